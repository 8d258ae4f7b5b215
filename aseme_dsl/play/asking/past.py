"""Past: what the lines of a trace say of a team until a time, as far as it explains what has not come."""

from __future__ import annotations

import json
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from dataclasses import field

from aseme_dsl.play.asking.sending import Sent
from aseme_dsl.play.inputs import identity_of
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.following import Following, Shape
from aseme_dsl.runtime.chart.inputs import Identity
from aseme_dsl.runtime.chart.plan import Plan
from aseme_dsl.runtime.time.clock import shown
from aseme_dsl.runtime.trace.records import Record, agents_of
from aseme_dsl.runtime.trace.trace_reading import Line

TROUBLES = ("refused", "dropped", "delayed", "replaced", "radio_failed", "lost")
"""The lines that say why a message on a channel has not come."""


@dataclass(slots=True)
class Member:
    """An agent of the team: its role, where it is, and since when; `over` says why it does nothing more."""

    role: str
    model: str
    configuration: tuple[str, ...] = ()
    since: dict[str, int] = field(default_factory=dict)
    """When its active states were entered, as far as that is known."""
    over: str = ""
    following: Following | None = None


class Past:
    """Is shown the lines of a trace, one after the other."""

    def __init__(
        self, plan_of: Callable[[str], Plan | None], earlier: Callable[[Collection[str]], Iterable[Line]]
    ) -> None:
        """`plan_of` gives the plan of a model by its hash.

        `earlier` gives the lines before the first that is shown (but for the header) that hold one of some
        texts, the newest first.
        """
        self._plan_of = plan_of
        self._earlier = earlier
        self.members: dict[str, Member] = {}
        self._searched: dict[str, frozenset[str]] = {}
        """The agents of which a message on a channel was looked for further up."""
        self.published: dict[str, dict[str, Record]] = {}
        """The last message of each agent on each channel."""
        self.troubles: dict[tuple[str, str], Record] = {}
        """What has last gone wrong on a channel for an agent, or with it as the `peer`."""
        self.sent: dict[tuple[str, str], dict[str, Record]] = {}
        """The last agent message of each agent, by performative and message."""
        self._refused: dict[tuple[str, Identity], Record] = {}
        """The lines of agent messages that an agent did not expect, by their identities."""
        self.begin = 0
        """The time (ns) of the first line that was shown, but for the header and changes of models."""
        self._received: dict[str, set[Identity]] = {}
        """The identities of what each agent has got."""
        self._kinds: Mapping[str, Callable[[Record], None]] = {
            "header": self._header,
            "step": self._step,
            "swap": self._changed,
            "select": self._changed,
            "message": self._published,
            "agent_message": self._sent,
            "unexpected": self._unexpected,
            "error": self._error,
            "life": self._life,
            **dict.fromkeys(TROUBLES, self._trouble),
        }

    def line(self, record: Record) -> None:
        """A line, in its turn."""
        known = self._kinds.get(record["kind"])
        if known is not None:
            known(record)

    def plan(self, agent: str) -> Plan | None:
        """The plan that an agent follows."""
        return self._plan_of(self.members[agent].model)

    def plans(self) -> Iterator[tuple[str, Plan]]:
        """The agents with their plans."""
        found = ((name, self.plan(name)) for name in self.members)
        return ((name, plan) for name, plan in found if plan is not None)

    # ---- what is asked of it ------------------------------------------------------------------------

    def last_published(self, channel: str, agents: Collection[str]) -> Mapping[str, Record]:
        """The last message on a channel of each of these agents that has published one."""
        found = self.published.setdefault(channel, {})
        missing = set(agents) - found.keys() - self._searched.get(channel, frozenset())
        if missing:
            self._searched[channel] = self._searched.get(channel, frozenset()) | missing
            for line in self._earlier((f'"channel":"{channel}"',)):
                record = line.record
                if record["kind"] == "message" and record["agent"] in missing:
                    found[record["agent"]] = record
                    missing.discard(record["agent"])
                    if not missing:
                        break
        return found

    def last_sent(self, kind: tuple[str, str], agent: str) -> Record | None:
        """The last agent message of a performative and message that an agent has sent."""
        found = self.sent.setdefault(kind, {})
        if agent not in found:
            for line in self._earlier((f'"performative":"{kind[0]}"',)):
                record = line.record
                if (
                    record["kind"] == "agent_message"
                    and record["agent"] == agent
                    and record["message"] == kind[1]
                ):
                    found[agent] = record
                    break
        return found.get(agent)

    def refused(self, agent: str, record: Record) -> Record | None:
        """The line that says why an agent did not take an agent message, given by that of its sending."""
        identity = record["agent"], record["sequence"]
        if (agent, identity) not in self._refused and record["time"] <= self.begin:
            self._look_for(agent, identity)
        return self._refused.get((agent, identity))

    def has_received(self, agent: str, record: Record) -> bool:
        """Whether an agent has got a message, given by the line of its sending."""
        identity = record["agent"], record["sequence"]
        received = self._received.setdefault(agent, set())
        if identity not in received and record["time"] <= self.begin:
            self._look_for(agent, identity)
        return identity in received

    def pending(self, agent: str, sent: Sent, name: str) -> Record | None:
        """The last agent message of another one to an agent, if it is still under way."""
        record = self.last_sent(sent, name)
        if record is None or agent not in record["to"]:
            return None
        is_over = self.has_received(agent, record) or self.refused(agent, record) is not None
        return None if is_over else record

    def _look_for(self, agent: str, identity: Identity) -> None:
        """Look further up for what has become of a message."""
        text = f"[{json.dumps(identity[0], ensure_ascii=False)},{identity[1]}]"
        for line in self._earlier((text,)):
            record = line.record
            if record.get("agent") != agent:
                continue
            if record["kind"] == "step":
                self._received.setdefault(agent, set()).add(identity)
                return
            if record["kind"] == "unexpected":
                self._refused[agent, identity] = record
                return

    def place(self, agent: str) -> tuple[str, ...]:
        """The active leaves of an agent."""
        member = self.members[agent]
        if not member.configuration:
            for line in self._earlier((f'"agent":"{agent}","step"',)):
                if "configuration" in line.record:
                    member.configuration = tuple(line.record["configuration"])
                    break
        return member.configuration

    def began(self, agent: str, label: str) -> int | None:
        """When the activity of an active state was started."""
        since = self.members[agent].since
        if label not in since:
            for line in self._earlier((f'"label":"{label}"',)):
                record = line.record
                if record["kind"] == "activity" and record["agent"] == agent and record["what"] == "start":
                    since[label] = record["time"]
                    break
        return since.get(label)

    # ---- lines -------------------------------------------------------------------------------------

    def _header(self, record: Record) -> None:
        for item in agents_of(record):
            self.members[item["name"]] = Member(item.get("role", ""), item.get("model", ""))

    def _step(self, record: Record) -> None:
        member = self.members[record["agent"]]
        received = self._received.setdefault(record["agent"], set())
        received.update(identity_of(item) for item in (*record["inputs"], *record.get("ahead", ())))
        member.configuration = tuple(record.get("configuration", member.configuration))
        following = self._followed(member)
        if following is None:
            return
        if record["step"] == 1:
            following = member.following = Following(following.shape)
            member.since = dict.fromkeys(following.begin().entered, record["time"])
        for way in record["taken"]:
            entered = following.take(tuple(way["transitions"])).entered
            member.since.update(dict.fromkeys(entered, record["time"]))
        if not following.active.issuperset(member.configuration):
            following.stand(member.configuration)

    def _followed(self, member: Member) -> Following | None:
        if member.following is None:
            plan = self._plan_of(member.model)
            if plan is not None:
                member.following = Following(Shape(plan))
                member.following.stand(member.configuration)
        return member.following

    def _changed(self, record: Record) -> None:
        member = self.members.get(record.get("agent", ""))
        if member is not None and "model" in record and record.get("what", "done") == "done":
            member.model = record["model"]
            member.following = None
            member.since = {}

    def _published(self, record: Record) -> None:
        self.published.setdefault(record["channel"], {})[record["agent"]] = record

    def _sent(self, record: Record) -> None:
        kind = record["performative"], str(record["message"])
        self.sent.setdefault(kind, {})[record["agent"]] = record

    def _unexpected(self, record: Record) -> None:
        self._refused[record["agent"], identity_of(record["input"])] = record

    def _trouble(self, record: Record) -> None:
        if "channel" in record:
            self.troubles[record["channel"], record.get("peer", record["agent"])] = record

    def _life(self, record: Record) -> None:
        is_down = record["what"] == "crash"
        self.members[record["agent"]].over = f"it crashed at {shown(record['time'])}" if is_down else ""

    def _error(self, record: Record) -> None:
        self.members[record["agent"]].over = record["reason"]


__all__ = ["Member", "Past"]
