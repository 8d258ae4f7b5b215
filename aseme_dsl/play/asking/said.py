"""Said: what an answer says, as lines with lines inside."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from aseme_dsl.play.asking.names import named
from aseme_dsl.play.asking.past import Past
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.time.clock import shown


@dataclass(frozen=True, slots=True)
class Said:
    """A line of an answer, and what explains it."""

    text: str
    inside: tuple[Said, ...] = ()


Back = Callable[[str, str], tuple[Said, ...]]
"""Says why another agent did not publish on a channel, or send an agent message."""


def where(past: Past, agent: str, near: Iterable[str], *, beside: bool = False) -> str:
    """In which state an agent is, of those that are active at once the nearest to others, as a phrase."""
    member = past.members[agent]
    if member.over:
        return f"has stopped: {member.over}"
    plan = past.plan(agent)
    place = past.place(agent)
    if plan is None or not place:
        return "has not started"
    wanted = tuple(near)
    leaves = [leaf for leaf in place if plan.by_label[leaf].type != "AND"]
    leaves.sort(key=lambda leaf: -max((_common(leaf, label) for label in wanted), default=0))
    first, *others = leaves
    since = past.began(agent, first)
    told = f"is in {named(plan, first)}{'' if since is None else f' since {shown(since)}'}"
    names = [named(plan, leaf) for leaf in others if plan.by_label[leaf].type == "BASIC"]
    return f"{told}, beside {', '.join(names)}" if names and beside else told


def _common(one: str, other: str) -> int:
    """How many states are around both."""
    pairs = zip(one.split("."), other.split("."), strict=False)
    return next((place for place, (first, second) in enumerate(pairs) if first != second), len(other))


__all__ = ["Back", "Said", "where"]
