"""Hints: what an editor shows within the text and above it: labels, types, what can be done with a block."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import field

from aseme_dsl.amola.liveness import names
from aseme_dsl.amola.statechart import StateType
from aseme_dsl.editor.answers.hover import type_of
from aseme_dsl.editor.files.index import Kind, Symbol, name_of
from aseme_dsl.editor.files.view import View
from aseme_dsl.grammar.text import tree
from aseme_dsl.records import dataclass
from aseme_dsl.source import Span


@dataclass(frozen=True, slots=True)
class Hint:
    """A short text that is shown at an offset of the file; `is_type` or else a label."""

    offset: int
    text: str
    is_type: bool


def hints(view: View, start: int, end: int) -> tuple[Hint, ...]:
    """The inferred types of lets and the labels of states, between two offsets.

    A name in a formula shows the label of its state where exactly one statechart has it exactly once. For an
    activity that is played in several places, hovering shows the labels.
    """
    labels = _labels(view)
    found: list[Hint] = []
    for item in view.file.declarations if view.file is not None else ():
        span = view.whole(item.span)
        if span.end < start or span.start > end:
            continue
        found += _types(view, item)
        for formula in _formulas(item):
            place = view.whole(formula.name.span)
            own = labels.get(formula.formula.span, [])
            if len(own) == 1:
                found.append(Hint(place.end, own[0], False))
            for leaf in names(formula.formula):
                states = labels.get(leaf.span, [])
                if len(states) == 1 and leaf is not formula.formula:
                    found.append(Hint(view.whole(name_of(leaf)).end, states[0], False))
    return tuple(
        sorted((item for item in found if start <= item.offset <= end), key=lambda item: item.offset)
    )


def _labels(view: View) -> Mapping[Span, list[str]]:
    """The labels of the states that stand for each place in a formula; of roles if a role has any."""
    found: dict[Span, list[str]] = {}
    known = view.program.inspection
    for charts in (known.iacs, known.eacs):
        seen = set(found)
        for chart in charts.values():
            for node in chart.states if chart is not None else ():
                if node.type in (StateType.OR, StateType.AND, StateType.BASIC) and node.span not in seen:
                    found.setdefault(node.span, []).append(node.label)
    return found


def _formulas(item: tree.Declaration) -> Iterator[tree.NamedFormula]:
    if isinstance(item, tree.Srm):
        yield from item.formulas
    elif isinstance(item, tree.Aip):
        for party in item.participants:
            yield from party.formulas


def _types(view: View, item: tree.Declaration) -> Iterator[Hint]:
    lets: list[tuple[str, tree.Let]] = []
    match item:
        case tree.Let():
            lets.append(("", item))
        case tree.Srm() | tree.Statechart():
            lets += ((item.name.text, let) for let in item.lets)
        case tree.Aip():
            lets += ((item.name.text, let) for let in item.lets)
            for party in item.participants:
                lets += ((f"{item.name}.{party.name}", let) for let in party.lets)
    for owner, let in lets:
        kind = type_of(view.program, Symbol(Kind.LET, let.name.text, owner))
        if kind is not None:
            yield Hint(view.whole(let.name.span).end, f": {kind}", True)


# ---- above the text ---------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Lens:
    """Something to click above a declaration: what it is called, and the command with its arguments."""

    span: Span
    title: str
    command: str
    arguments: Mapping[str, str] = field(default_factory=dict)


DIAGRAM, RUN, SCENARIOS = "asemec.diagram", "asemec.run", "asemec.scenarios"
"""The commands that an editor's extension offers."""


def lenses(view: View) -> tuple[Lens, ...]:
    """A diagram of each model, a run of each team, and the scenarios."""
    found: list[Lens] = []
    root = view.program.root
    for item in view.file.declarations if view.file is not None else ():
        span = view.whole(item.span)
        match item:
            case tree.Sag():
                found.append(_diagram(span, root, "sag", ""))
            case tree.Suc():
                found.append(_diagram(span, root, "suc", ""))
            case tree.Aip():
                found.append(_diagram(span, root, "eac", item.name.text))
            case tree.Srm() | tree.Statechart():
                found.append(_diagram(span, root, "iac", item.name.text))
            case tree.Team():
                found.append(Lens(span, "Run", RUN, {"file": root, "team": item.name.text}))
            case tree.Scenario():
                arguments = {"file": root, "scenario": item.title.text}
                found.append(Lens(span, "Run scenario", SCENARIOS, arguments))
    return tuple(found)


def _diagram(span: Span, root: str, model: str, name: str) -> Lens:
    return Lens(span, "Diagram", DIAGRAM, {"file": root, "model": model, "name": name})
