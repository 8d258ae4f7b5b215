"""A message that does not fit its channel is told with the place in the code, whatever publishes it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from aseme_dsl.runtime import activities_in
from aseme_dsl.runtime.activity.activities import ActivityFinder
from aseme_dsl.runtime.team.team import Team
from tests.faults.test_activities import folder
from tests.runtime.playing import SECOND, Played, make, play

TEXT = """
system S
message Ball { double x }
message Pose { double x }
topic vision { state Ball  state Pose }
srm R {
  liveness { R = Say }
  activities { Say AS writes vision.state.Ball }
}
"""
MODULE = TEXT.replace(
    "activities { Say AS writes", "activities { Say takes 60min }  modules { See every 500ms AS writes"
)
HEADS = {
    "thread": "def execute(self, context):\n        ",
    "process": "kind = 'process'\n    def execute(self, context):\n        ",
    "async": "async def execute(self, context):\n        ",
    "step": "def execute(self, context):\n        yield 0.01\n        ",
}


def written(
    tmp_path: Path, text: str, name: str, kind: str, above: str, message: str
) -> tuple[str, ActivityFinder]:
    """The text and its activities, of which one publishes `message`."""
    code = f"{above}class {name}:\n    {HEADS[kind]}context.publish('vision.state.Ball', {message})\n"
    find = activities_in(folder(tmp_path, **{name.lower(): code}))
    return text.replace("AS", "" if kind == "thread" else f"as {kind}"), find


def real(tmp_path: Path) -> dict[str, Any]:
    return {"clock": "real", "path": [tmp_path], "until": 60 * SECOND}


def run(tmp_path: Path, name: str, kind: str, above: str, message: str) -> Played:
    return play(*written(tmp_path, TEXT, name, kind, above, message), **real(tmp_path))


def line_of(tmp_path: Path, name: str) -> int:
    lines = (tmp_path / f"{name}.py").read_text().splitlines()
    return next(number for number, line in enumerate(lines, 1) if "publish" in line)


@pytest.mark.parametrize("kind", HEADS)
def test_an_activity_that_publishes_something_else_fails_with_its_place(kind: str, tmp_path: Path) -> None:
    played = run(tmp_path, "Say", kind, "class Pose:\n    pass\n\n", "Pose()")
    (crash,) = played.of("activity", what="crash")
    assert crash["reason"] == "TypeError: vision.state.Ball carries Ball, not Pose"
    assert crash["traceback"][-1] == {
        "file": "say.py",
        "line": line_of(tmp_path, "say"),
        "function": "execute",
    }


@pytest.mark.parametrize("kind", HEADS)
def test_a_module_that_does_so_goes_on_and_is_told_with_its_place(kind: str, tmp_path: Path) -> None:
    def told(team: Team) -> str | None:
        crashes = [r for r in records if r["kind"] == "module" and r["what"] == "crash"]
        return "told twice" if len(crashes) > 1 else None

    team, records = make(*written(tmp_path, MODULE, "See", kind, "", "3"), **real(tmp_path), stop=told)
    result = team.run()
    assert result.reason == "told twice" and not result.failed
    crash = next(r for r in records if r["kind"] == "module" and r["what"] == "crash")
    assert crash["reason"] == "TypeError: vision.state.Ball carries Ball, not int"
    assert crash["traceback"][-1]["line"] == line_of(tmp_path, "see")


def test_another_class_of_the_same_name_is_none_of_the_system(tmp_path: Path) -> None:
    played = run(tmp_path, "Say", "thread", "class Ball:\n    y = 1\n\n", "Ball()")
    (crash,) = played.of("activity", what="crash")
    assert crash["reason"].startswith(
        "TypeError: vision.state.Ball carries S's Ball, not the one of aseme_act"
    )
    assert crash["traceback"][-1]["line"] == line_of(tmp_path, "say")


@pytest.mark.parametrize("what", ["'s1'", "3", "None", "dict"])
def test_what_is_prepared_is_a_message(what: str, tmp_path: Path) -> None:
    code = f"class Say:\n    def execute(self, context):\n        context.prepare({what})\n"
    played = play(TEXT.replace("AS", ""), activities_in(folder(tmp_path, say=code)), path=[tmp_path])
    (crash,) = played.of("activity", what="crash")
    assert crash["reason"].startswith("TypeError: what is prepared is a message, not ")
    assert crash["traceback"][-1]["file"] == "say.py"
