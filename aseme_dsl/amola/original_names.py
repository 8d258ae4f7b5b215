"""Original names: a chart with its unnamed states spelled as the tools of the papers spelled them.

For those who compare. The originals wrote the operators of a term out, without blanks: `[A . B]` is
`_open_option_A_sequence_B_close_option_`. States with a name of their own keep it.
"""

from __future__ import annotations

from dataclasses import replace

from aseme_dsl.amola.operators import Operator
from aseme_dsl.amola.statechart import Statechart, StateType

_SPELLINGS = sorted(
    (
        pair
        for operator in Operator
        for pair in zip(operator.value.split(), operator.row.originals, strict=False)
    ),
    key=lambda pair: -len(pair[0]),
)
"""The longest signs first: `||` before `|`."""


def original_name(term: str) -> str:
    """A term in canonical spelling as the originals name its state."""
    name = term.replace(" ", "")
    for operator, spelling in _SPELLINGS:
        name = name.replace(operator, spelling)
    return name


def labels_as_original(chart: Statechart) -> Statechart:
    """The chart with the originals' names for its OR and AND states that are named by their terms.

    Names of transitions are made of the names of their ends, as ever.
    """
    names = {
        node.label: original_name(node.name)
        if node.type in (StateType.OR, StateType.AND) and node.name != node.label
        else node.name
        for node in chart.states
    }
    nodes = tuple(
        node if names[node.label] == node.name else replace(node, name=names[node.label])
        for node in chart.states
    )
    transitions = tuple(
        replace(item, name=f"{names[item.source]}TO{names[item.target]}") if item.changes_state else item
        for item in chart.transitions
    )
    return replace(chart, states=nodes, transitions=transitions)


__all__ = ["labels_as_original", "original_name"]
