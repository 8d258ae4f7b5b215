"""On the way: messages that come from one agent to another, and may have become old on their way."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import partial

from aseme_dsl.proofs.explore.deciding.choosing import Choices
from aseme_dsl.proofs.explore.surroundings import NOW, Underway
from aseme_dsl.proofs.timed.stamp import Window, standing, window
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.inputs import Sample
from aseme_dsl.runtime.message.acl import AclMessage
from aseme_dsl.runtime.time.clock import shown


@dataclass(frozen=True, slots=True)
class Came:
    """A message that comes: what gives it, and from when on it is how old, if that matters (ns)."""

    give: Callable[[], None]
    since: int = NOW
    least: int = 0
    until: int | None = None

    @property
    def window(self) -> Window | None:
        """When it comes."""
        return window(self.since, self.least, self.until)


@dataclass(frozen=True, slots=True)
class _Age:
    """How old a message is at the least (ns)."""

    age: int

    def __str__(self) -> str:
        return shown(self.age)


def come(item: Underway, ages: tuple[int, ...], choices: Choices) -> Came:
    """A message comes, to a reader for which it is another one from each of these ages on."""
    sample = sample_of(item)
    if not ages or sample is None or not isinstance(item.give, partial):
        return Came(item.give)
    answers = (None, *map(_Age, ages))
    chosen = choices.of(("age", item.what, item.identity), answers, "it is {} old when it comes")
    age = 0 if chosen is None else chosen.age
    until = next((limit - 1 for limit in ages if limit > age), None)
    give = partial(item.give.func, item.give.args[0], replace(sample, time=standing(sample.time, NOW - age)))
    return Came(give, sample.time, age, until)


def sample_of(item: Underway) -> Sample | None:
    """What is on its way, if it is a message of a topic."""
    given = item.give.args if isinstance(item.give, partial) else ()
    return next((part for part in given if isinstance(part, Sample)), None)


def letter_of(item: Underway) -> AclMessage | None:
    """The agent message that is on its way, if it is one."""
    given = item.give.args if isinstance(item.give, partial) else ()
    return next((part for part in given if isinstance(part, AclMessage)), None)


__all__ = ["Came", "come", "letter_of", "sample_of"]
