"""Twice the text is twice the work, for every token and in every block that is not closed."""

from __future__ import annotations

import time

import pytest

from aseme_dsl.grammar import parse
from aseme_dsl.grammar.text.recovery import BLOCKS
from aseme_dsl.source import Source

BEGINNINGS = {
    "JunkDeclaration": "system S\n",
    "JunkConstant": "enum E { A",
    "JunkField": "message M { int a",
    "JunkTopic": "topic t { state M",
    "JunkActor": "sag { actor a { goal g }",
    "JunkGoal": "sag { actor a { goal g",
    "JunkSuc": "suc { usecase u",
    "JunkAip": "aip P { clause A",
    "JunkParticipant": "aip P { participant p { process = A",
    "JunkControl": "srm r { control c { enter A . B",
    "JunkSrm": "srm r { plays a.b",
    "JunkFormula": "srm r { liveness { a = A",
    "JunkActivity": "srm r { activities { A reads a",
    "JunkModule": "srm r { modules { A writes a",
    "JunkFunctionality": "srm r { functionality f { technology",
    "JunkChart": "statechart c { state 0 OR",
    "JunkAgents": "team { agent a : r",
    "let": "let x = f(",
    "var": "srm r { var x : int = 1",
    "send": "srm r { control c { enter A : [a] / send inform M { a = b",
    "write": "srm r { control c { enter A : / write_messages.t.state.M { a = b, c",
}
"""A block of each kind, or an expression, that is not closed."""

PIECES = {
    "name": "a",
    "names": " a",
    "lines": "\na",
    "number": "1",
    "numbers": " 12",
    "durations": " 1s",
    "units": " 3sec",
    "label": ".1",
    "labels": "1 -> 2 : ",
    "path": ".a",
    "path with blanks": ". a",
    "path on lines": ".\n a",
    "texts": ' "a"',
    "text": '"',
    "escapes": '\\"',
    "comment": "//",
    "comments": "/* */",
    "open comments": "/*",
    "blanks": " ",
    "newlines": "\n",
    "operators": " || a",
    "bars": "|",
    "parentheses": "(a ",
    "brackets": "[a ",
    "braces": " a {",
    "closed": "}",
    "closed on lines": "\n}",
    "both": "{}",
    "placeholders": "?_?",
    "odd": "é",
    "quotes": "‘",
    "apostrophes": "'",
    "commas": ", a",
    "colons": " a :",
    "equals": " a =",
    "formulas": " a(b) = ",
    "verbs": " enter",
    "later verbs": " on a",
    "entries": "enter a : ",
    "messages": " send inform M { ",
    "writings": " write_messages.a.b.c { ",
    "declarations": "\nsrm r {",
    "not these": "!",
    "infinite": "ω",
    "words": "word1 word2, ",
}


def work(text: str) -> float:
    """The seconds of a processor that it takes to read the text."""
    begun = time.process_time()
    parse(Source("test.aseme", text))
    return time.process_time() - begun


def test_that_there_is_a_beginning_for_each_kind_of_block() -> None:
    assert set(BLOCKS) <= set(BEGINNINGS)


@pytest.mark.parametrize("beginning", BEGINNINGS.values(), ids=list(BEGINNINGS))
def test_the_work_grows_as_the_text_does(beginning: str) -> None:
    for name, piece in PIECES.items():
        # As exponential work would never end, the text grows by little at first.
        for length in (4, 8, 13):
            short, long = work(beginning + piece * length), work(beginning + piece * 2 * length)
            assert long < 40 * short + 0.1, name
        # Four times the text is four times the work; sixteen times would be quadratic. A machine that is
        # busy may make one measurement useless, and not all of them.
        assert any(
            work(beginning + piece * 800) < 9 * work(beginning + piece * 200) + 0.01 for _ in range(5)
        ), name
