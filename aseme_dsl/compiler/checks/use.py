"""Use: what a system without errors says and nothing uses, or uses and nothing says."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from aseme_dsl.amola.aip import Aip
from aseme_dsl.amola.srm import Activity, Srm
from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.compiler.chart.flow import check_completion
from aseme_dsl.compiler.checks.leftovers import LeftOut, check_leftovers
from aseme_dsl.compiler.checks.message_life import check_life
from aseme_dsl.compiler.checks.message_use import message_use
from aseme_dsl.compiler.checks.presence import check_presence
from aseme_dsl.compiler.checks.signal_readers import check_signals, check_stale
from aseme_dsl.compiler.control.repeated_lines import check_repeated_lines
from aseme_dsl.compiler.names.symbols import Symbols
from aseme_dsl.compiler.read.memory import Memory
from aseme_dsl.compiler.read.pieces import InPieces
from aseme_dsl.diagnostics import Diagnostic, Problem
from aseme_dsl.diagnostics.problems.use import VariableNotRead
from aseme_dsl.grammar.text import tree
from aseme_dsl.source import Span


def check_use(
    roles: Sequence[Statechart],
    protocols: Sequence[Statechart],
    played: tuple[Sequence[Aip], Sequence[Srm]],
    activities: Mapping[str, Activity],
    written: Sequence[tree.Activity],
    asked: frozenset[str],
    symbols: Symbols,
    memory: Memory,
) -> InPieces[tuple[Diagnostic, ...]]:
    """Messages, signals, timers and variables over their lifetime, in the charts of the roles.

    What protocols read and publish counts as read and published, whether a role plays them or not. `played`
    are all protocols, and the roles with what they play. `asked` are the words of scenarios and properties.
    """
    use = yield from message_use((*roles, *protocols), activities, written, symbols, memory)
    modules = {item.name: item.statement for chart in roles for item in chart.modules}
    activities = {**activities, **modules}
    found = [*(yield from check_life(roles, use, activities, symbols, memory))]
    left_out = _left_out(*played)
    for problems in (yield from memory.each_in_pieces(check_stale, zip(roles), use, activities, symbols)):
        found += problems
    for problems in (yield from memory.each_in_pieces(_in_chart, zip(roles), activities, symbols, left_out)):
        found += (item for item in problems if not _is_asked(item.problem, asked))
    return tuple(found)


def _is_asked(problem: Problem, asked: frozenset[str]) -> bool:
    return isinstance(problem, VariableNotRead) and problem.variable in asked


def _in_chart(
    chart: Statechart, activities: Mapping[str, Activity], symbols: Symbols, left_out: LeftOut
) -> tuple[Diagnostic, ...]:
    return (
        *check_signals(chart, activities, symbols),
        *check_presence(chart, activities, symbols),
        *check_leftovers(chart, activities, left_out),
        *check_completion(chart),
        *check_repeated_lines(chart),
    )


def _left_out(aips: Sequence[Aip], srms: Sequence[Srm]) -> LeftOut:
    """The results that a role, or a participant around, does not take where it plays a participant."""
    found: dict[tuple[str, str, str, str], Span] = {}
    nested = [("", item) for aip in aips for part in aip.participants for item in part.plays]
    known = {(aip.name, part.name): part for aip in aips for part in aip.participants}
    for player, item in (*nested, *((srm.name, item) for srm in srms for item in srm.plays)):
        part = known.get((item.protocol, item.participant))
        for result in part.results if part is not None else ():
            if result not in dict(item.results):
                found[player, item.protocol, item.participant, result] = item.span
    return found


__all__ = ["check_use"]
