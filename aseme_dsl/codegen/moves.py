"""Moves: which agent messages the activities of a participant may send, and in which states."""

from __future__ import annotations

from aseme_dsl.amola.aip import AgentMessage, Participant
from aseme_dsl.amola.expression import Send
from aseme_dsl.amola.statechart import State, Statechart, StateType
from aseme_dsl.records import dataclass


@dataclass(frozen=True, slots=True)
class Move:
    """A message of `sends` that no transition sends: the states whose activities may, and how often.

    Labels count from the participant's subchart (`.2.1`), the same in the protocol and in every role.
    """

    performative: str
    message: str
    states: tuple[str, ...]
    repeatedly: bool


def subchart_of(eac: Statechart, participant: str) -> State | None:
    """The subchart of a participant in the statechart of its protocol; of several, the first."""
    return next(
        (
            node
            for node in eac.states
            if (node.origin.owner, node.origin.name) == (eac.name, participant) and eac.is_branch(node)
        ),
        None,
    )


def sent_by_transitions(eac: Statechart, subchart: str) -> dict[tuple[str, str], Send]:
    """The messages that the transitions of a participant send, each with a place where one does."""
    found: dict[tuple[str, str], Send] = {}
    for transition in eac.transitions:
        if eac.branch_of(transition.source) == subchart and transition.source != subchart:
            for action in transition.expression.actions:
                if isinstance(action, Send):
                    found.setdefault((action.performative, action.message), action)
    return found


def sent_by_abandon(eac: Statechart, subchart: str) -> frozenset[tuple[str, str]]:
    """The messages that a participant sends when it is left before its END."""
    return frozenset((item.performative, item.message) for item in farewells_of(eac, subchart))


def farewells_of(eac: Statechart, subchart: str) -> tuple[Send, ...]:
    """What sends when a participant is left before its END."""
    return tuple(
        action
        for transition in eac.abandons.get(subchart, ())
        for action in transition.expression.actions
        if isinstance(action, Send)
    )


def moves_of(eac: Statechart, participant: Participant) -> tuple[Move, ...]:
    """What the activities of a participant may send: what no transition sends, by whom the protocol names."""
    subchart = subchart_of(eac, participant.name)
    if subchart is None:
        return ()
    sent = sent_by_transitions(eac, subchart.label)
    farewells = sent_by_abandon(eac, subchart.label)
    acting = [
        node
        for node in eac.states
        if node.type is StateType.BASIC and node.activity and eac.branch_of(node.label) == subchart.label
    ]
    return tuple(
        Move(
            item.performative,
            item.message,
            tuple(node.label[len(subchart.label) :] for node in acting if _may_send(node, item)),
            item.repeatedly,
        )
        for item in participant.sends
        if (item.performative, item.message) not in sent
        and (item.by or (item.performative, item.message) not in farewells)
    )


def _may_send(node: State, message: AgentMessage) -> bool:
    return not message.by or node.activity in message.by


__all__ = ["Move", "farewells_of", "moves_of", "sent_by_abandon", "sent_by_transitions", "subchart_of"]
