"""`waits`: an activity without code, whose state never completes by itself."""

from aseme_dsl.runtime import Context
from tests.runtime.playing import play

TEXT = """\
system S
srm R {
  liveness { R = (Idle . Walk) || Shout }
  activities { Idle waits  Walk takes 1s simulated  Shout takes 3s }
  control R { enter Walk : go }
}
"""


class Shout:
    def execute(self, context: Context) -> None:
        context.raise_event("go")


class Idle:
    def execute(self, context: Context) -> None:
        raise AssertionError("it has no code")


def test_it_lasts_until_something_ends_it() -> None:
    run = play(TEXT, {"Shout": Shout, "Idle": Idle})
    assert run.activities() == [
        "0 start Shout",
        "0 start Idle",
        "3000 end Shout",
        "3000 cancel Idle",
        "3000 start Walk",
        "4000 end Walk",
    ]
    assert run.of("fault") == []
    assert run.result.agents[0].finished


def test_a_role_that_only_waits_rests() -> None:
    run = play("system S srm R { liveness { R = Idle } activities { Idle waits } }", {"Idle": Idle})
    assert run.activities() == ["0 start Idle", "0 cancel Idle"]  # by the end of the run
    (agent,) = run.result.agents
    assert agent.stuck and not agent.finished
    (wait,) = agent.waits
    assert (wait.where, wait.name, wait.awaits) == ("in", "Idle", ())
