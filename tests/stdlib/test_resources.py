"""A resource of the library among many: capacity, order, leases, and who goes without a word."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cache
from random import Random
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from aseme_dsl.runtime import Context
from aseme_dsl.runtime.library import resources
from aseme_dsl.runtime.team.faults import Crash, Faults, Partition
from tests.runtime.playing import SECOND, Played, make, play
from tests.support.generated import Generated, generate
from tests.support.networks import BAD, SEEDS, NetworkRun, runs

HOLDERS = 7
ENDS = {
    "RETURNED",
    "EXPIRED",
    "REFUSED",
    "WITHDRAWN",
    "NOT_TAKEN",
    "LOST",
    "UNCONFIRMED",
    "NOT_UNDERSTOOD",
}


def text(capacity: int = 1, urgency: str = "index", more: str = "", places: int = 8) -> str:
    return f"""
system Lifts
import resources

srm desk {{
  includes resource_keeper
  liveness {{ desk = service  places = (keeper~)[{places}] }}
}}

srm porter {{
  plays resource.holder with whom = "", what = "the lift", urgency = urgency, lease = 10s,
                             patience = patience, renewing = renewing, UseResource = Ride
  var urgency  : int      = 0
  var patience : duration = 5min
  var renewing : bool     = false
  liveness {{ porter = Walk . holder . Rest }}
  activities {{ Ride  Rest takes 100ms simulated  Walk writes renewing, patience, urgency }}
}}

team Lifts {{
  lifts : desk with capacity = {capacity}{more}
  p[1..{HOLDERS}] : porter with urgency = {urgency}
}}
"""


@cache
def made(capacity: int = 1, urgency: str = "index", more: str = "", places: int = 8) -> Generated:
    return generate(text(capacity, urgency, more, places))


def code(
    walks: Mapping[str, float], rides: Mapping[str, float], sets: Mapping[str, Mapping[str, Any]] = {}
) -> dict[str, type[Any]]:
    """The activities of the holders, by agent: when it comes, how long it rides, what it wishes."""

    class Walk:
        def execute(self, context: Context) -> None:
            for name, value in sets.get(context.agent, {}).items():
                context.set_variable(name, value)
            context.wait(walks.get(context.agent, 3600))

    class Ride:
        def execute(self, context: Context) -> None:
            context.wait(rides.get(context.agent, 1))

    class Nothing:
        def execute(self, context: Context) -> None:
            pass

    class Close:
        def execute(self, context: Context) -> None:
            context.log(f"ended {context.get_variable('ending').name}")

    nothing = dict.fromkeys(
        ("ExpressNeed", "AwaitTurn", "ConsiderNeed", "OpenDesk", "KeepInLine", "Lend"), Nothing
    )
    return {**nothing, "Walk": Walk, "Ride": Ride, "CloseLease": Close, "CloseNeed": Close}


# ---- the trace, as the keeper and as the holders see it -----------------------------------------------


@dataclass(frozen=True)
class Service:
    """What a keeper did in one conversation: when it took the request, lent, and had it back (ns)."""

    holder: str
    priority: int
    asked: int
    lent: int | None = None
    over: int | None = None


def services(records: list[dict[str, Any]], keeper: str = "lifts") -> list[Service]:
    """What the keeper's messages say, conversation by conversation, in the order of the requests."""
    found: dict[str, Service] = {}
    for record in records:
        name = record.get("conversation", "")
        if record.get("agent") != keeper:
            continue
        if record["kind"] == "agent_message":
            what = (record["performative"], record["message"])
            if what == ("agree", "Need"):
                found[name] = Service(record["to"][0], record["content"]["priority"], record["time"])
            elif what == ("propose", "Lease"):
                found[name] = replace(found[name], lent=record["time"])
            elif what in (("inform", "Need"), ("failure", "Lease")) and name in found:
                found[name] = replace(found[name], over=record["time"])
        elif record["kind"] == "conversation" and record["what"] == "leave" and name in found:
            over = found[name].over
            found[name] = replace(found[name], over=record["time"] if over is None else over)
    return list(found.values())


def most_at_once(intervals: list[tuple[int, int]]) -> int:
    """How many of these intervals (without their ends) overlap at most."""
    events = sorted(
        [(end, -1) for begin, end in intervals if end > begin] + [(b, 1) for b, e in intervals if e > b]
    )
    most = now = 0
    for _, change in events:
        now += change
        most = max(most, now)
    return most


def lent(found: list[Service], end: int) -> list[tuple[int, int]]:
    return [(item.lent, end if item.over is None else item.over) for item in found if item.lent is not None]


def uses(records: list[dict[str, Any]], end: int) -> list[tuple[int, int]]:
    """When the holders used the resource."""
    begun: dict[tuple[str, str], int] = {}
    found = []
    for record in records:
        if record["kind"] == "activity" and record["activity"] == "Ride":
            key = (record["agent"], record["label"])
            if record["what"] == "start":
                begun[key] = record["time"]
            elif key in begun:
                found.append((begun.pop(key), record["time"]))
        elif record["kind"] in ("fault", "error") and "crash" in record.get("reason", ""):
            for key in [key for key in begun if key[0] == record["agent"]]:
                found.append((begun.pop(key), record["time"]))
    return [*found, *((begin, end) for begin in begun.values())]


def unfair(found: list[Service]) -> Iterator[str]:
    """Who was served although another one had to be: the oracle is a look at all that waited."""
    for item in found:
        for other in found:
            waited = other.asked < (item.lent or 0) and (other.lent is None or other.lent > (item.lent or 0))
            gone = other.over is not None and other.lent is None and other.over <= (item.lent or 0)
            if item.lent is None or other is item or not waited or gone:
                continue
            if other.priority > item.priority or (
                other.priority == item.priority and other.asked < item.asked
            ):
                yield f"{item} before {other}"


def said(records: list[dict[str, Any]], agent: str = "") -> list[str]:
    return [
        record["text"].removeprefix("ended ")
        for record in records
        if record["kind"] == "log" and record["agent"].startswith(agent)
    ]


# ---- the line ---------------------------------------------------------------------------------------

REPORTS = st.lists(st.tuples(st.integers(1, 6), st.integers(-1, 2), st.booleans()), max_size=30)


@given(REPORTS, st.integers(0, 3))
def test_the_line_is_in_the_order_of_priority_and_arrival(
    reports: list[tuple[int, int, bool]], capacity: int
) -> None:
    """Against lists that are sorted anew each time."""
    line = ""
    held: set[int] = set()
    waiting: list[tuple[int, int]] = []
    for place, priority, stays in reports:
        line = resources.lined_up(line, place, priority, stays, capacity)
        held.discard(place)
        waiting = [item for item in waiting if item[1] != place]
        if stays:
            waiting.append((priority, place))
        while waiting and len(held) < capacity:
            best = max(waiting, key=lambda item: item[0])  # the first of several
            waiting.remove(best)
            held.add(best[1])
        assert {number for number in range(1, 7) if resources.has_unit(line, number)} == held
        assert resources.units_held(line) == len(held) <= capacity
        assert resources.waiting_for(line) == len(waiting)
        standing = {number for number in range(1, 7) if resources.stands_in(line, number)}
        assert standing == held | {number for _, number in waiting}


# ---- many holders -----------------------------------------------------------------------------------


def varied(seed: int) -> tuple[int, dict[str, type[Any]]]:
    random = Random(seed)
    names = [f"p{number}" for number in range(1, HOLDERS + 1)]
    walks = {name: random.choice((0.0, 0.5, random.uniform(0, 20))) for name in names}
    rides = {name: random.choice((0.5, 3.0, 9.5, 25.0)) for name in names}
    sets = {
        name: {
            "urgency": random.randint(0, 2),
            "renewing": random.random() < 0.4,
            "patience": random.choice((5, 30, 600)) * SECOND,
        }
        for name in names
    }
    return random.randint(1, 3), code(walks, rides, sets)


def check(run: NetworkRun | Played, capacity: int) -> list[str]:
    end = run.result.end_ns
    found = services(run.records)
    wrong = list(unfair(found))
    if (most := most_at_once(lent(found, end))) > capacity:
        wrong.append(f"{most} lent of {capacity}")
    if (most := most_at_once(uses(run.records, end))) > capacity:
        wrong.append(f"{most} used of {capacity}")
    if unknown := {*said(run.records)} - ENDS:
        wrong.append(f"no end: {unknown}")
    return wrong


@pytest.mark.parametrize("network", [None, BAD, "delay=0..4s,loss=20%,reorder"], ids=["good", "bad", "slow"])
def test_never_more_than_there_is_and_in_order(network: str | None) -> None:
    wrong = []
    for seed in SEEDS[::3]:
        capacity, activities = varied(seed)
        for run in runs(made(capacity), network, seeds=[seed], until=900 * SECOND, activities=activities):
            wrong += [f"seed {seed}: {item}\n{run}" for item in check(run, capacity)]
            if len(said(run.records, "p")) != HOLDERS or run.failures or run.open:
                wrong.append(f"seed {seed}: not all have ended\n{run}")
    assert wrong == []


def test_holders_that_crash_give_back_when_their_leases_are_over() -> None:
    wrong = []
    for seed in SEEDS[::3]:
        capacity, activities = varied(seed)
        random = Random(seed)
        crashes = [
            Crash(f"p{number}", round(random.uniform(1, 40) * SECOND), random.choice((1, 60)) * SECOND)
            for number in (1, 3, 5)
        ]
        for run in runs(
            made(capacity),
            BAD,
            seeds=[seed],
            until=900 * SECOND,
            activities=activities,
            crashes=lambda seed, crashes=crashes: crashes,
        ):
            wrong += [f"seed {seed}: {item}\n{run}" for item in check(run, capacity)]
            wrong += [f"seed {seed}: {name} open\n{run}" for name in run.open]
    assert wrong == []


def test_a_partition_ends_no_lease_before_its_time() -> None:
    """Who cannot be reached may go on as long as its lease lasts; nobody else has the unit meanwhile."""
    wrong = []
    for seed in SEEDS[::3]:
        capacity, activities = varied(seed)
        random = Random(seed)
        parts = tuple(
            Partition(
                frozenset({f"p{number}"}),
                round(random.uniform(1, 40) * SECOND),
                random.choice((3, 30)) * SECOND,
            )
            for number in (1, 2, 4)
        )
        faults = Faults(seed, loss=0.1, delay=SECOND // 5, partitions=parts)
        team, records = make(made(capacity), activities, until=900 * SECOND, seed=seed, faults=faults)
        run = Played(team, team.run(), records)
        wrong += [f"seed {seed}: {item}" for item in check(run, capacity)]
        if len(said(run.records, "p")) != HOLDERS:
            wrong.append(f"seed {seed}: not all have ended")
    assert wrong == []


# ---- one thing each ---------------------------------------------------------------------------------


def served(run: Played) -> list[str]:
    """`2.5 p1 RETURNED`: when each got the resource, and how it says that it has ended."""
    ends = {
        record["agent"]: record["text"].split()[1] for record in run.of("log") if record["agent"] != "lifts"
    }
    begun = [record for record in run.of("activity", what="start") if record["activity"] == "Ride"]
    return [
        f"{record['time'] / SECOND:g} {record['agent']} {ends.get(record['agent'], '')}" for record in begun
    ]


def test_the_urgent_one_is_next() -> None:
    activities = code({"p1": 0, "p2": 1, "p3": 2, "p4": 3}, {f"p{n}": 5 for n in range(1, 5)})
    run = play(made(urgency="3 * (index - 2) * (4 - index)"), activities, until=60 * SECOND)
    assert served(run) == ["0 p1 RETURNED", "5 p3 RETURNED", "10 p2 RETURNED", "15 p4 RETURNED"]


def test_two_units_serve_two() -> None:
    activities = code({"p1": 0, "p2": 1, "p3": 2}, {"p1": 5, "p2": 2, "p3": 1})
    run = play(made(capacity=2), activities, until=60 * SECOND)
    assert served(run) == ["0 p1 RETURNED", "1 p2 RETURNED", "3 p3 RETURNED"]


def test_who_has_it_too_long_stops_and_the_next_one_gets_it() -> None:
    run = play(made(), code({"p1": 0, "p2": 1}, {"p1": 100, "p2": 1}), until=60 * SECOND)
    assert served(run) == ["0 p1 EXPIRED", "10 p2 RETURNED"]
    assert said(run.records, "lifts") == ["EXPIRED", "RETURNED"]


@pytest.mark.parametrize(
    ("more", "expected"),
    [
        ("", ["0 p1 EXPIRED", "15 p2 RETURNED"]),
        (", generous = true", ["0 p1 RETURNED", "22 p2 RETURNED"]),
    ],
    ids=["nobody waits", "always"],
)
def test_a_lease_is_renewed_while_nobody_waits(more: str, expected: list[str]) -> None:
    activities = code({"p1": 0, "p2": 7}, {"p1": 22, "p2": 1}, {"p1": {"renewing": True}})
    run = play(made(more=more), activities, until=60 * SECOND)
    assert served(run) == expected


def test_who_crashes_gives_it_back_when_its_lease_is_over() -> None:
    activities = code({"p1": 0, "p2": 1}, {"p1": 8, "p2": 1})
    (run,) = runs(
        made(),
        None,
        seeds=[1],
        until=60 * SECOND,
        activities=activities,
        crashes=lambda seed: [Crash("p1", 3 * SECOND, 100 * SECOND)],
    )
    assert [item.lent // SECOND for item in services(run.records) if item.lent is not None] == [0, 10]
    assert said(run.records, "lifts") == ["LOST", "RETURNED"]


def test_who_leaves_gives_it_back_at_once() -> None:
    interrupted = text().replace(
        "porter = Walk . holder . Rest }", "porter = (Walk . holder [> Flee) . Rest }"
    )
    interrupted = interrupted.replace(
        "activities { Ride",
        "control porter { enter Flee : after(3s) [index == 1] }\n"
        "  activities { Flee takes 1s simulated  Ride",
    )
    run = play(generate(interrupted), code({"p1": 0, "p2": 1}, {"p1": 8, "p2": 1}), until=60 * SECOND)
    assert served(run) == ["0 p1 ", "3 p2 RETURNED"]
    assert said(run.records, "lifts")[0] == "LOST"


def test_a_keeper_that_was_suspended_serves_those_in_line() -> None:
    halted = text().replace("desk = service", "desk = (service [> Halt)~")
    halted = halted.replace(
        "places = (keeper~)[8] }",
        """places = (keeper~)[8] }
  var halted : bool = false
  activities { Halt waits }
  control desk {
    resume service :
    enter  Halt    : after(3s) [!halted] / halted = true
    leave  Halt    : after(2s)
  }""",
    )
    activities = code({"p1": 0, "p2": 1, "p3": 2}, {"p1": 8, "p2": 1, "p3": 1})
    run = play(generate(halted), activities, until=60 * SECOND)
    assert served(run) == ["0 p1 RETURNED", "8 p3 RETURNED", "9 p2 RETURNED"]


def test_who_waits_too_long_goes_without_it() -> None:
    activities = code({"p1": 0, "p2": 1, "p3": 2}, {"p1": 9, "p3": 1}, {"p2": {"patience": 3 * SECOND}})
    run = play(made(), activities, until=60 * SECOND)
    assert served(run) == ["0 p1 RETURNED", "9 p3 RETURNED"]
    assert said(run.records, "p2") == ["WITHDRAWN"]
    assert "WITHDRAWN" in said(run.records, "lifts")


def test_a_keeper_that_has_crashed_lends_nothing_until_all_leases_are_over() -> None:
    activities = code({"p1": 0, "p2": 5}, {"p1": 8, "p2": 1})
    for more, expected in (("", 5), (", settling = 10s", 14)):
        (run,) = runs(
            made(more=more),
            None,
            seeds=[1],
            until=60 * SECOND,
            activities=activities if more == "" else code({"p1": 12, "p2": 15}, {"p1": 8, "p2": 1}),
            crashes=lambda seed, more=more: [Crash("lifts", (14 if more else 3) * SECOND, SECOND // 2)],
        )
        begun = [begin // SECOND for begin, _ in uses(run.records, run.result.end_ns)]
        assert max(begun) >= expected
        assert (most_at_once(uses(run.records, run.result.end_ns)) > 1) == (more == "")


def test_a_lease_counts_from_the_moment_at_which_it_was_asked_for() -> None:
    """The answer is late. So the holder stops when its lease is over for the keeper, and not later."""
    faults = Faults(
        least_delay=SECOND // 10,
        delay=SECOND // 10,
        partitions=(Partition(frozenset({"p1"}), SECOND * 28 // 100, 8 * SECOND),),
    )
    activities = code({"p1": 0, "p2": 1}, {"p1": 100, "p2": 5})
    team, records = make(made(), activities, until=60 * SECOND, faults=faults)
    run = Played(team, team.run(), records)
    (first, second) = uses(run.records, run.result.end_ns)
    assert first[0] > 8 * SECOND and first[1] == 10.2 * SECOND  # it asked at 0.2 s
    assert second[0] >= first[1]
    assert said(run.records, "p") == ["EXPIRED", "RETURNED"]
