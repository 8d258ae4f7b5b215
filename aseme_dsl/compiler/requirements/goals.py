"""Goals: use cases without a role that has them, unplayed participants, activities without functionality."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import chain

from aseme_dsl.amola.srm import Activity
from aseme_dsl.amola.statechart import StateType
from aseme_dsl.amola.suc import RoleType
from aseme_dsl.compiler.chart.srm_to_iac import Role
from aseme_dsl.compiler.names.usecases import UseCases, folded
from aseme_dsl.compiler.read.blocks import participants_of
from aseme_dsl.compiler.read.memory import Memory
from aseme_dsl.compiler.read.pieces import InPieces
from aseme_dsl.diagnostics import Diagnostic, Related, closest
from aseme_dsl.diagnostics.problems.absences import NoFunctionality
from aseme_dsl.diagnostics.problems.activities import NamedLikeParticipant
from aseme_dsl.diagnostics.problems.missing import (
    FunctionalityNotSaid,
    ParticipantWithoutPlayer,
    ProtocolWithoutPlayer,
    RoleIncomplete,
    UseCaseOfOthers,
)
from aseme_dsl.grammar.text import tree
from aseme_dsl.source import Source, Span


def out_of_reach(
    cases: UseCases, roles: Mapping[str, Role], formulas: Iterable[tree.NamedFormula]
) -> Iterator[Diagnostic]:
    """N705: a use case whose formulas and activities exist, but not in a role that takes part in it.

    Protocols are not checked, nor use cases of people, of other systems and of roles without an `srm`.
    """
    if not cases.suc.usecases:
        return
    own_types = (RoleType.SYSTEM, RoleType.ABSTRACT)
    elsewhere = {item.name for item in cases.suc.roles if item.type not in own_types}
    reached = {name: _reached(role) for name, role in roles.items()}
    if any(found is None for found in reached.values()):
        return
    doers: dict[str, set[str]] = {name: {name} for name in roles}
    for name, role in roles.items():
        for _, participant in role.parts:
            doers.setdefault(participant, set()).add(name)
    places = {folded(item.name.text): item.name.span for item in formulas}
    for case in cases.suc.usecases:
        names = set(cases.names_of(case))
        if not case.participants or cases.is_protocol(case) or not names & cases.spellings.keys():
            continue
        if any(name in elsewhere or name not in doers for name in case.participants):
            continue
        own = {role for name in case.participants for role in doers[name]}
        if any(not names.isdisjoint(reached[role] or ()) for role in own):
            continue
        others = [name for name, found in reached.items() if not names.isdisjoint(found or ())]
        if others:
            doer = roles[others[0]].written.name.span
            place = next((places[name] for name in names if name in places), doer)
            problem = UseCaseOfOthers(
                case.name, cases.spelling(case), case.participants, tuple(sorted(own)), tuple(others)
            )
            yield Diagnostic(problem, case.span, (Related(place, "here"),))


def _reached(role: Role) -> set[str] | None:
    """The names, folded, of all that a role's formulas come to; None where they cannot be expanded."""
    if role.outline is None or role.formulas is None:
        return None
    found = {folded(name) for name in role.formulas.named}
    found.update(folded(item.name.text) for item in role.written.capabilities)
    for node in role.outline.nodes:
        if node.activity is not None:
            found.add(folded(node.activity))
        elif node.type is StateType.OR:
            found.add(folded(node.name))
    for item in role.plays:
        found.update((folded(item.protocol), folded(item.participant)))
        part = role.parts.get((item.protocol, item.participant))
        if part is not None:
            found.update(folded(name) for name in part.formulas.named)
            # What it binds to its own activities, it does in its own way.
            found.update(folded(abstract) for abstract, _ in item.bindings)
    return found


def not_played(
    aips: Iterable[tree.Aip], roles: Iterable[Role], home: Source, told: Iterable[Diagnostic]
) -> Iterator[Diagnostic]:
    """N706: a participant of the system's own protocols that no role plays.

    Protocols of other files are there to be played in part: another system may have the other part. What
    `told` says of a protocol or participant (W202, N702) is not said again.
    """
    partly = (NamedLikeParticipant, RoleIncomplete)
    known = {place.span for item in told if isinstance(item.problem, partly) for place in item.related}
    roles = list(roles)
    if not roles:
        return
    played = {(item.protocol.text, item.participant.text) for role in roles for item in role.written.plays}
    played.update(*(role.parts for role in roles))
    for aip in aips:
        if aip.span.source.path != home.path or aip.name.span in known:
            continue
        participants = participants_of(aip)
        left = [item for item in participants if (aip.name.text, item.name.text) not in played]
        left = [item for item in left if item.name.span not in known]
        if not left:
            continue
        if len(left) == len(participants):
            yield Diagnostic(ProtocolWithoutPlayer(aip.name.text, left[0].name.text), aip.name.span)
            continue
        for item in left:
            yield Diagnostic(ParticipantWithoutPlayer(aip.name.text, item.name.text), item.name.span)


def without_functionality(
    roles: Sequence[Role], activities: Mapping[str, Activity], memory: Memory
) -> InPieces[list[Diagnostic]]:
    """N707: activities without functionality, in a role that describes some; W230: a name close to one's."""
    known: dict[str, Span] = {}
    for role in roles:
        for item in role.written.functionalities:
            known.setdefault(item.name.text, item.name.span)
    if not known:
        return []
    found = yield from memory.each_in_pieces(_without_functionality, zip(roles), known, activities)
    return list(chain.from_iterable(found))


def _without_functionality(
    role: Role, known: Mapping[str, Span], activities: Mapping[str, Activity]
) -> tuple[Diagnostic, ...]:
    found: list[Diagnostic] = []
    for written in role.written.activities:
        for name in written.uses:
            near = closest(name.text, known) if name.text not in known else None
            if near is not None:
                found.append(
                    Diagnostic(
                        NoFunctionality(name.text, near, tuple(known)),
                        name.span,
                        (Related(known[near], f"`{near}`"),),
                        fix=near,
                    )
                )
    if not role.written.functionalities or role.outline is None:
        return tuple(found)
    names = dict.fromkeys(node.activity for node in role.outline.nodes if node.activity is not None)
    idle = tuple(name for name in names if name not in activities or not activities[name].uses)
    if idle:
        problem = FunctionalityNotSaid(role.name, idle, next(iter(known)))
        found.append(Diagnostic(problem, role.written.name.span))
    return tuple(found)


__all__ = ["not_played", "out_of_reach", "without_functionality"]
