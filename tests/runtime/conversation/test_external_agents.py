"""Agents that are not of the team: what they say is understood, or told and answered; nothing is dropped."""

from __future__ import annotations

import json
from dataclasses import replace
from datetime import UTC, datetime
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from aseme_dsl.runtime import Context
from aseme_dsl.runtime.message.acl import AgentIdentifier, FipaMessage, Span
from aseme_dsl.runtime.team.team import RunResult
from aseme_dsl.runtime.trace.trace import Record
from tests.runtime.outside import Outside
from tests.runtime.playing import MS, SECOND, check_line, make
from tests.support.generated import Generated, generate

ASK = """
system Help
message Question { int n }
message Answer { int n }
aip ask {
  participant asker {
    sends request Question, cancel Question
    receives inform Answer
    process = Ask . Wait
  }
  participant helper {
    sends inform Answer
    receives request Question, cancel Question
    process = Think . Say
  }
  control asker {
    enter Ask : / send request Question to helper
    leave Wait : inform Answer from helper or after(5s)
  }
  control helper {
    enter Think : request Question from asker
    leave Say : / send inform Answer { n = 1 } to asker
  }
}
srm help { plays ask.helper  liveness { help = helper~ } activities { Think takes 1s  Say takes 1ms } }
srm boss {
  plays ask.asker
  liveness { boss = Rest . asker }
  activities { Rest takes 3s  Ask takes 1ms  Wait takes 1min }
}
team T { bob : help  TEAM }
"""


@pytest.fixture(scope="module")
def ask() -> Generated:
    return generate(ASK.replace("TEAM", ""))


def outside(generated: Generated, **options: Any) -> tuple[Outside, list[Record]]:
    team, records = make(generated, options.pop("activities", None), until=20 * SECOND, **options)
    return Outside(team), records


def run(alice: Outside, records: list[Record]) -> RunResult:
    result = alice.team.run()
    for record in records:
        check_line(record)
    return result


def of(records: list[Record], kind: str) -> list[Record]:
    return [record for record in records if record["kind"] == kind]


def test_an_outsider_asks_and_is_answered(ask: Generated) -> None:
    alice, records = outside(ask)
    alice.say(10, "REQUEST", {"n": 3}, protocol="ask", conversation="c1", reply_with="r1", language="JSON")
    run(alice, records)
    (answer,) = alice.heard
    assert (answer.performative, answer.content) == ("inform", '{"n": 1}')
    assert (answer.conversation, answer.protocol, answer.in_reply_to) == ("c1", "ask", "r1")
    assert (answer.language, answer.ontology) == ("json", "Help")
    assert answer.sender == AgentIdentifier("bob") and answer.receivers == (alice.me,)
    assert dict(answer.parameters) == {"X-message": "Answer", "X-participant": "helper"}
    (received,) = of(records, "received")
    assert received["content"] == {"n": 3} and received["conversation"] == "c1"
    assert [(r["what"], r["conversation"]) for r in of(records, "conversation")] == [
        ("join", "c1"),
        ("leave", "c1"),
    ]
    assert alice.team.conversations._members.conversations == {}


def test_little_need_be_said(ask: Generated) -> None:
    """Without protocol, conversation and types: what may be meant is one thing only."""
    alice, records = outside(ask)
    alice.say(10, "request")
    run(alice, records)
    (answer,) = alice.heard
    assert answer.performative == "inform" and answer.conversation
    assert answer.in_reply_to == ""


def test_answers_go_where_they_are_wanted(ask: Generated) -> None:
    alice, records = outside(ask)
    carol = Outside(alice.team, "carol@elsewhere")
    alice.say(10, "request", {}, reply_to=(carol.me,))
    run(alice, records)
    assert (alice.answers(), carol.answers()) == ([], [("inform", {"n": 1})])


def test_two_conversations_of_one_outsider_each_have_their_own(ask: Generated) -> None:
    alice, records = outside(ask)
    alice.say(10, "request", {}, conversation="c1", reply_with="r1")
    alice.say(10, "request", {}, conversation="c2", reply_with="r2")
    run(alice, records)
    assert [(m.conversation, m.in_reply_to) for m in alice.heard] == [("c1", "r1"), ("c2", "r2")]


MISTAKES = {
    "unknown performative": (
        {"performative": "shout", "content": {}},
        "FIPA has no performative shout",
    ),
    "not received": (
        {"performative": "cfp", "content": {}},
        "help receives no cfp",
    ),
    "content is not JSON": (
        {"performative": "request", "content": "(sl)"},
        "the content is not JSON: Expecting value: line 1 column 1 (char 0)",
    ),
    "content is no object": (
        {"performative": "request", "content": "3"},
        "the content is not a JSON object",
    ),
    "content is half a character": (
        {"performative": "request", "content": '"\\ud800"'},
        "the content is not JSON: 'utf-8' codec can't encode character",
    ),
    "content is very deep": (
        {"performative": "request", "content": "[" * 100_000},
        "the content is not JSON: more than 100 lists and objects in each other",
    ),
    "content is no text": (
        {"performative": "request", "content": b"\xff"},
        "the content is not a text in UTF-8",
    ),
    "another language": (
        {"performative": "request", "content": "(x)", "language": "fipa-sl"},
        "the content is in fipa-sl; json is understood",
    ),
    "another type": (
        {"performative": "request", "content": {"n": "three"}},
        "it is not a Question: n: a int is wanted, not 'three'",
    ),
    "a member too many": (
        {"performative": "request", "content": {"m": 3}},
        "it is not a Question: Question has no member m; it has n",
    ),
    "another message": (
        {"performative": "request", "content": {}, "parameters": (("X-message", "Answer"),)},
        "help receives no request Answer",
    ),
    "another part": (
        {"performative": "request", "content": {}, "parameters": (("x-participant", "helper"),)},
        "helper receives no request Question from helper",
    ),
    "another protocol": (
        {"performative": "request", "content": {}, "protocol": "fipa-query"},
        "bob plays no part in fipa-query",
    ),
    "nobody": ({"performative": "request", "content": {}, "to": "eve"}, "there is no agent eve here"),
}


@pytest.mark.parametrize("case", MISTAKES)
def test_what_is_not_understood_is_told_and_answered(ask: Generated, case: str) -> None:
    given, reason = MISTAKES[case]
    alice, records = outside(ask)
    alice.say(10, **{"conversation": "c1", "reply_with": "r1", **given})
    run(alice, records)
    (told,) = of(records, "unexpected")
    assert told["reason"].startswith(reason)
    (answer,) = alice.heard
    assert (answer.performative, answer.conversation) == ("not-understood", "c1")
    assert answer.in_reply_to == "r1"
    content = json.loads(str(answer.content))
    assert content["reason"] == told["reason"]
    (mail,) = [record for record in of(records, "agent_message") if record["answers"] == [told["input"]]]
    assert (mail["performative"], mail["content"], mail["to"]) == (
        "not_understood",
        content,
        ["alice@elsewhere"],
    )
    assert answer.reply_with == f"{mail['agent']}-{mail['sequence']}"
    assert alice.team.conversations._members.conversations == {}


def test_what_does_not_say_who_has_sent_it_is_told(ask: Generated) -> None:
    alice, records = outside(ask)
    alice.send(10, FipaMessage("request", None, (), "{}"))
    run(alice, records)
    assert [r["reason"] for r in of(records, "unexpected")] == ["it does not say who has sent it"]


def test_nobody_passes_for_one_of_the_team(ask: Generated) -> None:
    alice, records = outside(ask)
    alice.send(10, FipaMessage("request", AgentIdentifier("bob"), (), "{}"))
    run(alice, records)
    (told,) = of(records, "unexpected")
    assert told["reason"] == "an agent of the team is called bob, and this is none of its messages"
    with pytest.raises(ValueError, match="an agent of the team is called bob"):
        alice.team.conversations.add_external_agent("bob", alice.heard.append)


def test_what_is_received_twice_is_told_and_not_done_twice(ask: Generated) -> None:
    alice, records = outside(ask)
    message = FipaMessage("request", alice.me, (), "{}", protocol="ask", conversation="c1", reply_with="r1")
    for at in (10, 20, 5000):
        alice.send(at, message)
    alice.send(6000, replace(message, reply_with="r2", conversation="c2"))
    run(alice, records)
    assert [message.performative for message in alice.heard] == ["inform", "inform"]
    assert [r["reason"] for r in of(records, "unexpected")] == ["it was received before"] * 2


def test_what_comes_when_a_conversation_is_over_is_not_understood(ask: Generated) -> None:
    alice, records = outside(ask)
    alice.say(10, "request", {}, conversation="c1", reply_with="r1")
    alice.say(5000, "cancel", {}, conversation="c1", reply_with="r2")
    alice.say(6000, "request", {}, conversation="c1", reply_with="r3")
    run(alice, records)
    assert [(m.performative, m.in_reply_to) for m in alice.heard] == [
        ("inform", "r1"),
        ("not-understood", "r2"),
        ("not-understood", "r3"),
    ]
    over = "its part in the conversation is over"
    assert [r["reason"] for r in of(records, "unexpected")] == [over, over]


def test_not_understood_is_never_answered(ask: Generated) -> None:
    alice, records = outside(ask)
    alice.say(10, "not-understood", {})
    alice.say(20, "Not-Understood", "???")
    run(alice, records)
    assert (len(of(records, "unexpected")), alice.heard) == (2, [])


def test_no_more_agents_take_part_than_a_participant_may_have() -> None:
    """A stranger cannot take the place of the helper that was asked."""
    generated = generate(ASK.replace("TEAM", " ann : boss"))
    alice, records = outside(generated)
    alice.say(3500, "inform", {"n": 666}, to="ann", conversation="ask-ann-1")
    run(alice, records)
    (told,) = of(records, "unexpected")
    assert told["reason"] == "bob takes part as helper already"
    assert [message.performative for message in alice.heard] == ["not-understood"]
    (left,) = [r for r in of(records, "conversation") if r["agent"] == "ann" and r["what"] == "leave"]
    assert left["time"] == 4001 * MS


def test_who_was_not_invited_does_not_answer_for_those_who_were() -> None:
    generated = generate(
        ASK.replace("TEAM", " ann : boss")
        .replace("participant helper", "participant helper [1..*]")
        .replace(
            "leave Wait : inform Answer from helper or after(5s)",
            "leave Wait : inform Answer a from helper [a.n == 9]",
        )
    )
    alice, records = outside(generated)
    alice.say(3500, "inform", {"n": 9}, to="ann", in_reply_to="ann-2", conversation="ask-ann-1")
    run(alice, records)
    assert [r["reason"] for r in of(records, "unexpected")] == [
        "alice@elsewhere does not take part as helper"
    ]
    (left,) = [r for r in of(records, "conversation") if r["agent"] == "ann" and r["what"] == "leave"]
    assert left["time"] == 20 * SECOND  # the end of the run
    assert [message.performative for message in alice.heard] == ["not-understood"]


NET = """
system Net
message Task  { string id }
message Bid   { double cost }
message Award { string id }
aip net {
  participant manager {
    sends cfp Task, accept_proposal Award by Choose, reject_proposal Award by Choose
    receives propose Bid, inform Award
    process = Ask . Choose . Await
  }
  participant contractor [1..*] {
    sends propose Bid, inform Award
    receives cfp Task, accept_proposal Award, reject_proposal Award
    process = Think . (Work | Rest)
  }
  control manager {
    enter Ask    : / send cfp Task { id = "t" } to contractor
    enter Choose : propose Bid from contractor
    leave Await  : inform Award from contractor
  }
  control contractor {
    enter Think : cfp Task from manager / send propose Bid { cost = 1 } to manager
    enter Work  : accept_proposal Award from manager
    enter Rest  : reject_proposal Award from manager
    leave Work  : / send inform Award { id = "t" } to manager
  }
}
srm desk  { plays net.manager  liveness { desk = Wait . manager } activities { Wait takes 2s } }
srm robot { plays net.contractor  liveness { robot = contractor~ } }
team T { desk : desk  bob : robot }
"""


def choosing(*awards: tuple[str, str]) -> Any:
    generated = generate(NET)

    class Choose:
        def execute(self, context: Context) -> None:
            for performative, to in awards:
                context.send(performative, generated.message("Award", id="t"), to)

    return outside(generated, activities={"Choose": Choose})


@pytest.mark.parametrize("act", ["accept-proposal", "reject-proposal"])
def test_an_illegal_first_message_does_not_take_the_only_instance(act: str) -> None:
    """P11: an award of an unknown conversation is answered and forgotten; the real call comes through."""
    alice, records = choosing(("accept_proposal", "bob"))
    alice.say(1000, act, {"id": "x"}, to="bob", conversation="c9", protocol="net", reply_with="x")
    run(alice, records)
    (told,) = of(records, "unexpected")
    assert (told["agent"], told["reason"]) == ("bob", "contractor does not begin with it")
    assert [message.performative for message in alice.heard] == ["not-understood"]
    assert [(r["agent"], r["what"], r["conversation"]) for r in of(records, "conversation")] == [
        ("desk", "open", "net-desk-1"),
        ("bob", "join", "net-desk-1"),
        ("bob", "leave", "net-desk-1"),
        ("desk", "leave", "net-desk-1"),
    ]


def test_who_was_not_called_is_not_taken_by_an_award_of_the_team() -> None:
    generated = generate(NET.replace("bob : robot", "bob, ben : robot").replace("[1..*]", "[1..1]"))

    class Choose:
        def execute(self, context: Context) -> None:
            context.send("accept_proposal", generated.message("Award", id="t"), "bob")
            context.send("reject_proposal", generated.message("Award", id="t"), "ben")

    alice, records = outside(generated, activities={"Choose": Choose})
    run(alice, records)
    assert [r["agent"] for r in of(records, "conversation") if r["what"] == "join"] == ["bob"]


def test_who_cannot_be_reached_is_told(ask: Generated) -> None:
    alice, records = outside(ask)
    alice.send(10, FipaMessage("request", AgentIdentifier("eve@nowhere"), (), "{}"))
    run(alice, records)
    (fault,) = [r for r in of(records, "fault") if "code" not in r]
    assert fault["reason"] == "inform cannot be sent: there is no way to eve@nowhere"


def test_nobody_takes_the_name_of_a_conversation_to_come() -> None:
    alice, records = outside(generate(ASK.replace("TEAM", " ann : boss")))
    alice.say(10, "request", {}, conversation="ask-ann-1")
    run(alice, records)
    opened = [r["conversation"] for r in of(records, "conversation") if r["what"] == "open"]
    assert opened == ["ask-ann-2"]
    assert alice.answers() == [("inform", {"n": 1})]


words = st.sampled_from(["ask", "c1", "c2", "json", "r1", "Question", "helper", "asker", "", "?", "bob"])
contents = st.one_of(
    st.none(), st.text(), st.binary(), st.sampled_from(["{}", '{"n": 3}', '{"n": 1e400}', "[]", "{"])
)


@settings(max_examples=60, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(
    said=st.lists(
        st.builds(
            FipaMessage,
            st.sampled_from(["request", "inform", "cancel", "Request", "shout", "not-understood", ""]),
            st.sampled_from(
                [None, AgentIdentifier("alice@elsewhere"), AgentIdentifier("x"), AgentIdentifier("bob")]
            ),
            content=contents,
            language=words,
            encoding=words,
            protocol=words,
            conversation=words,
            reply_with=words,
            in_reply_to=words,
            parameters=st.sampled_from([(), (("X-message", "Question"),), (("x-participant", 3),)]),
        ),
        max_size=8,
    )
)
def test_whatever_is_said_leaves_a_line(ask: Generated, said: list[FipaMessage]) -> None:
    alice, records = outside(ask)
    for number, message in enumerate(said):
        alice.send(10 * number, message)
    result = run(alice, records)
    assert not result.failed
    assert len(of(records, "received")) + len(
        [r for r in of(records, "unexpected") if "message" not in r]
    ) == len(said)


def test_until_when_an_answer_is_wanted() -> None:
    seen: list[Any] = []

    class Think:
        def execute(self, context: Context) -> None:
            mail = context.last_received("request")
            assert mail is not None
            seen.append(mail.reply_by)

    alice, records = outside(generate(ASK.replace("TEAM", "")), activities={"Think": Think})
    alice.say(10, "request", {}, reply_by=Span(milliseconds=2500))
    alice.say(5000, "request", {}, reply_by=datetime(2026, 1, 1, tzinfo=UTC))
    run(alice, records)
    assert seen == [2510 * MS, None]  # in virtual time nobody knows which day it is
    assert of(records, "received")[0]["reply_by"] == 2510 * MS


def test_when_a_message_was_sent() -> None:
    """FIPA has no parameter for it: of an external agent that is not known."""
    seen: list[Any] = []

    class Think:
        def execute(self, context: Context) -> None:
            mail = context.last_received("request")
            assert mail is not None
            seen.append((mail.sender, mail.sent, context.now_ns))

    alice, records = outside(generate(ASK.replace("TEAM", " ann : boss")), activities={"Think": Think})
    alice.say(10, "request", {}, conversation="c1")
    run(alice, records)
    (sent,) = [r["time"] for r in of(records, "agent_message") if r["agent"] == "ann"]
    assert seen == [("alice@elsewhere", None, 10 * MS), ("ann", sent, sent)]


def test_an_activity_says_until_when_it_wants_an_answer() -> None:
    """To an agent of the team and to one that is not."""
    seen: list[Any] = []

    class Think:
        def execute(self, context: Context) -> None:
            mail = context.last_received("request")
            assert mail is not None
            seen.append(mail.reply_by)

    class Ask:
        def execute(self, context: Context) -> None:
            context.send("request", generated.message("Question"), "helper", reply_within=1.5)

    text = ASK.replace("TEAM", " ann : boss").replace("participant helper {", "participant helper [1..*] {")
    generated = generate(text.replace("    enter Ask : / send request Question to helper\n", ""))
    alice, records = outside(generated, activities={"Think": Think, "Ask": Ask})
    services = {"services": [{"type": "ask.helper"}]}
    alice.say(10, "request", {"action": "register", "description": services}, to="df")
    run(alice, records)
    (asked,) = of(records, "agent_message")[:1]
    assert (asked["to"], asked["reply_by"]) == (["bob", "alice@elsewhere"], asked["time"] + 1500 * MS)
    assert seen == [asked["reply_by"]]
    asked_for, over = alice.heard[1:]
    assert asked_for.reply_by == Span(milliseconds=1500)
    assert over.performative == "cancel"  # the one who asked has ended without an answer of alice


@pytest.mark.parametrize("by", ["transition", "activity"])
def test_one_that_has_registered_is_addressed_by_its_name(by: str) -> None:
    """As a broker does that has found it in the directory; who has not registered is none."""
    text = ASK.replace("TEAM", " ann : boss").replace("participant helper {", "participant helper [1..*] {")
    if by == "transition":
        text = text.replace("participant asker {", "participant asker {\n    var found : agent")
        text = text.replace("process = Ask . Wait", "process = Look . Ask . Wait")
        text = text.replace("send request Question to helper", "send request Question { n = 1 } to found")
        text = text.replace("Ask takes 1ms", "Look takes 1ms  Ask takes 1ms")
    else:
        text = text.replace("    enter Ask : / send request Question to helper\n", "")
    generated = generate(text)
    refused: list[str] = []

    class Look:
        def execute(self, context: Context) -> None:
            (found,) = context.directory.search("ask.helper", properties={"quick": "yes"})
            if by == "transition":
                context.set_variable("found", found.name)
            else:
                with pytest.raises(LookupError, match="carol@elsewhere is neither an agent nor") as problem:
                    context.send("request", generated.message("Question", n=1), "carol@elsewhere")
                refused.append(str(problem.value))
                context.send("request", generated.message("Question", n=1), found.name)

    alice, records = outside(generated, activities={"Look" if by == "transition" else "Ask": Look})
    services = {"services": [{"type": "ask.helper", "properties": {"quick": "yes"}}]}
    alice.say(10, "request", {"action": "register", "description": services}, to="df")
    run(alice, records)
    asked = [message.content for message in alice.heard if message.performative == "request"]
    assert asked == ['{"n": 1}']
    assert len(refused) == (by == "activity")
