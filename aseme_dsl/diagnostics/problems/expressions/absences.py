"""Absences in expressions: names that are none of those that can stand there, in the order of their codes."""

from __future__ import annotations

from typing import Literal, assert_never

from aseme_dsl.diagnostics.problem import Problem
from aseme_dsl.diagnostics.problems.absences import Absent, Importable, NoTopic, Unknown
from aseme_dsl.diagnostics.wording import a, carried_on, listed

Meant = Literal["constant", "variable", "participant", "nothing", "topic", "message", "function"]
"""The thing that has the name, if the name is not a value."""
SIZES = ("len", "length")
"""How other languages call `size`."""
MemberlessKind = Literal["", "variable", "let", "constant", "list"]


class NoAction(Absent):
    code = "E200"
    what = "there is no action"


class NoVariable(Absent):
    """`channel` is where a message of this name is carried."""

    code = "E200"
    what = "there is no variable"
    is_topic: bool = False
    channel: str | None = None

    @property
    def is_elsewhere(self) -> bool:
        return self.close is None and (self.is_topic or self.channel is not None)

    @property
    def advice(self) -> str:
        if self.is_topic:
            return f"it is a topic: name the message, `{self.name}.state.Message`"
        if self.channel is not None:
            return f"it is a message: `{self.channel}`"
        return "an activity writes a variable of its role or `topic.state.Message`"


class NoVariableOrLet(Importable):
    code = "E200"
    what = "there is no variable or let"
    advice = "declare it"


class NotAValue(NoVariableOrLet):
    """The name of something else; `places` are its constants, its owners or its channels."""

    meant: Meant = "nothing"
    places: tuple[str, ...] = ()

    @property
    def is_elsewhere(self) -> bool:
        return self.meant not in ("nothing", "message")

    @property
    def message(self) -> str:
        if self.meant == "message":
            return f"`{self.name}` is the name of a message, not a value"
        return super().message

    @property
    def certain(self) -> str:
        match self.meant:
            case "constant":
                return f"a constant is written with its enum: {listed(self.places, 'or')}"
            case "variable":
                return f"it is a variable of {listed(self.places)}: each participant sees its own"
            case "participant":
                return "it is a participant; one agent of it is the `sender(…)` of a message that it has sent"
            case "nothing":
                return "ask `!has(now)` whether a message is not there; `clear(now)` empties a variable"
            case "topic":
                return f"it is a topic: `{self.name}.state.Message.member` reads from it"
            case "message":
                new = f"a new one is `{self.name} {{ .. }}`"
                return f"{new}; {carried_on(self.places)}" if self.places else new
            case "function":
                return f"it is a function: `{self.name}(…)` calls it"
            case _ as never:
                assert_never(never)


class NoStateAsked(Unknown):
    code = "E430"
    advice = "ask for a formula, an activity or a played participant of this role"
    chart: str

    @property
    def message(self) -> str:
        return f"{self.chart} has no state `{self.name}`"


class NoMember(Absent):
    code = "E501"
    owner: str

    @property
    def message(self) -> str:
        return f"`{self.owner}` has no member `{self.name}`"


class NoMembers(Absent):
    """A member of what has none; `owner` is a `kind` called so, and of this type."""

    code = "E501"
    kind: MemberlessKind
    owner: str
    type: str = ""
    hides_topic: bool = False

    @property
    def message(self) -> str:
        match self.kind:
            case "":
                return f"`{self.owner}` is {a(self.type)}: it has no members"
            case "variable" | "let":
                return f"the {self.kind} `{self.owner}` is {a(self.type)}: it has no members"
            case "constant":
                return "a constant has no members"
            case "list":
                return f"`{self.owner}` is a list: it has no members"
            case _ as never:
                assert_never(never)

    @property
    def hint(self) -> str | None:
        if self.kind == "list":
            last = self.owner.rpartition(".")[2]
            first = f"take one of its elements: `{last}[0].{self.name}` for the first"
            return f"{first}; `find(….{last}.{self.name}, v)` looks for one"
        if self.type.startswith("list of ") and self.kind == "variable" and self.name in (*SIZES, "size"):
            return f"write `size({self.owner})`"
        if self.type.startswith("list of ") and self.kind in ("variable", "let"):
            of_one = f"of one element it is `{self.owner}[0].{self.name}`"
            return f"{of_one}; `find({self.owner}.{self.name}, v)` looks for the element"
        if self.hides_topic:
            return f"the variable hides the topic `{self.owner}`: call it something else"
        return None


class NoFunction(Importable):
    code = "E502"
    what = "there is no function"
    advice = "declare it, or import the file that does"


class EventAsFunction(Problem):
    """An event with the name of a function, such as `after(5s)`, in a condition."""

    code = "E502"
    event: str

    @property
    def message(self) -> str:
        return f"`{self.event}(…)` is an event, not a part of a condition"

    @property
    def hint(self) -> str:
        return f"write it before the condition: `{self.event}(…) [ … ]`; to leave on either, write two lines"


class NoTopicOfPath(NoTopic):
    advice = "declare it"


class NoTopicToRead(NoTopic):
    """`meant` is what else has this name; a message may be carried on `channel`."""

    meant: Literal["message", "let"] | None = None
    channel: str | None = None

    @property
    def is_elsewhere(self) -> bool:
        return self.meant is not None

    @property
    def certain(self) -> str | None:
        match self.meant:
            case "message":
                return "it is a message" if self.channel is None else f"it is a message: `{self.channel}`"
            case "let":
                return "it is a let: say what it reads instead"
            case None:
                return super().certain
            case _ as never:
                assert_never(never)


class NoBeginning(Importable):
    """The first name of a path; `is_bound` where another line takes a message under this name."""

    code = "E502"
    what = "there is no topic, variable, let or enum"
    advice = "a message is read as `topic.state.Message.member`"
    is_bound: bool = False

    @property
    def certain(self) -> str | None:
        if self.is_bound:
            line = "the line that takes the message"
            return f"`{self.name}` is known only in {line}: keep what is needed in a variable"
        return super().certain


class NoMessageOfTopic(Importable):
    code = "E502"
    topic: str

    @property
    def message(self) -> str:
        return f"the topic `{self.topic}` carries no message `{self.name}`"


class NotCarried(Absent):
    """A message that is there, but not on this topic: it is on `others`."""

    code = "E502"
    topic: str

    @property
    def message(self) -> str:
        return f"the topic `{self.topic}` does not carry `{self.name}`"

    @property
    def hint(self) -> str:
        return carried_on(self.others)


class NoConstant(Absent):
    """`namesakes` are constants of other enums."""

    code = "E508"
    enum: str
    namesakes: tuple[str, ...] = ()

    @property
    def message(self) -> str:
        return f"`{self.enum}` has no constant `{self.name}`"

    @property
    def certain(self) -> str | None:
        return f"it is one of another enum: {listed(self.namesakes, 'or')}" if self.namesakes else None


class NoAgent(Absent):
    code = "E513"
    what = "there is no agent"


class NoHost(NoAgent):
    """Before a topic."""

    is_participant: bool = False
    has_team: bool = True
    """Whether the system has one."""

    @property
    def is_elsewhere(self) -> bool:
        return self.close is None and self.is_participant

    @property
    def advice(self) -> str:
        if self.is_participant:
            return "it is a participant; senders are the agents of the team"
        if not self.has_team:
            return "senders are the agents of a team: declare one with a `team`"
        return "a field path is `sender.topic.kind.Message.field`, and senders are the agents of the team"


class NoOutcomes(Absent):
    code = "E520"

    @property
    def message(self) -> str:
        return f"the activity `{self.name}` has no outcomes"

    @property
    def hint(self) -> str:
        return f"say them among the `activities` of a role: `{self.name} ends done, failed`"


class NoActivityWithOutcomes(Unknown):
    code = "E520"
    what = "no activity has outcomes and is called"

    @property
    def advice(self) -> str:
        return f"say them among the `activities` of a role: `{self.name} ends done, failed`"


class NoReasonOfLoss(Unknown):
    """`reasons` are all there are."""

    code = "E520"
    reasons: tuple[str, ...]

    @property
    def message(self) -> str:
        return f"`{self.name}` is not a reason of a loss"

    @property
    def advice(self) -> str:
        return f"reasons are {listed(self.reasons)}"


class NoOutcome(Unknown):
    """`ends` are the outcomes of the activity in the order in which they are declared."""

    code = "E520"
    activity: str
    ends: tuple[str, ...]

    @property
    def message(self) -> str:
        return f"`{self.activity}` does not end `{self.name}`"

    @property
    def advice(self) -> str:
        return f"it ends {listed(self.ends, 'or')}"
