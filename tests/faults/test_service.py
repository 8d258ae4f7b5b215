"""A node as a service of its machine: notices, health, metrics, structured logs, and its end."""

from __future__ import annotations

import gzip
import json
import os
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Iterator, Mapping
from contextlib import suppress
from http.server import BaseHTTPRequestHandler, HTTPServer
from pathlib import Path
from typing import Any

import pytest

from aseme_dsl.project.operating.endpoint import AddressError, Page, address_of, json_page, serving
from aseme_dsl.project.operating.health import Health
from aseme_dsl.project.operating.measures import Measure, as_text
from aseme_dsl.project.operating.notifying import Notifier
from tests.faults.test_operate import Here, here
from tests.support.waiting import LONG, wait_until

__all__ = ["here"]  # the fixture

ONE = """\
system Alone
srm guard { liveness { guard = Watch~ } activities { Watch takes 100ms } }
team Alone { ann : guard }
"""
STUCK = """\
system Alone
function slow() : bool = "slow:slow"
srm guard {
  liveness { guard = Watch . Stop }
  activities { Watch takes 300ms  Stop takes 1s }
  control guard { enter Stop : [slow()] }
}
team Alone { ann : guard }
"""


def node(here: Here, *options: str, **environment: str) -> subprocess.Popen[str]:
    pytest.importorskip("zenoh")
    if not (here.folder / "out").exists():
        assert here.asemec("build", "one.aseme", "-o", "out")[0] == 0
    return here.begin("node", "ann", "--from", "out", *options, **environment)


@pytest.fixture
def short() -> Iterator[Path]:
    with tempfile.TemporaryDirectory(prefix="aseme", dir="/tmp") as name:
        yield Path(name)


def ask(address: str, path: str = "/health", raw: bytes | None = None) -> tuple[int, str]:
    """The status and body of an answer; (0, "") if there is none."""
    if address.startswith("unix:"):
        connection = socket.socket(socket.AF_UNIX)
        place: Any = address.removeprefix("unix:")
    else:
        connection = socket.socket()
        place = (address.rpartition(":")[0], int(address.rpartition(":")[2]))
    with connection, suppress(OSError):
        connection.settimeout(LONG)
        connection.connect(place)
        connection.sendall(raw or f"GET {path} HTTP/1.1\r\nHost: localhost\r\n\r\n".encode())
        answer = b""
        while part := connection.recv(65536):
            answer += part
        head, _, body = answer.decode().partition("\r\n\r\n")
        if head:
            return int(head.split()[1]), body
    return 0, ""


def test_a_node_notifies_its_service_manager(here: Here, short: Path) -> None:
    here.write("one.aseme", ONE)
    with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as manager:
        manager.bind(str(short / "notify"))
        manager.settimeout(LONG)
        process = node(here, NOTIFY_SOCKET=str(short / "notify"), WATCHDOG_USEC="900000")
        said: list[str] = []
        while "WATCHDOG=1" not in said or "READY=1" not in said:
            said += manager.recv(4096).decode().splitlines()
        assert said.index("READY=1") <= said.index("WATCHDOG=1")
        times = []
        for _ in range(4):
            while "WATCHDOG=1" not in manager.recv(4096).decode():
                pass
            times.append(time.monotonic())
        assert times[-1] - times[0] < 3 * 0.9 + 1.0
        process.send_signal(signal.SIGTERM)
        while "STOPPING=1" not in manager.recv(4096).decode():
            pass
        assert process.wait(LONG) == 0


def test_a_node_that_is_stuck_gives_no_sign_of_life(here: Here, short: Path) -> None:
    here.write("one.aseme", STUCK)
    here.write("slow.py", "import time\n\ndef slow() -> bool:\n    time.sleep(1000)\n    return True\n")
    address = f"unix:{short / 'health'}"
    process = node(here, "--health", address)

    def stuck() -> dict[str, Any]:
        code, body = ask(address)
        found = json.loads(body) if body else {}
        return found if code == 503 and found.get("alive") is False else {}

    found = wait_until(stuck, pause=0.1)
    assert any("ann has been in one step for" in text for text in found["problems"])
    assert ask(address, "/alive")[0] == 503
    process.kill()


def test_health_and_metrics_of_a_node(here: Here, short: Path) -> None:
    here.write("one.aseme", ONE)
    address = f"unix:{short / 'health'}"
    process = node(here, "--health", address, "-q")
    wait_until(lambda: ask(address)[0] == 200, pause=0.1)
    code, body = ask(address)
    assert json.loads(body) == {
        "ready": True,
        "alive": True,
        "problems": [],
        "notes": [],
        "system": "Alone",
        "model": json.loads(body)["model"],
        "agents": ["ann"],
    }
    assert (short / "health").stat().st_mode & 0o777 == 0o600
    code, text = ask(address, "/metrics")
    assert code == 200
    assert "asemec_ready 1\n" in text
    assert "# TYPE asemec_agent_steps_total counter\n" in text
    assert 'asemec_agent_state{agent="ann",state="Watch"' in text
    second = node(here, "--health", address)
    out, _ = second.communicate(timeout=LONG)
    assert second.returncode == 1
    assert "another process listens there" in out
    process.send_signal(signal.SIGTERM)
    assert process.wait(LONG) in (0, 1)
    assert not (short / "health").exists()


def test_logs_are_one_object_a_line(here: Here) -> None:
    here.write("one.aseme", ONE)
    process = node(here, "--log", "json", "--for", "1s")
    out, _ = process.communicate(timeout=LONG)
    assert process.returncode == 0, out
    lines = [json.loads(line) for line in out.splitlines()]
    assert all({"time", "level", "message"} <= line.keys() for line in lines)
    assert any(line.get("activity") == "Watch" and line["agent"] == "ann" for line in lines)
    assert any("stopped after" in line["message"] for line in lines)


@pytest.mark.parametrize(
    "text",
    [
        "0.0.0.0:80",
        "192.168.1.5:80",
        "example.org:80",
        "127.0.0.1",
        "127.0.0.1:70000",
        "unix:",
        ":8",
        "[::]:9",
    ],
)
def test_only_this_machine_is_served(text: str) -> None:
    with pytest.raises(AddressError):
        address_of(text)


def test_attacks_on_the_endpoint(short: Path) -> None:
    """Malformed, oversized, silent and very many requests; and what a page of the web would send."""
    pages: Mapping[str, Any] = {"/health": lambda: json_page(200, {"ready": True})}
    with serving(address_of("127.0.0.1:0"), pages) as mine:
        address = str(mine)
        assert ask(address)[0] == 200
        for raw, code in (
            (b"\x00\xff\r\n\r\n", 400),
            (b"GET /health HTTP/9.9\r\n\r\n", 400),
            (b"POST /health HTTP/1.1\r\n\r\n", 405),
            (b"GET /../etc/passwd HTTP/1.1\r\n\r\n", 404),
            (b"GET /health HTTP/1.1\r\nHost: evil.example\r\n\r\n", 403),
            (b"GET /health HTTP/1.1\r\nX: " + b"a" * 100_000 + b"\r\n\r\n", 400),
        ):
            assert ask(address, raw=raw)[0] in (code, 0), raw[:40]
        silent = [socket.create_connection((mine.host, mine.port)) for _ in range(100)]
        assert ask(address)[0] == 200
        for connection in silent:
            connection.close()
        assert all(ask(address)[0] == 200 for _ in range(1000))


def test_a_file_that_is_no_socket_is_not_removed(short: Path) -> None:
    (short / "x").write_text("mine")
    with pytest.raises(FileExistsError), serving(address_of(f"unix:{short / 'x'}"), {}):
        pass
    assert (short / "x").read_text() == "mine"


def test_what_the_environment_says_is_taken_and_hostile_values_are_ignored() -> None:
    for address in ("nowhere", "/nowhere/at/all", "@" + "x" * 300, "vsock:1:2", "/a\0b"):
        environment = {"NOTIFY_SOCKET": address, "WATCHDOG_USEC": "-5", "WATCHDOG_PID": "1"}
        notifier = Notifier(environment)
        assert environment == {} and notifier.watchdog is None
        notifier.see(Health(True))
        notifier.stopping()


def test_an_abstract_socket_is_notified() -> None:
    with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as manager:
        manager.bind(f"\0aseme-test-{os.getpid()}")
        Notifier({"NOTIFY_SOCKET": f"@aseme-test-{os.getpid()}"}).see(Health(True, ("a\nREADY=0",)))
        assert manager.recv(4096) == b"READY=1\nSTATUS=a READY=0"


def test_labels_of_metrics_are_escaped() -> None:
    text = as_text([Measure("asemec_agent_state", 1, {"state": 'a"b\\c\nd'})])
    assert text.splitlines()[-1] == 'asemec_agent_state{state="a\\"b\\\\c\\nd"} 1'


def test_metrics_go_to_opentelemetry() -> None:
    metrics = pytest.importorskip("opentelemetry.sdk.metrics.export")
    from aseme_dsl.project.operating.otel import exporting

    reader = metrics.InMemoryMetricReader()
    with exporting(lambda: [Measure("asemec_ready", 1), Measure("asemec_faults_total", 3)], "S", reader):
        found = json.loads(reader.get_metrics_data().to_json())
    (resource,) = found["resource_metrics"]
    assert resource["resource"]["attributes"]["asemec.system"] == "S"
    values = {
        metric["name"]: [point["value"] for point in metric["data"]["data_points"]]
        for scope in resource["scope_metrics"]
        for metric in scope["metrics"]
    }
    assert values["asemec_ready"] == [1] and values["asemec_faults_total"] == [3]


def test_a_collector_receives_the_measures_by_otlp_over_http(monkeypatch: pytest.MonkeyPatch) -> None:
    messages = pytest.importorskip("opentelemetry.proto.collector.metrics.v1.metrics_service_pb2")
    pytest.importorskip("opentelemetry.exporter.otlp.proto.http")
    from aseme_dsl.project.operating.otel import exporting

    received: list[tuple[str, str, bytes]] = []

    class Collector(BaseHTTPRequestHandler):
        def do_POST(self) -> None:
            content = self.rfile.read(int(self.headers["Content-Length"]))
            kind = self.headers["Content-Type"]
            content = gzip.decompress(content) if self.headers["Content-Encoding"] == "gzip" else content
            received.append((self.path, kind, content))
            self.send_response(200)
            self.send_header("Content-Length", "0")
            self.end_headers()

        def log_message(self, *arguments: object) -> None:
            pass

    with HTTPServer(("127.0.0.1", 0), Collector) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        monkeypatch.setenv("OTEL_EXPORTER_OTLP_ENDPOINT", f"http://127.0.0.1:{server.server_port}")
        monkeypatch.setenv("OTEL_METRIC_EXPORT_INTERVAL", "100")
        steps = Measure("asemec_agent_steps_total", 7, {"agent": "ann"})
        with exporting(lambda: [Measure("asemec_ready", 1), steps], "S"):
            wait_until(lambda: len(received) >= 2)
        server.shutdown()
    path, kind, content = received[0]
    assert (path, kind) == ("/v1/metrics", "application/x-protobuf")
    (resource,) = messages.ExportMetricsServiceRequest.FromString(content).resource_metrics
    about = {item.key: item.value.string_value for item in resource.resource.attributes}
    assert about["service.name"] == "asemec" and about["asemec.system"] == "S"
    metrics = {metric.name: metric for scope in resource.scope_metrics for metric in scope.metrics}
    assert [point.as_int or point.as_double for point in metrics["asemec_ready"].gauge.data_points] == [1]
    (point,) = metrics["asemec_agent_steps_total"].sum.data_points
    assert (point.as_int or point.as_double) == 7 and metrics["asemec_agent_steps_total"].sum.is_monotonic
    assert [(item.key, item.value.string_value) for item in point.attributes] == [("agent", "ann")]


def test_without_the_extra_otel_a_node_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    from aseme_dsl.project.operating.otel import ExportError, exporting

    monkeypatch.setitem(sys.modules, "opentelemetry.sdk.metrics", None)
    with pytest.raises(ExportError, match="aseme-dsl\\[otel\\]"), exporting(lambda: [], "S"):
        pass


def test_a_page_is_only_its_text() -> None:
    assert json_page(200, {"a": "é"}) == Page(200, "application/json", '{"a": "é"}\n')
