"""Elements: what a system consists of: each with a text that is equal if it means the same."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator
from dataclasses import fields, is_dataclass

from aseme_dsl.amola.aip import Participant
from aseme_dsl.amola.expression import TransitionExpression, action_text, events_text, value_text
from aseme_dsl.amola.liveness import Formula, canonical
from aseme_dsl.amola.srm import Activity
from aseme_dsl.amola.statechart import OriginKind, Statechart, StateType, Transition, transition_text
from aseme_dsl.amola.system import System
from aseme_dsl.records import dataclass
from aseme_dsl.source import Source, Span, is_library_path


@dataclass(frozen=True, slots=True)
class Element:
    """Something that a document says.

    `owner` is what it belongs to: a role, a protocol, a participant (`attack.center`), or nothing. `meaning`
    is equal for two that mean the same, `text` is for readers. What does not `matter` to runs is for readers
    of the document only. `whole` is the text with what each `let` in it stands for.
    """

    kind: str
    owner: str
    name: str
    meaning: str
    text: str
    span: Span
    matters: bool = True
    whole: str = ""

    @property
    def key(self) -> tuple[str, str, str]:
        return self.kind, self.owner, self.name

    @property
    def title(self) -> str:
        return f"{self.kind} {self.name}" + (f" of {self.owner}" if self.owner else "")


def elements_of(system: System) -> tuple[Element, ...]:
    """All that a system consists of, in the order of the models, but for the standard library."""
    found = (*_requirements(system), *_messages(system), *_parts(system), *_team(system))
    charts = [item for chart in system.statecharts for item in _chart(chart)]
    known: dict[tuple[str, str, str], Element] = {}
    for item in (*found, *charts):
        if not is_library_path(item.span.source.path):
            known.setdefault(item.key, item)
    return tuple(known.values())


def _requirements(system: System) -> Iterator[Element]:
    for goal in system.sag.goals:
        yield _element("goal", goal.depender, goal.name, goal, matters=False)
    for role in system.suc.roles:
        yield _element("use case role", "", role.name, role.type.value, role.span, matters=False)
    for case in system.suc.usecases:
        yield _element("use case", "", case.name, case, matters=False)


def _messages(system: System) -> Iterator[Element]:
    for enum in system.enums:
        said = " ".join(name for name, _ in enum.constants)
        yield _element("enum", "", enum.name, enum, text=f"{{ {said} }}")
    for message in system.messages:
        said = " ".join(f"{item.label} {item.type} {item.name}".lstrip() for item in message.fields)
        yield _element("message", "", message.name, message, text=f"{{ {said} }}")
    for topic in system.topics:
        for rules in topic.channels:
            about = (rules, topic.under, topic.radio, topic.delay)
            yield _element("channel", "", str(rules.channel), about, rules.span)
    for function in system.functions:
        name = f"{function.name}({', '.join(str(kind) for _, kind in function.parameters)})"
        if function.is_of_document:
            yield _element("function", "", name, function)


def _parts(system: System) -> Iterator[Element]:
    for activity in system.activities:
        yield _element("activity", "", activity.name, activity, text=_activity(activity))
    for aip in system.aips:
        yield _element("protocol", "", aip.name, (), aip.span)
        for clause in aip.clauses:
            yield _element("clause", aip.name, clause.text, clause, matters=False)
        for outcome in aip.outcomes:
            when = f"when {' or '.join(outcome.when)}" if outcome.when else "without `when`"
            yield _element("outcome", aip.name, outcome.text, outcome, aip.span, text=when, matters=False)
        for part in aip.participants:
            yield from _participant(aip.name, part)
    for srm in system.srms:
        yield _element("role", "", srm.name, (), srm.span)
        for plays in srm.plays:
            yield _element("part", srm.name, f"{plays.protocol}.{plays.participant}", plays, text=plays.text)
        for variable in srm.variables:
            yield _element("variable", srm.name, variable.name, variable, text=variable.text)
        for module in srm.modules:
            said = _activity(module.statement)
            yield _element("module", srm.name, module.name, module, module.statement.span, text=said)
        for formula in srm.formulas:
            said = f"{formula.name} = {canonical(formula.formula)}"
            yield _element("formula", srm.name, formula.name, formula, text=said)


def _participant(protocol: str, part: Participant) -> Iterator[Element]:
    owner = f"{protocol}.{part.name}"
    most = "*" if part.most is None else part.most
    about = (part.least, part.most, part.inputs, part.results, part.plays)
    yield _element("participant", protocol, part.name, about, part.span, text=f"[{part.least}..{most}]")
    for text in part.engage:
        yield _element("engagement rule", owner, text, (), part.span, matters=False)
    for variable in part.variables:
        yield _element("variable", owner, variable.name, variable, text=variable.text)
    for kind, messages in (("sent message", part.sends), ("received message", part.receives)):
        for item in messages:
            yield _element(kind, owner, f"{item.performative} {item.message}".strip(), item)
    for formula in part.formulas:
        said = f"{formula.name} = {canonical(formula.formula)}"
        yield _element("formula", owner, formula.name, formula, text=said)


def _team(system: System) -> Iterator[Element]:
    for team in system.teams:
        for agent in team.agents:
            yield _element(
                "agent", team.name, agent.name, agent, text=_agent_text(agent.role, agent.settings)
            )


def _agent_text(role: str, settings: object) -> str:
    assert isinstance(settings, tuple)
    given = ", ".join(f"{name} = {value.value}" for name, value in settings)
    return role + (f" with {given}" if given else "")


def _chart(chart: Statechart) -> Iterator[Element]:
    """The activities in the states, the lines of `control`, and the order of the branches of a choice."""
    counts: Counter[tuple[str, str, str]] = Counter()
    for state in chart.states:
        if state.type is StateType.BASIC and _is_own(chart, state.origin.kind):
            owner = _owner(state.origin.owner, state.origin.name, state.origin.kind)
            key = "state", owner, state.name
            counts[key] += 1
            yield _element("state", owner, _numbered(state.name, counts[key]), state.arguments, state.span)
    lines: dict[tuple[str, str], list[Transition]] = {}
    for transition in chart.transitions:
        if not _is_own(chart, transition.origin.kind) or not _is_written(transition):
            continue
        owner = _owner(transition.origin.owner, transition.origin.name, transition.origin.kind)
        head = _head(transition)
        key = "transition", owner, head
        counts[key] += 1
        name = _numbered(head, counts[key])
        meaning = f"{transition.kind} {transition.resume} {_meaning(transition.expression)}"
        lines.setdefault((owner, transition.source), []).append(transition)
        whole = f"{head} : {_in_full(transition.expression)}"
        yield Element("transition", owner, name, meaning, _one_line(transition), transition.span, whole=whole)
    for (owner, _), items in lines.items():
        tried = sorted((i for i in items if not i.expression.otherwise), key=lambda item: item.priority)
        heads = [_head(item) for item in tried]
        if len(set(heads)) > 1:
            text = ", ".join(heads)
            yield Element("order", owner, "; ".join(sorted(heads)), text, text, tried[0].span)


def _is_own(chart: Statechart, kind: OriginKind) -> bool:
    """Whether something belongs to the chart itself: what a role takes from a protocol is the protocol's."""
    return chart.kind == "EAC" or kind is not OriginKind.PROTOCOL


def _owner(owner: str, name: str, kind: OriginKind) -> str:
    return f"{owner}.{name}" if kind is OriginKind.PROTOCOL and name else owner


def _numbered(name: str, number: int) -> str:
    return name if number == 1 else f"{name}#{number}"


def _is_written(transition: Transition) -> bool:
    """Whether a line says something about a transition, besides the formula."""
    return " : " in f"{' '.join(transition.span.text.split())} " and not transition.reactive


def _head(transition: Transition) -> str:
    return _PACE.sub("", " ".join(transition.span.text.split()).partition(" :")[0])


_PACE = re.compile(r" every \S+$")
"""A pace in the head of a line, which is part of what the line says."""


def _one_line(transition: Transition) -> str:
    return f"{_head(transition)} : {transition_text(transition)}".rstrip()


def _activity(activity: Activity) -> str:
    """What a document says of an activity, for readers."""
    times = ((name, getattr(activity, name)) for name in ("every", "takes", "within"))
    parts = [f"{name} {_duration(time)}" for name, time in times if time is not None]
    parts += [activity.kind] if activity.kind != "thread" else []
    parts += [word for word in ("simulated", "waits") if getattr(activity, word)]
    reads = [*(str(item.channel or item.topic) for item in activity.reads), *activity.reads_variables]
    writes = [*map(str, activity.writes), *activity.writes_variables]
    named = (("uses", activity.uses), ("reads", reads), ("writes", writes), ("ends", activity.ends))
    parts += [f"{word} {', '.join(sorted(items))}" for word, items in named if items]
    return " ".join(parts)


def _duration(time: int) -> str:
    return f"{time / 1_000_000_000:g}s" if time >= 1_000_000_000 else f"{time / 1_000_000:g}ms"


def _element(
    kind: str,
    owner: str,
    name: str,
    about: object,
    span: Span | None = None,
    *,
    text: str | None = None,
    matters: bool = True,
) -> Element:
    place = span or about.span  # type: ignore[attr-defined]
    said = " ".join(place.text.split()) if text is None else text
    return Element(kind, owner, name, _meaning(about), said, place, matters)


def _expression(item: TransitionExpression) -> str:
    """A transition expression with what a `let` stands for."""
    condition = "" if item.condition is None else value_text(item.condition, expand=True)
    actions = "; ".join(action_text(action, expand=True) for action in item.actions)
    return f"{events_text(item) or ''} [{condition}] {item.weight or ''} / {actions}"


def _in_full(item: TransitionExpression) -> str:
    """The same, for readers."""
    condition = "" if item.condition is None else f"[{value_text(item.condition, expand=True)}]"
    actions = "; ".join(action_text(action, expand=True) for action in item.actions)
    return " ".join(filter(None, (events_text(item), condition, f"/ {actions}" if actions else "")))


_UNORDERED = frozenset(("uses", "reads", "writes", "writes_variables", "reads_variables"))
"""Lists in which the order means nothing."""


def _meaning(value: object) -> str:
    """A text that is equal for values that mean the same, wherever they are written."""
    if isinstance(value, Formula):
        return canonical(value)
    if isinstance(value, Span | Source):
        return ""
    if is_dataclass(value) and not isinstance(value, type):
        if isinstance(value, TransitionExpression):
            return _expression(value)
        inside = []
        for item in fields(value):
            part = getattr(value, item.name)
            if item.name in _UNORDERED and isinstance(part, tuple):
                inside.append(f"{item.name}={sorted(map(_meaning, part))}")
            elif not isinstance(part, Span):
                inside.append(f"{item.name}={_meaning(part)}")
        return f"{type(value).__name__}({', '.join(inside)})"
    if isinstance(value, tuple):
        return f"({', '.join(map(_meaning, value))})"
    return repr(value)


__all__ = ["Element", "elements_of"]
