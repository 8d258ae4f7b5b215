"""SCION's published test scripts, imported and played one event at a time.

`SCION_TESTS` is the folder `test` of the npm package `@scion-scxml/test-framework`. A machine of which the
report says that something is left out or to be decided is not within the language, and is not played.
"""

from __future__ import annotations

import json
import os
from pathlib import Path

import pytest

from aseme_dsl.interop.machines.machine import Shape
from tests.interop.machines.playing import Player, imported, is_at, script_of, texts

FOLDER = os.environ.get("SCION_TESTS", "")

_LATER = "the script looks before the engine has handed out what the machine has sent to itself"
OTHERWISE = {"w3c-ecma/test200.txml": _LATER, "w3c-ecma/test348.txml": _LATER}
"""Machines that play otherwise here, each with the reason."""

pytestmark = pytest.mark.skipif(not FOLDER, reason="SCION_TESTS is not set")


def played(path: Path) -> str:
    """How a machine plays: "" as its script says, else what is different. Raises LookupError if it is not
    within the language."""
    try:
        machine = imported(path.name, path.read_text("utf-8"))
    except ValueError as reason:
        raise LookupError(str(reason)) from None
    if machine.lost:
        raise LookupError("; ".join(machine.lost))
    parallels = {node.id for node in machine.plan.machine.nodes() if node.shape is Shape.PARALLEL}
    player = Player(machine)
    script_path = script_of(path)
    assert script_path is not None
    script = json.loads(script_path.read_text("utf-8"))
    if not is_at(player.active(), script["initialConfiguration"], parallels):
        return f"begins in {player.active()}, not in {script['initialConfiguration']}"
    for number, step in enumerate(script["events"], 1):
        if "after" in step:
            player.wait(step["after"] * 1_000_000)
        player.send(step["event"]["name"])
        if not is_at(player.active(), step["nextConfiguration"], parallels):
            return f"event {number}: in {player.active()}, not in {step['nextConfiguration']}"
    return ""


def test_what_is_within_the_language_plays_as_the_scripts_say(capsys: pytest.CaptureFixture[str]) -> None:
    outside: dict[str, str] = {}
    wrong: dict[str, str] = {}
    passed: list[str] = []
    for path in texts(Path(FOLDER)):
        name = path.relative_to(FOLDER).with_suffix("").as_posix()
        try:
            difference = played(path)
        except LookupError as reason:
            outside[name] = str(reason)
            continue
        if difference:
            wrong[name] = difference
        else:
            passed.append(name)
    with capsys.disabled():
        print(f"\n{len(passed)} pass, {len(wrong)} differ, {len(outside)} are outside of the language")
        for name, why in {**wrong, **outside}.items():
            print(f"  {'differs' if name in wrong else 'outside'}: {name}: {why[:300]}")
    assert wrong.keys() == OTHERWISE.keys()
