"""Whether what participants say and wait for can come about: waits that nobody ends, too few agents."""

from __future__ import annotations

from pathlib import Path

import pytest

from aseme_dsl.compiler import analyse
from aseme_dsl.source import Source
from tests.support.compiling import analysis, printed

ROOT = Path(__file__).parents[3]

TALK = """system S
message Note {{ string text }}
aip p {{
  participant a {{ sends cfp Note, inform Note  receives agree Note, refuse Note  process = A . B . C }}
  participant b {multiplicity} {{
    sends agree Note, refuse Note
    receives cfp Note, inform Note
    process = {process}
  }}
  control a {{ {a} }}
  control b {{ {b} }}
}}
srm r {{ plays p.a  liveness {{ r = a }} }}
srm s {{ plays p.b  liveness {{ s = b }} }}
team T {{ one : r  other[1..2] : s }}
"""
ANSWER = "enter X : cfp Note from a / send agree Note to a"
LATE = "enter X : cfp Note from a  enter Y : inform Note from a  leave Y : / send agree Note to a"
LOSS = "enter X : cfp Note from a  enter Y : inform Note from a or lost a / send agree Note to a"
REFUSE = "enter X : cfp Note from a / send refuse Note to a  leave Y : / send agree Note to a"
ASK = "enter A : / send cfp Note to b  enter B : agree Note from b"


def found(a: str = ASK, b: str = ANSWER, **more: str) -> list[str]:
    text = TALK.format(**{"a": a, "b": b, "process": "X . Y", "multiplicity": "[1..*]", **more})
    return [item.code for item in analysis(text).diagnostics if item.code in ("W553", "W554")]


@pytest.mark.parametrize(
    ("a", "b", "waits"),
    [
        (ASK, ANSWER, False),
        # both wait for the other one
        ("enter A : agree Note from b", ANSWER, True),
        # what is waited for is sent only afterwards
        (f"{ASK}  enter C : / send inform Note to b", LATE, True),
        # no line sends it: an activity may
        (ASK, "enter X : cfp Note from a", False),
        # something else ends the wait
        ("enter A : agree Note from b or after(1s)", ANSWER, False),
        ("enter A : agree Note from b  enter A : after(1s)", ANSWER, False),
        (ASK, LOSS, False),
        # a condition may hold: it says to which question an answer belongs
        (f'{ASK} [agree.Note.text == "1"]', ANSWER, False),
        # of two that may come, one can
        (f"{ASK} or refuse Note from b", REFUSE, False),
        # it was sent before somebody waits
        (f"{ASK}  leave C : / send inform Note to b", f"{ANSWER}  enter Y : inform Note from a", False),
    ],
)
def test_a_wait_that_nobody_ends(a: str, b: str, waits: bool) -> None:
    assert found(a, b) == (["W553"] if waits else [])


def test_what_cuts_short_ends_a_wait() -> None:
    a = f"{ASK}  enter C : / send inform Note to b"
    assert found(a, LATE) == ["W553"]
    late = LATE.replace("leave Y", "enter Z : after(5s)  leave Z")
    assert found(a, late, process="(X . Y) [> Z") == []


def test_it_is_said_once_with_all_who_wait() -> None:
    text = TALK.format(a="enter A : agree Note from b", b=ANSWER, process="X . Y", multiplicity="")
    said = printed(text)
    assert said.count("W553") == 1
    assert "deadlock: `a` waits here for `agree Note`, which `b` cannot have sent" in said
    assert "`b` waits here, and cannot continue either" in said


@pytest.mark.parametrize(
    ("multiplicity", "few"),
    [("", False), ("[2]", False), ("[2..*]", False), ("[3..*]", True), ("[3]", True), ("[1..9]", False)],
)
def test_a_team_that_is_too_small(multiplicity: str, few: bool) -> None:
    assert found(multiplicity=multiplicity) == (["W554"] if few else [])


def test_a_participant_that_no_agent_of_the_team_plays() -> None:
    text = TALK.format(a=ASK, b=ANSWER, process="X . Y", multiplicity="")
    items = {item.code: item for item in analysis(text.replace("  other[1..2] : s", "")).diagnostics}
    assert items["W554"].message == "`b` of `p` wants 1 agent at least, and no agent of T plays it"
    assert "N728" not in items, "one cause, one message"
    optional = text.replace("participant b ", "participant b [0..*] ").replace("  other[1..2] : s", "")
    codes = {item.code for item in analysis(optional).diagnostics}
    assert "W554" not in codes and "N728" in codes


def test_simulated_activities_send_nothing() -> None:
    quiet = "activities { A takes 1s simulated  B takes 1s simulated  C takes 1s simulated "
    quiet += "X takes 1s simulated  Y takes 1s simulated }"
    text = TALK.format(a=ASK, b="enter X : cfp Note from a", process="X . Y", multiplicity="")
    text = text.replace("liveness { r = a }", "liveness { r = a } " + quiet)
    assert "W553" in {item.code for item in analysis(text).diagnostics}
    one = text.replace("Y takes 1s simulated", "Y takes 1s")
    assert "W553" not in {item.code for item in analysis(one).diagnostics}
    bound = text.replace("plays p.b ", "plays p.b with Y = Write ")
    assert "W553" not in {item.code for item in analysis(bound).diagnostics}, "this one may send"


def test_who_opens_the_conversation_does_not_invite_itself() -> None:
    text = TALK.format(a=ASK, b=ANSWER, process="X . Y", multiplicity="[2..*]")
    both = text.replace("plays p.b  liveness { s = b }", "plays p.b, p.a  liveness { s = b || a }")
    both = both.replace("one : r  other[1..2]", "other[1..2]")
    assert "W554" in {item.code for item in analysis(both).diagnostics}
    assert "W554" not in {item.code for item in analysis(both.replace("1..2", "1..3")).diagnostics}


def test_nothing_is_said_of_what_is_right() -> None:
    """The acceptance files, the examples, and whoever plays all protocols of the library."""
    files = [*ROOT.glob("tests/acceptance/*.aseme"), *ROOT.glob("examples/*/*.aseme")]
    assert len(files) > 8
    for path in files:
        codes = {item.code for item in analyse(Source(str(path), path.read_text("utf-8"))).diagnostics}
        assert codes.isdisjoint({"W553", "W554"}), path
