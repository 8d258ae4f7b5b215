"""Packages of npm for tests that need Node.js, installed once into a cache outside of the project."""

from __future__ import annotations

import fcntl
import hashlib
import os
import shutil
import subprocess
from pathlib import Path

import pytest


def cache() -> Path:
    """Where what tests download stays."""
    return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "aseme-dsl"


def packages(folder: Path, *further: str) -> Path:
    """A folder with the `node_modules` that the package-lock.json in `folder` says.

    Skips the test, saying what is missing, where there is no Node.js.
    """
    for tool in ("node", "npm"):
        if shutil.which(tool) is None:
            pytest.skip(f"NOT TRIED, for there is no `{tool}` here: install Node.js 20 or newer")
    lock = (folder / "package-lock.json").read_bytes()
    key = hashlib.sha256(lock + " ".join(further).encode()).hexdigest()[:16]
    made = cache() / "npm" / key
    made.mkdir(parents=True, exist_ok=True)
    with (made / "lock").open("w") as busy:
        fcntl.flock(busy, fcntl.LOCK_EX)  # the workers of one run share it
        if not (made / "complete").exists():
            for name in ("package.json", "package-lock.json"):
                shutil.copy(folder / name, made)
            command = ["npm", "ci", "--ignore-scripts", "--no-audit", "--no-fund", *further]
            done = subprocess.run(command, cwd=made, capture_output=True, text=True)
            if done.returncode != 0:
                pytest.skip(f"NOT TRIED, for `npm ci` failed: {done.stderr.strip()[-500:]}")
            (made / "complete").touch()
    return made
