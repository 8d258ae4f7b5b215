"""Scheduler of added behaviours: one action at a time, as errands of the agent, in a fixed order."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Generator, Iterator
from dataclasses import replace
from functools import partial
from typing import TypeVar, cast

from aseme_dsl.records import dataclass
from aseme_dsl.runtime.activity.execution import Host
from aseme_dsl.runtime.activity.returning import frames_of, reason_of
from aseme_dsl.runtime.agent.added_behaviours import Behaviour, CompositeBehaviour, Pause
from aseme_dsl.runtime.chart.inputs import Identity
from aseme_dsl.runtime.conversation.moves import MoveError
from aseme_dsl.runtime.message.free import ACLMessage, MessageTemplate
from aseme_dsl.runtime.time.clock import MILLISECOND, nanoseconds
from aseme_dsl.runtime.time.timers import Timer

_T = TypeVar("_T")

TICK = 10 * MILLISECOND
"""After so long a behaviour acts again that neither is done nor waits for anything."""
AT_ONCE = 100
"""So many actions of one behaviour, with all in it, follow each other within `TICK`; then it pauses."""
WAITING = 1000
"""So many messages wait at the most for the behaviours of an agent."""
ROOT = "0"
"""The label in the trace of what a behaviour does: that of the statechart as a whole."""


@dataclass(slots=True, eq=False)
class _Leaf:
    """A behaviour that acts itself: what it waits for."""

    behaviour: Behaviour
    root: Behaviour
    ready: bool = False
    wakes: bool = False
    """Whether a message wakes it."""
    timer: Timer | None = None
    generator: Generator[object, None, object] | None = None
    blocked: bool = False
    until: int | None = None
    """Until when it is blocked, if that was said."""
    took: bool = False
    """Whether its action has received a message."""
    gone: bool = False


class _Queue:
    """The behaviours of one agent that act themselves, each once it is ready. Called while it is guarded."""

    def __init__(self, host: Host, run: Callable[[], None]) -> None:
        """`run` is called as an errand of the agent when there are ready behaviours; it takes them."""
        self._host = host
        self._run = run
        self._ready: deque[_Leaf] = deque()
        self._asked = False
        self._spent: dict[int, tuple[int, int]] = {}
        """How many actions of a root were in which span of `TICK`."""

    def make_ready(self, leaf: _Leaf) -> None:
        """Let a behaviour act in its turn."""
        if leaf.gone or leaf.ready:
            return
        self.awake(leaf)
        leaf.ready = True
        self._ready.append(leaf)
        self._ask()

    def _ask(self) -> None:
        if not self._asked:
            self._asked = True
            self._host.errand(self._run)

    def awake(self, leaf: _Leaf) -> None:
        """A behaviour does not wait any more."""
        leaf.wakes = leaf.ready = False
        if leaf.timer is not None:
            leaf.timer.cancel()
            leaf.timer = None

    def sleep(self, leaf: _Leaf, until: int | None, wakes: bool = False) -> None:
        """Let a behaviour act again at a moment, or (`wakes`) when a message has come."""
        self.awake(leaf)
        leaf.wakes = wakes
        if until is not None:
            leaf.timer = self._host.driver.at(
                until, lambda: self._host.errand(lambda: self._ring(leaf, until))
            )

    def _ring(self, leaf: _Leaf, until: int) -> None:
        if leaf.timer is not None and leaf.timer.moment <= max(until, self._host.driver.clock.now()):
            leaf.timer = None
            self.make_ready(leaf)

    def take(self) -> list[_Leaf]:
        """The behaviours that are ready, in order."""
        self._asked = False
        ready, self._ready = list(self._ready), deque()
        return ready

    def may_act(self, root: Behaviour) -> bool:
        """Count an action of a root; False if it has had too many of them in this `TICK`."""
        span = self._host.driver.clock.now() // TICK
        known, count = self._spent.get(id(root), (span, 0))
        count = count + 1 if known == span else 1
        self._spent[id(root)] = span, count
        return count <= AT_ONCE

    def forget(self, root: Behaviour) -> None:
        """A root behaviour has ended."""
        self._spent.pop(id(root), None)


class BehaviourScheduler:
    """The behaviours that were added to one agent. Called while the agent is guarded, but for `add`."""

    def __init__(self, host: Host, owner: object) -> None:
        self._host = host
        self._owner = owner
        self.roots: tuple[Behaviour, ...] = ()
        """What was added and has not ended."""
        self._leaves: dict[int, _Leaf] = {}
        self._queue = _Queue(host, self._run)
        self._acting: _Leaf | None = None
        self._stopped = False

    # ---- for the agent -----------------------------------------------------------------------

    def add(self, behaviour: Behaviour) -> None:
        """Run a behaviour from now on. Raises TypeError for what cannot be run."""
        if not isinstance(behaviour, Behaviour):
            raise TypeError(
                f"{getattr(behaviour, '__name__', behaviour)!r} is not an object of a behaviour of"
                " aseme_dsl.runtime.jade"
            )
        if behaviour.parent is not None or behaviour._runs_in is not None:
            raise TypeError(f"{behaviour.name} is in use: make another object")
        inside = list(_inside(behaviour))
        problem = next(filter(None, (item._problem() for item in inside)), None)
        if problem is not None:
            raise TypeError(problem)
        if self._stopped:
            self._fault(f"{behaviour.name} is not added: {self._host.name} has ended")
            return
        for item in inside:
            item.agent, item._runs_in = self._owner, self
        self.roots = (*self.roots, behaviour)
        self._host.errand(lambda: self._start(behaviour, behaviour))

    def remove(self, behaviour: Behaviour) -> None:
        """Run a behaviour no more; its `on_end` is not called. Raises LookupError if it was not added."""
        if not any(item is behaviour for item in self.roots):
            name = getattr(behaviour, "name", repr(behaviour))
            raise LookupError(f"{name} is not a behaviour that was added to {self._host.name}")
        self._remove(behaviour)

    def stop(self, *, told: bool) -> None:
        """The agent has ended, or continues under another plan."""
        self._stopped = True
        for item in self.roots:
            if told:
                self._trace("removed", item)
            self._let_go(item)

    def hear(self, identity: Identity, message: ACLMessage, refuse: Callable[[str], None]) -> None:
        """A message has come."""
        box = self._host.conversations.mailbox(self._host.name)
        if not self.roots:
            refuse(f"{self._host.name} has no behaviour that could receive it")
        elif len(box) >= WAITING:
            refuse(f"{WAITING} messages wait already for the behaviours of {self._host.name}")
        else:
            box[identity] = message
            for leaf in list(self._leaves.values()):
                if leaf.wakes:
                    self._queue.make_ready(leaf)

    # ---- for the behaviours ------------------------------------------------------------------

    def now(self) -> int:
        return self._host.driver.clock.now()

    def receive(self, template: MessageTemplate | None) -> ACLMessage | None:
        """The oldest message that waits and that a template matches. Raises LookupError for a protocol's."""
        host = self._host
        if template is not None and template.protocols:
            played = {name: host.conversations.protocol_of(name) for name in template.protocols}
            if all(played.values()):
                name, protocol = next(iter(played.items()))
                raise MoveError(
                    f"no behaviour receives messages of {name}: {protocol} is a protocol of this system,"
                    " whose participants receive them (handle_… of the participant's behaviour)"
                )
        box = host.conversations.mailbox(host.name)
        for identity, message in list(box.items()):
            if template is None or template.matches(message):
                box.pop(identity, None)
                leaf = self._acting
                if leaf is not None:
                    leaf.took = True
                    self._trace("received", leaf.behaviour, input=list(identity))
                if isinstance(message.content, str) or not host.messages:
                    return message
                return replace(message, content=host.understood(message.content))
        return None

    def send(self, message: ACLMessage) -> ACLMessage:
        host = self._host
        try:
            return host.conversations.send_free(host, message)
        except MoveError as error:
            self._fault(str(error))
            raise

    def block(self, behaviour: Behaviour, until: int | None) -> None:
        leaf = self._leaves.get(id(behaviour))
        if leaf is None or leaf is not self._acting:
            raise RuntimeError(f"{behaviour.name} may block in its own action only")
        leaf.blocked, leaf.until = True, until

    def restart(self, behaviour: Behaviour) -> None:
        leaf = self._leaves.get(id(behaviour))
        if leaf is not None and leaf.wakes:
            self._queue.make_ready(leaf)

    def log(self, behaviour: Behaviour, text: str) -> None:
        host = self._host
        host.trace.write("log", self.now(), agent=host.name, activity=behaviour.name, label=ROOT, text=text)

    # ---- starting and ending -----------------------------------------------------------------

    def _start(self, behaviour: Behaviour, root: Behaviour) -> None:
        """Start a behaviour and what starts with it."""
        waiting = [behaviour]
        while waiting:
            item = waiting.pop()
            if not self._is_in(root):
                return
            item._renew()
            if item._has_run and not self._call(item, root, item.reset, "reset")[0]:
                return
            item._has_run = True
            if not self._call(item, root, item.on_start, "on_start")[0] or not self._is_in(root):
                return
            self._trace("start", item)
            if isinstance(item, CompositeBehaviour):
                waiting += reversed(item._first())
                continue
            leaf = self._leaves[id(item)] = _Leaf(item, root)
            due = item._due(self.now())
            if due is None:
                self._queue.make_ready(leaf)
            else:
                self._queue.sleep(leaf, due)

    def _finish(self, behaviour: Behaviour, root: Behaviour) -> None:
        """A behaviour is done: the behaviour around it continues, or is done as well."""
        while True:
            fine, result = self._call(behaviour, root, behaviour.on_end, "on_end")
            if not fine or not self._is_in(root):
                return
            self._trace("end", behaviour)
            self._drop(behaviour)
            around = behaviour.parent
            if around is None:
                self._let_go(root)
                return
            around.exit_value = result
            fine, following = self._call(around, root, partial(around._after, behaviour, result), "the end")
            if not fine:
                return
            if following is not None:
                for item in following:
                    self._start(item, root)
                return
            behaviour = around

    def _call(
        self, behaviour: Behaviour, root: Behaviour, call: Callable[[], _T], what: str
    ) -> tuple[bool, _T | None]:
        """Call something of the user's; what it raises is recorded, and the behaviour removed."""
        try:
            return True, call()
        except (Exception, SystemExit) as error:
            self._fail(behaviour, root, error, what)
            return False, None

    def _fail(self, behaviour: Behaviour, root: Behaviour, error: BaseException, what: str) -> None:
        frames = frames_of(error)
        place = f" ({frames[-1]['file']}:{frames[-1]['line']})" if frames else ""
        inside = f" with {root.name}, which it is in" if root is not behaviour else ""
        self._fault(
            f"{what} of {behaviour.name} raised {reason_of(error)}{place}; the behaviour is removed{inside}"
        )
        if self._is_in(root):
            self._remove(root)

    def _remove(self, root: Behaviour) -> None:
        self._trace("removed", root)
        self._let_go(root)

    def _let_go(self, root: Behaviour) -> None:
        self.roots = tuple(item for item in self.roots if item is not root)
        self._queue.forget(root)
        for item in _inside(root):
            self._drop(item)
            item._runs_in = None

    def _drop(self, behaviour: Behaviour) -> None:
        """A behaviour, and what is in it, acts no more."""
        for item in _inside(behaviour):
            leaf = self._leaves.pop(id(item), None)
            if leaf is None:
                continue
            leaf.gone = True
            self._queue.awake(leaf)
            generator, leaf.generator = leaf.generator, None
            if generator is not None and leaf is not self._acting:
                try:
                    generator.close()
                except (Exception, SystemExit) as error:
                    self._fault(f"the end of {item.name} raised {reason_of(error)}")

    def _is_in(self, root: Behaviour) -> bool:
        return any(item is root for item in self.roots)

    # ---- acting ------------------------------------------------------------------------------

    def _run(self) -> None:
        """One action of each that is ready."""
        for leaf in self._queue.take():
            if leaf.gone or not leaf.ready:
                continue
            leaf.ready = False
            if not self._queue.may_act(leaf.root):
                self._queue.sleep(leaf, self.now() + TICK)
                continue
            self._acting = leaf
            try:
                self._act(leaf)
            finally:
                self._acting = None

    def _act(self, leaf: _Leaf) -> None:
        behaviour, root = leaf.behaviour, leaf.root
        leaf.took = leaf.blocked = False
        leaf.until = None
        if leaf.generator is None:
            fine, made = self._call(behaviour, root, behaviour.action, "action")
            if not fine or leaf.gone:
                return
            leaf.generator = made if isinstance(made, Generator) else None
        if leaf.generator is not None:
            fine, pause = self._call(behaviour, root, partial(_next, leaf.generator), "action")
            if not fine or leaf.gone:
                return
            if pause is not _END:
                self._pause(leaf, pause)
                return
            leaf.generator = None
        fine, done = self._call(behaviour, root, behaviour.done, "done")
        if not fine or leaf.gone:
            return
        if done:
            self._finish(behaviour, root)
            return
        due = behaviour._due(self.now())
        if due is not None:
            self._queue.sleep(leaf, due)
        elif leaf.blocked:
            self._queue.sleep(leaf, leaf.until, wakes=True)
        elif leaf.took:
            self._queue.make_ready(leaf)
        else:
            self._queue.sleep(leaf, self.now() + TICK)

    def _pause(self, leaf: _Leaf, pause: object) -> None:
        """A generator waits: for what it has yielded."""
        if isinstance(pause, Pause):
            self._queue.sleep(leaf, pause.until, wakes=pause.message)
            return
        fine, moment = self._call(
            leaf.behaviour,
            leaf.root,
            lambda: self.now() + (TICK if pause is None else nanoseconds(cast(float, pause))),
            "action",
        )
        if fine:
            self._queue.sleep(leaf, moment)

    # ---- the trace ---------------------------------------------------------------------------

    def _trace(self, what: str, behaviour: Behaviour, **members: object) -> None:
        host = self._host
        if host.trace.active:
            host.trace.write(
                "behaviour", self.now(), agent=host.name, what=what, behaviour=behaviour.name, **members
            )

    def _fault(self, text: str) -> None:
        self._host.trace.fault(self.now(), self._host.name, text)


_END = object()


def _next(generator: Generator[object, None, object]) -> object:
    """What a generator yields, or `_END`."""
    return next(generator, _END)


def _inside(behaviour: Behaviour) -> Iterator[Behaviour]:
    """A behaviour and all that is in it."""
    waiting = [behaviour]
    while waiting:
        item = waiting.pop()
        yield item
        if isinstance(item, CompositeBehaviour):
            waiting += reversed(item.sub_behaviours)


__all__ = ["BehaviourScheduler"]
