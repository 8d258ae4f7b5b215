"""Stand: stands still, and gets up first from sitting or lying."""

from monas.Kouretes.messages import Joints, Posture

from aseme_dsl.runtime import Context
from aseme_dsl.worlds.field import command


class Stand:
    def execute(self, context: Context) -> None:
        context.body.act(command.Command(command.Stand()))
        stands = False
        while not stands:
            context.wait(0.1)
            joints = context.read("body.state.Joints", Joints)
            stands = joints is not None and joints.posture == Posture.STANDING and not joints.busy
