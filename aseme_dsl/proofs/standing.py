"""Standing: what is true whenever an agent is in a state, by the form of its statechart alone.

At the end of a step nothing is enabled. So while a state is active, no `when` that leaves it is true. And
what the conditions on all ways into it have read is there, since a state message does not go away. From both
follows what the newest messages say, without a search.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import field
from typing import cast

from aseme_dsl.amola.expression import COMPARE, TURNED
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.plan import Plan, Transition, is_in, terms_in

Path = tuple[str, ...]
Known = Mapping[str, Mapping[Path, object]]
"""What members of messages hold, by channel and path, if such a message is there."""

_RAISES = frozenset(("call", "/", "//", "%", "element", "at", "mean"))
"""What may raise: then a condition does not hold, also if what is beside it is true."""

_Atoms = frozenset[tuple[object, bool]]
"""Terms that are true or false."""


@dataclass(frozen=True, slots=True)
class Said:
    """What is known of the newest message of a channel with states: members, and its age (ns) at the most."""

    channel: str
    members: tuple[tuple[Path, object], ...]
    age: int | None


# ---- which states there may be ------------------------------------------------------------------------


def reached(plan: Plan, known: Known) -> frozenset[str]:
    """The states in which an agent may ever be; the others are behind conditions that are never true."""
    found: set[str] = set()
    todo = [state.label for state in plan.states if state.parent is None]
    possible = [item for item in plan.transitions if _may_be(item.condition, True, known)]
    while todo:
        label = todo.pop()
        if label in found:
            continue
        found.add(label)
        state = plan.by_label[label]
        if state.parent is not None:
            todo.append(state.parent)
        todo += [
            child.label for child in plan.children(label) if state.type == "AND" or child.type == "START"
        ]
        for item in possible:
            if item.source == label:
                todo += [*item.targets, *plan.entries_of(item)]
    return frozenset(found)


def _may_be(term: object, value: bool, known: Known) -> bool:
    """Whether a condition may have this value."""
    match term:
        case ("&&", *parts):
            return (all if value else any)(_may_be(part, value, known) for part in parts)
        case ("||", *parts):
            return (any if value else all)(_may_be(part, value, known) for part in parts)
        case ("!", inner):
            return _may_be(inner, not value, known)
        case ("const", bool(held)):
            return held is value
        case (str() as sign, one, other) if sign in COMPARE:
            left, right = _held(one, known), _held(other, known)
            if left is None or right is None or type(left[0]) is not type(right[0]):
                return True
            return COMPARE[sign](cast(float, left[0]), cast(float, right[0])) is value
        case _:
            return True


def _held(term: object, known: Known) -> tuple[object] | None:
    """What a term holds, if that is known."""
    match term:
        case ("const", value):
            return (value,)
        case ("member", None, str() as channel, tuple() as path) if _path(path) in known.get(channel, {}):
            return (known[channel][_path(path)],)
        case _:
            return None


# ---- what is true in a state --------------------------------------------------------------------------


def said_in(
    plan: Plan, label: str, known: Known, is_optional: Callable[[str, Path], bool]
) -> tuple[Said, ...]:
    """What is known of the newest messages whenever a state is active between two steps.

    `is_optional` says whether a member of a message on a channel may be absent.
    """
    there = _there(plan, label, known)
    atoms: set[tuple[object, bool]] = set()
    for item in plan.transitions:
        if _leaves_at_once(plan, item, label):
            atoms |= _if(item.condition, False)
    found = {channel: _Saying() for channel in there}
    for term, value in atoms:
        if not any(is_optional(channel, path) for channel, path in _read(term)):
            _note(found, there, term, value, known)
    return tuple(
        Said(channel, tuple(sorted(item.members.items())), item.age)
        for channel, item in sorted(found.items())
    )


def _there(plan: Plan, label: str, known: Known) -> frozenset[str]:
    """The channels of which there is a message whenever a state is active."""
    state = plan.by_label[label]
    around = None if state.parent is None else plan.by_label[state.parent]
    if state.type == "START" or around is None or around.type == "AND":
        return frozenset()  # it is entered together with what is around it
    if any(
        item.resume and (is_in(label, item.target) or is_in(item.target, label)) for item in plan.transitions
    ):
        return frozenset()
    ways = [
        item
        for item in plan.transitions
        if not is_in(item.source, label)
        and any(is_in(target, label) for target in (*item.targets, *plan.entries_of(item)))
        and _may_be(item.condition, True, known)
    ]
    region = _region_of(plan, label)
    found: list[frozenset[str]] = []
    for item in ways:
        is_beside = _region_of(plan, item.source) == region and item.condition is not None
        atoms = _if(item.condition, True) if is_beside else frozenset()
        found.append(frozenset(channel for term, _ in atoms for channel, _ in _read(term)))
    return frozenset.intersection(*found) if found else frozenset()


def _leaves_at_once(plan: Plan, item: Transition, label: str) -> bool:
    """Whether a transition leaves a state as soon as its condition is true."""
    return (
        item.when
        and not item.events
        and item.every is None
        and item.weight is None
        and item.kind == "external"
        and item.condition is not None
        and is_in(label, item.source)
        and _region_of(plan, label) == _region_of(plan, item.source)
        and all(plan.by_label[target].type != "CONDITION" for target in item.targets)
        and not any(term and term[0] in _RAISES for term in terms_in([item.condition]))
    )


def _region_of(plan: Plan, label: str) -> str:
    """The region whose blackboard the conditions of a state read."""
    state = plan.by_label[label]
    while state.parent is not None and plan.by_label[state.parent].type != "AND":
        state = plan.by_label[state.parent]
    return state.label


def _if(term: object, value: bool) -> _Atoms:
    """What is so if a condition has this value, where nothing that it reads is absent."""
    match term:
        case ("!", inner):
            return _if(inner, not value)
        case ("&&" | "||" as word, *parts):
            found = [_if(part, value) for part in parts]
            together = (word == "&&") is value
            return (
                frozenset[tuple[object, bool]]().union(*found)
                if together
                else found[0].intersection(*found[1:])
            )
        case _:
            return frozenset(((term, value),))


@dataclass(slots=True)
class _Saying:
    members: dict[Path, object] = field(default_factory=dict)
    age: int | None = None


def _note(found: dict[str, _Saying], there: frozenset[str], term: object, value: bool, known: Known) -> None:
    """What a term that has a value says of the messages that are there."""
    match term:
        case (str() as sign, one, other) if sign in COMPARE and all(
            channel in there for channel, _ in _read(term)
        ):
            for word, left, right in ((sign, one, other), (TURNED.get(sign, sign), other, one)):
                match left, right:
                    case ("age", ("member", None, str() as channel, ())), ("const", int(age)):
                        if word in (("<", "<=") if value else (">", ">=")):
                            item, most = found[channel], age + (word in ("<=", ">"))  # when it steps again
                            item.age = most if item.age is None else min(most, item.age)
                    case ("member", None, str() as channel, tuple() as path), _:
                        held = _held(right, known)
                        if held is not None and word == ("==" if value else "!="):
                            found[channel].members[_path(path)] = held[0]
                    case _:
                        pass
        case ("member", None, str() as channel, tuple() as path) if path and channel in there:
            found[channel].members[_path(path)] = value
        case _:
            pass


def _read(term: object) -> Iterator[tuple[str, Path]]:
    """The members of states that have to be there for a term to be true or false, with their channels."""
    match term:
        case ("member", None, str() as channel, tuple() as path) if channel.split(".")[1] == "state":
            yield channel, _path(path)
        case ("age", inner):
            yield from _read(inner)
        case (str() as sign, one, other) if sign in COMPARE:
            yield from _read(one)
            yield from _read(other)
        case _:
            pass


def _path(path: Iterable[object]) -> Path:
    return tuple(map(str, path))


__all__ = ["Known", "Said", "reached", "said_in"]
