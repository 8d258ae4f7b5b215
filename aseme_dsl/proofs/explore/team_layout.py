"""Layout of a team that is explored: which of its objects and attributes are its state."""

from __future__ import annotations

from collections.abc import Mapping

from aseme_dsl.proofs.explore.deciding.acting import Acting
from aseme_dsl.proofs.explore.deciding.choosing import Choices
from aseme_dsl.proofs.explore.deciding.later import Decided
from aseme_dsl.proofs.explore.deciding.order import AnyNumber, Known, Order
from aseme_dsl.proofs.explore.deciding.staging import Open
from aseme_dsl.proofs.explore.deciding.values import Values
from aseme_dsl.proofs.explore.memory import Layout
from aseme_dsl.proofs.explore.surroundings import Still, StillClock, Ways
from aseme_dsl.proofs.timed.zone import Zone
from aseme_dsl.runtime.activity.execution import Execution
from aseme_dsl.runtime.activity.executions import Executions, _Node
from aseme_dsl.runtime.activity.plan_code import PlanCode
from aseme_dsl.runtime.agent.agent import Agent
from aseme_dsl.runtime.agent.effects import Effects
from aseme_dsl.runtime.agent.untakable import Untakable
from aseme_dsl.runtime.channel.bus import Bus
from aseme_dsl.runtime.channel.routes import Routes
from aseme_dsl.runtime.chart import inputs
from aseme_dsl.runtime.chart.plan import ActivityInfo, BranchInfo, Plan
from aseme_dsl.runtime.conversation.choosing import Choosing
from aseme_dsl.runtime.conversation.conversation import Conversations
from aseme_dsl.runtime.conversation.conversation_trace import ConversationTrace
from aseme_dsl.runtime.conversation.counting import Counting
from aseme_dsl.runtime.conversation.directory import Directory, Entry
from aseme_dsl.runtime.conversation.exchange.external_inbox import ExternalInbox
from aseme_dsl.runtime.conversation.exchange.external_outbox import ExternalOutbox
from aseme_dsl.runtime.conversation.exchange.given import Giving
from aseme_dsl.runtime.conversation.exchange.members import Members
from aseme_dsl.runtime.conversation.exchange.participant_delivery import Delivery
from aseme_dsl.runtime.conversation.exchange.parts import Parts
from aseme_dsl.runtime.conversation.exchange.sending import Sending
from aseme_dsl.runtime.conversation.free_messages import FreeMessages
from aseme_dsl.runtime.conversation.losses import Losses
from aseme_dsl.runtime.conversation.management import Management
from aseme_dsl.runtime.conversation.participation import Conversation, Desk, Participation
from aseme_dsl.runtime.message.acl import AclMessage
from aseme_dsl.runtime.time.timers import Timer
from aseme_dsl.runtime.trace.trace import Trace
from aseme_dsl.runtime.transport.port import Transport
from aseme_dsl.runtime.version.loading import Loaded


def layout_of(
    loaded: Loaded, further: Mapping[type, tuple[str, ...]], without: Mapping[type, frozenset[str]]
) -> Layout:
    """The layout of a team; `further` are more parts, `without` more of what makes no difference."""
    values = (
        *(inputs.Sample, inputs.AgentMessage, inputs.Addressed, inputs.Settled, inputs.Start),
        *(AclMessage, BranchInfo, ActivityInfo),
        *(kind for kind in loaded.messages.values() if isinstance(kind, type)),
    )
    constant = (
        *(Plan, Trace, Routes, PlanCode, Effects, ConversationTrace, StillClock, Choices, Values),
        *(Giving, Delivery, FreeMessages, ExternalOutbox, ExternalInbox, Losses, Counting, Parts, Sending),
        *(Transport, Management, Conversations, Entry, Open, Acting, AnyNumber, Zone, Order),
    )
    parts = {
        Agent: (
            *("chart", "executions", "_untakable", "steps", "stopped", "down"),
            *("_sequence", "_wanted", "_following", "_has_other_chart", "_configuration"),
        ),
        Executions: ("_nodes", "_former"),
        _Node: ("starts", "last_start", "last_end", "current", "next", "held", "waits", "made"),
        Execution: (
            *("cancelled", "error", "has_returned", "result", "start", "timer"),
            *("sent", "made", "earlier", "dropped", "handle"),
        ),
        Untakable: ("_seen",),
        Members: ("desks", "conversations", "over", "opened"),
        Directory: ("_team", "_gone", "_entries"),
        Bus: ("_held", "_given"),
        Still: ("running", "timers"),
        Timer: ("call", "moment"),
        Ways: ("ways",),
    }
    unkeyed = {
        Agent: frozenset(("_sequence", "steps", "_configuration")),
        Execution: frozenset(("number", "started")),
        inputs.Start: frozenset(("token", "arguments")),
        _Node: frozenset(("starts", "last_start", "last_end")),
        Still: frozenset(("running",)),
        Bus: frozenset(("_given",)),
        Directory: frozenset(("_entries",)),
        Members: frozenset(("opened",)),
        Conversation: frozenset(("left",)),
        Desk: frozenset(("heard",)),
        Choosing: frozenset(("_count", "_addressed")),
        Participation: frozenset(("spoken",)),
        Decided: frozenset(("values", "made")),
        Known: frozenset(("zone", "whole", "loose", "made")),
    }
    ordered = {
        Desk: lambda desk: tuple((part, tuple(places)) for part, places in sorted(desk.free.items())),
        Choosing: lambda item: tuple(sorted(item._addressed, key=item._addressed.__getitem__)),
    }
    return Layout(values, constant, {**parts, **further}, {**unkeyed, **without}, ordered)


__all__ = ["layout_of"]
