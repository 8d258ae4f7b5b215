"""Which message an external agent means and answers: by FIPA's parameters alone, or not at all."""

from __future__ import annotations

import json
import re
from functools import cache
from pathlib import Path
from typing import Any

import pytest

import aseme_dsl
from aseme_dsl.runtime.conversation import fipa_translation
from aseme_dsl.runtime.message.acl import REGISTERED, FipaMessage, Span, protocol_of, registered_name
from aseme_dsl.runtime.trace.trace import Record
from tests.runtime.outside import Outside
from tests.runtime.playing import MS, SECOND, check_line, make
from tests.support.generated import Generated, generate

LIBRARY = """
system Shop
import protocols
srm boss { plays request.initiator  liveness { boss = Rest . initiator }
  activities { Rest takes 1s simulated  PrepareOrder takes 100ms simulated  AwaitOutcome takes 1min simulated
               LearnOutcome takes 1s simulated } }
srm hand { plays request.responder  liveness { hand = responder~[2] }
  activities { ConsiderOrder takes 100ms simulated  PerformOrder takes 1s simulated
               ReportOutcome takes 100ms simulated } }
team T { TEAM }
"""
TALK = """
system Talk
message Call { int n }
message Job { int n }
message Done { int n }
aip talk {
  participant chief {
    var heard : int = 0
    sends    request Job, request Call
    receives inform Done, inform Job, agree Job, agree Call, not_understood Job, not_understood Call
    process  = Ask . Wait
  }
  participant hand [1..*] {
    sends    inform Done, inform Job, agree Job, agree Call, not_understood Job, not_understood Call
    receives request Job, request Call
    process  = Work
  }
  control chief {
    enter Ask  : / send request Job { n = 1 } to hand
    enter Wait : / send request Call { n = 2 } to hand
    on Wait    : agree Job from hand / heard = heard + 1
    on Wait    : agree Call from hand / heard = heard + 1
    on Wait    : not_understood Job from hand / heard = heard + 1
    on Wait    : not_understood Call from hand / heard = heard + 1
    leave Wait : inform Done from hand or inform Job from hand
    leave Wait : after(5s)
  }
  control hand {
    enter Work : request Job from chief
    leave Work : / send inform Done { n = 3 } to chief
  }
}
srm boss { plays talk.chief  liveness { boss = Rest . chief }
           activities { Rest takes 1s simulated  Ask takes 100ms simulated  Wait takes 1min simulated } }
srm worker { plays talk.hand  liveness { worker = hand~ } activities { Work takes 1s simulated } }
team T { ann : boss }
"""


@cache
def made(text: str) -> Generated:
    return generate(text)


def of(records: list[Record], kind: str, **members: Any) -> list[Record]:
    return [r for r in records if r["kind"] == kind and all(r.get(k) == v for k, v in members.items())]


class Talk:
    """A boss that asks an external hand; what the hand says."""

    def __init__(
        self, text: str = TALK, service: str = "talk.hand", boss: str = "ann", until: int = 20
    ) -> None:
        self.team, self.records = make(made(text), until=until * SECOND)
        self.alice = Outside(self.team)
        self.boss = boss
        services = {"action": "register", "description": {"services": [{"type": service}]}}
        registers = FipaMessage("request", self.alice.me, (), json.dumps(services))
        self.team.conversations.receive_external("df", registers)
        self.alice.heard.clear()

    def answer(self, at: int, act: str, content: Any, **more: Any) -> Talk:
        """Say something at a moment; `in_reply_to` may be the number or act of the message it answers."""

        def say() -> None:
            known = dict(more)
            if isinstance(number := known.get("in_reply_to"), int):
                known["in_reply_to"] = self.alice.heard[number].reply_with
            for message in self.alice.heard:
                if message.performative == known.get("in_reply_to"):
                    known["in_reply_to"] = message.reply_with
            if known.get("conversation") == "the same":
                known["conversation"] = self.alice.heard[0].conversation
            text = content if isinstance(content, str) else json.dumps(content)
            self.team.conversations.receive_external(
                self.boss, FipaMessage(act, self.alice.me, (), text, **known)
            )

        self.team.driver.at(at * MS, say)
        return self

    def received(self) -> list[str]:
        """What the boss could take of alice."""
        self.team.run()
        for record in self.records:
            check_line(record)
        found = of(self.records, "received", agent=self.boss)
        inputs = {(r["agent"], tuple(r["input"])) for r in of(self.records, "unexpected") if "message" in r}
        return [
            f"{r['performative']} {r['message']}"
            for r in found
            if (r["agent"], tuple(r["input"])) not in inputs
        ]

    def refused(self) -> list[str]:
        return [r["reason"] for r in of(self.records, "unexpected", agent=self.boss)]


# ---- names of protocols --------------------------------------------------------------------------


def test_the_names_of_fipas_protocols_go_both_ways() -> None:
    assert {protocol_of(registered_name(name)) for name in REGISTERED} == set(REGISTERED)
    assert registered_name("auction") == "fipa-auction-english"
    assert protocol_of("FIPA-Contract-Net") == "contract_net"
    assert registered_name("ordering") == protocol_of("ordering") == "ordering"
    assert all("-" in name for name in REGISTERED.values())
    library = (Path(aseme_dsl.__file__).parents[1] / "stdlib" / "protocols.aseme").read_text("utf-8")
    assert set(re.findall(r"^aip (\w+)", library, re.MULTILINE)) <= set(REGISTERED)


@pytest.mark.parametrize("name", ["fipa-request", "FIPA-Request", "request", "fipa_request"])
def test_a_registered_name_is_read_and_written(name: str) -> None:
    team, records = make(made(LIBRARY.replace("TEAM", "bob : hand")), until=20 * SECOND)
    alice = Outside(team)
    order = {"id": "1", "what": "tea"}
    alice.say(10, "request", order, protocol=name, conversation="c1", reply_with="r1")
    team.run()
    assert {message.protocol for message in alice.heard} == {"fipa-request"}
    assert [message.performative for message in alice.heard][-1] in ("inform", "failure", "refuse")
    assert {r["protocol"] for r in of(records, "agent_message")} == {"request"}


def test_a_protocol_of_the_very_name_is_meant_first() -> None:
    """`fipa_request` of the document is not `request`, though both are like `fipa-request`."""
    text = LIBRARY.replace("TEAM", "bob : both") + (
        "aip fipa_request { participant asker { sends request Order  process = AskIt } "
        "participant doer { receives request Order  process = DoIt } "
        'control asker { enter AskIt : / send request Order { id = "1", what = "x" } to doer } '
        "control doer { enter DoIt : request Order from asker } }\n"
        "srm both { plays request.responder, fipa_request.doer  liveness { both = responder~ || doer~ } "
        "activities { ConsiderOrder takes 100ms simulated  PerformOrder takes 1s simulated  "
        "ReportOutcome takes 100ms simulated  DoIt takes 1s simulated } }\n"
        "srm asks { plays fipa_request.asker  liveness { asks = asker } "
        "activities { AskIt takes 1s simulated } }"
    )
    for name, protocol in (("fipa-request", "request"), ("fipa_request", "fipa_request")):
        team, records = make(made(text), until=5 * SECOND)
        Outside(team).say(10, "request", {"id": "1", "what": "tea"}, protocol=name, conversation="c1")
        team.run()
        assert [r["protocol"] for r in of(records, "received")] == [protocol]
    team, records = make(made(text), until=5 * SECOND)
    Outside(team).say(10, "request", {"id": "1", "what": "tea"}, conversation="c1")
    team.run()
    assert [r["reason"] for r in of(records, "unexpected")] == [
        "it may be of request or fipa_request: protocol says which"
    ]


# ---- which message it is -------------------------------------------------------------------------


def test_an_answer_needs_no_header_of_ours() -> None:
    talk = (
        Talk().answer(2000, "agree", {"n": 1}, in_reply_to=0).answer(3000, "agree", {"n": 1}, in_reply_to=1)
    )
    assert talk.received() == ["agree Job", "agree Call"]
    assert talk.refused() == []


def test_what_may_be_two_messages_is_refused_with_the_reason() -> None:
    talk = Talk().answer(2000, "inform", {"n": 1}, conversation="the same")
    assert talk.received() == []
    assert talk.refused() == ["it may be Done or Job: X-message or in-reply-to says which"]
    assert talk.alice.answers()[-1][0] == "not-understood"


def test_the_type_may_be_said() -> None:
    talk = Talk().answer(2000, "inform", {"n": 1}, in_reply_to=0, parameters=(("X-message", "Done"),))
    assert talk.received() == ["inform Done"]


@pytest.mark.parametrize("content", ["what?", "", {"reason": "no", "content": {"n": 1}}, [], {"n": 2}])
def test_not_understood_may_have_any_content(content: Any) -> None:
    talk = Talk().answer(2000, "not-understood", content, in_reply_to=1)
    assert talk.received() == ["not_understood Call"]


def test_without_a_conversation_an_answer_belongs_to_the_only_one() -> None:
    talk = Talk().answer(2000, "agree", {"n": 1}, parameters=(("X-message", "Job"),))
    assert talk.received() == ["agree Job"]
    assert [r["conversation"] for r in of(talk.records, "received")] == ["talk-ann-1"]


def test_an_answer_that_may_belong_to_two_conversations_is_refused() -> None:
    text = TALK.replace("liveness { boss = Rest . chief }", "liveness { boss = Rest . chief[2] }")
    talk = Talk(text).answer(2000, "agree", {"n": 1}, parameters=(("X-message", "Job"),))
    assert talk.received() == []
    assert talk.refused() == [
        "it may belong to talk-ann-1 or talk-ann-2: conversation-id or in-reply-to says to which"
    ]
    talk = Talk(text).answer(2000, "agree", {"n": 1}, in_reply_to=2)
    assert len(talk.received()) == 1


ANSWERS_CANCEL = {
    "the result": ("request", ["inform Outcome"], []),
    "the cancellation": ("cancel", ["inform Order"], []),
    "one of both": ("", [], ["it may be Outcome or Order: X-message or in-reply-to says which"]),
}


def test_before_a_cancel_nothing_answers_it() -> None:
    talk = Talk(LIBRARY.replace("TEAM", "ann : boss"), "request.responder")
    talk.answer(1500, "agree", {"id": "1"}).answer(2000, "inform", {"id": "1"})
    assert (talk.received(), talk.refused()) == (["agree Order", "inform Outcome"], [])


@pytest.mark.parametrize("case", ANSWERS_CANCEL)
def test_in_fipas_protocols_inform_of_the_order_answers_a_cancel(case: str) -> None:
    """`inform {"id": …}` may be the outcome, or say that the order was cancelled."""
    answered, received, refused = ANSWERS_CANCEL[case]
    text = LIBRARY.replace("TEAM", "ann : boss").replace(
        "AwaitOutcome takes 1min", "AwaitOutcome takes 10min"
    )
    talk = Talk(text, "request.responder", until=100).answer(
        1500, "agree", {"id": "1"}, in_reply_to="request"
    )
    talk.answer(65_000, "inform", {"id": "1"}, in_reply_to=answered, conversation="the same")
    assert talk.received()[1:] == received
    assert "cancel" in [message.performative for message in talk.alice.heard]
    assert sorted(talk.refused()) == sorted(refused)


# ---- what it answers -----------------------------------------------------------------------------


def test_a_wrong_in_reply_to_is_not_taken() -> None:
    for more in ({"conversation": "the same"}, {"conversation": "c9"}, {}):
        talk = Talk().answer(2000, "agree", {"n": 1}, in_reply_to="nobody-7", **more)
        talk.answer(2500, "agree", {"n": 1}, in_reply_to=0)
        assert talk.received() == ["agree Job"]
        assert len(talk.refused()) == 1


def test_nobody_answers_what_another_was_sent() -> None:
    """Mallory takes part, too, and answers with what alice was sent."""
    talk = Talk()
    mallory = Outside(talk.team, "mallory@elsewhere")
    services = {"action": "register", "description": {"services": [{"type": "talk.hand"}]}}
    talk.team.conversations.receive_external(
        "df", FipaMessage("request", mallory.me, (), json.dumps(services))
    )
    talk.answer(2000, "shout", "", conversation="the same")

    def lie() -> None:
        assert talk.alice.heard[-1].performative == "not-understood"
        own, name = mallory.heard[-1].conversation, talk.alice.heard[-1].reply_with
        said = (("X-message", "Done"),)
        mallory.say(2500, "inform", {"n": 6}, to="ann", conversation=own, in_reply_to=name, parameters=said)

    talk.team.driver.at(2400 * MS, lie)
    talk.received()
    assert talk.refused()[1:] == [
        f"mallory@elsewhere was sent no {talk.alice.heard[-1].reply_with} in "
        "this conversation, which it answers"
    ]
    (left,) = of(talk.records, "conversation", what="leave", agent="ann")
    assert left["time"] == 6100 * MS  # at its deadline


def test_a_message_that_begins_a_conversation_answers_nothing() -> None:
    team, records = make(made(LIBRARY.replace("TEAM", "bob : hand")), until=20 * SECOND)
    alice = Outside(team)
    order = {"id": "1", "what": "tea"}
    alice.say(10, "request", order, conversation="c1", in_reply_to="bob-77", protocol="fipa-request")
    alice.say(20, "request", order, conversation="c2", protocol="fipa-request")
    team.run()
    (told,) = of(records, "unexpected")
    assert told["reason"] == "alice@elsewhere was sent no bob-77 in this conversation, which it answers"
    assert [m.performative for m in alice.heard if m.conversation == "c1"] == ["not-understood"]
    assert [r["conversation"] for r in of(records, "conversation", what="join")] == ["c2"]


# ---- until when ----------------------------------------------------------------------------------


def test_a_long_time_is_written_in_days() -> None:
    team, _ = make(made(TALK), until=MS)
    clock = team.driver.clock
    day = 86_400_000
    assert fipa_translation.fipa_moment(400 * day * MS, clock) == Span(1, 1, 5, 0)
    assert fipa_translation.fipa_moment(1500 * MS, clock) == Span(milliseconds=1500)
