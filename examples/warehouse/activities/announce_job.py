"""AnnounceJob: the next order that comes in."""

from monas.Warehouse.messages import Job

from aseme_dsl.runtime import Context


class AnnounceJob:
    def execute(self, context: Context) -> None:
        while (order := context.body.take()) is None:
            context.wait(0.5)
        context.prepare(Job(id=order.id, what=order.shelf))
        context.set("job", order.id)
