"""Expected: what the grammar would take next where a text is cut off.

The parser itself says it: it reads the text up to there, and every terminal that it tries in vain at the very
end is one that may come next. So a word that is added to the grammar is expected at once.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import field
from functools import lru_cache

from arpeggio import Match, NoMatch, OneOrMore, Optional, OrderedChoice, RegExMatch, Sequence, ZeroOrMore

from aseme_dsl.grammar.parsing.progress import ParsingExpression, Progress, TextParser
from aseme_dsl.grammar.parsing.terminals import (
    AsemeParser,
    all_rules,
    make_parser_model,
    skip_blanks,
)
from aseme_dsl.grammar.text.recovery import BLOCKS
from aseme_dsl.records import dataclass
from aseme_dsl.source import Source


@dataclass(frozen=True, slots=True)
class Step:
    """A rule of the grammar that was begun at `start`, and its attribute that is being read ("" if none)."""

    rule: str
    attribute: str
    start: int


@dataclass(frozen=True, slots=True)
class Expected:
    """A terminal that may come next.

    `terminal` is the name of its rule ("" for a word or sign of the grammar). `words` are the words that it
    accepts, if these are a fixed set. `steps` are the rules around it that have begun, the outermost first.
    """

    terminal: str
    words: tuple[str, ...]
    steps: tuple[Step, ...]
    holder: ParsingExpression = field(repr=False, compare=False)  # the rule that is to be matched

    @property
    def place(self) -> tuple[str, str]:
        """The innermost rule and its attribute."""
        return (self.steps[-1].rule, self.steps[-1].attribute) if self.steps else ("", "")

    def step(self, rule: str) -> Step | None:
        """The innermost step of this rule."""
        return next((item for item in reversed(self.steps) if item.rule == rule), None)


def expected_after(text: str) -> tuple[Expected, ...]:
    """What may follow `text`, in the order in which the parser tries it; nothing after a mistake."""
    parser = AsemeParser(_watching())
    parser.source = Source("<text>", text)
    parser.make_progress = _Watch
    with suppress(NoMatch):  # what is at the end has been noted
        parser.parse(text)
    watch = parser.progress
    assert isinstance(watch, _Watch)
    return tuple(watch.noted.values())


@dataclass
class _Watch(Progress):
    """A parser's progress that notes what is tried at the end of the text."""

    begun: list[tuple[ParsingExpression, int]] = field(default_factory=list)
    noted: dict[tuple[int, tuple[Step, ...]], Expected] = field(default_factory=dict)

    def fail(self, rule: ParsingExpression, position: int) -> None:
        super().fail(rule, position)
        if position >= len(self.lexed.text):
            steps = tuple(self._steps())
            holder = self.begun[-1][0] if self.begun and _attribute(self.begun[-1][0]) else rule
            self.noted.setdefault(
                (id(rule), steps), Expected(str(rule.rule_name), words_of(rule), steps, holder)
            )

    def _steps(self) -> Iterator[Step]:
        last: Step | None = None
        for rule, start in self.begun:
            attribute = _attribute(rule)
            if attribute:
                if last is not None:
                    yield Step(last.rule, attribute, last.start)
                last = None
                continue
            if last is not None:
                yield last
            last = Step(str(rule.rule_name), "", start)
        if last is not None:
            yield last


def _attribute(rule: ParsingExpression) -> str:
    return str(rule._attr_name) if str(rule.rule_name).startswith("__asgn") else ""


@lru_cache(maxsize=1)
def _watching() -> ParsingExpression:
    """Parsing expressions that tell which of them have been begun, and that fixes nothing at the end."""
    made = make_parser_model()
    for rule, _ in list(all_rules(made)):
        name = str(rule.rule_name)
        if isinstance(rule, Match):
            if name in BLOCKS or name in ("JunkHeader", "JunkEnd"):
                rule.parse = _not_at_the_end(rule.parse)
        elif rule.root and name not in ("", "Model") and not isinstance(rule, OrderedChoice):
            rule.parse = _begun(rule, rule.parse)
    return made


def _begun(rule: ParsingExpression, parse: Callable[[TextParser], object]) -> Callable[[TextParser], object]:
    def watched(parser: TextParser) -> object:
        watch = parser.progress
        assert isinstance(watch, _Watch)
        begun = watch.begun
        begun.append((rule, skip_blanks(parser)))
        try:
            return parse(parser)
        finally:
            begun.pop()

    return watched


def _not_at_the_end(parse: Callable[[TextParser], object]) -> Callable[[TextParser], object]:
    """Junk that would swallow the end of the text, or a brace that would be made up there, is none."""

    def watched(parser: TextParser) -> object:
        made = parse(parser) if skip_blanks(parser) < len(parser.input) else None
        if made is None or skip_blanks(parser) == len(parser.input):
            raise NoMatch([], parser.position, parser)
        return made

    return watched


# ---- what is written ---------------------------------------------------------------------------

_CHOICE = re.compile(r"\(\?:([^()]*)\)\\b")


def words_of(rule: ParsingExpression) -> tuple[str, ...]:
    """The words or the sign that a terminal accepts; nothing where it accepts more than a few words."""
    if not isinstance(rule, RegExMatch) or not rule.rule_name:
        return (str(rule.to_match),) if isinstance(rule, Match) and rule.to_match else ()
    choice = _CHOICE.match(rule.to_match)
    return tuple(item for item in choice[1].split("|") if item.isidentifier()) if choice else ()


@dataclass(frozen=True, slots=True)
class Blank:
    """What is still to be written after a word: a terminal by its rule, and its attribute.

    `words` are those that it accepts, if it is one of a few.
    """

    terminal: str
    attribute: str
    words: tuple[str, ...] = ()


def rest_of(expected: Expected) -> tuple[str | Blank, ...]:
    """What must follow the expected terminal for its entry or clause to be complete; options are left out."""
    sequence = _parents().get(id(expected.holder))
    if sequence is None:
        return ()
    nodes = list(sequence.nodes)
    index = next(i for i, node in enumerate(nodes) if node is expected.holder)
    return tuple(_blanks(nodes[index + 1 :], expected.place[1]))


@lru_cache(maxsize=1)
def _parents() -> dict[int, ParsingExpression]:
    """The sequence in which a terminal or an assignment stands."""
    found: dict[int, ParsingExpression] = {}
    for rule, _ in all_rules(_watching()):
        if type(rule) is Sequence and not _attribute(rule):
            found |= {id(node): rule for node in rule.nodes}
    return found


def _blanks(nodes: list[ParsingExpression], attribute: str) -> Iterator[str | Blank]:
    waiting = [(node, attribute) for node in reversed(nodes)]
    while waiting:
        rule, attribute = waiting.pop()
        if isinstance(rule, Match):
            if rule.rule_name:
                yield Blank(str(rule.rule_name), attribute, words_of(rule))
            else:
                yield str(rule.to_match)
        elif rule.rule_name == "Open":
            yield "{"
        elif isinstance(rule, OneOrMore) or (isinstance(rule, Sequence) and type(rule) is Sequence):
            inner = _attribute(rule) or attribute
            waiting += [(node, inner) for node in reversed(rule.nodes)]
        elif isinstance(rule, (Optional, ZeroOrMore)):
            if rule.rule_name and isinstance(rule.nodes[0], RegExMatch):
                yield Blank(str(rule.nodes[0].rule_name), _attribute(rule))
        elif isinstance(rule, OrderedChoice) and rule.rule_name != "Close":
            first = rule.nodes[0]
            waiting.append((first, attribute))


def all_places() -> frozenset[tuple[str, str, str]]:
    """Every rule of the grammar, with each of its attributes and the terminal that is read into it."""
    found: set[tuple[str, str, str]] = set()
    for rule, owner in all_rules(_watching()):
        attribute = _attribute(rule)
        if attribute:
            for node in rule.nodes:
                if isinstance(node, Match):
                    found.add((owner, attribute, str(node.rule_name)))
    return frozenset(found)


__all__ = ["Blank", "Expected", "Step", "all_places", "expected_after", "rest_of", "words_of"]
