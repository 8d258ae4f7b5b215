"""Sense: tells what the room senses, and the hall what the house knows."""

from monas.SmartHome.messages import Button, House, Mode, Room

from aseme_dsl.runtime import Context


class Sense:
    def execute(self, context: Context) -> None:
        percept = context.body.sense()
        context.publish("room.state.Room", Room(percept.motion, percept.temperature, percept.lux))
        context.publish("home.state.House", House(Mode.AWAY if percept.away else Mode.HOME, percept.fire))
        if percept.pressed:
            context.publish("home.signal.Button", Button(True))
