"""What was expected, in the words of the user: from a parser's mistakes to diagnostics."""

from __future__ import annotations

from aseme_dsl.amola.messages import BUILT_IN
from aseme_dsl.amola.operators import BRACKETS, INFIX_SIGNS
from aseme_dsl.diagnostics import Diagnostic, Problem, Related, closest, surely
from aseme_dsl.diagnostics.problems.syntax import characters
from aseme_dsl.diagnostics.problems.syntax import entries as problems
from aseme_dsl.diagnostics.problems.syntax.entries import Wanted
from aseme_dsl.grammar.parsing.progress import Mistake
from aseme_dsl.grammar.text.lexer import Lexed
from aseme_dsl.grammar.text.recovery import BLOCKS, begins_declaration
from aseme_dsl.runtime.time.clock import UNITS
from aseme_dsl.source import Span

_CHOICES = {
    "CommType": ("signal", "state", "data"),
    "FieldLabel": ("optional", "repeated"),
    "TopicFlagWord": ("queued", "persist"),
    "Verb": BLOCKS["JunkControl"].words,
    "StandingVerb": ("on", "exit"),
    "BusyToken": ("queue", "refuse"),
    "WaitsWord": ("waits",),
    "Reactive": ("reactive",),
    "First": ("first",),
    "RoleType": ("system", "abstract", "human", "legacy", "external"),
    "ActivityKind": ("thread", "async", "process", "step"),
    "FunctionalityWord": BLOCKS["JunkFunctionality"].words,
    "NodeType": ("START", "END", "OR", "AND", "BASIC", "CONDITION"),
}
"""The words that a terminal accepts, by the name of its rule."""

_OTHER_WORDS = {
    "protocol": "aip",
    "interaction": "aip",
    "role": "srm",
    "agent": "srm",
    "type": "message",
    "struct": "message",
    "channel": "topic",
    "include": "import",
    "fun": "function",
    "def": "function",
    "const": "let",
}
"""What declarations begin with elsewhere, and here."""

_TERMINALS = {
    "Name": Wanted.NAME,
    "EntryName": Wanted.NAME,
    "Reference": Wanted.NAME,
    "EntryReference": Wanted.NAME,
    "ProtocolName": Wanted.NAME,
    "SystemName": Wanted.NAME,
    "RoleName": Wanted.ROLE,
    "OutcomeName": Wanted.NAME,
    "IncludedName": Wanted.ROLE,
    "ActName": Wanted.NAME,
    "SentType": Wanted.MESSAGE,
    "SentName": Wanted.NAME,
    "SentToken": Wanted.EXPRESSION,
    "ActivityName": Wanted.ACTIVITY,
    "NodeName": Wanted.NAME,
    "Path": Wanted.NAME,
    "Text": Wanted.TEXT,
    "Integer": Wanted.INTEGER,
    "SignedInteger": Wanted.INTEGER,
    "Most": Wanted.MOST,
    "Count": Wanted.COUNT,
    "Bound": Wanted.COUNT,
    "Duration": Wanted.DURATION,
    "Label": Wanted.LABEL,
    "FormulaToken": Wanted.FORMULA,
    "ProcessToken": Wanted.FORMULA,
    "TermToken": Wanted.TERM,
    "ExpressionToken": Wanted.EXPRESSION,
    "SettingToken": Wanted.VALUE,
    "BindingToken": Wanted.VALUE,
}
"""What a terminal is, by the name of its rule."""

_UNSAID = ("ControlToken", "Separator", "Word", "FieldLabel", "Reach")
"""Terminals that go without saying."""

_ENTRIES: dict[str, tuple[Wanted | str, ...]] = {
    "JunkDeclaration": (Wanted.DECLARATION,),
    "JunkConstant": (Wanted.CONSTANT, "}"),
    "JunkField": (Wanted.FIELD, "}"),
    "JunkFormula": (Wanted.FORMULA_ENTRY, "}"),
    "JunkActivity": (Wanted.ACTIVITY, "}"),
    "JunkAgents": (Wanted.AGENT, "}"),
}
"""What a block holds, where its words do not say it."""


_BEGINNINGS = ("abstract", Wanted.NAME, Wanted.ACTIVITY, Wanted.LABEL)
"""What an entry may begin with, besides the words of its block."""


def explain(lexed: Lexed, mistake: Mistake) -> Diagnostic:
    """The diagnostic of a mistake."""
    if mistake.kind == "JunkEnd":
        return _Explanation(lexed, mistake).not_closed()
    return _Explanation(lexed, mistake).unexpected()


class _Explanation:
    def __init__(self, lexed: Lexed, mistake: Mistake) -> None:
        self.lexed = lexed
        self.tokens = lexed.tokens
        self.mistake = mistake
        self.first = self.tokens.at(mistake.start)
        self.index = self.tokens.at(mistake.place)
        if mistake.kind == "JunkHeader" and self.first > 0:
            self.first -= 1  # the end of the header before it, which has been understood
        self.words: tuple[str, ...] = ()
        self.clauses: tuple[str, ...] = ()
        if mistake.kind in BLOCKS:
            self.words, self.clauses = BLOCKS[mistake.kind].words, BLOCKS[mistake.kind].clauses

    # ---- what is wrong -------------------------------------------------------------------------

    def unexpected(self) -> Diagnostic:
        """Something else stands where an entry, or a part of one, is expected."""
        tokens = self.tokens
        found = tokens.word(self.index)
        if self.mistake.kind == "JunkDeclaration" and self.first == self.index:
            early = self._closed_early(found)
            if early is not None:
                return early
        swallowed = self._name_on_the_next_line()
        if swallowed is not None:
            return swallowed
        typical = (
            self._abstract_role()
            or self._misspelt()
            or self._no_colon()
            or self._hyphen()
            or self._other_comment()
            or self._other_assignment()
            or self._late_language()
        )
        typical = typical or self._other_word() or self._agents_by_number()
        if typical is not None:
            return typical
        if found.isdigit() and tokens.word(self.index + 1) in UNITS and self._expects("Duration"):
            return self._blank_before_unit()
        previous = tokens.word(self.index - 1)
        wanted = self._wanted()
        continues = self.index > self.first or (
            0 < self.index < len(tokens) and not tokens.begins_line(self.index)
        )
        after = previous if previous and continues else None
        if self.index >= len(tokens):
            problem = problems.UnexpectedInFile(wanted, after, None)
            return Diagnostic(problem, self._span(len(tokens) - 1))
        if tokens.begins_line(self.index) and self.index > self.first:
            # Something is missing at the end of a line, not wrong on the next one.
            return Diagnostic(self._end_of_line(wanted, after, found), self._span(self.index - 1))
        return Diagnostic(self._not_here(wanted, after, found), self._span(self.index))

    def not_closed(self) -> Diagnostic:
        """A `}` is missing."""
        tokens = self.tokens
        opener = tokens.at(self.mistake.opener if self.mistake.opener is not None else 0)
        place = min(self.index, len(tokens)) - 1
        found = None if self.index >= len(tokens) else tokens.word(self.index)
        kind = problems.BlockNotClosed
        # The block that lacks its `}` may be an inner one: then the outer one's `}` has closed it.
        for inner, closing in tokens.closing_with_missing.items():
            if (
                opener < inner
                and closing < self.index
                and tokens.begins_line(closing)
                and tokens.column(closing) == tokens.indentation(opener) < tokens.indentation(inner)
            ):
                opener, place, found = inner, closing - 1, "}"
                kind = problems.InnerBlockNotClosed
                break
        related = (Related(self._span(opener), "opened here"),)
        return Diagnostic(kind(self._header(opener), found), self._span(place), related)

    def _closed_early(self, found: str) -> Diagnostic | None:
        """After a `}` too many, the rest of a block stands where declarations are expected."""
        tokens = self.tokens
        begin = self.first - 1
        while begin > 0 and not begins_declaration(tokens, begin):
            begin -= 1
        openers = {
            closing: opening for opening, closing in tokens.closing_with_missing.items() if opening >= begin
        }
        for closing in range(begin, self.first):
            opener = openers.get(closing)
            if opener is None or tokens.word(closing) != "}":
                continue
            if "\n" not in self.lexed.text[tokens.starts[opener] : tokens.starts[closing]]:
                continue
            if tokens.begins_line(closing) and tokens.column(closing) == tokens.indentation(opener):
                continue
            if not tokens.begins_line(closing) and closing + 1 != self.first:
                continue
            related = (Related(self._span(opener), "opened here"),)
            return Diagnostic(problems.BlockClosedEarly(self._header(opener)), self._span(closing), related)
        if found == "}":
            return Diagnostic(problems.NothingToClose(), self._span(self.index))
        return None

    def _name_on_the_next_line(self) -> Diagnostic | None:
        """Where a name is missing at the end of a line, the word on the next line was taken for it."""
        tokens = self.tokens
        taken = self.first - 1
        if taken < 1 or not tokens.begins_line(taken) or tokens.word(taken) not in self.words:
            return None
        before = tokens.word(taken - 1)
        problem = problems.UnexpectedInFile((Wanted.NAME,), before, tokens.word(taken))
        return Diagnostic(problem, self._span(taken - 1))

    def _misspelt(self) -> Diagnostic | None:
        tokens = self.tokens
        entry = self.first
        if self.mistake.kind in ("JunkActivity", "JunkChart") and tokens.word(entry - 2) not in (
            *self.words,
            ",",
        ):
            entry -= 1  # a misspelt clause has been taken for a name
        for index, candidates in ((self.index, self._keywords()), (entry, (*self.words, *self.clauses))):
            word = tokens.word(index)
            if index < self.index - 1 or not word[:1].isalpha() or word in candidates:
                continue
            meant = closest(word, candidates)
            if meant is not None:
                problem = problems.MisspeltWord(word, meant)
                return Diagnostic(problem, self._span(index), fix=surely(word, candidates))
        return None

    def _no_colon(self) -> Diagnostic | None:
        """In `enter KickBall [can_kick(ball)]` the colon is missing where the term is complete."""
        tokens = self.tokens
        if (
            self.mistake.kind != "JunkControl"
            or not self._expects_literal(":")
            or self.index - 1 <= self.first
        ):
            return None
        if tokens.word(self.first) not in self.words:
            return None
        complete = False
        place = self.index
        for index in range(self.first + 1, self.index):
            word = tokens.word(index)
            begins_operand = word in ("[", "(") or word[:1].isalpha()
            counts = word == "[" and tokens.word(index + 1).isdigit()
            if complete and begins_operand and not counts:
                place = index
                break
            complete = word not in INFIX_SIGNS and word not in BRACKETS
        before = tokens.word(place - 1)
        found = tokens.word(place) if place < len(tokens) else None
        problem = problems.ControlWithoutColon((":",), before, found, tokens.word(self.first))
        return Diagnostic(problem, self._span(place - 1))

    def _hyphen(self) -> Diagnostic | None:
        tokens = self.tokens
        here = self.index
        before, after = tokens.word(here - 1), tokens.word(here + 1)
        joined = (
            tokens.word(here) == "-"
            and before[:1].isalpha()
            and after[:1].isalpha()
            and tokens.ends[here - 1] + 1 == tokens.ends[here] == tokens.starts[here + 1]
        )
        if not joined:
            return None
        span = Span(self.lexed.source, tokens.starts[here - 1], tokens.ends[here + 1])
        return Diagnostic(problems.HyphenInName(before, after), span, fix=f"{before}_{after}")

    def _other_word(self) -> Diagnostic | None:
        """What a declaration begins with in other languages, or in the speech of its users."""
        word = self.tokens.word(self.index)
        meant = _OTHER_WORDS.get(word)
        if self.mistake.kind != "JunkDeclaration" or self.index != self.first or meant is None:
            return None
        return Diagnostic(problems.WordOfOthers(word, meant), self._span(self.index), fix=meant)

    def _abstract_role(self) -> Diagnostic | None:
        """`abstract role base`: the word of the use cases for what is an `srm` here."""
        word = self.tokens.word(self.index)
        if self.tokens.word(self.index - 1) != "abstract" or _OTHER_WORDS.get(word) != "srm":
            return None
        return Diagnostic(problems.WordOfOthers(word, "srm"), self._span(self.index), fix="srm")

    def _agents_by_number(self) -> Diagnostic | None:
        """`robot[2]` for two agents."""
        tokens = self.tokens
        number = tokens.word(self.index - 1)
        if self.mistake.kind != "JunkAgents" or tokens.word(self.index) != "]" or not number.isdigit():
            return None
        fix = f"1..{number}" if int(number) > 1 else None
        return Diagnostic(problems.AgentsByNumber(number, fix), self._span(self.index - 1), fix=fix)

    def _other_comment(self) -> Diagnostic | None:
        """`# …` of other languages."""
        if self.tokens.word(self.index) != "#":
            return None
        return Diagnostic(problems.CommentOfOthers(), self._span(self.index), fix="//")

    def _other_assignment(self) -> Diagnostic | None:
        """`int rounds = 0` for a variable of a role, `ann = waiter` and `with (limit = 2)` in a team."""
        tokens = self.tokens
        before, word, after = (tokens.word(self.index + step) for step in (-1, 0, 1))
        if self.mistake.kind == "JunkAgents" and word == "=" and self._expects_literal(":"):
            role = after if after[:1].isalpha() else None
            problem = problems.AgentWithEquals((":",), before, word, role)
            return Diagnostic(problem, self._span(self.index), fix=":")
        if self.mistake.kind == "JunkAgents" and word == "(" and before == "with":
            return Diagnostic(problems.SettingsInParentheses(), self._span(self.index))
        if "var" in self.words and word in BUILT_IN and after[:1].isalpha() and self.index == self.first:
            value = tokens.word(self.index + 3)
            initial = value if tokens.word(self.index + 2) == "=" and value else None
            return Diagnostic(problems.VariableWithoutVar(word, after, initial), self._span(self.index))
        return None

    def _late_language(self) -> Diagnostic | None:
        if self.index != self.first or self.tokens.word(self.index) != "language":
            return None
        return Diagnostic(problems.LateLanguage(), self._span(self.index))

    def _blank_before_unit(self) -> Diagnostic:
        tokens = self.tokens
        number, unit = tokens.word(self.index), tokens.word(self.index + 1)
        span = Span(self.lexed.source, tokens.starts[self.index], tokens.ends[self.index + 1])
        return Diagnostic(characters.BlankBeforeUnit(number, unit), span, fix=number + unit)

    # ---- words and places ----------------------------------------------------------------------

    def _expects(self, rule: str) -> bool:
        return any(item.rule_name == rule for item in self.mistake.expected)

    def _expects_literal(self, text: str) -> bool:
        return any(not item.rule_name and item.to_match == text for item in self.mistake.expected)

    def _keywords(self) -> list[str]:
        words: list[str] = []
        for rule in self.mistake.expected:
            words += _CHOICES.get(rule.rule_name, ())
            if not rule.rule_name:
                words.append(str(rule.to_match))
        if self.index == self.first:
            words += [*self.words, *self.clauses]
        return [word for word in dict.fromkeys(words) if word[:1].isalpha()]

    def _wanted(self) -> tuple[Wanted | str, ...]:
        """What may stand here; at the begin of an entry what the block holds, rather than a long list."""
        wanted: dict[Wanted | str, None] = {}
        for rule in self.mistake.expected:
            if rule.rule_name in _CHOICES:
                wanted |= dict.fromkeys(_CHOICES[rule.rule_name])
            elif rule.rule_name in _TERMINALS:
                wanted[_TERMINALS[rule.rule_name]] = None
            elif rule.rule_name not in _UNSAID:
                wanted[str(rule.to_match)] = None
        if self.index > self.first or self.mistake.kind not in BLOCKS:
            return tuple(wanted)
        more = [item for item in wanted if item not in self.words and item not in _BEGINNINGS]
        if more and self.index < len(self.tokens) and not self.tokens.begins_line(self.index):
            return (*more, Wanted.NEXT_ENTRY)
        return _ENTRIES.get(self.mistake.kind) or (*self.words, "}")

    def _end_of_line(self, wanted: tuple[Wanted | str, ...], after: str | None, found: str) -> Problem:
        """A transition by labels has a colon, even with nothing behind it."""
        tokens = self.tokens
        if wanted != (":",) or tokens.word(self.index - 2) != "->":
            return problems.UnexpectedInFile(wanted, after, found)
        source, target = tokens.word(self.index - 3), tokens.word(self.index - 1)
        return problems.LabelledWithoutColon(wanted, after, found, source, target)

    def _not_here(self, wanted: tuple[Wanted | str, ...], after: str | None, found: str) -> Problem:
        tokens = self.tokens
        if found.isdigit() and self._expects("Duration"):
            return problems.DurationWithoutUnit(wanted, after, found)
        if wanted == (Wanted.EXPRESSION,) and tokens.word(self.index + 1) == "{":
            return problems.MessageOutsideControl(wanted, after, found)
        if self.mistake.kind != "JunkDeclaration" or self.index != self.first:
            return problems.UnexpectedInFile(wanted, after, found)
        if tokens.word(self.first - 2) == "import" and found in (".", "/", "-"):
            return problems.PathWithoutQuotes(wanted, after, found)
        return problems.NoDeclaration(wanted, after, found, self.words)

    def _span(self, index: int) -> Span:
        if not 0 <= index < len(self.tokens):
            return Span(self.lexed.source, 0, 0)
        return Span(self.lexed.source, self.tokens.starts[index], self.tokens.ends[index])

    def _header(self, opener: int) -> str:
        """The words before a `{`, which say what it opens."""
        tokens = self.tokens
        first = opener
        while first > 0 and not tokens.begins_line(first) and tokens.word(first - 1) not in ("{", "}"):
            first -= 1
        return " ".join(self.lexed.text[tokens.starts[first] : tokens.starts[opener]].split())
