"""EvaluateJob: whether the carrier is free, and has the power for the way."""

from aseme_dsl.runtime import Context

from .ways import power_for


class EvaluateJob:
    def execute(self, context: Context) -> None:
        context.wait(0.05 + 0.1 * context.random.random())
        job = context.last_received("cfp", "Job").content
        here = context.body.sense()
        context.set_variable(
            "able", not here.job and not here.charging and power_for(here, job.what) < here.battery
        )
