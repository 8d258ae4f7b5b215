"""Problems of expressions: paths, assignments, events and questions about states (E43x, E50x, E51x, W50x)."""

from __future__ import annotations

from aseme_dsl.diagnostics.problem import Problem
from aseme_dsl.diagnostics.wording import carried_on, listed, there_are

# ---- E102 to E225 -------------------------------------------------------------------------------


class ActionCalled(Problem):
    """`read_messages` or `write_messages` with parentheses."""

    code = "E102"
    action: str

    @property
    def message(self) -> str:
        return f"`{self.action}` is written without parentheses"

    @property
    def hint(self) -> str:
        if self.action == "read_messages":
            return f"write `{self.action}`"
        return f"write `{self.action}.topic.kind.Message`"


class NestedTooDeep(Problem):
    """`depth` is that with the lets written out; None where even what is written is too deep."""

    code = "E103"
    depth: int | None
    limit: int

    @property
    def message(self) -> str:
        if self.depth is None:
            return f"an expression is not nested more than {self.limit} deep"
        nested = f"the expression is nested {self.depth} deep, with its lets written out"
        return f"{nested}; {self.limit} is the limit"


class TooManyParts(Problem):
    """With the lets written out."""

    code = "E304"
    size: int
    limit: int

    @property
    def message(self) -> str:
        has = f"the expression has {self.size} parts, with its lets written out"
        return f"{has}; {self.limit} is the limit"


class MemberFilledTwice(Problem):
    code = "E225"
    member: str

    @property
    def message(self) -> str:
        return f"`{self.member}` is filled twice"

    hint = "leave one of them out"


# ---- E431, E433 and W435: questions about states ------------------------------------------------


class CountOfSeveral(Problem):
    code = "E431"
    state: str
    places: int

    @property
    def message(self) -> str:
        return f"`{self.state}` stands in {self.places} places here, and each has its own count"

    hint = "give one of them a formula with a name of its own, and count that"


class StateAskedInAction(Problem):
    code = "E433"
    question: str

    @property
    def message(self) -> str:
        return f"`{self.question}` is asked in conditions: while actions run, states are left and entered"

    hint = "ask it in the condition, in two lines if need be"


class NeverDone(Problem):
    code = "W435"
    state: str

    @property
    def message(self) -> str:
        return f"`{self.state}` never completes, so that this is never true"

    hint = "ask `in(…)`, or let it end"


# ---- E501 to E503: paths ------------------------------------------------------------------------


class WholeParameter(Problem):
    code = "E501"
    name: str

    @property
    def message(self) -> str:
        return f"the parameter `{self.name}` is used as a whole"


class NotTheMessage(Problem):
    """A participant or type where the message that is taken, `called` otherwise, is meant."""

    code = "E502"
    name: str
    is_participant: bool
    called: str

    @property
    def message(self) -> str:
        return f"`{self.name}` is {'a participant' if self.is_participant else 'a type'}"

    @property
    def hint(self) -> str:
        return f"the message that is taken is `{self.called}`"


class MessageAsEnum(Problem):
    """`constants` of enums have the name that follows."""

    code = "E502"
    name: str
    constants: tuple[str, ...]

    @property
    def message(self) -> str:
        return f"`{self.name}` is a message, not an enum"

    @property
    def hint(self) -> str:
        return f"did you mean {listed(self.constants, 'or')}?"


class MessageWithoutTopic(Problem):
    """`channels` carry the message."""

    code = "E502"
    name: str
    channels: tuple[str, ...]

    @property
    def message(self) -> str:
        return f"`{self.name}` is a message: a topic and a class come before it"

    @property
    def hint(self) -> str:
        return carried_on(self.channels)


class PathWithoutMessage(Problem):
    """`channels` are those of the topic, each of which would complete the path."""

    code = "E502"
    path: str
    topic: str
    channels: tuple[str, ...]

    @property
    def message(self) -> str:
        return f"`{self.path}` names no message"

    @property
    def hint(self) -> str:
        return there_are(self.channels) if self.channels else f"`{self.topic}` carries nothing of the kind"


class NotAFunction(Problem):
    """`meant` is what is written instead, where that is known."""

    code = "E502"
    path: str
    meant: str | None = None

    @property
    def message(self) -> str:
        return f"`{self.path}` is not a function"

    @property
    def hint(self) -> str | None:
        return None if self.meant is None else f"write `{self.meant}`"


class PublishedForHost(Problem):
    code = "E502"
    host: str
    channel: str

    message = "`write_messages` names no host"

    @property
    def hint(self) -> str:
        alone = f"what was assigned with `{self.host}.` goes to {self.host} alone"
        return f"write `write_messages.{self.channel}`; {alone}"


class MemberPublished(Problem):
    code = "E502"
    channel: str

    message = "`write_messages` names no member"

    @property
    def hint(self) -> str:
        return f"write `write_messages.{self.channel}`; members are assigned before it"


class NewOnTopic(Problem):
    """`desk.signal.Order { id = 7 }`, where a value is wanted."""

    code = "E502"
    written: str
    type: str

    @property
    def message(self) -> str:
        return f"`{self.written}` is what has come on a topic, not the type of a new message"

    @property
    def hint(self) -> str:
        return f"write the type alone: `{self.type} {{ … }}`"


class ClassMissing(Problem):
    """`channels` are what may be meant."""

    code = "E503"
    channels: tuple[str, ...]

    message = "the channel kind is missing"

    @property
    def hint(self) -> str:
        return f"write {listed(self.channels, 'or')}"


class ClassAndMessageMissing(Problem):
    """`path` is what is meant."""

    code = "E503"
    path: str

    message = "the channel kind and the message are missing"

    @property
    def hint(self) -> str:
        return f"write `{self.path}`"


class OtherClass(Problem):
    """A message that the topic carries as `classes`, on `channels`, and not as `written`."""

    code = "E503"
    name: str
    topic: str
    written: str
    classes: tuple[str, ...]
    channels: tuple[str, ...]

    @property
    def message(self) -> str:
        return f"`{self.name}` is on `{self.topic}` as {listed(self.classes)}, not as `{self.written}`"

    @property
    def hint(self) -> str:
        return f"write {listed(self.channels, 'or')}"


class NotQueued(Problem):
    code = "E503"
    kind: str

    @property
    def message(self) -> str:
        return f"a {self.kind} is never queued"

    hint = "only signals wait in a queue"


class NotExpiring(Problem):
    code = "E503"
    kind: str

    @property
    def message(self) -> str:
        if self.kind == "signal":
            return "a signal that expires after no time is never read"
        return f"a {self.kind} does not expire"

    @property
    def hint(self) -> str:
        if self.kind == "signal":
            return "write a longer time"
        return "a condition can ask for its age: `age(…) < 2s`"


class NotKept(Problem):
    code = "E503"
    kind: str

    @property
    def message(self) -> str:
        return f"a {self.kind} does not persist"

    hint = "only states are kept"


class SignalAge(Problem):
    code = "E503"
    message = "a signal has no age: it is consumed by its reader"


class AgeFromArrival(Problem):
    """A message that goes by radio has no time, and its topic does not say how long it is on its way."""

    code = "N771"
    topic: str
    hint = "add the longest delay of the radio to the topic, such as `delay 200ms`"

    @property
    def message(self) -> str:
        return f"the age of a message on `{self.topic}` counts from its arrival"


class NoHistory(Problem):
    """`form` looks back on a channel of a `kind` that is not kept."""

    code = "E503"
    form: str
    channel: str
    kind: str

    @property
    def message(self) -> str:
        return f"`{self.form}` needs a history, which only data has; `{self.channel}` is a {self.kind}"


# ---- E507: what cannot be assigned to -----------------------------------------------------------


class ParameterAssigned(Problem):
    code = "E507"
    name: str

    @property
    def message(self) -> str:
        return f"`{self.name}` is a parameter: nothing can be written to it"

    hint = "it stands for what the formula is given"


class LetAssigned(Problem):
    code = "E507"
    name: str

    @property
    def message(self) -> str:
        return f"`{self.name}` is a let: it has no value of its own"

    hint = "a variable (`var`) can be assigned to"


class ConstantAssigned(Problem):
    code = "E507"
    path: str

    @property
    def message(self) -> str:
        return f"`{self.path}` is a constant"


class MemberChanged(Problem):
    """`sign` is `+=` or another of its kind."""

    code = "E507"
    sign: str

    @property
    def message(self) -> str:
        return (
            f"'{self.sign}' changes a variable, and this is a member of a message that is yet to be published"
        )

    hint = "write '=' and the whole value"


class MessageAssigned(Problem):
    """It is a member of another."""

    code = "E507"
    message = "a message inside a message is not assigned to"
    hint = "assign to its members one by one"


class MemberOfVariable(Problem):
    """`order.count = 1`: `type` is the message that the variable, or an element of the list, holds."""

    code = "E507"
    name: str
    type: str

    @property
    def message(self) -> str:
        return f"the message in `{self.name}` does not change"

    @property
    def hint(self) -> str:
        return f"put another {self.type} in its place: `{self.name} = {self.type} {{ …, ..{self.name} }}`"


class OptionalAssigned(Problem):
    """A member of an optional message, which a draft does not have."""

    code = "E507"
    name: str
    is_sent: bool

    @property
    def message(self) -> str:
        return f"`{self.name}` is optional and not there in a new message"

    @property
    def hint(self) -> str:
        return f"an activity can {'send' if self.is_sent else 'publish'} the message with it"


# ---- E508 to E517 -------------------------------------------------------------------------------


class EnumAsValue(Problem):
    """`constant` is one of the enum."""

    code = "E508"
    enum: str
    constant: str | None

    @property
    def message(self) -> str:
        return f"`{self.enum}` is an enum, not one of its constants"

    @property
    def hint(self) -> str | None:
        return None if self.constant is None else f"write `{self.enum}.{self.constant}`, say"


class LetInItself(Problem):
    """`path` are the lets from it to itself."""

    code = "E510"
    path: tuple[str, ...]

    @property
    def message(self) -> str:
        return f"a `let` refers to itself: {' → '.join(self.path)}"

    hint = "a `let` stands for an expression; a value that changes is a variable (`var`)"


class InitialNotConstant(Problem):
    code = "E514"
    message = "an initial value must be a constant"
    hint = "this is known only at run time: assign it in an action"


class SettingNotConstant(Problem):
    code = "E514"
    message = "what is set in an agent must be a constant"
    hint = "write a constant; it may be computed from `index`"


class ValueAsEvent(Problem):
    code = "E517"
    name: str

    @property
    def message(self) -> str:
        return f"`{self.name}` is a value, not an event"

    @property
    def hint(self) -> str:
        return f"write `[{self.name}]`; a name without brackets is an event that an activity raises"


class NotRaised(Problem):
    """`raise` with a name that no event can have."""

    code = "E517"
    name: str
    is_value: bool = False

    @property
    def message(self) -> str:
        if self.is_value:
            return f"`{self.name}` is a value, and cannot be raised as an event"
        return f"`{self.name}` cannot be raised: it is not the name of an event of one's own"

    hint = "use a name that means nothing else"


class EventLikeValue(Problem):
    """An event whose name is spelt like that of a `value`."""

    code = "W424"
    name: str
    value: str

    @property
    def message(self) -> str:
        return f"`{self.name}` is an event that an activity has to raise"

    @property
    def hint(self) -> str:
        return f"if the value `{self.value}` is meant, write `[{self.value}]`"


class ValueDropped(Problem):
    code = "W500"
    is_comparison: bool

    message = "the value is computed and dropped"

    @property
    def hint(self) -> str:
        return "`=` assigns" if self.is_comparison else "assign it to a variable, or remove it"


class AssignedItself(Problem):
    code = "W500"
    name: str

    @property
    def message(self) -> str:
        return f"`{self.name}` is given the value that it has"

    hint = "leave it out"
