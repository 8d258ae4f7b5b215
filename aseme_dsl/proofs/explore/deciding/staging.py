"""Staging: the statecharts of a team that is explored, and what their plans let activities do."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import replace
from functools import partial
from operator import attrgetter
from typing import cast

from aseme_dsl.proofs.explore.deciding.arriving import methods_of
from aseme_dsl.runtime.activity import context as c
from aseme_dsl.runtime.chart.chart import Chart
from aseme_dsl.runtime.chart.plan import BranchInfo, Plan, is_in, terms_in, terms_of


class StandsFor:
    """Stands for the code of every activity: when it ends, it has done anything that it may do."""

    stands_in = True

    def execute(self, context: c.Context, **arguments: object) -> None:
        raise RuntimeError("no code runs where a team is explored")


class Open:
    """A value that is not decided before something reads it."""

    def __repr__(self) -> str:
        return "open"


OPEN = Open()


def staged(
    chart: type[Chart],
    decide: Callable[[str, str], object],
    draw: Callable[[str], float],
    looked_for: Callable[[str], None],
    is_paced: bool,
    holds: Callable[[Chart, Callable[[], object]], bool],
    more: Callable[[Mapping[str, object]], Mapping[str, object]] | None = None,
) -> type[Chart]:
    """The chart of a role whose activities all run until they are ended, without modules. If it is not paced,
    a pause between two runs of one counts as part of the run.

    What activities may write is open until it is read: `decide` is asked by the names of the agent and the
    variable. `draw` is asked for random numbers. `looked_for` is called with a channel when something looks
    for a message that is not there, and `holds` whether a condition is true. `more`
    gives further methods of the chart, if there are any, for those that it has.
    """
    plan = replace(
        chart.PLAN,
        activities=tuple(
            replace(
                info,
                simulated=False,
                takes=None,
                every=info.every if is_paced else None,
                kind="thread",
            )
            for info in chart.PLAN.activities
        ),
        modules=(),
    )
    own = methods_of(chart, looked_for, lambda chart, condition: holds(chart, condition))
    own["random"] = lambda chart: draw(chart.agent)
    if more is not None:
        own |= more(own)
    return with_open(chart, plan, own, partial(_opened, decide))


def with_open(
    chart: type[Chart], plan: Plan, own: Mapping[str, object], opened: Callable[[str, str], property]
) -> type[Chart]:
    """A chart with another plan and attributes of its own, in which what activities may write is open.

    `opened` makes the attribute for the name of the slot in which the value stands, and that of the variable.
    """
    names = {
        slot: variable
        for variable, slots in chart.VARIABLES.items()
        if variable in undecided(plan)
        for slot in slots
    }
    held = {slot: f"held_{slot}" for slot in names}
    own = {**own, "__slots__": tuple(held.values()), "PLAN": plan, "AGENT": None}
    own |= {slot: opened(held[slot], name) for slot, name in names.items()}
    places = tuple(held.get(name, name) for name in chart.places)
    if held:  # what is open stays so when it is saved
        read = attrgetter(*places)
        own["values"] = lambda chart: read(chart)
    kind = cast("type[Chart]", type(chart.__name__, (chart,), own))
    kind.places = places
    return kind


def _opened(decide: Callable[[str, str], object], slot: str, variable: str) -> property:
    def read(chart: Chart) -> object:
        value = getattr(chart, slot)
        if value is OPEN:
            value = decide(chart.agent, variable)
            setattr(chart, slot, value)
        return value

    return property(read, lambda chart, value: setattr(chart, slot, value))


def undecided(plan: Plan) -> frozenset[str]:
    """The variables that activities write: those that they declare, and those of participants that no line
    writes."""
    declared = {name for info in plan.activities for name in info.variables}
    written = assigned(plan)
    return frozenset(
        item.name
        for item in plan.variables
        if not item.type.startswith("list of ")
        and (item.name.partition("@")[0] in declared or (item.scope is not None and item.name not in written))
    )


def settled(
    plans: Collection[Plan], agents: Collection[str]
) -> dict[tuple[str, tuple[str, ...]], frozenset[object]]:
    """The numbers and texts that nothing writes, by the names of their variables, with what `agents` hold."""
    found: dict[str, set[object]] = {}
    for plan in plans:
        for item in plan.variables:
            if item.type in ("int", "double", "duration", "string"):
                own = (value for agent, name, value in plan.settings if agent in agents and name == item.name)
                found.setdefault(item.name.partition("@")[0], set()).update((item.initial, *own))
    written = {name.partition("@")[0] for plan in plans for name in (*undecided(plan), *assigned(plan))}
    return {(name, ()): frozenset(held) for name, held in found.items() if name not in written}


def lists_of(plan: Plan) -> tuple[str, ...]:
    """The lists that activities may write."""
    declared = {name for info in plan.activities for name in info.variables}
    written = assigned(plan)
    names = {
        item.name: item.name.partition("@")[0] for item in plan.variables if item.type.startswith("list of ")
    }
    scoped = {item.name for item in plan.variables if item.scope is not None}
    return tuple(
        own for name, own in names.items() if own in declared or (name in scoped and name not in written)
    )


def receivers(info: BranchInfo, performative: str, message: str, plans: Sequence[Plan]) -> tuple[str, ...]:
    """The participants that receive a message of a branch, from any agent."""
    key = info.protocol, performative, message
    found = (part for plan in plans for part in plan.receivers.get(key, ()))
    return tuple(
        part for part in dict.fromkeys(found) if part != info.participant or info.size_of(part)[1] != 1
    )


def by_lines(plan: Plan, branch: str) -> frozenset[tuple[str, str]]:
    """The agent messages that some transition of a branch takes."""
    return frozenset(
        (str(event[1]), str(event[2]))
        for item in plan.transitions
        if is_in(item.source, branch)
        for event in item.events
        if event[0] == "received"
    )


def by_lines_of(plan: Plan) -> frozenset[str]:
    """The channels on which lines of a plan publish."""
    actions = (action for item in plan.transitions for action in item.actions)
    return frozenset(channel for action in actions if (channel := published(action)) is not None)


def copied(plan: Plan) -> frozenset[str]:
    """The types of messages that lines keep or hand on as a whole."""
    found: set[str] = set()
    actions = (action for item in plan.transitions for action in item.actions)
    for term in terms_in((*actions, *(term for state in plan.states for _, term in state.arguments))):
        match term:
            case ("member", _, str() as channel, ()):
                found.add(channel.rpartition(".")[2])
            case _:
                pass
    return frozenset(found)


def looked_at(plan: Plan) -> frozenset[str]:
    """The channels whose messages lines of a plan ask for, hand on or give to activities."""
    return frozenset(str(term[2]) for term in terms_of(plan) if term[:1] == ("member",))


def asked_in(plans: Iterable[Plan], told: Collection[str]) -> Callable[[str], bool]:
    """Whether anything but activities asks for the messages of a channel.

    Lines of plans do. Something else asks for messages of the types `told`, even if no agent reads these.
    """
    seen = frozenset[str]().union(*map(looked_at, plans))
    return lambda channel: channel in seen or channel.rpartition(".")[2] in told


def published(action: tuple[object, ...]) -> str | None:
    """The channel for which an action publishes or prepares a message."""
    match action:
        case ("publish", str() as channel):
            return channel
        case ("fill", ("member", _, str() as channel, *_), *_):
            return channel
        case _:
            return None


def assigned(plan: Plan) -> frozenset[str]:
    """The variables to which lines of the document give another value than the initial one."""
    initial = {item.name: item.initial for item in plan.variables}
    return frozenset(
        str(action[1])
        for item in plan.transitions
        for action in item.actions
        if action[0] == "assign" and action[2] != ("const", initial.get(str(action[1])))
    )


def writable(plan: Plan, label: str) -> tuple[str, ...]:
    """The variables that the activity of a state may write: those that it declares, and those of its
    participant that no line of the protocol writes."""
    activity = plan.by_label[label].activity
    info = next((item for item in plan.activities if item.name == activity), None)
    there = [item for item in plan.variables if item.scope is None or is_in(label, item.scope)]
    own = {item.name.partition("@")[0] for item in there}
    written = assigned(plan)
    inner = (item.name.partition("@")[0] for item in there if item.scope and item.name not in written)
    declared = (name for name in (() if info is None else info.variables) if name in own)
    return tuple(dict.fromkeys((*declared, *inner)))


def watched(plan: Plan) -> frozenset[str]:
    """The variables that conditions read while what they are about is active, complete or not."""
    looked_for = (
        item.condition for item in plan.transitions if item.when or item.events or item.kind == "on"
    )
    return frozenset(
        str(term[1]).partition("@")[0] for term in terms_in(looked_for) if term[:1] == ("variable",)
    )


def events(plan: Plan) -> tuple[str, ...]:
    """The events that transitions wait for and that no line raises: they come from elsewhere."""
    raised = raised_by(plan)
    found = (str(event[1]) for item in plan.transitions for event in item.events if event[0] == "raised")
    return tuple(dict.fromkeys(name for name in found if name not in raised))


def raised_by(plan: Plan) -> frozenset[str]:
    """The events that lines raise."""
    actions = (action for item in plan.transitions for action in item.actions)
    return frozenset(str(action[1]) for action in actions if action[0] == "raise")


__all__ = [
    "OPEN",
    "Open",
    "StandsFor",
    "asked_in",
    "assigned",
    "by_lines",
    "by_lines_of",
    "copied",
    "events",
    "lists_of",
    "published",
    "raised_by",
    "receivers",
    "settled",
    "staged",
    "undecided",
    "watched",
    "with_open",
    "writable",
]
