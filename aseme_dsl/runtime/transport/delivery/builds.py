"""Builds: what robots of other builds send, as far as it is understood, and their word that it was not.

Each stream begins with the sender's contract, so that it is there before any message of that build.
"""

from __future__ import annotations

import time
from collections.abc import Iterator

from aseme_dsl.runtime.message.contract import Contract, ContractError, Reading, loads
from aseme_dsl.runtime.message.performatives import NOT_UNDERSTOOD
from aseme_dsl.runtime.message.wire import WireError
from aseme_dsl.runtime.transport import envelope as envelopes
from aseme_dsl.runtime.transport.delivery.records import Other, Sent, Unread
from aseme_dsl.runtime.transport.delivery.reports import count, lose, tell, tell_once
from aseme_dsl.runtime.transport.delivery.sending import UNKNOWN, pump
from aseme_dsl.runtime.transport.delivery.state import Delivery
from aseme_dsl.runtime.transport.envelope import Envelope
from aseme_dsl.runtime.transport.link import Stamp
from aseme_dsl.runtime.transport.stream import Letter

TELL_AGAIN = 500_000_000
"""So often, in ns, we notify a sender of the number of further messages that we did not read."""
SETTLED = 300_000_000
"""So many ns after a contract has come, or ours has changed, the two are compared."""
_MOST_CONTRACTS = 8
_MOST_SHOWN = 5


def decoded(
    state: Delivery, mine: str, other: Other, envelope: Envelope, payload: bytes
) -> tuple[Envelope, object] | None:
    """What is to be handed on of something in the stream; None if nothing is. Called with the lock."""
    match envelope.kind:
        case envelopes.CONTRACT:
            _learn(state, mine, other, envelope, payload)
            return None
        case envelopes.LOSS:  # it has no content
            return envelope, None
        case envelopes.REFUSED:
            return _refused(state, mine, other, envelope, payload)
        case _:
            return _read(state, mine, other, envelope, payload)


def _read(
    state: Delivery, mine: str, other: Other, envelope: Envelope, payload: bytes
) -> tuple[Envelope, object] | None:
    """A message; None, after telling its sender why, if it is none for us."""
    codec = state.codec
    is_mail = envelope.kind == envelopes.MAIL
    name = envelope.message if is_mail else envelope.channel
    view: Reading | None = None
    reason = ""
    if envelope.contract != codec.number:
        view = reading_of(state, other, envelope.contract)
        if view is None and envelope.place == 0:  # data may overtake the contract
            other.counts["dropped"] = other.counts.get("dropped", 0) + 1
            return None
        reason = _objection(view, envelope)
    kind = codec.kinds.get(name) if is_mail else codec.schema.channels.get(name)
    if not reason and kind is None:
        reason = f"there is no {'message' if is_mail else 'channel'} {name}"
    if not reason and kind is not None:
        try:
            return envelope, codec.read(kind, payload, view)
        except WireError as problem:
            if view is None:
                count(state, other, "unreadable", f"{name}: {problem}", about=name)
                return None
            reason = str(problem)
    said = f"{name} is of another build: {reason}"
    if kind is None and ("refused", name) not in other.told:  # a comparison of the builds may not tell it
        state.team.trace.fault(state.now(), mine, f"{other.name} sends what is not read: {said}")
    count(state, other, "refused", said, about=name)
    _tell_sender(state, mine, other, envelope, payload, reason)
    return None


def _objection(view: Reading | None, envelope: Envelope) -> str:
    """Why a message of another build is not read; empty if it is."""
    if view is None:
        return "nothing is known of that build"
    if envelope.kind != envelopes.MAIL:
        return view.channels.get(envelope.channel, "")
    found = view.protocols.get(envelope.protocol, "") if envelope.protocol else ""
    return found or (view.messages.get(envelope.message, "") if envelope.message else "")


def reading_of(state: Delivery, other: Other, number: int) -> Reading | None:
    """How we read what an agent sends under a contract; None if we do not know that."""
    contract = other.contracts.get(number)
    if contract is None:
        return None
    key = state.codec.number, number
    if key not in other.readings:
        other.readings[key] = state.codec.reading(contract)
    return other.readings[key]


# ---- contracts ---------------------------------------------------------------------------------


def contract_letters(state: Delivery, mine: str) -> Iterator[Letter[Sent]]:
    """The contracts of our builds, for an agent that we meet."""
    for contract in state.contracts.values():
        yield contract_letter(state, mine, contract)


def contract_letter(state: Delivery, mine: str, contract: Contract) -> Letter[Sent]:
    """A contract on its way. It says under which number it is meant."""
    payload = contract.dumps()
    envelope = state.envelope(envelopes.CONTRACT)._replace(contract=contract.number)
    return Letter(Sent("contract", envelope, payload, mine, "contract"), len(payload))


def _learn(state: Delivery, mine: str, other: Other, envelope: Envelope, payload: bytes) -> None:
    """An agent says what its build is."""
    try:
        contract = loads(payload)
    except ContractError as problem:
        count(state, other, "unreadable", str(problem))
        return
    if contract.number != envelope.contract:
        count(state, other, "unreadable", "its contract has another number")
        return
    other.contracts.pop(contract.number, None)
    other.contracts[contract.number] = contract
    for number in list(other.contracts)[:-_MOST_CONTRACTS]:
        del other.contracts[number]
    other.model = contract.model
    compare_soon(state, other)


def compare_soon(state: Delivery, other: Other) -> None:
    """Compare the builds in a moment: a swap changes them one after the other. Called with the lock."""
    other.compare_at = time.monotonic_ns() + SETTLED
    state.stir()


def compare(state: Delivery, other: Other, now: int) -> bool:
    """Tell what does not work between our build and that of an agent; whether it is not yet time for that.

    Called with the lock.
    """
    if not other.compare_at:
        return False
    if now < other.compare_at:
        return True
    other.compare_at = 0
    contract = next(reversed(other.contracts.values()), None)
    if contract is None:
        return False
    other.incompatible = tuple(_incompatible(state, other, contract))
    reason = ""
    if contract.model != state.codec.contract.model:
        reason = f"{other.name} is of another build ({contract.model or 'without a hash'})"
    if other.incompatible:
        shown = "; ".join(other.incompatible[:_MOST_SHOWN])
        more = len(other.incompatible) - _MOST_SHOWN
        reason += f", and not compatible: {shown}" + (f"; and {more} more" if more > 0 else "")
    if reason == other.said:
        return False
    other.said = reason
    if other.incompatible:
        state.team.trace.fault(state.now(), state.mine, reason)
    tell(state, other, "build", reason=reason or None, model=contract.model or None)
    return False


def _incompatible(state: Delivery, other: Other, contract: Contract) -> Iterator[str]:
    """What of that which travels between an agent and ours is not understood by one of both."""
    if contract.number == state.codec.number:
        return
    view = reading_of(state, other, contract.number)
    assert view is not None
    for name, reason in view.protocols.items():
        if name in state.codec.contract.protocols:
            yield f"protocol {name}: {reason}"
    for name, reason in view.channels.items():
        if any(state.team.bus.concerns(other.name, name, mine) for mine in state.here):
            yield f"{name} from {other.name}: {reason}"
    for name, reason in _theirs(state, contract).channels.items():
        if any(state.team.bus.concerns(mine, name, other.name) for mine in state.here):
            yield f"{name} to {other.name}: {reason}"


def _theirs(state: Delivery, contract: Contract) -> Reading:
    from aseme_dsl.runtime.message.contract import reading

    return reading(contract, state.codec.contract)


# ---- agents that a build does not know ---------------------------------------------------------


def turn_away(state: Delivery, mine: str, sender: str, envelope: Envelope) -> None:
    """Tell an agent that is in another build, but not in ours, that we cannot talk. Called with the lock."""
    now = time.monotonic_ns()
    told_at = state.strangers.get(sender)
    if state.lease is None or told_at is None or (told_at and now - told_at < TELL_AGAIN):
        return
    state.strangers[sender] = now
    back = state.envelope(envelopes.REFUSED)._replace(reason=f"there is no agent {sender} in its team")
    state.link.send(sender, mine, "refused", back, Stamp(envelope.incarnation), b"", True)


def be_unknown(state: Delivery, mine: str, other: Other, reason: str) -> None:
    """The build of an agent does not know ours: nothing can be brought there. Called with the lock."""
    if not other.knows_us:
        return
    other.knows_us = False
    state.team.trace.fault(state.now(), mine, f"{other.name} is of another build: {reason}")
    tell(state, other, "rejected", reason=reason)
    for (_, name), way in state.ways.items():
        if name == other.name:
            flying, waiting = way.out.restart()
            lose(state, name, (*flying, *waiting), UNKNOWN)


# ---- what was not read -------------------------------------------------------------------------


def _tell_sender(
    state: Delivery, mine: str, other: Other, envelope: Envelope, payload: bytes, reason: str
) -> None:
    """Notify a sender that we did not read a message. Of a channel, it learns the number."""
    if envelope.kind == envelopes.MAIL:
        if envelope.performative == NOT_UNDERSTOOD:
            return  # answers that are not understood are never answered
        sequence = state.here[mine].identity()[1]
        back = state.envelope(envelopes.REFUSED, sequence)._replace(
            performative=envelope.performative,
            message=envelope.message,
            protocol=envelope.protocol,
            conversation=envelope.conversation,
            participant=envelope.to,
            to=envelope.participant,
            in_reply_to=envelope.reply_with or f"{other.name}-{envelope.sequence}",
            reason=reason,
            upto=1,
        )
        _put(state, mine, other, back, payload)
        return
    unread = other.unread.setdefault(envelope.channel, Unread(mine, reason))
    unread.number += 1
    unread.reason = reason
    _tell_number(state, other, envelope.channel, unread, time.monotonic_ns())


def tell_numbers(state: Delivery, other: Other, now: int) -> bool:
    """Tell an agent of more messages that were not read; whether that is to be done again soon."""
    for channel, unread in other.unread.items():
        if unread.number:
            _tell_number(state, other, channel, unread, now)
    return any(unread.number for unread in other.unread.values())


def _tell_number(state: Delivery, other: Other, channel: str, unread: Unread, now: int) -> None:
    if now - unread.told_at < TELL_AGAIN and unread.told_at:
        state.stir()
        return
    back = state.envelope(envelopes.REFUSED)._replace(
        channel=channel, upto=unread.number, reason=unread.reason
    )
    unread.number, unread.told_at = 0, now
    _put(state, unread.mine, other, back, b"")


def _put(state: Delivery, mine: str, other: Other, envelope: Envelope, payload: bytes) -> None:
    way = state.ways[mine, other.name]
    way.out.put(Letter(Sent("refused", envelope, payload, mine, "refused"), len(payload)))
    pump(state, way, other)


def _refused(
    state: Delivery, mine: str, other: Other, envelope: Envelope, payload: bytes
) -> tuple[Envelope, object] | None:
    """An agent has not read what one of ours has sent; an agent message comes back with its content."""
    other.counts["rejected"] = other.counts.get("rejected", 0) + envelope.upto
    name = envelope.channel or envelope.message or "text"
    if ("rejected", name) not in other.told:
        reason = f"{other.name} does not read {name}, since it is of another build: {envelope.reason}"
        state.team.trace.fault(state.now(), mine, reason)
    tell_once(state, other, "rejected", f"{name}: {envelope.reason}", about=name)
    if envelope.channel:
        return None
    kind = state.codec.kinds.get(envelope.message)
    if kind is None:
        return None
    try:
        return envelope, state.codec.read(kind, payload)
    except WireError:  # it was sent before a swap
        return None
