"""Play: generated packages are imported and run, alone or as a team, in a world or without one."""

from __future__ import annotations

import inspect
import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import AbstractContextManager, contextmanager, nullcontext, suppress
from dataclasses import field, fields, replace
from numbers import Integral
from pathlib import Path
from typing import TYPE_CHECKING, Protocol, cast

from aseme_dsl import outside
from aseme_dsl.diagnostics import Diagnostic, Problem, closest
from aseme_dsl.diagnostics.problems import running as problems
from aseme_dsl.diagnostics.problems.running import NotPlayed
from aseme_dsl.project.settings.configuration import Configuration, RunConfiguration
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.time.clock import USUAL_LENGTH
from aseme_dsl.source import Source, Span

if TYPE_CHECKING:
    from collections.abc import Iterator

    from aseme_dsl.project.building.build import Agents, Choice
    from aseme_dsl.project.settings.deployment import Deployment
    from aseme_dsl.runtime.chart.plan import State
    from aseme_dsl.runtime.control.control import Changed
    from aseme_dsl.runtime.control.recent import Recent
    from aseme_dsl.runtime.driver.real_time import RealTime
    from aseme_dsl.runtime.team.network import Network
    from aseme_dsl.runtime.team.team import RunResult, Team
    from aseme_dsl.runtime.team.timed_inputs import TimedInput
    from aseme_dsl.runtime.trace.records import Record
    from aseme_dsl.runtime.trace.trace import Listener
    from aseme_dsl.runtime.transport.port import Transport
    from aseme_dsl.runtime.version.epochs import Epoch, EpochFile
    from aseme_dsl.runtime.version.loading import Loaded, RoleBackends
    from aseme_dsl.runtime.world.body import AnyWorld
    from aseme_dsl.runtime.world.shared_world import FarBody

LOOK_NS = 100_000_000
"""How often the project is asked what there is to tell, in the run's own time."""


class PlayError(Exception):
    """Nothing can be played as it was asked for; `problem` says why."""

    def __init__(self, problem: Problem) -> None:
        super().__init__(problem.message)
        self.problem = problem

    def problems(self, path: str) -> tuple[Diagnostic, ...]:
        """The same as diagnostics; `path` is what was to be played."""
        return (Diagnostic(self.problem, None, path=path),)


class NoSuchPlan(PlayError):
    """The plan or robot that was asked for is not there, or is not the only one of that name."""


class NoSuchAgent(PlayError):
    """Something is for an agent that there is not."""


class WrongInput(PlayError):
    """Lines of an input mean nothing."""

    def __init__(self, found: tuple[Diagnostic, ...]) -> None:
        super().__init__(NotPlayed("\n".join(item.message for item in found)))
        self._found = found

    def problems(self, path: str) -> tuple[Diagnostic, ...]:
        """What is wrong, each with its line."""
        return self._found


@dataclass(frozen=True, slots=True)
class Request:
    """How to play; what is None is as the project says, or as usual.

    `plan` runs one plan (`player`, or `Kouretes.player`) instead of the team, as an agent called `agent` (or
    as the first of the team that has this role). `world` and the values of `bodies` are Python functions,
    `module:name`; a body's is called with `name=…` and is for the agent that is its key, or for all ("").
    Times are in ns.
    """

    plan: str | None = None
    agent: str | None = None
    duration: int | None = None
    seed: int | None = None
    real: bool = False
    script: Path | None = None
    trace: Path | None = None
    world: str | None = None
    bodies: Mapping[str, str] = field(default_factory=dict)
    robot: str | None = None
    """Play this one of the team, in real time; the others are in other processes."""
    world_at: tuple[str, bytes] | None = None
    """Where a world in another process has the robot's body: its address, and the key to it."""
    begin: Callable[[], int | None] = lambda: None
    """Called when everything is there; gives the moment at which the run has begun, if it is not now (ns of
    the machine's monotonic clock)."""
    serve: Callable[[Team, Recent], AbstractContextManager[None]] = lambda team, recent: nullcontext()
    """What is open while a robot runs: for the machine that it runs on. May raise PlayError."""
    epoch: Epoch | None = None
    """The epoch that a robot follows at first, if it follows those of its team."""
    changed: Callable[[Changed], None] | None = None
    """Told of each swap of a robot that is done."""
    state: Path | None = None
    """Where `persist` states are kept from one run to the next."""
    platform: str | None = None
    """What carries messages between agents in real time (`platforms.PLATFORMS`)."""
    network: Network | None = None
    """How bad the links between agents are, in virtual time."""


@dataclass(frozen=True, slots=True)
class Played:
    """A run and what was said at its end."""

    result: RunResult
    summary: str
    seed: int
    trace: Path | None
    world: object = None
    """The world as it was left, if there was one here."""
    network: Network | None = None
    """The network that was simulated."""


Tell = Callable[[str], None]


class Watching(Protocol):
    """What watches a run, and may end it."""

    def begin(self, team: Team) -> None:
        """The run of the team begins."""

    def __call__(self, record: Record) -> None:
        """A line of its trace."""

    def settled(self, team: Team) -> str | None:
        """Nothing is left to do at this instant; why the run ends, if it does."""


def carried(folder: Path, configuration: Configuration, choice: Choice) -> tuple[Loaded, ...]:
    """Every system whose generated package is in a build's output folder: what a robot carries.

    Raises:
        PlayError: there is none, or one cannot be imported.
    """
    systems = _systems(folder)
    if not systems:
        raise PlayError(problems.NothingGenerated(str(folder)))
    return tuple(load(folder, name, configuration, choice) for name in systems)


def is_output(folder: Path) -> bool:
    """Whether a folder is the output of a build rather than a folder with sources."""
    return bool(_systems(folder)) and not any(folder.glob("*.aseme"))


def _systems(folder: Path) -> list[str]:
    """The systems of whose agents something is generated in an output folder."""
    from aseme_dsl.backends.backend import AGENTS

    found = [path.parent for backend in AGENTS for path in (folder / backend).glob("*/messages.py")]
    return sorted({path.name for path in found if (path / "__init__.py").is_file()})


def load(folder: Path, system: str, configuration: Configuration, choice: Choice) -> Loaded:
    """Import what a build into `folder` has generated; functions are looked for in the project, too.

    The agents are those of the backends that are chosen; where the usual one has generated nothing, those of
    another that has.

    Raises:
        PlayError: it is not there, or cannot be imported.
    """
    from aseme_dsl.backends.backend import AGENTS
    from aseme_dsl.runtime.version.loading import LoadError, load_system

    usual = choice.agents.usual
    there = [name for name in (usual, *AGENTS) if (folder / name / system / "__init__.py").is_file()]
    package = folder / (there or [usual])[0] / system
    try:
        return load_system(
            package, path=[configuration.folder.resolve()], mixture=mixture_of(choice.agents, package)
        )
    except LoadError as problem:
        raise PlayError(NotPlayed(str(problem))) from problem


def mixture_of(agents: Agents, package: Path) -> RoleBackends:
    """From which packages the agents are taken whose package is not this one; the roles are its system's."""
    from aseme_dsl.backends.backend import AGENTS
    from aseme_dsl.runtime.version.loading import RoleBackends

    return RoleBackends(
        {role: name for role, name in agents.roles.items() if name != package.parent.name}, AGENTS
    )


def in_version(loaded: Loaded, name: str, configuration: Configuration) -> Loaded:
    """The same system with the charts and messages of another version of it, named by its hash.

    Raises:
        PlayError: it is not there, cannot be imported, or lacks a plan of the team.
    """
    from aseme_dsl.project.playing.operable import output_of
    from aseme_dsl.runtime.version.loading import LoadError, load_system, package_like
    from aseme_dsl.runtime.version.versions import VERSIONS, VersionError, read_version

    assert loaded.folder is not None
    try:
        code = read_version(output_of(loaded) / VERSIONS, name)
        package = package_like(code, loaded.name, loaded.folder)
        project = [configuration.folder.resolve()]
        found = load_system(package, path=project, mixture=loaded.mixture, code=code)
    except (LoadError, VersionError) as problem:
        raise PlayError(NotPlayed(str(problem))) from problem
    missing = [role for _, role in loaded.team if role not in found.charts]
    if missing:
        raise PlayError(problems.VersionWithoutPlan(str(package), missing[0]))
    return replace(found, name=loaded.name, team=loaded.team, folder=loaded.folder)


def epoch_file(loaded: Loaded, robot: str) -> EpochFile:
    """Where a robot keeps its epoch."""
    from aseme_dsl.project.playing.operable import output_of
    from aseme_dsl.runtime.version.epochs import EpochFile
    from aseme_dsl.runtime.version.versions import VERSIONS

    return EpochFile(output_of(loaded) / VERSIONS, robot)


def in_epoch(
    loaded: Loaded, robot: str, configuration: Configuration, version: str | None, *, fresh: bool
) -> tuple[Loaded, Epoch]:
    """The system in the version that a robot follows, and its epoch: a `fresh` run begins with the build.

    A `version` that is named comes before that of the epoch.

    Raises:
        PlayError: the epoch that is kept, or its version, cannot be used.
    """
    from aseme_dsl.runtime.version.epochs import Epoch, EpochError

    check_robot(loaded, robot)
    kept = epoch_file(loaded, robot)
    epoch = Epoch(base=loaded.model)
    try:
        if fresh:
            kept.forget()
        else:
            epoch = kept.read(loaded.model)
    except EpochError as problem:
        raise PlayError(NotPlayed(str(problem))) from problem
    except OSError as problem:
        raise PlayError(_not_written(kept.path, problem)) from problem
    name = version or epoch.hash
    return (in_version(loaded, name, configuration) if name else loaded), epoch


def select(systems: Sequence[Loaded], plan: str | None) -> tuple[Loaded, str | None]:
    """The system that has a plan (`player`, or `Kouretes.player`), and the plan's own name.

    Raises:
        NoSuchPlan: none has it, or several have; or without `plan` there are several systems.
    """
    known = {f"{item.name}.{name}": item for item in systems for name in item.charts}
    if plan is None:
        if len(systems) > 1:
            raise NoSuchPlan(problems.SystemNotChosen(tuple(known)))
        return systems[0], None
    found = [name for name in known if plan in (name, name.partition(".")[2])]
    if len(found) != 1:
        if found:
            raise NoSuchPlan(problems.SeveralPlans(plan, None, tuple(found)))
        near = closest(plan, [*known, *(name.partition(".")[2] for name in known)])
        raise NoSuchPlan(problems.NoSuchPlan(plan, near, tuple(known)))
    return known[found[0]], found[0].partition(".")[2]


def play(
    loaded: Loaded,
    activities: Path,
    configuration: Configuration,
    request: Request,
    *,
    tell: Tell,
    listeners: Iterable[Listener] = (),
    tick: Callable[[int], None] | None = None,
    watch: Watching | None = None,
) -> Played:
    """Run a system's team, or one plan, to the end.

    `tell` is given each line of the project's `progress`. `tick` is given the time, at every instant at which
    nothing is left to do. `listeners` are given every line of the trace, and so is `watch`.

    Raises:
        PlayError: it cannot be run like that; or the project's own functions fail.
    """
    from aseme_dsl.project.settings.platform_settings import IN_PROCESS
    from aseme_dsl.project.settings.platforms import PlatformError, check_installed, provided
    from aseme_dsl.runtime.transport import TransportError

    if request.robot is not None:
        seed = _seed(request, configuration)
        return _play_robot(loaded, activities, configuration, request, request.robot, seed, listeners, watch)
    platform = request.platform or IN_PROCESS
    try:
        check_installed(platform)
        with provided(platform, loaded, configuration, tell):
            return _play_here(
                loaded,
                activities,
                configuration,
                request,
                tell=tell,
                listeners=listeners,
                tick=tick,
                watching=watch,
            )
    except (TransportError, PlatformError) as problem:
        raise PlayError(NotPlayed(str(problem))) from problem


def _seed(request: Request, configuration: Configuration) -> int:
    return configuration.seed if request.seed is None else request.seed


def _network(request: Request, configuration: Configuration) -> Network | None:
    """The network that is simulated, if one is."""
    project = configuration.run
    said = request.network or (project.network if project is not None else None)
    return None if request.real or request.plan is not None else said


def _play_here(
    loaded: Loaded,
    activities: Path,
    configuration: Configuration,
    request: Request,
    *,
    tell: Tell,
    listeners: Iterable[Listener],
    tick: Callable[[int], None] | None,
    watching: Watching | None,
) -> Played:
    """Run a system's team, or one plan, in this process."""
    from aseme_dsl.project.playing.operable import operable, others
    from aseme_dsl.runtime.activity.activities import ActivityError
    from aseme_dsl.runtime.control.recent import Recent
    from aseme_dsl.runtime.team.team import TeamError, make_team
    from aseme_dsl.runtime.version.loading import activities_in, importing

    project = configuration.run
    seed = _seed(request, configuration)
    network = _network(request, configuration)
    folders = [configuration.folder.resolve(), *loaded.path]
    recent = Recent()
    agent = request.agent
    if request.plan is not None and agent is None:
        agent = next((name for name, role in loaded.team if role == request.plan), None)
    with importing(folders):
        made_by = request.world or (project.world if project and not request.bodies else None)
        world = made_world(made_by, seed) if made_by else None
        bodies = _bodies(request.bodies, loaded, request.plan, agent)
        watch = _Watch(
            world, project.progress if project and world is not None else None, tell, tick, watching
        )
        script = _script(request.script, loaded)
        trace = request.trace or (project.trace if project and project.trace else None)
        try:
            if trace is not None:
                trace.parent.mkdir(parents=True, exist_ok=True)
            team = make_team(
                loaded,
                activities_in(activities),
                plan=request.plan,
                agent=agent,
                clock="real" if request.real else "virtual",
                seed=seed,
                world=world,
                bodies=bodies,
                until_ns=_duration(request, configuration, world),
                stop=watch,
                timed_inputs=script,
                trace=trace,
                before=None if watching is None else watching.begin,
                listeners=(
                    *listeners,
                    *(() if watching is None else (watching,)),
                    *((recent,) if request.real else ()),
                ),
                path=folders,
                real_time=_real_time(project),
                carried=lambda: others(loaded, activities, configuration),
                state_directory=_state(request, project),
                faults=network.faults(seed) if network is not None else None,
                transport=_whole_team_over(request, loaded, configuration),
            )
        except (TeamError, ActivityError) as problem:
            raise PlayError(NotPlayed(str(problem))) from problem
        except OSError as problem:
            place = problem.filename or trace
            raise PlayError(_not_written(place, problem)) from problem
        with operable(team, loaded, activities, recent=recent) if request.real else nullcontext():
            try:
                with users_mistakes(*([loaded.folder] if loaded.folder else [])):
                    result = team.run()
            except TeamError as problem:  # the platform cannot be used, or the world stands still
                raise PlayError(NotPlayed(str(problem))) from problem
        watch.look(team)
        summary = ""
        if project and project.summary and world is not None:
            summary = str(call(project.summary, world))
    return Played(result, summary, seed, trace, world, network)


def _whole_team_over(request: Request, loaded: Loaded, configuration: Configuration) -> Transport:
    """The transport of a team in this process; external agents may exchange messages with it."""
    from aseme_dsl.project.settings.platform_settings import IN_PROCESS
    from aseme_dsl.runtime.transport.port import LOCAL

    if request.platform in (None, IN_PROCESS):
        return LOCAL
    return _transport(str(request.platform), loaded, configuration, [name for name, _ in loaded.team])


def _transport(
    platform: str, loaded: Loaded, configuration: Configuration, agents: Sequence[str]
) -> Transport:
    """The transport of these agents over a platform. Raises PlatformError and TransportError."""
    from aseme_dsl.project.settings.platforms import link_of
    from aseme_dsl.runtime.transport.reliable_delivery import Post

    assert loaded.schema is not None  # every generated package has one
    plans = [chart.PLAN for chart in loaded.charts.values()]
    return Post(link_of(platform, loaded, configuration, agents), loaded.schema, loaded.model, plans)


def _play_robot(
    loaded: Loaded,
    activities: Path,
    configuration: Configuration,
    request: Request,
    robot: str,
    seed: int,
    listeners: Iterable[Listener],
    watching: Watching | None,
) -> Played:
    """Run one robot of the team in this process."""
    from aseme_dsl.project.playing.operable import operable, others
    from aseme_dsl.project.settings.deployment import misfits
    from aseme_dsl.project.settings.platform_settings import ZENOH
    from aseme_dsl.project.settings.platforms import PlatformError
    from aseme_dsl.runtime.activity.activities import ActivityError
    from aseme_dsl.runtime.control.recent import Recent
    from aseme_dsl.runtime.team.team import TeamError, make_team
    from aseme_dsl.runtime.transport import TransportError
    from aseme_dsl.runtime.version.loading import activities_in, activities_of, importing
    from aseme_dsl.runtime.world.body import BodyConnectionError
    from aseme_dsl.runtime.world.shared_world import FarBody

    check_robot(loaded, robot)
    deployment = configuration.deploy
    names = [name for name, _ in loaded.team]
    for misfit in misfits(deployment, names, str(configuration.path)) if deployment else ():
        raise PlayError(misfit)
    keys = _keys_of(robot, request.platform or ZENOH, deployment)
    project = configuration.run
    folders = [configuration.folder.resolve(), *loaded.path]
    trace = request.trace
    recent = Recent()
    body: FarBody | None = None
    with importing(folders):
        bodies = _bodies(request.bodies, loaded, None, None, only=robot)
        if request.world_at is not None:
            try:
                body = bodies[robot] = FarBody(robot, *request.world_at)
            except BodyConnectionError as problem:
                raise PlayError(NotPlayed(str(problem))) from problem
        elif project and project.world and not bodies:
            raise PlayError(problems.WorldInOnePlace())
        script = _script(request.script, loaded)
        try:
            if trace is not None:
                trace.parent.mkdir(parents=True, exist_ok=True)
            found = activities_in(activities) if loaded.code is None else activities_of(loaded.code)
            team = make_team(
                loaded,
                found,
                clock="real",
                seed=seed,
                bodies=bodies,
                until_ns=request.duration or (project.duration if project and body is not None else None),
                stop=_first_of(
                    _Reports(body) if body is not None and project and project.progress else None,
                    None if watching is None else watching.settled,
                ),
                timed_inputs=script,
                trace=trace,
                before=None if watching is None else watching.begin,
                listeners=(*listeners, recent, *(() if watching is None else (watching,))),
                path=folders,
                here=[robot],
                transport=_transport(request.platform or ZENOH, loaded, configuration, [robot]),
                origin=request.begin(),
                real_time=_real_time(project),
                carried=lambda: others(loaded, activities, configuration),
                state_directory=_state(request, project),
            )
            with (
                operable(
                    team,
                    loaded,
                    activities,
                    request.changed,
                    keys,
                    recent,
                    epoch_file(loaded, robot),
                    request.epoch,
                    deployment is not None and deployment.tls is not None,
                ),
                request.serve(team, recent),
            ):
                result = team.run()
        except (TeamError, ActivityError, TransportError, PlatformError) as problem:
            raise PlayError(NotPlayed(str(problem))) from problem
        except OSError as problem:
            place = problem.filename or trace
            raise PlayError(_not_written(place, problem)) from problem
        finally:
            if body is not None:
                body.close()
    return Played(result, "", seed, trace)


def _keys_of(robot: str, platform: str, deployment: Deployment | None) -> Path | None:
    """The file of the keys by which operators control a robot over the network; None: they cannot.

    Raises:
        PlayError: it cannot be used.
    """
    from aseme_dsl.project.settings.deployment import keys_of
    from aseme_dsl.project.settings.platform_settings import ZENOH
    from aseme_dsl.runtime.control.operator_key import KeyFileError, read_keys

    keys = keys_of(deployment, robot)
    if keys is None:
        return None
    if platform != ZENOH:
        raise PlayError(problems.ControlWithoutZenoh(platform))
    try:
        read_keys(keys)
    except KeyFileError as problem:
        raise PlayError(problems.KeysNotRead(str(problem))) from problem
    return keys


def check_robot(loaded: Loaded, robot: str) -> None:
    """Raises NoSuchPlan if the team has no robot of that name."""
    names = [name for name, _ in loaded.team]
    if robot not in names:
        if not names:
            raise NoSuchPlan(problems.NoTeamForRobot(loaded.name, robot))
        raise NoSuchPlan(problems.NoSuchRobot(robot, closest(robot, names), tuple(names)))


def _first_of(*asked: Callable[[Team], str | None] | None) -> Callable[[Team], str | None] | None:
    """What asks all of these, and gives the first reason; None if there is none to ask."""
    calls = [call for call in asked if call is not None]
    return (lambda team: next(filter(None, [call(team) for call in calls]), None)) if calls else None


class _Reports:
    """Tells a world elsewhere what the robot is doing; the world shows it. Never ends the run."""

    def __init__(self, body: FarBody) -> None:
        self._body = body
        self._next = 0

    def __call__(self, team: Team) -> str | None:
        now = team.driver.clock.now()
        if now >= self._next:
            self._next = now + LOOK_NS
            with suppress(ConnectionError):  # the robot's activities will find out
                self._body.tell(doing(team)[self._body.name])
        return None


def _script(path: Path | None, loaded: Loaded) -> tuple[TimedInput, ...]:
    """What a script gives the agents."""
    from aseme_dsl.runtime.team.timed_inputs import InputFileError, read_inputs

    if path is None:
        return ()
    try:
        text = outside.read_text(path)
        return read_inputs(text.splitlines(), loaded.messages)
    except OSError as problem:
        reason = problem.strerror or str(problem)
        raise PlayError(problems.ScriptNotRead(str(path), reason)) from problem
    except UnicodeDecodeError as problem:
        raise PlayError(problems.ScriptNotUtf8(str(path))) from problem
    except InputFileError as problem:
        source = Source(str(path), "\n".join(text.splitlines()))
        raise WrongInput(
            tuple(
                Diagnostic(problems.WrongLine(said), _line_of(source, number))
                for number, said in problem.lines.items()
            )
        ) from problem


def _line_of(source: Source, number: int) -> Span:
    """What is written in a line."""
    line = source.line(number)
    start = source.line_start(number)
    return Span(source, start + len(line) - len(line.lstrip()), start + len(line.rstrip()))


def _duration(request: Request, configuration: Configuration, world: object) -> int | None:
    if request.duration is not None:
        return request.duration
    if configuration.run is not None and configuration.run.duration is not None:
        return configuration.run.duration
    # On a robot the end is Ctrl-C; virtual time would never end.
    return None if request.real and world is None else USUAL_LENGTH


def _state(request: Request, project: RunConfiguration | None) -> Path | None:
    """Where `persist` states are kept."""
    return request.state or (project.state if project is not None else None)


def _real_time(project: RunConfiguration | None) -> RealTime:
    """What the project asks of the machine; the usual where it says nothing."""
    from aseme_dsl.runtime.driver.real_time import RealTime

    said = {field.name: getattr(project, field.name, None) for field in fields(RealTime)}
    return RealTime(**{name: value for name, value in said.items() if value is not None})


class _Watch:
    """What is asked at every instant: it tells what is new, and ends the run when the world is over."""

    def __init__(
        self,
        world: object,
        progress: str | None,
        tell: Tell,
        tick: Callable[[int], None] | None,
        watching: Watching | None,
    ) -> None:
        self._world = world
        self._watching = watching
        self._progress = Progress(world, progress, tell)
        self._tick = tick
        self._next = 0

    def __call__(self, team: Team) -> str | None:
        now = team.driver.clock.now()
        if self._tick is not None:
            self._tick(now)
        if now >= self._next:
            self._next = now + LOOK_NS
            self.look(team)
        ended = self._watching.settled(team) if self._watching is not None else None
        if ended is not None:
            return ended
        return "the world is over" if getattr(self._world, "over", False) is True else None

    def look(self, team: Team) -> None:
        """Tell what is new."""
        self._progress.look(lambda: doing(team))


class Progress:
    """The lines that a project prints of its world during a run."""

    def __init__(self, world: object, progress: str | None, tell: Tell) -> None:
        """`progress` is the project's function. Raises PlayError if there is none of that name."""
        self._world = world
        self._progress = function_of(progress) if progress else None
        self._wants_doing = self._progress is not None and _takes_two(self._progress)
        self._tell = tell
        self._told = 0

    def look(self, doing: Callable[[], Mapping[str, object]]) -> None:
        """Tell what is new; `doing` gives what each agent is doing. Raises PlayError if the project fails."""
        if self._progress is not None:
            further = (doing(),) if self._wants_doing else ()
            with _users_own(self._progress):
                lines = list(_lines_of(self._progress(self._world, *further)))
            for line in lines[self._told :]:
                self._tell(str(line))
            self._told = max(self._told, len(lines))


def _lines_of(told: object) -> Iterable[object]:
    if not isinstance(told, Iterable):
        raise TypeError(f"{type(told).__name__!r} object is not iterable")
    return told


def doing(team: Team) -> dict[str, tuple[tuple[str, ...], ...]]:
    """The active states of each agent, region by region in document order, by name.

    Of each region these are the names of the states that are active in one another. The first is the role's,
    the last the activity's, or that of the innermost state that has a name of its own.
    """
    return {
        agent.name: tuple(_names(agent.plan.by_label, label) for label in agent.chart.configuration())
        for agent in team.agents
    }


def _names(states: Mapping[str, State], label: str) -> tuple[str, ...]:
    parts = label.split(".")
    around = [".".join(parts[:end]) for end in range(1, len(parts) + 1)]
    return tuple(states[item].name for item in around if states[item].name != item)


def _takes_two(function: Callable[..., object]) -> bool:
    try:
        parameters = inspect.signature(function).parameters.values()
    except (TypeError, ValueError):  # written in C
        return False
    kinds = (inspect.Parameter.POSITIONAL_ONLY, inspect.Parameter.POSITIONAL_OR_KEYWORD)
    return sum(parameter.kind in kinds for parameter in parameters) > 1


def _bodies(
    given: Mapping[str, str], loaded: Loaded, plan: str | None, agent: str | None, only: str | None = None
) -> dict[str, object]:
    """A body for each agent, or for `only` one, by name."""
    if not given:
        return {}
    names = [name for name, _ in loaded.team] if plan is None else []
    names = names or [agent or plan or next(iter(loaded.charts))]
    strangers = [name for name in given if name and name not in names]
    if strangers:
        stranger = strangers[0]
        raise NoSuchAgent(problems.NoAgentForBody(stranger, closest(stranger, names), tuple(names)))
    return {
        name: call(function, name=name)
        for name in names
        if only in (None, name) and (function := given.get(name) or given.get("")) is not None
    }


def function_of(name: str) -> Callable[..., object]:
    """A function of the project, `module:name`. Raises PlayError if it cannot be had."""
    from aseme_dsl.runtime.chart.functions import FunctionError, find_function

    try:
        return find_function(name)
    except FunctionError as problem:
        raise PlayError(NotPlayed(str(problem))) from problem
    except Exception as error:  # its module raises when it is imported
        module = name.partition(":")[0]
        raise PlayError(problems.ModuleNotImported(module, _said(error))) from error


def call(target: str, *arguments: object, **named: object) -> object:
    """Call a function of the project, `module:name`. Raises PlayError, with the place, if it raises."""
    function = function_of(target)
    with _users_own(function):
        return function(*arguments, **named)


def made_world(target: str, seed: int, **further: object) -> AnyWorld:
    """The world that a function of the project makes. Raises PlayError if it fails, or makes no world."""
    world = call(target, seed=seed, **further)
    function = function_of(target)
    missing: list[tuple[str, str]] = []
    for name, what, fits in _WORLD:
        with _users_own(function):  # a property of its own may raise, too
            try:
                is_there = fits(getattr(world, name))
            except AttributeError:
                is_there = False
        if not is_there:
            missing.append((name, what))
    if missing:
        raise PlayError(problems.NoWorld(target, _short(world), tuple(missing)))
    return cast("AnyWorld", world)


def _said(error: Exception) -> str:
    return f"{type(error).__name__}: {error}"


def _not_written(place: object, problem: OSError) -> Problem:
    return problems.FileNotWritten(str(place), problem.strerror or str(problem))


def _short(value: object) -> str:
    text = repr(value)
    return text if len(text) <= 60 else f"a {type(value).__name__}"


def _is_time(value: object) -> bool:
    return isinstance(value, Integral)


def _is_duration(value: object) -> bool:
    return isinstance(value, Integral) and int(value) > 0


def _takes_one(function: object) -> bool:
    if not callable(function):
        return False
    try:
        inspect.signature(function).bind(0)
    except TypeError:
        return False
    except ValueError:  # written in C
        return True
    return True


_WORLD: tuple[tuple[str, str, Callable[[object], bool]], ...] = (
    ("bodies", "the bodies by the names of the agents", lambda bodies: isinstance(bodies, Mapping)),
    ("step_ns", "how long one step of it lasts, in whole ns", _is_duration),
    ("now_ns", "how far it has been simulated, in whole ns", _is_time),
    ("advance", "a method that is given the time up to which to simulate, in ns", _takes_one),
)
"""What a world has: the name, what it is, and whether something is that."""


@contextmanager
def users_mistakes(*generated: Path) -> Iterator[None]:
    """What the code of the project raises while agents play (a world, a body) is said with its place.

    It is not the project's mistake if it is raised by us, or by code that was `generated`.
    """
    import sysconfig
    import traceback

    try:
        yield
    except Exception as error:
        libraries = tuple(sysconfig.get_path(name) for name in ("stdlib", "platstdlib", "purelib", "platlib"))
        ours = tuple(str(path.resolve()) for path in (Path(__file__).parents[2], *generated))
        for place in reversed(traceback.extract_tb(error.__traceback__)):
            if os.path.realpath(place.filename).startswith(ours):
                raise
            if not place.filename.startswith((*libraries, "<")):
                where = f"{place.filename}:{place.lineno}"
                raise PlayError(problems.FunctionFailed(place.name, _said(error), where)) from error
        raise


@contextmanager
def _users_own(function: Callable[..., object]) -> Iterator[None]:
    """A function of the project that raises: said with the place in the project's code."""
    import traceback

    try:
        yield
    except PlayError:
        raise
    except Exception as error:
        place = traceback.extract_tb(error.__traceback__)[-1]
        name = getattr(function, "__name__", str(function))
        where = f"{place.filename}:{place.lineno}"
        raise PlayError(problems.FunctionFailed(name, _said(error), where)) from error
