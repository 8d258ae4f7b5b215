"""Sensors: what the robot feels of its own body."""

from monas.Kouretes.messages import Joints, Posture

from aseme_dsl.runtime import Context

from .knowledge import tell


class Sensors:
    def execute(self, context: Context) -> None:
        percept = context.body.sense()
        joints = Joints(percept.head, Posture(percept.posture), percept.busy, percept.ball_at_feet)
        tell(context, "body.state.Joints", joints)
