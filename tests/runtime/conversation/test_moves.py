"""Only moves of the protocol are sent: what an activity may send, in which state, and how often."""

from __future__ import annotations

from typing import Any

import pytest

from aseme_dsl.runtime import Context
from tests.runtime.playing import SECOND, Played, play
from tests.support.generated import Generated, generate

NET = """
system Net
message Task    { string id }
message Bid     { double cost }
message Award   { string id }
message Outcome { string id }
message Note    { string text }
aip net {
  participant manager {
    var best : agent
    sends cfp Task, accept_proposal Award BY, reject_proposal Award
    receives propose Bid, inform Outcome, inform Note
    process = Announce . Collect . AwardTask . Await
  }
  participant contractor [1..*] {
    sends propose Bid, inform Outcome, inform Note by Work REPEATEDLY
    receives cfp Task, accept_proposal Award, reject_proposal Award
    process = Evaluate . (Work . Report | Lose)
  }
  control manager {
    enter Announce : / send cfp Task { id = "t" } to contractor
    enter Collect  : after(1s)
    leave Await    : inform Outcome from contractor
  }
  control contractor {
    enter Evaluate : cfp Task from manager / send propose Bid { cost = 1 } to manager
    enter (Work . Report) : accept_proposal Award from manager
    enter Lose     : reject_proposal Award from manager
    enter Report   : / send inform Outcome { id = "t" } to manager
  }
}
srm desk  { plays net.manager WITH liveness { desk = manager } activities { Announce takes 10ms } }
srm robot { plays net.contractor  liveness { robot = contractor } activities { KIND } }
team T { desk : desk  r1, r2 : robot }
"""


def net(by: str = "by AwardTask", repeatedly: str = "", bound: str = "", kind: str = "") -> Generated:
    text = NET.replace("BY", by).replace("REPEATEDLY", repeatedly).replace("WITH", bound)
    return generate(text.replace("activities { KIND }", f"activities {{ {kind} }}" if kind else ""))


class Quiet:
    def execute(self, context: Context) -> None:
        context.wait(0.1)


def run(generated: Generated, **classes: Any) -> Played:
    class AwardTask:
        def execute(self, context: Context) -> None:
            context.send("accept_proposal", generated.message("Award"), "r1")
            context.send("reject_proposal", generated.message("Award"), "r2")

    default = {"AwardTask": AwardTask, "Work": Quiet, "Lose": Quiet, "Evaluate": Quiet, "Collect": Quiet}
    return play(generated, {**default, **classes}, until=30 * SECOND)


def said(played: Played, agent: str) -> list[str]:
    return [
        f"{r['performative']} {r['message']} -> {' '.join(r['to'])}"
        for r in played.of("agent_message", agent=agent)
    ]


def refusals(played: Played) -> list[tuple[str, str]]:
    return [(r["agent"], r["reason"]) for r in played.of("fault") if "code" not in r]


def test_the_named_activity_sends_and_the_award_is_carried_out() -> None:
    played = run(net())
    assert refusals(played) == []
    assert said(played, "desk") == [
        "cfp Task -> r1 r2",
        "accept_proposal Award -> r1",
        "reject_proposal Award -> r2",
        "not_understood Bid -> r1",  # nothing has taken it when the part ends
    ]
    assert said(played, "r1")[-1] == "inform Outcome -> desk"
    assert played.result.reason == "finished"


def test_the_loser_cannot_forge_the_result_of_the_winner() -> None:
    """P1: what a transition sends, no activity sends, in whatever state."""
    generated = net()
    errors: list[str] = []

    class Lose:
        def execute(self, context: Context) -> None:
            try:
                context.send("inform", generated.message("Outcome", id="mine"), "desk")
            except LookupError as error:
                errors.append(str(error))

    played = run(generated, Lose=Lose)
    why = "activity Lose may not send inform Outcome: a transition of contractor sends it"
    assert errors == [why]
    assert refusals(played) == [("r2", why)]
    assert said(played, "r2") == ["propose Bid -> desk"]
    assert played.result.reason == "finished"


def test_an_activity_that_is_not_named_is_refused_and_fails() -> None:
    generated = net()

    class Collect:
        def execute(self, context: Context) -> None:
            context.send("accept_proposal", generated.message("Award"), "r1")

    played = run(generated, Collect=Collect)
    (refused,) = refusals(played)
    assert (
        refused[1]
        == "activity Collect may not send accept_proposal Award: net.manager leaves that to AwardTask"
    )
    (crash,) = played.of("activity", what="crash")
    assert refused[1] in crash["reason"]
    assert said(played, "desk") == [
        "cfp Task -> r1 r2",
        "reject_proposal Award -> r1",  # since the part has failed
        "reject_proposal Award -> r2",
    ]


def test_without_a_name_any_activity_of_the_participant_sends_it() -> None:
    generated = net(by="")

    class Collect:
        def execute(self, context: Context) -> None:
            context.send("accept_proposal", generated.message("Award"), "r1")

    class AwardTask:
        def execute(self, context: Context) -> None:
            context.send("reject_proposal", generated.message("Award"), "r2")

    played = run(generated, Collect=Collect, AwardTask=AwardTask)
    assert refusals(played) == []
    assert played.result.reason == "finished"


@pytest.mark.parametrize(("repeatedly", "sent"), [("", 1), ("repeatedly", 3)])
@pytest.mark.parametrize("to", ["desk", "manager"])
@pytest.mark.parametrize("kind", ["", "Work as async", "Work as process"])
def test_once_to_each_agent_unless_repeatedly(repeatedly: str, sent: int, to: str, kind: str) -> None:
    generated = net(repeatedly=repeatedly, kind=kind)

    class Work:
        def execute(self, context: Context) -> None:
            for name in (to, "desk", "manager"):
                context.send("inform", generated.message("Note"), name)

    class Later:
        async def execute(self, context: Context) -> None:
            Work().execute(context)

    played = run(generated, Work=Later if "async" in kind else Work)
    assert said(played, "r1").count("inform Note -> desk") == sent
    assert len(refusals(played)) == (sent == 1)
    if sent == 1:
        assert refusals(played)[0][1] == (
            "activity Work has sent inform Note to desk already since its state was entered: "
            "`sends inform Note by Work repeatedly` in net.contractor allows it"
        )


def test_a_bound_activity_sends_in_place_of_the_protocols() -> None:
    generated = net(bound="with AwardTask = Choose")

    class Choose:
        def execute(self, context: Context) -> None:
            context.send("accept_proposal", generated.message("Award"), "r1")
            context.send("reject_proposal", generated.message("Award"), "r2")

    played = run(generated, Choose=Choose)
    assert refusals(played) == []
    assert played.result.reason == "finished"


def test_what_the_participant_does_not_send_at_all() -> None:
    generated = net()

    class AwardTask:
        def execute(self, context: Context) -> None:
            context.send("refuse", generated.message("Task"), "r1")

    played = run(generated, AwardTask=AwardTask)
    ((agent, why),) = refusals(played)
    assert agent == "desk"
    assert why.startswith(
        "manager sends cfp Task, accept_proposal Award, reject_proposal Award, not refuse Task"
    )


BEST = (
    NET.replace("BY", "by AwardTask")
    .replace(" REPEATEDLY", "")
    .replace("WITH ", "")
    .replace("activities { KIND } ", "")
    .replace("leave Await    : inform Outcome from contractor", "leave Await : EVENT")
)


@pytest.mark.parametrize(
    "event",
    [
        "inform Outcome from best",
        'inform Outcome o from best [o.id == "t"]',
        "inform Outcome from best or inform Note from best",
        "inform Outcome o from contractor [sender(o) == best]",
    ],
)
def test_a_message_from_one_agent_is_taken_from_that_one_only(event: str) -> None:
    """Both are awarded; r1 is done first, and the manager waits for r2."""
    generated = generate(BEST.replace("EVENT", event))

    class AwardTask:
        def execute(self, context: Context) -> None:
            context.set_variable("best", "r2")
            for name in ("r1", "r2"):
                context.send("accept_proposal", generated.message("Award"), name)

    class Work:
        def execute(self, context: Context) -> None:
            context.wait(1 if context.agent == "r1" else 5)

    played = run(generated, AwardTask=AwardTask, Work=Work)
    done = {r["agent"]: r["time"] for r in played.of("agent_message") if r["message"] == "Outcome"}
    assert done["r1"] < done["r2"]
    (left,) = [r["time"] for r in played.of("conversation", agent="desk") if r["what"] == "leave"]
    assert left >= done["r2"]
    assert played.result.reason == "finished"
