"""Stand-ins: what activities do in a scenario instead of their code."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Generator, Mapping, Sequence
from dataclasses import replace
from random import Random
from typing import cast

from aseme_dsl.amola.expression import Value
from aseme_dsl.amola.messages import Kind, Type
from aseme_dsl.play.evaluate import Known, value_of
from aseme_dsl.play.scenario import Acting, Content, Lasts, Script
from aseme_dsl.runtime.activity.activities import Activity, ActivityError, ActivityFinder, Executable
from aseme_dsl.runtime.activity.codeless import WITHOUT_CODE
from aseme_dsl.runtime.activity.context import Context
from aseme_dsl.runtime.chart.chart import Chart
from aseme_dsl.runtime.chart.plan import ActivityInfo
from aseme_dsl.runtime.message.as_json import from_json
from aseme_dsl.runtime.time.clock import SECOND
from aseme_dsl.source import Span

Types = Mapping[str, type[object]]
"""The classes of messages and enums by name."""


class ActedFailure(Exception):
    """The scenario lets an activity fail."""


class NotComputed(Exception):
    """What a scenario gives cannot be given; `span` is its place."""

    def __init__(self, span: Span, reason: str) -> None:
        super().__init__(f"{span}: {reason}")  # in the trace, where an activity fails for it
        self.span = span
        self.reason = reason


def given_message(content: Content, types: Types, inputs: Mapping[str, object]) -> object:
    """The message that is given. Raises NotComputed for a member that has no value."""
    data: dict[str, object] = {}
    for path, value in content.members:
        inside = data
        for name in path[:-1]:
            inside = cast("dict[str, object]", inside.setdefault(name, {}))
        inside[path[-1]] = _told(value, inputs)
    try:
        return from_json(types[content.channel.rpartition(".")[2]], data)
    except ValueError as error:
        raise NotComputed(content.span, str(error)) from error


def computed(value: Value, inputs: Mapping[str, object], types: Types) -> object:
    """The value that is given, as agents have it. Raises NotComputed if there is none."""
    return _typed(_told(value, inputs), value.type, types)


def _told(value: Value, inputs: Mapping[str, object]) -> object:
    """The value that is given, as a trace tells it. Raises NotComputed if there is none."""
    found = value_of(value, Known(inputs=inputs))
    if found is None:
        raise NotComputed(value.span, f"{value.span.text} has no value here")
    return found


def _typed(told: object, kind: Type, types: Types) -> object:
    """A value that was told as agents have it, with constants of enums instead of their names."""
    if kind.kind is Kind.ENUM:
        return from_json(types[kind.name], told)
    if kind.element is not None:
        return [_typed(item, kind.element, types) for item in cast("Sequence[object]", told)]
    return told


def duration_of(lasts: Lasts | None, chance: Random) -> int:
    """How long something lasts this time, in ns."""
    if lasts is None:
        return WITHOUT_CODE
    if lasts.is_normal:
        return max(0, round(chance.normalvariate(lasts.least, lasts.most)))
    return chance.randint(lasts.least, lasts.most)


def staged(chart: type[Chart], acting: Mapping[str, Acting], is_alone: bool = True) -> type[Chart]:
    """The chart of a role with the activities that the scenario gives it.

    One that `is_alone`, in no world, has no modules and behaviours. Activities of which nothing is said do
    nothing, and last what they are declared to.
    """

    def played(info: ActivityInfo) -> ActivityInfo:
        said = acting.get(info.name)
        if said is None and not is_alone:
            return info
        if said is None:
            takes = WITHOUT_CODE if info.takes is None else info.takes
            return replace(info, simulated=True, takes=takes)
        if said.real:
            return info
        return replace(info, simulated=False, waits=False, takes=None, kind="thread")

    if not is_alone and not acting:
        return chart
    modules = () if is_alone else chart.PLAN.modules
    plan = replace(chart.PLAN, activities=tuple(map(played, chart.PLAN.activities)), modules=modules)
    own = {"__slots__": (), "PLAN": plan, "AGENT": None if is_alone else chart.AGENT}
    return cast("type[Chart]", type(chart.__name__, (chart,), own))


def waiting(chart: type[Chart]) -> type[Chart]:
    """The chart of a role whose activities all wait for what is done by hand."""
    plan = replace(
        chart.PLAN,
        activities=tuple(
            replace(info, simulated=False, waits=False, takes=None, kind="thread")
            for info in chart.PLAN.activities
        ),
        modules=(),
    )
    own = {"__slots__": (), "PLAN": plan, "AGENT": None}
    return cast("type[Chart]", type(chart.__name__, (chart,), own))


def finder(
    script: Script,
    inputs: Mapping[str, object],
    types: Types,
    real: ActivityFinder,
    charts: Mapping[str, type[Chart]],
) -> ActivityFinder:
    """Gives the stand-ins of a script, and the code of what is `real`; `charts` are those of the roles.

    Raises NotComputed for an activity that is to be real and has no code, or code that cannot be loaded.
    """
    plans = {role: chart.PLAN for role, chart in charts.items()}
    roles = dict(script.team)

    def receivers(agent: str, label: str, content: Content) -> str:
        """The participant to which an activity sends a message."""
        plan = plans[roles[agent]]
        info = next((item for item in plan.branches if item.label == plan.branch_of(label)), None)
        if info is not None:
            key = info.protocol, content.performative or "", content.channel
            for other in plans.values():
                for name in other.receivers.get(key, ()):
                    if name != info.participant:
                        return name
        raise NotComputed(content.span, "no other participant receives it where the activity runs")

    stand_ins = {
        item.activity: _stand_in(item, inputs, types, receivers)
        for item in script.activities
        if not item.real
    }

    coded = {item.activity: item.span for item in script.activities if item.real}
    for name, span in coded.items():
        try:
            code = real(name)
        except ActivityError as problem:
            raise NotComputed(span, str(problem)) from problem
        if code is None:
            reason = f"{name} is to be real, and there is no code of it: set `activities` of the project"
            raise NotComputed(span, reason)

    def find(activity: str) -> type[Executable] | None:
        is_real = activity in coded or (script.world is not None and activity not in stand_ins)
        return real(activity) if is_real else stand_ins.get(activity)

    return find


def _stand_in(
    acting: Acting,
    inputs: Mapping[str, object],
    types: Types,
    receivers: Callable[[str, str, Content], str],
) -> type[Executable]:
    starts: Counter[str] = Counter()

    class StandIn(Activity):
        stands_in = True

        def execute(self, context: Context, **arguments: object) -> Generator[float, None, str | None]:
            starts[context.agent] += 1
            begin = context.now_ns
            end = begin + duration_of(acting.lasts, context.random)
            fails_at = acting.fails_at
            fails = fails_at is not None and begin <= fails_at <= end
            yield from _waiting(context, fails_at if fails and fails_at is not None else end)
            if fails:
                raise ActedFailure(f"{acting.activity} fails, as the scenario says")
            for name, value in acting.sets:
                context.set_variable(name, computed(value, inputs, types))
            for item in acting.writes:
                if item.every is None:
                    _publish(context, item.content)
            for content in acting.sends:
                to = receivers(context.agent, context.label, content)
                context.send(content.performative or "", given_message(content, types, inputs), to)
            return acting.ends[min(starts[context.agent], len(acting.ends)) - 1] if acting.ends else None

    def _publish(context: Context, content: Content) -> None:
        context.publish(content.channel, given_message(content, types, inputs))

    def _waiting(context: Context, end: int) -> Generator[float, None, None]:
        """Let time pass until `end`, and publish what is written again and again."""
        paced = [item for item in acting.writes if item.every is not None]
        due = [context.now_ns] * len(paced)
        while (now := context.now_ns) < end:
            for place, item in enumerate(paced):
                if due[place] <= now:
                    _publish(context, item.content)
                    due[place] = now + max(1, duration_of(item.every, context.random))
            yield (min([end, *due]) - now) / SECOND

    return StandIn


__all__ = [
    "ActedFailure",
    "NotComputed",
    "Types",
    "computed",
    "duration_of",
    "finder",
    "given_message",
    "staged",
    "waiting",
]
