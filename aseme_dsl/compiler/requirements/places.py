"""Places: which states of the roles' statecharts scenarios and properties mean by a name."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from aseme_dsl.amola.statechart import State, Statechart
from aseme_dsl.compiler.read.blocks import Blocks
from aseme_dsl.records import dataclass


@dataclass(frozen=True, slots=True)
class Places:
    """Which states of the roles' statecharts a name means."""

    charts: Mapping[str, Statechart]
    blocks: Blocks
    aliases: frozenset[str]

    def labels(
        self, role: str, name: str, participant: str | None, protocol: str | None = None
    ) -> frozenset[str]:
        """The labels of the states of a role that have the name (in the participant's branches).

        With a `protocol`, only its branches count: participants of other protocols may have the same names.
        """
        chart = self.charts[role]
        if participant is None:
            names = {name}
        else:
            names = {name, *self._bound(role, name, participant, protocol)}
        inside = [
            node.label
            for node in chart.states
            if participant is not None
            and chart.is_branch(node)
            and participant in (node.origin.name, node.name)
            and protocol in (None, node.origin.owner)
        ]
        found = [
            node
            for node in chart.states
            if participant is None or any(f"{node.label}.".startswith(f"{label}.") for label in inside)
        ]
        own = {node.label for node in found if names & self._called(node)}
        own |= {node.label for node in found if chart.is_branch(node) and node.origin.name in names}
        if name == chart.name:
            own.add(chart.states[0].label)
        return frozenset(own or _outermost(node.label for node in found if node.origin.name in names))

    def _called(self, node: State) -> set[str]:
        return called(node.name, self.aliases) | {node.activity or ""}

    def _bound(self, role: str, name: str, participant: str, protocol: str | None) -> Iterator[str]:
        """What the role puts in the place of an abstract activity of the participant."""
        for item in self.blocks.srms:
            for part in item.plays if item.name.text == role else ():
                alias = part.alias.text if part.alias is not None else ""
                if participant in (part.participant.text, alias) and protocol in (None, part.protocol.text):
                    for binding in part.bindings:
                        if binding.own is not None and name in called(binding.abstract.text, self.aliases):
                            yield binding.own.text


def called(name: str, aliases: Iterable[str]) -> set[str]:
    """The name that something has in the models, also without the aliases of its file."""
    found: set[str] = set()
    waiting = [name]
    while waiting:
        name = waiting.pop()
        found.add(name)
        waiting += (name[len(alias) + 1 :] for alias in aliases if name.startswith(f"{alias}_"))
    return found


def _outermost(labels: Iterable[str]) -> set[str]:
    found = set(labels)
    return {label for label in found if label.rpartition(".")[0] not in found}


__all__ = ["Places", "called"]
