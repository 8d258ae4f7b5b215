"""Where regions go: what is done as states are left and entered."""

from __future__ import annotations

from aseme_dsl.amola.statechart import State, StateType
from aseme_dsl.codegen.code.tree import (
    NONE,
    Block,
    Const,
    Do,
    Name,
    Note,
    Set,
    Statement,
    own,
    own_call,
)
from aseme_dsl.codegen.plain.actions import Actions
from aseme_dsl.codegen.plain.bodies import Body, dispatch
from aseme_dsl.codegen.plain.names import PlainNames
from aseme_dsl.codegen.program.moves import left_with, path


class Places:
    """The statements by which regions leave states and come to others."""

    def __init__(self, names: PlainNames, actions: Actions) -> None:
        self._names = names
        self._actions = actions
        self._flat = names.flat
        self._chart = names.chart
        self._leaving: dict[int, bool] = {}
        """The regions whose leaving is written; False for those with nothing to do."""
        self._times = frozenset(map(actions.entered_now, names.registers.timed))

    def leave(self, region: int, scope: str, leaf: State, number: int | None) -> Block:
        """What is done as everything inside `scope` is left; None for a BASIC state that may be complete."""
        found: list[Statement] = []
        if leaf.type is StateType.BASIC and (self._names.options.watched or self._names.may_fail):
            found += self._actions.stop(leaf, number)
        elif leaf.type is StateType.AND:
            for inner in self._flat.regions_of(leaf.label):
                found += self.leave_region(inner.number)
        for node in left_with(self._flat, leaf, scope):
            found += self._actions.left(region, node)
        return tuple(found)

    def leave_region(self, region: int) -> Block:
        """The call of the method that leaves a region, if there is anything to do."""
        name = f"_leave_{region}"
        if region not in self._leaving:
            self._leaving[region] = False
            label = self._flat.regions[region].label
            bodies = [
                Body(number, number, leaf.label, title, title, self.leave(region, label, leaf, number))
                for leaf in self._flat.leaves(region)
                for number in range(self._flat.leaf[leaf.label], self._names.last(leaf) + 1)
                for title in [self._names.title(leaf, number)]
            ]
            outermost = self._actions.left(region, self._chart.node(label))
            block = (*dispatch(region, bodies), *outermost)
            if block:
                self._leaving[region] = True
                self._names.method(name, "None", f"Leave region {label}.", block)
        return (Do(own_call(name)),) if self._leaving[region] else ()

    def enter(self, region: int, scope: str, target: str, number: int | None = None) -> Block:
        """Enter a state inside `scope`, outermost first; `number` is that of the region so far."""
        return (*self._into(scope, target), *self.enter_inside(region, target, number))

    def _into(self, scope: str, target: str) -> Block:
        entered = reversed(path(self._chart, scope, target))
        return tuple(item for label in entered for item in self._actions.on_entry(self._chart.node(label)))

    def enter_inside(self, region: int, target: str, number: int | None = None) -> Block:
        """Make the leaf of an entered state active, and the leaves of the regions inside it.

        The numbers of all regions are set before any call that may raise (`took`, the methods of activities).
        So each region has an active leaf even if such a call raises.
        """
        stands: list[Statement] = []
        found: list[Statement] = []
        stack = [(region, target, number)]
        rests = self._names.rests
        while stack:
            region, target, number = stack.pop()
            node = self._chart.node(target)
            if target == self._flat.regions[region].label and region:
                found += self._begin_region(region)
            if node.type is StateType.OR:
                start = self._chart.start_of(target)
                assert start is not None
                found += self._actions.on_entry(start)
                stack.append((region, start.label, number))
            elif target in rests.passed:
                found += self._pass(region, node)
                stack.append((region, rests.passed[target].target, number))
            else:
                stands += self._stand(region, node, number)
                if target in self._names.registers.ending:
                    found += (Set((place,), NONE) for place in self._names.outcomes_of(target))
                if node.type is StateType.BASIC and not node.waits and self._names.options.watched:
                    found.append(self._actions.begin(region, node))
                elif node.type is StateType.AND:
                    inner = [(item.number, item.label, None) for item in self._flat.regions_of(target)]
                    stack += reversed(inner)
        times = dict.fromkeys(item for item in found if item in self._times)
        return (*stands, *times, *(item for item in found if item not in self._times))

    def _stand(self, region: int, leaf: State, number: int | None) -> Block:
        """Note which leaf is active, where that is not known."""
        entered = self._flat.leaf[leaf.label]
        if self._flat.regions[region].size == 1 or entered == number:
            return ()
        value = bool(entered) if region in self._names.truths else entered
        return (Set((own(f"r{region}"),), Const(value), self._names.title(leaf, entered)),)

    def _pass(self, region: int, node: State) -> Block:
        """Take the transition of a START or END that has no number, as part of the move that enters it."""
        way = self._names.rests.passed[node.label]
        step = self._flat.transition_number[id(way)]
        scope = self._chart.scope_of(way)
        actions = self._actions.of(region, step)
        note = [Note(self._names.place(step))] if actions else []
        left = self.leave(region, scope, node, None)
        return (*self._actions.took((step,)), *left, *note, *actions, *self._into(scope, way.target))

    def _begin_region(self, region: int) -> Block:
        """What a region of an AND begins with: its copies of variables, no timers."""
        found: list[Statement] = []
        for name, copies in self._names.copied.items():
            regions = self._names.uses.variable_regions[name]
            around = next((item for item in self._flat.regions_around(region) if item in regions), None)
            if region in copies and around is not None:
                found.append(Set((self._names.copy(name, region),), self._names.variable(name, around)))
        timers = self._names.registers.timers.get(region, ())
        if timers:
            found.append(Set(tuple(self._names.timer(region, timer) for timer in timers), Name("NEVER")))
        return (*found, *self._actions.on_entry(self._chart.node(self._flat.regions[region].label)))


__all__ = ["Places"]
