"""Filling: a message with its content in braces is one terminal of the grammar, and several tokens."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable

from aseme_dsl.diagnostics import Edit
from aseme_dsl.diagnostics.problems.syntax import formulas as problems
from aseme_dsl.diagnostics.problems.syntax.entries import Wanted
from aseme_dsl.grammar.formulas.reader import Reader, is_word
from aseme_dsl.grammar.formulas.words import RESERVED, Malformed
from aseme_dsl.grammar.text import tree
from aseme_dsl.grammar.text.token import Token, token
from aseme_dsl.source import Span

Value = Callable[[Reader], tree.Expression]
"""How a value is read (expression.py)."""

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


def in_braces(
    reader: Reader, value: Value
) -> tuple[tuple[tree.Fill, ...] | None, tree.Rest | None, tuple[Span, Span] | None]:
    """The content of a message, if there is one, with the places of its braces."""
    if reader.next != "{":
        return None, None, None
    opener = reader.span(reader.tokens[reader.index])
    fills, rest = content(reader, value)
    return fills, rest, (opener, reader.span(reader.tokens[reader.index - 1]))


def _is_behind(reader: Reader) -> bool:
    """Whether a name is behind the next token."""
    following = reader.tokens[reader.index + 1] if reader.index + 1 < len(reader.tokens) else ""
    return is_word(following) and following not in RESERVED


def content(
    reader: Reader, value: Value, *, is_sent: bool = True
) -> tuple[tuple[tree.Fill, ...], tree.Rest | None]:
    """`{ f = v, g.h = v }`, and the `..` or `..m` at its end.

    Of what is published, not sent, members that are not named keep what they have; so it has no `..` alone.
    """
    opener = reader.take()
    found: list[tree.Fill] = []
    rest: tree.Rest | None = None
    while reader.next != "}":
        if rest is None and reader.next == ".." and (is_sent or _is_behind(reader)):
            dots = reader.take()
            message: tree.Expression | None = None
            if is_word(reader.next) and reader.next not in RESERVED:
                message = value(reader)
            rest = tree.Rest(message, reader.since(dots.start))
            if reader.next == ",":
                reader.take()
            continue
        if rest is not None:
            raise _behind_rest(reader, rest, opener)
        if reader.next == ".." and not is_sent:
            dots = reader.tokens[reader.index]
            wanted = (Wanted.MEMBER, "}")
            raise reader.error(problems.RestOfPublished(wanted, reader.tokens[reader.index - 1], dots), dots)
        if reader.index == len(reader.tokens) or not is_word(reader.next) or reader.next in RESERVED:
            raise reader.unexpected(Wanted.MEMBER, "}", related=(reader.still_open(opener),))
        name = reader.take()
        if reader.next != "=":
            at = reader.tokens[min(reader.index, len(reader.tokens) - 1)]
            raise reader.error(problems.MemberWithoutValue(("=",), name, at), at)
        reader.take()
        given = value(reader)
        found.append(tree.Fill(reader.path(name), given, reader.since(name.start)))
        if reader.next in (",", ";"):
            reader.take()
        elif reader.next == ".." and (is_sent or _is_behind(reader)):
            raise _without_comma(reader)
        elif reader.next != "}":
            raise reader.unexpected(Wanted.OPERATOR, ",", "}", related=(reader.still_open(opener),))
    reader.take()
    return tuple(found), rest


def _without_comma(reader: Reader) -> Malformed:
    """The error of `..` directly behind a value."""
    before, dots = reader.tokens[reader.index - 1], reader.take()
    of = reader.next if is_word(reader.next) else ""
    problem = problems.RestWithoutComma((Wanted.OPERATOR, ",", "}"), before, dots, rest=f"{dots}{of}")
    place = Span(reader.source, before.end, before.end)
    return reader.error(problem, dots, edits=(Edit(place, ","),))


def _behind_rest(reader: Reader, rest: tree.Rest, opener: Token) -> Malformed:
    """The error of what stands behind `..`, as far as it is a member."""
    related = (reader.still_open(opener),)
    if not is_word(reader.next):
        return reader.unexpected("}", related=related)
    found = reader.tokens[reader.index]
    text = "".join(rest.span.text.split())
    before = reader.tokens[reader.index - 1]
    return reader.error(problems.RestNotLast(("}",), before, found, rest=text), found, related=related)


__all__ = ["apart", "content", "in_braces"]
