"""Scenarios: `.aseme` text in, verdicts out. Each line is a scenario of its own."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import pytest

from aseme_dsl.play.sight.story import told
from aseme_dsl.project.building.build import choose
from aseme_dsl.project.building.project import compile_root
from aseme_dsl.project.testing.playing import play_scenarios, scenarios_in
from aseme_dsl.project.testing.story_pictures import pictures
from aseme_dsl.project.testing.verdicts import ScenarioResult, never_met

SYSTEM = """system Walk
enum Mood { CALM ANGRY }
message Ball { bool visible  double distance  Mood mood }
message Done { int number }
message Stop { int number }
topic eyes { state Ball }
message Touch { double force }
topic team { signal Done  signal Stop }
topic skin { data Touch }
function up(double x) : double = "math:ceil"
function gone(double x) : double = "math:not_there"
function same(Ball b) : bool = "math:isnan"
srm walker {
  var steps : int = 0
  liveness { walker = Wait . Walk . (Halt | Run) . Rest+ }
  activities {
    Wait takes 1s
    Walk takes 1s ends well, badly writes team.signal.Done, steps
    Halt takes 1s  Run takes 1s  Rest takes 1s ends warm, cold
  }
  control walker {
    enter Walk : Whistle
    enter Walk : / start_timer(pause, 500ms)
    enter Halt : [eyes.state.Ball.visible]
    enter Run : else
    leave Rest : [outcome(Rest) == cold]
    repeat Rest : else
  }
}
srm hearer {
  liveness { hearer = Listen . Answer~ }
  activities { Listen takes 1ms  Answer takes 1s }
  control hearer { enter Answer : when [team.signal.Done.number > 0] }
}
team Walk { a, b : walker  h : hearer }
"""
"""A walker waits for 1 s, walks for 1 s, runs (or halts, if it sees the ball) for 1 s and rests for ever."""

SHORT = {
    "DONE": "activity Walk writes team.signal.Done { number = 1 }",
    " sees {": " receives eyes.state.Ball {",
    " feels 2": " receives skin.data.Touch { force = 2 }",
    " feels 4": " receives skin.data.Touch { force = 4 }",
    "BALL": "eyes.state.Ball",
}
"""What stands for longer texts in the lines below."""

ALONE = [
    # What has no end of its own does not cut off what has one.
    ("passed", "in order a in Wait, a in Walk  at 97s a in Rest"),
    ("failed", "in order a in Wait, a in Walk  at 97s a in Walk"),
    # At a moment: after its last step.
    ("passed", "at 500ms a in Wait"),
    ("passed", "at 1s a in Walk"),
    ("failed", "at 1s a in Wait"),
    ("failed", "at 999ms a in Walk"),
    ("passed", "at 0ms a in Wait"),
    ("passed", "at 1500ms not a in (Wait or Run)"),
    # By a moment: at some point up to it, from the last stimulus on.
    ("passed", "by 1s a in Walk"),
    ("failed", "by 999ms a in Walk"),
    ("passed", "by 3s a in Wait"),
    ("failed", "at 2500ms a sees { visible = true }  by 3s a in Wait"),
    ("passed", "at 500ms a sees { visible = true }  by 2s a in Halt"),
    ("failed", "by 2s a in Halt"),
    ("passed", "at 2s a sees { visible = true }  by 2s a in Halt"),
    ("failed", "at 2001ms a sees { visible = true }  by 9s a in Halt"),
    # Events, and what is relative to what happens.
    ("passed", "at 500ms a raises Whistle  at 999ms a in Walk"),
    ("passed", "after 500ms in Walk a sees { visible = true }  by 2s a in Halt"),
    ("failed", "after 1001ms in Walk a sees { visible = true }  by 5s a in Halt"),
    ("passed", "after 500ms a in Walk : a in Walk  for 3s"),
    ("failed", "after 1s a in Walk : a in Walk  for 3s"),
    ("failed", "after 1s a in Walk : a in Run  for 1500ms"),
    ("vacuous", "after 500ms a in Halt : a in Walk  for 5s"),
    ("passed", "within 1s of a in Walk  a in Run  for 5s"),
    ("failed", "within 999ms of a in Walk  a in Run  for 5s"),
    ("vacuous", "within 1s of a in Halt  a in Run  for 5s"),
    ("failed", "within 2s of a in Run  a in Halt  for 3s"),
    # What lasts.
    ("passed", "always a in (Wait or Walk)  for 1999ms"),
    ("failed", "always a in (Wait or Walk)  for 2s"),
    ("passed", "never a in Halt  for 9s"),
    ("failed", "never a in Run  for 2s"),
    ("passed", "never a in Run  for 1999ms"),
    ("passed", "never a in Walk and a in Run  for 5s"),
    ("vacuous", "never a in Walk and a in Halt  for 5s"),
    ("passed", "never fault  for 5s"),
    ("passed", "no a in Walk before 1s"),
    ("failed", "no a in Walk before 1001ms"),
    ("failed", "no a in Wait before 1s"),
    ("passed", "no a in Rest within 1999ms after a in Walk  for 5s"),
    ("failed", "no a in Rest within 2s after a in Walk  for 5s"),
    ("vacuous", "no a in Rest within 2s after a in Halt  for 5s"),
    # Order.
    ("passed", "in order a in Wait, a in Walk, a in Rest  for 5s"),
    ("failed", "in order a in Walk, a in Wait  for 5s"),
    ("failed", "in order a in Rest, a in Rest  for 3500ms"),
    ("passed", "in order a in Rest, a in Rest  for 4s"),
    ("passed", "a in Walk before a in Run  for 5s"),
    ("failed", "a in Run before a in Walk  for 5s"),
    ("vacuous", "a in Walk before a in Halt  for 5s"),
    ("passed", "a in Wait until a in Walk  for 5s"),
    ("failed", "a in Wait until a in Run  for 5s"),
    ("passed", "a in Wait until a in Run  for 900ms"),
    # What has to come.
    ("passed", "eventually a in Run within 2s"),
    ("failed", "eventually a in Run within 1999ms"),
    ("failed", "eventually a in Halt  for 5s"),
    ("passed", "every a in Walk leads to a in Run within 1s  for 5s"),
    ("failed", "every a in Walk leads to a in Run within 999ms  for 5s"),
    ("passed", "every a in Rest leads to a in Rest within 1ms  for 5s"),
    ("failed", "every a in Run leads to a in Halt  for 5s"),
    ("vacuous", "every a in Halt leads to a in Run within 1s  for 5s"),
    # What activities do.
    ("passed", "activity Wait takes 200ms  at 200ms a in Walk"),
    ("failed", "activity Wait takes 201ms  at 200ms a in Walk"),
    ("passed", "activity Walk sets steps = 7  at 2s a has [steps == 7]"),
    ("passed", "activity Walk sets steps = 7  at 1999ms a has [steps == 0]"),
    ("passed", "table (n) { (1) (7) }  activity Walk sets steps = n + 1  at 2s a has [steps == n + 1]"),
    ("passed", "activity Rest ends warm, warm, cold  at 5s a in Rest  at 6s not a in Rest"),
    ("failed", "activity Rest ends warm, warm, cold  at 6s a in Rest"),
    ("passed", "activity Rest fails at 4500ms  a fails by 4500ms"),
    ("failed", "activity Rest fails at 4500ms  for 5s"),
    ("passed", "activity Rest fails at 4500ms  for 4s"),
    ("failed", "a fails by 4500ms"),
    # Values.
    ("passed", "at 1s a sees { distance = 3 }  at 1s a has [BALL.distance == 3]"),
    ("failed", "at 1s a has [BALL.distance == 0]"),
    ("passed", "at 1s a sees { distance = 3 }  every BALL.distance == 3 leads to a in Run within 1s  for 5s"),
    ("failed", "at 1s not a has [!has(BALL)]"),
    ("passed", "at 0ms a sees { }  at 300ms age(BALL) == 300ms and a in Wait"),
    ("passed", "at 0ms a sees { }  in order age(BALL) >= 1300ms and a in Walk, a in Run  for 3s"),
    ("failed", "at 0ms a sees { }  never age(BALL) > 1300ms and a in Walk  for 3s"),
    ("passed", "at 0ms a sees { mood = Mood.ANGRY }  at 0ms a has [BALL.mood == Mood.ANGRY]"),
    ("failed", "at 0ms a sees { }  at 0ms a has [BALL.mood == Mood.ANGRY]"),
    ("passed", "given d in 0..300  at 0ms a sees { distance = d }  at 1s a has [BALL.distance <= 300]"),
    ("failed", "given d in 0..300  at 0ms a sees { distance = d }  at 1s a has [BALL.distance < 300]"),
    ("passed", "table (s, x) { (true, Halt) (false, Run) }  at 0ms a sees { visible = s }  by 2s a in x"),
    ("failed", "table (s, x) { (true, Halt) (true, Run) }  at 0ms a sees { visible = s }  by 2s a in x"),
    # Crashes.
    ("passed", "crash a at 500ms  at 1500ms not a in (Wait or Walk)"),
    ("failed", "crash a at 500ms  by 3s a in Walk"),
    # Until then all is as before, although nothing else happens just then.
    ("passed", "crash a at 500ms  at 499ms a in Wait"),
    ("failed", "crash a at 500ms  by 499ms not a in Wait"),
    ("passed", "crash a at 500ms  restart a at 2s  at 2999ms a in Wait  at 3s a in Walk"),
    # Chance.
    ("passed", "activity Wait takes 500ms..1500ms  by 1s a in Walk in 25% of 10 seeds"),
    ("failed", "activity Wait takes 500ms..1500ms  by 1s a in Walk in 90% of 10 seeds"),
    ("failed", "activity Wait takes normal(1s, 100ms)  by 1s a in Walk in 100% of 10 seeds"),
    # States, outcomes, timers, histories and functions in conditions.
    ("passed", "at 1s a has [in(Walk) && !done(Walk) && in(walker)]  at 4s a has [in(Rest)]"),
    ("failed", "at 999ms a has [in(Walk)]"),
    ("passed", "activity Rest ends warm, warm, cold  by 6s a has [done(walker)]"),
    ("passed", "at 5s a has [count(Rest) == 3]"),
    ("failed", "at 4s a has [count(Rest) == 1]"),
    ("passed", "activity Walk ends badly  at 2s a has [outcome(Walk) == badly]"),
    ("failed", "activity Walk ends badly  at 1s a has [outcome(Walk) == badly]"),
    ("failed", "at 2s a has [outcome(Walk) == badly]"),
    ("passed", "in order a in Walk, a has [expired(pause)], a in Run  at 1499ms not a has [expired(pause)]"),
    ("failed", "at 1499ms a has [expired(pause)]"),
    ("passed", "at 1s a feels 2  at 2s a feels 4  at 3s a has [mean(skin.data.Touch.force, 5s) == 3]"),
    ("failed", "at 1s a feels 2  at 2s a feels 4  at 3s a has [mean(skin.data.Touch.force, 1s) == 3]"),
    ("passed", "at 1s a feels 2  at 2s a feels 4  at 2s a has [at(skin.data.Touch.force, -100ms) == 2]"),
    ("failed", "at 1s a feels 2  at 2s a feels 4  at 2s a has [at(skin.data.Touch.force, -1001ms) == 2]"),
    ("passed", "at 1s a sees { distance = 2.5 }  at 1s a has [up(BALL.distance) == 3]"),
    ("error", "at 1s a sees { distance = 2.5 }  at 1s a has [gone(BALL.distance) == 3]"),
    # What is assumed.
    ("passed", "assume Wait takes 1s..2s  at 1s a in Walk"),
    ("passed", "assume fair  assume Wait may fail  assume at most 1 of walker crash  crash a at 500ms"),
    # In a world, which may be none, all is as in `run`.
    ("passed", "world  at 1s a in Walk"),
    ("error", "world nowhere:world  at 1s a in Walk"),
    ("passed", "world walks:world  at 1s a in Walk"),
    # What is not played says so.
    ("error", "at 1s a receives inform Stop { number = 1 }  at 1s a in Walk"),
    ("error", "at 1s a has [same(BALL)]"),
]  # fmt: skip
"""Of scenarios in which only `a` takes part."""

TOGETHER = [
    ("passed", "never two of walker in Halt  at 0ms a sees { visible = true }  for 3s"),
    ("failed", "never two of walker in Run  for 3s"),
    ("vacuous", "never two of walker in Halt  for 3s"),
    ("passed", "at most 2 of walker in Run  for 3s"),
    ("failed", "at most one of walker in Run  for 3s"),
    ("passed", "DONE  by 2s h in Answer"),
    ("failed", "activity Walk writes team.signal.Done { number = 0 }  by 9s h in Answer"),
    ("passed", "DONE  network delay 300ms  at 2300ms h in Answer"),
    ("failed", "DONE  network delay 300ms  at 2299ms h in Answer"),
    ("failed", "DONE  from 0s to 5s h loses radio  by 4s h in Answer"),
    ("passed", "DONE  from 0s for 5s h loses radio  by 6s h in Answer"),
    ("passed", "DONE  from 0s to 5s partition { a, b } | { h }  by 6s h in Answer"),
    ("passed", "DONE  in order sent Done by a, received Done by h, h in Answer  for 3s"),
    ("failed", "in order sent Done by a, received Done by h  for 3s"),
    ("passed", "no message team.signal.Done before 3s"),
    ("failed", "DONE  no message team.signal.Done before 3s"),
    ("passed", "DONE  every sent Done d by b [d.number == 1] leads to h in Answer within 1ms  for 3s"),
    ("vacuous", "DONE  every sent Done d [d.number == 2] leads to h in Answer within 1ms  for 3s"),
    ("passed", "at 1s h receives team.signal.Done { number = 1 }  by 1s h in Answer"),
    ("passed", "crash a at 500ms  at 1s b in Walk  at 1s not a in Walk"),
    ("passed", "every a in Walk leads to h in Listen within 1s  for 3s"),
    ("error", "at 1s walker in Walk"),
    ("passed", "at 1s every walker in Walk  at 1s some walker in Walk"),
    ("passed", "at 1s h sees { distance = 3 }  at 1s h has [BALL.distance == 3]"),  # which it never reads
    ("passed", "crash a at 500ms  at 1s some walker in Walk"),
    ("failed", "crash a at 500ms  at 1s every walker in Walk"),
    ("error", "at 1s any walker in Walk"),
    ("passed", "at 1s any hearer in Listen  points 2"),
    ("failed", "at 0ms a sees { }  at 1s every walker has [has(BALL)]"),
    ("passed", "at 0ms a sees { }  at 1s some walker has [has(BALL)]"),
    ("passed", "DONE  eventually sent Done by some walker within 2s"),
]  # fmt: skip
"""Of scenarios of the whole team."""


WORLD = """
class World:
    step_ns = 100_000_000
    now_ns = 0
    bodies = {}
    def advance(self, moment):
        self.now_ns = moment
def world(seed):
    return World()
"""


def written(line: str) -> str:
    for short, long in SHORT.items():
        line = line.replace(short, long)
    return line


@pytest.fixture(scope="module")
def tested(tmp_path_factory: pytest.TempPathFactory) -> Mapping[str, ScenarioResult]:
    """The verdicts on all of them, by their texts."""
    scenarios = [
        *(f'scenario "{line}" {{\n  a : walker\n  {written(line)}\n}}' for _, line in ALONE),
        *(f'scenario "{line}" {{\n  {written(line)}\n}}' for _, line in TOGETHER),
    ]
    path = tmp_path_factory.mktemp("walk") / "walk.aseme"
    path.write_text(SYSTEM + "\n".join(scenarios))
    (path.parent / "walks.py").write_text(WORLD)
    return {item.name: item for item in play(path)}


def play(path: Path, seeds: tuple[int, ...] = (1,)) -> tuple[ScenarioResult, ...]:
    """The verdicts on the scenarios of a file."""
    compiled = compile_root(path)
    assert compiled.system is not None, [str(item) for item in compiled.diagnostics if item.code[0] == "E"]
    choice = choose(compiled.configuration)
    found = scenarios_in(compiled)
    return play_scenarios(
        compiled.system, found, seeds, compiled.configuration, choice, path.parent / "activities", 1
    )


@pytest.mark.parametrize(("verdict", "line"), [*ALONE, *TOGETHER])
def test_verdicts(verdict: str, line: str, tested: Mapping[str, ScenarioResult]) -> None:
    found = tested[line]
    assert found.verdict == verdict, (found.reason, str(found.span), found.story)


TALK = """system Talk
message Job { int size }
aip ask {
  participant boss {
    sends request Job  receives agree Job, refuse Job, inform Job
    process = Ask . (Wait | GiveUp)
  }
  participant hand {
    var free : bool = false
    receives request Job  sends agree Job, refuse Job, inform Job by Hear
    process = Hear . (Work | Leave)
  }
  outcome "Somebody works." when (Work@hand or Wait@boss)
  outcome "Nobody works." when GiveUp@boss
  outcome "Nobody knows."
  control boss {
    enter Ask    : / send request Job { size = 3 } to hand
    enter Wait   : agree Job from hand
    enter GiveUp : refuse Job from hand or after(3s)
  }
  control hand {
    enter Hear  : request Job from boss
    enter Work  : [free] / send agree Job { size = 3 } to boss
    enter Leave : else / send refuse Job { size = 0 } to boss
  }
}
srm chief { plays ask.boss  liveness { chief = Think . boss }  activities { Think takes 1s } }
srm clerk { plays ask.hand with Work = Dig  liveness { clerk = hand~ }  activities { Dig takes 1s } }
team Talk { ann : chief  bob : clerk }
"""


def test_agent_messages_and_places_of_participants(tmp_path: Path) -> None:
    """Also what a role binds has the protocol's name; `free` stays false, which is no fault here."""
    lines = [
        (
            "passed",
            "in order sent request Job, received request Job by bob, sent refuse Job, ann in GiveUp@boss",
        ),
        ("passed", "every sent request Job j [j.size == 3] leads to Hear@hand within 0ms  for 5s"),
        ("passed", "activity Hear sets free = true  in order sent request Job, Work@hand, Wait@boss"),
        ("passed", "activity Hear sets free = true  eventually bob in Dig"),
        ("failed", "eventually sent agree Job"),
        ("passed", "never fault  for 5s"),
        ("passed", 'eventually outcome "Nobody works." within 2s'),
        ("failed", 'eventually outcome "Somebody works." within 2s'),
        ("error", 'eventually outcome "Nobody knows." within 2s'),
        # Agent messages as inputs: from one who takes part, or not.
        ("passed", "bob : clerk  at 1s bob receives request Job { size = 2 } from ann  at 1s bob in Hear"),
        ("passed", "bob : clerk  at 1s bob receives request Job { size = 2 }  by 2s sent refuse Job by bob"),
        ("error", "bob : clerk  at 1s bob receives agree Job { size = 2 }  for 2s"),  # no part takes it
        ("passed", "ann : chief  at 2s ann receives agree Job { size = 2 }  by 2s ann in Wait"),
        ("failed", "ann : chief  at 4101ms ann receives agree Job { size = 2 }  by 5s ann in Wait"),
        ("passed", "activity Think takes 9s  at 2s bob receives request Job { } from ann  by 2s bob in Hear"),
        (
            "passed",
            "bob : clerk  at 1s bob receives request Job { } from ann  at 1s bob receives request Job { }"
            "  in order bob in Hear, bob in Leave, bob in Hear, bob in Leave  for 3s",
        ),
        # What activities send.
        (
            "passed",
            "activity Hear sends inform Job { size = 7 }  for 5s  "
            "every sent inform Job leads to received inform Job j by ann [j.size == 7] within 0ms",
        ),
        ("failed", "activity Hear sends inform Job { size = 7 }  eventually received inform Job by bob"),
        ("failed", "activity Hear sends refuse Job { size = 1 }  for 5s"),  # a transition sends it: bob fails
        ("failed", "activity Think sends inform Job { size = 1 }  for 5s"),  # it takes part in nothing
    ]  # fmt: skip
    path = tmp_path / "talk.aseme"
    scenarios = (f'scenario "{number}" {{ {line} }}\n' for number, (_, line) in enumerate(lines))
    path.write_text(TALK + "".join(scenarios))
    found = zip(play(path), lines, strict=True)
    assert [(item.verdict, line) for item, (_, line) in found] == lines


def test_only_real_activities_need_their_code(tmp_path: Path) -> None:
    path = tmp_path / "walk.aseme"
    scenarios = [f'scenario "{line}" {{ a : walker  {line} }}\n' for line in ("for 3s", "activity Wait real")]
    path.write_text(SYSTEM + "".join(scenarios))
    (tmp_path / "activities").mkdir()
    (tmp_path / "activities" / "wait.py").write_text("import nothing_there\nclass Wait: pass\n")
    simulated, real = play(path)
    assert simulated.verdict == "passed"
    assert (real.verdict, "nothing_there" in real.reason) == ("error", True)


ASSUMED = [
    ("assume Wait takes 1s..2s", None),
    ("assume Wait takes 2s..3s", "1 s"),
    ("assume Wait takes 200ms..900ms", "0.9 s"),
    ("assume Walk writes team.signal.Done every 900ms..1s", None),
    ("assume Walk writes team.signal.Done every 1s..2s", "1.9 s"),
    ("assume Walk writes team.signal.Done every 100ms..500ms", "1.5 s"),
    ("crash b at 500ms  assume at most 1 of walker crash", None),
    ("crash b at 500ms  assume at most 0 of walker crash", "0.5 s"),
    ("network delay 0..300ms  assume network delay 0..300ms", None),
    ("network delay 0..300ms  assume network delay 0..200ms", "0 s"),
    ("network loss 5%  assume network delay 100ms", "0 s"),
    ("network delay 50ms  assume network delay 100ms..300ms", "0 s"),
    ("network delay 0..150ms  assume network delay 100ms..300ms", "0 s"),
    ("assume network delay 100ms..300ms", None),
    ("from 1s for 1s b loses radio  assume network loss 1%", "1 s"),
    ("assume a has [eyes.state.Ball.visible]", None),  # it is absent
    ("at 1s a receives eyes.state.Ball { }  assume a has [eyes.state.Ball.visible]", "1 s"),
    ("at 1s b receives eyes.state.Ball { }  assume a has [eyes.state.Ball.visible]", None),
    ("at 1s b receives eyes.state.Ball { }  assume every walker has [eyes.state.Ball.visible]", "1 s"),
]  # fmt: skip


@pytest.mark.parametrize("where", ["scenario", "property"])
def test_what_is_broken_after_an_assumption_says_so(where: str, tmp_path: Path) -> None:
    path = tmp_path / "walk.aseme"
    text = SYSTEM
    paced = "activity Walk takes 1s writes team.signal.Done { number = 1 } every 900ms"
    for number, (line, _) in enumerate(ASSUMED):
        said, begin, assumed = line.partition("assume")
        inside = line if where == "scenario" else said
        if where == "property" and number:
            continue  # one property holds for all scenarios
        text += f'scenario "{number}" {{ a, b : walker  {paced}  {inside}  for 3s  at 3s a in Halt }}\n'
        text += f'property "{number}" {{ {begin}{assumed} }}\n' if where == "property" else ""
    path.write_text(text)
    found = [
        item.reason.partition("assumption broken at ")[2].partition(" (")[0] or None for item in play(path)
    ]
    assert found == [since for _, since in ASSUMED][: len(found)]


PROPERTIES = [
    ("passed", "never a in Halt"),
    ("failed", "never a in Run"),
    ("passed", "every a in Halt leads to a in Run within 1s"),  # says nothing of this run
    ("passed", "never b in Run"),  # b does not take part
    ("failed", "some walker in Walk before some walker in Wait"),
    ("passed", "assume Wait takes 5s..6s  a in Wait before a in Walk"),
]


@pytest.mark.parametrize(("verdict", "line"), PROPERTIES)
def test_properties_are_checked_in_each_scenario(verdict: str, line: str, tmp_path: Path) -> None:
    path = tmp_path / "walk.aseme"
    path.write_text(f'{SYSTEM}property "p" {{ {line} }}\nscenario "s" {{ a : walker  for 5s }}\n')
    (found,) = play(path)
    assert found.verdict == verdict, (found.reason, str(found.span), found.story)


def test_a_story_says_when_an_agent_starts_again(tmp_path: Path) -> None:
    path = tmp_path / "walk.aseme"
    body = "a : walker  crash a at 500ms  restart a at 2s  at 2500ms not a in Wait"
    path.write_text(f'{SYSTEM}scenario "s" {{ {body} }}\n')
    (found,) = play(path)
    lines = [(item.agent, item.moment, item.text) for item in found.story]
    assert [line for line in lines if "crashes" in line[2] or "again" in line[2]] == [
        ("a", 500_000_000, "crashes"),
        ("a", 2_000_000_000, "starts again"),
    ]


def test_a_story_says_what_did_not_arrive_and_what_is_awaited(tmp_path: Path) -> None:
    path = tmp_path / "talk.aseme"
    body = "from 0s to 9s bob loses radio  by 2s bob in Hear  for 3s"
    path.write_text(f'{TALK}scenario "s" {{ {body} }}\n')
    (found,) = play(path)
    lines = list(told(found.story))
    assert any("not received by bob" in line for line in lines), lines
    assert any("bob" in line and "is cut off from" in line for line in lines), lines
    assert any("bob" in line and "for request Job from boss" in line for line in lines), lines
    ((name, picture),) = pictures([found])
    assert name == "s.svg" and "not received by bob" in picture and "bob" in picture


def test_a_name_does_not_mean_a_state_whose_name_ends_with_it(tmp_path: Path) -> None:
    path = tmp_path / "kicker.aseme"
    path.write_text(
        """system Kicker
srm kicker { liveness { kicker = Kick_Ball . Ball } activities { Kick_Ball takes 1s  Ball takes 1s } }
team One { a : kicker }
scenario "s" { at 500ms a in Ball }
"""
    )
    (found,) = play(path)
    assert found.verdict == "failed", found.story


CLAUSES = [
    ("passed", "Ask@boss before Hear@hand"),
    ("failed", "Hear@hand before Ask@boss"),
    ("passed", "every Ask@boss leads to (Wait@boss or GiveUp@boss) within 300ms"),  # both ask bob
    ("failed", "every Ask@boss leads to (Wait@boss or GiveUp@boss) within 299ms"),
    ("failed", "every Ask@boss leads to Work@hand within 1s"),
    ("passed", "every Ask@boss leads to Work@hand"),  # a conversation may be cut off by the end: it is open
    # In each conversation: there are two at once.
    ("passed", "at most one boss"),
    ("passed", "at most 1 Hear@hand"),
    ("failed", "at most 0 hand"),
    ("vacuous", "every Work@hand leads to Wait@boss"),
]


@pytest.mark.parametrize(("verdict", "line"), CLAUSES)
def test_clauses_are_checked_in_each_conversation(verdict: str, line: str, tmp_path: Path) -> None:
    """One that was about nothing is noted for the whole, and fails no scenario."""
    path = tmp_path / "talk.aseme"
    text = TALK.replace("  control boss {", f"  clause {line}\n  control boss {{", 1)
    text = text.replace("request Job { size = 3 } to hand", "request Job { size = 3 } to one hand")
    path.write_text(text + 'scenario "s" { ann, eve : chief  bob, joe : clerk  for 3s }\n')
    (found,) = play(path)
    assert found.verdict == verdict.replace("vacuous", "passed"), (found.reason, found.story)
    assert bool(never_met([found])) == (verdict == "vacuous")


def test_clauses_of_a_protocol_without_messages_hold_in_the_whole_team(tmp_path: Path) -> None:
    path = tmp_path / "light.aseme"
    path.write_text(
        """system Light
aip cross { participant car { process = Wait . Go }  clause at most one Go@car }
srm driver { plays cross.car  liveness { driver = car }  activities { Wait takes 1s  Go takes 1s } }
scenario "alone" { a : driver  for 3s }
scenario "one after the other" { a, b : driver  activity Wait takes 1s..9s  in order Go@car, Go@car }
scenario "together" { a, b : driver  for 3s }
"""
    )
    found = [(item.name, item.verdict, item.reason) for item in play(path)]
    assert found == [
        ("alone", "passed", ""),
        ("one after the other", "passed", ""),
        ("together", "failed", "clause of cross: too many at once at 1 s: a, b are in Go"),
    ]
