"""Standing still: states that are left by conditions alone, of which nothing can change what they read.

An outcome stays as it is until its activity runs again, and a variable until something writes it. Where what
may do so has to wait for this very state, a condition that does not hold never will.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from aseme_dsl.amola import expression as e
from aseme_dsl.amola.srm import Activity
from aseme_dsl.amola.statechart import State, Statechart, StateType, Transition, TransitionKind
from aseme_dsl.compiler.formula.formulas import cut
from aseme_dsl.diagnostics import Diagnostic, Related
from aseme_dsl.diagnostics.problems.expressions.conditions import MayWaitForEver
from aseme_dsl.proofs.prover import Prover
from aseme_dsl.proofs.ways import interruptions


def check_standing_still(
    chart: Statechart, activities: Mapping[str, Activity], prover: Prover
) -> tuple[Diagnostic, ...]:
    """W438: a state whose only way on has a condition that may be false for ever. Needs z3."""
    found: list[Diagnostic] = []
    for state in chart.states:
        if state.type in (StateType.CONDITION, StateType.END):
            continue
        ways = _ways(chart, state)
        if ways is None:
            continue
        surroundings = _Surroundings(chart, state, activities)
        if all(surroundings.keep(condition) for condition in ways) and prover.is_there:
            facts = _falsified(ways, prover)
            if facts is not None:
                found.append(_diagnostic(chart, state, ways[0], facts))
    return tuple(found)


def _ways(chart: Statechart, state: State) -> tuple[e.Value, ...] | None:
    """The conditions of all that leads on from a state; None if an event, time or nothing at all does.

    Transitions to several states are a choice, of which the gaps are reported by themselves.
    """
    own = [item for item in chart.outgoing_edges(state.label) if not item.reactive]
    if not own or len({item.targets for item in own}) > 1:
        return None
    if any(item.expression.when for item in own):
        return None  # what the state itself does may change the condition
    conditions: list[e.Value] = []
    for transition in _on_and_away(chart, state, own):
        expression = transition.expression
        if expression.events:
            if all(isinstance(event, e.Failed) for event in expression.events):
                continue  # nothing fails in a state that is complete
            return None
        if expression.condition is None or expression.otherwise:
            return None
        conditions.append(expression.condition)
    return tuple(conditions) or None


def _on_and_away(chart: Statechart, state: State, own: Sequence[Transition]) -> Iterator[Transition]:
    """The ways on, and then those that lead away: to find these takes long in deep charts."""
    yield from own
    for path in interruptions(chart, state.label):
        yield path.segments[0]


class _Surroundings:
    """What may happen beside a state while it waits."""

    def __init__(self, chart: Statechart, state: State, activities: Mapping[str, Activity]) -> None:
        self.chart = chart
        self.state = state
        self.beside = {item.label for item in chart.states if _are_concurrent(chart, item.label, state.label)}
        around = {item.label for item in chart.ancestors(state.label)} | {state.label}
        self.performed = {
            item.activity for item in chart.states if item.label in self.beside and item.activity is not None
        }
        self.written: set[str] = set()
        for transition in chart.transitions:
            stays = transition.kind is TransitionKind.ON and transition.source in around
            if transition.source in self.beside or stays:
                self.written.update(_written_by(transition))
        said = [activities[name] for name in self.performed if name in activities]
        for item in (*said, *(module.statement for module in chart.modules)):
            self.written.update(item.writes_variables)
        # The code of a participant's activities may set its variables without saying so.
        self.is_silent = all(name in activities and activities[name].simulated for name in self.performed)
        self.is_pulled_out = any(
            transition.source in self.beside and state.label.startswith(f"{chart.scope_of(transition)}.")
            for transition in chart.transitions
            if transition.changes_state and _leads_out(chart, transition, state)
        )

    def keep(self, condition: e.Value) -> bool:
        """Whether the condition is one that what happens beside the state cannot change."""
        if self.is_pulled_out:
            return False
        reads = False
        for value in e.walk(condition):
            match value:
                case e.Outcome(activity=activity):
                    reads = True
                    if activity in self.performed:
                        return False
                case e.VariableValue(name=name):
                    reads = True
                    bare, _, scope = name.partition("@")
                    if bare in self.written or name in self.written or (scope and not self.is_silent):
                        return False
                    if not any(name in _written_by(item) for item in self.chart.transitions):
                        return False  # that nothing sets it is a problem of its own
                case e.Literal() | e.EnumConstant() | e.Not() | e.Logic() | e.Compare() | e.Arithmetic():
                    pass
                case e.Negate() | e.Named():
                    pass
                case _:
                    return False
        return reads


def _written_by(transition: Transition) -> Iterator[str]:
    for action in transition.expression.actions:
        if isinstance(action, e.Assign) and isinstance(action.target, e.VariableValue):
            yield action.target.name


def _are_concurrent(chart: Statechart, one: str, other: str) -> bool:
    """Whether two states are in different regions of one AND."""
    first, second = one.split("."), other.split(".")
    common = 0
    while common < min(len(first), len(second)) and first[common] == second[common]:
        common += 1
    if common in (len(first), len(second)):
        return False
    return chart.node(".".join(first[:common])).type is StateType.AND


def _leads_out(chart: Statechart, transition: Transition, state: State) -> bool:
    """Whether a transition leaves the AND around its source and a state beside it."""
    return not _are_concurrent(chart, transition.target, state.label)


def _falsified(conditions: Sequence[e.Value], prover: Prover) -> tuple[str, ...] | None:
    """Values with which none of the conditions holds, in words; None if there are none, or if none ever
    holds, which is a problem of its own."""
    from aseme_dsl.proofs.solver import Assumptions, Claim, Undecided  # costs time, and z3

    snapshot = prover.snapshot(tuple(conditions))
    try:
        if not any(snapshot.is_possible(Claim((condition,))) for condition in conditions):
            return None
        witness = snapshot.witness(
            Claim((), tuple((item,) for item in conditions)), Assumptions(present=True)
        )
    except Undecided:
        return None
    return None if witness is None else witness.facts


def _diagnostic(chart: Statechart, state: State, condition: e.Value, facts: tuple[str, ...]) -> Diagnostic:
    name = cut(state.name) if state.type is not StateType.START else None
    related = (Related(state.span, f"`{name}` ends here"),) if name is not None else ()
    outcomes = any(isinstance(value, e.Outcome) for value in e.walk(condition))
    return Diagnostic(MayWaitForEver(name, facts, outcomes), condition.span, related)


__all__ = ["check_standing_still"]
