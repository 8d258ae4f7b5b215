"""The match that the team plays, what is told while it goes on, and the picture of it at the end."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

from aseme_dsl.worlds.field import render
from aseme_dsl.worlds.field.event import Event, EventKind, clock
from aseme_dsl.worlds.field.field import HALF_LENGTH
from aseme_dsl.worlds.field.match import Match
from aseme_dsl.worlds.field.referee import SECOND, Rules
from aseme_dsl.worlds.field.team import team_sheet

OURS = team_sheet(1, "Kouretes", ("robot1", "robot2", "robot3"), goalie="keeper")
"""Three players and a goalie. The other team is played by the field itself."""
RULES = Rules(half_ns=120 * SECOND, halves=1)
PICTURE = Path(__file__).parent / "build" / "match.svg"
EVERY_NS = 5 * SECOND
"""How often the progress is told."""
TOLD = (EventKind.GOAL, EventKind.NO_GOAL, EventKind.PENALTY, EventKind.FULL_TIME)
"""What the referee notes is told if it is one of these."""


class Game(Match):
    """A match, with what has been told of it."""

    def __init__(self, seed: int) -> None:
        super().__init__(seed, home=OURS, rules=RULES)
        self.lines: list[str] = []
        self.noted = 0
        self.next_ns = EVERY_NS


def make(seed: int) -> Game:
    """A new match. Chance is drawn from the seed alone: one seed, one match."""
    return Game(seed)


def progress(game: Game, doing: Mapping[str, Sequence[Sequence[str]]]) -> list[str]:
    """Everything that was to tell so far: a line every few seconds, and what the referee noted."""
    events = game.events
    for event in events[game.noted :]:
        if event.kind in TOLD:
            game.lines.append(_told(event))
    game.noted = len(events)
    if game.now_ns >= game.next_ns:
        game.next_ns += EVERY_NS
        game.lines.append(_line(game, doing))
    return game.lines


def summary(game: Game) -> str:
    """Who scored and when, and the final result; the picture is drawn, too."""
    lines = [f"{clock(goal.time_ns)}  {_score(goal.score)}  {_scorer(goal)}" for goal in game.result().goals]
    lines.append(f"final result: {game.result()}" if game.over else f"so far: {game.result()}")
    try:
        PICTURE.parent.mkdir(exist_ok=True)
        PICTURE.write_text(render.svg(game), encoding="utf-8")
        lines.append(f"picture: {PICTURE}")
    except OSError as problem:
        lines.append(f"no picture: {PICTURE}: {problem.strerror}")
    return "\n".join(lines)


def _line(game: Game, doing: Mapping[str, Sequence[Sequence[str]]]) -> str:
    """The time, the score, where along the field the ball is, and what everybody is doing."""
    cells = ["·"] * 21
    cells[10] = "|"
    share = (game.truth().ball.x + HALF_LENGTH) / (2 * HALF_LENGTH)
    cells[min(20, max(0, int(share * 21)))] = "o"
    team = "  ".join(f"{name} {_state(doing.get(name, ()))}" for name in game.bodies)
    return f"{clock(game.now_ns)}  {_score(game.result().score)}  [{''.join(cells)}]  {team}"


def _state(active: Sequence[Sequence[str]]) -> str:
    """What a robot decided to do (its last region), with its part in the attack if it has one."""
    path = active[-1] if active else ["-"]
    part = [name for name in path[:-1] if name in ("center", "center_for")]
    return "/".join([*part, path[-1] if path[-1].isidentifier() else "waits"])


def _told(event: Event) -> str:
    if event.kind is EventKind.GOAL:
        return f"{clock(event.time_ns)}  {_score(event.score)}  GOAL for {event.team} by {_scorer(event)}"
    return str(event)


def _scorer(goal: Event) -> str:
    return f"{goal.robot} ({goal.detail})" if goal.detail else goal.robot


def _score(score: tuple[int, int]) -> str:
    return f"{score[0]}:{score[1]}"
