"""The examples and the acceptance files as they are played for measurements, and what people see of them."""

from __future__ import annotations

import hashlib
import re
import sys
from collections.abc import Container, Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
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

LENGTHS = {"robocup": 30_000_000_000}
"""How long the runs of an example are, in ns, if they are shorter than the project's: a match takes long."""

SCENARIOS, RUNS = "scenarios", "runs"

_PLACES = re.compile(r"(?m)\.aseme:\d+:\d+|^ *#.*$|^(MODEL|SOURCES) = .*$|model='\w+'")


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
        return digest(*(text if part == SCENARIOS else text.partition("\nscenario ")[0] for text in texts))


def digest(*texts: str) -> str:
    """A short text that is another one for other texts."""
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

    def code(self) -> str:
        """All that is generated, but for where it was written in the document, and what is made of that."""
        paths = sorted(self.package.rglob("*.py"))
        return digest(*(_PLACES.sub("", path.read_text("utf-8")) for path in paths))

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
