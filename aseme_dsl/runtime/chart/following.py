"""Following: what the transitions that a chart has taken have left and entered, in that order.

A chart says which transitions it took (`Outcome.taken`). What they left and entered, also inside one step,
follows by the rules of the semantics page ("Transitions"); nothing is decided here.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import field

from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.plan import Plan, Transition


@dataclass(frozen=True, slots=True)
class Change:
    """The states that one transition left, innermost first, and entered, outermost first."""

    left: tuple[str, ...] = ()
    entered: tuple[str, ...] = ()


NOTHING = Change()


class Shape:
    """What is the same for all who follow a plan, worked out once."""

    def __init__(self, plan: Plan) -> None:
        self.plan = plan
        order = sorted((state.label for state in plan.states), key=_innermost_first)
        self.rank = {label: number for number, label in enumerate(order)}
        """The states in the order in which they are left."""
        self._ways: dict[tuple[int, ...], tuple[str, str, tuple[str, ...]]] = {}
        self._entered: dict[tuple[str, ...], tuple[str, ...]] = {}

    def way(self, numbers: tuple[int, ...]) -> tuple[str, str, tuple[str, ...]]:
        """Of a transition, or the parts of a compound one: its scope, its target, and what is around that
        inside the scope; all empty for one that leads nowhere. The outermost comes first, and what leads into
        several regions of the target last.
        """
        found = self._ways.get(numbers)
        if found is None:
            found = self._ways[numbers] = self._way([self.plan.transitions[number] for number in numbers])
        return found

    def _way(self, parts: Sequence[Transition]) -> tuple[str, str, tuple[str, ...]]:
        if parts[0].kind != "external":
            return "", "", ()
        target = parts[-1].target
        scope = min((self._scope(part.source, part.target) for part in parts), key=len)
        led = dict.fromkeys(item for label in (target, *parts[-1].into) for item in _around(label))
        return scope, target, tuple(label for label in led if len(label) > len(scope))

    def _scope(self, source: str, target: str) -> str:
        """The lowest OR state that holds source and target."""
        around = set(_around(target)[:-1])
        holding = (label for label in reversed(_around(source)[:-1]) if label in around)
        return next(label for label in holding if self.plan.by_label[label].type == "OR")

    def region(self, label: str) -> str:
        """The innermost region around a state."""
        plan = self.plan
        around = reversed(_around(label))
        return next(
            item
            for item in around
            if (parent := plan.by_label[item].parent) is None or plan.by_label[parent].type == "AND"
        )

    def branches_in(self, label: str) -> set[str]:
        """The branches of participants that a state is or has inside."""
        return {branch for branch in self.plan.branch_labels if f"{branch}.".startswith(f"{label}.")}

    def entered(
        self,
        path: tuple[str, ...],
        again: frozenset[str] | None = None,
        suspended: frozenset[str] = frozenset(),
    ) -> tuple[str, ...]:
        """What is entered on the way to the last states of a path: inside them what was active, else what
        begins there. A branch begins anew unless it is suspended."""
        if again is not None:
            return self._all_entered(path, again, suspended)
        found = self._entered.get(path)
        if found is None:
            found = self._entered[path] = self._all_entered(path, frozenset(), frozenset())
        return found

    def _all_entered(
        self, path: tuple[str, ...], again: frozenset[str], suspended: frozenset[str]
    ) -> tuple[str, ...]:
        plan = self.plan
        wanted = {*path, *again}
        entered: list[str] = []
        stack = [path[0]]
        while stack:
            at = stack.pop()
            entered.append(at)
            children = plan.inside.get(at, ())
            anew = at in plan.branch_labels and at not in suspended
            if anew and not any(item.startswith(f"{at}.") for item in path):
                # What is remembered inside a conversation is of another one.
                wanted = {item for item in wanted if not item.startswith(f"{at}.")}
            match plan.by_label[at].type:
                case "AND":
                    stack += [child.label for child in reversed(children)]
                case "OR":
                    inside = [child.label for child in children if child.label in wanted]
                    stack += inside or [child.label for child in children if child.type == "START"]
        return tuple(entered)


@dataclass(slots=True)
class Following:
    """The active states of a chart, kept up to date with what it takes."""

    shape: Shape
    active: set[str] = field(default_factory=set)
    """The labels of all active states, points (START, END) among them."""
    kept: dict[str, frozenset[str]] = field(default_factory=dict)
    """Of states that may be resumed, and were left before they were complete: what was active in them."""

    suspended: set[str] = field(default_factory=set)
    """The branches of participants that were left and may be resumed."""

    def begin(self) -> Change:
        """The root is entered."""
        return Change((), self._enter(self.shape.entered((self.shape.plan.states[0].label,))))

    def stand(self, leaves: Iterable[str]) -> None:
        """The chart stands here, without anything having been left or entered: another one has brought it."""
        self.active = {around for leaf in leaves for around in _around(leaf)}

    def take(self, numbers: tuple[int, ...]) -> Change:
        """The chart has taken a transition, or the parts of a compound one."""
        scope, target, path = self.shape.way(numbers)
        if not path:
            return NOTHING
        plan = self.shape.plan
        left = self._leave(scope)
        resumes = plan.transitions[numbers[-1]].resume
        again = self.kept.pop(target, None) if resumes else None
        for label in path:
            if label in plan.resumed and not (resumes and label == target):
                self.suspended -= self.shape.branches_in(label) - (
                    self.shape.branches_in(target) if resumes else set()
                )
        if target in plan.branch_labels and target not in self.suspended:
            again = None
        entered = self.shape.entered(path, again, frozenset(self.suspended))
        for label in entered:
            if label in plan.resumed and label not in path and label not in (again or ()):
                self.suspended -= self.shape.branches_in(label)
        return Change(left, self._enter(entered))

    def end(self) -> Change:
        """Everything is left."""
        left = sorted(self.active, key=self.shape.rank.__getitem__)
        self.active = set()
        return Change(tuple(left))

    def is_complete(self, label: str) -> bool:
        """Whether a composite has come to its end: an AND when all its regions have."""
        plan = self.shape.plan
        stack = [label]
        while stack:
            at = stack.pop()
            children = plan.inside.get(at, ())
            if plan.by_label[at].type == "AND":
                stack += [child.label for child in children]
            elif not any(child.type == "END" and child.label in self.active for child in children):
                return False
        return True

    def _leave(self, scope: str) -> tuple[str, ...]:
        """Leave all that is active inside a state."""
        within = f"{scope}."
        left = [label for label in self.active if label.startswith(within)]
        left.sort(key=self.shape.rank.__getitem__)
        held: set[str] = set()
        for label in self.shape.plan.resumed:
            if label in self.active and label.startswith(within):
                self.kept.pop(label, None)
                if not self.is_complete(label):
                    self.kept[label] = frozenset(item for item in left if item.startswith(f"{label}."))
                    if self.shape.region(label) in _around(scope):
                        held |= self.shape.branches_in(label)
        for label in self.shape.plan.resumed:
            if self.shape.region(label) in left:
                self.suspended -= self.shape.branches_in(label) - held
        self.suspended |= {label for label in held.intersection(left) if not self.is_complete(label)}
        self.active.difference_update(left)
        return tuple(left)

    def _enter(self, entered: tuple[str, ...]) -> tuple[str, ...]:
        if self.kept:
            anew = self.shape.plan.branch_labels - self.suspended
            branches = [label for label in entered if label in anew]
            for key in [key for key in self.kept if any(key.startswith(f"{label}.") for label in branches)]:
                del self.kept[key]
        self.suspended.difference_update(entered)
        self.active.update(entered)
        return entered


def _around(label: str) -> tuple[str, ...]:
    """A state and those around it, the outermost first."""
    parts = label.split(".")
    return tuple(".".join(parts[:end]) for end in range(1, len(parts) + 1))


def _innermost_first(label: str) -> tuple[float, ...]:
    """Orders states as they are left: what is inside before what is around it, else in document order."""
    return (*map(int, label.split(".")), float("inf"))
