"""Report: tells the guard's office where somebody was."""

from aseme_dsl.runtime import Context


class Report:
    def execute(self, context: Context) -> None:
        context.body.act(None)
        context.wait(1)
        context.body.house.report(context.agent)
