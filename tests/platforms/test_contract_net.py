"""The contract net of the acceptance files over SPADE, by the command line: as processes, and all in one."""

from __future__ import annotations

import subprocess
import sys
from collections import Counter
from pathlib import Path
from typing import Any

import pytest

from aseme_dsl.project.code.activity_files import stubs
from tests.platforms.servers import Server
from tests.support.compiling import system
from tests.support.traces import records_of

pytest.importorskip("spade", reason="SPADE is not installed: python3 dev.py long")

SOURCE = Path(__file__).parent.parent / "acceptance" / "contract_net.aseme"

ACTIVITIES = {
    "evaluate.py": """
from aseme_dsl.runtime import Context
from monas.Warehouse.messages import Bid

class Evaluate:
    def execute(self, context: Context) -> None:
        context.set_variable("reachable", context.agent != "carrier2")
        context.prepare(Bid(task="t", cost=float(context.agent[-1])))
""",
    "collect_bids.py": """
from aseme_dsl.runtime import Context
from monas.Warehouse.messages import Award

class CollectBids:
    def execute(self, context: Context) -> None:
        context.wait(1.5)
        bids = []
        while (mail := context.receive("propose")) is not None:
            bids.append(mail)
        while context.receive("refuse", "Task"):
            pass
        context.set_variable("bids", len(bids))
        for mail in bids:
            best = min(bids, key=lambda item: item.content.cost)
            what = "accept_proposal" if mail is best else "reject_proposal"
            context.send(what, Award(task="t"), mail.sender)
""",
}


def project(folder: Path, server: Server) -> None:
    """A project with the team, for a server of its own or, where that is the embedded one, none."""
    (folder / "activities").mkdir()
    for name, text in ACTIVITIES.items():
        (folder / "activities" / name).write_text(text)
    # Three carriers are enough for a machine with much else to do.
    text = SOURCE.read_text("utf-8").replace("carrier[1..8]", "carrier[1..3]")
    (folder / "net.aseme").write_text(text)
    for path, content in stubs(system(text), folder / "activities").items():
        path.write_bytes(content)
    settings = ""
    if server.kind == "prosody":
        (folder / "password").write_text("secret\n")
        (folder / "password").chmod(0o600)
        settings = f"""
[tool.asemec.spade]
host = "127.0.0.1"
port = {server.port}
domain = "localhost"
account = "net-ROBOT"
password = "password"
register = true
verify = false
"""
    (folder / "pyproject.toml").write_text(
        f'[tool.asemec]\nfiles = ["net.aseme"]\nactivities = "activities"\nplatform = "spade"\n{settings}'
    )


@pytest.mark.parametrize("how", ["--real", "--process-per-agent"])
def test_the_contract_net_finds_its_contractor(tmp_path: Path, server: Server, how: str) -> None:
    project(tmp_path, server)
    done = subprocess.run(
        [sys.executable, "-m", "aseme_dsl", "run", ".", how, "--for", "12s", "-q"],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        timeout=180,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    records: list[dict[str, Any]] = [
        record for path in sorted((tmp_path / "out").glob("trace*.jsonl.gz")) for record in records_of(path)
    ]
    mails = [r for r in records if r["kind"] == "agent_message"]
    first = min((r for r in mails if r["performative"] == "inform"), key=lambda r: r["time"])
    assert first["agent"] == "carrier1"
    name = first["conversation"]
    said = Counter((r["agent"], r["performative"]) for r in mails if r["conversation"] == name)
    assert said == {
        ("desk", "cfp"): 1,
        ("carrier1", "propose"): 1,
        ("carrier2", "refuse"): 1,
        ("carrier3", "propose"): 1,
        ("desk", "accept_proposal"): 1,
        ("desk", "reject_proposal"): 1,
        ("carrier1", "inform"): 1,
    }
    assert not [r for r in records if r["kind"] == "unexpected" and r.get("conversation") == name]
