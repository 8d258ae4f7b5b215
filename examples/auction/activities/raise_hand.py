"""RaiseHand: holds up a hand; the claim itself is sent in `control`."""

from aseme_dsl.runtime import Context


class RaiseHand:
    def execute(self, context: Context) -> None:
        context.wait(0.1)
