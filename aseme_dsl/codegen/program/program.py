"""A statechart lowered once: everything that more than one generator would have to work out."""

from __future__ import annotations

from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.amola.system import System
from aseme_dsl.codegen.program.copies import copies_of
from aseme_dsl.codegen.program.events import Events
from aseme_dsl.codegen.program.flat import FlatChart
from aseme_dsl.codegen.program.following import Following
from aseme_dsl.codegen.program.history import History
from aseme_dsl.codegen.program.registers import Registers
from aseme_dsl.codegen.program.resting import Resting, resting
from aseme_dsl.codegen.program.uses import Uses
from aseme_dsl.records import dataclass


@dataclass(frozen=True, slots=True)
class Program:
    """A statechart of a system: its regions and leaves, what these use, and what must be remembered."""

    system: System
    chart: Statechart
    flat: FlatChart
    uses: Uses
    registers: Registers
    history: History


@dataclass(frozen=True, slots=True)
class EventProgram(Program):
    """The same for a class that is given one event at a time, and rests only where it must.

    `copied` are the variables of which some regions need a copy during the step, with these regions.
    """

    rests: Resting
    events: Events
    following: Following
    copied: dict[str, tuple[int, ...]]


def lowered(system: System, chart: Statechart) -> Program:
    """A statechart as an agent runs it: it may rest in every leaf."""
    flat = FlatChart(chart)
    return Program(system, chart, flat, Uses(flat), Registers(flat, system.activities), History(flat))


def lowered_for_events(system: System, chart: Statechart, *, watched: bool) -> EventProgram:
    """The lowered form of a statechart for a program without agents.

    `watched`: the program calls a method of each activity that it cancels.
    """
    rests = resting(chart, watched=watched)
    flat = FlatChart(chart, rests.width)
    uses = Uses(flat)
    events = Events(flat, uses, rests)
    following = Following(flat, rests, events)
    copied = copies_of(flat, uses, events, following, watched=watched)
    registers = Registers(flat, system.activities)
    history = History(flat)
    return EventProgram(system, chart, flat, uses, registers, history, rests, events, following, copied)


__all__ = ["EventProgram", "Program", "lowered", "lowered_for_events"]
