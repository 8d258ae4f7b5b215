"""System: the machines of several files as one `.aseme` file."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import PurePath

from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.diagnostics.problems.files import ForeignNotRead
from aseme_dsl.interop.emf.identifiers import Names, system_name
from aseme_dsl.interop.emf.markup import Unreadable
from aseme_dsl.interop.emf.report import Row
from aseme_dsl.interop.machines.chart import MachinePlan, machine_text
from aseme_dsl.interop.machines.machine import LARGEST, beyond
from aseme_dsl.interop.machines.scxml import read_scxml
from aseme_dsl.interop.machines.xstate import read_xstate
from aseme_dsl.records import dataclass
from aseme_dsl.source import Source

MACHINES = (".scxml", ".json")
"""The endings of files with a machine."""


@dataclass(slots=True)
class MachineSystem:
    """All machines of an import."""

    name: str
    files: tuple[str, ...]
    plans: list[MachinePlan]


@dataclass(frozen=True, slots=True)
class MachinesText:
    """The text, before its layout. A line has the number of its machine, and that of the part that it is
    for, if it is for one."""

    text: str
    lines: Mapping[int, tuple[int, int | None]]
    rows: tuple[Row, ...]
    targets: Mapping[int, str]
    """The ids of the states to which lines lead."""


def read_machines(sources: Sequence[Source]) -> tuple[MachineSystem | None, tuple[Diagnostic, ...]]:
    """The machines of files, and a diagnostic for each that is not read."""
    found: list[Diagnostic] = []
    plans: list[MachinePlan] = []
    names = Names()
    for source in sources:
        try:
            is_json = source.path.lower().endswith(".json")
            machine = read_xstate(source) if is_json else read_scxml(source)
            too_large = beyond(machine)
            if too_large is not None:
                said = f"it has more than {LARGEST} states, transitions, actions and variables"
                raise Unreadable(said, too_large)
        except Unreadable as problem:
            found.append(Diagnostic(ForeignNotRead(source.path, str(problem)), problem.place))
            continue
        title = machine.name or PurePath(source.path).stem
        plans.append(MachinePlan(machine, names.new(title, "machine")))
    if not plans:
        return None, tuple(found)
    return MachineSystem(system_name(plans[0].name), tuple(source.path for source in sources), plans), tuple(
        found
    )


def machines_text(system: MachineSystem, *, with_holes: bool = True) -> MachinesText:
    """The text of all machines."""
    lines = [f"system {system.name}"]
    places: dict[int, tuple[int, int | None]] = {}
    rows: list[Row] = []
    targets: dict[int, str] = {}
    for number, plan in enumerate(system.plans):
        made = machine_text(plan, with_holes=with_holes)
        lines.append("")
        places |= {len(lines) + i + 1: (number, made.parts.get(i)) for i in range(len(made.lines))}
        targets |= {len(lines) + i + 1: node for i, node in made.targets.items()}
        lines += made.lines
        rows += made.rows
    return MachinesText("\n".join([*lines, ""]), places, tuple(rows), targets)


__all__ = ["MACHINES", "MachineSystem", "MachinesText", "machines_text", "read_machines"]
