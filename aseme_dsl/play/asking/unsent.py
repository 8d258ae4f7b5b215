"""Unsent: why a message has not come: who sends it, where that agent is, and what has become of it."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from aseme_dsl.play.asking.changes import Coming
from aseme_dsl.play.asking.past import Past
from aseme_dsl.play.asking.reading import Reading
from aseme_dsl.play.asking.said import Back, Said, where
from aseme_dsl.play.asking.sending import Sent, places
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.inputs import LOST
from aseme_dsl.runtime.chart.plan import BranchInfo, Plan, is_in
from aseme_dsl.runtime.time.clock import shown
from aseme_dsl.runtime.trace.records import Record


@dataclass(frozen=True, slots=True)
class Unsent:
    """Says why an agent lacks messages."""

    agent: str
    plan: Plan
    past: Past
    back: Back

    # ---- channels --------------------------------------------------------------------------------

    def newer(self, item: Reading, now: int, is_aged: bool) -> Iterator[Said]:
        """Why there is no newer message of a sender, if there should be one."""
        name, channel = item.sender or "", item.channel or ""
        if name == self.agent or name not in self.past.members:
            return
        last = self.past.published.get(channel, {}).get(name)
        if last is not None and item.age is not None and last["time"] > now - item.age:
            yield Said(f"{name} has published another one at {shown(last['time'])}, {self._fate(last)}")
            yield from self._trouble(name, channel)
        elif is_aged:
            yield from self._sender(name, ("", channel), "publishes it")

    def absent(self, item: Reading) -> Iterator[Said]:
        """Why there is no message of a channel."""
        channel = item.channel or ""
        sent = ("", channel)
        senders = [name for name, plan in self.past.plans() if any(places(plan, sent))]
        wanted = [name for name in senders if item.host in (None, name)]
        published = self.past.last_published(channel, (*wanted, "input"))
        if self.agent in wanted and all(set(one.get("to", ())) <= {name} for name, one in published.items()):
            wanted = [self.agent]  # each publishes it for itself
        yield from _grouped((name, tuple(self._unpublished(name, channel))) for name in wanted)
        if not wanted:
            everywhere = "no role of the team publishes it: it comes from outside"
            yield Said(everywhere if item.host is None else f"{item.host} does not publish it")
        outside = published.get("input")
        if outside is not None and self.agent in outside.get("to", [self.agent]):
            yield Said(f"the last one from outside came at {shown(outside['time'])}")

    def _unpublished(self, name: str, channel: str) -> Iterator[Said]:
        last = self.past.published.get(channel, {}).get(name)
        if last is None:
            yield from self._sender(name, ("", channel), "has never published it")
        elif self.agent not in last.get("to", [self.agent]):
            yield Said(f"{name} published it at {shown(last['time'])}, but not to {self.agent}")
        else:
            yield Said(f"{name} published it last at {shown(last['time'])}, {self._fate(last)}")
        yield from self._trouble(name, channel)

    def _fate(self, record: Record) -> str:
        """What has become of a message on a channel."""
        if self.past.has_received(self.agent, record):
            return "and it was consumed, or dropped, since"
        return f"and {self.agent} has not received it yet"

    def _sender(self, name: str, sent: Sent, verb: str) -> Iterator[Said]:
        """Where an agent sends or publishes something, where it is, and why it does not."""
        plan = self.past.plan(name)
        found = [] if plan is None else list(places(plan, sent))
        modules = [item.called for item in found if item.is_module]
        if modules:
            yield Said(f"{name} {verb}; {' and '.join(modules)} does, and its code decides when")
        elsewhere = {item.label: item.called for item in found if not item.is_module}
        if elsewhere:
            told = ", ".join(dict.fromkeys(elsewhere.values()))
            text = f"{name} {verb}; it does in {told}, and {where(self.past, name, elsewhere)}"
            yield Said(text, () if name == self.agent else self.back(name, " ".join(filter(None, sent))))

    def _trouble(self, name: str, channel: str) -> Iterator[Said]:
        found = self.past.troubles.get((channel, self.agent)) or self.past.troubles.get((channel, name))
        if found is not None:
            what = found["kind"].replace("_", " ")
            yield Said(f"{what} at {shown(found['time'])}: {found['reason']}")

    # ---- agent messages --------------------------------------------------------------------------

    def pending(self, coming: Coming) -> Record | None:
        """The message that was sent already, and is still under way, or waits to be let in."""
        info = self._branch(coming)
        kind = coming.performative, coming.message
        names = () if info is None else self._senders(coming, info)
        found = (self.past.pending(self.agent, kind, name) for name in names)
        return next((record for record in found if record is not None), None)

    def message(self, coming: Coming) -> Said:
        """Why an agent message has not come."""
        if coming.performative == LOST:
            return Said(f"no {coming.participant} is lost")
        info = self._branch(coming)
        what = f"`{coming.performative} {coming.message}".strip() + f"` from {coming.participant}"
        pending = self.pending(coming)
        if info is None or pending is None:
            names = () if info is None else self._senders(coming, info)
            inside = tuple(_grouped((name, tuple(self._unsent(name, coming))) for name in names))
            return Said(f"{what} has not come, or was taken before", inside)
        sent = f"{pending['agent']} sent it at {shown(pending['time'])}"
        is_inside = any(is_in(leaf, info.label) for leaf in self.past.place(self.agent))
        if (coming.performative, coming.message) in info.opens and not is_inside:
            waits = f"it waits until {self.agent} enters {info.participant}"
        else:
            waits = f"{self.agent} has not received it yet"
        return Said(f"{what} has not come in yet", (Said(f"{sent}; {waits}"),))

    def _branch(self, coming: Coming) -> BranchInfo | None:
        return next((item for item in self.plan.branches if item.label == coming.branch), None)

    def _senders(self, coming: Coming, info: BranchInfo) -> Iterator[str]:
        """The other agents that may send an agent message."""
        kind = coming.performative, coming.message
        for name, plan in self.past.plans():
            plays = any(
                item.protocol == info.protocol
                and item.participant == coming.participant
                and kind in item.sends
                for item in plan.branches
            )
            if name != self.agent and plays:
                yield name

    def _unsent(self, name: str, coming: Coming) -> Iterator[Said]:
        """Why an agent has not sent an agent message, or what has become of it."""
        kind = coming.performative, coming.message
        last = self.past.last_sent(kind, name)
        if last is None:
            yield from self._sender(name, kind, "has never sent it")
            return
        sent = f"{name} sent it last at {shown(last['time'])}"
        refused = self.past.refused(self.agent, last)
        if self.agent not in last["to"]:
            yield Said(f"{sent}, to {', '.join(last['to']) or 'no agent'}")
        elif refused is None:
            yield Said(f"{sent}, and {self.agent} has taken it")
        else:
            when = shown(refused["time"])
            yield Said(f"{sent}, and {self.agent} refused it at {when}: {refused['reason']}")


def _grouped(told: Iterable[tuple[str, tuple[Said, ...]]]) -> Iterator[Said]:
    """What is said of some agents; where it is the same of several, once, with the names of the others."""
    known: dict[tuple[Said, ...], list[str]] = {}
    for name, said in told:
        known.setdefault(tuple(_without(item, name) for item in said), []).append(name)
    for said, (first, *others) in known.items():
        yield from (_with(item, first) for item in said)
        if others:
            yield Said(f"{', '.join(others)}: the same as {first}")


_NAME = "\0"
"""Stands for the name of an agent."""


def _without(said: Said, name: str) -> Said:
    text = re.sub(rf"\b{re.escape(name)}\b", _NAME, said.text)
    return Said(text, tuple(_without(item, name) for item in said.inside))


def _with(said: Said, name: str) -> Said:
    return Said(said.text.replace(_NAME, name), tuple(_with(item, name) for item in said.inside))


__all__ = ["Unsent"]
