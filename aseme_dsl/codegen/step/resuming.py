"""Generates the methods that resume composite states (deep history)."""

from __future__ import annotations

from aseme_dsl.amola.statechart import State, StateType
from aseme_dsl.codegen.code.face import docstring, key_of
from aseme_dsl.codegen.program.moves import path
from aseme_dsl.codegen.step.entering import Entering
from aseme_dsl.codegen.step.names import Method, Part, StepNames


class Resuming(Part):
    """The methods that remember and resume the last configuration of composite states."""

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
        """A method that resumes the remembered configuration of a composite that has just been entered."""
        region = self.flat.region_number[node.label]
        method = self.names.writing(region)
        method.add(2, f"kept = self.{self.names.kept(node)} or {{}}", f"self.{self.names.kept(node)} = None")
        method.add(2, f"n = kept.get({region}, INACTIVE)")
        if self.chart.is_branch(node):
            self._inside(method, region, node.label)
        else:
            self._where_it_was(method, region, node.label)
        name = f"_resume_{key_of(node.label)}(self, now: int) -> None"
        self.names.method(name, f"Go on in {node.label} {docstring(node.name)}.", method)

    def proceed(self, branch: State) -> None:
        """Methods that resume a suspended participant subchart and the regions inside it."""
        region = self.flat.region_number[branch.label]
        method = self.names.writing(region)
        method.add(2, f"n = kept.get({region}, INACTIVE)")
        self._inside(method, region, branch.label)
        signature = f"_proceed_{key_of(branch.label)}(self, now: int, kept: dict[int, int]) -> None"
        document = f"Go on in {branch.label} {docstring(branch.name)}, which was suspended."
        self.names.method(signature, document, method)
        for inner in self.flat.regions_inside(branch.label):
            method = self.names.writing(inner.number)
            method.add(2, f"timers = self.b{inner.number}.timers")
            self.entering.renew_region(method, inner.number)
            method.add(2, f"self.b{inner.number}.timers = timers")
            method.add(2, f"n = kept.get({inner.number}, INACTIVE)")
            self._inside(method, inner.number, inner.label)
            signature = f"_proceed_{inner.number}(self, now: int, kept: dict[int, int]) -> None"
            self.names.method(signature, f"Go on in region {inner.label}, which was suspended.", method)

    def _inside(self, method: Method, region: int, label: str) -> None:
        """Be at the leaf `n` again, without an entry: what ran starts anew."""
        method.add(2, f"self.r{region} = n")
        for branch in self.flat.branches:  # participants inside the resumed one
            if branch.label.startswith(f"{label}.") and self.flat.region_number[branch.label] == region:
                first, last = self.flat.range[branch.label]
                method.add(2, f"if {first} <= n <= {last}:")
                method.add(3, f"self.proceed_inside({branch.label!r})")
        word = "if"
        for leaf in self.flat.leaves(region):
            if not leaf.label.startswith(f"{label}.") or leaf.type not in (StateType.BASIC, StateType.AND):
                continue
            method.add(2, f"{word} n == {self.flat.leaf[leaf.label]}:")
            word = "elif"
            if leaf.type is StateType.AND:
                for inner in self.flat.regions_of(leaf.label):
                    method.add(3, f"self._proceed_{inner.number}(now, kept)")
                continue
            if leaf.label in self.registers.ending:
                method.add(3, f"self.await_outcome({leaf.label!r})")
            method.add(3, f"self.k{region} = {self.entering.begin(leaf)}")

    def again(self, region: int) -> None:
        """A method that enters a region of an AND inside a composite that is resumed."""
        label = self.flat.regions[region].label
        method = self.names.writing(region)
        self.entering.begin_region(method, region)
        method.add(2, f"n = kept.get({region}, INACTIVE)")
        self._where_it_was(method, region, label)
        signature = f"_again_{region}(self, now: int, kept: dict[int, int]) -> None"
        self.names.method(signature, f"Enter region {label} where it was left.", method)

    def _where_it_was(self, method: Method, region: int, label: str) -> None:
        """Enter the leaf `n` inside the state `label`, or its START.

        A suspended participant subchart is resumed.
        """
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
                method.add(3, f"if self.proceed({inner!r}):")
                for around in reversed(path(self.chart, label, inner)[1:]):
                    self.entering.on_entry(method, 4, region, self.chart.node(around))
                method.add(4, f"self._proceed_{key_of(inner)}(now, kept)")
                method.add(3, "else:")
                self.entering.enter(method, 4, region, label, inner, again=True)
                continue
            method.add(2, f"{word} n == {number}:")
            self.entering.enter(method, 3, region, label, leaf.label, again=True)
            if leaf.type is StateType.BASIC:
                method.add(2, f"elif n == {number + 1}:")
                self.entering.enter(method, 3, region, label, leaf.label, complete=True)
        method.add(2, "else:")
        self.entering.activate_start(method, 3, region, label)


__all__ = ["Resuming"]
