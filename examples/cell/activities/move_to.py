"""MoveTo: until the arm is there."""

from monas.Cells.messages import Place
from world import PLACES

from aseme_dsl.runtime import Context


class MoveTo:
    def execute(self, context: Context, goal: Place) -> None:
        target = PLACES[goal.name]
        context.body.act(target)
        while context.body.sense().position != target:
            context.wait(0.05)
