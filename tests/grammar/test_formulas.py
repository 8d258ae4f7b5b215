"""Liveness formulas: operators, precedence, depth, and an independent reader to compare with."""

from __future__ import annotations

import re
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from aseme_dsl.amola.liveness import Formula, canonical, walk
from aseme_dsl.amola.operators import Operator
from tests.grammar.reading import declared, formula, mistakes, nodes


@pytest.mark.parametrize(
    ("text", "spelled"),
    [
        ("A", "A"),
        ("A.B", "A . B"),
        ("A . B | C || D", "A . B | C || D"),
        ("A||B||C", "A || B || C"),
        ("A . (B . C)", "A . (B . C)"),
        ("(((A . B)))", "(A . B)"),
        ("[ [A] ]", "[[A]]"),
        ("([(A)])", "([(A)])"),
        ("A ~ * +", "A~*+"),
        ("A ω | B^ω|C~", "A~ | B~ | C~"),
        ("Aω || (B | C)ω || [D]ω", "A~ || (B | C)~ || [D]~"),
        ("A[3]", "A[3]"),
        ("A [ 12 ]", "A[12]"),
        ("|A~|3", "A~[3]"),
        ("|A | B|2 . C", "A | B[2] . C"),
        ("| |A|2 . B |3", "A[2] . B[3]"),
        ("A || |B|2", "A || B[2]"),
        ("A\n  .\n  B", "A . B"),
        ("A[>B", "A [> B"),
        ("A~[>[B]", "A~ [> [B]"),
        ("A . B | C || D [> E", "A . B | C || D [> E"),
        ("A [> B [> C", "A [> B [> C"),
        ("A [> (B [> C)", "A [> (B [> C)"),
    ],
)
def test_spelling(text: str, spelled: str) -> None:
    assert canonical(formula(text)) == spelled


def test_the_tree_of_a_formula() -> None:
    made = formula("Sensors~ || (initialize . [activate])")
    assert made.operator is Operator.PARALLEL
    loop, group = made.operands
    assert (loop.operator, loop.operands[0].name) == (Operator.FOREVER, "Sensors")
    assert group.operator is Operator.GROUP
    sequence = group.operands[0]
    assert [part.operator for part in sequence.operands] == [Operator.NAME, Operator.OPTION]


def test_instances_have_a_count_and_the_whole_as_span() -> None:
    for text in ("A~[3]", "|A~|3"):
        made = formula(text)
        assert (made.operator, made.count, made.span.text) == (Operator.INSTANCES, 3, text)
        assert made.operands[0].operator is Operator.FOREVER


def test_every_part_has_its_span() -> None:
    made = formula("( A  .B* )|[ C||D[2] ]")
    spans = {canonical(node): node.span.text for node in walk(made)}
    assert spans == {
        "(A . B*) | [C || D[2]]": "( A  .B* )|[ C||D[2] ]",
        "(A . B*)": "( A  .B* )",
        "A . B*": "A  .B*",
        "A": "A",
        "B*": "B*",
        "B": "B",
        "[C || D[2]]": "[ C||D[2] ]",
        "C || D[2]": "C||D[2]",
        "C": "C",
        "D[2]": "D[2]",
        "D": "D",
    }


@pytest.mark.parametrize(
    "text",
    [
        "(" * 500 + "A" + ")" * 500,
        "[" * 500 + "A" + "]" * 500,
        "A" + "*" * 500,
        "A" + "[2]" * 500,
        "(A . [B | " * 250 + "C" + "])" * 250,
        "(A || " * 999 + "B" + ")" * 999,
    ],
)
def test_deep_formulas(text: str) -> None:
    assert canonical(formula(text)).count("A") == text.count("A")


@pytest.mark.parametrize("operator", [".", "|", "||"])
def test_wide_formulas(operator: str) -> None:
    made = formula(f" {operator} ".join(f"A{n}" for n in range(1000)))
    assert len(made.operands) == 1000


@pytest.mark.parametrize(
    "text",
    ["(" * 1001 + "A" + ")" * 1001, "[" * 20_000, "A" + "~" * 1001, "A" + "[2]" * 1001, "(A . " * 1200 + "B"],
)
def test_formulas_that_are_too_deep(text: str) -> None:
    [mistake] = mistakes(f"srm a {{ liveness {{ a = {text}\n }} }}")
    assert mistake.code == "E103"


# ---- an independent reader ---------------------------------------------------------------------


def oracle(text: str) -> Any:
    """A formula as nested tuples, read the obvious way: one function a level, recursive."""
    tokens = re.findall(r"\|\||\w+|\S", text)

    def infix(operator: str, inner: Any) -> Any:
        parts = [inner()]
        while tokens and tokens[0] == operator:
            tokens.pop(0)
            parts.append(inner())
        return parts[0] if len(parts) == 1 else (operator, *parts)

    def parallel() -> Any:
        return infix("||", lambda: infix("|", lambda: infix(".", term)))

    def term() -> Any:
        first = tokens.pop(0)
        if first in "([":
            inner = parallel()
            tokens.pop(0)
            made = ("group", inner) if first == "(" else ("option", inner)
            if first == "(" and inner[0] == "group":
                made = inner
        else:
            made = ("name", first)
        while tokens and tokens[0] in ("*", "+", "~", "ω", "["):
            operator = tokens.pop(0)
            if operator == "[":
                made = ("count", made, int(tokens.pop(0)))
                tokens.pop(0)
            else:
                made = ("~" if operator == "ω" else operator, made)
        return made

    return parallel()


def as_tuples(made: Formula) -> Any:
    parts = tuple(as_tuples(operand) for operand in made.operands)
    match made.operator:
        case Operator.NAME:
            return ("name", made.name)
        case Operator.GROUP:
            return ("group", *parts)
        case Operator.OPTION:
            return ("option", *parts)
        case Operator.INSTANCES:
            return ("count", *parts, made.count)
    return (made.operator.value, *parts)


names = st.sampled_from(["A", "B", "Kick_ball", "x1", "_y", "enter", "srm"])
blanks = st.sampled_from(["", " ", "\n  ", " /* c */ "])
formulas = st.recursive(
    names,
    lambda inner: st.one_of(
        st.tuples(inner, blanks, st.sampled_from([".", "|", "||"]), blanks, inner).map("".join),
        st.tuples(st.sampled_from("(["), blanks, inner, blanks).map(
            lambda parts: "".join(parts) + {"(": ")", "[": "]"}[parts[0]]
        ),
        st.tuples(
            names, blanks, st.lists(st.sampled_from(["*", "+", "~", " ω ", "[3]"]), max_size=3).map("".join)
        ).map("".join),
        st.tuples(inner, st.sampled_from("*+~")).map(lambda parts: f"({parts[0]}){parts[1]}"),
    ),
    max_leaves=25,
)


@settings(max_examples=300)
@given(formulas)
def test_any_formula_is_read_as_the_obvious_reader_reads_it(text: str) -> None:
    plain = re.sub(r"/\*.*?\*/", " ", text)
    made = formula(text)
    assert as_tuples(made) == oracle(plain)
    again = formula(canonical(made))
    assert canonical(again) == canonical(made)
    assert as_tuples(again) == as_tuples(made)


@given(formulas)
def test_a_term_in_control_is_spelled_as_in_its_formula(text: str) -> None:
    plain = text.replace("enter", "E")
    control = declared(f"srm a {{ control f {{ enter {plain}#2 : }} }}").controls[0]
    term = control.entries[0].term
    assert canonical(term.formula) == canonical(formula(plain))
    assert term.occurrence == 2
    assert list(nodes(control))
