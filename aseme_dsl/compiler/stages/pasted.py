"""Pasted: transition expressions of KSE, with their translation instead of what is wrong with them here."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping

from aseme_dsl.amola.messages import Type
from aseme_dsl.amola.statechart import StateType
from aseme_dsl.compiler.names.scope import Scope
from aseme_dsl.compiler.types.scopes import role_scope
from aseme_dsl.diagnostics import Diagnostic, Severity
from aseme_dsl.diagnostics.problems.syntax.formulas import ForeignExpression
from aseme_dsl.grammar.text import tree
from aseme_dsl.grammar.text.lexer import Tokens, clean
from aseme_dsl.records import dataclass
from aseme_dsl.source import Source, Span

_SURE = re.compile(
    r"\bTimeoutCheck\s*\(|\bTimeoutAction\s*\.|\bNULL\b|\bnullptr\b|\bprocess_messages\b|\bpublish_all\b"
    r"|\bpublish\s*\.|\bmicrosec_clock\b|\bposix_time\b|(?<![.\w])\w+\.(?:State|Signal|Data)\.\w"
    r"|\b\w+\.(?:state|signal|data)\.\w+(?:\.\w+)*\.\w+\(",
    re.ASCII,
)
"""What only KSE writes."""
_VERBS = ("enter", "skip", "repeat", "leave", "start", "finish")
_LABEL = re.compile(r"[0-9]+(?:\.[0-9]+)*", re.ASCII)
_TERM_WITH_STATES = re.compile(r"[^\w\s]", re.ASCII)
_AFTER_SOURCE = ("repeat", "leave", "finish")
"""The verbs of transitions that begin in the state of the term."""
_MOST = 2000
"""How many characters an expression has that is looked at."""


@dataclass(frozen=True, slots=True)
class _Line:
    """The expression of a line of control, and whether its state has states inside."""

    place: Span
    is_composite: bool


def pasted(
    diagnostics: Iterable[Diagnostic], files: Iterable[tree.File], top: Scope
) -> tuple[Diagnostic, ...]:
    """The diagnostics, with one for each expression of KSE instead of the errors in it."""
    found = tuple(diagnostics)
    sources = {
        item.span.source for item in found if item.span is not None and item.severity is Severity.ERROR
    }
    foreign = {source for source in sources if _SURE.search(source.text) is not None}
    wrong = [
        (item, item.span)
        for item in found
        if item.severity is Severity.ERROR and item.span is not None and item.span.source in foreign
    ]
    if not wrong:
        return found
    declarations = [item for file in files for item in file.declarations]
    lines: dict[str, list[_Line]] = {}
    inside: dict[int, _Line] = {}
    for item, span in wrong:
        source = span.source
        known = lines.get(source.path)
        if known is None:
            known = lines[source.path] = list(_lines(source, declarations))
        for line in known:
            if line.place.start <= span.start <= line.place.end:
                inside[id(item)] = line
    told = {line: _translated(line, declarations, top) for line in inside.values()}
    kept = [item for item in found if id(item) not in inside]
    return (*kept, *told.values())


def _lines(source: Source, declarations: Iterable[tree.Declaration]) -> Iterator[_Line]:
    """The lines of control that hold an expression of KSE."""
    composites = _composites(declarations)
    read = clean(source)
    tokens = read.tokens
    heads = [(first, colon) for first in range(len(tokens)) if (colon := _colon(tokens, first)) is not None]
    comments = [comment.span.start for comment in read.comments]
    for number, (first, colon) in enumerate(heads):
        after = tokens.ends[colon]
        end = min((start for start in comments if start >= after), default=len(read.text))
        following = heads[number + 1][0] if number + 1 < len(heads) else len(tokens)
        following = min(following, tokens.at(min(end, after + _MOST)))
        stop = next((index for index in range(colon + 1, following) if tokens.word(index) == "}"), following)
        if stop == colon + 1:
            continue
        place = Span(source, tokens.starts[colon + 1], tokens.ends[stop - 1])
        if _SURE.search(place.text) is not None:
            verb, term = tokens.word(first), read.text[tokens.ends[first] : tokens.starts[colon]].strip()
            is_composite = verb in composites or (
                verb in _AFTER_SOURCE and (_TERM_WITH_STATES.search(term) is not None or term in composites)
            )
            yield _Line(place, is_composite)


def _colon(tokens: Tokens, first: int) -> int | None:
    """The token `:` behind the term, or the labels, of a line of control that begins at a token."""
    if not tokens.begins_line(first) and tokens.word(first - 1) != "{":
        return None
    is_labelled = _LABEL.fullmatch(tokens.word(first)) is not None and tokens.word(first + 1) == "->"
    if tokens.word(first) not in _VERBS and not is_labelled:
        return None
    index = first + 1
    while index < len(tokens) and not tokens.begins_line(index):
        if tokens.word(index) == ":":
            return index
        index += 1
    return None


def _composites(declarations: Iterable[tree.Declaration]) -> frozenset[str]:
    """The names of formulas, and the labels of states with states inside."""
    found: set[str] = set()
    for item in declarations:
        if isinstance(item, tree.Srm):
            found |= {formula.name.text for formula in item.formulas}
        elif isinstance(item, tree.Statechart):
            found |= {
                node.label.text for node in item.nodes if node.type.text in (StateType.OR, StateType.AND)
            }
    return frozenset(found)


def _types(line: _Line, declarations: Iterable[tree.Declaration], top: Scope) -> Mapping[str, Type]:
    """The variables and the `let` names that the expression may use."""
    for item in declarations:
        if isinstance(item, tree.Srm | tree.Statechart) and _holds(item.span, line.place):
            scope = role_scope(item, top)[0].scope
            own = {name: kind for name, (_, kind) in scope.variables.items()}
            return {**_of_lets(scope), **own}
    return _of_lets(top)


def _of_lets(scope: Scope) -> dict[str, Type]:
    return {name: item.value.type for name, item in scope.lets.items() if item.value is not None}


def _holds(span: Span, place: Span) -> bool:
    return span.source.path == place.source.path and span.start <= place.start < span.end


def _translated(line: _Line, declarations: Iterable[tree.Declaration], top: Scope) -> Diagnostic:
    from aseme_dsl.interop.emf.expressions import Untranslatable, read_expression
    from aseme_dsl.interop.emf.meaning import Known, Meaning

    messages = {item.name: item for item in top.symbols.messages}
    enums = {item.name: item for item in top.symbols.enums}
    meaning = Meaning(Known(messages, enums, {}, _types(line, declarations, top)))
    text = " ".join(line.place.text.split())
    bare = text.removeprefix("when").lstrip() if text.startswith(("when ", "when[")) else text
    try:
        read = read_expression(bare)
        meaning.add(read)
        meaning.settle()
        now = meaning.text(read, may_wait=line.is_composite or bare != text)
    except Untranslatable as problem:
        return Diagnostic(ForeignExpression(None, str(problem)), line.place)
    return Diagnostic(ForeignExpression(now, ""), line.place, fix=now)


__all__ = ["pasted"]
