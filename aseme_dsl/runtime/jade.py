"""For people who come from JADE: behaviours that a jade_like agent adds, and their messages."""

from __future__ import annotations

from aseme_dsl.runtime.agent.added_behaviours import (
    ALL,
    ANY,
    Behaviour,
    CompositeBehaviour,
    CyclicBehaviour,
    FSMBehaviour,
    OneShotBehaviour,
    ParallelBehaviour,
    SequentialBehaviour,
    SimpleBehaviour,
    TickerBehaviour,
    WakerBehaviour,
)
from aseme_dsl.runtime.agent.data_store import DataStore
from aseme_dsl.runtime.agent.fipa_callbacks import FailureException, RefuseException
from aseme_dsl.runtime.conversation.directory import Service
from aseme_dsl.runtime.message.free import ACLMessage, MessageTemplate, all_of, any_of, not_

__all__ = [
    "ALL",
    "ANY",
    "ACLMessage",
    "Behaviour",
    "CompositeBehaviour",
    "CyclicBehaviour",
    "DataStore",
    "FSMBehaviour",
    "FailureException",
    "MessageTemplate",
    "OneShotBehaviour",
    "ParallelBehaviour",
    "RefuseException",
    "SequentialBehaviour",
    "Service",
    "SimpleBehaviour",
    "TickerBehaviour",
    "WakerBehaviour",
    "all_of",
    "any_of",
    "not_",
]
