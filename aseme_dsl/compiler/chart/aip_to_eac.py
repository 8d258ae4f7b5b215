"""AIP to EAC: the processes of a protocol's participants as one statechart (P1, section 4.3 and Figure 5)."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace

from aseme_dsl.amola.aip import Plays
from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.compiler.chart.chart import Part, Protocol, RelativeLine, World, chart_of
from aseme_dsl.compiler.chart.playing import Woven, not_used, read_plays, unused_plays, weave, with_inside
from aseme_dsl.compiler.control.choices import check_formulas, undecided_formulas, unsettled
from aseme_dsl.compiler.control.control import (
    LabelledLine,
    Lines,
    check_labels,
    including_labels,
)
from aseme_dsl.compiler.formula import formulas as formula_tables
from aseme_dsl.compiler.formula.formula_to_statechart import (
    expand_protocol,
)
from aseme_dsl.compiler.read.blocks import participants_of
from aseme_dsl.compiler.read.damage import Damaged
from aseme_dsl.compiler.read.missing import Missing
from aseme_dsl.compiler.types.scopes import TypedParticipant
from aseme_dsl.diagnostics import Diagnostic, Related, closest, surely
from aseme_dsl.diagnostics.problems.absences import NoFormulaOfProtocol
from aseme_dsl.diagnostics.problems.control import ControlOfProtocol
from aseme_dsl.diagnostics.problems.formulas import ParticipantWithoutProcess
from aseme_dsl.diagnostics.problems.missing import ProtocolEmpty
from aseme_dsl.diagnostics.problems.names import FormulaAmbiguous
from aseme_dsl.grammar.text import tree
from aseme_dsl.records import dataclass

PROCESS = "process"
"""The name of a participant's own formula."""


@dataclass(frozen=True, slots=True)
class _Reading:
    """A participant on the way: its formulas with their control blocks and lines, and what it plays."""

    written: tree.Participant
    woven: Woven
    controls: Sequence[tuple[tree.Control, str]]
    plays: tuple[Plays, ...]
    inside: Mapping[tuple[str, str], Part]

    @property
    def name(self) -> str:
        return self.written.name.text


def read_protocol(
    written: tree.Aip,
    typed: Mapping[str, TypedParticipant],
    protocols: Mapping[str, Protocol],
    largest: int,
    is_damaged: Damaged,
) -> tuple[Protocol, tuple[Diagnostic, ...]]:
    """The formulas and control lines of every participant, with all that is wrong with them.

    `protocols` are those whose participants play a part in this one. `is_damaged` tells whether syntax errors
    left something out of a declaration.
    """
    controls, problems = _controls(written, is_damaged)
    found = list(problems)
    readings: list[_Reading] = []
    parts: dict[str, Part] = {}
    participants = participants_of(written)
    for participant in participants:
        name = participant.name.text
        own = [(control, formula) for control, part, formula in controls if part == name]
        reading, is_sound, problems = _participant(
            written, participant, own, typed[name], protocols, largest, is_damaged
        )
        found += problems
        if reading is None:
            continue
        readings.append(reading)
        if is_sound:
            lines = Lines(
                reading.woven.lines.by_way,
                reactive=reading.woven.lines.reactive,
                abandon=reading.woven.lines.abandon,
            )
            parts[name] = Part(
                written.name.text,
                name,
                reading.woven.formulas,
                typed[name].variables,
                lines,
                (),
                participant.name.span,
                _regions(participant),
                typed[name].inputs,
                typed[name].results,
                reading.plays,
                reading.woven.branches,
                reading.inside,
            )
    outline = None
    labelled: dict[str, tuple[LabelledLine, ...]] = {}
    if parts and len(parts) == len(participants):
        ends = [(name, part.branch(), part.span) for name, part in parts.items() for _ in range(part.count)]
        outline = expand_protocol(written.name.text, ends, written.name.span)
        labels: dict[str, str] = {}
        for label, branch in outline.branches.items():
            if branch.protocol == written.name.text:
                labels.setdefault(branch.participant, label)
        for reading in readings:
            label = labels[reading.name]
            labelled[reading.name], problems = check_labels(outline, reading.woven.lines.labelled, label)
            found += problems
            relative = _relative(labelled[reading.name], label)
            parts[reading.name] = replace(parts[reading.name], labelled=relative)
    missing: list[Missing] = []
    if not participants and not is_damaged(written.span):
        missing.append(_no_participants(written))
    for reading in readings:
        lines = reading.woven.lines
        if outline is not None:
            lines = including_labels(lines, outline, labelled[reading.name])
        unsure = {formula for control, formula in reading.controls if is_damaged(control.span)}
        if is_damaged(reading.written.span):
            unsure |= set(reading.woven.formulas.named)
        names = {name: reading.name if name == PROCESS else name for name in reading.woven.formulas.named}
        found += check_formulas(reading.woven.formulas, names, lines, frozenset(unsure))
        wrong = frozenset(unsure | unsettled(reading.woven.formulas, found))
        missing += undecided_formulas(reading.woven.formulas, names, lines, written.span, wrong)
        if not is_damaged(reading.written.span):
            owner = f"{written.name}.{reading.name}"
            for item in unused_plays(reading.woven.formulas, reading.plays):
                missing.append(not_used(owner, reading.woven.formulas, item, reading.written.span))
    return Protocol(written, parts, outline, tuple(missing)), tuple(found)


def _participant(
    written: tree.Aip,
    participant: tree.Participant,
    controls: Sequence[tuple[tree.Control, str]],
    typed: TypedParticipant,
    protocols: Mapping[str, Protocol],
    largest: int,
    is_damaged: Damaged,
) -> tuple[_Reading | None, bool, tuple[Diagnostic, ...]]:
    """What a participant says of itself, and whether its process can be expanded."""
    owner = f"{written.name}.{participant.name}"
    formulas, problems = formula_tables.table(owner, participant.formulas, PROCESS)
    found = list(problems)
    damaged = is_damaged(participant.span)
    plays, parts, problems = read_plays(participant, formulas, protocols, typed.scope, is_damaged)
    found += problems
    if formulas is None:
        if not damaged:
            found.append(_no_process(written, participant))
        return None, False, tuple(found)
    woven, problems = weave(
        participant,
        formulas,
        plays,
        parts,
        controls,
        typed.scope,
        largest,
        damaged,
        _regions(participant),
    )
    reading = _Reading(participant, woven, controls, plays, parts)
    return reading, woven.expandable, (*found, *problems)


def _regions(participant: tree.Participant) -> int:
    """`[2]` is two agents in each conversation: two regions. How many `[1..2]` are, a run decides: one."""
    many = participant.multiplicity
    return many.least if many is not None and many.least == many.most else 1


def _relative(labelled: Iterable[LabelledLine], label: str) -> tuple[RelativeLine, ...]:
    return tuple(
        RelativeLine(item.source.text[len(label) :], item.target.text[len(label) :], item.line)
        for item in labelled
    )


def aip_to_eac(protocol: Protocol, world: World) -> Statechart | None:
    """The EAC of a protocol; None where a process could not be expanded."""
    if protocol.outline is None:
        return None
    parts = with_inside({(protocol.name, name): part for name, part in protocol.parts.items()})
    return chart_of(protocol.name, "EAC", protocol.outline, parts, world, protocol.written.name.span)


def _no_participants(written: tree.Aip) -> Missing:
    note = Diagnostic(ProtocolEmpty(written.name.text), written.name.span)
    return Missing(note, "// Who takes part? participant … { process = … }", written.span)


def _no_process(written: tree.Aip, participant: tree.Participant) -> Diagnostic:
    problem = ParticipantWithoutProcess(participant.name.text, written.name.text, is_misspelt=False)
    near = closest(PROCESS, [item.name.text for item in participant.formulas])
    if near is not None:
        slip = next(item.name.span for item in participant.formulas if item.name.text == near)
        related = (Related(participant.name.span, "the participant"),)
        return Diagnostic(problem.but(is_misspelt=True), slip, related, fix=PROCESS)
    return Diagnostic(problem, participant.name.span)


def _controls(
    written: tree.Aip, is_damaged: Damaged
) -> tuple[list[tuple[tree.Control, str, str]], tuple[Diagnostic, ...]]:
    """Each control block with the participant and the formula that it is about.

    `control center` is about the process of the participant `center`; helper formulas have their own names.
    """
    known: dict[str, list[tuple[str, str]]] = {}
    for participant in participants_of(written):
        name = participant.name.text
        for item in participant.formulas:
            known.setdefault(name if item.name.text == PROCESS else item.name.text, [])
        known.setdefault(name, [])
    for participant in participants_of(written):
        name = participant.name.text
        for formula in dict.fromkeys(item.name.text for item in participant.formulas):
            known[name if formula == PROCESS else formula].append((name, formula))
    found: list[tuple[tree.Control, str, str]] = []
    problems: list[Diagnostic] = []
    for control in written.controls:
        places = known.get(control.name.text)
        if places is None:
            if not is_damaged(written.span):
                problems.append(_unknown_control(written, control, known))
        elif len(places) > 1:
            problems.append(_ambiguous_control(written, control, places))
        else:
            found += [(control, *place) for place in places]
    return found, tuple(problems)


def _unknown_control(written: tree.Aip, control: tree.Control, known: Iterable[str]) -> Diagnostic:
    name = control.name.text
    for play in (item for participant in written.participants for item in participant.plays):
        if name in ((play.alias or play.participant).text, play.participant.text):
            related = (Related(play.span, "it is played here"),)
            foreign = ControlOfProtocol(play.protocol.text, play.participant.text, name)
            return Diagnostic(foreign, control.name.span, related)
    participants = tuple(item.name.text for item in written.participants)
    is_process = name == PROCESS
    close = None if is_process else closest(name, known)
    problem = NoFormulaOfProtocol(name, close, participants, written.name.text, is_process)
    return Diagnostic(problem, control.name.span, fix=None if is_process else surely(name, known))


def _ambiguous_control(
    written: tree.Aip, control: tree.Control, places: Sequence[tuple[str, str]]
) -> Diagnostic:
    related = []
    for participant in written.participants:
        for item in participant.formulas:
            if (participant.name.text, item.name.text) in places:
                related.append(Related(item.name.span, f"of `{participant.name}`"))
    problem = FormulaAmbiguous(control.name.text, written.name.text)
    return Diagnostic(problem, control.name.span, tuple(related))


__all__ = ["PROCESS", "aip_to_eac", "read_protocol"]
