"""What is declared: every case is a document, and its snapshot says what is wrong with it."""

from __future__ import annotations

from pathlib import Path

import pytest

from aseme_dsl.amola.messages import Channel, ChannelKind, Kind, Type
from aseme_dsl.compiler.names.resolve import Symbols, resolve
from aseme_dsl.compiler.read.load import load
from aseme_dsl.diagnostics import render_text
from aseme_dsl.source import Source
from tests.conftest import Snapshot
from tests.support.compiling import codes, printed

CASES = sorted((Path(__file__).parent / "resolve").glob("*.aseme"))


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.stem)
def test_diagnostics(case: Path, snapshot: Snapshot) -> None:
    snapshot(printed(case.read_text("utf-8")), f"resolve/{case.stem}.txt")


def symbols_of(text: str) -> Symbols:
    loaded = load(Source("test.aseme", text))
    symbols, found = resolve(loaded)
    assert not loaded.diagnostics + found, render_text(loaded.diagnostics + found)
    return symbols


def test_field_numbers_are_given_or_the_smallest_that_are_free() -> None:
    symbols = symbols_of("message M { int a  int b = 1  int c  int d = 7  int e }")
    message = symbols.message("M")
    assert message is not None
    assert [(field.name, field.number) for field in message.fields] == [
        ("a", 2),
        ("b", 1),
        ("c", 3),
        ("d", 7),
        ("e", 4),
    ]


def test_adding_a_field_at_the_end_changes_no_number() -> None:
    before = symbols_of("message M { int a  double b }").message("M")
    after = symbols_of("message M { int a  double b  bool c }").message("M")
    assert before is not None and after is not None
    assert [field.number for field in after.fields][:2] == [field.number for field in before.fields]


def test_enum_numbers_go_on_from_the_last_one() -> None:
    enum = symbols_of("enum E { A B = 5 C D = 2 F }").enum("E")
    assert enum is not None
    assert enum.constants == (("A", 0), ("B", 5), ("C", 6), ("D", 2), ("F", 3))
    assert enum.number("C") == 6
    assert enum.number("X") is None


def test_a_topic_says_what_it_carries_and_for_whom() -> None:
    symbols = symbols_of(
        """
        message Ball { bool visible }
        topic world { }
        topic vision under world radio 10 { state Ball every 33ms persist  signal Ball from r queued }
        srm r { liveness { r = A } }
        """
    )
    topic = symbols.topic("vision")
    assert topic is not None
    assert (topic.under, topic.radio) == ("world", 10)
    state, signal = topic.channels
    assert state.channel == Channel("vision", ChannelKind.STATE, "Ball")
    assert (state.every, state.persist, state.queued, state.sources) == (33_000_000, True, False, ())
    assert (signal.every, signal.persist, signal.queued, signal.sources) == (None, False, True, ("r",))
    assert symbols.channels_of("Ball") == (state.channel, signal.channel)


def test_topics_are_reached_above_and_below() -> None:
    symbols = symbols_of("topic a {} topic b under a {} topic c under b {} topic d under a {}")

    def reached(reach: str) -> list[str]:
        return [topic.name for topic in symbols.topics_reached("b", reach)]

    assert reached("on") == ["b"]
    assert reached("above") == ["a", "b"]
    assert reached("below") == ["b", "c"]
    assert reached("around") == ["a", "b", "c"]


def test_functions_of_one_name_differ_in_their_parameters() -> None:
    symbols = symbols_of(
        """
        message Ball { double distance }
        function far(Ball b) : bool = "m:f"
        function far(double d) : bool = "m.n:f.g"
        """
    )
    first, second = symbols.overloads("far")
    assert first.parameters == (("b", Type(Kind.MESSAGE, "Ball")),)
    assert second.target == "m.n:f.g"
    assert {function.target for function in symbols.overloads("abs")} == {"builtin:abs"}


def test_ranges_of_a_team_are_agents() -> None:
    symbols = symbols_of("srm r { liveness { r = A } } team T { boss, carrier[2..4] : r  x[7..7] : r }")
    assert [agent.name for team in symbols.teams for agent in team.agents] == [
        "boss",
        "carrier2",
        "carrier3",
        "carrier4",
        "x7",
    ]
    assert symbols.agents == {"boss", "carrier2", "carrier3", "carrier4", "x7"}


def test_what_a_damaged_declaration_would_have_declared_is_not_reported_again() -> None:
    text = """
    system S
    message Ball { bool visible ??? }
    topic vision { state Ball, Pose }
    srm r { liveness { r = A | B } control r {
      enter A : [vision.state.Ball.visible && vision.state.Pose.x > 0]
      enter B : else
    } }
    """
    found = printed(text)
    assert "Pose" in found
    assert "no message `Ball`" not in found
    assert codes(text).count("E502") == 1


def test_a_missing_import_is_one_mistake(tmp_path: Path) -> None:
    text = """
    system S
    import socer
    topic mine { state Ball }
    srm r { var s : PlayerState  liveness { r = A | B } control r {
      enter A : [can_kick(vision.state.Ball) && s == PlayerState.SET]
      enter B : else
    } }
    """
    assert codes(text) == ["E004"]
