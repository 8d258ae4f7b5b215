"""Unreached: the states and transitions of a plan that no run has reached, of those that one should."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Set

from aseme_dsl.runtime.chart.plan import Plan, Transition, is_in

_RARE = frozenset(("lost", "error", "after"))
"""Events of transitions that are there for what is not assumed, or for waits that end otherwise."""


def unreached(
    plan: Plan, visited: Set[str], taken: Set[int], spared: Set[int] = frozenset()
) -> Iterator[tuple[str, str]]:
    """The states and transitions that were not reached: the label of the state, or of the source, and what
    is said of it. Of the copies that a number makes, as in `(a . b)[8]`, one has to be. Transitions that are
    `spared` need not be."""
    first = _first_copies(plan)
    lines = [
        (first[item.source], first[item.target], item.kind, item.priority, item.at)
        for item in plan.transitions
    ]
    passed = {first[label] for label in visited}
    passed |= {first[plan.transitions[number].source] for number in taken}
    passed |= {first[plan.transitions[number].target] for number in taken}
    done = {lines[number] for number in taken}
    for state in plan.states:
        if state.type == "BASIC" and first[state.label] not in passed:
            yield state.label, f"state {plan.called(state)}"
    for number, item in enumerate(plan.transitions):
        is_left = lines[number] not in done and number not in spared
        if is_left and first[item.source] in passed and _is_expected(plan, item):
            yield item.source, f"`{' '.join(item.text.split())}` ({item.at})"


def missing_partner(plans: Collection[Plan]) -> str:
    """A participant that these plans talk with and that none of them plays; empty if there is none."""
    played = {(info.protocol, info.participant) for plan in plans for info in plan.branches}
    return next(
        (
            f"{name} of {info.protocol}"
            for plan in plans
            for info in plan.branches
            if info.sends or info.receives
            for name, least, _ in info.participants
            if least and (info.protocol, name) not in played
        ),
        "",
    )


def lines_of(plan: Plan, protocol: str, file: str) -> Iterator[int]:
    """The transitions of a plan that a file has written for a protocol."""
    for info in plan.branches:
        if info.protocol == protocol:
            for number, item in enumerate(plan.transitions):
                if is_in(item.source, info.label) and item.at.split(":")[0] == file:
                    yield number


def _first_copies(plan: Plan) -> dict[str, str]:
    """The states by their labels, with those in the first of the copies in which they are."""
    regions: dict[str, str] = {}
    for state in plan.states:
        if state.type == "AND":
            inside = [item.label for item in plan.states if item.parent == state.label]
            if len({_shape(plan, label) for label in inside}) == 1:
                regions |= dict.fromkeys(inside, inside[0])
    found: dict[str, str] = {}
    for state in plan.states:
        label = ""
        for part in state.label.split("."):
            label = f"{label}.{part}" if label else part
            label = regions.get(label, label)
        found[state.label] = label
    return found


def _shape(plan: Plan, region: str) -> tuple[tuple[str, str], ...]:
    """The states in a region, with where they are written: the same in copies alone."""
    return tuple((item.label[len(region) :], item.at) for item in plan.states if is_in(item.label, region))


def _is_expected(plan: Plan, item: Transition) -> bool:
    """Whether a written transition should be taken in some run, once its source is reached."""
    if not item.text or item.kind not in ("external", "on"):
        return False
    kinds = {str(event[0]) for event in item.events}
    words = {str(event[1]) for event in item.events if event[0] == "received"}
    if kinds & _RARE or "not_understood" in words or "cancel" in words:
        return False
    return not (item.text.startswith("reactive ") and _stays(plan, item))


def _stays(plan: Plan, item: Transition) -> bool:
    """Whether a reactive choice keeps what is active, as its condition asks for that."""
    around = [state for state in plan.states if is_in(item.source, state.label)]
    names = frozenset(name for state in around for name in (state.name, state.activity) if name)
    return _holds(item.condition, names) is False


def _holds(term: object, active: frozenset[str]) -> bool | None:
    """Whether a condition holds where these states are active; None: it may, or may not."""
    match term:
        case ("&&" | "||" as word, *parts):
            ends = word == "||"  # the value of one part that decides
            found = {_holds(part, active) for part in parts}
            return ends if ends in found else None if None in found else not ends
        case ("!", part):
            found_inside = _holds(part, active)
            return None if found_inside is None else not found_inside
        case ("holds", part):
            return _holds(part, active)
        case ("in", name) if name in active:
            return True
        case _:
            return None


__all__ = ["lines_of", "missing_partner", "unreached"]
