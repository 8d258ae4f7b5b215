"""Lists: variables that hold agents in a text, as functions of the library write it.

Such a text is empty, or has a line for each agent, with a number. It may be that nothing asks for the numbers
but `ranked`, which is given a new one of each message. Then an agent may get any place: there is always a
number between two others. Two equal ones allow no more than two that are not. So no numbers are tried.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable

from aseme_dsl.proofs.explore.deciding.staging import undecided
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.plan import Plan, Transition, is_in, terms_in, terms_of
from aseme_dsl.runtime.library import agents

_MODULE = f"{agents.__name__}:"
_WRITE = ("with_agent", "ranked", "without")
Place = tuple[str, tuple[str, ...]]


@dataclass(frozen=True, slots=True)
class Ranked:
    """A call of `ranked` that is all that a line writes to a list."""

    term: object
    source: str
    variable: str
    member: Place | None
    """The member of the message that the line takes which gives the number, if one does."""
    branches: frozenset[str] = frozenset()
    """The parts in protocols in which the line stands, by their labels."""


class Lists:
    """Knows the lists of agents of one plan."""

    def __init__(self, plan: Plan) -> None:
        self._plan = plan
        self._called = {
            name: target.removeprefix(_MODULE)
            for name, target, *_ in plan.functions
            if target.startswith(_MODULE)
        }
        terms = [*terms_of(plan)]
        set_ = {name for _, name, _ in plan.settings}
        free = undecided(plan) | {name for module in plan.modules for name in module.variables}
        self.names = frozenset(
            item.name
            for item in plan.variables
            if item.type == "string"
            and item.initial == ""
            and not ({item.name, item.name.partition("@")[0]} & (set_ | free))
            and self._is_list(item.name, terms)
        )
        """The variables that hold nothing else."""

    def function(self, term: object) -> str:
        """The function about lists that a term calls; empty if it calls none."""
        match term:
            case ("call", str() as name, *_):
                return self._called.get(name, "")
            case _:
                return ""

    def _is_list(self, name: str, terms: list[tuple[object, ...]]) -> bool:
        """Whether a variable is given nothing but a list or nothing, and is asked for as a list."""
        own = "variable", name
        places = known = writes = 0
        for term in terms:
            places += sum(part == own for part in term)
            match term:
                case ("call", _, first, *rest) if first == own and self.function(term):
                    known += own not in rest
                case ("==" | "!=", one, other) if own in (one, other):
                    known += ("const", "") in (one, other)
                case ("assign", target, value) if target == name:
                    if value == ("const", ""):
                        continue
                    if self.function(value) not in _WRITE or _given(value)[0] != own:
                        return False
                    writes += 1
                case _:
                    pass
        return places == known and writes > 0

    def is_first(self, term: object) -> bool:
        """Whether a term is the first agent of a list, or None: a line surely gives it to a variable."""
        if self.function(term) != "first_of":
            return False
        first = _given(term)[0]
        return first[:1] == ("variable",) and len(first) == 2 and first[1] in self.names

    # ---- numbers that nothing asks for ---------------------------------------------------------

    def ranked(self) -> tuple[Ranked, ...]:
        """All calls of `ranked`."""
        return tuple(
            self._ranked(item, term)
            for item in self._plan.transitions
            for term in terms_in([item.condition, *item.actions])
            if self.function(term) == "ranked"
        ) + tuple(
            Ranked(term, state.label, "", None)
            for state in self._plan.states
            for term in terms_in([value for _, value in state.arguments])
            if self.function(term) == "ranked"
        )

    def _ranked(self, item: Transition, term: tuple[object, ...]) -> Ranked:
        whole = [str(action[1]) for action in item.actions if action[0] == "assign" and action[2] == term]
        taken = {str(event[2]) if event[0] == "received" else "" for event in item.events}
        variable = whole[0] if len(whole) == 1 and whole[0] in self.names else ""
        parts = [info for info in self._plan.branches if is_in(item.source, info.label)]
        is_one = all(info.size_of(info.participant)[1] == 1 for info in parts)  # none else gets the message
        branches = frozenset(info.label for info in parts)
        match term:
            case ("call", _, _, _, ("taken", tuple() as path)) if (
                path and is_one and len(taken) == 1 and "" not in taken
            ):
                member = taken.pop(), tuple(map(str, path))
                return Ranked(term, item.source, variable, member, branches)
            case _:
                return Ranked(term, item.source, variable, None, branches)

    def _are_apart(self, one: Ranked, two: Ranked) -> bool:
        """Whether two calls never rank the same message in two lists."""
        if one.variable == two.variable:
            return not self._plan.are_concurrent(one.source, two.source)
        # Each conversation has messages of its own.
        return bool(one.branches and two.branches) and not one.branches & two.branches

    def free(self, is_read: Callable[[Place], bool], is_given: Callable[[Place], bool]) -> frozenset[str]:
        """The function by which an agent may get any place in a list, if there is one. `is_read` says whether
        anything else asks for what stands in a place, and `is_given` whether lines have to do with it."""
        calls = self.ranked()
        numbers = (name for name, called in self._called.items() if called == "number_of")
        if (
            not calls
            or not all(self._are_apart(one, two) for one in calls for two in calls)
            or any(
                not item.variable or item.member is None or is_read(item.member) or is_given(item.member)
                for item in calls
            )
            or any(is_read((f"{name}()", ())) for name in numbers)
        ):
            return frozenset()
        return frozenset(name for name, called in self._called.items() if called == "ranked")


def entries_of(listed: str) -> list[tuple[float, str]]:
    """The agents in a list, with their numbers."""
    return [(float(number), name) for number, name in map(json.loads, listed.splitlines())]


def list_of(entries: Iterable[tuple[float, str]]) -> str:
    """The list of these agents with their numbers."""
    return "\n".join(json.dumps(item) for item in entries)


def placed(listed: str, who: str, place: int) -> str:
    """A list in which an agent has this place among the others."""
    rest = [item for item in entries_of(listed) if item[1] != who]
    return list_of((*rest[:place], (0.0, who), *rest[place:]))


def _given(term: object) -> tuple[tuple[object, ...], ...]:
    """What a function is given."""
    assert isinstance(term, tuple)
    return term[2:]


__all__ = ["Lists", "entries_of", "list_of", "placed"]
