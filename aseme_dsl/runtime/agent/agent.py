"""Agent: one ordered intake in front of a synchronous chart, and the hands that carry its effects out."""

from __future__ import annotations

import itertools
from collections import deque
from collections.abc import Callable, Iterable, Mapping

from aseme_dsl.runtime.activity.activities import ActivityFinder, Executable
from aseme_dsl.runtime.activity.execution import Execution
from aseme_dsl.runtime.activity.executions import Executions
from aseme_dsl.runtime.activity.modules import Modules
from aseme_dsl.runtime.activity.plan_code import PlanCode
from aseme_dsl.runtime.activity.returning import frames_of, reason_of
from aseme_dsl.runtime.agent.behaviours import JadeLikeAgent, agent_class
from aseme_dsl.runtime.agent.course import changed_states, cycle, place_of_failure
from aseme_dsl.runtime.agent.effects import Effects
from aseme_dsl.runtime.agent.overload import Overload
from aseme_dsl.runtime.agent.renewal import is_for_any_plan, renewed
from aseme_dsl.runtime.agent.requests import Requests
from aseme_dsl.runtime.agent.state_transfer import Carried
from aseme_dsl.runtime.agent.untakable import Untakable
from aseme_dsl.runtime.channel.bus import SELECT, Bus
from aseme_dsl.runtime.chart.board import QUEUE
from aseme_dsl.runtime.chart.chart import Chart
from aseme_dsl.runtime.chart.input_queue import Errand, Intake, Posted, Writer
from aseme_dsl.runtime.chart.inputs import (
    Addressed,
    AgentMessage,
    Effect,
    Identity,
    Input,
    Outcome,
    Publication,
    Sample,
    Sending,
    Settled,
)
from aseme_dsl.runtime.chart.plan import BranchInfo, Plan
from aseme_dsl.runtime.conversation.conversation import Conversations
from aseme_dsl.runtime.message.convert import Messages, converted
from aseme_dsl.runtime.message.free import ACLMessage
from aseme_dsl.runtime.ports import Driver
from aseme_dsl.runtime.time.alarm import Alarm
from aseme_dsl.runtime.trace.trace import Trace
from aseme_dsl.runtime.world.body import AnyBody

FOLLOWING = 900
"""After so many steps in a row that only variables and raised events ask for, an agent would never rest."""
PAID = 10
"""So many such steps an input may cause. With inputs in quick succession there is never a step without one
that follows, though nothing goes round."""


class Agent:
    """A running chart with its activities, its place on the bus and in conversations.

    `post` and `errand` may be called from any thread. The driver never calls `process` twice at once, and
    keeps the order of the items.

    Many methods, but small ones: each is what the driver, the bus or the conversations call of an agent
    (`ports.py`). The parts that decide something stand in files of their own in this room.
    """

    def __init__(
        self,
        name: str,
        chart: Chart,
        find: ActivityFinder,
        driver: Driver[Execution],
        bus: Bus,
        conversations: Conversations,
        trace: Trace,
        seed: int = 1,
        body: AnyBody | None = None,
        behind: int = 0,
        queue: int = QUEUE,
    ) -> None:
        """Identities of what comes from it begin `behind` a number; `queue` signals may wait in a region."""
        self.name = name
        self.chart = chart
        self.plan = chart.PLAN
        self.driver = driver
        self.bus = bus
        self.conversations = conversations
        self.trace = trace
        self.seed = seed
        chart.seed = seed
        self.body = body
        self.messages: Messages = {}
        """The message classes of the agent's plan, from when messages of other versions may come."""
        self.kinds: Messages = {}
        """The message classes of the agent's plan, as far as they are known."""
        self.chosen: Callable[[Agent, str, str], None] = _not_here
        """Called for a message that says which plan is to run, with its sender."""
        self.code = PlanCode(self, find)
        self.executions = Executions(self, self.code)
        self.modules = Modules(self, self.executions, find)
        self.requests = Requests(self, bus)
        self.intake = Intake(_queued(self.plan), not driver.clock.virtual, queue)
        self.overload = Overload(self, queue)
        self._untakable = Untakable(lambda branch, item: self.conversations.refuse(self, branch, item))
        self._queue = chart.queue = queue
        self.steps: int = 0
        self.recent: deque[tuple[int, ...]] = deque(maxlen=8)
        """The transitions taken last, for messages about what does not end."""
        self.stopped = False
        self.down: bool = False
        """Whether it has crashed and not started again (in a simulation with faults)."""
        self.failed_at: str = ""
        """The place in the source where the agent failed."""
        self.since: dict[str, int] = {}
        """When each state, by its label, was last entered by a transition to it, or its activity returned."""
        self._sequence = itertools.count(behind + 1)
        self._wanted = True  # the first step enters the root
        self._following = 0
        self._inputs: list[Posted] | None = None
        self._ahead: list[Sample] = []
        """What the present step has seen of what arrived after it began."""
        self._alarm = Alarm(driver, self.errand, self._want)
        self._configuration: tuple[str, ...] = ()
        self._has_other_chart = False
        """Whether the next step is the first of a chart that has taken the place of another."""
        self._info_of = {info.label: info for info in self.plan.branches}
        trace.agents.append(self.checkpoint if driver.clock.virtual else self._checkpoint_soon)
        self.shown: JadeLikeAgent | None = None
        """The agent with its behaviours, if it is shown so; made before the first step."""
        self._effects = Effects(self, bus, self.executions, self.requests, self.overload)
        self._carry_out = self._effects.carry_out
        if not driver.clock.virtual:
            chart.pending = self._pending

    @property
    def role(self) -> str:
        """The name of the plan that the agent follows."""
        return self.plan.name

    @property
    def over(self) -> bool:
        """Whether the agent has finished, failed or been stopped."""
        return self.stopped or self.chart.finished or self.chart.failure is not None

    # ---- the intake --------------------------------------------------------------------------

    def identity(self) -> Identity:
        """A new identity for something that comes from this agent."""
        return self.name, next(self._sequence)

    def post(
        self,
        identity: Identity,
        item: Input,
        execution: Writer | None = None,
        conversation: str | None = None,
    ) -> None:
        """Give the agent an input for its next step (for this one, from an errand that precedes it)."""
        posted = Posted(identity, item, execution, conversation)
        if self._inputs is not None and self.driver.owns(self):
            self._inputs.append(posted)
        else:
            self.intake.append(posted)
            self.driver.wake(self)

    def errand(self, call: Errand) -> None:
        """Have something done while the agent is guarded, in its turn among the inputs."""
        self.intake.append(call)
        self.driver.wake(self)

    def take(self) -> list[Posted | Errand]:
        """Everything that has come in so far."""
        return self.intake.take()

    @property
    def listens(self) -> bool:
        """Whether it has behaviours that may receive messages outside of every protocol."""
        shown = self.shown
        if shown is None:
            return not self.chart.started and self.chart.AGENT is not None
        return bool(shown.added_behaviours)

    def hear(self, identity: Identity, message: ACLMessage, refuse: Callable[[str], None]) -> None:
        """A message outside of every protocol has come: for an added behaviour."""
        self.errand(lambda: self._hear(identity, message, refuse))

    def _hear(self, identity: Identity, message: ACLMessage, refuse: Callable[[str], None]) -> None:
        if self.down:
            text = f"{message.performative} from {message.sender} is lost: {self.name} is down"
            self.trace.fault(self.driver.clock.now(), self.name, text, input=list(identity))
        elif self.over:
            refuse(f"{self.name} has ended")
        elif self.shown is not None:
            self.shown.hear(identity, message, refuse)
        elif self.chart.started or self.chart.AGENT is None:
            refuse(f"{self.role} has no behaviours that could receive it")
        else:  # its first step comes before the next errand
            self.hear(identity, message, refuse)

    def begin(self) -> None:
        """Ask for a step, also if nothing comes in: the first one, or one more."""
        self.errand(self._want)

    def _want(self) -> None:
        self._wanted = True

    def _pending(self) -> Iterable[Sample]:
        """What has arrived since the step began, for a step that looks."""
        found = self.intake.arrived()
        known = {item.identity for item in self._ahead}
        self._ahead += [item for item in found if item.identity not in known]
        return found

    # ---- the step ----------------------------------------------------------------------------

    def process(self, items: Iterable[Posted | Errand]) -> None:
        """Run the errands, and give the inputs to one step, if there is anything to step for."""
        inputs = self._inputs = []
        later: list[Posted] = []
        for item in items:
            if not isinstance(item, Posted):
                item()
            elif self.chart.raised and not (self.over or self.down):
                later.append(item)  # an event that an action has raised comes alone
            elif self._counts(item):
                wanted = self._renewed(item, None) if self.messages else item
                if wanted is not None:
                    inputs.append(wanted)
        self._inputs = None
        if later:
            self.intake.put_back(later)
            self.driver.wake(self)
        if self.intake.left_out or self.intake.refused:
            self.overload.at_the_door(self.intake)
        if self.down:
            self._lose(inputs)
            return
        if self.over or not (inputs or self._wanted):
            return
        self._wanted = False
        self._step(inputs)

    def _counts(self, item: Posted) -> bool:
        """Whether an input is still wanted."""
        if item.execution is not None and item.execution.cancelled:
            item.execution.dropped += 1
            return False
        if isinstance(item.input, AgentMessage):
            return self.conversations.arrives(self, item.input, item.conversation)
        if isinstance(item.input, Addressed | Settled):
            return self.conversations.place(self, item.input.branch)[0] == item.conversation
        if isinstance(item.input, Sample) and item.input.channel == SELECT:
            self.chosen(self, getattr(item.input.message, "plan"), item.input.sender)  # noqa: B009
            return SELECT in self.chart.READERS
        return True

    def _step(self, inputs: list[Posted]) -> None:
        chart = self.chart
        now = self.driver.clock.now()
        self.trace.checkpoint_all()
        if self._has_other_chart:
            self.checkpoint()
        self.steps += 1
        if not chart.started:
            self._show()
        self._ahead = []
        drained, chart.drains = chart.drains, False
        given = [item.input for item in inputs]
        try:
            outcome = chart.step(now, given)
        except Exception as error:  # nothing in a document can do that; the other agents play on
            self._trace_step(now, inputs, Outcome(), None)
            self.fail(f"the step raised {reason_of(error)}", frames_of(error, own=True))
            return
        self.recent.extend(outcome.taken)
        for label in changed_states(self.plan, self.steps == 1, given, outcome):
            self.since[label] = now
        if self.trace.active:
            before, self._configuration = self._configuration, chart.configuration()
            changed = self._configuration if self._configuration != before else None
            self._trace_step(now, inputs, outcome, changed)
        else:
            self._configuration = ()
        if self.shown is not None:
            self.shown.follow(outcome)
        stop = chart.stopped_at if outcome.failure is not None else -1
        self._effects.look_ahead(outcome.effects)
        for place, effect in enumerate(outcome.effects):
            if place == stop:
                self.conversations.leaving(self, "failed")
            self._carry_out[type(effect)](effect)
        if outcome.failure is not None:
            self._note_failure(now, outcome)
        self.requests.prepared.end_step()
        self._effects.fail_for_content()
        if outcome.failure is not None or outcome.finished:
            self._end()
            return
        if chart.PLAN.branches:
            self._untakable.look(chart)
        if not self.modules.has_begun:
            self.modules.begin()
        if outcome.again:
            self.errand(self._want)
        if chart.woken or self._following:
            self._follow(bool(inputs) or drained)
            if self.over:
                return
        self._alarm.set(chart.due(now))

    def checkpoint(self) -> None:
        """Record the state of the chart. Between two steps, while the agent is guarded."""
        if self.trace.is_kept:
            parts = [
                (conversation, info.participant, info.label)
                for info, conversation in self.conversations.inside(self)
            ]
            now, saved = self.driver.clock.now(), self.chart.save()
            self.trace.checkpoint(now, self.name, self.steps, saved, parts, anew=self._has_other_chart)
        self._has_other_chart = False

    def _checkpoint_soon(self) -> None:
        self.errand(self.checkpoint)

    def _trace_step(
        self, now: int, inputs: Iterable[Posted], outcome: Outcome, changed: tuple[str, ...] | None
    ) -> None:
        """Record a step, with the configuration if that has `changed`."""
        identities = [item.identity for item in inputs]
        self.trace.step(now, self.name, self.plan, self.steps, identities, self._ahead, outcome, changed)

    def _follow(self, has_inputs: bool) -> None:
        """Count the steps in a row that only variables and raised events have asked for, and stop an agent
        that makes them for ever. An input pays for some of them, and so does a queued signal."""
        if not self.chart.woken:
            self._following = 0
        elif has_inputs:
            self._following = max(1, self._following - PAID)
        else:
            self._following += 1
        self.chart.woken = False
        if self._following >= FOLLOWING:
            raising = "its actions raise events without an end"
            why = raising if self.chart.raised else "its regions wake each other"
            self.fail(f"{FOLLOWING} steps follow each other and no end, {why}: {self.cycle()}")

    def _show(self, labels: Mapping[str, str] | None = None) -> None:
        """Show the chart with its behaviours, if it is to be shown so. One that continues another, by
        `labels`, is shown in its present state."""
        before = self.shown
        kind = agent_class(type(self.chart), self.code.find)
        self.shown = kind(self) if kind is not None else None
        if self.shown is not None and labels is not None:
            self.shown.go_on(before, labels)

    # ---- the end -----------------------------------------------------------------------------

    def _note_failure(self, now: int, outcome: Outcome) -> None:
        self.failed_at = place_of_failure(self.plan, outcome)
        self.trace.failure(now, self.name, outcome.failure or "", self.failed_at)

    def fail(self, reason: str, frames: list[dict[str, object]] | None = None) -> None:
        """Stop the agent for a reason that its chart does not know. Called while the agent is guarded."""
        if self.over:
            return
        self.chart.failure = reason
        if self.recent:
            self.failed_at = self.plan.transitions[self.recent[-1][0]].at
        now = self.driver.clock.now()
        self.trace.failure(now, self.name, reason, self.failed_at, traceback=frames)
        self.conversations.leaving(self, "failed")
        self._end()

    def stop(self) -> None:
        """Cancel what runs and do nothing more. Called while the agent is guarded."""
        if not self.over:
            self.stopped = True
            self.conversations.leaving(self, None)
        self._end()

    def _end(self) -> None:
        self._alarm.cancel()
        if self.shown is not None:
            self.shown.over(left=self.chart.finished or self.chart.failure is not None)
        if not self.stopped:
            self._abandon(self.chart.ABANDON)
        self.overload.end(self.intake)
        self.executions.cancel_all()
        self.modules.stop()
        self.conversations.gone(self)

    def _abandon(self, branches: Iterable[str]) -> None:
        """Send what these branches say when they are left before their END, if their parts are not over."""
        chart = self.chart
        for branch in branches:
            if branch in chart.ABANDON and self.conversations.place(self, branch)[0] is not None:
                outcome = Outcome()
                chart.taken, chart.effects = outcome.taken, outcome.effects
                chart.abandon(branch)
                for effect in outcome.of(Sending):
                    self._effects.send(effect)

    # ---- another plan ------------------------------------------------------------------------

    def go_on(self, carried: Carried, find: ActivityFinder, messages: Messages, changed: bool) -> None:
        """Take over a chart that stands where the present one stands. Called while the agent is guarded.

        `changed` says whether the plan differs: then something may be enabled that was not.
        """
        # What has just become due is not due later once more: it is looked at now.
        is_due = self._alarm.is_due(self.driver.clock.now())
        labels = carried.labels
        kept = {info.label for info in carried.chart.PLAN.branches}
        self._abandon([item for item in self.chart.ABANDON if labels.get(item) not in kept])
        self._adopt(carried.chart)
        self.messages = messages
        self.since = {labels[label]: moment for label, moment in self.since.items() if label in labels}
        self.executions.carry(labels, find)
        if carried.chart.started:
            self._show(labels)
        self.requests.prepared.renew(labels, self.understood)
        with self.conversations.still():  # no agent message is posted to a participant by its old name
            self.conversations.carry(self, labels, messages)
            waiting = (
                self._renewed(item, labels) if isinstance(item, Posted) else item for item in self.take()
            )
            self.intake.put_back([item for item in waiting if item is not None])
        self.conversations.leaving(self, "replaced")
        for effect in carried.effects:
            self._carry_out[type(effect)](effect)
        self.conversations.leaving(self, "left")
        if changed or is_due:
            self.errand(self._want)
        self.modules.renew(find)
        if carried.chart.started:
            self._alarm.set(self.chart.due(self.driver.clock.now()))

    def begin_as(self, chart: Chart, find: ActivityFinder, messages: Messages, *, dead: bool = False) -> None:
        """Leave the present plan, and enter another. Called while the agent is guarded, between two steps.

        One that is `dead` says nothing any more when it leaves.
        """
        old = self.chart
        if old.started:
            old.effects.clear()
            old.leave()
            old.discard(old.PLAN.states[0].label)
            effects = old.effects if not dead else [item for item in old.effects if not _is_said(item)]
            self.conversations.leaving(self, "crashed" if dead else "replaced")
            for effect in effects:
                self._carry_out[type(effect)](effect)
            if self.shown is not None:
                self.shown.stop_behaviours()
            if self.shown is not None and not dead:
                self.shown.over(left=True)
            self.shown = None
        with self.conversations.still():
            self.conversations.gone(self, f"{self.name} has left its plan")
            items = [item for item in self.take() if is_for_any_plan(item)]
            chart.tokens = old.tokens
            self._adopt(chart)
            self.messages = messages
            self.executions.forget(find)
            self.modules.forget(find)
            self.requests.prepared.clear()
            self.intake.put_back(items)
        if self._inputs is not None:  # it chose this itself, in a message that came with others
            self._inputs[:] = [item for item in self._inputs if is_for_any_plan(item)]
        self.begin()

    def crash(self) -> None:
        """Stop dead, as a robot that is switched off; its knowledge is lost. Between two steps."""
        if not self.over:
            self.begin_as(type(self.chart)(self.name), self.code.find, self.messages, dead=True)
            self.down = True
            self.trace.write("life", self.driver.clock.now(), agent=self.name, what="crash")
            self.conversations.directory.disappeared(self.name)

    def restart(self) -> None:
        """Start afresh after a crash."""
        if self.down:
            self.down = False
            self.trace.write("life", self.driver.clock.now(), agent=self.name, what="restart")
            self.conversations.directory.appeared(self.name, self.plan)
            self.begin()

    def _lose(self, inputs: Iterable[Posted]) -> None:
        """What comes for an agent that is down is lost."""
        for item in inputs:
            if isinstance(item.input, Sample | AgentMessage):
                name = item.input.channel if isinstance(item.input, Sample) else item.input.message
                text = f"{name} from {item.input.sender} is lost: {self.name} is down"
                now = self.driver.clock.now()
                self.trace.fault(now, self.name, text, input=list(item.identity))

    def _adopt(self, chart: Chart) -> None:
        self._has_other_chart = True
        chart.seed = self.seed
        chart.chance = chart.chance or self.chart.chance
        self.chart = chart
        self.chart.queue = self._queue
        self.plan = chart.PLAN
        self.intake.queued = _queued(self.plan)
        self._info_of = {info.label: info for info in self.plan.branches}
        self.recent.clear()
        self._untakable.forget()
        self._configuration = chart.configuration() if chart.started and self.trace.active else ()
        if not self.driver.clock.virtual:
            chart.pending = self._pending
        self._alarm.cancel()

    def _renewed(self, item: Posted, labels: Mapping[str, str] | None) -> Posted | None:
        """An input as the agent's plan has it; None, told in the trace, where it has nothing of that name."""
        try:
            return renewed(item, self.chart, self.messages, labels)
        except LookupError as error:
            text = f"an input of {item.identity[0]} is left out: {error.args[0]}"
            self.trace.fault(self.driver.clock.now(), self.name, text)
            return None

    def understood(self, content: object) -> object:
        """The content of an agent message as the agent's plan has it; as it is, where it has none."""
        if not self.messages:
            return content
        try:
            return converted(content, self.messages)
        except LookupError:
            return content

    def in_threads(self) -> int:
        """How many of its activities and modules can run in threads at once."""
        return self.code.in_threads() + self.modules.in_threads()

    def cycle(self) -> str:
        """The transitions taken last, for messages about what does not end."""
        return cycle(self.plan, self.recent)

    # ---- behaviours --------------------------------------------------------------------------

    def take_note(self, branch: str, mail: AgentMessage) -> None:
        """A participant, by its branch, has taken a message: its behaviour gets it."""
        if self.shown is not None:
            self.shown.take_note(branch, mail)

    def callback(self, label: str) -> type[Executable] | None:
        """The activity of a state that is a method of a behaviour, if it is one."""
        return None if self.shown is None else self.shown.callback(label)

    # ---- questions ---------------------------------------------------------------------------

    def branch_info(self, label: str) -> BranchInfo:
        """What the plan says of a branch."""
        return self._info_of[label]


def _is_said(effect: Effect) -> bool:
    """Whether an effect leaves the agent."""
    return isinstance(effect, Publication | Sending)


def _not_here(agent: Agent, plan: str, by: str) -> None:
    """There is no team, and so no other plan."""


def _queued(plan: Plan) -> frozenset[str]:
    """The channels whose signals queue."""
    return frozenset(info.name for info in plan.channels if info.queued)
