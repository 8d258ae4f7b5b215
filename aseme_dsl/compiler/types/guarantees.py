"""Guarantees: what activities promise of the messages that they send, with names and types."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from aseme_dsl.amola.expression import EnumConstant, Literal, ParameterValue, operands, value_text, walk
from aseme_dsl.amola.messages import BOOL, Channel, Kind, Type
from aseme_dsl.amola.srm import Guarantee, Sent
from aseme_dsl.compiler.names.checker import Checker
from aseme_dsl.compiler.names.scope import Scope
from aseme_dsl.compiler.types.typecheck import type_value
from aseme_dsl.diagnostics import Related, closest
from aseme_dsl.diagnostics.problems import activities as problems
from aseme_dsl.grammar.text import tree


def read_guarantees(
    checker: Checker, written: tree.Activity, writes: Sequence[Channel]
) -> Iterator[Guarantee]:
    """What an activity that publishes on these channels guarantees; what is wrong is reported (E231)."""
    for item in written.guarantees:
        sents = [item.said] if item.earlier is None else [item.said, item.earlier]
        channels = [_channels(checker, written.name.text, sent, writes) for sent in sents]
        if not all(channels):
            continue
        names = [sent.called for sent in sents]
        if len({name.text for name in names}) < len(names):
            checker.report(
                problems.GuaranteeNamesTwice(names[0].text),
                names[1].span,
                (Related(names[0].span, "first named here"),),
            )
            continue
        known: dict[str, Type | None] = {
            sent.called.text: Type(Kind.MESSAGE, found[0].message)
            for sent, found in zip(sents, channels, strict=True)
        }
        scope = Scope(checker.scope.symbols, parameters=known, inputs=frozenset(known))
        read = [_sent(checker, sent, found, scope) for sent, found in zip(sents, channels, strict=True)]
        said, earlier = (*read, None)[:2]
        if said is None or (earlier is None) != (item.earlier is None):
            continue
        if item.within is not None and item.within.nanoseconds <= 0:
            checker.report(problems.GuaranteeWithoutTime(), item.within.span)
            continue
        within = None if item.within is None else item.within.nanoseconds
        yield Guarantee(said, within, earlier, item.span)


def _channels(
    checker: Checker, activity: str, sent: tree.Sent, writes: Sequence[Channel]
) -> tuple[Channel, ...]:
    """The channels that are meant, of those on which the activity publishes; none is reported."""
    name = "".join(sent.message.text.split())
    found = tuple(item for item in writes if name in (item.message, str(item)))
    if not found:
        near = closest(name, [*(item.message for item in writes), *map(str, writes)])
        problem = problems.GuaranteeOfOther(activity, name, near)
        checker.report(problem, sent.message.span, fix=near)
    return found


def _sent(checker: Checker, sent: tree.Sent, channels: tuple[Channel, ...], scope: Scope) -> Sent | None:
    called = sent.called.text
    if sent.condition is None:
        return Sent(channels[0].message, channels, called, None, sent.span)
    value, wrong = type_value(sent.condition, scope, BOOL)
    checker.diagnostics += wrong
    if value is None:
        return None
    for part in walk(value):
        if not operands(part) and not isinstance(part, Literal | EnumConstant | ParameterValue):
            checker.report(problems.GuaranteeReadsMore(value_text(part)), part.span)
            return None
    return Sent(channels[0].message, channels, called, value, sent.span)


__all__ = ["read_guarantees"]
