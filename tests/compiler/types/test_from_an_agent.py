"""`inform Task from best`: a message from one agent."""

from __future__ import annotations

import pytest

from aseme_dsl.compiler import analyse
from aseme_dsl.diagnostics.pages import page
from aseme_dsl.source import Source


def messages(old: str, new: str) -> list[tuple[str, str]]:
    text = page("E567").right.files[0].text
    assert old in text
    found = analyse(Source("/nowhere/team.aseme", text.replace(old, new))).diagnostics
    return [(item.code, item.message) for item in found if item.code.startswith("E")]


@pytest.mark.parametrize(
    ("new", "found"),
    [
        ("inform Task from best", []),
        ('inform Task t from best [t.id != ""]', []),
        ("inform Task from best or propose Task from best", []),
        ("inform Task from best or after(1s)", ["a message from one agent stands beside other events"]),
        ("inform Task from best or lost worker", ["a message from one agent stands beside other events"]),
        ("cfp Task from best", ["no other participant sends `cfp Task`, so `best` cannot"]),
    ],
)
def test_from_a_variable(new: str, found: list[str]) -> None:
    assert messages("inform Task from best", new) == [("E567", message) for message in found]


def test_the_answer_that_nobody_lists() -> None:
    """The runtime gives it for what was sent: it comes from who receives that."""
    text = page("E567").right.files[0].text.replace("inform Task from best", "not_understood Task from best")
    text = text.replace("receives propose Task,", "receives not_understood Task, propose Task,")
    found = analyse(Source("/nowhere/team.aseme", text)).diagnostics
    assert [item.code for item in found if item.code.startswith("E")] == []


def test_a_misspelt_agent() -> None:
    assert [code for code, _ in messages("inform Task from best", "inform Task from bets")] == ["E205"]


def test_a_variable_that_does_not_hold_an_agent() -> None:
    assert [code for code, _ in messages("var best : agent", 'var best : string = "x"')][:1] != []


def test_the_age_of_what_is_taken() -> None:
    assert messages("inform Task from best", "inform Task t from best [age(t) > 1s]") == []
    assert messages("inform Task from best", "inform Task from best [age(inform.Task) > 1s]") == []
    assert messages("inform Task from best", "inform Task t from best [age(t.id) > 1s]") == [
        ("E504", "`age` wants the whole message: `t`")
    ]
    assert messages("inform Task from best", "lost worker w [age(w) > 1s]") == [
        ("E504", "`age` wants a message, not an agent")
    ]


def test_what_is_missing_where_the_lines_say_what_is_sent() -> None:
    """Without `sends`, no list can be completed; and the line is no other mistake."""
    text = """system S
message Job { int id }
aip deal {
  participant boss { var best : agent  process = Ask . Wait }
  participant worker { process = Work . Rest }
  control boss {
    enter Ask  : / send cfp Job { id = 1 } to worker
    enter Wait : propose Job b from worker / best = sender(b)
    leave Wait : inform Job from best
  }
  control worker {
    enter Work : cfp Job from boss / send propose Job { id = 2 } to boss
  }
}
srm b { plays deal.boss as x  liveness { b = x }  activities { Ask takes 1s  Wait waits } }
srm w { plays deal.worker as x  liveness { w = x }  activities { Work takes 1s  Rest takes 1s } }
"""
    found = analyse(Source("/nowhere/team.aseme", text)).diagnostics
    said = [item for item in found if item.code in ("E567", "W402")]
    assert [item.code for item in said] == ["E567"]
    assert said[0].hint == "write the line that sends it: `/ send inform Job { .. } to …`"
