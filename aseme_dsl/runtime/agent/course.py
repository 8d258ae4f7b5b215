"""Course: what an agent's latest steps say of it: what has changed, where it failed, what goes round."""

from __future__ import annotations

from collections.abc import Iterable

from aseme_dsl.runtime.chart.inputs import Completed, Input, Outcome
from aseme_dsl.runtime.chart.plan import Plan


def changed_states(plan: Plan, is_first: bool, inputs: Iterable[Input], outcome: Outcome) -> list[str]:
    """The labels of the states that a step has entered by transitions to them, or whose activity returned."""
    found = [plan.states[0].label] if is_first else []
    for item in inputs:
        if isinstance(item, Completed):
            found.append(item.label)
    for numbers in outcome.taken:
        last = plan.transitions[numbers[-1]]
        if last.kind == "external":
            found += last.targets
    return found


def place_of_failure(plan: Plan, outcome: Outcome) -> str:
    """The place in the source of what failed in a step: a state's activity, or the transition taken last."""
    reason = outcome.failure or ""
    at = next((state.at for state in plan.states if f" of state {state.label} failed: " in reason), "")
    if at:
        return at
    taken = [plan.transitions[numbers[0]] for numbers in outcome.taken]
    return next((way.at for way in reversed(taken) if way.kind not in ("exit", "abandon")), "")


def cycle(plan: Plan, recent: Iterable[tuple[int, ...]]) -> str:
    """The transitions taken last and their activities, for messages about what does not end."""
    taken = list(recent)
    states = [plan.by_label[label] for numbers in taken for label in plan.transitions[numbers[-1]].targets]
    activities = [f"{state.activity} ({state.at})" for state in states if state.activity]
    if activities:
        return "activities " + ", ".join(dict.fromkeys(activities)) + " again and again"
    return ", ".join(dict.fromkeys(map(plan.way, taken))) or "no transition"
