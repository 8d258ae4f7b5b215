"""Decisions: the conditions of transitions in parts, and which parts were shown to decide (MC/DC).

A part holds, with its negation, or it does not: it is false then, or absent.

An evaluation notes for each part whether it held (`T`), did not (`F`), or was not asked (`-`), and then the
result: `TF-F`. Two evaluations show that a part decides if their results differ, and if it is the only part
that differs of those that both have asked.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator

from aseme_dsl.amola.expression import Value, value_text
from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.play.conditions import normal_form, parts_of
from aseme_dsl.records import dataclass

HELD, NOT_HELD, NOT_ASKED = "TF-"


@dataclass(frozen=True, slots=True)
class Decision:
    """The condition of a transition, by the transition's number, with its parts from left to right."""

    transition: int
    condition: Value
    parts: tuple[Value, ...]

    @property
    def texts(self) -> tuple[str, ...]:
        return tuple(value_text(part) for part in self.parts)


def decisions_of(chart: Statechart) -> Iterator[Decision]:
    """The decisions of a statechart, but for those of random choices, and what the compiler adds to them."""
    for number, item in enumerate(chart.transitions):
        condition = item.expression.condition
        if condition is not None and item.expression.draw is None and not item.reactive:
            normal = normal_form(condition)
            yield Decision(number, normal, tuple(parts_of(normal)))


def deciding(evaluations: Collection[str], count: int) -> frozenset[int]:
    """The numbers of those of `count` parts that these evaluations have shown to decide."""
    held = [item for item in evaluations if item[-1] == HELD]
    failed = [item for item in evaluations if item[-1] == NOT_HELD]
    found: set[int] = set()
    for one in held:
        for other in failed:
            differ = [
                place
                for place in range(count)
                if NOT_ASKED not in (one[place], other[place]) and one[place] != other[place]
            ]
            if len(differ) == 1:
                found.add(differ[0])
    return frozenset(found)


__all__ = ["HELD", "NOT_ASKED", "NOT_HELD", "Decision", "deciding", "decisions_of"]
