"""A real match with a process for each robot: what it takes of memory, threads and handles, and how it ends.

`benchmarks/real_match.py [MINUTES] [SIGINT|SIGTERM]` plays the example's team for 10 minutes of real time,
looks at the processes every few seconds, and ends the match with SIGINT. Exits with 1 if one of them grew,
was restarted, or took long to end. Memory is that of the last fifth of the time against that of the second.
"""

from __future__ import annotations

import os
import shutil
import signal
import socket
import statistics
import subprocess
import sys
import tempfile
import time
from collections import defaultdict
from pathlib import Path

import psutil

ROOT = Path(__file__).resolve().parent.parent
EVERY = 5.0
"""How often, in seconds, the processes are looked at."""
GROWTH = 0.01
"""How much more memory than before counts as growth."""
END = 2.0
"""How long, in seconds, the end may take."""
TEAM = ("robot1", "robot2", "robot3", "keeper")

WORLD = """
import world
from aseme_dsl.worlds.field.referee import SECOND, Rules

world.RULES = Rules(half_ns={seconds} * SECOND, halves=1)


def make(seed):
    return world.make(seed)
"""


def main(minutes: float, ending: signal.Signals) -> int:
    """Play, look, end it and tell."""
    folder = Path(tempfile.mkdtemp())
    project = folder / "robocup"
    shutil.copytree(ROOT / "examples" / "robocup", project, ignore=shutil.ignore_patterns("build"))
    (project / "long_world.py").write_text(WORLD.format(seconds=int(minutes * 60 + 600)))
    # Fixed addresses: else other teams on this machine come and go as neighbours, and are counted.
    with (project / "pyproject.toml").open("a") as file:
        hosts = ", ".join(f'{name} = "127.0.0.1:{_free_port()}"' for name in TEAM)
        file.write(f"\n[tool.asemec.deploy]\nhosts = {{ {hosts} }}\n")
    command = [sys.executable, "-m", "aseme_dsl", "run", str(project), "--process-per-agent"]
    command += ["--world", "long_world:make", "--for", f"{int(minutes) + 5}min"]
    team = subprocess.Popen(
        command, stdout=subprocess.PIPE, text=True, env={**os.environ, "PYTHONPATH": str(ROOT)}
    )
    assert team.stdout is not None
    first = team.stdout.readline()
    while first and "0:" not in first:
        first = team.stdout.readline()
    looked: dict[str, list[tuple[int, int, int]]] = defaultdict(list)
    end = time.monotonic() + minutes * 60
    while time.monotonic() < end and team.poll() is None:
        time.sleep(EVERY)
        _look(team.pid, looked)
    processes = psutil.Process(team.pid).children(recursive=True)
    began = time.monotonic()
    team.send_signal(ending)
    told = team.stdout.read()
    code = team.wait(30)
    took = time.monotonic() - began
    left = [process for process in processes if process.is_running()]
    print(told)
    fine = code == 130 and took < END and not left and "started" not in told
    for name, values in sorted(looked.items()):
        fine = _grew(name, values) and fine
    print(f"ended by {ending.name} with exit code {code} after {took:.2f} s; processes left: {len(left)}")
    sizes = sum(path.stat().st_size for path in (project / "build").glob("trace.*"))
    print(f"traces: {sizes / 1e6:.0f} MB")
    shutil.rmtree(folder)
    return 0 if fine else 1


def _free_port() -> int:
    with socket.socket() as found:
        found.bind(("127.0.0.1", 0))
        port: int = found.getsockname()[1]
        return port


def _look(team: int, looked: dict[str, list[tuple[int, int, int]]]) -> None:
    for child in psutil.Process(team).children():
        line = child.cmdline()
        name = line[line.index("node") + 1] if "node" in line else "the world"
        with child.oneshot():
            looked[name].append((child.memory_info().rss, child.num_threads(), child.num_fds()))


def _grew(name: str, values: list[tuple[int, int, int]]) -> bool:
    """Whether nothing grew, after telling how it was."""
    fifth = max(1, len(values) // 5)
    early, late = values[fifth : 2 * fifth] or values, values[-fifth:]
    fine, told = True, []
    for what, before, now in zip(("memory", "threads", "handles"), zip(*early), zip(*late), strict=True):  # noqa: B905
        first, last = statistics.median(before), statistics.median(now)
        fine = fine and last <= first * (1 + (GROWTH if what == "memory" else 0))
        shown = f"{first / 1e6:.1f} -> {last / 1e6:.1f} MB" if what == "memory" else f"{first:g} -> {last:g}"
        told.append(f"{what} {shown}")
    print(f"{name:<10} {'  '.join(told)}  {'' if fine else 'GREW'}")
    return fine


if __name__ == "__main__":
    sys.exit(
        main(
            float(sys.argv[1]) if len(sys.argv) > 1 else 10.0,
            signal.Signals[sys.argv[2]] if len(sys.argv) > 2 else signal.SIGINT,
        )
    )
