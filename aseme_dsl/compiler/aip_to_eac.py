"""AIP to EAC: the processes of a protocol's participants as one statechart (P1, section 4.3 and Figure 5)."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.compiler import formulas as formula_tables
from aseme_dsl.compiler.blocks import participants_of
from aseme_dsl.compiler.chart import Part, RelativeLine, World, chart_of
from aseme_dsl.compiler.choices import check_formulas, undecided_formulas
from aseme_dsl.compiler.control import (
    LabelledLine,
    Lines,
    check_labels,
    including_labels,
    read_lines,
)
from aseme_dsl.compiler.damage import Damaged
from aseme_dsl.compiler.formula_to_statechart import Outline, expand_protocol, too_large
from aseme_dsl.compiler.missing import Missing
from aseme_dsl.compiler.scopes import TypedParticipant
from aseme_dsl.diagnostics import Diagnostic, Related, closest
from aseme_dsl.grammar import tree
from aseme_dsl.source import Span

PROCESS = "process"
"""The name of a participant's own formula."""


@dataclass(frozen=True, slots=True)
class Protocol:
    """An `aip` whose processes have been read: the parts by name, and their chart.

    A participant whose process cannot be expanded is not in `parts`; `outline` is None if any is not.
    `missing` is what its control does not say yet.
    """

    written: tree.Aip
    parts: Mapping[str, Part]
    outline: Outline | None
    missing: tuple[Missing, ...]

    @property
    def name(self) -> str:
        return self.written.name.text


def read_protocol(
    written: tree.Aip, typed: Mapping[str, TypedParticipant], largest: int, is_damaged: Damaged
) -> tuple[Protocol, tuple[Diagnostic, ...]]:
    """The formulas and control lines of every participant, with all that is wrong with them.

    `is_damaged` tells whether syntax errors left something out of a declaration.
    """
    found: list[Diagnostic] = []
    missing: list[Missing] = []
    controls, problems = _controls(written, is_damaged)
    found += problems
    parts: dict[str, Part] = {}
    lines_of: dict[str, Lines] = {}
    participants = participants_of(written)
    for participant in participants:
        name = participant.name.text
        formulas, problems = formula_tables.table(f"{written.name}.{name}", participant.formulas, PROCESS)
        found += problems
        if formulas is None:
            if not is_damaged(participant.span):
                found.append(_no_process(written, participant))
            continue
        expandable, problems = formula_tables.check(formulas)
        found += _kept(problems, is_damaged, participant.span)
        own = [(control, formula) for control, part, formula in controls if part == name]
        lines_of[name], problems = read_lines(formulas, own, typed[name].scope)
        found += problems
        too_many = too_large(formulas, {}, largest, participant.name.span) if expandable else None
        if too_many is not None:
            found.append(too_many)
        part = Part(
            written.name.text,
            name,
            formulas,
            typed[name].variables,
            Lines(lines_of[name].by_way),
            (),
            participant.name.span,
        )
        if expandable and too_many is None:
            parts[name] = part
    outline = None
    labelled: dict[str, tuple[LabelledLine, ...]] = {}
    if len(parts) == len(participants) and parts:
        ends = [(name, part.branch(), part.span) for name, part in parts.items()]
        outline = expand_protocol(written.name.text, ends, written.name.span)
        for label, branch in outline.branches.items():
            name = branch.participant
            labelled[name], problems = check_labels(outline, lines_of[name].labelled, label)
            found += problems
            relative = tuple(
                RelativeLine(item.source.text[len(label) :], item.target.text[len(label) :], item.line)
                for item in labelled[name]
            )
            parts[name] = replace(parts[name], labelled=relative)
    if not participants and not is_damaged(written.span):
        missing.append(_no_participants(written))
    for participant in participants:
        name = participant.name.text
        lines = lines_of.get(name)
        formulas, _ = formula_tables.table(f"{written.name}.{name}", participant.formulas, PROCESS)
        if lines is None or formulas is None:
            continue
        if outline is not None:
            lines = including_labels(lines, outline, labelled[name])
        unsure = {formula for control, part, formula in controls if part == name and is_damaged(control.span)}
        if is_damaged(participant.span):
            unsure |= set(formulas.named)
        names = {formula: name if formula == PROCESS else formula for formula in formulas.named}
        found += check_formulas(formulas, names, lines, frozenset(unsure))
        missing += undecided_formulas(formulas, names, lines, written.span, frozenset(unsure))
    return Protocol(written, parts, outline, tuple(missing)), tuple(found)


def aip_to_eac(protocol: Protocol, world: World) -> Statechart | None:
    """The EAC of a protocol; None where a process could not be expanded."""
    if protocol.outline is None:
        return None
    parts = {(protocol.name, name): part for name, part in protocol.parts.items()}
    return chart_of(protocol.name, "EAC", protocol.outline, parts, world, protocol.written.name.span)


def _no_participants(written: tree.Aip) -> Missing:
    hint = "say who takes part: `participant center { process = … }`"
    note = Diagnostic(
        "N701", f"the protocol {written.name} has no participants yet", written.name.span, hint=hint
    )
    return Missing(note, "// Who takes part? participant … { process = … }", written.span)


def _no_process(written: tree.Aip, participant: tree.Participant) -> Diagnostic:
    return Diagnostic(
        "E305",
        f"`{participant.name}` of {written.name} has no process",
        participant.name.span,
        hint="say what it does: `process = WalkTowardsBall . [PassBall]`",
    )


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
    near = closest(name, known)
    if name == PROCESS:
        hint = "the process of a participant is controlled by the participant's name"
    elif near is not None:
        hint = f"did you mean `{near}`?"
    else:
        hint = "its participants are " + ", ".join(str(p.name) for p in written.participants)
    message = f"{written.name} has no participant and no formula called `{name}`"
    return Diagnostic("E403", message, control.name.span, hint=hint, fix=near if name != PROCESS else None)


def _ambiguous_control(
    written: tree.Aip, control: tree.Control, places: Sequence[tuple[str, str]]
) -> Diagnostic:
    related = []
    for participant in written.participants:
        for item in participant.formulas:
            if (participant.name.text, item.name.text) in places:
                related.append(Related(item.name.span, f"of `{participant.name}`"))
    return Diagnostic(
        "E213",
        f"`{control.name}` means several formulas of {written.name}",
        control.name.span,
        tuple(related),
        hint="give the helper formulas names of their own",
    )


def _kept(problems: Iterable[Diagnostic], is_damaged: Damaged, span: Span) -> Iterable[Diagnostic]:
    """Without E302 where a formula that could not be read may be the one that uses it."""
    damaged = is_damaged(span)
    return [item for item in problems if not (damaged and item.code == "E302")]
