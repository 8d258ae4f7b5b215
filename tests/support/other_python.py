"""A Python with packages that the project does not need, installed once into a cache outside of it."""

from __future__ import annotations

import fcntl
import hashlib
import subprocess
import sys
import venv
from pathlib import Path

import pytest

from tests.support.node import cache


def python_with(*requirements: str) -> Path:
    """The Python of an environment that has these packages.

    Skips the test, saying why, where they cannot be installed.
    """
    key = hashlib.sha256(" ".join((sys.version, *requirements)).encode()).hexdigest()[:16]
    made = cache() / "python" / key
    made.mkdir(parents=True, exist_ok=True)
    python = made / "bin" / "python"
    with (made / "lock").open("w") as busy:
        fcntl.flock(busy, fcntl.LOCK_EX)  # the workers of one run share it
        if not (made / "complete").exists():
            venv.create(made, with_pip=True)
            command = [str(python), "-m", "pip", "install", "-q", *requirements]
            done = subprocess.run(command, capture_output=True, text=True)
            if done.returncode != 0:
                pytest.skip(f"NOT TRIED, for `pip install` failed: {done.stderr.strip()[-500:]}")
            (made / "complete").touch()
    return python


__all__ = ["python_with"]
