"""How one-token slips are answered: `python benchmarks/mutations.py [SLIPS] [SEED] [FILE ...] [--show N]`.

Every slip goes through the whole compiler. Counted are the slips that make a mistake, i.e. give an error: how
many of them give exactly one, and how many of those have it on the line of the slip.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections import Counter
from itertools import islice
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

from aseme_dsl.compiler import analyse
from aseme_dsl.diagnostics import Severity
from aseme_dsl.source import Source
from tests.support.mutations import KINDS, slips


def main() -> None:
    """Print a table by file and kind, and some of the slips that were answered otherwise."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("number", nargs="?", type=int, default=400, help="slips a file")
    parser.add_argument("seed", nargs="?", type=int, default=1)
    parser.add_argument("files", nargs="*", type=Path)
    parser.add_argument(
        "--show", type=int, default=0, metavar="N", help="show N answers that are not as wished"
    )
    options = parser.parse_args()
    files = options.files or sorted((Path(__file__).parents[1] / "tests" / "acceptance").glob("*.aseme"))
    total: Counter[tuple[str, str]] = Counter()
    slowest = 0.0
    shown = 0
    for path in files:
        text = path.read_text("utf-8")
        for slip in islice(slips(text, options.seed), options.number):
            begun = time.process_time()
            found = analyse(Source(str(path), slip.text)).diagnostics
            slowest = max(slowest, time.process_time() - begun)
            errors = [item for item in found if item.severity is Severity.ERROR]
            total[slip.kind, "slips"] += 1
            if not errors:
                total[slip.kind, "no mistake" if not _warned(found) else "a warning"] += 1
                continue
            there = errors[0].span is not None and errors[0].span.line == slip.line
            total[slip.kind, "errors"] += 1
            total[slip.kind, "one"] += len(errors) == 1
            total[slip.kind, "there"] += there
            if shown < options.show and (len(errors) > 1 or not there):
                shown += 1
                print(f"{path.name}:{slip.line}: {slip.kind} {slip.token!r}")
                for item in errors[:4]:
                    place = item.span.line if item.span else "-"
                    print(f"    {place}: {item.code} {item.message}")
    print(f"{'':10}{'slips':>8}{'errors':>8}{'exactly one':>14}{'on its line':>14}{'no error':>10}")
    for kind in (*KINDS, "all"):
        counts = Counter({k: n for (other, k), n in total.items() if other == kind})
        if kind == "all":
            counts = Counter()
            for (_, k), n in total.items():
                counts[k] += n
        errors = max(1, counts["errors"])
        fine = counts["no mistake"] + counts["a warning"]
        one, there = 100 * counts["one"] / errors, 100 * counts["there"] / errors
        print(f"{kind:10}{counts['slips']:8}{counts['errors']:8}{one:12.1f} %{there:12.1f} %{fine:10}")
    print(f"slowest: {slowest:.2f} s of CPU time")


def _warned(found: tuple[object, ...]) -> bool:
    return bool(found)


if __name__ == "__main__":
    main()
