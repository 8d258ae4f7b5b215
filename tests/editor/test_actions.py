"""What is offered about a place, and what the text is when it is done."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from aseme_dsl.diagnostics import Edit
from aseme_dsl.editor.changes.actions import Action, ActionKind, actions, carry_out
from aseme_dsl.editor.changes.rewriting import Refused, after
from tests.conftest import Snapshot
from tests.editor.authoring import opened
from tests.support.compiling import codes

ROOT = Path(__file__).parents[2]
SOCCER = (ROOT / "tests/acceptance/kouretes.aseme").read_text("utf-8")
WAREHOUSE = (ROOT / "tests/acceptance/contract_net.aseme").read_text("utf-8")


def offered(marked: str) -> tuple[str, tuple[Action, ...]]:
    """The text without its marks, and the actions for what stands between `«` and `»`, or at `‸`."""
    if "‸" in marked:
        start = end = marked.index("‸")
        text = marked.replace("‸", "")
    else:
        start, end = marked.index("«"), marked.index("»") - 1
        text = marked.replace("«", "").replace("»", "")
    return text, actions(opened(text), start, end)


def titles(marked: str) -> list[str]:
    return [item.title for item in offered(marked)[1]]


def done(marked: str, title: str) -> str:
    """The text when the action whose title begins so has been chosen."""
    text, found = offered(marked)
    action = next(item for item in found if item.title.startswith(title))
    edits: tuple[Edit, ...] = action.edits
    if action.name:
        edits = carry_out(opened(text), action.name, action.start, action.end)
    return after(text, edits)


def refused(marked: str, title: str) -> str:
    """Why the action cannot be done."""
    with pytest.raises(Refused) as reason:
        done(marked, title)
    return str(reason.value)


def difference(before: str, changed: str) -> str:
    """The lines that are gone and those that are new."""
    import difflib

    lines = difflib.unified_diff(before.splitlines(), changed.splitlines(), n=0, lineterm="")
    return "".join(f"{line}\n" for line in lines if not line.startswith(("---", "+++", "@@")))


# ---- problems ------------------------------------------------------------------------------------


def test_a_misspelt_name_is_mended() -> None:
    marked = SOCCER.replace("vision.state.Ball.visible]", "vision.state.Ball.visibel‸]", 1)
    _, found = offered(marked)
    assert found[0].title == "Write `visible` instead of `visibel`"
    assert (found[0].kind, found[0].preferred) == (ActionKind.QUICK_FIX, True)
    assert done(marked, "Write `visible`") == SOCCER


def test_all_that_has_one_right_answer_is_mended_at_once() -> None:
    marked = SOCCER.replace("Ball.visible]", "Ball.visibel‸]", 1).replace(
        "PlayerState.FINISHED", "PlayerState.FINISHD"
    )
    assert done(marked, "Fix everything") == SOCCER


def test_a_warning_is_allowed_above_its_line() -> None:
    text = "system T\nsrm r {\n  liveness { r = A . B ‸| C }\n  activities {\n    A takes 1s\n  }\n}\n"
    assert "W300" in codes(text.replace("‸", ""))
    changed = done(text, "Allow W300")
    assert "  // asemec: allow(W300) \n  liveness" in changed
    assert "W300" not in codes(changed)
    assert "W010" in codes(changed)  # until the author says why


def test_an_error_cannot_be_allowed_but_explained() -> None:
    marked = SOCCER.replace("vision.state.Ball.visible]", "vision.state.Ball.visibel‸]", 1)
    assert not [title for title in titles(marked) if title.startswith("Allow")]
    (explained,) = [item for item in offered(marked)[1] if item.explains]
    assert (explained.title, explained.explains) == ("Explain E501: unknown field", "E501")


def test_what_a_note_says_is_missing_is_written() -> None:
    text = "system T\nsrm r {\n  liveness { ‸r = A | B }\n}\n"
    changed = done(text, "Write what is missing")
    assert "  control r {" in changed and "enter A : [?]" in changed
    assert {code for code in codes(changed) if code[0] == "E"} == {"E109"}


# ---- declarations --------------------------------------------------------------------------------

SMALL = """\
system T
enum Colour { RED GREEN }
message Note { int number }
topic board { state Note }
aip talk {
  participant one { var tries : int = 0  sends inform Note  process = Say . Rest }
  participant two { receives inform Note  process = Hear }
  control one { enter Say : / send inform Note to two }
  control two { enter Hear : inform Note from one }
}
srm r {
  plays talk.one
  plays talk.two
  liveness { r = (Look | one | two)~ }
  control r {
    enter Look : [CONDITION]
    enter one  : else
    enter two  : [board.state.Note.number == 2]
  }
}
"""


@pytest.mark.parametrize(
    ("condition", "title", "declared"),
    [
        ("tir‸ed", "Declare the variable `tired : bool`", "  var tired : bool"),
        ("cou‸nt > 3", "Declare the variable `count : int`", "  var count : int"),
        ("hu‸e == Colour.RED", "Declare the variable `hue : Colour`", "  var hue : Colour"),
        (
            "board.state.Note.we‸ight > 1.5",
            "Give `Note` the member `double weight`",
            "message Note { int number double weight }",
        ),
        (
            "has(board.sig‸nal.Note)",
            "Let `board` carry `signal Note`",
            "topic board { state Note signal Note }",
        ),
        ("has(wall‸.state.Note)", "Declare the topic `wall`", "topic wall {\n  state Note\n}"),
        (
            "has(board.state.Pap‸er)",
            "Declare the message `Paper`",
            "message Paper {\n}",
        ),
        (
            "board.state.Note.number == 1 && Colour.BL‸UE == Colour.RED",
            "Give `Colour` the constant `BLUE`",
            "enum Colour { RED GREEN BLUE }",
        ),
    ],
)
def test_what_an_unknown_name_needs(condition: str, title: str, declared: str) -> None:
    marked = SMALL.replace("CONDITION", condition)
    assert title in [item[: len(title)] for item in titles(marked)]
    changed = done(marked, title)
    assert declared in changed
    before = codes(marked.replace("‸", ""))
    assert (
        sum(code[0] == "E" for code in codes(changed)) < sum(code[0] == "E" for code in before)
        or "Paper" in title
    )


def test_a_message_that_is_not_listed() -> None:
    text = SMALL.replace("CONDITION", "true").replace("send inform Note to two", "send cfp N‸ote to two")
    changed = done(text, "Let `one` send `cfp Note`")
    assert "sends inform Note, cfp Note" in changed


# ---- control lines -------------------------------------------------------------------------------


def test_a_line_for_every_transition(snapshot: Snapshot) -> None:
    changed = done(SOCCER.replace("    decision   =", "    deci‸sion   ="), "Write a control line")
    snapshot(difference(SOCCER, changed), "action_lines_added.txt")
    assert codes(changed) == codes(SOCCER)
    again = changed.replace("control decision", "control deci‸sion")
    assert refused(again, "Write a control line") == "every transition of `decision` has a line"


def test_lines_in_a_block_of_their_own() -> None:
    text = "system T\nsrm r {\n  liveness { r‸ = A . (B | C)+ }\n  activities { A takes 1s }\n}\n"
    changed = done(text, "Write a control line")
    assert changed.endswith(
        "  control r {\n"
        "    enter  A        :\n"
        "    enter  (B | C)  :\n"
        "    leave  (B | C)+ :\n"
        "    start  (B | C)+ :\n"
        "    repeat (B | C)  : [?]\n"
        "    leave  (B | C)  : else\n"
        "    start  (B | C)  :\n"
        "    enter  B        : [?]\n"
        "    leave  B        :\n"
        "    enter  C        : else\n"
        "    leave  C        :\n"
        "  }\n}\n"
    )
    assert {code for code in codes(changed) if code[0] == "E"} == {"E109"}


@pytest.mark.parametrize("kept", ["enter A : [near]", "enter B : [far]", "enter C : else"])
def test_lines_where_some_are_missing_now(kept: str) -> None:
    """What is said of the rest of the model only when the lines are there has waited for them."""
    lines = ("enter A : [near]", "enter B : [far]", "enter C : else")
    text = (
        "system T\nimport soccer\nlet near = vision.state.Ball.distance < 3\n"
        "let far = vision.state.Ball.distance > 5\n"
        "srm r {\n  liveness { r = (A | B | C)~ }\n  activities { A takes 1s  B takes 1s  C takes 1s }\n"
        f"  control ‸r {{\n    {kept}\n  }}\n}}\nteam T {{ robot1 : r }}\n"
    )
    assert "E404" in codes(text.replace("‸", ""))
    changed = done(text, "Write a control line")
    assert {code for code in codes(changed) if code[0] == "E"} <= {"E109"}
    for line in lines:
        verb, term = line.split()[:2]
        assert len(re.findall(rf"^ +{verb} +{term} +:", changed, re.MULTILINE)) == 1


# ---- names for expressions -----------------------------------------------------------------------


def test_an_expression_gets_a_name() -> None:
    marked = SOCCER.replace(
        "[can_kick(vision.state.Ball) && facing_goal(world.state.Pose)]",
        "[«can_kick(vision.state.Ball)» && facing_goal(world.state.Pose)]",
    )
    changed = done(marked, "Give the selected expression a name")
    assert "[is_can_kick && facing_goal(world.state.Pose)]" in changed
    assert "  let is_can_kick = can_kick(vision.state.Ball)\n" in changed
    assert codes(changed) == codes(SOCCER)


def test_the_name_of_a_variable_stays_with_its_participant() -> None:
    marked = WAREHOUSE.replace("[bids > 0]", "[«bids > 0»]")
    changed = done(marked, "Give the selected expression a name")
    participant = changed[changed.index("participant manager") : changed.index("participant contractor")]
    assert "let bids_condition = bids > 0" in participant
    assert codes(changed) == codes(WAREHOUSE)


def test_half_an_expression_gets_no_name() -> None:
    marked = SOCCER.replace("[can_kick(vision.state.Ball) &&", "[can_kick(«vision.state».Ball) &&", 1)
    assert refused(marked, "Give the selected").startswith("select a whole expression")
