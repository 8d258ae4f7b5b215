"""Conditions: what is said of conditions that cannot be right (W410 to W412, N711 to N713), found by z3."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from itertools import chain

from aseme_dsl.amola.expression import LOSS, LOSS_REASONS, Named, Value, walk
from aseme_dsl.amola.statechart import OriginKind, Statechart, StateType, Transition
from aseme_dsl.compiler.chart.flow import Contradict
from aseme_dsl.compiler.formula.formulas import cut
from aseme_dsl.compiler.names.symbols import Symbols
from aseme_dsl.compiler.read.builtins import NOWHERE
from aseme_dsl.compiler.read.memory import Memory
from aseme_dsl.compiler.read.pieces import InPieces
from aseme_dsl.diagnostics import Diagnostic, Related
from aseme_dsl.diagnostics.problems.expressions.conditions import (
    BranchesOverlap,
    BranchNeverTaken,
    ChoiceWaitsForMessage,
    ConditionAlwaysHolds,
    ConditionNeverHolds,
    ConditionsUndecided,
    NoBranchHolds,
)
from aseme_dsl.grammar.text import tree
from aseme_dsl.proofs.choice import (
    Always,
    Covered,
    Finding,
    Gap,
    Never,
    Overlap,
    Situation,
    Unsure,
    situations,
)
from aseme_dsl.proofs.prover import Prover
from aseme_dsl.proofs.unknowns import Vocabulary, identity
from aseme_dsl.source import Span

FROM_CONDITIONS = frozenset(("W410", "W411", "W412", "W438", "N711", "N712", "N713"))
"""The codes that are found only where z3 is installed."""


_SHOWN = 5
"""How many branches beside the first one are pointed at."""


def vocabulary_of(symbols: Symbols) -> Vocabulary:
    """What conditions can be about, without its places: these mean nothing to a prover."""
    messages = (
        replace(item, span=NOWHERE, fields=tuple(replace(member, span=NOWHERE) for member in item.fields))
        for item in symbols.messages
    )
    return Vocabulary(
        {item.name: replace(item, span=NOWHERE) for item in symbols.enums},
        {item.name: item for item in messages},
        {
            **{name: item.ends for name, item in symbols.activities.items() if item.ends},
            LOSS.name: LOSS_REASONS,
        },
    )


def check_conditions(
    charts: Iterable[Statechart], prover: Prover, memory: Memory
) -> InPieces[tuple[tuple[Diagnostic, ...], int]]:
    """What cannot be right in the conditions; and how many choices went unchecked, without z3."""
    once: dict[object, Situation] = {}  # the same text may be expanded in several places
    for found in (yield from memory.each_in_pieces(_situations, zip(charts), prover.vocabulary)):
        for key, situation in found:
            once.setdefault(key, situation)
    if not once or not prover.is_there:  # the first saves the time that z3 takes to be loaded
        return (), len(once)
    said = yield from memory.each_in_pieces(_said, zip(once.values()), prover)
    return tuple(chain.from_iterable(said)), 0


def without_ordered(
    found: Iterable[Diagnostic], blocks: Iterable[tree.Aip | tree.Srm | tree.Statechart]
) -> tuple[Diagnostic, ...]:
    """Without the overlaps in a `control … first`, where the order of the lines is meant."""
    ordered = [
        control.span
        for block in blocks
        if not isinstance(block, tree.Statechart)
        for control in block.controls
        if control.first
    ]

    def is_meant(item: Diagnostic) -> bool:
        place = item.span
        return (
            isinstance(item.problem, BranchesOverlap)
            and place is not None
            and any(
                span.source is place.source and span.start <= place.start and place.end <= span.end
                for span in ordered
            )
        )

    return tuple(item for item in found if not is_meant(item))


def _situations(chart: Statechart, vocabulary: Vocabulary) -> tuple[tuple[object, Situation], ...]:
    """The situations of a chart, each with what it is by."""
    return tuple((item.key, item) for item in situations(chart, vocabulary))


def _said(situation: Situation, prover: Prover) -> tuple[Diagnostic, ...]:
    from aseme_dsl.proofs.findings import findings  # costs time, and z3

    return tuple(
        _diagnostic(situation.chart, finding)
        for finding in findings(situation, prover)
        if not (
            isinstance(finding, Never | Always | Covered)
            and situation.chart.kind == "IAC"
            and _reads_input(finding.transition)
        )
    )


def _reads_input(transition: Transition) -> bool:
    """Whether a condition of a protocol may read an input, for which a role can supply a constant.

    An input is a named value, as a `let` is. The protocol's own chart, in which inputs are variables, is
    looked at first: it shows what is wrong with the condition itself.
    """
    condition = transition.expression.condition
    return (
        transition.origin.kind is OriginKind.PROTOCOL
        and condition is not None
        and any(isinstance(value, Named) for value in walk(condition))
    )


def _diagnostic(chart: Statechart, finding: Finding) -> Diagnostic:
    match finding:
        case Overlap():
            return _overlap(chart, finding)
        case Gap():
            return _gap(finding)
        case Never():
            return _never(finding)
        case Covered():
            return _covered(chart, finding)
        case Always(transition=transition):
            return Diagnostic(ConditionAlwaysHolds(), _condition(transition))
        case Unsure(transitions=transitions):
            first, *others = transitions
            return Diagnostic(ConditionsUndecided(), _condition(first), _related(others, "beside this"))


def _overlap(chart: Statechart, finding: Overlap) -> Diagnostic:
    second, *others = finding.seconds
    related = [Related(_condition(finding.first), f"{_target(chart, finding.first)} comes first")]
    related += _related(others, "so can this")
    return Diagnostic(BranchesOverlap(finding.witness.facts), _condition(second), tuple(related))


def _gap(finding: Gap) -> Diagnostic:
    first, *others = finding.fork.branches
    kind = ChoiceWaitsForMessage if finding.waits else NoBranchHolds
    return Diagnostic(kind(finding.witness.facts), _condition(first), _related(others, "nor this"))


def _never(finding: Never) -> Diagnostic:
    related = tuple(Related(item.span, "this must hold as well") for item in finding.before)
    return Diagnostic(ConditionNeverHolds(len(related)), _condition(finding.transition), related)


def _covered(chart: Statechart, finding: Covered) -> Diagnostic:
    expression = finding.transition.expression
    has_condition = expression.condition is not None
    return Diagnostic(
        BranchNeverTaken(expression.otherwise, has_condition, len(finding.by)),
        _condition(finding.transition),
        tuple(Related(_condition(item), f"{_target(chart, item)} comes first") for item in finding.by),
    )


def _related(transitions: Sequence[Transition], words: str) -> tuple[Related, ...]:
    """The places of the other branches: of many, the first few."""
    found = [Related(_condition(item), words) for item in transitions[:_SHOWN]]
    if len(transitions) > _SHOWN:
        found[-1] = Related(found[-1].span, f"{words}, and {len(transitions) - _SHOWN} more")
    return tuple(found)


def _condition(transition: Transition) -> Span:
    condition = transition.expression.condition
    if condition is not None:
        return condition.span
    return transition.expression.span or transition.span


def _target(chart: Statechart, transition: Transition) -> str:
    """What a branch leads to, in the words of the file."""
    source, target = chart.node(transition.source), chart.node(transition.target)
    if target.type is StateType.END:
        return "leaving"
    if source.label == target.label:
        return "repeating"
    if target.type is StateType.CONDITION:
        return "the choice"
    return f"`{cut(target.name)}`"


def contradiction(prover: Prover) -> Contradict:
    """What `check_flow` asks about cycles: without z3, only a condition and its own `else` contradict."""

    def contradict(holding: Sequence[Value], failing: Sequence[Value]) -> bool:
        if {identity(condition) for condition in holding} & {identity(condition) for condition in failing}:
            return True
        if len(holding) + len(failing) < 2 or not prover.is_there:
            return False
        from aseme_dsl.proofs.solver import Undecided

        try:
            return not prover.is_possible(holding, failing)
        except Undecided:
            return False

    return contradict


__all__ = ["FROM_CONDITIONS", "check_conditions", "contradiction", "vocabulary_of", "without_ordered"]
