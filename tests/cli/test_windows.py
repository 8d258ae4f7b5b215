"""Commands without what Windows lacks (`tests/support/windows`): no machine with Windows runs these tests.

Each starts a process in which our package finds none of the modules and names that only POSIX systems have.
The encoding of the streams is that of a console of Western Europe.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from tests.cli.support import GOOD, Done, asemec, command
from tests.security.lines import line
from tests.support.waiting import wait_until

WINDOWS = Path(__file__).resolve().parents[1] / "support" / "windows"


def environment(home: Path) -> dict[str, str]:
    """The variables of a process that sees Windows; its user's profile is `home`."""
    return {
        "PYTHONPATH": str(WINDOWS),
        "PYTHONIOENCODING": "cp1252",
        "PYTHONWARNDEFAULTENCODING": "1",
        "PYTHONWARNINGS": "error::EncodingWarning:aseme_dsl",
        "LOCALAPPDATA": str(home),
        "COLUMNS": "80",
    }


def on_windows(*arguments: object, cwd: Path) -> Done:
    done = subprocess.run(
        command(*arguments),
        cwd=cwd,
        stdin=subprocess.DEVNULL,
        capture_output=True,
        env={**os.environ, **environment(cwd / "profile")},
        timeout=600,
    )
    return Done(done.returncode, done.stdout.decode("cp1252"), done.stderr.decode("cp1252"))


def test_our_code_finds_no_posix(tmp_path: Path) -> None:
    """The stand-in works: what the other tests find is not there by chance."""
    module = tmp_path / "aseme_dsl_probe.py"
    module.write_text(
        "import os, signal, socket, sys\n"
        "found = [n for m, n in ((os, 'fork'), (os, 'getuid'), (signal, 'SIGKILL'), (socket, 'AF_UNIX'))"
        " if hasattr(m, n)]\n"
        "try:\n    import fcntl\n    found.append('fcntl')\nexcept ImportError:\n    pass\n"
        "print(found, sys.platform, os.name)\n",
        "utf-8",
    )
    code = "import runpy, sys; runpy.run_path(sys.argv[1], run_name='aseme_dsl.probe')"
    done = subprocess.run(
        [sys.executable, "-c", code, str(module)],
        capture_output=True,
        text=True,
        env={**os.environ, **environment(tmp_path)},
    )
    assert done.stdout == "[] win32 nt\n", done.stderr


def test_the_commands_of_a_project(tmp_path: Path) -> None:
    text = GOOD.replace("system Walker", "system Walker  // geht, bis er zu Hause ist: «ω»")
    (tmp_path / "team.aseme").write_text(text, "utf-8")
    out = tmp_path / "out" / "trace.jsonl.gz"
    for words, said in {
        "check team.aseme": "no problems found in 1 file",
        "fmt --check team.aseme": "",
        "build team.aseme": "Walker -> out",
        "diagram team.aseme iac.robot -o robot.svg": "1 created",
        "run team.aseme --for 2s": "stopped after 2 s (virtual, seed 1): time limit reached",
    }.items():
        done = on_windows(*words.split(), cwd=tmp_path)
        assert done.code == (1 if words.startswith("fmt") else 0), (words, done.err)
        assert said in done.out, (words, done.out)
        assert "Traceback" not in done.err
    there = out.read_bytes()
    assert asemec("run", "team.aseme", "--for", "2s", cwd=tmp_path).code == 0
    assert out.read_bytes() == there  # the same run as on this system


SEEDED = """
sag { actor walker { goal walk "It walks until it is home." } }
scenario "it stands" { one : robot  activity Stand takes 500ms..1500ms  by 5s one in Stand }
"""


def test_the_commands_about_runs(tmp_path: Path) -> None:
    """Scenarios, steps, and what is read from a trace."""
    (tmp_path / "team.aseme").write_text(GOOD + SEEDED, "utf-8")
    trace = "out/trace.jsonl.gz"
    for words, said in {
        "run team.aseme --for 5s": "(virtual, seed 1)",
        "test team.aseme -j 1": "1 scenario: 1 passed",
        "test team.aseme --coverage --html page.html": "states",
        f"coverage team.aseme {trace}": "states",
        f"metrics {trace}": "robot: Stand",
        f"replay {trace}": "no difference",
        f"trace {trace} --lines": "robot",
        "goals team.aseme": "goal",
    }.items():
        done = on_windows(*words.split(), cwd=tmp_path)
        assert done.code == 0, (words, done.out, done.err)
        assert said in done.out, (words, done.out)
        assert "Traceback" not in done.err
    steps = subprocess.run(
        command("sim", "team.aseme"),
        cwd=tmp_path,
        input=b"step\nback\nquit\n",
        capture_output=True,
        env={**os.environ, **environment(tmp_path / "profile")},
        timeout=600,
    )
    assert (steps.returncode, b"Traceback" in steps.stderr) == (0, False), steps.stderr
    assert b"starts" in steps.stdout


def test_scenarios_on_a_cluster(tmp_path: Path) -> None:
    distributed = pytest.importorskip("distributed")
    (tmp_path / "team.aseme").write_text(GOOD + SEEDED, "utf-8")
    with distributed.LocalCluster(
        n_workers=1, threads_per_worker=1, dashboard_address="127.0.0.1:0", host="127.0.0.1"
    ) as there:
        words = ("test", "team.aseme", "--seeds", "3", "--cluster", there.scheduler_address)
        done = on_windows(*words, cwd=tmp_path)
    assert (done.code, "Traceback" in done.err) == (0, False), done.err
    assert "1 scenario: 1 passed" in done.out


def test_the_language_server_starts(tmp_path: Path) -> None:
    request = {"jsonrpc": "2.0", "id": 1, "method": "initialize", "params": {"capabilities": {}}}
    body = json.dumps(request).encode()
    process = subprocess.Popen(
        command("lsp"),
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        env={**os.environ, **environment(tmp_path)},
    )
    assert process.stdin is not None and process.stdout is not None
    with process:
        process.stdin.write(b"Content-Length: %d\r\n\r\n%s" % (len(body), body))
        process.stdin.flush()
        size = 0
        while header := process.stdout.readline().strip():
            name, _, value = header.partition(b":")
            size = int(value) if name.lower() == b"content-length" else size
        answer = json.loads(process.stdout.read(size))
        process.stdin.close()
        assert "hoverProvider" in answer["result"]["capabilities"]


@contextmanager
def running(folder: Path) -> Iterator[None]:
    (folder / "team.aseme").write_text(GOOD, "utf-8")
    arguments = command("run", "team.aseme", "--real", "-q")
    process = subprocess.Popen(
        arguments, cwd=folder, stdin=subprocess.DEVNULL, env={**os.environ, **environment(folder / "profile")}
    )
    try:
        wait_until(lambda: next((folder / "profile").rglob("*.sock"), None) is not None)
        yield
    finally:
        process.kill()
        process.wait()


@line("team", "the same on Windows")
def test_operators_reach_a_team_over_loopback_with_its_secret(tmp_path: Path) -> None:
    with running(tmp_path):
        done = on_windows("team", "status", "--output", "out", "--json", cwd=tmp_path)
        assert done.code == 0, done.err
        assert "one" in done.out
        (path,) = (tmp_path / "profile").rglob("*.sock")
        port, _, secret = path.read_text("ascii").strip().partition(" ")
        assert len(bytes.fromhex(secret)) == 32
        path.write_text(f"{port} {'00' * 32}\n", "ascii")
        wrong = on_windows("team", "status", "--output", "out", cwd=tmp_path)
        assert wrong.code == 1
        assert "has ended before it answered" in wrong.err or "cannot be reached" in wrong.err


def test_a_process_for_each_agent_is_refused_with_the_reason(tmp_path: Path) -> None:
    pytest.importorskip("zenoh")
    (tmp_path / "team.aseme").write_text(GOOD, "utf-8")
    done = on_windows("run", "team.aseme", "--real", "--platform", "zenoh", "--for", "1s", cwd=tmp_path)
    assert done.code == 1
    assert done.err.count("Unix sockets, which this system does not have") == 1  # and not by each agent
