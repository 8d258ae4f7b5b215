"""Texts: what stands at the line of a transition, or in a state, in short lines."""

from __future__ import annotations

import re

from aseme_dsl.amola.expression import action_text, expression_text
from aseme_dsl.amola.statechart import Transition, TransitionKind
from aseme_dsl.diagrams.compact.elements import SIZES, Look
from aseme_dsl.diagrams.look.labels import text_width, wrapped

WIDTH = 30
"""About so many characters stand in one line of a label."""

_CONSTANT = re.compile(r"\b[A-Z]\w*[a-z]\w*\.([A-Z][A-Z0-9_]+)\b")

Row = tuple[str, Look]


def width(text: str, look: Look) -> float:
    """How wide a text is, with a little room for other fonts."""
    bold = look in (Look.NAME, Look.TITLE)
    return text_width(text, SIZES[look]) * (1.09 if bold else 1.03)


def short(text: str) -> str:
    """The text with `and` and `or` for signs, and constants without their enumeration."""
    return _CONSTANT.sub(r"\1", text.replace("&&", "and").replace("||", "or"))


def rows(transition: Transition, cuts: bool = False) -> tuple[tuple[Row, ...], tuple[Row, ...]]:
    """What stands above the line of a transition, and below: its actions."""
    expression = transition.expression
    actions = [action_text(action) for action in expression.actions]
    whole = expression_text(expression)
    joined = "; ".join(actions)
    head = whole.removesuffix(joined).rstrip().removesuffix("/").rstrip() if actions else whole
    verb = {
        TransitionKind.ON: "on",
        TransitionKind.EXIT: "on exit",
        TransitionKind.ABANDON: "on abandon",
        TransitionKind.EXTERNAL: "resume" if transition.resume else "",
    }[transition.kind]
    mark = ("✕ " if expression.is_for_errors else "⚡ ") if cuts or expression.is_for_errors else ""
    look = Look.ERROR if expression.is_for_errors else Look.CUT if cuts else Look.LABEL
    head = " ".join(filter(None, (verb, short(head))))
    above = tuple((line, look) for line in wrapped(mark + head, WIDTH)) if head or mark else ()
    below = tuple(
        ("/ " * (number == 0) + line, Look.ACTION)
        for text in actions
        for number, line in enumerate(wrapped(short(text), WIDTH))
    )
    return above, below
