"""Whether runs of a changed protocol show a fault, and whether it is refuted then."""

from __future__ import annotations

from aseme_dsl.project.proving.results import Verdict
from benchmarks.protocol_mutants import answers, candidates, faults_of
from tests.cli.test_prove import BUY


def test_a_fault_shows_in_runs_and_is_refuted() -> None:
    assert not faults_of("buy", BUY, 1, 3).found
    text = BUY.replace("    enter Close : else / send refuse Order { .. } to buyer\n", "")
    shown = faults_of("buy", text, 1, 3)
    assert (shown.runs, set(shown.found)) == (6, {"deadlock"})
    assert answers("buy", text, 2000, 60.0)["deadlock"].verdict is Verdict.REFUTED
    assert not faults_of("buy", text.replace("system", "sistem"), 1, 3).runs


def test_mutants_are_drawn_from_each_protocol_by_turns() -> None:
    drawn = candidates(1)
    first = [next(drawn) for _ in range(10)]
    assert [item.protocol for item in first[:5]] == [item.protocol for item in first[5:]]
    assert len({item.protocol for item in first}) == 5
