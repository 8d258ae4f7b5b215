"""Conversations of robots in processes of their own are suspended, go on, and are discarded."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from tests.faults.kitchen import DISCARDING, GATES, TEXT, Gates
from tests.faults.team import Started, started
from tests.support.network import own_name
from tests.support.waiting import LONG

pytest.importorskip("zenoh")

CODE = """
from pathlib import Path

from tests.faults.kitchen import Gates

{name} = Gates(Path({folder!r})).activity("{name}")
"""


IN_LONG = pytest.mark.skipif("PROCESS_RUNS" not in os.environ, reason="run it with: python3 dev.py long")


def project(folder: Path, text: str) -> tuple[Path, Gates]:
    name = own_name("Kitchen")
    (folder / "activities").mkdir()
    (folder / "pyproject.toml").write_text(
        '[tool.asemec]\nfiles = ["t.aseme"]\noutput = "out"\nactivities = "activities"\n'
        f'[tool.asemec.deploy]\nlease = "{LONG:g}s"\n'
    )
    (folder / "t.aseme").write_text(text.replace("system Kitchen", f"system {name}"))
    gates = Gates(folder / "gates")
    gates.folder.mkdir()
    for gate in GATES:
        code = CODE.format(name=gate, folder=str(gates.folder))
        (folder / "activities" / f"{gate.lower()}.py").write_text(code)
    return folder, gates


def of(run: Started, agent: str, kind: str, **members: Any) -> list[dict[str, Any]]:
    return [
        r
        for r in run.trace(agent)
        if r["kind"] == kind and all(r.get(key) == value for key, value in members.items())
    ]


def has_begun(run: Started, agent: str, activity: str) -> Callable[[], object]:
    return lambda: of(run, agent, "activity", what="start", activity=activity)


def suspended(run: Started, gates: Gates) -> None:
    """The cook is called away with an order in its hands, and the waiter hurries it meanwhile."""
    run.wait_for(has_begun(run, "bob", "Cook"))
    gates.open("Clock")
    run.wait_for(lambda: of(run, "bob", "conversation", what="suspend"))
    gates.open("Ask")
    run.wait_for(lambda: of(run, "bob", "received", performative="cancel"))


def test_a_suspended_conversation_goes_on(tmp_path: Path) -> None:
    folder, gates = project(tmp_path, TEXT)
    with started(folder) as run:
        suspended(run, gates)
        gates.open("Charge", "Cook")
        run.wait_for(has_begun(run, "ann", "Serve"))
        run.wait_for(has_begun(run, "bob", "Sweep"))
        run.end()
    for agent in ("ann", "bob"):
        assert [of(run, agent, kind) for kind in ("unexpected", "fault", "error", "lost")] == [[]] * 4
    what = [r["what"] for r in of(run, "bob", "conversation")]
    assert what[:4] == ["join", "suspend", "resume", "leave"]
    assert [r["performative"] for r in of(run, "bob", "agent_message")] == ["inform"]
    assert [r["performative"] for r in of(run, "ann", "agent_message")] == ["request", "cancel"]


@IN_LONG
def test_what_is_discarded_is_told_before_the_loss(tmp_path: Path) -> None:
    folder, gates = project(tmp_path, DISCARDING)
    with started(folder) as run:
        suspended(run, gates)
        gates.open("Charge")
        run.wait_for(has_begun(run, "ann", "Sorry"))
        run.end()
    assert not has_begun(run, "ann", "Gone")()
    assert [r["performative"] for r in of(run, "bob", "agent_message")] == ["failure"]
    assert [r["reason"] for r in of(run, "bob", "conversation", what="leave")] == ["left"]


@IN_LONG
def test_a_suspended_one_that_is_killed_is_lost(tmp_path: Path) -> None:
    folder, gates = project(tmp_path, TEXT)
    with started(folder) as run:
        suspended(run, gates)
        run.robots()["bob"].kill()
        run.wait_for(has_begun(run, "ann", "Gone"))
        run.end()
    assert of(run, "bob", "agent_message") == []
