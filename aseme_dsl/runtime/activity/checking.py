"""Checking: what an activity does is checked when it asks for it, so that the error has its line of code."""

from __future__ import annotations

from dataclasses import is_dataclass

from aseme_dsl.runtime.activity import access
from aseme_dsl.runtime.activity import context as c
from aseme_dsl.runtime.activity.execution import Execution, Host
from aseme_dsl.runtime.chart.bounds import check_variable
from aseme_dsl.runtime.chart.functions import TYPES
from aseme_dsl.runtime.conversation.directory import Offer, Withdraw
from aseme_dsl.runtime.message.convert import same_shape


def check_doing(agent: Host, execution: Execution, doing: c.Doing) -> None:
    """Refuse at once an effect of an activity that is not declared or makes no sense.

    Raises:
        UndeclaredError: the activity does not declare that it writes the channel or variable.
        LookupError: there is no such channel, variable or participant.
        TypeError: a message or value is of another type.
        OutOfBounds: a bounded variable cannot hold the number.
    """
    match doing:
        case c.Publish(channel, message):
            c.check_message(channel, message)
            _check_kind(agent, channel, message)
            access.check_publish(execution.info, channel)
        case c.SetVariable(name, value):
            variable = agent.plan.variable_of(name, execution.label)
            if not fits(variable.type, value):
                raise TypeError(f"variable {name} is a {variable.type}, not {value!r}")
            access.check_set(execution.info, variable, name)
            check_variable(variable, value)
        case c.Prepare(message):
            if isinstance(message, type) or not is_dataclass(message):
                raise TypeError(f"what is prepared is a message, not {message!r}")
        case c.Send(performative, message, to):
            agent.requests.check_send(execution, performative, type(message).__name__, to)
        case Offer(anew=anew):
            agent.requests.check_registered(anew)
        case Withdraw():
            agent.requests.check_registered(True)


def _check_kind(agent: Host, channel: str, message: object) -> None:
    """Refuse a class that has only the name of a message; one of another version may be another class."""
    found = type(message)
    kind = agent.kinds.get(found.__name__)
    if found is kind or kind is None:
        return
    if not is_dataclass(found) or not (agent.messages or same_shape(found, kind)):
        text = f"{channel} carries {agent.plan.system}'s {found.__name__}, not the one of {found.__module__}"
        raise TypeError(text)


_TYPES = {**TYPES, "agent": (str, type(None))}


def fits(kind: str, value: object) -> bool:
    """Whether a value is of the type of a variable."""
    if kind.startswith("list of "):
        element = kind.removeprefix("list of ")
        return isinstance(value, list | tuple) and all(fits(element, item) for item in value)
    expected = _TYPES.get(kind)
    if expected is None:
        return type(value).__name__ == kind
    return isinstance(value, expected) and (bool in expected or not isinstance(value, bool))


__all__ = ["check_doing", "fits"]
