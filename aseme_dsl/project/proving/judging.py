"""Judging: what the states of a team say of each question, with the bounds within which they say it."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence, Set
from dataclasses import replace
from functools import cached_property, partial
from pathlib import Path

from aseme_dsl.amola.aip import Aip
from aseme_dsl.amola.system import System
from aseme_dsl.play.scenario import Expectation, Untaken
from aseme_dsl.project.proving.counterexample import Run
from aseme_dsl.project.proving.replaying import played, written
from aseme_dsl.project.proving.results import Bounds, Case, Key, Result, Verdict
from aseme_dsl.project.proving.scopes import Scope, role_of
from aseme_dsl.project.proving.watched import (
    Watched,
    asks_for_more,
    conditions_in,
    is_timed,
    key_of,
    left_out_of_times,
    named,
    unread_of,
)
from aseme_dsl.proofs.explore.explored import Assumed, Explored
from aseme_dsl.proofs.explore.needed import Needed
from aseme_dsl.proofs.explore.questions import Stuck, Untouched, around, stuck, stuck_alone, unmet, untouched
from aseme_dsl.proofs.explore.retrace import renewals
from aseme_dsl.proofs.explore.search import ENOUGH, Graph, Limits, Step, never_untaken
from aseme_dsl.proofs.explore.wandering.unreached import lines_of, missing_partner, unreached
from aseme_dsl.proofs.explore.wandering.wander import Goal
from aseme_dsl.proofs.timed.schedule import moments
from aseme_dsl.proofs.timed.stamp import Window
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.plan import Plan, State
from aseme_dsl.runtime.monitor.rules import Always, Before, LeadsTo, Never, Sometime, Until
from aseme_dsl.runtime.time.clock import SECOND, readable
from aseme_dsl.runtime.version.loading import Loaded
from aseme_dsl.source import is_library_path

CUT = "the search was cut after"
"""The reason of an answer for which a search was too short, before how long that was."""
ROUND = "from here on, again and again: "
"""What stands before the first line of a round that may repeat for ever."""
_LONG = 3600 * SECOND
"""So long a scenario waits for what does not come (ns)."""
_GAPS = (10**9, 10**8, 10**7, 10**6, 10**3, 0)
"""So far apart (ns) are two moves of a run with times, if they can be."""
_MARGIN = 1000
"""So far (ns) what is due stays apart from the moves before it, if it can."""
_MOST = 24
"""So many more numbers are tried at the most."""
_SHOWN = 5
"""So many dead states are named."""


@dataclass(frozen=True, slots=True)
class Reached:
    """Which states and transitions of its roles a team has reached; `why` these may not be all, if so.
    `is_vacuous`: no run is like that. Transitions that are `spared` need not be taken."""

    plans: Mapping[str, Plan]
    visited: Mapping[str, Set[str]]
    taken: Mapping[str, Set[int]]
    spared: Mapping[str, Set[int]]
    why: str
    is_vacuous: bool


def dead_states(found: Sequence[Reached]) -> tuple[Verdict, str]:
    """The answer about dead states, with its reason: what agents of a role reach in none of these teams."""
    if (vacuous := next((item for item in found if item.is_vacuous), None)) is not None:
        return Verdict.UNDECIDED, vacuous.why
    plans = {name: plan for item in found for name, plan in item.plans.items()}
    dead: list[str] = []
    for name, plan in plans.items():
        visited = {label for item in found for label in item.visited.get(name, ())}
        taken = {number for item in found for number in item.taken.get(name, ())}
        spared = {number for item in found for number in item.spared.get(name, ())}
        dead += dict.fromkeys(what for _, what in unreached(plan, visited, taken, spared))
    if not dead:
        return Verdict.PROVED, ""
    text = ", ".join(dead[:_SHOWN]) + (f" and {len(dead) - _SHOWN} more" if len(dead) > _SHOWN else "")
    why = next((item.why for item in found if item.why), "")
    return (
        (Verdict.UNDECIDED, f"not reached: {text}; {why}")
        if why
        else (Verdict.REFUTED, f"never reached: {text}")
    )


@dataclass(frozen=True, slots=True)
class Times:
    """Time was measured, up to the `horizon` (ns), if there is one."""

    horizon: int | None = None


def asks_for_times(item: Expectation, found: Result | None) -> bool:
    """Whether what was found of an expectation depends on times, which were not measured."""
    if is_timed(item.rule):
        return True
    is_safe = isinstance(item.rule, Always | Never | Before | Until)
    return is_safe and found is not None and found.is_abstract


@dataclass(frozen=True, slots=True)
class Answers:
    """What a search has found: `results`, and what was `reached`. `is_exact`: each way is that of a run.

    The questions in `safe` ask for what happens on the way, and what they speak of does happen.
    """

    results: tuple[Result, ...]
    reached: Reached
    is_exact: bool
    safe: frozenset[Key]

    @property
    def is_decided(self) -> bool:
        return all(item.verdict is not Verdict.UNDECIDED for item in self.results)

    def surer(self, other: Answers) -> Answers:
        """These, with what another search decides. Where that has ways that are of no run, it proves no more
        than what is not on any of them."""
        decided = {
            item.key: item
            for item in other.results
            if item.verdict is Verdict.REFUTED
            or (item.verdict is Verdict.PROVED and (other.is_exact or item.key in self.safe))
        }
        results = tuple(
            decided.get(item.key, item) if item.verdict is Verdict.UNDECIDED else item
            for item in self.results
        )
        reached = other.reached if ("dead states", "") in decided else self.reached
        return replace(self, results=results, reached=reached)


class Judge:
    """Answers the questions about one team."""

    def __init__(
        self,
        scope: Scope,
        explored: Explored,
        graph: Graph,
        watch: Watched | None,
        assumed: Assumed,
        limits: Limits,
        system: System,
        loaded: Loaded,
        times: Times | None = None,
        asked: Sequence[str] = (),
    ) -> None:
        self.parts: Sequence[Judge] = ()
        """What was found in searches in which only some agents move, and in long runs: what single runs of
        these show counts, too."""
        self._loaded = loaded
        self._scope = scope
        self._explored = explored
        self._graph = graph
        self._watch = watch
        self._assumed = assumed
        self._limits = limits
        self._system = system
        self._times = times
        self._asked = asked
        self._first = graph.pictures[0]

    def results(self) -> Iterator[Result]:
        """All answers: what the document says, then what is asked of every team."""
        yield from self.expected()
        yield self._deadlock()
        branches = [info for agent in self._explored.agents for info in agent.plan.branches]
        if any(info.sends or info.receives for info in branches):
            yield self._answer(Judge._orphans)
            yield self._answer(Judge._choice)
        if self._protocol is not None:
            yield self._answer(Judge._agreement)
        yield self._dead()
        yield self._answer(Judge._failures)

    @property
    def is_of_few(self) -> bool:
        """Whether the search was not cut by time, and has tried few numbers, which do not stand for all."""
        graph, values = self._graph, self._explored.values
        return bool(values.bounds) and (graph.cut is None or graph.cut != self._limits.time)

    @property
    def beside(self) -> tuple[float, ...]:
        """Numbers beside which the numbers that may be any are different; none if they are too many."""
        found = self._explored.order.beside
        return found if len(found) <= _MOST else ()

    def answers(self, *, is_all: bool) -> Answers:
        """The answers about what the document says; `is_all`: and to what is asked of every team."""
        results = tuple(self.results() if is_all else self.expected())
        safe = frozenset((("failures", ""), *self._safe()))
        is_exact = all(item._explored.order.is_exact for item in (self, *self.parts))
        return Answers(results, self.reached, is_exact, safe)

    def _safe(self) -> Iterator[Key]:
        """The expectations that ask for what happens on the way, and of which all witnesses were met."""
        if self._watch is None:
            return
        script = self._watch.observer.script
        for item in script.expectations:
            asked = conditions_in(replace(script, expectations=(item,)))
            if (
                isinstance(item.rule, Always | Never | Before | Until)
                and self._graph.met.issuperset(item.witnesses)
                and not any(isinstance(condition, Untaken) for condition in asked)
            ):
                yield key_of(item)

    @property
    def apart(self) -> tuple[Needed, ...]:
        """The groups of regions that are to be explored one by one, if there are some."""
        return self._explored.apart

    @property
    def is_apart(self) -> bool:
        """Whether some regions stood still, as they do not matter to those that were explored."""
        return self._explored.needed is not None

    def kept_alone(self) -> frozenset[str]:
        """The questions that the agent that was explored answers by itself: others change nothing."""
        explored, graph = self._explored, self._graph
        if self._incomplete() or (explored.others is not None and explored.others.is_bounded):
            return frozenset()
        found = set[str]()
        if not any(item.kind in ("failure", "circling") for item in graph.sightings):
            found.add("failures")
        if not stuck_alone(explored, graph):
            found.add("deadlock")
        return frozenset(found)

    def expected(self) -> Iterator[Result]:
        """The answers about what the document says."""
        if self._watch is not None:
            for number, item in enumerate(self._watch.observer.script.expectations):
                yield self._answer(partial(Judge._expectation, number=number, item=item))

    def _answer(self, asked: Callable[[Judge], Result]) -> Result:
        """The answer to a question; where it is not decided, a run of a further search counts."""
        found = asked(self)
        if found.verdict is Verdict.UNDECIDED:
            answers = (replace(asked(part), bounds=found.bounds) for part in self.parts)
            found = next((item for item in answers if item.verdict is Verdict.REFUTED), found)
        return found

    @property
    def is_open(self) -> bool:
        """Whether the limits have ended the search."""
        return self._graph.cut not in (None, ENOUGH)

    @property
    def has_all(self) -> bool:
        """Whether the search ended since all that was asked for is refuted."""
        return self._graph.cut == ENOUGH

    @property
    def _sees_all(self) -> bool:
        """Whether all continuations are looked at: others may end a wait that the agents here do not end."""
        return not self._explored.still

    # ---- what the document says --------------------------------------------------------------

    def _expectation(self, number: int, item: Expectation) -> Result:
        graph, name = self._graph, named(item)
        if self._times is not None and (why := left_out_of_times(item.rule, self._explored.agents)):
            return self._result(name, Verdict.UNDECIDED, why, item=item)
        if number in graph.broken:
            steps = graph.way_with(graph.broken[number])
            if self._times is not None:
                return self._at(name, steps, item)
            return self._refuted(name, "", steps, item, expects=_stated(item))
        found = unmet(graph, number) if self._times is None and self._sees_all else None
        if found is not None:
            state, circle = found
            reason = "what is awaited never comes" if not circle else "what is awaited may never come"
            steps = graph.way_to(state)
            further = 0 if circle else _LONG
            round_, expects = around(graph, circle), _stated(item)
            return self._refuted(name, reason, steps, item, round_=round_, further=further, expects=expects)
        if (ever := self._ever_untaken(item)) is not None:
            return self._refuted(name, ever.text, graph.way_to(ever.state), item, further=_LONG)
        if any(witness not in graph.met for witness in item.witnesses) and graph.cut is None:
            return self._result(
                name, Verdict.UNDECIDED, "vacuous: what it speaks of never happens", item=item
            )
        assert self._watch is not None
        if asks_for_more(self._watch.observer.script, item):
            reason = "it asks for an age, the history of a channel, or a function"
            return self._result(name, Verdict.UNDECIDED, reason, item=item)
        plans = {agent.name: agent.plan for agent in self._explored.agents}
        if unread := unread_of(self._watch.observer.script, item, plans):
            return self._result(name, Verdict.UNDECIDED, f"vacuous: {unread}", item=item)
        return self._unbroken(name, item=item)

    def _ever_untaken(self, item: Expectation) -> Untouched | None:
        """A message that waits for ever, if an expectation asks for such ones: in a run, that shows at the
        end."""
        assert self._watch is not None
        script = replace(self._watch.observer.script, expectations=(item,))
        asked = [condition for condition in conditions_in(script) if isinstance(condition, Untaken)]
        return next(
            (
                found
                for found in (self._untouched if asked else ())
                for condition in asked
                if condition.kind == found.letter.message
                and condition.performative in (None, found.letter.performative)
                and (condition.agents is None or found.letter.receiver in condition.agents)
            ),
            None,
        )

    @cached_property
    def _untouched(self) -> tuple[Untouched, ...]:
        return tuple(untouched(self._explored, self._graph)) if self._sees_all else ()

    @cached_property
    def _stuck(self) -> Stuck | None:
        return stuck(self._explored, self._graph) if self._sees_all else None

    def failures(self) -> Result:
        """The answer about failures, of a search with times."""
        first = next((item for item in self._graph.sightings if item.kind == "failure"), None)
        if first is None:
            return self._unbroken("failures", is_built_in=True)
        return self._at("failures", self._graph.way_with(first.at), None, first.text)

    def _at(self, name: str, steps: Sequence[Step], item: Expectation | None, why: str = "") -> Result:
        """A run that was found with times: it speaks against what was asked if it is played so."""
        made = [step for step in steps if step.number >= 0]
        further = renewals(self._explored, self._first, made)
        fitting = (
            moments(steps, gap, windows, margin)
            for windows, margin in ((further, _MARGIN), (further, 0), (dict[int, tuple[Window, ...]](), 0))
            for gap in _GAPS
        )
        when = next((some for some in fitting if some is not None), None)
        if when is None:
            reason = "abstract: no moments fit the run that was found"
            texts = tuple(step.text for step in steps)
            return self._result(name, Verdict.UNDECIDED, reason, texts, item, item is None)
        timed = [*zip(when, steps, strict=True)]
        lines = tuple(f"at {readable(moment)}: {step.text}" for moment, step in timed) or ("at the start",)
        found = self._result(name, Verdict.REFUTED, why, lines, item, item is None)
        at = [moment for moment, step in timed if step.number >= 0]
        run = Run(f"{name} of {self._scope.what}", self._scope.team, end=max(when, default=0) + 1)
        return self._played(found, made, run, item, at)

    # ---- what is asked of every team ---------------------------------------------------------

    def _orphans(self) -> Result:
        due = next((item for item in self._untouched if item.is_due), None)
        return self._seen("orphan messages", "orphan", ever=due)

    def _failures(self) -> Result:
        return self._seen("failures", "failure", "circling")

    def _choice(self) -> Result:
        """Two agents that send past each other: neither takes what the other has sent."""
        found = self._stuck
        if found is None or found.past is None:
            past = next((item for item in self._untouched if item.is_past), None)
            why = "" if past is None else f"{past.text}, and both have sent past each other"
            return self._seen("non-local choice", "race", ever=past, why=why)
        reason = f"{found.agent} and {found.past} have sent past each other, and {found.agent} waits for ever"
        steps = self._graph.way_to(found.state)
        return self._refuted("non-local choice", reason, steps, further=_LONG, expects=[self._waits(found)])

    def _deadlock(self) -> Result:
        found = self._stuck
        if found is None:
            return self._unbroken("deadlock", is_built_in=True)
        waiting = found.waiting
        what = " or ".join(item.what for item in waiting.awaits[:3])
        reason = (
            f"{found.agent} waits {waiting.where} {waiting.name} for ever{f' for {what}' if what else ''}"
        )
        if missing := self._missing:
            why = f"{reason}; {missing}"
            return self._result("deadlock", Verdict.UNDECIDED, why, is_built_in=True)
        steps = self._graph.way_to(found.state)
        return self._refuted("deadlock", reason, steps, further=_LONG, expects=[self._waits(found)])

    @property
    def _missing(self) -> str:
        """Which partner of a participant is not there, as the protocol is alone; empty if none is missing."""
        plans = [agent.plan for agent in self._explored.agents]
        missing = "" if self._scope.protocol is None else missing_partner(plans)
        return f"no agent plays {missing} where the protocol is alone" if missing else ""

    def _waits(self, found: Stuck) -> str:
        """That an agent does not wait where it waits for ever."""
        agent = next(item for item in self._explored.agents if item.name == found.agent)
        names = [state.name for state in around_of(agent.plan, found.waiting.state)]
        where = next((name for name in names if name.isidentifier()), agent.plan.name)
        return f"at {{end}} not {found.agent} in {where}"

    def _seen(self, name: str, *kinds: str, ever: Untouched | None = None, why: str = "") -> Result:
        """Whether something was seen, or a message waits for `ever`; `why` that speaks against it."""
        graph = self._graph
        first = next((item for item in graph.sightings if item.kind in kinds), None)
        if first is not None:
            return self._refuted(name, first.text, graph.way_with(first.at), expects=first.expects)
        if ever is not None:
            expects = (never_untaken(ever.letter.message, ever.letter.receiver),)
            return self._refuted(
                name, why or ever.text, graph.way_to(ever.state), further=_LONG, expects=expects
            )
        return self._unbroken(name, is_built_in=True)

    @cached_property
    def _protocol(self) -> Aip | None:
        """The protocol that is explored alone, if it has outcomes that may disagree."""
        aip = next((item for item in self._system.aips if item.name == self._scope.protocol), None)
        return None if aip is None or sum(bool(item.when) for item in aip.outcomes) < 2 else aip

    def _agreement(self) -> Result:
        """Two outcomes of one protocol never come together."""
        assert self._protocol is not None
        reached = _Outcomes(self._protocol, self._explored, self._graph)
        steps = reached.disagreement()
        if steps is None:
            return self._unbroken("agreement", is_built_in=True)
        return self._refuted("agreement", reached.text, steps, expects=reached.expects)

    @property
    def reached(self) -> Reached:
        """What the team has reached, also in further searches."""
        graph = self._graph
        plans = {agent.role: agent.plan for agent in self._explored.agents}
        why = self._incomplete() or self._missing
        if not why and self._explored.values.computes:
            why = "a few values are tried, and others may lead there"
        if not why and graph.is_queue_cut:
            why = "more messages may be on their way than are looked at"
        graphs = [graph, *(part._graph for part in self.parts)]
        visited = {
            role: frozenset().union(*(item.visited.get(role, ()) for item in graphs)) for role in plans
        }
        taken = {role: frozenset().union(*(item.taken.get(role, ()) for item in graphs)) for role in plans}
        spared = {role: self._spared(plan) for role, plan in plans.items()}
        return Reached(plans, visited, taken, spared, why, bool(self._assumed.contradiction))

    def _spared(self, plan: Plan) -> frozenset[int]:
        """The lines of protocols of the library, but of one that is proved alone: what a role gives to a
        participant may switch some off."""
        return frozenset(
            number
            for aip in self._system.aips
            if is_library_path(aip.span.source.path) and aip.name != self._scope.protocol
            for number in lines_of(plan, aip.name, Path(aip.span.source.path).name)
        )

    def left(self, further: Graph) -> list[Goal]:
        """Where neither a further search nor those before have reached all there is."""
        found, goals = self.reached, dict[Goal, None]()
        for role, plan in found.plans.items():
            visited = found.visited[role] | further.visited.get(role, set())
            taken = found.taken[role] | further.taken.get(role, set())
            goals |= dict.fromkeys(
                (role, label) for label, _ in unreached(plan, visited, taken, found.spared[role])
            )
        return [*goals]

    def has_enough(self, further: Graph, left: Sequence[Goal]) -> bool:
        """Whether single runs say no more of what is asked of every team than is known: by a further search,
        and those before. `left` is what none of them has reached."""
        graphs = [self._graph, *(part._graph for part in self.parts), further]
        seen = {item.kind for graph in graphs for item in graph.sightings}
        seen |= {"dead states"} if not left else set()
        questions = {
            "dead states": {"dead states"},
            "failures": {"failure", "circling"},
            **(
                {"orphan messages": {"orphan"}, "non-local choice": {"race"}} if self._explored._talks else {}
            ),
        }
        return all(
            seen & kinds for name, kinds in questions.items() if not self._asked or name in self._asked
        )

    def _dead(self) -> Result:
        return self._result("dead states", *dead_states([self.reached]), is_built_in=True)

    # ---- verdicts ----------------------------------------------------------------------------

    def _unbroken(self, name: str, *, item: Expectation | None = None, is_built_in: bool = False) -> Result:
        """Nothing speaks against it: it is proved if all was looked at."""
        why = self._incomplete()
        verdict = Verdict.UNDECIDED if why else Verdict.PROVED
        return self._result(name, verdict, why, item=item, is_built_in=is_built_in)

    def _incomplete(self) -> str:
        """What was left out; empty if nothing was."""
        if self._assumed.contradiction:
            return f"vacuous: {self._assumed.contradiction}"
        if self._graph.cut is not None:
            return f"{CUT} {self._graph.cut}"
        if self._explored.values.computed:
            return f"the program computes with {', '.join(sorted(self._explored.values.computed))}"
        if self._explored.values.bounds:
            return "a few values are tried, which do not stand for all"
        return self._explored.left_out

    def _refuted(
        self,
        name: str,
        reason: str,
        steps: Sequence[Step],
        item: Expectation | None = None,
        *,
        round_: Sequence[Step] = (),
        further: int = 0,
        expects: Sequence[str] = (),
    ) -> Result:
        """A run speaks against it, if it happens; it ends with one `round_` of what may repeat for ever."""
        again = [f"{'' if number else ROUND}{step.text}" for number, step in enumerate(round_)]
        lines = (*(step.text for step in steps), *again) or ("at the start",)
        found = self._result(name, Verdict.REFUTED, reason, lines, item, item is None)
        run = Run(f"{name} of {self._scope.what}", self._scope.team, further, expects)
        may_not = bool(self._assumed.times) and any(step.passes for step in steps)
        if not (may_not and round_):  # one round does not show whether more can be made
            played = self._played(found, (*steps, *round_), run, item)
            if played.verdict is Verdict.REFUTED or not may_not:
                return played
        why = f"abstract: the run that was found may not keep `{self._assumed.times[0]}`"
        reason = f"{reason}; {why}" if reason else why
        return replace(found, verdict=Verdict.UNDECIDED, reason=reason, is_abstract=True)

    def _played(
        self,
        found: Result,
        steps: Sequence[Step],
        run: Run,
        item: Expectation | None,
        at: Sequence[int] | None = None,
    ) -> Result:
        """What a run speaks against, once it was played; `at` are the moments of its moves, if known."""
        if self._assumed.contradiction:  # no run is like that
            why = f"vacuous: {self._assumed.contradiction}"
            return replace(found, verdict=Verdict.UNDECIDED, reason=why, counterexample=())
        if self._explored.values.may_be_any:
            return replace(found, verdict=Verdict.UNDECIDED, is_abstract=True)
        replay = written(self._explored, self._first, steps, run, self._system, at)
        if not replay.problem:
            replay = played(self._scope.root, replay, self._loaded, item, self._system)
        if replay.problem:
            why = f"abstract: the run found is none of a team: {replay.problem}"
            reason = f"{found.reason}; {why}" if found.reason else why
            return replace(found, verdict=Verdict.UNDECIDED, reason=reason, is_abstract=True)
        assert replay.played is not None
        scope, remark = self._scope, found.reason or "it is broken here"
        remark = remark if found.span is None else f"{found.span}: {remark}"
        story = scope.in_the_file(replay.played.story)
        case = Case(run.title, scope.roles, replay.text, scope.team, story, remark)
        return replace(found, case=case)

    def _result(
        self,
        name: str,
        verdict: Verdict,
        reason: str,
        counterexample: tuple[str, ...] = (),
        item: Expectation | None = None,
        is_built_in: bool = False,
    ) -> Result:
        span = None if item is None else item.span
        return Result(
            name, self._scope.what, verdict, self.bounds(), reason, counterexample, span, is_built_in
        )

    def bounds(self) -> Bounds:
        """How far the answers go."""
        graph = self._graph
        delay, times = self._assumed.delay, self._times
        within = "any delay"
        if times is not None and delay is not None:
            within = f"delay {readable(delay[0])} to {readable(delay[1])}"
        parts = [within + (", data may be lost" if self._assumed.loses else "")]
        if times is not None:
            parts += [
                f"{name} takes {readable(least)} to {readable(most)}"
                for name, (least, most) in self._assumed.takes.items()
            ]
            parts.append("all times" if times.horizon is None else f"the first {readable(times.horizon)}")
        parts += [f"at most {most} of {len(names)} crash" for most, names in self._assumed.crashes if names]
        parts += [text for agent, _ in self._scope.team for text in self._assumed.held.get(agent, ())]
        if graph.is_queue_cut:
            queue = self._limits.queue
            parts.append(f"at most {queue} messages ({queue // 2} of topics) on one way")
        parts += sorted(self._explored.values.bounds.values())
        if self._explored.needed is not None and self._explored.others is None:
            parts.append("only the regions that matter to it")
        few = sum(len(part._graph.parents) for part in self.parts if not part._sees_all)
        long = sum(len(part._graph.parents) for part in self.parts if part._sees_all)
        return Bounds(self._scope.agents, tuple(parts), len(graph.parents), few, long)


def _stated(item: Expectation) -> tuple[str, ...]:
    """A clause as a statement of a scenario, if it awaits something. For the end of a run may cut off a
    conversation: what a clause awaits there has failed only as a statement of the scenario itself."""
    if (
        not item.of.startswith("clause")
        or is_timed(item.rule)
        or not isinstance(item.rule, LeadsTo | Sometime)
    ):
        return ()
    return (named(item).replace("{", "{{").replace("}", "}}"),)


def around_of(plan: Plan, label: str) -> Iterator[State]:
    """A state, and those around it, from inside."""
    state: State | None = plan.by_label[label]
    while state is not None:
        yield state
        state = None if state.parent is None else plan.by_label[state.parent]


_Reached = tuple[int, frozenset[str]]
"""A state, and the outcomes of which a place was entered on the way."""


def _way(parents: Mapping[_Reached, tuple[_Reached, Step] | None], last: _Reached) -> list[Step]:
    steps: list[Step] = []
    while (before := parents[last]) is not None:
        last, step = before
        steps.append(step)
    return steps[::-1]


class _Outcomes:
    """Whether two outcomes of a protocol with conditions come together in one run of it."""

    def __init__(self, aip: Aip, explored: Explored, graph: Graph) -> None:
        self._aip = aip
        self._explored = explored
        self._graph = graph
        self.text = ""
        self.expects: list[str] = []
        """Statements of which one does not hold in the run."""

    def disagreement(self) -> list[Step] | None:
        """The shortest run in which places of two outcomes are entered."""
        outcomes = [(item.text, self._labels(item.when)) for item in self._aip.outcomes if item.when]
        first = 0, frozenset[str]()
        parents: dict[_Reached, tuple[_Reached, Step] | None] = {first: None}
        todo = deque([first])
        while todo:
            now = todo.popleft()
            if len(now[1]) > 1:
                one, other = sorted(now[1])[:2]
                self.text = f'both "{one}" and "{other}" come of it'
                self.expects = [
                    f'no outcome "{after}" within 60min after outcome "{before}"'
                    for before, after in ((one, other), (other, one))
                ]
                return _way(parents, now)
            for edge in self._graph.edges.get(now[0], ()):
                after = edge.target, now[1] | self._entered(outcomes, edge.taken)
                if after not in parents:
                    parents[after] = now, edge.step
                    todo.append(after)
        return None

    def _labels(self, places: Iterable[str]) -> dict[str, frozenset[str]]:
        """The labels of places, by the role that plays the participant."""
        found: dict[str, frozenset[str]] = {}
        for place in places:
            name, _, participant = place.partition("@")
            for agent in self._explored.agents:
                if agent.role == role_of(self._aip.name, participant):
                    labels = {
                        state.label for state in agent.plan.states if name in (state.name, state.activity)
                    }
                    found[agent.name] = found.get(agent.name, frozenset()) | labels
        return found

    def _entered(
        self,
        outcomes: list[tuple[str, dict[str, frozenset[str]]]],
        taken: Iterable[tuple[str, tuple[int, ...]]],
    ) -> frozenset[str]:
        plans = {agent.name: agent.plan for agent in self._explored.agents}
        return frozenset(
            text
            for text, labels in outcomes
            for name, way in taken
            for number in way
            if plans[name].transitions[number].target in labels.get(name, ())
        )


__all__ = ["Judge", "Reached", "dead_states"]
