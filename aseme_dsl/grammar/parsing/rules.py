"""The rules of the grammar as plain data, as textX reads them from the .tx files.

To read the .tx files takes longer than to check a small file. So `python -m aseme_dsl.grammar.syntax` writes
their rules into `prepared.py`. If the .tx files have changed since then, textX reads them instead.

An expression is the name of a rule, or one of

    ("word", "team")   ("sign", "{")   ("pattern", "[0-9]+")                       terminals
    ("series", …)   ("choice", …)   ("?", part)   ("*", part)   ("+", part)        of other expressions
    ("=", attribute, part)   ("?=", …)   ("*=", …)   ("+=", …)                     whose value is kept

where a list may have its separator as the last item.
"""

from __future__ import annotations

import zlib
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple, Protocol, TypeAlias

from aseme_dsl.grammar.parsing.progress import ParsingExpression, TextParser
from aseme_dsl.grammar.text.token import Token

if TYPE_CHECKING:
    from aseme_dsl.grammar.parsing.nodes import Declaration

_FOLDER = Path(__file__).parents[1]
_START = "aseme.tx"

Expression: TypeAlias = "str | tuple[Expression, ...]"


class Rule(NamedTuple):
    """A rule: `common` ones make objects, `abstract` ones are one of several of those, `match` ones a text.

    `attributes` are those of the objects, each of which is `one` value, a list of `many`, or a `flag`.
    """

    kind: str
    attributes: dict[str, str]
    expression: Expression


class TextXAttribute(Protocol):
    """An attribute of a rule in textX."""

    name: str
    ref: bool
    cont: bool
    mult: str
    bool_assignment: bool


class TextXClass(Protocol):
    """A rule in textX."""

    _tx_attrs: dict[str, TextXAttribute]
    _tx_peg_rule: ParsingExpression
    _tx_type: str


class Blueprint(Protocol):
    """The parser of which textX makes one a text."""

    parser_model: ParsingExpression
    comments_model: object


class Metamodel(Protocol):
    """A grammar in textX, which has no types itself."""

    namespaces: dict[str, dict[str, TextXClass]]
    _parser_blueprint: Blueprint

    def register_model_processor(self, processor: Callable[[TextXModel, object], None]) -> None: ...


class TextXModel(Protocol):
    """What textX makes of a file: as `nodes.File`, and where it is from."""

    language: Token | None
    declarations: list[Declaration]
    _tx_position: int
    _tx_position_end: int
    _tx_parser: TextParser
    _tx_filename: str | None


def rules() -> dict[str, Rule]:
    """The rules of the grammar by their names; the first is that of a file."""
    from aseme_dsl.grammar.parsing import prepared

    if checksum(prepared.FILES) == prepared.CHECKSUM:
        return {name: Rule(*rule) for name, rule in prepared.RULES.items()}
    return rules_of(textx_metamodel())


def textx_metamodel() -> Metamodel:
    """What textX makes of the .tx files."""
    from textx import metamodel_from_file

    made: Metamodel = metamodel_from_file(str(_FOLDER / _START), autokwd=True)
    return made


def checksum(files: Iterable[str]) -> int:
    """A number that changes with the text of the .tx files."""
    found = 0
    for name in files:
        found = zlib.crc32((_FOLDER / name).read_text("utf-8").encode(), found)
    return found


# ---- from textX ---------------------------------------------------------------------------------


def rules_of(metamodel: Metamodel) -> dict[str, Rule]:
    """The rules of a metamodel of textX, file by file, after that of a whole text.

    Raises:
        NotImplementedError: if it has what the grammar of `.aseme` does without.
    """
    found: dict[str, Rule] = {}
    spaces = {name: space for name, space in metamodel.namespaces.items() if name != "__base__"}
    for space in spaces.values():
        for name, kind in space.items():
            if name == "Comment":
                continue  # comments are blanked before anything is read
            if name in found:
                raise NotImplementedError(f"two rules {name}")
            attributes = {item.name: _attribute(item) for item in kind._tx_attrs.values()}
            top = kind._tx_peg_rule
            expression = _expression(top) if top.rule_name == name else str(top.rule_name)
            found[name] = Rule(kind._tx_type, attributes, expression)
    start = str(metamodel._parser_blueprint.parser_model.nodes[0].rule_name)
    return {start: found.pop(start), **found}


def _attribute(attribute: TextXAttribute) -> str:
    if attribute.ref and not attribute.cont:
        raise NotImplementedError(f"a reference: {attribute.name}")
    if attribute.mult in ("0..*", "1..*"):
        return "many"
    return "flag" if attribute.bool_assignment else "one"


_REPEATED = {"Optional": "?", "ZeroOrMore": "*", "OneOrMore": "+"}
_COMPOSED = {"Sequence": "series", "OrderedChoice": "choice", **_REPEATED}
_ASSIGNED = {"Sequence": "=", **{kind: f"{sign}=" for kind, sign in _REPEATED.items()}}


def _expression(node: ParsingExpression) -> Expression:
    """As deep as a rule is written."""
    kind = type(node).__name__
    if node.suppress or getattr(node, "eolterm", False):
        raise NotImplementedError(f"{node} in the grammar")
    if kind == "StrMatch":
        return ("sign", node.to_match)
    if kind == "RegExMatch":
        if node.to_match_regex == rf"{node.to_match}\b":
            return ("word", node.to_match)
        return ("pattern", node.to_match_regex)
    if kind not in _COMPOSED:
        raise NotImplementedError(f"{kind} in the grammar")
    separator = getattr(node, "sep", None)
    parts = (*map(_part, node.nodes), *([_expression(separator)] if separator is not None else []))
    if node.rule_name.startswith("__asgn"):
        return (_ASSIGNED[kind], node._attr_name, *parts)
    return (_COMPOSED[kind], *parts)


def _part(node: ParsingExpression) -> Expression:
    is_rule = node.root and not node.rule_name.startswith("__asgn")
    return str(node.rule_name) if is_rule else _expression(node)


def prepared_text() -> str:
    """What stands in `prepared.py`: the rules that textX reads now."""
    made = textx_metamodel()
    files = sorted(f"{name}.tx" for name in made.namespaces if name != "__base__")
    return "\n".join(_lines(files, rules_of(made)))


def _lines(files: list[str], found: dict[str, Rule]) -> Iterator[str]:
    yield '"""The rules of the .tx files; `python -m aseme_dsl.grammar.syntax` writes them: see rules.py."""'
    yield ""
    yield "from __future__ import annotations"
    yield ""
    yield "from collections.abc import Mapping"
    yield "from typing import TypeAlias"
    yield ""
    yield "Expression: TypeAlias = 'str | tuple[Expression, ...]'"
    yield ""
    yield f"FILES = {files!r}"
    yield f"CHECKSUM = {checksum(files)}"
    yield ""
    yield "RULES: Mapping[str, tuple[str, dict[str, str], Expression]] = {"
    for name, (kind, attributes, expression) in found.items():
        yield f"    {name!r}: ("
        yield f"        {kind!r},"
        yield f"        {attributes!r},"
        yield from _expression_lines(expression, " " * 8)
        yield "    ),"
    yield "}"
    yield ""


def _expression_lines(expression: Expression, indent: str) -> Iterator[str]:
    line = f"{indent}{expression!r},"
    if isinstance(expression, str) or len(line) <= 110 or expression[0] in ("word", "sign", "pattern"):
        yield line
        return
    yield f"{indent}("
    for part in expression:
        yield from _expression_lines(part, indent + "    ")
    yield f"{indent}),"
