"""Exchange: agent messages in transition expressions: what is sent to whom, and what a transition takes."""

from __future__ import annotations

from collections.abc import Callable, Collection
from dataclasses import replace

from aseme_dsl.amola import expression as amola
from aseme_dsl.amola.expression import Value
from aseme_dsl.amola.messages import AGENT
from aseme_dsl.compiler.names.checker import Checker
from aseme_dsl.compiler.names.scope import Party, Taken
from aseme_dsl.compiler.read.builtins import NOT_UNDERSTOOD, PERFORMATIVES, reserved
from aseme_dsl.compiler.read.names import unknown, unknown_performative
from aseme_dsl.compiler.types.content import Rest, deadline, fill, rest_of
from aseme_dsl.diagnostics import Related, closest
from aseme_dsl.diagnostics.problems import talk as problems
from aseme_dsl.diagnostics.problems.absences import NoPartner, NotListed, Verb
from aseme_dsl.grammar.text import tree

Typed = Callable[[Checker, tree.Expression], Value | None]
"""How an expression is typed (typecheck.py)."""


# ---- events ------------------------------------------------------------------------------------


def received(checker: Checker, written: tree.Received) -> amola.Received | None:
    """`propose Bid b from contractor`, or from an agent that a variable holds: E205, E511, E512, E567.

    A message of one agent is one of the participant that sends such a message: see `only_from`.
    """
    if _names_agent(checker, written):
        senders = _senders(checker, written)
        if len(senders) != 1:
            said = f"{written.performative} {written.message}"
            lists = any(
                party.lists
                for name, party in checker.scope.parties.items()
                if name != checker.scope.participant
            )
            problem = problems.SenderNotKnown(written.participant.text, said, senders, lists)
            checker.report(problem, written.participant.span)
            return None
        written = replace(written, participant=tree.Name(senders[0], written.participant.span))
    if not _is_exchanged(checker, written.performative, written.message, written.participant, False):
        return None
    parts = (written.performative.text, written.message.text, written.participant.text)
    return amola.Received(*parts, written.span, written.name.text if written.name is not None else "")


def _names_agent(checker: Checker, written: tree.Received) -> bool:
    """Whether what stands behind `from` is a variable that holds an agent."""
    name = written.participant.text
    known = checker.scope.variables.get(name)
    return (
        checker.scope.participant is not None
        and name not in checker.scope.parties
        and known is not None
        and known[1] == AGENT
    )


def _senders(checker: Checker, written: tree.Received) -> tuple[str, ...]:
    performative, message = written.performative.text, written.message.text
    parties = checker.scope.parties
    own = parties[checker.scope.participant or ""]
    others = [party for party in parties.values() if party is not own]
    found = [
        party.name
        for party in others
        if (performative, message) in [(item.performative, item.message) for item in party.sends]
    ]
    if not found and is_answered(performative, message, [item.message for item in own.sends]):
        asked = {(item.performative, item.message) for item in own.sends if item.message == message}
        found = [
            party.name
            for party in others
            if any((item.performative, item.message) in asked for item in party.receives)
        ]
    return tuple(found)


def only_from(checker: Checker, written: tree.TransitionExpression) -> amola.Value | None:
    """What has to hold so that the message is of the agent behind `from`: `sender(…) == best` (E567)."""
    named = [
        item for item in written.events if isinstance(item, tree.Received) and _names_agent(checker, item)
    ]
    if not named:
        return None
    first = named[0]
    same = [item for item in named if item.participant.text == first.participant.text]
    if written.when or len(same) < len(written.events):
        checker.report(problems.AgentAmongOthers(first.participant.text), first.participant.span)
        return None
    key, kind = checker.scope.variables[first.participant.text]
    span = first.participant.span
    called = (first.name or first.message).text
    sender = amola.Sender(called, span)
    return amola.Compare("==", sender, amola.VariableValue(key, kind, span), span)


def lost(checker: Checker, written: tree.Lost) -> amola.Lost | None:
    """`lost contractor c`: E205."""
    scope, name = checker.scope, written.participant
    if scope.participant is None:
        checker.report(problems.ExchangeOutsideProtocol("lost"), written.span)
        return None
    if name.text not in scope.parties:
        if not scope.symbols.is_excused(name.text):
            checker.diagnostics.append(unknown(NoPartner, name, scope.parties))
        return None
    return amola.Lost(name.text, written.span, written.name.text if written.name is not None else "")


def taken_by(checker: Checker, written: tree.TransitionExpression) -> Taken | None:
    """What the condition and the actions may call the message that the transition takes (E226, E530).

    Without a name the one message that is waited for is called by its performative and type.
    """
    events = written.events
    named = [item for item in events if isinstance(item, tree.Received | tree.Lost) and item.name is not None]
    if not named:
        only = events[0] if len(events) == 1 and not written.when else None
        if isinstance(only, tree.Received):
            return Taken("", only.performative.text, only.message.text, False, only.span)
        return None
    first = named[0]
    assert first.name is not None
    taken = _taken(first, first.name)
    for item in events:
        if isinstance(item, tree.Received | tree.Lost) and item.name is not None:
            other = _taken(item, item.name)
            if (other.name, other.message, other.lost) == (taken.name, taken.message, taken.lost):
                continue
            if other.name == taken.name:
                taken = replace(taken, message="", lost=False)  # nothing is known of it
        related = (Related(first.span, f"`{first.name}` is named here"),)
        checker.report(problems.NotAlwaysBound(first.name.text, on_when=False), item.span, related)
        return taken
    if written.when:
        checker.report(problems.NotAlwaysBound(first.name.text, on_when=True), first.span)
    _check_name(checker, first.name)
    return taken


def _taken(event: tree.Received | tree.Lost, name: tree.Name) -> Taken:
    if isinstance(event, tree.Lost):
        return Taken(name.text, "", "", True, name.span)
    return Taken(name.text, event.performative.text, event.message.text, False, name.span)


def _check_name(checker: Checker, name: tree.Name) -> None:
    """E226 where a message cannot have this name."""
    scope, symbols = checker.scope, checker.scope.symbols
    reason = reserved(name.text)
    if name.text in scope.variables:
        reason = "variable"
    elif name.text in scope.lets:
        reason = "let"
    elif name.text in scope.parties:
        reason = "participant"
    elif symbols.enum(name.text) is not None:
        reason = "enum"
    elif symbols.topic(name.text) is not None:
        reason = "topic"
    if reason is not None:
        checker.report(problems.BoundNameTaken(name.text, reason), name.span)


def check_use(checker: Checker, taken: Taken | None, typed: amola.TransitionExpression) -> None:
    """W551 for a name that neither the condition nor the actions use, of which nothing is left out."""
    if taken is None or not taken.name or checker.diagnostics or amola.taken_message(typed):
        return
    checker.report(problems.BoundNameUnused(taken.name), taken.span)


# ---- sending -----------------------------------------------------------------------------------


def send(checker: Checker, written: tree.Send, value: Typed) -> amola.Send | None:
    """`send accept_proposal Award { task = job } to best except c`: E205, E225, E511, E512, E531, E532."""
    scope, name = checker.scope, written.participant
    to: Value | None = None
    is_party = name is not None and (name.text in scope.parties or written.one is not None)
    participant = ""
    if name is not None and (is_party or not _may_be_agent(checker, name)):
        if not _is_exchanged(checker, written.performative, written.message, name, True):
            return None
        participant = name.text
    else:
        path = tree.Path((name,), name.span) if name is not None else None
        receiver = written.receiver if path is None else path
        assert receiver is not None
        fits = _is_exchanged(checker, written.performative, written.message, None, True)
        to = _agent(checker, receiver, value)
        if to is None or not fits:
            return None
        if written.excepts:
            checker.report(problems.ExceptOfOneAgent(), written.excepts[0].span)
            return None
    excepts = [_agent(checker, item, value) for item in written.excepts]
    fills, rest = None, Rest()
    if written.fills is not None:
        found = fill(checker, written.message.text, written.fills, value)
        said = None if found is None else rest_of(checker, written, found, value)
        if found is None or said is None:
            return None
        fills, rest = tuple(found), said
    reply_by = None
    if written.reply_by is not None:
        reply_by = deadline(checker, written.reply_by, value)
        if reply_by is None:
            return None
    if None in excepts:
        return None
    return amola.Send(
        written.performative.text,
        written.message.text,
        participant,
        written.span,
        fills,
        to,
        tuple(item for item in excepts if item is not None),
        rest.is_default,
        rest.message,
        rest.taken,
        reply_by,
        written.one is not None,
    )


def _may_be_agent(checker: Checker, name: tree.Name) -> bool:
    """Whether what stands behind `to` names a value rather than a participant."""
    scope = checker.scope
    is_lost = scope.taken is not None and scope.taken.name == name.text
    return name.text in scope.variables or name.text in scope.lets or is_lost


def _agent(checker: Checker, written: tree.Expression, value: Typed) -> Value | None:
    """A value of type agent (E531)."""
    found = value(checker, written)
    if found is None or found.type == AGENT:
        return found
    bound = found.name if isinstance(found, amola.Bound) and not found.path else None
    checker.report(problems.NotAnAgent(str(found.type), bound), written.span)
    return None


# ---- who exchanges what ------------------------------------------------------------------------


def _is_exchanged(
    checker: Checker, performative: tree.Name, message: tree.Name, other: tree.Name | None, sending: bool
) -> bool:
    """Whether the participant sends (or receives) this message to (from) the other one: E205, E511, E512.

    Without another one some participant has to receive it (E532).
    """
    scope = checker.scope
    if performative.text not in PERFORMATIVES:
        checker.diagnostics.append(unknown_performative(performative))
        return False
    if scope.participant is None:
        outside = problems.ExchangeOutsideProtocol("sent" if sending else "received")
        checker.report(outside, performative.span.to((other or message).span))
        return False
    if other is not None and other.text not in scope.parties:
        if not scope.symbols.is_excused(other.text):
            pool = set(scope.parties)
            if sending:
                pool |= {name for name, (_, kind) in scope.variables.items() if kind == AGENT}
                pool |= {name for name, let in scope.lets.items() if let.value and let.value.type == AGENT}
            checker.diagnostics.append(unknown(NoPartner, other, pool, tuple(sorted(scope.parties))))
        return False
    if scope.symbols.is_excused(message.text) and scope.symbols.message(message.text) is None:
        return False
    own = scope.parties[scope.participant]
    if other is None:
        return _lists(checker, own, "sends", performative, message) and _somebody_receives(
            checker, performative, message
        )
    peer = scope.parties[other.text]
    if not _lists(checker, own, "sends" if sending else "receives", performative, message):
        return False
    if not sending and is_answered(performative.text, message.text, [item.message for item in own.sends]):
        return True
    return _lists(checker, peer, "receives" if sending else "sends", performative, message)


def is_answered(performative: str, message: str, sent: Collection[str]) -> bool:
    """Whether this is the runtime's answer to an unexpected message, which no participant has to list.

    `sent` are the types of the messages that the receiver of the answer sends.
    """
    return performative == NOT_UNDERSTOOD and message in sent


def _lists(checker: Checker, party: Party, verb: Verb, performative: tree.Name, message: tree.Name) -> bool:
    listed = party.sends if verb == "sends" else party.receives
    said = f"{performative} {message}"
    texts = [f"{item.performative} {item.message}" for item in listed]
    if said in texts:
        return True
    if not party.wrong.isdisjoint((performative.text, message.text)):
        return False  # it may be what is wrong there
    first, _, near = (closest(said, texts) or "").partition(" ")
    close = near if first == performative.text else None
    problem = NotListed(message.text, close, tuple(texts), party.name, verb, performative.text, party.lists)
    span = message.span if close is not None else performative.span.to(message.span)
    related = (Related(party.span, "the participant"),)
    checker.report(problem, span, related, close)
    return False


def _somebody_receives(checker: Checker, performative: tree.Name, message: tree.Name) -> bool:
    said = (performative.text, message.text)
    parties = checker.scope.parties.values()
    if any(said in [(item.performative, item.message) for item in party.receives] for party in parties):
        return True
    if any(not party.wrong.isdisjoint(said) for party in parties):
        return False
    problem = problems.NobodyReceives(performative.text, message.text, all(party.lists for party in parties))
    checker.report(problem, performative.span.to(message.span))
    return False


__all__ = ["check_use", "is_answered", "lost", "only_from", "received", "send", "taken_by"]
