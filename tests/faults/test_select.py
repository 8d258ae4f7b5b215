"""Which plan runs is chosen while the agents run, by an operator or by a message."""

from __future__ import annotations

from typing import Any

from aseme_dsl.runtime.activity.context import Context
from aseme_dsl.runtime.team.swap import Version
from aseme_dsl.runtime.trace.trace import Record
from tests.faults.changing import version
from tests.runtime.playing import MS, SECOND, check_line, make
from tests.support.generated import generate

TWO = """\
system Two
import runtime
message Ball { double x }
topic vision { state Ball }
srm goalie {
  var saves : int = 0
  liveness { goalie = Guard~ }
  activities { Guard takes 100ms reads vision.state.Ball }
  control goalie { repeat Guard : / saves = saves + 1 }
}
srm player {
  var saves : int = 7
  var goals : int = 3
  liveness { player = Chase~ }
  activities { Chase takes 70ms reads vision.state.Ball }
}
team Two { a : player  b : goalie }
"""


def play(
    text: str = TWO, changes: Any = lambda team: None, activities: Any = None, **options: Any
) -> tuple[Any, list[Record]]:
    made = generate(text)
    options = {"until": SECOND, "version": version(made, activities), **options}
    team, records = make(made, activities, **options)
    changes(team)
    team.run()
    for record in records:
        check_line(record)
    return team, records


def of(records: list[Record], kind: str, **members: Any) -> list[Record]:
    return [r for r in records if r["kind"] == kind and all(r.get(k) == v for k, v in members.items())]


def test_an_operator_chooses() -> None:
    team, records = play(changes=lambda team: team.select("b", "player", at=250 * MS))
    (line,) = of(records, "select")
    assert (line["agent"], line["plan"], line["by"], line["time"]) == (
        "b",
        "Two.player",
        "operator",
        250 * MS,
    )
    assert of(records, "activity", agent="b", what="cancel", activity="Guard")[0]["time"] == 250 * MS
    chases = of(records, "activity", agent="b", what="start", activity="Chase")
    assert [r["time"] // MS for r in chases[:3]] == [250, 320, 390]
    assert team.agent("b").role == "player"


def test_variables_and_what_is_known_stay_and_nothing_else() -> None:
    seen: list[Any] = []

    class Chase:
        def execute(self, context: Context) -> None:
            ball = context.latest_message("vision.state.Ball")
            seen.append((context.agent, None if ball is None else ball.x))

    script = [{"at": "50ms", "channel": "vision.state.Ball", "message": {"x": 4.5}}]
    team, _ = play(
        changes=lambda team: team.select("b", "player", at=350 * MS),
        activities={"Chase": Chase},
        script=script,
    )
    assert (team.agent("b").chart.variable("saves"), team.agent("b").chart.variable("goals")) == (3, 3)
    assert team.agent("a").chart.variable("saves") == 7
    assert ("b", 4.5) in seen


def test_a_plan_that_is_not_there_is_refused() -> None:
    base = play()[1]
    _, records = play(changes=lambda team: team.select("b", "striker", at=250 * MS))
    (line,) = of(records, "select")
    assert line["reason"] == "there is no plan striker; there are Two.goalie, Two.player"
    assert [r for r in records if r["kind"] != "select"] == base


def test_a_plan_that_runs_already_goes_on() -> None:
    base = play()[1]
    assert play(changes=lambda team: team.select("b", "Two.goalie", at=250 * MS))[1] == base


def test_a_message_chooses_for_another_or_for_oneself() -> None:
    chosen = TWO.replace(
        "control goalie {",
        "control goalie {\n    enter Guard : / "
        'a.runtime.signal.SelectPlan.plan = "goalie" ; write_messages.runtime.signal.SelectPlan\n',
    )
    _, records = play(chosen)
    (line,) = of(records, "select")
    assert (line["agent"], line["plan"], line["by"]) == ("a", "Two.goalie", "b")
    alone = chosen.replace("a.runtime.signal", "runtime.signal").replace('"goalie"', '"player"')
    _, records = play(alone)
    assert [(r["agent"], r["plan"], r["by"]) for r in of(records, "select")] == [("b", "Two.player", "b")]


def test_a_plan_of_another_system_that_the_robot_carries() -> None:
    other = version(
        "system Other\nsrm sweeper { liveness { sweeper = Sweep~ } activities { Sweep takes 40ms } }"
    )

    def carried() -> list[Version]:
        return [other]

    team, records = play(changes=lambda team: team.select("b", "sweeper", at=250 * MS), carried=carried)
    assert of(records, "select")[0]["plan"] == "Other.sweeper"
    assert team.agent("b").plan.system == "Other"
    assert len(of(records, "activity", agent="b", what="start", activity="Sweep")) > 10


def test_the_signal_that_the_runtime_reads_is_no_slip() -> None:
    from tests.support.compiling import codes

    chosen = TWO.replace(
        "control goalie {",
        'control goalie {\n    enter Guard : / runtime.signal.SelectPlan.plan = "player" ; '
        "write_messages.runtime.signal.SelectPlan\n",
    )
    assert codes(chosen) == codes(TWO)
