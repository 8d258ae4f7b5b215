"""Problems of names that are there: declared twice, reserved, or not what they are used as (E2xx, W2xx)."""

from __future__ import annotations

from typing import Literal, assert_never

from aseme_dsl.diagnostics.problem import Problem
from aseme_dsl.diagnostics.wording import a, did_you_mean, listed

# ---- E201 and E202: names that cannot be had ----------------------------------------------------


class DeclaredTwice(Problem):
    """`kind` says what the language calls it: `parameter`, `topic`."""

    code = "E201"
    kind: str
    name: str
    in_library: bool = False
    """Whether the first one is in the standard library, which stays as it is."""

    @property
    def message(self) -> str:
        return f"the {self.kind} `{self.name}` is declared twice"

    @property
    def hint(self) -> str:
        if self.in_library:
            return "rename this one: the other one belongs to the standard library"
        return "rename one of them, or remove it"


class CarriedTwice(DeclaredTwice):
    """A message that a topic carries twice as the same class (`kind`)."""

    @property
    def message(self) -> str:
        return f"on this topic, {self.kind} `{self.name}` is declared twice"


class SystemTwice(Problem):
    code = "E201"
    in_other_file: bool

    message = "a system is declared twice"

    @property
    def hint(self) -> str | None:
        if self.in_other_file:
            return "one of the imported files is a system of its own: move what both need into a third file"
        return None


class FunctionTwice(Problem):
    code = "E201"
    name: str
    parameters: tuple[str, ...]

    @property
    def message(self) -> str:
        return f"the function `{self.name}({', '.join(self.parameters)})` is declared twice"

    hint = "functions of one name differ in the types of their parameters"


class SameConstant(Problem):
    """Two names of constants that other languages could not tell apart."""

    code = "E201"
    name: str
    other: str

    @property
    def message(self) -> str:
        return f"`{self.name}` and `{self.other}` are the same constant to Protocol Buffers"

    hint = "it ignores case and underscores"


class SameField(Problem):
    """Two fields of one name in JSON."""

    code = "E201"
    name: str
    other: str
    in_json: str

    @property
    def message(self) -> str:
        return f"`{self.name}` and `{self.other}` are the same field to Protocol Buffers"

    @property
    def hint(self) -> str:
        return f"both are `{self.in_json}` in its JSON"


Reserved = Literal[
    "type",
    "word",
    "action",
    "class",
    "built in",
    "generated",
    "python",
    "variable",
    "let",
    "participant",
    "enum",
    "topic",
]
"""What has a name already, so that something else cannot have it."""


class ReservedName(Problem):
    """`kind` says what the language calls what is to have the name: `variable`, `topic`."""

    code = "E202"
    kind: str
    name: str
    reserved: Reserved

    @property
    def message(self) -> str:
        return f"{a(self.kind)} cannot be called `{self.name}`"

    @property
    def hint(self) -> str:
        reason = reserved_for(self.name, self.reserved)
        is_lower = self.kind == "field" and self.name.lower() == self.name
        return f"{reason}; `{self.name}_` is free" if is_lower else reason


def reserved_for(name: str, reserved: Reserved) -> str:
    """Why nothing else can have a name."""
    match reserved:
        case "type":
            return f"`{name}` is a type"
        case "word":
            return f"`{name}` is a word of the language"
        case "action":
            return f"`{name}` is an action"
        case "class":
            return f"`{name}` is a channel kind"
        case "built in":
            return f"`{name}` is built in"
        case "generated":
            return f"`{name}` means something else in the generated Python"
        case "python":
            return "it would be a name that Python, or the runtime, has for something else"
        case "variable" | "let" | "participant" | "enum" | "topic":
            return f"{a(reserved)} has this name"
        case _ as never:
            assert_never(never)


class VerbAsName(Problem):
    code = "E202"
    name: str

    @property
    def message(self) -> str:
        return f"`{self.name}` is a verb of `control`, which could not name it"

    @property
    def hint(self) -> str:
        return f"call it `{self.name.capitalize()}`"


class BoundTwice(Problem):
    """An activity of a protocol, for which a role binds two of its own."""

    code = "E206"
    abstract: str

    @property
    def message(self) -> str:
        return f"`{self.abstract}` is bound twice"


class BoundToExpression(Problem):
    code = "E206"
    abstract: str

    @property
    def message(self) -> str:
        return f"`{self.abstract}` is an activity: it can only be bound to an activity or a formula"


class BoundToParticipant(Problem):
    code = "E206"
    own: str

    @property
    def message(self) -> str:
        return f"`{self.own}` is a participant: a protocol's activity is bound to an activity or a formula"

    hint = "bind it to a formula that names the participant"


class UseCaseIncludesItself(Problem):
    """`circle` begins and ends with the same use case."""

    code = "E208"
    circle: tuple[str, ...]

    @property
    def message(self) -> str:
        return f"a use case cannot include itself: {' → '.join(self.circle)}"

    hint = "remove one of the inclusions"


# ---- E209 to E217: messages, enums, topics, functions and teams ---------------------------------


class MessageInItself(Problem):
    """`path` are the messages from it to itself."""

    code = "E209"
    path: tuple[str, ...]

    @property
    def message(self) -> str:
        return f"the message `{self.path[0]}` contains itself: {' → '.join(self.path)}"

    hint = "make the field `optional` or `repeated`"


class FirstConstantNotZero(Problem):
    code = "E210"
    number: int

    @property
    def message(self) -> str:
        return f"the first constant of an enum has the number 0, not {self.number}"

    hint = "it is the value of a message that says nothing"


class ConstantOutOfRange(Problem):
    code = "E210"
    number: int

    @property
    def message(self) -> str:
        return f"the number {self.number} is out of range"


class FieldOutOfRange(Problem):
    code = "E210"
    number: int
    largest: int

    @property
    def message(self) -> str:
        return f"the field number {self.number} is out of range"

    @property
    def hint(self) -> str:
        return f"1 to {self.largest}, but for 19000 to 19999, which Protocol Buffers keeps for itself"


class NumberTwice(Problem):
    """Of a constant or field."""

    code = "E210"
    kind: Literal["constant", "field"]
    name: str
    number: int
    other: str

    @property
    def message(self) -> str:
        what = f"the field `{self.name}`" if self.kind == "field" else f"`{self.name}`"
        return f"{what} has the number {self.number}, as `{self.other}` has"

    hint = "give it a number of its own, or leave the numbers out"


class TooManyRadioMessages(Problem):
    code = "E211"
    most: int

    @property
    def message(self) -> str:
        return f"more than {self.most} kinds of message travel by radio"


class InputNotSupplied(Problem):
    """A role plays a participant without a value for one of its inputs."""

    code = "E590"
    name: str
    type: str
    participant: str

    @property
    def message(self) -> str:
        return f"`{self.participant}` is given no `{self.name}`"

    @property
    def hint(self) -> str:
        return f"add `with {self.name} = …`, of type {self.type}"


class ResultNotVariable(Problem):
    """`known`: the variables that a result of this type could be given to."""

    code = "E591"
    result: str
    known: tuple[str, ...]

    @property
    def message(self) -> str:
        return f"the result `{self.result}` needs a variable"

    @property
    def hint(self) -> str:
        if self.known:
            return "variables of its type are " + ", ".join(f"`{name}`" for name in self.known)
        return "declare one: `var NAME : TYPE`"


class ResultOfOtherType(Problem):
    code = "E591"
    result: str
    type: str
    target: str

    @property
    def message(self) -> str:
        return f"the result `{self.result}` is of type {self.type}, and the variable of type {self.target}"


class InputFromSignal(Problem):
    code = "E592"
    name: str
    channel: str

    @property
    def message(self) -> str:
        return f"the input `{self.name}` reads the signal `{self.channel}`, which is consumed when it is read"

    hint = "store what the signal says in a variable, and give that"


class InputMadeAnew(Problem):
    code = "E592"
    name: str

    @property
    def message(self) -> str:
        return f"the input `{self.name}` is a message, which would be made anew at each look"

    hint = "keep it in a variable, and give that"


class OutcomeOfFormula(Problem):
    """The formula `own` shall stand for an activity of a protocol, of whose outcome the protocol asks."""

    code = "E593"
    activity: str
    own: str

    @property
    def message(self) -> str:
        return f"the protocol asks for the outcome of `{self.activity}`: the formula `{self.own}` has none"

    hint = "bind it to an activity that has this outcome"


class FormulaOfParticipant(Problem):
    """A participant lets its own formula `own` stand for an activity of another protocol."""

    code = "E593"
    activity: str
    own: str

    @property
    def message(self) -> str:
        return f"`{self.own}` is a formula: here only an activity can stand for `{self.activity}`"

    hint = "bind it to an activity of the participant; a role can bind that one to a formula"


class EmptyFormulaInLoop(Problem):
    """A formula stands for an activity that is repeated, and may be done at once."""

    code = "E593"
    activity: str
    own: str

    @property
    def message(self) -> str:
        return f"`{self.activity}` is repeated, and the formula `{self.own}` may be done without any activity"

    @property
    def hint(self) -> str:
        return f"let `{self.own}` have an activity in every case"


class ProtocolsInCircle(Problem):
    """`circle` begins and ends with the same protocol."""

    code = "E594"
    circle: tuple[str, ...]

    @property
    def message(self) -> str:
        return f"a conversation cannot contain itself: {' → '.join(self.circle)}"

    hint = "let one of these participants do without the other protocol, or let a role play both"


class DelayWithoutRadio(Problem):
    code = "E595"
    topic: str

    @property
    def message(self) -> str:
        return f"`{self.topic}` has a `delay`, but does not go by `radio`"

    @property
    def hint(self) -> str:
        return "remove `delay`: other messages carry the time at which they were sent"


_SIZES = "one byte says which message it is; a bool takes 1, an enum 1, an int 4, a double 4"


class UnfitForRadio(Problem):
    """`type` is that of the field which no radio message can have."""

    code = "E211"
    name: str
    field: str
    why: Literal["repeated", "recursive", "optional", "wide", "long"]
    type: str

    @property
    def message(self) -> str:
        return f"`{self.name}` cannot travel by radio because of `{self.field}`: {self._reason}"

    @property
    def _reason(self) -> str:
        match self.why:
            case "repeated":
                return "it is repeated"
            case "recursive":
                return f"`{self.type}` contains itself"
            case "optional":
                return "it is a message that may be absent"
            case "wide":
                return f"a number of `{self.type}` does not fit one byte"
            case "long":
                return f"{self.type} may be of any length"
            case _ as never:
                assert_never(never)

    @property
    def hint(self) -> str:
        return _SIZES


class TooLongForRadio(Problem):
    """`size` and `limit` are in bytes; `field` is the first that no longer fits."""

    code = "E211"
    name: str
    field: str
    size: int
    limit: int

    @property
    def message(self) -> str:
        fits = f"`{self.field}` no longer fits"
        return f"`{self.name}` takes {self.size} bytes of the radio's {self.limit}: {fits}"

    @property
    def hint(self) -> str:
        return _SIZES


class FormulaAmbiguous(Problem):
    code = "E213"
    name: str
    protocol: str

    @property
    def message(self) -> str:
        return f"`{self.name}` means several formulas of {self.protocol}"

    hint = "give the helper formulas names of their own"


class ParticipantNameTaken(Problem):
    """Two participants are played by one `name`; the first is `participant` of `protocol`."""

    code = "E213"
    name: str
    protocol: str
    participant: str

    @property
    def message(self) -> str:
        return f"`{self.name}` already stands for {self.protocol}.{self.participant} here"

    @property
    def hint(self) -> str:
        return f"give one of them another name: `plays … as other_{self.name}`"


class SeveralFunctions(Problem):
    code = "E213"
    name: str

    @property
    def message(self) -> str:
        return f"`{self.name}` means several functions here"

    hint = "write a decimal point where a double is meant"


class NoTarget(Problem):
    code = "E214"
    kind: Literal["function", "class"]
    target: str

    @property
    def message(self) -> str:
        return f"`{self.target}` does not say where the Python {self.kind} is"

    @property
    def hint(self) -> str:
        if self.kind == "function":
            return 'it is written "module:name", say "team.conditions:can_kick"'
        return 'write "module:Class", or leave it out: then it is found by the module\'s name'


class TooManyAgents(Problem):
    code = "E215"
    name: str
    first: int
    last: int
    most: int

    @property
    def message(self) -> str:
        return f"`{self.name}[{self.first}..{self.last}]` has more than {self.most} agents"


class NoConstants(Problem):
    code = "E216"
    enum: str

    @property
    def message(self) -> str:
        return f"`{self.enum}` has no constants"

    @property
    def hint(self) -> str:
        return f"list them in the braces: enum {self.enum} {{ FIRST SECOND }}"


class TopicBelowItself(Problem):
    """`path` are the topics from it up to itself."""

    code = "E217"
    path: tuple[str, ...]

    @property
    def message(self) -> str:
        return f"the topic `{self.path[-1]}` is below itself: {' under '.join(self.path)}"

    hint = "remove one `under`"


# ---- E221 to E224: roles that include others ----------------------------------------------------


class ChartIncluded(Problem):
    code = "E221"
    name: str

    @property
    def message(self) -> str:
        return f"`{self.name}` is a statechart, and only an `srm` can be included"

    hint = "what is to be shared is said by formulas in an `srm`"


class RoleInItself(Problem):
    """`path` are the roles from it to itself."""

    code = "E222"
    path: tuple[str, ...]

    @property
    def message(self) -> str:
        return f"a role cannot include itself: {' → '.join(self.path)}"

    hint = "put what both need into a third role, `abstract srm …`, and let both include that"


Part = Literal[
    "participant", "capability", "variable", "let", "formula", "module", "functionality", "control"
]
"""What roles take over from others."""


class IncludedTwice(Problem):
    """A part of a role that it has from `included`, and itself (`is_own`) or from another role."""

    code = "E223"
    role: str
    kind: Part
    name: str
    included: str
    is_own: bool

    @property
    def message(self) -> str:
        what = "the control of" if self.kind == "control" else f"the {self.kind}"
        owner = "its own text" if self.is_own else "another one"
        return f"`{self.role}` has {what} `{self.name}` from `{self.included}` and from {owner}"

    @property
    def hint(self) -> str:
        if self.kind == "formula":
            where = f"in `{self.included}`: then it is open there"
            return f"leave the formula out {where}; or rename one of them"
        return "what a role includes cannot be replaced: give one of them another name"


class AbstractRoleOfAgent(Problem):
    """`including` are the roles that include it."""

    code = "E224"
    role: str
    including: tuple[str, ...]

    @property
    def message(self) -> str:
        return f"`{self.role}` is abstract: no agent can have it alone"

    @property
    def hint(self) -> str:
        if self.including:
            return f"give the agent a role that includes it: {listed(self.including, 'or')}"
        return f"leave `abstract` out, or write a role with `includes {self.role}`"


# ---- E610 ---------------------------------------------------------------------------------------


class SetTwice(Problem):
    """A variable of an agent."""

    code = "E610"
    name: str

    @property
    def message(self) -> str:
        return f"`{self.name}` is set twice"

    hint = "leave one out"


# ---- W550 and W560 ------------------------------------------------------------------------------


class AbstractRoleUnused(Problem):
    code = "W550"
    role: str

    @property
    def message(self) -> str:
        return f"no role includes the abstract role `{self.role}`"

    @property
    def hint(self) -> str:
        return f"write `includes {self.role}` in a role, or leave `abstract` out"


class UseCaseRenamed(Problem):
    """`meant` is a protocol or formula that may be what nothing is called any more."""

    code = "W560"
    name: str
    kind: Literal["protocol", "formula"]
    meant: str

    @property
    def message(self) -> str:
        no_case = f"no use case is called like the {self.kind} `{self.meant}`"
        return f"nothing is called `{self.name}`, and {no_case}"

    @property
    def hint(self) -> str:
        same = f"call it so, too, or write `realises {self.meant}` behind the use case"
        return f"if it is the same: {same}; if not: write a use case for `{self.meant}`"


class RoleRenamed(Problem):
    """`meant` is a role that may be what the use cases call otherwise."""

    code = "W560"
    name: str
    meant: str

    @property
    def message(self) -> str:
        return f"there is no srm `{self.name}`, and the use cases do not name the role `{self.meant}`"

    @property
    def hint(self) -> str:
        other = f"write an srm for `{self.name}`, and name `{self.meant}` in the use cases"
        return f"if it is the same: call it so, too; if not: {other}"


# ---- E228: aliases of imports --------------------------------------------------------------------


class AliasTwice(Problem):
    code = "E228"
    alias: str

    @property
    def message(self) -> str:
        return f"two imports of this file have the alias `{self.alias}`"

    hint = "rename one of them"


class AliasIsName(Problem):
    code = "E228"
    alias: str

    @property
    def message(self) -> str:
        return f"the alias `{self.alias}` is the name of a declaration of this file"

    hint = "rename the alias"


class AliasOfProto(Problem):
    code = "E228"
    alias: str
    message = "a .proto file has no alias"

    @property
    def hint(self) -> str:
        return f"remove `as {self.alias}`: its messages have a package of their own"


class NoAlias(Problem):
    """`near` is the alias that is spelt alike, `known` are all of the file."""

    code = "E228"
    alias: str
    near: str | None
    known: tuple[str, ...]

    @property
    def message(self) -> str:
        return f"no import of this file has the alias `{self.alias}`"

    @property
    def hint(self) -> str:
        if self.near is not None:
            return did_you_mean(self.near)
        return f"write `as {self.alias}` behind the import of the file that is meant"


class NotBehindAlias(Problem):
    """`sort` says what is looked for; `near` is the name that is spelt alike."""

    code = "E228"
    alias: str
    sort: str
    name: str
    near: str | None
    known: tuple[str, ...]

    @property
    def message(self) -> str:
        return f"the file behind `{self.alias}` declares no {self.sort} `{self.name}`"

    @property
    def hint(self) -> str | None:
        if self.near is not None:
            return did_you_mean(self.near)
        return f"it declares {listed(self.known)}" if self.known else None


class OnlyBehindAlias(Problem):
    """`places`: the name with each alias behind which it is declared."""

    code = "E228"
    name: str
    places: tuple[str, ...]

    @property
    def message(self) -> str:
        return f"`{self.name}` is declared in a file that has an alias"

    @property
    def hint(self) -> str:
        return f"write {' or '.join(f'`{place}`' for place in self.places)}"
