"""`n += 1`, `n -= 1`, `n *= 2`: actions that change a variable."""

from dataclasses import replace

import pytest

from aseme_dsl.amola.expression import Action, Assign, action_text
from tests.support.compiling import analysis, codes, system

TEXT = """
system S
message M {{ int n }}
topic t {{ state M }}
srm r {{
  var n : int = 7
  var a : int = 5
  var d : double = 1.5
  var p : duration = 1s
  var b : bool = false
  let half = n
  liveness {{ r = Go . Stop }}
  activities {{ Go takes 1s simulated  Stop takes 1s simulated }}
  control r {{
    enter Stop : [n > 0 && a > 0 && d > 0 && p > 0s && !b && t.state.M.n > -1] / {actions}
  }}
}}
"""


def texts(actions: str) -> list[str]:
    (chart,) = system(TEXT.format(actions=actions)).iacs
    return [action_text(item) for way in chart.transitions for item in way.expression.actions]


@pytest.mark.parametrize(
    ("short", "long"),
    [
        ("n += 1", "n = n + 1"),
        ("n -= a - 2", "n = n - (a - 2)"),
        ("n *= a - 2", "n = n * (a - 2)"),
        ("n -= -a", "n = n - -a"),
        ("d += n", "d = d + n"),
        ("p *= 2", "p = p * 2"),
        ("p += 500ms", "p = p + 500ms"),
        ("n += a; n += n", "n = n + a; n = n + n"),
    ],
)
def test_it_means_the_same_as_the_long_form(short: str, long: str) -> None:
    one, other = (system(TEXT.format(actions=item)).iacs[0] for item in (short, long))
    pairs = zip(one.transitions, other.transitions, strict=True)
    for way, same in pairs:
        for action, whole in zip(way.expression.actions, same.expression.actions, strict=True):
            assert action_text(whole).partition(" = ")[2] == _value(action)


def _value(action: Action) -> str:
    assert isinstance(action, Assign)
    return action_text(replace(action, operator="")).partition(" = ")[2]


@pytest.mark.parametrize(
    ("action", "code", "message"),
    [
        ("n += 0.5", "E506", None),
        ("b += true", "E500", None),
        ("p += 1", "E500", None),
        ("half += 1", "E507", "`half` is a let: it has no value of its own"),
        ("7 += 1", "E102", "only a variable can stand left of '+='"),
        ("t.state.M.n += 1", "E507", "'+=' changes a variable, and this is a member of a message that"),
        ("n +=", "E102", None),
        ("m += 1", "E200", None),
    ],
)
def test_what_cannot_be_changed_is_reported(action: str, code: str, message: str | None) -> None:
    found = [item for item in analysis(TEXT.format(actions=action)).diagnostics if item.code[0] == "E"]
    assert [item.code for item in found] == [code]
    assert message is None or found[0].message.startswith(message)


def test_without_a_slash_it_is_said() -> None:
    text = TEXT.format(actions="n = 1").replace("enter Stop : [", "on Go : n -= 1\n    enter Stop : [")
    found = analysis(text).diagnostics
    assert found[0].code == "E102"
    assert [edit.text for edit in found[0].edits] == ["/ "]


def test_old_texts_mean_the_same() -> None:
    assert codes(TEXT.format(actions="n = -a; n = n*-1; n = n- -1; n = n+ +1")) == []
