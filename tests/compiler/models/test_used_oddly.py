"""What is declared soundly and used by nothing, or where nobody expects it, gives diagnostics."""

from __future__ import annotations

import os

import pytest

from aseme_dsl.diagnostics import render_text
from tests.support.compiling import analysis, codes
from tests.support.oddities import odd_program

PROGRAMS = max(75, int(os.environ.get("MUTATIONS", "0")) // 20)

_PARAMETERS = """
system S
enum Place {{ BELT TABLE }}
srm robot {{
  liveness {{ {formulas} }}
  activities {{ MoveTo(goal : Place) }}
  control deliver {{ enter Open : [to != Place.BELT]  skip Open : else }}
}}
"""


@pytest.mark.parametrize(
    ("formulas", "expected"),
    [
        ("deliver(to) = MoveTo(to) . [Open]", ["E310"]),
        ("robot = deliver  deliver(to) = MoveTo(to) . [Open]", ["E523"]),
        ("robot = Wait  deliver(to) = MoveTo(to) . [Open]", ["E302"]),
        ("robot = deliver(1)  deliver(to) = MoveTo(to) . [Open]", ["E500"]),
        ("robot = deliver(Place.BELT, 2)  deliver(to) = MoveTo(to) . [Open]", ["E523"]),
        (
            "robot = first(Place.BELT)  first(to) = deliver  deliver(to) = MoveTo(to) . [Open]",
            ["E308", "E523"],
        ),
    ],
)
def test_a_parameter_without_a_value_is_said_where_it_is_missing(formulas: str, expected: list[str]) -> None:
    assert sorted(codes(_PARAMETERS.format(formulas=formulas))) == expected


def test_a_parameter_of_a_participants_formula_without_a_value() -> None:
    text = """
    system S
    enum Place { BELT TABLE }
    aip talk {
      participant one { process = waiting  waiting(to : Place) = Wait . [Open] }
      control waiting { enter Open : [to == Place.BELT]  skip Open : else }
    }
    srm robot { plays talk.one  liveness { robot = one } }
    """
    assert "E523" in codes(text)


def test_odd_uses_of_sound_declarations() -> None:
    for seed in range(PROGRAMS):
        render_text(analysis(odd_program(seed)).diagnostics)
