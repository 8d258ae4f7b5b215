"""What a step is made for while it is written: an event or none, and what is noted when something moves."""

from __future__ import annotations

from dataclasses import field
from typing import TypeAlias

from aseme_dsl.codegen.code.tree import (
    TRUE,
    Block,
    Const,
    Do,
    Expr,
    Name,
    Return,
    Set,
    compared,
    own_call,
    when,
)
from aseme_dsl.codegen.plain.names import Method
from aseme_dsl.codegen.program.events import OTHER, STEP
from aseme_dsl.records import dataclass

MOVED = "moved"
"""The local that says whether anything has moved."""

HAS_MOVED = Set((Name(MOVED),), TRUE)


Spending: TypeAlias = bool | Expr
"""Whether a compound transition spends the event, or the condition under which it does."""


@dataclass(frozen=True, slots=True)
class Candidate:
    """A compound transition with what must hold for it, besides that its source is active."""

    source: str
    tests: tuple[Expr, ...]
    taken: tuple[int, ...]
    spends: Spending
    stays: bool = False
    """Whether its source is not left."""
    leads_on: bool = True
    """Whether it can be taken: a choice may have no branch, but what may fail before it is to be reported."""


@dataclass(slots=True)
class Mode:
    """What a step is made for: an event, or none. It `loops` if one round may not be enough."""

    event: str
    loops: bool = False
    flags: tuple[str, ...] = (MOVED,)
    """The locals that are set when something moves."""
    direct: bool = False
    """Whether a transition that is taken ends the method."""
    inside: int = 0
    """How many locals tell whether something inside an AND has moved."""
    functions: dict[str, Method] = field(default_factory=dict)
    """Methods that the body calls, by their names."""
    tables: dict[str, list[str]] = field(default_factory=dict)
    apart: dict[int, str] = field(default_factory=dict)
    """The methods of regions that have one, by the region; "" for those with nothing to do."""

    def inner(self) -> Mode:
        """The mode for what is written into methods that the body calls."""
        return Mode(
            self.event,
            self.loops,
            direct=self.direct,
            functions=self.functions,
            tables=self.tables,
            apart=self.apart,
        )

    @property
    def word(self) -> str:
        """What its methods are called by."""
        return {STEP: "step", OTHER: "other"}.get(self.event, self.event)

    @property
    def said(self) -> str:
        """What the docstrings of its methods begin with."""
        return "any other event" if self.event == OTHER else self.word

    def moved(self, again: bool) -> Block:
        """What is noted when something was taken."""
        if self.direct:
            return (Do(own_call("step")), Return(TRUE)) if again else (Return(TRUE),)
        flags = (*self.flags, "again") if self.loops and again else self.flags
        return (Set(tuple(map(Name, flags)), TRUE),)

    def after_call(self, call: Expr, *, loops: bool) -> Block:
        """A call of what says whether something moved, and if it `loops`, whether another round is needed."""
        if self.direct:
            return (Return(call),)
        flags = Set(tuple(map(Name, self.flags)), TRUE)
        if not loops:
            return (when(call, flags),)
        found = Name("found")
        again = when(compared(found, ">", Const(1)), Set((Name("again"),), TRUE))
        return (Set((found,), call), when(found, flags, again))


__all__ = ["HAS_MOVED", "MOVED", "Candidate", "Mode", "Spending"]
