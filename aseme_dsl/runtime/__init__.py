"""Runtime: everything that a robot needs to run a team's statecharts, and nothing else.

Generated code imports only this package; activities use `Context` and, if they like, `Activity`.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from aseme_dsl.runtime.activity.access import UndeclaredError
    from aseme_dsl.runtime.activity.activities import Activity, ActivityError
    from aseme_dsl.runtime.activity.context import Cancelled, Context
    from aseme_dsl.runtime.chart.board import NEVER, Board
    from aseme_dsl.runtime.chart.chart import Chart
    from aseme_dsl.runtime.chart.inputs import Arrived, Mail
    from aseme_dsl.runtime.chart.plan import (
        ActivityInfo,
        BranchInfo,
        ChannelInfo,
        Plan,
        Region,
        State,
        Transition,
        Variable,
        find_plan,
        plans,
        register,
    )
    from aseme_dsl.runtime.team.scripted import Scripted, ScriptError, read_script
    from aseme_dsl.runtime.team.team import AgentResult, RunResult, Setup, Team, TeamError, make_team, run
    from aseme_dsl.runtime.version.loading import Loaded, LoadError, activities_in, load_system
    from aseme_dsl.runtime.world.body import Body, BodyLost, Heard, World

_MODULES = {
    "activity.access": ("UndeclaredError",),
    "activity.activities": ("Activity", "ActivityError"),
    "chart.board": ("NEVER", "Board"),
    "world.body": ("Body", "BodyLost", "Heard", "World"),
    "chart.chart": ("Chart",),
    "activity.context": ("Cancelled", "Context"),
    "chart.inputs": ("Arrived", "Mail"),
    "version.loading": ("Loaded", "LoadError", "activities_in", "load_system"),
    "chart.plan": (
        "ActivityInfo",
        "BranchInfo",
        "ChannelInfo",
        "Plan",
        "Region",
        "State",
        "Transition",
        "Variable",
        "find_plan",
        "plans",
        "register",
    ),
    "team.scripted": ("Scripted", "ScriptError", "read_script"),
    "team.team": ("AgentResult", "RunResult", "Setup", "Team", "TeamError", "make_team", "run"),
}
"""Where each name is: its module is imported when it is asked for, since most commands need none."""


def __getattr__(name: str) -> Any:
    for module, names in _MODULES.items():
        if name in names:
            value = globals()[name] = getattr(import_module(f"{__name__}.{module}"), name)
            return value
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


__all__ = [
    "NEVER",
    "Activity",
    "ActivityError",
    "ActivityInfo",
    "AgentResult",
    "Arrived",
    "Board",
    "Body",
    "BodyLost",
    "BranchInfo",
    "Cancelled",
    "ChannelInfo",
    "Chart",
    "Context",
    "Heard",
    "LoadError",
    "Loaded",
    "Mail",
    "Plan",
    "Region",
    "RunResult",
    "ScriptError",
    "Scripted",
    "Setup",
    "State",
    "Team",
    "TeamError",
    "Transition",
    "UndeclaredError",
    "Variable",
    "World",
    "activities_in",
    "find_plan",
    "load_system",
    "make_team",
    "plans",
    "read_script",
    "register",
    "run",
]
