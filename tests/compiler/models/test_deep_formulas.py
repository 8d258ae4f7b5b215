"""Formulas that are nested deep, and wrong at each level: a message spells what it quotes, and no more."""

from __future__ import annotations

import sys
from types import FrameType

import pytest

from aseme_dsl.amola.liveness import canonical
from aseme_dsl.compiler import analyse
from aseme_dsl.compiler.read.memory import Memory
from aseme_dsl.compiler.read.pieces import finished
from aseme_dsl.compiler.types.state_values import check_states
from aseme_dsl.source import Source
from tests.support.compiling import system
from tests.support.work import instructions

DEPTH = 100


@pytest.mark.parametrize(
    "program",
    [
        "system S srm R { liveness { R = FORMULA } }",
        "system S srm R { liveness { R = FORMULA } control R { enter B : go } }",
        "system S aip P { participant p { process = FORMULA } }",
    ],
    ids=["role", "control", "protocol"],
)
@pytest.mark.parametrize("opening", ["(a . ", "(a | "])
def test_a_term_is_spelled_as_a_whole_a_few_times(program: str, opening: str) -> None:
    spelled = 0

    def count(frame: FrameType, event: str, argument: object) -> None:
        nonlocal spelled
        spelled += event == "c_call" and frame.f_code is canonical.__code__

    before = sys.getprofile()
    sys.setprofile(count)
    try:
        analyse(Source("deep.aseme", program.replace("FORMULA", f"{opening * DEPTH}A . B{')*' * DEPTH}")))
    finally:
        sys.setprofile(before)
    assert spelled < 140 * DEPTH**2


def test_the_work_for_questions_about_states_grows_as_their_number() -> None:
    def work(number: int) -> int:
        condition = " || ".join(["in(A)"] * number)
        control = f"enter A : [{condition}] enter B : else"
        made = system(f"system S srm R {{ liveness {{ R = (A | B)~ }} control R {{ {control} }} }}")
        charts = [chart for chart in (made.iac("R"),) if chart is not None]
        return instructions(lambda: finished(check_states(charts, Memory())))

    assert 0 < work(400) < 3 * work(200)
