"""Generates the class of a statechart for programs without agents: one number a region, no function calls.

The semantics is that of the agent's class (`codegen/step`), without blackboards of regions, effects and
traces. The generator leaves out all code that a given statechart does not need:

- Each event has a body of its own.
- A START that is always exited at once has no number.
- A step looks for a second round only where one is possible.
- A region of two states has a Boolean instead of a number, which is faster to read and write.

A region sees its own writes at once; other regions see them in the next step. A variable is stored once, on
the blackboard, if no other region can read or overwrite it later in the same step. Otherwise each region that
uses it has a copy (`v3_x` in region 3) during the step.
"""

from __future__ import annotations

from collections.abc import Iterable

from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.amola.system import System
from aseme_dsl.codegen.code.face import natural
from aseme_dsl.codegen.code.python import Gates, lines_of
from aseme_dsl.codegen.code.tree import Remember, names_in, statements
from aseme_dsl.codegen.plain.actions import Actions
from aseme_dsl.codegen.plain.conditions import Conditions
from aseme_dsl.codegen.plain.head import Head
from aseme_dsl.codegen.plain.names import Method, PlainNames
from aseme_dsl.codegen.plain.options import TAKEN, PlainCode, PlainMethod, PlainOptions, PlainSteps
from aseme_dsl.codegen.plain.places import Places
from aseme_dsl.codegen.plain.rounds import Rounds
from aseme_dsl.codegen.plain.steps import Steps
from aseme_dsl.codegen.plain.taking import Taking
from aseme_dsl.codegen.program.program import lowered_for_events


def generate_plain(
    system: System,
    chart: Statechart,
    class_name: str,
    options: PlainOptions | None = None,
    board_name: str = "",
) -> PlainCode:
    """The class of a role's statechart; it must be one of which nothing is refused (`plain_limits.py`).

    That of its blackboard is called `board_name`, or as it is with `Blackboard` behind.
    """
    options = options or PlainOptions()
    written = _Class(system, chart, class_name, options, board_name or f"{class_name}Blackboard")
    return written.code()


def plain_steps(system: System, chart: Statechart, class_name: str) -> PlainSteps:
    """What the class keeps and does, for those who print it in another form."""
    options = PlainOptions(tables=False, gates=False, translated=True)
    return _Class(system, chart, class_name, options, f"{class_name}Blackboard").steps()


class _Class:
    """A plain class, written in the order in which what it needs is found."""

    def __init__(
        self, system: System, chart: Statechart, class_name: str, options: PlainOptions, board_name: str
    ) -> None:
        program = lowered_for_events(system, chart, watched=options.watched)
        self._names = names = PlainNames(program, class_name, board_name, options)
        self._conditions = Conditions(names)
        actions = Actions(names)
        places = Places(names, actions)
        rounds = Rounds(names, self._conditions, Taking(names, self._conditions, actions, places))
        self._steps = Steps(names, actions, places, rounds)
        for region in reversed(names.flat.regions[1:]):  # innermost first, so that nothing goes deep
            places.leave_region(region.number)
        self._own = list(self._steps.methods())
        self._head = Head(names, self._conditions.gates, spends=self._steps.spends)

    def code(self) -> PlainCode:
        """The parts of the module."""
        names = self._names
        head = self._head.lines()
        methods = [*self._own, *names.methods]
        asked = [*self._head.due(), *self._head.hooks()]
        parts = [head, *_written(methods, self._conditions.gates), *_written(asked, {})]
        board = tuple(self._head.board())
        enums = sorted(names.enums)
        used = names.messages | {enum for enum, _ in enums}
        of_methods = [
            name for name in sorted(used) if names.imported(name) in names.used or name in dict(enums)
        ]
        return PlainCode(
            names.class_name,
            names.board_name,
            tuple(map(self._imported, sorted(used))),
            tuple(map(self._imported, of_methods)),
            frozenset(names.used).union(*(names_in(method.body) for method in (*methods, *asked))),
            tuple(
                (names.constants[enum, constant], f"{names.imported(enum)}.{constant}")
                for enum, constant in enums
            ),
            tuple(sorted(names.functions.items())),
            board,
            tuple(line for part in parts for line in (*part, "")),
            tuple(names.tables),
        )

    def _imported(self, name: str) -> str:
        return name if name not in TAKEN else f"{name} as {self._names.imported(name)}"

    def steps(self) -> PlainSteps:
        """The same for those who print it in another form."""
        names = self._names
        slots = sorted((*self._head.regions(), *self._head.slots()), key=lambda slot: natural(slot.name))
        methods = [*self._own, *names.methods]
        steps = [method for method in methods if method.name not in ("send", *self._steps.called)]
        bodies = [method.body for method in methods]
        return PlainSteps(
            tuple((slot.name, slot.is_truth, slot.copies) for slot in slots),
            tuple(
                sorted(
                    {item.name for body in bodies for item in statements(body) if isinstance(item, Remember)}
                )
            ),
            tuple(PlainMethod(method.name, method.gives, method.body) for method in steps),
            tuple(self._steps.events),
            tuple(
                line
                for attribute in self._head.attributes()
                if attribute.name != "MESSAGES"
                for line in attribute.lines()
            ),
        )


def _written(methods: Iterable[Method], gates: Gates) -> list[list[str]]:
    """The lines of methods."""
    return [
        [
            f"    def {method.name}({_parameters(method)}) -> {method.gives}:",
            f'        """{method.document}"""',
            *lines_of(method.body, 2, gates),
        ]
        for method in methods
    ]


def _parameters(method: Method) -> str:
    return ", ".join(("self", *(f"{name}: {kind}" for name, kind in method.parameters)))


__all__ = ["generate_plain", "plain_steps"]
