"""No input, however broken, ends in a traceback, and none keeps the compiler busy without end."""

from __future__ import annotations

from pathlib import Path

import pytest

from aseme_dsl.diagnostics import render_text
from tests.support.compiling import analysis, codes, system
from tests.support.large import large_file

ACCEPTANCE = Path(__file__).resolve().parents[2] / "acceptance"


@pytest.mark.parametrize("name", ["testbehavior", "kouretes", "contract_net"])
def test_a_file_without_one_of_its_lines(name: str) -> None:
    lines = (ACCEPTANCE / f"{name}.aseme").read_text("utf-8").splitlines(keepends=True)
    for number in range(0, len(lines), 3):
        render_text(analysis("".join(lines[:number] + lines[number + 1 :])).diagnostics)


@pytest.mark.parametrize("name", ["testbehavior", "contract_net"])
def test_a_file_that_ends_anywhere(name: str) -> None:
    text = (ACCEPTANCE / f"{name}.aseme").read_text("utf-8")
    for end in range(0, len(text), 23):
        render_text(analysis(text[:end]).diagnostics)


@pytest.mark.parametrize(
    "text", ["", " \n", "system", "system S", "}", "\x00", "srm srm srm", "statechart S { state 0.1 START }"]
)
def test_odd_texts(text: str) -> None:
    render_text(analysis(text).diagnostics)


def test_an_empty_file_is_a_clear_error() -> None:
    assert codes("") == ["E008", "W001"]


def test_a_statechart_that_could_not_be_read_completely_makes_no_follow_ups() -> None:
    text = (
        "system S statechart R { state 0 OR state 0.1 START state 0.2 OR ! state 0.2.1 START 0.1 -> 0.2 : }"
    )
    assert [code[:2] for code in codes(text)] == ["E1"]


def test_thousands_of_lines() -> None:
    """No phase depends on how deep the stack of Python is. `benchmarks/large_file.py` has 10 000 lines."""
    text = large_file(3_000)
    found = system(text)
    assert len(text.splitlines()) >= 3_000
    assert sum(len(chart.states) for chart in found.statecharts) > 3_000


def test_a_thousand_branches_with_a_thousand_lines() -> None:
    names = [f"A{n}" for n in range(1000)]
    lines = " ".join(f"enter {name} : [true]" for name in names)
    text = f"system S srm R {{ liveness {{ R = {' | '.join(names)} }} control R {{ {lines} }} }}"
    chart = system(text).iacs[0]
    assert [item.priority for item in chart.outgoing("0.2")] == list(range(1000))
