"""TellMates: says by radio where this robot is and where it sees the ball. Who cannot play is silent."""

from monas.Kouretes.messages import GameState, Joints, Place, PlayerState, Posture

from aseme_dsl.runtime import Context

from .knowledge import SECOND, own_pose


class TellMates:
    def execute(self, context: Context) -> None:
        game = context.read("game.state.GameState", GameState)
        joints = context.read("body.state.Joints", Joints)
        if game is None or game.player_state != PlayerState.PLAYING:
            return
        if joints is None or joints.posture != Posture.STANDING:
            return
        pose = own_pose(context)
        context.publish("mates.state.Place", Place(pose.x, pose.y))
        ball = context.latest_sample("memory.state.BallPlace")
        if ball is not None and context.now_ns - ball.time < SECOND / 2:
            context.publish("mates.state.BallPlace", ball.message)
