"""What behaviours show is where the chart is, at every instant, also after the team has been changed."""

from __future__ import annotations

import pytest

from aseme_dsl.backends.jade_like import BACKEND
from aseme_dsl.runtime.chart import chart
from aseme_dsl.runtime.team.team import Team
from tests.faults.changing import version
from tests.faults.test_swap import script_for
from tests.oracle.charts import text as random_text
from tests.oracle.choices import Choices
from tests.oracle.examples import ROUNDS, forget
from tests.runtime.playing import MS, SECOND, make
from tests.support.generated import generate

EXAMPLES = 12


def look(team: Team) -> None:
    """Each agent's behaviours show all states that are active, and no others."""
    for agent in team.agents:
        if agent.shown is None or agent.over:
            continue
        leaves = [label.split(".") for label in agent.chart.configuration()]
        active = {".".join(parts[:end]) for parts in leaves for end in range(1, len(parts) + 1)}
        assert agent.shown.active == active
        shown = {label for item in agent.shown.behaviours if item.active for label in item.states}
        assert {
            label for label in active if agent.plan.by_label[label].type in ("OR", "AND", "BASIC")
        } <= shown


@pytest.mark.parametrize("seed", range(EXAMPLES))
def test_random_charts(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(chart, "ROUNDS", ROUNDS)
    choices = Choices(f"view {seed}")
    written = random_text(choices)
    made, moved = generate(written, backend=BACKEND), generate("\n\n" + written, backend=BACKEND)
    try:
        agents = [("me", "R"), ("you", "R")]
        options = {"script": script_for(choices, made), "agents": agents, "until": 2 * SECOND, "stop": look}
        team, _ = make(made, version=version(made), **options)
        for moment, other in ((choices.number(0, 700) * MS, moved), (choices.number(800, 1500) * MS, made)):
            team.swap(version(other), at=moment)
        team.run()
    finally:
        forget(made)
        forget(moved)
