"""Stand: until the statechart wants something else."""

from aseme_dsl.runtime import Context


class Stand:
    def execute(self, context: Context) -> None:
        context.wait(3600)
