"""Following: what the transitions that a chart has taken have left and entered, in that order.

A chart says which transitions it took (`Outcome.taken`). What they left and entered, also inside one step,
follows by the rules of the semantics page ("Transitions"); nothing is decided here.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field

from aseme_dsl.runtime.plan import Plan


@dataclass(frozen=True, slots=True)
class Change:
    """The states that one transition left, innermost first, and entered, outermost first."""

    left: tuple[str, ...] = ()
    entered: tuple[str, ...] = ()


@dataclass(slots=True)
class Following:
    """The active states of a chart, kept up to date with what it takes."""

    plan: Plan
    active: set[str] = field(default_factory=set)
    """The labels of all active states, points (START, END) among them."""
    kept: dict[str, frozenset[str]] = field(default_factory=dict)
    """Of states that may be resumed, and were left before they were complete: what was active in them."""

    def begin(self) -> Change:
        """The root is entered."""
        return Change((), self._enter(self.plan.states[0].label, (), None))

    def stand(self, leaves: Iterable[str]) -> None:
        """The chart stands here, without anything having been left or entered: another one has brought it."""
        self.active = {around for leaf in leaves for around in _around(leaf)}

    def take(self, numbers: Sequence[int]) -> Change:
        """The chart has taken a transition, or the parts of a compound one."""
        parts = [self.plan.transitions[number] for number in numbers]
        if parts[0].kind != "way":
            return Change()
        target = parts[-1].target
        scope = min((self._scope(part.source, part.target) for part in parts), key=len)
        left = self._leave(scope)
        again = self.kept.pop(target, None) if parts[-1].resume else None
        if target in self.plan.branch_labels:
            again = None
        inside = [label for label in _around(target) if len(label) > len(scope)]
        return Change(left, self._enter(inside[0], inside[1:], again))

    def end(self) -> Change:
        """Everything is left."""
        left = sorted(self.active, key=_innermost_first)
        self.active = set()
        return Change(tuple(left))

    def is_complete(self, label: str) -> bool:
        """Whether a composite has come to its end: an AND when all its regions have."""
        stack = [label]
        while stack:
            at = stack.pop()
            children = self.plan.inside.get(at, ())
            if self.plan.by_label[at].type == "AND":
                stack += [child.label for child in children]
            elif not any(child.type == "END" and child.label in self.active for child in children):
                return False
        return True

    def _scope(self, source: str, target: str) -> str:
        """The lowest OR state that holds source and target."""
        around = set(_around(target)[:-1])
        holding = (label for label in reversed(_around(source)[:-1]) if label in around)
        return next(label for label in holding if self.plan.by_label[label].type == "OR")

    def _leave(self, scope: str) -> tuple[str, ...]:
        """Leave all that is active inside a state."""
        left = sorted((label for label in self.active if label.startswith(f"{scope}.")), key=_innermost_first)
        for label in self.plan.resumed:
            if label in self.active and label.startswith(f"{scope}."):
                self.kept.pop(label, None)
                if not self.is_complete(label):
                    self.kept[label] = frozenset(item for item in left if item.startswith(f"{label}."))
        self.active.difference_update(left)
        return tuple(left)

    def _enter(self, label: str, path: Sequence[str], again: frozenset[str] | None) -> tuple[str, ...]:
        """Enter a state: inside it the states of the path, then what was active there, else its START."""
        wanted = {*path, *(again or ())}
        entered: list[str] = []
        stack = [label]
        while stack:
            at = stack.pop()
            entered.append(at)
            children = self.plan.inside.get(at, ())
            if at in self.plan.branch_labels:
                # What is remembered inside a conversation is of another one.
                self.kept = {key: value for key, value in self.kept.items() if not key.startswith(f"{at}.")}
                if not any(item.startswith(f"{at}.") for item in path):
                    wanted = {item for item in wanted if not item.startswith(f"{at}.")}
            match self.plan.by_label[at].type:
                case "AND":
                    stack += [child.label for child in reversed(children)]
                case "OR":
                    inside = [child.label for child in children if child.label in wanted]
                    stack += inside or [child.label for child in children if child.type == "START"]
        self.active.update(entered)
        return tuple(entered)


def _around(label: str) -> tuple[str, ...]:
    """A state and those around it, the outermost first."""
    parts = label.split(".")
    return tuple(".".join(parts[:end]) for end in range(1, len(parts) + 1))


def _innermost_first(label: str) -> tuple[float, ...]:
    """Orders states as they are left: what is inside before what is around it, else in document order."""
    return (*map(int, label.split(".")), float("inf"))
