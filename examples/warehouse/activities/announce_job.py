"""AnnounceJob: the order that waits longest. Each of the eight managers is a clerk of its own."""

from monas.Warehouse.messages import Job
from world import Take

from aseme_dsl.runtime import Context


class AnnounceJob:
    def execute(self, context: Context) -> None:
        clerk = context.label.rpartition(".")[0]
        while clerk not in (office := context.body.sense()).taken:
            if office.waiting:
                context.body.act(Take(office.waiting[0].id, clerk))
            else:
                context.wait(0.5)
        order = office.taken[clerk]
        context.prepare(Job(id=order.id, what=order.shelf))
        context.set_variable("job", order.id)
