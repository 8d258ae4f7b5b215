"""`asemec prove`: numbers that are compared with constants, and with variables that nothing writes."""

from __future__ import annotations

import pytest

from tests.cli.test_prove import verdicts

WATCH = """\
system S
message M {{ int x  double y }}
topic w {{ state M }}
srm a {{
  {variable}
  liveness {{ a = (A . B)~ }}
  activities {{ A takes 1s  B takes 1s }}
  control a {{ enter B : when [{condition}] }}
}}
team T {{ one : a{settings} }}
property "it never acts" {{ never one in B }}
property "it has not heard" {{ never one has [{asked}] }}
"""


@pytest.mark.parametrize("condition", ["w.state.M.x > 60.5", "w.state.M.x < -60.5", "w.state.M.x >= 60.5"])
@pytest.mark.parametrize("asked", ["w.state.M.x > 90.25", "w.state.M.x < 0.5"])
def test_an_int_is_on_both_sides_of_a_fraction(prove, condition: str, asked: str) -> None:  # type: ignore[no-untyped-def]
    text = WATCH.format(variable="", condition=condition, settings="", asked=asked)
    found = verdicts(prove(text, "--json"))
    assert found["dead states"] == "PROVED"
    assert found["it never acts"] == found["it has not heard"] == "REFUTED"


@pytest.mark.parametrize("condition", ["w.state.M.x == 60.5", "w.state.M.x > 60.5 && w.state.M.x < 60.75"])
def test_an_int_is_no_fraction(prove, condition: str) -> None:  # type: ignore[no-untyped-def]
    text = WATCH.format(variable="", condition=condition, settings="", asked="w.state.M.x > 1")
    assert verdicts(prove(text, "it never acts", "--json"))["it never acts"] == "PROVED"


LIMITED = WATCH.format(
    variable="var limit : double = 60",
    condition="w.state.M.y > limit",
    settings=" with limit = 90  two : a",
    asked="w.state.M.y > 1",
)


def test_a_variable_that_nothing_writes_is_a_constant(prove) -> None:  # type: ignore[no-untyped-def]
    limits = LIMITED + 'property "near" { never one in B }\nproperty "far" { never two in B }\n'
    done = prove(limits.replace("(A . B)~", "A . B"), "--json", "--robots", "2")
    assert {item["bounds"].split(";")[1].strip() for item in done.json["results"]} <= {
        "any delay",
        "agents that do not meet apart",
    }
    found = verdicts(done)
    assert found["deadlock"] == found["dead states"] == "PROVED"
    assert found["near"] == found["far"] == "REFUTED"


FAR = """
system S
message M { double y }
topic w { state M }
srm a {
  var limit : double = 60
  liveness { a = A . B . C }
  activities { A takes 1s%s  B takes 1s  C takes 1s }
  control a { enter B : when [w.state.M.y > limit]%s  enter C : when [w.state.M.y > limit && limit > 999] }
}
%steam T { one : a }
property "not so far" { never one in C }
"""


@pytest.mark.parametrize(
    ("more", "is_proved"),
    [
        (("", "", ""), True),
        ((" writes limit", "", ""), False),
        (("", " / limit = 1000", ""), False),
    ],
)
def test_a_variable_that_something_writes_is_none(prove, more: tuple[str, ...], is_proved: bool) -> None:  # type: ignore[no-untyped-def]
    done = prove(FAR % more, "not so far", "--json")
    assert (verdicts(done)["not so far"] == "PROVED") == is_proved


def test_one_that_is_written_in_another_role_is_none(prove) -> None:  # type: ignore[no-untyped-def]
    text = FAR.replace("srm a", "srm x").replace("a = A", "x = A").replace("control a", "control x")
    text = text % (" writes limit", "", "srm a { var limit : double = 7  liveness { a = E } }\n")
    text = text.replace("one : a", "two : a  one : x")
    assert verdicts(prove(text, "not so far", "--json"))["not so far"] != "PROVED"


AGED = """\
system S
message Ball {{ bool near }}
topic eye {{ state Ball }}
let old = age(eye.state.Ball)
srm dog {{
  liveness {{ dog = (Wait . (Run | Rest))~ }}
  activities {{ Wait takes 1s }}
  control dog {{ enter Run : [{condition}]  enter Rest : else }}
}}
"""


@pytest.mark.parametrize(
    "condition", ["old > 1s && old < 5s", "1s < old && 5s > old", "old >= 5s && old <= 5s", "old == 5s"]
)
def test_a_message_is_of_each_age_that_conditions_tell_apart(prove, condition: str) -> None:  # type: ignore[no-untyped-def]
    (found,) = prove(AGED.format(condition=condition), "dead states", "--json").json["results"]
    assert (found["verdict"], found["reason"]) == ("PROVED", "")


def test_no_message_is_of_two_ages(prove) -> None:  # type: ignore[no-untyped-def]
    text = AGED.format(condition="old < 1s && old >= 1s")
    (found,) = prove(text, "dead states", "--json").json["results"]
    assert found["verdict"] == "REFUTED"
