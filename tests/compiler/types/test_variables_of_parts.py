"""E200: variables of a participant that an activity reads or writes where they are not there."""

from __future__ import annotations

import pytest

from tests.support.compiling import analysis

TEXT = """system Fetching
message Ask {{ int n }}
aip fetch {{
  participant asker {{ process = Begin . Thank }}
  participant bringer {{ var fits : bool = false  process = Hear . [Bring] }}
  control asker {{
    enter Begin : / send request Ask {{ n = 1 }} to bringer
    enter Thank : inform Ask from bringer or after(5s)
  }}
  control bringer {{
    enter Hear  : request Ask from asker
    enter Bring : [fits] / send inform Ask {{ n = 1 }} to asker
    skip Bring  : else
  }}
}}
srm wants {{ plays fetch.asker liveness {{ wants = asker }} }}
srm gives {{
  plays fetch.bringer
  {variables}
  liveness {{ gives = {formula} }}
  activities {{ {activities} }}
}}
team Both {{ ann : wants  bob : gives }}
"""


def found(activities: str, formula: str = "Look . bringer", variables: str = "") -> list[tuple[str, str]]:
    text = TEXT.format(activities=activities, formula=formula, variables=variables)
    return [
        (item.code, item.span.text)
        for item in analysis(text).diagnostics
        if item.span and item.code[0] == "E"
    ]


@pytest.mark.parametrize("word", ["reads", "writes"])
def test_a_variable_of_a_participant_is_there_inside_of_it_only(word: str) -> None:
    assert found(f"Look {word} fits") == [("E200", "fits")]
    assert found(f"Hear {word} fits") == []
    assert found(f"Look {word} fits", variables="var fits : bool = true") == []


def test_an_activity_may_stand_outside_too() -> None:
    assert found("Hear writes fits", "Hear . bringer") == []
