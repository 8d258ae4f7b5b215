"""Does a long match stay flat? `python benchmarks/soak.py [HOURS]`, or `… --real MINUTES`.

In virtual time, the example team plays one match of HOURS (2) with a trace. Sampled: memory, Python's
objects, threads, file handles. After the warm-up, a quarter of the match, memory and objects may grow by 1 %,
threads and handles not at all. With `--real`, `asemec run --real` plays for MINUTES in a process of its own,
is watched from outside, and is stopped with SIGINT and, in another run, with SIGTERM: within two seconds it
has ended, and its trace is whole. Exit code 1 if not so. (`real_match.py` does it with a process a robot.)
"""

from __future__ import annotations

import argparse
import gc
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import psutil

ROOT = Path(__file__).resolve().parents[1]
EXAMPLE = ROOT / "examples" / "robocup"
sys.path[:0] = [str(ROOT), str(EXAMPLE)]

SECOND = 1_000_000_000
MINUTE = 60 * SECOND
SAMPLES = 60
WARM_UP = 0.25
"""This share of a run is warm-up."""
MOST = 0.01
"""Memory and objects may grow by this share after that."""
MOST_SECONDS = 2.0
"""So long may the end of a real match take."""


MATCH = """
import world
from aseme_dsl.worlds.field.referee import SECOND, Rules

world.RULES = Rules(half_ns=24 * 3600 * SECOND, halves=1)


class Endless(world.Game):
    # What the referee notes, and the way of the ball, grow with every match: this one forgets.
    def advance(self, until_ns):
        super().advance(until_ns)
        del self._referee.events[:-100], self.lines[:]
        self.noted = len(self._referee.events)
        while len(self._trail) > 600:
            self._trail.popleft()


make = Endless
"""
"""A match that never ends, as a module beside the example's `world`."""


@dataclass(frozen=True)
class Sample:
    """What a process has at a moment (s since the run began); objects are 0 where nobody counts them."""

    moment: float
    memory: int
    objects: int
    threads: int
    handles: int


def look(process: psutil.Process, moment: float, objects: int = 0) -> Sample:
    """A sample of a process."""
    with process.oneshot():
        memory = process.memory_info().rss
        return Sample(moment, memory, objects, process.num_threads(), process.num_fds())


def judged(name: str, samples: Sequence[Sample]) -> bool:
    """Print how what was sampled has grown after the warm-up; whether it is flat.

    Compared are the first and the last quarter of what comes after the warm-up, by their medians: one sample
    taken amid an activity is no growth.
    """
    end = samples[-1].moment
    after = [item for item in samples if item.moment >= WARM_UP * end]
    quarter = max(1, len(after) // 4)

    def median(items: Sequence[Sample], what: Callable[[Sample], int]) -> float:
        return float(sorted(what(item) for item in items)[len(items) // 2])

    flat = True
    for title, what, share in (
        ("memory", lambda item: item.memory, MOST),
        ("objects", lambda item: item.objects, MOST),
        ("threads", lambda item: item.threads, 0.0),
        ("handles", lambda item: item.handles, 0.0),
    ):
        first, last = median(after[:quarter], what), median(after[-quarter:], what)
        if not first:
            continue
        growth = last / first - 1
        flat = flat and growth <= share
        unit, scale = (" MB", 1e6) if title == "memory" else ("", 1)
        print(
            f"{name:12}{title:10}{first / scale:10.1f}{unit:3} -> {last / scale:10.1f}{unit:3} {growth:+8.2%}"
            f"{'' if growth <= share else '   GROWS'}",
            flush=True,
        )
    return flat


def played(duration: int, trace: Path | None) -> list[Sample]:
    """The example team plays one match of this length in virtual time."""
    from aseme_dsl import compile
    from aseme_dsl.project.building.build import Choice, build
    from aseme_dsl.project.playing.play import load
    from aseme_dsl.project.settings.configuration import find_configuration
    from aseme_dsl.runtime.team.team import Team, make_team
    from aseme_dsl.runtime.version.loading import activities_in

    process = psutil.Process()
    samples: list[Sample] = []
    every = duration // SAMPLES
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "long_match.py").write_text(MATCH)
        sys.path.insert(0, folder)
        import long_match

        build(compile(EXAMPLE / "kouretes.aseme"), Path(folder), Choice(("monas",)))
        configuration, _ = find_configuration(EXAMPLE)
        loaded = load(Path(folder), "Kouretes", configuration)
        due = every

        def watch(team: Team) -> str | None:
            nonlocal due
            now = team.driver.clock.now()
            if now >= due:
                due += every
                gc.collect()
                samples.append(look(process, now / SECOND, len(gc.get_objects())))
                if len(samples) % 5 == 0:
                    last = samples[-1]
                    print(
                        f"{now // MINUTE:4} min  {last.memory / 1e6:7.1f} MB  {last.objects:8} objects  "
                        f"{last.threads} threads  {last.handles} handles  CPU {time.process_time():.0f} s",
                        flush=True,
                    )
            return None

        team = make_team(
            loaded,
            activities_in(EXAMPLE / "activities"),
            seed=11,
            world=long_match.make(11),
            until_ns=duration,
            stop=watch,
            trace=trace,
        )
        result = team.run()
        print(f"{result.reason}, {time.process_time():.0f} s of CPU", flush=True)
    return samples


def virtual(hours: float) -> bool:
    """The long match; its trace, some gigabytes an hour, goes nowhere."""
    with tempfile.TemporaryDirectory() as folder:
        trace = Path(folder) / "trace.jsonl.gz"
        Path(f"{trace}.part").symlink_to("/dev/null")
        return judged("one process", played(int(hours * 60 * MINUTE), trace))


def real(minutes: float, number: signal.Signals) -> bool:
    """A match in a process of its own, ended by a signal; whether it is as it should be."""
    from aseme_dsl.runtime.trace.trace_files import part_of
    from aseme_dsl.runtime.trace.trace_reading import TraceReader

    with tempfile.TemporaryDirectory() as folder:
        project = Path(folder) / "robocup"
        shutil.copytree(EXAMPLE, project, ignore=shutil.ignore_patterns("build"))
        (project / "long_match.py").write_text(MATCH)
        command = [sys.executable, "-m", "aseme_dsl", "run", str(project), "--real", "--quiet"]
        command += ["--world", "long_match:make", "--for", f"{minutes + 10:g}min"]
        environment = {**os.environ, "PYTHONPATH": str(ROOT)}
        with subprocess.Popen(command, env=environment, stdout=subprocess.DEVNULL) as team:
            process = psutil.Process(team.pid)
            trace = project / "build" / "trace.jsonl.gz"
            while not part_of(trace).exists() and team.poll() is None:
                time.sleep(0.1)
            begun = time.monotonic()
            samples = [look(process, 0.0)]
            while (passed := time.monotonic() - begun) < minutes * 60 and team.poll() is None:
                time.sleep(min(5.0, minutes * 60 / SAMPLES))
                samples.append(look(process, passed))
                if len(samples) % 12 == 0:
                    last = samples[-1]
                    rest = f"{last.threads} threads  {last.handles} handles"
                    print(f"{passed:5.0f} s  {last.memory / 1e6:7.1f} MB  {rest}", flush=True)
            told = time.monotonic()
            team.send_signal(number)
            code = team.wait(60)
            lasted = time.monotonic() - told
        flat = minutes < 1 or judged(number.name, samples)
        reader = TraceReader(trace)
        lines = sum(1 for _ in reader)
        size = reader.path.stat().st_size / 1e6
        fine = flat and lasted < MOST_SECONDS and reader.problem is None and code == 130
        print(
            f"{number.name:12}ended after {lasted:.2f} s with exit code {code}, trace {size:.0f} MB, "
            f"{lines} lines, {reader.problem or 'whole'}{'' if fine else '   WRONG'}",
            flush=True,
        )
        return fine


def main() -> int:
    """Run what was asked for; the exit code."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("hours", nargs="?", type=float, default=2.0, help="of virtual time")
    parser.add_argument("--real", type=float, metavar="MINUTES", help="of real time, instead")
    options: Any = parser.parse_args()
    if options.real is None:
        return 0 if virtual(options.hours) else 1
    fine = [real(0.2, signal.SIGTERM), real(options.real, signal.SIGINT)]
    return 0 if all(fine) else 1


if __name__ == "__main__":
    sys.exit(main())
