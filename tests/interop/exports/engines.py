"""Engines that others wrote, playing what was recorded of ours."""

from __future__ import annotations

import json
import os
import re
import subprocess
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from aseme_dsl.interop.export.scxml import FINISHED, scxml
from aseme_dsl.interop.export.sismic import sismic
from aseme_dsl.interop.export.xstate import xstate
from tests.interop.exports.playing import Recording, Step
from tests.support.node import packages
from tests.support.other_python import python_with

_LATER = re.compile(r"\s*<(?:send [^>]*delay(?:expr)?=|cancel )[^>]*/>")


def without_clock(document: str) -> str:
    """SCXML without what it sends to itself later: times come as recorded."""
    return _LATER.sub("", document)


Played = list[list[tuple[str, ...]]]
"""What was active after the start and each step, of each game."""


def differences(recording: Recording, played: list[tuple[str, ...]]) -> list[str]:
    """What an engine did otherwise, after the start and after each step."""
    expected = [recording.first, *(step.active for step in recording.steps)]
    found = []
    for number, (ours, theirs) in enumerate(zip(expected, played, strict=True)):
        wanted = {FINISHED} if ours is None else set(ours)
        if set(theirs) != wanted:
            said = recording.steps[number - 1].data if number else {}
            found.append(f"step {number} {said}: ours {sorted(wanted)}, theirs {sorted(theirs)}")
    return found


def python_statemachine(recording: Recording) -> list[tuple[str, ...]]:
    """python-statemachine (PyPI) plays the SCXML with Python as the data model."""
    from statemachine.io import load

    document = without_clock(scxml(recording.machine, "python"))
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "chart.scxml"
        path.write_text(document, encoding="utf-8")
        kind = load(str(path), trusted=True)
    machine: Any = kind()
    found = [_active(machine)]
    for step in recording.steps:
        _send(machine, step)
        found.append(_active(machine))
    return found


def _active(machine: Any) -> tuple[str, ...]:
    return tuple(str(item) for item in machine.configuration_values)


def _send(machine: Any, step: Step) -> None:
    machine.send(step.event, step.data)


def sismic_engine(recording: Recording) -> list[tuple[str, ...]]:
    """Sismic (PyPI) plays its YAML; its clock stands still, so that times come as recorded."""
    from sismic.interpreter import Interpreter
    from sismic.io import import_from_yaml

    engine = Interpreter(import_from_yaml(sismic(recording.machine)))
    found = []
    for step in (None, *recording.steps):
        if step is not None:
            engine.queue(step.event, **step.data)
        engine.execute(max_steps=2000)
        found.append(tuple(engine.configuration) or (FINISHED,))
    return found


NODE = Path(__file__).with_name("node")


def job(engine: str, recording: Recording) -> dict[str, Any]:
    """What `node/engines.cjs` is given for one chart."""
    steps = [{"event": step.event, "data": step.data} for step in recording.steps]
    if engine == "scion":
        return {"engine": engine, "document": without_clock(scxml(recording.machine)), "steps": steps}
    made = xstate(recording.machine, "chart.json")
    return {"engine": engine, "config": made.config, "module": made.module, "steps": steps}


def on_qt(recordings: Sequence[Recording]) -> Played:
    """What was active after the start and each step, in Qt's engine of SCXML (PyPI: PySide6)."""
    jobs = [job("scion", recording) for recording in recordings]
    script = Path(__file__).with_name("qt.py")
    done = subprocess.run(
        [str(python_with("PySide6-Addons>=6.8,<7")), str(script)],
        input=json.dumps(jobs),
        capture_output=True,
        text=True,
        timeout=1000,
        check=True,
        env=os.environ | {"QT_QPA_PLATFORM": "offscreen"},
    )
    found = []
    for played in json.loads(done.stdout):
        assert "error" not in played, played["error"]
        found.append([tuple(ids) for ids in played["active"]])
    return found


def _on_node(jobs: Sequence[dict[str, Any]]) -> Played:
    """What was active after the start and each step, of every job."""
    folder = packages(NODE)
    script = folder / "engines.cjs"
    script.write_bytes((NODE / "engines.cjs").read_bytes())
    done = subprocess.run(
        ["node", str(script)], input=json.dumps(jobs), capture_output=True, text=True, timeout=280, check=True
    )
    found = []
    for played in json.loads(done.stdout):
        assert "error" not in played, played["error"]
        found.append([tuple(ids) for ids in played["active"]])
    return found


JAVASCRIPT = ("scion", "xstate")


def on_javascript(recordings: Sequence[Recording]) -> dict[str, Played]:
    """Both engines, in one process: it takes longer to start it than to play."""
    played = _on_node([job(engine, recording) for engine in JAVASCRIPT for recording in recordings])
    return {engine: played[i * len(recordings) :][: len(recordings)] for i, engine in enumerate(JAVASCRIPT)}
