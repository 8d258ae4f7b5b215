"""Staying: `on T` and `exit T`, the lines of control and of charts that lead nowhere."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from aseme_dsl.amola.expression import Has, Logic, Member, TransitionExpression
from aseme_dsl.amola.messages import ChannelKind
from aseme_dsl.amola.operators import Operator
from aseme_dsl.amola.statechart import TransitionKind
from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.diagnostics.problems.control import (
    AbandonWaits,
    ElseOfOn,
    ErrorOfOn,
    ExitWaits,
    IgnoredNoSignal,
    IgnoresMisplaced,
    NothingDone,
)
from aseme_dsl.grammar.text import tree
from aseme_dsl.source import Span

STAYING: Mapping[str, TransitionKind] = {"on": TransitionKind.ON, "exit": TransitionKind.EXIT}
"""The verbs of these lines, with what they mean."""
ABANDON = "abandon"
"""The word after `on` that is not a term: the participant is exited before its END."""
IGNORING = -1
"""The position of a line with `ignores`: it is tried before the other lines of its state."""


def is_abandon(line: tree.Way) -> bool:
    """Whether a line is `on abandon`, unless `abandon` is a term of the formula."""
    term = line.term.formula
    return line.verb.text == "on" and term.operator is Operator.NAME and term.name == ABANDON


def check_staying(line: tree.Way | tree.StandingWay, *, abandons: bool = False) -> Iterator[Diagnostic]:
    """What an `on` (E422), `exit` or `on abandon` (E424) line cannot wait for; what does nothing (E423).

    A line that takes an agent message, a loss or an event does something without an action: nothing around
    takes it then.
    """
    state = (line.term if isinstance(line, tree.Way) else line.state).span.text
    written = line.expression
    if line.verb.text == "exit" or abandons:
        if written.events or written.condition is not None or written.when or written.otherwise:
            yield Diagnostic(AbandonWaits() if abandons else ExitWaits(state), _before_actions(written))
    elif written.otherwise:
        yield Diagnostic(ElseOfOn(state), _before_actions(written))
    else:
        for event in written.events:
            if isinstance(event, tree.Raised) and event.name.text == "error":
                yield Diagnostic(ErrorOfOn(state, isinstance(line, tree.StandingWay)), event.span)
    takes = any(isinstance(event, tree.Received | tree.Lost | tree.Raised) for event in written.events)
    if not written.actions and written.ignores is None and not takes:
        yield Diagnostic(NothingDone(line.verb.text, state), line.span)


def check_ignoring(
    line: tree.Way | tree.LabelledWay | tree.StandingWay, typed: TransitionExpression
) -> Iterator[Diagnostic]:
    """E435 for `ignores` on a line of another verb than `on`, or with something that is not a signal."""
    word = line.expression.ignores
    if word is None:
        return
    if isinstance(line, tree.LabelledWay) or line.verb.text not in STAYING:
        yield Diagnostic(IgnoresMisplaced(), word)
        return
    condition = typed.condition
    parts = condition.operands if isinstance(condition, Logic) else (condition,)
    for part in parts:
        match part:
            case Has(message=Member(channel=channel, path=())) if channel.comm is ChannelKind.SIGNAL:
                pass
            case Has(span=span):
                yield Diagnostic(IgnoredNoSignal(span.text), span)
            case _:
                pass  # what is wrong with it has been said


def _before_actions(written: tree.TransitionExpression) -> Span:
    """The place of events, `else` and condition."""
    if not written.actions:
        return written.span
    text = written.span.source.text[written.span.start : written.actions[0].span.start]
    end = written.span.start + len(text.rstrip().removesuffix("/").rstrip())
    return Span(written.span.source, written.span.start, max(end, written.span.start))


__all__ = ["ABANDON", "IGNORING", "STAYING", "check_ignoring", "check_staying", "is_abandon"]
