"""Functions of a document and of its project: whether there is the Python function that each of them names.

No code is imported: the file of a module is found as an import would find it, and parsed. Where that does not
decide, nothing is said.
"""

from __future__ import annotations

import ast
import sys
from collections.abc import Iterator, Sequence
from functools import lru_cache
from importlib.machinery import (
    EXTENSION_SUFFIXES,
    ExtensionFileLoader,
    FileFinder,
    ModuleSpec,
    SourceFileLoader,
)
from pathlib import Path

from aseme_dsl import outside
from aseme_dsl.amola.messages import Function
from aseme_dsl.amola.system import System
from aseme_dsl.diagnostics import Diagnostic, Problem, closest
from aseme_dsl.diagnostics.problems.python.code import (
    ModuleNotPython,
    NoPythonFunction,
    NoPythonModule,
    NotAPythonFunction,
    TakesByNameOnly,
    TakesOtherNumber,
    WorldTakesMore,
    WorldTakesNoSeed,
)
from aseme_dsl.project.files.stamp import Look, Stamp, stamp_of
from aseme_dsl.project.settings.configuration import Configuration, places_of_run
from aseme_dsl.records import dataclass
from aseme_dsl.source import Span

_PLAIN = (ast.Constant, ast.JoinedStr, ast.List, ast.Tuple, ast.Dict, ast.Set)


def check_functions(system: System, project: Path, look: Look = stamp_of) -> tuple[Diagnostic, ...]:
    """The functions of the document that Python does not have (E541), or has with other parameters (E542).

    `project` is the folder in which modules are looked for before the usual ones.
    """
    return tuple(problem for item in system.functions for problem in _of_function(item, project, look))


def function_files(system: System, project: Path) -> list[str]:
    """The paths of the files in `project`, there or not, in which the functions of the document are."""
    found: dict[str, None] = {}
    for function in system.functions:
        place = project.joinpath(*function.target.partition(":")[0].split("."))
        found[f"{place}.py"] = found[str(place / "__init__.py")] = None
    return list(found)


def check_configured(configuration: Configuration, look: Look = stamp_of) -> tuple[Diagnostic, ...]:
    """The functions that the project names for its runs, as those of the document: E541, E542."""
    run = configuration.run
    if run is None:
        return ()
    named = {"world": run.world, "progress": run.progress, "summary": run.summary}
    places = places_of_run(configuration, [key for key, target in named.items() if target is not None])
    found: list[Diagnostic] = []
    for key, place in places.items():
        target = named[key]
        assert target is not None
        code = _resolved(target, place, configuration.folder, look)
        if isinstance(code, Diagnostic):
            found.append(code)
        elif code is not None and (problem := _of_run(key, code)) is not None:
            found.append(Diagnostic(problem, place))
    return tuple(found)


_CALLED = {"world": "seed=…", "progress": "world", "summary": "world"}
"""What the functions of a run are called with; `progress` with what the agents do, too, if it takes it."""


def _of_run(key: str, code: ast.FunctionDef) -> Problem | None:
    """Why a function cannot be called in a run."""
    called, given = (code.name, _CALLED[key]), code.args
    by_name = _needed_by_name(given)
    if key == "world":
        names = [one.arg for one in (*given.args, *given.kwonlyargs)]
        needed = [one.arg for one in (*given.posonlyargs, *given.args)]
        needed = [*needed[: _parameters(given)[0]], *by_name]
        if others := [name for name in needed if name != "seed"]:
            return WorldTakesMore(*called, others[0])
        return None if "seed" in names or given.kwarg is not None else WorldTakesNoSeed(*called)
    if by_name:
        return TakesByNameOnly(*called, by_name[0])
    least, most = _parameters(given)
    largest = 2 if key == "progress" else 1
    if least <= largest and (most is None or most >= 1):
        return None
    return TakesOtherNumber(*called, least, most, 1)


def _of_function(function: Function, project: Path, look: Look) -> Iterator[Diagnostic]:
    if function.target.partition(":")[0] == "builtin":
        return
    place = _place(function)
    code = _resolved(function.target, place, project, look)
    if isinstance(code, Diagnostic):
        yield code
    elif code is not None:
        if by_name := _needed_by_name(code.args):
            yield Diagnostic(TakesByNameOnly(code.name, None, by_name[0]), place)
            return
        least, most = _parameters(code.args)
        count = len(function.parameters)
        if count < least or (most is not None and count > most):
            yield Diagnostic(TakesOtherNumber(code.name, None, least, most, count), place)


def _needed_by_name(given: ast.arguments) -> list[str]:
    return [one.arg for one, usual in zip(given.kwonlyargs, given.kw_defaults, strict=True) if usual is None]


def _resolved(target: str, place: Span, project: Path, look: Look) -> Diagnostic | ast.FunctionDef | None:
    """The function that a `module:name` is, if its file says all about it; or why there is none (E541)."""
    module, _, name = target.partition(":")
    found = _find_module(module, project)
    if isinstance(found, _Missing):
        near, parts = closest(found.name, found.there), module.split(".")
        meant = None
        if near is not None:
            meant = ".".join((*parts[: found.depth], near, *parts[found.depth + 1 :]))
        return Diagnostic(NoPythonModule(".".join(parts[: found.depth + 1]), meant, name), place)
    stamp = None if found is None else look(found)
    if found is None or stamp is None:
        return None
    code = _code(found, stamp)
    if isinstance(code, str):
        return Diagnostic(ModuleNotPython(module, code, found), place)
    if code is None:
        return None
    if name not in code.names:
        if code.is_open:
            return None
        return Diagnostic(NoPythonFunction(module, name, closest(name, code.names)), place)
    made = code.names[name]
    if isinstance(made, _PLAIN):
        return Diagnostic(NotAPythonFunction(module, name), place)
    return made if isinstance(made, ast.FunctionDef) and not made.decorator_list else None


def _place(function: Function) -> Span:
    """Where the document names the Python function."""
    text = function.span.source.text
    start = text.find(function.target, function.span.end)
    return Span(function.span.source, start, start + len(function.target)) if start >= 0 else function.span


# ---- modules -------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class _Missing:
    """A part of the name of a module that is not there, how many are before it, and what is there instead."""

    name: str
    depth: int
    there: tuple[str, ...]


def _find_module(module: str, project: Path) -> str | _Missing | None:
    """The path of the file of a module; None where it is not to be had without importing something."""
    parts = module.split(".")
    if parts[0] in sys.builtin_module_names or parts[0] in sys.stdlib_module_names:
        return None
    folders: Sequence[str] = [str(project), *sys.path]
    for depth, part in enumerate(parts):
        spec = _spec(part, folders)
        if spec is None or spec.loader is None:
            spec = (_otherwise(part) if depth == 0 else None) or spec
        if spec is None:
            return _Missing(part, depth, _modules(folders[:1] if depth == 0 else folders))
        inside = spec.submodule_search_locations
        if depth == len(parts) - 1:
            return spec.origin if spec.origin is not None and spec.origin.endswith(".py") else None
        if inside is None:
            return None  # a module that is not a package may still put others into `sys.modules`
        if spec.origin is not None and "__path__" in _text(spec.origin):
            return None
        folders = list(inside)
    return None


def _spec(name: str, folders: Sequence[str]) -> ModuleSpec | None:
    """What an import of `name` from `folders` finds, as they are now."""
    spaces: list[str] = []
    for folder in folders:
        finder = FileFinder(
            folder or ".", (ExtensionFileLoader, EXTENSION_SUFFIXES), (SourceFileLoader, [".py"])
        )
        spec = finder.find_spec(name)
        if spec is not None and spec.loader is not None:
            return spec
        if spec is not None:
            spaces += spec.submodule_search_locations or ()
    if not spaces:
        return None
    space = ModuleSpec(name, None, is_package=True)
    space.submodule_search_locations = spaces
    return space


def _otherwise(name: str) -> ModuleSpec | None:
    """What other ways to import know of a module: archives, installations that can be edited."""
    for finder in sys.meta_path:
        try:
            spec = finder.find_spec(name, None)
        except Exception:  # a finder of another package
            continue
        if spec is not None:
            return spec
    return None


def _modules(folders: Sequence[str]) -> tuple[str, ...]:
    """The names of the modules in the folders."""
    found: set[str] = set()
    for folder in map(Path, folders):
        if folder.is_dir():
            found |= {path.stem for path in folder.glob("*.py")}
            found |= {path.parent.name for path in folder.glob("*/__init__.py")}
    return tuple(sorted(found - {"__init__"}))


def _text(path: str) -> str:
    try:
        return outside.read_bytes(Path(path)).decode("utf-8-sig")
    except (OSError, UnicodeDecodeError):
        return ""


# ---- what is in them -----------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class _Code:
    """The names of a module with what makes each, if that is one thing; whether it may have others."""

    names: dict[str, ast.AST | None]
    is_open: bool


@lru_cache(maxsize=64)
def _code(path: str, stamp: Stamp) -> _Code | str | None:
    """What is in a file; or why it is not Python. None if it cannot be read."""
    try:
        tree = ast.parse(outside.read_bytes(Path(path)))
    except OSError:
        return None
    except (SyntaxError, ValueError, RecursionError, MemoryError) as problem:
        return (problem.msg if isinstance(problem, SyntaxError) else str(problem)) or type(problem).__name__
    names: dict[str, ast.AST | None] = {}

    def add(name: str, made: ast.AST | None) -> None:
        names[name] = None if name in names else made

    surely = set(map(id, tree.body))
    for node in _at_import(tree):
        made = node if id(node) in surely else None
        match node:
            case ast.FunctionDef(name=name) | ast.AsyncFunctionDef(name=name) | ast.ClassDef(name=name):
                add(name, made)
            case ast.Assign(targets=[ast.Name(id=name)], value=value):
                add(name, value if made is not None else None)
            case ast.Import(names=imported) | ast.ImportFrom(names=imported):
                for item in imported:
                    add((item.asname or item.name).partition(".")[0], None)
            case ast.Name(id=name, ctx=ast.Store()) if name not in names:
                add(name, None)
            case _:
                pass
    everything = list(ast.walk(tree))
    for node in everything:
        if isinstance(node, ast.Global):
            names.update(dict.fromkeys(node.names))
    used = {node.id for node in everything if isinstance(node, ast.Name)}
    used |= {node.attr for node in everything if isinstance(node, ast.Attribute)}
    is_open = "*" in names or "__getattr__" in names or not used.isdisjoint(_WAYS)
    return _Code(names, is_open)


_WAYS = ("globals", "vars", "exec", "setattr", "modules", "__dict__")
"""What a module may give itself names with."""


def _at_import(node: ast.AST) -> Iterator[ast.AST]:
    """What is run when the module is imported, in the order of the text."""
    for child in ast.iter_child_nodes(node):
        yield child
        if not isinstance(child, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef, ast.Lambda)):
            yield from _at_import(child)


def _parameters(given: ast.arguments) -> tuple[int, int | None]:
    """How many arguments a function takes by position, at least and at most."""
    most = len(given.posonlyargs) + len(given.args)
    return most - len(given.defaults), None if given.vararg is not None else most


__all__ = ["check_configured", "check_functions", "function_files"]
