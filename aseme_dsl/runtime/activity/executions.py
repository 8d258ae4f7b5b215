"""Executions: the activities of one agent, from the start that a step asks for to the end it hears of."""

from __future__ import annotations

from collections.abc import Generator, Mapping
from dataclasses import replace
from functools import partial
from typing import cast

from aseme_dsl.records import dataclass
from aseme_dsl.runtime.activity import context as c
from aseme_dsl.runtime.activity.activities import ActivityError, ActivityFinder
from aseme_dsl.runtime.activity.checking import check_doing
from aseme_dsl.runtime.activity.codeless import Codeless
from aseme_dsl.runtime.activity.execution import Execution, Host
from aseme_dsl.runtime.activity.plan_code import CodeOf, PlanCode
from aseme_dsl.runtime.activity.returning import as_outcome, frames_of, is_cancellation, reason_of
from aseme_dsl.runtime.chart.inputs import Cancel, Completed, Crashed, Start
from aseme_dsl.runtime.conversation.moves import Sent
from aseme_dsl.runtime.message.as_json import to_json
from aseme_dsl.runtime.time.clock import MILLISECOND, nanoseconds
from aseme_dsl.runtime.time.timers import Timer

TICK = 10 * MILLISECOND
"""How long a `step` activity sleeps that yields nothing."""


@dataclass(slots=True)
class _Node:
    """A BASIC state: what runs there, and what is to run next."""

    program: CodeOf
    """What the plan says of its activity, and the code."""
    branch: str | None
    """The label of the protocol branch around it."""
    starts: int = 0
    last_start: int | None = None
    last_end: int = 0
    current: Execution | None = None
    next: Start | None = None
    held: Timer | None = None
    waits: bool = False
    made: Sent = frozenset()
    """What the activity that was suspended here has sent."""


class Executions:
    """The activities of one agent. Called only while the agent is guarded, but for `check`."""

    def __init__(self, agent: Host, code: PlanCode) -> None:
        self.agent = agent
        self._code = code
        self._nodes: dict[str, _Node] = {}
        self._former: list[_Node] = []
        """What the present plan does not have and is cancelled, but has not come to its end yet."""
        self._codeless = Codeless(agent, code)

    # ---- what the step asks for --------------------------------------------------------------

    def start(self, start: Start) -> None:
        """Start an activity, as soon as its period and its predecessor allow it."""
        node = self.hold(start)
        node.waits = False
        self._begin_when_free(node)

    def hold(self, start: Start) -> _Node:
        """Note an activity that is to start, and do not start it yet: a cancel may come first."""
        node = self._nodes.get(start.label)
        if node is None:
            node = self._nodes[start.label] = self._node(start)
        node.next = start
        return node

    def cancel(self, cancel: Cancel) -> None:
        """Cancel an activity that runs, or that was to start."""
        node = self._nodes.get(cancel.label)
        if node is None:
            return
        if node.next is not None and node.next.token == cancel.token:
            node.next = None
            if node.held is not None:
                node.held.cancel()
                node.held = None
            self._trace("cancel", cancel, started=False)
            return
        execution = node.current
        if execution is None or execution.start.token != cancel.token or execution.cancelled:
            return
        execution.cancelled = True
        self.agent.requests.prepared.cancelled(execution.branch, execution.label)
        execution.dropped += len(execution.held)
        execution.held.clear()
        self._trace("cancel", cancel, **({"reason": cancel.reason} if cancel.reason is not None else {}))
        if execution.timer is not None:
            execution.timer.cancel()
        if execution.code is None or execution.has_returned:
            self._free(execution)
        elif execution.generator is not None:
            self._close(execution)
        else:
            self.agent.driver.cancel(execution)

    def suspend(self, branch: str) -> None:
        """A protocol branch is suspended: where an activity ran, the next start continues it."""
        for node in self._nodes.values():
            current = node.current
            if node.branch == branch and current is not None and current.cancelled:
                node.made = current.made

    def leave(self, branch: str) -> None:
        """The part of a protocol branch is over: nothing in it continues."""
        for node in self._nodes.values():
            if node.branch == branch:
                node.made = frozenset()

    def cancel_all(self) -> None:
        """Cancel everything: the agent stops."""
        for label, node in self._nodes.items():
            if node.next is not None:
                self.cancel(Cancel(label, node.next.activity, node.next.token))
            if node.current is not None:
                start = node.current.start
                self.cancel(Cancel(label, start.activity, start.token))

    def refuse(self, start: Start, reason: str) -> None:
        """An activity cannot start, or continue: its state has failed."""
        identity = self.agent.identity()
        self._trace("crash", start, sequence=identity[1], reason=reason)
        self.agent.post(identity, Crashed(start.label, start.token, reason))

    def fail_inside(self, state: str, reason: str) -> bool:
        """Cancel the first activity that runs in a state, which has failed; whether there is one."""
        for label, node in self._nodes.items():
            current = node.current
            if current is not None and not current.has_returned and f"{label}.".startswith(f"{state}."):
                start = current.start
                self.cancel(Cancel(label, start.activity, start.token, reason))
                self.refuse(start, reason)
                return True
        return False

    def running(self) -> list[Execution]:
        """What has not come to its end yet, cancelled or not."""
        nodes = (*self._nodes.values(), *self._former)
        return [node.current for node in nodes if node.current is not None]

    # ---- another plan ------------------------------------------------------------------------

    def carry(self, labels: Mapping[str, str], find: ActivityFinder) -> None:
        """Continue under the agent's new plan, in which the states have these labels.

        What runs keeps running, with the code that it has; what starts later has the new plan's.
        """
        nodes, self._nodes = self._nodes, {}
        self._code.renew(find)
        self._codeless.clear()
        for old, node in nodes.items():
            label = labels.get(old)
            if label is None:  # nothing is active there
                if node.current is not None:
                    self._former.append(node)
                continue
            self._nodes[label] = node
            start = Start(label, self.agent.plan.by_label[label].activity or "", 0)
            fresh = self._node(start)
            node.program, node.branch = fresh.program, fresh.branch
            if node.next is not None:
                node.next = replace(node.next, label=label)
            execution = node.current
            if execution is not None:
                execution.start = replace(execution.start, label=label)
                execution.branch = node.branch
                execution.board = self.agent.chart.board_of(label)

    def forget(self, find: ActivityFinder) -> None:
        """Continue under the agent's new plan, of which nothing runs yet; everything has been cancelled."""
        self._former += [node for node in self._nodes.values() if node.current is not None]
        self._nodes = {}
        self._code.renew(find)
        self._codeless.clear()

    # ---- beginning ---------------------------------------------------------------------------

    def _node(self, start: Start) -> _Node:
        return _Node(self._code.of(start.activity), self.agent.plan.branch_of(start.label))

    def _begin_when_free(self, node: _Node) -> None:
        """Begin what is next, unless the old one has not returned or the period is not over."""
        start = node.next
        if start is None or node.held is not None:
            return
        if node.current is not None:
            if not node.waits:
                node.waits = True
                self._trace("wait", start)
            return
        now = self.agent.driver.clock.now()
        every = node.program.info.every
        if every is not None and node.last_start is not None:
            due = node.last_start + every
            if now < due:
                release = partial(self._release, node, due)
                node.held = self.agent.driver.at(due, lambda: self.agent.errand(release))
                return
            missed = (node.last_end - node.last_start - 1) // every
            if missed > 0:
                self._trace("missed", start, beats=missed)
        self._begin(node, start, now)

    def _begin_held(self, node: _Node, due: int) -> None:
        """Begin what was delayed until `due`. Its period is counted from then, however late it is now."""
        start, every = node.next, node.program.info.every
        assert start is not None and every is not None
        now = self.agent.driver.clock.now()
        missed = (now - due) // every
        if missed > 0:  # the machine or the process stood still
            self._trace("missed", start, beats=missed)
        self._begin(node, start, now)
        node.last_start = due + missed * every

    def _release(self, node: _Node, due: int) -> None:
        """The period is over, if it is still this start that is delayed."""
        if node.held is not None and node.held.moment == due:
            node.held = None
            if node.next is not None and node.current is None:
                self._begin_held(node, due)
            else:
                self._begin_when_free(node)

    def _begin(self, node: _Node, start: Start, now: int) -> None:
        info = node.program.info
        node.next = None
        node.last_start = now
        node.starts += 1
        board = self.agent.chart.board_of(start.label)
        code, kind = node.program.code, node.program.kind
        if code is None and node.program.error is None and not info.waits:
            called = self.agent.callback(start.label)
            code, kind = called, kind if called is None else "step"
        execution = node.current = Execution(
            self, start, info, code, kind, node.starts, node.branch, board, now
        )
        execution.earlier = execution.made = node.made
        node.made = frozenset()
        given = {name: to_json(value) for name, value in start.arguments}
        self._trace("start", start, **({"arguments": given} if given else {}))
        if node.program.error is not None:
            self.returned(execution, node.program.error)
        elif info.waits:
            pass  # until it is cancelled
        elif execution.code is None:
            lasts = self._codeless.begin(execution, now)
            execution.timer = self.agent.driver.at(
                now + lasts, lambda: self.agent.errand(lambda: self.returned(execution, None))
            )
        else:
            if node.program.stands_in:
                self.agent.requests.prepared.begun_without_code(execution.branch)
            if info.takes is not None and self.agent.driver.clock.virtual:
                execution.opens = now + info.takes
                execution.timer = self.agent.driver.at(execution.opens, lambda: self._open(execution))
            if execution.kind == "step":
                self._advance(execution)
            else:
                self.agent.driver.launch(execution)

    def _open(self, execution: Execution) -> None:
        """The activity has lasted what it takes: what it did counts."""
        if execution.cancelled:
            return
        execution.opens = None
        held, execution.held = execution.held, []
        for doing in held:
            self.agent.requests.perform(execution, doing)
        if execution.has_returned:
            self.agent.errand(lambda: self._end(execution))

    def _advance(self, execution: Execution) -> None:
        """Let a `step` activity continue until it yields."""
        if execution.cancelled or execution.has_returned:
            return
        try:
            if execution.generator is None:
                assert execution.code is not None
                made = execution.code().execute(execution.context, **execution.arguments)
                if not isinstance(made, Generator):  # a plain function is one that never yields
                    execution.result = as_outcome(made)
                    self.returned(execution, None)
                    return
                execution.generator = made
            pause = next(execution.generator)
            delay = TICK if pause is None else nanoseconds(cast(float, pause))
        except StopIteration as end:
            execution.result = as_outcome(end.value)
            self.returned(execution, None)
        except BaseException as error:
            if execution.generator is not None:
                execution.generator.close()
            self.returned(execution, error)
        else:
            moment = self.agent.driver.clock.now() + delay
            execution.handle = self.agent.driver.at(
                moment, lambda: self.agent.errand(lambda: self._advance(execution))
            )

    def _close(self, execution: Execution) -> None:
        """End a cancelled generator where it stands."""
        if execution.handle is not None:
            cast("Timer", execution.handle).cancel()  # see `_advance`
        error: BaseException | None = None
        try:
            assert execution.generator is not None
            execution.generator.close()
        except BaseException as raised:
            error = raised
        self.returned(execution, error)

    # ---- ending ------------------------------------------------------------------------------

    def returned(self, execution: Execution, error: BaseException | None) -> None:
        """The code has come to its end, or what has no code has lasted long enough."""
        if execution.has_returned:
            return
        execution.has_returned = True
        if error is None and not execution.cancelled:
            error = _wrong_outcome(execution)
        execution.error = error
        if execution.cancelled:
            if error is not None and is_cancellation(error):
                error = None
            self._trace(
                "late",
                execution.start,
                dropped=execution.dropped or None,
                reason=None if error is None else reason_of(error),
                traceback=None if error is None else frames_of(error),
            )
            self._free(execution)
        elif execution.opens is None or error is not None:
            self._end(execution)

    def _end(self, execution: Execution) -> None:
        if execution.cancelled:
            return
        agent = self.agent
        now = agent.driver.clock.now()
        start = execution.start
        takes = execution.info.takes
        if takes is not None and now - execution.started > takes:
            self._trace("overrun", start, takes=takes, lasted=now - execution.started)
        identity = agent.identity()
        if execution.timer is not None:
            execution.timer.cancel()
        if execution.error is None:
            outcome = _outcome(execution)
            told = {} if outcome is None else {"outcome": outcome}
            self._trace("end", start, sequence=identity[1], **told)
            agent.post(identity, Completed(start.label, start.token, outcome))
        else:
            reason = reason_of(execution.error)
            self._trace(
                "crash",
                start,
                sequence=identity[1],
                reason=reason,
                traceback=frames_of(execution.error),
                dropped=len(execution.held) or None,
            )
            agent.post(identity, Crashed(start.label, start.token, reason))
        self._free(execution)

    def _free(self, execution: Execution) -> None:
        execution.forget()
        node = self._nodes.get(execution.label)
        if node is not None and node.current is execution:
            node.current = None
            node.last_end = self.agent.driver.clock.now()
            self._begin_when_free(node)
        else:
            self._former = [item for item in self._former if item.current is not execution]

    # ---- what an activity does ---------------------------------------------------------------

    def check(self, execution: Execution, doing: c.Doing) -> None:
        """Refuse at once an effect that is not declared or makes no sense; see `check_doing`."""
        check_doing(self.agent, execution, doing)

    def frozen(self, execution: Execution) -> c.Port:
        """The port of a context that keeps what its activity sees just now."""
        from aseme_dsl.runtime.activity.snapshot import FrozenPort

        return FrozenPort(execution)

    def _trace(self, what: str, effect: Start | Cancel, **members: object) -> None:
        agent = self.agent
        if agent.trace.active:
            agent.trace.activity(what, agent.driver.clock.now(), agent.name, effect, **members)


def _outcome(execution: Execution) -> str | None:
    """How an activity has ended: one without code in the first of the ways in which it may."""
    ends = execution.info.ends
    if not ends:
        return None
    return ends[0] if execution.code is None else execution.result


def _wrong_outcome(execution: Execution) -> ActivityError | None:
    """An activity that ends in one of several ways has to say in which."""
    ends = execution.info.ends
    if not ends or execution.code is None or execution.result in ends:
        return None
    returned = "nothing" if execution.result is None else execution.result
    return ActivityError(f"it returned {returned}: it ends {' or '.join(ends)}")
