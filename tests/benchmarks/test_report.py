"""The report of a comparison: targets with whether they are met, marks for what is not counted, a page."""

from __future__ import annotations

from pathlib import Path

import pytest

from benchmarks.peers.contenders import BY_HAND, CORE_TYPED, PY_TREES, SEND, STATECHART
from benchmarks.peers.measuring import Results, Series
from benchmarks.peers.report import PLOT, into_page, missed, written, wrongs


@pytest.fixture
def results() -> Results:
    found = Results()

    def add(run: str, behaviour: str, key: str, nanoseconds: float, ratio: float) -> None:
        seconds = [nanoseconds * 1e-9] * 4
        found.series[run, behaviour, key] = Series(seconds, [ratio] * 4)  # type: ignore[index]

    for run in ("ours", "peers"):
        add(run, "player", BY_HAND.key, 500, 1)
        add(run, "player", SEND.key, 400, 0.8)
    add("ours", "player", CORE_TYPED.key, 350, 0.7)
    add("peers", "player", STATECHART.key, 10_000, 20)
    add("peers", "player", PY_TREES.key, 90_000, 180)
    found.refused["player", PY_TREES.key] = "entered_Stand is 2, not 1"
    found.differing.add(("player", PY_TREES.key))
    found.versions[STATECHART.key] = "0.4.2"
    found.missing = ["sismic"]
    return found


def test_the_report_says_what_is_met_and_by_how_much_something_is_missed(
    results: Results, tmp_path: Path
) -> None:
    text = written(results, tmp_path).read_text("utf-8")
    assert "| complete runtime, the player | 0.80 × by hand | ≤ 1.30 | met |" in text
    assert "| statechart against the complete runtime, the player | 25 × | ≥ 15 | met |" in text
    assert "| 0.70 × by hand | ≤ 0.65 | **missed**, 8 % above |" in text
    assert missed(results) == [
        "core step with typed blackboard, the player: 0.70 × by hand, wanted ≤ 0.65 (8 % above)"
    ]
    assert "| statechart 0.4.2 |" in text
    assert "Not installed: sismic." in text
    assert f"]({PLOT})" in text
    assert (tmp_path / PLOT).read_text("utf-8").startswith("<svg ")
    assert str(tmp_path) not in text


def test_who_does_something_else_is_shown_and_not_counted(results: Results, tmp_path: Path) -> None:
    text = written(results, tmp_path).read_text("utf-8")
    assert "90 µs \\*" in text
    assert "180 ×" not in text
    assert "py_trees, the player: its counts differ (entered_Stand is 2, not 1)." in text
    assert wrongs(results) == []
    results.refused["player", SEND.key] = "entered_Stand is 2, not 1"
    assert wrongs(results) == ["complete runtime (`Machine.send`), the player: entered_Stand is 2, not 1"]


def test_the_figures_of_a_page_are_replaced(results: Results, tmp_path: Path) -> None:
    (tmp_path / "pictures").mkdir()
    page = tmp_path / "page.md"
    page.write_text("before\n<!-- measured by a -->\nold\n<!-- /measured -->\nafter\n", "utf-8")
    into_page(results, page)
    once = page.read_text("utf-8")
    into_page(results, page)
    assert page.read_text("utf-8") == once
    assert once.startswith("before\n<!-- measured by a -->\n")
    assert once.endswith("<!-- /measured -->\nafter\n")
    assert "old" not in once
    assert f"](pictures/{PLOT})" in once
    page.write_text("before\nafter\n", "utf-8")
    with pytest.raises(ValueError, match="no place"):
        into_page(results, page)
