"""Places: which transition of which term each control line means, found in the text of the formulas."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from typing import assert_never

from aseme_dsl.amola.liveness import Formula, canonical, rewritten, term_key, ungrouped, walk
from aseme_dsl.amola.operators import Operator, Template
from aseme_dsl.proofs.certificate.claim import LabelLine, Line, Process
from aseme_dsl.records import dataclass

Edge = tuple[str, Formula]
"""A verb and the term (without parentheses) that it concerns."""

FIRST = -1
"""The position of a line with `ignores`: before the other lines."""


@dataclass(frozen=True, slots=True)
class Placed:
    """A line with its position among all lines of its owner."""

    position: int
    line: Line | LabelLine


@dataclass(frozen=True, slots=True)
class Places:
    """The lines of one process by edge, those by label, and those for the abandoned participant.

    `separate` are the choices `B | C` of `A [> (B | C)` whose branches interrupt A each by itself.
    """

    by_edge: Mapping[Edge, tuple[Placed, ...]]
    labelled: tuple[Placed, ...]
    abandon: tuple[Line, ...]
    separate: frozenset[Formula]
    reactive: frozenset[Formula]
    """The operators whose choices are reactive."""


class Unplaced(Exception):
    """A line that the certificate cannot place."""

    def __init__(self, line: Line) -> None:
        super().__init__(line.span.text)
        self.line = line


def interrupting(term: Formula, separate: frozenset[Formula]) -> tuple[Formula, ...]:
    """What interrupts the first operand of a `[>`."""
    second = ungrouped(term.operands[1])
    return second.operands if second in separate else term.operands[1:]


def places_of(process: Process) -> Places:
    """Where the lines of a process belong."""
    separate = frozenset(
        choice
        for name, formula in process.formulas.items()
        for choice in _separate(formula, [line for line in process.lines if line.formula == name])
    )
    texts = {name: _Text(formula, separate) for name, formula in process.formulas.items()}
    by_edge: dict[Edge, list[Placed]] = {}
    labelled: list[Placed] = []
    abandon: list[Line] = []
    for position, line in enumerate(process.lines):
        if isinstance(line, LabelLine):
            labelled.append(Placed(position, line))
            continue
        edge = _edge_of(line, texts, process)
        if edge is None:
            if not _is_abandon(line, process):
                raise Unplaced(line)
            abandon.append(line)
            continue
        by_edge.setdefault(edge, []).append(Placed(FIRST if line.ignores else position, line))
    reactive = frozenset(term for name in process.reactive for term in texts[name].parents)
    found = {edge: tuple(lines) for edge, lines in by_edge.items()}
    return Places(found, tuple(labelled), tuple(abandon), separate, reactive)


def _is_abandon(line: Line, process: Process) -> bool:
    return bool(process.participant) and line.verb == "on" and line.term.name == "abandon"


def _separate(formula: Formula, lines: Sequence[Line | LabelLine]) -> list[Formula]:
    """The choices behind `[>` of which some branch has a line of its own, and the whole has none."""
    own = [line for line in lines if isinstance(line, Line)]
    if not own or len(own) < len(lines):
        return []
    named = {term_key(line.term) for line in own}
    entered = {term_key(line.term) for line in own if line.verb in ("enter", "resume")}
    found = []
    for node in walk(formula):
        if node.operator.row.template is not Template.CUT:
            continue
        second = ungrouped(node.operands[1])
        if second.operator.row.template is Template.BRANCHES and term_key(second) not in named:
            branches = [ungrouped(branch) for branch in second.operands]
            if entered & ({term_key(branch) for branch in branches} | {item.name for item in branches}):
                found.append(second)
    return found


class _Text:
    """The terms of a formula's text: what stands around each, and where each spelling occurs."""

    def __init__(self, formula: Formula, separate: frozenset[Formula]) -> None:
        self.whole = ungrouped(formula)
        self.parents: dict[Formula, Formula | None] = {}
        waiting: list[tuple[Formula, Formula | None]] = [(self.whole, None)]
        while waiting:
            term, around = waiting.pop()
            self.parents[term] = around
            inside = term.operands
            if term.operator.row.template is Template.CUT:
                inside = (inside[0], *interrupting(term, separate))
            waiting += [(ungrouped(operand), term) for operand in reversed(inside)]

    @cached_property
    def spelt(self) -> dict[str, list[Formula]]:
        """The terms by their spelling, in the order of the text."""
        found: dict[str, list[Formula]] = {}
        for term in self.parents:
            found.setdefault(canonical(term), []).append(term)
        return found

    @cached_property
    def bare(self) -> dict[str, list[Formula]]:
        """The terms with arguments by their spelling without them."""
        found: dict[str, list[Formula]] = {}
        for spelling, terms in self.spelt.items():
            for term in terms if "(" in spelling else ():
                if (short := canonical(_bare(term))) != spelling:
                    found.setdefault(short, []).append(term)
        return found

    def find(self, key: str, occurrence: int | None) -> Formula | None:
        """The term of a spelling: the only one, or that of the number."""
        found = self.spelt.get(key) or self.bare.get(key) or []
        if occurrence is None:
            return found[0] if len(found) == 1 else None
        return found[occurrence - 1] if 0 < occurrence <= len(found) else None

    def has(self, key: str) -> bool:
        return key in self.spelt or key in self.bare


def _bare(term: Formula) -> Formula:
    return rewritten(term, lambda node: replace(node, arguments=()) if node.arguments else node)


def _edge_of(line: Line, texts: Mapping[str, _Text], process: Process) -> Edge | None:
    """The edge that a line means: of its own formula's text, or of the only other one that has the term."""
    key = term_key(line.term)
    text = texts[line.formula]
    names = (line.formula, process.title if line.formula == process.root else line.formula)
    if not text.has(key):
        if key in names and line.verb in ("start", "finish"):
            return _edge(line.verb, text.whole, text.parents)
        others = [other for name, other in texts.items() if name != line.formula and other.has(key)]
        if len(others) != 1:
            return None
        text = others[0]
    term = text.find(key, line.occurrence)
    return None if term is None else _edge(line.verb, term, text.parents)


def _edge(verb: str, term: Formula, parents: Mapping[Formula, Formula | None]) -> Edge | None:
    """The edge that a verb means for a term."""
    around = parents[term]
    row = None if around is None else around.operator.row
    match verb:
        case "enter":
            return _entry(term, parents)
        case "resume":
            again = row is not None and row.template is Template.BODY and row.repeats
            return ("repeat", term) if again else _entry(term, parents)
        case "start" | "finish" | "leave" | "repeat" | "skip" | "on" | "exit":
            return verb, term
    return None


def _entry(term: Formula, parents: Mapping[Formula, Formula | None]) -> Edge | None:
    """The entry of a term: of the body of a loop it is that of the loop."""
    around = parents[term]
    while around is not None:
        row = around.operator.row
        if row.template is not Template.BODY or row.skips:
            return "enter", term
        term, around = around, parents[around]
    if term.operator is Operator.NAME:
        return "enter", term
    template = term.operator.row.template
    match template:
        case Template.BODY:
            return "start", term
        case Template.CHAIN | Template.BRANCHES | Template.CUT | Template.REGIONS:
            return None
        case Template.ACTIVITY | Template.INSIDE | Template.UNDECIDED:
            return None
        case _:
            assert_never(template)


__all__ = ["Edge", "Placed", "Places", "Unplaced", "interrupting", "places_of"]
