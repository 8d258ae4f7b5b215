"""Busy: whether all instances of a participant are in use, and what an invitation is answered then."""

from __future__ import annotations

from dataclasses import is_dataclass

from aseme_dsl.runtime.chart.board import built
from aseme_dsl.runtime.chart.plan import BranchInfo
from aseme_dsl.runtime.conversation.participation import Desk
from aseme_dsl.runtime.message.acl import NOT_UNDERSTOOD, AclMessage
from aseme_dsl.runtime.ports import Receiver


def is_busy(agent: Receiver, desk: Desk, info: BranchInfo) -> bool:
    """Whether some instance of a participant is in use, and no other one can be entered beside those."""
    part = info.protocol, info.participant
    used = [
        place.info.label
        for place in desk.branches.values()
        if place.part == part and place.conversation is not None
    ]
    plan = agent.plan
    others = [
        item.label
        for item in plan.branches
        if (item.protocol, item.participant) == part and item.label not in used
    ]
    return bool(used) and not any(all(plan.are_concurrent(one, other) for other in used) for one in others)


def answer_of(agent: Receiver, info: BranchInfo, invitation: AclMessage) -> tuple[str, str, object] | None:
    """What a busy participant says to who invites it: performative, message and content.

    None: it does not understand the invitation now.
    """
    assert info.busy is not None
    performative, message, fills = info.busy
    if performative == NOT_UNDERSTOOD:
        return None
    if fills is None:
        return performative, message, agent.understood(invitation.content)
    kind = agent.kinds[message]
    assert is_dataclass(kind)
    return performative, message, built(kind, dict(fills), {})


__all__ = ["answer_of", "is_busy"]
