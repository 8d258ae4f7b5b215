"""Filling: a message with its content in braces is one terminal of the grammar, and several tokens."""

from __future__ import annotations

import re
from collections.abc import Iterable

from aseme_dsl.grammar.text.token import Token, token

_TOKEN = re.compile(
    r'"(?:[^"\\\n]|\\.)*"|[0-9]+(?:\.[0-9]+)*[A-Za-z]*|[A-Za-z_]\w*(?:\s*\.\s*[A-Za-z_]\w*)*'
    r"|\.\.|&&|\|\||[<>=!]=|->|\S",
    re.ASCII,
)


def apart(terminals: Iterable[Token]) -> list[Token]:
    """The tokens of the terminals of an expression: `send inform Done { by = 3 }` comes as one of them."""
    found: list[Token] = []
    for item in terminals:
        if item[:1] != '"' and "{" in item:
            found += (token(part[0], item.start + part.start()) for part in _TOKEN.finditer(item))
        else:
            found.append(item)
    return found


__all__ = ["apart"]
