"""Extract: a part of a formula gets a formula of its own, and its control lines go with it."""

from __future__ import annotations

import re

from aseme_dsl.amola.liveness import Formula, names, ungrouped, walk
from aseme_dsl.amola.operators import INFIX, Operator
from aseme_dsl.compiler.formula.formula_to_statechart import Way
from aseme_dsl.compiler.formula.terms import way
from aseme_dsl.diagnostics import Edit
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
from aseme_dsl.records import dataclass
from aseme_dsl.source import Span

ALLOWED = frozenset(("N704",))
"""What may be said anew: that the control of a formula is not written, of two formulas instead of one."""

_WORDS = {
    Operator.SEQUENCE: "_then_",
    Operator.CHOICE: "_or_",
    Operator.PARALLEL: "_and_",
}


def extract(view: View, start: int, end: int) -> tuple[Edit, ...]:
    """The edits that make a formula of what is selected.

    Raises:
        Refused: The selection is not a part of a formula that can stand alone, or the model would change.
    """
    piece = piece_at(view.source, start)
    owner, named, selected = _selection(piece, start - piece.first, end - piece.first)
    name = _new_name(piece, selected)
    text = piece.text
    inside = text[selected.inner.start : selected.inner.end]
    indent = _indent(text, named.span.start)
    formula_changes = [
        Replaced(selected.outer.start, selected.outer.end, name),
        Replaced(named.span.end, named.span.end, f"\n{indent}{name} = {inside}"),
    ]
    formula = named.name.text
    _stays_the_same(piece, owner, formula, selected)
    new = same_owner(applied(text, formula_changes), owner)
    translate = _translation(owner, new, formula, name, selected)
    controls = piece.declaration.controls
    changes = without_overlaps(moved_lines(text, controls, owner, new, translate))
    result = edits(piece, applied(text, [*formula_changes, *changes]))
    same_meaning(view, after(view.source.text, result), exactly=selected.last is None, allowed=ALLOWED)
    return result


@dataclass(frozen=True, slots=True)
class _Selected:
    """A whole term, or the operands `first … last` of a sequence; and where what is replaced stands."""

    term: Formula
    outer: Span
    first: int = 0
    last: int | None = None

    @property
    def operands(self) -> tuple[Formula, ...]:
        """What the new formula holds, in order."""
        return (self.term,) if self.last is None else self.term.operands[self.first : self.last + 1]

    @property
    def inner(self) -> Span:
        """The text of the new formula."""
        return self.operands[0].span.to(self.operands[-1].span)


def _selection(piece: Piece, start: int, end: int) -> tuple[Owner, tree.NamedFormula, _Selected]:
    text = piece.text
    while start < end and text[start].isspace():
        start += 1
    while end > start and text[end - 1].isspace():
        end -= 1
    for owner in piece.owners:
        for named in owner.formulas.named.values():
            span = named.formula.span
            if span.start <= start and end <= span.end and start < end:
                return owner, named, _term(named.formula, start, end)
    raise Refused("select a part of a formula")


def _term(whole: Formula, start: int, end: int) -> _Selected:
    """The term, or the neighbouring operands of a sequence, that the selection covers exactly."""
    around: dict[Formula, Formula] = {}
    for node in walk(whole):
        around |= {operand: node for operand in node.operands}
    for item in walk(whole):
        node = item
        if (node.span.start, node.span.end) == (start, end):
            term = ungrouped(node)
            if term is ungrouped(whole):
                raise Refused("this is the whole formula: it has a name already")
            if term.operator is Operator.NAME:
                raise Refused(f"`{term.name}` has a name already")
            while around[node].operator is Operator.GROUP:
                node = around[node]
            return _Selected(term, node.span)
    for node in walk(whole):
        begins = [operand.span.start for operand in node.operands]
        ends = [operand.span.end for operand in node.operands]
        if node.operator in INFIX and start in begins and end in ends:  # some of its operands
            if node.operator is not Operator.SEQUENCE:
                raise Refused(
                    f"some of the branches of `{node.operator.value}` would mean something else alone"
                )
            first, last = begins.index(start), ends.index(end)
            return _Selected(node, node.operands[first].span.to(node.operands[last].span), first, last)
    raise Refused("select a whole part of the formula: brackets and operators with all that belongs to them")


def _new_name(piece: Piece, selected: _Selected) -> str:
    """A name that says what is inside, and that nothing in the declaration has."""
    taken = set(re.findall(r"\w+", piece.text))
    inside = [node for operand in selected.operands for node in names(operand)]
    words = list(dict.fromkeys(_snake(node.name) for node in inside))
    inmost = selected.term
    while len(inmost.operands) == 1:
        inmost = inmost.operands[0]
    operator = inmost.operator
    if len(words) == 2 and operator in _WORDS:
        base = _WORDS[operator].join(words)
    else:
        base = f"{words[0]}_part"
    name, number = base, 2
    while name in taken:
        name, number = f"{base}_{number}", number + 1
    return name


def _snake(name: str) -> str:
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", name).lower()


def _translation(owner: Owner, new: Owner, formula: str, name: str, selected: _Selected) -> Translate:
    """Which transition of the new formulas each transition of the old ones is."""
    whole, changed = owner.terms(formula).whole, new.terms(formula).whole
    outside = _paired_outside(whole, changed, selected)
    stands = _held(new.terms(name).whole, selected)
    inside: dict[Formula, Formula] = {}
    for old, now in zip(selected.operands, stands, strict=True):
        inside |= paired(old, now)
    others = unchanged_terms(owner, new, {formula})

    def translate(of: str, way: Way) -> list[tuple[str, Way]]:
        verb, term = way
        if of != formula:
            return [(of, (verb, others[term]))]
        if term in inside and not _leads_out(selected, way):
            return [(name, (verb, inside[term]))]
        return [(formula, (verb, outside[term]))]

    return translate


def _leads_out(selected: _Selected, way: Way) -> bool:
    """Whether an edge of the outermost terms of the selection is not inside the new formula."""
    verb, term = way
    operands = [ungrouped(item) for item in selected.operands]
    if selected.last is None:
        return term is operands[0] and verb not in ("start", "finish")
    return (term is operands[0] and verb == "enter") or (term is operands[-1] and verb == "leave")


def _paired_outside(whole: Formula, changed: Formula, selected: _Selected) -> dict[Formula, Formula]:
    """The terms that stay with those of the changed formula; the selected ones with the new name."""
    if selected.last is None:
        return paired(whole, changed, selected.term)
    found = paired(whole, changed, selected.term)
    old, new = selected.term.operands, found[selected.term].operands
    first, last = selected.first, selected.last
    name = ungrouped(new[first])
    for one, other in zip((*old[:first], *old[last + 1 :]), (*new[:first], *new[first + 1 :]), strict=True):
        found |= paired(one, other)
    found[ungrouped(old[first])] = found[ungrouped(old[last])] = name
    return found


def _held(whole: Formula, selected: _Selected) -> tuple[Formula, ...]:
    """What the new formula holds, as it is now."""
    return (whole,) if selected.last is None else whole.operands


def _stays_the_same(piece: Piece, owner: Owner, formula: str, selected: _Selected) -> None:
    """The formula that is left by an event would now be left while all of its part is active.

    Raises:
        Refused: A control line says so.
    """
    if selected.last is None:
        return
    terms = owner.terms(formula)
    last = selected.last
    operands = selected.term.operands
    out: Way = ("leave", ungrouped(operands[last]))
    if last + 1 < len(operands):
        out = ("enter", ungrouped(operands[last + 1]))
    for control in piece.declaration.controls:
        if control.name.text != terms.title:
            continue
        for entry in control.entries:
            if isinstance(entry, tree.LabelledWay):
                raise Refused("the states would have other labels, and control names some by their labels")
            found = way(terms, entry.verb, entry.term)[0]
            if found == out and (entry.expression.events or entry.expression.when):
                raise Refused(
                    f"`{entry.verb} {entry.term.span.text}` would no longer wait for `"
                    f"{operands[last].span.text}` alone: it has an event"
                )


def _indent(text: str, offset: int) -> str:
    line = text[text.rfind("\n", 0, offset) + 1 : offset]
    return line[: len(line) - len(line.lstrip())] or "  "


__all__ = ["extract"]
