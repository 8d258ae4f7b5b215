"""What z3 says of random conditions is what trying all values says, by the tests' own interpreter."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import product
from random import Random
from types import SimpleNamespace
from typing import Any

import pytest

from aseme_dsl.amola.expression import Value
from aseme_dsl.codegen.plan import value_term
from aseme_dsl.compiler.names.resolve import resolve
from aseme_dsl.compiler.read.load import load
from aseme_dsl.compiler.types.scopes import global_scope
from aseme_dsl.proofs.prover import Prover
from aseme_dsl.proofs.solver import Claim, Witness
from aseme_dsl.proofs.unknowns import Key, Vocabulary
from aseme_dsl.source import Source
from tests.oracle.interpreter import Reference, Region

pytest.importorskip("z3", reason="conditions are compared by z3: pip install 'aseme-dsl[check]'")

DECLARATIONS = """
enum Color { RED GREEN = 4 BLUE }
message Inner { optional bool d }
message M { int a  optional int b  bool c  Color k  Inner inner }
message N { int a  Color k }
topic m { state M }
topic n { state N }
"""
CHANNELS = {"m.state.M": "M", "n.state.N": "N"}
INTS = (-2, -1, 0, 1, 2, 3, 4)
"""Enough for two ints that are compared with each other and with 0, 1, 2."""
COLORS = {"RED": 0, "GREEN": 4, "BLUE": 5}
FIELDS: dict[str, dict[str, tuple[Any, ...]]] = {
    "m.state.M": {
        "a": INTS,
        "b": (None, *INTS),
        "c": (False, True),
        "k": (0, 4, 5),
        "d": (None, False, True),
    },
    "n.state.N": {"a": INTS, "k": (0, 4, 5)},
}


class Words:
    """Random conditions as texts."""

    def __init__(self, random: Random, arithmetic: bool) -> None:
        self.random = random
        self.arithmetic = arithmetic

    def number(self, depth: int = 1) -> str:
        if self.arithmetic and depth and self.random.random() < 0.4:
            operator = self.random.choice("+-*/%")
            return f"({self.number(depth - 1)} {operator} {self.number(depth - 1)})"
        if self.random.random() < 0.3:
            return str(self.random.choice((0, 1, 2)))
        return self.random.choice(("m.state.M.a", "m.state.M.b", "n.state.N.a"))

    def leaf(self) -> str:
        match self.random.randrange(8):
            case 0:
                return f"has({self.random.choice(list(CHANNELS))})"
            case 1:
                return "m.state.M.c"
            case 2:
                return "m.state.M.inner.d"
            case 3:
                operator = self.random.choice(("==", "!="))
                other = self.random.choice(("Color.RED", "Color.GREEN", "n.state.N.k"))
                return f"m.state.M.k {operator} {other}"
            case 4:
                return "expired(t)"
            case _:
                operator = self.random.choice(("==", "!=", "<", "<=", ">", ">="))
                return f"{self.number()} {operator} {self.number()}"

    def condition(self, depth: int) -> str:
        if depth == 0 or self.random.random() < 0.2:
            return f"({self.leaf()})"
        word = self.random.choice(("&&", "||", "!", "=="))
        if word == "!":
            return f"(!{self.condition(depth - 1)})"
        return f"({self.condition(depth - 1)} {word} {self.condition(depth - 1)})"


def typed(texts: list[str]) -> tuple[list[Value], Vocabulary]:
    lets = "\n".join(f"let probe{place} = {text}" for place, text in enumerate(texts))
    loaded = load(Source("test.aseme", f"{DECLARATIONS}\n{lets}\n"))
    symbols, problems = resolve(loaded)
    scope, found = global_scope(symbols)
    assert not loaded.diagnostics and not problems and not found
    values = [scope.lets[f"probe{place}"].value for place in range(len(texts))]
    assert None not in values
    vocabulary = Vocabulary(
        {item.name: item for item in symbols.enums}, {item.name: item for item in symbols.messages}
    )
    return [value for value in values if value is not None], vocabulary


Snapshot = Mapping[str, Mapping[str, Any] | None]
"""For each channel its fields, or None while it is absent; and whether the timer has expired."""


def snapshots(texts: list[str]) -> Iterator[tuple[dict[str, dict[str, Any] | None], bool]]:
    """Everything that the texts can see, with the first value of what they do not read."""
    text = " ".join(texts)
    boards = []
    for channel, fields in FIELDS.items():
        if channel not in text:
            boards.append([None])
            continue
        used = [
            values if f"{channel}.{name}" in text or (name == "d" and "inner" in text) else values[:1]
            for name, values in fields.items()
        ]
        boards.append([None, *(dict(zip(fields, values, strict=True)) for values in product(*used))])
    for combination in product(*boards):
        for expired in (False, True) if "expired" in text else (False,):
            yield dict(zip(FIELDS, combination, strict=True)), expired


def interpreted(value: Value, board: Mapping[str, Mapping[str, Any] | None], expired: bool) -> bool:
    """Whether the condition holds, as the tests' interpreter of the semantics says."""
    reference = Reference.__new__(Reference)
    reference.messages = {"Color": COLORS}
    reference.now = 10
    region = Region("0")
    for channel, fields in board.items():
        if fields is not None:
            inner = SimpleNamespace(d=fields.get("d"))
            message = SimpleNamespace(**fields, inner=inner)
            region.states[channel] = [SimpleNamespace(sender="somebody", message=message, time=0)]  # type: ignore[list-item]
    if expired:
        region.timers["t"] = 5
    try:
        return reference.holds(value_term(value), region)
    except ZeroDivisionError:
        return False


def seen(witness: Witness) -> tuple[dict[str, dict[str, Any] | None], bool]:
    """The snapshot that a witness describes, with defaults for what it leaves open."""
    said: dict[Key, Any] = {unknown.key: witness.values[unknown.key] for unknown in witness.decisive}
    board: dict[str, dict[str, Any] | None] = dict.fromkeys(FIELDS)
    for key, value in said.items():
        if key[0] not in ("has", "value", "set"):
            continue
        channel = str(key[2])
        if key[0] == "has" and not value:
            continue
        fields = board[channel]
        if fields is None:
            fields = board[channel] = {
                name: next(item for item in values if item is not None)
                for name, values in FIELDS[channel].items()
            }
            fields["a"] = 0
        if key[0] != "has":
            fields[key[3][-1]] = value if key[0] == "value" else (0 if value else None)
    for key, value in said.items():
        if key[0] == "set" and not value:
            fields = board[str(key[2])]
            assert fields is not None
            fields[key[3][-1]] = None
    return board, bool(said.get(("expired", "t")))


def claims(values: list[Value]) -> list[Claim]:
    first, second, *_ = values
    return [
        Claim((first, second)),  # an overlap
        Claim((), tuple((value,) for value in values)),  # a gap
        Claim((first,)),  # it can hold
        Claim((), ((first,),)),  # it can fail
        Claim((second,), ((first,),)),  # not covered
    ]


@pytest.mark.parametrize("arithmetic", [False, True], ids=["comparisons", "arithmetic"])
@pytest.mark.parametrize("seed", range(50))
def test_z3_and_trying_all_values_agree(seed: int, arithmetic: bool) -> None:
    random = Random(f"{seed} {arithmetic}")
    words = Words(random, arithmetic)
    agree([words.condition(random.choice((0, 1, 2))) for _ in range(random.choice((2, 2, 3)))], arithmetic)


CORNERS = {
    "absent truth as a value": ["(m.state.M.c && has(n.state.N)) == has(m.state.M)", "!m.state.M.c"],
    "absent truth is not false": ["(m.state.M.c || n.state.N.a > 0) == (1 > 2)", "has(m.state.M)"],
    "a fault in a truth": ["(1 / m.state.M.a > 0 || m.state.M.c) == m.state.M.c", "m.state.M.a == 0"],
    "sign of the remainder": ["m.state.M.a % n.state.N.a < 0", "m.state.M.a > 0"],
    "remainder of a negative": ["m.state.M.a % 3 == 2", "m.state.M.a < 0"],
    "fault behind what decides": ["m.state.M.c || 1 / m.state.M.a > 0", "m.state.M.a == 0"],
    "fault before what decides": ["1 / m.state.M.a > 0 || m.state.M.c", "m.state.M.a == 0"],
    "absent before a fault": ["n.state.N.a == 1 / m.state.M.a || m.state.M.a == 0", "!has(n.state.N)"],
}


@pytest.mark.parametrize("corner", CORNERS)
def test_they_agree_where_it_is_narrow(corner: str) -> None:
    agree(CORNERS[corner], arithmetic=True)


def agree(texts: list[str], arithmetic: bool) -> None:
    """Compare what z3 says of some claims about the conditions with all snapshots, and try each example."""
    values, vocabulary = typed(texts)
    tried: dict[int, set[tuple[bool, ...]]] = {0: set()}
    for board, expired in snapshots(texts):
        tried[0].add(tuple(interpreted(value, board, expired) for value in values))
    snapshot = Prover(vocabulary).snapshot(values)
    for number, claim in enumerate(claims(values)):
        wanted = [values.index(value) for value in claim.open]
        unwanted = [values.index(way[0]) for way in claim.closed]
        found = any(
            all(row[place] for place in wanted) and not any(row[place] for place in unwanted)
            for row in tried[0]
        )
        witness = snapshot.witness(claim)
        if not arithmetic or found:  # numbers that were not tried may do what these cannot
            assert (witness is not None) is found, (number, texts)
        assert snapshot.is_possible(claim) is (witness is not None)
        if witness is not None:
            board, expired = seen(witness)
            says = [interpreted(value, board, expired) for value in values]
            assert all(says[place] for place in wanted), (number, texts, str(witness))
            assert not any(says[place] for place in unwanted), (number, texts, str(witness))


def test_the_values_are_the_same_every_time() -> None:
    words = Words(Random("again"), arithmetic=True)
    texts = [words.condition(2) for _ in range(2)]
    values, vocabulary = typed(texts)
    first, *others = (
        [str(Prover(vocabulary).snapshot(values).witness(claim)) for claim in claims(values)]
        for _ in range(5)
    )
    assert all(other == first for other in others)
