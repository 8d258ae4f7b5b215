"""Agent management: the agents `df` and `ams`, by which those that are not of the team use the directory.

They speak FIPA's agent management (SC00023) with contents in JSON, named as FIPA names them. `request` asks
for an action:

    {"action": "register", "description": {"name": "alice@host", "services": [{"type": "weather"}]}}
    {"action": "search", "description": {"services": [{"type": "net.contractor"}]}, "max-results": 3}

`df` knows register, modify, deregister and search, and `subscribe` with a `description`; `ams` knows search
and get-description. The answer is `inform` with the `result`, or `refuse`, `failure` or `not-understood` with
FIPA's `error` and the `reason` in words. What has changed is told to a subscriber by `inform` with `changes`,
until it sends `cancel` in that conversation.

On a network, where `df` has no address, each agent of the team takes what is for it: messages of the ontology
`fipa-agent-management`.
"""

from __future__ import annotations

import itertools
import json
from collections.abc import Callable, Container, Iterable
from typing import Any

from aseme_dsl import outside
from aseme_dsl.runtime.conversation.directory import (
    Change,
    Directory,
    DirectoryError,
    Entry,
    Service,
    as_json,
)
from aseme_dsl.runtime.message.acl import JSON, AgentIdentifier, FipaMessage, fipa_name, performative_of
from aseme_dsl.runtime.time.clock import SECOND

DF, AMS = "df", "ams"
MANAGERS = (DF, AMS)
ONTOLOGY = "fipa-agent-management"
SUBSCRIBERS = 1000
"""So many subscriptions there are at the most."""

_ACTIONS = {DF: ("register", "modify", "deregister", "search"), AMS: ("search", "get-description")}
_LISTS = ("protocols", "ontologies", "languages")
_SERVICE = ("type", "name", *_LISTS, "ownership", "properties")
_ENTRY = ("name", "addresses", "services", *_LISTS, "lease-time")

Say = Callable[[str, FipaMessage, Iterable[AgentIdentifier]], None]
"""What brings a message of a manager to agents outside."""


class _Refused(Exception):
    """What is answered instead of a result: the act, FIPA's word for the error, and the reason."""

    def __init__(self, act: str, error: str, reason: str) -> None:
        super().__init__(reason)
        self.act = act
        self.error = error


class Management:
    """The managers of a process."""

    def __init__(self, directory: Directory, system: str, say: Say, team: Container[str]) -> None:
        """`team` holds the names of the team's agents, which nobody else manages."""
        self._directory = directory
        self._system = system
        self._say = say
        self._team = team
        self._subscriptions: dict[tuple[str, str], tuple[Entry, str, FipaMessage]] = {}
        self._numbers = itertools.count(1)
        directory.listen(self._changed)

    def is_meant(self, to: str, message: FipaMessage) -> bool:
        """Whether a message to an agent of that name is for a manager."""
        if to in self._team:
            return message.ontology.lower() == ONTOLOGY
        return to in MANAGERS

    def hear(self, to: str, message: FipaMessage) -> None:
        """An agent that is not of the team has sent a message for a manager to it or an agent."""
        manager = AMS if to == AMS and to not in self._team else DF
        act = performative_of(message.performative)
        if message.sender is None or not message.sender.name:
            self._directory.tell(to, "not-understood", "a message does not say who has sent it")
            return
        if act == "not_understood":
            self._directory.tell(message.sender.name, "not-understood", f"it does not understand {manager}")
            return
        try:
            self._answer(to, message, *self._done(manager, to, message, act))
        except _Refused as problem:
            self._directory.tell(message.sender.name, problem.act, str(problem))
            content = {"error": problem.error, "reason": str(problem)}
            self._answer(to, message, problem.act, content)
        except DirectoryError as problem:
            self._directory.tell(message.sender.name, "failure", str(problem))
            self._answer(to, message, "failure", {"error": problem.error, "reason": str(problem)})

    def _answer(self, name: str, asked: FipaMessage, act: str, content: Any) -> None:
        to = asked.reply_to or (() if asked.sender is None else (asked.sender,))
        message = FipaMessage(
            fipa_name(act),
            AgentIdentifier(name),
            to,
            json.dumps(content, ensure_ascii=False),
            language=JSON,
            ontology=asked.ontology or ONTOLOGY,
            protocol=asked.protocol,
            conversation=asked.conversation,
            reply_with=f"{DF}-{next(self._numbers)}",
            in_reply_to=asked.reply_with,
        )
        self._say(name, message, to)

    # ---- what is asked for -------------------------------------------------------------------

    def _done(self, manager: str, to: str, message: FipaMessage, act: str | None) -> tuple[str, Any]:
        """Do what a message asks for; the act and content of the answer."""
        assert message.sender is not None
        if message.ontology.lower() not in ("", ONTOLOGY):
            raise _Refused("not-understood", "unsupported-value", f"{manager} speaks {ONTOLOGY}")
        if act == "cancel" and manager == DF:
            return self._cancelled(message)
        if act not in ("request", "subscribe") or (act == "subscribe" and manager != DF):
            known = "request, subscribe and cancel" if manager == DF else "request"
            raise _Refused("not-understood", "unsupported-act", f"{manager} understands {known}")
        content = _object(_content(message), "the content")
        if act == "subscribe":
            return self._subscribed(to, message, content)
        action = content.get("action")
        if not isinstance(action, str):
            raise _Refused("refuse", "missing-argument", "the content has no action")
        if action not in _ACTIONS[manager]:
            reason = f"{manager} knows {', '.join(_ACTIONS[manager])}"
            raise _Refused("refuse", "unsupported-function", reason)
        return "inform", {"action": action, "result": self._result(manager, action, content, message)}

    def _result(self, manager: str, action: str, content: dict[str, Any], message: FipaMessage) -> Any:
        assert message.sender is not None
        sender = message.sender
        _only(content, ("action", "description", "max-results"), "the content")
        if action == "get-description":
            services = [{"name": item, "type": f"fipa.{item}"} for item in MANAGERS]
            return {"name": self._system, "ap-services": services}
        given = _object(content.get("description", {}), "the description")
        if manager == AMS:
            return self._residents(given, _most(content))
        entry, lease = _entry(given)
        if action == "search":
            return [_described(found) for found in self._directory.search(entry, _most(content))]
        name = entry.name or sender.name
        if name != sender.name or name in self._team:
            raise _Refused("refuse", "unauthorised", f"{sender.name} may register itself alone, not {name}")
        if action == "deregister":
            self._directory.deregister(name)
            return []
        agent = AgentIdentifier(name, entry.agent.addresses or sender.addresses, sender.resolvers)
        mine = Entry(agent, entry.services, entry.protocols, entry.ontologies, entry.languages)
        change = self._directory.register if action == "register" else self._directory.modify
        return [_described(change(mine, lease), lease)]

    def _residents(self, given: dict[str, Any], most: int | None) -> list[dict[str, str]]:
        """The white pages."""
        _only(given, ("name", "state", "ownership"), "the description")
        found = [
            {"name": item.name, "state": item.state, **({"ownership": item.role} if item.role else {})}
            for item in self._directory.residents()
        ]
        return [item for item in found if all(item.get(key) == value for key, value in given.items())][:most]

    # ---- subscriptions -----------------------------------------------------------------------

    def _subscribed(self, to: str, message: FipaMessage, content: dict[str, Any]) -> tuple[str, Any]:
        assert message.sender is not None
        _only(content, ("description",), "the content")
        pattern, _ = _entry(_object(content.get("description", {}), "the description"))
        if not message.conversation:
            reason = "a subscription is a conversation of its own: the message names none"
            raise _Refused("refuse", "missing-parameter", reason)
        key = message.sender.name, message.conversation
        if key not in self._subscriptions and len(self._subscriptions) >= SUBSCRIBERS:
            raise _Refused("refuse", "internal-error", f"{SUBSCRIBERS} have subscribed already")
        self._subscriptions[key] = pattern, to, message
        self._answer(to, message, "agree", {"description": _described(pattern)})
        return "inform", {"result": [_described(found) for found in self._directory.search(pattern)]}

    def _cancelled(self, message: FipaMessage) -> tuple[str, Any]:
        assert message.sender is not None
        if self._subscriptions.pop((message.sender.name, message.conversation), None) is None:
            raise _Refused("failure", "not-registered", "there is no such subscription")
        return "inform", {"result": []}

    def disappeared(self, name: str) -> None:
        """An agent cannot be reached any more: its subscriptions end.

        They do not end with what it has registered itself, which is another matter.
        """
        for key in [key for key in self._subscriptions if key[0] == name]:
            self._subscriptions.pop(key, None)

    def _changed(self, change: Change) -> None:
        """Tell those who have subscribed."""
        for pattern, to, message in list(self._subscriptions.values()):
            if change.concerns(pattern):
                told = {"what": change.what, "description": _described(change.entry)}
                self._answer(to, message, "inform", {"changes": [told]})


# ---- contents ----------------------------------------------------------------------------------


def _content(message: FipaMessage) -> Any:
    text = message.content
    if message.language.lower() not in ("", JSON):
        raise _Refused("not-understood", "unsupported-value", f"contents are in {JSON}")
    if not isinstance(text, str):
        raise _Refused("not-understood", "unrecognised-value", "the content is no text in UTF-8")
    try:
        found = outside.loads(text)
        json.dumps(found, ensure_ascii=False).encode()
    except (ValueError, RecursionError) as problem:  # half a character is no text, either
        reason = f"the content is no JSON: {problem}"
        raise _Refused("not-understood", "unrecognised-value", reason[:1000]) from None
    return found


def _object(value: Any, what: str) -> dict[str, Any]:
    if not isinstance(value, dict):
        raise _Refused("not-understood", "unrecognised-value", f"{what} is no JSON object")
    return value


def _only(given: dict[str, Any], known: Iterable[str], what: str) -> None:
    strangers = [name for name in given if name not in known]
    if strangers:
        reason = f"{what} has no {strangers[0][:100]}; it has {', '.join(known)}"
        raise _Refused("refuse", "unexpected-parameter", reason)


def _most(content: dict[str, Any]) -> int | None:
    most = content.get("max-results")
    if most is None or (type(most) is int and most < 0):  # FIPA: a negative number is any
        return None
    if type(most) is not int:
        raise _Refused("refuse", "unrecognised-parameter-value", "max-results is a whole number")
    return most


def _entry(given: dict[str, Any]) -> tuple[Entry, int | None]:
    """An entry from its JSON, with its lease in ns."""
    _only(given, _ENTRY, "the description")
    services = given.get("services", [])
    if not isinstance(services, list):
        raise _Refused("refuse", "unrecognised-parameter-value", "services is a list")
    lease = given.get("lease-time")
    if lease is not None and (type(lease) not in (int, float) or not 0 < lease < 1e9):
        raise _Refused("refuse", "unrecognised-parameter-value", "lease-time is a number of seconds")
    agent = AgentIdentifier(_text(given, "name"), _texts(given, "addresses"))
    protocols, ontologies, languages = (_texts(given, name) for name in _LISTS)
    found = tuple(_service(_object(item, "a service")) for item in services)
    entry = Entry(agent, found, protocols, ontologies, languages)
    return entry, None if lease is None else round(lease * SECOND)


def _service(given: dict[str, Any]) -> Service:
    _only(given, _SERVICE, "a service")
    properties = _object(given.get("properties", {}), "properties")
    protocols, ontologies, languages = (_texts(given, name) for name in _LISTS)
    return Service(
        _text(given, "type"),
        _text(given, "name"),
        protocols,
        ontologies,
        languages,
        _text(given, "ownership"),
        tuple((name, _text(properties, name)) for name in properties),
    )


def _text(given: dict[str, Any], name: str) -> str:
    value = given.get(name, "")
    if not isinstance(value, str):
        raise _Refused("refuse", "unrecognised-parameter-value", f"{name[:100]} is a string")
    return value


def _texts(given: dict[str, Any], name: str) -> tuple[str, ...]:
    value = given.get(name, [])
    if not isinstance(value, list) or not all(isinstance(item, str) for item in value):
        raise _Refused("refuse", "unrecognised-parameter-value", f"{name} is a list of strings")
    return tuple(value)


def _described(entry: Entry, lease: int | None = None) -> dict[str, Any]:
    """An entry as JSON; what is empty is left out."""
    found: dict[str, Any] = {
        "name": entry.name,
        "addresses": list(entry.agent.addresses),
        "services": [as_json(service) for service in entry.services],
        "protocols": list(entry.protocols),
        "ontologies": list(entry.ontologies),
        "languages": list(entry.languages),
        "lease-time": None if lease is None else lease / SECOND,
    }
    return {name: value for name, value in found.items() if value}
