"""Where which words of the language are keywords: the grammar as contexts, for engines that only see lines.

A context has phrases: runs of tokens of which each has a kind. A phrase may enter another context:

- the body of a block, from its `{` to its `}`, has the entries of the block;
- what follows the beginning of an entry has the phrases of that entry, each possible anywhere in it, and ends
  where none of them is possible or another entry begins;
- a list of tokens (an expression, a formula) ends where the terminal of the grammar does not match.

So a word is a keyword where the grammar has it as one, and a name where it has a name.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import field, replace
from enum import Enum, auto

from aseme_dsl.amola.operators import INFIX, NUMBER, POSTFIX, Operator, parts
from aseme_dsl.grammar.formulas.words import BUILT_IN_TYPES
from aseme_dsl.grammar.layout.rules import EXPRESSIONS, FORMULAS
from aseme_dsl.grammar.syntax.shape import (
    Choice,
    Repeated,
    Series,
    Shape,
    Terminal,
    first,
    grammar,
    may_be_empty,
)
from aseme_dsl.records import dataclass


class Kind(Enum):
    """What a token is to its reader."""

    DECLARATION = auto()  # the word with which a declaration or an entry begins
    CLAUSE = auto()  # any other word of the grammar
    CHOICE = auto()  # one of several words: a kind, a type, a flag
    TRUTH = auto()
    LOGIC = auto()  # and, or, not
    BUILT_IN = auto()  # a type of the language
    BLOCK = auto()  # the name that a block declares
    NAME = auto()  # the name that an entry declares
    TYPE = auto()
    CALL = auto()
    REFERENCE = auto()
    TEXT = auto()
    NUMBER = auto()
    OPERATOR = auto()
    PUNCTUATION = auto()


KEYWORDS = (Kind.DECLARATION, Kind.CLAUSE, Kind.CHOICE, Kind.TRUTH, Kind.LOGIC)
"""The kinds of words that cannot be names."""


@dataclass(frozen=True, slots=True)
class Piece:
    """One token of a phrase: the first pattern that matches gives its kind."""

    options: tuple[tuple[str, Kind], ...]
    optional: bool = False
    words: tuple[tuple[Kind, str], ...] = field(default=(), compare=False)
    """The words of the language among what it matches."""

    @property
    def pattern(self) -> str:
        """Matches if one of the options matches."""
        return either(pattern for pattern, _ in self.options)

    @property
    def is_word(self) -> bool:
        """Whether it is always a word of the language, independent of the following token."""
        return all(kind in KEYWORDS for _, kind in self.options)

    @property
    def is_sign(self) -> bool:
        """Whether it is an operator or a punctuation mark."""
        return all(kind in (Kind.OPERATOR, Kind.PUNCTUATION) for _, kind in self.options)


@dataclass(frozen=True, slots=True)
class Phrase:
    """A sequence of tokens; the context `enters`, if any, applies to the text after it."""

    pieces: tuple[Piece, ...]
    enters: str = ""
    following: tuple[str, ...] = ()
    """Patterns of what must follow the first token for an entry to begin; none if all may."""

    @property
    def start(self) -> str:
        """Matches where the phrase begins, with one token to look ahead."""
        head = f"(?:{self.pieces[0].pattern})"
        if not self.following:
            return head
        after = either([*self.following, *([r"$|//|/\*"] if self.pieces[0].is_word else [])])
        return rf"{head}(?=\s*(?:{after}))"

    @property
    def clause(self) -> str:
        """Matches its first two tokens."""
        return r"\s*".join(enclosed(piece.pattern) for piece in self.pieces[:2])


class Tokens(Enum):
    """The languages of token lists."""

    EXPRESSION = auto()
    FORMULA = auto()
    WORDS = auto()


@dataclass(frozen=True, slots=True)
class Context:
    """A part of the text in which the same phrases are possible."""

    name: str
    phrases: tuple[Phrase, ...]
    closed: bool = False
    """The body of a block: from its brace to the closing one. (The file is open and has no end.)"""
    starts: tuple[Phrase, ...] | None = None
    """An entry: ends where one of these begins, or none of its phrases does, or after a body."""
    tokens: tuple[Tokens, str] | None = None
    """Tokens that stand in it, and the terminal that matches each."""

    @property
    def is_body(self) -> bool:
        """Whether it is a body, or the file."""
        return self.starts is None and self.tokens is None

    @property
    def has_body(self) -> bool:
        """Whether it is an entry that may have a body."""
        return any(phrase.pieces[0].pattern == r"\{" for phrase in self.phrases)

    def end(self) -> str | None:
        """Matches, without a width, where an entry or a list of tokens ends; None for a body."""
        if self.closed or self.is_body:
            return None
        going_on = [r"\s", "//", r"/\*", *dict.fromkeys(p.pieces[0].pattern for p in self.phrases)]
        if self.tokens is not None:
            going_on.append(self.tokens[1])
        over = f"(?!{either(going_on)})(?=\\S)"
        words = [start.start for start in self.starts or () if start.pieces[0].is_word]
        names = [start.start for start in self.starts or () if not start.pieces[0].is_word]
        clauses = [phrase.clause for phrase in self.phrases if phrase.pieces[0].is_word]
        if names and clauses:  # a clause is not a name
            names = [f"(?!{either(clauses)})(?:{either(names)})"]
        others = [f"(?={either([*words, *names])})"] if words or names else []
        return either([*([r"(?<=\})"] if self.has_body else []), *others, over])


FILE = "File"

EXPRESSION_WORDS: dict[str, str] = {
    "else": r"",
    "when": r"",
    "after": r"(?=\s*\()",
    "weight": r"(?=\s+[0-9])",
    "ignores": r"(?=\s+[A-Za-z_])",
    "send": r"(?=\s+[A-Za-z_])",
    "raise": r"(?=\s+[A-Za-z_])",
    "from": r"(?=\s+(?!(?:and|or)\b)[A-Za-z_])",
    "to": r"(?=\s+(?!(?:and|or)\b)[A-Za-z_])",
    "reply_by": r"(?=\s+[0-9A-Za-z_(])",
    "one": r"(?=\s+(?!(?:and|or|except)\b)[A-Za-z_])",
    "except": r"(?=\s+[A-Za-z_])",
    "lost": r"(?=\s+(?!(?:and|or)\b)[A-Za-z_])",
    "read_messages": r"(?!\s*\()",
    "write_messages": r"(?=\s*\.)",
}
"""The words of transition expressions, which transition.py reads, and what must follow."""

CONTENT = "content of a message"
"""The context between the braces of a message in an expression."""

_NAME = r"[A-Za-z_][A-Za-z0-9_]*"
_COMMON: tuple[tuple[str, Kind], ...] = (
    (r'"(?:[^"\\\n]|\\.)*"', Kind.TEXT),
    (r"[0-9]+(?:\.[0-9]+)*[A-Za-z]*\b", Kind.NUMBER),
)

_BLOCKS = "liveness|activities|modules|sag|suc"
"""The blocks that have no name: they follow where the brace of a `control` is missing."""

_WITH_CONTENT = tuple(
    Phrase(
        (
            Piece(((rf"{word}\b(?=(?:{after})\s*\{{)", kind),)),
            *parts,
            Piece(((r"\{", Kind.PUNCTUATION),)),
        ),
        CONTENT,
    )
    for word, kind, after, parts in (
        ("send", Kind.CLAUSE, rf"\s+{_NAME}\s+{_NAME}", (Piece(((_NAME, Kind.REFERENCE),)),) * 2),
        (
            "write_messages",
            Kind.CLAUSE,
            rf"(?:\s*\.\s*{_NAME})+",
            (Piece(((rf"(?:\.\s*{_NAME}\s*)+", Kind.REFERENCE),)),),
        ),
        (rf"(?!(?:{_BLOCKS})\b){_NAME}(?:\s*\.\s*{_NAME})*", Kind.REFERENCE, "", ()),
    )
)
"""What brings the content of a message in braces: `send inform Done { by = 1 }`, `Order { id = 7 }`."""

_ANSWER = Phrase(
    (
        Piece(((rf"{_NAME}\b(?=\s+{_NAME}\s*\{{)", Kind.REFERENCE),)),
        Piece(((_NAME, Kind.REFERENCE),)),
        Piece(((r"\{", Kind.PUNCTUATION),)),
    ),
    CONTENT,
)
"""What a busy participant answers: `refuse Job { reason = "later" }`, without `send`."""


def _formula_operators() -> str:
    """The operators of formulas, and those of other languages that the parser explains.

    Brackets, and holes, are not coloured as operators.
    """
    infix = (operator.value for operator in Operator if operator in INFIX and operator is not Operator.HOLE)
    postfix = (part for sign in POSTFIX for part in parts(sign) if part not in ("[", NUMBER, "]"))
    signs = (*infix, *postfix, "&&", "->", "&")
    several = [sign for sign in signs if len(sign) > 1 and sign.isascii()]
    characters = dict.fromkeys("".join(sign for sign in signs if sign not in several))
    return "|".join(
        (
            *(re.escape(sign) for sign in sorted(several, key=lambda sign: sign[0] == "[")),
            f"[{''.join(re.escape(one) for one in sorted(characters, key=str.isascii, reverse=True))}]",
        )
    )


TOKENS: dict[Tokens, tuple[tuple[str, Kind], ...]] = {
    Tokens.EXPRESSION: (
        *_COMMON,
        (r"(?:true|false)\b(?!\s*\.)", Kind.TRUTH),
        (r"(?:and|or|not)\b", Kind.LOGIC),
        *((rf"{word}\b{after}", Kind.CLAUSE) for word, after in EXPRESSION_WORDS.items()),
        (rf"{_NAME}(?=\s*\()", Kind.CALL),
        (rf"{_NAME}(?:[ \t]*\.[ \t]*{_NAME})*", Kind.REFERENCE),
        (r"&&|\|\||[-+*<>=!]=|->|\.\.|[-+*/%<>=!?#@~|&^]", Kind.OPERATOR),
        (r"[^\s\w{}]", Kind.PUNCTUATION),
    ),
    Tokens.FORMULA: (
        *_COMMON,
        (_NAME, Kind.REFERENCE),
        (r"[0-9]\w*", Kind.NUMBER),
        (_formula_operators(), Kind.OPERATOR),
        (r"[^\s\w{}]", Kind.PUNCTUATION),
    ),
    Tokens.WORDS: (
        *_COMMON,
        (rf"{_NAME}(?:[ \t]*\.[ \t]*{_NAME})*", Kind.REFERENCE),
        (r"&&|\|\||[-+*<>=!]=|->|\.\.|[-+*/%<>=!?#@~|&^]", Kind.OPERATOR),
        (r"[^\s\w{}]", Kind.PUNCTUATION),
    ),
}
"""The tokens of a list, by its language, in the order in which they are tried."""


def either(patterns: Iterator[str] | Sequence[str]) -> str:
    """A pattern that matches what one of `patterns` matches."""
    return "|".join(enclosed(pattern) for pattern in patterns)


def enclosed(pattern: str) -> str:
    """The pattern as a part of another one."""
    if pattern.startswith("(?x)"):
        return f"(?x:{pattern[4:]})"
    return f"(?:{pattern})" if "|" in pattern else pattern


def _list(name: str, terminal: Terminal) -> Context:
    """A list of tokens. In an expression, braces are the content of a message."""
    language = _language(terminal)
    phrases = _WITH_CONTENT if language is Tokens.EXPRESSION else ()
    if name == "BusyToken":
        phrases = (_ANSWER,)
    return Context(name, phrases, False, (), (language, terminal.pattern))


def outline() -> tuple[Context, ...]:
    """The contexts of the language, the file first."""
    found = _Outline()
    found.body(FILE, grammar().items, closed=False)
    content = Context(CONTENT, _WITH_CONTENT[-1:], True, None, (Tokens.EXPRESSION, r"[^\s{}]"))
    found.contexts[CONTENT] = content
    return tuple(found.contexts.values())


@dataclass
class _Outline:
    contexts: dict[str, Context] = field(default_factory=dict)

    def body(self, name: str, items: Sequence[Shape], closed: bool) -> None:
        """Note the context of a body, and those of its entries."""
        if name in self.contexts:
            return
        self.contexts[name] = Context(name, (), closed)  # keeps its place
        entries = [entry for item in items for entry in _entries(item)]
        words = [entry for entry in entries if isinstance(entry, Terminal)]
        assert len(words) < 2, name
        series = [entry for entry in entries if isinstance(entry, Series)]
        starts = tuple(dict.fromkeys(_start(entry) for entry in series))
        phrases = [phrase for entry in series for phrase in self.entry(name, entry, starts)]
        tokens = (_language(words[0]), words[0].pattern) if words else None
        self.contexts[name] = Context(name, tuple(phrases), closed, None, tokens)

    def entry(self, body: str, entry: Series, starts: tuple[Phrase, ...]) -> Iterator[Phrase]:
        """The phrases with which an entry begins; what may follow them becomes a context."""
        if _is(entry.items[0], r"\{"):
            phrases, _ = self.inner(entry.rule, entry.items)
            yield from phrases
            return
        for variant in _variants(entry):
            pieces, rest = _phrase(variant, True, _has_body(entry))
            following = _start(Series(tuple(variant), entry.rule)).following
            if not rest:
                yield Phrase(pieces, "", following)
                continue
            lists = isinstance(rest[0], Repeated) and _is_list(rest[0]) and len(rest) == 1
            name = entry.rule if lists else f"{entry.rule} in {body}"
            if name not in self.contexts:
                self.contexts[name] = Context(name, ())
                inner, tokens = self.inner(entry.rule, rest)
                tails = [tail for count in range(1, len(pieces)) for tail in _sure(pieces[count:])]
                if lists:
                    assert isinstance(rest[0], Repeated) and isinstance(rest[0].item, Terminal)
                    self.contexts[name] = _list(name, rest[0].item)
                else:
                    heads = dict.fromkeys(sorted([*inner, *tails], key=_unsure))
                    self.contexts[name] = Context(name, tuple(heads), False, starts, tokens)
            yield Phrase(pieces, name, following)

    def inner(self, rule: str, items: Sequence[Shape]) -> tuple[list[Phrase], tuple[Tokens, str] | None]:
        """The phrases that may follow the beginning of an entry, and its token list."""
        phrases: list[Phrase] = []
        tokens: tuple[Tokens, str] | None = None
        todo = list(items)
        while todo:
            item = todo.pop(0)
            if isinstance(item, Series):
                todo[:0] = item.items
            elif _is(item, r"\{"):
                end = _closing(todo)
                name = f"body of {rule}"
                self.body(name, todo[:end], closed=True)
                phrases.append(Phrase((Piece(((r"\{", Kind.PUNCTUATION),)),), name))
                del todo[: end + 1]
            elif isinstance(item, Repeated) and _is_list(item):
                assert isinstance(item.item, Terminal)
                tokens = (_language(item.item), item.item.pattern)
            elif isinstance(item, Choice) and not _options(item):
                for option in item.options:
                    found, inside = self.inner(rule, [option])
                    phrases += found
                    tokens = tokens or inside
            elif isinstance(item, Repeated) and not _options(item):
                parts: list[Shape] = [item.item]
                if item.separator is not None:
                    parts.append(Series((item.separator, item.item), ""))
                for part in parts:
                    found, inside = self.inner(rule, [part])
                    phrases += found
                    tokens = tokens or inside
            else:
                pieces, rest = _phrase([item, *todo], False, False)
                todo = list(rest)
                enters = ""
                if todo and isinstance(todo[0], Repeated) and _is_list(todo[0]):
                    terminal = todo.pop(0).item  # type: ignore[union-attr]
                    assert isinstance(terminal, Terminal)
                    enters = terminal.rule
                    self.contexts[enters] = _list(enters, terminal)
                phrases += _sure(pieces, enters)
                phrases += _ends(pieces, enters)
        return phrases, tokens


def _sure(pieces: tuple[Piece, ...], enters: str = "") -> list[Phrase]:
    """The phrase, and what is left of it without what is optional at its beginning: none of them is empty."""
    found = [Phrase((replace(pieces[0], optional=False), *pieces[1:]), enters)]
    if pieces[0].optional and len(pieces) > 1:
        found += _sure(pieces[1:], enters)
    return found


def _ends(pieces: tuple[Piece, ...], enters: str) -> list[Phrase]:
    """What a line may have of a phrase that is broken: its ends that do not begin with a name."""
    ends = (pieces[count:] for count in range(1, len(pieces)))
    return [end for rest in ends if rest[0].is_sign or rest[0].is_word for end in _sure(rest, enters)]


def _unsure(phrase: Phrase) -> int:
    """Phrases that begin with a word come first, those that begin with a name last; longer ones first."""
    head = phrase.pieces[0]
    kinds = {kind for _, kind in head.options}
    if head.is_word:
        return -len(phrase.pieces)
    if kinds <= {Kind.PUNCTUATION, Kind.OPERATOR, Kind.TEXT, Kind.NUMBER}:
        return 100 - len(phrase.pieces)
    return 200 - len(phrase.pieces)


def _entries(shape: Shape) -> Iterator[Series | Terminal]:
    if isinstance(shape, Repeated):
        yield from _entries(shape.item)
    elif isinstance(shape, Choice):
        for option in shape.options:
            yield from _entries(option)
    elif isinstance(shape, Series) and len(shape.items) == 1 and not isinstance(shape.items[0], Terminal):
        yield from _entries(shape.items[0])
    else:
        yield shape


def _variants(entry: Series) -> list[list[Shape]]:
    """An entry that begins with something optional, with it and without it."""
    head = entry.items[0]
    if isinstance(head, Repeated) and not head.many:
        return [[head.item, *entry.items[1:]], [*entry.items[1:]]]
    return [[*entry.items]]


def _start(entry: Series) -> Phrase:
    """The first token of an entry, and what follows it."""
    heads = list(dict.fromkeys(first(entry)))
    second: list[str] = []
    for variant in _variants(entry):
        rest = Series(tuple(_without_first(variant)), "")
        if may_be_empty(rest):
            second = []
            break
        second += [terminal.pattern for terminal in first(rest)]
    options = tuple(option for head in heads for option in _piece(head, True, False).options)
    return Phrase((Piece(options),), "", tuple(dict.fromkeys(second)))


def _without_first(items: Sequence[Shape]) -> list[Shape]:
    head, *rest = items
    if isinstance(head, Terminal):
        return rest
    if isinstance(head, Series):
        return [*_without_first(head.items), *rest]
    if isinstance(head, Choice):
        remaining = [Series(tuple(_without_first([option])), "") for option in head.options]
        return [*([Choice(tuple(remaining))] if any(part.items for part in remaining) else []), *rest]
    again = Repeated(
        Series((head.separator, head.item), "") if head.separator else head.item, False, head.many, None
    )
    return [*_without_first([head.item]), *([again] if head.many else []), *rest]


def _is(item: Shape, pattern: str) -> bool:
    return isinstance(item, Terminal) and item.pattern == pattern


def _closing(items: Sequence[Shape]) -> int:
    for index, item in enumerate(items):
        if _is(item, r"\}"):
            return index
    raise NotImplementedError("a block without a closing brace")


def _has_body(entry: Series) -> bool:
    return any(_is(item, r"\{") for item in entry.items)


def _is_list(item: Repeated) -> bool:
    return isinstance(item.item, Terminal) and item.many and item.separator is None and not item.item.words


def _language(terminal: Terminal) -> Tokens:
    if terminal.rule in FORMULAS:
        return Tokens.FORMULA
    if terminal.rule in EXPRESSIONS:
        return Tokens.EXPRESSION
    return Tokens.WORDS


def _options(shape: Shape) -> tuple[Terminal, ...]:
    """The terminals of a shape that is one token; none if it is not."""
    if isinstance(shape, Terminal):
        return (shape,)
    if isinstance(shape, Series) and len(shape.items) == 1:
        return _options(shape.items[0])
    if isinstance(shape, Choice):
        found = [_options(option) for option in shape.options]
        return tuple(terminal for options in found for terminal in options) if all(found) else ()
    if isinstance(shape, Repeated) and not shape.many:
        return _options(shape.item)
    return ()


def _phrase(items: Sequence[Shape], begins: bool, block: bool) -> tuple[tuple[Piece, ...], tuple[Shape, ...]]:
    """The tokens that follow one another from the first item on, and what is left."""
    pieces: list[Piece] = []
    todo = list(items)
    while todo:
        item = todo[0]
        leads = begins and not pieces
        if pieces and _is(item, r"\{"):
            break
        if _options(item):
            made = [_piece(terminal, leads, block) for terminal in _options(item)]
            options = tuple(dict.fromkeys(option for piece in made for option in piece.options))
            optional = isinstance(item, Repeated) and not item.at_least_one
            words = tuple(word for piece in made for word in piece.words)
            pieces.append(Piece(options, optional, words))
            del todo[0]
        elif isinstance(item, Series):
            todo[:1] = item.items
        elif isinstance(item, Repeated) and item.at_least_one and not _is_list(item):
            again = Series((item.separator, item.item), "") if item.separator else item.item
            todo[:1] = [item.item, Repeated(again, False, True, None)]
        else:
            break
    return tuple(pieces), tuple(todo)


def _piece(terminal: Terminal, leads: bool, block: bool) -> Piece:
    pattern = terminal.pattern
    if terminal.words:
        kind = Kind.DECLARATION if leads else Kind.CHOICE if terminal.rule else Kind.CLAUSE
        words = tuple((kind, word) for word in terminal.words)
        if not terminal.rule or not re.fullmatch(pattern, "1"):
            return Piece(((pattern, kind),), words=words)
        return Piece(((rf"(?:{'|'.join(terminal.words)})\b", kind), (pattern, Kind.NUMBER)), words=words)
    if re.fullmatch(pattern, '"x"'):
        return Piece(((pattern, Kind.TEXT),))
    if any(re.fullmatch(pattern, number) for number in ("1", "1s")):
        return Piece(((pattern, Kind.NUMBER),))
    if not re.match(pattern, "Name") and not re.match(pattern, "name"):
        operator = re.fullmatch(pattern, "=") or re.search(r"[^\\\[\](),;:.{}]", pattern)
        return Piece(((pattern, Kind.OPERATOR if operator else Kind.PUNCTUATION),))
    if terminal.attribute in ("type", "element", "result"):
        return Piece(((rf"(?:{'|'.join(BUILT_IN_TYPES)})\b", Kind.BUILT_IN), (pattern, Kind.TYPE)))
    if terminal.attribute == "name":
        return Piece(((pattern, Kind.BLOCK if block else Kind.NAME),))
    return Piece(((pattern, Kind.REFERENCE),))
