"""Never: transitions that can not be taken again, as a variable holds a value that their condition excludes.

A participant that has ended in its mind, such as `ending != NONE`, waits for a last word only. Its other
lines are still there, but their conditions are false, and stay so: no line gives the variable another value
from there on.

That is sound because each answer is too wide rather than too narrow. Only variables count that lines alone
write, no activity and no module. One may hold what it holds now, and what any line writes that may still be
reached, also if conditions on the way exclude it. It may hold anything if a line writes more than a constant.
Everything else in a condition may be true or false. A transition is never taken if its condition is true for
none.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from enum import Enum

from aseme_dsl.proofs.explore.deciding.order import AnyNumber
from aseme_dsl.proofs.explore.deciding.staging import undecided
from aseme_dsl.runtime.chart.chart import Chart
from aseme_dsl.runtime.chart.plan import Plan, Variable, is_in

_BOTH = frozenset((True, False))
_ANY = object()


class Never:
    """Knows of one plan which transitions can never be taken again."""

    def __init__(self, plan: Plan, ahead: Callable[[str, str | None], frozenset[str]]) -> None:
        """`ahead` gives the states that may be active from a leaf on, up to the next entry of another."""
        self._plan = plan
        self._ahead = ahead
        of_modules = {name for module in plan.modules for name in module.variables}
        asked = {name for item in plan.transitions for name in _compared(item.condition)}
        free = undecided(plan)
        self._variables: Mapping[str, Variable] = {
            item.name: item
            for item in plan.variables
            if item.name in asked and item.name not in free and item.name.partition("@")[0] not in of_modules
        }
        """The variables that lines alone write, and that conditions compare with constants."""
        self._may_be: dict[tuple[str, str, str | None], frozenset[object] | None] = {}
        self._known: dict[tuple[object, ...], bool] = {}
        self._names: dict[int, tuple[str, ...]] = {}
        """The variables of which the condition of a transition asks."""

    def values(self, chart: Chart) -> tuple[object, ...]:
        """What the variables hold that say whether a transition can be taken again."""
        return tuple([_held(chart, name) for name in self._variables])

    def is_never(
        self,
        chart: Chart,
        number: int,
        leaf: str,
        scope: str | None,
        without: frozenset[str] = frozenset(),
    ) -> bool:
        """Whether a transition is not taken from a leaf on, up to the next entry of `scope`, for all
        values of the variables `without`."""
        condition = self._plan.transitions[number].condition
        if condition is None:
            return False
        names = self._names.get(number)
        if names is None:
            found_names = (name for name in _compared(condition) if name in self._variables)
            names = self._names[number] = tuple(dict.fromkeys(found_names))
        key = number, leaf, scope, without, tuple([_held(chart, name) for name in names])
        found = self._known.get(key)
        if found is None:
            found = self._known[key] = True not in self._truth(condition, chart, leaf, scope, without)
        return found

    def _truth(
        self, term: object, chart: Chart, leaf: str, scope: str | None, without: frozenset[str]
    ) -> frozenset[bool]:
        """What a condition may give."""
        match term:
            case ("&&" | "||" as word, *parts):
                every = [self._truth(part, chart, leaf, scope, without) for part in parts]
                ends = word == "||"  # the value of one part that decides
                may_end = any(ends in some for some in every)
                may_not = all((not ends) in some for some in every)
                return frozenset((*([ends] if may_end else []), *([not ends] if may_not else [])))
            case ("!", part):
                return frozenset(not value for value in self._truth(part, chart, leaf, scope, without))
            case ("==" | "!=" as word, ("variable", str() as name), constant) if _is_constant(constant):
                some = None if name in without else self._values(name, chart, leaf, scope)
                if some is None:
                    return _BOTH
                return frozenset((value == _constant(constant)) == (word == "==") for value in some)
            case ("variable", str() as name):
                some = None if name in without else self._values(name, chart, leaf, scope)
                return _BOTH if some is None else frozenset(bool(value) for value in some)
            case _:
                return _BOTH

    def _values(self, name: str, chart: Chart, leaf: str, scope: str | None) -> frozenset[object] | None:
        """What a variable may hold from a leaf on; None: anything."""
        if name not in self._variables:
            return None
        key = name, leaf, scope
        if key not in self._may_be:
            self._may_be[key] = self._written(self._variables[name], leaf, scope)
        written = self._may_be[key]
        held = _held(chart, name)
        return None if written is None or held is _ANY else written | {held}

    def _written(self, variable: Variable, leaf: str, scope: str | None) -> frozenset[object] | None:
        found: set[object] = set()
        own = variable.scope
        for item in self._plan.transitions:
            if item.source not in self._ahead(leaf, scope):
                continue
            for action in item.actions:
                if action[0] == "assign" and action[1] == variable.name:
                    if not _is_constant(action[2]):
                        return None
                    found.add(_constant(action[2]))
            enters = (
                own is not None
                and is_in(item.target, own)
                and not (is_in(item.source, own) and item.source != own and item.target != own)
            )
            if enters and own != scope:
                found.add(_plain(variable.initial))
        return frozenset(found)


def _compared(term: object) -> list[str]:
    match term:
        case ("==" | "!=", ("variable", str() as name), constant) if _is_constant(constant):
            return [name]
        case ("variable", str() as name):
            return [name]
        case ("&&" | "||" | "!", *parts):
            return [name for part in parts for name in _compared(part)]
        case _:
            return []


def _is_constant(term: object) -> bool:
    return isinstance(term, tuple) and term[:1] in (("const",), ("enum",))


def _constant(term: object) -> object:
    assert isinstance(term, tuple)
    return term[-1]


def _held(chart: Chart, name: str) -> object:
    return _plain(getattr(chart, chart.VARIABLES[name][0]))


def _plain(value: object) -> object:
    """A value as conditions write it: one of an enumeration as its number. To compare a number that may be
    any would decide something."""
    if type(value) is AnyNumber:
        return _ANY
    return value.value if isinstance(value, Enum) else value


__all__ = ["Never"]
