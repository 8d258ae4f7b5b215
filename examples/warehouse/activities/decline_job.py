"""DeclineJob: nothing to be done; the desk has been told."""

from aseme_dsl.runtime import Context


class DeclineJob:
    def execute(self, context: Context) -> None:
        context.log("not now")
