"""Round values: `invited(q)`, `answered(q)` and `all_answered(q)`, typed; and whether conditions ask them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from aseme_dsl.amola.expression import RoundValue, values_of, walk
from aseme_dsl.amola.messages import BOOL, INT
from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.compiler.names.checker import Checker
from aseme_dsl.compiler.read.memory import Memory
from aseme_dsl.compiler.read.names import unknown
from aseme_dsl.compiler.read.pieces import InPieces
from aseme_dsl.compiler.types.calls import is_given, only_name
from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.diagnostics.problems.absences import NoPartner
from aseme_dsl.diagnostics.problems.talk import (
    AnswersInAction,
    AnswersOfNobody,
    ExchangeOutsideProtocol,
)
from aseme_dsl.grammar.text import tree
from aseme_dsl.source import Span


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


__all__ = ["check_rounds", "round_value"]
