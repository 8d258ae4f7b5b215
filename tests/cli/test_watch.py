"""`--watch`: a real process, whose files somebody edits, breaks, mends, renames and deletes."""

from __future__ import annotations

import os
import queue
import re
import signal
import subprocess
import threading
from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path

import pytest

from tests.cli.support import BAD, GOOD, Here, asemec, command, save

PATIENCE = 60.0
"""How long a line may take, in s: an answer to whether it comes at all."""

ROBOT = GOOD[GOOD.index("srm") : GOOD.index("team")]
SYSTEM = f'import "robot.aseme"\nsystem Walker\n{GOOD[GOOD.index("team") :]}'
LIBRARY = f"{GOOD[GOOD.index('message') : GOOD.index('srm')]}{ROBOT}"


class Watching:
    """A command that watches, and what it says."""

    def __init__(self, folder: Path, *arguments: object) -> None:
        self.process = subprocess.Popen(
            command(*arguments, "--watch"),
            cwd=folder,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            encoding="utf-8",
            start_new_session=True,
        )
        self.lines: queue.Queue[str | None] = queue.Queue()
        self.reader = threading.Thread(target=self._read)
        self.reader.start()

    def __enter__(self) -> Watching:
        return self

    def __exit__(self, *failure: object) -> None:
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()
        self.reader.join()
        assert self.process.stdout is not None
        self.process.stdout.close()

    def _read(self) -> None:
        assert self.process.stdout is not None
        for line in self.process.stdout:
            self.lines.put(line)
        self.lines.put(None)

    def until(self, wanted: str) -> str:
        """All that is said up to the next line in which this is (a regular expression)."""
        said = ""
        while True:
            try:
                line = self.lines.get(timeout=PATIENCE)
            except queue.Empty:
                pytest.fail(f"{wanted!r} is not said; {said!r} is")
            assert line is not None, f"it ended, and said {said!r}"
            said += line
            if re.search(wanted, line):
                return said

    def stop(self) -> int:
        self.process.send_signal(signal.SIGINT)
        return self.process.wait(PATIENCE)


@pytest.fixture
def project(tmp_path: Path) -> Iterator[Path]:
    (tmp_path / "walker.aseme").write_text(SYSTEM, "utf-8")
    (tmp_path / "robot.aseme").write_text(LIBRARY, "utf-8")
    yield tmp_path


@pytest.fixture
def watching(project: Path) -> Iterator[Watching]:
    arguments = ("build", "walker.aseme", "-o", "out", "--only", "models", "--only", "monas")
    with Watching(project, *arguments) as found:
        found.until("watching")
        yield found


def contents(folder: Path) -> dict[str, bytes]:
    return {
        path.relative_to(folder).as_posix(): path.read_bytes()
        for path in sorted(folder.rglob("*"))
        if path.is_file()
    }


def test_what_is_edited_is_built_again(project: Path, watching: Watching) -> None:
    before = contents(project / "out")
    save(project / "robot.aseme", LIBRARY.replace("Walk takes 1s", "Walk takes 2s"))
    said = watching.until(r"Walker -> out")
    assert "robot.aseme changed\n" in said
    assert "changed models/srm.robot.json, monas/Walker/__init__.py, monas/Walker/robot/plan.py (" in said
    after = contents(project / "out")
    assert {name for name in after if after[name] != before.get(name)} == {
        ".asemec.json",
        "models/srm.robot.json",
        "monas/Walker/__init__.py",
        "monas/Walker/robot/plan.py",
    }
    asemec("build", "walker.aseme", "-o", "fresh", "--only", "models", "--only", "monas", cwd=project)
    assert contents(project / "fresh") == after
    with (project / "robot.aseme").open("a", encoding="utf-8") as file:  # in place
        file.write("// the end\n")
    # The package holds the text of its model, and nothing else has changed.
    assert "changed monas/Walker/__init__.py (" in watching.until(r"Walker -> out")
    assert watching.stop() == 0
    assert not [name for name in contents(project) if ".asemec-" in name]


def test_behaviours_are_what_a_build_from_nothing_writes(project: Path) -> None:
    arguments = ("build", "walker.aseme", "--backend", "jade_like", "--only", "jade_like")
    after = LIBRARY.replace("srm", "// one\n\n// two\nsrm", 1)
    texts = (
        after,  # every place moves
        after.replace("Stand : else", "Stand : after(3s)"),
        after.replace("(Walk | Stand)", "(Walk | Stand | Sit)").replace(
            "enter Walk", "enter Sit : go\n    enter Walk"
        ),
        LIBRARY,
    )
    with Watching(project, *arguments, "-o", "out") as watching:
        watching.until("watching")
        for number, text in enumerate(texts):
            save(project / "robot.aseme", text)
            watching.until(r"Walker -> out|error")
            done = asemec(*arguments, "-o", f"fresh{number}", cwd=project)
            assert done.code == 0, done.err
            fresh, now = (contents(project / name / "jade_like") for name in (f"fresh{number}", "out"))
            assert fresh == now
        watching.stop()


def test_what_is_broken_is_told_and_the_last_good_output_stays(project: Path, watching: Watching) -> None:
    before = contents(project / "out")
    save(project / "robot.aseme", LIBRARY.replace("eyes.state.Seen.ball", "eyes.state.Sen.ball"))
    said = watching.until("the previous build is unchanged")
    assert "robot.aseme:7:31: error[" in said and "did you mean" in said
    assert "1 error; the previous build is unchanged (" in said
    assert contents(project / "out") == before
    save(project / "robot.aseme", LIBRARY.replace("srm robot {", "srm robot {{"))
    assert "error[E1" in watching.until("the previous build is unchanged")
    save(project / "robot.aseme", LIBRARY)
    assert "no change" in watching.until("Walker -> out")
    assert contents(project / "out") == before


def test_files_that_are_renamed_deleted_and_come_back(project: Path, watching: Watching) -> None:
    (project / "robot.aseme").rename(project / "android.aseme")
    said = watching.until("the previous build is unchanged")
    assert "robot.aseme was deleted" in said and "error[E004]: there is no file robot.aseme" in said
    save(project / "walker.aseme", SYSTEM.replace("robot.aseme", "android.aseme"))
    assert "walker.aseme changed" in watching.until("Walker -> out")
    save(project / "android.aseme", LIBRARY.replace("Walk takes 1s", "Walk takes 3s"))
    assert "android.aseme changed" in watching.until("Walker -> out")
    (project / "walker.aseme").unlink()
    assert "walker.aseme was deleted" in watching.until("the previous build is unchanged")
    save(project / "walker.aseme", SYSTEM.replace("robot.aseme", "android.aseme"))
    assert "walker.aseme is new" in watching.until("Walker -> out")


def test_what_is_no_longer_generated_is_removed_and_told(project: Path, watching: Watching) -> None:
    renamed = LIBRARY.replace("srm robot", "srm android").replace("robot =", "android =")
    save(project / "robot.aseme", renamed.replace("control robot", "control android"))
    assert "error[" in watching.until("the previous build is unchanged")
    save(project / "walker.aseme", SYSTEM.replace(": robot", ": android"))
    said = watching.until("Walker -> out")
    assert "removed models/iac.robot.json" in said
    assert not (project / "out" / "monas" / "Walker" / "robot").exists()
    assert (project / "out" / "monas" / "Walker" / "android" / "step.py").exists()


def test_configuration_activities_and_output_count_too(project: Path, watching: Watching) -> None:
    save(project / "pyproject.toml", '[tool.asemec]\nlabels = "wrong"\n')
    said = watching.until("the previous build is unchanged")
    assert "pyproject.toml is new" in said and "pyproject.toml:2" in said
    (project / "pyproject.toml").unlink()
    assert "pyproject.toml was deleted" in watching.until("Walker -> out")
    activity = project / "out" / "monas" / "activities" / "walk.py"
    text = activity.read_text("utf-8")
    save(activity, f"{text}        context.read('eyes.state.Seem')\n")
    said = watching.until("W530")
    assert "walk.py changed" in said
    watching.until("Walker -> out")
    save(activity, text)
    watching.until("Walker -> out")
    step = project / "out" / "monas" / "Walker" / "robot" / "plan.py"
    mine = step.read_text("utf-8") + "# mine\n"
    save(step, mine)
    save(project / "robot.aseme", LIBRARY.replace("Walk takes 1s", "Walk takes 5s"))
    assert "was edited since it was generated" in watching.until("the previous build is unchanged")
    assert step.read_text("utf-8") == mine


@pytest.mark.skipif(
    find_spec("grpc_tools") is None, reason="grpcio-tools is not installed: no .proto imports"
)
def test_imported_proto_files_count_with_those_behind_them(project: Path) -> None:
    save(project / "inner.proto", 'syntax = "proto3";\nmessage Point { double x = 1; }\n')
    (project / "seen.proto").write_text(
        'syntax = "proto3";\nimport "inner.proto";\nmessage Spot { Point at = 1; }\n', "utf-8"
    )
    text = GOOD.replace("state Seen }", "state Seen  state Spot }")
    (project / "walker.aseme").write_text(f'import "seen.proto"\n{text}', "utf-8")
    with Watching(project, "build", "walker.aseme", "--only", "monas") as watching:
        watching.until("watching")
        save(project / "inner.proto", 'syntax = "proto3";\nmessage Point { double y = 1; }\n')
        said = watching.until("Walker -> out")
        assert "inner.proto changed" in said and "changed monas/Walker/__init__.py" in said
        assert "y: float" in (project / "out" / "monas" / "Walker" / "messages.py").read_text("utf-8")
        (project / "inner.proto").unlink()
        assert "error[E007]" in watching.until("the previous build is unchanged")
        save(project / "inner.proto", 'syntax = "proto3";\nmessage Point { double z = 1; }\n')
        assert "inner.proto is new" in watching.until("Walker -> out")


def test_check_tells_what_is_new_in_a_folder(tmp_path: Path) -> None:
    (tmp_path / "walker.aseme").write_text(GOOD, "utf-8")
    with Watching(tmp_path, "check", ".") as watching:
        assert "no problems found in 1 file (" in watching.until("no problems")
        watching.until("watching")
        (tmp_path / "inner").mkdir()
        watching.until("no problems")
        save(tmp_path / "inner" / "bad.aseme", BAD)
        said = watching.until("errors? in 2 files|errors, .* in 2 files")
        assert "bad.aseme" in said and "error[" in said
        save(tmp_path / "inner" / "bad.aseme", GOOD)
        watching.until("no problems found in 2 files")
        assert watching.stop() == 0


def test_a_note_that_has_become_an_error_is_told(tmp_path: Path) -> None:
    text = GOOD.replace("  liveness", "  var tries : int = 0\n  liveness", 1)
    text = text.replace("Seen.ball]", "Seen.ball] / tries = tries + 1")
    (tmp_path / "walker.aseme").write_text(text, "utf-8")
    with Watching(tmp_path, "check", "walker.aseme") as watching:
        watching.until("watching")
        for severity in ("error", "note"):
            save(tmp_path / "pyproject.toml", f'[tool.asemec.diagnostics]\nN725 = "{severity}"\n')
            said = watching.until(r"1 \w+ in 1 file")
            assert f"{severity}[N725]" in said and "as before" not in said


def test_an_unknown_backend_in_the_configuration_can_be_mended(project: Path, watching: Watching) -> None:
    save(project / "pyproject.toml", '[tool.asemec]\nbackends = ["monass"]\n')
    watching.until("monass")
    save(project / "pyproject.toml", "[tool.asemec]\n")
    watching.until("Walker -> out")


@pytest.mark.parametrize(
    "arguments",
    [("build", "-"), ("check", "-"), ("check", "--json"), ("check", "--fix"), ("build", "--json")],
)
def test_what_does_not_go_together(here: Here, arguments: tuple[str, ...], folder: Path) -> None:
    done = here(*arguments, "--watch")
    assert done.code == 2 and "--watch" in done.err


def test_a_first_build_that_fails_is_waited_for(tmp_path: Path) -> None:
    with Watching(tmp_path, "build", "walker.aseme", "--only", "models") as watching:
        assert "there is no file walker.aseme" in watching.until("the previous build is unchanged")
        watching.until("watching")
        save(tmp_path / "walker.aseme", GOOD)
        watching.until("Walker -> out: new")
        os.kill(watching.process.pid, signal.SIGTERM)
        assert watching.process.wait(PATIENCE) == 143
