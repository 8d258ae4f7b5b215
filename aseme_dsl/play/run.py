"""Run: one way to play a scenario, in virtual time, and what came of it."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import field, replace
from functools import partial
from pathlib import Path
from typing import Protocol, assert_never

from aseme_dsl.play.coverage.probes import Recorder
from aseme_dsl.play.evaluate import NotEvaluated
from aseme_dsl.play.observer import Observer
from aseme_dsl.play.scenario import (
    Act,
    Assumption,
    Computes,
    Content,
    Crashes,
    Does,
    Gets,
    Raises,
    Receives,
    Restarts,
    Script,
    Stimulus,
)
from aseme_dsl.play.sight.guards import Guards
from aseme_dsl.play.sight.insight import Present
from aseme_dsl.play.sight.story import Happened
from aseme_dsl.play.sight.storyteller import Storyteller
from aseme_dsl.play.sight.subject import Next
from aseme_dsl.play.stand_ins import (
    NotComputed,
    finder,
    given_message,
    staged,
    waiting,
)
from aseme_dsl.play.stepwise import ByHand
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.activity.activities import ActivityFinder
from aseme_dsl.runtime.agent.agent import Agent
from aseme_dsl.runtime.monitor.rules import State
from aseme_dsl.runtime.team.faults import Faults, Partition
from aseme_dsl.runtime.team.team import Team, TeamError, make_team
from aseme_dsl.runtime.trace.records import Record
from aseme_dsl.runtime.version.loading import Loaded
from aseme_dsl.runtime.world.body import AnyWorld
from aseme_dsl.source import Span


class NotPlayable(Exception):
    """A scenario cannot be played; the text says why, `span` is the place of the reason if it has one."""

    def __init__(self, reason: str, span: Span | None = None) -> None:
        super().__init__(reason)
        self.span = span


@dataclass(frozen=True, slots=True)
class Played:
    """How a run went. `states` are those of the expectations, `met` the conditions that were met."""

    seed: int
    inputs: Mapping[str, object]
    end: int
    states: tuple[State, ...]
    met: frozenset[int]
    broken: int | None
    """The first expectation that was broken, of those that every run has to meet."""
    failures: Mapping[str, str]
    faults: tuple[str, ...]
    story: tuple[Happened, ...]
    ends: Mapping[str, frozenset[str]]
    """The labels of the states that each agent is in at the end."""
    read: str = ""
    """What the broken condition has read when it was not so."""
    assumption: tuple[Assumption, int] | None = None
    """The assumption that held no longer first, and since when."""
    reached: Mapping[int, int] = field(default_factory=dict)
    """When an expectation has come as far as it is (ns)."""
    question: Next | None = None
    """What to ask next about the broken expectation."""
    came: Mapping[int, int] = field(default_factory=dict)
    """When the conditions of orders have occurred last (ns)."""
    near: str = ""
    """Which message came that is not the awaited one, and why."""


class Watch(Protocol):
    """Follows a run instant by instant."""

    def begin(self, team: Team, observer: Observer) -> None:
        """The run begins."""

    def acted(self, act: Crashes | Restarts) -> None:
        """The scenario has stopped an agent, or started it again, of which a trace has no line."""

    def settled(self, team: Team) -> str | None:
        """Nothing is left to do at an instant; a reason ends the run."""

    def ended(self, reason: str) -> None:
        """The run is over."""


def play(
    loaded: Loaded,
    script: Script,
    seed: int,
    inputs: Mapping[str, object],
    real: ActivityFinder,
    until: int,
    world: AnyWorld | None = None,
    listeners: Sequence[Callable[[Record], None]] = (),
    recorder: Recorder | None = None,
    watch: Watch | None = None,
    guards: Guards | None = None,
    trace: Path | None = None,
    is_whole: bool = False,
) -> Played:
    """Play a script with a seed and values for its inputs, up to `until` (ns).

    The run is in a `world`, if the script has one. `listeners` are given the records of the run, too;
    `recorder` takes what probes see, and `watch` follows the instants. With `guards`, the conditions of
    the roles, the run has a story; if that `is_whole`, it has all that happened. `trace` is the file in which
    the run is recorded.

    Raises:
        NotPlayable: the code of an activity cannot be loaded, a value cannot be computed.
    """
    inputs = {**script.values, **inputs}
    teller = None if guards is None else Storyteller((name for name, _ in script.team), guards)
    observer = Observer(script, inputs, teller=teller)
    acting = {item.activity: item for item in script.activities}
    is_alone = script.world is None
    hand = None if script.stepwise is None else ByHand(script, inputs, loaded.types)
    charts = {
        role: staged(chart, acting, is_alone) if hand is None else waiting(chart)
        for role, chart in loaded.charts.items()
    }
    if recorder is not None:
        charts = {role: recorder.listening(chart) for role, chart in charts.items()}
    try:
        if hand is None:
            find = finder(script, inputs, loaded.types, real, loaded.charts)
        else:
            charts_of = loaded.charts.values()
            find = hand.find({info.name: info for chart in charts_of for info in chart.PLAN.activities})
        team = make_team(
            replace(loaded, charts=charts, team=script.team),
            find,
            seed=seed,
            until_ns=until,
            least_ns=max((item.moment for item in script.stimuli), default=0) if hand is not None else 0,
            stop=observer.settled
            if watch is None
            else lambda team: observer.settled(team) or watch.settled(team),
            before=_Stage(script, loaded, inputs, observer, watch, hand).begin,
            world=world,
            listeners=(observer, *listeners),
            faults=_faults(script, seed),
            trace=trace,
        )
        result = team.run()
    except NotComputed as problem:
        raise NotPlayable(problem.reason, problem.span) from problem
    except (TeamError, NotEvaluated) as problem:
        raise NotPlayable(str(problem)) from problem
    if result.reason == "interrupted":
        raise KeyboardInterrupt
    observer.end(until, result.unread)
    if watch is not None:
        watch.ended(result.reason)
    broken = observer.broken
    return Played(
        seed,
        inputs,
        until if broken is None else observer.states[broken].at,
        tuple(observer.states),
        frozenset(observer.met),
        broken,
        observer.failures,
        tuple(observer.faults),
        observer.story({agent.name: agent.waits for agent in result.agents}, is_whole),
        observer.places(),
        observer.read,
        observer.assumed.broken,
        observer.reached,
        observer.question,
        observer.came,
        observer.near,
    )


def _faults(script: Script, seed: int) -> Faults | None:
    """What goes wrong between the agents, if something does."""
    cuts = tuple(Partition(cut.agents, cut.first, cut.last - cut.first) for cut in script.cuts)
    if script.network is not None:
        return replace(script.network.faults(seed), partitions=cuts)
    return Faults(seed, partitions=cuts) if cuts else None


@dataclass(frozen=True, slots=True)
class _Stage:
    """Gives the agents what the script gives them."""

    script: Script
    loaded: Loaded
    inputs: Mapping[str, object]
    observer: Observer
    watch: Watch | None
    hand: ByHand | None

    def begin(self, team: Team) -> None:
        """Give what comes first, and schedule the rest."""
        self.observer.begin(Present(team))
        names = {agent for agent, _ in self.script.team}
        speakers = (item.act.sender for item in self.script.stimuli if isinstance(item.act, Receives))
        for name in dict.fromkeys(speakers):
            if name not in names:
                team.conversations.add_external_agent(name, lambda message: None)
        if self.hand is not None:
            self.hand.begin(team)
        if self.watch is not None:
            self.watch.begin(team, self.observer)
        for item in self.script.stimuli:
            call = partial(self._do, team, item.act, item.span)
            if item.trigger is not None:
                later = partial(self._schedule, team, item, call)
                self.observer.waiting.setdefault(item.trigger, []).append(later)
            elif item.moment > 0:
                team.driver.at(item.moment, call)
            else:
                call()

    def _schedule(self, team: Team, item: Stimulus, call: partial[None], moment: int) -> None:
        team.driver.at(moment + item.moment, call)

    def _do(self, team: Team, act: Act, span: Span) -> None:
        agent = team.agent(act.agent)
        match act:
            case Receives(content=content, sender=sender):
                message = given_message(content, self.loaded.messages, self.inputs)
                if content.performative is None:
                    team.bus.give(agent, content.channel, message, sender)
                else:
                    self._say(team, agent, sender, content, content.performative, message)
            case Raises(event=event):
                team.bus.give_event(agent, event)
            case Crashes():
                agent.crash()
                self.observer.crashed(act.agent)
            case Restarts():
                agent.restart()
                self.observer.restarted(act.agent)
            case Does():
                assert self.hand is not None
                self.hand.check(act, span)
            case Gets():
                assert self.hand is not None
                self.hand.gets(act, span)
            case Computes():
                assert self.hand is not None
                self.hand.computes(agent, act)
            case _:
                assert_never(act)
        if self.watch is not None and isinstance(act, Crashes | Restarts):
            self.watch.acted(act)

    def _say(
        self, team: Team, agent: Agent, sender: str, content: Content, performative: str, message: object
    ) -> None:
        """Give an agent message."""
        known = next((item for item in team.agents if item.name == sender), None)
        identity = (sender, team.bus.outside()[1]) if known is None else known.identity()
        self.observer.given.add(identity)
        problem = team.conversations.give(agent, performative, content.channel, message, sender, identity)
        if problem:
            raise NotComputed(content.span, problem)


__all__ = ["NotPlayable", "Played", "play"]
