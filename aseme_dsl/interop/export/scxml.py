"""SCXML 1.0 (W3C, 2015): the data model is ECMAScript's or Python's."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import field
from typing import Literal, assert_never
from xml.sax.saxutils import escape

from aseme_dsl.amola.expression import duration_text
from aseme_dsl.interop.export.machine import (
    ALWAYS,
    NEVER,
    Act,
    Const,
    Datum,
    Emit,
    Handler,
    If,
    Machine,
    Move,
    Raise,
    Schedule,
    Set,
    Shape,
    Term,
    Unschedule,
    Vertex,
)
from aseme_dsl.interop.export.script import EcmaScript, Python, Script
from aseme_dsl.interop.machines.scxml import END, OWN
from aseme_dsl.records import dataclass

DataModel = Literal["ecmascript", "python"]
NAMESPACE = "http://www.w3.org/2005/07/scxml"
FINISHED = "asemec_finished"


def scxml(machine: Machine, datamodel: DataModel = "ecmascript") -> str:
    """The document of a machine."""
    script: Script = EcmaScript() if datamodel == "ecmascript" else Python()
    page = _Page(script, Counter(_scheduled(_all_acts(machine))))
    return "\n".join([*_document(machine, datamodel, page), ""])


@dataclass
class _Page:
    """The language of the expressions, and the ids of what is sent later.

    An id stands once in a document. So each of several places that send one event has an id of its own, and
    all of them are cancelled.
    """

    script: Script
    places: Counter[str]
    used: Counter[str] = field(default_factory=Counter)

    def new_id(self, event: str) -> str:
        self.used[event] += 1
        return self._id(event, self.used[event])

    def ids(self, event: str) -> Iterator[str]:
        """The ids of all places that send an event."""
        return (self._id(event, number) for number in range(1, self.places[event] + 1))

    def _id(self, event: str, number: int) -> str:
        return event if number == 1 else f"{event}.{number}"


def _all_acts(machine: Machine) -> Iterator[Act]:
    for vertex in machine.root.inside():
        yield from vertex.entry
        yield from vertex.exit
        for move in vertex.moves:
            yield from move.acts
    for handler in machine.handlers:
        yield from handler.acts


def _scheduled(acts: Iterable[Act]) -> Iterator[str]:
    """The events that are sent later, once for each place."""
    for act in acts:
        if isinstance(act, Schedule):
            yield act.event
        elif isinstance(act, If):
            yield from _scheduled(act.then)
            yield from _scheduled(act.otherwise)


def _attribute(text: str) -> str:
    """A text between double quotes; what XML has no character for is left out."""
    kept = "".join(c if c.isprintable() or c in "\t\n" else "\N{REPLACEMENT CHARACTER}" for c in text)
    return escape(kept, {'"': "&quot;", "\n": "&#10;", "\t": "&#9;"})


def _comment(text: str) -> str:
    return _attribute(text).replace("--", "- -").rstrip("-")


def _document(machine: Machine, datamodel: DataModel, page: _Page) -> Iterator[str]:
    root = machine.root
    yield '<?xml version="1.0" encoding="UTF-8"?>'
    yield f"<!-- asemec export scxml: {_comment(machine.name)} of {_comment(machine.source)} -->"
    yield (
        f'<scxml xmlns="{NAMESPACE}" xmlns:amola="{OWN}" version="1.0" datamodel="{datamodel}"'
        f' name="{_attribute(machine.name)}" initial="{root.id}">'
    )
    yield "  <datamodel>"
    for item in machine.data or (Datum("asemec", True, "SCION refuses a chart without data"),):
        yield f"    <!-- {_comment(item.text)} -->"
        yield f'    <data id="{item.name}" expr="{_attribute(page.script.constant(item.initial))}"/>'
    yield "  </datamodel>"
    yield from _state(machine, root, page, "  ")
    yield f'  <final id="{FINISHED}"/>'
    yield "</scxml>"


def _state(machine: Machine, vertex: Vertex, page: _Page, indent: str) -> Iterator[str]:
    element = "parallel" if vertex.shape is Shape.PARALLEL else "state"
    initial = f' initial="{vertex.children[0].id}"' if vertex.shape is Shape.COMPOUND else ""
    activity = f' amola:activity="{_attribute(vertex.activity)}"' if vertex.activity else ""
    end = f' amola:type="{END}"' if vertex.shape is Shape.FINAL else ""
    own = f' amola:label="{vertex.label}" amola:name="{_attribute(vertex.title)}"{activity}{end}'
    inner = [*_inner(machine, vertex, page, indent + "  ")]
    if not inner:
        yield f'{indent}<{element} id="{vertex.id}"{initial}{own}/>'
        return
    yield f'{indent}<{element} id="{vertex.id}"{initial}{own}>'
    yield from inner
    yield f"{indent}</{element}>"


def _inner(machine: Machine, vertex: Vertex, page: _Page, indent: str) -> Iterator[str]:
    yield from _block("onentry", "", vertex.entry, page, indent)
    yield from _block("onexit", "", vertex.exit, page, indent)
    for move in vertex.moves:
        yield from _transition(move, page, indent)
    if vertex is machine.root:
        if machine.ended != NEVER:
            ended = _attribute(page.script.condition(machine.ended))
            yield f'{indent}<transition cond="{ended}" target="{FINISHED}"/>'
        for handler in machine.handlers:
            yield from _handler(handler, page, indent)
    for child in vertex.children:
        yield from _state(machine, child, page, indent)


def _transition(move: Move, page: _Page, indent: str) -> Iterator[str]:
    said = f"{move.place} {move.text}".strip()
    yield f"{indent}<!-- {_comment(said)} -->"
    target = f' target="{" ".join(move.targets)}"' if move.targets else ""
    condition = (
        f' cond="{_attribute(page.script.condition(move.condition))}"' if move.condition != ALWAYS else ""
    )
    yield from _block("transition", condition + target, move.acts, page, indent, always=True)


def _handler(handler: Handler, page: _Page, indent: str) -> Iterator[str]:
    yield f"{indent}<!-- {_comment(handler.text)} -->"
    yield from _block("transition", f' event="{handler.event}"', handler.acts, page, indent, always=True)


def _block(
    element: str, attributes: str, acts: Iterable[Act], page: _Page, indent: str, *, always: bool = False
) -> Iterator[str]:
    lines = [*_acts(acts, page, indent + "  ")]
    if lines:
        yield f"{indent}<{element}{attributes}>"
        yield from lines
        yield f"{indent}</{element}>"
    elif always:
        yield f"{indent}<{element}{attributes}/>"


def _acts(acts: Iterable[Act], page: _Page, indent: str) -> Iterator[str]:
    for act in acts:
        match act:
            case Set(name=name, value=value):
                yield f'{indent}<assign location="{name}" expr="{_attribute(page.script.term(value))}"/>'
            case If(condition=condition, then=then, otherwise=otherwise):
                yield f'{indent}<if cond="{_attribute(page.script.condition(condition))}">'
                yield from _acts(then, page, indent + "  ")
                if otherwise:
                    yield f"{indent}  <else/>"
                    yield from _acts(otherwise, page, indent + "  ")
                yield f"{indent}</if>"
            case Raise(event=event):
                yield f'{indent}<raise event="{event}"/>'
            case Schedule(event=event, delay=delay):
                yield from _cancelled(event, page, indent)
                own, later = page.new_id(event), _delay(delay, page.script)
                yield f'{indent}<send event="{event}" id="{own}" {later}/>'
            case Unschedule(event=event):
                yield from _cancelled(event, page, indent)
            case Emit(event=event, parameters=parameters):
                yield f'{indent}<send event="{event}">'
                for name, term in parameters:
                    said = _attribute(page.script.term(term))
                    yield f'{indent}  <param name="{_attribute(name)}" expr="{said}"/>'
                yield f"{indent}</send>"
            case _:
                assert_never(act)


def _cancelled(event: str, page: _Page, indent: str) -> Iterator[str]:
    return (f'{indent}<cancel sendid="{name}"/>' for name in page.ids(event))


def _delay(delay: Term, script: Script) -> str:
    if isinstance(delay, Const) and isinstance(delay.value, int):
        return (
            f'delay="{duration_text(delay.value)}"'
            if delay.value % 60_000_000_000
            else (f'delay="{delay.value // 1_000_000_000}s"')
        )
    return f'delayexpr="{_attribute(script.milliseconds(delay))}"'


__all__ = ["DataModel", "scxml"]
