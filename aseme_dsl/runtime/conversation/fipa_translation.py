"""Translation between FIPA messages of agents outside the team and messages of the system.

An external agent gives with a message what FIPA has parameters for, and its content as JSON. Which message of
the document that is, and of which participant for which, follows from what the receiver takes part in or may
take part in.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence
from datetime import UTC, datetime, timedelta

from aseme_dsl import outside
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.plan import BranchInfo, Plan
from aseme_dsl.runtime.message.acl import (
    JSON,
    NOT_UNDERSTOOD,
    REGISTERED,
    AclMessage,
    AgentIdentifier,
    FipaMessage,
    Span,
    fipa_name,
    performative_of,
    protocol_of,
    registered_name,
)
from aseme_dsl.runtime.message.as_json import from_json, to_json
from aseme_dsl.runtime.message.convert import Messages
from aseme_dsl.runtime.time.clock import MILLISECOND, SECOND, Clock

MESSAGE = "X-message"
"""The parameter that names the type of the content."""
PARTICIPANT = "X-participant"
"""The parameter that names the sender's part in the protocol."""
LONGEST = 2000
"""The most characters of a reason that are sent."""


class NotUnderstood(Exception):
    """A message of an external agent means nothing to its receiver; the text says why."""


@dataclass(frozen=True, slots=True)
class Understood:
    """What a message of an external agent means: from which participant it is, and for which participants."""

    performative: str
    message: str
    content: object
    participant: str
    infos: tuple[BranchInfo, ...]


def parameter(message: FipaMessage, name: str) -> str:
    """A parameter that FIPA does not have, as text; empty if it is not given."""
    found = next((value for key, value in message.parameters if key.lower() == name.lower()), "")
    return found if isinstance(found, str) else ""


def plays(protocol: str, wanted: str) -> bool:
    """Whether an external agent means this protocol by a name: `fipa-contract-net` is `contract_net`."""
    return _folded(protocol) == _folded(wanted)


def _folded(protocol: str) -> str:
    return protocol_of(protocol).lower().replace("-", "_").removeprefix("fipa_")


def played_as(wanted: str, infos: Sequence[BranchInfo]) -> list[BranchInfo]:
    """The participants of the protocol that an external agent names: of that very name, or of one like it."""
    exact = [info for info in infos if info.protocol in (wanted, protocol_of(wanted))]
    return exact or [info for info in infos if not wanted or plays(info.protocol, wanted)]


@dataclass(frozen=True, slots=True)
class Context:
    """What a message of an external agent may be understood by, besides itself.

    `infos` are the branches that it may be for, in groups, the likeliest first. `part` is the one that its
    sender has in the conversation. `answered` is the message that it answers, as performative and type, and
    `sent` what was sent to it in the conversation, the newest last.
    """

    infos: tuple[tuple[BranchInfo, ...], ...]
    part: str = ""
    answered: tuple[str, str] | None = None
    sent: tuple[tuple[str, str], ...] = ()


_Found = dict[str, tuple[object, list[BranchInfo]]]


def understood(message: FipaMessage, plan: Plan, context: Context, kinds: Messages) -> Understood:
    """What a message means to an agent.

    Raises:
        NotUnderstood: it means nothing, or may mean several things.
    """
    performative = performative_of(message.performative)
    if performative is None:
        raise NotUnderstood(f"FIPA has no performative {message.performative[:100]}")
    content = _reason_of(message) if performative == NOT_UNDERSTOOD else _content(message)
    problems: list[str] = []
    found: _Found = {}
    named = parameter(message, MESSAGE)
    for infos in context.infos:
        found = _candidates(performative, named, content, infos, kinds, problems)
        if not found and performative == NOT_UNDERSTOOD:  # its content is anything, or says why
            found = _candidates(performative, named, {}, infos, kinds, problems)
        if found:
            break
    if not found:
        what = f"{performative} {named}".strip()
        raise NotUnderstood(problems[0] if problems else f"{plan.name} receives no {what}")
    found = _narrowed(performative, found, plan, context)
    if len(found) > 1:
        raise NotUnderstood(f"it may be {' or '.join(found)}: {MESSAGE} or in-reply-to says which")
    ((name, (value, fitting)),) = found.items()
    first = fitting[0]
    protocols = dict.fromkeys(info.protocol for info in fitting)
    if len(protocols) > 1:
        raise NotUnderstood(f"it may be of {' or '.join(protocols)}: protocol says which")
    same = tuple(i for i in fitting if (i.protocol, i.participant) == (first.protocol, first.participant))
    speakers = _speakers(plan, same, performative, name)
    said = parameter(message, PARTICIPANT)
    if said and said not in speakers:
        raise NotUnderstood(f"{first.participant} receives no {performative} {name} from {said}")
    if context.part and not said and context.part not in speakers:
        raise NotUnderstood(f"{first.participant} receives no {performative} {name} from {context.part}")
    return Understood(performative, name, value, said or context.part or speakers[0], same)


def _candidates(
    performative: str,
    named: str,
    content: object,
    infos: Iterable[BranchInfo],
    kinds: Messages,
    problems: list[str],
) -> _Found:
    """The types that a message may have, each with the content and the branches that receive it."""
    found: _Found = {}
    for info in infos:
        for known, name in info.receives:
            if known != performative or named not in ("", name):
                continue
            try:
                value = from_json(kinds[name], content)
            except (KeyError, ValueError) as problem:
                problems.append(f"it is not a {name}: {problem}"[:LONGEST])
                continue
            found.setdefault(name, (value, []))[1].append(info)
    return found


def _narrowed(performative: str, found: _Found, plan: Plan, context: Context) -> _Found:
    """Of the types that a message may have, those that what was said before leaves open."""
    for rule in (_from_part, _as_answer, _of_cancel):
        if len(found) > 1:
            names = rule(performative, found, plan, context)
            found = {name: found[name] for name in names} or found
    return found


def _from_part(performative: str, found: _Found, plan: Plan, context: Context) -> list[str]:
    """What the participant says that the sender is."""
    return [
        name
        for name, (_, infos) in found.items()
        if not context.part or context.part in _speakers(plan, infos, performative, name)
    ]


ANSWERS_WITH_SAME = ("agree", "refuse", NOT_UNDERSTOOD, "accept_proposal", "reject_proposal")
"""The content of these is that of the message which they answer."""


def _as_answer(performative: str, found: _Found, plan: Plan, context: Context) -> list[str]:
    """What has the type of the message that it answers, or may answer."""
    if performative not in ANSWERS_WITH_SAME:
        return []
    if context.answered is not None:
        return [context.answered[1]] if context.answered[1] in found else []
    possible = {name for _, name in context.sent if name in found}
    return list(possible) if len(possible) == 1 else []


def _of_cancel(performative: str, found: _Found, plan: Plan, context: Context) -> list[str]:
    """In FIPA's protocols, `inform` and `failure` of what was cancelled answer the `cancel` alone."""
    if performative not in ("inform", "failure"):
        return []
    infos = [info for _, infos in found.values() for info in infos]
    if any(info.protocol not in REGISTERED for info in infos):
        return []
    ends = {name for act, name in infos[0].sends if act == "cancel" and name in found}
    if context.answered is not None:
        cancels = context.answered[0] == "cancel"
        return [name for name in found if (name in ends) == cancels]
    cancelled = any(act == "cancel" for act, _ in context.sent)
    return [] if cancelled else [name for name in found if name not in ends]


def _reason_of(message: FipaMessage) -> object:
    """What a `not-understood` says was not understood, as far as that can be read."""
    try:
        content = _content(message)
    except NotUnderstood:
        return {}
    inner = content.get("content")
    return inner if isinstance(inner, dict) else content


def _content(message: FipaMessage) -> dict[str, object]:
    if message.language.lower() not in ("", JSON):
        raise NotUnderstood(f"the content is in {message.language[:100]}; {JSON} is understood")
    if isinstance(message.content, bytes) or message.encoding.lower() not in ("", "utf-8", "utf8"):
        raise NotUnderstood("the content is not a text in UTF-8")
    if not (message.content or "").strip():
        return {}
    try:
        found = outside.loads(message.content or "")
        json.dumps(found, ensure_ascii=False).encode()
    except (ValueError, RecursionError) as problem:  # half a character is not a text, either
        raise NotUnderstood(f"the content is not JSON: {problem}"[:LONGEST]) from None
    if not isinstance(found, dict):
        raise NotUnderstood("the content is not a JSON object")
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
                        found[str(event[3])] = None
    for info in infos:
        found.update((name, None) for name, _, _ in info.participants if name != info.participant)
    return list(found) or [""]


def written(
    acl: AclMessage,
    to: Iterable[AgentIdentifier],
    reason: str = "",
    reply_by: datetime | Span | None = None,
) -> FipaMessage:
    """A message of the system as an external agent gets it; `reason` is why something is not understood."""
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
        registered_name(acl.protocol),
        acl.conversation,
        acl.reply_with,
        acl.in_reply_to,
        reply_by,
        tuple(
            (name, value) for name, value in ((MESSAGE, acl.message), (PARTICIPANT, acl.participant)) if value
        ),
    )


def answer(message: FipaMessage, sender: str, performative: str, reason: str, reply_with: str) -> FipaMessage:
    """The answer to an external agent whose message has no receiver, and why."""
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
    """Until when an external agent wants an answer, in ns of the run; None if it does not say so.

    Raises:
        ValueError: what it says is not a moment.
    """
    unread = parameter(message, "reply-by")
    if unread:
        raise ValueError(f"{unread[:100]!r} is not a date and time")
    return own_moment(message.reply_by, clock)


def own_moment(moment: datetime | Span | None, clock: Clock) -> int | None:
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
        days, rest = divmod(max(left, 0) // MILLISECOND, 86_400_000)
        years, days = divmod(days, 365)
        months, days = divmod(days, 30)
        return Span(years, months, days, rest)
    return datetime.now(UTC) + timedelta(microseconds=left // 1000)
