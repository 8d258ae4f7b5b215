"""Whether scenarios notice mistakes in a model: `python -m benchmarks.mutants [NUMBER] [SEED] [--only NAME]`.

The models are the examples and the acceptance files. Mutants of them (`tests/support/model_mutants.py`) are
drawn with a seed, by turns from every model and of every kind, until NUMBER of them compile. A mutant is
*caught* if a scenario of its model fails, is vacuous or cannot be played. One that is not caught *behaves
otherwise* if what people see of a run (activities, messages, conversations, variables, faults, ends) differs
in some scenario, or in a run of the example in its world, with one of the seeds 1 to 20. The rest behaves as
the model does, as far as these runs show, or since the same code is made of it. Scenarios without chance in
them are compared with two seeds.

What is found is kept in a folder (`--kept`), by the texts that it depends on: a further call goes on, and
`--for` ends one in time. `--report FILE` writes the tables into a page of the documentation.
"""

from __future__ import annotations

import argparse
import json
import multiprocessing
import os
import random
import signal
import sys
import threading
import time
from collections import Counter, deque
from collections.abc import Container, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import Future, ProcessPoolExecutor
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from tempfile import TemporaryDirectory

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from benchmarks.models import RUNS, SCENARIOS, Made, Model, digest, models  # noqa: E402
from tests.support.model_mutants import KINDS, ModelMutant, in_turns, model_mutants, shuffled  # noqa: E402

KEPT = ROOT / ".mutants"
BEGIN, END = "<!-- figures -->", "<!-- end of figures -->"
SEEDS = 20
LONGEST = 300
"""So many seconds of CPU time one mutant may take; who takes longer has an endless loop, which is noticed."""

NOT_COMPILED, CAUGHT, SURVIVED = "not compiled", "caught", "survived"
OTHERWISE, SAME = "not caught", "same behaviour"
SAME_CODE = "the code is the same"


def _place(file: Path) -> str:
    return str(file.relative_to(ROOT)) if file.is_relative_to(ROOT) else str(file)


@dataclass(frozen=True, slots=True)
class Candidate:
    """A mutant of a file of a model."""

    model: Model
    file: Path
    mutant: ModelMutant

    def key(self) -> str:
        """Names the mutant and all texts that its result depends on."""
        return digest(self.model.key(), self.mutant.text, _place(self.file))


def candidates(chosen: Sequence[Model], seed: int) -> Iterator[Candidate]:
    """All mutants in the order in which they are drawn: models take turns, and so do the kinds of each."""
    queues = []
    for model in chosen:
        chance = random.Random(f"{model.name}/{seed}")
        by_kind: dict[str, list[Candidate]] = {kind: [] for kind in KINDS}
        for file in model.files:
            for mutant in model_mutants(file.read_text("utf-8")):
                by_kind[mutant.kind].append(Candidate(model, file, mutant))
        queues.append(shuffled(by_kind.values(), chance))
    yield from in_turns(queues)


@dataclass(frozen=True, slots=True)
class Judged:
    """What was found of a mutant; `by` is the scenario that caught it, or where it behaves otherwise."""

    model: str
    file: str
    line: int
    kind: str
    before: str
    after: str
    result: str
    by: str = ""
    seeds: int = 0
    """With so many seeds it was compared with the model."""


class TooLong(BaseException):
    """A mutant takes too long."""


def judge(candidate: Candidate) -> Judged:
    """Compile a mutant and play its scenarios, up to the first that notices it."""

    def stop(_signal: int, _frame: object) -> None:
        raise TooLong

    signal.signal(signal.SIGPROF, stop)
    signal.setitimer(signal.ITIMER_PROF, LONGEST)
    try:
        result, by = _caught(candidate)
    except TooLong:
        result, by = CAUGHT, f"it takes longer than {LONGEST} s"
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
    mutant = candidate.mutant
    file = _place(candidate.file)
    return Judged(
        candidate.model.name, file, mutant.line, mutant.kind, mutant.before, mutant.after, result, by
    )


def _caught(candidate: Candidate) -> tuple[str, str]:
    with TemporaryDirectory(prefix="mutant-") as folder:
        made = Made.of(candidate.model, {str(candidate.file): candidate.mutant.text}, Path(folder))
        if made is None:
            return NOT_COMPILED, ""
        for name, verdict in made.verdicts():
            if verdict != "passed":
                return CAUGHT, f"{name} ({verdict})"
    return SURVIVED, ""


def compare(candidate: Candidate, found: Judged, kept: Path, seeds: int) -> Judged:
    """Whether a mutant that no scenario has noticed behaves otherwise than its model, and where first."""
    with TemporaryDirectory(prefix="mutant-") as own, TemporaryDirectory(prefix="model-") as folder:
        made = Made.of(candidate.model, {str(candidate.file): candidate.mutant.text}, Path(own))
        usual = Made.of(candidate.model, {}, Path(folder))
        assert made is not None and usual is not None, candidate.model.root
        if made.code() == usual.code():
            return replace(found, result=SAME, by=SAME_CODE, seeds=seeds)
        difference = _difference(made, Usual(usual, kept), seeds)
    return replace(found, result=OTHERWISE if difference else SAME, by=difference, seeds=seeds)


def _difference(made: Made, usual: Usual, seeds: int) -> str:
    every = range(1, seeds + 1)
    for seed in every[:2]:
        if place := _place_of_difference(made, usual, SCENARIOS, seed):
            return place
    for seed in every if made.is_run() else ():
        if place := _place_of_difference(made, usual, RUNS, seed):
            return place
    first = usual.of(1, SCENARIOS)
    by_chance = {
        name for seed in every for name, seen in usual.of(seed, SCENARIOS).items() if seen != first[name]
    }
    for seed in every[2:]:
        if place := _place_of_difference(made, usual, SCENARIOS, seed, by_chance):
            return place
    return ""


def _place_of_difference(
    made: Made, usual: Usual, part: str, seed: int, wanted: Container[str] | None = None
) -> str:
    expected = usual.of(seed, part)
    for place, seen in made.behaviours(seed, part, wanted):
        if expected[place] != seen:
            return f"{place}, seed {seed}"
    return ""


@dataclass(frozen=True)
class Usual:
    """The behaviour of a model as it is, which is kept in a folder."""

    made: Made
    kept: Path

    def of(self, seed: int, part: str) -> Mapping[str, str]:
        """What people see with a seed in the scenarios, or in the run of the example."""
        path = self.kept / f"{part}-{self.made.model.key(part)}-{seed}.json"
        if not path.exists():
            written = path.with_suffix(f".{os.getpid()}")
            written.write_text(json.dumps(dict(self.made.behaviours(seed, part))), "utf-8")
            written.replace(path)
        found: dict[str, str] = json.loads(path.read_text("utf-8"))
        return found


def _end_with_parent() -> None:
    """A worker ends when the process that wants its results has ended."""
    parent = os.getppid()

    def watch() -> None:
        while os.getppid() == parent:
            time.sleep(1)
        os._exit(1)

    threading.Thread(target=watch, daemon=True).start()


class Kept:
    """What is known of mutants, in a file."""

    def __init__(self, folder: Path) -> None:
        folder.mkdir(parents=True, exist_ok=True)
        self.folder = folder
        self._path = folder / "judged.jsonl"
        self._known: dict[str, Judged] = {}
        lines = self._path.read_text("utf-8").splitlines() if self._path.exists() else []
        for line in lines:
            item = json.loads(line)
            key = item.pop("key")
            self._known[key] = Judged(**item)

    def of(self, candidate: Candidate) -> Judged | None:
        """What is known of a mutant."""
        return self._known.get(candidate.key())

    def add(self, candidate: Candidate, found: Judged) -> None:
        """Remember it."""
        self._known[candidate.key()] = found
        line = json.dumps({"key": candidate.key(), **asdict(found)}, ensure_ascii=False)
        with self._path.open("a", encoding="utf-8") as file:
            file.write(line + "\n")


def judged(
    drawn: Iterator[Candidate], number: int, jobs: int, kept: Kept, deadline: float, seeds: int
) -> tuple[list[Judged], bool]:
    """The first mutants that compile, and those before them that do not; and whether all is known of them."""
    context = multiprocessing.get_context("spawn")
    with ProcessPoolExecutor(jobs, context, _end_with_parent) as pool:
        first: list[tuple[Candidate, Judged]] = []
        waiting: deque[tuple[Candidate, Judged | Future[Judged]]] = deque()
        compiled = 0
        while compiled < number:
            while len(waiting) < 4 * jobs and (candidate := next(drawn, None)) is not None:
                waiting.append((candidate, kept.of(candidate) or pool.submit(judge, candidate)))
            if not waiting:
                break
            candidate, found = waiting.popleft()
            if isinstance(found, Future):
                if time.monotonic() > deadline:
                    pool.shutdown(cancel_futures=True)
                    return [item for _, item in first], False
                found = found.result()
                kept.add(candidate, found)
            first.append((candidate, found))
            compiled += found.result != NOT_COMPILED
            print(f"{compiled:4} {found.result:14} {found.model:24} {found.kind}", flush=True)
        for _, left in waiting:
            if isinstance(left, Future):
                left.cancel()
        compared = [
            (
                candidate,
                pool.submit(compare, candidate, found, kept.folder, seeds)
                if found.result == SURVIVED or (found.result == SAME and found.seeds < seeds)
                else found,
            )
            for candidate, found in first
        ]
        results: list[Judged] = []
        is_complete = True
        for candidate, later in compared:
            if isinstance(later, Future):
                try:
                    later = later.result(max(0.0, deadline - time.monotonic()))
                except TimeoutError:
                    is_complete = False
                    continue
                kept.add(candidate, later)
                print(f"     {later.result:14} {later.model:24} {later.kind}: {later.by}", flush=True)
            results.append(later)
        pool.shutdown(cancel_futures=True)
    return results, is_complete


def table(results: Sequence[Judged], column: str, names: Iterable[str]) -> Iterator[str]:
    """How many of each kind, or each model, were caught, as a table in Markdown."""
    yield f"| {column} | mutants | same behaviour | caught | not caught |"
    yield "| --- | ---: | ---: | ---: | ---: |"
    counts: dict[str, Counter[str]] = {name: Counter() for name in names}
    for item in results:
        name = item.kind if column == "kind" else item.model
        counts[name][item.result] += 1
        counts[name]["all"] += item.result != NOT_COMPILED
    total: Counter[str] = sum(counts.values(), Counter())
    for name, count in (*counts.items(), ("**all**", total)):
        if count["all"]:
            yield f"| {name} | {count['all']} | {count[SAME]} | {count[CAUGHT]} | {count[OTHERWISE]} |"


def not_caught(results: Sequence[Judged]) -> Iterator[str]:
    """The mutants that behave otherwise and are not caught: what was changed, and where it shows first."""
    for item in results:
        if item.result == OTHERWISE:
            yield f"{item.file}:{item.line}, {item.kind}; it shows in {item.by}"
            yield f"- {item.before}"
            yield f"+ {item.after}"


def _compared(results: Sequence[Judged]) -> str:
    same = [item for item in results if item.result == SAME]
    counts = Counter(item.seeds for item in same if item.by != SAME_CODE)
    said = [f"{count} in runs with the seeds 1 to {seeds}" for seeds, count in sorted(counts.items())]
    said += [f"{count} by their code" for count in [len(same) - counts.total()] if count]
    return f"Those with the same behaviour were compared with the model: {', '.join(said)}." if said else ""


def write_page(page: Path, results: Sequence[Judged], names: Sequence[str], seed: int) -> None:
    """Put the figures into a page, between its two marks."""
    left = [
        f"- `{item.file}:{item.line}`, {item.kind}: `{item.before}` becomes `{item.after}`"
        for item in results
        if item.result == OTHERWISE
    ]
    lines = [
        f"Seed {seed}: {share(results):.1f} % of the mutants that behave otherwise are caught.",
        _compared(results),
        "",
        *table(results, "kind", KINDS),
        "",
        *table(results, "model", names),
        *(["", "Not caught:", "", *left] if left else []),
    ]
    before, mark, rest = page.read_text("utf-8").partition(BEGIN)
    _, end, after = rest.partition(END)
    assert mark and end, f"{page} has no {BEGIN} and {END}"
    page.write_text("\n\n".join([before + mark, "\n".join(lines), end + after]), "utf-8")


def share(results: Sequence[Judged]) -> float:
    """Percent of the mutants that behave otherwise which are caught."""
    count = Counter(item.result for item in results)
    return 100 * count[CAUGHT] / max(1, count[CAUGHT] + count[OTHERWISE])


def main() -> int:
    """Print the tables and what was not caught; 1 if that is too much, or not all is known yet."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("number", nargs="?", type=int, default=200, help="mutants that compile")
    parser.add_argument("seed", nargs="?", type=int, default=1)
    parser.add_argument("--only", metavar="NAME", help="only models whose name contains NAME")
    parser.add_argument("-j", "--jobs", type=int, default=2)
    parser.add_argument("--for", dest="minutes", type=float, default=120, help="stop after so many minutes")
    parser.add_argument("--kept", type=Path, default=KEPT, help="the folder of what is known")
    parser.add_argument(
        "--seeds", type=int, default=SEEDS, help="compare behaviours with seeds 1 to this one"
    )
    parser.add_argument("--least", type=float, default=95, help="percent that have to be caught")
    parser.add_argument("--show", action="store_true", help="show all mutants, not only those not caught")
    parser.add_argument("--report", type=Path, help="write the tables into docs/project/mutants.md")
    options = parser.parse_args()
    chosen = [item for item in models() if options.only is None or options.only in item.name]
    results, is_complete = judged(
        candidates(chosen, options.seed),
        options.number,
        options.jobs,
        Kept(options.kept),
        time.monotonic() + 60 * options.minutes,
        options.seeds,
    )
    for column, names in (("kind", KINDS), ("model", [item.name for item in chosen])):
        print("\n".join(table(results, column, names)), end="\n\n")
    print("\n".join(not_caught(results)))
    if options.show:
        for item in results:
            print(f"{item.file}:{item.line}: {item.kind}: {item.result} {item.by}")
            print(f"    - {item.before}\n    + {item.after}")
    not_compiled = sum(item.result == NOT_COMPILED for item in results)
    print(f"caught: {share(results):.1f} % of those that behave otherwise; {not_compiled} did not compile")
    if not is_complete:
        print(f"stopped after {options.minutes:g} minutes: call it again to go on")
        return 1
    if options.report is not None:
        write_page(options.report, results, [item.name for item in chosen], options.seed)
    return int(share(results) < options.least)


if __name__ == "__main__":
    sys.exit(main())
