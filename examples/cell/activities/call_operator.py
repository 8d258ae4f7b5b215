"""CallOperator: somebody should have a look."""

from aseme_dsl.runtime import Context


class CallOperator:
    def execute(self, context: Context) -> None:
        context.log("please look after the gripper")
        context.wait(2)
