"""Formulas: what cannot be right in liveness formulas (E30x, W30x)."""

from __future__ import annotations

from aseme_dsl.diagnostics.problem import Problem
from aseme_dsl.diagnostics.wording import did_you_mean


class FormulaRecursive(Problem):
    """`circle` begins and ends with the same formula."""

    code = "E300"
    circle: tuple[str, ...]

    @property
    def message(self) -> str:
        return f"a formula cannot contain itself: {' → '.join(self.circle)}"

    hint = "say a repetition with `*`, `+` or `~`"


class FormulaTwice(Problem):
    code = "E301"
    name: str
    owner: str

    @property
    def message(self) -> str:
        return f"`{self.name}` has two formulas in {self.owner}"

    hint = "rename one of them, or join them with an operator"


class FormulaNotUsed(Problem):
    """`close` is an operand without a formula that is spelt alike."""

    code = "E302"
    name: str
    owner: str
    close: str | None = None

    @property
    def message(self) -> str:
        return f"nothing in {self.owner} uses the formula `{self.name}`"

    @property
    def hint(self) -> str:
        return "use it in a formula, or remove it" if self.close is None else did_you_mean(self.close)


class FormulaMisspelt(Problem):
    """An operand without a formula, where nothing uses the `formula` that is spelt alike."""

    code = "E302"
    name: str
    formula: str

    @property
    def message(self) -> str:
        return f"`{self.name}` has no formula, and nothing uses the formula `{self.formula}`"

    @property
    def hint(self) -> str:
        return did_you_mean(self.formula)


class LoopMayBeEmpty(Problem):
    """`simpler` is the same loop over a body that is not empty."""

    code = "E303"
    loop: str
    simpler: str | None

    @property
    def message(self) -> str:
        return f"the body of `{self.loop}` may be empty, so that the loop would never settle"

    @property
    def hint(self) -> str:
        if self.simpler is not None:
            return f"write `{self.simpler}`"
        return "let the body take at least one activity, or give `repeat` a pace: `every 200ms`"


class TooManyStates(Problem):
    """`heaviest` are formulas, each with its states, of which each is most of the one before."""

    code = "E304"
    owner: str
    states: int
    limit: int
    heaviest: tuple[tuple[str, int], ...]

    @property
    def message(self) -> str:
        chain = " → ".join(f"{name} ({_thousands(states)} states)" for name, states in self.heaviest)
        return (
            f"{self.owner} would have {_thousands(self.states)} states; "
            f"the limit is {_thousands(self.limit)}: {chain}"
        )

    hint = (
        "a formula is expanded each time it stands: use it in fewer places, or allow more with "
        "`max_states = …` under [tool.asemec] in pyproject.toml"
    )


def _thousands(number: int) -> str:
    return f"{number:,}".replace(",", " ")


class RoleWithoutFormula(Problem):
    code = "E305"
    role: str

    @property
    def message(self) -> str:
        return f"the role {self.role} has no formula"

    @property
    def hint(self) -> str:
        return f"say what it does: `liveness {{ {self.role} = … }}`"


class ParticipantWithoutProcess(Problem):
    """`is_misspelt` where a formula of it is called almost so."""

    code = "E305"
    participant: str
    protocol: str
    is_misspelt: bool

    @property
    def message(self) -> str:
        return f"`{self.participant}` of {self.protocol} has no process"

    @property
    def hint(self) -> str:
        if self.is_misspelt:
            return "did you mean `process`?"
        return "say what it does: `process = WalkTowardsBall . [PassBall]`"


class ProcessRestated(Problem):
    """A formula `name` of a role, or a participant, that plays the participant under this name.

    `is_role`: it is the formula of the role as a whole, which is called as its participant.
    """

    code = "E306"
    name: str
    protocol: str
    participant: str
    is_role: bool

    @property
    def message(self) -> str:
        return f"the process of `{self.name}` is the protocol's: it cannot be stated again"

    @property
    def hint(self) -> str:
        if self.is_role:
            return f"write `{self.name} = {self.name}`, where the second `{self.name}` is the participant"
        other = f"{self.protocol}_{self.participant}"
        return (
            "remove this formula, or give the participant another name here: "
            f"`plays {self.protocol}.{self.participant} as {other}`"
        )


class TooFewInstances(Problem):
    code = "E307"
    term: str
    count: int

    @property
    def message(self) -> str:
        return f"`{self.term}` asks for {self.count} instance{'' if self.count == 1 else 's'}"

    hint = "two or more run concurrently; for one, leave the number out"


class OperatorsMixed(Problem):
    """`read_as` is the term with the parentheses that it is read with."""

    code = "W300"
    term: str
    read_as: str

    @property
    def message(self) -> str:
        return f"`{self.term}` mixes operators without parentheses"

    @property
    def hint(self) -> str:
        return f"it is read as `{self.read_as}`"


class LineNeverTaken(Problem):
    code = "W301"
    message = "this line is never taken: something beside it needs no condition"
    hint = "give the other one a condition, or remove this line"
