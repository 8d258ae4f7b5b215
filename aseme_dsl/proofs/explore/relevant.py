"""Relevant: what of a statechart can still make a difference where it stands; the rest is forgotten.

A variable that nothing reads before it is written anew is the same in all states. So are a timer that
nothing asks for, and the time since a state was entered that has been left.
"""

from __future__ import annotations

from collections.abc import Iterator

from aseme_dsl.runtime.chart.chart import Chart
from aseme_dsl.runtime.chart.plan import Plan, is_in, terms_in

_UNKNOWN = object()


class Relevant:
    """Knows of one plan what is relevant at each leaf."""

    def __init__(self, plan: Plan, kept: frozenset[str]) -> None:
        """What is called as in `kept` is always relevant."""
        self._plan = plan
        self._kept = kept
        self._ahead: dict[tuple[str, str | None], frozenset[str]] = {}
        self._most: dict[str, int | None] = {}
        self._gone: dict[tuple[str, ...], tuple[tuple[str, object], ...]] = {}
        """What makes no difference, by the active leaves."""
        self._asks: dict[str, tuple[frozenset[str], frozenset[str]]] = {}

    def forget(self, chart: Chart, unknown: object) -> None:
        """Give what is not relevant values that are the same everywhere; `unknown` for variables."""
        leaves = chart.configuration()
        known = self._gone.get(leaves)
        if known is None:
            known = self._gone[leaves] = tuple(self._find(chart, leaves))
        for slot, value in known:
            setattr(chart, slot, unknown if value is _UNKNOWN else value)
        for label, slot in chart.COUNTS.items():
            most = self._counted(label)
            if most is not None and getattr(chart, slot) > most:
                setattr(chart, slot, most)
        if any(board is not None and board.timers for board in chart.boards()):
            self._forget_timers(chart, leaves)

    def _find(self, chart: Chart, leaves: tuple[str, ...]) -> Iterator[tuple[str, object]]:
        """The attributes that make no difference at these leaves, with what they hold from now on."""
        for name, slots in chart.VARIABLES.items():
            if not self._reads(name, leaves):
                yield from ((slot, _UNKNOWN) for slot in slots)
        for label, slot in chart.TIMES.items():
            if not any(is_in(leaf, label) for leaf in leaves):
                yield slot, 0
        for number, (mark, past) in chart.MARKS.items():
            if not any(is_in(leaf, self._plan.transitions[number].source) for leaf in leaves):
                if mark:
                    yield mark, None
                if past:
                    yield past, -1

    def _counted(self, label: str) -> int | None:
        """The count of a state from which on more makes no difference; None if there is no such one."""
        if label not in self._most:
            names = {self._plan.by_label[label].name, label}
            self._most[label] = _bound(
                [part for item in self._plan.transitions for part in (item.condition, *item.actions)], names
            )
        return self._most[label]

    def _reads(self, variable: str, leaves: tuple[str, ...]) -> bool:
        name = variable.partition("@")[0]
        if name in self._kept:
            return True
        scope = next((item.scope for item in self._plan.variables if item.name == variable), None)
        return any(
            variable in self._asked(label)[0] or name in self._asked(label)[0]
            for leaf in leaves
            for label in self._from(leaf, scope)
        )

    def _forget_timers(self, chart: Chart, leaves: tuple[str, ...]) -> None:
        names = {name for board in chart.boards() if board is not None for name in board.timers}
        for name in names:
            if name in self._kept or any(
                name in self._asked(label)[1] for leaf in leaves for label in self._from(leaf, None)
            ):
                continue
            for board in chart.boards():
                if board is not None:
                    board.timers.pop(name, None)

    def _from(self, leaf: str, scope: str | None) -> frozenset[str]:
        """The states that may be active from a leaf on, up to the next entry of `scope`."""
        key = leaf, scope if scope is not None and is_in(leaf, scope) else None
        if key not in self._ahead:
            self._ahead[key] = frozenset(_reached(self._plan, leaf, key[1]))
        return self._ahead[key]

    def _asked(self, label: str) -> tuple[frozenset[str], frozenset[str]]:
        """The variables and timers that the transitions of a state, and its activity, ask for."""
        found = self._asks.get(label)
        if found is None:
            terms: list[object] = [term for _, term in self._plan.by_label[label].arguments]
            for item in self._plan.transitions:
                if item.source == label:
                    terms += [item.condition, *(_parts(action) for action in item.actions)]
            found = self._asks[label] = _names(terms)
        return found


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


def _names(terms: list[object]) -> tuple[frozenset[str], frozenset[str]]:
    variables: set[str] = set()
    timers: set[str] = set()
    for term in terms_in(terms):
        if term[:1] == ("variable",):
            variables.add(str(term[1]))
        elif term[:1] == ("expired",):
            timers.add(str(term[1]))
    return frozenset(variables), frozenset(timers)


def _reached(plan: Plan, leaf: str, scope: str | None) -> Iterator[str]:
    todo = [(leaf, False)]
    seen: set[tuple[str, bool]] = set()
    while todo:
        label, is_entered = todo.pop()
        if (label, is_entered) in seen:
            continue
        seen.add((label, is_entered))
        yield label
        state = plan.by_label[label]
        if state.parent is not None:
            todo.append((state.parent, False))
        if is_entered and state.type in ("AND", "OR"):
            todo += [
                (child.label, True)
                for child in plan.children(label)
                if state.type == "AND" or child.type == "START"
            ]
        for item in plan.transitions:
            if item.source != label or item.target == scope:
                continue
            todo.append((item.target, item.kind == "external"))
            if item.kind == "external":
                todo += [(other, True) for other in plan.entries_of(item)]
            if item.resume:
                todo += [(other.label, True) for other in plan.states if is_in(other.label, item.target)]


__all__ = ["Relevant"]
