"""The classes of what the parser makes, one a rule of the .tx files, with the types of their members."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from aseme_dsl.grammar.parsing.rules import Expression, Rule, rules_of, textx_metamodel

_LONGEST = 110
_BEGIN = '''"""What the parser makes of the rules of the .tx files (`python -m aseme_dsl.grammar.syntax`).

The classes give the types; whether an object is of one of them, `pieces.is_a` says by its rule's name.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, TypeAlias

from aseme_dsl.grammar.text.token import Token as Leaf


class Node:
    """What was read by a rule, and where."""

    _tx_position: int
    _tx_position_end: int
'''


def nodes_text() -> str:
    """What stands in `grammar/parsing/nodes.py`."""
    rules = rules_of(textx_metamodel())
    return _BEGIN + "".join(f"{line}\n" for line in _lines(rules))


def _lines(rules: Mapping[str, Rule]) -> Iterator[str]:
    for name, rule in rules.items():
        if rule.kind == "common":
            yield from ("", "", f"class {name}(Node):")
            for attribute, number in rule.attributes.items():
                yield f"    {attribute}: {_type(rule, attribute, number, rules)}"
    yield from ("", "", "if TYPE_CHECKING:")
    for name, rule in rules.items():
        if rule.kind == "abstract":
            yield from _alias(name, _alternatives(rule, rules))


def _alias(name: str, parts: list[str]) -> Iterator[str]:
    """As `ruff format` would wrap it."""
    either = " | ".join(parts)
    line, inner = f"    {name}: TypeAlias = {either}", f"        {either}"
    if len(line) <= _LONGEST:
        yield line
        return
    yield f"    {name}: TypeAlias = ("
    if len(inner) <= _LONGEST:
        yield inner
    else:
        yield f"        {parts[0]}"
        for part in parts[1:]:
            yield f"        | {part}"
    yield "    )"


def _alternatives(rule: Rule, rules: Mapping[str, Rule]) -> list[str]:
    assert not isinstance(rule.expression, str)
    return list(dict.fromkeys(_name(str(part), rules) for part in rule.expression[1:]))


def _type(rule: Rule, attribute: str, number: str, rules: Mapping[str, Rule]) -> str:
    if number == "flag":
        return "bool"
    names = list(dict.fromkeys(_name(part, rules) for part in _values(rule.expression, attribute)))
    if number == "many":
        return f"list[{' | '.join(names)}]"
    return " | ".join(names if _is_certain(rule.expression, attribute) else [*names, "None"])


def _name(part: Expression, rules: Mapping[str, Rule]) -> str:
    """The type of what is read by a part: a rule of texts, or a terminal, gives a leaf."""
    return part if isinstance(part, str) and rules[part].kind != "match" else "Leaf"


def _values(expression: Expression, attribute: str) -> Iterator[Expression]:
    """The parts whose values an attribute gets."""
    if isinstance(expression, str):
        return
    kind, *parts = expression
    if kind in ("=", "*=", "+="):
        if parts[0] == attribute:
            yield parts[1]
    elif kind in ("series", "choice", "?", "*", "+"):
        for part in parts:
            yield from _values(part, attribute)


def _is_certain(expression: Expression, attribute: str) -> bool:
    """Whether an attribute has a value in all that a rule reads."""
    if isinstance(expression, str):
        return False
    kind, *parts = expression
    match kind:
        case "=" | "+=":
            return bool(parts[0] == attribute)
        case "series" | "+":
            return any(_is_certain(part, attribute) for part in parts)
        case "choice":
            return all(_is_certain(part, attribute) for part in parts)
        case _:
            return False
