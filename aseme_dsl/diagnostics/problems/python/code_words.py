"""Words of code: the names that the Python code of activities uses (E546, W53x to W55x).

Fields that several classes have:

- `what` is "activity" or "module".
- A channel is written `topic.kind.Message`, an agent message as its performative and type.
- `near` is a name with a similar spelling, or None.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal, assert_never

from aseme_dsl.diagnostics.problem import Problem
from aseme_dsl.diagnostics.wording import called_now, did_you_mean, listed

Found = Literal["message", "class of message", "other class", "value"]
"""What may be published instead of a message that a channel carries."""

# ---- E546, W530: what `execute` takes and returns -------------------------------------------------


class ExecuteTakesNoContext(Problem):
    """`parameters` are those that `execute` has to have, of all problems of its parameters."""

    code = "E546"
    parameters: tuple[str, ...]

    message = "`execute` takes no context, and is called with one"

    @property
    def hint(self) -> str:
        return _signature(self.parameters)


class ByPlaceOnly(Problem):
    code = "E546"
    parameter: str
    parameters: tuple[str, ...]

    @property
    def message(self) -> str:
        return f"`execute` takes `{self.parameter}` by its place only, and is called with it by its name"

    @property
    def hint(self) -> str:
        return f"{_signature(self.parameters)}, without `/`"


class ParameterNotTaken(Problem):
    """`taken` is the parameter that is spelt alike."""

    code = "E546"
    activity: str
    parameter: str
    taken: str | None
    parameters: tuple[str, ...]

    @property
    def message(self) -> str:
        return f"`{self.activity}` is given `{self.parameter}`, which its `execute` does not take"

    @property
    def hint(self) -> str:
        if self.taken is not None:
            return f"did you mean `{self.parameter}` where it takes `{self.taken}`?"
        return _signature(self.parameters)


class ParameterNotGiven(Problem):
    code = "E546"
    what: str
    activity: str
    parameter: str

    @property
    def message(self) -> str:
        return f"`execute` takes `{self.parameter}`, which `{self.activity}` is not given"

    @property
    def hint(self) -> str:
        if self.what == "activity":
            return f"say so among the activities, `{self.activity}({self.parameter} : …)`, or leave it out"
        return f"leave it out: a {self.what} is given nothing"


class PerhapsByPlaceOnly(ByPlaceOnly):
    """Of an `execute` with a decorator, as the next two."""

    code = "W530"


class ParameterPerhapsNotTaken(ParameterNotTaken):
    code = "W530"


class ParameterPerhapsNotGiven(ParameterNotGiven):
    code = "W530"


class OutcomeNotReturned(Problem):
    code = "W530"
    activity: str
    outcomes: tuple[str, ...]

    @property
    def message(self) -> str:
        return f"`{self.activity}` has to say how it ends: {_one_of(self.outcomes)}"

    @property
    def hint(self) -> str:
        return f'return "{self.outcomes[0]}", say'


class OutcomeNotOfActivity(Problem):
    code = "W530"
    activity: str
    outcome: str
    near: str | None
    outcomes: tuple[str, ...]

    @property
    def message(self) -> str:
        return f"`{self.activity}` does not end `{self.outcome}`"

    @property
    def hint(self) -> str:
        return did_you_mean(self.near) if self.near is not None else f"it ends {_one_of(self.outcomes)}"


# ---- W530: names that are not there ----------------------------------------------------------------


class _Unknown(Problem):
    """`name` is nothing of what can stand there."""

    code = "W530"
    name: str
    near: str | None

    @property
    def hint(self) -> str | None:
        return None if self.near is None else did_you_mean(self.near)


class NoMethodOfContext(_Unknown):
    """`now` is today's name of what was renamed."""

    now: str | None = None

    @property
    def message(self) -> str:
        return f"a context has no `{self.name}`"

    @property
    def hint(self) -> str | None:
        return called_now(self.now) if self.now is not None else super().hint


class NoArgumentOfMethod(Problem):
    """Of a method of the context; `now` is today's name of what was renamed."""

    code = "W530"
    method: str
    name: str
    arguments: tuple[str, ...]
    now: str | None

    @property
    def message(self) -> str:
        return f"`{self.method}` has no argument `{self.name}`"

    @property
    def hint(self) -> str:
        if self.now is not None:
            return called_now(self.now)
        return f"it has {listed(self.arguments)}"


class NoGeneratedMessage(_Unknown):
    system: str

    @property
    def message(self) -> str:
        return f"`{self.system}` has no message `{self.name}`"


class NoConstantOfEnum(_Unknown):
    enum: str

    @property
    def message(self) -> str:
        return f"`{self.enum}` has no constant `{self.name}`"


class NoMemberMade(_Unknown):
    """A member that is given where a message is made."""

    message_type: str

    @property
    def message(self) -> str:
        return f"`{self.message_type}` has no member `{self.name}`"


class NoMemberRead(NoMemberMade):
    """`members` are those that the message has."""

    members: tuple[str, ...]

    @property
    def hint(self) -> str:
        return super().hint or "it has " + (_all_of(self.members) or "none")


class NoVariableOfActivity(_Unknown):
    activity: str

    @property
    def message(self) -> str:
        return f"no role that performs `{self.activity}` has a variable `{self.name}`"

    @property
    def hint(self) -> str:
        return super().hint or f"declare it: `var {self.name} : …`"


class NoChannel(_Unknown):
    """`others` are the channels of the topic that it names."""

    others: tuple[str, ...]

    @property
    def message(self) -> str:
        return f"there is no channel `{self.name}`"

    @property
    def hint(self) -> str:
        if self.near is not None:
            return did_you_mean(self.near)
        if self.others:
            return f"`{self.name.partition('.')[0]}` has {_all_of(self.others)}"
        return "a channel is `topic.kind.Message`, of a topic that the system declares"


class NoAgentInCode(_Unknown):
    @property
    def message(self) -> str:
        return f"there is no agent `{self.name}`"


class TooManyMembers(Problem):
    code = "W530"
    message_type: str
    members: int
    given: int

    @property
    def message(self) -> str:
        return f"`{self.message_type}` has {self.members} members, and {self.given} are given"


class NoHistoryInCode(Problem):
    code = "W530"
    channel: str
    kind: str

    @property
    def message(self) -> str:
        return f"only data has a history; `{self.channel}` is a {self.kind}"


# ---- W532, W540, W547: events, what is published and made --------------------------------------------


class EventNotAwaited(Problem):
    code = "W532"
    event: str
    near: str | None

    @property
    def message(self) -> str:
        return f"no transition waits for the event `{self.event}`"

    @property
    def hint(self) -> str:
        if self.near is not None:
            return did_you_mean(self.near)
        return "let a transition wait for it, or leave it out"


class PublishesOther(Problem):
    """`found` is the message or class that is published; "" for a value that is none."""

    code = "W540"
    channel: str
    wanted: str
    found: str
    kind: Found

    @property
    def message(self) -> str:
        return f"`{self.channel}` carries `{self.wanted}`, and this is {self._found}"

    @property
    def hint(self) -> str:
        return f"publish a `{self.wanted}`, or publish it on a channel that carries it"

    @property
    def _found(self) -> str:
        match self.kind:
            case "message":
                return f"a `{self.found}`"
            case "class of message":
                return f"the class `{self.found}` itself"
            case "other class":
                return f"a `{self.found}`, which is not a message"
            case "value":
                return "what is not a message"
            case other:
                assert_never(other)


class ValueOfOtherType(Problem):
    """`found` is the type of Python, message or enum of the value; "None" for None.

    `place` is what the value stands for: the member, an element of a repeated one, or all of its elements.
    """

    code = "W547"
    message_type: str
    member: str
    wanted: str
    found: str
    place: Literal["member", "element", "elements"]

    @property
    def message(self) -> str:
        repeated = "" if self.place == "member" else "repeated "
        this = "this element" if self.place == "element" else "this"
        article = {"None": "", "int": "an "}.get(self.found, "a ")
        return (
            f"`{self.member}` of `{self.message_type}` is {repeated}`{self.wanted}`, and {this} is "
            f"{article}`{self.found}`"
        )

    @property
    def hint(self) -> str | None:
        return "give a tuple: `(first, second)`, `(only,)` or `()`" if self.place == "elements" else None


# ---- W55x: agent messages ------------------------------------------------------------------------------


class NoPerformativeInCode(Problem):
    """`performatives` are those of FIPA."""

    code = "W555"
    name: str
    near: str | None
    performatives: tuple[str, ...]

    @property
    def message(self) -> str:
        return f"FIPA has no performative `{self.name}`"

    @property
    def hint(self) -> str:
        return did_you_mean(self.near) if self.near is not None else f"it has {', '.join(self.performatives)}"


class NotOfParticipant(Problem):
    """`listed` are the agent messages that the participants send or receive."""

    code = "W555"
    activity: str
    verb: Literal["sends", "receives"]
    agent_message: str
    participants: tuple[str, ...]
    near: str | None
    listed: tuple[str, ...]

    @property
    def message(self) -> str:
        who = " or ".join(f"`{name}`" for name in self.participants)
        return f"`{self.activity}` {self.verb} `{self.agent_message}`, and {who} does not"

    @property
    def hint(self) -> str:
        if self.near is not None:
            return did_you_mean(self.near)
        return f"it {self.verb} {', '.join(self.listed) or 'nothing'}"


class SentByLine(Problem):
    """An activity sends what only a line of its participant may send."""

    code = "W555"
    activity: str
    agent_message: str
    participant: str

    @property
    def message(self) -> str:
        return f"a line of `{self.participant}` sends `{self.agent_message}`, so `{self.activity}` may not"

    hint = "prepare the message for the line (`context.prepare`), or remove the `send` of the line"


class NeverSaid(Problem):
    """An agent message that a participant lists and neither its lines nor its activities send or take."""

    code = "W556"
    participant: str
    verb: Literal["sends", "takes"]
    performative: str
    message_type: str

    @property
    def message(self) -> str:
        return f"no line and no activity of `{self.participant}` {self.verb} `{self._said}`"

    @property
    def hint(self) -> str:
        if self.verb == "sends":
            line, call = f"send {self._said} to …", f'send("{self.performative}", …)'
        else:
            line, call = f"{self._said} from …", f'receive("{self.performative}", "{self.message_type}")'
        return f"write a line `{line}` in its control, or `context.{call}` in an activity, or leave it out"

    @property
    def _said(self) -> str:
        return f"{self.performative} {self.message_type}"


class EventNotRaised(Problem):
    code = "N726"
    event: str

    @property
    def message(self) -> str:
        return f"no activity raises the event `{self.event}`"

    @property
    def hint(self) -> str:
        return f'raise it in an activity: `context.raise_event("{self.event}")`'


def _all_of(names: Sequence[str]) -> str:
    return ", ".join(f"`{name}`" for name in names)


def _signature(parameters: Sequence[str]) -> str:
    return f"write `def execute({', '.join(parameters)})`"


def _one_of(outcomes: Sequence[str]) -> str:
    return " or ".join(f"`{name}`" for name in outcomes)


__all__ = [
    "ByPlaceOnly",
    "EventNotAwaited",
    "EventNotRaised",
    "ExecuteTakesNoContext",
    "NeverSaid",
    "NoAgentInCode",
    "NoArgumentOfMethod",
    "NoChannel",
    "NoConstantOfEnum",
    "NoGeneratedMessage",
    "NoHistoryInCode",
    "NoMemberMade",
    "NoMemberRead",
    "NoMethodOfContext",
    "NoPerformativeInCode",
    "NoVariableOfActivity",
    "NotOfParticipant",
    "OutcomeNotOfActivity",
    "OutcomeNotReturned",
    "ParameterNotGiven",
    "ParameterNotTaken",
    "ParameterPerhapsNotGiven",
    "ParameterPerhapsNotTaken",
    "PerhapsByPlaceOnly",
    "PublishesOther",
    "SentByLine",
    "TooManyMembers",
    "ValueOfOtherType",
]
