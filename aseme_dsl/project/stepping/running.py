"""Running: a run in virtual time that stands still between two instants until it may continue."""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

from aseme_dsl.play.observer import Observer
from aseme_dsl.play.run import NotPlayable, play
from aseme_dsl.play.scenario import Crashes, Restarts
from aseme_dsl.project.playing.play import PlayError, made_world
from aseme_dsl.project.settings.configuration import Configuration
from aseme_dsl.project.stepping.picture import Picture, picture_of
from aseme_dsl.project.stepping.session import Understood
from aseme_dsl.project.testing.cases import inputs_of
from aseme_dsl.project.testing.playing import world_of
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.driver.virtual import VirtualDriver
from aseme_dsl.runtime.team.team import Team
from aseme_dsl.runtime.trace.records import Record
from aseme_dsl.runtime.version.loading import Loaded, activities_in, forgetting, importing

PATIENCE = 2.0
"""So many seconds a run has to end."""
KEPT = 5000
"""So many records of what has happened are kept."""


@dataclass(frozen=True, slots=True)
class Instant:
    """Where a run stands."""

    events: int
    """In how many instants something has happened, up to this one."""
    happens: bool
    """Whether something has happened in this one."""
    picture: Picture
    happened: tuple[Record, ...]
    """What has happened since the run stood still last, the newest `KEPT` records of it."""
    last: tuple[Record, ...]
    """What has happened in this instant, or in the last one before it in which anything has."""
    halts: tuple[int, ...] = ()
    """The places of the halting conditions that have occurred."""
    over: str = ""
    """Why the run is over, if it is."""


@dataclass(frozen=True, slots=True)
class Point:
    """The end of an instant, as far as a goal asks for it."""

    events: int
    moment: int
    happens: bool
    halts: bool


Goal = Callable[[Point], bool]
"""Whether a run is to stand still there."""


@dataclass(frozen=True, slots=True)
class Stage:
    """What is needed to play: the code of the system, its project, and the folder of its activities.

    A run ends at `until` (ns), or later, where the scenario says so.
    """

    loaded: Loaded
    configuration: Configuration
    activities: Path
    until: int


class Run:
    """One run, in a thread of its own. `go` lets it continue, and waits until it stands still again.

    A run is followed by its trace, too: it is a listener.
    """

    def __init__(self, stage: Stage, understood: Understood, seed: int) -> None:
        self._stage = stage
        self._understood = understood
        self._seed = seed
        self._turn = threading.Condition()
        self._goal: Goal | None = None
        self._stands: Instant | None = None
        self._problem: BaseException | None = None
        self._is_closed = False
        self._events = 0
        self._wake: int | None = None
        self._happened: deque[Record] = deque(maxlen=KEPT)
        self._now: list[Record] = []
        """What has happened in this instant."""
        self._last: tuple[Record, ...] = ()
        self._halts: set[int] = set()
        self._team: Team | None = None
        self._observer: Observer | None = None
        self._thread = threading.Thread(target=self._play, name="aseme sim", daemon=True)

    # ---- for the one who steps ---------------------------------------------------------------

    def go(self, goal: Goal, moment: int | None = None) -> Instant:
        """Let the run continue to the first instant that is a goal, or to its end.

        There is an instant at `moment` (ns), also if nothing is due then.

        Raises:
            NotPlayable: it cannot be played.
        """
        with self._turn:
            if self._stands is not None and self._stands.over:
                return replace(self._stands, happened=())
            self._goal, self._wake, self._stands = goal, moment, None
            if not self._thread.is_alive():
                self._thread.start()
            self._turn.notify_all()
            self._turn.wait_for(
                lambda: self._is_closed or self._stands is not None or self._problem is not None
            )
            if self._problem is not None:
                raise self._problem
            if self._is_closed:
                raise NotPlayable("the run was ended")
            assert self._stands is not None
            return self._stands

    def close(self) -> None:
        """End the run, wherever it is; code of the user that does not return is left behind."""
        with self._turn:
            self._is_closed = True
            self._turn.notify_all()
        if self._thread.is_alive():
            self._thread.join(PATIENCE)

    # ---- in the run's thread -----------------------------------------------------------------

    def _play(self) -> None:
        stage, script = self._stage, self._understood.script
        project = stage.configuration.folder.resolve()
        try:
            with forgetting(project), importing([project, *stage.loaded.path]):
                name = world_of(script, stage.configuration)
                world = made_world(name, self._seed) if name is not None else None
                real = activities_in(stage.activities)
                inputs = next(inputs_of(script, self._seed, 1))
                until = stage.until if script.is_open else max(stage.until, script.until)
                play(stage.loaded, script, self._seed, inputs, real, until, world, (self,), watch=self)
        except PlayError as problem:
            self._end_with(NotPlayable(problem.problem.message))
        except BaseException as problem:
            self._end_with(problem)

    def _end_with(self, problem: BaseException) -> None:
        with self._turn:
            self._problem = problem
            self._turn.notify_all()

    def begin(self, team: Team, observer: Observer) -> None:
        """The run begins."""
        self._team, self._observer = team, observer
        for place, condition in enumerate(self._understood.halts):
            self._await(observer, place, condition)
        self._set_alarm(team)

    def _set_alarm(self, team: Team) -> None:
        if self._wake is not None:
            team.driver.at(self._wake, _nothing, background=True)

    def _await(self, observer: Observer, place: int, condition: int) -> None:
        def occurs(moment: int) -> None:
            self._halts.add(place)
            self._await(observer, place, condition)

        observer.waiting.setdefault(condition, []).append(occurs)

    def __call__(self, record: Record) -> None:
        self._now.append(record)

    def acted(self, act: Crashes | Restarts) -> None:
        """Something that a trace has no line of: it has one here."""
        assert self._team is not None
        what = "crash" if isinstance(act, Crashes) else "restart"
        moment = self._team.driver.clock.now()
        self._now.append({"kind": "scenario", "time": moment, "agent": act.agent, "what": what})

    def settled(self, team: Team) -> str | None:
        """An instant has ended: stand still if it is a goal. A reason ends the run."""
        return self._stand(team, "")

    def ended(self, reason: str) -> None:
        """The run is over."""
        assert self._team is not None and self._observer is not None
        broken = self._observer.broken
        if broken is not None:
            reason = f"broken: {self._understood.script.expectations[broken].span.text}"
        self._stand(self._team, reason)

    def _stand(self, team: Team, over: str) -> str | None:
        happens = bool(self._now)
        if happens:
            self._events += 1
            self._last = tuple(self._now)
            self._happened += self._now
            self._now.clear()
        point = Point(self._events, team.driver.clock.now(), happens, bool(self._halts))
        with self._turn:
            if self._is_closed:
                return "closed"
            if not over and self._goal is not None and not self._goal(point):
                self._halts.clear()
                return None
            halts = tuple(sorted(self._halts))
            happened = tuple(self._happened)
            self._stands = Instant(self._events, happens, picture_of(team), happened, self._last, halts, over)
            self._happened.clear()
            self._goal = None
            self._halts.clear()
            self._turn.notify_all()
            driver = team.driver
            if over or not isinstance(driver, VirtualDriver):
                return None
            driver.is_held = True
            self._turn.wait_for(lambda: self._goal is not None or self._is_closed)
            driver.is_held = False
            self._set_alarm(team)
            return "closed" if self._is_closed else None


def _nothing() -> None:
    pass


__all__ = ["Goal", "Instant", "NotPlayable", "Point", "Run", "Stage"]
