"""What several activities read and write: messages in, places out, and a walk that minds the obstacles."""

from monas.Kouretes import TEAM, messages

from aseme_dsl.runtime import Context
from aseme_dsl.worlds.field import command, skills
from aseme_dsl.worlds.field.geometry import Point, Pose, place_of
from aseme_dsl.worlds.field.robot import RADIUS, SIDE_SPEED, TOUCH

PLAYERS = tuple(name for name, role in TEAM if role == "player")
"""The field players; the first one has the number 1."""

SECOND = 1_000_000_000


def own_pose(context: Context) -> Pose:
    """Where this robot believes to stand."""
    told = context.read("world.state.Pose", messages.Pose) or messages.Pose()
    return Pose(told.x, told.y, told.heading)


def ball_place(context: Context) -> Point | None:
    """Where on the field the ball is; None: nobody knows."""
    ball = context.read("vision.state.Ball", messages.Ball)
    if ball is None or not ball.visible:
        return None
    return place_of(own_pose(context), ball.distance + TOUCH, ball.bearing)


def mate_place(context: Context, number: int) -> Point | None:
    """Where a field player of the own team said to be within the last one and a half seconds."""
    if not 1 <= number <= len(PLAYERS):
        return None
    told = context.latest_sample("mates.state.Place", sender=PLAYERS[number - 1])
    if told is None or context.now_ns - told.time > 1.5 * SECOND:
        return None
    return Point(told.message.x, told.message.y)


def pass_place(ball: Point) -> Point:
    """Where a pass is played to and taken: ahead of the ball, on the side where there is more room."""
    return Point(min(ball.x + 230, 310), -110 if ball.y > 20 else 110)


def tell(context: Context, channel: str, message: object) -> None:
    """Publish a state if it has changed."""
    if context.latest_message(channel) != message:
        context.publish(channel, message)


def walk(context: Context, way: command.Walk, past_robots: bool = True) -> None:
    """Walk like this from now on, but past a robot that stands in the way."""
    if past_robots and way.forward > 0:
        free = context.read("world.state.Obstacles", messages.Obstacles)
        if free is not None and free.front < 4 * RADIUS:
            side = SIDE_SPEED if free.left > free.right else -SIDE_SPEED
            way = command.Walk(way.forward / 2, side, way.turn)
    context.publish("motion.signal.Walk", messages.Walk(way.forward, way.left, way.turn))


def kick(context: Context, shot: command.Kick) -> None:
    """Kick, and wait until the robot stands on both feet again."""
    context.publish("motion.signal.Kick", messages.Kick(shot.strength, shot.direction))
    context.wait(1.0)


def lined_up(context: Context, target: Point, turned: float = skills.AIM_ERROR) -> bool:
    """Whether the ball lies at the feet, and the target about straight behind it."""
    ball = context.read("vision.state.Ball", messages.Ball)
    joints = context.read("body.state.Joints", messages.Joints)
    place = ball_place(context)
    if ball is None or place is None or joints is None:
        return False
    if not joints.ball_at_feet or ball.distance > 5 or abs(ball.bearing) > 8:
        return False
    return abs(skills.aim_error(own_pose(context), place, target)) < turned
