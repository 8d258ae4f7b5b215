"""AssignRoles: who is nearest to the ball becomes center, who of the others is foremost center_for."""

from monas.Kouretes.messages import Assignment, Pass

from aseme_dsl.runtime import Context
from aseme_dsl.worlds.field.geometry import Point, distance

from .knowledge import PLAYERS, SECOND, mate_place

RENEWED = 0.35
"""An assignment is void if it is not repeated; it is repeated after so many seconds."""
VOID = 1.5
"""After so many seconds without a message, nobody believes to be the center any more; see "one center"."""
NEARER = 50.0
"""A robot takes over from the center if it is nearer by this, cm: else they would change all the time."""


class AssignRoles:
    def execute(self, context: Context) -> None:
        last = context.read("team.state.Assignment", Assignment)
        if last is None:
            # It begins, perhaps anew after a crash: then the center from before still believes to be one.
            last = Assignment()
            context.publish("team.state.Assignment", last)
            context.wait(VOID)
        if context.read("team.signal.Pass", Pass) is not None:
            for _ in range(8):  # while a pass is under way, everybody keeps to his part
                context.publish("team.state.Assignment", last)
                context.wait(RENEWED)
        wanted = self.wanted(context, last)
        if wanted is None:
            return
        if last.center not in (0, wanted.center):
            # The center may not hear that it is one no more. It knows when its assignment has become void.
            context.publish("team.state.Assignment", Assignment(0, wanted.center_for))
            context.wait(VOID)
        context.publish("team.state.Assignment", wanted)

    def wanted(self, context: Context, last: Assignment) -> Assignment | None:
        told = context.latest_sample("mates.state.BallPlace")
        if told is None or context.now_ns - told.time > 1.5 * SECOND:
            return None
        ball = Point(told.message.x, told.message.y)
        places = {
            number: place
            for number in range(1, len(PLAYERS) + 1)
            if (place := mate_place(context, number)) is not None
        }
        away = {
            number: distance(place, ball) - (NEARER if number == last.center else 0.0)
            for number, place in places.items()
        }
        if not away:
            return None
        center = min(away, key=away.__getitem__)
        if last.center_for in places and last.center_for != center:
            return Assignment(center, last.center_for)
        others = {number: place.x for number, place in places.items() if number != center}
        return Assignment(center, max(others, key=others.__getitem__, default=0))
