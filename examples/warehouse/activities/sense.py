"""Sense: tells what the carrier senses of itself."""

from monas.Warehouse.messages import Status

from aseme_dsl.runtime import Context


class Sense:
    def execute(self, context: Context) -> None:
        here = context.body.sense()
        context.publish("body.state.Status", Status(here.battery, not here.job))
