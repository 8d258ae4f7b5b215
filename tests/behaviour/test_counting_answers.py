"""`invited`, `answered`, `all_answered` in a chart: what counts as an answer, and when."""

from __future__ import annotations

from aseme_dsl.runtime.chart.inputs import Addressed, Settled
from tests.behaviour.conftest import Play
from tests.behaviour.running import Run

PROTOCOL = """
aip p {
  participant a {
    var bids : int = 0
    sends    cfp Note, reject_proposal Note
    receives inform Note, refuse Note
    process  = A+ . B . C
  }
  participant b [1..*] {
    sends    inform Note, refuse Note
    receives cfp Note, reject_proposal Note
    process  = X
  }
  control a {
    enter  A+ : / send cfp Note { text = "x" } to b
    LEAVE
    repeat A : inform Note from b / bids = bids + 1REPLY
    repeat A : refuse Note from b
    enter  C : after(1s) / send cfp Note { text = "x" } to b
    leave  C : when [answered(b) >= 1 && invited(b) == 2]
  }
  control b { enter X : cfp Note from a }
}
srm R { plays p.a  liveness { R = a . D } }
"""


def text(leave: str = "leave A : when [all_answered(b)]", reply: str = "") -> str:
    return PROTOCOL.replace("LEAVE", leave).replace("REPLY", reply)


def addressed(run: Run, *agents: str, name: str = "me-1") -> Addressed:
    return Addressed(run.plan.branches[0].label, "b", agents, name)


def settled(run: Run, agent: str, reply: str = "") -> Settled:
    return Settled(run.plan.branches[0].label, "b", agent, reply)


def test_the_last_answer_is_taken_before_all_have_answered(play: Play) -> None:
    """The line that counts stands first; the last bid is not left behind."""
    run = play(text()).step()
    run.step(addressed(run, "ann", "bob"))
    assert run.active == ["A"]
    run.step(run.mail("inform", "Note", "ann"))
    assert run.active == ["A"]
    run.step(run.mail("refuse", "Note", "bob"), run.mail("inform", "Note", "ann"))
    assert run.active == ["B"]
    assert run.variable("bids") == 2


def test_nobody_addressed_is_not_all(play: Play) -> None:
    run = play(text()).step()
    assert run.active == ["A"]
    run.step(addressed(run))
    assert run.active == ["A"]


def test_who_is_lost_or_unexpected_counts_once_nothing_of_it_waits(play: Play) -> None:
    run = play(text()).step()
    run.step(addressed(run, "ann", "bob"), settled(run, "bob"))
    assert run.active == ["A"]
    run.step(settled(run, "ann"), run.mail("inform", "Note", "ann"))
    assert run.active == ["B"]
    assert run.variable("bids") == 1, "what ann sent before she was lost is taken first"


def test_who_was_not_addressed_does_not_count(play: Play) -> None:
    run = play(text()).step()
    run.step(addressed(run, "ann"), settled(run, "eve"), run.mail("inform", "Note", "eve"))
    assert run.active == ["A"]


def test_a_message_to_one_agent_does_not_begin_a_round(play: Play) -> None:
    """Each bad bid is rejected at once, and all answers are counted still."""
    named = text(reply='; send reject_proposal Note { text = "y" } to sender(n)')
    named = named.replace("Note from b / bids", "Note n from b / bids")
    run = play(named).step()
    run.step(addressed(run, "ann", "bob"))
    run.step(run.mail("inform", "Note", "ann"))
    run.step(run.mail("inform", "Note", "bob"))
    assert run.active == ["B"]


def test_the_next_send_counts_anew_and_late_answers_do_not(play: Play) -> None:
    run = play(text()).step()
    run.step(addressed(run, "ann"))
    run.step(run.mail("inform", "Note", "ann"))
    run.step(run.done("B"))
    run.step(ms=1000)
    assert run.active == ["C"]
    run.step(addressed(run, "ann", "bob", name="me-2"), settled(run, "ann", reply="me-1"))
    assert run.active == ["C"], "an answer to the first message does not count"
    run.step(settled(run, "ann", reply="me-2"))
    assert run.active == ["D"]


def test_numbers(play: Play) -> None:
    leave = "leave A : when [answered(b) * 2 > invited(b)]"
    run = play(text(leave)).step()
    run.step(addressed(run, "a1", "a2", "a3"))
    run.step(run.mail("inform", "Note", "a1"))
    assert run.active == ["A"]
    run.step(run.mail("inform", "Note", "a1"), run.mail("inform", "Note", "a3"))
    assert run.active == ["B"]
