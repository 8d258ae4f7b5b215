"""Effects: what a step asks for outside of the chart, carried out for one agent."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping
from typing import TypeVar, cast

from aseme_dsl.runtime.activity.execution import Host, tell_expired
from aseme_dsl.runtime.activity.executions import Executions
from aseme_dsl.runtime.agent.overload import Overload
from aseme_dsl.runtime.agent.requests import Requests
from aseme_dsl.runtime.channel.bus import Bus
from aseme_dsl.runtime.chart.inputs import (
    Cancel,
    Effect,
    Fault,
    FunctionResult,
    Joined,
    Left,
    LeftOut,
    MailTaken,
    Publication,
    Resumed,
    Sending,
    SignalExpired,
    Start,
    Suspended,
)

_T = TypeVar("_T")


class Effects:
    """Carries out the effects of an agent's steps, in their order. Called while the agent is guarded."""

    def __init__(
        self, agent: Host, bus: Bus, executions: Executions, requests: Requests, overload: Overload
    ) -> None:
        self._agent = agent
        self._bus = bus
        self._executions = executions
        self._requests = requests
        self._conversations = agent.conversations
        self._missing: tuple[str, str] | None = None
        """The state that is entered though the content of a message is missing, and what to say of it."""
        self._passing: frozenset[int] = frozenset()
        """The tokens of the activities that the step cancels, which never begin if it starts them, too."""
        self.carry_out: Mapping[type[Effect], Callable[[Effect], None]] = dict(
            (
                _of(Start, self._start),
                _of(Cancel, executions.cancel),
                _of(Publication, self._publish),
                _of(Sending, self.send),
                _of(MailTaken, self._take_mail),
                _of(Joined, self._join),
                _of(Left, self._leave),
                _of(Suspended, self._suspend),
                _of(Resumed, lambda effect: self._conversations.resumed(agent, effect.branch)),
                _of(FunctionResult, _nothing),
                _of(Fault, self._count_fault),
                _of(SignalExpired, self._tell_expired),
                _of(LeftOut, lambda effect: overload.inside(effect.region, effect.channel)),
            )
        )
        """The function for each type of effect."""

    def look_ahead(self, effects: Iterable[Effect]) -> None:
        """Learn what a step asks for, before any of it is carried out."""
        self._passing = frozenset(item.token for item in effects if isinstance(item, Cancel))

    def _count_fault(self, effect: Fault) -> None:
        agent = self._agent
        at = agent.plan.transitions[effect.transition].at
        agent.trace.count_fault(agent.driver.clock.now(), agent.name, effect.reason, at)

    def _tell_expired(self, effect: SignalExpired) -> None:
        agent = self._agent
        tell_expired(agent.trace, agent.driver.clock.now(), agent.name, effect)

    def _take_mail(self, effect: MailTaken) -> None:
        mail = self._conversations.taken(self._agent, effect.branch, effect.identity)
        if mail is not None:
            self._agent.take_note(effect.branch, mail)

    def _publish(self, effect: Publication) -> None:
        self._bus.publish(self._agent, effect.channel, effect.message, effect.host, region=effect.region)

    def _start(self, start: Start) -> None:
        if self._missing is not None and f"{start.label}.".startswith(f"{self._missing[0]}."):
            self._executions.refuse(start, self._missing[1])
            self._missing = None
        elif start.token in self._passing:
            self._executions.hold(start)
        else:
            self._executions.start(start)

    def _join(self, effect: Joined) -> None:
        self._requests.prepared.forget(effect.branch)
        self._conversations.joined(self._agent, effect.branch)

    def _leave(self, effect: Left) -> None:
        self._requests.prepared.forget(effect.branch)
        self._executions.leave(effect.branch)
        self._conversations.left(self._agent, effect.branch, effect.completed)

    def _suspend(self, effect: Suspended) -> None:
        self._executions.suspend(effect.branch)
        self._conversations.suspended(self._agent, effect.branch)

    def fail_for_content(self) -> None:
        """Fail the state that was entered by a transition whose message has no content, or the agent."""
        if self._missing is not None:
            (state, reason), self._missing = self._missing, None
            if not self._agent.over and not self._executions.fail_inside(state, reason):
                self._agent.fail(reason)

    def send(self, effect: Sending) -> None:
        """Send an agent message; without content, the state behind it will fail, or the agent."""
        agent = self._agent
        is_farewell = bool(effect.way) and agent.plan.transitions[effect.way[0]].kind == "abandon"
        if is_farewell and self._conversations.place(agent, effect.branch)[0] is None:
            return  # its conversation has not begun
        content = self._requests.content_of(effect)
        performative, message = effect.performative, effect.message
        if content is None:
            reason = f"{performative} {message} is not sent: nothing has prepared its content"
            ways = [agent.plan.transitions[number] for number in effect.way]
            at = ways[0].at if ways else ""
            agent.trace.fault(agent.driver.clock.now(), agent.name, reason, at)
            if is_farewell:
                return
            self._missing = (ways[-1].target if ways else effect.branch), reason
            return
        if effect.to is not None:
            receivers: Collection[str] = (effect.to,)
            self._conversations.send_to_agent(
                agent, effect.branch, performative, message, content, effect.to, effect.reply_by
            )
        else:
            receivers = self._conversations.send(
                agent,
                effect.branch,
                performative,
                message,
                content,
                effect.participant,
                effect.excepts,
                effect.reply_by,
                one=effect.one,
            )
        if is_farewell:
            self._conversations.took_leave(agent, effect.branch, receivers)


def _of(kind: type[_T], carry_out: Callable[[_T], None]) -> tuple[type[Effect], Callable[[Effect], None]]:
    """An entry of the table: the class of the effects, and the method that carries them out."""
    return cast("tuple[type[Effect], Callable[[Effect], None]]", (kind, carry_out))


def _nothing(effect: object) -> None:
    """Function results are in the record of the step."""


__all__ = ["Effects"]
