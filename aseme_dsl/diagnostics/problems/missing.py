"""Missing: what the analyst has not said yet (N70x)."""

from __future__ import annotations

from aseme_dsl.diagnostics.problem import Problem
from aseme_dsl.diagnostics.wording import first_of, listed

_LISTED = 4
"""How many activities a text lists at most."""


# ---- use cases, protocols and roles ------------------------------------------------------------


class UseCaseNotSpecified(Problem):
    """Formulas would call it `spelling`; `close` is what one of them calls something spelt alike."""

    code = "N700"
    usecase: str
    spelling: str
    close: str | None

    @property
    def message(self) -> str:
        return f"nothing specifies the use case `{self.usecase}`"

    @property
    def hint(self) -> str:
        if self.close is not None:
            return f"is it `{self.close}`? Then call it so, or write `realises {self.close}`"
        return f"let a formula use `{self.spelling}`, or say what it `realises`"


class ProtocolNotWritten(Problem):
    code = "N701"
    protocol: str
    parties: tuple[str, ...]
    skeleton: str

    @property
    def message(self) -> str:
        return f"the protocol `{self.protocol}` of {listed(self.parties)} is not written yet"

    @property
    def hint(self) -> str:
        return f"start from\n{self.skeleton}"


class ProtocolEmpty(Problem):
    code = "N701"
    protocol: str

    @property
    def message(self) -> str:
        return f"the protocol {self.protocol} has no participants yet"

    hint = "say who takes part: `participant center { process = … }`"


class RoleIncomplete(Problem):
    """A role that does not do what it takes part in."""

    code = "N702"
    role: str


class UseCaseWithoutFormula(RoleIncomplete):
    """`formulas` are lines to start from, of which another formula is to use `name`."""

    usecase: str
    name: str
    formulas: tuple[str, ...]

    @property
    def message(self) -> str:
        return f"{self.role} has no formula for the use case `{self.usecase}`"

    @property
    def hint(self) -> str:
        return "\n".join(["start from", *self.formulas, f"and let a formula use `{self.name}`"])


class UseCaseNotPlayed(RoleIncomplete):
    """`plays` are the lines of which one is missing."""

    usecase: str
    protocol: str
    plays: tuple[str, ...]

    @property
    def message(self) -> str:
        return f"{self.role} takes part in the use case `{self.usecase}`, but plays none of {self.protocol}"

    @property
    def hint(self) -> str:
        return f"say which part it takes: {' or '.join(f'`{line}`' for line in self.plays)}"


class NotAParticipant(RoleIncomplete):
    """`lines` are those of the participant to start from."""

    usecase: str
    lines: tuple[str, ...]

    @property
    def message(self) -> str:
        return f"{self.role} takes part in the use case `{self.usecase}`, but is not a participant of it"

    @property
    def hint(self) -> str:
        return "\n".join(["add", *self.lines])


class ParticipantNotUsed(RoleIncomplete):
    """The role, or a participant, calls the participant `name`, and its first formula is `root`."""

    protocol: str
    participant: str
    name: str
    root: str

    @property
    def message(self) -> str:
        return f"{self.role} plays {self.protocol}.{self.participant}, but no formula uses `{self.name}`"

    @property
    def hint(self) -> str:
        return f"let a formula use it, such as `{self.root} = … | {self.name}`"


class RoleNotWritten(Problem):
    code = "N703"
    role: str
    skeleton: str

    @property
    def message(self) -> str:
        return f"the role `{self.role}` is not written yet"

    @property
    def hint(self) -> str:
        return f"start from\n{self.skeleton}"


# ---- control -----------------------------------------------------------------------------------


class ControlMissing(Problem):
    """A formula with so many choices and loops that nothing decides, and the pairs (B, A) of its `A [> B`."""

    code = "N704"
    formula: str
    choices: int
    loops: int
    interrupts: tuple[tuple[str, str], ...]
    skeleton: str

    @property
    def message(self) -> str:
        parts = (_counted(self.choices, "choice"), _counted(self.loops, "loop"))
        what = " and ".join(part for part in parts if part)
        said = [f"`{self.formula}` has {what} without a condition: what comes first is taken"] if what else []
        said += [
            f"no `enter {term}` line: `{interrupted}` is never interrupted"
            for term, interrupted in self.interrupts
        ]
        return "; ".join(said)

    @property
    def hint(self) -> str:
        return f"start from\n{self.skeleton}"


def _counted(number: int, what: str) -> str:
    return "" if number == 0 else f"a {what}" if number == 1 else f"{number} {what}s"


class ExpressionsMissing(Problem):
    """A statechart; `states` have several transitions, and `transition` is the first one of them."""

    code = "N704"
    chart: str
    states: tuple[str, ...]
    transition: str

    @property
    def message(self) -> str:
        several = f"{len(self.states)} states" if len(self.states) > 1 else self.states[0]
        return f"no transition of `{self.chart}` has an expression: out of {several} the first one is taken"

    @property
    def hint(self) -> str:
        return f"write `{self.transition} : [ … ]`, and `else` on the last transition of each state"


# ---- who does what -----------------------------------------------------------------------------


class UseCaseOfOthers(Problem):
    """Formulas call the use case `spelling`; `doers` have it, `roles` are those that should."""

    code = "N705"
    usecase: str
    spelling: str
    participants: tuple[str, ...]
    roles: tuple[str, ...]
    doers: tuple[str, ...]

    @property
    def message(self) -> str:
        does = "does" if len(self.doers) == 1 else "do"
        return (
            f"`{self.usecase}` is a use case of {listed(self.participants)}, "
            f"but only {listed(self.doers)} {does} it"
        )

    @property
    def hint(self) -> str:
        return (
            f"let a formula of {listed(self.roles, 'or')} use `{self.spelling}`, or say whose it is: "
            f"`usecase {self.usecase} by {self.doers[0]}`"
        )


class ProtocolWithoutPlayer(Problem):
    """`first` is one of its participants."""

    code = "N706"
    protocol: str
    first: str

    @property
    def message(self) -> str:
        return f"no role plays the protocol `{self.protocol}`"

    @property
    def hint(self) -> str:
        plays = f"plays {self.protocol}.{self.first}"
        return f"write `{plays}` in the `srm` that does, and let a formula use `{self.first}`"


class ParticipantWithoutPlayer(Problem):
    code = "N706"
    protocol: str
    participant: str

    @property
    def message(self) -> str:
        return f"no role plays {self.protocol}.{self.participant}"

    @property
    def hint(self) -> str:
        return f"write `plays {self.protocol}.{self.participant}` in the `srm` that does"


class FunctionalityNotSaid(Problem):
    """`functionality` is one that a role describes."""

    code = "N707"
    role: str
    activities: tuple[str, ...]
    functionality: str

    @property
    def message(self) -> str:
        use = "uses" if len(self.activities) == 1 else "use"
        shown = first_of(self.activities, _LISTED)
        return f"nothing says which functionality {shown} of {self.role} {use}"

    @property
    def hint(self) -> str:
        return f"say it among the `activities`: `{self.activities[0]} uses {self.functionality}`"
