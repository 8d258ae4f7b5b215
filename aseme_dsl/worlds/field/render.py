"""Pictures of a match: a line of text while it is played, and a drawing of how the goals came about."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from html import escape

from aseme_dsl.worlds.field import ball as balls
from aseme_dsl.worlds.field.event import Event, clock
from aseme_dsl.worlds.field.field import (
    BORDER,
    CENTRE_CIRCLE_RADIUS,
    GOAL_AREA_DEPTH,
    GOAL_AREA_HALF_WIDTH,
    GOAL_DEPTH,
    GOAL_HALF_WIDTH,
    HALF_LENGTH,
    HALF_WIDTH,
    PENALTY_AREA_DEPTH,
    PENALTY_AREA_HALF_WIDTH,
    PENALTY_MARK,
    POST_RADIUS,
)
from aseme_dsl.worlds.field.geometry import unit
from aseme_dsl.worlds.field.match import Match, RobotTruth
from aseme_dsl.worlds.field.percept import Posture
from aseme_dsl.worlds.field.robot import RADIUS
from aseme_dsl.worlds.field.trail import TrailPoint

BUILD_UP_NS = 8_000_000_000
"""The path of the ball before a goal is drawn boldly for so long."""
STRIP = 25
"""The characters of the field in a line of progress."""

_COLOURS = ("#1f4fd8", "#d8321f")

_NIGHT = (
    ("rect", "#11151a"),
    ("text", "#e6edf3"),
    ('[fill="#555555"]', "#a3adb8"),
    (f'[fill="{_COLOURS[0]}"]', "#7aa5ff"),
    (f'[fill="{_COLOURS[1]}"]', "#ff8a7a"),
)
"""What stands around the field, in colours for readers who prefer dark ones."""

_HEADER = 90
_LINE = 26


def progress(match: Match) -> str:
    """One line: the time, the score, the state of the game, and where along the field the ball is.

    ``0:43.7  Home 1:0 Visitors  PLAYING   [············|···o········]``: the ball is in the visitors' half.
    """
    truth = match.truth()
    cells = ["·"] * STRIP
    cells[STRIP // 2] = "|"
    share = (truth.ball.x + HALF_LENGTH) / (2 * HALF_LENGTH)
    cells[min(STRIP - 1, max(0, int(share * STRIP)))] = "o"
    return f"{clock(truth.time_ns)}  {match.result()}  {truth.state.name:8}  [{''.join(cells)}]"


def svg(match: Match) -> str:
    """The match so far as an SVG document: the field, the path of the ball, the goals, and the players.

    The whole path is drawn thinly, the last seconds before each goal boldly in the colour of the team that
    scored. The players stand where they are now: those of the first team as circles, the others as squares.
    """
    result, truth = match.result(), match.truth()
    width = 2 * (HALF_LENGTH + BORDER)
    height = 2 * (HALF_WIDTH + BORDER)
    below = max(len(result.goals), 1) * _LINE + 30
    night = "".join(f".aseme-match>{what}{{fill:{colour}}}" for what, colour in _NIGHT)
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.0f} {_HEADER + height + below:.0f}"'
        ' class="aseme-match" font-family="sans-serif">',
        f"<title>{escape(str(result))}</title>",
        f"<style>@media (prefers-color-scheme:dark){{{night}}}</style>",
        f'<rect width="{width:.0f}" height="{_HEADER + height + below:.0f}" fill="#ffffff"/>',
        *_heading(match, width),
        f'<g transform="translate({width / 2:.0f} {_HEADER + height / 2:.0f}) scale(1 -1)">',
        *_carpet(),
        *_paths(match.trail, "#0b3d16", 1.5, 0.55),
        *_build_ups(match, result.goals),
        *(line for robot in truth.robots for line in _robot(robot)),
        _circle(truth.ball.x, truth.ball.y, balls.RADIUS, 'fill="#ffffff" stroke="#000000" stroke-width="2"'),
        "</g>",
        *_goals(match, result.goals, _HEADER + height + 34.0),
        "</svg>",
    ]
    return "\n".join(lines) + "\n"


def _number(value: float) -> str:
    """A coordinate, to the tenth of a centimetre; never ``-0.0``."""
    return f"{round(value, 1) + 0.0:.1f}"


def _circle(x: float, y: float, radius: float, style: str) -> str:
    return f'<circle cx="{_number(x)}" cy="{_number(y)}" r="{_number(radius)}" {style}/>'


def _heading(match: Match, width: float) -> Iterator[str]:
    result, truth = match.result(), match.truth()
    middle = width / 2
    names = f"{escape(result.teams[0])} ●", f"■ {escape(result.teams[1])}"
    for team, (anchor, x) in enumerate((("end", middle - 70.0), ("start", middle + 70.0))):
        yield (
            f'<text x="{_number(x)}" y="46" font-size="36" text-anchor="{anchor}" fill="{_COLOURS[team]}">'
            f"{names[team]}</text>"
        )
    yield (
        f'<text x="{_number(middle)}" y="48" font-size="42" font-weight="bold" text-anchor="middle">'
        f"{result.score[0]} : {result.score[1]}</text>"
    )
    yield (
        f'<text x="{_number(middle)}" y="78" font-size="18" text-anchor="middle" fill="#555555">'
        f"{clock(truth.time_ns)} · {truth.state.name} · seed {match.seed}</text>"
    )


def _carpet() -> Iterator[str]:
    length, width = HALF_LENGTH + BORDER, HALF_WIDTH + BORDER
    yield _box(-length, -width, 2 * length, 2 * width, 'fill="#5fae6c"')
    yield '<g fill="none" stroke="#ffffff" stroke-width="5">'
    yield _box(-HALF_LENGTH, -HALF_WIDTH, 2 * HALF_LENGTH, 2 * HALF_WIDTH)
    yield f'<path d="M0 {_number(-HALF_WIDTH)}V{_number(HALF_WIDTH)}"/>'
    yield _circle(0.0, 0.0, CENTRE_CIRCLE_RADIUS, "")
    for side in (-1.0, 1.0):
        for depth, half in (
            (PENALTY_AREA_DEPTH, PENALTY_AREA_HALF_WIDTH),
            (GOAL_AREA_DEPTH, GOAL_AREA_HALF_WIDTH),
        ):
            left = -HALF_LENGTH if side < 0.0 else HALF_LENGTH - depth
            yield _box(left, -half, depth, 2 * half)
        yield _circle(side * (HALF_LENGTH - PENALTY_MARK), 0.0, 3.0, "")
    yield "</g>"
    for side in (-1.0, 1.0):
        left = -HALF_LENGTH - GOAL_DEPTH if side < 0.0 else HALF_LENGTH
        yield _box(
            left, -GOAL_HALF_WIDTH, GOAL_DEPTH, 2 * GOAL_HALF_WIDTH, 'fill="#ffffff" fill-opacity="0.4"'
        )
        for post in (-GOAL_HALF_WIDTH, GOAL_HALF_WIDTH):
            yield _circle(
                side * HALF_LENGTH, post, POST_RADIUS, 'fill="#ffffff" stroke="#777777" stroke-width="1"'
            )


def _box(x: float, y: float, width: float, height: float, style: str = "") -> str:
    size = f'width="{_number(width)}" height="{_number(height)}"'
    return f'<rect x="{_number(x)}" y="{_number(y)}" {size} {style}/>'


def _paths(trail: Iterable[TrailPoint], colour: str, width: float, opacity: float) -> Iterator[str]:
    """The path of the ball, as one element for each time that it was laid down and played."""
    style = f'fill="none" stroke="{colour}" stroke-width="{width}" stroke-opacity="{opacity}"'
    places: list[str] = []
    for point in trail:
        place = f"{_number(point.x)} {_number(point.y)}"
        if not places or places[-1] != place:
            places.append(place)
        if not point.rolling:
            if len(places) > 1:
                yield f'<path d="M{" L".join(places)}" {style} stroke-linejoin="round"/>'
            places = []
    if len(places) > 1:
        yield f'<path d="M{" L".join(places)}" {style} stroke-linejoin="round"/>'


def _build_ups(match: Match, goals: Iterable[Event]) -> Iterator[str]:
    for number, goal in enumerate(goals, start=1):
        team = match.result().teams.index(goal.team)
        before = [p for p in match.trail if goal.time_ns - BUILD_UP_NS <= p.time_ns <= goal.time_ns]
        # At the whistle the ball is noted where it lay and, at the same time, where it was carried to.
        end = next((i for i, p in enumerate(before) if p.time_ns == goal.time_ns), len(before) - 1)
        yield from _paths(before[: end + 1], _COLOURS[team], 5.0, 0.8)
        yield _circle(goal.x, goal.y, 13.0, f'fill="#ffffff" stroke="{_COLOURS[team]}" stroke-width="4"')
        yield _label(goal.x, goal.y, str(number), 18, _COLOURS[team])


def _label(x: float, y: float, text: str, size: int, colour: str = "#ffffff") -> str:
    # The drawing grows upwards, letters would be upside down.
    return (
        f'<text transform="translate({_number(x)} {_number(y)}) scale(1 -1)" y="{size * 0.36:.1f}" '
        f'font-size="{size}" font-weight="bold" fill="{colour}" text-anchor="middle">{text}</text>'
    )


def _robot(robot: RobotTruth) -> Iterator[str]:
    x, y = robot.pose.x, robot.pose.y
    c, s = unit(robot.pose.heading)
    nose_x, nose_y = _number(x + 1.9 * RADIUS * c), _number(y + 1.9 * RADIUS * s)
    style = f'stroke="{_COLOURS[robot.team]}" stroke-width="5"'
    yield f'<path d="M{_number(x)} {_number(y)} L{nose_x} {nose_y}" {style}/>'
    opacity = "0.5" if robot.penalised or robot.posture is not Posture.STANDING else "1"
    outline = "#ffd400" if robot.goalie else "#ffffff"
    name = escape(robot.name)
    style = f'fill="{_COLOURS[robot.team]}" fill-opacity="{opacity}" stroke="{outline}" stroke-width="2.5"'
    if robot.team == 0:
        place = f'cx="{_number(x)}" cy="{_number(y)}" r="{_number(RADIUS)}"'
        yield f"<circle {place} {style}><title>{name}</title></circle>"
    else:  # the teams differ in black and white, too
        place = f'x="{_number(x - RADIUS)}" y="{_number(y - RADIUS)}"'
        size = f'width="{_number(2 * RADIUS)}" height="{_number(2 * RADIUS)}"'
        yield f"<rect {place} {size} {style}><title>{name}</title></rect>"
    yield _label(x, y, str(robot.jersey), 15)


def _goals(match: Match, goals: tuple[Event, ...], top: float) -> Iterator[str]:
    if not goals:
        yield f'<text x="70" y="{_number(top)}" font-size="20" fill="#555555">no goals</text>'
    score = [0, 0]
    for number, goal in enumerate(goals, start=1):
        team = match.result().teams.index(goal.team)
        score[team] += 1
        who = escape(goal.robot) + (f" ({escape(goal.detail)})" if goal.detail else "")
        yield (
            f'<text x="70" y="{_number(top + (number - 1) * _LINE)}" font-size="20" fill="{_COLOURS[team]}">'
            f"{number}.  {clock(goal.time_ns)}  {score[0]}:{score[1]}  {who}</text>"
        )
