"""What activities start ends with the run: forks, programs, and what these have started in turn."""

from __future__ import annotations

import contextlib
import ctypes
import os
import pickle
import subprocess
import sys
from pathlib import Path

import psutil
import pytest

from aseme_dsl.runtime.activity.snapshot import Snapshot
from aseme_dsl.runtime.chart.board import Board
from aseme_dsl.runtime.chart.plan import ActivityInfo
from aseme_dsl.runtime.workers.descendants import ending_descendants
from aseme_dsl.runtime.workers.processes import get, put
from tests.cli.support import Done, asemec, command
from tests.support.waiting import LONG, long_enough, wait_until

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="processes are adopted on Linux only")

TEXT = """
system Starter
srm robot {
  liveness { robot = Fork . Begin . Detach . Work . Stay }
  activities { Work as process  Stay takes 100ms }
}
team Starters { one : robot }
"""
NOTE = """
from pathlib import Path
def note(number):
    Path("pids").open("a").write(f"{number}\\n")
"""
ACTIVITIES = {
    "fork": """
import os, time
from noted import note
class Fork:
    def execute(self, context):
        child = os.fork()
        if child == 0:
            os.closerange(0, 100)  # whoever reads our output must not wait for this one
            time.sleep(600)
            os._exit(0)
        note(child)
""",
    "begin": """
import subprocess
from noted import note
class Begin:
    def execute(self, context):
        note(subprocess.Popen(["sleep", "601"], stdout=-3, stderr=-3).pid)
""",
    "detach": """
import subprocess
from noted import note
class Detach:
    def execute(self, context):
        line = "setsid sleep 602 >/dev/null 2>&1 & echo $!"
        done = subprocess.run(["sh", "-c", line], stdout=subprocess.PIPE)
        note(int(done.stdout))
""",
    "work": """
import subprocess
from noted import note
class Work:
    def execute(self, context):
        note(subprocess.Popen(["sleep", "603"], stdout=-3, stderr=-3, start_new_session=True).pid)
""",
    "stay": "class Stay:\n    def execute(self, context):\n        pass\n",
}


@pytest.fixture
def project(tmp_path: Path) -> Path:
    (tmp_path / "starter.aseme").write_text(TEXT)
    (tmp_path / "noted.py").write_text(NOTE)
    (tmp_path / "activities").mkdir()
    for name, code in ACTIVITIES.items():
        (tmp_path / "activities" / f"{name}.py").write_text(code)
    return tmp_path


@pytest.mark.parametrize("ways", [(), ("--real",), ("--process-per-agent",)], ids=" ".join)
def test_what_an_activity_started_ends_with_the_run(project: Path, ways: tuple[str, ...]) -> None:
    bystander = subprocess.Popen(["sleep", "604"])
    try:

        def pids() -> list[int]:
            file = project / "pids"
            return [int(line) for line in file.read_text().split()] if file.exists() else []

        def run(seconds: int) -> Done:
            (project / "pids").unlink(missing_ok=True)
            options = ("--activities", "activities", "--for", f"{seconds}s", *ways)
            return asemec("run", "starter.aseme", *options, cwd=project, PYTHONPATH=str(project))

        done = long_enough(run, lambda done: len(pids()) == 4)
        started = pids()
        assert len(started) == 4, done
        wait_until(lambda: not any(_lives(number) for number in started))
        assert "was left behind by the run and has been killed: sleep 601" in done.err
        assert bystander.poll() is None
    finally:
        bystander.kill()
        bystander.wait()


STUBBORN = """
import os, signal, time
from noted import note
class NAME:
    def execute(self, context):
        first = os.fork()
        if first == 0:
            os.setsid()
            for number in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP):
                signal.signal(number, signal.SIG_IGN)
            if second := os.fork():
                note(second)  # before the activity returns, so that the numbers have an order
                os._exit(0)
            os.closerange(0, 100)
            time.sleep(600)
            os._exit(0)
        os.waitpid(first, 0)
        WAIT
"""


@pytest.mark.parametrize("ways", [("--real",), ("--process-per-agent",)], ids=" ".join)
def test_what_a_daemon_does_does_not_help_against_a_kill(project: Path, ways: tuple[str, ...]) -> None:
    """Where the run is killed, too, it is what is left of it that ends them: robots and workers."""
    code = {"fork": "", "work": "context.wait(600)"}
    for name, wait in code.items():
        text = STUBBORN.replace("NAME", name.capitalize()).replace("WAIT", wait)
        (project / "activities" / f"{name}.py").write_text(text)
    text = TEXT.replace("Fork . Begin . Detach . Work . Stay", "Fork . Work").replace(
        "  Stay takes 100ms", ""
    )
    (project / "starter.aseme").write_text(text)
    for name in ("begin", "detach", "stay"):
        (project / "activities" / f"{name}.py").unlink()
    run = subprocess.Popen(
        command("run", "starter.aseme", "--activities", "activities", *ways), cwd=project,
        env={**os.environ, "PYTHONPATH": str(project)}, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
    )  # fmt: skip
    pids = project / "pids"
    started: list[int] = []
    try:
        wait_until(lambda: pids.exists() and pids.read_text().count("\n") == 2)
        started = [int(line) for line in pids.read_text().split()]
        run.kill()
        # Nothing is left of a single process that was killed itself, but for its workers.
        ended = started if "--process-per-agent" in ways else started[1:]
        wait_until(lambda: not any(_lives(number) for number in ended))
    finally:
        run.kill()
        run.communicate()
        for number in started:
            with contextlib.suppress(psutil.NoSuchProcess):
                psutil.Process(number).kill()


LEAVING = """
import subprocess
class Leave:
    def execute(self, context):
        subprocess.Popen(["sleep", "604"], stdout=-3, stderr=-3, start_new_session=True)
"""


@pytest.mark.parametrize("says", [False, True], ids=["killed", "closed"])
def test_a_worker_kills_what_is_left_when_its_input_ends_without_a_word(tmp_path: Path, says: bool) -> None:
    """The pipes of a killed process end before its children have another parent."""
    (tmp_path / "leave.py").write_text(LEAVING)
    info = ActivityInfo("Leave", "process")
    snapshot = Snapshot("one", "Leave", "0.2", 0, "", info, Board(), {}, None, (), {})
    worker = subprocess.Popen(
        [sys.executable, "-m", "aseme_dsl.runtime.workers.worker", "0", ""],
        stdin=subprocess.PIPE, stdout=subprocess.PIPE,
    )  # fmt: skip
    assert worker.stdin is not None and worker.stdout is not None
    try:
        put(worker.stdin, ("run", "leave", str(tmp_path / "leave.py"), "Leave", "", snapshot))
        while (answer := pickle.loads(get(worker.stdout) or b""))[0] != "end":
            pass
        assert answer[1] is None, answer
        (left,) = psutil.Process(worker.pid).children()
        if says:
            put(worker.stdin, ("close",))
        worker.stdin.close()
        worker.wait(LONG)
        assert _lives(left.pid) == says
        if says:
            left.kill()
    finally:
        worker.kill()
        worker.wait()
        worker.stdin.close()
        worker.stdout.close()


def _lives(number: int) -> bool:
    try:
        return psutil.Process(number).status() != psutil.STATUS_ZOMBIE
    except psutil.NoSuchProcess:
        return False


def test_what_ran_before_goes_on_and_the_process_is_as_it_was() -> None:
    adopts = ctypes.c_int(-1)
    lines: list[str] = []
    before = subprocess.Popen(["sleep", "605"])
    try:
        with ending_descendants(lines.append):
            meanwhile = subprocess.Popen(["sleep", "606"])
        meanwhile.wait()
        assert _lives(before.pid)
        assert lines == [f"process {meanwhile.pid} was left behind by the run and has been killed: sleep 606"]
        ctypes.CDLL(None).prctl(37, ctypes.byref(adopts), 0, 0, 0)
        assert adopts.value == 0
    finally:
        before.kill()
        before.wait()
