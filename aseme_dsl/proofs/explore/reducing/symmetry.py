"""Symmetry: agents that may change places, as nothing tells one from another but what each has done.

Others that have one role may all do the same (see `Others`). The agent that is explored only asks whether two
names are equal, or where they stand in a list. Then it does the same with other names. So one state stands
for all that differ in the names alone. The names stand in it in an order that depends on where they occur.

That does not hold if a line, a setting or an assumption names one of them, or asks for the order of texts.
Nor if one of them alone is chosen for a participant: that is the first one in the team. A name that stands
in a state anywhere but in a variable for an agent, or in a list of agents, keeps its place.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from enum import Enum

from aseme_dsl.proofs.explore.deciding.lists import Lists, entries_of, list_of
from aseme_dsl.proofs.explore.deciding.staging import undecided
from aseme_dsl.proofs.explore.deciding.values import Values
from aseme_dsl.runtime.agent.agent import Agent
from aseme_dsl.runtime.chart.functions import is_of_library
from aseme_dsl.runtime.chart.plan import Plan, terms_of

_ORDER = ("<", "<=", ">", ">=")
_NUMBERS = ("int", "double", "duration")
_COMPUTED = ("+", "-", "*", "/", "//", "%", "neg", "duration", "count", "invited", "answered", "age", "index")
"""Terms that are numbers."""
_READING = (("taken",), ("member",), ("variable",), ("element",), ("contains",), ("find",), ("new",))
"""Terms with the path of a member."""
_LIBRARY = "aseme_dsl.runtime.library."
_KNOWN = tuple(f"{_LIBRARY}{name}:" for name in ("agents", "math", "resources", "soccer", "time"))
"""The functions of the library that ask no more of a text than whether it is equal to another one."""
_SIMPLE = (type(None), bool, int, float)

Occurrence = tuple[int, int, float]
"""Where a name stands: in which variable, at which place of a list, and with which number."""


class Symmetry:
    """Lets the names stand in the chart of the agent that is explored in an order of their own."""

    def __init__(
        self,
        agent: Agent,
        groups: Sequence[Sequence[str]],
        values: Values,
        mentions: Callable[[str], Iterable[str]],
    ) -> None:
        """The agents in each of the groups may change places. `mentions` gives the names in a text."""
        self._chart = chart = agent.chart
        self._groups = groups
        self._mentions = mentions
        lists = Lists(agent.plan).names
        types = {item.name: item.type for item in agent.plan.variables}
        self._agents: list[str] = []
        """The attributes that hold an agent."""
        self._lists: list[str] = []
        """Those that hold a list of agents."""
        for variable, slots in chart.VARIABLES.items():
            places = [f"held_{slot}" if f"held_{slot}" in chart.places else slot for slot in slots]
            if types[variable] == "agent":
                self._agents += places
            elif variable in lists:
                self._lists += places
        known = {*self._agents, *self._lists}
        self._rest = tuple(name for name in chart.places if name not in known)
        self._decides = _decides(agent.plan, values, {name for some in groups for name in some})
        """Whether names may come into the state in other ways than with messages and their senders."""
        self._alike: dict[str, int] = {}
        """For each name that may change places now, the first one with which it may."""
        self._read: dict[str, list[tuple[float, str]]] = {}

    # ---- between two moves -------------------------------------------------------------------

    def settle(self, fixed: Collection[str]) -> bool:
        """Let the names stand in their order, but for those that are fixed; whether something has changed."""
        names = self._names(fixed)
        found = self._occurrences()
        other: dict[str, str] = {}
        for some in names:
            ordered = sorted(some, key=lambda name: (name not in found, found.get(name, ())))
            other |= {name: place for name, place in zip(ordered, some, strict=True) if name != place}
        if not other:
            return False
        chart = self._chart
        for place in self._agents:
            value = getattr(chart, place)
            if type(value) is str and value in other:
                setattr(chart, place, other[value])
        for place in self._lists:
            value = getattr(chart, place)
            if type(value) is str and value:
                entries = self._entries(value)
                if any(name in other for _, name in entries):
                    renamed = [(number, other.get(name, name)) for number, name in entries]
                    setattr(chart, place, list_of(renamed))
        return True

    def _names(self, fixed: Collection[str]) -> list[list[str]]:
        """The names of each group that may change places."""
        kept = {*fixed, *self._elsewhere()}
        return [[name for name in some if name not in kept] for some in self._groups]

    def _elsewhere(self) -> Iterator[str]:
        """The names in other attributes of the chart."""
        for place in self._rest:
            value = getattr(self._chart, place)
            if not isinstance(value, (*_SIMPLE, Enum)):
                yield from self._mentions(value if type(value) is str else repr(value))
        for place in self._agents:
            value = getattr(self._chart, place)
            if type(value) is not str:
                yield from self._mentions(repr(value))

    def _occurrences(self) -> Mapping[str, tuple[Occurrence, ...]]:
        """Where the names stand."""
        found: dict[str, list[Occurrence]] = {}
        for number, place in enumerate(self._agents):
            value = getattr(self._chart, place)
            if type(value) is str:
                found.setdefault(value, []).append((number, 0, 0.0))
        for number, place in enumerate(self._lists, len(self._agents)):
            value = getattr(self._chart, place)
            if type(value) is str:
                for index, (by, name) in enumerate(self._entries(value)):
                    found.setdefault(name, []).append((number, index, by))
        return {name: tuple(some) for name, some in found.items()}

    def _entries(self, listed: str) -> list[tuple[float, str]]:
        if listed not in self._read:
            self._read[listed] = entries_of(listed)
        return self._read[listed]

    # ---- within a move -----------------------------------------------------------------------

    def begin(self, fixed: Collection[str]) -> None:
        """A move is made."""
        self._alike = {}
        if not self._decides:
            there = self._occurrences()
            for number, some in enumerate(self._names(fixed)):
                self._alike |= {name: number for name in some if name not in there}

    def others(self, names: Sequence[str], came: Collection[str]) -> Sequence[str]:
        """Of some agents, those with which a move is not the same. Of those that stand nowhere yet, and have
        not spoken in the move (`came`), that is the first one of each group."""
        known: set[int] = set()
        found: list[str] = []
        for name in names:
            group = None if name in came else self._alike.get(name)
            if group is None or group not in known:
                found.append(name)
            if group is not None:
                known.add(group)
        return found


def groups_of(
    agent: Agent, others: Sequence[Agent], messages: Mapping[str, type[object]], has: object
) -> tuple[tuple[str, ...], ...]:
    """The agents that may change places, so that the one that is explored does the same; `has` is what is
    assumed that it hears."""
    plan = agent.plan
    found: dict[str, list[Agent]] = {}
    for other in others:
        found.setdefault(other.role, []).append(other)
    if plan.chooses or _asks_for_order(plan) or not all(map(_is_known, plan.functions)):
        return ()
    said, named = _said(plan, messages, has)
    return tuple(
        tuple(other.name for other in group)
        for group in found.values()
        if len(group) > 1
        and not any(_is_single(plan, other) for other in group)
        and all(other.name.isascii() and other.name.isidentifier() for other in group)
        and not any(other.name in named or any(other.name in text for text in said) for other in group)
    )


def _asks_for_order(plan: Plan) -> bool:
    """Whether a line may ask which of two texts comes first."""
    types = {item.name: item.type for item in plan.variables}
    results = {name: kind for name, _, kind, _ in plan.functions}

    def is_number(term: object) -> bool:
        match term:
            case ("const", value):
                return isinstance(value, int | float)
            case ("variable", str() as name):
                return types.get(name) in _NUMBERS
            case ("call", str() as name, *_):
                return results.get(name) in _NUMBERS
            case (str() as word, *_):
                return word in _COMPUTED
            case _:
                return False

    return any(
        len(term) == 3 and term[0] in _ORDER and not (is_number(term[1]) or is_number(term[2]))
        for term in terms_of(plan)
    )


def _is_known(function: tuple[str, str, str, str]) -> bool:
    """Whether a function does the same with other names."""
    return not function[1].startswith(_LIBRARY) or function[1].startswith(_KNOWN)


def _said(plan: Plan, messages: Mapping[str, type[object]], has: object) -> tuple[list[str], set[str]]:
    """The texts of a plan, of what messages hold by themselves, and of what is assumed; and the words of the
    plan."""
    said = [repr(has), *(repr(value) for _, _, value in plan.settings)]
    said += [repr(item.initial) for item in plan.variables]
    said += [repr(info.busy) for info in plan.branches]
    said += [repr(kind()) for kind in messages.values()]
    named: set[str] = set()
    for term in terms_of(plan):
        if term[:1] == ("const",):
            said += [part for part in term[1:] if isinstance(part, str)]
        else:
            named |= {part for part in term if isinstance(part, str)}
    return said, named


def _is_single(plan: Plan, other: Agent) -> bool:
    """Whether one of several agents like another one takes part in what the plan does."""
    parts = {(info.protocol, info.participant) for info in other.plan.branches}
    return any(
        most == 1 and (info.protocol, name) in parts
        for info in plan.branches
        for name, _, most in info.participants
    )


def _decides(plan: Plan, values: Values, names: Collection[str]) -> bool:
    """Whether one of the names may be decided for what a variable, a message or a function gives."""
    free = undecided(plan)
    given = [(item.type, item.name.partition("@")[0]) for item in plan.variables if item.name in free]
    given += [(kind, f"{name}()") for name, target, kind, _ in plan.functions if not is_of_library(target)]
    looked_at = {part for term in terms_of(plan) if term[:1] in _READING for part in term}
    return any(values.may_name(kind, (name, ())) for kind, name in given) or any(
        path is None or path in looked_at for path in values.naming(names)
    )


__all__ = ["Symmetry", "groups_of"]
