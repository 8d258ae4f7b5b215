"""Stand-ins: what activities do in a scenario instead of their code."""

from __future__ import annotations

from collections import Counter
from collections.abc import Generator, Mapping
from dataclasses import replace
from random import Random
from typing import cast

from aseme_dsl.amola.expression import Value
from aseme_dsl.play.evaluate import Known, value_of
from aseme_dsl.play.scenario import Acting, Content, Lasts, Script
from aseme_dsl.runtime.activity.activities import Activity, ActivityFinder, Executable
from aseme_dsl.runtime.activity.codeless import WITHOUT_CODE
from aseme_dsl.runtime.activity.context import Context
from aseme_dsl.runtime.chart.chart import Chart
from aseme_dsl.runtime.chart.plan import ActivityInfo
from aseme_dsl.runtime.message.as_json import from_json
from aseme_dsl.runtime.time.clock import SECOND

Messages = Mapping[str, type[object]]
"""The message classes by name."""


class ActedFailure(Exception):
    """The scenario lets an activity fail."""


class NotComputed(Exception):
    """A value that a scenario gives cannot be computed."""


def given_message(content: Content, messages: Messages, inputs: Mapping[str, object]) -> object:
    """The message that is given. Raises NotComputed for a member that has no value."""
    data: dict[str, object] = {}
    for path, value in content.members:
        inside = data
        for name in path[:-1]:
            inside = cast("dict[str, object]", inside.setdefault(name, {}))
        inside[path[-1]] = _computed(value, inputs)
    try:
        return from_json(messages[content.channel.rpartition(".")[2]], data)
    except ValueError as error:
        raise NotComputed(f"{content.span}: {error}") from error


def _computed(value: Value, inputs: Mapping[str, object]) -> object:
    found = value_of(value, Known(inputs=inputs))
    if found is None:
        raise NotComputed(f"{value.span}: {value.span.text} has no value here")
    return found


def duration_of(lasts: Lasts | None, chance: Random) -> int:
    """How long something lasts this time, in ns."""
    if lasts is None:
        return WITHOUT_CODE
    if lasts.is_normal:
        return max(0, round(chance.normalvariate(lasts.least, lasts.most)))
    return chance.randint(lasts.least, lasts.most)


def staged(chart: type[Chart], acting: Mapping[str, Acting]) -> type[Chart]:
    """The chart of a role with the activities that the scenario gives it, without modules and behaviours.

    Those of which nothing is said do nothing, and last what they are declared to.
    """

    def played(info: ActivityInfo) -> ActivityInfo:
        said = acting.get(info.name)
        if said is None:
            takes = WITHOUT_CODE if info.takes is None else info.takes
            return replace(info, simulated=True, takes=takes)
        if said.real:
            return info
        return replace(info, simulated=False, waits=False, takes=None, kind="thread")

    plan = replace(chart.PLAN, activities=tuple(map(played, chart.PLAN.activities)), modules=())
    return cast("type[Chart]", type(chart.__name__, (chart,), {"__slots__": (), "PLAN": plan, "AGENT": None}))


def finder(
    script: Script, inputs: Mapping[str, object], messages: Messages, real: ActivityFinder
) -> ActivityFinder:
    """Gives the stand-ins of a script, and the code of what is `real`."""
    stand_ins = {
        item.activity: _stand_in(item, inputs, messages) for item in script.activities if not item.real
    }

    coded = {item.activity for item in script.activities if item.real}

    def find(activity: str) -> type[Executable] | None:
        return real(activity) if activity in coded else stand_ins.get(activity)

    return find


def _stand_in(acting: Acting, inputs: Mapping[str, object], messages: Messages) -> type[Executable]:
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
                context.set_variable(name, _computed(value, inputs))
            for item in acting.writes:
                if item.every is None:
                    _publish(context, item.content)
            return acting.ends[min(starts[context.agent], len(acting.ends)) - 1] if acting.ends else None

    def _publish(context: Context, content: Content) -> None:
        context.publish(content.channel, given_message(content, messages, inputs))

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


__all__ = ["Messages", "NotComputed", "duration_of", "finder", "given_message", "staged"]
