"""ReportOutcome: how it went; Deliver has prepared it."""

from aseme_dsl.runtime import Context


class ReportOutcome:
    def execute(self, context: Context) -> None:
        context.log("done" if context.get_variable("succeeded") else "it did not work")
