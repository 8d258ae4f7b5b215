"""`given` and `result` in the models, and what is wrong with them."""

from __future__ import annotations

import pytest

from aseme_dsl.amola.expression import expression_text
from tests.support.compiling import codes, system

DELIVERY = """system House
enum Ending { NONE DONE }
message Job { string id }
topic t { state Job  signal Job }
aip delivery {
  participant courier {
    given low : bool
    given load : double
    result ending : Ending
    process = Consider . [Carry]
  }
  control courier {
    enter Carry : [!low && load < 3] / ending = Ending.DONE
    skip  Carry : else
  }
}
srm robot {
  plays delivery.courier WITH
  var last : Ending
  var other : int
  liveness { robot = courier . [Rest] }
  control robot { enter Rest : [last == Ending.DONE && other < 1] / other = other + 1  skip Rest : else }
}
"""
SOUND = "with low = has(t.state.Job), load = max(other, 2) / 4, ending = last"


def test_the_models_have_what_is_supplied() -> None:
    found = system(DELIVERY.replace("WITH", SOUND))
    plays = found.srms[0].plays[0]
    assert [name for name, _ in plays.inputs] == ["low", "load"]
    assert plays.results == (("ending", "last"),)
    chart = found.iac("robot")
    assert chart is not None
    texts = [expression_text(item.expression) for item in chart.transitions]
    assert "[!low && load < 3] / ending = Ending.DONE" in texts
    assert [text for text in texts if "last = ending" in text] == ["/ last = ending"]
    assert [item.name for item in chart.variables if item.scope] == ["ending@0.2"]
    eac = found.eac("delivery")
    assert eac is not None
    names = {item.name.partition("@")[0] for item in eac.variables}
    assert names == {"low", "load", "ending"}


@pytest.mark.parametrize(
    ("said", "code"),
    [
        ("with load = 1, ending = last", "E590"),
        ("", "E590"),
        ("with low = has(t.signal.Job), load = 1", "E592"),
        ("with low = random() < 1, load = 1", "E526"),
        ("with low = 3, load = 1", "E500"),
        ("with low = true, load = 1, ending = other", "E591"),
        ("with low = true, load = 1, ending = Ending.DONE", "E591"),
        ("with low = true, load = 1, ending = Last", "E591"),
        ("with low = true, load = 1, ending = last, low = false", "E206"),
        ("with low = true, load = 1, Carry = 3 + 4", "E206"),
        ("with low = true, load = 1, lows = true", "E206"),
        ("with low = nothing, load = 1", "E200"),
    ],
)
def test_what_is_wrong_with_what_is_supplied(said: str, code: str) -> None:
    found = codes(DELIVERY.replace("WITH", said))
    assert code in found
    assert len(set(found) - {"N437", "W410", "N727"}) <= 2, found


@pytest.mark.parametrize(
    ("old", "new", "code"),
    [
        ("given low : bool", "given low : bytes", "E500"),
        ("given load : double", "given ending : double", "E201"),
        ("/ ending = Ending.DONE", "/ low = true", "E5"),
        ("given low : bool", "given true : bool", "E106"),
    ],
)
def test_what_is_wrong_with_an_input(old: str, new: str, code: str) -> None:
    assert any(item.startswith(code) for item in codes(DELIVERY.replace("WITH", SOUND).replace(old, new)))


def test_the_new_words_may_be_names() -> None:
    text = """system S
aip p {
  participant a { var given : int = 1  var result : int  process = result . given_up  result = A . given }
}
srm r { plays p.a  liveness { r = a } }
"""
    assert not [code for code in codes(text) if code.startswith("E")]


def test_one_wrong_input_is_said_once() -> None:
    text = DELIVERY.replace("WITH", SOUND).replace("given low : bool", "given low : bytes")
    assert [code for code in codes(text) if code.startswith("E")] == ["E500"]


LOOPS = """system House
aip p {
  participant a { process = A . (B~ [> Stop) }
  control a { enter Stop : after(3s) }
}
srm r {
  plays p.a with B = work
  liveness { r = a  work = WORK }
  activities { A takes 1s  Stop takes 1s }
}
"""


@pytest.mark.parametrize(
    ("work", "code"),
    [
        ("X . Y", None),
        ("[X]", "E593"),
        ("[X] . other  other = Y*", "E593"),
        ("X . a", "E300"),
        ("X . work", "E300"),
        ("X . other  other = Y . [a]", "E300"),
        ("X[20000]", "E304"),
    ],
)
def test_formulas_that_cannot_stand_for_an_activity(work: str, code: str | None) -> None:
    found = [item for item in codes(LOOPS.replace("WORK", work)) if item.startswith("E")]
    assert found == ([] if code is None else [code])


def test_an_activity_whose_outcome_counts_is_no_formula() -> None:
    text = (
        LOOPS.replace("WORK", "X . Y")
        .replace("process = A . (B~", "process = B . (B~")
        .replace(
            "enter Stop : after(3s)", "enter (B~ [> Stop) : [outcome(B) == good]  enter Stop : after(3s)"
        )
        .replace("activities {", "activities { B ends good, bad ")
    )
    assert "E593" in codes(text)


def test_the_formula_has_the_parameters_of_the_activity() -> None:
    text = LOOPS.replace("B~", "B(1)~").replace("activities {", "activities { B(n : int) ")
    assert "E525" in codes(text.replace("WORK", "X . Y"))
    assert "E525" in codes(text.replace("WORK", "X").replace("work =", "work(n : bool) ="))
    assert not [
        c for c in codes(text.replace("WORK", "X").replace("work =", "work(k : int) =")) if c[0] == "E"
    ]


def test_a_formula_may_be_called_like_the_activity_that_it_refines() -> None:
    text = (
        LOOPS.replace("B~", "Carry~").replace("B = work", "Carry = carry").replace("work = WORK", "carry = X")
    )
    assert codes(text) == []


MESSAGE = """system House
message Job { int id }
message Other { int id }
topic t { state Job }
aip delivery {
  participant courier { given job : Job  process = Carry . [Rest] }
  control courier { enter Rest : [job.MEMBER > 1]  skip Rest : else }
}
srm robot {
  var now : Job
  plays delivery.courier with job = GIVEN
  liveness { robot = courier }
  control robot { enter courier : / now = t.state.Job }
}
"""


@pytest.mark.parametrize(
    ("given", "member", "expected"),
    [
        ("now", "id", []),
        ("t.state.Job", "id", []),
        ("now", "ids", ["E501"]),
        ("now.id > 1 ? now : t.state.Job", "id", []),
        ("3", "id", ["E500"]),
    ],
)
def test_an_input_that_is_a_message(given: str, member: str, expected: list[str]) -> None:
    text = MESSAGE.replace("GIVEN", given).replace("MEMBER", member)
    assert [code for code in codes(text) if code[0] == "E"] == expected
