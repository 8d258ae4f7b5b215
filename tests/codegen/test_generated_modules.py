"""The generated modules: what they look like, and that the usual checkers find nothing in them."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from aseme_dsl.amola.system import System
from aseme_dsl.backends.backend import BackendOptions
from aseme_dsl.backends.monas import BACKEND
from aseme_dsl.compiler import analyse
from aseme_dsl.source import Source
from tests.conftest import Snapshot
from tests.support.generated import system_of

LIGHTS = """
system Lights
message Room { bool motion  double lux }
message Button { bool pressed  int hand }
topic room { state Room  signal Button }
function bright(Room r) : bool = "tests.support.functions:bright"
srm lamp {
  var presses : int = 0
  liveness { lamp = Watch~ || (Dark | Bright)+ }
  activities { Watch every 50ms  writes room.state.Room }
  control lamp {
    start (Dark | Bright)+ : / presses = 0
    enter Dark   : else
    enter Bright : [room.state.Room.motion && !bright(room.state.Room)]
    repeat (Dark | Bright) : room_changed or when [room.signal.Button.pressed] / presses = presses + 1
    repeat (Dark | Bright) : after(5min) [presses < 10]
    leave  (Dark | Bright) : [100 / presses <= 20]
  }
}
"""


def modules(system: System) -> dict[str, str]:
    return {item.path: item.text for item in BACKEND.generate(system, BackendOptions())}


def acceptance(name: str) -> System:
    path = Path(__file__).parents[1] / "acceptance" / name
    analysis = analyse(Source(name, path.read_text(encoding="utf-8")))
    assert analysis.system is not None
    return analysis.system


@pytest.mark.parametrize(
    "path",
    [
        "TestBehavior/__init__.py",
        "TestBehavior/messages.py",
        "TestBehavior/TestBehavior/plan.py",
        "TestBehavior/TestBehavior/step.py",
        "activities/no_play.py",
    ],
)
def test_the_smallest_useful_behaviour(path: str, snapshot: Snapshot) -> None:
    snapshot(modules(acceptance("testbehavior.aseme"))[path], path.replace("/", ".") + ".txt")


def test_what_may_raise_stands_in_a_method_of_its_own(snapshot: Snapshot) -> None:
    snapshot(modules(system_of(LIGHTS))["Lights/lamp/step.py"], "lights.step.py.txt")


@pytest.mark.parametrize(
    ("condition", "raises"),
    [
        ("presses / 2 >= 5", False),
        ("presses % -3 == 1", False),
        ("pause + 2 * pause > 3s", False),
        ("pause / 2 > 1s && pause / 2s > 1.5", False),
        ("pause * 0.5 > 1s && 1.5 * pause > 1s", False),
        ("100 / presses <= 20", True),
        ("presses % (presses - 1) == 0", True),
        ("pause * part > 1s", True),
        ("part * pause > 1s", True),
    ],
)
def test_a_condition_is_tried_only_if_it_may_raise(condition: str, raises: bool) -> None:
    variables = "var presses : int = 0 var pause : duration = 2s var part : double = 1.0"
    control = f"control lamp {{ enter Bright : [{condition}] }}"
    text = f"system S srm lamp {{ {variables} liveness {{ lamp = (Dark . Bright)~ }} {control} }}"
    assert ("except Exception" in modules(system_of(text))["S/lamp/step.py"]) is raises


def test_the_same_system_gives_the_same_bytes() -> None:
    assert modules(system_of(LIGHTS)) == modules(system_of(LIGHTS))


def written(folder: Path, *systems: System) -> Path:
    for system in systems:
        for name, text in modules(system).items():
            path = folder / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
    return folder


@pytest.fixture(scope="module")
def everything(tmp_path_factory: pytest.TempPathFactory) -> Path:
    names = ("testbehavior.aseme", "kouretes.aseme", "contract_net.aseme")
    return written(tmp_path_factory.mktemp("monas"), *map(acceptance, names), system_of(LIGHTS))


def checked(*command: str, folder: Path) -> str:
    done = subprocess.run(
        [sys.executable, "-m", *command], cwd=folder, capture_output=True, text=True, check=False
    )
    return "" if done.returncode == 0 else done.stdout + done.stderr


def test_ruff_finds_nothing_in_generated_code(everything: Path) -> None:
    assert checked("ruff", "check", "--isolated", "--no-cache", ".", folder=everything) == ""


def test_mypy_finds_nothing_in_generated_code(everything: Path) -> None:
    packages = [path.name for path in everything.iterdir() if path.is_dir() and path.name != "activities"]
    arguments = [argument for name in sorted(packages) for argument in ("-p", name)]
    assert checked("mypy", "--strict", *arguments, folder=everything) == ""


def test_generated_code_imports_only_the_runtime_and_the_standard_library(everything: Path) -> None:
    for path in everything.rglob("*.py"):
        for line in path.read_text(encoding="utf-8").splitlines():
            if line.startswith(("import ", "from ")):
                module = line.split()[1]
                known = module.split(".")[0] in sys.stdlib_module_names
                assert known or module.startswith((".", "aseme_dsl.runtime")), f"{path}: {line}"
