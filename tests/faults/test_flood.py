"""A robot that is flooded with what it has had already talks on, and ends when it is told to."""

from __future__ import annotations

import signal
import threading
from pathlib import Path
from typing import Any

import pytest

from aseme_dsl.runtime.transport import Network
from aseme_dsl.runtime.transport.over_zenoh import ZenohLink
from tests.faults.team import NAME, gone, project, signals_from, started
from tests.support.lanes import kept
from tests.support.waiting import LONG, wait_until

zenoh = pytest.importorskip("zenoh")


@pytest.mark.parametrize(
    "number",
    kept([signal.SIGTERM, signal.SIGINT], lambda number: number == signal.SIGTERM),
    ids=lambda number: number.name,
)
def test_a_signal_ends_a_robot_under_a_flood_of_duplicates(tmp_path: Path, number: int) -> None:
    recorded: list[tuple[str, bytes, bytes]] = []
    over = threading.Event()

    def record(sample: Any) -> None:
        if len(recorded) < 50:
            recorded.append((str(sample.key_expr), sample.payload.to_bytes(), sample.attachment.to_bytes()))

    def flood() -> None:
        while not over.is_set():
            for key, payload, data in list(recorded):
                session.put(key, payload, attachment=data, congestion_control=zenoh.CongestionControl.BLOCK)

    with started(project(tmp_path)) as run:
        run.wait_for_talk()
        session = ZenohLink(NAME, Network()).connected("mallory")
        session.declare_subscriber(f"asemec/{NAME}/to/robot1/**", record)
        wait_until(lambda: len(recorded) == 50)
        threads = [threading.Thread(target=flood, daemon=True) for _ in range(2)]
        for thread in threads:
            thread.start()
        try:
            run.wait_for(lambda: any(entry.endswith(" duplicated") for entry in run.news("robot1")))
            before = len(signals_from(run.trace("robot1"), "robot2"))
            run.wait_for(lambda: len(signals_from(run.trace("robot1"), "robot2")) > before + 10)
            robot = run.robots()["robot1"]
            robot.send_signal(number)
            assert gone([robot])
        finally:
            over.set()
            for thread in threads:
                thread.join(LONG)
            session.close()
        run.wait_for(lambda: run.trace("robot1")[-1]["kind"] == "finish")
        assert run.trace("robot1")[-1]["reason"] == (
            "terminated" if number == signal.SIGTERM else "interrupted"
        )
        assert run.end() == 130
