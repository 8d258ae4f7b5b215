"""Findings: what z3 says of one choice, question by question."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from aseme_dsl.amola import expression as e
from aseme_dsl.amola.messages import Kind
from aseme_dsl.amola.statechart import Statechart, StateType, Transition
from aseme_dsl.proofs.choice import (
    Always,
    Covered,
    Finding,
    Gap,
    Never,
    Overlap,
    Situation,
    Unsure,
    asks,
    ends_open,
)
from aseme_dsl.proofs.prover import Prover
from aseme_dsl.proofs.solver import Assumptions, Claim, Snapshot, Undecided, Way, Witness, calls_in
from aseme_dsl.proofs.states import facts_of_states
from aseme_dsl.proofs.unknowns import CALL, PRESENCES, Key, identity, is_unknown_function, sources
from aseme_dsl.proofs.ways import WHEN, paths
from aseme_dsl.records import dataclass


@dataclass(slots=True)
class _Question:
    """A situation with its snapshot, and what was found about it so far."""

    situation: Situation
    snapshot: Snapshot
    ways: dict[int, tuple[Way, ...]]
    """For each branch, by its place, the conditions of every compound transition that begins with it."""
    closed: set[int]
    """The branches that are never taken."""
    findings: list[Finding]
    unsure: bool = False
    """Whether some answer is not known."""

    def ask(self, claim: Claim, assumptions: Assumptions) -> bool | None:
        """Whether the claim is possible; None if that is not known."""
        try:
            return self.snapshot.is_possible(claim, assumptions)
        except Undecided:
            self.unsure = True
            return None

    def example(self, claim: Claim, assumptions: Assumptions) -> Witness | None:
        """The simplest values that make the claim true; None if there are none, or none is known."""
        try:
            return self.snapshot.witness(claim, assumptions)
        except Undecided:
            self.unsure = True
            return None

    @property
    def branches(self) -> tuple[Transition, ...]:
        return self.situation.fork.branches

    @property
    def before(self) -> Way:
        return self.situation.fork.before

    def condition(self, branch: int) -> e.Value | None:
        return self.branches[branch].expression.condition


_RAISING = Assumptions(raising=True)
_WITHOUT_FUNCTIONS = Assumptions(functions=False)


_MOST_BRANCHES = 64
_MOST_PARTS = 5000
"""How many branches a choice and how many parts its conditions may have to be looked at."""


def _size(conditions: Sequence[e.Value]) -> int:
    """How many parts there are; those of a declared function's arguments again for each such function."""
    parts = [part for condition in conditions for part in e.walk(condition)]
    calls = [sum(1 for _ in e.walk(part)) for part in parts if is_unknown_function(part)]
    return len(parts) + sum(calls) * len(calls) // 10


def findings(situation: Situation, prover: Prover) -> list[Finding]:
    """Everything that is worth saying about a choice. Raises ImportError without z3."""
    fork = situation.fork
    ways = {place: _ways(situation.chart, branch) for place, branch in enumerate(fork.branches)}
    items = [*fork.before, *(item for own in ways.values() for way in own for item in way)]
    items += [item for way in situation.closers or () for item in way]
    # Also of a branch into a choice that nothing leaves, which has no way.
    items += [item for branch in fork.branches if (item := branch.expression.condition) is not None]
    conditions = list({id(item): item for item in items}.values())
    if len(fork.branches) > _MOST_BRANCHES or _size(conditions) > _MOST_PARTS:
        return [Unsure(fork.branches)]
    facts = facts_of_states(situation.chart, fork.state, conditions)
    question = _Question(situation, prover.snapshot(conditions, facts), ways, set(), [])
    for step in (_nevers, _covers, _alwayses, _overlaps, _gap):
        question.findings += list(step(question))
    if question.unsure:
        question.findings.append(Unsure(fork.branches))
    return question.findings


def _ways(chart: Statechart, branch: Transition) -> tuple[Way, ...]:
    own = () if branch.expression.condition is None else (branch.expression.condition,)
    if chart.node(branch.target).type is not StateType.CONDITION:
        return (own,)
    return tuple((*own, *path.conditions) for path in paths(chart, branch.target))


def _nevers(question: _Question) -> Iterator[Finding]:
    """Conditions that cannot hold, by themselves or after what leads to them."""
    for place, branch in enumerate(question.branches):
        condition = question.condition(place)
        if condition is None or not asks(branch):
            continue
        if question.ask(Claim((*question.before, condition)), _RAISING) is False:
            question.closed.add(place)
            alone = question.before and question.ask(Claim((condition,)), _RAISING) is not False
            yield Never(branch, question.before if alone else ())


def _covers(question: _Question) -> Iterator[Finding]:
    """Branches whose condition implies that an earlier one is open."""
    for place, branch in enumerate(question.branches):
        earlier = [other for other in range(place) if asks(question.branches[other])]
        earlier = [other for other in earlier if other not in question.closed]
        if place in question.closed or not earlier or branch.expression.span is None:
            continue
        condition = question.condition(place)
        own = question.before if condition is None else (*question.before, condition)

        def is_covered(others: Sequence[int], own: Way = own) -> bool:
            ways = tuple(way for other in others for way in question.ways[other])
            return question.ask(Claim(own, ways), _RAISING) is False

        if not is_covered(earlier):
            continue
        for other in list(earlier):
            rest = [item for item in earlier if item != other]
            if rest and is_covered(rest):
                earlier = rest
        question.closed.add(place)
        yield Covered(branch, tuple(question.branches[other] for other in earlier))


def _alwayses(question: _Question) -> Iterator[Finding]:
    """Conditions that hold whenever what they read is there; not if that is what covers another branch."""
    covering = [item for found in question.findings if isinstance(found, Covered) for item in found.by]
    for place, branch in enumerate(question.branches):
        condition = question.condition(place)
        if condition is None or not asks(branch) or place in question.closed or branch in covering:
            continue
        if question.ask(Claim((), ((condition,),)), Assumptions(present=True)) is False:
            yield Always(branch)


def _overlaps(question: _Question) -> Iterator[Finding]:
    """For each branch the first one before it that can be open with it."""
    if ends_open(question.situation.fork):
        return
    later: dict[int, list[tuple[Transition, Witness]]] = {}
    for place, branch in enumerate(question.branches):
        for other in range(place):
            if place in question.closed or other in question.closed:
                continue
            first = question.branches[other]
            if first.targets == branch.targets and first.expression.actions == branch.expression.actions:
                continue
            witness = _overlap(question, other, place)
            if witness is not None:
                later.setdefault(other, []).append((branch, witness))
                break
    for other, found in later.items():
        branches = tuple(branch for branch, _ in found)
        yield Overlap(question.branches[other], branches, found[0][1])


def _overlap(question: _Question, first: int, second: int) -> Witness | None:
    one, two = question.condition(first), question.condition(second)
    assert one is not None and two is not None
    if question.situation.fork.trigger == WHEN and not sources(one) & sources(two):
        return None
    if question.ask(Claim((*question.before, one), ((two,),)), Assumptions()) is False:
        return None  # a special case before the general one
    for assumptions in (_WITHOUT_FUNCTIONS, Assumptions()):
        for way in question.ways[first]:
            for other in question.ways[second]:
                claim = Claim((*question.before, *way, *other))
                witness = question.example(claim, assumptions)
                if witness is not None and _is_sure(witness, claim, is_gap=False):
                    return witness
    return None


def _gap(question: _Question) -> Iterator[Finding]:
    """A snapshot in which nothing opens by itself."""
    closers = question.situation.closers
    if closers is None:
        return
    conditions = [question.condition(place) for place in range(len(question.branches))]
    own = tuple((condition,) for condition in conditions if condition is not None)
    claim = Claim(question.before, (*own, *closers))
    timers = question.situation.timers
    witness = question.example(claim, Assumptions(present=True, late=True, timers=timers))
    waits = False
    if witness is None and any(isinstance(part, e.Has) for item in claim.conditions for part in e.walk(item)):
        witness = question.example(claim, Assumptions(late=True, timers=timers))
        waits = True
    if witness is not None and _is_sure(witness, claim, is_gap=True):
        yield Gap(question.situation.fork, witness, waits)


# ---- what functions return ------------------------------------------------------------------------


def _is_sure(witness: Witness, claim: Claim, *, is_gap: bool) -> bool:
    """Whether the witness does not hang on what a function returns for values that it looks at itself.

    `[near(ball)]` and `[far(ball)]` may exclude each other; `[near(ball)]` and `[playing]` do not. Nor is it
    known that a function returns any number at all: for a gap, only what lies between those it is compared
    with counts.
    """
    calls = calls_in(witness, claim.conditions)
    for call in calls:
        own = identity(call)
        read = sources(call)
        for unknown in witness.decisive:
            if unknown.key != own and read & _source_of(unknown.key, calls):
                return False
        if is_gap and call.type.kind not in (Kind.BOOL, Kind.ENUM) and not _is_between(call, witness, claim):
            return False
    return True


def _source_of(key: Key, calls: Sequence[e.Call]) -> frozenset[Key]:
    if key[0] == CALL:
        return next(sources(call) for call in calls if identity(call) == key)
    if key[0] in PRESENCES:
        return frozenset()
    return frozenset({key, ("has", *key[1:3])})


def _is_between(call: e.Call, witness: Witness, claim: Claim) -> bool:
    """Whether a function's number lies between numbers that it is compared with, and only by their order."""
    key = identity(call)
    limits: list[float] = []
    for condition in claim.conditions:
        for part in e.walk(condition):
            if not isinstance(part, e.Compare):
                continue
            sides = (part.left, part.right)
            if not any(identity(inner) == key for side in sides for inner in e.walk(side)):
                continue
            if part.operator in ("==", "!="):
                return False
            limits += [
                side.value
                for side in sides
                if isinstance(side, e.Literal) and isinstance(side.value, int | float)
            ]
    value = witness.values[key]
    return bool(limits) and isinstance(value, int | float) and min(limits) <= value <= max(limits)


__all__ = ["findings"]
