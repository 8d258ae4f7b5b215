"""How soon one changed file of a project of 10 000 lines is built again, and what commands take to start.

Run by hand: `python3 dev.py long`, or `python benchmarks/rebuild.py [LINES]`. A real `asemec build --watch`
builds a project of many files (a system, and what it imports), of which one is changed again and again: how
long an activity takes, a condition, a formula with a new activity. `asemec check --watch` does the same.
Times are milliseconds by the clock, from the change to the line that says what was written, so an idle
machine is needed; and of CPU, of the process and of the Graphviz that it starts. Starting is CPU time,
interleaved with that of an empty Python.
"""

from __future__ import annotations

import os
import re
import resource
import signal
import statistics
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

from tests.support.large import large_project

ROUNDS = 9
REBUILD, VERSION, CHECK = 300.0, 150.0, 400.0
"""What the medians should stay below: in ms by the clock, and of CPU where a command starts."""
LIMIT = 600
"""How long the watching process may live, in s."""

SMALL = """\
system Walker
message Seen { bool ball }
topic eyes { state Seen }
srm robot {
  liveness { robot = (Walk | Stand)~ }
  control robot {
    enter Walk  : [eyes.state.Seen.ball]
    enter Stand : else
  }
}
team Walkers { one : robot }
"""


def processor_time(pid: int) -> float:
    """Milliseconds of CPU that a process, its threads and its ended children have had."""
    fields = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
    return 1000 * sum(map(int, fields[11:15])) / os.sysconf("SC_CLK_TCK")


def a_duration(text: str, number: int) -> str:
    """One activity takes longer: its description and the role's plan change."""
    return re.sub(r"takes \d+(\.\d+)?s", f"takes {number + 2}s", text, count=1)


def a_condition(text: str, number: int) -> str:
    """One condition changes: so do a role's statechart, its class and its drawings."""
    return text.replace("count % 7 == 3", f"count % 7 == {number + 10}", 1)


def a_formula(text: str, number: int) -> str:
    """A formula has another new activity each time: a file for it is new, a statechart gets another form."""
    name = f"Wash{number}"
    text = re.sub(r"(produce\d+ += )", rf"\1{name} . ", text, count=1)
    return text.replace("activities {", f"activities {{\n    {name} takes 1s", 1)


EDITS: tuple[tuple[str, Callable[[str, int], str]], ...] = (
    ("a `takes`", a_duration),
    ("a condition", a_condition),
    ("a formula", a_formula),
)


@dataclass(frozen=True, slots=True)
class Measured:
    """CPU and clock of each change, in ms, of a kind of edit."""

    kind: str
    processor: list[float]
    clocked: list[float]


def rebuilds(folder: Path, files: Mapping[str, str], command: str) -> Iterator[Measured | float]:
    """What each kind of edit costs; first, the share of a processor that waiting takes."""
    for name, text in files.items():
        (folder / name).write_text(text, "utf-8")
    process = subprocess.Popen(
        [sys.executable, "-m", "aseme_dsl", command, "plant.aseme", "--watch"],
        cwd=folder,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
        encoding="utf-8",
    )
    assert process.stdout is not None
    stopper = threading.Timer(LIMIT, process.kill)
    stopper.start()
    try:
        said = next(line for line in process.stdout if "watching" in line)
        print(f"asemec {command} --watch: {said.strip()}")
        time.sleep(1)
        begun, clock = processor_time(process.pid), time.perf_counter()
        time.sleep(5)
        yield (processor_time(process.pid) - begun) / (1000 * (time.perf_counter() - clock))
        changed = folder / "hall3.aseme"
        text = changed.read_text("utf-8")
        for kind, edit in EDITS:
            found = Measured(kind, [], [])
            for number in range(ROUNDS):
                begun, clock = processor_time(process.pid), time.perf_counter()
                new = changed.with_suffix(".new")
                new.write_text(edit(text, number), "utf-8")
                new.replace(changed)
                next(line for line in process.stdout if line.rstrip().endswith(" s)"))
                found.clocked.append(1000 * (time.perf_counter() - clock))
                time.sleep(0.3)  # what is done when all has been said counts, too
                found.processor.append(processor_time(process.pid) - begun)
            yield found
    finally:
        stopper.cancel()
        process.send_signal(signal.SIGINT)
        try:
            process.wait(10)
        except subprocess.TimeoutExpired:
            process.kill()
        process.stdout.close()


def started(folder: Path, *arguments: str) -> float:
    """Milliseconds of CPU of one process."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([sys.executable, *arguments], cwd=folder, capture_output=True, check=True, timeout=60)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return 1000 * (after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)


def main(lines: int) -> int:
    """Print a line a kind; 1 if one takes too long."""
    os.environ["PYTHONPATH"] = str(Path(__file__).parents[1])
    late = False
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        (folder / "small.aseme").write_text(SMALL, "utf-8")
        kinds = {
            "python -c pass": ("-c", "pass"),
            "asemec --version": ("-m", "aseme_dsl", "--version"),
            "asemec check": ("-m", "aseme_dsl", "check", "small.aseme"),
        }
        times: dict[str, list[float]] = {name: [] for name in kinds}
        for _ in range(2 * ROUNDS):
            for name, arguments in kinds.items():
                times[name].append(started(folder, *arguments))
        for name, limit in (("python -c pass", 0.0), ("asemec --version", VERSION), ("asemec check", CHECK)):
            median, least = statistics.median(times[name]), min(times[name])
            aim = f" (aim: below {limit:.0f})" if limit else ""
            print(f"{name:18} {median:6.0f} ms of CPU, at the least {least:.0f}{aim}")
            late |= bool(limit) and median > limit
        project = large_project(lines)
        count = sum(text.count("\n") for text in project.values())
        print(f"{count} lines in {len(project)} files")
        for command in ("build", "check"):
            late |= told(rebuilds(folder, project, command))
    return int(late)


def told(found: Iterator[Measured | float]) -> bool:
    """Print a line a kind of edit; whether one takes too long."""
    late = False
    for item in found:
        if isinstance(item, float):
            print(f"  waiting          {100 * item:6.1f} % of a processor")
            continue
        median, clock = statistics.median(item.processor), statistics.median(item.clocked)
        print(
            f"  {item.kind:16} {clock:6.0f} ms by the clock, at the least {min(item.clocked):.0f} "
            f"(aim: below {REBUILD:.0f}); {median:.0f} ms of CPU, at the least {min(item.processor):.0f}"
        )
        late |= clock > REBUILD
    return late


if __name__ == "__main__":
    sys.exit(main(int(sys.argv[1]) if len(sys.argv) > 1 else 10_000))
