#!/usr/bin/env python3
"""Run the unit lane on every Python that is found: `python3 ci/pythons.py [--minutes N] [PYTHON ...]`.

Without PYTHON these are python3 and python3.11 to python3.14 on PATH, /usr/bin/python3, and those of pyenv;
each version once. Each has its own virtual environment, `.venv-X.Y.Z` beside `.venv` (kept). The tests
of the unit lane are in `UNIT` in dev.py. Exits with 1 if a Python fails, or is not done in time.
"""

from __future__ import annotations

import argparse
import os
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Iterable
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
OLDEST = (3, 11)
NAMES = ["python3", "/usr/bin/python3", *(f"python3.{minor}" for minor in range(OLDEST[1], 15))]
QUESTION = "import ensurepip, platform, sys, venv; print(platform.python_version(), *sys.version_info[:2])"


def candidates() -> list[str]:
    """Return what may be a Python here."""
    pyenv = shutil.which("pyenv")
    if pyenv is None:
        return NAMES
    folder = subprocess.run([pyenv, "root"], capture_output=True, text=True).stdout.strip()
    return NAMES + [str(path) for path in sorted(Path(folder).glob("versions/*/bin/python3"))]


def versions(pythons: Iterable[str]) -> dict[str, str]:
    """Return the version of each Python that is new enough and can make an environment; each version once."""
    found: dict[str, str] = {}
    for python in pythons:
        try:
            answer = subprocess.run([python, "-c", QUESTION], capture_output=True, text=True)
        except OSError:
            continue
        words = answer.stdout.split()
        if answer.returncode == 0 and len(words) == 3 and (int(words[1]), int(words[2])) >= OLDEST:
            found.setdefault(words[0], python)
    return found


def unit_lane(version: str, python: str, minutes: float) -> str | None:
    """Run it; return what went wrong, None if nothing did."""
    lane = subprocess.Popen(
        [python, str(ROOT / "dev.py"), "unit"],
        env={**os.environ, "ASEME_DSL_VENV": f".venv-{version}"},
        start_new_session=True,
    )
    try:
        code = lane.wait(60 * minutes)
    except subprocess.TimeoutExpired:
        return f"not done in {minutes:g} minutes"
    finally:
        if lane.poll() is None:
            os.killpg(lane.pid, signal.SIGKILL)
            lane.wait()
    return None if code == 0 else f"failed (exit code {code})"


def main(arguments: list[str]) -> int:
    """Do it; return the exit code."""
    parser = argparse.ArgumentParser(prog="ci/pythons.py", description="The unit lane on every Python here.")
    parser.add_argument("python", nargs="*", help="run it on these only")
    parser.add_argument("--minutes", type=float, default=15, help="for each Python (15)")
    options = parser.parse_args(arguments)
    found = versions(options.python or candidates())
    if not found:
        print("ci/pythons.py: no Python that is new enough and has its venv package", file=sys.stderr)
        return 1
    results = {}
    for version, python in found.items():
        print(f"== unit lane on Python {version} ({python})", flush=True)
        begun = time.monotonic()
        wrong = unit_lane(version, python, options.minutes)
        results[version] = wrong
        print(f"== Python {version}: {wrong or 'passed'} in {time.monotonic() - begun:.0f} s", flush=True)
    return 1 if any(results.values()) else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
