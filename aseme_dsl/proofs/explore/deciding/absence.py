"""Absence: the channels on which one message tells no more than that it may say anything.

A condition over a message that has not come is not true. Say that some content makes true none of the
conditions that an agent can look at before one has come. Then a message that may say anything does all that
no message does: it may hold that content. And no message does all that it does: one may come just now. So
there is no difference, and the agent need not be explored twice.

A condition without `!` before `&&` and `||` is true if enough of its parts are. With no message, the parts
that are about it are not true. So each of these parts has to be false for that content. A channel that is
asked for in any other way counts as one that makes a difference.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from typing import cast

from aseme_dsl.amola.expression import COMPARE, TURNED
from aseme_dsl.proofs.explore.deciding.ahead import ahead
from aseme_dsl.proofs.explore.deciding.order import Some
from aseme_dsl.proofs.explore.deciding.values import Values
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.functions import is_of_library
from aseme_dsl.runtime.chart.plan import Plan, Transition

Place = tuple[str, tuple[str, ...]]
"""A type of message and the path of a member, or a function (`name()`) and the empty path."""


@dataclass(frozen=True, slots=True)
class _Part:
    """A part of a condition that is about one message: its place is compared, and that has to be `wanted`."""

    place: Place
    wanted: bool
    sign: str = ""
    """A sign with which it is compared with `other`; else it is true or false itself."""
    other: object = None
    is_amount: bool = False
    """Whether its amount is compared."""

    def is_met(self, value: object) -> bool:
        """Whether the part helps to make its condition true if this stands in the place."""
        if value is None:
            return False
        if not self.sign:
            return bool(value) is self.wanted
        if self.is_amount:
            assert isinstance(value, int | float)
            value = abs(value)
        compare = cast("Callable[[object, object], bool]", COMPARE[self.sign])
        return compare(value, self.other) is self.wanted


def tells_absence(plan: Plan, channel: str, values: Values) -> bool:
    """Whether a role may tell that no message has come on a channel from one that may say anything."""
    early = frozenset(_early(plan, channel))
    arguments = [term for state in plan.states if state.label in early for _, term in state.arguments]
    lines = [item for item in plan.transitions if item.source in early]
    others = [*arguments, *(part for item in lines for part in (*item.actions, *item.events))]
    if any(_mentions(part, channel) for part in others):
        return True
    parts: list[_Part] = []
    for item in lines:
        for literal, wanted in _literals(item.condition, True):
            if _mentions(literal, channel):
                part = _part(literal, wanted, channel, plan)
                if part is None:
                    return True
                parts.append(part)
    for place in dict.fromkeys(part.place for part in parts):
        tried = [value for value in _tried(place, plan, values) if not isinstance(value, Some)]
        about = [part for part in parts if part.place == place]
        if not any(not any(part.is_met(value) for part in about) for value in tried):
            return True
    return False


def _early(plan: Plan, channel: str) -> Iterator[str]:
    """The states that may be active while no message has come on a channel."""
    return ahead(plan, plan.states[0].label, partial(_may_be_taken, channel), is_entered=True)


def _may_be_taken(channel: str, item: Transition) -> bool:
    """Whether the condition of a transition may be true with no message on a channel."""
    return item.condition is None or _may_be(item.condition, True, channel)


def _may_be(term: object, wanted: bool, channel: str) -> bool:
    match term:
        case ("!", part):
            return _may_be(part, not wanted, channel)
        case ("&&" | "||" as word, *parts):
            every = (word == "&&") is wanted
            return (all if every else any)(_may_be(part, wanted, channel) for part in parts)
        case ("has" | "holds", *_):
            return True
        case _:
            return not _mentions(term, channel)


def _literals(term: object, wanted: bool) -> Iterator[tuple[object, bool]]:
    """The parts of a condition, with what each of them has to be for it to be true."""
    match term:
        case None:
            return
        case ("!", part):
            yield from _literals(part, not wanted)
        case ("&&" | "||", *parts):
            for part in parts:
                yield from _literals(part, wanted)
        case _:
            yield term, wanted


def _mentions(term: object, channel: str) -> bool:
    if isinstance(term, tuple):
        return any(_mentions(part, channel) for part in term)
    return term == channel


def _part(literal: object, wanted: bool, channel: str, plan: Plan) -> _Part | None:
    """What a part of a condition asks of a message on a channel; None if that is not known."""
    place = _place(literal, channel, plan)
    if place is not None:
        return _Part(place, wanted)
    match literal:
        case (str() as sign, one, other) if sign in COMPARE:
            for value, against, word in ((one, other, sign), (other, one, TURNED.get(sign, sign))):
                match against:
                    case ("const" | "enum", *_, constant):
                        amount = _amount(value, channel)
                        if amount is not None:
                            return _Part(amount, wanted, word, constant, is_amount=True)
                        place = _place(value, channel, plan)
                        if place is not None:
                            return _Part(place, wanted, word, constant)
    return None


def _amount(term: object, channel: str) -> Place | None:
    match term:
        case ("builtin", "abs", ("member", None, str() as name, tuple() as path)) if name == channel and path:
            return channel.rpartition(".")[2], tuple(map(str, path))
    return None


def _place(term: object, channel: str, plan: Plan) -> Place | None:
    """A member of the message, or what a function of the document makes of it and of nothing else."""
    match term:
        case ("member", None, str() as name, tuple() as path) if name == channel and path:
            return channel.rpartition(".")[2], tuple(map(str, path))
        case ("call", str() as function, *given) if given:
            where = next((item[1] for item in plan.functions if item[0] == function), None)
            is_free = where is not None and all(_is_free(part, channel, where) for part in given)
            return (f"{function}()", ()) if is_free else None
    return None


def _is_free(given: object, channel: str, function: str) -> bool:
    """Whether a function may give anything for a message, or for a member of it."""
    match given:
        case ("member", None, str() as name, tuple() as path):
            return name == channel and not (path and is_of_library(function))
    return False


def _tried(place: Place, plan: Plan, values: Values) -> tuple[object, ...]:
    """What is tried for a place, each for itself; nothing if it is tried only with others."""
    name, path = place
    if path:
        tried = values.tried(name)
        known = None if tried is None or values.alike(name, path) is not None else tried.get(path)
        return known or ()
    kind = next(item[2] for item in plan.functions if f"{item[0]}()" == name)
    return (False, True) if kind == "bool" else values.results(name.removesuffix("()"), kind)


__all__ = ["tells_absence"]
