"""The textX grammar as a parser that records all places and continues after an error.

textX stops at the first error, gives no place to a name in a list, and says what it expected in regular
expressions. Three changes to the parser of the grammar fix this:

- The value of every terminal is a `Token`, a `str` with its place.
- The parser remembers the failure that is farthest in the text, with all terminals that were tried there. If
  a repeated entry matches no alternative of the grammar, that failure is the error to report.
- The `Junk…` terminals are the last alternative of every repeated entry. They note the error and skip to the
  beginning of the next entry. `JunkHeader` and `JunkEnd` stand for a missing `{` and `}`.

An entry never fails after its `{`, so no block is parsed twice and parsing takes linear time.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from functools import lru_cache
from typing import cast

from arpeggio import EndOfFile, Match, NoMatch, OneOrMore, Optional, RegExMatch, Repetition, Terminal

from aseme_dsl.grammar.parsing.nodes import File
from aseme_dsl.grammar.parsing.parser import RulesParser, objects, parsing_expressions
from aseme_dsl.grammar.parsing.progress import ParseNode, ParsingExpression, Progress, TextParser
from aseme_dsl.grammar.parsing.rules import Metamodel, rules, textx_metamodel
from aseme_dsl.grammar.text.lexer import clean
from aseme_dsl.grammar.text.recovery import BLOCKS, end_of_header, end_of_junk, is_outside
from aseme_dsl.grammar.text.token import token
from aseme_dsl.source import Source


class _Parser:
    """What is laid over a parser class of the grammar."""

    source: Source | None = None
    make_progress: type[Progress] = Progress

    def parse(self, text: str, file_name: str | None = None) -> ParseNode:
        lexed = clean(self.source or Source(file_name or "<text>", text))
        self.progress = self.make_progress(lexed)
        tree: ParseNode = super().parse(lexed.text, file_name=file_name)  # type: ignore[misc]
        return tree

    def _nm_raise(self, rule: ParsingExpression, position: int, parser: TextParser) -> None:
        # Arpeggio raises one exception object again and again, whose traceback grows.
        raise NoMatch([rule], position, parser)


class AsemeParser(_Parser, RulesParser):
    """The compiler's parser, of one text."""


@lru_cache(maxsize=1)
def parser_model() -> ParsingExpression:
    """The parsing expressions of the language, made once."""
    return make_parser_model()


def make_parser_model() -> ParsingExpression:
    """Another set of the parsing expressions of the language, which may be changed further."""
    return _laid_over(parsing_expressions(rules()))


@lru_cache(maxsize=1)
def metamodel() -> Metamodel:
    """The metamodel of the language for those who use textX, made once; its parser reads the same."""
    made = textx_metamodel()
    parser = made._parser_blueprint
    parser.comments_model = None  # `clean` has blanked them
    parser.__class__ = type("AsemeParser", (_Parser, type(parser)), {})
    _laid_over(parser.parser_model)
    return made


def _laid_over(top: ParsingExpression) -> ParsingExpression:
    braces = {"Open": _open, "Close": _close}
    for rule, owner in list(all_rules(top)):
        if isinstance(rule, Repetition) and isinstance(rule.nodes[0], RegExMatch) and rule.sep is None:
            if not isinstance(rule, Optional):
                rule._parse = _tokens(rule.nodes[0], isinstance(rule, OneOrMore))
        elif not isinstance(rule, Match) or isinstance(rule, EndOfFile):
            continue
        elif rule.rule_name in BLOCKS:
            rule.parse = _junk(rule)
        elif rule.rule_name == "JunkHeader":
            rule.parse = _missing_open(rule)
        elif rule.rule_name == "JunkEnd":
            rule.parse = _missing_close(rule)
        else:
            rule.parse = _terminal(rule, braces.get(owner))
    return top


def all_rules(top: ParsingExpression) -> Iterator[tuple[ParsingExpression, str]]:
    """Every parsing expression of a grammar, with the name of the rule in which it stands."""
    seen: set[int] = set()
    todo: list[tuple[ParsingExpression, str]] = [(top, "")]
    while todo:
        rule, owner = todo.pop()
        if id(rule) in seen:
            continue
        seen.add(id(rule))
        if rule.rule_name and rule.root and not rule.rule_name.startswith("__asgn"):
            owner = rule.rule_name
        yield rule, owner
        separator = getattr(rule, "sep", None)
        todo += [(part, owner) for part in (*rule.nodes, separator) if part is not None]


_BLANKS = re.compile(r"[ \t\r\n]*")


def skip_blanks(parser: TextParser) -> int:
    """Where the next token begins."""
    progress = parser.progress
    position: int = parser.position
    if position != progress.blank_from:
        progress.blank_from = position
        progress.blank_to = _BLANKS.match(parser.input, position).end()  # type: ignore[union-attr]
    return progress.blank_to


def _matcher(rule: ParsingExpression) -> Callable[[str, int], re.Match[str] | None]:
    if not isinstance(rule, RegExMatch):
        return re.compile(re.escape(rule.to_match)).match
    rule.compile()
    regex: re.Pattern[str] = rule.regex
    return regex.match


def _terminal(
    rule: ParsingExpression, brace: Callable[[Progress, int], bool] | None
) -> Callable[[TextParser], object]:
    """The terminal's `parse`: what Arpeggio does, with the place in the value and the failure remembered."""
    match: Callable[[str, int], re.Match[str] | None] | None = None  # compiled when it is needed

    def parse(parser: TextParser) -> object:
        nonlocal match
        if match is None:
            match = _matcher(rule)
        position = skip_blanks(parser)
        found = match(parser.input, position)
        if found is None:
            parser.progress.fail(rule, position)
            raise NoMatch([rule], position, parser)
        if brace is not None and not brace(parser.progress, position):
            raise NoMatch([rule], position, parser)
        parser.position = found.end()
        return Terminal(rule, position, token(found.group(), position))

    return parse


def _tokens(rule: ParsingExpression, at_least_one: bool) -> Callable[[TextParser], object]:
    """`_parse` of a flat list of tokens, which most of a file consists of: the same in one loop."""
    match: Callable[[str, int], re.Match[str] | None] | None = None  # compiled when it is needed
    blanks = _BLANKS.match

    def parse(parser: TextParser) -> object:
        nonlocal match
        if match is None:
            match = _matcher(rule)
        text = parser.input
        results: list[object] = []
        position = skip_blanks(parser)
        while (found := match(text, position)) is not None:
            results.append(Terminal(rule, position, token(found.group(), position)))
            parser.position = found.end()
            position = blanks(text, parser.position).end()  # type: ignore[union-attr]
        parser.progress.fail(rule, position)
        if at_least_one and not results:
            raise NoMatch([rule], position, parser)
        return results

    return parse


def _open(progress: Progress, position: int) -> bool:
    progress.openers.append(position)
    return True


def _close(progress: Progress, position: int) -> bool:
    if progress.is_stray(position):
        return False
    progress.openers.pop()
    if progress.quiet_before >= 0 and progress.lexed.tokens.at(position) == progress.quiet_before:
        progress.quiet_before += 1  # a `}` alone does not show that the text is understood again
    return True


def _nothing(rule: ParsingExpression, position: int) -> object:
    return Terminal(rule, position, token("", position))


def _junk(rule: ParsingExpression) -> Callable[[TextParser], object]:
    """`parse` of a Junk terminal: skips text that is not an entry of its block."""
    block = BLOCKS[rule.rule_name]

    def parse(parser: TextParser) -> object:
        progress: Progress = parser.progress
        start = skip_blanks(parser)
        if start == len(parser.input):
            raise NoMatch([rule], start, parser)
        if parser.input[start] == "}" and progress.openers and not progress.is_stray(start):
            raise NoMatch([rule], start, parser)
        tokens = progress.lexed.tokens
        first = tokens.at(start)
        if is_outside(tokens, first, block):
            raise NoMatch([rule], start, parser)
        place = max(start, progress.farthest)
        expected = tuple(progress.expected) if place == progress.farthest else ()
        end, another = end_of_junk(tokens, first, tokens.at(place), block)
        progress.note(rule.rule_name, start, end, place, expected)
        if another:
            progress.quiet_before = -1
        parser.position = end
        return Terminal(rule, start, token(parser.input[start:end], start))

    return parse


def _missing_open(rule: ParsingExpression) -> Callable[[TextParser], object]:
    """`parse` of JunkHeader: continues after the `{` of the line, or as if there were one."""

    def parse(parser: TextParser) -> object:
        progress: Progress = parser.progress
        start = parser.position
        tokens = progress.lexed.tokens
        place = max(skip_blanks(parser), progress.farthest)
        expected = tuple(progress.expected) if place == progress.farthest else ()
        end = end_of_header(tokens, tokens.at(skip_blanks(parser)), start)
        progress.note("JunkHeader", start, end, place, expected)
        if end == start:
            tokens.missing.append(tokens.at(end))
        progress.openers.append(end)
        parser.position = end
        return _nothing(rule, end)

    return parse


def _missing_close(rule: ParsingExpression) -> Callable[[TextParser], object]:
    """`parse` of JunkEnd: continues as if there were a `}`."""

    def parse(parser: TextParser) -> object:
        progress: Progress = parser.progress
        place = skip_blanks(parser)
        progress.note("JunkEnd", place, place, place, ())
        progress.openers.pop()
        return _nothing(rule, parser.position)

    return parse


def read(source: Source) -> tuple[File, Progress]:
    """The objects of a text, and what the parser has noted."""
    model, progress, _ = read_with_leaves(source)
    return model, progress


def read_with_leaves(source: Source) -> tuple[File, Progress, ParseNode]:
    """The same, and the parse tree, the leaves of which are all tokens of the text."""
    parser = AsemeParser(parser_model())
    parser.source = source
    tree = parser.parse(source.text)
    return cast(File, objects(tree[0])), parser.progress, tree
