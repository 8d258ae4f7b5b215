"""`asemec prove`: a message that waits for ever is not taken, whatever its receiver does in the meantime."""

from __future__ import annotations

import pytest

from aseme_dsl.project.building.project import compile_root
from aseme_dsl.source import Source
from tests.cli.test_prove import BUY, verdicts

TURNED = BUY.replace("Look . Close", "Close . Look")
EXCHANGED = BUY.replace("enter Look  : request", "enter Close : request").replace(
    "enter Close : [there] /", "enter Look : [there] /"
)
"""The seller waits for something else, and the order with it."""

RADIO = """\
system Radio
message Song { int n }
aip show {
  participant studio {
    sends   inform Song, request Song
    process = Talk . Play . Rest~
  }
  participant listener {
    receives inform Song, request Song
    process  = Hear . Dance~
  }
  control studio {
    enter Play : / send inform Song { n = 1 } to listener
    enter Rest : / send request Song { n = 2 } to listener
  }
  control listener {
    enter Hear : inform Song from studio
    on    Dance : request Song s from studio [s.n == 2]
  }
}
"""
"""Both go on for ever; with another number, the listener never takes the second song."""
DEAF = RADIO.replace("s.n == 2", "s.n == 3")

ON_AIR = (
    DEAF
    + """\
srm caster { plays show.studio liveness { caster = studio } }
srm fan    { plays show.listener liveness { fan = listener } }
team Town { caster : caster  fan : fan }
property "all is heard" { never untaken Song by fan }
"""
)

PAST = """\
system Hall
message Ask { int n }
aip meet {
  participant left {
    var goes : bool = false
    sends    request Ask
    receives query_ref Ask
    process  = Come . (Go~ | Serve~)
  }
  participant right {
    var goes : bool = false
    sends    query_ref Ask
    receives request Ask
    process  = Come . (Go~ | Serve~)
  }
  control left {
    enter Go    : [goes] / send request Ask { n = 1 } to right
    enter Serve : else
    on    Serve : query_ref Ask from right
  }
  control right {
    enter Go    : [goes] / send query_ref Ask { n = 1 } to left
    enter Serve : else
    on    Serve : request Ask from left
  }
}
"""
"""Two that may both choose to go, and then go on for ever."""


@pytest.mark.parametrize("text", [TURNED, EXCHANGED])
def test_a_message_for_an_agent_that_waits_for_something_else_is_an_orphan(prove, text: str) -> None:  # type: ignore[no-untyped-def]
    done = prove(text, "orphan messages", "--json")
    (item,) = done.json["results"]
    assert (done.code, item["verdict"]) == (1, "REFUTED")
    assert "never takes" in item["reason"]


def test_a_message_that_waits_for_ever_is_an_orphan_though_no_agent_waits(prove) -> None:  # type: ignore[no-untyped-def]
    found = verdicts(prove(DEAF, "--json"))
    assert (found["deadlock"], found["orphan messages"]) == ("PROVED", "REFUTED")
    found = verdicts(prove(RADIO, "--json"))
    assert (found["deadlock"], found["orphan messages"]) == ("PROVED", "PROVED")


@pytest.mark.long
def test_a_property_about_messages_that_nothing_takes_asks_for_those_that_wait_for_ever(prove) -> None:  # type: ignore[no-untyped-def]
    assert verdicts(prove(ON_AIR, "all is heard", "--json")) == {"all is heard": "REFUTED"}
    text = ON_AIR.replace("s.n == 3", "s.n == 2")
    assert verdicts(prove(text, "all is heard", "--json")) == {"all is heard": "PROVED"}


@pytest.mark.long
def test_two_that_send_past_each_other_and_go_on_are_a_non_local_choice(prove) -> None:  # type: ignore[no-untyped-def]
    found = verdicts(prove(PAST, "--json"))
    assert (found["deadlock"], found["non-local choice"]) == ("PROVED", "REFUTED")


def test_what_an_agent_does_not_do_is_read_whatever_its_name_is() -> None:
    """`desk` is nearly the verb `does`; a counterexample says where it waits with `not desk in …`."""
    text = (
        "system Shop\nsrm clerk { liveness { clerk = Wait~ } activities { Wait takes 1s simulated } }\n"
        'scenario "s" { desk : clerk at 2s not desk in Wait for 3s }\n'
    )
    assert [str(item.message) for item in compile_root(Source("shop.aseme", text)).diagnostics] == []
