"""`c ? a : b`: one of two values; only the one that is chosen is looked at."""

import pytest

from aseme_dsl.amola.expression import expression_text
from aseme_dsl.amola.statechart import Transition
from tests.runtime.playing import play
from tests.support.compiling import analysis, system

TEXT = """
system S
enum Colour {{ RED GREEN }}
message M {{ int n  optional int o }}
topic t {{ state M }}
srm r {{
  var n : int = 7
  var d : double = 1.5
  var c : Colour = Colour.RED
  var b : bool = true
  var s : string = "x"
  let big = n > 5 ? 2 : 3
  liveness {{ r = Go . Stop }}
  activities {{ Go takes 1s simulated  Stop takes 1s simulated reads n, d, c, b, s }}
  control r {{ enter Stop : {way} }}
}}
"""


def way(text: str) -> Transition:
    (chart,) = system(TEXT.format(way=text)).iacs
    return next(item for item in chart.transitions if item.expression.span is not None)


@pytest.mark.parametrize(
    "text",
    [
        "[(n > 5 ? 1 : 2) > 1]",
        "/ n = b ? 1 : 2",
        "/ n = b ? 1 : d > 1 ? 2 : 3",
        "/ n = (b ? 1 : 2) + 3",
        "/ n += b ? 1 : -1",
        "/ d = b || n > 1 ? 1 : 0.5",
        "[(has(t.state.M) ? t.state.M.n : 0) == 0]",
        '/ s = b ? "a" : "b"; c = b ? Colour.RED : Colour.GREEN',
    ],
)
def test_it_is_shown_as_it_is_written(text: str) -> None:
    assert expression_text(way(text).expression) == text


def taken(text: str) -> bool:
    return "start Stop" in play(TEXT.format(way=text)).order("start")


@pytest.mark.parametrize(
    ("condition", "holds"),
    [
        ("(n > 5 ? 1 : 2) == 1", True),
        ("(n > 8 ? 1 : 2) == 1", False),
        ("(n > 5 ? n > 6 ? 1 : 2 : 3) == 1", True),
        ("(n > 8 ? 1 : n > 6 ? 2 : 3) == 2", True),
        ("(b ? 1 : 0.5) / 2 == 0.5", True),
        ("b ? n > 5 : false", True),
        ("!(b ? n > 5 : false)", False),
        ("(has(t.state.M) ? t.state.M.n : 4) == 4", True),
        ("(!has(t.state.M) ? 4 : t.state.M.n) == 4", True),
        ("(has(t.state.M) ? 4 : t.state.M.n) == 4", False),
        ("(t.state.M.n > 1 ? 4 : 4) == 4", False),
        ("(n == 0 ? 1 : 14 / n) == 2", True),
        ("(n != 0 ? 1 : 14 / 0.0) == 1", True),
        ("big == 2", True),
        ("min(b ? 1 : 2, 3) == 1", True),
    ],
)
def test_only_what_is_chosen_counts(condition: str, holds: bool) -> None:
    assert taken(f"[{condition}]") is holds


@pytest.mark.parametrize(
    ("value", "code", "message"),
    [
        (
            'b ? 1 : "x"',
            "E500",
            "`?` gives values of one type: this is string, and before the ':' stands int",
        ),
        ("n ? 1 : 2", "E505", None),
        ("b ? t.state.M : t.state.M", "E500", "an int is wanted here, not a M"),
        ("size(b ? [1] : [2])", "E500", "`?` gives one of two values, and this is a whole list of int"),
        ("b ? 0.5 : 1", "E506", None),
        ("b ? 1", "E102", None),
        ("b ? : 1", "E102", None),
        ("b ? 1 :", "E102", None),
        ("random() > 0.5 ? 1 : 2", "E526", None),
    ],
)
def test_what_is_wrong_is_reported(value: str, code: str, message: str | None) -> None:
    found = [item for item in analysis(TEXT.format(way=f"/ n = {value}")).diagnostics if item.code[0] == "E"]
    assert [item.code for item in found] == [code]
    assert message is None or found[0].message.startswith(message)


def test_a_double_branch_makes_the_other_one_a_double() -> None:
    text = "system S srm r { var d : double = true ? 1 : 0.5  liveness { r = A } activities { A takes 1s } }"
    (chart,) = system(text).iacs
    (variable,) = chart.variables
    assert isinstance(variable.initial.value, float)


def test_it_stands_between_the_braces_of_a_message() -> None:
    text = '/ write_messages.t.state.M { n = b ? 1 : s == "a" ? 2 : 3, o = 3 }'
    assert 't.state.M.n = b ? 1 : s == "a" ? 2 : 3; t.state.M.o = 3' in expression_text(way(text).expression)


GIVEN = """
system S
let near = 4
message M { int n }
topic t { state M  signal M }
aip ride {
  participant rider { given low : bool  process = Step  sends inform M }
  participant lift { process = Wait  receives inform M }
  control rider { enter Step : [low] / send inform M { n = 1 } to lift }
}
srm bot {
  var n : int = 7
  plays ride.rider with low = n > 2 ? n < 9 : false, Step = Ride
  liveness {
    bot     = Go(n > 1 ? n : 0) . Go(n == 1 ? 5 : has(t.state.M) ? t.state.M.n : -n) . more(n > 2 ? 1 : 2)
              . rider
    more(k) = Go(k) . Other(k * 10 + (k == 1 ? 2 : 3))
  }
  activities { Go(x : int) takes 1s simulated  Other(x : int) takes 1s simulated  Ride takes 1s simulated }
}
srm ann { plays ride.lift liveness { ann = lift } activities { Wait takes 1s simulated } }
team T {
  a    : bot with n = index > 1 ? 3 : 5
  b, c : bot with n = index == 1 ? true ? 1 : 2 : near
  d    : bot with n = index > 1 ? (near) : index  e : ann
}
"""


def test_arguments_settings_and_bindings_choose() -> None:
    played = play(GIVEN)
    given = {
        agent: [
            r["arguments"]["x"] for r in played.of("activity", agent=agent, what="start") if "arguments" in r
        ]
        for agent in ("a", "b", "d")
    }
    assert given == {"a": [5, -5, 1, 12], "b": [0, 5, 2, 23], "d": [0, 5, 2, 23]}
    assert {r["agent"] for r in played.of("activity", what="start") if r["activity"] == "Ride"} == {
        "a"
    }  # the others' `low` is false


@pytest.mark.parametrize(
    ("old", "new", "code", "hint"),
    [
        ("Go(n > 1 ? n : 0)", "Go(n > 1 ? n)", "E102", None),
        ("Go(n > 1 ? n : 0)", 'Go(n > 1 ? n : "x")', "E500", None),
        ("has(t.state.M) ? t.state.M.n", "has(t.signal.M) ? t.signal.M.n", "E524", None),
        ("(near)", "near", "E102", "a name and ':' begin the next agents: write (near) for the value"),
        ("true ? 1", "n > 1 ? 1", "E200", None),
        ("low = n > 2 ? n < 9 : false", "low = n > 2 ? n : false", "E500", None),
    ],
)
def test_what_is_wrong_there_is_one_mistake(old: str, new: str, code: str, hint: str | None) -> None:
    assert old in GIVEN
    found = [item for item in analysis(GIVEN.replace(old, new)).diagnostics if item.code[0] == "E"]
    assert [item.code for item in found] == [code]
    assert hint is None or found[0].hint == hint
