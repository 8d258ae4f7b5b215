"""Activity pace: whether the Python of an activity surely returns at once, with any arguments."""

from __future__ import annotations

import ast
import builtins

_AT_ONCE = frozenset(
    """age consume get_variable interpolated last_received latest_message latest_sample log prepare publish
    raise_event read send set_variable snapshot""".split()
)
"""The calls on the context that do not wait."""
_BUILTINS = frozenset(dir(builtins)) - {"input", "open", "exec", "eval", "__import__"}


def returns_at_once(execute: ast.FunctionDef | ast.AsyncFunctionDef) -> bool:
    """Whether nothing in `execute` can take time: no wait, no `yield`, no loop without an end, no call of
    other code."""
    if isinstance(execute, ast.AsyncFunctionDef) or _is_empty(execute):
        return False
    return all(_is_quick(node) for node in ast.walk(execute))


def _is_quick(node: ast.AST) -> bool:
    match node:
        case ast.Await() | ast.Yield() | ast.YieldFrom() | ast.While() | ast.With() | ast.AsyncFor():
            return False
        case ast.Call(func=ast.Attribute(value=ast.Name(id="context"), attr=method)):
            return method in _AT_ONCE
        case ast.Call(func=ast.Name(id=name)):
            return name in _BUILTINS or name[:1].isupper()  # a message is made
        case ast.Call():
            return False
    return True


def _is_empty(execute: ast.FunctionDef) -> bool:
    """Whether nothing is written yet: a build's beginning."""
    return all(
        isinstance(item, ast.Pass) or (isinstance(item, ast.Expr) and isinstance(item.value, ast.Constant))
        for item in execute.body
    )


__all__ = ["returns_at_once"]
