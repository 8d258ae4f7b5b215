"""Content: whether the Python of activities prepares what their participants send without content in braces.

`context.prepare(Done(task=1))`.
"""

from __future__ import annotations

import ast
from collections.abc import Collection, Iterator, Mapping

from aseme_dsl.amola.statechart import State, Statechart, StateType
from aseme_dsl.amola.system import System
from aseme_dsl.codegen.opening import openings_of
from aseme_dsl.compiler.checks.talk.preparing import ACTIVITY, all_bare_sends, bare_sends, with_defaults
from aseme_dsl.compiler.read.library import is_of_library
from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.diagnostics.problems.talk import ContentNotPrepared, ContentNotPreparedInCode
from aseme_dsl.source import Span

Prepared = Mapping[str, frozenset[str] | None]
"""Of each activity with code: the types of message that it prepares, or None where the text does not say."""


def prepared_in(module: ast.Module, contexts: Collection[str]) -> frozenset[str] | None:
    """What a module prepares; None where its text does not tell.

    That is so if it gives its context away, inherits, or prepares what it does not make at that place.
    """
    owners = {id(node.value) for node in ast.walk(module) if isinstance(node, ast.Attribute)}
    called = {id(node.func) for node in ast.walk(module) if isinstance(node, ast.Call)}
    found: set[str] = set()
    for node in ast.walk(module):
        match node:
            case ast.ClassDef(bases=bases) if bases:
                return None
            case ast.Name(id=name, ctx=ast.Load()) if name in contexts and id(node) not in owners:
                return None
            case ast.Attribute(attr="prepare") if id(node) not in called:
                return None
            case ast.Call(func=ast.Attribute(attr="prepare"), args=arguments):
                made = arguments[0] if arguments else None
                if not isinstance(made, ast.Call) or not isinstance(made.func, ast.Name | ast.Attribute):
                    return None
                found.add(made.func.id if isinstance(made.func, ast.Name) else made.func.attr)
    return frozenset(found)


def never_prepared(system: System, prepared: Prepared) -> Iterator[Diagnostic]:
    """W576 for a `send` without content, where there is code of all that runs before and none prepares it.

    The opening message may also be prepared before the part begins: there all activities of the role count.
    Where none can have run yet, and an activity of the part has code, no code prepares it either.
    """
    known = {item.name for item in system.messages}
    sure = {name: types for name, types in prepared.items() if types is not None and types <= known}
    told: set[tuple[Span, tuple[str, ...]]] = set()
    for chart in system.iacs:
        for problem, place in _in_role(system, chart, sure):
            if (place, problem.activities) not in told:
                told.add((place, problem.activities))
                yield Diagnostic(problem, place, edits=with_defaults(place))
    places = {place for place, _ in told}
    for chart in system.iacs:
        for unprepared, place in _before_all(system, chart, prepared):
            if place not in places:
                places.add(place)
                yield Diagnostic(unprepared, place, edits=with_defaults(place))


def _before_all(
    system: System, chart: Statechart, prepared: Prepared
) -> Iterator[tuple[ContentNotPrepared, Span]]:
    """What opens a conversation before any activity of the role can have run: a part with code fails then."""
    for way, send, there in all_bare_sends(chart, chart.root):
        branch = chart.branch_of(way.source)
        if branch is None or any(name.startswith(ACTIVITY) for name in there):
            continue
        inside = [node.activity for node in chart.states if node.label.startswith(f"{branch}.")]
        if is_of_library(send.span.source) or not any(name in prepared for name in inside):
            continue
        if _is_invited(system, chart.node(branch)) is False:
            ends = chart.node(way.target).type is StateType.END
            yield ContentNotPrepared(send.performative, send.message, ends), send.span


def _is_invited(system: System, branch: State) -> bool | None:
    """Whether a participant joins conversations that others open; None if it is none."""
    eac = system.eac(branch.origin.owner)
    aip = next((item for item in system.aips if item.name == branch.origin.owner), None)
    part = aip.participant(branch.origin.name) if aip is not None else None
    return None if eac is None or part is None else bool(openings_of(eac, part))


def _in_role(
    system: System, chart: Statechart, sure: Mapping[str, frozenset[str]]
) -> Iterator[tuple[ContentNotPreparedInCode, Span]]:
    everywhere = {node.activity for node in chart.states if node.activity is not None}
    for branch in chart.states:
        if not chart.is_branch(branch):
            continue
        is_invited = _is_invited(system, branch)
        if is_invited is None:
            continue
        for way, send, activities in bare_sends(chart, branch):
            before = activities if is_invited else everywhere
            if chart.branch_of(way.source) != branch.label or is_of_library(send.span.source):
                continue
            if before and all(send.message not in sure.get(name, (send.message,)) for name in before):
                names = tuple(sorted(activities or before))
                yield ContentNotPreparedInCode(send.performative, send.message, names), send.span


__all__ = ["Prepared", "never_prepared", "prepared_in"]
