"""A small team as real processes, for tests that do bad things to them."""

from __future__ import annotations

import contextlib
import os
import re
import signal
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import psutil

from aseme_dsl.runtime.trace.trace_files import TraceError
from tests.support.network import own_name
from tests.support.traces import records_of
from tests.support.waiting import LONG, wait_until

ROOT = Path(__file__).resolve().parents[2]

NAME = own_name("Talk")
"""What the team is called, on the network, too."""

TEAM = """
system TALK
message Tick { int n  string who }
topic team { state Tick  signal Tick queued }
srm robot {
  liveness { robot = Say~ || Hear~ }
  activities {
    Say every 20ms writes team.state.Tick, team.signal.Tick
    Hear every 20ms reads team.state.Tick, team.signal.Tick, robot1.team.signal.Tick, robot2.team.signal.Tick,
      robot3.team.signal.Tick
  }
}
team T { robot[1..3] : robot }
""".replace("TALK", NAME)

SAY = """
from aseme_dsl.runtime import Context
from monas.TALK.messages import Tick


class Say:
    def execute(self, context: Context) -> None:
        Say.n = getattr(Say, "n", 0) + 1
        context.publish("team.signal.Tick", Tick(n=Say.n, who=context.agent))
        context.publish("team.state.Tick", Tick(n=Say.n, who=context.agent))
""".replace("TALK", NAME)

HEAR = """
from aseme_dsl.runtime import Context


class Hear:
    def execute(self, context: Context) -> None:
        pass
"""


def project(folder: Path, lease: str = f"{LONG:g}s", **files: str) -> Path:
    """A project with that team. After `lease` a robot that stands still is gone, as on a busy machine."""
    (folder / "activities").mkdir(parents=True)
    (folder / "pyproject.toml").write_text(
        '[tool.asemec]\nfiles = ["talk.aseme"]\noutput = "out"\nactivities = "activities"\n'
        + f'[tool.asemec.deploy]\nlease = "{lease}"\n'
        + files.get("configuration", "")
    )
    (folder / "talk.aseme").write_text(files.get("text", TEAM))
    (folder / "activities" / "say.py").write_text(files.get("say", SAY))
    (folder / "activities" / "hear.py").write_text(files.get("hear", HEAR))
    return folder


PATIENT = f"""
import sys
from aseme_dsl.project.playing import supervisor
from aseme_dsl.cli import main
supervisor.START = supervisor.END = supervisor.SETTLED = {LONG}
sys.exit(main(sys.argv[1:]))
"""
"""`python -m aseme_dsl` that takes no robot for stuck because a busy machine lets it begin or end slowly."""


class Started:
    """`asemec run --team … --process-per-agent`, while it runs."""

    def __init__(self, folder: Path, *arguments: str) -> None:
        self.folder = folder
        self.process = subprocess.Popen(
            [
                sys.executable,
                "-c",
                PATIENT,
                "run",
                "--team",
                str(folder),
                "--process-per-agent",
                *arguments,
            ],
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            env={**os.environ, "PYTHONPATH": str(ROOT), "PYTHONUNBUFFERED": "1"},
        )
        self.lines: list[str] = []
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()

    def _read(self) -> None:
        assert self.process.stdout is not None
        for line in self.process.stdout:
            self.lines.append(line.rstrip("\n"))

    def robots(self) -> dict[str, psutil.Process]:
        """The robots' processes by name."""
        found = {}
        for child in psutil.Process(self.process.pid).children():
            try:
                line = child.cmdline()
            except psutil.Error:
                continue
            if "node" in line:
                found[line[line.index("node") + 1]] = child
        return found

    def trace(self, robot: str, life: int = 1) -> list[dict[str, Any]]:
        """What is in a trace so far."""
        name = f"trace.{robot}{'' if life == 1 else f'.{life}'}.jsonl.gz"
        whole, part = self.folder / "out" / name, self.folder / "out" / f"{name}.part"
        for path in (whole, part, whole):  # it may get its name between two looks
            with contextlib.suppress(TraceError):  # it is not there, or has no line yet
                return records_of(path)
        return []

    def news(self, robot: str) -> list[str]:
        """What a robot's trace says of its peers so far: `robot2 there`."""
        return [f"{r['peer']} {r['what']}" for r in self.trace(robot) if r["kind"] == "peer"]

    def wait_for(self, condition: Callable[[], object]) -> None:
        """Fails, with what was printed, if it does not happen."""

        def is_over() -> bool:
            return bool(condition()) or self.process.poll() is not None

        with contextlib.suppress(AssertionError):
            wait_until(is_over, pause=0.1)  # the traces are long
        assert condition(), "it did not happen:\n" + "\n".join(self.lines)

    def wait_for_talk(self) -> None:
        """Until each robot has heard each other one."""

        def all_heard() -> bool:
            return all(
                {r["input"][0] for r in self.trace(name) if r["kind"] == "arrived"} == others
                for name, others in (
                    ("robot1", {"robot2", "robot3"}),
                    ("robot2", {"robot1", "robot3"}),
                    ("robot3", {"robot1", "robot2"}),
                )
            )

        self.wait_for(all_heard)

    def end(self, number: int = signal.SIGINT) -> int:
        """End it, and wait for that."""
        if self.process.poll() is None:
            self.process.send_signal(number)
        code = self.process.wait(LONG)
        self._reader.join(LONG)
        if self.process.stdout is not None:
            self.process.stdout.close()
        return code

    def said(self, pattern: str) -> bool:
        """Whether a line was printed that has this in it."""
        return any(re.search(pattern, line) for line in list(self.lines))


@contextmanager
def started(folder: Path, *arguments: str) -> Iterator[Started]:
    """A team that is ended at the end, whatever happens."""
    run = Started(folder, *arguments)
    try:
        yield run
    finally:
        children: list[psutil.Process] = []
        with contextlib.suppress(psutil.Error):  # it has ended
            children = psutil.Process(run.process.pid).children(recursive=True)
        try:
            run.end()
        finally:
            for process in (*children, run.process):
                with contextlib.suppress(psutil.Error):
                    process.kill()


def signals_from(trace: list[dict[str, Any]], sender: str) -> list[int]:
    """The numbers of the signals that have come from a robot, in order."""
    return [
        r["message"]["n"]
        for r in trace
        if r["kind"] == "arrived" and r["channel"] == "team.signal.Tick" and r["message"]["who"] == sender
    ]


def gone(processes: list[psutil.Process]) -> bool:
    def is_gone(process: psutil.Process) -> bool:
        try:
            return not process.is_running() or process.status() == psutil.STATUS_ZOMBIE
        except psutil.NoSuchProcess:  # since it was asked whether it runs
            return True

    return wait_until(lambda: all(map(is_gone, processes)), pause=0.02)
