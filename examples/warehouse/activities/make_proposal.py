"""MakeProposal: the seconds until the pallet would be at the gate."""

from monas.Warehouse.messages import Proposal

from aseme_dsl.runtime import Context

from .ways import seconds_for


class MakeProposal:
    def execute(self, context: Context) -> None:
        job = context.last_received("cfp", "Job").content
        context.prepare(Proposal(job=job.id, cost=round(seconds_for(context.body.sense(), job.what), 1)))
