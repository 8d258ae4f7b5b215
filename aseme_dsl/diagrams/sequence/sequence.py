"""Sequence diagrams: who takes part in conversations, what is said, and what happens to one of them."""

from __future__ import annotations

from collections.abc import Iterator

from aseme_dsl.records import dataclass

PAGE = 60
"""So many rows are one page: more are not looked at together."""

DECLINING = frozenset("refuse reject_proposal failure disconfirm cancel not_understood".split())
"""The performatives that end something or say no: their arrows are dashed."""


@dataclass(frozen=True, slots=True)
class Lifeline:
    """An agent that takes part, or `count` of one role; `role` is what it is, and what it plays."""

    name: str
    role: str = ""
    count: int = 1


@dataclass(frozen=True, slots=True)
class Arrow:
    """A message. `moment` is in ns; `content` is short, `whole` all of it."""

    moment: int
    sender: str
    receivers: tuple[str, ...]
    performative: str
    message: str
    content: str = ""
    whole: str = ""
    conversation: str = ""

    @property
    def text(self) -> str:
        """What is said, without what it contains."""
        return f"{self.performative} {self.message}".rstrip()


@dataclass(frozen=True, slots=True)
class Mark:
    """Something that happens to one agent: a deadline passes, a message is not expected, it breaks down, …

    `ends` says that the agent takes part in nothing any more.
    """

    moment: int
    agent: str
    text: str
    conversation: str = ""
    ends: bool = False


Row = Arrow | Mark


@dataclass(frozen=True, slots=True)
class SequenceDiagram:
    """Lifelines from left to right, rows from top to bottom, and what is said of the whole below them."""

    title: str
    lifelines: tuple[Lifeline, ...]
    rows: tuple[Row, ...]
    remarks: tuple[str, ...] = ()

    @property
    def conversations(self) -> tuple[str, ...]:
        """The conversations of the rows, in the order in which they begin."""
        return tuple(dict.fromkeys(row.conversation for row in self.rows if row.conversation))


def pages(diagram: SequenceDiagram, rows: int = PAGE) -> Iterator[SequenceDiagram]:
    """The diagram in pieces of so many rows at the most, each with all lifelines; one, if it is short."""
    count = max(1, -(-len(diagram.rows) // rows))
    each = -(-len(diagram.rows) // count) if diagram.rows else 1
    for number in range(count):
        part = diagram.rows[number * each : (number + 1) * each]
        title = diagram.title if count == 1 else f"{diagram.title} · page {number + 1} of {count}"
        yield SequenceDiagram(title, diagram.lifelines, part, diagram.remarks)


def seconds(moment: int) -> str:
    """A moment in ns as it is written beside a row."""
    return f"{moment / 1e9:.3f}".rstrip("0").rstrip(".") + " s"


__all__ = ["DECLINING", "PAGE", "Arrow", "Lifeline", "Mark", "Row", "SequenceDiagram", "pages", "seconds"]
