"""Choice: which choices of a statechart are looked at, and what may be found: overlaps, gaps, dead branches.

What is worth saying is decided here, once:

- Two branches that can both hold are an overlap, unless the author has shown that their order is meant. A
  choice that ends in a branch without a condition (`else`) is read as "if … else if … else". A special case
  before the general one cannot be meant otherwise. Of `when`, only what shares something it reads.
- A gap is a snapshot in which no branch opens after any wait. All messages are there but those of which the
  choice asks `has(…)`, timers have run out, ages are old. An event, a timeout, a signal, or a state around it
  that may be left, ends the wait. One condition alone is a wait that was meant.
- A condition that reads nothing, like `true`, is as its author wants it: it counts as none.
- What a list holds is not known but for its size: a choice that asks for its elements is not looked at.
- What a declared function returns is not known. If a finding depends on it together with what the function
  itself looks at, it is not reported.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from aseme_dsl.amola import expression as e
from aseme_dsl.amola.messages import Kind
from aseme_dsl.amola.statechart import Statechart, Transition
from aseme_dsl.proofs.unknowns import (
    Vocabulary,
    identity,
    is_beyond,
    is_unknown_function,
    reads_signal,
    sources,
)
from aseme_dsl.proofs.ways import COMPLETION, MOST, Fork, forks, interruptions, paths
from aseme_dsl.records import dataclass

if TYPE_CHECKING:
    from aseme_dsl.proofs.solver import Way, Witness


@dataclass(frozen=True, slots=True)
class Overlap:
    """`first` and any of `seconds`, which are tried later, can both hold: with the witness, the first two."""

    first: Transition
    seconds: tuple[Transition, ...]
    witness: Witness


@dataclass(frozen=True, slots=True)
class Gap:
    """No branch of a fork holds, however long it waits; `waits`: only while a message is absent."""

    fork: Fork
    witness: Witness
    waits: bool


@dataclass(frozen=True, slots=True)
class Never:
    """The condition cannot hold; with `before`, not together with the conditions on the way to it."""

    transition: Transition
    before: tuple[e.Value, ...]


@dataclass(frozen=True, slots=True)
class Covered:
    """Whenever it could be taken, one of `by` is tried first and open."""

    transition: Transition
    by: tuple[Transition, ...]


@dataclass(frozen=True, slots=True)
class Always:
    """The condition holds whenever what it reads is there."""

    transition: Transition


@dataclass(frozen=True, slots=True)
class Unsure:
    """A question about these transitions could not be decided within the budget."""

    transitions: tuple[Transition, ...]


Finding = Overlap | Gap | Never | Covered | Always | Unsure


def situations(chart: Statechart, vocabulary: Vocabulary) -> tuple[Situation, ...]:
    """The forks of a chart of which there is anything to ask. What is expanded twice has the same `key`.

    Branches with weights are all open together, as they shall be.
    """
    return tuple(
        Situation(chart, fork, _closers(chart, fork))
        for fork in forks(chart)
        if all(branch.expression.weight is None for branch in fork.branches)
        and _is_worth_it(fork, vocabulary)
    )


# ---- the situation -----------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Situation:
    """A fork, and what else may end the wait at it: None if a gap of it would be no mistake."""

    chart: Statechart
    fork: Fork
    closers: tuple[Way, ...] | None

    @property
    def key(self) -> tuple[object, ...]:
        closers = self.closers or ()
        return (
            tuple(_written(branch) for branch in self.fork.branches),
            tuple(item.span for item in self.fork.before),
            self.closers is None,
            tuple(item.span for way in closers for item in way),
        )

    @property
    def timers(self) -> frozenset[str]:
        """The timers that the region starts: those of others never run out here."""
        region = self.chart.region_of(self.fork.state)
        return frozenset(
            action.timer
            for transition in self.chart.transitions
            for action in transition.expression.actions
            if isinstance(action, e.StartTimer) and self.chart.region_of(transition.source) == region
        )


def _written(transition: Transition) -> tuple[object, ...]:
    return (transition.expression.span or transition.span, transition.priority)


def asks(branch: Transition) -> bool:
    """Whether it has a condition that reads something."""
    condition = branch.expression.condition
    return condition is not None and any(
        isinstance(
            part,
            e.Member
            | e.Bound
            | e.Sender
            | e.LossReason
            | e.VariableValue
            | e.Expired
            | e.Outcome
            | e.StateValue
            | e.RoundValue
            | e.Index
            | e.Call
            | e.Element,
        )
        for part in e.walk(condition)
    )


def ends_open(fork: Fork) -> bool:
    """Whether some branch needs no condition: `else`, or what is done when nothing else is."""
    return not all(asks(branch) for branch in fork.branches)


def _closers(chart: Statechart, fork: Fork) -> tuple[Way, ...] | None:
    if fork.trigger != COMPLETION or ends_open(fork):
        return None
    if len({branch.targets for branch in fork.branches}) < 2:
        return None  # a wait
    own = paths(chart, fork.state)
    if len(own) >= MOST:
        return None
    found: list[Way] = []
    for path in (*own, *interruptions(chart, fork.state)):
        events = path.events - {"error"}
        if events:
            return None
        if path.events or any(segment in fork.branches for segment in path.segments):
            continue  # nothing fails in a state that is complete
        if not path.conditions:
            return None
        found.append(path.conditions)
    own_conditions = tuple(item.expression.condition for item in fork.branches)
    for condition in (*own_conditions, *(condition for way in found for condition in way)):
        if condition is not None and (
            reads_signal(condition) or _asks_of_states(condition) or is_beyond(condition)
        ):
            return None
    return tuple(found)


def _asks_of_states(condition: e.Value) -> bool:
    """Whether it waits for what else the agent does, or for answers."""
    return any(isinstance(part, e.StateValue | e.RoundValue) for part in e.walk(condition))


def _is_worth_it(fork: Fork, vocabulary: Vocabulary) -> bool:
    """Whether there is anything to ask.

    Conditions that have nothing to do with each other hold and fail in any combination: that matters only
    where each of several branches has one.
    """
    asking = [branch.expression.condition for branch in fork.branches if asks(branch)]
    if any(is_beyond(item) for item in (*fork.before, *asking) if item is not None):
        return False
    conditions = [*fork.before, *(condition for condition in asking if condition is not None)]
    if len(asking) > 1 and not ends_open(fork):
        return True
    return bool(asking) and not are_free(conditions, vocabulary)


def are_free(conditions: Sequence[e.Value], vocabulary: Vocabulary) -> bool:
    """Whether they plainly hold and fail in any combination: each unknown is read once, beside a constant."""
    atoms: list[e.Value] = []
    stack = list(conditions)
    while stack:
        item = stack.pop()
        if isinstance(item, e.Named):
            stack.append(item.expression)
        elif isinstance(item, e.Not | e.Logic):
            stack.extend(e.operands(item))
        else:
            atom = _free_atom(item, vocabulary)
            if atom is None:
                return False
            atoms.append(atom)
    asked = {source for atom in atoms if isinstance(atom, e.Has) for source in sources(atom)}
    read = {source for atom in atoms if not isinstance(atom, e.Has) for source in sources(atom)}
    return len({identity(atom) for atom in atoms}) == len(atoms) and not asked & read


def _free_atom(value: e.Value, vocabulary: Vocabulary) -> e.Value | None:
    """What a leaf of a condition reads, if it can have any value and the leaf be true and false."""
    atom = value
    if isinstance(value, e.Compare):
        constants = e.Literal | e.EnumConstant
        atom, other = (
            (value.right, value.left) if isinstance(value.left, constants) else (value.left, value.right)
        )
        kind = atom.type.kind
        if not isinstance(other, constants) or kind in (Kind.STRING, Kind.BYTES, Kind.AGENT):
            return None
        enum = vocabulary.enums.get(atom.type.name)
        if kind is Kind.OUTCOME and len(vocabulary.outcomes[atom.type.name]) < 2:
            return None
        if kind is Kind.ENUM and (enum is None or len({number for _, number in enum.constants}) < 2):
            return None
    while isinstance(atom, e.Named):
        atom = atom.expression
    if isinstance(atom, e.Call):
        plain = all(
            isinstance(part, e.Call | e.Member | e.Bound | e.VariableValue | e.Literal)
            for part in e.walk(atom)
        )
        return atom if is_unknown_function(atom) and plain else None
    kinds = e.Member | e.Bound | e.VariableValue | e.Expired | e.Outcome | e.StateValue | e.RoundValue
    kinds |= e.Index | e.Has
    if isinstance(atom, e.Has) and atom.message.path:
        return None  # it depends on the message around it, too
    return atom if isinstance(atom, kinds) else None


__all__ = [
    "Always",
    "Covered",
    "Finding",
    "Gap",
    "Never",
    "Overlap",
    "Situation",
    "Unsure",
    "asks",
    "ends_open",
    "situations",
]
