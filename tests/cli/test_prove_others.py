"""`asemec prove`: where a search is cut, each agent is explored among others that may do anything."""

from __future__ import annotations

import re

import pytest

GROUP = """\
system Market
message Offer { int euros }
aip sale {
  participant seller {
    var sold : bool
    process = Call . Hear . Close
  }
  participant buyer [1..*] {
    var keen : bool
    process = Listen . [Bid . [Pay]] . Leave
  }
  control seller {
    enter Hear  : / send cfp Offer { euros = 1 } to buyer
    on    Hear  : propose Offer o from buyer [!sold]
                  / sold = true; send agree Offer { euros = 2 } to sender(o)
    on    Hear  : propose Offer o from buyer / send refuse Offer { euros = 2 } to sender(o)
    enter Close : after(10s)
  }
  control buyer {
    enter Listen : cfp Offer from seller
    enter (Bid . [Pay]) : [keen] / send propose Offer { euros = 2 } to seller
    skip  (Bid . [Pay]) : else
    enter Pay    : agree Offer from seller
    skip  Pay    : refuse Offer from seller
    skip  Pay    : lost seller
    skip  Pay    : after(1min)
  }
}
"""
"""One seller calls several buyers: too many states for a short search."""
PATIENT = GROUP.replace("    skip  Pay    : after(1min)\n", "").replace(
    "    skip  Pay    : lost seller\n", ""
)
"""A buyer waits for an answer, whatever time passes."""
TEAM = (
    GROUP
    + """\
srm seller {
  plays sale.seller
  liveness { seller = sale.seller }
}
srm buyer {
  plays sale.buyer
  liveness { buyer = sale.buyer . Done . [Rest . Stay] }
  activities { Done Rest Stay }
  control buyer {
    enter (Rest . Stay) : [index > 1]
    skip  (Rest . Stay) : else
    enter Stay          : after(5s) [index < 2]
  }
}
team Market { a : seller  b[1..3] : buyer }
"""
)
"""All buyers but the first one wait for ever when they are done."""
BOUND = "; any delay; each agent among others that may do anything; "


def asked(prove, text: str, question: str):  # type: ignore[no-untyped-def]
    (found,) = prove(text, question, "--states", "60", "--json").json["results"]
    return found


@pytest.mark.parametrize("question", ["deadlock", "failures"])
def test_what_each_agent_keeps_by_itself_is_proved(prove, question: str) -> None:  # type: ignore[no-untyped-def]
    found = asked(prove, GROUP, question)
    assert found["verdict"] == "PROVED"
    assert re.fullmatch(rf"1 seller, 2 buyer{BOUND}[0-9]+ states", found["bounds"])


def test_a_wait_that_only_others_end_stays_undecided(prove) -> None:  # type: ignore[no-untyped-def]
    found = asked(prove, PATIENT, "deadlock")
    assert (found["verdict"], found["reason"]) == ("UNDECIDED", "the search was cut after 60 states")


def test_an_agent_that_fails_among_others_is_not_proved_to_fail_never(prove) -> None:  # type: ignore[no-untyped-def]
    fails = GROUP.replace("    var sold : bool\n", "    var sold : bool\n    var best : agent\n")
    fails = fails.replace(
        "enter Close : after(10s)", "enter Close : after(10s) / send refuse Offer { .. } to best"
    )
    assert asked(prove, fails, "failures")["verdict"] != "PROVED"


def test_one_that_asks_how_old_a_message_is_is_not_explored_so(prove) -> None:  # type: ignore[no-untyped-def]
    old = GROUP.replace(
        "skip  Pay    : refuse Offer from seller", "skip  Pay    : refuse Offer o from seller [age(o) > 1s]"
    )
    assert old != GROUP
    assert asked(prove, old, "deadlock")["verdict"] == "UNDECIDED"


def test_agents_of_one_role_that_begin_otherwise_are_explored_each(prove) -> None:  # type: ignore[no-untyped-def]
    found = prove(TEAM, "deadlock", "--states", "60", "--json").json["results"]
    assert [item["verdict"] for item in found] == ["UNDECIDED", "PROVED"]


def test_agents_of_one_role_that_have_other_inputs_are_explored_each(prove) -> None:  # type: ignore[no-untyped-def]
    held = TEAM.replace("[index > 1]", "[my.state.Place.number > 1]")
    held = held.replace("b[1..3] : buyer", "b1 : buyer  b2 : buyer  b3 : buyer").replace(
        "index < 2", "index > 2"
    )
    held = held.replace("aip sale {", "message Place { int number }\ntopic my { state Place }\naip sale {")
    held += """\
property "places" {
  assume b1 has [my.state.Place.number == 1]
  assume b2 has [my.state.Place.number == 2]
  assume b3 has [my.state.Place.number == 3]
  never two of buyer in Done
}
"""
    found = prove(held, "deadlock", "--states", "60", "--json").json["results"]
    assert [item["verdict"] for item in found] == ["UNDECIDED", "PROVED"]


PUBLISHED = """\
system Team
message Order { int n }
topic team { state Order  signal Order }
srm chief {
  liveness { chief = Think . Give . Rest }
  activities { Think  Give writes team.state.Order, team.signal.Order  Rest waits }
}
srm robot {
  liveness { robot = ((Wait . Work)~ || (Look . Look . Look)~) . End }
  activities { End waits }
  control robot { enter Work : LINE }
}
team Team { c : chief  r[1..3] : robot }
"""
"""Robots that read what a chief publishes: too many states for a short search."""


@pytest.mark.parametrize(
    "line",
    [
        pytest.param("after(1s)\n    enter Work : when [team.state.Order.n > 1]", id="time ends the wait"),
        pytest.param("[team.state.Order.n > 1]\n    enter Work : else", id="it goes on in each case"),
    ],
)
def test_an_agent_that_goes_on_for_all_that_is_published_is_proved(prove, line: str) -> None:  # type: ignore[no-untyped-def]
    text = PUBLISHED.replace("LINE", line)
    found = asked(prove, text, "deadlock")
    assert found["verdict"] == "PROVED", found
    assert "each agent among others that may do anything; regions that do not meet apart" in found["bounds"]


@pytest.mark.parametrize(
    "line",
    [
        pytest.param("when [team.state.Order.n > 1]", id="for a state"),
        pytest.param("when [team.signal.Order.n > 1]", id="for a signal"),
        pytest.param("[team.state.Order.n > 1]", id="for a state, once the activity has ended"),
        pytest.param("when [age(team.state.Order) > 1s]", id="until others publish no more"),
    ],
)
def test_one_that_waits_for_what_others_publish_stays_undecided(prove, line: str) -> None:  # type: ignore[no-untyped-def]
    found = asked(prove, PUBLISHED.replace("LINE", line), "deadlock")
    assert found["verdict"] == "UNDECIDED", found


def test_what_each_agent_publishes_for_itself_is_its_own(prove) -> None:  # type: ignore[no-untyped-def]
    line = "when [eye.state.Ball.n > 1]\n    enter Stay : [team.state.Order.n > 1]\n    skip Stay : else"
    text = PUBLISHED.replace("LINE", line).replace("Look . Look . Look", "Look . [Stay]")
    text = text.replace("topic team", "message Ball { int n }\ntopic eye { state Ball }\ntopic team")
    text = text.replace("End waits }", "End waits  Look writes eye.state.Ball }")
    found = asked(prove, text, "deadlock")
    assert found["verdict"] == "PROVED", found
    assert "each agent among others" in found["bounds"]


def test_an_activity_that_writes_a_variable_of_a_part_may_stand_outside_of_it(prove) -> None:  # type: ignore[no-untyped-def]
    """What copies of a part depend on is asked there, too, where the variable is not known."""
    roles = """\
srm seller {
  plays sale.seller
  liveness { seller = (sale.seller~)[3] }
}
srm buyer {
  plays sale.buyer
  liveness { buyer = (sale.buyer~)[2] || other~
             other = Listen . Rest }
  activities { Listen writes keen }
}
team Market { one : seller  two : buyer }
"""
    done = prove(GROUP + roles, "failures", "--robots", "2", "--states", "30")
    (team,) = (line for line in done.out.splitlines() if " of team" in line)
    assert team.startswith("PROVED    failures of team [1 seller, 1 buyer; ")
    assert "regions that do not meet apart" in team
