"""The rules of the grammar as sequences, choices, repetitions and terminals, without what fixes mistakes."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TypeAlias

from arpeggio import Match, OneOrMore, OrderedChoice, RegExMatch, Repetition, ZeroOrMore
from arpeggio import Optional as Perhaps

from aseme_dsl.grammar.parsing.progress import ParsingExpression
from aseme_dsl.grammar.parsing.terminals import metamodel
from aseme_dsl.records import dataclass


@dataclass(frozen=True, slots=True)
class Terminal:
    """One token: `pattern` is a regular expression, `words` are the words of the language that it matches."""

    pattern: str
    words: tuple[str, ...]
    rule: str  # the rule of a lexical file, "" for what is written in quotes
    attribute: str  # that it becomes, "" if none
    owner: str  # the rule in which it stands


@dataclass(frozen=True, slots=True)
class Series:
    """One after the other."""

    items: tuple[Shape, ...]
    rule: str  # "" inside a rule


@dataclass(frozen=True, slots=True)
class Choice:
    """The first that matches."""

    options: tuple[Shape, ...]


@dataclass(frozen=True, slots=True)
class Repeated:
    """`many` or at most one, with `separator` between them."""

    item: Shape
    at_least_one: bool
    many: bool
    separator: Terminal | None


Shape: TypeAlias = Terminal | Series | Choice | Repeated

NOTHING = Series((), "")

_NEVER = ("(?!)", "(?=)")
_WORDS = re.compile(r"\(\?:([^()]+)\)\\b.*", re.DOTALL)
_WORD = re.compile(r"[A-Za-z_]\w*")


def grammar() -> Series:
    """The whole grammar, from the rule File down."""
    # Model is File and the end of the text.
    top = _shape(metamodel()._parser_blueprint.parser_model.nodes[0], "", "", {})
    assert isinstance(top, Series)
    return top


def _shape(node: ParsingExpression, owner: str, attribute: str, known: dict[tuple[int, str], Shape]) -> Shape:
    """The grammar is not recursive, so this ends, and is as deep as the grammar."""
    attribute = getattr(node, "_attr_name", None) or attribute
    if isinstance(node, Match):
        return _terminal(node, owner, attribute)
    key = (id(node), attribute)
    if key not in known:
        known[key] = _made(node, owner, attribute, known)
    return known[key]


def _made(node: ParsingExpression, owner: str, attribute: str, known: dict[tuple[int, str], Shape]) -> Shape:
    rule = node.rule_name if node.root and not node.rule_name.startswith("__") else ""
    inner = rule or owner
    inherited = "" if rule else attribute
    parts = [_shape(part, inner, inherited, known) for part in node.nodes]
    parts = [part for part in parts if part != NOTHING]
    if isinstance(node, Repetition):
        separator = _shape(node.sep, inner, "", known) if node.sep is not None else None
        assert len(parts) == 1 and (separator is None or isinstance(separator, Terminal)), rule
        if not isinstance(node, (Perhaps, ZeroOrMore, OneOrMore)):
            raise NotImplementedError(f"{type(node).__name__} in rule {inner}")
        return Repeated(parts[0], isinstance(node, OneOrMore), not isinstance(node, Perhaps), separator)
    if isinstance(node, OrderedChoice):
        return parts[0] if len(parts) == 1 else Choice(tuple(parts))
    return parts[0] if len(parts) == 1 and not rule else Series(tuple(parts), rule)


def _terminal(node: ParsingExpression, owner: str, attribute: str) -> Shape:
    text = str(node.to_match)
    if not isinstance(node, RegExMatch):
        pattern = re.escape(text)
        return Terminal(r"=(?!=)" if text == "=" else pattern, (), "", attribute, owner)
    if text in _NEVER:
        return NOTHING
    rule = node.rule_name if node.root else ""
    if not rule:  # a keyword; textX has made a regular expression of it
        word = text.replace(r"\b", "")
        return Terminal(rf"{word}\b", (word,), "", attribute, owner)
    found = _WORDS.fullmatch(text)
    words = tuple(word for word in found[1].split("|") if _WORD.fullmatch(word)) if found else ()
    return Terminal(text, words, rule, attribute, owner)


def first(shape: Shape) -> Iterator[Terminal]:
    """The terminals with which it may begin."""
    if isinstance(shape, Terminal):
        yield shape
    elif isinstance(shape, Choice):
        for option in shape.options:
            yield from first(option)
    elif isinstance(shape, Repeated):
        yield from first(shape.item)
    else:
        for item in shape.items:
            yield from first(item)
            if not may_be_empty(item):
                break


def may_be_empty(shape: Shape) -> bool:
    """Whether it matches no token at all."""
    if isinstance(shape, Terminal):
        return False
    if isinstance(shape, Choice):
        return any(may_be_empty(option) for option in shape.options)
    if isinstance(shape, Repeated):
        return not shape.at_least_one
    return all(may_be_empty(item) for item in shape.items)
