"""Engines that others wrote do, step by step, what our runtime does with the same chart.

Random charts with random inputs are recorded and repeated. The second lane, `EXPORTED_CHARTS=300 pytest
tests/interop/exports/test_engines.py`, has further engines: sismic and Qt's.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from functools import cache, partial
from pathlib import Path

import pytest

from aseme_dsl.compiler import analyse
from aseme_dsl.diagnostics.problems.exporting import Foreign
from aseme_dsl.interop.export.lowering import lowered
from aseme_dsl.interop.export.sismic import limits
from aseme_dsl.runtime.chart import chart
from tests.interop.exports.engines import (
    Played,
    differences,
    on_javascript,
    on_qt,
    python_statemachine,
    sismic_engine,
)
from tests.interop.exports.playing import Recorder, Recording
from tests.interop.exports.taming import tamed
from tests.oracle import interpreter
from tests.oracle.charts import text
from tests.oracle.choices import Choices
from tests.oracle.examples import ROUNDS, forget
from tests.support.generated import generate, imported, system_of

CHARTS = int(os.environ.get("EXPORTED_CHARTS", "24"))
PARTS = 2
"""The random charts are played in so many parts, beside each other."""
SECOND_LANE = "EXPORTED_CHARTS" in os.environ
SEEDS = 10 if SECOND_LANE else 1  # games with each role of a file
FIRST = int(os.environ.get("ORACLE_FIRST", "0"))
ROOT = Path(__file__).parents[3]


@pytest.fixture(scope="module", autouse=True)
def bound() -> Iterator[None]:
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(chart, "ROUNDS", ROUNDS)
        patch.setattr(interpreter, "ROUNDS", ROUNDS)
        yield


def random_charts(part: int) -> tuple[tuple[str, Recording], ...]:
    """Games with random charts, each of 25 steps at most."""
    found: list[tuple[str, Recording]] = []
    wanted = -(-CHARTS // PARTS)
    for seed in range(FIRST + part, FIRST + part + PARTS * (2 * wanted + 20), PARTS):
        choices = Choices(seed)
        made = imported(tamed(system_of(text(choices))))
        recorder = Recorder(made)
        recording = None if recorder.refused else recorder.record(choices)
        forget(made)
        if recording is not None:
            found.append((f"seed {seed}", recording))
        if len(found) == wanted:
            return tuple(found)
    raise AssertionError("too many random charts are refused")


FILES = (*sorted(ROOT.glob("tests/acceptance/*.aseme")), *sorted(ROOT.glob("examples/*/*.aseme")))
WAITS = (0, 50_000_000, 100_000_000, 200_000_000, 1_000_000_000)
AS_THEY_ARE = frozenset(
    [
        "acceptance/testbehavior TestBehavior",
        "acceptance/kouretes goalie",
        "hospital/hospital guard",
        "robocup/kouretes goalie",
    ]
)
"""Roles that have nothing which engines lack. Of the others, it is replaced: signals by states, what agents
say by events, what stays in a state by nothing."""


@cache
def charts_of_files() -> tuple[tuple[str, Recording], ...]:
    """Games with all roles of the acceptance files and the examples."""
    found = []
    for path in FILES:
        system = analyse(path).system
        if system is None:  # a part of another file
            continue
        whole = [chart for chart in system.iacs if not lowered(system, chart)[1]]
        able = tamed(system)
        charts = tuple(old if old in whole else new for old, new in zip(system.iacs, able.iacs, strict=True))
        made = imported(replace(able, iacs=charts))
        for chart_ in charts:
            name = f"{path.parent.name}/{path.stem} {chart_.name}"
            assert (chart_ in whole) == (name in AS_THEY_ARE)
            for seed in range(SEEDS):
                recorder = Recorder(made, chart_.name, WAITS)
                assert not recorder.refused
                recording = recorder.record(Choices(f"{chart_.name} {seed}"))
                assert recording is not None
                found.append((f"{name} {seed}", recording))
        forget(made)
    return tuple(found)


def on_python_statemachine(recordings: Sequence[Recording]) -> Played:
    pytest.importorskip("statemachine", reason="NOT TRIED, for there is no python-statemachine here")
    return [python_statemachine(recording) for recording in recordings]


def on_sismic(recordings: Sequence[Recording]) -> Played:
    pytest.importorskip("sismic", reason="NOT TRIED, for there is no sismic here")
    return [sismic_engine(recording) for recording in recordings]


OTHERS = (("Qt", on_qt), ("sismic", on_sismic)) if SECOND_LANE else ()
ENGINES: tuple[tuple[str, Callable[[Sequence[Recording]], Played]], ...] = (
    ("python-statemachine", on_python_statemachine),
    *OTHERS,
)
PARTS_OF_CHARTS = [pytest.param(partial(random_charts, part), id=f"random-{part}") for part in range(PARTS)]


@pytest.mark.parametrize("record", [*PARTS_OF_CHARTS, pytest.param(charts_of_files, id="files")])
def test_engines_do_the_same(record: Callable[[], tuple[tuple[str, Recording], ...]]) -> None:
    recorded = record()
    assert sum(len(recording.steps) for _, recording in recorded) > 5 * len(recorded)
    for engine, played in on_javascript([one for _, one in recorded]).items():
        assert wrong_in(engine, recorded, played) == []
    for engine, play in ENGINES:
        able = [pair for pair in recorded if engine != "sismic" or not any(limits(pair[1].chart))]
        assert 2 * len(able) > len(recorded), engine
        assert wrong_in(engine, able, play([one for _, one in able])) == []


def wrong_in(engine: str, recorded: Sequence[tuple[str, Recording]], played: Played) -> list[str]:
    """What an engine has done otherwise, at first, in each game."""
    return [
        f"{engine}, {name}: {difference}"
        for (name, recording), one in zip(recorded, played, strict=True)
        for difference in differences(recording, one)[:1]
    ]


COMPLETE = """\
system S
statechart c {
  state 0 OR  state 0.1 START  state 0.3 BASIC D  state 0.4 END
  state 0.2 AND
  state 0.2.1 OR  state 0.2.1.1 START  state 0.2.1.2 BASIC A  state 0.2.1.3 END
  state 0.2.2 OR  state 0.2.2.1 START  state 0.2.2.2 BASIC B  state 0.2.2.3 END
  0.1 -> 0.2 :  0.2.1.1 -> 0.2.1.2 :  0.2.2.1 -> 0.2.2.2 :
  0.2.1.2 -> 0.2.1.3 :  0.2.2.2 -> 0.2.2.3 :
  0.2 -> 0.3 : go
  0.2 -> 0.4 : hop
  0.3 -> 0.2 :
  exit 0.2 : / raise hop
}
team T { me : c }
"""


def test_a_composite_that_is_complete_goes_on_where_only_ends_are_active() -> None:
    """SCION ends a session as soon as all active states are final, also inner ones: it does all `exit`."""
    made = generate(COMPLETE)
    found = [Recorder(made, "c").record(Choices(f"complete {seed}")) for seed in range(8)]
    forget(made)
    recordings = [one for one in found if one is not None]
    ends = {"or_0", "and_0_2", "or_0_2_1", "end_0_2_1_3", "or_0_2_2", "end_0_2_2_3"}
    assert any(set(step.active or ()) == ends for one in recordings for step in one.steps[:-1])
    for played in on_javascript(recordings).values():
        assert [differences(*pair) for pair in zip(recordings, played, strict=True)] == [[]] * 8


def test_a_chart_that_means_something_else_is_noticed() -> None:
    """Completion as an event would be lost: a machine without its flags does otherwise."""
    pytest.importorskip("statemachine", reason="NOT TRIED, for there is no python-statemachine here")
    recording = next(found for name, found in charts_of_files() if "testbehavior" in name)
    forgetful = replace(recording, steps=tuple(replace(step, data={}) for step in recording.steps))
    assert differences(recording, python_statemachine(forgetful)) != []


def test_what_the_acceptance_files_have_that_engines_lack() -> None:
    made = generate((ROOT / "tests/acceptance/kouretes.aseme").read_text("utf-8"))
    refused = {refusal.feature for refusal in Recorder(made, "player").refused}
    forget(made)
    assert refused == {Foreign.SIGNALS}
