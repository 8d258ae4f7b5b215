"""Regular expressions of Python in the words of other engines.

`compact` writes them without blanks and comments, as Oniguruma (TextMate) and Python read them; `vim` writes
them as Vim does, very magic.
"""

from __future__ import annotations

import re._constants as codes  # type: ignore[import-not-found]
import re._parser as parser  # type: ignore[import-not-found]
from collections.abc import Callable
from functools import cache
from typing import Any

_CLASSES = {
    codes.CATEGORY_SPACE: r"\s",
    codes.CATEGORY_NOT_SPACE: r"\S",
    codes.CATEGORY_WORD: r"\w",
    codes.CATEGORY_NOT_WORD: r"\W",
    codes.CATEGORY_DIGIT: r"\d",
    codes.CATEGORY_NOT_DIGIT: r"\D",
}
_VIM_SETS = {r"\s": r" \t", r"\w": "0-9A-Za-z_", r"\d": "0-9"}
_VIM_LAZY = {"*": "{-}", "+": "{-1,}", "?": "{-,1}"}
_ESCAPES = {"\n": r"\n", "\t": r"\t", "\r": r"\r"}


@cache
def compact(pattern: str) -> str:
    """The same expression without what (?x) allows."""
    return _written(parser.parse(pattern), _Python)


@cache
def vim(pattern: str) -> str:
    """The same expression for Vim, after `\\v`; a blank may be a line break."""
    return _written(parser.parse(pattern), _Vim)


class _Python:
    word_boundary, end, any_, special = r"\b", "$", ".", r"\.^$*+?{}[]|()"
    blank, no_blank, word = r"\s", r"\S", r"\w"
    group: Callable[[str], str] = staticmethod(lambda inner: f"(?:{inner})")
    lookahead: Callable[[str], str] = staticmethod(lambda inner: f"(?={inner})")
    no_lookahead: Callable[[str], str] = staticmethod(lambda inner: f"(?!{inner})")
    lookbehind: Callable[[str], str] = staticmethod(lambda inner: f"(?<={inner})")
    lazy: Callable[[str], str] = staticmethod(lambda times: f"{times}?")

    @staticmethod
    def set_item(item: str) -> str:
        return item


class _Vim:
    word_boundary, end, any_ = "%(<|>)", "$", "."
    special = "".join(chr(code) for code in range(33, 127) if not chr(code).isalnum() and chr(code) != "_")
    blank, no_blank, word = r"\_s", r"\S", r"\w"
    group: Callable[[str], str] = staticmethod(lambda inner: f"%({inner})")
    lookahead: Callable[[str], str] = staticmethod(lambda inner: f"%({inner})@=")
    no_lookahead: Callable[[str], str] = staticmethod(lambda inner: f"%({inner})@!")
    lookbehind: Callable[[str], str] = staticmethod(lambda inner: f"%({inner})@1<=")
    lazy: Callable[[str], str] = staticmethod(lambda times: _VIM_LAZY[times])

    @staticmethod
    def set_item(item: str) -> str:
        return _VIM_SETS.get(item, item.replace("/", r"\/"))


def _literal(code: int, special: str) -> str:
    character = chr(code)
    if character in _ESCAPES:
        return _ESCAPES[character]
    return f"\\{character}" if character in special else character


def _set(items: list[Any], dialect: type[_Python] | type[_Vim]) -> str:
    parts: list[str] = []
    for operation, argument in items:
        if operation is codes.NEGATE:
            parts.append("^")
        elif operation is codes.LITERAL:
            parts.append(dialect.set_item(_literal(argument, r"]\^-[")))
        elif operation is codes.RANGE:
            parts.append(f"{chr(argument[0])}-{chr(argument[1])}")
        elif operation is codes.CATEGORY:
            parts.append(dialect.set_item(_CLASSES[argument]))
        else:
            raise NotImplementedError(operation)
    return f"[{''.join(parts)}]"


def _written(parsed: Any, dialect: type[_Python] | type[_Vim]) -> str:
    return "".join(_item(operation, argument, dialect) for operation, argument in parsed)


def _item(operation: Any, argument: Any, dialect: type[_Python] | type[_Vim]) -> str:
    if operation is codes.LITERAL:
        return _literal(argument, dialect.special)
    if operation is codes.NOT_LITERAL:
        return _set([(codes.NEGATE, None), (codes.LITERAL, argument)], dialect)
    if operation is codes.ANY:
        return dialect.any_
    if operation is codes.IN:
        if len(argument) == 1 and argument[0][0] is codes.CATEGORY:
            found = _CLASSES[argument[0][1]]
            return {r"\s": dialect.blank, r"\S": dialect.no_blank, r"\w": dialect.word}[found]
        return _set(argument, dialect)
    if operation is codes.BRANCH:
        return dialect.group("|".join(_written(branch, dialect) for branch in argument[1]))
    if operation is codes.SUBPATTERN:
        return dialect.group(_written(argument[3], dialect))
    if operation in (codes.MAX_REPEAT, codes.MIN_REPEAT):
        least, most, inner = argument
        text = _written(inner, dialect)
        if len(inner) > 1 or inner[0][0] in (codes.MAX_REPEAT, codes.MIN_REPEAT):
            text = dialect.group(text)
        times = {(0, codes.MAXREPEAT): "*", (1, codes.MAXREPEAT): "+", (0, 1): "?"}.get((least, most))
        if times is None:
            times = f"{{{least},{'' if most is codes.MAXREPEAT else most}}}"
        return text + (dialect.lazy(times) if operation is codes.MIN_REPEAT else times)
    if operation is codes.AT:
        if argument is codes.AT_BOUNDARY:
            return dialect.word_boundary
        if argument in (codes.AT_END, codes.AT_END_STRING):
            return dialect.end
    if operation in (codes.ASSERT, codes.ASSERT_NOT):
        direction, inner = argument
        text = _written(inner, dialect)
        if operation is codes.ASSERT_NOT and direction > 0:
            return dialect.no_lookahead(text)
        if operation is codes.ASSERT:
            return str(dialect.lookahead(text) if direction > 0 else dialect.lookbehind(text))
    raise NotImplementedError(f"{operation} {argument}")
