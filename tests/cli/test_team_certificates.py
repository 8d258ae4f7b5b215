"""`asemec certificates`: what is made is right, nothing is replaced, and what expires is reported."""

from __future__ import annotations

import contextlib
import json
import os
import ssl
import sys
from datetime import UTC, datetime, timedelta
from pathlib import Path

import pytest

from tests.cli.support import asemec, asemec_here

pytest.importorskip("cryptography")

PROJECT = """
[tool.asemec.deploy]
hosts = { robot1 = "192.168.1.11", robot2 = "robot2.local:7448" }
[tool.asemec.deploy.tls]
authority = "certificates/authority.pem"
certificate = "certificates/ROBOT.pem"
key = "certificates/ROBOT.key"
"""


@pytest.fixture
def team(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    (tmp_path / "pyproject.toml").write_text(PROJECT)
    monkeypatch.chdir(tmp_path)
    assert asemec_here("certificates", "make").code == 0
    return tmp_path / "certificates"


def shaken(team: Path, server: str, client: str, host: str, authority: Path | None = None) -> str:
    """The common name of the client that a TLS connection shows to the server, without a network."""
    there = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
    here = ssl.SSLContext(ssl.PROTOCOL_TLS_CLIENT)
    there.verify_mode = ssl.CERT_REQUIRED
    for context, name in ((there, server), (here, client)):
        context.load_verify_locations(authority or team / "authority.pem")
        context.load_cert_chain(team / f"{name}.pem", team / f"{name}.key")
    sent = {"here": ssl.MemoryBIO(), "there": ssl.MemoryBIO()}
    one = here.wrap_bio(sent["there"], sent["here"], server_hostname=host)
    two = there.wrap_bio(sent["here"], sent["there"], server_side=True)
    for _ in range(3):
        for side in (one, two):
            with contextlib.suppress(ssl.SSLWantReadError):
                side.do_handshake()
    found = two.getpeercert()
    assert found is not None
    return str(found["subject"][-1][0][1])


def test_what_is_made_authenticates_each_robot_at_its_host(team: Path) -> None:
    assert shaken(team, "robot1", "robot2", "192.168.1.11") == "robot2"
    assert shaken(team, "robot2", "robot1", "robot2.local") == "robot1"
    assert shaken(team, "robot1", "asemec-operator", "192.168.1.11") == "asemec-operator"
    with pytest.raises(ssl.SSLCertVerificationError):
        shaken(team, "robot1", "robot2", "192.168.1.12")
    with pytest.raises(ssl.SSLError):  # an operator is no server
        shaken(team, "asemec-operator", "robot1", "192.168.1.11")


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no such modes")
def test_keys_are_for_their_user_alone_and_that_of_the_authority_is_apart(team: Path) -> None:
    keys = sorted(team.rglob("*.key"))
    assert [str(path.relative_to(team)) for path in keys] == [
        "asemec-operator.key",
        "private/authority.key",
        "robot1.key",
        "robot2.key",
    ]
    assert {path.stat().st_mode & 0o777 for path in keys} == {0o600}
    assert (team / "private").stat().st_mode & 0o777 == 0o700


def test_nothing_is_replaced(team: Path) -> None:
    before = {path: path.read_bytes() for path in team.rglob("*") if path.is_file()}
    done = asemec_here("certificates", "make", "--agent", "scout=10.0.0.7,scout.local")
    assert done.code == 0 and "kept     certificates/robot1.pem" in done.out
    assert all(path.read_bytes() == content for path, content in before.items())
    assert shaken(team, "scout", "robot1", "10.0.0.7") == shaken(team, "scout", "robot1", "scout.local")


def test_a_renewed_certificate_has_a_new_key_and_the_old_one_stays(team: Path) -> None:
    before = (team / "robot1.key").read_bytes(), (team / "robot1.pem").read_bytes()
    assert asemec_here("certificates", "renew", "robot1", "--address", "10.0.0.1").code == 0
    assert (team / "robot1.key").read_bytes() != before[0]
    assert {path.read_bytes() for path in team.glob("robot1.before-*")} == set(before)
    assert shaken(team, "robot1", "robot2", "10.0.0.1") == "robot2"
    assert shaken(team, "robot1", "robot2", "192.168.1.11") == "robot2"
    asemec_here("certificates", "make", "--agent", "scout=10.0.0.7")
    assert asemec_here("certificates", "renew", "scout").code == 0
    assert shaken(team, "scout", "robot1", "10.0.0.7") == "robot1"


def test_the_list_says_what_expires_and_what_does_not_fit(team: Path) -> None:
    done = asemec_here("certificates", "list")
    assert done.code == 0
    assert [line.split()[0] for line in done.out.splitlines()] == [
        "authority",
        "robot1",
        "robot2",
        "asemec-operator",
    ]
    asemec_here("certificates", "renew", "robot1", "--days", "20")
    config = team.parent / "pyproject.toml"
    config.write_text(PROJECT.replace("robot2.local", "robot7.local"))
    done = asemec_here("certificates", "list", "--json")
    found = {item["name"]: item for item in json.loads(done.out)["result"]}
    assert done.code == 1
    assert found["robot1"]["problem"] == "expires soon" and found["robot1"]["days_left"] == 19
    assert found["robot2"]["problem"] == "not valid for robot7.local"
    assert found["robot2"]["addresses"] == ["robot2.local"]
    (team / "robot2.pem").write_bytes((team / "robot1.pem").read_bytes())
    assert "(its common name is robot1)" in asemec_here("certificates", "list").out


def test_an_expired_certificate_and_one_of_another_authority_are_reported(team: Path) -> None:
    from aseme_dsl.project.deploying.certificates import Files, validities
    from aseme_dsl.project.settings.deployment import TlsFiles

    files = Files(TlsFiles(team / "authority.pem", team / "ROBOT.pem", team / "ROBOT.key"))
    later = datetime.now(UTC) + timedelta(days=400)
    assert [item.problem for item in validities(files, {}, later)] == [None, *["expired"] * 3]
    old = team.rename(team.parent / "old")
    asemec_here("certificates", "make")
    (team / "robot1.pem").write_bytes((old / "robot1.pem").read_bytes())
    assert "robot1           " in (said := asemec_here("certificates", "list").out)
    assert "another authority has signed it" in said


@pytest.mark.parametrize(
    ("removed", "reason"),
    [
        ("authority.pem", "certificates/authority.key is there without"),
        ("private/authority.key", "certificates/private/authority.key cannot be read"),
        ("robot1.key", "certificates/robot1.pem is there without"),
        ("robot1.pem", "certificates/robot1.key is there without"),
    ],
)
def test_half_of_a_pair_is_an_error(team: Path, removed: str, reason: str) -> None:
    (team / removed).unlink()
    done = asemec_here("certificates", "make", "--agent", "scout")
    said = done.err.replace("certificates/private/authority.key is", "certificates/authority.key is")
    assert done.code == 1 and "error[E038]" in done.err
    assert reason.replace("/", os.sep) in said.replace(f"{team.parent}{os.sep}", "")


def test_without_the_library_it_says_what_to_install(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "pyproject.toml").write_text(PROJECT)
    monkeypatch.chdir(tmp_path)
    (tmp_path / "without").mkdir()
    (tmp_path / "without" / "cryptography.py").write_text("raise ImportError\n")
    done = asemec("certificates", "make", PYTHONPATH=os.pathsep.join([str(tmp_path / "without"), *sys.path]))
    assert done.code == 1 and 'pip install "aseme-dsl[certificates]"' in done.err
    assert not (tmp_path / "certificates").exists()
    (tmp_path / "pyproject.toml").write_text("")
    done = asemec_here("certificates", "make")
    assert done.code == 1 and "there is no [tool.asemec.deploy.tls]" in done.err


def test_names_are_names(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "pyproject.toml").write_text(PROJECT)
    monkeypatch.chdir(tmp_path)
    for name in ("../x", "a/b", ""):
        assert asemec_here("certificates", "make", "--agent", name).code == 2
        assert asemec_here("certificates", "renew", name).code == 2
    assert not (tmp_path / "certificates").exists()
