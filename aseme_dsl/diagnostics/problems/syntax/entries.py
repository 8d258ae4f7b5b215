"""Entries: the parts of a file, its holes, comments and braces (E100, E109–E116)."""

from __future__ import annotations

from collections.abc import Iterable
from enum import Enum
from typing import ClassVar

from aseme_dsl.diagnostics.problem import Problem
from aseme_dsl.diagnostics.wording import shown

Signs = tuple[tuple[str, str], ...]
"""Signs of operators, each with what it means."""


class Wanted(Enum):
    """What may be expected at a place, besides words of the language; the value is what it is called."""

    ACTION = "an action"
    ACTIVITY = "an activity"
    AGENT = "an agent (as 'robot1 : player')"
    AGENT_NAME = "a name for the agent"
    CONDITION = "'[' and a condition"
    CONDITION_OR_STATE = "a condition or a state"
    CONSTANT = "a constant"
    COUNT = "a number"
    DECLARATION = "a declaration"
    DURATION = "a duration (as 200ms)"
    ELEMENT_MEMBER = "a member of the element"
    END_OF_ACTIONS = "';' and an action, or the end of the entry,"
    END_OF_CONDITION = "'/' and an action, or the end of the entry,"
    END_OF_EVENTS = "'[', '/' or the end of the entry"
    EVENT = "an event"
    EXPRESSION = "an expression"
    FIELD = "a field (as 'double x')"
    FORMULA = "a formula"
    FORMULA_ENTRY = "a formula (as 'NAME = A . B')"
    INTEGER = "a whole number"
    LABEL = "a label (as 0.2.1)"
    MEMBER = "a member of the message"
    MESSAGE = "a message"
    MESSAGE_NAME = "a name for the message"
    MOST = "a whole number or '*'"
    NAME = "a name"
    NEXT_ENTRY = "the next entry"
    OPERATOR = "an operator"
    OUTCOME = "an outcome of the activity"
    PARTICIPANT = "a participant"
    PERFORMATIVE = "a performative"
    RECEIVER = "'to' and a participant"
    RECEIVING_PARTICIPANT = "the participant that receives the message"
    ROLE = "a role"
    SENDER = "'from' and a participant"
    SENDING_PARTICIPANT = "the participant that sends the message"
    SIGNAL = "a signal (as topic.signal.Message)"
    STATE = "a state"
    STATEMENT = "a statement"
    TERM = "a term of the formula"
    TEXT = "a text in double quotes"
    VALUE = "a value"


class Unexpected(Problem):
    """Something else than one of `wanted` stands `after` a word: `found`, None at the end.

    In `wanted`, a string is a word or sign of the language.
    """

    wanted: tuple[Wanted | str, ...]
    after: str | None
    found: str | None
    whole: ClassVar[str]
    """What ends."""

    @property
    def message(self) -> str:
        wanted = _alternatives(one.value if isinstance(one, Wanted) else f"'{one}'" for one in self.wanted)
        after = f" after {shown(self.after)}" if self.after is not None else ""
        found = f"found {shown(self.found)}" if self.found is not None else f"but the {self.whole} ends"
        return f"expected {wanted}{after}, {found}"


def _alternatives(phrases: Iterable[str]) -> str:
    *all_but_last, last = list(phrases) or ["something else"]
    return ", ".join(all_but_last) + " or " + last if all_but_last else last


# ---- E100: the parts of a file -----------------------------------------------------------------


class UnexpectedInFile(Unexpected):
    code = "E100"
    whole = "file"


class DurationWithoutUnit(UnexpectedInFile):
    @property
    def hint(self) -> str:
        return f"a duration has a unit: {self.found}ms, {self.found}s or {self.found}min"


class MessageOutsideControl(UnexpectedInFile):
    """`var now : Order = Order { id = 1 }`"""

    hint = "a message is made in a control line: a variable holds none at first, and an action sets it"


class PathWithoutQuotes(UnexpectedInFile):
    hint = "a path stands in double quotes"


class NoDeclaration(UnexpectedInFile):
    """`beginnings`: the words that declarations begin with."""

    beginnings: tuple[str, ...]

    @property
    def hint(self) -> str:
        return "declarations begin with " + _alternatives(self.beginnings)


class LabelledWithoutColon(UnexpectedInFile):
    """A transition between two labels."""

    source: str
    target: str

    @property
    def hint(self) -> str:
        return f"write '{self.source} -> {self.target} :' for one that waits for completion"


class ControlWithoutColon(UnexpectedInFile):
    verb: str

    @property
    def hint(self) -> str:
        return f"write {self.verb} TERM : event [condition] / actions"


class AgentWithEquals(UnexpectedInFile):
    """`ann = waiter`: `role` stands behind the `=`, None if no name does."""

    role: str | None

    @property
    def hint(self) -> str:
        return f"write {self.after} : {self.role}" if self.role is not None else "write ':'"


class MisspeltWord(Problem):
    code = "E100"
    word: str
    meant: str

    @property
    def message(self) -> str:
        return f"{shown(self.word)} is not a word of the language here"

    @property
    def hint(self) -> str:
        return f"did you mean {shown(self.meant)}?"


class WordOfOthers(MisspeltWord):
    """What other languages, or people, call what is `meant`."""

    @property
    def hint(self) -> str:
        return f"write {shown(self.meant)}"


class HyphenInName(Problem):
    code = "E100"
    before: str
    after: str

    @property
    def message(self) -> str:
        return f"{shown(f'{self.before}-{self.after}')} is not a name"

    @property
    def hint(self) -> str:
        return f"write {self.before}_{self.after}"


class AgentsByNumber(Problem):
    """`robot[2]`; `range` is what may be meant."""

    code = "E100"
    number: str
    range: str | None

    @property
    def message(self) -> str:
        return f"agents are counted from one number to another, as [1..{self.number}]"

    @property
    def hint(self) -> str | None:
        return f"write [{self.range}]" if self.range is not None else None


class CommentOfOthers(Problem):
    code = "E100"
    message = "'#' does not begin a comment here"
    hint = "comments begin with '//'"


class SettingsInParentheses(Problem):
    code = "E100"
    message = "what is set in an agent stands behind 'with' without parentheses"
    hint = "write with NAME = VALUE, NAME = VALUE"


class VariableWithoutVar(Problem):
    """`int rounds = 0`"""

    code = "E100"
    type: str
    name: str
    initial: str | None

    @property
    def message(self) -> str:
        return f"expected 'var' before a variable, found {shown(self.type)}"

    @property
    def hint(self) -> str:
        initial = f" = {self.initial}" if self.initial is not None else ""
        return f"write var {self.name} : {self.type}{initial}"


class LateLanguage(Problem):
    code = "E100"
    message = "'language' can only stand first in a file"


# ---- E109: holes -------------------------------------------------------------------------------


class Hole(Problem):
    """Something is still to be chosen or written."""

    code = "E109"


class OperatorToChoose(Hole):
    """`usual`: the operators that are named."""

    usual: Signs
    message = "an operator is still to be chosen here"

    @property
    def hint(self) -> str:
        return "write " + ", ".join(f"`{sign}` for {meaning}" for sign, meaning in self.usual)


class ConditionToWrite(Hole):
    message = "a condition is still to be written here"
    hint = "write when this transition is taken, or `else` instead of the brackets"


# ---- E110 to E116: comments, braces, entries, the whole file -----------------------------------


class CommentNotClosed(Problem):
    code = "E110"
    message = "the comment that begins here is not closed"
    hint = "write '*/' at its end"


class BlockNotClosed(Problem):
    """`header`: the words before its `{`, if any; `found`: what stands instead, None at the file's end."""

    code = "E111"
    header: str
    found: str | None
    hint = "write '}'"

    @property
    def message(self) -> str:
        found = "but the file ends" if self.found is None else f"found {shown(self.found)}"
        return f"expected '}}' that closes {_block(self.header)}, {found}"


class InnerBlockNotClosed(BlockNotClosed):
    """The `}` of a block around it stands instead."""

    @property
    def message(self) -> str:
        return f"expected '}}' that closes {_block(self.header)}, found the '}}' of a block around it"


class BlockClosedEarly(Problem):
    """`header`: the words before its `{`, if any."""

    code = "E112"
    header: str
    hint = "is it too much, or is a '{' missing before it?"

    @property
    def message(self) -> str:
        return f"this '}}' closes {_block(self.header)} too early"


def _block(header: str) -> str:
    return shown(header) if header else "the block"


class NothingToClose(Problem):
    code = "E112"
    message = "this '}' closes nothing"
    hint = "leave it out"


class MoreMistakes(Problem):
    """Than `listed`."""

    code = "E113"
    listed: int

    @property
    def message(self) -> str:
        return f"only the first {self.listed} mistakes of the file are listed"


class SaidTwice(Problem):
    """`clause`: the word that begins it, None for a requirement, which is only a text."""

    code = "E114"
    clause: str | None
    hint = "leave one out"

    @property
    def message(self) -> str:
        return f"{'the requirement' if self.clause is None else shown(self.clause)} is said twice"


class EmptyMultiplicity(Problem):
    code = "E115"
    least: int
    most: int

    @property
    def message(self) -> str:
        return f"no number of agents is from {self.least} to {self.most}"

    @property
    def hint(self) -> str:
        return f"write {self.most}..{self.least}" if self.most else "write 1, or a larger number"


class EmptyRange(Problem):
    """Of the agents of a team."""

    code = "E115"
    least: int
    most: int

    @property
    def message(self) -> str:
        return f"no agents are numbered from {self.least} to {self.most}"

    @property
    def hint(self) -> str:
        return f"write {self.most}..{self.least}"


class NotReadInTime(Problem):
    """`limit`: what it takes, as `longer than 2 s`."""

    code = "E116"
    limit: str
    hint = "it is read again when it is edited; please report the text"

    @property
    def message(self) -> str:
        return f"this was not read, because that takes {self.limit}; what is known of it is older"
