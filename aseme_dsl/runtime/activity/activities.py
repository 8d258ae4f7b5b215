"""Activities: ordinary Python classes, found by name, one module each (`kick_ball.py`, class `KickBall`)."""

from __future__ import annotations

import importlib
import inspect
from collections.abc import Callable
from typing import ClassVar, Protocol

from aseme_dsl.runtime.activity.context import Context
from aseme_dsl.runtime.message.naming import class_name, module_name

KINDS = ("thread", "async", "process", "step")
"""How an activity runs: in a resident thread, on the event loop, in a resident process, inside the step."""

ActivityFinder = Callable[[str], "type[Executable] | None"]
"""Gives the class of an activity, or None where there is no code for it."""


class Executable(Protocol):
    """What has the code of an activity or module. Its parameters are those of its declaration."""

    @property
    def execute(self) -> Callable[..., object]: ...


class ActivityError(Exception):
    """An activity's code cannot be loaded, or is not what it should be."""


class Activity:
    """The base of activity classes; one object is made for each start.

    A subclass overrides `execute`. A plain function runs in a resident thread (or, with `kind = "process"`, a
    resident process); an `async def` on the event loop; a generator is advanced inside the agent's steps. It
    must not block, and yields its pauses in seconds (or nothing, for 10 ms). A class whose `execute` is not
    overridden, or still nothing but a docstring, counts as an activity without code.
    """

    kind: ClassVar[str | None] = None
    """One of `KINDS`; None: what the document says, or what `execute` shows."""
    stands_in: ClassVar[bool] = False
    """Whether it only plays an activity: it prepares what an activity without code does."""

    def execute(self, context: Context) -> object:
        """Do what the activity is for. What it raises makes its state fail."""
        raise NotImplementedError


def from_package(package: str, has: Callable[[str], bool]) -> ActivityFinder:
    """Activities that are modules of an importable package; `has` says whether it has a file of that name.

    The finder raises ActivityError for a module that cannot be imported or lacks its class.
    """
    found: dict[str, type[Executable] | None] = {}

    def find(activity: str) -> type[Executable] | None:
        if activity not in found:
            found[activity] = _load(package, has, activity)
        return found[activity]

    return find


def _load(package: str, has: Callable[[str], bool], activity: str) -> type[Executable] | None:
    module = module_name(activity)
    file = f"{module}.py"
    if not has(file):
        return None
    try:
        loaded = importlib.import_module(f"{package}.{module}")
    except (Exception, SystemExit) as error:
        raise ActivityError(f"{file} cannot be imported: {type(error).__name__}: {error}") from error
    kind = getattr(loaded, class_name(activity), None)
    if not isinstance(kind, type):
        raise ActivityError(f"{file} has no class {class_name(activity)}")
    return kind


def _empty(self: object, context: object) -> None:
    pass


def _described(self: object, context: object) -> None:
    """An execute that says what it would do, but does not."""


_NOTHING = {_empty.__code__.co_code, _described.__code__.co_code}


def has_code(kind: type[Executable] | None) -> bool:
    """Whether a class says what its activity does: an `execute` that is missing or unwritten does not."""
    execute = getattr(kind, "execute", None)
    if execute is None or execute is Activity.execute:
        return False
    code = getattr(execute, "__code__", None)
    if code is None or code.co_code not in _NOTHING:
        return True
    # One that returns a constant has the same code.
    if any(constant is not None and constant != execute.__doc__ for constant in code.co_consts):
        return True
    return not _is_unwritten(execute)


def _is_unwritten(execute: Callable[..., object]) -> bool:
    """Whether there is only a docstring, as a build starts it, or `...`; `pass` is a decision of the
    author."""
    import ast

    try:
        source = inspect.getsource(execute)
        tree = ast.parse(f"if True:\n{source}" if source[:1].isspace() else source)
    except (OSError, TypeError, SyntaxError):  # nothing to be seen: nothing is done
        return True
    written = next((node for node in ast.walk(tree) if isinstance(node, ast.FunctionDef)), None)
    return written is not None and all(isinstance(part, ast.Expr) for part in written.body)


def kind_of(kind: type[Executable], declared: str) -> str:
    """How the activity of a class runs; `declared` is what the document says.

    Raises:
        ActivityError: the class's `kind` is none, or does not fit its `execute` or the document.
    """
    execute = kind.execute
    shape = (
        "async"
        if inspect.iscoroutinefunction(execute)
        else "step"
        if inspect.isgeneratorfunction(execute)
        else None
    )
    said: str | None = getattr(kind, "kind", None)
    chosen: str = said or shape or declared
    if declared not in ("thread", chosen) and chosen in KINDS:  # "thread" is also what is not said
        raise ActivityError(
            f"{kind.__name__} runs as {chosen!r} by its class, and as {declared!r} by the document"
        )
    if chosen not in KINDS:
        raise ActivityError(f"{kind.__name__}.kind is {chosen!r}; it can be {', '.join(KINDS)}")
    if shape is not None and chosen != shape:
        needed = "an async def" if shape == "async" else "a generator"
        raise ActivityError(f"{kind.__name__}.execute is {needed}, which does not run as {chosen!r}")
    if shape is None and chosen == "async":
        raise ActivityError(f"{kind.__name__} runs as 'async', but its execute is not an async def")
    return chosen
