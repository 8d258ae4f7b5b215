"""A statechart to the text of its plan: the declarative face that people and tools read."""

from __future__ import annotations

import hashlib
import re
from collections.abc import Iterable, Mapping, Sequence

from aseme_dsl.amola import expression as e
from aseme_dsl.amola.aip import Participant
from aseme_dsl.amola.messages import DOUBLE, DURATION, INT, PROBE, Kind, Topic
from aseme_dsl.amola.srm import Activity, Module
from aseme_dsl.amola.statechart import (
    State,
    Statechart,
    Transition,
    TransitionKind,
    Variable,
    transition_text,
)
from aseme_dsl.amola.system import Agent, System
from aseme_dsl.codegen.automaton import TooManyStates, automaton_of
from aseme_dsl.codegen.code.values import function_key
from aseme_dsl.codegen.moves import farewells_of, moves_of, subchart_of
from aseme_dsl.codegen.opening import openings_of
from aseme_dsl.codegen.place import place
from aseme_dsl.codegen.program.flat import FlatChart
from aseme_dsl.codegen.program.uses import retention

Term = tuple[object, ...]

Sections = list[tuple[str, list[str]]]
"""The parts of a plan as (keyword of Plan, source lines of the items)."""


def value_term(value: e.Value) -> Term:
    """A value as the nested tuple that `runtime/chart/plan.py` describes."""
    match value:
        case e.Named(expression=inner):
            return value_term(inner)
        case e.Literal(value=constant, type=kind):
            return ("const", None if kind.begins_unset else constant)
        case e.EnumConstant(type=kind, constant=constant, number=number):
            return ("enum", kind.name, constant, number)
        case e.VariableValue(name=name, path=path):
            return ("variable", name, path) if path else ("variable", name)
        case e.ParameterValue(name=name):
            raise AssertionError(f"{name} is replaced where its formula is expanded")
        case e.Member(host=host, channel=channel, path=path):
            return ("member", host, str(channel), path)
        case e.Bound(path=path):
            return ("taken", path)
        case e.Sender():
            return ("sender",)
        case e.LossReason():
            return ("reason",)
        case e.Call(function=function, arguments=arguments):
            values = tuple(value_term(argument) for argument in arguments)
            if function.target == PROBE:
                return values[-1]
            if function.target.startswith("builtin:"):
                return ("builtin", function.target[8:], *values)
            return ("call", function_key(value), *values)
        case e.ListValue(elements=elements):
            return ("list", *(value_term(element) for element in elements))
        case e.Element(list=whole, index=index, path=path):
            return ("element", value_term(whole), value_term(index), path)
        case e.Size(list=whole):
            return ("size", value_term(whole))
        case e.Contains(list=whole, value=wanted, path=path):
            return ("contains", value_term(whole), value_term(wanted), *((path,) if path else ()))
        case e.Find(list=whole, value=wanted, path=path):
            return ("find", value_term(whole), value_term(wanted), *((path,) if path else ()))
        case e.Changed(change=change, list=whole, given=given):
            return (change.value, value_term(whole), *map(value_term, given))
        case e.NewMessage(message=message, fills=fills, rest=rest, taken=taken):
            filled = tuple((item.path, value_term(item.value)) for item in fills)
            return ("new", message, filled, None if rest is None else (value_term(rest), taken))
        case e.Has(message=message):
            return ("has", value_term(message))
        case e.Age(message=message):
            return ("age", value_term(message))
        case e.At(message=message, offset=offset):
            return ("at", value_term(message), value_term(offset))
        case e.Mean(message=message, window=window):
            return ("mean", value_term(message), value_term(window))
        case e.Expired(timer=timer):
            return ("expired", timer)
        case e.Outcome(activity=activity):
            return ("outcome", activity)
        case e.Index():
            return ("index",)
        case e.Random():
            return ("random",)
        case e.StateValue(question=question, state=state):
            return (question, state)
        case e.RoundValue(question=question, participant=participant):
            return (question, participant)
        case e.Holds(operand=operand):
            return ("holds", value_term(operand))
        case e.Not(operand=operand):
            return ("!", value_term(operand))
        case e.Logic(operator=operator, operands=parts):
            return (operator, *(value_term(part) for part in parts))
        case e.Compare(operator=operator, left=left, right=right):
            return (operator, value_term(left), value_term(right))
        case e.Arithmetic():
            return _arithmetic(value)
        case e.Conditional(condition=condition, yes=yes, no=no):
            return ("?", value_term(condition), value_term(yes), value_term(no))
        case e.Negate(operand=operand):
            return ("neg", value_term(operand))


def _arithmetic(value: e.Arithmetic) -> Term:
    operator = value.operator
    kinds = (value.left.type, value.right.type)
    if value.type == DURATION and operator == "/" and kinds[1] == INT:
        operator = "//"
    term = (operator, value_term(value.left), value_term(value.right))
    return ("duration", term) if value.type == DURATION and DOUBLE in kinds else term


def event_term(event: e.Event) -> Term:
    """An event as a tuple."""
    match event:
        case e.After(duration=duration):
            return ("after", duration)
        case e.Received(performative=performative, message=message, participant=participant):
            return ("received", performative, message, participant)
        case e.Lost(participant=participant):
            return ("lost", participant)
        case e.Raised(name=name):
            return ("raised", name)
        case e.Failed():
            return ("error",)


def action_term(action: e.Action) -> Term:
    """An action as a tuple."""
    match action:
        case e.Assign(target=e.VariableValue(name=name), value=value):
            return ("assign", name, value_term(value))
        case e.Assign(target=target, value=value):
            return ("fill", value_term(target), value_term(value))
        case e.Publish(channel=channel):
            return ("publish", str(channel))
        case e.ReadMessages():
            return ("read_messages",)
        case e.StartTimer(timer=timer, duration=duration):
            return ("start_timer", timer, value_term(duration))
        case e.Send(performative=performative, message=message, participant=participant):
            said: Term = ("send", performative, message, participant)
            is_more = action.rest is not None or action.reply_by is not None or action.one
            if action.fills is None and action.to is None and not action.excepts and not is_more:
                return said
            fills = None
            if action.fills is not None:
                fills = tuple((item.path, value_term(item.value)) for item in action.fills)
            to = None if action.to is None else value_term(action.to)
            said = (*said, fills, to, tuple(value_term(item) for item in action.excepts))
            if not is_more:
                return said
            rest = None if action.rest is None else (value_term(action.rest), action.taken)
            reply_by = None if action.reply_by is None else value_term(action.reply_by)
            return (*said, rest, reply_by, action.one)
        case e.Raise(name=name):
            return ("raise", name)
        case e.Evaluate(value=value):
            return ("evaluate", value_term(value))


def _call(name: str, required: Sequence[object], optional: Iterable[tuple[str, object, object]]) -> str:
    """`name(…)` with the required arguments by place, the others by name where they are not the default."""
    parts = [repr(item) for item in required]
    parts += [f"{key}={value!r}" for key, value, default in optional if value != default]
    return f"{name}({', '.join(parts)})"


def _state(node: State, flat: FlatChart, placed: bool = True) -> str:
    branch = f"{node.origin.owner}.{node.origin.name}" if flat.chart.is_branch(node) else None
    return _call(
        "State",
        [node.label, node.name, node.type.value],
        [
            ("parent", node.parent, None),
            ("activity", node.activity, None),
            ("arguments", _given(node), ()),
            ("branch", branch, None),
            ("at", place(node.span) if placed else "", ""),
        ],
    )


def _given(node: State) -> tuple[tuple[str, Term], ...]:
    """What the activity of a state is given, by parameter."""
    if node.activity is None:
        return ()
    return tuple((item.name, value_term(item.value)) for item in node.arguments)


def _transition(transition: Transition, placed: bool = True) -> str:
    expression = transition.expression
    condition = None if expression.condition is None else value_term(expression.condition)
    return _call(
        "Transition",
        [transition.source, transition.target],
        [
            ("priority", transition.priority, 0),
            ("events", tuple(event_term(event) for event in expression.events), ()),
            ("when", expression.when, False),
            ("otherwise", expression.otherwise, False),
            ("every", expression.every, None),
            ("condition", condition, None),
            ("weight", expression.weight, None),
            ("actions", tuple(action_term(action) for action in expression.actions), ()),
            ("first", transition.first, False),
            ("kind", transition.kind.value, "external"),
            ("resume", transition.resume, False),
            ("into", transition.into, ()),
            ("text", transition_text(transition), ""),
            ("at", place(transition.span) if placed else "", ""),
        ],
    )


def _variable(system: System, variable: Variable) -> str:
    initial = None if variable.type.begins_unset else _constant(system, variable.initial)
    bounds = None if variable.bounds is None else (variable.bounds.least, variable.bounds.most)
    return _call(
        "Variable",
        [variable.name, str(variable.type), initial],
        [("scope", variable.scope, None), ("bounds", bounds, None), ("length", variable.length, None)],
    )


def _topics_reached(system: System, name: str, reach: str) -> list[Topic]:
    """The topics that a subscription means: the one it names and, by its reach, those above or below it."""
    parents = {topic.name: topic.under for topic in system.topics}

    def is_above(upper: str, lower: str) -> bool:
        seen: set[str] = set()
        topic = parents.get(lower)
        while topic is not None and topic not in seen:
            if topic == upper:
                return True
            seen.add(topic)
            topic = parents.get(topic)
        return False

    return [
        topic
        for topic in system.topics
        if topic.name == name
        or (reach in ("above", "around") and is_above(topic.name, name))
        or (reach in ("below", "around") and is_above(name, topic.name))
    ]


def _read(system: System, activity: Activity) -> tuple[str, ...]:
    """The channels that an activity reads, topics spelled out; those of a sender under its name, too."""
    found: list[str] = []
    for read in activity.reads:
        if read.channel is not None:
            found.append(str(read.channel))
            if read.host is not None:
                found.append(f"{read.host}.{read.channel}")
        else:
            topics = _topics_reached(system, read.topic, read.reach)
            found += [str(rules.channel) for topic in topics for rules in topic.channels]
    return tuple(dict.fromkeys(found))


def _histories(activity: Activity) -> tuple[tuple[str, int], ...]:
    """How far the activity looks back at each data channel, in ns."""
    found: dict[str, int] = {}
    for read in activity.reads:
        if read.channel is not None and read.history:
            found[str(read.channel)] = max(found.get(str(read.channel), 0), read.history)
    return tuple(found.items())


def _activity(system: System, activity: Activity) -> str:
    return _call("ActivityInfo", [activity.name], _statement(system, activity))


def _module(system: System, module: Module) -> str:
    target = [("target", module.target, "")]
    return _call("ModuleInfo", [module.name], [*_statement(system, module.statement), *target])


def _statement(system: System, activity: Activity) -> list[tuple[str, object, object]]:
    """What is said of an activity or a module, with the defaults."""
    return [
        ("kind", activity.kind or "thread", "thread"),
        ("every", activity.every, None),
        ("takes", activity.takes, None),
        ("simulated", activity.simulated, False),
        ("waits", activity.waits, False),
        ("reads", _read(system, activity), ()),
        ("writes", tuple(str(channel) for channel in activity.writes), ()),
        ("variables", activity.writes_variables, ()),
        ("reads_variables", activity.reads_variables, ()),
        ("histories", _histories(activity), ()),
        ("parameters", tuple((item.name, str(item.type)) for item in activity.parameters), ()),
        ("within", activity.within, None),
        ("ends", activity.ends, ()),
    ]


def _participant(system: System, protocol: str, name: str) -> Participant | None:
    aip = next((item for item in system.aips if item.name == protocol), None)
    return aip.participant(name) if aip else None


def plan_sections(system: System, chart: Statechart, versions: Mapping[str, str] | None = None) -> Sections:
    """The parts of the plan.

    `versions` is `protocol_versions(system)`: pass it to make the plans of many charts without repeated work.
    """
    flat = FlatChart(chart)
    kept = retention(system, chart)
    used = {node.activity for node in chart.states if node.activity}
    activities = [item for item in system.activities if item.name in used]
    channels = {str(c) for region in chart.regions for c in (*region.reads, *region.writes)}
    functions = {
        function_key(value): value.function
        for _, value in chart.values()
        if isinstance(value, e.Call) and value.function.is_of_document
    }
    sections = [
        ("states", [_state(node, flat) for node in chart.states]),
        ("transitions", [_transition(transition) for transition in chart.transitions]),
        (
            "variables",
            [_variable(system, v) for v in chart.variables],
        ),
        (
            "regions",
            [
                _call(
                    "Region",
                    [region.label],
                    [
                        ("reads", tuple(sorted(map(str, region.reads))), ()),
                        ("writes", tuple(sorted(map(str, region.writes))), ()),
                    ],
                )
                for region in chart.regions
            ],
        ),
        ("activities", [_activity(system, activity) for activity in activities]),
        ("modules", [_module(system, module) for module in chart.modules]),
        (
            "channels",
            [
                _call(
                    "ChannelInfo",
                    [str(rules.channel), rules.channel.message],
                    [
                        ("queued", rules.queued, False),
                        ("retention", kept.get(str(rules.channel), 0), 0),
                        ("every", rules.every, None),
                        ("persist", rules.persist, False),
                        ("expires", rules.expires, None),
                        ("sources", rules.sources, ()),
                        ("radio", topic.radio, None),
                        ("delay", topic.delay or 0, 0),
                    ],
                )
                for topic in system.topics
                for rules in topic.channels
                if str(rules.channel) in channels
            ],
        ),
        (
            "functions",
            [
                repr((key, found.target, str(found.result), place(found.span)))
                for key, found in sorted(functions.items())
            ],
        ),
        ("branches", _branches(system, chart, flat, versions)),
        ("settings", [repr(item) for item in _settings(system, chart)]),
        ("numbers", [repr(item) for item in _numbers(system, chart)]),
    ]
    return [(name, items) for name, items in sections if items]


def _agents(system: System, chart: Statechart) -> list[Agent]:
    """The agents that have the role of a chart, whose names are those of the first team that has them."""
    agents = {agent.name: agent for team in reversed(system.teams) for agent in reversed(team.agents)}
    return [agent for agent in reversed(agents.values()) if agent.role == chart.name]


def _settings(system: System, chart: Statechart) -> list[tuple[str, str, object]]:
    """What the variables of the role hold at first in its agents."""
    return [
        (agent.name, name, _constant(system, literal))
        for agent in _agents(system, chart)
        for name, literal in agent.settings
    ]


def _numbers(system: System, chart: Statechart) -> list[tuple[str, int]]:
    """The numbers of the agents that have another than 1, if the chart asks for them."""
    if not any(isinstance(value, e.Index) for _, value in chart.values()):
        return []
    return [(agent.name, agent.index) for agent in _agents(system, chart) if agent.index != 1]


def _constant(system: System, literal: e.Literal) -> object:
    enum = system.enum(literal.type.name)
    if literal.type.kind is Kind.LIST:
        return ()
    return literal.value if enum is None else dict(enum.constants)[str(literal.value)]


def _branches(
    system: System, chart: Statechart, flat: FlatChart, versions: Mapping[str, str] | None
) -> list[str]:
    if versions is None:
        versions = protocol_versions(system) if flat.branches else {}
    return [_branch(system, chart, flat, node, versions.get(node.origin.owner, "")) for node in flat.branches]


def _branch(system: System, chart: Statechart, flat: FlatChart, node: State, version: str) -> str:
    participant = _participant(system, node.origin.owner, node.origin.name)
    sends = tuple((m.performative, m.message) for m in participant.sends) if participant else ()
    receives = tuple((m.performative, m.message) for m in participant.receives) if participant else ()
    return _call(
        "BranchInfo",
        [node.label, node.origin.owner, node.origin.name],
        [
            ("sends", sends, ()),
            ("receives", receives, ()),
            ("moves", _moves(system, node, participant), ()),
            ("opens", _opens(system, node, participant), ()),
            ("version", version, ""),
            ("loses", _lost_in(chart, node.label), ()),
            ("counts", _counted_in(chart, node.label), ()),
            ("participants", _sizes(system, node.origin.owner), ()),
            ("busy", _busy(system, chart, flat, node), None),
        ],
    )


def _busy(
    system: System, chart: Statechart, flat: FlatChart, branch: State
) -> tuple[str, str, tuple[tuple[tuple[str, ...], object], ...] | None] | None:
    """What invitations are answered, as the participant around the branch says it, or the role."""
    plays = [item for srm in system.srms if srm.name == chart.name for item in srm.plays]
    for around in flat.branches:
        if branch.label.startswith(f"{around.label}."):
            participant = _participant(system, around.origin.owner, around.origin.name)
            plays = [*(participant.plays if participant is not None else ()), *plays]
    for item in plays:
        if (item.protocol, item.participant) == (branch.origin.owner, branch.origin.name):
            busy = item.busy
            if busy is None:
                continue
            if not busy.performative:
                return None
            fills = None
            if busy.fills is not None:
                fills = tuple(
                    (fill.path, _constant(system, fill.value))
                    for fill in busy.fills
                    if isinstance(fill.value, e.Literal)
                )
            return busy.performative, busy.message, fills
    return None


def _opens(system: System, branch: State, participant: Participant | None) -> tuple[tuple[str, str], ...]:
    """What can be the first message that a participant takes."""
    eac = system.eac(branch.origin.owner)
    return () if eac is None or participant is None else openings_of(eac, participant)


def _moves(
    system: System, branch: State, participant: Participant | None
) -> tuple[tuple[str, str, tuple[str, ...], bool], ...]:
    """What activities of a branch may send, with the labels of their states in the role."""
    eac = system.eac(branch.origin.owner)
    if eac is None or participant is None:
        return ()
    return tuple(
        (
            item.performative,
            item.message,
            tuple(branch.label + state for state in item.states),
            item.repeatedly,
        )
        for item in moves_of(eac, participant)
    )


def _sizes(system: System, protocol: str) -> tuple[tuple[str, int, int | None], ...]:
    aip = next((aip for aip in system.aips if aip.name == protocol), None)
    return () if aip is None else tuple((item.name, item.least, item.most) for item in aip.participants)


def _lost_in(chart: Statechart, branch: str) -> tuple[str, ...]:
    """The participants whose loss a transition of a branch waits for."""
    inside = (item for item in chart.transitions if chart.conversation_of(item) == branch)
    events = (event for item in inside for event in item.expression.events)
    return tuple(dict.fromkeys(event.participant for event in events if isinstance(event, e.Lost)))


def _counted_in(chart: Statechart, branch: str) -> tuple[str, ...]:
    """The participants whose answers a transition of a branch counts."""
    inside = (item for item in chart.transitions if chart.conversation_of(item) == branch)
    values = (value for item in inside for value in e.values_of(item.expression))
    return tuple(dict.fromkeys(value.participant for value in values if isinstance(value, e.RoundValue)))


def protocol_versions(system: System) -> dict[str, str]:
    """A hash of each protocol, by name: of its participants' automata, and then of its messages.

    Agents of one team that are swapped apart can take part in the same conversation if they have the same
    hash. The hash does not depend on activities and their bindings, on conditions and durations, or on the
    nesting of states.
    """
    messages = {item.name: item for item in system.messages}
    order = {name: number for number, name in enumerate(messages)}
    found: dict[str, str] = {}
    for aip in system.aips:
        eac = system.eac(aip.name)
        parts: list[str] = []
        named: set[str] = set()
        for participant in aip.participants:
            parts.append(participant.name)
            if eac is not None:
                parts.append(_spoken(system, eac, participant))
            named.update(item.message for item in (*participant.sends, *participant.receives))
        said: list[str] = []
        for name in sorted(named & messages.keys(), key=order.__getitem__):
            fields = [(f.name, f.label, str(f.type)) for f in messages[name].fields]
            said.append(repr((name, fields)))
        found[aip.name] = _digest(parts) + _digest(said)
    return found


def _digest(parts: list[str]) -> str:
    return hashlib.sha256("\0".join(parts).encode()).hexdigest()[:16]


def _spoken(system: System, eac: Statechart, participant: Participant) -> str:
    """What a participant says, in which order; where that is too large to be compared, all that it does."""
    try:
        automaton = automaton_of(eac, participant)
    except TooManyStates:
        subchart = subchart_of(eac, participant.name)
        return "" if subchart is None else _branch_text(system, eac, FlatChart(eac), subchart)
    subchart = subchart_of(eac, participant.name)
    farewells = farewells_of(eac, subchart.label) if subchart is not None else ()
    sent = [(item.performative, item.message, item.participant) for item in farewells]
    return repr((automaton.ways, sorted(automaton.ends), *([sent] if sent else [])))


def _branch_text(system: System, chart: Statechart, flat: FlatChart, branch: State) -> str:
    """All that a branch is, with its labels as if it were a root."""
    inside = [n for n in chart.states if n.label == branch.label or n.label.startswith(branch.label + ".")]
    labels = {node.label for node in inside}
    used = {node.activity for node in inside}
    items = [
        *(_state(node, flat, placed=False) for node in inside),
        *(
            _transition(transition, placed=False)
            for transition in chart.transitions
            if transition.source in labels
            and (transition.source != branch.label or transition.kind is TransitionKind.ABANDON)
        ),
        *(_variable(system, variable) for variable in chart.variables if variable.scope in labels),
        *(_activity(system, activity) for activity in system.activities if activity.name in used),
    ]
    around = branch.parent or ""
    text = "\n".join((branch.origin.name, *items)).replace(f"parent={around!r}", "")
    return re.sub(rf"(?<![\w.]){re.escape(branch.label)}(?![\w])", "~", text)
