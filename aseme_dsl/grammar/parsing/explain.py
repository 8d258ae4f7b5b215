"""What was expected, in the words of the user: from a parser's mistakes to diagnostics."""

from __future__ import annotations

from collections.abc import Iterable

from aseme_dsl.amola.messages import BUILT_IN
from aseme_dsl.amola.operators import BRACKETS, INFIX_SIGNS
from aseme_dsl.diagnostics import Diagnostic, Related, closest, surely
from aseme_dsl.grammar.parsing.terminals import Mistake
from aseme_dsl.grammar.text.lexer import UNITS, Lexed, shown
from aseme_dsl.grammar.text.recovery import BLOCKS, begins_declaration
from aseme_dsl.source import Span

_CHOICES = {
    "CommType": ("signal", "state", "data"),
    "FieldLabel": ("optional", "repeated"),
    "TopicFlagWord": ("queued", "persist"),
    "Verb": BLOCKS["JunkControl"].words,
    "Reactive": ("reactive",),
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

_PHRASES = {
    "Name": "a name",
    "EntryName": "a name",
    "SystemName": "a name",
    "RoleName": "a role",
    "OutcomeName": "a name",
    "IncludedName": "a role",
    "ActName": "a name",
    "ActivityName": "an activity",
    "NodeName": "a name",
    "Path": "a name",
    "Text": "a text in double quotes",
    "Integer": "a whole number",
    "SignedInteger": "a whole number",
    "Most": "a whole number or '*'",
    "Count": "a number",
    "Duration": "a duration (as 200ms)",
    "Label": "a label (as 0.2.1)",
    "FormulaToken": "a formula",
    "ProcessToken": "a formula",
    "TermToken": "a term of the formula",
    "ExpressionToken": "an expression",
    "SettingToken": "a value",
} | dict.fromkeys(("ControlToken", "Separator", "Word", "FieldLabel", "Reach"), "")
"""What a terminal is called, by the name of its rule; what goes without saying is empty."""

_ENTRIES = {
    "JunkDeclaration": "a declaration",
    "JunkConstant": "a constant or '}'",
    "JunkField": "a field (as 'double x') or '}'",
    "JunkFormula": "a formula (as 'NAME = A . B') or '}'",
    "JunkActivity": "an activity or '}'",
    "JunkAgents": "an agent (as 'robot1 : player') or '}'",
}
"""What a block holds, where its words do not say it."""


_BEGINNINGS = ("'abstract'", "a name", "an activity", "a label (as 0.2.1)")
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
        after = f" after {shown(previous)}" if previous and continues else ""
        if self.index >= len(tokens):
            last = len(tokens) - 1
            return Diagnostic("E100", f"expected {wanted}{after}, but the file ends", self._span(last))
        message = f"expected {wanted}{after}, found {shown(found)}"
        if tokens.begins_line(self.index) and self.index > self.first:
            # Something is missing at the end of a line, not wrong on the next one.
            return Diagnostic("E100", message, self._span(self.index - 1), hint=self._no_expression(wanted))
        hint = self._what_may_stand_here()
        if found.isdigit() and self._expects("Duration"):
            hint = f"a duration has a unit: {found}ms, {found}s or {found}min"
        return Diagnostic("E100", message, self._span(self.index), hint=hint)

    def not_closed(self) -> Diagnostic:
        """A `}` is missing."""
        tokens = self.tokens
        opener = tokens.at(self.mistake.opener if self.mistake.opener is not None else 0)
        place = min(self.index, len(tokens)) - 1
        found = (
            "but the file ends" if self.index >= len(tokens) else f"found {shown(tokens.word(self.index))}"
        )
        # The block that lacks its `}` may be an inner one: then the outer one's `}` has closed it.
        for inner, closing in tokens.closing_with_missing.items():
            if (
                opener < inner
                and closing < self.index
                and tokens.begins_line(closing)
                and tokens.column(closing) == tokens.indentation(opener) < tokens.indentation(inner)
            ):
                opener, place, found = inner, closing - 1, "found the '}' of a block around it"
                break
        related = (Related(self._span(opener), "opened here"),)
        message = f"expected '}}' that closes {self._header(opener)}, {found}"
        return Diagnostic("E111", message, self._span(place), related, hint="write '}'")

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
            message = f"this '}}' closes {self._header(opener)} too early"
            hint = "is it too much, or is a '{' missing before it?"
            related = (Related(self._span(opener), "opened here"),)
            return Diagnostic("E112", message, self._span(closing), related, hint)
        if found == "}":
            return Diagnostic("E112", "this '}' closes nothing", self._span(self.index), hint="leave it out")
        return None

    def _name_on_the_next_line(self) -> Diagnostic | None:
        """Where a name is missing at the end of a line, the word on the next line was taken for it."""
        tokens = self.tokens
        taken = self.first - 1
        if taken < 1 or not tokens.begins_line(taken) or tokens.word(taken) not in self.words:
            return None
        before = tokens.word(taken - 1)
        message = f"expected a name after {shown(before)}, found {shown(tokens.word(taken))}"
        return Diagnostic("E100", message, self._span(taken - 1))

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
                message = f"{shown(word)} is no word of the language here"
                hint = f"did you mean {shown(meant)}?"
                return Diagnostic("E100", message, self._span(index), hint=hint, fix=surely(word, candidates))
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
        message = f"expected ':' after {shown(before)}, found {shown(tokens.word(place))}"
        if place == len(tokens):
            message = f"expected ':' after {shown(before)}, but the file ends"
        hint = f"write {tokens.word(self.first)} TERM : event [condition] / actions"
        return Diagnostic("E100", message, self._span(place - 1), hint=hint)

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
        name = f"{before}_{after}"
        return Diagnostic("E100", f"{shown(span.text)} is not a name", span, hint=f"write {name}", fix=name)

    def _other_word(self) -> Diagnostic | None:
        """What a declaration begins with in other languages, or in the speech of its users."""
        word = self.tokens.word(self.index)
        meant = _OTHER_WORDS.get(word)
        if self.mistake.kind != "JunkDeclaration" or self.index != self.first or meant is None:
            return None
        message = f"{shown(word)} is no word of the language here"
        return Diagnostic("E100", message, self._span(self.index), hint=f"write {shown(meant)}", fix=meant)

    def _abstract_role(self) -> Diagnostic | None:
        """`abstract role base`: the word of the use cases for what is an `srm` here."""
        word = self.tokens.word(self.index)
        if self.tokens.word(self.index - 1) != "abstract" or _OTHER_WORDS.get(word) != "srm":
            return None
        message = f"{shown(word)} is no word of the language here"
        return Diagnostic("E100", message, self._span(self.index), hint="write 'srm'", fix="srm")

    def _agents_by_number(self) -> Diagnostic | None:
        """`robot[2]` for two agents."""
        tokens = self.tokens
        number = tokens.word(self.index - 1)
        if self.mistake.kind != "JunkAgents" or tokens.word(self.index) != "]" or not number.isdigit():
            return None
        message = f"agents are counted from one number to another, as [1..{number}]"
        span, several = self._span(self.index - 1), int(number) > 1
        fix = f"1..{number}" if several else None
        return Diagnostic("E100", message, span, hint=f"write [{fix}]" if fix else None, fix=fix)

    def _other_comment(self) -> Diagnostic | None:
        """`# …` of other languages."""
        if self.tokens.word(self.index) != "#":
            return None
        message = "'#' does not begin a comment here"
        return Diagnostic("E100", message, self._span(self.index), hint="comments begin with '//'", fix="//")

    def _other_assignment(self) -> Diagnostic | None:
        """`int rounds = 0` for a variable of a role, `ann = waiter` and `with (limit = 2)` in a team."""
        tokens = self.tokens
        before, word, after = (tokens.word(self.index + step) for step in (-1, 0, 1))
        if self.mistake.kind == "JunkAgents" and word == "=" and self._expects_literal(":"):
            message = f"expected ':' after {shown(before)}, found '='"
            hint = f"write {before} : {after}" if after[:1].isalpha() else "write ':'"
            return Diagnostic("E100", message, self._span(self.index), hint=hint, fix=":")
        if self.mistake.kind == "JunkAgents" and word == "(" and before == "with":
            message = "what is set in an agent stands behind 'with' without parentheses"
            hint = "write with NAME = VALUE, NAME = VALUE"
            return Diagnostic("E100", message, self._span(self.index), hint=hint)
        if "var" in self.words and word in BUILT_IN and after[:1].isalpha() and self.index == self.first:
            value = tokens.word(self.index + 3)
            initial = f" = {value}" if tokens.word(self.index + 2) == "=" and value else ""
            message = f"expected 'var' before a variable, found {shown(word)}"
            return Diagnostic(
                "E100", message, self._span(self.index), hint=f"write var {after} : {word}{initial}"
            )
        return None

    def _late_language(self) -> Diagnostic | None:
        if self.index != self.first or self.tokens.word(self.index) != "language":
            return None
        return Diagnostic("E100", "'language' can only stand first in a file", self._span(self.index))

    def _blank_before_unit(self) -> Diagnostic:
        tokens = self.tokens
        number, unit = tokens.word(self.index), tokens.word(self.index + 1)
        span = Span(self.lexed.source, tokens.starts[self.index], tokens.ends[self.index + 1])
        message = f"a blank between the number {number} and its unit {unit}"
        return Diagnostic("E108", message, span, hint=f"write {number}{unit}", fix=number + unit)

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

    def _wanted(self) -> str:
        """What may stand here; at the begin of an entry what the block holds, rather than a long list."""
        phrases: list[str] = []
        for rule in self.mistake.expected:
            if rule.rule_name in _CHOICES:
                phrases += [f"'{word}'" for word in _CHOICES[rule.rule_name]]
            elif rule.rule_name in _PHRASES:
                phrases.append(_PHRASES[rule.rule_name])
            else:
                phrases.append(f"'{rule.to_match}'")
        phrases = [phrase for phrase in dict.fromkeys(phrases) if phrase]
        if self.index > self.first or self.mistake.kind not in BLOCKS:
            return _alternatives(phrases)
        words = [f"'{word}'" for word in self.words]
        more = [phrase for phrase in phrases if phrase not in words and phrase not in _BEGINNINGS]
        if more and self.index < len(self.tokens) and not self.tokens.begins_line(self.index):
            return _alternatives([*more, "the next entry"])
        return _ENTRIES.get(self.mistake.kind) or _alternatives([*words, "'}'"])

    def _no_expression(self, wanted: str) -> str | None:
        """A transition by labels with nothing behind it: it has a colon nevertheless."""
        if wanted != "':'" or self.tokens.word(self.index - 2) != "->":
            return None
        source, target = self.tokens.word(self.index - 3), self.tokens.word(self.index - 1)
        return f"write '{source} -> {target} :' for one that waits for completion"

    def _what_may_stand_here(self) -> str | None:
        tokens = self.tokens
        if self.mistake.kind == "JunkDeclaration" and self.index == self.first:
            if tokens.word(self.first - 2) == "import" and tokens.word(self.index) in (".", "/", "-"):
                return "a path stands in double quotes"
            return "declarations begin with " + _alternatives(list(self.words))
        return None

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
        header = " ".join(self.lexed.text[tokens.starts[first] : tokens.starts[opener]].split())
        return shown(header) if header else "the block"


def _alternatives(phrases: Iterable[str]) -> str:
    *all_but_last, last = list(phrases) or ["something else"]
    return ", ".join(all_but_last) + " or " + last if all_but_last else last
