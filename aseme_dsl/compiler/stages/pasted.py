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
from aseme_dsl.records import dataclass
from aseme_dsl.source import Source, Span

_SURE = re.compile(
    r"\bTimeoutCheck\s*\(|\bTimeoutAction\s*\.|\bNULL\b|\bnullptr\b|\bprocess_messages\b|\bpublish_all\b"
    r"|\bpublish\s*\.|\bmicrosec_clock\b|\bposix_time\b|(?<![.\w])\w+\.(?:State|Signal|Data)\.\w"
    r"|\b\w+\.(?:state|signal|data)\.\w+(?:\.\w+)*\.\w+\(",
    re.ASCII,
)
"""What only KSE writes."""
_HEAD = re.compile(
    r"(?:^|\{)[ \t]*(?:(?P<verb>enter|skip|repeat|leave|start|finish)\b(?P<term>[^:\n]*?)"
    r"|(?P<source>[0-9]+(?:\.[0-9]+)*)[ \t]*->[ \t]*[0-9.]+)[ \t]*:(?!:)",
    re.MULTILINE | re.ASCII,
)
_END = re.compile(r'(?:"(?:[^"\\\n]|\\.)*"|[^"}/]|/(?![/*]))*', re.ASCII)
"""Up to the end of a block or a comment; neither is in an expression of KSE."""
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
    wrong = [
        (item, item.span) for item in found if item.span is not None and _may_be_foreign(item, item.span)
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


def _may_be_foreign(item: Diagnostic, span: Span) -> bool:
    return item.severity is Severity.ERROR and _SURE.search(span.source.text) is not None


def _lines(source: Source, declarations: Iterable[tree.Declaration]) -> Iterator[_Line]:
    """The lines of control that hold an expression of KSE."""
    composites = _composites(declarations)
    heads = list(_HEAD.finditer(source.text))
    for number, head in enumerate(heads):
        last = heads[number + 1].start() if number + 1 < len(heads) else len(source.text)
        found = _END.match(source.text, head.end(), min(last, head.end() + _MOST))
        text = "" if found is None else found[0]
        start = head.end() + len(text) - len(text.lstrip())
        if _SURE.search(text) is not None:
            term = (head["term"] or "").strip()
            is_composite = head["source"] in composites or (
                head["verb"] in _AFTER_SOURCE
                and (_TERM_WITH_STATES.search(term) is not None or term in composites)
            )
            yield _Line(Span(source, start, head.end() + len(text.rstrip())), is_composite)


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
