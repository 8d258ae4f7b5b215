"""Swapping a running team to another version: what goes on, what is refused, what else changes: nothing."""

from __future__ import annotations

import os
from typing import Any

import pytest

from aseme_dsl.runtime.activity.context import Context
from aseme_dsl.runtime.team.swap import Version
from aseme_dsl.runtime.team.team import Team
from aseme_dsl.runtime.trace.trace import Record
from tests.faults.changing import version, without
from tests.oracle.charts import text as random_text
from tests.oracle.choices import Choices
from tests.oracle.examples import forget
from tests.runtime.playing import MS, SECOND, check_line, make
from tests.support.generated import Generated, generate

EXAMPLES = int(os.environ.get("SWAP_EXAMPLES", "6"))

ONE = """\
system S
message Ball { double x  bool near }
topic vision { state Ball  data Ball }
srm player {
  var kicks : int = 0
  liveness {
    player = Look~ || play~
    play   = Search . (Kick | Wait)
  }
  activities { Look takes 30ms  Search takes 100ms  Kick takes 300ms  Wait takes 200ms }
  control play {
    enter Kick : [kicks < 100] / kicks = kicks + 1
    enter Wait : else
  }
}
team S { a : player  b : player }
"""

GUARD = """\
system S
statechart guard {
  state 0 OR  state 0.1 START  state 0.2 BASIC Rest
  state 0.3 AND
  state 0.3.1 OR  state 0.3.1.1 START  state 0.3.1.2 BASIC Look   state 0.3.1.3 BASIC Follow
  state 0.3.2 OR  state 0.3.2.1 START  state 0.3.2.2 BASIC Stand  state 0.3.2.3 BASIC Walk
  0.1 -> 0.2 :  0.3.1.1 -> 0.3.1.2 :  0.3.2.1 -> 0.3.2.2 :
  0.2 -> (0.3.1.3, 0.3.2.3) : after(1s)
  0.3 -> 0.2 : after(1s)
  activities { Rest waits  Look waits  Follow waits  Stand waits  Walk waits }
}
team S { a : guard }
"""

WITHOUT_KICK = """\
system S
message Ball { double x  bool near }
topic vision { state Ball  data Ball }
srm player {
  var kicks : int = 0
  liveness {
    player = Look~ || play~
    play   = Search . Wait
  }
  activities { Look takes 30ms  Search takes 100ms  Wait takes 200ms }
}
team S { a : player  b : player }
"""


def played(what: Generated | str, changes: Any, until: int = 2 * SECOND, **options: Any) -> list[Record]:
    """The records of a run in which `changes(team)` is called before it begins."""
    team, records = make(what, until=until, **options)
    changes(team)
    team.run()
    for record in records:
        check_line(record)
    return records


def swaps(records: list[Record]) -> list[Record]:
    return [record for record in records if record["kind"] == "swap"]


def starts(records: list[Record], after: int, agent: str = "a") -> list[str]:
    return [
        f"{record['time'] // MS} {record['activity']}"
        for record in records
        if record["kind"] == "activity" and record["what"] == "start"
        if record["agent"] == agent and record["time"] >= after
    ]


class TestGoingOn:
    def test_an_activity_goes_on_and_the_new_formula_follows(self) -> None:
        new = version(ONE.replace("Search . (Kick | Wait)", "Search . (Kick | Wait) . Cheer"))
        records = played(ONE, lambda team: team.swap(new, at=200 * MS), until=900 * MS)
        assert [line["what"] for line in swaps(records)] == ["done", "done"]
        assert not any(
            record.get("what") in ("cancel", "crash") for record in records if record["time"] < 900 * MS
        )
        # Kick was begun at 100 ms by the old plan, and its end is followed by what the new one says
        assert [s for s in starts(records, 200 * MS) if "Look" not in s][:3] == [
            "400 Cheer",
            "500 Search",
            "600 Kick",
        ]

    def test_variables_keep_their_values(self) -> None:
        new = version(ONE.replace("kicks < 100", "kicks < 3"))
        records = played(ONE, lambda team: team.swap(new, at=950 * MS), until=2 * SECOND)
        # three kicks have been counted by then: at 100, 500 and 900
        assert "1300 Wait" in starts(records, 950 * MS)

    def test_a_new_concurrent_part_begins_at_its_start(self) -> None:
        new = version(ONE.replace("Look~ || play~", "Look~ || Blink~ || play~"))
        records = played(ONE, lambda team: team.swap(new, at=205 * MS), until=500 * MS)
        (line, _) = swaps(records)
        assert line["entered"] == ["0.2.2"]
        assert "205 Blink" in starts(records, 205 * MS)
        assert not [s for s in starts(records, 205 * MS) if "Search" in s and int(s.split()[0]) < 400]

    @pytest.mark.parametrize(
        ("targets", "start"),
        [("(0.3.1.2, 0.3.2.3)", "Look Walk"), ("0.3.1.3", "Follow Stand"), ("0.3", "Look Stand")],
    )
    def test_other_targets_of_one_transition_count_from_the_swap_on(self, targets: str, start: str) -> None:
        both = "(0.3.1.3, 0.3.2.3)"
        for one, other, expected in (
            (both, targets, ("Follow Walk", start)),
            (targets, both, (start, "Follow Walk")),
        ):
            old, new = (generate(GUARD.replace(both, item)) for item in (one, other))
            assert old.package.MODEL != new.package.MODEL
            to = version(new)
            records = played(old, lambda team, to=to: team.swap(to, at=1500 * MS), until=3500 * MS)
            assert [(line["what"], line.get("entered")) for line in swaps(records)] == [("done", None)]
            found = [set(expected[0].split()), {"Rest"}, set(expected[1].split())]
            begun = starts(records, 1000 * MS)
            assert [{s.split()[1] for s in begun if s.startswith(f"{at}000 ")} for at in (1, 2, 3)] == found

    def test_an_activity_of_which_the_new_version_says_something_else_starts_anew(self) -> None:
        new = version(ONE.replace("Kick takes 300ms", "Kick takes 50ms"))
        records = played(ONE, lambda team: team.swap(new, at=200 * MS), until=400 * MS)
        (line, _) = swaps(records)
        assert len(line["restarted"]) == 1
        told = [
            f"{r['time'] // MS} {r['what']}"
            for r in records
            if r["kind"] == "activity" and r["activity"] == "Kick" and r["agent"] == "a"
        ]
        assert told[:4] == ["100 start", "200 cancel", "200 start", "250 end"]

    def test_an_outcome_is_still_known_and_a_new_deadline_counts_from_the_entry(self) -> None:
        cell = """
            system S
            srm arm {
              liveness { arm = Grasp . Carry . (Place | Open) . Rest }
              activities { Grasp takes 100ms ends slipped, held  Carry takes 500ms within 2s }
              control arm { enter Open : [outcome(Grasp) == slipped]  enter Place : else }
            }
            team T { a : arm }
        """
        new = cell.replace("Grasp . Carry", "Look . Grasp . Carry").replace("2s", "300ms")
        records = played(cell, lambda team: team.swap(version(new), at=200 * MS), until=2 * SECOND)
        (cancel,) = (r for r in records if r.get("what") == "cancel")
        assert cancel["activity"] == "Carry" and cancel["time"] == 400 * MS
        longer = new.replace("300ms", "1s")
        records = played(cell, lambda team: team.swap(version(longer), at=200 * MS), until=2 * SECOND)
        assert starts(records, 300 * MS)[0] == "600 Open"
        assert not any(line.get("restarted") for line in swaps(records))

    def test_the_trace_has_the_new_plan(self) -> None:
        new = version(ONE.replace("(Kick | Wait)", "Rest . (Kick | Wait)"))
        records = played(ONE, lambda team: team.swap(new, at=200 * MS), until=400 * MS)
        (line, _) = swaps(records)
        assert "Rest" in {state["name"] for state in line["plan"]["states"]}
        assert line["before"] != line["model"]
        later = [r for r in records if r["kind"] == "step" and r["time"] > 200 * MS and r["agent"] == "a"]
        for record in later:
            for taken in record["taken"]:
                ways = [line["plan"]["transitions"][number] for number in taken["transitions"]]
                assert (ways[0]["source"], ways[-1]["target"]) == (taken["source"], taken["target"])


class TestRefusing:
    def test_where_the_new_version_has_no_such_state(self) -> None:
        new = version(WITHOUT_KICK)
        handles: list[Any] = []
        before = played(ONE, lambda team: None)
        records = played(ONE, lambda team: handles.append(team.swap(new, at=200 * MS)))
        assert handles[0].state == "refused"
        assert handles[0].reasons == (
            "a is in `Kick` (test.aseme:8:24), which the new model does not have",
            "b is in `Kick` (test.aseme:8:24), which the new model does not have",
        )
        assert without(records, "swap") == before  # nothing has changed
        assert [line["what"] for line in swaps(records)] == ["refused"]

    def test_where_the_new_version_has_no_such_plan(self) -> None:
        new = version(ONE.replace("player", "striker"))
        handles: list[Any] = []
        played(ONE, lambda team: handles.append(team.swap(new, at=200 * MS)))
        assert handles[0].reasons[0] == "the new model has no player, which a plays; it has striker"

    def test_one_agent_that_cannot_keeps_all_from_it(self) -> None:
        new = version(ONE.replace("Look~ || play~", "play~ || Look~"))
        team, _ = make(ONE, until=SECOND)
        with pytest.raises(KeyError):
            team.swap(new, at=200 * MS, agents=["a", "nobody"])


NET = """\
system Net
message Task { int n }
message Answer { int n }
aip deal {
  participant asker {
    sends request Task
    receives inform Answer
    process = Ask . Hear
  }
  participant teller {
    sends inform Answer
    receives request Task
    process = Think . Tell
  }
  control asker {
    enter Ask  : / send request Task to teller
    enter Hear : inform Answer from teller or after(1s)
  }
  control teller {
    enter Think : request Task from asker
    leave Tell  : / send inform Answer to asker
  }
}
srm boss   { plays deal.asker   liveness { boss = (Rest . asker)~ }
             activities { Rest takes 100ms  Ask takes 10ms  Hear takes 10ms } }
srm helper { plays deal.teller  liveness { helper = teller~ || Blink~ }
             activities { Think takes 50ms  Tell takes 10ms  Blink takes 40ms } }
team Net { chief : boss  aide : helper }
"""

NODDING = (
    NET.replace("process = Think . Tell", "process = Think . Nod . Tell")
    .replace("sends inform Answer", "sends inform Answer, agree Task")
    .replace("receives inform Answer", "receives inform Answer, agree Task")
    .replace("enter Think :", "enter Tell : / send agree Task to asker\n    enter Think :")
)
"""The teller says one more thing."""


class TestConversations:
    """No two agents play different versions of a protocol inside one run of it."""

    def change(self, new: str, at: int, within: int = SECOND, **options: Any) -> tuple[Any, list[Record]]:
        handles: list[Any] = []
        records = played(
            NET,
            lambda team: handles.append(team.swap(version(new), at=at, within=within, **options)),
        )
        return handles[0], records

    def test_a_protocol_that_both_play_alike_is_no_obstacle(self) -> None:
        swap, records = self.change(
            NET.replace("helper = teller~ || Blink~", "helper = Blink~ || teller~"), 130 * MS
        )
        assert swap.state == "done"
        assert {line["time"] for line in swaps(records)} == {130 * MS}
        assert not [r for r in records if r["kind"] in ("unexpected", "fault")]
        heard = [
            r["time"] // MS for r in records if r["kind"] == "agent_message" and r["performative"] == "inform"
        ]
        assert heard == [160, 330, 500, 670, 840, 1010, 1180, 1350, 1520, 1690, 1860]

    @pytest.mark.parametrize(
        ("old", "new"),
        [
            ("process = Think . Tell", "process = Think . Nod . Tell"),
            ("Think takes 50ms", "Think takes 60ms"),
            ("after(1s)", "after(2s)"),
        ],
    )
    def test_what_nobody_else_notices_is_no_obstacle(self, old: str, new: str) -> None:
        """Activities, durations and deadlines do not count: what is said, in which order, does."""
        swap, records = self.change(NET.replace(old, new), 130 * MS)
        assert swap.state == "done"
        assert {line["time"] for line in swaps(records)} == {130 * MS}
        assert not [r for r in records if r["kind"] == "unexpected"]

    @pytest.mark.parametrize("which", [None, ["aide"], ["chief"]])
    def test_messages_that_change_compatibly_are_no_obstacle(self, which: list[str] | None) -> None:
        """(Two builds in one team: the same contracts judge)"""
        new = NET.replace("message Task { int n }", "message Task { int n  optional int by }")
        swap, records = self.change(new, 130 * MS, agents=which)
        assert swap.state == "done" and swap.notes == ()
        assert {line["time"] for line in swaps(records)} == {130 * MS}
        assert not [r for r in records if r["kind"] in ("unexpected", "fault")]
        heard = [r["time"] // MS for r in records if r.get("performative") == "inform"]
        assert {160, 330, 1860} <= set(heard)

    def test_messages_that_the_others_do_not_read_are_named(self) -> None:
        new = NET.replace("message Task { int n }", "message Task { int n  int by }")
        swap, records = self.change(new, 130 * MS, within=20 * MS)
        assert swap.state == "refused"
        assert swap.reasons[0] == (
            "chief is still asker in the conversation deal-chief-1 of deal, which the new model plays "
            "differently: Task: `by` is not sent, and is not optional here; after 0.02 s"
        )
        _, records = self.change(new, 50 * MS, agents=["aide"])
        reasons = {r["reason"] for r in records if r["kind"] == "unexpected" and r["agent"] == "aide"}
        assert reasons == {"chief plays another version of deal"}

    def test_where_the_active_state_is_gone_it_waits_until_that_is_left(self) -> None:
        swap, records = self.change(NET.replace("Think", "Ponder"), 130 * MS)
        assert swap.state == "done"
        assert {line["time"] for line in swaps(records)} == {150 * MS}
        assert not [r for r in records if r["kind"] == "unexpected"]

    def test_a_bound_activity_talks_with_the_old_version(self) -> None:
        changed = NET.replace("Think", "Ponder")
        _, records = self.change(changed, 50 * MS, agents=["aide"])
        assert not [r for r in records if r["kind"] == "unexpected"]
        assert [r for r in records if r["kind"] == "conversation" and r["what"] == "join"]

    def test_another_one_waits_for_the_end_of_the_conversation(self) -> None:
        swap, records = self.change(NODDING, 130 * MS)
        assert swap.state == "done"
        (moment,) = {line["time"] for line in swaps(records)}
        left = [r["time"] for r in records if r["kind"] == "conversation" and r["what"] == "leave"]
        assert moment == max(t for t in left if t < 200 * MS) == 170 * MS
        assert not [r for r in records if r["kind"] == "unexpected"]
        assert [s for s in starts(records, moment, "aide") if "Nod" in s]

    def test_not_for_ever(self) -> None:
        swap, records = self.change(NODDING, 130 * MS, within=20 * MS)
        assert swap.state == "refused"
        assert swap.reasons == (
            "chief is still asker in the conversation deal-chief-1 of deal, which the new model plays "
            "differently: its participants say something else, or in another order; after 0.02 s",
            "aide is still teller in the conversation deal-chief-1 of deal, which the new model plays "
            "differently: its participants say something else, or in another order; after 0.02 s",
        )
        assert [line["time"] for line in swaps(records)] == [150 * MS]

    def test_agents_of_two_versions_do_not_talk(self) -> None:
        _, records = self.change(NODDING, 50 * MS, agents=["aide"])
        reasons = {r["reason"] for r in records if r["kind"] == "unexpected" and r["agent"] == "aide"}
        assert reasons == {"chief plays another version of deal"}
        assert not [r for r in records if r["kind"] == "conversation" and r["what"] == "join"]
        assert {r["performative"] for r in records if r.get("sender") == "aide"} == {"not_understood"}

    @pytest.mark.parametrize(
        "way", ["lost teller gone [reason(gone) == incompatible]", "when [all_answered(teller)]"]
    )
    def test_who_waits_for_an_agent_of_another_version_loses_it(self, way: str) -> None:
        """(language.md, part 3: the reasons of `lost`)"""

        def sorry(text: str) -> str:
            return (
                text.replace("Ask . Hear", "Ask . (Hear | Sorry)")
                .replace("Hear takes 10ms", "Hear takes 10ms  Sorry takes 10ms")
                .replace("    enter Hear", f"    enter Sorry : {way}\n    enter Hear")
            )

        records = played(
            sorry(NET), lambda team: team.swap(version(sorry(NODDING)), at=50 * MS, agents=["aide"])
        )
        starts_sorry = [text for text in starts(records, 0, "chief") if text.endswith("Sorry")]
        assert starts_sorry[0].startswith("110 ")
        assert not [r for r in records if r["kind"] == "agent_message" and r["agent"] == "aide"]


class TestMessages:
    def test_channels_that_one_version_does_not_read_are_noted(self) -> None:
        handles: list[Any] = []
        for text in ("double x  bool near  optional int far", "double x  bool near  int far"):
            new = version(ONE.replace("double x  bool near", text))
            played(ONE, lambda team, new=new: handles.append(team.swap(new, at=50 * MS)), until=100 * MS)
        assert [handle.state for handle in handles] == ["done", "done"]
        assert handles[0].notes == ()
        why = "of the version before: `far` is not sent, and is not optional here"
        assert handles[1].notes == (
            f"the new version does not read vision.state.Ball {why}",
            f"the new version does not read vision.data.Ball {why}",
        )

    def test_blackboards_are_carried_by_member(self) -> None:
        seen: list[Any] = []

        class Search:
            def execute(self, context: Context) -> None:
                seen.append(context.latest_message("vision.state.Ball"))

        old = ONE.replace("Search takes 100ms", "Search takes 100ms reads vision.state.Ball")
        new = old.replace("double x  bool near", "double x  int far")
        script = [{"at": "0.05s", "channel": "vision.state.Ball", "message": {"x": 2.5, "near": True}}]
        records = played(
            old,
            lambda team: team.swap(version(new, {"Search": Search}), at=200 * MS),
            until=600 * MS,
            activities={"Search": Search},
            script=script,
        )
        assert [line["what"] for line in swaps(records)] == ["done", "done"]
        last = seen[-1]
        assert (last.x, last.far) == (2.5, 0)


LEAVING = """\
system Leaving
srm player {
  liveness { player = (Wait . Rest)~ }
  activities { Wait takes 1s  Rest takes 1s }
  control player { enter Rest : after(50ms) }
}
team Leaving { one : player }
"""


class TestNothingElseChanges:
    """A swap to the same model, at any moment, is a line in the trace and nothing else."""

    def test_at_the_moment_at_which_a_state_is_left(self) -> None:
        made = generate(LEAVING)
        base = played(made, lambda team: None, until=100 * MS)
        changed = played(made, lambda team: team.swap(version(made), at=50 * MS), until=100 * MS)
        assert _same_end(base, changed)
        assert starts(changed, 50 * MS, "one")[0] == "50 Rest"

    @pytest.mark.parametrize("group", range(4))
    def test_random_charts(self, group: int) -> None:
        for seed in range(group, EXAMPLES, 4):
            choices = Choices(f"swap {seed}")
            written = random_text(choices)
            made, again = generate(written), generate(written)
            moved = generate("\n\n" + written)  # another model, which does the same
            try:
                moments = sorted(choices.number(0, 1500) * MS for _ in range(2))
                script = script_for(choices, made)
                agents = [("me", "R"), ("you", "R")]
                options: dict[str, Any] = {"until": 2 * SECOND, "script": script, "agents": agents}
                base = played(made, lambda team: None, **options)
                same, other = version(again), version(moved)

                def once(team: Team, same: Version = same, moment: int = moments[0]) -> None:
                    team.swap(same, at=moment)

                def there_and_back(
                    team: Team,
                    versions: tuple[Version, Version] = (other, same),
                    moments: list[int] = moments,
                ) -> None:
                    for item, moment in zip(versions, moments, strict=True):
                        team.swap(item, at=moment)

                changed = played(made, once, **options)
                assert _same_end(base, changed), f"example {seed}\n{written}"
                changed = played(made, there_and_back, **options)
                if all(line["what"] == "done" for line in swaps(changed)):

                    def look(team: Team, moments: list[int] = moments) -> None:
                        """Another model is looked at anew: let the one that stays be looked at then, too."""
                        for moment in moments:
                            for agent in team.agents:
                                team.driver.at(moment, agent.begin)

                    base = played(made, look, **options)
                    assert _behaviour(changed) == _behaviour(base), f"example {seed}\n{written}"
            finally:
                for item in (made, again, moved):
                    forget(item)


def _same_end(base: list[Record], changed: list[Record]) -> bool:
    return without(changed, "swap", "finish") == without(base, "finish")


PLACED = ("step", "at", "reason", "again", "functions")


def _behaviour(records: list[Record]) -> list[Record]:
    """What is left of a trace without places in the source and without steps in which nothing happens."""
    found = []
    for record in without(records, "swap", "header", "finish"):
        if record["kind"] == "step" and not (record["taken"] or record["inputs"]):
            continue
        found.append({key: value for key, value in record.items() if key not in PLACED})
    return found


def script_for(choices: Choices, made: Generated) -> list[dict[str, Any]]:
    lines: list[dict[str, Any]] = []
    channels = sorted(made.charts["R"].READERS)
    for _ in range(choices.number(2, 12)):
        at = f"{choices.number(1, 1500)}ms"
        if not channels:
            break
        channel = choices.one_of(channels)
        message = {"x": choices.number(0, 3), "on": choices.one_in(2)} if channel.endswith("M") else {"n": 1}
        lines.append({"at": at, "channel": channel, "message": message})
    return lines


ORDERS = """\
system S
message Place { int x }
message Order { int id  Place place }
srm clerk {
  var now   : Order
  var spare : Order
  var queue : list[3] of Order
  liveness { clerk = Sell . Wait . Rest }
  activities { Sell takes 100ms  Wait takes 300ms  Rest takes 100ms }
  control clerk {
    enter Wait : / now = Order { id = 7, place.x = 2 }; append(queue, now);
                   append(queue, Order { id = 8, ..now })
    enter Rest : [now.id == 7 && queue[1].place.x == 2 && !has(spare)] / spare = queue[1]
  }
}
team S { a : clerk }
"""


def test_variables_with_messages_go_on() -> None:
    """Their members follow by name and type; a member that is new has its default."""
    changed = ORDERS.replace("int id  Place place", "Place place  int id  string item").replace(
        "Order { id = 7, place.x = 2 }", "Order { .. }"
    )
    changed = changed.replace("now.id == 7 &&", 'now.id == 7 && now.item == "" &&')
    records = played(ORDERS, lambda team: team.swap(version(changed), at=200 * MS))
    [swap] = swaps(records)
    assert not swap.get("lost")
    assert "400 Rest" in starts(records, 0)
