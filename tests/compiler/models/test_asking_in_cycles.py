"""A cycle that sends, or starts a timer, and then needs what comes of it waits for that (no W403)."""

from __future__ import annotations

import pytest

from tests.support.compiling import analysis, codes

ASKING = """
system S
message Call {{ int floor }}
aip dispatch {{
  participant desk {{
    var count : int
    sends cfp Call
    receives propose Call
    process = Collect+
  }}
  participant car [1..*] {{
    sends propose Call
    receives cfp Call
    process = Offer
  }}
  control desk {{
    enter Collect+ : / send cfp Call {{ floor = 1 }} to car; start_timer(limit, {limit})
    leave Collect : when [{condition}]
    {more}
    repeat Collect : propose Call from car
  }}
  control car {{ enter Offer : cfp Call from desk  leave Offer : / send propose Call {{ .. }} to desk }}
}}
srm dispatcher {{
  plays dispatch.desk
  var calls : int
  liveness {{ dispatcher = (Idle . desk)~ }}
  activities {{ Idle waits  Collect waits }}
  control dispatcher {{ enter desk : when [calls > 0] }}
}}
srm lift {{ plays dispatch.car  liveness {{ lift = car~ }} activities {{ Offer takes 1s }} }}
team House {{ d : dispatcher  l : lift }}
"""


def found(condition: str, more: str = "", limit: str = "1s") -> list[str]:
    text = ASKING.format(condition=condition, more=more, limit=limit)
    return [code for code in codes(text) if code.startswith(("E", "W403"))]


@pytest.mark.parametrize(
    "condition",
    [
        "all_answered(car)",
        "all_answered(car) && count > 0",
        "answered(car) > 2",
        "answered(car) >= invited(car)",
        "all_answered(car) || expired(limit)",
        "!(answered(car) == 0)",
    ],
)
def test_a_condition_on_answers_waits_behind_the_send(condition: str) -> None:
    assert found(condition) == []
    assert found(condition, f"leave Collect : when [{condition} && count < 9]") == []


@pytest.mark.parametrize(
    "condition",
    [
        "!all_answered(car)",
        "answered(car) < 3",
        "invited(car) > 0",
        "all_answered(car) || count == 0",
        "count == 0",
    ],
)
def test_a_condition_that_may_hold_at_once_does_not_wait(condition: str) -> None:
    assert found(condition) == ["W403"]
    assert found("all_answered(car)", f"leave Collect : when [{condition}]") == ["W403"]


def test_a_timer_of_no_time_does_not_wait() -> None:
    assert found("expired(limit)") == []
    assert found("expired(limit)", limit="0s") == ["W403"]


def test_an_answer_to_what_was_sent_before_the_cycle_is_there_already() -> None:
    assert found("answered(car) > 5", "repeat Collect : when [all_answered(car)]") == ["W403"]
    assert (
        found(
            "answered(car) > 5",
            "repeat Collect : when [all_answered(car)] / send cfp Call { floor = 2 } to car",
        )
        == []
    )


def test_the_line_that_does_not_wait_is_pointed_at() -> None:
    more = "leave Collect : when [count == 0]"
    text = ASKING.format(condition="all_answered(car)", more=more, limit="1s")
    [item] = [item for item in analysis(text).diagnostics if item.code == "W403"]
    assert [place.span.text for place in item.related] == [
        "enter desk : when [calls > 0]",
        "leave Collect : when [count == 0]",
    ]
