"""Deployments: from `[tool.asemec.deploy]` to how each robot reaches the others."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest

from aseme_dsl.diagnostics import render_text
from aseme_dsl.project.settings.configuration import read_configuration
from aseme_dsl.project.settings.deployment import misfits, network_of
from aseme_dsl.runtime.transport import TransportError


def read(folder: Path, text: str) -> tuple[object, str]:
    path = folder / "pyproject.toml"
    path.write_text(text)
    configuration, problems = read_configuration(path)
    return configuration.deploy, render_text(problems)


def test_without_a_word_nothing_leaves_the_machine() -> None:
    network = network_of(None, "robot1")
    assert network.local
    assert dict(network.settings())["scouting/multicast/enabled"] == "false"


TLS = '[tool.asemec.deploy.tls]\nauthority = "ca.pem"\ncertificate = "ROBOT.pem"\nkey = "ROBOT.key"\n'


@pytest.fixture
def files(tmp_path: Path) -> Path:
    for name in ("ca.pem", "robot1.pem", "robot1.key"):
        (tmp_path / name).touch(0o600)
    return tmp_path


def test_robots_with_hosts_connect_to_each_other(files: Path) -> None:
    deployment, problems = read(
        files,
        '[tool.asemec.deploy]\nlease = "800ms"\n'
        'hosts = { robot2 = "10.0.0.1", robot1 = "10.0.0.2:7448", keeper = "[fe80::1]" }\n' + TLS,
    )
    assert problems == ""
    network = network_of(deployment, "robot1", ["robot1", "robot2"])  # type: ignore[arg-type]
    assert network.listen == ("tls/10.0.0.2:7448",)
    assert network.connect == ("tls/10.0.0.1:7447", "tls/[fe80::1]:7447")
    settings = dict(network.settings())
    assert settings["scouting/multicast/enabled"] == "false"
    assert settings["transport/link/tx/lease"] == "800"
    rules = json.loads(settings["access_control"])
    assert rules["default_permission"] == "deny"
    assert [item["id"] for item in rules["subjects"]] == ["robot2"]


def test_an_interface_is_searched(files: Path) -> None:
    deployment, problems = read(
        files, '[tool.asemec.deploy]\ninterface = "wlan0"\nhosts = { robot2 = "10.0.0.1" }\n' + TLS
    )
    assert problems == ""
    network = network_of(deployment, "robot1")  # type: ignore[arg-type]
    assert network.listen == ("tls/0.0.0.0:0#iface=wlan0",)
    assert dict(network.settings())["scouting/multicast/interface"] == '"wlan0"'


def test_each_robot_has_its_own_files(files: Path) -> None:
    (files / "access.json").write_text('{"enabled": true}')
    deployment, problems = read(
        files,
        '[tool.asemec.deploy]\naccess = "access.json"\nhosts = { robot1 = "127.0.0.1" }\n' + TLS,
    )
    assert problems == ""
    network = network_of(deployment, "robot1", ["robot1"])  # type: ignore[arg-type]
    settings = dict(network.settings())
    assert settings["transport/link/tls/connect_private_key"] == f'"{files}/robot1.key"'
    assert settings["transport/link/tls/enable_mtls"] == "true"
    assert settings["access_control"] == '{"enabled": true}'
    with pytest.raises(TransportError, match=r"robot2\.pem cannot be read: No such file"):
        dict(network_of(deployment, "robot2").settings())  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("text", "codes"),
    [
        ('hosts = { robot1 = "127.0.0.1" }', ["E015"]),
        ('interface = "wlan0"', ["E015", "E016"]),
        ('connect = ["tcp/10.0.0.1:7447"]', ["E015"]),
        ('connect = ["tls/10.0.0.1:7447", "tcp/10.0.0.1:7447"]\n' + TLS, ["E015"]),
        ('access = "access.json"', ["E016"]),
        (TLS, ["E016"]),
        ('interface = "wlan0"\n' + TLS, ["E016", "E016"]),
    ],
)
def test_nobody_is_let_in_without_a_certificate(tmp_path: Path, text: str, codes: list[str]) -> None:
    _, problems = read(tmp_path, f"[tool.asemec.deploy]\n{text}\n")
    assert re.findall(r"error\[(E\d+)\]", problems) == codes
    assert problems.count("pyproject.toml:") == len(codes)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("hosts = 5", "`hosts` must be a table of addresses"),
        ('hosts = { robot1 = "tcp/10.0.0.1:1" }', "`hosts` must be a table of addresses"),
        ('interface = ""', "`interface` must be the name or address"),
        ('connect = ["10.0.0.1"]', "`connect` must be a list of endpoints"),
        ('lease = "soon"', "`lease` must be a duration"),
        ('host = "x"', "has no key `host`"),
        ('tls = { authority = "ca.pem" }', "[tool.asemec.deploy.tls] needs a `certificate`, too"),
        ("tls = 3", "`tls` must be a table"),
    ],
)
def test_mistakes_are_said_with_their_place(tmp_path: Path, text: str, message: str) -> None:
    _, problems = read(tmp_path, f"[tool.asemec.deploy]\n{text}\n")
    assert "error[E010]" in problems and message in problems and "pyproject.toml:" in problems


def test_a_deployment_fits_its_team(tmp_path: Path) -> None:
    deployment, _ = read(
        tmp_path, '[tool.asemec.deploy]\nhosts = { robot1 = "10.0.0.1", robot9 = "10.0.0.9" }\n'
    )
    found = misfits(deployment, ["robot1", "robot2"], "pyproject.toml")  # type: ignore[arg-type]
    assert [item.message for item in found] == [
        "pyproject.toml: there is no agent robot9 in the team; there are robot1, robot2",
        "pyproject.toml: no agent would find robot2: it has no host, and there is no interface to look on",
    ]


def test_hosts_may_stand_in_a_file_of_their_own(files: Path) -> None:
    text = '[tool.asemec.deploy]\nhosts = "hosts.toml"\n' + TLS
    (files / "hosts.toml").write_text('robot1 = "10.0.0.2:7448"\nrobot2 = "robot2.local"\n')
    deployment, problems = read(files, text)
    assert problems == ""
    network = network_of(deployment, "robot1", ["robot1", "robot2"])  # type: ignore[arg-type]
    assert network.listen == ("tls/10.0.0.2:7448",) and network.connect == ("tls/robot2.local:7447",)
    for content, said in (
        ("robot1 = 5", "of `hosts` is not a table of hosts"),
        ("robot1", "of `hosts` is not valid TOML"),
        (None, "of `hosts` cannot be read: No such file"),
    ):
        (files / "hosts.toml").unlink()
        if content is not None:
            (files / "hosts.toml").write_text(content)
        else:
            text = text.replace("hosts.toml", "other.toml")
        deployment, problems = read(files, text)
        assert "error[E010]" in problems and said in problems
        (files / "hosts.toml").touch()


@pytest.mark.parametrize(
    ("found", "listens"),
    [
        (["127.0.1.1"], "0.0.0.0"),  # as Debian has it
        (["192.0.2.7"], "0.0.0.0"),  # an address that this machine does not have
        ([], "0.0.0.0"),
    ],
)
def test_an_agent_whose_host_is_a_name_listens_where_this_machine_can(
    files: Path, monkeypatch: pytest.MonkeyPatch, found: list[str], listens: str
) -> None:
    import socket

    kind = (socket.AF_INET, socket.SOCK_DGRAM, 0, "")
    monkeypatch.setattr(socket, "getaddrinfo", lambda *_, **__: [(*kind, (one, 0)) for one in found])
    deployment, _ = read(
        files, '[tool.asemec.deploy]\nhosts = { robot1 = "one.local", robot2 = "two.local:7000" }\n' + TLS
    )
    network = network_of(deployment, "robot1", ["robot1", "robot2"])  # type: ignore[arg-type]
    assert network.listen == (f"tls/{listens}:7447",) and network.connect == ("tls/two.local:7000",)
