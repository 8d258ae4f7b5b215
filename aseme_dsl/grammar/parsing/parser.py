"""From the rules of the grammar to a parser, and from what it has parsed to objects.

It is the parser that textX makes of the same rules, of Arpeggio's parts, and the objects have what textX
gives its own: the attributes of their rule, `_tx_position` and `_tx_position_end`. textX itself, which takes
long to import, is not needed.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from arpeggio import (
    EOF,
    OneOrMore,
    Optional,
    OrderedChoice,
    Parser,
    RegExMatch,
    Sequence,
    StrMatch,
    Terminal,
    ZeroOrMore,
)

from aseme_dsl.grammar.parsing.rules import Expression, Rule

_COMPOSED = {"series": Sequence, "choice": OrderedChoice, "?": Optional, "*": ZeroOrMore, "+": OneOrMore}
_ASSIGNED = {
    "=": (Sequence, "__asgn_plain"),
    "?=": (Optional, "__asgn_optional"),
    "*=": (ZeroOrMore, "__asgn_zeroormore"),
    "+=": (OneOrMore, "__asgn_oneormore"),
}


class RulesParser(Parser):  # type: ignore[misc]
    """A parser of a grammar that is given as rules; one object parses one text."""

    def __init__(self, parser_model: Any) -> None:
        super().__init__()
        self.parser_model = parser_model
        self.comments_model = None

    def _parse(self) -> Any:
        return self.parser_model.parse(self)


def parsing_expressions(rules: Mapping[str, Rule]) -> Any:
    """Arpeggio's parsing expression of the first of the rules, up to the end of the text.

    The terminals' regular expressions are not compiled: a small file needs few of them.
    """
    made: dict[str, Any] = {}
    top = _of_rule(next(iter(rules)), rules, made)
    return Sequence(nodes=[top, EOF()], rule_name="Model", root=True)


def _of_rule(name: str, rules: Mapping[str, Rule], made: dict[str, Any]) -> Any:
    """The rules are not recursive, so this ends, and is as deep as the grammar."""
    if name not in made:
        rule = rules[name]
        node = made[name] = _node(rule.expression, rules, made)
        if not isinstance(rule.expression, str):
            node.rule_name, node.root = name, True
            node.kind = type(name, (_Object,), {"rule": rule})
    return made[name]


def _node(expression: Expression, rules: Mapping[str, Rule], made: dict[str, Any]) -> Any:
    if isinstance(expression, str):
        return _of_rule(expression, rules, made)
    kind, *parts = expression
    if kind == "sign":
        return StrMatch(parts[0])
    if kind in ("word", "pattern"):
        return RegExMatch(rf"{parts[0]}\b", str_repr=parts[0]) if kind == "word" else RegExMatch(parts[0])
    if kind in _ASSIGNED:
        made_as, rule_name = _ASSIGNED[kind]
        attribute, *parts = parts
        node = made_as(rule_name=rule_name, root=True)
        node._attr_name = attribute
    else:
        node = _COMPOSED[kind]()
    node.nodes = [_node(part, rules, made) for part in parts]
    if kind in ("*", "+", "*=", "+=") and len(parts) > 1:
        node.sep = node.nodes.pop()
        node.sep.rule_name = "sep"
    return node


class _Object:
    """What has been read by a `common` rule: its class has the rule's name."""

    rule: Rule
    _tx_position: int
    _tx_position_end: int


def objects(tree: Any) -> Any:
    """The object of a parse tree, with those in it; the text where a rule makes no objects.

    It is as deep as the grammar.
    """
    if isinstance(tree, Terminal):
        return tree.value
    kind = tree.rule.kind
    if kind.rule.kind == "match":
        return "".join(str(objects(part)) for part in tree) if len(tree) > 1 else objects(tree[0])
    if kind.rule.kind == "abstract":
        return objects(next((part for part in tree if not isinstance(part, Terminal)), tree[0]))
    made = kind()
    made._tx_position = tree.position
    made._tx_position_end = tree.position_end
    values = made.__dict__
    for name, number in kind.rule.attributes.items():
        values[name] = [] if number == "many" else False if number == "flag" else None
    for part in tree:
        name = getattr(part.rule, "_attr_name", None)
        if name is None:
            continue
        if isinstance(part.rule, Optional):
            values[name] = True
        elif kind.rule.attributes[name] == "many":
            values[name] += [objects(item) for item in part if item.rule_name != "sep"]
        else:
            values[name] = objects(part[0])
    return made
