"""The bus: takes what is published to the agents that it concerns, under the rules of its channel.

Whom a message without addressee concerns. A message always comes back to its own agent, whose other regions
see it in the next step. It goes to another agent that reads its channel if

* the channel's topic goes by `radio`, or its rule `from` names a role or an agent: it is the team's; or
* the other reads it under the publisher's name (`robot1.vision.state.Ball`); or
* nothing in the other ever publishes on that channel: it can only mean what others publish.

Everything else stays at home: each robot has its own `vision.state.Ball`. A message to one agent goes to that
agent alone.

The rules. `from`: a publication by any other (by role, agent or activity) is refused. `every`: one that comes
sooner than that after the last is delayed until the time is over, and a newer one takes its place. Data is
dropped instead; `queued` signals all go out, one at a time. `persist`: the last state is kept in the state
directory and is there when the agent starts again. The trace records each message that does not go out as it
was published.
"""

from __future__ import annotations

import threading
from collections.abc import Iterable, Mapping
from functools import partial
from pathlib import Path

from aseme_dsl.runtime.channel.persist import Kept
from aseme_dsl.runtime.channel.routes import Routes
from aseme_dsl.runtime.chart.board import QUEUE
from aseme_dsl.runtime.chart.inputs import Happened, Identity, Sample
from aseme_dsl.runtime.chart.plan import ChannelInfo, Plan
from aseme_dsl.runtime.message.as_json import to_json
from aseme_dsl.runtime.ports import Links, Receiver, Speaker
from aseme_dsl.runtime.time.timers import Scheduler, Timer
from aseme_dsl.runtime.trace.trace import Trace
from aseme_dsl.runtime.transport.port import LOCAL, Transport

SELECT = "runtime.signal.SelectPlan"
"""The channel on which a message says which plan its receiver, or else its sender, is to run."""


class _Held:
    """What one sender has published on a channel for one receiver: when last, and what waits for its turn."""

    __slots__ = ("last", "timer", "waiting", "was_full")

    def __init__(self) -> None:
        self.last: int | None = None
        self.waiting: list[tuple[object, str | None, str | None]] = []
        self.timer: Timer | None = None
        self.was_full = False


class Bus:
    """The bus of a team: of its agents in this process, and by `transport` of those in others.

    May be used from any thread.
    """

    def __init__(
        self,
        driver: Scheduler,
        trace: Trace,
        state_directory: Path | None = None,
        transport: Transport = LOCAL,
        queue: int = QUEUE,
    ) -> None:
        """So many signals that queue, `queue`, may wait for their turn on a channel with `every`."""
        self.trace = trace
        self._transport = transport
        self._queue = queue
        self._driver = driver
        self._routes = routes = Routes()
        self._agents = routes.agents
        self._rules = routes.rules
        self._radios: dict[str, Speaker] = {}
        self._held: dict[tuple[str, str, str | None], _Held] = {}
        self._given = 0
        self._lock = threading.RLock()
        self.links: Links | None = None
        """The simulated links between the agents, if they are not perfect."""
        self._kept = Kept(state_directory) if state_directory is not None else None

    def join(self, agent: Receiver, radio: Speaker | None = None) -> None:
        """An agent comes on the bus; the order in which they come is the team's."""
        self._agents[agent.name] = agent
        if radio is not None:
            self._radios[agent.name] = radio
        self.join_elsewhere(agent.name, agent.plan)

    def join_elsewhere(self, name: str, plan: Plan) -> None:
        """An agent of the team runs in another process, with this plan; it counts in the team's order."""
        self._routes.add(name, plan)

    def renew(self, plans: Mapping[str, Plan]) -> None:
        """Agents follow these plans now: take their rules instead."""
        with self._lock:
            self._routes.renew(plans)

    # ---- publishing --------------------------------------------------------------------------

    def publish(
        self,
        agent: Receiver,
        channel: str,
        message: object,
        host: str | None = None,
        *,
        region: str | None = None,
        activity: str | None = None,
    ) -> None:
        """Publish for an agent: from a region of its chart or from an activity."""
        rules = self._rules.get(channel)
        sources = rules.sources if rules is not None else ()
        if sources and not {agent.name, agent.role, activity} & set(sources):
            who = f"{agent.name} ({agent.role}{', ' + activity if activity else ''})"
            reason = f"only {', '.join(sources)} may publish on {channel}, not {who}"
            self._refused("refused", agent, channel, message, reason)
            return
        if host is not None and host not in self._routes.roles:
            self._refused("refused", agent, channel, message, f"there is no agent {host}")
            return
        with self._driver.holding(), self._lock:
            if rules is not None and rules.every is not None:
                self._in_time(agent, rules, message, host, region, activity)
            else:
                self._send(agent, channel, message, host, region, activity)

    def _in_time(
        self,
        agent: Receiver,
        rules: ChannelInfo,
        message: object,
        host: str | None,
        region: str | None,
        activity: str | None,
    ) -> None:
        """Send now if the last publication is long enough ago, else hold back or drop."""
        assert rules.every is not None
        key = (agent.name, rules.name, host)
        held = self._held.setdefault(key, _Held())
        now = self._driver.clock.now()
        if held.last is None or (now - held.last >= rules.every and not held.waiting):
            held.last = now
            self._send(agent, rules.name, message, host, region, activity)
            return
        due = held.last + rules.every
        comm = rules.name.split(".", 2)[1]
        if comm == "data":
            self._refused("dropped", agent, rules.name, message, "too soon after the last", until=due)
            return
        if held.waiting and not rules.queued:
            old, _, _ = held.waiting.pop()
            self._refused("replaced", agent, rules.name, old, "a newer one came before its time")
        if len(held.waiting) >= self._queue:
            self._refused("refused", agent, rules.name, message, f"{self._queue} wait already for their turn")
            if not held.was_full:
                held.was_full = True
                text = f"{self._queue} {rules.name} of {agent.name} wait for their turn"
                self.trace.fault(now, agent.name, f"{text}: what comes now is refused")
            return
        held.waiting.append((message, region, activity))
        self._refused("delayed", agent, rules.name, message, "too soon after the last", until=due)
        if held.timer is None:
            held.timer = self._driver.at(due, lambda: self._release(agent, rules, host, held))

    def _release(self, agent: Receiver, rules: ChannelInfo, host: str | None, held: _Held) -> None:
        """Send what was delayed."""
        assert rules.every is not None
        with self._driver.holding(), self._lock:
            held.timer = None
            if not held.waiting:
                return
            message, region, activity = held.waiting.pop(0)
            held.last = now = self._driver.clock.now()
            self._send(agent, rules.name, message, host, region, activity)
            if held.waiting:
                due = now + rules.every
                held.timer = self._driver.at(due, lambda: self._release(agent, rules, host, held))

    def _send(
        self,
        agent: Receiver,
        channel: str,
        message: object,
        host: str | None,
        region: str | None,
        activity: str | None,
    ) -> None:
        now = self._driver.clock.now()
        identity = agent.identity()
        message = agent.understood(message)  # of an activity that began under another version
        rules = self._rules.get(channel)
        radio = self._radios.get(agent.name) if rules is not None and rules.radio is not None else None
        if host is not None:
            route = self._routes.to((host,))
        elif channel == SELECT:
            route = self._routes.to((agent.name,))
        else:
            route = self._routes.receivers(agent.name, channel)
        if radio is not None:
            route = self._routes.to((agent.name,) if agent.name in route.names else ())
        self.trace.message(
            now,
            identity,
            channel,
            message,
            route.names,
            host=host,
            region=region,
            activity=activity,
            via="radio" if radio is not None else None,
        )
        self._deliver(route.here, agent, Sample(channel, message, agent.name, now, identity), region)
        if route.elsewhere:
            self._transport.publish(identity, rules, channel, message, route.elsewhere, now, host)
        if radio is not None and host != agent.name:
            radio.send(channel, message, host, identity)
        if rules is not None and rules.persist and self._kept is not None:
            error = self._kept.put(agent.name, channel, host, message)
            if error is not None:
                self.trace.fault(now, agent.name, error)

    def _deliver(
        self, receivers: Iterable[Receiver], agent: Receiver | None, item: Sample, region: str | None
    ) -> None:
        own = item
        if region is not None:
            own = Sample(item.channel, item.message, item.sender, item.time, item.identity, region)
        for other in receivers:
            if other is agent:
                other.post(item.identity, own)
            elif self.links is None or agent is None:
                self._bring(other, item)
            else:
                self.links.carry(
                    agent.name,
                    other.name,
                    self._routes.kind(item.channel),
                    item.channel,
                    item.identity,
                    partial(self._bring, other, item),
                )

    def _bring(self, other: Receiver, item: Sample) -> None:
        """Give an agent what another one has published. What goes by radio has no time of its own."""
        came = item.time if self.links is None else self._driver.clock.now()
        moment = self._routes.measured(item.channel, came)
        if moment is not None and moment != item.time:
            self._tell_arrived(other, item.identity, item.channel, item.message, moment)
            item = Sample(item.channel, item.message, item.sender, moment, item.identity)
        other.post(item.identity, item)

    def _tell_arrived(
        self,
        agent: Receiver,
        identity: Identity,
        channel: str,
        message: object,
        moment: int,
        host: str | None = None,
    ) -> None:
        if self.trace.active:
            self.trace.write(
                "arrived",
                self._driver.clock.now(),
                agent=agent.name,
                input=list(identity),
                channel=channel,
                message=to_json(message),
                measured=moment,
                host=host,
            )

    # ---- from outside ------------------------------------------------------------------------

    def give(self, agent: Receiver, channel: str, message: object, sender: str = "input") -> None:
        """Give an agent a message that no agent has published (a script, a test)."""
        with self._driver.holding(), self._lock:
            identity = self.outside()
            now = self._driver.clock.now()
            self.trace.message(
                now, identity, channel, message, [agent.name], sender=None if sender == "input" else sender
            )
            agent.post(identity, Sample(channel, message, sender, now, identity))

    def give_event(self, agent: Receiver, event: str) -> None:
        """Give an agent an event that none of its activities has raised."""
        with self._driver.holding(), self._lock:
            name, number = identity = self.outside()
            now = self._driver.clock.now()
            self.trace.write("event", now, agent=name, sequence=number, event=event, to=[agent.name])
            agent.post(identity, Happened(event))

    def outside(self) -> Identity:
        """A new identity for what no agent has sent."""
        self._given += 1
        return "input", self._given

    def heard(self, agent: Receiver, channel: str, message: object, sender: str) -> None:
        """An agent has heard a message by radio; a simulated network delays or loses it first."""
        with self._driver.holding(), self._lock:
            if self.links is None:
                self._hear(agent, channel, message, sender)
                return
            self.links.carry(
                sender or "unknown",
                agent.name,
                "radio",
                channel,
                agent.identity(),
                lambda: self._hear(agent, channel, message, sender),
            )

    def _hear(self, agent: Receiver, channel: str, message: object, sender: str) -> None:
        with self._driver.holding(), self._lock:
            identity = agent.identity()
            now = self._driver.clock.now()
            measured = self._routes.measured(channel, now)
            moment = now if measured is None else measured
            self.trace.write(
                "radio_received",
                now,
                agent=agent.name,
                sequence=identity[1],
                sender=sender,
                channel=channel,
                message=to_json(message),
                measured=moment if moment != now else None,
            )
            if self._routes.reads(agent.name, channel):
                agent.post(identity, Sample(channel, message, sender, moment, identity))

    def arrived(
        self,
        agent: Receiver,
        channel: str,
        message: object,
        sender: str,
        identity: Identity,
        moment: int,
        host: str | None = None,
    ) -> str | None:
        """The transport has brought what an agent elsewhere published, measured at `moment`.

        The rules hold for every sender. A message that by them is not for the agent is refused; gives the
        reason.
        """
        reason = self._routes.objection(agent.name, channel, sender, host)
        if reason is not None:
            return reason
        with self._driver.holding(), self._lock:
            by_radio = self._routes.measured(channel, self._driver.clock.now())
            moment = moment if by_radio is None else by_radio
            self._tell_arrived(agent, identity, channel, message, moment, host)
            if self._routes.reads(agent.name, channel) or channel == SELECT:
                agent.post(identity, Sample(channel, message, sender, moment, identity))
        return None

    def concerns(self, sender: str, channel: str, receiver: str) -> bool:
        """Whether an agent gets what another one publishes on a channel for all."""
        return receiver in self._routes.receivers(sender, channel).names

    def restore(self, messages: Mapping[str, type[object]]) -> None:
        """Give the agents the states that were kept; `messages` are the classes by name.

        A kept state that is not of its message's type any more is recorded as a fault and left out.
        """
        if self._kept is None:
            return
        now = self._driver.clock.now()
        for agent in self._agents.values():
            states, errors = self._kept.load(agent.name, messages)
            for error in errors:
                self.trace.fault(now, agent.name, error)
            for channel, host, message in states:
                rules = self._rules.get(channel)
                if rules is None or not rules.persist:
                    continue
                identity = agent.identity()
                if host is None:
                    route = self._routes.receivers(agent.name, channel)
                else:
                    route = self._routes.to((host,) if host in self._routes.roles else ())
                self.trace.message(now, identity, channel, message, route.names, host=host, via="kept")
                self._deliver(route.here, agent, Sample(channel, message, agent.name, now, identity), None)
                if route.elsewhere:
                    self._transport.publish(identity, rules, channel, message, route.elsewhere, now, host)

    def keep(self) -> None:
        """Write, from now on, kept states as they change: in real time, where that can be beside the run."""
        if self._kept is not None and not self._driver.clock.virtual:
            self._kept.begin(self._not_kept)

    def save(self) -> None:
        """Write the kept states that have changed."""
        if self._kept is not None:
            for name, error in self._kept.save():
                self._not_kept(name, error)

    def end(self) -> None:
        """Write the last of the kept states."""
        if self._kept is not None:
            self._kept.end(1.0)
            self.save()

    def _not_kept(self, name: str, error: str) -> None:
        self.trace.fault(self._driver.clock.now(), name, error)

    def _refused(
        self, kind: str, agent: Receiver, channel: str, message: object, reason: str, until: int | None = None
    ) -> None:
        if self.trace.active:
            self.trace.write(
                kind,
                self._driver.clock.now(),
                agent=agent.name,
                channel=channel,
                message=to_json(message),
                reason=reason,
                until=until,
            )
