"""Outline: what a file or a workspace declares, as a tree and as a list; and how blocks fold and nest."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields, is_dataclass

from aseme_dsl.amola.liveness import Formula
from aseme_dsl.compiler.read.pieces import InPieces
from aseme_dsl.editor.files.index import NAMES, Kind, Occurrence, Symbol, Use
from aseme_dsl.editor.files.program import Program
from aseme_dsl.editor.files.view import View
from aseme_dsl.grammar.text import tree
from aseme_dsl.grammar.text.lexer import Tokens, clean
from aseme_dsl.records import dataclass
from aseme_dsl.source import Source, Span


@dataclass(frozen=True, slots=True)
class Entry:
    """Something that is declared: its name, what it is, all of it and its name (whole), and what is in it."""

    name: str
    kind: Kind
    detail: str
    span: Span
    name_span: Span
    inside: tuple[Entry, ...] = ()


def outline(view: View) -> tuple[Entry, ...]:
    """What a file declares, as a tree."""
    if view.file is None:
        return ()
    program = view.program
    found: list[Entry] = []
    for item in view.file.declarations:
        names = program.indexer(item, program.index.world)
        found += (_whole(view, entry) for entry in program.recall(_in_declaration, item, names))
    return tuple(found)


def _in_declaration(item: tree.Declaration, names: tuple[Occurrence, ...]) -> tuple[Entry, ...]:
    """What a declaration declares, with the spans of its part of the file."""
    declared = [
        name for name in names if name.use is Use.DECLARATION and name.symbol.kind is not Kind.OUTCOME
    ]
    kinds = {name.span: name.symbol.kind for name in declared}
    return tuple(_entries((item,), kinds))


def _whole(view: View, entry: Entry) -> Entry:
    inside = tuple(_whole(view, item) for item in entry.inside)
    span, name_span = view.whole(entry.span), view.whole(entry.name_span)
    return Entry(entry.name, entry.kind, entry.detail, span, name_span, inside)


_WORDS = {tree.Sag: "sag", tree.Suc: "suc"}


def _entries(nodes: tuple[object, ...], kinds: dict[Span, Kind]) -> Iterator[Entry]:
    for node in nodes:
        if not is_dataclass(node) or isinstance(node, (tree.Name, tree.Text, Formula)):
            continue
        inside = tuple(
            entry for item in fields(node) for entry in _entries(_tuple(getattr(node, item.name)), kinds)
        )
        named = [
            name
            for item in fields(node)
            if (type(node), item.name) in NAMES
            for name in _names(getattr(node, item.name))
            if name.span in kinds
        ]
        if type(node) in _WORDS:
            span = _span(node)
            word = Span(span.source, span.start, span.start + len(_WORDS[type(node)]))
            yield Entry(_WORDS[type(node)], Kind.SYSTEM, "", span, word, inside)
            continue
        if isinstance(node, (tree.Scenario, tree.Property)):
            what = type(node).__name__.lower()
            yield Entry(
                node.title.text or what,
                Kind.CAPABILITY,
                what,
                node.span,
                node.title.span,
            )
            continue
        if not named:
            yield from inside
            continue
        for name in named:
            span = _span(node) if len(named) == 1 else name.span
            kind = kinds[name.span]
            yield Entry(name.text or "?", kind, _detail(node, kind), span, name.span, inside)
            inside = ()


def _span(node: object) -> Span:
    span: Span = getattr(node, "span")  # noqa: B009  nodes of all classes have one
    return span


def _tuple(value: object) -> tuple[object, ...]:
    return value if isinstance(value, tuple) else (value,)


def _names(value: object) -> Iterator[tree.Name]:
    for item in _tuple(value):
        if isinstance(item, tree.Name):
            yield item
        elif isinstance(item, tuple):
            yield from _names(item)


def _detail(node: object, kind: Kind) -> str:
    match node:
        case tree.Var():
            return str(node.type)
        case tree.Field():
            return f"{node.label} {node.type}".strip()
        case tree.NamedFormula() | tree.Let():
            return " ".join(
                (node.formula if isinstance(node, tree.NamedFormula) else node.expression).span.text.split()
            )[:80]
        case tree.TeamAgents():
            return str(node.role)
    return kind.value


def workspace_symbols(programs: tuple[Program, ...], query: str) -> tuple[tuple[Symbol, str, Span], ...]:
    """What is declared in the files of some programs and whose name has the letters of `query` in this order.

    Each with the path of its file and its whole place.
    """
    found: dict[tuple[str, int, str], tuple[Symbol, str, Span]] = {}
    wanted = query.lower()
    for program in programs:
        for item in program.index.all():
            if item.use is Use.DECLARATION and _has_letters(item.symbol.name.lower(), wanted):
                span = program.whole(item.span)
                path = program.path_of(span.source)
                found.setdefault((path, span.start, item.symbol.name), (item.symbol, path, span))
    return tuple(found.values())


def _has_letters(name: str, wanted: str) -> bool:
    rest = iter(name)
    return all(letter in rest for letter in wanted)


# ---- folding and selecting -------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Fold:
    """Lines (from 1) that can be folded away behind the first; `kind` is region, comment or imports."""

    first: int
    last: int
    kind: str = "region"


def folds(view: View) -> InPieces[tuple[Fold, ...]]:
    """Blocks in braces, comments of several lines, and imports that follow each other."""
    source = view.source
    lexed = clean(source)
    yield
    found = [*_braces(source, lexed.tokens), *_comments(lexed.comments), *_imports(view)]
    return tuple(sorted(found, key=lambda item: (item.first, -item.last)))


def _braces(source: Source, tokens: Tokens) -> Iterator[Fold]:
    for opening, closing in tokens.closing.items():
        first = source.position(tokens.starts[opening])[0]
        last = source.position(tokens.starts[closing])[0]
        if last - first > 1:
            yield Fold(first, last - 1)  # the closing brace stays in sight


def _comments(comments: tuple[tree.Comment, ...]) -> Iterator[Fold]:
    """Comments of several lines, and `//` comments on lines that follow each other."""
    begin = end = -1
    for item in comments:
        source = item.span.source
        first, last = item.span.line, source.position(item.span.end)[0]
        alone = not source.line(first)[: item.span.column - 1].strip()
        if alone and first == end + 1 and item.text.startswith("//"):
            end = last
            continue
        if end > begin > 0:
            yield Fold(begin, end, "comment")
        begin, end = (first, last) if alone or last > first else (-1, -1)
    if end > begin > 0:
        yield Fold(begin, end, "comment")


def _imports(view: View) -> Iterator[Fold]:
    lines = [
        view.whole(item.span).line
        for item in (view.file.declarations if view.file is not None else ())
        if isinstance(item, tree.Import)
    ]
    if len(lines) > 1:
        yield Fold(lines[0], lines[-1], "imports")


def selections(view: View, offset: int) -> tuple[Span, ...]:
    """The ranges around an offset, the innermost first: the word, every node of the tree, the file."""
    found: dict[tuple[int, int], Span] = {}
    part, inside = view.at(offset)
    todo: list[object] = [view.declaration_at(offset)]
    while todo:
        node = todo.pop()
        if isinstance(node, tuple):
            todo += node
            continue
        if not is_dataclass(node) or isinstance(node, (Source, Span)):
            continue
        span = getattr(node, "span", None)
        if isinstance(span, Span):
            if span.source is not part or not span.start <= inside <= span.end:
                continue
            found.setdefault((span.start, span.end), view.whole(span))
        todo += [getattr(node, item.name) for item in fields(node)]
    whole = Span(view.source, 0, len(view.source.text))
    spans = sorted(found.values(), key=lambda item: item.end - item.start)
    return (*_nested(spans), whole)


def _nested(spans: list[Span]) -> Iterator[Span]:
    """Those of the spans that are each inside the next."""
    last: Span | None = None
    for span in spans:
        if last is None or (span.start <= last.start and last.end <= span.end):
            yield span
            last = span


__all__ = ["Entry", "Fold", "folds", "outline", "selections", "workspace_symbols"]
