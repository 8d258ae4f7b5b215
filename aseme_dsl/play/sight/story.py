"""Story: what happened to agents, as lines for people."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence

from aseme_dsl.records import dataclass
from aseme_dsl.runtime.time.clock import readable

_WIDEST = 24
"""So wide (characters) the column of the names may be."""


@dataclass(frozen=True, slots=True)
class Happened:
    """Something that happened to an agent, so many times by now. `at` is the place in the source.

    If the agent has sent a message, `sent` says which, `to` has the receivers, and `number` is that of the
    message. `peer` has sent what the agent receives.
    """

    moment: int
    agent: str
    text: str
    at: str = ""
    sent: str = ""
    to: tuple[str, ...] = ()
    number: int = 0
    peer: str = ""
    is_step: bool = False
    """Whether it is known only inside of the agent: a step, the end of an activity."""
    stands: bool = False
    """Whether it says where the agent is at the end."""
    times: int = 1
    label: str = ""
    """The state that it is about."""
    details: tuple[str, ...] = ()
    """What explains it, as further lines."""

    @property
    def line(self) -> str:
        """What happened, and where it stands in the source."""
        often = f", the {_ordinal(self.times)} time" if self.times > 1 else ""
        return f"{self.text}{f' ({self.at})' if self.at else ''}{often}"


def told(story: Iterable[Happened]) -> Iterator[str]:
    """A story as lines, with the times and names in columns. What several agents do alike is one line."""
    rows = [(readable(items[0].moment), _together(items), items[0]) for items in _folded(story)]
    wide = max((len(time) for time, _, item in rows if not item.stands), default=0)
    names = min(_WIDEST, max((len(name) for _, name, _ in rows), default=0))
    has_ended = False
    explained: set[tuple[str, str, tuple[str, ...]]] = set()
    for time, name, item in rows:
        if item.stands and not has_ended:
            has_ended = True
            yield f"then, at {time}:"
        lead = f"{'' if item.stands else time:>{wide}}  {name:<{names}}  "
        each = "each: " if "[" in name or "," in name else ""
        yield f"{lead}{each}{item.line}"
        if (key := (name, item.text, item.details)) not in explained:  # each thing is explained once
            explained.add(key)
            yield from (f"{' ' * (wide + names + 4)}  {detail}" for detail in item.details)


def _folded(story: Iterable[Happened]) -> list[list[Happened]]:
    """The same of several agents at one moment stands together, where the first of them stands."""
    found: dict[tuple[object, ...], list[Happened]] = {}
    for item in story:
        key = (item.moment, item.line, item.details, item.to, item.stands)
        beside = found.setdefault(key, [])
        if any(other.agent == item.agent for other in beside):
            found[*key, len(found)] = [item]
        else:
            beside.append(item)
    return list(found.values())


def _together(items: Sequence[Happened]) -> str:
    return agents_text([item.agent for item in items])


def agents_text(names: Sequence[str]) -> str:
    """Agents together: `bob`, `ann, bob`, or those of a range as a file writes it, `carrier[2..5]`."""
    groups: list[list[tuple[str, int | None]]] = []
    for name in names:
        found = re.fullmatch(r"(.*\D)(\d+)", name)
        stem, number = (found[1], int(found[2])) if found is not None else (name, None)
        last = groups[-1][-1] if groups else ("", None)
        if number is not None and last == (stem, number - 1):
            groups[-1].append((stem, number))
        else:
            groups.append([(stem, number)])
    texts = []
    for group in groups:
        if len(group) > 2:
            texts.append(f"{group[0][0]}[{group[0][1]}..{group[-1][1]}]")
        else:
            texts += [f"{stem}{'' if number is None else number}" for stem, number in group]
    return ", ".join(texts)


def _ordinal(number: int) -> str:
    ending = "th" if number % 100 in (11, 12, 13) else {1: "st", 2: "nd", 3: "rd"}.get(number % 10, "th")
    return f"{number}{ending}"


__all__ = ["Happened", "agents_text", "told"]
