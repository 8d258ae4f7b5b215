"""ObstacleAvoidance: how far it is free ahead and to both sides, up to the ball."""

from monas.Kouretes.messages import Obstacles

from aseme_dsl.runtime import Context

from .knowledge import tell

FAR = 400.0


class ObstacleAvoidance:
    def execute(self, context: Context) -> None:
        percept = context.body.sense()
        ball = FAR if percept.ball is None else percept.ball.distance
        near = [robot for robot in percept.robots if robot.distance < ball]
        front = [robot.distance for robot in near if abs(robot.bearing) <= 40]
        left = [robot.distance for robot in near if 0 < robot.bearing < 120]
        right = [robot.distance for robot in near if -120 < robot.bearing <= 0]
        free = Obstacles(*(min(side, default=FAR) for side in (front, left, right)))
        tell(context, "world.state.Obstacles", free)
