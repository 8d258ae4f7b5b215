"""A statechart as lines of a text from which a tool draws: what Mermaid and PlantUML have in common."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterator

from aseme_dsl.amola.expression import NEVER
from aseme_dsl.amola.statechart import State, Statechart, StateType, Transition, transition_text
from aseme_dsl.diagnostics.problems.exporting import Foreign
from aseme_dsl.interop.export.lowering import Refusal
from aseme_dsl.interop.export.names import Names


def shown(text: str, kept: str, escape: str) -> str:
    """A text in which everything but letters, digits and what is `kept` is written by its number."""
    safe = (c if c.isalnum() or c in kept else " " if c.isspace() else escape.format(ord(c)) for c in text)
    return "".join(safe)


def crossings(chart: Statechart) -> tuple[Refusal, ...]:
    """The transitions that lead from inside one composite into another, which cannot be drawn."""
    known = chart.by_label
    return tuple(
        Refusal(Foreign.SEVERAL_TARGETS if item.into else Foreign.CROSSING, item.span)
        for item in chart.transitions
        if item.into or known[item.source].parent != known[item.target].parent
    )


class Sketch(ABC):
    """The lines of a chart in one language."""

    def __init__(self, chart: Statechart) -> None:
        self.chart = chart
        self.names = Names(chart)

    @abstractmethod
    def quoted(self, text: str) -> str:
        """A text as it stands in a line."""

    @abstractmethod
    def note(self, state: str, text: str) -> str:
        """A line that says something of a state."""

    def state(self, state: State, indent: str) -> Iterator[str]:
        """A state, and what is in it."""
        name = self.names.id_of(state)
        match state.type:
            case StateType.START | StateType.END:
                return
            case StateType.CONDITION:
                yield f"{indent}state {name} <<choice>>"
                return
        named = f'{indent}state "{self.quoted(self.chart.title(state))}" as {name}'
        if state.type is StateType.BASIC:
            yield named
            return
        yield f"{named} {{"  # PlantUML forgets the name of a state that stands a second time without it
        yield from self.inside(state, indent + "  ")
        yield f"{indent}}}"

    def inside(self, state: State, indent: str) -> Iterator[str]:
        """The states in a composite, and the transitions between them."""
        for number, child in enumerate(self.chart.children(state.label)):
            if number and state.type is StateType.AND:
                yield f"{indent}--"
            yield from self.state(child, indent)
        for child in self.chart.children(state.label):
            for transition in self.chart.outgoing(child.label):
                if transition.expression is not NEVER:
                    yield indent + self.arrow(transition)
            stays = (*self.chart.exits_of(child.label), *self.chart.abandons.get(child.label, ()))
            for transition in stays:
                yield indent + self.arrow(transition)

    def arrow(self, transition: Transition) -> str:
        text = self.quoted(transition_text(transition))
        if not transition.changes_state:
            return self.note(self.names.id_of(self.chart.node(transition.source)), text)
        source, target = (self._end(label) for label in (transition.source, transition.target))
        return f"{source} --> {target} : {text}" if text else f"{source} --> {target}"

    def _end(self, label: str) -> str:
        state = self.chart.node(label)
        return "[*]" if state.type in (StateType.START, StateType.END) else self.names.id_of(state)


__all__ = ["Sketch", "crossings", "shown"]
