"""`asemec prove` on properties that ask what is in messages and variables: as trying all values says."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import product
from operator import eq, ge, gt, le, lt, ne
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from tests.cli.support import Here
from tests.cli.test_prove import verdicts
from tests.support.lanes import IS_LONG

PLACES = {
    "received": "never received Ball b [{}]",
    "sent": "never sent Order b [{}]",
    "has": "never dog has [{}]",
    "variable": "never boss has [{}]",
}
"""Properties about one message or about variables, with a place for a condition."""

NAMES = {"received": "b.", "sent": "b.", "has": "team.state.Ball.", "variable": ""}

TEAM = """\
system Team
enum Colour { RED GREEN BLUE }
message Ball  { int number  bool seen  Colour colour }
message Order { int number  bool seen  Colour colour }
topic team { state Order  state Ball }
srm boss {
  var number : int    = 0
  var seen   : bool   = false
  var colour : Colour = Colour.RED
  liveness { boss = Give . Rest }
  activities { Give takes 1s writes team.state.Order, number, seen, colour  Rest waits }
}
srm dog {
  liveness { dog = (Look | Run)~ }
  control dog { enter Run : [team.state.Ball.number > 3]  enter Look : else }
}
team T { boss : boss  dog : dog }
"""


Values = tuple[int, bool, str]
"""The members `number`, `seen` and `colour`."""


@dataclass(frozen=True)
class Condition:
    """A condition as it is written, with `@` before each member, and whether values meet it."""

    text: str
    met: Callable[[Values], bool]

    def __repr__(self) -> str:
        return self.text


SIGNS = {"<": lt, "<=": le, "==": eq, "!=": ne, ">=": ge, ">": gt}


def compared(number: int, sign: str) -> Condition:
    return Condition(f"@number {sign} {number}", lambda values: SIGNS[sign](values[0], number))


def joined(one: Condition, other: Condition, word: str) -> Condition:
    join = all if word == "&&" else any
    return Condition(
        f"({one.text}) {word} ({other.text})", lambda values: join((one.met(values), other.met(values)))
    )


COLOURS = ("RED", "GREEN", "BLUE")
CONDITIONS = st.recursive(
    st.one_of(
        st.builds(compared, st.integers(-3, 8), st.sampled_from(sorted(SIGNS))),
        st.just(Condition("@seen", lambda values: values[1])),
        st.just(Condition("!@seen", lambda values: not values[1])),
        st.sampled_from(COLOURS).map(
            lambda name: Condition(f"@colour == Colour.{name}", lambda values: values[2] == name)
        ),
    ),
    lambda inner: st.builds(joined, inner, inner, st.sampled_from(("&&", "||"))),
    max_leaves=4,
)


def happens(condition: Condition) -> bool:
    """Whether any values make a condition true."""
    return any(map(condition.met, product(range(-6, 12), (False, True), COLOURS)))


@settings(max_examples=6 if IS_LONG else 2, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.lists(st.tuples(st.sampled_from(sorted(PLACES)), CONDITIONS), min_size=4, max_size=4))
def test_a_condition_is_met_if_any_values_meet_it(
    here: Here, folder: Path, asked: list[tuple[str, Condition]]
) -> None:
    text = TEAM
    for number, (place, condition) in enumerate(asked):
        written = condition.text.replace("@", NAMES[place])
        text += f'property "p{number}" {{ {PLACES[place].format(written)} }}\n'
    (folder / "team.aseme").write_text(text)
    names = [f"p{number}" for number in range(len(asked))]
    done = here("prove", "team.aseme", *names, "--json")
    found = {item["name"]: item["verdict"] for item in done.json["results"]}
    wanted = {
        f"p{number}": "REFUTED" if happens(condition) else "PROVED"
        for number, (_, condition) in enumerate(asked)
    }
    assert found == wanted, text


@pytest.mark.parametrize(
    "written, verdict",
    [
        ("never sent Order", "REFUTED"),  # nobody reads it
        ("never dog has [team.state.Ball.number * team.state.Ball.number == 49]", "UNDECIDED"),
        ("never dog has [abs(team.state.Ball.number) == 7]", "REFUTED"),
        ("never boss has [number * number == 400]", "UNDECIDED"),
        ("never dog has [age(team.state.Ball) > 5s]", "UNDECIDED"),
        ("never dog in Run and dog has [team.state.Ball.number < 0]", "REFUTED"),  # a second one has come
    ],
)
def test_other_conditions(here: Here, folder: Path, written: str, verdict: str) -> None:
    (folder / "team.aseme").write_text(f'{TEAM}property "p" {{ {written} }}\n')
    assert here("prove", "team.aseme", "p").out.split()[0] == verdict


STOP = """\
system Stop
srm boss {
  var n : int = 0
  liveness { boss = (Give . Next) [> Stop }
  activities { Give takes 1s writes n  Next takes 1s  Stop takes 1s }
  control boss { enter Stop : when [n > 3] }
}
team T { boss : boss }
property "order" { boss in Next before boss has [n == 2] }
property "while" { never boss in Give and boss has [n == 2] }
property "bound" { never boss in Next and boss has [n > 3] }
"""


def test_an_activity_writes_a_variable_before_it_ends(here: Here, folder: Path) -> None:
    (folder / "a.aseme").write_text(STOP)
    done = here("prove", "a.aseme", "order", "while", "bound", "--save", "found.aseme", "--json")
    verdicts = {item["name"]: item["verdict"] for item in done.json["results"]}
    assert verdicts == {"order": "REFUTED", "while": "REFUTED", "bound": "PROVED"}
    assert "boss does Give sets n = 2" in (folder / "found.aseme").read_text()
    played = here("test", "found.aseme", "--json").json["scenarios"]
    assert [item["verdict"] for item in played] == ["failed"] * 2


def test_what_other_properties_ask_for_is_not_decided(here: Here, folder: Path) -> None:
    """It would be decided of a variable before an activity has written it."""
    other = 'property "other" { never boss in Give and dog has [team.state.Ball.number == 7] }\n'
    text = TEAM + 'property "one" { never boss in Give and boss has [number == 7] }\n' + other
    (folder / "a.aseme").write_text(text)
    done = here("prove", "a.aseme", "one", "other", "--json")
    assert [item["verdict"] for item in done.json["results"]] == ["REFUTED", "REFUTED"], done.out


@pytest.mark.parametrize(
    ("assumed", "reason"),
    [
        (["number == 2 && number > 5"], "is never true"),
        (["!(number != 2 || number <= 5)"], "is never true"),
        (["number > 5", "5 > number"], "and another assumption exclude each other"),
        (["seen", "number > 3 && !seen"], "and another assumption exclude each other"),
        (["colour == Colour.RED && colour == Colour.BLUE"], "is never true"),
        (["number > 2 && number < 4", "number != 4"], ""),
        (["colour != Colour.RED && colour != Colour.BLUE", "seen"], ""),
    ],
)
def test_nothing_is_proved_under_assumptions_that_exclude_each_other(
    here: Here, folder: Path, assumed: list[str], reason: str
) -> None:
    lines = "".join(f"assume boss has [{condition}] " for condition in assumed)
    (folder / "a.aseme").write_text(
        f'{TEAM}property "p" {{ {lines} never boss has [number == 50 && number == 51] }}\n'
    )
    item, dead = here("prove", "a.aseme", "p", "dead states", "--json").json["results"]
    assert dead["verdict"] == "UNDECIDED" or not reason
    assert item["verdict"] == ("UNDECIDED" if reason else "PROVED")
    assert item["reason"].endswith(reason)
    assert item["reason"].startswith("vacuous" if reason else "")


def test_what_an_activity_writes_and_what_comes_may_be_taken_in_one_step(here: Here, folder: Path) -> None:
    (folder / "a.aseme").write_text("""\
system Both
srm robot {
  var tired : bool = false
  liveness {
    robot = Look || part
    part  = (Both | Alone)
  }
  activities { Look writes tired }
  control part {
    enter Both  : go [tired]
    enter Alone : when [tired]
  }
}
team T { it : robot }
property "not both" { never it in Both }
""")
    (item,) = here("prove", "a.aseme", "not both", "--json").json["results"]
    assert item["verdict"] != "PROVED"


COUNTER = """\
system Counter
message Ball { bool seen }
topic eyes { state Ball }
srm robot {
  var known : bool
  var last  : bool
  liveness { robot = Begin . Look . [Count] }
  control robot {
    enter Begin : / known = false
    enter Look  : / known = eyes.state.Ball.seen || !eyes.state.Ball.seen; last = known
    enter Count : [!last]
    skip  Count : else
  }
}
"""
"""Where no ball was seen, the first action of `enter Look` is not done: the variable holds what it held."""


def test_an_action_that_is_not_done_leaves_what_was_there(prove) -> None:  # type: ignore[no-untyped-def]
    assert verdicts(prove(COUNTER, "dead states", "--json")) == {"dead states": "PROVED"}


GIVEN = """\
system Talks
import math
message Word { double n }
aip talk {
  participant asking {
    var whole : int = 0
    process = Ask . Wait . [Work] . Learn
  }
  participant asked {
    process = Look . Tell
  }
  control asking {
    enter Wait   : / send request Word { n = 1.0 } to asked
    enter [Work] : inform Word w from asked / whole = floor(w.n)
    enter Work   : [whole > 3]
    skip Work    : else
  }
  control asked {
    enter Look : request Word from asking
    leave Tell : / send inform Word to asking
  }
}
"""
"""What a message says comes to a variable through a function of the library."""


def test_what_a_function_of_the_library_is_given_is_tried(prove) -> None:  # type: ignore[no-untyped-def]
    found = verdicts(prove(GIVEN, "dead states", "failures", "--json"))
    assert found == {"dead states": "UNDECIDED", "failures": "UNDECIDED"}
