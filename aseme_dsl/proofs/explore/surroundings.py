"""Surroundings of a team that is explored: no time passes, and what is on its way waits until it is let go.

Time stands still. What time alone would bring is the end of an activity, a message on its way, or a
deadline. Each may come at any moment and in any order, so runs of any speed are explored.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import AbstractContextManager, nullcontext
from dataclasses import field, replace
from functools import partial

from aseme_dsl.records import dataclass
from aseme_dsl.runtime.activity.context import Cancelled
from aseme_dsl.runtime.activity.execution import Execution
from aseme_dsl.runtime.chart.inputs import Identity
from aseme_dsl.runtime.message.acl import AclMessage
from aseme_dsl.runtime.ports import Stepping
from aseme_dsl.runtime.time.alarm import Alarm
from aseme_dsl.runtime.time.timers import Timer, Timers

NOW = 10**15
"""The moment (ns) at which an explored team stands."""

_FREE = nullcontext()


class StillClock:
    """A clock that stands still."""

    virtual = True
    moment = NOW
    """The moment, which may be marked: see `retrace`."""

    def __init__(self) -> None:
        self.moment = NOW
        """Now; of a team that is explored with times, a stamp."""

    def now(self) -> int:
        return self.moment


class Still:
    """The driver of an explored team: keeps what would happen by itself."""

    def __init__(self) -> None:
        self.clock = StillClock()
        self.agents: Sequence[Stepping] = ()
        self.running: list[Execution] = []
        """The activities that run."""
        self.timers: list[Timer] = []
        """Calls that wait for their moment, but those of alarms: how old things are is a move of its own."""
        self._none = Timers()

    def at(self, moment: int, call: Callable[[], None], background: bool = False) -> Timer:
        """Keep a call."""
        timer = Timer(self._none, moment, call, background)
        if not isinstance(getattr(call, "__self__", None), Alarm):
            self.timers = [item for item in self.timers if item.call is not None]
            self.timers.append(timer)
        return timer

    def owns(self, agent: Stepping) -> bool:
        return True

    def wake(self, agent: Stepping) -> None:
        """It steps when the team comes to rest."""

    def holding(self) -> AbstractContextManager[object]:
        return _FREE

    def guard(self, agent: Stepping) -> AbstractContextManager[object]:
        return _FREE

    def hold(self, agent: Stepping) -> AbstractContextManager[object]:
        return _FREE

    def launch(self, execution: Execution) -> None:
        """An activity runs from now on."""
        self.running.append(execution)

    def cancel(self, execution: Execution) -> None:
        """One that is cancelled ends at once."""
        if execution in self.running:
            self.running.remove(execution)
        execution.returned(Cancelled())

    def wait(self, execution: Execution, duration: int) -> None:
        raise RuntimeError("no code runs where a team is explored")


@dataclass(frozen=True, slots=True)
class Underway:
    """Something on its way from one agent to another."""

    kind: str
    what: str
    identity: Identity
    give: Callable[[], None]
    sent: int
    """When it was sent."""
    crosses: bool = False
    """Whether its receiver has sent an agent message to its sender, and neither has the other's."""

    @property
    def overtakes(self) -> bool:
        """Whether it may come before what was sent earlier."""
        return self.kind in ("data", "radio")


def next_of(waiting: Sequence[Underway]) -> Iterator[Underway]:
    """What may come next of all that is on one way."""
    held: set[str] = set()
    for item in waiting:
        line = item.what if item.overtakes else ""
        if line not in held:
            held.add(line)
            yield item


@dataclass(slots=True)
class Ways:
    """The links between the agents: what was sent from one to another, the oldest first."""

    ways: dict[tuple[str, str], list[Underway]] = field(default_factory=dict)
    taken: Callable[[str, str], bool] = lambda receiver, what: True
    """Whether it matters to a receiver what comes on a channel."""
    now: Callable[[], int] = lambda: NOW
    mail: Callable[[AclMessage], AclMessage] = lambda acl: acl
    """What of an agent message makes a difference."""
    deaf: frozenset[str] = frozenset()
    """The agents to which nothing comes."""

    def uncross(self) -> None:
        """It makes no difference which messages cross."""
        for waiting in self.ways.values():
            for place, item in enumerate(waiting):
                if item.crosses:
                    waiting[place] = replace(item, crosses=False)

    def carry(
        self, sender: str, receiver: str, kind: str, what: str, identity: Identity, give: Callable[[], None]
    ) -> None:
        """Something is on its way now."""
        if receiver in self.deaf or (kind != "mail" and not self.taken(receiver, what)):
            return
        against = self.ways.get((receiver, sender), [])
        crossed = [item for item in against if item.kind == kind == "mail"]
        for item in crossed:
            against[against.index(item)] = replace(item, crosses=True)
        if isinstance(give, partial) and isinstance(give.args[-1], AclMessage):
            give = partial(give.func, *give.args[:-1], self.mail(give.args[-1]))
        item = Underway(kind, what, identity, give, self.now(), bool(crossed))
        self.ways.setdefault((sender, receiver), []).append(item)


__all__ = ["NOW", "Still", "Underway", "Ways", "next_of"]
