"""Bounds of variables: what the compiler says of them, and where the models have them."""

from __future__ import annotations

import pytest

from aseme_dsl.amola.as_json import models_json
from aseme_dsl.compiler import analyse
from aseme_dsl.source import Source
from tests.support.generated import system_of

ROLE = """system S
srm r {{
  var n : {declared}
  liveness {{ r = A . B }}
  activities {{ A takes 1s  B takes 1s }}
  control r {{ enter A : / n = n + 1  enter B : [{condition}] / {action} }}
}}
team T {{ a : r{setting} }}
"""


def text(
    declared: str = "int 0..3", action: str = "n = 2", condition: str = "n == 1", setting: str = ""
) -> str:
    return ROLE.format(declared=declared, action=action, condition=condition, setting=setting)


def told(written: str) -> list[tuple[str, str, str]]:
    """Code, underlined text and message of what is wrong."""
    found = analyse(Source("one.aseme", written)).diagnostics
    return [(item.code, item.span.text, item.message) for item in found if item.code[0] != "N"]


def test_what_is_inside_is_fine() -> None:
    assert [code for code, _, _ in told(text()) if code[0] == "E"] == []
    assert [code for code, _, _ in told(text("double -1.5..2 = 0.5")) if code[0] == "E"] == []


@pytest.mark.parametrize(
    ("written", "code", "place", "message"),
    [
        (text(action="n = 4"), "E516", "4", "`n` cannot be 4: its bounds are 0..3"),
        (text(action="n = 1 - 2"), "E516", "1 - 2", "`n` cannot be -1: its bounds are 0..3"),
        (text("int 0..3 = 5"), "E516", "5", "`n` cannot be 5: its bounds are 0..3"),
        (text("int 1..3"), "E516", "1..3", "`n` would begin with 0, outside of its bounds 1..3"),
        (text(setting=" with n = 7"), "E516", "7", "`n` cannot be 7: its bounds are 0..3"),
        (text("int 3..0"), "E518", "3..0", "no number is within 3..0"),
        (text("int 0..1.5"), "E518", "0..1.5", "the bounds of the int `n` have a fraction"),
        (
            text('string 0..3 = ""', 'n = "a"', "true").replace("n + 1", '"b"'),
            "E518",
            "0..3",
            "a string has no bounds",
        ),
    ],
)
def test_what_does_not_fit_is_said_once(written: str, code: str, place: str, message: str) -> None:
    assert told(written)[0] == (code, place, message)
    assert [item for item in told(written) if item[0][0] == "E"] == [(code, place, message)]


def test_the_checks_of_conditions_know_them() -> None:
    """A choice whose branches leave nothing within the bounds has no gap."""
    choice = """system S
srm r {{
  var n : int {bounds}
  liveness {{ r = A . (B | C) }}
  activities {{ A takes 1s  B takes 1s  C takes 1s }}
  control r {{ enter A : / n = n + 1  enter B : [n <= 1]  enter C : [n >= 2 && n <= 3] }}
}}
"""
    assert [code for code, _, _ in told(choice.format(bounds="0..3"))] == []
    assert [code for code, _, _ in told(choice.format(bounds="0..4"))] == ["W411"]


def test_the_models_have_them() -> None:
    models = models_json(system_of(text()))
    wanted = {"least": 0, "most": 3}
    for name in ("iac.r.json", "srm.r.json"):
        [variable] = models[name]["variables"]  # type: ignore[misc]
        assert variable["bounds"] == wanted


RESULT = """system S
message M { int x }
aip p {
  participant a { result n : int 0..3  sends inform M  process = Say }
  participant b { receives inform M  process = Hear }
  control a.process { leave Say : / n = n + 1; send inform M { x = 1 } to b }
  control b.process { enter Hear : inform M from a }
}
srm one { var k : int%s  plays p.a with n = k  liveness { one = a } }
srm two { plays p.b  liveness { two = b } }
team T { x : one  y : two }
"""


def test_a_result_and_its_variable_have_the_same_bounds() -> None:
    found = told(RESULT % " 0..9")
    assert "E591" in [code for code, _, _ in found]
    assert "E591" not in [code for code, _, _ in told(RESULT % " 0..3")]
