"""Guards and actions of a behaviour as Python functions, with nothing in them but what they say."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from types import SimpleNamespace
from typing import Any

from benchmarks.behaviours.description import Action, Guard

Blackboard = dict[str, Any]
Send = Callable[[str], object]
"""What sends a machine an event."""


def condition(guard: Guard, blackboard: str = "bb") -> str:
    """A guard as an expression over a blackboard that is a dictionary."""
    return " and ".join(
        f"({wanted})" if not flag else f"{'' if wanted else 'not '}{blackboard}[{flag!r}]"
        for flag, wanted in guard
    )


def statements(actions: Iterable[Action], blackboard: str = "bb") -> list[str]:
    """Actions as statements."""
    found = []
    for action in actions:
        match action:
            case ("count", counter):
                found.append(f"{blackboard}[{counter!r}] += 1")
            case ("set", flag, value):
                found.append(f"{blackboard}[{flag!r}] = {value}")
            case ("python", text):
                found.append(text)
    return found


def function(parameters: str, lines: list[str], bb: Blackboard) -> Callable[..., Any]:
    """A function with these statements, that knows the blackboard as `bb`."""
    body = "".join(f"        {line}\n" for line in lines or ["pass"])
    code = f"def outer(bb):\n    def inner({parameters}):\n{body}    return inner\n"
    namespace: dict[str, Any] = {"Message": SimpleNamespace}
    exec(code, namespace)
    made: Callable[..., Any] = namespace["outer"](bb)
    return made


def guard_function(parameters: str, guard: Guard, bb: Blackboard) -> Callable[..., bool]:
    """A function that says whether a guard holds."""
    return function(parameters, [f"return {condition(guard)}"], bb)
