"""`plays P.q when busy …`: what is said to who asks while all instances of a participant are in use."""

from __future__ import annotations

import pytest

from tests.runtime.outside import Outside
from tests.runtime.playing import MS, SECOND, Played, make, play
from tests.support.generated import generate

TEXT = """
system Shop
enum Why { LATER NEVER }
message Job { string id  int size }
message Sorry { string text  Why why }
aip work {
  participant client {
    sends request Job
    receives inform Job, SENDS, not_understood Job
    process = Ask . [Complain]
  }
  participant worker [1..*] {
    sends inform Job, SENDS
    receives request Job
    process = Do
  }
  control client {
    enter Ask : / send request Job { id = "j", size = 3 } to worker
    enter [Complain] : inform Job from worker
    enter [Complain] : SENDS from worker
    enter [Complain] : not_understood Job from worker
    enter [Complain] : lost worker
    enter Complain : [index == 9]
    skip Complain : else
  }
  control worker {
    enter Do : request Job from client
    leave Do : / send inform Job { .. } to client
  }
}
srm customer { plays work.client  liveness { customer = client . After }
  activities { Ask simulated takes 1s } }
srm smith {
  plays work.worker BUSY
  liveness { smith = SMITH }
  activities { Do simulated takes 5s }
}
team Shop { bob : smith  ann, bea, cid : customer }
"""


def work(busy: str, sends: str = "refuse Job", smith: str = "worker~") -> Played:
    text = TEXT.replace("SENDS", sends).replace("BUSY", busy).replace("SMITH", smith)
    return play(generate(text), until=30 * SECOND)


def told(run: Played) -> list[str]:
    """What the worker answers, with the time and the client."""
    return [
        f"{record['time'] // MS} {record['performative']} {record['to'][0]}"
        for record in run.of("agent_message", agent="bob")
    ]


def marks(run: Played) -> list[str]:
    lines = run.of("conversation", agent="bob")
    return [f"{line['what']} {line.get('peer', '')}".strip() for line in lines]


ONE_BY_ONE = ["5000 inform ann", "10000 inform bea", "15000 inform cid"]


@pytest.mark.parametrize("busy", ["", "when busy queue"])
def test_invitations_wait_in_their_order(busy: str) -> None:
    run = work(busy)
    assert told(run) == ONE_BY_ONE
    assert marks(run) == ["join", "queue bea", "queue cid", "leave", "join", "leave", "join", "leave"]


def test_refuse_says_what_the_protocol_refuses_with() -> None:
    run = work("when busy refuse")
    assert told(run) == ["0 refuse bea", "0 refuse cid", "5000 inform ann"]
    refusals = run.of("agent_message", performative="refuse")
    assert [item["content"] for item in refusals] == [{"id": "j", "size": 3}] * 2, "that of the invitation"
    assert all(item["answers"] for item in refusals)
    assert marks(run) == ["join", "busy bea", "busy cid", "leave"]
    assert not run.of("unexpected")


def test_a_message_with_its_content() -> None:
    run = work('when busy failure Sorry { text = "full", why = Why.NEVER }', "failure Sorry")
    assert told(run) == ["0 failure bea", "0 failure cid", "5000 inform ann"]
    assert run.of("agent_message", performative="failure")[0]["content"] == {"text": "full", "why": "NEVER"}


def test_without_a_message_for_it_the_invitation_is_not_understood() -> None:
    run = work("when busy refuse", "agree Sorry")
    assert told(run) == ["0 not_understood bea", "0 not_understood cid", "5000 inform ann"]
    assert len(run.of("unexpected")) == 2


def test_all_instances_have_to_be_in_use() -> None:
    run = work("when busy refuse", smith="worker[2] . Rest")
    assert told(run) == ["0 refuse cid", "5000 inform ann", "5000 inform bea"]


def test_who_asks_before_the_participant_is_entered_waits() -> None:
    """It is not busy then. When it takes one of them, it is."""
    run = work("when busy refuse", smith="(Rest . worker)~")
    assert told(run) == ["100 refuse bea", "100 refuse cid", "5100 inform ann"]


def test_one_of_two_places_is_in_use() -> None:
    run = work("when busy refuse", smith="worker . worker . Rest")
    assert told(run) == ["0 refuse bea", "0 refuse cid", "5000 inform ann"]


def test_who_expects_no_such_answer_learns_that_this_part_is_over() -> None:
    text = TEXT.replace("enter [Complain] : not_understood Job from worker", "")
    text = text.replace(", not_understood Job", "").replace("SENDS", "agree Sorry")
    run = play(generate(text.replace("BUSY", "when busy refuse").replace("SMITH", "worker~")), until=SECOND)
    gone = run.of("conversation", what="gone", agent="bea")
    assert [(item["reason"], item["peer"]) for item in gone] == [("completed", "bob")]


def test_a_sender_that_leaves_takes_its_invitation_along() -> None:
    text = TEXT.replace("customer = client . After", "customer = client [> Off")
    text = text.replace("srm customer {", "srm customer { control customer { enter Off : after(2s) }")
    text = text.replace("SENDS", "refuse Job").replace("BUSY", "when busy queue").replace("SMITH", "worker~")
    run = play(generate(text), until=30 * SECOND)
    assert marks(run) == ["join", "queue bea", "queue cid", "leave"]
    reasons = [item["reason"] for item in run.of("unexpected", agent="bob")]
    assert reasons[:2] == [f"{name} has left the conversation: left" for name in ("bea", "cid")]


def test_an_external_agent_is_refused() -> None:
    text = TEXT.replace("SENDS", "refuse Job").replace("BUSY", "when busy refuse").replace("SMITH", "worker~")
    team, _ = make(generate(text.replace("ann, bea, cid", "ann")), until=2 * SECOND)
    alice = Outside(team)
    alice.say(10, "request", {"id": "x", "size": 1}, protocol="work", conversation="c", reply_with="r")
    team.run()
    (answer,) = alice.heard
    assert (answer.performative, answer.conversation, answer.in_reply_to) == ("refuse", "c", "r")
    assert alice.answers() == [("refuse", {"id": "x", "size": 1})]


def test_a_participant_says_it_of_what_stands_inside() -> None:
    """What a participant plays is nested in its conversation; it says what is answered."""
    text = TEXT.replace("SENDS", "refuse Job").replace("plays work.worker BUSY", "plays outer.host")
    text = text.replace("SMITH", "host").replace(
        "srm customer",
        "aip outer { participant host { plays work.worker when busy refuse process = worker~ } }\n"
        "srm customer",
    )
    run = play(generate(text), until=2 * SECOND)
    assert told(run) == ["0 refuse bea", "0 refuse cid"]
