"""From the tokens of a transition expression to its tree."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from aseme_dsl.diagnostics import Edit
from aseme_dsl.diagnostics.problems.syntax import formulas as problems
from aseme_dsl.diagnostics.problems.syntax.entries import Wanted
from aseme_dsl.grammar.formulas.expression import BINDING, operation, read_path, value
from aseme_dsl.grammar.formulas.filling import apart, content, in_braces
from aseme_dsl.grammar.formulas.reader import Reader, is_word
from aseme_dsl.grammar.formulas.transition_mistakes import (
    ASSIGNMENTS,
    after_transition,
    bare_condition,
    check_content,
    condition_with_if,
    no_colon,
    no_event,
    no_from,
)
from aseme_dsl.grammar.formulas.words import RESERVED
from aseme_dsl.grammar.text import tree
from aseme_dsl.grammar.text.lexer import HOLE
from aseme_dsl.grammar.text.token import Token
from aseme_dsl.source import Source, Span

_BEGINS_NO_ACTION = ("", ";", "/", "]", ")", "[", ",", "=", ".")
_ARE_NO_ACTION = ("else", "when", "and", "or")

_LATER_VERBS = ("on", "exit", "resume")
"""The verbs that are so only before a term and `:`, and may be names elsewhere."""


def read_transition(source: Source, tokens: Sequence[Token], place: Span) -> tree.TransitionExpression:
    """`event [condition] / action; action`; `place` is where an empty one stands.

    Raises:
        Malformed: As `read_expression`.
    """
    if not tokens:
        return tree.TransitionExpression((), False, False, None, (), place)
    return _transition(Reader(source, apart(tokens)))


def read_busy(source: Source, terminals: Sequence[Token], place: Span) -> tree.Busy:
    """`queue`, `refuse` or `refuse Job { reason = "later" }` behind `when busy`; `place` is all of it.

    Raises:
        Malformed: As `read_expression`.
    """
    reader = Reader(source, apart(terminals))
    word = reader.need_name(Wanted.PERFORMATIVE)
    answer: tree.Send | None = None
    if reader.next:
        message = reader.need_name(Wanted.MESSAGE)
        fills, rest, braces = in_braces(reader, operation)
        span = reader.since(word.span.start)
        answer = tree.Send(word, message, None, span, fills, rest=rest, braces=braces)
        if reader.next:
            raise reader.unexpected(",", Wanted.NEXT_ENTRY)
    return tree.Busy(word.text, answer, place)


def _transition(reader: Reader) -> tree.TransitionExpression:
    start = reader.tokens[0].start
    events: list[tree.Event] = []
    when = False
    otherwise = False
    condition: tree.Expression | None = None
    actions: list[tree.Action] = []
    ignores = reader.span(reader.tokens[0]) if _is_ignoring(reader) else None
    if ignores is not None:
        when = True
        condition = _ignored(reader)
    elif reader.next == "else":
        word = reader.take()
        otherwise = True
        if reader.next == "[":
            raise reader.error(problems.ElseWithCondition(), word)
    elif reader.next not in ("[", "/") and not _is_weight(reader):
        while True:
            if reader.next == "when":
                reader.take()
                when = True
            else:
                events.append(_event(reader))
            if reader.next not in ("or", "||"):
                break
            reader.take()
    if ignores is None and reader.next == "[":
        opener = reader.take()
        condition = _hole(reader) or operation(reader)
        reader.need("]", opener)
    elif when and ignores is None:
        wrong = bare_condition(reader, reader.index) if is_word(reader.next) else None
        raise wrong or reader.unexpected(Wanted.CONDITION)
    weight = None
    if _is_weight(reader):
        first = reader.take().start
        number = reader.take()
        if not number.isdecimal():
            raise reader.error(problems.WeightNotWhole(), number)
        weight = tree.Weight(int(number), reader.since(first))
    if reader.next == "/":
        reader.take()
        while True:
            actions.append(_action(reader))
            if reader.next != ";":
                break
            reader.take()
    if reader.index < len(reader.tokens):
        raise after_transition(reader, bool(actions), condition is not None or otherwise)
    return tree.TransitionExpression(
        tuple(events),
        when,
        otherwise,
        condition,
        tuple(actions),
        reader.since(start),
        weight=weight,
        ignores=ignores,
    )


def _is_weight(reader: Reader) -> bool:
    """Whether `weight 3` follows; without a number `weight` is a name."""
    following = reader.tokens[reader.index + 1 : reader.index + 2]
    return reader.next == "weight" and bool(following) and following[0][0] in "-.0123456789"


def _is_ignoring(reader: Reader) -> bool:
    """Whether `ignores panel.signal.Key` follows; without a name behind it `ignores` is an event."""
    first, second, third = (*reader.tokens[reader.index : reader.index + 3], "", "", "")[:3]
    return first == "ignores" and is_word(second) and second not in RESERVED and third != "from"


def _ignored(reader: Reader) -> tree.Expression:
    """The condition that one of the signals behind `ignores` is there, which consumes it."""
    word = reader.take()
    found: list[tree.Expression] = []
    while True:
        if not is_word(reader.next) or reader.next in RESERVED:
            raise reader.unexpected(Wanted.SIGNAL)
        path = read_path(reader.source, reader.take())
        has = tree.Name("has", reader.span(word))
        found.append(tree.Call(tree.Path((has,), has.span), (path,), path.span))
        if reader.next != ",":
            break
        reader.take()
    if len(found) == 1:
        return found[0]
    return tree.Logic("||", tuple(found), found[0].span.to(found[-1].span))


def _hole(reader: Reader) -> tree.Hole | None:
    """The `?` of `[?]`."""
    if reader.next != HOLE or reader.tokens[reader.index + 1 : reader.index + 2] != ["]"]:
        return None
    return tree.Hole(reader.span(reader.take()))


def _event(reader: Reader) -> tree.Event:
    start = reader.index
    if not is_word(reader.next) or reader.next in RESERVED:
        if start == 0:
            raise bare_condition(reader, 0)
        raise reader.unexpected(Wanted.EVENT)
    first = reader.take()
    following = reader.next
    if first in ("send", "read_messages") or first.startswith("write_messages"):
        fix = f"/ {first}" if start == 0 else None
        raise reader.error(problems.ActionWithoutSlash(first), first, fix)
    if first in _LATER_VERBS and (following == "(" or (is_word(following) and following not in RESERVED)):
        raise no_colon(reader, first)
    if first == "after" and following == "(":
        opener = reader.take()
        duration = operation(reader)
        reader.need(")", opener)
        return tree.After(duration, reader.since(first.start))
    if first == "if" and following == "[":
        between = Edit(Span(reader.source, first.start, reader.tokens[reader.index].start), "")
        raise reader.error(problems.ConditionWithIf(None), first, edits=(between,))
    if (
        following
        and is_word(following)
        and following not in RESERVED
        and "." not in first
        and "." not in following
    ):
        if first == "if" and reader.tokens[reader.index : reader.index + 2][1:] != ["from"]:
            raise condition_with_if(reader, first)
        if first == "weight":
            raise reader.error(problems.WeightNotWhole(), reader.tokens[reader.index])
        if first == "lost":
            return _lost(reader, first)
        reader.index -= 1
        performative = reader.need_name(Wanted.PERFORMATIVE)
        message = reader.need_name(Wanted.MESSAGE)
        name = None
        if is_word(reader.next) and reader.tokens[reader.index + 1 : reader.index + 2] == ["from"]:
            name = reader.need_name(Wanted.MESSAGE_NAME)
        if reader.next != "from":
            raise no_from(reader)
        reader.take()
        participant = reader.need_name(Wanted.SENDING_PARTICIPANT)
        if reader.next == "as" and name is None and reader.index + 1 < len(reader.tokens):
            called = reader.tokens[reader.index + 1]
            problem = problems.NameBehindFrom(performative.text, message.text, called, participant.text)
            raise reader.error(problem, reader.tokens[reader.index])
        return tree.Received(performative, message, participant, reader.since(first.start), name)
    if "." in first or following in ("(", "and") or (following in BINDING and following not in ("||", "/")):
        raise bare_condition(reader, start)
    return tree.Raised(tree.Name(str(first), reader.span(first)), reader.span(first))


def _lost(reader: Reader, word: Token) -> tree.Lost:
    if reader.next == "from":
        raise reader.unexpected(Wanted.PARTICIPANT)
    participant = reader.need_name(Wanted.PARTICIPANT)
    name = None
    if is_word(reader.next) and reader.next not in RESERVED:
        name = reader.need_name(Wanted.AGENT_NAME)
    return tree.Lost(participant, name, reader.since(word.start))


def _action(reader: Reader) -> tree.Action:
    check_content(reader)
    if reader.next[:1] in _BEGINS_NO_ACTION or reader.next in _ARE_NO_ACTION:
        raise reader.unexpected(Wanted.ACTION)
    first = reader.tokens[reader.index]
    following = reader.tokens[reader.index + 1] if reader.index + 1 < len(reader.tokens) else ""
    if first == "send" and following and is_word(following):
        return _send(reader)
    if first == "raise" and not following:
        raise no_event(reader)
    if first == "raise" and following and is_word(following) and following not in RESERVED:
        reader.take()
        name = reader.need_name(Wanted.EVENT)
        return tree.Raise(name, reader.since(first.start))
    if first == "read_messages" and following != "(":
        reader.take()
        return tree.ReadMessages(reader.span(first))
    head, dot, _ = first.partition(".")
    if head.strip() == "write_messages" and following not in ("(", "="):
        path = read_path(reader.source, first)
        reader.take()
        if not dot:
            raise reader.error(problems.PublishWithoutChannel(), first)
        topic = tree.Path(path.segments[1:], path.segments[1].span.to(path.span))
        fills, rest = content(reader, operation, is_sent=False) if reader.next == "{" else (None, None)
        return tree.Publish(topic, reader.since(first.start), fills, rest)
    expression = operation(reader)
    if reader.next not in ASSIGNMENTS:
        return tree.Evaluate(expression, reader.since(first.start))
    equals = reader.take()
    place = expression.list if isinstance(expression, tree.Element) else expression
    if not isinstance(place, tree.Path):
        raise reader.error(problems.NotAssignable(str(equals)), equals)
    value = operation(reader)
    operator = None if equals == "=" else tree.Name(equals[0], reader.span(equals))
    found = tree.Assign(place, value, reader.since(first.start), operator)
    if isinstance(expression, tree.Element):
        return replace(found, index=expression.index, members=expression.members)
    return found


def _send(reader: Reader) -> tree.Send:
    start = reader.take().start
    performative = reader.need_name(Wanted.PERFORMATIVE)
    message = reader.need_name(Wanted.MESSAGE)
    fills, rest, braces = in_braces(reader, operation)
    reply_by = None
    if reader.next == "reply_by":
        reader.take()
        reply_by = operation(reader)
    if reader.next != "to":
        raise reader.unexpected(Wanted.RECEIVER)
    reader.take()
    one = _one(reader)
    participant, receiver = None, None
    if reader.index + 1 < len(reader.tokens) and reader.tokens[reader.index + 1] in ("(", "["):
        receiver = value(reader)
    else:
        participant = reader.need_name(Wanted.RECEIVING_PARTICIPANT)
    excepts: list[tree.Expression] = []
    if reader.next == "except":
        reader.take()
        excepts.append(value(reader))
        while reader.next == ",":
            reader.take()
            excepts.append(value(reader))
    return tree.Send(
        performative,
        message,
        participant,
        reader.since(start),
        fills,
        receiver,
        tuple(excepts),
        rest,
        braces,
        reply_by,
        one,
    )


def _one(reader: Reader) -> Span | None:
    """`one` before a participant; a variable may be called so."""
    following = reader.tokens[reader.index + 1] if reader.index + 1 < len(reader.tokens) else ""
    if reader.next != "one" or not is_word(following) or following == "except":
        return None
    return reader.span(reader.take())
