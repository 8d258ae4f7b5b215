"""The process of one team in a match: the team runs in virtual time, in a world that the referee keeps.

Nothing of the other team is here: no code, names, topics or messages. The world's time passes when both teams
have asked for it.
"""

from __future__ import annotations

import os
import signal
import sys
from collections.abc import Mapping, Sequence
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, cast

from aseme_dsl.records import dataclass
from aseme_dsl.runtime.world.body import BodyConnectionError, RadioMessage

if TYPE_CHECKING:
    from multiprocessing.connection import Connection

MOST_FAULTS = 20
"""How many different faults of a team are reported."""


@dataclass(frozen=True, slots=True)
class Side:
    """What a team's process needs: where its code is, and where its trace goes. `folder` is its project's."""

    package: Path
    activities: Path
    folder: Path
    seed: int
    trace: Path | None = None


@dataclass(frozen=True, slots=True)
class View:
    """What the referee shows of the world: the time, whether it is over, and what is new for each body."""

    now_ns: int
    over: bool
    percepts: Mapping[str, object]
    heard: Mapping[str, Sequence[RadioMessage]]


@dataclass(frozen=True, slots=True)
class Start:
    """What a team gets first: the length of a step, its bodies with the radio's limit, and the view."""

    step_ns: int
    limits: Mapping[str, int]
    view: View


@dataclass(frozen=True, slots=True)
class TeamEnd:
    """How a team's run ended: why agents stopped, and what could not be done although they went on."""

    reason: str
    time_ns: int
    failures: tuple[str, ...] = ()
    faults: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Act:
    """A command for a body."""

    agent: str
    command: object


@dataclass(frozen=True, slots=True)
class Say:
    """Something to say by radio."""

    agent: str
    payload: bytes


@dataclass(frozen=True, slots=True)
class Until:
    """The team has done everything up to this moment; the answer is a `View`."""

    moment: int


@dataclass(frozen=True, slots=True)
class Given:
    """An answer."""

    value: object


@dataclass(frozen=True, slots=True)
class Refused:
    """The body has raised this."""

    error: Exception


@dataclass(frozen=True, slots=True)
class Broken:
    """The team cannot be played; the text says why."""

    reason: str


class LentBody:
    """A body in the world of the referee."""

    def __init__(self, name: str, limit: int, ask: _Ask) -> None:
        self.name = name
        self.payload_limit = limit
        self.percept: object = None
        self.inbox: list[RadioMessage] = []
        self._ask = ask

    def sense(self) -> object:
        """The newest percept."""
        return self.percept

    def act(self, command: object) -> None:
        """Put a command in force."""
        self._ask(Act(self.name, command))

    def say(self, payload: bytes) -> bool:
        """Send a message by radio; whether the radio took it."""
        return bool(self._ask(Say(self.name, bytes(payload))))

    def hear(self) -> list[RadioMessage]:
        """What arrived since the last call."""
        heard, self.inbox = self.inbox, []
        return heard


class _Ask:
    """The line to the referee."""

    def __init__(self, connection: Connection[object, object]) -> None:
        self._connection = connection

    def __call__(self, question: Act | Say | Until) -> object:
        try:
            self._connection.send(question)
            answer = self._connection.recv()
        except (OSError, EOFError) as problem:
            raise BodyConnectionError("the match has been ended") from problem
        if isinstance(answer, Refused):
            raise answer.error
        return cast(Given, answer).value


class LentWorld:
    """The world of the match, as far as one team has to do with it."""

    def __init__(self, start: Start, connection: Connection[object, object]) -> None:
        self._ask = _Ask(connection)
        self.step_ns = start.step_ns
        self.bodies = {name: LentBody(name, limit, self._ask) for name, limit in start.limits.items()}
        self.now_ns = 0
        self.over = False
        self._take(start.view)

    def advance(self, until_ns: int) -> None:
        """Let the world pass, and the other team do its part."""
        if self.over or until_ns < self.now_ns + self.step_ns:
            return
        self._take(cast(View, self._ask(Until(until_ns))))

    def _take(self, view: View) -> None:
        self.now_ns = view.now_ns
        self.over = view.over
        for name, percept in view.percepts.items():
            self.bodies[name].percept = percept
        for name, heard in view.heard.items():
            self.bodies[name].inbox.extend(heard)


def run_team(connection: Connection[object, object], side: Side) -> None:
    """Run a team to its end, and tell the referee how it ended. The entry of its process."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the referee, who then ends us
    sys.stdout.flush()
    os.dup2(2, 1)  # standard output is for the results
    try:
        end: TeamEnd | Broken = _run(connection, side)
    except BodyConnectionError:
        return
    except Exception as problem:
        end = Broken(f"{type(problem).__name__}: {problem}")
    with suppress(OSError):
        connection.send(end)
        connection.close()


def _run(connection: Connection[object, object], side: Side) -> TeamEnd | Broken:
    from aseme_dsl.backends.backend import AGENTS
    from aseme_dsl.project.playing.play import PlayError, users_mistakes
    from aseme_dsl.runtime.activity.activities import ActivityError
    from aseme_dsl.runtime.team.team import TeamError, make_team
    from aseme_dsl.runtime.version.loading import (
        LoadError,
        RoleBackends,
        activities_in,
        importing,
        load_system,
    )

    faults = _Faults()
    try:
        loaded = load_system(side.package, path=[side.folder], mixture=RoleBackends(names=AGENTS))
        folders = [side.folder, *loaded.path]
        with importing(folders):
            connection.send(Given(None))  # ready
            if side.trace is not None:
                side.trace.parent.mkdir(parents=True, exist_ok=True)
            world = LentWorld(cast(Start, connection.recv()), connection)
            team = make_team(
                loaded,
                activities_in(side.activities),
                clock="virtual",
                seed=side.seed,
                world=world,
                stop=lambda team: "the world is over" if world.over else None,
                listeners=(faults,),
                path=folders,
                trace=side.trace,
            )
            with users_mistakes(side.package):
                result = team.run()
    except (LoadError, TeamError, ActivityError, PlayError) as problem:
        return Broken(str(problem))
    except OSError as problem:
        if side.trace is None:
            raise
        return Broken(f"its trace cannot be written: {problem}")
    failures = tuple(
        f"{agent.name}: {agent.failure}{f' ({agent.at})' if agent.at else ''}"
        for agent in result.agents
        if agent.failure
    )
    reasons = [*faults.reasons, *([f"the trace: {result.trace_error}"] if result.trace_error else [])]
    return TeamEnd(result.reason, result.end_ns, failures, tuple(reasons))


class _Faults:
    """What the runtime has to complain of, each once."""

    def __init__(self) -> None:
        self.reasons: dict[str, None] = {}

    def wants(self, kind: str, what: str | None) -> bool:
        return kind == "fault"

    def __call__(self, record: Mapping[str, object]) -> None:
        if record["kind"] == "fault" and len(self.reasons) < MOST_FAULTS:
            agent = record.get("agent")
            self.reasons.setdefault(f"{agent}: {record['reason']}" if agent else str(record["reason"]))


__all__ = [
    "Act",
    "Broken",
    "Given",
    "LentWorld",
    "Refused",
    "Say",
    "Side",
    "Start",
    "TeamEnd",
    "Until",
    "View",
    "run_team",
]
