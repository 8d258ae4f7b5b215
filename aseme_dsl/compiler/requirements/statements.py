"""Statements: whether what scenarios and properties name exists, and whether values have the right types."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import field, fields, is_dataclass, replace
from typing import assert_never

from aseme_dsl.amola.aip import Aip
from aseme_dsl.amola.expression import Assign, Fill, Member, Raised, Value, walk
from aseme_dsl.amola.liveness import names
from aseme_dsl.amola.messages import BOOL, DOUBLE, DURATION, INT, Channel, Type
from aseme_dsl.amola.srm import Activity
from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.compiler.names.checker import Checker
from aseme_dsl.compiler.names.paths import channel_of
from aseme_dsl.compiler.names.scope import Scope, Taken
from aseme_dsl.compiler.read.blocks import Blocks, participants_of
from aseme_dsl.compiler.read.builtins import COMM_TYPES, PERFORMATIVES
from aseme_dsl.compiler.read.constants import NotConstant, fold
from aseme_dsl.compiler.read.damage import Damaged
from aseme_dsl.compiler.read.names import declared_twice, unknown, unknown_performative
from aseme_dsl.compiler.requirements.places import called
from aseme_dsl.compiler.requirements.together import check_together
from aseme_dsl.compiler.types.content import fill
from aseme_dsl.compiler.types.scopes import TypedRole
from aseme_dsl.compiler.types.typecheck import type_value
from aseme_dsl.diagnostics import Diagnostic, Problem
from aseme_dsl.diagnostics.problems.absences import Absent
from aseme_dsl.diagnostics.problems.expressions.absences import NoBeginning, NoVariableOrLet
from aseme_dsl.diagnostics.problems.scenarios import statements as problems
from aseme_dsl.grammar.formulas.statement import read_statements
from aseme_dsl.grammar.text import statements as nodes
from aseme_dsl.grammar.text import tree
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.inputs import LOST
from aseme_dsl.source import Span


@dataclass(frozen=True, slots=True)
class Known:
    """What statements may name.

    `states` are those of each role, None where its chart could not be built. `processes` are the places of
    each participant, under its own name and under those that roles give it.
    """

    top: Scope
    scopes: Mapping[str, TypedRole]
    states: Mapping[str, frozenset[str] | None]
    processes: Mapping[str, frozenset[str]]
    events: Mapping[str, frozenset[str]]
    performed: Mapping[str, frozenset[str]]
    activities: Mapping[str, Activity]
    outcomes: tuple[str, ...]
    variables: Mapping[str, Mapping[str, Type]]
    """Those of each role, and of the participants that it plays."""
    of_parts: Mapping[str, Mapping[str, tuple[str, Type]]]
    """The keys and types of the variables of participants of which a role has one of that name."""
    held: Mapping[str, frozenset[Channel]]
    """The channels that each role reads, or of which its actions fill messages."""
    aliases: frozenset[str]
    """Those of all files."""

    @property
    def agents(self) -> dict[str, str]:
        """The roles of the agents of the team; without a team, an agent is called as its role."""
        teams = self.top.symbols.teams
        return {agent.name: agent.role for team in teams for agent in team.agents} or {
            name: name for name in self.states
        }


def known_by(
    files: Iterable[tree.File],
    top: Scope,
    scopes: Mapping[str, TypedRole],
    blocks: Blocks,
    aips: Iterable[Aip],
    iacs: Mapping[str, Statechart | None],
    activities: Mapping[str, Activity],
) -> Known:
    """What the statements of a system may name."""
    aliases = frozenset(alias for file in files for alias in _aliases(file))
    performed: dict[str, set[str]] = {}
    for role, chart in iacs.items():
        for node in chart.states if chart is not None else ():
            if node.activity is not None:
                performed.setdefault(node.activity, set()).add(role)
    for name in activities:
        performed.setdefault(name, set())
    return Known(
        top,
        scopes,
        {role: None if chart is None else _states(chart, aliases) for role, chart in iacs.items()},
        _processes(blocks, aliases),
        {role: _events(chart) for role, chart in iacs.items() if chart is not None},
        {name: frozenset(roles) for name, roles in performed.items()},
        activities,
        tuple(item.text for aip in aips for item in aip.outcomes),
        {role: _variables(chart) for role, chart in iacs.items() if chart is not None},
        {role: _of_parts(chart) for role, chart in iacs.items() if chart is not None},
        {role: _held(chart) for role, chart in iacs.items() if chart is not None},
        aliases,
    )


def _variables(chart: Statechart) -> dict[str, Type]:
    return {item.name.partition("@")[0]: item.type for item in chart.variables}


def _of_parts(chart: Statechart) -> dict[str, tuple[str, Type]]:
    names = Counter(item.name.partition("@")[0] for item in chart.variables)
    return {
        name: (item.name, item.type)
        for item in chart.variables
        if "@" in item.name and names[name := item.name.partition("@")[0]] == 1
    }


def _held(chart: Statechart) -> frozenset[Channel]:
    actions = (action for item in chart.transitions for action in item.expression.actions)
    filled = {
        item.target.channel
        for item in actions
        if isinstance(item, Assign) and isinstance(item.target, Member)
    }
    return frozenset(filled.union(*(region.reads for region in chart.regions)))


def _states(chart: Statechart, aliases: Iterable[str]) -> frozenset[str]:
    """The names of its states, those from a file with an alias also without it."""
    found = {chart.name}
    for node in chart.states:
        found.update((node.name, node.activity or "", node.origin.name))
    found = {short for name in found for short in called(name, aliases)}
    return frozenset(name for name in found if name.isidentifier())


def _events(chart: Statechart) -> frozenset[str]:
    events = (event for item in chart.transitions for event in item.expression.events)
    return frozenset(event.name for event in events if isinstance(event, Raised))


def _processes(blocks: Blocks, aliases: Iterable[str]) -> dict[str, frozenset[str]]:
    """The names in the process of each participant, those from a file with an alias also without it."""
    places: dict[str, set[str]] = {}
    owned: dict[tuple[str, str], set[str]] = {}
    for protocol in blocks.aips:
        for item in participants_of(protocol):
            own = owned.setdefault((protocol.name.text, item.name.text), set())
            own.update({one.name.text for one in item.formulas} - {"process"})
            own.update(node.name for one in item.formulas for node in names(one.formula))
            own.add(item.name.text)
            places.setdefault(item.name.text, set()).update(own)
    for role in blocks.srms:
        for part in role.plays:
            own = owned.get((part.protocol.text, part.participant.text), set())
            bound = {item.own.text for item in part.bindings if item.own is not None}
            for name in (part.participant.text, *((part.alias.text,) if part.alias else ())):
                places.setdefault(name, set()).update(own | bound)
    return {
        part: frozenset(short for name in inside for short in called(name, aliases))
        for part, inside in places.items()
    }


def check_statements(
    files: Sequence[tree.File], known: Known, is_damaged: Damaged, told: Iterable[Diagnostic]
) -> tuple[Diagnostic, ...]:
    """What is wrong in scenarios and properties: E117, E229, E230, and types as everywhere.

    `told` is what is wrong elsewhere: names are not missing where something could not be read.
    """
    is_read = not any(_is_elsewhere(item, files) for item in told)
    blocks = [(item, _aliases(file)) for file in files for item in file.must_hold]
    read = []
    for item, aliases in blocks:
        is_property = isinstance(item, tree.Property)
        statements, wrong = read_statements(item.span.source, _words(item, aliases), is_property)
        # Where a brace is missing, what ends too early has been said.
        read.append((statements, () if is_damaged(item.span) else wrong, is_property))
    # A property speaks of every run: also of the agents that some scenario introduces.
    introduced: dict[str, str] = {}
    for statements, _, _ in read:
        introduced |= {name: role for name, role in _introduced(statements).items() if role in known.states}
    given = frozenset(_given(statements for statements, _, _ in read))
    found: list[Diagnostic] = []
    for (statements, wrong, is_property), (item, _) in zip(read, blocks, strict=True):
        own = introduced if is_property else _introduced(statements)
        agents = {**known.agents, **own} if is_property or not own else own
        check = Check(
            known,
            agents,
            bool(own) and not is_property,
            is_damaged(item.span),
            is_read,
            not is_property,
            given,
        )
        check.introduce(statements)
        for statement in statements:
            check.statement(statement)
        found += _each_cause(check.found, wrong)
        if not is_property and not wrong and not check.is_broken:
            found += check_together(statements, agents)
    for file in files:
        found += _titled_twice(file)
    return tuple(dict.fromkeys(found))


def _titled_twice(file: tree.File) -> Iterator[Diagnostic]:
    """Verdicts name a scenario by its title, and so does who wants to play it alone."""
    first: dict[tuple[type[object], str], Span] = {}
    for item in file.must_hold:
        kind = "property" if isinstance(item, tree.Property) else "scenario"
        place = first.setdefault((type(item), item.title.text), item.title.span)
        if place != item.title.span:
            yield declared_twice(kind, item.title, place)


def scenarios(
    files: Iterable[tree.File], known: Known
) -> Iterator[tuple[tree.Scenario, tuple[nodes.Statement, ...], Check]]:
    """The scenarios of files without errors, with their statements, and what the names in them mean."""
    for file in files:
        for item in file.must_hold:
            if isinstance(item, tree.Scenario):
                statements, _ = read_statements(item.span.source, _words(item, _aliases(file)))
                own = _introduced(statements)
                check = Check(known, own or known.agents, bool(own), is_broken=False, is_read=True)
                check.introduce(statements)
                yield item, statements, check


def properties(files: Iterable[tree.File]) -> tuple[tuple[str, nodes.Statement], ...]:
    """What the properties of files without errors say of every run, each with the title of its property."""
    return tuple(
        (item.title.text, statement)
        for file in files
        for item in file.must_hold
        if isinstance(item, tree.Property)
        for statement in read_statements(item.span.source, _words(item, _aliases(file)), True)[0]
    )


def _is_elsewhere(found: Diagnostic, files: Iterable[tree.File]) -> bool:
    """Whether it says that something could not be read outside of scenarios and properties, or that a role
    lacks what it plays or includes."""
    span = found.span
    if found.code[:2] not in ("E0", "E1") and found.code not in ("E205", "E206", "E207"):
        return False
    return span is None or not any(
        item.span.source is span.source and item.span.start <= span.start <= item.span.end
        for file in files
        for item in file.must_hold
    )


def _each_cause(named: Sequence[Diagnostic], formed: Iterable[Diagnostic]) -> list[Diagnostic]:
    """All problems, but what remains of a line whose beginning names something wrong begins no statement."""
    ends = {(item.span.line): item.span.end for item in reversed(named) if item.span is not None}
    return [
        *named,
        *(
            item
            for item in formed
            if item.span is None
            or not isinstance(item.problem, problems.NoStatement | problems.WithoutMoment)
            or ends.get(item.span.line, item.span.end) > item.span.start
        ),
    ]


def _introduced(statements: Iterable[nodes.Statement]) -> dict[str, str]:
    """The agents that take part, with their roles."""
    found: dict[str, str] = {}
    for item in statements:
        if isinstance(item, nodes.TakesPart):
            for name, bounds in item.agents:
                if bounds is None:
                    found[name.text] = model_name(item.role)
                else:
                    numbers = range(bounds[0], bounds[1] + 1)
                    found.update((f"{name}{number}", model_name(item.role)) for number in numbers)
    return found


def model_name(name: tree.Name) -> str:
    """What `alice.attacker` is called in the models."""
    return name.text.replace(".", "_")


def _words(item: tree.Scenario | tree.Property, aliases: frozenset[str]) -> list[tree.Name]:
    """The words, of which `alice.attacker` is called as it is in the models, which takes as many letters."""
    return [
        tree.Name(word.text.replace(".", "_", 1), word.span) if word.text.split(".")[0] in aliases else word
        for word in item.words
    ]


def _aliases(file: tree.File) -> frozenset[str]:
    items = (item.alias for item in file.declarations if isinstance(item, tree.Import))
    return frozenset(alias.text for alias in items if alias is not None)


def _given(statements: Iterable[object]) -> Iterator[str]:
    """The last names of the messages that statements give, wherever they stand in them."""
    todo = list(statements)
    while todo:
        node = todo.pop()
        if isinstance(node, tuple):
            todo += node
        elif isinstance(node, nodes.Filled):
            yield node.what.segments[-1].text.rpartition("_")[2]
        elif is_dataclass(node) and type(node).__module__ == nodes.__name__:
            todo += (getattr(node, one.name) for one in fields(node))


def only_agent(item: object) -> tree.Name | None:
    """The agent of a sentence, if it has one only: what its bare conditions are about."""
    found: dict[str, tree.Name] = {}
    todo = [item]
    while todo:
        node = todo.pop()
        if isinstance(node, tuple):
            todo += node
        elif is_dataclass(node) and type(node).__module__ == nodes.__name__:
            agent = getattr(node, "agent", None)
            if isinstance(agent, tree.Name):
                found[agent.text] = agent
            todo += (getattr(node, one.name) for one in fields(node))
    return next(iter(found.values())) if len(found) == 1 else None


def _with_paths(written: tree.Expression, change: Callable[[tree.Path], tree.Path]) -> tree.Expression:
    """An expression with its paths changed. It is as deep as the parser lets it be."""

    def part(item: tree.Expression) -> tree.Expression:
        return _with_paths(item, change)

    match written:
        case tree.Path():
            return change(written)
        case tree.Call():
            return replace(written, arguments=tuple(map(part, written.arguments)))
        case tree.Unary():
            return replace(written, operand=part(written.operand))
        case tree.Binary():
            return replace(written, left=part(written.left), right=part(written.right))
        case tree.Logic():
            return replace(written, operands=tuple(map(part, written.operands)))
        case tree.Conditional():
            condition, yes, no = map(part, (written.condition, written.yes, written.no))
            return replace(written, condition=condition, yes=yes, no=no)
        case tree.Parenthesised():
            return replace(written, inner=part(written.inner))
        case tree.List():
            return replace(written, elements=tuple(map(part, written.elements)))
        case tree.Element():
            return replace(written, list=part(written.list), index=part(written.index))
        case tree.NewMessage(fills=fills):
            return replace(written, fills=tuple(replace(item, value=part(item.value)) for item in fills))
        case tree.Number() | tree.Duration() | tree.Truth() | tree.Text() | tree.Hole():
            return written
        case _:
            assert_never(written)


def taken_by(item: nodes.Heard, kind: str | None) -> Taken | None:
    """What the condition of `sent Pass p [p.to == 2]` knows as `p`, a message of the kind."""
    if item.called is None or kind is None:
        return None
    act = item.performative.text if item.performative is not None else "inform"
    return Taken(item.called.text, act, kind, False, item.called.span)


def _typed(checker: Checker, written: tree.Expression) -> Value | None:
    value, wrong = type_value(written, checker.scope)
    checker.diagnostics += wrong
    return value


@dataclass(slots=True)
class Check:
    """Goes through the statements of one scenario or property.

    `is_broken`: a part of it could not be read, which may have introduced what is not known then. `is_read`:
    all other declarations could be read.
    """

    known: Known
    agents: Mapping[str, str]
    is_listed: bool
    is_broken: bool
    is_read: bool
    is_scenario: bool = False
    given: frozenset[str] = frozenset()
    """The last names of what scenarios give to agents, or let activities write."""
    found: list[Diagnostic] = field(default_factory=list)
    parameters: dict[str, Type | None] = field(default_factory=dict)
    chosen: set[str] = field(default_factory=set)
    """The columns whose values are states."""

    def introduce(self, statements: Iterable[nodes.Statement]) -> None:
        """Look at what is said of agents and inputs, which all other statements may name."""
        for item in statements:
            if isinstance(item, nodes.TakesPart):
                self._takes_part(item)
            elif isinstance(item, nodes.Input | nodes.Table):
                self._inputs(item)

    def _takes_part(self, item: nodes.TakesPart) -> None:
        """`robot1, robot2 : player`"""
        role = model_name(item.role)
        if role not in self.known.states:
            self._unknown(problems.NoRoleInScenario, item.role, self.known.states)
            return
        in_team = self.known.agents if self.known.top.symbols.teams else {}
        for name, bounds in item.agents:
            if bounds is None and in_team.get(name.text, role) != role:
                self._report(problems.OtherRole(name.text, in_team[name.text]), item.role)

    def _inputs(self, item: nodes.Input | nodes.Table) -> None:
        """What a scenario is run with."""
        if isinstance(item, nodes.Input):
            self._input(item)
            return
        for column in item.columns:
            self._new(column)
        whole = [cells for cells, _ in item.rows if len(cells) == len(item.columns)]
        for cells, span in item.rows:
            if len(cells) != len(item.columns):
                columns = tuple(name.text for name in item.columns)
                self.found.append(Diagnostic(problems.RowOfOtherLength(columns, len(cells)), span))
        for name, cells in zip(item.columns, zip(*whole, strict=True), strict=False):
            self.parameters[name.text] = self._column(name, cells)

    def _column(self, name: tree.Name, cells: tuple[tree.Expression, ...]) -> Type | None:
        """The type of a column; None where it is one of states, or wrong."""
        single = [
            cell.segments[0] for cell in cells if isinstance(cell, tree.Path) and len(cell.segments) == 1
        ]
        if len(single) == len(cells) and not any(one.text in self.known.top.lets for one in single):
            self.chosen.add(name.text)
            for one in single:
                self._place(tree.Place(one, None, one.span), None)
            return None
        kind: Type | None = None
        for cell in cells:
            value, wrong = type_value(cell, self.known.top)
            self.found += wrong
            if value is None:
                return None
            if kind is None or (kind, value.type) == (INT, DOUBLE):
                kind = value.type
            elif (kind, value.type) != (DOUBLE, INT) and kind != value.type:
                self.found += type_value(cell, self.known.top, kind)[1]
                return None
        return kind

    def _input(self, item: nodes.Input) -> None:
        self._new(item.name)
        self.parameters[item.name.text] = None
        ends = []
        for written in (item.least, item.most):
            value, wrong = type_value(written, self.known.top)
            self.found += wrong
            if value is None:
                return
            ends.append(value)
        kinds = {value.type for value in ends}
        if not kinds <= {INT, DOUBLE} and kinds != {DURATION}:
            self._report(problems.UnsuitableInput(item.name.text), item)
            return
        self.parameters[item.name.text] = DOUBLE if DOUBLE in kinds else ends[0].type
        try:
            least, most = (fold(value) for value in ends)
        except (NotConstant, ArithmeticError):
            self._report(problems.UnsuitableInput(item.name.text), item)
            return
        assert not isinstance(least, str) and not isinstance(most, str)
        if most < least:
            span = item.least.span.to(item.most.span)
            problem = problems.UnsuitableRange(item.least.span.text, item.most.span.text)
            self.found.append(Diagnostic(problem, span))

    def _new(self, name: tree.Name) -> None:
        if name.text in self.parameters or name.text in self.agents:
            self._report(problems.InputTwice(name.text), name)
        self.parameters.setdefault(name.text, None)

    def statement(self, item: nodes.Statement) -> None:
        """Everything that a statement names."""
        match item:
            case nodes.TakesPart() | nodes.Input() | nodes.Table() | nodes.Setup():
                pass  # looked at before the others, or by the parser
            case nodes.Simulated():
                self._simulated(item)
            case nodes.Hit():
                self._event(item)
            case nodes.Timed():
                self._moments(item)
                only = only_agent(item)
                if item.of is not None:
                    self._condition(item.of, self.role_of(only))
                self._event(item.event)
                self._share(item.share)
            case nodes.Rule():
                only = only_agent(item)
                for condition in item.conditions:
                    if item.word == "never" or not isinstance(condition, nodes.Fault):
                        self._condition(condition, self.role_of(only))
                    else:
                        self._report(problems.FaultNotNever(), condition)
                self._share(item.share)
            case nodes.Several():
                role = None
                if item.role is not None and (role := model_name(item.role)) not in self.known.states:
                    self._unknown(problems.NoRoleInScenario, item.role, self.known.states)
                    return
                for place in item.places:
                    self._place(place, role)
                self._share(item.share)
            case nodes.Fails():
                self._agent(item.agent)
            case nodes.Assumed():
                self._activity(item.activity)
                self._ranges(item.times)
                if item.writes is not None:
                    self._channel(item.writes)
            case nodes.AssumedSo(condition=condition):
                self._condition(condition, self.role_of(condition.agent))
            case _:
                assert_never(item)

    # ---- parts of statements ---------------------------------------------------------------------

    def _simulated(self, item: nodes.Simulated) -> None:
        self._ranges((item.takes, *(pace for _, pace in item.writes)))
        if not self._activity(item.activity):
            return
        self._outcomes(item.activity.text, item.ends)
        for message in (*(message for message, _ in item.writes), *item.sends):
            self.fills(message)
        self._sets(item.activity.text, item.sets)

    def _outcomes(self, name: str, ends: Iterable[tree.Name]) -> None:
        activity = self.known.activities.get(name)
        there = activity.ends if activity is not None else ()
        for end in ends:
            if end.text not in there:
                self._unknown(problems.NoOutcomeOfActivity, end, there, name)

    def _sets(self, name: str, sets: Iterable[tuple[tree.Name, tree.Expression]]) -> None:
        """The variables that an activity sets."""
        roles = self.known.performed.get(name, frozenset())
        variables: dict[str, Type] = {}
        for role in sorted(roles):
            variables |= self.known.variables.get(role, {})
        for variable, value in sets:
            if variable.text not in variables:
                self._unknown(problems.NoVariableToSet, variable, variables, name)
                continue
            self.value(value, None, variables[variable.text])

    def _does(self, item: nodes.Does) -> None:
        """What an activity does by hand."""
        self._agent(item.agent)
        if not self._activity(item.activity):
            return
        self._outcomes(item.activity.text, () if item.outcome is None else (item.outcome,))
        for message in (*item.writes, *(sent for sent, _ in item.sends)):
            self.fills(message)
        for _, part in item.sends:
            if part.text not in self.known.processes:
                self._unknown(problems.NoParticipantInScenario, part, self.known.processes)
        for message in item.prepares:
            self.fills(message, is_content=True)
        for performative, taken in item.takes:
            self._performative(performative)
            self.carried(taken)
        self._sets(item.activity.text, item.sets)

    def _performative(self, name: tree.Name | None) -> None:
        if name is not None and name.text not in (*PERFORMATIVES, LOST):
            self.found.append(unknown_performative(name))

    def _moments(self, item: nodes.Timed) -> None:
        """`from 8s to 3s` is empty."""
        if item.word != "from" or len(item.times) < 2:
            return
        first, last = item.times
        if last.nanoseconds < first.nanoseconds:
            self._empty(first, last)

    def _ranges(self, times: Iterable[nodes.Lasts | None]) -> None:
        for item in times:
            if item is None or item.is_normal:
                continue
            if item.most.nanoseconds < item.least.nanoseconds:
                self._empty(item.least, item.most)

    def _empty(self, least: tree.Duration, most: tree.Duration) -> None:
        problem = problems.UnsuitableRange(least.span.text, most.span.text)
        self.found.append(Diagnostic(problem, least.span.to(most.span)))

    def _event(self, item: nodes.Event) -> None:
        match item:
            case nodes.Receives():
                self._agent(item.agent)
                self.fills(item.message)
                if item.sender is not None and not self._is_outside(item.sender):
                    self._agent(item.sender)
            case nodes.Raises():
                self._agent(item.agent)
                role = self.role_of(item.agent)
                events = self.known.events.get(role or "")
                if role is not None and events is not None and item.event.text not in events:
                    self._unknown(problems.NoEventOfRole, item.event, events, role)
            case nodes.Does():
                self._does(item)
            case nodes.Gets():
                self._agent(item.agent)
                self._agent(item.sender)
                self._performative(item.performative)
                if item.what is not None:
                    self.carried(item.what)
            case nodes.Computes():
                self._agent(item.agent)
                symbols = self.known.top.symbols
                function = next((one for one in symbols.functions if one.name == item.function.text), None)
                if function is None and item.function.text != "random":
                    names = (one.name for one in symbols.functions)
                    self._unknown(problems.NoFunctionInScenario, item.function, names)
                    return
                self.value(item.value, None, DOUBLE if function is None else function.result)
            case nodes.Hit():
                for agent in item.agents:
                    self._agent(agent)
            case nodes.Reached():
                self._condition(item.condition, self.role_of(only_agent(item)))
            case _:
                assert_never(item)

    def _is_outside(self, name: tree.Name) -> bool:
        """`from input`; or from an agent of the team that does not take part."""
        return name.text == "input" or name.text in self.known.agents

    def _share(self, item: nodes.Share | None) -> None:
        if item is None:
            return
        percent = item.percent.value if isinstance(item.percent, tree.Number) else 0
        seeds = item.seeds.value if isinstance(item.seeds, tree.Number) else 0
        if not 0 < percent <= 100 or not isinstance(seeds, int) or seeds < 1:
            self._report(problems.UnsuitableShare(), item)

    def _condition(self, written: nodes.Condition, role: str | None) -> None:
        todo = [written]
        while todo:
            item = todo.pop()
            match item:
                case nodes.Joined():
                    todo += reversed(item.parts)
                case nodes.InState():
                    if item.agent is None:
                        self._bare(item, role)
                    elif self._agent(item.agent):
                        for place in item.places:
                            self._place(place, self.role_of(item.agent))
                case nodes.Holds():
                    if item.agent is None:
                        self._bare_truth(item, item.expression, role)
                    elif self._agent(item.agent):
                        self._truth(item.expression, self.role_of(item.agent) or role)
                case nodes.Heard():
                    self._heard(item, role)
                case nodes.Ended():
                    if self.is_read and item.text.text not in self.known.outcomes:
                        name = tree.Name(item.text.text, item.text.span)
                        wrong = unknown(problems.NoOutcomeOfProtocols, name, self.known.outcomes)
                        self.found.append(replace(wrong, fix=None))
                case nodes.Fault():
                    pass
                case _:
                    assert_never(item)

    def _bare(self, item: nodes.InState, role: str | None) -> None:
        """A name alone is a state, else a condition that has this name."""
        for place in item.places:
            name = place.name
            if self.is_value(place, role):
                self._bare_truth(item, tree.Path((name,), name.span), role)
            elif place.at is None and name.text in self.known.processes:
                pass  # a participant, as in a clause
            elif place.at is None and name.text in self.agents and not self._is_state(name.text):
                self._report(problems.AgentAlone(name.text), name)
            else:
                self._place(place, None)

    def _bare_truth(
        self, item: nodes.Holds | nodes.InState, written: tree.Expression, role: str | None
    ) -> None:
        """In a scenario, a bare condition is about the agent that its sentence names, or the only one."""
        before = len(self.found)
        self._truth(written, role)
        if role is None and self.is_scenario and len(self.agents) > 1 and len(self.found) == before:
            self._report(problems.WhichAgent(tuple(self.agents), written.span.text), item)

    def is_value(self, place: tree.Place, role: str | None) -> bool:
        """Whether a name alone is a condition."""
        scope, name = self.scope(role), place.name.text
        is_known = name in scope.variables or name in scope.lets or name in scope.parameters
        return place.at is None and is_known and name not in self.chosen and not self._is_state(name)

    def _is_state(self, name: str) -> bool:
        return any(states is not None and name in states for states in self.known.states.values())

    def _truth(self, written: tree.Expression, role: str | None) -> None:
        segments = written.segments if isinstance(written, tree.Path) else ()
        if len(segments) == 3 and self.known.top.symbols.topic(segments[0].text) is not None:
            self._report(problems.MessageAlone(written.span.text), written)
            return
        value = self.value(written, role, BOOL)
        if value is not None and self.is_read and role is not None and role in self.known.held:
            self._is_held(value, role, written.span)

    def _is_held(self, value: Value, role: str, place: Span) -> None:
        """W231 for a message that an agent of the role never has; of each channel once."""
        told: set[Channel] = set()
        for part in walk(value):
            if not isinstance(part, Member) or part.channel in told | self.known.held[role]:
                continue
            told.add(part.channel)
            if str(part.channel).rpartition(".")[2].rpartition("_")[2] not in self.given:
                problem = problems.NeverHasMessage(role, str(part.channel))
                is_here = part.span.source is place.source and place.start <= part.span.start < place.end
                self.found.append(Diagnostic(problem, part.span if is_here else place))

    def value(
        self,
        written: tree.Expression,
        role: str | None,
        expected: Type | None = None,
        taken: Taken | None = None,
    ) -> Value | None:
        """An expression with its type, as an agent of the role means it; None if it is wrong."""
        found, wrong = type_value(self._own(written), replace(self.scope(role), taken=taken), expected)
        self.found += wrong if role is not None else [self._with_agent(item, written) for item in wrong]
        return found

    def _with_agent(self, wrong: Diagnostic, written: tree.Expression) -> Diagnostic:
        """What is wrong with a condition that names no agent: a name may be a variable of one."""
        if not isinstance(wrong.problem, NoVariableOrLet | NoBeginning):
            return wrong
        name = wrong.problem.name
        owners = tuple(agent for agent, role in self.agents.items() if name in self.scope(role).variables)
        if not owners:
            return wrong
        return Diagnostic(problems.VariableWithoutAgent(name, owners, written.span.text), wrong.span)

    def _heard(self, item: nodes.Heard, role: str | None) -> None:
        if item.performative is not None and item.performative.text not in PERFORMATIVES:
            self.found.append(unknown_performative(item.performative))
        kind = self.carried(item.what)
        if item.agent is not None:
            self._agent(item.agent)
        if item.condition is None:
            return
        if item.called is None or kind is not None:
            self.value(item.condition, role, BOOL, taken_by(item, kind))

    # ---- names -----------------------------------------------------------------------------------

    def _agent(self, name: tree.Name) -> bool:
        """An agent, or a role behind `any`, `some` and `every`."""
        if name.text in self.agents or model_name(name) in self.known.states:
            return True
        self._unknown(problems.NoAgentInScenario, name, self.agents, self.is_listed)
        return False

    def role_of(self, name: tree.Name | None) -> str | None:
        if name is None:
            return None
        if name.text in self.agents:
            return self.agents[name.text]
        return name.text if name.text in self.known.states else None

    def _place(self, place: tree.Place, role: str | None) -> None:
        """A state of a role (of any, if None), in a participant if the place says so."""
        name = place.name
        if name.text in self.chosen and place.at is None:
            return
        states = self._states_of(role)
        if states is None:
            return
        if place.at is not None:
            process = self.known.processes.get(place.at.text)
            if process is None:
                is_player = place.at.text in self.known.agents or model_name(place.at) in self.known.states
                instead = f"{place.at.text} in {name.text}" if is_player else ""
                self._unknown(problems.NoParticipantInScenario, place.at, self.known.processes, instead)
            elif name.text not in process:
                self._unknown(problems.NoStateOfParticipant, name, process, place.at.text)
        elif name.text not in states:
            self._unknown(problems.NoStateOfRole, name, states, role or "")

    def _states_of(self, role: str | None) -> frozenset[str] | None:
        """None where a chart is missing: then nothing can be said."""
        if role is not None:
            return self.known.states.get(role)
        playing = set(self.agents.values()) if self.is_listed else set(self.known.states)
        found: set[str] = set()
        for name in playing:
            states = self.known.states.get(name)
            if states is None:
                return None
            found |= states
        return frozenset(found)

    def _activity(self, name: tree.Name) -> bool:
        if name.text in self.known.performed:
            return True
        if None not in self.known.states.values():
            self._unknown(problems.NoActivityInScenario, name, self.known.performed)
        return False

    def fills(self, item: nodes.Filled, *, is_content: bool = False) -> list[Fill]:
        """The members of a message that are given, or only of the content of one."""
        if item.performative is not None and item.performative.text not in PERFORMATIVES:
            self.found.append(unknown_performative(item.performative))
        kind = self.carried(item.what)
        if kind is None:
            return []
        if item.performative is None and len(item.what.segments) == 1 and not is_content:
            self._report(problems.NeitherMessage(kind), item.what)
        checker = Checker(self.scope(None))
        fills = tuple(replace(one, value=self._own(one.value)) for one in item.fills)
        found = fill(checker, kind, fills, _typed)
        self.found += checker.diagnostics
        return found or []

    def carried(self, path: tree.Path) -> str | None:
        """The type of message that a channel carries, or that is named."""
        if len(path.segments) > 1:
            return self._channel(path)
        name = path.segments[0]
        symbols = self.known.top.symbols
        if symbols.message(name.text) is not None:
            return name.text
        self._unknown(problems.NoMessageInScenario, name, (item.name for item in symbols.messages))
        return None

    def _channel(self, path: tree.Path) -> str | None:
        found = self.channel(path)
        return None if found is None else found.message

    def channel(self, path: tree.Path) -> Channel | None:
        """The channel that a path names."""
        checker = Checker(self.known.top)
        found = channel_of(checker, self._meant(path))
        self.found += checker.diagnostics
        return None if found is None else found[1]

    def scope(self, role: str | None) -> Scope:
        typed = self.known.scopes.get(role or "")
        scope = self.known.top if typed is None else typed.scope
        variables = {**self.known.of_parts.get(role or "", {}), **scope.variables}
        return replace(scope, variables=variables, parameters={**scope.parameters, **self.parameters})

    def _own(self, written: tree.Expression) -> tree.Expression:
        """An expression whose paths mean what they mean here (see `_meant`)."""
        return _with_paths(written, self._meant)

    def _meant(self, path: tree.Path) -> tree.Path:
        """The path with an input of a dotted name, as `ball.distance`, as one name.

        On a topic of a file with an alias, messages have the alias before them in the models only.
        """
        if path.text in self.parameters:
            return tree.Path((tree.Name(path.text, path.span),), path.span)
        segments = path.segments
        topic = self.known.top.symbols.topic(segments[0].text)
        if topic is None or len(segments) < 3 or segments[1].text not in COMM_TYPES:
            return path
        comm, name = segments[1].text, segments[2].text
        carried = [item.channel.message for item in topic.channels if item.channel.comm == comm]
        behind = [item for item in carried if item.endswith(f"_{name}")]
        if name in carried or len(behind) != 1 or not topic.name.startswith(behind[0][: -len(name)]):
            return path
        named = tree.Name(behind[0], segments[2].span)
        return tree.Path((*segments[:2], named, *segments[3:]), path.span)

    # ---- reports ---------------------------------------------------------------------------------

    def _unknown(
        self, problem: type[Absent], name: tree.Name, others: Iterable[str], *values: object
    ) -> None:
        if not self.is_read or (self.is_broken and problem is problems.NoAgentInScenario):
            return
        if not self.known.top.symbols.is_excused(name.text):
            self.found.append(unknown(problem, name, others, *values))

    def _report(
        self,
        problem: Problem,
        at: tree.Name | tree.Expression | nodes.Statement | nodes.Condition | nodes.Share,
    ) -> None:
        self.found.append(Diagnostic(problem, at.span))


__all__ = [
    "Check",
    "Known",
    "check_statements",
    "known_by",
    "model_name",
    "only_agent",
    "properties",
    "scenarios",
    "taken_by",
]
