"""A bundle: all that the hosts of a team need to run its agents, but no certificate and no key.

One bundle serves all agents. It is a `.tar.gz`; the same input gives the same bytes.
"""

from __future__ import annotations

import contextlib
import gzip
import hashlib
import io
import json
import re
import tarfile
from collections.abc import Collection, Iterable, Iterator, Mapping
from importlib import metadata
from pathlib import Path, PurePosixPath

from aseme_dsl import outside
from aseme_dsl.project.deploying import install
from aseme_dsl.project.settings.configuration import FILE, Configuration
from aseme_dsl.project.settings.deployment import ROBOT, file_of, host_of, keys_of
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.control.operator_key import KeyFileError, keys_for

OUT = "out"
"""Where the output folder of the build is in a bundle."""
_CODE = (".py", ".aseme", ".proto")
_REQUIREMENTS = "requirements.txt"
_LEFT_OUT = re.compile(r"trace\..*|.*\.(pyc|svg|pdf|part)|diagrams|versions|__pycache__|\.state")

START = """#!/bin/sh
# Starts an agent of this version: ./start AGENT
cd -- "$(dirname -- "$(readlink -f -- "$0")")" || exit 1
python=python3
[ ! -x .venv/bin/python ] || python=.venv/bin/python
exec "$python" -m aseme_dsl node "$1" --from out STATE
"""
UNIT = """[Unit]
Description=Agent %i of SYSTEM
After=network-online.target
Wants=network-online.target
StartLimitIntervalSec=120
StartLimitBurst=10

[Service]
Type=notify
NotifyAccess=main
WatchdogSec=10
Restart=on-failure
RestartSec=1
TimeoutStopSec=15
Environment=MALLOC_ARENA_MAX=2
ExecStart=@DIRECTORY@/current/start %i
NoNewPrivileges=yes

[Install]
WantedBy=default.target
"""


class BundleError(Exception):
    """A bundle cannot be made; the text says why."""


@dataclass(frozen=True, slots=True)
class Bundle:
    """A bundle, as bytes, and what it is called."""

    version: str
    archive: bytes
    agents: tuple[str, ...]

    @property
    def name(self) -> str:
        """The name of its file."""
        return f"{self.version}.tar.gz"


def make_bundle(
    system: str,
    agents: Iterable[str],
    output: Path,
    activities: Path,
    configuration: Configuration,
    wheels: Mapping[str, bytes] | None = None,
    without: Path | None = None,
) -> Bundle:
    """The bundle of a team that was built into `output`; nothing of the folder `without` is in it.

    `wheels` are the Python packages to bring along, by the names of their files.

    Raises:
        BundleError: a file cannot be read, is missing, or has its place outside of the project.
    """
    files = dict(_output_files(output))
    code = _activities_in(activities, output, configuration)
    files |= {code / path.relative_to(activities): path for path in _sources(activities, (".py",))}
    files |= dict(_project_files(configuration, (output, *([] if without is None else [without]))))
    names = tuple(agents)
    contents = {path.as_posix(): _read(source) for path, source in files.items()}
    for name in names:
        for path in private_files(configuration, name).values():
            contents.pop(path.as_posix(), None)
    for place, content in contents.items():
        if b"PRIVATE KEY-----" in content:
            raise BundleError(f"{place} has a private key, which no bundle may have")
    state = "--state ../../state" if configuration.run and configuration.run.state else ""
    contents["start"] = START.replace("STATE", state).replace(" \n", "\n").encode()
    contents["asemec.service"] = UNIT.replace("SYSTEM", system).encode()
    contents["install.py"] = Path(install.__file__).read_bytes()
    contents[_REQUIREMENTS] = _requirements(configuration, wheels).encode()
    for name, content in (wheels or {}).items():
        contents[f"wheels/{name}"] = content
    hashes = {name: hashlib.sha256(contents[name]).hexdigest() for name in sorted(contents)}
    beside = {
        name: sorted(path.as_posix() for path in private_files(configuration, name).values())
        for name in names
    }
    found = install.Listed("", [code.as_posix()], beside, hashes)
    version = f"{system}-{install.digest(found)}"
    listed = {
        "format": 1,
        "asemec": metadata.version("aseme-dsl"),
        **found._replace(version=version)._asdict(),
    }
    contents[install.LIST] = (json.dumps(listed, indent=1, ensure_ascii=False) + "\n").encode()
    return Bundle(version, _archive(contents), names)


def private_files(configuration: Configuration, agent: str) -> dict[Path, PurePosixPath]:
    """The certificates and keys of an agent, each with its place in an unpacked bundle.

    Raises:
        BundleError: a place is outside of the project.
    """
    deploy = configuration.deploy
    if deploy is None:
        return {}
    tls = deploy.tls
    named = (tls.authority, tls.certificate, tls.key) if tls is not None else ()
    return {
        file_of(path, agent): _place(file_of(path, agent), configuration)
        for path in (*named, deploy.control)
        if path is not None
    }


def private_archive(configuration: Configuration, agents: Iterable[str]) -> bytes:
    """The certificates and keys of some agents, as a .tar.

    Of operators' keys it has what follows from them for the agents of one host.

    Raises:
        BundleError: a file cannot be read.
    """
    contents: dict[str, bytes] = {}
    for agent in agents:
        keys = keys_of(configuration.deploy, agent)
        for path, place in private_files(configuration, agent).items():
            contents[place.as_posix()] = (
                _keys_for(path, configuration, agent) if path == keys else _read(path)
            )
    return _tar(contents, 0o600)


def _keys_for(path: Path, configuration: Configuration, agent: str) -> bytes:
    """The keys of a file for an agent, and for those of its host that have the same file."""
    assert configuration.deploy is not None
    hosts = {name: host_of(host) for name, host in configuration.deploy.hosts.items()}
    place = hosts.get(agent)
    same = [name for name, host in hosts.items() if host == place]
    try:
        return keys_for(path, [x for x in same if keys_of(configuration.deploy, x) == path] or [agent])
    except KeyFileError as problem:
        raise BundleError(str(problem)) from problem


def _output_files(output: Path) -> Iterator[tuple[PurePosixPath, Path]]:
    """What of a build the agents need; no drawings, traces, nor what earlier runs have left."""
    for path in sorted(output.rglob("*")):
        inside = path.relative_to(output)
        if path.is_file() and not any(_LEFT_OUT.fullmatch(part) for part in inside.parts):
            yield PurePosixPath(OUT, *inside.parts), path


def _activities_in(activities: Path, output: Path, configuration: Configuration) -> PurePosixPath:
    """Where the folder of the activities is in a bundle."""
    real = activities.resolve()
    if real.is_relative_to(output.resolve()):
        return PurePosixPath(OUT, *real.relative_to(output.resolve()).parts)
    return _place(activities, configuration)


def _project_files(
    configuration: Configuration, without: Iterable[Path]
) -> Iterator[tuple[PurePosixPath, Path]]:
    """The project file, the sources, what activities may import, and the access rules."""
    folder = configuration.folder
    if configuration.path is None:
        raise BundleError("the project has no pyproject.toml, which says how its agents reach each other")
    yield PurePosixPath(FILE), configuration.path
    for path in _sources(folder, _CODE, {path.resolve() for path in without}):
        yield PurePosixPath(*path.relative_to(folder).parts), path
    deploy = configuration.deploy
    if deploy is None:
        return
    access = deploy.access
    if access is not None:
        rules = [access]
        if ROBOT in access.name:
            start, _, end = access.name.partition(ROBOT)
            rules = sorted(access.parent.glob(f"{start}*{end}"))
        for path in rules:
            yield _place(path, configuration), path
    if deploy.hosts_file is not None and deploy.hosts_file.resolve().is_relative_to(folder.resolve()):
        yield _place(deploy.hosts_file, configuration), deploy.hosts_file
    for pattern in deploy.include:
        found = [path for path in sorted(folder.glob(pattern)) if path.is_file()]
        if not found:
            raise BundleError(f"`include`: no file is called {pattern}")
        for path in found:
            yield _place(path, configuration), path


def _sources(folder: Path, endings: tuple[str, ...], without: Collection[Path] = ()) -> Iterator[Path]:
    """Files with these endings, but none in hidden folders, virtual environments or the output folder."""
    for path in sorted(folder.iterdir()) if folder.is_dir() else ():
        if path.name.startswith(".") or path.name == "__pycache__":
            continue
        if path.is_dir():
            if path.resolve() not in without and not (path / "pyvenv.cfg").exists():
                yield from _sources(path, endings, without)
        elif path.suffix in endings:
            yield path


def _place(path: Path, configuration: Configuration) -> PurePosixPath:
    """The place of a file of the project in an unpacked bundle."""
    folder = configuration.folder.resolve()
    absolute = path.parent.resolve() / path.name
    if (path.is_absolute() and not configuration.folder.is_absolute()) or not absolute.is_relative_to(folder):
        raise BundleError(f"{path} is outside of the project: a robot would not find it there")
    return PurePosixPath(*absolute.relative_to(folder).parts)


def _requirements(configuration: Configuration, wheels: Mapping[str, bytes] | None) -> str:
    """What pip is to install for this bundle."""
    if wheels is not None:
        lines = []
        for name, content in sorted(wheels.items()):
            package, version = name.split("-")[:2]
            digest = hashlib.sha256(content).hexdigest()
            lines.append(f"{package}=={version} --hash=sha256:{digest}\n")
        return "".join(lines)
    own = configuration.folder / _REQUIREMENTS
    text = _read(own).decode("utf-8", "replace") if own.is_file() else ""
    zenoh = ""
    with contextlib.suppress(metadata.PackageNotFoundError):
        zenoh = f"eclipse-zenoh=={metadata.version('eclipse-zenoh')}\n"
    return f"aseme-dsl=={metadata.version('aseme-dsl')}\n{zenoh}{text.strip()}".strip() + "\n"


def _archive(contents: Mapping[str, bytes]) -> bytes:
    out = io.BytesIO()
    with gzip.GzipFile("", "wb", 9, out, mtime=0) as file:
        file.write(_tar(contents, 0o644))
    return out.getvalue()


def _tar(contents: Mapping[str, bytes], mode: int) -> bytes:
    out = io.BytesIO()
    with tarfile.open(fileobj=out, mode="w", format=tarfile.PAX_FORMAT) as file:
        for name in sorted(contents):
            member = tarfile.TarInfo(name)
            member.size = len(contents[name])
            member.mode = 0o755 if name == "start" else mode
            file.addfile(member, io.BytesIO(contents[name]))
    return out.getvalue()


def _read(path: Path) -> bytes:
    try:
        return outside.read_bytes(path)
    except OSError as problem:
        raise BundleError(f"{path} cannot be read: {problem.strerror or problem}") from problem
