"""Routes: the rules of a team's channels, and which agents a message on a channel concerns."""

from __future__ import annotations

from collections.abc import Mapping

from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.plan import ChannelInfo, Plan, Term
from aseme_dsl.runtime.ports import Receiver


@dataclass(frozen=True, slots=True)
class Route:
    """Who gets what an agent publishes on a channel: agents here, agents elsewhere, the names of all."""

    here: tuple[Receiver, ...]
    elsewhere: tuple[str, ...]
    names: tuple[str, ...]


class Routes:
    """The channels of one team, with the agents that publish and read on them."""

    def __init__(self) -> None:
        self.agents: dict[str, Receiver] = {}
        """The agents in this process."""
        self.rules: dict[str, ChannelInfo] = {}
        self.roles: dict[str, str] = {}
        """The role of each agent, in the team's order."""
        self._plans: dict[str, Plan] = {}
        self._reads: dict[str, dict[str, frozenset[str | None]]] = {}
        self._writes: dict[str, frozenset[str]] = {}
        self._routes: dict[tuple[str, str], Route] = {}

    def add(self, name: str, plan: Plan) -> None:
        """An agent of the team, here or elsewhere, has this plan; it counts in the team's order."""
        self._plans[name] = plan
        for info in plan.channels:
            self.rules.setdefault(info.name, info)
        self.roles[name] = plan.name
        self._reads[name] = _reads(plan)
        self._writes[name] = _writes(plan)
        self._routes.clear()

    def renew(self, plans: Mapping[str, Plan]) -> None:
        """Agents follow these plans now: take their rules instead."""
        self._plans.update(plans)
        self.rules.clear()
        for name, plan in self._plans.items():
            self.add(name, plan)

    def reads(self, agent: str, channel: str) -> bool:
        """Whether anything of an agent reads a channel."""
        return channel in self._reads[agent]

    def receivers(self, publisher: str, channel: str) -> Route:
        """Who gets what an agent publishes on a channel."""
        key = (publisher, channel)
        found = self._routes.get(key)
        if found is None:
            rules = self.rules.get(channel)
            found = self._routes[key] = self.to(
                tuple(
                    name
                    for name in self.roles
                    if channel in self._reads[name] and self._concerns(publisher, name, channel, rules)
                )
            )
        return found

    def to(self, names: tuple[str, ...]) -> Route:
        """The route to these agents."""
        here = tuple(self.agents[name] for name in names if name in self.agents)
        return Route(here, tuple(name for name in names if name not in self.agents), names)

    def _concerns(self, publisher: str, reader: str, channel: str, rules: ChannelInfo | None) -> bool:
        if reader == publisher or channel not in self._writes[reader]:
            return True
        if publisher in self._reads[reader][channel]:
            return True
        if rules is None:
            return False
        names = {*self.roles, *self.roles.values()}
        return rules.radio is not None or bool(names & set(rules.sources))

    def objection(self, reader: str, channel: str, sender: str, host: str | None) -> str | None:
        """Why a message from elsewhere is not for this agent, or None."""
        if host is None and reader not in self.receivers(sender, channel).names:
            return f"{channel} of {sender} does not concern {reader}"
        if host not in (None, reader):
            return f"{channel} of {sender} is for {host}"
        rules = self.rules.get(channel)
        sources = set(rules.sources) if rules is not None else set()
        known = {*self.roles, *self.roles.values()}
        # Where an activity may publish, too, its agent has seen to it that it was that one.
        if sources and sources <= known and not sources & {sender, self.roles[sender]}:
            return f"only {', '.join(sorted(sources))} may publish on {channel}, not {sender}"
        return None

    def measured(self, channel: str, came: int) -> int | None:
        """When a message that came at a moment counts as sent, if it goes by radio; None if it has a time."""
        rules = self.rules.get(channel)
        return None if rules is None or rules.radio is None else came - rules.delay

    def kind(self, channel: str) -> str:
        """How the links carry what is published on a channel: signal, state, data or radio."""
        rules = self.rules.get(channel)
        return "radio" if rules is not None and rules.radio is not None else channel.split(".", 2)[1]


def _reads(plan: Plan) -> dict[str, frozenset[str | None]]:
    """The channels that a plan reads, each with the senders that it names there (None: any)."""
    found: dict[str, set[str | None]] = {c: {None} for region in plan.regions for c in region.reads}
    for activity in (*plan.activities, *plan.modules):
        for name in activity.reads:
            host, _, channel = name.partition(".")
            if channel.count(".") == 2:  # robot1.vision.state.Ball
                found.setdefault(channel, {None}).add(host)
    waiting: list[Term] = []
    for transition in plan.transitions:
        if transition.condition is not None:
            waiting.append(transition.condition)
        waiting.extend(transition.actions)
    while waiting:
        term = waiting.pop()
        if term and term[0] == "member":
            of = term[1]
            found.setdefault(str(term[2]), {None}).add(None if of is None else str(of))
        waiting.extend(item for item in term if isinstance(item, tuple) and item)
    return {channel: frozenset(hosts) for channel, hosts in found.items()}


def _writes(plan: Plan) -> frozenset[str]:
    """The channels on which something in a plan publishes."""
    activities = (channel for activity in plan.activities for channel in activity.writes)
    regions = (channel for region in plan.regions for channel in region.writes)
    return frozenset((*activities, *regions))


__all__ = ["Route", "Routes"]
