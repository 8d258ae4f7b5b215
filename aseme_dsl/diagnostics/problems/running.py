"""Building and running: options, inputs, starts, running teams, traces, backends (E028–E035, E32x)."""

from __future__ import annotations

from enum import Enum
from typing import ClassVar

from aseme_dsl.diagnostics.problem import Problem
from aseme_dsl.diagnostics.wording import did_you_mean, listed

# ---- E028 to E031: what a command is given -----------------------------------------------------


class OptionWithoutEffect(Problem):
    code = "E028"
    option: str
    why: ClassVar[str]
    """What follows "has no effect"."""

    @property
    def message(self) -> str:
        return f"`{self.option}` has no effect {self.why}"


class AgentWithoutRole(OptionWithoutEffect):
    why = "without `--role`"
    hint = "add `--role ROLE`; without it, the whole team runs"


class NetworkOfOneAgent(OptionWithoutEffect):
    why = "with `--role`, which runs one agent"
    hint = "leave it out, or run the whole team"


class WithList(OptionWithoutEffect):
    why = "with `--list`, which runs nothing"
    hint = "leave it out"


class WithQuiet(OptionWithoutEffect):
    why = "with `--quiet`"
    hint = "leave one of them out"


class OnOutput(OptionWithoutEffect):
    why = "on an output directory, which is run as it is"
    hint = "leave it out"


class OnOutputOfTarget(OnOutput):
    """Where the target may be a source as well."""

    hint = "leave it out, or name the .aseme file or the project directory to build"


class OnOutputWithoutBackend(OptionWithoutEffect):
    """`backend`: what was not built."""

    backend: str
    why = "on an output directory without its files"

    @property
    def hint(self) -> str:
        return f"build with `--backend {self.backend}` first"


class WithProcesses(OptionWithoutEffect):
    why = "where each agent is a process"
    hint = "leave it out: the agents stop by themselves or at the time limit"


class WithFrom(OptionWithoutEffect):
    why = "with `--from`"
    hint = "name one of them"


class OnOneSystem(OptionWithoutEffect):
    why = "on a target with one system"
    hint = "leave it out, or name the output directory"


class WithJson(OptionWithoutEffect):
    """Which form an output has."""

    why = "with `--json`, which prints rows"
    hint = "write a file with -o, or leave one out"


class AgentNotInTrace(Problem):
    """`close`: the one of `team` that is spelt alike."""

    code = "E029"
    agent: str
    close: str | None
    team: tuple[str, ...]

    @property
    def message(self) -> str:
        return f"the trace has nothing about an agent `{self.agent}`"

    @property
    def hint(self) -> str:
        return did_you_mean(self.close) if self.close else f"the team has {', '.join(self.team)}"


class NoTemplates(Problem):
    """`is_file`: there is a file instead of the folder."""

    code = "E030"
    is_file: bool
    hint = "name the folder that holds the templates"

    @property
    def message(self) -> str:
        return f"the folder of templates {'is a file' if self.is_file else 'does not exist'}"


class WrongLine(Problem):
    """`reason`: what the runtime says of the line."""

    code = "E031"
    reason: str

    @property
    def message(self) -> str:
        return self.reason


# ---- E032: which agent, plan or system is meant ------------------------------------------------


class NotChosen(Problem):
    """`name` is none of `known`, of which `close` is spelt alike; or it is several of them."""

    code = "E032"
    name: str
    close: str | None
    known: tuple[str, ...]

    @property
    def hint(self) -> str:
        there = f"there are {', '.join(self.known)}" if self.known else "there is none"
        return f"did you mean `{self.close}`? {there}" if self.close else there


class NoSuchPlan(NotChosen):
    @property
    def message(self) -> str:
        return f"no plan is called `{self.name}`"


class SeveralPlans(NotChosen):
    @property
    def message(self) -> str:
        return f"several plans are called `{self.name}`"


class NoSuchRobot(NotChosen):
    @property
    def message(self) -> str:
        return f"there is no robot `{self.name}`"


class NoAgentForBody(NotChosen):
    @property
    def message(self) -> str:
        return f"there is no agent `{self.name}` for a body"


class NoTeamForRobot(Problem):
    code = "E032"
    system: str
    robot: str

    @property
    def message(self) -> str:
        return f"{self.system} declares no team, so it has no robot `{self.robot}`"


class SystemNotChosen(Problem):
    """`plans`: all that there are."""

    code = "E032"
    plans: tuple[str, ...]
    message = "there are several systems"

    @property
    def hint(self) -> str:
        return f"choose a plan of {', '.join(self.plans)}"


class NoSuchSystem(Problem):
    """`system`: None where none of the `known` ones was chosen."""

    code = "E032"
    system: str | None
    known: tuple[str, ...]

    @property
    def message(self) -> str:
        return f"there is no system `{self.system}`" if self.system else "there are several systems"

    @property
    def hint(self) -> str:
        return f"choose one with --system; there are {', '.join(self.known)}"


# ---- E033: why nothing is played ---------------------------------------------------------------


class NotPlayed(Problem):
    """`reason`: what the runtime, a platform or the operating system says."""

    code = "E033"
    reason: str

    @property
    def message(self) -> str:
        return self.reason


class NothingGenerated(Problem):
    code = "E033"
    folder: str

    @property
    def message(self) -> str:
        return f"there is nothing generated in {self.folder}: build something into it first"


class VersionWithoutPlan(Problem):
    code = "E033"
    package: str
    plan: str

    @property
    def message(self) -> str:
        return f"{self.package} has no plan {self.plan}"


class FileNotWritten(Problem):
    """`reason`: what the operating system says."""

    code = "E033"
    path: str
    reason: str

    @property
    def message(self) -> str:
        return f"{self.path} cannot be written: {self.reason}"


class ScriptNotRead(Problem):
    """`reason`: what the operating system says."""

    code = "E033"
    path: str
    reason: str

    @property
    def message(self) -> str:
        return f"{self.path} cannot be read: {self.reason}"


class ScriptNotUtf8(Problem):
    code = "E033"
    path: str

    @property
    def message(self) -> str:
        return f"{self.path} is not UTF-8"


class HostOfNobody(Problem):
    """The file `path` has a host for a robot that is none of the `team`."""

    code = "E033"
    path: str
    robot: str
    team: tuple[str, ...]

    @property
    def message(self) -> str:
        there = ", ".join(self.team)
        return f"{self.path}: there is no agent {self.robot} in the team; there are {there}"


class AgentWithoutHost(Problem):
    """The file `path` has hosts, but none for a robot of the team."""

    code = "E033"
    path: str
    robot: str

    @property
    def message(self) -> str:
        why = "it has no host, and there is no interface to look on"
        return f"{self.path}: no agent would find {self.robot}: {why}"


class WorldInOnePlace(Problem):
    code = "E033"
    message = (
        "the project's world is simulated in one place: play the whole team with"
        " `asemec run --process-per-agent`, or give the robot a body with --body"
    )


class ControlWithoutZenoh(Problem):
    code = "E033"
    platform: str

    @property
    def message(self) -> str:
        return f"operators control robots over zenoh only, not over {self.platform}: remove `control`"


class KeysNotRead(Problem):
    """`reason`: what the runtime says of the file of keys."""

    code = "E033"
    reason: str

    @property
    def message(self) -> str:
        return f"operators' keys: {self.reason}"


class ModuleNotImported(Problem):
    """`error`: what it raises, with its type."""

    code = "E033"
    module: str
    error: str

    @property
    def message(self) -> str:
        return f"{self.module} cannot be imported: {self.error}"


class FunctionFailed(Problem):
    """A function of the project; `error`: what it raises, with its type; `place`: where, with the line."""

    code = "E033"
    function: str
    error: str
    place: str

    @property
    def message(self) -> str:
        return f"{self.function} failed: {self.error} ({self.place})"


class NoWorld(Problem):
    """`missing`: each thing that a world has, and this has not, with what it is."""

    code = "E033"
    function: str
    value: str
    missing: tuple[tuple[str, str], ...]

    @property
    def message(self) -> str:
        missing = "; ".join(f"{name}, {what}" for name, what in self.missing)
        return f"{self.function} gave {self.value}, which is not a world: it needs {missing}"


class NoBodyInMatch(Problem):
    """`function` has made a world of a match that has no body of the name `seat`."""

    code = "E033"
    function: str
    seat: str

    @property
    def message(self) -> str:
        return f"{self.function} gave a world that has no body `{self.seat}`"


class NoScore(Problem):
    """`function` has made a world that does not say how a match stands."""

    code = "E033"
    function: str

    @property
    def message(self) -> str:
        return f"{self.function} gave a world whose `score` is not two numbers, one of each team"


class TeamOfMatch(Problem):
    """A team that cannot take part in a match, since its system declares no team."""

    code = "E033"
    system: str
    hint = "add a `team` with the agents that play"

    @property
    def message(self) -> str:
        return f"{self.system} declares no team, so it cannot play"


class NoTeam(Problem):
    code = "E033"
    system: str

    @property
    def message(self) -> str:
        return f"{self.system} declares no team, so there are no robots to start"


class WorldNotMade(Problem):
    code = "E033"
    message = "the world could not be made"


class ProcessNotStarted(Problem):
    """`robot`: None for the world; `end`: how the process ended."""

    code = "E033"
    robot: str | None
    end: str

    @property
    def message(self) -> str:
        return f"{self.robot or 'the world'} could not be started ({self.end})"


class StartTooSlow(Problem):
    """`seconds` have passed."""

    code = "E033"
    is_world: bool
    seconds: float

    @property
    def message(self) -> str:
        what = "the world does not start" if self.is_world else "some agents do not get ready"
        return f"{what}: {self.seconds:g} s have passed"


# ---- E034, E035: running teams and traces ------------------------------------------------------


class NotDone(Problem):
    """What was asked of robots that run; `reasons`: what they, or the network, say."""

    code = "E034"
    reasons: tuple[str, ...]

    @property
    def message(self) -> str:
        return "\n".join(self.reasons)


class NotOneTeam(Problem):
    """`systems`: those with a team in the output folder."""

    code = "E034"
    output: str
    systems: tuple[str, ...]

    @property
    def message(self) -> str:
        systems = ", ".join(self.systems) or "none"
        return f"{self.output} must have one system with a team; it has {systems}"


class TraceNotRead(Problem):
    """`reason`: what the reader of traces says."""

    code = "E035"
    reason: str

    @property
    def message(self) -> str:
        return self.reason


class NotOfThisModel(Problem):
    """A run of another version of the system; `who` are the agents or roles that had another model."""

    code = "E035"
    system: str
    who: tuple[str, ...]
    hint = "measure with the files of that run, or run again"

    @property
    def message(self) -> str:
        return f"{listed(self.who)} ran another version of `{self.system}`"


# ---- E320 to E322: what a backend cannot do ----------------------------------------------------


class AgentFeature(Enum):
    """What only agents can do; the value is what it is called."""

    AGENT_MESSAGES = "the messages of agents"
    AGENTS = "other agents"
    AGES = "how old a message is"
    BOUNDS = "the bounds of a variable beside an `error` transition"
    DATA = "data with its time of measurement, and looking back"
    DEADLINES = "the deadline of an activity"
    ENTERING = "leading into a region of an AND"
    GIVEN = "what an activity is given, where that may be absent or fail"
    LEAVING = "leading out of an AND from inside"
    NUMBERS = "the number of an agent"
    PROTOCOLS = "what a participant of a protocol does"
    PUBLISHING = "publishing"
    RAISING = "`raise` (a program sends events)"
    READING = "reading messages during a step"
    RESUMING = "`resume`"
    SIGNALS = "signals (a program sends events)"
    STAYING = "`on` without an event of the program"


class SingleFeature(Enum):
    """What one statechart can do and a batch cannot; the value is what it is called."""

    BOUNDS = "the bounds of variables"
    CHANCE = "random numbers (draw the values of variables for all at once)"
    CONDITIONALS = "a choice between two values, `c ? a : b` (two transitions it can)"
    DIVISION = "division by what may be zero (by a number that is written there it can)"
    FUNCTIONS = "functions that are written in Python"
    MESSAGES = "messages (what it sees are variables)"
    OUTCOMES = "the outcome or the failure of an activity"
    SCALING = "a duration times what may be no number (times one that is written there it can)"
    TIMERS = "timers and `every` (there is `after`)"
    TYPES = "values that are neither Booleans nor numbers"


class Unsupported(Problem):
    """What a program that is made of `chart` cannot do."""

    chart: str
    feature: AgentFeature | SingleFeature
    program: ClassVar[str]

    @property
    def message(self) -> str:
        return f"{self.program} `{self.chart}` cannot do this: {self.feature.value}"


class NotPlain(Unsupported):
    code = "E320"
    program = "a plain statechart such as"
    hint = (
        "another backend makes agents of the roles, which can; `--backend ROLE=plain` leaves other roles out"
    )


class NotBatch(Unsupported):
    """Nor can a plain statechart do it."""

    code = "E321"
    program = "a batch of"
    hint = "`--backend monas` makes agents of the roles, which can"


class NotBatchButPlain(Unsupported):
    code = "E321"
    program = "a batch of"
    hint = "`--backend plain` can, one instance at a time"


class NotCompiled(Problem):
    """To machine code; `reason`: what the compiler says."""

    code = "E322"
    reason: str
    hint = "without --native it runs as Python"

    @property
    def message(self) -> str:
        return self.reason
