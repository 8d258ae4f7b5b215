"""Charge: to the dock, and stay until there is power again."""

from world import dock

from aseme_dsl.runtime import Context

from .ways import drive_to


class Charge:
    def execute(self, context: Context) -> None:
        if not context.body.plug(True):
            return
        try:
            drive_to(context, dock(context.agent))
            while context.body.sense().battery < 90:
                context.wait(0.5)
        finally:
            context.body.plug(False)
