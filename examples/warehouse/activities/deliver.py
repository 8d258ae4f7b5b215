"""Deliver: fetch the pallet from its shelf, and bring it to the gate."""

from monas.Warehouse.messages import Job, Outcome
from world import GATE, Lift, Take, shelf

from aseme_dsl.runtime import Context

from .ways import drive_to


class Deliver:
    def execute(self, context: Context) -> None:
        job = context.last_received("cfp", "Job").content
        context.body.act(Take(job.id))
        if context.body.sense().job != job.id:
            context.prepare(Outcome(id=job.id, detail="the carrier is busy by now"))
            return
        try:
            self.deliver(context, job)
        finally:
            context.body.act(Take(""))

    def deliver(self, context: Context, job: Job) -> None:
        drive_to(context, shelf(job.what))
        context.wait(1)
        context.body.act(Lift())
        if not context.body.sense().loaded:
            context.prepare(Outcome(id=job.id, detail="the pallet slipped"))
            return
        drive_to(context, GATE)
        context.wait(1)
        context.prepare(Outcome(id=job.id, detail="at the gate"))
        context.set_variable("succeeded", True)
