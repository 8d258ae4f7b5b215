"""Import: models of the ASEME IDE, KSE and Monas as a project of its own, with a report."""

from __future__ import annotations

import re
import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import field, replace
from pathlib import Path

from aseme_dsl.compiler import analyse
from aseme_dsl.diagnostics import Diagnostic, Severity
from aseme_dsl.diagnostics.problems.files import ForeignNotRead
from aseme_dsl.grammar.layout import format_source
from aseme_dsl.interop.emf.comparison import differences
from aseme_dsl.interop.emf.report import Row, as_markdown
from aseme_dsl.interop.emf.requirements import Requirements
from aseme_dsl.interop.emf.roles import RolePlan
from aseme_dsl.interop.emf.system import ForeignSystem, SystemText, Threads, read_system, system_text
from aseme_dsl.interop.machines.system import machines_text
from aseme_dsl.interop.monas_agents import reported_modules
from aseme_dsl.project.editing.foreign_files import ForeignFiles, gather
from aseme_dsl.project.editing.import_machines import machines_of
from aseme_dsl.project.files.write import DISK, Disk, write_new
from aseme_dsl.records import dataclass
from aseme_dsl.source import Source

REPORT = "import-report.md"
_WORD = re.compile(r"[A-Za-z_]\w*", re.ASCII)
_COMMON = frozenset({"state", "signal", "data", "message", "topic", "enum", "function", "let", "bool", "int"})
_ROUNDS = 8
"""How often lines that the compiler refuses become holes, before their model is refused."""


@dataclass(frozen=True, slots=True)
class ImportedProject:
    """What an import gives: files by their names in the new folder, the report, and what went wrong."""

    system: str = ""
    files: dict[str, bytes] = field(default_factory=dict)
    rows: tuple[Row, ...] = ()
    diagnostics: tuple[Diagnostic, ...] = ()
    created: tuple[Path, ...] = ()
    formulas: tuple[str, ...] = ()
    """The roles that have formulas; the others are statecharts state by state."""


def import_models(paths: Sequence[Path]) -> ImportedProject:
    """The project that models stand for, not yet written. A model that cannot be read is a diagnostic."""
    given = gather(paths)
    diagnostics = given.diagnostics
    if given.machines:
        return _machines(given)
    modules: list[str] = []
    rows: list[Row] = []
    for source in given.monas:
        text, about, found = reported_modules(source)
        diagnostics += found
        rows += about
        modules += text.splitlines()
    names = tuple(path.name for path in given.protos)
    threads = Threads(tuple(modules), tuple(rows), tuple(source.path for source in given.monas))
    system, found = read_system(given.models, given.known, names, threads)
    diagnostics += found
    if system is None:
        return ImportedProject(diagnostics=tuple(diagnostics))
    diagnostics += _settled(system, given)
    if not (system.plans or system.protocols or modules) and (
        system.documents.requirements == Requirements()
    ):
        return ImportedProject(diagnostics=tuple(diagnostics))
    return _project(system, given, diagnostics)


def _machines(given: ForeignFiles) -> ImportedProject:
    """The project of state machines, which are imported without models of other kinds."""
    found = given.diagnostics
    for source in (*given.models, *given.monas):
        reason = "models and state machines become projects of their own: import them one kind at a time"
        found.append(Diagnostic(ForeignNotRead(source.path, reason), None, path=source.path))
    system, problems = machines_of(given.machines)
    found += problems
    if system is None:
        return ImportedProject(diagnostics=tuple(found))
    made = machines_text(system)
    laid_out = format_source(Source(f"{system.name.lower()}.aseme", made.text))
    title = f"Import of {', '.join(Path(name).name for name in system.files)}"
    files = {
        f"{system.name.lower()}.aseme": laid_out.text.encode(),
        REPORT: as_markdown(title, made.rows).encode(),
    }
    return ImportedProject(system.name, files, made.rows, tuple(found))


def write_project(project: ImportedProject, folder: Path, disk: Disk = DISK) -> ImportedProject:
    """Write a project where nothing of it is yet: all files, or (E009) none."""
    if not project.files:
        return project
    written = write_new({folder / name: content for name, content in project.files.items()}, disk)
    return replace(project, created=written.created, diagnostics=(*project.diagnostics, *written.diagnostics))


def _project(system: ForeignSystem, given: ForeignFiles, diagnostics: list[Diagnostic]) -> ImportedProject:
    made = system_text(system)
    laid_out = format_source(Source(f"{system.name.lower()}.aseme", made.text))
    title = f"Import of {', '.join(Path(name).name for name in system.files)}"
    files = {f"{system.name.lower()}.aseme": laid_out.text.encode()}
    if made.functions:
        files[f"{system.module}.py"] = made.functions.encode()
    files |= dict(given.copies())
    files[REPORT] = as_markdown(title, made.rows).encode()
    formulas = tuple(plan.name for plan in system.plans if plan.reconstructed is not None)
    return ImportedProject(system.name, files, made.rows, tuple(diagnostics), (), formulas)


def _settled(system: ForeignSystem, given: ForeignFiles) -> Iterator[Diagnostic]:
    """Compile the text until nothing in it is wrong: refused lines become holes, refused models go.

    Where formulas do not give the chart of the file, the chart is written state by state.
    """
    with tempfile.TemporaryDirectory(prefix="aseme-import-") as name:
        folder = Path(name).resolve()
        for file, content in given.copies():
            place = folder / file
            place.parent.mkdir(parents=True, exist_ok=True)
            place.write_bytes(content)
        for left in range(_ROUNDS * (len(system.plans) + 2), 0, -1):
            refused, changed = _round(system, folder, is_last=left == 1)
            yield from refused
            if not changed:
                return


def _round(system: ForeignSystem, folder: Path, *, is_last: bool) -> tuple[list[Diagnostic], bool]:
    """One compilation: the models that are refused, and whether anything has changed."""
    made = system_text(system, with_holes=False)
    if made.functions:
        (folder / f"{system.module}.py").write_text(made.functions, "utf-8")
    root = folder / f"{system.name.lower()}.aseme"
    root.write_text(made.text, "utf-8")
    analysis = analyse(root)
    refused: dict[int, str] = {}
    changed = False
    for item in analysis.diagnostics:
        if item.severity is Severity.ERROR:
            changed |= _judged(system, made, item, refused, is_last)
    if analysis.system is not None:
        for number, plan in enumerate(system.plans):
            chart = analysis.system.iac(plan.name)
            other = "it has no statechart" if chart is None else next(differences(chart, plan.chart), None)
            if other is not None:
                changed |= _doubted(plan, number, other, refused)
        for protocol in system.protocols:
            chart = analysis.system.eac(protocol.name)
            other = (
                "it has no statechart" if chart is None else next(differences(chart, protocol.chart), None)
            )
            if other is not None:
                system.documents.problems[f"eac.{protocol.name}"], changed = other, True
    if changed:
        system.gather()
        return [], True
    found = [
        Diagnostic(ForeignNotRead(plan.chart.place.source.path, refused[number]), plan.chart.place)
        for number, plan in enumerate(system.plans)
        if number in refused
    ]
    if -1 in refused and not refused.keys() - {-1}:
        first = system.files[0]
        found.append(Diagnostic(ForeignNotRead(first, refused[-1]), None, path=first))
    if -1 in refused:
        system.documents.requirements = Requirements()
    system.plans = [plan for number, plan in enumerate(system.plans) if number not in refused]
    system.gather()
    return found, bool(refused)


def _judged(
    system: ForeignSystem, made: SystemText, item: Diagnostic, refused: dict[int, str], is_last: bool
) -> bool:
    """What follows from an error of the compiler: a hole, no formulas or (`refused`) no model at all."""
    line = 0 if item.span is None or item.span.source.path.endswith(".proto") else item.span.line
    at = made.lines.get(line, (None, None))
    if isinstance(at, str):
        if at in system.documents.problems and at.startswith("eac."):
            at = ".".join(at.split(".")[:2])  # not what a transition says: the protocol as a whole
        system.documents.problems[at] = item.message
        return True
    role, transition = at
    if role is None:
        words = set(_WORD.findall(made.text.split("\n")[line - 1] if line else ""))
        speaking = [
            (plan, number)
            for plan in (*system.plans, *(part for item in system.protocols for part in item.parts))
            for number, move in enumerate(plan.chart.transitions)
            if number not in plan.problems and words & set(_WORD.findall(move.expression)) - _COMMON
        ]
        for plan, number in speaking:
            plan.problems[number] = item.message
        if not speaking or is_last:
            refused |= dict.fromkeys(range(-1, len(system.plans)), item.message)
        return bool(speaking) and not is_last
    plan = system.plans[role]
    if transition is None or transition in plan.problems or is_last:
        return _doubted(plan, role, item.message, refused)
    plan.problems[transition] = item.message
    return True


def _doubted(plan: RolePlan, number: int, reason: str, refused: dict[int, str]) -> bool:
    """Give up the formulas of a chart, or, if it has none, the chart."""
    if plan.reconstructed is None:
        refused.setdefault(number, reason)
        return False
    plan.reconstructed, plan.why_not = None, reason
    return True


__all__ = ["ImportedProject", "import_models", "write_project"]
