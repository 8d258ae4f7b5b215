"""What each region reads and writes: by its conditions, actions and activities, and by regions inside."""

from __future__ import annotations

from aseme_dsl.amola.statechart import Statechart
from tests.support.compiling import system

WORLD = """system S
message M { int n }
topic a { state M  data M  signal M }
topic b under a { state M }
topic c { state M  signal M }
"""


def regions(liveness: str, rest: str = "") -> dict[str, tuple[str, str]]:
    text = WORLD + f"srm R {{ liveness {{ {liveness} }} {rest} }}"
    return by_label(system(text).iacs[0])


def by_label(chart: Statechart) -> dict[str, tuple[str, str]]:
    return {
        item.label: (" ".join(map(str, item.reads)), " ".join(map(str, item.writes)))
        for item in chart.regions
    }


def test_the_root_is_a_region() -> None:
    control = (
        "control R { enter B : [c.state.M.n > 0] / a.signal.M.n = b.state.M.n; write_messages.a.signal.M }"
    )
    assert regions("R = A . B", control) == {"0": ("b.state.M c.state.M", "a.signal.M")}


def test_each_concurrent_part_reads_what_it_uses_and_the_one_around_it_all_but_signals() -> None:
    control = """control inner {
        enter A : [a.signal.M.n > 0 && a.state.M.n > 0]
        enter B : [has(c.signal.M)] / write_messages.c.state.M
        finish inner : [b.state.M.n > 0]
    }"""
    assert regions("R = inner || C . D   inner = A || B", control) == {
        "0": ("a.state.M b.state.M", ""),
        "0.2.1": ("a.state.M b.state.M", ""),
        "0.2.1.2.2.1": ("a.signal.M a.state.M", ""),
        "0.2.1.2.2.2": ("c.signal.M", "c.state.M"),
        "0.2.2": ("", ""),
    }


def test_activities_read_and_write_where_they_stand() -> None:
    activities = "activities { A reads a.data.M for 2s writes c.state.M  B reads below a }"
    assert regions("R = A || B", activities) == {
        "0": ("a.data.M a.state.M b.state.M", ""),
        "0.2.1": ("a.data.M", "c.state.M"),
        "0.2.2": ("a.data.M a.signal.M a.state.M b.state.M", ""),
    }


def test_ages_histories_and_lets_count_as_reading() -> None:
    control = """let young = age(a.state.M) < 1s
    control R { enter B : [young && mean(a.data.M.n, 1s) > 0] }"""
    found = regions("R = A . B", control)
    assert found == {"0": ("a.data.M a.state.M", "")}


def test_the_transitions_around_an_and_belong_to_the_region_that_holds_it() -> None:
    control = "control R { start R : [a.signal.M.n > 0]  enter A : [c.signal.M.n > 0] }"
    assert regions("R = A || B", control) == {
        "0": ("a.signal.M", ""),
        "0.2.1": ("c.signal.M", ""),
        "0.2.2": ("", ""),
    }
