"""Logs: the recent records of all agents, in the order of their times."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from aseme_dsl.project.operating.whole_team import Silent, name_of
from aseme_dsl.project.playing.operate import Endpoint, ask_each, running_from
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.control.recent import MOST_ASKED

if TYPE_CHECKING:
    from aseme_dsl.project.playing.remote import Robot


@dataclass(frozen=True, slots=True)
class Line:
    """A record of a process, which is named by its agent; `at` is the time there, in s since 1970."""

    process: str
    number: int
    at: float
    record: dict[str, object]


@dataclass(frozen=True, slots=True)
class Lines:
    """The records in the order of their times; how many are missing, by process; and what does not answer."""

    lines: tuple[Line, ...]
    missed: dict[str, int]
    silent: tuple[Silent, ...]


class Logs:
    """Asks for the recent records again and again, each time for those that are new."""

    def __init__(self, output: Path, robots: Sequence[Robot] | None = None, last: int = MOST_ASKED) -> None:
        """Of the records that there are, the `last` of each process."""
        self._output = output
        self._robots = robots
        self._last = min(max(last, 1), MOST_ASKED)
        self._after: dict[str, int] = {}

    def new(self, seconds: float = 5.0) -> Lines:
        """What is new. It takes `seconds` at most.

        Raises:
            OperateError: nothing runs.
        """
        found: Sequence[Endpoint] = running_from(self._output) if self._robots is None else self._robots
        asked = {
            endpoint: {
                "request": "logs",
                "after": self._after.get(str(endpoint), -self._last),
                "most": MOST_ASKED,
            }
            for endpoint in found
        }
        lines: list[Line] = []
        missed: dict[str, int] = {}
        silent: list[Silent] = []
        for endpoint, reply in ask_each(asked, seconds).items():
            name = name_of(endpoint)
            if not reply["ok"]:
                silent.append(Silent(name, reply["reasons"][0]))
                continue
            first = str(endpoint) not in self._after
            after = reply["next"]
            if not first and after < self._after[str(endpoint)]:  # another incarnation counts from 1
                after = 0
            self._after[str(endpoint)] = after
            if reply["missed"] and not first:
                missed[name] = reply["missed"]
            lines += [Line(name, x["number"], x["at"], x["record"]) for x in reply["records"]]
        return Lines(tuple(sorted(lines, key=lambda line: line.at)), missed, tuple(silent))


def as_data(line: Line) -> dict[str, object]:
    """A record as JSON, as docs/reference/team-json.md describes it."""
    return {"process": line.process, "number": line.number, "at": line.at, "record": line.record}


__all__ = ["Line", "Lines", "Logs", "as_data"]
