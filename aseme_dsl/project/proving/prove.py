"""Prove: explore the teams of a system, and say what holds in all their runs."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory

from aseme_dsl.compiler.phases import inspect_files, watched_of
from aseme_dsl.diagnostics import Severity
from aseme_dsl.play.scenario import (
    Assumption,
    CrashesAssumed,
    DurationAssumed,
    Expectation,
    FailuresAssumed,
    NetworkAssumed,
    PaceAssumed,
    Script,
)
from aseme_dsl.project.building.build import choose
from aseme_dsl.project.building.project import Compiled, compile_root, options_of
from aseme_dsl.project.playing.operate import generate_version, loaded_for
from aseme_dsl.project.proving.judging import Judge
from aseme_dsl.project.proving.results import Result, Verdict
from aseme_dsl.project.proving.scopes import Scope, scopes_of
from aseme_dsl.project.proving.watched import Watched, layout_of, named, names_in
from aseme_dsl.proofs.explore.explored import Assumed, Explored
from aseme_dsl.proofs.explore.search import Eyes, Limits, search
from aseme_dsl.runtime.trace.trace import Listener


class NotThere(Exception):
    """Nothing is called as something that was asked for; the text lists what there is."""


def prove(
    compiled: Compiled,
    asked: Sequence[str],
    robots: int,
    limits: Limits,
    told: Callable[[str], None] = lambda text: None,
) -> tuple[Result, ...]:
    """What holds in all runs of a system without errors; `asked` are names of what to answer, all if none.

    With `robots` agents of each role, and of each participant, that has several. `told` hears what is done.

    Raises:
        NotThere: nothing is called as one of `asked`; the text lists what there is.
        OperateError, LoadError: the code of the system cannot be made.
    """
    assert compiled.system is not None
    found: list[Result] = []
    for scope in scopes_of(compiled.root, compiled.system, robots):
        told(f"exploring the {scope.what}")
        found += _explored(scope, compiled, limits, asked)
        if scope.protocol is None:
            found += _left_out(scope, compiled, found)
    names = dict.fromkeys(item.name for item in found)
    missing = next((name for name in asked if name not in names), None)
    if missing is not None:
        raise NotThere(f"nothing is called {missing}; there are {', '.join(names)}")
    return tuple(item for item in found if not asked or item.name in asked)


def _explored(scope: Scope, compiled: Compiled, limits: Limits, asked: Sequence[str]) -> Iterator[Result]:
    """The answers about one team."""
    own = compiled if scope.protocol is None else compile_root(scope.root)
    if own.system is None:
        wrong = next(item for item in own.diagnostics if item.severity is Severity.ERROR)
        reason = f"it cannot be played alone: {wrong.message}"
        yield Result(scope.what, scope.what, Verdict.UNDECIDED, scope.agents, reason)
        return
    inspection = inspect_files(scope.root, None, options_of(own.configuration))
    watched = watched_of(inspection, dict(scope.team))
    script = watched.scripts[0] if watched.refused is None else None
    with TemporaryDirectory(prefix="asemec-prove-") as folder:
        package, _ = generate_version(own.system, Path(folder), choose(own.configuration))
        loaded = loaded_for(package, compiled.configuration.folder.resolve())
        eyes = Eyes()
        own_script = None if script is None else _of_scope(script, scope)
        watch = Watched(own_script) if own_script is not None and own_script.expectations else None
        listeners: list[Listener] = [eyes] if watch is None else [eyes, watch.observer]
        assumed = assumed_by(script.assumptions if script is not None else ())
        explored = Explored(
            loaded,
            scope.team,
            assumed,
            listeners,
            [] if watch is None else [watch.observer],
            layout_of(watch),
            names_in(script),
        )
        if watch is not None:
            watch.begin(explored)
        wanted = () if watch is None else watch.numbers_of(asked)
        graph = search(
            explored,
            eyes,
            None if watch is None else watch.monitors,
            limits,
            lambda graph: 0 < len(asked) == len(wanted) and graph.broken.keys() >= set(wanted),
        )
        yield from Judge(scope, explored, graph, watch, assumed, limits, own.system).results()


def _left_out(scope: Scope, compiled: Compiled, found: Sequence[Result]) -> Iterator[Result]:
    """The properties and clauses of the whole team of which a smaller one says nothing."""
    assert compiled.system is not None
    whole = {agent.name: agent.role for team in compiled.system.teams[:1] for agent in team.agents}
    inspection = inspect_files(compiled.root, None, options_of(compiled.configuration))
    for team in (whole, dict(scope.team)):
        watched = watched_of(inspection, team)
        if watched.refused is not None:
            reason, span = watched.refused.reason, watched.refused.span
            yield Result(span.text, scope.what, Verdict.UNDECIDED, scope.agents, reason, (), span)
            return
        for item in watched.scripts[0].expectations:
            if named(item) not in {other.name for other in found}:
                reason = "it speaks of agents that are left out: raise --robots"
                yield Result(named(item), scope.what, Verdict.UNDECIDED, scope.agents, reason, (), item.span)


def _of_scope(script: Script, scope: Scope) -> Script:
    """What is watched: of a protocol alone its clauses, of the team everything."""

    def belongs(item: Expectation) -> bool:
        if not item.of.startswith("clause"):
            return scope.protocol is None
        return item.of.split()[-1] == scope.protocol if scope.protocol is not None else True

    kept = tuple(item for item in script.expectations if belongs(item))
    return replace(script, expectations=kept)


def assumed_by(assumptions: Sequence[Assumption]) -> Assumed:
    """What the surroundings may do, as a document says it."""
    crashes = tuple((item.most, item.agents) for item in assumptions if isinstance(item, CrashesAssumed))
    loses = any(isinstance(item, NetworkAssumed) and item.network.loss > 0 for item in assumptions)
    fails = frozenset(item.activity for item in assumptions if isinstance(item, FailuresAssumed))
    times = tuple(
        item.span.text.strip()
        for item in assumptions
        if isinstance(item, DurationAssumed | PaceAssumed)
        or (isinstance(item, NetworkAssumed) and item.network.most > 0)
    )
    return Assumed(loses, crashes, fails, times)


__all__ = ["NotThere", "assumed_by", "prove"]
