"""Faint: variables that make no difference, though lines read them.

A counter that is only given to an activity, or from which only itself is computed, decides nothing: no code
runs where a team is explored. That is so if each value that is made of it is surely there, and goes to an
activity or to another such variable.
"""

from __future__ import annotations

from aseme_dsl.runtime.chart.plan import Plan, terms_in

SCALARS = ("bool", "int", "double", "string")
"""The types whose variables always hold something."""


def faint_in(plan: Plan) -> frozenset[str]:
    """The variables of a plan that make no difference."""
    there = frozenset(item.name for item in plan.variables if item.type in SCALARS)
    free = {item.name for item in plan.variables if item.name in there and item.bounds is None}
    needed = _named_in([item.condition for item in plan.transitions])
    assigned: list[tuple[str, frozenset[str]]] = []
    for action in (action for item in plan.transitions for action in item.actions):
        match action:
            case ("assign", str() as name, value) if name in free and is_there(value, there):
                assigned.append((name, _named_in([value])))
            case _:
                needed |= _named_in([action])
    arguments = [term for state in plan.states for _, term in state.arguments]
    needed |= _named_in([term for term in arguments if not is_there(term, there)])
    while more := {name for to, names in assigned if to in needed for name in names} - needed:
        needed |= more
    return frozenset(free - needed)


def is_there(term: object, there: frozenset[str]) -> bool:
    """Whether a value is surely there, if the variables in `there` hold something. An action or a start of
    an activity does nothing without it."""
    match term:
        case ("const", value):
            return value is not None
        case ("enum", *_) | ("sender",):
            return True
        case ("variable", name):
            return name in there
        case ("%" | "/", part, ("const", int(number) | float(number))):
            return number != 0 and is_there(part, there)
        case ("==" | "!=" | "<" | "<=" | ">" | ">=" | "&&" | "||" | "!" | "+" | "-" | "*", *parts):
            return all(is_there(part, there) for part in parts)
        case _:
            return False


def _named_in(terms: list[object]) -> frozenset[str]:
    """The variables in some terms; an action names also the one that it changes."""
    found: set[str] = set()
    for term in terms_in(terms):
        match term:
            case ("variable" | "assign", str() as name, *_):
                found.add(name)
            case _:
                pass
    return frozenset(found)


__all__ = ["SCALARS", "faint_in", "is_there"]
