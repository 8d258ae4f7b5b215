"""The oracle: an interpreter of the semantics that works on a plan, as plain as its text.

What the text says stands in quotation marks above what does it. Everything is kept in sets and dictionaries
of labels and looked up again whenever it is needed: nothing here is fast, and nothing here is clever.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property, reduce
from importlib import import_module
from itertools import pairwise
from operator import add
from random import Random
from typing import Any

from aseme_dsl.amola.statechart import label_key
from aseme_dsl.runtime.chart.inputs import (
    Addressed,
    AgentMessage,
    Cancel,
    Completed,
    Crashed,
    Fault,
    FunctionResult,
    Happened,
    Identity,
    Input,
    Joined,
    Left,
    MailTaken,
    Outcome,
    Publication,
    Resumed,
    Sample,
    Sending,
    Settled,
    SignalExpired,
    Start,
    Suspended,
    Written,
)
from aseme_dsl.runtime.chart.plan import Plan, Term, Transition

ROUNDS = 1000
"""The "bound" of a step."""


class Absent:
    """A value that is not there: "a message that has not arrived", and what is computed from one."""

    def __repr__(self) -> str:
        return "absent"


ABSENT = Absent()


@dataclass
class Region:
    """What one active region has: its blackboard, its drafts, its timers and its copy of the variables."""

    label: str
    states: dict[str, list[Sample]] = field(default_factory=dict)
    data: dict[str, list[Sample]] = field(default_factory=dict)
    signals: dict[str, list[Sample]] = field(default_factory=dict)
    timers: dict[str, int] = field(default_factory=dict)
    drafts: dict[tuple[str, str | None], dict[tuple[str, ...], Any]] = field(default_factory=dict)
    variables: dict[str, Any] = field(default_factory=dict)
    asked: list[Sample] = field(default_factory=list)
    """The signals that were looked at in this step."""
    seen: dict[tuple[str, str | None], Sample | None] = field(default_factory=dict)
    """What was seen when a signal channel was last looked at in this step."""
    read_ahead: set[Identity] = field(default_factory=set)
    """What `read_messages` has put on the board before it comes as an input."""

    def put(self, message: Sample, queued: bool) -> None:
        """Write a message onto the blackboard.

        "`state`: the latest value of each sender (and of any). `data`: values with their time of measurement.
        `signal`: … a newer one of the same sender, topic and type replaces an unread one unless the topic
        says `queued`" (and takes its place in the order of arrival).
        """
        kind = message.channel.split(".")[1]
        if kind == "state":
            self.states.setdefault(message.channel, []).append(message)
        elif kind == "data":
            self.data.setdefault(message.channel, []).append(message)
        else:
            waiting = self.signals.setdefault(message.channel, [])
            of_the_same_sender = [n for n, other in enumerate(waiting) if other.sender == message.sender]
            if of_the_same_sender and not queued:
                waiting[of_the_same_sender[0]] = message
            else:
                waiting.append(message)

    def sees(self, channel: str, host: str | None) -> Sample | None:
        """What an expression sees: the latest state, the oldest waiting signal, the newest data."""
        kind = channel.split(".")[1]
        if kind == "state":
            found = of_sender(self.states.get(channel, []), host)
            return found[-1] if found else None
        if kind == "signal":
            found = of_sender(self.signals.get(channel, []), host)
            return found[0] if found else None
        return newest(of_sender(self.data.get(channel, []), host))

    def look_at(self, channel: str, host: str | None) -> None:
        """ "Whenever a condition that names a signal channel is evaluated … that channel is asked." """
        message = self.sees(channel, host)
        self.seen[channel, host] = message
        if message is not None:
            self.asked.append(message)

    def drop(self, message: Sample) -> bool:
        """Take a signal away if it is still the same one; whether it was."""
        waiting = self.signals.get(message.channel, [])
        for n, other in enumerate(waiting):
            if other is message:
                del waiting[n]
                return True
        return False


def of_sender(messages: list[Sample], host: str | None) -> list[Sample]:
    return [message for message in messages if host is None or message.sender == host]


def newest(messages: list[Sample]) -> Sample | None:
    """The one measured last; of several measured at one moment the one that came last."""
    found = None
    for message in messages:
        if found is None or message.time >= found.time:
            found = message
    return found


GIVEN = {"plan", "agent", "messages", "pending", "initial", "seed", "endless", "chance", "outcome"}
"""What is no part of the interpreter's state: what it is given, and the outcome of its last step."""


def frozen(value: Any) -> Any:
    """What holds the same as a list, dictionary or set, and cannot be changed."""
    match value:
        case dict():
            return dict, tuple((key, frozen(item)) for key, item in value.items())
        case list() | set():
            return type(value), tuple(frozen(item) for item in value)
        case tuple():
            return tuple, tuple(frozen(item) for item in value)
        case Region():
            return Region, tuple((key, frozen(item)) for key, item in vars(value).items())
    return value


def thawed(value: Any) -> Any:
    """What `frozen` was given."""
    match value:
        case (kind, items) if kind is dict or kind is Region:
            found = {key: thawed(item) for key, item in items}
            return found if kind is dict else Region(**found)
        case (kind, items) if kind in (list, set, tuple):
            return kind(thawed(item) for item in items)
    return value


class Reference:
    """A running chart, like the generated step classes but interpreted from the plan's words.

    `messages` gives the class of each message and enum by its name. `pending` gives what has arrived since
    the step began, for `read_messages`.
    """

    def __init__(self, plan: Plan, agent: str, messages: Mapping[str, Any]) -> None:
        self.plan = plan
        self.agent = agent
        self.messages = messages
        self.pending: Callable[[], Iterable[Sample]] = tuple

        self.now = 0
        self.started = False
        self.finished = False
        self.failure: str | None = None

        self.active: set[str] = set()
        self.complete: set[str] = set()
        """BASIC states whose activity has completed."""
        self.failed: dict[str, str] = {}
        """BASIC states whose activity has failed, with the reason."""
        self.entered: dict[str, int] = {}
        """When each active state was entered."""
        self.token: dict[str, int] = {}
        """With which token the activity of a BASIC state was started last."""
        self.tokens = 0
        self.ended: dict[str, str | Absent] = {}
        """How the activity of each state that was ever entered has ended, in the order of these events."""
        self.entries: dict[str, int] = {}
        """How often each state was entered since its loop was."""
        self.asking = ""
        """The source of the transition whose condition or action is looked at."""

        named = {item.name for item in plan.activities if item.waits}
        self.endless = {state.label for state in plan.states if state.activity in named}
        """BASIC states that never complete by themselves."""

        self.regions: dict[str, Region] = {}
        """The active regions by label."""
        self.initial = {variable.name: variable.initial for variable in plan.variables}
        # "what is set in an agent" holds at first
        self.initial |= {name: value for whose, name, value in plan.settings if whose == agent}
        self.seed = 1
        self.chance: Random | None = None
        self.writes: list[tuple[str, str, Any]] = []
        """The writes of the step to variables: (region, variable, value)."""
        self.rounds: dict[tuple[str, str], dict[str, Any]] = {}
        self.earlier: dict[tuple[str, str], list[str]] = {}
        self.mailbox: dict[str, list[AgentMessage]] = {branch.label: [] for branch in plan.branches}
        self.came: dict[Identity, int] = {}
        """When each agent message came."""
        self.found: dict[int, AgentMessage | None] = {}
        """What each transition that speaks of it would take, when it was looked at last."""
        self.in_hand: AgentMessage | None = None
        """The agent message that a condition or an action speaks of."""
        self.events: set[str] = set()
        self.raised: list[str] = []
        """The events that actions have raised, and that have not come yet."""
        self.spent: set[tuple[str, str]] = set()
        """(region, event): what a region has spent in this step."""
        self.faulty: set[int] = set()
        """Transitions of which a fault was recorded in this step."""
        self.noticed: dict[int, list[Any]] = {}
        """What each `on` transition has seen when it was taken last, since its state was entered."""
        self.kept: dict[str, tuple[set[str], set[str]]] = {}
        """Of states that may be resumed: what was active in them when they were left, what of it complete."""
        self.suspended: dict[str, tuple[int, dict[str, dict[str, int]], Region]] = {}
        """The branches that may go on: when each was left, and the timers of each region that stand still."""
        self.abandoning: tuple[int, ...] = ()
        """The `on abandon` line that is done now."""
        self.left_with: dict[str, dict[str, int]] = {}
        """The timers that regions had when they were left last."""
        self.held: set[str] = set()
        """The branches that are suspended by the transition which is being taken."""
        self.waited: dict[int, int] = {}
        """The longest `after` by which an `on` transition was taken, since its state was entered."""
        self.breach: tuple[str, str] | None = None
        """The state that is entered though a write on the way was outside of the bounds, and why."""
        self.outcome = Outcome()

    # ---- as a value -------------------------------------------------------------------------

    def save(self) -> Any:
        """The whole state between two steps, as a plain immutable value."""
        kept = {name: value for name, value in vars(self).items() if name not in GIVEN}
        return frozen(kept), self.chance and self.chance.getstate()

    def load(self, saved: Any) -> None:
        """Take a state that was saved."""
        values, chance = saved
        vars(self).update(thawed(values))
        self.chance = None
        if chance is not None:
            self.chance = Random()
            self.chance.setstate(chance)

    # ---- what the plan says -----------------------------------------------------------------

    def type_of(self, label: str) -> str:
        return self.plan.by_label[label].type

    def children(self, label: str) -> list[str]:
        """The states directly inside, in document order."""
        return [state.label for state in self.plan.children(label)]

    def root(self) -> str:
        return next(state.label for state in self.plan.states if state.parent is None)

    def parent(self, label: str) -> str | None:
        return self.plan.by_label[label].parent

    def around(self, label: str) -> list[str]:
        """The states around `label`, innermost first."""
        found = []
        parent = self.parent(label)
        while parent is not None:
            found.append(parent)
            parent = self.parent(parent)
        return found

    def is_region(self, label: str) -> bool:
        """ "A *region* is the root or an OR child of an AND." """
        parent = self.parent(label)
        return parent is None or self.type_of(parent) == "AND"

    def region_of(self, label: str) -> str:
        """ "Conditions, actions and activities use the innermost region around them." """
        return next(state for state in [label, *self.around(label)] if self.is_region(state))

    def branch_of(self, label: str) -> str:
        """The protocol branch in which `label` stands."""
        return next(state for state in [label, *self.around(label)] if state in self.mailbox)

    def place(self, label: str) -> int:
        """The place of a state in document order."""
        return [state.label for state in self.plan.states].index(label)

    def scope(self, source: str, target: str) -> str:
        """ "The scope of a transition is the lowest OR state that holds source and target."

        Of a compound transition it is the outermost of its segments' scopes.
        """
        holds_target = self.around(target)
        return next(s for s in self.around(source) if s in holds_target and self.type_of(s) == "OR")

    # ---- what can be asked between steps ----------------------------------------------------

    def leaf(self, region: str) -> str:
        """The active leaf of a region: a state without active states in it, or an AND."""
        label = region
        while self.type_of(label) == "OR":
            label = next(child for child in self.children(label) if child in self.active)
        return label

    def configuration(self) -> tuple[str, ...]:
        """ "The *configuration* is one active path per region": the leaves, region by region."""
        in_order = sorted(self.regions, key=self.place)
        return tuple(self.leaf(region) for region in in_order if region in self.active)

    def variable(self, name: str) -> Any:
        return self.regions[self.root()].variables[name] if self.regions else self.initial[name]

    # ---- the step ---------------------------------------------------------------------------

    def step(self, now: int, inputs: Iterable[Input]) -> Outcome:
        self.outcome = Outcome()
        if self.finished or self.failure is not None:
            self.outcome.finished = self.finished
            self.outcome.failure = self.failure
            return self.outcome
        self.now = now

        # "The first step enters the root (its START becomes active) and goes on with rounds."
        if not self.started:
            self.started = True
            self.regions[self.root()] = Region(self.root(), variables=dict(self.initial))
            self.enter(self.root())

        # "1. Inputs, in the order given"
        self.drop_expired()
        for item in inputs:
            self.take_in(item)
        # "`raise e`: the event comes alone in the next step, in order, before arrivals"
        if self.raised:
            self.events.add(self.raised.pop(0))
        self.drop_expired()
        self.look_at_deadlines()

        # "A step that does not settle within a bound" is an error "that names the cycle". Rounds that take
        # what waits are no cycle as long as it becomes less: it is looked at after each 1000 rounds. (Where
        # something can wait, the first thousand rounds tell nothing: less than before them may wait.)
        rounds = 0
        can_wait = any(region.reads for region in self.plan.regions) or self.mailbox
        waited = None if can_wait else 0
        while self.failure is None and (self.visit(self.root()) or self.fails_for_breach()):
            rounds += 1
            if rounds % ROUNDS == 0:
                waits = self.how_much_waits()
                if waited is not None and waits >= waited:
                    self.stop("the step does not settle: " + self.last_transitions())
                waited = waits

        # "3. At the end: variable writes of the step become visible everywhere (of two writers the region
        # later in document order wins);" "elsewhere from the next step, which follows at the same instant if
        # anything there reads it"
        self.outcome.again = self.spread_writes() or bool(self.raised)

        # "signals that were looked at in this step are dropped in the region where they were;" and "`again` =
        # some region still has a signal waiting behind one that was dropped."
        for region in self.regions.values():
            dropped = [message.channel for message in region.asked if region.drop(message)]
            if any(region.signals[channel] for channel in dropped):
                self.outcome.again = True
            # "The engine sleeps when nothing is enabled": a condition may hold because a signal is gone.
            if not self.missed_in(region.label).isdisjoint(dropped):
                self.outcome.again = True
            region.asked = []
            region.seen = {}

        # "if a failed state is still active the agent stops (its running activities are cancelled);"
        if self.failed and self.failure is None:
            label, reason = next(iter(self.failed.items()))
            self.stop(f"{self.plan.by_label[label].name} of state {label} failed: {reason}")

        # "an event raised is there … until the end of the step"; "a fault is recorded once per transition
        # and step"
        self.events = set()
        self.spent = set()
        self.faulty = set()

        # "With the root's END active the agent has finished."
        self.finished = self.failure is None and self.is_complete(self.root())
        if self.finished or self.failure is not None:
            self.raised = []
        self.outcome.finished = self.finished
        self.outcome.failure = self.failure
        return self.outcome

    def take_in(self, item: Input) -> None:
        match item:
            case Sample():
                # "an arrived message is put on the board of every active region that reads its channel (but
                # not the region that wrote it, which saw it at once)"
                for region in self.regions.values():
                    if not self.reads(region.label, item.channel):
                        continue
                    if item.identity in region.read_ahead:
                        region.read_ahead.remove(item.identity)
                    elif region.label != item.written_by:
                        region.put(item, self.queued(item.channel))
            case Completed(label, token, outcome):
                # "a completed activity makes its state complete if that state is active with the same token
                # (else dropped)"; one that waits never completes
                if label not in self.endless and self.runs(label) and self.token[label] == token:
                    self.complete.add(label)
                    if outcome is not None:
                        self.note_end(label, outcome)
            case Crashed(label, token, reason):
                # "a failed one marks it failed"
                if self.runs(label) and self.token[label] == token:
                    self.failed[label] = reason
            case Happened(name):
                # "an event raised is there for every region until the end of the step or until that region
                # spends it"
                self.events.add(name)
            case Written(name, value):
                # "a variable written by an activity is set"
                for region in self.regions.values():
                    region.variables[name] = value
            case AgentMessage():
                # "mail is put into the mailbox of the participation (protocol branch) it names"
                self.mailbox[item.branch].append(item)
                self.came[item.identity] = self.now
            case Addressed(branch, participant, agents, name):
                # "since the last send to `q` in this conversation: how many agents were addressed"
                if self.rounds.get((branch, participant), {}).get("name") != "":
                    self.begin_round(branch, participant)
                self.rounds[branch, participant] |= {"agents": agents, "name": name}
            case Settled(branch, participant, agent, reply):
                # "(a message … refused or unexpected) or are lost"
                if reply not in self.earlier.get((branch, participant), []):
                    self.rounds.get((branch, participant), {"settled": set()})["settled"].add(agent)

    def begin_round(self, branch: str, participant: str) -> None:
        """Nobody is addressed yet: whoever answers an earlier message does not answer this one."""
        before = self.rounds.get((branch, participant), {}).get("name", "")
        self.earlier.setdefault((branch, participant), []).extend([before] if before else [])
        self.rounds[branch, participant] = {"agents": (), "name": "", "taken": set(), "settled": set()}

    def round_of(self, question: str, participant: str) -> bool | int:
        """ "how many agents were addressed, how many have answered …, whether all have (false if none was
        addressed)"; "what waits counts when it is taken" """
        branch = self.branch_of(self.asking)
        found = self.rounds.get((branch, participant), {"agents": ()})
        wait = {m.sender for m in self.mailbox[branch] if m.message and m.participant == participant}
        counted = [
            name
            for name in found["agents"]
            if name in found["taken"] or (name in found["settled"] and name not in wait)
        ]
        if question == "all_answered":
            return len(counted) == len(found["agents"]) > 0
        return len(found["agents"] if question == "invited" else counted)

    def note_end(self, label: str, outcome: str | Absent) -> None:
        self.ended = {other: end for other, end in self.ended.items() if other != label} | {label: outcome}

    def look_at_deadlines(self) -> None:
        """ "Past its deadline an activity is cancelled and its state has failed." Inputs come first."""
        for state in self.plan.states:
            info = next((info for info in self.plan.activities if info.name == state.activity), None)
            if info is None or info.within is None or not self.runs(state.label):
                continue
            if self.now >= self.entered[state.label] + info.within:
                reason = f"not done within {info.within / 1e9:g} s"
                self.failed[state.label] = reason
                cancel = Cancel(state.label, info.name, self.token[state.label], reason)
                self.outcome.effects.append(cancel)

    def outcome_of(self, activity: str) -> str | Absent:
        """ "The innermost region or participant's branch around the transition that performs it counts; of
        several states there, the one that ended or was entered last." """
        around = [self.asking, *self.around(self.asking)]
        for holder in [label for label in around if self.is_region(label) or label in self.mailbox]:
            inside = [
                state.label
                for state in self.plan.states
                if state.activity == activity and holder in (state.label, *self.around(state.label))
            ]
            if inside:
                return next((end for label, end in reversed(self.ended.items()) if label in inside), ABSENT)
        return ABSENT

    def answer(self, question: str, name: str) -> bool | int:
        """ "`in(T)`, `done(T)`: two-valued, as of the moment of evaluation. `count(T)`: entries of T since
        its loop was entered." """
        meant = next(
            found
            for holder in [self.asking, *self.around(self.asking)]
            if (found := self.named(name, holder))
        )
        match question:
            case "in":
                return any(label in self.active for label in meant)
            case "done":
                return any(label in self.active and self.is_complete(label) for label in meant)
        return self.entries.get(meant[0], 0)

    def named(self, name: str, holder: str) -> list[str]:
        return [
            state.label
            for state in self.plan.states
            if name in (state.name, state.activity, without_arguments(state.name))
            and holder in (state.label, *self.around(state.label))
        ]

    @cached_property
    def counted_in(self) -> dict[str, list[str]]:
        """The states whose counts are set to 0 by the entry of another one."""
        found: dict[str, list[str]] = {}
        for state in self.plan.states:
            found.setdefault(self.loop_around(state.label), []).append(state.label)
        return found

    def loop_around(self, label: str) -> str:
        """ "The nearest state at or around T with a transition to itself; its parent's entry sets it to 0;
        without one, T's region's entry." """
        inside = [label, *self.around(label)]
        inside = inside[: inside.index(self.region_of(label)) + 1]
        return next((parent for state, parent in pairwise(inside) if state in self.repeated), inside[-1])

    @cached_property
    def repeated(self) -> set[str]:
        """The states with a transition to themselves."""
        ways = [way for way in self.plan.transitions if way.kind == "external"]
        return {way.source for way in ways if way.source == way.target}

    def count_entry(self, label: str) -> None:
        self.entries |= dict.fromkeys(self.counted_in.get(label, ()), 0)
        self.entries[label] = self.entries.get(label, 0) + 1

    def reads(self, region: str, channel: str) -> bool:
        return any(r.label == region and channel in r.reads for r in self.plan.regions)

    def drop_expired(self) -> None:
        """ "A signal that is not taken is gone once it is so old as its topic says with `expires`." """
        longest = {c.name: c.expires for c in self.plan.channels if c.expires is not None}
        for region in sorted(self.regions.values(), key=lambda region: label_key(region.label)):
            for channel, signals in sorted(region.signals.items()):
                for signal in signals if channel in longest else ():
                    if self.now - signal.time >= longest[channel]:
                        region.signals[channel] = [s for s in region.signals[channel] if s is not signal]
                        self.outcome.effects.append(SignalExpired(region.label, channel, signal.identity))

    def queued(self, channel: str) -> bool:
        return any(c.name == channel and c.queued for c in self.plan.channels)

    def runs(self, label: str) -> bool:
        """Whether the activity of a BASIC state runs."""
        return label in self.active and label not in self.complete and label not in self.failed

    def last_transitions(self) -> str:
        transitions = [self.plan.transitions[number] for way in self.outcome.taken[-8:] for number in way]
        return ", ".join(f"{transition.source} -> {transition.target}" for transition in transitions)

    def stop(self, reason: str) -> None:
        """The agent stops: "its running activities are cancelled"."""
        self.failure = reason
        self.leave(self.root())
        self.spread_writes()  # of what was done on leaving

    def spread_writes(self) -> bool:
        """Let every region see what was written; whether that is news to one that reads it."""
        before = {label: dict(region.variables) for label, region in self.regions.items()}
        for _, name, value in sorted(self.writes, key=lambda write: self.place(write[0])):
            for region in self.regions.values():
                region.variables[name] = value
        self.writes = []
        return any(
            before[label][name] != region.variables[name]
            for label, region in self.regions.items()
            for name in self.variables_read_in(label)
        )

    def variables_read_in(self, region: str) -> set[str]:
        """The variables that "a transition of an active state" of a region reads: in its condition."""
        conditions = self.conditions_in(region)
        return {part[1] for condition in conditions for part in parts(condition) if part[0] == "variable"}

    def missed_in(self, region: str) -> set[str]:
        """The signals of which an active state's condition may hold because they are not there.

        "`&&`, `||`, `!` follow Kleene's three-valued logic, comparisons and functions of an absent value are
        absent": so none, but for those with a part that "is always two-valued" or that may raise.
        """
        return {
            channel
            for condition in self.conditions_in(region)
            if any(part[0] in ("has", "holds", "call", "*", "/", "%") for part in parts(condition))
            for channel, _ in signals_of(condition)
        }

    def conditions_in(self, region: str) -> list[Term | None]:
        """The conditions of all transitions of a region's active states, with those of their branches."""
        sources = [label for label in self.active if self.region_of(label) == region]
        found: list[Term | None] = []
        while sources:
            for _, transition in self.plan.outgoing(sources.pop()):
                asked = transition.condition
                # Whether a weighted branch is open counts in the draws before it: true or not.
                found.append(("holds", asked) if transition.weight is not None and asked else asked)
                if self.type_of(transition.target) == "CONDITION":
                    sources.append(transition.target)
        return found

    def how_much_waits(self) -> int:
        """How many signals wait in the regions, and agent messages in the conversations."""
        signals = [waiting for region in self.regions.values() for waiting in region.signals.values()]
        return sum(len(waiting) for waiting in [*signals, *self.mailbox.values()])

    # ---- rounds -----------------------------------------------------------------------------

    def visit(self, region: str) -> bool:
        """ "visit(R): let L be R's active leaf." Whether R has moved."""
        leaf = self.leaf(region)
        inside = self.around(leaf)
        path = [leaf, *inside[: inside.index(region) + (region != self.root())]] if leaf != region else []
        # "What cuts short is tried before anything inside what it cuts, the outermost first."
        for source in reversed(path):
            way = self.enabled_way(source, first=True)
            if way is not None:
                self.take(region, way)
                return True
        # "If L is an AND: visit each of its regions in document order (all of them); if any moved, R has
        # moved."
        if self.type_of(leaf) == "AND":
            moved = []
            boards = [self.regions[inner] for inner in self.children(leaf)]
            for inner in self.children(leaf):
                moved.append(self.visit(inner))
                # "One that leads out of the AND leaves all its regions": those behind it take nothing, nor
                # do those that it has entered anew.
                if any(self.regions.get(board.label) is not board for board in boards):
                    break
            if any(moved):
                return True
        # "Otherwise the sources L, then the OR states around it inside R, innermost first, then R itself
        # (whose transitions lead out of its AND);"
        for source in path:
            # "of each the outgoing transitions by priority; the first that is enabled is taken, and R has
            # moved."
            way = self.enabled_way(source)
            if way is not None:
                self.take(region, way)
                return True
        return False

    def enabled_way(self, source: str, first: bool = False) -> list[int] | None:
        """The first enabled transition of an active source; with its branches it may be a compound one."""
        return self.first_open(source, source, self.is_complete(source), first)

    def first_open(self, node: str, source: str, complete: bool, first: bool = False) -> list[int] | None:
        """The first of the transitions of `node` that is enabled, while `source` waits.

        Those that cut their source short are only looked at, and alone, when `first` says so.
        """
        for number, transition in self.plan.outgoing(node):
            if transition.first is not first:
                continue
            if transition.kind == "on":
                if self.is_on(number, transition, source, complete):
                    return [number]
                continue
            # "`else`: source complete and no other outgoing transition (or branch) of the same source
            # enabled". `else` is tried last, so that here no other one is.
            if not self.is_enabled(number, transition, source, complete):
                continue
            if self.type_of(transition.target) != "CONDITION":
                return [number]
            # "If the target is a CONDITION, one of its outgoing branches must be enabled too (recursively),
            # tried by priority: a branch's events/when/condition count the same way, but "complete" is what
            # the first segment needed"
            rest = self.first_open(transition.target, source, True)
            if rest is not None:
                return [number, *rest]
        return None

    def is_enabled(self, number: int, transition: Transition, source: str, complete: bool) -> bool:
        if transition.when:
            # "`when`: always"
            pass
        elif transition.events:
            # "with events: one of them is there"
            if not any(self.is_there(event, source) for event in transition.events):
                return False
        elif not complete:
            # "nothing: source complete"
            return False
        # "not before 200 ms since T was entered"
        if transition.every is not None and self.now < self.entered[source] + transition.every:
            return False
        # "The oldest waiting message of that kind *for which the condition holds* is taken."
        if speaks_of_mail(transition):
            self.found[number] = self.letter(number, transition, source)
            return self.found[number] is not None
        if transition.weight is not None:
            return self.is_drawn(number, transition)
        # "And the condition, if any, holds."
        return transition.condition is None or self.condition_holds(number, transition)

    def letter(self, number: int, transition: Transition, source: str) -> AgentMessage | None:
        """What a transition takes that speaks of it: of the events in their order, the oldest first."""
        for event in transition.events:
            for mail in self.waiting(event, source):
                self.in_hand = mail
                if transition.condition is None or self.condition_holds(number, transition):
                    return mail
        return None

    def is_on(self, number: int, transition: Transition, source: str, complete: bool) -> bool:
        """Whether an `on` transition is to be taken.

        "Without an event it is taken when its condition holds, and again each time it holds and has not held
        in between, or something it reads has been written or has arrived since."
        """
        if not transition.when and not transition.events and not complete:
            return False
        there = any(self.is_there(event, source, number) for event in transition.events)
        if speaks_of_mail(transition):
            self.found[number] = self.letter(number, transition, source)
            return self.found[number] is not None
        if not transition.when and transition.events:
            return there and (transition.condition is None or self.condition_holds(number, transition))
        if transition.condition is not None and not self.condition_holds(number, transition):
            self.noticed.pop(number, None)
            return False
        if there or number not in self.noticed:
            return True
        # "A signal that is there always counts."
        region = self.regions[self.region_of(source)]
        if any(region.sees(channel, host) is not None for channel, host in signals_of(transition.condition)):
            return True
        before, now = self.noticed[number], self.what_is_read(transition)
        return any(not is_same(one, other) for one, other in zip(before, now, strict=True))

    def what_is_read(self, transition: Transition) -> list[Any]:
        """The messages, variables and timers that the condition of an `on` transition reads."""
        region = self.regions[self.region_of(transition.source)]
        found: list[Any] = []
        for term in parts(transition.condition):
            match term:
                case ("member", host, channel, _) if channel.split(".")[1] != "signal":
                    message = region.sees(channel, host)
                    found.append(None if message is None else message.message)
                case ("variable", name, *_):
                    found.append((region.variables[name],))
                case ("expired", timer):
                    found.append((region.timers.get(timer),))
                case ("outcome", activity):
                    self.asking = transition.source
                    found.append((self.outcome_of(activity),))
                case ("in" | "done" | "count" as question, name) if len(term) == 2:
                    self.asking = transition.source
                    found.append((self.answer(question, name),))
                case ("invited" | "answered" | "all_answered" as question, participant):
                    self.asking = transition.source
                    found.append((self.round_of(question, participant),))
        return found

    def is_complete(self, label: str) -> bool:
        """ "Complete: BASIC when its activity completed; OR when its END is active; AND when every region's
        END is active; START always." """
        match self.type_of(label):
            case "BASIC":
                return label in self.complete
            case "OR":
                return any(c in self.active for c in self.children(label) if self.type_of(c) == "END")
            case "AND":
                return all(self.is_complete(region) for region in self.children(label))
            case "START":
                return True
        return False

    def is_there(self, event: Term, source: str, on: int | None = None) -> bool:
        """Whether an event is there for a transition of `source`; `on` is its number if it stays there."""
        match event:
            case ("after", duration) if on is not None and duration <= self.waited.get(on, -1):
                # "`after` once an entry"
                return False
            case ("after", duration):
                # "once `d` has passed since the source was entered"; "`after` on a branch counts from the
                # entry of the waiting source"
                return bool(self.now - self.entered[source] >= duration)
            case ("received" | "lost", *_):
                return bool(self.waiting(event, source))
            case ("raised", name):
                return name in self.events and (self.region_of(source), name) not in self.spent
            case ("error",):
                # "`error` (an activity inside failed; it bubbles outwards)"
                return any(source in (label, *self.around(label)) for label in self.failed)
        raise ValueError(event)

    def waiting(self, event: Term, source: str) -> list[AgentMessage]:
        """The agent messages that an event means, the oldest first; that somebody is lost is one, too."""
        match event:
            case ("received", *kind):
                wanted = tuple(kind)
            case ("lost", participant):
                wanted = ("lost", "", participant)
        box = self.mailbox[self.branch_of(source)]
        return [mail for mail in box if (mail.performative, mail.message, mail.participant) == wanted]

    # ---- taking a transition ----------------------------------------------------------------

    def take(self, region: str, way: list[int]) -> None:
        self.outcome.taken.append(tuple(way))
        transitions = [self.plan.transitions[number] for number in way]
        source, target = transitions[0].source, transitions[-1].target
        board = self.regions[region]
        if transitions[0].kind == "on":
            self.take_on(way[0], board)
            return

        # "the first listed that is there is the one spent"; "An event is spent by what takes it."
        letters = {
            number: self.found[number]
            for number, transition in zip(way, transitions, strict=True)
            if speaks_of_mail(transition)
        }
        plain = [transition for transition in transitions if not speaks_of_mail(transition)]
        there = [[e for e in transition.events if self.is_there(e, source)] for transition in plain]
        for event in dict.fromkeys(events[0] for events in there if events):
            self.spend(event, source)
        for mail in letters.values():
            assert mail is not None
            self.take_mail(mail)

        # "Everything active inside the scope is left, innermost first;"
        scope = min((self.scope(t.source, t.target) for t in transitions), key=self.place)
        # "A transition that leads out of its region reads the blackboard of that region, and acts in the
        # region of its scope."
        there_is = self.regions[self.region_of(scope)]
        # "A part that any `resume` line can continue is *suspended* instead … discarded … when … the region
        # that remembers it is left."
        self.held = {
            branch
            for state in self.resumable()
            if state in self.active and scope in self.around(state) and not self.is_complete(state)
            if self.region_of(state) in (scope, *self.around(scope))
            for branch in self.branches_in(state)
        }
        for child in self.children(scope):
            if child in self.active:
                self.leave(child)
        self.held = set()

        # "then the actions run;" "actions of segment 1, then 2"
        for number in way:
            self.in_hand = letters.get(number)
            for action in self.plan.transitions[number].actions:
                self.act(number, action, board, there_is)

        # "the signals its segments' conditions and actions name are consumed (the one that was seen), after
        # its actions."
        for transition in transitions:
            for channel, host in signals_of(transition.condition, *transition.actions):
                message = board.seen.get((channel, host))
                if message is not None:
                    self.consume(message, board)

        # "then the target is entered, outermost first."
        path = [target, *self.around(target)]
        path = list(reversed(path[: path.index(scope)]))
        # "Entering by resume: the states around the remembered leaves are entered outermost first … Then the
        # memory is spent."
        again = self.kept.pop(target, None) if transitions[-1].resume else None
        # "Where a region of it has a target of its own (`A -> (B, C)`), the region goes there instead of its
        # START."
        into = transitions[-1].into
        towards = frozenset(state for label in into for state in [label, *self.around(label)])
        self.enter(path[0], path[1:], again, target if transitions[-1].resume else "", towards)

    def take_on(self, number: int, board: Region) -> None:
        """ "Nothing is left or entered." """
        transition = self.plan.transitions[number]
        there = [event for event in transition.events if self.is_there(event, transition.source, number)]
        self.in_hand = self.found[number] if speaks_of_mail(transition) else None
        if self.in_hand is not None:
            self.take_mail(self.in_hand)
            there = []
        for event in there[:1]:
            if event[0] == "after":
                self.waited[number] = event[1]
            else:
                self.spend(event, transition.source)
        self.do(number, board)
        # "What its own actions write does not count."
        self.noticed[number] = self.what_is_read(transition)

    def do(self, number: int, board: Region) -> None:
        """The actions of a transition that stays; the signals that it names are consumed after them."""
        transition = self.plan.transitions[number]
        for action in transition.actions:
            self.act(number, action, board)
        for channel, host in signals_of(transition.condition, *transition.actions):
            message = board.seen.get((channel, host))
            if message is not None:
                self.consume(message, board)

    def spend(self, event: Term, source: str) -> None:
        match event:
            case ("received" | "lost", *_):
                self.take_mail(self.waiting(event, source)[0])
            case ("raised", name):
                # "a … raised event … is consumed at once, for its region and for every region around it"
                self.spent |= {(region, name) for region in self.regions_around(source)}

    def regions_around(self, label: str) -> list[str]:
        """The region in which a state is, and those around it."""
        return [state for state in [label, *self.around(label)] if self.is_region(state)]

    def consume(self, message: Sample, board: Region) -> None:
        """ "A signal … is consumed at once, for its region and for every region around it." """
        for label in self.regions_around(board.label):
            around = self.regions.get(label)
            if around is None:  # it has been left
                continue
            ahead = message.identity in board.read_ahead and self.reads(label, message.channel)
            if not around.drop(message) and ahead:
                # … also where it would come only as an input of the next step
                around.read_ahead.add(message.identity)

    def way(self) -> tuple[int, ...]:
        """The compound transition that is being taken; what an `exit` does belongs to it."""
        if self.abandoning:
            return self.abandoning
        ways = [
            way for way in self.outcome.taken if self.plan.transitions[way[0]].kind not in ("exit", "abandon")
        ]
        return ways[-1] if ways else ()

    def forget_rounds(self, branch: str) -> None:
        for kept in (self.rounds, self.earlier):
            for key in [key for key in kept if key[0] == branch]:
                del kept[key]  # type: ignore[attr-defined]

    def take_mail(self, mail: AgentMessage) -> None:
        """ "An agent message waits … until exactly one transition or activity takes it" """
        box = self.mailbox[mail.branch]
        if any(other is mail for other in box):
            self.mailbox[mail.branch] = [other for other in box if other is not mail]
            key = (mail.branch, mail.participant)
            if key in self.rounds and mail.message and mail.in_reply_to not in self.earlier.get(key, []):
                self.rounds[key]["taken"].add(mail.sender)
            self.outcome.effects.append(MailTaken(mail.branch, mail.identity))

    def leave(self, label: str) -> None:
        """ "an AND: its regions in document order, inner leaves first" """
        if any(transition.resume and transition.target == label for transition in self.plan.transitions):
            # "written when T is left while not complete …; cleared when T is left complete"
            self.kept.pop(label, None)
            if not self.is_complete(label):
                inside = {state for state in self.active if label in self.around(state)}
                self.kept[label] = (inside, inside & self.complete)
        completed = self.is_complete(label)
        still = self.timers_of_part(label) if label in self.mailbox else {}
        for child in self.children(label):
            if child in self.active:
                self.leave(child)
        self.active.remove(label)
        state = self.plan.by_label[label]
        if state.type == "BASIC":
            # "a BASIC whose activity still runs gives Cancel"
            if label not in self.complete and label not in self.failed:
                assert state.activity is not None
                self.outcome.effects.append(Cancel(label, state.activity, self.token[label]))
            self.complete.discard(label)
            self.failed.pop(label, None)
        # "`exit`: innermost first, after the Cancel of the activity, before the transition's own actions"
        for number, transition in enumerate(self.plan.transitions):
            if transition.kind == "exit" and transition.source == label:
                self.outcome.taken.append((number,))
                self.do(number, self.regions[self.region_of(label)])
        if label in self.mailbox:
            # What an `exit` has started counts, too: "the part's own `after` and timers stand still".
            still = {r: self.left_with.get(r, {}) for r in still} | self.timers_of_part(label)
            self.end_timers(label, self.regions[self.region_of(label)])
            if label in self.held and not completed:
                self.suspended[label] = (self.now, still, self.regions[self.region_of(label)])
                self.outcome.effects.append(Suspended(label))
            else:
                self.part(label, completed)
        if label in self.regions:
            for state in self.resumable():
                if self.region_of(state) == label:
                    self.discard(state)
        if label in self.regions and label != self.root():
            # "leaving the region drops its timers", and its blackboard "is dropped when the AND is left"
            self.left_with[label] = self.regions.pop(label).timers

    def part(self, branch: str, completed: bool = False, region: Region | None = None) -> None:
        """ "entering/leaving a participation gives Joined/Left"; what waits in it is given up"""
        if not completed:
            # "A participant may say what it sends in that case: `on abandon`; then that is sent first."
            for number, transition in enumerate(self.plan.transitions):
                if transition.kind == "abandon" and transition.source == branch:
                    self.outcome.taken.append((number,))
                    self.abandoning = (number,)
                    self.do(number, region or self.regions[self.region_of(branch)])
                    self.abandoning = ()
            self.end_timers(branch, region or self.regions[self.region_of(branch)])
        self.mailbox[branch].clear()
        self.forget_rounds(branch)
        self.outcome.effects.append(Left(branch, completed))

    def resumable(self) -> list[str]:
        """The composites that some transition resumes, in document order."""
        targets = {transition.target for transition in self.plan.transitions if transition.resume}
        return [s.label for s in self.plan.states if s.label in targets and s.type == "OR"]

    def branches_in(self, label: str) -> set[str]:
        return {branch for branch in self.mailbox if label in (branch, *self.around(branch))}

    def discard(self, label: str, but: str = "") -> None:
        """ "The part is discarded, which is leaving, when `enter` is taken instead" """
        for branch in list(self.suspended):
            if branch in self.branches_in(label) - self.held - (self.branches_in(but) if but else set()):
                self.part(branch, region=self.suspended.pop(branch)[2])

    def end_timers(self, branch: str, region: Region) -> None:
        """ "A timer that a part starts ends with the part", also one that it starts in its farewell."""
        for name in self.timers_started_in(branch):
            region.timers.pop(name, None)

    def timers_started_in(self, label: str) -> set[str]:
        ways = [way for way in self.plan.transitions if label in self.around(way.source)]
        return {action[1] for way in ways for action in way.actions if action[0] == "start_timer"}

    def timers_of_part(self, branch: str) -> dict[str, dict[str, int]]:
        """The timers of a part, by the region that has them."""
        own = self.region_of(branch)
        names = self.timers_started_in(branch)
        found = {r.label: dict(r.timers) for r in self.regions.values() if branch in self.around(r.label)}
        found[own] = {n: due for n, due in self.regions[own].timers.items() if n in names}
        return found

    def go_on(self, label: str, again: tuple[set[str], set[str]]) -> None:
        """ "Its activities are cancelled, the part's own `after` and timers stand still; on resumption they
        go on" """
        moment, timers, _ = self.suspended.pop(label)
        passed = self.now - moment
        for state in self.entered:
            if label in (state, *self.around(state)):
                self.entered[state] += passed
        shifted = {r: {n: due + passed for n, due in kept.items()} for r, kept in timers.items()}
        self.regions[self.region_of(label)].timers |= shifted.pop(self.region_of(label))
        self.outcome.effects.append(Resumed(label))
        self.be_in(label, again, shifted)

    def be_in(self, label: str, again: tuple[set[str], set[str]], timers: dict[str, dict[str, int]]) -> None:
        """Be in a state of a part that goes on, as it was left; nothing that belongs to an entry is done."""
        self.active.add(label)
        if label in self.suspended:  # a part inside: its time stood still with that of the part around it
            moment, kept, _ = self.suspended.pop(label)
            own = self.region_of(label)
            due_then = {n: due + self.now - moment for n, due in kept.get(own, {}).items()}
            self.regions[own].timers |= due_then
            self.outcome.effects.append(Resumed(label))
        match self.type_of(label):
            case "BASIC" if label in again[1]:
                self.complete.add(label)
            case "BASIC":
                self.start(label)
            case "OR":
                for child in [child for child in self.children(label) if child in again[0]]:
                    self.be_in(child, again, timers)
            case "AND":
                for inner in self.children(label):
                    self.begin_region(inner, self.regions[self.region_of(label)])
                    self.regions[inner].timers |= timers.get(inner, {})
                    self.be_in(inner, again, timers)

    def enter(
        self,
        label: str,
        path: list[str] | None = None,
        again: tuple[set[str], set[str]] | None = None,
        resumed: str = "",
        towards: frozenset[str] = frozenset(),
    ) -> None:
        """Enter a state, and inside it the next one of the path instead of its START.

        Behind the path, a state that is `towards` several targets is entered instead of a START.
        At the end of the path, at `resumed`, `again` says what was active, and what of that complete, when it
        was left.
        """
        state = self.plan.by_label[label]
        goes_on = again is not None and path is None
        if label in self.resumable() and not goes_on and label != resumed:
            self.discard(label, resumed)
        if label in self.mailbox:
            # A part that was not suspended "is entered anew".
            if not path and label in self.suspended and again is not None:
                self.go_on(label, again)
                return
            if not path:
                again = None
            for kept in [other for other in self.kept if label in self.around(other)]:
                del self.kept[kept]
        self.active.add(label)
        self.entered[label] = self.now
        # What an `on` transition has seen is "forgotten when its state is entered".
        for number, transition in enumerate(self.plan.transitions):
            if transition.source == label:
                self.noticed.pop(number, None)
                self.waited.pop(number, None)
        self.count_entry(label)

        # "Entering a node that is the scope of variables (a protocol branch) sets them to their initial
        # values": they start anew, whatever was written to them in this step.
        for variable in self.plan.variables:
            if variable.scope == label:
                self.writes = [write for write in self.writes if write[1] != variable.name]
                for region in self.regions.values():
                    region.variables[variable.name] = variable.initial
        if label in self.mailbox:
            self.forget_rounds(label)
            self.outcome.effects.append(Joined(label))

        match state.type:
            case "BASIC" if again is not None and label in again[1]:
                # "one that was complete is complete"
                self.complete.add(label)
            case "BASIC":
                self.start(label)
            case "OR":
                # "OR: its START becomes active"
                was = [child for child in self.children(label) if again is not None and child in again[0]]
                led = [child for child in self.children(label) if child in towards]
                if path:
                    self.enter(path[0], path[1:], again, resumed, towards)
                elif led:
                    self.enter(led[0], towards=towards)
                elif was:
                    self.enter(was[0], None, again)
                else:
                    start = [child for child in self.children(label) if self.type_of(child) == "START"]
                    self.enter(start[0])
            case "AND":
                # "AND: each region in document order gets its board (a copy of the surrounding board's states
                # and histories, no signals, no timers) and its START becomes active"
                surrounding = self.regions[self.region_of(label)]
                for inner in self.children(label):
                    self.begin_region(inner, surrounding)
                    if path and path[0] == inner:
                        self.enter(inner, path[1:], again, resumed, towards)
                    else:
                        self.enter(inner, None, None if path else again, towards=towards)

    def begin_region(self, inner: str, surrounding: Region) -> None:
        """The blackboard of a region that is entered."""
        self.regions[inner] = Region(
            inner,
            states={channel: list(found) for channel, found in surrounding.states.items()},
            data={channel: list(found) for channel, found in surrounding.data.items()},
            # "they start with a copy"
            variables=dict(surrounding.variables),
        )
        # "regions that are entered during the step do not see it"
        self.spent |= {(inner, name) for name in self.events}

    def start(self, label: str) -> None:
        """ "BASIC gives Start with a new token (a counter of the chart, from 1)" """
        activity = self.plan.by_label[label].activity
        assert activity is not None
        # "absent from the entry of such a state until it ends with an outcome"
        self.note_end(label, ABSENT)
        given = self.given(label)
        if given is None:
            return
        # "The state that is entered fails: the first activity that would start there does not."
        if self.breach is not None and self.breach[0] in (label, *self.around(label)):
            self.failed[label] = self.breach[1]
            self.breach = None
            return
        self.tokens += 1
        self.token[label] = self.tokens
        self.outcome.effects.append(Start(label, activity, self.tokens, given))

    def given(self, label: str) -> tuple[tuple[str, Any], ...] | None:
        """ "What an activity is given is computed on entry. Absent or raising, the state fails at once." """
        self.asking = label
        region = self.regions[self.region_of(label)]
        found = []
        for name, term in self.plan.by_label[label].arguments:
            try:
                value = self.value(term, region)
            except Exception as error:
                self.failed[label] = f"{name}: {error}"
                return None
            if value is ABSENT:
                self.failed[label] = f"the argument `{name}` is absent"
                return None
            found.append((name, value))
        return tuple(found)

    def fails_for_breach(self) -> bool:
        """ "Where none starts, the first that runs there is cancelled. Without one, the agent stops." """
        if self.breach is None:
            return False
        (target, reason), self.breach = self.breach, None
        inside = [s.label for s in self.plan.states if target in (s.label, *self.around(s.label))]
        running = [label for label in inside if self.type_of(label) == "BASIC" and self.runs(label)]
        if not running:
            self.stop(reason)
            return False
        self.failed[running[0]] = reason
        activity = self.plan.by_label[running[0]].activity
        assert activity is not None
        self.outcome.effects.append(Cancel(running[0], activity, self.token[running[0]], reason))
        return True

    # ---- actions ----------------------------------------------------------------------------

    def act(self, number: int, action: Term, region: Region, place: Region | None = None) -> None:
        """Do an action with what `region` knows; what it changes it changes in `place`."""
        place = place or region
        self.asking = self.plan.transitions[number].source
        # "… or an action reads one, that channel is asked in that region."
        for channel, host in signals_of(action):
            region.look_at(channel, host)
        # "In an action, an absent or raising value means that this one action is not done, with a fault."
        # "If a value of a `send` is absent or raises, the message is not sent, and the state … fails."
        # "An action … that is not done because something is absent draws nothing": what it reads is looked up
        # first, as written, and only if all of it is there anything is computed.
        try:
            reads = []
            for term in values_of(action):
                reads.append(self.look_up(term, region))
                if reads[-1] is ABSENT:
                    self.not_done(number, action, "a value is absent")
                    return
            values = [self.compute(read) for read in reads]
        except NoElement as error:
            count, wanted = error.args
            own = action[1].partition("@")[0]
            self.breach_by(number, f"list {own} of {count} elements has no element {wanted}")
            return
        except Exception as error:
            self.not_done(number, action, str(error))
            return
        match action:
            case ("assign", name, _):
                # "A write to a variable is seen at once in its own region, and by regions entered later in
                # the same step inside it (they start with a copy); elsewhere from the next step."
                bounds = next(v.bounds for v in self.plan.variables if v.name == name)
                length = next(v.length for v in self.plan.variables if v.name == name)
                own = name.partition("@")[0]
                reason = ""
                if bounds is not None and not bounds[0] <= values[0] <= bounds[1]:
                    reason = f"variable {own} of {bounds[0]}..{bounds[1]} cannot be {values[0]!r}"
                if length is not None and len(values[0]) > length:
                    reason = f"list {own} of at most {length} elements cannot have {len(values[0])}"
                if reason:
                    self.breach_by(number, reason)
                    return
                region.variables[name] = place.variables[name] = values[0]
                self.writes.append((place.label, name, values[0]))
            case ("fill", ("member", host, channel, path), _):
                # "Drafts belong to the region: `t.c.M.f = v` fills one", `t.c.M = m` makes one of m
                draft = region.drafts.setdefault((channel, host), {})
                if not path:
                    draft.clear()
                draft[path] = values[0]
            case ("raise", name):
                self.raised.append(name)
            case ("publish", channel):
                self.publish(channel, region, place)
            case ("read_messages",):
                # "`read_messages` renews the executing region's snapshot"
                for message in self.pending():
                    if (
                        self.reads(place.label, message.channel)
                        and message.written_by != place.label
                        and message.identity not in place.read_ahead
                    ):
                        place.read_ahead.add(message.identity)
                        place.put(message, self.queued(message.channel))
            case ("start_timer", name, _):
                place.timers[name] = self.now + values[0]
            case ("send", performative, message, participant):
                branch = self.branch_of(self.plan.transitions[number].source)
                content = self.messages[message]()
                self.begin_round(branch, participant)
                sending = Sending(branch, performative, message, content, participant, way=self.way())
                self.outcome.effects.append(sending)
            case ("send", performative, message, participant, fills, to, _, *more):
                rest, reply_by, one = more or (None, None, False)
                branch = self.branch_of(self.plan.transitions[number].source)
                content = self.messages[message]()
                filled = [(path, values.pop(0)) for path, _ in fills or ()]
                if rest is not None:
                    # "or `..m` to take them from a received message `m`"
                    given = values.pop(0)
                    for name in rest[1]:
                        content = with_member(content, (name,), getattr(given, name))
                for path, value in filled:
                    content = with_member(content, path, value)
                within = None if reply_by is None else values.pop(0)
                receiver = None if to is None else values.pop(0)
                if to is None:
                    self.begin_round(branch, participant)
                self.outcome.effects.append(
                    Sending(
                        branch,
                        performative,
                        message,
                        content,
                        participant,
                        filled=fills is not None,
                        to=receiver,
                        excepts=tuple(values),
                        reply_by=None if within is None else self.now + within,
                        one=one,
                        way=self.way(),
                    )
                )
            case ("evaluate", _):
                pass

    def publish(self, channel: str, region: Region, place: Region) -> None:
        """ "`write_messages.t.c.M` publishes the region's drafts of the channel (one for all, one a host) in
        the order they were begun, or a message of defaults if there is none, and the region itself sees it at
        once if it reads the channel." """
        kind = self.messages[next(info.message for info in self.plan.channels if info.name == channel)]
        drafts = [(host, members) for (other, host), members in region.drafts.items() if other == channel]
        for host, _ in drafts:
            del region.drafts[channel, host]
        for host, members in drafts or [(None, {})]:
            message = kind()
            for path, value in members.items():
                message = with_member(message, path, value)
            self.outcome.effects.append(Publication(channel, message, host, place.label))
            # "with a `host.` it goes to that host alone"
            if self.reads(place.label, channel) and host in (None, self.agent):
                own = Sample(channel, message, self.agent, self.now, (self.agent, 0), place.label)
                place.put(own, self.queued(channel))

    def not_done(self, number: int, action: Term, reason: str) -> None:
        """An action lacks a value: a fault, and of a `send` that is no farewell a failure."""
        if action[0] != "send":
            self.fault(number, reason)
        elif self.abandoning:
            self.fault(number, f"{action[1]} {action[2]} is not sent: {reason}")
        else:
            self.breach_by(number, f"{action[1]} {action[2]} is not sent: {reason}")

    def breach_by(self, number: int, reason: str) -> None:
        """ "A write outside of the bounds is not made"; the state that is entered fails."""
        self.fault(number, reason)
        if self.breach is None and self.failure is None:
            way = self.way()
            target = self.plan.transitions[way[-1]].target if way else self.root()
            self.breach = target, f"{reason} ({self.plan.transitions[number].at})"

    def fault(self, number: int, reason: str) -> None:
        """ "a fault is recorded once per transition and step" """
        if number not in self.faulty:
            self.faulty.add(number)
            self.outcome.effects.append(Fault(number, reason))

    # ---- conditions and values --------------------------------------------------------------

    def condition_holds(self, number: int, transition: Transition) -> bool:
        region = self.regions[self.region_of(transition.source)]
        self.asking = transition.source
        assert transition.condition is not None
        # "whenever a condition that names a signal channel is evaluated (whatever was short-circuited) …
        # that channel is "asked" in that region"
        for channel, host in signals_of(transition.condition):
            region.look_at(channel, host)
        # "A function (or division) that raises makes the whole condition not hold"
        try:
            return self.holds(transition.condition, region)
        except Exception as error:
            self.fault(number, str(error))
            return False

    def is_drawn(self, number: int, transition: Transition) -> bool:
        """ "A branch with a weight is taken if its condition, if any, holds and it is drawn." """
        region = self.regions[self.region_of(transition.source)]
        self.asking = transition.source
        assert transition.weight is not None
        behind = [
            other
            for _, other in self.plan.outgoing(transition.source)
            if other.weight is not None and other.priority > transition.priority
        ]
        for channel, host in signals_of(transition.condition, *(other.condition for other in behind)):
            region.look_at(channel, host)
        try:
            if transition.condition is not None and not self.holds(transition.condition, region):
                return False
            # "For each open one a number is drawn …; then it is asked which of the weighted branches behind
            # it are open."
            number_drawn = self.compute(("random",))
            total = transition.weight
            for other in behind:
                if other.condition is None or self.holds(other.condition, region):
                    assert other.weight is not None
                    total += other.weight
            # "It is drawn if the number, times the sum of its weight and theirs, is below its weight"
            return bool(number_drawn * total < transition.weight)
        except Exception as error:
            self.fault(number, str(error))
            return False

    def holds(self, term: Term, region: Region) -> bool:
        match term:
            case ("&&", *operands):
                # "holds(a && b) = holds(a) then holds(b)"
                return all(self.holds(operand, region) for operand in operands)
            case ("||", *operands):
                # "holds(a || b) = holds(a) or else holds(b)"
                return any(self.holds(operand, region) for operand in operands)
            case ("!", operand):
                # "holds(!a) = fails(a)"
                return self.fails(operand, region)
        # "anything else: its value is True"
        return self.value(term, region) is True

    def fails(self, term: Term, region: Region) -> bool:
        match term:
            case ("&&", *operands):
                # "fails(a && b) = fails(a) or else fails(b)"
                return any(self.fails(operand, region) for operand in operands)
            case ("||", *operands):
                # "fails(a || b) = fails(a) then fails(b)"
                return all(self.fails(operand, region) for operand in operands)
            case ("!", operand):
                # "fails(!a) = holds(a)"
                return self.holds(operand, region)
        # "anything else: its value … is False"
        return self.value(term, region) is False

    def value(self, term: Term, region: Region) -> Any:
        """The value of a term, or ABSENT.

        "An absent operand makes a comparison, arithmetic, call, member absent": what a term reads is looked
        up first, and only if all of it is there the term is computed.
        """
        read = self.look_up(term, region)
        return ABSENT if read is ABSENT else self.compute(read)

    def look_up(self, term: Term, region: Region) -> Any:
        """The term with what it reads put in, from the left; ABSENT if something of that is absent."""
        match term:
            case ("const", _):
                return term
            case ("enum", enum, constant, _):
                return ("const", self.messages[enum][constant])
            case ("variable", name):
                # A variable of type agent, or of a message, "is absent until set".
                value = region.variables[name]
                return ABSENT if value is None else ("const", value)
            case ("variable", name, path):
                value = region.variables[name]
                found = ABSENT if value is None else member(value, path)
            case ("has", ("variable", name, path)):
                value = region.variables[name]
                return ("const", value is not None and member(value, path) is not ABSENT)
            case ("has", ("taken", path)):
                assert self.in_hand is not None
                return ("const", member(self.in_hand.content, path) is not ABSENT)
            case ("has", ("variable", name)):
                return ("const", region.variables[name] is not None)
            case ("taken", path):
                assert self.in_hand is not None
                found = member(self.in_hand.content, path)
            case ("reason",):
                assert self.in_hand is not None
                return ("const", self.in_hand.content)
            case ("sender",):
                assert self.in_hand is not None
                return ("const", self.in_hand.sender)
            case ("expired", timer):
                # "`expired(t)` is false before `start_timer`, true from the due time until it is started
                # again"
                return ("const", timer in region.timers and self.now >= region.timers[timer])
            case ("?", condition, yes, no):
                # "`c ? a : b` is absent if c is, else what it chooses; the other one is not looked at"
                test = self.value(condition, region)
                return ABSENT if test is ABSENT else self.look_up(yes if test else no, region)
            case ("outcome", activity):
                found = self.outcome_of(activity)
            case ("index",):
                # "the agent's number in its range, 1 if it is in none"
                found = next((n for name, n in self.plan.numbers if name == self.agent), 1)
            case ("random",):
                return term
            case ("in" | "done" | "count" as question, name):
                return ("const", self.answer(question, name))
            case ("invited" | "answered" | "all_answered" as question, participant):
                return ("const", self.round_of(question, participant))
            case ("has", ("member", host, channel, path)):
                # "`has(x)` is never absent."
                return ("const", self.read_member(host, channel, path, region) is not ABSENT)
            case ("member", host, channel, path):
                found = self.read_member(host, channel, path, region)
            case ("age", ("taken", _)):
                # "of an agent message: now - when it was sent", or came where that is not known
                assert self.in_hand is not None
                found = self.now - self.sent(self.in_hand)
            case ("age", ("member", host, channel, _)):
                # "`age(x)` = now - time of measurement."
                message = region.sees(channel, host)
                found = ABSENT if message is None else self.now - message.time
            case ("at", ("member", host, channel, path), offset):
                # "`at(x, -d)` = newest value whose time ≤ now - d, else absent."
                found = self.value(offset, region)
                if found is not ABSENT:
                    history = of_sender(region.data.get(channel, []), host)
                    message = newest([m for m in history if m.time <= self.now + found])
                    found = ABSENT if message is None else member(message.message, path)
            case ("mean", ("member", host, channel, path), window):
                # "`mean(x.m, w)` = mean over values with time ≥ now - w, absent if none."
                found = self.value(window, region)
                if found is not ABSENT:
                    history = sorted(of_sender(region.data.get(channel, []), host), key=lambda m: m.time)
                    values = [member(m.message, path) for m in history if m.time >= self.now - found]
                    there = [value for value in values if value is not ABSENT]
                    found = reduce(add, there) / len(there) if there else ABSENT
            case ("element", items, index, path):
                # "`list[i]` is the element with the number i, from 0; … absent where there is none"
                read = [self.look_up(items, region)]
                read.append(ABSENT if read[0] is ABSENT else self.look_up(index, region))
                found = ABSENT
                if ABSENT not in read:
                    held, number = [self.compute(item) for item in read]
                    numbered = dict(enumerate(held))
                    found = member(numbered[number], path) if number in numbered else ABSENT
            case ("find", items, wanted, *more):
                # "The number of the first one … absent where there is none"
                read = [self.look_up(items, region)]
                read.append(ABSENT if read[0] is ABSENT else self.look_up(wanted, region))
                found = ABSENT
                if ABSENT not in read:
                    held, sought = [self.compute(item) for item in read]
                    looked = [n for n, item in enumerate(held) if member(item, *(more or [()])) == sought]
                    found = looked[0] if looked else ABSENT
            case ("contains", items, wanted, path):
                read = [self.look_up(items, region)]
                read.append(ABSENT if read[0] is ABSENT else self.look_up(wanted, region))
                return ABSENT if ABSENT in read else ("contains", *read, path)
            case ("new", name, fills, rest):
                # "A new message is absent where something that it is made of is"
                made = [(path, self.look_up(value, region)) for path, value in fills]
                of = None if rest is None else (self.look_up(rest[0], region), rest[1])
                if any(value is ABSENT for _, value in made) or (of is not None and of[0] is ABSENT):
                    return ABSENT
                return ("new", name, tuple(made), of)
            case ("holds", operand):
                # "`holds(c)` is two-valued"
                found = self.holds(operand, region)
            case ("!" | "&&" | "||", *_):
                # "As a plain value, a logic expression is True if it holds, False if it fails, else absent."
                found = True if self.holds(term, region) else False if self.fails(term, region) else ABSENT
            case _:
                read = []
                for operand in term[1:]:
                    item = self.look_up(operand, region) if isinstance(operand, tuple) else operand
                    if item is ABSENT:
                        return ABSENT
                    read.append(item)
                return (term[0], *read)
        return ABSENT if found is ABSENT else ("const", found)

    def read_member(self, host: str | None, channel: str, path: tuple[str, ...], region: Region) -> Any:
        message = region.sees(channel, host)
        return ABSENT if message is None else member(message.message, path)

    def compute(self, term: Term) -> Any:
        """The value of a term in which everything has been looked up."""
        match term:
            case ("const", constant):
                return constant
            case ("random",):
                # "one generator an agent, from the run's seed and the agent's name"
                self.chance = self.chance or Random(f"{self.seed}/{self.agent}")
                drawn = self.chance.random()
                self.outcome.effects.append(FunctionResult("random", drawn))
                return drawn
            case ("duration", inner):
                # "Time is an `int` of nanoseconds everywhere"
                return int(self.compute(inner))
            case ("neg", inner):
                return -self.compute(inner)
            case ("list", *elements):
                return tuple(self.compute(element) for element in elements)
            case ("new", name, fills, rest):
                filled = [(path, self.compute(value)) for path, value in fills]
                message = self.messages[name]()
                given = None if rest is None else self.compute(rest[0])
                taken = () if rest is None else rest[1]
                for path, value in (*(((own,), getattr(given, own)) for own in taken), *filled):
                    message = with_member(message, path, value)
                return message
            case ("append", items, item):
                return (*self.compute(items), self.compute(item))
            case ("drop", items, index):
                # "An element that is not there": the action fails the state
                held, number = self.compute(items), self.compute(index)
                kept = [item for n, item in enumerate(held) if n != number]
                if len(kept) == len(held):
                    raise NoElement(len(held), number)
                return tuple(kept)
            case ("put", items, index, item):
                held, number, new = self.compute(items), self.compute(index), self.compute(item)
                changed = [new if n == number else old for n, old in enumerate(held)]
                if not 0 <= number < len(held):
                    raise NoElement(len(held), number)
                return tuple(changed)
            case ("remove", items, item):
                kept, sought = [], [self.compute(item)]
                for held in self.compute(items):
                    if sought and held == sought[0]:
                        sought = []
                    else:
                        kept.append(held)
                return tuple(kept)
            case ("size", items):
                return sum(1 for _ in self.compute(items))
            case ("contains", items, wanted):
                sought = self.compute(wanted)
                return any(item == sought for item in self.compute(items))
            case ("contains", items, wanted, path):
                sought = self.compute(wanted)
                return any(member(item, path) == sought for item in self.compute(items))
            case ("builtin", name, *arguments):
                return BUILT_IN[name](*[self.compute(argument) for argument in arguments])
            case ("call", name, *arguments):
                return self.call(name, [self.compute(argument) for argument in arguments])
            case (operator, left, right):
                return OPERATORS[operator](self.compute(left), self.compute(right))
        raise ValueError(term)

    def call(self, name: str, values: list[Any]) -> Any:
        target = next(function[1] for function in self.plan.functions if function[0] == name)
        module, _, function = target.partition(":")
        result = getattr(import_module(module), function)(*values)
        self.outcome.effects.append(FunctionResult(name, result))
        return result

    # ---- time -------------------------------------------------------------------------------

    def due(self, now: int) -> int | None:
        """ "the earliest moment > now at which an active source's transition may become enabled by time
        alone: `after`, a started timer named in its condition (or a branch's), `age(x)` crossing the constant
        duration it is compared with (time + c; + 1 ns for `>` and `<=`)." """
        moments = [moment for source in self.active for moment in self.moments(source, source)]
        # … and the deadline of an activity that runs
        for info in self.plan.activities:
            for state in self.plan.states:
                if info.within is not None and state.activity == info.name and self.runs(state.label):
                    moments.append(self.entered[state.label] + info.within)
        return min((moment for moment in moments if moment > now), default=None)

    def moments(self, node: str, source: str) -> Iterator[int]:
        region = self.regions[self.region_of(source)]
        for _, transition in self.plan.outgoing(node):
            for event in transition.events:
                if event[0] == "after":
                    yield self.entered[source] + event[1]
            if transition.every is not None:
                yield self.entered[source] + transition.every
            for term in parts(transition.condition):
                match term:
                    case ("expired", timer) if timer in region.timers:
                        yield region.timers[timer]
                    case ("<" | "<=" | ">" | ">=" | "==" | "!=" as operator, left, right):
                        events = [event for event in transition.events if event[0] == "received"]
                        letters = [mail for event in events for mail in self.waiting(event, source)]
                        yield from self.crossings(operator, left, right, region, letters)
                        yield from self.crossings(MIRRORED[operator], right, left, region, letters)
            if self.type_of(transition.target) == "CONDITION":
                yield from self.moments(transition.target, source)

    def sent(self, mail: AgentMessage) -> int:
        return self.came[mail.identity] if mail.sent is None else mail.sent

    def crossings(
        self, operator: str, age: Term, amount: Term, region: Region, letters: list[AgentMessage]
    ) -> Iterator[int]:
        """When `age(x) operator amount` changes: "time + c; + 1 ns for `>` and `<=`" (`==` changes twice)."""
        if age[0] != "age" or not is_constant(amount):
            return
        try:
            length = self.compute(amount)
        except ZeroDivisionError:
            return
        if age[1][0] == "taken":
            times = [self.sent(mail) for mail in letters]
        else:
            message = region.sees(age[1][2], age[1][1])
            times = [] if message is None else [message.time]
        for time in times:
            if operator in ("<", ">=", "==", "!="):
                yield time + length
            if operator in (">", "<=", "==", "!="):
                yield time + length + 1


OPERATORS: dict[str, Callable[[Any, Any], Any]] = {
    "==": lambda a, b: a == b,
    "!=": lambda a, b: a != b,
    "<": lambda a, b: a < b,
    "<=": lambda a, b: a <= b,
    ">": lambda a, b: a > b,
    ">=": lambda a, b: a >= b,
    "+": lambda a, b: a + b,
    "-": lambda a, b: a - b,
    "*": lambda a, b: a * b,
    # "`/` on numbers gives double (int/int too); `%` is Python's"
    "/": lambda a, b: a / b,
    "%": lambda a, b: a % b,
    # "duration / int" gives "duration": whole ns
    "//": lambda a, b: a // b,
}

MIRRORED = {"<": ">", "<=": ">=", ">": "<", ">=": "<=", "==": "==", "!=": "!="}
"""`c < age(x)` says `age(x) > c`."""

BUILT_IN: dict[str, Callable[..., Any]] = {"abs": abs, "min": min, "max": max}


def is_same(one: Any, other: Any) -> bool:
    """Whether a message is the same one, or a value (in a tuple of one) has stayed."""
    return one == other if isinstance(one, tuple) and isinstance(other, tuple) else one is other


def without_arguments(name: str) -> str:
    """ "A state goes by its formula or activity, whatever that is given": `deliver` of `deliver(a, f(b))`."""
    before, _, inside = name.partition("(")
    depth = [inside[: n + 1].count(")") - inside[: n + 1].count("(") for n in range(len(inside))]
    return before if 1 in depth and depth.index(1) == len(inside) - 1 else name


def is_constant(term: Term) -> bool:
    """Whether a term reads nothing and calls no function."""
    return all(part[0] in ("const", "neg", "duration", *OPERATORS) for part in parts(term))


def member(message: Any, path: tuple[str, ...]) -> Any:
    """The member at a path, or ABSENT where it (or what it is in) is not there."""
    for name in path:
        message = getattr(message, name)
        if message is None:
            return ABSENT
    return message


def with_member(message: Any, path: tuple[str, ...], value: Any) -> Any:
    """A copy of the message with another value at the path."""
    if not path:
        return value
    if len(path) > 1:
        value = with_member(getattr(message, path[0]), path[1:], value)
    return replace(message, **{path[0]: value})


def values_of(action: Term) -> list[Term]:
    """The values that an action computes."""
    match action:
        case ("assign" | "fill" | "start_timer", _, value) | ("evaluate", value):
            return [value]
        case ("send", _, _, _, fills, to, excepts, *more):
            rest, reply_by, _ = more or (None, None, False)
            single = [rest[0] if rest is not None else None, reply_by, to]
            given = [value for value in single if value is not None]
            return [*(value for _, value in fills or ()), *given, *excepts]
    return []


class NoElement(Exception):
    """An action changes an element that is not there: how many there are, and which was meant."""


def parts(term: Term | None) -> Iterator[Term]:
    """A term and all terms in it."""
    if term is None:
        return
    yield term
    at = {"element": 3, "contains": 3, "find": 3, "variable": 2}.get(str(term[0]), len(term))
    path = term[at] if at < len(term) else None
    for item in term[1:]:
        if isinstance(item, tuple) and item and term[0] not in ("member", "taken") and item is not path:
            yield from parts(item)


def speaks_of_mail(transition: Transition) -> bool:
    """Whether the condition or an action speaks of the agent message that the transition takes."""
    values = [value for action in transition.actions for value in values_of(action)]
    return any(
        p[0] in ("taken", "sender", "reason") for term in (transition.condition, *values) for p in parts(term)
    )


def signals_of(*terms: Term | None) -> list[tuple[str, str | None]]:
    """The signals that conditions and actions name: (channel, host), each once; not what an action fills."""
    found = []
    for term in terms:
        read = [term] if term is None or term[0] not in ACTIONS else values_of(term)
        for value in read:
            for part in parts(value):
                if (
                    part[0] == "member"
                    and part[2].split(".")[1] == "signal"
                    and (part[2], part[1]) not in found
                ):
                    found.append((part[2], part[1]))
    return found


ACTIONS = ("assign", "fill", "publish", "read_messages", "start_timer", "send", "evaluate")
