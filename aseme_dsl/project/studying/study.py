"""Study: a team played in virtual time again and again, varied in its size, its settings and its speed.

This is the optimization phase of ASEME (P2, section 3): what the model leaves open as numbers is decided by
simulation. Every variant is played with the same seeds, so that two variants differ by what was varied and
not by random variation; runs are spread over processes.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import field, replace
from decimal import Decimal
from numbers import Real
from pathlib import Path
from typing import TYPE_CHECKING

from aseme_dsl.project.settings.configuration import OUTPUT, Configuration
from aseme_dsl.project.spreading.cluster import Cluster, Copied
from aseme_dsl.project.spreading.spread import spread
from aseme_dsl.project.studying.variation import Variant, quicker, varied
from aseme_dsl.records import dataclass

if TYPE_CHECKING:
    from aseme_dsl.amola.system import System
    from aseme_dsl.project.building.build import Choice
    from aseme_dsl.runtime.team.network import Network
    from aseme_dsl.runtime.team.team import RunResult
    from aseme_dsl.runtime.trace.records import Record

TIME = "time"
"""The measure that is how long it took until all agents had finished, in s."""

_BEYOND = 1e100
"""No measure is as large: sums and shares of such numbers would be infinite."""


class StudyError(Exception):
    """The study cannot be made as it was asked for; the text says why."""


@dataclass(frozen=True, slots=True)
class Plan:
    """How each run is played: for how long (ns), in which world, and what is measured.

    The measure is one of these:

    - `time`;
    - an activity, for how often it was done a minute, by all agents together;
    - a Python function `module:name`, called with the world at the end, for the number that it gives.

    A run that broke down is not the better for having ended early: see `_measured`.
    """

    measure: str
    length: int
    world: str | None = None
    activities: Path = Path("activities")
    configuration: Configuration = field(default_factory=lambda: Configuration(Path()))
    network: Network | None = None
    """The simulated network, where it is not the project's."""

    @property
    def words(self) -> str | None:
        """The words of the network that is simulated, if one is."""
        project = self.configuration.run
        network = self.network or (project.network if project is not None else None)
        return str(network) if network is not None else None


@dataclass(frozen=True, slots=True)
class Case:
    """What is played: a variant, with one activity that is quicker than the model says, or none."""

    variant: Variant
    quicker: str | None = None


@dataclass(frozen=True, slots=True)
class Run:
    """How one run went. Times are in ns; `measure` is None where the run has none.

    `at_least`: it had not finished, and the time that is its measure is all that it was given.
    """

    seed: int
    measure: float | None
    at_least: bool
    time: int
    agents: int
    done: Mapping[str, int]
    """How often each activity ended."""
    busy: Mapping[str, int]
    """How long each activity was running, in all agents together."""
    failures: tuple[str, ...] = ()
    """Why agents stopped, each with the agent."""
    faults: tuple[str, ...] = ()
    """What could not be done although the agents went on, each once."""
    without_code: tuple[str, ...] = ()
    """Activities that have neither code nor a `takes`: nothing says how long they lasted."""


@dataclass(frozen=True, slots=True)
class Played:
    """A case and its runs, by seed."""

    case: Case
    runs: tuple[Run, ...]


@dataclass(frozen=True, slots=True)
class _Job:
    package: Path
    seed: int
    plan: Plan


def play_all(
    system: System,
    cases: Sequence[Case],
    seeds: Sequence[int],
    plan: Plan,
    folder: Path,
    choice: Choice,
    *,
    times: float = 2.0,
    crew: int | Cluster,
    told: Callable[[], None] = lambda: None,
) -> tuple[Played, ...]:
    """Play every case with every seed. `folder` is for what is generated; `told` is called after each run.

    Raises:
        ClusterError: the cluster cannot be used.
        StudyError: a run cannot be played, or has no measure of that name.
    """
    jobs = [
        _Job(_generated(system, case, times, folder / str(number), choice), seed, plan)
        for number, case in enumerate(cases)
        for seed in seeds
    ]
    configuration = plan.configuration
    copied = (
        Copied(folder),
        Copied(plan.activities),
        Copied(configuration.folder, (configuration.output or Path(OUTPUT),)),
    )
    runs = iter(spread(_run_job, jobs, crew, copied, told))
    return tuple(Played(case, tuple(next(runs) for _ in seeds)) for case in cases)


def _generated(system: System, case: Case, times: float, folder: Path, choice: Choice) -> Path:
    from aseme_dsl.project.playing.operate import OperateError, generate_version

    made = varied(system, case.variant)
    if case.quicker is not None:
        made = quicker(made, case.quicker, times)
    try:
        return generate_version(made, folder, choice)[0]
    except OperateError as problem:
        raise StudyError(str(problem)) from problem


def _run_job(job: _Job) -> Run:
    return run(job.package, job.seed, job.plan)


class _Clocks:
    """How often activities ended and how long they ran, from the lines of a trace."""

    def __init__(self) -> None:
        self.done: dict[str, int] = {}
        self.busy: dict[str, int] = {}
        self._since: dict[tuple[str, str, int], tuple[str, int]] = {}

    def wants(self, kind: str, what: str | None) -> bool:
        return kind == "activity" and what in ("start", "end", "crash", "cancel")

    def __call__(self, record: Record) -> None:
        if record["kind"] != "activity":
            return
        execution = (record["agent"], record["label"], record["token"])
        name, moment = record["activity"], record["time"]
        if record["what"] == "start":
            self._since[execution] = (name, moment)
            return
        if record["what"] == "end":
            self.done[name] = self.done.get(name, 0) + 1
        started = self._since.pop(execution, None)
        if started is not None:
            self.busy[name] = self.busy.get(name, 0) + moment - started[1]

    def end(self, moment: int) -> None:
        """What runs at the end was busy until then."""
        for name, since in self._since.values():
            self.busy[name] = self.busy.get(name, 0) + moment - since
        self._since.clear()


_MOST_FAULTS = 50
"""How many different faults of a run are kept."""


class _Faults:
    """What the runtime has to complain of, from the lines of a trace."""

    def __init__(self) -> None:
        self.reasons: dict[str, None] = {}
        self.without_code: dict[str, None] = {}

    def wants(self, kind: str, what: str | None) -> bool:
        return kind == "fault"

    def __call__(self, record: Mapping[str, object]) -> None:
        if record["kind"] != "fault":
            return
        if len(self.reasons) < _MOST_FAULTS:
            self.reasons.setdefault(str(record["reason"]))
        if record.get("code") == "W201":
            self.without_code.setdefault(str(record["activity"]))


def run(package: Path, seed: int, plan: Plan) -> Run:
    """Play one run of a generated package. What it leaves in the project's modules is not there for the next.

    Raises:
        StudyError: it cannot be played, or cannot be measured so.
    """
    from aseme_dsl.runtime.version.loading import forgetting

    with forgetting(plan.configuration.folder):
        return _run(package, seed, plan)


def _run(package: Path, seed: int, plan: Plan) -> Run:
    from aseme_dsl.project.playing import play
    from aseme_dsl.project.playing.operate import loaded_for
    from aseme_dsl.runtime.version.loading import LoadError

    configuration = plan.configuration
    project = configuration.run
    if project is not None:  # a study leaves the project's own trace, states and socket alone
        project = replace(project, trace=None, state=None, progress=None, summary=None)
        configuration = replace(configuration, run=project)
    clocks, faults = _Clocks(), _Faults()
    try:
        loaded = loaded_for(package, configuration.folder.resolve())
        request = play.Request(duration=plan.length, seed=seed, world=plan.world, network=plan.network)
        played = play.play(
            loaded,
            plan.activities,
            configuration,
            request,
            tell=lambda line: None,
            listeners=(clocks, faults),
        )
    except (LoadError, play.PlayError) as problem:
        raise StudyError(f"with seed {seed}: {problem}") from problem
    result = played.result
    if result.reason == "interrupted":
        raise KeyboardInterrupt
    clocks.end(result.end_ns)
    if played.world is not None:
        _check_bodies(played.world, [name for name, _ in loaded.team])
    failures = tuple(f"{agent.name}: {agent.failure}" for agent in result.agents if agent.failure)
    measure, at_least = _measured(plan, result, clocks, played.world)
    return Run(
        seed,
        measure,
        at_least,
        result.end_ns,
        len(loaded.team),
        clocks.done,
        clocks.busy,
        failures,
        tuple(faults.reasons),
        tuple(faults.without_code),
    )


def _check_bodies(world: object, agents: Sequence[str]) -> None:
    """A world that is made for a team of one size may have no place for more."""
    bodies = getattr(world, "bodies", {})
    without = [name for name in agents if name not in bodies]
    if bodies and without and len(without) < len(agents):
        raise StudyError(f"the world has no body for {without[0]}: it must make as many as there are agents")


def _measured(plan: Plan, result: RunResult, clocks: _Clocks, world: object) -> tuple[float | None, bool]:
    """The measure of a run, and whether it is only the least that it can be.

    A team that stops because an agent failed, or because it waits for ever, has not been quick: its rates are
    over all the time that it was given. A run that had not finished took at least that time; one in which an
    agent failed has no time at all.
    """
    if plan.measure == TIME:
        if result.failed:
            return None, False
        has_finished = result.reason == "finished"
        return (result.end_ns if has_finished else plan.length) / 1e9, not has_finished
    if ":" not in plan.measure:
        broke_down = result.failed or result.reason == "idle"
        time = max(plan.length, result.end_ns) if broke_down else result.end_ns
        return (clocks.done.get(plan.measure, 0) * 60e9 / time if time else 0.0), False
    return _given(plan, world), False


def _finite(value: object) -> float | None:
    """A number that is neither infinite nor not-a-number; None for anything else."""
    if not isinstance(value, Real | Decimal) or isinstance(value, bool):
        return None
    try:
        number = float(value)
    except (OverflowError, ValueError):
        return None
    return number if abs(number) < _BEYOND else None


def _given(plan: Plan, world: object) -> float | None:
    """What the project's function says of the world at the end."""
    from aseme_dsl.project.playing.play import PlayError, call
    from aseme_dsl.runtime.version.loading import importing

    try:
        with importing([plan.configuration.folder.resolve()]):
            value = call(plan.measure, world)
    except PlayError as problem:
        raise StudyError(str(problem)) from problem
    if value is None:
        return None
    number = _finite(value)
    if number is not None:
        return number
    raise StudyError(f"{plan.measure} gave {value!r}, which is not a number")
