"""Relevant: what of a statechart can still make a difference where it stands; the rest is forgotten.

A variable that nothing reads before it is written anew is the same in all states. So are a timer that
nothing asks for, and the time since a state was entered that has been left. What only those transitions ask
for that can never be taken again makes no difference, either, nor does a variable that is `faint`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from enum import Enum, auto
from functools import cached_property
from itertools import accumulate

from aseme_dsl.proofs.explore.deciding.ahead import ahead
from aseme_dsl.proofs.explore.deciding.lists import Lists
from aseme_dsl.proofs.explore.reducing.faint import SCALARS, faint_in, is_there
from aseme_dsl.proofs.explore.reducing.never import Never
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.chart import Chart
from aseme_dsl.runtime.chart.plan import Plan, is_in, terms_in

_UNKNOWN = object()
_COUNTING = (("invited",), ("answered",), ("all_answered",))


class _Reads(Enum):
    """Whether something asks for a variable."""

    YES = auto()
    IN_VAIN = auto()
    NO = auto()


class Relevant:
    """Knows of one plan what is relevant at each leaf."""

    def __init__(self, plan: Plan, kept: frozenset[str]) -> None:
        """What is called as in `kept` is always relevant."""
        self._plan = plan
        self._kept = kept
        self._ahead: dict[tuple[str, str | None], frozenset[str]] = {}
        self._most: dict[str, int | None] = {}
        self._never = Never(plan, self._from)
        self._gone: dict[tuple[object, ...], _Gone] = {}
        """What makes no difference, by the active leaves and the values of variables that lines write."""
        self._asks: dict[int | str, _Names] = {}
        self._in_states: dict[str, _Names] = {}
        """What the activities of states from a leaf on ask for."""
        self._who: dict[tuple[str, str], tuple[str | None, tuple[int | str, ...]]] = {}
        self._fresh: Chart | None = None
        self._faint = faint_in(plan)
        self._there = frozenset(
            item.name for item in plan.variables if item.type in SCALARS and item.bounds is None
        )
        """The variables that always hold something, and can hold any value of their type."""
        self._is_first = Lists(plan).is_first

    def forget(self, chart: Chart, unknown: object) -> None:
        """Give what is not relevant values that are the same everywhere; `unknown` for variables."""
        leaves = chart.configuration()
        key = leaves, *self._never.values(chart)
        known = self._gone.get(key)
        if known is None:
            known = self._gone[key] = self._find(chart, leaves)
        for slot, value in known.slots:
            setattr(chart, slot, unknown if value is _UNKNOWN else value)
        for label, slot in chart.COUNTS.items():
            most = self._counted(label)
            if most is not None and getattr(chart, slot) > most:
                setattr(chart, slot, most)
        if known.is_round_over and chart.rounds:
            chart.rounds.load(())
        for board in chart.boards():
            if board is not None:
                for name in [name for name in board.timers if name not in known.timers]:
                    del board.timers[name]

    def _find(self, chart: Chart, leaves: tuple[str, ...]) -> _Gone:
        """What makes no difference at these leaves."""
        asked = _joined(self._asked_from(chart, leaves))
        return _Gone(tuple(self._slots(chart, leaves)), asked.timers | self._kept, not asked.counts_answers)

    def _slots(self, chart: Chart, leaves: tuple[str, ...]) -> Iterator[tuple[str, object]]:
        """The attributes that make no difference at these leaves, with what they hold from now on."""
        active = frozenset(label for leaf in leaves for label in _around(leaf))
        dropped: set[str] = set()
        for name, slots in chart.VARIABLES.items():
            reads = self._reads(chart, name, leaves, frozenset((*dropped, name)))
            if reads is not _Reads.YES:
                dropped.add(name)
                # What is looked at in vain holds something that can be looked at.
                yield from (
                    (slot, _UNKNOWN if reads is _Reads.NO else self._initial(chart, slot)) for slot in slots
                )
        for label, slot in chart.TIMES.items():
            if label not in active or self._is_timeless(chart, label, leaves):
                yield slot, 0
        for number, (mark, past) in chart.MARKS.items():
            source = self._plan.transitions[number].source
            if source not in active or self._is_never(chart, number, leaves, source):
                if mark:
                    yield mark, None
                if past:
                    yield past, -1

    def _is_timeless(self, chart: Chart, label: str, leaves: tuple[str, ...]) -> bool:
        """Whether no time since an active state was entered makes a difference until it is entered again."""
        timed = [
            number
            for number, item in enumerate(self._plan.transitions)
            if item.source == label and any(event[0] == "after" for event in item.events)
        ]
        return (
            bool(timed)
            and label not in chart.WITHIN
            and all(self._is_never(chart, number, leaves, label) for number in timed)
        )

    def _is_never(self, chart: Chart, number: int, leaves: tuple[str, ...], scope: str | None) -> bool:
        return all(self._never.is_never(chart, number, leaf, scope) for leaf in leaves)

    def _counted(self, label: str) -> int | None:
        """The count of a state from which on more makes no difference; None if there is no such one."""
        if label not in self._most:
            names = {self._plan.by_label[label].name, label}
            self._most[label] = _bound(
                [part for item in self._plan.transitions for part in (item.condition, *item.actions)], names
            )
        return self._most[label]

    def _reads(self, chart: Chart, variable: str, leaves: tuple[str, ...], without: frozenset[str]) -> _Reads:
        """Whether something asks for a variable; in vain if only transitions do that are not taken, for all
        values of the variables `without`."""
        name = variable.partition("@")[0]
        if name in self._kept:
            return _Reads.YES
        if variable in self._faint:
            return _Reads.IN_VAIN
        found = _Reads.NO
        for leaf in leaves:
            known = self._who.get((variable, leaf))
            scope, askers = known or self._askers(variable, name, leaf)
            for place in askers:
                if isinstance(place, str) or not self._never.is_never(chart, place, leaf, scope, without):
                    return _Reads.YES
                found = _Reads.IN_VAIN
        return found

    def _askers(self, variable: str, name: str, leaf: str) -> tuple[str | None, tuple[int | str, ...]]:
        """The scope of a variable; and from a leaf on, the transitions and activities that ask for it."""
        plan = self._plan
        scope = next((item.scope for item in plan.variables if item.name == variable), None)
        ahead = self._from(leaf, scope)
        places: list[int | str] = [state.label for state in plan.states if state.label in ahead]
        places += [number for number, item in enumerate(plan.transitions) if item.source in ahead]
        asking = [place for place in places if not {variable, name}.isdisjoint(self._asked(place).variables)]
        found = self._who[variable, leaf] = scope, tuple(asking)
        return found

    def _initial(self, chart: Chart, slot: str) -> object:
        """What an attribute holds in a new chart."""
        if self._fresh is None:
            self._fresh = type(chart)(chart.PLAN.name)
        return getattr(self._fresh, slot)

    def _asked_from(self, chart: Chart, leaves: tuple[str, ...]) -> Iterator[_Names]:
        """What is asked for from these leaves on, of timers and answers."""
        for leaf in leaves:
            if leaf not in self._in_states:
                self._in_states[leaf] = _joined(map(self._asked, self._from(leaf, None)))
            yield self._in_states[leaf]
        for number, source in self._telling:
            if any(source in self._from(leaf, None) for leaf in leaves) and not self._is_never(
                chart, number, leaves, None
            ):
                yield self._asked(number)

    @cached_property
    def _telling(self) -> tuple[tuple[int, str], ...]:
        """The transitions that ask for timers or answers, with their sources."""
        return tuple(
            (number, item.source)
            for number, item in enumerate(self._plan.transitions)
            if self._asked(number).timers or self._asked(number).counts_answers
        )

    def _from(self, leaf: str, scope: str | None) -> frozenset[str]:
        """The states that may be active from a leaf on, up to the next entry of `scope`."""
        key = leaf, scope if scope is not None and is_in(leaf, scope) else None
        if key not in self._ahead:
            self._ahead[key] = frozenset(
                ahead(self._plan, leaf, lambda item: item.target != key[1], is_entered=False)
            )
        return self._ahead[key]

    def _asked(self, place: int | str) -> _Names:
        """What a transition, or the activity of a state, asks for."""
        found = self._asks.get(place)
        if found is None:
            if isinstance(place, str):
                found = _names([term for _, term in self._plan.by_label[place].arguments])
            else:
                item = self._plan.transitions[place]
                found = _joined(
                    [_names([item.condition]), *_asked_by(item.actions, self._there, self._is_first)]
                )
            self._asks[place] = found
        return found


@dataclass(frozen=True, slots=True)
class _Names:
    """The variables and timers that something asks for, and whether it asks who has answered."""

    variables: frozenset[str] = frozenset()
    timers: frozenset[str] = frozenset()
    counts_answers: bool = False


@dataclass(frozen=True, slots=True)
class _Gone:
    """What makes no difference: attributes, with what they hold from now on; timers but these; rounds."""

    slots: tuple[tuple[str, object], ...]
    timers: frozenset[str]
    is_round_over: bool


def _around(leaf: str) -> Iterator[str]:
    """The labels of a state, and of those around it."""
    return accumulate(leaf.split("."), "{}.{}".format)


def _joined(some: Iterable[_Names]) -> _Names:
    variables: set[str] = set()
    timers: set[str] = set()
    counts = False
    for item in some:
        variables |= item.variables
        timers |= item.timers
        counts |= item.counts_answers
    return _Names(frozenset(variables), frozenset(timers), counts)


def _asked_by(
    actions: Sequence[tuple[object, ...]], there: frozenset[str], is_first: Callable[[object], bool]
) -> Iterator[_Names]:
    """What actions read that they have surely not written before; `there` are the variables that always hold
    something. A value that `is_first` of a list of agents is written in any case."""
    written: set[str] = set()
    for action in actions:
        found = _names([_parts(action)])
        yield replace(found, variables=found.variables - written)
        if action[0] == "assign" and (
            is_first(action[2]) or (action[1] in there and is_there(action[2], there))
        ):
            written.add(str(action[1]))


def _bound(terms: list[object], names: set[str]) -> int | None:
    """One more than the greatest constant with which a count of states of these names is compared."""
    most = 0
    while terms:
        term = terms.pop()
        match term:
            case ("==" | "!=" | "<" | "<=" | ">" | ">=", ("count", str() as name), ("const", int(number))) | (
                "==" | "!=" | "<" | "<=" | ">" | ">=",
                ("const", int(number)),
                ("count", str() as name),
            ):
                if name in names:
                    most = max(most, number + 1)
            case ("count", str() as name):
                if name in names:
                    return None
            case tuple():
                terms += term
            case _:
                pass
    return most


def _parts(action: tuple[object, ...]) -> tuple[object, ...]:
    """What an action reads."""
    return ("", *action[2:]) if action[0] == "assign" else action


def _names(terms: list[object]) -> _Names:
    variables: set[str] = set()
    timers: set[str] = set()
    counts = False
    for term in terms_in(terms):
        if term[:1] == ("variable",):
            variables.add(str(term[1]))
        elif term[:1] == ("expired",):
            timers.add(str(term[1]))
        counts |= term[:1] in _COUNTING
    return _Names(frozenset(variables), frozenset(timers), counts)


__all__ = ["Relevant"]
