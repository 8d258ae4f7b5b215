"""Groups: of many agents of one role, one lifeline; and of what many of them say, one arrow."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import groupby

from aseme_dsl.diagrams.sequence.sequence import Arrow, Lifeline, Mark, Row, SequenceDiagram, seconds
from aseme_dsl.records import dataclass

MOST = 12
"""A diagram with more lifelines is drawn with groups."""
_LEAST = 3
"""Fewer agents stay apart."""
_NUMBERED = re.compile(r"(.*?)(\d+)")


@dataclass(frozen=True, slots=True)
class _Group:
    """Agents of one role, and the name of their lifeline."""

    name: str
    members: tuple[str, ...]


def grouped(diagram: SequenceDiagram, most: int = MOST) -> SequenceDiagram:
    """The diagram with groups instead of agents, the largest first, until it has at most so many lifelines.

    What one of a group does has its name; equal messages of several that follow each other are one arrow.
    """
    groups: list[_Group] = []
    count = len(diagram.lifelines)
    for role, members in sorted(_roles(diagram).items(), key=lambda item: -len(item[1])):
        if count > most and len(members) >= _LEAST:
            groups.append(_Group(_called(role, members), members))
            count -= len(members) - 1
    if not groups:
        return diagram
    of = {member: group for group in groups for member in group.members}
    lifelines: dict[str, Lifeline] = {}
    for line in diagram.lifelines:
        name = of[line.name].name if line.name in of else line.name
        if name not in lifelines:
            lifelines[name] = _lifeline(line, of, diagram)
    rows = tuple(_merged([_in_groups(row, of) for row in diagram.rows]))
    return replace(diagram, lifelines=tuple(lifelines.values()), rows=rows)


def _roles(diagram: SequenceDiagram) -> Mapping[str, tuple[str, ...]]:
    """The agents of each role."""
    found: dict[str, tuple[str, ...]] = {}
    for line in diagram.lifelines:
        role = line.role.partition(":")[0]
        found[role] = (*found.get(role, ()), line.name)
    return found


def _called(role: str, members: Sequence[str]) -> str:
    """`worker[1..38]`, `worker[1..3, 7]`, or `cook × 3` where the names do not end with numbers."""
    parts = [_NUMBERED.fullmatch(name) for name in members]
    stems = {part[1] for part in parts if part is not None}
    if None in parts or len(stems) != 1:
        return f"{role} × {len(members)}"
    numbers = sorted(int(part[2]) for part in parts if part is not None)
    runs = [
        [number for _, number in run]
        for _, run in groupby(enumerate(numbers), lambda item: item[1] - item[0])
    ]
    ranges = [f"{run[0]}..{run[-1]}" if len(run) > 1 else str(run[0]) for run in runs]
    if len(ranges) > _LEAST:
        ranges = [ranges[0], "…", ranges[-1]]
    return f"{stems.pop()}[{', '.join(ranges)}]"


def _lifeline(line: Lifeline, of: Mapping[str, _Group], diagram: SequenceDiagram) -> Lifeline:
    """The lifeline of a group, with all parts that its members take, or the agent's own."""
    if line.name not in of:
        return line
    group = of[line.name]
    roles = [item.role.partition(": ") for item in diagram.lifelines if item.name in group.members]
    parts = dict.fromkeys(part for _, _, said in roles for part in said.split(", ") if part)
    role = f"{len(group.members)} agents, {roles[0][0]}" + (f": {', '.join(parts)}" if parts else "")
    return Lifeline(group.name, role, len(group.members))


# ---- rows -----------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class _Grouped:
    """A row between lifelines; `who` says which of a group, and is empty if there is no group in it.

    `one` says that it is about one agent of each group.
    """

    row: Row
    who: str = ""
    one: bool = False


def _in_groups(row: Row, of: Mapping[str, _Group]) -> _Grouped:
    if isinstance(row, Mark):
        group = of.get(row.agent)
        if group is None:
            return _Grouped(row)
        return _Grouped(replace(row, agent=group.name, ends=False), row.agent, one=True)
    sender = of[row.sender].name if row.sender in of else row.sender
    receivers = tuple(dict.fromkeys(of[name].name if name in of else name for name in row.receivers))
    said = [row.sender] if row.sender in of else []
    one = True
    for group in dict.fromkeys(of[name] for name in row.receivers if name in of):
        names = [name for name in row.receivers if name in group.members]
        one = one and len(names) == 1
        if len(names) == len(group.members):
            said.append("to all")
        else:
            said.append(f"to {names[0]}" if len(names) == 1 else f"to {len(names)} of {len(group.members)}")
    return _Grouped(replace(row, sender=sender, receivers=receivers), " ".join(said), bool(said) and one)


def _merged(rows: Sequence[_Grouped]) -> Iterator[Row]:
    """The rows, with one for those of a stretch that say the same."""
    for stretch in _stretches(rows):
        kinds: dict[tuple[str, str], list[_Grouped]] = {}
        for item in stretch:
            kinds.setdefault(_kind(item.row), []).append(item)
        for found in kinds.values():
            yield _named(found[0]) if len(found) == 1 else _of_several(found)


def _stretches(rows: Sequence[_Grouped]) -> Iterator[Sequence[_Grouped]]:
    """Rows that follow each other, of the same lifelines, and each about another one of a group."""
    stretch: list[_Grouped] = []
    for item in rows:
        goes_on = stretch and item.one and stretch[-1].one and _ends(item.row) == _ends(stretch[-1].row)
        if stretch and (not goes_on or item.who in {other.who for other in stretch}):
            yield stretch
            stretch = []
        stretch.append(item)
    if stretch:
        yield stretch


def _ends(row: Row) -> tuple[object, ...]:
    return (row.agent,) if isinstance(row, Mark) else (row.sender, row.receivers)


def _kind(row: Row) -> tuple[str, str]:
    return (row.text, "") if isinstance(row, Mark) else (row.performative, row.message)


def _named(item: _Grouped) -> Row:
    """A row with the name of who of a group it is about."""
    row = item.row
    if not item.who:
        return row
    if isinstance(row, Mark):
        return replace(row, text=f"{item.who}: {row.text}")
    return replace(row, content=": ".join(filter(None, (item.who, row.content))))


def _of_several(items: Sequence[_Grouped]) -> Row:
    first, last = items[0].row, items[-1].row
    count = f"× {len(items)}"
    if seconds(first.moment) != seconds(last.moment):
        count += f" until {seconds(last.moment)}"
    conversations = {item.row.conversation for item in items}
    conversation = first.conversation if len(conversations) == 1 else f"{len(conversations)} conversations"
    if isinstance(first, Mark):
        return replace(first, text=f"{first.text} ({count})", conversation=conversation)
    contents = {item.row.content for item in items if isinstance(item.row, Arrow)}
    content = ": ".join(filter(None, (count, first.content if len(contents) == 1 else "")))
    whole = "\n".join(
        f"{seconds(item.row.moment)}  {item.who} {item.row.whole}".rstrip()
        for item in items
        if isinstance(item.row, Arrow)
    )
    return replace(first, content=content, whole=f"\n{whole}", conversation=conversation)


__all__ = ["MOST", "grouped"]
