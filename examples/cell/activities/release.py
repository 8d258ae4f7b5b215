"""Release: opens the gripper."""

from world import PLACES

from aseme_dsl.runtime import Context


class Release:
    def execute(self, context: Context) -> None:
        context.wait(0.3)
        context.body.open_gripper(into_tray=context.body.sense().position == PLACES["TRAY"])
