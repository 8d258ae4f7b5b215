"""`to one q`, `reply_by` and `..m` between whole agents."""

from __future__ import annotations

from tests.runtime.playing import Played, play
from tests.support.generated import generate

RIDES = """
system House
message Ride { string id  int floor }
message Answer { string id  bool fits }
aip ride {
  participant passenger {
    sends request Ride
    receives agree Answer, refuse Ride
    process = Ask . (Go | (Again . [Go2]))
  }
  participant lift [1..*] {
    sends agree Answer, refuse Ride
    receives request Ride
    process = Answer
  }
  control passenger {
    enter Ask : / send request Ride { id = "r", floor = 2 } reply_by 3s to one lift
    enter Go : agree Answer from lift
    enter (Again . [Go2]) : refuse Ride r from lift / send request Ride { floor = 3, ..r } to one lift
    enter Go2 : agree Answer from lift
    skip Go2 : refuse Ride from lift
  }
  control lift {
    enter Answer : request Ride from passenger
    leave Answer : [index == FULL] / send refuse Ride { id = "full", .. } to passenger
    leave Answer : else / send agree Answer { .. } to passenger
  }
}
srm person { plays ride.passenger  liveness { person = PERSON } }
srm cabin { plays ride.lift  liveness { cabin = lift~ }  activities { Answer takes 2s } }
team House { ann : person  cab[1..3] : cabin }
"""


def rides(person: str, full: int = 0) -> Played:
    return play(generate(RIDES.replace("PERSON", person).replace("FULL", str(full))), until=30_000_000_000)


def asked(run: Played) -> list[list[str]]:
    return [record["to"] for record in run.of("agent_message", performative="request")]


def test_the_one_that_was_addressed_least_recently() -> None:
    run = rides("passenger~")
    assert asked(run)[:5] == [["cab1"], ["cab2"], ["cab3"], ["cab1"], ["cab2"]]


def test_those_with_an_open_conversation_come_last() -> None:
    run = rides("passenger[2] || Rest")
    assert sorted(asked(run)) == [["cab1"], ["cab2"]]


def test_who_was_asked_in_this_conversation_is_not_asked_again() -> None:
    run = rides("passenger . Rest", full=1)
    assert asked(run) == [["cab1"], ["cab2"]]
    second = run.of("agent_message", performative="request")[1]
    assert second["content"] == {"id": "full", "floor": 3}, "what `..r` gives"


def test_the_receiver_sees_the_deadline() -> None:
    run = rides("passenger . Rest")
    (first,) = run.of("agent_message", performative="request")
    assert first["reply_by"] == first["time"] + 3_000_000_000
