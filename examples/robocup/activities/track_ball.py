"""TrackBall: from now on the head follows the ball."""

from monas.Kouretes.messages import Gaze

from aseme_dsl.runtime import Context


class TrackBall:
    def execute(self, context: Context) -> None:
        context.publish("head.state.Gaze", Gaze(at_ball=True))
