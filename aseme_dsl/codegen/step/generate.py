"""Generates the class that runs a statechart: one slotted class, one integer a region, the rest inlined.

The page on execution semantics says what the code does. Its form was measured to be as fast as code that is
written by hand with care. The methods of the class, for region 3 and transition 12:

    _region_3   one round of the region: by its active leaf, the transitions that can be taken from there
    _around_…   the transitions of a composite that may be taken while it is not complete
    _first_…    the transitions of a composite that are tried before anything inside it
    _enter_3    enter the region with its AND;  _leave_3: exit it
    _picks_12   the agent message that transition 12 consumes, if its expressions read that message
    _holds_12   the condition of transition 12, if evaluating it may raise
    _seen_12    the values that the condition of the `on` transition 12 reads
    _exit_…     the exit actions of a state;  _abandon_…: those of a participant subchart before its END
    _keep_…     remember the configuration of a composite that may be resumed
    _resume_…   resume such a composite;  _again_3: a region in it
    _proceed_…  resume a suspended participant subchart;  _proceed_3: a region in it
"""

from __future__ import annotations

from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.amola.system import System
from aseme_dsl.codegen.program.program import lowered
from aseme_dsl.codegen.step.actions import Actions
from aseme_dsl.codegen.step.boards import Boards
from aseme_dsl.codegen.step.entering import Entering
from aseme_dsl.codegen.step.events import Events
from aseme_dsl.codegen.step.frame import Frame
from aseme_dsl.codegen.step.head import Head
from aseme_dsl.codegen.step.leaving import Leaving
from aseme_dsl.codegen.step.names import StepNames
from aseme_dsl.codegen.step.resuming import Resuming
from aseme_dsl.codegen.step.rounds import Rounds
from aseme_dsl.codegen.step.taking import Taking
from aseme_dsl.records import dataclass


@dataclass(frozen=True, slots=True)
class StepCode:
    """The parts of a step module: what it imports from the messages module, and its lines."""

    class_name: str
    messages: tuple[str, ...]
    used: frozenset[str]
    """What it needs of the runtime and of Python's library."""
    constants: tuple[tuple[str, str], ...]
    """Module-level names of enum constants with the expression they stand for."""
    boards: tuple[str, ...]
    body: tuple[str, ...]
    tables: tuple[str, ...]


def generate_step(system: System, chart: Statechart, class_name: str) -> StepCode:
    """The step class of a role's statechart."""
    names = StepNames(lowered(system, chart), class_name)
    flat = names.flat
    boards = Boards(names)
    actions = Actions(names)
    events = Events(names)
    leaving = Leaving(names, actions)
    entering = Entering(names, actions)
    resuming = Resuming(names, entering)
    rounds = Rounds(names, actions, events, Taking(names, actions, events, leaving, entering))
    for region in flat.regions:
        rounds.region(region.number)
        leaving.leave(region.number)
        if region.number:
            entering.enter_region(region.number)
    for node in chart.states:
        if chart.exits_of(node.label):
            leaving.exit(node)
        if node.label in chart.abandons:
            leaving.abandon(node)
    for numbers in flat.staying.values():
        for number in numbers:
            if names.has_mark(number):
                actions.seen(number)
    for node in names.history.resumed:
        resuming.keep(node)
        resuming.resume(node)
    for branch in names.history.suspended:
        resuming.proceed(branch)
    for inner in names.history.entered_again:
        resuming.again(inner.number)
    entering.enter_root()
    Frame(names).write()
    of_boards = [line for region in flat.regions for line in boards.board(region.number)]
    head = Head(names, boards).lines()
    body = [line for method in (head, *names.methods) for line in (*method, "")]
    constants = tuple(
        (names.constants[enum, constant], f"{enum}.{constant}") for enum, constant in sorted(names.enums)
    )
    messages = names.messages | {enum for enum, _ in names.enums} | names.published
    return StepCode(
        class_name,
        tuple(sorted(messages)),
        frozenset(names.used),
        constants,
        tuple(of_boards),
        tuple(body),
        tuple(names.tables),
    )


__all__ = ["StepCode", "generate_step"]
