"""Searches: those of one team, in the time that there is for them."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from time import process_time
from typing import ParamSpec, Protocol, TypeVar

from aseme_dsl.play.scenario import Script
from aseme_dsl.project.proving.judging import Judge, Times
from aseme_dsl.project.proving.results import Bounds, Result, Verdict
from aseme_dsl.project.proving.scopes import Scope
from aseme_dsl.proofs.explore.apart import first_of
from aseme_dsl.proofs.explore.deciding.order import Unanswerable
from aseme_dsl.proofs.explore.needed import Asked, Needed
from aseme_dsl.proofs.explore.search import Graph, Limits

ALONE = ("deadlock", "failures")
"""The questions that each agent can answer for itself."""
EACH_ALONE = "each agent among others that may do anything"
"""What was explored to answer them."""
APART = "regions that do not meet apart"
"""How, if it was done for groups of regions."""

P = ParamSpec("P")
T = TypeVar("T")


class Purse:
    """The time of all searches of a scope. What becomes of their results takes none of it."""

    def __init__(self, limits: Limits, least: float, lender: Purse | None = None) -> None:
        """What one search is allowed, with the seconds of all of them. A search gets the `least` seconds at
        least, as those before it may take longer than their parts. The time is that of the `lender`, too."""
        self._limits = limits
        self._least = least
        self._left = limits.seconds
        self._lender = lender

    def share(self, parts: float) -> Limits:
        """What is left, divided by so many: who needs less leaves more to those that come later."""
        return replace(self._limits, seconds=max(self._least, self._left / parts))

    def part(self, parts: float) -> Purse:
        """The same for searches that belong together."""
        return Purse(self.share(parts), self._least, self)

    @property
    def of_one(self) -> Limits:
        """All that is left, for a search of one agent: its states are small, but each may have many moves."""
        states = self._limits.states
        return replace(self.share(1), states=3 * states, moves=100 * states)

    def spend(self, search: Callable[P, T], *arguments: P.args, **named: P.kwargs) -> T:
        """What a search finds."""
        before = process_time()
        found = search(*arguments, **named)
        self._pay(process_time() - before)
        return found

    def _pay(self, seconds: float) -> None:
        self._left -= seconds
        if self._lender is not None:
            self._lender._pay(seconds)


class Searching(Protocol):
    """One search, see `prove._searched`."""

    def __call__(
        self,
        scope: Scope,
        script: Script | None,
        limits: Limits,
        *,
        about: Asked | None = None,
        times: Times | None = None,
        numbers: Sequence[float] | None = (),
        still: frozenset[str] = frozenset(),
        others: frozenset[str] = frozenset(),
        group: int | None = None,
        apart: Sequence[Needed] = (),
        before: Judge | None = None,
    ) -> Judge | None: ...


_OF_ALL = 2
"""A search of all agents gets this part of the time, if others may come after it."""
_LAST = 5
"""So many parts of the time are left to those of one agent each, behind the long runs."""


def in_parts(
    purse: Purse,
    searched: Searching,
    scope: Scope,
    script: Script | None,
    *,
    about: Asked | None = None,
    times: Times | None = None,
    numbers: Sequence[float] | None = (),
) -> Judge | None:
    """A search; if it was cut, then also some in which only the first agents of each role move, and long runs
    of all, unless it is `about` one question. Where these leave something unreached, first agents make long
    runs, too.

    Not with times: then agents have to move in time. Nor with further numbers: these are tried where all do.
    """

    def search_one(
        limits: Limits,
        still: frozenset[str] = frozenset(),
        before: Judge | None = None,
    ) -> Judge | None:
        search = partial(searched, about=about, times=times, numbers=numbers, still=still, before=before)
        return purse.spend(search, scope, script, limits)

    is_plain = times is None and numbers == ()
    few = first_of(scope.team) if is_plain else ()
    stills = [frozenset(name for name, _ in scope.team if name not in names) for names in few]
    runs = [frozenset[str](), *stills] if is_plain and about is None else []
    judge = search_one(purse.share(_OF_ALL if stills or runs else 1))
    if judge is None or not judge.is_open:
        return judge
    last = len(runs) + _LAST if runs else 0
    for number, still in enumerate(stills):
        part = search_one(purse.share(len(stills) - number + last), still)
        assert part is not None
        judge.parts = (*judge.parts, part)
        if part.has_all:
            return judge
    for number, still in enumerate(runs):
        left = judge.left(Graph())
        if judge.has_enough(Graph(), left) or (still and not left):
            break
        part = search_one(purse.share(last - number), still, before=judge)
        assert part is not None
        judge.parts = (*judge.parts, part)
    return judge


def among_others(
    purse: Purse,
    searched: Searching,
    scope: Scope,
    results: Sequence[Result],
    asked: Sequence[str],
    kinds: Mapping[str, object],
) -> Iterator[Result]:
    """The answers, also to questions that each agent answers by itself as others change nothing. Of agents
    that are of one of the `kinds`, the first one stands for all."""
    left = {
        item.name
        for item in results
        if item.is_built_in and item.name in ALONE
        if item.verdict is Verdict.UNDECIDED and (not asked or item.name in asked)
    }
    found: list[Judge] = []
    for judge in _each_alone(purse, searched, scope, kinds) if left else ():
        left &= frozenset() if judge is None else judge.kept_alone()
        if judge is None or not left:
            break
        found.append(judge)
    bounds = [judge.bounds() for judge in found]
    how = (EACH_ALONE,) if len(scope.team) > 1 else ()
    if any(judge.is_apart for judge in found):
        how = (*how, APART)
    for item in results:
        if item.is_built_in and item.name in left:
            parts = dict.fromkeys(part for some in bounds for part in some.parts)
            states = sum(some.states or 0 for some in bounds)
            within = Bounds(scope.agents, (*parts, *how), states)
            item = replace(item, verdict=Verdict.PROVED, bounds=within, reason="")
        yield item


def _each_alone(
    purse: Purse, searched: Searching, scope: Scope, kinds: Mapping[str, object]
) -> Iterator[Judge | None]:
    """The searches of one agent of each kind, by groups of its regions; None where something is left out."""
    for agent in {kinds[name]: name for name, _ in reversed(scope.team)}.values():
        others = frozenset(name for name, _ in scope.team if name != agent)
        group, apart = 0, tuple[Needed, ...]()
        while group == 0 or group < len(apart):
            judge = purse.spend(_of_all_numbers, searched, scope, others, purse.of_one, group, apart)
            yield judge
            group, apart = group + 1, () if judge is None else judge.apart


def _of_all_numbers(
    searched: Searching,
    scope: Scope,
    others: frozenset[str],
    limits: Limits,
    group: int,
    apart: Sequence[Needed],
) -> Judge | None:
    """A search of one agent, in which numbers may be any. If it asks more of one than how it compares, a few
    are tried; there is no answer if these do not stand for all."""
    try:
        return searched(scope, None, limits, others=others, group=group, apart=apart, numbers=None)
    except Unanswerable:
        judge = searched(scope, None, limits, others=others, group=group, apart=apart)
        return None if judge is None or judge.is_of_few else judge


__all__ = ["EACH_ALONE", "Purse", "Searching", "among_others", "in_parts"]
