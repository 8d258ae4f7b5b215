"""The acceptance files compile as they stand, to the charts of the papers."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

import pytest

from aseme_dsl.amola.original_names import labels_as_original
from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.compiler import analyse
from tests.conftest import Snapshot
from tests.support.compiling import role_chart
from tests.support.show import show

ACCEPTANCE = Path(__file__).resolve().parents[2] / "acceptance"


def charts(name: str) -> tuple[Statechart, ...]:
    found = analyse(ACCEPTANCE / f"{name}.aseme")
    assert found.system is not None, found.diagnostics
    assert {item.severity for item in found.diagnostics} <= {"note"}
    return found.system.statecharts


@pytest.mark.parametrize("name", ["testbehavior", "kouretes", "contract_net"])
def test_every_chart(name: str, snapshot: Snapshot) -> None:
    for chart in charts(name):
        snapshot(show(chart), f"{name}.{chart.kind.lower()}.{chart.name}.txt")


def test_test_behavior_is_the_chart_of_the_second_paper() -> None:
    (chart,) = charts("testbehavior")
    assert (len(chart.states), len(chart.transitions), chart.levels) == (14, 13, 4)
    assert Counter(node.type for node in chart.states) == dict(OR=3, BASIC=3, CONDITION=2, START=3, END=3)


def test_the_player_is_the_chart_of_figure_4() -> None:
    chart = next(chart for chart in charts("kouretes") if chart.name == "player")
    assert (len(chart.states), len(chart.transitions), chart.levels) == (124, 92, 19)
    assert Counter(node.type for node in chart.states) == dict(
        OR=35, AND=3, BASIC=20, CONDITION=5, START=35, END=26
    )


def test_names_on_request_as_the_original_tools_spell_them() -> None:
    (chart,) = charts("testbehavior")
    original = labels_as_original(chart)
    assert [node.name for node in original.children("0")] == [
        "0.1",
        "_open_group_Play_or_NoPlay_close_group_",
        "0.3",
    ]
    assert original.transitions[1].name == (
        "_open_group_Play_or_NoPlay_close_group_TO_open_group_Play_or_NoPlay_close_group_"
    )
    assert [node.label for node in original.states] == [node.label for node in chart.states]
    player = labels_as_original(next(chart for chart in charts("kouretes") if chart.name == "player"))
    assert player.node("0.2.1.2").name == "Sensors_forever_"
    assert player.node("0.2.5.2").name == "_open_group_initialize_sequence_activate_close_group_"


ORIGINALS = {
    "R = Init . DoNothing+": (8, 6),
    "R = (play | NoPlay)+\nplay = Change . Go+": (16, 14),
    "R = A~ || B~ || C~ || D~ || E~ || F~": (40, 26),
    """R = Init . (playing | nonPlaying)+
       nonPlaying = NoPlay . [Go+]
       playing = Scan+ | Approach+ | Kick | follow
       follow = Stare+ . [Special]""": (48, 46),
    """R = (NonPlaying | Playing)+
       NonPlaying = NoPlay . [Go+]
       Playing = [Localize+] . [Go+] . MakeAction
       MakeAction = Scan+ | Approach+ | Kick+ | Follow
       Follow = Stare+ . [Special]""": (66, 64),
}


@pytest.mark.parametrize("formulas", ORIGINALS)
def test_charts_that_the_original_tools_built_have_their_sizes(formulas: str) -> None:
    chart = role_chart(formulas)
    assert (len(chart.states), len(chart.transitions)) == ORIGINALS[formulas]
