"""Protocols: the statechart of an `.eac` file as an `aip`, with the process and `control` of participants."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import field, replace

from aseme_dsl.amola.statechart import StateType
from aseme_dsl.interop.emf.charts import ForeignChart, ForeignState
from aseme_dsl.interop.emf.formulas import NoFormula, body_of, title
from aseme_dsl.interop.emf.meaning import Meaning
from aseme_dsl.interop.emf.report import Fate, Row
from aseme_dsl.interop.emf.requirements import ForeignProtocol
from aseme_dsl.interop.emf.roles import RolePlan, RoleWriter, plan_role
from aseme_dsl.records import dataclass


@dataclass(slots=True)
class ProtocolPlan:
    """A protocol on its way to text: its chart, and a plan for the process of each participant."""

    name: str
    chart: ForeignChart
    parts: list[RolePlan]
    said: ForeignProtocol | None = None
    """What an `.aip` says of the protocol."""


@dataclass(slots=True)
class ProtocolText:
    """Lines, the transition of each that has one (part and number), and what became of each element."""

    lines: list[str] = field(default_factory=list)
    transitions: dict[int, tuple[int, int]] = field(default_factory=dict)
    rows: list[Row] = field(default_factory=list)


def plan_protocol(chart: ForeignChart, name: str) -> ProtocolPlan:
    """The participants of a chart. Raises NoFormula if it is not that of a protocol."""
    body_of(chart, chart.states[0])
    parts = []
    for inside in _participants(chart):
        plan = plan_role(_below(chart, inside), inside.name)
        if plan.reconstructed is None:
            raise NoFormula(plan.why_not)
        if next(iter(plan.reconstructed.formulas)) != inside.name:
            raise NoFormula(f"{title(inside)} has no name for a participant")
        parts.append(plan)
    if len({plan.name for plan in parts}) < len(parts):
        raise NoFormula("two participants have one name")
    return ProtocolPlan(name, chart, parts)


def _participants(chart: ForeignChart) -> Iterator[ForeignState]:
    """The state of each participant: START, an AND with a region for each, END."""
    children = chart.inside(chart.states[0].label)
    if [child.type for child in children] != [StateType.START, StateType.AND, StateType.END]:
        raise NoFormula("it is not one AND state between START and END")
    for region in chart.inside(children[1].label):
        inside = chart.inside(region.label)[1]
        if inside.type is not StateType.OR:
            raise NoFormula(f"the participant {title(inside)} is one activity")
        yield inside


def _below(chart: ForeignChart, root: ForeignState) -> ForeignChart:
    """The part of a chart that is inside a state."""
    states = tuple(
        replace(state, parent=None) if state is root else state
        for state in chart.states
        if state is root or state.label.startswith(f"{root.label}.")
    )
    labels = {state.label for state in states} - {root.label}
    transitions = tuple(item for item in chart.transitions if item.source in labels)
    return ForeignChart(root.name, states, transitions, (), root.place)


def protocol_text(plan: ProtocolPlan, meaning: Meaning, *, with_holes: bool) -> ProtocolText:
    """The text of an `aip`."""
    found = ProtocolText()
    place = plan.chart.place
    found.rows.append(Row(Fate.KEPT, f"model {plan.chart.name}", place, f"aip {plan.name}"))
    found.lines.append(f"aip {plan.name} {{")
    said = {} if plan.said is None else {member.name: member for member in plan.said.participants}
    inner: set[str] = set()
    controls: list[tuple[int, RoleWriter]] = []
    for number, part in enumerate(plan.parts):
        assert part.reconstructed is not None
        writer = RoleWriter(part, meaning, with_holes)
        found.lines.append(f"  participant {part.name} {{")
        member = said.get(part.name)
        if member is not None and member.rule:
            found.lines.append(f"    engage {_quoted(member.rule)}")
        for name, text in part.reconstructed.formulas.items():
            found.lines.append(f"    {'process' if name == part.name else name} = {text}")
        found.lines.append("  }")
        for state in part.chart.states:
            inner.add(state.label)
            writer.state(state, f"participant {part.name} of {plan.name}")
            if state.activity:
                what = f"activity of {title(state)}"
                writer.rows.append(Row(Fate.LEFT_OUT, what, state.place, f"roles say it: {state.activity}"))
        writer.control(part.reconstructed)
        controls.append((number, writer))
    outcomes = dict.fromkeys(member.outcomes for member in said.values() if member.outcomes)
    found.lines += [f"  outcome {_quoted(text)}" for text in outcomes]
    for number, writer in controls:
        begin = len(found.lines)
        found.transitions |= {begin + line: (number, at) for line, at in writer.transitions.items()}
        found.lines += writer.lines
        found.rows += writer.rows
    found.lines.append("}")
    found.rows += _frame(plan, inner)
    return found


def _frame(plan: ProtocolPlan, inner: set[str]) -> Iterator[Row]:
    """The rows of what stands around the participants."""
    for state in plan.chart.states:
        if state.label not in inner:
            yield Row(Fate.KEPT, f"{state.type} {title(state)}", state.place, f"aip {plan.name}")
    roots = {part.chart.states[0].label for part in plan.parts}
    for item in plan.chart.transitions:
        if item.source not in inner or item.source in roots:
            ends = f"{item.source} -> {item.target}"
            fate = Fate.LEFT_OUT if item.expression else Fate.KEPT
            now = "a protocol has no expression there" if item.expression else f"aip {plan.name}"
            yield Row(fate, f"transition {ends} {item.expression}".rstrip(), item.place, now)
    for variable in plan.chart.variables:
        now = "roles say what their activities read"
        yield Row(Fate.LEFT_OUT, f"variable {variable.name}", variable.place, now)


def _quoted(text: str) -> str:
    escaped = text.replace("\\", "\\\\").replace('"', '\\"')
    return f'"{escaped}"'


__all__ = ["ProtocolPlan", "ProtocolText", "plan_protocol", "protocol_text"]
