"""SRM to IAC: a role's formulas as a statechart, with its protocols woven in (P1, section 4.3)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence, Set
from dataclasses import dataclass, replace

from aseme_dsl.amola.expression import Outcome, values_of
from aseme_dsl.amola.liveness import called, names
from aseme_dsl.amola.srm import Plays
from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.compiler.chart.aip_to_eac import Protocol
from aseme_dsl.compiler.chart.chart import Part, World, chart_of
from aseme_dsl.compiler.control.choices import check_formulas, undecided_formulas, unsettled
from aseme_dsl.compiler.control.control import LabelledLine, Lines, check_labels, including_labels, read_lines
from aseme_dsl.compiler.control.stopping import stops_of
from aseme_dsl.compiler.formula import formulas as formula_tables
from aseme_dsl.compiler.formula.formula_to_statechart import Branch, Outline, expand_role, too_large
from aseme_dsl.compiler.formula.formulas import Formulas
from aseme_dsl.compiler.names.scope import Scope
from aseme_dsl.compiler.names.symbols import Symbols
from aseme_dsl.compiler.read.damage import Damaged
from aseme_dsl.compiler.read.missing import Missing
from aseme_dsl.compiler.read.names import unknown
from aseme_dsl.compiler.types.given import Supplied, give, supplied_names, supply
from aseme_dsl.compiler.types.scopes import TypedRole
from aseme_dsl.diagnostics import Diagnostic, Related, closest, surely
from aseme_dsl.diagnostics.problems.absences import (
    NoActivityToBind,
    NoFormulaOfRole,
    NoParticipant,
    NoProtocol,
)
from aseme_dsl.diagnostics.problems.activities import BoundToOtherParameters
from aseme_dsl.diagnostics.problems.control import ControlOfProtocol
from aseme_dsl.diagnostics.problems.formulas import FormulaNotUsed, ProcessRestated, RoleWithoutFormula
from aseme_dsl.diagnostics.problems.missing import ParticipantNotUsed
from aseme_dsl.diagnostics.problems.names import (
    BoundToExpression,
    BoundToParticipant,
    BoundTwice,
    EmptyFormulaInLoop,
    OutcomeOfFormula,
    ParticipantNameTaken,
)
from aseme_dsl.grammar.text import tree
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
    plays, parts, problems = _plays(written, formulas, protocols, typed.scope, is_damaged)
    found += problems
    played = {item.name: item for item in plays}
    found += _foreign_controls(written, formulas, played, protocols, damaged)
    if formulas is None:
        if not damaged:
            found.append(_no_formula(written))
        return Role(written, typed, None, plays, parts, Lines(), (), None, (), ()), tuple(found)
    through = {
        item.name: tuple(own for _, own in item.bindings if own in formulas.named)
        for item in (*plays, *_by_own_name(plays, played, formulas).values())
    }
    through |= {name: through[item.name] for name, item in _by_own_name(plays, played, formulas).items()}
    formulas, problems = give(replace(formulas, through=through), typed.scope, played)
    found += problems
    found += _other_parameters(written, plays, formulas, typed.scope.symbols)
    branches = {
        item.name: parts[item.protocol, item.participant].branch(item)
        for item in plays
        if (item.protocol, item.participant) in parts
    }
    played |= _by_own_name(plays, played, formulas)
    branches = {name: branches[item.name] for name, item in played.items() if item.name in branches}
    is_empty, empty_bound = _emptiness(branches, parts)
    own = [
        (control, control.name.text) for control in written.controls if control.name.text in formulas.named
    ]
    inside = {owner: part.formulas for owner, part in parts.items()}
    lines, problems = read_lines(formulas, own, typed.scope, inside, played)
    found += problems
    expandable, problems = formula_tables.check(formulas, is_empty, frozenset(played), stops_of(lines.by_way))
    found += [item for item in problems if not (damaged and isinstance(item.problem, FormulaNotUsed))]
    outline, labelled = None, tuple[LabelledLine, ...]()
    # A played participant whose process could not be read would stand as an activity: no chart then.
    if expandable and len(plays) == len(written.plays) and len(branches) == len(played):
        found += _unfit_formulas(written, plays, branches, parts, empty_bound)
        problem = too_large(formulas, branches, largest, written.name.span)
        if problem is not None:
            found.append(problem)
        else:
            outline = expand_role(formulas, branches, written.name.span)
            labelled, problems = check_labels(outline, lines.labelled)
            found += problems
    unsure = frozenset(formulas.named if damaged else (f for c, f in own if is_damaged(c.span)))
    checked = including_labels(lines, outline, labelled) if outline is not None else lines
    found += check_formulas(formulas, {}, checked, unsure)
    wrong = unsure.union(unsettled(formulas, found), played.keys() & formulas.named.keys())
    missing = undecided_formulas(formulas, {}, checked, written.span, wrong)
    unused = (
        () if damaged else tuple(item for item in _unused(formulas, plays) if _stands_in(item.span, written))
    )
    missing += tuple(_not_used(written, formulas, item) for item in unused)
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


def _plays(
    written: tree.Srm,
    formulas: Formulas | None,
    protocols: Mapping[str, Protocol],
    scope: Scope,
    is_damaged: Damaged,
) -> tuple[tuple[Plays, ...], dict[tuple[str, str], Part], tuple[Diagnostic, ...]]:
    """What the role plays, by the names that its formulas use: E205, E206, E213, E306."""
    found: list[Diagnostic] = []
    plays: dict[str, Plays] = {}
    parts: dict[tuple[str, str], Part] = {}
    for item in written.plays:
        protocol = protocols.get(item.protocol.text)
        if protocol is None:
            if not scope.symbols.is_excused(item.protocol.text):
                found.append(unknown(NoProtocol, item.protocol, protocols))
            continue
        participants = {p.name.text: p for p in protocol.written.participants}
        if item.participant.text not in participants:
            if not is_damaged(protocol.written.span):
                named = item.protocol.text
                found.append(unknown(NoParticipant, item.participant, participants, named))
            continue
        name = item.alias or item.participant
        earlier = plays.get(name.text)
        if earlier is not None:
            found.append(_same_name(name, earlier))
            continue
        part = protocol.parts.get(item.participant.text)
        bindings: dict[str, str] = {}
        supplied = Supplied()
        if part is not None:
            parts[protocol.name, part.participant] = part
            party = participants[item.participant.text]
            bindings, problems = _bindings(item, part, party, _played_names(written))
            found += problems
            supplied, problems = supply(item, part.inputs, part.results, part.variables, scope)
            found += problems
        plays[name.text] = Plays(
            item.protocol.text,
            item.participant.text,
            name.text,
            tuple(bindings.items()),
            item.span,
            supplied.inputs,
            supplied.results,
        )
        restated = formulas.named.get(name.text) if formulas is not None else None
        if restated is not None:
            found.append(_restated(restated, item, participants[item.participant.text]))
    return tuple(plays.values()), parts, tuple(found)


def _same_name(name: tree.Name, earlier: Plays) -> Diagnostic:
    problem = ParticipantNameTaken(name.text, earlier.protocol, earlier.participant)
    return Diagnostic(problem, name.span, (Related(earlier.span, "here"),))


def _restated(formula: tree.NamedFormula, plays: tree.Plays, participant: tree.Participant) -> Diagnostic:
    related = [Related(plays.span, "the role plays it here")]
    related += [
        Related(item.span, "its process") for item in participant.formulas if item.name.text == "process"
    ]
    problem = ProcessRestated(formula.name.text, plays.protocol.text, plays.participant.text)
    return Diagnostic(problem, formula.name.span, tuple(related))


def _bindings(
    written: tree.Plays,
    part: Part,
    party: tree.Participant,
    played: Mapping[str, Span],
) -> tuple[dict[str, str], tuple[Diagnostic, ...]]:
    """The protocol's activities, and the activities or formulas of the role that stand for them (E206)."""
    activities = part.formulas.activities
    others = {name.text for name in supplied_names(party)}
    found: list[Diagnostic] = []
    bindings: dict[str, str] = {}
    seen: set[str] = set()
    for item in written.bindings:
        abstract = item.abstract.text
        if abstract in seen:
            found.append(Diagnostic(BoundTwice(abstract), item.abstract.span))
        elif abstract in others:
            pass  # see `supply`
        elif abstract not in activities:
            pool = (*activities, *others)
            none = unknown(NoActivityToBind, item.abstract, pool, part.protocol, part.participant)
            related = (Related(part.formulas.named[part.formulas.root].span, "its process"),)
            found.append(replace(none, related=related))
        elif item.own is None:
            found.append(Diagnostic(BoundToExpression(abstract), item.expression.span))
        elif item.own.text in played:
            own = item.own.text
            found.append(
                Diagnostic(BoundToParticipant(own), item.own.span, (Related(played[own], "played here"),))
            )
        else:
            bindings[abstract] = item.own.text
        seen.add(abstract)
    return bindings, tuple(found)


def _other_parameters(
    written: tree.Srm, plays: Iterable[Plays], formulas: Formulas, symbols: Symbols
) -> Iterable[Diagnostic]:
    """E525 for a binding to what is given something else than the protocol gives it."""
    for _, binding, own in _bound(written, plays):
        abstract = symbols.activities.get(binding.abstract.text)
        wanted = [kind.type for kind in abstract.parameters] if abstract is not None else []
        form = symbols.activities.get(own)
        known = [] if abstract is None else [abstract]
        if own in formulas.named:
            has = formulas.parameters.get(own, ())
            if len(has) != len(formulas.named[own].parameters):
                continue  # that is said
            related = [Related(formulas.named[own].name.span, "the formula")]
        else:
            has = form.parameters if form is not None else ()
            known += [] if form is None else [form]
            related = []
        if wanted == [kind.type for kind in has]:
            continue
        if symbols.is_excused(own) or symbols.is_excused(binding.abstract.text):
            continue
        related += [Related(one.span, f"`{called(one.name, map(str, one.parameters))}`") for one in known]
        problem = BoundToOtherParameters(binding.abstract.text, own, tuple(map(str, wanted)))
        yield Diagnostic(problem, binding.expression.span, tuple(related))


def _bound(written: tree.Srm, plays: Iterable[Plays]) -> Iterator[tuple[Plays, tree.Binding, str]]:
    """The sound bindings of a role, each with what stands for the protocol's activity."""
    by_span = {item.span: item for item in plays}
    for play in written.plays:
        item = by_span.get(play.span)
        bindings = dict(item.bindings) if item is not None else {}
        for binding in play.bindings:
            own = bindings.get(binding.abstract.text)
            if item is not None and own is not None and binding.own is not None and binding.own.text == own:
                yield item, binding, own


def _emptiness(
    branches: Mapping[str, Branch], parts: Mapping[tuple[str, str], Part]
) -> tuple[formula_tables.IsEmpty, dict[tuple[str, str], tuple[Diagnostic, ...]]]:
    """Whether a participant may do nothing at all; and, filled meanwhile, loops over bound formulas that may.

    The loops are known by the name of the participant and that of the formula.
    """
    known: dict[str, bool] = {}
    loops: dict[tuple[str, str], tuple[Diagnostic, ...]] = {}

    def is_empty(name: str, formulas: Set[str]) -> bool:
        branch = branches.get(name)
        if branch is None:
            return False
        if name not in known:
            stops = stops_of(parts[branch.protocol, branch.participant].lines.by_way)
            bound = [activity for activity, own in branch.bindings.items() if own in formulas]
            known[name], _ = formula_tables.may_be_empty(branch.formulas, stops, bound)
            for activity in bound:
                _, found = formula_tables.may_be_empty(branch.formulas, stops, (activity,))
                loops[name, activity] = found
        return known[name]

    return is_empty, loops


def _unfit_formulas(
    written: tree.Srm,
    plays: Iterable[Plays],
    branches: Mapping[str, Branch],
    parts: Mapping[tuple[str, str], Part],
    loops: Mapping[tuple[str, str], tuple[Diagnostic, ...]],
) -> Iterable[Diagnostic]:
    """E593 for a formula that stands for an activity of whose outcome is asked, or in an empty loop."""
    for item, binding, own in _bound(written, plays):
        part = parts[item.protocol, item.participant]
        activity = binding.abstract.text
        asked = next((value for value in _outcomes_asked(part) if value.activity == activity), None)
        formula = next((one for one in written.formulas if one.name.text == own), None)
        if asked is not None and formula is not None:
            related = (Related(asked.span, "asked here"), Related(formula.name.span, "the formula"))
            yield Diagnostic(OutcomeOfFormula(activity, own), binding.expression.span, related)
        for loop in loops.get((item.name, activity), ())[:1]:
            places = () if loop.span is None else (Related(loop.span, "the loop"),)
            yield Diagnostic(EmptyFormulaInLoop(activity, own), binding.expression.span, places)


def _outcomes_asked(part: Part) -> Iterator[Outcome]:
    for lines in part.lines.by_way.values():
        for line in lines:
            for value in values_of(line.expression):
                if isinstance(value, Outcome):
                    yield value


def _by_own_name(plays: Sequence[Plays], played: Mapping[str, Plays], formulas: Formulas) -> dict[str, Plays]:
    """Participants that have another name in the role and may be called by their own as well."""
    found: dict[str, list[Plays]] = {}
    for item in plays:
        if item.participant not in played and item.participant not in formulas.named:
            found.setdefault(item.participant, []).append(item)
    return {name: items[0] for name, items in found.items() if len(items) == 1}


def _played_names(written: tree.Srm) -> dict[str, Span]:
    return {(item.alias or item.participant).text: item.span for item in written.plays}


def _unused(formulas: Formulas, plays: Sequence[Plays]) -> Iterable[Plays]:
    """What the role plays and no formula uses."""
    used = {node.name for item in formulas.named.values() for node in names(item.formula)}
    by_own_name = _by_own_name(plays, {item.name: item for item in plays}, formulas)
    used.update(item.name for name, item in by_own_name.items() if name in used)
    return (item for item in plays if item.name not in used and item.name not in formulas.named)


def _not_used(written: tree.Srm, formulas: Formulas, item: Plays) -> Missing:
    problem = ParticipantNotUsed(written.name.text, item.protocol, item.participant, item.name, formulas.root)
    note = Diagnostic(problem, item.span)
    return Missing(note, f"// Let a formula use the participant {item.name}.", written.span)


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
