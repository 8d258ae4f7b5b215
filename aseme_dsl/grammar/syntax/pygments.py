"""The lexer for Pygments, which Sphinx, MkDocs, LaTeX's minted and other tools use."""

from __future__ import annotations

from aseme_dsl.grammar.syntax.contexts import FILE, Context, Kind
from aseme_dsl.grammar.syntax.patterns import compact
from aseme_dsl.grammar.syntax.rules import COMMENTS, STRAY, Rule, rules

TOKENS: dict[Kind, str] = {
    Kind.DECLARATION: "Keyword.Declaration",
    Kind.CLAUSE: "Keyword",
    Kind.CHOICE: "Keyword.Pseudo",
    Kind.TRUTH: "Keyword.Constant",
    Kind.LOGIC: "Operator.Word",
    Kind.BUILT_IN: "Keyword.Type",
    Kind.BLOCK: "Name.Class",
    Kind.NAME: "Name.Function",
    Kind.TYPE: "Name.Class",
    Kind.CALL: "Name.Builtin",
    Kind.REFERENCE: "Name",
    Kind.TEXT: "String",
    Kind.NUMBER: "Number",
    Kind.OPERATOR: "Operator",
    Kind.PUNCTUATION: "Punctuation",
}
"""The token type of each kind."""

_HEAD = '''"""The lexer of `.aseme` for Pygments. Made from aseme_dsl/grammar/*.tx: python3 dev.py syntax."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import ClassVar

from pygments.lexer import RegexLexer, bygroups, default
from pygments.token import Comment, Keyword, Name, Number, Operator, Punctuation, String, Text, Whitespace


def leave(lexer: RegexLexer, match: re.Match[str]) -> Iterator[tuple[int, object, str]]:
    """The end of an entry or a list, which has no width."""
    return iter(())


class AsemeLexer(RegexLexer):  # type: ignore[misc]
    """Colours `.aseme`: a word is a keyword where the grammar has it as one, and a name elsewhere.

    What the grammar has nowhere is `Text`, so that a broken example can be shown, too.
    """

    name = "ASEME"
    aliases: ClassVar[list[str]] = ["aseme"]
    filenames: ClassVar[list[str]] = ["*.aseme"]
    mimetypes: ClassVar[list[str]] = ["text/x-aseme"]
    flags = re.MULTILINE

    tokens: ClassVar[dict[str, list[object]]] = {
'''


def pygments_lexer(contexts: tuple[Context, ...]) -> str:
    """The source of the module."""
    rests = dict.fromkeys(
        rule.rest for context in contexts for rule in rules(context) if rule.rest is not None
    )
    names = {rest: f"rest {number}" for number, rest in enumerate(rests, start=1)}
    parts = [_HEAD]
    for context in contexts:
        name = "root" if context.name == FILE else context.name
        parts.append(f"        {_quoted(name)}: [\n")
        parts += [f"            {line},\n" for line in _lines(context, names)]
        parts.append("        ],\n")
    for rest, name in names.items():
        matched = f'({_quoted(rest.pattern)}, {_groups(rest)}, "#pop")'
        parts.append(f"        {_quoted(name)}: [\n")
        parts += [f"            {line},\n" for line in [*_comments(), matched, 'default("#pop")']]
        parts.append("        ],\n")
    stray = [*_comments(), *_stray(), r'("\\}", Punctuation, "#pop")', '("[^\\\\n]", Text)']
    parts.append('        "stray": [\n')
    parts += [f"            {line},\n" for line in stray]
    parts.append("        ],\n    }\n")
    return "".join(parts)


def _quoted(text: str) -> str:
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'


def _comments() -> list[str]:
    kinds = {"line": "Comment.Single", "block": "Comment.Multiline"}
    found = [f"({_quoted(pattern)}, {kinds[kind]})" for pattern, kind in COMMENTS]
    return [r'("\\s+", Whitespace)', *found]


def _stray() -> list[str]:
    tokens = [f"({_quoted(pattern)}, {TOKENS[kind] if kind else 'Text'})" for pattern, kind in STRAY]
    return [*tokens, r'("\\{", Punctuation, "stray")']


def _lines(context: Context, rests: dict[Rule, str]) -> list[str]:
    lines = _comments()
    end = context.end()
    if end is not None:
        lines.append(f'({_quoted(compact(end))}, leave, "#pop")')
    lines += [_rule(rule, rests) for rule in rules(context)]
    if context.is_body:
        lines += _stray()
    if context.closed:
        lines.append(r'("\\}", Punctuation, "#pop")')
    lines.append('("[^\\\\n]", Text)')
    return lines


def _groups(rule: Rule) -> str:
    types = [TOKENS[kind] if kind is not None else "Whitespace" for kind in rule.kinds]
    return f"bygroups({', '.join(types)})"


def _rule(rule: Rule, rests: dict[Rule, str]) -> str:
    enters = rests[rule.rest] if rule.rest is not None else rule.enters
    return f"({_quoted(rule.pattern)}, {_groups(rule)}{f', {_quoted(enters)}' if enters else ''})"
