"""Statecharts: states and transitions that break a rule of statecharts (E409, E410, E6xx, W6xx)."""

from __future__ import annotations

from aseme_dsl.diagnostics.problem import Problem


class Unsound(Problem):
    """A rule of statecharts is broken: none is made of these states and transitions."""


# ---- E409, E410: ends of transitions -----------------------------------------------------------


class TransitionOfRoot(Unsound):
    code = "E409"
    message = "the root has no transitions: nothing is around it"


class TransitionToRegion(Unsound):
    """`parallel` is the AND that the region is of."""

    code = "E409"
    region: str
    parallel: str

    @property
    def message(self) -> str:
        return f"{self.region} is a region of {self.parallel}: it is entered with it, not by a transition"

    @property
    def hint(self) -> str:
        return f"lead to {self.parallel}"


class TransitionIntoRegion(Unsound):
    """From one region of the AND `parallel` into another one."""

    code = "E409"
    source: str
    target: str
    region: str
    parallel: str

    @property
    def message(self) -> str:
        return f"a transition from {self.source} to {self.target} leads into the region {self.region}"

    @property
    def hint(self) -> str:
        return (
            f"the regions of {self.parallel} are active together: lead out of it, or raise an event in one "
            "that another waits for"
        )


class TransitionToOtherChoice(Unsound):
    """To a choice of another region; the choice is in `around`."""

    code = "E409"
    source: str
    choice: str
    around: str

    @property
    def message(self) -> str:
        return f"{self.choice} is a CONDITION of another region than {self.source}"

    @property
    def hint(self) -> str:
        return f"lead to a state: to {self.around}, if its START leads to the choice"


class OutsideOfBranch(Unsound):
    """A line of a participant whose branch is `branch`."""

    code = "E409"
    label: str
    branch: str

    @property
    def message(self) -> str:
        return f"{self.label} is outside this participant's branch, which is {self.branch}"

    hint = "what several participants do together follows from their processes and messages"


class NoState(Unsound):
    """`has_parent` where the statechart has the state that it would be in."""

    code = "E410"
    label: str
    has_parent: bool

    @property
    def message(self) -> str:
        return f"the statechart has no state {self.label}"

    @property
    def hint(self) -> str | None:
        return f"add `state {self.label} BASIC …`" if self.has_parent else None


class NoStateOfFormula(Unsound):
    """`around` is the innermost state that it would be in, None if there is none; `inside` are its states."""

    code = "E410"
    label: str
    around: str | None
    inside: tuple[str, ...]

    @property
    def message(self) -> str:
        return f"the statechart has no state {self.label}"

    @property
    def hint(self) -> str:
        if self.around is None:
            return "the root is 0"
        if not self.inside:
            return f"{self.around} has nothing inside"
        return f"inside {self.around} there are {self.inside[0]} to {self.inside[-1]}"


class NoStateAround(Unsound):
    code = "E410"
    label: str
    around: str

    @property
    def message(self) -> str:
        return f"{self.label} is inside {self.around}, which the statechart does not have"

    @property
    def hint(self) -> str:
        return f"add `state {self.around} OR`"


# ---- E600 to E612: states ----------------------------------------------------------------------


class NotOneRoot(Unsound):
    code = "E600"
    chart: str
    roots: int

    @property
    def message(self) -> str:
        return f"the statechart {self.chart} has {f'{self.roots} roots' if self.roots else 'no root'}"

    hint = "the root is `state 0 OR`; all others are inside it: 0.1, 0.2, …"


class RootNotOr(Unsound):
    """`type` is the word for the type of a state, here and below."""

    code = "E600"
    label: str
    type: str

    @property
    def message(self) -> str:
        return f"the root is {self.type}, and has to be OR"

    @property
    def hint(self) -> str:
        return f"write `state {self.label} OR`"


class NotOneStart(Unsound):
    code = "E601"
    label: str
    starts: int

    @property
    def message(self) -> str:
        count = f"{self.starts} START states" if self.starts else "no START"
        return f"{self.label} is OR and has {count}"

    @property
    def hint(self) -> str | None:
        return None if self.starts else f"add `state {self.label}.1 START` and a transition from it"


class SeveralEnds(Unsound):
    code = "E602"
    label: str
    ends: int

    @property
    def message(self) -> str:
        return f"{self.label} has {self.ends} END states"

    hint = "lead all ways to one of them"


class TransitionIntoStart(Unsound):
    """`around` is the state that the START is in."""

    code = "E603"
    label: str
    around: str

    @property
    def message(self) -> str:
        return f"{self.label} is a START: it is entered with the state around it, not by a transition"

    @property
    def hint(self) -> str:
        return f"lead to {self.around}, or to what {self.label} leads to"


class TransitionOutOfEnd(Unsound):
    """`around` is the state that the END is in."""

    code = "E604"
    label: str
    around: str

    @property
    def message(self) -> str:
        return f"{self.label} is an END: what follows is a transition of the state around it"

    @property
    def hint(self) -> str:
        return f"let the transition leave {self.around}"


class RegionNotOr(Unsound):
    code = "E605"
    label: str
    type: str

    @property
    def message(self) -> str:
        return f"{self.label} is {self.type}, but what is inside an AND has to be OR"

    @property
    def hint(self) -> str:
        return f"make {self.label} OR, with a START and this state inside"


class NoRegion(Unsound):
    code = "E605"
    label: str

    @property
    def message(self) -> str:
        return f"{self.label} is AND and has no region"

    hint = "two or more OR states run concurrently in it"


class CannotHaveStates(Unsound):
    code = "E606"
    label: str
    type: str

    @property
    def message(self) -> str:
        return f"{self.label} is {self.type} and cannot have states inside"

    @property
    def hint(self) -> str:
        return f"make {self.label} OR"


class LabelTwice(Unsound):
    """`free` is a label that no state has; None for the root."""

    code = "E607"
    label: str
    free: str | None

    @property
    def message(self) -> str:
        return f"two states are labelled {self.label}"

    @property
    def hint(self) -> str | None:
        return f"give one of them another label, such as {self.free}" if self.free is not None else None


class BasicWithoutActivity(Unsound):
    code = "E608"
    label: str

    @property
    def message(self) -> str:
        return f"{self.label} is BASIC, but has no activity"

    @property
    def hint(self) -> str:
        return f"write `state {self.label} BASIC Vision`"


class ActivityOutsideBasic(Unsound):
    code = "E608"
    label: str
    type: str

    @property
    def message(self) -> str:
        return f"{self.label} is {self.type}: only a BASIC state has an activity"

    hint = "make it BASIC, or remove the activity"


class NoPlaceToStay(Unsound):
    code = "E612"
    label: str
    type: str
    verb: str

    @property
    def message(self) -> str:
        return f"{self.label} is {self.type}: an agent does not stay in it"

    @property
    def hint(self) -> str:
        return f"write `{self.verb}` for a BASIC, OR or AND state"


# ---- E613: several targets ---------------------------------------------------------------------


class TargetTwice(Unsound):
    code = "E613"
    label: str

    @property
    def message(self) -> str:
        return f"{self.label} is a target twice"

    hint = "write it once"


class TargetInTarget(Unsound):
    """`around` is the outer one of two targets."""

    code = "E613"
    label: str
    around: str

    @property
    def message(self) -> str:
        return f"the target {self.label} is inside the target {self.around}"

    @property
    def hint(self) -> str:
        return f"remove {self.around}: it is entered with {self.label}"


class TargetsTogether(Unsound):
    """`around` is the OR in which both targets are, `parallel` its AND if it is a region."""

    code = "E613"
    first: str
    second: str
    around: str
    parallel: str | None

    @property
    def message(self) -> str:
        what = f"a region of {self.parallel}" if self.parallel is not None else "not AND"
        return f"the targets {self.first} and {self.second} are both in {self.around}, which is {what}"

    @property
    def hint(self) -> str:
        return f"name one of them: of the states in {self.around}, one is active at a time"


class TargetIsRegion(Unsound):
    """`parallel` is the AND that the region is of."""

    code = "E613"
    label: str
    parallel: str

    @property
    def message(self) -> str:
        return f"the target {self.label} is a region of {self.parallel}"

    hint = "remove it: a region without a target is entered at its START"


class TargetIsChoice(Unsound):
    """`around` is the state that the choice is in."""

    code = "E613"
    label: str
    around: str

    @property
    def message(self) -> str:
        return f"the target {self.label} is a CONDITION: of several targets, each is a state to be active"

    @property
    def hint(self) -> str:
        return f"name {self.around}, if its START leads to the choice, or a branch of the choice"


class TargetsInFormula(Unsound):
    code = "E613"
    message = "a transition of a formula has one target"

    hint = "lead to the AND, or write the role as a `statechart`"


class StateNotReached(Problem):
    """`name` is None where the state has only its label."""

    code = "W600"
    label: str
    name: str | None

    @property
    def message(self) -> str:
        return f"no transition leads to {_called(self.label, self.name)}"

    hint = "lead a transition to it, or remove it"


class StateNotLeft(Problem):
    """`name` is None where the state has only its label."""

    code = "W601"
    label: str
    name: str | None

    @property
    def message(self) -> str:
        return f"no transition leads out of {_called(self.label, self.name)}"

    @property
    def hint(self) -> str:
        return f"lead one out of it; to stay for good, write `{self.label} -> {self.label} :`"


def _called(label: str, name: str | None) -> str:
    return label if name is None else f"{label} `{name}`"


class OneRegion(Problem):
    code = "W602"
    label: str

    @property
    def message(self) -> str:
        return f"{self.label} is AND and has one region"

    hint = "two or more OR states run concurrently in it"
