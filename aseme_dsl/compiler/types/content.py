"""Content: whether the braces behind a `send` say everything, and what `..` and `..m` stand for."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Sequence

from aseme_dsl.amola.expression import Fill, NewMessage, Value
from aseme_dsl.amola.messages import DURATION, ChannelKind, Field, Kind, Message, Type
from aseme_dsl.compiler.names.checker import Checker
from aseme_dsl.compiler.names.paths import member_path, through_optional
from aseme_dsl.compiler.names.symbols import Symbols
from aseme_dsl.compiler.read.constants import NotConstant, fold
from aseme_dsl.compiler.read.names import unknown
from aseme_dsl.compiler.types.calls import assignable
from aseme_dsl.diagnostics import Diagnostic, Edit, Related
from aseme_dsl.diagnostics.problems import talk as problems
from aseme_dsl.diagnostics.problems.absences import NoMessage
from aseme_dsl.diagnostics.problems.expressions.paths import (
    MemberFilledTwice,
    NewOnTopic,
    OptionalAssigned,
)
from aseme_dsl.grammar.text import tree
from aseme_dsl.records import dataclass
from aseme_dsl.source import Span

Typed = Callable[[Checker, tree.Expression], Value | None]
"""How an expression is typed (typecheck.py)."""


@dataclass(frozen=True, slots=True)
class Rest:
    """What the members that are not named have: those of `message` that are `taken`, else their defaults."""

    is_default: bool = False
    message: Value | None = None
    taken: tuple[str, ...] = ()


def rest_of(
    checker: Checker, written: tree.Send | tree.NewMessage, fills: Collection[Fill], value: Typed
) -> Rest | None:
    """What is said of the members that are not filled in; None where it is wrong: E577, E578, N760."""
    message = checker.scope.symbols.message(written.message.text)
    if message is None:
        return Rest()
    paths = {item.path for item in fills}
    missing = list(_missing(checker.scope.symbols, message, paths))
    if written.rest is None:
        if missing:
            checker.diagnostics.append(_incomplete(written, message, missing))
        return None if missing else Rest()
    open_fields = [item for item in message.fields if (item.name,) not in paths]
    if not missing and not any(item.label == "optional" for item in open_fields):
        checker.report(problems.NothingLeft(message.name), written.rest.span)
    if written.rest.message is None:
        return Rest(is_default=True)
    found = value(checker, written.rest.message)
    if found is None:
        return None
    source = checker.scope.symbols.message(found.type.name) if found.type.kind is Kind.MESSAGE else None
    if source is None:
        checker.report(problems.RestOfNoMessage(written.rest.message.span.text), written.rest.message.span)
        return None
    heads = {path[0] for path in missing}
    lacking = [item for item in open_fields if item.name in heads and not _fits(source, item)]
    if lacking:
        names = tuple(item.name for item in lacking)
        problem = problems.RestDoesNotFit(written.rest.message.span.text, source.name, message.name, names)
        checker.report(problem, written.rest.span)
        return None
    return Rest(message=found, taken=tuple(item.name for item in open_fields if _fits(source, item)))


def fill(checker: Checker, message: str, written: Sequence[tree.Fill], value: Typed) -> list[Fill] | None:
    """The members of a message that are filled in braces: E225, E501, E507. None where one is wrong."""
    found: list[Fill] = []
    first: dict[tuple[str, ...], Span] = {}
    sound = True
    for item in written:
        target = member_path(checker, Type(Kind.MESSAGE, message), (), item.target.segments)
        given = value(checker, item.value)
        sound = sound and target is not None and given is not None
        if target is None or given is None:
            continue
        path, kind = target
        earlier = next((span for other, span in first.items() if other[: len(path)] == path), None)
        first[path] = item.target.span
        if earlier is not None:
            related = (Related(earlier, "the first time"),)
            checker.report(MemberFilledTwice(item.target.text), item.target.span, related)
            sound = False
        elif (optional := through_optional(checker, message, path)) is not None:
            checker.report(OptionalAssigned(optional, is_sent=True), item.target.span)
            sound = False
        elif not assignable(checker, given, kind):
            sound = False
        else:
            found.append(Fill(path, kind, given, item.span))
    return found if sound else None


def new_message(checker: Checker, written: tree.NewMessage, value: Typed) -> NewMessage | None:
    """`Order { id = 7, ..now }`: E200, E225, E501, E507, E577, E578, N760."""
    name, symbols = written.message, checker.scope.symbols
    if symbols.message(name.text) is None:
        if not symbols.is_excused(name.text):
            _no_message(checker, name)
        return None
    fills = fill(checker, name.text, written.fills, value)
    rest = None if fills is None else rest_of(checker, written, fills, value)
    if fills is None or rest is None:
        return None
    kind = Type(Kind.MESSAGE, name.text)
    made = tuple(fills), rest.message, rest.taken, rest.is_default
    return NewMessage(name.text, *made, kind, written.span)


def deadline(checker: Checker, written: tree.Expression, value: Typed) -> Value | None:
    """`reply_by 2s`: a duration that is greater than zero (E501, E579)."""
    found = value(checker, written)
    if found is None or not assignable(checker, found, DURATION):
        return None
    try:
        amount = fold(found)
    except (NotConstant, ArithmeticError):
        return found
    if isinstance(amount, int | float) and amount <= 0:
        checker.report(problems.DeadlineInThePast(), written.span)
        return None
    return found


def _no_message(checker: Checker, name: tree.Name) -> None:
    """What stands before the braces is not a message (E502)."""
    topic, _, last = name.text.rpartition(".")
    if topic.rpartition(".")[2] in [comm.value for comm in ChannelKind]:
        checker.report(NewOnTopic(name.text, last), name.span, fix=last)
        return
    symbols = checker.scope.symbols
    pool = [one.name for one in symbols.messages]
    is_enum = symbols.enum(name.text) is not None
    checker.diagnostics.append(unknown(NoMessage, name, pool, is_enum=is_enum))


def _incomplete(
    written: tree.Send | tree.NewMessage, message: Message, missing: list[tuple[str, ...]]
) -> Diagnostic:
    assert written.braces is not None and written.fills is not None
    opener, closer = written.braces
    braces = opener.to(closer)
    if written.fills:
        end = written.fills[-1].span.end
        edit = Edit(Span(braces.source, end, end), ", ..")
    else:
        edit = Edit(braces, "{ .. }")
    names = tuple(".".join(path) for path in missing)
    return Diagnostic(problems.ContentIncomplete(message.name, names), braces, edits=(edit,))


def _missing(
    symbols: Symbols, message: Message, filled: Collection[tuple[str, ...]], at: tuple[str, ...] = ()
) -> Iterator[tuple[str, ...]]:
    """The members that are neither filled nor optional, those of inner messages by their paths.

    A message that is partly filled is complete when its members are.
    """
    for item in message.fields:
        path = (*at, item.name)
        if path in filled or item.label == "optional":
            continue
        inner = symbols.message(item.type.name) if item.type.kind is Kind.MESSAGE else None
        is_begun = any(other[: len(path)] == path for other in filled)
        if inner is not None and item.label != "repeated" and is_begun:
            yield from _missing(symbols, inner, filled, path)
        else:
            yield path


def _fits(source: Message, wanted: Field) -> bool:
    """Whether a message has a member of the same name and type, which is there where it has to be."""
    own = source.field(wanted.name)
    if own is None or own.type != wanted.type:
        return False
    return own.label == wanted.label or (wanted.label == "optional" and own.label != "repeated")


__all__ = ["Rest", "deadline", "fill", "new_message", "rest_of"]
