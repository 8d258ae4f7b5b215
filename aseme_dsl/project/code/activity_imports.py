"""Activity imports: whether the generated modules that activities import are those of a system."""

from __future__ import annotations

import ast
import re
from collections.abc import Callable, Collection, Iterable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from aseme_dsl import outside
from aseme_dsl.backends.backend import AGENTS
from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.source import Span

if TYPE_CHECKING:
    from aseme_dsl.amola.system import System

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
    tree: ast.Module, system: str, systems: Collection[str], place: Callable[[ast.expr | ast.stmt], Span]
) -> Iterator[Diagnostic]:
    """E546 for an import of what is generated for a system that there is not, as before it was renamed.

    An import inside `try` may fail.
    """
    tried = {id(inner) for node in ast.walk(tree) if isinstance(node, ast.Try) for inner in ast.walk(node)}
    for node in ast.walk(tree):
        if not isinstance(node, (ast.Import, ast.ImportFrom)) or id(node) in tried:
            continue
        for module in _modules(node):
            backend, _, rest = module.partition(".")
            name = rest.partition(".")[0]
            if backend not in AGENTS or not name or name in systems or name == "*":
                continue
            whole = place(node)
            at = whole.text.find(name, whole.text.find(backend) + len(backend))
            span = Span(whole.source, whole.start + at, whole.start + at + len(name))
            yield Diagnostic(
                "E546",
                f"there is no generated module `{backend}.{name}`: the system is called `{system}`",
                span,
                hint=f"did you mean `{backend}.{system}`?",
                fix=system if len(systems) == 1 else None,
            )


def _modules(node: ast.Import | ast.ImportFrom) -> list[str]:
    if isinstance(node, ast.Import):
        return [item.name for item in node.names]
    if node.level or node.module is None:
        return []
    if node.module in AGENTS:
        return [f"{node.module}.{item.name}" for item in node.names]
    return [node.module]


__all__ = ["systems_beside", "wrong_imports"]
