"""The methods that a program calls: to start, to step, with an event, and after an activity has returned."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from aseme_dsl.amola.statechart import State, StateType
from aseme_dsl.codegen.code.face import docstring
from aseme_dsl.codegen.code.python import length
from aseme_dsl.codegen.code.tree import (
    FALSE,
    NONE,
    SELF,
    TRUE,
    Arm,
    Block,
    Break,
    CallOf,
    Const,
    Do,
    Ended,
    Expr,
    Fail,
    Field,
    Forgive,
    If,
    Infix,
    Item,
    Listed,
    Loop,
    Name,
    Negated,
    Pass,
    Remember,
    Return,
    Set,
    Statement,
    Update,
    all_of,
    always_returns,
    any_of,
    compared,
    expressions_in,
    names_in,
    own,
    own_call,
    sets_local,
    statements,
    when,
)
from aseme_dsl.codegen.plain.actions import FOLLOWS, WOKEN, Actions
from aseme_dsl.codegen.plain.bodies import Body, merged, tree
from aseme_dsl.codegen.plain.modes import HAS_MOVED, MOVED, Mode
from aseme_dsl.codegen.plain.names import Method, PlainNames, with_locals
from aseme_dsl.codegen.plain.places import Places
from aseme_dsl.codegen.plain.rounds import Rounds
from aseme_dsl.codegen.program import sizes
from aseme_dsl.codegen.program.events import STEP

_EVENT, _PLACE, _OUTCOME = Name("event"), Name("place"), Name("outcome")
_NOTHING: Block = (Return(FALSE),)
_ROUNDS = Name("ROUNDS")
_STEP = Return(own_call("step"))


class Steps:
    """Steps, whole: with what comes before and after what the regions do."""

    def __init__(self, names: PlainNames, actions: Actions, places: Places, rounds: Rounds) -> None:
        self._names = names
        self._actions = actions
        self._places = places
        self._rounds = rounds
        self._flat = names.flat
        self._follows = FOLLOWS if names.uses.wakes else ()
        self.spends = False
        """Whether the regions that have no event any more are noted."""
        self._called: dict[str, str] = {}
        """The methods of events that have one."""
        self.events: list[tuple[str, Block]] = []
        """What a step with each event does, without the `return False` that `send` has at its end."""

    def methods(self) -> Iterator[Method]:
        """All methods of steps, with those of the modes, but without what steps call besides.

        `events` are known afterwards.
        """
        self._rounds.share()
        modes: dict[str, Mode] = {}
        bodies: dict[str, Block] = {}
        for event in self._names.events.modes:
            mode = modes[event] = self._rounds.begin(event)
            block = self._rounds.region(mode, 0, 3 if mode.loops else 2)
            bodies[event] = self._whole(mode, block, follows=event != STEP)
        yield self._start(bodies[STEP])
        yield self._send(bodies)
        yield from self._step(bodies[STEP])
        if not self._names.options.translated:
            yield from self._done()
        others = self._rounds.others
        for mode in (*modes.values(), *([others] if others else ())):
            yield from mode.functions.values()
            self._names.tables += (line for table in mode.tables.values() for line in table)

    @property
    def called(self) -> frozenset[str]:
        """The methods that `send` calls, one an event."""
        return frozenset(self._called.values())

    # ---- a step ----------------------------------------------------------------------------

    def _whole(self, mode: Mode, block: Block, region: int | None = None, *, follows: bool = True) -> Block:
        """What a step does, with what comes before and after it; of one `region` if nothing else is done.

        `follows`: steps may follow it at the same instant.
        """
        if not block:
            return _NOTHING
        if mode.direct:
            return block if always_returns(block) else (*block, Return(FALSE))
        moved, rounds = Name(MOVED), Name("rounds")
        head = [item for name in self._names.copied for item in self._actions.copies(name, region)]
        tail: Block = self._actions.spread()
        if self._names.faults:
            tail = (*tail, Forgive())
        after = self._follows if follows else ()
        if mode.loops:
            written = [block, *(method.body for method in mode.functions.values())]
            if any(item == own("spent") for part in written for item in expressions_in(part)):
                self.spends = True
                head.append(Set((own("spent"),), Const(0)))
            head += [Set((rounds,), Const(0)), Set((moved,), FALSE)]
            again = Name("again")
            unsettled = Fail(own_call("unsettled"))
            looped = (
                Set((again,), FALSE),
                *block,
                when(Negated(again), Break()),
                Update(rounds, "+", Const(1)),
                when(compared(rounds, "==", _ROUNDS), unsettled),
            )
            block = (Loop(looped),)
        elif self._always_moves(block):
            block = tuple(item for item in block if item != HAS_MOVED)
            return (*head, *self._ended(block, tail), *after, Return(TRUE))
        else:
            head.append(Set((moved,), FALSE))
        return (*head, *self._ended(block, tail), *after, Return(moved))

    def _always_moves(self, block: Block) -> bool:
        """Whether a block always says that something has moved, and nothing else speaks of it."""
        rest = [item for item in block if item != HAS_MOVED]
        if len(rest) == len(block) or MOVED in names_in(rest):
            return False
        return not any(sets_local(item, MOVED) for item in statements(rest))

    def _ended(self, block: Block, tail: Block) -> Block:
        """A step with what ends it: also one that something raises, where a program is called in it."""
        if not tail or self._names.options.translated:
            return (*block, *tail)
        return (Ended(block, tail),)

    # ---- the interface ---------------------------------------------------------------------

    def _start(self, step: Block) -> Method:
        """The method that enters the root and takes transitions until none is enabled, as a `step` does."""
        names = self._names
        root = names.chart.root
        head: list[Statement] = [Set((names.count(label),), Const(0)) for label in names.registers.counted]
        copies = [item for name in names.copied for item in self._actions.copies(name)]
        head += [*copies, *self._actions.on_entry(root)]
        entered = self._places.enter_inside(0, root.label)
        goes_on = (
            names.rests.asked
            or names.following.open_at(STEP, names.events.rest(root.label), False, root.label)
            or bool(names.chart.outgoing(root.label))
        )
        document = "Enter the root, and go on until nothing is enabled."
        body: Block
        if goes_on and any(isinstance(item, Remember) for item in entered):
            # It is one step: what a region has written it sees, so the copies are not taken again.
            rest = tuple(item for item in step[:-1] if item not in copies)
            whole = next((item for item in rest if isinstance(item, Ended)), None)
            if whole is None:
                rest = (*entered, *rest)
            else:
                place = rest.index(whole)
                rest = (*rest[:place], Ended((*entered, *whole.body), whole.end), *rest[place + 1 :])
            body = (*head, *rest, *self._follows)
        elif goes_on:
            body = (*head, *entered, Do(own_call("step")))
        else:
            follows = FOLLOWS if WOKEN in entered else ()
            body = (*head, *self._ended(entered, self._actions.spread()), *follows)
        return Method("start", "None", document, with_locals(body or (Pass(),)))

    def _send(self, bodies: Mapping[str, Block]) -> Method:
        """The method that makes a step with an event: a body for each."""
        names = self._names
        events = [event for event in bodies if event != STEP]
        idle = bodies[STEP] == _NOTHING
        few = len(events) <= sizes.BRANCHES
        in_line = few and sum(length(bodies[event]) for event in events) <= sizes.IN_LINE
        called = self._called
        for event in events if not in_line else ():
            called[event] = names.identifiers.name(("event", event), f"_on_{event}")
            names.method(called[event], "bool", f"One step with `{event}`.", bodies[event])
        found: list[Statement] = []
        if not few:
            entries = [f"    {event!r}: {names.class_name}.{called[event]}," for event in events]
            kind = f"dict[str, Callable[[{names.class_name}], bool]]"
            names.used.add("Callable")
            names.tables += ["", f"_EVENTS: {kind} = {{", *entries, "}"]
            method = Name("method")
            found.append(Set((method,), CallOf(Field(Name("_EVENTS"), "get"), (_EVENT,))))
            found.append(when(compared(method, "is not", NONE), Return(CallOf(method, (SELF,)))))
        other = _NOTHING[0] if idle else _STEP
        if in_line and len(events) == 1:
            (event,) = events
            self.events.append((event, bodies[event]))
            found += [when(compared(_EVENT, "!=", Const(event)), other), *with_locals(bodies[event])]
            return _sending(found)
        arms: list[Arm] = []
        falls = False
        for event in events:
            block = bodies[event]
            if in_line and block[-1] == _NOTHING[0]:
                block = block[:-1]  # there is one at the end
                falls = True
            self.events.append((event, block))
            if not few:
                continue
            block = with_locals(block) if in_line else (Return(own_call(called[event])),)
            arms.append(Arm(compared(_EVENT, "==", Const(event)), block))
        if falls and not idle:
            return _sending([*found, If(tuple(arms), (_STEP,)), *_NOTHING])
        return _sending([*found, *([If(tuple(arms))] if arms else []), other])

    def _step(self, body: Block) -> Iterator[Method]:
        """The method that makes a step without an event, with what follows at the same instant."""
        document = "One step without an event."
        if not self._names.uses.wakes:
            yield Method("step", "bool", document, with_locals(body))
            return
        steps, woken = Name("steps"), own("woken")
        whole = (when(Negated(own_call("_alone")), Return(FALSE)), *FOLLOWS, Return(TRUE))
        follow = (
            Set((steps,), Const(0)),
            Loop(
                (
                    when(Negated(woken), Break()),
                    Set((woken,), FALSE),
                    Do(own_call("_alone")),
                    Update(steps, "+", Const(1)),
                    when(compared(steps, "==", _ROUNDS), Fail(own_call("endless"))),
                )
            ),
        )
        alone = "What a step without an event does, without the steps that follow it."
        after = "The steps that follow as long as regions write what conditions of others read."
        yield Method("step", "bool", document, whole)
        yield Method("_alone", "bool", alone, with_locals(body))
        yield Method("_follow", "None", after, follow)

    # ---- an activity that has returned -----------------------------------------------------

    def _done(self) -> Iterator[Method]:
        """The method that makes a step before which an activity has returned, if that matters anywhere.

        States are found by their place among the leaves of all regions, one region after the other.
        """
        names = self._names
        bodies: list[Body] = []
        places = 0
        alone = names.following.alone()
        for region in self._flat.regions:
            for leaf in self._flat.leaves(region.number):
                if leaf.type is StateType.BASIC and not leaf.waits and names.rests.width(leaf) > 1:
                    place = places + self._flat.leaf[leaf.label]
                    does = self._returned(region.number, leaf, places, alone[region.number])
                    title = f"{leaf.label} {leaf.name}"
                    bodies.append(Body(place, place, leaf.label, title, title, does))
            places += region.size
        bodies = merged(bodies)
        if not bodies:
            return
        if sum(length(body.block) for body in bodies) > sizes.IN_LINE:
            bodies = [
                self._done_apart(number, bodies[first : first + sizes.CHUNK])
                for number, first in enumerate(range(0, len(bodies), sizes.CHUNK))
            ]
        says = any(map(names.registers.ending.__contains__, self._flat.leaf))
        label, known = Name("label"), Name("_PLACES")
        key: Expr = Listed((label, _OUTCOME)) if says else label
        kind = "tuple[str, str | None]" if says else "str"
        names.tables += ["", f"_PLACES: dict[{kind}, int] = {{}}"]
        names.tables.append('"""The activities that have returned before, as they were given to `done`."""')
        keep: Statement = Set((Item(known, key),), _PLACE)
        if says:
            ends = CallOf(Field(own("ENDS"), "get"), (own_call("label_of", label), Listed(())))
            keep = when(any_of((compared(_OUTCOME, "is", NONE), compared(_OUTCOME, "in", ends))), keep)
        looked_up = (
            Set((_PLACE,), own_call("place", label, _OUTCOME)),
            when(compared(_PLACE, "<", Const(0)), _STEP),
            keep,
        )
        yield Method(
            "done",
            "bool",
            "One step, before which the activity of a BASIC state has returned.",
            (
                Set((_PLACE,), CallOf(Field(known, "get"), (key,))),
                when(compared(_PLACE, "is", NONE), *looked_up),
                *tree(_PLACE, bodies),
                _STEP,
            ),
            (("label", "str"), ("outcome", "str | None = None")),
        )

    def _done_apart(self, number: int, bodies: list[Body]) -> Body:
        """A method for some of the activities that have returned; what calls it."""
        names = self._names
        name = names.identifiers.name(("done", number), f"_done_{number}")
        given = {"place": "int"} | ({"outcome": "str | None"} if names.registers.outcomes else {})
        one, other = bodies[0], bodies[-1]
        document = f"{docstring(f'{one.begins} to {other.ends}')} has returned."
        names.methods.append(
            Method(name, "bool", document, (*tree(_PLACE, bodies), _STEP), tuple(given.items()))
        )
        call = Return(own_call(name, *map(Name, given)))
        return Body(one.first, other.last, one.label, one.begins, other.ends, (call,))

    def _returned(self, region: int, leaf: State, places: int, alone: bool) -> Block:
        """What is done as the activity of a leaf has returned, and all of the step if it moves `alone`.

        Where nothing can be said of the rest, a step is to follow.
        """
        names = self._names
        number = self._flat.leaf[leaf.label]
        slot = own(f"r{region}")
        ends = [Set((place,), _OUTCOME) for place in names.outcomes_of(leaf.label)]
        around = names.chart.node(self._flat.regions[region].label).parent
        active = None if around is None else names.is_active(names.chart.node(around))
        before = () if active is None or active == TRUE else (active,)
        again = names.following.loops_at(STEP, leaf)
        is_large = self._flat.regions[region].size > sizes.TABLE
        held = all_of((*before, compared(slot, "==", Const(number))))
        if is_large or not alone or (again and (names.copied or names.faults)):
            if ends:
                return (when(held, Set((slot,), Const(number + 1)), *ends),)
            running = Infix("-", _PLACE, Const(places)) if places else _PLACE  # the same for all
            return (when(all_of((*before, compared(slot, "==", running))), Update(slot, "+", Const(1))),)
        mode = Mode(STEP, direct=not names.copied and not names.faults)
        block = self._whole(mode, self._rounds.from_leaf(mode, region, leaf, number + 1, 4), region)
        complete = Set((slot,), Const(number + 1), names.title(leaf, number + 1))
        return (when(held, *with_locals((complete, *ends, *block))),)


def _sending(body: Iterable[Statement]) -> Method:
    document = "One step with an event; whether anything was taken."
    return Method("send", "bool", document, tuple(body), (("event", "str"),))


__all__ = ["Steps"]
