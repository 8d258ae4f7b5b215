"""WriteMinutes: says when the meeting was."""

from aseme_dsl.runtime import Context


class WriteMinutes:
    def execute(self, context: Context) -> None:
        context.log(f"the meeting of {context.agent} was at {context.get_variable('hour')}")
