"""The other team, if no program drives it: a modest game of one chaser, supporters and a keeper.

It knows where the ball is without looking, but walks slowly, shoots at the middle of the goal and never
passes.
"""

from __future__ import annotations

from collections.abc import Sequence

from aseme_dsl.worlds.field.ball import Ball
from aseme_dsl.worlds.field.command import Command, Motion, Stand, Walk
from aseme_dsl.worlds.field.field import OPPONENTS_GOAL, in_own_penalty_area
from aseme_dsl.worlds.field.geometry import Point, Pose, distance, turned
from aseme_dsl.worlds.field.percept import PlayerState, Posture
from aseme_dsl.worlds.field.robot import Robot, at_feet
from aseme_dsl.worlds.field.skills import (
    AIM_ERROR,
    aim_error,
    clear,
    keeper_place,
    kick,
    line_up,
    support_place,
    walk_to,
)

DECIDE_NS = 100_000_000
"""How often the team thinks."""
SPEED = 0.6
"""Its pace, as a share of what a robot can walk."""
SHOT_BEYOND = 60.0
"""Its shots roll this far past the goal line, cm."""


def decide(
    robots: Sequence[Robot], ball: Ball, state: PlayerState, places: dict[str, Pose]
) -> list[tuple[Robot, Command]]:
    """What each robot of one team does next; ``places`` are its places for the kick-off, as it sees them."""
    in_play = [robot for robot in robots if not robot.penalised and robot.action is None]
    if not in_play:
        return []
    if state is PlayerState.READY:
        return [(robot, Command(_up(robot) or _go(robot, places[robot.name]))) for robot in in_play]
    if state is not PlayerState.PLAYING:
        return []
    spot = Point(ball.x, ball.y)
    if in_play[0].team == 1:
        spot = turned(Pose(ball.x, ball.y)).point
    field_players = [robot for robot in in_play if not robot.goalie]
    standing = [robot for robot in field_players if robot.posture is Posture.STANDING]
    chaser = min(standing, key=lambda robot: distance(_pose(robot), spot), default=None)
    waiting = 0
    commands: list[tuple[Robot, Command]] = []
    for robot in in_play:
        up = _up(robot)
        if up is not None:
            motion: Motion = up
        elif robot.goalie:
            motion = _keep(robot, ball, spot)
        elif robot is chaser:
            motion = _chase(robot, ball, spot)
        else:
            waiting += 1
            motion = _go(robot, support_place(spot, waiting))
        commands.append((robot, Command(motion)))
    return commands


def _pose(robot: Robot) -> Pose:
    """Where a robot is, as its own team sees the field."""
    return robot.pose if robot.team == 0 else turned(robot.pose)


def _up(robot: Robot) -> Stand | None:
    return None if robot.posture is Posture.STANDING else Stand()


def _go(robot: Robot, place: Pose) -> Walk:
    return walk_to(_pose(robot), place, place.heading, SPEED)


def _chase(robot: Robot, ball: Ball, spot: Point) -> Motion:
    pose = _pose(robot)
    if at_feet(robot, ball.x, ball.y) and abs(aim_error(pose, spot, OPPONENTS_GOAL)) <= AIM_ERROR:
        return kick(pose, spot, OPPONENTS_GOAL, SHOT_BEYOND)
    return line_up(pose, spot, OPPONENTS_GOAL, SPEED)


def _keep(robot: Robot, ball: Ball, spot: Point) -> Motion:
    """Stay in the goal; go for a ball that comes to rest in the penalty area, and kick it out."""
    pose = _pose(robot)
    if in_own_penalty_area(spot) and ball.speed < 20.0:
        if at_feet(robot, ball.x, ball.y) and abs(pose.heading) < 90.0:
            return clear(pose, spot)
        return line_up(pose, spot, OPPONENTS_GOAL, SPEED)
    return _go(robot, keeper_place(spot))
