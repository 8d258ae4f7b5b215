"""Naming: an expression gets a name by `let`, and the name stands instead of it."""

from __future__ import annotations

import re

from aseme_dsl.compiler.names.scope import Scope
from aseme_dsl.compiler.types.scopes import protocol_scopes, role_scope
from aseme_dsl.compiler.types.typecheck import type_value
from aseme_dsl.diagnostics import Edit
from aseme_dsl.editor.changes.rewriting import (
    Piece,
    Refused,
    Replaced,
    after,
    applied,
    edits,
    piece_at,
    same_meaning,
)
from aseme_dsl.editor.files.known import nodes
from aseme_dsl.editor.files.view import View
from aseme_dsl.grammar.text import tree

_EXPRESSIONS = (tree.Path, tree.Call, tree.Unary, tree.Binary, tree.Logic, tree.Parenthesised)
"""What a name may stand for; a name for a number or a text is a `let` to be written by hand."""


def name_expression(view: View, start: int, end: int) -> tuple[Edit, ...]:
    """The edits that name the selected expression and put the name in its place.

    The `let` stands where all that the expression uses is known: in the role; in the participant if it uses a
    variable of it, else in the protocol.

    Raises:
        Refused: The selection is not a whole expression with a value, or the model would change.
    """
    piece = piece_at(view.source, start)
    text = piece.text
    first, last = _trimmed(text, start - piece.first, end - piece.first)
    control, expression = _selected(piece, first, last)
    inner = expression.inner if isinstance(expression, tree.Parenthesised) else expression
    owner = _owner(view, piece, control, inner)
    name = _new_name(text, inner)
    changes = [
        Replaced(first, last, name),
        _declared(text, owner, f"let {name} = {text[inner.span.start : inner.span.end]}"),
    ]
    result = edits(piece, applied(text, changes))
    same_meaning(view, after(view.source.text, result))
    return result


def _trimmed(text: str, start: int, end: int) -> tuple[int, int]:
    while start < end and text[start].isspace():
        start += 1
    while end > start and text[end - 1].isspace():
        end -= 1
    return start, end


def _selected(piece: Piece, start: int, end: int) -> tuple[tree.Control, tree.Expression]:
    for control in piece.declaration.controls:
        if not control.span.start <= start <= end <= control.span.end:
            continue
        targets = {id(node.target) for node in nodes(control) if isinstance(node, tree.Assign)}
        for node in nodes(control):
            if (
                isinstance(node, _EXPRESSIONS)
                and (node.span.start, node.span.end) == (start, end)
                and id(node) not in targets
            ):
                return control, node
    raise Refused("select a whole expression in a control line: a comparison, a call, a value")


def _owner(
    view: View, piece: Piece, control: tree.Control, expression: tree.Expression
) -> tree.Srm | tree.Aip | tree.Participant:
    """The block in which the `let` stands."""
    known = view.program.inspection
    declaration = piece.declaration
    if isinstance(declaration, tree.Srm):
        if _type(expression, role_scope(declaration, known.top)[0].scope) is None:
            raise Refused("this has no value by itself")
        return declaration
    scopes = protocol_scopes(declaration, known.top)[0]
    for owner in piece.owners:
        if isinstance(owner.written, tree.Participant) and owner.formula_of(control.name.text) is not None:
            scope = scopes[owner.written.name.text].scope
            if _type(expression, scope) is None:
                raise Refused("this has no value by itself")
            own = {item.name.text for item in owner.written.variables}
            own |= {item.name.text for item in owner.written.lets}
            used = {node.segments[0].text for node in nodes(expression) if isinstance(node, tree.Path)}
            return owner.written if own & used else declaration
    raise Refused("this control is of no formula here")


def _type(expression: tree.Expression, scope: Scope) -> object:
    return type_value(expression, scope)[0]


def _new_name(text: str, expression: tree.Expression) -> str:
    """A name after what the expression is about: its function, or the last name in it."""
    paths = [node for node in nodes(expression) if isinstance(node, (tree.Path, tree.Call))]
    base = "condition"
    if isinstance(expression, tree.Call):
        base = f"is_{expression.function.text}"
    elif paths:
        begin = min(paths, key=_start)
        path = begin.function if isinstance(begin, tree.Call) else begin
        base = (
            f"{path.segments[-1].text}_value"
            if isinstance(expression, tree.Path)
            else f"{path.segments[-1].text}_condition"
        )
    taken = set(re.findall(r"\w+", text))
    name, number = base.lower(), 2
    while name in taken:
        name, number = f"{base.lower()}_{number}", number + 1
    return name


def _start(node: tree.Path | tree.Call) -> int:
    return node.span.start


def _declared(text: str, owner: tree.Srm | tree.Aip | tree.Participant, line: str) -> Replaced:
    """The `let` behind those that are there; in a role or protocol before its control, else at the end."""
    if owner.lets:
        behind = owner.lets[-1].span.end
        return Replaced(behind, behind, f"\n{_indent(text, owner.lets[-1].span.start)}{line}")
    controls = owner.controls if not isinstance(owner, tree.Participant) else ()
    if controls:
        before = min(item.span.start for item in controls)
        return Replaced(before, before, f"{line}\n{_indent(text, before)}")
    closing = owner.span.end - 1
    start = text.rfind("\n", 0, closing) + 1
    if text[start:closing].strip():
        return Replaced(closing, closing, f" {line} ")
    return Replaced(start, start, f"{text[start:closing]}  {line}\n")


def _indent(text: str, offset: int) -> str:
    line = text[text.rfind("\n", 0, offset) + 1 : offset]
    return line[: len(line) - len(line.lstrip())]


__all__ = ["name_expression"]
