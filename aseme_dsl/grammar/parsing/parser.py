"""Makes a parser of the rules of the grammar, and objects of its parse trees.

The parser consists of the same Arpeggio objects that textX makes of these rules. The objects have the same
attributes as those of textX: the attributes of their rule, `_tx_position` and `_tx_position_end`. So textX,
which takes long to import, need not be imported.
"""

from __future__ import annotations

from collections.abc import Mapping

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

from aseme_dsl.grammar.parsing.progress import Parsed, ParseNode, ParsingExpression
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

    def __init__(self, parser_model: ParsingExpression) -> None:
        super().__init__()
        self.parser_model = parser_model
        self.comments_model = None

    def _parse(self) -> object:
        return self.parser_model.parse(self)


def parsing_expressions(rules: Mapping[str, Rule]) -> ParsingExpression:
    """Arpeggio's parsing expression of the first of the rules, up to the end of the text.

    The terminals' regular expressions are not compiled: a small file needs few of them.
    """
    made: dict[str, ParsingExpression] = {}
    top = _of_rule(next(iter(rules)), rules, made)
    whole: ParsingExpression = Sequence(nodes=[top, EOF()], rule_name="Model", root=True)
    return whole


def _of_rule(name: str, rules: Mapping[str, Rule], made: dict[str, ParsingExpression]) -> ParsingExpression:
    """The rules are not recursive, so this ends, and is as deep as the grammar."""
    if name not in made:
        rule = rules[name]
        node = made[name] = _node(rule.expression, rules, made)
        if not isinstance(rule.expression, str):
            node.rule_name, node.root = name, True
            node.kind = _kind_of(name, rule)
    return made[name]


def _kind_of(name: str, rule: Rule) -> type[Parsed]:
    class Made(Parsed):
        pass

    Made.__name__ = Made.__qualname__ = name
    Made.rule = rule
    return Made


def _node(
    expression: Expression, rules: Mapping[str, Rule], made: dict[str, ParsingExpression]
) -> ParsingExpression:
    if isinstance(expression, str):
        return _of_rule(expression, rules, made)
    first, *parts = expression
    kind = str(first)
    node: ParsingExpression
    if kind in ("sign", "word", "pattern"):
        text = str(parts[0])
        if kind == "word":
            node = RegExMatch(rf"{text}\b", str_repr=text)
        else:
            node = StrMatch(text) if kind == "sign" else RegExMatch(text)
        return node
    if kind in _ASSIGNED:
        made_as, rule_name = _ASSIGNED[kind]
        attribute, *parts = parts
        node = made_as(rule_name=rule_name, root=True)
        node._attr_name = str(attribute)
    else:
        node = _COMPOSED[kind]()
    node.nodes = [_node(part, rules, made) for part in parts]
    if kind in ("*", "+", "*=", "+=") and len(parts) > 1:
        separator = node.sep = node.nodes.pop()
        separator.rule_name = "sep"
    return node


def objects(tree: ParseNode) -> object:
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
        assigned: str | None = getattr(part.rule, "_attr_name", None)
        if assigned is None:
            continue
        if isinstance(part.rule, Optional):
            values[assigned] = True
        elif kind.rule.attributes[assigned] == "many":
            values[assigned] += [objects(item) for item in part if item.rule_name != "sep"]
        else:
            values[assigned] = objects(part[0])
    return made
