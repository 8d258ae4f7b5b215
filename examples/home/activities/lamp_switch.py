"""LampSwitch: switches the lamp as the statechart says."""

from aseme_dsl.runtime import Context


class LampSwitch:
    def execute(self, context: Context) -> None:
        said = context.read("room.state.Lamp")
        if said is not None:
            context.body.act(("lamp", said.on))
