"""SUC to SRM: what each role is expected to do, and what is not said of it yet (P1, Figure 4)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

from aseme_dsl.amola.aip import NamedFormula
from aseme_dsl.amola.srm import Capability, Functionality, Srm
from aseme_dsl.amola.statechart import NodeType, Statechart
from aseme_dsl.amola.suc import RoleType, UseCase
from aseme_dsl.compiler.names import declared_twice, unknown
from aseme_dsl.compiler.srm_to_iac import Role
from aseme_dsl.compiler.usecases import ORDER, UseCases, folded, joined
from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.grammar import tree


def read_srm(role: Role, chart: Statechart | None, cases: UseCases) -> tuple[Srm, tuple[Diagnostic, ...]]:
    """The role as written, with the capabilities that its use cases give it."""
    written = role.written
    found: list[Diagnostic] = []
    activities = activities_of(chart) if chart is not None else ()
    functionalities: dict[str, Functionality] = {}
    for item in written.functionalities:
        if item.name.text in functionalities:
            found.append(declared_twice("the functionality", item.name, functionalities[item.name.text].span))
            continue
        functionalities[item.name.text] = Functionality(
            item.name.text,
            _text(item.technology),
            _text(item.permissions),
            _text(item.environment),
            _text(item.algorithm),
            item.name.span,
        )
    capabilities, problems = _capabilities(role, activities, cases)
    found += problems
    formulas = role.formulas.named.values() if role.formulas is not None else ()
    model = Srm(
        role.name,
        role.plays,
        role.typed.variables,
        tuple(NamedFormula(item.name.text, item.formula, item.span) for item in formulas),
        activities,
        tuple(functionalities.values()),
        capabilities,
        written.name.span,
    )
    return model, tuple(found)


def _text(written: tree.Text | None) -> str:
    return written.text if written is not None else ""


def activities_of(chart: Statechart) -> tuple[str, ...]:
    """The activities of a chart, each once, in document order."""
    return tuple(
        dict.fromkeys(
            node.activity for node in chart.nodes if node.type is NodeType.BASIC and node.activity is not None
        )
    )


def _capabilities(
    role: Role, activities: Sequence[str], cases: UseCases
) -> tuple[tuple[Capability, ...], tuple[Diagnostic, ...]]:
    found: list[Diagnostic] = []
    capabilities: dict[str, Capability] = {}
    known = {*activities, *(role.formulas.named if role.formulas is not None else ())}
    known.update(item.name for item in role.plays)
    for item in role.written.capabilities:
        key = folded(item.name.text)
        if key in capabilities:
            found.append(declared_twice("the capability", item.name, capabilities[key].span))
            continue
        for name in item.activities:
            if role.outline is not None and name.text not in known:
                found.append(unknown("E204", f"{role.name} has no activity", name, known))
        names = tuple(name.text for name in item.activities)
        capabilities[key] = Capability(item.name.text, names, _text(item.description), item.name.span)
    for case in _cases_of(role.name, role, cases):
        if case.includes and folded(case.name) not in capabilities:
            capabilities[folded(case.name)] = Capability(
                case.name, cases.activities(case), case.requirements, case.span
            )
    return tuple(capabilities.values()), tuple(found)


def _cases_of(name: str, role: Role | None, cases: UseCases) -> Iterator[UseCase]:
    """The use cases of a role, those of the participants that it plays included."""
    names = {name}
    if role is not None:
        names.update(item.participant for item in role.plays)
    return (case for case in cases.suc.usecases if names.intersection(case.participants))


# ---- what is missing -----------------------------------------------------------------------------


def suc_to_srm(
    cases: UseCases, roles: Mapping[str, Role], charts: Iterable[str], protocols: Sequence[tree.Aip]
) -> tuple[Diagnostic, ...]:
    """Notes for the roles (N703), formulas (N702) and use cases (N700) that nothing specifies yet.

    `charts` are the roles that are written as a statechart: what they do is not looked into.
    """
    found: list[Diagnostic] = []
    charts = set(charts)
    covered: set[str] = set()
    for item in cases.suc.roles:
        if item.type is not RoleType.SYSTEM or item.name in charts:
            continue
        if item.name not in roles:
            covered.add(item.name)
            found.append(
                Diagnostic(
                    "N703",
                    f"the role `{item.name}` is not written yet",
                    item.span,
                    hint="start from\n" + srm_skeleton(item.name, cases, protocols),
                )
            )
    for name, role in roles.items():
        for case in _cases_of(name, None, cases):
            if case.includes and not _is_realised(case, role, cases, protocols):
                found.append(_no_formula(case, role, cases, protocols))
    human = {item.name for item in cases.suc.roles if item.type not in (RoleType.SYSTEM, RoleType.ABSTRACT)}
    for case in cases.suc.usecases:
        participants = set(case.participants)
        left_to_others = bool(participants) and participants <= covered | charts | human
        reported = case.includes and (participants & set(roles) or cases.is_protocol(case))
        if left_to_others or reported or not cases.spellings.keys().isdisjoint(cases.names_of(case)):
            continue
        if not case.participants and _is_included_by(case, cases, covered):
            continue
        found.append(
            Diagnostic(
                "N700",
                f"nothing specifies the use case `{case.name}`",
                case.span,
                hint=f"let a formula use `{cases.spelling(case)}`, or say what it `realises`",
            )
        )
    return tuple(found)


def _is_included_by(case: UseCase, cases: UseCases, covered: set[str]) -> bool:
    """Whether the skeleton of a role that is not written yet contains the use case."""
    return any(
        covered.issuperset(other.participants) and other.participants
        for other in cases.suc.usecases
        if any(folded(name) == folded(case.name) for name in other.includes)
    )


def _is_realised(case: UseCase, role: Role, cases: UseCases, protocols: Sequence[tree.Aip]) -> bool:
    """Whether the role has a formula, an activity or a capability for the use case, or plays its protocol."""
    own = {folded(item.name.text) for item in role.written.formulas}
    own.update(folded(item.name.text) for item in role.written.capabilities)
    own.update(folded(item.protocol.text) for item in role.written.plays)
    if role.outline is not None:
        own.update(folded(node.activity) for node in role.outline.nodes if node.activity is not None)
    if not own.isdisjoint(cases.names_of(case)):
        return True
    # A protocol that is not written yet is a note of its own.
    written = {folded(item.name.text) for item in protocols}
    return cases.is_protocol(case) and written.isdisjoint(cases.names_of(case))


def _no_formula(case: UseCase, role: Role, cases: UseCases, protocols: Sequence[tree.Aip]) -> Diagnostic:
    protocol = _protocol_of(case, cases, protocols)
    if protocol is not None:
        participants = [item.name.text for item in protocol.participants]
        part = role.name if role.name in participants else participants[0]
        hint = f"say which part it takes: `plays {protocol.name}.{part}`"
        message = f"{role.name} takes part in the use case `{case.name}`, but plays none of {protocol.name}"
        return Diagnostic("N702", message, role.written.name.span, hint=hint)
    lines = list(_formula_lines(case, cases, protocols))
    return Diagnostic(
        "N702",
        f"{role.name} has no formula for the use case `{case.name}`",
        role.written.name.span,
        hint="start from\n" + "\n".join(lines) + f"\nand let a formula use `{case.name}`",
    )


def _protocol_of(case: UseCase, cases: UseCases, protocols: Sequence[tree.Aip]) -> tree.Aip | None:
    names = cases.names_of(case)
    return next((item for item in protocols if folded(item.name.text) in names and item.participants), None)


def _term(case: UseCase, cases: UseCases, protocols: Sequence[tree.Aip]) -> str:
    """How a formula uses the use case: by its name, or by the participants of its protocol."""
    protocol = _protocol_of(case, cases, protocols)
    if protocol is not None:
        names = [item.name.text for item in protocol.participants]
    elif cases.is_protocol(case):
        names = list(case.participants)
    else:
        return cases.spelling(case)
    return names[0] if len(names) == 1 else f"({' | '.join(names)})"


def _formula_lines(
    case: UseCase, cases: UseCases, protocols: Sequence[tree.Aip], done: set[str] | None = None
) -> Iterator[str]:
    """A formula for a use case with inclusions, and those for what it includes."""
    done = set() if done is None else done
    waiting = [case]
    while waiting:
        item = waiting.pop(0)
        if folded(item.name) in done:
            continue
        done.add(folded(item.name))
        parts = [cases.case(name) for name in item.includes]
        note = f"  {ORDER}" if len(parts) > 1 else ""
        yield f"{cases.spelling(item)} = {joined(_term(p, cases, protocols) for p in parts)}{note}"
        waiting += [
            p
            for p in parts
            if p.includes and not cases.is_protocol(p) and _protocol_of(p, cases, protocols) is None
        ]


def srm_skeleton(name: str, cases: UseCases, protocols: Sequence[tree.Aip]) -> str:
    """An `srm` to start from: every use case of the role, with all that they include; nothing is left out."""
    own = list(_cases_of(name, None, cases))
    inner = {folded(item) for case in own for item in case.includes}
    outer = [case for case in own if folded(case.name) not in inner] or own
    plays: dict[str, None] = {}
    needed = list(outer)
    seen: set[str] = set()
    while needed:
        case = needed.pop(0)
        if folded(case.name) in seen:
            continue
        seen.add(folded(case.name))
        protocol = _protocol_of(case, cases, protocols)
        if protocol is not None:
            plays.update((f"{protocol.name}.{item.name}", None) for item in protocol.participants)
        elif cases.is_protocol(case):
            plays.update((f"{case.name}.{item}", None) for item in case.participants)
        else:
            needed += [cases.case(item) for item in case.includes]
    terms = [_term(case, cases, protocols) for case in outer]
    if outer and all(term == name for term in terms):
        terms = [f"Be{name[0].upper()}{name[1:]}"]
    formulas = [f"{name} = {joined(terms)}" + (f"  {ORDER}" if len(terms) > 1 else "")] if terms else []
    done: set[str] = set()
    for case in outer:
        if case.includes and not cases.is_protocol(case) and _protocol_of(case, cases, protocols) is None:
            formulas += _formula_lines(case, cases, protocols, done)
    if not formulas:
        formulas = [f"{name} = Do{name[0].upper()}{name[1:]}"]
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


__all__ = ["activities_of", "read_srm", "srm_skeleton", "suc_to_srm"]
