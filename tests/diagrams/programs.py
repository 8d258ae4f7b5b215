"""Programs that stand in for Graphviz."""

from __future__ import annotations

import shlex
import stat
from pathlib import Path


def stand_in(folder: Path, script: str, name: str = "dot") -> Path:
    """An executable shell script `name` in `folder`, which is made if needed."""
    folder.mkdir(exist_ok=True)
    path = folder / name
    path.write_text(f"#!/bin/sh\n{script}\n", "utf-8")
    path.chmod(path.stat().st_mode | stat.S_IXUSR)
    return path


def counting(calls: Path, real: str, *, fails: str, unless: str = "") -> str:
    """A script that notes its arguments and does `fails`, or what `real` does if `unless` is in them."""
    note = f'echo "$*" >> {shlex.quote(str(calls))}'
    pattern = f"*{unless}*" if unless else ""
    real_run = f'exec {shlex.quote(real)} "$@"'
    return f'{note}\ncase "$*" in {pattern or "no-such-argument"}) {real_run};; *) {fails};; esac'
