"""Coverage of a system, from scenarios, from traces and from files of earlier measurements."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import ExitStack
from pathlib import Path
from typing import TYPE_CHECKING, cast

from aseme_dsl import outside
from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.diagnostics.problems.running import NotOfThisModel, TraceNotRead
from aseme_dsl.play.coverage.probes import Probed, Recorder, probed
from aseme_dsl.play.coverage.seen import Following, RoleSeen, Seen
from aseme_dsl.play.inputs import Messages
from aseme_dsl.play.replay import Model as Replayed
from aseme_dsl.play.replay import NotReplayable, Replay
from aseme_dsl.project.files.inputs import is_folder
from aseme_dsl.project.settings.target import builds_in, project_here
from aseme_dsl.project.testing.replaying import generated, models_of
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.chart import Chart
from aseme_dsl.runtime.time.clock import readable
from aseme_dsl.runtime.trace.packed import unpacked
from aseme_dsl.runtime.trace.records import Record, TracedAgent, agents_of
from aseme_dsl.runtime.trace.trace_files import TraceError
from aseme_dsl.runtime.trace.trace_reading import TraceReader, fitting

if TYPE_CHECKING:
    from aseme_dsl.amola.system import System
    from aseme_dsl.project.building.build import Choice

FORMAT = 1
_MARK = "asemec coverage"

Listener = Callable[[Record], None]


@dataclass(frozen=True, slots=True)
class Model:
    """A system as its agents run it, with the hash of the model of each role."""

    system: System
    hashes: Mapping[str, str]


def model_of(system: System, choice: Choice) -> Model:
    """The system with the labels that its build has."""
    from aseme_dsl.backends.shared.generate import role_models
    from aseme_dsl.project.building.build import with_labels

    labelled = with_labels(system, choice.labels)
    return Model(labelled, role_models(labelled))


def source_of_runs(targets: Sequence[str], files: Iterable[Path]) -> str:
    """The target whose system has run: a target that is not a record of a run, else where it was built.

    Without either it is the file that the first record names, here or beside it, else the project here.
    """
    known = list(files)
    for target in targets:
        if Path(target) not in known:
            return target
    for path in known:
        if is_folder(path.parent) and builds_in(path.parent):
            return str(path.parent)
    for path in known:
        name = _source_in(path)
        for place in (Path(), path.parent):
            if name is not None and (place / name).is_file():
                return str(place / name)
    return project_here()


def _source_in(path: Path) -> str | None:
    """The file of the system, as a record of a run names it."""
    try:
        if path.suffix == ".json":
            return str(_document(path)["source"])
        header = next(iter(TraceReader(path))).record
        return next((agent["source"] for agent in agents_of(header) if "source" in agent), None)
    except (TraceError, StopIteration, KeyError, TypeError):
        return None


# ---- traces -----------------------------------------------------------------------------------------


def read_runs(
    model: Model,
    paths: Iterable[Path],
    seen: Seen,
    listeners: Sequence[Listener] = (),
    *,
    conditions: bool = False,
) -> tuple[Diagnostic, ...]:
    """Add what traces, and files of earlier measurements, have shown; what is wrong with them.

    `listeners` are given the records of the traces, too. For `conditions` the steps of traces are made again.
    """
    found: list[Diagnostic] = []
    with ExitStack() as stack:
        replays = _Replays(model, stack) if conditions else None
        for path in paths:
            try:
                if path.suffix == ".json":
                    found += _read_measured(model, path, seen)
                else:
                    found += _read_trace(model, path, seen, listeners, replays)
            except TraceError as problem:
                found.append(Diagnostic(TraceNotRead(str(problem)), None, path=str(path)))
    return tuple(found)


class _Replays:
    """Makes the steps of traces again, by classes with probes; these are generated when they are needed."""

    def __init__(self, model: Model, stack: ExitStack) -> None:
        self._model = model
        self._stack = stack
        self._generated: tuple[Mapping[str, type[Chart]], Messages, Probed] | None = None

    def replay(self, recorder: Recorder, header: Record) -> Replay:
        """A replay of the trace of a header, whose conditions tell the recorder. Raises NotReplayable."""
        if self._generated is None:
            made = probed(self._model.system)
            self._generated = *generated(made.system, self._stack), made
        charts, messages, made = self._generated
        recorder.probes = made.probes
        hashes = self._model.hashes
        kinds = {
            hashes[role]: Replayed(recorder.listening(chart, hashes[role]), messages)
            for role, chart in charts.items()
        }
        ours = header.get("sources") if not _others(self._model, header) else None

        def models(sources: Mapping[str, str]) -> Mapping[str, Replayed]:
            is_ours = ours is not None and sources == unpacked(ours)
            return kinds if is_ours else {**models_of(sources, self._stack), **kinds}

        return Replay(models)


def _read_trace(
    model: Model, path: Path, seen: Seen, listeners: Sequence[Listener], replays: _Replays | None
) -> Iterable[Diagnostic]:
    """Add what a trace has shown of a model, as far as agents ran it."""
    reader = TraceReader(path)
    others = _others(model, reader.header().record)
    if others and (listeners or not _changes_to(model, reader)):
        return [Diagnostic(NotOfThisModel(model.system.name, others), None, path=str(path))]
    mine = Seen(traces=1)
    following = Following(
        {chart.name: chart for chart in model.system.iacs},
        mine,
        {a["name"]: a.get("role", "") for a in _agents(reader) if a["name"] not in others},
        model.hashes.values(),
    )
    recorder = Recorder(())
    replay = None
    if replays is not None:
        try:
            replay = replays.replay(recorder, reader.header().record)
        except NotReplayable as problem:
            mine.left_out[_UNMEASURED.format(path, problem)] += 1
    for line in reader:
        record = line.record
        with fitting(reader.path, line):
            following(record)
            for listener in listeners:
                listener(record)
        if replay is not None and (why := _differs(replay, record)) is not None:
            mine.left_out[_UNMEASURED.format(path, why)] += 1
            replay = None
        if record["kind"] in ("swap", "select") and record.get("model") not in (None, *model.hashes.values()):
            name, when = record["agent"], readable(record["time"])
            mine.left_out[f"{name} changed to another model at {when}; what came then was not counted"] += 1
    if others:
        mine.left_out[f"{', '.join(others)} ran another model at first, which was not counted"] += 1
    if replay is not None:
        mine.add(Seen(evaluations=recorder.evaluations, evaluated=1))
    seen.add(mine)
    if reader.problem is not None:
        return [Diagnostic(TraceNotRead(reader.problem), None, path=str(path))]
    return []


_UNMEASURED = "the conditions of {} were not measured: {}"


def _changes_to(model: Model, reader: TraceReader) -> bool:
    """Whether some agent of a trace changes to this model."""
    known = set(model.hashes.values())
    changes = (line.record for line in reader if line.record["kind"] in ("swap", "select"))
    return any("agent" in record and record.get("model") in known for record in changes)


def _agents(reader: TraceReader) -> Iterable[TracedAgent]:
    return agents_of(reader.header().record)


def _differs(replay: Replay, record: Record) -> str | None:
    """Why the steps of a trace cannot be made again from this record on, if it is so."""
    try:
        found = replay.line(record)
    except NotReplayable as problem:
        return str(problem)
    if found is None:
        return None
    return f"step {found.step} of {found.agent} differs in its replay"


def _others(model: Model, header: Record) -> tuple[str, ...]:
    """The agents of a trace that did not run this model."""
    return tuple(
        agent["name"]
        for agent in agents_of(header)
        if agent.get("model", "") != model.hashes.get(agent.get("role", ""))
    )


# ---- files of measurements --------------------------------------------------------------------------


def written(model: Model, seen: Seen) -> bytes:
    """What was seen, as a file that `read_runs` reads."""
    document = {
        "kind": _MARK,
        "format": FORMAT,
        "system": model.system.name,
        "source": model.system.span.source.path if model.system.span is not None else "",
        "models": dict(model.hashes),
        "scenarios": seen.scenarios,
        "traces": seen.traces,
        "evaluated": seen.evaluated,
        "left_out": dict(seen.left_out),
        "roles": {
            role: {
                "entered": dict(item.entered),
                "completed": dict(item.completed),
                "taken": {str(number): times for number, times in sorted(item.taken.items())},
                "ended": [[*place, times] for place, times in sorted(item.ended.items())],
            }
            for role, item in sorted(seen.roles.items())
        },
        "conditions": [
            [role, number, sorted(found)] for (role, number), found in sorted(seen.evaluations.items())
        ],
    }
    return f"{json.dumps(document, indent=1, ensure_ascii=False)}\n".encode()


def _document(path: Path) -> Mapping[str, object]:
    """Raises TraceError: it cannot be read, or is not one of ours."""
    try:
        document = json.loads(outside.read_bytes(path))
        if document["kind"] != _MARK or document["format"] != FORMAT:
            raise ValueError(document["kind"])
    except OSError as problem:
        raise TraceError(f"{path} cannot be read: {problem.strerror or problem}") from problem
    except (KeyError, TypeError, ValueError, RecursionError) as problem:
        raise TraceError(_NOT_OURS.format(path)) from problem
    return cast("Mapping[str, object]", document)


_NOT_OURS = "{} is not a file that `asemec test --coverage-file` has written"


def _read_measured(model: Model, path: Path, seen: Seen) -> Iterable[Diagnostic]:
    document = _document(path)
    try:
        read = _seen(document)
        hashes = cast("Mapping[str, str]", document["models"])
        models = {str(role): str(text) for role, text in hashes.items()}
    except (KeyError, TypeError, ValueError, AttributeError) as problem:
        raise TraceError(_NOT_OURS.format(path)) from problem
    if models != dict(model.hashes):
        roles = tuple(role for role, text in models.items() if model.hashes.get(role) != text)
        wrong = NotOfThisModel(model.system.name, roles or tuple(model.hashes))
        return [Diagnostic(wrong, None, path=str(path))]
    seen.add(read)
    return []


def _seen(document: Mapping[str, object]) -> Seen:
    """Raises KeyError, TypeError, ValueError, AttributeError: it is of another form."""
    found = cast("Mapping[str, Mapping[str, Mapping[str, int]]]", document["roles"])
    roles = {}
    for role, item in found.items():
        ended = cast("Sequence[tuple[str, str, int]]", item["ended"])
        roles[role] = RoleSeen(
            Counter({str(label): int(times) for label, times in item["entered"].items()}),
            Counter({str(label): int(times) for label, times in item["completed"].items()}),
            Counter({int(number): int(times) for number, times in item["taken"].items()}),
            Counter({(str(label), str(outcome)): int(times) for label, outcome, times in ended}),
        )
    conditions = cast("Sequence[tuple[str, int, Sequence[str]]]", document["conditions"])
    evaluations = {(str(role), int(number)): set(map(str, texts)) for role, number, texts in conditions}
    left_out = cast("Mapping[str, int]", document["left_out"])
    names = ("scenarios", "traces", "evaluated")
    scenarios, traces, evaluated = (int(cast(int, document[name])) for name in names)
    return Seen(roles, evaluations, scenarios, traces, evaluated, Counter(dict(left_out)))


__all__ = ["Model", "model_of", "read_runs", "source_of_runs", "written"]
