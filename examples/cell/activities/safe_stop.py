"""SafeStop: the arm stands still, the gripper keeps what it holds."""

from aseme_dsl.runtime import Context


class SafeStop:
    def execute(self, context: Context) -> None:
        context.body.act(None)
