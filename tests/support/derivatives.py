"""The language of a liveness formula by derivatives: which words of completed activities it allows.

Independent of any statechart. A formula is a nested tuple; `after(formula, activity)` is what remains of it
when that activity has completed (Brzozowski's derivative, with the shuffle of `||`).

    ("do", "A")   A completes        ("seq", p, q)   p, then q      ("loop", p)     p, any number of times
    DONE          nothing remains    ("either", p…)  one of them    ("forever", p)  p, without end
    NEVER         no word at all     ("both", p, q)  interleaved
"""

from __future__ import annotations

from functools import cache
from typing import Any

from aseme_dsl.amola.liveness import Formula
from aseme_dsl.amola.operators import Operator

Language = tuple[Any, ...]

DONE: Language = ("done",)
NEVER: Language = ("never",)


def language(formula: Formula, named: dict[str, Formula] | None = None) -> Language:
    """The language of a formula whose names are activities, or formulas in `named`. For small formulas."""
    parts = [language(operand, named) for operand in formula.operands]
    match formula.operator:
        case Operator.NAME:
            inside = (named or {}).get(formula.name)
            return ("do", formula.name) if inside is None else language(inside, named)
        case Operator.GROUP:
            return parts[0]
        case Operator.OPTION:
            return either(DONE, parts[0])
        case Operator.SEQUENCE:
            return _chain(seq, parts)
        case Operator.CHOICE:
            return either(*parts)
        case Operator.PARALLEL:
            return _chain(both, parts)
        case Operator.INSTANCES:
            return _chain(both, parts * formula.count)
        case Operator.ZERO_OR_MORE:
            return ("loop", parts[0])
        case Operator.ONE_OR_MORE:
            return seq(parts[0], ("loop", parts[0]))
        case Operator.FOREVER:
            return ("forever", parts[0])


def _chain(join: Any, parts: list[Language]) -> Language:
    whole = parts[-1]
    for part in reversed(parts[:-1]):
        whole = join(part, whole)
    return whole


def seq(first: Language, then: Language) -> Language:
    if NEVER in (first, then):
        return NEVER
    if first == DONE:
        return then
    return first if then == DONE else ("seq", first, then)


def both(one: Language, other: Language) -> Language:
    if NEVER in (one, other):
        return NEVER
    if one == DONE:
        return other
    return one if other == DONE else ("both", one, other)


def either(*parts: Language) -> Language:
    flat: set[Language] = set()
    for part in parts:
        flat.update(part[1:] if part[0] == "either" else [part])
    flat.discard(NEVER)
    if not flat:
        return NEVER
    return flat.pop() if len(flat) == 1 else ("either", *sorted(flat, key=repr))


@cache
def may_end(language: Language) -> bool:
    """Whether the empty word is in the language: everything may be complete."""
    match language:
        case ("done",) | ("loop", _):
            return True
        case ("seq" | "both", one, other):
            return may_end(one) and may_end(other)
        case ("either", *parts):
            return any(map(may_end, parts))
    return False


@cache
def after(language: Language, activity: str) -> Language:
    """What remains when `activity` has completed; NEVER if it may not be the next to complete."""
    match language:
        case ("do", name):
            return DONE if name == activity else NEVER
        case ("seq", one, other):
            found = seq(after(one, activity), other)
            return either(found, after(other, activity)) if may_end(one) else found
        case ("both", one, other):
            return either(both(after(one, activity), other), both(one, after(other, activity)))
        case ("either", *parts):
            return either(*(after(part, activity) for part in parts))
        case ("loop" | "forever", body):
            return seq(after(body, activity), language)
    return NEVER


def words(start: Language, activities: list[str], longest: int) -> tuple[set[str], set[str]]:
    """All words up to a length that may be begun, and those of them with which everything may be complete.

    Activities are single letters.
    """
    begun: set[str] = set()
    ended: set[str] = set()
    waiting = [("", start)]
    while waiting:
        word, rest = waiting.pop()
        begun.add(word)
        if may_end(rest):
            ended.add(word)
        if len(word) < longest:
            for name in activities:
                following = after(rest, name)
                if following != NEVER:
                    waiting.append((word + name, following))
    return begun, ended
