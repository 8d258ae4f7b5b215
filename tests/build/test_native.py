"""`asemec build --native`: plain statecharts as machine code, which does the same as their Python."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests.cli.support import asemec

ROOM = """\
system Room

enum Colour { WHITE RED }
message Light { bool on  double level }
topic room { state Light }

srm lamp {
  var notes : int = 0
  var tired   : bool = false
  var colour  : Colour = Colour.WHITE
  liveness {
    lamp  = (shine || count)+
    shine = Dark . (Bright | Dim)
    count = Wait . Note+
  }
  control lamp { repeat (shine || count) : reset / notes = 0 }
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

GAME = """\
import json, random, sys
from plain.Room import Lamp
from plain.Room.messages import Light
import plain.Room.lamp as module

draw, lamp, seen = random.Random(5), Lamp(), []
lamp.start()
for step in range(400):
    lamp.now = step * 10_000_000
    if draw.random() < 0.3:
        lamp.bb.room_state_Light = Light(on=draw.random() < 0.8, level=draw.random())
    taken = lamp.send(draw.choice(("touch", "touch", "reset", "other")))
    seen.append([taken, lamp.configuration(), lamp.bb.notes, lamp.bb.tired, int(lamp.bb.colour)])
print(json.dumps([module.__file__, seen]))
"""


def play(folder: Path) -> tuple[str, object]:
    root = str(Path(__file__).parents[2])
    done = subprocess.run(
        [sys.executable, "-c", GAME], cwd=folder, env={**os.environ, "PYTHONPATH": root}, capture_output=True
    )
    assert done.returncode == 0, done.stderr.decode()
    file, seen = json.loads(done.stdout)
    return file, seen


def test_machine_code_does_the_same_and_goes_when_it_is_not_asked_for(tmp_path: Path) -> None:
    (tmp_path / "room.aseme").write_text(ROOM, "utf-8")
    build = ("build", "room.aseme", "--only", "plain", "-o", "out")
    folder = tmp_path / "out"
    done = asemec(*build, "--native", cwd=tmp_path)
    assert done.code == 0, done.err
    file, native = play(folder)
    assert not file.endswith(".py")
    again = asemec(*build, cwd=tmp_path)
    assert again.code == 0, again.err
    file, plain = play(folder)
    assert file.endswith(".py")
    assert native == plain


def test_only_what_is_plain_is_compiled(tmp_path: Path) -> None:
    (tmp_path / "room.aseme").write_text(ROOM, "utf-8")
    done = asemec("build", "room.aseme", "--native", cwd=tmp_path)
    assert done.code == 2
    assert "--native compiles what --backend plain makes: ask for that, too." in done.err


def test_a_compiler_that_fails_leaves_nothing(tmp_path: Path) -> None:
    (tmp_path / "room.aseme").write_text(ROOM, "utf-8")
    done = asemec("build", "room.aseme", "--only", "plain", "--native", cwd=tmp_path, CC="/no/such/cc")
    assert done.code == 1
    assert "plain/Room/lamp.py: error[E322]: this cannot be compiled: " in done.err
    assert not (tmp_path / "out").exists()


def test_mypyc_that_is_missing_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    from aseme_dsl.build import native
    from aseme_dsl.build.write import Planned

    monkeypatch.setitem(sys.modules, "mypyc", None)
    file = Planned("plain/Room/lamp.py", b"from aseme_dsl.runtime.plain import Plain\n", "plain")
    with pytest.raises(native.NativeError, match=r"pip install 'aseme-dsl\[native\]'"):
        list(native.compiled([file]))
