"""Alike: values of a variable that no line can tell apart.

A counter that only grows, and is only asked whether it is above 0, is as good at 2 as at 7. An ending that
is compared with two of its values is one of these, or another. So one value stands for all of its kind.

That holds of variables that lines alone write, and of which nothing is asked but how they compare with
constants. A line gives them a constant or, if they are whole numbers, adds one to what they hold. Where a
line waits for news of a variable, each value is another one.
"""

from __future__ import annotations

from collections.abc import Iterator
from enum import Enum

from aseme_dsl.proofs.explore.deciding.staging import undecided
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.chart import Chart
from aseme_dsl.runtime.chart.plan import Plan, Transition, Variable, terms_in, terms_of

_OTHER = ("bool", "double", "string", "agent")
"""Types that are neither whole numbers nor those of enums."""
_COMPARISONS = ("==", "!=", "<", "<=", ">", ">=")


@dataclass(frozen=True, slots=True)
class _Asked:
    """The constants with which a variable is compared, and whether a line adds something to it."""

    constants: frozenset[int]
    grows: bool


class Alike:
    """Knows of one plan which values of its variables are alike."""

    def __init__(self, plan: Plan, kept: frozenset[str]) -> None:
        """Something else asks for what is called as in `kept`."""
        free = undecided(plan) | {name for module in plan.modules for name in module.variables}
        news = {name for item in plan.transitions for name in _news_of(item)}
        found = {
            item.name: _asked(plan, item)
            for item in plan.variables
            if item.bounds is None and not ({item.name, item.name.partition("@")[0]} & (kept | free | news))
        }
        self._asked = {name: asked for name, asked in found.items() if asked is not None}

    def forget(self, chart: Chart) -> None:
        """Let one value stand for all that are alike."""
        for name, asked in self._asked.items():
            for slot in chart.VARIABLES.get(name, ()):
                value = getattr(chart, slot)
                if isinstance(value, Enum):
                    if value.value not in asked.constants:
                        others = (item for item in type(value) if item.value not in asked.constants)
                        setattr(chart, slot, next(others))
                elif type(value) is int and asked.grows:
                    most = max(asked.constants, default=-1) + 1
                    if value > most:
                        setattr(chart, slot, most)


def _waits_for_news(item: Transition) -> bool:
    """Whether a line is taken again only when there is news."""
    hears = any(event[0] in ("received", "lost") for event in item.events)
    return item.kind == "on" and (item.when or not hears)


def _news_of(item: Transition) -> Iterator[str]:
    """The variables of which a line waits for news; not those to which it gives nothing but constants, as it
    is news of these alone for which it waits then."""
    if not _waits_for_news(item):
        return
    assigns = [action for action in item.actions if action[0] == "assign"]
    given = {action[1] for action in assigns} - {
        action[1] for action in assigns if _constant(action[2]) is None
    }
    for term in terms_in([item.condition]):
        if term[:1] == ("variable",) and term[1] not in given:
            yield str(term[1])


def _given(plan: Plan, name: str) -> Iterator[int]:
    """The constants that a line gives to a variable and then waits for others."""
    for item in plan.transitions:
        if _waits_for_news(item):
            for action in item.actions:
                if action[:2] == ("assign", name) and (number := _constant(action[2])) is not None:
                    yield number


def _asked(plan: Plan, variable: Variable) -> _Asked | None:
    """What is asked of a variable; None if that is more than how it compares with constants."""
    is_number = variable.type == "int"
    if not is_number and (variable.type in _OTHER or variable.type.startswith("list of ")):
        return None
    own = "variable", variable.name
    constants = {*_given(plan, variable.name)}
    places = known = 0
    grows = False
    for term in terms_of(plan):
        places += sum(part == own for part in term)
        match term:
            case (str() as word, one, other) if word in _COMPARISONS and own in (one, other):
                against = _constant(other if one == own else one)
                if against is None or not (is_number or word in ("==", "!=")):
                    return None
                constants.add(against)
                known += 1
            case ("assign", name, value) if name == variable.name:
                if is_number and _adds(own, value):
                    grows = True
                    known += 1
                elif _constant(value) is None:
                    return None
            case _:
                pass
    return _Asked(frozenset(constants), grows) if places == known else None


def _adds(own: tuple[str, str], value: object) -> bool:
    """Whether a value is what a variable holds, and something more."""
    match value:
        case ("+", one, other) if own in (one, other):
            more = _constant(other if one == own else one)
            return more is not None and more > 0
        case _:
            return False


def _constant(term: object) -> int | None:
    """The whole number, or the number of the enum value, that a term is."""
    match term:
        case ("const", int(number)) if type(number) is int:
            return number
        case ("enum", _, _, int(number)):
            return number
        case _:
            return None


__all__ = ["Alike"]
