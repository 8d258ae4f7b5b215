"""Conversations: follows the conversations of a run, and shows each of them the clauses of its protocol."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import field

from aseme_dsl.play.scenario import Condition, Expectation, InPlaces
from aseme_dsl.play.sight.alarms import Alarms
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.plan import is_in
from aseme_dsl.runtime.monitor.rules import State, Verdict, View, deadline, ended, seen
from aseme_dsl.runtime.trace.records import Record

Place = tuple[str, str]
"""An agent, and the label of one of its protocol branches."""


@dataclass(slots=True)
class _Talk:
    """A conversation: who takes part, and how far each clause of its protocol has come."""

    places: set[Place] = field(default_factory=set)
    states: dict[int, State] = field(default_factory=dict)
    held: frozenset[int] = frozenset()
    """The conditions that held last."""


class Clauses:
    """Watches the expectations that hold in each conversation of a protocol. `broken` are those that do not,
    with their states when they were broken first."""

    def __init__(
        self, expectations: Sequence[Expectation], conditions: Sequence[Condition], alarms: Alarms
    ) -> None:
        self._alarms = alarms
        self._clauses = {
            number: item for number, item in enumerate(expectations) if item.protocol is not None
        }
        self._conditions = {
            number: item for number, item in enumerate(conditions) if isinstance(item, InPlaces)
        }
        self._talks: dict[str, _Talk] = {}
        self._of: dict[Place, list[_Talk]] = {}
        """The conversations in which an agent takes part with a branch."""
        self._due: dict[int, _Talk] = {}
        """Those in which a clause awaits something by a moment: time alone changes no other."""
        self._early: dict[Place, set[str]] = {}
        """What was entered in a branch that is in no conversation yet."""
        self._active: dict[str, frozenset[str]] = {}
        self.broken: dict[int, State] = {}

    def __bool__(self) -> bool:
        return bool(self._clauses)

    def step(
        self, agent: str, branches: Iterable[str], entered: frozenset[str], active: frozenset[str], now: int
    ) -> None:
        """An agent with these protocol branches has made a step."""
        self._active[agent] = active
        for branch in branches:
            inside = {label for label in entered if is_in(label, branch)}
            talks = self._of.get((agent, branch), [])
            for talk in talks:
                self._look(talk, {agent: inside}, now, now)
            if not talks and inside:
                self._early.setdefault((agent, branch), set()).update(inside)

    def crash(self, agent: str, now: int) -> None:
        """An agent has stopped dead: it is in no state."""
        self._active[agent] = frozenset()
        for place in list(self._of):
            if place[0] == agent:
                for talk in self._of[place]:
                    self._look(talk, {}, now, now)

    def conversation(self, record: Record, protocol: str, now: int) -> None:
        """An agent opens, joins, or leaves a conversation of a protocol."""
        place = record["agent"], record["branch"]
        name = record["conversation"]
        if record["what"] in ("open", "join"):
            talk = self._talks.get(name)
            if talk is None:
                mine = (number for number, item in self._clauses.items() if item.protocol == protocol)
                talk = self._talks[name] = _Talk(states={number: State() for number in mine})
            if place not in talk.places:
                talk.places.add(place)
                self._of.setdefault(place, []).append(talk)
            self._look(talk, {place[0]: self._early.pop(place, set())}, now, now)
        elif record["what"] == "leave" and name in self._talks:
            self._early.pop(place, None)
            talk = self._talks[name]
            if place in talk.places:
                talk.places.discard(place)
                self._of[place].remove(talk)
                self._look(talk, {}, now, now)

    def rest(self, first: int, last: int) -> None:
        """Nothing happens from `first` to `last`."""
        for talk in list(self._due.values()):
            self._look(talk, {}, first, last, rests=True)

    def look(self, now: int) -> None:
        """Time alone may have changed something."""
        for talk in list(self._due.values()):
            self._look(talk, {}, now, now)

    def is_awaited(self, number: int, moment: int) -> bool:
        """Whether something that a clause speaks of has still to come in some conversation."""
        states = (talk.states[number] for talk in self._talks.values() if number in talk.states)
        return any(
            state.verdict is Verdict.OPEN
            and ended(self._clauses[number].rule, state, moment).verdict is Verdict.BROKEN
            for state in states
        )

    def _look(
        self, talk: _Talk, entered: Mapping[str, set[str]], first: int, last: int, rests: bool = False
    ) -> None:
        holds: set[int] = set()
        occurs: set[int] = set()
        for number, item in self._conditions.items():
            inside = sum(
                any(is_in(label, branch) and label in item.places.get(agent, ()) for label in active)
                for agent, branch in talk.places
                for active in (self._active.get(agent, frozenset()),)
            )
            if inside >= item.least:
                holds.add(number)
            is_new = any(not labels.isdisjoint(item.places.get(name, ())) for name, labels in entered.items())
            if is_new if item.least == 1 else inside >= item.least and number not in talk.held:
                occurs.add(number)
        talk.held = frozenset(holds)
        view = View(first, last, frozenset(holds), frozenset(occurs), rests=rests)
        for number, state in talk.states.items():
            self._take(talk, number, seen(self._clauses[number].rule, state, view))
        rules = ((self._clauses[number].rule, state) for number, state in talk.states.items())
        if any(deadline(rule, state) is not None for rule, state in rules):
            self._due[id(talk)] = talk
        else:
            self._due.pop(id(talk), None)

    def _take(self, talk: _Talk, number: int, state: State) -> None:
        if state is talk.states[number]:
            return
        talk.states[number] = state
        self._alarms.mind((id(talk), number), self._clauses[number].rule, state)
        if state.verdict is Verdict.BROKEN:
            self.broken.setdefault(number, state)


__all__ = ["Clauses"]
