"""Sense: tells what the robot senses."""

import math

from monas.NightWatch.messages import Battery, Intruder

from aseme_dsl.runtime import Context


class Sense:
    def execute(self, context: Context) -> None:
        percept = context.body.sense()
        context.publish("body.state.Battery", Battery(percept.battery))
        if percept.intruder is not None:
            distance = math.dist(percept.intruder, percept.place)
            context.publish("eyes.state.Intruder", Intruder(distance, 1.0 - distance / 50))
