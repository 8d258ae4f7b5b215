"""Interrupts: whether the branches of `A [> (B | C)` interrupt A each by itself, or as one choice."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace

from aseme_dsl.amola.liveness import Formula, term_key, ungrouped, walk
from aseme_dsl.amola.operators import Operator, Template
from aseme_dsl.compiler.formula.formulas import Formulas
from aseme_dsl.grammar.text import tree


def with_interrupts(formulas: Formulas, controls: Iterable[tuple[tree.Control, str]]) -> Formulas:
    """The formulas with the choices whose branches interrupt each by itself.

    `controls` come with the names of their formulas. Such a choice has `enter` lines for branches, and no
    line that names the choice as a whole. A line by label counts as one, since it may name its state.
    """
    lines: dict[str, list[tree.Way | tree.LabelledWay]] = {}
    for control, name in controls:
        lines.setdefault(name, []).extend(control.entries)
    separate: set[Formula] = set()
    for name, written in lines.items():
        ways = [entry for entry in written if isinstance(entry, tree.Way)]
        if name not in formulas.named or len(ways) < len(written):
            continue
        entered = {term_key(way.term.formula) for way in ways if way.verb.text in ("enter", "resume")}
        named = {term_key(way.term.formula) for way in ways}
        for choice in _choices(formulas.named[name].formula):
            branches = {term_key(branch) for branch in choice.operands}
            bare = {ungrouped(branch).name for branch in choice.operands} - {""}
            if term_key(choice) not in named and entered & (branches | bare):
                separate.add(choice)
    return replace(formulas, separate=frozenset(separate)) if separate else formulas


def _choices(formula: Formula) -> Iterator[Formula]:
    """Every choice that stands behind `[>`."""
    for node in walk(formula):
        if node.operator.row.template is Template.CUT:
            second = ungrouped(node.operands[1])
            if second.operator is Operator.CHOICE:
                yield second


__all__ = ["with_interrupts"]
