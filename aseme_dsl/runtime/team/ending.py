"""Ending: what a run leaves open: agents that wait, open conversations, unread messages, and its faults."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Mapping
from typing import TYPE_CHECKING

from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.plan import Plan, State, Transition
from aseme_dsl.runtime.team.outside import Need, need_of, wait_for_input

if TYPE_CHECKING:
    from aseme_dsl.runtime.agent.agent import Agent
    from aseme_dsl.runtime.conversation.conversation import Conversations


@dataclass(frozen=True, slots=True)
class Awaited:
    """Something that an agent waits for: `what` in the words of the source, `at` its place there.

    `kind` is "message", "event", "condition", "time" or "activity".
    """

    kind: str
    what: str
    at: str = ""


@dataclass(frozen=True, slots=True)
class Waiting:
    """An active state and what is awaited there.

    `state` is the label of the leaf (or of the complete state with its END), `name` the innermost name
    around it. `at` is the place of that name in the source. `where` says how far it is: "in" (its activity
    runs), "after" (the activity has returned, or its END is active) or "before" (the first transition inside
    was not taken yet). `conversation` is the open conversation that the state belongs to; `free` says that it
    waits for a message that begins a conversation. `since` is the moment (ns) at which the activity returned
    or, where none has, the state was entered; `timed` says that a time alone ends the wait, in this region.
    """

    state: str
    name: str
    where: str
    at: str
    awaits: tuple[Awaited, ...]
    conversation: str | None = None
    free: bool = False
    since: int = 0
    timed: bool = False


@dataclass(frozen=True, slots=True)
class Member:
    """An agent that is still in a conversation; `here` says whether it runs in this process.

    It is `suspended` if its part was left and may be resumed.
    """

    agent: str
    participant: str
    here: bool
    waits: tuple[Waiting, ...] = ()
    suspended: bool = False


@dataclass(frozen=True, slots=True)
class OpenConversation:
    """A conversation that was open at the end, and the agents that are still in it."""

    name: str
    protocol: str
    members: tuple[Member, ...]


@dataclass(frozen=True, slots=True)
class Unread:
    """An agent message that waited for its receiver at the end."""

    agent: str
    participant: str
    conversation: str
    performative: str
    message: str
    sender: str


@dataclass(frozen=True, slots=True)
class Picture:
    """What is open at one moment: what each agent waits for, by its name, and the conversations.

    `idle` are the agents that only need an input from outside, directly or through other agents.
    """

    waits: dict[str, tuple[Waiting, ...]]
    conversations: tuple[OpenConversation, ...] = ()
    unread: tuple[Unread, ...] = ()
    idle: frozenset[str] = frozenset()


NOTHING = Picture({})


def picture(
    found_waits: dict[str, tuple[tuple[Waiting, Need], ...]],
    conversations: Conversations,
    writers: Mapping[str, Collection[str]],
) -> Picture:
    """What is open now, from what the agents wait for and the conversations in which they take part.

    `writers` are the agents that may publish on a channel.
    """
    waits = {name: tuple(item for item, _ in own) for name, own in found_waits.items()}
    needs = {name: [need for item, need in own if not item.free] for name, own in found_waits.items()}
    found = tuple(
        OpenConversation(
            name,
            protocol,
            tuple(
                Member(
                    agent,
                    participant,
                    agent in waits,
                    tuple(
                        item
                        for item in waits.get(agent, ())
                        if branch is not None and f"{item.state}.".startswith(f"{branch}.")
                    ),
                    suspended,
                )
                for agent, participant, branch, suspended in members
            ),
        )
        for name, protocol, members in conversations.open()
    )
    unread = tuple(Unread(*item) for item in conversations.unread())
    return Picture(waits, found, unread, wait_for_input(needs, writers))


def is_stuck(waits: Iterable[Waiting]) -> bool:
    """Whether an agent that nothing can wake is stuck: it waits anywhere but for a conversation to begin."""
    return any(not item.free for item in waits)


# ---- one agent -----------------------------------------------------------------------------------


def waits_of(agent: Agent) -> tuple[tuple[Waiting, Need], ...]:
    """What an agent waits for and needs: one entry for each active leaf. Called while it is guarded.

    A state that is complete, since its END or those of its regions are active, has an entry in the place of
    these. A region that is complete beside one that is not has none. The first entry has the transitions of
    the states around, too, as far as they need no completion; those around several regions stand with the
    first of these only.
    """
    chart = agent.chart
    if agent.over or agent.down or not chart.started:
        return ()
    plan = agent.plan
    told: set[str] = set()
    ended: dict[str, list[int]] = {}
    found = []
    for label in chart.configuration():
        state = plan.by_label[label]
        since = agent.since.get(label, 0)
        complete = _parent(plan, state) if state.type == "END" else None
        if complete is not None:
            around = _parent(plan, complete)
            if around is not None and around.type == "AND":
                moments = ended.setdefault(around.label, [])
                moments.append(since)
                if len(moments) < sum(item.parent == around.label for item in plan.states):
                    continue
                complete, since = around, max(moments)
            state = complete
        if complete is not None or state.type != "AND":
            found.append(_waiting(agent, plan, state, told, since))
    return tuple(found)


def _waiting(agent: Agent, plan: Plan, leaf: State, told: set[str], since: int) -> tuple[Waiting, Need]:
    """The entry of a leaf, or of a state around that is complete, which came to rest `since` at least."""
    waits = _waits(plan, leaf)
    running = _runs(agent, leaf) and not waits
    complete = not running and not waits
    branch = agent.plan.branch_of(leaf.label)
    conversation, is_entered = (
        agent.conversations.place(agent, branch) if branch is not None else (None, False)
    )
    own = tuple(_awaited(plan, leaf, complete=complete))
    awaits = list(own)
    around = _parent(plan, leaf)
    in_branch = branch is not None
    may_begin = [item.kind == "message" for item in own]
    timed = _is_timed(plan, leaf, complete=complete)
    in_region = True
    since = max(since, agent.since.get(leaf.label, 0))
    while around is not None:
        outer = tuple(_awaited(plan, around, complete=False))
        if around.label not in told:
            told.add(around.label)
            awaits += outer
        may_begin += [item.kind == "message" for item in outer if in_branch]
        in_branch = in_branch and around.label != branch
        in_region = in_region and around.type != "AND"
        timed = timed or (in_region and _is_timed(plan, around, complete=False))
        since = max(since, agent.since.get(around.label, 0))
        around = _parent(plan, around)
    named = leaf
    while named.name == named.label and (parent := _parent(plan, named)) is not None:
        named = parent
    where = "in" if running or waits else ("before" if leaf.type in ("START", "CONDITION") else "after")
    if running:
        awaits.insert(0, Awaited("activity", leaf.activity or leaf.name, leaf.at))
    begins = is_entered and conversation is None and not running and any(may_begin)
    free = begins or agent.listens  # a behaviour may raise what it waits for
    waiting = Waiting(
        leaf.label,
        named.name,
        where,
        named.at,
        tuple(dict.fromkeys(awaits)),
        conversation,
        free,
        since,
        timed,
    )
    return waiting, need_of(plan, leaf.label, conversation, complete=complete)


def _runs(agent: Agent, leaf: State) -> bool:
    """Whether the state is a BASIC one whose activity has not returned."""
    if leaf.label not in agent.chart.RUNNING:
        return False
    slot, _, number = agent.chart.RUNNING[leaf.label]
    return bool(getattr(agent.chart, slot) == number)


def _waits(plan: Plan, leaf: State) -> bool:
    """Whether the state is one that never completes by itself."""
    return any(item.waits for item in plan.activities if item.name == leaf.activity)


def _parent(plan: Plan, state: State) -> State | None:
    return plan.by_label[state.parent] if state.parent is not None else None


def _awaited(plan: Plan, state: State, *, complete: bool) -> Iterator[Awaited]:
    """What the transitions of a state wait for; without `complete` only those that need no completion."""
    for first in _ways(plan, state.label):
        if not (complete or first.events or first.when):
            continue
        for way in _compound(plan, first):
            if way.events or way.condition is not None or way.otherwise or way.every is not None:
                yield Awaited(_kind(way), trigger_of(way.text) or "the next period", way.at)


def _is_timed(plan: Plan, state: State, *, complete: bool) -> bool:
    """Whether a transition of the state waits for a time and nothing else."""
    return any(
        way.condition is None and _kind(way) == "time"
        for way in _ways(plan, state.label)
        if complete or way.events or way.when
    )


def _ways(plan: Plan, label: str) -> Iterable[Transition]:
    return (way for _, way in plan.outgoing(label) if way.kind == "external")


def _compound(plan: Plan, first: Transition) -> Iterator[Transition]:
    """A transition, and where it leads to a choice, those that continue it."""
    seen: set[str] = set()
    waiting = [first]
    while waiting:
        way = waiting.pop(0)
        yield way
        if plan.by_label[way.target].type == "CONDITION" and way.target not in seen:
            seen.add(way.target)
            waiting += _ways(plan, way.target)


def trigger_of(text: str) -> str:
    """The trigger and condition of a transition expression: what stands before the first free `/`."""
    depth = 0
    for part in re.finditer(r'"(?:[^"\\]|\\.)*"|\[>|.', text, re.DOTALL):
        if part[0] in "([{":
            depth += 1
        elif part[0] in ")]}":
            depth -= 1
        elif part[0] == "/" and depth == 0:
            return text[: part.start()].rstrip()
    return text


def _kind(way: Transition) -> str:
    """What a transition waits for, foremost."""
    events = {event[0] for event in way.events}
    if "received" in events:
        return "message"
    if events == {"after"} or way.every is not None:
        return "time"
    if events:
        return "event"
    return "condition"
