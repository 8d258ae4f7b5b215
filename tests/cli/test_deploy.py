"""`asemec deploy`: what a bundle has, how it comes to a host, and what does not start there."""

from __future__ import annotations

import gzip
import hashlib
import io
import json
import os
import shutil
import subprocess
import sys
import tarfile
import zipfile
from pathlib import Path

import pytest

from tests.cli.support import Done, asemec, asemec_here

pytest.importorskip("cryptography")
pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="hosts of robots run Linux")

SYSTEM = """\
system Field

message Tick { int n }
topic team { signal Tick queued }

srm robot {
  liveness { robot = Say~ }
  activities { Say every 100ms writes team.signal.Tick }
}

team Two { ann, bob : robot }
"""
SAY = """\
from aseme_dsl.runtime import Context
from helping import number
from monas.Field.messages import Tick


class Say:
    def execute(self, context: Context) -> None:
        context.publish("team.signal.Tick", Tick(n=number()))
"""
PROJECT = """\
[tool.asemec]
files = ["field.aseme"]
activities = "activities"

[tool.asemec.deploy]
hosts = { ann = "127.0.0.1:7601", bob = "10.9.9.9" }
include = ["maps/*.json"]

[tool.asemec.deploy.tls]
authority = "certificates/authority.pem"
certificate = "certificates/ROBOT.pem"
key = "certificates/ROBOT.key"
"""
SSH = """#!{python}
import os, subprocess, sys
words = sys.argv[1:]
open({log!r}, "a").write(repr(words) + "\\n")
host, command = words[words.index("--") + 1:]
if host.endswith("10.9.9.9"):
    sys.exit("ssh: connect to host 10.9.9.9 port 22: No route to host")
sys.exit(subprocess.run(["sh", "-c", command], cwd={home!r}).returncode)
"""
SCP = """#!{python}
import shutil, sys
words = sys.argv[1:]
open({log!r}, "a").write(repr(words) + "\\n")
*files, place = words[words.index("--") + 1:]
for file in files:
    shutil.copy2(file, place.partition(":")[2])
"""


@pytest.fixture(scope="module")
def certified(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A project with certificates, of which each test has a copy."""
    folder = tmp_path_factory.mktemp("certified") / "project"
    for name, text in {
        "pyproject.toml": PROJECT,
        "field.aseme": SYSTEM,
        "activities/say.py": SAY,
        "helping.py": "def number() -> int:\n    return 1\n",
        "maps/hall.json": "{}",
    }.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)
    assert asemec_here("certificates", "make", cwd=folder).code == 0
    return folder


@pytest.fixture
def project(certified: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A project with certificates, and a host `127.0.0.1` whose home is the folder `home` beside it."""
    folder = tmp_path / "project"
    shutil.copytree(certified, folder)
    monkeypatch.chdir(folder)
    tools = tmp_path / "tools"
    tools.mkdir()
    (tmp_path / "home").mkdir()
    for name, script in (("ssh", SSH), ("scp", SCP)):
        text = script.format(python=sys.executable, log=str(tmp_path / "log"), home=str(tmp_path / "home"))
        (tools / name).write_text(text)
        (tools / name).chmod(0o755)
    monkeypatch.setenv(
        "PATH", os.pathsep.join([str(tools), str(Path(sys.executable).parent), os.environ["PATH"]])
    )
    return folder


def archive_in(folder: Path) -> Path:
    (found,) = folder.glob("*.tar.gz")
    return found


def contents(archive: Path) -> dict[str, bytes]:
    with tarfile.open(archive) as file:
        return {member.name: file.extractfile(member).read() for member in file}  # type: ignore[union-attr]


def installed(project: Path) -> Path:
    """The folder of the team on the host."""
    return project.parent / "home" / "asemec" / "Field"


def started(folder: Path, agent: str = "ann", *more: str) -> Done:
    done = subprocess.run(
        ["./start", agent, *more],
        cwd=folder,
        capture_output=True,
        text=True,
        timeout=120,
        stdin=subprocess.DEVNULL,
    )
    return Done(done.returncode, done.stdout, done.stderr)


def test_a_bundle_is_complete_has_no_secret_and_is_the_same_each_time(project: Path) -> None:
    done = asemec_here("deploy")
    assert done.code == 0, done.err
    archive = archive_in(project / "deploy")
    first = archive.read_bytes()
    there = contents(archive)
    assert {"pyproject.toml", "field.aseme", "helping.py", "maps/hall.json", "start"} < set(there)
    assert {"activities/say.py", "requirements.txt", "asemec.service", "install.py"} < set(there)
    assert not [name for name in there if "certificates" in name or name.endswith((".key", ".svg", ".gz"))]
    secrets = [path.read_bytes() for path in (project / "certificates").rglob("*.key")]
    assert len(secrets) == 4
    assert not any(secret in gzip.decompress(first) for secret in secrets)
    assert "Type=notify" in (unit := there["asemec.service"].decode()) and "WatchdogSec=" in unit
    beside = {path.name: path.stat().st_mode & 0o777 for path in (project / "deploy").glob("*.private.tar")}
    assert beside == {"ann.private.tar": 0o600, "bob.private.tar": 0o600}
    with tarfile.open(project / "deploy" / "ann.private.tar") as file:
        names = file.getnames()
    assert names == ["certificates/ann.key", "certificates/ann.pem", "certificates/authority.pem"]
    shutil.rmtree(project / "out")
    assert asemec_here("deploy").code == 0
    assert archive_in(project / "deploy").read_bytes() == first
    (project / "helping.py").write_text("def number() -> int:\n    return 2\n")
    assert asemec_here("deploy", "-o", "second").code == 0
    assert archive_in(project / "second").name != archive.name


def test_a_bundle_is_copied_activated_and_rolled_back(project: Path) -> None:
    done = asemec_here("deploy", "pi@ann")
    assert done.code == 0, done.err
    to = installed(project)
    first = (to / "current").readlink().name
    assert f"pi@127.0.0.1 (ann): active: {first}" in done.out
    assert {path.name for path in to.iterdir()} == {"current", "versions", "private"}  # nothing is left
    key = to / "current" / "certificates" / "ann.key"
    assert key.read_bytes() == (project / "certificates" / "ann.key").read_bytes()
    assert key.stat().st_mode & 0o777 == 0o600
    assert not (to / "current" / "certificates" / "bob.key").exists()
    done = asemec_here("deploy", "127.0.0.1", "--rollback")
    assert done.code == 1 and "has no version before the active one" in done.err
    (project / "helping.py").write_text("def number() -> int:\n    return 2\n")
    assert asemec_here("certificates", "renew", "ann").code == 0
    assert asemec_here("deploy", "ann").code == 0
    second = (to / "current").readlink().name
    assert second != first and (to / "previous").readlink().name == first
    done = asemec_here("deploy", "ann", "--rollback")
    assert done.code == 0 and f"active: {first}" in done.out
    assert (to / "current").readlink().name == first and (to / "previous").readlink().name == second
    # The version before has the certificate of today.
    assert key.read_bytes() == (project / "certificates" / "ann.key").read_bytes()
    assert "return 1" in (to / "current" / "helping.py").read_text()
    for line in (project.parent / "log").read_text().splitlines():
        assert line.startswith("['-")  # options, then `--`, then names


def test_old_versions_are_removed_but_never_the_active_one_or_the_one_before(project: Path) -> None:
    made: list[str] = []
    for number in range(4):
        (project / "helping.py").write_text(f"def number() -> int:\n    return {number}\n")
        done = asemec_here("deploy", "ann", "--keep", "2" if number == 3 else "5")
        assert done.code == 0, done.err
        made.append((installed(project) / "current").readlink().name)
    assert {path.name for path in (installed(project) / "versions").iterdir()} == set(made[2:])
    assert all(f"removed: {name}" in done.out for name in made[:2])
    assert asemec_here("deploy", "ann", "--rollback").code == 0
    (project / "helping.py").write_text("def number() -> int:\n    return 9\n")
    assert asemec_here("deploy", "ann", "--keep", "1").code == 0
    there = {path.name for path in (installed(project) / "versions").iterdir()}
    assert there == {(installed(project) / name).readlink().name for name in ("current", "previous")}
    assert made[2] in there and asemec_here("deploy", "ann", "--keep", "0").code == 2


def test_a_host_that_cannot_be_reached_fails_alone(project: Path) -> None:
    done = asemec_here("deploy", "--all")
    assert done.code == 1
    assert "127.0.0.1 (ann): active: Field-" in done.out
    assert "error[E040]: 10.9.9.9: ssh: connect to host 10.9.9.9 port 22: No route to host" in done.err


@pytest.mark.parametrize(
    ("words", "code", "said"),
    [
        (("nowhere",), 1, "`hosts` names neither an agent nor an address `nowhere`"),
        (("--", "-oProxyCommand=x@ann"), 1, "is not a destination for ssh"),
        (("--user", "-oProxyCommand=touch", "ann"), 1, "is not a destination for ssh"),
        (("--to", "x; touch y", "ann"), 2, "only letters, digits"),
        (("--rollback",), 2, "--rollback needs a HOST, or --all"),
    ],
)
def test_what_does_not_fit_is_refused(project: Path, words: tuple[str, ...], code: int, said: str) -> None:
    done = asemec_here("deploy", *words)
    assert done.code == code and said in done.err
    assert not (project.parent / "log").exists()


def test_a_secret_or_a_file_from_elsewhere_is_in_no_bundle(project: Path) -> None:
    text = PROJECT.replace("maps/*.json", "certificates/private/*")
    (project / "pyproject.toml").write_text(text)
    done = asemec_here("deploy")
    assert done.code == 1 and "authority.key has a private key, which no bundle may have" in done.err
    (project / "pyproject.toml").write_text(PROJECT.replace('"certificates/ROBOT.key"', '"../ROBOT.key"'))
    done = asemec_here("deploy")
    assert done.code == 1 and "is outside of the project" in done.err
    (project / "pyproject.toml").write_text(PROJECT.replace("maps/*.json", "maps/*.txt"))
    assert "no file is called maps/*.txt" in asemec_here("deploy").err
    assert not (project / "deploy").exists()


def test_an_agent_starts_from_its_bundle(project: Path) -> None:
    pytest.importorskip("zenoh")
    assert asemec_here("deploy", "ann").code == 0
    folder = installed(project) / "current"
    done = asemec("node", "ann", "--from", folder / "out", "--for", "1s", cwd=project.parent)
    assert done.code == 0, done.err
    assert "simulate" not in done.out + done.err
    trace = gzip.decompress((folder / "out" / "trace.ann.jsonl.gz").read_bytes()).decode()
    assert '"n":1' in trace.replace(" ", "")  # its own code has run


BREAK = {
    "activities/say.py": "activities/say.py is missing",
    "pyproject.toml": "pyproject.toml is missing",
    "helping.py": "helping.py is missing",
    "out/monas/Field/messages.py": "out/monas/Field/messages.py is missing",
    "certificates/ann.key": "certificates/ann.key is missing: it is beside the bundle",
    "certificates/authority.pem": "certificates/authority.pem is missing: it is beside the bundle",
}


def test_of_an_incomplete_or_altered_bundle_nothing_starts(project: Path) -> None:
    assert asemec_here("deploy", "ann").code == 0
    folder = installed(project) / "current"
    for name, reason in BREAK.items():
        content = (folder / name).read_bytes()
        (folder / name).unlink()
        done = started(folder)
        assert done.code == 1 and "error[E039]" in done.err and reason in done.err, name
        (folder / name).write_bytes(content)
    (folder / "activities" / "say.py").write_text(SAY + "# changed\n")
    assert "activities/say.py has been altered" in started(folder).err
    (folder / "activities" / "say.py").write_text(SAY)
    (folder / "activities" / "more.py").write_text("")
    assert "activities/more.py has been added" in started(folder).err
    (folder / "activities" / "more.py").unlink()
    (folder / "helping.py").write_text("")
    assert asemec_here("deploy", "ann").code == 0  # as the hint says
    assert "return 1" in (folder / "helping.py").read_text()
    done = started(folder, "bob")
    assert done.code == 1 and "certificates/bob.key is missing" in done.err
    # Only the output folder, as O4 had it.
    shutil.copytree(folder / "out", project.parent / "alone")
    done = asemec("node", "ann", "--from", project.parent / "alone")
    assert done.code == 1 and "error[E039]" in done.err


def test_a_certificate_that_the_others_would_refuse_is_refused_at_the_start(project: Path) -> None:
    assert asemec_here("deploy", "ann").code == 0
    folder = installed(project) / "current" / "certificates"
    good = {path.name: path.read_bytes() for path in folder.iterdir()}
    (folder / "ann.pem").write_bytes((project / "certificates" / "bob.pem").read_bytes())
    done = started(folder.parent)
    assert done.code == 1 and "error[E038]" in done.err and "do not fit" in done.err
    (folder / "ann.key").write_bytes((project / "certificates" / "bob.key").read_bytes())
    assert "is for bob, not for ann" in started(folder.parent).err
    shutil.rmtree(project / "certificates")
    asemec_here("certificates", "make")
    for name in ("ann.pem", "ann.key"):
        (folder / name).write_bytes((project / "certificates" / name).read_bytes())
    assert "certificate" in (said := started(folder.parent).err) and "error[E038]" in said
    for name, content in good.items():
        (folder / name).write_bytes(content)


def test_a_file_of_hosts_in_the_project_is_in_the_bundle_and_one_elsewhere_is_not(project: Path) -> None:
    for number, place in enumerate((Path("hosts.toml"), project.parent / "hosts.toml")):
        place.write_text('ann = "127.0.0.1"\nbob = "10.9.9.9"\n')
        hosts = 'hosts = { ann = "127.0.0.1:7601", bob = "10.9.9.9" }'
        (project / "pyproject.toml").write_text(PROJECT.replace(hosts, f'hosts = "{place}"'))
        assert asemec_here("deploy", "-o", f"to{number}").code == 0
        assert ("hosts.toml" in contents(archive_in(project / f"to{number}"))) is (number == 0)


def test_a_host_receives_its_part_of_the_operator_s_key_only(project: Path) -> None:
    from aseme_dsl.project.deploying.bundle import private_archive
    from aseme_dsl.project.settings.configuration import read_configuration
    from aseme_dsl.runtime.control.operator_key import newest_key

    hosts = '{ ann = "10.0.0.1", bob = "10.0.0.1:7448", cid = "10.0.0.2" }\ncontrol = "keys.toml"'
    text = PROJECT.replace('{ ann = "127.0.0.1:7601", bob = "10.9.9.9" }', hosts)
    (project / "pyproject.toml").write_text(text)
    shutil.copy(project / "certificates/ann.pem", project / "certificates/cid.pem")
    shutil.copy(project / "certificates/ann.key", project / "certificates/cid.key")
    assert asemec_here("key", "keys.toml").code == 0
    whole = newest_key(project / "keys.toml")
    configuration, _ = read_configuration(project / "pyproject.toml")
    for agent, there in (("ann", {"ann", "bob"}), ("bob", {"ann", "bob"}), ("cid", {"cid"})):
        archive = project / f"{agent}.tar"
        archive.write_bytes(private_archive(configuration, [agent]))
        content = contents(archive)["keys.toml"]
        (project / "part.toml").write_bytes(content)
        (project / "part.toml").chmod(0o600)
        part = newest_key(project / "part.toml")
        assert part.name == whole.name and part.secret == b"" and set(part.robots) == there
        assert part.of(agent) == whole.of(agent)


def test_requirements_that_are_not_met_are_reported(project: Path) -> None:
    (project / "requirements.txt").write_text("click==1.0\nnever-there==2.0 --hash=sha256:00\n")
    assert asemec_here("deploy", "ann").code == 0
    said = started(installed(project) / "current").err
    assert "the Python package never-there 2.0 is not installed" in said
    assert "the Python package click has version" in said


def test_a_build_without_its_activities_warns(project: Path) -> None:
    pytest.importorskip("zenoh")
    assert asemec_here("build").code == 0
    shutil.copytree(project / "out", project.parent / "alone")
    done = asemec("node", "ann", "--from", project.parent / "alone", "--for", "300ms")
    assert "warning[W201]" in done.err and "for Say: the agent simulates them" in done.err


def test_a_bundle_brings_its_python_packages(project: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from aseme_dsl.project.deploying import install
    from aseme_dsl.project.deploying.bundle import make_bundle
    from aseme_dsl.project.settings.configuration import read_configuration

    assert asemec_here("build").code == 0
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w") as file:
        about = "hallo-1.0.dist-info"
        file.writestr("hallo.py", "print('hallo')\n")
        file.writestr(f"{about}/METADATA", "Metadata-Version: 2.1\nName: hallo\nVersion: 1.0\n")
        file.writestr(f"{about}/WHEEL", "Wheel-Version: 1.0\nRoot-Is-Purelib: true\nTag: py3-none-any\n")
        file.writestr(
            f"{about}/RECORD", f"hallo.py,,\n{about}/METADATA,,\n{about}/WHEEL,,\n{about}/RECORD,,\n"
        )
    configuration, _ = read_configuration(Path("pyproject.toml"))
    wheels = {"hallo-1.0-py3-none-any.whl": out.getvalue()}
    bundle = make_bundle("Field", ["ann"], Path("out"), Path("activities"), configuration, wheels)
    Path("bundle.tar.gz").write_bytes(bundle.archive)
    version = install.install(Path("bundle.tar.gz"), Path("to"))  # a relative path, as over ssh
    python = Path("to", "versions", version, ".venv", "bin", "python")
    assert subprocess.run([python, "-m", "hallo"], capture_output=True, text=True).stdout == "hallo\n"


@pytest.mark.parametrize("name", ["../evil", "/tmp/evil", "a/../../evil", "link"])
def test_an_archive_with_a_path_that_leads_out_is_refused(project: Path, name: str) -> None:
    from aseme_dsl.project.deploying import install

    out = io.BytesIO()
    with tarfile.open(fileobj=out, mode="w:gz") as file:
        member = tarfile.TarInfo(name)
        if name == "link":
            member.type, member.linkname = tarfile.SYMTYPE, "/etc/passwd"
        file.addfile(member, io.BytesIO(b""))
    (project / "bad.tar.gz").write_bytes(out.getvalue())
    with pytest.raises(install.InstallError, match="has no place in a bundle"):
        install.install(project / "bad.tar.gz", project / "to")
    assert list((project / "to" / "versions").iterdir()) == []


def test_a_damaged_archive_leaves_the_active_version(project: Path) -> None:
    assert asemec_here("deploy", "ann").code == 0
    to = installed(project)
    before = (to / "current").readlink()
    archive = archive_in(project / "deploy")
    there = contents(archive)
    there["helping.py"] = b"import os\n"
    out = io.BytesIO()
    with tarfile.open(fileobj=out, mode="w:gz") as file:
        for name, content in there.items():
            member = tarfile.TarInfo(name)
            member.size = len(content)
            file.addfile(member, io.BytesIO(content))
    for number, content in enumerate((out.getvalue(), archive.read_bytes()[:-200], b"")):
        (project / f"bad{number}.tar.gz").write_bytes(content)
        words = ["install", str(project / f"bad{number}.tar.gz"), "--to", str(to)]
        command = [sys.executable, str(to / "current" / "install.py"), *words]
        done = subprocess.run(command, capture_output=True, text=True)
        assert done.returncode == 1 and "install.py: " in done.stderr and "Traceback" not in done.stderr
        assert (to / "current").readlink() == before and len(list((to / "versions").iterdir())) == 1


def test_the_list_names_every_file_with_its_hash(project: Path) -> None:
    assert asemec_here("deploy").code == 0
    there = contents(archive_in(project / "deploy"))
    listed = json.loads(there.pop("out/bundle.json"))
    assert listed["files"] == {name: hashlib.sha256(content).hexdigest() for name, content in there.items()}


SYSTEMCTL = """#!/bin/sh
echo "$@" >> {home}/systemctl.log
"""
LOGINCTL = """#!/bin/sh
case "$1" in
  enable-linger) {may} && touch {home}/lingers ;;
  show-user) test -e {home}/lingers && echo yes || echo no ;;
esac
"""


@pytest.mark.parametrize("may", ["true", "false"])
def test_agents_are_not_started_where_they_would_end_with_the_login(
    project: Path, monkeypatch: pytest.MonkeyPatch, may: str
) -> None:
    home = project.parent / "home"
    monkeypatch.setenv("XDG_CONFIG_HOME", str(home / "config"))
    for name, script in (("systemctl", SYSTEMCTL), ("loginctl", LOGINCTL)):
        (project.parent / "tools" / name).write_text(script.format(home=home, may=may))
        (project.parent / "tools" / name).chmod(0o755)
    done = asemec_here("deploy", "--all", "--start")
    unit = home / "config" / "systemd" / "user" / "asemec-Field@.service"
    if may == "true":
        assert "started: ann" in done.out and unit.exists()
        assert "--user restart asemec-Field@ann.service" in (home / "systemctl.log").read_text()
    else:
        assert done.code == 1 and not unit.exists()
        assert "systemd would end the agents at once" in done.err and "enable-linger" in done.err
