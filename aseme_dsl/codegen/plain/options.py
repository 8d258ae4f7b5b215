"""What a plain class is to be, and what is made of it."""

from __future__ import annotations

import builtins
from dataclasses import dataclass

from aseme_dsl.codegen.code.tree import Block

TAKEN = frozenset(dir(builtins)) | {
    *(
        "ABSENT",
        "NEVER",
        "ROUNDS",
        "SHOWN",
        "ActivityFailed",
        "Any",
        "Callable",
        "ClassVar",
        "Iterable",
        "Mapping",
        "Plain",
        "Random",
        "UNSTARTED",
    ),
    *(
        "NotStarted",
        "Unsettled",
        "annotations",
        "cache",
        "function_at",
        "leaves_of",
        "logging",
        "names_of",
        "Sequence",
        "unknown_event",
    ),
}
"""What other names mean in a module, also in one of machine code, which has the class `Plain` in it."""


@dataclass(frozen=True, slots=True)
class PlainOptions:
    """How the class is to be.

    `mapping`: the blackboard is a dictionary instead of a class with slots. `watched`: each activity has a
    method that is called as it starts, and one that is called when it is interrupted, and `took` is told of
    each transition. `tables`: regions with many leaves find what is to do in a tuple of functions. `gates`:
    many conditions in a row are skipped while a tracked blackboard has not changed. `translated`: the steps
    are for batches, which have a `done` of their own, and nothing is called there that may raise.
    """

    mapping: bool = False
    watched: bool = False
    tables: bool = True
    gates: bool = True
    translated: bool = False


@dataclass(frozen=True, slots=True)
class PlainCode:
    """The parts of a module: what it imports, and its lines."""

    class_name: str
    board_name: str
    messages: tuple[str, ...]
    """What it imports of these, `Any as Any_` where a name is taken."""
    messages_of_methods: tuple[str, ...]
    """Those that it needs besides the blackboard: for constants and the parameters of methods."""
    used: frozenset[str]
    """What it needs of Python's library and of the runtime."""
    constants: tuple[tuple[str, str], ...]
    """Module-level names of enum constants with the expression they stand for."""
    functions: tuple[tuple[str, tuple[str, str, str]], ...]
    """Module-level names of functions, each with the target, the name in errors and the declared result."""
    board: tuple[str, ...]
    body: tuple[str, ...]
    tables: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class PlainMethod:
    """A method of the class: its name, what it gives (`bool`, `int`, `None`), and what it does."""

    name: str
    gives: str
    body: Block


@dataclass(frozen=True, slots=True)
class PlainSteps:
    """What the class keeps and does, for those who print it in another form.

    `slots` are the names of what it keeps, each with whether that is a truth, and the variable if it is a
    copy of one; `events` what a step with each does; `tables` the lines that say of the leaves what they are.
    """

    slots: tuple[tuple[str, bool, str], ...]
    written: tuple[str, ...]
    """The variables on the blackboard that regions write into copies."""
    methods: tuple[PlainMethod, ...]
    events: tuple[tuple[str, Block], ...]
    tables: tuple[str, ...]


__all__ = ["TAKEN", "PlainCode", "PlainMethod", "PlainOptions", "PlainSteps"]
