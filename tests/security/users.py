"""Another user of this machine: a child process that has given up the rights of the tests' own user."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Sequence

NOBODY = 65534
"""The user and group that own nothing."""

_PRELUDE = """
import importlib, os, sys
for name in {modules!r}:
    importlib.import_module(name)  # before: the interpreter's own files may be out of the other user's reach
os.setgroups([])
os.setresgid({user}, {user}, {user})
os.setresuid({user}, {user}, {user})
assert os.getuid() == {user}
"""


def can_be_another() -> bool:
    """Whether processes of another user can be started: only root may do that."""
    return hasattr(os, "setresuid") and os.geteuid() == 0


def run_as_other(
    program: str, *arguments: str, modules: Sequence[str] = (), seconds: float = 120.0
) -> subprocess.CompletedProcess[str]:
    """Run a Python program as the user `NOBODY`, and wait for its end.

    `modules` are imported before the rights are given up. `arguments` are its `sys.argv[1:]`.
    """
    text = _PRELUDE.format(modules=tuple(modules), user=NOBODY) + program
    return subprocess.run(
        [sys.executable, "-c", text, *arguments],
        capture_output=True,
        text=True,
        timeout=seconds,
        cwd="/",
        check=False,
    )
