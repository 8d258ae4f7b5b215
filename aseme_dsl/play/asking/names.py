"""Names: what people call the states of a statechart where several have the same name."""

from __future__ import annotations

from aseme_dsl.runtime.chart.plan import Plan, State


def named(plan: Plan, label: str) -> str:
    """What people call a state, told apart from others: `Carry[2]` is in the second of some instances.

    Where that does not do, the formula around it stands beside it, or else its label.
    """
    state = plan.by_label[label]
    name = plan.called(state)
    same = [item for item in plan.states if item is not state and plan.called(item) == name]
    if not same:
        return name
    own = _instance(plan, state)
    if all(_instance(plan, item) != own for item in same):
        return f"{name}{own}"
    around = _formula(plan, label)
    like = (item.label for item in same if _instance(plan, item) == own)
    if around and all(_formula(plan, item) != around for item in like):
        return f"{name}{own} in {around}"
    return f"{name}{own} ({label})"


def _formula(plan: Plan, label: str) -> str:
    """The name of the innermost formula around a state."""
    around = plan.by_label[label].parent
    while around is not None and not plan.by_label[around].name.isidentifier():
        around = plan.by_label[around].parent
    return "" if around is None else plan.by_label[around].name


def _instance(plan: Plan, state: State) -> str:
    """The numbers of the instances around a state: `[2]`; none where no region beside it has the same."""
    numbers = []
    for place, character in enumerate(state.label):
        around = state.label[:place]
        if character == "." and plan.by_label[around].type == "AND":
            region = state.label[place + 1 :].partition(".")[0]
            inner = state.label[place + 1 + len(region) :]
            like = [
                child.label
                for child in plan.children(around)
                if (other := plan.by_label.get(f"{child.label}{inner}")) is not None
                and (other.name == state.name or plan.called(other) == plan.called(state))
            ]
            if len(like) > 1:
                numbers.append(f"[{like.index(f'{around}.{region}') + 1}]")
    return "".join(numbers)


__all__ = ["named"]
