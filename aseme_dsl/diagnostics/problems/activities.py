"""Problems of activities and modules: what is said of them, and how they end (E2xx, E50x, E52x, W60x)."""

from __future__ import annotations

from typing import Literal

from aseme_dsl.diagnostics.problem import Problem
from aseme_dsl.diagnostics.wording import did_you_mean, how_to_play


class TwoStatements(Problem):
    """`clause` is what is said in two ways."""

    code = "E203"
    activity: str
    clause: str

    @property
    def message(self) -> str:
        return f"`{self.activity}` has two different `{self.clause}`: an activity belongs to the whole system"

    hint = "leave one of them out, or give one of the activities another name"


class FormulaDescribed(Problem):
    """A formula that is described as an activity."""

    code = "E204"
    name: str

    @property
    def message(self) -> str:
        return f"`{self.name}` is a formula, not an activity"

    hint = "describe the activities that it consists of"


class NoPeriod(Problem):
    code = "E218"
    module: str

    @property
    def message(self) -> str:
        return f"the module `{self.module}` has no period"

    @property
    def hint(self) -> str:
        return f"say how often it runs: `{self.module} every 33ms`"


class PeriodNotPositive(Problem):
    code = "E218"
    module: str

    @property
    def message(self) -> str:
        return f"the period of module `{self.module}` must be greater than zero"

    hint = "write how often it runs: `every 33ms`"


class ModuleIsActivity(Problem):
    code = "E219"
    name: str

    @property
    def message(self) -> str:
        return f"`{self.name}` is a module here, and an activity of a formula"

    hint = "a module runs by itself: give one of them another name"


class PartOfMessageUsed(Problem):
    """`whole` is the message."""

    code = "E502"
    verb: Literal["reads", "publishes"]
    whole: str

    @property
    def message(self) -> str:
        return f"an activity {self.verb} whole messages"

    @property
    def hint(self) -> str:
        return f"write `{self.whole}`"


class ReachOfMessage(Problem):
    code = "E502"
    reach: str
    topic: str

    @property
    def message(self) -> str:
        return f"`{self.reach}` is followed by a topic"

    @property
    def hint(self) -> str:
        return f"write `{self.reach} {self.topic}`"


class PublishesForOther(Problem):
    code = "E502"
    message = "an activity publishes as its own agent"


class HistoryOfVariable(Problem):
    code = "E503"
    message = "a variable has no history"
    hint = "leave it out"


class HistoryOfTopic(Problem):
    """`time` is how long it is to be kept, as it is written."""

    code = "E503"
    topic: str
    time: str

    message = "a whole topic has no history"

    @property
    def hint(self) -> str:
        return f"name the message: `{self.topic}.data.Message for {self.time}`"


class HistoryOfOther(Problem):
    """A channel of a `kind` that is not kept."""

    code = "E503"
    channel: str
    kind: str

    @property
    def message(self) -> str:
        return f"only data has a history; `{self.channel}` is a {self.kind}"


class LetWritten(Problem):
    code = "E507"
    name: str

    @property
    def message(self) -> str:
        return f"`{self.name}` is a let: nothing can be written to it"


class VariableOutOfReach(Problem):
    """A variable of the participant `part` that an activity reads or writes, and no state with it is inside
    of that part."""

    code = "E200"
    activity: str
    variable: str
    part: str

    @property
    def message(self) -> str:
        return f"`{self.variable}` is there inside of {self.part} only, and `{self.activity}` stands outside"

    @property
    def hint(self) -> str:
        return f"let an activity inside of {self.part} read or write it, or declare a variable of the role"


class AlmostNamedLike(Problem):
    """`kind` is what the `other` name is the name of."""

    code = "W200"
    name: str
    other: str
    kind: Literal["activity", "formula", "participant"]

    @property
    def message(self) -> str:
        return f"the activity `{self.name}` is named almost like the {self.kind} `{self.other}`"

    @property
    def hint(self) -> str:
        return did_you_mean(self.other)


class SimulatedWithoutTime(Problem):
    code = "W201"
    activity: str

    @property
    def message(self) -> str:
        return f"`{self.activity}` is simulated, and nothing says how long: it lasts 100 ms"

    @property
    def hint(self) -> str:
        return f"say what it takes: `{self.activity} takes 1s simulated`"


class NamedLikeParticipant(Problem):
    """An activity of a role that is named like a participant of these protocols."""

    code = "W202"
    participant: str
    protocols: tuple[str, ...]
    role: str

    @property
    def message(self) -> str:
        return f"`{self.participant}` is an activity here, for {self.role} does not play the participant"

    @property
    def hint(self) -> str:
        return how_to_play(self.protocols, self.participant, self.role)


class OutcomeOfNobody(Problem):
    """`chart` is the role or protocol in which the outcome is asked for."""

    code = "E520"
    activity: str
    chart: str

    @property
    def message(self) -> str:
        return f"nothing in {self.chart} performs `{self.activity}`, so it never ends there"

    hint = "ask for the outcome of an activity of the same role or participant"


class BoundWithoutOutcome(Problem):
    """A role's own activity that has not the outcomes of the one for which it stands."""

    code = "E520"
    activity: str
    bound_for: str
    chart: str
    outcome: str

    @property
    def message(self) -> str:
        return (
            f"`{self.activity}`, which stands for `{self.bound_for}` in {self.chart}, does not end "
            f"`{self.outcome}`"
        )

    @property
    def hint(self) -> str:
        return f"say so among the activities: `{self.activity} ends {self.outcome}, …`"


class NoDeadline(Problem):
    code = "E522"
    message = "the deadline must be greater than zero"
    hint = "a deadline comes after the state is entered: `within 5s`"


class ModuleEnds(Problem):
    """`clause` is what only an activity has."""

    code = "E522"
    module: str
    clause: str

    @property
    def message(self) -> str:
        return f"the module `{self.module}` is not an activity: it has no `{self.clause}`"

    hint = "leave it out"


class ParametersInChart(Problem):
    """`activity` is its name with its parameters."""

    code = "E523"
    activity: str

    @property
    def message(self) -> str:
        return f"`{self.activity}`: a state gives it nothing"

    hint = "only formulas give arguments: describe the role by formulas, or use a variable"


class BoundToOtherParameters(Problem):
    """A binding of the protocol's activity `abstract`, which is given values of the types `given`."""

    code = "E525"
    abstract: str
    own: str
    given: tuple[str, ...]

    @property
    def message(self) -> str:
        given = ", ".join(self.given) or "nothing"
        return f"the protocol gives `{self.abstract}` {given}, which `{self.own}` does not take"

    hint = "bind it to an activity with parameters of the same types"


class ModuleSimulated(Problem):
    code = "E545"
    module: str

    @property
    def message(self) -> str:
        return f"the module `{self.module}` cannot be simulated: nothing says what it would do"

    hint = "leave the module out as long as it has no code"


class WaitsBeside(Problem):
    """`word` is another clause of the activity."""

    code = "E227"
    activity: str
    word: str

    @property
    def message(self) -> str:
        return f"`{self.activity}` waits: it never ends by itself, so that `{self.word}` has no effect"

    @property
    def hint(self) -> str:
        if self.word in ("takes", "within"):
            return "remove one of both; for a time limit write `after(…)` on a transition that leaves it"
        return f"remove `waits` or `{self.word}`"


class GuaranteeOfOther(Problem):
    """`near` is a message of the activity with a similar name."""

    code = "E231"
    activity: str
    message_name: str
    near: str | None

    @property
    def message(self) -> str:
        return f"`{self.activity}` guarantees something of `{self.message_name}`, which it does not write"

    @property
    def hint(self) -> str:
        return did_you_mean(self.near) if self.near else "name a message that stands behind its `writes`"


class GuaranteeReadsMore(Problem):
    code = "E231"
    read: str

    @property
    def message(self) -> str:
        return f"a guarantee speaks only of the messages that it names, not of `{self.read}`"

    hint = "compare their members with each other and with constants"


class GuaranteeNamesTwice(Problem):
    code = "E231"
    name: str

    @property
    def message(self) -> str:
        return f"both messages are called `{self.name}`"

    hint = "give one of them another name"


class GuaranteeWithoutTime(Problem):
    code = "E231"
    message = "a guarantee for no time says nothing"
    hint = "write how long it holds: `within 500ms`"


class ModuleWaits(Problem):
    code = "E227"
    module: str

    @property
    def message(self) -> str:
        return f"the module `{self.module}` cannot wait: a module consists of its code"

    hint = "remove `waits`"


class DeadlineTooShort(Problem):
    """`takes` and `within` are durations as the language writes them."""

    code = "W603"
    activity: str
    takes: str
    within: str

    @property
    def message(self) -> str:
        return f"`{self.activity}` takes {self.takes}, and is given {self.within}"

    hint = "in simulation it always fails: give it more time"


class MissedDeadlineStops(Problem):
    """`conditional`: a transition takes the failure where its condition holds."""

    code = "W604"
    role: str
    activity: str
    within: str
    conditional: bool

    @property
    def message(self) -> str:
        stops = f"{self.role} stops if `{self.activity}` is not done within {self.within}"
        return f"{stops}, and the condition of its `error` does not hold" if self.conditional else stops

    @property
    def hint(self) -> str:
        if self.conditional:
            return f"say what happens then: `leave {self.activity} : error`, or `error` further out"
        return f"let a transition take it: `enter … : error` after `{self.activity}`, or further out"


__all__ = [
    "AlmostNamedLike",
    "BoundWithoutOutcome",
    "DeadlineTooShort",
    "FormulaDescribed",
    "MissedDeadlineStops",
    "NamedLikeParticipant",
    "OutcomeOfNobody",
]
