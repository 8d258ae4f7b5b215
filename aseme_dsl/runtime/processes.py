"""Processes: resident worker processes for activities of kind `process`; `worker.py` is their other end.

Both talk in pickled tuples, each after four bytes with its length: over the worker's standard input and what
was its standard output when it started.
"""

from __future__ import annotations

import contextlib
import os
import pickle
import subprocess
import sys
import threading
from collections.abc import Callable, Sequence
from pathlib import Path
from queue import SimpleQueue
from typing import IO, TYPE_CHECKING, Any

from aseme_dsl.runtime.context import Cancelled
from aseme_dsl.runtime.execution import reason_of
from aseme_dsl.runtime.snapshot import Snapshot, snapshot_of, tell

if TYPE_CHECKING:
    from aseme_dsl.runtime.execution import Execution


class ReportedError(Exception):
    """What an activity has raised in another process: its text is the whole reason."""

    def __init__(self, reason: str, frames: list[dict[str, Any]] | None = None) -> None:
        super().__init__(reason)
        self.frames = frames


def put(file: IO[bytes], item: tuple[Any, ...]) -> None:
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
    """One worker process and the thread that talks with it, so that no step waits for a pipe."""

    def __init__(self, pool: Processes) -> None:
        self.pool = pool
        self.execution: Execution | None = None
        self.jobs: SimpleQueue[tuple[Execution, Snapshot] | None] = SimpleQueue()
        self.child: subprocess.Popen[bytes] | None = None
        self._sending = threading.Lock()
        threading.Thread(target=self._work, name="aseme process", daemon=True).start()

    def cancel(self) -> None:
        """Tell the activity that runs that it is cancelled."""
        with contextlib.suppress(OSError):  # the worker is gone, which its thread will see
            self._send(("cancel",))

    def kill(self) -> None:
        """End the worker by force if it is busy, else by closing what it listens to."""
        child = self.child
        if child is None:
            return
        if self.execution is not None:
            child.kill()
        elif child.stdin is not None:
            child.stdin.close()
        try:
            child.wait(1.0)
        except subprocess.TimeoutExpired:
            child.kill()
            child.wait()
        _close(child)

    def _work(self) -> None:
        while (job := self.jobs.get()) is not None:
            execution, snapshot = job
            error = self._run(execution, snapshot)
            self.execution = None
            if self.child is not None and self.child.poll() is not None:
                _close(self.child)
                self.child = None  # the next job makes a new one
            execution.returned(error)
            self.pool.ended(execution)
            self.pool.idle.append(self)

    def _run(self, execution: Execution, snapshot: Snapshot) -> BaseException | None:
        """Have an activity run to its end; with which error, if any."""
        code = execution.code
        assert code is not None
        try:
            child = self.child or self._start()
            file = getattr(sys.modules.get(code.__module__), "__file__", None)
            self._send(("run", code.__module__, file, code.__qualname__, snapshot))
            if execution.cancelled:  # a cancellation before that would have been forgotten
                self.cancel()
        except Exception as error:  # what cannot be pickled, a worker that cannot start
            return ReportedError(f"it cannot be started in another process: {reason_of(error)}")
        refused: Exception | None = None
        assert child.stdout is not None
        while (data := get(child.stdout)) is not None:
            try:
                kind, *rest = pickle.loads(data)
                if kind == "end":
                    return refused or _error_of(*rest)
                if refused is None:
                    tell(execution, rest[0])
            except Exception as error:  # what the activity would have got, had it been here
                refused = error
                self.cancel()
        return ReportedError(f"its process has ended with code {child.wait()}")

    def _start(self) -> subprocess.Popen[bytes]:
        # What this process can import, the worker can, too, whether this package is installed or not.
        found = [*map(str, self.pool.path), *(entry or str(Path.cwd()) for entry in sys.path)]
        environment = {**os.environ, "PYTHONPATH": os.pathsep.join(dict.fromkeys(found))}
        command = [sys.executable, "-m", "aseme_dsl.runtime.worker"]
        self.child = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, env=environment)
        return self.child

    def _send(self, item: tuple[Any, ...]) -> None:
        child = self.child
        if child is not None and child.stdin is not None:
            with self._sending:
                put(child.stdin, item)


def _close(child: subprocess.Popen[bytes]) -> None:
    """Close the pipes to a worker that has ended."""
    for pipe in (child.stdin, child.stdout):
        if pipe is not None:
            with contextlib.suppress(OSError):  # what was not sent yet cannot be sent any more
                pipe.close()


def _error_of(kind: str | None, reason: str, frames: list[dict[str, Any]] | None) -> BaseException | None:
    if kind is None:
        return None
    return Cancelled() if kind == "Cancelled" else ReportedError(reason, frames)


class Processes:
    """The worker processes of a run: as many as activities have run in them at once."""

    def __init__(self, path: Sequence[Path], ended: Callable[[Execution], None]) -> None:
        self.path = tuple(path)
        self.ended = ended
        self.idle: list[_Process] = []
        self._all: list[_Process] = []

    def launch(self, execution: Execution) -> None:
        """Run the code of an activity in a worker. Called while its agent is guarded."""
        snapshot = snapshot_of(execution)
        try:
            process = self.idle.pop()
        except IndexError:
            process = _Process(self)
            self._all.append(process)
        process.execution = execution
        execution.handle = process
        process.jobs.put((execution, snapshot))

    def cancel(self, execution: Execution) -> None:
        """Tell an activity that its state was left."""
        process: _Process | None = execution.handle
        if process is not None and process.execution is execution:
            process.cancel()

    def close(self) -> None:
        """End all workers, by force those that do not end by themselves."""
        for process in self._all:
            process.jobs.put(None)
            process.kill()
