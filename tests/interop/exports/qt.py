"""Qt's own engine of SCXML plays machines; run by a Python that has PySide6, which the project does not need.

Standard input: `[{"document": …, "steps": [{"event": …, "data": …}]}]`. Output: the active states of every
machine, after the start and after each step.
"""

import json
import os
import sys
import tempfile
from pathlib import Path

from PySide6.QtCore import QCoreApplication
from PySide6.QtScxml import QScxmlStateMachine

TURNS = 20
SPARE = []
"""References to None that are never given back: PySide6 6.12 on Python 3.11 loses one with each call that
returns it, and Python ends when the last one is gone."""


def settle(app):
    """Let the machine do what it does by itself."""
    for _ in range(TURNS):
        app.processEvents()


def active(machine):
    """The active states; a machine that has ended has none any more, and is in its top-level final state."""
    return machine.activeStateNames(False) if machine.isRunning() else ["asemec_finished"]


def played(app, path, job):
    """The active states of one machine after each step."""
    Path(path).write_text(job["document"], encoding="utf-8")
    machine = QScxmlStateMachine.fromFile(path)
    errors = [item.toString() for item in machine.parseErrors()]
    if errors:
        return {"error": "; ".join(errors)}
    machine.start()
    settle(app)
    found = [active(machine)]
    for step in job["steps"]:
        machine.submitEvent(step["event"], step["data"])
        settle(app)
        found.append(active(machine))
    return {"active": found}


def main():
    """Play all machines."""
    app = QCoreApplication([])
    with tempfile.TemporaryDirectory() as folder:
        jobs = json.load(sys.stdin)
        SPARE.extend([None] * sum((TURNS + 10) * (len(job["steps"]) + 1) for job in jobs))
        result = [played(app, f"{folder}/chart{number}.scxml", job) for number, job in enumerate(jobs)]
    json.dump(result, sys.stdout)
    sys.stdout.flush()
    os._exit(0)  # PySide6 6.12 on Python 3.11 fails as it is taken down


main()
