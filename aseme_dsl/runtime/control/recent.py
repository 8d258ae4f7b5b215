"""Recent records: the last ones of a run that an operator looks for, and how many there were of each kind."""

from __future__ import annotations

import json
import threading
import time
from collections import Counter, deque

from aseme_dsl.records import dataclass
from aseme_dsl.runtime.trace.records import Record

MOST = 1000
"""So many records are kept; older ones are in the trace."""
LARGEST = 2000
"""A record of more characters is kept without its larger members."""
SHORT = 200
"""A member of a record that is too large is kept up to so many characters."""
MOST_ASKED = 200
"""A reply has at most so many records,"""
MOST_CHARACTERS = 200_000
"""and about so many characters."""

KINDS = frozenset(
    (
        *("fault", "error", "breach", "life", "lost", "refused", "dropped", "unexpected", "unsent"),
        *("overload", "gap", "swap", "select"),
    )
)
"""The kinds of which all records are kept."""
SOME = {
    "peer": None,
    "control": frozenset({"refused"}),
    "conversation": frozenset({"gone", "back"}),
    "activity": frozenset({"crash", "late"}),
    "module": frozenset({"crash"}),
}
"""The kinds of which some are kept: those with these `what`; None: all."""
_LARGE = ("plan", "sources", "configuration", "content", "message", "traceback")


@dataclass(frozen=True, slots=True)
class Kept:
    """A record with its number, from 1, and when it was written (s since 1970 by the machine's clock)."""

    number: int
    at: float
    record: dict[str, object]
    size: int


class Recent:
    """Keeps the last records of a run. A listener of its trace; may be used from any thread."""

    def __init__(self) -> None:
        self._kept: deque[Kept] = deque(maxlen=MOST)
        self._lock = threading.Lock()
        self._number = 0
        self._counts: Counter[str] = Counter()

    def wants(self, kind: str, what: str | None) -> bool:
        """Whether such records are kept."""
        if kind in KINDS:
            return True
        some = SOME.get(kind, frozenset())
        return some is None or what in some

    def __call__(self, record: Record) -> None:
        """Keep a record."""
        kept, size = _fitting(dict(record))
        with self._lock:
            self._number += 1
            self._counts[_kind(record)] += 1
            self._kept.append(Kept(self._number, time.time(), kept, size))

    @property
    def number(self) -> int:
        """The number of the newest record; 0 if there is none."""
        return self._number

    def counts(self) -> dict[str, int]:
        """How many records there were of each kind; of a kind with `what`, as `peer.gone`."""
        with self._lock:
            return dict(sorted(self._counts.items()))

    def after(self, number: int, most: int = MOST_ASKED) -> tuple[list[Kept], int]:
        """The first records after a number, and how many of those there are no more.

        A negative number counts from the end: -20 gives the last 20.
        """
        with self._lock:
            first = max(0, self._number + number) if number < 0 else number
            found: list[Kept] = []
            size = 0
            for kept in self._kept:
                if kept.number <= first:
                    continue
                size += kept.size
                if len(found) >= min(most, MOST_ASKED) or (found and size > MOST_CHARACTERS):
                    break
                found.append(kept)
            oldest = self._kept[0].number if self._kept else self._number + 1
            return found, max(0, min(oldest, self._number + 1) - 1 - first)


def _kind(record: Record) -> str:
    what = record.get("what")
    return record["kind"] if what is None else f"{record['kind']}.{what}"


def _fitting(record: dict[str, object]) -> tuple[dict[str, object], int]:
    """The record, which is JSON, without what makes it too large, and its length as a text."""
    if record["kind"] == "swap":
        record.pop("plan", None)  # of a `select`, it is a name
    record.pop("sources", None)
    size = len(json.dumps(record))
    if size <= LARGEST:
        return record, size
    short: dict[str, object] = {}
    for name, value in record.items():
        if isinstance(value, str):
            short[name] = value if len(value) <= SHORT else f"{value[: SHORT - 1]}…"
        elif isinstance(value, list) and name == "reasons":
            short[name] = [str(text)[:SHORT] for text in value[:5]]
        elif isinstance(value, list | dict):
            if name not in _LARGE and len(json.dumps(value)) <= SHORT:
                short[name] = value
        else:
            short[name] = value
    return short, len(json.dumps(short))


__all__ = ["KINDS", "MOST", "MOST_ASKED", "SOME", "Kept", "Recent"]
