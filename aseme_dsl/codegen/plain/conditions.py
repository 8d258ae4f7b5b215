"""What must hold for the outgoing transitions of a leaf, mode by mode."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from aseme_dsl.amola.expression import NEVER, After, Event, Failed, Raised, Value
from aseme_dsl.amola.statechart import StateType, TransitionKind
from aseme_dsl.codegen.code.face import docstring
from aseme_dsl.codegen.code.tree import (
    FALSE,
    NOW,
    TRUE,
    Const,
    Expr,
    Field,
    Group,
    Guarded,
    Infix,
    Name,
    Negated,
    Return,
    any_of,
    compared,
    inside,
    own,
    own_call,
)
from aseme_dsl.codegen.code.values import holds
from aseme_dsl.codegen.plain.modes import Candidate, Mode, Spending
from aseme_dsl.codegen.plain.names import BB, PlainNames
from aseme_dsl.codegen.program import sizes
from aseme_dsl.codegen.program.events import STEP
from aseme_dsl.codegen.program.flat import Way
from aseme_dsl.codegen.program.moves import draws, raises


class Conditions:
    """The conditions of transitions, in line or in methods, and gates before many of them."""

    def __init__(self, names: PlainNames) -> None:
        self._names = names
        self._guards: set[int] = set()
        self._gated: dict[tuple[frozenset[Expr], tuple[Expr, ...]], Field] = {}
        self.gates: dict[Field, frozenset[Expr]] = {}
        """What says of many conditions that they still do not hold, with what on the blackboard they read."""

    def candidates(
        self,
        mode: Mode,
        region: int,
        source: str,
        complete: Expr,
        way: Way,
        before: tuple[int, ...] = (),
        tests: tuple[Expr, ...] = (),
        spends: Spending = False,
        *,
        does: bool = False,
    ) -> Iterator[Candidate]:
        """The compound transitions of a way, each with all of its tests.

        `does`: to test so far does something: it may be told that a condition has failed, or a random number
        is drawn.
        """
        names = self._names
        transition = names.flat.transition(way.number)
        expression = transition.expression
        if expression is NEVER:
            return
        if expression.events and not expression.when:
            found = self._there(mode, region, source, expression.events)
            if found is None:
                return
            tests = (*tests, *found)
        elif not expression.events and not expression.when and not before:
            if complete == FALSE:
                return
            if complete != TRUE:
                tests = (*tests, complete)
        spends = self._spending(mode, source, expression.events) or spends
        if expression.every is not None:
            tests = (*tests, self._has_been(source, expression.every))
        if expression.guard is not None:
            guard = self._guard(region, way.number, expression.guard)
            does = does or raises(expression.guard) or draws(expression.guard)
            if guard != TRUE:
                tests = (*tests, guard)
        taken = (*before, way.number)
        if names.chart.node(transition.target).type is StateType.CONDITION:
            found_ways = [
                item
                for branch in way.branches
                for item in self.candidates(
                    mode, region, source, complete, branch, taken, tests, spends, does=does
                )
            ]
            if not found_ways and does:
                found_ways = [Candidate(source, (*tests, FALSE), taken, False, leads_on=False)]
            yield from found_ways
            return
        yield Candidate(source, tests, taken, spends, transition.kind is TransitionKind.ON)

    def _has_been(self, source: str, duration: int) -> Expr:
        """Whether a state has been active so long."""
        return compared(Infix("-", NOW, self._names.time(source)), ">=", Const(duration))

    def _there(
        self, mode: Mode, region: int, source: str, events: Iterable[Event]
    ) -> tuple[Expr, ...] | None:
        """What must hold for one of the events to be there; None if it cannot be."""
        tests: list[Expr] = []
        for event in events:
            if isinstance(event, After):
                tests.append(self._has_been(source, event.duration))
            elif isinstance(event, Failed) and mode.event == STEP:
                tests.append(own_call("failed_inside", Const(source)))
            elif isinstance(event, Raised) and event.name == mode.event:
                if not mode.loops:
                    return ()
                tests.append(Negated(Infix("&", own("spent"), Const(1 << region))))
        if not tests:
            return None
        return (tests[0] if len(tests) == 1 else Group(any_of(tests)),)

    def _spending(self, mode: Mode, source: str, events: Iterable[Event]) -> Spending:
        """Whether the event is consumed: the first of several that is there counts."""
        before: list[Expr] = []
        for event in events:
            if isinstance(event, Raised) and event.name == mode.event:
                return Negated(Group(any_of(before))) if before else True
            if isinstance(event, After):
                before.append(self._has_been(source, event.duration))
        return False

    def _guard(self, region: int, number: int, condition: Value) -> Expr:
        """The condition in line, or as a method of its own where evaluating it may raise."""
        if not raises(condition):
            names = self._names.names(region, f"{region}_{number}_")
            self._names.asked_by(number, names)
            return holds(condition, names)[0]
        if number not in self._guards:
            self._guards.add(number)
            names = self._names.names(region)
            self._names.asked_by(number, names)
            code, _ = holds(condition, names)
            fault = own_call("fault", Const(number), Name("error"))
            document = f"The condition of {docstring(self._names.place(number))}."
            self._names.method(
                f"_holds_{number}",
                "bool",
                document,
                (Guarded((Return(code),), (Return(fault),)),),
                ((BB.name, self._names.board_type()),),
            )
        return own_call(f"_holds_{number}", BB)

    def gate(self, candidates: Sequence[Candidate]) -> Field | None:
        """What says that none of many conditions holds, as long as nothing changes that they read."""
        options = self._names.options
        if len(candidates) < sizes.GUARDS or options.mapping or not options.gates:
            return None
        if not all(item.tests for item in candidates):
            return None
        tests = tuple(test for candidate in candidates for test in candidate.tests)
        parts = [part for test in tests for part in inside(test)]
        if any(isinstance(part, Name) and part.name in ("now", "self") for part in parts):
            return None
        read = frozenset(part for part in parts if isinstance(part, Field) and part.base == BB)
        found = self._gated.get((read, tests))
        if found is None:
            number = len(self.gates) + 1
            found = Field(BB, self._names.board_names.name(("gate", number), f"still_{number}"))
            self.gates[found] = read
            self._gated[read, tests] = found
        return found


__all__ = ["Conditions"]
