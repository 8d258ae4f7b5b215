"""Sismic: a statechart in its YAML, with Python code."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator
from typing import assert_never

from aseme_dsl.amola.expression import NEVER
from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.diagnostics.problems.exporting import Foreign
from aseme_dsl.interop.export.lowering import Refusal
from aseme_dsl.interop.export.machine import (
    ALWAYS,
    Act,
    Emit,
    If,
    Machine,
    Move,
    Raise,
    Schedule,
    Set,
    Shape,
    Unschedule,
    Vertex,
)
from aseme_dsl.interop.export.script import Python

_SCRIPT = Python("event.data", "active")


def sismic(machine: Machine) -> str:
    """The document of a machine. Texts are written as JSON strings, which are YAML, too."""
    return "\n".join([*_document(machine), ""])


def limits(chart: Statechart) -> Iterator[Refusal]:
    """What Sismic does otherwise: it enters the regions of an AND only together."""
    for item in chart.transitions:
        if item.expression is NEVER:
            continue
        left = {item.source, *(state.label for state in chart.ancestors(item.source))}
        entered = {item.target, *(state.label for state in chart.ancestors(item.target))} - left
        if item.into or any(chart.is_region(label) for label in entered):
            yield Refusal(Foreign.ENTERING, item.span)


def _text(text: str) -> str:
    return json.dumps(text)


def _document(machine: Machine) -> Iterator[str]:
    about = f"asemec export sismic: {machine.name} of {machine.source}"
    yield f"# {''.join(c if c.isprintable() else ' ' for c in about)}"
    yield "statechart:"
    yield f"  name: {_text(machine.name)}"
    yield f"  description: {_text(about)}"
    lines = [f"{item.name} = {_SCRIPT.constant(item.initial)}  # {item.text}" for item in machine.data]
    lines += [f"{_number(event)} = 0  # of the last {event}" for event in _scheduled(machine)]
    safe = ["".join(c if c.isprintable() else " " for c in line) for line in lines]
    yield f"  preamble: {_text(chr(10).join(safe))}"
    yield "  root state:"
    yield from _state(machine, machine.root, "    ")


def _scheduled(machine: Machine) -> list[str]:
    """The events that the chart sends to itself later."""
    return [item.event for item in machine.handlers if item.event.startswith(("after.", "timer."))]


def _number(event: str) -> str:
    """Counts how often an event was sent or taken back."""
    return f"number_{event.partition('.')[2]}"


def _state(machine: Machine, vertex: Vertex, indent: str) -> Iterator[str]:
    yield f"{indent}name: {vertex.id}"
    if vertex.shape is Shape.FINAL:
        yield f"{indent}type: final"
    if vertex.shape is Shape.COMPOUND:
        yield f"{indent}initial: {vertex.children[0].id}"
    for word, acts in (("on entry", vertex.entry), ("on exit", vertex.exit)):
        if acts:
            yield f"{indent}{word}: {_code(acts)}"
    transitions = [*_transitions(machine, vertex, indent + "  ")]
    if transitions:
        yield f"{indent}transitions:"
        yield from transitions
    if vertex.children:
        yield f"{indent}{'parallel states' if vertex.shape is Shape.PARALLEL else 'states'}:"
        for child in vertex.children:
            first, *more = _state(machine, child, indent + "    ")
            yield f"{indent}  - {first.strip()}"
            yield from more


def _transitions(machine: Machine, vertex: Vertex, indent: str) -> Iterator[str]:
    """Those of a state; which one is tried first is a priority here."""
    for number, move in enumerate(vertex.moves):
        yield from _move(move, len(vertex.moves) - number, indent)
    if vertex is machine.root:
        for handler in machine.handlers:
            yield f"{indent}- event: {_text(handler.event)}"
            if handler.event in _scheduled(machine):  # what was taken back comes nevertheless
                last = _number(handler.event)
                same = f"event.data.get('number', {last}) == {last}"
                yield f"{indent}  guard: {_text(same)}"
            if handler.acts:
                yield f"{indent}  action: {_code(handler.acts)}"


def _move(move: Move, priority: int, indent: str) -> Iterator[str]:
    yield f"{indent}- priority: {priority}"
    for target in move.targets:  # at most one: see `limits`
        yield f"{indent}  target: {target}"
    if move.condition != ALWAYS:
        yield f"{indent}  guard: {_text(_SCRIPT.condition(move.condition))}"
    if move.acts:
        yield f"{indent}  action: {_code(move.acts)}"


def _code(acts: Iterable[Act]) -> str:
    return _text("\n".join(_statements(acts, "")))


def _statements(acts: Iterable[Act], indent: str) -> Iterator[str]:
    empty = True
    for act in acts:
        empty = False
        match act:
            case Set(name=name, value=value):
                yield f"{indent}{name} = {_SCRIPT.term(value)}"
            case If(condition=condition, then=then, otherwise=otherwise):
                yield f"{indent}if {_SCRIPT.condition(condition)}:"
                yield from _statements(then, indent + "    ")
                if otherwise:
                    yield f"{indent}else:"
                    yield from _statements(otherwise, indent + "    ")
            case Raise(event=event):
                yield f"{indent}send({event!r})"
            case Schedule(event=event, delay=delay):
                number = _number(event)
                yield f"{indent}{number} += 1"
                yield f"{indent}send({event!r}, delay={_SCRIPT.term(delay)} / 1e9, number={number})"
            case Unschedule(event=event):
                yield f"{indent}{_number(event)} += 1"
            case Emit(event=event, parameters=parameters):
                said = "".join(f", {name!r}: {_SCRIPT.term(term)}" for name, term in parameters)
                yield f"{indent}notify({event!r}, data={{{said.removeprefix(', ')}}})"
            case _:
                assert_never(act)
    if empty:
        yield f"{indent}pass"


__all__ = ["limits", "sismic"]
