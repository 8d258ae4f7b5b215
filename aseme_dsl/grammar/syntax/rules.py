"""The phrases of a context as regular expressions with groups, in the order in which an engine tries them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from aseme_dsl.grammar.syntax.contexts import KEYWORDS, TOKENS, Context, Kind, Phrase, Piece, either
from aseme_dsl.grammar.syntax.patterns import compact
from aseme_dsl.records import dataclass


@dataclass(frozen=True, slots=True)
class Rule:
    """What a match of `pattern` is: its groups are tokens of `kinds` (None: blanks between them)."""

    pattern: str
    kinds: tuple[Kind | None, ...]
    enters: str = ""
    rest: Rule | None = None
    """What follows on another line, if it does; comments may stand between."""


COMMENTS = ((r"//[^\n]*", "line"), (r"/\*(?:[^*]|\*(?!/))*\*/", "block"))

STRAY: tuple[tuple[str, Kind | None], ...] = (
    (r'"(?:[^"\\\n]|\\.)*"', Kind.TEXT),
    (r'"[^"\n]*', Kind.TEXT),
    (r"[0-9]+(?:\.[0-9]+)*\w*", Kind.NUMBER),
    (r"\w+", None),
    (r"[^\s\w{}]", None),
)
"""Tokens where the grammar has none of them, so that a text that is being written stays readable."""


_SURE = (*KEYWORDS, Kind.OPERATOR, Kind.PUNCTUATION)


def rules(context: Context) -> Iterator[Rule]:
    """What may begin in a context, but for comments and what is stray; lists of tokens last."""
    whole = [rule for phrase in context.phrases for rule in _whole(phrase, context.is_body)]
    parts = [rule for phrase in context.phrases for rule in _parts(phrase, context.is_body)]
    sure = [rule for rule in whole if rule.kinds[0] in _SURE]
    yield from dict.fromkeys([*sure, *_broken(context.phrases), *whole, *parts])
    if context.tokens is not None:
        for pattern, kind in TOKENS[context.tokens[0]]:
            yield Rule(f"({compact(pattern)})", (kind,))


def _whole(phrase: Phrase, begins: bool) -> Iterator[Rule]:
    """All of the phrase, on one line."""
    pattern, kinds = _all_of(phrase.pieces)
    if begins and len(phrase.pieces) == 1 and phrase.following and not phrase.pieces[0].is_word:
        pattern += compact(rf"(?=\s*(?:{either(phrase.following)}))")
    yield Rule(pattern, tuple(kinds), phrase.enters)


def _all_of(pieces: tuple[Piece, ...]) -> tuple[str, list[Kind | None]]:
    """All pieces but those that are optional, one after the other."""
    pattern = ""
    kinds: list[Kind | None] = []
    for piece in pieces:
        text, own = _piece_groups(piece.options)
        if piece.optional and not pattern:
            text += r"(\s*)"
            pattern, kinds = f"(?:{text})?", [*own, None]
            continue
        blank = r"(\s*)" if pattern and not pattern.endswith(r"(\s*))?") else ""
        pattern += f"(?:{blank}{text})?" if piece.optional else blank + text
        kinds += [*([None] if blank else []), *own]
    return pattern, kinds


def _broken(phrases: tuple[Phrase, ...]) -> Iterator[Rule]:
    """Rules for phrases whose first token, a keyword or a sign, may be followed by a line break."""
    rests: dict[Piece, list[tuple[Piece, ...]]] = {}
    for phrase in phrases:
        head, *others = phrase.pieces
        if others and not phrase.enters and all(kind in _SURE for _, kind in head.options):
            rests.setdefault(head, []).append(tuple(others))
    for head, tails in rests.items():
        # A complete phrase is a better match than a part of a longer one.
        found = [
            *(_all_of(tail) for tail in tails if len(tail) > 1),
            *(_nested(tail) for tail in tails[::-1]),
        ]
        pattern, kinds = _piece_groups(head.options)
        rest = Rule(
            "|".join(f"(?:{text})" for text, _ in found), tuple(kind for _, own in found for kind in own)
        )
        yield Rule(pattern + r"(?=\s*(?:$|//|/\*))", tuple(kinds), "", rest)


def _nested(pieces: tuple[Piece, ...]) -> tuple[str, list[Kind | None]]:
    """The first piece, and of the others as many as there are."""
    pattern, first_kinds = _piece_groups(pieces[0].options)
    kinds: list[Kind | None] = [*first_kinds]
    if pieces[0].optional and len(pieces) > 1:  # with what comes first, or without it
        with_it, its_kinds = _nested((replace(pieces[0], optional=False), *pieces[1:]))
        without, other_kinds = _nested(pieces[1:])
        return f"(?:{with_it})|(?:{without})", [*its_kinds, *other_kinds]
    for piece in pieces[1:]:
        text, own = _piece_groups(piece.options)
        pattern += rf"(?:(\s*){text}"
        kinds += [None, *own]
    return pattern + ")?" * (len(pieces) - 1), kinds


def _parts(phrase: Phrase, begins: bool) -> Iterator[Rule]:
    """The beginning of the phrase, as far as it stands on the line."""
    head, *others = phrase.pieces
    if not others:
        return
    pattern, kinds = _piece_groups(head.options)
    if head.is_sign and not phrase.enters and not head.optional:
        text, all_kinds = _nested(phrase.pieces)
        yield Rule(rf"(?:{text})(?=\s*(?:$|//|/\*))", tuple(all_kinds))
        return
    if not head.is_word:
        if begins and phrase.following:
            yield Rule(pattern + r"(?=\s*$)", tuple(kinds), phrase.enters)
        return
    text, all_kinds = _nested(phrase.pieces)
    yield Rule(text, tuple(all_kinds), phrase.enters)


def _piece_groups(options: tuple[tuple[str, Kind], ...]) -> tuple[str, list[Kind]]:
    texts = [f"({compact(pattern)})" for pattern, _ in options]
    return (texts[0] if len(texts) == 1 else f"(?:{'|'.join(texts)})"), [kind for _, kind in options]
