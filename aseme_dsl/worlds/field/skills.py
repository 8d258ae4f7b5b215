"""What a player's activities need to calculate: from what was sensed to what to do, as pure functions.

Every function takes plain values of :mod:`~aseme_dsl.worlds.field.percept` (or what an activity remembers
of them) and gives a place, a yes or no, or a motion; none keeps anything. A turn of a loop that plays::

    percept = body.sense()
    ball = ball_place(percept)
    if ball is None:
        body.act(Command(search(percept.pose, percept.time_ns), scan(percept.time_ns)))
    else:
        body.act(Command(attack(percept, ball, aim(percept, ball)), look_at(percept.pose, ball)))

A better player remembers for some seconds where the ball was: now and then it is missed in a picture.

Places are those of the own team: cm, x towards the opponents' goal; directions are degrees, left positive.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from aseme_dsl.worlds.field.ball import DECELERATION
from aseme_dsl.worlds.field.command import Dive, Kick, Motion, Stand, Walk
from aseme_dsl.worlds.field.field import (
    CENTRE_CIRCLE_RADIUS,
    GOAL_HALF_WIDTH,
    HALF_LENGTH,
    HALF_WIDTH,
    OPPONENTS_GOAL,
    OWN_GOAL,
    PENALTY_AREA_DEPTH,
    PENALTY_MARK,
)
from aseme_dsl.worlds.field.geometry import (
    Point,
    Pose,
    bearing,
    clamp,
    distance,
    place_of,
    towards,
    unit,
    wrap,
)
from aseme_dsl.worlds.field.percept import BallSeen, Percept, Posture, RobotSeen, SetPlay
from aseme_dsl.worlds.field.robot import (
    FORWARD_SPEED,
    HEAD_LIMIT,
    KICK_ANGLE,
    KICK_SPEED,
    RADIUS,
    SIDE_SPEED,
    TOUCH,
    TURN_SPEED,
)

AIM_ERROR = 25.0
"""A robot that stands turned away from its aim by no more than this kicks round the rest, degrees."""
SEARCH_NS = 18_000_000_000
"""How long a robot looks for the ball in one half before it goes to the other."""
NARROW = 8.0
"""A goal that is seen under a smaller angle is not worth a shot, degrees."""
CIRCLE = 40.0
"""The distance from the ball at which a robot walks round it, cm."""
NEAR = 75.0
"""Nearer than this to a place, a robot walks sideways rather than turning first, cm."""


# ---- looking --------------------------------------------------------------------------------------------


def scan(time_ns: int, period_ns: int = 4_000_000_000) -> float:
    """Where to point the head in search of the ball: to and fro, as far as it goes, once a period."""
    phase = time_ns % period_ns / period_ns
    return HEAD_LIMIT * (4.0 * abs(phase - 0.5) - 1.0)


def search(pose: Pose, time_ns: int) -> Walk:
    """How to walk in search of a ball that the head alone does not find.

    From the middle of each half a robot sees as far as the lines: it goes to the one and to the other by
    turns, and looks round there. (If half of a team adds :data:`SEARCH_NS` to the time, they part.)
    """
    side = 1.0 if time_ns // SEARCH_NS % 2 else -1.0
    spot = Point(side * HALF_LENGTH / 2, 0.0)
    if distance(pose, spot) > 30.0:
        return walk_to(pose, spot)
    return Walk(turn=TURN_SPEED / 2)


def look_at(pose: Pose, place: Point | Pose) -> float:
    """Where to point the head to have a place in the middle of the picture."""
    return clamp(bearing(pose, place), HEAD_LIMIT)


def ball_place(percept: Percept) -> Point | None:
    """Where on the field the ball is that the robot sees, or None."""
    if percept.ball is None:
        return None
    return place_of(percept.pose, percept.ball.distance, percept.ball.bearing)


def gap(ball_distance: float) -> float:
    """The free distance in cm between the feet and a ball; the distance seen is between the middles."""
    return max(0.0, ball_distance - TOUCH)


# ---- walking --------------------------------------------------------------------------------------------


def walk_to(pose: Pose, place: Point | Pose, heading: float | None = None, speed: float = 1.0) -> Walk:
    """Walk to a place and stop there, in the end with a heading (None: any).

    From afar the robot turns and walks straight on; near the place it walks sideways, too. ``speed`` is a
    share of the fastest walk.
    """
    away = distance(pose, place)
    aside = bearing(pose, place)
    if away > NEAR:
        c, _ = unit(aside)
        return Walk(FORWARD_SPEED * speed * max(0.0, c) ** 2, 0.0, 3.0 * aside)
    pace = min(FORWARD_SPEED * speed, 2.0 * away) if away > 2.0 else 0.0
    c, s = unit(aside)
    turn = 0.0 if heading is None else 3.0 * wrap(heading - pose.heading)
    return Walk(pace * c, pace * s, turn)


def at_place(pose: Pose, place: Pose, near: float = 15.0, turned: float = 15.0) -> bool:
    """Whether a robot stands within ``near`` cm of a place and within ``turned`` degrees of its heading."""
    return distance(pose, place) <= near and abs(wrap(place.heading - pose.heading)) <= turned


def avoid(walk: Walk, robots: Sequence[RobotSeen], ball_distance: float | None = None) -> Walk:
    """The same walk, but past a robot that stands in the way (unless the ball lies this side of it)."""
    for robot in robots:
        if robot.distance > 4 * RADIUS or abs(robot.bearing) > 40.0 or walk.forward <= 0.0:
            continue
        if ball_distance is not None and ball_distance < robot.distance:
            continue
        side = -1.0 if robot.bearing > 0.0 else 1.0
        return Walk(walk.forward / 2, SIDE_SPEED * side, walk.turn)
    return walk


def line_up(pose: Pose, ball: Point, target: Point, speed: float = 1.0) -> Walk:
    """Walk to where the ball lies at the feet and the target straight behind it.

    From afar the robot walks to a spot behind the ball, in a bow if it comes from the front. Near the ball it
    faces it, circles round it at a distance, and closes in as it gets behind it.
    """
    away = distance(pose, ball)
    aim_direction = towards(ball, target)
    astray = wrap(towards(pose, ball) - aim_direction)
    if away > NEAR:
        x, y = unit(aim_direction)
        spot = Point(ball.x - CIRCLE * x, ball.y - CIRCLE * y)
        if abs(astray) > 90.0:
            side = CIRCLE if astray < 0.0 else -CIRCLE
            spot = Point(ball.x - side * y, ball.y + side * x)
        return walk_to(pose, spot, None, speed)
    facing = bearing(pose, ball)
    closeness = TOUCH + 1.0 if abs(astray) < AIM_ERROR else CIRCLE
    inwards = clamp(2.0 * (away - closeness), FORWARD_SPEED * speed)
    round_it = clamp(0.8 * astray, SIDE_SPEED * speed)
    c, s = unit(facing)
    return Walk(inwards * c - round_it * s, inwards * s + round_it * c, 4.0 * facing)


# ---- kicking --------------------------------------------------------------------------------------------


def strength_for(roll: float) -> float:
    """How strong to kick so that the ball rolls that many cm; 1 if it cannot roll so far."""
    return min(1.0, max(0.05, math.sqrt(2.0 * DECELERATION * max(0.0, roll)) / KICK_SPEED))


def aim_error(pose: Pose, ball: Point, target: Point) -> float:
    """By how much a robot would have to turn left for a straight kick to send the ball at the target."""
    return wrap(towards(ball, target) - pose.heading)


def can_kick(percept: Percept, ball: Point, target: Point) -> bool:
    """Whether the ball is at the feet, and the target in front."""
    return (
        percept.ball_at_feet and not percept.busy and abs(aim_error(percept.pose, ball, target)) <= AIM_ERROR
    )


def kick(pose: Pose, ball: Point, target: Point, beyond: float = 0.0) -> Kick:
    """A kick that sends the ball at the target and ``beyond`` cm further."""
    turn = clamp(aim_error(pose, ball, target), KICK_ANGLE)
    return Kick(strength_for(distance(ball, target) + beyond), turn)


def aim(percept: Percept, ball: Point) -> Point:
    """Where to shoot: where in the opponents' goal the robots that are seen leave most room.

    From beside the goal, where it is too narrow to hit, the penalty mark: there a team mate may wait.
    """
    left, right = Point(HALF_LENGTH, GOAL_HALF_WIDTH), Point(HALF_LENGTH, -GOAL_HALF_WIDTH)
    if abs(wrap(towards(ball, left) - towards(ball, right))) < NARROW:
        return Point(HALF_LENGTH - PENALTY_MARK, 0.0)
    seen = [place_of(percept.pose, robot.distance, robot.bearing) for robot in percept.robots]
    before = [robot for robot in seen if robot.x > ball.x]
    best, room = OPPONENTS_GOAL, -1.0
    for y in (0.0, 25.0, -25.0, 50.0, -50.0):
        target = Point(HALF_LENGTH, y)
        line = towards(ball, target)
        free = min((abs(wrap(towards(ball, robot) - line)) for robot in before), default=90.0)
        # A little more room beside the middle is not worth the risk of the post.
        free = min(free, 30.0) - abs(y) / 10.0
        if free > room:
            best, room = target, free
    return best


def shoot(pose: Pose, ball: Point, target: Point = OPPONENTS_GOAL) -> Kick:
    """A kick at what :func:`aim` chose: a shot at goal goes hard, a cross comes to rest."""
    return kick(pose, ball, target, beyond=250.0 if target.x >= HALF_LENGTH else 20.0)


def pass_to(pose: Pose, ball: Point, mate: Point | Pose) -> Kick:
    """A pass that comes to rest a little behind a team mate."""
    return kick(pose, ball, Point(mate.x, mate.y), beyond=30.0)


def kick_off(pose: Pose, ball: Point) -> Kick:
    """A kick that plays the ball just out of the centre circle: a shot from there would not count."""
    ahead = Point(ball.x + CENTRE_CIRCLE_RADIUS, ball.y)
    return kick(pose, ball, ahead, beyond=25.0)


def clear(pose: Pose, ball: Point) -> Kick:
    """Kick the ball away from the own goal, as far and as straight outwards as the robot stands."""
    return Kick(1.0, clamp(wrap(towards(OWN_GOAL, ball) - pose.heading), KICK_ANGLE))


# ---- playing --------------------------------------------------------------------------------------------


def recover(percept: Percept) -> Motion | None:
    """Get up, if the robot lies or sits and is not yet getting up; else None."""
    return Stand() if percept.posture is not Posture.STANDING and not percept.busy else None


def attack(percept: Percept, ball: Point, target: Point = OPPONENTS_GOAL, speed: float = 1.0) -> Motion:
    """Get up, line up behind the ball, and shoot it at the target: the whole of a simple striker.

    From the kick-off, from where no goal counts, it plays the ball a little ahead instead.
    """
    up = recover(percept)
    if up is not None:
        return up
    if can_kick(percept, ball, target):
        if percept.game.set_play is SetPlay.KICK_OFF:
            return kick_off(percept.pose, ball)
        return shoot(percept.pose, ball, target)
    walk = line_up(percept.pose, ball, target, speed)
    return avoid(walk, percept.robots, distance(percept.pose, ball))


def seconds_to_ball(pose: Pose, ball: Point) -> float:
    """About how long a robot needs to the ball: what team mates compare to agree who goes."""
    return distance(pose, ball) / FORWARD_SPEED + abs(bearing(pose, ball)) / TURN_SPEED


def support_place(ball: Point, number: int) -> Pose:
    """Where a player without the ball waits: ahead of it, behind it on the left or right, by its number."""
    ahead, aside = ((120.0, 90.0), (-120.0, 100.0), (-120.0, -100.0))[number % 3]
    side = -1.0 if ball.y > 0.0 and ahead > 0.0 else 1.0
    x = clamp(ball.x + ahead, HALF_LENGTH - PENALTY_AREA_DEPTH / 2)
    y = clamp(ball.y + aside * side, HALF_WIDTH - 50.0)
    return Pose(x, y, towards(Point(x, y), ball))


def keeper_place(ball: Point) -> Pose:
    """Where a keeper stands: before its goal, on the line to the ball."""
    line = towards(OWN_GOAL, ball)
    _, s = unit(line)
    y = clamp(60.0 * s, GOAL_HALF_WIDTH - RADIUS - 8.0)
    place = Point(25.0 - HALF_LENGTH, y)
    return Pose(place.x, place.y, clamp(towards(place, ball), 60.0))


def crossing(ball: BallSeen) -> tuple[float, float] | None:
    """In how many seconds, and how many cm to the left, a rolling ball will pass; None: it will not."""
    c, s = unit(ball.bearing)
    ahead, aside = ball.distance * c, ball.distance * s
    speed = ball.speed
    if ball.velocity_forward >= -20.0 or ahead <= 0.0:
        return None
    # It slows down by the same share in both directions, so it stays on its line as long as it rolls.
    path = ahead * speed / -ball.velocity_forward
    left = speed * speed - 2.0 * DECELERATION * path
    if left < 0.0:
        return None
    return (
        speed - math.sqrt(left)
    ) / DECELERATION, aside + ball.velocity_left * ahead / -ball.velocity_forward


def save(percept: Percept) -> Dive | None:
    """A dive before a ball that would pass the keeper soon and within reach, else None."""
    if percept.ball is None or percept.busy or percept.posture is not Posture.STANDING:
        return None
    passes = crossing(percept.ball)
    if passes is None:
        return None
    seconds, left = passes
    if seconds > 0.9 or not TOUCH < abs(left) < 60.0:
        return None
    return Dive(left=left > 0.0)
