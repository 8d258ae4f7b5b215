"""Renames: what the names in a participant's expressions mean in the chart where it is played."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field, replace

from aseme_dsl.amola import expression
from aseme_dsl.amola.expression import TransitionExpression
from aseme_dsl.amola.messages import Type
from aseme_dsl.records import dataclass


@dataclass(frozen=True, slots=True)
class Renames:
    """What the names in a participant's expressions mean in the chart where it is played."""

    variables: Mapping[str, str] = field(default_factory=dict)
    """The keys of its variables: `bids@0.2.3`."""
    activities: Mapping[str, str] = field(default_factory=dict)
    """The activities or formulas of the role that stand for the protocol's activities."""
    inputs: Mapping[str, expression.Value] = field(default_factory=dict)
    """What it is given, in terms of the chart."""


SAME = Renames()
"""Names outside of a participant mean what they say."""


def rename(written: TransitionExpression, names: Renames) -> TransitionExpression:
    """The expression with its variables, inputs and activities replaced as `names` says."""
    if names == SAME:
        return written
    return expression.rewritten_expression(written, lambda value: _renamed(value, names))


def rename_value(value: expression.Value, names: Renames) -> expression.Value:
    """The same for a value."""
    return value if names == SAME else expression.rewritten(value, lambda part: _renamed(part, names))


def _renamed(value: expression.Value, names: Renames) -> expression.Value:
    match value:
        case expression.VariableValue(name=name) if name in names.variables:
            return replace(value, name=names.variables[name])
        case expression.ParameterValue(name=name, span=span, path=path, type=kind) if name in names.inputs:
            found = replace(names.inputs[name], span=span)
            return _member(found, path, kind) if path else found
        case expression.Outcome(activity=activity) if activity in names.activities:
            return replace(value, activity=names.activities[activity])
        case expression.StateValue(state=state) if state in names.activities:
            return replace(value, state=names.activities[state])
    return value


def _member(message: expression.Value, path: tuple[str, ...], kind: Type) -> expression.Value:
    """A member of a message that an input stands for; only these are supplied (E592)."""
    match message:
        case expression.Named(expression=inner):
            return _member(replace(inner, span=message.span), path, kind)
        case expression.Conditional(yes=yes, no=no):
            return replace(message, yes=_member(yes, path, kind), no=_member(no, path, kind), type=kind)
        case expression.VariableValue(message=of, type=whole):
            whole_path = (*message.path, *path)
            return replace(message, path=whole_path, type=kind, message=of or whole.name)
        case expression.Member() | expression.Element() | expression.ParameterValue():
            return replace(message, path=(*message.path, *path), type=kind)
    raise AssertionError(f"{expression.value_text(message)} has no members here")


__all__ = ["SAME", "Renames", "rename", "rename_value"]
