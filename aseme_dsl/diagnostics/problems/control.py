"""Control: what cannot be right in control lines and the choices that they decide (E40x–E43x, W40x–W43x)."""

from __future__ import annotations

from typing import Literal, assert_never

from aseme_dsl.diagnostics.problem import Problem
from aseme_dsl.diagnostics.wording import first_of, listed

NeverHappens = Literal["action", "repetition", "end", "entry"]
"""What comes of a transition that is never taken: nothing is done, repeated, at its end, or entered."""
_LISTED = 8
"""How many terms a text lists at most."""

# ---- E401, E402: what a line names -------------------------------------------------------------


class TermAmbiguous(Problem):
    code = "E401"
    term: str
    formula: str
    count: int

    @property
    def message(self) -> str:
        return f"`{self.term}` stands {self.count} times in `{self.formula}`"

    @property
    def hint(self) -> str:
        return "say which one: " + first_of([f"{self.term}#{n}" for n in range(1, self.count + 1)], _LISTED)


class NoWay(Problem):
    """A verb that a term does not have; `ways` are those that it has."""

    code = "E402"
    verb: str
    term: str
    formula: str
    ways: tuple[str, ...]

    @property
    def message(self) -> str:
        return f"`{self.term}` has no way `{self.verb}` in `{self.formula}`"

    @property
    def hint(self) -> str:
        if not self.ways:
            return f"`{self.term}` is all of `{self.formula}`; the ways are those of its terms"
        if len(self.ways) == 1:
            return f"the only way of `{self.term}` is `{self.ways[0]} {self.term}`"
        return f"the ways of `{self.term}` are {first_of([f'{w} {self.term}' for w in self.ways], _LISTED)}"


class NoStayInWhole(NoWay):
    """`on` or `exit` of a whole formula, which is a state where it stands in another one."""

    @property
    def hint(self) -> str:
        return f"say it where `{self.formula}` stands in another formula, or of the terms of this one"


class NoStayInRoot(NoWay):
    """The same of a formula that stands in no other one.

    It is made of `parts`, or is the name of another one.
    """

    parts: tuple[str, ...]

    @property
    def hint(self) -> str:
        if not self.parts:
            return f"say it of the terms of `{self.term}`, in `control {self.term} {{ … }}`"
        lines = [f"{self.verb} {part}" for part in self.parts]
        return f"write a line for each part: {first_of(lines, _LISTED)}"


class NoWayIntoFormula(NoWay):
    """A term that is the name of another formula."""

    @property
    def hint(self) -> str:
        return f"what happens inside `{self.term}` is said in `control {self.term} {{ … }}`"


class NoWayButOfBody(NoWay):
    body: str

    @property
    def hint(self) -> str:
        does = {"skip": "goes past it", "repeat": "repeats it", "leave": "leaves it"}[self.verb]
        return f"its body is `{self.body}`: `{self.verb} {self.body}` {does}"


class NoStartButOfFirst(NoWay):
    first: str

    @property
    def hint(self) -> str:
        return f"its START leads to its first term: `enter {self.first}`"


class NoLeaveButNext(NoWay):
    following: str

    @property
    def hint(self) -> str:
        return f"what follows `{self.term}` is `{self.following}`: `enter {self.following}`"


# ---- E404 to E412: what lines decide -----------------------------------------------------------


class BranchUndecided(Problem):
    """`decided` is a branch with a condition; `may_be_else` where this one may be the `else`.

    `waits`: another one is taken for an event, for which an `else` does not wait.
    """

    code = "E404"
    branch: str
    decided: str
    may_be_else: bool
    waits: bool = False

    @property
    def message(self) -> str:
        return f"`{self.branch}` has no condition, while `{self.decided}` has one"

    @property
    def hint(self) -> str:
        if self.waits:
            return (
                f"write `{self.branch} : [ … ]` or an event; an `else` waits for none of the events beside it"
            )
        return f"write `{self.branch} : {'else' if self.may_be_else else '[ … ]'}`"


class ChoiceUndecided(Problem):
    code = "E405"
    branches: tuple[str, ...]

    @property
    def message(self) -> str:
        return f"nothing decides this choice: none of {first_of(self.branches, _LISTED)} has a condition"

    @property
    def hint(self) -> str:
        return f"for example `{self.branches[0]} : [ … ]` and `{self.branches[-1]} : else`"


class ElseTwice(Problem):
    code = "E406"
    message = "this is the second `else` beside each other"
    hint = "say when this one is taken, and leave `else` to one of them"


class LoopUndecided(Problem):
    code = "E407"
    repeat: str
    leave: str

    @property
    def message(self) -> str:
        return f"`{self.repeat}` and `{self.leave}` are both without a condition: the loop is never left"

    @property
    def hint(self) -> str:
        body = self.repeat.removeprefix("repeat ")
        decided = f"write `{self.repeat} : [ … ]`, and `{self.leave} : else` or another condition"
        return f"{decided}; for a loop without an end write `{body}~`"


class _OfProtocol(Problem):
    """Control of a role inside of what it plays."""

    code = "E408"
    protocol: str
    participant: str

    @property
    def hint(self) -> str:
        return f"say it in `aip {self.protocol}`, for every role that plays it"


class ControlOfProtocol(_OfProtocol):
    """A control block; `name` is that of a participant or of a formula of it."""

    name: str

    @property
    def message(self) -> str:
        return f"`{self.name}` is the protocol's: no role has control in {self.protocol}.{self.participant}"


class LineInBranch(_OfProtocol):
    """A line from or to a state in the participant's branch, which is `label`."""

    label: str

    @property
    def message(self) -> str:
        branch = f"{self.protocol}.{self.participant}"
        return f"{self.label} is the branch of {branch}: others cannot write control inside it"


class ControlTwice(Problem):
    code = "E411"
    name: str

    @property
    def message(self) -> str:
        return f"`{self.name}` has two control blocks"

    hint = "write their lines into one block: their order is the order in which they are tried"


class ChoicesInCircle(Problem):
    """`labels` begin and end with the same choice."""

    code = "E412"
    labels: tuple[str, ...]

    @property
    def message(self) -> str:
        return f"these choices lead to each other in a circle: {' → '.join(self.labels)}"

    hint = "let one of them lead to a state"


# ---- E420 to E432: lines of their own kind -----------------------------------------------------


class InterruptWaits(Problem):
    """A line for `A [> B`, where `term` is B and `interrupted` is A."""

    code = "E420"
    term: str
    interrupted: str

    @property
    def message(self) -> str:
        return f"`enter {self.term}` interrupts `{self.interrupted}` and needs a trigger: an event or `when`"

    @property
    def hint(self) -> str:
        return (
            f"write `enter {self.term} : when [ … ]`, or name an event; for what follows "
            f"`{self.interrupted}` when it is complete, write `.` in the formula"
        )


class InterruptUndecided(Problem):
    """No line for `A [> B`, where `term` is B and `interrupted` is A.

    `branches` are those of B if it is a choice: each may have a line instead.
    """

    code = "E421"
    term: str
    interrupted: str
    branches: tuple[str, ...] = ()

    @property
    def message(self) -> str:
        return f"no `enter {self.term}` line: `{self.interrupted}` is never interrupted"

    @property
    def hint(self) -> str:
        if self.branches:
            lines = listed(f"enter {branch} : when [ … ]" for branch in self.branches)
            return f"write `enter {self.term} : when [ … ]`, or {lines}; an event may stand for `when`"
        return f"write `enter {self.term} : when [ … ]`, or name an event"


class ElseOfOn(Problem):
    code = "E422"
    state: str

    @property
    def message(self) -> str:
        return f"`on {self.state}` has no `else`: nothing is chosen here"

    @property
    def hint(self) -> str:
        return f"write when it is done: `on {self.state} : when [ … ] / …`"


class ErrorOfOn(Problem):
    """`in_chart` where states have labels, and not terms."""

    code = "E422"
    state: str
    in_chart: bool

    @property
    def message(self) -> str:
        return f"`on {self.state}` cannot take an `error`: what has failed stays failed until it is left"

    @property
    def hint(self) -> str:
        ways = "`0.2 -> 0.3 : error`" if self.in_chart else "`enter …`, `leave …` or `repeat …` with `error`"
        return f"take it on an outgoing transition: {ways}"


class NothingDone(Problem):
    code = "E423"
    verb: str
    state: str

    @property
    def message(self) -> str:
        return f"`{self.verb} {self.state}` does nothing"

    @property
    def hint(self) -> str:
        when = "" if self.verb == "exit" or self.state == "abandon" else "… "
        return f"write what is done: `{self.verb} {self.state} : {when}/ light = true`"


class ExitWaits(Problem):
    code = "E424"
    state: str

    @property
    def message(self) -> str:
        return f"`exit {self.state}` takes no trigger or condition"

    @property
    def hint(self) -> str:
        return f"write `exit {self.state} : / …`; write a condition for leaving on the outgoing transition"


class AbandonWaits(Problem):
    code = "E424"
    message = "`on abandon` takes no trigger or condition"
    hint = "write `on abandon : / …`: its actions are done whenever the participant is left before its END"


class ReactiveWithoutChoice(Problem):
    code = "E425"
    formula: str

    @property
    def message(self) -> str:
        return f"`{self.formula}` has no choice that could be made again"

    hint = "leave `reactive` out, or write it where the choice is: `A | B`, `[A]` or `A*`"


class WeightMisplaced(Problem):
    code = "E434"
    message = "a weight belongs to a branch of a choice, without an event"
    hint = "write it on the `enter` or `skip` lines of a choice: `enter T : [ … ] weight 3`"


class WeightNotPositive(Problem):
    code = "E434"
    message = "a branch with weight 0 is never drawn"
    hint = "write a larger weight, or a condition"


class WeightMissing(Problem):
    """`branch` has no weight, and `weighted` has one."""

    code = "E434"
    branch: str
    weighted: str

    @property
    def message(self) -> str:
        return f"`{self.branch}` has no weight, and `{self.weighted}` has one"

    hint = "give each branch of the choice a weight, or write `else`"


class IgnoresMisplaced(Problem):
    """`ignores` on a line whose verb is not `on`."""

    code = "E435"
    message = "`ignores` belongs to an `on` line"
    hint = "name the state in which the signal is dropped: `on T : ignores …`"


class IgnoredNoSignal(Problem):
    """What is ignored is a message of another kind, or a part of the message `whole`."""

    code = "E435"
    name: str
    whole: str | None = None

    @property
    def message(self) -> str:
        return f"`{self.name}` is not a signal"

    @property
    def hint(self) -> str:
        return f"name a whole signal: `ignores {self.whole or 'topic.signal.Message'}`"


class PeriodOutsideLoop(Problem):
    code = "E432"
    verb: str

    @property
    def message(self) -> str:
        return f"only `repeat` has a pace, not `{self.verb}`"

    hint = "wait with `after(…)`, or give the activity a period"


class PeriodOfLoopNotPositive(Problem):
    code = "E432"
    message = "a pace of no time is none"
    hint = "leave `every` out, or say how long"


# ---- warnings and notes ------------------------------------------------------------------------


class TransitionNotOfFormula(Problem):
    code = "W400"
    source: str
    target: str

    @property
    def message(self) -> str:
        return f"the formula has no transition from {self.source} to {self.target}"

    hint = "with it the chart is no longer the formula's; change the formula if you can"


class ElseBesideTime(Problem):
    """`time` is what else would be waited for."""

    code = "W401"
    time: Literal["limit", "timer"]

    @property
    def message(self) -> str:
        if self.time == "limit":
            why = "the time limit beside it is never waited for"
        else:
            why = "the timer beside it is not waited for"
        return f"`else` is taken as soon as nothing else is enabled: {why}"

    @property
    def hint(self) -> str:
        at_once = "leave the limit out" if self.time == "limit" else "write `[!expired(…)]` instead"
        return f"write the opposite condition instead of `else`; if nothing is to wait here, {at_once}"


class NeverCompletes(Problem):
    """A transition to `target` that waits for completion of `state`; `what` never happens.

    `is_before_choice`: the state `waits`, and behind it is a choice with lines of its own.
    """

    code = "W402"
    state: str
    what: NeverHappens
    target: str
    is_before_choice: bool = False

    @property
    def message(self) -> str:
        return f"`{self.state}` never completes, so that {self._never}"

    @property
    def _never(self) -> str:
        match self.what:
            case "action":
                return "this is never done"
            case "repetition":
                return "it is never repeated"
            case "end":
                return "this is never taken"
            case "entry":
                return f"`{self.target}` is never entered"
            case _:
                assert_never(self.what)

    @property
    def hint(self) -> str:
        if self.is_before_choice:
            return (
                f"the lines of what stands in `{self.target}` come behind the end of `{self.state}`: "
                "let it have `takes` instead of `waits`, and the choice waits for them"
            )
        return "let the transition have an event, `after(…)` or `when [ … ]`, or let every part of it end"


class CycleNeverRests(Problem):
    """`states` begin and end with the same state."""

    code = "W403"
    states: tuple[str, ...]

    @property
    def message(self) -> str:
        names = " → ".join(f"`{name}`" for name in self.states)
        return f"this cycle repeats without an activity, an event or time to wait for: {names}"

    hint = "wait for the completion of an activity, for an event, or for a timer that is started again"


class LoopWithoutPause(Problem):
    """`activities` all return at once; `term` is what the loop repeats."""

    code = "W439"
    activities: tuple[str, ...]
    term: str

    @property
    def message(self) -> str:
        names = ", ".join(f"`{name}`" for name in self.activities)
        verb = "returns" if len(self.activities) == 1 else "return"
        return f"nothing paces this loop: {names} {verb} at once"

    @property
    def hint(self) -> str:
        return f"write `repeat {self.term} every 100ms :`, or wait in an activity: `context.wait(0.1)`"


class ConditionAlwaysFalse(Problem):
    code = "W404"
    message = "this transition is never taken: its condition is always false"
    hint = "write a condition that can hold, or remove the line"


class EventWaits(Problem):
    """The choice with `branch` stands in `term`, which follows `before`."""

    code = "W405"
    branch: str
    before: str
    term: str
    is_when: bool

    @property
    def message(self) -> str:
        what = "`when`" if self.is_when else "the event"
        return f"{what} of `{self.branch}` is waited for only when `{self.before}` is complete"

    @property
    def hint(self) -> str:
        return (
            f"to interrupt `{self.before}`, write `enter {self.term} : when [ … ]` or an event as well; "
            f"if it is to be completed first, write `enter {self.term} :` to say so"
        )


class LoopNeverRepeats(Problem):
    """`leave` is None where the loop has no end."""

    code = "W420"
    repeat: str
    leave: str | None
    message = "the loop never repeats"

    @property
    def hint(self) -> str:
        if self.leave is None:
            return f"let `{self.repeat}` have a condition that can hold"
        return f"let `{self.repeat}` and `{self.leave}` have conditions that can hold and can fail"


class LoopNeverLeft(Problem):
    code = "W420"
    repeat: str
    leave: str
    message = "the loop is never left"

    @property
    def hint(self) -> str:
        return f"let `{self.leave}` and `{self.repeat}` have conditions that can hold and can fail"


class NothingToResume(Problem):
    code = "W430"
    term: str
    verb: str

    @property
    def message(self) -> str:
        return f"`{self.term}` is an activity: it starts anew, as by `{self.verb} {self.term}`"

    @property
    def hint(self) -> str:
        return f"write `{self.verb}` instead of `resume`"


class RegionsWakeEachOther(Problem):
    code = "W436"
    states: tuple[str, ...]

    @property
    def message(self) -> str:
        names = " and ".join(f"`{name}`" for name in self.states)
        return f"these concurrent parts wake each other without end: {names}"

    hint = "let one of them wait for the completion of an activity, for an event, or for a timer"


class ListOfTwoRegions(Problem):
    code = "W440"
    name: str

    @property
    def message(self) -> str:
        return f"two parallel parts change the list `{self.name}`: if both do in one step, a change is lost"

    hint = "let one part change it, and the other one ask for that by an event, a message or another variable"


class EventBesideWhen(Problem):
    """`events` and `condition` as they are written; a condition that is long is None."""

    code = "W441"
    events: tuple[str, ...]
    condition: str | None

    @property
    def message(self) -> str:
        verb = "has" if len(self.events) == 1 else "have"
        why = "the condition counts for both, and `when` waits for nothing else"
        return f"{listed(self.events)} {verb} no effect: {why}"

    @property
    def hint(self) -> str:
        when = f"when [{self.condition or ' … '}]"
        return f"write a line for each: one with `{' or '.join(self.events)}`, one with `{when}`"


class LeftByTimeOnly(Problem):
    """`line` is how the line for completion begins; None where that is too long."""

    code = "N724"
    state: str
    line: str | None

    @property
    def message(self) -> str:
        return f"`{self.state}` is left only by this, not when it is complete"

    @property
    def hint(self) -> str:
        if self.line is None:
            return "if completion is meant to lead there, too, write a line without event beside this one"
        return f"write `{self.line} :` beside it if it is also left when it is complete"
