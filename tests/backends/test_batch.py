"""The batch backend: thousands of instances at once, with NumPy and with numba."""

from __future__ import annotations

import copy
import os
import pickle
import random
import subprocess
import sys
import warnings
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from aseme_dsl.backends.backend import BackendOptions, Refused
from aseme_dsl.backends.batch import BACKEND
from aseme_dsl.diagnostics import render_text
from aseme_dsl.runtime.plain.batch import BatchError
from aseme_dsl.runtime.plain.plain import Unsettled
from tests.support.batches import Together, made, without_compiling
from tests.support.generated import system_of
from tests.support.lanes import kept

ROBOT = """
system Team

enum Mood { CALM EAGER }

srm robot {
  var seen  : bool = false
  var near  : bool = false
  var mood  : Mood = Mood.CALM
  var shots : int = 0
  var power : double = 0.5
  liveness {
    robot = (look || play)~
    look  = Scan . Track
    play  = Walk . (Kick | Wait)
  }
  control robot { repeat (look || play) : }
  control look {
    enter Track : tick [seen]
    leave Track : tick [!seen || shots > 2] / mood = Mood.EAGER
  }
  control play {
    enter (Kick | Wait) : tick [near && (seen || mood == Mood.EAGER)]
    enter Kick : [power > 0.6] / shots = shots + 1; power = 0.0
    enter Wait : else / power = power + 0.25
    leave Kick : tick or after(20ms)
    leave Wait : tick
  }
}
"""


CIRCLES = """
system Circles
srm dancer {
  var dizzy : bool = false
  liveness { dancer = (Left . Right)~ }
  control dancer {
    enter Right : when [dizzy]
    repeat (Left . Right) : when [dizzy]
  }
}
"""


def test_each_instance_goes_its_own_way(tmp_path: Path) -> None:
    plain, batch = made(system_of(ROBOT), tmp_path, "robot")
    together = Together(plain, batch, 40, ("numpy", "numba"))
    together.start()
    draw = random.Random(7)
    for step in range(60):
        together.time(step * 5_000_000)
        for instance in range(40):
            together.set(instance, draw.choice(("seen", "near")), draw.random() < 0.6)
        together.send(draw.choice(("tick", "tick", "tock")))
    numpy, numba = together.batches.values()
    assert numpy.counts() == numba.counts()
    assert sum(chart.bb.shots for chart in together.scalars) == numpy.bb.shots.sum() > 40
    assert set(numpy.bb.mood) == {1}


@pytest.mark.parametrize("engine", ["numpy", "numba"])
def test_time_alone_makes_a_step(tmp_path: Path, engine: str) -> None:
    _, kind = made(system_of(ROBOT), tmp_path, "robot")
    with without_compiling():
        batch = kind(3, engine)
        batch.start()
        batch.bb.near = batch.bb.seen = [True, False, True]
        batch.bb.power = 1.0
        batch.send("tick")
        assert not batch.step().any()
        batch.now = 20_000_000
        assert batch.step().tolist() == [True, False, True]


@pytest.mark.parametrize("engine", kept(["numpy", "numba"], lambda engine: engine == "numpy"))
def test_a_variable_is_a_row_of_a_table(tmp_path: Path, engine: str) -> None:
    _, kind = made(system_of(ROBOT), tmp_path, "robot")
    with without_compiling():
        batch = kind(3, engine)
        for name, values in (("near", [True, False, True]), ("shots", [3, 4, 5]), ("power", [0.5, 1.5, 2.5])):
            table, row = batch.table(name)
            table[row] = values
            assert getattr(batch.bb, name).tolist() == values
        assert batch.table("seen")[0] is not None and not batch.bb.seen.any()
        with pytest.raises(KeyError, match="no variable stuck"):
            batch.table("stuck")


def test_roles_whose_modules_would_be_called_alike() -> None:
    text = (
        "system Two\nsrm a { liveness { a = Walk~ } }\nsrm a_compiled { liveness { a_compiled = Walk~ } }\n"
    )
    paths = [artefact.path for artefact in BACKEND.generate(system_of(text), BackendOptions())]
    assert sorted(paths) == [
        *(
            "Two/__init__.py",
            "Two/a.py",
            "Two/a_compiled.py",
            "Two/a_compiled_.py",
            "Two/a_compiled__compiled.py",
        )
    ]


def test_what_is_active_is_asked_of_all_at_once(tmp_path: Path) -> None:
    _, kind = made(system_of(ROBOT), tmp_path, "robot")
    batch = kind(3)
    batch.start()
    batch.bb.seen = [True, False, True]
    assert batch.send("tick").tolist() == [True, False, True]
    label = next(
        label for label in batch.configuration(0) if batch.active(label).tolist() == [True, False, True]
    )
    assert batch.counts()[label] == 2
    assert batch.finished.tolist() == [False] * 3
    with pytest.raises(KeyError, match="no leaf 9"):
        batch.active("9")
    with pytest.raises(AttributeError, match="there is no sen on this blackboard"):
        batch.bb.sen = True


def test_what_does_not_fit_on_the_blackboard_is_refused_by_its_name(tmp_path: Path) -> None:
    _, kind = made(system_of(ROBOT), tmp_path, "robot")
    batch = kind(3)
    for one in (True, [True], [True] * 3):
        batch.bb.seen = one
        assert batch.bb.seen.tolist() == [True] * 3
    for wrong, shape in (([True] * 4, "4"), ([[True] * 3] * 2, "2 by 3"), ([], "0")):
        wanted = f"seen wants one value for all, or an array of 3, not one of {shape}"
        with pytest.raises(ValueError, match=wanted):
            batch.bb.seen = wrong
    with pytest.raises(ValueError, match=r"seen cannot be set: .*inhomogeneous"):
        batch.bb.seen = [True, [True, False]]
    with pytest.raises(ValueError, match=r"shots cannot be set: .*'many'"):
        batch.bb.shots = "many"


def test_what_a_value_would_become_another_for_is_refused(tmp_path: Path) -> None:
    _, kind = made(system_of(ROBOT), tmp_path, "robot")
    batch = kind(3)
    batch.bb.shots = [1.0, 2.0, 3.0]
    batch.bb.seen = [0, 1, 1]
    batch.bb.power = [True, 2, 0.5]
    assert (batch.bb.shots.tolist(), batch.bb.seen.tolist()) == ([1, 2, 3], [False, True, True])
    for name, values, text in (
        ("shots", [1, 2.5, 3], "2.5 is not a whole number"),
        ("shots", float("nan"), "nan is not a whole number"),
        ("seen", [0, 1, 2], "2 is not a truth"),
    ):
        with pytest.raises(ValueError, match=f"{name} cannot be set: {text}"):
            setattr(batch.bb, name, values)
    assert batch.bb.shots.tolist() == [1, 2, 3]


@pytest.mark.parametrize("engine", kept(["numpy", "numba"], lambda engine: engine == "numpy"))
def test_nothing_is_done_or_known_before_the_start(tmp_path: Path, engine: str) -> None:
    _, kind = made(system_of(ROBOT), tmp_path, "robot")
    with without_compiling():
        batch = kind(3, engine)
        label = next(iter(kind.RUNNING), "0.2")
        for ask in (
            lambda: batch.send("tick"),
            lambda: batch.step(),
            lambda: batch.done(label, True),
            lambda: batch.active(label),
            lambda: batch.counts(),
            lambda: batch.configuration(0),
            lambda: batch.finished,
        ):
            with pytest.raises(BatchError, match=r"RobotBatch has not been started: call start\(\) first"):
                ask()
        batch.start()
        assert batch.active(batch.configuration(0)[-1]).all()


@pytest.mark.parametrize("engine", kept(["numpy", "numba"], lambda engine: engine == "numpy"))
def test_there_is_one_time_for_all(tmp_path: Path, engine: str) -> None:
    _, kind = made(system_of(ROBOT), tmp_path, "robot")
    with without_compiling():
        batch = kind(3, engine)
    for wrong in (np.arange(3), [1, 2, 3], 1.5):
        with pytest.raises(TypeError, match="now is one time for all instances, in whole ns, not "):
            batch.now = wrong
    batch.now = np.int64(7)
    assert batch.now == 7


def test_the_end_of_an_activity_is_for_those_in_which_it_runs(tmp_path: Path) -> None:
    text = """
system Doors
srm door {
  var locked : bool = false
  liveness { door = Open . Close }
  control door { leave Close : [locked] }
}
"""
    plain, kind = made(system_of(text), tmp_path, "door")
    together = Together(plain, kind, 4, ("numpy", "numba"))
    together.start()
    first, second = kind.RUNNING
    batch = together.batches["numpy"]
    for numbers in ([0, 1, 2], np.array([0, 1, 1, 0])):
        with pytest.raises(TypeError, match="which wants a truth for each instance, not values of type"):
            batch.done(first, numbers)
    with pytest.raises(ValueError, match="which wants one value for all, or an array of 4, not one of 3"):
        batch.done(first, [True] * 3)
    with pytest.raises(KeyError, match=r"DoorBatch has no leaf 9\.9"):
        batch.done("9.9", True)
    together.done(first, [True, True, True, False])
    together.done(second, [True, False, True, True])
    together.set(0, "locked", True)
    together.set(1, "locked", True)
    together.send("look")
    assert [chart.finished for chart in together.scalars] == [True, False, False, False]
    assert together.batches["numpy"].finished.tolist() == [True, False, False, False]


def test_a_step_that_always_takes_something_says_so(tmp_path: Path) -> None:
    text = "system S srm R { liveness { R = (A . B)~ } control R { enter B : go leave B : go } }"
    plain, kind = made(system_of(text), tmp_path, "R")
    with without_compiling():
        together = Together(plain, kind, 3, ("numpy", "numba"))
        together.start()
        together.send("go")
        together.send("go")


def test_what_is_constant_is_so_in_each_instance(tmp_path: Path) -> None:
    text = """
system Moods
enum Mood { CALM EAGER }
srm robot {
  var seen : bool = false
  var happy : bool = false
  liveness { robot = (A . B)~ }
  control robot {
    enter B : go [(Mood.CALM == Mood.CALM && 1 + 1 > 3) == false && (true || seen)] / happy = !(2 < 1)
    repeat (A . B) : go [Mood.CALM != Mood.EAGER]
  }
}
"""
    plain, kind = made(system_of(text), tmp_path, "robot")
    together = Together(plain, kind, 3, ("numpy", "numba"))
    together.start()
    together.set(1, "seen", True)
    together.send("go")
    together.send("go")
    assert together.batches["numpy"].bb.happy.all()


def test_an_instance_that_does_not_settle_is_named(tmp_path: Path) -> None:
    _, kind = made(system_of(CIRCLES), tmp_path, "dancer")
    for engine in ("numpy", "numba"):
        with without_compiling():
            sys.modules.pop(f"{kind.__module__}_compiled", None)
            batch = kind(3, engine)
        batch.start()
        batch.bb.dizzy = [False, True, False]
        with pytest.raises(Unsettled) as raised:
            batch.send("turn")
        said, names = str(raised.value), ", ".join(batch.names(1))
        assert said.startswith(f"instance 1 does not settle after 1000 rounds, at {names}: ")
        assert batch.names(1) != batch.configuration(1)
        assert "dizzy" in said and ".aseme:" in said


WAKING = """
system Circles
srm dancer {
  var lead : bool = false
  var dizzy : bool = false
  liveness { dancer = left || right  left = Left~  right = Right~ }
  control left { repeat Left : when [dizzy && !lead] / lead = true }
  control right { repeat Right : when [dizzy && lead] / lead = false }
}
"""


def test_regions_of_an_instance_that_wake_each_other_are_named(tmp_path: Path) -> None:
    _, kind = made(system_of(WAKING), tmp_path, "dancer")
    for engine in ("numpy", "numba"):
        with without_compiling():
            sys.modules.pop(f"{kind.__module__}_compiled", None)
            batch = kind(3, engine)
        batch.start()
        batch.bb.dizzy = [False, False, True]
        with pytest.raises(Unsettled) as raised:
            batch.step()
        said = str(raised.value)
        assert "at Left, Right: " in said
        assert ".aseme:7:" in said and ".aseme:8:" in said


def test_what_arrays_cannot_do_is_refused_with_all_places() -> None:
    text = """
system Lamp
message Touch { int x }
topic panel { state Touch }
function even(int n) : bool = "tests.support.functions:even"
srm lamp {
  var level : int = 0
  var name : string = "lamp"
  var share : double = 0.5
  var pause : duration = 2s
  var pace : duration = 2s
  liveness { lamp = (Dark . Shine)~ }
  control lamp {
    enter Shine : touched [panel.state.Touch.x > 2 && even(level)] / level = level % level
    repeat (Dark . Shine) : [name == "lamp" && pace / pause > 1] / level = level % (level - 4)
    leave Shine : off / pause = pause * share; level = level > 1 ? 1 : 2
  }
}
"""
    with pytest.raises(Refused) as refused:
        BACKEND.generate(system_of(text), BackendOptions())
    messages = {problem.message for problem in refused.value.diagnostics}
    start = "a batch of `lamp` cannot do this: "
    assert {message.removeprefix(start) for message in messages} == {
        "messages (what it sees are variables)",
        "functions that are written in Python",
        "division by what may be zero (by a number that is written there it can)",
        "a duration times what may be no number (times one that is written there it can)",
        "a choice between two values, `c ? a : b` (two transitions it can)",
        "values that are neither Booleans nor numbers",
    }
    shown = render_text(refused.value.diagnostics)
    assert shown.count("level % ") >= 2
    hints = {problem.hint for problem in refused.value.diagnostics}
    assert hints == {"`--backend plain` can, one instance at a time"}


def test_what_is_refused_for_one_reason_is_said_once() -> None:
    text = """
system Patrol
topic hw { signal Hit }
message Hit { int x }
srm robot {
  var level : int = 0
  liveness { robot = Try . Report . Rest+ }
  control robot {
    enter Report : error
    enter Report : [hw.signal.Hit.x > level]
    repeat Rest every 200ms : [level < 2]
    leave Rest : after(3s)
  }
  activities { Try takes 1s within 2s }
}
"""
    with pytest.raises(Refused) as refused:
        BACKEND.generate(system_of(text), BackendOptions())
    start = "a batch of `robot` cannot do this: "
    agents = "`--backend monas` makes agents of the roles, which can"
    plain = "`--backend plain` can, one instance at a time"
    found = [(problem.message.removeprefix(start), problem.hint) for problem in refused.value.diagnostics]
    assert sorted(found) == [
        ("signals (a program sends events)", agents),
        ("the deadline of an activity", agents),
        ("the outcome or the failure of an activity", plain),
        ("timers and `every` (there is `after`)", plain),
    ]


def test_what_cannot_fail_is_computed_as_by_the_plain_class(tmp_path: Path) -> None:
    text = """
system Sums
srm adder {
  var level : int = 7
  var real : double = 1.5
  var pause : duration = 2s
  var near : bool = false
  liveness { adder = (A . B)~ }
  control adder {
    enter B : go [level % 3 != 0 && !(real / -2 > 3)] / level = level % -4; pause = pause + 1s
    enter B : back [pause / 2 > 1s || near] / real = level / 3; pause = pause * 0.3
    enter B : less [min(level, 3) < max(real, level) && abs(real) < 9] / real = min(real, level) - abs(real)
    enter B : same [min(1, 2) == 1 && 7 % -4 == -1 && abs(-2) == 2] / pause = 1s / 3 + 2s * 0.25
    enter B : truths [(pause + 1s > 2s && near) != (level % 2 == 0)] / near = pause + 1s > 3s && !near
    enter B : also / near = ((pause - 1s > 1s || near) == (level % 3 > 1)) != near
    leave B : go [pause - 1s < 5s] / pause = pause * 2 / -3
    leave B :
    repeat (A . B) : / real = real % -0.7; level = level - 3
  }
}
"""
    plain, kind = made(system_of(text), tmp_path, "adder")
    together = Together(plain, kind, 8, ("numpy", "numba"))  # numba compiles
    together.start()
    draw = random.Random(3)
    for _ in range(60):
        for instance in range(8):
            together.set(instance, "near", draw.random() < 0.5)
            together.set(instance, "level", draw.randrange(-9, 9))
            together.set(instance, "real", draw.uniform(-5, 5))
            together.set(instance, "pause", draw.randrange(-4 * 10**9, 4 * 10**9))
        together.send(draw.choice(("go", "back", "less", "same", "truths", "also")))
    assert len(set(together.batches["numpy"].bb.real)) > 4


def test_an_engine_that_is_not_there_is_said(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    _, kind = made(system_of(ROBOT), tmp_path, "robot")
    with pytest.raises(BatchError, match="there is no engine numbra; there are numpy, numba"):
        kind(2, "numbra")
    monkeypatch.setitem(sys.modules, "numba", None)
    with pytest.raises(BatchError, match=r"pip install 'aseme-dsl\[numba\]'"):
        kind(2, "numba")


def test_without_numpy_it_is_said_what_to_install(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    text = ROBOT.replace("[!seen || shots > 2]", "[!seen || min(abs(shots), 9) > 2]")
    monkeypatch.setitem(sys.modules, "numpy", None)
    _, kind = made(system_of(text), tmp_path, "robot")
    with pytest.raises(BatchError, match=r"batches need NumPy: pip install 'aseme-dsl\[batch\]'"):
        kind(2)


@pytest.mark.long
def test_a_project_that_is_checked_may_have_batches_in_it(tmp_path: Path) -> None:
    _, kind = made(system_of(ROBOT), tmp_path, "robot")
    folder = Path(str(sys.modules[kind.__module__].__file__)).parent
    linted = subprocess.run(
        [sys.executable, "-m", "ruff", "check", "--isolated", "--no-cache", str(folder)],
        capture_output=True,
        text=True,
        check=False,
        timeout=600,
    )
    assert linted.returncode == 0, linted.stdout
    package = kind.__module__.rpartition(".")[0]
    user = tmp_path / "user.py"
    user.write_text(
        f"from {kind.__module__} import {kind.__name__}\n\n"
        f"batch = {kind.__name__}(3)\nbatch.now = 5\nbatch.now = 'soon'\n",
        "utf-8",
    )
    done = subprocess.run(
        [sys.executable, "-m", "mypy", "--strict", "-p", package, "-m", "user"],
        cwd=tmp_path,
        env=dict(os.environ, MYPYPATH=str(Path(__file__).parents[2])),
        capture_output=True,
        text=True,
        check=False,
        timeout=600,
    )
    assert "Found 1 error in 1 file (checked 4 source files)" in done.stdout, done.stdout + done.stderr
    assert 'user.py:5: error: Incompatible types in assignment (expression has type "str"' in done.stdout


NAMES = ("bb", "now", "r0", "r1", "t_0_2", "stuck", "moved", "writes", "w_n", "size", "sel")


@pytest.mark.parametrize("engine", kept(["numpy", "numba"], lambda engine: engine == "numpy"))
def test_a_variable_may_have_any_name(tmp_path: Path, engine: str) -> None:
    lines = "".join(f"  var {name} : int = {number}\n" for number, name in enumerate(NAMES))
    text = f"""
system S
srm R {{
{lines}  var n : int = 0
  liveness {{ R = (A . both . D)~  both = B . E || C . F }}
  control R {{
    enter both : go [{" + ".join(NAMES)} > 3] / {"; ".join(f"{name} = {name} + 1" for name in NAMES)}
    enter D : go [n > 1] / n = 0
    enter D : after(3s)
  }}
  control both {{ enter E : tick / n = n + 1  enter F : tick [n < 5] / n = n + 2 }}
}}
"""
    plain, batch = made(system_of(text), tmp_path, "R")
    together = Together(plain, batch, 3, (engine,))
    together.start()
    draw = random.Random(3)
    for step in range(30):
        together.time(step * 500_000_000)
        together.set(draw.randrange(3), "r0", draw.randrange(4))
        together.send(draw.choice(("tick", "go")))


@pytest.mark.parametrize("engine", kept(["numpy", "numba"], lambda engine: engine == "numpy"))
def test_what_a_plain_blackboard_calls_otherwise_is_called_as_in_the_document(
    tmp_path: Path, engine: str
) -> None:
    text = """
system S
srm R {
  var changed : int = 0
  var tracked : int = 7
  liveness { R = A . (B || C) . D }
  control R {
    enter (B || C) : go [tracked > 0] / changed = changed + 1; tracked = changed
    enter D : go / tracked = 5
  }
}
"""
    _, batch = made(system_of(text), tmp_path, "R")
    robots = batch(2, engine)
    robots.start()
    assert robots.send("go").tolist() == [True, True]
    assert (robots.bb.changed.tolist(), robots.bb.tracked.tolist()) == ([1, 1], [1, 1])


@pytest.mark.parametrize("engine", kept(["numpy", "numba"], lambda engine: engine == "numpy"))
def test_an_event_may_be_for_some_of_the_instances(tmp_path: Path, engine: str) -> None:
    plain, kind = made(system_of(ROBOT), tmp_path, "robot")
    together = Together(plain, kind, 4, (engine,))
    together.start()
    for instance in range(4):
        together.set(instance, "seen", True)
    together.send("tick", [True, False, True, False])
    together.step([False, True, True, False])
    together.send("tick", [False] * 4)
    batch = together.batches[engine]
    assert batch.send("tick", False).tolist() == [False] * 4
    for wrong in ([0, 2], np.array([0, 1, 1, 0])):
        with pytest.raises(TypeError, match="which wants a truth for each instance, not values of type"):
            batch.send("tick", wrong)
    with pytest.raises(ValueError, match="which wants one value for all, or an array of 4, not one of 3"):
        batch.step([True] * 3)
    together.send("tick")


def test_a_misspelt_event_is_told_where_that_is_wanted(tmp_path: Path) -> None:
    plain, kind = made(system_of(ROBOT), tmp_path, "robot")
    assert tuple(kind.EVENTS) == plain.EVENTS
    batch = kind(2)
    batch.start()
    assert not batch.send("tikc").any()
    strict = kind(2, strict=True)
    strict.start()
    strict.send("tick")
    with pytest.raises(ValueError, match=r"RobotBatch waits for no event 'tikc'; did you mean 'tick'\?"):
        strict.send("tikc")
    with pytest.raises(ValueError, match="RobotBatch waits for no event 'kick-off'; it waits for tick"):
        strict.send("kick-off")


@pytest.mark.parametrize("engine", kept(["numpy", "numba"], lambda engine: engine == "numpy"))
def test_a_number_that_is_no_constant_of_its_enum_is_refused(tmp_path: Path, engine: str) -> None:
    _, kind = made(system_of(ROBOT), tmp_path, "robot")
    with without_compiling():
        batch = kind(3, engine)
    batch.bb.mood = [0, 1, 1]
    for wrong in (7, [0, 7, 1]):
        with pytest.raises(ValueError, match="mood cannot be set: 7 is none of 0 CALM, 1 EAGER"):
            batch.bb.mood = wrong
    assert batch.bb.mood.tolist() == [0, 1, 1]


def test_how_many_instances_there_are_is_a_number(tmp_path: Path) -> None:
    _, kind = made(system_of(ROBOT), tmp_path, "robot")
    with pytest.raises(ValueError, match="RobotBatch wants no instance or more, not -1"):
        kind(-1)
    for wrong in ("10", 1e4):
        with pytest.raises(TypeError, match=f"RobotBatch wants a whole number of instances, not {wrong!r}"):
            kind(wrong)
    none = kind(np.int64(0))
    none.start()
    assert none.send("tick").shape == (0,)
    with pytest.raises(IndexError, match="RobotBatch of 0 has no instance 0"):
        none.configuration(0)


@pytest.mark.parametrize("engine", kept(["numpy", "numba"], lambda engine: engine == "numpy"))
def test_a_debugger_shows_what_is_active(tmp_path: Path, engine: str) -> None:
    _, kind = made(system_of(ROBOT), tmp_path, "robot")
    with without_compiling():
        batch = kind(3, engine)
        assert repr(batch) == f"<RobotBatch of 3, {engine}: not started>"
        batch.start()
        batch.bb.seen = [True, False, True]
        batch.send("tick")
    first, second = batch.configuration(0)[1], batch.configuration(1)[1]
    assert f"<RobotBatch of 3, {engine}: " in repr(batch)
    assert f"1 at {second}, 2 at {first}" in repr(batch)
    assert "seen: [ True False  True]; near: [False False False]" in repr(batch.bb)
    assert len(repr(kind(100_000).bb)) < 500


@pytest.mark.parametrize("engine", kept(["numpy", "numba"], lambda engine: engine == "numpy"))
@pytest.mark.parametrize("means", [copy.copy, copy.deepcopy, lambda batch: pickle.loads(pickle.dumps(batch))])
def test_a_copy_goes_on_alone(tmp_path: Path, engine: str, means: Any) -> None:
    plain, kind = made(system_of(ROBOT), tmp_path, "robot")
    with without_compiling():
        together = Together(plain, kind, 3, (engine,))
        batch = together.batches[engine]
        together.start()
        together.time(7)
        together.set(1, "seen", True)
        together.send("tick")
        before = [batch.configuration(instance) for instance in range(3)]
        other = means(batch)
        together.batches[engine] = other
        together.compare("copy")
        table, row = other.table("near")
        table[row] = [True, False, True]
        assert other.bb.near.tolist() == [True, False, True] and not batch.bb.near.any()
        other.bb.near = False
        together.set(0, "seen", True)
        together.send("tick")
        assert [batch.configuration(instance) for instance in range(3)] == before
        assert not batch.bb.seen[0] and (other.now, other.size) == (7, 3)
        board = copy.deepcopy(batch.bb)
        board.seen = True
        assert not batch.bb.seen[0]
        with pytest.raises(ValueError, match="mood cannot be set"):
            board.mood = 9


def test_numbers_that_get_too_large_are_as_silent_as_in_python(tmp_path: Path) -> None:
    text = """
system Sums
srm adder {
  var real : double = 1.0
  var less : double = 0.0
  liveness { adder = (A . B)~ }
  control adder {
    enter B : go / real = real * real; less = real - real
    repeat (A . B) :
  }
}
"""
    plain, kind = made(system_of(text), tmp_path, "adder")
    one, batch = plain(), kind(2)
    one.bb.real = batch.bb.real = 1e300
    one.start()
    batch.start()
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for _ in range(2):
            one.send("go")
            batch.send("go")
    assert repr(batch.bb.real.tolist()) == repr([one.bb.real] * 2) == "[inf, inf]"
    assert repr(batch.bb.less.tolist()) == repr([one.bb.less] * 2)


def test_an_instance_that_did_not_settle_does_not_stop_the_others_later(tmp_path: Path) -> None:
    _, kind = made(system_of(CIRCLES), tmp_path, "dancer")
    batch = kind(3)
    batch.start()
    batch.bb.dizzy = [False, True, False]
    with pytest.raises(Unsettled, match="instance 1"):
        batch.send("turn")
    assert batch.send("turn", [True, False, True]).tolist() == [False] * 3
