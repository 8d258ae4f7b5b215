"""From the tokens of a liveness formula to its tree, by precedence and without recursion."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import field

from aseme_dsl.amola.liveness import Formula
from aseme_dsl.amola.operators import (
    BRACKETS,
    INFIX,
    INFIX_SIGNS,
    MISTAKEN,
    NUMBER,
    POSTFIX,
    USUAL,
    Operator,
    parts,
)
from aseme_dsl.diagnostics import Diagnostic, Edit, Problem, Related
from aseme_dsl.diagnostics.problems.syntax import formulas as problems
from aseme_dsl.diagnostics.problems.syntax.characters import (
    FormulaTooDeep,
    ReservedOperand,
    TooManyInstances,
)
from aseme_dsl.diagnostics.problems.syntax.entries import Signs, Wanted
from aseme_dsl.grammar.formulas.expression import read_arguments
from aseme_dsl.grammar.formulas.words import BUILT_IN_TYPES, RESERVED, Malformed, is_hyphen, is_name
from aseme_dsl.grammar.text.token import Token
from aseme_dsl.records import dataclass
from aseme_dsl.source import Source, Span

DEEPEST = 1000
"""How many brackets and postfix operators may stand one in the other."""

_POSTFIX = {parts(sign)[0]: (parts(sign), operator) for sign, operator in POSTFIX.items()}
"""The postfix operators by the first token of their signs, with all tokens."""

_CLOSES = {opening: closing[0] for opening, (_, closing) in BRACKETS.items()}

_USUAL = tuple((item.value, item.row.meaning) for item in USUAL)
_MEANT: dict[str, Signs] = {sign: ((meant.value, meant.row.meaning),) for sign, meant in MISTAKEN.items()} | {
    ">": (("[>", "one that cuts the other short"), (".", Operator.SEQUENCE.row.meaning)),
    "=": (),
}
"""The operators that are probably meant by other signs."""

_IN_EXPRESSIONS = ("*", "+", ".", "?")
_FORMULA_ONLY = frozenset((*INFIX_SIGNS, *_POSTFIX, "]", ";", "->")) - {*_IN_EXPRESSIONS}
"""What does not stand in the arguments of an activity."""


_NO_POSTFIX: tuple[tuple[str, ...], None] = ((), None)


@dataclass
class _Group:
    """What has been read in one pair of brackets.

    `levels` are the operands, with their heights, of each infix operator, the tightest first.
    """

    opener: Token | None
    levels: list[list[tuple[Formula, int]]] = field(default_factory=lambda: [[] for _ in INFIX])

    @property
    def operands(self) -> list[tuple[Formula, int]]:
        """Those of the tightest operator."""
        return self.levels[0]


def read_formula(source: Source, tokens: Sequence[Token], deepest: int = DEEPEST) -> Formula:
    """The formula that the tokens spell.

    Raises:
        Malformed: They spell none; with the first thing that is wrong (E101, E103).
    """
    return _Reader(source, tokens, deepest).read()


class _Reader:
    def __init__(self, source: Source, tokens: Sequence[Token], deepest: int) -> None:
        self.source = source
        self.tokens = tokens
        self.deepest = deepest
        self.groups = [_Group(None)]

    def read(self) -> Formula:
        tokens = self.tokens
        count = len(tokens)
        group = self.groups[0]
        operand_expected = True
        index = 0
        while index < count:
            token = tokens[index]
            if operand_expected:
                if token in _CLOSES:
                    if len(self.groups) > self.deepest:
                        raise self._too_deep(token)
                    group = _Group(token)
                    self.groups.append(group)
                elif is_name(token):
                    if token in RESERVED or token in BUILT_IN_TYPES:
                        raise self._error(ReservedOperand(token), token)
                    closing_at = self._end_of_arguments(index)
                    group.operands.append((self._named(index, closing_at), 1))
                    operand_expected = False
                    index = closing_at
                else:
                    raise self._no_operand(index)
                index += 1
                continue
            signs, postfix = _POSTFIX.get(token, _NO_POSTFIX)
            if postfix is not None and (len(signs) == 1 or self._stand_at(index, signs)):
                last = index + len(signs) - 1
                number = tokens[index + signs.index(NUMBER)] if postfix.row.counted else None
                self._wrap(group, postfix, tokens[last], number)
                index = last + 1
            elif (
                token == ")" or token == "]" or self._closes_bar(index, group)
            ) and group.opener is not None:
                if token != _CLOSES[group.opener]:
                    raise self._wrong_bracket(token, group.opener)
                self.groups.pop()
                formula = self._fold(group)
                index += 1
                closing = token
                if token == "|":
                    closing = tokens[index]
                    index += 1
                group_around = self.groups[-1]
                group_around.operands.append(self._bracketed(group.opener, formula, closing))
                group = group_around
            elif token in INFIX_SIGNS:
                self._infix(group, INFIX_SIGNS[token])
                operand_expected = True
                index += 1
            else:
                raise self._no_operator(index)
        if operand_expected:
            raise self._no_operand(count)
        if group.opener is not None:
            raise self._not_closed(group.opener)
        return self._fold(group)[0]

    # ---- arguments -----------------------------------------------------------------------------

    def _end_of_arguments(self, index: int) -> int:
        """Where the arguments of the name at `index` end, or `index` itself where it has none.

        They stand in parentheses behind it: `MoveTo(goal)`. What can only be a formula is none of them.
        """
        tokens = self.tokens
        opening = index + 1
        if opening >= len(tokens) or tokens[opening] != "(":
            return index
        depth = elements = 0
        for place in range(opening, len(tokens)):
            token, before = tokens[place], tokens[place - 1]
            depth += (token == "(") - (token == ")")
            if depth == 0:
                return place
            if (token == "[" and is_name(before)) or (token == "]" and elements):
                elements += 1 if token == "[" else -1
                continue
            if token in _FORMULA_ONLY or (before == "." and token == "(") or (before == ")" and token == "."):
                return index
            if before in ("*", "+") and (token in (")", ",", ".")):
                return index
        return index

    def _named(self, index: int, closing: int) -> Formula:
        token = self.tokens[index]
        if closing == index:
            return Formula(Operator.NAME, (), self._span(token), name=str(token))
        if closing == index + 2:
            span = self._to(token.end, self.tokens[closing])
            raise Malformed(Diagnostic(problems.EmptyArguments(token), span, edits=(Edit(span, ""),)))
        arguments = read_arguments(self.source, self.tokens[index + 1 : closing + 1])
        span = self._to(token.start, self.tokens[closing])
        return Formula(Operator.NAME, (), span, name=str(token), arguments=arguments)

    # ---- building ------------------------------------------------------------------------------

    def _span(self, token: Token) -> Span:
        return Span(self.source, token.start, token.end)

    def _to(self, start: int, token: Token) -> Span:
        return Span(self.source, start, token.end)

    def _height(self, height: int, token: Token) -> int:
        if height > self.deepest:
            raise self._too_deep(token)
        return height

    def _wrap(self, group: _Group, operator: Operator, last: Token, count: Token | None = None) -> None:
        operand, height = group.operands[-1]
        span = self._to(operand.span.start, last)
        number = int(count) if count is not None else 0
        formula = Formula(operator, (operand,), span, count=number)
        group.operands[-1] = (formula, self._height(height + 1, last))

    def _infix(self, group: _Group, operator: Operator) -> None:
        """Join the operands of all that binds more tightly than `operator`."""
        for level, tighter in enumerate(INFIX):
            if tighter is operator:
                return
            group.levels[level + 1].append(self._joined(tighter, group.levels[level]))
            group.levels[level] = []

    def _joined(self, operator: Operator, parts: list[tuple[Formula, int]]) -> tuple[Formula, int]:
        if len(parts) == 1:
            return parts[0]
        if operator.row.pairs:
            found, height = parts[0]
            for other, other_height in parts[1:]:
                found = Formula(operator, (found, other), found.span.to(other.span))
                height = max(height + 1, other_height)
            return found, height
        operands = tuple(formula for formula, _ in parts)
        formula = Formula(operator, operands, operands[0].span.to(operands[-1].span))
        return formula, max(height for _, height in parts)

    def _fold(self, group: _Group) -> tuple[Formula, int]:
        self._infix(group, INFIX[-1])
        found, height = self._joined(INFIX[-1], group.levels[-1])
        if height > self.deepest:
            raise self._too_deep(self.tokens[0])
        return found, height

    def _bracketed(self, opener: Token, inner: tuple[Formula, int], closing: Token) -> tuple[Formula, int]:
        formula, height = inner
        span = self._to(opener.start, closing)
        operator, _ = BRACKETS[opener]
        if operator is Operator.GROUP is formula.operator:  # several around one thing count as one
            return Formula(operator, formula.operands, span), height
        count = int(closing) if operator.row.counted else 0
        return Formula(operator, (formula,), span, count=count), self._height(height + 1, opener)

    def _stand_at(self, index: int, signs: Sequence[str]) -> bool:
        """Whether the tokens of a postfix operator stand at `index`, with a number that fits."""
        found = self.tokens[index : index + len(signs)]
        return (
            len(found) == len(signs)
            and all(
                (token.isdigit() if sign == NUMBER else token == sign)
                for token, sign in zip(found, signs, strict=True)
            )
            and self._fits(found[signs.index(NUMBER)])
        )

    def _closes_bar(self, index: int, group: _Group) -> bool:
        """Whether a `|` is the second of `|A~|3`: an operand never begins with a digit."""
        tokens = self.tokens
        return (
            tokens[index] == "|"
            and group.opener == "|"
            and index + 1 < len(tokens)
            and tokens[index + 1].isdigit()
            and self._fits(tokens[index + 1])
        )

    def _fits(self, count: Token) -> bool:
        if len(count) > 9:
            raise self._error(TooManyInstances(count), count)
        return True

    # ---- what can be wrong ---------------------------------------------------------------------

    def _error(
        self, problem: Problem, token: Token, related: tuple[Related, ...] = (), fix: str | None = None
    ) -> Malformed:
        return Malformed(Diagnostic(problem, self._span(token), related, fix))

    def _too_deep(self, token: Token) -> Malformed:
        return self._error(FormulaTooDeep(self.deepest), token)

    def _no_operand(self, index: int) -> Malformed:
        tokens = self.tokens
        previous = tokens[index - 1] if index else None
        wanted = (Wanted.ACTIVITY, "(", "[")
        if previous is None and not tokens:
            raise AssertionError("the grammar lets no formula be empty")
        if index == len(tokens):
            assert previous is not None
            at_end = problems.OptionAsInPatterns if previous == "?" else problems.UnexpectedInFormula
            return self._error(at_end(wanted, previous, None), previous)
        token = tokens[index]
        kind = problems.UnexpectedInFormula
        if previous == "?":
            kind = problems.OptionAsInPatterns
        elif token in INFIX_SIGNS and previous is not None and previous in INFIX_SIGNS:
            kind = problems.TwoOperators
        elif token in (")", "]") and previous in ("(", "["):
            kind = problems.EmptyBrackets
        elif token in _MEANT and previous is None:
            return self._error(problems.OperatorOfOthersFirst(wanted, None, token, _MEANT[token]), token)
        return self._error(kind(wanted, previous, token), token)

    def _no_operator(self, index: int) -> Malformed:
        token = self.tokens[index]
        previous = self.tokens[index - 1]
        if token in (")", "]"):
            return self._error(problems.NothingOpened(token), token)
        if token == "[" and self.tokens[index + 1 : index + 2] == [">"]:
            both = Span(self.source, token.start, self.tokens[index + 1].end)
            return Malformed(Diagnostic(problems.BlankInInterrupt(previous), both, fix="[>"))
        if token == "[":
            before = str(previous) if is_name(previous) else "A"
            problem = problems.OperatorBeforeBracket(previous, before, self._inside(index))
            return self._error(problem, token, fix=". [")
        if is_name(token) or token == "(":
            begins_formula = is_name(token) and "\n" in self.source.text[previous.end : token.start]
            return self._error(problems.OperatorMissing(previous, token, _USUAL, begins_formula), token)
        following = self.tokens[index + 1] if index + 1 < len(self.tokens) else None
        if token == "-" and following is not None and is_hyphen(previous, token, following):
            return self._error(problems.HyphenInOperand(previous, following), token, fix="_")
        meant = MISTAKEN.get(token)
        doubtful = meant is Operator.SEQUENCE and token != "->" and self._is_among_others(index)
        if token not in _MEANT or doubtful:
            return self._error(problems.NoOperator(token, _USUAL), token)
        fix = meant.value if meant is not None else None
        return self._error(problems.OperatorOfOthers(token, _MEANT[token]), token, fix=fix)

    def _is_among_others(self, index: int) -> bool:
        """Whether another operator than '.' stands in the same brackets: then this may stand for it, too."""
        for step in (1, -1):
            depth = 0
            place = index + step
            while 0 <= place < len(self.tokens) and depth >= 0:
                token = self.tokens[place]
                depth += step * ((token in ("(", "[")) - (token in (")", "]")))
                if depth == 0 and INFIX_SIGNS.get(token) not in (None, Operator.SEQUENCE, Operator.HOLE):
                    return True
                place += step
        return False

    def _inside(self, opening: int) -> str:
        """What stands in the brackets that open at `opening`, if it is short."""
        for index in range(opening + 1, min(opening + 8, len(self.tokens))):
            if self.tokens[index] == "]":
                return " ".join(self.tokens[opening + 1 : index])
        return "B"

    def _wrong_bracket(self, token: Token, opener: Token) -> Malformed:
        if opener == "|":
            return self._error(problems.BarsWithoutNumber(token), opener)
        problem = problems.UnexpectedInFormula((_CLOSES[opener],), None, token)
        return self._error(problem, token, self._still_open(opener))

    def _not_closed(self, opener: Token) -> Malformed:
        last = self.tokens[-1]
        if opener == "|":
            return self._error(problems.BarsWithoutNumber(None), opener)
        problem = problems.UnexpectedInFormula((_CLOSES[opener],), last, None)
        return self._error(problem, last, self._still_open(opener))

    def _still_open(self, opener: Token) -> tuple[Related, ...]:
        return (Related(self._span(opener), f"this '{opener}' is still open"),)
