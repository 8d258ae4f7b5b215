"""ECMAScript: the conditions and values of a machine, as far as the language can say them.

Nothing is evaluated. What is not understood is Untranslatable, with the reason.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping

from aseme_dsl.interop.emf.expressions import Untranslatable
from aseme_dsl.records import dataclass

LONGEST = 4_000
"""How many characters an expression may have."""
DEEPEST = 40
"""How deep parentheses and operators may be nested."""

_TOKEN = re.compile(
    r"\s*(?:(?P<number>(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)(?![\w$])"
    r"|(?P<text>'(?:[^'\\\n]|\\['\"\\])*'|\"(?:[^\"\\\n]|\\['\"\\])*\")"
    r"|(?P<name>[A-Za-z_$][\w$]*)"
    r"|(?P<sign>===|!==|==|!=|<=|>=|&&|\|\||\+\+|--|\+=|-=|\*=|[-+*/%<>!()?:,.=;\[\]{}]))",
    re.ASCII,
)
_LEVELS: tuple[tuple[str, ...], ...] = (
    ("||", "or"),
    ("&&", "and"),
    ("==", "!=", "===", "!=="),
    ("<", "<=", ">", ">="),
    ("+", "-"),
    ("*", "/", "%"),
)
_WORDS = {"===": "==", "!==": "!=", "or": "||", "and": "&&"}
_TRUTH = {"true": "true", "false": "false", "True": "true", "False": "false"}


@dataclass(frozen=True, slots=True)
class Said:
    """An expression of the language: its text, its type, and how tightly it binds (9: as tight as a name)."""

    text: str
    type: str
    level: int = 9

    def inside(self, level: int) -> str:
        """The text as an operand of an operator of a level."""
        return self.text if self.level > level else f"({self.text})"


NUMBERS = ("int", "double")
Variables = Mapping[str, tuple[str, str]]
"""The name in the language and the type of each variable."""


def value(text: str, variables: Variables, states: Callable[[str], str | None]) -> Said:
    """An expression: `variables` have types, `states` gives the name of a state by its id.

    Raises:
        Untranslatable: it is not one that the language has.
    """
    reader = _Reader(text, variables, states)
    found = reader.conditional()
    reader.end()
    return found


def condition(text: str, variables: Variables, states: Callable[[str], str | None]) -> str:
    """An expression as a condition: a number holds if it is not zero. Raises Untranslatable."""
    return _truth(value(text, variables, states)).text


def assignments(script: str) -> tuple[tuple[str, str], ...]:
    """The assignments that a script consists of: a variable, and the text of its value.

    Raises:
        Untranslatable: something else stands in it.
    """
    found: list[tuple[str, str]] = []
    for statement in _statements(script):
        plain = statement.strip()
        if not plain:
            continue
        read = re.fullmatch(r"([A-Za-z_$][\w$]*)\s*([-+*]?=)(?!=)\s*(.+)", plain, re.ASCII)
        step = re.fullmatch(r"(?:([A-Za-z_$][\w$]*)\s*(\+\+|--))|(?:(\+\+|--)\s*([A-Za-z_$][\w$]*))", plain)
        if step is not None:
            name, sign = step[1] or step[4], (step[2] or step[3])[0]
            found.append((name, f"{name} {sign} 1"))
        elif read is not None and read[2] == "=":
            found.append((read[1], read[3]))
        elif read is not None:
            found.append((read[1], f"{read[1]} {read[2][0]} ({read[3]})"))
        else:
            raise Untranslatable("a script of which not all is an assignment")
    return tuple(found)


_PIECE = re.compile(
    r"(?P<comment>//[^\n]*|/\*.*?\*/)|(?P<end>[;\n])"
    r"|'(?:[^'\\\n]|\\.)*'|\"(?:[^\"\\\n]|\\.)*\"|[^;\n'\"/]+|.",
    re.DOTALL,
)


def _statements(script: str) -> Iterator[str]:
    """What `;` and the ends of lines separate, without comments; both may be in quotes."""
    statement = ""
    for piece in _PIECE.finditer(script):
        if piece["end"] is not None:
            yield statement
            statement = ""
        else:
            statement += " " if piece["comment"] is not None else piece[0]
    yield statement


class _Reader:
    def __init__(self, text: str, variables: Variables, states: Callable[[str], str | None]) -> None:
        if len(text) > LONGEST:
            raise Untranslatable(f"an expression of more than {LONGEST} characters")
        self.tokens: list[tuple[str, str]] = []
        at = 0
        rest = text.rstrip()
        while at < len(rest):
            read = _TOKEN.match(rest, at)
            if read is None:
                raise Untranslatable(f"`{rest[at:].strip()[:1]}` is not an operator of the language")
            self.tokens.append((read.lastgroup or "", read[read.lastgroup or 0]))
            at = read.end()
        self.at = 0
        self.depth = 0
        self.variables = variables
        self.states = states

    @property
    def next(self) -> str:
        return self.tokens[self.at][1] if self.at < len(self.tokens) else ""

    def take(self) -> tuple[str, str]:
        if self.at >= len(self.tokens):
            raise Untranslatable("the expression is not complete")
        self.at += 1
        return self.tokens[self.at - 1]

    def need(self, sign: str) -> None:
        if self.next != sign:
            raise Untranslatable(f"`{sign}` is missing")
        self.at += 1

    def end(self) -> None:
        if self.next:
            raise Untranslatable(f"`{self.next[:40]}` is not expected there")

    def conditional(self) -> Said:
        self.depth += 1
        if self.depth > DEEPEST:
            raise Untranslatable(f"an expression of more than {DEEPEST} levels")
        found = self.operation(0)
        if self.next == "?":
            self.at += 1
            yes = self.conditional()
            self.need(":")
            no = self.conditional()
            kind = _same(yes, no, "?")
            found = Said(f"{_truth(found).inside(0)} ? {yes.inside(0)} : {no.inside(0)}", kind, 0)
        self.depth -= 1
        return found

    def operation(self, level: int) -> Said:
        if level == len(_LEVELS):
            return self.single()
        found = self.operation(level + 1)
        while self.next in _LEVELS[level]:
            sign = _WORDS.get(self.next, self.next)
            self.at += 1
            found = _operation(sign, found, self.operation(level + 1), level + 1)
        return found

    def single(self) -> Said:
        kind, word = self.take()
        self.depth += 1
        if self.depth > DEEPEST:
            raise Untranslatable(f"an expression of more than {DEEPEST} levels")
        found = self.one(kind, word)
        self.depth -= 1
        return found

    def one(self, kind: str, word: str) -> Said:
        if word in ("!", "not"):
            return Said(f"!{_truth(self.single()).inside(7)}", "bool", 8)
        if word in ("-", "+"):
            inner = self.single()
            _number(inner, word)
            return Said(f"-{inner.inside(8)}", inner.type, 8) if word == "-" else inner
        if word == "(":
            found = self.conditional()
            self.need(")")
            return found
        if kind == "number":
            whole = word.isdecimal() and len(word) < 19
            if not whole and not re.fullmatch(r"[0-9]+\.[0-9]+", word):
                word = repr(float(word))
                if not re.fullmatch(r"[0-9]+\.[0-9]+", word):
                    raise Untranslatable(f"the number {word}")
            return Said(str(int(word)) if whole else word, "int" if whole else "double")
        if kind == "text":
            plain = re.sub(r"\\(.)", r"\1", word[1:-1])
            if not plain.isprintable():
                raise Untranslatable("a text with what cannot be printed")
            quoted = plain.replace("\\", "\\\\").replace('"', '\\"')
            return Said(f'"{quoted}"', "string")
        if kind == "name":
            return self.named(word)
        raise Untranslatable(f"`{word}` is not expected there")

    def named(self, word: str) -> Said:
        if word in _TRUTH:
            return Said(_TRUTH[word], "bool")
        if word == "In" and self.next == "(":
            self.at += 1
            kind, state = self.take()
            self.need(")")
            name = self.states(state[1:-1]) if kind == "text" else None
            if name is None:
                raise Untranslatable(
                    f"`In` of {state[:40]}: only states that stand in the text can be asked about"
                )
            return Said(f"in({name})", "bool")
        if self.next in (".", "(", "["):
            raise Untranslatable(f"`{word[:40]}{self.next}…`: members and functions are not known here")
        if word not in self.variables:
            raise Untranslatable(f"nothing declares `{word[:40]}`")
        return Said(*self.variables[word])


def _truth(found: Said) -> Said:
    if found.type == "bool":
        return found
    if found.type in NUMBERS:
        return Said(f"{found.inside(4)} != 0", "bool", 3)
    raise Untranslatable(f"a {found.type} as a condition")


def _number(found: Said, sign: str) -> None:
    if found.type not in NUMBERS:
        raise Untranslatable(f"`{sign}` of a {found.type}")


def _same(left: Said, right: Said, sign: str) -> str:
    kinds = {left.type, right.type}
    if kinds <= set(NUMBERS):
        return "double" if "double" in kinds else "int"
    if len(kinds) > 1:
        raise Untranslatable(f"`{sign}` between a {left.type} and a {right.type}")
    return left.type


def _operation(sign: str, left: Said, right: Said, level: int) -> Said:
    """Two operands of an operator; comparisons do not chain in the language."""
    if sign in ("||", "&&"):
        left, right = _truth(left), _truth(right)
        return Said(f"{left.inside(level - 1)} {sign} {right.inside(level)}", "bool", level)
    if sign in ("==", "!="):
        _same(left, right, sign)
        return Said(f"{left.inside(4)} {sign} {right.inside(4)}", "bool", 3)
    _number(left, sign)
    _number(right, sign)
    kind = _same(left, right, sign)
    if sign in ("<", "<=", ">", ">="):
        return Said(f"{left.inside(4)} {sign} {right.inside(4)}", "bool", 3)
    if sign == "%":
        raise Untranslatable("`%`: of a negative number it gives another remainder here")
    if sign == "/":
        return Said(f"{left.inside(level - 1)} / {right.inside(level)}", "double", level)
    return Said(f"{left.inside(level - 1)} {sign} {right.inside(level)}", kind, level)


__all__ = ["NUMBERS", "Said", "Untranslatable", "Variables", "assignments", "condition", "value"]
