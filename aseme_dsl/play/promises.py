"""Promises: what activities guarantee of the messages that they publish, and whether a run keeps it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from aseme_dsl.amola.messages import Channel
from aseme_dsl.amola.srm import Guarantee, Sent
from aseme_dsl.play.evaluate import Known, Told, value_of
from aseme_dsl.play.scenario import Breached, Condition
from aseme_dsl.play.sight.words import content_of
from aseme_dsl.runtime.time.clock import readable


class Promises:
    """Remembers what activities have published, as long as a guarantee speaks of it; also across restarts."""

    def __init__(self, conditions: Sequence[Condition]) -> None:
        self._all = {number: item for number, item in enumerate(conditions) if isinstance(item, Breached)}
        self._earlier: dict[tuple[int, str], list[tuple[int, Told]]] = {}
        """What an agent has published, by the number of the guarantee, with its moments (ns)."""
        self.said: dict[int, str] = {}
        """What has broken a guarantee, for readers."""

    def see(
        self, agent: str, activity: str | None, channel: str, content: Told, moment: int
    ) -> frozenset[int]:
        """An activity publishes a message; the conditions that say that it has broken a guarantee."""
        return frozenset(
            number
            for number, item in self._all.items()
            if item.activity == activity and self._breaks(number, item, agent, channel, content, moment)
        )

    def _breaks(
        self, number: int, item: Breached, agent: str, channel: str, content: Told, moment: int
    ) -> bool:
        promise, text = item.guarantee, ""
        said, earlier = promise.said, promise.earlier
        if earlier is None or promise.within is None:
            if is_on(said, channel) and is_so(promise, content, None) is True:
                text = f"{item.activity} publishes {_told(said, content, moment)}"
        else:
            held = self._earlier.setdefault((number, agent), [])
            while held and held[0][0] + promise.within < moment:
                held.pop(0)
            for then, other in held if is_on(said, channel) else ():
                if is_so(promise, content, other) is True:
                    now, before = _told(said, content, moment), _told(earlier, other, then)
                    text = f"{item.activity} publishes {now}, after {before}"
                    break
            if is_on(earlier, channel):
                held.append((moment, content))
        if text:
            self.said[number] = text
        return bool(text)


def _told(sent: Sent, content: Told, moment: int) -> str:
    return f"{sent.message}{content_of(content)} at {readable(moment)}"


def is_on(sent: Sent, channel: str | Channel) -> bool:
    """Whether a message on a channel is meant."""
    return str(channel) in map(str, sent.channels)


def is_so(promise: Guarantee, said: Told, earlier: Told | None) -> object:
    """Whether messages, one behind the other, are what a guarantee excludes; None if that is not known."""
    known: Mapping[str, object] = {promise.said.called: said}
    sents = [promise.said]
    if promise.earlier is not None:
        known = {**known, promise.earlier.called: earlier}
        sents.append(promise.earlier)
    found = [
        True if item.condition is None else value_of(item.condition, Known(inputs=known)) for item in sents
    ]
    if False in found:
        return False
    return None if None in found else True


__all__ = ["Promises", "is_on", "is_so"]
