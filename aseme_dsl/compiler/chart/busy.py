"""Busy: what `plays … when busy` says of invitations while all instances of a participant are in use."""

from __future__ import annotations

from collections.abc import Iterable

from aseme_dsl.amola.aip import Busy
from aseme_dsl.amola.expression import Fill, Literal, Value
from aseme_dsl.amola.messages import DOUBLE
from aseme_dsl.compiler.names.checker import Checker
from aseme_dsl.compiler.names.scope import Scope
from aseme_dsl.compiler.read.builtins import NOT_UNDERSTOOD, PERFORMATIVES
from aseme_dsl.compiler.read.constants import NotConstant, fold
from aseme_dsl.compiler.read.names import unknown_performative
from aseme_dsl.compiler.types.content import fill, rest_of
from aseme_dsl.compiler.types.typecheck import type_value
from aseme_dsl.diagnostics import Diagnostic, Related, closest
from aseme_dsl.diagnostics.problems.absences import NotListed
from aseme_dsl.diagnostics.problems.expressions.values import NotComputed
from aseme_dsl.diagnostics.problems.talk import AnswerNotConstant, AnswerWithoutMessage
from aseme_dsl.grammar.text import tree

REFUSING = ("refuse", "reject_proposal", "failure")
"""What `when busy refuse` says: the first of these that the participant sends, else `not_understood`."""


def busy_of(
    written: tree.Plays, party: tree.Participant, scope: Scope
) -> tuple[Busy | None, tuple[Diagnostic, ...]]:
    """What a player answers to invitations to `party` while it is busy: E511, E512, E514, E577, E596."""
    said = written.busy
    if said is None:
        return None, ()
    if said.answer is not None:
        return _message(said, said.answer, party, scope)
    if said.word == "queue":
        return Busy("", "", None, said.span), ()
    if said.word != "refuse":
        return None, (Diagnostic(AnswerWithoutMessage(said.word), said.span),)
    for performative in REFUSING:
        for item in party.sends:
            if item.performative.text == performative:
                return Busy(performative, item.message.text, None, said.span), ()
    return Busy(NOT_UNDERSTOOD, "", None, said.span), ()


def _message(
    said: tree.Busy, answer: tree.Send, party: tree.Participant, scope: Scope
) -> tuple[Busy | None, tuple[Diagnostic, ...]]:
    """The message that is named, with its content."""
    if answer.performative.text not in PERFORMATIVES:
        return None, (unknown_performative(answer.performative),)
    checker = Checker(scope)
    if not _is_sent(checker, answer, party):
        return None, tuple(checker.diagnostics)
    fills: tuple[Fill, ...] | None = None
    if answer.fills is not None:
        found = fill(checker, answer.message.text, answer.fills, _value)
        rest = None if found is None else rest_of(checker, answer, found, _value)
        if found is None or rest is None:
            return None, tuple(checker.diagnostics)
        if rest.message is not None:
            checker.report(AnswerNotConstant(), rest.message.span)
        fills = tuple(_constants(checker, found))
    busy = Busy(answer.performative.text, answer.message.text, fills, said.span)
    return None if checker.diagnostics else busy, tuple(checker.diagnostics)


def _is_sent(checker: Checker, answer: tree.Send, party: tree.Participant) -> bool:
    """Whether the participant sends it, so that its protocol has this message."""
    texts = tuple(f"{item.performative} {item.message}" for item in party.sends)
    wanted = f"{answer.performative} {answer.message}"
    if wanted in texts:
        return True
    if not checker.scope.symbols.is_excused(answer.message.text):
        first, _, near = (closest(wanted, texts) or "").partition(" ")
        close = near if first == answer.performative.text else None
        performative, message = answer.performative, answer.message
        problem = NotListed(message.text, close, texts, party.name.text, "sends", performative.text)
        span = message.span if close is not None else performative.span.to(message.span)
        checker.report(problem, span, (Related(party.name.span, "the participant"),), close)
    return False


def _value(checker: Checker, written: tree.Expression) -> Value | None:
    value, found = type_value(written, checker.scope)
    checker.diagnostics += found
    return value


def _constants(checker: Checker, fills: Iterable[Fill]) -> Iterable[Fill]:
    """The members with what their expressions come to."""
    for item in fills:
        try:
            value = fold(item.value)
        except NotConstant as problem:
            checker.report(AnswerNotConstant(), problem.value.span)
            continue
        except ArithmeticError as problem:
            checker.report(NotComputed(str(problem)), item.value.span)
            continue
        if item.type == DOUBLE:
            assert not isinstance(value, str)
            value = float(value)
        yield Fill(item.path, item.type, Literal(value, item.type, item.value.span), item.span)


__all__ = ["REFUSING", "busy_of"]
