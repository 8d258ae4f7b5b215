"""Entering states: what is noted of them, and the activities that begin."""

from __future__ import annotations

from typing import assert_never

from aseme_dsl.amola.statechart import State, StateType, split_targets
from aseme_dsl.codegen.code.face import docstring, key_of
from aseme_dsl.codegen.code.tree import (
    NOW,
    all_of,
)
from aseme_dsl.codegen.code.values import converted, evaluate
from aseme_dsl.codegen.program.flat import FlatRegion
from aseme_dsl.codegen.program.moves import path, raises
from aseme_dsl.codegen.step.actions import Actions
from aseme_dsl.codegen.step.names import Method, Part, StepNames


class Entering(Part):
    """Entering states: what is noted of them, and the activities that begin."""

    def __init__(self, names: StepNames, actions: Actions) -> None:
        super().__init__(names)
        self.actions = actions

    def enter(
        self,
        method: Method,
        depth: int,
        region: int,
        scope: str,
        target: str,
        *,
        resume: bool = False,
        again: bool = False,
        complete: bool = False,
        into: tuple[str, ...] = (),
    ) -> None:
        """Enter a state inside `scope`, outermost first.

        `into` are states in regions of the target, an AND, that are entered instead of the STARTs there.
        With `resume` a composite target resumes its last configuration. The other two are for states inside
        it: `again` for an AND whose regions resume, too, `complete` for a BASIC state whose activity has
        returned.
        """
        for label in reversed(path(self.chart, scope, target)):
            if self.chart.is_region(label):
                self._enter_one(method, depth, region, label, target, resume, into)
                return
            entered = self.chart.node(label)
            if not again and self.history.suspends(entered) and not (label == target and resume):
                but = f", {target!r}" if resume else ""
                method.add(depth, f"self.discard({label!r}{but})")
            if label != target or not (resume and self.chart.is_branch(entered)):
                self.on_entry(method, depth, region, entered)
        node = self.chart.node(target)
        number = self.flat.leaf.get(target)
        match node.type:
            case StateType.BASIC if complete:
                method.add(depth, f"self.r{region} = {number} + 1")
            case StateType.BASIC:
                method.add(depth, f"self.r{region} = {number}")
                if target in self.registers.ending:
                    method.add(depth, f"self.await_outcome({target!r})")
                method.add(depth, f"self.k{region} = {self.begin(node)}")
            case StateType.AND if into:
                self._enter_parts(method, depth, region, target, into)
            case StateType.AND:
                method.add(depth, f"self.r{region} = {number}")
                for inner in self.flat.regions_of(target):
                    call = f"_again_{inner.number}(now, kept)" if again else f"_enter_{inner.number}(now)"
                    method.add(depth, f"self.{call}")
            case StateType.OR if resume and self.chart.is_branch(node):
                method.add(depth, f"if self.proceed({target!r}):", f"    self._resume_{key_of(target)}(now)")
                method.add(depth, "else:")
                self.on_entry(method, depth + 1, region, node)
                self.activate_start(method, depth + 1, region, target)
            case StateType.OR if resume:
                method.add(depth, f"if self.{self.names.kept(node)} is None:")
                self.activate_start(method, depth + 1, region, target)
                method.add(depth, "else:", f"    self._resume_{key_of(target)}(now)")
            case StateType.OR:
                self.activate_start(method, depth, region, target)
            case StateType.START | StateType.END | StateType.CONDITION:
                method.add(depth, f"self.r{region} = {number}")
            case _:
                assert_never(node.type)

    def _enter_one(
        self,
        method: Method,
        depth: int,
        region: int,
        entered: str,
        target: str,
        resume: bool,
        into: tuple[str, ...],
    ) -> None:
        """Enter an AND, in one of its regions (`entered`) the target instead of its START."""
        around = self.chart.node(entered).parent
        assert around is not None
        method.add(depth, f"self.r{region} = {self.flat.leaf[around]}")
        for inner in self.flat.regions_of(around):
            if inner.label == entered:
                self._begin_part(method, depth, inner)
                self.enter(method, depth, inner.number, entered, target, resume=resume, into=into)
            else:
                method.add(depth, f"self._enter_{inner.number}(now)")

    def _enter_parts(
        self, method: Method, depth: int, region: int, parallel: str, into: tuple[str, ...]
    ) -> None:
        """Enter an AND, in some of its regions a target instead of their STARTs."""
        method.add(depth, f"self.r{region} = {self.flat.leaf[parallel]}")
        for inner in self.flat.regions_of(parallel):
            part = split_targets(inner.label, into)
            if part is None:
                method.add(depth, f"self._enter_{inner.number}(now)")
            else:
                self._begin_part(method, depth, inner)
                self.enter(method, depth, inner.number, inner.label, part[0], into=part[1])

    def _begin_part(self, method: Method, depth: int, region: FlatRegion) -> None:
        """Begin a region of an AND in which another state than its START is entered."""
        if self.history.suspends(self.chart.node(region.label)):
            method.add(depth, f"self.discard({region.label!r})")
        begin = self.names.writing(region.number)
        self.begin_region(begin, region.number)
        method.take(depth - 2, begin)

    def begin(self, node: State) -> str:
        """The call that starts the activity of a state; with arguments in a method of its own."""
        if not node.arguments:
            return f"self.begin({node.label!r}, {node.activity!r})"
        name = f"_begin_{key_of(node.label)}"
        if self.names.is_new(name):
            self._begin_given(name, node)
        return f"self.{name}(now)"

    def _begin_given(self, name: str, node: State) -> None:
        """Compute what an activity is given; where that cannot be, the state has failed."""
        region = self.flat.region_number[node.label]
        method = self.names.writing(region)
        self.names.asked_at(node.label, method.names)
        types = self.registers.parameters(node)
        for number, argument in enumerate(node.arguments):
            can_raise = raises(argument.value)
            piece = evaluate(argument.value, method.names)
            what = f"the argument `{argument.name}`"
            depth = 2
            if can_raise:
                method.add(depth, "try:")
                depth += 1
            if piece.needs:
                method.add(depth, f"if not ({method.code(all_of(piece.needs))}):")
                method.add(depth + 1, f"return self.not_given({node.label!r}, {f'{what} is absent'!r})")
            kind = types.get(argument.name, argument.value.type)
            method.add(depth, f"given_{number} = {method.code(converted(piece, argument.value.type, kind))}")
            if can_raise:
                method.add(2, "except Exception as error:")
                method.add(3, f"return self.not_given({node.label!r}, {what!r}, error)")
        given = "".join(f"({item.name!r}, given_{n}), " for n, item in enumerate(node.arguments)).rstrip()
        method.add(2, f"return self.begin({node.label!r}, {node.activity!r}, ({given}))")
        document = f"Start {docstring(node.name)}, the activity of {node.label}."
        self.names.method(f"{name}(self, now: int) -> int", document, method)

    def on_entry(self, method: Method, depth: int, region: int, node: State) -> None:
        """What belongs to every entry of a state."""
        if self.chart.is_branch(node):
            method.add(depth, f"self.join({node.label!r})")
        for variable in self.chart.variables:
            if variable.scope == node.label:
                if len(self.uses.variable_regions[variable.name]) > 1:
                    method.add(depth, f"self.renew({variable.name!r})")
                self.actions.write(method, depth, region, variable.name, self.names.initial(variable))
        if node.label in self.registers.timed:
            method.add(depth, f"self.{self.names.time_name(node.label)} = {method.now}")
        for number in self.flat.staying.get(node.label, ()):
            if self.names.has_mark(number):
                method.add(depth, f"self.{self.names.mark(number)} = None")
            if self.names.has_time(number):
                method.add(depth, f"self.{self.names.past(number)} = -1")
        for label, loop in self.registers.counted.items():
            if loop == node.label:
                method.add(depth, f"self.{self.names.count_name(label)} = 0")
        if node.label in self.registers.counted:
            method.add(depth, f"self.{self.names.count_name(node.label)} += 1")
        if self.chart.is_branch(node):
            for inner in self.history.resumed:
                if inner.label.startswith(f"{node.label}."):
                    method.add(depth, f"self.{self.names.kept(inner)} = None")

    def activate_start(self, method: Method, depth: int, region: int, label: str) -> None:
        start = self.chart.start_of(label)
        assert start is not None
        method.add(depth, f"self.r{region} = {self.flat.leaf[start.label]}")
        if start.label in self.registers.timed:
            method.add(depth, f"self.{self.names.time_name(start.label)} = {method.now}")

    def enter_region(self, region: int) -> None:
        label = self.flat.regions[region].label
        method = self.names.writing(region)
        if self.history.suspends(self.chart.node(label)):
            method.add(2, f"self.discard({label!r})")
        self.begin_region(method, region)
        self.activate_start(method, 2, region, label)
        self.names.method(f"_enter_{region}(self, now: int) -> None", f"Enter region {label}.", method)

    def begin_region(self, method: Method, region: int) -> None:
        """The blackboard of a region that is entered, and what is done on its entry."""
        self.renew_region(method, region)
        self.on_entry(method, 2, region, self.chart.node(self.flat.regions[region].label))

    def renew_region(self, method: Method, region: int) -> None:
        """The blackboard of a region that is entered, and its copies of variables."""
        outer = self.flat.enclosing(region)
        method.add(2, f"self.b{region} = Board{region}()", f"self.b{region}.inherit(self.b{outer})")
        if region in self.uses.awaited:
            method.add(2, "if self.events:", f"    self.miss({region})")
        for name, regions in self.uses.variable_regions.items():
            if len(regions) > 1 and region in regions:
                around = outer
                while around is not None and around not in regions:
                    around = self.flat.enclosing(around)
                if around is not None:
                    copies = (self.names.variable(name, item) for item in (region, around))
                    method.add(2, " = ".join(f"self.{copy}" for copy in copies))

    def enter_root(self) -> None:
        method = self.names.writing(0)
        root = self.chart.root
        self.on_entry(method, 2, 0, root)
        self.activate_start(method, 2, 0, root.label)
        if NOW.name in method.used:
            method.lines.insert(0, "        now = self.now")
        self.names.method("enter(self) -> None", "Enter the root.", method)


__all__ = ["Entering"]
