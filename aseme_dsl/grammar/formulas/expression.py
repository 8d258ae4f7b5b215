"""From the tokens of an expression or a transition expression to its tree.

Precedence, loosest first: `||`, `&&`, comparisons, `+ -`, `* / %`, then `!` and the signs. Comparisons do not
chain, and `!` takes an operand that is a value, a call or parenthesised: what may be read in two ways needs
parentheses (E107).
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import TypeVar

from aseme_dsl.amola.expression import Literal, value_text
from aseme_dsl.amola.liveness import Argument
from aseme_dsl.amola.messages import BUILT_IN, DOUBLE, DURATION, INT, STRING
from aseme_dsl.diagnostics import Diagnostic, Edit, Problem, Related, closest, surely
from aseme_dsl.diagnostics.problems.syntax import characters
from aseme_dsl.diagnostics.problems.syntax import formulas as problems
from aseme_dsl.diagnostics.problems.syntax.entries import Wanted
from aseme_dsl.grammar.formulas.filling import apart
from aseme_dsl.grammar.formulas.words import RESERVED, Malformed, is_hyphen
from aseme_dsl.grammar.text import tree
from aseme_dsl.grammar.text.lexer import HOLE, UNITS
from aseme_dsl.grammar.text.recovery import BLOCKS
from aseme_dsl.grammar.text.token import Token, token
from aseme_dsl.source import Source, Span

DEEPEST = 100
"""How many operators, calls and parentheses may stand one in the other."""

_LOGIC = {"||": "||", "or": "||", "&&": "&&", "and": "&&"}
_COMPARISON = ("<", "<=", ">", ">=", "==", "!=")
_CHAINS = ({"<", "<="}, {">", ">="}, {"=="})
"""Comparisons that mean one thing where they are chained: `a < b <= c` is `a < b && b <= c`."""
_SUM = ("+", "-")
_PRODUCT = ("*", "/", "%")
_BINDING = (
    {"||": 1, "&&": 2} | dict.fromkeys(_COMPARISON, 3) | dict.fromkeys(_SUM, 4) | dict.fromkeys(_PRODUCT, 5)
)
_TIGHTEST = 6

_PATH = re.compile(r"[A-Za-z_]\w*", re.ASCII)
_NUMBER = re.compile(r"([0-9]+)(?:\.([0-9]+))?([a-z]*)")
_LONGEST_NUMBER = 18
_CONTENT = re.compile(
    r"\s*(send\s+(?P<kind>[A-Za-z_]\w*)(?:\s+(?P<message>[A-Za-z_]\w*))?|write_messages(?:\s*\.\s*\w+)+)"
    r"\s*\{",
    re.ASCII,
)
_COLON = re.compile(
    r'(?:(?:"[^"\n]*"|[^{}":\n])*,)?\s*[A-Za-z_][\w.]*\s*:',
    re.ASCII,
)
_UNCLOSED = re.compile(r"[^{}\n]*?([^\s{},;]+)[ \t,;]*(?=\bto\b(?!\s*=)|\n|\Z)", re.ASCII)
"""A message with its braces, and what may be wrong inside them."""

_HAVE_NO_ELEMENTS = (tree.Number, tree.Duration, tree.Truth, tree.Text)
"""What stands before the brackets of a condition, if anything does that is no list."""

Made = TypeVar("Made", bound=tree.Expression)

_BEGINS_NO_ACTION = ("", ";", "/", "]", ")", "[", ",", "=", ".")
_ARE_NO_ACTION = ("else", "when", "and", "or")

_MEANT = {"&": "&&", "|": "||", "=": "==", "and": "&&", "or": "||", "^": None, "?": None}
"""Operators of other languages, with what they mean."""


def read_expression(source: Source, tokens: Sequence[Token]) -> tree.Expression:
    """The expression that the tokens spell.

    Raises:
        Malformed: They spell none; with the first thing that is wrong (E102, E103, E107, E108).
    """
    reader = _Reader(source, tokens)
    expression = reader.expression()
    if reader.index < len(tokens):
        raise reader.unexpected(Wanted.OPERATOR)
    return expression


def read_transition(source: Source, tokens: Sequence[Token], place: Span) -> tree.TransitionExpression:
    """`event [condition] / action; action`; `place` is where an empty one stands.

    Raises:
        Malformed: As `read_expression`.
    """
    if not tokens:
        return tree.TransitionExpression((), False, False, None, (), place)
    return _Reader(source, apart(tokens)).transition()


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
    reader = _Reader(source, [token(piece.group(), start + piece.start()) for piece in found])
    opener = reader.take()
    arguments = [reader.expression()]
    while reader.next == ",":
        reader.take()
        arguments.append(reader.expression())
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
        case tree.Parenthesised(inner=inner):
            return f"({spelled(inner)})"
        case tree.List(elements=elements):
            return f"[{', '.join(map(spelled, elements))}]"
        case tree.Element(list=whole, index=index, members=members):
            return ".".join((f"{spelled(whole)}[{spelled(index)}]", *(name.text for name in members)))
        case tree.Hole():
            return HOLE


_LATER_VERBS = ("on", "exit", "resume")
"""The verbs that are so only before a term and `:`, and may be names elsewhere."""

_IN_TERMS = frozenset("( ) . | || ~ * + ;".split())
"""What terms are made of, besides names."""

_EXPRESSION_TOKEN = re.compile(
    r'"(?:[^"\\\n]|\\.)*"|[0-9]+(?:\.[0-9]+)*[A-Za-z]*\b'
    r"|[A-Za-z_][A-Za-z0-9_]*(?:\s*\.\s*[A-Za-z_][A-Za-z0-9_]*)*\b|&&|\|\||[<>=!]=|\S",
    re.ASCII,
)
"""The tokens of an expression, as the grammar has them (ExpressionToken)."""


def read_duration(source: Source, text: Token) -> tree.Duration:
    """A duration that the grammar has recognised.

    Raises:
        Malformed: It is too long, or not a whole number of nanoseconds (E108).
    """
    value = _Reader(source, [text]).value()
    assert isinstance(value, tree.Duration)
    return value


def read_text(source: Source, text: Token) -> tree.Text:
    """A text in quotes that the grammar has recognised, with its escapes resolved."""
    inner = text[1:-1]
    if "\\" in inner:
        inner = re.sub(r"\\(.)", r"\1", inner)
    return tree.Text(inner, Span(source, text.start, text.end))


def read_path(source: Source, text: Token) -> tree.Path:
    """A dotted name that the grammar has recognised."""
    segments = tuple(
        tree.Name(found.group(), Span(source, text.start + found.start(), text.start + found.end()))
        for found in _PATH.finditer(text)
    )
    return tree.Path(segments, Span(source, text.start, text.end))


class _Reader:
    def __init__(self, source: Source, tokens: Sequence[Token]) -> None:
        self.source = source
        self.tokens = tokens
        self.index = 0
        self.depth = 0
        self.heights: dict[int, int] = {}

    # ---- tokens --------------------------------------------------------------------------------

    @property
    def next(self) -> str:
        return self.tokens[self.index] if self.index < len(self.tokens) else ""

    def take(self) -> Token:
        taken = self.tokens[self.index]
        self.index += 1
        return taken

    def need(self, text: str, opener: Token | None = None) -> Token:
        if self.next == text:
            return self.take()
        if opener is not None and self.index == len(self.tokens):
            raise self.unexpected(text, related=(self._still_open(opener),))
        raise self.unexpected(Wanted.OPERATOR, text, related=(self._still_open(opener),) if opener else ())

    def need_name(self, wanted: Wanted) -> tree.Name:
        if self.index == len(self.tokens) or not _is_name(self.next) or self.next in RESERVED:
            raise self.unexpected(wanted)
        taken = self.tokens[self.index]
        if "." in taken:
            raise self.error(problems.UnexpectedInExpression((wanted,), None, taken), taken)
        self.index += 1
        return tree.Name(str(taken), self.span(taken))

    def span(self, text: Token) -> Span:
        return Span(self.source, text.start, text.end)

    def since(self, start: int) -> Span:
        return Span(self.source, start, self.tokens[self.index - 1].end)

    # ---- transition expressions ----------------------------------------------------------------

    def transition(self) -> tree.TransitionExpression:
        start = self.tokens[0].start
        events: list[tree.Event] = []
        when = False
        otherwise = False
        condition: tree.Expression | None = None
        actions: list[tree.Action] = []
        if self.next == "else":
            word = self.take()
            otherwise = True
            if self.next == "[":
                raise self.error(problems.ElseWithCondition(), word)
        elif self.next not in ("[", "/"):
            while True:
                if self.next == "when":
                    self.take()
                    when = True
                else:
                    events.append(self.event())
                if self.next not in ("or", "||"):
                    break
                self.take()
        if self.next == "[":
            opener = self.take()
            condition = self.hole() or self.expression()
            self.need("]", opener)
        elif when:
            raise (
                self._bare_condition(self.index) if _is_name(self.next) else self.unexpected(Wanted.CONDITION)
            )
        if self.next == "/":
            self.take()
            while True:
                actions.append(self.action())
                if self.next != ";":
                    break
                self.take()
        if self.index < len(self.tokens):
            raise self._after_transition(bool(actions), condition is not None or otherwise)
        return tree.TransitionExpression(
            tuple(events), when, otherwise, condition, tuple(actions), self.since(start)
        )

    def hole(self) -> tree.Hole | None:
        """The `?` of `[?]`."""
        if self.next != HOLE or self.tokens[self.index + 1 : self.index + 2] != ["]"]:
            return None
        return tree.Hole(self.span(self.take()))

    def event(self) -> tree.Event:
        start = self.index
        if not _is_name(self.next) or self.next in RESERVED:
            if start == 0:
                raise self._bare_condition(0)
            raise self.unexpected(Wanted.EVENT)
        first = self.take()
        following = self.next
        if first in ("send", "read_messages") or first.startswith("write_messages"):
            fix = f"/ {first}" if start == 0 else None
            raise self.error(problems.ActionWithoutSlash(first), first, fix)
        if first in _LATER_VERBS and (
            following == "(" or (_is_name(following) and following not in RESERVED)
        ):
            raise self._no_colon(first)
        if first == "after" and following == "(":
            opener = self.take()
            duration = self.expression()
            self.need(")", opener)
            return tree.After(duration, self.since(first.start))
        if first == "if" and following == "[":
            between = Edit(Span(self.source, first.start, self.tokens[self.index].start), "")
            raise self.error(problems.ConditionWithIf(None), first, edits=(between,))
        if (
            following
            and _is_name(following)
            and following not in RESERVED
            and "." not in first
            and "." not in following
        ):
            if first == "if" and self.tokens[self.index : self.index + 2][1:] != ["from"]:
                raise self._if(first)
            if first == "lost":
                return self._lost(first)
            self.index -= 1
            performative = self.need_name(Wanted.PERFORMATIVE)
            message = self.need_name(Wanted.MESSAGE)
            name = None
            if _is_name(self.next) and self.tokens[self.index + 1 : self.index + 2] == ["from"]:
                name = self.need_name(Wanted.MESSAGE_NAME)
            if self.next != "from":
                raise self._no_from()
            self.take()
            participant = self.need_name(Wanted.SENDING_PARTICIPANT)
            if self.next == "as" and name is None and self.index + 1 < len(self.tokens):
                called = self.tokens[self.index + 1]
                problem = problems.NameBehindFrom(performative.text, message.text, called, participant.text)
                raise self.error(problem, self.tokens[self.index])
            return tree.Received(performative, message, participant, self.since(first.start), name)
        if (
            "." in first
            or following in ("(", "and")
            or (following in _BINDING and following not in ("||", "/"))
        ):
            raise self._bare_condition(start)
        return tree.Raised(tree.Name(str(first), self.span(first)), self.span(first))

    def _lost(self, word: Token) -> tree.Lost:
        if self.next == "from":
            raise self.unexpected(Wanted.PARTICIPANT)
        participant = self.need_name(Wanted.PARTICIPANT)
        name = None
        if _is_name(self.next) and self.next not in RESERVED:
            name = self.need_name(Wanted.AGENT_NAME)
        return tree.Lost(participant, name, self.since(word.start))

    def action(self) -> tree.Action:
        self._check_content()
        if self.next[:1] in _BEGINS_NO_ACTION or self.next in _ARE_NO_ACTION:
            raise self.unexpected(Wanted.ACTION)
        first = self.tokens[self.index]
        following = self.tokens[self.index + 1] if self.index + 1 < len(self.tokens) else ""
        if first == "send" and following and _is_name(following):
            return self.send()
        if first == "read_messages" and following != "(":
            self.take()
            return tree.ReadMessages(self.span(first))
        head, dot, _ = first.partition(".")
        if head.strip() == "write_messages" and following not in ("(", "="):
            path = read_path(self.source, first)
            self.take()
            if not dot:
                raise self.error(problems.PublishWithoutChannel(), first)
            topic = tree.Path(path.segments[1:], path.segments[1].span.to(path.span))
            fills = self.fills() if self.next == "{" else None
            return tree.Publish(topic, self.since(first.start), fills)
        expression = self.expression()
        if self.next != "=":
            return tree.Evaluate(expression, self.since(first.start))
        equals = self.take()
        if not isinstance(expression, tree.Path):
            raise self.error(problems.NotAssignable(), equals)
        value = self.expression()
        return tree.Assign(expression, value, self.since(first.start))

    def send(self) -> tree.Send:
        start = self.take().start
        performative = self.need_name(Wanted.PERFORMATIVE)
        message = self.need_name(Wanted.MESSAGE)
        fills = self.fills() if self.next == "{" else None
        if self.next != "to":
            raise self.unexpected(Wanted.RECEIVER)
        self.take()
        participant, receiver = None, None
        if self.index + 1 < len(self.tokens) and self.tokens[self.index + 1] in ("(", "["):
            receiver = self.value()
        else:
            participant = self.need_name(Wanted.RECEIVING_PARTICIPANT)
        excepts: list[tree.Expression] = []
        if self.next == "except":
            self.take()
            excepts.append(self.value())
            while self.next == ",":
                self.take()
                excepts.append(self.value())
        return tree.Send(
            performative, message, participant, self.since(start), fills, receiver, tuple(excepts)
        )

    def fills(self) -> tuple[tree.Fill, ...]:
        """`{ f = v, g.h = v }`"""
        opener = self.take()
        found: list[tree.Fill] = []
        while self.next != "}":
            if self.index == len(self.tokens) or not _is_name(self.next) or self.next in RESERVED:
                raise self.unexpected(Wanted.MEMBER, "}", related=(self._still_open(opener),))
            name = self.take()
            if self.next != "=":
                at = self.tokens[min(self.index, len(self.tokens) - 1)]
                raise self.error(problems.MemberWithoutValue(("=",), name, at), at)
            self.take()
            value = self.expression()
            found.append(tree.Fill(read_path(self.source, name), value, self.since(name.start)))
            if self.next in (",", ";"):
                self.take()
            elif self.next != "}":
                raise self.unexpected(Wanted.OPERATOR, ",", "}", related=(self._still_open(opener),))
        self.take()
        return tuple(found)

    def _check_content(self) -> None:
        """What is wrong where the grammar could not read a message and its braces. Raises Malformed."""
        is_last = self.index == len(self.tokens)
        start = self.tokens[-1].end if is_last else self.tokens[self.index].start
        text = self.source.text
        found = _CONTENT.match(text, start)
        if found is None or any(item.end == found.end() for item in self.tokens[self.index :]):
            return
        place = Span(self.source, self.tokens[-1].start if is_last else start, found.end())
        if found["kind"] and not found["message"]:
            raise Malformed(
                Diagnostic(problems.SendWithoutMessage((Wanted.MESSAGE,), found["kind"], "{"), place)
            )
        colon = _COLON.match(text, found.end())
        if colon is not None:
            at = Span(self.source, colon.end() - 1, colon.end())
            raise Malformed(Diagnostic(problems.MemberWithColon(), place, edits=(Edit(at, " ="),)))
        end = _UNCLOSED.match(text, found.end())
        if end is not None:
            at = Span(self.source, end.end(1), end.end(1))
            raise Malformed(Diagnostic(problems.ContentNotClosed(end[1]), place, edits=(Edit(at, " }"),)))

    # ---- expressions ---------------------------------------------------------------------------

    def expression(self, loosest: int = 1) -> tree.Expression:
        self.depth += 1
        if self.depth > DEEPEST + 1:
            raise self._too_deep(self.tokens[min(self.index, len(self.tokens) - 1)])
        made = self._operators(loosest)
        self.depth -= 1
        return made

    def _operators(self, loosest: int) -> tree.Expression:
        left = self.unary()
        negation = left if isinstance(left, tree.Unary) and left.operator == "!" else None
        while True:
            word = self.next
            operator = _LOGIC.get(word, word)
            binding = _BINDING.get(operator, 0)
            if binding < loosest or binding == 0:
                return left
            at = self.tokens[self.index]
            if negation is not None and binding > 2:
                raise self._negated(negation, at, binding)
            self.index += 1
            if binding <= 2:
                operands = [left, self.expression(binding + 1)]
                while _LOGIC.get(self.next, "") == operator:
                    self.index += 1
                    operands.append(self.expression(binding + 1))
                left = self.grown(
                    tree.Logic(operator, tuple(operands), operands[0].span.to(operands[-1].span)), *operands
                )
                continue
            right = self.expression(binding + 1)
            span = left.span.to(right.span)
            left = self.grown(tree.Binary(operator, left, right, self.span(at), span), left, right)
            if binding == 3 and self.next in _COMPARISON:
                raise self._chained(left, self.tokens[self.index])

    def unary(self) -> tree.Expression:
        signs: list[Token] = []
        while self.next in ("!", "not", "-", "+"):
            signs.append(self.take())
            if len(signs) > DEEPEST:
                raise self._too_deep(signs[-1])
        operand = self.value()
        for sign in reversed(signs):
            operator = "!" if sign == "not" else str(sign)
            operand = self.grown(
                tree.Unary(operator, operand, Span(self.source, sign.start, operand.span.end)), operand
            )
        return operand

    def value(self) -> tree.Expression:
        found = self.whole()
        while self.next == "[" and not isinstance(found, _HAVE_NO_ELEMENTS):
            opener = self.take()
            index = self.expression()
            self.need("]", opener)
            members: tuple[tree.Name, ...] = ()
            if self.next == "." and self.index + 1 < len(self.tokens):
                self.take()
                if not _is_name(self.next):
                    raise self.unexpected(Wanted.ELEMENT_MEMBER)
                members = read_path(self.source, self.take()).segments
            made = tree.Element(found, index, members, self.since(found.span.start))
            found = self.grown(made, found, index)
        return found

    def elements(self) -> tree.List:
        """`[a, b]`"""
        opener = self.take()
        elements: list[tree.Expression] = []
        if self.next != "]":
            elements.append(self.expression())
            while self.next == ",":
                self.take()
                elements.append(self.expression())
        if self.next != "]":
            raise self.unexpected(Wanted.OPERATOR, ",", "]", related=(self._still_open(opener),))
        self.take()
        return self.grown(tree.List(tuple(elements), self.since(opener.start)), *elements)

    def whole(self) -> tree.Expression:
        """A value without what stands in `[ ]` behind it."""
        if self.index == len(self.tokens):
            raise self.unexpected(Wanted.VALUE)
        first = self.tokens[self.index]
        initial = first[0]
        if initial.isdigit():
            return self.number(self.take())
        if initial == '"':
            self.index += 1
            return read_text(self.source, first)
        if first == "[":
            return self.elements()
        if first == "(":
            self.take()
            inner = self.expression()
            self.need(")", first)
            return self.grown(tree.Parenthesised(inner, self.since(first.start)), inner)
        if not _is_name(first) or first in ("and", "or", "else", "when"):
            raise self.unexpected(Wanted.VALUE)
        self.index += 1
        if first == "true" or first == "false":
            return tree.Truth(first == "true", self.span(first))
        path = read_path(self.source, first)
        if self.next != "(":
            return path
        opener = self.take()
        arguments: list[tree.Expression] = []
        if self.next != ")":
            arguments.append(self.expression())
            while self.next == ",":
                self.take()
                arguments.append(self.expression())
        if self.next != ")":
            raise self.unexpected(Wanted.OPERATOR, ",", ")", related=(self._still_open(opener),))
        self.take()
        return self.grown(tree.Call(path, tuple(arguments), self.since(first.start)), *arguments)

    def number(self, text: Token) -> tree.Number | tree.Duration:
        found = _NUMBER.fullmatch(text)
        if found is None:
            raise self.error(characters.TwoPointsInNumber(text), text)
        whole, fraction, unit = found[1], found[2] or "", found[3]
        if len(whole) > _LONGEST_NUMBER or len(fraction) > 100:
            raise self.error(characters.TooManyDigits(text), text)
        if unit:
            nanoseconds, rest = divmod(int(whole + fraction) * UNITS[unit], 10 ** len(fraction))
            if rest:
                raise self.error(characters.PartOfNanosecond(text), text)
            return tree.Duration(nanoseconds, self.span(text))
        if self.next in UNITS:
            following = self.tokens[self.index]
            span = Span(self.source, text.start, following.end)
            problem = characters.BlankBeforeUnit(text, following)
            raise Malformed(Diagnostic(problem, span, fix=f"{text}{following}"))
        return tree.Number(float(text) if fraction else int(whole), self.span(text))

    def grown(self, made: Made, *parts: tree.Expression) -> Made:
        """`made` of `parts`, with its height remembered and bounded."""
        height = 1 + max((self.heights.pop(id(part), 0) for part in parts), default=0)
        if height > DEEPEST:
            raise Malformed(self._deep(made.span))
        self.heights[id(made)] = height
        return made

    # ---- what can be wrong ---------------------------------------------------------------------

    def error(
        self,
        problem: Problem,
        at: Token,
        fix: str | None = None,
        related: tuple[Related, ...] = (),
        edits: tuple[Edit, ...] = (),
    ) -> Malformed:
        return Malformed(Diagnostic(problem, self.span(at), related, fix, edits=edits))

    def unexpected(self, *wanted: Wanted | str, related: tuple[Related, ...] = ()) -> Malformed:
        """Something else stands here than one of `wanted`, of which strings are words of the language."""
        if self.index == len(self.tokens):
            last = self.tokens[-1]
            return self.error(problems.UnexpectedInExpression(wanted, last, None), last, related=related)
        found = self.tokens[self.index]
        previous = self.tokens[self.index - 1] if self.index else None
        if previous is None:
            kind = problems.ReservedWord if found in RESERVED else problems.UnexpectedInExpression
            return self.error(kind(wanted, None, found), found, related=related)
        problem, fix = self._unexpected_after(previous, found, wanted)
        return self.error(problem, found, fix, related)

    def _unexpected_after(
        self, previous: Token, found: Token, wanted: tuple[Wanted | str, ...]
    ) -> tuple[Problem, str | None]:
        """What may be meant by the next token, and what to write instead."""
        following = self.tokens[self.index + 1] if self.index + 1 < len(self.tokens) else None
        if found == "=" and (following in ("<", ">") or previous in ("<", ">", "==", "!=")):
            return problems.ComparisonOfOthers(wanted, previous, found), None
        if previous == "after" and found[:1].isdigit():
            return problems.AfterWithoutParentheses(wanted, previous, found), None
        if found == "or" and previous == "]":
            return problems.ConditionOfOneEvent(wanted, previous, found), None
        if found in RESERVED:
            return problems.ReservedWord(wanted, previous, found), None
        if found == "-" and following is not None and is_hyphen(previous, found, following):
            return problems.HyphenInOperandName(wanted, previous, found, rest=following), "_"
        if found in UNITS and previous[0].isdigit():
            return problems.BlankBeforeUnitOfEvent(wanted, previous, found), None
        name = re.compile(r"\s+([A-Za-z_]\w*)").match(self.source.text, found.end)
        if found in BUILT_IN and name is not None:
            return problems.TypeBeforeName(wanted, previous, found, name=name[1]), None
        if found.lower() in _MEANT:
            return problems.OperatorOfOtherLanguages(wanted, previous, found), _MEANT[found.lower()]
        return problems.UnexpectedInExpression(wanted, previous, found), None

    def _still_open(self, opener: Token) -> Related:
        return Related(self.span(opener), f"this '{opener}' is still open")

    def _too_deep(self, at: Token) -> Malformed:
        return Malformed(self._deep(self.span(at)))

    def _deep(self, span: Span) -> Diagnostic:
        return Diagnostic(characters.ExpressionTooDeep(DEEPEST), span)

    def _negated(self, negation: tree.Unary, operator: Token, binding: int) -> Malformed:
        """Parentheses around a comparison are right however it is read: `(!a) == b` is `!(a == b)`."""
        inner = self.source.text[negation.operand.span.start : negation.operand.span.end]
        edits: tuple[Edit, ...] = ()
        if operator in _COMPARISON and not isinstance(negation.operand, tree.Unary):
            try:
                self.index += 1
                end = self.expression(binding + 1).span.end
            except Malformed:
                end = 0
            if end and self.next not in _COMPARISON:
                start = negation.operand.span.start
                opened = Edit(Span(self.source, start, start), "(")
                edits = (opened, Edit(Span(self.source, end, end), ")"))
        sign = Span(self.source, negation.span.start, negation.span.start + 1)
        problem = problems.NegatedComparison(inner, operator)
        return self.error(problem, operator, related=(Related(sign, "this '!'"),), edits=edits)

    def _chained(self, left: tree.Expression, operator: Token) -> Malformed:
        assert isinstance(left, tree.Binary)
        middle = left.right.span.text
        problem = problems.ChainedComparisons(left.span.text, middle, left.operator, operator)
        edits: tuple[Edit, ...] = ()
        if any({left.operator, operator} <= chain for chain in _CHAINS):
            edits = (Edit(Span(self.source, operator.start, operator.start), f"&& {middle} "),)
        return self.error(
            problem, operator, related=(Related(left.operator_span, "the first comparison"),), edits=edits
        )

    def _no_colon(self, verb: Token) -> Malformed:
        """`on work [c]`: a control line of its own, if it had a colon."""
        line = self.source.text[self.source.text.rfind("\n", 0, verb.start) + 1 : verb.start]
        if verb == "on" and line.rstrip().endswith(":") and self._is_last_event(self.index):
            return self._event_after(verb, self.tokens[self.index])
        complete = False
        while self.index < len(self.tokens):
            begins_operand = self.next == "(" or _is_name(self.next)
            if (complete and begins_operand) or not (begins_operand or self.next in _IN_TERMS):
                break
            complete = self.next not in ("(", ".", "|", "||")
            self.take()
        last = self.tokens[self.index - 1]
        found = self.tokens[self.index] if self.index < len(self.tokens) else None
        return self.error(problems.EntryWithoutColon(verb, last, found), last)

    def _no_from(self) -> Malformed:
        if self.index == len(self.tokens):
            return self.unexpected(Wanted.SENDER)
        found = self.tokens[self.index]
        if _is_name(found) and closest(found, ("from",)):
            return self.error(problems.MisspeltFrom(("from",), None, found), found, "from")
        return self.unexpected(Wanted.SENDER)

    def _if(self, word: Token) -> Malformed:
        """`if low` of other languages."""
        found = self._bare_condition(self.index).diagnostic
        if found.fix is None or found.span is None:
            return self.error(problems.ConditionWithIf(None), word)
        span = Span(self.source, word.start, found.span.end)
        bare = found.problem.condition if isinstance(found.problem, problems.BareCondition) else None
        return Malformed(Diagnostic(problems.ConditionWithIf(bare), span, fix=found.fix))

    def _bare_condition(self, start: int) -> Malformed:
        first = self.tokens[start]
        if start > 0 and self.tokens[start - 1] == "when" and self._is_last_event(start):
            return self._event_after(self.tokens[start - 1], first)
        for offset, word in enumerate(self.tokens[start:]):
            if word in ("/", "["):
                condition = self.tokens[start : start + offset]
                break
        else:
            condition = self.tokens[start:]
        if condition and (_is_name(first) or first in ("!", "(", "-") or first[0].isdigit()):
            if condition[-1] == "]":
                return self.error(problems.BracketMissingBefore(first), first, f"[{first}")
            last = condition[-1]
            span = Span(self.source, first.start, last.end)
            return Malformed(Diagnostic(problems.BareCondition(span.text), span, fix=f"[{span.text}]"))
        return self.error(problems.UnexpectedInExpression((Wanted.EVENT, "[", "/"), None, first), first)

    def _is_last_event(self, index: int) -> bool:
        """Whether a plain name ends the expression that the file declares as no value."""
        word = self.tokens[index]
        if index < len(self.tokens) - 1 or not _is_name(word) or "." in word or word in RESERVED:
            return False
        return re.search(rf"\b(?:var|let)\s+{re.escape(word)}\b", self.source.text) is None

    def _event_after(self, word: Token, event: Token) -> Malformed:
        """`when stop` or `on stop`, as other languages write the event `stop`."""
        span = Span(self.source, word.start, event.end)
        return Malformed(Diagnostic(problems.EventBehindWord(word, event), span, fix=str(event)))

    def _after_transition(self, has_actions: bool, has_condition: bool) -> Malformed:
        wanted = Wanted.END_OF_EVENTS
        if has_actions:
            wanted = Wanted.END_OF_ACTIONS
        elif has_condition:
            wanted = Wanted.END_OF_CONDITION
        verb = self._misspelt_verb()
        if verb is not None:
            previous, word = self.tokens[self.index - 1], self.tokens[self.index]
            problem = problems.UnexpectedInExpression((wanted,), previous, word, verb)
            return self.error(problem, word, verb)
        if wanted is Wanted.END_OF_EVENTS and self.next == "=":
            return self._assignment_without_slash()
        return self.unexpected(wanted)

    def _assignment_without_slash(self) -> Malformed:
        start = self.tokens[0].start
        slash = Edit(Span(self.source, start, start), "/ ")
        edits = (slash,) if self.index == 1 else ()
        return self.error(problems.AssignmentWithoutSlash(), self.tokens[self.index], edits=edits)

    def _misspelt_verb(self) -> str | None:
        """The verb for which the next token is misspelt, where it begins a line."""
        if self.index >= len(self.tokens):
            return None
        word = self.tokens[self.index]
        line = self.source.text.rfind("\n", 0, word.start) + 1
        if self.source.text[line : word.start].strip():
            return None
        verbs = BLOCKS["JunkControl"].words
        return None if word in verbs else surely(word, verbs)


def _is_name(text: str) -> bool:
    return text[:1].isalpha() or text[:1] == "_"


__all__ = ["Malformed", "read_duration", "read_expression", "read_path", "read_transition", "token"]
