"""W436: concurrent parts that wake each other for ever, where that is certain."""

from __future__ import annotations

import pytest

from aseme_dsl.runtime.chart import chart
from tests.oracle.choices import Choices
from tests.support.compiling import analysis
from tests.support.generated import generate


def found(inside: str, before: str = "") -> list[tuple[int, int]]:
    text = f"system S\n{before}\nsrm R {{\n{inside}\n}}\n"
    return [
        (item.span.line, item.span.column)
        for item in analysis(text).diagnostics
        if item.code == "W436" and item.span is not None
    ]


LAMP = """var lamp : bool = false
liveness { R = on || off  on = On~  off = Off~ }
activities { On takes 1s  Off takes 1s }
control on { repeat On : when [!lamp] / lamp = true }
"""


def test_two_parts_that_toggle_one_variable() -> None:
    assert found(LAMP + "control off { repeat Off : when [lamp] / lamp = false }") == [(7, 14)]


def test_two_parts_that_count_up() -> None:
    inside = """var n : int = 0  var m : int = 0
    liveness { R = a || b  a = A~  b = B~ }
    activities { A takes 1s  B takes 1s }
    control a { repeat A : when [n > m] / m = n }
    control b { repeat B : when [n == m] / n = n + 1 }"""
    assert len(found(inside)) == 1


def test_three_parts_in_a_ring_beside_one_that_has_nothing_to_do_with_it() -> None:
    inside = """var turn : int = 0
    liveness { R = Rest . (a || b || c || Other)  a = A~  b = B~  c = C~ }
    activities { A takes 1s  B takes 1s  C takes 1s  Other takes 1s  Rest takes 1s }
    control a { repeat A : when [turn == 0] / turn = 1 }
    control b { repeat B : when [turn == 1] / turn = 2 }
    control c { repeat C : when [turn == 2] / turn = 0 }"""
    assert len(found(inside)) == 1


@pytest.mark.parametrize("action", ["append(seen, 1)", "clear(seen)", "chance = random()"])
def test_what_no_condition_can_know_is_written_on_the_way(action: str) -> None:
    variables = "var seen : list[3] of int  var chance : double = 0.5\n"
    text = variables + LAMP.replace("lamp = true", f"lamp = true; {action}")
    assert found(text + "control off { repeat Off : when [lamp] / lamp = false }") == []


COMES_TO_REST = {
    "one of them waits for completion": "control off { repeat Off : [lamp] / lamp = false }",
    "one of them takes time": "control off { repeat Off every 1s : when [lamp] / lamp = false }",
    "an event may be needed": "control off { repeat Off : go [lamp] / lamp = false }",
    "nothing changes back": "control off { repeat Off : when [lamp] / lamp = true }",
    "a message decides": "control off { repeat Off : when [lamp && !t.state.M.on] / lamp = false }",
    "a function decides": "control off { repeat Off : when [lamp && free()] / lamp = false }",
    "it is left first": (
        "control off { repeat Off : when [lamp] / lamp = false }"
        " control R { leave (on || off) : when [!lamp] }"
    ),
}
BEFORE = 'message M { bool on }  topic t { state M }  function free() : bool = "m:free"'


@pytest.mark.parametrize("why", COMES_TO_REST)
def test_what_comes_to_rest_or_may(why: str) -> None:
    assert found(LAMP + COMES_TO_REST[why], BEFORE) == []


def test_a_count_that_ends() -> None:
    inside = """var n : int = 0  var m : int = 0
    liveness { R = a || b  a = A~  b = B~ }
    activities { A takes 1s  B takes 1s }
    control a { repeat A : when [n > m && n < 50] / m = n }
    control b { repeat B : when [n == m] / n = n + 1 }"""
    assert found(inside) == []


def test_an_activity_may_write_the_variable() -> None:
    inside = LAMP.replace("Off takes 1s", "Off takes 1s writes lamp")
    assert found(inside + "control off { repeat Off : when [lamp] / lamp = false }") == []


def test_the_team_may_set_the_variable() -> None:
    inside = LAMP + "control off { repeat Off : when [lamp] / lamp = false }"
    assert found(inside, "team T { ann : R { lamp = true } }") == []


WAYS = (
    "[b] / b = false",
    "[!b] / b = true",
    "[i == 0] / i = 1",
    "[i == 1] / i = 2; k = 1",
    "[i == 2] / i = 0",
    "[i != k] / k = i",
    "[i == k] / k = (k + 1) % 3; b = !b",
    "[i > 1 && b] / i = 0",
)
"""Conditions with actions after which they do not hold."""


def _random(choices: Choices) -> str:
    """A role with concurrent loops over a few variables."""
    names = [f"p{number}" for number in range(choices.number(2, 4))]
    lines = ["system S srm R {", "var i : int = 0 var k : int = 1 var b : bool = false"]
    lines += [f"liveness {{ R = {' || '.join(names)}", *(f"{name} = X{name}~" for name in names), "}"]
    lines += ["activities {", *(f"X{name} takes 1s" for name in names), "}"]
    for name in names:
        when = choices.one_of(("when ", "when ", "when ", ""))
        lines += [f"control {name} {{ repeat X{name} : {when}{choices.one_of(WAYS)} }}"]
    return "\n".join([*lines, "}"])


@pytest.mark.parametrize("group", range(4))
def test_what_is_reported_never_rests_and_what_is_not_does(group: int) -> None:
    """Of these programs the compiler knows everything."""
    both = set()
    for seed in range(group, 60, 4):
        text = _random(Choices(seed))
        agent = generate(text).chart("R", "me")
        steps = 1
        while agent.step(0, ()).again and steps < chart.ROUNDS:
            steps += 1
        reported = "W436" in {item.code for item in analysis(text).diagnostics}
        if agent.failure is None:  # else a part does not rest within one step
            assert reported is (steps == chart.ROUNDS), text
            both.add(reported)
    assert both == {True, False}


def test_lists_that_grow_in_a_part_that_wakes_another() -> None:
    inside = """var notes : list[3] of int  var k : int = 0
    liveness { R = a || b  a = A~  b = B~ }
    control a { repeat A : when [k > 0] / append(notes, k); k = k + 1 }
    control b { repeat B : when [k < 5] / k = k + 1 }"""
    assert found(inside) == []
