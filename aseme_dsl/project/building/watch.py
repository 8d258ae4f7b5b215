"""Watch: which files a command depends on, and which of them have changed since it looked at them last.

The watch looks at the time, size and number of files, again and again. So it sees the changes of any editor,
on any file system and in any container. An editor may even write a new file with the old one's name.
It measures the cost, and takes no more than a hundredth of a processor. It always looks at the files that are
edited most, and each time at some of the others.
"""

# watchfiles sees a change 40 ms sooner where inotify works. It refuses files that do not exist yet, sees
# nothing on network drives, and polls three times as slowly: this would have to stay beside it.

from __future__ import annotations

import glob
import os
import time
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import field
from pathlib import Path
from typing import TYPE_CHECKING

from aseme_dsl.project.building.project import Compiled, code_folder, path_of
from aseme_dsl.project.code.activity_code import code_files
from aseme_dsl.project.code.function_code import function_files
from aseme_dsl.project.files.inputs import is_searched
from aseme_dsl.project.files.manifest import NAME as MANIFEST
from aseme_dsl.project.files.stamp import CLOCK, Stamp, stamp_of
from aseme_dsl.project.settings.configuration import FILE
from aseme_dsl.records import dataclass

if TYPE_CHECKING:
    from aseme_dsl.project.building.workshop import Workshop

_INTERVAL = 0.04
"""How long to wait at least between two looks, in s: too short for a user to notice."""
_SHARE = 100
"""Looking may take one part in so many of the time."""
_FEWEST = 8
"""How many of the files that are edited rarely are looked at each time at least."""
_EDITED = 20
"""How many of them are looked at each time because they were changed last."""
_SETTLED = 0.015
"""For how long nothing may have changed before it counts, in s: editors write in several steps."""
_PATIENCE = 1.0
"""How long is waited for that at most, in s."""

_UNKNOWN = (0, 0, 0)
"""The stamp of a file that may have changed since it was read: the next look sees to it."""

Stamps = Mapping[str, Stamp | None]
"""What each path was when it was looked at; None where there was nothing."""


@dataclass(frozen=True, slots=True)
class Changes:
    """What has happened to files since the look before, by the paths that people know."""

    changed: tuple[str, ...] = ()
    created: tuple[str, ...] = ()
    deleted: tuple[str, ...] = ()

    @property
    def all(self) -> tuple[str, ...]:
        return (*self.changed, *self.created, *self.deleted)


@dataclass(slots=True)
class Watch:
    """The paths that a command depends on, each as it was before the command read it."""

    _stamps: dict[str, Stamp | None] = field(default_factory=dict)
    _often: list[str] = field(default_factory=list)
    _rarely: list[str] = field(default_factory=list)
    _next: int = 0  # of those
    _edited: list[str] = field(default_factory=list)  # of those that need not be looked at often
    _cost: float = 4e-6  # of looking at one, in s: what is usual, until it is known
    _begun: int = 0
    _is_new: bool = False  # whether everything has been looked at since the command did something

    def begin(self) -> Stamps:
        """The command is about to read its files, which are what is returned, as far as they are known."""
        if not self._is_new:
            self._look()
        self._is_new = False
        return self._stamps

    def depend(
        self, paths: Iterable[str], written: Iterable[Path] = (), rarely: Collection[str] = frozenset()
    ) -> None:
        """The command has read these; all others are left out. Those that change `rarely` may wait a second.

        The files that it has written itself (and the folders around them) count as they are now. So do new
        paths, unless they may have changed since the command read them.
        """
        own = {str(item) for path in written for item in (path, path.parent)}
        known, self._stamps = self._stamps, {}
        for path in paths:
            if path in known and path not in own:
                self._stamps[path] = known[path]
                continue
            stamp = stamp_of(path)
            is_late = stamp is not None and stamp[0] >= self._begun and path not in own
            self._stamps[path] = _UNKNOWN if is_late else stamp
        self._edited = [path for path in self._edited if path in self._stamps][-_EDITED:]
        often = {*self._edited, *(path for path in self._stamps if path not in rarely)}
        self._often = [path for path in self._stamps if path in often]
        self._rarely = [path for path in self._stamps if path not in often]

    def wait(self, until: Callable[[], bool] = lambda: False) -> Changes | None:
        """Wait for a change, and until nothing more changes; None as soon as `until` says so."""
        while not until():
            always = len(self._often) * self._cost
            pause = max(_INTERVAL, _SHARE * always)
            time.sleep(pause)
            number = max(_FEWEST, int((pause / _SHARE - always) / self._cost))
            some = self._rarely[self._next : self._next + number]
            self._next = self._next + number if some else 0
            if any(stamp_of(path) != self._stamps[path] for path in (*self._often, *some)):
                return self._settled()
        return None

    def _settled(self) -> Changes:
        before = self._stamps
        end = time.monotonic() + _PATIENCE
        while True:
            self._look()
            changed = [path for path, stamp in self._stamps.items() if stamp is not before[path]]
            if time.monotonic() >= end:
                break
            time.sleep(_SETTLED)
            if all(stamp_of(path) == self._stamps[path] for path in (*self._often, *changed)):
                break
        self._edited += [path for path in changed if path not in self._edited]
        self._is_new = True
        return _changes(before, self._stamps)

    def _look(self) -> None:
        """Look at everything. What is as it was keeps its stamp: that very object."""
        self._begun = time.time_ns() - CLOCK
        begun = time.thread_time()
        found: dict[str, Stamp | None] = {}
        for path, known in self._stamps.items():
            stamp = stamp_of(path)
            found[path] = known if stamp == known else stamp
        self._stamps = found
        if found:
            self._cost = max(1e-6, (time.thread_time() - begun) / len(found))


def _changes(before: Stamps, now: Stamps) -> Changes:
    different = [path for path in now if before[path] != now[path]]
    files = [path for path in different if not Path(path).is_dir()] or different
    once: dict[str, str] = {}
    for path in sorted(map(_shown, files), key=len):
        once.setdefault(os.path.realpath(path), path)
    kinds: dict[bool | None, list[str]] = {True: [], False: [], None: []}
    for path in files:
        if _shown(path) in once.values():
            kind = None if now[path] is None else before[path] is not None
            if _shown(path) not in kinds[kind]:
                kinds[kind].append(_shown(path))
    return Changes(*(tuple(sorted(kinds[kind])) for kind in (True, False, None)))


def watched(
    arguments: Sequence[str],
    compiled: Iterable[Compiled],
    activities: Path | None,
    templates: Path | None,
    workshop: Workshop,
) -> tuple[set[str], set[str]]:
    """The paths on which the output of a command depends; second, those of them with code of activities.

    A path need not exist. The files with code are many, of which few are ever edited. The files are: those
    that were read or looked for, the configuration, the Python of activities and modules, .proto files behind
    others, and templates. The folders are those in which a new file would count.
    """
    found: set[str] = set()
    code_found: set[str] = set()
    folders: set[str] = set()
    folders_around = {Path().absolute()}
    for argument in arguments or (".",):
        folders |= _folders(argument)
    for item in compiled:
        root = path_of(item.root)
        found |= {root, *item.depends}
        for path in item.depends:
            if path.endswith(".proto"):
                from aseme_dsl.interop.proto import files_behind

                found |= {str(other) for other in files_behind(Path(path))}
        folders_around.add(Path(root).parent.absolute())
        if item.system is not None:
            code_found.update(function_files(item.system, item.configuration.folder))
        code = code_folder(item.configuration, activities)
        if code is not None:
            folders.add(str(code))
            if item.system is not None:
                memory = workshop.about(root).code
                code_found.update(code_files(item.system, code, item.configuration.folder, memory))
            else:
                code_found |= {str(path) for path in code.glob("*.py")}
        own = templates or item.configuration.templates
        if own is not None:
            folders |= {str(own), *(str(path) for path in own.rglob("*"))}
    found |= {str(folder / FILE) for around in folders_around for folder in (around, *around.parents)}
    return found | folders | code_found, code_found


def _folders(argument: str) -> set[str]:
    """The folders in which a new file would be meant by an argument; what is built is not among them."""
    if glob.has_magic(argument):
        parts = Path(argument).parts
        fixed = next(number for number, part in enumerate(parts) if glob.has_magic(part))
        argument = str(Path(*parts[:fixed]))
    if not Path(argument).is_dir():
        return set()
    found: set[str] = set()
    for folder, inner, _ in os.walk(argument):
        inner[:] = [name for name in inner if is_searched(Path(folder, name))]
        inner[:] = [name for name in inner if not Path(folder, name, MANIFEST).exists()]
        found.add(folder)
    return found


def _shown(path: Path | str) -> str:
    """A path as seen from here, if it is below."""
    here = Path().absolute()
    return str(Path(path).relative_to(here)) if Path(path).is_relative_to(here) else str(path)


__all__ = ["Changes", "Watch", "watched"]
