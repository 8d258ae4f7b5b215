"""Telling: what was so, and what would have to be otherwise, in words."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from typing import assert_never

from aseme_dsl.amola.expression import Age, At, Mean, value_text, walk
from aseme_dsl.amola.statechart import Statechart, transition_text
from aseme_dsl.play.asking.changes import (
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
from aseme_dsl.play.asking.names import named
from aseme_dsl.play.asking.parts import Part
from aseme_dsl.play.asking.past import Past
from aseme_dsl.play.asking.reading import Reading
from aseme_dsl.play.asking.said import Said, where
from aseme_dsl.play.asking.unsent import Unsent
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.inputs import AgentMessage, Completed, Crashed, Happened, Input
from aseme_dsl.runtime.chart.plan import Plan, is_in
from aseme_dsl.runtime.time.clock import shown

SETTERS = 3
"""So many transitions that set a variable are listed."""
LONGEST = 80
"""A value is shown with so many characters at most."""


@dataclass(frozen=True, slots=True)
class Teller:
    """Says what is asked of one agent, in the words of its statechart."""

    agent: str
    chart: Statechart
    trial: Trial
    past: Past
    unsent: Unsent

    @property
    def plan(self) -> Plan:
        return self.trial.plan

    def state(self, label: str) -> str:
        """What people call a state."""
        return named(self.plan, label)

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
        targets = " and ".join(map(self.state, last.targets))
        return f"to {targets} from {start}{name}{by} ({last.at or first.at})"

    # ---- what was so -----------------------------------------------------------------------------

    def cause(self, change: Change, moment: Moment, place: int) -> Said:
        """What was so behind so many transitions of a step; `change` is that it was not."""
        match change:
            case Holding(part=part, is_true=is_true):
                verb = "did not hold" if is_true else "held"
                return self._part(
                    part, verb, moment, self.trial.decided(part, moment, (), not is_true, place)
                )
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

    def change(self, change: Change, moment: Moment, changes: Sequence[Change]) -> Said:
        """Why something is not as it would have to be; `changes` are all that a step needs."""
        match change:
            case Holding(part=part, is_true=is_true):
                verb = "does not hold" if is_true else "holds"
                read = self.trial.decided(part, moment, changes, not is_true)
                told = self._part(part, verb, moment, read)
                return replace(told, inside=(*told.inside, *self._setters(read)))
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
                return self.unsent.message(change)
            case Lacking(input=item):
                return Said(f"{_input_text(item, self)} is there")
            case Drawing(transition=transition):
                return Said(f"another branch may be drawn: {self._chance(transition)}")
            case _:
                assert_never(change)

    def _part(self, part: Part, verb: str, moment: Moment, found: Sequence[Reading]) -> Said:
        """A part of a condition without its negation, with what it read, and where that comes from."""
        text, whole = value_text(part.value), value_text(part.value, expand=True)
        meant = f" ({whole})" if whole != text else ""
        is_aged = any(isinstance(item, Age | At | Mean) for item in walk(part.value))
        read = tuple(self._reading(item, moment.now, is_aged) for item in found)
        return Said(f"`{text}` {verb}{meant}", read)

    def _setters(self, found: Sequence[Reading]) -> Iterator[Said]:
        """Which transitions set the variables that were read."""
        for name in dict.fromkeys(item.variable for item in found if item.variable):
            ways = [
                self.plan.way((number,))
                for number, item in enumerate(self.plan.transitions)
                if any(action[:2] == ("assign", name) for action in item.actions)
            ]
            if ways:
                more = f", and {len(ways) - SETTERS} more" if len(ways) > SETTERS else ""
                yield Said(f"{name.partition('@')[0]} is set in {', '.join(ways[:SETTERS])}{more}")

    def _reading(self, item: Reading, now: int, is_aged: bool) -> Said:
        if item.is_timer:
            ends = item.value
            if not isinstance(ends, int):
                return Said(f"{item.text} is not started")
            return Said(f"{item.text} {'has run out' if ends <= now else 'runs out'} at {shown(ends)}")
        if item.identity is None:
            if item.channel is None:
                return Said(f"{item.text} is {'absent' if item.value is None else _short(item.value)}")
            inside = tuple(self.unsent.absent(item))
            return Said(f"{item.text} is absent: the message is not there", inside)
        sender = "itself" if item.sender == self.agent else item.sender
        age = "" if item.age is None else f"{shown(item.age)} old, "
        inside = () if item.channel is None else tuple(self.unsent.newer(item, now, is_aged))
        return Said(f"{item.text} is {_short(item.value)}, {age}from {sender}", inside)

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


__all__ = ["Teller"]
