"""A round of a region: by its active leaf, what can be taken from there, in line or in methods."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterator
from dataclasses import replace

from aseme_dsl.amola.statechart import State, StateType
from aseme_dsl.codegen.code.face import docstring
from aseme_dsl.codegen.code.tree import (
    FALSE,
    NONE,
    SELF,
    Block,
    CallOf,
    Const,
    Do,
    Infix,
    Item,
    Name,
    Negated,
    Return,
    Set,
    Statement,
    always_returns,
    compared,
    own,
    own_call,
    when,
)
from aseme_dsl.codegen.plain.bodies import Body, Untouched, dispatch, merged
from aseme_dsl.codegen.plain.conditions import Conditions
from aseme_dsl.codegen.plain.modes import HAS_MOVED, MOVED, Candidate, Mode
from aseme_dsl.codegen.plain.names import Method, PlainNames, with_locals
from aseme_dsl.codegen.plain.taking import Taking
from aseme_dsl.codegen.program import sizes
from aseme_dsl.codegen.program.events import OTHER, STEP
from aseme_dsl.codegen.program.flat import completes


class Rounds:
    """The statements of rounds, mode by mode."""

    def __init__(self, names: PlainNames, conditions: Conditions, taking: Taking) -> None:
        self._names = names
        self._conditions = conditions
        self._taking = taking
        self._flat = names.flat
        self._touched = names.events.touched
        self._untouched: dict[tuple[int, bool, bool, tuple[str, ...]], Untouched] = {}
        self.others: Mode | None = None
        """What is done with an event that nothing waits for, where all events share that."""
        self._others_done: dict[int, tuple[list[int], list[int]]] = {}
        """The first and last numbers in a region for which there is anything in these methods."""

    # ---- what stands apart -----------------------------------------------------------------

    def begin(self, event: str) -> Mode:
        """A mode, with methods for regions that stand deep in others."""
        mode = self.mode_of(event)
        for region in reversed(self._flat.regions):  # innermost first, so that nothing goes deep
            is_deep = region.number and self._nesting(region.number) % sizes.NESTED == 0
            if is_deep and not self._is_shared(mode, region.number):
                self._write_apart(mode, region.number)
        return mode

    def mode_of(self, event: str) -> Mode:
        """What a step with an event, or without one, is made for."""
        names = self._names
        mode = Mode(event, names.following.may_loop(event))
        if event and self.others is not None:
            mode.loops |= self.others.loops
        mode.direct = not (mode.loops or len(self._flat.regions) > 1 or names.copied or names.faults)
        return mode

    def share(self) -> None:
        """Write what needs no event into methods, one a region, if that is much to stand with each event."""
        leaves = [leaf for region in self._flat.regions for leaf in self._flat.leaves(region.number)]
        tests = sum(1 for leaf in leaves for _ in self._names.events.open_paths(OTHER, leaf))
        if tests * (len(self._names.events.modes) - 1) > sizes.SHARED:
            mode = self.mode_of(OTHER)
            for region in reversed(self._flat.regions):
                self._write_apart(mode, region.number)
            self.others = mode

    def _is_shared(self, mode: Mode, region: int) -> bool:
        """Whether what is done in a region is the same for other events, and stands in a method of theirs."""
        return (
            self.others is not None
            and mode.event not in (STEP, OTHER)
            and region not in self._touched.get(mode.event, {})
        )

    def _nesting(self, region: int) -> int:
        """How many regions are around a region."""
        return sum(1 for _ in self._flat.regions_around(region))

    def _write_apart(self, mode: Mode, region: int) -> None:
        """Write the code of a region into a method of its own."""
        inner = mode.inner()
        block = self.region(inner, region, 3)
        mode.apart[region] = ""
        if block:
            wish = f"_{mode.word}_region_{region}"
            name = self._names.identifiers.name(("region", mode.event, region), wish)
            label = self._flat.regions[region].label
            self._function(inner, name, f"{mode.said} in region {label}.", block)
            mode.apart[region] = name

    def _called_apart(self, mode: Mode, called: Mode, region: int) -> Block:
        """The call of a region's method, which is one of the same mode or of the shared one."""
        name = called.apart[region]
        return mode.after_call(own_call(name), loops=called.loops) if name else ()

    def _function(self, mode: Mode, name: str, document: str, block: Block) -> None:
        """A method that gives 0, 1 if something moved, 2 if another round is needed after it."""
        moved, again = Name(MOVED), Name("again")
        if mode.direct:
            if not always_returns(block):
                block = (*block, Return(FALSE))
        elif mode.loops:
            block = (Set((moved, again), FALSE), *block, Return(Infix("+", moved, again)))
        else:
            block = (Set((moved,), FALSE), *block, Return(moved))
        gives = "bool" if mode.direct else "int"
        mode.functions[name] = Method(name, gives, docstring(document), with_locals(block))

    # ---- a region --------------------------------------------------------------------------

    def region(self, mode: Mode, region: int, depth: int) -> Block:
        """One round of a region: by its active leaf, what can be taken from there."""
        if self.others is not None and self._is_shared(mode, region):
            return self._called_apart(mode, self.others, region)
        if region in mode.apart:
            return self._called_apart(mode, mode, region)
        if depth > sizes.DEEP:
            self._write_apart(mode, region)
            return self._called_apart(mode, mode, region)
        if self._names.options.tables and self._flat.regions[region].size > sizes.TABLE:
            touched = self._touched.get(mode.event, {}).get(region, ())
            if not mode.event or self.others is None or len(touched) > sizes.TABLE:
                return self._by_table(mode, region)
        bodies = self._bodies(mode, region, depth)
        if mode.flags != (MOVED,) or mode.direct or mode.loops:
            return dispatch(region, bodies)
        if not all(body.block and body.block[-1] == HAS_MOVED for body in bodies):
            return dispatch(region, bodies)
        # Every body ends with the same statement: print it once, after all of them.
        bodies = [replace(body, block=body.block[:-1]) for body in bodies]
        return (*dispatch(region, bodies), HAS_MOVED)

    def _bodies(self, mode: Mode, region: int, depth: int) -> list[Body]:
        """What is done for each number of a region; neighbours that do the same are one."""
        leaves = self._flat.leaves(region)
        if mode.event in (STEP, OTHER):
            bodies = merged(body for leaf in leaves for body in self._pieces(mode, region, leaf, depth))
            if mode.event == OTHER:
                filled = [body for body in bodies if body.block]
                self._others_done[region] = [body.first for body in filled], [body.last for body in filled]
            return bodies
        if self.others is not None:
            return merged(self._beside_others(mode, region, depth, self.others))
        touched = set(self._touched.get(mode.event, {}).get(region, ()))
        touched.update(place for place, leaf in enumerate(leaves) if leaf.type is StateType.AND)
        others = self._untouched.setdefault((region, mode.loops, mode.direct, mode.flags), Untouched())
        other = replace(mode, event=OTHER)
        if not others.pieces:
            others.pieces = [None] * len(leaves)
            found: list[Body] = []
            for place, leaf in enumerate(leaves):
                of = self._pieces(mode if place in touched else other, region, leaf, depth)
                found += of
                others.pieces[place] = None if place in touched else of
            return merged(found)
        if not others.starts:
            for place, leaf in enumerate(leaves):
                if others.pieces[place] is None:
                    is_and = leaf.type is StateType.AND  # it is never used then
                    of = [_never_used(place)] if is_and else self._pieces(other, region, leaf, depth)
                    others.pieces[place] = of
            others.join()
        found = []
        begin = 0
        for place in sorted(touched):
            found += others.between(begin, place)
            found += self._pieces(mode, region, leaves[place], depth)
            begin = place + 1
        return merged([*found, *others.between(begin, len(leaves))])

    def _beside_others(self, mode: Mode, region: int, depth: int, others: Mode) -> Iterator[Body]:
        """What is done for each number of a region, where a method does what needs no event."""
        leaves = self._flat.leaves(region)
        called = self._called_apart(mode, others, region)
        begin = 0
        for place in (*self._touched.get(mode.event, {}).get(region, ()), len(leaves)):
            if begin < place:
                one, other = leaves[begin], leaves[place - 1]
                first, last = self._flat.leaf[one.label], self._names.last(other)
                block = called if self._is_in_others(region, first, last) else ()
                titles = self._names.title(one, first), self._names.title(other, last)
                yield Body(first, last, one.label, *titles, block)
            if place < len(leaves):
                yield from self._pieces(mode, region, leaves[place], depth)
            begin = place + 1

    def _is_in_others(self, region: int, first: int, last: int) -> bool:
        """Whether there is anything for some of these numbers in what all events share."""
        begins, ends = self._others_done[region]
        found = bisect_right(begins, last) - 1
        return found >= 0 and ends[found] >= first

    def _pieces(self, mode: Mode, region: int, leaf: State, depth: int) -> list[Body]:
        """What is done for each number of a leaf."""
        found: list[Body] = []
        first = self._flat.leaf[leaf.label]
        for number in range(first, self._names.last(leaf) + 1):
            if mode.event and number > first and self._names.events.is_left(leaf):
                found[-1] = replace(found[-1], last=number)
                continue
            block = self.from_leaf(mode, region, leaf, number, depth + 3)
            title = self._names.title(leaf, number)
            is_and = leaf.type is StateType.AND
            found.append(Body(number, number, leaf.label, title, title, block, is_and))
        return found

    def _by_table(self, mode: Mode, region: int) -> Block:
        """Find the body of the active leaf in a tuple of functions, each for as many leaves as `CHUNK`.

        One function for each leaf would take long to load without being faster.
        """
        names = self._names
        table = names.identifiers.name(("table", mode.event, region), f"_{mode.word.upper()}_{region}")
        entries: list[str] = []
        inner = mode.inner()
        others = self.others if mode.event not in (STEP, OTHER) else None
        shared = others.apart[region] if others is not None else ""
        called = self._called_apart(inner, others, region) if others is not None else ()
        bodies = self._bodies(inner, region, 3)
        for first in range(0, self._flat.regions[region].size, sizes.CHUNK):
            last = first + sizes.CHUNK - 1
            inside = [
                replace(body, first=max(body.first, first), last=min(body.last, last))
                for body in bodies
                if body.first <= last and body.last >= first
            ]
            block = dispatch(region, inside)
            if not block:
                entries.append("None")
                continue
            if block == called:
                entries.append(f"{names.class_name}.{shared}")
                continue
            wish = f"_{mode.word}_{region}_{first}"
            name = names.identifiers.name(("leaves", mode.event, region, first), wish)
            ends = f"{inside[0].label} … {inside[-1].label}"
            self._function(inner, name, f"{mode.said} while {ends}.", block)
            entries.append(f"{names.class_name}.{name}")
        if all(entry == "None" for entry in entries):
            return ()
        names.used.add("Callable")
        gives = "bool" if mode.direct else "int"
        kind = f"tuple[Callable[[{names.class_name}], {gives}] | None, ...]"
        mode.tables[table] = ["", f"{table}: {kind} = (", *(f"    {entry}," for entry in entries), ")"]
        leaves = Name("leaves")
        index = Infix(">>", own(f"r{region}"), Const(sizes.CHUNK.bit_length() - 1))
        moved = mode.after_call(CallOf(leaves, (SELF,)), loops=mode.loops)
        return (Set((leaves,), Item(Name(table), index)), when(compared(leaves, "is not", NONE), *moved))

    # ---- from a leaf -----------------------------------------------------------------------

    def from_leaf(self, mode: Mode, region: int, leaf: State, number: int, depth: int) -> Block:
        """What one round may do while `leaf` is active: what interrupts, the outermost first; then innermost
        source first."""
        flat = self._flat
        complete = self._names.complete(leaf, number)
        around = flat.around(leaf.label)
        cuts: list[Candidate] = []
        for source in reversed(around):
            for way in flat.first_ways(source.label):
                cuts += self._conditions.candidates(mode, region, source.label, FALSE, way)
        for way in flat.first_ways(leaf.label):
            cuts += self._conditions.candidates(mode, region, leaf.label, complete, way)
        ways: list[Candidate] = []
        for way in flat.ways(leaf.label):
            ways += self._conditions.candidates(mode, region, leaf.label, complete, way)
        for source in around:
            ended = Const(completes(leaf, source))
            for way in flat.ways(source.label):
                ways += self._conditions.candidates(mode, region, source.label, ended, way)
        inside: list[Statement] = []
        flag = ""
        if leaf.type is StateType.AND:
            flags = mode.flags
            if ways:
                mode.inside += 1
                flag = f"inside_{region}_{mode.inside}"
                mode.flags = (*flags, flag)
            deeper = depth + (1 if cuts else 0)
            was_direct, mode.direct = mode.direct, False
            for inner in flat.regions_of(leaf.label):
                inside += self.region(mode, inner.number, deeper)
            mode.direct = was_direct
            mode.flags = flags
        rest = self._taking.chain(mode, region, leaf, number, ways)
        if inside and rest:
            says = Name(flag)
            rest = (Set((says,), FALSE), *inside, when(Negated(says), *rest))
        else:
            rest = tuple(inside) or rest
        return self._taking.chain(mode, region, leaf, number, cuts, rest) if cuts else rest


def _never_used(place: int) -> Body:
    """What stands in the place of an AND among what is not touched: it differs from its neighbours."""
    return Body(0, 0, "", "", "", (Do(Const(place)),))


__all__ = ["Rounds"]
