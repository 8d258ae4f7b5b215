"""Formulas: the formulas of one role or participant as a table, and what may be wrong with them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence, Set
from dataclasses import field, replace
from typing import TypeVar, assert_never

from aseme_dsl.amola.aip import NamedFormula
from aseme_dsl.amola.liveness import Formula, canonical, fold, names, ungrouped, walk
from aseme_dsl.amola.messages import Parameter
from aseme_dsl.amola.operators import INFIX, Operator, Template
from aseme_dsl.amola.statechart import Argument
from aseme_dsl.diagnostics import Diagnostic, Related
from aseme_dsl.diagnostics.problems.formulas import (
    FormulaNotUsed,
    FormulaRecursive,
    FormulaTwice,
    LoopMayBeEmpty,
    OperatorsMixed,
    TooFewInstances,
)
from aseme_dsl.diagnostics.problems.names import VerbAsName
from aseme_dsl.grammar.text import tree
from aseme_dsl.records import dataclass

_T = TypeVar("_T")

Stops = Callable[[tuple[str, Formula]], bool]
"""Whether the way of a verb and term waits for time or for something that arrives."""


IsEmpty = Callable[[str, Set[str]], bool]
"""Whether the process of a participant may be done at once, if the formulas of the set may be."""


def _nothing_is_empty(name: str, formulas: Set[str]) -> bool:
    return False


def _nothing_stops(_: tuple[str, Formula]) -> bool:
    return False


@dataclass(frozen=True, slots=True)
class Formulas:
    """The formulas of a role (`player`) or participant (`attack.center`) by name, in document order.

    `root` is the name of the one that the others refine: a role's first, a participant's `process`.
    `taken_over` are those that stand in a role which this one includes: they need not be used.
    `parameters` are those of the formulas that have any, and `given` is what the names in formulas are given.
    `through` are the formulas that stand in a participant which a formula names, bound to its activities.
    `separate` are the choices `B | C` of `A [> (B | C)` whose branches interrupt A each by itself.
    """

    owner: str
    root: str
    named: Mapping[str, tree.NamedFormula] = field(default_factory=dict)
    taken_over: frozenset[str] = frozenset()
    parameters: Mapping[str, tuple[Parameter, ...]] = field(default_factory=dict)
    given: Mapping[Formula, tuple[Argument, ...]] = field(default_factory=dict)
    through: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    separate: frozenset[Formula] = frozenset()

    def formula(self, name: str) -> Formula | None:
        """The formula called `name`, or None if there is none."""
        found = self.named.get(name)
        return found.formula if found is not None else None

    def interrupts(self, term: Formula) -> tuple[Formula, ...]:
        """What interrupts the first operand of a `[>`: the second, or the branches of that choice."""
        second = ungrouped(term.operands[1])
        return second.operands if second in self.separate else term.operands[1:]

    @property
    def activities(self) -> frozenset[str]:
        """The names in the formulas that are not formulas themselves."""
        used = (node.name for item in self.named.values() for node in names(item.formula))
        return frozenset(used) - self.named.keys()


def table(
    owner: str, written: Sequence[tree.NamedFormula], root: str | None = None
) -> tuple[Formulas | None, tuple[Diagnostic, ...]]:
    """The table of what was written; of two formulas of one name the first counts (E301).

    None without a formula, or without one called `root` where that is given.
    """
    named: dict[str, tree.NamedFormula] = {}
    found: list[Diagnostic] = []
    for item in written:
        first = named.setdefault(item.name.text, item)
        if first is not item:
            found.append(
                Diagnostic(
                    FormulaTwice(item.name.text, owner),
                    item.name.span,
                    (Related(first.name.span, "the first one"),),
                )
            )
    root = root if root is not None else next(iter(named), None)
    if root is None or root not in named:
        return None, tuple(found)
    return Formulas(owner, root, named), tuple(found)


def named_formulas(formulas: Formulas | None) -> tuple[NamedFormula, ...]:
    """The formulas as the models have them."""
    if formulas is None:
        return ()
    return tuple(
        NamedFormula(name, item.formula, item.span, formulas.parameters.get(name, ()))
        for name, item in formulas.named.items()
    )


QUOTED = 70
"""How long a formula, a term or a name may be to be quoted in full."""


def cut(text: str, longest: int = QUOTED) -> str:
    """A text as a message quotes it: cut where it is long."""
    return text if len(text) <= longest else text[: longest - 1] + "…"


def shown(formula: Formula, longest: int = QUOTED) -> str:
    """The formula as a message quotes it: in canonical spelling, cut where it is long."""
    return cut(canonical(formula, longest), longest)


def check(
    formulas: Formulas,
    is_empty: IsEmpty = _nothing_is_empty,
    participants: frozenset[str] = frozenset(),
    stops: Stops = _nothing_stops,
) -> tuple[bool, tuple[Diagnostic, ...]]:
    """Whether the formulas can be expanded (no circles, no holes), and everything that is wrong with them.

    `participants` are the names of played participants; `is_empty` tells whether the process of one may do
    nothing at all. A circle through a formula that is named like one is a consequence of the name (E306).
    """
    cycles = list(_cycles(formulas))
    in_cycle = {name for cycle in cycles for name, _ in cycle}
    found = [
        _recursion(formulas, cycle) for cycle in cycles if participants.isdisjoint(name for name, _ in cycle)
    ]
    found += _unused(formulas)
    may_be_empty: set[str] = set()
    for name in dependencies_first(formulas):
        empty = fold(formulas.named[name].formula, _emptiness(formulas, may_be_empty, found, stops, is_empty))
        if empty and name not in in_cycle:
            may_be_empty.add(name)
    for item in formulas.named.values():
        found += _verbs(item)
        found += _mixed_operators(item.formula)
        found += _too_few_instances(item.formula)
    return not cycles and not has_holes(formulas) and _has_all_values(formulas), tuple(found)


def _has_all_values(formulas: Formulas) -> bool:
    """Whether every parameter has a value in the chart; where one has none, that is already reported."""
    if formulas.named[formulas.root].parameters:
        return False
    return all(
        node in formulas.given or not formulas.named[node.name].parameters
        for name in reached(formulas)
        for node in names(formulas.named[name].formula)
        if node.name in formulas.named
    )


def has_holes(formulas: Formulas) -> bool:
    """Whether an operator of any formula is still to be chosen: then there is no chart of them."""
    return any(
        node.operator is Operator.HOLE for item in formulas.named.values() for node in walk(item.formula)
    )


def may_be_empty(
    formulas: Formulas, stops: Stops, activities: Iterable[str] = ()
) -> tuple[bool, tuple[Diagnostic, ...]]:
    """Whether the whole may be done at once, without any activity and without a wait; and loops over such.

    `activities` are those that stand for what may be done at once.
    """
    empty, loops = set(activities), list[Diagnostic]()
    for name in dependencies_first(formulas):
        if fold(formulas.named[name].formula, _emptiness(formulas, empty, loops, stops)):
            empty.add(name)
    return formulas.root in empty, tuple(loops)


# ---- how formulas use each other ----------------------------------------------------------------


def uses(formulas: Formulas, name: str) -> Iterator[Formula]:
    """Where the formula called `name` uses another one (or itself), also through a participant."""
    for node in names(formulas.named[name].formula):
        if node.name in formulas.named:
            yield node
        else:
            yield from (replace(node, name=other) for other in formulas.through.get(node.name, ()))


def dependencies_first(formulas: Formulas) -> list[str]:
    """All names, each after those that its formula uses; a recursive use is left out of the order."""
    done: list[str] = []
    for step, name in _depth_first(formulas):
        if step == "leave":
            done.append(name)
    return done


def reached(formulas: Formulas) -> frozenset[str]:
    """The names that the root's expansion meets, the root included."""
    seen = {formulas.root}
    waiting = [formulas.root]
    while waiting:
        for node in uses(formulas, waiting.pop()):
            if node.name not in seen:
                seen.add(node.name)
                waiting.append(node.name)
    return frozenset(seen)


def _depth_first(formulas: Formulas) -> Iterator[tuple[str, str]]:
    """("enter", name) and ("leave", name) in depth-first order, and ("again", name) for a name on the way."""
    state: dict[str, str] = {}
    for root in formulas.named:
        if root in state:
            continue
        state[root] = "open"
        yield "enter", root
        stack = [(root, uses(formulas, root))]
        while stack:
            name, remaining = stack[-1]
            node = next(remaining, None)
            if node is None:
                state[name] = "done"
                stack.pop()
                yield "leave", name
            elif node.name not in state:
                state[node.name] = "open"
                yield "enter", node.name
                stack.append((node.name, uses(formulas, node.name)))
            elif state[node.name] == "open":
                yield "again", node.name


Cycle = list[tuple[str, Formula]]
"""The formulas of a circle, each with the place where the next one stands in it."""


def _cycles(formulas: Formulas) -> Iterator[Cycle]:
    """A circle for each case of formulas that need themselves; no formula is in two of them."""
    path: list[str] = []
    reported: set[str] = set()
    for step, name in _depth_first(formulas):
        if step == "enter":
            path.append(name)
        elif step == "leave":
            path.pop()
        else:
            circle = path[path.index(name) :]
            if reported.isdisjoint(circle):
                reported.update(circle)
                following = [*circle[1:], circle[0]]
                yield [
                    (one, next(node for node in uses(formulas, one) if node.name == other))
                    for one, other in zip(circle, following, strict=True)
                ]


def _recursion(formulas: Formulas, cycle: Cycle) -> Diagnostic:
    circle = (*(name for name, _ in cycle), cycle[0][0])
    last, place = cycle[-1]
    related = tuple(Related(node.span, f"`{name}` uses `{node.name}` here") for name, node in cycle[:-1]) or (
        Related(formulas.named[last].name.span, f"`{last}` is defined here"),
    )
    return Diagnostic(FormulaRecursive(circle), place.span, related)


def _unused(formulas: Formulas) -> Iterator[Diagnostic]:
    """Formulas that no other one names; what only such a formula uses is not reported as well."""
    used = {node.name for name in formulas.named for node in uses(formulas, name) if node.name != name}
    root = formulas.named[formulas.root]
    for name, item in formulas.named.items():
        if name not in used and name != formulas.root and name not in formulas.taken_over:
            yield Diagnostic(
                FormulaNotUsed(name, formulas.owner),
                item.name.span,
                (Related(root.name.span, f"`{formulas.root}` is the formula that the others refine"),),
            )


# ---- what a formula may not be ------------------------------------------------------------------


def _emptiness(
    formulas: Formulas,
    empty_names: set[str],
    found: list[Diagnostic],
    stops: Stops,
    is_empty: IsEmpty = _nothing_is_empty,
) -> Callable[[Formula, Sequence[bool]], bool]:
    """For `fold`: whether a formula may be done at once; loops over such go into `found`."""

    def at_once(verb: str, operand: Formula) -> bool:
        return not stops((verb, ungrouped(operand)))

    def combine(node: Formula, operands: Sequence[bool]) -> bool:
        parts, row = node.operands, node.operator.row
        match row.template:
            case Template.ACTIVITY:
                return node.name in empty_names or is_empty(node.name, empty_names)
            case Template.BRANCHES:
                return any(empty and at_once("enter", p) for p, empty in zip(parts, operands, strict=True))
            case Template.CUT:
                return operands[0]
            case Template.BODY:
                paced = not (row.repeats and at_once("repeat", parts[0]))
                if operands[0] and not paced:
                    found.append(_empty_loop(formulas, node))
                if row.skips:
                    return at_once("skip", parts[0]) or (operands[0] and at_once("enter", parts[0]))
                return row.leaves and operands[0] and paced
            case Template.INSIDE | Template.CHAIN | Template.REGIONS | Template.UNDECIDED:
                return all(operands)
            case _:
                assert_never(row.template)

    return combine


def _empty_loop(formulas: Formulas, loop: Formula) -> Diagnostic:
    body = ungrouped(loop.operands[0])
    related: tuple[Related, ...] = ()
    if body.operator is Operator.NAME and body.name in formulas.named:
        named = formulas.named[body.name]
        related = (Related(named.formula.span, f"`{body.name}` may be empty"),)
    simpler = None
    if body.operator.row.skips:
        operand = body.operands[0]
        inside = canonical(operand, QUOTED)
        inside = f"({inside})" if operand.operator in INFIX else inside
        simpler = inside + (Operator.ZERO_OR_MORE if loop.operator.row.leaves else Operator.FOREVER)
        simpler = simpler if len(simpler) <= QUOTED else None
    return Diagnostic(LoopMayBeEmpty(shown(loop), simpler), loop.span, related)


VERBS = ("enter", "skip", "repeat", "leave", "start", "finish")
"""What a control line begins with."""


def _verbs(item: tree.NamedFormula) -> Iterator[Diagnostic]:
    places = [(node.name, node.span) for node in names(item.formula)]
    for name, span in [(item.name.text, item.name.span), *places]:
        if name in VERBS:
            yield Diagnostic(VerbAsName(name), span)


def _mixed_operators(formula: Formula) -> Iterator[Diagnostic]:
    """One warning for each formula or group in which infix operators stand beside each other."""
    waiting = [(formula, False)]
    while waiting:
        node, inside = waiting.pop()
        infix = node.operator in INFIX
        mixed = infix and any(
            operand.operator in INFIX and operand.operator is not node.operator for operand in node.operands
        )
        mixed = mixed and all(part.operator is not Operator.HOLE for part in (node, *node.operands))
        if mixed and not inside:
            yield Diagnostic(OperatorsMixed(shown(node), _with_parentheses(node)), node.span)
        waiting += [(operand, infix and (mixed or inside)) for operand in reversed(node.operands)]


def _with_parentheses(formula: Formula) -> str:
    def combine(node: Formula, operands: Sequence[Formula]) -> Formula:
        if node.operator in INFIX:
            operands = [
                Formula(Operator.GROUP, (operand,), operand.span) if operand.operator in INFIX else operand
                for operand in operands
            ]
        return replace(node, operands=tuple(operands))

    return shown(fold(formula, combine), 200)


def _too_few_instances(formula: Formula) -> Iterator[Diagnostic]:
    for node in walk(formula):
        if node.operator is Operator.INSTANCES and node.count < 2:
            yield Diagnostic(TooFewInstances(shown(node), node.count), node.span)


__all__ = [
    "QUOTED",
    "Formulas",
    "Stops",
    "check",
    "cut",
    "dependencies_first",
    "may_be_empty",
    "named_formulas",
    "reached",
    "shown",
    "table",
    "uses",
]
