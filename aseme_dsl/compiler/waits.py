"""Waits: events of a choice that are waited for only when what stands before the choice is complete."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from aseme_dsl.amola.expression import Failed, Raised
from aseme_dsl.amola.liveness import Formula, Operator, ungrouped
from aseme_dsl.compiler.control import Lines
from aseme_dsl.compiler.terms import Terms, spelling
from aseme_dsl.diagnostics import Diagnostic, Related
from aseme_dsl.grammar import tree


def check_waits(terms: Terms, lines: Lines) -> Iterator[Diagnostic]:
    """W405 for each term of a sequence that begins with a choice whose branch has an event or `when`.

    A line for the way into the term says that the wait is meant, or interrupts what stands before. A choice
    that a message of an agent decides is a place to wait at; `after` counts from the choice in any case.
    """
    for sequence in terms.parents:
        if sequence.operator is not Operator.SEQUENCE:
            continue
        operands = [ungrouped(operand) for operand in sequence.operands]
        for before, term in pairwise(operands):
            if not lines.of(("enter", term)):
                yield from _waits(terms, lines, before, term)


def _waits(terms: Terms, lines: Lines, before: Formula, term: Formula) -> Iterator[Diagnostic]:
    choice = _first_choice(lines, term)
    if choice is None:
        return
    verbs = ("enter",) if choice.operator is Operator.CHOICE else ("enter", "skip")
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
            what = "`when`" if is_when else "the event"
            yield Diagnostic(
                "W405",
                f"{what} of `{verb} {spelling(terms, branch)}` is waited for only when `{first}` is complete",
                line.span,
                (Related(before.span, f"`{first}` comes before the choice"),),
                hint=f"to interrupt `{first}`, write `enter {whole} : when [ … ]` or an event as well; "
                f"if it is to be completed first, write `enter {whole} :` to say so",
            )
            return


def _first_choice(lines: Lines, term: Formula) -> Formula | None:
    """The choice or option that a term begins with, in the same formula, with nothing said on the way."""
    while True:
        match term.operator:
            case Operator.CHOICE | Operator.OPTION | Operator.ZERO_OR_MORE:
                return None if lines.of(("start", term)) else term
            case Operator.SEQUENCE:
                term = ungrouped(term.operands[0])
                if lines.of(("enter", term)):
                    return None
            case Operator.ONE_OR_MORE | Operator.FOREVER:
                if lines.of(("start", term)):
                    return None
                term = ungrouped(term.operands[0])
            case _:
                return None


__all__ = ["check_waits"]
