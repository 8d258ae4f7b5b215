"""What it costs to load a compiled statechart of 1 000 states: again in a process, and first in a new one."""

from __future__ import annotations

import json
import os
import py_compile
import statistics
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

from aseme_dsl.backends.backend import BackendOptions
from aseme_dsl.backends.plain import BACKEND as PLAIN
from benchmarks.behaviours.aseme import camel
from benchmarks.behaviours.catalogue import BEHAVIOURS
from benchmarks.peers.compiling import system_in, system_of, write
from benchmarks.peers.environment import ROOT

STATES = 1000
SIMPLE, GUARDED = "ring_1000", "guarded_ring"
LOADS = 51
PROCESSES = 15
PATIENCE = 60
"""Seconds that a process may take."""


@dataclass(frozen=True, slots=True)
class Loading:
    """What it costs to load one module, in CPU seconds: medians."""

    key: str
    title: str
    size: int
    """Bytes of its `.pyc`."""
    again: float
    """The file is read, made into code, and run, in a process that has done that before, and forgotten it.

    So there is memory for it, which else takes about as long as all the rest.
    """
    cold: float
    """A new process, which has the runtime of plain classes, imports it with its package."""


def guarded_ring(states: int = STATES) -> str:
    """A ring of which each transition has a guard and an action and waits for one of ten events."""
    lines = [
        "system GuardedRing",
        "",
        f"statechart {GUARDED} {{",
        "  var laps : int = 0",
        "  state 0 OR ring",
    ]
    lines.append("  state 0.1 START")
    lines += [f"  state 0.{place} BASIC S{place}" for place in range(2, states + 2)]
    lines.append("  0.1 -> 0.2 :")
    for place in range(2, states + 2):
        target = place + 1 if place <= states else 2
        lines.append(
            f"  0.{place} -> 0.{target} : e{place % 10} [laps < {place}] / laps = (laps + 1) % {states // 2}"
        )
    return "\n".join([*lines, "}", ""])


def loadings(folder: Path) -> list[Loading]:
    """The ring of the behaviours and the one with guards and actions, and the watched class of each."""
    charts = {
        SIMPLE: (system_of(BEHAVIOURS[SIMPLE]), "a ring of small rings, 2 events"),
        GUARDED: (system_in(GUARDED, guarded_ring()), "a guard and an action a transition, 10 events"),
    }
    found = []
    for name, (system, title) in charts.items():
        root = folder / "loading" / name
        write(root, PLAIN.generate(system, BackendOptions()))
        for path in sorted(root.rglob("*.py")):
            py_compile.compile(str(path), doraise=True)
        for module, further in ((name, ""), (f"{name}_watched", "; its watched class")):
            found.append(measured(module, title + further, root, f"{camel(name)}.{module}"))
    return found


def measured(key: str, title: str, root: Path, module: str, processes: int = PROCESSES) -> Loading:
    """A module below a folder, loaded in so many processes.

    Raises:
        subprocess.SubprocessError: one of them has failed, or took too long.
    """
    command = [sys.executable, "-c", SCRIPT, str(root), module, str(LOADS)]
    environment = dict(os.environ, PYTHONPATH=str(ROOT), PYTHONHASHSEED="0")
    answers = [
        json.loads(
            subprocess.run(command, env=environment, capture_output=True, check=True, timeout=PATIENCE).stdout
        )
        for _ in range(processes)
    ]
    again, cold = (statistics.median(answer[what] for answer in answers) for what in ("again", "cold"))
    return Loading(key, title, answers[0]["size"], again, cold)


SCRIPT = """
import gc, importlib, json, marshal, statistics, sys, time
import aseme_dsl.runtime.plain.plain

folder, name, loads = sys.argv[1:]
sys.path.insert(0, folder)
begun = time.process_time()
module = importlib.import_module(name)
cold = time.process_time() - begun
again = []
gc.freeze()  # so that only what was loaded before is looked at
for _ in range(int(loads)):
    gc.collect()
    begun = time.process_time()
    with open(module.__cached__, "rb") as file:
        data = file.read()
    exec(marshal.loads(memoryview(data)[16:]), {"__name__": name, "__package__": module.__package__})
    again.append(time.process_time() - begun)
print(json.dumps({"size": len(data), "cold": cold, "again": statistics.median(again)}))
"""
