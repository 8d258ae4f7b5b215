"""Activity files: which activities have one, which files nothing uses, first versions of what is missing.

No code is imported: who uses a file is found in the texts of those that import it.
"""

from __future__ import annotations

import ast
import os
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Literal, TypeGuard

from aseme_dsl import outside
from aseme_dsl.amola.expression import duration_text
from aseme_dsl.amola.liveness import names as names_in
from aseme_dsl.amola.statechart import StateType
from aseme_dsl.diagnostics import Diagnostic, Problem, Related, closest
from aseme_dsl.diagnostics.problems.python.code import (
    CodeNamedOtherwise,
    FileNotUsed,
    FileOfSimulated,
    NoCode,
    NoCodeFolder,
    NoCodeOfParticipant,
)
from aseme_dsl.project.files.stamp import Look, Stamp, stamp_of
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.message.naming import class_name, module_name
from aseme_dsl.source import Source, Span, is_library_path

if TYPE_CHECKING:
    from aseme_dsl.amola.aip import Aip, Participant
    from aseme_dsl.amola.srm import Activity
    from aseme_dsl.amola.system import System


@dataclass(frozen=True, slots=True)
class Required:
    """That the files of the activities have to be in a folder: a project, or an option, names it.

    `place` is where the project does, None for an option. `users` are Python files that may import what is in
    the folder; the systems in `neighbours` may share it.
    """

    place: Span | None = None
    users: tuple[str, ...] = ()
    neighbours: tuple[Path, ...] = ()


@dataclass(frozen=True, slots=True)
class Wanted:
    """An activity, or a module whose code is found by its name, with the path of its file."""

    said: Activity
    path: str
    what: str
    roles: tuple[Span, ...]
    unplayed: Unplayed | None = None


@dataclass(frozen=True, slots=True)
class Unplayed:
    """That a role has an activity where it seems to mean a participant, which it does not play (W202).

    Several protocols may have one of that name. `activities` are those that the role would have then.
    """

    protocols: tuple[str, ...]
    role: str
    places: tuple[Related, ...]
    activities: frozenset[str]


def wanted_files(system: System, folder: Path) -> tuple[Wanted, ...]:
    """What has its code in the folder, simulated activities included, each once."""
    roles: dict[str, list[Span]] = {}
    unplayed: dict[str, Unplayed] = {}
    participants: dict[str, list[tuple[Aip, Participant]]] = {}
    for aip in system.aips:
        for part in aip.participants:
            participants.setdefault(part.name, []).append((aip, part))
    modules: dict[str, Activity] = {}
    for chart in system.iacs:
        names = {node.activity for node in chart.states if node.type is StateType.BASIC and node.activity}
        for module in chart.modules:
            if not module.target:
                modules.setdefault(module.name, module.statement)
                names.add(module.name)
        for name in names:
            roles.setdefault(name, []).append(chart.root.span)
        for name in names & participants.keys():
            unplayed.setdefault(name, _unplayed(chart.name, participants[name]))
    found = [(item, "activity") for item in system.activities if item.name in roles]
    found += [(item, "module") for item in modules.values()]
    return tuple(
        Wanted(
            item,
            str(folder / f"{module_name(item.name)}.py"),
            what,
            tuple(roles[item.name]),
            unplayed.get(item.name) if what == "activity" else None,
        )
        for item, what in found
    )


def _unplayed(role: str, alike: Sequence[tuple[Aip, Participant]]) -> Unplayed:
    done = {
        name
        for _, part in alike
        for name in {node.name for item in part.formulas for node in names_in(item.formula)}
        - {item.name for item in part.formulas}
    }
    return Unplayed(
        tuple(aip.name for aip, _ in alike),
        role,
        tuple(
            Related(part.span, f"the participant of {aip.name}, which {role} does not play")
            for aip, part in alike
        ),
        frozenset(done),
    )


def missing_folder(
    system: System, folder: Path, required: Required, project: Path | None
) -> tuple[Diagnostic, ...]:
    """E544: the folder is not there."""
    lacking = [item.said.name for item in wanted_files(system, folder) if item.said.has_code]
    near = closest(folder.name, [path.name for path in _inside(folder.parent) if path.is_dir()])
    scaffold = _scaffold(system) if lacking else None
    problem = NoCodeFolder(_shown(str(folder), project), near, scaffold, required.place is None)
    path = None if required.place is not None else str(folder)
    return (Diagnostic(problem, required.place, path=path),)


def check_files(
    system: System, folder: Path, required: Required, project: Path | None, look: Look = stamp_of
) -> tuple[Diagnostic, ...]:
    """E543 for an activity without a file, W541 for a file that nothing uses, W542 for one of a simulated
    activity."""
    wanted = wanted_files(system, folder)
    there = {item.path for item in wanted if look(item.path) is not None}
    own = [item.path for item in wanted if item.said.has_code]
    users = [*own, *required.users, *_targets(system, project)]
    imported = _imported(users, folder, project, look)
    beside = [str(path) for path in _inside(folder) if path.suffix == ".py"]
    used = set(map(os.path.realpath, [*users, *(item.path for item in wanted), *(imported or ())]))
    unused = [] if imported is None else _unused(beside, used, system)
    unused = _not_of_neighbours(unused, system, required.neighbours)
    missing = [item for item in wanted if item.path not in there and item.said.has_code]
    to_play = [item for item in missing if item.unplayed is not None]
    then_used = {module_name(name) for item in to_play if item.unplayed for name in item.unplayed.activities}
    unused = [path for path in unused if Path(path).stem not in then_used]
    missing = [item for item in missing if item.unplayed is None]
    modules = {Path(path).stem: path for path in unused}
    found = [_missing(item, None, system, project) for item in to_play]
    # One file too few and one too many: an activity has been renamed, even if the names are not alike.
    is_renamed = len(missing) == len(unused) == 1 and _is_of_class(unused[0])
    for item in missing:
        near = modules.get(closest(Path(item.path).stem, modules) or "")
        found.append(_missing(item, unused[0] if is_renamed else near, system, project))
    for path in unused:
        near = closest(Path(path).stem, [Path(item.path).stem for item in missing])
        meant = next((item for item in missing if is_renamed or Path(item.path).stem == near), None)
        found.append(_unneeded(path, meant, project))
    for item in wanted:
        is_helper = imported is not None and os.path.realpath(item.path) in imported
        if not item.said.has_code and item.path in there and not is_helper:
            shown = _shown(item.path, project)
            word: Literal["simulated", "waits"] = "waits" if item.said.waits else "simulated"
            place, problem = _place(item), FileOfSimulated(item.said.name, shown, word)
            found.append(Diagnostic(problem, place, _declared(item, place)))
    return tuple(found)


def _missing(item: Wanted, near: str | None, system: System, project: Path | None) -> Diagnostic:
    name, file = item.said.name, _shown(item.path, project)
    related: tuple[Related, ...] = ()
    problem: Problem
    if item.unplayed is not None:
        related = item.unplayed.places
        problem = NoCodeOfParticipant(name, item.unplayed.protocols, item.unplayed.role, file)
    elif near is not None:
        own_class = class_name(name) if _is_of_class(near) else None
        there = _shown(near, project)
        problem = CodeNamedOtherwise(item.what, name, file, there, Path(file).name, own_class)
    else:
        simulated = as_simulated(item.said) if item.what == "activity" else None
        problem = NoCode(item.what, name, file, _scaffold(system), simulated)
    place = _place(item)
    return Diagnostic(problem, place, (*_declared(item, place), *related))


def as_simulated(said: Activity) -> str:
    """How the file says that there is no code for an activity."""
    return f"{said.name} takes {'1s' if said.takes is None else duration_text(said.takes)} simulated"


def _unneeded(path: str, meant: Wanted | None, project: Path | None) -> Diagnostic:
    rename = own_class = None
    related: tuple[Related, ...] = ()
    if meant is not None:
        rename = Path(meant.path).name
        own_class = class_name(meant.said.name) if _is_of_class(path) else None
        related = (Related(meant.said.span, f"the {meant.what} `{meant.said.name}`, which has no file"),)
    problem = FileNotUsed(_shown(path, project), rename, own_class)
    return Diagnostic(problem, _first_line(path), related, path=path)


def _place(item: Wanted) -> Span:
    """Where the user's files speak of it: of an activity of the library, the role that performs it."""
    is_library = is_library_path(item.said.span.source.path)
    return item.roles[0] if is_library and item.roles else item.said.span


def _declared(item: Wanted, place: Span) -> tuple[Related, ...]:
    return () if place == item.said.span else (Related(item.said.span, f"the {item.what}"),)


def _scaffold(system: System) -> str:
    """The name of the file of which `asemec scaffold` starts what is missing."""
    file = system.span.source.path if system.span is not None else "FILE"
    return Path(file).name


def _shown(path: str, project: Path | None) -> str:
    """A path as seen from the project, if it is inside."""
    place = Path(path)
    if project is not None and place.is_relative_to(project):
        return place.relative_to(project).as_posix()
    return path


def _inside(folder: Path) -> list[Path]:
    try:
        return sorted(folder.iterdir())
    except OSError:
        return []


def _text(path: str) -> str:
    try:
        return outside.read_bytes(Path(path)).decode("utf-8-sig").replace("\r\n", "\n")
    except (OSError, UnicodeDecodeError):
        return ""


def _is_of_class(path: str) -> bool:
    """Whether a file has a class that is called like it, as that of an activity."""
    stem = Path(path).stem
    return any(module_name(name) == stem for name in re.findall(r"^class\s+(\w+)", _text(path), re.MULTILINE))


def _first_line(path: str) -> Span | None:
    """The name of the first class, or else the first line."""
    source = Source(path, _text(path))
    found = re.search(r"^class\s+(\w+)", source.text, re.MULTILINE)
    if found is not None:
        return Span(source, *found.span(1))
    return Span(source, 0, len(source.line(1)))


# ---- who uses a file -----------------------------------------------------------------------------


def _targets(system: System, project: Path | None) -> list[str]:
    """The files of the modules that say where their code is."""
    if project is None:
        return []
    targets = {module.target for chart in system.iacs for module in chart.modules if module.target}
    places = [project.joinpath(*target.partition(":")[0].split(".")) for target in sorted(targets)]
    return [path for place in places for path in (f"{place}.py", str(place / "__init__.py"))]


def _unused(paths: Iterable[str], used: set[str], system: System) -> list[str]:
    """Files that are not used, nor have a purpose of their own beside activities."""
    names = ["".join(dict.fromkeys(map(class_name, (system.name, chart.name)))) for chart in system.iacs]
    agents = "|".join(re.escape(module_name(f"{name}Agent")) for name in names)  # of jade_like
    other = re.compile(rf"__\w+__|conftest|test_.*|.*_test|(?:{agents})\d*")
    return [
        path for path in paths if os.path.realpath(path) not in used and not other.fullmatch(Path(path).stem)
    ]


def _not_of_neighbours(unused: list[str], system: System, neighbours: Sequence[Path]) -> list[str]:
    """Without the files whose activity another system names, itself or through what it imports."""
    own = {Path(source.path).resolve() for source in system.sources}
    others = [path for path in neighbours if path.resolve() not in own] if unused else []
    named: set[str] = set()
    for path in others:
        text = _text(str(path))
        for library in re.findall(r"\bimport\s+(\w+)", text):
            text += _library(library)
        named.update(map(module_name, re.findall(r"[A-Za-z_]\w*", text)))
    return [path for path in unused if Path(path).stem not in named]


def _library(name: str) -> str:
    from aseme_dsl.standard_library import standard_library

    try:
        return _text(str(standard_library() / f"{name}.aseme"))
    except FileNotFoundError:
        return ""


def _imported(roots: Iterable[str], folder: Path, project: Path | None, look: Look) -> frozenset[str] | None:
    """All files that the roots import, directly or not; None if one of them computes what it imports."""
    real = Path(os.path.realpath(folder))
    waiting = list(dict.fromkeys(os.path.realpath(path) for path in (*roots, str(real / "__init__.py"))))
    begun = set(waiting)
    found: set[str] = set()
    while waiting:
        path = waiting.pop()
        stamp = look(path)
        said = None if stamp is None else _imports(path, stamp)
        if said is None:
            continue
        modules, is_open = said
        if is_open and Path(path).parent == real:
            return None
        for level, module, _ in modules:
            for other in _files_of(Path(path).parent, level, module, project):
                path_of_other = os.path.realpath(other)
                found.add(path_of_other)
                if path_of_other not in begun:
                    begun.add(path_of_other)
                    waiting.append(path_of_other)
    return frozenset(found)


def _files_of(here: Path, level: int, module: str, project: Path | None) -> Iterator[str]:
    """The files, there or not, that an import may mean: of the module, and of the packages around it."""
    bases = [here]
    if level == 0 and project is not None:
        bases.append(project)
    for _ in range(level - 1):
        bases = [base.parent for base in bases]
    parts = [part for part in module.split(".") if part]
    for base in bases:
        for depth in range(1, len(parts) + 1):
            place = base.joinpath(*parts[:depth])
            yield f"{place}.py"
            yield str(place / "__init__.py")


@lru_cache(maxsize=512)
def _imports(path: str, stamp: Stamp) -> tuple[tuple[tuple[int, str, bool], ...], bool] | None:
    """The modules that a file imports, with the dots before each; whether it may import others, too.

    Third is whether the import has to succeed: inside `try` it may fail, what is for types is not imported.
    """
    try:
        tree = ast.parse(_text(path))
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return None
    found: list[tuple[int, str, bool]] = []
    is_open = False
    spared = {
        id(inner)
        for node in ast.walk(tree)
        if _may_fail(node)
        for part in node.body
        for inner in ast.walk(part)
    }
    for node in ast.walk(tree):
        match node:
            case ast.Import(names=names):
                found += ((0, item.name, id(node) not in spared) for item in names)
                is_open = is_open or any(item.name.split(".")[0] in _WAYS for item in names)
            case ast.ImportFrom(module=module, names=names, level=level):
                inside = f"{module}." if module else ""
                found += ((level, f"{inside}{item.name}", id(node) not in spared) for item in names)
                is_open = is_open or (level == 0 and inside.split(".")[0] in _WAYS)
            case ast.Name(id="__import__"):
                is_open = True
            case _:
                pass
    return tuple(found), is_open


def _may_fail(node: ast.AST) -> TypeGuard[ast.Try | ast.If]:
    """Whether an import in the body of a statement need not succeed."""
    if isinstance(node, ast.If):
        test = node.test
        return "TYPE_CHECKING" in (getattr(test, "id", None), getattr(test, "attr", None))
    return isinstance(node, ast.Try)


def needed_by(
    roots: Iterable[str], folder: Path, project: Path | None, look: Look = stamp_of
) -> Mapping[str, str]:
    """The real paths of the files that the roots cannot do without, each with that of one that imports it."""
    first = [path for path in roots if look(path) is not None]
    waiting = [os.path.realpath(path) for path in first]
    if first:
        waiting.append(os.path.realpath(folder / "__init__.py"))
    found: dict[str, str] = {}
    begun = set(waiting)
    while waiting:
        path = waiting.pop()
        stamp = look(path)
        said = None if stamp is None else _imports(path, stamp)
        for level, module, is_needed in said[0] if said is not None else ():
            for name in _files_of(Path(path).parent, level, module, project) if is_needed else ():
                other = os.path.realpath(name)
                if other not in begun and look(other) is not None:
                    begun.add(other)
                    found[other] = path
                    waiting.append(other)
    return found


_WAYS = ("importlib", "pkgutil", "runpy")
"""With what a file imports by a name that it computes."""


# ---- what has no code ----------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class WithoutCode:
    """The names of activities that only last when they are played, by the reason.

    `simulated` say so; `missing` have no file; `empty` have one in which nothing is written yet.
    """

    simulated: tuple[str, ...]
    missing: tuple[str, ...]
    empty: tuple[str, ...]


def without_code(system: System, folder: Path, look: Look = stamp_of) -> WithoutCode:
    """Which activities of a system have no code in `folder`, as far as the texts of the files show."""
    called = _callbacks(folder)
    wanted = (item for item in wanted_files(system, folder) if item.what == "activity")
    activities = [item for item in wanted if item.said.name not in called]
    simulated = [item for item in activities if item.said.simulated]
    others = [item for item in activities if item.said.has_code]
    missing = [item for item in others if look(item.path) is None]
    empty = [
        item
        for item in others
        if item not in missing and class_name(item.said.name) in empty_classes(_parsed(item.path))
    ]
    return WithoutCode(*(tuple(item.said.name for item in items) for items in (simulated, missing, empty)))


def _callbacks(folder: Path) -> frozenset[str]:
    """The activities that are methods of behaviours, in the files of JADE-like agents."""
    from aseme_dsl.runtime.agent.fipa_callbacks import CALLBACKS

    methods = {
        item.name
        for path in sorted(folder.glob("*_agent.py"))
        for node in _parsed(str(path)).body
        if isinstance(node, ast.ClassDef)
        for item in node.body
        if isinstance(item, ast.FunctionDef)
    }
    return frozenset(
        activity
        for table in CALLBACKS.values()
        if any(item.method in methods for item in table.values())
        for activity, item in table.items()
        if item.method in methods or item.does not in ("content", "decide", "result", "condition")
    )


def _parsed(path: str) -> ast.Module:
    try:
        return ast.parse(_text(path))
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return ast.Module([], [])


def empty_classes(tree: ast.Module) -> frozenset[str]:
    """The classes whose `execute` is a docstring, as they are started. A user has written `pass`."""
    return frozenset(
        node.name
        for node in tree.body
        if isinstance(node, ast.ClassDef)
        for item in node.body
        if isinstance(item, (ast.FunctionDef, ast.AsyncFunctionDef)) and item.name == "execute"
        if all(isinstance(part, ast.Expr) and isinstance(part.value, ast.Constant) for part in item.body)
    )


def stubs(system: System, folder: Path, templates: Path | None = None) -> dict[Path, bytes]:
    """First versions of the files that are missing in `folder`, by their paths."""
    wanted = _first_versions(system, folder, templates)
    return {path: content for path, content in wanted.items() if stamp_of(path) is None}


def renewed_stubs(
    system: System, folder: Path, templates: Path | None = None
) -> dict[Path, tuple[bytes, bytes]]:
    """Files that are as they were started, without an edit, and that would be started otherwise now.

    Each is given as it is and as it would be.
    """
    found: dict[Path, tuple[bytes, bytes]] = {}
    for path, content in _first_versions(system, folder, templates).items():
        if path.is_symlink() or not path.is_file():
            continue
        try:
            before = outside.read_bytes(path)
        except OSError:
            continue
        if before != content and _is_as_started(before, content):
            found[path] = (before, content)
    return found


def _first_versions(system: System, folder: Path, templates: Path | None) -> dict[Path, bytes]:
    from aseme_dsl.backends.backend import ACTIVITIES, AGENTS, BackendOptions, find_backend

    found: dict[Path, bytes] = {}
    for artefact in find_backend(AGENTS[0]).generate(system, BackendOptions(templates)):
        first, _, rest = artefact.path.partition("/")
        if artefact.kept and first == ACTIVITIES:
            found[folder / rest] = artefact.text.encode("utf-8", "backslashreplace")
    return found


_DESCRIBES = re.compile(
    r"""from\ (?:aseme_dsl|monas)\.[\w.]+\ import\ [\w, ]+
    | \ {4}(?:Uses|Reads|Writes|Runs\ every|Is\ given)\ .*
    | \ {4}(?:Is\ cancelled,\ and\ fails,|Returns\ how\ it\ has\ ended:)\ .*
    | \ {4}def\ execute\(self,\ context:\ Context(?:,\ \w+:\ [\w.\[\]]+)*\)\ ->\ [\w |]+:""",
    re.VERBOSE,
)
"""The lines of a first version that follow from what the file says of the activity."""


def _is_as_started(before: bytes, now: bytes) -> bool:
    """Whether a file has no line but those of a first version, for any description of its activity."""
    try:
        lines = before.decode("utf-8").splitlines()
    except UnicodeDecodeError:
        return False
    known = {"", *now.decode("utf-8", "replace").splitlines()}
    return all(line in known or _DESCRIBES.fullmatch(line) for line in lines)


__all__ = [
    "Required",
    "WithoutCode",
    "as_simulated",
    "check_files",
    "empty_classes",
    "missing_folder",
    "needed_by",
    "renewed_stubs",
    "stubs",
    "wanted_files",
    "without_code",
]
