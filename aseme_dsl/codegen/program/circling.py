"""Circling: the transitions of which a step may take so many that it does not end."""

from __future__ import annotations

from aseme_dsl.amola.expression import NEVER
from aseme_dsl.amola.statechart import Statechart, StateType


def circling(chart: Statechart) -> tuple[int, ...]:
    """The numbers of the transitions that may be taken again and again within one step."""
    basic = {node.label for node in chart.states if node.type is StateType.BASIC}
    ways: dict[str, dict[str, None]] = {}
    for node in chart.states:  # enter at START, exit at END; ignore the states between
        if node.parent is None:
            continue
        is_region = chart.node(node.parent).type is StateType.AND
        if is_region or node.type is StateType.START:
            ways.setdefault(node.parent, {})[node.label] = None
        cut = any(way.expression.when for way in chart.outgoing_edges(node.parent))
        if is_region or cut or node.type is StateType.END:
            ways.setdefault(node.label, {})[node.parent] = None
    quick: list[int] = []
    for number, transition in enumerate(chart.transitions):
        said = transition.expression
        waits = said.events or said is NEVER or said.every or transition.reactive
        if transition.changes_state and not waits and (said.when or transition.source not in basic):
            quick.append(number)
            ways.setdefault(transition.source, {})[transition.target] = None

    def leads(source: str, target: str) -> bool:
        seen, waiting = {source}, [source]
        while waiting and target not in seen:
            new = ways.get(waiting.pop(), {}).keys() - seen
            seen |= new
            waiting += new
        return target in seen

    ends = [(chart.transitions[n].target, chart.transitions[n].source) for n in quick]
    return tuple(
        number for number, (target, source) in zip(quick, ends, strict=True) if leads(target, source)
    )


__all__ = ["circling"]
