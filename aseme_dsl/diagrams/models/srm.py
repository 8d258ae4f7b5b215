"""The SRM drawing of a role: protocols, formulas, activities and functionalities, as in Figure 4 of P1."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from aseme_dsl.amola.aip import NamedFormula
from aseme_dsl.amola.expression import duration_text
from aseme_dsl.amola.liveness import called, canonical
from aseme_dsl.amola.srm import Activity, Functionality, Srm, Subscription
from aseme_dsl.diagrams.look import style
from aseme_dsl.diagrams.look.dot import Sheet
from aseme_dsl.diagrams.look.labels import Cell, wrapped
from aseme_dsl.diagrams.look.tables import table_sheet

_COLUMNS = 6
_ACROSS = 110
_WIDTH = 34

_Rows = list[list[Cell]]


def sheet(srm: Srm, activities: Sequence[Activity | None], name: str) -> Sheet:
    """The table of a role and what is said of its activities. Parts that have nothing to say are left out."""
    rows: _Rows = []
    _part(rows, "Includes", [", ".join(srm.includes)] if srm.includes else [])
    _part(rows, "Protocols", [", ".join(item.text for item in srm.plays)] if srm.plays else [])
    _part(rows, "Liveness", (f"{_formula(item)} = {canonical(item.formula)}" for item in srm.formulas))
    _part(rows, "Variables", (item.text for item in srm.variables))
    _part(
        rows,
        "Capabilities",
        (_capability(item.name, item.activities, item.description) for item in srm.capabilities),
    )
    _table(
        rows,
        ("Activity", "Functionality", "Every", "Takes", "Reads", "Writes"),
        [_activity(name, said) for name, said in zip(srm.activities, activities, strict=True)],
    )
    _table(
        rows,
        ("Module", "Functionality", "Every", "Takes", "Reads", "Writes"),
        [_activity(item.name, item.statement) for item in srm.modules],
    )
    _table(
        rows,
        ("Functionality", "Technology", "Permissions", "Environment", "Algorithm"),
        [_functionality(item) for item in srm.functionalities],
    )
    return table_sheet(name, name, Cell((f"Role {srm.name}",)), rows, f"Role {srm.name}")


def _part(rows: _Rows, title: str, texts: Iterable[str]) -> None:
    lines = tuple(line for text in texts for line in wrapped(text, _ACROSS))
    if lines:
        rows.append([Cell((title,), _COLUMNS, bold=True, colour=style.HEAD_COLOUR)])
        rows.append([Cell(lines, _COLUMNS)])


def _table(rows: _Rows, titles: Sequence[str], items: Sequence[Sequence[Sequence[str]]]) -> None:
    """Rows of one kind under their titles, without those that nothing is said of.

    The last column takes what is left of the table's columns.
    """
    if not items:
        return
    said = [number for number in range(len(titles)) if number == 0 or any(item[number] for item in items)]
    titles = [titles[number] for number in said]
    items = [[item[number] for number in said] for item in items]
    last = _COLUMNS - len(titles) + 1

    def row(cells: Sequence[Sequence[str]], *, bold: bool = False, colour: str = "") -> None:
        lines = [tuple(line for text in cell for line in wrapped(text, _WIDTH)) or ("",) for cell in cells]
        spans = [1] * (len(cells) - 1) + [last]
        rows.append([Cell(text, span, bold, colour) for text, span in zip(lines, spans, strict=True)])

    row([[title] for title in titles], bold=True, colour=style.HEAD_COLOUR)
    for item in items:
        row(item)


def _capability(name: str, activities: Sequence[str], description: str) -> str:
    needs = f": {', '.join(activities)}" if activities else ""
    return f"{name}{needs}{f' ({description})' if description else ''}"


def _activity(name: str, activity: Activity | None) -> list[list[str]]:
    if activity is None:
        return [[name], [], [], [], [], []]
    return [
        [called(name, map(str, activity.parameters)), *_ends(activity)],
        [", ".join(activity.uses)] if activity.uses else [],
        [] if activity.every is None else [duration_text(activity.every)],
        _takes(activity),
        [*map(_subscription, activity.reads), *(f"variable {name}" for name in activity.reads_variables)],
        [*map(str, activity.writes), *(f"variable {name}" for name in activity.writes_variables)],
    ]


def _takes(activity: Activity) -> list[str]:
    parts = [
        *([] if activity.takes is None else [duration_text(activity.takes)]),
        *(["simulated"] if activity.simulated else []),
        *(["waits"] if activity.waits else []),
    ]
    return [", ".join(parts)] if parts else []


def _formula(item: NamedFormula) -> str:
    return called(item.name, map(str, item.parameters))


def _ends(activity: Activity) -> list[str]:
    """Its deadline and its outcomes, below its name."""
    deadline = [f"within {duration_text(activity.within)}"] if activity.within is not None else []
    return deadline + ([f"ends {', '.join(activity.ends)}"] if activity.ends else [])


def _subscription(item: Subscription) -> str:
    """`robot2.vision.data.Ball, last 500ms`, or a whole topic and the part of the tree meant."""
    text = str(item.channel) if item.channel is not None else item.topic
    if item.host:
        text = f"{item.host}.{text}"
    if item.reach != "on":
        text += f" and {item.reach}"
    return f"{text}, last {duration_text(item.history)}" if item.history else text


def _functionality(item: Functionality) -> list[list[str]]:
    texts = (item.name, item.technology, item.permissions, item.environment, item.algorithm)
    return [[text] if text else [] for text in texts]
