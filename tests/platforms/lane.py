#!/usr/bin/env python3
"""Run what needs SPADE, mango and Prosody, in an environment of its own: `.venv-platforms` beside `.venv`.

    python tests/platforms/lane.py [bench | further arguments for pytest]

SPADE pins much of what it needs, so that it is not installed where all else is. Prosody is installed with
apt-get where that may be; where it is not there, that is said, and its tests are skipped.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
HOME = ROOT / ".venv-platforms"
PYTHON = HOME / "bin" / "python"
NEEDED = ["pytest>=9.0,<10", "pytest-asyncio", "hypothesis>=6.130,<7", "jsonschema>=4.20,<5", "psutil>=6,<8"]


def main(arguments: list[str]) -> int:
    """Install what is missing, and run."""
    if not PYTHON.exists():
        print("Making .venv-platforms with SPADE and mango (this takes some minutes) ...", flush=True)
        subprocess.run([sys.executable, "-m", "venv", str(HOME)], check=True)
        install = [str(PYTHON), "-m", "pip", "install", "-q", "--disable-pip-version-check"]
        done = subprocess.run([*install, "-e", f"{ROOT}[spade,mango]", *NEEDED])
        if done.returncode != 0:
            shutil.rmtree(HOME)
            print("SPADE and mango CANNOT BE INSTALLED: nothing over them is tested", file=sys.stderr)
            return done.returncode
    if shutil.which("prosody") is None and os.geteuid() == 0 and shutil.which("apt-get"):
        subprocess.run(["apt-get", "install", "-y", "-q", "prosody"], stdout=subprocess.DEVNULL)
    if shutil.which("prosody") is None:
        print(
            "Prosody IS NOT INSTALLED (apt-get install prosody): nothing over it is tested", file=sys.stderr
        )
    if arguments[:1] == ["bench"]:
        command = ["benchmarks/spade.py", *arguments[1:]]
    else:
        command = ["-m", "pytest", "tests/platforms", *arguments]
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    return subprocess.run([str(PYTHON), *command], cwd=ROOT, env=environment).returncode


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
