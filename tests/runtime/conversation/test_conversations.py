"""Conversations between agents (semantics, "Agent messages"), from documents to who got which message."""

from __future__ import annotations

from typing import Any

import pytest

from aseme_dsl.runtime import Context
from aseme_dsl.runtime.conversation.exchange import participant_delivery
from aseme_dsl.runtime.message.acl import PERFORMATIVES, fipa_name
from tests.runtime.playing import MS, SECOND, Played, play
from tests.support.generated import generate


def said(run: Played) -> list[str]:
    """Every agent message: `0 desk cfp Task -> carrier1 carrier2`."""
    return [
        f"{r['time'] / MS:g} {r['agent']} {r['performative']} {r['message']} -> {' '.join(r['to'])}"
        for r in run.of("agent_message")
    ]


def unexpected(run: Played) -> list[str]:
    return [f"{r['agent']} {r['performative']} {r['message']}: {r['reason']}" for r in run.of("unexpected")]


NET = """
system Net
message Task {{ int n }}
message Bid {{ double cost }}
message Award {{ string task }}
aip net {{
  participant manager {{
    var bids : int = 0
    sends cfp Task, accept_proposal Award, reject_proposal Award
    receives propose Bid, refuse Task, inform Award
    process = Announce . CollectBids . (Award . AwaitResult | GiveUp)
  }}
  participant contractor [1..*] {{
    var able : bool = false
    sends propose Bid, refuse Task, inform Award
    receives cfp Task, accept_proposal Award, reject_proposal Award
    process = Evaluate . ((SendBid . [Deliver]) | Decline)
  }}
  control manager {{
    enter Announce : / send cfp Task to contractor
    enter (Award . AwaitResult) : [bids > 0]
    enter GiveUp : else
    leave AwaitResult : inform Award from contractor or after(1min)
  }}
  control contractor {{
    enter Evaluate : cfp Task from manager
    enter (SendBid . [Deliver]) : [able]
    enter Decline : else / send refuse Task to manager
    enter SendBid : / send propose Bid to manager
    enter Deliver : accept_proposal Award from manager
    skip Deliver : reject_proposal Award from manager or after(10s)
    leave Deliver : / send inform Award to manager
  }}
}}
srm dispatcher {{
  plays net.manager
  liveness {{ dispatcher = NextTask . manager }}
  activities {{ NextTask takes 1ms  AwaitResult takes 1h  CollectBids writes bids }}
}}
srm robot {{
  plays net.contractor
  liveness {{ robot = {robot} }}
  activities {{ Evaluate writes able  SendBid takes 1ms  Decline takes 1ms  Deliver takes 1s }}
}}
team T {{ desk : dispatcher  carrier[1..3] : robot }}
"""


def net(robot: str = "contractor", able: str = "carrier1 carrier3") -> Played:
    """A contract net between a desk and three carriers, of which some are able to do the task."""
    generated = generate(NET.format(robot=robot).replace("1h", "60min"))

    class NextTask:
        def execute(self, context: Context) -> None:
            context.prepare(generated.message("Task", n=7))

    class Evaluate:
        def execute(self, context: Context) -> None:
            task = context.last_received("cfp", "Task", "desk")
            assert task is not None and task.content.n == 7
            context.set_variable("able", context.agent in able.split())
            context.prepare(generated.message("Bid", cost=float(context.agent[-1])))

    class CollectBids:
        def execute(self, context: Context) -> None:
            context.wait(0.5)
            bids: list[Any] = []
            while (mail := context.receive("propose")) is not None:
                bids.append(mail)
            while context.receive("refuse", "Task"):
                pass
            context.set_variable("bids", len(bids))
            if bids:
                best = max(bids, key=lambda mail: mail.content.cost)
                assert context.last_received("propose") == bids[-1]
                context.send("accept_proposal", generated.message("Award", task="7"), best.sender)
                for mail in bids:
                    if mail is not best:
                        context.send("reject_proposal", generated.message("Award"), mail.sender)

    activities = {"NextTask": NextTask, "Evaluate": Evaluate, "CollectBids": CollectBids}
    return play(generated, activities, until=30 * SECOND)


def test_a_contract_net_finds_its_contractor() -> None:
    run = net()
    assert said(run) == [
        "1 desk cfp Task -> carrier1 carrier2 carrier3",
        "1 carrier1 propose Bid -> desk",
        "1 carrier2 refuse Task -> desk",
        "1 carrier3 propose Bid -> desk",
        "601 desk accept_proposal Award -> carrier3",
        "601 desk reject_proposal Award -> carrier1",
        "1601 carrier3 inform Award -> desk",
    ]
    assert unexpected(run) == []
    assert [r["content"] for r in run.of("agent_message")][:2] == [{"n": 7}, {"cost": 1.0}]
    assert run.result.reason == "finished"
    assert [(r["agent"], r["what"]) for r in run.of("conversation")] == [
        ("desk", "open"),
        ("carrier1", "join"),
        ("carrier2", "join"),
        ("carrier3", "join"),
        ("carrier2", "leave"),
        ("carrier1", "leave"),
        ("carrier3", "leave"),
        ("desk", "leave"),
    ]


def test_what_is_sent_answers_what_was_last_taken_of_its_receivers() -> None:
    run = net()
    sent = {(r["agent"], r["sequence"]): f"{r['agent']} {r['performative']}" for r in run.of("agent_message")}
    answers = {
        sent[r["agent"], r["sequence"]]: [sent[agent, number] for agent, number in r.get("answers", ())]
        for r in run.of("agent_message")
    }
    assert answers == {
        "desk cfp": [],
        "carrier1 propose": ["desk cfp"],
        "carrier2 refuse": ["desk cfp"],
        "carrier3 propose": ["desk cfp"],
        "desk accept_proposal": ["carrier3 propose"],
        "desk reject_proposal": ["carrier1 propose"],
        "carrier3 inform": ["desk accept_proposal"],
    }


def test_nobody_is_able() -> None:
    run = net(able="")
    assert said(run)[1:] == [f"1 carrier{n} refuse Task -> desk" for n in (1, 2, 3)]
    assert "end GiveUp" in run.order()


def test_a_message_waits_until_its_participant_is_entered() -> None:
    """ "(so one that comes early is not lost)" """
    run = net(robot="Rest . contractor")
    assert "100 carrier1 propose Bid -> desk" in said(run)
    assert run.of("conversation", agent="carrier1")[0]["time"] == 100 * MS
    assert unexpected(run) == []
    assert run.result.reason == "finished"


REQUEST = """
system S
message Question {{ int n }}
message Answer {{ int n }}
aip ask {{
  participant asker {{
    sends request Question
    receives inform Answer{also}
    process = Ask . Wait
  }}
  participant helper {{
    sends inform Answer
    receives request Question
    process = Think . Say
  }}
  control asker {{
    enter Ask : / send request Question to helper
    leave Wait : inform Answer from helper or after(5s)
  }}
  control helper {{
    enter Think : request Question from asker
    leave Say : / send inform Answer to asker
  }}
}}
srm boss {{ plays ask.asker  liveness {{ boss = {boss} }} activities {{ Ask takes 1ms  Wait takes 1min }} }}
srm help {{ plays ask.helper  liveness {{ help = {help} }} activities {{ Think takes 1s  Say takes 1ms }} }}
team T {{ ann : boss  bob : help }}
"""


def ask(boss: str, help: str, also: str = "") -> Played:
    return play(REQUEST.format(boss=boss, help=help, also=also), until=20 * SECOND)


def test_an_agent_takes_part_in_as_many_conversations_as_it_has_instances() -> None:
    """ "An agent takes part in as many conversations of a participant at once as its formula has instances of
    it; the rest wait." """
    alone = ask("asker[2]", "helper~")
    assert [line.split(" ", 1) for line in said(alone)] == [
        ["0", "ann request Question -> bob"],
        ["0", "ann request Question -> bob"],
        ["1001", "bob inform Answer -> ann"],
        ["2002", "bob inform Answer -> ann"],
    ]
    both = ask("asker[2]", "helper[2]")
    assert [line.split(" ")[0] for line in said(both)] == ["0", "0", "1001", "1001"]


def test_each_answer_reaches_the_branch_that_asked() -> None:
    run = ask("asker[2]", "helper~")
    left = run.of("conversation", agent="ann", what="leave")
    assert [r["time"] // MS for r in left] == [1001, 2002]
    assert [r["conversation"] for r in left] == ["ask-ann-1", "ask-ann-2"]


def test_what_comes_too_late_is_answered_not_understood() -> None:
    """ "one … of a closed conversation, is unexpected: reported, kept in the trace and answered" """
    run = play(
        REQUEST.format(boss="asker . Rest", help="helper", also="").replace(
            "Think takes 1s", "Think takes 6s"
        ),
        until=20 * SECOND,
    )
    assert said(run) == [
        "0 ann request Question -> bob",
        "6001 bob inform Answer -> ann",
        "6001 ann not_understood Answer -> bob",
    ]
    assert unexpected(run)[0].startswith("ann inform Answer: ")
    assert len(unexpected(run)) == 2
    late, answer = run.of("agent_message")[1:]
    assert answer["answers"] == [["bob", late["sequence"]]]
    assert run.result.reason == "finished"


def test_a_participant_that_listens_for_not_understood_hears_it() -> None:
    text = REQUEST.format(boss="asker", help="helper", also=", not_understood Question")
    for old, new in (
        ("process = Ask . Wait", "process = Ask . Again . Wait"),
        ("sends inform Answer\n", "sends inform Answer, not_understood Question\n"),
        (
            "leave Wait : inform",
            "enter Again : after(3s) / send request Question to helper\n leave Wait : inform",
        ),
        ("or after(5s)", "or not_understood Question from helper"),
        ("enter Ask :", "enter Wait : \n enter Ask :"),
        ("inform Answer from helper or", ""),
        ("Ask takes 1ms", "Ask takes 1ms  Again takes 1ms"),
    ):
        assert old in text
        text = text.replace(old, new)
    run = play(text, until=20 * SECOND)
    assert said(run) == [
        "0 ann request Question -> bob",
        "1001 bob inform Answer -> ann",
        "3000 ann request Question -> bob",
        "3000 bob not_understood Question -> ann",
    ]
    assert unexpected(run) == ["bob request Question: its part in the conversation is over"]
    assert (run.result.reason, run.result.end_ns) == ("finished", 3001 * MS)


def test_conversations_work_in_real_time() -> None:
    text = REQUEST.format(boss="asker[3]", help="helper~ || Work", also="").replace("1s", "1ms")
    run = play(text, until=60 * SECOND, clock="real", stop=_three_answers)
    assert run.result.reason == "three"
    answers = [r["conversation"] for r in run.of("agent_message", performative="inform")]
    assert sorted(answers) == ["ask-ann-1", "ask-ann-2", "ask-ann-3"]


def _three_answers(team: Any) -> str | None:
    return "three" if team.agent("ann").chart.finished else None


def test_performatives_are_fipas() -> None:
    assert len(PERFORMATIVES) == 22
    assert fipa_name("accept_proposal") == "accept-proposal"


def test_each_of_them_is_sent_and_taken() -> None:
    """All 22, one after the other, from the text to the run."""
    sends = ", ".join(f"{performative} Note" for performative in PERFORMATIVES)
    steps = [f"S{number}" for number in range(len(PERFORMATIVES))]
    said_by = "  ".join(
        f"enter {step} : / send {performative} Note to b"
        for step, performative in zip(steps, PERFORMATIVES, strict=True)
    )
    heard_by = "  ".join(
        f"enter {step.replace('S', 'T')} : {performative} Note from a"
        for step, performative in zip(steps, PERFORMATIVES, strict=True)
    )
    acts = "  ".join(f"{step} takes 1ms  {step.replace('S', 'T')} takes 1ms" for step in steps)
    run = play(f"""
        system S
        message Note {{ string text }}
        aip p {{
          participant a {{ sends {sends}  process = {" . ".join(steps)} }}
          participant b {{ receives {sends}  process = {" . ".join(steps).replace("S", "T")} }}
          control a {{ {said_by} }}
          control b {{ {heard_by} }}
        }}
        srm r {{ plays p.a  liveness {{ r = a }}  activities {{ {acts} }} }}
        srm s {{ plays p.b  liveness {{ s = b }} }}
        team T {{ one : r  two : s }}
        """)
    assert [line.split()[2] for line in said(run)] == list(PERFORMATIVES)
    assert unexpected(run) == [] and run.result.reason == "finished"


def test_no_more_messages_wait_than_an_agent_can_remember(monkeypatch: pytest.MonkeyPatch) -> None:
    """Who asks for ever somebody who never listens is told, and nothing grows."""
    monkeypatch.setattr(participant_delivery, "WAITING", 20)
    run = play(
        """
        system S
        message Task { int n }
        aip ask {
          participant asker { sends request Task  process = Ask }
          participant teller { receives request Task  process = Answer }
          control asker { enter Ask : / send request Task to teller }
          control teller { enter Answer : request Task from asker }
        }
        srm boss { plays ask.asker  liveness { boss = asker~ }  activities { Ask takes 50ms } }
        srm worker { plays ask.teller  liveness { worker = Sleep . teller }  activities { Sleep takes 1min } }
        team T { boss1 : boss  worker1 : worker }
        """,
        until=10 * SECOND,
    )
    asked = len(run.of("agent_message", agent="boss1"))
    assert asked >= 150
    told = "worker1 request Task: 20 messages wait already for a participant to be entered"
    assert unexpected(run).count(told) == asked - 20
    conversations = run.team.conversations
    assert len(conversations._members.conversations) <= 21
