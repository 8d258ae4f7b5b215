"""Activity words: what the Python of an activity takes from its context and from the system's messages."""

from __future__ import annotations

import ast
from collections.abc import Collection, Iterable, Iterator, Mapping
from functools import cache
from inspect import signature
from typing import TYPE_CHECKING, TypeGuard

from aseme_dsl.backends.backend import message_modules
from aseme_dsl.diagnostics import Diagnostic, closest
from aseme_dsl.diagnostics.problems.python.code_words import (
    NoArgumentOfMethod,
    NoConstantOfEnum,
    NoGeneratedMessage,
    NoMemberMade,
    NoMethodOfContext,
    TooManyMembers,
)
from aseme_dsl.project.code.activity_access import Place, executes_of
from aseme_dsl.project.code.activity_fields import dotted, type_names
from aseme_dsl.project.code.renamed import ARGUMENTS, METHODS
from aseme_dsl.source import Span

if TYPE_CHECKING:
    from aseme_dsl.amola.system import System


def unknown_methods(tree: ast.Module, place: Place, wanted: Iterable[str]) -> Iterator[Diagnostic]:
    """W530 for members and arguments that a `Context` does not have, in the `execute` of the classes `wanted`
    and where a parameter is annotated as one."""
    known = _members()
    executes = {id(function) for function in executes_of(tree, wanted)}
    for function in ast.walk(tree):
        if not isinstance(function, (ast.FunctionDef, ast.AsyncFunctionDef)):
            continue
        arguments = (*function.args.posonlyargs, *function.args.args, *function.args.kwonlyargs)
        contexts = {item.arg for item in arguments if _is_context(item.annotation)}
        if id(function) in executes and len(arguments) > 1 and _is_bound_once(function, arguments[1].arg):
            contexts.add(arguments[1].arg)
        if not contexts:
            continue
        for node in ast.walk(function):
            if _is_of(node, contexts) and node.attr not in known and not node.attr.startswith("_"):
                span = place(node)
                span = Span(span.source, span.end - len(node.attr.encode()), span.end)
                now = METHODS.get(node.attr)
                yield Diagnostic(NoMethodOfContext(node.attr, closest(node.attr, known), now), span, fix=now)
            elif isinstance(node, ast.Call) and _is_of(node.func, contexts):
                method = METHODS.get(node.func.attr, node.func.attr)
                yield from _unknown_arguments(node, method, known.get(method, ()), place)


def _unknown_arguments(
    call: ast.Call, method: str, arguments: tuple[str, ...], place: Place
) -> Iterator[Diagnostic]:
    for keyword in call.keywords:
        if arguments and keyword.arg is not None and keyword.arg not in arguments:
            now = ARGUMENTS.get((method, keyword.arg))
            yield Diagnostic(
                NoArgumentOfMethod(method, keyword.arg, arguments, now), _name(keyword, place), fix=now
            )


@cache
def _members() -> Mapping[str, tuple[str, ...]]:
    """The public members of a context; of each method the names of its arguments."""
    from aseme_dsl.runtime.activity.context import Context

    members = {name: getattr(Context, name) for name in dir(Context) if not name.startswith("_")}
    return {
        name: tuple(signature(member).parameters)[1:] if callable(member) else ()
        for name, member in members.items()
    }


def _is_of(node: ast.AST, contexts: Collection[str]) -> TypeGuard[ast.Attribute]:
    """Whether it is a member of a context."""
    return isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name) and node.value.id in contexts


def _name(keyword: ast.keyword, place: Place) -> Span:
    """The name of `name=value`."""
    assert keyword.arg is not None
    value = place(keyword.value)
    start = value.source.text.rfind(keyword.arg, 0, value.start)
    return Span(value.source, start, start + len(keyword.arg))


def _is_bound_once(function: ast.AST, name: str) -> bool:
    """Whether a parameter is nothing else inside."""
    nodes = list(ast.walk(function))
    if any(isinstance(node, ast.Name) and node.id == name for node in nodes if _stores(node)):
        return False
    return sum(isinstance(node, ast.arg) and node.arg == name for node in nodes) == 1


def _stores(node: ast.AST) -> bool:
    return isinstance(node, ast.Name) and not isinstance(node.ctx, ast.Load)


def _is_context(annotation: ast.expr | None) -> bool:
    match annotation:
        case ast.Name(id="Context") | ast.Attribute(attr="Context") | ast.Constant(value="Context"):
            return True
    return False


def unknown_messages(tree: ast.Module, system: System, place: Place) -> Iterator[Diagnostic]:
    """W530 for messages, enums, members and constants that the generated `messages.py` does not have."""
    fields = {item.name: {field.name for field in item.fields} for item in system.messages}
    constants = {item.name: {name for name, _ in item.constants} for item in system.enums}
    modules = message_modules(system.name)
    for node in ast.walk(tree):
        if not isinstance(node, ast.ImportFrom) or node.module not in modules:
            continue
        for alias in node.names:
            if alias.name in fields or alias.name in constants:
                continue
            if (near := closest(alias.name, (*fields, *constants))) is not None:
                yield Diagnostic(NoGeneratedMessage(alias.name, near, system.name), place(node))
    imported = type_names(tree, system)
    for node in ast.walk(tree):
        if isinstance(node, ast.Call) and dotted(node.func) in imported:
            yield from _unknown_members(node, imported[dotted(node.func)], fields, place)
        elif isinstance(node, ast.Attribute) and imported.get(dotted(node.value)) in constants:
            enum = imported[dotted(node.value)]
            own = constants[enum]
            near = closest(node.attr, own)
            if node.attr not in own and near is not None:
                yield Diagnostic(NoConstantOfEnum(node.attr, near, enum), place(node))


def _unknown_members(
    call: ast.Call, name: str, fields: Mapping[str, set[str]], place: Place
) -> Iterator[Diagnostic]:
    own = fields.get(name)
    if own is None:
        return
    for keyword in call.keywords:
        if keyword.arg is not None and keyword.arg not in own:
            near = closest(keyword.arg, own)
            yield Diagnostic(NoMemberMade(keyword.arg, near, name), _name(keyword, place))
    if len(call.args) > len(own) and not any(isinstance(item, ast.Starred) for item in call.args):
        yield Diagnostic(TooManyMembers(name, len(own), len(call.args)), place(call))


__all__ = ["unknown_messages", "unknown_methods"]
