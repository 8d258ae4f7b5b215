"""Agent management in SL: what is asked of `df` and `ams`, and their answers, as FIPA writes them (SC00023).

Both directions go through the JSON form of `management`, which has FIPA's names, too.
"""

from __future__ import annotations

from collections.abc import Mapping

from aseme_dsl.records import dataclass
from aseme_dsl.runtime.message.acl import AgentIdentifier, FipaMessage, Span
from aseme_dsl.runtime.message.acl_text import AclTextError
from aseme_dsl.runtime.message.sl import LANGUAGES, Form, Term, Variable, dumps, loads

FUNCTIONS = ("register", "modify", "deregister", "search", "get-description")
DESCRIPTIONS = {"df": "df-agent-description", "ams": "ams-agent-description"}
_SETS = ("services", "protocols", "ontologies", "languages", "properties")
_ALONE = ("unauthorised", "already-registered", "not-registered", "unexpected-argument-count")
"""Errors without an argument."""
MOST = 1000
"""The most characters of a reason that are sent."""


class SlError(Exception):
    """A content that asks for nothing a manager understands: FIPA's word for it, and the reason."""

    def __init__(self, error: str, reason: str) -> None:
        super().__init__(reason)
        self.error = error


@dataclass(frozen=True, slots=True)
class Asked:
    """What is asked for: as JSON, and the action and the expression that the answers repeat."""

    content: dict[str, object]
    action: Term
    whole: tuple[Term, ...]


def is_spoken(language: str) -> bool:
    """Whether a content in this language is in SL."""
    return language.lower() in LANGUAGES


# ---- what is asked for ---------------------------------------------------------------------------


def asked(message: FipaMessage, manager: str, act: str) -> Asked:
    """What a message to a manager asks for.

    Raises:
        SlError: it is not a content in SL, or not one that a manager understands.
    """
    if not isinstance(message.content, str):
        raise SlError("unrecognised-value", "the content is not a text in UTF-8")
    try:
        found = loads(message.content)
    except AclTextError as problem:
        raise SlError("unrecognised-value", f"the content is not SL: {problem}"[:MOST]) from None
    if len(found) != 1:
        raise SlError("unrecognised-value", f"the content has {len(found)} expressions; one is understood")
    (whole,) = found
    action = _subscribed(whole) if act == "subscribe" else whole
    function = action.terms[1] if isinstance(action, Form) and action.name == "action" else None
    if isinstance(function, str) and not isinstance(function, Variable):  # without arguments
        function = Form(function)
    if not isinstance(function, Form):
        wanted = "(iota ?x (result (action …) ?x))" if act == "subscribe" else "(action …)"
        raise SlError("unrecognised-value", f"the content is {wanted}, in parentheses")
    content: dict[str, object] = {} if act == "subscribe" else {"action": function.name}
    if act == "subscribe" and function.name != "search":
        raise SlError("unsupported-value", f"a subscription is to a search, not to {function.name[:100]}")
    if function.name in FUNCTIONS:
        _take_arguments(content, function, manager, act)
    return Asked(content, action, found)


def _subscribed(whole: Term) -> Term:
    """The action whose result a subscription asks for."""
    match whole:
        case Form(("iota" | "any" | "all"), (Variable(), Form("result", (action, _)))):
            return action
        case Form(("iota" | "any" | "all"), (Variable(), Form("=", (_, Form("result", (action, _)))))):
            return action
        case _:
            return ""


def _take_arguments(content: dict[str, object], function: Form, manager: str, act: str) -> None:
    wanted = DESCRIPTIONS[manager]
    arguments = list(function.terms)
    if function.parameters:
        raise SlError("unrecognised-value", f"{function.name[:100]} takes its arguments without names")
    if arguments and isinstance(arguments[0], Form) and arguments[0].name in DESCRIPTIONS.values():
        given = arguments.pop(0)
        assert isinstance(given, Form)
        if given.name != wanted:
            raise SlError("unrecognised-value", f"{manager} takes a {wanted}, not a {given.name}")
        content["description"] = _object(given)
    elif function.name in ("register", "modify", "deregister"):
        raise SlError("missing-argument", wanted)
    if arguments and isinstance(arguments[0], Form) and arguments[0].name == "search-constraints":
        limits = arguments.pop(0)
        assert isinstance(limits, Form)
        # There is one directory: how many others to ask, and under which name, makes no difference.
        for name, value in limits.parameters:
            if name == "max-results" and not (act == "subscribe" and isinstance(value, int) and value < 0):
                content[name] = value
            elif name not in ("max-results", "max-depth", "search-id"):
                content[name] = _value(value)
    if arguments:
        raise SlError("unexpected-argument", _shown(arguments[0]))


def _object(form: Form) -> dict[str, object]:
    """A description as JSON."""
    if form.terms:
        raise SlError("unrecognised-value", f"a {form.name} has named parameters only")
    found: dict[str, object] = {}
    for name, value in form.parameters:
        if name == "name" and isinstance(value, Form) and value.name == "agent-identifier":
            found["name"] = value.parameter("name") or ""
            if (addresses := value.parameter("addresses")) is not None:
                found["addresses"] = _value(addresses)
        elif name == "properties":
            found[name] = dict(_property(item) for item in _items(name, value))
        elif name in _SETS:
            found[name] = [_value(item) for item in _items(name, value)]
        else:
            found[name] = _value(value)
    return found


def _items(name: str, value: Term) -> tuple[Term, ...]:
    if not isinstance(value, Form) or value.name not in ("set", "sequence"):
        raise SlError("unrecognised-value", f"{name} is a set")
    return value.terms


def _property(item: Term) -> tuple[str, str]:
    name = item.parameter("name") if isinstance(item, Form) and item.name == "property" else None
    if not isinstance(item, Form) or not isinstance(name, str):
        raise SlError("unrecognised-value", "a property is (property :name … :value …)")
    value = item.parameter("value")
    if value is None:
        return name, ""
    return name, value if isinstance(value, str) else dumps(value)[1:-1]


def _value(term: Term) -> object:
    if isinstance(term, Form):
        if term.name in ("set", "sequence"):
            return [_value(item) for item in term.terms]
        if term.name == "agent-identifier":
            return term.parameter("name") or ""
        return _object(term)
    return term


def _shown(term: Term) -> str:
    try:
        return dumps(term)[1:-1][:MOST]
    except AclTextError:
        return type(term).__name__


# ---- answers -------------------------------------------------------------------------------------


def refusal(question: Asked | None, message: FipaMessage, error: str, about: tuple[str, ...]) -> str:
    """Why something is not done: the action, and FIPA's word with what it is about."""
    if question is not None:
        action = question.action
    else:
        sender = message.sender or AgentIdentifier("")
        said = Form(message.performative if _is_word(message.performative) else "message", ())
        action = Form("action", (_agent(sender.name), said))
    reason: Term = error if error in _ALONE else Form(error, tuple(_clean(text[:MOST]) for text in about))
    return dumps(action, reason)


def agreement(question: Asked, act: str) -> str:
    """It is going to be done; of a subscription, what is subscribed to."""
    return dumps(*question.whole) if act == "subscribe" else dumps(question.action, "true")


def done(question: Asked | None, manager: str) -> str:
    """It is done; without a question, a subscription is cancelled."""
    action = Form("action", (_agent(manager), Form("cancel"))) if question is None else question.action
    return dumps(Form("done", (action,)))


def result(question: Asked, act: str, manager: str, found: object) -> str:
    """What was found, as FIPA describes it."""
    described: Term
    if isinstance(found, Mapping):
        services = tuple(
            Form("ap-service", (), (("name", _term(item["name"])), ("type", _term(item["type"]))))
            for item in _objects(found["ap-services"])
        )
        parameters = (("name", _term(found["name"])), ("ap-services", Form("set", services)))
        described = Form("ap-description", (), parameters)
    else:
        described = Form("set", tuple(_description(manager, item) for item in _objects(found)))
    if act == "subscribe":
        return dumps(Form("=", (question.whole[0], described)))
    return dumps(Form("result", (question.action, described)))


def _description(manager: str, item: Mapping[str, object]) -> Form:
    parameters: list[tuple[str, Term]] = [("name", _agent(str(item["name"]), item.get("addresses", [])))]
    for name, value in item.items():
        if name in ("name", "addresses"):
            continue
        if name == "services":
            parameters.append((name, Form("set", tuple(map(_service, _objects(value))))))
        elif name == "lease-time" and isinstance(value, (int, float)):
            parameters.append((name, Span(milliseconds=round(value * 1000))))
        elif isinstance(value, list):
            parameters.append((name, Form("set", _terms(value))))
        else:
            parameters.append((name, _term(value)))
    return Form(DESCRIPTIONS[manager], (), tuple(parameters))


def _service(item: Mapping[str, object]) -> Form:
    parameters: list[tuple[str, Term]] = []
    for name, value in item.items():
        if name == "properties" and isinstance(value, dict):
            properties = (
                Form("property", (), (("name", key), ("value", text))) for key, text in value.items()
            )
            parameters.append((name, Form("set", tuple(properties))))
        else:
            parameters.append((name, Form("set", _terms(value)) if isinstance(value, list) else _term(value)))
    return Form("service-description", (), tuple(parameters))


def _term(value: object) -> Term:
    """A value of the directory's JSON, which is one of SL, too."""
    assert isinstance(value, str | bytes | int | float | Form)
    return value


def _terms(values: object) -> tuple[Term, ...]:
    assert isinstance(values, list)
    return tuple(map(_term, values))


def _objects(values: object) -> list[Mapping[str, object]]:
    assert isinstance(values, list)
    return values


def _agent(name: str, addresses: object = None) -> Form:
    parameters: list[tuple[str, Term]] = [("name", _clean(name))]
    if addresses:
        parameters.append(("addresses", Form("sequence", _terms(addresses))))
    return Form("agent-identifier", (), tuple(parameters))


def _clean(text: str) -> str:
    """A text without what has no place in UTF-8."""
    return text.encode("utf-8", "replace").decode()


def _is_word(text: str) -> bool:
    try:
        dumps(Form(text))
    except AclTextError:
        return False
    return True


__all__ = ["Asked", "SlError", "agreement", "asked", "done", "is_spoken", "refusal", "result"]
