"""A run ends on SIGINT and SIGTERM whatever its activities do, and leaves nothing behind."""

from __future__ import annotations

import signal
import subprocess
import textwrap
from pathlib import Path

import psutil
import pytest

from tests.cli.support import command
from tests.support.traces import records_of
from tests.support.waiting import LONG, wait_until

TEXT = """
system Stubborn
srm robot {
  liveness { robot = Deaf || Busy || Blocking || Starter || Looping || Ready }
  activities { Busy as process }
}
"""
ACTIVITIES = {
    "deaf": """
        import time
        from pathlib import Path
        class Deaf:
            def execute(self, context):
                Path("deaf.begun").touch()
                while True:
                    try:
                        time.sleep(1000)
                    except BaseException:
                        pass
        """,
    "busy": """
        from pathlib import Path
        class Busy:
            def execute(self, context):
                Path("busy.begun").touch()
                while True:
                    pass
        """,
    "blocking": """
        import time
        from pathlib import Path
        class Blocking:
            async def execute(self, context):
                Path("blocking.begun").touch()
                time.sleep(1000)
        """,
    "starter": """
        import threading, time
        from pathlib import Path
        class Starter:
            def execute(self, context):
                threading.Thread(target=time.sleep, args=(1000,), name="mine", daemon=False).start()
                Path("starter.begun").touch()
                context.wait(1000)
        """,
    "looping": """
        from pathlib import Path
        class Looping:
            def execute(self, context):
                Path("looping.begun").touch()
                while True:
                    pass
        """,
    "ready": """
        from pathlib import Path
        class Ready:
            def execute(self, context):
                while len(list(Path().glob("*.begun"))) < OTHERS:
                    context.wait(0.01)
                context.log("ready")
                context.wait(1000)
        """,
}


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_signal_ends_a_run_whose_activities_never_would(number: int, tmp_path: Path) -> None:
    folder = tmp_path / "activities"
    folder.mkdir()
    (tmp_path / "stubborn.aseme").write_text(TEXT)
    for name, text in ACTIVITIES.items():
        (folder / f"{name}.py").write_text(textwrap.dedent(text).replace("OTHERS", "5"))
    started = subprocess.Popen(
        command("run", "stubborn.aseme", "--real", "--activities", "activities"),
        cwd=tmp_path,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    assert started.stdout is not None
    try:
        for line in started.stdout:
            if line.endswith("ready\n"):
                break
        children = psutil.Process(started.pid).children(recursive=True)
        assert children
        started.send_signal(number)
        out, err = started.communicate(timeout=LONG)  # the activities would take 1000 s and more
    finally:
        started.kill()
    assert started.returncode == (0 if number == signal.SIGTERM else 130), err
    assert "stopped" in out
    lines = records_of(tmp_path / "out/trace.jsonl.gz")
    reason = "terminated" if number == signal.SIGTERM else "interrupted"
    assert lines[-1]["kind"] == "finish" and lines[-1]["reason"] == reason
    reasons = " ".join(line["reason"] for line in lines if line["kind"] == "fault")
    for name in ("Deaf", "Busy", "Blocking", "Looping"):
        assert f"activity {name} of robot has not ended" in reasons
    assert "the thread mine, which an activity has started, still runs" in reasons
    gone, alive = psutil.wait_procs(children, timeout=LONG)
    assert gone and not alive


def _play_alone(folder: Path, activity: str) -> subprocess.Popen[str]:
    """A run of one activity, `Alone`, up to the moment at which that says `ready`."""
    (folder / "activities").mkdir()
    (folder / "alone.aseme").write_text("system Lonely\nsrm robot { liveness { robot = Alone } }\n")
    (folder / "activities" / "alone.py").write_text(textwrap.dedent(activity))
    started = subprocess.Popen(
        command("run", "alone.aseme", "--real", "--activities", "activities"),
        cwd=folder,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    assert started.stdout is not None
    for line in started.stdout:
        if line.endswith("ready\n"):
            break
    return started


def test_a_second_signal_ends_the_process_at_once(tmp_path: Path) -> None:
    started = _play_alone(tmp_path, ACTIVITIES["ready"].replace("Ready", "Alone").replace("OTHERS", "0"))
    try:
        started.send_signal(signal.SIGSTOP)  # so that both come before it can be over
        started.send_signal(signal.SIGINT)
        started.send_signal(signal.SIGTERM)
        started.send_signal(signal.SIGCONT)
        out, err = started.communicate(timeout=LONG)
    finally:
        started.kill()
    assert started.returncode in (130, 143), out + err  # that of the one that is taken second
    assert "played" not in out


def test_a_thread_that_ends_the_process_ends_all_and_leaves_the_trace(tmp_path: Path) -> None:
    started = _play_alone(
        tmp_path,
        """
        import os
        class Alone:
            def execute(self, context):
                context.log("ready")
                context.wait(1)
                os._exit(7)
        """,
    )
    try:
        started.communicate(timeout=LONG)
    finally:
        started.kill()
    assert started.returncode == 7
    lines = records_of(tmp_path / "out/trace.jsonl.gz.part")
    assert lines[0]["kind"] == "header" and lines[-1]["kind"] != "finish"
    assert "ready" in [line.get("text") for line in lines]


def test_workers_end_when_their_robot_is_killed(tmp_path: Path) -> None:
    """kill -9: nobody tells the workers, they notice."""
    folder = tmp_path / "activities"
    folder.mkdir()
    (tmp_path / "busy.aseme").write_text(
        "system Stubborn srm robot { liveness { robot = Busy || Ready } activities { Busy as process } }"
    )
    for name in ("busy", "ready"):
        (folder / f"{name}.py").write_text(textwrap.dedent(ACTIVITIES[name]).replace("OTHERS", "1"))
    started = subprocess.Popen(
        command("run", "busy.aseme", "--real", "--activities", "activities"),
        cwd=tmp_path,
        stdout=subprocess.PIPE,
        text=True,
    )
    assert started.stdout is not None
    try:
        for line in started.stdout:
            if line.endswith("ready\n"):
                break
        children = psutil.Process(started.pid).children(recursive=True)
    finally:
        started.kill()
    started.communicate(timeout=LONG)
    gone, alive = psutil.wait_procs(children, timeout=LONG)
    assert gone and not alive


STUCK = {
    "sleeps": "time.sleep(1000)",
    "computes": "while True: pass",
    "deaf": """
                while True:
                    try:
                        time.sleep(1000)
                    except BaseException:
                        pass
        """,
}
LOOK = """
import os, sys, time
from pathlib import Path
class Look:
    def execute(self, context):
        context.wait(WAITS)
        Path(f"{os.getpid()}.begun").touch()
        STUCK
"""


def _begin_stuck(folder: Path, code: str, *arguments: str, processes: int = 1) -> subprocess.Popen[str]:
    """A command that plays an activity in virtual time which never returns, once it runs."""
    (folder / "activities").mkdir()
    (folder / "activities" / "look.py").write_text(code)
    (folder / "lonely.aseme").write_text(
        "system Lonely\nsrm robot { liveness { robot = Look~ } control robot { repeat Look : } }\n"
        "team Crew { r[1..2] : robot }\n"
    )
    name, *options = arguments
    started = subprocess.Popen(
        command(name, "lonely.aseme", "--activities", "activities", *options),
        cwd=folder,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    )
    wait_until(lambda: len(list(folder.glob("*.begun"))) >= processes, pause=0.05)
    return started


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
@pytest.mark.parametrize("stuck", STUCK)
@pytest.mark.parametrize("waits", [0, 1], ids=["", "after a wait"])
def test_a_signal_ends_a_run_in_virtual_time_whose_activity_does_not_return(
    number: int, stuck: str, waits: int, tmp_path: Path
) -> None:
    code = LOOK.replace("STUCK", textwrap.dedent(STUCK[stuck]).strip().replace("\n", "\n        "))
    started = _begin_stuck(tmp_path, code.replace("WAITS", str(waits)), "run")
    try:
        started.send_signal(number)
        out, _ = started.communicate(timeout=LONG)
    finally:
        started.kill()
    assert started.returncode == 130, out
    assert "stopped" in out
    lines = records_of(tmp_path / "out/trace.jsonl.gz")
    assert lines[-1]["kind"] == "finish" and lines[-1]["reason"] == "interrupted"
    (fault,) = [line for line in lines if line["kind"] == "fault"]
    assert (fault["agent"], fault["activity"]) == ("r1", "Look")
    assert fault["reason"].startswith("activity Look of r1 has not ended 1 s after it was to (at look.py:")
    assert [line["agent"] for line in lines if line.get("what") == "cancel"] == ["r1", "r2"]


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGKILL])
@pytest.mark.parametrize("jobs", [1, 2])
def test_a_study_ends_with_its_processes_though_an_activity_does_not_return(
    number: int, jobs: int, tmp_path: Path
) -> None:
    code = LOOK.replace("STUCK", STUCK["sleeps"]).replace("WAITS", "0")
    options = (
        "optimise",
        "--measure",
        "Look",
        "--runs",
        "2",
        "--for",
        "5s",
        "--quicker",
        "1",
        "-j",
        str(jobs),
    )
    started = _begin_stuck(tmp_path, code, *options, processes=jobs)
    try:
        children = psutil.Process(started.pid).children(recursive=True)
        assert len(children) >= (jobs if jobs > 1 else 0)
        started.send_signal(number)
        out, _ = started.communicate(timeout=LONG)
    finally:
        started.kill()
    assert started.returncode in (-signal.SIGKILL, 130, 143), out
    assert "Traceback" not in out
    _, alive = psutil.wait_procs(children, timeout=LONG)
    assert not alive
