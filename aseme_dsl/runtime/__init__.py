"""Runtime: everything that a robot needs to run a team's statecharts, and nothing else.

Generated code imports only this package; activities use `Context` and, if they like, `Activity`.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from aseme_dsl.runtime.activity.access import UndeclaredError
    from aseme_dsl.runtime.activity.activities import Activity, ActivityError
    from aseme_dsl.runtime.activity.context import Cancelled, Context
    from aseme_dsl.runtime.chart.board import NEVER, Board
    from aseme_dsl.runtime.chart.chart import Chart
    from aseme_dsl.runtime.chart.inputs import AgentMessage, Sample
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
    from aseme_dsl.runtime.team.team import AgentResult, RunResult, Setup, Team, TeamError, make_team, run
    from aseme_dsl.runtime.team.timed_inputs import InputFileError, TimedInput, read_inputs
    from aseme_dsl.runtime.version.loading import Loaded, LoadError, activities_in, load_system
    from aseme_dsl.runtime.world.body import Body, BodyConnectionError, RadioMessage, World

_MODULES = {
    "activity.access": ("UndeclaredError",),
    "activity.activities": ("Activity", "ActivityError"),
    "chart.board": ("NEVER", "Board"),
    "world.body": ("Body", "BodyConnectionError", "RadioMessage", "World"),
    "chart.chart": ("Chart",),
    "activity.context": ("Cancelled", "Context"),
    "chart.inputs": ("Sample", "AgentMessage"),
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
    "team.timed_inputs": ("TimedInput", "InputFileError", "read_inputs"),
    "team.team": ("AgentResult", "RunResult", "Setup", "Team", "TeamError", "make_team", "run"),
}
"""Where each name is: its module is imported when it is asked for, since most commands need none."""


def __getattr__(name: str) -> object:
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
    "AgentMessage",
    "AgentResult",
    "Board",
    "Body",
    "BodyConnectionError",
    "BranchInfo",
    "Cancelled",
    "ChannelInfo",
    "Chart",
    "Context",
    "InputFileError",
    "LoadError",
    "Loaded",
    "Plan",
    "RadioMessage",
    "Region",
    "RunResult",
    "Sample",
    "Setup",
    "State",
    "Team",
    "TeamError",
    "TimedInput",
    "Transition",
    "UndeclaredError",
    "Variable",
    "World",
    "activities_in",
    "find_plan",
    "load_system",
    "make_team",
    "plans",
    "read_inputs",
    "register",
    "run",
]
