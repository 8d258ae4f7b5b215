"""Teams: agents on one bus, run in virtual or real time until something ends the run."""

from __future__ import annotations

import signal
import threading
from collections.abc import Callable, Container, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import field
from functools import partial
from pathlib import Path
from types import FrameType
from typing import cast

from aseme_dsl.display import Displayed
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.activity.activities import ActivityFinder, Executable
from aseme_dsl.runtime.agent.agent import Agent
from aseme_dsl.runtime.channel.bus import Bus
from aseme_dsl.runtime.chart.board import QUEUE
from aseme_dsl.runtime.chart.chart import Chart
from aseme_dsl.runtime.chart.plan import Plan
from aseme_dsl.runtime.conversation.conversation import Conversations
from aseme_dsl.runtime.driver.real import RealDriver
from aseme_dsl.runtime.driver.real_time import RealTime
from aseme_dsl.runtime.driver.virtual import VirtualDriver
from aseme_dsl.runtime.message.as_json import to_json
from aseme_dsl.runtime.message.by_name import made
from aseme_dsl.runtime.message.wire import Schema
from aseme_dsl.runtime.team.ending import (
    NOTHING,
    OpenConversation,
    Unread,
    Waiting,
    is_stuck,
    picture,
    waits_of,
)
from aseme_dsl.runtime.team.faults import Faults, Links
from aseme_dsl.runtime.team.network import words_of
from aseme_dsl.runtime.team.outside import Need
from aseme_dsl.runtime.team.radio import Radio
from aseme_dsl.runtime.team.role_switches import RoleSwitches
from aseme_dsl.runtime.team.swap import WITHIN, Swap, Version, WaitingSwaps, activity_errors, version_of
from aseme_dsl.runtime.team.timed_inputs import TimedInput
from aseme_dsl.runtime.time.clock import USUAL_LENGTH
from aseme_dsl.runtime.trace.fault_counts import FaultCount
from aseme_dsl.runtime.trace.trace import Listener, Trace
from aseme_dsl.runtime.trace.trace_files import TraceError
from aseme_dsl.runtime.transport import LOCAL, Peer, Transport, TransportError
from aseme_dsl.runtime.version.loading import Loaded, importing, other_names
from aseme_dsl.runtime.world.body import AnyBody, AnyWorld


class TeamError(Exception):
    """A team cannot run as it is asked to; the text says why."""


@dataclass(frozen=True, slots=True)
class AgentResult:
    """How an agent ended. `failure` is the reason why it stopped by itself, `at` its place in the source."""

    name: str
    role: str
    finished: bool
    failure: str | None
    at: str
    configuration: tuple[str, ...]
    steps: int
    waits: tuple[Waiting, ...] = ()
    """What it waited for when the run ended; nothing if it had ended before."""
    stuck: bool = False
    """Whether nothing pending could have woken it, though it does not wait for a conversation to begin."""
    idle: bool = False
    """Whether an input from outside could have woken it, or an agent that it waits for."""


@dataclass(frozen=True, slots=True)
class RunResult(Displayed):
    """How a run ended.

    `reason` is "finished" (all agents have ended), "time" (the duration is over), "idle" (nothing would ever
    happen any more), "interrupted", or what the stop condition said. In real time it is "terminated" after
    SIGTERM.
    `trace_error` says why a trace ended before the run. `conversations` were open at the end, `unread` are
    the agent messages that waited then, `faults` those of the whole run by reason and place.
    """

    reason: str
    end_ns: int
    agents: tuple[AgentResult, ...]
    trace_error: str | None = None
    left: tuple[str, ...] = ()
    """What of the activities still runs, in spite of its cancellation: it ends with this process."""
    idle_since: int | None = None
    """The moment (ns) from which on nothing was pending: no input, timer or activity. None if something was,
    with the real clock and in a world."""
    conversations: tuple[OpenConversation, ...] = ()
    unread: tuple[Unread, ...] = ()
    faults: tuple[FaultCount, ...] = ()

    @property
    def failed(self) -> bool:
        """Whether an agent has stopped by itself without having finished."""
        return any(agent.failure is not None for agent in self.agents)

    @property
    def stuck(self) -> tuple[str, ...]:
        """The agents that wait for ever: see `AgentResult.stuck`."""
        return tuple(agent.name for agent in self.agents if agent.stuck)


@dataclass(frozen=True, slots=True, kw_only=True)
class Setup:
    """How a team is to run; by itself in virtual time, in one process, until all agents have ended."""

    system: str = ""
    """Its name; without it, the one that the first agent's plan says."""
    messages: Mapping[str, type[object]] = field(default_factory=dict)
    """The message classes by name, which scripts and kept states need."""
    schema: Schema | None = None
    """How messages become bytes, which radio needs."""
    clock: str = "virtual"
    seed: int = 1
    world: AnyWorld | None = None
    bodies: Mapping[str, AnyBody] = field(default_factory=dict)
    """The agents' bodies where there is no world."""
    until_ns: int | None = None
    """When the run ends."""
    least_ns: int = 0
    """Before this moment it does not end because all agents have ended."""
    stop: Callable[[Team], str | None] | None = None
    """Asked at every instant at which nothing is left to do; the reason that it gives ends the run."""
    timed_inputs: Iterable[TimedInput] = ()
    before: Callable[[Team], None] | None = None
    """Called when all is ready and no agent has begun: what it gives them is part of their first step."""
    trace: Path | None = None
    listeners: Iterable[Listener] = ()
    state_directory: Path | None = None
    path: Sequence[Path] = ()
    """Folders with modules that activities and functions import."""
    here: Iterable[str] | None = None
    """The agents that run in this process, if not all do; `transport` carries messages to the others."""
    transport: Transport = LOCAL
    origin: int | None = None
    """When the run began, in ns of the machine's monotonic clock, where it is older than this process."""
    real_time: RealTime | None = None
    """What a run with the real clock asks of the machine."""
    version: Version | None = None
    """The system that the agents are of, with all its plans."""
    carried: Callable[[], Sequence[Version]] = tuple
    """What the robots carry besides; called when a plan of another system is wanted."""
    faults: Faults | None = None
    """What goes wrong between the agents in virtual time."""


class Team:
    """A team that is about to run, and runs once."""

    def __init__(
        self,
        agents: Iterable[tuple[str, type[Chart]]],
        activities: ActivityFinder | Mapping[str, type[Executable]],
        setup: Setup = Setup(),
    ) -> None:
        """Put the agents, given with their charts in the team's order, on a bus.

        Raises:
            TeamError: two agents of one name, no agents, an activity whose code cannot be loaded, a world
            that would never end, inputs for an unknown agent or channel. Also agents elsewhere without a
            transport, or in virtual time. OSError: the trace cannot be written.
        """
        members = list(agents)
        names = [name for name, _ in members]
        here = _here(names, setup)
        self.seed = setup.seed
        self.world = setup.world
        self.system = setup.system or members[0][1].PLAN.system
        self._path = tuple(setup.path)
        self._until = setup.until_ns
        self._least = setup.least_ns
        self._stop = setup.stop
        self._before = setup.before
        self._has_run = False
        self.at_end: list[Callable[[], None]] = []
        """Called before the last line of the trace is written."""
        self._open = NOTHING
        self._messages = dict(setup.messages)
        find: ActivityFinder = activities if callable(activities) else dict(activities).get
        plans = {chart.PLAN.name: chart for _, chart in members}
        self.version = setup.version or Version(self.system, plans, find, self._messages, setup.schema)
        self._switches = RoleSwitches(self, setup.carried)
        self._swaps = WaitingSwaps(self)
        with importing(self._path):
            charts = {chart.PLAN.name: chart for name, chart in members if name in here}
            _check_activities(charts.values(), find)
        self._script = _checked(tuple(setup.timed_inputs), members)
        bodies = setup.world.bodies if setup.world is not None else setup.bodies
        mine = [(name, chart) for name, chart in members if name in here]
        with_radio = _with_radio(mine, bodies, setup.schema)
        try:
            self.trace = Trace(setup.trace, setup.listeners, background=setup.clock == "real")
        except TraceError as problem:
            raise TeamError(str(problem)) from problem
        self.driver = self._driver(setup)
        self.trace.now = self.driver.clock.now
        self.transport = setup.transport
        limits = setup.real_time or RealTime()
        self._queue = limits.queue
        self.bus = Bus(self.driver, self.trace, setup.state_directory, setup.transport, limits.queue)
        self.conversations = Conversations(
            self.driver, self.trace, setup.transport, limits.queue, self.system, limits.conversation_limit
        )
        self.elsewhere: dict[str, Plan] = {name: chart.PLAN for name, chart in members if name not in here}
        """The plans of the agents that run in other processes."""
        self.agents: tuple[Agent, ...] = tuple(
            self._agent(name, chart, find, setup, bodies.get(name)) for name, chart in mine
        )
        self._radios: dict[str, Radio] = {}
        self._bring_together(names, with_radio, setup.schema)
        self.driver.bring(self.agents)
        self._faults = setup.faults
        if setup.faults is not None:
            self._make_faulty(setup.faults)

    # ---- making ------------------------------------------------------------------------------

    def _agent(
        self, name: str, chart: type[Chart], find: ActivityFinder, setup: Setup, body: AnyBody | None
    ) -> Agent:
        return Agent(
            name,
            chart(name),
            find,
            self.driver,
            self.bus,
            self.conversations,
            self.trace,
            setup.seed,
            body,
            setup.transport.behind,
            self._queue,
        )

    def _bring_together(
        self, names: Sequence[str], with_radio: Container[str], schema: Schema | None
    ) -> None:
        """Let all agents, in the team's order, join the bus and the conversations."""
        running = {agent.name: agent for agent in self.agents}
        for name in names:
            agent = running.get(name)
            if agent is None:
                self.bus.join_elsewhere(name, self.elsewhere[name])
                self.conversations.join_elsewhere(name, self.elsewhere[name])
                continue
            radio = None
            if schema is not None and name in with_radio:
                radio = self._radios[name] = Radio(agent, self.bus, schema, names)
            self.bus.join(agent, radio)
            self.conversations.join(agent)
            agent.chosen = self._switches.follow
            agent.kinds = self.version.messages

    def _driver(self, setup: Setup) -> VirtualDriver | RealDriver:
        if setup.clock == "virtual":
            driver: VirtualDriver | RealDriver = VirtualDriver()
        else:
            names = other_names(self.version.modules)
            driver = RealDriver(self._path, setup.real_time, setup.origin, names, self.version.code)
            driver.watch = self._stop is not None
        driver.until = self._until
        return driver

    def _make_faulty(self, faults: Faults) -> None:
        if not self.driver.clock.virtual:
            raise TeamError("faults are simulated in virtual time; a real link has its own")
        self.bus.links = self.conversations.links = Links(faults, self.driver, self.trace)
        for crash in faults.crashes:
            agent = self.agent(crash.agent)
            self.driver.at(crash.at, agent.crash)
            self.driver.at(crash.at + crash.down, agent.restart)

    # ---- other plans -------------------------------------------------------------------------

    def swap(
        self, version: Version, *, at: int = 0, within: int = WITHIN, agents: Iterable[str] | None = None
    ) -> Swap:
        """Have the agents (all, or these) change to another version in virtual time. They do so at the moment
        `at`, or within `within` ns from then, as soon as no conversation is in the way.

        Raises:
            LookupError: there is no such agent.
            TeamError: the clock is real; there, a `Swap` is prepared and finished by who asks for it.
        """
        if not self.driver.clock.virtual:
            raise TeamError("in real time a swap is prepared and finished, not scheduled")
        return self._swaps.schedule(Swap(self, version, agents), at, within)

    def select(self, agent: str, plan: str, *, at: int = 0) -> None:
        """Have an agent leave its plan and enter another at a moment of virtual time; the trace tells how
        that went. Raises KeyError for an agent that there is not.
        """
        chosen = self.agent(agent)

        def choose() -> None:
            self.choose(chosen, plan, "operator")

        self.driver.at(max(at, self.driver.clock.now()), choose)

    def choose(self, agent: Agent, plan: str, by: str, *, own: bool = False) -> str | None:
        """Let an agent leave its plan and enter another: see `RoleSwitches.choose`."""
        return self._switches.choose(agent, plan, by, own=own)

    def bind_message_types(self) -> None:
        """From now on agents of several versions may meet: each takes messages as its own plan has them."""
        for agent in self.agents:
            agent.messages = agent.messages or self.version.messages

    def speak(self, version: Version) -> None:
        """What goes to agents elsewhere is of this version from now on."""
        if version.schema is not None:
            plans = tuple(chart.PLAN for chart in version.charts.values())
            self.transport.renew(version.schema, version.model, plans)

    def set_version(self, version: Version) -> None:
        """The whole team, here and elsewhere, is of this version now."""
        same = version.messages.items() == self.version.messages.items() and version.code == self.version.code
        if isinstance(self.driver, RealDriver) and not same:
            self.driver.renew(version.path, other_names(version.modules), version.code)
        self.version = version
        for name, plan in self.elsewhere.items():
            if plan.name in version.charts:
                self.elsewhere[name] = version.charts[plan.name].PLAN
        self.bus.renew(self.elsewhere)
        self.conversations.renew(self.elsewhere)

    def renew(self, agent: Agent, version: Version) -> None:
        """An agent follows another plan: the bus and its radio go by that."""
        agent.kinds = version.messages
        plans = {agent.name: agent.plan}
        self.bus.renew(plans)
        self.conversations.renew(plans)
        if isinstance(self.driver, RealDriver):
            self.driver.have_threads()
        radio = self._radios.get(agent.name)
        has_radio = any(info.radio is not None for info in agent.plan.channels)
        if version.schema is None or not has_radio or agent.body is None:
            return
        if radio is not None:
            radio.renew(version.schema)
            return
        names = [item.name for item in self.agents]
        radio = self._radios[agent.name] = Radio(agent, self.bus, version.schema, names)
        self.bus.join(agent, radio)
        radio.begin(self.world.step_ns if self.world is not None else None)

    # ---- running -----------------------------------------------------------------------------

    def agent(self, name: str) -> Agent:
        """The agent of that name. Raises KeyError if there is none."""
        return next((agent for agent in self.agents if agent.name == name), None) or _unknown(name)

    def peers(self) -> dict[str, Peer]:
        """The agents that run in other processes: who is there, and what came from whom."""
        return self.transport.peers()

    def history(self, agent: str, channel: str, since: int, until: int) -> list[tuple[int, object]]:
        """The data that an agent in another process has published in a span of time, as (time, message).

        It is asked for it, and has what it published lately. Times are in ns of this run.

        Raises:
            TransportError: there is no such agent or channel, or no answer.
        """
        return self.transport.history(agent, channel, since, until)

    def run(self) -> RunResult:
        """Run to the end; activities that still run then are cancelled, and the trace is closed.

        Ctrl-C and SIGTERM end the run cleanly where this is the main thread; a second one at once.

        Raises:
            TeamError: the team has run already; the network cannot be used.
        """
        if self._has_run:
            raise TeamError("a team runs once; make another one")
        self._has_run = True
        driver = self.driver
        plans = {agent.name: agent.plan for agent in self.agents}
        schema = self.version.schema
        queue = None if self._queue == QUEUE else self._queue
        self.trace.header(
            self.system,
            plans,
            self.seed,
            driver.clock.virtual,
            self.elsewhere,
            schema,
            queue,
            words_of(self._faults),
            self.transport.machine(driver.clock),
            self.version.sources,
        )
        self.trace.begun = True
        try:
            with importing(self._path), _interruptible(driver.stop, driver.clock.virtual):
                try:
                    self.transport.begin(self)
                except TransportError as problem:
                    raise TeamError(str(problem)) from problem
                if isinstance(driver, RealDriver):
                    driver.know_threads()  # the transport's
                try:
                    self._prepare()
                    self.bus.keep()
                    self.transport.go()
                    driver.run()
                finally:
                    self.transport.close()
            self._end(driver.reason)
        except BaseException:
            self._end("error")
            raise
        return RunResult(
            driver.reason,
            driver.clock.now(),
            tuple(self._result(agent) for agent in self.agents),
            self.trace.error,
            driver.left,
            self._idle_since(),
            self._open.conversations,
            self._open.unread,
            self.trace.faults.counts(),
        )

    def _note_open(self) -> None:
        """What is open, before everything is stopped."""
        waits: dict[str, tuple[tuple[Waiting, Need], ...]] = {}
        writers: dict[str, set[str]] = {}

        def note(agent: Agent) -> None:
            waits[agent.name] = waits_of(agent)

        for agent in self.agents:
            self.driver.look(agent, partial(note, agent))
            outside = {info.name for info in agent.plan.channels if info.is_from_outside}
            for region in agent.plan.regions:
                for channel in set(region.writes) - outside:
                    writers.setdefault(channel, set()).add(agent.name)
        self._open = picture(waits, self.conversations, writers)

    def _idle_since(self) -> int | None:
        return self.driver.idle_since if self.world is None else None

    def _end(self, reason: str) -> None:
        """Keep what is to be kept, write the last line, close the trace."""
        try:
            self.bus.end()
            for call in self.at_end:
                call()
            results = [self._result(agent) for agent in self.agents]
            self.trace.write(
                "finish",
                self.driver.clock.now(),
                reason=reason,
                agents=[
                    {
                        "name": result.name,
                        "finished": result.finished,
                        "failure": result.failure,
                        "configuration": list(result.configuration),
                        **({"waits": to_json(result.waits)} if result.waits else {}),
                        **({"stuck": True} if result.stuck else {}),
                    }
                    for result in results
                ],
                idle_since=self._idle_since(),
                conversations=to_json(self._open.conversations) or None,
                unread=to_json(self._open.unread) or None,
                faults=to_json(self.trace.faults.counts()) or None,
            )
        finally:
            self.trace.close()

    def _prepare(self) -> None:
        driver = self.driver
        driver.settled = self._settled
        driver.advance = self._advance
        driver.complain = self._complain
        driver.ending = self._note_open
        if isinstance(driver, RealDriver):
            driver.have_threads()
        with driver.holding():  # what is there from the beginning is part of the first step
            self.bus.restore(self._messages)
            for item in self._script:
                if item.at > 0:
                    driver.at(item.at, self._giving(item))
                else:
                    self._giving(item)()
            if self._before is not None:
                self._before(self)
            for agent in self.agents:
                agent.begin()
        for radio in self._radios.values():
            radio.begin(self.world.step_ns if self.world is not None else None)
        if self.world is not None and (self._stop is not None or not driver.clock.virtual):
            self._move_world()

    def _giving(self, item: TimedInput) -> Callable[[], None]:
        def give() -> None:
            for agent in self.agents:
                if item.agent not in (None, agent.name) or agent.over:
                    continue
                if item.event:
                    self.bus.give_event(agent, item.event)
                elif any(item.channel in region.reads for region in agent.plan.regions):
                    self.bus.give(agent, item.channel, item.message, item.sender)

        return give

    def _settled(self) -> str | None:
        self._swaps.try_again()
        if all(agent.over for agent in self.agents) and self.driver.clock.now() >= self._least:
            return "finished"
        return self._stop(self) if self._stop is not None else None

    def _advance(self, moment: int) -> None:
        if self.world is not None and self.driver.clock.virtual:
            self.world.advance(moment)
        self.bus.save()

    def _move_world(self) -> None:
        """Advance a simulated world step by step: with real time, or because it may end the run."""
        assert self.world is not None
        now = self.driver.clock.now()
        self.world.advance(now)
        following = self.world.now_ns + self.world.step_ns
        if following <= now:
            raise TeamError(
                f"the world stands still: after advance({now}) its now_ns is {self.world.now_ns},"
                f" and its step {self.world.step_ns} ns"
            )
        self.driver.at(following, self._move_world)

    def _complain(self, text: str, agent: str = "", activity: str | None = None) -> None:
        self.trace.fault(self.driver.clock.now(), agent, text, activity=activity)

    def _result(self, agent: Agent) -> AgentResult:
        chart = agent.chart
        waits = self._open.waits.get(agent.name, ())
        stuck = self._idle_since() is not None and is_stuck(waits)
        return AgentResult(
            agent.name,
            agent.role,
            chart.finished,
            chart.failure,
            agent.failed_at,
            chart.configuration() if chart.started else (),
            agent.steps,
            waits,
            stuck,
            stuck and agent.name in self._open.idle,
        )


def _check_activities(charts: Iterable[type[Chart]], find: ActivityFinder) -> None:
    errors = activity_errors(charts, find)
    if errors:
        raise TeamError("\n".join(errors))


def _checked(
    script: tuple[TimedInput, ...], members: Sequence[tuple[str, type[Chart]]]
) -> tuple[TimedInput, ...]:
    names = [name for name, _ in members]
    read = {channel for _, chart in members for region in chart.PLAN.regions for channel in region.reads}
    for item in script:
        if item.agent is not None and item.agent not in names:
            raise TeamError(f"the script is for an agent {item.agent}; there are {', '.join(names)}")
        if item.channel and item.channel not in read:
            known = ", ".join(sorted(read)) or "none"
            raise TeamError(f"no agent of the team reads {item.channel}; there are {known}")
    return script


def _with_radio(
    agents: Iterable[tuple[str, type[Chart]]], bodies: Container[str], schema: Schema | None
) -> list[str]:
    """The agents that have a body and a channel by radio. Raises TeamError if there is no schema for one."""
    found = [
        name
        for name, chart in agents
        if name in bodies and any(info.radio is not None for info in chart.PLAN.channels)
    ]
    if found and schema is None:
        raise TeamError(f"{found[0]} has a radio, but the messages have no schema for it")
    return found


def _here(names: Sequence[str], setup: Setup) -> Sequence[str]:
    """The agents of this process.

    Raises:
        TeamError: the team cannot be set up like this.
    """
    if not names:
        raise TeamError("a team has at least one agent")
    if len(set(names)) < len(names):
        double = next(name for name in names if names.count(name) > 1)
        raise TeamError(f"two agents are called {double}")
    if setup.clock not in ("virtual", "real"):
        raise TeamError(f"the clock is virtual or real, not {setup.clock!r}")
    chosen = names if setup.here is None else tuple(setup.here)
    strangers = [name for name in chosen if name not in names]
    if strangers:
        raise TeamError(f"there is no agent {strangers[0]} in the team; there are {', '.join(names)}")
    here = [name for name in names if name in chosen]
    if not here:
        raise TeamError("no agent of the team is to run here")
    if len(here) < len(names) and not setup.transport.networked:
        raise TeamError(f"{', '.join(n for n in names if n not in here)} cannot be reached: no transport")
    if setup.transport.networked and setup.clock != "real":
        raise TeamError("agents in several processes have no virtual time in common: play in real time")
    if setup.world is not None and setup.until_ns is None and setup.stop is None:
        raise TeamError("a world never ends by itself: say how long the run is, or what stops it")
    return here


def run(
    loaded: Loaded,
    activities: ActivityFinder | Mapping[str, type[Executable]],
    *,
    plan: str | None = None,
    agent: str | None = None,
    **options: object,
) -> RunResult:
    """Run a system's team or, with `plan`, one agent (of that name, or called `agent`) with that plan.

    The options are those of `Setup`. In virtual time and in a world, a run without `until_ns` and `stop` ends
    after one minute (`USUAL_LENGTH`), as one of `asemec run` does; with `until_ns=None` it has no limit.

    Raises:
        TeamError: the system has no team or no such plan, and what `Team` raises.
    """
    goes_on = options.get("clock") == "real" and options.get("world") is None
    if not goes_on and options.get("stop") is None:
        options.setdefault("until_ns", USUAL_LENGTH)
    return make_team(loaded, activities, plan=plan, agent=agent, **options).run()


def make_team(
    loaded: Loaded,
    activities: ActivityFinder | Mapping[str, type[Executable]],
    *,
    plan: str | None = None,
    agent: str | None = None,
    **options: object,
) -> Team:
    """The team of a generated system, ready to run; see `run`."""
    charts = loaded.charts
    known = ", ".join(charts) or "none"
    if plan is not None:
        if plan not in charts:
            raise TeamError(f"{loaded.name} has no plan {plan}; it has {known}")
        members = [(agent or plan, charts[plan])]
    elif loaded.team:
        members = [(name, charts[role]) for name, role in loaded.team]
    elif len(charts) == 1:
        name, chart = next(iter(charts.items()))
        members = [(agent or name, chart)]
    else:
        raise TeamError(f"{loaded.name} declares no team: say which plan to run; it has {known}")
    path = (*loaded.path, *cast("Sequence[Path]", options.pop("path", ())))
    find: ActivityFinder = activities if callable(activities) else dict(activities).get
    setup = made(
        Setup,
        version=version_of(loaded, find),
        system=loaded.name,
        messages=loaded.messages,
        schema=loaded.schema,
        path=path,
        **options,
    )
    return Team(members, find, setup)


@contextmanager
def _interruptible(stop: Callable[[str], None], virtual: bool) -> Iterator[None]:
    """Inside, Ctrl-C and SIGTERM end the run; a second signal acts as if there were no run.

    In real time SIGTERM is how a run is meant to end, and has a reason of its own.
    Only a run in the main thread does so, since Python lets no other set handlers; they are put back.
    """
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    before: dict[int, Callable[[int, FrameType | None], object] | int | signal.Handlers | None] = {}

    def handle(number: int, frame: FrameType | None) -> None:
        for each, handler in before.items():
            signal.signal(each, handler)
        stop("terminated" if number == signal.SIGTERM and not virtual else "interrupted")

    for number in (int(signal.SIGINT), int(signal.SIGTERM)):
        if signal.getsignal(number) is not None:  # None: it was not set by Python
            before[number] = signal.signal(number, handle)
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


def _unknown(name: str) -> Agent:
    raise KeyError(name)
