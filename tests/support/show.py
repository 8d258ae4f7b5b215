"""A statechart as compact text for people: states indented, transitions, variables, regions."""

from __future__ import annotations

from aseme_dsl.amola.expression import expression_text
from aseme_dsl.amola.statechart import Statechart, StateType


def show(chart: Statechart) -> str:
    """All of a chart; origins are given where they change."""
    counts = f"{len(chart.states)} states, {len(chart.transitions)} transitions, {chart.levels} levels"
    lines = [f"{chart.kind} {chart.name}: {counts}"]
    origin = ""
    for node in chart.states:
        indent = "  " * (node.label.count(".") + 1)
        name = "" if node.name == node.label else f" {node.name}"
        activity = f" = {node.activity}" if node.activity not in (None, node.name) else ""
        where = (
            f"   <- {node.origin}" if str(node.origin) != origin and node.type is not StateType.END else ""
        )
        if where:
            origin = str(node.origin)
        lines.append(f"{indent}{node.label} {node.type}{name}{activity}{where}")
    lines.append("transitions")
    for item in chart.transitions:
        priority = f" #{item.priority}" if len(chart.outgoing(item.source)) > 1 else ""
        text = expression_text(item.expression)
        lines.append(f"  {item.source} -> {item.target}{priority}{' : ' + text if text else ''}")
    if chart.variables:
        lines.append("variables")
        lines += [
            f"  {item.name} : {item.type} = {item.initial.value}{' in ' + item.scope if item.scope else ''}"
            for item in chart.variables
        ]
    lines.append("regions")
    for region in chart.regions:
        reads, writes = (", ".join(map(str, channels)) or "-" for channels in (region.reads, region.writes))
        lines.append(f"  {region.label} reads {reads} writes {writes}")
    return "\n".join(lines) + "\n"
