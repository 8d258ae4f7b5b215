"""Views: a running chart as an agent with a tree of behaviours, in the terms of JADE.

The backend `jade_like` generates a class for each behaviour and one for the agent. They show what the chart
does and decide nothing. A behaviour is active while its state is, on every backend, and the chart runs the
same without them. A class of the user may have `on_start` and `on_end`, a waker also `on_wake`. They are
called after the step that enters or leaves their states, in the same order and at its time. They must not
block. What they raise is recorded in the trace as a fault, and the agent continues.

Behaviours that a user adds beside the tree do act: they are in `added_behaviours`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence, Set
from dataclasses import is_dataclass
from itertools import pairwise
from typing import Any, ClassVar, TypeVar, cast

from aseme_dsl.records import dataclass
from aseme_dsl.runtime.activity.activities import ActivityError, ActivityFinder, Executable
from aseme_dsl.runtime.activity.checking import fits
from aseme_dsl.runtime.activity.execution import Host
from aseme_dsl.runtime.activity.returning import frames_of, reason_of
from aseme_dsl.runtime.agent import added_behaviours as added
from aseme_dsl.runtime.agent import fipa_callbacks
from aseme_dsl.runtime.agent.behaviour_scheduler import ROOT, BehaviourScheduler
from aseme_dsl.runtime.agent.data_store import HasDataStore
from aseme_dsl.runtime.chart.bounds import check_variable
from aseme_dsl.runtime.chart.chart import Chart
from aseme_dsl.runtime.chart.following import Following, Shape
from aseme_dsl.runtime.chart.inputs import AgentMessage, Happened, Identity, Outcome, Written
from aseme_dsl.runtime.chart.plan import is_in
from aseme_dsl.runtime.conversation.directory import AgentDirectory, Directory, Offer, Service, Withdraw
from aseme_dsl.runtime.message.as_json import to_json
from aseme_dsl.runtime.message.free import ACLMessage, MessageTemplate

_T = TypeVar("_T")

START, CHOICE, END = "START", "CHOICE", "END"
"""The points of a behaviour: where it begins, where it chooses, where it is done."""
_POINTS = {START: "START", CHOICE: "CONDITION", END: "END"}

_CALLED = ("handle_", "prepare_", "next_notification", "next_provider", "await_condition")
"""How the methods of a participant's behaviour begin that are called for a message or as an activity."""

ALL = "all"
"""When a parallel behaviour is done: when all that is in it is."""


@dataclass(frozen=True, slots=True)
class Way:
    """How one state follows on another: `text` is what stands on the transition, "" for completion.

    With `stays`, nothing is left: something is done while the source is active, or when it is left. `into`
    are the states in regions of the target, by their labels, at which these begin.
    """

    source: str
    target: str
    text: str = ""
    stays: bool = False
    into: tuple[str, ...] = ()


_Registered = tuple[
    "type[Behaviour] | str",
    "type[Behaviour] | str | None",
    str,
    "tuple[type[WakerBehaviour], ...]",
    tuple[str, ...],
]
"""A source, a target (None where nothing is left), what is said of the way, the times in it, its `into`."""


class Behaviour(HasDataStore):
    """What is done while a state is active."""

    states: ClassVar[tuple[str, ...]] = ()
    """The labels of the states that it stands for, the outermost first: more than one where a state only
    wraps another."""
    at: ClassVar[str] = ""
    """The place in the source."""
    protocol: ClassVar[str] = ""
    participant: ClassVar[str] = ""
    """Whose part in which protocol it is, if it is one's."""
    _sub: tuple[Behaviour, ...] = ()

    def __init__(self, agent: JadeLikeAgent) -> None:
        self.agent = agent
        self.parent: Behaviour | None = None
        self._began = 0
        self._ended = 0

    def build(self) -> None:
        """Say what is in it. Generated."""

    def on_start(self) -> None:
        """Called when its state has been entered; to be overridden."""

    def on_end(self) -> None:
        """Called when its state has been left, complete or not; to be overridden."""

    @property
    def name(self) -> str:
        """The name of its class."""
        return type(self).__name__

    @property
    def label(self) -> str:
        """The label of its state."""
        return self.states[0]

    @property
    def sub_behaviours(self) -> tuple[Behaviour, ...]:
        """What is in it, in document order."""
        return self._sub

    @property
    def active(self) -> bool:
        """Whether its state is active."""
        return self.label in self.agent.active

    @property
    def done(self) -> bool:
        """Whether it has done what it does since what is around it began: its state is complete or left."""
        if self.active:
            return self.agent.is_complete(self.label)
        return self._ended > (self.parent._began if self.parent is not None else 0)

    @property
    def transitions(self) -> tuple[Way, ...]:
        """How the states that it stands for, and what is in it, follow on each other."""
        return tuple(Way(*pair) for pair in self._implied())

    def log(self, text: str) -> None:
        """Write a line into the trace."""
        self.agent.log(self, text)

    def raise_event(self, name: str) -> None:
        """Raise an event: transitions that wait for it see it in the agent's next step."""
        self.agent._raise_event(name, self.name, self.states[-1])

    def get_variable(self, name: str) -> Any:
        """A variable of its participant or of the role. Raises LookupError if there is none."""
        return self.agent._variable(name, self.states[-1])

    def set_variable(self, name: str, value: object) -> None:
        """Write a variable of its participant or of the role. Raises LookupError and TypeError."""
        self.agent._set_variable(name, value, self.name, self.states[-1])

    def prepare(self, message: object) -> None:
        """Give what the next `send` of this message type of its participant contains. Raises TypeError."""
        self.agent._prepare(message, self)

    # ---- for the callbacks of a participant ----------------------------------------------------

    def heard(self) -> tuple[AgentMessage, ...]:
        """What its participant has taken in this conversation, the last message of each kind and sender."""
        return self.agent._heard(self)

    def default_of(self, message: str) -> Any:
        """A message of a type with its defaults."""
        return self.agent._default_of(message)

    def tells_responses(self) -> bool:
        """Whether `handle_all_responses` was not called in this conversation; from now on it was."""
        return self.agent._tells_responses(self)

    def news(self) -> tuple[AgentMessage, ...]:
        """What its participant has taken in this conversation since this was asked last."""
        return self.agent._news(self)

    def _implied(self) -> Iterator[tuple[str, str]]:
        """The transitions that need no mention."""
        for outer, inner in pairwise(self.states):
            yield from self._between(outer, [inner])

    def _between(self, around: str, labels: Sequence[str]) -> Iterator[tuple[str, str]]:
        """One after the other, from START to END."""
        start, end = (self._point(around, kind) for kind in ("START", "END"))
        row = [label for label in (start, *labels, end) if label is not None]
        yield from pairwise(row)

    def _point(self, around: str, kind: str) -> str | None:
        inside = self.agent.plan.children(around)
        return next((state.label for state in inside if state.type == kind), None)

    def __repr__(self) -> str:
        state = "active" if self.active and not self.done else "done" if self.done else "waiting"
        return f"<{self.name} {'/'.join(self.states) or self.label} {state}>"


class OneShotBehaviour(Behaviour):
    """An activity: it is done when the activity has returned."""


class WakerBehaviour(Behaviour):
    """A time after which what it waits in is left, or something is done in it (`after`)."""

    waits_in: ClassVar[tuple[str, ...]] = ()
    """The labels of the states that it waits in: of any one of them."""
    timeout: ClassVar[int] = 0
    """In ns."""

    def on_wake(self) -> None:
        """Called when its time has come and its transition is taken, before `on_end`; to be overridden."""

    @property
    def label(self) -> str:
        """The label of the state that it waits in, the first if there are several."""
        return self.waits_in[0]

    @property
    def active(self) -> bool:
        """Whether it waits."""
        return any(label in self.agent.active for label in self.waits_in)

    @property
    def done(self) -> bool:
        """Whether it has waited, since what is around it began."""
        return not self.active and self._ended > (self.parent._began if self.parent is not None else 0)


class CompositeBehaviour(Behaviour):
    """A behaviour with others in it."""

    def __init__(self, agent: JadeLikeAgent) -> None:
        super().__init__(agent)
        self.wakers: tuple[WakerBehaviour, ...] = ()
        self._kinds: list[type[Behaviour]] = []
        self._registered: list[_Registered] = []

    def add_sub_behaviour(self, kind: type[Behaviour]) -> None:
        """One more behaviour is in it, behind the others."""
        self._kinds.append(kind)

    def register_transition(
        self,
        source: type[Behaviour] | str,
        target: type[Behaviour] | str,
        text: str = "",
        *wakers: type[WakerBehaviour],
        into: tuple[str, ...] = (),
    ) -> None:
        """From here it continues there when `text` says so; `wakers` are the times in it.

        A target that is parallel may begin at the states `into` which it leads, given by their labels.
        """
        self._registered.append((source, target, text, wakers, into))

    def register_default_transition(
        self,
        source: type[Behaviour] | str,
        target: type[Behaviour] | str,
        text: str = "",
        *,
        into: tuple[str, ...] = (),
    ) -> None:
        """From here it continues there when the source is done and nothing else is open; `text` says what is
        done on the way."""
        self.register_transition(source, target, text, into=into)

    def register_action(
        self, source: type[Behaviour] | str, text: str, *wakers: type[WakerBehaviour]
    ) -> None:
        """While the source is active (`on`), or when it is left (`exit`), something is done."""
        self._registered.append((source, None, text, wakers, ()))

    @property
    def current(self) -> Behaviour | None:
        """The first of what is in it that is active."""
        return next((item for item in self._sub if item.active), None)

    @property
    def transitions(self) -> tuple[Way, ...]:
        registered = [self._way(item) for item in self._registered]
        pairs = {(way.source, way.target) for way in registered}
        return (*(Way(*pair) for pair in self._implied() if pair not in pairs), *registered)

    def _way(self, item: _Registered) -> Way:
        source, target, text, _, into = item
        label = self._label(source)
        return Way(label, label if target is None else self._label(target), text, target is None, into)

    def _label(self, what: type[Behaviour] | str) -> str:
        if not isinstance(what, str):
            return what.states[0]
        kind = _POINTS.get(what)
        return what if kind is None else self._point(self.states[-1], kind) or what


class SequentialBehaviour(CompositeBehaviour):
    """Its behaviours are done one after the other, then it is done.

    A transition that is registered between two of them takes the place of their mere succession.
    """

    def _implied(self) -> Iterator[tuple[str, str]]:
        yield from super()._implied()
        yield from self._between(self.states[-1], [kind.states[0] for kind in self._kinds])


class CyclicBehaviour(CompositeBehaviour):
    """What is in it is done again and again: it is never done."""

    def _implied(self) -> Iterator[tuple[str, str]]:
        yield from super()._implied()
        labels = [kind.states[0] for kind in self._kinds]
        yield from self._between(self.states[-1], labels)
        yield from ((label, label) for label in labels)


class TickerBehaviour(CompositeBehaviour):
    """Something that is done once a period: an activity with a pace, or what is in it."""

    period: ClassVar[int] = 0
    """In ns, from start to start."""


class FSMBehaviour(CompositeBehaviour):
    """Its behaviours are states; the transitions say which one is next."""

    def register_state(self, kind: type[Behaviour]) -> None:
        """One more of its states."""
        self.add_sub_behaviour(kind)


class ParallelBehaviour(CompositeBehaviour):
    """Its behaviours are done at the same time; it is done when all of them are."""

    when: ClassVar[str] = ALL


class _Window:
    """The directory as behaviours see it."""

    def __init__(self, shell: Host) -> None:
        self._shell = shell

    @property
    def directory(self) -> Directory:
        return self._shell.conversations.directory

    def do(self, doing: Offer | Withdraw) -> None:
        wanted = isinstance(doing, Withdraw) or doing.anew
        self._shell.requests.check_registered(wanted)
        self._shell.requests.register(doing)


class JadeLikeAgent:
    """An agent with behaviours: what it offers, and what it does. It has the methods of JADE's `Agent`.

    The generated subclass says which step class it shows; a subclass of that, in the folder of activities,
    says in `setup` which behaviours are the user's own. Those of the tree that it uses are views; those
    that it adds act.
    """

    main: ClassVar[type[Behaviour]] = Behaviour
    """The outermost behaviour."""
    services: ClassVar[tuple[Service, ...]] = ()
    """What the directory says that it offers: to be the participants that it plays."""
    own: ClassVar[str] = ""
    """The name of the user's class, which is found as an activity is."""
    _shape: ClassVar[Shape]

    def __init_subclass__(cls, step: type[Chart] | None = None) -> None:
        if step is not None:
            step.AGENT = cls
            cls._shape = Shape(step.PLAN)

    def __init__(self, shell: Host) -> None:
        self._shell = shell
        self.plan = shell.plan
        self.behaviours: tuple[Behaviour, ...] = ()
        """All of them, in document order, with the wakers behind what they are in."""
        self._following = Following(self._shape)
        self._began = False
        self._over = False
        self._count = 0
        self._since: dict[str, int] = {}
        self._kinds: dict[type[Behaviour], type[Behaviour]] = {}
        self._added = BehaviourScheduler(shell, self)
        self._parts: dict[str, Behaviour] = {}
        """What stands for a participant, by the labels of its states."""
        self._told: dict[str, str | None] = {}
        """The conversation of each branch in which all responses were told last."""
        self._known: dict[str, tuple[str | None, frozenset[Identity]]] = {}
        """For each branch, its conversation and what was heard in it when `news` was asked last."""
        self._at: dict[str, list[Behaviour]] = {}
        """What starts and ends with each state: its behaviour, and those that wait in it."""
        self._wakers: dict[int, list[WakerBehaviour]] = {}
        """What wakes a transition, by its number."""
        self._try(type(self).__name__, "", self.setup, "setup")
        self._grow()

    # ---- for the user --------------------------------------------------------------------------

    def setup(self) -> None:
        """Called before the agent's first step; to be overridden."""

    def take_over(self, before: JadeLikeAgent) -> None:
        """Called after `setup` when the agent continues after a hot swap; `before` is its object until then.

        To be overridden, to keep what an attribute has.
        """

    def take_down(self) -> None:
        """Called when the agent has ended in any way; to be overridden."""

    def use(self, *kinds: type[Behaviour]) -> None:
        """Have these classes in the place of the generated ones that they are subclasses of. For `setup`.

        Raises:
            TypeError: one is not a subclass of a behaviour of this agent, or says itself what is in it; two
                are for the same one.
        """
        for kind in kinds:
            if issubclass(kind, added.Behaviour):
                raise TypeError(f"{kind.__name__} runs beside the tree: add_behaviour({kind.__name__}())")
            home = self.main.__module__
            bases = (item for item in kind.__mro__ if item.__module__ == home)
            base = next((item for item in bases if issubclass(item, Behaviour)), None)
            if base is None or base is kind:
                raise TypeError(
                    f"{kind.__name__} is not a subclass of a behaviour of {self.plan.name}: what the agent"
                    f" does stands in {self.plan.source}"
                )
            self._check_callbacks(kind, base)
            if kind.build is not base.build:
                raise TypeError(
                    f"{kind.__name__} overrides build: what is in it stands in {self.plan.source}"
                )
            other = self._kinds.get(base)
            if other is not None:
                raise TypeError(f"{kind.__name__} and {other.__name__} are both for {base.__name__}")
            self._kinds[base] = kind

    def add_behaviour(self, behaviour: added.Behaviour) -> None:
        """Run a behaviour beside the statechart, from the end of this step on.

        Raises:
            TypeError: it is not an object of a behaviour of `aseme_dsl.runtime.jade`, runs already, or lacks
                something; the text says what.
        """
        kind = behaviour if isinstance(behaviour, type) else type(behaviour)
        if issubclass(kind, Behaviour):
            raise TypeError(f"{kind.__name__} is a view of a state: use({kind.__name__}) in setup")
        if isinstance(behaviour, type):
            raise TypeError(f"{kind.__name__} is a class: add_behaviour({kind.__name__}())")
        self._added.add(behaviour)

    def remove_behaviour(self, behaviour: added.Behaviour) -> None:
        """Run a behaviour no more; its `on_end` is not called. Raises LookupError if it does not run."""
        self._added.remove(behaviour)

    @property
    def added_behaviours(self) -> tuple[added.Behaviour, ...]:
        """What was added and has not ended."""
        return self._added.roots

    def receive(self, template: MessageTemplate | None = None) -> ACLMessage | None:
        """Take the oldest message outside of every protocol that waits and matches, or None."""
        return self._added.receive(template)

    def send(self, message: ACLMessage) -> ACLMessage:
        """Send a message outside of every protocol; gives it as it was sent.

        Raises:
            LookupError: it belongs to a protocol of the system, whose participants alone send it.
            ValueError: it has no receiver.
        """
        return self._added.send(message)

    @property
    def directory(self) -> AgentDirectory:
        """Which agents there are, and what each offers."""
        return AgentDirectory(_Window(self._shell))

    def raise_event(self, name: str) -> None:
        """Raise an event: transitions that wait for it see it in the agent's next step."""
        self._raise_event(name, type(self).__name__, ROOT)

    def get_variable(self, name: str) -> Any:
        """A variable of the role. Raises LookupError if there is none."""
        return self._variable(name, ROOT)

    def set_variable(self, name: str, value: object) -> None:
        """Write a variable of the role. Raises LookupError if there is none, TypeError for another type."""
        self._set_variable(name, value, type(self).__name__, ROOT)

    @property
    def name(self) -> str:
        """The agent's name in its team."""
        return self._shell.name

    @property
    def now(self) -> int:
        """The time of the run, in ns."""
        return self._shell.driver.clock.now()

    @property
    def active(self) -> Set[str]:
        """The labels of the active states."""
        return self._following.active

    def is_complete(self, label: str) -> bool:
        """Whether an active state has done what it does."""
        running = self._shell.chart.RUNNING.get(label)
        if running is not None:
            leaf, _, number = running
            return bool(getattr(self._shell.chart, leaf) == number + 1)
        return self._following.is_complete(label)

    def behaviour(self, kind: type[Behaviour]) -> Behaviour:
        """The behaviour of a class, or of a subclass of it. Raises LookupError if there is none."""
        for item in self.behaviours:
            if isinstance(item, kind):
                return item
        raise LookupError(f"{self.plan.name} has no behaviour {kind.__name__}")

    def log(self, behaviour: Behaviour, text: str) -> None:
        """Write a line of a behaviour into the trace."""
        shell = self._shell
        shell.trace.write(
            "log", self.now, agent=shell.name, activity=behaviour.name, label=behaviour.label, text=text
        )

    def _check_callbacks(self, kind: type[Behaviour], base: type[Behaviour]) -> None:
        """Raises TypeError for a `handle_…` or `prepare_…` that nothing would call."""
        names = {name for name in dir(kind) if name.startswith(_CALLED) and not hasattr(base, name)}
        if not names:
            return
        if not kind.participant:
            raise TypeError(
                f"{kind.__name__} has {sorted(names)[0]}, and {base.__name__} is not a participant's part"
            )
        branches = [item for item in self.plan.branches if item.label in kind.states]
        receives = [pair for item in branches for pair in item.receives]
        known = fipa_callbacks.methods_of(kind.protocol, kind.participant, receives)
        wrong = next((name for name in sorted(names) if name not in known), None)
        if wrong is not None:
            raise TypeError(
                f"{kind.__name__} has {wrong}, which nothing calls: {kind.protocol}.{kind.participant} has"
                f" {', '.join(known)}"
            )
        table = fipa_callbacks.CALLBACKS.get((kind.protocol, kind.participant), {})
        inside = {
            state.activity
            for item in branches
            for state in self.plan.states
            if is_in(state.label, item.label)
        }
        for activity, callback in table.items():
            if callback.method in names and not inside & {
                name for name, other in table.items() if other.method == callback.method
            }:
                raise TypeError(
                    f"{kind.__name__} has {callback.method}, which nothing calls: another activity stands for"
                    f" {activity}"
                )
            if callback.method in names and activity in inside and self._shell.code.has_code(activity):
                text = f"{callback.method} of {kind.__name__} is not called: {activity} has code"
                self._shell.trace.fault(self.now, self._shell.name, text, kind.at)

    # ---- for its behaviours --------------------------------------------------------------------

    def _prepare(self, message: object, by: Behaviour) -> None:
        if isinstance(message, type) or not is_dataclass(message):
            raise TypeError(f"what is prepared is a message, not {message!r}")
        branch = self.plan.branch_of(by.states[-1])
        self._shell.requests.prepared.add(branch, by.states[-1], type(message).__name__, message)

    def _heard(self, by: Behaviour) -> tuple[AgentMessage, ...]:
        branch = self.plan.branch_of(by.states[-1])
        return () if branch is None else self._shell.conversations.taken_by(self._shell, branch)

    def _default_of(self, message: str) -> object:
        return self._shell.kinds[message]()

    def _tells_responses(self, by: Behaviour) -> bool:
        branch = self.plan.branch_of(by.states[-1]) or ""
        conversation = self._shell.conversations.place(self._shell, branch)[0]
        if self._told.get(branch) == conversation:
            return False
        self._told[branch] = conversation
        return True

    def _news(self, by: Behaviour) -> tuple[AgentMessage, ...]:
        branch = self.plan.branch_of(by.states[-1]) or ""
        conversation, heard = self._shell.conversations.place(self._shell, branch)[0], self._heard(by)
        before, known = self._known.get(branch, (None, frozenset()))
        self._known[branch] = conversation, frozenset(item.identity for item in heard)
        return tuple(item for item in heard if before != conversation or item.identity not in known)

    def _variable(self, name: str, label: str) -> object:
        return self._shell.chart.variable(self.plan.variable_of(name, label).name)

    def _set_variable(self, name: str, value: object, by: str, label: str) -> None:
        shell, variable = self._shell, self.plan.variable_of(name, label)
        if not fits(variable.type, value):
            raise TypeError(f"variable {name} is a {variable.type}, not {value!r}")
        check_variable(variable, value)
        identity = shell.identity()
        shell.trace.write(
            "variable",
            self.now,
            agent=shell.name,
            sequence=identity[1],
            variable=variable.name,
            value=to_json(value),
            activity=by,
            label=label,
        )
        shell.post(identity, Written(variable.name, tuple(value) if isinstance(value, list) else value))

    def _raise_event(self, name: str, by: str, label: str) -> None:
        shell, identity = self._shell, self._shell.identity()
        shell.trace.write(
            "event", self.now, agent=shell.name, sequence=identity[1], event=name, activity=by, label=label
        )
        shell.post(identity, Happened(name))

    # ---- for the shell -------------------------------------------------------------------------

    def take_note(self, branch: str, mail: AgentMessage) -> None:
        """A participant, by its branch, has taken a message."""
        item = self._part(branch)
        if item is None:
            return
        name = f"handle_{mail.performative}"
        method = getattr(item, name, None)
        if method is not None and not fipa_callbacks.is_activity(item.protocol, item.participant, name):
            self._try(item.name, item.at, lambda: fipa_callbacks.check_nothing(method(mail), name), name)
        is_answer = mail.performative in (*fipa_callbacks.RESPONSES, *fipa_callbacks.RESULTS)
        if is_answer and (item.protocol, item.participant) in fipa_callbacks.ANSWERED_ONCE:
            self._tell_responses(item, mail)

    def _tell_responses(self, item: Behaviour, mail: AgentMessage) -> None:
        """All responses have come: the only agent that was asked has answered."""
        name = "handle_all_responses"
        method = getattr(item, name, None)
        if method is not None and item.tells_responses():
            responses = [mail] if mail.performative in fipa_callbacks.RESPONSES else []
            self._try(item.name, item.at, lambda: fipa_callbacks.check_nothing(method(responses), name), name)

    def callback(self, label: str) -> type[Executable] | None:
        """The activity of a state that is a method of its participant's behaviour, if it is one."""
        branch = self.plan.branch_of(label)
        item = self._part(branch) if branch is not None else None
        if item is None:
            return None
        table = fipa_callbacks.CALLBACKS.get((item.protocol, item.participant), {})
        found = table.get(self.plan.by_label[label].activity or "")
        if found is None or not any(hasattr(item, each.method) for each in table.values() if each.method):
            return None
        if found.method and not hasattr(item, found.method):
            if found.does in fipa_callbacks.NEEDED:
                return None
            if found.does in fipa_callbacks.OPTIONAL:
                found = fipa_callbacks.Callback("nothing")
        return fipa_callbacks.activity_of(found, item)

    def _part(self, branch: str) -> Behaviour | None:
        """The behaviour that stands for a participant, by its branch."""
        return self._parts.get(branch)

    def hear(self, identity: Identity, message: ACLMessage, refuse: Callable[[str], None]) -> None:
        """A message outside of every protocol has come."""
        self._added.hear(identity, message, refuse)

    def stop_behaviours(self, *, told: bool = True) -> None:
        """What was added acts no more; the trace may be told."""
        self._added.stop(told=told)

    def follow(self, outcome: Outcome) -> None:
        """The chart has made a step."""
        if not self._began:
            self._began = True
            self._enter(self._following.begin().entered)
        for numbers in outcome.taken:
            if self._wakers:
                self._wake(numbers)
            change = self._following.take(numbers)
            self._leave(change.left)
            self._enter(change.entered)
        if outcome.failure is not None:
            self.leave()

    def leave(self) -> None:
        """Everything is left."""
        self._leave(self._following.end().left)

    def over(self, left: bool) -> None:
        """The agent has ended, or leaves its plan; `left` says whether its chart has left everything."""
        if self._over:
            return
        self._over = True
        self.stop_behaviours(told=left)
        if left:
            self.leave()
        self._try(type(self).__name__, "", self.take_down, "take_down")

    def go_on(self, before: JadeLikeAgent | None, labels: Mapping[str, str]) -> None:
        """The chart stands where another one stood, whose states are called otherwise."""
        self._began = True
        if before is not None:
            before.stop_behaviours()
            self._try(type(self).__name__, "", lambda: self.take_over(before), "take_over")
        self._following.stand(self._shell.chart.configuration())
        self._count = 1
        for label in self._following.active:
            if label in self._since:
                self._since[label] = self.now
            for item in self._at.get(label, ()):
                item._began = 1
        if before is not None:
            for label, inside in before._following.kept.items():
                if label in labels:
                    kept = frozenset(labels[item] for item in inside if item in labels)
                    self._following.kept[labels[label]] = kept
            since = {labels[old]: at for old, at in before._since.items() if old in labels}
            self._since |= {label: at for label, at in since.items() if label in self._since}

    # ---- the tree ------------------------------------------------------------------------------

    def _grow(self) -> None:
        """Make all behaviours. Charts may be nested deep, so nothing here recurses."""
        found: list[Behaviour] = []
        # Of two that say the same, each has its wakers: which of them has which does not matter.
        numbers: dict[tuple[str, str, str], list[int]] = {}
        for number, item in enumerate(self.plan.transitions):
            if any(event[0] == "after" for event in item.events):
                numbers.setdefault((item.source, item.target, item.text), []).append(number)
        stack: list[tuple[type[Behaviour], Behaviour | None]] = [(self.main, None)]
        while stack:
            kind, parent = stack.pop()
            made = self._make(kind, parent)
            found.append(made)
            self._at.setdefault(made.label, []).insert(0, made)
            if isinstance(parent, CompositeBehaviour):
                parent._sub = (*parent._sub, made)
            if isinstance(made, CompositeBehaviour):
                found += self._grow_wakers(made, numbers)
                stack += [(inside, made) for inside in reversed(made._kinds)]
        self.behaviours = tuple(found)
        self._parts = {label: item for item in found if item.participant for label in item.states}

    def _grow_wakers(
        self, around: CompositeBehaviour, numbers: Mapping[tuple[str, str, str], list[int]]
    ) -> list[Behaviour]:
        found: list[WakerBehaviour] = []
        for item in around._registered:
            if not item[3]:
                continue
            way = around._way(item)
            number = numbers[way.source, way.target, way.text].pop(0)
            for kind in item[3]:
                made = self._make(kind, around)
                assert isinstance(made, WakerBehaviour)
                found.append(made)
                self._wakers.setdefault(number, []).append(made)
                for label in made.waits_in:
                    self._at.setdefault(label, []).append(made)
                    self._since[label] = 0
        around.wakers = tuple(found)
        return list(found)

    def _make(self, kind: type[Behaviour], parent: Behaviour | None) -> Behaviour:
        chosen = self._kinds.get(kind, kind)
        made: Behaviour | None = None
        if chosen is not kind:
            made = self._try(chosen.__name__, kind.at, lambda: _built(chosen, self), "__init__")
        if made is None:
            made = _built(kind, self)
        made.parent = parent
        return made

    # ---- what happens --------------------------------------------------------------------------

    def _enter(self, labels: Sequence[str]) -> None:
        for label in labels:
            if label in self._since:
                self._since[label] = self.now
            for item in self._at.get(label, ()):
                self._count += 1
                item._began = self._count
                if type(item).on_start is not Behaviour.on_start:
                    self._try(item.name, item.at, item.on_start, "on_start")

    def _leave(self, labels: Sequence[str]) -> None:
        for label in labels:
            for item in reversed(self._at.get(label, ())):
                self._count += 1
                item._ended = self._count
                if type(item).on_end is not Behaviour.on_end:
                    self._try(item.name, item.at, item.on_end, "on_end")

    def _wake(self, numbers: Sequence[int]) -> None:
        """Tell those whose time is the reason why a transition is taken, or could have been."""
        for number in numbers:
            for item in self._wakers.get(number, ()):
                since = max((self._since[at] for at in item.waits_in if at in self.active), default=self.now)
                if self.now - since >= item.timeout and type(item).on_wake is not WakerBehaviour.on_wake:
                    self._try(item.name, item.at, item.on_wake, "on_wake")

    def _try(self, name: str, at: str, call: Callable[[], _T], what: str) -> _T | None:
        """Call something of the user's; what it raises becomes a fault."""
        try:
            return call()
        except Exception as error:
            frames = frames_of(error)
            place = f" ({frames[-1]['file']}:{frames[-1]['line']})" if frames else ""
            text = f"{what} of {name} raised {reason_of(error)}{place}"
            self._shell.trace.fault(self.now, self._shell.name, text, at)
            return None


def agent_class(step: type[Chart], find: ActivityFinder) -> type[JadeLikeAgent] | None:
    """The class that shows a chart: the user's own, else the generated one, if the chart is shown at all.

    Raises:
        ActivityError: the user's cannot be imported, or is none for this chart.
    """
    generated = cast("type[JadeLikeAgent] | None", step.AGENT)
    own = find(generated.own) if generated is not None and generated.own else None
    if generated is None or own is None:
        return generated
    if not issubclass(own, generated):
        raise ActivityError(
            f"{own.__name__} is not a subclass of {generated.__module__}.{generated.__name__}, which shows"
            f" {step.PLAN.name}"
        )
    return own


def _built(kind: type[Behaviour], agent: JadeLikeAgent) -> Behaviour:
    made = kind(agent)
    if getattr(made, "agent", None) is not agent:
        raise TypeError(f"{kind.__name__}.__init__ does not call that of its base")
    made.build()
    return made
