"""Marks: how a state shows its type, that it came from a protocol, and that it is closed."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from aseme_dsl.amola.statechart import State, StateType, transition_text
from aseme_dsl.diagrams.look import style
from aseme_dsl.diagrams.look.dot import Attributes
from aseme_dsl.diagrams.look.labels import Cell, Html, escaped, font, table, wrapped
from aseme_dsl.diagrams.look.tips import inside_text
from aseme_dsl.diagrams.look.view import View, Way

NAME_WIDTH = 34
"""Characters in a line of a state's name."""

NAME_LINES = 4
"""A name of more lines is cut; the tip has all of it."""

FILLS = {
    StateType.OR: style.OR_COLOUR,
    StateType.AND: style.AND_COLOUR,
    StateType.BASIC: style.BASIC_COLOUR,
}

Label = tuple[dict[str, str], tuple[str, ...]]
"""The attributes that label something, and the lines of text they show."""


def state_id(label: str) -> str:
    """The id that a state has in every drawing and in the SVG."""
    return f"n{label}"


def class_of(node: State) -> dict[str, str]:
    """The SVG class of a state: `state` and its type."""
    return {"class": f"state {node.type.value}"}


def protocol_border(view: View, node: State) -> dict[str, str]:
    """The border of what came from a protocol."""
    return {"color": style.PROTOCOL_COLOUR, "penwidth": "1.8"} if view.is_from_protocol(node.label) else {}


def small(text: str, ink: str = style.PALE_INK) -> Cell:
    """A line of small print."""
    return Cell((text,), size=style.SMALL_SIZE, ink=ink, align="CENTER")


def name_lines(node: State, width: int = NAME_WIDTH) -> tuple[str, ...]:
    """The lines of a state's name; a label is never broken."""
    return (node.name,) if node.name == node.label else wrapped(node.name, width, NAME_LINES)


def branch_mark(view: View, node: State) -> list[Cell]:
    """`«attack.center»` on the first state of a protocol's branch."""
    branch = view.branch(node.label)
    return [] if branch is None else [small(f"«{branch}»", style.PROTOCOL_COLOUR)]


def closed_marks(view: View, node: State, links: Mapping[str, str]) -> tuple[list[Cell], dict[str, str]]:
    """What a closed state says of its inside, and how it looks; nothing for any other state."""
    if node.label not in view.closed:
        return [], {}
    cells = [small(inside_text(view.closed[node.label]))]
    look = {"peripheries": "2"}
    if node.label in links:
        cells.append(small(links[node.label]))
        look["URL"] = links[node.label]
    return cells, look


def cells_label(cells: list[Cell]) -> Label:
    """The label of a box: plain if it is only a plain name, else a small table."""
    lines = tuple(line for cell in cells for line in cell.lines)
    if len(cells) == 1 and cells[0].size == style.TEXT_SIZE and not cells[0].bold:
        return {"label": "\n".join(lines)}, lines
    return {"label": table([[cell] for cell in cells], cell_border=0, padding=1)}, lines


def way_label(numbers: Mapping[int, int], way: Way, inline_width: int | None) -> Label:
    """The label of a transition: its number, else its expression in lines of `inline_width`, else nothing."""
    if way.place in numbers:
        number = numbers[way.place]
        return {"label": number_label(number)}, (str(number),)
    text = transition_text(way.transition)
    if inline_width is None or not text:
        return {}, ()
    lines = wrapped(text, inline_width)
    content = "".join(f'{escaped(line)}<BR ALIGN="LEFT"/>' for line in lines)
    return {"label": _padded(font(content, size=style.SMALL_SIZE))}, lines


def way_look(way: Way) -> dict[str, str]:
    """How the line of a transition looks: thick where it cuts its source short."""
    return {"penwidth": "2.2"} if way.transition.first else {}


Staying = Mapping[str, Sequence[tuple[str, ...]]]
"""For each state the lines of text of what is done in it, and when it is left."""


def staying(view: View, numbers: Mapping[int, int], inline_width: int | None) -> Staying:
    """What states say of the transitions that lead nowhere: the word and the number, or all of it."""
    found: dict[str, list[tuple[str, ...]]] = {}
    for way in view.ways:
        if not way.transition.changes_state:
            if way.place in numbers:
                lines: tuple[str, ...] = (f"{way.transition.kind.value} {numbers[way.place]}",)
            elif inline_width is not None:
                lines = wrapped(transition_text(way.transition), inline_width)
            else:
                lines = (way.transition.kind.value,)
            found.setdefault(way.source, []).append(lines)
    return found


def staying_marks(node: State, staying: Staying) -> list[Cell]:
    """The cells of a state for what is done in it, and when it is left."""
    return [
        Cell(lines, size=style.SMALL_SIZE, ink=style.NUMBER_COLOUR) for lines in staying.get(node.label, ())
    ]


def number_label(number: int) -> Html:
    """The number that stands for a transition's expression."""
    return _padded(font(str(number), colour=style.NUMBER_COLOUR, bold=True))


def _padded(content: str) -> Html:
    return Html(f'<TABLE BORDER="0" CELLBORDER="0" CELLPADDING="2"><TR><TD>{content}</TD></TR></TABLE>')


def outside_mark(view: View, way: Way, box_id: str) -> tuple[str, Attributes, tuple[str, ...]]:
    """The id, look and text of the mark for an end of a transition that the view does not show."""
    label = way.transition.source if way.source_outside else way.transition.target
    words = f"from {label}" if way.source_outside else f"to {label}"
    node = view.chart.node(label)
    lines = (words,) if node.name == label else (words, *name_lines(node))
    if way.target_outside and way.transition.into:
        lines = (*lines, *wrapped(f"at {', '.join(way.transition.into)}", NAME_WIDTH))
    look = {
        "style": "dashed",
        "color": style.PALE_INK,
        "fontcolor": style.PALE_INK,
        "fontsize": str(style.SMALL_SIZE),
        "label": "\n".join(lines),
    }
    return box_id, look, lines
