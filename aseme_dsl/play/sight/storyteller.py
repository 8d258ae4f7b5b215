"""Storyteller: collects what happens to the agents of a run, and tells what led to a failure."""

from __future__ import annotations

import itertools
from collections import deque
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import field, replace
from typing import TypeVar

from aseme_dsl.play.evaluate import Known
from aseme_dsl.play.scenario import Cut
from aseme_dsl.play.sight.guards import Guards
from aseme_dsl.play.sight.story import Happened
from aseme_dsl.play.sight.words import Said, content_of, cut, ending, few, name_of, sending
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.board import NEVER
from aseme_dsl.runtime.chart.plan import Plan, Transition, is_in
from aseme_dsl.runtime.time.clock import readable
from aseme_dsl.runtime.trace.records import Record
from aseme_dsl.source import without_column

LAST, FEWEST = 12, 3
"""A story shows so many of the last things that happened to an agent; fewer of each of many."""
_FIRST = 8
"""It shows so many of the first things that happened after what is awaited was near."""
_MOST_KEPT = 500
"""So many of the last things that happened to an agent are kept."""
_MOST_TAKEN = 20
"""Of a step with more transitions, the story shows so many of the last ones."""
_MOST_UNREAD = 1000
"""Of so many messages it is known who sent them, and who has not received them."""

OUTSIDE = "input"
"""The sender of what a scenario gives without one."""
BY_SCENARIO = ", an input of the scenario"

_CAUSES = {
    "busy": ", automatically: `when busy`",
    "ended": ", automatically: its part has ended",
    "unexpected": ", automatically: it does not expect what has come",
}
"""Why an agent has sent what its statechart does not send."""

_ENDS = "end of an activity: "
"""With this the keys of the ends of activities begin."""

Identity = tuple[str, int]
_T = TypeVar("_T")


@dataclass(frozen=True, slots=True)
class About:
    """What a story is about: the agents (None: all), their states, and the messages, by name."""

    agents: frozenset[str] | None = None
    places: Mapping[str, frozenset[str]] = field(default_factory=dict)
    messages: frozenset[str] = frozenset()
    since: int | None = None
    """When what is awaited had come as far as it is (ns)."""


@dataclass(frozen=True, slots=True)
class _Came:
    """What comes to agents: the `event` that transitions take, as plans have it, and `why` it was sent."""

    event: tuple[object, ...]
    text: str
    why: str = ""


class Storyteller:
    """Collects what happens, each thing as it happened last."""

    def __init__(self, agents: Iterable[str], guards: Guards) -> None:
        agents = tuple(agents)
        self.guards = guards
        self._last: dict[str, dict[str, tuple[int, Happened]]] = {name: {} for name in agents}
        """What has happened to an agent, with its number; the newest comes last."""
        self._log: dict[str, deque[tuple[int, Happened]]] = {
            name: deque(maxlen=_MOST_KEPT) for name in agents
        }
        """All that has happened to an agent lately."""
        self._happened = itertools.count()
        self._unread: dict[Identity, set[str]] = {}
        """Who has not received yet what was sent lately."""
        self._came: dict[Identity, _Came] = {}
        """What was sent lately, and which losses agents have learned."""
        self._taken: dict[tuple[str, str], dict[int, int]] = {}
        """When an agent in a role has taken a transition last (ns), by its number."""
        self._mail: dict[tuple[str, str], Said] = {}
        """The last message of a kind that was sent to an agent."""
        self._names: dict[tuple[str, str], str] = {}
        self._values: dict[str, Mapping[str, object]] = {}
        """What variables of an agent held at the end of its last step, of those that conditions read."""

    # ---- what happens ----------------------------------------------------------------------------

    def note(self, moment: int, agent: str, text: str) -> None:
        """Something has happened to an agent."""
        self._add(text, Happened(moment, agent, text))

    def end(self, record: Record) -> None:
        """An activity has ended."""
        text, agent = ending(record), record["agent"]
        item = Happened(record["time"], agent, text, is_step=True, label=record["label"])
        self._add(f"{_ENDS}{text}", item)

    def sent(self, said: Said, record: Record, is_given: bool) -> None:
        """A message was sent, by the scenario if it `is_given`."""
        agent, number, receivers = record["agent"], int(record["sequence"]), record.get("to", [])
        item = replace(sending(said, receivers, self._durations(said)), number=number)
        why = BY_SCENARIO if is_given else _CAUSES.get(str(record.get("cause")), "")
        self._add(f"sends {said.what}", replace(item, text=item.text + why, sent=item.sent + why))
        came = _Came(("received", said.performative, said.kind), f"{said.what} from {agent}", why)
        _keep(self._came, (agent, number), came)
        for sender, answered in record.get("answers", ()):
            self.arrived(agent, (str(sender), int(answered)))
        if said.performative is not None:
            self._mail.update(((name, said.what), said) for name in receivers)
        _keep(self._unread, (agent, number), self._last.keys() & set(receivers))

    def came(self, agent: str) -> Mapping[str, Said]:
        """The last agent message of each kind that was sent to an agent."""
        return {what: said for (name, what), said in self._mail.items() if name == agent}

    def _durations(self, said: Said) -> frozenset[str]:
        return self.guards.durations.get(said.kind, frozenset())

    def gone(self, record: Record) -> None:
        """An agent learns that the part of another one has ended."""
        text = f"the part of {record['peer']} has ended: {record.get('reason', 'lost')}"
        _keep(self._came, (record["agent"], int(record["sequence"])), _Came(("lost", record["played"]), text))

    def taken(self, agent: str, plan: Plan) -> Mapping[int, int]:
        """When an agent has taken each transition of a role last (ns), by their numbers."""
        return self._taken.get((agent, plan.name), {})

    def arrived(self, agent: str, identity: Identity) -> None:
        """An agent has received a message."""
        self._unread.get(identity, set()).discard(agent)

    def received(self, moment: int, agent: str, said: Said, identity: Identity) -> None:
        """An agent has received a message of another one, and a step has taken note of it."""
        is_given = said.sender not in self._last
        text = f"receives {said.what}{content_of(said.content, self._durations(said))}"
        text += f" from {said.sender}" if said.sender != OUTSIDE else ""
        came = self._came.get(identity)
        text += BY_SCENARIO if is_given else "" if came is None else came.why
        # What a scenario gives is different each time.
        key = text if is_given else f"receives {said.what} {said.sender}"
        self._add(key, Happened(moment, agent, text, peer=said.sender))

    def step(self, record: Record, plan: Plan, after: Sequence[str], known: Callable[[], Known]) -> None:
        """An agent has made a step; what stands together in it is one line. `after` are the active leaves."""
        moment, agent = record["time"], record["agent"]
        ways = [way["transitions"] for way in record["taken"][-_MOST_TAKEN:]]
        last = self._taken.setdefault((agent, plan.name), {})
        last.update((number, moment) for way in ways for number in way)
        now, before = known(), self._values.get(agent, {})
        changes = [frozenset(_changed(plan, way)) for way in ways]
        for chain in _chains(plan, ways):
            first = plan.transitions[ways[chain[0]][0]]
            text = self._moved(plan, [ways[place] for place in chain], after)
            returned = self._returned(moment, agent, first.source)
            if returned is not None and not first.events and not first.when:
                text = f"{returned}; {text}"
            parts: list[str] = []
            places: list[str] = []
            details: list[str] = []
            for place in chain:
                then, unknown = _at_way(now, before, changes, place)
                for number in ways[place]:
                    item = plan.transitions[number]
                    places.append(without_column(item.at))
                    what = item.text or ("again" if item.source == item.target else "")
                    parts += [f"{cut(what)} ({without_column(item.at)})"] if what else []
                    details += self._first_of(record, item)
                    details += self.guards.explained(plan, number, then, unknown)
                    details += self.guards.passed_over(plan, number, then, unknown)
            text += f" : {', '.join(parts)}" if parts else ""
            at = "" if parts else ", ".join(list(dict.fromkeys(places))[:2])
            told = Happened(
                moment,
                agent,
                text,
                at,
                is_step=True,
                label=first.target,
                details=tuple(dict.fromkeys(details)),
            )
            numbers = (str(number) for place in chain for number in ways[place])
            self._add(" ".join((plan.name, *numbers)), told)
        names = self.guards.variables(plan)
        self._values[agent] = {name: now.variable(name) for name in names} if names else {}

    def _first_of(self, record: Record, way: Transition) -> Iterator[str]:
        """Which of several things that a transition waits for has come."""
        for sender, number in record.get("agent_messages", ()) if len(way.events) > 1 else ():
            came = self._came.get((str(sender), int(number)))
            if came is not None and any(event[: len(came.event)] == came.event for event in way.events):
                yield f"as {came.text}" if came.event[0] == "lost" else f"by {came.text}"

    def _returned(self, moment: int, agent: str, label: str) -> str | None:
        """What was said of the end of the activity of a state, which is not said twice then."""
        for key, (number, item) in reversed(self._last[agent].items()):
            if item.moment != moment:
                return None
            if item.label == label and key.startswith(_ENDS):
                del self._last[agent][key]
                with suppress(ValueError):  # so much has happened at this moment that it is not kept
                    self._log[agent].remove((number, item))
                return item.text
        return None

    def _moved(self, plan: Plan, chain: Sequence[Sequence[int]], after: Sequence[str]) -> str:
        """What people call what some transitions do, one behind the other."""
        first = plan.transitions[chain[0][0]]
        if first.kind == "on":
            return f"stays in {self._name(plan, first.source)}"
        if first.kind in ("exit", "abandon"):
            return f"leaves {self._name(plan, first.source)}"
        ends = [plan.transitions[way[-1]].target for way in chain]
        sources = [plan.transitions[way[0]].source for way in chain]
        inner: dict[str, None] = {}
        for place, label in enumerate(ends):
            if not any(_follows(plan, label, source) for source in sources[place + 1 :]):
                leaves = [leaf for leaf in after if is_in(leaf, label) and plan.by_label[leaf].type != "AND"]
                inner.update(dict.fromkeys(self._name(plan, leaf) for leaf in leaves or [label]))
        names = list(inner)
        text = few(names)
        entered = [end for end, source in zip(ends, sources, strict=True) if not _is_start(plan, source)]
        around = plan.by_label[(entered or ends[:1])[-1]]
        is_named = around.type in ("OR", "AND") and around.name.isidentifier()
        if is_named and " in " not in text and around.name not in text:
            text += f" in {around.name}"
        if _is_start(plan, first.source):
            return f"enters {text}"
        return f"{self._name(plan, first.source)} -> {text}"

    def _name(self, plan: Plan, label: str) -> str:
        key = plan.name, label
        if key not in self._names:
            self._names[key] = name_of(plan, label)
        return self._names[key]

    def _add(self, key: str, item: Happened) -> None:
        """Something has happened to an agent; what has the same `key` is the same once more."""
        last = self._last.get(item.agent)
        if last is not None:
            before = last.pop(key, None)
            times = 1 if before is None else before[1].times + 1
            last[key] = numbered = next(self._happened), replace(item, times=times)
            self._log[item.agent].append(numbered)

    # ---- the story -------------------------------------------------------------------------------

    def story(
        self, about: About, cuts: Iterable[Cut], end: int, plan: Callable[[str], Plan]
    ) -> Iterator[Happened]:
        """The last things that happened to the agents that it is about, in their order.

        Of others there is what they have exchanged with those, and how they have crashed or failed. Of an
        agent, regions beside the states that are spoken of have less room.
        """
        chosen = frozenset(self._last) if about.agents is None else about.agents
        most = max(FEWEST, LAST // max(1, len(chosen) // 2))
        found: dict[int, Happened] = {}
        for name, last in self._last.items():
            items = [item for item in last.values() if _is_read(item[1], about.messages)]
            if name not in chosen:
                found.update([item for item in items if _concerns(item[1], chosen)][-FEWEST:])
                continue
            spoken = about.places.get(name, frozenset())
            asides = dict(item for item in items if _is_aside(plan(name), item[1], spoken))
            own = [item for item in items if item[0] not in asides]
            minor = {number for number, item in own if item.text.startswith("stays in ")}
            found.update([item for item in own if item[0] not in minor][-most:])
            found.update([item for item in own if item[0] in minor][-FEWEST:])
            found.update([item for item in asides.items() if not item[1].text.endswith("returns")][-FEWEST:])
            found.update(last[key] for key in (f"sends {one}" for one in about.messages) if key in last)
            found.update(self._then(name, about, plan(name), spoken))
        story = self._in_order(found)
        story += [item for item in self._cut_off(cuts, end) if item.agent in chosen]
        yield from sorted(story, key=lambda item: item.moment)

    def whole(self) -> list[Happened]:
        """All that has happened to the agents, as far as it is kept, in its order."""
        return self._in_order(dict(itertools.chain.from_iterable(self._log.values())))

    def _in_order(self, found: Mapping[int, Happened]) -> list[Happened]:
        """What has happened, by its number; what is received as it is sent stands there once."""
        ordered = [self._with_missing(item) for _, item in sorted(found.items())]
        sent = {(item.moment, item.agent, name) for item in ordered for name in item.to}
        return [item for item in ordered if (item.moment, item.peer, item.agent) not in sent]

    def _then(
        self, agent: str, about: About, plan: Plan, spoken: Collection[str]
    ) -> list[tuple[int, Happened]]:
        """What happened first to an agent after what is awaited had come as far as it is."""
        if about.since is None:
            return []
        later = (
            item
            for item in self._log[agent]
            if item[1].moment >= about.since
            if _is_read(item[1], about.messages) and not _is_aside(plan, item[1], spoken)
        )
        found: dict[str, tuple[int, Happened]] = {}
        for item in later:
            found.setdefault(item[1].text, item)
        return list(found.values())[:_FIRST]

    def _cut_off(self, cuts: Iterable[Cut], end: int) -> Iterator[Happened]:
        """How agents were cut off until the end."""
        for item in cuts:
            others = [name for name in self._last if name not in item.agents]
            if item.first <= end and others:
                until = "" if item.last == NEVER else f" until {readable(item.last)}"
                for agent in self._last:
                    away = others if agent in item.agents else sorted(item.agents)
                    yield Happened(item.first, agent, f"is cut off from {', '.join(away)}{until}")

    def _with_missing(self, item: Happened) -> Happened:
        """A message that was sent, with those who have not received it."""
        missing = [name for name in item.to if name in self._unread.get((item.agent, item.number), ())]
        if not missing:
            return item
        but = f"; not received by {', '.join(missing)}"
        return replace(item, text=item.text + but, sent=item.sent + but)


def _keep(found: dict[Identity, _T], identity: Identity, item: _T) -> None:
    """Add something, and forget the oldest where there is much."""
    found[identity] = item
    if len(found) > _MOST_UNREAD:
        del found[next(iter(found))]


def _chains(plan: Plan, ways: Sequence[Sequence[int]]) -> list[list[int]]:
    """The transitions of a step, by their places: those that follow from another one stand behind that."""
    chains: list[list[int]] = []
    for place, way in enumerate(ways):
        first = plan.transitions[way[0]]
        behind = (
            chain
            for chain in reversed(chains)
            for before in (plan.transitions[ways[one][-1]] for one in chain)
            if before.kind == "external" and _follows(plan, before.target, first.source)
        )
        chain = next(behind, None) if first.kind == "external" else None
        if chain is None:
            chains.append([place])
        else:
            chain.append(place)
    return chains


def _follows(plan: Plan, entered: str, source: str) -> bool:
    """Whether a transition of `source` follows from entering a state.

    It is the first one inside it, or that of the state around, which is complete then.
    """
    if _is_start(plan, source):
        region = plan.by_label[source].parent or ""
        return region == entered or (
            plan.by_label[entered].type == "AND" and plan.by_label[region].parent == entered
        )
    if plan.by_label[entered].type != "END":
        return False
    region = plan.by_label[entered].parent or ""
    around = plan.by_label[region].parent if region else None
    return source == region or (source == around and plan.by_label[source].type == "AND")


def _is_start(plan: Plan, label: str) -> bool:
    return plan.by_label[label].type == "START"


def _changed(plan: Plan, way: Iterable[int]) -> Iterator[str]:
    """What the actions of a transition change: variables, and timers."""
    for number in way:
        for action in plan.transitions[number].actions:
            if action[0] in ("assign", "start_timer"):
                yield str(action[1])


def _at_way(
    now: Known, before: Mapping[str, object], changes: Sequence[frozenset[str]], place: int
) -> tuple[Known, frozenset[str]]:
    """What was known when a transition of a step was taken, and the variables of which that is not sure.

    `now` is what is known after the step; `before` are the variables before it, and `changes` says which of
    them each transition has changed.
    """
    earlier = frozenset().union(*changes[:place])
    later = frozenset().union(*changes[place:])
    find = now.variable
    then = replace(now, variable=lambda name: before.get(name) if name in later else find(name))
    return then, (earlier & later) | (later - before.keys())


def _is_read(item: Happened, messages: Collection[str]) -> bool:
    """Whether an agent reads a message: what none reads says something only if it is spoken of."""
    return not item.sent or bool(item.to) or any(name in item.sent for name in messages)


def _is_aside(plan: Plan, item: Happened, spoken: Collection[str]) -> bool:
    """Whether something has happened beside all of the states that are spoken of."""
    return bool(item.label and spoken) and all(plan.are_concurrent(item.label, label) for label in spoken)


def _concerns(item: Happened, agents: frozenset[str]) -> bool:
    """Whether others see what has happened to an agent: these agents, or all."""
    if item.to or item.peer:
        return item.peer in agents or not agents.isdisjoint(item.to)
    return not item.is_step


__all__ = ["OUTSIDE", "About", "Storyteller"]
