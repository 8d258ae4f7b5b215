"""WalkTowardsOpponentGoal: to the place where a pass can be taken, or until one comes."""

from aseme_dsl.runtime import Context
from aseme_dsl.worlds.field import command, skills
from aseme_dsl.worlds.field.geometry import Pose, towards

from .knowledge import ball_place, own_pose, pass_place, walk


class WalkTowardsOpponentGoal:
    def execute(self, context: Context) -> None:
        arrived = False
        while not arrived:
            ball = ball_place(context)
            if ball is None or context.latest_message("team.signal.Pass") is not None:
                return
            spot = pass_place(ball)
            place = Pose(spot.x, spot.y, towards(spot, ball))
            walk(context, skills.walk_to(own_pose(context), place, place.heading))
            context.wait(0.1)
            arrived = skills.at_place(own_pose(context), place, near=25.0, turned=20.0)
        walk(context, command.Walk())
