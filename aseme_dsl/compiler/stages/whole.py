"""Whole: what only a program without errors can be asked, as one missing line may be what is wrong."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from aseme_dsl.amola.srm import Activity
from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.compiler.chart.flow import check_timers
from aseme_dsl.compiler.checks.conditions import check_conditions, without_ordered
from aseme_dsl.compiler.checks.outcomes import check_deadlines
from aseme_dsl.compiler.checks.standing_still import check_standing_still
from aseme_dsl.compiler.checks.talk.busy import check_busy
from aseme_dsl.compiler.checks.talk.dialogue import check_multiplicity, check_waits
from aseme_dsl.compiler.checks.talk.moves import check_moves
from aseme_dsl.compiler.checks.talk.preparing import check_prepared
from aseme_dsl.compiler.checks.talk.races import check_races
from aseme_dsl.compiler.checks.unused import check_agents, check_exchange, check_unused
from aseme_dsl.compiler.checks.unwritten import check_unwritten
from aseme_dsl.compiler.checks.use import check_use
from aseme_dsl.compiler.checks.waking import check_lists, check_waking
from aseme_dsl.compiler.names.inclusion import Inclusion
from aseme_dsl.compiler.read.blocks import Blocks
from aseme_dsl.compiler.read.memory import Memory
from aseme_dsl.compiler.stages.charts import Charts
from aseme_dsl.compiler.stages.declarations import Declarations
from aseme_dsl.compiler.stages.found import Found, Stage
from aseme_dsl.compiler.stages.processes import Described, Processes
from aseme_dsl.compiler.stages.uses import Fulfilment
from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.grammar.text import tree
from aseme_dsl.proofs.prover import Prover


def check_whole(
    declared: Declarations,
    processes: Processes,
    described: Described,
    charts: Charts,
    fulfilment: Fulfilment,
    memory: Memory,
) -> Stage[int]:
    """How many choices were not compared, because z3 is not installed."""
    found, each = Found(), memory.each_in_pieces
    symbols, activities = declared.symbols, described.activities
    all_charts = (*charts.of_protocols, *charts.of_roles)
    for problems in (yield from each(_timers, zip(all_charts))):
        found.add(problems)
    found.add(check_deadlines(all_charts, activities))
    yield
    if symbols.system is not None and charts.are_complete:
        written = list(_statements(declared.blocks))
        played = (processes.aips, fulfilment.srms)
        # Variables that scenarios and properties ask for are read.
        asked = frozenset(
            word.text for file in declared.loaded.files for item in file.must_hold for word in item.words
        )
        use = check_use(
            charts.of_roles, charts.of_protocols, played, activities, written, asked, symbols, memory
        )
        found.add((yield from use))
    yield
    if symbols.system is not None:
        found.add(check_unused(declared.loaded.files, symbols, memory))
        too_few = list(check_multiplicity(processes.aips, fulfilment.srms, processes.teams))
        found.add(check_agents(_alone(declared.inclusion), symbols, too_few))
        found.add(check_exchange(declared.blocks.aips))
        waits = check_waits(processes.aips, charts.eacs, fulfilment.srms, activities, memory)
        found.add((yield from waits))
        races = check_races(processes.aips, charts.eacs, fulfilment.srms, memory)
        found.add((yield from races))
        found.add(check_moves(processes.aips, charts.eacs, fulfilment.srms, activities))
        found.add(check_prepared(processes.aips, charts.eacs))
        found.add(check_busy(processes.aips, charts.eacs, fulfilment.srms))
        found.add(too_few)
    yield
    settings = [
        (agent.role, name) for team in processes.teams for agent in team.agents for name, _ in agent.settings
    ]
    known = memory.same("settings", tuple(dict.fromkeys(settings)))
    if symbols.teams:  # without one, a program around a plain statechart may set them
        found.add(check_unwritten(charts.of_roles, fulfilment.srms, activities, known))
    for problems in (yield from each(_wakes, zip(charts.of_roles), activities, known, charts.prover)):
        found.add(problems)
    still = yield from each(_still, zip(all_charts), activities, charts.prover)
    found.add({item.span: item for problems in still for item in problems}.values())  # once a text
    compared, unchecked = yield from check_conditions(all_charts, charts.prover, memory)
    found.add(without_ordered(compared, (*declared.blocks.aips, *declared.blocks.roles)))
    return found.of(unchecked)


def _timers(chart: Statechart) -> tuple[Diagnostic, ...]:
    return tuple(check_timers(chart))


def _wakes(
    chart: Statechart,
    activities: Mapping[str, Activity],
    settings: tuple[tuple[str, str], ...],
    prover: Prover,
) -> tuple[Diagnostic, ...]:
    written = {name for role, name in settings if role == chart.name}
    performed = [activities[name] for node in chart.states if (name := node.activity or "") in activities]
    for activity in (*performed, *(module.statement for module in chart.modules)):
        written.update(activity.writes_variables)
    return (*check_waking(chart, frozenset(written), prover.vocabulary), *check_lists(chart))


def _still(chart: Statechart, activities: Mapping[str, Activity], prover: Prover) -> tuple[Diagnostic, ...]:
    return check_standing_still(chart, activities, prover)


def _statements(blocks: Blocks) -> Iterable[tree.Activity]:
    """What is said of activities and modules."""
    for block in blocks.roles:
        yield from block.activities
    for block in blocks.roles:
        yield from (module.activity for module in block.modules)


def _alone(inclusion: Inclusion) -> list[tree.Srm | tree.Statechart]:
    """The roles that are not part of another one: those that agents should have."""
    parts = {part.name.text for parts in inclusion.included.values() for part in parts}
    return [item for item in inclusion.blocks.roles if item.name.text not in parts]


__all__ = ["check_whole"]
