"""RobotController: what the referee signals, and who this robot is."""

from monas.Kouretes.messages import GameState, Identity, PlayerState, SetPlay

from aseme_dsl.runtime import Context

from .knowledge import tell


class RobotController:
    def execute(self, context: Context) -> None:
        percept = context.body.sense()
        game = percept.game
        tell(context, "my.state.Identity", Identity(percept.jersey, percept.team))
        tell(
            context,
            "game.state.GameState",
            GameState(
                player_state=PlayerState(game.state),
                game_state=PlayerState(game.game_state),
                half=game.half,
                seconds_remaining=game.seconds_remaining,
                own_score=game.own_score,
                other_score=game.other_score,
                own_kick_off=game.own_kick_off,
                set_play=SetPlay(game.set_play),
                own_set_play=game.own_set_play,
            ),
        )
