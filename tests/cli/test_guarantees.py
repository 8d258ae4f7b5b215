"""What activities guarantee, watched in scenarios, runs, replays and logs."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.cli.support import Here

TEAM = """
system Team
message Order { int to }
topic team { state Order }
srm boss {
  liveness { boss = Give~ }
  activities {
    Give writes team.state.Order
         guarantees no sent Order b [b.to != a.to] within 1400ms after sent Order a [a.to != 0]
         guarantees never sent Order o [o.to < 0]
  }
}
srm worker {
  liveness { worker = Work~ }
  activities { Work takes 100ms simulated reads team.state.Order }
}
team Team { one : boss  two : worker }
"""

PROJECT = """[tool.asemec]
files = ["team.aseme"]
activities = "activities"
[tool.asemec.run]
duration = "5s"
"""

CODE = """from monas.Team.messages import Order

from aseme_dsl.runtime import Context


class Give:
    def execute(self, context: Context) -> None:
        context.publish("team.state.Order", Order(int(context.now_ns // 10**9) % 3 + 1))
        context.wait(1.0)
"""


@pytest.fixture
def team(here: Here, folder: Path) -> Here:
    (folder / "pyproject.toml").write_text(PROJECT)
    (folder / "activities").mkdir()
    (folder / "activities" / "give.py").write_text(CODE)
    (folder / "team.aseme").write_text(TEAM)
    return here


def told(here: Here, folder: Path, scenario: str) -> str:
    (folder / "team.aseme").write_text(f'{TEAM}\nscenario "s" {{ {scenario} }}\n')
    return here("test").out


@pytest.mark.parametrize(
    ("scenario", "reason"),
    [
        (
            "activity Give takes 1s writes team.state.Order { to = 1 } every 300ms "
            "writes team.state.Order { to = 2 } for 2s",
            "Give publishes Order { to = 2 } at 1 s, after Order { to = 1 } at 0 s",
        ),
        (
            "activity Give takes 1s writes team.state.Order { to = -1 } for 2s",
            "Give publishes Order { to = -1 } at 1 s",
        ),
        ("activity Give takes 1s writes team.state.Order { to = 1 } every 300ms for 5s", ""),
        ("activity Give takes 1s writes team.state.Order { to = 0 } every 300ms for 5s", ""),
        ("at 1s two receives team.state.Order { to = -1 } for 2s", ""),
        ("at 1s two receives team.state.Order { to = -1 } from one for 2s", ""),
    ],
)
def test_scenarios_fail_where_a_guarantee_is_broken(
    team: Here, folder: Path, scenario: str, reason: str
) -> None:
    out = told(team, folder, scenario)
    assert (f"guarantee of Give: {reason}" in out) if reason else out.startswith("passed"), out


def test_what_was_sent_before_a_crash_counts_after_it(team: Here, folder: Path) -> None:
    """With the code of the project, which sends another order in each second."""
    code = folder / "activities" / "give.py"
    code.write_text(CODE.replace("context.wait(1.0)", "context.wait(9.0)"))
    scenario = "activity Give real crash one at 500ms restart one at 1300ms for {}"
    assert "after Order { to = 1 } at 0 s" in told(team, folder, scenario.format("2s"))
    late = told(team, folder, scenario.replace("1300ms", "1401ms").format("2s"))
    assert late.startswith("passed"), late


def test_runs_replays_and_logs_show_the_breach(team: Here) -> None:
    done = team("run", "--strict")
    assert done.code == 1
    assert "broken at 1 s: guarantee of Give (team.aseme:9:10)" in done.out
    for command in ("replay", "observe"):
        found = team(command, "out/trace.jsonl.gz")
        assert "at 1 s: guarantee of Give" in found.out, found.out
