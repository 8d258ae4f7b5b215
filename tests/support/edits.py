"""Random edits of `.aseme` texts, such as people make while they type: many leave the text broken."""

from __future__ import annotations

import re
from dataclasses import dataclass

from hypothesis import strategies as st

TOKENS = (
    '{ } ( ) [ ] . | || ~ + * , ; : = == && ! / // /* */ " \n - -> # @ 🤖 \r\n srm aip topic message let enum'
    " control liveness enter leave skip repeat finish start else when x y 3 3s 0.2 system import suc sag team"
    " activities participant process statechart scenario function var as with every reads writes uses"
).split(" ")


@dataclass(frozen=True, slots=True)
class Edit:
    """One of `KINDS`, at a place from 0 (the beginning) to 999 (the end)."""

    kind: str
    place: int
    other: int
    token: str


KINDS = ("insert", "delete", "drop line", "copy line", "other word", "type", "undo")

edits = st.builds(
    Edit, st.sampled_from(KINDS), st.integers(0, 999), st.integers(0, 999), st.sampled_from(TOKENS)
)


def edited(text: str, edit: Edit, original: str) -> str:
    """The text after an edit; `undo` is back to the original."""
    at = edit.place * len(text) // 999
    match edit.kind:
        case "insert":
            return f"{text[:at]} {edit.token} {text[at:]}"
        case "type":
            return text[:at] + edit.token + text[at:]
        case "delete":
            return text[:at] + text[at + 1 + edit.other % 12 :]
        case "drop line":
            start, end = _line(text, at)
            return text[:start] + text[end:]
        case "copy line":
            start, end = _line(text, at)
            other, _ = _line(text, edit.other * len(text) // 999)
            return text[:other] + text[start:end] + text[other:]
        case "other word":
            words = list(re.finditer(r"[A-Za-z_]\w*", text))
            if not words:
                return text
            word = words[edit.place * (len(words) - 1) // 999]
            by = words[edit.other * (len(words) - 1) // 999]
            return text[: word.start()] + by.group() + text[word.end() :]
    return original


def _line(text: str, at: int) -> tuple[int, int]:
    start = text.rfind("\n", 0, at) + 1
    end = text.find("\n", at)
    return start, len(text) if end < 0 else end + 1
