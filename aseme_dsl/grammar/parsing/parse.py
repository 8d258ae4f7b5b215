"""Parsing: from a source to its tree, with all syntax errors of the file."""

from __future__ import annotations

from typing import TYPE_CHECKING

from aseme_dsl.diagnostics import Diagnostic, Problem, in_order
from aseme_dsl.diagnostics.problems.syntax import entries as problems
from aseme_dsl.grammar.text.tree import Comment, File
from aseme_dsl.source import Source

if TYPE_CHECKING:
    from aseme_dsl.grammar.parsing.nodes import File as ParsedFile
    from aseme_dsl.grammar.parsing.progress import ParseNode, Progress


def parse(source: Source) -> tuple[File, tuple[Diagnostic, ...]]:
    """The tree of `source` and what is wrong with its syntax, in the order of the text.

    Parts of the text that could not be read are missing in the tree. Every text gives a tree, and nothing is
    raised.
    """
    from aseme_dsl.grammar.parsing.terminals import read

    model, progress = read(source)
    return understood(model, progress)


def parse_with_leaves(source: Source) -> tuple[ParseNode, tuple[Comment, ...], tuple[Diagnostic, ...]]:
    """The parse tree of `source`, its comments, and what is wrong with its syntax (see `parse`).

    The leaves of the parse tree are all tokens of the text, if nothing is wrong.
    """
    from aseme_dsl.grammar.parsing.terminals import read_with_leaves

    model, progress, leaves = read_with_leaves(source)
    file, diagnostics = understood(model, progress)
    return leaves, file.comments, diagnostics


def understood(model: ParsedFile, progress: Progress) -> tuple[File, tuple[Diagnostic, ...]]:
    """The tree of what textX has made of a text, and all mistakes of the text."""
    from aseme_dsl.grammar.parsing.build import build

    lexed = progress.lexed
    file, inside = build(lexed.source, model, lexed.comments)
    mistakes = _explained(progress) if progress.mistakes else []
    return file, _selected(list(lexed.diagnostics), mistakes, inside)


def _explained(progress: Progress) -> list[Diagnostic]:
    from aseme_dsl.grammar.parsing.explain import explain

    return [explain(progress.lexed, mistake) for mistake in progress.mistakes[: MOST_MISTAKES + 1]]


MOST_MISTAKES = 100
"""How many mistakes of one file are listed."""


def _selected(
    odd: list[Diagnostic], mistakes: list[Diagnostic], inside: list[Diagnostic]
) -> tuple[Diagnostic, ...]:
    """One message a mistake: on a line, the first kind of mistake explains those of the other kinds after it.

    The kinds are odd characters, mistakes in the structure, and mistakes inside formulas and expressions.
    """
    comments = [item.span.start for item in odd if _is(item, problems.CommentNotClosed) and item.span]
    comment = min(comments, default=None)
    if comment is not None:  # all that follows is part of it
        mistakes = [
            item
            for item in mistakes
            if item.span and item.span.end < comment and not _is(item, problems.BlockNotClosed)
        ]
    mistakes = _at_different_places(mistakes, {item.span.start for item in inside if item.span})
    first: dict[int, tuple[int, int]] = {}  # by line: the place and the kind of its first mistake
    kinds = list(enumerate((odd, mistakes, inside)))
    for kind, items in kinds:
        for item in items:
            if item.span is not None and not _is(item, *_BRACES):
                here = (item.span.start, kind)
                first[item.span.line] = min(here, first.get(item.span.line, here))
    found = in_order(
        item
        for kind, items in kinds
        for item in items
        if item.span is None or _is(item, *_BRACES) or first[item.span.line][1] == kind
    )
    if len(found) <= MOST_MISTAKES:
        return found
    last = found[MOST_MISTAKES - 1]
    note = Diagnostic(problems.MoreMistakes(MOST_MISTAKES), last.span)
    return (*found[:MOST_MISTAKES], note)


def _at_different_places(mistakes: list[Diagnostic], taken: set[int]) -> list[Diagnostic]:
    """Without those at the place of an earlier one, and missing braces where something else is wrong."""
    seen: set[int] = set()
    kept: list[Diagnostic] = []
    for item in mistakes:
        start = item.span.start if item.span else -1
        if start not in seen and not (_is(item, *_BRACES) and start in taken):
            kept.append(item)
        seen.add(start)
    return kept


def _is(item: Diagnostic, *kinds: type[Problem]) -> bool:
    return isinstance(item.problem, kinds)


_BRACES = (
    problems.CommentNotClosed,
    problems.BlockNotClosed,
    problems.BlockClosedEarly,
    problems.NothingToClose,
)
"""What is shown on a line though it may concern others."""
