"""Reading: each parse has a budget, and a long one is done in a process of its own.

A parse begins in the server, where it nearly always ends within milliseconds. If it does not, it is given
up and `NotYet` is raised. The request that needs it waits for another process to do it, and is then answered
from the beginning. Meanwhile all others are answered. A text that is not read within `MOST` counts as
unreadable until it is edited (`TooSlow`); the operating system ends the process.
"""

from __future__ import annotations

import asyncio
import pickle
import signal
import sys
from collections.abc import Callable, Sequence
from contextlib import suppress
from contextvars import ContextVar
from typing import ParamSpec, TypeVar, cast

from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.editor.reading.budget import OutOfTime, may_interrupt, within
from aseme_dsl.editor.reading.reader_process import LENGTH, WORK
from aseme_dsl.grammar.layout import Formatted
from aseme_dsl.grammar.parsing.copies import load
from aseme_dsl.grammar.parsing.parts import TooSlow
from aseme_dsl.grammar.text import tree
from aseme_dsl.records import dataclass
from aseme_dsl.source import Source

_T = TypeVar("_T")
_K = TypeVar("_K")
_V = TypeVar("_V")
_P = ParamSpec("_P")

QUICK = 0.25
"""Seconds of computing after which a parse in the server is given up: all requests wait meanwhile."""

MOST = 5.0
"""Seconds of computing after which a parse is given up for good."""

LONGEST = 100.0
"""Seconds after which it is, on a machine that does not let it compute."""

PROCESSES = 4
"""How many processes read at the same time."""

KEPT = 64
"""How many slow texts are remembered."""

_BOOT = (
    "import sys; sys.path[:] = {path!r}; "
    "from aseme_dsl.editor.reading.reader_process import main; main({most!r})"
)


@dataclass(frozen=True, slots=True)
class Job:
    """Something to be done with a text: the name of one of `WORK`."""

    work: str
    path: str
    text: str

    @property
    def beginning(self) -> tuple[str, str, str]:
        """What stays while people type in a declaration."""
        return self.work, self.path, self.text[: self.text.find("\n") + 1]


class NotYet(Exception):
    """What is asked for is not known before a job is done: ask again then."""

    def __init__(self, job: Job) -> None:
        super().__init__(job.path)
        self.job = job


class Reader:
    """Does the parses of one server. For one thread, but for `do`.

    `command` starts the process that reads what takes long (see `reader_process`).
    """

    def __init__(
        self, command: Sequence[str] | None = None, *, quick: float = QUICK, most: float = MOST
    ) -> None:
        self._command = command or own_command(most)
        self._quick = quick
        self._most = most
        self._done: dict[Job, bytes] = {}
        self._given_up: dict[Job, str] = {}
        self._slow: dict[tuple[str, str, str], None] = {}
        self._tasks: dict[Job, asyncio.Task[None]] = {}
        self._files: dict[str, asyncio.Lock] = {}
        self._idle: list[asyncio.subprocess.Process] = []
        self._free = asyncio.Semaphore(PROCESSES)

    def do(self, work: str, source: Source, function: Callable[[Source], _T]) -> _T:
        """`function(source)`, which another process knows by the name `work`.

        Raises:
            NotYet: It takes long; `wait` for the job, then ask again.
            TooSlow: It takes too long.
        """
        job = Job(work, source.path, source.text)
        if job in self._given_up:
            raise TooSlow(self._given_up[job])
        if job in self._done:
            return cast(_T, load(self._done[job], source))
        if job.beginning not in self._slow and may_interrupt():
            try:
                return within(self._quick, function, source)
            except OutOfTime:
                _keep(self._slow, job.beginning, None)
        raise NotYet(job)

    def at_once(self, function: Callable[_P, _T], *arguments: _P.args, **named: _P.kwargs) -> _T:
        """The result of something that is of no use later.

        Raises:
            TooSlow: It takes long.
        """
        if not may_interrupt():
            return function(*arguments, **named)
        try:
            return within(self._quick, function, *arguments, **named)
        except OutOfTime:
            raise TooSlow(f"longer than {self._quick:g} s") from None

    async def wait(self, job: Job) -> None:
        """Until the job is done, or is given up."""
        if job not in self._tasks:
            self._tasks[job] = asyncio.create_task(self._work(job))
            self._tasks[job].add_done_callback(lambda task: self._tasks.pop(job, None))
        await asyncio.wait([self._tasks[job]])

    def changed(self, path: str, text: str) -> None:
        """A file has another text: what is read of the one before is not wanted any more."""
        for job, task in list(self._tasks.items()):
            if job.path == path and job.text not in text:
                task.cancel()

    async def _work(self, job: Job) -> None:
        async with self._files.setdefault(job.path, asyncio.Lock()), self._free:
            process = self._idle.pop() if self._idle else await self._start()
            try:
                answer = await asyncio.wait_for(_asked(process, job), LONGEST)
            except asyncio.IncompleteReadError:
                code = await process.wait()
                by_time = hasattr(signal, "SIGVTALRM") and code == -signal.SIGVTALRM
                reason = f"longer than {self._most:g} s" if by_time else f"its process ended with {code}"
                _keep(self._given_up, job, reason)
                return
            except TimeoutError:
                process.kill()
                _keep(self._given_up, job, f"longer than {LONGEST:g} s")
                return
            except BaseException:
                with suppress(ProcessLookupError):
                    process.kill()
                raise
            _keep(self._done, job, answer)
            self._idle.append(process)

    async def _start(self) -> asyncio.subprocess.Process:
        pipe = asyncio.subprocess.PIPE
        return await asyncio.create_subprocess_exec(*self._command, stdin=pipe, stdout=pipe)


def own_command(most: float = MOST) -> tuple[str, ...]:
    """What starts a process that reads, with the modules that this one has."""
    return sys.executable, "-P", "-c", _BOOT.format(path=sys.path, most=most)


async def _asked(process: asyncio.subprocess.Process, job: Job) -> bytes:
    """What a process answers.

    Raises:
        asyncio.IncompleteReadError: It has ended.
    """
    assert process.stdin is not None and process.stdout is not None
    asked = pickle.dumps((job.work, job.path, job.text))
    with suppress(ConnectionError):  # then there is nothing to read either
        process.stdin.write(len(asked).to_bytes(LENGTH, "big") + asked)
        await process.stdin.drain()
    size = int.from_bytes(await process.stdout.readexactly(LENGTH), "big")
    return await process.stdout.readexactly(size)


def _keep(known: dict[_K, _V], key: _K, value: _V) -> None:
    known[key] = value
    if len(known) > KEPT:
        del known[next(iter(known))]


# ---- for those who read --------------------------------------------------------------------------

reader: ContextVar[Reader | None] = ContextVar("reader", default=None)
"""Who reads for the request that is being answered; None: it is done here, however long it takes."""


def parse(source: Source) -> tuple[tree.File, tuple[Diagnostic, ...]]:
    """As `grammar.parse`; may raise `NotYet` and `TooSlow`."""
    return cast("tuple[tree.File, tuple[Diagnostic, ...]]", _read("parse", source))


def format_source(source: Source) -> Formatted:
    """As `grammar.layout.format_source`; may raise `NotYet` and `TooSlow`."""
    return cast(Formatted, _read("layout", source))


def _read(work: str, source: Source) -> object:
    own = reader.get()
    return WORK[work](source) if own is None else own.do(work, source, WORK[work])


def at_once(function: Callable[_P, _T], *arguments: _P.args, **named: _P.kwargs) -> _T:
    """`function(*arguments)`, for an answer that is useless when late; may raise `TooSlow`."""
    own = reader.get()
    if own is None:
        return function(*arguments, **named)
    return own.at_once(function, *arguments, **named)


__all__ = ["Job", "NotYet", "Reader", "at_once", "format_source", "own_command", "parse", "reader"]
