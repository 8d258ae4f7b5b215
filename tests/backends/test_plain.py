"""The plain backend: what it writes, and what it refuses."""

from __future__ import annotations

import subprocess
import sys
from functools import partial
from itertools import cycle
from pathlib import Path

import pytest

from aseme_dsl.backends.backend import BackendOptions, Refused
from aseme_dsl.backends.plain import BACKEND
from aseme_dsl.backends.plain import generate as generate_module
from aseme_dsl.codegen.plain.options import TAKEN, PlainOptions
from aseme_dsl.diagnostics.problems.running import AgentFeature
from aseme_dsl.runtime.plain import plain as runtime
from tests.support.generated import generate, system_of
from tests.support.plain_engine import plain_class

LAMP = """
system Lamp

enum Colour { WHITE RED }
message Room { bool dark }
topic room { state Room }

srm lamp {
  var touched : int = 0
  var colour : Colour = Colour.WHITE
  liveness { lamp = (Dark . Shine)~ }
  control lamp {
    enter Shine : touch [room.state.Room.dark] / touched = touched + 1; colour = Colour.RED
    leave Shine : touch
  }
}
"""


def built(tmp_path: Path, text: str) -> Path:
    for artefact in BACKEND.generate(system_of(text), BackendOptions()):
        path = tmp_path / "plain" / artefact.path
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(artefact.text, encoding="utf-8")
    return tmp_path / "plain"


@pytest.mark.parametrize("names", [("a", "a_watched"), ("a_watched", "a"), ("messages", "messages_")])
def test_roles_whose_modules_would_be_called_alike(tmp_path: Path, names: tuple[str, str]) -> None:
    roles = "".join(f"srm {name} {{ liveness {{ {name} = Walk{n}~ }} }}\n" for n, name in enumerate(names))
    folder = built(tmp_path, f"system Two\n{roles}")
    program = """
import Two, importlib
for name in sorted(vars(Two)):
    kind = getattr(Two, name)
    if isinstance(kind, type) and hasattr(kind, "LEAVES"):
        module = importlib.import_module(f"{kind.__module__}_watched")
        chart = getattr(module, f"Watched{name}")()
        chart.start()
        print(name, [item.removeprefix("start_") for item in dir(chart) if item.startswith("start_")])
"""
    done = subprocess.run([sys.executable, "-c", program], cwd=folder, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert len(done.stdout.splitlines()) == 2
    assert "Walk0" in done.stdout and "Walk1" in done.stdout


def test_a_statechart_is_an_ordinary_class(tmp_path: Path) -> None:
    folder = built(tmp_path, LAMP)
    program = """
from Lamp import Lamp
from Lamp.messages import Room

lamp = Lamp()
lamp.start()
print(lamp.configuration(), lamp.send("touch"))
lamp.bb.room_state_Room = Room(dark=True)
print(lamp.send("touch"), lamp.configuration(), lamp.bb.touched, lamp.bb.colour.name)
print(lamp.send("touch"), lamp.send("other"), lamp.configuration())

from Lamp.lamp_watched import WatchedLamp

class Told(WatchedLamp):
    def start_Shine(self, label):
        print("on")
    def stop_Shine(self, label):
        print("off")
    def took(self, *transitions):
        print(self.TRANSITIONS[transitions[0]].split("  (")[0])

lamp = Told(lamp.bb)
lamp.start()
lamp.send("touch")
lamp.send("touch")
"""
    done = subprocess.run(
        [sys.executable, "-c", program],
        cwd=folder,
        env={"PYTHONPATH": str(Path(__file__).parents[2])},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.stdout.splitlines() == [
        "('0.2.2',) False",
        "True ('0.2.3',) 1 RED",
        "True False ('0.2.2',)",
        "0.1 -> 0.2 (Dark . Shine)",
        "0.2.1 -> 0.2.2 Dark",
        "0.2.2 -> 0.2.3 Shine  touch [room.state.Room.dark] / touched = touched + 1; colour = Colour.RED",
        "on",
        "0.2.3 -> 0.2.4  touch",
        "off",
        "0.2 -> 0.2 (Dark . Shine)",
        "0.2.1 -> 0.2.2 Dark",
    ], done.stderr


def test_what_is_generated_passes_the_checkers(tmp_path: Path) -> None:
    built(tmp_path, LAMP)
    for command in (["ruff", "check", "--isolated", "plain"], ["mypy", "--strict", "plain/Lamp"]):
        done = subprocess.run(
            [sys.executable, "-m", *command], cwd=tmp_path, capture_output=True, text=True, check=False
        )
        assert done.returncode == 0, done.stdout


def test_the_same_text_gives_the_same_bytes() -> None:
    one, other = (BACKEND.generate(system_of(LAMP), BackendOptions()) for _ in range(2))
    assert one == other


def test_what_it_cannot_do_is_refused_with_every_place() -> None:
    text = """
system S
message M { int x }
topic t { signal M  state M }
srm R {
  liveness { R = A . B . C }
  control R {
    enter B : when [has(t.signal.M)]
    enter C : when [t.signal.M.x > 1 || expired(pace)] / write_messages.t.state.M
    leave C : go / start_timer(pace, 1s)
  }
}
"""
    with pytest.raises(Refused) as refused:
        BACKEND.generate(system_of(text), BackendOptions())
    told = [
        (problem.message.rpartition(": ")[2], 1 + len(problem.related))
        for problem in refused.value.diagnostics
    ]
    assert told == [
        ("signals (a program sends events)", 2),
        ("publishing", 1),
    ]


def test_without_conditions_over_it_a_message_has_no_place() -> None:
    made = generate(LAMP)
    text = next(a.text for a in BACKEND.generate(made.system, BackendOptions()) if a.path == "Lamp/lamp.py")
    assert "room_state_Room: Room | None = None" in text
    assert "bb.room_state_Room" in text


MANY = """
system Many
srm R {
  var a : bool = false
  var b : bool = false
  var c : bool = false
  var d : bool = false
  var e : int = 0
  var tracked : int = 0
  liveness { R = (Wait . Go)~ }
  control R {
    enter Go : when [a]
    enter Go : when [b]
    enter Go : when [c]
    enter Go : when [d] / d = false; tracked = tracked + 1
    enter Go : when [e == 1]
    enter Go : when [e == 2]
    enter Go : when [e == 3]
    enter Go : when [e == 4]
    leave Go : when [!a && !b && !c]
  }
}
"""


def test_a_tracked_blackboard_is_looked_at_when_it_has_changed() -> None:
    kind = plain_class(generate(MANY), "R", PlainOptions())
    board = vars(sys.modules[kind.__module__])["RBlackboard"](tracked=True)
    chart = kind(board)
    chart.start()
    assert not chart.step()
    board.d = True
    assert not chart.step(), "nobody has said so"
    board.changed()
    assert chart.step()
    assert (chart.configuration(), board.d, board.tracked_2) == (("0.2.2",), False, 1)


def test_one_that_is_not_tracked_is_looked_at_each_time() -> None:
    chart = plain_class(generate(MANY), "R", PlainOptions())()
    chart.start()
    assert not chart.step()
    chart.bb.a = True
    assert chart.step()
    assert chart.configuration() == ("0.2.3",)


def test_what_the_statechart_writes_itself_is_looked_at() -> None:
    text = MANY.replace("leave Go : when [!a && !b && !c]", "leave Go : on / a = true")
    kind = plain_class(generate(text), "R", PlainOptions())
    board = vars(sys.modules[kind.__module__])["RBlackboard"](tracked=True)
    chart = kind(board)
    chart.start()
    board.b = True
    board.changed()
    assert chart.step()
    board.b = False
    board.changed()
    assert chart.send("on")
    assert chart.configuration() == ("0.2.3",), "back in Wait, `a` leads on at once"


@pytest.mark.parametrize("written", ["({0} . B{1})~", "({0} || B{1})"])
def test_formulas_may_be_nested_deep(written: str) -> None:
    formula = "A"
    for number in range(120):
        formula = written.format(formula, number)
    chart = plain_class(generate(f"system S srm R {{ liveness {{ R = {formula} }} }}"), "R", PlainOptions())()
    chart.start()
    assert not chart.step()
    assert chart.done(chart.configuration()[-1])


def test_it_may_be_said_how_an_activity_has_ended_though_nobody_asks() -> None:
    text = "system S srm R { liveness { R = Grasp . Carry } activities { Grasp ends held, slipped } }"
    chart = plain_class(generate(text), "R", PlainOptions())()
    chart.start()
    assert chart.done("0.2", "held")
    assert chart.configuration() == ("0.3",)


def test_what_moves_without_doing_anything_is_written_so() -> None:
    text = "system S srm R { liveness { R = (A . B)~ || C } control R { repeat (A . B) : again } }"
    chart = plain_class(generate(text), "R", PlainOptions())()
    chart.start()
    assert chart.send("again")
    assert chart.names() == ("A", "C")


WORDS = """
system S
message Now {{ int now }}
topic news {{ state Now }}
srm R {{
  var n : int = 0
  var now : int = 2
  var said : string = "bb now, self moved"
  liveness {{ R = now  now = A . B . C . D }}
  control now {{
    enter B : go [said == "go now" || said == "self"] / said = "bb"; n = n + 1
    enter C : go [now > 1] / now = 1
    enter D : go{more} [news.state.Now.now > 3] / said = "moved now"
  }}
}}
"""


@pytest.mark.parametrize("more", ["", " or after(1s)"])
@pytest.mark.parametrize("mapping", [False, True])
def test_words_of_the_document_are_no_locals(more: str, mapping: bool) -> None:
    made = generate(WORDS.format(more=more))
    chart = plain_class(made, "R", PlainOptions(mapping=mapping))()
    put = chart.bb.__setitem__ if mapping else partial(setattr, chart.bb)
    chart.start()
    put("said", "go now")
    assert chart.send("go")
    put("news_state_Now", made.message("Now", now=4))
    assert chart.send("go")
    assert chart.send("go")
    assert chart.configuration() == ("0.5",)
    said, now = (chart.bb["said"], chart.bb["now"]) if mapping else (chart.bb.said, chart.bb.now)
    assert (said, now) == ("moved now", 1)


def test_a_local_is_only_there_where_it_is_used() -> None:
    made = system_of(WORDS.format(more=" or after(1s)"))
    texts = {artefact.path: artefact.text for artefact in BACKEND.generate(made, BackendOptions())}
    start = texts["S/R.py"].partition("def start(self)")[2].partition("    def ")[0]
    assert "now = self.now" not in start
    assert "\x01" not in "".join(texts.values())


HOOKS = """
system S
srm R {
  liveness { R = (work [> Off)~  work = A . all  all = B . (H | I) || C . (D | E) || F }
  control R { enter Off : over }
  control work { enter all : go }
  control all { enter H : tick  enter I : tock  enter D : tick  enter E : tock or after(1s) }
}
"""


@pytest.mark.parametrize(
    "wrong", ["start_B", "start_C", "start_F", "start_D", "start_H", "stop_B", "stop_F", "took"]
)
def test_a_method_that_raises_leaves_every_region_somewhere(wrong: str) -> None:
    """`start_…` raises after a transition is taken, `stop_…` and `took` before."""
    kind = plain_class(generate(HOOKS), "R", PlainOptions(watched=True))
    armed: list[str] = []

    def raises(self: object, *arguments: object) -> None:
        if armed:
            raise OSError(armed.pop())

    chart = type("Raising", (kind,), {wrong: raises})()
    plays = cycle(("go", "tick", "over", "go", "tock", "go", "over"))
    chart.start()
    seen = 0
    for turn in range(300):
        before = chart.configuration()
        armed[:] = [wrong]
        try:
            chart.send(next(plays))
        except OSError:
            seen += 1
            after = chart.configuration()
            assert (after == before) is not wrong.startswith("start"), (before, after)
        armed.clear()
        chart.step()
        for label in chart.configuration() if turn % 3 == 0 else ():
            chart.done(label)
        if chart.finished:
            chart.start()
    assert seen


def test_a_variable_that_cannot_keep_its_name_is_told_of(tmp_path: Path) -> None:
    text = """
system S
srm R {
  var changed : int = 0
  var n : int = 0
  liveness { R = A . B }
  control R { enter B : go / changed = changed + 1; n = changed }
}
"""
    module = (built(tmp_path, text) / "S" / "R.py").read_text("utf-8")
    assert '"""What R knows. The variable `changed` is `changed_2`."""' in module


COLLIDING = """
system B

enum Any { RED }
message Light { bool on }
message Random { int x }
message Plain { int x  Random inner }
topic room { state Light, Random, Plain }

srm light {
  var shown : Any = Any.RED
  var chance : double = 0.0
  liveness { light = A . B . C }
  control light {
    enter B : ev [room.state.Light.on && room.state.Random.x > 1 && shown == Any.RED]
    enter C : ev [room.state.Plain.inner.x > 1] / chance = random()
  }
}
srm fast_lane { liveness { fast_lane = A . B } control fast_lane { enter B : ev } }
srm FastLane { liveness { FastLane = A . B } control FastLane { enter B : ev } }
srm any { liveness { any = A . B } control any { enter B : ev } }
srm plain { liveness { plain = A . B } control plain { enter B : ev } }
srm Exception { liveness { Exception = A . B } control Exception { enter B : ev [1 / 0 > 1] } }
"""


def test_no_class_has_the_name_of_another_or_of_a_message(tmp_path: Path) -> None:
    folder = built(tmp_path, COLLIDING)
    program = """
import B
from B.messages import Light, Plain, Random

chart = B.LightChart()
chart.start()
chart.bb.room_state_Light = Light(on=True)
chart.bb.room_state_Random = Random(x=2)
print(chart.send("ev"))
chart.bb.room_state_Plain = Plain(x=1, inner=Random(x=3))
print(chart.send("ev"), chart.configuration())
print([name for name in B.__all__ if not name.endswith("Blackboard")])
for kind in (B.AnyChart, B.PlainChart, B.FastLane, B.FastLaneChart, B.ExceptionChart):
    one = kind()
    one.start()
    print(one.send("ev"), end=" ")
"""
    done = subprocess.run([sys.executable, "-c", program], cwd=folder, capture_output=True, text=True)
    assert done.stdout.splitlines() == [
        "True",
        "True ('0.4',)",
        "['AnyChart', 'ExceptionChart', 'FastLane', 'FastLaneChart', 'LightChart', 'PlainChart']",
        "True True True True False ",
    ], done.stderr
    done = subprocess.run(
        [sys.executable, "-m", "mypy", "--strict", "B"], cwd=folder, capture_output=True, text=True
    )
    assert done.returncode == 0, done.stdout


def test_what_is_taken_is_all_that_a_module_has() -> None:
    # pytest adds names with `@` to the modules of a plugin's package.
    assert {name for name in vars(runtime) if name.isidentifier() and not name.startswith("_")} <= TAKEN
    assert {*generate_module._RUNTIME, *(n for _, names in generate_module._STANDARD for n in names)} <= TAKEN


REFUSED = {
    AgentFeature.AGENT_MESSAGES: "the messages of agents",
    AgentFeature.AGENTS: "variables of type `agent`",
    AgentFeature.BOUNDS: "the bounds of a variable beside an `error` transition",
    AgentFeature.PROTOCOLS: "protocols",
    AgentFeature.PUBLISHING: "publishing",
    AgentFeature.SIGNALS: "signals",
    AgentFeature.DATA: "measurements (`data`, `at`, `mean`)",
    AgentFeature.AGES: "how old a message is (`age`)",
    AgentFeature.DEADLINES: "deadlines of activities",
    AgentFeature.GIVEN: "arguments of activities that may be absent or fail",
    AgentFeature.NUMBERS: "`index`",
    AgentFeature.STAYING: "`on` without an event",
    AgentFeature.RESUMING: "`resume`",
    AgentFeature.RAISING: "`raise`",
    AgentFeature.READING: "`read_messages`",
    AgentFeature.LEAVING: "transitions out of a parallel from inside it",
    AgentFeature.ENTERING: "from outside into a part of it",
}
"""Everything that is refused, and what the page calls it."""


def test_the_page_names_everything_that_is_refused() -> None:
    assert set(AgentFeature) == set(REFUSED)
    page = (Path(__file__).parents[2] / "docs" / "howto" / "embed-a-statechart.md").read_text("utf-8")
    text = " ".join(page.partition("## What is refused")[2].split())
    assert [phrase for phrase in REFUSED.values() if phrase not in text] == []


def test_a_word_in_a_text_imports_nothing(tmp_path: Path) -> None:
    text = """
system U
message Any { int Callable }
topic t { state Any }
srm R {
  var Mapping : string = "Random NEVER"
  liveness { R = A . B }
  control R { enter B : go [t.state.Any.Callable > 1 && Mapping == "ROUNDS: don't ABSENT"] }
}
"""
    built(tmp_path, text)
    done = subprocess.run(
        [sys.executable, "-m", "ruff", "check", "--isolated", "plain"],
        cwd=tmp_path,
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stdout


NAMED = """
system S
srm R {
  var tries : int = 0
  liveness { R = x || y . x  x = (A . B)~  y = C . D }
  control y { enter D : next }
  control x { enter B : go / tries = tries + 1 }
}
"""


def test_a_debugger_shows_names() -> None:
    kind = plain_class(generate(NAMED), "R", PlainOptions(watched=True))
    seen: list[str] = []

    class Telling(kind):  # type: ignore[misc, valid-type]
        def took(self, *transitions: int) -> None:
            seen.append(repr(self))

    chart = Telling()
    assert repr(chart) == "<Telling: not started>"
    chart.start()
    chart.send("next")
    chart.send("go")
    assert all(text.startswith("<Telling: ") for text in seen)
    assert "AND" not in chart.names()
    assert repr(chart).startswith("<Telling: B 0.2.1")
    assert "D" in chart.names()
    assert repr(chart.bb) == "<RBlackboard tries=1>"
    while not chart.finished and chart.RUNNING:
        active = [label for label in chart.configuration() if label in chart.RUNNING]
        if not any(chart.done(label) for label in active):
            break
    assert repr(chart).startswith("<Telling: ")


def test_what_has_no_name_is_not_among_the_names() -> None:
    chart = plain_class(generate(NAMED), "R", PlainOptions())()
    chart.start()
    assert chart.configuration()[0] == "0.2"
    assert all(name.split()[0] in "ABCD" for name in chart.names())


def test_a_comment_says_how_many_states_it_leaves_out(tmp_path: Path) -> None:
    text = f"system S srm R {{ liveness {{ R = {' . '.join(f'S{n}' for n in range(1000))} }} }}"
    module = (built(tmp_path, text) / "S" / "R.py").read_text("utf-8")
    (line,) = (line for line in module.splitlines() if "# r0: " in line)
    assert line.endswith(", and 1985 more")  # each runs or is complete, and there is the END


def test_a_class_says_what_its_slots_mean(tmp_path: Path) -> None:
    text = (built(tmp_path, LAMP) / "Lamp" / "lamp.py").read_text("utf-8")
    assert "    # r0: what is active in 0 lamp: 0 Dark, 1 Shine\n" in text
