"""Differing: where a machine, written as a statechart, does something else than in its own engine.

In one step, each region of a statechart takes a transition, and sees what other regions write only in the
next step. An engine of SCXML takes one transition after the other, and none whose exits overlap with those
of an earlier one.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from aseme_dsl.interop.machines.machine import Assigning, Doing, Machine, Move, Node, Raising, around, matches
from aseme_dsl.interop.machines.places import by_id, is_and, is_inside, is_region, region_in
from aseme_dsl.records import dataclass

_WORD = re.compile(r"[A-Za-z_$][\w$]*")


@dataclass(frozen=True, slots=True)
class _Use:
    """Where a variable is used or written: the state, and when that sees what others write."""

    node: Node
    is_exit: bool
    is_at_once: bool


class Differing:
    """A machine, looked through once: which of its transitions stay in a region, and who uses a variable."""

    def __init__(self, machine: Machine) -> None:
        known = by_id(machine)
        self.staying: dict[tuple[str, str], list[tuple[int, Node, Move]]] = {}
        """By an AND and the first word of an event: the transitions inside one of its regions."""
        self.writes: dict[str, dict[tuple[str, bool], _Use]] = {}
        """By a variable, and then by region: where it is written; of several states of a region the first."""
        self.uses: dict[str, dict[tuple[str, bool, bool], _Use]] = {}
        self.places: dict[str, int] = {}
        """The place of each region among those of its AND."""
        for node in machine.nodes():
            if is_and(node):
                self.places |= {child.id: place for place, child in enumerate(node.children)}
            for region in (item for item in (node, *around(node)) if is_region(item)):
                assert region.parent is not None
                for move in node.moves:
                    if _stays(node, move, region, known):
                        for word in _first_words(move):
                            inside = self.staying.setdefault((region.parent.id, word), [])
                            inside.append((self.places[region.id], node, move))
            self._look(node)

    def _look(self, node: Node) -> None:
        """Note who writes and uses variables. What is in the same region sees the same."""
        region = next((item.id for item in (node, *around(node)) if is_region(item)), "")

        def used(text: str, *, is_exit: bool, is_at_once: bool) -> None:
            for name in dict.fromkeys(_WORD.findall(text)):
                found = self.uses.setdefault(name, {})
                found.setdefault((region, is_exit, is_at_once), _Use(node, is_exit, is_at_once))

        for does, is_exit in _doings(node):
            for item in does:
                if isinstance(item, Assigning):
                    found = self.writes.setdefault(item.variable, {})
                    found.setdefault((region, is_exit), _Use(node, is_exit, True))
                    used(f"{item.variable} {item.value}", is_exit=is_exit, is_at_once=True)
        for move in node.moves:
            if move.guard:
                at_once = not move.events or move.events[0].startswith("done.")
                used(move.guard, is_exit=False, is_at_once=at_once)

    def shared(self, name: str) -> str:
        """Why a variable has other values here: regions use it that do not see each other's writes at once.

        "" if it has the same values.
        """
        for writer in self.writes.get(name, {}).values():
            for user in self.uses.get(name, {}).values():
                if _are_apart(writer.node, user.node):
                    said = f"{user.node.id} beside it"
                elif _is_out_of(writer.node, user.node) and (
                    writer.is_exit or user.is_exit or user.is_at_once
                ):
                    said = f"{user.node.id} around it"
                else:
                    continue
                return f"{writer.node.id} writes it, and {said} sees that from the next step on"
        return ""

    def overtaken(self, node: Node, target: Node, move: Move) -> str:
        """Why a transition that leaves an AND is taken here and not there; "" if it is not.

        A region before that of its source may take a transition for the same event, and stay active.
        """
        for item in around(node):
            if not is_and(item):
                continue
            own = region_in(node, item)
            if is_inside(target, item) and region_in(target, item) is own:
                return ""
            place = self.places[own.id]
            words = _first_words(move)
            if _ANY in words:
                words = {word for parallel, word in self.staying if parallel == item.id and word}
            for word in sorted({*words, *([_ANY] if move.events else [])}):
                for before, other, found in self.staying.get((item.id, word), ()):
                    if before < place and _meet(move, found):
                        return f"{other.id} may take one in the same step; here both are taken"
        return ""


_ANY = "*"


def _first_words(move: Move) -> set[str]:
    """The first words of the events of a transition; "" if it needs none, nothing if it waits for a while.

    What meets another one has a first word in common with it, or is for any event.
    """
    if move.after is not None:
        return set()
    return {item.split(".", 1)[0].removesuffix("*") or _ANY for item in move.events} or {""}


def _stays(node: Node, move: Move, region: Node, known: dict[str, Node]) -> bool:
    """Whether a transition leaves and enters only states inside a region."""
    if not move.targets or (node is region and not move.is_internal):
        return False
    return all(is_inside(known[target], region) for target in move.targets)


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


__all__ = ["Differing", "unordered"]
