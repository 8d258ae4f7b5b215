"""Holes: what is still to be chosen is noted, and nothing is made of it."""

from __future__ import annotations

import pytest

from aseme_dsl.compiler import analyse
from aseme_dsl.compiler.formula.holes import as_notes
from aseme_dsl.grammar.layout import format_source
from aseme_dsl.source import Source


def codes(text: str) -> list[tuple[str, str]]:
    analysis = analyse(Source("t.aseme", text))
    assert analysis.system is None
    return [(item.code, item.span.text if item.span else "") for item in as_notes(analysis.diagnostics)]


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("srm r { liveness { r = A ? B } }", [("E109", "?")]),
        ("srm r { liveness { r = A ?OP? B } }", [("E109", "?OP?")]),
        # Nothing that an operator would decide is said: `A~` might stand beside B.
        (
            "srm r { liveness { r = A~ ? B  } control r { enter B : after(1s) skip B : [?] } }",
            [("E109", "?")] * 2,
        ),
        ("srm r { liveness { r = A ? b  b = C ? D . E ? F } }", [("E109", "?")] * 3),
        ("srm r { liveness { r = (A | B) } control r { enter A : [?] enter B : [?] } }", [("E109", "?")] * 2),
        (
            "srm r { liveness { r = A . B } control r { enter B : when [?] / x = 1 } var x : int }",
            [("E109", "?")],
        ),
        (
            "statechart r { state 0 OR  state 0.1 START  state 0.2 BASIC A  state 0.3 END\n"
            "0.1 -> 0.2 :\n0.2 -> 0.3 : [?] }",
            [("E109", "?")],
        ),
    ],
)
def test_each_hole_is_a_note_and_nothing_else_is_said(text: str, found: list[tuple[str, str]]) -> None:
    assert codes(f"system S\n{text}\n") == found


def test_an_option_is_not_a_question_mark() -> None:
    (problem,) = analyse(Source("t.aseme", "system S srm r { liveness { r = A? . B } }")).diagnostics
    assert problem.code == "E101" and problem.hint is not None and problem.hint.startswith("write [A]")


def test_a_condition_is_a_hole_wholly_or_not_at_all() -> None:
    text = "system S srm r { liveness { r = A . B } control r { enter B : [? && true] } }"
    assert [item.code for item in analyse(Source("t.aseme", text)).diagnostics] == ["E102"]


def test_the_layout_keeps_holes() -> None:
    text = "system S\nsrm r {\n  liveness { r=A?(B|C) }\n  control r { enter B:[?] enter C:when[?] }\n}\n"
    laid = format_source(Source("t.aseme", text))
    assert laid.diagnostics == ()
    assert "r = A ? (B | C)" in laid.text and "enter B : [?]" in laid.text and "when [?]" in laid.text
    assert format_source(Source("t.aseme", laid.text)).text == laid.text
