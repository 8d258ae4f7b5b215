"""Written: what the code of activities writes beside what is declared: variables of their participants.

Activities need not declare these. If lines of the protocol write such a variable, too, then that an activity
does is only known from its code.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import replace
from pathlib import Path
from types import FunctionType
from typing import cast

from aseme_dsl.amola.system import System
from aseme_dsl.project.building.project import code_folder
from aseme_dsl.project.playing.operate import loaded_for
from aseme_dsl.project.settings.configuration import Configuration
from aseme_dsl.runtime.chart.chart import Chart
from aseme_dsl.runtime.chart.plan import ActivityInfo
from aseme_dsl.runtime.version.loading import Loaded


def loaded_with_writes(package: Path, system: System, configuration: Configuration) -> Loaded:
    """A generated system to explore: its activities write what they declare, and what their code does.

    Raises LoadError.
    """
    loaded = loaded_for(package, configuration.folder.resolve())
    folder = code_folder(configuration, None)
    if not system.aips or folder is None or not folder.is_dir():
        return loaded
    from aseme_dsl.project.code.activity_code import variables_written

    written = variables_written(system, folder, configuration.folder)
    charts = {role: _writing(chart, written) for role, chart in loaded.charts.items()}
    return replace(loaded, charts=charts)


def _writing(chart: type[Chart], written: Mapping[str, Collection[str | None]]) -> type[Chart]:
    """The chart of a role whose activities write what their code writes of participants."""
    plan = chart.PLAN
    of_participants = frozenset(
        item.name.partition("@")[0] for item in plan.variables if item.scope is not None
    )
    activities = tuple(
        _with_code(info, written.get(info.name, ()), of_participants) for info in plan.activities
    )
    if activities == plan.activities:
        return chart
    methods = {name: item for name, item in vars(chart).items() if isinstance(item, FunctionType)}
    # What is opened where a team is explored are the methods of the class, in the names of its module.
    own: dict[str, object] = {**methods, "__slots__": (), "__module__": chart.__module__}
    own["PLAN"] = replace(plan, activities=activities)
    return cast("type[Chart]", type(chart.__name__, (chart,), own))


def _with_code(
    info: ActivityInfo, code: Collection[str | None], of_participants: frozenset[str]
) -> ActivityInfo:
    """An activity that also writes those variables of participants that its code writes."""
    names = of_participants if None in code else of_participants.intersection(code)
    return replace(info, variables=tuple(dict.fromkeys((*info.variables, *sorted(names)))))


__all__ = ["loaded_with_writes"]
