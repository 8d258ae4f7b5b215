"""Plans: the declarative face of a statechart, registered by name, for people and tools to read.

Nothing in the product interprets a plan; the class in `step.py` beside it is what runs.

Conditions and values are nested tuples whose first item says what they are:

    ```text
    ("const", value)  ("enum", "PlayerState", "PLAYING", 3)  ("variable", name)
    ("variable", name, ("member",))
    ("member", sender or None, "vision.state.Ball", ("visible",))      (the message itself with an empty path)
    ("taken", path)  ("sender",)  ("reason",)       (of the agent message that the transition takes)
    ("call", name, value, …)  ("builtin", name, value, …)  ("has", member or variable)
    ("new", "Order", ((("id",), value), …), (value of the rest, ("item",)) or None)
    ("list", value, …)  ("element", list, value, ("name",))  ("size", list)
    ("contains" | "find", list, value)  ("contains" | "find", list, value, ("member",))
    ("age", member)  ("at", member, value)  ("mean", member, value)  ("expired", timer)
    ("outcome", activity)  ("index",)  ("random",)  ("in" | "done" | "count", state name)
    ("invited" | "answered" | "all_answered", participant)
    ("!", value)  ("&&", value, …)  ("||", value, …)  ("neg", value)  ("holds", value)
    ("==" | "!=" | "<" | "<=" | ">" | ">=", value, value)
    ("+" | "-" | "*" | "/" | "//" | "%", value, value)
    ```

Events are:

    ```text
    ("after", ns)  ("received", performative, message, participant)  ("lost", participant)
    ("raised", name)  ("error",)
    ```

Actions are:

    ```text
    ("assign", name, value)  ("fill", member, value)  ("publish", channel)  ("read_messages",)
    ("start_timer", name, value)  ("evaluate", value)  ("send", performative, message, participant)
    ("raise", event)
    ```

Where more is said, `send` has three more items:

- what is filled, as ((path, value), …) or None;
- the value that is the one receiver, or None;
- the values that it does not go to.

And three more again:

- (message value, the members that are taken of it) or None;
- the duration within which an answer is wanted, or None;
- whether it goes to one agent of the participant.

Durations are in ns; ("duration", value) cuts a computed one to whole ns.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from functools import cached_property

from aseme_dsl.records import dataclass

Term = tuple[object, ...]
Kind = tuple[str, str, str]
"""An agent message: performative, message and the participant that it is from ("": any)."""


@dataclass(frozen=True, slots=True)
class State:
    """A state: `type` is one of START END OR AND BASIC CONDITION, `at` its place in the source."""

    label: str
    name: str
    type: str
    parent: str | None = None
    activity: str | None = None
    branch: str | None = None
    """`protocol.participant` where the state is the branch of a participant."""
    at: str = ""
    arguments: tuple[tuple[str, Term], ...] = ()
    """What the activity is given, by parameter."""


@dataclass(frozen=True, slots=True)
class Transition:
    """A transition with its expression, as data and (`text`) as written."""

    source: str
    target: str
    priority: int = 0
    events: tuple[Term, ...] = ()
    when: bool = False
    otherwise: bool = False
    every: int | None = None
    """The pace of a loop: not before so many ns since the source was entered."""
    condition: Term | None = None
    weight: int | None = None
    """Of the open branches of its source that have weights, one is drawn."""
    actions: tuple[Term, ...] = ()
    first: bool = False
    """Whether it cuts its source short: it is tried before anything inside."""
    kind: str = "external"
    """`on` and `exit` do not change the state: they are done while it is active, or when it is exited."""
    resume: bool = False
    """Whether the target is resumed where it was last left before it was complete."""
    text: str = ""
    at: str = ""
    into: tuple[str, ...] = ()
    """Of a target AND: the states, in regions of it, that are entered instead of the STARTs there."""

    @property
    def targets(self) -> tuple[str, ...]:
        """The states that it names as its targets."""
        return self.into or (self.target,)


@dataclass(frozen=True, slots=True)
class Variable:
    """A variable; `scope` is the label of the branch whose entry renews it, or None.

    `bounds` are the least and the greatest number that it may hold, if it has some; `length` is how many
    elements a list has at most.
    """

    name: str
    type: str
    initial: object
    scope: str | None = None
    bounds: tuple[int | float, int | float] | None = None
    length: int | None = None


@dataclass(frozen=True, slots=True)
class Region:
    """The root or an OR state directly inside an AND, and the channels its blackboard knows."""

    label: str
    reads: tuple[str, ...] = ()
    writes: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class ActivityInfo:
    """What the document says of an activity: `every` and `takes` in ns, `kind`, what it reads and writes.

    `variables` are those of the role that it writes, `reads_variables` those that it reads; `histories` says
    how far it looks back at data channels, in ns. `within` is its deadline in ns, from the entry of its
    state; `ends` are its outcomes, `parameters` the names and types of what it is given. Of one that is
    `simulated` or `waits` no code is loaded; one that `waits` never ends by itself.
    """

    name: str
    kind: str = "thread"
    every: int | None = None
    takes: int | None = None
    reads: tuple[str, ...] = ()
    writes: tuple[str, ...] = ()
    variables: tuple[str, ...] = ()
    reads_variables: tuple[str, ...] = ()
    histories: tuple[tuple[str, int], ...] = ()
    within: int | None = None
    ends: tuple[str, ...] = ()
    parameters: tuple[tuple[str, str], ...] = ()
    simulated: bool = False
    waits: bool = False


@dataclass(frozen=True, slots=True)
class ModuleInfo(ActivityInfo):
    """What the document says of a module; `target` is `module:Class` where it is not found by its name."""

    target: str = ""


@dataclass(frozen=True, slots=True)
class ChannelInfo:
    """A channel: its message type, whether signals queue, how long data is kept (ns), its radio number."""

    name: str
    message: str
    queued: bool = False
    retention: int = 0
    every: int | None = None
    persist: bool = False
    sources: tuple[str, ...] = ()
    radio: int | None = None
    """The most bytes a radio message of its topic may have, or None where it does not go by radio."""
    delay: int = 0
    """How old a radio message of its topic is when it arrives, in ns."""
    expires: int | None = None
    """The age at which an untaken signal is dropped, in ns."""

    @property
    def is_from_outside(self) -> bool:
        """Whether its topic says that messages come from outside of the team, besides those of the team."""
        return "outside" in self.sources


@dataclass(frozen=True, slots=True)
class BranchInfo:
    """A protocol branch in this plan: what its participant sends and receives as (performative, message)."""

    label: str
    protocol: str
    participant: str
    sends: tuple[tuple[str, str], ...] = ()
    receives: tuple[tuple[str, str], ...] = ()
    moves: tuple[tuple[str, str, tuple[str, ...], bool], ...] = ()
    """What activities send, as (performative, message, states, repeatedly): only in these states, given by
    their labels, and once to each agent unless `repeatedly`. All else is sent by transitions alone."""
    opens: tuple[tuple[str, str], ...] = ()
    """What can be the first message that it takes: only such a message takes an instance of it."""
    version: str = ""
    """The hash of what the protocol's participants say, in which order, and of the messages: agents for which
    it is the same may take part in one conversation."""
    loses: tuple[str, ...] = ()
    """The participants of which it waits to hear that an agent is lost."""
    counts: tuple[str, ...] = ()
    """The participants whose answers a condition counts (`all_answered(q)`)."""
    participants: tuple[tuple[str, int, int | None], ...] = ()
    """All participants of the protocol: name, and how many agents of each take part at least and at most."""
    busy: tuple[str, str, tuple[tuple[tuple[str, ...], object], ...] | None] | None = None
    """What an invitation is answered while all instances are in use, as (performative, message, members with
    their values); without members the answer says what the invitation says. None: the invitation waits."""

    @property
    def automata(self) -> str:
        """The first half of the version: the hash of what the participants say, in which order."""
        return self.version[: len(self.version) // 2]

    def knows(self, participant: str) -> bool:
        """Whether the protocol has a participant of that name."""
        return any(name == participant for name, _, _ in self.participants)

    def size_of(self, participant: str) -> tuple[int, int | None]:
        """How many agents take part as a participant, at least and (None: any number) at most."""
        return next(((low, high) for name, low, high in self.participants if name == participant), (1, None))


@dataclass(frozen=True)
class Plan:
    """The statechart of a role, as declared in a `.aseme` file (P1 Figure 8, P2 Figure 3)."""

    name: str
    system: str
    source: str
    model: str
    """The hash of the model this plan was generated from."""
    states: tuple[State, ...]
    transitions: tuple[Transition, ...]
    variables: tuple[Variable, ...] = ()
    regions: tuple[Region, ...] = ()
    activities: tuple[ActivityInfo, ...] = ()
    channels: tuple[ChannelInfo, ...] = ()
    functions: tuple[tuple[str, str, str, str], ...] = ()
    """Functions as (name in call terms, "module:name", result type, place of the declaration)."""
    branches: tuple[BranchInfo, ...] = ()
    modules: tuple[ModuleInfo, ...] = ()
    settings: tuple[tuple[str, str, object], ...] = ()
    """What variables hold at first in some agents, as (agent, variable, value)."""
    numbers: tuple[tuple[str, int], ...] = ()
    """The numbers of agents that are not 1, as far as a program asks for them."""

    @cached_property
    def by_label(self) -> dict[str, State]:
        return {state.label: state for state in self.states}

    def begins(self, agent: str) -> str:
        """What is its own of an agent when it begins: its settings and its number, as a text."""
        settings = [(name, value) for other, name, value in self.settings if other == agent]
        return repr((settings, dict(self.numbers).get(agent, 1)))

    def are_concurrent(self, one: str, other: str) -> bool:
        """Whether two states, by their labels, are in different regions of an AND."""
        common = 0
        first, second = one.split("."), other.split(".")
        while common < min(len(first), len(second)) and first[common] == second[common]:
            common += 1
        if common in (len(first), len(second)):
            return False
        state = self.by_label.get(".".join(first[:common]))
        return state is not None and state.type == "AND"

    def entries_of(self, transition: Transition) -> tuple[str, ...]:
        """The targets, and the regions of ANDs around them that are entered at their STARTs with them."""
        targets = transition.targets
        found = dict.fromkeys(targets)
        for target in targets:
            parts = target.split(".")
            for end in range(1, len(parts)):
                around = ".".join(parts[:end])
                stays = transition.source.startswith(f"{around}.") and around != transition.target
                if self.by_label[around].type == "AND" and not stays:
                    found |= {
                        region.label: None
                        for region in self.children(around)
                        if not any(is_in(other, region.label) for other in targets)
                    }
        return tuple(found)

    def way(self, numbers: Sequence[int]) -> str:
        """What a compound transition leads from and to, and where it is written, for messages."""
        first, last = self.transitions[numbers[0]], self.transitions[numbers[-1]]
        return f"{self.called(self.by_label[first.source])} -> {self.called_all(last.targets)} ({first.at})"

    def called_all(self, labels: Sequence[str]) -> str:
        """What people call the targets of a transition: of several, in parentheses."""
        names = [self.called(self.by_label[label]) for label in labels]
        return names[0] if len(names) == 1 else f"({', '.join(names)})"

    def called(self, state: State) -> str:
        """What people call a state: by what it is in the state around it where its name is only its label."""
        around = state
        while around.parent is not None and around.name in ("", around.label):
            around = self.by_label[around.parent]
        if around is state or around.name in ("", around.label):
            return state.name or state.label
        what = {"START": "start of ", "END": "end of ", "CONDITION": "choice in "}.get(state.type, "in ")
        return what + around.name

    @cached_property
    def receivers(self) -> dict[tuple[str, str, str], tuple[str, ...]]:
        """The participants that receive a message, by protocol, performative and message."""
        found: dict[tuple[str, str, str], dict[str, None]] = {}
        for info in self.branches:
            for performative, message in info.receives:
                found.setdefault((info.protocol, performative, message), {})[info.participant] = None
        return {key: tuple(parts) for key, parts in found.items()}

    def children(self, label: str) -> tuple[State, ...]:
        """The states directly inside `label`, in document order."""
        return self.inside.get(label, ())

    @cached_property
    def inside(self) -> dict[str, tuple[State, ...]]:
        """The states directly inside each composite, in document order."""
        found: dict[str, list[State]] = {}
        for state in self.states:
            if state.parent is not None:
                found.setdefault(state.parent, []).append(state)
        return {label: tuple(states) for label, states in found.items()}

    @cached_property
    def chooses(self) -> bool:
        """Whether a transition sends to one agent of several."""
        actions = (action for item in self.transitions for action in item.actions)
        return any(action[0] == "send" and action[9:] == (True,) for action in actions)

    @cached_property
    def resumed(self) -> tuple[str, ...]:
        """The labels of the states that some transition resumes."""
        return tuple(dict.fromkeys(item.target for item in self.transitions if item.resume))

    @cached_property
    def counted(self) -> frozenset[tuple[str, str]]:
        """The participants whose answers a condition counts, each with the label of the branch."""
        return frozenset((info.label, name) for info in self.branches for name in info.counts)

    @cached_property
    def branch_labels(self) -> frozenset[str]:
        """The labels of the states that are the branch of a participant."""
        return frozenset(info.label for info in self.branches)

    def at_once(self, counted: frozenset[str]) -> int:
        """How many of these states, given by their labels, can be active at once."""
        widths: dict[str, int] = {}
        for state in reversed(self.states):  # what is inside a state comes after it
            width = widths.get(state.label, 0) + (state.label in counted)
            if state.parent is not None:
                beside = widths.get(state.parent, 0)
                together = self.by_label[state.parent].type == "AND"
                widths[state.parent] = beside + width if together else max(beside, width)
        return widths.get(self.states[0].label, 0)

    def branch_of(self, label: str) -> str | None:
        """The label of the innermost protocol branch around a state, or None."""
        known = self._branch_of
        if label not in known:
            around = [info.label for info in self.branches if is_in(label, info.label)]
            known[label] = max(around, key=len, default=None)
        return known[label]

    @cached_property
    def _branch_of(self) -> dict[str, str | None]:
        return {}

    def can_end(self, label: str) -> bool:
        """Whether a state can be complete, if all conditions may hold."""
        known = self._can_end
        if label not in known:
            match self.by_label[label].type:
                case "AND":
                    known[label] = all(self.can_end(child.label) for child in self.children(label))
                case "OR":
                    known[label] = self._reaches_end(label)
                case _:
                    known[label] = True
        return known[label]

    @cached_property
    def _can_end(self) -> dict[str, bool]:
        return {}

    def _reaches_end(self, label: str) -> bool:
        inside = {child.label: child for child in self.children(label)}
        ways = [item for item in self.transitions if item.kind == "external"]
        seen: set[str] = set()
        todo = [name for name, child in inside.items() if child.type == "START"]
        todo += [
            name
            for item in ways
            if item.into or not is_in(item.source, label)
            for target in item.targets
            for name in inside
            if is_in(target, name)
        ]
        while todo:
            name = todo.pop()
            if name in seen:
                continue
            seen.add(name)
            if inside[name].type == "END":
                return True
            is_complete = self.can_end(name)
            todo += [
                other
                for item in ways
                if is_in(item.source, name)
                and (is_complete or item.first or item.when or item.events or item.source != name)
                for other in inside
                if is_in(item.target, other)
            ]
        return False

    @cached_property
    def activities_inside(self) -> dict[str, tuple[State, ...]]:
        """The states with activities inside each protocol branch, in document order."""
        states = [state for state in self.states if state.activity]
        return {
            branch: tuple(item for item in states if item.label.startswith(f"{branch}."))
            for branch in self.branch_labels
        }

    @cached_property
    def _sources(self) -> dict[str, list[Transition]]:
        """The transitions of each source that can be taken while it is active."""
        found: dict[str, list[Transition]] = {}
        for item in self.transitions:
            if item.kind not in ("exit", "abandon"):
                found.setdefault(item.source, []).append(item)
        return found

    @cached_property
    def _taken_from(self) -> dict[tuple[str, str], frozenset[Kind]]:
        return {}

    def taken_from(self, branch: str, leaf: str) -> frozenset[Kind]:
        """The agent messages that a branch can take now or later while this leaf inside it is active.

        All conditions may hold, and what is left may be complete. A message that no transition of the branch
        takes is one for its activities, whenever one may be active.
        """
        found = self._taken_from.get((branch, leaf))
        if found is None:
            found = self._taken_from[branch, leaf] = frozenset(self._find_taken(branch, leaf))
        return found

    def _find_taken(self, branch: str, leaf: str) -> Iterator[Kind]:
        within = f"{branch}."
        todo = [(leaf, False)]
        reached: set[tuple[str, bool]] = set()
        while todo:
            label, is_entered = todo.pop()
            if (label, is_entered) in reached or not label.startswith(within):
                continue
            reached.add((label, is_entered))
            state = self.by_label[label]
            if state.parent is not None:
                todo.append((state.parent, False))
            if is_entered and state.type == "AND":
                todo += [(child.label, True) for child in self.children(label)]
            elif is_entered and state.type == "OR":
                todo += [(child.label, True) for child in self.children(label) if child.type == "START"]
            for item in self._sources.get(label, ()):
                if item.kind == "external":
                    todo += [(other, True) for other in (item.target, *self.entries_of(item))]
                if item.resume:
                    todo += [(other.label, True) for other in self.states if is_in(other.label, item.target)]
        by_lines: set[tuple[str, str]] = set()
        labels = {label for label, _ in reached}
        for item in self.transitions:
            if self._around(item.source) == branch:
                events = (map(str, event[1:4]) for event in item.events if event[0] == "received")
                kinds = [(act, message, sender) for act, message, sender in events]
                by_lines.update((performative, message) for performative, message, _ in kinds)
                if item.source in labels:
                    yield from kinds
        if any(self.by_label[item].activity and self.branch_of(item) == branch for item in labels):
            info = next(item for item in self.branches if item.label == branch)
            yield from ((*kind, "") for kind in info.receives if kind not in by_lines)

    def _around(self, label: str) -> str | None:
        """The branch to which the transitions of a state belong: the innermost around it, never itself."""
        return self.branch_of(label if label not in self.branch_labels else label.rpartition(".")[0])

    def variable_of(self, name: str, label: str) -> Variable:
        """The variable that a state's activity means by a name: the innermost. Raises LookupError."""
        known = self._variable_of.get((name, label))
        if known is None:
            known = self._variable_of[name, label] = self._find_variable(name, label)
        return known

    @cached_property
    def _variable_of(self) -> dict[tuple[str, str], Variable]:
        return {}

    def _find_variable(self, name: str, label: str) -> Variable:
        found = [
            variable
            for variable in self.variables
            if variable.name.partition("@")[0] == name
            and (variable.scope is None or (label + ".").startswith(variable.scope + "."))
        ]
        if not found:
            known = ", ".join(sorted({v.name.partition("@")[0] for v in self.variables})) or "none"
            raise LookupError(f"no variable {name} here; {self.name} has {known}")
        return max(found, key=lambda variable: len(variable.scope or ""))

    def outgoing(self, label: str) -> tuple[tuple[int, Transition], ...]:
        """The transitions of a source with their numbers, in the order in which they are tried."""
        found = [
            (n, t)
            for n, t in enumerate(self.transitions)
            if t.source == label and t.kind not in ("exit", "abandon")
        ]
        return tuple(sorted(found, key=lambda item: item[1].priority))


_registry: dict[tuple[str, str], Plan] = {}


def is_in(label: str, state: str) -> bool:
    """Whether a state, by its label, is another one or inside it."""
    return label == state or label.startswith(f"{state}.")


def terms_in(parts: Iterable[object]) -> Iterator[tuple[object, ...]]:
    """The terms among conditions, values and actions, and all terms inside them."""
    todo = list(parts)
    while todo:
        term = todo.pop()
        if isinstance(term, tuple):
            yield term
            todo += term


def terms_of(plan: Plan) -> Iterator[tuple[object, ...]]:
    """All terms in the lines of a plan, and in what its activities are given."""
    lines = (part for item in plan.transitions for part in (item.condition, *item.actions))
    return terms_in((*lines, *(term for state in plan.states for _, term in state.arguments)))


def register(plan: Plan) -> Plan:
    """Make a plan known under its system and name; a later one of the same name replaces it."""
    _registry[plan.system, plan.name] = plan
    return plan


def plans() -> Iterator[Plan]:
    """Every registered plan, by system and name."""
    return (plan for _, plan in sorted(_registry.items()))


def find_plan(name: str, system: str | None = None) -> Plan | None:
    """The registered plan of that name (of that system, where several systems have one)."""
    return next((p for p in plans() if p.name == name and system in (None, p.system)), None)
