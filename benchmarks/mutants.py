"""Whether scenarios notice mistakes in a model: `python -m benchmarks.mutants [NUMBER] [SEED] [--only NAME]`.

The models are the examples and the acceptance files. Mutants of them (`tests/support/model_mutants.py`) are
drawn with a seed, by turns from every model and of every kind, until NUMBER of them compile. A mutant is
*caught* if a scenario of its model fails, is vacuous or cannot be played. One that is not caught *behaves
otherwise* if what people see of a run (activities, messages, conversations, variables, faults, ends) differs
in some scenario, or in a run of the example in its world, with one of the seeds 1 to 20. The rest behaves as
the model does, as far as these runs show. Scenarios without chance in them are compared with two seeds.

What is found is kept in a folder (`--kept`), by the texts that it depends on: a further call goes on, and
`--for` ends one in time. `--report FILE` writes the tables into a page of the documentation.
"""

from __future__ import annotations

import argparse
import hashlib
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
from itertools import zip_longest
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import cast

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from aseme_dsl.compiler.phases import inspect_files, scenarios_of  # noqa: E402
from aseme_dsl.compiler.read.memory import Memory  # noqa: E402
from aseme_dsl.diagnostics import has_errors  # noqa: E402
from aseme_dsl.play.run import NotPlayable, Played, play  # noqa: E402
from aseme_dsl.play.scenario import Scenario, Script  # noqa: E402
from aseme_dsl.project.building.build import activities_folder, choose  # noqa: E402
from aseme_dsl.project.building.project import configuration_for, options_of  # noqa: E402
from aseme_dsl.project.playing.operate import generate_version, loaded_for  # noqa: E402
from aseme_dsl.project.playing.play import PlayError, Request, made_world  # noqa: E402
from aseme_dsl.project.playing.play import play as play_example  # noqa: E402
from aseme_dsl.project.settings.configuration import OUTPUT, Configuration  # noqa: E402
from aseme_dsl.project.testing.cases import cases_of  # noqa: E402
from aseme_dsl.project.testing.playing import world_of  # noqa: E402
from aseme_dsl.project.testing.verdicts import NotRun, verdict_of  # noqa: E402
from aseme_dsl.runtime.trace.records import Record, agents_of  # noqa: E402
from aseme_dsl.runtime.version.loading import activities_in, forgetting, importing  # noqa: E402
from tests.support.model_mutants import KINDS, ModelMutant, model_mutants  # noqa: E402

KEPT = ROOT / ".mutants"
BEGIN, END = "<!-- figures -->", "<!-- end of figures -->"
SEEDS = 20
LONGEST = 300
"""So many seconds of CPU time one mutant may take; who takes longer has an endless loop, which is noticed."""

LENGTHS = {"robocup": 30_000_000_000}
"""How long the runs of an example are, in ns, if they are shorter than the project's: a match takes long."""

NOT_COMPILED, CAUGHT, SURVIVED = "not compiled", "caught", "survived"
OTHERWISE, SAME = "not caught", "same behaviour"
SCENARIOS, RUNS = "scenarios", "runs"


@dataclass(frozen=True, slots=True)
class Model:
    """A system: the file with its scenarios, and the files that mutants are made of."""

    name: str
    root: Path
    files: tuple[Path, ...]

    def key(self, part: str = SCENARIOS) -> str:
        """Names all that decides its behaviour in its folder; scenarios do not decide that of its runs."""
        folder = self.root.parent
        files = sorted({*self.files, self.root, *folder.glob("*.py"), *folder.glob("activities/*.py")})
        texts = [path.read_text("utf-8") for path in files]
        return _digest(*(text if part == SCENARIOS else text.partition("\nscenario ")[0] for text in texts))


def _place(file: Path) -> str:
    return str(file.relative_to(ROOT)) if file.is_relative_to(ROOT) else str(file)


def _digest(*texts: str) -> str:
    return hashlib.sha256("\0".join(texts).encode()).hexdigest()[:20]


def models() -> tuple[Model, ...]:
    """The examples, then the acceptance files."""
    found = []
    for settings in sorted((ROOT / "examples").glob("*/pyproject.toml")):
        name = settings.parent.name
        files = sorted(settings.parent.glob("*.aseme"))
        (root,) = (path for path in files if "\nsystem " in path.read_text("utf-8"))
        found.append(Model(name, root, tuple(files)))
    for path in sorted((ROOT / "tests/acceptance").glob("*.aseme")):
        scenarios = path.parent / "scenarios" / path.name
        found.append(Model(f"{path.stem} (acceptance)", scenarios, (path,)))
    return tuple(found)


@dataclass(frozen=True, slots=True)
class Candidate:
    """A mutant of a file of a model."""

    model: Model
    file: Path
    mutant: ModelMutant

    def key(self) -> str:
        """Names the mutant and all texts that its result depends on."""
        return _digest(self.model.key(), self.mutant.text, _place(self.file))


def candidates(chosen: Sequence[Model], seed: int) -> Iterator[Candidate]:
    """All mutants in the order in which they are drawn: models take turns, and so do the kinds of each."""
    queues = []
    for model in chosen:
        chance = random.Random(f"{model.name}/{seed}")
        by_kind: dict[str, list[Candidate]] = {kind: [] for kind in KINDS}
        for file in model.files:
            for mutant in model_mutants(file.read_text("utf-8")):
                by_kind[mutant.kind].append(Candidate(model, file, mutant))
        for items in by_kind.values():
            chance.shuffle(items)
        order = [items for items in by_kind.values() if items]
        chance.shuffle(order)
        queues.append([item for turn in zip_longest(*order) for item in turn if item is not None])
    for turn in zip_longest(*queues):
        yield from (item for item in turn if item is not None)


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
    difference = _difference(candidate, kept, seeds)
    return replace(found, result=OTHERWISE if difference else SAME, by=difference, seeds=seeds)


def _difference(candidate: Candidate, kept: Path, seeds: int) -> str:
    model = candidate.model
    in_scenarios = _original(model, kept, SCENARIOS, seeds)
    by_chance = {
        name for seen in in_scenarios.values() for name in seen if seen[name] != in_scenarios[1][name]
    }
    with TemporaryDirectory(prefix="mutant-") as folder:
        made = Made.of(model, {str(candidate.file): candidate.mutant.text}, Path(folder))
        assert made is not None
        for part in (SCENARIOS, RUNS) if made.is_run() else (SCENARIOS,):
            for seed, usual in _original(model, kept, part, seeds).items():
                wanted = by_chance if part == SCENARIOS and seed > 2 else usual
                for place, seen in made.behaviours(seed, part, wanted):
                    if usual[place] != seen:
                        return f"{place}, seed {seed}"
    return ""


def _original(model: Model, kept: Path, part: str, seeds: int) -> Mapping[int, Mapping[str, str]]:
    """The behaviour of a model as it is, by seed, in its scenarios or in its runs."""
    path = kept / f"{part}-{seeds}-{model.key(part)}.json"
    if not path.exists():
        with TemporaryDirectory(prefix="model-") as folder:
            made = Made.of(model, {}, Path(folder))
            assert made is not None, model.root
            found = {seed: dict(made.behaviours(seed, part)) for seed in range(1, seeds + 1)}
        written = path.with_suffix(f".{os.getpid()}")
        written.write_text(json.dumps(found), "utf-8")
        written.replace(path)
    return {int(seed): seen for seed, seen in json.loads(path.read_text("utf-8")).items()}


@dataclass(frozen=True)
class Made:
    """A system that can be played, and its scenarios, those with few runs first."""

    model: Model
    configuration: Configuration
    scenarios: tuple[Scenario, ...]
    package: Path

    @classmethod
    def of(cls, model: Model, changed: Mapping[str, str], folder: Path) -> Made | None:
        """Compile it, with changed texts; none if it has errors."""
        configuration, _ = configuration_for(model.root)
        memory = _MEMORIES.setdefault(model.root, Memory())
        inspection = inspect_files(model.root, changed, options_of(configuration), memory)
        system = inspection.analysis.system
        if system is None or has_errors(inspection.analysis.diagnostics):
            return None
        package, _ = generate_version(system, folder, choose(configuration))
        found = scenarios_of(inspection, {})
        return cls(model, configuration, tuple(sorted(found, key=_length)), package)

    def verdicts(self) -> Iterator[tuple[str, str]]:
        """The scenarios by name, and the verdict on each, with the seed of the project."""
        for scenario in self.scenarios:
            cases = cases_of(scenario, (self.configuration.seed,))
            runs: list[Played | NotRun] = []
            for case in cases if scenario.refused is None else ():
                run = self._run(scenario.scripts[case.script], case.seed, case.inputs)
                runs.append(run)
                if isinstance(run, NotRun) or run.broken is not None:
                    break
            yield scenario.name, verdict_of(scenario, cases[: len(runs)] or cases, runs).verdict

    def is_run(self) -> bool:
        """Whether the project says how it is run."""
        return self.configuration.run is not None

    def behaviours(
        self, seed: int, part: str, wanted: Container[str] | None = None
    ) -> Iterator[tuple[str, str]]:
        """Digests of what people see, by scenario (all, or those `wanted`), or of the run of the example."""
        if part == RUNS:
            yield "the run", self._example(seed)
            return
        for scenario in self.scenarios:
            place = f"scenario {scenario.name!r}"
            if scenario.refused is None and (wanted is None or place in wanted):
                digest = Digest()
                for case in cases_of(scenario, (seed,)):
                    if case.seed == seed:
                        self._run(scenario.scripts[case.script], seed, case.inputs, digest)
                yield place, digest.text()

    @property
    def _activities(self) -> Path:
        return activities_folder(self.configuration.output or Path(OUTPUT), choose(self.configuration))

    @property
    def _project(self) -> Path:
        return self.configuration.folder.resolve()

    def _run(
        self, script: Script, seed: int, inputs: Mapping[str, object], listener: Digest | None = None
    ) -> Played | NotRun:
        until = max(script.until, self.configuration.length) if script.is_open else script.until
        world = world_of(script, self.configuration)
        loaded = loaded_for(self.package, self._project)
        with forgetting(self._project), importing([self._project, *loaded.path]):
            try:
                real = activities_in(self._activities)
                made = None if world is None else made_world(world, seed)
                listeners = () if listener is None else (listener,)
                return play(loaded, script, seed, inputs, real, until, made, listeners)
            except PlayError as problem:
                return NotRun(problem.problem.message)
            except NotPlayable as problem:
                return NotRun(str(problem), problem.span)

    def _example(self, seed: int) -> str:
        assert self.configuration.run is not None
        quiet = replace(self.configuration, run=replace(self.configuration.run, trace=None, progress=None))
        loaded = loaded_for(self.package, self._project)
        request = Request(seed=seed, duration=LENGTHS.get(self.model.name))
        digest = Digest()
        with forgetting(self._project):
            try:
                play_example(
                    loaded, self._activities, quiet, request, tell=lambda line: None, listeners=(digest,)
                )
            except PlayError as problem:
                return problem.problem.message
        return digest.text()


_MEMORIES: dict[Path, Memory] = {}
"""What the compiler need not find out again of a model, in this process."""


def _length(scenario: Scenario) -> int:
    return sum((100 if script.inputs else 1) * script.until for script in scenario.scripts)


SEEN = {
    "activity": ("what", "activity", "arguments", "outcome"),
    "message": ("channel", "message", "to"),
    "agent_message": ("performative", "message", "content", "protocol", "to"),
    "conversation": ("what", "participant", "peer", "reason"),
    "variable": ("variable", "value"),
    "event": ("event",),
    "unexpected": ("performative", "message", "reason"),
    "fault": ("what", "reason", "text"),
    "error": ("what", "reason", "text"),
}
"""What people see of a run, by the kind of the record: neither labels nor numbers of transitions."""


class Digest:
    """What people see of runs, as a short text: equal if they behave alike."""

    def __init__(self) -> None:
        self._hash = hashlib.sha256()

    def wants(self, kind: str, what: str | None) -> bool:
        return kind in SEEN or kind == "finish"

    def __call__(self, record: Record) -> None:
        kind, as_data = record["kind"], cast(Mapping[str, object], record)
        if kind == "finish":
            ends = [(a["name"], a.get("finished"), a.get("failure")) for a in agents_of(record)]
            self._hash.update(repr((record["time"], record["reason"], ends)).encode())
        elif kind in SEEN and record.get("what") != "late":
            seen = [as_data.get(name) for name in SEEN[kind]]
            self._hash.update(repr((record["time"], record.get("agent"), seen)).encode())

    def text(self) -> str:
        return self._hash.hexdigest()[:20]


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
    counts = Counter(item.seeds for item in results if item.result == SAME)
    said = ", ".join(f"{count} with the seeds 1 to {seeds}" for seeds, count in sorted(counts.items()))
    return f"Those with the same behaviour were compared with the model: {said}." if said else ""


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
