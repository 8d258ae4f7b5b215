"""Leaving states: from what is active inward out, with what is done then."""

from __future__ import annotations

from aseme_dsl.amola.statechart import State, StateType
from aseme_dsl.codegen.code.face import docstring, key_of
from aseme_dsl.codegen.code.tree import (
    NOW,
)
from aseme_dsl.codegen.step.actions import Actions
from aseme_dsl.codegen.step.names import Method, Part, StepNames


class Leaving(Part):
    """Leaving states: from what is active inward out, with what is done then."""

    def __init__(self, names: StepNames, actions: Actions) -> None:
        super().__init__(names)
        self.actions = actions

    def exit(self, node: State) -> None:
        """A method with what is done when a state is left."""
        region = self.flat.region_number[node.label]
        method = self.names.writing(region)
        for transition in self.chart.exits_of(node.label):
            number = self.flat.transition_number[id(transition)]
            method.add(2, f"# {self.names.place(number)}", f"self.taken.append(({number},))")
            for channel, host in self.actions.actions(method, 2, region, node.label, (number,)):
                self.actions.consume(method, 2, region, channel, host)
        if NOW.name in method.used:
            method.lines.insert(0, "        now = self.now")
        name = f"_exit_{key_of(node.label)}(self) -> None"
        self.names.method(name, f"What is done when {node.label} {docstring(node.name)} is left.", method)

    def abandon(self, branch: State) -> None:
        """A method with what is done when the branch of a participant is left before it is complete."""
        region = self.flat.region_number[branch.label]
        method = self.names.writing(region)
        for transition in self.chart.abandons[branch.label]:
            number = self.flat.transition_number[id(transition)]
            method.add(2, f"# {self.names.place(number)}", f"self.taken.append(({number},))")
            for channel, host in self.actions.actions(method, 2, region, branch.label, (number,)):
                self.actions.consume(method, 2, region, channel, host)
        if NOW.name in method.used:
            method.lines.insert(0, "        now = self.now")
        name = f"_abandon_{key_of(branch.label)}(self) -> None"
        document = f"What {branch.label} {docstring(branch.name)} does when it is left before its END."
        self.names.method(name, document, method)

    def _left(self, node: State, leaf: State | None = None) -> list[str]:
        """What is done when a state is left, after what is inside it: the active `leaf`, if that is known."""
        lines = [f"self._exit_{key_of(node.label)}()"] if self.chart.exits_of(node.label) else []
        if not self.chart.is_branch(node):
            return lines
        end = next((n for n in self.chart.children(node.label) if n.type is StateType.END), None)
        if end is None or (leaf is not None and leaf is not end):
            return [*lines, f"self.part({node.label!r})"]
        place = f"self.r{self.flat.region_number[end.label]} == {self.flat.leaf[end.label]}"
        return [*lines, f"self.part({node.label!r}, completed={'True' if leaf is end else place})"]

    def _kept(self, node: State) -> list[str]:
        """What remembers where a composite is left, while the region around it stays active."""
        lines = [f"self._keep_{key_of(node.label)}()"]
        if self.history.suspends(node):
            lines += [f"if self.{self.names.kept(node)} is not None:", f"    self.hold({node.label!r})"]
        return lines

    def leave_leaf(
        self, method: Method, depth: int, region: int, scope: str, leaf: State | None, complete: bool
    ) -> None:
        for node in self.history.resumed:
            if self.flat.region_number[node.label] != region or not node.label.startswith(scope + "."):
                continue
            first, last = self.flat.range[node.label]
            if leaf is None:
                method.add(depth, f"if {first} <= self.r{region} <= {last}:")
                method.add(depth + 1, *self._kept(node))
            elif leaf.label.startswith(f"{node.label}."):
                method.add(depth, *self._kept(node))
        if leaf is None:
            method.add(depth, f"self._leave_leaf_{region}()")
            for node in reversed(self.history.leaving):
                if self.flat.region_number[node.label] == region and node.label.startswith(scope + "."):
                    first, last = self.flat.range[node.label]
                    method.add(depth, f"if {first} <= self.r{region} <= {last}:")
                    method.add(depth + 1, *self._left(node))
            return
        if leaf.type is StateType.BASIC and not complete:
            method.add(depth, f"self.cancel({leaf.label!r}, {leaf.activity!r}, self.k{region})")
        elif leaf.type is StateType.AND:
            for inner in self.flat.regions_of(leaf.label):
                method.add(depth, f"self._leave_{inner.number}()")
        if leaf.type in (StateType.BASIC, StateType.AND):
            method.add(depth, *self._left(leaf))
        for around in self.flat.around(leaf.label):
            if len(around.label) > len(scope):
                method.add(depth, *self._left(around, leaf))

    def leave(self, region: int) -> None:
        """Methods that exit the active states of a region."""
        running = [n for n in self.flat.leaves(region) if n.type is StateType.BASIC]
        ands = [n for n in self.flat.leaves(region) if n.type is StateType.AND]
        left = [n for n in running if self._left(n)]
        method = self.names.writing(region)
        if running or ands:
            method.add(2, f"r = self.r{region}")
        if running:
            method.add(2, f"running = _RUNNING_{region}.get(r)")
            method.add(2, "if running is not None:", f"    self.cancel(*running, self.k{region})")
            table = {self.flat.leaf[n.label]: (n.label, n.activity) for n in running}
            self.names.tables += ["", f"_RUNNING_{region}: dict[int, tuple[str, str]] = {table!r}"]
        for node in left:
            first = self.flat.leaf[node.label]
            method.add(2, f"if {first} <= r <= {first + 1}:", *(f"    {line}" for line in self._left(node)))
        for node in ands:
            method.add(2, f"if r == {self.flat.leaf[node.label]}:")
            for inner in self.flat.regions_of(node.label):
                method.add(3, f"self._leave_{inner.number}()")
            method.add(3, *self._left(node))
        if not method.lines:
            method.add(2, "return")
        label = self.flat.regions[region].label
        self.names.method(
            f"_leave_leaf_{region}(self) -> None", f"Leave the active leaf of region {label}.", method
        )
        whole = self.names.writing(region)
        for node in self.history.resumed:
            if self.flat.region_number[node.label] == region:
                first, last = self.flat.range[node.label]
                whole.add(2, f"if {first} <= self.r{region} <= {last}:")
                whole.add(3, f"self._keep_{key_of(node.label)}()")
        whole.add(2, f"self._leave_leaf_{region}()")
        for node in reversed(self.history.leaving):
            if self.flat.region_number[node.label] == region:
                first, last = self.flat.range[node.label]
                whole.add(2, f"if {first} <= self.r{region} <= {last}:")
                whole.add(3, *self._left(node))
        for node in self.history.resumed:
            if self.flat.region_number[node.label] == region and self.history.suspends(node):
                whole.add(2, f"self.discard({node.label!r})")
        whole.add(2, f"self.r{region} = INACTIVE")
        self.names.method(f"_leave_{region}(self) -> None", f"Leave region {label}.", whole)


__all__ = ["Leaving"]
