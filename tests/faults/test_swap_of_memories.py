"""Swap carries what `on` and `resume` remember, or says what is lost."""

from __future__ import annotations

from aseme_dsl.runtime.agent.state_transfer import Carried, carry, same_states
from aseme_dsl.runtime.chart.inputs import Left, Start
from tests.behaviour.conftest import PRELUDE
from tests.behaviour.running import Run
from tests.support.generated import Generated, generate

SHIFT = """
srm R {
  var n : int = 0
  liveness { R = (shift [> Charge)~  shift = A . B . C || D }
  control R {
    resume shift :
    enter Charge : go
    on Charge : when [t.state.M.on] / n = n + 1
  }
}
"""


def charging(text: str) -> tuple[Run, Generated]:
    """An agent that was cut short in B, with what `on` has seen."""
    made = generate(PRELUDE + text)
    run = Run(made.chart("R", "me"), made.plan("R"), made).step()
    run.step(run.done("A"), run.done("D"))
    run.step(run.event("go"), run.heard("t.state.M", on=True))
    assert (run.active, run.variable("n")) == (["Charge"], 1)
    return run, made


def carried(run: Run, before: Generated, text: str) -> tuple[Run, Carried]:
    """The same agent under another version of its text."""
    after = generate(PRELUDE + text)
    old, kind = before.charts["R"], after.charts["R"]
    result = carry(
        run.chart,  # type: ignore[arg-type]
        kind,
        vars(before.messages),
        vars(after.messages),
        run.now,
        same_states(old.PLAN, kind.PLAN),
    )
    other = Run(result.chart, after.plan("R"), after)
    other.now = run.now
    for start in run.last.effects:
        if isinstance(start, Start) and start.label in result.labels:
            other.tokens[result.labels[start.label]] = start.token
    return other, result


def test_it_goes_on_under_the_new_version() -> None:
    run, made = charging(SHIFT)
    text = SHIFT.replace("A . B . C || D", "Z . A . B . C || D").replace(
        "srm R {", "srm R {\n  var k : int = 0"
    )
    other, result = carried(run, made, text)
    assert result.lost == ()
    other.step()
    assert other.variable("n") == 1  # `on` was taken for what is there
    other.step(other.done("Charge"))
    assert other.active[0] == "B"
    assert other.started == ["B"]


def test_what_is_not_there_any_more_is_said_to_be_lost() -> None:
    run, made = charging(SHIFT)
    other, result = carried(run, made, SHIFT.replace("A . B . C", "A . X . C"))
    assert result.lost == ("where shift was left",)
    other.step(other.done("Charge"))
    assert other.active == ["A", "D"]


TALK = """
aip p {
  participant a { sends inform Note receives inform Note process = Ask . Give }
  participant b { sends inform Note receives inform Note process = Hear }
  control a { enter Give : after(30ms) }
}
srm R {
  plays p.a
  liveness { R = (shift [> Charge)~  shift = A . a . B }
  control R { resume shift :  enter Charge : go }
}
"""


def talking() -> tuple[Run, Generated]:
    """An agent whose conversation is suspended."""
    made = generate(PRELUDE + TALK)
    run = Run(made.chart("R", "me"), made.plan("R"), made).step()
    run.step(run.done("A"))
    run.step(run.event("go"), ms=10)
    assert [line.split()[0] for line in run.did] == ["cancel", "suspend", "start"]
    return run, made


def test_a_suspended_conversation_goes_on_under_the_new_version() -> None:
    run, made = talking()
    other, result = carried(run, made, TALK.replace("A . a . B", "Z . A . a . B"))
    assert (result.lost, result.effects) == ((), ())
    other.step(other.done("Charge"), ms=50)
    assert [line.split()[0] for line in other.did] == ["resume", "start"]
    assert (other.active, other.due) == (["Ask"], 20)


def test_a_suspended_conversation_that_cannot_go_on_is_left() -> None:
    run, made = talking()
    _, result = carried(run, made, TALK.replace("Ask . Give", "Look . Give"))
    assert result.lost == ("where shift was left",)
    assert [type(effect) for effect in result.effects] == [Left]
