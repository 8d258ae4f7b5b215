"""One seed, one trace: `python -m benchmarks.same_traces [--runs N] [--only PYTHON ...]`.

Runs of all examples with many seeds, each of some seconds in virtual time, are made one after the other in
this Python; then in two processes, on a cluster of two workers, and on every other Python from 3.11 on that
is found (each in an environment of its own, as `ci/pythons.py` makes them). Every trace must have the same
lines: their hashes are compared. Exits with 1 if one differs.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import os
import platform
import subprocess
import sys
import tempfile
from collections.abc import Iterator, Sequence
from contextlib import redirect_stdout
from dataclasses import dataclass
from io import StringIO
from itertools import count, islice
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
SECONDS = {"meetings": 1800, "robocup": 3}
"""How long an example runs, in s of virtual time, if not 30."""


@dataclass(frozen=True, slots=True)
class Job:
    """One run of an example."""

    example: str
    seed: int


def jobs(number: int) -> list[Job]:
    """So many runs: of all examples in turn, with further and further seeds."""
    examples = sorted(path.parent.name for path in (ROOT / "examples").glob("*/pyproject.toml"))
    return list(islice((Job(name, seed) for seed in count(1) for name in examples), number))


def hash_of(job: Job) -> str:
    """The hash of the lines of its trace."""
    from aseme_dsl.cli import main
    from aseme_dsl.runtime.trace.trace_reading import TraceReader

    with tempfile.TemporaryDirectory() as folder, redirect_stdout(StringIO()):
        trace = Path(folder) / "trace.jsonl.gz"
        words = ["run", str(ROOT / "examples" / job.example), "-o", folder, "--trace", str(trace), "--quiet"]
        words += ["--seed", str(job.seed), "--for", f"{SECONDS.get(job.example, 20)}s"]
        words += ["--allow", "waiting"]
        code = main(words)
        found = hashlib.sha256()
        for line in TraceReader(trace):
            found.update(line.text.encode("utf-8", "backslashreplace") + b"\n")
        return f"{code} {found.hexdigest()}"


def here(number: int) -> list[str]:
    """The hashes of so many runs, one after the other."""
    return [hash_of(job) for job in jobs(number)]


def elsewhere(python: str, version: str, number: int) -> list[str]:
    """The same on another Python, which sets up its environment first."""
    venv = f".venv-{version}"
    variables = {**os.environ, "ASEME_DSL_VENV": venv}
    subprocess.run([python, "-c", "import dev; dev.set_up('')"], cwd=ROOT, env=variables, check=True)
    command = [str(ROOT / venv / "bin" / "python"), "-m", "benchmarks.same_traces", "--hashes", str(number)]
    done = subprocess.run(command, cwd=ROOT, env=variables, stdout=subprocess.PIPE, text=True, check=True)
    found: list[str] = json.loads(done.stdout.splitlines()[-1])
    return found


def ways(number: int, only: Sequence[str]) -> Iterator[tuple[str, list[str]]]:
    """The hashes by each way of running."""
    from distributed import LocalCluster

    from aseme_dsl.project.spreading.cluster import Cluster
    from aseme_dsl.project.spreading.spread import spread
    from benchmarks.same_traces import hash_of, jobs  # by the name that other processes know
    from ci.pythons import candidates, versions

    def told() -> None:
        """It is not shown how much is done."""

    yield "two processes", spread(hash_of, jobs(number), 2, (), told)
    with LocalCluster(
        n_workers=2, threads_per_worker=1, dashboard_address="127.0.0.1:0", host="127.0.0.1"
    ) as cluster:
        yield "a cluster", spread(hash_of, jobs(number), Cluster(cluster.scheduler_address), (), told)
    for version, python in versions(only or candidates()).items():
        if version != platform.python_version():
            yield f"Python {version}", elsewhere(python, version, number)


def main(arguments: list[str]) -> int:
    """Do it; return the exit code."""
    parser = argparse.ArgumentParser(prog="benchmarks.same_traces", description="One seed, one trace.")
    parser.add_argument("--runs", type=int, default=100, metavar="N")
    parser.add_argument("--only", nargs="*", default=(), metavar="PYTHON", help="compare with these only")
    parser.add_argument("--hashes", type=int, metavar="N", help="print the hashes of N runs on this Python")
    options = parser.parse_args(arguments)
    if options.hashes:
        print(json.dumps(here(options.hashes)))
        return 0
    expected = here(options.runs)
    print(
        f"{len(set(expected))} different traces of {options.runs} runs on Python {platform.python_version()}"
    )
    code = 0
    for what, found in ways(options.runs, options.only):
        others = [
            job for job, one, two in zip(jobs(options.runs), expected, found, strict=True) if one != two
        ]
        print(f"{what}: {options.runs - len(others)} of {options.runs} equal", flush=True)
        for job in others:
            print(f"  {job.example}, seed {job.seed}: another trace")
        code |= bool(others)
    return code


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
