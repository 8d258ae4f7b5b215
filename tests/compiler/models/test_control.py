"""Which transition a control line is: every way of every term."""

from __future__ import annotations

import pytest

from aseme_dsl.amola.expression import expression_text
from aseme_dsl.amola.statechart import Statechart
from tests.support.compiling import analysis, codes, role_chart


def said(chart: Statechart) -> list[str]:
    """The transitions with an expression, in the order in which those of a source are tried."""
    found = []
    for node in chart.states:
        for item in chart.outgoing(node.label):
            if item.expression.span is not None:
                found.append(f"{item.source}->{item.target} {expression_text(item.expression)}".rstrip())
    return found


ACTION = "/ start_timer(t, 1s)"

WAYS = [
    # formula, control line, transitions
    ("A . B . C", "enter A", "0.1->0.2"),
    ("A . B . C", "enter B", "0.2->0.3"),
    ("A . B . C", "leave C", "0.4->0.5"),
    ("A . (B . C)", "enter (B . C)", "0.2->0.3"),
    ("A . (B . C)", "enter B . C", "0.2->0.3"),
    ("A . (B . C)", "leave (B . C)", "0.3->0.4"),
    ("A . (B . C)", "enter B", "0.3.1->0.3.2"),
    ("A . (B . C)", "leave C", "0.3.3->0.3.4"),
    ("A . B . A", "enter A#2", "0.3->0.4"),
    ("A . B . A", "enter A#1", "0.1->0.2"),
    ("A || B", "start R", "0.1->0.2"),
    ("A || B", "finish R", "0.2->0.3"),
    ("A || B", "start (A || B)", "0.1->0.2"),
    ("A || B", "enter B", "0.2.2.1->0.2.2.2"),
    ("A || B", "leave A", "0.2.1.2->0.2.1.3"),
    ("C . (A || B)", "start (A || B)", "0.3.1->0.3.2"),
    ("C . (A || B)", "finish (A || B)", "0.3.2->0.3.3"),
    ("C . (A || B)", "enter (A || B)", "0.2->0.3"),
    ("A[2]", "enter A", "0.2.1.1->0.2.1.2, 0.2.2.1->0.2.2.2"),
    ("A[2]", "finish A[2]", "0.2->0.3"),
    ("A~", "enter A", "0.1->0.2"),
    ("A~", "start R", "0.1->0.2"),
    ("A~", "repeat A", "0.2->0.2"),
    ("B . A~", "enter A", "0.2->0.3"),
    ("B . A~", "enter A~", "0.2->0.3"),
    ("B . A~", "start A~", "0.3.1->0.3.2"),
    ("B . A~", "leave A~", "0.3->0.4"),
    ("A~ || B", "enter A", "0.2.1.1->0.2.1.2"),
    ("(B . A)~", "enter (B . A)", "0.1->0.2"),
    ("B . (A~)", "enter A", "0.2->0.3"),
]

DECIDED = [
    # formula, what decides its choices and loops, way, transition
    ("A | B", "enter B : else", "enter A", "0.2->0.3"),
    ("A | B", "enter A : [true] enter B : else", "leave B", "0.4->0.5"),
    ("A | B", "enter A : [true] enter B : else", "start R", "0.1->0.2"),
    ("C . (A | B)", "enter A : [true] enter B : else", "start (A | B)", "0.3.1->0.3.2"),
    ("C . (A | B)", "enter A : [true] enter B : else", "enter (A | B)", "0.2->0.3"),
    ("[A]", "skip A : else", "enter A", "0.2->0.3"),
    ("[A]", "enter A : else", "skip A", "0.2->0.4"),
    ("[A]", "enter A : [true] skip A : else", "leave A", "0.3->0.4"),
    ("[A]", "enter A : [true] skip A : else", "enter [A]", "0.1->0.2"),
    ("C . [A]", "enter A : [true] skip A : else", "enter [A]", "0.2->0.3"),
    ("C . [A]", "enter A : [true] skip A : else", "start [A]", "0.3.1->0.3.2"),
    ("C . [A]", "skip A : else", "enter A", "0.3.2->0.3.3"),
    ("C . [A]", "enter A : [true] skip A : else", "leave [A]", "0.3->0.4"),
    ("C . A*", "enter A : [true] skip A : else repeat A : [true]", "enter A*", "0.2->0.3"),
    ("C . A*", "enter A : [true] skip A : else repeat A : [true]", "start A*", "0.3.1->0.3.2"),
    ("C . A*", "skip A : else repeat A : [true]", "enter A", "0.3.2->0.3.3"),
    ("C . A*", "enter A : else repeat A : [true]", "skip A", "0.3.2->0.3.4"),
    ("C . A*", "enter A : [true] skip A : else", "repeat A", "0.3.3->0.3.3"),
    ("C . A*", "enter A : [true] skip A : else", "leave A", "0.3.3->0.3.4"),
    ("C . A+", "repeat A : [true]", "enter A", "0.2->0.3"),
    ("C . A+", "repeat A : [true]", "enter A+", "0.2->0.3"),
    ("C . A+", "repeat A : [true]", "start A+", "0.3.1->0.3.2"),
    ("C . A+", "repeat A : else", "leave A", "0.3.2->0.3.3"),
    ("C . A+", "repeat A : [true]", "leave A+", "0.3->0.4"),
    ("A+", "repeat A : [true]", "enter A", "0.1->0.2"),
    ("A+", "repeat A : [true]", "enter A+", "0.1->0.2"),
    ("(A | B)+", "repeat (A | B) : [true] enter A : [true] enter B : else", "enter (A | B)", "0.1->0.2"),
    ("C . [A+]", "skip A+ : else repeat A : [true]", "enter A+", "0.3.2->0.3.3"),
    ("C . [A+]", "skip A+ : else repeat A : [true]", "enter A", "0.3.2->0.3.3"),
    ("C . [A+]", "skip A+ : else enter A : [true] repeat A : [true]", "enter [A+]", "0.2->0.3"),
]


@pytest.mark.parametrize(("formula", "line", "expected"), WAYS, ids=lambda value: str(value))
def test_a_line_is_one_way_of_a_term(formula: str, line: str, expected: str) -> None:
    chart = role_chart(f"R = {formula}", f"control R {{ {line} : {ACTION} }}")
    assert said(chart) == [f"{arrow} {ACTION}" for arrow in expected.split(", ")]


@pytest.mark.parametrize(("formula", "others", "line", "expected"), DECIDED, ids=lambda value: str(value))
def test_a_line_of_a_choice_or_loop(formula: str, others: str, line: str, expected: str) -> None:
    chart = role_chart(f"R = {formula}", f"control R {{ {others} {line} : after(7s) }}")
    assert [item.split(" ")[0] for item in said(chart) if "after(7s)" in item] == [expected]


def test_a_line_counts_wherever_its_formula_is_expanded() -> None:
    chart = role_chart("R = sub . sub\nsub = X . Y", "control sub { enter Y : after(1s) }")
    assert said(chart) == ["0.2.2->0.2.3 after(1s)", "0.3.2->0.3.3 after(1s)"]


def test_terms_are_found_in_the_formulas_own_text_only() -> None:
    chart = role_chart("R = X . sub\nsub = X . Y", "control R { enter X : after(1s) }")
    assert said(chart) == ["0.1->0.2 after(1s)"]


FORMULAS = "R = (sub~ [> Halt)~\nsub = A(n) . [B] . rest\nrest = C | D"
OWN = "exit C : / n = 4 enter B : [n > 2] skip B : else enter C : [n > 1] enter D : else enter A : / n = 1"
WHOLE = "enter Halt : stop leave Halt : go on sub : hit / n = 2 repeat sub :"


@pytest.mark.parametrize("block", ["R", "sub", "rest"])
def test_a_line_may_stand_in_the_block_of_another_formula(block: str) -> None:
    """Its term stands in one formula of the role: the chart is that of a block for each formula."""
    lines = OWN.split(" enter C")
    apart = f"""
        control R {{ {WHOLE} }}
        control sub {{ {lines[0].removeprefix("exit C : / n = 4 ")} enter A : / n = 1 }}
        control rest {{ exit C : / n = 4 enter C{lines[1].removesuffix("enter A : / n = 1")} }}
    """
    declared = "var n : int = 3 activities { A(m : int) takes 1s }"
    one = role_chart(FORMULAS, f"{declared} control {block} {{ {WHOLE} {OWN} }}")
    assert said(one) == said(role_chart(FORMULAS, declared + apart))
    assert [item.priority for item in one.transitions] == [
        item.priority for item in role_chart(FORMULAS, declared + apart).transitions
    ]


def test_a_line_for_a_term_of_several_other_formulas_is_reported() -> None:
    formulas = "R = one . two one = A . B two = C . B . A#2"
    for line in ("enter B : after(1s)", "exit A : / n = 1"):
        text = f"system T srm R {{ var n : int = 1 liveness {{ {formulas} }} control R {{ {line} }} }}"
        (found,) = [item for item in analysis(text.replace("#2", "")).diagnostics if item.code[0] == "E"]
        assert (found.code, found.hint) == (
            "E400",
            "it stands in `one` and `two`: write this line in `control one { … }`, if that one is meant",
        )


def test_what_a_block_says_of_its_choices_is_said_of_its_own_formula() -> None:
    """`reactive` of a block does not reach formulas whose lines stand in it; nor do their weights matter."""
    formulas, declared = "R = A | part\npart = X | Y", "var n : int = 1 control R reactive "
    own, of_part = "enter A : [n > 1] enter part : else", "enter X : weight 3 enter Y : weight 1"
    one = role_chart(formulas, f"{declared} {{ {own} {of_part} }}")
    assert said(one) == said(role_chart(formulas, f"{declared} {{ {own} }} control part {{ {of_part} }}"))


def test_several_lines_of_one_way_are_parallel_transitions_tried_in_order() -> None:
    chart = role_chart("R = A . B", "control R { enter B :  enter B : after(10s)  enter B : [true] }")
    assert said(chart) == ["0.2->0.3 after(10s)", "0.2->0.3 [true]", "0.2->0.3"]
    assert [item.name for item in chart.transitions].count("ATOB") == 3
    assert [item.source for item in chart.transitions] == ["0.1", "0.2", "0.2", "0.2", "0.3"]


def test_a_branch_beside_an_event_is_not_advised_to_be_the_else() -> None:
    """An `else` would be taken at once, before the event can come."""
    for line, advice in (("pressed", "`else` waits for none"), ("[in(A)]", "write `enter C : else`")):
        control = f"control R {{ enter B : {line} enter C : }}"
        text = f"system T srm R {{ liveness {{ R = A . (B | C) }} {control} }}"
        [found] = [item for item in analysis(text).diagnostics if item.code == "E404"]
        assert found.hint is not None and advice in found.hint


def test_priority_is_the_order_of_the_lines_then_the_templates() -> None:
    control = "control R { enter C : [true]  enter A : [false] }"
    text = f"system T srm R {{ liveness {{ R = A | B | C }} {control} }}"
    assert codes(text) == ["E404"]
    chart = role_chart(
        "R = A | B | C | D",
        "control R { enter D : else  enter C : [true]  enter A : after(1s)  enter B : [false] }",
    )
    assert [item.target for item in chart.outgoing("0.2")] == ["0.5", "0.3", "0.4", "0.6"]
    assert [item.priority for item in chart.outgoing("0.2")] == [0, 1, 2, 3]


def test_a_transition_without_condition_comes_after_those_with_one_wherever_it_is_written() -> None:
    chart = role_chart("R = A+", "control R { repeat A : / start_timer(t, 1s)  leave A : after(5s) }")
    assert [item.target for item in chart.outgoing("0.2")] == ["0.3", "0.2"]


def test_a_label_says_what_nothing_else_reaches() -> None:
    text = "control R { 0.2 -> 0.4 : after(1s)  0.2 -> 0.3 : after(2s) }"
    found = analysis(f"system T srm R {{ liveness {{ R = A . B }} {text} }}")
    assert [item.code for item in found.diagnostics] == ["W400", "N724"]
    assert found.system is not None
    chart = found.system.iacs[0]
    assert said(chart) == ["0.2->0.4 after(1s)", "0.2->0.3 after(2s)"]
    assert chart.transitions[-1].name == "ATO0.4"


def test_a_label_line_that_is_a_way_is_no_warning() -> None:
    text = "control R { 0.2 -> 0.3 : [true]  0.2 -> 0.4 : else }"
    assert codes(f"system T srm R {{ liveness {{ R = A | B }} {text} }}", notes=True) == []


@pytest.mark.parametrize(
    "branch", ["enter A : when [true] enter B : else", "enter A : done enter B : after(1s)"]
)
def test_an_event_or_when_decides_a_branch(branch: str) -> None:
    assert codes(f"system T srm R {{ liveness {{ R = A | B }} control R {{ {branch} }} }}") == []


def test_a_formula_without_control_is_a_note_with_what_to_start_from() -> None:
    text = "system T srm R { liveness { R = (A | B) . [C] . D+ } }"
    (note,) = analysis(text).diagnostics
    assert note.code == "N704"
    assert note.hint is not None
    skeleton = note.hint.split("\n", 1)[1]
    found = codes(text[:-1] + skeleton + "\n}", notes=True)
    assert set(found) == {"E109"} and len(found) == skeleton.count("[?]")


def test_an_expression_that_is_wrong_is_no_missing_condition() -> None:
    text = "system T srm R { liveness { R = A | B } control R { enter A : [nonsense]  enter B : else } }"
    assert len(codes(text)) == 1 and codes(text)[0][:2] in ("E2", "E5")
