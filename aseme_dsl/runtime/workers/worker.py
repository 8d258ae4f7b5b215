"""A worker process: runs activities of kind `process`, one after the other, each on a snapshot."""

from __future__ import annotations

import contextlib
import importlib
import importlib.util
import os
import pickle
import signal
import sys
import threading
import time
from functools import cache
from pathlib import Path
from queue import SimpleQueue
from types import ModuleType
from typing import IO

from aseme_dsl.runtime.activity.activities import Executable
from aseme_dsl.runtime.activity.context import Cancelled, Context
from aseme_dsl.runtime.activity.returning import as_outcome, frames_of, reason_of
from aseme_dsl.runtime.activity.snapshot import Snapshot, SnapshotPort, Told
from aseme_dsl.runtime.time.clock import SECOND
from aseme_dsl.runtime.version.loading import know_as
from aseme_dsl.runtime.version.versions import VersionFiles, read_version, serve
from aseme_dsl.runtime.workers.descendants import adopt_descendants, kill_descendants
from aseme_dsl.runtime.workers.processes import get, put


class _Worker:
    def __init__(self, requests: IO[bytes], answers: IO[bytes]) -> None:
        self.requests = requests
        self.answers = answers
        self.parent = os.getppid()
        self.closed = False
        """Whether the other end has said that nothing more comes. It says nothing if it is killed."""
        self.jobs: SimpleQueue[bytes | None] = SimpleQueue()
        self.cancelled = threading.Event()
        self.kept: dict[str, Executable] = {}
        """What runs again and again: the object of a module, by who keeps it."""

    def listen(self) -> None:
        """Put jobs in order, and pass on a cancellation while one runs."""
        while (data := get(self.requests)) is not None:
            if data == _CANCEL:
                self.cancelled.set()
            elif data == _CLOSE:
                self.closed = True
            else:
                self.cancelled.clear()
                self.jobs.put(data)
        self.cancelled.set()
        self.jobs.put(None)
        time.sleep(_ORPHAN)  # no agent waits for an activity that still runs then
        self.end_descendants()
        os._exit(1)

    def end_descendants(self) -> None:
        """Kill the processes that activities have left, if our parent has ended and does so no more.

        Its pipes end before we have another parent: the parent alone does not tell.
        """
        if not self.closed or os.getppid() != self.parent:
            kill_descendants(lambda line: None)

    def work(self) -> None:
        """Run jobs until there are no more."""
        while (data := self.jobs.get()) is not None:
            kind: str | None = None
            reason, frames, result = "", None, None
            try:
                _, module, place, name, keep, snapshot = pickle.loads(data)
                code: Executable = self.kept.pop(keep) if keep in self.kept else _class(module, place, name)()
                result = self._run(code, snapshot)
                if keep:
                    self.kept = {keep: code}
            except BaseException as error:  # the agent must hear of each error
                kind, reason, frames = type(error).__name__, reason_of(error), frames_of(error)
            put(self.answers, ("end", kind, reason, frames, result))

    def _run(self, code: Executable, snapshot: Snapshot) -> str | None:
        begun = time.monotonic_ns()

        def tell(told: Told) -> None:
            put(self.answers, ("tell", told))

        def wait(duration: int) -> None:
            if self.cancelled.wait(duration / SECOND):
                raise Cancelled

        port = SnapshotPort(
            snapshot,
            tell,
            lambda: snapshot.now + time.monotonic_ns() - begun,
            wait,
            self.cancelled.is_set,
        )
        return as_outcome(code.execute(Context(port), **snapshot.arguments))


_ORPHAN = 2.0
"""How long, in seconds, an activity may still run after its agent process has ended."""
_CANCEL = pickle.dumps(("cancel",))
_CLOSE = pickle.dumps(("close",))


def _class(module: str, place: str | tuple[Path, str] | None, name: str) -> type[Executable]:
    """The class of an activity.

    A module that cannot be imported by its name is loaded from its file; one of a version, which is given as
    its folder and hash, only from there.
    """
    found: object = sys.modules.get(module)
    if found is None and isinstance(place, tuple):
        package = module.rpartition(".")[0]
        if package not in sys.modules:
            _version(*place).as_package(package)
        found = importlib.import_module(module)
    elif found is None and not isinstance(place, tuple):
        try:
            found = importlib.import_module(module)
        except ImportError:
            if place is None:
                raise
            found = _loaded(module, place)
    for part in name.split("."):
        found = getattr(found, part)
    assert isinstance(found, type)
    kind: type[Executable] = found
    return kind


@cache
def _version(folder: Path, name: str) -> VersionFiles:
    return read_version(folder.parent, name)


def _loaded(module: str, file: str) -> ModuleType:
    package, _, _ = module.rpartition(".")
    if package and package not in sys.modules:
        parent = ModuleType(package)
        parent.__path__ = [str(Path(file).parent)]
        sys.modules[package] = parent
    specification = importlib.util.spec_from_file_location(module, file)
    if specification is None or specification.loader is None:
        raise ImportError(f"{file} is not a module")
    loaded = importlib.util.module_from_spec(specification)
    sys.modules[module] = loaded
    specification.loader.exec_module(loaded)
    return loaded


def main() -> None:
    """Serve the process at the other end of standard input and output; what is printed goes to its errors.

    The arguments are:

    1. how many bytes of address space there are, or 0;
    2. the folder of the version whose packages are imported, or an empty text;
    3. other names of packages with messages (`monas=jade_like`), any number of them.
    """
    for number in (signal.SIGINT, signal.SIGTERM):  # the team gets the signal, and tells us
        signal.signal(number, signal.SIG_IGN)
    memory, version, *names = sys.argv[1:]
    if int(memory):
        try:
            import resource
        except ImportError:
            print("this system does not limit the memory of a process", file=sys.stderr)
        else:
            resource.setrlimit(resource.RLIMIT_AS, (int(memory), int(memory)))
    if version:
        folder = Path(version)
        serve(_version(folder, folder.name))
    if names:
        know_as(dict(name.split("=", 1) for name in names))
    requests = os.fdopen(os.dup(0), "rb")
    answers = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)
    with Path(os.devnull).open("rb") as nothing:
        os.dup2(nothing.fileno(), 0)
    worker = _Worker(requests, answers)
    adopt_descendants()
    threading.Thread(target=worker.listen, daemon=True).start()
    put(answers, ("begun",))
    with contextlib.suppress(BrokenPipeError):  # the agent process does not listen any more
        worker.work()
    worker.end_descendants()


if __name__ == "__main__":
    main()
