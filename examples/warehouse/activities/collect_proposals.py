"""CollectProposals: so long the desk waits for proposals."""

from aseme_dsl.runtime import Context


class CollectProposals:
    def execute(self, context: Context) -> None:
        context.wait(1)
