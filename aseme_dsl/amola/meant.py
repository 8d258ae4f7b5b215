"""Meant: which states a condition means by a name, as in `outcome(Grasp)`, and since when it counts them."""

from __future__ import annotations

from collections.abc import Callable

from aseme_dsl.amola.statechart import State, Statechart, StateType


def states_meant(
    chart: Statechart, source: str, name: str, fits: Callable[[State], bool] | None = None
) -> tuple[State, ...]:
    """The states that an expression of a transition out of `source` means by `name`, in document order.

    They are those of that name in the innermost state around `source` (`source` included) that holds any;
    none where the whole chart has none. A state goes by its name and by that of its activity. With `fits`,
    only such states count.
    """
    named = [node for node in chart.called(name) if fits is None or fits(node)]
    around = [source, *(node.label for node in chart.ancestors(source))] if named else []
    for holder in around:
        held = tuple(node for node in named if node.label == holder or node.label.startswith(f"{holder}."))
        if held:
            return held
    return ()


def performers(chart: Statechart, source: str, activity: str) -> tuple[State, ...]:
    """The states of which `outcome(activity)` is the last outcome, in a transition out of `source`.

    They are looked for from its region, or its participant's branch, outwards: there one thing is done after
    the other, so that "the last" is clear.
    """
    region, branch = chart.region_of(source), chart.branch_of(source) or ""
    return states_meant(
        chart,
        branch if branch.startswith(f"{region}.") else region,
        activity,
        lambda node: node.type is StateType.BASIC and node.activity == activity,
    )


def loop_of(chart: Statechart, label: str) -> str:
    """The state whose entry sets the count of `label` to 0: what its loop stands in, else its region.

    Its loop is the nearest state, itself or around it in its region, with a transition to itself.
    """
    while not chart.is_region(label):
        node = chart.node(label)
        assert node.parent is not None
        if any(way.target == label and way.changes_state for way in chart.outgoing(label)):
            return node.parent
        label = node.parent
    return label


__all__ = ["loop_of", "performers", "states_meant"]
