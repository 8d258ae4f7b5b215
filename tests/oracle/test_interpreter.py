"""The interpreter against small plans made by hand: each test quotes the sentence it is about."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import pytest

from aseme_dsl.runtime.chart.inputs import (
    AgentMessage,
    Cancel,
    Completed,
    Crashed,
    Fault,
    FunctionResult,
    Happened,
    Joined,
    Left,
    MailTaken,
    Outcome,
    Publication,
    Sample,
    Sending,
    Start,
    Written,
)
from aseme_dsl.runtime.chart.plan import (
    BranchInfo,
    ChannelInfo,
    Plan,
    Region,
    State,
    Term,
    Transition,
    Variable,
)
from tests.oracle.interpreter import Reference


@dataclass(frozen=True)
class M:
    x: int = 0
    on: bool = False


@dataclass(frozen=True)
class Note:
    text: str = ""


MESSAGES = {"M": M, "Note": Note}
MS = 1_000_000
STATE, SIGNAL, QUEUE, DATA = "t.state.M", "t.signal.M", "q.signal.M", "t.data.M"
CHANNELS = (STATE, SIGNAL, QUEUE, DATA)
ARRIVALS = 0


def plan(states: str, *transitions: Transition, **parts: Any) -> Plan:
    """A plan from lines `label TYPE activity`; every region reads and writes every channel."""
    found = []
    for line in states.split("\n"):
        if line.strip():
            label, kind, *activity = line.split()
            parent = label.rpartition(".")[0] or None
            branch = "p.a" if kind == "BRANCH" else None
            kind = "OR" if kind == "BRANCH" else kind
            name = activity[0] if activity else label
            found.append(State(label, name, kind, parent, activity[0] if activity else None, branch))
    types = {state.label: state.type for state in found}
    regions = [s.label for s in found if s.parent is None or types[s.parent] == "AND"]
    return Plan(
        "role",
        "System",
        "test.aseme",
        "",
        tuple(found),
        transitions,
        regions=tuple(Region(label, CHANNELS, CHANNELS) for label in regions),
        channels=tuple(ChannelInfo(name, "M", queued=name == QUEUE) for name in CHANNELS),
        branches=tuple(BranchInfo(state.label, "p", "a") for state in found if state.branch),
        **parts,
    )


def way(
    source: str, target: str, condition: Term | None = None, *actions: Term, priority: int = 0, **rest: Any
) -> Transition:
    return Transition(source, target, priority, condition=condition, actions=actions, **rest)


def on(source: str, target: str, *events: Term, priority: int = 0) -> Transition:
    return Transition(source, target, priority, events=events)


def arrived(channel: str, sender: str = "other", time: int = 0, **fields: Any) -> Sample:
    global ARRIVALS
    ARRIVALS += 1
    return Sample(channel, M(**fields), sender, time, (sender, ARRIVALS))


def x(channel: str, host: str | None = None) -> Term:
    return ("member", host, channel, ("x",))


def flag(channel: str, host: str | None = None) -> Term:
    return ("member", host, channel, ("on",))


class Run:
    """A reference with the last outcome."""

    def __init__(self, of: Plan) -> None:
        self.chart = Reference(of, "me", MESSAGES)
        self.now = 0
        self.last = Outcome()

    def step(self, *inputs: Any, ms: int = 0) -> Outcome:
        self.now += ms * MS
        self.last = self.chart.step(self.now, inputs)
        return self.last

    @property
    def at(self) -> tuple[str, ...]:
        return self.chart.configuration()


A_THEN_B = """
0 OR
0.1 START
0.2 BASIC A
0.3 BASIC B
0.4 END
"""

WITH_A_CHOICE = """
0 OR
0.1 START
0.2 CONDITION
0.3 BASIC A
0.4 BASIC B
0.5 END
"""

NESTED = """
0 OR
0.1 START
0.2 OR
0.2.1 START
0.2.2 BASIC A
0.2.3 END
0.3 BASIC B
0.4 END
"""

PARALLEL = """
0 OR
0.1 START
0.2 AND
0.2.1 OR
0.2.1.1 START
0.2.1.2 BASIC A
0.2.1.3 END
0.2.2 OR
0.2.2.1 START
0.2.2.2 BASIC B
0.2.2.3 END
0.3 END
"""

PARALLEL_WAYS = (
    way("0.1", "0.2"),
    way("0.2", "0.3"),
    way("0.2.1.1", "0.2.1.2"),
    way("0.2.1.2", "0.2.1.3"),
    way("0.2.2.1", "0.2.2.2"),
    way("0.2.2.2", "0.2.2.3"),
)


def test_the_first_step_enters_the_root_and_starts_the_first_activity() -> None:
    """ "The first step enters the root (its START becomes active) and goes on with rounds." """
    run = Run(plan(A_THEN_B, way("0.1", "0.2"), way("0.2", "0.3"), way("0.3", "0.4")))
    outcome = run.step()
    assert outcome.taken == [(0,)]
    assert outcome.effects == [Start("0.2", "A", 1)]
    assert run.at == ("0.2",)


def test_completion_with_its_token_moves_and_the_end_of_the_root_finishes() -> None:
    """ "With the root's END active the agent has finished." """
    run = Run(plan(A_THEN_B, way("0.1", "0.2"), way("0.2", "0.3"), way("0.3", "0.4")))
    run.step()
    assert run.step(Completed("0.2", 1)).effects == [Start("0.3", "B", 2)]
    assert run.step(Completed("0.3", 1)).taken == []
    assert run.step(Completed("0.3", 2)).finished
    assert run.step(Happened("anything")) == Outcome(finished=True)


def test_a_state_stays_complete() -> None:
    """ "A state stays complete until it is left: completion is a fact, not an event that can be missed." """
    run = Run(plan(A_THEN_B, way("0.1", "0.2"), way("0.2", "0.3", flag(STATE))))
    run.step()
    assert run.step(Completed("0.2", 1)).taken == []
    assert run.step(arrived(STATE, on=False)).taken == []
    assert run.step(arrived(STATE, on=True)).taken == [(1,)]


def test_a_compound_transition_is_one() -> None:
    """ "START→CONDITION→X is one compound transition"; "If no branch is open, the START stays active and
    waits." """
    run = Run(
        plan(
            WITH_A_CHOICE,
            way("0.1", "0.2"),
            way("0.2", "0.3", ("==", x(STATE), ("const", 1))),
            way("0.2", "0.4", ("==", x(STATE), ("const", 2)), priority=1),
        )
    )
    assert run.step().taken == []
    assert run.at == ("0.1",)
    assert run.step(arrived(STATE, x=2)).taken == [(0, 2)]
    assert run.at == ("0.4",)


def test_all_conditions_come_before_any_action() -> None:
    """ "all its conditions are evaluated before any of its actions; actions of segment 1, then 2" """
    one = ("assign", "v", ("+", ("variable", "v"), ("const", 1)))
    ten = ("assign", "v", ("*", ("variable", "v"), ("const", 10)))
    run = Run(
        plan(
            WITH_A_CHOICE,
            way("0.1", "0.2", None, one),
            way("0.2", "0.3", ("==", ("variable", "v"), ("const", 1))),
            way("0.2", "0.4", ("==", ("variable", "v"), ("const", 0)), ten, priority=1),
            variables=(Variable("v", "int", 0),),
        )
    )
    assert run.step().taken == [(0, 2)]
    assert run.chart.variable("v") == 10


def test_priority_decides() -> None:
    """ "of each the outgoing transitions by priority; the first that is enabled is taken" """
    true = ("const", True)
    run = Run(plan(A_THEN_B, way("0.1", "0.2", true, priority=1), way("0.1", "0.3", true, priority=0)))
    run.step()
    assert run.at == ("0.3",)


def test_else_needs_that_no_other_is_enabled() -> None:
    """ "the source is complete and no sibling is enabled (an absent condition counts as not enabled)" """
    ways = (
        way("0.1", "0.2"),
        way("0.2", "0.3", flag(STATE)),
        Transition("0.2", "0.4", 1, otherwise=True),
    )
    run = Run(plan(WITH_A_CHOICE, *ways))
    run.step()
    assert run.at == ("0.4",)
    run = Run(plan(WITH_A_CHOICE, *ways))
    run.step(arrived(STATE, on=True))
    assert run.at == ("0.3",)


def test_when_does_not_wait_for_completion() -> None:
    """ "while the source is active, complete or not, as soon as `c` holds"; "a BASIC whose activity still
    runs gives Cancel" """
    run = Run(plan(A_THEN_B, way("0.1", "0.2"), way("0.2", "0.3", flag(STATE), when=True)))
    run.step()
    assert run.step(arrived(STATE, on=True)).effects == [Cancel("0.2", "A", 1), Start("0.3", "B", 2)]


def test_after_counts_from_the_entry() -> None:
    """ "once `d` has passed since the source was entered, complete or not" """
    run = Run(plan(A_THEN_B, way("0.1", "0.2"), on("0.2", "0.3", ("after", 5 * MS))))
    run.step(ms=3)
    assert run.chart.due(run.now) == 8 * MS
    assert run.step(ms=4).taken == []
    assert run.step(ms=1).taken == [(1,)]
    assert run.chart.due(run.now) is None


def test_the_scope_is_the_lowest_or_that_holds_both() -> None:
    """ "Everything active inside the scope is left, innermost first; … then the target is entered, outermost
    first." """
    run = Run(plan(NESTED, way("0.1", "0.2"), way("0.2.1", "0.2.2"), on("0.2.2", "0.3", ("raised", "e"))))
    run.step()
    assert run.at == ("0.2.2",)
    run.step(Happened("e"))
    assert run.at == ("0.3",)


def test_a_target_inside_a_composite_is_entered_through_it() -> None:
    """ "then the target is entered, outermost first" """
    run = Run(
        plan(
            NESTED,
            way("0.1", "0.2.2"),
            on("0.2.2", "0.2.2", ("raised", "e")),
            on("0.2", "0.3", ("after", 5), priority=0),
        )
    )
    run.step()
    assert run.at == ("0.2.2",)
    assert run.step(Happened("e")).effects == [Cancel("0.2.2", "A", 1), Start("0.2.2", "A", 2)]
    assert run.chart.due(0) == 5


def test_a_self_transition_of_a_completed_or_starts_again_at_its_start() -> None:
    """ "A self-transition leaves and enters; a completed OR starts again at its START." """
    run = Run(
        plan(NESTED, way("0.1", "0.2"), way("0.2", "0.2"), way("0.2.1", "0.2.2"), way("0.2.2", "0.2.3"))
    )
    run.step()
    outcome = run.step(Completed("0.2.2", 1))
    assert outcome.taken == [(3,), (1,), (2,)]
    assert outcome.effects == [Start("0.2.2", "A", 2)]


def test_an_and_joins_and_each_round_visits_all_regions() -> None:
    """ "an AND when all its regions are complete" """
    run = Run(plan(PARALLEL, *PARALLEL_WAYS))
    outcome = run.step()
    assert outcome.taken == [(0,), (2,), (4,)]
    assert outcome.effects == [Start("0.2.1.2", "A", 1), Start("0.2.2.2", "B", 2)]
    assert run.at == ("0.2", "0.2.1.2", "0.2.2.2")
    assert run.step(Completed("0.2.2.2", 2)).taken == [(5,)]
    assert run.step(Completed("0.2.1.2", 1)).taken == [(3,), (1,)]
    assert run.chart.finished


def test_an_enclosing_transition_only_if_no_region_moved() -> None:
    """ "a transition of an enclosing state is taken only if no region inside it moved (and, for `when` and
    events, in the first such round: all its regions are then left and their activities cancelled)" """
    ways = (*PARALLEL_WAYS[:1], on("0.2", "0.3", ("raised", "e")), *PARALLEL_WAYS[2:])
    run = Run(plan(PARALLEL, *ways))
    run.step()
    outcome = run.step(Happened("e"), Completed("0.2.1.2", 1))
    assert outcome.taken == [(3,), (1,)]
    assert outcome.effects == [Cancel("0.2.2.2", "B", 2)]


def test_a_signal_goes_when_it_was_looked_at() -> None:
    """ "it goes at the end of the first step in which a condition that names it was evaluated, whatever the
    outcome" """
    run = Run(plan(A_THEN_B, way("0.1", "0.2"), way("0.2", "0.3", flag(SIGNAL))))
    run.step(arrived(SIGNAL, on=True))
    run.step(Completed("0.2", 1), ms=1)
    assert run.at == ("0.3",)
    run = Run(plan(A_THEN_B, way("0.1", "0.2"), way("0.2", "0.3", ("&&", flag(STATE), flag(SIGNAL)))))
    run.step(arrived(SIGNAL, on=True))
    run.step(Completed("0.2", 1))
    assert run.step(arrived(STATE, on=True)).taken == []


def test_another_step_where_a_signal_waits_behind_a_dropped_one() -> None:
    """ "`again` = some region still has a signal waiting behind one that was dropped." """
    run = Run(plan(A_THEN_B, way("0.1", "0.2", ("==", x(QUEUE), ("const", 2)))))
    outcome = run.step(arrived(QUEUE, x=1), arrived(QUEUE, x=2))
    assert (outcome.taken, outcome.again) == ([], True)
    outcome = run.step()
    assert (outcome.taken, outcome.again) == ([(0,)], False)


def test_absence_is_kleenes() -> None:
    """ "`&&`, `||`, `!` follow Kleene's three-valued logic, comparisons and functions of an absent value are
    absent, and a transition needs *true*." """
    absent = flag(STATE)
    true, false = ("const", True), ("const", False)
    chart = Reference(plan(A_THEN_B), "me", MESSAGES)
    chart.step(0, ())
    region = chart.regions["0"]

    def three(term: Term) -> Any:
        return True if chart.holds(term, region) else False if chart.fails(term, region) else None

    table = [
        (absent, None),
        (("!", absent), None),
        (("&&", absent, true), None),
        (("&&", absent, false), False),
        (("&&", false, absent), False),
        (("&&", absent, absent), None),
        (("||", absent, true), True),
        (("||", true, absent), True),
        (("||", absent, false), None),
        (("||", absent, absent), None),
        (("!", ("&&", absent, false)), True),
        (("==", absent, absent), None),
        (("!=", x(STATE), ("const", 1)), None),
        (("has", ("member", None, STATE, ())), False),
        (("==", ("||", absent, true), true), True),
        (("==", ("||", absent, false), true), None),
        (("<", ("builtin", "abs", x(STATE)), ("const", 1)), None),
    ]
    assert [three(term) for term, _ in table] == [expected for _, expected in table]


def test_a_division_by_zero_makes_the_whole_condition_not_hold() -> None:
    """ "A function (or division) that raises makes the whole condition not hold; a fault is recorded once per
    transition and step." """
    wrong = ("||", ("==", ("/", ("const", 1), ("const", 0)), ("const", 1)), ("const", True))
    run = Run(plan(A_THEN_B, way("0.1", "0.2", wrong), way("0.1", "0.3", priority=1)))
    outcome = run.step()
    assert outcome.taken == [(1,)]
    assert [e.transition for e in outcome.of(Fault)] == [0]


def test_functions_are_called_from_the_left_until_it_is_decided() -> None:
    """ "Conditions are evaluated … from the left, stopping as soon as decided" """
    even = ("call", "even(int)", ("const", 2))
    odd = ("call", "even(int)", ("const", 3))
    run = Run(
        plan(
            A_THEN_B,
            way("0.1", "0.2", ("&&", odd, even)),
            way("0.1", "0.3", ("||", even, odd), priority=1),
            functions=(("even(int)", f"{__name__}:even", "bool"),),
        )
    )
    results = [e.value for e in run.step().of(FunctionResult)]
    assert results == [False, True]


def even(number: int) -> bool:
    return number % 2 == 0


def test_an_absent_value_in_an_action_is_a_fault() -> None:
    """ "In an action, an absent or raising value means that this one action is not done, with a fault." """
    run = Run(
        plan(
            A_THEN_B,
            way("0.1", "0.2", None, ("assign", "v", x(STATE)), ("assign", "w", ("const", 1))),
            variables=(Variable("v", "int", 7), Variable("w", "int", 7)),
        )
    )
    outcome = run.step()
    assert [e.transition for e in outcome.of(Fault)] == [0]
    assert (run.chart.variable("v"), run.chart.variable("w")) == (7, 1)


def test_two_writers_of_one_variable() -> None:
    """ "A write is seen at once in its region, elsewhere from the next step; of two writes in one step the
    last in document order stays" """
    ways = list(PARALLEL_WAYS)
    ways[2] = way("0.2.1.1", "0.2.1.2", None, ("assign", "v", ("const", 1)))
    ways[4] = way("0.2.2.1", "0.2.2.2", None, ("assign", "v", ("+", ("variable", "v"), ("const", 10))))
    run = Run(plan(PARALLEL, *ways, variables=(Variable("v", "int", 0),)))
    run.step()
    assert run.chart.variable("v") == 10


def test_timers_belong_to_their_region() -> None:
    """ "`expired(t)` is false before `start_timer`, true from the due time until it is started again, and
    leaving the region drops its timers." """
    ways = list(PARALLEL_WAYS)
    ways[2] = way("0.2.1.1", "0.2.1.2", None, ("start_timer", "t", ("const", 2)))
    ways[3] = way("0.2.1.2", "0.2.1.3", ("expired", "t"), when=True)
    ways[5] = way("0.2.2.2", "0.2.2.3", ("expired", "t"), when=True)
    run = Run(plan(PARALLEL, *ways))
    run.step()
    assert run.chart.due(0) == 2
    run.step(ms=1)
    assert run.at == ("0.2", "0.2.1.3", "0.2.2.2")


def test_a_failure_bubbles_to_the_nearest_error_transition() -> None:
    """ "taken by the nearest `error` transition outwards, otherwise the agent stops in a safe way and says
    where" """
    ways = (way("0.1", "0.2"), way("0.2.1", "0.2.2"), on("0.2", "0.3", ("error",)))
    run = Run(plan(NESTED, *ways))
    run.step()
    outcome = run.step(Crashed("0.2.2", 1, "no battery"))
    assert outcome.effects == [Start("0.3", "B", 2)]
    outcome = run.step(Crashed("0.3", 2, "no battery"))
    assert outcome.failure is not None
    assert "no battery" in outcome.failure and "0.3" in outcome.failure
    assert run.at == ()


def test_a_step_that_does_not_settle_is_reported() -> None:
    """ "A step that does not settle within a bound [is] a reported error": where
    something can wait, 1000 rounds
    in which it has not become less, after the first 1000."""
    true = ("const", True)
    run = Run(
        plan(
            A_THEN_B,
            way("0.1", "0.2"),
            way("0.2", "0.3", true, when=True),
            way("0.3", "0.2", true, when=True),
        )
    )
    outcome = run.step()
    assert len(outcome.taken) == 2000
    assert outcome.failure is not None and "0.3 -> 0.2" in outcome.failure
    assert run.chart.failure == outcome.failure


def test_drafts_are_published_in_the_order_they_were_begun() -> None:
    """ "`write_messages.t.c.M` publishes the region's drafts of the channel (one for all, one a host) in
    the order they were begun, or a message of defaults if there is none, and the region itself sees it at
    once" """
    actions = (
        ("fill", x(STATE, "ann"), ("const", 1)),
        ("fill", x(STATE), ("const", 2)),
        ("fill", flag(STATE, "ann"), ("const", True)),
        ("publish", STATE),
        ("assign", "v", x(STATE)),
        ("publish", STATE),
    )
    run = Run(plan(A_THEN_B, way("0.1", "0.2", None, *actions), variables=(Variable("v", "int", 0),)))
    assert list(run.step().of(Publication)) == [
        Publication(STATE, M(1, True), "ann", "0"),
        Publication(STATE, M(2, False), None, "0"),
        Publication(STATE, M(), None, "0"),
    ]
    assert run.chart.variable("v") == 2


def test_a_participants_variables_start_anew() -> None:
    """ "A participant's variables start anew each time its branch is entered." """
    branch = NESTED.replace("0.2 OR", "0.2 BRANCH")
    run = Run(
        plan(
            branch,
            way("0.1", "0.2"),
            way("0.2", "0.2"),
            way("0.2.1", "0.2.2"),
            way("0.2.2", "0.2.3"),
            variables=(Variable("v", "int", 3, "0.2"),),
        )
    )
    assert run.step().effects == [Joined("0.2"), Start("0.2.2", "A", 1)]
    run.step(Written("v", 5))
    assert run.chart.variable("v") == 5
    assert run.step(Completed("0.2.2", 1)).effects == [
        Left("0.2", completed=True),
        Joined("0.2"),
        Start("0.2.2", "A", 2),
    ]
    assert run.chart.variable("v") == 3


def test_mail_waits_in_its_branch_until_a_transition_takes_it() -> None:
    """ "An agent message waits in its conversation until exactly one transition or activity takes it" """
    branch = NESTED.replace("0.2 OR", "0.2 BRANCH")
    run = Run(
        plan(
            branch,
            way("0.1", "0.2"),
            way("0.2.1", "0.2.2", None, ("send", "cfp", "Note", "b")),
            on("0.2.2", "0.2.2", ("received", "inform", "Note", "b")),
        )
    )
    assert Sending("0.2", "cfp", "Note", Note(), "b", way=(1,)) in run.step().effects
    letters = [
        AgentMessage("0.2", kind, "Note", Note(), "b", "bob", ("bob", n)) for n, kind in enumerate(LETTERS)
    ]
    outcome = run.step(*letters)
    assert [e.identity for e in outcome.of(MailTaken)] == [("bob", 0), ("bob", 2)]
    assert len(outcome.taken) == 2


LETTERS = ("inform", "refuse", "inform")


@pytest.mark.parametrize(("offset", "expected"), [(0, 3), (-1, 2), (-3, 1), (-4, None)])
def test_history(offset: int, expected: int | None) -> None:
    """ "`at(x, -d)` = newest value whose time ≤ now - d, else absent." """
    chart = Reference(plan(A_THEN_B), "me", MESSAGES)
    chart.step(3, [arrived(DATA, time=time, x=value) for time, value in ((0, 1), (3, 3), (2, 2))])
    term = ("at", x(DATA), ("const", offset))
    value = chart.value(("+", term, ("const", 0)), chart.regions["0"])
    assert (value if isinstance(value, int) else None) == expected


def test_age_and_mean() -> None:
    """ "`age(x)` = now - time of measurement."; "`mean(x.m, w)` = mean over values with time ≥ now - w,
    absent if none." """
    run = Run(
        plan(
            A_THEN_B,
            way("0.1", "0.2", (">", ("age", ("member", None, DATA, ())), ("const", 5))),
            way("0.1", "0.3", ("==", ("mean", x(DATA), ("const", 2)), ("const", 2.5)), priority=1),
        )
    )
    run.step(arrived(DATA, time=-4, x=100), arrived(DATA, time=-2, x=2))
    assert run.chart.due(0) == -2 + 5 + 1
    assert run.step(arrived(DATA, time=-1, x=3)).taken == [(1,)]
