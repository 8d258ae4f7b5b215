"""Roles that include roles: what they say counts as if it were written in the role that includes them."""

from __future__ import annotations

from typing import Any

import pytest

from aseme_dsl.amola.as_json import models_json
from tests.support.compiling import codes, printed, system

WORLD = """
system Half
message Ball { bool visible  double x }
topic vision { state Ball }
"""

SHARED = """
  var turns : int = 0
  let near  = vision.state.Ball.x < 3
  liveness { search = Turn+ . found }
  activities { Turn every 50ms takes 1s uses legs reads vision.state.Ball writes turns }
  modules { Vision every 33ms writes vision.state.Ball = "robot.vision:Vision" }
  functionality legs { technology "two" }
  capability seeing "It sees." = Turn
  control search {
    repeat Turn  : [turns < 4] / turns = turns + 1
    leave  Turn  : else
    enter  found : [near]
  }
"""

OWN = """
  liveness {
    robot = (search | Rest)~
    found = Kick
  }
  activities { Kick takes 1s uses legs  Rest takes 1s uses legs }
  control robot {
    enter search : [has(vision.state.Ball)]
    enter Rest   : else
  }
"""


def plain(model: Any) -> Any:
    """A model without the places in the text, and without the word `includes`."""
    if isinstance(model, dict):
        return {key: plain(value) for key, value in model.items() if key not in ("span", "includes")}
    return [plain(item) for item in model] if isinstance(model, list) else model


@pytest.mark.parametrize(
    "text",
    [
        f"abstract srm moving {{ {SHARED} }} srm robot {{ includes moving {OWN} }}",
        f"srm robot {{ {OWN} includes moving }} abstract srm moving {{ {SHARED} }}",
        f"abstract srm moving {{ {SHARED} }} abstract srm all {{ includes moving }} "
        f"srm robot {{ includes all, moving {OWN} }}",
    ],
    ids=["directly", "in any order", "on two ways"],
)
def test_a_role_has_what_it_includes_as_if_written_there(text: str) -> None:
    at_once = models_json(system(WORLD + f"srm robot {{ {OWN} {SHARED} }}"))
    included = models_json(system(WORLD + text))
    assert plain(included) == plain(at_once)
    assert codes(WORLD + text, notes=True) == codes(WORLD + f"srm robot {{ {OWN} {SHARED} }}", notes=True)


def test_places_stay_where_they_are_written() -> None:
    text = WORLD + f"abstract srm moving {{ {SHARED} }}\nsrm robot {{ includes moving {OWN} }}"
    chart = system(text).iacs[0]
    turn = next(node for node in chart.states if node.activity == "Turn")
    assert turn.span is not None and turn.span.start < text.index("srm robot")
    assert {node.origin.owner for node in chart.states} == {"robot"}


def test_the_model_says_what_a_role_includes() -> None:
    text = WORLD + f"abstract srm moving {{ {SHARED} }} srm robot {{ includes moving {OWN} }}"
    models = models_json(system(text))
    assert models["srm.robot.json"]["includes"] == ["moving"]
    assert "srm.moving.json" not in models and "iac.moving.json" not in models


def test_a_role_without_a_formula_does_what_it_includes() -> None:
    text = "system S srm a { liveness { a = Walk }  activities { Walk takes 1s } } srm b { includes a }"
    charts = {chart.name: chart for chart in system(text).iacs}
    assert [node.name for node in charts["b"].states] == [node.name for node in charts["a"].states]


def test_a_role_changes_while_it_runs() -> None:
    text = """system S
srm player { liveness { player = Play~ }  activities { Play takes 1s } }
srm goalie { liveness { goalie = Guard~ }  activities { Guard takes 1s } }
srm robot {
  includes player, goalie
  var keeps : bool = false
  liveness { robot = (player | goalie)~ }
  control robot {
    enter goalie : [keeps]
    enter player : else
    repeat (player | goalie) : when [true]
  }
}
team T { one : robot }
"""
    found = system(text)
    assert {node.activity for node in found.iacs[-1].states} == {None, "Play", "Guard"}
    assert "N728" not in codes(text, notes=True), "player and goalie are part of robot"


def test_who_includes_a_role_publishes_as_it() -> None:
    text = """system S
message M { int x }
topic t { state M from player }
srm player { liveness { player = Play }  activities { Play takes 1s writes t.state.M } }
srm robot { includes player  liveness { robot = player }  control robot { } }
team T { one : robot  two : player }
"""
    (rules,) = system(text).topics[0].channels
    assert rules.sources == ("player", "robot")


def test_what_is_taken_over_and_not_used_is_not_reported() -> None:
    text = """system S
aip p { participant a { process = X }  participant b { process = Y } }
abstract srm base {
  plays p.a, p.b
  liveness { one = A  two = B }
  activities { A takes 1s  B takes 1s  X takes 1s }
}
srm robot { includes base  liveness { robot = one . a } }
srm other { includes base  liveness { other = two . b } }
"""
    assert codes(text) == []
    assert "N702" not in codes(text, notes=True)


def test_one_mistake_in_a_shared_text_is_one_message() -> None:
    text = """system S
abstract srm base { liveness { one = A }  control one { enter A : [speed > 1] } }
srm robot { includes base  liveness { robot = one } }
srm other { includes base  liveness { other = one } }
"""
    assert codes(text) == ["E200"]
    assert printed(text).count("speed") == 2  # in the message and in the line that it shows


def test_an_abstract_role_that_nobody_includes_is_read_nevertheless() -> None:
    text = """system S
srm robot { liveness { robot = A } }
abstract srm base { liveness { one = A . open  two = B }  control one { enter A : [speed > 1] } }
"""
    assert codes(text) == ["W550", "E200"]


@pytest.mark.parametrize(
    ("base", "own", "code"),
    [
        ("liveness { one = A }", "liveness { robot = one  one = B }", "E223"),
        ("var n : int = 0", "var n : int = 0", "E223"),
        ("let n = 1", "let n = 1", "E223"),
        ("capability see_all", "capability SeeAll", "E223"),
        ("modules { V every 1s }", "modules { V every 1s }", "E223"),
        ("functionality f { technology \"a\" }", "functionality f { technology \"b\" }", "E223"),
        ("functionality f { technology \"a\" }", "functionality f { technology \"a\" }", None),
        ("plays p.a", "plays p.b as a", "E223"),
        ("plays p.a", "plays p.a", None),
        ("liveness { one = A . B }  control one { enter B : }", "control one { enter B : }", "E223"),
        ("liveness { one = A . B }", "control one { enter B : after(1s) }", None),
        ("activities { A takes 1s }", "activities { A takes 2s }", "E203"),
        ("activities { A takes 1s }", "activities { A as step }", None),
    ],
)  # fmt: skip
def test_a_name_has_one_meaning(base: str, own: str, code: str | None) -> None:
    text = "system S aip p { participant a { process = X } participant b { process = Y } }\n"
    rest = "" if "robot =" in own else "liveness { robot = A . B }"
    found = codes(f"{text} abstract srm base {{ {base} }}\nsrm robot {{ {rest} {own}\n includes base }}")
    assert [item for item in found if item[0] == "E"] == ([code] if code else [])


def test_two_that_do_not_fit_are_told_once() -> None:
    text = """system S
abstract srm a { var n : int = 0 }
abstract srm b { var n : int = 0 }
srm one { includes a, b  liveness { one = A } }
srm two { includes a, b  liveness { two = A } }
"""
    assert codes(text) == ["E223"]


@pytest.mark.parametrize(
    ("text", "code", "hint"),
    [
        ("srm one { includes playr  liveness { one = A } } srm player { liveness { player = B } }", "E207",
         "did you mean `player`?"),
        ("srm one { includes one  liveness { one = A } }", "E222", "abstract srm"),
        ("srm a { includes b  liveness { a = x } }  srm b { includes c }  srm c { includes a }", "E222",
         "a → b → c → a"),
        ("statechart l { state 0 OR l  state 0.1 START  state 0.2 BASIC L  state 0.3 END "
         "0.1 -> 0.2 :  0.2 -> 0.3 : } "
         "srm one { includes l  liveness { one = A } }", "E221", "statechart"),
        ("abstract srm a { liveness { a = X } } srm b { includes a } team T { one : a }", "E224",
         "a role that includes it: `b`"),
        ("abstract srm a { liveness { a = X } }  abstract srm a { liveness { a = X } } srm b { includes a }",
         "E201", "rename"),
    ],
)  # fmt: skip
def test_what_cannot_be_included(text: str, code: str, hint: str) -> None:
    text = "system S\n" + text
    assert codes(text) == [code]
    assert hint in printed(text)


def test_what_is_lost_in_one_role_is_not_missed_in_another() -> None:
    text = """system S
abstract srm base {
  liveness { one = A . . B }
  var n : int = 0
}
srm robot {
  includes base
  liveness { robot = one }
  control one { enter B : [n > 1] }
}
"""
    assert codes(text) == ["E101"]


@pytest.mark.parametrize(
    ("written", "code", "hint"),
    [
        ("abstract role base { }", "E100", "write 'srm'"),
        ("abstrac srm base { }", "E100", "did you mean 'abstract'?"),
        ("abstract base { }", "E100", "'srm'"),
        ("srm one { include base  liveness { one = A } }", "E100", "did you mean 'includes'?"),
        ("srm one { includes  liveness { one = A } }", "E100", ""),
        ("srm one { includes base, liveness { one = A } }", "E100", ""),
    ],
)
def test_slips(written: str, code: str, hint: str) -> None:
    text = "system S\n" + written + "\nsrm last { liveness { last = A } }\nabstract srm base { }"
    found = [item for item in codes(text) if item[0] == "E"]
    assert found == [code], printed(text)
    assert hint in printed(text)


def test_suc_knows_abstract_roles() -> None:
    text = """system S
suc { usecase score by player includes kick }
abstract srm player { liveness { score = Kick } }
srm robot { includes player  liveness { robot = score }  activities { Kick takes 1s } }
"""
    found = system(text)
    assert [(item.name, item.type.value) for item in found.suc.roles] == [("player", "abstract")]
    assert [item.name for item in found.srms[0].capabilities] == ["score"]
    assert codes(text, notes=True) == []
