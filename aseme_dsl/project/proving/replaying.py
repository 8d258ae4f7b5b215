"""Replaying: whether a run that a search has found happens on what runs on a robot."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from aseme_dsl import outside
from aseme_dsl.amola.system import System
from aseme_dsl.compiler.phases import inspect_files, scenarios_of
from aseme_dsl.diagnostics import Severity, in_order
from aseme_dsl.grammar.layout.adding import titled_apart
from aseme_dsl.play.run import NotPlayable, Played, play
from aseme_dsl.play.scenario import GUARANTEE, Expectation, Scenario
from aseme_dsl.play.sight.guards import Guards
from aseme_dsl.project.building.build import choose, with_labels
from aseme_dsl.project.building.project import configuration_for, options_of
from aseme_dsl.project.proving.counterexample import Run, Types, scenario_of
from aseme_dsl.proofs.explore.explored import Explored
from aseme_dsl.proofs.explore.memory import Picture
from aseme_dsl.proofs.explore.retrace import NotRetraced, retrace
from aseme_dsl.proofs.explore.search import Step
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.version.loading import Loaded
from aseme_dsl.source import Source

SEED = 1


@dataclass(frozen=True, slots=True)
class Replay:
    """The scenario of a run, and how it went; or why there is none: it does not happen."""

    text: str = ""
    problem: str = ""
    scenario: Scenario | None = None
    played: Played | None = None


def written(
    explored: Explored,
    first: Picture,
    steps: Sequence[Step],
    run: Run,
    system: System,
    moments: Sequence[int] | None = None,
) -> Replay:
    """The scenario of a run, which is not played yet; with these moments of its moves, if they are known."""
    variables = {
        agent.name: {item.name.partition("@")[0]: item.type for item in agent.plan.variables}
        for agent in explored.agents
    }
    members = {item.name: {member.name: member.type for member in item.fields} for item in system.messages}
    types = Types(variables, members)
    try:
        return Replay(scenario_of(run, retrace(explored, first, steps, moments), types))
    except NotRetraced as problem:
        return Replay(problem=str(problem))


def played(
    root: Path | Source, found: Replay, loaded: Loaded, of: Expectation | None, system: System
) -> Replay:
    """A scenario as it went with the files of `root`. There is a problem unless it breaks an expectation:
    that which it is `of`, if there is one, or one of its own. Its story needs the `system`."""
    source = root if isinstance(root, Source) else Source(str(root), outside.read_text(root))
    whole = Source(source.path, f"{source.text}\n{titled_apart(source.text, found.text)}")
    configuration, _ = configuration_for(Path(source.path))
    inspection = inspect_files(whole, None, options_of(configuration))
    diagnostics = in_order(inspection.analysis.diagnostics)
    wrong = next((item for item in diagnostics if item.severity is Severity.ERROR), None)
    if wrong is not None:
        return replace(found, problem=f"{wrong.message}: `{_line(wrong.span)}`")
    scenario = scenarios_of(inspection, {})[-1]
    if scenario.refused is not None and not scenario.scripts:  # otherwise that is a property
        return replace(found, problem=f"{scenario.refused.reason}: `{_line(scenario.refused.span)}`")
    (script,) = scenario.scripts
    labelled = with_labels(system, choose(configuration).labels)
    guards = Guards({chart.name: chart for chart in labelled.iacs}, labelled.activities, labelled.messages)
    kept = tuple(item for item in script.expectations if _is(item, of) or item.of.startswith(GUARANTEE))
    try:
        run = play(
            loaded,
            replace(script, expectations=kept),
            SEED,
            {},
            lambda activity: None,
            script.until,
            guards=guards,
            is_whole=True,
        )
    except NotPlayable as problem:
        return replace(
            found, problem=f"{problem}{'' if problem.span is None else f': `{_line(problem.span)}`'}"
        )
    if run.broken is None:
        failed = "; ".join(f"{name} fails: {why}" for name, why in run.failures.items())
        return replace(found, problem=failed or "in it, all is as it should be")
    broken = kept[run.broken]
    if broken.of.startswith(GUARANTEE):
        return replace(found, problem=f"it breaks `{_line(broken.span)}`")
    if run.assumption is not None:
        return replace(found, problem=f"it breaks `{_line(run.assumption[0].span)}`")
    return replace(found, scenario=scenario, played=run)


def _is(item: Expectation, of: Expectation | None) -> bool:
    if of is None or not item.of:
        return not item.of
    return (item.of, item.span.text) == (of.of, of.span.text)


def _line(span: object) -> str:
    text = getattr(span, "text", "")
    return " ".join(str(text).split())


__all__ = ["Replay", "played", "written"]
