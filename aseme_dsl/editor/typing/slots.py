"""Slots: what may come next inside a transition expression, a value or a formula.

These are flat lists of tokens for the grammar. Their structure is read by hand
(grammar/formulas/transition.py), and so it is here. The tokens before the cursor need not make sense yet.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from enum import StrEnum
from itertools import pairwise

from aseme_dsl.compiler.read.builtins import PERFORMATIVES
from aseme_dsl.grammar.text.token import Token, token
from aseme_dsl.records import dataclass


class SlotKind(StrEnum):
    """What the next token of an expression would be."""

    EVENT = "event"
    CONDITION = "condition"  # `[` and what follows, behind `when`
    RECEIVED_MESSAGE = "received message"
    FROM = "from"
    SENDER = "sender"
    VALUE = "value"
    MEMBER = "member"  # after a dot
    ACTION = "action"
    ACTION_MEMBER = "action member"
    SENT_PERFORMATIVE = "sent performative"
    SENT_MESSAGE = "sent message"
    TO = "to"
    RECEIVER = "receiver"
    FILL = "fill"  # a member of the message that is sent
    WEIGHT = "weight"  # behind the condition
    COMPLETE = "complete"  # an operator, or the end


@dataclass(frozen=True, slots=True)
class Call:
    """A call whose parentheses are open: its function and the index of the argument that is being written.

    `given` are the arguments before it.
    """

    function: str
    argument: int
    given: tuple[tuple[Token, ...], ...] = ()


@dataclass(frozen=True, slots=True)
class Slot:
    """`path` are the segments before a dot, `left` the other side of a comparison, `said` the words so far.

    `calls` are the open calls, the outermost first; `target` is what an assignment fills. `decides` says that
    the expression is a condition, which is looked at many times.
    """

    kind: SlotKind
    path: tuple[str, ...] = ()
    left: tuple[Token, ...] = ()
    said: tuple[str, ...] = ()
    calls: tuple[Call, ...] = ()
    target: tuple[Token, ...] = ()
    first: bool = False
    decides: bool = False


OPERATORS = frozenset("&& || and or ! not == != < <= > >= + - * / % ( [ , = when else & | ? :".split())
_COMPARISONS = ("==", "!=", "<", "<=", ">", ">=")
_OPENERS, _CLOSERS = ("(", "[", "{"), (")", "]", "}")
_LOGIC = ("&&", "||", "and", "or")


def transition_slot(tokens: Sequence[Token]) -> Slot:
    """What may come next in `event [condition] / action; action`."""
    depth = 0
    condition = slash = -1
    for index, item in enumerate(tokens):
        if depth == 0 and item == "[" and condition < 0:
            condition = index
        if depth == 0 and item == "/":
            slash = index
            break
        depth += (item in ("(", "[")) - (item in (")", "]"))
    if slash >= 0:
        return _action_slot(tokens[slash + 1 :])
    if condition < 0:
        return _event_slot(tokens)
    inside = value_slot(tokens[condition + 1 :])
    if depth > 0:
        return replace(inside, decides=True)
    return Slot(SlotKind.WEIGHT if tokens[-1] == "]" else SlotKind.COMPLETE)


def _event_slot(tokens: Sequence[Token]) -> Slot:
    begin = _behind_last(tokens, ("or", "||"))
    event = tokens[begin:]
    said = tuple(map(str, event))
    match said:
        case ():
            return Slot(SlotKind.EVENT, first=begin == 0)
        case ("when",):
            return Slot(SlotKind.CONDITION)
        case ("after", "(", *_):
            if ")" not in said:
                return replace(value_slot(event), decides=True)
            return Slot(SlotKind.COMPLETE)
        case (word,) if word in PERFORMATIVES:
            return Slot(SlotKind.RECEIVED_MESSAGE, said=said)
        case ("ignores", *_) if begin == 0:
            return value_slot(event[_behind_last(event, ("ignores", ",")) :])
        case ("lost",):
            return Slot(SlotKind.SENDER, said=said)
        case (_, _, *_, "from"):
            return Slot(SlotKind.SENDER, said=(*said[:2], "from"))
        case (word, _) | (word, _, _) if word in PERFORMATIVES:
            return Slot(SlotKind.FROM, said=said)
    return Slot(SlotKind.COMPLETE)


def _action_slot(tokens: Sequence[Token]) -> Slot:
    action = tokens[_behind_last(tokens, (";",)) :]
    said = tuple(map(str, action))
    opened = _open_brace(action)
    if opened > 0:
        return _fill_slot(said[opened - 1].rpartition(".")[2], action[opened + 1 :])
    if said[:1] == ("send",) and "{" in said:
        said = said[: said.index("{")] + said[_behind_braces(action) :]
    match said:
        case ():
            return Slot(SlotKind.ACTION)
        case ("send",):
            return Slot(SlotKind.SENT_PERFORMATIVE)
        case ("send", _):
            return Slot(SlotKind.SENT_MESSAGE, said=said)
        case ("send", _, _):
            return Slot(SlotKind.TO, said=said)
        case ("send", _, _, "to") | ("send", _, _, "to", _, "except"):
            return Slot(SlotKind.RECEIVER, said=said)
        case ("send", *_):
            return Slot(SlotKind.COMPLETE)
    depth = 0
    for index, item in enumerate(action):
        depth += (item in _OPENERS) - (item in _CLOSERS)
        if depth == 0 and item == "=":
            slot = value_slot(action[index + 1 :])
            return Slot(slot.kind, slot.path, slot.left, slot.said, slot.calls, tuple(action[:index]))
    slot = value_slot(action)
    if slot.kind is SlotKind.MEMBER and not slot.calls:
        return Slot(SlotKind.ACTION_MEMBER, slot.path)
    return slot


def _open_brace(tokens: Sequence[Token]) -> int:
    """Where the innermost brace is that is still open; 0 without one."""
    opened: list[int] = []
    for index, item in enumerate(tokens):
        if item == "{":
            opened.append(index)
        elif item == "}" and opened:
            opened.pop()
    return opened[-1] if opened else 0


def _behind_braces(tokens: Sequence[Token]) -> int:
    """Where that begins which follows the first content in braces."""
    depth = 0
    for index, item in enumerate(tokens):
        depth += (item == "{") - (item == "}")
        if item == "}" and depth == 0:
            return index + 1
    return len(tokens)


def _fill_slot(message: str, tokens: Sequence[Token]) -> Slot:
    """Inside the braces behind a message that is sent: a member, or the value that it gets."""
    member = tokens[_behind_last(tokens, (",", ";")) :]
    if member[:1] == [".."]:
        return value_slot(member[1:])
    equals = max((index for index, item in enumerate(member) if item == "="), default=-1)
    slot = value_slot(member[equals + 1 :])
    if equals < 0 or slot.kind is SlotKind.COMPLETE:
        return Slot(SlotKind.FILL, path_before(member)[0], said=(message,))
    return slot


def value_slot(tokens: Sequence[Token]) -> Slot:
    """What may come next in an expression."""
    frames: list[tuple[int, list[int]]] = [(-1, [0])]  # the index of a function's name, where arguments begin
    for index, item in enumerate(tokens):
        if item in _OPENERS:
            called = index > 0 and item == "(" and is_name(tokens[index - 1])
            frames.append((index - 1 if called else -1, [index + 1]))
        elif item in _CLOSERS:
            if len(frames) > 1:
                frames.pop()
        elif item == ",":
            frames[-1][1].append(index + 1)
    calls = tuple(
        Call(
            str(tokens[name]),
            len(begins) - 1,
            tuple(tuple(tokens[begin : end - 1]) for begin, end in pairwise(begins)),
        )
        for name, begins in frames
        if name >= 0
    )
    argument = tokens[frames[-1][1][-1] :]
    segments, begin = path_before(argument)
    if segments:
        kind = SlotKind.MEMBER
    elif not argument or argument[-1] in OPERATORS:
        kind, begin = SlotKind.VALUE, len(argument)
    else:
        return Slot(SlotKind.COMPLETE, calls=calls)
    return Slot(kind, segments, tuple(_compared(argument[:begin])), calls=calls)


def path_before(tokens: Sequence[Token]) -> tuple[tuple[str, ...], int]:
    """The segments of a dotted name that ends with a dot, and where it begins; none if there is no dot.

    An element of a list counts as the list: `x.items[0].` has the segments `x` and `items`.
    """
    index = len(tokens)
    segments: list[str] = []
    while index >= 2 and tokens[index - 1] == ".":
        name = _before_brackets(tokens, index - 2)
        if name < 0 or not is_name(tokens[name]):
            break
        segments[:0] = str(tokens[name]).split(".")
        index = name
    return tuple(segments), index


def _before_brackets(tokens: Sequence[Token], index: int) -> int:
    """Where the token is that stands before the brackets which end at `index`, if any end there."""
    while index >= 0 and tokens[index] == "]":
        depth = 0
        while index >= 0:
            depth += (tokens[index] == "]") - (tokens[index] == "[")
            index -= 1
            if depth == 0:
                break
    return index


def _compared(tokens: Sequence[Token]) -> Sequence[Token]:
    """The left side of a comparison whose operator is the last token."""
    if not tokens or tokens[-1] not in _COMPARISONS:
        return ()
    depth = 0
    for index in range(len(tokens) - 2, -1, -1):
        item = tokens[index]
        depth += (item in (")", "]")) - (item in ("(", "["))
        if depth < 0 or (depth == 0 and item in _LOGIC):
            return tokens[index + 1 : -1]
    return tokens[:-1]


def formula_is_open(tokens: Sequence[Token]) -> bool:
    """Whether an operand must follow: at the begin, behind an operator or an opening bracket."""
    return not tokens or tokens[-1] in (".", "|", "||", "(", "[", "=", ",", ">")


def joined(text: str, tokens: Sequence[Token]) -> list[Token]:
    """The tokens as the grammar has them: a dotted name is one."""
    found: list[Token] = []
    for item in tokens:
        if found and ((item == "." and is_name(found[-1])) or (found[-1][-1:] == "." and is_name(item))):
            start = found.pop().start
            found.append(token(text[start : item.end], start))
        else:
            found.append(item)
    return found


def is_name(text: str) -> bool:
    """Whether a token is a name, or ends with one."""
    return (text[:1].isalpha() or text[:1] == "_") and text not in OPERATORS


def _behind_last(tokens: Sequence[Token], signs: tuple[str, ...]) -> int:
    depth, behind = 0, 0
    for index, item in enumerate(tokens):
        depth += (item in _OPENERS) - (item in _CLOSERS)
        if depth == 0 and item in signs:
            behind = index + 1
    return behind


__all__ = [
    "Call",
    "Slot",
    "SlotKind",
    "formula_is_open",
    "joined",
    "path_before",
    "transition_slot",
    "value_slot",
]
