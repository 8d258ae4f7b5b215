"""Faded: what messages say that are too old for anything to ask for it.

A condition such as `age(x.Order) < 1s && x.Order.number == 3` does not look at the order once it is old: what
it says makes no difference from then on, until a new one comes. That is so if each condition that looks at a
message asks for its age, too, in the same `&&`, and nothing else looks at it.
"""

from __future__ import annotations

from collections.abc import Mapping

from aseme_dsl.runtime.chart.plan import Plan


def faded_in(plan: Plan) -> Mapping[str, int]:
    """The channels of which nothing looks into messages that are so old (ns), or older."""
    known = {info.name for info in plan.channels}
    found: dict[str, int] = {}
    open_: set[str] = set()
    conditions = [item.condition for item in plan.transitions]
    for condition in conditions:
        _look(condition, {}, found, open_)
    for part in (part for item in plan.transitions for part in (*item.actions, *item.events)):
        _look(part, {}, found, open_)
    for state in plan.states:
        for _, term in state.arguments:
            _look(term, {}, found, open_)
    return {channel: age for channel, age in found.items() if channel in known and channel not in open_}


def _look(term: object, young: Mapping[str, int], found: dict[str, int], open_: set[str]) -> None:
    """Note what looks into messages, where those on the channels `young` are not older than so (ns)."""
    match term:
        case ("&&", *parts):
            now = dict(young)
            for part in parts:
                match part:
                    case ("<", ("age", ("member", None, str() as channel, ())), ("const", int(age))):
                        now[channel] = min(age, now.get(channel, age))
            for part in parts:
                _look(part, now, found, open_)
        case ("age", ("member", None, str(), ())):
            pass
        case ("member", None, str() as channel, tuple()) if channel in young:
            found[channel] = max(young[channel], found.get(channel, 0))
        case tuple():
            for part in term:
                _look(part, young, found, open_)
        case str():
            open_.add(term)


__all__ = ["faded_in"]
