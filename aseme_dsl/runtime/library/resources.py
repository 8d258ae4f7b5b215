"""A line of requests for a resource as a text: what the functions of `resources` do.

Each line of the text is a request as JSON: the number of its place at the keeper, its priority, and whether
it has a unit. The lines are in the order of service.
"""

from __future__ import annotations

import json


def lined_up(line: str, place: int, priority: int, stays: bool, capacity: int) -> str:
    """The line once a request has come, behind those of its priority, or gone; free units are given out."""
    found = [item for item in _read(line) if item[0] != place]
    if stays:
        before = [item for item in found if item[2] or item[1] >= priority]
        found = [*before, (place, priority, False), *(item for item in found if item not in before)]
    return _given_out(found, capacity)


def given_out(line: str, capacity: int) -> str:
    """The line in which all units that are free have been given out."""
    return _given_out(_read(line), capacity)


def stands_in(line: str, place: int) -> bool:
    """Whether the line has a request of this place."""
    return any(item[0] == place for item in _read(line))


def has_unit(line: str, place: int) -> bool:
    """Whether the request of this place has a unit."""
    return any(item[0] == place and item[2] for item in _read(line))


def units_held(line: str) -> int:
    """How many units are given out."""
    return sum(held for _, _, held in _read(line))


def waiting_for(line: str) -> int:
    """How many requests wait."""
    return sum(not held for _, _, held in _read(line))


def keeper_called(name: str) -> str | None:
    """The agent of this name; None if the name is empty."""
    return name or None


_Request = tuple[int, int, bool]


def _given_out(found: list[_Request], capacity: int) -> str:
    free = capacity - sum(held for _, _, held in found)
    lines = []
    for place, priority, held in found:
        if not held and free > 0:
            held, free = True, free - 1
        lines.append(json.dumps((place, priority, held)))
    return "\n".join(lines)


def _read(line: str) -> list[_Request]:
    return [
        (int(place), int(priority), bool(held))
        for place, priority, held in map(json.loads, line.splitlines())
    ]
