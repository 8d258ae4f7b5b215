"""Supervisor: a team in which every robot is a process, started, watched, restarted and ended together.

Each process has a pipe from here as its standard input and ends when that does, so that none is left over,
also if this process is killed. All begin at one moment, which they get over that pipe when all are ready. A
robot that ends badly is started again after a while that doubles each time, until it has run for some time.
A robot reports each version of its model that it is changed to while it plays, and is started again in that.
"""

from __future__ import annotations

import contextlib
import json
import os
import secrets
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import field
from pathlib import Path
from queue import Empty, SimpleQueue
from types import FrameType
from typing import IO, TYPE_CHECKING, Protocol

from aseme_dsl import outside
from aseme_dsl.diagnostics.problems import running as problems
from aseme_dsl.play.sight.insight import Asked
from aseme_dsl.play.sight.sightings import asked_text
from aseme_dsl.project.playing.play import PlayError
from aseme_dsl.project.settings.platforms import given_environment
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.trace.trace_files import USUAL, name_for

if TYPE_CHECKING:
    from aseme_dsl.project.playing.play import Request
    from aseme_dsl.project.settings.configuration import Configuration
    from aseme_dsl.runtime.control.control import Changed
    from aseme_dsl.runtime.version.loading import Loaded

READY = "\x01ready"
"""What a robot's process says on its standard output when it waits for the beginning."""
CHANGED = "\x01changed "
"""With this begins a line in which a robot says, as JSON, which version it plays from now on."""
ENDED = "\x01ended "
"""With this begins a line in which a robot says, as JSON, how its run has ended: `result`, and as `lines`."""
SEEN = "\x01seen "
"""With this begins a line in which a robot says, as JSON, what the properties and clauses may be about."""
LOOK = 0.1
"""Seconds between two looks at what the robots say of that."""
WORLD = "ASEMEC_WORLD"
"""The environment variable that has the key to the world."""
FEW_ARENAS = {"MALLOC_ARENA_MAX": "2"}
"""The default of the environment variable for the number of arenas of the GNU C library.

Without it, the library keeps memory apart for each of a robot's two dozen threads. Then the process seems to
grow for an hour.
"""
START = 60.0
"""How long, in seconds, all processes may take to get ready."""
END = 1.5
"""How long, in seconds, a process may take to end before it is killed."""
SHORTEST, LONGEST = 0.2, 5.0
"""After how many seconds a robot is started again, at first and at most."""
SETTLED = 10.0
"""A robot that has lived for so many seconds is started again at once, as if it were the first time."""
ATTEMPTS = 8
"""After so many short incarnations in a row an agent process is given up."""
FINE, FAILED, WRONG_USE, INTERRUPTED = 0, 1, 2, 130
_DELIBERATE = (FINE, WRONG_USE, INTERRUPTED, 143)
"""Exit codes of a robot that is not started again."""

_LONGEST = 1 << 20
"""A longer line of what a process prints is shown in pieces."""

Handler = Callable[[int, FrameType | None], object] | int | signal.Handlers | None
"""What `signal.signal` takes and gives."""
Say = Callable[[str, str, bool], None]
"""Shows a line: whose it is (a robot's, or "" for the team's), the line, whether something is wrong."""


class TeamWatching(Protocol):
    """What watches what all robots do, and may end the run."""

    record: Callable[[Mapping[str, object]], None]
    """Called for what is broken, with the members of the line of a trace."""

    @property
    def asked(self) -> Asked:
        """What is asked of the inside of agents."""

    def hear(self, text: str) -> None:
        """What a robot says it has seen (`SEEN`). May be called from any thread."""

    def crash(self, agent: str, moment: int) -> None:
        """The process of a robot has stopped dead."""

    def look(self, moment: int) -> str | None:
        """The time is `moment` (ns); why the run ends, if it does."""

    def finish(self, moment: int) -> None:
        """The run has ended at this moment (ns)."""


@dataclass(frozen=True, slots=True)
class End:
    """How a run ended, as the process says it (`ENDED`): as data, and as lines; nothing if it could not."""

    result: object = None
    lines: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class RobotEnd:
    """How a robot ended: the exit code of its last process, how often it was started, its traces."""

    name: str
    code: int
    starts: int
    traces: tuple[Path, ...]
    end: End = End()
    """What its last process has said of its end (`ENDED`); empty if it could not."""


@dataclass(frozen=True, slots=True)
class Supervised:
    """How a run ended: "finished", "interrupted", "terminated", "the world is over", or what went wrong."""

    reason: str
    robots: tuple[RobotEnd, ...]

    @property
    def failed(self) -> bool:
        """Whether a robot has ended badly at last."""
        return any(robot.code not in (FINE, INTERRUPTED, 143) for robot in self.robots)


@dataclass(slots=True)
class _Child:
    """A process that belongs to the run: a robot's, or the world's (called "")."""

    name: str
    process: subprocess.Popen[str] | None = None
    starts: int = 0
    short_lives: int = 0
    began: float = 0.0
    code: int | None = None
    over: bool = False
    again_at: float | None = None
    traces: list[Path] = field(default_factory=list)
    end: End = End()
    version: Changed | None = None
    """The version that it was changed to, if it was."""


@dataclass(frozen=True, slots=True)
class _News:
    """What happens to a process: of which child, what, and what there is to say of it."""

    name: str
    kind: str
    text: str = ""
    code: int = 0
    version: Changed | None = None


def supervise(
    loaded: Loaded,
    folder: Path,
    activities: Path,
    configuration: Configuration,
    request: Request,
    options: Sequence[str],
    say: Say,
    watch: TeamWatching | None = None,
) -> Supervised:
    """Play a team with a process for each robot, to the end.

    `folder` is the output folder of the build, `options` are passed on to every robot. `watch` is shown what
    all robots do. Must be called in the main thread. Ctrl-C and SIGTERM end all.

    Raises:
        PlayError: it cannot be begun: no team, no transport, a robot or the world that does not start.
    """
    from aseme_dsl.project.settings.deployment import network_of
    from aseme_dsl.project.settings.platform_settings import ZENOH
    from aseme_dsl.project.settings.platforms import PlatformError, check_installed, provided
    from aseme_dsl.runtime.transport import TransportError
    from aseme_dsl.runtime.transport.meeting import check_meeting

    platform = request.platform or ZENOH
    if not loaded.team:
        raise PlayError(problems.NoTeam(loaded.name))
    try:
        check_installed(platform)
        if platform == ZENOH and network_of(configuration.deploy, "").local:
            check_meeting()
        with provided(platform, loaded, configuration, lambda line: say("", line, False)):
            options = [*options, "--platform", platform]
            if watch is not None:
                options += ["--watched", asked_text(watch.asked)]
            return _Run(loaded, folder, activities, configuration, request, options, say, watch).run()
    except (TransportError, PlatformError) as problem:
        raise PlayError(problems.NotPlayed(str(problem))) from problem


class _Run:
    """One run. All but the pumps happens in the thread that calls `run`."""

    def __init__(
        self,
        loaded: Loaded,
        folder: Path,
        activities: Path,
        configuration: Configuration,
        request: Request,
        options: Sequence[str],
        say: Say,
        watching: TeamWatching | None,
    ) -> None:
        self._watching = watching
        if watching is not None:
            watching.record = self._record
        self._loaded = loaded
        self._folder = folder
        self._activities = activities
        self._configuration = configuration
        self._request = request
        self._options = options
        self._say = say
        self._key = secrets.token_bytes(32)
        self._news: SimpleQueue[_News] = SimpleQueue()
        self._robots = {name: _Child(name) for name, _ in loaded.team}
        self._world: _Child | None = None
        self._address: str | None = None
        self._origin: int | None = None
        self._reason = ""
        self._pumps: list[threading.Thread] = []

    def run(self) -> Supervised:
        """Start all processes, and watch them to the end."""
        over = False
        with _signals(lambda reason: self._news.put(_News("", "stop", reason))):
            try:
                if self._made_by is not None:
                    self._start_world(self._made_by)
                for child in self._robots.values():
                    self._start(child)
                self._await_all()
                self._watch()
                over = self._time_is_over()
            finally:
                self._end_all()
                if self._watching is not None:
                    self._watching.finish(self._now)
        ends = tuple(
            RobotEnd(child.name, child.code or 0, child.starts, tuple(child.traces), child.end)
            for child in self._robots.values()
        )
        return Supervised(self._reason or ("time" if over else "finished"), ends)

    def _time_is_over(self) -> bool:
        """Whether the robots have played for as long as they were to."""
        project = self._configuration.run
        limit = self._request.duration
        if limit is None and self._world is not None and project is not None:
            limit = project.duration
        return limit is not None and self._origin is not None and time.monotonic_ns() >= self._origin + limit

    @property
    def _made_by(self) -> str | None:
        """The function that makes the world, if there is one."""
        project = self._configuration.run
        if self._request.world is not None or self._request.bodies:
            return self._request.world
        return project.world if project else None

    # ---- starting ----------------------------------------------------------------------------

    def _start_world(self, made_by: str) -> None:
        project = self._configuration.run
        child = self._world = _Child("")
        child.process = self._spawn([sys.executable, "-m", "aseme_dsl.project.playing.world_process"])
        duration = self._request.duration or (project.duration if project else None)
        asked = {
            "project": str(self._configuration.path.absolute()) if self._configuration.path else None,
            "folder": str(self._configuration.folder.absolute()),
            "path": [str(entry.absolute()) for entry in self._loaded.path],
            "world": made_by,
            "seed": self._configuration.seed if self._request.seed is None else self._request.seed,
            "duration": duration,
            "key": self._key.hex(),
        }
        _write(child, json.dumps(asked))
        self._pump(child)
        for news in self._listen(START, for_world=True):
            if news.name == "" and news.kind == "address":
                self._address = news.text
                return
            if news.name == "" and news.kind == "ended":
                raise PlayError(problems.WorldNotMade())
            if news.kind == "stop":
                raise PlayError(problems.NotPlayed(news.text))

    def _start(self, child: _Child) -> None:
        child.starts += 1
        child.began = time.monotonic()
        child.again_at = None
        trace = self._trace(child)
        child.traces.append(trace)
        command = [sys.executable, "-m", "aseme_dsl", "node", child.name, str(self._folder.absolute())]
        command += ["--supervised", "--system", self._loaded.name, "--trace", str(trace.absolute())]
        activities = str(self._activities.absolute())
        if child.starts == 1:
            command += ["--fresh"]
        if child.version is not None:
            command += ["--in-version", child.version.hash]
        command += ["--activities", activities]
        if self._configuration.path is not None:
            command += ["--project", str(self._configuration.path.absolute())]
        if self._address is not None:
            command += ["--world-at", self._address]
        child.process = self._spawn([*command, *self._options])
        self._pump(child)
        if self._origin is not None:
            _write(child, str(self._origin))

    def _trace(self, child: _Child) -> Path:
        """A file for each agent process, and another one for each further incarnation."""
        project = self._configuration.run
        given = self._request.trace or (project.trace if project else None) or self._folder / USUAL
        life = f".{child.starts}" if child.starts > 1 else ""
        return given.with_name(name_for(f"{child.name}{life}", given.name))

    def _spawn(self, command: list[str]) -> subprocess.Popen[str]:
        own = {"PYTHONUNBUFFERED": "1", WORLD: self._key.hex()}
        environment = {**FEW_ARENAS, **os.environ, **given_environment(), **own}
        return subprocess.Popen(
            command,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            encoding="utf-8",
            errors="replace",
            env=environment,
            start_new_session=True,  # Ctrl-C in a terminal is for us, who end the others in order
        )

    def _await_all(self) -> None:
        """Wait until all processes are ready, and begin."""
        waiting = set(self._robots)
        if waiting:
            for news in self._listen(START):
                if news.kind == "ready":
                    waiting.discard(news.name)
                elif news.kind == "ended":
                    raise PlayError(problems.ProcessNotStarted(news.name or None, _how_ended(news.code)))
                elif news.kind == "stop":
                    self._reason = news.text
                    return
                if not waiting:
                    break
        self._origin = time.monotonic_ns()
        for child in (*self._robots.values(), *([self._world] if self._world else [])):
            _write(child, str(self._origin))

    # ---- watching ----------------------------------------------------------------------------

    def _watch(self) -> None:
        while not self._reason and not all(child.over for child in self._robots.values()):
            starts = [child.again_at for child in self._robots.values() if child.again_at is not None]
            rest = max(0.0, min(starts) - time.monotonic()) if starts else None
            if self._watching is not None:
                rest = LOOK if rest is None else min(rest, LOOK)
            with contextlib.suppress(Empty):
                self._heed(self._news.get(timeout=rest))
            if self._watching is not None and not self._reason:
                self._reason = self._watching.look(self._now) or ""
            for child in self._robots.values():
                if child.again_at is not None and child.again_at <= time.monotonic():
                    self._start(child)

    @property
    def _now(self) -> int:
        """The time of the run (ns)."""
        return 0 if self._origin is None else time.monotonic_ns() - self._origin

    def _record(self, breach: Mapping[str, object]) -> None:
        """Write into the trace of the first robot whose process runs that something is broken.

        What is found when all have ended is in no trace: theirs are closed.
        """
        running = (child for child in self._robots.values() if not child.over and child.again_at is None)
        child = next(running, None)
        if child is not None:
            _write(child, json.dumps(breach))

    def _heed(self, news: _News) -> None:
        if news.kind == "stop":
            self._reason = news.text
        elif news.version is not None:
            everybody = self._robots.values()
            for child in everybody if news.version.whole_team else (self._robots[news.name],):
                child.version = news.version
        elif news.kind == "over":
            self._reason = "the world is over"
        elif news.kind == "ended" and news.name == "":
            self._reason = f"the world has ended: {_how_ended(news.code)}"
            self._say("", self._reason, True)
        elif news.kind == "ended":
            self._ended(self._robots[news.name], news.code)

    def _ended(self, child: _Child, code: int) -> None:
        """A robot's process is over: for good, or to be started again."""
        child.code = code
        if child.process is not None and child.process.stdin is not None:
            with contextlib.suppress(OSError):
                child.process.stdin.close()
        if code in _DELIBERATE:
            child.over = True
            return
        if self._watching is not None:
            self._watching.crash(child.name, self._now)
        lived = time.monotonic() - child.began
        child.short_lives = 0 if lived >= SETTLED else child.short_lives + 1
        how = f"{child.name} {_how_ended(code)}"
        if child.short_lives >= ATTEMPTS:
            child.over = True
            self._say("", f"{how}, for the {ATTEMPTS}th time in a row: it is given up", True)
            return
        pause = min(LONGEST, SHORTEST * 2 ** max(0, child.short_lives - 1))
        child.again_at = time.monotonic() + pause
        self._say("", f"{how}; it is started again in {pause:g} s", True)

    # ---- ending ------------------------------------------------------------------------------

    def _end_all(self) -> None:
        """Ask all processes to end, robots before the world; kill those that do not."""
        robots = [child.process for child in self._robots.values() if child.process is not None]
        world = [self._world.process] if self._world is not None and self._world.process is not None else []
        for group, patience in ((robots, END), (world, 0.3)):
            for process in group:
                with contextlib.suppress(OSError):
                    process.terminate()
            deadline = time.monotonic() + patience
            for process in group:
                try:
                    process.wait(max(0.0, deadline - time.monotonic()))
                except subprocess.TimeoutExpired:
                    process.kill()
                    process.wait()
                # Only now: to a robot the end of this pipe is a second signal, which ends it at once.
                if process.stdin is not None:
                    with contextlib.suppress(OSError):
                        process.stdin.close()
        for thread in self._pumps:
            thread.join(END)
        for child in self._robots.values():
            if child.process is not None and not child.over:
                code = child.process.returncode
                child.code = FINE if code in (-signal.SIGTERM, 143, INTERRUPTED) else code

    # ---- pipes -------------------------------------------------------------------------------

    def _listen(self, seconds: float, *, for_world: bool = False) -> Iterator[_News]:
        """What happens. Raises PlayError when it takes too long."""
        deadline = time.monotonic() + seconds
        while True:
            try:
                yield self._news.get(timeout=max(0.0, deadline - time.monotonic()))
            except Empty:
                raise PlayError(problems.StartTooSlow(for_world, seconds)) from None

    def _pump(self, child: _Child) -> None:
        """Show what a process says, and tell when it has ended."""
        process = child.process
        assert process is not None and process.stdout is not None and process.stderr is not None
        name, out, err = child.name, process.stdout, process.stderr
        threads = [
            threading.Thread(target=self._read_out, args=(name, out), daemon=True),
            threading.Thread(target=self._read_err, args=(name, err), daemon=True),
        ]
        for thread in threads:
            thread.start()

        def wait() -> None:
            code = process.wait()
            for thread in threads:
                thread.join(1.0)  # a grandchild may hold the pipe open
            self._news.put(_News(name, "ended", code=code))

        waiting = threading.Thread(target=wait, daemon=True)
        waiting.start()
        self._pumps = [thread for thread in (*self._pumps, waiting) if thread.is_alive()]

    def _read_out(self, name: str, stream: IO[str]) -> None:
        with stream:
            while text := stream.readline(_LONGEST):
                line = text.rstrip("\n")
                try:
                    self._hear(name, line)
                except (ValueError, TypeError):  # what an activity prints may look like news
                    self._say(name, line, False)

    def _hear(self, name: str, line: str) -> None:
        from aseme_dsl.runtime.control.control import Changed

        if name == "":
            for kind, value in _object(line).items():
                if kind == "line":
                    self._say("", str(value), False)
                else:
                    self._news.put(_News("", kind, str(value)))
        elif line == READY:
            self._news.put(_News(name, "ready"))
        elif line.startswith(SEEN) and self._watching is not None:
            self._watching.hear(line.removeprefix(SEEN))
        elif line.startswith(CHANGED):
            version = _object(line.removeprefix(CHANGED))
            if not {"hash", "whole_team"} <= version.keys():
                raise TypeError("it is not `control.Changed`")
            change = Changed(str(version["hash"]), bool(version["whole_team"]))
            self._news.put(_News(name, "changed", version=change))
        elif line.startswith(ENDED):
            end = _object(line.removeprefix(ENDED))
            lines = end.get("lines")
            said = tuple(map(str, lines)) if isinstance(lines, list) else ()
            self._robots[name].end = End(end.get("result"), said)
        else:
            self._say(name, line, False)

    def _read_err(self, name: str, stream: IO[str]) -> None:
        with stream:
            while text := stream.readline(_LONGEST):
                self._say(name, text.rstrip("\n"), True)


def _object(text: str) -> dict[str, object]:
    found = outside.loads(text)
    if not isinstance(found, dict):
        raise TypeError("a JSON object is wanted")
    return found


def _write(child: _Child, line: str) -> None:
    process = child.process
    if process is not None and process.stdin is not None:
        with contextlib.suppress(OSError, ValueError):  # it has ended, which will be told
            process.stdin.write(line + "\n")
            process.stdin.flush()


def _how_ended(code: int) -> str:
    if code >= 0:
        return f"has ended with exit code {code}"
    try:
        return f"was ended by {signal.Signals(-code).name}"
    except ValueError:
        return f"was ended by signal {-code}"


@contextmanager
def _signals(stop: Callable[[str], None]) -> Iterator[None]:
    """Inside, Ctrl-C and SIGTERM call `stop` with the reason of the end.

    They do so if this is the main thread: no other may set handlers.
    """
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    before: dict[int, Handler] = {}

    def handle(number: int, frame: FrameType | None) -> None:
        stop("terminated" if number == signal.SIGTERM else "interrupted")

    for number in (int(signal.SIGINT), int(signal.SIGTERM)):
        if signal.getsignal(number) is not None:  # None: code outside Python has set it
            before[number] = signal.signal(number, handle)
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
