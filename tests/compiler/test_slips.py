"""One slip gives one message, where the slip is: of seeded one-token slips in the acceptance programs."""

from __future__ import annotations

from itertools import islice
from pathlib import Path

from aseme_dsl.compiler import analyse
from aseme_dsl.diagnostics import Severity
from aseme_dsl.source import Source
from tests.support.mutations import slips

ACCEPTANCE = sorted((Path(__file__).parents[1] / "acceptance").glob("*.aseme"))
EACH = 60


def test_a_slip_gives_one_error_on_its_line() -> None:
    """At least 95 in 100 mistakes give exactly one error; in at least 92 it is on the line of the slip.

    `python benchmarks/mutations.py` tells more, with other seeds.
    """
    mistakes = alone = there = 0
    for path in ACCEPTANCE:
        for slip in islice(slips(path.read_text("utf-8"), seed=2), EACH):
            found = analyse(Source(path.name, slip.text)).diagnostics
            errors = [item for item in found if item.severity is Severity.ERROR]
            if errors:
                mistakes += 1
                alone += len(errors) == 1
                there += errors[0].span is not None and errors[0].span.line == slip.line
    assert mistakes > 2 * EACH
    assert alone / mistakes >= 0.95
    assert there / mistakes >= 0.92
