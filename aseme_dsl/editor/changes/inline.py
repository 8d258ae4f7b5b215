"""Inline: a formula is written where its name stood, and its control lines go with it."""

from __future__ import annotations

from aseme_dsl.amola.liveness import Formula, names, ungrouped
from aseme_dsl.amola.operators import INFIX, Operator
from aseme_dsl.compiler.formula.formula_to_statechart import Way
from aseme_dsl.diagnostics import Edit
from aseme_dsl.editor.changes.extract import ALLOWED
from aseme_dsl.editor.changes.moving import Translate, moved_lines, paired, unchanged_terms, without_overlaps
from aseme_dsl.editor.changes.rewriting import (
    Owner,
    Piece,
    Refused,
    Replaced,
    after,
    applied,
    edits,
    piece_at,
    same_meaning,
    same_owner,
)
from aseme_dsl.editor.files.view import View
from aseme_dsl.grammar.text import tree


def inline(view: View, offset: int) -> tuple[Edit, ...]:
    """The edits that write the formula at `offset` (its name, or a use of it) wherever it is used.

    Raises:
        Refused: There is no formula that could be written elsewhere, or the model would change.
    """
    piece = piece_at(view.source, offset)
    owner, name = formula_at(piece, offset - piece.first)
    formula = owner.formulas.named[name]
    if name == owner.formulas.root:
        raise Refused(f"`{owner.titles[name]}` is what all other formulas refine")
    if formula.parameters:
        raise Refused(f"`{name}` has parameters: each use of it stands for something else")
    text = piece.text
    uses = {
        other: [node for node in names(item.formula) if node.name == name]
        for other, item in owner.formulas.named.items()
    }
    uses = {other: found for other, found in uses.items() if found and other != name}
    if not uses:
        raise Refused(f"no formula uses `{name}`")
    whole = ungrouped(formula.formula)
    is_activity = whole.operator is Operator.NAME
    lines = [item for item in piece.declaration.controls if item.name.text == owner.titles[name]]
    if is_activity and any(block.entries for block in lines):
        raise Refused(f"the state of `{name}` goes away, and control says when it is entered")
    changes = [_without(text, formula)]
    for other, found in uses.items():
        parents = owner.terms(other).parents
        changes += [
            Replaced(node.span.start, node.span.end, _spelled(text, formula.formula, parents.get(node)))
            for node in found
        ]
    new = same_owner(applied(text, changes), owner)
    translate = _translation(owner, new, name, uses)
    changes += without_overlaps(moved_lines(text, piece.declaration.controls, owner, new, translate))
    result = edits(piece, applied(text, changes))
    same_meaning(view, after(view.source.text, result), exactly=not is_activity, allowed=ALLOWED)
    return result


def formula_at(piece: Piece, offset: int) -> tuple[Owner, str]:
    """The formula whose name stands at an offset of a piece.

    Raises:
        Refused: There is none.
    """
    for owner in piece.owners:
        for name, item in owner.formulas.named.items():
            if item.name.span.start <= offset <= item.name.span.end:
                return owner, name
            for node in names(item.formula):
                if node.span.start <= offset <= node.span.end and node.name in owner.formulas.named:
                    return owner, node.name
    raise Refused("put the cursor on the name of a formula")


def _spelled(text: str, formula: Formula, parent: Formula | None) -> str:
    """The text of a formula as an operand: in parentheses where it would be read in another way."""
    written = text[formula.span.start : formula.span.end]
    if formula.operator is Operator.GROUP or formula.operator is Operator.OPTION:
        return written
    bare = parent is None or parent.operator in INFIX or parent.operator is Operator.OPTION
    return written if formula.operator not in INFIX and bare else f"({written})"


def _without(text: str, formula: tree.NamedFormula) -> Replaced:
    """Without the formula, and without its line if it is alone on it."""
    start, end = formula.span.start, formula.span.end
    line = text.rfind("\n", 0, start) + 1
    stop = text.find("\n", end)
    if not text[line:start].strip() and stop >= 0 and not text[end:stop].strip():
        return Replaced(line, stop + 1, "")
    return Replaced(start, end, "")


def _translation(owner: Owner, new: Owner, name: str, uses: dict[str, list[Formula]]) -> Translate:
    """The transitions of the new formulas for each of the old ones: those of the formula, at each use."""
    inlined = owner.terms(name).whole
    found = unchanged_terms(owner, new, {name, *uses})
    sites: list[tuple[str, dict[Formula, Formula]]] = []
    for other, used in uses.items():
        waiting = [(owner.terms(other).whole, new.terms(other).whole)]
        while waiting:
            one, now = (ungrouped(item) for item in waiting.pop())
            found[one] = now
            if one in used:
                sites.append((other, paired(inlined, now)))
            else:
                waiting += zip(one.operands, now.operands, strict=True)

    def translate(of: str, way: Way) -> list[tuple[str, Way]]:
        verb, term = way
        if of != name:
            return [(of, (verb, found[term]))]
        return [(other, (verb, inside[term])) for other, inside in sites]

    return translate


__all__ = ["formula_at", "inline"]
