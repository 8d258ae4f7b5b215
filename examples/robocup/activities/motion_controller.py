"""MotionController: gives the legs what the other activities want them to do."""

from monas.Kouretes.messages import Kick, Walk

from aseme_dsl.runtime import Context
from aseme_dsl.worlds.field import command


class MotionController:
    def execute(self, context: Context) -> None:
        walk = context.read("motion.signal.Walk", Walk)
        kick = context.read("motion.signal.Kick", Kick)
        if kick is not None:
            context.body.act(command.Command(command.Kick(kick.strength, kick.direction)))
        elif walk is not None:
            context.body.act(command.Command(command.Walk(walk.forward, walk.left, walk.turn)))
