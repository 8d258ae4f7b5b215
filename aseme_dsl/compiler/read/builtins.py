"""Builtins: the functions that need no import, and the names that nothing in a document can have."""

from __future__ import annotations

from aseme_dsl.amola.messages import BUILT_IN, DOUBLE, DURATION, INT, ChannelKind, Function, Type
from aseme_dsl.diagnostics.problems.names import Reserved
from aseme_dsl.grammar.formulas.words import RESERVED
from aseme_dsl.runtime.message.performatives import NOT_UNDERSTOOD as NOT_UNDERSTOOD
from aseme_dsl.runtime.message.performatives import PERFORMATIVES as PERFORMATIVES
from aseme_dsl.source import Source, Span

NOWHERE = Span(Source("<built in>", ""), 0, 0)
"""The place of what no document declares."""


def _same(name: str, count: int, kind: Type) -> Function:
    names = ("a", "b")[:count]
    return Function(name, tuple((item, kind) for item in names), kind, f"builtin:{name}", NOWHERE)


FUNCTIONS: tuple[Function, ...] = tuple(
    _same(name, count, kind)
    for name, count in (("abs", 1), ("min", 2), ("max", 2))
    for kind in (INT, DOUBLE, DURATION)
)
"""`abs`, `min` and `max`: of ints, doubles and durations."""

FORMS: dict[str, str] = {
    "has": "has(topic.state.Message)",
    "age": "age(topic.state.Message)",
    "at": "at(topic.data.Message.member, -200ms)",
    "mean": "mean(topic.data.Message.member, 500ms)",
    "expired": "expired(timer)",
    "start_timer": "start_timer(timer, 200ms)",
    "outcome": "outcome(Activity) == name",
    "random": "random()",
    "in": "in(Formula)",
    "done": "done(Formula)",
    "count": "count(Activity) < 3",
    "invited": "invited(participant) > 0",
    "answered": "answered(participant) >= 3",
    "all_answered": "all_answered(participant)",
    "sender": "sender(message)",
    "reason": "reason(agent) == left",
    "size": "size(topic.state.Message.members)",
    "contains": "contains(topic.state.Message.members, value)",
    "find": "find(topic.state.Message.members.id, value)",
    "append": "append(list, value)",
    "remove": "remove(list, value)",
    "clear": "clear(variable)",
}
"""What looks like a function and is part of the language, with an example of its use."""

STATE_QUESTIONS = ("in", "done", "count")
ROUND_QUESTIONS = ("invited", "answered", "all_answered")
YIELDING = frozenset(
    (
        "outcome",
        "random",
        "sender",
        "reason",
        "size",
        "contains",
        "find",
        "append",
        "remove",
        "clear",
        *STATE_QUESTIONS,
        *ROUND_QUESTIONS,
    )
)
"""The forms that came later: a function that a document declares under such a name goes before."""

COMM_TYPES = tuple(comm.value for comm in ChannelKind)
ACTIONS = ("read_messages", "write_messages")
OTHER_SPELLINGS = {
    "float": "double",
    "float32": "double",
    "float64": "double",
    "real": "double",
    "number": "double",
    "boolean": "bool",
    "str": "string",
    "text": "string",
    "integer": "int",
    "long": "int",
    "int32": "int",
    "int64": "int",
    "uint32": "int",
    "uint64": "int",
    "time": "duration",
}
"""What other languages call a built-in type."""


def reserved(name: str) -> Reserved | None:
    """Why nothing that expressions name (a variable, topic, field, …) can be called `name`, or None."""
    if name in BUILT_IN:
        return "type"
    if name in RESERVED:
        return "word"
    return "action" if name in ACTIONS else None
