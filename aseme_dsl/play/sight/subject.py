"""Subject: what a broken expectation is about, and what to ask about it next."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import assert_never

from aseme_dsl.play.asking.question import NotAsked, goal_of
from aseme_dsl.play.asking.sending import places, sent_of
from aseme_dsl.play.scenario import (
    AllOf,
    AnyOf,
    Breached,
    Failed,
    Faulty,
    Holds,
    InPlaces,
    NotSo,
    Says,
    Script,
    Untaken,
    all_parts,
)
from aseme_dsl.play.sight.deciding import agents_about
from aseme_dsl.play.sight.storyteller import About
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.plan import Plan, is_in
from aseme_dsl.runtime.monitor.rules import (
    AfterFirst,
    Always,
    At,
    Before,
    InOrder,
    LeadsTo,
    Never,
    NotWithin,
    Rule,
    Sometime,
    State,
    Until,
    conditions_of,
)

Plans = Callable[[str], Plan]
"""Gives what an agent follows."""


@dataclass(frozen=True, slots=True)
class Next:
    """What to ask next: `why` an agent did something, or why not; `what` as these commands take it."""

    agent: str
    what: str
    is_why: bool
    at: int | None = None
    """About which moment (ns); None: the end."""


def spoken(rule: Rule, state: State) -> tuple[int, ...]:
    """The conditions that decide why a rule is broken: of an order the missing part, and the one before."""
    found = conditions_of(rule)
    return found[max(0, state.stage - 1) : state.stage + 1] if isinstance(rule, InOrder) else found


def about(script: Script, rule: Rule, state: State, plans: Plans, since: int | None) -> About:
    """What a story about a broken rule is about; it had come as far as it is at `since`."""
    conditions = script.conditions
    inside: dict[str, frozenset[str]] = {}
    messages: set[str] = set()
    agents: set[str] = set()
    for number in all_parts(conditions, spoken(rule, state)):
        condition = conditions[number]
        match condition:
            case InPlaces(places=labels):
                for name, own in labels.items():
                    inside[name] = inside.get(name, frozenset()) | own
            case Says():
                messages.add(condition.what)
                agents |= condition.agents or _who_say(script, condition, plans)
            case Breached(guarantee=guarantee):
                messages.update(map(str, guarantee.said.channels))
            case _:
                pass
        if not isinstance(condition, Says | AllOf | AnyOf | NotSo):
            agents |= agents_about(conditions, (number,)) or {name for name, _ in script.team}
    return About(frozenset(agents) or None, inside, frozenset(messages), since)


def _who_say(script: Script, says: Says, plans: Plans) -> frozenset[str]:
    """The agents that send a message or, if it is to be received, all."""
    if says.is_received:
        return frozenset(name for name, _ in script.team)
    return frozenset(name for name, _ in script.team if _sends(plans(name), says) is not None)


def _sends(plan: Plan, says: Says) -> str | None:
    """How a question names a message that a role sends; None if it does not."""
    texts = [
        says.what if says.performative is None or " " in says.what else f"{says.performative} {says.what}"
    ]
    if says.is_kind:
        texts += [item.name for item in plan.channels if item.message == says.what]
        sent = {item for info in plan.branches for item in info.sends if item[1] == says.what}
        texts += [f"{act} {kind}" for act, kind in sorted(sent) if says.performative in (None, act)]
    return next((text for text in texts if any(places(plan, sent_of(text)))), None)


def question(script: Script, rule: Rule, state: State, held: Iterable[int], plans: Plans) -> Next | None:
    """What to ask about a broken rule; `held` are the conditions that hold."""
    is_why = False
    match rule:
        case InOrder(conditions=conditions):
            number = conditions[state.stage]
        case Sometime(condition=number) | At(condition=number) | Always(condition=number):
            pass
        case AfterFirst(condition=number) | LeadsTo(second=number) | Until(first=number):
            pass
        case Never(condition=number) | Before(second=number) | NotWithin(condition=number):
            is_why = True
        case _:
            assert_never(rule)
    return _asked(script, number, is_why, frozenset(held), plans)


def _asked(script: Script, number: int, is_why: bool, held: frozenset[int], plans: Plans) -> Next | None:
    condition = script.conditions[number]
    match condition:
        case NotSo(part=part):
            return _asked(script, part, not is_why, held, plans)
        case AllOf(parts=parts) | AnyOf(parts=parts):
            telling = [part for part in parts if (part in held) == is_why] or list(parts)
            found = (_asked(script, part, is_why, held, plans) for part in telling)
            return next((item for item in found if item is not None), None)
        case InPlaces(places=inside):
            for name, labels in inside.items():
                plan = plans(name)
                for label in sorted(labels & plan.by_label.keys()):
                    state = plan.by_label[label]
                    what = state.activity or state.name
                    if state.type != "END" and _is_known(plan, what):
                        return Next(name, what, is_why)
            return None
        case Says(agents=agents):
            for name, _ in script.team:
                if condition.is_received or agents is None or name in agents:
                    text = _sends(plans(name), condition)
                    if text is not None and _is_known(plans(name), text):
                        return Next(name, text, is_why)
            return None
        case Breached(agents=agents):
            for name in sorted(agents):
                for channel in condition.guarantee.said.channels:
                    if _is_known(plans(name), str(channel)):
                        return Next(name, str(channel), is_why)
            return None
        case Holds() | Untaken() | Faulty() | Failed():
            return None
        case _:
            assert_never(condition)


def turned_away(plan: Plan, what: str, taken: Mapping[int, int]) -> int | None:
    """When an agent that might have come to `what` by the next transition has last taken another one (ns).

    `taken` says when it has taken each transition last. None: never.
    """
    goal = goal_of(plan, what)

    def leads(number: int) -> bool:
        target = plan.transitions[number].target
        return number in goal.transitions or any(is_in(label, target) for label in goal.states)

    found = (
        moment
        for number, moment in taken.items()
        if not leads(number)
        if any(
            leads(other) and item.kind == "external"
            for other, item in plan.outgoing(plan.transitions[number].source)
        )
    )
    return max(found, default=None)


def _is_known(plan: Plan, what: str) -> bool:
    try:
        goal_of(plan, what)
    except NotAsked:
        return False
    return True


__all__ = ["Next", "about", "question", "spoken", "turned_away"]
