"""CloseJob: the porter is ready for the next job; how this one ended is in `ending`."""

from aseme_dsl.runtime import Context


class CloseJob:
    def execute(self, context: Context) -> None:
        context.log(context.get_variable("ending").name)
