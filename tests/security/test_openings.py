"""`asemec doctor` says what a run of the project opens."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.cli.support import asemec

TLS = 'tls = { authority = "a.pem", certificate = "b.pem", key = "c.pem" }\n'
LOCAL = "tcp/127.0.0.1, any free port"


def opened(folder: Path, project: str) -> dict[str, list[str]]:
    (folder / "pyproject.toml").write_text(project)
    found: dict[str, list[str]] = {}
    for opening in asemec("doctor", "--json", cwd=folder).json["opens"]:
        found.setdefault(opening["platform"], []).append(opening["opens"])
    return found


@pytest.mark.parametrize(
    ("project", "platform", "opens"),
    [
        ("[tool.asemec]\n", "zenoh", ["Unix sockets in a folder with mode 0700"]),
        ("[tool.asemec]\n", "in_process", ["nothing on the network"]),
        ("[tool.asemec]\n", "spade", [LOCAL]),
        ("[tool.asemec]\n", "mango", [f"{LOCAL}, for each agent"]),
        (
            '[tool.asemec.deploy]\nhosts = { one = "10.0.0.1", two = "10.0.0.2:7000" }\n' + TLS,
            "zenoh",
            ["tls/10.0.0.1:7447", "udp/10.0.0.1:7447", "tls/10.0.0.2:7000", "udp/10.0.0.2:7000"],
        ),
        (
            '[tool.asemec.deploy]\nhosts = { one = "10.0.0.1" }\ninterface = "eth0"\n' + TLS,
            "zenoh",
            [
                "tls/10.0.0.1:7447",
                "udp/10.0.0.1:7447",
                "tls/0.0.0.0:0#iface=eth0",
                "udp/eth0, any free port",
                "udp/224.0.0.224:7446 on eth0",
            ],
        ),
        ('[tool.asemec.mango]\nhosts = { one = "10.0.0.1:5555" }\n', "mango", ["tcp/10.0.0.1:5555"]),
        ('[tool.asemec.spade]\nhost = "xmpp.example"\n', "spade", ["nothing"]),
    ],
)
def test_what_a_project_opens(tmp_path: Path, project: str, platform: str, opens: list[str]) -> None:
    assert opened(tmp_path, project)[platform] == opens


def test_it_is_printed_and_what_is_refused_opens_nothing(tmp_path: Path) -> None:
    (tmp_path / "pyproject.toml").write_text('[tool.asemec.deploy]\nhosts = { one = "10.0.0.1" }\n')
    said = asemec("doctor", cwd=tmp_path).out
    assert "sockets of a run" in said and "10.0.0.1" not in said
    assert "no run starts: `hosts` leads beyond this machine" in said
