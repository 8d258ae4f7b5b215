"""What was expected, in the words of the user: from a parser's mistakes to diagnostics."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from aseme_dsl.diagnostics import Diagnostic, Related, closest
from aseme_dsl.grammar.lexer import UNITS, Lexed, Tokens, shown
from aseme_dsl.grammar.recovery import BLOCKS
from aseme_dsl.grammar.terminals import Mistake
from aseme_dsl.source import Span

_WORDS = {
    "Name": "a name",
    "EntryName": "a name",
    "ActivityName": "an activity",
    "NodeName": "a name",
    "Path": "a name",
    "Text": "a text in double quotes",
    "Integer": "a whole number",
    "SignedInteger": "a whole number",
    "Most": "a whole number or '*'",
    "Count": "a number",
    "Duration": "a duration, as 200ms",
    "Label": "a label, as 0.2.1",
    "FormulaToken": "a formula",
    "ProcessToken": "a formula",
    "TermToken": "a term of the formula",
    "ControlToken": "",
    "ExpressionToken": "an expression",
    "Separator": "",
    "Word": "",
    "CommType": "'signal', 'state' or 'data'",
    "FieldLabel": "",
    "TopicFlagWord": "'queued', 'persist'",
    "Verb": "'enter', 'skip', 'repeat', 'leave', 'start', 'finish'",
    "RoleType": "'system', 'abstract', 'human', 'legacy' or 'external'",
    "ActivityKind": "'thread', 'async', 'process' or 'step'",
    "Reach": "",
    "FunctionalityWord": "'technology', 'permissions', 'environment', 'algorithm'",
    "NodeType": "'START', 'END', 'OR', 'AND', 'BASIC' or 'CONDITION'",
}
"""By the name of the rule; those with an empty text go without saying."""

_CHOICES = {
    "CommType": ("signal", "state", "data"),
    "FieldLabel": ("optional", "repeated"),
    "TopicFlagWord": ("queued", "persist"),
    "Verb": BLOCKS["JunkControl"].words,
    "RoleType": ("system", "abstract", "human", "legacy", "external"),
    "ActivityKind": ("thread", "async", "process", "step"),
    "FunctionalityWord": BLOCKS["JunkFunctionality"].words,
    "NodeType": ("START", "END", "OR", "AND", "BASIC", "CONDITION"),
}
"""The words that a terminal accepts."""


def explain(lexed: Lexed, mistake: Mistake) -> Diagnostic:
    """The diagnostic of a mistake."""
    tokens = lexed.tokens
    index = tokens.at(mistake.place)
    if mistake.kind == "JunkEnd":
        return _not_closed(lexed, mistake, index)
    words = _keywords(mistake.expected)
    found = tokens.word(index)
    previous = tokens.word(index - 1)
    hint: str | None = None
    fix: str | None = None
    meant = closest(found, words) if found[:1].isalpha() and found not in words else None
    if meant is None and index > 0 and mistake.start < tokens.starts[min(index, len(tokens) - 1)]:
        block = BLOCKS.get(mistake.kind)
        candidates = block.words if block else ()
        before = (
            closest(previous, candidates) if previous[:1].isalpha() and previous not in candidates else None
        )
        if before is not None:
            meant, index = before, index - 1
            found, previous = previous, tokens.word(index - 1)
    if meant is not None:
        hint, fix = f"did you mean {shown(meant)}?", meant
    wanted = _alternatives(_phrases(mistake.expected, mistake.kind))
    after = f" after {shown(previous)}" if previous else ""
    if index >= len(tokens):
        place = _end_of(lexed, tokens, len(tokens) - 1)
        return Diagnostic("E100", f"expected {wanted}{after}, but the file ends", place, hint=hint)
    if (
        found.isdigit()
        and tokens.word(index + 1) in UNITS
        and any(rule.rule_name == "Duration" for rule in mistake.expected)
    ):
        unit = tokens.word(index + 1)
        span = Span(lexed.source, tokens.starts[index], tokens.ends[index + 1])
        return Diagnostic(
            "E108",
            f"a blank between the number {found} and its unit {unit}",
            span,
            hint=f"write {found}{unit}",
            fix=found + unit,
        )
    place = Span(lexed.source, tokens.starts[index], tokens.ends[index])
    if tokens.begins_line(index) and index > 0 and meant is None and mistake.start < tokens.starts[index]:
        # Something is missing at the end of a line, not wrong on the next one.
        place = _end_of(lexed, tokens, index - 1)
    return Diagnostic("E100", f"expected {wanted}{after}, found {shown(found)}", place, hint=hint, fix=fix)


def _not_closed(lexed: Lexed, mistake: Mistake, index: int) -> Diagnostic:
    tokens = lexed.tokens
    related: tuple[Related, ...] = ()
    block = "a block"
    if mistake.opener is not None:
        opener = min(tokens.at(mistake.opener), len(tokens) - 1)
        first = opener
        while first > 0 and not tokens.begins_line(first) and tokens.word(first - 1) not in ("{", "}"):
            first -= 1
        header = lexed.text[tokens.starts[first] : tokens.starts[opener]].strip()
        block = shown(header) if header else block
        related = (Related(Span(lexed.source, tokens.starts[opener], tokens.ends[opener]), "opened here"),)
    found = "but the file ends" if index >= len(tokens) else f"found {shown(tokens.word(index))}"
    place = _end_of(lexed, tokens, min(index, len(tokens)) - 1)
    return Diagnostic("E111", f"expected '}}' that closes {block}, {found}", place, related, hint="write '}'")


def _end_of(lexed: Lexed, tokens: Tokens, index: int) -> Span:
    if not 0 <= index < len(tokens):
        return Span(lexed.source, 0, 0)
    return Span(lexed.source, tokens.starts[index], tokens.ends[index])


def _keywords(expected: Iterable[Any]) -> list[str]:
    words: list[str] = []
    for rule in expected:
        words += _CHOICES.get(rule.rule_name, ())
        if not rule.rule_name or rule.rule_name.startswith("__asgn"):
            words.append(str(rule.to_match))
    return [word for word in words if word[:1].isalpha()]


def _phrases(expected: Iterable[Any], kind: str) -> list[str]:
    phrases: list[str] = []
    for rule in expected:
        if rule.rule_name in _WORDS:
            phrases.append(_WORDS[rule.rule_name])
        else:
            phrases.append(f"'{rule.to_match}'")
    return [phrase for phrase in dict.fromkeys(phrases) if phrase]


def _alternatives(phrases: list[str]) -> str:
    if not phrases:
        return "something else"
    if len(phrases) == 1:
        return phrases[0]
    return ", ".join(phrases[:-1]) + " or " + phrases[-1]
