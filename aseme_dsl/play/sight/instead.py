"""Instead: what was said, or could not be said, instead of the messages that conditions speak of."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping

from aseme_dsl.play.evaluate import Known, Told
from aseme_dsl.play.followed import Followed
from aseme_dsl.play.scenario import InPlaces, Says
from aseme_dsl.play.sight.guards import unmet
from aseme_dsl.play.sight.story import agents_text
from aseme_dsl.play.sight.words import Said, few, leaf_names
from aseme_dsl.runtime.chart.plan import Plan
from aseme_dsl.runtime.message.acl import NOT_UNDERSTOOD
from aseme_dsl.runtime.time.clock import readable

_INSTEAD = {
    "accept_proposal": ("reject_proposal", "cancel"),
    "agree": ("refuse", "failure", NOT_UNDERSTOOD),
    "confirm": ("disconfirm", "refuse", "failure", NOT_UNDERSTOOD),
    "inform": ("refuse", "failure", NOT_UNDERSTOOD),
    "propose": ("refuse", NOT_UNDERSTOOD),
}
"""What is said instead of an answer."""
_REFUSALS = frozenset(act for acts in _INSTEAD.values() for act in acts)


class Instead:
    """Collects it from a run."""

    def __init__(self) -> None:
        self.near: dict[int, tuple[str, Said]] = {}
        """By condition: who sent or received the last message that only its filter has refused."""
        self._refusals: dict[tuple[str, bool], Said] = {}
        """What has last been said by an agent, or (True) to it, that ends or refuses something."""
        self._unsent: dict[str, tuple[str, int, str]] = {}
        """The last message that an agent could not send: what, when (ns), and why."""

    def sent(self, said: Said, receivers: Iterable[str]) -> None:
        """An agent has sent a message."""
        if said.performative in _REFUSALS:
            self._refusals[said.sender, False] = said
            self._refusals.update(((name, True), said) for name in receivers)

    def failed(self, agent: str, reason: str, now: int) -> None:
        """An agent could not do something, perhaps send a message."""
        what, is_unsent, why = reason.partition(" is not sent: ")
        if is_unsent:
            self._unsent[agent] = what, now, why

    def told(
        self, number: int, condition: Says, since: int, known: Callable[[str, Told], Known]
    ) -> Iterator[str]:
        """Which messages came with other values, could not be sent, or refused, since a moment (ns).

        `number` is that of the condition, and `known` what an agent knows beside a content.
        """
        if number in self.near and condition.condition is not None:
            agent, said = self.near[number]
            verb = "received" if condition.is_received else "sent"
            parts = unmet(condition.condition, known(agent, said.content))
            if parts:
                yield f"{agent} {verb} {said.what} at {readable(said.moment)}, but {parts}"
            return
        for name, (what, moment, reason) in self._unsent.items():
            if what == f"{condition.performative} {condition.what}":
                yield f"{name} could not send it at {readable(moment)}: {reason}"
        instead = _INSTEAD.get(condition.performative or "", ())
        for (name, is_to), said in sorted(self._refusals.items(), key=lambda item: item[1].moment):
            is_meant = condition.agents is None or name in condition.agents
            is_instead = said.performative in instead and said.kind == condition.what
            if is_meant and is_instead and is_to == condition.is_received and said.moment >= since:
                to = f" to {name}" if is_to else ""
                yield f"{said.sender} sent {said.what}{to} at {readable(said.moment)}"


def located(
    condition: InPlaces, plans: Callable[[str], Plan], agents: Mapping[str, Followed]
) -> Iterator[str]:
    """Where the agents are of which a condition speaks."""
    found: dict[str, list[str]] = {}
    for name, labels in condition.places.items():
        plan, followed = plans(name), agents[name]
        beside = {
            leaf
            for leaf in followed.leaves
            if leaf in plan.by_label and all(plan.are_concurrent(leaf, label) for label in labels)
        }
        leaves = [leaf for leaf in followed.leaves if leaf not in beside] or followed.leaves
        found.setdefault(few(leaf_names(plan, leaves)) or "no state", []).append(name)
    for inside, names in found.items():
        yield f"{agents_text(names)} {'is' if len(names) == 1 else 'are'} in {inside}"


__all__ = ["Instead", "located"]
