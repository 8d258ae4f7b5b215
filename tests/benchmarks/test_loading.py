"""What the benchmark loads: charts that compile, and modules as they are imported."""

from __future__ import annotations

import compileall
import subprocess
from pathlib import Path

import pytest

from aseme_dsl.amola.expression import event_text
from aseme_dsl.backends.backend import BackendOptions
from aseme_dsl.backends.plain import BACKEND
from benchmarks.peers.compiling import system_in, write
from benchmarks.peers.loading import GUARDED, guarded_ring, measured


def test_a_ring_with_guards_and_actions_is_loaded_again_and_in_a_new_process(tmp_path: Path) -> None:
    system = system_in(GUARDED, guarded_ring(20))
    ring = system.statecharts[-1]
    ways = [item.expression for item in ring.transitions if item.source != "0.1"]
    assert len(ways) == 20
    assert all(way.condition is not None and way.actions for way in ways)
    assert len({event_text(event) for way in ways for event in way.events}) == 10
    write(tmp_path, BACKEND.generate(system, BackendOptions()))
    compileall.compile_dir(tmp_path, quiet=1)
    for module in ("GuardedRing.guarded_ring", "GuardedRing.guarded_ring_watched"):
        found = measured("ring", "a ring", tmp_path, module, processes=1)
        assert found.size > 1000
        assert found.again > 0
        assert found.cold > 0


def test_a_module_that_cannot_be_loaded_is_no_figure(tmp_path: Path) -> None:
    with pytest.raises(subprocess.CalledProcessError):
        measured("nothing", "nothing", tmp_path, "nothing", processes=1)
