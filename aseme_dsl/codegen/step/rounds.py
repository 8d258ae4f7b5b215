"""A round of a region: by its active leaf, the transitions that can be taken from there."""

from __future__ import annotations

from aseme_dsl.amola.expression import (
    taken_message,
    walk,
)
from aseme_dsl.amola.statechart import State, StateType, TransitionKind
from aseme_dsl.codegen.code.face import key_of
from aseme_dsl.codegen.code.tree import (
    FALSE,
    TRUE,
    Expr,
)
from aseme_dsl.codegen.program import sizes
from aseme_dsl.codegen.program.flat import Way, completes
from aseme_dsl.codegen.program.uses import signals
from aseme_dsl.codegen.step.actions import Actions
from aseme_dsl.codegen.step.events import Events
from aseme_dsl.codegen.step.names import Method, Part, StepNames, mail_name
from aseme_dsl.codegen.step.taking import Taking
from aseme_dsl.records import dataclass


@dataclass(frozen=True, slots=True)
class _Body:
    """What a round does while a region has this number."""

    number: int
    title: str
    method: Method


class Rounds(Part):
    """A round of a region: by its active leaf, the transitions that can be taken from there."""

    def __init__(self, names: StepNames, actions: Actions, events: Events, taking: Taking) -> None:
        super().__init__(names)
        self.actions = actions
        self.events = events
        self.taking = taking

    def region(self, region: int) -> None:
        bodies: list[_Body] = []
        for leaf in self.flat.leaves(region):
            number = self.flat.leaf[leaf.label]
            numbers = [number, number + 1] if leaf.type is StateType.BASIC else [number]
            for state in numbers:
                # locals of different leaves are typed differently, so they do not share names
                method = self.names.writing(region, f"{state}_")
                self._from_leaf(method, region, leaf, complete=self.names.complete(leaf, state))
                if method.lines:
                    bodies.append(_Body(state, self.names.leaf_title(leaf, state), method))
        label = self.flat.regions[region].label
        signature = f"_region_{region}(self, now: int) -> bool"
        document = f"One round of region {label}."
        if self.flat.regions[region].size > sizes.TABLE:
            self._table(region, bodies, signature, document)
            return
        whole = self.names.writing(region)
        if bodies:
            whole.add(2, f"r = self.r{region}")
            self._tree(whole, bodies, 2)
        whole.add(2, "return False")
        self.names.method(signature, document, whole)

    def _tree(self, whole: Method, bodies: list[_Body], depth: int) -> None:
        """Find the body of the active leaf by comparisons; halves where there are many."""
        if len(bodies) > 4:
            middle = len(bodies) // 2
            whole.add(depth, f"if r < {bodies[middle].number}:")
            self._tree(whole, bodies[:middle], depth + 1)
            whole.add(depth, "else:")
            self._tree(whole, bodies[middle:], depth + 1)
            return
        for index, body in enumerate(bodies):
            whole.add(depth, f"{'elif' if index else 'if'} r == {body.number}:  # {body.title}")
            whole.take(depth - 1, body.method)  # written two deep

    def _table(self, region: int, bodies: list[_Body], signature: str, document: str) -> None:
        """Find the body of the active leaf in a tuple of functions."""
        entries = ["None"] * self.flat.regions[region].size
        for body in bodies:
            name = f"_leaf_{region}_{body.number}"
            body.method.add(2, "return False")
            self.names.method(f"{name}(self, now: int) -> bool", f"While {body.title}.", body.method)
            entries[body.number] = f"{self.names.class_name}.{name}"
        whole = self.names.writing(region)
        whole.add(
            2,
            f"leaf = _LEAVES_{region}[self.r{region}]",
            "return leaf is not None and leaf(self, now)",
        )
        self.names.method(signature, document, whole)
        kind = f"tuple[Callable[[{self.names.class_name}, int], bool] | None, ...]"
        self.names.used.add("Callable")
        self.names.tables += ["", f"_LEAVES_{region}: {kind} = ("]
        self.names.tables += [f"    {entry}," for entry in entries]
        self.names.tables += [")"]

    def _from_leaf(self, method: Method, region: int, leaf: State, complete: Expr) -> None:
        """Everything that one round may do while `leaf` is active: what interrupts, the outermost first, then
        innermost source first."""
        depth = 2
        for around in reversed(self.flat.sources_around(leaf.label)):
            if self.flat.first_ways(around.label):
                method.add(depth, f"if self._first_{key_of(around.label)}(now):", "    return True")
                self._before(region, around)
        for way in self.flat.first_ways(leaf.label):
            if self._way(method, depth, region, leaf.label, leaf, complete, way, ()):
                return
        if leaf.type is StateType.AND:
            first, *others = self.flat.regions_of(leaf.label)
            method.add(depth, f"moved = self._region_{first.number}(now)")
            self._left_behind(method, depth, region, leaf)
            for inner in others:
                method.add(depth, f"if self._region_{inner.number}(now):", "    moved = True")
                self._left_behind(method, depth, region, leaf)
            method.add(depth, "if moved:", "    return True")
        if self._ways(method, depth, region, leaf.label, leaf, complete):
            return
        for around in self.flat.sources_around(leaf.label):
            if completes(leaf, around):
                if self._ways(method, depth, region, around.label, leaf, TRUE):
                    return
            elif any(self.flat.waits_for_event(way) for way in self.flat.ways(around.label)):
                method.add(depth, f"if self._around_{key_of(around.label)}(now):", "    return True")
                self._around(region, around)

    def _left_behind(self, method: Method, depth: int, region: int, leaf: State) -> None:
        """The end of a round in an AND which one of its regions has left; up to the region of the scope."""
        if self.flat.is_left_from_inside(leaf.label):
            method.add(depth, "if self.out >= 0:")
            method.add(depth + 1, f"if self.out == {region}:", "    self.out = -1", "return True")

    def _around(self, region: int, source: State) -> None:
        """A method with the transitions that may leave a composite before it is complete."""
        name = f"_around_{key_of(source.label)}"
        if not self.names.is_new(name):
            return
        method = self.names.writing(region)
        self._ways(method, 2, region, source.label, None, FALSE)
        method.add(2, "return False")
        document = f"What may leave {source.label} {source.name} before it is complete."
        self.names.method(f"{name}(self, now: int) -> bool", document, method)

    def _before(self, region: int, source: State) -> None:
        """A method with the transitions that cut a composite short."""
        name = f"_first_{key_of(source.label)}"
        if not self.names.is_new(name):
            return
        method = self.names.writing(region)
        always = any(
            self._way(method, 2, region, source.label, None, FALSE, way, ())
            for way in self.flat.first_ways(source.label)
        )
        if not always:
            method.add(2, "return False")
        self.names.method(
            f"{name}(self, now: int) -> bool", f"What cuts {source.label} {source.name} short.", method
        )

    def _ways(
        self, method: Method, depth: int, region: int, source: str, leaf: State | None, complete: Expr
    ) -> bool:
        """The outgoing transitions of a source; whether one is always taken, so that nothing follows."""
        return any(
            self._way(method, depth, region, source, leaf, complete, way, ())
            for way in self.flat.ways(source)
        )

    def _way(
        self,
        method: Method,
        depth: int,
        region: int,
        source: str,
        leaf: State | None,
        complete: Expr,
        way: Way,
        before: tuple[int, ...],
    ) -> bool:
        """The tests of a way around what taking it does; whether it is always taken."""
        if self.flat.transition(way.number).kind is TransitionKind.ON:
            self.taking.on(method, depth, region, way.number, complete)
            return False
        expression = self.flat.transition(way.number).expression
        tests: list[str] = []
        if expression.events and not expression.when:
            there = " or ".join(self.events.there(region, source, event) for event in expression.events)
            tests.append(f"({there})" if len(expression.events) > 1 else there)
        elif not expression.events and not expression.when and not before:
            if complete == FALSE:
                return False
            if complete != TRUE:
                tests.append(method.code(complete))
        if expression.every is not None:
            tests.append(f"now - self.{self.names.time_name(source)} >= {expression.every}")
        method.add(depth, f"# {self.names.place(way.number)}")
        outside = depth
        if expression.guard is not None:
            asked = signals(walk(expression.guard))
            if asked and tests:  # a signal is looked at only where its condition is evaluated
                method.add(depth, f"if {' and '.join(tests)}:")
                tests.clear()
                depth += 1
            for channel, host in asked:
                method.add(depth, f"{method.b}.ask({channel!r}, {host!r})")
            if not taken_message(expression):
                guard = self.actions.guard(method, region, way.number, expression.guard)
                tests += [guard] if guard else []
        if taken_message(expression):
            picked = self.events.pick(region, way.number, expression)
            tests.append(f"({mail_name(way.number)} := {picked}) is not None")
        if tests:
            method.add(depth, f"if {' and '.join(tests)}:")
            depth += 1
        taken = (*before, way.number)
        if self.chart.node(self.flat.transition(way.number).target).type is StateType.CONDITION:
            if not way.branches:
                method.add(depth, "pass  # no way out of the choice")
            always = any(
                self._way(method, depth, region, source, leaf, complete, branch, taken)
                for branch in way.branches
            )
            return always and depth == outside
        self.taking.take(method, depth, region, source, leaf, complete, taken)
        method.add(depth, "return True")
        return depth == outside


__all__ = ["Rounds"]
