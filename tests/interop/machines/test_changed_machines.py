"""Changed files of each format: a project, or a message with its place; never a traceback.

`ASEME_CHANGED_MACHINES` says how many of each format are tried; `dev.py long` tries 5 000.
"""

from __future__ import annotations

import json
import os
import random

import pytest

from aseme_dsl.interop.machines.system import machines_text, read_machines
from aseme_dsl.project.editing.import_machines import machines_of
from aseme_dsl.source import Source
from tests.interop.changing import changed, limited
from tests.interop.machines.test_scxml import OVEN, PARALLEL, machine
from tests.interop.machines.test_xstate import LIGHT

CHANGED = int(os.environ.get("ASEME_CHANGED_MACHINES", "60"))
COMPILED = max(1, CHANGED // 20)
"""How many of the changed files are compiled, too, which takes longer."""

SEEDS = {
    "scxml": (OVEN, machine(PARALLEL.format("e"), '<data id="n" expr="1+2"/>')),
    "json": (json.dumps(LIGHT, indent=1),),
}
PIECES = {
    "scxml": '< > " </state> <state id="a"> <parallel> <final/> <history/> & &lt; ]]> <!-- cond="n" '
    + 'target="a" <transition event="*" target="on"/> <send event="e" delay="9s"/> type="internal" '
    + "\0 é &#0; (((",
    "json": '{ } [ ] " , : null true 1e999 -1 "type" "parallel" "final" "history" "#light" ".x" "" '
    + '\0 é \\u0000 "on" "always" "after" "1000"',
}


@pytest.mark.parametrize("kind", SEEDS)
def test_changed_files_end_in_a_project_or_a_message(kind: str) -> None:
    read = 0
    for number in range(CHANGED):
        chance = random.Random(f"{kind} {number}")
        source = Source(f"m.{kind}", changed(chance.choice(SEEDS[kind]), PIECES[kind].split(" "), chance))
        with limited(f"{kind} {number}"):
            read += _read(source, compile_it=read < COMPILED)
    assert read > 0


def _read(source: Source, *, compile_it: bool) -> bool:
    """Whether a file becomes a project; otherwise it is refused with a place."""
    system, found = read_machines([source])
    assert all(item.span is not None for item in found), source.text
    if system is None:
        assert found
        return False
    made = machines_text(system)
    assert all(row.place is not None for row in made.rows), source.text
    if compile_it:
        _, found = machines_of([source])
        assert all(item.span is not None for item in found), source.text
    return True
