"""Match: two teams in one world, each in a process of its own, in virtual time and with many seeds.

The referee (this process) has the world. At each step it hears what the home team does until that has nothing
more to do at this time, then the away team, and then lets the world pass. So one seed gives one match. A team
that fails, ends or does not answer is out; the other plays on.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager, suppress
from dataclasses import replace
from multiprocessing import get_context
from numbers import Real
from pathlib import Path
from typing import TYPE_CHECKING, cast

from aseme_dsl.diagnostics.problems import running as problems
from aseme_dsl.project.playing.match_team import (
    Act,
    Broken,
    Given,
    Refused,
    Say,
    Side,
    Start,
    TeamEnd,
    Until,
    View,
    run_team,
)
from aseme_dsl.project.playing.play import PlayError, made_world
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.time.clock import USUAL_LENGTH
from aseme_dsl.runtime.world.body import AnyBody, AnyWorld, RadioMessage, fit_to_travel
from aseme_dsl.runtime.world.lineup import AWAY, HOME, Lineup, seat_of

if TYPE_CHECKING:
    from multiprocessing.connection import Connection
    from multiprocessing.context import SpawnProcess

FIELD = "aseme_dsl.worlds.field.game:make"
"""The world that a match has if no other is named."""
PATIENCE = 60.0
"""How long, in seconds, a team may take until it asks or says something."""
END = 2.0
"""How long, in seconds, a process may take to end before it is killed."""


@dataclass(frozen=True, slots=True)
class Contestant:
    """A team that can play: its lineup, and where its code is."""

    lineup: Lineup
    package: Path
    activities: Path
    folder: Path


@dataclass(frozen=True, slots=True)
class Plan:
    """What is played: who against whom, in which world, and for how long at most (ns).

    `output` is where the trace of each team goes, if anywhere; with it, a match is drawn, too.
    """

    home: Contestant
    away: Contestant
    world: str = FIELD
    length: int | None = None
    output: Path | None = None


@dataclass(frozen=True, slots=True)
class SideEnd:
    """How the match ended for one team; `broken` is why it was out before, if it was."""

    broken: str | None
    end: TeamEnd | None

    @property
    def failed(self) -> bool:
        """Whether the team, or one of its agents, has failed."""
        return self.broken is not None or (self.end is not None and bool(self.end.failures))


@dataclass(frozen=True, slots=True)
class Played:
    """A match that has been played. `story` are the lines that the world tells of it."""

    seed: int
    score: tuple[float, float]
    time_ns: int
    over: bool
    story: tuple[str, ...]
    home: SideEnd
    away: SideEnd
    picture: str | None = None

    @property
    def failed(self) -> bool:
        """Whether a team, or an agent of one, has failed."""
        return self.home.failed or self.away.failed


def play_matches(
    plan: Plan, seeds: Sequence[int], processes: int, told: Callable[[], None] = lambda: None
) -> tuple[Played, ...]:
    """Play a match with each seed, so many at the same time; `told` is called after each.

    Raises:
        PlayError: the world cannot be made, or fails.
    """
    with ThreadPoolExecutor(processes, thread_name_prefix="aseme match") as pool:
        waiting = [pool.submit(play_match, plan, seed) for seed in seeds]
        try:
            found = []
            for item in waiting:
                found.append(item.result())
                told()
            return tuple(found)
        except BaseException:
            pool.shutdown(wait=False, cancel_futures=True)
            raise


def play_match(plan: Plan, seed: int) -> Played:
    """Play one match.

    Raises:
        PlayError: the world cannot be made, or fails.
    """
    world = made_world(plan.world, seed, home=plan.home.lineup, away=plan.away.lineup)
    _score(plan.world, world)
    length = plan.length
    if length is None and not hasattr(world, "over"):
        length = USUAL_LENGTH
    contestants = {HOME: plan.home, AWAY: plan.away}
    for side, contestant in contestants.items():
        for agent in contestant.lineup.roles:
            if seat_of(side, agent) not in world.bodies:
                raise PlayError(problems.NoBodyInMatch(plan.world, seat_of(side, agent)))
    with _seated(contestants, world, seed, plan.output) as seats:
        over = _referee(plan.world, world, seats, length)
        home, away = (seat.ended() for seat in seats)
        picture = getattr(world, "picture", None) if plan.output is not None else None
        story = getattr(world, "story", ())
        return Played(
            seed,
            _score(plan.world, world),
            world.now_ns,
            over,
            tuple(str(line) for line in story),
            home,
            away,
            str(picture()) if callable(picture) else None,
        )


class _Seat:
    """A team in the match, as the referee sees it."""

    def __init__(
        self, side: str, contestant: Contestant, world: AnyWorld, seed: int, output: Path | None
    ) -> None:
        self.side = side
        self.waits_for: int | None = None
        """The moment up to which it has done everything; None while it has its turn."""
        self._agents = tuple(contestant.lineup.roles)
        self._bodies: dict[str, AnyBody] = {
            agent: world.bodies[seat_of(side, agent)] for agent in self._agents
        }
        self._shown: dict[str, object] = {}
        self._end: TeamEnd | Broken | None = None
        spawned = get_context("spawn")
        ours, theirs = spawned.Pipe()
        self._connection: Connection[object, object] = ours
        trace = None if output is None else output / f"match-{seed}.{side}.jsonl.gz"
        where = Side(contestant.package, contestant.activities, contestant.folder, seed, trace)
        self._process: SpawnProcess = spawned.Process(
            target=run_team, args=(theirs, where), name=f"aseme {side}", daemon=True
        )
        self._process.start()
        theirs.close()

    @property
    def playing(self) -> bool:
        """Whether the team is still in the match."""
        return self._end is None

    def begin(self, world: AnyWorld) -> None:
        """Wait until the team is ready, and show it the world."""
        if self._next() is not None:
            limits = {agent: body.payload_limit for agent, body in self._bodies.items()}
            self._send(Start(world.step_ns, limits, self._view(world, False)))

    def take_turn(self) -> None:
        """Do what the team asks for, until it has done everything at this time, or has ended."""
        while self.waits_for is None and self._end is None:
            match self._next():
                case Act(agent, command):
                    self._send(self._answer(lambda: self._bodies[agent].act(command)))
                case Say(agent, payload):
                    self._send(self._answer(lambda: self._bodies[agent].say(payload)))
                case Until(moment):
                    self.waits_for = moment
                case None:
                    return
                case said:
                    self._end = Broken(f"it has sent an unknown request: {type(said).__name__}")

    def show(self, world: AnyWorld, over: bool) -> None:
        """Show the team what is new; it has its turn again."""
        self.waits_for = None
        self._send(Given(self._view(world, over)))

    def ended(self) -> SideEnd:
        """How the match ended for the team, which says so now that it is over."""
        while self._end is None:
            self.take_turn()
            self.waits_for = None
        if isinstance(self._end, Broken):
            return SideEnd(self._end.reason, None)
        return SideEnd(None, self._end)

    def close(self) -> None:
        """End the team's process."""
        with suppress(OSError):
            self._connection.close()
        self._process.join(END)
        if self._process.is_alive():
            self._process.kill()
            self._process.join(END)

    def _next(self) -> object:
        """What the team says; None if it is out or has ended."""
        try:
            if not self._connection.poll(PATIENCE):
                self._end = Broken(f"it has not answered for {PATIENCE:g} s")
                self._process.kill()
                return None
            said = self._connection.recv()
        except (OSError, EOFError):
            self._process.join(END)
            code = self._process.exitcode
            self._end = Broken("its process has ended" + (f" with code {code}" if code else ""))
            return None
        except Exception as problem:  # a class of the team may raise anything when it is unpickled
            said = Broken(f"it has sent an unreadable message: {type(problem).__name__}: {problem}")
        if isinstance(said, (TeamEnd, Broken)):
            self._end = said
            return None
        return said

    def _send(self, answer: object) -> None:
        with suppress(OSError):  # its process has ended: the next reading says so
            self._connection.send(answer)

    def _answer(self, call: Callable[[], object]) -> Given | Refused:
        try:
            return Given(call())
        except Exception as error:
            return Refused(fit_to_travel(error))

    def _view(self, world: AnyWorld, over: bool) -> View:
        percepts = {agent: body.sense() for agent, body in self._bodies.items()}
        new = {
            agent: percept
            for agent, percept in percepts.items()
            if agent not in self._shown or percept is not self._shown[agent]
        }
        self._shown = percepts
        heard = {agent: self._own(agent) for agent in self._agents}
        return View(world.now_ns, over, new, {agent: items for agent, items in heard.items() if items})

    def _own(self, agent: str) -> list[RadioMessage]:
        """What a robot has heard from its own team, by the names that the team knows."""
        found: list[RadioMessage] = []
        for item in self._bodies[agent].hear():
            side, dot, name = item.sender.rpartition(".")
            if not dot and (name == "" or name in self._agents):
                found.append(item)
            elif dot and side == self.side:
                found.append(replace(item, sender=name))
        return found


@contextmanager
def _seated(
    contestants: Mapping[str, Contestant], world: AnyWorld, seed: int, output: Path | None
) -> Iterator[list[_Seat]]:
    seats: list[_Seat] = []
    try:
        for side, contestant in contestants.items():
            seats.append(_Seat(side, contestant, world, seed, output))
        yield seats
    finally:
        for seat in seats:
            seat.close()


def _referee(name: str, world: AnyWorld, seats: Sequence[_Seat], length: int | None) -> bool:
    """Let both teams play until the world is over; whether it is."""
    for seat in seats:
        seat.begin(world)
    while True:
        for seat in seats:
            if seat.playing:
                seat.take_turn()
        waiting = [seat.waits_for for seat in seats if seat.playing and seat.waits_for is not None]
        if not waiting:
            return getattr(world, "over", False) is True
        until = min(waiting) if length is None else min(length, *waiting)
        try:
            world.advance(until)
        except Exception as error:
            raise PlayError(
                problems.FunctionFailed("advance", f"{type(error).__name__}: {error}", name)
            ) from error
        over = getattr(world, "over", False) is True
        at_end = over or (length is not None and world.now_ns + world.step_ns > length)
        for seat in seats:
            if seat.playing and (at_end or (seat.waits_for or 0) < world.now_ns + world.step_ns):
                seat.show(world, at_end)
        if at_end:
            return over


def _score(name: str, world: AnyWorld) -> tuple[float, float]:
    score = getattr(world, "score", None)
    if (
        not isinstance(score, Sequence)
        or len(score) != 2
        or not all(isinstance(part, Real) for part in score)
    ):
        raise PlayError(problems.NoScore(name))
    home, away = cast("tuple[float, float]", score)
    return home, away


__all__ = ["FIELD", "Contestant", "Plan", "Played", "SideEnd", "play_match", "play_matches"]
