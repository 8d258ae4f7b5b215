"""Optimise: how many agents are worth it, which settings are best, and which activity is the bottleneck."""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from aseme_dsl.project.spreading.cluster import Cluster
from aseme_dsl.project.studying import study as studies
from aseme_dsl.project.studying.findings import Row, best, rows, slowest, worth
from aseme_dsl.project.studying.study import TIME, Case, StudyError
from aseme_dsl.project.studying.study_report import Study, Untried
from aseme_dsl.project.studying.variation import Knob, Variant, instead, variants, varied
from aseme_dsl.records import dataclass

if TYPE_CHECKING:
    from aseme_dsl.amola.system import System
    from aseme_dsl.project.building.build import Choice


@dataclass(frozen=True, slots=True)
class Question:
    """What a study is to find out.

    `least` is the share that a further step must gain to be worth it. `times` is how much quicker each
    activity is tried for the bottleneck. If it is 1, the bottleneck is not looked for.
    """

    knobs: tuple[Knob, ...]
    seeds: tuple[int, ...]
    less_is_better: bool = False
    least: float = 0.05
    times: float = 2.0
    crew: int | Cluster = 1


def optimise(
    system: System,
    question: Question,
    plan: studies.Plan,
    choice: Choice,
    *,
    total: Callable[[int], None] = lambda runs: None,
    told: Callable[[], None] = lambda: None,
) -> Study:
    """Play all variants, choose, and look for the bottleneck of what was chosen.

    `total` is called with the number of runs, as soon as that is known; `told` is called after each.

    Raises:
        ClusterError: the cluster cannot be used.
        StudyError: something cannot be played or measured.
        VariationError: the system cannot be varied so.
    """
    cases = [Case(variant) for variant in variants(question.knobs)]
    for case in cases:  # all mistakes before the first run
        varied(system, case.variant)
    known = activities_of(system)
    if plan.measure != TIME and ":" not in plan.measure and plan.measure not in known:
        raise StudyError(f"no agent of the team does {plan.measure}; {instead(plan.measure, known)}")
    takes = {name: activity.takes for name in known if (activity := system.activity(name)) is not None}
    tried = [name for name in known if takes.get(name) and question.times != 1]
    total(len(question.seeds) * (len(cases) + len(tried)))
    with tempfile.TemporaryDirectory(prefix="asemec-") as folder:

        def play(what: Sequence[Case], name: str) -> tuple[studies.Played, ...]:
            return studies.play_all(
                system,
                what,
                question.seeds,
                plan,
                Path(folder) / name,
                choice,
                times=question.times,
                crew=question.crew,
                told=told,
            )

        played = play(cases, "variants")
        found = rows(played, less_is_better=question.less_is_better)
        chosen = _chosen(question, found)
        variant: Variant = chosen.variant if chosen is not None else cases[0].variant
        quicker = play([Case(variant, name) for name in tried], "quicker") if tried and chosen else ()
    base = next(item for item in played if item.case.variant == variant)
    untried = [name for name in known if name not in tried] if question.times != 1 else []
    codeless = {name for item in played for run in item.runs for name in run.without_code}
    return Study(
        system.name,
        question.knobs,
        plan.measure,
        question.less_is_better,
        question.seeds,
        plan.length,
        question.least,
        question.times,
        played,
        found,
        chosen,
        quicker,
        slowest(base, quicker, less_is_better=question.less_is_better),
        Untried(
            tuple(name for name in untried if takes.get(name) is None and name not in codeless),
            tuple(name for name in untried if name in codeless),
            tuple(name for name in untried if takes.get(name) == 0),
        ),
        network=plan.words,
    )


def _chosen(question: Question, found: Sequence[Row]) -> Row | None:
    if len(question.knobs) == 1 and question.knobs[0].counts:
        return worth(found, question.least, less_is_better=question.less_is_better)
    return best(found, less_is_better=question.less_is_better)


def activities_of(system: System) -> tuple[str, ...]:
    """What the agents of the team do, in the order of the charts."""
    roles = {agent.role for team in system.teams for agent in team.agents}
    charts = [chart for chart in system.iacs if chart.name in roles]
    names = (node.activity for chart in charts for node in chart.states if node.activity is not None)
    return tuple(dict.fromkeys(names))
