"""`asemec prove`: what it says of small systems with and without a mistake, exit codes and bounds."""

from __future__ import annotations

from tests.cli.support import Done

BUY = """\
system Shop
message Order { string what }
message Price { int euros }
aip buy {
  participant buyer {
    sends    request Order
    receives inform Price, refuse Order
    process  = Choose . Wait . (Pay | GoHome)
  }
  participant seller {
    var there : bool = false
    sends    inform Price, refuse Order
    receives request Order
    process  = Look . Close
  }
  clause Look@seller before Pay@buyer
  control buyer {
    enter Wait   : / send request Order { .. } to seller
    enter Pay    : inform Price from seller
    enter GoHome : refuse Order from seller
  }
  control seller {
    enter Look  : request Order from buyer
    enter Close : [there] / send inform Price { euros = 5 } to buyer
    enter Close : else / send refuse Order { .. } to buyer
  }
}
"""

MEET = """\
system Hall
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
"""

LATE = """\
system Office
message Job { int n }
aip ask {
  participant boss {
    sends    request Job
    receives inform Job
    process  = Think . Wait . (Praise | GiveUp)
  }
  participant worker {
    sends    inform Job
    receives request Job
    process  = Work . Rest
  }
  outcome "It is done."       when Rest@worker
  outcome "It was given up." when GiveUp@boss
  control boss {
    enter Wait   : / send request Job { n = 1 } to worker
    enter Praise : inform Job from worker
    enter GiveUp : after(10s)
  }
  control worker {
    enter Work : request Job from boss
    enter Rest : / send inform Job { n = 1 } to boss
  }
}
"""

FORGED = """\
system Yard
message Job { int n }
aip carry {
  participant manager {
    sends    request Job
    receives inform Job
    process  = Call . Settle
  }
  participant carrier {
    sends    inform Job by Estimate or Carry
    receives request Job
    process  = Estimate . Carry
  }
  clause Carry@carrier before Settle@manager
  control manager {
    enter Call   : / send request Job { n = 1 } to carrier
    enter Settle : inform Job from carrier
  }
  control carrier { enter Estimate : request Job from manager }
}
"""

CENTRES = """\
system Pair
message Who { int center }
topic team { state Who from decider }
srm decider {
  liveness { decider = Decide }
  activities { Decide writes team.state.Who }
}
srm player {
  var number : int = 0
  liveness { player = Wait . [Center] }
  control player {
    enter Center : [team.state.Who.center == number]
    skip  Center : [team.state.Who.center != number]
  }
}
team Pair {
  referee : decider
  one : player with number = 1
  two : player with number = 2
}
property "one centre" { at most one Center }
"""


def verdicts(done: Done) -> dict[str, str]:
    """The verdicts by name, from JSON."""
    assert done.json["format"] == 1
    return {item["name"]: item["verdict"] for item in done.json["results"]}


def test_a_protocol_without_a_mistake_is_proved_with_its_bounds(prove) -> None:  # type: ignore[no-untyped-def]
    done = prove(BUY)
    assert done.code == 0, done.out
    assert done.out.splitlines()[0] == (
        "PROVED    Look@seller before Pay@buyer of protocol buy (it.aseme:16:3)"
        " [1 buyer, 1 seller; any delay; 31 states]"
    )
    assert done.out.count("PROVED") == len(done.out.splitlines())


def test_a_wait_that_nothing_ends_is_shown_with_the_shortest_run(prove) -> None:  # type: ignore[no-untyped-def]
    done = prove(BUY.replace("    enter Close : else / send refuse Order { .. } to buyer\n", ""), "deadlock")
    assert done.code == 1
    assert done.out == (
        "REFUTED   deadlock of protocol buy: seller waits after Look for ever for [there]"
        " [1 buyer, 1 seller; any delay; 156 states]\n"
        "    1  buyer: Choose ends\n"
        "    2  seller gets request Order of buyer\n"
        "    3  seller: Look ends; seller: there is False\n"
    )


def test_a_message_that_nothing_takes_is_an_orphan(prove) -> None:  # type: ignore[no-untyped-def]
    twice = "send inform Price { euros = 5 } to buyer; send inform Price { euros = 6 } to buyer"
    text = BUY.replace("send inform Price { euros = 5 } to buyer", twice)
    assert verdicts(prove(text, "--json")) | {"orphan messages": "REFUTED", "deadlock": "PROVED"} == verdicts(
        prove(text, "--json")
    )


def test_two_that_choose_for_each_other_send_past_each_other(prove) -> None:  # type: ignore[no-untyped-def]
    found = verdicts(prove(MEET, "--json"))
    assert found["non-local choice"] == "REFUTED"
    assert found["deadlock"] == "REFUTED"


def test_a_deadline_that_crosses_the_answer_breaks_agreement(prove) -> None:  # type: ignore[no-untyped-def]
    done = prove(LATE, "agreement", "--json")
    (item,) = done.json["results"]
    assert (done.code, item["verdict"]) == (1, "REFUTED")
    assert item["reason"] == 'both "It is done." and "It was given up." come of it'
    assert item["counterexample"][-1] == "boss: 10 s have passed in start of (Praise | GiveUp)"
    assert verdicts(prove(LATE, "--json"))["deadlock"] == "PROVED"


def test_an_activity_that_may_send_the_answer_breaks_the_order(prove) -> None:  # type: ignore[no-untyped-def]
    done = prove(FORGED, "Carry@carrier before Settle@manager")
    assert done.code == 1
    assert "Estimate sends inform Job to manager" in done.out
    mended = FORGED.replace("by Estimate or Carry", "by Carry")
    assert prove(mended, "Carry@carrier before Settle@manager").code == 0


def test_two_robots_take_the_same_place(prove) -> None:  # type: ignore[no-untyped-def]
    done = prove(CENTRES, "one centre", "--json")
    (item,) = done.json["results"]
    assert (done.code, item["verdict"]) == (1, "REFUTED"), item
    assert "Who.center in" not in item["bounds"]  # `number` is written by nothing: it is a constant
    assert sum("publishes" in line for line in item["counterexample"]) == 2
    rule = "control decider { leave Decide : / write_messages.team.state.Who { center = 1 } }"
    fixed = CENTRES.replace("activities { Decide writes team.state.Who }", rule)
    assert prove(fixed, "one centre").code == 0


def test_what_takes_too_long_is_vacuous_or_was_cut_is_not_proved(prove) -> None:  # type: ignore[no-untyped-def]
    clause = "every Look@seller leads to Close@seller within 5s"
    timed = prove(BUY.replace("Look@seller before Pay@buyer", clause), clause, "--json")
    (item,) = timed.json["results"]
    assert (timed.code, item["verdict"]) == (1, "REFUTED"), item
    never = BUY.replace("Look@seller before Pay@buyer", "at most one GoHome@buyer")
    never = never.replace("  participant buyer {", "  participant buyer {\n    var no : int = 1")
    never = never.replace("enter Wait   : / send", "enter Wait   : / no = 2; send")
    never = never.replace("refuse Order from seller", "refuse Order from seller [no == 3]")
    vacuous = prove(never, "at most one GoHome@buyer", "--json")
    (item,) = vacuous.json["results"]
    assert (vacuous.code, item["verdict"]) == (3, "UNDECIDED"), item
    assert item["reason"] == "vacuous: what it speaks of never happens"
    cut = prove(BUY, "deadlock", "--states", "3", "--json")
    (item,) = cut.json["results"]
    assert (cut.code, item["verdict"]) == (3, "UNDECIDED")
    assert item["reason"] == "the search was cut after 3 states"
    assert prove(BUY, "--states", "3").code == 3  # of the clause


def test_a_crash_is_looked_at_where_it_is_assumed(prove) -> None:  # type: ignore[no-untyped-def]
    assert prove(BUY, "deadlock").code == 0
    team = (
        "srm shop { plays buy.seller liveness { shop = seller } }\n"
        "srm client { plays buy.buyer liveness { client = buyer } }\n"
        "team Street { ann : client  bob : shop }\n"
        'property "no matter" { assume at most 1 of shop crash  never ann in GoHome }\n'
    )
    found = prove(BUY + team, "deadlock", "--json").json["results"]
    by_scope = {item["of"]: item for item in found}
    assert by_scope["team"]["verdict"] == "REFUTED"
    assert any("crashes" in line for line in by_scope["team"]["counterexample"])
    assert by_scope["protocol buy"]["verdict"] == "PROVED"


def test_a_property_may_be_called_as_a_question(prove) -> None:  # type: ignore[no-untyped-def]
    robot = "system A\nsrm robot { liveness { robot = Go . Rest } }\n"
    done = prove(robot + 'property "deadlock" { never robot in Rest }\n', "deadlock", "--json")
    assert [item["verdict"] for item in done.json["results"]] == ["REFUTED", "PROVED"], done.out


def test_wrong_use_and_files_with_errors(prove) -> None:  # type: ignore[no-untyped-def]
    done = prove(BUY, "deadlok")
    assert done.code == 2
    assert "no property, clause or question is called `deadlok`; did you mean `deadlock`?" in done.err
    assert "there are `Look@seller before Pay@buyer`, `deadlock`," in prove(BUY, "").err
    assert "`failures`, `buy` and `team`" in prove(BUY, "").err
    assert "`b.aseme` is one file too many" in prove(BUY, "b.aseme").err
    none = prove(BUY, "buy", "agreement").err
    assert "`agreement` has no answer: no protocol of the file has two outcomes" in none
    assert prove(BUY.replace("Choose .", "Choose ..")).code == 1


NEAR = """\
system Eye
message Ball { double distance  int number }
topic eyes { state Ball }
srm robot {
  liveness { robot = (Look | Run | Jump)~ }
  control robot {
    enter Run  : [eyes.state.Ball.distance > 0.2 && eyes.state.Ball.distance < 0.5]
    enter Jump : [eyes.state.Ball.number % 10 == 7]
    enter Look : else
  }
}
property "never runs"  { never robot in Run }
property "never jumps" { never robot in Jump }
"""

FAR = NEAR.replace("eyes.state.Ball.number % 10 == 7", "abs(eyes.state.Ball.number) > 70")
"""Numbers beside a constant are tried where something is computed, too."""


def test_values_between_constants_are_tried_and_those_in_functions_are_not_all(prove) -> None:  # type: ignore[no-untyped-def]
    found = verdicts(prove(NEAR, "--json"))
    assert found["never runs"] == "REFUTED"
    assert found["never jumps"] == "UNDECIDED"  # a few numbers are tried
    assert found["dead states"] == "UNDECIDED"
    assert verdicts(prove(FAR, "never jumps", "--json")) == {"never jumps": "REFUTED"}


def test_what_a_participant_is_given_may_be_anything_when_a_protocol_is_played_alone(prove) -> None:  # type: ignore[no-untyped-def]
    text = BUY.replace("    var there : bool = false", "    given there : bool\n    given cost : Price")
    text = text.replace("[there]", "[there && cost.euros > 3]")
    found = verdicts(prove(text, "--json"))
    assert found["dead states"] == "PROVED"  # both lines of Close are taken
    assert found["deadlock"] == found["Look@seller before Pay@buyer"] == "PROVED"
    assert (
        verdicts(
            prove(text.replace("Look@seller before Pay@buyer", "Pay@buyer before Close@seller"), "--json")
        )["Pay@buyer before Close@seller"]
        == "REFUTED"
    )


def test_a_participant_that_is_given_an_agent_is_not_played_alone(prove) -> None:  # type: ignore[no-untyped-def]
    done = prove(
        BUY.replace("    var there : bool = false", "    given there : bool\n    given friend : agent")
    )
    assert (done.code, done.out) == (
        3,
        "UNDECIDED protocol buy of protocol buy: it cannot be played alone: `seller` is given no `friend`"
        " [1 buyer, 1 seller]\n",
    )


def test_a_property_about_values_has_those_tried_that_it_asks_for(prove) -> None:  # type: ignore[no-untyped-def]
    text = NEAR[: NEAR.index("property")].replace(
        "srm robot {", "srm robot {\n  var tries : int = 0\n  activities { Look writes tries }"
    )
    text += 'property "few" { always robot has [tries < 3] }\n'
    text += 'property "small" { never received Ball b [b.distance > 900.0] }\n'
    found = verdicts(prove(text, "few", "small", "--json"))
    assert (found["few"], found["small"]) == ("REFUTED", "REFUTED")


MODULE = """\
system Keeper
message Ball { int distance }
topic vision { state Ball }
srm keeper {
  liveness { keeper = Stand . Dive }
  modules { Vision every 40ms writes vision.state.Ball }
  control keeper { enter Dive : when [vision.state.Ball.distance < 100] }
}
property "never dives" { never keeper in Dive }
"""


def test_what_a_module_publishes_is_an_input(prove) -> None:  # type: ignore[no-untyped-def]
    found = verdicts(prove(MODULE, "--json"))
    assert (found["never dives"], found["deadlock"], found["dead states"]) == ("REFUTED", "PROVED", "PROVED")
