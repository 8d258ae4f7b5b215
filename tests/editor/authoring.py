"""A text with the cursor at `‸`, as somebody has it in an editor, and what the editor offers there."""

from __future__ import annotations

from aseme_dsl.editor.files.known import Known, known_in
from aseme_dsl.editor.files.view import View
from aseme_dsl.editor.files.workspace import Workspace
from aseme_dsl.editor.typing.completion import complete
from aseme_dsl.editor.typing.items import Item
from aseme_dsl.editor.typing.snippets import filled
from aseme_dsl.source import Source

CURSOR = "‸"
PATH = "/nowhere/team.aseme"


def opened(text: str, path: str = PATH) -> View:
    """The view of a text that an editor has open."""
    workspace = Workspace()
    workspace.open(path, text)
    view = workspace.view(path)
    assert view is not None
    return view


def offered(marked: str, path: str = PATH, known: Known | None = None) -> tuple[Item, ...]:
    """The items at the cursor, of what the text with the cursor in it says of the system."""
    offset = marked.index(CURSOR)
    text = marked.replace(CURSOR, "")
    return complete(Source(path, text), offset, known or known_in(opened(text, path)))


def labels(marked: str, path: str = PATH) -> list[str]:
    """The labels of what is offered, the likeliest first."""
    return [item.label for item in offered(marked, path)]


def accepted(text: str, item: Item) -> str:
    """The text after the item was accepted, with the examples of its snippet."""
    new = filled(item.insert) if item.is_snippet else item.insert
    return text[: item.start] + new + text[item.end :]


def listed(items: tuple[Item, ...]) -> str:
    """Items as a table for people: label, kind, detail, and what is written if it is not the label."""
    rows = []
    for item in items:
        written = "" if item.insert == item.label else "→ " + item.insert.replace("\n", "⏎")
        rows.append(f"{item.label:<28}  {item.kind:<13}  {item.detail:<44}  {written}".rstrip())
    return "\n".join(rows) + "\n"
