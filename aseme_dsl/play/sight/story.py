"""Story: what happened to agents, as people say it."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Mapping

from aseme_dsl.records import dataclass
from aseme_dsl.runtime.time.clock import shown

_LONGEST = 60
"""A longer content of a message is cut off (characters)."""


@dataclass(frozen=True, slots=True)
class Happened:
    """Something that happened to an agent, so many times by now. `at` is the place in the source.

    If the agent has sent a message, `sent` says which, `to` has the receivers, and `number` is that of the
    message. `peer` has sent what the agent receives.
    """

    moment: int
    agent: str
    text: str
    at: str = ""
    sent: str = ""
    to: tuple[str, ...] = ()
    number: int = 0
    peer: str = ""
    is_step: bool = False
    """Whether it is known only inside of the agent: a step, the end of an activity."""
    stands: bool = False
    """Whether it says where the agent is at the end."""
    times: int = 1

    @property
    def line(self) -> str:
        """What happened, and where it stands in the source."""
        often = f", {self.times} times by now" if self.times > 1 else ""
        return f"{self.text}{often}{f'  ({self.at})' if self.at else ''}"


def told(story: Iterable[Happened]) -> Iterator[str]:
    """A story as lines, with the names and times in columns."""
    all_ = tuple(story)
    times = [shown(item.moment) for item in all_]
    wide = max(map(len, times), default=0)
    names = max((len(item.agent) for item in all_), default=0)
    for item, time in zip(all_, times, strict=True):
        yield f"{time:>{wide}}  {item.agent:<{names}}  {item.line}"


def content_of(message: Mapping[str, object]) -> str:
    """` { n = 1 }`: the fields of a message that say something; nothing if none does."""
    said = ", ".join(
        f"{name} = {value if isinstance(value, str) else json.dumps(value, ensure_ascii=False)}"
        for name, value in message.items()
        if value not in ("", None, [], {})
    )
    if not said:
        return ""
    return f" {{ {said if len(said) <= _LONGEST else f'{said[: _LONGEST - 1]}…'} }}"


__all__ = ["Happened", "content_of", "told"]
