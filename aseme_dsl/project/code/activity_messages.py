"""Activity messages: whether what the Python of an activity publishes is what the channel carries.

Only what is plain is looked at: a message made in the call itself, or in the one assignment to the name that
is given there.
"""

from __future__ import annotations

import ast
from collections.abc import Iterable, Iterator, Mapping
from typing import TYPE_CHECKING

from aseme_dsl.backends.backend import message_modules
from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.diagnostics.problems.python.code_words import Found, PublishesOther
from aseme_dsl.project.code.activity_access import Place

if TYPE_CHECKING:
    from aseme_dsl.amola.system import System

Published = tuple[str, ast.expr]
"""A channel that there is, and what is published on it."""

_PLAIN = (ast.Constant, ast.JoinedStr, ast.List, ast.Tuple, ast.Dict, ast.Set)
"""Expressions whose values are never messages."""


def unfit_messages(
    tree: ast.Module, system: System, published: Iterable[Published], place: Place
) -> Iterator[Diagnostic]:
    """W540 for what is published and is not what the channel carries."""
    names = _names(tree, system)
    assigned = _assigned(tree)
    for channel, value in published:
        wanted = channel.rpartition(".")[2]
        known = assigned.get(id(value)) if isinstance(value, ast.Name) else value
        found = None if known is None else _found(known, wanted, names)
        if found is not None:
            yield Diagnostic(PublishesOther(channel, wanted, *found), place(value))


def _names(tree: ast.Module, system: System) -> Mapping[str, str | None]:
    """What names of the module mean: a message of the system, or (None) a class that is none."""
    messages = {item.name for item in system.messages}
    names: dict[str, str | None] = {}
    modules = message_modules(system.name)
    for node in tree.body:
        if isinstance(node, ast.ClassDef) and not node.bases:
            names[node.name] = None
        if isinstance(node, ast.ImportFrom) and node.module in modules:
            names.update(
                (alias.asname or alias.name, alias.name) for alias in node.names if alias.name in messages
            )
    return names


def _found(value: ast.expr, wanted: str, names: Mapping[str, str | None]) -> tuple[str, Found] | None:
    """The name and kind of what a value is, if it is not a `wanted` for sure."""
    if isinstance(value, _PLAIN):
        return "", "value"
    if isinstance(value, ast.Name) and (named := names.get(value.id)) is not None:
        return named, "class of message"
    if isinstance(value, ast.Call) and isinstance(value.func, ast.Name) and value.func.id in names:
        kind = names[value.func.id]
        if kind is None:
            return value.func.id, "other class"
        return None if kind == wanted else (kind, "message")
    return None


def _assigned(tree: ast.Module) -> dict[int, ast.expr]:
    """For each use of a name in a function (by the node's id) its value; names that are bound once only."""
    found: dict[int, ast.expr] = {}
    for function in ast.walk(tree):  # what is inside another one comes after it
        if not isinstance(function, (ast.FunctionDef, ast.AsyncFunctionDef)):
            continue
        nodes = list(ast.walk(function))
        bound: dict[str, int] = {}
        values: dict[str, ast.expr] = {}
        for node in nodes:
            if isinstance(node, ast.Name) and not isinstance(node.ctx, ast.Load):
                bound[node.id] = bound.get(node.id, 0) + 1
            elif isinstance(node, ast.arg):
                bound[node.arg] = bound.get(node.arg, 0) + 1
            elif isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name):
                values[node.targets[0].id] = node.value
        for node in nodes:
            if isinstance(node, ast.Name):
                found.pop(id(node), None)
                if bound.get(node.id) == 1 and node.id in values:
                    found[id(node)] = values[node.id]
                elif node.id not in bound:
                    found[id(node)] = node  # of the module: perhaps a class
    return found


__all__ = ["unfit_messages"]
