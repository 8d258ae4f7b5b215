"""Outsiders: what agents that are not of the team say and hear, as messages of the document and back.

An outsider says of a message what FIPA has parameters for, and its content as JSON. Which message of the
document that is, and of which participant for which, follows from what the receiver takes part in or may take
part in.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime, timedelta
from typing import Any

from aseme_dsl import outside
from aseme_dsl.runtime.chart.plan import BranchInfo, Plan
from aseme_dsl.runtime.message.acl import (
    JSON,
    AclMessage,
    AgentIdentifier,
    FipaMessage,
    Span,
    fipa_name,
    performative_of,
)
from aseme_dsl.runtime.message.as_json import from_json, to_json
from aseme_dsl.runtime.message.convert import Messages
from aseme_dsl.runtime.time.clock import MILLISECOND, SECOND, Clock

MESSAGE = "X-message"
"""The parameter that names the type of the content."""
PARTICIPANT = "X-participant"
"""The parameter that names the sender's part in the protocol."""
LONGEST = 2000
"""So many characters of a reason are told."""


class NotUnderstood(Exception):
    """A message of an outsider means nothing to its receiver; the text says why."""


@dataclass(frozen=True, slots=True)
class Understood:
    """What a message of an outsider means: from which participant it is, and for which branches."""

    performative: str
    message: str
    content: Any
    participant: str
    infos: tuple[BranchInfo, ...]


def parameter(message: FipaMessage, name: str) -> str:
    """A parameter that FIPA does not have, as text; empty if it is not given."""
    found = next((value for key, value in message.parameters if key.lower() == name.lower()), "")
    return found if isinstance(found, str) else ""


def plays(protocol: str, wanted: str) -> bool:
    """Whether a protocol is the one that an outsider calls so: `fipa-contract-net` is `contract_net`."""
    return _folded(protocol) == _folded(wanted)


def _folded(protocol: str) -> str:
    return protocol.lower().replace("-", "_").removeprefix("fipa_")


def understood(message: FipaMessage, plan: Plan, infos: Sequence[BranchInfo], kinds: Messages) -> Understood:
    """What a message means to an agent that has these branches for it, the likeliest first.

    Raises:
        NotUnderstood: it means nothing, or may mean several things.
    """
    performative = performative_of(message.performative)
    if performative is None:
        raise NotUnderstood(f"FIPA has no performative {message.performative[:100]}")
    content = _content(message)
    named = parameter(message, MESSAGE)
    problems: list[str] = []
    found: dict[str, tuple[Any, list[BranchInfo]]] = {}
    for info in infos:
        for known, name in info.receives:
            if known != performative or named not in ("", name):
                continue
            try:
                value = from_json(kinds[name], content)
            except (KeyError, ValueError) as problem:
                problems.append(f"it is no {name}: {problem}"[:LONGEST])
                continue
            found.setdefault(name, (value, []))[1].append(info)
    if not found:
        what = f"{performative} {named}".strip()
        raise NotUnderstood(problems[0] if problems else f"{plan.name} receives no {what}")
    if len(found) > 1:
        raise NotUnderstood(f"it may be {' or '.join(found)}: {MESSAGE} says which")
    ((name, (value, fitting)),) = found.items()
    first = fitting[0]
    same = tuple(i for i in fitting if (i.protocol, i.participant) == (first.protocol, first.participant))
    speakers = _speakers(plan, same, performative, name)
    said = parameter(message, PARTICIPANT)
    if said and said not in speakers:
        raise NotUnderstood(f"{first.participant} receives no {performative} {name} from {said}")
    return Understood(performative, name, value, said or speakers[0], same)


def _content(message: FipaMessage) -> Any:
    if message.language.lower() not in ("", JSON):
        raise NotUnderstood(f"the content is in {message.language[:100]}; {JSON} is understood")
    if isinstance(message.content, bytes) or message.encoding.lower() not in ("", "utf-8", "utf8"):
        raise NotUnderstood("the content is no text in UTF-8")
    if not (message.content or "").strip():
        return {}
    try:
        found = outside.loads(message.content or "")
        json.dumps(found, ensure_ascii=False).encode()
    except (ValueError, RecursionError) as problem:  # half a character is no text, either
        raise NotUnderstood(f"the content is no JSON: {problem}"[:LONGEST]) from None
    if not isinstance(found, dict):
        raise NotUnderstood("the content is no JSON object")
    return found


def _speakers(plan: Plan, infos: Iterable[BranchInfo], performative: str, message: str) -> list[str]:
    """The participants from which a branch takes such a message, first those from which a transition does."""
    found: dict[str, None] = {}
    for info in infos:
        inside = info.label + "."
        for transition in plan.transitions:
            if transition.source.startswith(inside):
                for event in transition.events:
                    if event[:3] == ("received", performative, message):
                        found[event[3]] = None
    for info in infos:
        found.update((name, None) for name, _, _ in info.participants if name != info.participant)
    return list(found) or [""]


def written(
    acl: AclMessage,
    to: Iterable[AgentIdentifier],
    reason: str = "",
    reply_by: datetime | Span | None = None,
) -> FipaMessage:
    """A message of the document as an outsider gets it; `reason` is why something is not understood."""
    content = to_json(acl.content)
    if reason:
        content = {"reason": reason, "content": content}
    return FipaMessage(
        fipa_name(acl.performative),
        AgentIdentifier(acl.sender),
        tuple(to),
        json.dumps(content, ensure_ascii=False),
        tuple(AgentIdentifier(name) for name in acl.reply_to),
        acl.language,
        acl.encoding,
        acl.ontology,
        acl.protocol,
        acl.conversation,
        acl.reply_with,
        acl.in_reply_to,
        reply_by,
        tuple(
            (name, value) for name, value in ((MESSAGE, acl.message), (PARTICIPANT, acl.participant)) if value
        ),
    )


def answer(message: FipaMessage, sender: str, performative: str, reason: str, reply_with: str) -> FipaMessage:
    """What is said to an outsider about a message that could not be handed to anybody, and why."""
    said = message.content
    content = {"reason": reason, "content": said if isinstance(said, str) else None}
    return FipaMessage(
        fipa_name(performative),
        AgentIdentifier(sender),
        message.reply_to or ((message.sender,) if message.sender is not None else ()),
        json.dumps(content, ensure_ascii=False),
        language=JSON,
        ontology=message.ontology,
        protocol=message.protocol,
        conversation=message.conversation,
        reply_with=reply_with,
        in_reply_to=message.reply_with,
    )


def deadline(message: FipaMessage, clock: Clock) -> int | None:
    """Until when an outsider wants an answer, in ns of the run; None if it does not say so.

    Raises:
        ValueError: what it says is no moment.
    """
    unread = parameter(message, "reply-by")
    if unread:
        raise ValueError(f"{unread[:100]!r} is no date and time")
    return _own_moment(message.reply_by, clock)


def _own_moment(moment: datetime | Span | None, clock: Clock) -> int | None:
    """A moment of FIPA's in ns of the run; None in virtual time for one that is not relative."""
    if isinstance(moment, Span):
        days = moment.years * 365 + moment.months * 30 + moment.days
        return clock.now() + moment.sign * (days * 86_400_000 + moment.milliseconds) * MILLISECOND
    if moment is None or clock.virtual:
        return None
    try:
        left = moment.timestamp() - datetime.now(UTC).timestamp()
    except (OverflowError, ValueError):  # in the year 1, in local time
        raise ValueError(f"{moment} is out of reach") from None
    return clock.now() + round(left * SECOND)


def fipa_moment(moment: int | None, clock: Clock) -> datetime | Span | None:
    """A moment of the run as FIPA says it: in virtual time from now on."""
    if moment is None:
        return None
    left = moment - clock.now()
    if clock.virtual:
        return Span(milliseconds=max(left, 0) // MILLISECOND)
    return datetime.now(UTC) + timedelta(microseconds=left // 1000)
