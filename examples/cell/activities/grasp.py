"""Grasp: closes the gripper, and says whether the part is in it."""

from aseme_dsl.runtime import Context


class Grasp:
    def execute(self, context: Context) -> str:
        context.wait(0.5)
        return "held" if context.body.close_gripper() else "slipped"
