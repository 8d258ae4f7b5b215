"""The page on security says nothing that is not tested."""

from __future__ import annotations

from tests.security.lines import lines_of_tests, lines_of_the_page


def test_each_line_of_the_page_has_a_test() -> None:
    lines = lines_of_the_page()
    tests = lines_of_tests()
    assert [cells for cells in lines if cells not in tests] == []
    assert [where for cells, where in tests.items() if cells not in lines] == []
    assert len(lines) == len(set(lines))
