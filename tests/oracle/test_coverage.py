"""Coverage of random charts: what is counted from records and by probes, the interpreter counts as well.

The interpreter notes each state that it enters, and for each condition which parts it evaluates, and how. It
does so with its own reading of conditions, from the plan of the chart without probes.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from itertools import combinations
from typing import Any

import pytest

from aseme_dsl.play.coverage.decisions import deciding
from aseme_dsl.play.coverage.probes import Recorder, probed
from aseme_dsl.play.coverage.reach import reach_of
from aseme_dsl.play.coverage.seen import Following, Seen
from aseme_dsl.runtime.chart import chart
from aseme_dsl.runtime.trace.records import as_record
from tests.oracle import interpreter
from tests.oracle.charts import text
from tests.oracle.choices import Choices
from tests.oracle.examples import ROUNDS, agree, forget, how_many
from tests.oracle.interpreter import Reference
from tests.oracle.playing import Game, Moment, moments
from tests.support.generated import imported, system_of

EXAMPLES = how_many(20)
GROUPS = 2


@pytest.fixture(autouse=True)
def bound(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(chart, "ROUNDS", ROUNDS)
    monkeypatch.setattr(interpreter, "ROUNDS", ROUNDS)


class Counting(Reference):
    """An interpreter that counts what it enters, and notes how it evaluates conditions."""

    def __init__(self, *arguments: Any) -> None:
        super().__init__(*arguments)
        self.entered: Counter[str] = Counter()
        self.notes: list[str] = []
        self.evaluated: dict[int, set[tuple[tuple[int, bool], ...]]] = {}
        self.parts: list[tuple[int, bool]] = []
        self.has_failed = False
        self.is_asked = False

    def enter(self, label: str, *arguments: Any, **named: Any) -> None:
        self.notes.append(f"+{label}")
        super().enter(label, *arguments, **named)

    def be_in(self, label: str, *arguments: Any) -> None:
        if not self.notes or self.notes[-1] != f"+{label}":
            self.notes.append(f"+{label}")
        super().be_in(label, *arguments)

    def leave(self, label: str) -> None:
        super().leave(label)
        self.notes.append(f"-{label}")

    def condition_holds(self, number: int, transition: Any) -> bool:
        self.parts = []
        self.has_failed = False
        self.is_asked = True
        result = super().condition_holds(number, transition)
        if not self.has_failed:
            self.evaluated.setdefault(number, set()).add((*self.parts, (-1, result)))
        return result

    def fault(self, *arguments: Any) -> None:
        self.has_failed = True
        super().fault(*arguments)

    def holds(self, term: Any, region: Any) -> bool:
        if not self.is_asked:
            return super().holds(term, region)  # of a random choice, or inside a part
        self.is_asked = False
        return self.judged(term, True, region, 0)

    def judged(self, term: Any, truth: bool, region: Any, place: int) -> bool:
        """Whether a condition is true, or false, as its parts say from the left; notes what they say."""
        match term:
            case ("!", operand):
                return self.judged(operand, not truth, region, place)
            case ("&&" | "||" as word, *operands):
                needs_all = (word == "&&") is truth
                for operand in operands:
                    if self.judged(operand, truth, region, place) is not needs_all:
                        return not needs_all
                    place += len(list(leaves(operand)))
                return needs_all
        said = self.value(term, region) is truth
        self.parts.append((place, said))
        return said


def leaves(term: Any) -> Iterator[Any]:
    if term[0] in ("&&", "||", "!"):
        for part in term[1:]:
            yield from leaves(part)
    else:
        yield term


def slow_deciding(evaluations: set[tuple[tuple[int, bool], ...]]) -> set[int]:
    """The parts that decide, by comparing all pairs of evaluations."""
    found = set()
    for one, other in combinations(evaluations, 2):
        first, second = dict(one), dict(other)
        if first.pop(-1) != second.pop(-1):
            differing = {place for place in first.keys() & second.keys() if first[place] != second[place]}
            if len(differing) == 1:
                found |= differing
    return found


@dataclass
class Covered(Game):
    """A game whose generated class has probes."""

    seen: Seen = field(default_factory=Seen)

    def __post_init__(self) -> None:
        super().__post_init__()
        without = imported(self.made.system)
        self.plan = without.plan(self.role)
        self.expected = Counting(self.plan, "me", vars(self.made.messages))
        charts = {item.name: item for item in self.made.system.iacs}
        self.chart = charts[self.role]
        self.following = Following(charts, self.seen, {"me": self.role})
        self.steps = 0

    def step(self, moment: Moment) -> None:
        super().step(moment)
        self.steps += 1
        taken = [{"transitions": list(numbers)} for numbers in self.actual.taken]
        record = {"kind": "step", "agent": "me", "step": self.steps, "taken": taken}
        self.following(as_record(record))

    def compare_all(self) -> None:
        expected = self.expected
        assert isinstance(expected, Counting)
        entered = Counter(note[1:] for note in expected.notes if note[0] == "+")
        counted = self.seen.of(self.role)
        self.compare("what was entered", entered, counted.entered)
        reach = reach_of(self.chart)
        assert reach.states.issuperset(entered), self.text
        assert reach.transitions.issuperset(counted.taken), self.text
        for number, evaluations in expected.evaluated.items():
            item = self.chart.transitions[number]
            if item.reactive or item.expression.draw is not None:
                continue
            found = self.seen.evaluations.get((self.role, number), set())
            count = len(list(leaves(self.plan.transitions[number].condition)))
            self.compare(
                f"what decides transition {number}", slow_deciding(evaluations), set(deciding(found, count))
            )


def play(choices: Choices) -> Iterator[Game]:
    written = text(choices)
    system = system_of(written)
    with_probes = probed(system)
    made = imported(with_probes.system)
    try:
        for _ in range(2):
            seen = Seen()
            game = Covered(replace(made, system=system), written, seen=seen)
            recorder = Recorder(with_probes.probes, seen.evaluations)
            game.actual = recorder.listening(made.charts["R"])("me")
            game.play(moments(choices))
            game.compare_all()
            yield game
    finally:
        forget(made)


@pytest.mark.parametrize("group", range(GROUPS))
def test_random_charts(group: int) -> None:
    assert agree(play, EXAMPLES, group, GROUPS) > 0
