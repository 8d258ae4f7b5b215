"""SUC to AIP: a use case with several participants and inclusions is a protocol (P1, section 4.2)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from aseme_dsl.amola.aip import Aip, NamedFormula, Participant
from aseme_dsl.amola.suc import UseCase
from aseme_dsl.compiler.chart.chart import Part
from aseme_dsl.compiler.names.usecases import UseCases, activity_name, folded, formula_line, helper_formulas
from aseme_dsl.compiler.read.blocks import participants_of
from aseme_dsl.compiler.read.damage import Damaged
from aseme_dsl.compiler.read.missing import Missing
from aseme_dsl.compiler.read.names import unknown
from aseme_dsl.compiler.requirements.clauses import read_clauses
from aseme_dsl.compiler.types.scopes import TypedParticipant
from aseme_dsl.diagnostics import Diagnostic, Related
from aseme_dsl.diagnostics.problems.absences import NoActivityToSend
from aseme_dsl.diagnostics.problems.missing import ProtocolNotWritten
from aseme_dsl.grammar.text import tree


def read_aip(
    written: tree.Aip,
    typed: Mapping[str, TypedParticipant],
    parts: Mapping[str, Part],
    is_damaged: Damaged,
) -> tuple[Aip, tuple[Diagnostic, ...]]:
    """The protocol as written; a participant's formulas begin with its process.

    `parts` are the participants whose process is sound.
    """
    clauses, outcomes, problems = read_clauses(written, is_damaged)
    found = list(problems)
    participants = []
    for item in participants_of(written):
        own = typed[item.name.text]
        formulas = sorted(item.formulas, key=lambda formula: formula.name.text != "process")
        part = parts.get(item.name.text)
        if part is not None:
            found += _unknown_senders(item, part)
        parameters = part.formulas.parameters if part is not None else {}
        most: int | None = 1
        least = 1
        if item.multiplicity is not None:
            least, most = item.multiplicity.least, item.multiplicity.most
        participants.append(
            Participant(
                item.name.text,
                least,
                most,
                tuple(text.text for text in item.engage),
                own.variables,
                own.sends,
                own.receives,
                tuple(
                    NamedFormula(f.name.text, f.formula, f.span, parameters.get(f.name.text, ()))
                    for f in formulas
                ),
                item.name.span,
                own.inputs,
                own.results,
                part.plays if part is not None else (),
            )
        )
    return Aip(written.name.text, tuple(participants), outcomes, clauses, written.name.span), tuple(found)


def _unknown_senders(written: tree.Participant, part: Part) -> Iterator[Diagnostic]:
    """E565 for a name behind `by` that is not an activity of the participant."""
    activities = part.activities
    for name in (name for item in written.sends for name in item.by):
        if name.text not in activities:
            yield unknown(NoActivityToSend, name, activities, part.participant)


def suc_to_aip(cases: UseCases, written: Sequence[tree.Aip]) -> tuple[Missing, ...]:
    """A note for every protocol that follows from the use cases and is not written yet (N701)."""
    known = {folded(item.name.text) for item in written}
    found = []
    for case in cases.suc.usecases:
        if cases.is_protocol(case) and known.isdisjoint(cases.names_of(case)):
            skeleton = aip_skeleton(cases, case)
            parties = cases.parties(case)
            note = Diagnostic(
                ProtocolNotWritten(case.name, tuple(parties), skeleton),
                case.span,
                tuple(
                    Related(role.span, f"`{role.name}`") for role in cases.suc.roles if role.name in parties
                ),
            )
            found.append(Missing(note, skeleton))
    return tuple(found)


def aip_skeleton(cases: UseCases, case: UseCase) -> str:
    """An `aip` to start from. A participant does what the use case includes and is not others' alone."""
    lines = [f"aip {case.name} {{"]
    for name in cases.parties(case):
        lines += (f"  {line}" for line in participant_skeleton(cases, case, name))
    lines += ['  outcome "What is reached?"', "}"]
    return "\n".join(lines)


def participant_skeleton(cases: UseCases, case: UseCase, name: str) -> list[str]:
    """The lines of a participant to start from."""
    own = [cases.case(item) for item in case.includes]
    own = [item for item in own if not item.participants or name in item.participants]
    terms = [participant_term(cases, item) for item in own] or [activity_name(case.name)]
    formulas = [formula_line("process", terms)]
    formulas += helper_formulas(cases, own, lambda item: participant_term(cases, item))
    return [
        f"participant {name} {{",
        '  engage  "When does it take part?"',
        *(f"  {line}" for line in formulas),
        "}",
    ]


def participant_term(cases: UseCases, case: UseCase) -> str:
    """How a process uses a use case. A participant plays no other protocol: there it is an activity."""
    return activity_name(case.name) if cases.is_protocol(case) else cases.spelling(case)


__all__ = ["aip_skeleton", "participant_skeleton", "participant_term", "read_aip", "suc_to_aip"]
