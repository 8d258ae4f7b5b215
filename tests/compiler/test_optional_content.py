"""N720 for optional members of a taken message in the content of a message that is sent."""

from __future__ import annotations

import pytest

from aseme_dsl.compiler import analyse
from aseme_dsl.source import Source

TEXT = """system Shop
message Job { string id  optional int limit }
message Answer { int price  string id }
aip work {
  participant client {
    sends    request Job
    receives agree Answer
    process  = Ask
  }
  participant worker {
    sends    agree Answer
    receives request Job
    process  = Look
  }
  control client {
    enter Ask : / send request Job { id = "1", .. } to worker
    leave Ask : agree Answer from worker
  }
  control worker { enter Look : LINE }
}
srm a { plays work.client  liveness { a = client }  activities { Ask waits } }
srm b { plays work.worker  liveness { b = worker }  activities { Look takes 1s } }
team Shop { ann : a  bob : b }
"""


@pytest.mark.parametrize(
    ("condition", "price", "found"),
    [
        ("", "j.limit", ["j.limit"]),
        ("", "2 * j.limit + 1", ["2 * j.limit + 1"]),
        ("[has(j.limit)]", "j.limit", []),
        ("[j.limit > 3]", "j.limit", []),
        ("[!(j.limit > 3)]", "j.limit", []),
        ("[!has(j.limit)]", "j.limit", ["j.limit"]),
        ('[j.id == "1" || has(j.limit)]', "j.limit", ["j.limit"]),
        ("", "has(j.limit) ? 1 : 2", []),
        ("", "3", []),
    ],
)
def test_an_optional_member_in_what_is_sent(condition: str, price: str, found: list[str]) -> None:
    content = f"{{ price = {price}, id = j.id }}"
    line = f"request Job j from client {condition} / send agree Answer {content} to client"
    items = analyse(Source("shop.aseme", TEXT.replace("LINE", line))).diagnostics
    assert [item.code for item in items if item.code[0] == "E"] == []
    assert [item.span.text for item in items if item.code == "N720" and item.span is not None] == found
