"""A hundred times the message rate: memory is bounded, queued signals stay whole, the trace says so."""

from __future__ import annotations

import threading
from typing import Any

from aseme_dsl.runtime.chart.input_queue import CROWD, Intake, Posted
from aseme_dsl.runtime.chart.inputs import Sample
from aseme_dsl.runtime.team.team import Team
from tests.runtime.playing import MS, SECOND, make
from tests.support.waiting import LONG

TEXT = """
system S
message M { int n }
topic t { state M  data M  signal M  signal Q queued }
message Q { int n }
srm R {
  var taken : int = 0
  var last : int = 0
  liveness { R = Take~ || Follow~ }
  activities { Take takes 60min  Follow takes 60min }
  control R {
    repeat Take : when [t.signal.Q.n > 0] / taken = taken + t.signal.Q.n
    repeat Follow : when [t.state.M.n > last && t.signal.M.n > 0 && t.data.M.n > 0] / last = t.state.M.n
  }
}
"""
SENT = 50_000
SIGNALS = 300


def test_a_flood_is_bounded_and_queued_signals_are_all_taken() -> None:
    """Everything is sent while the agent is in one long step: nothing is taken meanwhile."""
    waited: list[int] = []

    def over(team: Team) -> str | None:
        chart = team.agents[0].chart
        return "all taken" if (chart.variable("taken"), chart.variable("last")) == (SIGNALS, SENT) else None

    team, records = make(TEXT, clock="real", until=round(LONG) * SECOND, stop=over)
    (agent,) = team.agents
    kinds = team._messages

    def send() -> None:
        with team.driver.guard(agent):  # as a step that takes long does
            for number in range(1, SENT + 1):
                for kind in ("state", "data", "signal"):
                    give(f"t.{kind}.M", kinds["M"](number))
                if number % (SENT // SIGNALS) == 0 and number // (SENT // SIGNALS) <= SIGNALS:
                    give("t.signal.Q", kinds["Q"](1))
            waited.append(len(agent.intake))

    def give(channel: str, message: Any) -> None:
        nonlocal sent
        sent += 1
        identity = ("input", sent)
        agent.post(identity, Sample(channel, message, "ann", team.driver.clock.now(), identity))

    sent = 0
    thread = threading.Thread(target=send)
    team.driver.at(20 * MS, thread.start)
    result = team.run()
    thread.join()
    assert result.reason == "all taken"
    assert waited[0] <= CROWD + SIGNALS + 3
    crowds = [record for record in records if record["kind"] == "overload"]
    assert sum(record["left_out"] for record in crowds) == 3 * SENT + SIGNALS - waited[0]
    assert max(record["most"] for record in crowds) == waited[0]
    faults = [record["reason"] for record in records if record["kind"] == "fault"]
    assert faults.count("me is sent more than it can take: of states and data only the newest are kept") == 1


def arrived(channel: str, sender: str, number: int, region: str | None = None) -> Posted:
    identity = (sender, number)
    return Posted(identity, Sample(channel, number, sender, 0, identity, region))


def test_what_nobody_could_have_seen_is_left_out_and_nothing_else() -> None:
    intake = Intake(frozenset({"t.signal.Q"}), bounded=True)
    for number in range(CROWD):
        intake.append(arrived("t.state.M", "ann", number))
    for number in range(10):
        intake.append(arrived("t.state.M", "ann", CROWD + number))
        intake.append(arrived("t.state.M", "bob", number))
        intake.append(arrived("t.signal.Q", "ann", number))
        intake.append(arrived("t.state.M", "ann", number, region="0.2.1"))
    intake.append(arrived("t.state.M", "bob", 10))
    taken = intake.take()
    identities = [item.identity for item in taken if isinstance(item, Posted)]
    assert identities[:CROWD] == [("ann", number) for number in range(CROWD)]
    assert identities[CROWD:] == [
        *(("ann", number) for number in range(10)),  # the queued signals
        ("ann", CROWD + 9),
        ("ann", 9),
        ("bob", 10),
    ]
    assert intake.left_out == 9 + 9 + 10 and not intake


def test_virtual_time_takes_everything() -> None:
    intake = Intake(frozenset(), bounded=False)
    for number in range(3 * CROWD):
        intake.append(arrived("t.state.M", "ann", number))
    assert len(intake.take()) == 3 * CROWD and not intake.left_out
