"""Composites that go on where they were left."""

from __future__ import annotations

from aseme_dsl.amola.statechart import State, StateType
from aseme_dsl.codegen.code.face import docstring, key_of
from aseme_dsl.codegen.step.entering import Entering
from aseme_dsl.codegen.step.names import Method, Part, StepNames


class Resuming(Part):
    """Composites that go on where they were left."""

    def __init__(self, names: StepNames, entering: Entering) -> None:
        super().__init__(names)
        self.entering = entering

    def keep(self, node: State) -> None:
        """A method that remembers where a composite is left, before it is; nothing if it is complete."""
        region = self.flat.region_number[node.label]
        method = self.names.writing(region)
        inside = [region, *(inner.number for inner in self.flat.regions_inside(node.label))]
        kept = ", ".join(f"{number}: self.r{number}" for number in inside)
        end = self.chart.end_of(node.label)
        value = f"{{{kept}}}"
        if end is not None:
            value = f"None if self.r{region} == {self.flat.leaf[end.label]} else {value}"
        method.add(2, f"self.{self.names.kept(node)} = {value}")
        name = f"_keep_{key_of(node.label)}(self) -> None"
        self.names.method(name, f"Remember where {node.label} {docstring(node.name)} is left.", method)

    def resume(self, node: State) -> None:
        """A method by which a composite that has been entered goes on with what is remembered."""
        region = self.flat.region_number[node.label]
        method = self.names.writing(region)
        method.add(2, f"kept = self.{self.names.kept(node)} or {{}}", f"self.{self.names.kept(node)} = None")
        method.add(2, f"n = kept.get({region}, INACTIVE)")
        if self.chart.is_branch(node):
            self.entering.activate_start(method, 2, region, node.label)
        else:
            self._where_it_was(method, region, node.label)
        name = f"_resume_{key_of(node.label)}(self, now: int) -> None"
        self.names.method(name, f"Go on in {node.label} {docstring(node.name)}.", method)

    def again(self, region: int) -> None:
        """A method that enters a region in which a composite around it goes on."""
        label = self.flat.regions[region].label
        method = self.names.writing(region)
        self.entering.begin_region(method, region)
        method.add(2, f"n = kept.get({region}, INACTIVE)")
        self._where_it_was(method, region, label)
        signature = f"_again_{region}(self, now: int, kept: dict[int, int]) -> None"
        self.names.method(signature, f"Enter region {label} where it was left.", method)

    def _where_it_was(self, method: Method, region: int, label: str) -> None:
        """Enter the leaf `n` inside the state `label`, or its START; the inside of a branch begins anew."""
        branches: set[str] = set()
        branched = False
        for leaf in self.flat.leaves(region):
            if not leaf.label.startswith(f"{label}."):
                continue
            inner = next(
                (
                    around.label
                    for around in reversed(self.flat.around(leaf.label))
                    if around.label.startswith(f"{label}.") and self.chart.is_branch(around)
                ),
                None,
            )
            if inner is not None and inner in branches:
                continue
            number = self.flat.leaf[leaf.label]
            word = "elif" if branched else "if"
            branched = True
            if inner is not None:
                branches.add(inner)
                first, last = self.flat.range[inner]
                method.add(2, f"{word} {first} <= n <= {last}:")
                self.entering.enter(method, 3, region, label, inner)
                continue
            method.add(2, f"{word} n == {number}:")
            self.entering.enter(method, 3, region, label, leaf.label, again=True)
            if leaf.type is StateType.BASIC:
                method.add(2, f"elif n == {number + 1}:")
                self.entering.enter(method, 3, region, label, leaf.label, complete=True)
        method.add(2, "else:")
        self.entering.activate_start(method, 3, region, label)


__all__ = ["Resuming"]
