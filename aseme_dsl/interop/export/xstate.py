"""XState 5: the machine as JSON, and a TypeScript module with its guards, its actions and their types."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import field
from typing import assert_never

from aseme_dsl.interop.export.machine import (
    ALWAYS,
    INPUT,
    SETTLED,
    Act,
    All,
    Cond,
    Emit,
    Handler,
    If,
    In,
    Inverse,
    Machine,
    Move,
    Present,
    Raise,
    Schedule,
    Set,
    Shape,
    Some,
    Truth,
    Unschedule,
    Vertex,
    asks_for_states,
)
from aseme_dsl.interop.export.script import EcmaScript
from aseme_dsl.records import dataclass

Json = dict[str, object]

_TYPES = {"bool": "boolean", "int": "number", "double": "number", "duration": "number", "string": "string"}


@dataclass(frozen=True, slots=True)
class XState:
    """The two files."""

    config: str
    module: str


def xstate(machine: Machine, name: str) -> XState:
    """The files of a machine; `name` is that of the JSON file, which the module imports."""
    writer = _Writer(machine)
    config = writer.config()
    return XState(json.dumps(config, indent=2) + "\n", "\n".join([*writer.module(name), ""]))


@dataclass
class _Writer:
    machine: Machine
    guards: dict[str, str] = field(default_factory=dict)
    """The name of each guard by its text."""
    actions: dict[str, str] = field(default_factory=dict)
    about: dict[str, str] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.script = EcmaScript("context.", "event")

    # ---- the configuration --------------------------------------------------------------

    def config(self) -> Json:
        """The machine: the chart is the only region of its root, so that its END ends the machine."""
        machine = self.machine
        return {
            "id": "asemec_machine",
            "description": f"asemec export xstate: {machine.name} of {machine.source}",
            "type": "parallel",
            "context": {item.name: item.initial for item in machine.data},
            "on": {item.event: {"actions": self._actions(item.acts, item.text)} for item in machine.handlers},
            "states": {machine.root.id: self._state(machine.root)},
        }

    def _state(self, vertex: Vertex) -> Json:
        found: Json = {"id": vertex.id, "description": f"{vertex.label} {vertex.title}"}
        if vertex.activity:
            found["meta"] = {"activity": vertex.activity}
        if vertex.shape in (Shape.PARALLEL, Shape.FINAL):
            found["type"] = vertex.shape.value
        if vertex.shape is Shape.COMPOUND:
            found["initial"] = vertex.children[0].id
        if vertex.entry:
            found["entry"] = self._actions(vertex.entry, f"entry of {vertex.title}")
        if vertex.exit:
            found["exit"] = self._actions(vertex.exit, f"exit of {vertex.title}")
        if vertex.moves:
            found["always"] = [self._move(move) for move in vertex.moves]
        if vertex.children:
            found["states"] = {child.id: self._state(child) for child in vertex.children}
        return found

    def _move(self, move: Move) -> Json:
        said = f"{move.place} {move.text}".strip()
        found: Json = {"description": said}
        if move.targets:
            ids = [f"#{target}" for target in move.targets]
            found |= {"target": ids if len(ids) > 1 else ids[0], "reenter": True}
        if move.condition != ALWAYS:
            found["guard"] = self._named(self.guards, "guard", self._guard(move.condition), said)
        if move.acts:
            found["actions"] = self._actions(move.acts, said)
        return found

    def _named(self, table: dict[str, str], kind: str, text: str, about: str) -> str:
        name = table.get(text)
        if name is None:
            name = table[text] = f"{kind}{len(table) + 1}"
            self.about[name] = about
        return name

    # ---- guards -------------------------------------------------------------------------

    def _guard(self, cond: Cond) -> str:
        """A guard; what asks for states is put together from guards, and everything else is a function."""
        if not asks_for_states(cond):
            return f"({{ context }}: Given) => {self._boolean(self.script.condition(cond))}"
        match cond:
            case In(state=state):
                return f"stateIn({json.dumps('#' + state)})"
            case All(parts=parts):
                return f"and([{', '.join(self._guard(part) for part in parts)}])"
            case Some(parts=parts):
                return f"or([{', '.join(self._guard(part) for part in parts)}])"
            case Inverse(part=part):
                return f"not({self._guard(part)})"
            case Truth() | Present():
                raise AssertionError(cond)  # they ask for no state
        assert_never(cond)

    def _boolean(self, text: str) -> str:
        return f"Boolean({text})"

    # ---- actions ------------------------------------------------------------------------

    def _actions(self, acts: tuple[Act, ...], about: str) -> list[str]:
        """The names of what is done: assignments that follow each other are one."""
        found: list[str] = []
        together: list[Set | If] = []
        for act in (*acts, None):
            if isinstance(act, Set | If):
                together.append(act)
                continue
            if together:
                found.append(self._named(self.actions, "action", self._assigned(together), about))
                together = []
            if act is not None:
                found += [self._named(self.actions, "action", text, about) for text in self._sent(act)]
        return found

    def _assigned(self, acts: list[Set | If]) -> str:
        lines = [
            "assign<Context, any, undefined, any, any>(({ context: before, event }) => {",
            "  const context: Context = { ...before };",
            *self.script.statements(acts, "  "),
            "  return context;",
            "})",
        ]
        return "\n".join(lines)

    def _sent(self, act: Act) -> Iterator[str]:
        match act:
            case Raise(event=event):
                yield f"raise({{ type: {json.dumps(event)} }})"
            case Schedule(event=event, delay=delay):
                name = json.dumps(event)
                yield f"cancel({name})"
                later = f"({{ context }}: Given) => {self.script.term(delay)} / 1e6"
                yield f"raise({{ type: {name} }}, {{ id: {name}, delay: {later} }})"
            case Unschedule(event=event):
                yield f"cancel({json.dumps(event)})"
            case Emit(event=event, parameters=parameters):
                said = [f"type: {json.dumps(event)}"]
                said += [f"{json.dumps(name)}: {self.script.term(term)}" for name, term in parameters]
                yield f"emit(({{ context }}: Given) => ({{ {', '.join(said)} }}))"

    # ---- the module ---------------------------------------------------------------------

    def module(self, name: str) -> Iterator[str]:
        yield f"// asemec export xstate: {_comment(self.machine.name)} of {_comment(self.machine.source)}"
        helpers = "and, assign, cancel, emit, not, or, raise, setup, stateIn"
        yield f'import {{ {helpers} }} from "xstate";'
        yield f"import config from {json.dumps('./' + name)};"
        yield ""
        yield from self._context()
        yield ""
        yield from self._events()
        yield ""
        yield "type Given = { context: Context; event: { [name: string]: any } };"
        yield ""
        yield from self._table("guards", self.guards)
        yield ""
        yield from self._table("actions", self.actions)
        yield ""
        yield "export const machine = setup({"
        yield "  types: { context: {} as Context, events: {} as Event, emitted: {} as Emitted },"
        yield "  guards: guards as any,"
        yield "  actions: actions as any,"
        yield "}).createMachine(config as any);"
        yield ""
        yield f"void [{helpers}];"

    def _context(self) -> Iterator[str]:
        yield "export interface Context {"
        for item in self.machine.data:
            kind = _TYPES.get(item.kind, "any")
            kind = (
                kind
                if isinstance(item.initial, bool | int | float | str) or kind == "any"
                else f"{kind} | null"
            )
            yield f"  /** {_comment(item.text)} */"
            yield f"  {item.name}: {kind};"
        yield "}"

    def _events(self) -> Iterator[str]:
        yield "export type Event ="
        for handler in self.machine.handlers:
            if handler.event == INPUT:
                yield "  // any of the inputs"
                yield f'  | ({{ type: "{INPUT}" }} & Partial<Context>)'
            elif handler.event != SETTLED:
                yield f"  // {_comment(handler.text)}"
                more = "; [outcome: string]: any" if _has_outcome(handler) else ""
                yield f"  | {{ type: {json.dumps(handler.event)}{more} }}"
        yield f'  | {{ type: "{SETTLED}" }};'
        yield ""
        emitted = [
            f"{{ type: {json.dumps(event)}; [member: string]: any }}" for event in self.machine.emitted
        ]
        yield f"export type Emitted = {' | '.join(emitted) or '{ type: never }'};"

    def _table(self, kind: str, table: dict[str, str]) -> Iterator[str]:
        yield f"export const {kind} = {{"
        for text, name in table.items():
            first, *more = text.split("\n")
            yield f"  // {_comment(self.about[name])}"
            yield f"  {name}: {first}" + ("" if more else ",")
            for number, line in enumerate(more, 1):
                yield f"  {line}" + ("," if number == len(more) else "")
        yield "};"


def _has_outcome(handler: Handler) -> bool:
    return len(handler.acts) > 1


def _comment(text: str) -> str:
    """A text for one line of a comment."""
    return "".join(c if c.isprintable() else " " for c in text).replace("*/", "* /")


__all__ = ["XState", "xstate"]
