"""Sending: where a role sends an agent message or publishes on a channel."""

from __future__ import annotations

from collections.abc import Iterator

from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.plan import Plan

Sent = tuple[str, str]
"""What is sent: performative and message; ("", channel): what is published."""


@dataclass(frozen=True, slots=True)
class Place:
    """A place where a role sends something, as it is `called`.

    It is a transition by its number, or the activity of a state; a module runs beside all states.
    """

    label: str
    called: str
    transition: int | None = None
    is_module: bool = False


def sent_of(text: str) -> Sent:
    """What a text names: `inform Done` or a channel, also behind `send` or `publish`."""
    words = text.removeprefix("send ").removeprefix("publish ").split()
    return (words[0], words[1]) if len(words) == 2 else ("", " ".join(words))


def places(plan: Plan, sent: Sent) -> Iterator[Place]:
    """Where a role sends it: activities, modules, then transitions."""
    performative, message = sent
    yield from _in_activities(plan, sent)
    if not performative:
        modules = (item.name for item in plan.modules if message in item.writes)
        yield from (Place(plan.states[0].label, f"the module {name}", is_module=True) for name in modules)
    action = ("send", *sent) if performative else ("publish", message)
    for number, item in enumerate(plan.transitions):
        if any(other[: len(action)] == action for other in item.actions):
            yield Place(item.source, plan.way((number,)), number)


def published(plan: Plan) -> Iterator[str]:
    """The channels on which a role publishes."""
    for item in (*plan.activities, *plan.modules):
        yield from item.writes
    for way in plan.transitions:
        yield from (str(action[1]) for action in way.actions if action[0] == "publish")


def _in_activities(plan: Plan, sent: Sent) -> Iterator[Place]:
    performative, message = sent
    if performative:
        moves = (move for info in plan.branches for move in info.moves if move[:2] == sent)
        labels = [label for _, _, states, _ in moves for label in states]
    else:
        writers = {item.name for item in plan.activities if message in item.writes}
        labels = [state.label for state in plan.states if state.activity in writers]
    yield from (Place(label, plan.called(plan.by_label[label])) for label in labels)


__all__ = ["Place", "Sent", "places", "published", "sent_of"]
