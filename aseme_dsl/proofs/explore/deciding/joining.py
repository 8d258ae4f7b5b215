"""Joining: what comes to an agent at the same moment as something else, in one step.

A signal and an event are there for one step alone, and a newer message takes the place of the one before. Of
two agent messages, the line that comes first takes its own. So what comes one after another is not all that
may happen.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import lru_cache, partial

from aseme_dsl.proofs.explore.coming import Coming
from aseme_dsl.proofs.explore.deciding.choosing import Choices
from aseme_dsl.proofs.explore.on_the_way import letter_of
from aseme_dsl.proofs.explore.surroundings import Underway, Ways, next_of
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.agent.agent import Agent
from aseme_dsl.runtime.channel.bus import Bus
from aseme_dsl.runtime.chart.inputs import LOST
from aseme_dsl.runtime.chart.plan import Plan, Transition, is_in, terms_in

_Related = Mapping[str, frozenset[str]]
"""What may come, with what makes a difference if it comes in the same step.

Signals by their channels, events by their names, agent messages by what they are called (see `name_of`), ends
of activities as `end_of` says.
"""


@dataclass(frozen=True, slots=True)
class _More:
    """Something that may come, too: how it is asked for, and what lets it come."""

    what: str
    question: tuple[object, ...]
    text: str
    do: Callable[[], None]


class Joining:
    """Decides, in a move in which something comes, what else comes with it."""

    def __init__(
        self,
        plans: Sequence[Plan],
        events: Mapping[str, Sequence[str]],
        ways: Ways,
        coming: Coming,
        bus: Bus,
        choices: Choices,
        arrive: Callable[[str, list[Underway], Underway], None],
    ) -> None:
        """`events` are those that come from elsewhere, by role."""
        self._related = {plan.name: related_in(plan) for plan in plans}
        self._first = {plan.name: sorted(first_in(plan)) for plan in plans}
        self._queued = {plan.name: frozenset(i.name for i in plan.channels if i.queued) for plan in plans}
        self._events = events
        self._ways = ways
        self._coming = coming
        self._bus = bus
        self._choices = choices
        self._arrive = arrive
        self.came: list[str] = []
        """What else has come in the present move."""

    def begin(self, agent: Agent) -> None:
        """An agent makes its first step: what makes a difference there may have come before it."""
        for what in self._first[agent.role]:
            for more in self._from_outside(agent, what):
                if self._choices.of(more.question, (None, True), more.text):
                    more.do()
                    self.came.append(what)

    def joins(self, agent: Agent, what: str) -> bool:
        """Whether it makes a difference for an agent if something else comes with this."""
        return what in self._related[agent.role]

    def join(self, agent: Agent, first: str) -> None:
        """Something has come to an agent."""
        self.came.clear()
        asked: set[object] = set()
        while True:
            here = {first, *self.came}
            found = (more for more in self._more(agent, here) if more.question not in asked)
            more = next(found, None)
            if more is None:
                return
            asked.add(more.question)
            if self._choices.of(more.question, (None, True), more.text):
                more.do()
                self.came.append(more.what)

    def _more(self, agent: Agent, here: set[str]) -> Iterator[_More]:
        """What may come where this has come."""
        related = self._related[agent.role]
        beside = frozenset[str]().union(*(related.get(what, frozenset()) for what in here))
        for (sender, receiver), waiting in self._ways.ways.items():
            for item in next_of(waiting) if receiver == agent.name else ():
                what = name_of(item)
                is_newer = what in here and what not in self._queued[agent.role]
                if what in beside or (is_newer and item.kind != "mail"):
                    question = ("joins", "way", sender, receiver, what.strip(), item.identity)
                    text = f"{receiver} gets {what.strip()} of {sender} at the same moment"
                    do = partial(self._arrive, receiver, waiting, item)
                    yield _More(what, question, text, do)
        for what in sorted(beside - here):
            yield from self._from_outside(agent, what)

    def _from_outside(self, agent: Agent, what: str) -> Iterator[_More]:
        """An event that is raised, or a signal, if it may come from outside."""
        if what in self._events[agent.role]:
            text = f"{agent.name}: {what} is raised at the same moment"
            do = partial(self._bus.give_event, agent, what)
            yield _More(what, ("joins", "event", agent.name, what), text, do)
        elif self._may_be_given(agent, what):
            text = f"{agent.name} gets {what} at the same moment"
            do = partial(self._coming.give, agent, what)
            yield _More(what, ("come", agent.name, what), text, do)

    def _may_be_given(self, agent: Agent, what: str) -> bool:
        """Whether it is a signal that may come from outside."""
        is_input = is_signal(what) and what in self._coming.inputs[agent.name]
        return is_input and self._coming.may_change(agent, what)


def end_of(activity: str) -> str:
    """What the end of an activity is called."""
    return f"end {activity}"


def name_of(item: Underway) -> str:
    """What is on its way: a channel, or the performative and the type of an agent message, or a loss."""
    if item.kind != "mail":
        return item.what
    acl = letter_of(item)
    return called(LOST) if acl is None else called(acl.performative, acl.message)


def called(performative: str, message: str = "") -> str:
    """What an agent message is called, or a loss."""
    return f"{performative} {message}"


def is_signal(what: str) -> bool:
    """Whether it is the channel of a signal."""
    return what.split(".")[1:2] == ["signal"]


@lru_cache(maxsize=64)
def related_in(plan: Plan) -> _Related:
    """What is there for one step, and what a way of that step may ask for beside it."""
    lines: dict[str, list[Transition]] = {}
    for item in plan.transitions:
        lines.setdefault(item.source, []).append(item)
    found: dict[str, frozenset[str]] = {}
    for item in plan.transitions:
        asked = frozenset(name for way in _on_from(plan, item, lines) for name in _asked(way))
        ended = frozenset(_ends(plan, item))
        for what in _asked(item):
            if is_signal(what) or "." not in what:
                found[what] = found.get(what, frozenset()) | (asked | ended) - {what}
    for what, others in [*found.items()]:  # it makes no difference which of them comes first
        for other in others:
            if is_signal(other) or "." not in other:
                found[other] = found.get(other, frozenset()) | {what}
    for what, other in _letters_in(plan):
        found[what] = found.get(what, frozenset()) | {other}
    return {what: others for what, others in found.items() if others}


def _letters_in(plan: Plan) -> Iterator[tuple[str, str]]:
    """Agent messages, and losses, of which two may be awaited at once: each two."""
    lines = [
        (item.source, called(LOST) if event[0] == "lost" else called(str(event[1]), str(event[2])))
        for item in plan.transitions
        for event in item.events
        if event[0] in ("received", "lost")
    ]
    for one, what in lines:
        for other, name in lines:
            if what != name and (is_in(one, other) or is_in(other, one)):
                yield what, name


@lru_cache(maxsize=64)
def first_in(plan: Plan) -> frozenset[str]:
    """The signals and events for which ways of the first step ask; a later step would not have these ways."""
    found: set[str] = set()
    todo = [plan.states[0].label]
    seen: set[str] = set()
    while todo:
        label = todo.pop()
        if label in seen:
            continue
        seen.add(label)
        state = plan.by_label[label]
        todo += [
            child.label for child in plan.children(label) if state.type == "AND" or child.type == "START"
        ]
        for item in plan.transitions:
            if item.source != label or item.kind != "external":
                continue
            if state.type in ("START", "CONDITION"):
                todo += plan.entries_of(item)
            elif not item.first:
                continue
            found.update(_asked(item))
    return frozenset(what for what in found if is_signal(what) or "." not in what)


def _on_from(
    plan: Plan, first: Transition, lines: Mapping[str, Sequence[Transition]]
) -> Iterator[Transition]:
    """A transition, and those that are taken at once behind it, at STARTs and CONDITIONs."""
    todo, seen = [first], {id(first)}
    while todo:
        item = todo.pop()
        yield item
        if item.kind != "external":
            continue
        entered = [*plan.entries_of(item)]
        while entered:
            label = entered.pop()
            state = plan.by_label[label]
            if state.type in ("START", "CONDITION"):
                further = [way for way in lines.get(label, ()) if id(way) not in seen]
                seen.update(map(id, further))
                todo += further
            else:
                entered += [
                    child.label
                    for child in plan.children(label)
                    if state.type == "AND" or child.type == "START"
                ]


def _ends(plan: Plan, item: Transition) -> Iterator[str]:
    """The activities for whose end a transition asks: for their outcomes, or what they write."""
    terms = [*terms_in((item.condition,))]
    variables = {str(term[1]).partition("@")[0] for term in terms if term[:1] == ("variable",)}
    for info in plan.activities:
        if ("outcome", info.name) in terms or not variables.isdisjoint(info.writes):
            yield end_of(info.name)


def _asked(item: Transition) -> Iterator[str]:
    """The channels and the events for which a transition asks."""
    for event in item.events:
        if event[0] == "raised":
            yield str(event[1])
    for term in terms_in((item.condition, *item.actions)):
        match term:
            case ("member", _, str() as channel, tuple()):
                yield channel


__all__ = ["Joining", "called", "end_of", "first_in", "is_signal", "name_of", "related_in"]
