"""Tips: the full text of a state or transition, which the SVG shows under the pointer."""

from __future__ import annotations

from aseme_dsl.amola.statechart import State, Statechart, StateType, transition_text
from aseme_dsl.diagrams.look.labels import short
from aseme_dsl.diagrams.look.view import View, Way


def state_tip(view: View, node: State) -> str:
    """Label, type, name and origin; its outgoing transitions in the order in which they are tried."""
    lines = [_title(node, len(node.name))]
    if node.activity and node.activity != node.name:
        lines.append(f"activity {node.activity}")
    if node.waits:
        lines.append("waits: never completes by itself")
    if node.type not in (StateType.START, StateType.END):
        lines.append(f"from {node.origin}")
    if node.label in view.closed:
        lines.append(inside_text(view.closed[node.label]))
    stays = [*(item for item in view.chart.outgoing(node.label) if not item.changes_state)]
    lines += [
        transition_text(item)
        for item in (*stays, *view.chart.exits_of(node.label), *view.chart.abandons.get(node.label, ()))
    ]
    for transition in view.chart.outgoing_edges(node.label):
        targets = " and ".join(_title(view.chart.node(label)) for label in transition.targets)
        lines.append(f"to {targets}: {transition_text(transition) or 'when complete'}")
    return "\n".join(lines)


def way_tip(view: View, way: Way) -> str:
    """Both ends, the whole expression, and when it is tried among those of its source."""
    transition = way.transition
    ends = _title(view.chart.node(transition.source))
    if transition.changes_state:
        ends += f" to {' and '.join(_title(view.chart.node(label)) for label in transition.targets)}"
    lines = [ends, transition_text(transition) or "when complete"]
    rivals = view.chart.outgoing(transition.source)
    if len(rivals) > 1 and transition in rivals:
        lines.append(f"tried as number {rivals.index(transition) + 1} of {len(rivals)}")
    return "\n".join(lines)


def chart_about(chart: Statechart) -> str:
    """What a drawing of a statechart shows, for readers who cannot see it."""
    return f"{chart.kind} {chart.name} of {chart.system}"


def inside_text(count: int) -> str:
    """What a closed state says of the states inside."""
    return f"{count} state inside" if count == 1 else f"{count} states inside"


def _title(node: State, most: int = 60) -> str:
    """Label, type and name of a state; the name is shortened to `most` characters."""
    if node.name == node.label:
        return f"{node.label} {node.type.value}"
    return f"{node.label} {node.type.value} {short(node.name, most)}"
