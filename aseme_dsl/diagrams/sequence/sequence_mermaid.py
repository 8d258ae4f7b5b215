"""A sequence diagram as the text that Mermaid draws."""

from __future__ import annotations

import re
from collections.abc import Iterator

from aseme_dsl.diagrams.sequence.sequence import DECLINING, Arrow, Mark, SequenceDiagram, seconds

_ENTITIES = str.maketrans({"#": "#35;", ";": "#59;", "<": "#lt;", ">": "#gt;", "\n": " "})
_WORDS = re.compile(r"[A-Za-z_]\w*", re.ASCII)
_RESERVED = frozenset("end box loop alt else opt par and note over critical break rect activate as".split())
"""Words of Mermaid's that no participant can be called in its text."""


def mermaid(diagram: SequenceDiagram) -> str:
    """The diagram as Mermaid's text; it ends with a newline."""
    return "\n".join([*_lines(diagram), ""])


def _lines(diagram: SequenceDiagram) -> Iterator[str]:
    yield "---"
    yield f"title: {_quoted(diagram.title)}"
    yield "---"
    yield "sequenceDiagram"
    names = {line.name: _called(line.name, number) for number, line in enumerate(diagram.lifelines)}
    for line in diagram.lifelines:
        shown = f"{_clean(line.name)}<br/>{_clean(line.role)}" if line.role else _clean(line.name)
        yield f"  participant {names[line.name]} as {shown}"
    several = len(diagram.conversations) > 1
    for row in diagram.rows:
        where = f" · {_clean(row.conversation)}" if several and row.conversation else ""
        if isinstance(row, Mark):
            yield f"  Note over {names[row.agent]}: {seconds(row.moment)} {_clean(row.text)}{where}"
            continue
        yield from _said(row, names, where)
    for text in diagram.remarks:
        yield f"  %% {_clean(text)}"


def _said(row: Arrow, names: dict[str, str], where: str) -> Iterator[str]:
    line = "-->>" if row.performative in DECLINING else "->>"
    content = f" ({_clean(row.content)})" if row.content else ""
    text = f"{seconds(row.moment)} {_clean(row.text)}"
    if not row.receivers:
        yield f"  Note over {names[row.sender]}: {text}{content} to nobody{where}"
    for number, name in enumerate(row.receivers):
        # What it contains is said once, where it goes to several.
        more = f"{content}{where}" if number == 0 else ""
        yield f"  {names[row.sender]}{line}{names[name]}: {text}{more}"


def _called(name: str, number: int) -> str:
    """What an agent is called inside the text."""
    return name if _WORDS.fullmatch(name) and name.lower() not in _RESERVED else f"agent_{number + 1}"


def _clean(text: str) -> str:
    return text.translate(_ENTITIES)


def _quoted(text: str) -> str:
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'


__all__ = ["mermaid"]
