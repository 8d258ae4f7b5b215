"""Numbers that may be any: what is explored with them is what trying many numbers says.

A few random robots are compared in every run of the tests; many with `COMPARED_NUMBERS=100`.
"""

from __future__ import annotations

import os
import random
from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import product
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import cast

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from aseme_dsl.amola.expression import COMPARE
from aseme_dsl.project.building.build import choose
from aseme_dsl.project.building.project import compile_root
from aseme_dsl.project.playing.operate import generate_version, loaded_for
from aseme_dsl.proofs.explore import questions
from aseme_dsl.proofs.explore.deciding import values
from aseme_dsl.proofs.explore.deciding.choosing import Choices
from aseme_dsl.proofs.explore.deciding.order import AnyNumber, Number, Order, Unanswerable
from aseme_dsl.proofs.explore.deciding.values import Tried
from aseme_dsl.proofs.explore.explored import Assumed, Explored
from aseme_dsl.proofs.explore.search import Eyes, Graph, Limits, search
from aseme_dsl.proofs.timed.zone import unbounded
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.version.loading import Loaded
from aseme_dsl.source import Source

MANY = int(os.environ.get("COMPARED_NUMBERS", "0"))

# ---- comparisons ------------------------------------------------------------------------------------

Asked = tuple[int, int, str, int, int]
"""Number one + offset, sign, number other + offset; a number that is -1 is 0."""

asked = st.tuples(
    st.integers(0, 2),
    st.integers(-1, 1),
    st.sampled_from(sorted(COMPARE)),
    st.integers(-1, 2),
    st.integers(-1, 1),
)


def _ways(questions: Sequence[Asked], *, is_whole: bool, kept: int) -> set[tuple[bool, ...]]:
    """All answers that may come; of `kept` numbers something is remembered after half of the questions."""
    choices = Choices()
    order = Order(choices)
    found: set[tuple[bool, ...]] = set()
    size = _size(is_whole)
    choices.begin()
    while True:
        order.known = type(order.known)()
        numbers = [order.number(is_whole=is_whole) for _ in range(size)]
        answers = []
        for number, (one, more, sign, other, plus) in enumerate(questions):
            if number == len(questions) // 2:
                order.keep({item.number for item in numbers[:kept]})
                numbers[kept:] = [order.number(is_whole=is_whole) for _ in numbers[kept:]]
            left = cast("float", numbers[one % size] + more)
            right = cast("float", plus if other < 0 else numbers[other % size] + plus)
            answers.append(COMPARE[sign](left, right))
        found.add(tuple(answers))
        if not choices.again():
            assert order.is_exact
            return found


def _tried(questions: Sequence[Asked], *, is_whole: bool, kept: int) -> set[tuple[bool, ...]]:
    """The answers of numbers of which there are enough."""
    some = range(-10, 11) if is_whole else [number / 4 for number in range(-20, 21)]
    size = _size(is_whole)
    half = len(questions) // 2

    def answers(part: Sequence[Asked], numbers: Sequence[float]) -> tuple[bool, ...]:
        return tuple(
            COMPARE[sign](numbers[one % size] + more, plus if other < 0 else numbers[other % size] + plus)
            for one, more, sign, other, plus in part
        )

    first: dict[tuple[float, ...], set[tuple[bool, ...]]] = {}
    for numbers in product(some, repeat=size):
        first.setdefault(numbers[:kept], set()).add(answers(questions[:half], numbers))
    second: dict[tuple[float, ...], set[tuple[bool, ...]]] = {}
    for numbers in product(some, repeat=size):
        second.setdefault(numbers[:kept], set()).add(answers(questions[half:], numbers))
    return {(*one, *other) for held in first for one in first[held] for other in second[held]}


def _size(is_whole: bool) -> int:
    """How many numbers there are. Fewer if they are dense, so that there is one for each way."""
    return 3 if is_whole else 2


@settings(max_examples=40, deadline=None)
@given(st.lists(asked, min_size=1, max_size=6), st.booleans(), st.integers(0, 3))
def test_the_answers_are_those_of_some_numbers(questions: list[Asked], is_whole: bool, kept: int) -> None:
    assert _ways(questions, is_whole=is_whole, kept=kept) == _tried(questions, is_whole=is_whole, kept=kept)


def _number(*, is_whole: bool = True) -> tuple[Order, AnyNumber]:
    choices = Choices()
    choices.begin()
    order = Order(choices)
    return order, order.number(is_whole=is_whole)


@pytest.mark.parametrize(
    "use",
    [
        "int(n)",
        "float(n)",
        "str(n)",
        "f'{n}'",
        "bool(n)",
        "n % 2",
        "1 / n",
        "n / n",
        "2 ** n",
        "range(n)",
        "n // n",
    ],
)
def test_a_number_has_no_value(use: str) -> None:
    _, number = _number()
    with pytest.raises((Unanswerable, TypeError)):
        eval(use, {"n": number})  # a test's own text


def test_what_is_not_the_program_compares_no_numbers() -> None:
    order, number = _number()
    order.asks = lambda: False
    assert number == number
    assert (number == 3) is False
    with pytest.raises(Unanswerable):
        _ = number < 3


@pytest.mark.parametrize("constant", [0.1, 0.001, 1e-9, 2**53, 1e18])
def test_a_constant_is_exact(constant: float) -> None:
    _, number = _number(is_whole=False)
    assert number < constant  # the answer that is tried first
    assert not number >= constant
    assert number + 1 < constant + 1 + constant / 1000


@pytest.mark.parametrize("constant", [1e300, -1e300, 1e-300, float("inf"), float("nan")])
def test_a_constant_that_is_none_of_the_numbers_is_not_compared(constant: float) -> None:
    _, number = _number(is_whole=False)
    with pytest.raises(Unanswerable):
        _ = number < constant


def test_a_sum_may_be_any_number_and_is_not_exact() -> None:
    order, number = _number()
    total = number + order.number(is_whole=True)
    assert order.is_exact
    _ = total < 3
    assert not order.is_exact


# ---- robots -----------------------------------------------------------------------------------------

ROBOT = """\
system Numbers
srm robot {{
  var a : {kind} = 0
  var b : {kind} = 0
  var n : int = 0
  liveness {{ robot = Draw . (Look . [Work])+ . Then . [Wait] . Next . (Left | Right) . Done }}
  activities {{ Draw takes 1s writes a, b  Look takes 1s {again}  Work takes 1s  Then takes 1s  Wait takes 1s
               Next takes 1s  Left takes 1s  Right takes 1s  Done waits }}
  control robot {{
    enter Work : [{conditions[0]}] / n = n + 1
    skip  Work : else
    repeat (Look . [Work]) : [n < 2 && {conditions[1]}]
    enter Then : else
    enter Wait : [{conditions[2]}]
    skip  Wait : else
    enter Left : when [{conditions[3]}]
    enter Right : when [{conditions[4]}]
  }}
}}
team T {{ robot : robot }}
"""


def _condition(chance: random.Random, depth: int = 2) -> str:
    if depth and chance.random() < 0.4:
        parts = [_condition(chance, depth - 1) for _ in range(2)]
        return f"({parts[0]} {chance.choice(['&&', '||'])} {parts[1]})"
    left = chance.choice(["a", "b", "a + 1", "b - 1"])
    right = chance.choice(["a", "b", "n", "n + 1", "0", "2", "b + 1"])
    return f"{left} {chance.choice(sorted(COMPARE))} {right}"


TEAM = """\
system Numbers
message Ball {{ {kind} x }}
message Goal {{ {kind} x }}
topic field {{ state Ball  state Goal }}
srm boss {{
  var a : {kind} = 0
  var b : {kind} = 0
  liveness {{ boss = Draw . [Tell] . [Again] . Rest }}
  activities {{ Draw takes 1s writes a, b  Tell takes 1s  Again takes 1s  Rest waits }}
  control boss {{
    enter Tell : [{conditions[0]}] / write_messages.field.state.Ball {{ x = a }}
    skip  Tell : else
    enter Again : [{conditions[1]}] / write_messages.field.state.Ball {{ x = b - 1 }}
    skip  Again : else
  }}
}}
srm robot {{
  var c : {kind} = 0
  liveness {{ robot = Draw . Wait . (Left | Right) . Done }}
  activities {{ Draw takes 1s writes c  Wait takes 1s  Left takes 1s  Right takes 1s  Done waits }}
  control robot {{
    enter Wait  : when [{conditions[2]}]
    enter Left  : when [{conditions[3]}]
    enter Right : when [{conditions[4]}]
  }}
}}
team T {{ boss : boss  robot : robot }}
"""


def team_of(chance: random.Random) -> str:
    """A robot that compares what another one and its surroundings tell it."""
    read = ["c", "c + 1", "field.state.Ball.x", "field.state.Ball.x - 1", "field.state.Goal.x", "1"]
    conditions = [_condition(chance) for _ in range(2)]
    for _ in range(3):
        one, other = chance.sample(read, 2)
        conditions.append(f"{one} {chance.choice(sorted(COMPARE))} {other}")
    return TEAM.format(kind="int", conditions=[item.replace("n", "1") for item in conditions])


def robot_of(chance: random.Random) -> str:
    """A robot that compares numbers which its activities decide."""
    conditions = [_condition(chance) for _ in range(5)]
    again = chance.choice(["", "writes a", "writes b"])
    return ROBOT.format(kind=chance.choice(["int", "double"]), again=again, conditions=conditions)


@dataclass(frozen=True, slots=True)
class Said:
    """What a search says."""

    stuck: frozenset[tuple[str, str]]
    visited: Mapping[str, frozenset[str]]
    taken: Mapping[str, frozenset[int]]
    ends: frozenset[tuple[tuple[int, ...], ...]]


def _loaded(text: str) -> Loaded:
    compiled = compile_root(Source("robot.aseme", text))
    assert compiled.system is not None, compiled.diagnostics
    with TemporaryDirectory(prefix="robot-") as folder:
        package, _ = generate_version(compiled.system, Path(folder), choose(compiled.configuration))
        return loaded_for(package, Path())


def _said(loaded: Loaded, *, may_be_any: bool) -> tuple[Said, int]:
    eyes = Eyes()
    team = [(role, role) for role in loaded.charts]
    explored = Explored(loaded, team, Assumed(), [eyes], numbers=None if may_be_any else ())
    graph = search(explored, eyes, None, Limits(20_000, 1e9))
    assert graph.cut is None
    assert explored.order.is_exact
    assert not graph.sightings
    found = Said(
        frozenset(_stuck(explored, graph)),
        {role: frozenset(labels) for role, labels in graph.visited.items()},
        {role: frozenset(numbers) for role, numbers in graph.taken.items()},
        frozenset(graph.places[state] for state, edges in graph.edges.items() if not edges),
    )
    return found, len(graph.parents)


def _stuck(explored: Explored, graph: Graph) -> Iterator[tuple[str, str]]:
    back = questions._back(graph)
    for place, agent in enumerate(explored.agents):
        for state in questions._for_ever(graph, back, place, 0, agent):
            waiting = questions._waits(explored, graph, state, place, 0)
            if waiting is not None:
                yield agent.name, waiting.name


def _many(kind: object, known: object, agents: object) -> Tried:
    """Numbers of which there are enough for a robot."""
    assert kind in (int, float)
    some = [float(number) if kind is float else number for number in range(-3, 6)]
    some += [number + part for number in some for part in (0.25, 0.5)] if kind is float else []
    return Tried(tuple(some), is_all=True)


def _with_any(kind: object, known: object, agents: object) -> Tried:
    return Tried((), is_all=False)


@pytest.fixture(autouse=True)
def none_is_alike(monkeypatch: pytest.MonkeyPatch) -> None:
    """Of numbers that are compared with constants, no few stand for all."""
    monkeypatch.setattr(values, "_few", lambda *_: None)


@pytest.mark.parametrize(("made", "few"), [(robot_of, (0, 2, 10)), (team_of, (9, 13))])
def test_robots_do_with_any_numbers_what_they_do_with_many(
    monkeypatch: pytest.MonkeyPatch, made: Callable[[random.Random], str], few: Sequence[int]
) -> None:
    stuck = 0
    for seed in range(MANY) or few:
        text = made(random.Random(seed))
        loaded = _loaded(text)
        with monkeypatch.context() as patch:
            patch.setattr(values, "_values", _many)
            expected, more = _said(loaded, may_be_any=False)
        with monkeypatch.context() as patch:
            patch.setattr(values, "_values", _with_any)
            found, fewer = _said(loaded, may_be_any=True)
        assert found == expected, (seed, text)
        stuck += bool(found.stuck)
        if MANY:
            print(seed, more, fewer, sorted(found.stuck), flush=True)
    assert stuck


def test_a_number_that_is_forgotten_too_early_is_noticed(monkeypatch: pytest.MonkeyPatch) -> None:
    """A robot waits for what was decided before; if that is forgotten, it may come."""
    text = ROBOT.format(
        kind="int", again="", conditions=["a < 2", "a > 5", "a < 2", "a >= 2 && n > 0", "a > 1 && n == 0"]
    )
    loaded = _loaded(text)
    monkeypatch.setattr(values, "_values", _with_any)
    expected, _ = _said(loaded, may_be_any=True)
    assert expected.stuck
    monkeypatch.setattr(Order, "keep", _forget)
    found, _ = _said(loaded, may_be_any=True)
    assert found != expected


def _forget(order: Order, numbers: object) -> bool:
    known = order.known
    there = known.zone.clocks
    order.known.zone = type(known.zone)()
    for number in there:
        order.known.zone = unbounded(order.known.zone, number)
    return bool(there)


def test_number_is_what_comparisons_take() -> None:
    _, number = _number(is_whole=False)
    some: Number = number
    assert isinstance(some, float)
