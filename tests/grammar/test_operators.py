"""The one table of operators: what is written in it is what parser, layout, size limit and reference say."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from aseme_dsl.amola.liveness import canonical
from aseme_dsl.amola.operators import INFIX, Fixity, Operator, with_number
from aseme_dsl.grammar.layout import format_source
from aseme_dsl.source import Source
from tests.grammar.reading import formula, mistakes
from tests.support.compiling import codes, role_chart

LANGUAGE = Path(__file__).parents[2] / "docs" / "reference" / "language"
CONTROL = {Operator.DISABLING: "control R { enter B : after(1s) }"}
"""What an operator needs beside its operands."""
WRITTEN = [item for item in Operator if item not in (Operator.NAME, Operator.HOLE)]


def written(operator: Operator, sign: str) -> str:
    """An example of the operator with one of its signs."""
    sign = with_number(sign, 3)
    if operator.row.fixity is Fixity.INFIX:
        return f"A {sign} B"
    return sign.replace(" ", "A") if " " in sign else f"A{sign}"


@pytest.mark.parametrize("operator", WRITTEN)
def test_every_sign_is_read_and_laid_out_as_the_operators_own(operator: Operator) -> None:
    own = written(operator, operator.value)
    for sign in (operator.value, *operator.row.spellings):
        text = written(operator, sign)
        made = formula(text)
        assert (made.operator, canonical(made)) == (operator, own)
        around = "srm R {{\n  liveness {{\n    f = {}\n  }}\n}}\n"
        laid_out = format_source(Source("test.aseme", around.format(text.replace("A", " A "))))
        assert laid_out.text == around.format(text if text.startswith("|") else own)


@pytest.mark.parametrize("operator", WRITTEN)
def test_the_size_limit_counts_the_states_that_the_chart_has(operator: Operator) -> None:
    role = f"R = {written(operator, operator.value)}"
    chart = role_chart(role, CONTROL.get(operator, ""))
    text = f"system T srm R {{ liveness {{ {role} }} {CONTROL.get(operator, '')} }}"
    assert "E304" not in codes(text, largest=len(chart.states))
    assert "E304" in codes(text, largest=len(chart.states) - 1)


def test_the_reference_gives_the_infix_operators_from_the_tightest_to_the_loosest() -> None:
    text = " ".join((LANGUAGE / "formulas.md").read_text("utf-8").split())
    sentence = re.search(r"From the tightest to the loosest: .*?\. A", text)
    assert sentence is not None
    said = re.findall(r"`([^`]+)`", sentence[0])
    postfix = [item.value for item in Operator if item.row.fixity is Fixity.POSTFIX]
    infix = [item.value for item in INFIX if item is not Operator.HOLE]
    assert said == [*postfix, *infix]


@pytest.mark.parametrize("operator", INFIX)
def test_a_missing_colon_of_control_is_found_behind_the_whole_term(operator: Operator) -> None:
    text = f"srm R {{ liveness {{ R = A . B }} control R {{ enter A {operator} B [true] }} }}"
    messages = [item.message for item in mistakes(text) if item.code == "E100"]
    assert messages == ["expected ':' after 'B', found '['"]


def test_no_two_infix_operators_bind_equally() -> None:
    assert sorted(operator.row.precedence for operator in INFIX) == list(range(len(INFIX)))
