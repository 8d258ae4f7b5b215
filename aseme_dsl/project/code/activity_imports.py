"""Activity imports: whether the generated modules that activities import are those of a system."""

from __future__ import annotations

import ast
import re
from collections.abc import Collection, Iterable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, TypeGuard

from aseme_dsl import outside
from aseme_dsl.backends.backend import AGENTS, ROLE_MODULES
from aseme_dsl.diagnostics import Diagnostic, Edit, closest
from aseme_dsl.diagnostics.problems.python.code import (
    NoGeneratedModule,
    NoGeneratedSystem,
    NoModuleOfPackage,
    NoNameOfRuntime,
)
from aseme_dsl.project.code.activity_access import Place
from aseme_dsl.project.code.renamed import NAMES
from aseme_dsl.runtime.message.naming import class_name, usable
from aseme_dsl.source import Span

if TYPE_CHECKING:
    from aseme_dsl.amola.system import System

_OURS = "aseme_dsl"
_SYSTEM = re.compile(r"^\s*system\s+(\w+)", re.MULTILINE)


def systems_beside(system: System, neighbours: Iterable[Path]) -> frozenset[str]:
    """The names of a system and of those that may share its activities."""
    found = {system.name}
    for path in neighbours:
        try:
            found.update(_SYSTEM.findall(outside.read_bytes(path).decode("utf-8-sig")))
        except (OSError, UnicodeDecodeError):
            continue
    return frozenset(found)


def wrong_imports(
    tree: ast.Module, system: System, systems: Collection[str], place: Place
) -> Iterator[Diagnostic]:
    """E546 for imports of modules that do not exist, generated or of `aseme_dsl`.

    The system of a generated module may be unknown, as after it was renamed, or not have such a module. A
    module of `aseme_dsl` may have been moved. An import inside `try` may fail.
    """
    tried = {id(inner) for node in ast.walk(tree) if isinstance(node, ast.Try) for inner in ast.walk(node)}
    told: set[Span | None] = set()
    for node in ast.walk(tree):
        if not isinstance(node, (ast.Import, ast.ImportFrom)) or id(node) in tried:
            continue
        for parts, is_name in _modules(node):
            problem: Diagnostic | None = None
            backend, name = parts[0], parts[1] if len(parts) > 1 else "*"
            if name == "*" or backend not in (*AGENTS, _OURS):
                continue
            if backend == _OURS:
                problem = _not_of_ours(parts[:-1] if is_name else parts, place(node))
                if parts[:-1] == (_OURS, "runtime") and is_name and _not_of_ours(parts, place(node)):
                    problem = _not_of_runtime(node, parts[-1], tree, place)
            elif name not in systems:
                problem = Diagnostic(
                    NoGeneratedSystem(backend, name, system.name),
                    _place(place(node), parts[:2]),
                    fix=system.name if len(systems) == 1 else None,
                )
            elif name == system.name:
                problem = _not_generated(parts, is_name, system, place(node))
            if problem is not None and problem.span not in told:
                told.add(problem.span)
                yield problem


def _not_of_ours(parts: tuple[str, ...], whole: Span) -> Diagnostic | None:
    """E546 for a module that our package does not have, with the one of its name that is elsewhere in it."""
    folder = Path(__file__).parents[2]
    for depth, part in enumerate(parts[1:], 2):
        if (folder / f"{part}.py").is_file():
            return None
        if not (folder / part).is_dir():
            found = [path.relative_to(folder) for path in folder.rglob(f"{part}.py")]
            now = ".".join(found[0].with_suffix("").parts) if len(found) == 1 else None
            moved = None if now is None else ".".join([*parts[: depth - 1], now])
            problem = NoModuleOfPackage(".".join(parts[:depth]), moved)
            return Diagnostic(problem, _place(whole, parts[:depth]), fix=now)
        folder /= part
    return None


def _not_of_runtime(
    node: ast.Import | ast.ImportFrom, name: str, tree: ast.Module, place: Place
) -> Diagnostic | None:
    """E546 for a name that the runtime does not have, with the changes that give it its new one."""
    from aseme_dsl import runtime

    if name in runtime.__all__:
        return None
    now = NAMES.get(name)
    near = None if now is not None else closest(name, runtime.__all__)
    imported = next(item for item in node.names if item.name == name)
    whole = place(imported)
    span = Span(whole.source, whole.start, whole.start + len(name))
    used = [] if imported.asname is not None else [node for node in ast.walk(tree) if _is(node, name)]
    edits = () if now is None else tuple(Edit(item, now) for item in (span, *map(place, used)))
    return Diagnostic(NoNameOfRuntime(name, now, near), span, edits=edits)


def _is(node: ast.AST, name: str) -> TypeGuard[ast.Name]:
    return isinstance(node, ast.Name) and node.id == name


def _not_generated(parts: tuple[str, ...], is_name: bool, system: System, whole: Span) -> Diagnostic | None:
    """E546 for a module that the package of a system does not have.

    The last of the parts may be a name in the module before it: then only one that is almost a module's is.
    """
    backend, _, *rest = parts
    roles = [usable(chart.name) for chart in system.iacs]
    there = ["messages", *roles]
    names = [*_NAMES, *(f"{class_name(chart.name)}{end}" for chart in system.iacs for end in _CLASSES)]
    for depth, part in enumerate(rest[:2], 3):
        near = closest(part, there)
        may_be_name = is_name and depth == len(parts)
        if part not in there and not (may_be_name and (near is None or part in names)):
            problem = NoGeneratedModule(".".join(parts[:depth]), near, tuple(there))
            return Diagnostic(problem, _place(whole, parts[:depth]), fix=near)
        if part not in roles:
            return None
        there = list(ROLE_MODULES[backend])
    return None


_NAMES = ("SYSTEM", "SOURCE", "MODEL", "TEAM", "CHARTS", "AGENTS")
"""What the package of a system has beside the classes of its roles."""
_CLASSES = ("Step", "Agent")


def _place(whole: Span, parts: Iterable[str]) -> Span:
    """The last of the parts that follow each other in a statement."""
    start = end = 0
    for part in parts:
        found = re.compile(rf"\b{re.escape(part)}\b").search(whole.text, end)
        if found is not None:
            start, end = found.span()
    return Span(whole.source, whole.start + start, whole.start + end)


def _modules(node: ast.Import | ast.ImportFrom) -> list[tuple[tuple[str, ...], bool]]:
    """The parts of what is imported; whether the last is only perhaps a module."""
    if isinstance(node, ast.Import):
        return [(tuple(item.name.split(".")), False) for item in node.names]
    if node.level or node.module is None:
        return []
    within = tuple(node.module.split("."))
    return [((*within, *([] if item.name == "*" else [item.name])), item.name != "*") for item in node.names]


__all__ = ["systems_beside", "wrong_imports"]
