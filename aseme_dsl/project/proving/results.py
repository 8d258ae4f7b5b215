"""Results: what was asked of all runs, and what came of it."""

from __future__ import annotations

from collections.abc import Iterator
from enum import StrEnum

from aseme_dsl.play.sight.story import Happened
from aseme_dsl.proofs.wording import states_text
from aseme_dsl.records import dataclass
from aseme_dsl.source import Span

Key = tuple[str, str]
"""What an answer is about: its name, and the place of the statement, as a property may have several."""

BUILT_IN = ("deadlock", "orphan messages", "non-local choice", "agreement", "dead states", "failures")
"""The questions that are asked of every team, without being in a file."""


class Verdict(StrEnum):
    PROVED = "PROVED"
    REFUTED = "REFUTED"
    UNDECIDED = "UNDECIDED"


@dataclass(frozen=True, slots=True)
class Bounds:
    """How far an answer goes: for which agents, under what, and in how many states, if any were explored."""

    agents: str
    parts: tuple[str, ...] = ()
    states: int | None = None
    few: int = 0
    """So many more states of searches in which only some of the agents move."""
    long: int = 0
    """So many more states of long runs."""

    @property
    def text(self) -> str:
        """`1 initiator, 1 responder; any delay; 3366 states`."""
        return "; ".join((self.agents, *self.parts, *self._states()))

    def _states(self) -> Iterator[str]:
        if self.states is not None:
            few = [f"{self.few} in which only some agents move"] if self.few else []
            long = [f"{self.long} of long runs"] if self.long else []
            *others, last = (states_text(self.states), *few, *long)
            yield f"{', '.join(others)} and {last}" if others else last


@dataclass(frozen=True, slots=True)
class Case:
    """A counterexample that was played as a scenario.

    `roles` declares the roles that there are for it only. `story` is what happened, up to what `remark` says.
    """

    title: str
    roles: str
    text: str
    team: tuple[tuple[str, str], ...]
    story: tuple[Happened, ...]
    remark: str


@dataclass(frozen=True, slots=True)
class Result:
    """An answer. `of` is the team or the protocol, `bounds` say how far it goes.

    `counterexample` is a run in which it is not so, a line for each thing that happens.
    """

    name: str
    of: str
    verdict: Verdict
    bounds: Bounds
    reason: str = ""
    counterexample: tuple[str, ...] = ()
    span: Span | None = None
    is_built_in: bool = False
    case: Case | None = None
    """The counterexample as a scenario, if it is one."""
    is_abstract: bool = False
    """Whether a run was found that may be none of a team."""

    @property
    def key(self) -> Key:
        return self.name, "" if self.span is None else str(self.span)

    @property
    def text(self) -> str:
        """`PROVED  deadlock (protocol request): 1 initiator, 1 responder, 3366 states`."""
        place = f" ({self.span})" if self.span is not None else ""
        why = f": {self.reason}" if self.reason else ""
        return f"{self.verdict:<9} {self.name} of {self.of}{place}{why} [{self.bounds.text}]"

    @property
    def as_json(self) -> dict[str, object]:
        return {
            "name": self.name,
            "of": self.of,
            "verdict": str(self.verdict),
            "reason": self.reason,
            "bounds": self.bounds.text,
            "counterexample": list(self.counterexample),
            "scenario": None if self.case is None else self.case.roles + self.case.text,
            "at": None if self.span is None else str(self.span),
        }


__all__ = ["BUILT_IN", "Bounds", "Case", "Key", "Result", "Verdict"]
