"""Another name for a thing: in every model that has it, and only if everything means what it meant."""

from __future__ import annotations

from pathlib import Path

import pytest

from aseme_dsl.compiler import analyse
from aseme_dsl.editor.rename import Refused, Renaming, edited, rename, renameable
from aseme_dsl.editor.workspace import Workspace
from aseme_dsl.source import Source

KOURETES = (Path(__file__).parents[2] / "examples/robocup/kouretes.aseme").read_text("utf-8")
PATH = "/nowhere/team.aseme"


def renamed(text: str, marked: str, name: str) -> str:
    """The text after a rename of what begins at the `^`, or why there is none."""
    workspace = Workspace()
    workspace.open(PATH, text)
    view = workspace.view(PATH)
    assert view is not None
    before, _, after = marked.partition("^")
    found = rename(workspace, view, text.index(before + after) + len(before), name)
    if isinstance(found, Refused):
        return f"refused: {found.reason}"
    return edited(text, found.edits.get(PATH, ()))


def test_a_use_case_and_its_activity_are_renamed_together_each_in_its_spelling() -> None:
    text = renamed(KOURETES, "^WalkTowardsBall . [PassBall]", "RunToBall")
    assert "includes run_to_ball, pass_ball, walk_towards_goal, kick_ball" in text
    assert "WalkTowardsBall" not in text and "walk_towards_ball" not in text
    assert text.count("RunToBall") == KOURETES.count("WalkTowardsBall")
    scenario = renamed(KOURETES, "by 3s  robot1 in ^ScanForBall", "Look")
    assert "activity" in scenario and "robot1 in Look" in scenario and "enter Look : else" in scenario
    before, after = (analyse(Source(PATH, item)).diagnostics for item in (KOURETES, text))
    assert [item.code for item in after] == [item.code for item in before]


def test_a_participant_is_renamed_with_its_role_in_the_use_cases() -> None:
    text = renamed(KOURETES, "participant ^center_for", "wing")
    assert "role center, wing : abstract" in text
    assert "usecase attack             by center, wing" in text
    assert "plays attack.wing with" in text and "control wing {" in text
    assert "clause PassBall@center before KickBall@wing" in text
    # a member of a message that is called the same is something else
    assert "team.state.Assignment.center_for == my" in text


def test_a_formula_is_renamed_in_its_role_only() -> None:
    text = renamed(KOURETES, "^decision   =", "choice")
    assert "choice~" in text and "control choice {" in text and "choice   = CheckForBall" in text


def test_agents_of_a_range_are_renamed_with_their_numbers() -> None:
    text = (
        "system S\nmessage N { int n }\ntopic t { state N }\nsrm a { liveness { a = (X | Y)~ }\n"
        "  control a { enter X : [bot2.t.state.N.n > 1] enter Y : else } }\nteam S { bot[1..3] : a }\n"
    )
    after = renamed(text, "^bot[1..3]", "robot")
    assert "[robot2.t.state.N.n > 1]" in after and "robot[1..3] : a" in after
    assert "cannot be renamed here" in renamed(text, "[^bot2", "robot9")


@pytest.mark.parametrize(
    ("marked", "name", "reason"),
    [
        ("^decision   =", "action", "there is a formula `action` already"),
        ("^decision   =", "TellMates", "something else would be meant"),
        ("let ^playing", "vision", "with this name, "),
        ("let ^playing", "and", "cannot be"),
        ("^initialize . activate", "initial-ize", "is no name"),
        ("vision.state.^Ball.visible && vision", "Sphere", "the standard library declares it"),
        ("enter ^NoGame", "NoGame", ""),
    ],
)
def test_a_rename_that_would_change_the_meaning_is_refused(marked: str, name: str, reason: str) -> None:
    found = renamed(KOURETES, marked, name)
    assert reason in found.partition("refused: ")[2] if reason else found == KOURETES


def test_what_has_no_name_or_a_fixed_one_cannot_be_renamed() -> None:
    workspace = Workspace()
    workspace.open(PATH, KOURETES)
    view = workspace.view(PATH)
    assert view is not None
    for marked in ("process = WalkTowardsBall", "state Gaze", "sag {"):
        assert isinstance(renameable(workspace, view, KOURETES.index(marked)), Refused)
    assert isinstance(rename(workspace, view, KOURETES.index("Gaze {"), "Glance"), Renaming)


def test_a_name_is_still_known_while_its_line_is_broken() -> None:
    workspace = Workspace()
    workspace.open(PATH, KOURETES)
    workspace.view(PATH)
    broken = KOURETES.replace("enter NoGame      : [!playing]", "enter NoGame      : [!playing &&& ]")
    workspace.open(PATH, broken)
    view = workspace.view(PATH)
    assert view is not None and view.earlier is not None
    found = view.occurrence_at(broken.index("playing &&&") + 2)
    assert found is not None and found.symbol.name == "playing"
    assert view.whole(found.span).start == broken.index("playing &&&")
