"""A chart allows exactly the words that its formula allows, and has as many states as the templates say."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from aseme_dsl.amola.liveness import Formula
from aseme_dsl.amola.operators import Operator
from aseme_dsl.amola.statechart import StateType
from aseme_dsl.compiler.chart.flow import check_flow, check_reach
from tests.compiler.models.test_protocols import branch, branch_labels
from tests.support import derivatives, walking
from tests.support.compiling import role_chart, system

LETTERS = "ABC"


@st.composite
def formulas(draw: st.DrawFn, depth: int = 3, names: tuple[str, ...] = tuple(LETTERS)) -> tuple[str, bool]:
    """A formula, and whether it may be empty (then no loop is built on it)."""
    kind = draw(st.sampled_from(["name", "name", "infix", "infix", "group", "option", "loop", "instances"]))
    if depth == 0 or kind == "name":
        return draw(st.sampled_from(names)), False
    if kind == "infix":
        operator = draw(st.sampled_from([" . ", " | ", " || "]))
        parts = draw(st.lists(formulas(depth - 1, names), min_size=2, max_size=3))
        texts = [f"({text})" if draw(st.booleans()) else text for text, _ in parts]
        # Without parentheses the reading may be another one: be careful with loops around it.
        return f"({operator.join(texts)})", any(empty for _, empty in parts)
    text, empty = draw(formulas(depth - 1, names))
    if kind == "group" or (kind == "loop" and empty):
        return f"({text})", empty
    if kind == "option":
        return f"[{text}]", True
    if kind == "instances":
        return f"({text})[2]", empty
    return f"({text}){draw(st.sampled_from('*+~'))}", True


def states(formula: Formula, named: dict[str, Formula], whole: bool = False) -> int:
    """How many states the templates give a term, itself included; of a whole formula, with its own state."""
    inner = formula
    while inner.operator is Operator.GROUP:
        inner = inner.operands[0]
    if inner.operator is Operator.NAME:
        if inner.name in named:
            return states(named[inner.name], named, whole=True)
        return 4 if whole else 1
    parts = [states(operand, named) for operand in inner.operands]
    match inner.operator:
        case Operator.SEQUENCE | Operator.ONE_OR_MORE:
            return 3 + sum(parts)
        case Operator.CHOICE | Operator.OPTION | Operator.ZERO_OR_MORE:
            return 4 + sum(parts)
        case Operator.FOREVER:
            return 2 + sum(parts)
        case Operator.PARALLEL:
            return 4 + sum(3 + part for part in parts)
    return 4 + inner.count * (3 + parts[0])


@given(formulas(2), formulas(1))
@settings(max_examples=80)
def test_a_chart_allows_the_words_of_its_formula(first: tuple[str, bool], second: tuple[str, bool]) -> None:
    text = f"R = {first[0]} . sub\nsub = {second[0]}"
    role = system(f"system T srm R {{ liveness {{ {text} }} }}")
    chart = role.iacs[0]
    named = {item.name: item.formula for item in role.srms[0].formulas}
    assert walking.words(chart, 3) == derivatives.words(
        derivatives.language(named["R"], named), list(LETTERS), 3
    )


@given(formulas(4, ("A", "B", "sub")), formulas(2))
@settings(max_examples=50)
def test_a_chart_has_as_many_states_as_the_templates_say(
    first: tuple[str, bool], second: tuple[str, bool]
) -> None:
    text = f"R = {first[0]} . sub\nsub = C . {second[0]}"
    role = system(f"system T srm R {{ liveness {{ {text} }} }}", largest=100_000)
    chart = role.iacs[0]
    named = {item.name: item.formula for item in role.srms[0].formulas}
    assert len(chart.states) == states(named["R"], named, whole=True)


@given(formulas(4))
@settings(max_examples=50)
def test_a_chart_keeps_the_rules_of_the_papers_tools(formula: tuple[str, bool]) -> None:
    chart = role_chart(f"R = {formula[0]}", largest=100_000)
    assert [node.label for node in chart.states if node.parent is None] == ["0"]
    assert len(chart.by_label) == len(chart.states)
    for node in chart.states:
        kinds = [child.type for child in chart.children(node.label)]
        if node.type is StateType.OR:
            assert kinds.count(StateType.START) == 1 and kinds.count(StateType.END) <= 1
        elif node.type is StateType.AND:
            assert len(kinds) >= 2 and set(kinds) == {StateType.OR}
        else:
            assert not kinds
    for item in chart.transitions:
        assert chart.node(item.source).type is not StateType.END
        assert chart.node(item.target).type is not StateType.START
        assert chart.node(item.source).parent == chart.node(item.target).parent
    assert list(check_reach(chart)) == []
    assert [item.code for item in check_flow(chart) if item.code != "W402"] == []


@pytest.mark.parametrize(
    ("text", "begun", "ended"),
    [
        ("A . B", {"", "A", "AB"}, {"AB"}),
        ("A*", {"", "A", "AA"}, {"", "A", "AA"}),
        ("A~ || B", {"", "A", "B", "AA", "AB", "BA"}, set()),
        ("[A] . B", {"", "A", "B", "AB"}, {"B", "AB"}),
    ],
)
def test_words_that_a_person_can_check(text: str, begun: set[str], ended: set[str]) -> None:
    assert walking.words(role_chart(f"R = {text}"), 2) == (begun, ended)


@given(formulas(3), formulas(2))
@settings(max_examples=40)
def test_a_branch_is_the_protocols_whatever_its_process(
    process: tuple[str, bool], helper: tuple[str, bool]
) -> None:
    text = f"""system T
aip p {{
  participant a {{ var n : int = 0  process = core . help
    core = {process[0]}  help = {helper[0]} }}
  participant b {{ process = X }}
  control a {{ leave help : [n > 0] / n = n + 1 }}
}}
srm R {{ plays p.a  plays p.b  liveness {{ R = Y . part || (a | b)  part = a . a . b }} }}
"""
    found = system(text, largest=100_000)
    expected = branch(found.eacs[0], "0.2.1.2")
    places = [label for label in branch_labels(found.iacs[0]) if found.iacs[0].node(label).name == "a"]
    assert len(places) == 3
    assert [branch(found.iacs[0], label) for label in places] == [expected] * 3
