"""HeaterSwitch: switches the heater as the statechart says."""

from aseme_dsl.runtime import Context


class HeaterSwitch:
    def execute(self, context: Context) -> None:
        said = context.read("room.state.Heater")
        if said is not None:
            context.body.act(("heater", said.on))
