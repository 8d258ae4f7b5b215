"""Moves: whether a protocol says which activity sends each message that no transition sends."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence

from aseme_dsl.amola.aip import Aip, Participant, answers_when_busy, plays_inside
from aseme_dsl.amola.srm import Activity, Srm
from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.codegen.moves import sent_by_abandon, sent_by_transitions, subchart_of
from aseme_dsl.compiler.checks.talk.dialogue import silent_activities
from aseme_dsl.compiler.read.library import is_of_library
from aseme_dsl.diagnostics import Diagnostic, Related
from aseme_dsl.diagnostics.problems.talk import SentByAnyActivity, SentByTransitionToo


def check_moves(
    aips: Sequence[Aip],
    eacs: Mapping[str, Statechart | None],
    srms: Sequence[Srm],
    activities: Mapping[str, Activity],
) -> Iterator[Diagnostic]:
    """E566 for a message that a transition sends and an activity shall; N755 where no activity is named."""
    plays = [item for srm in srms for item in plays_inside(srm.plays, aips)]
    busy = answers_when_busy(plays)
    for aip in aips:
        chart = eacs.get(aip.name)
        if chart is None or is_of_library(aip.span.source):
            continue
        received = {(item.performative, item.message) for part in aip.participants for item in part.receives}
        silent = silent_activities(chart, plays, activities)
        for part in aip.participants:
            answers = busy.get((aip.name, part.name), frozenset())
            yield from _messages(chart, part, received - answers, silent)


def _messages(
    chart: Statechart, part: Participant, received: Collection[tuple[str, str]], silent: Collection[str]
) -> Iterator[Diagnostic]:
    """N755 for a message that any activity may send; E566 for one that a transition sends as well.

    No N755 for a message that no participant receives (W524 reports it) or that a role answers while it is
    busy. If all activities are `silent`, none can send it (W556).
    """
    subchart = subchart_of(chart, part.name)
    if subchart is None:
        return
    sent = sent_by_transitions(chart, subchart.label)
    farewells = sent_by_abandon(chart, subchart.label)
    activities = tuple(
        dict.fromkeys(
            node.activity
            for node in chart.states
            if node.activity is not None
            and node.activity not in silent
            and chart.branch_of(node.label) == subchart.label
        )
    )
    for item in part.sends:
        said = f"{item.performative} {item.message}"
        action = sent.get((item.performative, item.message))
        is_asked = (item.performative, item.message) in received and not item.by
        farewell = (item.performative, item.message) in farewells
        if action is None and not farewell and is_asked and activities:
            fix = f"{said} by {activities[0]}" if len(activities) == 1 else None
            yield Diagnostic(SentByAnyActivity(part.name, said, activities), item.span, fix=fix)
        elif action is not None and item.by:
            related = (Related(action.span, "sent here"),)
            yield Diagnostic(SentByTransitionToo(said, item.by), item.span, related)


__all__ = ["check_moves"]
