"""Telling: what an answer says, as lines with lines inside."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import assert_never

from aseme_dsl.amola.expression import Age, At, Mean, value_text, walk
from aseme_dsl.amola.statechart import Statechart, transition_text
from aseme_dsl.play.asking.changes import (
    OUTSIDE,
    Change,
    Coming,
    Drawing,
    Ending,
    Failing,
    Holding,
    Lacking,
    Moment,
    Raising,
    Trial,
    Waiting,
)
from aseme_dsl.play.asking.parts import Part
from aseme_dsl.play.asking.past import Past
from aseme_dsl.play.asking.reading import Reading, readings
from aseme_dsl.runtime.chart.inputs import LOST, AgentMessage, Completed, Crashed, Happened, Input
from aseme_dsl.runtime.chart.plan import Plan, is_in
from aseme_dsl.runtime.time.clock import shown

LONGEST = 80
"""A value is shown with so many characters at most."""


@dataclass(frozen=True, slots=True)
class Said:
    """A line of an answer, and what explains it."""

    text: str
    inside: tuple[Said, ...] = ()


@dataclass(frozen=True, slots=True)
class Teller:
    """Says what is asked of one agent, in the words of its statechart."""

    agent: str
    chart: Statechart
    trial: Trial
    past: Past
    given: Mapping[str, object]
    back: Callable[[str, str], tuple[Said, ...]]
    """Says why another agent did not publish on a channel, or send an agent message."""

    @property
    def plan(self) -> Plan:
        return self.trial.plan

    def state(self, label: str) -> str:
        """What people call a state."""
        return self.plan.called(self.plan.by_label[label])

    def where(self, near: Iterable[str]) -> str:
        """Where the agent is, as a phrase, and what is active beside that."""
        return where(self.past, self.agent, near, beside=True)

    def way(self, way: tuple[int, ...]) -> str:
        """A transition with the text that decides on it, and its place."""
        return self.passage((way,))

    def passage(self, ways: Sequence[tuple[int, ...]]) -> str:
        """Transitions that one step takes one after the other, as one."""
        first, last = self.plan.transitions[ways[0][0]], self.plan.transitions[ways[-1][-1]]
        parts = (self.chart.transitions[number] for way in ways for number in way)
        texts = [text for item in parts if (text := transition_text(item))]
        by = f" by `{'`, `'.join(texts)}`" if texts else ""
        source = self.plan.by_label[first.source]
        start = "the start of " if source.type == "START" else ""
        name = self.state(first.source).removeprefix("start of ")
        return f"to {self.state(last.target)} from {start}{name}{by} ({last.at or first.at})"

    # ---- what was so -----------------------------------------------------------------------------

    def cause(self, change: Change, moment: Moment) -> Said:
        """What was so; `change` is that it was not."""
        match change:
            case Holding(part=part, is_true=is_true):
                verb = "did not hold" if is_true else "held"
                return self._part(part, verb, moment)
            case Lacking(input=Completed(label=label, outcome=outcome)):
                with_it = "" if outcome is None else f" with `{outcome}`"
                return Said(f"{self.state(label)} ended{with_it}")
            case Lacking(input=Crashed(label=label, reason=reason)):
                return Said(f"{self.state(label)} failed: {reason}")
            case Waiting(label=label):
                chart = self.trial.look(moment)
                entered = getattr(chart, chart.TIMES[label])
                passed = moment.now - entered
                return Said(f"{shown(passed)} had passed since {self.state(label)} was entered")
            case Lacking(input=item):
                return Said(f"{_input_text(item, self)} came")
        raise AssertionError(change)

    # ---- what has to be otherwise ----------------------------------------------------------------

    def change(self, change: Change, moment: Moment) -> Said:
        """Why something is not as it would have to be."""
        match change:
            case Holding(part=part, is_true=is_true):
                verb = "does not hold" if is_true else "holds"
                return self._part(part, verb, moment)
            case Ending(label=label, outcome=outcome):
                with_it = "" if outcome is None else f" with `{outcome}`"
                return Said(f"{self.state(label)} has not ended{with_it}: {self._running(label)}")
            case Failing(label=label):
                return Said(f"{self.state(label)} has not failed")
            case Waiting(label=label, duration=0):
                return Said(f"the time since {self.state(label)} was entered has passed")
            case Waiting(label=label, duration=duration):
                return Said(self._time(label, duration, moment))
            case Raising(event=event):
                return Said(f"the event {event} is not raised")
            case Coming():
                return self._message(change)
            case Lacking(input=item):
                return Said(f"{_input_text(item, self)} is there")
            case Drawing(transition=transition):
                return Said(f"another branch may be drawn: {self._chance(transition)}")
            case _:
                assert_never(change)

    def _part(self, part: Part, verb: str, moment: Moment) -> Said:
        """A part of a condition without its negation, with what it reads, and where that comes from."""
        text, whole = value_text(part.value), value_text(part.value, expand=True)
        meant = f" ({whole})" if whole != text else ""
        chart = self.trial.look(moment)
        found = readings(part, chart, moment.now, self.given)
        is_aged = any(isinstance(item, Age | At | Mean) for item in walk(part.value))
        read = tuple(self._reading(item, moment.now, is_aged) for item in found)
        return Said(f"`{text}` {verb}{meant}", read)

    def _reading(self, item: Reading, now: int, is_aged: bool) -> Said:
        if item.is_timer:
            ends = item.value
            if not isinstance(ends, int):
                return Said(f"{item.text} is not started")
            return Said(f"{item.text} {'has run out' if ends <= now else 'runs out'} at {shown(ends)}")
        if item.sender == OUTSIDE[0]:
            return Said(f"{item.text}: the message would have to come")
        if item.channel is None:
            return Said(f"{item.text} is {_short(item.value)}")
        if item.identity is None:
            return Said(f"{item.text} is absent: the message is not there", tuple(self._absent(item)))
        sender = "itself" if item.sender == self.agent else item.sender
        text = f"{item.text} is {_short(item.value)}, {shown(item.age or 0)} old, from {sender}"
        return Said(text, tuple(self._newer(item, now, is_aged)))

    def _running(self, label: str) -> str:
        if label not in self.past.place(self.agent):
            return "its activity would run then"
        since = self.past.began(self.agent, label)
        activity = self.plan.by_label[label].activity or ""
        takes = next((info.takes for info in self.plan.activities if info.name == activity), None)
        runs = f"its activity runs{'' if since is None else f' since {shown(since)}'}"
        return runs if takes is None else f"{runs}, and takes {shown(takes)}"

    def _time(self, label: str, duration: int, moment: Moment) -> str:
        chart = self.trial.look(moment)
        if not any(is_in(leaf, label) for leaf in self.past.place(self.agent)):
            return f"{shown(duration)} would have to pass in {self.state(label)}"
        entered = getattr(chart, chart.TIMES[label])
        return (
            f"{shown(duration)} have not passed since {self.state(label)} was entered at {shown(entered)}:"
            f" they will have at {shown(entered + duration)}"
        )

    def _chance(self, transition: int) -> str:
        item = self.plan.transitions[transition]
        weights = [other.weight or 0 for _, other in self.plan.outgoing(item.source)]
        return f"this one has the weight {item.weight}, all together {sum(weights)}"

    # ---- what has not come -----------------------------------------------------------------------

    def _newer(self, item: Reading, now: int, is_aged: bool) -> Iterator[Said]:
        """Why there is no newer message of a sender, if there should be one."""
        name, channel = item.sender or "", item.channel or ""
        last = self.past.published.get(channel, {}).get(name)
        if name == self.agent or name not in self.past.members:
            return
        if last is not None and item.age is not None and last["time"] > now - item.age:
            yield Said(f"{name} has published another one at {shown(last['time'])}, which has not come")
            yield from self._trouble(name, channel)
        elif is_aged:
            yield from self._sender(name, channel, "does so")

    def _sender(self, name: str, channel: str, verb: str) -> Iterator[Said]:
        """Where an agent publishes on a channel, and where it is."""
        places = dict(_publishing(self.past.plan(name), channel))
        told = ", ".join(dict.fromkeys(places.values()))
        text = f"{name} {verb} in {told}, and {where(self.past, name, places)}"
        yield Said(text, () if name == self.agent else self.back(name, channel))

    def _trouble(self, name: str, channel: str) -> Iterator[Said]:
        found = self.past.troubles.get((channel, self.agent)) or self.past.troubles.get((channel, name))
        if found is not None:
            what = found["kind"].replace("_", " ")
            yield Said(f"{what} at {shown(found['time'])}: {found['reason']}")

    def _absent(self, item: Reading) -> Iterator[Said]:
        """Why there is no message of a channel."""
        channel = item.channel or ""
        senders = [name for name, plan in self.past.plans() if _publishes(plan, channel)]
        wanted = [name for name in senders if item.host in (None, name)]
        published = self.past.last_published(channel, (*wanted, "input"))
        if self.agent in wanted and all(set(one.get("to", ())) <= {name} for name, one in published.items()):
            wanted = [self.agent]  # each publishes it for itself
        for name in wanted:
            yield from self._unpublished(name, channel)
        if not wanted:
            everywhere = "no role of the team publishes it: it comes from outside"
            yield Said(everywhere if item.host is None else f"{item.host} does not publish it")
        outside = published.get("input")
        if outside is not None and self.agent in outside.get("to", [self.agent]):
            yield Said(f"the last one from outside came at {shown(outside['time'])}")

    def _unpublished(self, name: str, channel: str) -> Iterator[Said]:
        last = self.past.published.get(channel, {}).get(name)
        if last is None:
            yield from self._sender(name, channel, "has never published it; it does")
        elif self.agent not in last.get("to", [self.agent]):
            yield Said(f"{name} published it at {shown(last['time'])}, but not to {self.agent}")
        else:
            yield Said(f"{name} published it last at {shown(last['time'])}; it was taken, or dropped, since")
        yield from self._trouble(name, channel)

    def _message(self, coming: Coming) -> Said:
        if coming.performative == LOST:
            return Said(f"no {coming.participant} is lost")
        what = f"{coming.performative} {coming.message}".strip()
        text = f"`{what}` from {coming.participant} has not come, or was taken before"
        return Said(text, tuple(self._unsent(coming)))

    def _unsent(self, coming: Coming) -> Iterator[Said]:
        info = next((item for item in self.plan.branches if item.label == coming.branch), None)
        if info is None:
            return
        kind = coming.performative, coming.message
        for name, plan in self.past.plans():
            plays = any(
                item.protocol == info.protocol
                and item.participant == coming.participant
                and kind in item.sends
                for item in plan.branches
            )
            if name == self.agent or not plays:
                continue
            last = self.past.last_sent(kind, name)
            if last is None:
                places = dict(_sending(plan, kind))
                told = ", ".join(dict.fromkeys(places.values()))
                text = f"{name} has never sent it; it does in {told}, and {where(self.past, name, places)}"
                yield Said(text, self.back(name, " ".join(kind)))
            else:
                to = ", ".join(last["to"]) or "no agent"
                yield Said(f"{name} sent it last at {shown(last['time'])}, to {to}")
            refused = self.past.refused.get((self.agent, name))
            if refused is not None:
                text = f"one of {name} was not taken at {shown(refused['time'])}: {refused['reason']}"
                yield Said(text)


def where(past: Past, agent: str, near: Iterable[str], *, beside: bool = False) -> str:
    """In which state an agent is, of those that are active at once the nearest to others, as a phrase."""
    member = past.members[agent]
    if member.over:
        return f"has stopped: {member.over}"
    plan = past.plan(agent)
    place = past.place(agent)
    if plan is None or not place:
        return "has not started"
    wanted = tuple(near)
    leaves = [leaf for leaf in place if plan.by_label[leaf].type != "AND"]
    leaves.sort(key=lambda leaf: -max((_common(leaf, label) for label in wanted), default=0))
    first, *others = leaves
    since = past.began(agent, first)
    told = f"is in {plan.called(plan.by_label[first])}{'' if since is None else f' since {shown(since)}'}"
    names = [plan.called(plan.by_label[leaf]) for leaf in others if plan.by_label[leaf].type == "BASIC"]
    return f"{told}, beside {', '.join(names)}" if names and beside else told


def _common(one: str, other: str) -> int:
    """How many states are around both."""
    pairs = zip(one.split("."), other.split("."), strict=False)
    return next((place for place, (first, second) in enumerate(pairs) if first != second), len(other))


def _publishes(plan: Plan, channel: str) -> bool:
    return next(_publishing(plan, channel), None) is not None


def _publishing(plan: Plan | None, channel: str) -> Iterator[tuple[str, str]]:
    """Where a role publishes on a channel, by label, and what that is called."""
    if plan is None:
        return
    writers = {item.name for item in plan.activities if channel in item.writes}
    yield from ((state.label, state.name) for state in plan.states if state.activity in writers)
    yield from ((plan.states[0].label, item.name) for item in plan.modules if channel in item.writes)
    for number, item in enumerate(plan.transitions):
        if ("publish", channel) in item.actions:
            yield item.source, plan.way((number,))


def _sending(plan: Plan, kind: tuple[str, str]) -> Iterator[tuple[str, str]]:
    """Where a role sends an agent message, by label, and what that is called."""
    for number, item in enumerate(plan.transitions):
        if any(action[:3] == ("send", *kind) for action in item.actions):
            yield item.source, plan.way((number,))
    for info in plan.branches:
        for performative, message, states, _ in info.moves:
            if (performative, message) == kind:
                yield from ((label, plan.called(plan.by_label[label])) for label in states)


def _input_text(item: Input, teller: Teller) -> str:
    match item:
        case AgentMessage(performative=performative, message=message, sender=sender):
            return " ".join(filter(None, (f"`{performative}", f"{message}`", f"from {sender}")))
        case Happened(name=name):
            return f"the event {name}"
        case Crashed(label=label):
            return f"the failure of {teller.state(label)}"
        case Completed(label=label):
            return f"the end of {teller.state(label)}"
        case _:
            return type(item).__name__


def _short(value: object) -> str:
    text = json.dumps(value, ensure_ascii=False)
    return text if len(text) <= LONGEST else f"{text[: LONGEST - 1]}…"


__all__ = ["Said", "Teller", "where"]
