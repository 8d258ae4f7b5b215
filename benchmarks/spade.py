"""What our layer costs over SPADE: the same conversations by our agents and by SPADE agents written by hand.

    python benchmarks/spade.py [ROUNDS [CONVERSATIONS]]

Two processes with five agents each ask each other, over one server: request, inform, confirm; each agent has
four such conversations at once on each side. The programs take turns, ROUNDS each; a figure is the sum of
both processes', per conversation. Exits with 1 if ours take more than 20 % more processor time or wall time
than those by hand, in the median of the rounds. Neither writes a trace.
Needs the extra `spade`, and, for a server that is not the bottleneck, Prosody.
"""

from __future__ import annotations

import json
import shutil
import statistics
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))

from tests.platforms.servers import Server  # noqa: E402

PROCESSES, AGENTS, WIDTH = 2, 5, 4
LIMIT = 1.2
SECONDS = 240
PROGRAMS = {"ours": "tests.platforms.crowd", "by hand": "benchmarks.spade_by_hand"}


def once(program: str, each: int) -> tuple[float, float]:
    """Processor time of both processes, and wall time of the slower one, in seconds."""
    server = Server("prosody" if shutil.which("prosody") else "embedded").start()
    running = [
        subprocess.Popen(
            [
                *("timeout", "-k", "5", str(SECONDS), sys.executable, "-m", program),
                *(str(item) for item in (server.port, index, PROCESSES, AGENTS, each, WIDTH, "untraced")),
            ],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
            cwd=ROOT,
        )
        for index in range(PROCESSES)
    ]
    try:
        for line in ("ready\n", "done\n"):
            for process in running:
                assert process.stdout is not None
                if process.stdout.readline() != line:
                    raise SystemExit(f"{program} has failed: {server.log()}")
            for process in running:
                assert process.stdin is not None
                process.stdin.write("go\n")
                process.stdin.flush()
        said = [json.loads(process.stdout.readline()) for process in running if process.stdout]
    finally:
        for process in running:
            process.kill()
            process.wait()
        server.close()
    return sum(item["cpu"] for item in said), max(item["wall"] for item in said)


def main() -> int:
    """Measure, print, and judge."""
    rounds = int(sys.argv[1]) if len(sys.argv) > 1 else 3
    each = (int(sys.argv[2]) if len(sys.argv) > 2 else 1000) // (PROCESSES * AGENTS)
    total = PROCESSES * AGENTS * each
    found: dict[str, list[tuple[float, float]]] = {name: [] for name in PROGRAMS}
    for _ in range(rounds):
        for name, program in PROGRAMS.items():
            found[name].append(once(program, each))
            cpu, wall = found[name][-1]
            print(f"{name:8} {cpu / total * 1e3:6.2f} ms CPU, {wall / total * 1e3:6.2f} ms a conversation")
    ratios = [
        statistics.median(item[part] for item in found["ours"])
        / statistics.median(item[part] for item in found["by hand"])
        for part in range(2)
    ]
    print(f"ours : by hand = {ratios[0]:.2f} in processor time, {ratios[1]:.2f} in wall time")
    return int(max(ratios) > LIMIT)


if __name__ == "__main__":
    sys.exit(main())
