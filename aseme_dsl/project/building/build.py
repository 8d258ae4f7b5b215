"""Build: everything that follows from a system, into a folder."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import field, replace
from functools import cache, partial
from pathlib import Path
from typing import TYPE_CHECKING, TypeVar

from aseme_dsl import outside
from aseme_dsl.diagnostics import NO_POLICY, Diagnostic, Policy, has_errors, in_order
from aseme_dsl.diagnostics.problems.running import NotCompiled, NoTemplates
from aseme_dsl.diagnostics.problems.writing import GraphvizNotThere, NotDrawn
from aseme_dsl.project.building.counting import Count, amount
from aseme_dsl.project.building.earlier import Earlier
from aseme_dsl.project.files.manifest import hash_of
from aseme_dsl.project.files.write import DISK, Disk, Planned, Written, write
from aseme_dsl.project.settings.configuration import Configuration
from aseme_dsl.records import dataclass
from aseme_dsl.source import STANDARD_INPUT, is_library_path

if TYPE_CHECKING:
    from aseme_dsl.amola.statechart import Statechart
    from aseme_dsl.amola.system import System
    from aseme_dsl.backends.backend import Artefact, Known
    from aseme_dsl.diagrams import Drawing
    from aseme_dsl.diagrams.rendering.drawn import Drawn, Result
    from aseme_dsl.proofs.certificate.certify import Certificate

_T = TypeVar("_T")

MODELS, DIAGRAMS, PROTO = "models", "diagrams", "proto"
PARTS = (MODELS, DIAGRAMS, PROTO)
"""The parts of a build that are not a backend's; the name of each is that of its folder."""


@dataclass(frozen=True, slots=True)
class Choice:
    """What a build is asked to do.

    `only` are the parts and backends to renew, all if it is empty. `activities` is the folder of the
    project's activities. Without it, each backend has its own, in its output folder.
    """

    only: frozenset[str] = frozenset()
    backends: tuple[str, ...] = ("monas",)
    """The first that makes agents is the one whose agents are played."""
    roles: Mapping[str, str] = field(default_factory=dict)
    """The backend whose agents play a role, where it is not that one."""
    classes: Mapping[str, frozenset[str]] = field(default_factory=dict)
    """Of backends that make no agents and are not asked for all roles: for which."""
    activities: Path | None = None
    templates: Path | None = None
    expressions: str = "numbered"
    labels: str = "plain"
    """`original`: states are named as the original tools name them."""
    native: bool = False
    """Whether the modules of plain statecharts are compiled, too."""
    force: bool = False
    starts_files: bool = True
    """Whether a first version is written of each file of the user's that is not there."""
    replaces: bool = False
    """Whether a build of another system gives way that has nothing of the user's: no folder was chosen."""
    policy: Policy = NO_POLICY
    """How bad the project finds each kind of problem."""

    @property
    def agents(self) -> Agents:
        """Which of the agents that are generated are played."""
        from aseme_dsl.backends.backend import AGENTS

        usual = next((name for name in self.backends if name in AGENTS), AGENTS[0])
        return Agents(usual, self.roles)

    @property
    def generated(self) -> tuple[str, ...]:
        """All backends that are to generate something."""
        return tuple(dict.fromkeys((*self.backends, *self.roles.values(), *self.classes)))


@dataclass(frozen=True, slots=True)
class Agents:
    """From which backend's package agents are taken: from `usual`, those of some `roles` from others."""

    usual: str = "monas"
    roles: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Report:
    """What a build did. With an error among the diagnostics, it changed nothing.

    (But for W002 that a project's policy takes for an error: what is edited and no longer generated stays.)
    """

    system: str
    folder: Path
    written: Written = field(default_factory=Written)
    count: Count | None = None
    """None where no backend was asked for."""
    notes: tuple[str, ...] = ()
    diagnostics: tuple[Diagnostic, ...] = ()
    certificates: tuple[Certificate, ...] = ()
    """What was proved of each statechart."""


def _silently(text: str) -> None:
    """No progress is shown."""


def _tell(told: Callable[[str], None], what: str, done: int, of: int) -> None:
    told(f"{what}: {done} of {of}")


def build(
    system: System,
    folder: Path,
    choice: Choice,
    disk: Disk = DISK,
    earlier: Earlier | None = None,
    told: Callable[[str], None] = _silently,
    certificates: tuple[Certificate, ...] = (),
) -> Report:
    """Write the models, diagrams, messages and code of a system into `folder`.

    `told` is given what long work is at: how many of the drawings and of the native modules are done.

    The manifest says what was proved of each statechart (`certificates`).

    What `earlier` builds of it have made is taken from there, and nothing is counted; what is written is the
    same.

    Raises:
        UnknownBackend: a backend is asked for that is not installed.
    """
    from aseme_dsl.backends.backend import Refused

    if choice.templates is not None and not choice.templates.is_dir():
        missing = NoTemplates(choice.templates.exists())
        problem = Diagnostic(missing, None, path=str(choice.templates))
        return Report(system.name, folder, diagnostics=(problem,))
    before = earlier or Earlier()
    known = before.known
    system = with_labels(system, choice.labels)
    backends = _backends(system, choice)
    parts = [part for part in PARTS if not choice.only or part in choice.only]
    files: list[Planned] = []
    notes: list[str] = []
    diagnostics: list[Diagnostic] = []
    drawings = _drawings(system, choice, known) if DIAGRAMS in parts else []
    refused = False
    drawn = partial(_tell, told, "drawing")
    with _drawn(drawings, before.pictures, drawn) as results:  # Graphviz draws while the others are made
        if MODELS in parts:
            files += _models(system, known)
        if PROTO in parts:
            files += _proto(system, known)
        for name in backends:
            homes = {file.home for file in files if file.home is not None}
            try:
                code = _code(system, name, folder, choice, known)
            except Refused as refusal:
                diagnostics += refusal.diagnostics
                refused = True
                continue
            files += (file for file in code if file.home not in homes)
        files += _pictures(drawings, results(), known, notes, diagnostics)
    if not choice.starts_files:
        files = [file for file in files if file.home is None or file.home.exists()]
    generated = [file for file in files if file.part in backends]
    if choice.native and not refused:
        files += _native(generated, told, diagnostics)
    problems = choice.policy.apply(diagnostics)
    if refused or has_errors(problems):
        return Report(system.name, folder, notes=tuple(notes), diagnostics=in_order(problems))
    written = write(
        folder,
        files,
        parts=frozenset((*parts, *backends)),
        system=system.name,
        source=_source(system, folder),
        certified={item.chart: item.text for item in certificates},
        force=choice.force,
        replaces=choice.replaces,
        disk=disk,
        seen=before.seen,
    )
    found = in_order((*problems, *choice.policy.apply(written.diagnostics)))
    count = _count(system, generated, written) if generated and earlier is None else None
    return Report(system.name, folder, written, count, tuple(notes), found, certificates)


def _backends(system: System, choice: Choice) -> list[str]:
    """The backends that write something: of the project, then those that are asked for besides."""
    found = [name for name in choice.generated if not choice.only or name in choice.only]
    found += sorted(name for name in choice.only if name not in (*PARTS, *found))
    return [name for name in found if _charts(system, name, choice)]


def _native(
    generated: Sequence[Planned], told: Callable[[str], None], diagnostics: list[Diagnostic]
) -> list[Planned]:
    """The generated classes as machine code; what cannot be compiled is added to the diagnostics."""
    from aseme_dsl.project.building.native import NativeError, compiled

    try:
        return list(compiled(generated, partial(_tell, told, "compiling to machine code")))
    except NativeError as problem:
        diagnostics.append(Diagnostic(NotCompiled(str(problem)), None, path=problem.path))
        return []


def _source(system: System, folder: Path) -> str:
    """The system's file as seen from the output folder, so that both may be moved together."""
    if system.span is None:
        return system.name
    path = system.span.source.path
    if path == STANDARD_INPUT:
        return path
    return Path(os.path.relpath(os.path.realpath(path), os.path.realpath(folder))).as_posix()


def choose(
    configuration: Configuration,
    *,
    only: Iterable[str] = (),
    backends: Iterable[str] = (),
    activities: Path | None = None,
    templates: Path | None = None,
    labels: str | None = None,
    native: bool = False,
    force: bool = False,
) -> Choice:
    """What is asked for on the command line, else by the project's configuration, else the usual.

    Of the `backends`, those that are `ROLE=NAME` are for a role; one for all makes what the project says of
    its roles void.
    """
    from aseme_dsl.backends.backend import AGENTS

    given = tuple(dict.fromkeys(backends))
    for_all = tuple(name for name in given if "=" not in name)
    for_roles = [] if for_all else list(configuration.roles.items())
    for_roles += [(role, name) for role, _, name in (item.partition("=") for item in given) if name]
    chosen = for_all or configuration.backends or ("monas",)
    classes: dict[str, frozenset[str]] = {}
    for role, name in for_roles:
        if name not in (*AGENTS, *chosen):
            classes[name] = classes.get(name, frozenset()) | {role}
    return Choice(
        frozenset(only),
        chosen,
        {role: name for role, name in for_roles if name in AGENTS},
        classes,
        activities or configuration.activities,
        templates or configuration.templates,
        configuration.expressions or "numbered",
        labels or configuration.labels or "plain",
        native,
        force,
        policy=configuration.diagnostics,
    )


def with_labels(system: System, labels: str) -> System:
    """The system with its states named as the original tools name them, if `labels` is `original`."""
    if labels != "original":
        return system
    from aseme_dsl.amola.original_names import labels_as_original

    eacs, iacs = (tuple(map(labels_as_original, charts)) for charts in (system.eacs, system.iacs))
    return replace(system, eacs=eacs, iacs=iacs)


def activities_folder(folder: Path, choice: Choice, backend: str = "monas") -> Path:
    """Where a build into `folder` keeps the activities of a backend; agents of all backends have the same."""
    from aseme_dsl.backends.backend import ACTIVITIES, AGENTS

    return choice.activities or folder / (AGENTS[0] if backend in AGENTS else backend) / ACTIVITIES


def _models(system: System, known: Known) -> Iterator[Planned]:
    from aseme_dsl.amola.as_json import model_makers

    for name, make, inputs in model_makers(system):
        text = _made(known, name, _model_text(make), inputs)
        yield _planned(known, f"{MODELS}/{name}", text, MODELS)


def _made(known: Known, name: object, make: Callable[..., _T], inputs: Iterable[object]) -> _T:
    """`make(*inputs)`, or what it was before of equal inputs."""
    return known.recall(make, *known.same(name, tuple(inputs)))


@cache
def _model_text(make: Callable[..., dict[str, object]]) -> Callable[..., str]:
    from aseme_dsl.amola.as_json import json_text

    return lambda *inputs: json_text(make(*inputs))


def _planned(known: Known, path: str, text: str, part: str) -> Planned:
    """A generated file: the same object as long as the text is the same."""
    return known.recall(_of_text, path, known.whole(text), part)


def _of_text(path: str, text: str, part: str) -> Planned:
    return Planned(path, _bytes(text), part)


def _drawings(system: System, choice: Choice, known: Known) -> list[Drawing]:
    """The drawings of all models."""
    from aseme_dsl.diagrams import Expressions, Options, makers

    options = Options(Expressions(choice.expressions), layout=None)
    return [
        drawing
        for make, inputs in makers(system, options)
        for drawing in _made(known, (make, str(getattr(inputs[0], "name", ""))), make, inputs)
    ]


@contextmanager
def _drawn(
    drawings: Sequence[Drawing],
    before: dict[str, tuple[Drawing, Drawn]],
    done: Callable[[int, int], None],
) -> Iterator[Callable[[], list[Result]]]:
    """Draw while something else is done; what is given waits, and says what came of each drawing.

    It is taken from `before` where it is the same; afterwards, `before` has them all.
    """
    from aseme_dsl.diagrams.rendering.drawn import Drawn, drawing

    known = {
        item.name: found[1] for item in drawings if (found := before.get(item.name)) and found[0] == item
    }
    new = [item for item in drawings if item.name not in known]
    with drawing(new, done=done) as results:

        def all_results() -> list[Result]:
            made: dict[str, Result] = {
                **known,
                **dict(zip((item.name for item in new), results(), strict=True)),
            }
            found = [made[item.name] for item in drawings]
            before.clear()
            before.update(
                (item.name, (item, result))
                for item, result in zip(drawings, found, strict=True)
                if isinstance(result, Drawn)
            )
            return found

        yield all_results


def _pictures(
    drawings: Sequence[Drawing],
    results: Sequence[Result],
    known: Known,
    notes: list[str],
    diagnostics: list[Diagnostic],
) -> Iterator[Planned]:
    """The files of the drawings; where Graphviz cannot draw, the text of one, with a warning."""
    from aseme_dsl.diagrams import DrawingFailed, GraphvizMissing, draw

    missing = False
    for drawing, made in zip(drawings, results, strict=True):
        drawn = draw(drawing, "dot") if missing else made
        if isinstance(drawn, DrawingFailed):
            missing = isinstance(drawn, GraphvizMissing)
            kind = GraphvizNotThere if missing else NotDrawn
            problem = kind(str(drawn), drawing.name)
            diagnostics.append(Diagnostic(problem, None, path=f"{drawing.name}.svg"))
            drawn = draw(drawing, "dot")
        notes += drawn.notes
        for name, content in drawn.files:
            yield known.recall(Planned, f"{DIAGRAMS}/{name}", content, DIAGRAMS)


def _proto(system: System, known: Known) -> Iterator[Planned]:
    """The messages for robots in other languages, with the files that they import: protoc needs no others."""
    from aseme_dsl.codegen.proto import file_name, proto_text

    yield _planned(known, f"{PROTO}/{file_name(system)}", proto_text(system), PROTO)
    for file in system.protos:
        if not file.name.startswith("google/protobuf/"):  # protoc has these
            yield _planned(known, f"{PROTO}/{file.name}", file.text, PROTO)


def _charts(system: System, name: str, choice: Choice) -> tuple[Statechart, ...]:
    """The statecharts of which a backend is to make code."""
    roles = choice.classes.get(name)
    return system.iacs if roles is None else tuple(chart for chart in system.iacs if chart.name in roles)


def _code(system: System, name: str, folder: Path, choice: Choice, known: Known) -> tuple[Planned, ...]:
    """What a backend generates, in a folder of its name; what is the user's goes among the activities."""
    from aseme_dsl.backends.backend import AGENTS, BackendOptions, find_backend

    activities = activities_folder(folder, choice, name)
    owner = AGENTS[0] if name in AGENTS else name
    if name in choice.classes:
        system = replace(system, iacs=_charts(system, name, choice))
    artefacts = find_backend(name).generate(system, BackendOptions(choice.templates, known))
    whole = [(artefact, known.whole(artefact.text)) for artefact in artefacts]
    return known.each(_of_artefact, whole, name, owner, str(folder), str(activities))


def _of_artefact(
    artefact: Artefact, text: str, name: str, owner: str, folder: str, activities: str
) -> Planned:
    """A file of a backend of this name; `owner` is the one whose activities it starts."""
    from aseme_dsl.backends.backend import ACTIVITIES

    if not artefact.kept:
        return Planned(f"{name}/{artefact.path}", _bytes(text), name)
    first, _, rest = artefact.path.partition("/")
    home = Path(activities, rest) if first == ACTIVITIES else Path(folder, name, artefact.path)
    return Planned(f"{owner if first == ACTIVITIES else name}/{artefact.path}", _bytes(text), name, home)


def _count(system: System, code: Sequence[Planned], written: Written) -> Count:
    """Activities that were filled in count as written by hand, the library's sources not at all."""
    generated = [file.content for file in code if file.home is None]
    by_hand: list[bytes] = []
    for file in code:
        if file.home is not None:
            content = _content(file.home)
            untouched = hash_of(content) in (hash_of(file.content), written.manifest.started.get(file.path))
            (generated if untouched else by_hand).append(content)
    homes = {file.home for file in code if file.home is not None}
    by_hand += [_content(path) for path in _helpers({home.parent for home in homes}) if path not in homes]
    own = [_bytes(source.text) for source in system.sources if not is_library_path(source.path)]
    return Count(amount(generated), amount(by_hand), amount(own))


def _helpers(folders: Iterable[Path]) -> list[Path]:
    """Python files beside activities that are none themselves: an activity has a class of its own name."""
    found: list[Path] = []
    for folder in folders:
        for path in sorted(folder.glob("*.py")):
            name = path.stem.replace("_", "").lower()
            classes = re.findall(rb"^class (\w+)", _content(path), re.MULTILINE)
            if name not in [item.decode(errors="replace").lower() for item in classes]:
                found.append(path)
    return found


def _bytes(text: str) -> bytes:
    """UTF-8; bytes that are not text are escaped (a file's name may be any bytes)."""
    return text.encode("utf-8", "backslashreplace")


def _content(path: Path) -> bytes:
    try:
        return outside.read_bytes(path)
    except OSError:
        return b""
