"""`when busy` behind `plays`: what may be answered to an invitation, and with which content."""

from __future__ import annotations

import pytest

from aseme_dsl.compiler import analyse
from aseme_dsl.diagnostics.pages import page
from aseme_dsl.project.code.activity_code import check_silence
from aseme_dsl.source import Source
from tests.support.compiling import system

PLAYS = 'plays work.worker when busy refuse Sorry { text = "later" }'


def found(plays: str, old: str = PLAYS) -> list[tuple[str, str, str]]:
    text = page("E596").right.files[0].text
    assert old in text
    problems = analyse(Source("/nowhere/shop.aseme", text.replace(old, plays))).diagnostics
    return [(item.code, item.span.text, item.message) for item in problems if item.code.startswith("E")]


@pytest.mark.parametrize(
    "busy",
    [
        "when busy queue",
        "as w when busy refuse Sorry { .. }",
        'when busy refuse Sorry { text = "a, b" }',
        "with Look = Watch when busy queue",
    ],
)
def test_what_may_be_said(busy: str) -> None:
    assert found(f"plays work.worker {busy}".replace("as w", "")) == []


@pytest.mark.parametrize(
    ("busy", "code", "place", "message"),
    [
        (
            "refuse",
            "E596",
            "when busy refuse",
            "`refuse Sorry` has no content; the invitation is `request Job`",
        ),
        ("wait", "E596", "when busy wait", "`wait` alone does not answer an invitation"),
        ("refuse Sorry { }", "E577", "{ }", "the content of `Sorry` leaves out `text`"),
        ("refuse Sory", "E511", "Sory", "`worker` does not list `sends refuse Sory`"),
        ("refuze Sorry", "E512", "refuze", "there is no performative `refuze`"),
        ("refuse Sorry { text = word }", "E596", "word", "the answer of a busy participant must be constant"),
        ("refuse Sorry { text = 3 }", "E500", "3", "`3` is int, not string"),
        ("queue Sorry", "E512", "queue", "there is no performative `queue`"),
    ],
)
def test_what_may_not(busy: str, code: str, place: str, message: str) -> None:
    (first, *others) = found(f'plays work.worker when busy {busy}  var word : string = "x"')
    assert not others
    assert first[:2] == (code, place)
    assert message in first[2] or code in ("E500", "E512")


def test_nothing_invites_who_opens_its_conversations_itself() -> None:
    (first,) = found("plays work.client when busy queue", "plays work.client")
    assert first[2] == "nothing invites `client`: it opens its conversations itself"


def test_two_answers_of_one_participant() -> None:
    twice = f"{PLAYS}, work.worker as again when busy queue"
    text = "plays work.worker when busy refuse Sorry { .. }, work.worker as again when busy queue"
    assert [item[:2] for item in found(text)] == [("E596", "when busy queue")]
    assert found(twice.replace("when busy queue", "")) == [], "said once, it holds for both"


def test_nothing_behind_busy() -> None:
    assert [item[0] for item in found("plays work.worker when busy")] == ["E100"]
    assert [item[0] for item in found("plays work.worker when busy refuse Sorry { .. } now")] == ["E102"]


TAXI = """system Taxis
message Call { int floor }
aip rides {
  participant caller {
    sends    request Call
    receives inform Call, refuse Call
    process  = Ask [> Ride
  }
  participant taxi {
    sends    inform Call, refuse Call
    receives request Call
    process  = Stand [> Drive
  }
  control caller {
    enter Ask  : / send request Call { floor = 1 } to taxi
    enter Ride : refuse Call from taxi
    leave Ride : after(1s)
  }
  control taxi {
    enter Stand : request Call from caller
    enter Drive : after(1s)
    leave Drive : / send inform Call { .. } to caller
  }
}
srm person { plays rides.caller  liveness { person = caller }  activities { Ask waits  Ride waits } }
srm car {
  plays rides.taxi when busy refuse Call
  liveness { car = taxi~ }
  activities { Stand waits  Drive takes 1s }
}
team Town { ann : person  t : car }
"""


def about_refuse(text: str) -> list[tuple[str, str, str | None]]:
    """What is said of who sends the refusal."""
    problems = analyse(Source("/nowhere/taxis.aseme", text)).diagnostics
    return [
        (item.code, item.message, item.hint)
        for item in problems
        if item.code in ("N755", "W553", "W556", "W524")
    ]


def test_a_busy_answer_is_a_message_that_is_sent() -> None:
    assert about_refuse(TAXI) == []
    assert about_refuse(TAXI.replace("busy refuse Call", "busy refuse")) == []
    without = TAXI.replace(" when busy refuse Call", "")
    assert [item[0] for item in about_refuse(without)] == ["N755"]
    assert [item[0] for item in about_refuse(TAXI.replace("busy refuse Call", "busy queue"))] == ["N755"]


def test_the_hint_names_an_activity_that_can_send() -> None:
    without = TAXI.replace(" when busy refuse Call", "")
    assert about_refuse(without)[0][2] == "write `sends refuse Call by Drive`"
    silent = without.replace("Drive takes 1s }", "Drive takes 1s simulated }")
    assert "N755" not in [item[0] for item in about_refuse(silent)], "nothing may send it, not anything"
    bound = silent.replace("plays rides.taxi", "plays rides.taxi with Drive = Fly").replace(
        "Drive takes", "Fly takes"
    )
    assert "N755" not in [item[0] for item in about_refuse(bound)]
    coded = bound.replace("1s simulated }\n}\nteam", "1s }\n}\nteam")
    assert about_refuse(coded)[0][2] == "write `sends refuse Call by Drive`"


def test_a_simulated_part_refuses_while_it_is_busy() -> None:
    simulated = TAXI.replace("Drive takes 1s }", "Drive takes 1s simulated }")
    assert about_refuse(simulated) == []
    assert [item.code for item in check_silence(system(simulated))[0]] == ["W556"], (
        "`inform Call` is not taken"
    )
