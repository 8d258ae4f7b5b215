"""SRM to IAC: a role's formulas as a statechart, with its protocols woven in (P1, section 4.3)."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace

from aseme_dsl.amola.aip import Plays
from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.compiler.chart.chart import Part, Protocol, World, chart_of
from aseme_dsl.compiler.chart.playing import not_used, read_plays, unused_plays, weave
from aseme_dsl.compiler.control.choices import check_formulas, undecided_formulas, unsettled
from aseme_dsl.compiler.control.control import LabelledLine, Lines, check_labels, including_labels
from aseme_dsl.compiler.formula import formulas as formula_tables
from aseme_dsl.compiler.formula.formula_to_statechart import Outline, expand_role
from aseme_dsl.compiler.formula.formulas import Formulas
from aseme_dsl.compiler.read.damage import Damaged
from aseme_dsl.compiler.read.missing import Missing
from aseme_dsl.compiler.types.scopes import TypedRole
from aseme_dsl.diagnostics import Diagnostic, Related, closest, surely
from aseme_dsl.diagnostics.problems.absences import (
    NoFormulaOfRole,
)
from aseme_dsl.diagnostics.problems.control import ControlOfProtocol
from aseme_dsl.diagnostics.problems.formulas import RoleWithoutFormula
from aseme_dsl.grammar.text import tree
from aseme_dsl.records import dataclass
from aseme_dsl.source import Span


@dataclass(frozen=True, slots=True)
class Role:
    """An `srm` that has been read. `outline` is None where its formulas cannot be expanded.

    `unused` is what it plays and no formula uses, `missing` what its formulas and its control do not say yet.
    """

    written: tree.Srm
    typed: TypedRole
    formulas: Formulas | None
    plays: tuple[Plays, ...]
    parts: Mapping[tuple[str, str], Part]
    lines: Lines
    labelled: tuple[LabelledLine, ...]
    outline: Outline | None
    unused: tuple[Plays, ...]
    missing: tuple[Missing, ...]

    @property
    def name(self) -> str:
        return self.written.name.text


def read_role(
    written: tree.Srm,
    typed: TypedRole,
    protocols: Mapping[str, Protocol],
    largest: int,
    is_damaged: Damaged,
) -> tuple[Role, tuple[Diagnostic, ...]]:
    """The formulas, control lines and plays of a role, with all that is wrong with them."""
    found: list[Diagnostic] = []
    name = written.name.text
    damaged = is_damaged(written.span)
    formulas, problems = formula_tables.table(name, written.formulas)
    found += problems
    if formulas is not None and written.includes:
        foreign = (item.name for item in formulas.named.values() if not _stands_in(item.span, written))
        formulas = replace(formulas, taken_over=frozenset(name.text for name in foreign))
    plays, parts, problems = read_plays(written, formulas, protocols, typed.scope, is_damaged)
    found += problems
    found += _foreign_controls(written, formulas, {item.name: item for item in plays}, protocols, damaged)
    if formulas is None:
        if not damaged:
            found.append(_no_formula(written))
        return Role(written, typed, None, plays, parts, Lines(), (), None, (), ()), tuple(found)
    own = [
        (control, control.name.text) for control in written.controls if control.name.text in formulas.named
    ]
    woven, problems = weave(written, formulas, plays, parts, own, typed.scope, largest, damaged)
    found += problems
    formulas, lines = woven.formulas, woven.lines
    outline, labelled = None, tuple[LabelledLine, ...]()
    if woven.expandable:
        outline = expand_role(formulas, woven.branches, written.name.span)
        labelled, problems = check_labels(outline, lines.labelled)
        found += problems
    unsure = frozenset(formulas.named if damaged else (f for c, f in own if is_damaged(c.span)))
    checked = including_labels(lines, outline, labelled) if outline is not None else lines
    found += check_formulas(formulas, {}, checked, unsure)
    wrong = unsure.union(unsettled(formulas, found), woven.named.keys() & formulas.named.keys())
    missing = undecided_formulas(formulas, {}, checked, written.span, wrong)
    unused = (
        ()
        if damaged
        else tuple(item for item in unused_plays(formulas, plays) if _stands_in(item.span, written))
    )
    missing += tuple(not_used(name, formulas, item, written.span) for item in unused)
    role = Role(written, typed, formulas, plays, parts, lines, labelled, outline, unused, missing)
    return role, tuple(found)


def srm_to_iac(role: Role, world: World) -> Statechart | None:
    """The IAC of a role; None where its formulas could not be expanded."""
    if role.outline is None:
        return None
    return chart_of(
        role.name,
        "IAC",
        role.outline,
        role.parts,
        world,
        role.written.name.span,
        role.lines,
        role.labelled,
        role.typed.variables,
    )


def _stands_in(span: Span, written: tree.Srm) -> bool:
    """Whether a place is in the role's own text, not in that of one which it includes."""
    own = written.span
    return span.source is own.source and own.start <= span.start and span.end <= own.end


# ---- playing participants ------------------------------------------------------------------------


def _foreign_controls(
    written: tree.Srm,
    formulas: Formulas | None,
    played: Mapping[str, Plays],
    protocols: Mapping[str, Protocol],
    damaged: bool,
) -> Iterable[Diagnostic]:
    """Control blocks that are about none of the role's formulas: E403, or E408 inside a protocol's branch."""
    own = formulas.named if formulas is not None else {}
    for control in written.controls:
        name = control.name.text
        if name in own:
            continue
        item = played.get(name) or next((p for p in played.values() if _helps(p, name, protocols)), None)
        if item is not None:
            related = (Related(item.span, "the role plays it here"),)
            foreign = ControlOfProtocol(item.protocol, item.participant, name)
            yield Diagnostic(foreign, control.name.span, related)
        elif not damaged:
            problem = NoFormulaOfRole(name, closest(name, own), tuple(own), written.name.text)
            yield Diagnostic(problem, control.name.span, fix=surely(name, own))


def _helps(plays: Plays, name: str, protocols: Mapping[str, Protocol]) -> bool:
    part = protocols[plays.protocol].parts.get(plays.participant)
    return part is not None and (name in part.formulas.named or name == plays.participant)


def _no_formula(written: tree.Srm) -> Diagnostic:
    return Diagnostic(RoleWithoutFormula(written.name.text), written.name.span)


__all__ = ["Role", "read_role", "srm_to_iac"]
