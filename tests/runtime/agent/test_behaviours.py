"""Behaviours: what classes of the user hear, what the tree shows, and that a run is the same without both."""

from __future__ import annotations

from typing import Any

import pytest

from aseme_dsl.backends.jade_like import BACKEND
from aseme_dsl.runtime.agent.behaviours import JadeLikeAgent
from aseme_dsl.runtime.team.faults import Crash, Faults
from aseme_dsl.runtime.team.swap import activity_errors
from aseme_dsl.runtime.team.team import TeamError
from tests.faults.changing import version
from tests.runtime.playing import MS, SECOND, Played, make, play
from tests.support.generated import Generated, generate

WALK = """\
system S
srm walker {
  liveness {
    walker = Prepare . walk . Rest
    walk   = (Left . Right)~ || Look~
  }
  activities { Prepare takes 100ms  Left takes 200ms  Right takes 200ms  Rest takes 100ms
               Look every 150ms takes 50ms }
  control walker {
    enter Rest : after(650ms)
  }
}
team S { me : walker }
"""


class Heard:
    """Own classes for behaviours of an agent that note what they hear, and for the agent that uses them."""

    def __init__(self, made: Generated, *names: str, role: str = "walker", raises: str = "") -> None:
        self.lines: list[str] = []
        lines = self.lines
        generated: Any = made.package.AGENTS[role]
        behaviours = __import__(generated.main.__module__, fromlist=["x"])

        def own(name: str) -> type[Any]:
            def note(self: Any, what: str) -> None:
                lines.append(f"{self.agent.now // MS} {what} {name}")
                if what == raises:
                    raise ValueError("no battery")

            hooks = {
                f"on_{what}": (lambda self, what=what: note(self, what)) for what in ("start", "end", "wake")
            }
            return type(name, (getattr(behaviours, name),), hooks)

        kinds = [own(name) for name in names]
        self.agents: list[JadeLikeAgent] = []
        heard = self

        class Own(generated):  # type: ignore[misc]
            def setup(self) -> None:
                heard.agents.append(self)
                self.use(*kinds)

            def take_down(self) -> None:
                lines.append(f"{self.now // MS} down")

        self.found = {generated.own: Own}


def walk(made: Generated | None = None, *names: str, **options: Any) -> tuple[Heard, Played]:
    made = made or generate(WALK, backend=BACKEND)
    heard = Heard(made, *names, **options)
    return heard, play(made, heard.found, until=3 * SECOND)


def test_starts_and_ends_are_heard_in_order() -> None:
    heard, played = walk(None, "Walker", "Prepare", "Walk", "Left", "Right", "Look", "Rest")
    assert played.result.reason == "finished"
    assert [line for line in heard.lines if "Look" not in line] == [
        "0 start Walker",
        "0 start Prepare",
        "100 end Prepare",
        "100 start Walk",
        "100 start Left",
        "300 end Left",
        "300 start Right",
        "500 end Right",
        "500 start Left",
        "700 end Left",
        "700 start Right",
        "750 end Right",
        "750 end Walk",
        "750 start Rest",
        "850 end Rest",
        "850 end Walker",
        "850 down",
    ]
    assert heard.lines.count("450 start Look") == 1  # a ticker starts once a period
    # what is left at one instant is left innermost first, in document order
    assert heard.lines[-7:-4] == ["750 end Right", "750 end Look", "750 end Walk"]


def test_a_waker_is_told_when_its_time_has_come() -> None:
    heard, _ = walk(None, "WalkAfter650ms", "Walk")
    assert heard.lines == [
        "100 start Walk",
        "100 start WalkAfter650ms",
        "750 wake WalkAfter650ms",
        "750 end WalkAfter650ms",
        "750 end Walk",
        "850 down",
    ]


def test_the_tree_shows_what_is_active_and_what_is_done() -> None:
    made = generate(WALK, backend=BACKEND)
    heard = Heard(made)
    played = play(made, heard.found, until=400 * MS)
    (agent,) = heard.agents
    assert agent is played.team.agent("me").shown
    assert [repr(item) for item in agent.behaviours] == [
        "<Walker 0 active>",
        "<WalkAfter650ms 0.3 active>",
        "<Prepare 0.2 done>",
        "<Walk 0.3/0.3.2 active>",
        "<LeftForever 0.3.2.1/0.3.2.1.2 active>",
        "<LeftThenRight 0.3.2.1.2.2 active>",
        "<Left 0.3.2.1.2.2.2 done>",
        "<Right 0.3.2.1.2.2.3 active>",
        "<LookForever 0.3.2.2/0.3.2.2.2 active>",
        "<Look 0.3.2.2.2.2 active>",
        "<Rest 0.4 waiting>",
    ]
    main: Any = agent.behaviours[0]
    assert main.current.name == "Walk"
    assert [item.name for item in main.sub_behaviours] == ["Prepare", "Walk", "Rest"]


def test_states_that_last_for_no_time_are_heard_too() -> None:
    made = generate(
        """\
system S
srm walker {
  liveness { walker = (A | B) . C  }
  activities { A takes 10ms  B takes 10ms  C takes 10ms }
  control walker {
    enter A : [n > 0]
    enter B : else
    enter C : when [true]
  }
  var n : int = 0
}
team S { me : walker }
""",
        backend=BACKEND,
    )
    heard, _ = walk(made, "AOrB", "B", "C")
    assert heard.lines == [
        "0 start AOrB",
        "0 start B",
        "0 end B",
        "0 end AOrB",
        "0 start C",
        "10 end C",
        "10 down",
    ]


def test_what_a_hook_raises_is_a_fault_and_nothing_else() -> None:
    made = generate(WALK, backend=BACKEND)
    heard, played = walk(made, "Prepare", raises="start")
    (fault,) = played.of("fault")
    assert fault["reason"].startswith(
        "on_start of Prepare raised ValueError: no battery (test_behaviours.py:"
    )
    assert fault["at"] == "test.aseme:4:14"
    assert heard.lines == ["0 start Prepare", "100 end Prepare", "850 down"]
    finish = played.records[-1]
    assert [item["reason"] for item in finish.pop("faults")] == [fault["reason"]]
    assert [r for r in played.records if r["kind"] != "fault"] == play(made, until=3 * SECOND).records


def test_setup_that_raises_leaves_the_generated_behaviours() -> None:
    made = generate(WALK, backend=BACKEND)
    generated: Any = made.package.AGENTS["walker"]

    class Lost(generated):  # type: ignore[misc]
        def setup(self) -> None:
            raise RuntimeError("no map")

    played = play(made, {generated.own: Lost}, until=3 * SECOND)
    assert played.result.reason == "finished"
    (fault,) = played.of("fault")
    assert fault["reason"].startswith("setup of Lost raised RuntimeError: no map")
    shown = played.team.agent("me").shown
    assert shown is not None and shown.behaviours[0].done


def test_only_behaviours_of_the_agent_are_used_and_each_once() -> None:
    made = generate(WALK, backend=BACKEND)
    heard = Heard(made, "Left", "Left")
    assert [record["reason"] for record in play(made, heard.found, until=SECOND).of("fault")] == [
        _at("setup of Own raised TypeError: Left and Left are both for Left")
    ]


def _at(text: str) -> Any:
    """Equal to a text with a place behind it."""

    class Beginning(str):
        __slots__ = ()

        def __eq__(self, other: object) -> bool:
            return str(other).startswith(text)

        __hash__ = str.__hash__

    return Beginning(text)


def test_a_class_that_says_itself_what_is_in_it_is_not_used() -> None:
    made = generate(WALK, backend=BACKEND)
    generated: Any = made.package.AGENTS["walker"]
    behaviours = __import__(generated.main.__module__, fromlist=["x"])

    class Walk(behaviours.Walk):  # type: ignore[name-defined, misc]
        def build(self) -> None:
            pass

    class Own(generated):  # type: ignore[misc]
        def setup(self) -> None:
            self.use(Walk)

    (fault,) = play(made, {generated.own: Own}, until=3 * SECOND).of("fault")
    assert "Walk overrides build: what is in it stands in test.aseme" in fault["reason"]


def test_a_class_that_cannot_be_made_leaves_the_generated_one() -> None:
    made = generate(WALK, backend=BACKEND)
    generated: Any = made.package.AGENTS["walker"]
    behaviours = __import__(generated.main.__module__, fromlist=["x"])

    class Walk(behaviours.Walk):  # type: ignore[name-defined, misc]
        def __init__(self, agent: JadeLikeAgent) -> None:
            self.steps = 0

    class Own(generated):  # type: ignore[misc]
        def setup(self) -> None:
            self.use(Walk)

    played = play(made, {generated.own: Own}, until=3 * SECOND)
    assert played.result.reason == "finished"
    (fault,) = played.of("fault")
    assert (
        "__init__ of Walk raised TypeError: Walk.__init__ does not call that of its base" in fault["reason"]
    )


def test_a_class_of_the_user_that_shows_something_else_is_refused_before_the_run() -> None:
    made = generate(WALK, backend=BACKEND)

    class WalkerAgent:
        pass

    (problem,) = activity_errors(made.charts.values(), {"SWalkerAgent": WalkerAgent}.get)
    assert problem.startswith("WalkerAgent is not a subclass of generated_")
    with pytest.raises(TeamError, match="WalkerAgent is not a subclass"):
        make(made, {"SWalkerAgent": WalkerAgent})


def test_an_agent_that_fails_leaves_everything() -> None:
    class Left:
        def execute(self, context: Any) -> None:
            raise ValueError("no leg")

    made = generate(WALK, backend=BACKEND)
    heard = Heard(made, "Walker", "Walk", "Left", "Look")
    played = play(made, {"Left": Left, **heard.found}, until=3 * SECOND)
    assert played.result.failed
    assert heard.lines[-5:] == ["100 end Left", "100 end Look", "100 end Walk", "100 end Walker", "100 down"]


def test_an_agent_that_is_stopped_is_taken_down_where_it_is() -> None:
    made = generate(WALK, backend=BACKEND)
    heard = Heard(made, "Walker", "Prepare")
    play(made, heard.found, until=50 * MS)
    assert heard.lines == ["0 start Walker", "0 start Prepare", "50 down"]


def test_behaviours_go_on_over_a_swap() -> None:
    made = generate(WALK, backend=BACKEND)
    other = generate(WALK.replace("Rest takes 100ms", "Rest takes 50ms"), backend=BACKEND)
    before, after = Heard(made, "Prepare", "Walk", "Left"), Heard(other, "Walk", "WalkAfter650ms", "Left")
    team, _ = make(made, before.found, until=3 * SECOND)
    change = team.swap(version(other, after.found), at=350 * MS)
    team.run()
    assert change.state == "done"
    assert before.lines[-2:] == ["100 start Left", "300 end Left"]
    assert after.lines == [
        "500 start Left",
        "700 end Left",
        "750 wake WalkAfter650ms",
        "750 end WalkAfter650ms",
        "750 end Walk",
        "800 down",
    ]


TWO = """\
system S
srm one { liveness { one = A~ }  activities { A takes 100ms } }
srm two { liveness { two = B~ }  activities { B takes 100ms } }
team S { me : one }
"""


def test_an_agent_that_is_told_another_plan_leaves_one_and_starts_the_other() -> None:
    made = generate(TWO, backend=BACKEND)
    one, two = Heard(made, "One", "A", role="one"), Heard(made, "Two", "B", role="two")
    team, _ = make(
        made,
        one.found | two.found,
        until=200 * MS,
        version=version(made, one.found | two.found),
        agents=[("me", "one")],
    )
    team.select("me", "two", at=150 * MS)
    team.run()
    assert one.lines == [
        "0 start One",
        "0 start A",
        "100 end A",
        "100 start A",
        "150 end A",
        "150 end One",
        "150 down",
    ]
    assert two.lines == ["150 start Two", "150 start B", "200 down"]


def test_a_crash_is_no_end() -> None:
    made = generate(TWO, backend=BACKEND)
    heard = Heard(made, "One", "A", role="one")
    faults = Faults(crashes=[Crash("me", 150 * MS, 100 * MS)])
    play(made, heard.found, until=300 * MS, agents=[("me", "one")], faults=faults)
    assert heard.lines == [
        "0 start One",
        "0 start A",
        "100 end A",
        "100 start A",
        "250 start One",
        "250 start A",
        "300 down",
    ]
