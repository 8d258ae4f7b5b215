"""Guards and actions of a behaviour as Python functions, with nothing in them but what they say."""

from __future__ import annotations

import importlib
import sys
from collections.abc import Callable, Iterable
from functools import cache
from types import SimpleNamespace
from typing import Any

from benchmarks.behaviours.description import Action, Behaviour, Guard

Blackboard = dict[str, Any]
Send = Callable[[str], object]
"""What sends a machine an event."""


FUNCTIONS: dict[str, Callable[..., Any]] = {}
"""What the conditions of the present behaviour call."""


def know_functions(behaviour: Behaviour) -> None:
    """Import what the conditions of a behaviour call.

    Raises:
        ImportError, AttributeError: there is no such function.
    """
    FUNCTIONS.clear()
    sys.path += [folder for folder in behaviour.path if folder not in sys.path]
    for name, target in behaviour.functions:
        module, _, function_name = target.partition(":")
        FUNCTIONS[name] = getattr(importlib.import_module(module), function_name)


def condition(guard: Guard, blackboard: str = "bb") -> str:
    """A guard as an expression over a blackboard that is a dictionary."""
    return " and ".join(_asked(flag, wanted, blackboard) for flag, wanted in guard)


def _asked(flag: str, wanted: bool | str, blackboard: str) -> str:
    """A part of a guard."""
    if not flag:
        return f"({wanted})"
    message, dot, member = flag.partition(".")
    should = "" if wanted else "not "
    if not dot:
        return f"{should}{blackboard}[{flag!r}]"
    there = f"{blackboard}[{message!r}]"
    return f"{there} is not None and {should}{there}.{member}"


def statements(actions: Iterable[Action], blackboard: str = "bb") -> list[str]:
    """Actions as statements; adding is written out, which is the faster way on a dictionary."""
    found = []
    for action in actions:
        match action:
            case ("count", counter):
                found.append(f"{blackboard}[{counter!r}] = {blackboard}[{counter!r}] + 1")
            case ("set", flag, value):
                found.append(f"{blackboard}[{flag!r}] = {value}")
            case ("python", text):
                found.append(text)
    return found


def made(message: str, member: str, value: object) -> object:
    """A message as a person writes its class: with a slot for its member."""
    found = _class_of(message, member)()
    setattr(found, member, value)
    return found


@cache
def _class_of(message: str, member: str) -> type[Any]:
    return type(message.capitalize(), (), {"__slots__": (member,)})


def function(parameters: str, lines: list[str], bb: Blackboard, **known: object) -> Callable[..., Any]:
    """A function with these statements, that knows the blackboard as `bb`, and whatever else is `known`."""
    body = "".join(f"        {line}\n" for line in lines or ["pass"])
    code = f"def outer(bb):\n    def inner({parameters}):\n{body}    return inner\n"
    namespace: dict[str, Any] = {"Message": SimpleNamespace, **FUNCTIONS, **known}
    exec(code, namespace)
    made: Callable[..., Any] = namespace["outer"](bb)
    return made


def guard_function(parameters: str, guard: Guard, bb: Blackboard) -> Callable[..., bool]:
    """A function that says whether a guard holds."""
    return function(parameters, [f"return {condition(guard)}"], bb)
