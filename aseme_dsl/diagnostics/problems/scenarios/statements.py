"""Scenarios and properties: their statements, the names in them, and what does not fit (E117, E229, E230)."""

from __future__ import annotations

from aseme_dsl.diagnostics.problem import Problem
from aseme_dsl.diagnostics.problems.absences import Absent
from aseme_dsl.diagnostics.problems.syntax.entries import Unexpected
from aseme_dsl.diagnostics.wording import did_you_mean, listed

# ---- E117: statements --------------------------------------------------------------------------


class UnexpectedInStatement(Unexpected):
    """`close`: the word of the language that is spelt alike."""

    code = "E117"
    whole = "statement"
    close: str | None = None

    @property
    def hint(self) -> str | None:
        return did_you_mean(self.close) if self.close is not None else None


class InputAsTime(UnexpectedInStatement):
    """`at t`, where `given t in 1s..5s` is an input."""

    hint = "write the time itself, as 2s: an input stands in `[ … ]` and `{ … }` only"


class NoStatement(Problem):
    code = "E117"
    word: str
    close: str | None

    @property
    def message(self) -> str:
        return f"no statement begins with `{self.word}`"

    @property
    def hint(self) -> str:
        if self.close is not None:
            return did_you_mean(self.close)
        return "begin with `at`, `by`, `always`, `never`, `eventually`, `every`, or write `X before Y`"


class WithoutMoment(Problem):
    """`verb`: that of a stimulus; empty for an expectation."""

    code = "E117"
    verb: str

    @property
    def message(self) -> str:
        what = f"`{self.verb}`" if self.verb else "an expectation"
        return f"{what} without a moment"

    @property
    def hint(self) -> str:
        return (
            "write `at 2s` before it"
            if self.verb
            else "write `at 2s`, `by 3s`, `always` or `never` before it"
        )


class AgentAlone(Problem):
    code = "E117"
    agent: str

    @property
    def message(self) -> str:
        return f"`{self.agent}` is an agent, not a condition"

    @property
    def hint(self) -> str:
        return f"write `{self.agent} in`, and a state"


class VariableWithoutAgent(Problem):
    """A condition about a variable of `agents`, none of which it names."""

    code = "E229"
    name: str
    agents: tuple[str, ...]
    condition: str

    @property
    def message(self) -> str:
        return f"nothing says whose `{self.name}` this is"

    @property
    def hint(self) -> str:
        return f"write `{self.agents[0]} has [{self.condition}]`"


class MessageAlone(Problem):
    code = "E117"
    channel: str

    @property
    def message(self) -> str:
        return f"`{self.channel}` is a message, not a condition"

    @property
    def hint(self) -> str:
        return f"write `message {self.channel}`, or ask for a member"


class OfMissing(Problem):
    code = "E117"
    count: str
    role: str
    message = "`of` is missing before the role"

    @property
    def hint(self) -> str:
        return (
            f"write `at most {self.count} of {self.role} in ...`; in all agents: `at most {self.count} ...`"
        )


class OnlyHas(Problem):
    code = "E117"
    message = "what is assumed of an agent is about its values, not about where it is"
    hint = "write `assume robot1 has [...]`"


class OnlyInScenario(Problem):
    code = "E117"
    word: str
    hint = "move it to a `scenario`"

    @property
    def message(self) -> str:
        return f"a property has no `{self.word}`"


# ---- E229: names -------------------------------------------------------------------------------


class NoAgentInScenario(Absent):
    """`is_listed`: the scenario says which agents take part."""

    code = "E229"
    what = "there is no agent"
    is_listed: bool = False

    @property
    def message(self) -> str:
        return f"no agent `{self.name}` takes part" if self.is_listed else super().message


class NoRoleInScenario(Absent):
    code = "E229"
    what = "there is no role"


class NoStateOfRole(Absent):
    code = "E229"
    role: str

    @property
    def message(self) -> str:
        return (
            f"{self.role} has no state `{self.name}`" if self.role else f"no role has a state `{self.name}`"
        )


class NoStateOfParticipant(Absent):
    code = "E229"
    participant: str

    @property
    def message(self) -> str:
        return f"the process of {self.participant} has no state `{self.name}`"


class NoParticipantInScenario(Absent):
    """`instead`: how the state of an agent or a role of that name is written."""

    code = "E229"
    what = "there is no participant"
    instead: str = ""

    @property
    def certain(self) -> str | None:
        return f"write `{self.instead}`" if self.instead else super().certain


class NoMessageInScenario(Absent):
    code = "E229"
    what = "there is no message"


class NoActivityInScenario(Absent):
    code = "E229"
    what = "there is no activity"


class NoFunctionInScenario(Absent):
    code = "E229"
    what = "there is no function"


class NoOutcomeOfActivity(Absent):
    code = "E229"
    activity: str

    @property
    def message(self) -> str:
        return f"`{self.activity}` has no outcome `{self.name}`"

    @property
    def advice(self) -> str | None:
        return super().advice or f"declare it: `{self.activity} ends {self.name}`"


class NoOutcomeOfProtocols(Absent):
    code = "E229"

    @property
    def message(self) -> str:
        return f'no protocol has the outcome "{self.name}"'

    @property
    def hint(self) -> str | None:
        if self.close is not None:
            return f'did you mean "{self.close}"?'
        return "say it in the `aip`: `outcome`, and the text in quotes"


class NoEventOfRole(Absent):
    code = "E229"
    role: str

    @property
    def message(self) -> str:
        return f"no transition of {self.role} waits for the event `{self.name}`"


class NoVariableToSet(Absent):
    code = "E229"
    activity: str

    @property
    def message(self) -> str:
        return f"no role that performs `{self.activity}` has the variable `{self.name}`"


# ---- E230: what does not fit -------------------------------------------------------------------


class UnsuitableRange(Problem):
    code = "E230"
    least: str
    most: str
    hint = "write the smaller value first"

    @property
    def message(self) -> str:
        return f"the range {self.least}..{self.most} is empty, or too large"


class UnsuitableShare(Problem):
    code = "E230"
    message = "a share is 1% to 100%, of at least one seed"
    hint = "write for example `in 95% of 200 seeds`"


class OtherRole(Problem):
    code = "E230"
    agent: str
    role: str
    hint = "use its role, or another name"

    @property
    def message(self) -> str:
        return f"in the team, `{self.agent}` has the role `{self.role}`"


class InputTwice(Problem):
    code = "E230"
    name: str
    hint = "use another name"

    @property
    def message(self) -> str:
        return f"`{self.name}` is an input or an agent already"


class RowOfOtherLength(Problem):
    code = "E230"
    columns: tuple[str, ...]
    found: int
    hint = "give one value to each column"

    @property
    def message(self) -> str:
        return f"a row has {self.found} values, but the columns are {listed(self.columns)}"


class UnsuitableInput(Problem):
    code = "E230"
    name: str
    hint = "write two numbers or two durations"

    @property
    def message(self) -> str:
        return f"`{self.name}` needs two constants of one type"


class FaultNotNever(Problem):
    code = "E230"
    message = "a fault cannot be expected"
    hint = "write `never fault`"


class StatedTwice(Problem):
    """`what`: `for`, `network`, or an activity with a line already."""

    code = "E230"
    what: str
    hint = "keep one of the two"

    @property
    def message(self) -> str:
        return f"a second `{self.what}` in one scenario"


class TakesPartTwice(Problem):
    code = "E230"
    agent: str
    hint = "name each agent once"

    @property
    def message(self) -> str:
        return f"`{self.agent}` takes part twice"


class RestartWithoutCrash(Problem):
    code = "E230"
    agent: str
    moment: str

    @property
    def message(self) -> str:
        return f"`{self.agent}` has not crashed before {self.moment}"

    @property
    def hint(self) -> str:
        return f"write `crash {self.agent} at` an earlier time"


class CrashOfCrashed(Problem):
    code = "E230"
    agent: str
    hint = "restart it before, or remove the line"

    @property
    def message(self) -> str:
        return f"`{self.agent}` has crashed already"


class EmptyTable(Problem):
    code = "E230"
    message = "the table has no row"
    hint = "write a row, as `(1, Walk)`"


class RealAndSimulated(Problem):
    code = "E230"
    activity: str
    hint = "remove `real`, or the rest"

    @property
    def message(self) -> str:
        return f"`{self.activity}` is `real`: it does what its code says, and nothing else"


class OutsideGroups(Problem):
    code = "E230"
    agents: tuple[str, ...]
    hint = "name each agent that takes part in one group"

    @property
    def message(self) -> str:
        return f"in no group, or in two: {listed(self.agents)}"


class BehindTheEnd(Problem):
    code = "E230"
    end: str
    hint = "let the run last longer"

    @property
    def message(self) -> str:
        return f"the run ends before it, with `for {self.end}`"


class HitWithoutMoment(Problem):
    code = "E230"
    message = "it needs a moment"
    hint = "write `at 2s` or `from 2s to 5s` before it"


class NotStepwise(Problem):
    """`verb`: that of something which happens by hand."""

    code = "E230"
    verb: str
    hint = "write `stepwise` in the scenario, so that nothing else ends or arrives"

    @property
    def message(self) -> str:
        return f"`{self.verb}` in a scenario that is not stepwise"


class StepwiseWith(Problem):
    """`word`: that of a statement which leaves open what is done by hand."""

    code = "E230"
    word: str
    hint = "remove one of both"

    @property
    def message(self) -> str:
        return f"`{self.word}` in a scenario that is stepwise"


class NeitherMessage(Problem):
    """A message that is on no channel and has no performative."""

    code = "E230"
    kind: str

    @property
    def message(self) -> str:
        return f"nothing says how `{self.kind}` comes"

    @property
    def hint(self) -> str:
        kind = self.kind
        return f"write `topic.state.{kind} {{ … }}` for a channel, or `inform {kind} {{ … }}` between agents"


class WhichAgent(Problem):
    """A condition that no agent is named for, where several take part."""

    code = "E230"
    agents: tuple[str, ...]
    condition: str
    message = "nothing says which agent this is about"

    @property
    def hint(self) -> str:
        return f"write `{self.agents[0]} has [{self.condition}]`"


class NeverHasMessage(Problem):
    """A condition asks an agent for a message of a channel that its role neither reads nor fills."""

    code = "W231"
    role: str
    channel: str

    @property
    def message(self) -> str:
        return f"{self.role} does not read `{self.channel}`, so it never has such a message"

    @property
    def hint(self) -> str:
        return f"let an activity of {self.role} read it (`reads {self.channel}`), or ask another agent"
