"""Charge: to the dock, and stay until there is power again."""

from world import Plug, dock

from aseme_dsl.runtime import Context

from .ways import drive_to


class Charge:
    def execute(self, context: Context) -> None:
        context.body.act(Plug(True))
        if not context.body.sense().charging:
            return  # there is a job, after all
        try:
            drive_to(context, dock(context.agent))
            while context.body.sense().battery < 90:
                context.wait(0.5)
        finally:
            context.body.act(Plug(False))
