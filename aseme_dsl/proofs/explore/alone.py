"""Alone: one agent of a team, to which everything may come that any agent, itself included, may send."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import field

from aseme_dsl.proofs.explore.deciding.choosing import Choices
from aseme_dsl.proofs.explore.surroundings import NOW
from aseme_dsl.proofs.timed.stamp import stamp, standing
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.plan import ChannelInfo, Plan
from aseme_dsl.runtime.time.clock import shown

Path = tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Alone:
    """What comes to the agent.

    `kept` are channels with states of which it matters when a message was sent. Each message comes between
    the two times of `delay` (ns) after that; None: at any time.
    """

    kept: frozenset[str] = frozenset()
    delay: tuple[int, int | None] = (0, None)
    own: frozenset[str] = frozenset()
    """The channels on which the agent may publish itself."""
    members: Mapping[str, frozenset[Path]] = field(default_factory=dict)
    """Which members of messages on these channels matter later; the others may be otherwise at each look."""
    fixed: Mapping[str, Mapping[Path, object]] = field(default_factory=dict)
    """What members of messages hold on a channel."""


@dataclass(frozen=True, slots=True)
class Sent:
    """When a message that comes now was sent: between `least` and `most` ns ago, as the clock `origin`."""

    origin: int
    least: int
    most: int | None


@dataclass(frozen=True, slots=True)
class _Age:
    least: int
    most: int | None

    def __str__(self) -> str:
        return shown(self.least)


def reads_of(plan: Plan) -> frozenset[str]:
    """The channels that a role reads."""
    return frozenset(channel for region in plan.regions for channel in region.reads)


def fixed_in(reads: Iterable[tuple[str, Mapping[Path, object]]]) -> dict[tuple[str, Path], frozenset[object]]:
    """The members of types of messages of which it is known what they hold, with all that they do.

    `reads` are channels that agents read, with what is known of messages there.
    """
    of_type: dict[str, list[Mapping[Path, object]]] = {}
    for channel, known in reads:
        of_type.setdefault(channel.rpartition(".")[2], []).append(known)
    return {
        (kind, path): frozenset(other[path] for other in held)
        for kind, held in of_type.items()
        for path in held[0]
        if all(path in other for other in held)
    }


def measured(
    rule: ChannelInfo | None, alone: Alone, moved: int, ages: tuple[int, ...], choices: Choices
) -> tuple[int, bool, Sent | None]:
    """When a message that comes in the move `moved` counts as sent, and whether it is the agent's own.

    The third item says when it was sent, if that is not when it comes. Conditions ask for the `ages`.
    """
    name = "" if rule is None else rule.name
    if name in alone.own and choices.of(("own", name), (False, True), "its own: {}"):
        return stamp(NOW, moved), True, None
    if rule is not None and rule.radio is not None:
        return stamp(NOW, moved) - rule.delay, False, None
    found = choices.of(("age", name), tuple(_classes(ages, *alone.delay)), "it is {} old when it comes")
    sent = Sent(-moved, max(found.least, alone.delay[0]), _least(found.most, alone.delay[1]))
    return standing(stamp(NOW, -moved), NOW - found.least), False, sent


def _classes(ages: tuple[int, ...], least: int, most: int | None) -> Iterator[_Age]:
    """The ranges between ages within which conditions are the same, as far as messages may have them."""
    limits = (0, *ages)
    for place, begin in enumerate(limits):
        end = limits[place + 1] - 1 if place + 1 < len(limits) else None
        if (most is None or begin <= most) and (end is None or end >= least):
            yield _Age(begin, end)


def _least(one: int | None, other: int | None) -> int | None:
    known = [item for item in (one, other) if item is not None]
    return min(known, default=None)


__all__ = ["Alone", "Sent", "measured"]
