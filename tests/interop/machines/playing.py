"""A machine that was imported, played by the generated class: one event at a time, as its own engine does."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from aseme_dsl.interop.emf.report import Fate, Row
from aseme_dsl.interop.machines.chart import MachinePlan
from aseme_dsl.interop.machines.places import places_of
from aseme_dsl.interop.machines.system import machines_text
from aseme_dsl.project.editing.import_machines import machines_of
from aseme_dsl.runtime.chart.chart import Chart
from aseme_dsl.runtime.chart.inputs import Happened, Input
from aseme_dsl.source import Source
from tests.support.generated import generate

MOST = 1_000
"""How many steps may follow at one instant."""


@dataclass(slots=True)
class Imported:
    """A machine with its text, and what became of its parts."""

    plan: MachinePlan
    text: str
    rows: tuple[Row, ...]
    targets: Mapping[int, str]

    @property
    def lost(self) -> tuple[str, ...]:
        """What the machine says and the text does not, each with the reason."""
        return tuple(
            f"{row.element}: {row.now}"
            for row in self.rows
            if row.fate in (Fate.HOLE, Fate.LEFT_OUT, Fate.DIFFERS)
        )


def imported(name: str, text: str) -> Imported:
    """The machine of a file. Raises ValueError with the messages if it is refused."""
    system, found = machines_of([Source(name, text)])
    if system is None:
        raise ValueError("; ".join(item.message for item in found))
    made = machines_text(system)
    return Imported(system.plans[0], made.text, made.rows, made.targets)


@dataclass
class Player:
    """The class of an imported machine, as its engine would be used."""

    machine: Imported
    now: int = 0
    chart: Chart = field(init=False)

    def __post_init__(self) -> None:
        made = generate(self.machine.text)
        self.chart = made.chart(self.machine.plan.name, "me")
        places = places_of(self.machine.plan.machine)
        self.ids: dict[str, set[str]] = {}
        for node, label in places.label.items():
            self.ids.setdefault(label, set()).add(node)
        from aseme_dsl.interop.machines.words import words_of

        self.events = words_of(self.machine.plan.machine).events
        self.last: dict[str, str] = {}
        self.run(())

    def run(self, inputs: Iterable[Input]) -> None:
        """A step, and those that follow it at once."""
        for _ in range(MOST):
            outcome = self.chart.step(self.now, inputs)
            for *_, last in outcome.taken:
                transition = self.chart.PLAN.transitions[last]
                line = int(transition.at.split(":")[1])
                self.last[transition.target] = self.machine.targets.get(line, "")
            if not outcome.again:
                return
            inputs = ()
        raise AssertionError("it does not come to rest")

    def wait(self, duration: int) -> None:
        """Let time pass, with what is due meanwhile."""
        until = self.now + duration
        while (due := self.chart.due(self.now)) is not None and due <= until:
            self.now = due
            self.run(())
        self.now = until
        self.run(())

    def send(self, event: str) -> None:
        """An event from outside."""
        if event in self.events:
            self.run([Happened(self.events[event])])
            return
        from aseme_dsl.interop.machines.machine import matches

        known = [
            self.events[name] for name in sorted(self.events, key=len, reverse=True) if matches(name, event)
        ]
        self.run([Happened(known[0] if known else "an event that nothing waits for")])

    def active(self) -> list[set[str]]:
        """The active states, innermost, by their ids: of several finals that are one END all."""
        found = []
        for label in self.chart.configuration():
            ids = self.ids.get(label, set())
            if len(ids) > 1 and label in self.last:
                ids = {self.last[label]}
            if ids:
                found.append(ids)
        return found


def is_at(active: Sequence[set[str]], expected: Iterable[str], parallels: Iterable[str]) -> bool:
    """Whether these are the basic states that are expected."""
    wanted = set(expected)
    left = [ids for ids in active if not ids & set(parallels)]
    return len(left) == len(wanted) and all(ids & wanted for ids in left)


def texts(folder: Path) -> list[Path]:
    """The machines of SCION's test framework that have a script."""
    return sorted(path for path in folder.rglob("*.scxml") if script_of(path) is not None)


def script_of(path: Path) -> Path | None:
    """The script beside a machine."""
    found = path.with_suffix(".json")
    return found if found.is_file() else None
