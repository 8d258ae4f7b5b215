"""Mutants of a model: its text with one readable change that a person could have made by mistake.

They are made on the tokens of the parsed text, so each change is one of meaning: a condition negated, a
message not sent. Whether a mutant compiles, and whether it behaves otherwise, is for the caller to find out.
How long a simulated activity lasts (`takes`) and how often one runs (`every`) is not changed: these are facts
of the surroundings.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise, zip_longest
from random import Random
from typing import TypeVar

from aseme_dsl.grammar.parsing.terminals import read
from aseme_dsl.grammar.text.token import Token
from aseme_dsl.source import Source

T = TypeVar("T")

KINDS = (
    "condition negated",
    "condition dropped",
    "comparison turned",
    "number changed",
    "line dropped",
    "target changed",
    "order of lines",
    "else first",
    "timer dropped",
    "timer longer",
    "message not sent",
    "another receiver",
    "another message",
    "action dropped",
    "resume forgotten",
    "order of states",
    "operator changed",
    "value changed",
)

_TURNED = {
    "<": ">=",
    "<=": ">",
    ">": "<=",
    ">=": "<",
    "==": "!=",
    "!=": "==",
    "&&": "||",
    "||": "&&",
}
_BESIDE = {
    "enter": ("enter", "skip"),
    "skip": ("enter", "skip"),
    "repeat": ("repeat", "leave"),
    "leave": ("repeat", "leave"),
    "finish": ("finish",),
}
"""The verbs between which a line with `else` decides."""

_DURATION = re.compile(r"(\d+(?:\.\d+)?)(ms|s|min)$")
_NUMBER = re.compile(r"\d+(?:\.\d+)?$")


@dataclass(frozen=True, slots=True)
class ModelMutant:
    """A text that differs in one statement, what kind of change it is, and the line of it (from 1)."""

    kind: str
    line: int
    before: str
    """The changed lines as they were; `after` as they are."""
    after: str
    text: str


_Edit = tuple[int, int, str]


def model_mutants(text: str) -> tuple[ModelMutant, ...]:
    """All mutants of a text, in the order of the text. What stands in its scenarios is left alone."""
    model, _ = read(Source("model", text))
    found: dict[str, ModelMutant] = {}
    for kind, edits in _edits(model, text):
        changed = text
        for start, end, new in sorted(edits, reverse=True):
            changed = changed[:start] + new + changed[end:]
        if changed.split() != text.split() and changed not in found:
            found[changed] = _mutant(kind, text, changed)
    return tuple(sorted(found.values(), key=lambda item: (item.line, KINDS.index(item.kind), item.after)))


def _mutant(kind: str, text: str, changed: str) -> ModelMutant:
    old, new = text.splitlines(), changed.splitlines()
    first = next(n for n, (a, b) in enumerate(zip([*old, ""], [*new, ""], strict=False)) if a != b)
    same = 0
    while same < min(len(old), len(new)) - first and old[-1 - same] == new[-1 - same]:
        same += 1
    before, after = old[first : len(old) - same], new[first : len(new) - same]
    return ModelMutant(kind, first + 1, _shown(before), _shown(after), changed)


def _shown(lines: Iterable[str]) -> str:
    return " ⏎ ".join(" ".join(line.split()) for line in lines if line.strip())


def _nodes(node: object) -> Iterator[object]:
    """A node and all that are in it."""
    yield node
    for name, value in vars(node).items():
        if not name.startswith("_") and name != "parent":
            for item in value if isinstance(value, list) else [value]:
                if hasattr(item, "_tx_position"):
                    yield from _nodes(item)


def _is(node: object, *rules: str) -> bool:
    return type(node).__name__ in rules


def _edits(model: object, text: str) -> Iterator[tuple[str, list[_Edit]]]:
    for node in _nodes(model):
        if _is(node, "Control"):
            yield from _of_control(node, text)
        elif _is(node, "Let"):
            yield from _of_condition(node.tokens)  # type: ignore[attr-defined]
        elif _is(node, "Formula", "Process"):
            yield from _of_formula(node.tokens, text)  # type: ignore[attr-defined]
        elif _is(node, "Within", "TopicExpires"):
            yield from _longer([node.duration])  # type: ignore[attr-defined]
            if _is(node, "Within"):
                place = node._tx_position, node._tx_position_end  # type: ignore[attr-defined]
                yield "timer dropped", [(*place, "")]
        elif _is(node, "Var", "Setting", "Binding"):
            yield from _of_value(node.tokens)  # type: ignore[attr-defined]


def _of_value(tokens: Sequence[Token]) -> Iterator[tuple[str, list[_Edit]]]:
    for token in tokens:
        if token in ("true", "false"):
            yield "value changed", [_instead(token, "false" if token == "true" else "true")]
        elif _NUMBER.match(token):
            yield "value changed", [_instead(token, _other(token))]
    yield from _longer(tokens)


def _instead(token: Token, new: str) -> _Edit:
    return token.start, token.end, new


def _other(number: str) -> str:
    """Another number: twice as much, and 1 more if it is small."""
    value = float(number)
    value = value + 1 if value < 3 else 2 * value
    return f"{value:g}"


def _longer(tokens: Iterable[Token]) -> Iterator[tuple[str, list[_Edit]]]:
    for token in tokens:
        if match := _DURATION.match(token):
            yield "timer longer", [_instead(token, f"{3 * float(match[1]):g}{match[2]}")]


def _of_condition(tokens: Sequence[Token]) -> Iterator[tuple[str, list[_Edit]]]:
    for token in tokens:
        if token in _TURNED:
            yield "comparison turned", [_instead(token, _TURNED[token])]
        elif _NUMBER.match(token):
            yield "number changed", [_instead(token, _other(token))]
    yield from _longer(tokens)


def _of_control(control: object, text: str) -> Iterator[tuple[str, list[_Edit]]]:
    ways = [entry for entry in control.entries if _is(entry, "Way")]  # type: ignore[attr-defined]
    for way in ways:
        yield from _of_way(way, text, ways)
    for one, other in pairwise(ways):
        if one.verb == other.verb or {one.verb, other.verb} <= {"enter", "skip"}:
            if one.verb == other.verb and _text(one.term, text) != _text(other.term, text):
                swapped = [_moved(one.term, other.term, text), _moved(other.term, one.term, text)]
                yield "target changed", swapped
            if all(way.tokens and way.tokens[0] not in ("/", "else") for way in (one, other)):
                here, there = _whole(one, text), _whole(other, text)
                swapped = [(*here, text[slice(*there)]), (*there, text[slice(*here)])]
                yield "order of lines", swapped
    for place, way in enumerate(ways):
        if way.tokens and way.tokens[0] == "else":
            first = place
            while first and ways[first - 1].verb in _BESIDE[way.verb]:
                first -= 1
            if first == place:
                continue
            start, end = _whole(way, text)
            word = way.tokens[0]
            open_one = text[start : word.start] + text[word.end : end]
            here = ways[first]._tx_position
            yield "else first", [(here, here, open_one + "\n    "), (start, end, "")]


def _text(tokens: Sequence[Token], text: str) -> str:
    return text[tokens[0].start : tokens[-1].end]


def _moved(here: Sequence[Token], there: Sequence[Token], text: str) -> _Edit:
    return here[0].start, here[-1].end, _text(there, text)


def _whole(way: object, text: str) -> tuple[int, int]:
    return way._tx_position, way._tx_position_end  # type: ignore[attr-defined]


def _of_way(way: object, text: str, ways: Sequence[object]) -> Iterator[tuple[str, list[_Edit]]]:
    tokens: Sequence[Token] = way.tokens  # type: ignore[attr-defined]
    start, end = _whole(way, text)
    slash = _outside(tokens, "/")
    head, tail = tokens[:slash], tokens[slash + 1 :]
    trigger = head[: _outside(head, "[")]
    yield "timer dropped" if trigger[:1] == ["after"] else "line dropped", [(start, end, "")]
    if way.verb == "resume":  # type: ignore[attr-defined]
        verb: Token = way.verb  # type: ignore[attr-defined]
        yield "resume forgotten", [_instead(verb, "enter")]
    opening = len(trigger)
    if opening < len(head):
        guard = head[opening + 1 : -1]
        yield "condition negated", [(head[opening].end, head[-1].start, f"!({_text(guard, text)})")]
        begin = trigger[-1].start if trigger and trigger[-1] == "when" else head[opening].start
        yield "condition dropped", [(begin, head[-1].end, "")]
        signs = [token for token in guard if token in _TURNED]
        is_negated = len(signs) == 1 and signs[0] not in ("&&", "||")  # by turning it
        for kind, edits in _of_condition(guard):
            if kind != "comparison turned" or not is_negated:
                yield kind, edits
    yield from _longer(trigger)
    if len(trigger) >= 2 and "from" in trigger:
        for other in ways:
            theirs = other.tokens  # type: ignore[attr-defined]
            if "from" in theirs and theirs[:2] != trigger[:2]:
                yield "another message", [_moved(trigger[:1], theirs[:1], text)]
    yield from _of_actions(tail, tokens[slash:], text)


def _outside(tokens: Sequence[Token], sign: str) -> int:
    """Where a sign stands outside all brackets, or behind the last token."""
    depth = 0
    for place, token in enumerate(tokens):
        if token == sign and depth == 0:
            return place
        depth += (token in ("(", "[", "{")) - (token in (")", "]", "}"))
    return len(tokens)


def _of_actions(
    tail: Sequence[Token], with_slash: Sequence[Token], text: str
) -> Iterator[tuple[str, list[_Edit]]]:
    actions: list[Sequence[Token]] = []
    rest = tail
    while rest:
        place = _outside(rest, ";")
        actions.append(rest[:place])
        rest = rest[place + 1 :]
    for number, action in enumerate(actions):
        if len(actions) == 1:
            cut = with_slash[0].start, action[-1].end
        elif number == 0:
            cut = action[0].start, actions[1][0].start
        else:
            cut = actions[number - 1][-1].end, action[-1].end
        is_send = action[0].split()[0] == "send"
        is_timer = action[0] == "start_timer"
        kind = "message not sent" if is_send else "timer dropped" if is_timer else "action dropped"
        yield kind, [(*cut, "")]
        yield from _longer(action)
        if is_send:
            yield from _of_receiver(action)
        elif not is_timer:
            for token in action:
                if token in ("true", "false"):
                    yield "value changed", [_instead(token, "false" if token == "true" else "true")]
                elif _NUMBER.match(token):
                    yield "value changed", [_instead(token, _other(token))]
                elif token in ("+", "-"):
                    yield "value changed", [_instead(token, "-" if token == "+" else "+")]


def _of_receiver(action: Sequence[Token]) -> Iterator[tuple[str, list[_Edit]]]:
    receiver = action[_outside(action, "to") + 1 :]
    place = _outside(receiver, "except")
    if place < len(receiver):
        yield "another receiver", [(receiver[place - 1].end, receiver[-1].end, "")]
    elif receiver and receiver[0] == "one":
        yield "another receiver", [(receiver[0].start, receiver[1].start, "")]
    elif len(receiver) == 1:
        yield "another receiver", [(receiver[0].start, receiver[0].start, "one ")]


def _of_formula(tokens: Sequence[Token], text: str) -> Iterator[tuple[str, list[_Edit]]]:
    depth = 0
    for place, token in enumerate(tokens):
        depth += (token == "(") - (token == ")")
        if token == "." and 0 < place < len(tokens) - 1:
            left, right = _operand(tokens[:place], -1), _operand(tokens[place + 1 :], 1)
            if left and right:
                yield "order of states", [_moved(left, right, text), _moved(right, left, text)]
        elif token in ("+", "~", "*"):
            yield "operator changed", [_instead(token, "")]
        elif token == "[>":
            yield "operator changed", [_instead(token, ".")]
        elif token == "[" and place + 1 < len(tokens) and not _NUMBER.match(tokens[place + 1]):
            close = place + 1 + _outside(tokens[place + 1 :], "]")
            if close < len(tokens):
                yield "operator changed", [_instead(token, "("), _instead(tokens[close], ")")]


def _operand(tokens: Sequence[Token], step: int) -> Sequence[Token]:
    """The operand that stands at the end (-1) or at the beginning (1) of tokens."""
    depth = 0
    for number in range(len(tokens)):
        token = tokens[number] if step == 1 else tokens[-1 - number]
        if depth == 0 and token in ("|", "||", "[>", ".", "=") and number:
            return tokens[:number] if step == 1 else tokens[len(tokens) - number :]
        change = (token in ("(", "[")) - (token in (")", "]"))
        depth += change * step
        if depth < 0:
            return tokens[:number] if step == 1 else tokens[len(tokens) - number :]
    return tokens


def in_turns(queues: Iterable[Sequence[T]]) -> Iterator[T]:
    """The first of each queue, then the second of each, to the end."""
    for turn in zip_longest(*queues):
        yield from (item for item in turn if item is not None)


def shuffled(kinds: Iterable[list[T]], chance: Random) -> list[T]:
    """What is of several kinds, in a random order in which the kinds take turns."""
    order = []
    for items in kinds:
        chance.shuffle(items)
        if items:
            order.append(items)
    chance.shuffle(order)
    return list(in_turns(order))


__all__ = ["KINDS", "ModelMutant", "in_turns", "model_mutants", "shuffled"]
