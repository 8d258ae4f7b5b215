"""Typecheck: a written expression to a typed one; what does not fit is reported once, at its cause."""

from __future__ import annotations

from aseme_dsl.amola import expression
from aseme_dsl.amola.messages import Type
from aseme_dsl.compiler.scope import Scope
from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.grammar import tree


def type_expression(
    written: tree.TransitionExpression, scope: Scope
) -> tuple[expression.TransitionExpression, tuple[Diagnostic, ...]]:
    """Type events, condition and actions. What is wrong is left out of the result and has a diagnostic.

    The duration of `after` and the second argument of `at` and `mean` are constants: `At.offset` and
    `Mean.window` are always `Literal`.
    """
    raise NotImplementedError


def type_value(
    written: tree.Expression, scope: Scope, expected: Type | None = None
) -> tuple[expression.Value | None, tuple[Diagnostic, ...]]:
    """Type a value; with `expected`, it must be assignable to that type. None when it is wrong."""
    raise NotImplementedError


def constant(
    written: tree.Expression, expected: Type, scope: Scope
) -> tuple[expression.Literal | None, tuple[Diagnostic, ...]]:
    """The constant that an expression of literals, enum constants and lets comes to (E514 otherwise).

    The value of an enum's Literal is the constant's name.
    """
    raise NotImplementedError
