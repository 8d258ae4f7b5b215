"""What is done at each number of a region, and how the number that it has is found."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import field

from aseme_dsl.codegen.code.tree import (
    Arm,
    Block,
    Const,
    Expr,
    If,
    Name,
    Negated,
    Set,
    compared,
    own,
    when,
    within,
)
from aseme_dsl.records import dataclass


@dataclass(frozen=True, slots=True)
class Body:
    """What a round does while a region has one of these numbers, which are called `begins` to `ends`.

    `label` is that of the leaf with the first of them.
    """

    first: int
    last: int
    label: str
    begins: str
    ends: str
    block: Block
    is_and: bool = False

    @property
    def title(self) -> str:
        """The numbers for people."""
        return self.begins if self.begins == self.ends else f"{self.begins} to {self.ends}"


@dataclass(slots=True)
class Untouched:
    """What is done in a region, leaf by leaf, with an event that nothing there waits for.

    It is the same for all such events. In `all` of them, those of a leaf begin at `first`, and such as do
    the same as their neighbours at `starts`.
    """

    pieces: list[list[Body] | None] = field(default_factory=list)
    all: list[Body] = field(default_factory=list)
    first: list[int] = field(default_factory=list)
    starts: list[int] = field(default_factory=list)

    def join(self) -> None:
        """Find the neighbours that do the same."""
        for of in self.pieces:
            self.first.append(len(self.all))
            self.all += of or ()
        self.first.append(len(self.all))
        same = (n for n in range(1, len(self.all)) if self.all[n].block != self.all[n - 1].block)
        self.starts = [0, *same, len(self.all)]

    def between(self, begin: int, end: int) -> Iterator[Body]:
        """The bodies from one leaf to before another."""
        place, last = self.first[begin], self.first[end]
        run = bisect_right(self.starts, place)
        while place < last:
            until = min(self.starts[run], last)
            yield joined(self.all[place], self.all[until - 1]) if until - place > 1 else self.all[place]
            place, run = until, run + 1


def merged(bodies: Iterable[Body]) -> list[Body]:
    """Bodies, neighbours that do the same as one."""
    found: list[Body] = []
    for body in bodies:
        if found and found[-1].block == body.block:
            found[-1] = joined(found[-1], body)
        else:
            found.append(body)
    return found


def joined(one: Body, other: Body) -> Body:
    """Neighbours that do the same as one."""
    return Body(one.first, other.last, one.label, one.begins, other.ends, one.block)


def dispatch(region: int, bodies: Sequence[Body]) -> Block:
    """Find the body of the active leaf by comparisons; halves where there are many."""
    filled = [body for body in bodies if body.block]
    if not filled:
        return ()
    if len(bodies) == 1:
        return bodies[0].block
    place = own(f"r{region}")
    if len(bodies) == 2:
        return (_either(place, *bodies),)
    if len(filled) == 1:
        return tree(place, bodies)
    local = Name(f"r{region}")
    return (Set((local,), place), *tree(local, bodies))


def tree(place: Expr, bodies: Sequence[Body]) -> Block:
    """Find the body of the number in a place by comparisons; halves where there are many."""
    if not any(body.block for body in bodies):
        return ()
    if len(bodies) == 1:
        return bodies[0].block
    return (_found(place, bodies),)


def _found(place: Expr, bodies: Sequence[Body]) -> If:
    """One of several bodies, of which some do something."""
    filled = [body for body in bodies if body.block]
    if len(bodies) == 2:
        return _either(place, *bodies)
    is_held = filled[-1] is bodies[-1] and bodies[-1].is_and and len(filled) > 1
    if len(filled) <= 3 and not is_held:
        return _one_by_one(place, bodies)
    # A statechart stays long in an AND: one comparison is to lead there.
    middle = len(bodies) - 1 if is_held else len(bodies) // 2
    begins = Const(bodies[middle].first)
    lower = tree(place, bodies[:middle])
    if not lower:
        return when(compared(place, ">=", begins), *tree(place, bodies[middle:]))
    below = Arm(compared(place, "<", begins), lower)
    if is_held:
        return If((below,), bodies[-1].block, bodies[-1].title)
    if not any(body.block for body in bodies[middle:]):
        return If((below,))
    upper = _found(place, bodies[middle:])
    return If((below, *upper.arms), upper.otherwise, upper.note)


def _either(place: Expr, one: Body, other: Body) -> If:
    """One of two bodies; truth is the cheapest comparison."""
    alone = one.first == 0 and other.first == 1
    later = place if alone else compared(place, ">", Const(one.last))
    if not one.block:
        return _only(later, other)
    if not other.block:
        return _only(Negated(place) if alone else compared(place, "<", Const(other.first)), one)
    return If((Arm(later, other.block, other.title),), one.block, one.title)


def _only(test: Expr, body: Body) -> If:
    """A body that is the only one of two with anything in it.

    If all of it is for when something has changed, that is asked first: it is the rarer thing.
    """
    match body.block:
        case (If(arms=(Arm(test=gate, body=inner, note=note),), otherwise=None, gate=True),):
            return If((Arm(gate, (when(test, *inner, note=body.title),), note),), gate=True)
    return when(test, *body.block, note=body.title)


def _one_by_one(place: Expr, bodies: Sequence[Body]) -> If:
    """Compare with each number at which there is anything to do."""
    arms: list[Arm] = []
    tested = bodies[0].first
    """What is smaller does not come so far."""
    for body in bodies:
        if not body.block:
            continue
        if body is bodies[-1] and body.first == tested:
            return If(tuple(arms), body.block, body.title)
        if body.first == body.last:
            test: Expr = compared(place, "==", Const(body.first))
        elif body.first == tested:
            test = compared(place, "<=", Const(body.last))
        elif body is bodies[-1]:
            test = compared(place, ">=", Const(body.first))
        else:
            test = within(body.first, place, body.last)
        if body.first == tested:
            tested = body.last + 1
        arms.append(Arm(test, body.block, body.title))
    return If(tuple(arms))


__all__ = ["Body", "Untouched", "dispatch", "joined", "merged", "tree"]
