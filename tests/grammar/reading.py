"""Reading a text in a test, and showing its tree in short."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields, is_dataclass
from pathlib import Path
from typing import Any

from aseme_dsl.amola.liveness import Formula, canonical
from aseme_dsl.diagnostics import Diagnostic, render_text
from aseme_dsl.grammar import parse
from aseme_dsl.grammar.text import tree
from aseme_dsl.source import Source, Span

ACCEPTANCE = sorted((Path(__file__).parents[1] / "acceptance").glob("*.aseme"))


def read(text: str) -> tree.File:
    """The tree of a text that has no mistake."""
    file, diagnostics = parse(Source("test.aseme", text))
    assert not diagnostics, render_text(diagnostics)
    return file


def declared(text: str) -> Any:
    """The last declaration of a text that has no mistake."""
    return read(text).declarations[-1]


def mistakes(text: str) -> tuple[Diagnostic, ...]:
    return parse(Source("test.aseme", text))[1]


def places(text: str) -> list[str]:
    """`code line:column` of every mistake."""
    found = []
    for item in mistakes(text):
        assert item.span is not None
        found.append(f"{item.code} {item.span.line}:{item.span.column}")
    return found


def formula(text: str) -> Formula:
    """The tree of a formula that has no mistake."""
    made: Formula = declared(f"srm role {{ liveness {{ f = {text}\n }} }}").formulas[0].formula
    return made


def condition(text: str) -> tree.Expression:
    made = transition(f"[{text}]").condition
    assert made is not None
    return made


def transition(text: str) -> tree.TransitionExpression:
    """What stands behind the colon of an entry in `control`."""
    made: tree.TransitionExpression = (
        declared(f"srm role {{ control f {{ enter A : {text}\n }} }}").controls[0].entries[0].expression
    )
    return made


def nodes(value: Any) -> Iterator[Any]:
    """Everything in a tree that has a span."""
    todo = [value]
    while todo:
        item = todo.pop()
        if isinstance(item, tuple):
            todo.extend(item)
        elif is_dataclass(item) and not isinstance(item, (Span, Source)):
            if hasattr(item, "span"):
                yield item
            todo.extend(getattr(item, field.name) for field in fields(item))


def short(value: Any) -> Any:
    """A tree without its spans: names and texts as `str`, formulas and expressions as they are spelled.

    A field that has its default is left out.
    """
    match value:
        case tree.Name():
            return value.text
        case tree.Text():
            return f'"{value.text}"'
        case Span():
            return value.text
        case Formula():
            return canonical(value)
        case tree.Path():
            return value.text
        case tree.Number():
            return value.value
        case tree.Duration():
            return f"{value.nanoseconds}ns"
        case tree.Truth():
            return str(value.value).lower()
        case tree.Call():
            return f"{short(value.function)}({', '.join(str(short(item)) for item in value.arguments)})"
        case tree.Unary():
            return f"({value.operator}{short(value.operand)})"
        case tree.Binary():
            return f"({short(value.left)} {value.operator} {short(value.right)})"
        case tree.Logic():
            return "(" + f" {value.operator} ".join(str(short(item)) for item in value.operands) + ")"
        case tree.List():
            return f"[{', '.join(str(short(item)) for item in value.elements)}]"
        case tree.Element():
            members = "".join(f".{name.text}" for name in value.members)
            return f"{short(value.list)}[{short(value.index)}]{members}"
        case tree.Parenthesised():
            return f"({short(value.inner)})"
        case tuple():
            return tuple(short(item) for item in value)
        case tree.Publish(fills=None):
            return ("Publish", short(value.path))
        case tree.Received(name=None) | tree.Send(fills=None, receiver=None, excepts=()):
            parts = (value.performative, value.message, value.participant)
            return (type(value).__name__, *map(short, parts))
        case _ if is_dataclass(value):
            parts = ((field, getattr(value, field.name)) for field in fields(value) if field.name != "span")
            return (type(value).__name__, *(short(part) for field, part in parts if part != field.default))
    return value
