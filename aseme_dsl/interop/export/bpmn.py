"""BPMN 2.0: a statechart as a process, which modelling tools open; it is not made to be executed."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import field
from xml.sax.saxutils import escape

from aseme_dsl.amola.expression import (
    NEVER,
    After,
    Event,
    Failed,
    Lost,
    Raised,
    Received,
    action_text,
    event_text,
    value_text,
)
from aseme_dsl.amola.statechart import State, Statechart, StateType, Transition, transition_text
from aseme_dsl.diagnostics.problems.exporting import Foreign
from aseme_dsl.interop.export.lowering import Refusal
from aseme_dsl.interop.export.names import Names
from aseme_dsl.records import dataclass

_MODEL = "http://www.omg.org/spec/BPMN/20100524/MODEL"
_DRAWN = "http://www.omg.org/spec/BPMN/20100524/DI"
_BOUNDS = "http://www.omg.org/spec/DD/20100524/DC"
_LINES = "http://www.omg.org/spec/DD/20100524/DI"
_XSI = "http://www.w3.org/2001/XMLSchema-instance"

_TASK = (120, 60)
_SMALL = (36, 36)
_GAP = 50


def bpmn(chart: Statechart, about: str) -> str:
    """The document of a chart; `about` says from what it comes."""
    return "\n".join([*_Process(chart).document(about), ""])


def limits(chart: Statechart) -> tuple[Refusal, ...]:
    """What a process cannot say."""
    found: list[Refusal] = []
    known = chart.by_label
    for item in chart.transitions:
        expression = item.expression
        if expression is NEVER:
            continue
        if item.into:
            found.append(Refusal(Foreign.SEVERAL_TARGETS, item.span))
        elif known[item.source].parent != known[item.target].parent:
            found.append(Refusal(Foreign.CROSSING, item.span))
        if not item.changes_state:
            found.append(Refusal(Foreign.ACTIONS_INSIDE, item.span))
        if item.resume:
            found.append(Refusal(Foreign.RESUMING, item.span))
        if expression.events and (expression.condition is not None or expression.when):
            found.append(Refusal(Foreign.GUARDED_EVENTS, item.span))
        if expression.every is not None:
            found.append(Refusal(Foreign.PACES, item.span))
        if expression.weight is not None:
            found.append(Refusal(Foreign.BRANCHING, item.span))
    for state in chart.states:
        leaving = [i for i in chart.outgoing_edges(state.label) if i.expression is not NEVER]
        plain = state.type in (StateType.CONDITION, StateType.START)
        waits = [i for i in leaving if i.expression.events or i.expression.when]
        if plain and waits and any(_is_default(item) for item in leaving):
            found += [Refusal(Foreign.EVENT_OR_ELSE, item.span) for item in waits]
    return tuple(found)


def _is_default(transition: Transition) -> bool:
    expression = transition.expression
    return expression.otherwise or (
        not expression.events and not expression.when and expression.condition is None
    )


def _text(text: str) -> str:
    kept = "".join(c if c.isprintable() or c in "\t\n" else "\N{REPLACEMENT CHARACTER}" for c in text)
    return escape(kept, {'"': "&quot;", "\n": "&#10;", "\t": "&#9;"})


def _label(transition: Transition) -> str:
    """What is done on the way, and what is chosen by."""
    expression = transition.expression
    parts = ["else"] if expression.otherwise else []
    parts += [f"[{value_text(expression.condition)}]"] if expression.condition is not None else []
    actions = "; ".join(map(action_text, expression.actions))
    return " ".join([*parts, *([f"/ {actions}"] if actions else [])])


@dataclass
class _Node:
    """An element of a process with its place and size."""

    id: str
    element: str
    name: str = ""
    attributes: str = ""
    content: list[str] = field(default_factory=list)
    nodes: list[_Node] = field(default_factory=list)
    flows: list[tuple[str, str, str, str, str]] = field(default_factory=list)
    """Flows inside: id, source, target, name, condition."""
    width: int = 0
    height: int = 0
    x: int = 0
    y: int = 0


class _Process:
    def __init__(self, chart: Statechart) -> None:
        self.chart = chart
        self.names = Names(chart)
        self.flows = 0
        self.signals: dict[str, str] = {}
        self.messages: dict[str, str] = {}
        self.errors: dict[str, str] = {}

    # ---- the model ----------------------------------------------------------------------

    def process(self) -> _Node:
        root = _Node(self.names.id_of(self.chart.root), "process", self.chart.name, ' isExecutable="false"')
        self._fill(root, self.chart.root)
        return root

    def _fill(self, node: _Node, state: State) -> None:
        """The elements inside an OR."""
        for child in self.chart.children(state.label):
            node.nodes.append(self._element(child))
        for child in self.chart.children(state.label):
            self._leaving(node, child)

    def _element(self, state: State) -> _Node:
        name, title = self.names.id_of(state), self.chart.title(state)
        match state.type:
            case StateType.START:
                return _Node(name, "startEvent")
            case StateType.END:
                return _Node(name, "endEvent")
            case StateType.CONDITION:
                return _Node(name, self._gateway(state))
            case StateType.BASIC:
                return _Node(name, "task", title)
        node = _Node(name, "subProcess", title)
        if state.type is StateType.OR:
            self._fill(node, state)
            return node
        regions = [self._element(region) for region in self.chart.children(state.label)]
        begin, fork = _Node(f"{name}_begin", "startEvent"), _Node(f"{name}_fork", "parallelGateway")
        join, end = _Node(f"{name}_join", "parallelGateway"), _Node(f"{name}_end", "endEvent")
        node.nodes = [begin, fork, *regions, join, end]
        self._flow(node, begin.id, fork.id)
        for region in regions:
            self._flow(node, fork.id, region.id)
            self._flow(node, region.id, join.id)
        self._flow(node, join.id, end.id)
        return node

    def _gateway(self, state: State) -> str:
        leaving = self._outgoing(state)
        return "exclusiveGateway" if any(map(_is_default, leaving)) else "eventBasedGateway"

    def _outgoing(self, state: State) -> list[Transition]:
        return [i for i in self.chart.outgoing_edges(state.label) if i.expression is not NEVER]

    def _leaving(self, node: _Node, state: State) -> None:
        """The flows out of a state, with what they need on the way."""
        source = self.names.id_of(state)
        completing = []
        for number, item in enumerate(self._outgoing(state)):
            waits = item.expression.events or item.expression.when
            if waits and state.type not in (StateType.START, StateType.CONDITION):
                event = _Node(f"{source}_event_{number}", "boundaryEvent", self._said(item))
                event.attributes = f' attachedToRef="{source}" cancelActivity="true"'
                event.content = [*self._definitions(item)]
                node.nodes.append(event)
                self._flow(node, event.id, self._target(item), _label_of_actions(item))
            else:
                completing.append(item)
        if not completing:
            return
        alone = completing[0]
        if (
            len(completing) == 1
            and alone.expression.is_unconditional
            and state.type is not StateType.CONDITION
        ):
            self._flow(node, source, self._target(alone), _label(alone))
            return
        default = any(map(_is_default, completing))
        if state.type is not StateType.CONDITION and (default or len(completing) > 1):
            kind = "exclusiveGateway" if default else "eventBasedGateway"
            gateway = _Node(f"{source}_choice", kind)
            node.nodes.append(gateway)
            self._flow(node, source, gateway.id)
            source = gateway.id
        for number, item in enumerate(completing):
            if default:
                self._choose(node, source, item)
            else:
                event = _Node(f"{source}_catch_{number}", "intermediateCatchEvent", self._said(item))
                event.content = [*self._definitions(item)]
                node.nodes.append(event)
                self._flow(node, source, event.id)
                self._flow(node, event.id, self._target(item), _label_of_actions(item))

    def _choose(self, node: _Node, source: str, item: Transition) -> None:
        """A flow out of a gateway that takes the first that holds, or the default one."""
        condition = item.expression.condition
        number = self._flow(
            node,
            source,
            self._target(item),
            _label(item),
            value_text(condition, expand=True) if condition is not None and not _is_default(item) else "",
        )
        gateway = next(other for other in node.nodes if other.id == source)
        if _is_default(item) and not gateway.attributes:
            gateway.attributes = f' default="{number}"'

    def _target(self, item: Transition) -> str:
        return self.names.id_of(self.chart.node(item.target))

    def _said(self, item: Transition) -> str:
        """What an event waits for, for readers."""
        return transition_text(item).partition(" / ")[0].removeprefix("/ ")

    def _flow(self, node: _Node, source: str, target: str, name: str = "", condition: str = "") -> str:
        self.flows += 1
        number = f"flow_{self.flows}"
        node.flows.append((number, source, target, name, condition))
        return number

    def _definitions(self, item: Transition) -> Iterator[str]:
        for event in item.expression.events:
            yield self._definition(event)
        if not item.expression.events and item.expression.condition is not None:
            text = _text(value_text(item.expression.condition, expand=True))
            yield (
                "<conditionalEventDefinition>"
                f'<condition xsi:type="tFormalExpression">{text}</condition>'
                "</conditionalEventDefinition>"
            )

    def _definition(self, event: Event) -> str:
        said = event_text(event)
        match event:
            case After(duration=duration):
                time = f"PT{duration // 10**9}.{duration % 10**9:09d}S"
                return (
                    "<timerEventDefinition>"
                    f'<timeDuration xsi:type="tFormalExpression">{time}</timeDuration>'
                    "</timerEventDefinition>"
                )
            case Raised() | Lost():
                number = self.signals.setdefault(said, f"signal_{len(self.signals) + 1}")
                return f'<signalEventDefinition signalRef="{number}"/>'
            case Received():
                number = self.messages.setdefault(said, f"message_{len(self.messages) + 1}")
                return f'<messageEventDefinition messageRef="{number}"/>'
            case Failed():
                number = self.errors.setdefault(said, f"error_{len(self.errors) + 1}")
                return f'<errorEventDefinition errorRef="{number}"/>'

    # ---- the document -------------------------------------------------------------------

    def document(self, about: str) -> Iterator[str]:
        root = self.process()
        _measure(root)
        yield '<?xml version="1.0" encoding="UTF-8"?>'
        yield (
            f'<definitions xmlns="{_MODEL}" xmlns:bpmndi="{_DRAWN}" xmlns:dc="{_BOUNDS}" xmlns:di="{_LINES}"'
            f' xmlns:xsi="{_XSI}" id="definitions" targetNamespace="urn:asemec" exporter="{_text(about)}">'
        )
        for kind, table in (("signal", self.signals), ("message", self.messages), ("error", self.errors)):
            for said, number in table.items():
                yield f'  <{kind} id="{number}" name="{_text(said)}"/>'
        yield from _written(root, "  ")
        yield '  <bpmndi:BPMNDiagram id="diagram">'
        yield f'    <bpmndi:BPMNPlane id="plane" bpmnElement="{root.id}">'
        yield from _drawn(root)
        yield "    </bpmndi:BPMNPlane>"
        yield "  </bpmndi:BPMNDiagram>"
        yield "</definitions>"


def _label_of_actions(item: Transition) -> str:
    actions = "; ".join(map(action_text, item.expression.actions))
    return f"/ {actions}" if actions else ""


def _written(node: _Node, indent: str) -> Iterator[str]:
    name = f' name="{_text(node.name)}"' if node.name else ""
    begin = f'{indent}<{node.element} id="{node.id}"{name}{node.attributes}'
    if not (node.nodes or node.content):
        yield f"{begin}/>"
        return
    yield f"{begin}>"
    for line in node.content:
        yield f"{indent}  {line}"
    for child in node.nodes:
        yield from _written(child, indent + "  ")
    for number, source, target, said, condition in node.flows:
        label = f' name="{_text(said)}"' if said else ""
        flow = f'{indent}  <sequenceFlow id="{number}"{label} sourceRef="{source}" targetRef="{target}"'
        if condition:
            inner = (
                f'<conditionExpression xsi:type="tFormalExpression">{_text(condition)}</conditionExpression>'
            )
            yield f"{flow}>{inner}</sequenceFlow>"
        else:
            yield f"{flow}/>"
    yield f"{indent}</{node.element}>"


# ---- where everything is drawn -----------------------------------------------------------------


def _measure(root: _Node) -> None:
    """Sizes from the inside out, and places from the outside in: in a row, events below what they are at."""
    order, stack = [], [root]
    while stack:
        node = stack.pop()
        order.append(node)
        stack.extend(node.nodes)
    for node in reversed(order):
        if not node.nodes:
            node.width, node.height = _TASK if node.element == "task" else _SMALL
            continue
        row = [child for child in node.nodes if child.element != "boundaryEvent"]
        x = _GAP
        for child in row:
            child.x, child.y = x, _GAP
            x += child.width + _GAP
        node.width = x
        node.height = max(child.height for child in row) + 2 * _GAP
    for node in order:
        if node is root:
            node.x = node.y = 0
        known = {child.id: child for child in node.nodes}
        for child in node.nodes:
            if child.element == "boundaryEvent":
                holder = known[child.id.rpartition("_event_")[0]]
                at = sum(1 for other in node.nodes if other.id.startswith(f"{holder.id}_event_") and other.x)
                child.x = holder.x + 10 + 40 * at
                child.y = holder.y + holder.height - 18
    for node in order:
        for child in node.nodes:
            child.x += node.x
            child.y += node.y


def _drawn(root: _Node) -> Iterator[str]:
    stack = [root]
    while stack:
        node = stack.pop()
        known = {child.id: child for child in node.nodes}
        for child in node.nodes:
            expanded = ' isExpanded="true"' if child.element == "subProcess" else ""
            yield f'      <bpmndi:BPMNShape id="shape_{child.id}" bpmnElement="{child.id}"{expanded}>'
            box = f'x="{child.x}" y="{child.y}" width="{child.width}" height="{child.height}"'
            yield f"        <dc:Bounds {box}/>"
            yield "      </bpmndi:BPMNShape>"
        for number, source, target, _, _ in node.flows:
            one, other = known[source], known[target]
            yield f'      <bpmndi:BPMNEdge id="edge_{number}" bpmnElement="{number}">'
            yield f'        <di:waypoint x="{one.x + one.width}" y="{one.y + one.height // 2}"/>'
            yield f'        <di:waypoint x="{other.x}" y="{other.y + other.height // 2}"/>'
            yield "      </bpmndi:BPMNEdge>"
        stack.extend(node.nodes)


__all__ = ["bpmn", "limits"]
