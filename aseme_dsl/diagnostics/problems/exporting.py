"""Exports: what the format of another tool cannot express (E323)."""

from __future__ import annotations

from enum import Enum

from aseme_dsl.diagnostics.problem import Problem


class Foreign(Enum):
    """What a format may lack; the value is what it is called."""

    ABANDONING = "`on abandon`"
    ACTIONS_INSIDE = "`on`, `exit` and `on abandon`"
    AGENT_MESSAGES = "agent messages, which wait in a conversation"
    ARGUMENTS = "what an activity is given"
    ARITHMETIC = "arithmetic, and functions that are built in"
    ASSIGNING = "an assignment to a variable"
    BOUNDS = "a variable with bounds"
    BRANCHING = "a random choice"
    COMPLETE_AND = "a condition that counts only once a composite is complete: KSE has only `when` there"
    COUNTING = "`count(T)`, which counts entries"
    CROSSING = "a transition between states inside different composites"
    DEADLINES = "the deadline of an activity"
    DIVISION = "division by a value that may be zero"
    DRAFTS = "a member that a later transition publishes"
    ENTERING = "a transition from outside into one region of an AND: the other regions would not start"
    EVENT_OR_ELSE = "a choice between an event and `else`"
    ERRORS = "`error`, which follows a failed activity outwards"
    FUNCTIONS = "a function of what the chart itself changes"
    FIRST_VALUES = "a variable with a first value, or of a participant"
    GIVEN = "what an activity is given, where it may be absent"
    GUARDED_EVENTS = "an event with a condition"
    HOSTS = "a message of one host"
    INSIDE = "`in(T)` or `done(T)` about a state of a concurrent region"
    INSIDE_VALUE = "`in(T)` or `done(T)` inside a computed value"
    INTERRUPTS = "`A [> B`"
    LEAVING = "a transition out of an AND from a region that is not its first"
    LISTS = "lists"
    MESSAGES = "a variable that holds a message or an agent"
    OUTCOMES = "`outcome(A)` where several states perform A"
    OTHER_ACTIVITY = "a state that is not called like its activity"
    OWN_MESSAGES = "a condition on a message that the chart itself publishes"
    PACES = "`every`"
    RAISING = "`raise`"
    RANDOM = "`random()`"
    REACTIVE = "`reactive`"
    READING = "`read_messages`"
    REENTERING = (
        "a transition from inside an AND into several of its regions, where the AND has a time or `exit`"
    )
    RESUMING = "`resume`"
    SETTERS = "a message that is not filled with one member, just before it is published"
    SEVERAL_EVENTS = "several events"
    SEVERAL_TARGETS = "a transition into several regions of an AND"
    SHARING = "a variable that one region changes and another one uses"
    SIGNALS = "a condition on a signal, which is consumed when it is read"
    STATES = "`in(T)`, `done(T)` and `count(T)`"
    STAYING = "`on` without an event"
    STAYING_AROUND = "`on` of a state with concurrent regions"
    STAYING_INSIDE = "`on` in a region of an AND that an event or `when` can leave"
    TEXTS = "a text with one of [ ] / ; and \\, at which KSE cuts an expression"
    TIMED = "`after`"
    TIMES = "a timer whose time is not a whole number of milliseconds"
    TIMED_STAYING = "`on` with `after`"
    VALUES = "a value other than a member, a variable, a constant or the result of a function"
    VARIABLES = "a variable that is not a number, a text or a truth value"
    WAITING = "a state that `waits`"
    WHEN = "`when` of a state that is not a composite"


class NotExpressible(Problem):
    """A construct of `chart` that `format` has no means for."""

    code = "E323"
    chart: str
    format: str
    feature: Foreign
    hint = "see the table of constructs and formats in the documentation of `asemec export`"

    @property
    def message(self) -> str:
        return f"{self.format} cannot express this of `{self.chart}`: {self.feature.value}"


class NotInModel(Problem):
    """What a model for SPIN of a team or protocol (`of`) cannot say: `what`."""

    code = "E323"
    of: str
    what: str
    hint = "see the table of constructs and formats in the documentation of `asemec export`"

    @property
    def message(self) -> str:
        return f"promela cannot express this of {self.of}: {self.what}"


__all__ = ["Foreign", "NotExpressible", "NotInModel"]
