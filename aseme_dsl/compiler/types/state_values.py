"""State values (`in(T)`, `done(T)`, `count(T)`) and round values (`invited(q)`, `answered(q)`), typed.

Also whether a chart has the states that are named, and whether rounds are asked for only by conditions.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import assert_never

from aseme_dsl.amola.expression import RoundValue, StateValue, values_of, walk
from aseme_dsl.amola.meant import states_meant
from aseme_dsl.amola.messages import BOOL, INT
from aseme_dsl.amola.statechart import State, Statechart, StateType
from aseme_dsl.compiler.formula.formulas import cut
from aseme_dsl.compiler.names.checker import Checker
from aseme_dsl.compiler.read.memory import Memory
from aseme_dsl.compiler.read.names import unknown
from aseme_dsl.compiler.read.pieces import InPieces
from aseme_dsl.compiler.types.calls import is_given, only_name
from aseme_dsl.diagnostics import Diagnostic, Related
from aseme_dsl.diagnostics.problems.absences import NoPartner
from aseme_dsl.diagnostics.problems.expressions.absences import NoStateAsked
from aseme_dsl.diagnostics.problems.expressions.paths import CountOfSeveral, NeverDone, StateAskedInAction
from aseme_dsl.diagnostics.problems.talk import (
    AnswersInAction,
    AnswersOfNobody,
    ExchangeOutsideProtocol,
)
from aseme_dsl.grammar.text import tree
from aseme_dsl.source import Span


def state_value(checker: Checker, question: str, written: tree.Call) -> StateValue | None:
    """`in(chase)`: of which states it asks is known only in a chart."""
    if not is_given(checker, question, written, 1):
        return None
    name = only_name(checker, question, written.arguments[0], "state")
    if name is None:
        return None
    kind = INT if question == "count" else BOOL
    return StateValue(question, name.text, kind, name.span, written.span)


def check_states(charts: Sequence[Statechart], memory: Memory) -> InPieces[list[Diagnostic]]:
    """E430 where a chart has no state of the name, E431 where `count` means several, E433 in actions."""
    found: dict[Span, Diagnostic] = {}
    asked = yield from memory.each_in_pieces(_questions, zip(charts))
    for chart, questions in zip(charts, asked, strict=True):
        for place, value, in_condition in questions:
            if value.span in found:
                continue
            problem = _problem(chart, place, value, in_condition)
            if problem is not None:
                found[value.span] = problem
    return list(found.values())


def _questions(chart: Statechart) -> tuple[tuple[str, StateValue, bool], ...]:
    """What is asked of states, with the state where it is asked and whether a condition asks it."""
    return tuple(_each_question(chart))


def _each_question(chart: Statechart) -> Iterator[tuple[str, StateValue, bool]]:
    for node in chart.states:
        for argument in node.arguments:
            for value in walk(argument.value):
                if isinstance(value, StateValue):
                    yield node.label, value, False
    for transition in chart.transitions:
        guard = transition.expression.guard
        values = () if guard is None else walk(guard)
        asked = {value.span for value in values if isinstance(value, StateValue)}
        for value in values_of(transition.expression):
            if isinstance(value, StateValue):
                yield transition.source, value, value.span in asked


def _problem(chart: Statechart, source: str, value: StateValue, in_condition: bool) -> Diagnostic | None:
    found = states_meant(chart, source, value.state)
    if value.question != "count" and not in_condition:
        return Diagnostic(StateAskedInAction(value.question), value.span)
    if not found:
        names = {node.name for node in chart.states if _has_name(node)}
        return unknown(NoStateAsked, tree.Name(value.state, value.named), names, chart.name)
    if value.question == "count" and len(found) > 1:
        related = tuple(Related(node.span, f"{node.label}") for node in found[:5])
        return Diagnostic(CountOfSeveral(cut(value.state), len(found)), value.span, related)
    if value.question == "done" and not any(_completes(chart, node) for node in found):
        name = cut(value.state)
        return Diagnostic(NeverDone(name), value.span, (Related(found[0].span, f"`{name}`"),))
    return None


def _has_name(node: State) -> bool:
    return node.name != node.label and node.name.isidentifier()


def _completes(chart: Statechart, node: State) -> bool:
    match node.type:
        case StateType.OR:
            return chart.end_of(node.label) is not None
        case StateType.AND:
            return all(chart.end_of(region.label) is not None for region in chart.children(node.label))
        case StateType.START | StateType.END | StateType.BASIC | StateType.CONDITION:
            return not node.waits
        case _:
            assert_never(node.type)


def round_value(checker: Checker, question: str, written: tree.Call) -> RoundValue | None:
    """A question about the last send to a participant: E205, E504, E576."""
    scope = checker.scope
    if not is_given(checker, question, written, 1):
        return None
    name = only_name(checker, question, written.arguments[0], "participant")
    if name is None:
        return None
    if not scope.parties:
        checker.report(ExchangeOutsideProtocol("answered"), written.span)
        return None
    party = scope.parties.get(name.text)
    if party is None:
        if not scope.symbols.is_excused(name.text):
            checker.diagnostics.append(unknown(NoPartner, name, scope.parties))
        return None
    own = scope.parties.get(scope.participant or "")
    if own is not None and not own.wrong and not party.wrong:
        received = {(item.performative, item.message) for item in party.receives}
        if not any((item.performative, item.message) in received for item in own.sends):
            checker.report(AnswersOfNobody(own.name, party.name), written.span)
            return None
    kind = BOOL if question == "all_answered" else INT
    return RoundValue(question, name.text, kind, name.span, written.span)


def check_rounds(charts: Sequence[Statechart], memory: Memory) -> InPieces[list[Diagnostic]]:
    """E575 where something else than a condition counts answers."""
    found: dict[Span, Diagnostic] = {}
    asked = yield from memory.each_in_pieces(_asked_elsewhere, zip(charts))
    for values in asked:
        for value in values:
            found.setdefault(value.span, Diagnostic(AnswersInAction(value.question), value.span))
    return list(found.values())


def _asked_elsewhere(chart: Statechart) -> tuple[RoundValue, ...]:
    return tuple(_each_elsewhere(chart))


def _each_elsewhere(chart: Statechart) -> Iterator[RoundValue]:
    for node in chart.states:
        for argument in node.arguments:
            yield from (value for value in walk(argument.value) if isinstance(value, RoundValue))
    for transition in chart.transitions:
        guard = transition.expression.guard
        asked = {value.span for value in (walk(guard) if guard is not None else ())}
        for value in values_of(transition.expression):
            if isinstance(value, RoundValue) and value.span not in asked:
                yield value


__all__ = ["check_rounds", "check_states", "round_value", "state_value"]
