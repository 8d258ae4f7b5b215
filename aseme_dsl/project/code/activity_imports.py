"""Activity imports: whether the generated modules that activities import are those of a system."""

from __future__ import annotations

import ast
import re
from collections.abc import Callable, Collection, Iterable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from aseme_dsl import outside
from aseme_dsl.backends.backend import AGENTS
from aseme_dsl.diagnostics import Diagnostic, closest
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
    tree: ast.Module, system: System, systems: Collection[str], place: Callable[[ast.expr | ast.stmt], Span]
) -> Iterator[Diagnostic]:
    """E546 for an import of what is generated for a system that there is not, as before it was renamed, of a
    module that is not generated, and of a module of `aseme_dsl` that there is not, as before it was moved.

    An import inside `try` may fail.
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
            elif name not in systems:
                problem = Diagnostic(
                    "E546",
                    f"there is no generated module `{backend}.{name}`: the system is called `{system.name}`",
                    _place(place(node), parts[:2]),
                    hint=f"did you mean `{backend}.{system.name}`?",
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
            return Diagnostic(
                "E546",
                f"there is no module `{'.'.join(parts[:depth])}`",
                _place(whole, parts[:depth]),
                hint=f"it is `{'.'.join([*parts[: depth - 1], now])}` now" if now is not None else None,
                fix=now,
            )
        folder /= part
    return None


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
            known = ", ".join(f"`{item}`" for item in there)
            return Diagnostic(
                "E546",
                f"there is no generated module `{'.'.join(parts[:depth])}`",
                _place(whole, parts[:depth]),
                hint=f"did you mean `{near}`?" if near is not None else f"there is {known}",
                fix=near,
            )
        if part not in roles:
            return None
        there = list(_OF_ROLES[backend])
    return None


_NAMES = ("SYSTEM", "SOURCE", "MODEL", "TEAM", "CHARTS", "AGENTS")
"""What the package of a system has beside the classes of its roles."""
_CLASSES = ("Step", "Agent")
_OF_ROLES = {"monas": ("plan", "step"), "jade_like": ("plan", "step", "agent", "behaviours")}
"""The modules of a role."""


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
