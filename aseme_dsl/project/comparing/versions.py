"""Versions: a file, a folder of a project or a build, or a git revision, as the models of one system."""

from __future__ import annotations

import ast
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import fields, is_dataclass, replace
from pathlib import Path, PurePosixPath
from tempfile import TemporaryDirectory
from typing import TypeVar, cast

from aseme_dsl import outside
from aseme_dsl.amola.system import System
from aseme_dsl.compiler.phases import inspect_files
from aseme_dsl.diagnostics import Diagnostic, Problem, has_errors
from aseme_dsl.project.building.project import configuration_for, options_of
from aseme_dsl.project.settings.configuration import Configuration
from aseme_dsl.project.settings.target import sources_of
from aseme_dsl.records import dataclass

_T = TypeVar("_T")

SUFFIXES = (".aseme", ".proto", ".py", ".toml")
"""What of a revision is read: sources, the code of functions, and the project's settings."""
LARGEST = 50_000_000
"""So many bytes of a revision are read, at the most."""
_PATIENCE = 60.0
"""So many seconds git may take."""


class NotAVersion(Exception):
    """What was named is not a version of a system; the text says why."""


@dataclass(frozen=True, slots=True)
class Compiled:
    """One version of a system. `name` is how people named it; a system with errors has none."""

    name: str
    root: Path
    configuration: Configuration
    system: System | None
    diagnostics: tuple[Diagnostic, ...]


@contextmanager
def opened(name: str, path: str | None = None) -> Iterator[Compiled]:
    """The version that a name means, as long as it is looked at: a file, a folder of a project or of a
    build, or a git revision.

    Of a revision, `path` is the file or folder; `REVISION:PATH` names both.

    Raises:
        NotAVersion: it is none, or not of one system.
    """
    built = sorted(Path(name).glob("monas/*/__init__.py")) if Path(name).is_dir() else []
    if built:
        with TemporaryDirectory(prefix="asemec-diff-") as folder:
            yield _compiled(name, _sources_of_build(built, Path(folder).resolve(), name))
        return
    if Path(name).exists():
        yield _compiled(name, Path(name))
        return
    revision, _, inside = name.partition(":")
    with TemporaryDirectory(prefix="asemec-diff-") as folder:
        root = Path(folder).resolve()
        place = _check_out(revision, inside or path or ".", root, name)
        found = _compiled(name, place)
        yield replace(found, diagnostics=_as_in_git(found.diagnostics, f"{root}/", f"{revision}:"))


def _as_in_git(value: _T, folder: str, revision: str) -> _T:
    """What is said of files of a revision, with their names as git has them: `HEAD~1:parts/legs.aseme`."""
    if isinstance(value, str):
        return cast("_T", value.replace(folder, revision))
    if isinstance(value, Problem):
        return value.but(**{name: _as_in_git(item, folder, revision) for name, item in vars(value).items()})
    if isinstance(value, tuple):
        return cast("_T", tuple(_as_in_git(item, folder, revision) for item in value))
    if not is_dataclass(value) or isinstance(value, type):
        return value
    inside = {item.name: getattr(value, item.name) for item in fields(value) if item.init}
    return replace(value, **{name: _as_in_git(item, folder, revision) for name, item in inside.items()})


def _compiled(name: str, place: Path) -> Compiled:
    inputs = sources_of([str(place)], bytes)
    if has_errors(inputs.diagnostics):
        raise NotAVersion(f"{name}: {inputs.diagnostics[0].message}")
    if len(inputs.roots) != 1 or not isinstance(inputs.roots[0], Path):
        names = ", ".join(str(root) for root in inputs.roots) or "no `system` declaration"
        raise NotAVersion(f"{name} contains {len(inputs.roots)} systems ({names}), not one: name its file")
    root = inputs.roots[0]
    configuration, problems = configuration_for(root)
    found = inspect_files(root, None, options_of(configuration)).analysis
    return Compiled(name, root, configuration, found.system, (*problems, *found.diagnostics))


def _sources_of_build(built: list[Path], folder: Path, name: str) -> Path:
    """Write the files of which a build was made into a folder; the place of the file with the system."""
    if len(built) > 1:
        raise NotAVersion(f"{name} contains the builds of {len(built)} systems: name the folder of one")
    values: dict[str, object] = {}
    try:
        for item in ast.parse(outside.read_bytes(built[0]).decode()).body:
            if isinstance(item, ast.Assign) and isinstance(item.targets[0], ast.Name):
                with suppress(ValueError):
                    values[item.targets[0].id] = ast.literal_eval(item.value)
    except (OSError, ValueError, SyntaxError, RecursionError, MemoryError) as problem:
        raise NotAVersion(f"{built[0]} cannot be read: {problem}") from problem
    sources, root = values.get("SOURCES"), values.get("SOURCE")
    if not isinstance(sources, dict) or root not in [PurePosixPath(str(path)).name for path in sources]:
        raise NotAVersion(f"{built[0]} does not have the files that it was made of")
    for path, text in sources.items():
        inside = PurePosixPath(str(path))
        if inside.is_absolute() or ".." in inside.parts:
            raise NotAVersion(f"{built[0]} was made of {path}, which is outside of its folder")
        target = folder / inside
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(str(text), encoding="utf-8")
    return next(folder / str(path) for path in sources if PurePosixPath(str(path)).name == root)


# ---- git ---------------------------------------------------------------------------------------------


def _check_out(revision: str, path: str, folder: Path, name: str) -> Path:
    """Write what a revision has into a folder; the place of the file or folder that is meant."""
    if revision.startswith("-") or not revision:
        raise NotAVersion(f"there is no file {name}, and that is not the name of a revision")
    try:
        top = Path(_git(["rev-parse", "--show-toplevel"]).decode().strip())
    except NotAVersion as problem:
        raise NotAVersion(f"there is no file {name}, and no revision of that name: {problem}") from None
    try:
        commit = _git(["rev-parse", "--verify", "--quiet", "--end-of-options", f"{revision}^{{commit}}"])
    except NotAVersion:
        raise NotAVersion(f"there is no file {name}, and no revision {revision}") from None
    inside = _inside(path, top)
    listed = _git(["ls-tree", "-r", "-l", "-z", "--full-tree", commit.decode().strip()]).split(b"\0")
    wanted: list[tuple[str, PurePosixPath]] = []
    total = 0
    for line in filter(None, listed):
        about, _, called = line.partition(b"\t")
        mode, kind, blob, size = about.split()
        place = PurePosixPath(called.decode("utf-8", "surrogateescape"))
        if kind != b"blob" or mode == b"120000" or place.suffix not in SUFFIXES:
            continue
        total += int(size)
        wanted.append((blob.decode(), place))
    if total > LARGEST:
        raise NotAVersion(f"the sources of {revision} have more than {LARGEST // 1_000_000} MB")
    _write(wanted, folder)
    target = folder / inside
    if not target.exists():
        raise NotAVersion(f"{revision} has no {inside}")
    return target


def _inside(path: str, top: Path) -> Path:
    """Where a path of the working tree is in the repository."""
    try:
        return Path(path).resolve().relative_to(top.resolve())
    except ValueError:
        raise NotAVersion(f"{path} is not in the git repository {top}") from None


def _write(wanted: list[tuple[str, PurePosixPath]], folder: Path) -> None:
    names = "".join(f"{blob}\n" for blob, _ in wanted)
    content = _git(["cat-file", "--batch"], names.encode())
    place = 0
    for _, path in wanted:
        end = content.index(b"\n", place)
        size = int(content[place:end].split()[-1])
        target = folder / path
        if ".." in path.parts or path.is_absolute():
            raise NotAVersion(f"a file of the revision is called {path}")
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_bytes(content[end + 1 : end + 1 + size])
        place = end + 1 + size + 1


def _git(arguments: list[str], given: bytes = b"") -> bytes:
    """What git prints. Raises NotAVersion with what it says."""
    try:
        done = subprocess.run(
            ["git", *arguments], input=given, capture_output=True, timeout=_PATIENCE, check=False
        )
    except FileNotFoundError:
        raise NotAVersion("git is not installed") from None
    except (OSError, subprocess.TimeoutExpired) as problem:
        raise NotAVersion(f"git cannot be asked: {problem}") from problem
    if done.returncode:
        said = done.stderr.decode(errors="replace").strip().splitlines()
        raise NotAVersion(said[-1].rstrip(".") if said else f"git ended with {done.returncode}")
    return done.stdout


__all__ = ["Compiled", "NotAVersion", "opened"]
