"""Ending: what a run leaves open: agents that wait, open conversations, unread messages, and its faults."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from aseme_dsl.runtime.plan import Plan, State, Transition

if TYPE_CHECKING:
    from aseme_dsl.runtime.agent import Agent
    from aseme_dsl.runtime.conversation import Conversations


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

    `state` is the label of the leaf, `name` the innermost name around it, `at` the place of that name in the
    source. `where` says how far it is: "in" (its activity runs), "after" (the activity has returned) or
    "before" (the first transition inside was not taken yet). `conversation` is the open conversation that
    the state belongs to; `free` says that it waits for a message that begins a conversation.
    """

    state: str
    name: str
    where: str
    at: str
    awaits: tuple[Awaited, ...]
    conversation: str | None = None
    free: bool = False


@dataclass(frozen=True, slots=True)
class Member:
    """An agent that is still in a conversation; `here` says whether it runs in this process."""

    agent: str
    participant: str
    here: bool
    waits: tuple[Waiting, ...] = ()


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
    """What is open at one moment: what each agent waits for, by its name, and the conversations."""

    waits: dict[str, tuple[Waiting, ...]]
    conversations: tuple[OpenConversation, ...] = ()
    unread: tuple[Unread, ...] = ()


NOTHING = Picture({})


def picture(waits: dict[str, tuple[Waiting, ...]], conversations: Conversations) -> Picture:
    """What is open now, from what the agents wait for and the conversations in which they take part."""
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
                        if branch is not None
                        and item.conversation == name
                        and f"{item.state}.".startswith(f"{branch}.")
                    ),
                )
                for agent, participant, branch in members
            ),
        )
        for name, protocol, members in conversations.open()
    )
    return Picture(waits, found, tuple(Unread(*item) for item in conversations.unread()))


def is_stuck(waits: Iterable[Waiting]) -> bool:
    """Whether an agent that nothing can wake is stuck: it waits anywhere but for a conversation to begin."""
    return any(not item.free for item in waits)


# ---- one agent -----------------------------------------------------------------------------------


def waits_of(agent: Agent) -> tuple[Waiting, ...]:
    """What an agent waits for: one entry for each active leaf that is not an END. Called while it is guarded.

    The first entry has the transitions of the states around, too, as far as they need no completion; those
    around several regions stand with the first of these only.
    """
    chart = agent.chart
    if agent.over or agent.down or not chart.started:
        return ()
    plan = agent.plan
    told: set[str] = set()
    found = []
    for label in chart.configuration():
        state = plan.by_label[label]
        if state.type not in ("END", "AND"):
            found.append(_waiting(agent, plan, state, told))
    return tuple(found)


def _waiting(agent: Agent, plan: Plan, leaf: State, told: set[str]) -> Waiting:
    running = _runs(agent, leaf)
    branch = agent.branch_of(leaf.label)
    conversation, is_entered = (
        agent.conversations.place(agent, branch) if branch is not None else (None, False)
    )
    own = tuple(_awaited(plan, leaf, complete=not running))
    awaits = list(own)
    around = _parent(plan, leaf)
    in_branch = branch is not None
    may_begin = [item.kind == "message" for item in own]
    while around is not None:
        outer = tuple(_awaited(plan, around, complete=False))
        if around.label not in told:
            told.add(around.label)
            awaits += outer
        may_begin += [item.kind == "message" for item in outer if in_branch]
        in_branch = in_branch and around.label != branch
        around = _parent(plan, around)
    named = leaf
    while named.name == named.label and (parent := _parent(plan, named)) is not None:
        named = parent
    where = "in" if running else ("after" if leaf.type == "BASIC" else "before")
    if running:
        awaits.insert(0, Awaited("activity", leaf.activity or leaf.name, leaf.at))
    free = is_entered and conversation is None and not running and any(may_begin)
    return Waiting(leaf.label, named.name, where, named.at, tuple(dict.fromkeys(awaits)), conversation, free)


def _runs(agent: Agent, leaf: State) -> bool:
    """Whether the state is a BASIC one whose activity has not returned."""
    if leaf.label not in agent.chart.RUNNING:
        return False
    slot, _, number = agent.chart.RUNNING[leaf.label]
    return bool(getattr(agent.chart, slot) == number)


def _parent(plan: Plan, state: State) -> State | None:
    return plan.by_label[state.parent] if state.parent is not None else None


def _awaited(plan: Plan, state: State, *, complete: bool) -> Iterator[Awaited]:
    """What the transitions of a state wait for; without `complete` only those that need no completion."""
    for first in _ways(plan, state.label):
        if not (complete or first.events or first.when):
            continue
        for way in _compound(plan, first):
            if way.events or way.condition is not None or way.otherwise or way.every is not None:
                yield Awaited(_kind(way), _without_actions(way.text) or "the next period", way.at)


def _ways(plan: Plan, label: str) -> Iterable[Transition]:
    return (way for _, way in plan.outgoing(label) if way.kind == "way")


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


def _without_actions(text: str) -> str:
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
