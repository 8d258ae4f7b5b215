"""Stepwise: a run by hand, in which activities end and messages arrive only as a scenario says."""

from __future__ import annotations

from collections.abc import Callable, Generator, Mapping
from functools import partial
from random import Random
from typing import cast

from aseme_dsl.amola.expression import Value
from aseme_dsl.play.scenario import Computes, Content, Does, Gets, Script
from aseme_dsl.play.stand_ins import ActedFailure, NotComputed, Types, computed, given_message
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.activity.activities import Activity, Executable
from aseme_dsl.runtime.activity.codeless import WITHOUT_CODE
from aseme_dsl.runtime.activity.context import Context
from aseme_dsl.runtime.agent.agent import Agent
from aseme_dsl.runtime.chart.board import NEVER
from aseme_dsl.runtime.chart.functions import results_of
from aseme_dsl.runtime.chart.inputs import Identity
from aseme_dsl.runtime.chart.plan import ActivityInfo
from aseme_dsl.runtime.message.acl import AclMessage
from aseme_dsl.runtime.team.team import Team
from aseme_dsl.runtime.time.clock import SECOND
from aseme_dsl.source import Span

_LONG = 3600 * SECOND
"""So long an activity waits at once (ns)."""


@dataclass(slots=True)
class _Act:
    """What an activity does at a moment."""

    moment: int
    act: Does
    span: Span
    is_taken: bool = False


@dataclass(frozen=True, slots=True)
class _Drawn:
    """Draws the same number again and again."""

    value: object

    def random(self) -> object:
        return self.value


@dataclass(frozen=True, slots=True)
class _Letter:
    kind: str
    what: str
    give: Callable[[], None]


class ByHand:
    """What moves a team that is played by hand: its links, and what its activities do."""

    def __init__(self, script: Script, inputs: Mapping[str, object], types: Types) -> None:
        self._until = NEVER if script.stepwise is None else script.stepwise
        self._inputs = inputs
        self._types = types
        self._team: Team | None = None
        self._ways: dict[tuple[str, str], list[_Letter]] = {}
        self._acts: dict[tuple[str, str], list[_Act]] = {}
        for item in sorted(script.stimuli, key=lambda item: item.moment):
            if isinstance(item.act, Does):
                key = item.act.agent, item.act.acting.activity
                self._acts.setdefault(key, []).append(_Act(item.moment, item.act, item.span))

    def begin(self, team: Team) -> None:
        """The run begins."""
        self._team = team
        team.bus.links = team.conversations.links = self
        if self._until < NEVER:
            team.driver.at(self._until, self._release)

    @property
    def _moment(self) -> int:
        assert self._team is not None
        return self._team.driver.clock.now()

    # ---- the links ---------------------------------------------------------------------------

    def carry(
        self, sender: str, receiver: str, kind: str, what: str, identity: Identity, give: Callable[[], None]
    ) -> None:
        """Something is on its way: see `Links.carry`."""
        assert self._team is not None
        if self._moment >= self._until:
            self._team.driver.at(self._moment, give)
            return
        self._ways.setdefault((sender, receiver), []).append(_Letter(kind, what, give))

    def _release(self) -> None:
        """From now on nothing waits."""
        for letters in self._ways.values():
            for letter in letters:
                letter.give()
        self._ways.clear()

    def gets(self, act: Gets, span: Span) -> None:
        """The oldest message of this kind arrives, or is lost. Raises NotComputed if it is not the next."""
        letters = self._ways.get((act.sender, act.agent), [])
        held: set[str] = set()
        coming = []
        for letter in letters:
            lane = letter.what if letter.kind in ("data", "radio") else ""
            if lane not in held:
                held.add(lane)
                coming.append(letter)
        found = next((letter for letter in coming if _is(letter, act)), None)
        if found is None:
            there = ", ".join(map(_called, coming)) or "nothing"
            raise NotComputed(span, f"it is not the next on its way from {act.sender}: that is {there}")
        letters.remove(found)
        if not act.is_lost:
            found.give()

    # ---- what functions give -----------------------------------------------------------------

    def computes(self, agent: Agent, act: Computes) -> None:
        """A function gives an agent this value from now on."""
        value = self._computed(act.value)
        chart = agent.chart
        if act.function == "random":
            chart.chance = cast("Random", _Drawn(value))
        else:
            for name, _, result, _ in chart.PLAN.functions:
                if name.partition("(")[0] == act.function:
                    chart._functions[name] = (lambda *arguments: value), results_of(result)

    # ---- activities --------------------------------------------------------------------------

    def find(self, infos: Mapping[str, ActivityInfo]) -> Callable[[str], type[Executable]]:
        """Gives the code that waits for what is done by hand."""
        kinds = {name: self._kind(info) for name, info in infos.items()}
        return kinds.__getitem__

    def _kind(self, info: ActivityInfo) -> type[Executable]:
        hand = self

        class Waits(Activity):
            stands_in = True

            def execute(self, context: Context, **arguments: object) -> Generator[float, None, str | None]:
                while (next_ := hand._next(context.agent, info.name, context.now_ns)) is not None:
                    next_.is_taken = True
                    try:
                        yield from _until(context, next_.moment)
                    except BaseException:
                        next_.is_taken = False
                        raise
                    hand._do(context, next_)
                    if next_.act.is_end:
                        return next(iter(next_.act.acting.ends), None)
                yield from _until(context, hand._until)
                usual = WITHOUT_CODE if info.takes is None else info.takes
                yield from _until(context, context.now_ns + usual)
                return next(iter(info.ends), None)

        return Waits

    def _next(self, agent: str, activity: str, moment: int) -> _Act | None:
        acts = self._acts.get((agent, activity), ())
        return next((item for item in acts if item.moment >= moment and not item.is_taken), None)

    def check(self, act: Does, span: Span) -> None:
        """Raises NotComputed if the activity does not run."""
        acts = self._acts[act.agent, act.acting.activity]
        if not any(item.act is act and item.is_taken for item in acts):
            raise NotComputed(span, f"{act.acting.activity} does not run in {act.agent} then")

    def _do(self, context: Context, what: _Act) -> None:
        act = what.act
        for performative, message in act.takes:
            if performative is None:
                taken, called = context.consume(message), message
            else:
                taken, called = context.receive(performative, message), f"{performative} {message}"
            if taken is None:
                raise NotComputed(what.span, f"no {called} waits for it")
        for name, value in act.acting.sets:
            context.set_variable(name, self._computed(value))
        for item in act.acting.writes:
            context.publish(item.content.channel, self._given(item.content))
        for content in act.prepares:
            context.prepare(self._given(content))
        for content, receiver in act.sends:
            context.send(content.performative or "", self._given(content), receiver)
        if act.fails:
            raise ActedFailure(f"{act.acting.activity} fails, as the scenario says")

    def _given(self, content: Content) -> object:
        return given_message(content, self._types, self._inputs)

    def _computed(self, value: Value) -> object:
        return computed(value, self._inputs, self._types)


def _until(context: Context, moment: int) -> Generator[float, None, None]:
    """Let time pass."""
    while (now := context.now_ns) < moment:
        yield min(moment - now, _LONG) / SECOND


def _is(letter: _Letter, act: Gets) -> bool:
    if act.performative is None:
        return letter.kind != "mail" and letter.what == act.what
    if letter.kind != "mail":
        return False
    acl = _acl(letter)
    if acl is None:
        return act.performative == letter.what  # the news of a loss
    return acl.performative == act.performative and act.what in ("", acl.message)


def _acl(letter: _Letter) -> AclMessage | None:
    given = letter.give.args if isinstance(letter.give, partial) else ()
    return next((part for part in given if isinstance(part, AclMessage)), None)


def _called(letter: _Letter) -> str:
    acl = _acl(letter)
    return letter.what if acl is None else f"{acl.performative} {acl.message}"


__all__ = ["ByHand"]
