"""LearnOutcome: what is not at the gate is announced again."""

from monas.Warehouse.messages import Ending
from world import Close

from aseme_dsl.runtime import Context

REASONS = {
    Ending.REFUSED: "nobody is free",
    Ending.NOBODY: "nobody answers",
    Ending.NOT_UNDERSTOOD: "nobody answers",
    Ending.LOST: "the carrier is lost",
    Ending.CANCELLED: "it took too long",
    Ending.TIMED_OUT: "it took too long",
}


class LearnOutcome:
    def execute(self, context: Context) -> None:
        clerk = context.label.rpartition(".")[0]
        ending = context.get_variable("ending")
        told = context.last_received("inform", "Outcome") or context.last_received("failure", "Outcome")
        if ending is Ending.DONE:
            context.body.act(Close(clerk, True, told.sender))
            return
        context.wait(2)
        context.body.act(
            Close(clerk, False, told.content.detail if ending is Ending.FAILED else REASONS[ending])
        )
