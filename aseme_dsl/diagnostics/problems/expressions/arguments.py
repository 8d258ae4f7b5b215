"""Problems of what formulas, functions, forms and activities are given (E308 to E310, E504, E515, E52x)."""

from __future__ import annotations

from typing import Literal, assert_never

from aseme_dsl.diagnostics.problem import Problem
from aseme_dsl.diagnostics.wording import a, did_you_mean

# ---- E308 to E310: parameters of formulas -------------------------------------------------------


class UntypedParameter(Problem):
    code = "E308"
    formula: str
    name: str

    @property
    def message(self) -> str:
        return f"the type of the parameter `{self.name}` is not known"

    @property
    def hint(self) -> str:
        written = f"`{self.formula}({self.name} : …)`"
        return f"it is passed on to no activity that says it: write {written}"


class ParameterOfTwoTypes(Problem):
    code = "E309"
    name: str
    first: str
    second: str

    @property
    def message(self) -> str:
        return f"`{self.name}` is passed on as {self.first} and as {self.second}"

    hint = "it can be one of them only"


class RootWithParameters(Problem):
    code = "E310"
    formula: str

    @property
    def message(self) -> str:
        return f"`{self.formula}` has parameters, and nothing gives them a value"

    hint = "only a formula that another one names can be given something"


# ---- E504: functions ----------------------------------------------------------------------------


class _OfFunction(Problem):
    """`signatures` are those of a built-in function: others are shown where they are declared."""

    code = "E504"
    name: str
    signatures: tuple[str, ...]

    @property
    def hint(self) -> str | None:
        if not self.signatures:
            return None
        return "there is " + ", ".join(f"`{signature}`" for signature in self.signatures)


class WrongNumber(_OfFunction):
    """`counts` are the numbers of arguments that a function of this name takes."""

    counts: tuple[int, ...]
    given: int

    @property
    def message(self) -> str:
        takes = " or ".join(str(count) for count in self.counts)
        plural = "" if self.counts == (1,) else "s"
        return f"`{self.name}` takes {takes} argument{plural}, not {self.given}"


class WrongArgument(_OfFunction):
    parameter: str
    wanted: str
    type: str

    @property
    def message(self) -> str:
        return f"`{self.name}` wants {a(self.wanted)} as `{self.parameter}`, not {a(self.type)}"


class NoOverload(_OfFunction):
    types: tuple[str, ...]

    @property
    def message(self) -> str:
        return f"no `{self.name}` takes ({', '.join(self.types)})"


class OtherOrder(Problem):
    """`arguments` are in the order in which they fit."""

    code = "E504"
    name: str
    arguments: tuple[str, ...]

    @property
    def message(self) -> str:
        return f"the arguments of `{self.name}` are in another order"

    @property
    def hint(self) -> str:
        return f"write `{self.name}({', '.join(self.arguments)})`"


# ---- E504: forms of the language ----------------------------------------------------------------


class _OfForm(Problem):
    """A form of the language that is used otherwise than in the `example`."""

    code = "E504"
    form: str
    example: str

    @property
    def hint(self) -> str:
        return f"it is used as `{self.example}`"


class TimerAsValue(_OfForm):
    @property
    def message(self) -> str:
        return f"`{self.form}` is an action, not a value"


class WrongNumberForForm(_OfForm):
    wanted: int
    given: int

    @property
    def message(self) -> str:
        if self.wanted == 0:
            return f"`{self.form}` takes no arguments"
        plural = "" if self.wanted == 1 else "s"
        return f"`{self.form}` takes {self.wanted} argument{plural}, not {self.given}"


Named = Literal["activity", "agent", "participant", "state", "timer"]
"""What the name in a form is the name of."""


class NoName(_OfForm):
    wanted: Named

    @property
    def message(self) -> str:
        what = "a formula or an activity" if self.wanted == "state" else a(self.wanted)
        return f"`{self.form}` wants the name of {what}"


class OtherKind(_OfForm):
    """A value of this `type` where another is wanted."""

    wanted: Literal["message", "number", "list"]
    type: str

    @property
    def message(self) -> str:
        return f"`{self.form}` wants {a(self.wanted)}, not {a(self.type)}"


class PartOfMessage(_OfForm):
    """`whole` is the message."""

    whole: str

    @property
    def message(self) -> str:
        return f"`{self.form}` wants the whole message: `{self.whole}`"


class AlwaysThere(_OfForm):
    """The message that a transition takes, or the member of it at `path`."""

    path: str

    @property
    def message(self) -> str:
        what = f"`{self.path}`" if self.path else "the message that is taken"
        return f"{what} is there in any case"


class SenderOfOther(_OfForm):
    """`sender(…)` of something that is not an agent message; `agent` is set if it is the name of an agent."""

    agent: str | None

    @property
    def message(self) -> str:
        if self.agent is not None:
            return f"`{self.agent}` is the agent itself"
        return f"`{self.form}` wants the agent message that the transition takes"


class OtherThanElements(_OfForm):
    """`member` is that of the elements which is looked at, if it is not the elements."""

    type: str
    wanted: str
    member: str = ""

    @property
    def message(self) -> str:
        if self.member:
            return f"`{self.member}` of an element is {a(self.type)}, not {a(self.wanted)}"
        return f"the list holds values of type {self.type}: {a(self.wanted)} is not among them"


# ---- E504, E515 and E516: durations -------------------------------------------------------------

DurationOf = Literal["after", "start_timer", "at", "mean"]
"""Which duration it is, by what it is given to."""


class _OfDuration(Problem):
    """A duration that `place` is given."""

    place: DurationOf

    @property
    def what(self) -> str:
        match self.place:
            case "after" | "start_timer":
                return f"the time of `{self.place}`"
            case "at" | "mean":
                return f"the second argument of `{self.place}`"
            case _ as never:
                assert_never(never)


class NotADuration(_OfDuration):
    code = "E504"
    type: str

    @property
    def message(self) -> str:
        return f"{self.what} must be a duration, not {a(self.type)}"

    @property
    def hint(self) -> str | None:
        return "a duration has a unit: 200ms, 1.5s, 2min" if self.type in ("int", "double") else None


class DurationTooShort(_OfDuration):
    code = "E504"
    may_be_zero: bool

    @property
    def message(self) -> str:
        return f"{self.what} must be {'zero or more' if self.may_be_zero else 'more than zero'}"


class DurationInFuture(_OfDuration):
    """`written` is the constant."""

    code = "E504"
    written: str | None

    @property
    def message(self) -> str:
        return f"{self.what} must lie in the past: it is negative"

    @property
    def hint(self) -> str | None:
        return None if self.written is None else f"write -{self.written}"


class DurationNotConstant(_OfDuration):
    code = "E515"

    @property
    def message(self) -> str:
        return f"{self.what} must be a constant"

    hint = "this is known only at run time: write a duration, such as 500ms"


class DurationNotComputed(_OfDuration):
    code = "E516"

    @property
    def message(self) -> str:
        return f"{self.what} cannot be computed"


# ---- E523 and E524: activities and formulas -----------------------------------------------------


class GivenWithoutParameters(Problem):
    """`close` is something else that has parameters; `in_sequence` is written where no argument is meant."""

    code = "E523"
    name: str
    close: str | None
    parameters: tuple[str, ...]
    in_sequence: str

    @property
    def message(self) -> str:
        return f"the activity `{self.name}` is given something, and nothing says that it has parameters"

    @property
    def hint(self) -> str:
        if self.close is not None:
            return did_you_mean(self.close)
        parameters = ", ".join(f"{name} : …" for name in self.parameters)
        said = f"say so among the `activities`: `{self.name}({parameters})`"
        return f"{said}; one after the other is `{self.in_sequence}`"


class WrongNumberGiven(Problem):
    """`in_sequence` is written where no argument is meant."""

    code = "E523"
    name: str
    parameters: tuple[str, ...]
    given: int
    in_sequence: str

    @property
    def message(self) -> str:
        wanted = len(self.parameters)
        if wanted == 0:
            return f"`{self.name}` takes no arguments"
        plural = "" if wanted == 1 else "s"
        return f"`{self.name}` takes {wanted} argument{plural}, not {self.given or 'none'}"

    @property
    def hint(self) -> str:
        if not self.parameters:
            return f"write `{self.in_sequence}`"
        return f"write `{self.name}(…)`, with {', '.join(self.parameters)}"


class SignalGiven(Problem):
    code = "E524"
    channel: str

    @property
    def message(self) -> str:
        return f"signal `{self.channel}` may already be consumed when the argument is evaluated"

    hint = "store the value in a variable in the transition's actions: `/ goal = …`"
