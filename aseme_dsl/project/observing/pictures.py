"""Pictures: what led to a breach, or out of a protocol, as lines and as a sequence diagram."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from aseme_dsl.diagrams.sequence.sequence import Arrow, Lifeline, Mark, Row, SequenceDiagram
from aseme_dsl.diagrams.sequence.sequence_svg import pictures
from aseme_dsl.play.sight.story import Happened, told
from aseme_dsl.play.sight.words import content_of, fields_of
from aseme_dsl.project.observing.session import Observed
from aseme_dsl.project.observing.statements import Statement
from aseme_dsl.project.observing.talks import Deviation, Message
from aseme_dsl.project.testing.story_pictures import diagram_of_story, file_names
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
    stories = [(item.watched.of, _of_statement(item)) for item in observed.statements if item.story]
    for item in observed.deviations:
        stories.append((f"{item.message.protocol}-{item.message.conversation}", _of_deviation(item)))
    names = file_names((title for title, _ in stories), "story")
    for name, (_, diagram) in zip(names, stories, strict=True):
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
    content = fields_of(message.content) if isinstance(message.content, Mapping) else ""
    kind = message.message or ""
    return Arrow(
        *(message.moment, message.sender, message.to, message.performative, kind, content),
        conversation=message.conversation,
    )


def _of_statement(item: Statement) -> SequenceDiagram:
    watched = item.watched
    return diagram_of_story(watched.of, item.story, f"{watched.span}: broken at {shown(watched.time_ns)}", {})


__all__ = ["drawn", "lines_of"]
