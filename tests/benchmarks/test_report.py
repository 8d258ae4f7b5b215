"""The report of a comparison: targets with whether they are met, marks for what is not counted, a page."""

from __future__ import annotations

from pathlib import Path

import pytest

from benchmarks.peers.contenders import BY_HAND, CORE_TYPED, PY_TREES, SEND, SEND_DICT, STATECHART
from benchmarks.peers.loading import GUARDED, SIMPLE, Loading
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


def test_both_blackboards_are_shown_and_what_has_no_target_is_not_missed(
    results: Results, tmp_path: Path
) -> None:
    for run in ("ours", "peers"):
        results.series[run, "player", SEND_DICT.key] = Series([5e-7] * 4, [1.25] * 4)  # type: ignore[index]
    results.series["ours", "loops", CORE_TYPED.key] = Series([4e-7] * 4, [2.5] * 4)
    results.figures |= {"around_dict": 104.4, "around_slots": 70.2}
    before = missed(results)
    text = written(results, tmp_path).read_text("utf-8")
    assert "| complete runtime with a dictionary, the player | 1.25 × by hand | – |  |" in text
    assert "| core `done`, eight loops, one waits for a message | 2.50 × by hand | – |  |" in text
    assert "| statechart 0.4.2 | 25 × | 20 × | – | 20 × |" in text
    assert "104 ns are the measurement and the setting of four flags,\nwith slots 70.2 ns." in text
    assert missed(results) == before


def test_memory_has_a_limit_for_each_number_of_regions(results: Results, tmp_path: Path) -> None:
    for regions, size in ((1, 48), (8, 200), (64, 600)):
        results.memory[regions, CORE_TYPED.key] = size, 1e-6
    results.memory[1, STATECHART.key] = 9754, 1e-4
    text = written(results, tmp_path).read_text("utf-8")
    assert "without its blackboard, one region | 48 bytes | ≤ 108 | met |" in text
    assert "without its blackboard, 8 regions | 200 bytes | ≤ 164 | **missed**, 22 % above |" in text
    assert "without its blackboard, 64 regions | 600 bytes | ≤ 612 | met |" in text
    assert "| statechart 0.4.2 | 9 754 | – | – | 100 | – | – |" in text


def test_what_is_loaded_is_told_beside_what_is_made(results: Results, tmp_path: Path) -> None:
    results.loadings = [
        Loading(SIMPLE, "a simple one", 90_000, 8e-5, 4e-4),
        Loading(GUARDED, "with guards", 270_000, 2.5e-4, 1e-3),
    ]
    results.constructed["ring_1000", SEND.key] = 1e-3
    results.constructed["ring_1000", STATECHART.key] = 4e-2
    text = written(results, tmp_path).read_text("utf-8")
    assert "| loading a compiled chart, 1 000 states | 0.08 ms | ≤ 0.10 | met |" in text
    assert "each with a guard and an action | 0.25 ms | – |  |" in text
    assert "| a simple one | 90 | 0.08 | 0.40 |" in text
    making = text.partition("## Making a machine")[2]
    assert f"| {SEND.title} | 1 |" in making and "| statechart 0.4.2 | 40 |" in making


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
