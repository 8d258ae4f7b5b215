"""Contents in SL (FIPA SC00008): what is read, what is written, and a second reader made of the grammar."""

from __future__ import annotations

import math
import os
import re
from datetime import UTC, datetime
from functools import cache
from typing import Any

import pytest
from arpeggio import NoMatch, ParserPython, ZeroOrMore
from arpeggio import OneOrMore as Some
from arpeggio import RegExMatch as Token
from hypothesis import given, settings
from hypothesis import strategies as st

from aseme_dsl.runtime.message.acl import Span
from aseme_dsl.runtime.message.acl_text import AclTextError
from aseme_dsl.runtime.message.sl import LONGEST, OPERATORS, Form, Variable, dumps, loads

EXAMPLES = int(os.environ.get("ACL_EXAMPLES", "100"))
DF = Form("agent-identifier", (), (("name", "df"),))
READ = {
    "((action (agent-identifier :name df) (get-description)))": (
        Form("action", (DF, Form("get-description"))),
    ),
    "((iota ?x (result a ?x)))": (Form("iota", (Variable("x"), Form("result", ("a", Variable("x"))))),),
    "( true\n(p 0x1F +3 -1.5e1 20260131T120000000Z) )": (
        "true",
        Form("p", (31, 3, -15.0, datetime(2026, 1, 31, 12, tzinfo=UTC))),
    ),
    '((p "say \\"hi\\"" #3"a"b +00000000T000010000))': (
        Form("p", ('say "hi"', 'a"b', Span(milliseconds=10_000))),
    ),
    "((p (set) (sequence a (set 1)) (f :x 1 :y (g))))": (
        Form(
            "p",
            (
                Form("set"),
                Form("sequence", ("a", Form("set", (1,)))),
                Form("f", (), (("x", 1), ("y", Form("g")))),
            ),
        ),
    ),
}
WRONG = {
    "": "line 1, column 1: a content begins with '('",
    "()": "line 1, column 2: the content has no expression",
    "(a": "line 1, column 3: a term is wanted here, not the end",
    "(a) b": "line 1, column 5: something follows after the message",
    "(1)": "line 1, column 2: an action or a proposition is wanted here",
    "((set a))": "line 1, column 2: an action or a proposition is wanted here",
    "((f :a 1))": "line 1, column 2: an action or a proposition is wanted here",
    "((p (f a :b 1)))": "line 1, column 5: f has terms and parameters; it can have one of both",
    "((p (f :a 1 :a 2)))": "line 1, column 13: :a is given twice",
    "((p (set :a 1)))": "line 1, column 5: a set has no parameters",
    "((action a))": "line 1, column 2: action has 1 terms; it takes 2",
    "((done a))": "line 1, column 2: done takes an action",
    "((iota x (result a b)))": "line 1, column 2: iota begins with a variable, such as ?x",
    "((iota ?x 1))": "line 1, column 2: iota ends with a proposition",
    "((p -a))": "line 1, column 5: a term is wanted here, not -a",
    "((()))": "line 1, column 3: a name is wanted here, not '('",
    '((p "a))': "line 1, column 5: the string has no end",
    "((p" + " (f" * 100: "line 1, column 149: it is nested more than 50 deep",
    "((p 20261399T000000000))": (
        "line 1, column 5: 20261399T000000000 is not a moment: month must be in 1..12"
    ),
}


@pytest.mark.parametrize("text", READ)
def test_what_is_read(text: str) -> None:
    found = loads(text)
    assert found == READ[text]
    assert loads(dumps(*found)) == found


@pytest.mark.parametrize("text", WRONG)
def test_what_is_no_content(text: str) -> None:
    with pytest.raises(AclTextError) as problem:
        loads(text)
    assert str(problem.value) == WRONG[text]


def test_a_long_content_is_not_read() -> None:
    with pytest.raises(AclTextError, match="1000000 are read at the most"):
        loads("(" + "a " * LONGEST + ")")


@pytest.mark.parametrize(
    ("term", "reason"),
    [
        (Form("p", (b"\xff",)), "is not a text in UTF-8"),
        (Form("p", (math.nan,)), "nan is not a number of SL"),
        (Form("p q", ("a",)), "is not a word"),
        (Form("p", (), (("a b", 1),)), "cannot be a name"),
        (Form("p", ("\ud800",)), "is not a text"),
        (Form("done", ("a",)), "done takes an action"),
    ],
)
def test_what_has_no_text(term: Form, reason: str) -> None:
    with pytest.raises(AclTextError, match=reason):
        dumps(term)


def test_a_deep_term_has_no_text() -> None:
    term: Any = "a"
    for _ in range(60):
        term = Form("f", (term,))
    with pytest.raises(AclTextError, match="more than 50 deep"):
        dumps(term)


# ---- at random -----------------------------------------------------------------------------------

names = st.from_regex(r"[a-z][a-z0-9@./:\-]{0,8}", fullmatch=True).filter(
    lambda name: name not in (*OPERATORS, "set", "sequence")
)
strings = st.text(st.characters(codec="utf-8"), max_size=8)
constants = st.one_of(
    strings,
    names,
    st.integers(-(10**20), 10**20),
    st.floats(allow_nan=False, allow_infinity=False),
    st.builds(Span, st.integers(0, 9), st.integers(0, 99), st.integers(0, 99), st.integers(0, 10**7)),
    st.sampled_from(["true", "+5", "5", "20260131T120000000", "?x", ":a", '#1"a', "", "a\\", "-"]),
)


def forms(inner: st.SearchStrategy[Any]) -> st.SearchStrategy[Any]:
    few = st.lists(inner, max_size=3).map(tuple)
    return st.one_of(
        st.builds(Form, names, few),
        st.builds(Form, st.sampled_from(["set", "sequence"]), few),
        st.builds(
            Form,
            names,
            st.just(()),
            st.dictionaries(names, inner, max_size=3).map(lambda d: tuple(d.items())),
        ),
        st.builds(lambda a, b: Form("action", (a, b)), inner, inner),
    )


terms = st.recursive(constants, forms, max_leaves=8)
actions = st.builds(lambda a, b: Form("action", (a, b)), terms, terms)
expressions = st.one_of(
    actions,
    names,
    st.builds(Form, names, st.lists(terms, min_size=1, max_size=3).map(tuple)),
    st.builds(lambda a, b: Form("result", (a, b)), terms, terms),
    st.builds(lambda a: Form("done", (a,)), actions),
)


@settings(max_examples=EXAMPLES, deadline=None)
@given(st.lists(expressions, min_size=1, max_size=3))
def test_what_is_written_is_read_again(found: list[Any]) -> None:
    text = dumps(*found)
    assert loads(text) == tuple(found)
    assert "#" in text or "=" in text or second_reader(text)


# ---- another reader, made of the grammar of SC00008 ------------------------------------------------


@cache
def _grammar() -> ParserPython:
    """SL0 as section 3 of SC00008 has it, rule by rule; strings with their length aside."""
    end = r"(?=[\x00-\x20()])"
    number = r"[+-]?([0-9]+\.[0-9]*|\.[0-9]+|[0-9]+)([eE][+-]?[0-9]+)?" + end
    hexadecimal = r"[+-]?0[xX][0-9A-Fa-f]+" + end
    name = r'[^\x00-\x20()#0-9:\-?"][^\x00-\x20()]*'
    word = f"(?!{number}|{hexadecimal}){name}"
    # The symbol of a proposition is a String, which may be a StringLiteral.
    quoted = r'"(?:[^\x00-\x20()#0-9:\-?"\\]|\\(?!"))(?:[^\x00-\x20()"\\]|\\"|\\(?!"))*"'

    def content() -> Any:
        return "(", Some(expression), ")", Token(r"\Z")

    def expression() -> Any:
        return [action, proposition]

    def proposition() -> Any:
        return [
            ("(", Token(r"done(?=[\x00-\x20(])"), action, ")"),
            ("(", Token(r"result(?=[\x00-\x20(\"])"), term, term, ")"),
            ("(", symbol, Some(term), ")"),
            Token(word),
            Token(quoted),
        ]

    def action() -> Any:
        return "(", Token(r"action(?=[\x00-\x20(\"])"), term, term, ")"

    def symbol() -> Any:
        return Token(r"(?!(action|result|done|=|iota|any|all|set|sequence)[\x00-\x20()])" + name)

    def term() -> Any:
        return [
            action,
            ("(", Token(r"(set|sequence)(?=[\x00-\x20()\"])"), ZeroOrMore(term), ")"),
            ("(", symbol, Some(Token(r":[^\x00-\x20()]+"), term), ")"),
            ("(", symbol, ZeroOrMore(term), ")"),
            constant,
        ]

    def constant() -> Any:
        return [
            Token(r'"(?:[^"\\]|\\"|\\(?!"))*"'),
            Token(r"[+-]?\d{8}T\d{9}[A-Za-z]?(?=[\x00-\x20()])"),
            Token(hexadecimal),
            Token(number),
            Token(word),
        ]

    return ParserPython(content, skipws=True, ws="".join(map(chr, range(33))), memoization=True)


def second_reader(text: str) -> bool:
    try:
        _grammar().parse(text)
    except NoMatch:
        return False
    return True


pieces = st.lists(
    st.sampled_from(
        [
            *"(())  ",
            "action ",
            "done ",
            "result ",
            "set ",
            "sequence ",
            "a ",
            "b",
            ":x ",
            "1 ",
            '"s" ',
            "0x2 ",
        ]
    ),
    max_size=14,
).map("".join)


@settings(max_examples=EXAMPLES, deadline=None)
@given(pieces | st.lists(expressions, min_size=1, max_size=2).map(lambda found: dumps(*found)), st.data())
def test_both_readers_agree(text: str, data: Any) -> None:
    """Of what is written, with a piece taken out or doubled, and of pieces in any order."""
    if "#" in text or "=" in text or len(text) > 200:
        return
    at = data.draw(st.integers(0, len(text)))
    to = data.draw(st.integers(at, min(len(text), at + 3)))
    text = text[:at] + data.draw(st.sampled_from(["", text[at:to] * 2])) + text[to:]
    # Which days there are, and which numbers a float holds, is no matter of the grammar.
    if re.search(r"\d{8}T|e\+\d{3}", text):
        return
    try:
        loads(text)
        read = True
    except AclTextError:
        read = False
    assert read == second_reader(text), text
