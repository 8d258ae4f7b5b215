"""Names that look alike are told apart by all that is generated."""

from __future__ import annotations

from pathlib import Path

from aseme_dsl.codegen.plain.options import PlainOptions
from aseme_dsl.runtime.chart.inputs import Happened
from tests.support import batches
from tests.support.generated import generate, system_of
from tests.support.plain_engine import plain_class

ALIKE = """
system S
enum A { X B_C }
enum A_B { C D }
message A_X { int n }
topic t { state A_X }
srm R {
  var a : A = A.X
  var b : A_B = A_B.D
  liveness { R = P . Q . Z }
  control R {
    enter Q : go [a != A.B_C && (!has(t.state.A_X) || t.state.A_X.n == 0)] / a = A.B_C; b = A_B.C
    enter Z : go [a == A.B_C && b == A_B.C]
  }
}
team T { robot : R }
"""


def test_constants_of_enums_whose_names_look_alike_are_told_apart(tmp_path: Path) -> None:
    made = generate(ALIKE)
    agent = made.chart("R")
    agent.settle()
    agent.step(0, [])
    for _ in range(2):
        agent.step(0, [Happened("go")])
    assert (agent.variable("a").name, agent.variable("b").name) == ("B_C", "C")
    for watched in (False, True):
        chart = plain_class(made, "R", PlainOptions(watched=watched))()
        chart.start()
        assert (chart.send("go"), chart.bb.a.name, chart.bb.b.name) == (True, "B_C", "C")
        assert (chart.send("go"), chart.names()) == (True, ("Z",))
    numbers = ALIKE.replace(" && (!has(t.state.A_X) || t.state.A_X.n == 0)", "")
    _, kind = batches.made(system_of(numbers), tmp_path, "R")
    batch = kind(2, "numpy")
    batch.start()
    assert batch.send("go").all()
    assert (batch.bb.a.tolist(), batch.bb.b.tolist()) == ([1, 1], [0, 0])
    assert batch.send("go").all()
