"""What a project says of platforms, and what is said where a platform is missing or cannot be used."""

from __future__ import annotations

import os
import sys
from pathlib import Path
from types import ModuleType

import pytest

from aseme_dsl.project.settings.configuration import Configuration, read_configuration
from aseme_dsl.project.settings.openings import openings
from aseme_dsl.project.settings.platform_settings import (
    IN_PROCESS,
    PLATFORMS,
    MangoConfiguration,
    SpadeConfiguration,
)
from aseme_dsl.project.settings.platforms import (
    BETWEEN_PROCESSES,
    GIVEN,
    PlatformError,
    _mango_hosts,
    _xmpp,
)
from aseme_dsl.project.settings.tools import OPTIONAL
from aseme_dsl.runtime.transport import TransportError
from aseme_dsl.runtime.transport.settings import Xmpp
from tests.cli.support import Here, asemec

TEAM = """
system Walk
srm walker { liveness { walker = Walk }  activities { Walk takes 10ms } }
team T { one, two : walker }
"""


def configured(folder: Path, text: str) -> tuple[Configuration, list[str]]:
    (folder / "pyproject.toml").write_text("[tool.asemec]\n" + text)
    configuration, problems = read_configuration(folder / "pyproject.toml")
    return configuration, [item.message for item in problems]


def test_each_platform_is_made_and_told_of() -> None:
    assert set(BETWEEN_PROCESSES) == set(PLATFORMS) - {IN_PROCESS}
    assert set(PLATFORMS) <= {item.platform for item in openings(Configuration(Path()))}
    assert set(PLATFORMS) - {IN_PROCESS} <= {extra for extra, _ in OPTIONAL.values()}


def test_a_project_says_which_platform_and_which_server(tmp_path: Path) -> None:
    found, problems = configured(
        tmp_path,
        """
platform = "spade"
[tool.asemec.spade]
host = "xmpp.example.org"
domain = "example.org"
account = "warehouse-ROBOT"
password = "passwords/ROBOT.txt"
register = true
authority = "authority.pem"
[tool.asemec.mango]
hosts = { one = "10.0.0.1:5601" }
""",
    )
    assert problems == []
    assert found.platform == "spade"
    settings = _xmpp(found)
    assert settings == Xmpp(
        "xmpp.example.org",
        5222,
        "example.org",
        "warehouse-ROBOT",
        tmp_path / "passwords" / "ROBOT.txt",
        True,
        True,
        tmp_path / "authority.pem",
    )
    (tmp_path / "passwords").mkdir()
    (tmp_path / "passwords" / "one.txt").write_text("secret\nand more\n")
    (tmp_path / "passwords" / "one.txt").chmod(0o600)
    assert settings.account_of("one") == "warehouse-one"
    assert settings.password_of("one") == "secret"
    with pytest.raises(TransportError, match=r"two\.txt cannot be read"):
        settings.password_of("two")
    assert _mango_hosts(found) == {"one": ("10.0.0.1", 5601)}


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        ('platform = "jade"', "`platform` must be one of in_process, zenoh, spade, mango, in quotes"),
        ("[tool.asemec.spade]\nport = 0", "`port` must be a port, such as 5222"),
        ('[tool.asemec.spade]\naccount = "one"', "`account` must be a name in quotes in which ROBOT stands"),
        ('[tool.asemec.spade]\nverify = "no"', "`verify` must be true or false"),
        ("[tool.asemec.spade]\nhost = 1", "`host` must be the name or address of a host"),
        ('[tool.asemec.spade]\npasword = "x"', "[tool.asemec.spade] has no key `pasword`"),
        (
            '[tool.asemec.mango]\nhosts = { one = "10.0.0.1" }',
            "`hosts` must be a table of addresses with ports",
        ),
    ],
)
def test_mistakes_in_it_are_said(tmp_path: Path, text: str, problem: str) -> None:
    _, problems = configured(tmp_path, text)
    assert len(problems) == 1 and problem in problems[0]


def test_what_a_project_does_not_say_is_asked_for(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv(GIVEN, raising=False)
    with pytest.raises(PlatformError, match="no XMPP server is known"):
        _xmpp(Configuration(Path()))
    with pytest.raises(PlatformError, match=r"names the XMPP server a\.b, and no file with a `password`"):
        _xmpp(Configuration(Path(), spade=SpadeConfiguration(host="a.b")))
    monkeypatch.setenv(GIVEN, '{"spade": [4711, "secret"]}')
    assert _xmpp(Configuration(Path())) == Xmpp(port=4711, password="secret", register=True, verify=False)
    given = Configuration(Path(), mango=MangoConfiguration({"one": "[::1]:5601"}))
    assert _mango_hosts(given) == {"one": ("[::1]", 5601)}


@pytest.mark.parametrize("platform", ["spade", "mango"])
def test_a_platform_that_is_not_installed_is_said_with_how_to_get_it(
    tmp_path: Path, platform: str, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, platform, None)  # so that its import fails
    monkeypatch.setitem(sys.modules, "greenlet", ModuleType("greenlet"))
    monkeypatch.setenv(GIVEN, '{"spade": [1, "x"], "mango": {"one": "h:1", "two": "h:2"}}')
    monkeypatch.chdir(tmp_path)
    (tmp_path / "walk.aseme").write_text(TEAM)
    for words in (
        ("run", "walk.aseme"),
        ("run", "walk.aseme", "--process-per-agent"),
        ("node", "one", "walk.aseme"),
    ):
        done = Here(capsys)(*words, "--platform", platform)
        assert done.code == 1
        assert f'pip install "aseme-dsl[{platform}]"' in done.err and "Traceback" not in done.err


def test_greenlet_is_asked_for_by_name(tmp_path: Path) -> None:
    (tmp_path / "greenlet.py").write_text("raise ImportError('No module named greenlet')\n")
    (tmp_path / "walk.aseme").write_text(TEAM)
    paths = {"PYTHONPATH": os.pathsep.join([str(tmp_path), *sys.path])}
    done = asemec("run", "walk.aseme", "--platform", "spade", cwd=tmp_path, **paths)
    assert done.code == 1
    assert "not whole (No module named greenlet)" in done.err


@pytest.mark.parametrize(
    ("words", "reason"),
    [
        (("--role", "walker", "--platform", "spade"), "--role runs one role in this process"),
        (("--process-per-agent", "--platform", "in_process"), "needs a transport between processes"),
    ],
)
def test_options_that_do_not_go_together(tmp_path: Path, words: tuple[str, ...], reason: str) -> None:
    (tmp_path / "walk.aseme").write_text(TEAM)
    done = asemec("run", "walk.aseme", *words, cwd=tmp_path)
    assert done.code == 2 and reason in done.err


def test_in_virtual_time_a_project_with_a_platform_plays_in_process(tmp_path: Path) -> None:
    configured(tmp_path, 'platform = "spade"\nfiles = ["walk.aseme"]\n')
    (tmp_path / "walk.aseme").write_text(TEAM)
    done = asemec("run", ".", cwd=tmp_path)
    assert done.code == 0 and "all agents completed" in done.out
