"""Items: what is offered to an author who types, independent of the protocol of any editor."""

from __future__ import annotations

from enum import StrEnum

from aseme_dsl.records import dataclass


class ItemKind(StrEnum):
    """What an item is; editors draw a sign for each."""

    WORD = "word"  # of the language
    SNIPPET = "snippet"  # a whole declaration
    TOPIC = "topic"
    CLASS = "class"  # a channel kind
    MESSAGE = "message"
    MEMBER = "member"
    ENUM = "enum"
    CONSTANT = "constant"
    TYPE = "type"
    VARIABLE = "variable"
    LET = "let"
    FUNCTION = "function"
    TIMER = "timer"
    EVENT = "event"
    PERFORMATIVE = "performative"
    TERM = "term"
    FORMULA = "formula"
    ACTIVITY = "activity"
    FUNCTIONALITY = "functionality"
    ROLE = "role"
    ACTOR = "actor"
    USE_CASE = "use case"
    PROTOCOL = "protocol"
    PARTICIPANT = "participant"
    AGENT = "agent"
    STATE = "state"
    FILE = "file"
    NAME = "name"  # one that is used, but not declared yet


@dataclass(frozen=True, slots=True)
class Item:
    """One offer.

    `insert` replaces the text from `start` to `end`; it is written as a snippet of LSP if `is_snippet`.
    `rank` sorts, the smallest first. With `goes_on` the editor asks again at once for what follows.
    """

    label: str
    kind: ItemKind
    detail: str = ""
    documentation: str = ""
    insert: str = ""
    is_snippet: bool = False
    rank: int = 5
    start: int = -1
    end: int = -1
    goes_on: bool = False

    @property
    def commit(self) -> tuple[str, ...]:
        """Characters that accept the item when they are typed."""
        return (".",) if self.kind in (ItemKind.TOPIC, ItemKind.CLASS, ItemKind.ENUM, ItemKind.AGENT) else ()


def escaped(text: str) -> str:
    """Text as it stands in a snippet."""
    return text.replace("\\", "\\\\").replace("$", "\\$").replace("}", "\\}")


__all__ = ["Item", "ItemKind", "escaped"]
