"""Installs a bundle on the host of a robot: unpacks it, activates it, returns to the version before.

This file runs on the robot, alone: it needs Python and its standard library. The folder of a team has:

    versions/VERSION/   bundles as they were unpacked; none is changed
    current, previous   links to two of them
    private/            certificates, keys, and what else is only for this host
    state/              what agents keep for their next start
"""

from __future__ import annotations

import argparse
import getpass
import hashlib
import json
import os
import re
import secrets
import shutil
import subprocess
import sys
import tarfile
from collections.abc import Iterable, Iterator
from pathlib import Path, PurePosixPath
from typing import NamedTuple

LIST = "out/bundle.json"
"""The list of a bundle: its files with their hashes."""
_VERSION = re.compile("[A-Za-z][A-Za-z0-9_]*-[0-9a-f]{12}")
_UNIT = "asemec.service"
_LARGEST = 4 << 30
KEEP = 5
"""So many versions remain on a host, if nothing else is said; the active one and the one before always do."""
_AGENT = re.compile(r"[A-Za-z_]\w*")


class Listed(NamedTuple):
    """The list of a bundle: the folders of its activities, what is beside it for each agent, its files."""

    version: str
    activities: list[str]
    private: dict[str, list[str]]
    files: dict[str, str]


class InstallError(Exception):
    """The bundle cannot be installed; the text says why. The active version has not changed."""


def install(archive: Path, to: Path, private: Iterable[Path] = ()) -> str:
    """Unpack and activate a bundle; its version. Raises InstallError."""
    to.mkdir(parents=True, exist_ok=True)
    to = to.resolve()  # pip runs in another folder
    for file in private:
        _unpack_private(file, to / "private")
    version = _unpack(archive, to / "versions")
    os.utime(to / "versions" / version)  # its age is that of its last installation
    _activate(to, version)
    return version


def prune(to: Path, keep: int) -> list[str]:
    """Remove the oldest versions but so many, and but the active one and the one before; their names."""
    needed = {(to / name).readlink().name for name in ("current", "previous") if (to / name).is_symlink()}
    found = [path for path in (to / "versions").iterdir() if _VERSION.fullmatch(path.name)]
    found.sort(key=lambda path: (path.name in needed, path.stat().st_mtime_ns), reverse=True)
    removed: list[str] = []
    for path in found[max(keep, len(needed)) :]:
        gone = path.with_name(f".part-{secrets.token_hex(4)}")
        path.rename(gone)  # in one step: a version is whole or not there
        shutil.rmtree(gone, ignore_errors=True)
        removed.append(path.name)
    return sorted(removed)


def rollback(to: Path) -> str:
    """Activate the version before; its name. Raises InstallError."""
    try:
        before = (to / "previous").readlink().name
    except OSError:
        raise InstallError(f"{to} has no version before the active one") from None
    if not (to / "versions" / before).is_dir():
        raise InstallError(f"{to / 'versions' / before} is missing")
    _activate(to, before)
    return before


def _activate(to: Path, version: str) -> None:
    """Make a version the active one, in one step. What is private to the host is copied into it before."""
    place = to / "versions" / version
    for file in _files(to / "private"):
        target = place / file.relative_to(to / "private")
        target.parent.mkdir(parents=True, exist_ok=True)
        part = target.with_name(f".{target.name}.{secrets.token_hex(4)}")
        shutil.copyfile(file, part)
        part.chmod(0o600)
        part.replace(target)
    now = to / "current"
    before = now.readlink().name if now.is_symlink() else None
    if before is not None and before != version:
        _link(to / "previous", before)
    _link(now, version)


def _link(link: Path, version: str) -> None:
    new = link.with_name(f".{link.name}.{secrets.token_hex(4)}")
    new.symlink_to(Path("versions") / version)
    new.replace(link)


def _unpack(archive: Path, versions: Path) -> str:
    """Unpack a bundle into a folder of its version, if it is not there, and check it."""
    versions.mkdir(exist_ok=True)
    part = versions / f".part-{secrets.token_hex(4)}"
    damaged: Path | None = None
    try:
        with tarfile.open(archive, "r:gz") as file:
            members = file.getmembers()
            if sum(member.size for member in members) > _LARGEST:
                raise InstallError(f"{archive} unpacks to more than 4 GB")
            for member in members:
                content = _content(file, member)
                target = part / member.name
                target.parent.mkdir(parents=True, exist_ok=True)
                target.write_bytes(content)
                target.chmod(0o755 if member.mode & 0o100 else 0o644)
        version = check(part)
        place = versions / version
        if not _is_complete(place):
            _make_environment(part)
            if place.exists():
                place.rename(damaged := place.with_name(f"{part.name}.damaged"))
            part.rename(place)
            if damaged is not None:
                shutil.rmtree(damaged, ignore_errors=True)
    except (OSError, tarfile.TarError, EOFError) as problem:
        raise InstallError(f"{archive} cannot be unpacked: {problem}") from problem
    finally:
        shutil.rmtree(part, ignore_errors=True)
    return version


def _content(file: tarfile.TarFile, member: tarfile.TarInfo) -> bytes:
    path = PurePosixPath(member.name)
    taken = file.extractfile(member) if member.isreg() else None
    if taken is None or path.is_absolute() or ".." in path.parts or "\\" in member.name:
        raise InstallError(f"{member.name} has no place in a bundle")
    return taken.read()


def _unpack_private(archive: Path, place: Path) -> None:
    place.mkdir(mode=0o700, exist_ok=True)
    try:
        with tarfile.open(archive, "r:") as file:
            for member in file.getmembers():
                content = _content(file, member)
                target = place / member.name
                target.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
                part = target.with_name(f".{target.name}.{secrets.token_hex(4)}")
                with os.fdopen(os.open(part, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600), "wb") as new:
                    new.write(content)
                part.replace(target)
    except (OSError, tarfile.TarError) as problem:
        raise InstallError(f"{archive} cannot be unpacked: {problem}") from problem


def read_list(folder: Path) -> Listed:
    """The list of an unpacked bundle. Raises InstallError if it is missing or damaged."""
    try:
        document = json.loads((folder / LIST).read_bytes())
        found = Listed(*(document[name] for name in Listed._fields))
        if document["format"] != 1 or not _VERSION.fullmatch(found.version):
            raise ValueError(found.version)
        if found.version.rpartition("-")[2] != digest(found):
            raise ValueError(found.files)
    except (OSError, ValueError, KeyError, TypeError, AttributeError, RecursionError):
        raise InstallError(f"{LIST} is missing or damaged") from None
    return found


def digest(found: Listed) -> str:
    """What a version is called: a hash of its list, with the hashes of its files."""
    text = json.dumps([found.activities, found.private, found.files], sort_keys=True)
    return hashlib.sha256(text.encode()).hexdigest()[:12]


def altered(folder: Path, found: Listed) -> Iterator[str]:
    """What of a bundle is missing or not as it was made."""
    for name, wanted in found.files.items():
        try:
            content = (folder / name).read_bytes()
        except OSError:
            yield f"{name} is missing"
        else:
            if hashlib.sha256(content).hexdigest() != wanted:
                yield f"{name} has been altered"
    for name in found.activities:
        for path in sorted((folder / name).rglob("*.py")):
            there = path.relative_to(folder).as_posix()
            if there not in found.files:
                yield f"{there} has been added"


def check(folder: Path) -> str:
    """The version of an unpacked bundle. Raises InstallError if it is not complete."""
    found = read_list(folder)
    wrong = next(altered(folder, found), None)
    if wrong is not None:
        raise InstallError(f"{folder}: {wrong}")
    return found.version


def _is_complete(folder: Path) -> bool:
    try:
        check(folder)
    except InstallError:
        return False
    return True


def _make_environment(folder: Path) -> None:
    """A Python environment with the wheels of the bundle, if it has some."""
    if not (folder / "wheels").is_dir():
        return
    python = folder / ".venv" / "bin" / "python"
    pip = [str(python), "-m", "pip", "install", "--quiet", "--no-input", "--disable-pip-version-check"]
    wheels = ["--no-index", "--find-links", "wheels", "--require-hashes", "-r", "requirements.txt"]
    for command in ([sys.executable, "-m", "venv", str(folder / ".venv")], [*pip, *wheels]):
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
        if done.returncode != 0:
            raise InstallError(f"`{' '.join(command)}` failed: {(done.stderr or done.stdout).strip()[-800:]}")


def _files(folder: Path) -> Iterator[Path]:
    return (path for path in sorted(folder.rglob("*")) if path.is_file())


def start(to: Path, agents: Iterable[str]) -> None:
    """Have systemd run these agents, as services of this user. Raises InstallError.

    Without `linger`, systemd ends the services of a user with the last session: here, with that of ssh.
    """
    if _has_no_linger():
        subprocess.run(["loginctl", "enable-linger"], capture_output=True)  # some systems allow it to all
        if _has_no_linger():
            raise InstallError(
                "systemd would end the agents at once, with this login: enter on this host "
                f"`sudo loginctl enable-linger {getpass.getuser()}`, then start them again"
            )
    system = (to / "current").readlink().name.rpartition("-")[0]
    text = (to / "current" / _UNIT).read_text().replace("@DIRECTORY@", str(to.resolve()))
    unit = Path(os.environ.get("XDG_CONFIG_HOME") or Path.home() / ".config") / "systemd" / "user"
    unit.mkdir(parents=True, exist_ok=True)
    (unit / f"asemec-{system}@.service").write_text(text)
    names = [f"asemec-{system}@{agent}.service" for agent in agents if _AGENT.fullmatch(agent)]
    for words in (["daemon-reload"], ["enable", *names], ["restart", *names]):
        try:
            done = subprocess.run(["systemctl", "--user", *words], capture_output=True, text=True)
        except OSError as problem:
            raise InstallError(f"systemctl cannot be started: {problem.strerror}") from problem
        if done.returncode != 0:
            raise InstallError(f"`systemctl --user {' '.join(words)}` failed: {done.stderr.strip()[-400:]}")


def _has_no_linger() -> bool:
    """Whether services of this user end with the last session. False if systemd-logind is not there."""
    words = ["loginctl", "show-user", getpass.getuser(), "--property=Linger", "--value"]
    try:
        return subprocess.run(words, capture_output=True, text=True).stdout.strip() == "no"
    except OSError:
        return False


def main(arguments: list[str]) -> int:
    """Do what the command line says; the exit code."""
    parser = argparse.ArgumentParser(prog="install.py", description="Install the bundle of a team.")
    parser.add_argument("what", choices=["prepare", "install", "rollback", "list"])
    parser.add_argument("archive", nargs="?", type=Path, help="the bundle, a .tar.gz")
    parser.add_argument("--to", type=Path, required=True, help="the folder of the team on this host")
    parser.add_argument("--private", type=Path, action="append", default=[], help="files for this host alone")
    parser.add_argument("--keep", type=int, default=KEEP, help="how many versions remain on this host")
    parser.add_argument("--start", action="append", default=[], help="agent to start with systemd")
    given = parser.parse_args(arguments)
    to = Path(os.path.expanduser(given.to))  # noqa: PTH111
    try:
        if given.what == "prepare":
            to.mkdir(parents=True, exist_ok=True)
            incoming = to / f".incoming-{secrets.token_hex(4)}"
            incoming.mkdir(mode=0o700)
            print(incoming.resolve())
            return 0
        if given.what == "list":
            now = (to / "current").readlink().name if (to / "current").is_symlink() else None
            for place in sorted((to / "versions").glob("*-*")):
                print(f"{'*' if place.name == now else ' '} {place.name}")
            return 0
        if given.what == "install":
            if given.archive is None:
                parser.error("install needs the bundle")
            incoming = given.archive.parent
            try:
                version = install(given.archive, to, given.private)
            finally:
                if incoming.name.startswith(".incoming-"):
                    shutil.rmtree(incoming, ignore_errors=True)
        else:
            version = rollback(to)
        print(f"active: {version}")
        if given.what == "install":
            for name in prune(to, given.keep):
                print(f"removed: {name}")
        if given.start:
            start(to, given.start)
            print(f"started: {', '.join(given.start)}")
    except InstallError as problem:
        print(f"install.py: {problem}", file=sys.stderr)
        return 1
    except OSError as problem:
        print(f"install.py: {problem.filename or to}: {problem.strerror}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
