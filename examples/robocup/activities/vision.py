"""Vision: where the ball is. What was seen lately, or what a mate tells, counts until it is too old."""

from monas.Kouretes.messages import Ball, BallPlace, BallTrack

from aseme_dsl.runtime import Context
from aseme_dsl.worlds.field import skills
from aseme_dsl.worlds.field.geometry import Point, bearing, distance

from .knowledge import SECOND

REMEMBERED = 2.5 * SECOND
BELIEVED = 1.0 * SECOND
"""How long the place counts that somebody else has told."""


class Vision:
    def execute(self, context: Context) -> None:
        percept = context.body.sense()
        seen = percept.ball
        if seen is not None:
            gap = skills.gap(seen.distance)
            place = skills.ball_place(percept)
            context.publish("vision.data.BallTrack", BallTrack(gap, seen.bearing))
            context.publish("memory.state.BallPlace", BallPlace(place.x, place.y))
            context.publish("vision.state.Ball", Ball(True, gap, seen.bearing, seen.speed))
            return
        place = self.known(context)
        if place is not None:
            gap = skills.gap(distance(percept.pose, place))
            context.publish("vision.state.Ball", Ball(True, gap, bearing(percept.pose, place)))
        else:
            context.publish("vision.state.Ball", Ball(visible=False))

    def known(self, context: Context) -> Point | None:
        for channel, lasts in (("memory.state.BallPlace", REMEMBERED), ("mates.state.BallPlace", BELIEVED)):
            told = context.latest_sample(channel)
            if told is not None and context.now_ns - told.time <= lasts:
                return Point(told.message.x, told.message.y)
        return None
