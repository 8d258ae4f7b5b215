"""The drawing that follows the cursor."""

from __future__ import annotations

import re
from pathlib import Path
from xml.etree import ElementTree

import pytest

from aseme_dsl.diagrams.rendering import store
from aseme_dsl.editor.answers.diagram import EARLIER, MISTAKES, READABLE, Diagrams, LiveDrawing
from aseme_dsl.editor.files.workspace import Workspace
from tests.editor.authoring import CURSOR, PATH

TEXT = """\
system Team

message Seen { bool ball }
topic eyes { state Seen }

sag {
  actor player { goal score depends on goalie "The ball is in the goal." }
  actor goalie { }
}

suc { usecase score by player includes walk }

aip attack {
  participant center { process = WalkToBall . Kick }
  participant wing { process = Wait }
}

srm player {
  plays attack.center
  liveness {
    player = Look+ || decision
    decision = center | Rest
  }
  activities { Look takes 1s  Rest takes 2s  WalkToBall takes 1s  Kick takes 1s }
  control player {
    leave  Look : [eyes.state.Seen.ball]
    repeat Look : else
  }
  control decision {
    enter center : [eyes.state.Seen.ball]
    enter Rest   : else
  }
}

team Kouretes { one, two : player }
"""


class Session:
    """An editor with one file and one view beside it."""

    def __init__(self) -> None:
        self.diagrams = Diagrams()
        self.workspace = Workspace()

    def at(self, place: str, text: str = TEXT) -> LiveDrawing | None:
        """The drawing where `place`, a piece of the text with the cursor in it, stands."""
        before, _, after = place.partition(CURSOR)
        assert text.count(before + after) == 1, place
        self.workspace.open(PATH, text)
        view = self.workspace.view(PATH)
        assert view is not None
        return self.diagrams.at(view, text.index(before + after) + len(before))


@pytest.fixture(scope="module")
def session() -> Session:
    return Session()


def here(drawing: LiveDrawing | None) -> str:
    """The text that the highlighted element stands for."""
    assert drawing is not None and drawing.here is not None
    return drawing.elements[drawing.here].text


@pytest.mark.parametrize(
    ("place", "name", "text"),
    [
        ("goal score dep‸ends", "sag", "score"),
        ("actor goa‸lie", "sag", "goalie"),
        ("score by pl‸ayer includes", "suc", "score"),
        ("process = Walk‸ToBall", "eac.attack", "WalkToBall"),
        ("participant wi‸ng", "eac.attack", None),
        ("player = Lo‸ok+", "iac.player", "Look"),
        ("Look+ |‸| decision", "iac.player", "Look+ || decision"),
        ("center | Re‸st", "iac.player", "Rest"),
        ("leave  Look : [eyes‸.", "iac.player", "leave  Look : [eyes.state.Seen.ball]"),
        ("enter Re‸st   : else", "iac.player", "enter Rest   : else"),
        ("Kick ta‸kes", "iac.player", None),
        ("Ki‸ck takes", "iac.player", "Kick"),
        ("dec‸ision = center", "iac.player", "decision"),
        ("two : pla‸yer", "iac.player", None),
    ],
)
def test_the_model_that_the_cursor_is_in(session: Session, place: str, name: str, text: str | None) -> None:
    drawing = session.at(place)
    assert drawing is not None
    assert (drawing.name, drawing.note) == (name, "")
    if text is not None:
        assert here(drawing) == text


@pytest.mark.parametrize("place", ["message Se‸en", "topic ey‸es", "system Te‸am"])
def test_where_there_is_no_model(session: Session, place: str) -> None:
    assert session.at(place) is None


def test_everything_that_is_drawn_leads_into_the_text(session: Session) -> None:
    for place in ("goal sc‸ore depends", "usecase sc‸ore", "process = Walk‸ToBall", "player = Lo‸ok+"):
        drawing = session.at(place)
        assert drawing is not None
        root = ElementTree.fromstring(drawing.svg)
        ids = {element.get("id") for element in root.iter()}
        assert set(drawing.elements) <= ids
        compact = root.get("class") == "aseme-compact"
        named = {
            element.get("id", "")
            for element in root.iter()
            if element.get("id")
            and (compact or element.get("class", "").split(" ", 1)[0] in ("node", "edge", "cluster"))
        }
        assert {item for item in named if not re.search("corner", item)} == set(drawing.elements)
        for span in drawing.elements.values():
            assert span.source.text == TEXT
            assert span.text


def test_what_it_shows_in_words(session: Session) -> None:
    drawing = session.at("player = Lo‸ok+")
    assert drawing is not None
    assert drawing.title.startswith("Statechart of the role player: ")


class TestMistakes:
    def test_a_mistake_elsewhere_is_noted(self) -> None:
        session = Session()
        drawing = session.at("player = Lo‸ok+", TEXT.replace("Rest   : else", "Rset : else"))
        assert drawing is not None and drawing.note == MISTAKES
        assert here(drawing) == "Look"

    def test_what_cannot_be_drawn_now_is_shown_as_it_was(self) -> None:
        session = Session()
        good = session.at("player = Lo‸ok+")
        assert good is not None
        broken = TEXT.replace("Look+ || decision", "Look+ || || decision")
        drawing = session.at("player = Lo‸ok+", broken)
        assert drawing is not None
        assert (drawing.svg, drawing.note, drawing.here) == (good.svg, EARLIER, None)
        again = session.at("player = Lo‸ok+")
        assert again is not None and again.note == ""

    def test_a_mistake_of_syntax_in_another_model_hides_nothing(self) -> None:
        session = Session()
        session.at("player = Lo‸ok+")
        drawing = session.at("player = Lo‸ok+", TEXT.replace("depends on goalie", "depends goalie"))
        assert drawing is not None and drawing.note == MISTAKES
        assert here(drawing) == "Look"

    def test_with_mistakes_from_the_beginning_there_is_what_could_be_read(self) -> None:
        broken = TEXT.replace("Look+ || decision", "Look+ || || decision")
        drawing = Session().at("center | Re‸st", broken)
        assert drawing is not None and drawing.note == MISTAKES
        assert here(drawing) == "Rest"

    @pytest.mark.parametrize("at", range(0, len(TEXT), 37))
    def test_a_text_that_ends_anywhere(self, at: int) -> None:
        session = Session()
        session.workspace.open(PATH, TEXT[:at])
        view = session.workspace.view(PATH)
        assert view is not None
        session.diagrams.at(view, at)


class TestLarge:
    FORMULAS = "\n".join(
        f"part{number} = {' . '.join(f'Step{number}x{step:02}' for step in range(40))}"
        for number in range(12)
    )
    TEXT = f"""\
system Large
srm robot {{
  liveness {{
    robot = {" . ".join(f"part{number}" for number in range(12))}
    {FORMULAS}
  }}
}}
"""

    @pytest.mark.long
    def test_the_part_around_the_cursor(self) -> None:
        session = Session()
        whole = session.at("liveness ‸{", self.TEXT)
        part = session.at("Step0x03‸", self.TEXT)
        again = session.at("Step0x09‸", self.TEXT)
        assert whole is not None and part is not None and again is not None
        assert whole.name == "iac.robot" and ">Step0x03<" not in whole.svg
        assert part.name == again.name and part.svg == again.svg
        assert here(part) == "Step0x03"
        assert here(again) == "Step0x09"
        for drawing in (whole, part):
            root = ElementTree.fromstring(drawing.svg)
            assert float(root.get("width", "")) <= 1920 and float(root.get("height", "")) <= 1080
            assert not re.search(r"\bhref=", drawing.svg), "there is no other page here"

    def test_many_side_by_side_are_shown_all_the_same(self) -> None:
        steps = " | ".join(f"Step{number}" for number in range(READABLE + 20))
        text = f"system Wide\nsrm robot {{\n  liveness {{ robot = A . ({steps}) }}\n}}\n"
        drawing = Session().at("Step42‸ ", text)
        assert here(drawing) == "Step42"


def test_a_place_in_a_file_that_a_system_imports(tmp_path: Path) -> None:
    protocol = TEXT[TEXT.index("aip attack") : TEXT.index("srm player")]
    (tmp_path / "attack.aseme").write_text(protocol)
    (tmp_path / "team.aseme").write_text(TEXT.replace(protocol, 'import "attack.aseme"\n\n'))
    session = Session()
    path = str(tmp_path / "attack.aseme")
    session.workspace.folders = [str(tmp_path)]
    session.workspace.open(path, protocol)
    view = session.workspace.view(path)
    assert view is not None
    drawing = session.diagrams.at(view, protocol.index("Kick"))
    assert drawing is not None and drawing.name == "eac.attack"
    assert here(drawing) == "Kick"
    other = session.workspace.view(str(tmp_path / "team.aseme"))
    assert other is not None
    drawing = session.diagrams.at(other, other.source.text.index("player = Look"))
    assert drawing is not None
    shown = {view.program.path_of(span.source) for span in drawing.elements.values()}
    assert shown == {str(tmp_path / "attack.aseme"), str(tmp_path / "team.aseme")}


def test_moving_the_cursor_draws_nothing_again(monkeypatch: pytest.MonkeyPatch) -> None:
    drawn: list[str] = []
    real = store.render

    def render(drawing: store.Drawing, format: str, *, time_limit: float) -> bytes:
        drawn.append(drawing.name)
        return real(drawing, format, time_limit=time_limit)

    monkeypatch.setattr(store, "render", render)
    session = Session()
    for place in ("player = Lo‸ok+", "Look+ || dec‸ision", "center | Re‸st"):
        session.at(place)
    session.at("player = Lo‸ok+", f"// a word more\n{TEXT}")
    assert drawn == ["iac.player"]
