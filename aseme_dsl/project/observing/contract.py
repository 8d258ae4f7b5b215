"""Contract: what each participant of a protocol may say, in which order, and how it may leave early."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from aseme_dsl.amola.aip import Aip, Participant, answers_when_busy
from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.amola.system import System
from aseme_dsl.codegen.automaton import Automaton, Letter, TooManyStates, automaton_of
from aseme_dsl.codegen.moves import farewells_of, subchart_of
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.conversation.losses import FAREWELLS
from aseme_dsl.source import Span

ENDING = ("cancel", "failure")
"""What any agent may say that cannot do its part to the end."""
Kind = tuple[str, str]
"""A performative, and the type of the content."""


@dataclass(frozen=True, slots=True)
class Part:
    """A participant: its automaton, and how many agents are asked at once at the most."""

    name: str
    automaton: Automaton
    most: int | None
    receives: frozenset[Kind]
    farewells: Mapping[str, frozenset[Kind]]
    """By participant: what it may be sent by this one at any time, if that leaves its part early."""
    chosen: Mapping[str, frozenset[Kind]]
    """The same for agents of asemec: what the runtime sends for them then."""
    busy: frozenset[Kind]
    """What may answer an invitation while all instances are in use."""
    span: Span


@dataclass(frozen=True, slots=True)
class Contract:
    """A protocol, by participants. `fields` are those of the messages, by type."""

    name: str
    parts: Mapping[str, Part]
    fields: Mapping[str, frozenset[str]]
    span: Span
    kinds: Mapping[str, tuple[Kind, ...]]
    """What its participants send and receive, by performative."""

    def kinds_of(self, performative: str, content: object) -> tuple[Kind, ...]:
        """What a message without a type may be: by its performative, and by its fields."""
        found = self.kinds.get(performative, ())
        if len(found) > 1 and isinstance(content, dict):
            fitting = (kind for kind in found if content.keys() <= self.fields.get(kind[1], frozenset()))
            found = tuple(fitting) or found
        return found

    def said_by(self, kind: Kind) -> tuple[str, ...]:
        """The participants that ever send a message."""
        return tuple(
            name
            for name, part in self.parts.items()
            if any(letter[0] != "?" and letter[1:3] == kind for letter in _letters(part.automaton))
            or kind in part.busy
            or any(kind in items for items in (*part.farewells.values(), *part.chosen.values()))
        )


def _letters(automaton: Automaton) -> Iterable[Letter]:
    return (letter for ways in automaton.ways for letter, _ in ways)


def contracts_of(system: System) -> Mapping[str, Contract | None]:
    """The contracts of protocols, by name; None for one whose automaton is too large to be made."""
    plays = [item for srm in system.srms for item in srm.plays]
    plays += [item for aip in system.aips for part in aip.participants for item in part.plays]
    busy = answers_when_busy(plays)
    fields = {item.name: frozenset(field.name for field in item.fields) for item in system.messages}
    found: dict[str, Contract | None] = {}
    for aip in system.aips:
        eac = system.eac(aip.name)
        if eac is None:
            continue
        try:
            parts = {part.name: _part(aip, eac, part, busy) for part in aip.participants}
        except TooManyStates:
            found[aip.name] = None
        else:
            found[aip.name] = Contract(aip.name, parts, fields, aip.span, _kinds(parts))
    return found


def _kinds(parts: Mapping[str, Part]) -> Mapping[str, tuple[Kind, ...]]:
    found: dict[str, dict[Kind, None]] = {}
    for part in parts.values():
        for letter in _letters(part.automaton):
            found.setdefault(letter[1], {})[letter[1:3]] = None
    return {performative: tuple(kinds) for performative, kinds in found.items()}


def _part(
    aip: Aip, eac: Statechart, part: Participant, busy: Mapping[tuple[str, str], frozenset[Kind]]
) -> Part:
    receives = frozenset((item.performative, item.message) for item in part.receives)
    answers = busy.get((aip.name, part.name), frozenset())
    return Part(
        part.name,
        automaton_of(eac, part),
        part.most,
        receives,
        {other.name: _farewells(eac, part, other) for other in aip.participants},
        {other.name: frozenset(_chosen(part, other)) for other in aip.participants},
        frozenset(kind for kind in answers if kind[0]),
        part.span,
    )


def _farewells(eac: Statechart, part: Participant, other: Participant) -> frozenset[Kind]:
    """What a part says to another one when it ends early: by its lines, or that it has failed."""
    subchart = subchart_of(eac, part.name)
    said = farewells_of(eac, subchart.label) if subchart is not None else ()
    own = {(item.performative, item.message) for item in said if item.participant in ("", other.name)}
    return frozenset((*own, *(kind for kind in _chosen(part, other) if kind[0] in ENDING)))


def _chosen(part: Participant, other: Participant) -> list[Kind]:
    """What the runtime says for a part that ends early: the first of its farewells that the protocol has."""
    received = {(item.performative, item.message) for item in other.receives}
    sent = [(item.performative, item.message) for item in part.sends]
    return [kind for act in FAREWELLS for kind in sent if kind[0] == act and kind in received][:1]


__all__ = ["Contract", "Kind", "Part", "contracts_of"]
