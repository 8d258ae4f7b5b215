"""From the tokens of an expression to its tree.

Precedence, loosest first: `||`, `&&`, comparisons, `+ -`, `* / %`, then `!` and the signs. Comparisons do not
chain, and `!` takes an operand that is a value, a call or parenthesised: what may be read in two ways needs
parentheses (E107).
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from aseme_dsl.amola.expression import Literal, value_text
from aseme_dsl.amola.liveness import Argument
from aseme_dsl.amola.messages import DOUBLE, DURATION, INT, STRING
from aseme_dsl.diagnostics import Diagnostic, Edit, Related
from aseme_dsl.diagnostics.problems.syntax import characters
from aseme_dsl.diagnostics.problems.syntax import formulas as problems
from aseme_dsl.diagnostics.problems.syntax.entries import Wanted
from aseme_dsl.grammar.formulas.filling import in_braces
from aseme_dsl.grammar.formulas.reader import DEEPEST, Reader, is_word
from aseme_dsl.grammar.formulas.transition_mistakes import check_content
from aseme_dsl.grammar.formulas.words import Malformed
from aseme_dsl.grammar.text import tree
from aseme_dsl.grammar.text.lexer import HOLE
from aseme_dsl.grammar.text.token import Token, token
from aseme_dsl.runtime.time.clock import UNITS
from aseme_dsl.source import Source, Span

_LOGIC = {"||": "||", "or": "||", "&&": "&&", "and": "&&"}
_COMPARISON = ("<", "<=", ">", ">=", "==", "!=")
_CHAINS = ({"<", "<="}, {">", ">="}, {"=="})
"""Comparisons that mean one thing where they are chained: `a < b <= c` is `a < b && b <= c`."""
_SUM = ("+", "-")
_PRODUCT = ("*", "/", "%")
BINDING = (
    {"||": 1, "&&": 2} | dict.fromkeys(_COMPARISON, 3) | dict.fromkeys(_SUM, 4) | dict.fromkeys(_PRODUCT, 5)
)

_NUMBER = re.compile(r"([0-9]+)(?:\.([0-9]+))?([a-z]*)")
_LONGEST_NUMBER = 18
_HAVE_NO_ELEMENTS = (tree.Number, tree.Duration, tree.Truth, tree.Text)
"""What stands before the brackets of a condition, if anything does that is not a list."""

_EXPRESSION_TOKEN = re.compile(
    r'"(?:[^"\\\n]|\\.)*"|[0-9]+(?:\.[0-9]+)*[A-Za-z]*\b'
    r"|[A-Za-z_][A-Za-z0-9_]*(?:\s*\.\s*[A-Za-z_][A-Za-z0-9_]*)*\b|&&|\|\||[<>=!]=|\S",
    re.ASCII,
)
"""The tokens of an expression, as the grammar has them (ExpressionToken)."""


def read_expression(source: Source, tokens: Sequence[Token]) -> tree.Expression:
    """The expression that the tokens spell.

    Raises:
        Malformed: They spell none; with the first thing that is wrong (E102, E103, E107, E108).
    """
    reader = Reader(source, tokens)
    expression = operation(reader)
    if reader.index < len(tokens):
        raise reader.unexpected(Wanted.OPERATOR)
    return expression


def read_arguments(source: Source, tokens: Sequence[Token]) -> tuple[Argument, ...]:
    """The arguments `(a, b + 1)` of an activity, from the tokens of a formula with both parentheses.

    Raises:
        Malformed: As `read_expression`.
    """
    start = tokens[0].start
    text = [" "] * (tokens[-1].end - start)
    for part in tokens:
        text[part.start - start : part.end - start] = part
    found = _EXPRESSION_TOKEN.finditer("".join(text))
    reader = Reader(source, [token(piece.group(), start + piece.start()) for piece in found])
    opener = reader.take()
    arguments = [operation(reader)]
    while reader.next == ",":
        reader.take()
        arguments.append(operation(reader))
    reader.need(")", opener)
    return tuple(Argument(spelled(item), item, item.span) for item in arguments)


def spelled(written: tree.Expression) -> str:
    """An expression in canonical spelling, with the parentheses that it has."""
    match written:
        case tree.Number(value=number, span=span):
            return value_text(Literal(number, INT if isinstance(number, int) else DOUBLE, span))
        case tree.Duration(nanoseconds=nanoseconds, span=span):
            return value_text(Literal(nanoseconds, DURATION, span))
        case tree.Truth(value=truth):
            return "true" if truth else "false"
        case tree.Text(text=text, span=span):
            return value_text(Literal(text, STRING, span))
        case tree.Path():
            return ".".join(segment.text for segment in written.segments)
        case tree.Call(function=function, arguments=arguments):
            return f"{spelled(function)}({', '.join(map(spelled, arguments))})"
        case tree.Unary(operator=operator, operand=operand):
            return f"{operator}{spelled(operand)}"
        case tree.Binary(operator=operator, left=left, right=right):
            return f"{spelled(left)} {operator} {spelled(right)}"
        case tree.Logic(operator=operator, operands=operands):
            return f" {operator} ".join(map(spelled, operands))
        case tree.Conditional(condition=condition, yes=yes, no=no):
            return f"{spelled(condition)} ? {spelled(yes)} : {spelled(no)}"
        case tree.Parenthesised(inner=inner):
            return f"({spelled(inner)})"
        case tree.List(elements=elements):
            return f"[{', '.join(map(spelled, elements))}]"
        case tree.Element(list=whole, index=index, members=members):
            return ".".join((f"{spelled(whole)}[{spelled(index)}]", *(name.text for name in members)))
        case tree.NewMessage(message=message, fills=fills, rest=rest):
            said = [f"{item.target.text} = {spelled(item.value)}" for item in fills]
            if rest is not None:
                said.append(f"..{spelled(rest.message) if rest.message is not None else ''}")
            return f"{message} {{ {', '.join(said)} }}" if said else f"{message} {{ }}"
        case tree.Hole():
            return HOLE


def read_duration(source: Source, text: Token) -> tree.Duration:
    """A duration that the grammar has recognised.

    Raises:
        Malformed: It is too long, or not a whole number of nanoseconds (E108).
    """
    found = value(Reader(source, [text]))
    assert isinstance(found, tree.Duration)
    return found


def read_text(source: Source, text: Token) -> tree.Text:
    """A text in quotes that the grammar has recognised, with its escapes resolved."""
    inner = text[1:-1]
    if "\\" in inner:
        inner = re.sub(r"\\(.)", r"\1", inner)
    return tree.Text(inner, Span(source, text.start, text.end))


def read_path(source: Source, text: Token) -> tree.Path:
    """A dotted name that the grammar has recognised."""
    return Reader(source, [text]).path(text)


def operation(reader: Reader, loosest: int = 1) -> tree.Expression:
    """The expression that begins here, of operators that bind at least so tightly. Raises Malformed."""
    reader.depth += 1
    if reader.depth > DEEPEST + 1:
        raise reader.too_deep(reader.tokens[min(reader.index, len(reader.tokens) - 1)])
    made = _operators(reader, loosest)
    if loosest == 1 and reader.next == "?":
        made = _conditional(reader, made)
    reader.depth -= 1
    return made


def _conditional(reader: Reader, condition: tree.Expression) -> tree.Expression:
    """`? yes : no` behind a condition; `no` may be another one."""
    mark = reader.take()
    yes = operation(reader)
    if reader.next in ("=", "+=", "-=", "*="):
        problem = problems.ActionChosen((":",), reader.tokens[reader.index - 1], reader.next)
        raise reader.error(problem, reader.tokens[reader.index])
    if reader.next != ":":
        raise reader.unexpected(":", related=(Related(reader.span(mark), "this '?'"),))
    reader.take()
    no = operation(reader)
    made = tree.Conditional(condition, yes, no, condition.span.to(no.span))
    return reader.grown(made, condition, yes, no)


def _operators(reader: Reader, loosest: int) -> tree.Expression:
    left = _unary(reader)
    negation = left if isinstance(left, tree.Unary) and left.operator == "!" else None
    while True:
        word = reader.next
        operator = _LOGIC.get(word, word)
        binding = BINDING.get(operator, 0)
        if binding < loosest or binding == 0:
            return left
        at = reader.tokens[reader.index]
        if negation is not None and binding > 2:
            raise _negated(reader, negation, at, binding)
        reader.index += 1
        if binding <= 2:
            operands = [left, operation(reader, binding + 1)]
            while _LOGIC.get(reader.next, "") == operator:
                reader.index += 1
                operands.append(operation(reader, binding + 1))
            left = reader.grown(
                tree.Logic(operator, tuple(operands), operands[0].span.to(operands[-1].span)), *operands
            )
            continue
        right = operation(reader, binding + 1)
        span = left.span.to(right.span)
        left = reader.grown(tree.Binary(operator, left, right, reader.span(at), span), left, right)
        if binding == 3 and reader.next in _COMPARISON:
            raise _chained(reader, left, reader.tokens[reader.index])


def _unary(reader: Reader) -> tree.Expression:
    signs: list[Token] = []
    while reader.next in ("!", "not", "-", "+"):
        signs.append(reader.take())
        if len(signs) > DEEPEST:
            raise reader.too_deep(signs[-1])
    operand = value(reader)
    for sign in reversed(signs):
        operator = "!" if sign == "not" else str(sign)
        operand = reader.grown(
            tree.Unary(operator, operand, Span(reader.source, sign.start, operand.span.end)), operand
        )
    return operand


def value(reader: Reader) -> tree.Expression:
    """A value, with what stands in `[ ]` behind it. Raises Malformed."""
    found = _whole(reader)
    while reader.next == "[" and not isinstance(found, _HAVE_NO_ELEMENTS):
        opener = reader.take()
        index = operation(reader)
        reader.need("]", opener)
        members: tuple[tree.Name, ...] = ()
        if reader.next == "." and reader.index + 1 < len(reader.tokens):
            reader.take()
            if not is_word(reader.next):
                raise reader.unexpected(Wanted.ELEMENT_MEMBER)
            members = reader.path(reader.take()).segments
        made = tree.Element(found, index, members, reader.since(found.span.start))
        found = reader.grown(made, found, index)
    return found


def _elements(reader: Reader) -> tree.List:
    """`[a, b]`"""
    opener = reader.take()
    elements = _separated(reader, opener, "]")
    return reader.grown(tree.List(tuple(elements), reader.since(opener.start)), *elements)


def _separated(reader: Reader, opener: Token, closer: str) -> list[tree.Expression]:
    """The values behind an opener, with commas between them, and the closer."""
    found: list[tree.Expression] = []
    if reader.next != closer:
        found.append(operation(reader))
        while reader.next == ",":
            reader.take()
            found.append(operation(reader))
    if reader.next != closer:
        raise reader.unexpected(Wanted.OPERATOR, ",", closer, related=(reader.still_open(opener),))
    reader.take()
    return found


def _whole(reader: Reader) -> tree.Expression:
    """A value without what stands in `[ ]` behind it."""
    if reader.index == len(reader.tokens):
        check_content(reader)
        raise reader.unexpected(Wanted.VALUE)
    first = reader.tokens[reader.index]
    initial = first[0]
    if initial.isdigit():
        return _number(reader, reader.take())
    if initial == '"':
        reader.index += 1
        return read_text(reader.source, first)
    if first == "[":
        return _elements(reader)
    if first == "(":
        reader.take()
        inner = operation(reader)
        reader.need(")", first)
        return reader.grown(tree.Parenthesised(inner, reader.since(first.start)), inner)
    if not is_word(first) or first in ("and", "or", "else", "when"):
        raise _no_value(reader, first)
    reader.index += 1
    if first == "true" or first == "false":
        return tree.Truth(first == "true", reader.span(first))
    path = reader.path(first)
    if reader.next == "{":
        return _new_message(reader, path)
    if reader.next != "(":
        return path
    arguments = _separated(reader, reader.take(), ")")
    return reader.grown(tree.Call(path, tuple(arguments), reader.since(first.start)), *arguments)


def _no_value(reader: Reader, found: Token) -> Malformed:
    """What stands where a value should begin."""
    if found == "{":
        return reader.error(problems.ContentWithoutMessage(), found)
    is_rest = found == "." and reader.tokens[reader.index + 1 : reader.index + 2] == ["."]
    if reader.index and (is_rest or found == ".."):
        before = reader.tokens[reader.index - 1]
        return reader.error(problems.RestOutsideBraces((Wanted.VALUE,), before, ".."), found)
    return reader.unexpected(Wanted.VALUE)


def _new_message(reader: Reader, path: tree.Path) -> tree.NewMessage:
    """`Order { id = 7, ..now }`"""
    fills, rest, places = in_braces(reader, operation)
    assert fills is not None and places is not None
    made = tree.NewMessage(
        tree.Name(path.text, path.span), fills, rest, places, reader.since(path.span.start)
    )
    return reader.grown(made, *(item.value for item in fills))


def _number(reader: Reader, text: Token) -> tree.Number | tree.Duration:
    found = _NUMBER.fullmatch(text)
    if found is None:
        raise reader.error(characters.TwoPointsInNumber(text), text)
    whole, fraction, unit = found[1], found[2] or "", found[3]
    if len(whole) > _LONGEST_NUMBER or len(fraction) > 100:
        raise reader.error(characters.TooManyDigits(text), text)
    if unit:
        nanoseconds, rest = divmod(int(whole + fraction) * UNITS[unit], 10 ** len(fraction))
        if rest:
            raise reader.error(characters.PartOfNanosecond(text), text)
        return tree.Duration(nanoseconds, reader.span(text))
    if reader.next in UNITS:
        following = reader.tokens[reader.index]
        span = Span(reader.source, text.start, following.end)
        problem = characters.BlankBeforeUnit(text, following)
        raise Malformed(Diagnostic(problem, span, fix=f"{text}{following}"))
    return tree.Number(float(text) if fraction else int(whole), reader.span(text))


def _negated(reader: Reader, negation: tree.Unary, operator: Token, binding: int) -> Malformed:
    """Parentheses around a comparison are right however it is read: `(!a) == b` is `!(a == b)`."""
    inner = reader.source.text[negation.operand.span.start : negation.operand.span.end]
    edits: tuple[Edit, ...] = ()
    if operator in _COMPARISON and not isinstance(negation.operand, tree.Unary):
        try:
            reader.index += 1
            end = operation(reader, binding + 1).span.end
        except Malformed:
            end = 0
        if end and reader.next not in _COMPARISON:
            start = negation.operand.span.start
            opened = Edit(Span(reader.source, start, start), "(")
            edits = (opened, Edit(Span(reader.source, end, end), ")"))
    sign = Span(reader.source, negation.span.start, negation.span.start + 1)
    problem = problems.NegatedComparison(inner, operator)
    return reader.error(problem, operator, related=(Related(sign, "this '!'"),), edits=edits)


def _chained(reader: Reader, left: tree.Expression, operator: Token) -> Malformed:
    assert isinstance(left, tree.Binary)
    middle = left.right.span.text
    problem = problems.ChainedComparisons(left.span.text, middle, left.operator, operator)
    edits: tuple[Edit, ...] = ()
    if any({left.operator, operator} <= chain for chain in _CHAINS):
        edits = (Edit(Span(reader.source, operator.start, operator.start), f"&& {middle} "),)
    return reader.error(
        problem, operator, related=(Related(left.operator_span, "the first comparison"),), edits=edits
    )
