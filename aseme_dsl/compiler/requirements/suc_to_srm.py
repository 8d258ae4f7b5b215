"""SUC to SRM: what each role is expected to do, and what is not said of it yet (P1, Figure 4)."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from aseme_dsl.amola.liveness import Formula, names
from aseme_dsl.amola.operators import Fixity, Operator
from aseme_dsl.amola.srm import Capability, Functionality, Module, Srm
from aseme_dsl.amola.statechart import Statechart, StateType
from aseme_dsl.amola.suc import RoleType, UseCase
from aseme_dsl.compiler.chart.srm_to_iac import Role
from aseme_dsl.compiler.formula.formulas import named_formulas
from aseme_dsl.compiler.names.usecases import (
    UseCases,
    activity_name,
    folded,
    formula_line,
    helper_formulas,
    joined,
)
from aseme_dsl.compiler.read.missing import Missing
from aseme_dsl.compiler.read.names import declared_twice, unknown
from aseme_dsl.compiler.requirements.suc_to_aip import participant_skeleton, participant_term
from aseme_dsl.diagnostics import Diagnostic, Edit, Related, closest
from aseme_dsl.diagnostics.problems.absences import NoActivityOfRole
from aseme_dsl.diagnostics.problems.missing import (
    NotAParticipant,
    RoleIncomplete,
    RoleNotWritten,
    UseCaseNotPlayed,
    UseCaseNotSpecified,
    UseCaseWithoutFormula,
)
from aseme_dsl.grammar.text import tree
from aseme_dsl.records import dataclass
from aseme_dsl.source import Span


def read_srm(
    role: Role,
    chart: Statechart | None,
    modules: tuple[Module, ...],
    cases: UseCases,
    included: Iterable[str] = (),
) -> tuple[Srm, tuple[Diagnostic, ...]]:
    """The role as written, with the capabilities that its use cases and those of `included` roles give it."""
    written = role.written
    found: list[Diagnostic] = []
    activities = activities_of(chart) if chart is not None else ()
    functionalities: dict[str, Functionality] = {}
    for item in written.functionalities:
        if item.name.text in functionalities:
            found.append(declared_twice("functionality", item.name, functionalities[item.name.text].span))
            continue
        functionalities[item.name.text] = Functionality(
            item.name.text,
            _text(item.technology),
            _text(item.permissions),
            _text(item.environment),
            _text(item.algorithm),
            item.name.span,
        )
    capabilities, problems = _capabilities(role, activities, cases, included)
    found += problems
    model = Srm(
        role.name,
        role.plays,
        role.typed.variables,
        named_formulas(role.formulas),
        activities,
        tuple(functionalities.values()),
        capabilities,
        written.name.span,
        modules,
        tuple(dict.fromkeys(item.text for item in written.includes)),
    )
    return model, tuple(found)


def _text(written: tree.Text | None) -> str:
    return written.text if written is not None else ""


def activities_of(chart: Statechart) -> tuple[str, ...]:
    """The activities of a chart, each once, in document order."""
    return tuple(
        dict.fromkeys(
            node.activity
            for node in chart.states
            if node.type is StateType.BASIC and node.activity is not None
        )
    )


def _capabilities(
    role: Role, activities: Sequence[str], cases: UseCases, included: Iterable[str]
) -> tuple[tuple[Capability, ...], tuple[Diagnostic, ...]]:
    found: list[Diagnostic] = []
    capabilities: dict[str, Capability] = {}
    known = {*activities, *(role.formulas.named if role.formulas is not None else ())}
    known.update(item.name for item in role.plays)
    for item in role.written.capabilities:
        key = folded(item.name.text)
        if key in capabilities:
            found.append(declared_twice("capability", item.name, capabilities[key].span))
            continue
        for name in item.activities:
            if role.outline is not None and name.text not in known:
                found.append(unknown(NoActivityOfRole, name, known, role.name))
        names = tuple(name.text for name in item.activities)
        capabilities[key] = Capability(item.name.text, names, _text(item.description), item.name.span)
    for case in _cases_of([role.name, *included], role, cases):
        if case.includes and folded(case.name) not in capabilities:
            capabilities[folded(case.name)] = Capability(
                case.name, cases.activities(case), case.requirements, case.span
            )
    return tuple(capabilities.values()), tuple(found)


def _cases_of(own: Sequence[str], role: Role | None, cases: UseCases) -> list[UseCase]:
    """The use cases of a role by its names, those of the participants that it plays included."""
    names = list(own)
    if role is not None:
        names += [item.participant for item in role.plays]
    found = {case.name: case for item in names for case in cases.by_participant.get(item, ())}
    return list(found.values())


# ---- what is missing -----------------------------------------------------------------------------


def suc_to_srm(
    cases: UseCases, roles: Mapping[str, Role], charts: Iterable[str], protocols: Sequence[tree.Aip]
) -> tuple[Missing, ...]:
    """Notes for the roles (N703), formulas (N702) and use cases (N700) that nothing specifies yet.

    `charts` are the roles that are written as a statechart: what they do is not looked into.
    """
    found: list[Missing] = []
    written = _Written(cases, protocols)
    elsewhere = set(charts)
    noted: set[str] = set()  # use cases that a note's skeleton contains, folded
    for item in cases.suc.roles:
        if item.type not in (RoleType.SYSTEM, RoleType.ABSTRACT):
            elsewhere.add(item.name)
        elif item.type is RoleType.SYSTEM and item.name not in roles and item.name not in elsewhere:
            skeleton = srm_skeleton(item.name, cases, protocols)
            note = Diagnostic(RoleNotWritten(item.name, skeleton), item.span)
            found.append(Missing(note, skeleton))
            elsewhere.add(item.name)
            noted |= _included(_cases_of([item.name], None, cases), cases)
    for name, role in roles.items():
        for case in _cases_of([name], None, cases):
            if case.includes and not _is_realised(case, role, written):
                found.append(_no_formula(case, role, written))
                if written.protocol_of(case) is None:  # else its participants do what it includes
                    noted |= _included([case], cases)
    for case in cases.suc.usecases:
        if cases.is_protocol(case) and written.protocol_of(case) is None:
            noted |= _included([case], cases)  # N701
    for case in cases.suc.usecases:
        left_to_others = case.participants and elsewhere.issuperset(case.participants)
        specified = not cases.spellings.keys().isdisjoint(cases.names_of(case))
        if left_to_others or specified or folded(case.name) in noted:
            continue
        others = {name for other in cases.suc.usecases if other is not case for name in cases.names_of(other)}
        free = [name for name in cases.spellings if name not in others]
        near = next((near for name in cases.names_of(case) if (near := closest(name, free))), None)
        meant = cases.spellings[near] if near is not None else None
        problem = UseCaseNotSpecified(case.name, cases.spelling(case), meant)
        note = Diagnostic(problem, case.span)
        doer = next((roles[name] for name in case.participants if name in roles), None)
        inside = doer.written.span if doer is not None else None
        edits = () if near is not None else _used_in(case, doer, roles, written)
        found.append(Missing(note, f"// The use case {case.name}: {problem.hint}.", inside, edits))
    return tuple(found)


def _used_in(
    case: UseCase, doer: Role | None, roles: Mapping[str, Role], written: _Written
) -> tuple[Edit, ...]:
    """Insertions that add the use case to a formula of a use case which includes it, or of the role `doer`.

    If the including use case is a protocol, the formulas are the processes of participants that may do it.
    """
    cases = written.cases
    for outer in cases.suc.usecases:
        if case.name in outer.includes:
            protocol = written.protocol_of(outer)
            edits = tuple(
                edit
                for participant in (protocol.participants if protocol is not None else ())
                if not case.participants or participant.name.text in case.participants
                for formula in participant.formulas
                if formula.name.text == "process"
                for edit in _joined_to(formula.formula, participant_term(cases, case))
            )
            if edits:
                return edits
            wanted = cases.names_of(outer)
            for role in roles.values():
                for item in role.written.formulas:
                    if folded(item.name.text) in wanted and _is_inside(item.formula.span, role):
                        return _joined_to(item.formula, cases.spelling(case))
    if doer is None or not doer.written.formulas:
        return ()
    root = doer.written.formulas[0].formula
    return _joined_to(root, cases.spelling(case)) if _is_inside(root.span, doer) else ()


def _is_inside(span: Span, role: Role) -> bool:
    """Whether a formula stands in the role's own text, and not in that of a role which it includes."""
    own = role.written.span
    return span.source is own.source and own.start <= span.start and span.end <= own.end


def _joined_to(formula: Formula, term: str) -> tuple[Edit, ...]:
    """Insertions that join a term to a whole formula, with a hole: how is still to be chosen."""

    def at(offset: int, text: str) -> Edit:
        return Edit(Span(formula.span.source, offset, offset), text)

    start, end = formula.span.start, formula.span.end
    row = formula.operator.row
    loose = row.fixity is Fixity.INFIX and row.precedence < Operator.HOLE.row.precedence
    brackets = (at(start, "("), at(end, ")")) if loose else ()
    return (*brackets, at(end, f" {Operator.HOLE} {term}"))


@dataclass(frozen=True, slots=True)
class _Written:
    """The use cases with the protocols that are written."""

    cases: UseCases
    protocols: Sequence[tree.Aip]

    def protocol_of(self, case: UseCase) -> tree.Aip | None:
        names = self.cases.names_of(case)
        return next(
            (item for item in self.protocols if folded(item.name.text) in names and item.participants), None
        )

    def parts(self, case: UseCase) -> list[tuple[str, str]] | None:
        """The protocol and the participants of a use case that is one, written or not."""
        protocol = self.protocol_of(case)
        if protocol is not None:
            return [(protocol.name.text, item.name.text) for item in protocol.participants]
        if self.cases.is_protocol(case):
            return [(case.name, name) for name in self.cases.parties(case)]
        return None

    def plays(self, case: UseCase, role: str) -> dict[str, str] | None:
        """What a role plays of a use case that is a protocol: its own part, or any; by the names it uses.

        A part that is called like the role has another name there, because the role's formula has this one.
        """
        parts = self.parts(case)
        if parts is None:
            return None
        own = [part for part in parts if part[1] == role] or parts
        return {
            f"{protocol}_{name}" if name == role else name: f"{protocol}.{name}"
            + (f" as {protocol}_{name}" if name == role else "")
            for protocol, name in own
        }

    def term(self, case: UseCase, role: str) -> str:
        """How a formula of a role uses the use case: by its name, or by the participants of its protocol."""
        plays = self.plays(case, role)
        if plays is None:
            return self.cases.spelling(case)
        return next(iter(plays)) if len(plays) == 1 else f"({joined(plays)})"


def _included(cases: Iterable[UseCase], all_cases: UseCases) -> set[str]:
    """The folded names of some use cases and of all that they include."""
    found: set[str] = set()
    waiting = list(cases)
    while waiting:
        case = waiting.pop()
        if folded(case.name) not in found:
            found.add(folded(case.name))
            waiting += [all_cases.case(name) for name in case.includes]
    return found


def _is_realised(case: UseCase, role: Role, written: _Written) -> bool:
    """Whether the role has a formula, an activity or a capability for the use case, or plays its protocol."""
    own = {folded(item.name.text) for item in role.written.formulas}
    own.update(folded(item.name.text) for item in role.written.capabilities)
    own.update(folded(item.protocol.text) for item in role.written.plays)
    own.update(folded(node.name) for item in role.written.formulas for node in names(item.formula))
    if role.outline is not None:
        own.update(folded(node.activity) for node in role.outline.nodes if node.activity is not None)
    if not own.isdisjoint(written.cases.names_of(case)):
        return True
    # A protocol that is not written yet is a note of its own.
    return written.cases.is_protocol(case) and written.protocol_of(case) is None


def _no_formula(case: UseCase, role: Role, written: _Written) -> Missing:
    place = role.written.name.span
    protocol = written.protocol_of(case)
    plays = written.plays(case, role.name)
    if protocol is not None and _lacks(protocol, role.name, case):
        lines = participant_skeleton(written.cases, case, role.name)
        problem: RoleIncomplete = NotAParticipant(role.name, case.name, tuple(lines))
        note = Diagnostic(problem, place, (Related(protocol.name.span, "the protocol"),))
        return Missing(note, "\n".join(lines), protocol.span)
    if protocol is not None and plays is not None:
        lines = [f"plays {item}" for item in plays.values()]
        problem = UseCaseNotPlayed(role.name, case.name, protocol.name.text, tuple(lines))
        advice = f"// The use case {case.name}; let a formula use the participant:"
        note = Diagnostic(problem, place, (Related(protocol.name.span, "the protocol"),))
    else:
        lines = helper_formulas(written.cases, [case], lambda item: written.term(item, role.name))
        name = written.cases.spelling(case)
        advice = f"// The use case {case.name}; let a formula use `{name}`:"
        note = Diagnostic(UseCaseWithoutFormula(role.name, case.name, name, tuple(lines)), place)
    # As a comment: what no formula uses would be an error.
    skeleton = "\n".join([advice, *(f"//   {line}" for line in lines)])
    edits: tuple[Edit, ...] = ()
    formulas = role.written.formulas
    if protocol is None and formulas and all(_is_inside(item.span, role) for item in formulas):
        edits = _joined_to(formulas[0].formula, written.cases.spelling(case))
        edits = (*edits, *_lines_after(formulas[-1], lines))
    return Missing(note, skeleton, role.written.span, edits)


def _lacks(protocol: tree.Aip, role: str, case: UseCase) -> bool:
    """Whether a protocol whose participants are called like the roles of its use case has none for a role."""
    names = {item.name.text for item in protocol.participants}
    return role in case.participants and role not in names and names.issubset(case.participants)


def _lines_after(formula: tree.NamedFormula, lines: Sequence[str]) -> tuple[Edit, ...]:
    """The insertion of formulas behind another one: below it and its comment, or on its line."""
    source = formula.span.source
    number, column = source.position(formula.span.start)
    last, _ = source.position(formula.span.end)
    indent = source.line(number)[: column - 1]
    end_of_line = source.line_start(last) + len(source.line(last))
    rest = source.text[formula.span.end : end_of_line].strip()
    if indent.strip() or (rest and not rest.startswith("//")):
        place = Span(source, formula.span.end, formula.span.end)
        return (Edit(place, "".join(f"  {line}" for line in lines)),)
    return (Edit(Span(source, end_of_line, end_of_line), "".join(f"\n{indent}{line}" for line in lines)),)


def srm_skeleton(name: str, cases: UseCases, protocols: Sequence[tree.Aip]) -> str:
    """An `srm` to start from: every use case of the role, with all that they include; nothing is left out."""
    written = _Written(cases, protocols)
    own = _cases_of([name], None, cases)
    inner = {folded(item) for case in own for item in case.includes}
    outer = [case for case in own if folded(case.name) not in inner] or own
    plays: dict[str, None] = {}
    for key in sorted(_included(outer, cases)):
        case = cases.by_name[key]
        needed = written.plays(case, name)
        if needed is not None and not _only_inside_a_protocol(case, outer, written):
            plays.update(dict.fromkeys(needed.values()))
    parts: list[UseCase] = []
    for case in outer:
        if case.includes and written.term(case, name) == name:
            # The role's own formula has the name of this use case: what it includes stands there.
            parts += [cases.case(item) for item in case.includes]
        else:
            parts.append(case)
    terms = [written.term(case, name) for case in parts] or [f"Do{name[0].upper()}{name[1:]}"]
    formulas = [formula_line(name, [activity_name(term) if term == name else term for term in terms])]
    single = [case for case in parts if written.parts(case) is None]
    formulas += helper_formulas(cases, single, lambda item: written.term(item, name))
    return "\n".join(
        [
            f"srm {name} {{",
            *(f"  plays {item}" for item in plays),
            "  liveness {",
            *(f"    {line}" for line in formulas),
            "  }",
            "}",
        ]
    )


def _only_inside_a_protocol(case: UseCase, outer: Iterable[UseCase], written: _Written) -> bool:
    """Whether every way from the role's use cases to this one leads through another protocol."""
    seen: set[str] = set()
    waiting = list(outer)
    while waiting:
        item = waiting.pop()
        if folded(item.name) == folded(case.name):
            return False
        if folded(item.name) not in seen and written.parts(item) is None:
            seen.add(folded(item.name))
            waiting += [written.cases.case(name) for name in item.includes]
    return True


__all__ = ["activities_of", "read_srm", "srm_skeleton", "suc_to_srm"]
