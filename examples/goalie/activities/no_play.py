"""NoPlay: stands still."""

from aseme_dsl.runtime import Context


class NoPlay:
    def execute(self, context: Context) -> None:
        context.body.act(None)
