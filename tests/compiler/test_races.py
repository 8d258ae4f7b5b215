"""W575: two participants that may each send while the other does, and then wait past each other."""

from __future__ import annotations

from pathlib import Path

import pytest

from aseme_dsl.compiler import analyse
from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.source import Source

MEET = """system Hall
message Ask   { int n }
message Reply { int n }
aip meet {
  participant left {
    sends    request Ask, agree Reply
    receives query_ref Ask, inform Reply
    process  = Come . (Wait | Serve)
  }
  participant right {
    sends    query_ref Ask, inform Reply
    receives request Ask, agree Reply
    process  = Come . (Wait | Serve)
  }
  control left {
    enter Wait  : after(1s) / send request Ask { n = 1 } to right
    enter Serve : query_ref Ask from right / send agree Reply { n = 1 } to right
    leave Wait  : inform Reply from right
  }
  control right {
    enter Wait  : after(1s) / send query_ref Ask { n = 1 } to left
    enter Serve : request Ask from left / send inform Reply { n = 1 } to left
    leave Wait  : agree Reply from left
  }
}
srm l { plays meet.left   liveness { l = left }  activities { Come takes 1s } }
srm r { plays meet.right  liveness { r = right } }
team Hall { ann : l  bob : r }
"""


def races(text: str) -> list[Diagnostic]:
    found = analyse(Source("/nowhere/team.aseme", text)).diagnostics
    assert [item.message for item in found if item.code.startswith("E")] == []
    return [item for item in found if item.code == "W575"]


def changed(*changes: tuple[str, str]) -> str:
    text = MEET
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    return text


def test_both_may_send_first() -> None:
    (race,) = races(MEET)
    assert race.message == (
        "`left` may send `request Ask` while `right` sends `query_ref Ask`, and neither can receive the "
        "other's message then"
    )
    assert race.span is not None and race.span.text == "send request Ask { n = 1 } to right"
    assert [item.span.text for item in race.related] == ["send query_ref Ask { n = 1 } to left"]


@pytest.mark.parametrize(
    "changes",
    [
        [  # both orders are handled
            (
                "leave Wait  : inform Reply from right",
                "leave Wait : inform Reply from right or query_ref Ask from right",
            ),
            (
                "leave Wait  : agree Reply from left",
                "leave Wait : agree Reply from left or request Ask from left",
            ),
        ],
        [  # one handles both: it gives way
            (
                "leave Wait  : inform Reply from right",
                "leave Wait : inform Reply from right or query_ref Ask from right",
            ),
        ],
        [("enter Wait  : after(1s) / send query_ref Ask { n = 1 } to left", "enter Wait : after(1s)")],
    ],
)
def test_quiet_where_both_orders_are_handled_or_one_waits(changes: list[tuple[str, str]]) -> None:
    assert races(changed(*changes)) == []


def test_deadlines_do_not_help_if_both_open() -> None:
    assert races(changed(("inform Reply from right\n", "inform Reply from right or after(1s)\n")))


LATER = (
    (
        "process  = Come . (Wait | Serve)\n  }\n  participant right",
        "process  = Hail . (Wait | Serve)\n  }\n  participant right",
    ),
    (
        "    enter Wait  : after(1s) / send request",
        "    enter Hail  : / send propose Ask { n = 0 } to right\n    enter Wait  : after(1s) / send request",
    ),
    ("sends    request Ask, agree", "sends    propose Ask, request Ask, agree"),
    ("receives request Ask, agree", "receives propose Ask, request Ask, agree"),
    ("  control right {", "  control right {\n    enter Come : propose Ask from left"),
    ("activities { Come takes 1s }", "activities { Hail takes 1s }"),
)


def test_in_the_middle_of_a_conversation() -> None:
    (race,) = races(changed(*LATER))
    assert "`request Ask` while `right` sends `query_ref Ask`" in race.message


def test_in_the_middle_a_deadline_ends_the_waits() -> None:
    assert not races(
        changed(
            *LATER,
            ("inform Reply from right\n", "inform Reply from right or after(1s)\n"),
            ("agree Reply from left\n", "agree Reply from left or after(1s)\n"),
        )
    )


def test_what_activities_send_races_too() -> None:
    text = changed(
        ("sends    query_ref Ask,", "sends    query_ref Ask by Wait,"),
        ("enter Wait  : after(1s) / send query_ref Ask { n = 1 } to left", "enter Wait : after(1s)"),
    )
    (race,) = races(text)
    assert [item.span.text for item in race.related] == ["query_ref Ask"]


@pytest.mark.parametrize(
    "protocol", "request query contract_net iterated_contract_net subscribe propose".split()
)
def test_the_library_is_quiet(protocol: str) -> None:
    library = Path(__file__).parents[2] / "stdlib" / "protocols.aseme"
    text = library.read_text("utf-8")
    assert f"aip {protocol} {{" in text
    assert races(f"system S\n{text}") == []
