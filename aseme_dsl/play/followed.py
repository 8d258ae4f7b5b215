"""Followed: what is known of one agent of a run: where it is, and what it has received."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import field

from aseme_dsl.play.evaluate import Told
from aseme_dsl.play.sight.insight import Insight
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.plan import Plan, State, is_in


@dataclass(slots=True)
class Followed:
    """What is known of an agent."""

    active: frozenset[str] = frozenset()
    """The labels of the active states, with those around them."""
    leaves: tuple[str, ...] = ()
    """The labels of the innermost active states."""
    newest: dict[tuple[str, str | None], tuple[Told, int]] = field(default_factory=dict)
    measured: dict[tuple[str, str | None], list[tuple[Told, int]]] = field(default_factory=dict)
    """What has come on the channels whose history a condition asks for, by time of measurement."""
    entries: dict[str, int] = field(default_factory=dict)
    """How often states were entered since their loops began, of those that a condition counts."""
    has_begun: bool = False

    def forget(self) -> None:
        """It has crashed: it is in no state, and knows nothing."""
        self.active = frozenset()
        self.leaves = ()
        self.newest.clear()
        self.measured.clear()
        self.entries.clear()

    def receive(self, channel: str, sender: str, content: Told, measured: int, keeps: bool) -> None:
        """A message has come on a channel; `keeps`: its history is asked for."""
        for who in (None, sender):
            self.newest[channel, who] = content, measured
            if keeps:
                known = self.measured.setdefault((channel, who), [])
                known.append((content, measured))
                known.sort(key=lambda item: item[1])

    def count(self, plan: Plan, states: Iterable[str], entered: Iterable[str]) -> None:
        """A transition has entered states: count those of these names."""
        labels = set(entered)
        for state in states:
            for node in named(plan, state):
                loop = _loop_of(plan, node)
                if loop != node.label and loop in labels:
                    self.entries[node.label] = 0
                if node.label in labels:
                    self.entries[node.label] = self.entries.get(node.label, 0) + 1


def named(plan: Plan, name: str) -> Sequence[State]:
    """The states that a question means by a name, which may be that of their activity."""
    return [state for state in plan.states if name in (state.name, state.activity)]


def answer(inside: Insight, followed: Followed, question: str, name: str) -> object:
    """The value of `in(T)`, `done(T)` or `count(T)`."""
    plan = inside.plan
    active = [state for state in named(plan, name) if state.label in followed.active]
    if question == "count":
        first = next(iter(named(plan, name)), None)
        return 0 if first is None else followed.entries.get(first.label, 0)
    if question == "in":
        return bool(active)
    return any(_is_complete(inside, followed.active, state) for state in active)


def _is_complete(inside: Insight, active: frozenset[str], state: State) -> bool:
    if state.type == "BASIC":
        return inside.has_returned(state.label)
    plan = inside.plan
    parts = plan.children(state.label) if state.type == "AND" else (state,)
    return bool(parts) and all(_has_ended(plan, active, part) for part in parts)


def _has_ended(plan: Plan, active: frozenset[str], region: State) -> bool:
    return any(item.type == "END" and item.label in active for item in plan.children(region.label))


def _loop_of(plan: Plan, state: State) -> str:
    """The state whose entry sets the count of another to 0 (see `amola.meant.loop_of`)."""
    regions = {region.label for region in plan.regions}
    label = state.label
    while label not in regions:
        parent = plan.by_label[label].parent
        assert parent is not None
        if any(way.source == way.target == label and way.kind == "external" for way in plan.transitions):
            return parent
        label = parent
    return label


def around(label: str) -> Iterator[str]:
    """A label, and those of the states around it."""
    parts = label.split(".")
    return (".".join(parts[:end]) for end in range(1, len(parts) + 1))


def entered_by(plan: Plan, numbers: Iterable[int]) -> set[str]:
    """The labels of the states that transitions enter, also those that are left again in the same step."""
    found: set[str] = set()
    for number in numbers:
        item = plan.transitions[number]
        if item.kind == "external":
            for target in (item.target, *item.into):
                found |= {label for label in around(target) if not is_in(item.source, label)}
                found.add(target)
    return found


__all__ = ["Followed", "answer", "around", "entered_by", "named"]
