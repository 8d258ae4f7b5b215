"""The content of a `send`: complete, at its defaults (`..`), or taken from a received message (`..m`)."""

from __future__ import annotations

import pytest

from aseme_dsl.compiler import analyse
from aseme_dsl.source import Source

TEXT = """system S
message Place { int x  int y }
message Job { string id  Place at  optional string note }
message Bid { string id  double cost  optional string note }
message Tag { string id }
aip p {
  participant a {
    sends    cfp Job, inform Job
    receives propose Bid, refuse Tag
    process  = A . B
  }
  participant b { sends propose Bid, refuse Tag  receives cfp Job, inform Job  process = X . Y }
  control a {
    enter A : / send cfp Job CONTENT to b
    enter B : propose Bid m from b / LATER
    enter B : refuse Tag m from b / send inform Job { at.x = 1, at.y = 2, ..m } to b
  }
  control b {
    enter X : cfp Job j from a / send propose Bid { cost = 3, ..j } to a
    enter Y : inform Job from a
    enter Y : after(1s) / send refuse Tag { .. } to a
  }
}
srm r { plays p.a  liveness { r = a } }
srm q { plays p.b  liveness { q = b } }
"""
NO_PLACE = "E578 `m` is a `Bid`, which does not give `at` of `Job`"
LATER = "send inform Job { at.x = 1, at.y = 2, id = m.id } to b"


CODES = ("E577", "E578", "E579", "N760", "E500", "E501")


def told(content: str, later: str = LATER) -> list[str]:
    text = TEXT.replace("CONTENT", content).replace("LATER", later)
    found = analyse(Source("t.aseme", text)).diagnostics
    return [
        f"{d.code} {d.message}" for d in found if d.code in ("E577", "E578", "E579", "N760", "E500", "E501")
    ]


@pytest.mark.parametrize(
    ("content", "said"),
    [
        ('{ id = "1", at.x = 1, at.y = 2 }', []),  # what is optional may be left out
        ('{ id = "1", .. }', []),
        ("{ .. }", []),
        ("{ }", ["E577 the content of `Job` leaves out `id` and `at`"]),
        ('{ id = "1", at.y = 1 }', ["E577 the content of `Job` leaves out `at.x`"]),
        ('{ at.x = 1, at.y = 2, id = "1", .. }', []),  # `note` is left
        ('{ id = "1", .. } reply_by 0s', ["E579 the deadline of the answer is not greater than zero"]),
        ('{ id = "1", .. } reply_by 3', ["E500 a duration is wanted here, not an int"]),
        ('{ id = "1", .. } reply_by 3s', []),
    ],
)
def test_content(content: str, said: list[str]) -> None:
    found = told(content)
    assert len(found) == len(said), found
    assert all(one.startswith(other) for one, other in zip(found, said, strict=True)), found


@pytest.mark.parametrize(
    ("later", "said"),
    [
        ("send inform Job { ..m } to b", [NO_PLACE]),
        (
            "send inform Job { at.x = 1, ..m } to b",
            [NO_PLACE],
        ),
        ("send inform Job { at.x = 1, at.y = 2, ..m } to b", []),
        ("send inform Job { at.x = 1, at.y = 2, ..m.id } to b", ["E578 `m.id` is not a message"]),
    ],
)
def test_what_is_taken_of_a_message(later: str, said: list[str]) -> None:
    assert told("{ .. }", later) == said


def test_all_filled() -> None:
    filled = TEXT.replace("send refuse Tag { .. }", 'send refuse Tag { id = "1", .. }')
    text = filled.replace("CONTENT", "{ .. }").replace("LATER", LATER)
    assert [d.code for d in analyse(Source("t.aseme", text)).diagnostics if d.code == "N760"] == ["N760"]


@pytest.mark.parametrize("content", ["{ }", "{}", '{ id = "1" }', '{ id = "1", }', "{ at.x = 1\n  }"])
def test_the_fix_keeps_the_meaning(content: str) -> None:
    text = TEXT.replace("CONTENT", content).replace("LATER", LATER)
    (found,) = [d for d in analyse(Source("t.aseme", text)).diagnostics if d.code == "E577"]
    for edit in found.changes:
        text = text[: edit.span.start] + edit.text + text[edit.span.end :]
    assert [d for d in analyse(Source("t.aseme", text)).diagnostics if d.code.startswith("E")] == []
