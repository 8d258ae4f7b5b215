"""`asemec build --native`: plain statecharts as machine code, which does the same as their Python."""

from __future__ import annotations

import importlib
import json
import os
import shutil
import subprocess
import sys
import sysconfig
from pathlib import Path

import pytest

from aseme_dsl.backends.backend import BackendOptions
from aseme_dsl.backends.plain.generate import module_text
from aseme_dsl.project.building import native as native_module
from aseme_dsl.project.building.native import native_source, run_mypyc
from tests.cli.support import Here, asemec
from tests.oracle.charts import text
from tests.oracle.choices import Choices
from tests.oracle.examples import forget
from tests.oracle.plain import without_limits
from tests.oracle.test_plain import Game
from tests.support.generated import Generated, generate, imported, system_of

EXAMPLES = int(os.environ.get("NATIVE_EXAMPLES", "1"))
"""So many random charts are compiled, which takes seconds."""
GAMES = 20

compiles = pytest.mark.skipif(
    shutil.which("cc") is None or not Path(sysconfig.get_path("include"), "Python.h").exists(),
    reason="NOT TRIED, for there is no C compiler here, or Python's headers: apt install gcc python3-dev",
)

ROOM = """\
system Room

enum Colour { WHITE RED }
message Light { bool on  double level  repeated int spots }
topic room { state Light }
function dim(int n) : bool = "lamps:dim"

srm lamp {
  var notes : int = 0
  var tired   : bool = false
  var colour  : Colour = Colour.WHITE
  var held    : int = 0
  liveness {
    lamp  = (shine || count || fetch)+
    shine = Dark . (Bright | Dim)
    count = Wait . Note+
    fetch = (Reach . Grasp . (Carry | Open | Report))~
  }
  activities { Grasp ends held, slipped, broken }
  control lamp { repeat (shine || count || fetch) : reset / notes = 0 }
  control fetch {
    enter Grasp  : [contains(room.state.Light.spots, 3) || notes > 2] / start_timer(patience, 40ms)
    enter Carry  : [outcome(Grasp) == held] / held = held + 1
    enter Open   : [outcome(Grasp) == slipped && !expired(patience)]
    enter Report : [dim(held) || expired(patience)]
    enter Report : error
    leave Open   : error
  }
  control shine {
    enter (Bright | Dim) : touch [room.state.Light.on]
    enter Bright : [room.state.Light.level > 0.5 && !tired] / colour = Colour.RED
    enter Dim    : else / tired = true
    leave Bright : touch or after(30ms)
    leave Dim    : touch
  }
  control count {
    enter  Note+ : touch / notes = notes + 1
    repeat Note  : touch [notes < 100000000000000] / notes = notes * 700000 + 1
  }
}
team Room { one : lamp }
"""

LAMPS = """\
def dim(n):
    if n % 4 == 3:
        raise ValueError(n)
    return n % 2 == 0
"""

GAME = """\
import json, random, sys
from aseme_dsl.runtime.plain.plain import ActivityFailed
from plain.Room import Lamp
from plain.Room.messages import Light
import plain.Room.lamp as module

draw, lamp, seen = random.Random(5), Lamp(), []

def move(kind):
    active = draw.choice(lamp.configuration())
    if kind == "done":
        try:
            return lamp.done(active)
        except ValueError as error:
            return str(error)
    if kind == "ended":
        return lamp.done(active, draw.choice(("held", "slipped", "broken")))
    if kind == "failed":
        try:
            return lamp.failed(active, "no battery")
        except ActivityFailed as error:
            return str(error)
    return lamp.send(kind) if kind else lamp.step()

lamp.start()
for step in range(600):
    lamp.now = step * 10_000_000
    if draw.random() < 0.3:
        spots = tuple(draw.randrange(5) for _ in range(draw.randrange(4)))
        lamp.bb.room_state_Light = Light(on=draw.random() < 0.8, level=draw.random(), spots=spots)
    kinds = ("touch", "touch", "reset", "other", "", "done", "done", "done", "ended", "ended", "failed")
    taken = move(draw.choice(kinds))
    bb = lamp.bb
    seen.append([taken, lamp.configuration(), bb.notes, bb.tired, int(bb.colour), bb.held])
    seen.append([lamp.failures, lamp.finished, lamp.due()])
print(json.dumps([module.__file__, seen]))
"""


TYPES = """\
from plain.Room import Lamp
from plain.Room.messages import Light

lamp = Lamp()
lamp.start()

def tell(call):
    try:
        call()
    except TypeError as error:
        print(type(error).__name__)
    else:
        print("taken")

for name, value in (("notes", 2.5), ("notes", None), ("tired", 1), ("held", "x"), ("notes", "3")):
    tell(lambda: setattr(lamp.bb, name, value))
lamp.bb.room_state_Light = Light(spots=[3])
reach = lamp.configuration()[-1]
tell(lambda: lamp.done(reach))
tell(lambda: type("Own", (Lamp,), {})())
"""


def room(folder: Path) -> None:
    (folder / "room.aseme").write_text(ROOM, "utf-8")
    (folder / "lamps.py").write_text(LAMPS, "utf-8")


def run(program: str, folder: Path) -> str:
    root = str(Path(__file__).parents[3])
    done = subprocess.run(
        [sys.executable, "-c", program],
        cwd=folder,
        env={**os.environ, "PYTHONPATH": root},
        capture_output=True,
    )
    assert done.returncode == 0, done.stderr.decode()
    return done.stdout.decode()


def play(folder: Path) -> tuple[str, object]:
    file, seen = json.loads(run(GAME, folder))
    return file, seen


@compiles
def test_machine_code_does_the_same_and_goes_when_it_is_not_asked_for(tmp_path: Path) -> None:
    room(tmp_path)
    build = ("build", "room.aseme", "--only", "plain", "-o", "out")
    folder = tmp_path / "out"
    folder.mkdir()
    (folder / "lamps.py").write_text(LAMPS, "utf-8")
    done = asemec(*build, "--native", cwd=tmp_path)
    assert done.code == 0, done.err
    file, native = play(folder)
    assert not file.endswith(".py")
    checked = run(TYPES, folder)
    # A list becomes a tuple.
    assert checked.splitlines() == [*["TypeError"] * 5, "taken", "TypeError"], checked
    again = asemec(*build, cwd=tmp_path)
    assert again.code == 0, again.err
    file, plain = play(folder)
    assert file.endswith(".py")
    assert native == plain


MANY = f"""
system Many
srm R {{
  liveness {{ R = ({" . ".join(f"S{number}" for number in range(70))})~ }}
  control R {{ {" ".join(f"enter S{number} : go" for number in range(1, 70))} leave S69 : go }}
}}
"""
"""So many states of one region that they are found in a table."""


def random_charts(count: int) -> list[tuple[Generated, str]]:
    """Random charts that are not refused, each with its text."""
    made: list[tuple[Generated, str]] = []
    seed = 0
    while len(made) < count:
        written = text(Choices(seed))
        system = without_limits(system_of(written), simple=False)
        if system is not None:
            made.append((imported(system), written))
        seed += 1
    return made


@compiles
def test_machine_code_of_random_charts_agrees_with_the_interpreter(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    if EXAMPLES == 1:  # the C compiler takes half as long; what users get is compared above
        monkeypatch.setattr(native_module, "_FLAGS", native_module._FLAGS.replace("-O2", "-O0"))
        monkeypatch.setattr(native_module, "_MYPYC", native_module._MYPYC.replace('"2"', '"0"'))
    charts = [*random_charts(EXAMPLES), (generate(MANY), MANY)]
    modules: list[str] = []
    for made, _ in charts:
        package = tmp_path / made.package.__name__
        package.mkdir()
        shutil.copy(made.folder / package.name / "messages.py", package)
        chart = made.system.iac("R")
        assert chart is not None
        source = native_source(module_text(made.system, chart, BackendOptions()))
        (package / "native.py").write_text(source, "utf-8")
        modules.append(f"{package.name}/native.py")
    done = run_mypyc(tmp_path, modules, "charts")
    assert done.returncode == 0, done.stdout + done.stderr
    monkeypatch.syspath_prepend(str(tmp_path))
    for seed, (made, written) in enumerate(charts):
        made.package.__path__.append(str(tmp_path / made.package.__name__))
        native = importlib.import_module(f"{made.package.__name__}.native")
        assert not str(native.__file__).endswith(".py")
        for turn in range(GAMES):
            game = Game(made, written)
            game.run_by(native.R)
            game.play(Choices(GAMES * seed + turn))
        forget(made)


def test_only_what_is_plain_is_compiled(tmp_path: Path) -> None:
    room(tmp_path)
    done = asemec("build", "room.aseme", "--native", cwd=tmp_path)
    assert done.code == 2
    assert "--native requires --backend plain." in done.err


def test_a_compiler_that_fails_leaves_nothing(tmp_path: Path) -> None:
    room(tmp_path)
    done = asemec("build", "room.aseme", "--only", "plain", "--native", cwd=tmp_path, CC="/no/such/cc")
    assert done.code == 1
    assert "plain/Room/lamp.py: error[E322]: this cannot be compiled: " in done.err
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("name", ["mypyc", "setuptools"])
def test_what_is_missing_is_said_as_elsewhere(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], name: str
) -> None:
    room(tmp_path)
    monkeypatch.setitem(sys.modules, name, None)
    build = ("build", tmp_path / "room.aseme", "--only", "plain", "--native", "-o", tmp_path / "out")
    done = Here(capsys)(*build)
    assert done.code == 1
    assert done.err.strip() == f"Error: --native needs {name}: pip install 'aseme-dsl[native]'"
    assert not (tmp_path / "out").exists()
