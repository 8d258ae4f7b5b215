"""Playing: the scenarios of a system in as many processes as are wanted, or on a cluster."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import count
from pathlib import Path
from tempfile import TemporaryDirectory
from types import MappingProxyType
from typing import TYPE_CHECKING

from aseme_dsl.play.coverage.probes import Probed, Recorder, probed
from aseme_dsl.play.coverage.seen import Following, Seen
from aseme_dsl.play.run import NotPlayable, Played, play
from aseme_dsl.play.scenario import Scenario, Script
from aseme_dsl.play.sight.guards import Guards
from aseme_dsl.project.spreading.cluster import Cluster, Copied
from aseme_dsl.project.spreading.spread import spread
from aseme_dsl.project.testing.cases import Case, cases_of
from aseme_dsl.project.testing.shrinking import Shrunk, shrunk, text_of
from aseme_dsl.project.testing.story_pictures import file_names
from aseme_dsl.project.testing.verdicts import NotRun, ScenarioResult, Verdict, verdict_of
from aseme_dsl.records import dataclass

if TYPE_CHECKING:
    from aseme_dsl.amola.system import System
    from aseme_dsl.project.building.build import Choice
    from aseme_dsl.project.building.project import Compiled
    from aseme_dsl.project.settings.configuration import Configuration

TRACE = ".jsonl.gz"
"""The end of the name of a trace."""
MANY = 20
"""So many runs one process makes before another one is of use."""


@dataclass(frozen=True, slots=True)
class _Job:
    """Some of the runs of a script."""

    package: Path
    project: Path
    activities: Path
    script: Script
    cases: tuple[Case, ...]
    until: int
    world: str | None
    probed: Probed | None
    """What is measured, if coverage is."""
    guards: Guards | None = None
    """The conditions of the roles, if the runs are to have a story."""
    trace: Path | None = None


def scenarios_in(compiled: Compiled, bound: Mapping[str, str] = MappingProxyType({})) -> tuple[Scenario, ...]:
    """The scenarios of a system that has no errors; `any ROLE` is the agent that is `bound` to the role."""
    from aseme_dsl.compiler.phases import scenarios_of

    return scenarios_of(compiled.inspection, bound)


def play_scenarios(
    system: System,
    scenarios: Sequence[Scenario],
    seeds: Sequence[int],
    configuration: Configuration,
    choice: Choice,
    activities: Path,
    crew: int | Cluster,
    told: Callable[[str], None] = lambda text: None,
    seen: Seen | None = None,
    traces: Path | None = None,
) -> tuple[ScenarioResult, ...]:
    """The verdicts on scenarios, in their order. `told` is given how much is done.

    What the runs reach of the system is added to `seen`, if it is given. Into the folder `traces` a trace of
    each failure is written, of the run that is shown.

    Raises:
        ClusterError: the cluster cannot be used.
        OperateError: the code of the system cannot be written.
    """
    from aseme_dsl.project.building.build import with_labels
    from aseme_dsl.project.playing.operate import generate_version
    from aseme_dsl.project.settings.configuration import OUTPUT

    project = configuration.folder.resolve()
    cases = [cases_of(scenario, seeds) for scenario in scenarios]
    labelled = with_labels(system, choice.labels)
    measured = None if seen is None else probed(labelled)
    charts = {chart.name: chart for chart in labelled.iacs}
    guards = Guards(charts, labelled.activities, labelled.messages)
    with TemporaryDirectory(prefix="asemec-test-") as folder:
        package, _ = generate_version(system if measured is None else measured.system, Path(folder), choice)
        jobs = [
            _Job(
                package,
                project,
                activities,
                scenario.scripts[part[0].script],
                part,
                _end(scenario, part, configuration.length),
                world_of(scenario.scripts[part[0].script], configuration),
                measured,
            )
            for scenario, mine in zip(scenarios, cases, strict=True)
            for part in (_parts(mine) if scenario.refused is None else ())
        ]
        copied = (
            Copied(Path(folder)),
            Copied(activities),
            Copied(project, (configuration.output or Path(OUTPUT),)),
        )
        needed = -(-sum(map(len, cases)) // MANY)
        done = count(1)
        played = spread(
            _play,
            jobs,
            crew if isinstance(crew, Cluster) else max(1, min(crew, needed)),
            copied,
            lambda: told(f"{next(done)} of {len(jobs)} parts played"),
        )
        found = iter(played)
        runs = [
            [run for _ in _parts(mine) for run in next(found).runs] if scenario.refused is None else []
            for scenario, mine in zip(scenarios, cases, strict=True)
        ]
        names = file_names(item.name for item in scenarios)
        jobs_of = {id(job.cases[0]): job for job in jobs}
        results = [
            _shown(
                scenario, mine, own, jobs_of, guards, None if traces is None else traces / f"{name}{TRACE}"
            )
            for scenario, mine, own, name in zip(scenarios, cases, runs, names, strict=True)
        ]
    if seen is not None:
        for item in played:
            seen.add(item.seen)
        seen.scenarios += len(scenarios)
        seen.evaluated += len(scenarios)
    return tuple(results)


def _shown(
    scenario: Scenario,
    cases: Sequence[Case],
    runs: Sequence[Played | NotRun],
    jobs: Mapping[int, _Job],
    guards: Guards,
    trace: Path | None,
) -> ScenarioResult:
    """The verdict on a scenario; that of a failure is about a smaller run in which it fails, too.

    This run is made once more for its story, and recorded in `trace`, if that is given.
    """
    result = verdict_of(scenario, cases, runs)
    if result.verdict is not Verdict.FAILED:
        return result
    case, found = cases[result.place], runs[result.place]
    script = scenario.scripts[case.script]
    assert isinstance(found, Played)
    part = next(part for part in _parts(cases) if any(one is case for one in part))
    job = jobs[id(part[0])]

    def play_again(smaller: Script, inputs: Mapping[str, object]) -> Played | None:
        (run,) = _play(replace(job, script=smaller, cases=(replace(case, inputs=inputs),))).runs
        return run if isinstance(run, Played) else None

    best = Shrunk(found, script, case.inputs, ())
    may_be_less = found.broken is not None and bool(script.stimuli or script.inputs)
    if may_be_less:
        best = shrunk(script, case.inputs, found, play_again)
    if trace is not None:
        trace.parent.mkdir(parents=True, exist_ok=True)
    job = replace(job, guards=guards, trace=trace, probed=None)
    told = play_again(best.script, best.inputs)
    is_steady = told is not None and told.states == best.run.states
    if found.broken is not None:
        run = told if told is not None and is_steady else best.run
        again = verdict_of(scenario, (replace(case, inputs=best.inputs),), (run,))
        result = replace(again, runs=result.runs)
    return replace(
        result,
        story=() if told is None else told.story,
        is_steady=is_steady,
        dropped=best.dropped,
        shrunk=text_of(scenario, script, best, case.seed) if may_be_less else "",
        trace=trace,
    )


def _end(scenario: Scenario, part: Sequence[Case], usual: int) -> int:
    script = scenario.scripts[part[0].script]
    return max(script.until, usual) if script.is_open else script.until


def world_of(script: Script, configuration: Configuration) -> str | None:
    """The function that makes the world of a script: its own, or that of the project."""
    project = configuration.run.world if configuration.run is not None else None
    return script.world or (project if script.world == "" else None)


def _parts(cases: Sequence[Case]) -> Iterator[tuple[Case, ...]]:
    """Cases of one script each, and not too many."""
    begin = 0
    for place in range(1, len(cases) + 1):
        is_last = place == len(cases) or cases[place].script != cases[begin].script
        if is_last or place - begin == MANY:
            yield tuple(cases[begin:place])
            begin = place


@dataclass(frozen=True, slots=True)
class _Done:
    """The runs of a job, and what they have reached."""

    runs: list[Played | NotRun]
    seen: Seen


def _play(job: _Job) -> _Done:
    """The runs of a job; what they leave in the project's modules is not there for the next."""
    from aseme_dsl.project.playing.operate import loaded_for
    from aseme_dsl.project.playing.play import PlayError, made_world
    from aseme_dsl.runtime.version.loading import LoadError, activities_in, forgetting, importing

    found: list[Played | NotRun] = []
    seen = Seen()
    recorder = None if job.probed is None else Recorder(job.probed.probes, seen.evaluations)
    charts = {} if job.probed is None else {chart.name: chart for chart in job.probed.system.iacs}
    try:
        loaded = loaded_for(job.package, job.project)
    except LoadError as problem:
        return _Done([NotRun(str(problem)) for _ in job.cases], seen)
    for case in job.cases:
        follow = [] if recorder is None else [Following(charts, seen, dict(job.script.team))]
        with forgetting(job.project), importing([job.project, *loaded.path]):
            try:
                real = activities_in(job.activities)
                world = made_world(job.world, case.seed) if job.world is not None else None
                given = (case.seed, case.inputs, real, job.until, world)
                found.append(
                    play(loaded, job.script, *given, follow, recorder, guards=job.guards, trace=job.trace)
                )
            except PlayError as problem:
                found.append(NotRun(problem.problem.message))
            except NotPlayable as problem:
                found.append(NotRun(str(problem), problem.span))
    return _Done(found, seen)


__all__ = ["play_scenarios", "scenarios_in", "world_of"]
