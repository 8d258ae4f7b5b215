"""Derivative: what a formula lets happen next, found without any statechart.

The words of a formula are made of steps. A step is an edge (which verb of which term) and what is reached by
it (a term, a choice, an AND or the end). What remains of a formula after some steps is a list of items; its
derivatives by all steps are `after(rest)`. Every occurrence in the source is a step of its own: no two
derivatives of one rest have the same step, and there are only finitely many rests.
"""

from __future__ import annotations

from enum import Enum, auto
from typing import assert_never

from aseme_dsl.amola.liveness import Formula, ungrouped
from aseme_dsl.amola.operators import Operator, Template
from aseme_dsl.proofs.certificate.places import Edge, interrupting
from aseme_dsl.records import dataclass


class Reached(Enum):
    """What a step reaches."""

    TERM = auto()
    FRAMED = auto()  # a participant between two points of the one that plays it
    CHOICE = auto()
    AND = auto()
    END = auto()


@dataclass(frozen=True, slots=True, eq=False)
class Step:
    """An edge, and what it reaches: for a TERM the operand as written, else the operator that it is of.

    `of` is the operand of the edge as written. One that is `first` interrupts what was reached before.
    """

    edge: Edge
    of: Formula
    reached: Reached
    what: Formula
    first: bool = False


@dataclass(frozen=True, slots=True, eq=False)
class Either:
    """One of several words."""

    words: tuple[Word, ...]


@dataclass(frozen=True, slots=True, eq=False)
class Again:
    """A word, any number of times."""

    word: Word


Item = Step | Either | Again
Word = tuple[Item, ...]


@dataclass(slots=True, eq=False)
class Rest:
    """What remains of a word: an item, and what remains behind it (None: nothing)."""

    item: Item
    behind: Rest | None
    steps: tuple[tuple[Step, Rest | None], ...] | None = None
    """Its derivatives, once they were asked for."""


def rest_of(word: Word, behind: Rest | None = None) -> Rest | None:
    """All of a word, in front of what remains behind it."""
    for item in reversed(word):
        behind = Rest(item, behind)
    return behind


def after(rest: Rest | None) -> tuple[tuple[Step, Rest | None], ...]:
    """Every step that may come next, with what remains after it."""
    if rest is None:
        return ()
    if rest.steps is None:
        found: list[tuple[Step, Rest | None]] = []
        waiting: list[Rest | None] = [rest]
        while waiting:
            current = waiting.pop()
            if current is None:
                continue
            item = current.item
            if isinstance(item, Step):
                found.append((item, current.behind))
            elif isinstance(item, Again):
                waiting += [current.behind, rest_of(item.word, current)]
            else:
                waiting += [rest_of(word, current.behind) for word in reversed(item.words)]
        rest.steps = tuple(found)
    return rest.steps


def word_of(formula: Formula, separate: frozenset[Formula]) -> Word:
    """The word of one operator (or of a whole formula that is one name); its operands are steps."""
    template = formula.operator.row.template
    match template:
        case Template.CHAIN:
            steps = [_into("enter", operand) for operand in formula.operands]
            return (*steps, _end("leave", formula.operands[-1], formula))
        case Template.BRANCHES:
            begun = Step(("start", formula), formula, Reached.CHOICE, formula)
            return begun, Either(tuple(_through(operand, formula) for operand in formula.operands))
        case Template.CUT:
            first = formula.operands[0]
            cuts = [
                (_into("enter", other, first=True), _end("leave", other, formula))
                for other in interrupting(formula, separate)
            ]
            return _into("enter", first), Either((*cuts, (_end("leave", first, formula),)))
        case Template.REGIONS:
            begun = Step(("start", formula), formula, Reached.AND, formula)
            return begun, _end("finish", formula, formula)
        case Template.BODY:
            return _body(formula)
        case Template.ACTIVITY:
            return _through(formula, formula)
        case Template.INSIDE | Template.UNDECIDED:
            raise TypeError(template)
        case _:
            assert_never(template)


def framed(term: Formula, frame: Formula) -> Word:
    """The word around a participant that another one plays."""
    return (
        Step(("start", frame), term, Reached.FRAMED, term),
        Step(("finish", frame), term, Reached.END, term),
    )


def region(operand: Formula, around: Formula) -> Word:
    """The word of a region of an AND."""
    return _through(operand, around)


def _body(formula: Formula) -> Word:
    row, operand = formula.operator.row, formula.operands[0]
    again = (Again((_into("repeat", operand),)),) if row.repeats else ()
    done = (_end("leave", operand, formula),) if row.leaves or row.skips else ()
    if not row.skips:
        return Step(("start", formula), formula, Reached.TERM, operand), *again, *done
    begun = Step(("start", formula), formula, Reached.CHOICE, formula)
    skipped = (_end("skip", operand, formula),)
    return begun, Either(((_into("enter", operand), *again, *done), skipped))


def _through(operand: Formula, around: Formula) -> Word:
    return _into("enter", operand), _end("leave", operand, around)


def _into(verb: str, operand: Formula, *, first: bool = False) -> Step:
    return Step((verb, ungrouped(operand)), operand, Reached.TERM, operand, first)


def _end(verb: str, operand: Formula, around: Formula) -> Step:
    return Step((verb, ungrouped(operand)), operand, Reached.END, around)


def is_name(term: Formula) -> bool:
    """Whether a term is a name: an activity, a formula or a participant."""
    return term.operator is Operator.NAME


__all__ = ["Reached", "Rest", "Step", "after", "framed", "is_name", "region", "rest_of", "word_of"]
