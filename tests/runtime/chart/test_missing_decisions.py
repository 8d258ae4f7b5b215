"""Participants that agree to nothing because nobody has written their activities: told once for a role."""

from __future__ import annotations

from typing import Any

import pytest

from aseme_dsl.runtime import Context
from tests.runtime.playing import play

LIBRARY = """
system S
import protocols
srm boss {
  plays contract_net.manager
  liveness { boss = manager }
  activities { AnnounceJob takes 1s  CollectProposals takes 5s  AwardContract takes 1s
               AwaitOutcome takes 1min  LearnOutcome takes 1s }
}
srm cook {
  plays contract_net.contractor
  liveness { cook = contractor~[2] }
  activities { EvaluateJob takes 1s  MakeProposal takes 1s  CarryOut takes 1s  ReportOutcome takes 1s
               DeclineJob takes 1s  StopWork takes 1s  CloseJob takes 1s }
}
team T { ann : boss  bob, cid : cook }
"""
OWN = """
system S
message Job { string id }
aip ask {
  participant one { sends request Job  receives agree Job, refuse Job  process = Ask . Wait }
  participant two {
    VARIABLE
    sends agree Job, refuse Job
    receives request Job
    process = Think . (Do | Leave)
  }
  control one {
    enter Ask  : / send request Job to two
    leave Wait : agree Job from two or refuse Job from two
  }
  control two {
    enter Think : request Job from one LINE
    enter Do    : CONDITION / send agree Job to one
    enter Leave : else / send refuse Job to one
  }
}
srm first { plays ask.one  liveness { first = one }  activities { Ask takes 1s  Wait takes 1min } }
srm second {
  plays ask.two
  liveness { second = two }
  activities { Think takes 1s  Do takes 1s  Leave takes 1s }
}
team T { ann : first  bob : second }
"""


class Something:
    def execute(self, context: Context) -> None:
        context.log("here")


def told(text: str, activities: dict[str, type[Any]] | None = None) -> list[tuple[str, str]]:
    return [(fault["agent"], fault["reason"]) for fault in play(text, activities or {}).of("fault")]


def test_a_participant_of_the_library_that_nobody_has_written_is_told_once_for_its_role() -> None:
    assert told(LIBRARY) == [
        (
            "bob",
            "cook plays contract_net.contractor without code, so able and succeeded stay false: EvaluateJob,"
            " MakeProposal, CarryOut, ReportOutcome, DeclineJob, StopWork or CloseJob would decide that",
        )
    ]


@pytest.mark.parametrize("activity", ["EvaluateJob", "CarryOut"])
def test_what_has_code_decides_for_itself(activity: str) -> None:
    assert told(LIBRARY, {activity: Something}) == []


@pytest.mark.parametrize(
    ("variable", "line", "condition", "stays"),
    [
        ("var able : bool = false", "", "[able]", "able stays"),
        ("var able : bool = false  var free : bool = false", "", "[able && !free]", "able and free stay"),
        ("var able : bool = false", "/ able = true", "[able]", ""),  # a line sets it
        ("var able : bool = true", "", "[able]", ""),  # it says yes as it is
        ("var able : bool = false", "", "[able || random.state.Job.id == \"1\"]", ""),
        ("var who : agent", "", "[has(who)]", ""),
        ("var over : bool = false", "enter Leave : when [over]", "[!over]", ""),  # what a line waits for
        ("var n : int = 0", "", "[n > 1]", ""),
    ],
)  # fmt: skip
def test_what_only_activities_can_set(variable: str, line: str, condition: str, stays: str) -> None:
    text = OWN.replace("VARIABLE", variable).replace("LINE", line).replace("CONDITION", condition)
    text = text.replace("message Job", "topic random { state Job }\nmessage Job", 1)
    reasons = [reason for _, reason in told(text)]
    expected = f"second plays ask.two without code, so {stays} false: Think, Do or Leave would decide that"
    assert reasons == ([expected] if stays else [])
