"""A message waits while a later state of its participant can take it; else it is `not_understood`."""

from __future__ import annotations

import re

import pytest

from tests.runtime.playing import MS, SECOND, Played, play
from tests.support.generated import generate

TEXT = """
system Shop
message Note {{ string text }}
aip talk {{
  participant clerk {{
    sends inform Note, request Note, confirm Note
    receives not_understood Note
    process = Say . Listen
  }}
  participant guest {{
    receives inform Note, request Note, confirm Note
    process = {process}
  }}
  control clerk {{
    enter Say    : / send inform Note {{ text = "open" }} to guest
    enter Listen : {sent}
    leave Listen : not_understood Note from guest or after(9s)
  }}
  control guest {{
    {control}
  }}
}}
srm a {{ plays talk.clerk  liveness {{ a = clerk . After }}
  activities {{ Say takes 1s  Listen takes 20s  After takes 1s }} }}
srm b {{ plays talk.guest  liveness {{ b = guest }}
  activities {{ {activities} }} }}
team T {{ ann : a  bob : b }}
"""
REQUEST = '/ send request Note { text = "late" } to guest'


def talk(process: str, control: str, sent: str = REQUEST) -> Played:
    names = dict.fromkeys(re.findall("[A-Z][a-z]+", process))
    activities = "  ".join(f"{name} takes 3s" for name in names)
    text = TEXT.format(process=process, control=control, sent=sent, activities=activities)
    return play(generate(text), until=30 * SECOND)


def unexpected(run: Played) -> list[str]:
    return [f"{r['time'] / MS:g} {r['performative']}: {r['reason']}" for r in run.of("unexpected")]


LATER = "no later state of guest takes it"


@pytest.mark.parametrize(
    ("process", "control", "found"),
    [
        pytest.param(
            "First . Second",
            "enter First : inform Note from clerk or request Note from clerk",
            [f"1000 request: {LATER}"],
            id="only the first state takes it",
        ),
        pytest.param(
            "First . Second . Third",
            "enter First : inform Note from clerk\n    enter Third : request Note from clerk",
            [],
            id="a later state takes it",
        ),
        pytest.param(
            "First . Second . Third",
            """enter First : inform Note from clerk
    enter Third : request Note n from clerk [n.text == "never"]""",
            [],
            id="a condition may hold",
        ),
        pytest.param(
            "First . Second+",
            """enter First : inform Note from clerk
    leave Second : request Note from clerk
    repeat Second : [true]""",
            [],
            id="a loop comes back to it",
        ),
        pytest.param(
            "First . (Left || Right)",
            "enter First : inform Note from clerk\n    leave Right : request Note from clerk",
            [],
            id="another region takes it",
        ),
        pytest.param(
            "First . Second",
            "enter First : inform Note from clerk",
            ["6000 request: its part in the conversation is over"],
            id="an activity may take it",
        ),
        pytest.param(
            "(First . Second) [> Third",
            "enter First : inform Note from clerk\n    enter Third : request Note from clerk",
            [],
            id="an interrupt takes it",
        ),
    ],
)
def test_who_takes_a_message_later(process: str, control: str, found: list[str]) -> None:
    assert unexpected(talk(process, control)) == found


def test_who_has_sent_it_learns_at_once() -> None:
    run = talk("First . Second", "enter First : inform Note from clerk or request Note from clerk")
    assert run.activities("start")[-2:] == ["1000 start After", "3000 start Second"]


def test_what_waits_is_answered_when_the_last_state_that_takes_it_is_left() -> None:
    run = talk(
        "First . [Second] . Third",
        """enter First  : inform Note from clerk
    enter Second : request Note n from clerk [n.text == "never"]
    skip  Second : after(2s)""",
    )
    assert unexpected(run) == [f"5000 request: {LATER}"]


ENDS = """
system Shop
message Job { string id }
aip work {
  participant boss {
    sends request Job, cancel Job
    receives inform Job, not_understood Job
    process = Ask . Wait
  }
  participant hand {
    sends inform Job
    receives request Job, cancel Job
    process = Do
  }
  control boss {
    enter Ask  : / send request Job { id = "j" } to hand
    enter Wait : after(1s) / send cancel Job { id = "j" } to hand
    leave Wait : WAIT
  }
  control hand {
    enter Do : request Job from boss
    leave Do : after(3s) SAY
    leave Do : cancel Job from boss [count(Do) == 2]
  }
}
srm a { plays work.boss  liveness { a = boss . After }  activities { Ask waits  Wait waits  After takes 9s } }
srm b { plays work.hand  liveness { b = hand . Rest }  activities { Do waits  Rest takes 9s } }
team Shop { ann : a  bob : b }
"""


@pytest.mark.parametrize(
    ("wait", "say", "answers"),
    [
        pytest.param("after(5s)", "", ["not_understood"], id="nothing tells the sender"),
        pytest.param("lost hand", "", [], id="the sender hears that it is lost"),
        pytest.param(
            "inform Job from hand", "/ send inform Job { .. } to boss", ["inform"], id="the end is the answer"
        ),
    ],
)
def test_what_waits_at_the_end_of_a_part_is_answered_once(wait: str, say: str, answers: list[str]) -> None:
    run = play(generate(ENDS.replace("WAIT", wait).replace("SAY", say)), until=8 * SECOND)
    assert [record["performative"] for record in run.of("agent_message", agent="bob")] == answers
    (leave,) = run.of("conversation", agent="bob", what="leave")
    assert ("untaken" in leave) == (answers != ["not_understood"])
    assert len(run.of("unexpected", agent="bob")) == (answers == ["not_understood"])


def test_an_answer_that_the_sender_does_not_list_is_recorded_and_not_answered() -> None:
    text = ENDS.replace("inform Job, not_understood Job", "inform Job").replace("WAIT", "after(5s)")
    run = play(generate(text.replace("SAY", "")), until=8 * SECOND)
    records = [(r["agent"], r["performative"]) for r in run.of("unexpected")]
    assert records == [("bob", "cancel"), ("ann", "not_understood")]
    assert [r["performative"] for r in run.of("agent_message")] == ["request", "cancel", "not_understood"]
