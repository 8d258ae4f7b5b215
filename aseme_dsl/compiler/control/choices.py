"""Choices: whether the control lines decide every choice and loop of a formula, and decide it once."""

from __future__ import annotations

import textwrap
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from typing import Literal

from aseme_dsl.amola.expression import Expired, Not, TransitionExpression, operands
from aseme_dsl.amola.liveness import Formula, ungrouped
from aseme_dsl.amola.operators import Template
from aseme_dsl.compiler.control.control import Line, Lines
from aseme_dsl.compiler.control.waits import check_waits
from aseme_dsl.compiler.formula.formula_to_statechart import Way
from aseme_dsl.compiler.formula.formulas import Formulas
from aseme_dsl.compiler.formula.staying import STAYING
from aseme_dsl.compiler.formula.terms import Terms, spelling, terms_of
from aseme_dsl.compiler.read.constants import NotConstant, fold
from aseme_dsl.compiler.read.missing import Missing
from aseme_dsl.diagnostics import Diagnostic, Edit, Related
from aseme_dsl.diagnostics.problems.control import (
    BranchUndecided,
    ChoiceUndecided,
    ConditionAlwaysFalse,
    ElseBesideTime,
    ElseTwice,
    InterruptUndecided,
    InterruptWaits,
    LoopNeverLeft,
    LoopNeverRepeats,
    LoopUndecided,
    WeightMisplaced,
    WeightMissing,
    WeightNotPositive,
)
from aseme_dsl.diagnostics.problems.expressions.conditions import BranchBehindOpenOne
from aseme_dsl.diagnostics.problems.formulas import LineNeverTaken, LoopMayBeEmpty
from aseme_dsl.diagnostics.problems.missing import ControlMissing
from aseme_dsl.grammar.text import tree
from aseme_dsl.records import dataclass
from aseme_dsl.source import Span


@dataclass(frozen=True, slots=True)
class Alternative:
    """One of several transitions of a source: its name, its lines, and where it stands without one."""

    name: str
    lines: tuple[Line, ...]
    span: Span

    @property
    def place(self) -> Span:
        return self.lines[0].span if self.lines else self.span

    @property
    def is_decided(self) -> bool:
        """Whether every line of it has an event, a condition or `else`."""
        return bool(self.lines) and not any(_unconditional(line.written) for line in self.lines)


def check_formulas(
    formulas: Formulas,
    controls: Mapping[str, str],
    lines: Lines,
    damaged: frozenset[str] = frozenset(),
) -> tuple[Diagnostic, ...]:
    """Every choice and loop of the formulas against their lines.

    `controls` gives each formula the name that its control block has; `damaged` are the formulas whose
    control could not be read completely, so that a missing line means nothing.
    """
    found: list[Diagnostic] = []
    waiting: set[Span | None] = set()  # lines of which it is said what they wait for
    for name in formulas.named:
        if name in damaged:
            continue
        terms = terms_of(formulas, name, controls.get(name, name))
        choices, loops, others = _alternatives(terms, lines)
        has_control = name in lines.blocks and not _is_empty(lines.blocks[name])
        for interruption in _interruptions(terms, lines):
            if interruption.way.lines or (has_control and name not in lines.unsure):
                found += check_interruption(interruption)
        if has_control and name not in lines.unsure:
            for choice in choices:
                found += check_choice(choice)
            for loop in loops:
                found += check_loop(loop)
            found += _endless_once(terms, lines)
        own_ways = (own for (_, term), own in lines.by_way.items() if term in terms.parents)
        found += check_weights(choices, own_ways, {item.line.span for item in lines.labelled})
        for problem in check_waits(formulas, controls, terms, lines):
            if problem.span not in waiting:
                waiting.add(problem.span)
                found.append(problem)
        decided = {line.span for group in (*choices, *loops) for item in group for line in item.lines}
        decided |= {line.span for item in _interruptions(terms, lines) for line in item.way.lines}
        for (verb, term), own in lines.by_way.items():
            if verb not in (*STAYING, "repeat") and term in terms.parents:
                found += always_false(line for line in own if line.span not in decided)
        for group in (*choices, *loops, *others):
            found += check_group(group)
        for group in (*loops, *others):
            found += check_source(group)
    return tuple(found)


def undecided_formulas(
    formulas: Formulas,
    controls: Mapping[str, str],
    lines: Lines,
    inside: Span,
    damaged: frozenset[str] = frozenset(),
) -> tuple[Missing, ...]:
    """A note for every formula with choices or loops that has no `control` line at all (N704).

    `inside` is the block that the control block goes into; the rest is as in `check_formulas`.
    """
    found: list[Missing] = []
    for name in formulas.named:
        if name in damaged or (name in lines.blocks and not _is_empty(lines.blocks[name])):
            continue
        terms = terms_of(formulas, name, controls.get(name, name))
        choices, loops, _ = _alternatives(terms, lines)
        silent = [item for item in _interruptions(terms, lines) if not item.way.lines]
        if silent or any(not item.lines for group in (*choices, *loops) for item in group):
            missing = _nothing_said(terms, controls.get(name, name), choices, loops, silent, inside)
            if name in lines.blocks:
                own_lines = textwrap.dedent("\n".join(missing.skeleton.split("\n")[1:-1]))
                missing = Missing(missing.note, own_lines, lines.blocks[name].span)
            found.append(missing)
    return tuple(found)


def _is_empty(control: tree.Control) -> bool:
    return not control.entries


def unsettled(formulas: Formulas, problems: Iterable[Diagnostic]) -> set[str]:
    """The formulas with a loop that would never settle (E303): its repair changes what is to be decided."""
    loops = (item.span for item in problems if isinstance(item.problem, LoopMayBeEmpty))
    places = [span for span in loops if span is not None]
    return {
        name
        for name, item in formulas.named.items()
        if any(
            place.source is item.span.source and item.span.start <= place.start <= item.span.end
            for place in places
        )
    }


def _alternatives(
    terms: Terms, lines: Lines
) -> tuple[list[list[Alternative]], list[list[Alternative]], list[list[Alternative]]]:
    """The choices, the loops and the other sources of a formula, each with its alternatives in order."""
    choices: list[list[Alternative]] = []
    loops: list[list[Alternative]] = []
    grouped: set[Way] = set()

    def alternative(verb: str, operand: Formula) -> Alternative:
        term = ungrouped(operand)
        grouped.add((verb, term))
        return Alternative(f"{verb} {spelling(terms, term)}", lines.of((verb, term)), operand.span)

    for term in terms.parents:
        operands, row = term.operands, term.operator.row
        if row.template is Template.BRANCHES:
            choices.append([alternative("enter", operand) for operand in operands])
        if row.skips:
            choices.append([alternative(verb, operands[0]) for verb in ("enter", "skip")])
        if row.repeats and row.leaves:
            loops.append([alternative(verb, operands[0]) for verb in ("repeat", "leave")])
    others = [
        [Alternative(f"{verb} {spelling(terms, term)}", own, term.span)]
        for (verb, term), own in lines.by_way.items()
        if len(own) > 1 and verb not in STAYING and term in terms.parents and (verb, term) not in grouped
    ]
    return choices, loops, others


@dataclass(frozen=True, slots=True)
class Interruption:
    """What interrupts another term: its entry transition, and the term that it interrupts.

    `branches` are those of a choice that interrupts.
    """

    way: Alternative
    term: str
    cut: str
    branches: tuple[str, ...] = ()


def _interruptions(terms: Terms, lines: Lines) -> list[Interruption]:
    """Every `A [> B` of a formula."""
    found = []
    for term in terms.parents:
        if term.operator.row.template is Template.CUT:
            cut = spelling(terms, ungrouped(term.operands[0]))
            for operand in terms.formulas.interrupts(term):
                other = ungrouped(operand)
                name = spelling(terms, other)
                way = Alternative(f"enter {name}", lines.of(("enter", other)), operand.span)
                choice = other.operands if other.operator.row.template is Template.BRANCHES else ()
                branches = tuple(spelling(terms, ungrouped(branch)) for branch in choice)
                found.append(Interruption(way, name, cut, branches))
    return found


def check_interruption(interruption: Interruption) -> Iterator[Diagnostic]:
    """`A [> B` wants an event or `when` on every entry transition of B (E420), and at least one (E421)."""
    way = interruption.way
    if not way.lines:
        yield Diagnostic(
            InterruptUndecided(interruption.term, interruption.cut, interruption.branches), way.span
        )
    for line in way.lines:
        written = line.written
        if written.events or written.when:
            continue
        edits: tuple[Edit, ...] = ()
        if written.condition is not None and not written.otherwise:
            start = written.span.start
            edits = (Edit(Span(written.span.source, start, start), "when "),)
        yield Diagnostic(
            InterruptWaits(interruption.term, interruption.cut),
            line.span,
            (Related(way.span, f"`{interruption.term}` stands behind `[>`"),),
            edits=edits,
        )


def check_choice(alternatives: Sequence[Alternative]) -> Iterator[Diagnostic]:
    """A choice wants a condition on each branch: E404, E405; `else` beside a time limit: W401."""
    decided = [item for item in alternatives if any(not _unconditional(line.written) for line in item.lines)]
    if not decided:
        yield Diagnostic(
            ChoiceUndecided(tuple(item.name for item in alternatives)),
            alternatives[0].place,
            _places(alternatives),
        )
        return
    undecided = [item for item in alternatives if not item.is_decided]
    has_else = any(line.written.otherwise for item in alternatives for line in item.lines)
    waits = any(
        line.written.events or line.written.when for other in decided for line in other.lines
    )  # an `else` beside them is taken at once
    for item in undecided:
        may_be_else = item is undecided[-1] and not has_else and not waits
        yield Diagnostic(
            BranchUndecided(item.name, decided[0].name, may_be_else, waits),
            next((line.span for line in item.lines if _unconditional(line.written)), item.span),
            (Related(decided[0].place, f"`{decided[0].name}`"),),
        )
    limits = [line for item in alternatives for line in item.lines if _waits(line.written)]
    yield from _else_beside(alternatives, limits, "limit")
    if not undecided:
        yield from _behind_an_open_one(alternatives)


def check_weights(
    choices: Iterable[Sequence[Alternative]], ways: Iterable[Sequence[Line]], labelled: Collection[Span]
) -> Iterator[Diagnostic]:
    """E434: weights in `choices`, and those of other lines among `ways`.

    Those on `labelled` lines have been refused before.
    """
    chosen = set(labelled)
    for choice in choices:
        lines = [(item, line) for item in choice for line in item.lines if line.span not in labelled]
        chosen |= {line.span for _, line in lines}
        weighted = [item for item, line in lines if line.written.weight is not None]
        for item, line in lines:
            written = line.written
            if written.weight is None:
                if weighted and not written.otherwise:
                    yield Diagnostic(WeightMissing(item.name, weighted[0].name), line.span)
            elif written.events or written.when or written.otherwise:
                yield Diagnostic(WeightMisplaced(), written.weight.span)
            elif written.weight.value == 0:
                yield Diagnostic(WeightNotPositive(), written.weight.span)
        for item in choice:
            if weighted and not item.lines:
                yield Diagnostic(WeightMissing(item.name, weighted[0].name), item.span)
    for line in (line for own in ways for line in own if line.span not in chosen):
        if line.written.weight is not None:
            yield Diagnostic(WeightMisplaced(), line.written.weight.span)


def _behind_an_open_one(alternatives: Sequence[Alternative]) -> Iterator[Diagnostic]:
    """W412: a branch with a condition behind one with `[true]`.

    Before `else` alone, `[true]` is what the scaffold writes for a condition that is still to be said.
    """
    open_ones = [
        (line.position, item)
        for item in alternatives
        for line in item.lines
        if isinstance(line.written.condition, tree.Truth)
        and line.written.condition.value
        and not line.written.events
    ]
    if not open_ones:
        return
    first, taken = min(open_ones, key=lambda found: found[0])
    for item in alternatives:
        later = [line for line in item.lines if line.position > first]
        if item is taken or len(later) < len(item.lines) or not later or later[0].written.condition is None:
            continue
        yield Diagnostic(
            BranchBehindOpenOne(item.name, taken.name),
            later[0].span,
            (Related(taken.place, f"`{taken.name}`"),),
        )


def _places(alternatives: Sequence[Alternative]) -> tuple[Related, ...]:
    """All but the first; not those that have no line of their own and stand where the first does."""
    first = alternatives[0].place
    return tuple(Related(item.place, f"`{item.name}`") for item in alternatives[1:] if item.place != first)


def _waits(written: tree.TransitionExpression) -> bool:
    return any(isinstance(event, tree.After) for event in written.events)


def check_loop(alternatives: Sequence[Alternative]) -> Iterator[Diagnostic]:
    """A loop that repeats and leaves without a condition only ever does what comes first: E407.

    One whose conditions are constant is W420: it never repeats, or is never left.
    """
    repeat, leave = alternatives
    if any(item.is_decided for item in alternatives):
        for item, other, never in ((repeat, leave, LoopNeverRepeats), (leave, repeat, LoopNeverLeft)):
            reason = _never(item, other)
            if reason is not None:
                related = (Related(reason, "because of this"),) if reason != item.place else ()
                yield Diagnostic(never(repeat.name, leave.name), item.place, related)
        return
    always = (line.span for line in repeat.lines if line.expression.is_unconditional)
    place = next(always, repeat.place)
    yield Diagnostic(LoopUndecided(repeat.name, leave.name), place, _places(alternatives))


def _endless_once(terms: Terms, lines: Lines) -> Iterator[Diagnostic]:
    """W420 for a loop without an end (`A~`) whose `repeat` has a condition that never holds."""
    for term in terms.parents:
        if term.operator.row.repeats and not term.operator.row.leaves:
            body = ungrouped(term.operands[0])
            own = lines.of(("repeat", body))
            if own and all(_fixed(line) is False for line in own):
                yield Diagnostic(LoopNeverRepeats(f"repeat {spelling(terms, body)}", None), own[0].span)


def _never(item: Alternative, other: Alternative) -> Span | None:
    """The line because of which an alternative is never taken: its own, or one of the other's."""
    fixed = [_fixed(line) for line in item.lines]
    if item.lines and all(truth is False for truth in fixed):
        return item.lines[0].span
    always = next((line for line in other.lines if _fixed(line) is True), None)
    if always is None:
        return None
    for line, truth in zip(item.lines, fixed, strict=True):
        written = line.written
        if written.events or written.when:
            return None
        if truth is None and written.condition is not None and line.position < always.position:
            return None
    return always.span


def _fixed(line: Line) -> bool | None:
    """Whether the condition of a line holds always (True) or never (False), as far as constants say."""
    condition = line.expression.condition
    if condition is None:
        return None
    try:
        value = fold(condition)
    except (NotConstant, ArithmeticError):
        return None
    if line.written.events and value:
        return None
    return bool(value)


def always_false(lines: Iterable[Line]) -> Iterator[Diagnostic]:
    """W404 for each line whose condition is constant and never holds."""
    for line in lines:
        condition = line.expression.condition
        if condition is not None and _fixed(line) is False:
            yield Diagnostic(ConditionAlwaysFalse(), condition.span)


def check_group(alternatives: Sequence[Alternative]) -> Iterator[Diagnostic]:
    """What holds for all transitions of one source: E406, W401, and lines that are never looked at (W301)."""
    lines = sorted((line for item in alternatives for line in item.lines), key=lambda line: line.position)
    otherwise = [line for line in lines if line.written.otherwise]
    for line in otherwise[1:]:
        yield Diagnostic(ElseTwice(), line.span, (Related(otherwise[0].span, "the first one"),))
    timers = [line for line in lines if line.expression.every or _expires(line.expression)]
    yield from _else_beside(alternatives, timers, "timer")
    for item in alternatives:
        always = [line for line in item.lines if _unconditional(line.written)]
        for line in always[1:]:
            yield never_taken(line, always[0].span)


def check_source(alternatives: Sequence[Alternative]) -> Iterator[Diagnostic]:
    """An `else` beside a transition that needs no condition is never taken: W301 (in a choice, E404)."""
    for item in alternatives:
        unconditional = [line.span for line in item.lines if _unconditional(line.written)]
        place = unconditional[0] if unconditional else None if item.lines else item.span
        if place is not None:
            for line in (line for other in alternatives for line in other.lines):
                if line.written.otherwise:
                    yield never_taken(line, place)
            return


def never_taken(line: Line, because: Span) -> Diagnostic:
    """W301 for a line beside one, at `because`, that needs no condition."""
    related = (Related(because, "taken as soon as the source is complete"),)
    return Diagnostic(LineNeverTaken(), line.span, related)


def _else_beside(
    alternatives: Sequence[Alternative], timed: Sequence[Line], time: Literal["limit", "timer"]
) -> Iterator[Diagnostic]:
    """W401 for the first `else`; another one is E406."""
    lines = (line for item in alternatives for line in item.lines if line.written.otherwise)
    first = min(lines, key=lambda line: line.position, default=None)
    if first is not None and timed:
        related = (Related(timed[0].span, "the time that is waited for"),)
        yield Diagnostic(ElseBesideTime(time), first.span, related)


def _expires(typed: TransitionExpression) -> bool:
    """Whether a condition waits for a timer; `!expired(t)` holds at first, so `else` is right beside it."""
    stack = [] if typed.condition is None else [typed.condition]
    while stack:
        item = stack.pop()
        if isinstance(item, Expired):
            return True
        if not isinstance(item, Not):
            stack += operands(item)
    return False


def _unconditional(written: tree.TransitionExpression) -> bool:
    said = written.events or written.condition is not None or written.otherwise or written.weight is not None
    return not said


def _nothing_said(
    terms: Terms,
    control: str,
    choices: Sequence[Sequence[Alternative]],
    loops: Sequence[Sequence[Alternative]],
    silent: Sequence[Interruption],
    inside: Span,
) -> Missing:
    skeleton = control_skeleton(control, [*choices, *loops], [item.way for item in silent])
    interrupts = tuple((item.term, item.cut) for item in silent)
    problem = ControlMissing(terms.title, len(choices), len(loops), interrupts, skeleton)
    note = Diagnostic(problem, terms.formulas.named[terms.formula].name.span)
    return Missing(note, skeleton, inside)


def control_skeleton(
    control: str, groups: Iterable[Sequence[Alternative]], silent: Sequence[Alternative] = ()
) -> str:
    """A control block that decides every choice and loop, with conditions still to be written.

    `silent` are the ways by which one cuts another short.
    """
    rows: list[tuple[str, str, str]] = []  # verb, term, expression
    for alternatives in groups:
        rows += [_row(item, "[?]") for item in alternatives]
    rows += [_row(item, "when [?]") for item in silent]
    longest = max(len(verb) for verb, _, _ in rows)
    width = max(len(term) for _, term, _ in rows)
    lines = [f"  {verb:{longest}} {term:{width}} : {said}" for verb, term, said in rows]
    return "\n".join([f"control {control} {{", *lines, "}"])


def _row(item: Alternative, said: str) -> tuple[str, str, str]:
    verb, _, term = item.name.partition(" ")
    return verb, term, said


__all__ = [
    "Alternative",
    "always_false",
    "check_choice",
    "check_formulas",
    "check_group",
    "check_loop",
    "check_source",
    "control_skeleton",
    "never_taken",
    "undecided_formulas",
    "unsettled",
]
