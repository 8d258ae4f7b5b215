"""Sense: tells what the keeper senses."""

import math

from monas.Keeper.messages import Ball, BallTrack, GameState, PlayerState, Pose

from aseme_dsl.runtime import Context


class Sense:
    def execute(self, context: Context) -> None:
        percept = context.body.sense()
        (x, y), (ball_x, ball_y) = percept.place, percept.ball
        state = PlayerState.PENALISED if percept.penalised else PlayerState.PLAYING
        context.publish("game.state.GameState", GameState(player_state=state, game_state=PlayerState.PLAYING))
        context.publish("world.state.Pose", Pose(x, y))
        distance = math.dist(percept.place, percept.ball)
        bearing = math.degrees(math.atan2(ball_y - y, ball_x - x))
        context.publish("vision.state.Ball", Ball(distance < 240, distance, bearing, percept.speed))
        context.publish("vision.data.BallTrack", BallTrack(distance, bearing))
