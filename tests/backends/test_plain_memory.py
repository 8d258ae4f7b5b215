"""What an instance of a plain class takes: 100 bytes and 8 a region at most, its blackboard not counted.

One that is watched keeps which activities have failed, too; one whose regions wake each other, that they did.
"""

from __future__ import annotations

import gc
import sys
import tracemalloc

import pytest

from aseme_dsl.codegen.plain.options import PlainOptions
from tests.support.generated import generate
from tests.support.lanes import kept
from tests.support.plain_engine import plain_class

INSTANCES = 200
FRAMES = 20
"""How many calls deep what takes memory is known by who called it."""
FIXED = 100
A_REGION = 8
WATCHED = 8
WOKEN = 8

TWO = """
system S
srm R { liveness { R = (A . B)~ } control R { enter B : go  leave B : go } }
"""

REGIONS = """
system S
function even(int n) : bool = "tests.oracle.functions:even"
message M {{ int x }}
topic t {{ state M }}
srm R {{
  var n : int = 0
  var m : int = 0
  var c : double = 0.0
  liveness {{ R = w || x || y || z  w = (A . B)~  x = (C . D)~  y = (E . F)~  z = (G . H)~ }}
{controls}
  {activities}
}}
"""


def regions(*controls: str, activities: str = "") -> str:
    return REGIONS.format(
        controls="\n".join(
            f"  control {name} {{ {text} }}" for name, text in zip("wxyz", controls, strict=False)
        ),
        activities=activities,
    )


MANY_TIMED = "system S srm R {{ liveness {{ R = ({})~ }} control R {{ {} }} }}".format(
    " . ".join(f"S{n}" for n in range(40)), " ".join(f"enter S{n} : after({n + 1}s)" for n in range(40))
)

CHARTS = {
    "two states": TWO,
    "four regions": regions("enter B : go", "enter D : go", "enter F : go", "enter H : go"),
    "a function and a timer": regions(
        "enter B : go [even(n)] / start_timer(t, 5s)  leave B : when [expired(t)]", "enter D : go"
    ),
    "a condition that may fail": regions("enter B : go [even(n)]", "enter D : go [t.state.M.x > 3]"),
    "chance that is not drawn": regions("enter B : never / c = random()"),
    "variables over regions, and time": regions(
        "enter B : go / n = n + 1; m = m + 2  leave B : after(3s)",
        "enter D : go [n > 3] / n = n + m",
        "enter F : go [m > 3] / m = 0",
        "enter H : stop [n + m > 5]",
    ),
    "activities that fail": regions("leave B : error  enter B : go", "leave D : error  enter D : go"),
    "how activities end": regions(
        "enter B : go [outcome(A) == held]",
        "enter D : [outcome(C) == held]",
        activities="activities { A ends held, slipped  C ends held, slipped }",
    ),
    "rounds in a step": regions("enter B : go || on  leave B : go", "enter D : when [n > 3]"),
    "a state is counted": regions("enter B : go [count(A) > 2]"),
    "forty states that wait for time": MANY_TIMED,
}


@pytest.mark.parametrize("name", CHARTS)
@pytest.mark.parametrize("watched", kept([False, True], lambda watched: not watched), ids=["bare", "watched"])
def test_an_instance_is_small(name: str, watched: bool) -> None:
    kind = plain_class(generate(CHARTS[name]), "R", PlainOptions(watched=watched))
    board = vars(sys.modules[kind.__module__])["RBlackboard"]
    limit = FIXED + A_REGION * len(kind.LEAVES) + WATCHED * watched
    limit += WOKEN * ("woken" in kind.__slots__)
    assert _bytes(kind, board) <= limit


def _bytes(kind: type, board: type) -> int:
    """What an instance takes, that has been started and given an event."""
    boards = [board() for _ in range(INSTANCES)]
    charts = [kind(board())] * INSTANCES
    _run(charts[0])  # what is made once
    gc.collect()
    tracemalloc.start(FRAMES)
    try:
        for place, each in enumerate(boards):
            charts[place] = kind(each)
            _run(charts[place])
        kept = tracemalloc.take_snapshot()
    finally:
        tracemalloc.stop()
    # What other threads have got meanwhile is not ours.
    ours = tracemalloc.Filter(True, _bytes.__code__.co_filename, all_frames=True)
    return sum(trace.size for trace in kept.filter_traces([ours]).traces) // INSTANCES


def _run(chart: object) -> None:
    chart.start()  # type: ignore[attr-defined]
    chart.send("go")  # type: ignore[attr-defined]
    chart.send("go")  # type: ignore[attr-defined]
