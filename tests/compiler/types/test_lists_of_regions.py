"""W440: parallel parts that change one list."""

from __future__ import annotations

import pytest

from tests.support.compiling import analysis

TEXT = """system S
srm r {{
  var xs : list of int
  var n : int = 0
  liveness {{ r = (first || second) . C  first = A~  second = B~ }}
  activities {{ A takes 1s  B takes 1s  C takes 1s reads xs }}
  control first {{ repeat A : / {first} }}
  control second {{ repeat B : / {second} }}
}}
"""


def told(first: str, second: str) -> list[tuple[str, list[str]]]:
    """The place of the warning, and the other ones that it shows."""
    found = [
        item for item in analysis(TEXT.format(first=first, second=second)).diagnostics if item.code == "W440"
    ]
    return [(item.span.text if item.span else "", [one.span.text for one in item.related]) for item in found]


@pytest.mark.parametrize(
    ("first", "second"),
    [
        ("append(xs, 1)", "append(xs, 2)"),
        ("n = 1; remove(xs[0])", "xs[0] = 3"),
        ("xs[0] += 1", "remove(xs, 1)"),
    ],
)
def test_both_places_are_said(first: str, second: str) -> None:
    one, other = first.split("; ")[-1], second
    assert told(first, second) == [(other, [one])]


@pytest.mark.parametrize(
    ("first", "second"),
    [
        ("append(xs, 1)", "n += size(xs)"),
        ("n = 1", "append(xs, 1); append(xs, 2)"),
        ("append(xs, 1)", "xs = []"),
    ],
)
def test_one_part_may_change_it(first: str, second: str) -> None:
    assert told(first, second) == []
