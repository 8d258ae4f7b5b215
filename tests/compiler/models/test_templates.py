"""The template of every operator, label by label, as the language's table gives it."""

from __future__ import annotations

import pytest

from aseme_dsl.amola.statechart import Statechart
from tests.support.compiling import role_chart


def inside(chart: Statechart, label: str) -> list[str]:
    """The children of a state: `0.1 START`, `0.2 BASIC A`."""
    return [
        f"{node.label} {node.type}{'' if node.name == node.label else ' ' + node.name}"
        for node in chart.children(label)
    ]


def arrows(chart: Statechart, *parents: str) -> list[str]:
    """The transitions whose source is a child of one of `parents`, in the order of the chart."""
    return [
        f"{item.source}->{item.target}"
        for item in chart.transitions
        if chart.node(item.source).parent in parents
    ]


def spread(text: str) -> list[str]:
    return [part.strip() for part in text.split(",")]


ONE_NODE = {
    "A . B . C": (
        "0.1 START, 0.2 BASIC A, 0.3 BASIC B, 0.4 BASIC C, 0.5 END",
        "0.1->0.2, 0.2->0.3, 0.3->0.4, 0.4->0.5",
    ),
    "A | B": (
        "0.1 START, 0.2 CONDITION, 0.3 BASIC A, 0.4 BASIC B, 0.5 END",
        "0.1->0.2, 0.2->0.3, 0.2->0.4, 0.4->0.5, 0.3->0.5",
    ),
    "A | B | C": (
        "0.1 START, 0.2 CONDITION, 0.3 BASIC A, 0.4 BASIC B, 0.5 BASIC C, 0.6 END",
        "0.1->0.2, 0.2->0.3, 0.2->0.4, 0.2->0.5, 0.5->0.6, 0.4->0.6, 0.3->0.6",
    ),
    "A [> B": (
        "0.1 START, 0.2 BASIC A, 0.3 BASIC B, 0.4 END",
        "0.1->0.2, 0.2->0.3, 0.2->0.4, 0.3->0.4",
    ),
    "A [> B [> C": (
        "0.1 START, 0.2 OR A [> B, 0.3 BASIC C, 0.4 END",
        "0.1->0.2, 0.2->0.3, 0.2->0.4, 0.3->0.4",
    ),
    "A*": (
        "0.1 START, 0.2 CONDITION, 0.3 BASIC A, 0.4 END",
        "0.1->0.2, 0.2->0.3, 0.3->0.3, 0.2->0.4, 0.3->0.4",
    ),
    "A+": ("0.1 START, 0.2 BASIC A, 0.3 END", "0.1->0.2, 0.2->0.2, 0.2->0.3"),
    "A~": ("0.1 START, 0.2 BASIC A", "0.1->0.2, 0.2->0.2"),
    "[A]": ("0.1 START, 0.2 CONDITION, 0.3 BASIC A, 0.4 END", "0.1->0.2, 0.2->0.3, 0.2->0.4, 0.3->0.4"),
    "A": ("0.1 START, 0.2 BASIC A, 0.3 END", "0.1->0.2, 0.2->0.3"),
    "(A)": ("0.1 START, 0.2 BASIC A, 0.3 END", "0.1->0.2, 0.2->0.3"),
    "((A . B))": ("0.1 START, 0.2 BASIC A, 0.3 BASIC B, 0.4 END", "0.1->0.2, 0.2->0.3, 0.3->0.4"),
}


@pytest.mark.parametrize("formula", ONE_NODE)
def test_the_template_of_an_operator(formula: str) -> None:
    children, transitions = ONE_NODE[formula]
    chart = role_chart(f"R = {formula}")
    assert inside(chart, "0") == spread(children)
    assert arrows(chart, "0") == spread(transitions)
    assert chart.root.name == "R" and chart.root.type == "OR"


def test_the_template_of_a_choice_whose_branches_interrupt() -> None:
    """With `enter B` and `enter C` alone; a line that names the choice keeps the template of `A [> B`."""
    lines = "enter B : b  enter (C . D) : c"
    chart = role_chart("R = A [> (B | (C . D))", f"control R {{ {lines} }}")
    children = ["0.1 START", "0.2 BASIC A", "0.3 BASIC B", "0.4 OR (C . D)", "0.5 END"]
    assert inside(chart, "0") == children
    assert arrows(chart, "0") == spread("0.1->0.2, 0.2->0.3, 0.2->0.4, 0.2->0.5, 0.3->0.5, 0.4->0.5")
    chart = role_chart(
        "R = A [> (B | C)", "control R { enter (B | C) : d  enter B : [true]  enter C : else }"
    )
    assert inside(chart, "0") == ["0.1 START", "0.2 BASIC A", "0.3 OR (B | C)", "0.4 END"]


@pytest.mark.parametrize(
    ("formula", "name", "terms"),
    [
        ("A || B", "A || B", ["A", "B"]),
        ("A[3]", "A[3]", ["A"] * 3),
        ("|A~|2", "A~[2]", ["A~"] * 2),
        ("A || A", "A || A", ["A", "A"]),
    ],
)
def test_the_template_of_concurrency(formula: str, name: str, terms: list[str]) -> None:
    chart = role_chart(f"R = {formula}")
    assert inside(chart, "0") == ["0.1 START", f"0.2 AND {name}", "0.3 END"]
    expected = ["0.1->0.2", "0.2->0.3"]
    for number, term in enumerate(terms, 1):
        region = f"0.2.{number}"
        kind = "OR" if "~" in term else "BASIC"
        assert inside(chart, "0.2")[number - 1] == f"{region} OR"
        assert inside(chart, region) == [f"{region}.1 START", f"{region}.2 {kind} {term}", f"{region}.3 END"]
        expected += [f"{region}.1->{region}.2", f"{region}.2->{region}.3"]
    assert arrows(chart, "0", *(f"0.2.{n}" for n in range(1, len(terms) + 1))) == expected


@pytest.mark.parametrize(
    ("operand", "name", "children"),
    [
        ("(A . B)", "(A . B)", "START, BASIC A, BASIC B, END"),
        ("((A | B))", "(A | B)", "START, CONDITION, BASIC A, BASIC B, END"),
        ("[A . B]", "[A . B]", "START, CONDITION, OR A . B, END"),
        ("[(A . B)]", "[(A . B)]", "START, CONDITION, OR (A . B), END"),
        ("(A | B)+", "(A | B)+", "START, OR (A | B), END"),
        ("(A+)", "(A+)", "START, BASIC A, END"),
        ("(A+)~", "(A+)~", "START, OR (A+)"),
        ("sub", "sub", "START, BASIC X, BASIC Y, END"),
        ("(sub)", "sub", "START, BASIC X, BASIC Y, END"),
        ("sub+", "sub+", "START, OR sub, END"),
        ("alias", "alias", "START, BASIC X, BASIC Y, END"),
        ("only", "only", "START, BASIC Z, END"),
    ],
)
def test_an_operand_has_a_node_of_its_own(operand: str, name: str, children: str) -> None:
    formulas = f"R = Q . {operand}\n"
    if "sub" in operand or operand == "alias":
        formulas += "sub = X . Y\n"
    if operand == "alias":
        formulas += "alias = sub\n"
    if operand == "only":
        formulas += "only = Z\n"
    chart = role_chart(formulas)
    assert inside(chart, "0")[2] == f"0.3 OR {name}"
    assert [child.split(" ", 1)[1] for child in inside(chart, "0.3")] == spread(children)


def test_an_activity_in_parentheses_is_the_activity() -> None:
    assert inside(role_chart("R = Q . (A)"), "0")[2] == "0.3 BASIC A"


def test_a_formula_is_expanded_each_time_it_stands() -> None:
    chart = role_chart("R = sub . sub || sub\nsub = X . Y")
    assert [node.label for node in chart.states if node.name == "X"] == [
        "0.2.1.2.2.2",
        "0.2.1.2.3.2",
        "0.2.2.2.2",
    ]


def test_an_activity_may_stand_any_number_of_times() -> None:
    chart = role_chart("R = A . (A | kick | Kick) . A~")
    assert [node.label for node in chart.states if node.activity == "A"] == ["0.2", "0.3.3", "0.4.2"]
    assert [node.activity for node in chart.children("0.3")][2:5] == ["A", "kick", "Kick"]


def test_transitions_are_named_after_their_ends() -> None:
    names = [item.name for item in role_chart("R = (A | B) . C").transitions]
    assert names[:3] == ["0.1TO(A | B)", "(A | B)TOC", "CTO0.4"]
    assert names[3:] == ["0.2.1TO0.2.2", "0.2.2TOA", "0.2.2TOB", "BTO0.2.5", "ATO0.2.5"]


def test_more_than_nine_children_stay_in_order() -> None:
    chart = role_chart("R = " + " . ".join(f"A{n}" for n in range(12)))
    assert [node.label for node in chart.states][-3:] == ["0.12", "0.13", "0.14"]


def test_states_and_transitions_say_where_they_come_from() -> None:
    chart = role_chart("R = Q . sub\nsub = X . Y")
    assert {str(chart.node(label).origin) for label in ("0", "0.1", "0.2")} == {"formula R.R"}
    assert {str(chart.node(label).origin) for label in ("0.3", "0.3.1", "0.3.2")} == {"formula R.sub"}
    assert chart.node("0.3").span.text == "sub"
    assert chart.node("0.3.2").span.text == "X"


@pytest.mark.parametrize(
    ("formula", "states", "levels"),
    [
        ("[" * 500 + "A" + "]" * 500, 1 + 500 * 4, 501),
        ("(" * 500 + "A" + ")" * 500, 4, 2),
        (" . ".join(f"A{n}" for n in range(1000)), 1003, 2),
        (" | ".join(f"A{n}" for n in range(1000)), 1004, 2),
        (" || ".join(f"A{n}" for n in range(1000)), 4 + 4000, 4),
    ],
    ids=["options 500 deep", "groups 500 deep", "1000 in sequence", "1000 choices", "1000 concurrent"],
)
def test_depth_and_width_are_no_problem(formula: str, states: int, levels: int) -> None:
    chart = role_chart(f"R = {formula}")
    assert (len(chart.states), chart.levels) == (states, levels)


def test_a_chain_of_a_thousand_formulas() -> None:
    lines = [f"f{n} = A{n} . f{n + 1}" for n in range(999)]
    chart = role_chart("\n".join([*lines, "f999 = B . C"]))
    assert len(chart.states) == 999 * 4 + 5
