"""What each name in a file means."""

from __future__ import annotations

import dataclasses
import types
import typing
from pathlib import Path

import pytest

from aseme_dsl.amola.expression import LOSS_REASONS
from aseme_dsl.editor.answers.hover import hover
from aseme_dsl.editor.answers.navigation import PythonFolders, definition, references
from aseme_dsl.editor.files.index import NAMES, UNNAMED, Kind, Symbol, Use
from aseme_dsl.editor.files.view import View
from aseme_dsl.editor.files.workspace import Workspace
from aseme_dsl.grammar.text import tree

ROOT = Path(__file__).parents[2]


def opened(text: str, path: str = "/nowhere/team.aseme") -> View:
    workspace = Workspace()
    workspace.open(path, text)
    view = workspace.view(path)
    assert view is not None
    return view


def symbol(view: View, marked: str) -> Symbol | None:
    """What the name means that begins where `marked` has its `^`."""
    before, _, after = marked.partition("^")
    found = view.occurrence_at(view.source.text.index(before + after) + len(before))
    return found.symbol if found is not None else None


def node_classes() -> list[type]:
    return [
        item
        for item in vars(tree).values()
        if dataclasses.is_dataclass(item) and isinstance(item, type) and item.__module__ == tree.__name__
    ]


def holds_names(hint: object) -> bool:
    """Whether a field of this type has a Name in it directly, or in a tuple."""
    if hint is tree.Name:
        return True
    if typing.get_origin(hint) in (tuple, types.UnionType, typing.Union):
        return any(holds_names(item) for item in typing.get_args(hint))
    return False


@pytest.mark.parametrize("node", node_classes(), ids=lambda node: node.__name__)
def test_every_name_of_the_tree_is_indexed_or_deliberately_not(node: type) -> None:
    """A new construct of the language is entered in NAMES or UNNAMED."""
    if node is tree.Path:
        return  # taken apart by what it stands in
    for name, hint in typing.get_type_hints(node).items():
        if holds_names(hint):
            assert ((node, name) in NAMES) != ((node, name) in UNNAMED), f"{node.__name__}.{name}"


@pytest.mark.parametrize(
    "path",
    [
        *sorted((ROOT / "tests/acceptance").glob("*.aseme")),
        *sorted((ROOT / "examples").rglob("*.aseme")),
        *sorted((ROOT / "stdlib").glob("*.aseme")),
    ],
    ids=lambda path: path.name,
)
def test_every_name_of_a_whole_file_means_something(path: Path) -> None:
    workspace = Workspace()
    workspace.open(str(path), path.read_text("utf-8"))
    view = workspace.view(str(path))
    assert view is not None and view.file is not None
    indexed = {view.whole(item.span).start for item in view.occurrences}
    left = []
    todo: list[object] = list(view.file.declarations)
    while todo:
        node = todo.pop()
        if isinstance(node, tree.Name):
            if view.whole(node.span).start not in indexed:
                left.append(node.text)
        elif isinstance(node, tuple):
            todo += node
        elif dataclasses.is_dataclass(node) and type(node).__module__ == tree.__name__:
            todo += [
                getattr(node, item.name)
                for item in dataclasses.fields(node)
                if (type(node), item.name) not in UNNAMED
            ]
    outcomes = {name for item in view.program.inspection.symbols.activities.values() for name in item.ends}
    assert [name for name in left if name not in {"index", "error", *LOSS_REASONS, *outcomes}] == []


TEAM = """\
system Team
import soccer
message Note { int number }
topic board { state Note  signal Note }
let near = vision.state.Ball.distance < 3
let note = board.state.Note

aip swap {
  participant giver {
    engage "always"
    var tries : int = 0
    sends inform Note
    process = Give . [more]
    more = Give . Rest
  }
  participant taker { engage "always"  receives inform Note  process = Take }
  clause Give@giver before Take@taker
  control giver { enter Give : / send inform Note to taker; tries = tries + 1 }
  control more { leave Rest : [tries > 2] }
}

srm keeper {
  plays swap.giver as handing with Give = Hand
  var seen : int = 0
  let far = !near
  liveness {
    keeper = (look | handing)~
    look = Scan . [Jump]
  }
  activities { Scan uses camera writes board.state.Note }
  functionality camera { technology "eye" }
  control look {
    enter Jump : when [far && note.number > seen && expired(pace)] / start_timer(pace, 1s); seen = 2
    skip Jump : [robot1.board.state.Note.number == 3 && game.state.GameState.set_play == SetPlay.KICK_IN]
  }
}
team Team { robot1 : keeper }
"""


@pytest.mark.parametrize(
    ("marked", "expected"),
    [
        ("system ^Team", Symbol(Kind.SYSTEM, "Team")),
        ("import ^soccer", Symbol(Kind.LIBRARY, "soccer")),
        ("state ^Note ", Symbol(Kind.MESSAGE, "Note")),
        ("state.Ball.^distance", Symbol(Kind.FIELD, "distance", "Ball")),
        ("process = ^Give", Symbol(Kind.ACTIVITY, "Give")),
        ("[^more]", Symbol(Kind.FORMULA, "more", "swap.giver")),
        ("control ^more", Symbol(Kind.FORMULA, "more", "swap.giver")),
        ("control ^giver", Symbol(Kind.PARTICIPANT, "giver", "swap")),
        ("clause ^Give", Symbol(Kind.ACTIVITY, "Give")),
        ("Give@^giver", Symbol(Kind.PARTICIPANT, "giver", "swap")),
        ("to ^taker", Symbol(Kind.PARTICIPANT, "taker", "swap")),
        ("leave Rest : [^tries", Symbol(Kind.VARIABLE, "tries", "swap.giver")),
        ("plays swap.^giver", Symbol(Kind.PARTICIPANT, "giver", "swap")),
        ("| ^handing", Symbol(Kind.ALIAS, "handing", "keeper")),
        ("with Give = ^Hand", Symbol(Kind.ACTIVITY, "Hand")),
        ("= (^look", Symbol(Kind.FORMULA, "look", "keeper")),
        ("enter ^Jump", Symbol(Kind.ACTIVITY, "Jump")),
        ("let far = !^near", Symbol(Kind.LET, "near")),
        ("when [^far", Symbol(Kind.LET, "far", "keeper")),
        ("&& note.^number", Symbol(Kind.FIELD, "number", "Note")),
        ("expired(^pace", Symbol(Kind.TIMER, "pace", "keeper")),
        ("; ^seen", Symbol(Kind.VARIABLE, "seen", "keeper")),
        ("[^robot1", Symbol(Kind.AGENT, "robot1")),
        ("[robot1.^board", Symbol(Kind.TOPIC, "board")),
        ("SetPlay.^KICK_IN", Symbol(Kind.CONSTANT, "KICK_IN", "SetPlay")),
        ("uses ^camera", Symbol(Kind.FUNCTIONALITY, "camera")),
        ("robot1 : ^keeper", Symbol(Kind.ROLE, "keeper")),
    ],
)
def test_what_a_name_means(marked: str, expected: Symbol) -> None:
    assert symbol(opened(TEAM), marked) == expected


CELL = """\
system Cell
enum Place { TRAY BELT }
srm arm {
  var home : Place = Place.TRAY
  liveness {
    arm = deliver(Place.BELT, home)~
    deliver(from, to) = MoveTo(from) . Grasp . MoveTo(to)
  }
  activities { MoveTo(goal : Place) takes 1s  Grasp takes 1s ends held, slipped }
  control deliver { enter Grasp : [to != Place.TRAY && in(deliver) && outcome(Grasp) == held] }
}
team Cell { left : arm with home = Place.BELT }
"""


@pytest.mark.parametrize(
    ("marked", "expected"),
    [
        ("Place.BELT, ^home", Symbol(Kind.VARIABLE, "home", "arm")),
        ("(Place.^BELT", Symbol(Kind.CONSTANT, "BELT", "Place")),
        ("= ^deliver(", Symbol(Kind.FORMULA, "deliver", "arm")),
        ("MoveTo(^from", Symbol(Kind.PARAMETER, "from", "arm.deliver")),
        ("(from, ^to)", Symbol(Kind.PARAMETER, "to", "arm.deliver")),
        ("[^to !=", Symbol(Kind.PARAMETER, "to", "arm.deliver")),
        (". ^MoveTo(to", Symbol(Kind.ACTIVITY, "MoveTo")),
        ("MoveTo(^goal", Symbol(Kind.PARAMETER, "goal", "MoveTo")),
        ("goal : ^Place", Symbol(Kind.ENUM, "Place")),
        ("in(^deliver", Symbol(Kind.FORMULA, "deliver", "arm")),
        ("outcome(^Grasp", Symbol(Kind.ACTIVITY, "Grasp")),
        ("with ^home", Symbol(Kind.VARIABLE, "home", "arm")),
    ],
)
def test_what_parameters_mean(marked: str, expected: Symbol) -> None:
    assert symbol(opened(CELL), marked) == expected


def test_where_a_symbol_is_declared_and_used() -> None:
    view = opened(TEAM)
    index = view.program.index
    number = Symbol(Kind.FIELD, "number", "Note")
    declared = index.declarations(number)
    assert [view.whole(item.span).line for item in declared] == [3]
    assert [view.whole(item.span).line for item in index.of(number)] == [3, 33, 34]
    seen = Symbol(Kind.VARIABLE, "seen", "keeper")
    assert [item.use for item in index.of(seen)] == [Use.DECLARATION, Use.READ, Use.WRITE]


def test_a_name_of_the_standard_library_is_declared_there() -> None:
    view = opened(TEAM)
    declared = view.program.index.declarations(Symbol(Kind.FIELD, "distance", "Ball"))
    assert [Path(view.program.path_of(item.span.source)).name for item in declared] == ["soccer.aseme"]


def test_control_of_an_included_formula_is_about_that_formula() -> None:
    view = opened(
        "system T\n"
        "abstract srm walker { liveness { walk = Step . Rest } activities { Step takes 1s Rest takes 1s } }\n"
        "srm robot {\n"
        "  includes walker\n"
        "  liveness { robot = (walk | Wait)~ }\n"
        "  control robot { enter walk : [true] enter Wait : else }\n"
        "  control walk { enter Rest : [true] }\n"
        "}\n"
    )
    text = view.source.text
    place = text.index("control walk") + len("control ")
    assert [item.span.start for item in definition(view, place)] == [text.index("walk = Step")]
    used = {item.span.start for item in references(view, text.index("walk = Step"), PythonFolders())}
    assert used == {text.index(one) for one in ("walk = ", "walk | Wait", "walk : [true]")} | {place}
    about = hover(view, text.index("Rest : [true]"))
    assert about is not None and "State `0.2.3.3` of robot" in about.text
