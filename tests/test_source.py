"""Places in a text."""

from __future__ import annotations

from aseme_dsl.source import Source, Span


def test_lines_and_columns_count_from_one_in_code_points() -> None:
    source = Source("a.aseme", "äb\r\nc\n")
    assert source.position(0) == (1, 1)
    assert source.position(1) == (1, 2)
    assert source.position(4) == (2, 1)
    assert source.position(6) == (3, 1)
    assert source.line(1) == "äb"
    assert source.line(3) == ""


def test_a_span_says_where_it_is() -> None:
    source = Source("a.aseme", "one\ntwo three\n")
    span = Span(source, 4, 7)
    assert (str(span), span.text) == ("a.aseme:2:1", "two")
    assert span.to(Span(source, 8, 13)).text == "two three"
