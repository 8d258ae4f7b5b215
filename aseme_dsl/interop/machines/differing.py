"""Differing: where a machine, written as a statechart, does something else than in its own engine.

In one step, each region of a statechart takes a transition, and sees what other regions write only in the
next step. An engine of SCXML takes one transition after the other, and none whose exits overlap with those
of an earlier one.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from aseme_dsl.interop.machines.machine import Assigning, Doing, Machine, Move, Node, Raising, around, matches
from aseme_dsl.interop.machines.places import is_and, is_inside, region_in

_WORD = re.compile(r"[A-Za-z_$][\w$]*")


def overtaken(node: Node, target: Node, move: Move) -> str:
    """Why a transition that leaves an AND is taken here and not there; "" if it is not.

    A region before that of its source may take a transition for the same event, and stay active.
    """
    for item in around(node):
        if not is_and(item):
            continue
        own = region_in(node, item)
        if is_inside(target, item) and region_in(target, item) is own:
            return ""
        for region in item.children[: item.children.index(own)]:
            for other in _within(region):
                if any(_meet(move, found) and _stays(other, found, region) for found in other.moves):
                    return f"{other.id} may take one in the same step; here both are taken"
    return ""


def _stays(node: Node, move: Move, region: Node) -> bool:
    """Whether a transition leaves and enters only states inside a region."""
    if not move.targets or (node is region and not move.is_internal):
        return False
    inside = {found.id for found in _within(region) if found is not region}
    return inside.issuperset(move.targets)


def unordered(machine: Machine) -> list[tuple[Node, str]]:
    """The states whose events come in another order here, each with the reason."""
    found: list[tuple[Node, str]] = []
    raised = [item for node in machine.nodes() for does in _doings(node) for item in does[0]]
    sent = [item for item in raised if isinstance(item, Raising) and item.is_sent]
    if sent and any(isinstance(item, Raising) and not item.is_sent for item in raised):
        found.append((machine.root, "events that are sent come after those that are raised; here in order"))
    for node in machine.nodes():
        if is_and(node):
            raising = [child for child in node.children if any(map(_raises_at_exit, _within(child)))]
            if len(raising) > 1:
                found.append((node, "the exits of its last region come first there, here those of its first"))
    return found


def _raises_at_exit(node: Node) -> bool:
    return any(isinstance(item, Raising) for item in node.exit)


def _within(node: Node) -> Iterator[Node]:
    waiting = [node]
    while waiting:
        found = waiting.pop()
        yield found
        waiting += found.children


def _meet(one: Move, other: Move) -> bool:
    """Whether two transitions may be enabled by the same event, or both by none."""
    if one.after is not None or other.after is not None:
        return False
    if not one.events or not other.events:
        return not one.events and not other.events
    return any(
        matches(first, second.removesuffix("*").removesuffix("."))
        or matches(second, first.removesuffix("*").removesuffix("."))
        for first in one.events
        for second in other.events
    )


def shared(machine: Machine, name: str) -> str:
    """Why a variable has other values here: regions use it that do not see each other's writes at once."""
    writes: list[tuple[Node, bool]] = []
    uses: list[tuple[Node, bool, bool]] = []
    for node in machine.nodes():
        for does, is_exit in _doings(node):
            for item in does:
                if isinstance(item, Assigning):
                    if item.variable == name:
                        writes.append((node, is_exit))
                    if item.variable == name or name in _WORD.findall(item.value):
                        uses.append((node, is_exit, True))
        for move in node.moves:
            if move.guard and name in _WORD.findall(move.guard):
                uses.append((node, False, not move.events or move.events[0].startswith("done.")))
    for writer, at_exit in {(id(node), is_exit): (node, is_exit) for node, is_exit in writes}.values():
        for user, is_exit, at_once in uses:
            if _are_apart(writer, user):
                return f"{writer.id} writes it, and {user.id} beside it sees that from the next step on"
            if _is_out_of(writer, user) and (at_exit or is_exit or at_once):
                return f"{writer.id} writes it, and {user.id} around it sees that from the next step on"
    return ""


def _doings(node: Node) -> Iterator[tuple[tuple[Doing, ...], bool]]:
    yield node.entry, False
    yield node.exit, True
    yield node.initial_does, False
    for move in node.moves:
        yield move.does, False


def _are_apart(one: Node, other: Node) -> bool:
    """Whether two states are in different regions of an AND."""
    for item in around(one):
        if is_and(item) and is_inside(other, item) and region_in(one, item) is not region_in(other, item):
            return True
    return False


def _is_out_of(inside: Node, outer: Node) -> bool:
    """Whether a state is in an AND that the other one is not in."""
    return any(is_and(item) and not is_inside(outer, item) for item in around(inside))


__all__ = ["overtaken", "shared"]
