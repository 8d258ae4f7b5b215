"""One robot: how it walks, turns its head, kicks, dives, sits, falls and gets up."""

from __future__ import annotations

from dataclasses import dataclass, field

from aseme_dsl.worlds.field import ball as balls
from aseme_dsl.worlds.field.command import Command, Dive, Kick, Motion, Sit, Stand, Walk
from aseme_dsl.worlds.field.geometry import Pose, clamp, length, unit, wrap
from aseme_dsl.worlds.field.percept import Posture

RADIUS = 12.0
"""cm; two robots touch at twice this distance."""
FORWARD_SPEED = 40.0
BACKWARD_SPEED = 25.0
SIDE_SPEED = 25.0
"""The fastest walk, in cm/s."""
TURN_SPEED = 90.0
"""degrees/s."""
ACCELERATION = 80.0
"""cm/s²."""
TURN_ACCELERATION = 360.0
"""degrees/s²."""
HEAD_LIMIT = 119.0
"""How far the head turns to each side, in degrees."""
HEAD_SPEED = 240.0
"""degrees/s."""

TOUCH = RADIUS + balls.RADIUS
"""The distance of the middles at which a robot touches the ball."""
FEET_REACH = 5.0
"""A ball at most this far from the feet can be kicked, cm."""
FEET_ANGLE = 30.0
"""… if it lies at most this far to one side, in degrees."""
KICK_SPEED = 240.0
"""The speed of the ball after the strongest kick, cm/s."""
KICK_ANGLE = 45.0
"""The directions into which a robot can kick, to each side of straight ahead."""
KICK_STRENGTH_NOISE = 0.06
"""The standard deviation of the ball's speed, as a share of it."""
KICK_ANGLE_NOISE = 3.0
"""The standard deviation of the ball's direction, degrees."""

MILLISECOND = 1_000_000
SWING_NS = 300 * MILLISECOND
"""From the beginning of a kick until the foot is where the ball should be."""
KICK_NS = 900 * MILLISECOND
DIVE_NS = 400 * MILLISECOND
DIVE_REACH = 40.0
"""How far beyond its middle a robot that dived covers the ground, cm."""
SIT_NS = 1000 * MILLISECOND
STAND_NS = 1000 * MILLISECOND
"""Getting up from sitting."""
GET_UP_NS = 3000 * MILLISECOND
"""Getting up from lying."""


@dataclass(slots=True)
class Robot:
    """The state of one robot. Places are those of the home team, whichever team it plays for."""

    name: str
    team: int
    """0: the home team, 1: the other."""
    jersey: int
    goalie: bool
    x: float = 0.0
    y: float = 0.0
    heading: float = 0.0
    forward: float = 0.0
    left: float = 0.0
    turn: float = 0.0
    """How it really walks: cm/s, cm/s, degrees/s."""
    vx: float = 0.0
    vy: float = 0.0
    """The same as a velocity over ground."""
    head: float = 0.0
    head_target: float = 0.0
    posture: Posture = Posture.STANDING
    dived: int = 0
    """Lying stretched out to the left (1), to the right (−1), or not (0)."""
    motion: Motion = field(default_factory=Stand)
    """The motion in force."""
    fresh: bool = False
    """It has not begun yet."""
    action: Motion | None = None
    """The motion that is done once and has not ended: a kick, a dive, sitting down, getting up."""
    action_began_ns: int = 0
    action_ends_ns: int = 0
    swung: bool = False
    """In the present kick, the foot has been where the ball should be."""
    penalised_until_ns: int | None = None

    @property
    def pose(self) -> Pose:
        """Where it stands."""
        return Pose(self.x, self.y, self.heading)

    @property
    def penalised(self) -> bool:
        """Whether the referee has taken it out."""
        return self.penalised_until_ns is not None

    def put(self, pose: Pose) -> None:
        """Set it down somewhere, standing still."""
        self.x, self.y, self.heading = pose.x, pose.y, pose.heading
        halt(self)

    def raise_up(self) -> None:
        """Set it on its feet, as a referee's assistant does."""
        self.posture, self.dived, self.action = Posture.STANDING, 0, None


def obey(robot: Robot, command: Command) -> None:
    """Put a command in force."""
    if command.motion is not None:
        robot.motion, robot.fresh = command.motion, True
    if command.head is not None:
        robot.head_target = clamp(command.head, HEAD_LIMIT)


def halt(robot: Robot) -> None:
    """Stop at once."""
    robot.forward = robot.left = robot.turn = robot.vx = robot.vy = 0.0


def fall(robot: Robot) -> None:
    """Fall over; a motion that went on is broken off."""
    robot.posture, robot.action, robot.dived = Posture.FALLEN, None, 0
    halt(robot)


def at_feet(robot: Robot, x: float, y: float) -> bool:
    """Whether a ball at (x, y) is where a kick of the robot hits it."""
    if robot.posture is not Posture.STANDING or length(x - robot.x, y - robot.y) > TOUCH + FEET_REACH:
        return False
    c, s = unit(robot.heading)
    ahead = (x - robot.x) * c + (y - robot.y) * s
    aside = (y - robot.y) * c - (x - robot.x) * s
    return ahead > 0.0 and abs(aside) * _FEET_COSINE <= ahead * _FEET_SINE


def move(robot: Robot, now_ns: int, seconds: float, free: bool) -> None:
    """Let a robot move for one step that ends at ``now_ns``; if not ``free``, it must not leave the spot."""
    turn_head = robot.head_target - robot.head
    if turn_head:
        robot.head += clamp(turn_head, HEAD_SPEED * seconds)
    if robot.action is not None and now_ns >= robot.action_ends_ns:
        _end(robot)
    if robot.fresh and robot.action is None:
        _begin(robot, now_ns, free)
    motion = robot.motion
    if free and type(motion) is Walk and robot.action is None and robot.posture is Posture.STANDING:
        _walk(robot, motion, seconds)
    elif robot.forward or robot.left or robot.turn:
        _walk(robot, _STILL, seconds)


def kick_now(robot: Robot, now_ns: int) -> Kick | None:
    """The kick whose foot is where the ball should be in this step, once a kick."""
    if robot.action is None or robot.swung or type(robot.action) is not Kick:
        return None
    if now_ns < robot.action_began_ns + SWING_NS:
        return None
    robot.swung = True
    return robot.action


def covers(robot: Robot, x: float, y: float) -> tuple[float, float]:
    """The point of the robot's middle line that is nearest to (x, y): its middle, unless it has dived."""
    if robot.dived == 0:
        return robot.x, robot.y
    c, s = unit(robot.heading + 90.0 * robot.dived)
    along = (x - robot.x) * c + (y - robot.y) * s
    along = 0.0 if along < 0.0 else DIVE_REACH if along > DIVE_REACH else along
    return robot.x + along * c, robot.y + along * s


_STILL = Walk()
_FEET_COSINE, _FEET_SINE = unit(FEET_ANGLE)


def _begin(robot: Robot, now_ns: int, free: bool) -> None:
    """Begin the motion in force, if the robot can do it now; else it stays to be begun."""
    motion = robot.motion
    standing = robot.posture is Posture.STANDING
    if isinstance(motion, Kick | Dive):
        if not (standing and free):
            return
        duration = KICK_NS if isinstance(motion, Kick) else DIVE_NS
    elif isinstance(motion, Stand):
        duration = 0 if standing else STAND_NS if robot.posture is Posture.SITTING else GET_UP_NS
    elif isinstance(motion, Sit):
        duration = 0 if robot.posture is Posture.SITTING else SIT_NS if standing else GET_UP_NS
    else:
        duration = 0
    robot.fresh = False
    if duration:
        robot.action, robot.swung = motion, False
        robot.action_began_ns, robot.action_ends_ns = now_ns, now_ns + duration
        if isinstance(motion, Dive):
            robot.dived = 1 if motion.left else -1
        elif not isinstance(motion, Kick):
            robot.dived = 0


def _end(robot: Robot) -> None:
    if isinstance(robot.action, Stand):
        robot.posture = Posture.STANDING
    elif isinstance(robot.action, Sit):
        robot.posture = Posture.SITTING
    elif isinstance(robot.action, Dive):
        robot.posture = Posture.FALLEN
    robot.action = None


def _walk(robot: Robot, wanted: Walk, seconds: float) -> None:
    """Come nearer to the wanted walk, as acceleration and speed allow, and walk for a moment."""
    change = ACCELERATION * seconds
    forward = wanted.forward
    forward = (
        FORWARD_SPEED
        if forward > FORWARD_SPEED
        else -BACKWARD_SPEED
        if forward < -BACKWARD_SPEED
        else forward
    )
    robot.forward += clamp(forward - robot.forward, change)
    robot.left += clamp(clamp(wanted.left, SIDE_SPEED) - robot.left, change)
    robot.turn += clamp(clamp(wanted.turn, TURN_SPEED) - robot.turn, TURN_ACCELERATION * seconds)
    robot.heading = wrap(robot.heading + robot.turn * seconds)
    c, s = unit(robot.heading)
    robot.vx, robot.vy = robot.forward * c - robot.left * s, robot.forward * s + robot.left * c
    robot.x += robot.vx * seconds
    robot.y += robot.vy * seconds
