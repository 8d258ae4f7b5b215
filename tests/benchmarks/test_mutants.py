"""Mutants of a model: what is changed, and how scenarios that notice it are told from those that do not."""

from __future__ import annotations

from pathlib import Path

import pytest

from benchmarks.mutants import (
    CAUGHT,
    NOT_COMPILED,
    OTHERWISE,
    SAME,
    SURVIVED,
    Candidate,
    Model,
    compare,
    judge,
)
from tests.support.model_mutants import ModelMutant, model_mutants

BELL = """\
system Bell

message Button { bool pressed }
topic door { state Button }

srm bell {
  liveness { bell = (Wait . Ring)~ }
  activities { Ring takes 1s simulated within 5s }
  control bell {
    enter Ring : when [door.state.Button.pressed] / start_timer(pause, 3s)
    leave Ring : [expired(pause) && !door.state.Button.pressed]
  }
}

team House { front : bell }

scenario "it rings" {
  at 1s front in Wait
  at 2s front receives door.state.Button { pressed = true }
  at 3s front receives door.state.Button { pressed = false }
  at 2s front in Ring
}
"""


def found(text: str = BELL) -> list[tuple[str, str, str]]:
    return [(item.kind, item.before, item.after) for item in model_mutants(text)]


def test_one_statement_is_changed_and_nothing_in_a_scenario() -> None:
    mutants = model_mutants(BELL)
    assert mutants == model_mutants(BELL)
    scenario = BELL[BELL.index("scenario") :]
    assert all(item.text.endswith(scenario) for item in mutants)
    assert all(
        item.text.splitlines()[: item.line - 1] == BELL.splitlines()[: item.line - 1] for item in mutants
    )


@pytest.mark.parametrize(
    ("kind", "before", "after"),
    [
        ("order of states", "liveness { bell = (Wait . Ring)~ }", "liveness { bell = (Ring . Wait)~ }"),
        ("operator changed", "liveness { bell = (Wait . Ring)~ }", "liveness { bell = (Wait . Ring) }"),
        (
            "timer longer",
            "activities { Ring takes 1s simulated within 5s }",
            "activities { Ring takes 1s simulated within 15s }",
        ),
        (
            "condition negated",
            "leave Ring : [expired(pause) && !door.state.Button.pressed]",
            "leave Ring : [!(expired(pause) && !door.state.Button.pressed)]",
        ),
        (
            "comparison turned",
            "leave Ring : [expired(pause) && !door.state.Button.pressed]",
            "leave Ring : [expired(pause) || !door.state.Button.pressed]",
        ),
        (
            "timer dropped",
            "enter Ring : when [door.state.Button.pressed] / start_timer(pause, 3s)",
            "enter Ring : when [door.state.Button.pressed]",
        ),
        ("line dropped", "leave Ring : [expired(pause) && !door.state.Button.pressed]", ""),
    ],
)
def test_what_a_mutant_is(kind: str, before: str, after: str) -> None:
    assert (kind, before, after) in found()


TALK = """\
aip talk {
  control boss {
    enter Ask    : / send request Job { n = 1 } to hand except best; tries = tries + 1
    enter Rest   : inform Job from hand [tries < 3]
    enter Scold  : after(10s)
    enter Praise : else
    resume Work  :
  }
}
"""


@pytest.mark.parametrize(
    ("kind", "after"),
    [
        ("message not sent", "enter Ask : / tries = tries + 1"),
        ("another receiver", "enter Ask : / send request Job { n = 1 } to hand; tries = tries + 1"),
        ("action dropped", "enter Ask : / send request Job { n = 1 } to hand except best"),
        ("value changed", "enter Ask : / send request Job { n = 1 } to hand except best; tries = tries - 1"),
        ("number changed", "enter Rest : inform Job from hand [tries < 6]"),
        ("condition dropped", "enter Rest : inform Job from hand"),
        ("timer dropped", ""),
        ("timer longer", "enter Scold : after(30s)"),
        ("resume forgotten", "enter Work :"),
        ("order of lines", "enter Scold : after(10s) ⏎ enter Rest : inform Job from hand [tries < 3]"),
        ("target changed", "enter Scold : inform Job from hand [tries < 3] ⏎ enter Rest : after(10s)"),
    ],
)
def test_what_is_changed_in_a_talk(kind: str, after: str) -> None:
    assert (kind, after) in [(kind, after) for kind, _, after in found(TALK)]


def test_else_can_be_taken_first() -> None:
    (first,) = [item for item in model_mutants(TALK) if item.kind == "else first"]
    assert first.text.index("enter Praise :") < first.text.index("enter Ask")


@pytest.fixture
def model(tmp_path: Path) -> Model:
    root = tmp_path / "bell.aseme"
    root.write_text(BELL)
    return Model("bell", root, (root,))


@pytest.mark.parametrize(
    ("before", "after", "first", "then"),
    [
        ("when [door.state.Button.pressed]", "when [!(door.state.Button.pressed)]", CAUGHT, CAUGHT),
        ("(Wait . Ring)~", "(Wait . Rong)~", NOT_COMPILED, NOT_COMPILED),
        ("start_timer(pause, 3s)", "start_timer(pause, 9s)", SURVIVED, SAME),  # the scenario ends before
        ("takes 1s", "takes 800ms", SURVIVED, OTHERWISE),
        ("bell = (Wait", "bell = (Look . Wait", SURVIVED, OTHERWISE),
    ],
)
def test_a_mutant_is_caught_or_behaves_otherwise_or_not(
    model: Model, tmp_path: Path, before: str, after: str, first: str, then: str
) -> None:
    mutant = ModelMutant("by hand", 1, before, after, BELL.replace(before, after))
    candidate = Candidate(model, model.root, mutant)
    result = judge(candidate)
    assert result.result == first
    if result.result == SURVIVED:
        result = compare(candidate, result, tmp_path, 2)
    assert result.result == then
