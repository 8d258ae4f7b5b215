"""Processes: resident worker processes for activities of kind `process`; `worker.py` is their other end.

Both exchange pickled tuples, each after four bytes with its length: over the worker's standard input and what
was its standard output when it started.
"""

# concurrent.futures and loky cannot cancel what runs, and kill the workers of all activities together.

from __future__ import annotations

import contextlib
import os
import pickle
import signal
import subprocess
import sys
import threading
from collections import deque
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from queue import SimpleQueue
from typing import IO, TYPE_CHECKING

from aseme_dsl.runtime.activity.context import Cancelled
from aseme_dsl.runtime.activity.returning import reason_of
from aseme_dsl.runtime.activity.snapshot import Snapshot, snapshot_of, tell
from aseme_dsl.runtime.ports import Complain
from aseme_dsl.runtime.version.versions import VersionFiles, version_of_module

if TYPE_CHECKING:
    from aseme_dsl.runtime.activity.execution import Execution


_Job = tuple["Execution", Snapshot]


class ReportedError(Exception):
    """What an activity has raised in another process: its text is the whole reason."""

    def __init__(self, reason: str, frames: list[dict[str, object]] | None = None) -> None:
        super().__init__(reason)
        self.frames = frames


def put(file: IO[bytes], item: tuple[object, ...]) -> None:
    """Send an item. Raises what pickling raises, and OSError."""
    data = pickle.dumps(item)
    file.write(len(data).to_bytes(4, "big") + data)
    file.flush()


def get(file: IO[bytes]) -> bytes | None:
    """The next item, still pickled, or None at the end."""
    head = file.read(4)
    if len(head) < 4:
        return None
    data = file.read(int.from_bytes(head, "big"))
    return data


class _Process:
    """One worker process and the thread that communicates with it, so that no step waits for a pipe."""

    def __init__(self, pool: Processes) -> None:
        self.pool = pool
        self.execution: Execution | None = None
        self.jobs: SimpleQueue[_Job | None] = SimpleQueue()
        self.child: subprocess.Popen[bytes] | None = None
        self.is_free = True
        """Whether it has nothing to run, though its thread may still be telling what became of the last."""
        self.listens = False
        """Whether the worker has begun, which takes a new one a while."""
        self.killed = ""
        """Why the worker was killed, while the activity has not been told."""
        self._sending = threading.Lock()
        self._turning = threading.Lock()
        """Held while it is said what runs, and while that is killed: what follows must not be."""
        self.thread = threading.Thread(target=self._work, name="aseme process", daemon=True)
        self.thread.start()

    def give(self, job: _Job) -> None:
        """Have it run something; it is free."""
        self.is_free = False
        job[0].handle = self
        self.jobs.put(job)

    def cancel(self, execution: Execution) -> None:
        """Tell an activity, if it is the one that runs, that it is cancelled.

        A thread that sends just now looks for that afterwards; none waits for a worker that does not listen.
        """
        if self._sending.acquire(blocking=False):
            with contextlib.suppress(OSError):  # the worker has ended, which its thread will see
                if self.execution is execution:
                    self._put(("cancel",))
            self._sending.release()

    def kill(self, execution: Execution, reason: str) -> bool:
        """End the worker, if it still runs this; the next activity has a new one."""
        with self._turning:
            if self.execution is not execution:
                return False
            self.killed = reason
            child = self.child
            if child is not None:
                child.kill()
        return True

    def _work(self) -> None:
        job = self.jobs.get()
        while job is not None:
            execution, snapshot = job
            with self._turning:
                self.killed = ""
                self.execution = execution
            error = self._run(execution, snapshot)
            with self._sending, self._turning:  # from here on it is too late to cancel or kill it
                self.execution = None
            # A worker that was killed may take a moment to die.
            if self.child is not None and (self.killed or self.child.poll() is not None or _is_spent(error)):
                self._end()
            self.is_free = True
            execution.returned(error)
            self.pool.ended(execution)
            job = self.pool.next_for(self)
        self._end()

    def _run(self, execution: Execution, snapshot: Snapshot) -> BaseException | None:
        """Have an activity run to its end; with which error, if any."""
        code = execution.code
        assert code is not None
        if self.child is not None and self.child.poll() is not None:
            self._end()  # it was killed while it was idle
        try:
            child = self.child or self._start()
            file = getattr(sys.modules.get(code.__module__), "__file__", None)
            version = version_of_module(code.__module__)
            name: str = getattr(code, "__qualname__", "")
            place = file if version is None else (version.folder, version.hash)
            with self._sending:
                self._put(("run", code.__module__, place, name, execution.keeps, snapshot))
        except BrokenPipeError:
            return self._ended()
        except Exception as error:  # what cannot be pickled, a worker that cannot start
            return ReportedError(f"it cannot be started in another process: {reason_of(error)}")
        if execution.cancelled:  # a cancellation before that would have been forgotten
            self.cancel(execution)
        refused: Exception | None = None
        assert child.stdout is not None
        while (data := get(child.stdout)) is not None:
            try:
                kind, *rest = pickle.loads(data)
                if kind == "end":
                    *raised, execution.result = rest
                    return refused or _error_of(*raised)
                if kind == "begun":
                    self.listens = True
                elif refused is None:
                    tell(execution, rest[0])
            except Exception as error:  # what the activity would have got, had it been here
                refused = error
                self.cancel(execution)
        return self._ended()

    def _ended(self) -> ReportedError:
        """How the worker has come to its end, in the midst of an activity."""
        if self.killed:
            return ReportedError(self.killed)
        assert self.child is not None
        code = self.child.wait()
        if code >= 0:
            return ReportedError(f"its process has ended with code {code}")
        try:
            name = signal.Signals(-code).name
        except ValueError:
            name = f"signal {-code}"
        return ReportedError(f"its process was killed by {name}")

    def _start(self) -> subprocess.Popen[bytes]:
        # What this process can import, the worker can, too, whether this package is installed or not.
        found = [*map(str, self.pool.path), *(entry or str(Path.cwd()) for entry in sys.path)]
        environment = {**os.environ, "PYTHONPATH": os.pathsep.join(dict.fromkeys(found))}
        self.listens = False
        version = self.pool.code
        command = [sys.executable, "-m", "aseme_dsl.runtime.workers.worker", str(self.pool.memory or 0)]
        command.append(str(version.folder) if version is not None else "")
        command += [f"{name}={other}" for name, other in self.pool.names.items()]
        child = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, env=environment)
        self.child = child
        if self.killed:  # meanwhile
            child.kill()
        return child

    def _put(self, item: tuple[object, ...]) -> None:
        child = self.child
        if child is not None and child.stdin is not None:
            put(child.stdin, item)

    def _end(self) -> None:
        """End the worker, by force if it does not by itself."""
        if self.child is None:
            return
        with contextlib.suppress(OSError):  # it has ended
            self._put(("close",))
        child, self.child = self.child, None
        for pipe in (child.stdin, child.stdout):
            if pipe is not None:
                with contextlib.suppress(OSError):  # what was not sent yet cannot be sent any more
                    pipe.close()
        try:
            child.wait(_LEAVE)
        except subprocess.TimeoutExpired:
            child.kill()
            child.wait()


_LEAVE = 0.3
"""How long, in seconds, an idle worker may take to end."""


def _is_spent(error: BaseException | None) -> bool:
    """Whether a worker is not to be used again: its memory is full."""
    return isinstance(error, ReportedError) and str(error).startswith("MemoryError")


def _error_of(kind: str | None, reason: str, frames: list[dict[str, object]] | None) -> BaseException | None:
    if kind is None:
        return None
    return Cancelled() if kind == "Cancelled" else ReportedError(reason, frames)


class Processes:
    """Resident worker processes: as many as activities have run in them at once, up to a maximum."""

    def __init__(
        self,
        path: Sequence[Path],
        maximum: int,
        memory: int | None,
        ended: Callable[[Execution], None],
        complain: Complain,
        names: Mapping[str, str] | None = None,
        code: VersionFiles | None = None,
    ) -> None:
        """`memory` is the address space that each may use, in bytes; `names` are other names of packages;
        `code` is the version whose packages are imported."""
        self.path = tuple(path)
        self.names = dict(names or {})
        self.code = code
        self.memory = memory
        self.ended = ended
        self._maximum = maximum
        self._complain = complain
        self._lock = threading.Lock()
        self._all: list[_Process] = []
        self._idle: list[_Process] = []
        self._kept: dict[str, _Process] = {}
        self._waiting: deque[_Job] = deque()
        self._was_full = False
        self._looked: _Job | None = None
        self._closed = False
        self._retired: list[_Process] = []

    def launch(self, execution: Execution) -> None:
        """Run the code of an activity in a worker. Called while its agent is guarded."""
        job = execution, snapshot_of(execution)
        tell = False
        with self._lock:
            owner = execution.keeps.partition("#")[0]
            process = self._kept.get(owner)
            if process is None:
                process = self._idle.pop() if self._idle and not owner else None
                if process is None and not owner and self._soon():
                    self._waiting.append(job)
                    return
                if process is None and (owner or len(self._all) < self._maximum):
                    process = _Process(self)
                    if owner:
                        self._kept[owner] = process
                    else:
                        self._all.append(process)
            if process is None:
                self._waiting.append(job)
                tell, self._was_full = not self._was_full, True
            else:
                process.give(job)
        if tell:
            self._complain(
                f"all {len(self._all)} processes for activities are busy: {execution.activity} and others "
                "wait until one is free",
                execution.agent,
                execution.activity,
            )

    def _soon(self) -> bool:
        """Whether a worker is about to be free that nothing waits for yet."""
        return sum(process.is_free for process in self._all) > len(self._waiting)

    def look(self) -> None:
        """Called now and then: what has waited since the last time, in vain, gets a worker of its own."""
        with self._lock:
            first = self._waiting[0] if self._waiting else None
            late = first is not None and first is self._looked
            self._looked = first
            if late and len(self._all) < self._maximum and not self._closed:
                process = _Process(self)
                self._all.append(process)
                process.give(self._waiting.popleft())

    def next_for(self, process: _Process) -> _Job | None:
        """What a worker whose activity has returned runs next."""
        with self._lock:
            if self._closed or process in self._retired:
                return None
            if process in self._all:
                if self._waiting:
                    job = self._waiting.popleft()
                    process.is_free = False
                    job[0].handle = process
                    return job
                self._idle.append(process)
        return process.jobs.get()

    def cancel(self, execution: Execution) -> None:
        """Tell an activity that its state was left."""
        process = _process_of(execution)
        if process is None:
            with self._lock:
                job = next((job for job in self._waiting if job[0] is execution), None)
                if job is not None:
                    self._waiting.remove(job)
                process = _process_of(execution)
            if job is not None:
                execution.returned(Cancelled())
                self.ended(execution)
        if process is not None:
            process.cancel(execution)

    def kill(self, execution: Execution, reason: str) -> bool:
        """End an activity that does not listen, with its process; not one that cannot have heard yet."""
        process = _process_of(execution)
        return process is not None and process.listens and process.kill(execution, reason)

    def renew(self, path: Sequence[Path], names: Mapping[str, str], code: VersionFiles | None) -> None:
        """From now on workers import from here: those that there are end when they have done what they do."""
        with self._lock:
            self.path = tuple(path)
            self.names = dict(names)
            self.code = code
            self._retired += [*self._all, *self._kept.values()]
            idle = [process for process in self._retired if process.execution is None]
            self._all.clear()
            self._idle.clear()
            self._kept.clear()
        for process in idle:
            process.jobs.put(None)

    def close(self) -> None:
        """End all workers, by force those that are busy."""
        with self._lock:
            self._closed = True
            everyone = [*self._all, *self._kept.values(), *self._retired]
        for process in everyone:
            execution = process.execution
            if execution is not None:
                process.kill(execution, "its process was killed: the run is over")
            process.jobs.put(None)

    def join(self, seconds: Callable[[], float]) -> None:
        """Wait for all workers to end, so many seconds at the most."""
        for process in (*self._all, *self._kept.values(), *self._retired):
            process.thread.join(seconds())


def _process_of(execution: Execution) -> _Process | None:
    """The process in which an activity runs; None while it waits for one."""
    handle = execution.handle
    assert handle is None or isinstance(handle, _Process)
    return handle
