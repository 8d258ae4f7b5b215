"""Regular expressions: none that old Pythons get wrong, and none that takes exponential time."""

from __future__ import annotations

import re
from re import _constants as op  # type: ignore[attr-defined]
from re import _parser  # type: ignore[attr-defined]
from typing import Any

import pytest

from tests.support.ambiguity import exponential
from tests.support.patterns import all_patterns


def operators(parts: Any) -> set[Any]:
    """All operators that occur in a parsed expression."""
    found = set()
    todo = [parts]
    while todo:
        part = todo.pop()
        if isinstance(part, tuple | list | _parser.SubPattern):
            todo += list(part)
        elif isinstance(part, type(op.LITERAL)):
            found.add(part)
    return found


def forbidden(text: str | bytes, flags: int = 0) -> set[Any]:
    return operators(_parser.parse(text, flags)) & {op.POSSESSIVE_REPEAT, op.ATOMIC_GROUP}


def test_that_the_expressions_are_found() -> None:
    found = {pattern.where for pattern in all_patterns()}
    assert len(found) > 300
    assert any(where.startswith("grammar ControlToken") for where in found)
    assert "aseme_dsl.runtime.message.acl_text _STRING" in found
    assert any(where.startswith("lexer") for where in found)


@pytest.mark.parametrize("text", [r"(a*+)b", r"(?>a|b)", r"((?:x|y)?+)", r"a{2,3}+"])
def test_that_what_is_forbidden_is_recognised(text: str) -> None:
    assert forbidden(text)


def test_no_possessive_quantifier_and_no_atomic_group() -> None:
    """`re` of Python 3.11.0 to 3.11.2, Debian 12's own, gets them wrong inside a group."""
    assert [str(item) for item in all_patterns() if forbidden(item.text, item.flags)] == []


@pytest.mark.parametrize(
    "text",
    [
        r"(a*)*b",
        r"(a|a)*b",
        r"(?:[A-Za-z_]\w*|[^{}A-Za-z_])*}",
        r'\{ (?: [a-z]\w* | [^{}"a-z_] )* \}',
        r"(?:\.(?:[ ]*|\s+(?!x))\w+)*y",
        r"x(?=(a+)+b)",
        r"(a?b?)*c",
    ],
)
def test_that_the_analysis_finds_exponential_expressions(text: str) -> None:
    assert exponential(text, re.VERBOSE)


@pytest.mark.parametrize(
    "text",
    [
        r"a*a*a*b",  # cubic, and no more
        r'"(?:[^"\\]|\\.)*"',
        r"(?:[A-Za-z_]\w*\b|[^{}A-Za-z_])*}",
        r"[0-9]+(?:\.[0-9]+)*",
        r"/\*[\s\S]*?\*/",
        r"(?:[^*]|\*(?!/))*x",
    ],
)
def test_that_the_analysis_finds_no_others(text: str) -> None:
    assert exponential(text, re.VERBOSE) is None


def test_no_expression_can_be_matched_in_exponentially_many_ways() -> None:
    """All in one test: to find them takes two seconds, which every worker would need to list the tests."""
    found = {str(item): item.text for item in all_patterns() if exponential(item.text, item.flags)}
    assert found == {}
