"""Waits: events of a choice that are waited for only when what stands before the choice is complete."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import pairwise

from aseme_dsl.amola.expression import Failed, Raised
from aseme_dsl.amola.liveness import Formula, ungrouped
from aseme_dsl.amola.operators import Operator, Template, is_choice
from aseme_dsl.compiler.control.control import Lines
from aseme_dsl.compiler.formula.formulas import Formulas
from aseme_dsl.compiler.formula.terms import Terms, spelling, terms_of
from aseme_dsl.diagnostics import Diagnostic, Related
from aseme_dsl.diagnostics.problems.control import EventWaits
from aseme_dsl.grammar.text import tree


def check_waits(
    formulas: Formulas, controls: Mapping[str, str], terms: Terms, lines: Lines
) -> Iterator[Diagnostic]:
    """W405 for each term of a sequence that begins with a choice whose branch has an event or `when`.

    The choice may stand in another formula, which the term names. A line for the entry transition of the term
    says that the wait is meant, or interrupts what stands before. A choice that a message of an agent decides
    is a place to wait at; `after` counts from the choice in any case. `controls` gives each formula the name
    that its control block has.
    """
    for sequence in terms.parents:
        if sequence.operator.row.template is not Template.CHAIN:
            continue
        operands = [ungrouped(operand) for operand in sequence.operands]
        for before, term in pairwise(operands):
            if lines.of(("enter", term)):
                continue
            for owner, choice in _first_choices(formulas, lines, terms.formula, term):
                inside = terms
                if owner != terms.formula:
                    inside = terms_of(formulas, owner, controls.get(owner, owner))
                yield from _waits(terms, before, term, inside, lines, choice)


def _waits(
    terms: Terms, before: Formula, term: Formula, inside: Terms, lines: Lines, choice: Formula
) -> Iterator[Diagnostic]:
    """The first branch of a choice whose event waits for `before`; `inside` are the terms of its formula."""
    verbs = ("enter", "skip") if choice.operator.row.skips else ("enter",)
    own = [
        (verb, branch, line)
        for branch in map(ungrouped, choice.operands)
        for verb in verbs
        for line in lines.of((verb, branch))
    ]
    if any(isinstance(event, tree.Received | tree.Lost) for *_, line in own for event in line.written.events):
        return
    for verb, branch, line in own:
        is_when = line.expression.when
        if is_when or any(isinstance(event, Raised | Failed) for event in line.expression.events):
            first, whole = spelling(terms, before), spelling(terms, term)
            yield Diagnostic(
                EventWaits(f"{verb} {spelling(inside, branch)}", first, whole, is_when),
                line.span,
                (Related(before.span, f"`{first}` comes before the choice"),),
            )
            return


def _first_choices(
    formulas: Formulas, lines: Lines, owner: str, term: Formula
) -> Iterator[tuple[str, Formula]]:
    """The choices and options that a term begins with, nothing being said on the way, with their formulas.

    Concurrent parts all begin at once.
    """
    stack = [(owner, term)]
    named: set[str] = set()
    while stack:
        owner, term = stack.pop()
        operator = term.operator
        if operator is Operator.NAME:
            formula = formulas.formula(term.name)
            if formula is not None and term.name not in named:
                named.add(term.name)
                stack.append((term.name, ungrouped(formula)))
        elif operator is Operator.HOLE or lines.of(("start", term)):
            continue
        elif is_choice(operator):
            yield owner, term
        else:
            beginning = term.operands if operator.row.template is Template.REGIONS else term.operands[:1]
            parts = [ungrouped(operand) for operand in reversed(beginning)]
            stack += [(owner, part) for part in parts if not lines.of(("enter", part))]


__all__ = ["check_waits"]
