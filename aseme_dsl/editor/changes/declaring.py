"""Declaring: what an unknown name needs to be known: a variable, a field, a constant, an entry of a topic, …

What is declared elsewhere can be changed only where it is this file's.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from aseme_dsl.amola.messages import BOOL, ChannelKind, Type
from aseme_dsl.compiler.names.scope import Scope
from aseme_dsl.compiler.read.blocks import lists
from aseme_dsl.compiler.types.scopes import protocol_scopes, role_scope
from aseme_dsl.compiler.types.typecheck import type_value
from aseme_dsl.diagnostics import Diagnostic, Edit
from aseme_dsl.diagnostics.problems.absences import NoMessage, NotListed, NoTopic
from aseme_dsl.diagnostics.problems.expressions.absences import (
    NoBeginning,
    NoConstant,
    NoMember,
    NoMessageOfTopic,
    NotCarried,
    NoVariable,
    NoVariableOrLet,
)
from aseme_dsl.diagnostics.problems.expressions.paths import OtherClass
from aseme_dsl.editor.changes.rewriting import Piece, Refused, piece_at
from aseme_dsl.editor.files.known import nodes
from aseme_dsl.editor.files.view import View
from aseme_dsl.grammar.text import tree
from aseme_dsl.source import Span

_PATH = re.compile(r"[A-Za-z_]\w*(?:\s*\.\s*[A-Za-z_]\w*)*")
_COMMS = tuple(comm.value for comm in ChannelKind)

Declaration = tuple[str, tuple[Edit, ...]]
"""A title, and the edits that declare what is missing."""


def declarations(view: View, item: Diagnostic) -> Iterator[Declaration]:
    """What could be declared so that a name is known."""
    if item.span is None:
        return
    match item.problem:
        case NoVariable() | NoVariableOrLet():
            yield from _variable(view, item.span)
        case NoMember():
            yield from _field(view, item.span)
        case NoBeginning() | NoTopic() | NoMessage() | NoMessageOfTopic() | NotCarried():
            yield from _channel(view, item.span)
            yield from _message(view, item.span)
        case OtherClass():
            yield from _channel(view, item.span)
        case NoConstant():
            yield from _constant(view, item.span)
        case NotListed():
            yield from _exchange(view, item.span)


# ---- variables -----------------------------------------------------------------------------------


def _variable(view: View, span: Span) -> Iterator[Declaration]:
    """A variable of the role or participant, with the type that its use asks for."""
    try:
        piece = piece_at(view.source, span.start)
    except Refused:
        return
    start = span.start - piece.first
    owner = _owner(piece, start)
    if owner is None or not span.text.isidentifier():
        return
    written, scope = _with_scope(view, piece, owner)
    kind = _asked_for(piece.declaration, start, scope)
    if kind is not None:
        title = f"Declare the variable `{span.text} : {kind}`"
        yield title, (_entry(view, piece, written, f"var {span.text} : {kind}"),)


def _owner(piece: Piece, offset: int) -> tree.Control | None:
    for control in piece.declaration.controls:
        if control.span.start <= offset <= control.span.end:
            return control
    return None


def _with_scope(view: View, piece: Piece, control: tree.Control) -> tuple[tree.Srm | tree.Participant, Scope]:
    top = view.program.inspection.top
    declaration = piece.declaration
    if isinstance(declaration, tree.Srm):
        return declaration, role_scope(declaration, top)[0].scope
    scopes = protocol_scopes(declaration, top)[0]
    for owner in piece.owners:
        if owner.formula_of(control.name.text) is not None and isinstance(owner.written, tree.Participant):
            return owner.written, scopes[owner.written.name.text].scope
    part = declaration.participants[0]
    return part, scopes[part.name.text].scope


def _asked_for(declaration: object, offset: int, scope: Scope) -> Type | None:
    """The type of a value that stands at an offset, as far as what stands beside it says."""
    for node in nodes(declaration):
        sides: tuple[tree.Expression, tree.Expression] | None = None
        match node:
            case tree.Binary(left=left, right=right):
                sides = (left, right)
            case tree.Assign(target=target, value=value):
                sides = (target, value)
            case tree.TransitionExpression(condition=condition) if condition is not None:
                if _begins(condition, offset) and isinstance(condition, tree.Path):
                    return BOOL
            case tree.Logic(operands=operands):
                if any(isinstance(one, tree.Path) and _begins(one, offset) for one in operands):
                    return BOOL
            case tree.Unary(operator="!", operand=tree.Path() as operand) if _begins(operand, offset):
                return BOOL
        if sides is None:
            continue
        for one, other in (sides, sides[::-1]):
            if isinstance(one, tree.Path) and _begins(one, offset):
                typed = type_value(other, scope)[0]
                return typed.type if typed is not None else None
    return None


def _begins(node: tree.Expression, offset: int) -> bool:
    return node.span.start == offset


def _entry(view: View, piece: Piece, owner: tree.Srm | tree.Participant, line: str) -> Edit:
    """An entry behind the variables that there are, or else first in the block."""
    text = piece.text
    if owner.variables:
        last = owner.variables[-1].span
        return _insert(view, piece.first + last.end, f"\n{_indent(text, last.start)}{line}")
    opening = text.index("{", owner.name.span.end)
    indent = _indent(text, owner.span.start) + "  "
    same_line = "\n" not in text[opening : owner.span.end]
    return _insert(view, piece.first + opening + 1, f" {line}" if same_line else f"\n{indent}{line}")


# ---- messages and topics -------------------------------------------------------------------------


def _path_at(view: View, span: Span) -> tuple[list[str], int]:
    """The dotted name around a place, and which of its segments stands there."""
    text = view.source.text
    line = text.rfind("\n", 0, span.start) + 1
    for found in _PATH.finditer(text, line):
        if found.start() > span.start:
            break
        if found.end() >= span.end:
            before = text[found.start() : span.start].count(".")
            return [part.strip() for part in found.group().split(".")], before
    return [], 0


def _message(view: View, span: Span) -> Iterator[Declaration]:
    """A message of that name, before the declaration in which it is used."""
    segments, index = _path_at(view, span)
    name = span.text
    if not name.isidentifier() or (len(segments) > 1 and index != _class_index(segments) + 1):
        return
    if not name[:1].isupper() or view.program.inspection.symbols.message(name) is not None:
        return
    declaration = view.declaration_at(span.start)
    if declaration is None:
        return
    start = view.whole(declaration.span).start
    line = view.source.text.rfind("\n", 0, start) + 1
    yield f"Declare the message `{name}`", (_insert(view, line, f"message {name} {{\n}}\n\n"),)


def _class_index(segments: list[str]) -> int:
    return next((index for index, item in enumerate(segments) if item in _COMMS), -1)


def _channel(view: View, span: Span) -> Iterator[Declaration]:
    """The message on the topic, in the class that is asked for; or the topic with it."""
    segments, _ = _path_at(view, span)
    at = _class_index(segments)
    symbols = view.program.inspection.symbols
    if at < 1 or len(segments) < at + 2 or symbols.message(segments[at + 1]) is None:
        return
    name, comm, message = segments[at - 1 : at + 2]
    topic = symbols.topic(name)
    if topic is None:
        declaration = view.declaration_at(span.start)
        if declaration is not None:
            start = view.whole(declaration.span).start
            line = view.source.text.rfind("\n", 0, start) + 1
            text = f"topic {name} {{\n  {comm} {message}\n}}\n\n"
            yield f"Declare the topic `{name}` with `{comm} {message}`", (_insert(view, line, text),)
        return
    if any(item.channel.comm == comm and item.channel.message == message for item in topic.channels):
        return
    block = _block(view, tree.Topic, name)
    if block is not None:
        yield f"Let `{name}` carry `{comm} {message}`", (_inside(view, block, f"{comm} {message}"),)


def _field(view: View, span: Span) -> Iterator[Declaration]:
    """The member, with the type of what it is compared with or assigned."""
    segments, index = _path_at(view, span)
    at = _class_index(segments)
    symbols = view.program.inspection.symbols
    if at < 1 or index < at + 2:
        return
    message = symbols.message(segments[at + 1])
    for name in segments[at + 2 : index]:
        field = message.field(name) if message is not None else None
        message = symbols.message(field.type.name) if field is not None else None
    if message is None or message.field(span.text) is not None:
        return
    block = _block(view, tree.Message, message.name)
    if block is None:
        return
    try:
        piece = piece_at(view.source, span.start)
    except Refused:
        return
    control = _owner(piece, span.start - piece.first)
    if control is None:
        return
    begin = view.source.text.rfind(segments[0], 0, span.start) - piece.first
    kind = _asked_for(piece.declaration, begin, _with_scope(view, piece, control)[1])
    if kind is not None:
        entry = f"{kind} {span.text}"
        yield f"Give `{message.name}` the member `{entry}`", (_inside(view, block, entry),)


def _constant(view: View, span: Span) -> Iterator[Declaration]:
    segments, index = _path_at(view, span)
    if index != 1:
        return
    block = _block(view, tree.Enum, segments[0])
    if block is not None:
        title = f"Give `{segments[0]}` the constant `{span.text}`"
        yield title, (_inside(view, block, span.text),)


def _exchange(view: View, span: Span) -> Iterator[Declaration]:
    """The message among those that the participant sends or receives."""
    try:
        piece = piece_at(view.source, span.start)
    except Refused:
        return
    control = _owner(piece, span.start - piece.first)
    if control is None or isinstance(piece.declaration, tree.Srm):
        return
    part, _ = _with_scope(view, piece, control)
    for node in nodes(control):
        if isinstance(node, (tree.Send, tree.Received)) and _covers(node.span, span, piece):
            if not isinstance(part, tree.Participant) or not lists(part):
                return
            sent = isinstance(node, tree.Send)
            said = f"{node.performative} {node.message}"
            there = part.sends if sent else part.receives
            if there:
                edit = _insert(view, piece.first + there[-1].span.end, f", {said}")
            else:
                edit = _entry(view, piece, part, f"{'sends' if sent else 'receives'} {said}")
            verb = "send" if sent else "receive"
            yield f"Let `{part.name}` {verb} `{said}`", (edit,)


def _covers(outer: Span, inner: Span, piece: Piece) -> bool:
    return outer.start <= inner.start - piece.first and inner.end - piece.first <= outer.end


# ---- texts ---------------------------------------------------------------------------------------


def _block(view: View, kind: type, name: str) -> Span | None:
    """The declaration of that name in this file."""
    for item in view.file.declarations if view.file is not None else ():
        if isinstance(item, kind) and getattr(item, "name").text == name:  # noqa: B009
            return view.whole(item.span)
    return None


def _inside(view: View, block: Span, entry: str) -> Edit:
    """An entry at the end of a block: on a line of its own where the brace is."""
    text = view.source.text
    closing = block.end - 1
    line = text.rfind("\n", 0, closing) + 1
    if text[line:closing].strip():
        blank = "" if text[closing - 1].isspace() else " "
        return _insert(view, closing, f"{blank}{entry} ")
    return _insert(view, line, f"{text[line:closing]}  {entry}\n")


def _insert(view: View, offset: int, text: str) -> Edit:
    return Edit(Span(view.source, offset, offset), text)


def _indent(text: str, offset: int) -> str:
    line = text[text.rfind("\n", 0, offset) + 1 : offset]
    return line[: len(line) - len(line.lstrip())]


__all__ = ["Declaration", "declarations"]
