"""N722: the only outgoing transition of a state has a guard over a message that nothing publishes."""

from __future__ import annotations

import pytest

from tests.support.compiling import analysis, codes


def _role(control: str, *, formula: str = "A . B", said: str = "", topic: str = "state Ball") -> str:
    return f"""system S message Ball {{ bool visible  double far }} topic vision {{ {topic} }}
    srm r {{
      liveness {{ r = {formula} }}
      activities {{ A takes 1s {said}  B takes 1s }}
      control r {{ {control} }}
    }}"""


def awaited(text: str) -> list[str]:
    return [item.message for item in analysis(text).diagnostics if item.code == "N722"]


def test_the_only_way_out_waits_for_what_nobody_publishes() -> None:
    (problem,) = analysis(_role("enter B : [vision.state.Ball.visible]")).diagnostics
    assert problem.code == "N722"
    expected = (
        "nothing says who publishes `vision.state.Ball`; the only outgoing transition of `A` waits for it"
    )
    assert problem.message == expected
    assert problem.related[0].span.text == "Ball"
    assert problem.hint is not None and "`writes vision.state.Ball`" in problem.hint


@pytest.mark.parametrize(
    "control",
    [
        "enter B : when [vision.state.Ball.far < 3]",
        "enter B : [has(vision.state.Ball)]",
        "enter B : [vision.state.Ball.visible && vision.state.Ball.far < 1]",
        "enter B : [!vision.state.Ball.visible]",
        "enter A : [vision.state.Ball.visible]",
        "leave B : [vision.state.Ball.visible]",
    ],
)
def test_whatever_the_guard_asks(control: str) -> None:
    assert len(awaited(_role(control))) == 1


@pytest.mark.parametrize(
    ("control", "formula", "said", "topic"),
    [
        ("enter B : [vision.state.Ball.visible]", "A . B", "writes vision.state.Ball", "state Ball"),
        ("enter B : [vision.state.Ball.visible]", "A . B", "", "state Ball from A"),
        ("enter B : [vision.state.Ball.visible]  enter B : after(9s)", "A . B", "", "state Ball"),
        ("enter B : [!has(vision.state.Ball)]", "A . B", "", "state Ball"),
        ("enter B : [vision.state.Ball.visible || 1 < 2]", "A . B", "", "state Ball"),
        ("enter A : [vision.state.Ball.visible]  enter B : else", "A | B", "", "state Ball"),
        (
            "enter A : / vision.state.Ball.far = 2; write_messages.vision.state.Ball  "
            "enter B : [vision.state.Ball.far > 1]",
            "A . B",
            "",
            "state Ball",
        ),
        ("enter B : [vision.state.Ball.visible]  enter C : after(9s)", "(A . B) [> C", "", "state Ball"),
    ],
)
def test_what_someone_publishes_or_another_way_leads_out_of_is_not_reported(
    control: str, formula: str, said: str, topic: str
) -> None:
    assert awaited(_role(control, formula=formula, said=said, topic=topic)) == []


def test_in_a_statechart_too() -> None:
    text = """system S message Ball { bool visible } topic vision { state Ball }
    statechart r { state 0 OR state 0.1 START state 0.2 BASIC A state 0.3 END
      0.1 -> 0.2 :  0.2 -> 0.3 : [vision.state.Ball.visible] }"""
    assert len(awaited(text)) == 1
    assert awaited(text.replace("0.1 -> 0.2 :", "0.1 -> 0.2 :  0.2 -> 0.2 : after(1s)")) == []


def test_another_files_topic_may_be_written_by_those_who_share_it() -> None:
    shared = "message Ball { bool visible } topic vision { state Ball }"
    text = """system S import "shared.aseme"
    srm r { liveness { r = A . B } activities { A takes 1s B takes 1s }
      control r { enter B : [vision.state.Ball.visible] } }"""
    found = analysis(text, sources={"shared.aseme": shared}).diagnostics
    assert [item.code for item in found] == []


def test_it_is_a_note() -> None:
    assert codes(_role("enter B : [vision.state.Ball.visible]")) == []


def test_the_hint_says_what_to_write_for_an_input_from_outside_and_that_works() -> None:
    text = _role("enter B : [vision.state.Ball.visible]", said="simulated").replace("B takes 1s", "B waits")
    (problem,) = analysis(text).diagnostics
    assert problem.hint == (
        "for what comes from outside, write `state Ball from outside`; "
        "an activity that publishes it says `writes vision.state.Ball`"
    )
    declared = text.replace("state Ball", "state Ball from outside")
    assert analysis(declared).diagnostics == ()
    role = "suc { role outside : external } srm r"
    assert analysis(declared.replace("srm r", role)).diagnostics == ()


def test_the_hint_names_only_activities_that_can_publish() -> None:
    text = _role("enter B : [vision.state.Ball.visible]", formula="A . B . C").replace(
        "B takes 1s", "B waits  C simulated takes 1s"
    )
    (problem,) = (item for item in analysis(text).diagnostics if item.code == "N722")
    assert problem.hint is not None
    assert problem.hint.endswith("; an activity that publishes it (`A`) says `writes vision.state.Ball`")


def test_the_hint_for_what_is_read_says_the_same() -> None:
    text = """system S message Ball { bool visible } topic vision { state Ball } topic memory { state Ball }
    srm r {
      liveness { r = (Look~ || Note~) || (Wait . Walk) }
      activities { Look takes 1s  Note takes 1s writes memory.state.Ball  Wait waits  Walk waits }
      control r { enter Walk : when [vision.state.Ball.visible] }
    }"""
    (problem,) = (item for item in analysis(text).diagnostics if item.code == "N722")
    assert (
        problem.hint is not None
        and "(`Look`)" in problem.hint
        and "write `state Ball from outside`" in problem.hint
    )
