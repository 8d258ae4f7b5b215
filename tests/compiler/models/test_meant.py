"""Which states a condition means by a name: those of the innermost state around it that holds any."""

from __future__ import annotations

from aseme_dsl.amola.meant import states_meant
from aseme_dsl.amola.statechart import Statechart
from tests.support.compiling import role_chart


def meant(chart: Statechart, source: str, name: str) -> list[str]:
    return [node.label for node in states_meant(chart, source, name)]


def test_the_source_itself_is_looked_at_first() -> None:
    chart = role_chart("R = A . B . A")
    assert meant(chart, "0.4", "A") == ["0.4"]
    assert meant(chart, "0.3", "A") == ["0.2", "0.4"]


def test_the_innermost_state_that_holds_one_counts() -> None:
    chart = role_chart("R = (A . B) . (A . C) . D")
    assert meant(chart, "0.2.3", "A") == ["0.2.2"]
    assert meant(chart, "0.3.1", "A") == ["0.3.2"]
    assert meant(chart, "0.4", "A") == ["0.2.2", "0.3.2"]


def test_other_regions_are_looked_at_further_out() -> None:
    chart = role_chart("R = A || B")
    assert meant(chart, "0.2.2.2", "A") == ["0.2.1.2"]


def test_a_formula_goes_by_its_name_and_what_is_not_there_is_none() -> None:
    chart = role_chart("R = play . B  play = A . C")
    assert meant(chart, "0.3", "play") == ["0.2"]
    assert meant(chart, "0.2.2", "play") == ["0.2"]
    assert meant(chart, "0.2.2", "D") == []


def test_only_states_that_fit_count() -> None:
    chart = role_chart("R = A . B . A")
    found = states_meant(chart, "0.3", "A", lambda node: node.label != "0.2")
    assert [node.label for node in found] == ["0.4"]
