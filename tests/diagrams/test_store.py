"""Pictures that are kept."""

from __future__ import annotations

from pathlib import Path

import pytest

from aseme_dsl.diagrams import DrawingFailed, Layout, Options, draw_statechart, drawings
from aseme_dsl.diagrams.look.drawing import Drawing
from aseme_dsl.diagrams.look.words import words
from aseme_dsl.diagrams.rendering import store
from aseme_dsl.diagrams.rendering.store import Store, key_of
from tests.diagrams.building import statechart
from tests.diagrams.texts import TEAM, compiled


def drawing(formula: str) -> Drawing:
    return draw_statechart(statechart(formula), Options(layout=Layout.NESTED))[0]


@pytest.fixture
def drawn(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The DOT texts that were given to Graphviz."""
    found: list[str] = []
    real = store.render

    def render(item: Drawing, format: str, *, time_limit: float) -> bytes:
        found.append(item.dot)
        return real(item, format, time_limit=time_limit)

    monkeypatch.setattr(store, "render", render)
    return found


def test_the_same_text_is_drawn_once(drawn: list[str]) -> None:
    kept = Store()
    assert kept.render(drawing("A . B"), "svg") == kept.render(drawing("A . B"), "svg")
    assert kept.render(drawing("A | B"), "svg") != kept.render(drawing("A . B"), "svg")
    assert len(drawn) == 2
    assert kept.render(drawing("A . B"), "png").startswith(b"\x89PNG")


def test_what_was_wanted_long_ago_is_forgotten(drawn: list[str]) -> None:
    kept = Store(most=2)
    for formula in ("A", "B", "A", "C", "A", "B"):
        kept.render(drawing(formula), "svg")
    assert len(drawn) == 4


def test_a_folder_outlives_it(tmp_path: Path, drawn: list[str]) -> None:
    first = Store(tmp_path / "new").render(drawing("A . B"), "svg")
    assert [path.name for path in (tmp_path / "new").iterdir()] == [f"{key_of(drawing('A . B'))}.svg"]
    assert Store(tmp_path / "new").render(drawing("A . B"), "svg") == first
    assert len(drawn) == 1
    (tmp_path / "file").write_text("no folder")
    assert Store(tmp_path / "file").render(drawing("A . B"), "svg") == first


def test_a_failure_is_not_kept(monkeypatch: pytest.MonkeyPatch) -> None:
    kept = Store()
    with monkeypatch.context() as patch, pytest.raises(DrawingFailed):
        patch.setattr(store, "program", lambda: "/bin/false")
        patch.setattr("aseme_dsl.diagrams.rendering.layout.program", lambda: "/bin/false")
        kept.render(drawing("A . B"), "svg")
    assert kept.render(drawing("A . B"), "svg")


def test_every_drawing_has_words() -> None:
    system = compiled(TEAM)
    said = {item.name: words(system, item) for item in drawings(system)}
    assert all(said.values())
    assert len(set(said.values())) == len([name for name in said if not name.endswith(".tree")])
    assert all("\n" not in text for text in said.values())


def test_the_words_of_a_part_are_about_the_part() -> None:
    system = compiled(TEAM)
    whole = next(item for item in drawings(system) if item.name.startswith("iac."))
    part = drawings(system, Options(at="0.2", layout=Layout.NESTED))[-1]
    assert ", state 0.2: " in words(system, part)
    assert ", state" not in words(system, whole)
