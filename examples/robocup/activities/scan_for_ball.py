"""ScanForBall: looks to and fro; a player walks to where it sees more, a keeper to its goal."""

from monas.Kouretes.messages import Gaze

from aseme_dsl.runtime import Context
from aseme_dsl.worlds.field import skills
from aseme_dsl.worlds.field.field import CENTRE

from .knowledge import own_pose, walk


class ScanForBall:
    def execute(self, context: Context) -> None:
        context.publish("head.state.Gaze", Gaze(at_ball=False))
        percept = context.body.sense()
        if percept.goalie:
            place = skills.keeper_place(CENTRE)
            walk(context, skills.walk_to(own_pose(context), place, place.heading))
        else:
            turn = percept.jersey % 2 * skills.SEARCH_NS  # half of the team looks in the other half
            walk(context, skills.search(own_pose(context), context.now_ns + turn))
        context.wait(0.1)
