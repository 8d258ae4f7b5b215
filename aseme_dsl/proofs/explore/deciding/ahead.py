"""Ahead: the states that may be active from one on, by the form of a statechart alone."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from aseme_dsl.runtime.chart.plan import Plan, Transition, is_in


def ahead(plan: Plan, label: str, goes: Callable[[Transition], bool], *, is_entered: bool) -> Iterator[str]:
    """The states that may be active from one on, if only transitions are taken of which `goes` is true.

    `is_entered`: the first state is entered now, at its STARTs. A state may come twice.
    """
    todo = [(label, is_entered)]
    seen: set[tuple[str, bool]] = set()
    lines: dict[str, list[Transition]] = {}
    for item in plan.transitions:
        lines.setdefault(item.source, []).append(item)
    while todo:
        label, is_entered = todo.pop()
        if (label, is_entered) in seen:
            continue
        seen.add((label, is_entered))
        yield label
        state = plan.by_label[label]
        if state.parent is not None:
            todo.append((state.parent, False))
        if is_entered:
            todo += [
                (child.label, True)
                for child in plan.children(label)
                if state.type == "AND" or child.type == "START"
            ]
        for item in lines.get(label, ()):
            if item.kind != "external" or not goes(item):
                continue
            todo += [(other, True) for other in (item.target, *plan.entries_of(item))]
            if item.resume:
                todo += [(other.label, True) for other in plan.states if is_in(other.label, item.target)]


__all__ = ["ahead"]
