"""Prove: explore the teams of a system, and say what holds in all their runs."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory

from aseme_dsl.amola.system import System
from aseme_dsl.compiler.phases import watched_of
from aseme_dsl.diagnostics import Severity
from aseme_dsl.play.scenario import (
    GUARANTEE,
    Assumption,
    CrashesAssumed,
    DurationAssumed,
    Expectation,
    FailuresAssumed,
    InPlaces,
    NetworkAssumed,
    PaceAssumed,
    Script,
    ValueAssumed,
)
from aseme_dsl.project.building.build import choose
from aseme_dsl.project.building.project import Compiled, compile_root
from aseme_dsl.project.playing.operate import generate_version
from aseme_dsl.project.proving.asking import not_there, nothing_for
from aseme_dsl.project.proving.contradicting import contradiction_in
from aseme_dsl.project.proving.judging import (
    Answers,
    Judge,
    Reached,
    Times,
    asks_for_times,
    dead_states,
)
from aseme_dsl.project.proving.pairs import by_pairs, equal_in
from aseme_dsl.project.proving.results import BUILT_IN, Bounds, Key, Result, Verdict
from aseme_dsl.project.proving.scopes import TEAM, Scope, agents_of, is_for_a_run, scopes_of
from aseme_dsl.project.proving.searches import Purse, among_others, in_parts
from aseme_dsl.project.proving.watched import (
    Watched,
    as_written,
    asked_by,
    hears,
    is_timed,
    key_of,
    layout_of,
    messages_in,
    named,
    names_in,
    terms_in,
)
from aseme_dsl.project.proving.written import loaded_with_writes
from aseme_dsl.proofs.explore.apart import groups_of
from aseme_dsl.proofs.explore.deciding.order import Unanswerable
from aseme_dsl.proofs.explore.explored import Assumed, Explored
from aseme_dsl.proofs.explore.needed import Asked, Needed
from aseme_dsl.proofs.explore.search import Eyes, Limits, search
from aseme_dsl.proofs.explore.wandering.wander import wander
from aseme_dsl.proofs.guide import Guide
from aseme_dsl.proofs.timed.search import Watching, search_with_times
from aseme_dsl.runtime.monitor.rules import Never
from aseme_dsl.runtime.trace.trace import Listener
from aseme_dsl.runtime.version.loading import Loaded
from aseme_dsl.source import Span


class NotThere(Exception):
    """Nothing is called as something that was asked for; the text lists what there is."""


def prove(
    compiled: Compiled,
    asked: Sequence[str],
    robots: int,
    limits: Limits,
    told: Callable[[str], None] = lambda text: None,
    horizon: int | None = None,
    only: Collection[str] = (),
    must_be_there: bool = True,
) -> tuple[Result, ...]:
    """What holds in all runs of a system without errors; `asked` are names of what to answer, all if none.

    With `robots` agents of each role, and of each participant, that has several. `told` hears what is done.
    Where times are measured, that is up to the `horizon` (ns), if there is one. `only` says which of the
    team and the protocols alone are explored, all if none. What is asked for `must_be_there` in one of them.

    Raises:
        NotThere: nothing is called as one of `asked`; the text lists what there is.
        OperateError, LoadError: the code of the system cannot be made.
    """
    assert compiled.system is not None
    found: list[Result] = []
    known: dict[str, str] = {}
    for scope in scopes_of(compiled.root, compiled.system, robots):
        if only and scope.what not in only:
            continue
        found += _explored(scope, compiled, limits, asked, known, told, horizon)
        if asked and all(known.get(name, "").startswith("property") for name in asked):
            break  # these are about the team, which comes first
    found += _unsaid(compiled, asked, found, only)
    names = {*known, *(item.name for item in found)}
    missing = next((name for name in asked if name not in names), None)
    if missing is not None and must_be_there:
        raise NotThere(not_there(missing, tuple(known), compiled.system))
    return tuple(item for item in found if not asked or item.name in asked)


def prove_alone(scope: Scope, compiled: Compiled, limits: Limits) -> tuple[Result, ...]:
    """All answers about one team, or about a protocol alone. Raises OperateError, LoadError: see `prove`."""
    return tuple(_explored(scope, compiled, limits, (), {}))


def _explored(
    scope: Scope,
    compiled: Compiled,
    limits: Limits,
    asked: Sequence[str],
    known: dict[str, str],
    told: Callable[[str], None] = lambda text: None,
    horizon: int | None = None,
) -> Iterator[Result]:
    """The answers about one team; the names of its properties and clauses are added to `known`,
    with what they are. A team of which nothing is asked is not explored."""
    own = compiled if scope.protocol is None else compile_root(scope.root)
    if own.system is None:
        wrong = next(item for item in own.diagnostics if item.severity is Severity.ERROR)
        reason = f"it cannot be played alone: {wrong.message}"
        assert compiled.system is not None
        aip = next(item for item in compiled.system.aips if item.name == scope.protocol)
        known |= {as_written(item.span): "clause" for item in aip.clauses}
        names = [name for name in asked if name in known or name in BUILT_IN] if asked else [scope.what]
        for name in names:
            yield Result(name, scope.what, Verdict.UNDECIDED, Bounds(scope.agents), reason)
        return
    (script,) = watched_of(own.inspection, dict(scope.team)).scripts
    own_script = of_scope(script, scope)
    known |= {named(item): item.of for item in own_script.expectations}
    wanted = [item for item in own_script.expectations if not asked or named(item) in asked]
    others = len(BUILT_IN) if not asked else len({*asked} & {*BUILT_IN})
    if not wanted and not others:
        return
    told(f"exploring the {scope.what}")
    assumed = assumed_by(script.assumptions)
    with TemporaryDirectory(prefix="asemec-prove-") as folder:
        package, _ = generate_version(own.system, Path(folder), choose(own.configuration))
        loaded = loaded_with_writes(package, own.system, compiled.configuration)
        plans = {role: loaded.charts[role].PLAN for _, role in scope.team}
        groups = groups_of(scope.team, plans)
        kinds = {
            name: (role, plans[role].begins(name), repr(assumed.has.get(name))) for name, role in scope.team
        }
        searched = partial(_searched, system=own.system, loaded=loaded, assumed=assumed, asked=asked)

        def with_times(item: Result, team: Scope, later: int) -> Result:
            """The answer about failures, with times if it depends on them; so many questions come later."""
            if not (item.is_built_in and item.is_abstract and item.name == "failures"):
                return item
            judge = in_parts(purse.part(1 + later), searched, team, None, times=Times(horizon))
            assert judge is not None
            return judge.failures()

        def answered(
            team: Scope, script: Script | None, parts: float, about: Asked | None = None, is_all: bool = False
        ) -> Answers | None:
            """The answers of one search, and of others in which numbers may be any, or more are tried; there
            are none as `_searched` says. `is_all`: also those to what is asked of every team."""
            lent = purse.part(parts)
            judge = in_parts(lent, searched, team, script, about=about)
            given = None if judge is None else judge.answers(is_all=is_all)
            if judge is not None and given is not None and is_all and judge.is_open:
                more = among_others(lent, searched, team, given.results, asked, kinds)
                given = replace(given, results=(*more,))
            if judge is None or given is None or not judge.is_of_few or given.is_decided:
                return given
            try:
                judge = in_parts(purse.part(parts), searched, team, script, about=about, numbers=None)
                assert judge is not None
                abstract = judge.answers(is_all=is_all)
            except Unanswerable:
                return given
            given, numbers = given.surer(abstract), judge.beside
            if given.is_decided or not any(item.is_abstract for item in abstract.results) or not numbers:
                return given
            judge = in_parts(purse.part(parts), searched, team, script, about=about, numbers=numbers)
            return given if judge is None else given.surer(judge.answers(is_all=is_all))

        found: dict[Key, Result] = {}
        rest: list[Expectation] = []
        timed = [item for item in wanted if is_timed(item.rule)]
        untimed = [item for item in wanted if not is_timed(item.rule)]
        questions = max(1, len(wanted) + others)
        purse = Purse(limits, limits.seconds / (2 * questions))  # half of an equal part at least
        for number, item in enumerate(untimed):
            one = replace(own_script, expectations=(item,))
            about = asked_by(one)
            parts = len(untimed) - number + len(timed) + others
            proved = purse.spend(by_pairs, scope, own_script, item, loaded, assumed, purse.share(2 * parts))
            if proved is not None:
                found[key_of(item)] = proved
                continue
            answers = None if about is None else answered(scope, one, parts, about)
            if answers is None:
                rest.append(item)
            else:
                found |= {answer.key: answer for answer in answers.results}
        own_script = replace(own_script, expectations=tuple(rest))
        has_more = others > 0
        is_whole = groups == [scope.team]
        if rest or (has_more and is_whole):
            now, later = len(rest), len(timed)
            now, later = (now + others, later) if is_whole else (now, later + others)
            answers = answered(scope, own_script, (now + later) / max(1, now), is_all=is_whole)
            assert answers is not None
            found |= {item.key: with_times(item, scope, later) for item in answers.results}
        timed = [item for item in wanted if asks_for_times(item, found.get(key_of(item)))]
        others = 0 if is_whole else others
        for number, item in enumerate(timed):
            one = replace(script, expectations=(item,))
            lent = purse.part(len(timed) - number + others)
            judge = in_parts(lent, searched, scope, one, about=asked_by(one), times=Times(horizon))
            assert judge is not None
            found[key_of(item)] = next(judge.expected())
        yield from found.values()
        if has_more and not is_whole:
            about_groups: list[Result] = []
            reached: list[Reached] = []
            for number, group in enumerate(groups):
                part = replace(scope, team=group)
                answers = answered(part, None, len(groups) - number, is_all=True)
                assert answers is not None
                later = len(groups) - number - 1
                about_groups += [with_times(item, part, later) for item in answers.results]
                reached.append(answers.reached)
            yield from _together(about_groups, reached, scope)


def _together(parts: Sequence[Result], reached: Sequence[Reached], scope: Scope) -> Iterator[Result]:
    """The answers about groups of agents that do not meet as answers about their team."""
    for name in dict.fromkeys(item.name for item in parts):
        same = [item for item in parts if item.name == name]
        worst = next(
            item
            for verdict in (Verdict.REFUTED, Verdict.UNDECIDED, Verdict.PROVED)
            for item in same
            if item.verdict is verdict
        )
        if name == "dead states":  # what one group does not reach, another may
            verdict, reason = dead_states(reached)
            worst = replace(worst, verdict=verdict, reason=reason)
        under = dict.fromkeys(part for item in same for part in item.bounds.parts)
        states = sum(item.bounds.states or 0 for item in same)
        few = sum(item.bounds.few for item in same)
        long = sum(item.bounds.long for item in same)
        bounds = Bounds(scope.agents, (*under, "agents that do not meet apart"), states, few, long)
        yield replace(worst, bounds=bounds)


def _searched(
    scope: Scope,
    script: Script | None,
    limits: Limits,
    *,
    system: System,
    loaded: Loaded,
    assumed: Assumed,
    asked: Sequence[str],
    about: Asked | None = None,
    times: Times | None = None,
    numbers: Sequence[float] | None = (),
    still: frozenset[str] = frozenset(),
    others: frozenset[str] = frozenset(),
    group: int | None = None,
    apart: Sequence[Needed] = (),
    before: Judge | None = None,
) -> Judge | None:
    """One search, with the judge of what it has found. With `about`, it is about that alone: what does not
    matter to it stands still. Then there is none if everything matters, unless `times` are measured. Nor is
    there one among `others`, if that leaves something out, nor of the only `group` of one agent.
    `numbers`, `still`, `others`, `group`, `apart`: see Explored. It is one of long runs if there were others
    `before`.
    Raises Unanswerable, if numbers may be any, and the team asks more of one than how it compares."""
    eyes = Eyes()
    watch = Watched(script) if script is not None and script.expectations else None
    listeners: list[Listener] = [eyes] if watch is None else [eyes, watch.observer]
    explored = Explored(
        loaded,
        scope.team,
        assumed,
        listeners,
        [] if watch is None else [watch.observer],
        layout_of(watch),
        names_in(script),
        messages_in(script, loaded.messages),
        about,
        times is not None,
        conditions=tuple(terms_in(script)),
        numbers=numbers,
        still=still,
        others=others,
        group=group,
        apart=apart,
    )
    if about is not None and explored.needed is None and times is None:
        return None
    if others and explored.left_out:
        return None
    if group is not None and not others and explored.needed is None:
        return None
    explored.hears = hears(script)
    if about is not None or times is not None or group is not None:
        explored.judged.clear()  # such a search says nothing of messages that nothing takes
    if watch is not None:
        watch.begin(explored)
    wanted: tuple[int, ...] = ()
    if watch is not None:  # the number of the only one, or of those that were asked for
        wanted = (0,) if about is not None else watch.numbers_of(asked)
    there = set() if script is None else {named(item) for item in script.expectations}
    is_all = about is not None or (bool(asked) and {*asked} <= there - {*BUILT_IN})
    far = None if script is None or about is None else _guess(script, explored)
    if times is not None:
        watching = Watching()
        if watch is not None:
            watching = Watching(watch.monitors, watch.dues, watch.begin_moment, far=far)
        graph = search_with_times(explored, eyes, watching, limits, times.horizon)
    else:
        monitors = None if watch is None else watch.monitors
        if before is not None:
            graph = wander(explored, eyes, monitors, limits, before.has_enough, before.left)
        else:
            graph = search(
                explored,
                eyes,
                monitors,
                limits,
                lambda graph: is_all and graph.broken.keys() >= set(wanted),
                far,
            )
    return Judge(scope, explored, graph, watch, assumed, limits, system, loaded, times, asked)


def _guess(script: Script, explored: Explored) -> Callable[[], int] | None:
    """How many moves may be left until the only expectation of a script is broken, if it is "at most"."""
    rule = script.expectations[0].rule
    condition = script.conditions[rule.condition] if isinstance(rule, Never) else None
    if not isinstance(condition, InPlaces):
        return None
    plans = {agent.name: agent.plan for agent in explored.agents}
    places = {agent: labels for agent, labels in condition.places.items() if agent in plans}
    guide = Guide(places, condition.least, plans)
    return lambda: guide.far(explored.agents)


def _unsaid(
    compiled: Compiled, asked: Sequence[str], found: Sequence[Result], only: Collection[str]
) -> Iterator[Result]:
    """What the team was not asked, with the reason.

    That are statements about agents that are left out or not there, and roles of the file that no agent has.
    Of the built-in questions, those that were `asked` for where there is nothing to ask.
    """
    system = compiled.system
    assert system is not None
    if only and TEAM not in only:
        return
    agents = agents_of(system)
    bounds = Bounds(next((item.bounds.agents for item in found if item.of == TEAM), "no agent"))
    answered = {item.key for item in found}
    (script,) = watched_of(compiled.inspection, agents).scripts
    raise_it = "it speaks of agents that are left out: raise --robots"
    statements = [item for item in script.expectations if not item.of.startswith(GUARANTEE)]
    unsaid = [(named(item), item.span, raise_it) for item in statements]
    unsaid += [(item.name, item.span, item.reason) for item in script.silent]
    for name, span, reason in unsaid:
        if (name, str(span)) not in answered:
            yield Result(name, TEAM, Verdict.UNDECIDED, bounds, reason, span=span)
    names = {item.name for item in found}
    for name in BUILT_IN:
        if name in asked and name not in names:
            reason = f"vacuous: {nothing_for(name)}"
            yield Result(name, TEAM, Verdict.UNDECIDED, bounds, reason, is_built_in=True)
    for chart in () if asked else system.iacs:
        if is_for_a_run(chart.name):
            continue
        if chart.name not in agents.values() and _is_own(chart.span, system):
            name, reason = f"role {chart.name}", "it is not explored: no agent has this role"
            yield Result(name, TEAM, Verdict.UNDECIDED, bounds, reason, span=chart.span, is_built_in=True)


def _is_own(span: Span | None, system: System) -> bool:
    """Whether something stands in the file that declares the system."""
    return span is not None and system.span is not None and span.source.path == system.span.source.path


def of_scope(script: Script, scope: Scope) -> Script:
    """What is watched: of a protocol alone its clauses, of the team everything."""

    def belongs(item: Expectation) -> bool:
        if item.of.startswith(GUARANTEE):
            return False  # it is assumed
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
    networks = [item.network for item in assumptions if isinstance(item, NetworkAssumed)]
    delays = [
        (network.least, network.most)
        for network in networks
        if network.most > 0 or not (network.loss or network.reorder)
    ]
    takes = {
        item.activity: (item.takes.least, item.takes.most)
        for item in assumptions
        if isinstance(item, DurationAssumed)
    }
    has: dict[str, dict[str, dict[tuple[str, ...], object]]] = {}
    held: dict[str, tuple[str, ...]] = {}
    for item in assumptions:
        if isinstance(item, ValueAssumed):
            for channel, path, value in equal_in(item.value):
                has.setdefault(item.agent, {}).setdefault(channel, {}).setdefault(path, value)
                text = " ".join(item.span.text.split())
                held[item.agent] = tuple(dict.fromkeys((*held.get(item.agent, ()), text)))
    contradiction = contradiction_in(item for item in assumptions if isinstance(item, ValueAssumed))
    return Assumed(
        loses, crashes, fails, times, delays[-1] if delays else None, takes, has, held, contradiction
    )


__all__ = ["NotThere", "assumed_by", "of_scope", "prove", "prove_alone"]
