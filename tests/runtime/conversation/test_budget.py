"""A conversation has a budget of messages: two agents that answer each other without end stop."""

from __future__ import annotations

from aseme_dsl.runtime.driver.real_time import RealTime
from tests.runtime.outside import Outside
from tests.runtime.playing import SECOND, Played, make, play
from tests.runtime.transport.net import Air, part
from tests.support.generated import generate
from tests.support.waiting import wait_until

TEXT = """
system Quarrel
message Word { string text }
aip quarrel {
  participant one {
    sends inform Word, not_understood Word
    receives not_understood Word
    process = Say . Reply+ . Stopped
  }
  participant other {
    sends not_understood Word
    receives inform Word, not_understood Word
    process = Listen . Answer+ . Ended
  }
  control one {
    enter  Say     : / send inform Word { text = "yes" } to other
    enter  Reply+  : not_understood Word from other / send not_understood Word { text = "no" } to other
    repeat Reply   : not_understood Word from other / send not_understood Word { text = "no" } to other
    leave  Reply   : lost other gone [reason(gone) == exhausted]
    leave  Reply   : after(1min)
  }
  control other {
    enter  Listen  : inform Word from one
    enter  Answer+ : / send not_understood Word { text = "no" } to one
    repeat Answer  : not_understood Word from one / send not_understood Word { text = "no" } to one
    leave  Answer  : lost one gone [reason(gone) == exhausted]
    leave  Answer  : after(1min)
  }
}
srm a { plays quarrel.one    liveness { a = one }
  activities { Say takes 1s  Reply takes 1s  Stopped takes 1s } }
srm b { plays quarrel.other  liveness { b = other }
  activities { Listen takes 1s  Answer takes 1s  Ended takes 1s } }
team T { ann : a  bob : b }
"""

LIMIT = RealTime(conversation_limit=50)


def quarrel(**options: object) -> Played:
    return play(generate(TEXT), until=20 * SECOND, **options)


def test_two_agents_that_answer_each_other_without_end_stop() -> None:
    run = quarrel(real_time=LIMIT)
    assert len(run.of("agent_message")) == 50
    assert run.activities("start")[-2:] == ["1000 start Stopped", "1000 start Ended"]
    [fault] = run.of("fault")
    name = fault["reason"].split()[1]
    assert fault["reason"] == f"conversation {name} is over: the conversation has had 50 messages, its limit"
    assert {(r["agent"], r["peer"], r["reason"]) for r in run.of("conversation", what="gone")} == {
        ("ann", "bob", "exhausted"),
        ("bob", "ann", "exhausted"),
    }
    assert len(run.of("unsent", reason="the conversation has had 50 messages, its limit")) == 1


def test_the_limit_holds_between_processes() -> None:
    made, air = generate(TEXT), Air()
    ann = part(made, ["ann"], {}, air.link(), real_time=LIMIT).start()
    bob = part(made, ["bob"], {}, air.link(), real_time=RealTime(conversation_limit=5000)).start()
    wait_until(lambda: ann.of("activity", what="start", activity="Stopped"))
    wait_until(lambda: bob.of("activity", what="start", activity="Ended"))
    ann.stop()
    bob.stop()
    assert 40 < len(ann.of("agent_message")) + len(ann.of("received")) <= 51


def test_an_external_agent_that_says_nonsense_without_end_is_not_answered_for_ever() -> None:
    team, records = make(generate(TEXT), agents=[("bob", "b")], real_time=LIMIT, until=20 * SECOND)
    alice = Outside(team)
    alice.say(0, "inform", {"text": "yes"}, protocol="quarrel", conversation="c1", reply_with="a")
    for number in range(200):
        alice.say(
            number, "inform", "nonsense", protocol="quarrel", conversation="c1", reply_with=f"n{number}"
        )
    team.run()
    assert len(alice.heard) < 50
    assert [r["reason"] for r in records if r["kind"] == "fault"] == [
        "conversation c1 is over: the conversation has had 50 messages, its limit"
    ]
    gone = [r for r in records if r["kind"] == "conversation" and r["what"] == "gone"]
    assert [(r["agent"], r["peer"], r["reason"]) for r in gone] == [("bob", "alice@elsewhere", "exhausted")]
