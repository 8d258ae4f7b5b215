"""What a plain class is to be, and what is made of it."""

from __future__ import annotations

import builtins

from aseme_dsl.codegen.code.tree import Block
from aseme_dsl.records import dataclass

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
        "OutOfBounds",
        "Unsettled",
        "annotations",
        "cache",
        "function_at",
        "leaves_of",
        "logging",
        "names_of",
        "replace",
        "Sequence",
        "unknown_event",
    ),
}
"""What other names mean in a module, also in one of machine code, which has the class `Plain` in it."""


@dataclass(frozen=True, slots=True)
class PlainOptions:
    """Options of the generated class.

    - `mapping`: the blackboard is a dictionary instead of a class with slots.
    - `watched`: each activity has a method that is called when it starts, and one that is called when it is
      cancelled; `took` is called for each transition.
    - `tables`: regions with many leaves find their code in a tuple of functions.
    - `gates`: many conditions in a row are skipped while a tracked blackboard has not changed.
    - `translated`: the steps are translated for batches. These have their own `done`, and the steps call
      nothing that may raise.
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
    """The fields and steps of the class, from which other generators print another form.

    Each of `slots` is a field: its name, whether it is a Boolean, and the variable of which it is a copy, if
    any. `events` has the code of a step for each event. `tables` are the lines that describe the leaves.
    """

    slots: tuple[tuple[str, bool, str], ...]
    written: tuple[str, ...]
    """The variables on the blackboard that regions write into copies."""
    methods: tuple[PlainMethod, ...]
    events: tuple[tuple[str, Block], ...]
    tables: tuple[str, ...]


__all__ = ["TAKEN", "PlainCode", "PlainMethod", "PlainOptions", "PlainSteps"]
