"""Pay: gives away what was asked."""

from aseme_dsl.runtime import Context


class Pay:
    def execute(self, context: Context) -> None:
        context.wait(1)
        left = context.variable("budget") - context.variable("asked")
        context.set("budget", left)
        context.log(f"pays {context.variable('asked'):.0f}, has {left:.0f} left")
