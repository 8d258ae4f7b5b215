"""Explored: a team whose every next move can be made, with the agents, bus and conversations of every run.

The statecharts are the generated ones. Only the surroundings are others than in a run: so what is found is
what runs.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterator, Mapping, Sequence
from dataclasses import field
from functools import partial

from aseme_dsl.proofs.explore.ages import (
    Passing,
    asks_for_history,
    passing,
    pauses,
    settle_timers,
    thresholds_of,
)
from aseme_dsl.proofs.explore.alone import Alone, Sent, fixed_in, measured, reads_of
from aseme_dsl.proofs.explore.coming import Coming
from aseme_dsl.proofs.explore.deciding.acting import Acting, Free
from aseme_dsl.proofs.explore.deciding.choosing import Choices
from aseme_dsl.proofs.explore.deciding.joining import Joining, end_of, name_of
from aseme_dsl.proofs.explore.deciding.later import Contents, Later
from aseme_dsl.proofs.explore.deciding.order import Order
from aseme_dsl.proofs.explore.deciding.others import Others
from aseme_dsl.proofs.explore.deciding.outcomes import Outcomes
from aseme_dsl.proofs.explore.deciding.staging import (
    OPEN,
    StandsFor,
    asked_in,
    events,
    lists_of,
    settled,
    staged,
)
from aseme_dsl.proofs.explore.deciding.values import Condition, Values
from aseme_dsl.proofs.explore.memory import Memory, Picture
from aseme_dsl.proofs.explore.needed import Asked, Needed, groups_in, needed_for
from aseme_dsl.proofs.explore.on_the_way import Came, come, letter_of, sample_of
from aseme_dsl.proofs.explore.reducing.alike import Alike
from aseme_dsl.proofs.explore.reducing.spent import Spent
from aseme_dsl.proofs.explore.reducing.steady import Steady
from aseme_dsl.proofs.explore.reducing.symmetry import Symmetry, groups_of
from aseme_dsl.proofs.explore.relevant import Relevant
from aseme_dsl.proofs.explore.surroundings import NOW, Still, Underway, Ways
from aseme_dsl.proofs.explore.team_layout import layout_of
from aseme_dsl.proofs.timed.stamp import Mark, Stamp, Window, marked, stamp, standing, window
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.activity.execution import Execution
from aseme_dsl.runtime.activity.executions import _Node
from aseme_dsl.runtime.agent.agent import Agent
from aseme_dsl.runtime.channel.bus import Bus
from aseme_dsl.runtime.chart.chart import Chart
from aseme_dsl.runtime.chart.inputs import LOST, AgentMessage, Sample
from aseme_dsl.runtime.chart.plan import Plan
from aseme_dsl.runtime.conversation.conversation import Conversations
from aseme_dsl.runtime.conversation.directory import Entry
from aseme_dsl.runtime.conversation.participation import Desk
from aseme_dsl.runtime.message.acl import NOT_UNDERSTOOD, AclMessage
from aseme_dsl.runtime.time.clock import shown
from aseme_dsl.runtime.trace.trace import Listener, Trace
from aseme_dsl.runtime.version.loading import Loaded

SETTLES = 1000
"""A team that makes so many steps at one moment goes round in circles."""

FAILS = "it fails"
"""Why an activity fails here."""


class Circling(Exception):
    """Agents step again and again at one moment."""


@dataclass(frozen=True, slots=True)
class Assumed:
    """What the surroundings may do.

    `loses`: data and what goes by radio may be lost. `crashes`: so many of the agents, at most, each given by
    their names, may crash. `fails`: these activities may fail.
    """

    loses: bool = False
    crashes: tuple[tuple[int, frozenset[str]], ...] = ()
    fails: frozenset[str] = frozenset()
    times: tuple[str, ...] = ()
    """What is assumed of how long something takes, as it is written."""
    delay: tuple[int, int] | None = None
    """How long a message is on its way (ns), if that is assumed."""
    takes: Mapping[str, tuple[int, int]] = field(default_factory=dict)
    """How long activities take (ns), of which that is assumed."""
    has: Mapping[str, Mapping[str, Mapping[tuple[str, ...], object]]] = field(default_factory=dict)
    """What members of messages hold at agents, by agent and channel, as far as that is assumed."""
    held: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    """The same as it is written, by agent."""
    contradiction: str = ""
    """Why the assumptions cannot all be true, if they cannot: then there is no run at all."""


@dataclass(frozen=True, slots=True)
class Move:
    """Something that may happen next. Two moves are of one `kind` if fairness takes them for the same."""

    kind: tuple[str, ...]
    text: str
    do: Callable[[], None]
    agent: str
    """Who moves."""
    is_fair: bool = True
    """Whether it happens some time, if it can all the time."""
    passes: bool = False
    """Whether time passes."""
    window: Window | None = None
    """When it happens, where that is not at any time."""
    is_idle: bool = False
    """Whether another move has all of its outcomes but one, in which it leads back."""


@dataclass(frozen=True, slots=True)
class Letter:
    """An agent message that waits at its receiver."""

    receiver: str
    sender: str
    number: int
    performative: str
    message: str


class Explored:
    """A team between two moves."""

    def __init__(
        self,
        loaded: Loaded,
        team: Sequence[tuple[str, str]],
        assumed: Assumed,
        listeners: Sequence[Listener] = (),
        further: Sequence[object] = (),
        layout: tuple[Mapping[type, tuple[str, ...]], Mapping[type, frozenset[str]]] = ({}, {}),
        kept: frozenset[str] = frozenset(),
        told: frozenset[str] = frozenset(),
        asked: Asked | None = None,
        with_times: bool = False,
        alone: Alone | None = None,
        conditions: Sequence[Condition] = (),
        numbers: Sequence[float] | None = (),
        still: frozenset[str] = frozenset(),
        others: frozenset[str] = frozenset(),
        group: int | None = None,
        apart: Sequence[Needed] = (),
    ) -> None:
        """`listeners` are given the lines of a trace. `further` objects belong to the state of the team;
        `layout` has the parts of these, and what of those is not keyed (see `Layout`). They ask for the
        variables and timers in `kept`, for what is in messages of the types `told`, and for `conditions`.
        What does not matter to the question that is `asked`, if there is one, does not move. `with_times`,
        each move says when it may happen, counted from those before; else time is not measured. `alone`,
        there is one agent, and it says what comes to that. Where a few numbers do not stand for all, these
        `numbers` are tried, too; None: there is one that may be any, and nothing can be retraced.
        Agents that stand `still` begin, and make no move after that. It is not looked at what `others` do:
        anything may come of them (see `Others`). With `group`, there is one agent, and groups of its regions
        that do not depend on each other are explored one by one; this is the one of this number. `apart` are
        all of them, if they are known."""
        self.choices = Choices()
        self.still = still
        self._assumed = assumed
        self.driver = driver = Still()
        self.trace = trace = Trace(None, listeners)
        trace.now = driver.clock.now
        self.ways = Ways(now=driver.clock.now)
        self._with_times = with_times
        self.moved = 0
        """How many moves were made; with times, the number of the present one."""
        self.came: list[Came] = []
        """What has come in the present move from other agents, on channels."""
        self.joined: list[Underway] = []
        """What of that has come with something else."""
        self.alone = alone
        self.sent: list[Sent] = []
        """When that was sent which has come in the present move, if it was not then."""
        self.stepped: Callable[[], None] = lambda: None
        """Called after each step of an agent."""
        self.has_crashed: Callable[[str], None] = lambda name: None
        """Called when an agent has crashed."""
        self.windows: list[Window] = []
        """What has turned out in the present move about when it is made."""
        if with_times:
            driver.clock.moment = stamp(NOW, 0)
        self.bus = Bus(driver, trace)
        self.conversations = Conversations(driver, trace, system=loaded.name)
        self.bus.links = self.conversations.links = self.ways
        self._roles = dict(team)
        names = [name for name, _ in team]
        plans = [loaded.charts[role].PLAN for role in dict.fromkeys(role for _, role in team)]
        roles = {role for name, role in team if name not in others}
        looked_at = [plan for plan in plans if plan.name in roles]
        self._modules = tuple((plan.name, module) for plan in looked_at for module in plan.modules)
        has = {name: assumed.has.get(name, {}) if alone is None else alone.fixed for name in names}
        known = [
            (channel, has[name].get(channel, {}))
            for name, role in team
            if name not in others
            for channel in reads_of(loaded.charts[role].PLAN)
        ]
        self.values = Values(
            looked_at,
            loaded.types,
            names,
            {**fixed_in(known), **settled(plans, names)},
            conditions=conditions,
            numbers=numbers,
            is_free=bool(others) or numbers is None,
        )
        self._outcomes = Outcomes(self.choices)
        self.order = Order(self.choices)
        self.order.asks = lambda: self._is_moving
        self._is_moving = False
        known_outside = told if alone is None else frozenset(loaded.messages)
        self.later = Later(self.choices, self.values, self._outcomes, self.order, known_outside)
        contents = Contents(self.choices, self.values, self.later, loaded.messages, told, self.order)
        is_asked = asked_in(looked_at, told)
        self.others = Others(self.conversations, self.choices, contents) if others else None
        """What others may do to the only agent that is explored, if there are any."""
        self._acting = acting = Acting(
            *(self.choices, self.values, contents, plans, self._is_new, self._outcomes, is_asked, kept),
            self.order,
            self._stands,
        )
        acting.publishes = alone is None
        charts = {
            name: staged(
                loaded.charts[role],
                partial(acting.decide, role),
                acting.draw,
                partial(self._look_for, name),
                with_times,
                self._outcomes.holds,
                None if self.others is None or name in others else self.others.methods,
            )
            for name, role in team
        }
        self._talks = any(plan.branches for plan in plans)
        self.crashed: list[str] = []
        self.late: set[str] = set()
        """The agents in which a deadline has passed."""
        self.spurned: set[tuple[str, str]] = set()
        """Agents, with whose messages that crossed those of another that one has done nothing."""
        self._touched: set[str] = set()
        """The agents that may have been changed in the present move."""
        self.arriving: Underway | None = None
        """What comes in the present move."""
        agents = [self._agent(name, charts[name], loaded) for name in names]
        self.agents = tuple(agent for agent in agents if agent.name not in others)
        driver.agents = self.agents
        self._of_others = frozenset[str]()
        """The channels on which something of others may come."""
        if self.others is not None:
            self.ways.deaf = others
            (agent,) = self.agents
            self.others.meet(agent, [other for other in agents if other.name in others])
            self._of_others = self.others.channels(self.bus)
        self._messages_of_others = frozenset(channel.rpartition(".")[2] for channel in self._of_others)
        self.coming = coming = Coming(
            self.agents,
            self.bus,
            self.choices,
            contents,
            self.later,
            [channel for _, module in self._modules for channel in module.writes],
            told,
            is_asked,
            has,
            alone,
            with_times,
            self._of_others,
        )
        if self._of_others:
            self._outcomes.is_of_others = self._decided_by_others
        self.order.is_of_others = bool(self._of_others)
        self._steady = Steady(plans, coming, acting, with_times or alone is not None)
        self._events = {plan.name: events(plan) for plan in plans}
        self._joining = Joining(
            *(plans, self._events, self.ways, coming, self.bus, self.choices, self._arrive_with)
        )
        self._ages = {plan.name: thresholds_of(plan)[0] for plan in plans}
        own = {agent.role: coming.own(agent) for agent in self.agents}
        if asked is not None:
            coming.needed = needed_for(plans, asked, assumed.fails, coming.reaches, own)
        self.apart = tuple(apart)
        """The groups of regions that do not meet, if there are some."""
        if group is not None and not self.apart:
            (plan,) = (agent.plan for agent in self.agents)
            needed = partial(
                needed_for,
                [plan],
                fails=assumed.fails,
                reaches=self._reaches_itself,
                own=own,
                is_alone=True,
            )
            self.apart = groups_in(plan, needed)
        if group is not None and self.apart:
            coming.needed = self.apart[group]
        self.needed = coming.needed
        """The regions that matter, if not all do."""
        if self.others is not None:
            self.others.matters = self.matters
        self.ways.taken = self._is_taken
        self._relevant = {plan.name: Relevant(plan, kept) for plan in plans}
        self._alike = {plan.name: Alike(plan, kept) for plan in plans}
        self.spent = Spent(plans)
        self.ways.mail = self.spent.sent
        self._named = {agent.name: agent for agent in self.agents}
        sends = any(info.sends or info.moves for plan in plans for info in plan.branches)
        self.judged = {"orphan", "race"} if sends else set[str]()
        """What is still asked of messages that nothing takes: whether one is an orphan, and whether two
        agents have sent past each other."""
        self.hears = False
        """Whether something else asks for each message that is sent, or not taken."""
        protocols = {info.protocol for plan in plans for info in plan.branches}
        self.memory = Memory(
            [
                *([agent] for agent in self.agents),
                [
                    self.conversations._members,
                    self.conversations._sending._choosing,
                    self.conversations.directory,
                    *(self.bus, self.ways, driver, self.crashed, self.late, self.spurned, self.later.decided),
                    *(self.order.known, *(() if self.others is None else (self.others.paused,)), *further),
                ],
            ],
            layout_of(loaded, *layout),
            [*names, "input"],
            protocols,
            self.later.said,
        )
        self._symmetry: Symmetry | None = None
        if self.others is not None and not (kept or told or conditions or further):
            (agent,) = self.agents
            if alike := groups_of(agent, self.others.agents, loaded.messages, has[agent.name]):
                self.memory.watch(alike, (Desk, Entry))
                self._symmetry = Symmetry(agent, alike, self.values, self.memory.mentions)
                self.others.differ = self._symmetry.others

    def _agent(self, name: str, kind: type[Chart], loaded: Loaded) -> Agent:
        chart = kind(name)
        agent = Agent(
            name, chart, lambda activity: StandsFor, self.driver, self.bus, self.conversations, self.trace
        )
        self.bus.join(agent)
        self.conversations.join(agent)
        agent.kinds = loaded.messages
        chart.stand_in(
            {item[0]: self._acting.function(chart.PLAN.name, name, item) for item in chart.PLAN.functions}
        )
        agent.requests.prepared = Free(self._acting, name)
        return agent

    def _is_taken(self, receiver: str, channel: str) -> bool:
        """Whether what comes on a channel may make a difference to a receiver."""
        if receiver in self.still:
            return False
        return self.needed is None or channel in self.needed.reads[self._roles[receiver]]

    @property
    def left_out(self) -> str:
        """What of the team is not explored; empty if nothing is."""
        for agent in self.agents:
            if not thresholds_of(agent.plan)[1]:
                return f"{agent.role} does more with an age than compare it with a constant"
            if lists := lists_of(agent.plan):
                return f"nothing is tried for the list {lists[0]}, which activities may write"
            if asks_for_history(agent.plan):
                return f"{agent.role} asks for the history of a channel"
        if self.others is not None and (why := self.others.left_out):
            return why
        for role, module in self._modules:
            if module.variables:
                return f"the module {module.name} of {role} writes variables"
        return ""

    def _reaches_itself(self, writer: str, reader: str, channel: str) -> bool:
        """Whether it matters to a role what it publishes itself: not where others publish, too."""
        return channel not in self._of_others and self.coming.reaches(writer, reader, channel)

    def _decided_by_others(self, question: Hashable) -> bool:
        """Whether what others have published decides a question, or may be given to a function that does."""
        match question:
            case ("member", _, str() as message, _):
                return message in self._messages_of_others
            case ("function", *_):
                return True
            case _:
                return False

    def is_own(self, kind: tuple[str, ...]) -> bool:
        """Whether an agent makes a move of this kind by itself, and nothing of others has come in it."""
        if self.others is None:
            return True
        if self.others.has_come or not self._of_others.isdisjoint(self._joining.came):
            return False
        match kind:
            case ("other", *_):
                return False
            case ("input", agent):
                return self.coming.has_more_from_outside(agent)
            case ("input", _, channel) | ("time", _, "message" | "signal", channel):
                return channel not in self._of_others
            case _:
                return True

    def settle(self) -> None:
        """Get the agents ready for their first step."""
        self._touch("")
        for agent in self.agents:
            agent.chart.settle()

    def begin(self) -> bool:
        """Let all agents make their first step; whether that could be made in one way only.

        If not, the state before it has it as a move.
        """
        self.choices.begin()
        before = self.picture()
        self.coming.look()
        self.make(Move(("begin",), "", self._begin_all, ""))
        is_only = not self.choices.again()
        if not is_only:
            self.take_back(before)
        return is_only

    def _begin_all(self) -> None:
        for agent in self.agents:
            agent.begin()
            self.stepped()

    def _touch(self, name: str) -> None:
        """An agent may be changed in this move; an empty name: any of them."""
        for number, agent in enumerate(self.agents):
            if name in ("", agent.name):
                self._touched.add(agent.name)
                self.memory.touch(number)

    def _settle(self) -> None:
        """Let the agents step until nothing is left to do at this moment."""
        for _ in range(SETTLES):
            waiting = [agent for agent in self.agents if agent.intake]
            if not waiting:
                self._outcomes.mark()
                self.later.forgotten.clear()
                self._forget()
                self.later.settle()
                return
            for agent in waiting:
                self._touch(agent.name)
                agent.process(agent.take())
                self.stepped()
        raise Circling(", ".join(agent.name for agent in self.agents if agent.intake))

    def _forget(self) -> None:
        """Forget what makes no difference any more."""
        if self._talks:
            self._forget_talks()
        if self.others is not None:
            self.others.forget()
        for agent in self.agents:
            if agent.name not in self._touched:
                continue
            self.coming.forget(agent)
            settle_timers(agent.chart)
            if self.alone is not None:
                self.coming.forget_kept(agent, self._ages[agent.role])
            nodes = agent.executions._nodes
            paced = {label for label, *_ in pauses(agent)} if self._with_times else ()
            for label in [label for label, node in nodes.items() if _is_idle(node) and label not in paced]:
                del nodes[label]
            if agent.chart.started and not agent.over and not agent.down:
                self._relevant[agent.role].forget(agent.chart, OPEN)
                self._alike[agent.role].forget(agent.chart)

    def _forget_talks(self) -> None:
        desks = self.conversations._members.desks
        for desk in desks.values():
            self.spent.forget(desk)
        if not self.hears:
            self.spent.drop(self.ways, self._named, desks)
        if not self.judges:
            self.late.clear()
            self.spurned.clear()
            self.ways.uncross()
        elif "orphan" not in self.judged:
            self.late.clear()

    @property
    def judges(self) -> bool:
        """Whether it makes a difference now if an agent message is not taken. After a crash, it does not."""
        return self.hears or (bool(self.judged) and not self.crashed)

    def longest(self) -> int:
        """How many messages, at the most, are on their way from one agent to another that moves, or wait in
        line there from outside; of a topic, each counts twice."""
        weights = [
            sum(1 if item.kind == "mail" else 2 for item in items)
            for (_, receiver), items in self.ways.ways.items()
            if receiver not in self.still
        ]
        moving = (agent for agent in self.agents if agent.name not in self.still)
        return max((*weights, *(2 * self.coming.in_line(agent) for agent in moving)), default=0)

    def invitations(self, agent: Agent) -> list[AclMessage]:
        """The agent messages that wait for a participant of an agent to be entered or free."""
        return self.conversations._members.desks[agent.name].invitations.waiting()

    def letters(self) -> tuple[Letter, ...]:
        """The agent messages that wait to be taken, in an order that does not depend on their numbers."""
        found: list[Letter] = []
        for name, desk in self.conversations._members.desks.items():
            mail: list[AgentMessage | AclMessage] = []
            for _, place in sorted(desk.branches.items()):
                mail += [item for _, item in sorted(place.waiting.items(), key=repr)]
            mail += desk.invitations.waiting()
            for item in mail:
                if item.performative not in (NOT_UNDERSTOOD, LOST):
                    number = item.identity[1]
                    found.append(Letter(name, item.sender, number, item.performative, item.message))
        return tuple(found)

    def may_be_joined(self, conversation: str) -> bool:
        """Whether a message of a conversation is on its way, or an agent has still to join by one."""
        found = self.conversations._members.conversations.get(conversation)
        letters = (letter_of(item) for items in self.ways.ways.values() for item in items)
        return (found is not None and found.invitations > 0) or any(
            letter is not None and letter.conversation == conversation for letter in letters
        )

    def writers(self) -> Mapping[str, frozenset[str]]:
        """The agents that may publish on each channel."""
        return self.coming.writers()

    # ---- moves -------------------------------------------------------------------------------

    def picture(self) -> Picture:
        """What all holds now, without what was decided of messages that have been dropped."""
        found = self.memory.picture()
        if self.later.keep({number for section in found for name, number in section.names if not name}):
            self.memory.touch(-1)
            found = self.memory.picture()
        if self._symmetry is not None and self._symmetry.settle(self._fixed(found)):
            self.memory.touch(0)
            found = self.memory.picture()
        return found

    def _fixed(self, picture: Picture) -> frozenset[str]:
        """The names of agents that do not change places, as they stand elsewhere than in a chart."""
        assert self.others is not None
        texts = (value for value in self.later.decided.values.values() if isinstance(value, str))
        decided = {name for text in texts for name in self.memory.mentions(text)}
        return self.memory.mentioned(picture) | decided | self.others.busy

    def take_back(self, picture: Picture) -> None:
        self.memory.take_back(picture)

    def next_moment(self) -> None:
        """What is done from now on, is done in a move of its own, from which times are counted."""
        self.moved += 1
        self.driver.clock.moment = stamp(NOW, self.moved)

    def marks(self) -> Iterator[Mark]:
        """The moments from which something is counted that may still come."""
        found: list[tuple[str, int]] = []
        for execution in self.driver.running:
            if execution.activity in self._assumed.takes and self.matters(execution.agent, execution.label):
                found.append((f"end {execution.agent} {execution.label}", execution.started))
        for (sender, receiver), waiting in self.ways.ways.items():
            ages = self._ages[self._roles[receiver]]
            for number, item in enumerate(waiting):
                if self._on_the_way(item) is not None:
                    found.append((f"way {sender} {receiver} {number}", item.sent))
                sample = sample_of(item)
                if sample is not None and ages.get(item.what):
                    found.append((f"age {sender} {receiver} {number}", sample.time))
        found += [
            (f"timer {number}", timer.moment)
            for number, timer in enumerate(item for item in self.driver.timers if item.call is not None)
        ]
        found += [
            (f"pace {' '.join(map(str, key))}", held.last)
            for key, held in self.bus._held.items()
            if held.last is not None and NOW - held.last < (self.bus._rules[key[1]].every or 0)
        ]
        for agent in self.agents:
            if not (agent.over or agent.down):
                found += [
                    (f"{agent.name} {item.what} {item.name} {item.place}", item.since)
                    for item in passing(agent.chart, self._ages[agent.role])
                    if item.what != "state" or self.matters(agent.name, item.name)
                ]
        found += [
            (f"pause {agent.name} {label}", node.last_start)
            for agent in self.agents
            for label, node, _ in pauses(agent)
            if node.last_start is not None and self.matters(agent.name, label)
        ]
        for name, since in found:
            mark = marked(name, since)
            if mark is not None:
                yield mark

    def first(self, moves: Sequence[Move]) -> Move | None:
        """A move before which no other one needs to be made; None if there is no such one.

        That is an agent message that comes to an agent that has ended. Nothing takes it, and at most an
        answer is sent. All other moves do the same before it and after it: the agent makes no move, and
        others read nothing of it. Its answer is the last message on its way. What comes in between differs
        only in what is on the way to and from that agent. Nothing asks for that while nothing is judged. It
        has an end, as an answer is never answered.
        """
        if self.judges:
            return None
        return next(
            (move for move in moves if move.kind[0] == "arrive" and self._is_late_letter(move.kind)), None
        )

    def _is_late_letter(self, kind: tuple[str, ...]) -> bool:
        """Whether what arrives is an agent message for an agent that has ended."""
        _, sender, receiver, channel = kind
        if channel or not self._named[receiver].over:
            return False
        ordered = (item for item in self.ways.ways[sender, receiver] if not item.overtakes)
        return next(ordered).kind == "mail"

    def make(self, move: Move) -> None:
        """Make a move, by the choices that are next. Raises Circling."""
        self.arriving = None
        self.windows.clear()
        self.sent.clear()
        self.came.clear()
        self.joined.clear()
        self._joining.came.clear()
        self._touched.clear()
        self._outcomes.begin(is_quiet=move.is_idle)
        if self.others is not None:
            self.others.begin()
        if self._symmetry is not None:
            self._symmetry.begin(self._fixed(self.memory.picture()))
        self.coming.begin()
        self._is_moving = True
        try:
            self._touch(move.agent)
            move.do()
            self._join(move)
            self._settle()
            if self._with_times:
                self._begin_anew()
        finally:
            self._is_moving = False
            self.coming.end()

    def _join(self, move: Move) -> None:
        """Let more come at the same moment. What comes to an agent alone may be there at any time."""
        match move.kind:
            case ("begin",):
                for agent in self.agents if self.alone is None else ():
                    self._joining.begin(agent)
                return
            case ("input" | "event", name, what):
                pass
            case ("end", name, label):
                plan = self._named[name].plan
                what = end_of(plan.by_label[label].activity or "")
            case ("arrive", _, name, _) if self.arriving is not None:
                what = name_of(self.arriving)
            case _:
                return
        agent = self._named[name]
        if self.alone is None and not agent.over and not agent.down:
            self._joining.join(agent, what)

    def _begin_anew(self) -> None:
        """What has begun after a pause counts the next one from now."""
        for execution in self.driver.running:
            if isinstance(execution.started, Stamp) and execution.started.origin == self.moved:
                agent = next(item for item in self.agents if item.name == execution.agent)
                agent.executions._nodes[execution.label].last_start = execution.started

    def _look_for(self, agent: str, channel: str) -> None:
        self.coming.look_for(agent, channel)

    def _is_new(self, agent: Agent, channel: str) -> bool:
        return self.coming.is_new(agent, channel)

    def _stands(self, agent: Agent, channel: str) -> bool:
        return self.coming.stands(agent, channel)

    def moves(self) -> Iterator[Move]:
        """What may happen next."""
        self.coming.look()
        if not any(agent.chart.started for agent in self.agents):
            when = Window(0, 0, 0)
            yield Move(("begin",), "the agents begin", self._begin_all, "", window=when)
            return
        if self.others is not None:
            for item in self.others.moves():
                yield Move(item.kind, item.text, item.do, self.agents[0].name, is_fair=False)
            if self.others.paused[0]:
                return
        moves = (self._ends(), self._arrivals(), self._times(), self._crashes(), self._given())
        yield from (move for some in moves for move in some if move.agent not in self.still)

    def _ends(self) -> Iterator[Move]:
        for execution in self.driver.running:
            if not self.matters(execution.agent, execution.label):
                continue
            kind = ("end", execution.agent, execution.label)
            text = f"{execution.agent}: {execution.activity} ends"
            when = self._lasting(execution)
            end, is_idle = partial(self._end, execution), self._steady.is_idle(execution)
            if self._joining.joins(self._named[execution.agent], end_of(execution.activity)):
                is_idle = False  # what comes with its end is tried, too
            yield Move(kind, text, end, execution.agent, window=when, is_idle=is_idle)
            if execution.activity in self._assumed.fails:
                kind = ("fail", execution.agent, execution.label)
                text = f"{execution.agent}: {execution.activity} fails"
                fail = partial(self._fail, execution)
                yield Move(kind, text, fail, execution.agent, is_fair=False)
            if self._acting.acts(execution):
                kind = ("act", execution.agent, execution.label)
                text = f"{execution.agent}: {execution.activity} runs"
                yield Move(kind, text, partial(self._acting.act, execution), execution.agent, is_fair=False)

    def _lasting(self, execution: Execution) -> Window | None:
        """When an activity ends, if that is assumed."""
        takes = self.lasts(execution)
        return None if takes is None else window(execution.started, *takes)

    def lasts(self, execution: Execution) -> tuple[int, int | None] | None:
        """How long an activity takes (ns), if that is assumed."""
        return self._assumed.takes.get(execution.activity)

    def matters(self, agent: str, label: str) -> bool:
        """Whether a state of an agent matters to what is asked."""
        return self.needed is None or label in self.needed.states[self._roles[agent]]

    def _may_pass(self, agent: Agent, item: Passing) -> bool:
        """Whether it matters to what is asked that the time of something passes."""
        match item.what:
            case "state":
                return self.matters(agent.name, item.name)
            case "timer" if self.needed is not None:
                regions = self.needed.regions[agent.role]
                places = (place for place in item.place if isinstance(place, int))
                return any(agent.chart.REGIONS[place] in regions for place in places)
            case _:
                return True

    def written(self, execution: Execution, *, is_end: bool) -> tuple[str, ...]:
        """The variables that an activity writes when it runs or ends, as its agent calls them."""
        agent = next(item for item in self.agents if item.name == execution.agent)
        names = self._acting.written(agent, execution, is_end=is_end)
        return tuple(agent.plan.variable_of(name, execution.label).name for name in names)

    def _arrivals(self) -> Iterator[Move]:
        for (sender, receiver), waiting in self.ways.ways.items():
            if not waiting:
                continue
            held: set[str] = set()
            for item in waiting:
                is_sample = item.overtakes
                if not is_sample and "stream" in held:
                    continue
                if not is_sample:
                    held.add("stream")
                elif item.what in held:
                    continue
                text = f"{receiver} gets {_called(item)} of {sender}"
                kind = ("arrive", sender, receiver, item.what if is_sample else "")
                arrive = partial(self._arrive, receiver, waiting, item)
                yield Move(kind, text, arrive, receiver, window=self._on_the_way(item))
                if is_sample and self._assumed.loses:
                    yield Move(
                        ("lose", *kind[1:]),
                        f"{_called(item)} of {sender} to {receiver} is lost",
                        partial(waiting.remove, item),
                        receiver,
                        is_fair=False,
                    )
                    held.add(item.what)

    def _on_the_way(self, item: Underway) -> Window | None:
        """When a message comes, if that is assumed. The news of a loss takes any time."""
        delay = self.on_the_way(item)
        return None if delay is None else window(item.sent, *delay)

    def on_the_way(self, item: Underway) -> tuple[int, int | None] | None:
        """How long a message is on its way (ns), at the least and at the most, if that is assumed."""
        delay = self._assumed.delay
        if delay is None or (item.kind == "mail" and letter_of(item) is None):
            return None
        repeats = self._assumed.loses and not item.overtakes  # what is lost is sent again
        return delay[0], None if repeats else delay[1]

    def _times(self) -> Iterator[Move]:
        for timer in self.driver.timers:
            if timer.call is not None:
                when = window(timer.moment, 0, 0)
                yield Move(("timer",), "a pause is over", timer.ring, "", passes=True, window=when)
        for (name, channel, host), held in self.bus._held.items():
            every = self.bus._rules[channel].every
            last = held.last
            if every is not None and last is not None and not held.waiting and NOW - last < every:
                kind = ("pace", name, channel, host or "")
                text = f"{name} may publish on {channel} again"
                do = partial(setattr, held, "last", standing(last, NOW - every))
                when = window(last, every, every)
                yield Move(kind, text, do, "", passes=True, window=when)
        for agent in self.agents:
            if agent.over or agent.down:
                continue
            for label, node, every in pauses(agent) if self._with_times else ():
                if node.held is None and node.last_start is not None and self.matters(agent.name, label):
                    text = f"{agent.name}: {node.program.info.name} may begin again"
                    do = partial(setattr, node, "last_start", standing(node.last_start, NOW - every))
                    when = window(node.last_start, every, every)
                    yield Move(("pause", agent.name, label), text, do, agent.name, passes=True, window=when)
            for item in passing(agent.chart, self._ages[agent.role]):
                if not self._may_pass(agent, item):
                    continue
                kind = ("time", agent.name, item.what, item.name)
                text = f"{agent.name}: {_passed(agent.plan, item)}"
                do = partial(self._pass, agent, item.pass_)
                # What may be renewed at any moment was renewed long enough ago: it is exactly so old now.
                renews = item.what == "message" and self._is_new(agent, item.name)
                if renews and self._with_times and item.renew is not None:
                    do = partial(self._pass, agent, partial(self._renew, item.renew, item.duration))
                when = window(item.since, item.duration, None if renews else item.duration)
                yield Move(kind, text, do, agent.name, passes=True, window=when)

    def _given(self) -> Iterator[Move]:
        """What comes from outside: messages on channels on which no agent publishes, and events."""
        for agent in self.agents:
            if agent.over or agent.down:
                continue
            if self.coming.has_more(agent.name):
                kind = ("input", agent.name)
                yield Move(kind, f"{agent.name} gets new inputs", agent.begin, agent.name, is_fair=False)
            for channel in self.coming.inputs[agent.name]:
                if not self._is_new(agent, channel) and self.coming.may_change(agent, channel):
                    is_kept = self.alone is not None and channel in self.alone.kept
                    do = partial(self._give_kept if is_kept else self.coming.give, agent, channel)
                    yield Move(
                        ("input", agent.name, channel),
                        f"{agent.name} gets {channel}",
                        do,
                        agent.name,
                        is_fair=False,
                    )
            for event in self._events[agent.role]:
                do = partial(self.bus.give_event, agent, event)
                yield Move(
                    ("event", agent.name, event),
                    f"{agent.name}: {event} is raised",
                    do,
                    agent.name,
                    is_fair=False,
                )

    def _crashes(self) -> Iterator[Move]:
        for most, names in () if self.others is not None else self._assumed.crashes:
            if sum(name in names for name in self.crashed) >= most:
                continue
            for agent in self.agents:
                if agent.name in names and not agent.over and not agent.down:
                    yield Move(
                        ("crash", agent.name),
                        f"{agent.name} crashes",
                        partial(self._crash, agent),
                        agent.name,
                        is_fair=False,
                    )

    def _arrive(self, receiver: str, waiting: list[Underway], item: Underway) -> None:
        waiting.remove(item)
        self.arriving = item
        self._give(receiver, item)()

    def _arrive_with(self, receiver: str, waiting: list[Underway], item: Underway) -> None:
        """What is on its way comes at the same moment as something else."""
        waiting.remove(item)
        self.joined.append(item)
        if item.crosses:
            self.arriving = item
        if self._with_times and (when := self._on_the_way(item)) is not None:
            self.windows.append(when)
        self._give(receiver, item)()

    def _give(self, receiver: str, item: Underway) -> Callable[[], None]:
        """What gives a message, which may have become old on its way, to its receiver."""
        if self.bus._routes.measured(item.what, NOW) is not None:
            return item.give
        came = come(item, self._ages[self._roles[receiver]].get(item.what, ()), self.choices)
        self.came.append(came)
        if came.window is not None:
            self.windows.append(came.window)
        return came.give

    def _give_kept(self, agent: Agent, channel: str) -> None:
        """A message comes of which it matters when it was sent."""
        assert self.alone is not None
        rule = next((info for info in agent.plan.channels if info.name == channel), None)
        ages = self._ages[agent.role].get(channel, ())
        time, is_own, sent = measured(rule, self.alone, self.moved, ages, self.choices)
        if sent is not None:
            self.sent.append(sent)
        identity = agent.identity() if is_own else self.bus.outside()
        content = self.coming.content(agent, channel)
        agent.post(identity, Sample(channel, content, "input", time, identity))

    def _pass(self, agent: Agent, pass_: Callable[[], None]) -> None:
        pass_()
        if self._talks:
            self.late.add(agent.name)
        agent.begin()

    def _renew(self, renew: Callable[[int], None], age: int) -> None:
        """A message becomes so old in this move, counted from the last time that it was renewed."""
        renew(stamp(NOW - age, self.moved, -age))

    def _crash(self, agent: Agent) -> None:
        agent.crash()
        self.crashed.append(agent.name)
        self.has_crashed(agent.name)

    def _end(self, execution: Execution) -> None:
        self.driver.running.remove(execution)
        self._acting.end(execution)

    def _fail(self, execution: Execution) -> None:
        self.driver.running.remove(execution)
        execution.returned(RuntimeError(FAILS))


def _is_idle(node: _Node) -> bool:
    """Whether nothing runs in a state, nor is to run next."""
    return node.current is None and node.next is None and node.held is None and not (node.waits or node.made)


def _called(item: Underway) -> str:
    """What is on its way, for readers."""
    if item.kind != "mail":
        return item.what
    acl = letter_of(item)
    return "the news of a loss" if acl is None else f"{acl.performative} {acl.message}"


def _passed(plan: Plan, item: Passing) -> str:
    match item.what:
        case "state":
            return f"{shown(item.duration)} have passed in {plan.called(plan.by_label[item.name])}"
        case "timer":
            return f"timer {item.name} runs out"
        case _:
            return f"{item.name} is {shown(item.duration)} old"


__all__ = ["FAILS", "Assumed", "Circling", "Explored", "Letter", "Move"]
