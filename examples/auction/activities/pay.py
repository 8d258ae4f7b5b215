"""Pay: gives away what was asked."""

from aseme_dsl.runtime import Context


class Pay:
    def execute(self, context: Context) -> None:
        context.wait(1)
        left = context.get_variable("budget") - context.get_variable("asked")
        context.set_variable("budget", left)
        context.log(f"pays {context.get_variable('asked'):.0f}, has {left:.0f} left")
