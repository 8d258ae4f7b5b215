"""Where the peers live: a virtual environment and a `node_modules` of their own, in a cache folder."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from dataclasses import dataclass, field
from pathlib import Path

HERE = Path(__file__).parent
ROOT = HERE.parents[1]
CACHE = ROOT / "build" / "peers"
INSTALLING = 600
"""Seconds that pip or npm may take for one library."""


@dataclass(slots=True)
class Environment:
    """What could be had: the interpreters, and by distribution what could not be installed and why."""

    python: Path | None = None
    node: str | None = None
    node_folder: Path = CACHE / "node"
    missing: dict[str, str] = field(default_factory=dict)


def requirements() -> dict[str, str]:
    """The version of each Python library, by its distribution."""
    lines = (HERE / "requirements.txt").read_text("utf-8").splitlines()
    pairs = [line.split("==") for line in lines if line and not line.startswith("#")]
    return {name: version for name, version in pairs}


def node_requirements() -> dict[str, str]:
    """The version of each library on Node."""
    found: dict[str, str] = json.loads((HERE / "node" / "package.json").read_text("utf-8"))["dependencies"]
    return found


def prepare() -> Environment:
    """Install what is not there yet, and say what cannot be installed."""
    found = Environment()
    _prepare_python(found)
    _prepare_node(found)
    return found


def _prepare_python(found: Environment) -> None:
    folder = CACHE / "python"
    python = folder / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
    if not python.exists():
        made = _run([sys.executable, "-m", "venv", "--clear", str(folder)])
        if made is not None:
            found.missing |= dict.fromkeys(requirements(), f"no virtual environment: {made}")
            return
    found.python = python
    for name, version in requirements().items():
        stamp = folder / f".{name}"
        if stamp.exists() and stamp.read_text("utf-8") == version:
            continue
        print(f"installing {name} {version}", flush=True)
        pip = [str(python), "-m", "pip", "install", "--no-input", "--disable-pip-version-check", "-q"]
        reason = _run([*pip, f"{name}=={version}"])
        if reason is None:
            stamp.write_text(version, encoding="utf-8")
        else:
            found.missing[name] = reason


def _prepare_node(found: Environment) -> None:
    node, npm = shutil.which("node"), shutil.which("npm")
    wanted = node_requirements()
    if node is None or npm is None:
        found.missing |= dict.fromkeys(wanted, "there is no Node.js with npm")
        return
    found.node = node
    folder = found.node_folder
    folder.mkdir(parents=True, exist_ok=True)
    package = folder / "package.json"
    if not package.exists():
        package.write_text('{"private": true}\n', encoding="utf-8")
    for name, version in wanted.items():
        installed = folder / "node_modules" / name / "package.json"
        if installed.exists() and json.loads(installed.read_text("utf-8"))["version"] == version:
            continue
        print(f"installing {name} {version}", flush=True)
        options = ["--ignore-scripts", "--no-audit", "--no-fund", "--no-package-lock", "--save-exact"]
        reason = _run([npm, "install", *options, f"{name}@{version}"], folder)
        if reason is not None:
            found.missing[name] = reason


def _run(command: list[str], folder: Path | None = None) -> str | None:
    """Run a command; its last word if it failed, None if it did not."""
    try:
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=INSTALLING)
    except (OSError, subprocess.TimeoutExpired) as error:
        return type(error).__name__
    if done.returncode == 0:
        return None
    said = [line for line in (done.stderr or done.stdout).splitlines() if line.strip()]
    return said[-1].strip() if said else f"exit code {done.returncode}"
