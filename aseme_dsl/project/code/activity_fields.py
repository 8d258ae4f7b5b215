"""Activity fields: whether the Python of activities makes and reads messages with the members that they have.

Only certain errors are reported: in values that are written where a message is made, and in members of values
that are surely messages. These are known by an annotation, by the call that makes them, or by the context's
method that gives them.
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Literal

from aseme_dsl.amola.messages import Field, Kind, Message
from aseme_dsl.backends.backend import message_modules
from aseme_dsl.diagnostics import Diagnostic, Related, closest
from aseme_dsl.diagnostics.problems.python.code_words import NoMemberRead, ValueOfOtherType
from aseme_dsl.project.code.activity_access import Place
from aseme_dsl.records import dataclass
from aseme_dsl.source import Span

if TYPE_CHECKING:
    from aseme_dsl.amola.system import System

Text = Callable[[ast.expr | None], str | None]
Function = ast.FunctionDef | ast.AsyncFunctionDef


def type_names(tree: ast.Module, system: System) -> Mapping[str, str]:
    """How the module calls the messages and enums of the system, with what each is called there.

    `Ball`, `messages.Ball` and `monas.Team.messages.Ball`, as it has imported them.
    """
    types = [*(item.name for item in system.messages), *(item.name for item in system.enums)]
    modules = message_modules(system.name)
    found: dict[str, str] = {}
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            for alias in node.names:
                if alias.name in modules:
                    found.update((f"{alias.asname or alias.name}.{name}", name) for name in types)
        elif isinstance(node, ast.ImportFrom) and node.level == 0:
            for alias in node.names:
                if node.module in modules and alias.name in types:
                    found[alias.asname or alias.name] = alias.name
                elif f"{node.module}.{alias.name}" in modules:
                    found.update((f"{alias.asname or alias.name}.{name}", name) for name in types)
    return found


def dotted(node: ast.expr) -> str:
    """`a.b.c` as a text; "" for what is more than names."""
    parts: list[str] = []
    while isinstance(node, ast.Attribute):
        parts.append(node.attr)
        node = node.value
    return ".".join([node.id, *reversed(parts)]) if isinstance(node, ast.Name) else ""


# ---- what messages are made of -------------------------------------------------------------------


def unfit_values(tree: ast.Module, system: System, place: Place) -> Iterator[Diagnostic]:
    """W547 for a value that is written where a message is made, and is of another type than its member."""
    names = type_names(tree, system)
    messages = {item.name: item for item in system.messages}
    for node in ast.walk(tree) if names else ():
        message = messages.get(names.get(dotted(node.func), "")) if isinstance(node, ast.Call) else None
        if message is None or not isinstance(node, ast.Call):
            continue
        given: list[tuple[Field | None, ast.expr]] = []
        if not any(isinstance(item, ast.Starred) for item in node.args):
            given += zip(message.fields, node.args, strict=False)
        given += [(message.field(item.arg), item.value) for item in node.keywords if item.arg is not None]
        for field, value in given:
            if field is not None:
                yield from _unfit(message, field, value, names, place)


def _unfit(
    message: Message, field: Field, value: ast.expr, names: Mapping[str, str], place: Place
) -> Iterator[Diagnostic]:
    related = (Related(field.span, "the member"),)
    values: Sequence[ast.expr] = (value,)
    what: Literal["member", "element", "elements"] = "member"
    if field.label == "repeated":
        what = "elements"
        if isinstance(value, (ast.List, ast.Tuple)):
            values, what = value.elts, "element"
    elif field.label == "optional" and isinstance(value, ast.Constant) and value.value is None:
        return
    for item in values:
        found = _other(item, None if what == "elements" else field, names)
        if found is not None:
            problem = ValueOfOtherType(message.name, field.name, str(field.type), found, what)
            yield Diagnostic(problem, place(item), related)


_FITTING: Mapping[Kind, tuple[type, ...]] = {
    Kind.BOOL: (bool, int),
    Kind.INT: (int,),
    Kind.DOUBLE: (int, float),
    Kind.STRING: (str,),
    Kind.BYTES: (bytes,),
    Kind.DURATION: (int,),
    Kind.ENUM: (int,),
}
"""Which constants of Python may stand for a type; a `bool` is an `int`."""


def _other(value: ast.expr, field: Field | None, names: Mapping[str, str]) -> str | None:
    """The type of a value, if it does not fit for sure; without a `field`, a tuple or list was wanted."""
    kind = None if field is None else field.type.kind
    fitting = () if kind is None else _FITTING.get(kind, ())
    match value:
        case ast.UnaryOp(op=ast.USub() | ast.UAdd(), operand=ast.Constant(value=int() | float())):
            return _other(value.operand, field, names)
        case ast.Constant(value=None):
            return "None"
        case ast.Constant(value=constant) if isinstance(constant, (bool, int, float, str, bytes)):
            return None if isinstance(constant, fitting) else type(constant).__name__
        case ast.JoinedStr():
            return None if str in fitting else "str"
        case ast.List() | ast.Tuple() | ast.Dict() | ast.Set() if field is not None or not isinstance(
            value, (ast.List, ast.Tuple)
        ):
            return type(value).__name__.lower()
        case ast.Call(func=called) if dotted(called) in names:
            made = names[dotted(called)]
            if field is None or kind not in (Kind.MESSAGE, Kind.ENUM) or field.type.name != made:
                return made if kind is not Kind.INT else None
        case ast.Attribute(value=owner) if dotted(owner) in names:
            made = names[dotted(owner)]
            if kind in (Kind.STRING, Kind.BYTES, Kind.MESSAGE) or (
                kind is Kind.ENUM and field is not None and field.type.name != made
            ):
                return made
        case _:
            pass
    return None


# ---- what is read of them ------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class _Known:
    """What a value is: a message, or what a message is inside of (`member` is where)."""

    message: str
    member: str = ""


@dataclass(frozen=True, slots=True)
class Readings:
    """What the context gives: the message of each channel; `mails`: agent messages are of this system."""

    channels: Mapping[str, str]
    mails: bool


def unknown_members(
    tree: ast.Module,
    system: System,
    readings: Readings,
    contexts: Collection[str],
    text: Text,
    place: Place,
) -> Iterator[Diagnostic]:
    """W530 for a member that is read and that the message does not have."""
    messages = {item.name: item for item in system.messages}
    names = {called: name for called, name in type_names(tree, system).items() if name in messages}
    calls = _Calls(readings, messages, names, contexts, text)
    said: set[int] = set()
    for function in ast.walk(tree):
        if not isinstance(function, (ast.FunctionDef, ast.AsyncFunctionDef)):
            continue
        known = _locals(function, calls)
        for node in ast.walk(function):
            if not isinstance(node, ast.Attribute) or id(node) in said or node.attr.startswith("_"):
                continue
            owner = _at(node.value, known, calls)
            if owner is None or owner.member:
                continue
            message = messages[owner.message]
            if message.field(node.attr) is None:
                said.add(id(node))
                members = tuple(field.name for field in message.fields)
                span = place(node)
                span = Span(span.source, span.end - len(node.attr), span.end)
                problem = NoMemberRead(node.attr, closest(node.attr, members), message.name, members)
                yield Diagnostic(problem, span, (Related(message.span, "the message"),))


@dataclass(frozen=True, slots=True)
class _Calls:
    """What calls give."""

    readings: Readings
    messages: Mapping[str, Message]
    names: Mapping[str, str]
    contexts: Collection[str]
    text: Text

    def given(self, node: ast.expr) -> _Known | None:
        """What a call gives: a message that it makes, or one that the context has."""
        if not isinstance(node, ast.Call):
            return None
        made = self.names.get(dotted(node.func))
        if made is not None:
            return _Known(made)
        if not isinstance(node.func, ast.Attribute) or not isinstance(node.func.value, ast.Name):
            return None
        if node.func.value.id not in self.contexts:
            return None
        named = {item.arg: item.value for item in node.keywords}
        match node.func.attr:
            case "read" | "latest_message" | "consume" | "at" | "latest_sample" as method:
                channel = self.text(node.args[0] if node.args else named.get("channel"))
                message = self.readings.channels.get(channel or "")
                if message is None or message not in self.messages:
                    return None
                return _Known(message, "message" if method == "latest_sample" else "")
            case "receive" | "last_received":
                message = self.text(node.args[1] if len(node.args) > 1 else named.get("message"))
                if not self.readings.mails or message is None or message not in self.messages:
                    return None
                return _Known(message, "content")
            case _:
                return None


def _at(node: ast.expr, known: Mapping[str, _Known], calls: _Calls) -> _Known | None:
    """What an expression is, if it is known."""
    members: list[str] = []
    while isinstance(node, ast.Attribute):
        members.append(node.attr)
        node = node.value
    if isinstance(node, ast.NamedExpr):
        node = node.target
    found = known.get(node.id) if isinstance(node, ast.Name) else calls.given(node)
    for member in reversed(members):
        if found is None:
            return None
        if found.member:
            found = _Known(found.message) if found.member == member else None
            continue
        field = calls.messages[found.message].field(member)
        is_one = field is not None and field.label != "repeated" and field.type.kind is Kind.MESSAGE
        found = _Known(field.type.name) if is_one and field is not None else None
        if found is not None and found.message not in calls.messages:
            return None
    return found


def _locals(function: Function, calls: _Calls) -> Mapping[str, _Known]:
    """What the names of a function are that it binds once."""
    bound: dict[str, int] = {}
    found: dict[str, _Known | None] = {}
    for node in ast.walk(function):
        match node:
            case ast.Name(id=name, ctx=ast.Store() | ast.Del()):
                bound[name] = bound.get(name, 0) + 1
            case ast.arg(arg=name, annotation=annotation):
                bound[name] = bound.get(name, 0) + 1
                found[name] = _annotated(annotation, calls.names)
            case (
                ast.ExceptHandler(name=str(name))
                | ast.MatchAs(name=str(name))
                | ast.MatchStar(name=str(name))
            ):
                bound[name] = 2
            case ast.Global(names=several) | ast.Nonlocal(names=several):
                bound.update(dict.fromkeys(several, 2))
            case ast.Import(names=imported) | ast.ImportFrom(names=imported):
                bound.update((item.asname or item.name, 2) for item in imported)
            case _:
                pass
        match node:
            case (
                ast.Assign(targets=[ast.Name(id=name)], value=value)
                | ast.NamedExpr(target=ast.Name(id=name), value=value)
            ):
                found[name] = calls.given(value)
            case ast.AnnAssign(target=ast.Name(id=name), annotation=annotation):
                found[name] = _annotated(annotation, calls.names)
            case _:
                pass
    # What is bound besides (a loop, `with`) has no entry of its own, and is not known.
    return {name: kind for name, kind in found.items() if kind is not None and bound.get(name) == 1}


def _annotated(annotation: ast.expr | None, names: Mapping[str, str]) -> _Known | None:
    """`Ball`, `Ball | None`, `Optional[Ball]`, `"Ball"`."""
    match annotation:
        case ast.Constant(value=str(said)):
            return _Known(names[said]) if said in names else None
        case ast.BinOp(left=one, op=ast.BitOr(), right=ast.Constant(value=None)):
            return _annotated(one, names)
        case ast.BinOp(left=ast.Constant(value=None), op=ast.BitOr(), right=one):
            return _annotated(one, names)
        case ast.Subscript(value=ast.Name(id="Optional"), slice=one):
            return _annotated(one, names)
        case ast.Name() | ast.Attribute():
            said = dotted(annotation)
            return _Known(names[said]) if said in names else None
        case _:
            return None


__all__ = ["Readings", "dotted", "type_names", "unfit_values", "unknown_members"]
