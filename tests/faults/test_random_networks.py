"""Bad networks in virtual time: what they do to messages, and the races that only they show."""

from __future__ import annotations

from collections import Counter

import pytest

from aseme_dsl.grammar.text.network_words import read_network
from aseme_dsl.runtime import Context
from tests.runtime.playing import MS, SECOND, check_line
from tests.support.generated import Generated, generate
from tests.support.networks import BAD, Part, noting, runs

FIRST = """
system First
message Word { int n }
aip talk {
  participant left {
    sends    request Word, agree Word
    receives request Word, agree Word
    process  = Ready . (Speak . Hear | Answer)
  }
  participant right {
    sends    request Word, agree Word
    receives request Word, agree Word
    process  = Ready . (Speak . Hear | Answer)
  }
  control left {
    enter (Speak . Hear) : after(10ms) / send request Word { n = 1 } to right
    enter Answer         : request Word from right
    enter Hear           : agree Word from right
    leave Answer         : / send agree Word { n = 2 } to right
  }
  control right {
    enter (Speak . Hear) : after(60ms) / send request Word { n = 1 } to left
    enter Answer         : request Word from left
    enter Hear           : agree Word from left
    leave Answer         : / send agree Word { n = 2 } to left
  }
}
srm one { plays talk.left   liveness { one = left }
          activities { Ready takes 1ms  Speak takes 1ms  Hear takes 1ms  Answer takes 1ms } }
srm two { plays talk.right  liveness { two = right }
          activities { Ready takes 1ms  Speak takes 1ms  Hear takes 1ms  Answer takes 1ms } }
team T { ann : one  bob : two }
"""
"""Each side may speak first: a non-local choice. The left one is 50 ms quicker."""


def test_a_choice_of_both_sides_blocks_only_on_a_slow_network() -> None:
    """P3: in one process the quicker side always wins, and nothing shows the race."""
    (good,) = runs(FIRST, None, seeds=[1])
    assert good.finished
    assert (good.ended("ann"), good.ended("bob")) == (["Hear"], ["Answer"])
    found = Counter(run.finished for run in runs(FIRST, "delay=0..300ms", until=60 * SECOND))
    assert found[True] and found[False], found
    (bad,) = runs(FIRST, "delay=100ms", until=60 * SECOND, seeds=[1])
    assert set(bad.stuck) == {"ann", "bob"}
    assert bad.messages[:2] == ["ann request Word to bob", "bob request Word to ann"]


WORK = """
system Work
message Job { int n }
aip hire {
  participant boss {
    var ending : string = ""
    sends    request Job, cancel Job
    receives inform Job
    process  = Ask . Wait . Learn
  }
  participant hand {
    var ending : string = ""
    sends    inform Job
    receives request Job, cancel Job
    process  = Do . Tell . (Stop | Rest) . Learn
  }
  control boss {
    enter Wait  : / send request Job { n = 1 } to hand
    enter Learn : inform Job from hand / ending = "done"
    enter Learn : after(1s) / ending = "timed out"; send cancel Job { n = 1 } to hand
  }
  control hand {
    enter Do   : request Job from boss
    enter Tell : / send inform Job { n = 1 } to boss
    enter Stop : cancel Job from boss / ending = "timed out"
    enter Rest : after(2s) / ending = "done"
  }
}
srm chief  { plays hire.boss  liveness { chief = boss }
             activities { Ask takes 1ms  Wait takes 1ms  Learn takes 1ms } }
srm worker { plays hire.hand  liveness { worker = hand }
             activities { Do takes 900ms  Tell takes 1ms  Stop takes 1ms  Rest takes 1ms  Learn takes 1ms } }
team T { ann : chief  bob : worker }
"""
"""The answer is 100 ms before the deadline."""


def test_a_deadline_crosses_an_answer_only_on_a_slow_network() -> None:
    """P4: the work is done, and the one who asked for it says that it timed out."""
    activities = {"Learn": noting("ending")}
    (good,) = runs(WORK, None, seeds=[1], activities=activities)
    assert [item.values["ending"] for item in good.outcomes] == ["done", "done"]
    found = Counter(
        tuple(str(item.values["ending"]) for item in sorted(run.outcomes, key=lambda item: item.agent))
        for run in runs(WORK, BAD, activities=activities)
    )
    assert found["done", "done"] and found["timed out", "timed out"], found


TALK = """
system Talk
message Note { int n }
topic line { signal Note queued  state Note  data Note }
topic air radio 100 { state Note }
srm speaker {
  liveness { speaker = Speak~ }
  activities { Speak every 20ms writes line.signal.Note, line.state.Note, line.data.Note, air.state.Note }
}
srm hearer {
  liveness { hearer = Hear }
  activities { Hear takes 1min  reads line.signal.Note, line.state.Note, line.data.Note, air.state.Note }
}
team Talk { one : speaker  ear : hearer }
"""


class Speak:
    def execute(self, context: Context) -> None:
        if context.now_ns < SECOND:
            note = NOTES["kind"](n=context.now_ns // MS)
            for kind in ("line.signal", "line.state", "line.data", "air.state"):
                context.publish(f"{kind}.Note", note)


NOTES: dict[str, type] = {}


def talk() -> Generated:
    made = generate(TALK)
    NOTES["kind"] = made.messages.Note
    return made


def heard(network: str | None, seed: int = 1) -> dict[str, list[tuple[int, int]]]:
    """For each channel what the hearer's steps took: when it was sent, and when it came, in ms."""
    (run,) = runs(talk(), network, seeds=[seed], until=3 * SECOND, activities={"Speak": Speak})
    for record in run.records:
        check_line(record)
    sent = {(r["agent"], r["sequence"]): r for r in run.records if r["kind"] == "message"}
    found: dict[str, list[tuple[int, int]]] = {}
    for step in run.records:
        if step["kind"] == "step" and step["agent"] == "ear":
            for identity in step["inputs"]:
                if tuple(identity) in sent:
                    record = sent[tuple(identity)]
                    found.setdefault(record["channel"], []).append((record["time"] // MS, step["time"] // MS))
    found["lost"] = [
        (sent[tuple(r["input"])]["time"] // MS, r["time"] // MS) for r in run.records if r["kind"] == "lost"
    ]
    return found


def test_each_message_takes_a_time_from_the_range() -> None:
    got = heard("delay=40..90ms")
    for channel in ("line.data.Note", "air.state.Note"):
        took = [came - sent for sent, came in got[channel]]
        assert len(took) == 50 and min(took) >= 40 and max(took) <= 90 and len(set(took)) > 5, channel
    assert not got["lost"]


def test_one_delay_is_the_same_for_all() -> None:
    got = heard("delay=50ms")
    assert {came - sent for channel in got for sent, came in got[channel]} == {50}


@pytest.mark.parametrize("channel", ["line.data.Note", "air.state.Note"])
def test_samples_overtake_each_other_only_with_reorder(channel: str) -> None:
    ordered = [sent for sent, _ in heard("delay=0..300ms")[channel]]
    assert ordered == sorted(ordered) and len(ordered) == 50
    mixed = [sent for sent, _ in heard("delay=0..300ms,reorder")[channel]]
    assert mixed != sorted(mixed) and sorted(mixed) == ordered


def test_signals_and_states_come_once_and_in_order_however_bad_it_is() -> None:
    got = heard("delay=0..300ms,loss=40%,reorder")
    signals = [sent for sent, _ in got["line.signal.Note"]]
    assert signals == sorted(set(signals)) and len(signals) == 50
    states = [sent for sent, _ in got["line.state.Note"]]
    assert states == sorted(set(states)) and states[-1] == signals[-1]  # a newer one may take its place
    assert max(came - sent for sent, came in got["line.signal.Note"]) > 300  # it was lost and sent again
    for channel in ("line.data.Note", "air.state.Note"):
        assert 15 < len(got[channel]) < 45, channel
    assert len(got["lost"]) == 100 - len(got["line.data.Note"]) - len(got["air.state.Note"])


def test_a_lost_message_is_in_the_trace_and_no_fault() -> None:
    (run,) = runs(talk(), "loss=50%", seeds=[1], until=SECOND, activities={"Speak": Speak})
    lost = [r for r in run.records if r["kind"] == "lost"]
    assert lost and {r["channel"] for r in lost} == {"line.data.Note", "air.state.Note"}
    assert {(r["agent"], r["peer"]) for r in lost} == {("one", "ear")}
    assert not run.faults


def test_the_same_seed_is_the_same_run_and_another_is_not() -> None:
    one, again, other = (next(runs(WORK, BAD, seeds=[seed])).records for seed in (3, 3, 4))
    assert one == again
    assert [r["time"] for r in one] != [r["time"] for r in other]
    assert one[0]["network"] == "delay 0..300ms loss 10% reorder"
    assert "network" not in next(runs(WORK, None, seeds=[3])).records[0]


def test_what_a_run_says_of_itself() -> None:
    (run,) = runs(WORK, "delay=10ms", seeds=[5], activities={"Learn": noting("ending")})
    boss, hand = run.parts
    assert boss == Part("ann", "boss", "hire-ann-1", ("Wait", "Learn"), True, 0)
    assert (hand.participant, hand.last, hand.left) == ("hand", "Learn", True)
    assert run.messages == ["ann request Job to bob", "bob inform Job to ann"]
    assert run.logs == ['ann Learn: {"ending": "done"}', 'bob Learn: {"ending": "done"}']
    assert not (run.faults or run.failures or run.stuck or run.open or run.unexpected)
    assert str(run).startswith("seed 5: finished after ")


@pytest.mark.parametrize(
    ("words", "meant"),
    [
        ("delay=0..300ms,loss=10%,reorder", "delay 0..300ms loss 10% reorder"),
        ("delay 0..300ms loss 20% reorder", "delay 0..300ms loss 20% reorder"),
        ("reorder , loss = 2.5% , delay = 33ms..1.5s", "delay 33ms..1500ms loss 2.5% reorder"),
        ("delay=50ms", "delay 50ms"),
        ("delay=1..2min", "delay 1min..2min"),
        ("delay=0.25ms", "delay 0.25ms"),
        ("loss=0%", "delay 0ms"),
        ("delay=0ms", "delay 0ms"),
    ],
)
def test_the_words_of_a_network(words: str, meant: str) -> None:
    network = read_network(words)
    assert str(network) == meant
    assert read_network(meant) == network
