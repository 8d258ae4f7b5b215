"""Pictures: what led to a breach, or out of a protocol, as lines and as a sequence diagram."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping

from aseme_dsl.diagrams.sequence.sequence import Arrow, Lifeline, Mark, Row, SequenceDiagram
from aseme_dsl.diagrams.sequence.sequence_svg import pictures
from aseme_dsl.play.sight.story import Happened, told
from aseme_dsl.play.sight.words import content_of
from aseme_dsl.project.observing.session import Observed
from aseme_dsl.project.observing.statements import Statement
from aseme_dsl.project.observing.talks import Deviation, Message
from aseme_dsl.runtime.time.clock import shown

LINES = 8
"""So many of the last messages of a conversation are lines of its story."""


def lines_of(item: Deviation) -> Iterator[str]:
    """The last messages of a conversation, up to the one that is not allowed."""
    story = item.story[-LINES:]
    earlier = item.earlier + len(item.story) - len(story)
    if earlier:
        yield f"… {earlier} earlier message{'' if earlier == 1 else 's'}"
    yield from told(
        Happened(message.moment, message.sender, f"sends {_said(message)} to {_receivers(message)}")
        for message in story
    )


def _said(message: Message) -> str:
    content = message.content
    return f"{message.text}{content_of(content) if isinstance(content, Mapping) else ''}"


def _receivers(message: Message) -> str:
    return ", ".join(message.to) or "no agent"


def drawn(observed: Observed) -> Iterator[tuple[str, str]]:
    """An SVG for each page of each story, with a name for its file; names are different."""
    names: set[str] = set()
    stories = [(item.watched.of, _of_statement(item)) for item in observed.statements if item.story]
    for item in observed.deviations:
        stories.append((f"{item.message.protocol}-{item.message.conversation}", _of_deviation(item)))
    for title, diagram in stories:
        plain = re.sub(r"[^\w.-]+", "-", title).strip("-.")[:80] or "story"
        name = next(it for it in (plain, *(f"{plain}-{n}" for n in range(2, 10_000))) if it not in names)
        names.add(name)
        for number, text in enumerate(pictures(diagram, None), 1):
            yield f"{name}.svg" if number == 1 else f"{name}.page{number}.svg", text


def _of_deviation(item: Deviation) -> SequenceDiagram:
    last = item.message
    arrows: list[Row] = [_arrow(message) for message in item.story]
    names = dict.fromkeys(name for message in item.story for name in (message.sender, *message.to))
    parts: dict[str, str] = {}
    for message in item.story:
        parts.setdefault(message.sender, message.parts[0])
        for name in message.to:
            parts.setdefault(name, message.parts[1])
    if item.part:
        parts[last.sender] = item.part
    arrows.append(Mark(last.moment, last.sender, item.reason, last.conversation))
    lifelines = tuple(Lifeline(name, parts.get(name, "")) for name in names)
    remarks = (f"{item.span}: {item.instead}",)
    return SequenceDiagram(f"{last.protocol} · {last.conversation}", lifelines, tuple(arrows), remarks)


def _arrow(message: Message) -> Arrow:
    content = content_of(message.content).strip(" {}") if isinstance(message.content, Mapping) else ""
    kind = message.message or ""
    return Arrow(
        *(message.moment, message.sender, message.to, message.performative, kind, content),
        conversation=message.conversation,
    )


def _of_statement(item: Statement) -> SequenceDiagram:
    names = dict.fromkeys(name for happened in item.story for name in (happened.agent, *happened.to))
    rows: Iterable[Row] = (
        Arrow(happened.moment, happened.agent, happened.to, happened.sent, "")
        if happened.to
        else Mark(happened.moment, happened.agent, happened.line)
        for happened in item.story
    )
    watched = item.watched
    remarks = (f"{watched.span}: broken at {shown(watched.time_ns)}",)
    return SequenceDiagram(watched.of, tuple(Lifeline(name) for name in names), tuple(rows), remarks)


__all__ = ["drawn", "lines_of"]
