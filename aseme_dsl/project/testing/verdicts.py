"""Verdicts: what the runs of a scenario have shown."""

from __future__ import annotations

import shlex
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import field, replace
from enum import StrEnum
from pathlib import Path

from aseme_dsl.play.run import Played
from aseme_dsl.play.scenario import Scenario
from aseme_dsl.play.sight.story import Happened
from aseme_dsl.project.testing.cases import Case
from aseme_dsl.project.testing.reasons import broken
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.monitor.rules import Verdict as Shown
from aseme_dsl.runtime.time.clock import at_text, readable
from aseme_dsl.source import Span


class Verdict(StrEnum):
    """The verdicts, of which the first that applies counts."""

    ERROR = "error"
    FAILED = "failed"
    VACUOUS = "vacuous"
    PASSED = "passed"


@dataclass(frozen=True, slots=True)
class ScenarioResult:
    """The verdict on a scenario, with its first seed, and the time (ns) of the run in question.

    `span` is the place of the reason, `given` are the inputs of the run, `story` is what happened last.
    """

    name: str
    verdict: Verdict
    seed: int
    time_ns: int
    reason: str = ""
    span: Span | None = None
    given: Mapping[str, object] | None = None
    story: tuple[Happened, ...] = ()
    team: tuple[tuple[str, str], ...] = ()
    """The agents with their roles."""
    runs: int = 0
    points: int | None = None
    """What a teacher gives for it if it passes."""
    dropped: tuple[Span, ...] = ()
    """The stimuli without which it fails, too."""
    shrunk: str = ""
    """The smaller scenario that fails, if one was made."""
    general: tuple[tuple[str, Span, bool], ...] = ()
    """What properties and clauses say, and whether what each speaks of has happened in some run."""
    row: Mapping[str, str] = field(default_factory=dict)
    """What the row of the table gives its columns with which it failed."""
    question: str = ""
    """The command that asks about a trace of the run why it failed, without the name of the trace."""
    trace: Path | None = None
    """The trace of the run, if it was written."""
    place: int = 0
    """Which of the runs it is about."""
    is_steady: bool = True
    """Whether a second run with the same seed and inputs has come to the same."""


@dataclass(frozen=True, slots=True)
class NotRun:
    """A run that could not be made, and why."""

    reason: str
    span: Span | None = None


def verdict_of(scenario: Scenario, cases: Sequence[Case], runs: Sequence[Played | NotRun]) -> ScenarioResult:
    """The one verdict on a scenario."""
    if (refused := scenario.refused) is not None:
        return _result(scenario, Verdict.ERROR, cases, 0, 0, refused.reason, refused.span)
    for place, run in enumerate(runs):
        if isinstance(run, NotRun):
            return _result(scenario, Verdict.ERROR, cases, place, 0, run.reason, run.span or scenario.span)
    played = [run for run in runs if isinstance(run, Played)]
    for place, run in enumerate(played):
        if run.broken is not None:
            item = scenario.scripts[cases[place].script].expectations[run.broken]
            reason = broken(item, scenario.scripts[cases[place].script], run)
            if run.assumption is not None and run.assumption[1] <= run.end:
                assumed, since = run.assumption
                reason = f"assumption broken at {readable(since)} ({assumed.span}): {reason}"
            if item.of:
                reason = f"{item.of}: {reason}"
            failed = _result(scenario, Verdict.FAILED, cases, place, run.end, reason, item.span, run.inputs)
            return replace(failed, row=scenario.scripts[cases[place].script].cells, question=_question(run))
    found = _missed_share(scenario, cases, played) or _vacuous(scenario, cases, played)
    if found is None:
        found = _result(scenario, Verdict.PASSED, cases, 0, played[0].end if played else 0)
    return replace(found, general=tuple(_general(scenario, played)))


def _general(scenario: Scenario, runs: Sequence[Played]) -> Iterator[tuple[str, Span, bool]]:
    """What properties and clauses say, and whether it was about something."""
    for item in scenario.scripts[0].expectations if scenario.scripts else ():
        if item.of:
            yield item.of, item.span, any(run.met.issuperset(item.witnesses) for run in runs)


def never_met(results: Sequence[ScenarioResult]) -> tuple[tuple[str, Span], ...]:
    """The properties and clauses that were about nothing in any run, with their statements."""
    spoken: dict[tuple[str, Span], bool] = {}
    for result in results:
        for of, span, was_met in result.general:
            spoken[of, span] = was_met or spoken.get((of, span), False)
    return tuple(what for what, was_met in spoken.items() if not was_met)


def _result(
    scenario: Scenario,
    verdict: Verdict,
    cases: Sequence[Case],
    place: int,
    time: int,
    reason: str = "",
    span: Span | None = None,
    given: Mapping[str, object] | None = None,
) -> ScenarioResult:
    seed = cases[place].seed if cases else 0
    team = scenario.scripts[0].team if scenario.scripts else ()
    return ScenarioResult(
        scenario.name,
        verdict,
        seed,
        time,
        reason,
        span,
        given,
        team=team,
        runs=len(cases),
        points=scenario.points,
        place=place,
    )


def _question(run: Played) -> str:
    """The command that asks about the trace of a run why its expectation was broken."""
    asked = run.question
    if asked is None:
        return ""
    at = at_text(run.end if asked.at is None else asked.at)
    return shlex.join(["asemec", "why" if asked.is_why else "whynot", asked.agent, asked.what, "--at", at])


def _missed_share(scenario: Scenario, cases: Sequence[Case], runs: Sequence[Played]) -> ScenarioResult | None:
    """What holds in too few of the runs."""
    for number, script in enumerate(scenario.scripts):
        mine = [place for place, case in enumerate(cases) if case.script == number]
        for which, item in enumerate(script.expectations):
            if item.share is None:
                continue
            first = [place for place in mine if cases[place].seed <= item.share.seeds]
            wrong = [place for place in first if runs[place].states[which].verdict is not Shown.KEPT]
            kept = len(first) - len(wrong)
            if kept < item.share.least:
                run = runs[wrong[0]]
                reason = f"so in {kept} of {len(first)} runs, not in {item.share.least}"
                return _result(
                    scenario,
                    Verdict.FAILED,
                    cases,
                    wrong[0],
                    run.states[which].at,
                    reason,
                    item.span,
                    run.inputs,
                )
    return None


def _vacuous(scenario: Scenario, cases: Sequence[Case], runs: Sequence[Played]) -> ScenarioResult | None:
    """What says nothing, because what it speaks of has happened in no run."""
    if not scenario.scripts:
        return None
    for item in scenario.scripts[0].expectations:
        if item.of:  # properties and clauses are looked at over all scenarios
            continue
        # The scripts of a table differ in values only: their conditions have the same numbers.
        if any(all(witness not in run.met for run in runs) for witness in item.witnesses):
            reason = "what it speaks of has not happened"
            return _result(scenario, Verdict.VACUOUS, cases, 0, runs[0].end, reason, item.span)
    return None


__all__ = ["NotRun", "ScenarioResult", "Verdict", "never_met", "verdict_of"]
