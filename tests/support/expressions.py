"""Typing one expression for a test."""

from __future__ import annotations

from aseme_dsl.amola.expression import Value
from aseme_dsl.compiler.names.resolve import resolve
from aseme_dsl.compiler.read.load import load
from aseme_dsl.compiler.types.scopes import global_scope
from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.source import Source


def typed(expression: str, declarations: str = "") -> tuple[Value | None, tuple[Diagnostic, ...]]:
    """An expression as the compiler understands it where these declarations stand, and what is wrong."""
    loaded = load(Source("test.aseme", f"{declarations}\nlet probe = {expression}\n"))
    symbols, resolved = resolve(loaded)
    scope, found = global_scope(symbols)
    let = scope.lets.get("probe")
    return (None if let is None else let.value), loaded.diagnostics + resolved + found
