"""What an agent does that somebody else has written: each role of FIPA's protocols, by message.

It knows FIPA's parameters of messages and the fields of the contents, and nothing of ours. `by_hand_spade.py`
and `by_hand_mango.py` are such agents on their platforms.
"""

from __future__ import annotations

import itertools
import json
from dataclasses import dataclass, field, replace
from typing import Any

Headers = dict[str, str]
Sent = tuple[str, Headers, str]
"""Whom to send what: an address, headers and a content."""

SENDER = ""
ORDER = {"id": "1", "what": "soup"}
DONE = {"id": "1", "detail": "hot"}
ABOUT = {"id": "1", "about": "the soup"}
WHEN = {"id": "1", "what": "serve", "condition": "it is hot"}
CONTRACT = {"job": "1", "contractor": "bob"}
LOT, OFFER = {"id": "fish", "price": 10.0}, {"lot": "fish", "price": 10.0}
SALE = {"lot": "fish", "winner": "me", "price": 10.0}
ERRAND = {"id": "1", "what": "soup", "wanted": "cook"}
MATCH = {"errand": "1", "provider": "cid"}
"""Our provider by the name that it has in the directory."""
NEED = {"id": "1", "what": "the lift", "priority": 0, "lease": 10_000_000_000}
LEASE = {"id": "1", "lasts": 10_000_000_000}


@dataclass(frozen=True)
class Does:
    """What is sent: the performative and content, to whom (a part, or whoever has said it), and then done."""

    act: str
    content: dict[str, Any]
    to: str = SENDER
    last: bool = False


def end() -> Does:
    return Does("", {}, last=True)


Role = dict[tuple[str, int], list[Does]]
"""What is done when a performative is heard for the n-th time; with "", at the beginning."""

ROLES: dict[str, Role] = {
    "request.initiator": {("", 1): [Does("request", ORDER, "responder")], ("inform", 1): [end()]},
    "request.responder": {("request", 1): [Does("agree", ORDER), Does("inform", DONE, last=True)]},
    "query.initiator": {("", 1): [Does("query-ref", ABOUT, "responder")], ("inform", 1): [end()]},
    "query.responder": {
        ("query-ref", 1): [
            Does("agree", ABOUT),
            Does("inform", {"id": "1", "holds": True, "value": "hot"}, last=True),
        ]
    },
    "request_when.initiator": {
        ("", 1): [Does("request-when", WHEN, "responder")],
        ("inform", 1): [end()],
    },
    "request_when.responder": {("request-when", 1): [Does("agree", WHEN), Does("inform", DONE, last=True)]},
    "contract_net.manager": {
        ("", 1): [Does("cfp", ORDER, "contractor")],
        ("propose", 1): [Does("accept-proposal", CONTRACT)],
        ("inform", 1): [end()],
    },
    "contract_net.contractor": {
        ("cfp", 1): [Does("propose", {"job": "1", "cost": 7.0})],
        ("accept-proposal", 1): [Does("inform", DONE, last=True)],
    },
    "iterated_contract_net.manager": {
        ("", 1): [Does("cfp", ORDER, "contractor")],
        ("propose", 1): [Does("cfp", {"id": "1", "what": "cheaper"})],
        ("propose", 2): [Does("accept-proposal", CONTRACT)],
        ("inform", 1): [end()],
    },
    "iterated_contract_net.contractor": {
        ("cfp", 1): [Does("propose", {"job": "1", "cost": 7.0})],
        ("cfp", 2): [Does("propose", {"job": "1", "cost": 5.0})],
        ("accept-proposal", 1): [Does("inform", DONE, last=True)],
    },
    "subscribe.initiator": {
        ("", 1): [Does("subscribe", ABOUT, "responder")],
        ("inform", 2): [Does("cancel", ABOUT)],
        ("inform", 3): [end()],
    },
    "subscribe.responder": {
        ("subscribe", 1): [
            Does("agree", ABOUT),
            *(Does("inform", {"id": "1", "value": value}) for value in ("cold", "warm", "hot")),
        ],
        ("cancel", 1): [Does("inform", ABOUT, last=True)],
    },
    "auction.auctioneer": {
        ("", 1): [Does("inform", LOT, "bidder"), Does("cfp", LOT, "bidder")],
        ("propose", 1): [Does("accept-proposal", OFFER), Does("request", SALE)],
        ("confirm", 1): [end()],
    },
    "auction.bidder": {
        ("cfp", 1): [Does("propose", OFFER)],
        ("request", 1): [Does("confirm", SALE, last=True)],
    },
    "dutch_auction.auctioneer": {
        ("", 1): [Does("inform", LOT, "bidder"), Does("cfp", LOT, "bidder")],
        ("propose", 1): [Does("accept-proposal", OFFER), Does("request", SALE)],
        ("confirm", 1): [end()],
    },
    "dutch_auction.bidder": {
        ("cfp", 1): [Does("propose", OFFER)],
        ("request", 1): [Does("confirm", SALE, last=True)],
    },
    "propose.initiator": {
        ("", 1): [Does("propose", ORDER, "responder")],
        ("accept-proposal", 1): [end()],
    },
    "propose.responder": {("propose", 1): [Does("accept-proposal", ORDER, last=True)]},
    "brokering.client": {("", 1): [Does("proxy", ERRAND, "broker")], ("inform", 1): [end()]},
    "brokering.broker": {
        ("proxy", 1): [Does("agree", ERRAND), Does("request", ERRAND, "provider")],
        ("inform", 1): [Does("inform", DONE, "client", last=True)],
    },
    "brokering.provider": {("request", 1): [Does("agree", ERRAND), Does("inform", DONE, last=True)]},
    "recruiting.client": {("", 1): [Does("proxy", ERRAND, "recruiter")], ("inform", 2): [end()]},
    "recruiting.recruiter": {
        ("proxy", 1): [Does("agree", ERRAND), Does("request", ERRAND, "provider")],
        ("agree", 1): [Does("inform", MATCH, "client", last=True)],
    },
    "recruiting.provider": {
        ("request", 1): [
            Does("agree", ERRAND),
            Does("inform", DONE, "client", last=True),
        ]
    },
    "resource.holder": {
        ("", 1): [Does("request", NEED, "keeper")],
        ("propose", 1): [Does("request", LEASE)],
        ("inform", 1): [Does("cancel", NEED)],
        ("inform", 2): [end()],
    },
    "resource.keeper": {
        ("request", 1): [Does("agree", NEED), Does("propose", LEASE)],
        ("request", 2): [Does("inform", LEASE)],
        ("cancel", 1): [Does("inform", NEED, last=True)],
    },
}
WAYS = {
    "honest": "as the protocol has it",
    "twice": "each move twice",
    "early": "all moves at once",
    "lying": "also what only the other parts may say, in this conversation and in one that there is not",
    "late": "each move only after the others' deadlines",
    "foreign": "each answer with the name of a conversation that there is not",
    "silent": "it begins or registers, and never answers",
    "half": "its first answer, and no other",
    "leaving": "its process is gone when it is to answer first",
    "returning": "its process is gone after the first answer, and there is a new one",
}
"""How an agent plays its role."""
LATE = 4.0
"""How many seconds after what it has heard a late agent makes its moves."""
OPENERS = {"request", "query-ref", "request-when", "cfp", "propose", "subscribe", "proxy"}
"""What begins a conversation, so that who says it has one of its own."""
NAMES = {"auction": "fipa-auction-english", "dutch_auction": "fipa-auction-dutch", "resource": "resource"}
"""The names on the wire that are not `fipa-` and the protocol's."""


@dataclass
class Hand:
    """An agent that plays one role once."""

    role: str
    partners: dict[str, str]
    """The address of each other part."""
    directory: str
    """Who is told by agent management that this one offers its role."""
    way: str = "honest"
    """How it does that, one of `WAYS`."""
    heard: list[str] = field(default_factory=list)
    over: bool = False
    refused: str = ""
    """What it was told that it has done wrong."""

    def __post_init__(self) -> None:
        self._numbers = itertools.count(1)
        self._answers = 0
        self._has_said_all = False
        self._seen: dict[str, int] = {}
        self._conversation = f"by-hand-{self.role}"
        protocol = self.role.partition(".")[0]
        self._protocol = NAMES.get(protocol) or "fipa-" + protocol.replace("_", "-")

    def begin(self) -> list[Sent]:
        """Say what the role begins with, or else register in FIPA's language."""
        if ("", 1) in ROLES[self.role]:
            return self._do(("", 1), "", "")
        service = f"(service-description :type {self.role} :protocols (set {self._protocol}))"
        content = (
            "((action (agent-identifier :name df) (register (df-agent-description"
            f" :services (set {service})))))"
        )
        headers = {
            "performative": "request",
            "language": "fipa-sl0",
            "ontology": "fipa-agent-management",
            "protocol": "fipa-request",
            "conversation-id": "registration",
            "reply-with": "registration-1",
        }
        return [(self.directory, headers, content)]

    def hear(self, sender: str, headers: Headers, content: str) -> list[Sent]:
        """What is answered to a message."""
        act = headers.get("performative", "")
        self.heard.append(act)
        if act == "not-understood" and self.way == "honest":
            self.refused = content
        if headers.get("ontology") == "fipa-agent-management":
            return []
        assert headers.get("protocol") == self._protocol, headers
        self._conversation = headers["conversation-id"]
        number = self._seen[act] = self._seen.get(act, 0) + 1
        return self._do((act, number), sender, headers.get("reply-with", ""))

    @property
    def waits(self) -> float:
        """How many seconds go by before it makes a move."""
        return LATE if self.way == "late" and self._answers > 0 else 0.0

    @property
    def breaks(self) -> bool:
        """Whether its process is to end, at once and without a word."""
        return self.way in ("leaving", "returning") and self._answers > 0

    def _do(self, when: tuple[str, int], sender: str, reply_with: str) -> list[Sent]:
        does = ROLES[self.role].get(when, [])
        if when[0] and does:
            self._answers += 1
            if self.way in ("silent", "leaving") or (self.way in ("half", "returning") and self._answers > 1):
                return []
            if self.way in ("half", "returning"):
                does = does[:1]
        if self.way == "early":
            does = [item for part in ROLES[self.role].values() for item in part] if does else []
            does, self._has_said_all = [] if self._has_said_all else does, bool(does) or self._has_said_all
        elif self.way == "twice":
            does = [item for item in does for _ in range(2)]
        said = [self._said(item, sender, reply_with) for item in does if item.act]
        self.over = self.over or any(item.last for item in does)
        return [*(self._lies() if does and self.way == "lying" else []), *said]

    def _said(self, does: Does, sender: str, reply_with: str, conversation: str = "") -> Sent:
        headers = {
            "performative": does.act,
            "protocol": self._protocol,
            "conversation-id": conversation or self._called(does),
            "reply-with": f"{self.role}-{next(self._numbers)}",
        }
        if does.to == SENDER and reply_with:
            headers["in-reply-to"] = reply_with
        to = self.partners[does.to] if does.to != SENDER else sender or next(iter(self.partners.values()))
        return to, headers, json.dumps(does.content)

    def _called(self, does: Does) -> str:
        """The name of the conversation in which something is said."""
        if self.way == "foreign" and does.act not in OPENERS:
            return f"{self._conversation}-of-somebody-else"
        return self._conversation

    def _lies(self) -> list[Sent]:
        """What the other parts say, to everybody, in this conversation and in one that there is not."""
        protocol = self.role.partition(".")[0]
        mine = {item.act for part in ROLES[self.role].values() for item in part}
        others = [
            item
            for role, parts in ROLES.items()
            if role.partition(".")[0] == protocol and role != self.role
            for part in parts.values()
            for item in part
            if item.act and item.act not in mine
        ]
        return [
            self._said(replace(item, to=to), "", "", conversation)
            for item in others
            for to in self.partners
            for conversation in ("", "of-nobody")
            if item.act not in OPENERS or not conversation
        ]
