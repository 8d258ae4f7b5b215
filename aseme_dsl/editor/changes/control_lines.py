"""Control lines: a line for each transition of a formula that has none, to be filled in."""

from __future__ import annotations

from collections.abc import Container, Iterator, Sequence

from aseme_dsl.amola.liveness import ungrouped
from aseme_dsl.amola.operators import Template
from aseme_dsl.compiler.formula.formula_to_statechart import Way
from aseme_dsl.compiler.formula.staying import STAYING
from aseme_dsl.compiler.formula.terms import Terms, way, ways
from aseme_dsl.diagnostics import Edit
from aseme_dsl.diagnostics.problems.syntax.entries import Hole
from aseme_dsl.editor.changes.inline import formula_at
from aseme_dsl.editor.changes.moving import said
from aseme_dsl.editor.changes.rewriting import (
    Owner,
    Piece,
    Refused,
    Replaced,
    after,
    applied,
    edits,
    nothing_new,
    piece_at,
)
from aseme_dsl.editor.files.view import View
from aseme_dsl.grammar.text import tree


def missing_lines(view: View, offset: int) -> tuple[Edit, ...]:
    """The edits that write a line for every way of a formula that has no line yet.

    Such a line says what holds without it: that the transition waits for completion. Where transitions
    compete, in a choice or a loop, the condition is a hole (`[?]`). The formula is the one whose name, or
    whose control block's name, stands at `offset`.

    Raises:
        Refused: There is no such formula, or all its transitions have lines.
    """
    piece = piece_at(view.source, offset)
    owner, formula = _formula(piece, offset - piece.first)
    title = owner.titles[formula]
    blocks = [item for item in piece.declaration.controls if item.name.text == title]
    terms = owner.terms(formula)
    lined = {
        way(terms, entry.verb, entry.term)[0]
        for block in blocks
        for entry in block.entries
        if isinstance(entry, tree.Way)
    }
    all_ways: dict[Way, str] = {}
    for term in terms.parents:
        for verb, meant in ways(terms, term).items():
            if verb in STAYING:
                continue  # no transition
            all_ways.setdefault(meant, verb)
    undecided = _undecided(terms, lined, _with_else(terms, blocks))
    lines = []
    for meant, verb in all_ways.items():
        head = said(terms, meant, verb) if meant not in lined else None
        if head is not None:
            lines.append((*head, undecided.get(meant, "")))
    if not lines:
        raise Refused(f"every transition of `{title}` has a line")
    change = _written(piece, blocks, title, lines)
    result = edits(piece, applied(piece.text, [change]))
    nothing_new(view, after(view.source.text, result), _ALLOWED)
    return result


_ALLOWED = frozenset((Hole.code, "W403", "W410", "W411", "W412", "W420", "N712"))
"""What may be said of conditions that are still to be written."""


def _groups(terms: Terms) -> Iterator[list[Way]]:
    """The ways that compete: the branches of a choice, going on with a loop or leaving it."""
    for term in terms.parents:
        operands = [ungrouped(operand) for operand in term.operands]
        row = term.operator.row
        if row.template is Template.BRANCHES:
            yield [("enter", operand) for operand in operands]
        if row.skips:
            yield [("enter", operands[0]), ("skip", operands[0])]
        if row.repeats and row.leaves:
            yield [("repeat", operands[0]), ("leave", operands[0])]


def _with_else(terms: Terms, blocks: Sequence[tree.Control]) -> set[Way]:
    """The ways that have an `else`."""
    found = set()
    for block in blocks:
        for entry in block.entries:
            if isinstance(entry, tree.Way) and entry.expression.otherwise:
                found.add(way(terms, entry.verb, entry.term)[0])
    return {item for item in found if item is not None}


def _undecided(terms: Terms, lined: Container[Way | None], otherwise: set[Way]) -> dict[Way, str]:
    """What is written for ways that compete: the last of those without a line is for all other cases."""
    found: dict[Way, str] = {}
    for group in _groups(terms):
        silent = [item for item in group if item not in lined]
        has_else = any(item in otherwise for item in group)
        for item in silent:
            found[item] = "else" if item is silent[-1] and not has_else else "[?]"
    return found


def _formula(piece: Piece, offset: int) -> tuple[Owner, str]:
    for control in piece.declaration.controls:
        if control.name.span.start <= offset <= control.name.span.end:
            for owner in piece.owners:
                found = owner.formula_of(control.name.text)
                if found is not None:
                    return owner, found
    return formula_at(piece, offset)


def _written(
    piece: Piece, blocks: Sequence[tree.Control], title: str, lines: Sequence[tuple[str, str, str]]
) -> Replaced:
    """The lines at the end of the formula's block, or in a new block at the end of the declaration."""
    text = piece.text
    verbs = max(len(verb) for verb, _, _ in lines)
    width = max(len(term) for _, term, _ in lines)
    rows = [f"{verb:{verbs}} {term:{width}} : {expression}".rstrip() for verb, term, expression in lines]
    block = blocks[0] if blocks else None
    closing = (block.span.end if block is not None else piece.declaration.span.end) - 1
    line = text.rfind("\n", 0, closing) + 1
    indent = text[line:closing] if not text[line:closing].strip() else ""
    at = line if not text[line:closing].strip() else closing
    if block is not None:
        body = "".join(f"{indent}  {row}\n" for row in rows)
    else:
        inner = "".join(f"{indent}    {row}\n" for row in rows)
        body = f"\n{indent}  control {title} {{\n{inner}{indent}  }}\n"
    return Replaced(at, at, body if at == line else f"\n{body}{indent}")


__all__ = ["missing_lines"]
