"""NoGame: while the ball is not in play, the robot goes to its place for the kick-off, and stands."""

from monas.Kouretes.messages import GameState, PlayerState

from aseme_dsl.runtime import Context
from aseme_dsl.worlds.field import command, skills

from .knowledge import own_pose, walk


class NoGame:
    def execute(self, context: Context) -> None:
        game = context.read("game.state.GameState", GameState)
        if game is not None and game.player_state == PlayerState.READY:
            place = context.body.sense().kick_off_place
            walk(context, skills.walk_to(own_pose(context), place, place.heading))
        else:
            walk(context, command.Walk())
        context.wait(0.1)
