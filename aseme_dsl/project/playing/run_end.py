"""The end of a run in words: idle agents, deadlock, waits, open conversations, unread messages, faults."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from aseme_dsl.runtime.team.ending import Awaited, Member, Unread, Waiting
from aseme_dsl.runtime.team.team import AgentResult, RunResult
from aseme_dsl.runtime.trace.fault_counts import FaultCount
from aseme_dsl.source import without_column

_MOST = 20
"""So many lines of one sort are printed; of the others only the number."""
_MOST_AWAITED = 4
_LONG = 60
"""A longer text of the source is cut."""


def end_lines(result: RunResult) -> Iterator[str]:
    """What to say about the end of a run besides its time; nothing about one that left nothing open."""
    if result.stuck and result.idle_since is not None:
        since = f"{result.idle_since / 1e9:g} s"
        idle = [agent.name for agent in result.agents if agent.idle]
        locked = [name for name in result.stuck if name not in idle]
        if idle:
            verb = "waits" if len(idle) == 1 else "wait"
            yield f"idle since {since}: {_few(idle, 8, ', ')} {verb} for input from outside"
        if locked:
            names = _few(locked, 8, ", ")
            yield f"deadlock since {since}: no input, timer or activity is pending that could wake {names}"
    yield from _clipped(_waiting_lines(result.agents), "waiting state")
    yield from _clipped(_conversation_lines(result), "line")
    yield from _clipped([_unread_line(item) for item in result.unread], "unread message")
    yield from _fault_lines(result.faults)


def _fault_lines(faults: Iterable[FaultCount]) -> Iterator[str]:
    """How many faults there were, and the first of each kind."""
    found = list(faults)
    if found:
        yield f"{_plural(sum(item.count for item in found), 'fault')}; the first of each kind:"
        yield from _clipped([_fault_line(item) for item in found], "kind")


def _waiting_lines(agents: Iterable[AgentResult]) -> list[str]:
    lines = []
    for agent in agents:
        # Beside an activity that runs, a region that rests for a time is nothing to look at.
        is_active = not agent.stuck and any(map(_runs, agent.waits))
        lines += [
            f"{agent.name} ({agent.role}) waits {waits_text(item)}"
            for item in agent.waits
            if item.conversation is None and not item.free
            if not is_active or (not _runs(item) and item.awaits and not item.timed)
        ]
    return lines


def _runs(item: Waiting) -> bool:
    """Whether an activity runs there, which may end by itself."""
    return item.where == "in" and any(found.kind == "activity" for found in item.awaits)


def _conversation_lines(result: RunResult) -> list[str]:
    lines = []
    for conversation in result.conversations:
        lines.append(f"conversation {conversation.name} of {conversation.protocol} is open:")
        lines += [f"  {line}" for member in conversation.members for line in _member_lines(member)]
    return lines


def _member_lines(member: Member) -> list[str]:
    who = f"{member.agent} as {member.participant}"
    if not member.here:
        return [f"{who}, in another process"]
    if member.suspended:
        return [f"{who} is suspended"]
    if not member.waits:
        return [f"{who} has not joined"]
    return [f"{who} waits {waits_text(item)}" for item in member.waits]


def waits_text(item: Waiting) -> str:
    """Where an agent waits and for what: `after Ask (a.aseme:4) for agree Offer from seller (a.aseme:9)`.

    What may interrupt an activity that runs is only in --json.
    """
    if _runs(item):
        return f"for its activity {_cut(item.name)}{_place(item.at)} to end"
    awaited = _few([_awaited(found) for found in item.awaits], _MOST_AWAITED, " or ")
    what = f" for {awaited}" if awaited else ""
    return f"{item.where} {_cut(item.name)}{_place(item.at)}{what}, since {item.since / 1e9:g} s"


def _awaited(item: Awaited) -> str:
    return f"{_cut(item.what)}{_place(item.at)}"


def _unread_line(item: Unread) -> str:
    part = f" as {item.participant}" if item.participant else ""
    where = f"{part} in {item.conversation}" if item.conversation else part
    return f"unread: {item.performative} {item.message} from {item.sender} to {item.agent}{where}"


def _fault_line(item: FaultCount) -> str:
    times = f"{item.count} times, first " if item.count > 1 else ""
    who = f"{'by ' if times else ''}{item.agent} " if item.agent else ""
    at = _place(item.at)
    if not item.at and item.activity and item.activity not in item.reason:
        at = f" (activity {item.activity})"
    return f"  {times}{who}at {item.time / 1e9:g} s: {item.reason}{at}"


def _few(texts: list[str], most: int, between: str) -> str:
    further = f"{between}{len(texts) - most} more" if len(texts) > most else ""
    return between.join(texts[:most]) + further


def _clipped(lines: list[str], noun: str) -> Iterator[str]:
    yield from lines[:_MOST]
    if len(lines) > _MOST:
        yield f"... and {_plural(len(lines) - _MOST, noun)} more; --json and the trace have them all"


def _cut(text: str) -> str:
    return text if len(text) <= _LONG else f"{text[:_LONG]} …"


def _place(at: str) -> str:
    return f" ({without_column(at)})" if at else ""


def _plural(number: int, noun: str) -> str:
    return f"{number} {noun}{'' if number == 1 else 's'}"
