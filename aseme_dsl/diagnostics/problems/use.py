"""Use: messages, signals, timers, variables and declarations that have only one side (W42x, W52x, N72x).

A channel is written `topic.kind.Message`.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

from aseme_dsl.diagnostics.problem import Problem
from aseme_dsl.diagnostics.wording import did_you_mean, first_of, listed

DeclarationKind = Literal["let", "function", "enum", "message", "functionality"]
"""The word that declares something."""
_SHOWN = 4
"""How many names a text shows at most."""


class DraftNotPublished(Problem):
    """`elsewhere`: another region publishes on the channel."""

    code = "W421"
    channel: str
    elsewhere: bool

    @property
    def message(self) -> str:
        return f"`{self.channel}` is filled here, but never published"

    @property
    def hint(self) -> str:
        if self.elsewhere:
            return "publish it here, too: a draft belongs to the region that fills it"
        return f"publish it: `/ …; write_messages.{self.channel}`"


class MessageNotRead(Problem):
    code = "W422"
    channel: str

    @property
    def message(self) -> str:
        return f"nothing reads `{self.channel}`, which this publishes"

    @property
    def hint(self) -> str:
        return f"let a condition or an activity read it (`reads {self.channel}`), or leave it out"


class TimerNotRead(Problem):
    code = "W423"
    timer: str

    @property
    def message(self) -> str:
        return f"the timer `{self.timer}` is started, but nothing asks whether it has expired"

    @property
    def hint(self) -> str:
        return f"ask for it in a condition: `[expired({self.timer})]`"


class VariablesNeverSet(Problem):
    code = "N437"
    variables: tuple[str, ...]

    @property
    def message(self) -> str:
        return f"nothing sets {listed(self.variables)}, so that a condition never changes"

    @property
    def hint(self) -> str:
        return (
            f"set it in an action, let the activity that does say so, `writes {self.variables[0]}`, or give "
            "it a value in the team: `agent : role with …`"
        )


class SameLineForAll(Problem):
    """All activities inside `around`, or (None) of the role, have one line; `count` is how many there are."""

    code = "N442"
    count: int
    role: str
    around: str | None

    @property
    def message(self) -> str:
        where = f"`{self.role}`" if self.around is None else f"`{self.around}`"
        return f"all {self.count} activities of {where} have this line"

    @property
    def hint(self) -> str:
        if self.around is None:
            return f"write it once, with the whole formula of `{self.role}`: `on ( … ) : …`"
        return f"write it once: `on {self.around} : …`"


class TimerNotStarted(Problem):
    """`elsewhere`: another region of the role starts it; otherwise `close` is a timer that is spelt alike."""

    code = "W501"
    timer: str
    elsewhere: bool
    close: str | None

    @property
    def message(self) -> str:
        return f"the timer `{self.timer}` is never started here, so it never expires"

    @property
    def hint(self) -> str:
        if self.elsewhere:
            return "a timer belongs to the region that starts it; this is another one of the same role"
        if self.close is not None:
            return did_you_mean(self.close)
        return f"start it on the way there: / start_timer({self.timer}, 1s)"


class SignalNotRead(Problem):
    code = "W520"
    channel: str

    @property
    def message(self) -> str:
        return f"nothing reads the signal `{self.channel}`"

    @property
    def hint(self) -> str:
        return f"let a condition ask for it, or an activity that wants it say `reads {self.channel}`"


class SignalAlreadyConsumed(Problem):
    code = "W521"
    channel: str

    @property
    def message(self) -> str:
        return f"signal `{self.channel}` is already consumed when this condition reads it"

    hint = "read it once and store what you need in a variable"


class SignalConsumedBeforeActivity(Problem):
    code = "W521"
    channel: str
    activity: str

    @property
    def message(self) -> str:
        return (
            f"`{self.activity}` reads the signal `{self.channel}`, but this looks at each one first: "
            "a signal that was looked at is consumed when the step ends"
        )

    @property
    def hint(self) -> str:
        return f"let `{self.activity}` raise an event for this, or stand in a region of its own"


class SignalTakenLate(Problem):
    """`states` cannot take the signal."""

    code = "W525"
    channel: str
    states: tuple[str, ...]

    @property
    def message(self) -> str:
        return (
            f"a signal `{self.channel}` that comes in {listed(self.states)} is taken here afterwards, "
            "however old it is"
        )

    @property
    def hint(self) -> str:
        return (
            f"let it expire (`{_carried(self.channel)} expires 2s` on its topic), or drop it: "
            f"`on {self.states[0]} : ignores {self.channel}`"
        )


class MessageNotPublished(Problem):
    code = "W522"
    channel: str

    @property
    def message(self) -> str:
        return f"nothing in this system publishes `{self.channel}`"

    @property
    def hint(self) -> str:
        return _from_outside(self.channel, ())


class WindowTooShort(Problem):
    """`window` and `period` are durations as the language writes them."""

    code = "W523"
    channel: str
    window: str
    period: str

    @property
    def message(self) -> str:
        return f"a mean over {self.window} of what comes every {self.period} often has no value"

    @property
    def hint(self) -> str:
        return f"look back longer than {self.period}, or read the newest value: `{self.channel}`"


class AgentMessageUnmatched(Problem):
    """`agent_message` is the performative and the type."""

    code = "W524"
    participant: str
    clause: Literal["sends", "receives"]
    agent_message: str

    @property
    def message(self) -> str:
        return (
            f"`{self.participant}` {self.clause} `{self.agent_message}`, and no participant {self._other} it"
        )

    @property
    def hint(self) -> str:
        return (
            f"write `{self._other} {self.agent_message}` of the participant that does, or leave it out here"
        )

    @property
    def _other(self) -> str:
        return "receives" if self.clause == "sends" else "sends"


UNSENT = "this is not sent, and the state behind it fails"


class ActionNeedsMessage(Problem):
    code = "N720"
    channel: str
    is_sent: bool

    @property
    def message(self) -> str:
        what = UNSENT if self.is_sent else "this action is not done"
        return f"no `{self.channel}` may have come yet: then {what}"

    @property
    def hint(self) -> str:
        return f"let the transition wait for it, `[has({self.channel})]`, or do this where it is there"


class SentWithoutMember(Problem):
    """What is sent has an optional member of the message that the line takes."""

    code = "N720"
    type: str
    member: str

    @property
    def message(self) -> str:
        return f"`{self.member}` of `{self.type}` may be absent: then {UNSENT}"

    @property
    def hint(self) -> str:
        return f"let the line wait for it, `[has(….{self.member})]`, and write one for the other case"


class ElseWithoutMessage(Problem):
    code = "N720"
    channel: str

    @property
    def message(self) -> str:
        return f"while no `{self.channel}` has come, this does not hold, and `else` is taken"

    @property
    def hint(self) -> str:
        return (
            f"write `!has({self.channel}) || …` if this is meant then, else `!has({self.channel})` in a "
            "branch of its own"
        )


class ChangesUnseen(Problem):
    code = "N721"
    function: Literal["at", "mean"]
    channel: str

    @property
    def message(self) -> str:
        return f"`{self.function}` is looked at when something arrives, not when time passes"

    @property
    def hint(self) -> str:
        return (
            f"say how often `{self.channel}` comes (`every` on its topic, or of the activity that publishes "
            "it), or wait with `after(…)` beside it"
        )


class PublishersNotDeclared(Problem):
    """`silent` are the activities with code of whose messages nothing is said."""

    code = "N722"
    channels: tuple[str, ...]
    silent: tuple[str, ...]

    @property
    def message(self) -> str:
        are = "is" if len(self.channels) == 1 else "are"
        return f"nothing says who publishes {listed(self.channels)}, which {are} read"

    @property
    def hint(self) -> str:
        return _from_outside(self.channels[0], self.silent)


class ExitWaitsForUndeclared(Problem):
    """`silent` are the activities with code of whose messages nothing is said."""

    code = "N722"
    channel: str
    state: str
    silent: tuple[str, ...]

    @property
    def message(self) -> str:
        state = f"the only outgoing transition of `{self.state}` waits for it"
        return f"nothing says who publishes `{self.channel}`; {state}"

    @property
    def hint(self) -> str:
        return _from_outside(self.channel, self.silent)


class PublishedBySeveral(Problem):
    """`agents` are those of the roles that publish, of which `publisher` is the first."""

    code = "N723"
    role: str
    channel: str
    agents: tuple[str, ...]
    publisher: str

    @property
    def message(self) -> str:
        return (
            f"`{self.role}` publishes no `{self.channel}` itself: it reads that of "
            f"{first_of(self.agents, _SHOWN)}, any of them"
        )

    @property
    def hint(self) -> str:
        return (
            f"read one agent's: `{self.agents[0]}.{self.channel}`; if all are meant, say that it is the "
            f"team's: `{_carried(self.channel)} from {self.publisher}`"
        )


class VariableNotRead(Problem):
    code = "N725"
    variable: str

    @property
    def message(self) -> str:
        return f"no condition, action or activity reads the variable `{self.variable}`"

    @property
    def hint(self) -> str:
        return f"if an activity does, let it say so: `reads {self.variable}`; otherwise leave it out"


class ResultNotTaken(Problem):
    """A role plays `participant` and takes no `variable`, which is a result of it."""

    code = "N725"
    variable: str
    participant: str

    @property
    def message(self) -> str:
        return f"nothing reads the result `{self.variable}` of `{self.participant}`"

    @property
    def hint(self) -> str:
        return f"give it to a variable: `with {self.variable} = …`"


class DeclarationNotUsed(Problem):
    code = "N727"
    kind: DeclarationKind
    name: str

    @property
    def message(self) -> str:
        return f"nothing uses the {self.kind} `{self.name}`"

    hint = "use it, or leave it out"


class ImportedTwice(Problem):
    code = "N727"
    target: str

    @property
    def message(self) -> str:
        return f"`{self.target}` is imported already"

    hint = "leave one of them out"


class ImportNotUsed(Problem):
    code = "N727"
    target: str

    @property
    def message(self) -> str:
        return f"nothing uses what `{self.target}` declares"

    hint = "use it, or leave the import out"


class RoleWithoutAgent(Problem):
    code = "N728"
    role: str

    @property
    def message(self) -> str:
        return f"no agent has the role `{self.role}`"

    @property
    def hint(self) -> str:
        return f"give it to one in a `team`: `name : {self.role}`"


def _from_outside(channel: str, silent: Sequence[str]) -> str:
    """What to write where a message comes from outside, or else from one of these activities."""
    these = f" ({first_of(silent, _SHOWN)})" if silent else ""
    return (
        f"for what comes from outside, write `{_carried(channel)} from outside`; "
        f"an activity that publishes it{these} says `writes {channel}`"
    )


def _carried(channel: str) -> str:
    """The kind and the message of a channel, as a topic declares them."""
    parts = channel.split(".")
    kind = next(at for at, part in enumerate(parts) if at and part in ("signal", "state", "data"))
    return f"{parts[kind]} {'.'.join(parts[kind + 1 :])}"


__all__ = [
    "ActionNeedsMessage",
    "AgentMessageUnmatched",
    "ChangesUnseen",
    "DeclarationKind",
    "DeclarationNotUsed",
    "DraftNotPublished",
    "ElseWithoutMessage",
    "ExitWaitsForUndeclared",
    "ImportNotUsed",
    "ImportedTwice",
    "MessageNotPublished",
    "MessageNotRead",
    "PublishedBySeveral",
    "PublishersNotDeclared",
    "ResultNotTaken",
    "RoleWithoutAgent",
    "SentWithoutMember",
    "SignalAlreadyConsumed",
    "SignalConsumedBeforeActivity",
    "SignalNotRead",
    "TimerNotRead",
    "VariableNotRead",
    "VariablesNeverSet",
    "WindowTooShort",
]
