"""Formulas and expressions that cannot be read (E101, E102, E107), in the order of their codes."""

from __future__ import annotations

from aseme_dsl.diagnostics.problem import Problem
from aseme_dsl.diagnostics.problems.syntax.entries import Signs, Unexpected
from aseme_dsl.diagnostics.wording import did_you_mean, shown

_LONGEST = 60
"""How long what a hint writes again is at most."""

# ---- E101: formulas ----------------------------------------------------------------------------


class UnexpectedInFormula(Unexpected):
    code = "E101"
    whole = "formula"


class OptionAsInPatterns(UnexpectedInFormula):
    """`A?`"""

    @property
    def hint(self) -> str:
        if self.found is None:
            return "write [A] for an option"
        return "write [A] for an option; '?' stands between two terms for an operator still to be chosen"


class TwoOperators(UnexpectedInFormula):
    hint = "one of the two operators is too much, or a name is missing between them"


class EmptyBrackets(UnexpectedInFormula):
    hint = "put an activity between the brackets"


class OperatorOfOthersFirst(UnexpectedInFormula):
    """`meant`: what it may stand for."""

    meant: Signs

    @property
    def hint(self) -> str:
        return _instead(self.meant)


class OperatorOfOthers(Problem):
    """`meant`: what it may stand for."""

    code = "E101"
    sign: str
    meant: Signs

    @property
    def message(self) -> str:
        return f"{shown(self.sign)} is not an operator of formulas"

    @property
    def hint(self) -> str:
        return _instead(self.meant)


def _instead(meant: Signs) -> str:
    """What to write instead of an operator that the language does not have; `=` stands for none."""
    if not meant:
        return "is a name missing before '='?"
    return "write " + ", ".join(f"'{sign}' for {meaning}" for sign, meaning in meant)


class NoOperator(Problem):
    """`usual`: the operators that are named."""

    code = "E101"
    sign: str
    usual: Signs

    @property
    def message(self) -> str:
        return f"{shown(self.sign)} is not an operator of formulas"

    @property
    def hint(self) -> str:
        return _operators(self.usual)


def _operators(usual: Signs) -> str:
    return ", ".join(f"'{sign}' {meaning}" for sign, meaning in usual).replace(" ", " is ", 1)


class HyphenInOperand(Problem):
    code = "E101"
    before: str
    after: str
    message = "'-' is not an operator of formulas"

    @property
    def hint(self) -> str:
        return f"names are written with '_': {self.before}_{self.after}"


class NothingOpened(Problem):
    """A `)` or `]`."""

    code = "E101"
    closing: str

    @property
    def message(self) -> str:
        opening = "(" if self.closing == ")" else "["
        return f"{shown(self.closing)} closes nothing: there is no '{opening}' before it"


class OperatorMissing(Problem):
    """`usual`: the operators that are named; `begins_formula`: `found` may be the name of the next one."""

    code = "E101"
    before: str
    found: str
    usual: Signs
    begins_formula: bool

    @property
    def message(self) -> str:
        return f"an operator is missing between {shown(self.before)} and {shown(self.found)}"

    @property
    def hint(self) -> str:
        hint = _operators(self.usual)
        if self.begins_formula:
            hint += f"; a formula begins with 'NAME =': is '=' missing after {shown(self.found)}?"
        return hint


class OperatorBeforeBracket(Problem):
    """`A [B]`; `name` stands for the operand before it, `inside` for what the brackets hold."""

    code = "E101"
    before: str
    name: str
    inside: str

    @property
    def message(self) -> str:
        return f"an operator is missing between {shown(self.before)} and '['"

    @property
    def hint(self) -> str:
        return (
            f"write '{self.name} . [{self.inside}]' for an option that follows, "
            f"'{self.name}[3]' for three instances"
        )


class BlankInInterrupt(Problem):
    """`A [ > B`"""

    code = "E101"
    before: str
    hint = "one that cuts the other short is written with '[>', without a blank"

    @property
    def message(self) -> str:
        return f"an operator is missing between {shown(self.before)} and '['"


class BarsWithoutNumber(Problem):
    """`|A`, and what is `found` instead of the second bar, None at the end."""

    code = "E101"
    found: str | None
    hint = "three instances of A are written |A|3, or A[3]"

    @property
    def message(self) -> str:
        also = f", or '|' and a number before {shown(self.found)}" if self.found is not None else ""
        return f"expected an activity before '|'{also}"


class EmptyArguments(Problem):
    code = "E101"
    activity: str
    message = "there is nothing between the parentheses"

    @property
    def hint(self) -> str:
        return f"without arguments it is written `{self.activity}`"


# ---- E102: expressions -------------------------------------------------------------------------


class UnexpectedInExpression(Unexpected):
    """`verb`: the verb of control lines that `found` may be meant to be."""

    code = "E102"
    whole = "expression"
    verb: str | None = None

    @property
    def hint(self) -> str | None:
        return did_you_mean(self.verb) if self.verb is not None else None


class OperatorOfOtherLanguages(UnexpectedInExpression):
    """`&`, `|`, `=`, `AND`, `OR`, `^` and `?`."""

    @property
    def hint(self) -> str:
        return _OPERATORS_OF_OTHERS[(self.found or "").lower()]


_OPERATORS_OF_OTHERS = {
    "&": "'&&' is and",
    "|": "'||' is or",
    "=": "write '==' to compare",
    "and": "write && for and",
    "or": "write || for or",
    "^": "there is no power; multiply, or call a function",
    "?": "only a value is chosen so: n = c ? a : b; for actions write two entries",
}


class AgentsBehindQuestion(UnexpectedInExpression):
    """`a : r with n = c ? near : far`: `near :` begins other agents. `name` is `near`."""

    name: str = ""

    @property
    def hint(self) -> str:
        return f"a name and ':' begin the next agents: write ({self.name}) for the value"


class NumberWithoutNought(UnexpectedInExpression):
    """`.7`; `number` is `0.7`."""

    number: str = ""

    @property
    def hint(self) -> str:
        return f"write {self.number}"


class MessageLikeCall(UnexpectedInExpression):
    """`Order(id = 7)`"""

    hint = "a new message has its members in braces: `Order { id = 7, .. }`"


class ChangeInCondition(UnexpectedInExpression):
    """`[hp -= 1]`"""

    @property
    def hint(self) -> str:
        return f"write '==' to compare; a change stands behind '/': / {self.after} {self.found} …"


class CountedUp(Problem):
    """`n++` and `n--`, by their name and sign."""

    code = "E102"
    name: str
    sign: str

    @property
    def message(self) -> str:
        return f"there is no '{self.sign}{self.sign}'"

    @property
    def hint(self) -> str:
        return f"write {self.name} {self.sign}= 1"


class ActionChosen(UnexpectedInExpression):
    """`/ c ? x = 1 : x = 2`"""

    @property
    def hint(self) -> str:
        return f"a value is chosen, not an action: / {self.after} = c ? a : b; or write two entries"


class ComparisonOfOthers(UnexpectedInExpression):
    """`=<`, `<=>` or `===`"""

    hint = "comparisons are written < <= > >= == !="


class AfterWithoutParentheses(UnexpectedInExpression):
    """`after 5s`"""

    @property
    def hint(self) -> str:
        return f"write after({self.found})"


class ConditionOfOneEvent(UnexpectedInExpression):
    """`a [x] or b`"""

    hint = "the condition stands behind all events; where it is for one of them, write an entry for each"


class ReservedWord(UnexpectedInExpression):
    @property
    def hint(self) -> str:
        return f"{shown(self.found or '')} cannot be a name here"


class HyphenInOperandName(UnexpectedInExpression):
    """`rest` is what stands behind the `-`."""

    rest: str = ""

    @property
    def hint(self) -> str:
        return f"names are written with '_': {self.after}_{self.rest}"


class BlankBeforeUnitOfEvent(UnexpectedInExpression):
    @property
    def hint(self) -> str:
        return f"write {self.after}{self.found} without a blank"


class TypeBeforeName(UnexpectedInExpression):
    """`int rounds`"""

    name: str = ""

    @property
    def hint(self) -> str:
        return f"write var {self.name} : {self.found}"


class MisspeltFrom(UnexpectedInExpression):
    hint = "did you mean 'from'?"


class MemberWithoutValue(UnexpectedInExpression):
    @property
    def hint(self) -> str:
        return f"write {self.after} = …"


class RestWithoutComma(UnexpectedInExpression):
    """`{ id = 3 .. }`: `rest` is what begins with the dots."""

    rest: str = ".."

    @property
    def hint(self) -> str:
        return f"write ',' before it: {self.after}, {self.rest}"


class RestOutsideBraces(UnexpectedInExpression):
    """`now = ..other`, and `Order { place = ..other }`"""

    hint = "leave it out: only the members of another message follow '..', as in `Order { id = 7, ..other }`"


class ReplyByBehindReceiver(UnexpectedInExpression):
    """`send cfp Task { .. } to bidder reply_by 2s`"""

    hint = "write it before the receiver: `reply_by … to …`"


class MemberOfNewMessage(UnexpectedInExpression):
    """`Order { id = 7, .. }.id`"""

    message = "no member of a new message is read"
    hint = "use the value itself, or assign the message to a variable and ask for its member"


class RestNotLast(UnexpectedInExpression):
    """`{ ..m, id = 3 }`: `rest` is what begins with the dots."""

    rest: str = ".."

    @property
    def hint(self) -> str:
        return f"'{self.rest}' stands at the end, after all members"


class RestOfPublished(UnexpectedInExpression):
    """`write_messages.t.state.M { .. }`"""

    hint = "'..' is for agent messages: here, members that are not named keep their values"


class SendWithoutMessage(UnexpectedInExpression):
    """`send inform { … }`"""

    hint = "send inform Done { … } to …"


class PublishWithoutChannel(Problem):
    code = "E102"
    message = "expected '.topic.kind.Message' after 'write_messages'"
    hint = "write_messages.team.state.Assignment"


class MemberWithColon(Problem):
    code = "E102"
    message = "a member is filled with '='"
    hint = "write = for :"


class MemberWithBraces(Problem):
    """`Order { id = 1, place { x = 3 } }`"""

    code = "E102"
    member: str
    message = "a member is filled with '='"

    @property
    def hint(self) -> str:
        return f"write `{self.member} = Message {{ ... }}`, with the type of `{self.member}` for `Message`"


class NewBeforeMessage(Problem):
    code = "E102"
    message = "'new' is not a word of the language"
    hint = "write the message alone: `Order { id = 7, .. }`"


class ContentWithoutMessage(Problem):
    code = "E102"
    message = "no message stands before '{'"
    hint = "write the name of its type before '{', as `Order { id = 7, .. }` does"


class ContentNotClosed(Problem):
    """`last`: the last word of what stands in the braces."""

    code = "E102"
    last: str
    hint = "write '}'"

    @property
    def message(self) -> str:
        return f"expected '}}' after {shown(self.last)}"


class EntryWithoutColon(Problem):
    """A verb of control lines in an expression; `found` stands instead of its `:`, if anything."""

    code = "E102"
    verb: str
    after: str
    found: str | None

    @property
    def message(self) -> str:
        rest = "" if self.found is None else f", found {shown(self.found)}"
        return f"expected ':' after {shown(self.after)}{rest}"

    @property
    def hint(self) -> str:
        if self.verb == "resume":
            return "write resume TERM :"
        if self.verb == "exit":
            return "write exit TERM : / actions"
        return f"write {self.verb} TERM : event [condition] / actions"


class ElseWithCondition(Problem):
    code = "E102"
    message = "'else' stands for a condition: it cannot have one"
    hint = "leave 'else' out"


class WeightNotWhole(Problem):
    code = "E102"
    message = "a weight is a whole number above 0"
    hint = "write for example 'weight 3'"


class ActionWithoutSlash(Problem):
    code = "E102"
    action: str
    hint = "write / before actions"

    @property
    def message(self) -> str:
        return f"{shown(self.action)} is an action: '/' is missing before it"


class AssignmentWithoutSlash(Problem):
    code = "E102"
    message = "an assignment is an action: '/' is missing before it"
    hint = "write / before actions"


class NotAssignable(Problem):
    """`sign` is `=`, or one that changes a variable."""

    code = "E102"
    sign: str

    @property
    def message(self) -> str:
        what = "a variable or a member of a message" if self.sign == "=" else "a variable"
        return f"only {what} can stand left of '{self.sign}'"


class NameBehindFrom(Problem):
    """`inform Done from a as d`"""

    code = "E102"
    performative: str
    message_type: str
    name: str
    participant: str
    message = "the name of a message stands before 'from'"

    @property
    def hint(self) -> str:
        return f"write {self.performative} {self.message_type} {self.name} from {self.participant}"


class BareCondition(Problem):
    """`meant`: the condition with its brackets."""

    code = "E102"
    meant: str
    message = "a condition stands in '[' and ']'"

    @property
    def hint(self) -> str | None:
        return f"write {self.meant}" if len(self.meant) < _LONGEST and "\n" not in self.meant else None


class ConditionWithIf(Problem):
    """`meant`: with brackets, what stands without them behind `if`, if it does."""

    code = "E102"
    meant: str | None
    message = "a condition stands in '[' and ']', without 'if'"

    @property
    def hint(self) -> str | None:
        return BareCondition(self.meant).hint if self.meant is not None else None


class BracketMissingBefore(Problem):
    """The `[` of a condition, before the word `first`."""

    code = "E102"
    first: str

    @property
    def message(self) -> str:
        return f"'[' is missing before {shown(self.first)}"


class EventBehindWord(Problem):
    """`when stop` or `on stop`, as other languages write the event `stop`."""

    code = "E102"
    word: str
    event: str

    @property
    def message(self) -> str:
        return f"an event is written without {shown(self.word)}"

    @property
    def hint(self) -> str:
        return f"write {self.event}; a condition stands in '[' and ']'"


class EventNamedLikeVerb(Problem):
    """`raise start`: `start` is read as the next control line."""

    code = "E102"
    word: str

    @property
    def message(self) -> str:
        return f"{shown(self.word)} begins a control line and cannot be the name of an event"

    hint = "give the event another name"


# ---- E107: what can be read in two ways --------------------------------------------------------


class NegatedComparison(Problem):
    """`!operand == …`"""

    code = "E107"
    operand: str
    operator: str

    @property
    def message(self) -> str:
        return f"'!' before {shown(self.operator)} can be read in two ways"

    @property
    def hint(self) -> str:
        return f"write !({self.operand} {self.operator} …) or (!{self.operand}) {self.operator} …"


class ChainedComparisons(Problem):
    """`left first middle second …`, where `left` is the whole of the first comparison."""

    code = "E107"
    left: str
    middle: str
    first: str
    second: str

    @property
    def message(self) -> str:
        return f"comparisons do not chain: {shown(self.first)} and {shown(self.second)} need parentheses"

    @property
    def hint(self) -> str | None:
        if len(self.left) >= _LONGEST:
            return None
        return f"write {self.left} && {self.middle} {self.second} …"


# ---- E118: expressions of KSE ------------------------------------------------------------------


class ForeignExpression(Problem):
    """`now`: what says the same here, None for the `reason` why nothing does."""

    code = "E118"
    now: str | None
    reason: str
    message = "this is an expression of KSE"

    @property
    def hint(self) -> str:
        return f"here it is {self.now}" if self.now is not None else f"say it anew: {self.reason}"
