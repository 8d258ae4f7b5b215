"""A thousand conversations at once over SPADE, among thirty agents: none is lost, none mixed with another."""

from __future__ import annotations

import json
import subprocess
import sys

import pytest

from tests.platforms.servers import Server

pytest.importorskip("spade", reason="SPADE is not installed: python3 dev.py long")

PROCESSES, AGENTS, EACH = 3, 10, 34


def test_a_thousand_conversations_among_thirty_agents(server: Server) -> None:
    numbers = [str(item) for item in (PROCESSES, AGENTS, EACH, EACH)]
    running = [
        subprocess.Popen(
            [sys.executable, "-m", "tests.platforms.crowd", str(server.port), str(index), *numbers],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )
        for index in range(PROCESSES)
    ]
    try:
        for line in ("ready\n", "done\n"):
            for process in running:
                assert process.stdout is not None
                assert process.stdout.readline() == line, server.log()
            for process in running:
                assert process.stdin is not None
                process.stdin.write("go\n")
                process.stdin.flush()
        for process in running:
            assert process.stdout is not None
            said = json.loads(process.stdout.readline())
            mine = AGENTS * EACH
            assert said["what"] == {
                "open asker": mine,
                "join helper": mine,
                "leave asker": mine,
                "leave helper": mine,
            }
            assert said["opened"] == mine and said["wrong"] == [] and not said["failed"]
            print(f"{said['wall']:.1f} s, {said['cpu']:.1f} s of processor time")
    finally:
        for process in running:
            process.kill()
            process.wait()
            for stream in (process.stdin, process.stdout):
                assert stream is not None
                stream.close()
