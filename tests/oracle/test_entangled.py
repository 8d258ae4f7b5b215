"""Charts whose regions and rounds depend on each other, written by hand, where a generator is easily wrong.

The plain face decides before it runs what may be taken together, which regions need copies of variables,
where a second round could find anything, and which events share code: each chart here is a reason not to.
"""

from __future__ import annotations

import re

import pytest

from aseme_dsl.codegen.program import sizes
from aseme_dsl.runtime.plain import plain
from tests.oracle import interpreter
from tests.oracle.choices import Choices
from tests.oracle.examples import ROUNDS, forget, how_many
from tests.oracle.test_plain import LARGE, Game
from tests.support.generated import generate

GAMES = how_many(15)

HEAD = """
system Hard
message M { int x  bool on }
topic t { state M }
function even(int n) : bool = "tests.oracle.functions:even"
function shy(int n) : bool = "tests.oracle.functions:shy"
"""

VARIABLES = "var x : int = 0  var y : int = 0  var z : int = 0  var f : double = 0.0"

STATES = """
state 1 START
state 2 BASIC a
state 3 BASIC b
state 4 END
"""


def region(ways: str) -> str:
    """A START 1, two activities 2 and 3, an END 4."""
    return f"{STATES}1 -> 2 :\n{ways}"


def both(*regions: str, ways: str = "") -> str:
    """A START 1, an AND 2 with these regions (2.1, 2.2, ...), an END 3."""
    inside = [f"state 2.{n} OR\n{_inside(f'2.{n}', text)}" for n, text in enumerate(regions, start=1)]
    return "\n".join(["state 1 START", "state 2 AND", *inside, "state 3 END", "1 -> 2 :", ways])


def _inside(label: str, text: str) -> str:
    """The lines of a text with a label before each of their own."""
    labels = re.compile(r"^(state )?(\d[.\d]*)( -> (\d[.\d]*))?", re.MULTILINE)
    return labels.sub(
        lambda m: f"{m[1] or ''}{label}.{m[2]}" + (f" -> {label}.{m[4]}" if m[4] else ""), text.strip()
    )


def chart(text: str) -> str:
    """The whole text, of states or of a formula; activities are called by the labels of their states."""
    if "liveness" in text:
        return f"{HEAD}srm R {{\n{VARIABLES}\n{text}\n}}\n"
    lines = [line.strip() for line in _inside("0", text).splitlines() if line.strip()]
    states = sorted((line for line in lines if line.startswith("state")), key=_place)
    states = [
        re.sub(r"^state (\S+) BASIC (\w+)", lambda m: f"{m[0]}{m[1].replace('.', '_')}", s) for s in states
    ]
    ways = [line for line in lines if not line.startswith("state")]
    return f"{HEAD}statechart R {{\n{VARIABLES}\nstate 0 OR\n" + "\n".join([*states, *ways]) + "\n}\n"


def _place(line: str) -> list[int]:
    return [int(part) for part in line.split()[1].split(".")]


IN_TURN = region("2 -> 3 : go\n3 -> 2 : go")

CHARTS = {
    "a later region reads what an earlier one writes": both(
        region("2 -> 3 : go / x = x + 1\n3 -> 2 : go"),
        region("2 -> 3 : go [x == 1]\n3 -> 2 : go [x == 2]"),
    ),
    "an earlier region reads what a later one writes": both(
        region("2 -> 3 : go [x == 1]\n3 -> 2 : go [x == 2] / x = 0"),
        region("2 -> 3 : go / x = x + 1\n3 -> 2 : go"),
    ),
    "two regions exchange values": both(
        region("2 -> 3 : go / x = y\n3 -> 2 : go / x = x + 1"),
        region("2 -> 3 : go / y = x\n3 -> 2 : go / y = y + 2"),
    ),
    "three regions write the same, of which the last counts": both(
        region("2 -> 3 : go / x = x + 1\n3 -> 2 : go / x = x + 1"),
        region("2 -> 3 : go [x > 0] / x = x * 2\n3 -> 2 : stop / x = 0"),
        region("2 -> 3 : stop / x = x - 1\n3 -> 2 : go [x < 3] / x = x + 5"),
    ),
    "a region reads what it has written in a round before": both(
        region("2 -> 3 : go / x = x + 1\n3 -> 2 : when [x == 2] / x = 0\n3 -> 4 : when [x == 3]"),
        region("2 -> 3 : when [x == 2] / y = y + 1\n3 -> 2 : when [x == 0]"),
    ),
    "eventless ways of regions enable each other in the next step": both(
        region("2 -> 3 : when [x == 0] / x = 1\n3 -> 2 : when [x == 3] / x = 0"),
        region("2 -> 3 : when [x == 1] / x = 2\n3 -> 2 : when [x == 0]"),
        region("2 -> 3 : when [x == 2] / x = 3\n3 -> 2 : when [x == 0]"),
    ),
    "functions read what others write": both(
        region("2 -> 3 : go / x = x + 1\n3 -> 2 : go / x = x + 1"),
        region("2 -> 3 : go [even(x)]\n3 -> 2 : go [shy(x)] / x = 0"),
        region("2 -> 3 : when [shy(x)] / y = y + 1\n3 -> 2 : when [even(x)]"),
    ),
    "a function raises before the write of another region": both(
        region("2 -> 3 : go [shy(y)] / x = x + 1\n3 -> 2 : go / x = x + 1"),
        region("2 -> 3 : go / y = y + 1\n3 -> 2 : go [even(x)] / shy(2); y = x; f = 6 / y"),
    ),
    "messages are compared with what others write": both(
        region("2 -> 3 : go / x = t.state.M.x\n3 -> 2 : go / x = 0"),
        region("2 -> 3 : go [t.state.M.x == x] / y = t.state.M.x\n3 -> 2 : when [!t.state.M.on || x == 0]"),
        region("2 -> 3 : stop [has(t.state.M) && x == t.state.M.x]\n3 -> 2 : when [t.state.M.x > x]"),
    ),
    "regions draw in turns": both(
        region("2 -> 3 : go / f = random()\n3 -> 2 : go / f = f + random()"),
        region("2 -> 3 : go [f < 0.6] / y = y + 1; f = random()\n3 -> 2 : stop"),
        region("2 -> 3 : when [f > 0.7]\n3 -> 2 : go / f = random()"),
    ),
    "what is inside reads what is outside of it": both(
        both(
            region("2 -> 3 : go [x == 0] / y = y + 1\n3 -> 2 : go / x = x + 1"),
            region("2 -> 3 : go [y == 1] / z = x\n3 -> 2 : go [x > 0] / y = 0"),
            ways="2 -> 2 : stop [x == 1] / x = 5\n2 -> 3 : quit",
        ),
        region("2 -> 3 : go [z == 0] / x = x + 1\n3 -> 2 : stop / z = y"),
    ),
    "an AND that is entered again reads what the step before has written": both(
        both(
            region("2 -> 3 : go / x = x + 1\n3 -> 4 : go [x > 1]"),
            region("2 -> 3 : go [x == 1] / y = y + 1\n3 -> 4 : stop / x = 0"),
            ways="2 -> 2 : / y = x\n2 -> 3 : quit / x = 9",
        ),
        region("2 -> 3 : when [y > 0] / y = 0\n3 -> 2 : when [x == 0]"),
    ),
    "what an exit writes is read by a region that is left as well": """
        liveness { R = E . both
                   both = ((A . B)~ || (C . D)~ || F~)+ }
        control both {
          enter B : go
          leave B : go
          enter D : go [x == 1]
          leave D : go [y == 1]
          repeat F : stop [x > 2]
          exit A : / x = x + 1
          exit B : / y = x
          exit D : / x = x + 2; z = y
          exit (A . B)~ : / y = z
          repeat ((A . B)~ || (C . D)~ || F~) : quit [x != y] / z = z + 1
          on (C . D)~ : stop [x == 1] / y = 2
          on B : stop [y == 2] / x = 0
        }
        control R { exit both : / z = x; x = 0 }""",
    "an event is spent region by region": both(
        both(
            IN_TURN,
            region("2 -> 3 : stop\n3 -> 4 : go"),
            ways="2 -> 3 : go [x > 0]\n2 -> 2 : stop / x = x + 1",
        ),
        region("2 -> 3 : go / x = x + 1\n3 -> 2 : stop / x = 0"),
        ways="2 -> 2 : go [x > 1]\n2 -> 2 : stop [x == 0] / x = 1",
    ),
    "the event of a step is there in its later rounds": both(
        region("2 -> 3 : when [x == 1]\n3 -> 2 : go / x = 2"),
        region("2 -> 3 : after(10ms)\n3 -> 2 : go or stop"),
        ways="2 -> 2 : go [x == 2] / x = 0",
    ),
    "a state that is entered without an event waits for the one of this step": region(
        "2 -> 3 : when [x == 1] / x = 0\n3 -> 2 : go / x = x + 1\n2 -> 4 : quit"
    ),
    "one that is entered by an event waits for the same": region(
        "2 -> 3 : go\n3 -> 2 : go / x = x + 1\n3 -> 4 : [x > 3]"
    ),
    "completion of ANDs in ANDs": both(
        both(
            region("2 -> 4 : go\n2 -> 3 : stop\n3 -> 4 :"),
            region("2 -> 4 :\n2 -> 3 : go\n3 -> 4 : when [x == 1]"),
            ways="2 -> 3 : / x = x + 1",
        ),
        both(
            region("2 -> 3 : go\n3 -> 4 : go"),
            region("2 -> 4 : when [x == 1] / x = 0"),
            ways="2 -> 3 : [x == 0]\n2 -> 2 : after(20ms) / y = y + 1",
        ),
        ways="2 -> 2 : [y < 2]\n2 -> 3 :",
    ),
    "an AND is complete as it is entered": both(
        "state 1 START\nstate 2 BASIC a\nstate 3 END\n1 -> 3 : [x == 0]\n1 -> 2 : else\n2 -> 3 : go / x = 0",
        "state 1 START\nstate 2 BASIC a\nstate 3 END\n1 -> 3 :\n",
        ways="2 -> 2 : [y < 3] / y = y + 1; x = y\n2 -> 3 : [y == 3]",
    ),
    "regions ask where others stand": both(
        region("2 -> 3 : go [in(a0_2_2_2)] / x = x + 1\n3 -> 2 : when [done(a0_2_2_2) || x > 2]"),
        region("2 -> 3 : go [in(b0_2_1_3)]\n3 -> 2 : when [count(b0_2_1_3) > 2 && in(a0_2_1_2)]"),
    ),
    "several times on one state, and around it": both(
        region(
            "2 -> 3 : after(5ms) or stop [x == 0]\n2 -> 3 : after(20ms)\n"
            "3 -> 2 : after(10ms) / x = 1\n3 -> 4 : after(5ms) [x == 1]"
        ),
        region("2 -> 3 : after(10ms) / x = 0\n3 -> 3 : after(5ms) / y = y + 1\n3 -> 2 : after(20ms) or go"),
        ways="2 -> 2 : after(20ms) [y > 3] / y = 0\n2 -> 3 : after(100ms)",
    ),
    "no time at all": region(
        "2 -> 3 : after(0s) [x == 1] / x = 2\n3 -> 2 : after(0s) [x == 2] / x = 3\n"
        "3 -> 2 : go / x = 0\n2 -> 3 : stop / x = 1"
    ),
    "time and an event at once": both(
        region("2 -> 3 : go or after(10ms) / x = x + 1\n3 -> 2 : after(10ms) or go or when [x == 2]"),
        region("2 -> 3 : go [x == 0]\n3 -> 2 : stop or after(5ms)"),
        ways="2 -> 2 : go or after(20ms) / x = 0",
    ),
    "timers of regions": both(
        region("2 -> 3 : go / start_timer(pace, 10ms); x = 1\n3 -> 2 : when [expired(pace)] / x = 0"),
        region("2 -> 3 : when [x == 1] / start_timer(pace, 5ms)\n3 -> 2 : when [expired(pace) && x == 0]"),
        ways="2 -> 2 : stop / start_timer(pace, 20ms)\n2 -> 3 : when [expired(pace)]",
    ),
    "failures inside and outside": both(
        region("2 -> 3 : error / x = x + 1\n3 -> 2 : go"),
        both(
            region("2 -> 3 : error [x == 1]\n3 -> 2 : when [x == 2]"),
            IN_TURN,
            ways="2 -> 2 : error / x = 2",
        ),
        ways="2 -> 2 : error [x > 1] / x = 0",
    ),
    "choices look at what the way to them has written": both(
        region(
            "state 5 CONDITION\n2 -> 5 : go / x = x + 1\n3 -> 5 : stop\n"
            "5 -> 3 : [x > 1] / x = 0\n5 -> 2 : else / y = x"
        ),
        region(
            "state 5 CONDITION\n2 -> 5 : go [x == 1]\n3 -> 2 : when [x == 0]\n"
            "5 -> 3 : [y == 1]\n5 -> 4 : else"
        ),
    ),
    "a chart that does not always settle": both(
        region("2 -> 3 : when [x == 1]\n3 -> 2 : stop or when [x == 1 && y == 1]"),
        region("2 -> 3 : go / x = 1 - x\n3 -> 2 : stop / x = 1 - x; y = x"),
    ),
    "many conditions in a row": region(
        "\n".join(f"2 -> 3 : when [x == {n} && y > {n}] / y = {n}" for n in range(1, 10))
        + "\n3 -> 2 : when [x > 2] / x = x - 1\n3 -> 2 : go"
    ),
    "many conditions on what another region writes": both(
        region("2 -> 3 : go / x = x + 1\n3 -> 2 : stop"),
        region("\n".join(f"2 -> 3 : when [x == {n}] / z = {n}" for n in range(1, 10)) + "\n3 -> 2 : stop"),
    ),
    "many conditions beside a region that writes what they read": both(
        region("2 -> 3 : go / x = x + 1\n3 -> 2 : go / y = y + 1; x = 0"),
        region(
            "\n".join(f"2 -> 3 : when [x == {n} && y == {n % 3}] / z = {n}" for n in range(1, 10))
            + "\n3 -> 2 : when [y > 1] / y = 0"
        ),
    ),
}


@pytest.fixture(params=["as usual", "as large ones"])
def made_for(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(plain, "ROUNDS", ROUNDS)
    monkeypatch.setattr(interpreter, "ROUNDS", ROUNDS)
    for name, value in LARGE.items() if request.param == "as large ones" else ():
        monkeypatch.setattr(sizes, name, value)


@pytest.mark.usefixtures("made_for")
@pytest.mark.parametrize("name", CHARTS)
def test_the_plain_face_agrees_with_the_interpreter(name: str) -> None:
    text = chart(CHARTS[name])
    made = generate(text)
    try:
        for seed in range(GAMES):
            Game(made, text).play(Choices(f"{name} {seed}"))
    finally:
        forget(made)
