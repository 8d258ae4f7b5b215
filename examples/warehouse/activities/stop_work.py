"""StopWork: the job was taken back, or the desk is gone; the wheels stand still already."""

from aseme_dsl.runtime import Context


class StopWork:
    def execute(self, context: Context) -> None:
        context.log("not wanted any more")
