"""`waits`: what is read, kept in the model, drawn and reported."""

import pytest
from jsonschema import Draft202012Validator

from aseme_dsl.amola.as_json import schema, srm_json
from aseme_dsl.diagrams.models.srm import sheet
from tests.support.compiling import analysis, codes, system

SYSTEM = """
system S
srm robot {{
  liveness {{ robot = Idle . Walk }}
  activities {{ {activities} }}
  control robot {{ enter Walk : {way} }}
}}
"""


def written(activities: str, way: str = "go") -> str:
    return SYSTEM.format(activities=activities, way=way)


def test_its_states_wait() -> None:
    made = system(written("Idle waits  Walk takes 1s"))
    assert [(item.name, item.waits, item.has_code) for item in made.activities] == [
        ("Idle", True, False),
        ("Walk", False, True),
    ]
    (chart,) = made.iacs
    assert [node.name for node in chart.states if node.waits] == ["Idle"]


def test_it_stands_in_a_statechart_too() -> None:
    text = """system S
statechart R {
  state 0 OR R
  state 0.1 START
  state 0.2 BASIC Idle
  state 0.3 END
  0.1 -> 0.2 :
  0.2 -> 0.3 : go
}
srm other { liveness { other = Idle } activities { Idle waits } }
"""
    chart = system(text).iac("R")
    assert chart is not None
    assert [node.name for node in chart.states if node.waits] == ["Idle"]


def test_json_and_drawing_have_it() -> None:
    made = system(written("Idle waits  Walk takes 1s"))
    found = srm_json(made.srms[0], made.activities, made.name)
    Draft202012Validator(schema("srm")).validate(found)
    assert [item.get("waits") for item in found["activities"]] == [True, None]
    assert "waits" in str(sheet(made.srms[0], made.activities, "robot"))


@pytest.mark.parametrize("way", ["", "[true]", "/ act()"])
def test_what_waits_for_its_completion_is_reported(way: str) -> None:
    text = 'function act() : bool = "m:f"\n' + written("Idle waits  Walk takes 1s", way)
    (found,) = (item for item in analysis(text).diagnostics if item.code == "W402")
    assert found.message == "`Idle` never completes, so that `Walk` is never entered"


@pytest.mark.parametrize("way", ["go", "after(1s)", "when [1 < 2]", "go or after(5s)"])
def test_what_leaves_it_otherwise_is_not_reported(way: str) -> None:
    assert "W402" not in codes(written("Idle waits  Walk takes 1s", way))


def test_a_transition_without_a_line_waits_in_vain_too() -> None:
    text = "system S srm r { liveness { r = Idle . Walk } activities { Idle waits  Walk takes 1s } }"
    assert codes(text) == ["W402"]


def test_before_a_choice_the_hint_speaks_of_its_lines() -> None:
    text = """system S srm r {
      liveness { r = Idle . [Walk] } activities { Idle waits  Walk takes 1s }
      control r { enter Walk : yes  skip Walk : no }
    }"""
    (found,) = (item for item in analysis(text).diagnostics if item.code == "W402")
    assert found.hint is not None and "let it have `takes` instead of `waits`" in found.hint


def test_an_endless_wait_at_the_end_is_meant() -> None:
    text = "system S srm r { liveness { r = Walk . Idle } activities { Idle waits  Walk takes 1s } }"
    assert codes(text) == []


def test_done_of_it_is_never_true() -> None:
    assert codes(written("Idle waits  Walk takes 1s", "when [done(Idle)]")) == ["W435"]


@pytest.mark.parametrize(
    "clause",
    ["takes 1s", "within 1s", "every 1s", "simulated", "ends up, down", "as step"],
)
def test_another_clause_beside_it_is_refused(clause: str) -> None:
    text = written(f"Idle {clause} waits  Walk takes 1s")
    (found,) = (item for item in analysis(text).diagnostics if item.severity.value == "error")
    word = clause.split()[0]
    assert found.code == "E227"
    assert found.message == f"`Idle` waits: it never ends by itself, so that `{word}` has no effect"
    assert found.span is not None and found.span.text == "waits"


def test_what_one_role_says_holds_for_all() -> None:
    other = "srm other { liveness { other = Idle } activities { Idle } }"
    assert [item.waits for item in system(written("Idle waits  Walk takes 1s") + other).activities] == [
        True,
        False,
    ]


def test_two_roles_may_not_disagree() -> None:
    other = "srm other { liveness { other = Idle } activities { Idle takes 1s } }"
    assert codes(written("Idle waits  Walk takes 1s") + other) == ["E227"]


def test_a_module_does_not_wait() -> None:
    text = "system S srm r { liveness { r = A } modules { Eyes every 1s waits } }"
    assert codes(text) == ["E227"]


def test_it_is_said_once() -> None:
    assert codes(written("Idle waits waits  Walk takes 1s")) == ["E114"]


def test_an_activity_may_still_be_called_so() -> None:
    text = "system S srm r { liveness { r = waits . Walk } activities { waits takes 1s  Walk takes 1s } }"
    assert codes(text) == []
    assert [item.waits for item in system(text).activities] == [False, False]
