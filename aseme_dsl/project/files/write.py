"""Write: files into a folder, all or none, never over anything that is not ours."""

from __future__ import annotations

import contextlib
import errno
import glob
import os
import secrets
import signal
import stat
import threading
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import field
from importlib.util import cache_from_source
from pathlib import Path
from types import FrameType, MappingProxyType
from typing import TypeVarTuple

from aseme_dsl import outside
from aseme_dsl.diagnostics import Diagnostic, Problem
from aseme_dsl.diagnostics.problems import writing as problems
from aseme_dsl.diagnostics.problems.writing import Obstacle
from aseme_dsl.project.files.manifest import (
    NAME,
    DamagedManifest,
    Entry,
    Manifest,
    hash_of,
    is_inside,
    manifest_text,
    read_manifest,
    seen_from_here,
)
from aseme_dsl.project.files.stamp import Look, Stamp, stamp_of
from aseme_dsl.records import dataclass

_Ts = TypeVarTuple("_Ts")

STAGED = ".asemec-"
"""How the names of files begin that exist only while a build is being written."""


@dataclass(frozen=True, slots=True)
class Planned:
    """A file to write.

    `path` is relative to the output folder, with `/`. A file with a `home` is the user's once it is there.
    It is written to `home` if there is nothing yet, and never again. `path` is then only its name in the
    manifest.
    """

    path: str
    content: bytes
    part: str
    home: Path | None = None


@dataclass(frozen=True, slots=True)
class Written:
    """What became of the files: paths as the user knows them. With errors, nothing was changed at all."""

    created: tuple[Path, ...] = ()
    changed: tuple[Path, ...] = ()
    unchanged: tuple[Path, ...] = ()
    removed: tuple[Path, ...] = ()
    kept: tuple[Path, ...] = ()
    """Files of the user that were there and stay as they are."""
    manifest: Manifest = field(default_factory=Manifest)
    diagnostics: tuple[Diagnostic, ...] = ()


@dataclass(slots=True)
class Seen:
    """What a process has found of its own files when it wrote into a folder last, so as not to read it again.

    A file counts as seen as long as its stamp is the same: what `stat` says of its time, size and number.
    `look` gives the stamp of a file of the user; it may be one that was taken just before.
    """

    files: dict[str, tuple[Planned, Stamp, Path]] = field(default_factory=dict)
    manifest: tuple[Manifest, Stamp] | None = None
    look: Look = stamp_of


class Disk:
    """The few things that are done to a file system, so that a test can let each of them fail."""

    def create(self, path: Path, content: bytes, mode: int | None) -> None:
        """Write a new file, with the permissions given or the usual ones."""
        descriptor = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_BINARY", 0), 0o666)
        with os.fdopen(descriptor, "wb") as file:
            file.write(content)
        if mode is not None:
            path.chmod(mode)

    def rename(self, source: Path, target: Path) -> None:
        """Put a file in the place of another, in one instant."""
        source.replace(target)

    def link(self, target: Path, name: Path) -> None:
        """Give a file a second name."""
        name.hardlink_to(target)

    def remove(self, path: Path) -> None:
        """Remove a file, if it is there."""
        path.unlink(missing_ok=True)

    def make_folder(self, path: Path) -> None:
        """Make one folder; one that another process has just made is as good."""
        path.mkdir(exist_ok=True)

    def remove_folder(self, path: Path) -> None:
        """Remove a folder, if it is empty."""
        path.rmdir()


DISK = Disk()


def write(
    folder: Path,
    files: Iterable[Planned],
    *,
    parts: frozenset[str],
    system: str,
    source: str,
    certified: Mapping[str, str] = MappingProxyType({}),
    force: bool = False,
    replaces: bool = False,
    disk: Disk = DISK,
    seen: Seen | None = None,
) -> Written:
    """Make `parts` of an output folder consist of `files`: all of it happens, or nothing.

    Files that have their content already are not touched. Files of the `parts` that an earlier build wrote
    and that are no longer among `files` are removed. A file that was not written by a build, or was edited
    since, is an error (E009), or with `force` is overwritten; one that would be removed stays (W002).
    `system` and `source` (a file's name) say whose folder it is: another system's is an error, too,
    but if it `replaces` one to which the user has added nothing. `certified` is what was proved of each
    statechart.

    Everything is first written beside its target, then renamed. A failure on the way, or Ctrl-C, leaves what
    was there before and no temporary files; while files are being renamed, Ctrl-C waits. What was `seen` of
    the folder when the same process wrote into it last is not read again.
    """
    wanted = tuple(files)
    plan = _Plan(folder, force, seen or Seen(), replaces=replaces)
    plan.look(wanted, parts, system, source, certified)
    if plan.errors:
        return Written(diagnostics=tuple(plan.errors))
    try:
        _carry_out(plan, disk)
    except OSError as problem:
        return Written(diagnostics=(_failed(problem, folder),))
    if seen is not None:
        plan.remember(wanted)
    return Written(
        tuple(plan.created),
        tuple(plan.changed),
        tuple(plan.unchanged),
        tuple(plan.stale),
        tuple(plan.kept),
        plan.manifest,
        tuple(plan.warnings),
    )


def write_new(files: Mapping[Path, bytes], disk: Disk = DISK) -> Written:
    """Write files where there are none: all of them, or (E009) none if anything is in the way of one."""
    folder = Path(os.path.commonpath([path.parent for path in files])) if files else Path()
    plan = _Plan(folder, force=False)
    for path, content in files.items():
        if os.path.lexists(path):
            plan.in_the_way(path, Obstacle.EXISTS)
        else:
            plan.writes.append((path, content))
    if plan.errors:
        return Written(diagnostics=tuple(plan.errors))
    try:
        _carry_out(plan, disk)
    except OSError as problem:
        return Written(diagnostics=(_failed(problem, folder),))
    return Written(created=tuple(files))


def write_over(files: Mapping[Path, tuple[bytes, bytes]], disk: Disk = DISK) -> Written:
    """Change files of the user, each given as it was read and as it shall be: all of them, or none.

    A file that no longer is what was read is an error (E009). A link stays, and what it leads to is changed.
    """
    folder = Path(os.path.commonpath([path.parent.absolute() for path in files])) if files else Path()
    plan = _Plan(folder, force=False)
    for path, (before, after) in files.items():
        target = Path(os.path.realpath(path))
        if _is(target, before):
            plan.writes.append((target, after))
            if not os.access(target, os.W_OK):
                plan.in_the_way(path, Obstacle.READ_ONLY)
        else:
            plan.errors.append(_changed(path))
    if plan.errors:
        return Written(diagnostics=tuple(plan.errors))
    try:
        _carry_out(plan, disk)
    except OSError as problem:
        return Written(diagnostics=(_failed(problem, folder),))
    return Written(changed=tuple(files))


def write_file(path: Path, content: bytes, disk: Disk = DISK) -> Written:
    """Write one file that was named for it, over what is there: the whole of it at once, or (E009) nothing.

    A file that holds the content already is left as it is.
    A link stays, and what it leads to is written; so does a device or a pipe, which takes the content.
    """
    plan = _Plan(path.parent, force=True)
    existed = os.path.lexists(path)
    if path.is_dir():
        plan.in_the_way(path, Obstacle.FOLDER)
        return Written(diagnostics=tuple(plan.errors))
    if path.is_file() and _is(path, content):
        return Written(unchanged=(path,))
    plan.writes.append((Path(os.path.realpath(path)), content))
    try:
        if path.exists() and not path.is_file():
            path.write_bytes(content)
        else:
            _carry_out(plan, disk)
    except OSError as problem:
        return Written(diagnostics=(_failed(problem, path),))
    return Written(changed=(path,)) if existed else Written(created=(path,))


def check_room(path: Path, disk: Disk = DISK) -> tuple[Diagnostic, ...]:
    """Why `write_file` could not write that file, found by trying beside it; nothing is left of that."""
    plan = _Plan(path.parent, force=True)
    if path.is_dir():
        plan.in_the_way(path, Obstacle.FOLDER)
        return tuple(plan.errors)
    if path.exists() and not path.is_file():
        return ()
    target = Path(os.path.realpath(path))
    trial = target.with_name(f"{STAGED}{secrets.token_hex(4)}.new")
    folders: list[Path] = []
    try:
        _make_folders(target.parent, folders, disk)
        disk.create(trial, b"", None)
    except OSError as problem:
        return (_failed(problem, path),)
    finally:
        with _uninterrupted():
            _fails(disk.remove, trial)
            for folder in reversed(folders):
                _fails(disk.remove_folder, folder)
    return ()


def _is(path: Path, content: bytes) -> bool:
    try:
        return outside.holds(path, content)
    except OSError:
        return False


def _changed(path: Path) -> Diagnostic:
    return Diagnostic(problems.ChangedMeanwhile(str(path)), None, path=str(path))


def _is_all_generated(folder: Path, before: Manifest) -> bool:
    """Whether a build holds no code of the user's, nor a first version of it."""
    return not before.started and not any(folder.glob("*/activities/*.py"))


@dataclass(slots=True)
class _Plan:
    """What is to be done, decided before anything is done."""

    folder: Path
    force: bool
    seen: Seen = field(default_factory=Seen)
    replaces: bool = False
    manifest: Manifest = field(default_factory=Manifest)
    writes: list[tuple[Path, bytes]] = field(default_factory=list)
    created: list[Path] = field(default_factory=list)
    changed: list[Path] = field(default_factory=list)
    unchanged: list[Path] = field(default_factory=list)
    kept: list[Path] = field(default_factory=list)
    stale: list[Path] = field(default_factory=list)
    errors: list[Diagnostic] = field(default_factory=list)
    warnings: list[Diagnostic] = field(default_factory=list)

    def look(
        self,
        files: Sequence[Planned],
        parts: frozenset[str],
        system: str,
        source: str,
        certified: Mapping[str, str],
    ) -> None:
        """Compare what is wanted with what is there."""
        before = self._manifest(system, source)
        if before is None:
            return
        other_system = before.system not in (None, system)
        self._check_paths(files)
        if self.errors:
            return
        entries = {p: e for p, e in before.files.items() if e.part not in parts and not other_system}
        started = dict(before.started)
        for file in files:
            if file.home is not None:
                self._look_at_kept(file, file.home, started)
                continue
            known = before.files.get(file.path)
            place = self._seen_at(file) if known is not None else None
            if known is not None and place is not None:
                self.unchanged.append(place)
                entries[file.path] = known
            else:
                self._look_at_generated(file, known)
                entries[file.path] = Entry(file.part, hash_of(file.content))
        self._look_at_stale({p: e for p, e in before.files.items() if p not in entries})
        proved = MappingProxyType(dict(certified))
        self.manifest = Manifest(system, source, MappingProxyType(entries), MappingProxyType(started), proved)
        if self.manifest != before or self.seen.manifest is None:
            self._write(self.folder / NAME, manifest_text(self.manifest).encode(), listed=False)

    def remember(self, files: Iterable[Planned]) -> None:
        """Keep in mind how everything is now."""
        found: dict[str, tuple[Planned, Stamp, Path]] = {}
        for file in files:
            if file.home is not None:
                continue
            before = self.seen.files.get(file.path)
            if before is not None and before[0] is file:
                found[file.path] = before
                continue
            place = self.folder / file.path
            stamp = stamp_of(place)
            if stamp is not None:
                found[file.path] = (file, stamp, place)
        self.seen.files = found
        stamp = stamp_of(self.folder / NAME)
        self.seen.manifest = None if stamp is None else (self.manifest, stamp)

    def _seen_at(self, file: Planned) -> Path | None:
        """The path of a file that was written, or found to be the same, and has not changed since."""
        known = self.seen.files.get(file.path)
        if known is None or known[0] is not file:
            return None
        if known[1] == stamp_of(known[2]):
            return known[2]
        del self.seen.files[file.path]
        return None

    def _manifest(self, system: str, source: str) -> Manifest | None:
        """The manifest of earlier builds, or None with an error."""
        there = next((path for path in (self.folder, *self.folder.parents) if os.path.lexists(path)), None)
        if there is not None and not there.is_dir():
            self.in_the_way(there, Obstacle.NO_FOLDER)
            return None
        known = self.seen.manifest
        if known is not None and known[1] != stamp_of(self.folder / NAME):
            known = self.seen.manifest = None
        try:
            before = read_manifest(self.folder) if known is None else known[0]
        except OSError as problem:
            self._not_read(self.folder / NAME, problem)
            return None
        except DamagedManifest as problem:
            if self.force:
                return Manifest()
            place = self.folder / NAME
            self.refuse(place, problems.DamagedList(str(place), str(problem)))
            return None
        is_other = before.system not in (None, system) and before.source != source
        if is_other and not self.force and not (self.replaces and _is_all_generated(self.folder, before)):
            known_source = None if before.source is None else str(seen_from_here(self.folder, before.source))
            self.refuse(self.folder, problems.OtherBuild(str(self.folder), str(before.system), known_source))
            return None
        return before

    def _check_paths(self, files: Sequence[Planned]) -> None:
        """No file may leave the folder, and no two may have one place."""
        seen: dict[str, Planned] = {}
        for file in files:
            place = file.path if file.home is None else str(file.home)
            if file.home is None and (not is_inside(file.path) or file.path == NAME):
                self.in_the_way(self.folder / file.path, Obstacle.NO_PLACE)
            elif place in seen and seen[place].content != file.content:
                self.in_the_way(Path(place), Obstacle.TWICE)
            seen[place] = file

    def _look_at_kept(self, file: Planned, home: Path, started: dict[str, str]) -> None:
        if self.seen.look(str(home)) is not None or os.path.lexists(home):
            self.kept.append(home)
        elif home not in self.created:
            self._write(home, file.content)
            started[file.path] = hash_of(file.content)

    def _look_at_generated(self, file: Planned, known: Entry | None) -> None:
        target = self.folder / file.path
        present = self._content(target)
        if present is None or present == file.content:
            if present is None and target not in self.created:
                self._write(target, file.content)
            elif present is not None:
                self.unchanged.append(target)
            return
        ours = known is not None and known.hash == hash_of(present) and not target.is_symlink()
        if not ours and not self.force:
            kind = problems.NotGenerated if known is None else problems.EditedSinceGenerated
            self.refuse(target, kind(str(target)))
        elif not os.access(target, os.W_OK):
            self.in_the_way(target, Obstacle.READ_ONLY)
        else:
            self._write(target, file.content)

    def _look_at_stale(self, entries: Mapping[str, Entry]) -> None:
        for path, entry in sorted(entries.items()):
            target = self.folder / path
            present = self._content(target)
            if present is None:
                continue
            if hash_of(present) == entry.hash and not target.is_symlink():
                self.stale.append(target)
            else:
                problem = problems.EditedButObsolete(str(target))
                self.warnings.append(Diagnostic(problem, None, path=str(target)))

    def _content(self, target: Path) -> bytes | None:
        """The content of a file; None if there is none. A path that is not a readable file is an error."""
        try:
            return outside.read_bytes(target)
        except FileNotFoundError:
            if not target.is_symlink():
                return None
            self.in_the_way(target, Obstacle.DEAD_LINK)
        except IsADirectoryError:
            self.in_the_way(target, Obstacle.FOLDER)
        except NotADirectoryError:
            self.in_the_way(target, Obstacle.FILE_ABOVE)
        except OSError as problem:
            self._not_read(target, problem)
        return None

    def _write(self, target: Path, content: bytes, *, listed: bool = True) -> None:
        try:
            present = outside.read_bytes(target) if target.exists() else None
        except OSError:
            present = None
        if present == content:
            return
        self.writes.append((target, content))
        if listed:
            (self.created if present is None else self.changed).append(target)

    def refuse(self, path: Path, problem: Problem) -> None:
        """Note why nothing can be written."""
        self.errors.append(Diagnostic(problem, None, path=str(path)))

    def in_the_way(self, path: Path, obstacle: Obstacle) -> None:
        self.refuse(path, problems.InTheWay(str(path), obstacle))

    def _not_read(self, path: Path, problem: OSError) -> None:
        reason = problem.strerror or str(problem)
        self.refuse(path, problems.NotReadBeforeWriting(str(path), reason))


def _carry_out(plan: _Plan, disk: Disk) -> None:
    """Stage everything, then put it in place.

    Raises:
        OSError: something failed; everything is as it was before.
    """
    if not plan.writes and not plan.stale:
        return
    token = secrets.token_hex(4)
    staged: list[tuple[Path, Path]] = []
    folders: list[Path] = []
    try:
        for number, (target, content) in enumerate(plan.writes):
            _make_folders(target.parent, folders, disk)
            temporary = target.with_name(f"{STAGED}{token}-{number}.new")
            staged.append((temporary, target))
            disk.create(temporary, content, mode_of(target))
        with _uninterrupted():
            _commit(staged, plan.stale, token, disk)
    except BaseException:
        with _uninterrupted():
            for temporary, _ in staged:
                _fails(disk.remove, temporary)
            for folder in reversed(folders):
                _fails(disk.remove_folder, folder)
        raise
    _remove_empty_folders(plan, disk)


def _commit(staged: Sequence[tuple[Path, Path]], stale: Sequence[Path], token: str, disk: Disk) -> None:
    """Rename every staged file to its target and remove what is stale, or undo what was done of it."""
    undo: list[tuple[Path, Path | None]] = []
    try:
        for number, (temporary, target) in enumerate(staged):
            backup = None
            if os.path.lexists(target):
                backup = target.with_name(f"{STAGED}{token}-{number}.old")
                undo.append((target, backup))
                try:
                    disk.link(target, backup)
                except OSError:  # a file system without second names
                    disk.rename(target, backup)
            else:
                undo.append((target, None))
            disk.rename(temporary, target)
        for number, target in enumerate(stale, len(staged)):
            backup = target.with_name(f"{STAGED}{token}-{number}.old")
            undo.append((target, backup))
            disk.rename(target, backup)
    except BaseException:
        for target, backup in reversed(undo):
            if backup is None:
                _fails(disk.remove, target)
            elif os.path.lexists(backup) and not _fails(disk.rename, backup, target):
                # Renaming one name of a file to another name of it does nothing at all.
                _fails(disk.remove, backup)
        raise
    for _, backup in undo:
        if backup is not None:
            _fails(disk.remove, backup)
    for _, target in staged:
        if target.suffix == ".py":
            _forget_compiled(target, disk)


def _forget_compiled(module: Path, disk: Disk) -> None:
    """Remove what Python keeps of a module: it goes by the second and the size, and might run the old one."""
    with contextlib.suppress(NotImplementedError):  # a Python that keeps nothing
        kept = Path(cache_from_source(str(module))).parent
        for path in kept.glob(f"{glob.escape(module.stem)}.*.pyc"):
            _fails(disk.remove, path)


def _make_folders(folder: Path, made: list[Path], disk: Disk) -> None:
    missing: list[Path] = []
    while not folder.is_dir():
        missing.append(folder)
        if folder.parent == folder:
            break
        folder = folder.parent
    for path in reversed(missing):
        if os.path.lexists(path):
            raise NotADirectoryError(errno.ENOTDIR, os.strerror(errno.ENOTDIR), str(path))
        made.append(path)
        disk.make_folder(path)


def _remove_empty_folders(plan: _Plan, disk: Disk) -> None:
    """The folders that held only what was removed, up to the output folder."""
    for target in plan.stale:
        folder = target.parent
        while folder != plan.folder and not _fails(disk.remove_folder, folder):
            folder = folder.parent


def _fails(action: Callable[[*_Ts], None], *arguments: *_Ts) -> bool:
    """Do it as well as it goes; whether it failed. Used where there is nothing more to be done about it."""
    try:
        action(*arguments)
    except OSError:
        return True
    return False


def mode_of(target: Path) -> int | None:
    """The permissions of what is being replaced."""
    try:
        return stat.S_IMODE(target.stat().st_mode)
    except OSError:
        return None


def _failed(problem: OSError, folder: Path) -> Diagnostic:
    path = str(problem.filename2 or problem.filename or folder)
    if Path(path).name.startswith(STAGED):
        path = str(Path(path).parent)
    found = problems.CannotBeWritten(path, problem.strerror or str(problem))
    return Diagnostic(found, None, path=path)


@contextlib.contextmanager
def _uninterrupted() -> Iterator[None]:
    """Inside, Ctrl-C and termination wait; they count when it is over."""
    if threading.current_thread() is not threading.main_thread():
        yield  # signals are delivered to the main thread only
        return
    waiting: list[tuple[int, FrameType | None]] = []

    def wait(number: int, frame: FrameType | None) -> None:
        waiting.append((number, frame))

    before = {}
    for number in (signal.SIGINT, signal.SIGTERM):
        handler = signal.getsignal(number)
        if handler is not None:  # None: code outside Python has set it
            before[number] = handler
    try:
        for number in before:
            signal.signal(number, wait)
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
    if waiting:
        signal.raise_signal(waiting[0][0])
