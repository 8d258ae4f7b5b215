"""Roles: a foreign chart as the text of an `srm` with formulas and `control`, or of a `statechart`.

Monas tries transitions with a condition in the order from the last to the first, and those without one after
them. The lines are written in that order.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field, replace

from aseme_dsl.amola.messages import BOOL, DOUBLE, INT, STRING, Type
from aseme_dsl.amola.statechart import StateType
from aseme_dsl.interop.emf.charts import ForeignChart, ForeignState, ForeignTransition, ForeignVariable
from aseme_dsl.interop.emf.expressions import ForeignExpression, Untranslatable, read_expression
from aseme_dsl.interop.emf.formulas import Edge, NoFormula, Reconstructed, formulas_of, title
from aseme_dsl.interop.emf.identifiers import INITIAL, Names, is_name
from aseme_dsl.interop.emf.meaning import Meaning
from aseme_dsl.interop.emf.report import Fate, Row
from aseme_dsl.records import dataclass

_COMPOSITE = (StateType.OR, StateType.AND)
_SCALARS = {"bool": BOOL, "int": INT, "float": DOUBLE, "double": DOUBLE, "string": STRING, "String": STRING}
_SCALARS |= {"boolean": BOOL, "long": INT, "std::string": STRING}


@dataclass(frozen=True, slots=True)
class Line:
    """What is written for a transition: its expression, or a hole and what stands in the file."""

    expression: str = ""
    is_hole: bool = False
    comment: str = ""
    reason: str = ""


@dataclass(frozen=True, slots=True)
class RoleText:
    """The lines of a role, and for those that stand for a transition its number in the chart."""

    name: str
    lines: tuple[str, ...]
    transitions: Mapping[int, int]
    rows: tuple[Row, ...]
    is_formula: bool


@dataclass(slots=True)
class RolePlan:
    """A chart on its way to text. `problems` are what the compiler says of the lines of transitions."""

    chart: ForeignChart
    name: str
    reconstructed: Reconstructed | None
    why_not: str
    expressions: list[ForeignExpression | str] = field(default_factory=list)
    """Of each transition; a text is the reason why it is a hole."""
    problems: dict[int, str] = field(default_factory=dict)
    renamed: list[tuple[ForeignState, str]] = field(default_factory=list)


def scalar_variables(chart: ForeignChart) -> dict[str, Type]:
    """The variables of a chart that a role can have."""
    return {item.name: _SCALARS[item.type] for item in chart.variables if _is_scalar(item)}


def _is_scalar(item: ForeignVariable) -> bool:
    return is_name(item.name) and item.type in _SCALARS


def channel_of(item: ForeignVariable) -> tuple[str, str, str] | None:
    """The channel that a variable of KSE stands for, whose type is `topic.State.Message`."""
    parts = item.type.split(".")
    if len(parts) == 3 and all(map(is_name, (parts[0].lstrip("_"), parts[2]))):
        kind = parts[1].lower()
        if kind in ("state", "signal", "data"):
            return parts[0].lstrip("_"), kind, parts[2]
    return None


def plan_role(chart: ForeignChart, name: str) -> RolePlan:
    """Names that the language has, and formulas if there are any."""
    names = Names()
    states: list[ForeignState] = []
    renamed: list[tuple[ForeignState, str]] = []
    for state in chart.states:
        own = state.name
        if state.type is StateType.BASIC and not is_name(own):
            own = names.of(own or state.label, "Activity")
            renamed.append((state, own))
        states.append(replace(state, name=own))
    chart = replace(chart, states=tuple(states))
    reconstructed, why_not = None, ""
    try:
        reconstructed = formulas_of(chart)
    except NoFormula as problem:
        why_not = str(problem)
    return RolePlan(chart, name, reconstructed, why_not, renamed=renamed)


def read_expressions(plan: RolePlan, meaning: Meaning) -> None:
    """Read what the transitions say; what is understood counts for the meaning of all."""
    plan.expressions.clear()
    for number, item in enumerate(plan.chart.transitions):
        found: ForeignExpression | str = plan.problems.get(number) or ForeignExpression()
        if item.expression and number not in plan.problems:
            try:
                found = read_expression(item.expression)
                meaning.add(found)
            except Untranslatable as problem:
                found = str(problem)
        plan.expressions.append(found)
    for variable in plan.chart.variables:
        channel = channel_of(variable)
        if channel is not None:
            meaning.channels[channel] = None


def role_text(plan: RolePlan, meaning: Meaning, *, with_holes: bool = True) -> RoleText:
    """The text of a role. Without holes it is for comparison only: each is a condition that holds."""
    return RoleWriter(plan, meaning, with_holes).written()


class RoleWriter:
    """Writes a role: the lines, which of them are transitions, and what became of each element."""

    def __init__(self, plan: RolePlan, meaning: Meaning, with_holes: bool) -> None:
        self.plan = plan
        self.chart = plan.chart
        self.meaning = meaning
        self.with_holes = with_holes
        self.hole = "[?]" if with_holes else "[true]"
        self.lines: list[str] = []
        self.transitions: dict[int, int] = {}
        self.rows: list[Row] = []
        self.numbers = {id(item): number for number, item in enumerate(self.chart.transitions)}
        self.others = {state.label: name for state, name in plan.renamed}
        self.said = {number: self._line(number) for number in range(len(self.chart.transitions))}

    def written(self) -> RoleText:
        """The whole role."""
        plan = self.plan
        self._head()
        if plan.reconstructed is not None:
            self._formulas(plan.reconstructed)
        else:
            self._statechart()
        self.lines.append("}")
        return RoleText(
            plan.name, tuple(self.lines), self.transitions, tuple(self.rows), plan.reconstructed is not None
        )

    # ---- transitions -------------------------------------------------------------------------

    def _line(self, number: int) -> Line:
        item = self.chart.transitions[number]
        read = self.plan.expressions[number]
        source = self.chart.by_label[item.source]
        is_composite = source.type in _COMPOSITE
        hole = f"when {self.hole}" if is_composite and self.with_holes else self.hole
        if isinstance(read, str):
            return Line(hole, True, f"KSE: {item.expression}", read)
        try:
            text = self.meaning.text(read, may_wait=is_composite)
        except Untranslatable as reason:
            return Line(hole, True, f"KSE: {item.expression}", str(reason))
        if read.condition is not None or read.event:
            return Line(text)
        siblings = [self._says_when(other) for other in self.chart.outgoing[item.source]]
        if siblings.count(False) > 1:
            return Line(f"{hole} {text}".strip(), True, "", "nothing says when it is taken")
        if source.type is StateType.CONDITION and len(siblings) > 1:
            return Line(f"else {text}".strip())
        return Line(text)

    def _says_when(self, item: ForeignTransition) -> bool:
        read = self.plan.expressions[self.numbers[id(item)]]
        return isinstance(read, str) or read.condition is not None or bool(read.event)

    def _in_order(self, label: str) -> list[int]:
        """The transitions of a state in the order in which Monas tries them."""
        outgoing = self.chart.outgoing.get(label, ())
        asked = [item for item in outgoing if self._says_when(item)]
        rest = [item for item in outgoing if not self._says_when(item)]
        return [self.numbers[id(item)] for item in (*reversed(asked), *rest)]

    def _transition(self, number: int, way: str, now: str) -> None:
        """Write the line of a transition, and its row."""
        line, item = self.said[number], self.chart.transitions[number]
        if line.comment:
            self.lines.append(f"  // {line.comment}")
        self.transitions[len(self.lines)] = number
        self.lines.append(f"  {way} : {line.expression}")
        self._row(number, line, item, now)

    def _row(self, number: int, line: Line, item: ForeignTransition, now: str) -> None:
        ends = " -> ".join(title(self.chart.by_label[label]) for label in (item.source, item.target))
        text = f" : {item.expression}" if item.expression else ""
        fate = (
            Fate.HOLE if line.is_hole else Fate.CHANGED if item.expression or line.expression else Fate.KEPT
        )
        why = f"{line.reason}; {now}" if line.reason else now
        self.rows.append(Row(fate, f"transition {ends}{text}", item.place, why))
        if item.metadata:
            self.rows.append(Row(Fate.LEFT_OUT, f"metadata of transition {ends}", item.place, item.metadata))

    # ---- the two forms -----------------------------------------------------------------------

    def _head(self) -> None:
        chart, plan = self.chart, self.plan
        kind = "srm" if plan.reconstructed is not None else "statechart"
        for what, text in (("description", chart.description), ("metadata", chart.metadata)):
            if text:
                self.lines.append(f"// {what}: {text}")
                self.rows.append(Row(Fate.CHANGED, f"{what} of the model", chart.place, "a comment"))
        self.rows.append(
            Row(
                Fate.KEPT,
                f"model {chart.name or chart.states[0].name}",
                chart.place,
                f"{kind} {plan.name}" + (f": {plan.why_not}" if plan.why_not else ""),
            )
        )
        self.lines.append(f"{kind} {plan.name} {{")
        for item in chart.variables:
            self.variable(item)
        for name, place in chart.lost:
            self.rows.append(Row(Fate.LEFT_OUT, f"element <{name}>", place, "the format does not have it"))

    def variable(self, item: ForeignVariable) -> None:
        """A variable of the role."""
        channel = channel_of(item)
        if _is_scalar(item):
            kind = str(_SCALARS[item.type])
            self.lines.append(f"  var {item.name} : {kind} = {INITIAL[kind]}")
            now = "a variable of the role; its first value is not in the model"
            self.rows.append(Row(Fate.CHANGED, f"variable {item.name}", item.place, now))
        elif channel is not None:
            now = f"its states read {'.'.join(channel)}"
            self.rows.append(Row(Fate.CHANGED, f"variable {item.name}", item.place, now))
        else:
            now = f"its type `{item.type[:40]}` is not one of the language"
            self.rows.append(Row(Fate.LEFT_OUT, f"variable {item.name}", item.place, now))

    def _formulas(self, found: Reconstructed) -> None:
        self.lines.append("  liveness {")
        self.lines += [f"    {name} = {text}" for name, text in found.formulas.items()]
        self.lines.append("  }")
        stale = {state.label for state in found.renamed}
        for state in self.chart.states:
            self.state(
                state, "a term that the name is not of any more" if state.label in stale else "liveness"
            )
        self._activities()
        self.control(found)

    def control(self, found: Reconstructed) -> None:
        """The `control` blocks of the formulas."""
        for name in found.formulas:
            lines = [
                (number, way)
                for state in self.chart.states
                for number in self._in_order(state.label)
                if (way := found.ways[self._edge(number)]).formula == name
            ]
            written = [(n, w) for n, w in lines if w.is_first and self.said[n].expression]
            if written:
                self.lines.append(f"  control {name} {{")
            for number, way in lines:
                now = f"control {name}: {way.verb} {way.term}"
                if way.is_first and self.said[number].expression:
                    self._transition(number, f"{way.verb} {way.term}", now)
                else:
                    self._row(number, self.said[number], self.chart.transitions[number], now)
            if written:
                self.lines.append("  }")

    def _edge(self, number: int) -> Edge:
        item = self.chart.transitions[number]
        return item.source, item.target

    def _statechart(self) -> None:
        for state in self.chart.states:
            name = "" if state.name in ("", state.label) else state.name
            if state.type is not StateType.BASIC and name and not is_name(name):
                name = '"' + name.replace("\\", "\\\\").replace('"', '\\"') + '"'
            self.lines.append(f"  state {state.label} {state.type} {name}".rstrip())
            self.state(state, f"state {state.label}")
        for state in self.chart.states:
            for number in self._in_order(state.label):
                source, target = self._edge(number)
                self._transition(number, f"{source} -> {target}", f"{source} -> {target}")
        self._activities()

    # ---- states ------------------------------------------------------------------------------

    def state(self, state: ForeignState, now: str) -> None:
        """The row of a state."""
        other = self.others.get(state.label)
        fate = Fate.KEPT
        if state.was:
            fate, now = Fate.CHANGED, f"{now}; its label was {state.was}"
        if state.was_hollow:
            fate, now = Fate.CHANGED, f"{now}; an OR without states is an activity"
        if other is not None:
            fate, now = Fate.CHANGED, f"{now}; called {other}"
        self.rows.append(Row(fate, f"{state.type} {title(state)}", state.place, now))
        for what in ("actions", "metadata"):
            if text := getattr(state, what):
                why = f"the language says them in `control`: {text}" if what == "actions" else text
                self.rows.append(Row(Fate.LEFT_OUT, f"{what} of {title(state)}", state.place, why))

    def _activities(self) -> None:
        """Comments for where the code was, and what the activities read by their variables."""
        channels = {item.name: channel_of(item) for item in self.chart.variables}
        lines: dict[str, tuple[str, dict[str, None]]] = {}
        for state in self.chart.states:
            reads = [channel for name in state.variables if (channel := channels.get(name)) is not None]
            if state.type is StateType.BASIC and (state.activity or reads):
                place, known = lines.setdefault(state.name, (state.activity, {}))
                known |= dict.fromkeys(".".join(channel) for channel in reads)
                if state.activity:
                    self.rows.append(
                        Row(Fate.CHANGED, f"activity of {title(state)}", state.place, f"a comment: {place}")
                    )
            elif state.activity:
                why = f"only BASIC states have activities: {state.activity}"
                self.rows.append(Row(Fate.LEFT_OUT, f"activity of {title(state)}", state.place, why))
        if lines:
            self.lines.append("  activities {")
            for name, (place, reads_of) in sorted(lines.items()):
                if place:
                    self.lines.append(f"    // {place}")
                self.lines.append(f"    {name}{' reads ' + ', '.join(reads_of) if reads_of else ''}")
            self.lines.append("  }")


__all__ = [
    "RolePlan",
    "RoleText",
    "RoleWriter",
    "channel_of",
    "plan_role",
    "read_expressions",
    "role_text",
    "scalar_variables",
]
