"""Agent management: the agents `df` and `ams`, by which those that are not of the team use the directory.

They speak FIPA's agent management (SC00023) with contents in JSON, named as FIPA names them, or in SL
(`management_sl`): the language of a message is that of its answers. `request` asks for an action:

    {"action": "register", "description": {"name": "alice@host", "services": [{"type": "weather"}]}}
    {"action": "search", "description": {"services": [{"type": "net.contractor"}]}, "max-results": 3}

`df` knows register, modify, deregister and search, and `subscribe` with a `description`; `ams` knows search
and get-description. The answer is `inform` with the `result`, or `refuse`, `failure` or `not-understood` with
FIPA's `error` and the `reason` in words. A subscriber learns what has changed by `inform` with `changes`,
until it sends `cancel` in that conversation.

On a network, where `df` has no address, each agent of the team takes what is for it: messages of the ontology
`fipa-agent-management`.
"""

from __future__ import annotations

import itertools
import json
from collections.abc import Callable, Container, Iterable
from datetime import datetime

from aseme_dsl import outside
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.conversation import management_sl
from aseme_dsl.runtime.conversation.directory import (
    Change,
    Directory,
    DirectoryError,
    Entry,
    Service,
    as_json,
)
from aseme_dsl.runtime.conversation.fipa_translation import own_moment
from aseme_dsl.runtime.message.acl import (
    JSON,
    AgentIdentifier,
    FipaMessage,
    Span,
    fipa_name,
    performative_of,
    protocol_of,
    registered_name,
)
from aseme_dsl.runtime.time.clock import SECOND

DF, AMS = "df", "ams"
MANAGERS = (DF, AMS)
ONTOLOGY = "fipa-agent-management"
CONTENT, DESCRIPTION, SERVICE = "content", management_sl.DESCRIPTIONS[DF], "service-description"
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

    def __init__(self, act: str, error: str, reason: str, about: tuple[str, ...] = ()) -> None:
        """`about` are the arguments of the error, as FIPA has them; without them the reason is."""
        super().__init__(reason)
        self.act = act
        self.error = error
        self.about = about or (reason,)


@dataclass(frozen=True, slots=True)
class _Question:
    """A message to a manager, understood: who is to answer, and what is asked for."""

    to: str
    manager: str
    act: str
    message: FipaMessage
    content: dict[str, object]
    sl: management_sl.Asked | None
    """What was asked for in SL; None: in JSON."""

    @property
    def sender(self) -> AgentIdentifier:
        assert self.message.sender is not None
        return self.message.sender


class Management:
    """The managers of a process."""

    def __init__(self, directory: Directory, system: str, say: Say, team: Container[str]) -> None:
        """`team` holds the names of the team's agents, which only it manages."""
        self._directory = directory
        self._system = system
        self._say = say
        self._team = team
        self._subscriptions: dict[tuple[str, str], tuple[Entry, _Question]] = {}
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
        question: _Question | None = None
        try:
            question = self._understood(to, manager, message, act)
            self._do(question)
        except _Refused as problem:
            self._refuse(to, message, question, problem)
        except DirectoryError as problem:
            self._refuse(to, message, question, _Refused("failure", problem.error, str(problem)))

    def _refuse(self, to: str, message: FipaMessage, question: _Question | None, problem: _Refused) -> None:
        assert message.sender is not None
        self._directory.tell(message.sender.name, problem.act, str(problem))
        if management_sl.is_spoken(message.language):
            sl = question.sl if question is not None else None
            text = management_sl.refusal(sl, message, problem.error, problem.about)
        else:
            text = _json({"error": problem.error, "reason": str(problem)})
        self._answer(to, message, problem.act, text)

    def _answer(self, name: str, asked: FipaMessage, act: str, text: str) -> None:
        to = asked.reply_to or (() if asked.sender is None else (asked.sender,))
        message = FipaMessage(
            fipa_name(act),
            AgentIdentifier(name),
            to,
            text,
            language=asked.language if management_sl.is_spoken(asked.language) else JSON,
            ontology=asked.ontology or ONTOLOGY,
            protocol=asked.protocol,
            conversation=asked.conversation,
            reply_with=f"{DF}-{next(self._numbers)}",
            in_reply_to=asked.reply_with,
        )
        self._say(name, message, to)

    # ---- what is asked for -------------------------------------------------------------------

    def _understood(self, to: str, manager: str, message: FipaMessage, act: str | None) -> _Question:
        """What a message asks for. Raises _Refused."""
        if message.ontology.lower() not in ("", ONTOLOGY):
            reason = f"{manager} speaks {ONTOLOGY}"
            raise _Refused("not-understood", "unsupported-value", reason, (message.ontology,))
        if act == "cancel" and manager == DF:
            return _Question(to, manager, act, message, {}, None)
        if act is None or act not in ("request", "subscribe") or (act == "subscribe" and manager != DF):
            known = "request, subscribe and cancel" if manager == DF else "request"
            reason = f"{manager} understands {known}"
            raise _Refused("not-understood", "unsupported-act", reason, (message.performative,))
        if not management_sl.is_spoken(message.language):
            return _Question(to, manager, act, message, _object(_content(message), "the content"), None)
        try:
            asked = management_sl.asked(message, manager, act)
        except management_sl.SlError as problem:
            is_argument = problem.error.endswith("argument")
            raise _Refused(
                "refuse" if is_argument else "not-understood", problem.error, str(problem)
            ) from None
        description = asked.content.get("description")
        if isinstance(description, dict) and "lease-time" in description:
            description["lease-time"] = self._lease(description["lease-time"])
        return _Question(to, manager, act, message, asked.content, asked)

    def _lease(self, value: object) -> float:
        """A lease in seconds, from a moment or a span of SL. Raises _Refused."""
        clock = self._directory.clock
        reason = "lease-time is a moment, or a span such as +00000000T000100000"
        if isinstance(value, datetime) and clock.virtual:
            reason = "in virtual time lease-time is a span, such as +00000000T000100000"
        elif isinstance(value, (datetime, Span)):
            try:
                moment = own_moment(value, clock)
            except ValueError as problem:
                reason = str(problem)
            else:
                assert moment is not None
                return (moment - clock.now()) / SECOND
        raise _Refused("refuse", *_value_of(DESCRIPTION, "lease-time", reason))

    def _do(self, question: _Question) -> None:
        """Do what is asked for, and answer. Raises _Refused or DirectoryError."""
        match question.act:
            case "cancel":
                self._cancel(question)
            case "subscribe":
                self._subscribe(question)
            case _:
                self._act(question)

    def _act(self, question: _Question) -> None:
        manager, content, sl = question.manager, question.content, question.sl
        action = content.get("action")
        if not isinstance(action, str):
            raise _Refused("refuse", "missing-argument", "the content has no action", ("action",))
        if action not in _ACTIONS[manager]:
            reason = f"{manager} knows {', '.join(_ACTIONS[manager])}"
            raise _Refused("refuse", "unsupported-function", reason, (action[:100],))
        work = self._prepared(question, action)
        if sl is not None:  # it is not refused; it may fail
            self._answer(question.to, question.message, "agree", management_sl.agreement(sl, "request"))
        found = work()
        if sl is None:
            text = _json({"action": action, "result": found})
        elif action in ("search", "get-description"):
            text = management_sl.result(sl, "request", manager, found)
        else:
            text = management_sl.done(sl, manager)
        self._answer(question.to, question.message, "inform", text)

    def _prepared(self, question: _Question, action: str) -> Callable[[], object]:
        """What does an action and gives its result. Raises _Refused."""
        content, sender = question.content, question.sender
        _only(content, ("action", "description", "max-results"), "the content", CONTENT)
        if action == "get-description":
            services = [{"name": item, "type": f"fipa.{item}"} for item in MANAGERS]
            return lambda: {"name": self._system, "ap-services": services}
        given = _object(content.get("description", {}), "the description")
        most = _most(content)
        if question.manager == AMS:
            _only(given, ("name", "state", "ownership"), "the description", management_sl.DESCRIPTIONS[AMS])
            return lambda: self._residents(given, most)
        entry, lease = _entry(given)
        if action == "search":
            return lambda: [_described(found) for found in self._directory.search(entry, most)]
        name = entry.name or sender.name
        if name != sender.name or name in self._team:
            raise _Refused("refuse", "unauthorised", f"{sender.name} may register itself alone, not {name}")
        if action == "deregister":
            return lambda: self._deregistered(name)
        agent = AgentIdentifier(name, entry.agent.addresses or sender.addresses, sender.resolvers)
        mine = Entry(agent, entry.services, entry.protocols, entry.ontologies, entry.languages)
        change = self._directory.register if action == "register" else self._directory.modify
        return lambda: [_described(change(mine, lease), lease)]

    def _deregistered(self, name: str) -> list[object]:
        self._directory.deregister(name)
        return []

    def _residents(self, given: dict[str, object], most: int | None) -> list[dict[str, str]]:
        """The white pages."""
        found = [
            {"name": item.name, "state": item.state, **({"ownership": item.role} if item.role else {})}
            for item in self._directory.residents()
        ]
        return [item for item in found if all(item.get(key) == value for key, value in given.items())][:most]

    # ---- subscriptions -----------------------------------------------------------------------

    def _subscribe(self, question: _Question) -> None:
        message, content, sl = question.message, question.content, question.sl
        _only(content, ("description",), "the content", CONTENT)
        pattern, _ = _entry(_object(content.get("description", {}), "the description"))
        if not message.conversation:
            reason = "a subscription is a conversation of its own: the message names none"
            raise _Refused("refuse", "missing-parameter", reason, ("subscribe", "conversation-id"))
        key = question.sender.name, message.conversation
        if key not in self._subscriptions and len(self._subscriptions) >= SUBSCRIBERS:
            raise _Refused("refuse", "internal-error", f"{SUBSCRIBERS} have subscribed already")
        self._subscriptions[key] = pattern, question
        found = [_described(item) for item in self._directory.search(pattern)]
        agreed = {"description": _described(pattern)}
        text = _json(agreed) if sl is None else management_sl.agreement(sl, "subscribe")
        self._answer(question.to, message, "agree", text)
        self._inform(question, {"result": found}, found)

    def _inform(self, question: _Question, content: object, found: object) -> None:
        """Tell a subscriber something: as JSON, or these descriptions in SL."""
        sl = question.sl
        text = _json(content) if sl is None else management_sl.result(sl, "subscribe", DF, found)
        self._answer(question.to, question.message, "inform", text)

    def _cancel(self, question: _Question) -> None:
        message = question.message
        if self._subscriptions.pop((question.sender.name, message.conversation), None) is None:
            raise _Refused("failure", "not-registered", "there is no such subscription")
        is_sl = management_sl.is_spoken(message.language)
        text = management_sl.done(None, question.manager) if is_sl else _json({"result": []})
        self._answer(question.to, message, "inform", text)

    def disappeared(self, name: str) -> None:
        """An agent cannot be reached any more: its subscriptions end.

        They do not end with what it has registered itself, which is another matter.
        """
        for key in [key for key in self._subscriptions if key[0] == name]:
            self._subscriptions.pop(key, None)

    def _changed(self, change: Change) -> None:
        """Tell those who have subscribed."""
        for pattern, question in list(self._subscriptions.values()):
            if change.concerns(pattern):
                described = _described(change.entry)
                told = {"what": change.what, "description": described}
                # In SL, as in JADE, who offers nothing any more is described by its name alone.
                left = {"name": described["name"]} if change.what == "gone" else described
                self._inform(question, {"changes": [told]}, [left])


# ---- contents ----------------------------------------------------------------------------------


def _content(message: FipaMessage) -> object:
    text = message.content
    if message.language.lower() not in ("", JSON):
        reason = f"contents are in {JSON} or fipa-sl0"
        raise _Refused("not-understood", "unsupported-value", reason, (message.language,))
    if not isinstance(text, str):
        raise _Refused("not-understood", "unrecognised-value", "the content is not a text in UTF-8")
    try:
        found = outside.loads(text)
        json.dumps(found, ensure_ascii=False).encode()
    except (ValueError, RecursionError) as problem:  # half a character is not a text, either
        reason = f"the content is not JSON: {problem}"
        raise _Refused("not-understood", "unrecognised-value", reason[:1000]) from None
    return found


def _object(value: object, what: str) -> dict[str, object]:
    if not isinstance(value, dict):
        raise _Refused("not-understood", "unrecognised-value", f"{what} is not a JSON object")
    return value


def _json(content: object) -> str:
    return json.dumps(content, ensure_ascii=False)


def _only(given: dict[str, object], known: Iterable[str], what: str, name: str) -> None:
    """Refuse what an object does not have; it is called so in words, and so by FIPA."""
    strangers = [item for item in given if item not in known]
    if strangers:
        reason = f"{what} has no {strangers[0][:100]}; it has {', '.join(known)}"
        raise _Refused("refuse", "unexpected-parameter", reason, (name, strangers[0][:100]))


def _value_of(name: str, parameter: str, reason: str) -> tuple[str, str, tuple[str, ...]]:
    """The error of a parameter whose value means nothing."""
    return "unrecognised-parameter-value", reason, (name, parameter[:100])


def _most(content: dict[str, object]) -> int | None:
    most = content.get("max-results")
    if most is None or (type(most) is int and most < 0):  # FIPA: a negative number is any
        return None
    if type(most) is not int:
        error = _value_of("search-constraints", "max-results", "max-results is a whole number")
        raise _Refused("refuse", *error)
    return most


def _entry(given: dict[str, object]) -> tuple[Entry, int | None]:
    """An entry from its JSON, with its lease in ns."""
    _only(given, _ENTRY, "the description", DESCRIPTION)
    services = given.get("services", [])
    if not isinstance(services, list):
        raise _Refused("refuse", *_value_of(DESCRIPTION, "services", "services is a list"))
    lease = given.get("lease-time")
    if lease is not None and (
        not isinstance(lease, (int, float)) or isinstance(lease, bool) or not 0 < lease < 1e9
    ):
        reason = "lease-time is a number of seconds"
        raise _Refused("refuse", *_value_of(DESCRIPTION, "lease-time", reason))
    agent = AgentIdentifier(_text(given, "name", DESCRIPTION), _texts(given, "addresses", DESCRIPTION))
    protocols, ontologies, languages = _lists(given, DESCRIPTION)
    found = tuple(_service(_object(item, "a service")) for item in services)
    entry = Entry(agent, found, protocols, ontologies, languages)
    return entry, None if lease is None else round(lease * SECOND)


def _service(given: dict[str, object]) -> Service:
    _only(given, _SERVICE, "a service", SERVICE)
    properties = _object(given.get("properties", {}), "properties")
    protocols, ontologies, languages = _lists(given, SERVICE)
    return Service(
        _text(given, "type", SERVICE),
        _text(given, "name", SERVICE),
        protocols,
        ontologies,
        languages,
        _text(given, "ownership", SERVICE),
        tuple((name, _text(properties, name, "property")) for name in properties),
    )


def _text(given: dict[str, object], name: str, what: str) -> str:
    value = given.get(name, "")
    if not isinstance(value, str):
        raise _Refused("refuse", *_value_of(what, name, f"{name[:100]} is a string"))
    return str(value)


def _texts(given: dict[str, object], name: str, what: str) -> tuple[str, ...]:
    value = given.get(name, [])
    if not isinstance(value, list) or not all(isinstance(item, str) for item in value):
        raise _Refused("refuse", *_value_of(what, name, f"{name} is a list of strings"))
    return tuple(map(str, value))


def _lists(given: dict[str, object], what: str) -> tuple[tuple[str, ...], ...]:
    """Protocols, by their names in documents; ontologies; languages."""
    protocols, *others = (_texts(given, name, what) for name in _LISTS)
    return tuple(map(protocol_of, protocols)), *others


def _described(entry: Entry, lease: int | None = None) -> dict[str, object]:
    """An entry as JSON; what is empty is left out."""
    found: dict[str, object] = {
        "name": entry.name,
        "addresses": list(entry.agent.addresses),
        "services": [_with_registered_names(as_json(service)) for service in entry.services],
        "protocols": [registered_name(name) for name in entry.protocols],
        "ontologies": list(entry.ontologies),
        "languages": list(entry.languages),
        "lease-time": None if lease is None else lease / SECOND,
    }
    return {name: value for name, value in found.items() if value}


def _with_registered_names(service: dict[str, object]) -> dict[str, object]:
    protocols = service.get("protocols")
    if isinstance(protocols, list):
        service["protocols"] = [registered_name(name) for name in protocols]
    return service
