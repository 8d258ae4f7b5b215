"""Told: selects the diagnostics to report, with their places in the files, and returns the system."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from aseme_dsl.amola.system import System
from aseme_dsl.compiler.checks.activity_use import all_activities
from aseme_dsl.compiler.checks.conditions import FROM_CONDITIONS
from aseme_dsl.compiler.checks.consequences import without_consequences
from aseme_dsl.compiler.formula.holes import apart_from_holes
from aseme_dsl.compiler.read.allow import allow
from aseme_dsl.compiler.read.load import Loaded
from aseme_dsl.compiler.read.memory import Memory
from aseme_dsl.compiler.read.missing import Missing
from aseme_dsl.compiler.read.names import as_written, of_homonyms, together
from aseme_dsl.compiler.stages.analysis import Analysis
from aseme_dsl.compiler.stages.charts import Charts
from aseme_dsl.compiler.stages.declarations import Declarations
from aseme_dsl.compiler.stages.pasted import pasted
from aseme_dsl.compiler.stages.processes import Described, Processes, Requirements
from aseme_dsl.compiler.stages.uses import Fulfilment, Uses
from aseme_dsl.diagnostics import Diagnostic, Edit, Policy, has_errors
from aseme_dsl.diagnostics.problems.files import NoSystem
from aseme_dsl.grammar.parsing.parts import Layout
from aseme_dsl.grammar.text import tree

_OF_CODE = frozenset(("N726", "W542", "W556"))
"""What is found only where the activities' code is at hand (project/code/activity_code.py)."""

_IMPORTABLE = (
    tree.Import,
    tree.Enum,
    tree.Message,
    tree.Topic,
    tree.Function,
    tree.Let,
    tree.Aip,
)
"""What a file may declare for others to import."""


def tell(
    declared: Declarations,
    missing: Sequence[Missing],
    found: Sequence[Diagnostic],
    unchecked: int,
    policy: Policy,
) -> Analysis:
    """Each cause once, without what comments allow, judged by the project's policy; without a system."""
    loaded = declared.loaded
    layout = loaded.layout
    placed = {id(item): layout.diagnostic(item) for item in declared.inclusion.once(found)}
    kept = pasted(without_consequences(placed.values()), loaded.files, declared.top)
    not_looked_for = _OF_CODE | FROM_CONDITIONS if unchecked else _OF_CODE
    diagnostics, suppressed = allow(loaded.files, kept, not_looked_for, layout)
    spellings = together(loaded.spellings, of_homonyms(declared.blocks.srms))
    if spellings:
        diagnostics = as_written(diagnostics, spellings)
    accepted = {id(item.diagnostic) for item in suppressed}
    still_missing = (_placed(item, placed.get(id(item.note), item.note), layout) for item in missing)
    return Analysis(
        None,
        policy.apply(diagnostics),
        tuple(item for item in still_missing if id(item.note) not in accepted),
        _is_library(loaded),
        suppressed,
        unchecked,
        tuple(loaded.paths.values()),
    )


def system_of(
    declared: Declarations,
    required: Requirements,
    processes: Processes,
    described: Described,
    charts: Charts,
    uses: Uses,
    fulfilment: Fulfilment,
    memory: Memory,
) -> System:
    """The models of all phases together; only where there is no error."""
    symbols = declared.symbols
    assert symbols.system is not None
    performed = {item.name: item for item in all_activities(uses.by_roles, described.activities)}
    return System(
        name=declared.system,
        enums=symbols.enums,
        messages=symbols.messages,
        topics=symbols.topics,
        functions=symbols.functions,
        activities=tuple(memory.same_values("activities", performed).values()),
        sag=required.sag,
        suc=required.suc,
        aips=processes.aips,
        srms=fulfilment.srms,
        eacs=charts.of_protocols,
        iacs=charts.of_roles,
        teams=processes.teams,
        protos=symbols.protos,
        sources=tuple(file.source for file in declared.loaded.files),
        span=symbols.system.name.span,
    )


def no_system(loaded: Loaded) -> Iterable[Diagnostic]:
    """E008, unless the declaration may be among what could not be read."""
    if loaded.files and not has_errors(apart_from_holes(loaded.diagnostics)):
        source = loaded.files[-1].source
        yield Diagnostic(NoSystem(source.path), None, path=source.path)


def _placed(item: Missing, note: Diagnostic, layout: Layout) -> Missing:
    return Missing(
        note,
        item.skeleton,
        None if item.inside is None else layout.whole(item.inside),
        tuple(Edit(layout.whole(edit.span), edit.text) for edit in item.edits),
    )


def _is_library(loaded: Loaded) -> bool:
    declarations = [item for file in loaded.files for item in file.declarations]
    return bool(declarations) and all(isinstance(item, _IMPORTABLE) for item in declarations)


__all__ = ["no_system", "system_of", "tell"]
