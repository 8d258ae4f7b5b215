"""Localization: where the robot believes to stand."""

from monas.Kouretes.messages import Pose

from aseme_dsl.runtime import Context
from aseme_dsl.worlds.field.field import GOAL_HALF_WIDTH, HALF_LENGTH
from aseme_dsl.worlds.field.geometry import Point, distance

OWN_POSTS = (Point(-HALF_LENGTH, GOAL_HALF_WIDTH), Point(-HALF_LENGTH, -GOAL_HALF_WIDTH))


class Localization:
    def execute(self, context: Context) -> None:
        pose = context.body.sense().pose
        to_post = min(distance(pose, post) for post in OWN_POSTS)
        context.publish("world.state.Pose", Pose(pose.x, pose.y, pose.heading, 1.0, to_post))
