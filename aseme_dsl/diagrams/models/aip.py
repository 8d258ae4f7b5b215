"""The AIP drawing of a protocol: its participants side by side, as in Table 1 of P1."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

from aseme_dsl.amola.aip import AgentMessage, Aip, DeclaredVariable, Participant
from aseme_dsl.amola.liveness import canonical
from aseme_dsl.diagrams.look import style
from aseme_dsl.diagrams.look.dot import Sheet
from aseme_dsl.diagrams.look.labels import Cell, wrapped
from aseme_dsl.diagrams.look.tables import table_sheet

_WIDTH = 44
"""Characters in a line of a participant's column."""

_NARROW = 26
"""The same, where there are more than four participants."""


def sheet(aip: Aip, name: str) -> Sheet:
    """The table of a protocol. Rows that say nothing for any participant are left out."""
    people = aip.participants
    width = _WIDTH if len(people) <= 4 else _NARROW
    columns = max(len(people), 1)
    across = width * columns
    rows = [[_head("Participants"), *(_title(person) for person in people)]]

    def row(title: str, texts: Sequence[Iterable[str]]) -> None:
        cells = [Cell(_lines(column, width)) for column in texts]
        if any(cell.lines != ("",) for cell in cells):
            rows.append([_head(title), *cells])

    def wide_row(title: str, texts: Iterable[str]) -> None:
        lines = _lines(texts, across)
        if lines != ("",):
            rows.append([_head(title), Cell(lines, columns)])

    row("Engagement Rules", [person.engage for person in people])
    outcomes = [item.text for item in aip.outcomes]
    wide_row("Outcomes (one of)" if len(outcomes) > 1 else "Outcome", outcomes)
    row("Process", [_formulas(person) for person in people])
    row("Inputs", [(f"{item.name} : {item.type}" for item in person.inputs) for person in people])
    row("Protocols", [(item.text for item in person.plays) for person in people])
    row("Variables", [map(_variable(person), person.variables) for person in people])
    row("Sends", [map(_message, person.sends) for person in people])
    row("Receives", [map(_message, person.receives) for person in people])
    wide_row("Clauses", (clause.text for clause in aip.clauses))
    return table_sheet(name, name, Cell((f"Protocol {aip.name}",)), rows, f"Protocol {aip.name}")


def _head(title: str) -> Cell:
    return Cell((title,), bold=True, colour=style.HEAD_COLOUR)


def _title(person: Participant) -> Cell:
    most = "*" if person.most is None else str(person.most)
    many = "" if (person.least, person.most) == (1, 1) else f" [{person.least}..{most}]"
    return Cell((person.name + many,), bold=True, colour=style.ACTOR["fillcolor"])


def _lines(texts: Iterable[str], width: int) -> tuple[str, ...]:
    return tuple(line for text in texts for line in wrapped(text, width)) or ("",)


def _formulas(person: Participant) -> Iterable[str]:
    """The process, then the helper formulas with their names."""
    for index, item in enumerate(person.formulas):
        text = canonical(item.formula)
        yield f"{item.name} = {text}" if index else text


def _variable(person: Participant) -> Callable[[DeclaredVariable], str]:
    """What a row says of a variable: also whether it is a result."""
    return lambda item: f"result {item.text}" if item.name in person.results else item.text


def _message(message: AgentMessage) -> str:
    by = f" by {' or '.join(message.by)}" if message.by else ""
    return f"{message.performative} {message.message}{by}{' repeatedly' if message.repeatedly else ''}"
