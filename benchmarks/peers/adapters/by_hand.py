"""The behaviours as they are written by hand; and the same with a class with slots as the blackboard."""

from __future__ import annotations

import importlib
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any, Literal

from benchmarks.behaviours.description import Behaviour
from benchmarks.peers.driving import Running, blackboard, with_attributes, with_dictionary

Form = Literal["dict", "slots"]
FORMS: tuple[Form, ...] = ("dict", "slots")

MODULES = {"deep_leaf": "deep", "deep_top": "deep"}
"""The module of a behaviour, where it is called otherwise."""


def machine_of(behaviour: Behaviour, form: Form) -> type[Any]:
    """The class that was written for a behaviour.

    Raises:
        NotImplementedError: nobody writes that by hand.
    """
    if behaviour.name.startswith("ring_"):
        raise NotImplementedError("nobody writes a thousand states by hand")
    name = MODULES.get(behaviour.name, behaviour.name)
    module = importlib.import_module(f"benchmarks.behaviours.by_hand.{name}")
    if form == "dict":
        found: type[Any] = module.Machine
        return found
    assert module.__file__ is not None
    # Nobody has to write it twice: `bb["n"]` is `bb.n` there, and `bb[f"…"]` is asked for by name.
    text = Path(module.__file__).read_text("utf-8")
    text = re.sub(r'\bbb\["(\w+)"\]', r"bb.\1", text)
    text = re.sub(r'\bbb\[(f"[^"]+")\] \+= 1', r"setattr(bb, \1, getattr(bb, \1) + 1)", text)
    namespace: dict[str, Any] = {"__name__": f"{module.__name__}_slots"}
    exec(compile(text, module.__file__, "exec"), namespace)
    found = namespace["Machine"]
    return found


def board_of(behaviour: Behaviour) -> type[Any]:
    """A class with a slot for each flag and counter."""
    values = blackboard(behaviour)

    def start(self: Any) -> None:
        for name, value in values.items():
            setattr(self, name, value)

    return type("Blackboard", (), {"__slots__": tuple(values), "__init__": start})


def running(behaviour: Behaviour, form: Form = "dict") -> Running:
    """A machine that has been started."""
    bb = blackboard(behaviour) if form == "dict" else board_of(behaviour)()
    machine = machine_of(behaviour, form)(bb)
    machine.start()
    send = machine.done if behaviour.ends else machine.send
    running = (with_dictionary if form == "dict" else with_attributes)(send, bb, machine.leaves)
    running.told = dict(behaviour.ends)
    return running


def instances(
    behaviour: Behaviour, number: int, form: Form = "dict"
) -> tuple[list[Any], Callable[[Any], object]]:
    """Blackboards, and what makes a machine with one."""
    machine = machine_of(behaviour, form)
    board: Callable[[], Any] = board_of(behaviour) if form == "slots" else lambda: blackboard(behaviour)

    def make(bb: Any) -> object:
        made = machine(bb)
        made.start()
        return made

    return [board() for _ in range(number)], make
