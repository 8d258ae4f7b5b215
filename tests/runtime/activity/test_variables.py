"""What activities write to variables: bounds hold, and a list is copied."""

from __future__ import annotations

import pytest

from aseme_dsl.runtime import Context
from aseme_dsl.runtime.chart.bounds import OutOfBounds
from tests.runtime.playing import SECOND, play

TEXT = """
system S
srm R {
  var n : int 0..3
  var xs : list[2] of int
  liveness { R = A . B }
  activities { A takes 1ms  reads xs writes n, xs  B takes 1ms }
  control R { enter B : [n < 9 && size(xs) < 9] }
}
"""


def test_a_list_that_the_activity_changes_afterwards_stays_as_it_was_written() -> None:
    class A:
        def execute(self, context: Context) -> None:
            items = [1]
            context.set_variable("xs", items)
            items.append(2)

    played = play(TEXT, {"A": A}, until=SECOND)
    assert played.team.agent("me").chart.variable("xs") == (1,)


def test_what_a_variable_cannot_hold_raises_in_the_activity() -> None:
    said: list[str] = []

    class A:
        def execute(self, context: Context) -> None:
            for name, value in (("n", 4), ("xs", [1, 2, 3])):
                with pytest.raises(OutOfBounds) as refused:
                    context.set_variable(name, value)
                said.append(str(refused.value))
            with pytest.raises(TypeError):
                context.set_variable("xs", ["a"])

    played = play(TEXT, {"A": A}, until=SECOND)
    assert said == [
        "variable n of 0..3 cannot be 4",
        "list xs of at most 2 elements cannot have 3",
    ]
    assert played.team.agent("me").chart.variable("n") == 0
