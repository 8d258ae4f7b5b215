"""Renamed: use cases that have another name now than the protocol or the formula which specifies them."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import replace

from aseme_dsl.amola.liveness import names
from aseme_dsl.amola.suc import RoleType, UseCase
from aseme_dsl.compiler.names.usecases import UseCases, folded
from aseme_dsl.compiler.read.blocks import participants_of
from aseme_dsl.compiler.read.library import is_of_library
from aseme_dsl.diagnostics import Diagnostic, Related
from aseme_dsl.diagnostics.problems.names import RoleRenamed, UseCaseRenamed
from aseme_dsl.grammar.text import tree


def renamed(
    cases: UseCases, aips: Sequence[tree.Aip], srms: Iterable[tree.Srm]
) -> tuple[UseCases, tuple[Diagnostic, ...]]:
    """W560 for each use case that nothing specifies, where what has no use case does the same.

    In the use cases that come back they realise it, so that nothing is asked for that is there already.
    """
    taken = {name for case in cases.suc.usecases for name in cases.names_of(case)}
    free = [
        item for item in aips if folded(item.name.text) not in taken and not is_of_library(item.span.source)
    ]
    srms = list(srms)
    found: list[Diagnostic] = []
    now: list[UseCase] = []
    for case in cases.suc.usecases:
        meant = None
        is_protocol = cases.is_protocol(case)
        if case.includes and cases.spellings.keys().isdisjoint(cases.names_of(case)):
            if is_protocol:
                meant = next((item.name for item in free if _is_protocol_of(case, cases, item)), None)
            else:
                meant = next(_formulas_of(case, cases, srms, taken), None)
        if meant is None:
            now.append(case)
            continue
        taken.add(folded(meant.text))
        free = [item for item in free if item.name is not meant]
        now.append(replace(case, realises=(*case.realises, meant.text)))
        problem = UseCaseRenamed(case.name, "protocol" if is_protocol else "formula", meant.text)
        found.append(Diagnostic(problem, case.span, (Related(meant.span, "is it this?"),)))
    if not found:
        return cases, ()
    suc = replace(cases.suc, usecases=tuple(now))
    by_name = {folded(case.name): case for case in now}
    by_participant = {
        name: [by_name[folded(case.name)] for case in own] for name, own in cases.by_participant.items()
    }
    return UseCases(suc, by_name, by_participant, cases.spellings), tuple(found)


def renamed_roles(
    cases: UseCases, srms: Sequence[tree.Srm], written: Collection[str]
) -> tuple[frozenset[str], tuple[Diagnostic, ...]]:
    """The roles that are not `written`, where one that `suc` does not name does the same; W560 each."""
    known = {role.name for role in cases.suc.roles}
    known |= {name for case in cases.suc.usecases for name in case.participants}
    free = [srm for srm in srms if srm.name.text not in known and not is_of_library(srm.span.source)]
    found: list[Diagnostic] = []
    names_of_roles: set[str] = set()
    for role in cases.suc.roles:
        if role.type is not RoleType.SYSTEM or role.name in written:
            continue
        own = [case for case in cases.suc.usecases if role.name in case.participants]
        wanted = {name for case in own for name in cases.names_of(case)}
        meant = next((srm for srm in free if not wanted.isdisjoint(_done_by(srm))), None)
        if meant is None:
            continue
        free.remove(meant)
        names_of_roles.add(role.name)
        problem = RoleRenamed(role.name, meant.name.text)
        found.append(Diagnostic(problem, role.span, (Related(meant.name.span, "is it this?"),)))
    return frozenset(names_of_roles), tuple(found)


def _done_by(srm: tree.Srm) -> set[str]:
    """What the formulas of a role name, and what they are called."""
    return {
        folded(name)
        for item in srm.formulas
        for name in (item.name.text, *(node.name for node in names(item.formula)))
    }


def _is_protocol_of(case: UseCase, cases: UseCases, aip: tree.Aip) -> bool:
    """Whether two roles of the use case take part, and something that it includes is done there."""
    parts = participants_of(aip)
    if len({part.name.text for part in parts} & set(cases.parties(case))) < 2:
        return False
    done = {folded(node.name) for part in parts for item in part.formulas for node in names(item.formula)}
    return any(not done.isdisjoint(wanted) for wanted in _included(case, cases))


def _formulas_of(
    case: UseCase, cases: UseCases, srms: Iterable[tree.Srm], taken: set[str]
) -> Iterator[tree.Name]:
    """Formulas of the roles of the use case, but for their roots, which have all that it includes."""
    for srm in srms:
        if srm.name.text not in case.participants:
            continue
        for item in srm.formulas[1:]:
            done = {folded(node.name) for node in names(item.formula)}
            if folded(item.name.text) not in taken and all(
                not done.isdisjoint(wanted) for wanted in _included(case, cases)
            ):
                yield item.name


def _included(case: UseCase, cases: UseCases) -> list[tuple[str, ...]]:
    """The names of each use case that one includes."""
    return [cases.names_of(cases.case(name)) for name in case.includes]


__all__ = ["renamed", "renamed_roles"]
