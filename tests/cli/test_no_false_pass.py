"""`asemec prove`: ways to a PROVED that nothing stands behind. In each, what is asked is false or empty, or
the search cannot tell; so no way leads to a PROVED, nor to exit code 0."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.cli.support import Here
from tests.cli.test_prove import BUY, CENTRES, FORGED
from tests.cli.test_prove_pairs import LEASE

HEAD = """\
system S
enum Mood { CALM, ANGRY }
message Ball { int number  double x  string name  bool seen  Mood mood }
topic field { state Ball  data Ball every 100ms  signal Ball }
"""


def _role(inside: str, activities: str = "") -> str:
    """A robot that waits, and then works if a line lets it."""
    return (
        HEAD
        + f"srm robot {{\n  liveness {{ robot = Wait . [Work] }}\n  activities {{ {activities} }}\n"
        + f"  {inside}\n}}\n"
    )


def _works(condition: str, more: str = "", activities: str = "") -> str:
    """A robot that works only if a condition lets it; that it never does is false."""
    control = f"{more}\n  control robot {{ enter Work : [{condition}]  skip Work : else }}"
    return _role(control, activities) + 'property "p" { never robot in Work }\n'


LONG = (
    HEAD
    + "srm robot {\n  var n : int\n  liveness { robot = Count+ . Work }\n  activities { }\n"
    + "  control robot { leave Count : [n == 40]  repeat Count : else / n = n + 1 }\n}\n"
    + 'property "p" { never robot in Work }\n'
)

WAYS = {
    "few states": (LONG, ["--states", "20"], "p"),
    "no time": (LONG, ["--budget", "1ms"], "p"),
    "few states for a question": (BUY, ["--states", "5"], "deadlock"),
    "few states for what never is": (
        BUY.replace("else / send refuse", "[there] / send refuse"),
        ["--states", "5"],
        "dead states",
    ),
    "a message that the agent does not read": (
        _role("") + 'property "p" { never robot has [field.state.Ball.number >= 0] }\n',
        [],
        "p",
    ),
    "leads to, whose first part never comes": (
        _role("control robot { enter Work : [false && true]  skip Work : else }")
        + 'property "p" { every robot in Work leads to robot in Wait }\n',
        [],
        "p",
    ),
    "before, whose second part never comes": (
        _role("control robot { enter Work : [1 > 2]  skip Work : else }")
        + 'property "p" { Wait before Work }\n',
        [],
        "p",
    ),
    "never a state that nothing reaches": (
        _role("control robot { enter Work : [1 > 2]  skip Work : else }")
        + 'property "p" { never two of robot in Work }\nteam t { one, two : robot }\n',
        [],
        "p",
    ),
    "at most one in a state that nothing reaches": (
        _role("control robot { enter Work : [1 > 2]  skip Work : else }")
        + 'property "p" { at most one Work }\nteam t { one, two : robot }\n',
        [],
        "p",
    ),
    "never both, of which one never is": (
        _role("control robot { enter Work : [1 > 2]  skip Work : else }")
        + 'property "p" { never one in Work and two in Wait }\nteam t { one, two : robot }\n',
        [],
        "p",
    ),
    "a clause of a protocol in which nothing can be said": (
        BUY.replace(
            "enter Look  : request Order from buyer", "enter Look  : request Order from buyer [1 > 2]"
        ),
        [],
        "Look@seller before Pay@buyer",
    ),
    "an agent that is left out": (
        CENTRES.replace("at most one Center", "never two in Center"),
        ["--robots", "1"],
        "one centre",
    ),
    "a duration": (
        _role("") + 'property "p" { every robot in Wait leads to robot in Work within 1ms }\n',
        [],
        "p",
    ),
    "a moment": (_role("") + 'property "p" { no robot in Work before 1h }\n'.replace("1h", "60min"), [], "p"),
    "a list": (
        _works("size(tries) == 2", "var tries : list of int", "Wait writes tries"),
        [],
        "p",
    ),
    "an age that is computed with": (_works("age(field.state.Ball) + 1s > 3s"), [], "p"),
    "a history": (_works("at(field.data.Ball.number, -1s) == 3"), [], "p"),
    "a mean": (_works("mean(field.data.Ball.x, 1s) > 2.5"), [], "p"),
    "two values": (_works("field.state.Ball.number > field.data.Ball.number + 2"), [], "p"),
    "a product": (_works("field.state.Ball.number * field.state.Ball.number == 1764"), [], "p"),
    "a sum of halves": (_works("field.state.Ball.x + 0.25 == 7.0"), [], "p"),
    "a text": (_works('field.state.Ball.name == "red ball"'), [], "p"),
    "another text": (_works('field.state.Ball.name != "red ball"'), [], "p"),
    "a random number": (
        HEAD + "srm robot {\n  var luck : double\n  liveness { robot = Wait . Draw . [Work] }\n"
        "  control robot { enter Draw : / luck = random()\n"
        "    enter Work : [luck > 0.999]  skip Work : else }\n}\n"
        'property "p" { never robot in Work }\n',
        [],
        "p",
    ),
    "a module that writes a variable": (
        _works("tries == 7", "var tries : int\n  modules { Look every 1s writes tries }"),
        [],
        "p",
    ),
    "a variable that an activity sets, which is asked for": (
        _role("var tries : int", "Wait writes tries") + 'property "p" { never robot has [tries == 12345] }\n',
        [],
        "p",
    ),
    "a value of a message, which is asked for": (
        _role("", "Wait writes field.state.Ball")
        + 'property "p" { never sent Ball b [b.number * b.number == 1764] }\n',
        [],
        "p",
    ),
    "a message that an activity sends, which never comes": (
        _role("") + 'property "p" { every sent field.state.Ball leads to robot in Work }\n',
        [],
        "p",
    ),
    "a remainder": (_works("field.state.Ball.number % 1000 == 999"), [], "p"),
    "an enum": (_works("field.state.Ball.mood == Mood.ANGRY"), [], "p"),
    "in the first step": (
        HEAD + "srm robot { liveness { robot = (Work | Wait) . Rest~ }\n"
        "  control robot { enter Work : [field.state.Ball.number == 3]  enter Wait : else }\n}\n"
        'property "p" { never robot in Work }\n',
        [],
        "p",
    ),
    "a message that an undeclared activity may send": (
        FORGED.replace(" by Estimate or Carry", ""),
        [],
        "Carry@carrier before Settle@manager",
    ),
    "guarantees that exclude each other": (
        HEAD + "srm robot {\n  liveness { robot = Look~ || (Wait . Work) }\n"
        "  activities { Wait waits  Look writes field.state.Ball\n"
        "    guarantees no sent Ball b [b.number == 1] within 1s after sent Ball a [a.number == 1]\n"
        "    guarantees no sent Ball b [b.number != 1] within 1s after sent Ball a [a.number == 1] }\n"
        "  control robot { enter Work : when [field.state.Ball.number == 1] }\n}\n"
        'property "p" { never robot in Work }\n',
        [],
        "p",
    ),
    "assumptions about one value that exclude each other": (
        _works("field.state.Ball.number == 3").replace(
            'property "p" {',
            'property "p" { assume robot has [field.state.Ball.number == 1]'
            " assume robot has [field.state.Ball.number == 2]",
        ),
        [],
        "p",
    ),
    "an assumption that is never so of a value": (
        _works("field.state.Ball.number == 3").replace(
            'property "p" {',
            'property "p" { assume robot has [field.state.Ball.number == 2 && field.state.Ball.number > 5]',
        ),
        [],
        "p",
    ),
    "an assumption that is never so": (
        _works("field.state.Ball.number == 3").replace(
            'property "p" {', 'property "p" { assume robot has [1 > 2]'
        ),
        [],
        "p",
    ),
    "a horizon of nothing": (
        _role("control robot { enter Work : [true]  skip Work : after(1s) }")
        + 'property "p" { no robot in Work before 30min }\n',
        ["--horizon", "1ms"],
        "p",
    ),
    "nearly every message is lost": (
        CENTRES.replace(
            "at most one Center", "assume network loss 99%  every one in Wait leads to one in Center"
        ),
        ["--states", "300"],
        "one centre",
    ),
    "a timer that nothing starts": (
        HEAD + "srm robot {\n  liveness { robot = Wait . Work }\n  activities { Wait waits }\n"
        "  control robot { enter Work : when [expired(rest)] }\n}\n"
        'property "p" { every robot in Work leads to robot in Wait }\n',
        [],
        "p",
    ),
    "a part that is cut short, which counts as over": (
        HEAD + "srm robot {\n  liveness { robot = (Look~ [> Halt) . [Work] }\n"
        "  control robot { enter Halt : when [field.state.Ball.seen]\n"
        "    enter Work : [field.state.Ball.number == 9]  skip Work : else }\n}\n"
        'property "p" { never robot in Work }\n',
        [],
        "p",
    ),
    "a crash that is assumed of nobody who matters": (
        CENTRES.replace("at most one Center", "assume at most 1 of decider crash  never two in Center"),
        [],
        "one centre",
    ),
    "a monitor that waits for what comes once": (
        _role("control robot { enter Work : [1 > 2]  skip Work : else }")
        + 'property "p" { robot in Wait until robot in Work }\n',
        [],
        "p",
    ),
    "no X soon after a Y that never is": (
        _role("control robot { enter Work : [1 > 2]  skip Work : else }")
        + 'property "p" { no robot in Wait within 1s after robot in Work }\n',
        [],
        "p",
    ),
    "in order, of what never comes": (
        _role("control robot { enter Work : [1 > 2]  skip Work : else }")
        + 'property "p" { in order robot in Wait, robot in Work }\n',
        [],
        "p",
    ),
    "a list of a participant that is longer than it can be": (
        BUY.replace(
            "    var there : bool = false", "    var there : bool = false\n    var list : list[3] of int"
        ).replace("[there]", "[there && size(list) > 7]"),
        ["--states", "9"],
        "Look@seller before Pay@buyer",
    ),
    "an agent alone of which two values are assumed": (
        LEASE.replace("  assume three", "  assume two has [my.state.Identity.number == 7]\n  assume three"),
        ["--budget", "3s"],
        "one works",
    ),
    "a second agent that gives orders": (
        LEASE.replace("  two, three : worker", "  two, three : worker\n  four : boss"),
        ["--budget", "3s"],
        "one works",
    ),
    "a promise that is too short": (
        LEASE.replace("within 2s", "within 1s"),
        ["--budget", "3s"],
        "one works",
    ),
    "a message that an activity publishes and nobody reads": (
        _role("", "Wait takes 1s writes field.state.Ball") + 'property "p" { never sent Ball }\n',
        [],
        "p",
    ),
    "a message on a channel that an activity publishes and nobody reads": (
        _role("", "Wait takes 1s writes field.state.Ball") + 'property "p" { never sent field.state.Ball }\n',
        [],
        "p",
    ),
    "a message that comes to a region that does not matter": (
        _role("control robot { enter Work : [field.state.Ball.seen]  skip Work : else }")
        + 'property "p" { never received field.state.Ball }\n',
        [],
        "p",
    ),
    "an event from outside": (
        _role("control robot { enter Work : alarm  skip Work : after(1s) }")
        + 'property "p" { never robot in Work }\n',
        [],
        "p",
    ),
}


SURE = {"nearly every message is lost"}
"""Those that are refuted in a part of the search: there, UNDECIDED alone would show nothing."""


def test_there_are_twenty_ways() -> None:
    assert len(WAYS) >= 20


@pytest.mark.parametrize("way", WAYS)
def test_no_way_leads_to_a_proof_of_nothing(here: Here, folder: Path, way: str) -> None:
    text, options, name = WAYS[way]
    (folder / "a.aseme").write_text(text)
    done = here("prove", "a.aseme", name, *options, "--json")
    assert done.out.startswith("{"), done.err
    found = [item for item in done.json["results"] if item["name"] == name]
    assert found, done.out
    assert all(item["verdict"] != "PROVED" for item in found), found
    if way in SURE:
        assert all(item["verdict"] == "REFUTED" for item in found), found
    assert done.code in (1, 3)
    assert done.code == 1 or all(item["reason"] for item in found)
