"""Another name for a thing: in every model that has it, and only if everything means what it meant."""

from __future__ import annotations

import asyncio
import re
import sys
from pathlib import Path

import pytest
from lsprotocol import types as lsp
from pygls.lsp.client import LanguageClient

from aseme_dsl.compiler import analyse
from aseme_dsl.editor.answers.hover import hover
from aseme_dsl.editor.answers.navigation import PythonFolders, definition, references
from aseme_dsl.editor.changes.rename import Refused, Renaming, edited, rename, renameable
from aseme_dsl.editor.files.workspace import Workspace
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


@pytest.mark.parametrize(
    "marked",
    [
        "^LEFT RIGHT",
        "message ^Ball",
        "bool ^seen",
        "participant ^guide",
        "process = ^Go",
        "ends ^found",
        ": ^Whistle",
        "^one : r",
    ],
)
def test_what_scenarios_name_is_renamed_there(marked: str) -> None:
    text = """system T
enum Side { LEFT RIGHT }
message Ball { bool seen  Side side }
topic eyes { state Ball }
aip walk { participant guide { process = Go } }
srm r {
  plays walk.guide
  liveness { r = (Look . guide . Turn)~ }
  activities { Look takes 1s ends found, lost }
  control r { enter Turn : Whistle }
}
team T { one : r }
scenario "s" {
  one : r
  activity Look ends lost, found
  at 1s one receives eyes.state.Ball { seen = true  side = Side.LEFT }
  at 2s one raises Whistle
  by 3s one in Go@guide and one has [eyes.state.Ball.seen]
  no received Ball before 1s
}
"""
    before = [item.code for item in analyse(Source(PATH, text)).diagnostics]
    assert not any(code[0] == "E" for code in before)
    name = marked.partition("^")[2].partition(" ")[0]
    changed = renamed(text, marked, "other")
    assert re.search(rf"\b{name}\b", changed) is None
    assert [item.code for item in analyse(Source(PATH, changed)).diagnostics] == before


def test_a_member_is_renamed_in_the_messages_of_variables() -> None:
    text = """message M { int ^x }
topic t { state M }
srm r {
  var m : M  var q : list of M
  liveness { r = A . B }
  control r {
    enter B : [m.x == q[0].x && contains(q.x, find(q.x, 3))]
            / m = t.state.M; append(q, m); write_messages.t.state.M { x = q[1].x, ..m }
  }
}
"""
    after = renamed(text.replace("^", ""), "message M { int ^x", "y")
    assert "[m.y == q[0].y && contains(q.y, find(q.y, 3))]" in after and "{ y = q[1].y, ..m }" in after


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
        ("^initialize . activate", "initial-ize", "is not a name"),
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


HAND = """\
system Hand
srm hand {
  liveness { hand = (Grasp . (Lift | Rest))~ }
  let safe = outcome(Grasp) == held
  activities { Grasp takes 1s ends held, slipped }
  control hand {
    enter Lift : [safe && slipped == outcome(Grasp)]
    enter Rest : else
  }
}
team T { one : hand }
"""

GRASP = '''\
"""Grasp: held or slipped."""


class Grasp:
    def execute(self, context):
        if context.grips("held"):
            return "held" if context.tight else 'slipped'
        return Grasp.failed
'''

TOUCH = "from .grasp import Grasp\n\n\nclass Touch(Grasp):\n    grasp = Grasp\n"


@pytest.fixture
def hand(tmp_path: Path) -> Path:
    (tmp_path / "pyproject.toml").write_text('[tool.asemec]\nactivities = "code"\n', "utf-8")
    (tmp_path / "hand.aseme").write_text(HAND, "utf-8")
    (tmp_path / "code").mkdir()
    (tmp_path / "code/grasp.py").write_text(GRASP, "utf-8")
    (tmp_path / "code/touch.py").write_text(TOUCH, "utf-8")
    return tmp_path


def renamed_there(folder: Path, marked: str, name: str) -> Renaming | Refused:
    workspace = Workspace()
    path = str(folder / "hand.aseme")
    workspace.open(path, HAND)
    view = workspace.view(path)
    assert view is not None
    offset = HAND.index(marked.replace("^", "")) + marked.index("^")
    return rename(workspace, view, offset, name, folder / "code")


def test_an_outcome_is_renamed_where_it_is_said_compared_and_returned(hand: Path) -> None:
    for marked in ("ends ^held", "== ^held"):
        found = renamed_there(hand, marked, "got_it")
        assert isinstance(found, Renaming)
        assert edited(HAND, found.edits[str(hand / "hand.aseme")]) == HAND.replace("held", "got_it")
        code = edited(GRASP, found.code.edits[str(hand / "code/grasp.py")])
        assert code == GRASP.replace('return "held"', 'return "got_it"') and found.code.moves == ()
    found = renamed_there(hand, "[safe && ^slipped", "lost")
    assert isinstance(found, Renaming)
    assert edited(HAND, found.edits[str(hand / "hand.aseme")]) == HAND.replace("slipped", "lost")
    assert "else 'lost'" in edited(GRASP, found.code.edits[str(hand / "code/grasp.py")])


def test_an_outcome_is_found_from_each_of_its_places(hand: Path) -> None:
    workspace = Workspace()
    path = str(hand / "hand.aseme")
    workspace.open(path, HAND)
    view = workspace.view(path)
    assert view is not None
    folders = PythonFolders(hand / "code")
    said = HAND.index("held, slipped")
    (place,) = definition(view, HAND.index("held\n"))
    assert (place.path, place.span.start) == (path, said)
    places = [(Path(item.path).name, item.span.text) for item in references(view, said, folders)]
    assert places == [("hand.aseme", "held"), ("hand.aseme", "held"), ("grasp.py", "held")]
    shown = hover(view, said)
    assert shown is not None and "an outcome of `Grasp`" in shown.text


def test_the_code_of_an_activity_is_renamed_with_it(hand: Path) -> None:
    found = renamed_there(hand, "liveness { hand = (^Grasp", "TakeHold")
    assert isinstance(found, Renaming)
    assert edited(HAND, found.edits[str(hand / "hand.aseme")]) == HAND.replace("Grasp", "TakeHold")
    code = edited(GRASP, found.code.edits[str(hand / "code/grasp.py")])
    assert "class TakeHold:" in code and "return TakeHold.failed" in code and '"""Grasp:' in code
    assert edited(TOUCH, found.code.edits[str(hand / "code/touch.py")]) == (
        "from .take_hold import TakeHold\n\n\nclass Touch(TakeHold):\n    grasp = TakeHold\n"
    )
    assert found.code.moves == ((hand / "code/grasp.py", hand / "code/take_hold.py"),)


def test_code_that_is_in_the_way_is_not_overwritten(hand: Path) -> None:
    (hand / "code/take_hold.py").write_text("class TakeHold: ...\n", "utf-8")
    found = renamed_there(hand, "liveness { hand = (^Grasp", "TakeHold")
    assert isinstance(found, Refused) and "take_hold.py already" in found.reason
    (hand / "code/grasp.py").write_text("class Grasp(\n", "utf-8")
    found = renamed_there(hand, "liveness { hand = (^Grasp", "Hold")
    assert isinstance(found, Refused) and "fix it first" in found.reason


def renamed_by_an_editor(
    hand: Path, able: lsp.WorkspaceEditClientCapabilities | None
) -> tuple[lsp.WorkspaceEdit | None, list[str]]:
    """What the server answers, and says, to an editor that announces this of its edits."""

    async def asked() -> tuple[lsp.WorkspaceEdit | None, list[str]]:
        client = LanguageClient("test", "1")
        said: list[str] = []

        @client.feature(lsp.WINDOW_SHOW_MESSAGE)
        def show(params: lsp.ShowMessageParams) -> None:
            said.append(params.message)

        await client.start_io(sys.executable, "-m", "aseme_dsl", "lsp")
        abilities = lsp.ClientCapabilities(workspace=lsp.WorkspaceClientCapabilities(workspace_edit=able))
        await client.initialize_async(lsp.InitializeParams(abilities, root_uri=hand.as_uri()))
        client.initialized(lsp.InitializedParams())
        uri = (hand / "hand.aseme").as_uri()
        client.text_document_did_open(
            lsp.DidOpenTextDocumentParams(lsp.TextDocumentItem(uri, "aseme", 1, HAND))
        )
        place = lsp.Position(2, HAND.split("\n")[2].index("Grasp"))
        found = await client.text_document_rename_async(
            lsp.RenameParams(lsp.TextDocumentIdentifier(uri), place, "TakeHold")
        )
        await client.shutdown_async(None)
        client.exit(None)
        await client.stop()
        return found, said

    return asyncio.run(asked())


def test_an_editor_that_renames_files_without_knowing_versions(hand: Path) -> None:
    able = lsp.WorkspaceEditClientCapabilities(resource_operations=[lsp.ResourceOperationKind.Rename])
    found, said = renamed_by_an_editor(hand, able)
    assert found is not None and found.changes is None and found.document_changes is not None
    *edits, moved = found.document_changes
    documents = [item.text_document for item in edits if isinstance(item, lsp.TextDocumentEdit)]
    assert {Path(item.uri).name for item in documents} == {"hand.aseme", "grasp.py", "touch.py"}
    assert {item.version for item in documents} == {None}
    assert isinstance(moved, lsp.RenameFile) and moved.new_uri.endswith("/take_hold.py")
    assert said == []


def test_an_editor_that_cannot_rename_files_is_told_what_is_left(hand: Path) -> None:
    found, said = renamed_by_an_editor(hand, None)
    assert found is not None and found.changes is not None and found.document_changes is None
    assert {Path(uri).name for uri in found.changes} == {"hand.aseme", "grasp.py", "touch.py"}
    assert len(said) == 1 and "grasp.py to take_hold.py" in said[0]


def test_a_participant_is_renamed_where_its_answers_are_counted() -> None:
    text = renamed(COUNTED, "participant ^bidder", "rival")
    assert "when [all_answered(rival)]" in text and "bidder" not in text


COUNTED = """
system Market
message Task { string id }
aip auction {
  participant seller {
    sends    cfp Task
    receives refuse Task
    process  = Collect+
  }
  participant bidder [1..*] {
    sends    refuse Task
    receives cfp Task
    process  = Offer
  }
  control seller {
    enter  Collect+ : / send cfp Task { id = "t1" } to bidder
    repeat Collect : refuse Task from bidder
    leave  Collect : when [all_answered(bidder)]
  }
  control bidder { enter Offer : cfp Task from seller / send refuse Task { id = "t1" } to seller }
}
"""


def test_an_activity_is_renamed_where_a_participant_says_that_it_sends() -> None:
    text = """system S
message Task { string id }
aip hiring {
  participant manager { sends cfp Task by Ask or Wait  process = Ask . Wait }
  participant worker { receives cfp Task  process = Work }
}
"""
    changed = renamed(text, "process = ^Ask", "Call")
    assert "sends cfp Task by Call or Wait  process = Call . Wait" in changed


def test_a_variable_is_renamed_where_a_message_comes_from_its_agent() -> None:
    text = """system S
message Task { string id }
aip hiring {
  participant manager {
    var best : agent
    sends cfp Task  receives inform Task
    process = Ask . Wait
  }
  participant worker [1..*] { sends inform Task  receives cfp Task  process = Work }
  control manager {
    enter Ask  : / send cfp Task to best
    enter Wait : inform Task from best
  }
}
"""
    changed = renamed(text, "var ^best", "first")
    assert "best" not in changed and "inform Task from first" in changed


DELIVERY = """system House
aip delivery {
  participant courier {
    given low : bool
    result load : int
    process = Consider . [Carry]
  }
  control courier {
    enter Carry : [!low && load == 0] / load = 3
    skip  Carry : else
  }
}
srm robot {
  var low : bool
  plays delivery.courier with low = !low, load = parcels
  var parcels : int
  liveness { robot = courier . [Rest] }
  control robot { enter Rest : [parcels > 1] / low = true  skip Rest : else }
}
"""


def test_an_input_is_renamed_where_it_is_supplied() -> None:
    text = renamed(DELIVERY, "given ^low", "weak")
    assert "given weak : bool" in text and "[!weak && load == 0]" in text
    assert "with weak = !low, load" in text and "var low : bool" in text


def test_a_result_and_the_variable_that_gets_it_have_their_own_names() -> None:
    text = renamed(DELIVERY, "result ^load", "weight")
    assert "result weight : int" in text and "weight = parcels" in text and "/ weight = 3" in text
    text = renamed(DELIVERY, "var ^parcels", "sum")
    assert "load = sum" in text and "[sum > 1]" in text and "load == 0" in text


def test_a_formula_is_renamed_where_it_is_bound() -> None:
    text = DELIVERY.replace("with low", "with Carry = carry, low").replace(
        "robot = courier . [Rest]", "robot = courier . [Rest]  carry = Lift . Walk"
    )
    text = renamed(text, "^carry = Lift", "bring")
    assert "with Carry = bring, low" in text and "bring = Lift . Walk" in text


NESTED = """system House
aip ride {
  participant passenger { given goal : int  result level : int  process = Call . Travel }
}
aip delivery {
  participant courier {
    plays ride.passenger as trip with goal = floor, level = there, Call = Ring
    var floor : int
    var there : int
    process = Consider . trip . HandOver
  }
  control courier { enter trip : [floor > 1]  leave HandOver : [there == floor] }
}
srm porter {
  plays delivery.courier with Ring = Phone
  liveness { porter = courier }
}
"""


@pytest.mark.parametrize(
    ("marked", "new", "expected"),
    [
        ("plays ride.passenger as ^trip", "way", ("as way with", ". way . HandOver", "enter way :")),
        ("Consider . ^trip", "way", ("as way with", ". way . HandOver", "enter way :")),
        ("participant ^passenger", "rider", ("participant rider", "plays ride.rider as trip")),
        ("given ^goal", "aim", ("given aim", "with aim = floor")),
        ("result ^level", "height", ("result height", "height = there")),
        ("var ^floor", "storey", ("goal = storey", "[storey > 1]", "== storey]")),
        ("var ^there", "now", ("level = now,", "[now == floor]")),
        ("aip ^ride", "lift", ("aip lift", "plays lift.passenger as trip")),
        ("Call = ^Ring", "Bell", ("Call = Bell", "with Bell = Phone")),
    ],
)
def test_what_a_participant_plays_is_renamed(marked: str, new: str, expected: tuple[str, ...]) -> None:
    text = renamed(NESTED, marked, new)
    assert [part for part in expected if part not in text] == []


TARGETS = """system T
statechart r {
  state 0 OR  state 0.1 START  state 0.2 AND
  state 0.2.1 OR  state 0.2.1.1 START  state 0.2.1.2 BASIC A
  state 0.2.2 OR  state 0.2.2.1 START  state 0.2.2.2 BASIC B
  0.1 -> (0.2.1.2, 0.2.2.2) :
  0.2.1.1 -> 0.2.1.2 :
  0.2.2.1 -> 0.2.2.2 :
}
"""


@pytest.mark.parametrize(("marked", "name"), [("(^0.2.1.2", "A"), (", ^0.2.2.2)", "B")])
def test_each_of_several_targets_leads_to_its_state(marked: str, name: str) -> None:
    workspace = Workspace()
    workspace.open(PATH, TARGETS)
    view = workspace.view(PATH)
    assert view is not None
    before, _, after = marked.partition("^")
    place = TARGETS.index(before + after) + len(before)
    label = after.rstrip(")")
    found = hover(view, place)
    assert found is not None and f"State `{label}`: BASIC `{name}`" in found.text
    (declared,) = definition(view, place)
    assert declared.span.text == label and declared.span.line == (4 if name == "A" else 5)
    assert [use.span.line for use in references(view, place, PythonFolders(()))] == [
        declared.span.line,
        6,
        7 if name == "A" else 8,
    ]
    assert "a label is the place of a state" in renamed(TARGETS, marked, "0.2.7")
    assert "BASIC C" in renamed(TARGETS, f"BASIC ^{name}", "C")
