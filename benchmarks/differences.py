"""Whether `asemec diff` sees mistakes in a model: `python -m benchmarks.differences [NUMBER] [SEED]`.

The mutants are those of `benchmarks.mutants`. Each is compared with its model. One that is not reported as
different plays the scenarios of the model: if one of them notices it, its runs do differ, and it was missed.
A mutant that was missed and reported as equal is an error; one that is undecided is counted.
"""

from __future__ import annotations

import argparse
import sys
from collections import Counter
from itertools import islice
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from aseme_dsl.compiler.phases import inspect_files  # noqa: E402
from aseme_dsl.project.building.project import configuration_for, options_of  # noqa: E402
from aseme_dsl.project.comparing.behaviour import Verdict, behaviour_of  # noqa: E402
from aseme_dsl.project.comparing.elements import elements_of  # noqa: E402
from aseme_dsl.project.comparing.report import Report  # noqa: E402
from aseme_dsl.project.comparing.structure import changes_of  # noqa: E402
from aseme_dsl.project.comparing.versions import Compiled  # noqa: E402
from aseme_dsl.proofs.compare.search import Bounds  # noqa: E402
from benchmarks.mutants import CAUGHT, Candidate, candidates, judge, models  # noqa: E402


def version(candidate: Candidate, text: str | None) -> Compiled:
    """The model of a candidate, or (with its text) the candidate."""
    root = candidate.model.root
    configuration, _ = configuration_for(root)
    sources = {} if text is None else {str(candidate.file): text}
    found = inspect_files(root, sources, options_of(configuration)).analysis
    return Compiled(candidate.model.name, root, configuration, found.system, found.diagnostics)


def compared(candidate: Candidate, seconds: float) -> tuple[str, str]:
    """The verdict on a candidate, and the bounds of what is not different; empty if it does not compile."""
    old, new = version(candidate, None), version(candidate, candidate.mutant.text)
    if old.system is None or new.system is None:
        return "", ""
    structure = changes_of(elements_of(old.system), elements_of(new.system))
    results = behaviour_of(old, new, structure, Bounds(50_000, seconds, 1))
    report = Report(old, new, structure, results)
    return report.verdict.value, "; ".join(item.bounds for item in results if item.bounds != "unchanged")


def main() -> int:
    """Print what was missed and the counts; 1 if a mutant whose runs differ was reported as equal."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("number", nargs="?", type=int, default=100, help="mutants that compile")
    parser.add_argument("seed", nargs="?", type=int, default=1)
    parser.add_argument("--only", metavar="NAME", help="only models whose name contains NAME")
    parser.add_argument("--seconds", type=float, default=10.0, help="budget of each role")
    options = parser.parse_args()
    chosen = [item for item in models() if options.only is None or options.only in item.name]
    counts: Counter[str] = Counter()
    for candidate in islice(candidates(chosen, options.seed), 20 * options.number):
        verdict, bounds = compared(candidate, options.seconds)
        if not verdict:
            counts["not compiled"] += 1
            continue
        counts["compiled"] += 1
        word = verdict
        if verdict != Verdict.DIFFERENT.value:
            found = judge(candidate)
            word = f"{verdict}, {'missed' if found.result == CAUGHT else 'not noticed by scenarios'}"
            mutant = candidate.mutant
            print(f"{candidate.model.name}:{mutant.line}: {mutant.kind}: {word}: {bounds}")
            print(f"    - {mutant.before}\n    + {mutant.after}  {found.by}", flush=True)
        counts[word] += 1
        if counts["compiled"] == options.number:
            break
    for word, count in counts.items():
        print(f"{count:5} {word}")
    return int(counts["equal, missed"] > 0)


if __name__ == "__main__":
    sys.exit(main())
