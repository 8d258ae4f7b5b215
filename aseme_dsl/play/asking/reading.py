"""Reading: what a part of a condition reads at a moment: values, with their ages and senders."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from aseme_dsl.amola.expression import (
    Bound,
    Call,
    Expired,
    Index,
    LossReason,
    Member,
    Outcome,
    RoundValue,
    Sender,
    Value,
    VariableValue,
    value_text,
    walk,
)
from aseme_dsl.play.asking.parts import Part
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.board import Board
from aseme_dsl.runtime.chart.chart import Chart
from aseme_dsl.runtime.chart.inputs import LOST, AgentMessage, Identity
from aseme_dsl.runtime.chart.plan import is_in
from aseme_dsl.runtime.message.as_json import to_json

MADE_UP = -1
"""The number of a message that a trial makes up: it is not there."""


@dataclass(frozen=True, slots=True)
class Reading:
    """Something that a condition reads. `value` is as JSON has it, None if it is absent.

    A message has its age in ns (an agent message only if it is known), its sender and its identity; one of a
    topic has its channel.
    """

    text: str
    value: object
    channel: str | None = None
    host: str | None = None
    age: int | None = None
    sender: str | None = None
    identity: Identity | None = None
    is_timer: bool = False
    """Its value is when it runs out, in ns."""
    variable: str = ""
    """The variable of the role that it is."""


def readings(part: Part, chart: Chart, now: int, given: Mapping[str, object]) -> tuple[Reading, ...]:
    """What a part reads, each once; `given` is what functions of the document gave last."""
    found = (item for value in walk(part.value) for item in _readings(value, part, chart, now, given))
    return tuple({(item.text, item.identity): item for item in found}.values())


def _readings(
    value: Value, part: Part, chart: Chart, now: int, given: Mapping[str, object]
) -> Iterator[Reading]:
    if isinstance(value, Bound | Sender | LossReason):
        yield from _of_letters(value, part, chart, now)
    elif (found := _reading(value, part, chart, now, given)) is not None:
        yield found


def is_unknown(part: Part, chart: Chart) -> bool:
    """Whether a part asks what a message says that a trial has made up: nothing is known of that."""
    board = board_in(chart, part.region)
    for channel, host in part.said:
        item = None if board is None else board.newest(channel, host)
        if item is not None and item.identity[1] == MADE_UP:
            return True
    return part.asks_letter and any(mail.identity[1] == MADE_UP for mail in _letters(part, chart))


def _letters(part: Part, chart: Chart) -> Iterator[AgentMessage]:
    """The agent messages that the transition of a part could take."""
    events = (event for event in chart.PLAN.transitions[part.transition].events if len(event) > 1)
    kinds = {(LOST, "", event[1]) if event[0] == "lost" else event[1:4] for event in events}
    for mail in chart.mail.get(part.branch, ()):
        if (mail.performative, mail.message, mail.participant) in kinds:
            yield mail


def _of_letters(value: Bound | Sender | LossReason, part: Part, chart: Chart, now: int) -> Iterator[Reading]:
    """What each of the agent messages says that the transition of the part could take."""
    for mail in _letters(part, chart):
        if mail.identity[1] == MADE_UP:
            continue
        match value:
            case Bound(path=path):
                found = to_json(_inside(mail.content, path))
            case Sender():
                found = mail.sender
            case LossReason():
                found = str(mail.content)
        age = None if mail.sent is None else now - mail.sent
        yield Reading(value_text(value), found, age=age, sender=mail.sender, identity=mail.identity)


def _reading(value: Value, part: Part, chart: Chart, now: int, given: Mapping[str, object]) -> Reading | None:
    text = value_text(value)
    match value:
        case Member(channel=channel, host=host, path=path):
            return _message(text, str(channel), host, path, part, chart, now)
        case VariableValue(name=name, path=path):
            return Reading(text, to_json(_inside(chart.variable(name), path)), variable=name)
        case Expired(timer=timer):
            return Reading(f"timer {timer}", _timer(chart, part.region, timer), is_timer=True)
        case Outcome(activity=activity):
            labels = tuple(state.label for state in chart.PLAN.states if state.activity == activity)
            return Reading(text, chart.last_outcome(labels))
        case RoundValue(question=question, participant=participant):
            return Reading(text, getattr(chart, question)(part.branch, participant))
        case Index():
            return Reading(text, chart.index)
        case Call(function=function) if function.is_of_document:
            kinds = ", ".join(str(kind) for _, kind in function.parameters)
            name = f"{function.name}({kinds})"
            return Reading(f"what {function.name} gave last", given[name]) if name in given else None
    return None


def _message(
    text: str, channel: str, host: str | None, path: tuple[str, ...], part: Part, chart: Chart, now: int
) -> Reading:
    board = board_in(chart, part.region)
    item = None if board is None else board.newest(channel, host)
    if item is None or item.identity[1] == MADE_UP:
        return Reading(text, None, channel, host)
    value = to_json(_inside(item.message, path))
    return Reading(text, value, channel, host, now - item.time, item.sender, item.identity)


def board_in(chart: Chart, region: str) -> Board | None:
    """The blackboard of a region; of one that is not active, that of the region around it, of which it will
    have the messages when it is entered."""
    boards = zip(chart.REGIONS, chart.boards(), strict=True)
    around = [(label, board) for label, board in boards if board is not None and is_in(region, label)]
    return max(around, key=lambda item: len(item[0]))[1] if around else None


def _inside(value: object, path: tuple[str, ...]) -> object:
    for name in path:
        value = None if value is None else getattr(value, name)
    return value


def _timer(chart: Chart, region: str, timer: str) -> int | None:
    board = board_in(chart, region)
    return None if board is None else board.timers.get(timer)


__all__ = ["MADE_UP", "Reading", "board_in", "is_unknown", "readings"]
