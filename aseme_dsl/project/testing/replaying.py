"""Replaying: the steps of a trace made again by the model that the trace has in it."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from contextlib import ExitStack
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING

from aseme_dsl.play.inputs import Messages
from aseme_dsl.play.replay import Difference, Model, Models, NotReplayable, Replay
from aseme_dsl.play.scenario import Refused
from aseme_dsl.project.testing.watching import Watch, Watched, script_in
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.chart import Chart
from aseme_dsl.runtime.trace.packed import unpacked
from aseme_dsl.runtime.trace.records import Record
from aseme_dsl.runtime.trace.trace_reading import Line, TraceReader

if TYPE_CHECKING:
    from aseme_dsl.amola.system import System


@dataclass(frozen=True, slots=True)
class Replayed:
    """What came of a trace: how many steps of which agents were made again, and the first difference."""

    path: Path
    agents: tuple[str, ...]
    steps: int
    seconds: float
    difference: Difference | None = None
    problem: str | None = None
    """What is to be said of the file, if it is not whole."""
    watched: tuple[Watched, ...] = ()
    """What has become of properties and clauses; with a difference, those that were broken before."""
    unwatched: str | None = None
    """Why nothing is watched, or no more."""


def replay(path: Path, agents: Collection[str] = ()) -> Replayed:
    """Make the steps of a trace again, up to the first difference; of these agents, or of all.

    Properties and clauses are watched if all agents are followed.

    Raises:
        TraceError: there is no such trace, or it is none.
        NotReplayable: it does not say enough.
    """
    reader = TraceReader(path)
    with ExitStack() as stack:
        replaying = Replay(lambda sources: models_of(sources, stack), agents)
        difference, watch, moment = None, None, 0
        for line in reader:
            record = line.record
            difference = replaying.line(record, line.number)
            if difference is not None:
                break
            if line.number == 1 and not agents:
                watch = _watch(replaying, record)
            moment = record["time"]
            if isinstance(watch, Watch):
                followed = replaying.agents.get(record.get("agent", ""))
                watch.see(record, None if followed is None or followed.waits else followed.chart)
    watched: tuple[Watched, ...] = ()
    if isinstance(watch, Watch):
        watch.finish(moment)
        watched = tuple(item for item in watch.end() if difference is None or item.verdict == "broken")
        watch = watch.stopped
    return Replayed(
        reader.path,
        tuple(replaying.agents),
        replaying.steps,
        replaying.seconds,
        difference,
        reader.problem if difference is None else None,
        watched,
        watch,
    )


def _watch(replaying: Replay, header: Record) -> Watch | str | None:
    """What watches the properties and clauses of a recorded run, if its model has any; or why nothing can."""
    from aseme_dsl.project.settings.configuration import Configuration

    team = {name: agent.chart.PLAN.name for name, agent in replaying.agents.items()}
    script = script_in(unpacked(header["sources"]), Configuration(Path()), team)
    if isinstance(script, Refused):
        return f"properties and clauses are not watched: {script.span}: {script.reason}"
    return None if script is None else Watch(script, lambda text: None, False, replaying.plans)


def replayed_to(
    reader: TraceReader, moment: int, models: Models, agents: Collection[str] = ()
) -> tuple[Replay, Difference | None]:
    """A replay of all steps up to a moment (ns), this one included; with the first difference, if any.

    It begins with the newest checkpoints that are not later, and so does not read what is before them. Where
    the trace does not say enough there, it begins with the first line.

    Raises:
        TraceError: it is not a trace.
        NotReplayable: it does not say enough.
    """
    try:
        return _replayed(reader.since(moment, agents), moment, Replay(models, agents, reader.before))
    except NotReplayable:
        return _replayed(iter(reader), moment, Replay(models, agents))


def _replayed(lines: Iterator[Line], moment: int, replaying: Replay) -> tuple[Replay, Difference | None]:
    for line in lines:
        if line.record["time"] > moment:
            break
        difference = replaying.line(line.record, line.number)
        if difference is not None:
            return replaying, difference
    return replaying, None


def models_of(sources: Mapping[str, str], stack: ExitStack) -> dict[str, Model]:
    """The step classes of a model's files, by the hashes of the roles' models; their files last as `stack`.

    Raises:
        NotReplayable: this version of asemec does not compile them.
    """
    charts, messages = generated(compiled(sources), stack)
    return {kind.PLAN.model: Model(kind, messages) for kind in charts.values()}


def compiled(sources: Mapping[str, str]) -> System:
    """The system of a model's files, the first of which is the root. Raises NotReplayable."""
    from aseme_dsl.compiler import analyse
    from aseme_dsl.diagnostics import Severity
    from aseme_dsl.source import Source

    root, *_ = sources
    analysis = analyse(Source(root, sources[root]), sources)
    if analysis.system is None:
        first = next((item for item in analysis.diagnostics if item.severity is Severity.ERROR), None)
        raise NotReplayable(f"its model does not compile: {'' if first is None else first.message}")
    return analysis.system


def generated(system: System, stack: ExitStack) -> tuple[Mapping[str, type[Chart]], Messages]:
    """The step classes of a system by role, and its messages; their files last as `stack`.

    Raises:
        NotReplayable: they cannot be written or loaded.
    """
    from aseme_dsl.project.building.build import Choice
    from aseme_dsl.project.playing.operate import OperateError, generate_version
    from aseme_dsl.runtime.version.loading import LoadError, load_system

    folder = stack.enter_context(TemporaryDirectory(prefix="asemec-replay-"))
    try:
        package, _ = generate_version(system, Path(folder), Choice())
        loaded = load_system(package)
    except (OperateError, LoadError) as problem:
        raise NotReplayable(f"its model cannot be loaded: {problem}") from problem
    return loaded.charts, vars(loaded.modules[f"{package.parent.name}.{package.name}.messages"])


__all__ = ["Replayed", "compiled", "generated", "models_of", "replay", "replayed_to"]
