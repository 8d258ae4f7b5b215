"""Deliver: fetch the pallet from its shelf, and bring it to the gate."""

from monas.Warehouse.messages import Job, Outcome
from world import GATE, shelf

from aseme_dsl.runtime import Context

from .ways import drive_to


class Deliver:
    def execute(self, context: Context) -> None:
        job = context.received("cfp", "Job").content
        if not context.body.take(job.id):
            context.prepare(Outcome(id=job.id, detail="the carrier is busy by now"))
            return
        try:
            self.deliver(context, job)
        finally:
            context.body.take("")

    def deliver(self, context: Context, job: Job) -> None:
        drive_to(context, shelf(job.what))
        context.wait(1)
        if not context.body.grasp():
            context.prepare(Outcome(id=job.id, detail="the pallet slipped"))
            return
        drive_to(context, GATE)
        context.wait(1)
        context.prepare(Outcome(id=job.id, detail="at the gate"))
        context.set("succeeded", True)
