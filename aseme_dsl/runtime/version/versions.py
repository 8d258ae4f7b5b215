"""Versions on disk: folders of generated packages and activities, named by the hash of all that is in them.

A robot loads a version only from its own folder of versions, and runs the very bytes that it has hashed. It
does not read files again that are exchanged on the disk afterwards. Only its user may be able to write there.
"""

from __future__ import annotations

import hashlib
import os
import re
import stat
import sys
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import field
from importlib.abc import ExecutionLoader, MetaPathFinder
from importlib.machinery import ModuleSpec
from pathlib import Path
from types import ModuleType

from aseme_dsl.records import dataclass

VERSIONS = "versions"
"""The folder inside an output folder with the versions that teams were changed to."""
ACTIVITIES = "activities"
"""The folder inside a version with the code of the activities."""
LARGEST = 256 << 20
"""A version has at most so many bytes."""
MOST = 10_000
"""A version has at most so many files and folders."""
DEEPEST = 16
"""So many folders may stand in each other."""
HASH = re.compile("[0-9a-f]{64}")

IS_POSIX = hasattr(os, "geteuid")
"""Whether files belong to users, who are numbers. On Windows they do not."""
_OPEN = os.O_RDONLY | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0)


class VersionError(Exception):
    """A version cannot be used; the text says why."""


@dataclass(frozen=True, slots=True)
class VersionFiles:
    """A version as it was read: its hash and its Python files by their paths in it, such as
    `activities/kick.py`."""

    folder: Path
    hash: str
    code: Mapping[str, bytes] = field(repr=False)

    @property
    def systems(self) -> tuple[str, ...]:
        """The systems of which it has packages."""
        parts = [path.split("/") for path in self.code]
        return tuple(dict.fromkeys(part[1] for part in parts if part[2:] == ["messages.py"]))

    def as_package(self, name: str) -> None:
        """From now on its activities are imported as modules of a package of this name."""
        package = ModuleType(name, "Activities of a version.")
        package.__path__ = [f"{_mark(self)}/{ACTIVITIES}"]
        sys.modules[name] = package


def hash_of(files: Mapping[str, bytes]) -> str:
    """The hash of a version with these files, by their paths in it."""
    return _hash({path: hashlib.sha256(content).digest() for path, content in files.items()})


def _hash(digests: Mapping[str, bytes]) -> str:
    """The hash of all paths and contents: neither can be moved into the other."""
    whole = hashlib.sha256(b"aseme version 1\0")
    for path, digest in sorted(digests.items()):
        name = os.fsencode(path)
        whole.update(len(name).to_bytes(8, "big") + name + digest)
    return whole.hexdigest()


# ---- reading -----------------------------------------------------------------------------------------


def read_version(store: Path, name: str) -> VersionFiles:
    """The version of this hash in a folder of versions.

    Raises:
        VersionError: it is not there, is not of that hash, or another user may have written it.
    """
    if not HASH.fullmatch(name):
        raise VersionError("a version is named by the 64 digits of its hash")
    if not IS_POSIX:
        raise VersionError("on this system a running team cannot change to another version: start it again")
    store = store.absolute()
    check_place(store)
    digests: dict[str, bytes] = {}
    code: dict[str, bytes] = {}
    try:
        with _opened(store, None, store) as around, _opened(name, around, store / name) as top:
            _read(top, "", store / name, digests, code, [LARGEST, MOST])
    except FileNotFoundError as problem:
        raise VersionError(f"there is no version {name[:12]} in {store}: copy it there first") from problem
    except OSError as problem:
        raise VersionError(f"the version {name[:12]} cannot be read: {_why(problem)}") from problem
    if _hash(digests) != name:
        raise VersionError(
            f"{store / name} has been changed since it was written: remove it, and write or copy it again"
        )
    return VersionFiles(store / name, name, code)


@contextmanager
def _opened(name: str | Path, around: int | None, path: Path) -> Iterator[int]:
    """A file or folder, opened without following a link; it is the user's, and no other user may write it."""
    descriptor = os.open(name, _OPEN, dir_fd=around)
    try:
        found = os.fstat(descriptor)
        if found.st_uid != os.geteuid():
            raise VersionError(f"{path} belongs to another user ({found.st_uid})")
        if found.st_mode & (stat.S_IWGRP | stat.S_IWOTH):
            raise VersionError(f"{path} can be written by other users: run `chmod -R go-w` on it")
        yield descriptor
    finally:
        os.close(descriptor)


def _read(
    folder: int,
    inside: str,
    path: Path,
    digests: dict[str, bytes],
    code: dict[str, bytes],
    left: list[int],
) -> None:
    """Hash what is in an open folder; `left` is how many bytes and entries there may still be."""
    if inside.count("/") >= DEEPEST:
        raise VersionError(f"{path} is more than {DEEPEST} folders deep")
    with os.scandir(folder) as entries:
        names = sorted(entry.name for entry in entries)
    for name in names:
        left[1] -= 1
        if left[1] < 0:
            raise VersionError(f"a version has at most {MOST} files")
        with _opened(name, folder, path / name) as descriptor:
            kind = os.fstat(descriptor).st_mode
            if stat.S_ISDIR(kind):
                _read(descriptor, f"{inside}{name}/", path / name, digests, code, left)
            elif stat.S_ISREG(kind):
                digest = hashlib.sha256()
                keep = name.endswith(".py")
                kept: list[bytes] = []
                while piece := os.read(descriptor, 1 << 20):
                    left[0] -= len(piece)
                    if left[0] < 0:
                        raise VersionError(f"a version has at most {LARGEST >> 20} MB")
                    digest.update(piece)
                    if keep:
                        kept.append(piece)
                digests[f"{inside}{name}"] = digest.digest()
                if keep:
                    code[f"{inside}{name}"] = b"".join(kept)
            else:
                raise VersionError(f"{path / name} is not a regular file")


def check_place(folder: Path) -> None:
    """See that no other user can put another folder in the place of this one.

    Every folder around it must be the user's or root's. Other users may write in one only where they cannot
    rename files of others (the sticky bit of `/tmp`). A group may write if only the user is in it.

    Raises:
        VersionError: one is not like that.
    """
    if not IS_POSIX:  # a folder there has a list of who may do what, which it has from the folder around it
        return
    for around in folder.resolve().parents:
        try:
            found = around.stat()
        except OSError as problem:
            raise VersionError(f"{around} cannot be read: {_why(problem)}") from problem
        if found.st_uid not in (0, os.geteuid()):
            raise VersionError(
                f"{around} belongs to another user ({found.st_uid}), who could replace what is loaded from it"
            )
        by_others = found.st_mode & stat.S_IWOTH
        by_group = found.st_mode & stat.S_IWGRP and not _is_own_group(found.st_gid)
        if (by_others or by_group) and not found.st_mode & stat.S_ISVTX:
            raise VersionError(f"{around} can be written by other users: run `chmod go-w` on it")


def _is_own_group(group: int) -> bool:
    """Whether a group is the one that a user has alone, as most Linux systems make them."""
    import grp
    import pwd

    try:
        user = pwd.getpwuid(os.geteuid())
        found = grp.getgrgid(group)
    except KeyError:
        return False
    return group == user.pw_gid and found.gr_name == user.pw_name and not {*found.gr_mem} - {user.pw_name}


def _why(problem: OSError) -> str:
    place = f"{problem.filename}: " if problem.filename else ""
    return f"{place}{problem.strerror or problem}"


# ---- importing ---------------------------------------------------------------------------------------

_MARK = "asemec-version:"
_marked: dict[str, VersionFiles] = {}
_served: list[VersionFiles] = []
"""Whose packages are found by their own names just now; the last first."""


def _mark(files: VersionFiles) -> str:
    """What stands for the folder of a version in the `__path__` of its packages."""
    mark = f"{_MARK}{files.hash}"
    _marked[mark] = files
    if not any(isinstance(finder, _Finder) for finder in sys.meta_path):
        sys.meta_path.insert(0, _Finder())
    return mark


@contextmanager
def serving(files: VersionFiles | None) -> Iterator[None]:
    """Inside, the packages of a version are imported by their own names (`monas.Pair`)."""
    if files is None:
        yield
        return
    serve(files)
    try:
        yield
    finally:
        _served.remove(files)


def serve(files: VersionFiles) -> None:
    """From now on, the packages of a version are imported by their own names."""
    _mark(files)
    _served.insert(0, files)


class _Finder(MetaPathFinder):
    """Finds the modules of versions, and nothing on the disk under their packages."""

    def find_spec(
        self, fullname: str, path: Sequence[str] | None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        if path is None:
            found = (_spec(files, fullname, fullname) for files in _served if fullname != ACTIVITIES)
            return next((spec for spec in found if spec is not None), None)
        mark, _, folder = next(iter(path), "").partition("/")
        files = _marked.get(mark)
        if files is None:
            return None
        spec = _spec(files, fullname, f"{folder}/{fullname.rpartition('.')[2]}")
        if spec is None:  # the finders after this one would look on the disk
            raise ModuleNotFoundError(f"No module named {fullname!r} in {files.folder}", name=fullname)
        return spec


def _spec(files: VersionFiles, fullname: str, place: str) -> ModuleSpec | None:
    """Where a module is in a version; `place` is its path there, without its end."""
    package, module = f"{place}/__init__.py", f"{place}.py"
    if package in files.code or any(path.startswith(f"{place}/") for path in files.code):
        spec = ModuleSpec(fullname, _Loader(files, package), origin=str(files.folder / package))
        spec.submodule_search_locations = [f"{_mark(files)}/{place}"]
    elif module in files.code:
        spec = ModuleSpec(fullname, _Loader(files, module), origin=str(files.folder / module))
    else:
        return None
    spec.has_location = True
    return spec


class _Loader(ExecutionLoader):
    """Loads one module from the bytes that were hashed."""

    def __init__(self, files: VersionFiles, path: str) -> None:
        self.files = files
        self._path = path

    def get_filename(self, fullname: str) -> str:
        return str(self.files.folder / self._path)

    def get_source(self, fullname: str) -> str:
        from importlib.util import decode_source

        return decode_source(self.files.code.get(self._path, b""))

    def is_package(self, fullname: str) -> bool:
        return self._path.endswith("/__init__.py")


def version_of_module(name: str) -> VersionFiles | None:
    """The version from which a module was loaded, if it was one."""
    loader = getattr(sys.modules.get(name), "__loader__", None)
    return loader.files if isinstance(loader, _Loader) else None
