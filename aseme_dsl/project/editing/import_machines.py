"""Import of machines: SCXML and XState as a project of its own, with a report."""

from __future__ import annotations

import tempfile
from collections.abc import Iterator, Sequence
from pathlib import Path

from aseme_dsl.compiler import analyse
from aseme_dsl.diagnostics import Diagnostic, Severity
from aseme_dsl.diagnostics.problems.files import ForeignNotRead
from aseme_dsl.interop.machines.system import MachineSystem, machines_text, read_machines
from aseme_dsl.source import Source

_ROUNDS = 8
"""How often parts that the compiler refuses become holes, before their machine is refused."""


def machines_of(sources: Sequence[Source]) -> tuple[MachineSystem | None, tuple[Diagnostic, ...]]:
    """The machines of files, as far as their text is correct."""
    system, found = read_machines(sources)
    if system is None:
        return None, found
    refused = tuple(_settled(system))
    return (system if system.plans else None), (*found, *refused)


def _settled(system: MachineSystem) -> Iterator[Diagnostic]:
    """Compile the text until nothing in it is wrong: a refused transition becomes a hole, then it is left
    out; a machine that is refused as a whole goes."""
    with tempfile.TemporaryDirectory(prefix="aseme-import-") as name:
        root = Path(name).resolve() / "machines.aseme"
        for left in range(_ROUNDS, -1, -1):
            made = machines_text(system, with_holes=False)
            root.write_text(made.text, "utf-8")
            errors = [item for item in analyse(root).diagnostics if item.severity is Severity.ERROR]
            if not errors:
                return
            refused: dict[int, str] = {}
            for item in errors:
                at = made.lines.get(item.span.line if item.span is not None else 0)
                if at is None:
                    refused |= dict.fromkeys(range(len(system.plans)), item.message)
                    continue
                number, part = at
                problems = system.plans[number].problems
                before = "!" if part is None or not left else problems.get(part)
                if part is None or (before is not None and before.startswith("!")):
                    refused[number] = item.message
                else:
                    problems[part] = item.message if before is None else f"!{item.message}"
            for number, reason in refused.items():
                place = system.plans[number].machine.root.place
                yield Diagnostic(ForeignNotRead(place.source.path, reason), place)
            system.plans = [plan for number, plan in enumerate(system.plans) if number not in refused]
            if not system.plans:
                return


__all__ = ["machines_of"]
