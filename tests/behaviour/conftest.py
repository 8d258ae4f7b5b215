"""The fixture `play`: a text becomes a running agent, once for each engine."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import cache

import pytest

from aseme_dsl.runtime.chart.chart import Chart
from tests.behaviour.running import Engine, Run
from tests.oracle.interpreter import Reference
from tests.support import asleep
from tests.support.generated import Generated, generate
from tests.support.plain_engine import CannotDo, PlainEngine

PRELUDE = """
system S

enum Colour { RED GREEN BLUE }
message M { int x  bool on  double d  string s  Colour colour }
message Note { string text }
topic t { state M  signal M  data M }
topic q { signal M queued  signal Note expires 20ms }

team T { me, ann, bob, eve : R }

function even(int n) : bool = "tests.behaviour.functions:even"
function inverse(int n) : double = "tests.behaviour.functions:inverse"
function far(M m) : bool = "tests.behaviour.functions:far"
function fails(int n) : bool = "tests.behaviour.functions:fails"
"""

Play = Callable[[str], Run]


@cache
def generated(text: str) -> Generated:
    """The generated package of a text, made once for all engines."""
    return generate(PRELUDE + text)


def interpreter(made: Generated, role: str) -> Engine:
    return Reference(made.plan(role), "me", vars(made.messages))


def step_class(made: Generated, role: str) -> Engine:
    return made.chart(role, "me")


def plain_chart(made: Generated, role: str) -> Engine:
    return PlainEngine(made, role)


@pytest.fixture(autouse=True)
def nothing_is_overlooked(monkeypatch: pytest.MonkeyPatch) -> None:
    """Whenever a chart goes to sleep, no transition of it is enabled."""
    monkeypatch.setattr(Chart, "step", asleep.step)


@pytest.fixture(params=[interpreter, step_class, plain_chart], ids=["interpreter", "generated", "plain"])
def play(request: pytest.FixtureRequest) -> Play:
    """`play(text)` gives an agent with the role `R` of the text, not yet stepped."""

    def start(text: str) -> Run:
        made = generated(text)
        return Run(request.param(made, "R"), made.plan("R"), made)

    return start


@pytest.hookimpl(wrapper=True)
def pytest_runtest_call(item: pytest.Item) -> Iterator[None]:
    """What the plain face refuses, or no program can do with it, is skipped, with the reason."""
    try:
        return (yield)
    except CannotDo as refused:
        pytest.skip(f"the plain face: {refused}")
