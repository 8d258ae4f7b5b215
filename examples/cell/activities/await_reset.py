"""AwaitReset: until the operator lets go of the button; the statechart sees it."""

from aseme_dsl.runtime import Context


class AwaitReset:
    def execute(self, context: Context) -> None:
        context.wait(3600)
