"""Watch: tells where the operator's button is."""

from monas.Cells.messages import Safety

from aseme_dsl.runtime import Context


class Watch:
    def execute(self, context: Context) -> None:
        percept = context.body.sense()
        context.publish("safety.state.Safety", Safety(percept.stop, percept.released))
