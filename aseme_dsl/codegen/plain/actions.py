"""What transitions do as they are taken, and what entering a state notes."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from aseme_dsl.amola.expression import Action, Assign, Evaluate, StartTimer, Value, VariableValue
from aseme_dsl.amola.statechart import State, TransitionKind
from aseme_dsl.codegen.code.tree import (
    NONE,
    NOW,
    TRUE,
    Arm,
    Block,
    CallOf,
    Const,
    Do,
    Expr,
    Field,
    Guarded,
    If,
    Infix,
    Name,
    Negated,
    Note,
    Remember,
    Set,
    Spread,
    Statement,
    Update,
    Wrote,
    all_of,
    any_of,
    compared,
    own,
    own_call,
    when,
)
from aseme_dsl.codegen.code.values import Piece, computed, converted, evaluate
from aseme_dsl.codegen.plain.names import BB, PlainNames
from aseme_dsl.codegen.program.moves import assigned

WOKEN = Set((own("woken"),), TRUE)
"""A region has written what a condition of another reads."""

FOLLOWS: Block = (when(own("woken"), Do(own_call("_follow"))),)
"""What is done after a step in which a region may have written what a condition of another reads."""


class Actions:
    """The statements for actions, for calls of `took`, and for the registers of states."""

    def __init__(self, names: PlainNames) -> None:
        self._names = names

    def took(self, taken: tuple[int, ...]) -> Block:
        """The call that tells of a transition that is taken."""
        if not self._names.options.watched:
            return ()
        return (Do(own_call("took", *map(Const, taken))),)

    def of(self, region: int, number: int) -> Block:
        """The actions of a transition."""
        names = self._names
        # Machine code has one type for a local: the condition of this transition has its own.
        values = names.names(region, f"e{region}_{number}_")
        names.asked_by(number, values)
        found: list[Statement] = []

        def after(value: Value, use: Callable[[Piece], Block], can_raise: bool = False) -> None:
            """Compute a value and use it; an absent or raising one is a fault."""
            result = computed((value,), values)
            block = use(result.pieces[0])
            if result.needs:
                fault = Do(own_call("fault", Const(number), Name("ABSENT")))
                block = (If((Arm(all_of(result.needs), block),), (fault,)),)
            if result.raises or can_raise:
                fault = Do(own_call("fault", Const(number), Name("error")))
                block = (Guarded(block, (fault,)),)
            found.extend(block)

        def assign(target: VariableValue, value: Value) -> None:
            after(
                value,
                lambda piece: self._assignment(
                    region, target, names.bounded(target.name, converted(piece, value.type, target.type))
                ),
                names.is_bounded(target.name),
            )

        def start(place: Expr, duration: Value) -> None:
            after(duration, lambda piece: (Set((place,), Infix("+", NOW, piece.code)),))

        action: Action
        for action in names.flat.transition(number).expression.actions:
            match action:
                case Assign(target=VariableValue() as target, value=value):
                    assign(target, value)
                case Evaluate(value=value):
                    after(value, lambda piece: (Do(piece.code),))
                case StartTimer(timer=timer, duration=duration):
                    start(names.timer(region, timer), duration)
                case _:
                    raise AssertionError(f"{action} is refused")
        if self._wakes(region, number):
            found.append(WOKEN)
        return tuple(found)

    def _assignment(self, region: int, target: VariableValue, code: Expr) -> Block:
        names = self._names
        if target.name not in names.copied:
            place = names.variable_on_board(target.name)
            return (Set((place,), code), Wrote(place))
        copy = names.copy(target.name, region)
        return (Set((copy,), code), Remember(region, names.on_board(target.name), copy))

    def _wakes(self, region: int, number: int) -> bool:
        """Whether a transition writes what a condition of another region reads that it does not enter."""
        flat = self._names.flat
        transition = flat.transition(number)
        return any(
            reader != region
            and (transition.kind is TransitionKind.ON or region not in flat.regions_around(reader))
            for name in assigned(transition.expression)
            for reader in self._names.uses.wakes.get(name, ())
        )

    def copies(self, name: str, only: int | None = None) -> Block:
        """The copies of a variable at the beginning of a step, of all regions or only one."""
        names = self._names
        copies = tuple(names.copy(name, region) for region in names.copied[name] if only in (None, region))
        return (Set(copies, names.variable_on_board(name)),) if copies else ()

    def spread(self) -> Block:
        """The end of a step: all regions see what some have written into their copies."""
        names = self._names
        if not names.copied:
            return ()
        return (Spread(BB, tuple(map(names.variable_on_board, names.copied))),)

    def on_entry(self, node: State) -> Block:
        """What is noted as a state is entered."""
        names, registers = self._names, self._names.registers
        found: list[Statement] = []
        if node.label in registers.timed:
            found.append(self.entered_now(node.label))
        found += (
            Set((names.count(label),), Const(0))
            for label, loop in registers.counted.items()
            if loop == node.label
        )
        if node.label in registers.counted:
            found.append(Update(names.count(node.label), "+", Const(1)))
        return tuple(found)

    def entered_now(self, label: str) -> Set:
        """What notes when a state was entered."""
        return Set((self._names.time(label),), NOW)

    def begin(self, region: int, node: State) -> Statement:
        """The call that starts the activity of a state, with what it is given."""
        values = self._names.names(region, f"{region}_")
        self._names.asked_at(node.label, values)
        types = self._names.registers.parameters(node)
        given = [
            converted(evaluate(item.value, values), item.value.type, types.get(item.name, item.value.type))
            for item in node.arguments
        ]
        return Do(own_call(f"start_{node.activity}", Const(node.label), *given))

    def stop(self, node: State, number: int | None) -> Block:
        """The call that cuts an activity short, unless it has returned."""
        names = self._names
        if number != names.flat.leaf[node.label]:
            return ()
        stop: Sequence[Statement] = ()
        if names.options.watched and not node.waits:
            stop = (Do(own_call(f"stop_{node.activity}", Const(node.label))),)
        if not names.may_fail:
            return tuple(stop)
        failures = own("failures")
        forget = CallOf(Field(failures, "pop"), (Const(node.label), NONE))
        if not stop:
            return (when(failures, Do(forget)),)
        return (when(_not_failed(failures, forget), *stop),)

    def left(self, region: int, node: State) -> Block:
        """What is done when a state is left, after what is inside it."""
        found: list[Statement] = []
        for transition in self._names.chart.exits_of(node.label):
            number = self._names.flat.transition_number[id(transition)]
            done = [*self.took((number,)), *self.of(region, number)]
            found += [Note(self._names.place(number)), *done] if done else []
        return tuple(found)


def _not_failed(failures: Expr, forget: Expr) -> Expr:
    """Whether an activity that is left has not failed before."""
    return any_of((Negated(failures), compared(forget, "is", NONE)))


__all__ = ["FOLLOWS", "WOKEN", "Actions"]
