"""Certified: what the sources of a system say, from the phases, and the certificates of its statecharts."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from aseme_dsl.amola.aip import DeclaredVariable, Plays
from aseme_dsl.amola.liveness import Formula
from aseme_dsl.amola.statechart import Argument
from aseme_dsl.compiler.chart.chart import Protocol
from aseme_dsl.compiler.chart.srm_to_iac import Role
from aseme_dsl.compiler.control.control import LabelledLine, Line
from aseme_dsl.compiler.formula.formulas import Formulas
from aseme_dsl.compiler.phases import Inspection
from aseme_dsl.grammar.text import tree
from aseme_dsl.proofs.certificate import claim
from aseme_dsl.proofs.certificate.certify import Certificate, certify

if TYPE_CHECKING:
    from aseme_dsl.amola.expression import TransitionExpression
    from aseme_dsl.amola.system import System
    from aseme_dsl.source import Span

_Controls = Sequence[tuple[tree.Control, str]]


def certificates_of(inspection: Inspection) -> tuple[Certificate, ...]:
    """The certificates of a system without errors.

    Raises:
        NotCertified: a statechart is not what its source says.
    """
    system = inspection.analysis.system
    return () if system is None else certify(system, claims_of(inspection, system))


def claims_of(inspection: Inspection, system: System) -> claim.Claims:
    """What the sources of a system say of its statecharts."""
    processes = _Processes(inspection.protocols, system)
    roles = {
        name: processes.of_role(role)
        for name, role in inspection.roles.items()
        if system.iac(name) is not None and role.formulas is not None
    }
    regions = {name: tuple(processes.regions(item)) for name, item in inspection.protocols.items()}
    waiting = frozenset(item.name for item in system.activities if item.waits)
    return claim.Claims(roles, regions, waiting)


class _Processes:
    """The processes of roles and participants, each once."""

    def __init__(self, protocols: Mapping[str, Protocol], system: System) -> None:
        self._protocols = protocols
        self._system = system
        self._parts: dict[tuple[str, str], claim.Process] = {}

    def of_role(self, role: Role) -> claim.Process:
        """What a role says of itself, with what it includes."""
        assert role.formulas is not None
        typed = _typed(role.lines.by_way.values(), role.lines.labelled, ())
        own = [(item, item.name.text) for item in role.written.controls]
        srm = next(item for item in self._system.srms if item.name == role.name)
        return claim.Process(
            role.name,
            "",
            "",
            role.formulas.root,
            role.formulas.root,
            *_formulas(role.formulas),
            tuple(_lines(own, typed)),
            _reactive(own),
            self._plays(role.formulas, role.plays),
            srm.variables,
        )

    def regions(self, protocol: Protocol) -> Iterator[claim.Region]:
        """The regions of a protocol's own chart: one for each agent of a fixed number."""
        for written in protocol.written.participants:
            process = self.of_part(protocol.name, written.name.text)
            for _ in range(_count(written)):
                yield claim.Region(written.name.text, process, written.name.span)

    def of_part(self, protocol: str, participant: str) -> claim.Process:
        """What a protocol says of a participant."""
        key = protocol, participant
        if key not in self._parts:
            self._parts[key] = self._read_part(self._protocols[protocol], participant)
        return self._parts[key]

    def _read_part(self, protocol: Protocol, name: str) -> claim.Process:
        part = protocol.parts[name]
        labelled = [item.line for item in part.labelled]
        typed = _typed(part.lines.by_way.values(), (), (*labelled, *part.lines.abandon))
        own = _controls_of(protocol.written, name, part.formulas)
        aip = next(item for item in self._system.aips if item.name == protocol.name)
        model = aip.participant(name)
        assert model is not None
        variables: tuple[DeclaredVariable, ...] = part.variables
        return claim.Process(
            f"{protocol.name}.{name}",
            protocol.name,
            name,
            part.formulas.root,
            name,
            *_formulas(part.formulas),
            tuple(_lines(own, typed, _label(protocol.written, name))),
            _reactive(own),
            self._plays(part.formulas, part.plays),
            variables,
            model.inputs,
        )

    def _plays(self, formulas: Formulas, plays: Sequence[Plays]) -> dict[str, claim.Play]:
        """What formulas may name: participants by their names here, or by their own where that is clear."""
        made = {item.name: self._play(item) for item in plays}
        for item in plays:
            alone = sum(other.participant == item.participant for other in plays) == 1
            if alone and item.participant not in made and item.participant not in formulas.named:
                made[item.participant] = made[item.name]
        return made

    def _play(self, item: Plays) -> claim.Play:
        process = self.of_part(item.protocol, item.participant)
        return claim.Play(process, dict(item.bindings), dict(item.inputs), dict(item.results), item.span)


def _formulas(
    found: Formulas,
) -> tuple[
    dict[str, Formula],
    dict[str, tuple[str, ...]],
    Mapping[Formula, tuple[Argument, ...]],
]:
    """The formulas by name, their parameters, and the arguments of the names in them."""
    named = {name: item.formula for name, item in found.named.items()}
    parameters = {name: tuple(one.name for one in items) for name, items in found.parameters.items()}
    return named, parameters, found.given


def _typed(
    ways: Iterable[Sequence[Line]], labelled: Iterable[LabelledLine], others: Iterable[Line]
) -> dict[Span, TransitionExpression]:
    """The expressions by the places of their lines. Where a line belongs is not taken from the compiler."""
    found = {line.span: line.expression for lines in ways for line in lines}
    found |= {item.line.span: item.line.expression for item in labelled}
    return found | {line.span: line.expression for line in others}


def _lines(
    controls: _Controls, typed: Mapping[Span, TransitionExpression], label: str = ""
) -> Iterator[claim.Line | claim.LabelLine]:
    """The lines in the order in which they are written; `label` is that of the participant's subchart."""
    for control, formula in controls:
        for entry in control.entries:
            expression = typed.get(entry.span)
            if expression is None:
                continue  # it is refused, with a diagnostic
            if isinstance(entry, tree.LabelledWay):
                source, target = (name.text[len(label) :] for name in (entry.source, *entry.targets))
                yield claim.LabelLine(formula, source, target, expression, entry.span)
            else:
                term = entry.term
                ignores = entry.expression.ignores is not None
                yield claim.Line(
                    formula,
                    entry.verb.text,
                    term.formula,
                    term.occurrence,
                    expression,
                    entry.span,
                    ignores,
                )


def _reactive(controls: _Controls) -> frozenset[str]:
    return frozenset(formula for control, formula in controls if control.reactive is not None)


def _controls_of(written: tree.Aip, participant: str, formulas: Formulas) -> _Controls:
    """The control of a participant: of its process by its name, of its other formulas by theirs."""
    names = {name if name != formulas.root else participant: name for name in formulas.named}
    others = {item.name.text for item in written.participants} - {participant}
    return [
        (control, names[control.name.text])
        for control in written.controls
        if control.name.text in names and control.name.text not in others
    ]


def _count(written: tree.Participant) -> int:
    """How many regions a participant has in its protocol's own chart."""
    many = written.multiplicity
    return many.least if many is not None and many.least == many.most else 1


def _label(written: tree.Aip, participant: str) -> str:
    """The label of a participant's subchart in the protocol's own chart."""
    before = 0
    for item in written.participants:
        if item.name.text == participant:
            break
        before += _count(item)
    return f"0.2.{before + 1}.2"


__all__ = ["certificates_of", "claims_of"]
