"""Played: from the statements of scenarios to what is played; the rest is refused, with its place.

It takes files without errors: what the statements name is there, and of the right type.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import field, replace
from typing import NoReturn, assert_never

from aseme_dsl.amola.expression import Value
from aseme_dsl.amola.messages import BOOL, DOUBLE, Channel, ChannelKind
from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.compiler.read.blocks import Blocks
from aseme_dsl.compiler.read.constants import fold
from aseme_dsl.compiler.requirements.places import Places
from aseme_dsl.compiler.requirements.statements import (
    Check,
    Known,
    model_name,
    only_agent,
    properties,
    scenarios,
    taken_by,
)
from aseme_dsl.grammar.text import statements as nodes
from aseme_dsl.grammar.text import tree
from aseme_dsl.play import scenario as play
from aseme_dsl.play.evaluate import not_evaluated
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.board import NEVER
from aseme_dsl.runtime.monitor import rules
from aseme_dsl.runtime.team.network import Network
from aseme_dsl.source import Source, Span


class _NotPlayed(Exception):
    """Something cannot be played."""

    def __init__(self, span: Span, reason: str) -> None:
        super().__init__(reason)
        self.refused = play.Refused(span, reason)


class _NotThere(_NotPlayed):
    """No agent that is meant takes part."""


def _refuse(node: nodes.Statement | nodes.Condition | tree.Name | Value, reason: str) -> NoReturn:
    raise _NotPlayed(node.span, reason)


def played(
    files: Iterable[tree.File],
    known: Known,
    charts: Mapping[str, Statechart],
    blocks: Blocks,
    bound: Mapping[str, str],
) -> tuple[play.Scenario, ...]:
    """The scenarios of files without errors, as they are played; `any ROLE` is the agent `bound` to it."""
    places = Places(charts, blocks, known.aliases)
    always = properties(files)
    return tuple(
        _scenario(item, statements, always, check, places, bound)
        for item, statements, check in scenarios(files, known)
    )


def watched(
    files: Iterable[tree.File],
    known: Known,
    charts: Mapping[str, Statechart],
    blocks: Blocks,
    team: Mapping[str, str],
) -> play.Scenario:
    """What properties and clauses of files without errors say of a run of a team.

    It is a scenario in which nothing is given. If it is refused, it has a script of what is not.
    """
    check = Check(known, team, is_listed=False, is_broken=False, is_read=True)
    places = Places(charts, blocks, known.aliases)
    span = next((item.title.span for file in files for item in file.must_hold), Span(Source("", ""), 0, 0))
    script = _Lowering(check, places, span, {}, {}).script((), properties(files), may_fail=True)
    return play.Scenario("", span, (script,), _refused((script,)))


def _refused(scripts: Iterable[play.Script]) -> play.Refused | None:
    """Why what a property says is not watched."""
    silent = (item for script in scripts for item in script.silent)
    return next((play.Refused(item.span, item.reason) for item in silent if item.is_refused), None)


def _scenario(
    item: tree.Scenario,
    statements: Sequence[nodes.Statement],
    always: Sequence[tuple[str, nodes.Statement]],
    check: Check,
    places: Places,
    bound: Mapping[str, str],
) -> play.Scenario:
    name, title = item.title.text, item.title.span
    setups = (statement for statement in statements if isinstance(statement, nodes.Setup))
    given = [statement.points for statement in setups if statement.points is not None]
    points = sum(given) if given else None
    try:
        tables = [statement for statement in statements if isinstance(statement, nodes.Table)]
        rows: list[tuple[tree.Expression, ...]] = [cells for table in tables for cells, _ in table.rows] or [
            ()
        ]
        columns = [column.text for table in tables for column in table.columns]
        scripts = tuple(
            _Lowering(check, places, title, dict(zip(columns, cells, strict=True)), bound).script(
                statements, always
            )
            for cells in rows
        )
    except _NotPlayed as problem:
        return play.Scenario(name, title, (), problem.refused, points)
    return play.Scenario(name, title, scripts, _refused(scripts), points, item.span)


# ---- one way to play a scenario ---------------------------------------------------------------------


@dataclass(slots=True)
class _Lowering:
    """Makes the script of a scenario; `row` is what its table gives the columns this time."""

    check: Check
    places: Places
    title: Span
    row: Mapping[str, tree.Expression]
    bound: Mapping[str, str]
    conditions: list[play.Condition] = field(default_factory=list)
    expectations: list[play.Expectation] = field(default_factory=list)
    stimuli: list[play.Stimulus] = field(default_factory=list)
    cuts: list[play.Cut] = field(default_factory=list)
    activities: dict[str, play.Acting] = field(default_factory=dict)
    assumptions: list[play.Assumption] = field(default_factory=list)
    silent: list[play.Silent] = field(default_factory=list)
    network: Network | None = None
    """That of the run."""

    @property
    def team(self) -> Mapping[str, str]:
        return self.check.agents

    def script(
        self,
        statements: Sequence[nodes.Statement],
        always: Sequence[tuple[str, nodes.Statement]],
        may_fail: bool = False,
    ) -> play.Script:
        """What is played; `always` is what the properties say."""
        values = {
            name: self._constant(cell, name)
            for name, cell in self.row.items()
            if name not in self.check.chosen
        }
        setups = [item for item in statements if isinstance(item, nodes.Setup)]
        networks = [item.network for item in setups if item.word == "network"]
        inputs = tuple(self._input(item) for item in statements if isinstance(item, nodes.Input))
        given = [
            item.times[0].nanoseconds
            for item in statements
            if isinstance(item, nodes.Timed)
            and item.word == "at"
            and isinstance(item.event, nodes.Receives | nodes.Raises)
        ]
        self.network = networks[0] if networks else None
        for item in sorted(statements, key=_comes_last):
            self._statement(item, given)
        for name, item in always:
            self._always(name, item)
        for protocol in self.places.blocks.aips:
            self._clauses(protocol)
        self._guarantees()
        if not may_fail:
            self._add_failures(statements)
        return play.Script(
            tuple(self.team.items()),
            tuple(self.activities.values()),
            self.network,
            tuple(self.cuts),
            tuple(self.stimuli),
            tuple(self.conditions),
            tuple(self.expectations),
            inputs,
            values,
            {name: cell.span.text for name, cell in self.row.items()},
            *_end(statements),
            next((item.world for item in setups if item.word == "world"), None),
            tuple(self.assumptions),
            next((_until(item) for item in setups if item.word == "stepwise"), None),
            tuple(self.silent),
        )

    def _constant(self, cell: tree.Expression, column: str) -> object:
        value = self.check.value(cell, None)
        assert value is not None
        found = fold(value)
        return float(found) if self.check.parameters[column] == DOUBLE else found

    def _input(self, item: nodes.Input) -> play.Given:
        ends = [self.check.value(written, None) for written in (item.least, item.most)]
        least, most = (fold(value) for value in ends if value is not None)
        assert isinstance(least, int | float) and isinstance(most, int | float)
        is_whole = self.check.parameters[item.name.text] != DOUBLE
        return play.Given(item.name.text, least, most, is_whole, item.span)

    def _always(self, name: str, item: nodes.Statement) -> None:
        """What a property says of those that take part. It may say nothing in this run, or be refused."""
        before = len(self.expectations)
        try:
            self._statement(item, ())
        except _NotPlayed as problem:
            is_refused = not isinstance(problem, _NotThere)
            if is_refused or not isinstance(item, nodes.AssumedSo):
                span, reason = problem.refused.span, problem.refused.reason
                self.silent.append(play.Silent(name, span, reason, is_refused))
        of = f'property "{name}"'
        self.expectations[before:] = [replace(new, of=of) for new in self.expectations[before:]]

    def _clauses(self, protocol: tree.Aip) -> None:
        """What the clauses of a protocol say of those that take part, in each conversation if it has some."""
        name = protocol.name.text
        has_messages = any(item.sends or item.receives for item in protocol.participants)
        for item in protocol.clauses:
            before = len(self.expectations)
            with suppress(_NotThere):
                self._clause(item, name)
            self.expectations[before:] = [
                replace(new, of=f"clause of {name}", protocol=name if has_messages else None)
                for new in self.expectations[before:]
            ]

    def _clause(self, item: tree.Clause, protocol: str) -> None:
        first, *others = (
            self._in_places(self.team, places, item, protocol)
            for places in (item.first, item.second)
            if places
        )
        if item.kind == "at most":
            rule = rules.Never(self._number(play.InPlaces(first, item.count + 1)))
            self._expect(rule, item.span, None, (self._number(play.InPlaces(first)),))
            return
        one, two = (self._number(play.InPlaces(places)) for places in (first, others[0]))
        if item.kind == "before":
            self._expect(rules.Before(one, two), item.span, None, (two,))
        else:
            within = None if item.within is None else item.within.nanoseconds
            self._expect(rules.LeadsTo(one, two, within), item.span, None, (one,))

    def _guarantees(self) -> None:
        """What the activities guarantee that some agent performs."""
        known = self.check.known
        for activity in known.activities.values():
            roles = known.performed.get(activity.name, frozenset())
            agents = frozenset(agent for agent, role in self.team.items() if role in roles)
            for item in activity.guarantees if agents else ():
                number = self._number(play.Breached(activity.name, item, agents))
                of = f"{play.GUARANTEE}{activity.name}"
                self.expectations.append(play.Expectation(rules.Never(number), item.span, of=of))

    def _add_failures(self, statements: Iterable[nodes.Statement]) -> None:
        """No agent may fail but those that are to."""
        failing = {item.agent.text for item in statements if isinstance(item, nodes.Fails)}
        others = frozenset(self.team) - failing
        if others:
            self._expect(rules.Never(self._number(play.Failed(others))), self.title, None)

    def _number(self, condition: play.Condition) -> int:
        self.conditions.append(condition)
        return len(self.conditions) - 1

    def _expect(
        self,
        rule: rules.Rule,
        span: Span,
        share: nodes.Share | None,
        witnesses: tuple[int, ...] = (),
        parts: tuple[nodes.Condition, ...] = (),
    ) -> None:
        spans = tuple(part.span for part in parts)
        self.expectations.append(play.Expectation(rule, span, witnesses, _share(share), parts=spans))

    # ---- statements ------------------------------------------------------------------------------

    def _statement(self, item: nodes.Statement, given: Sequence[int]) -> None:
        match item:
            case nodes.TakesPart() | nodes.Input() | nodes.Table():
                pass  # looked at before
            case nodes.Setup(word=word):
                if word == "assume" and item.network is not None:
                    self._assume_network(item, item.network)
            case nodes.Simulated():
                self._simulated(item)
            case nodes.Hit():
                _refuse(item, "it needs a moment")
            case nodes.Timed():
                self._timed(item, given)
            case nodes.Rule():
                self._rule(item)
            case nodes.Several():
                self._several(item)
            case nodes.Fails(agent=agent, by=by):
                failed = self._number(play.Failed(frozenset((self._agent(agent),))))
                self._expect(rules.Sometime(failed, 0, by.nanoseconds), item.span, None)
            case nodes.Assumed():
                self._assume(item)
            case nodes.AssumedSo(condition=condition):
                assert condition.agent is not None
                for name in self._meant(condition.agent, condition.which):
                    value = self._value(condition.expression, self.team[name])
                    self.assumptions.append(play.ValueAssumed(name, value, item.span))
            case _:
                assert_never(item)

    def _simulated(self, item: nodes.Simulated) -> None:
        name = item.activity.text
        activity = self.check.known.activities.get(name)
        usual = activity.ends[:1] if activity is not None else ()
        self.activities[name] = play.Acting(
            name,
            item.span,
            item.is_real,
            _lasts(item.takes) or _declared(activity.takes if activity is not None else None),
            tuple(end.text for end in item.ends) or usual,
            None if item.fails is None else item.fails.nanoseconds,
            tuple(play.Writes(self._content(message), _lasts(pace)) for message, pace in item.writes),
            tuple((variable.text, self._value(value, None)) for variable, value in item.sets),
            tuple(self._content(message) for message in item.sends),
        )

    def _timed(self, item: nodes.Timed, given: Sequence[int]) -> None:
        moment = item.times[0].nanoseconds
        about = self._about(item)
        match item.word, item.event:
            case "from" | "at", nodes.Hit(word="partition" | "loses") as hit:
                last = item.times[1].nanoseconds if item.word == "from" else NEVER
                self._cut(hit, moment, last)
            case "at", nodes.Reached(condition=condition):
                rule = rules.At(self._condition(condition, about), moment)
                self._expect(rule, item.span, item.share, (), (condition,))
            case "at", _:
                self.stimuli.append(play.Stimulus(self._act(item.event), moment, item.span))
            case "by", nodes.Reached(condition=condition):
                since = max((earlier for earlier in given if earlier < moment), default=0)
                some = rules.Sometime(self._condition(condition, about), since, moment)
                self._expect(some, item.span, item.share, (), (condition,))
            case "after", nodes.Reached(condition=condition):
                assert item.of is not None
                trigger = self._condition(item.of, about)
                first = rules.AfterFirst(trigger, moment, self._condition(condition, about))
                self._expect(first, item.span, item.share, (trigger,), (item.of, condition))
            case "after", nodes.Receives() | nodes.Raises():
                assert item.of is not None
                trigger = self._condition(item.of, about)
                self.stimuli.append(play.Stimulus(self._act(item.event), moment, item.span, trigger))
            case "within", nodes.Reached(condition=condition):
                assert item.of is not None
                trigger, then = self._condition(item.of, about), self._condition(condition, about)
                leads = rules.LeadsTo(trigger, then, moment)
                self._expect(leads, item.span, item.share, (trigger,), (item.of, condition))
            case _:
                _refuse(item, "it is not played yet")

    def _rule(self, item: nodes.Rule) -> None:
        about = self._about(item)
        parts = tuple(item.conditions)
        found = tuple(self._condition(condition, about) for condition in parts)
        within = None if item.within is None else item.within.nanoseconds
        match item.word, found:
            case "always", (first,):
                self._expect(rules.Always(first), item.span, item.share, (), parts)
            case "never", (first,):
                several = self.conditions[first]
                witnesses = several.parts if isinstance(several, play.AllOf) else ()
                self._expect(rules.Never(first), item.span, item.share, witnesses, parts)
            case "no before", (first,):
                assert within is not None
                self._expect(rules.Never(first, within), item.span, item.share, (), parts)
            case "no within", (first, second):
                assert within is not None
                rule = rules.NotWithin(first, second, within)
                self._expect(rule, item.span, item.share, (second,), parts[::-1])
            case "eventually", (first,):
                until = NEVER if within is None else within
                self._expect(rules.Sometime(first, 0, until), item.span, item.share, (), parts)
            case "in order", _:
                self._expect(rules.InOrder(found), item.span, item.share, (), parts)
            case "leads to", (first, second):
                leads = rules.LeadsTo(first, second, within)
                self._expect(leads, item.span, item.share, (first,), parts)
            case "before", (first, second):
                self._expect(rules.Before(first, second), item.span, item.share, (second,), parts)
            case "until", (first, second):
                self._expect(rules.Until(first, second), item.span, item.share, (), parts)
            case _:
                _refuse(item, "it is not played yet")

    def _several(self, item: nodes.Several) -> None:
        role = None if item.role is None else model_name(item.role)
        agents = [agent for agent, played in self.team.items() if role in (None, played)]
        if item.word == "assume":
            self.assumptions.append(play.CrashesAssumed(item.count, frozenset(agents), item.span))
            return
        places = self._in_places(agents, item.places, item)
        least = item.count + 1 if item.word == "at most" else item.count
        rule = rules.Never(self._number(play.InPlaces(places, least)))
        self._expect(rule, item.span, item.share, (self._number(play.InPlaces(places)),))

    # ---- what is assumed ---------------------------------------------------------------------------

    def _assume(self, item: nodes.Assumed) -> None:
        """What is assumed of an activity; a normal distribution has no bounds."""
        if not item.times:
            self.assumptions.append(play.FailuresAssumed(item.activity.text, item.span))
            return
        lasts = _lasts(item.times[0])
        if lasts is None or lasts.is_normal:
            return
        name = item.activity.text
        if item.writes is None:
            self.assumptions.append(play.DurationAssumed(name, lasts, item.span))
        else:
            channel = self.check.channel(item.writes)
            self.assumptions.append(play.PaceAssumed(name, str(channel), lasts, item.span))

    def _assume_network(self, item: nodes.Setup, assumed: Network) -> None:
        """The network of the run is other than assumed from 0 on, or from when an agent is cut off.

        Without one, nothing is said of delays: messages may be quicker than is assumed.
        """
        real = self.network or Network()
        is_other = (
            real.most > assumed.most
            or (self.network is not None and real.least < assumed.least)
            or (real.loss > 0 and not assumed.loss)
            or (real.reorder and not assumed.reorder)
        )
        moments = [0] if is_other else [cut.first for cut in self.cuts]
        self.assumptions.append(play.NetworkAssumed(min(moments, default=None), item.span, assumed))

    # ---- what happens ----------------------------------------------------------------------------

    def _cut(self, hit: nodes.Hit, first: int, last: int) -> None:
        groups = hit.groups or (hit.agents,)
        named = [self._agent(agent) for agent in hit.agents]
        if hit.groups and sorted(named) != sorted(self.team):  # a role that `--role` has bound
            _refuse(hit, "each agent that takes part stands in one of the groups")
        for group in groups[: max(1, len(groups) - 1)]:
            self.cuts.append(play.Cut(frozenset(map(self._agent, group)), first, last))

    def _act(self, event: nodes.Event) -> play.Act:
        match event:
            case nodes.Receives(agent=agent, message=message, sender=sender):
                by = "input" if sender is None else sender.text
                return play.Receives(self._agent(agent), self._content(message), by)
            case nodes.Raises(agent=agent, event=name):
                return play.Raises(self._agent(agent), name.text)
            case nodes.Hit(word="crash", agents=(agent,)):
                return play.Crashes(self._agent(agent))
            case nodes.Does():
                return self._does(event)
            case nodes.Gets(agent=agent, performative=performative, what=what, sender=sender):
                channel = None if what is None else self._channel(what)
                kind = "" if what is None else what.text if channel is None else str(channel)
                spoken = None if performative is None else performative.text
                if (channel is None) == (spoken is None):
                    reason = "write `gets topic.state.M from A`, or `gets inform M from A`"
                    raise _NotPlayed(event.span, reason)
                return play.Gets(self._agent(agent), self._agent(sender), spoken, kind, event.is_lost)
            case nodes.Computes(agent=agent, function=function, value=written):
                return play.Computes(self._agent(agent), function.text, self._value(written, None))
            case nodes.Hit(word="restart", agents=(agent,)):
                return play.Restarts(self._agent(agent))
            case nodes.Hit() | nodes.Reached():
                raise _NotPlayed(event.span, "it is not played yet")
            case _:
                assert_never(event)

    def _does(self, event: nodes.Does) -> play.Does:
        """What an activity does by hand."""
        name = event.activity.text
        activity = self.check.known.activities.get(name)
        usual = activity.ends[:1] if activity is not None and event.verb == "ends" else ()
        return play.Does(
            self._agent(event.agent),
            play.Acting(
                name,
                event.span,
                ends=usual if event.outcome is None else (event.outcome.text,),
                writes=tuple(play.Writes(self._content(message), None) for message in event.writes),
                sets=tuple((variable.text, self._value(value, None)) for variable, value in event.sets),
            ),
            event.verb == "ends",
            tuple(
                play.Content(message.what.text, self._members(message, is_content=True), message.span)
                for message in event.prepares
            ),
            tuple(
                (None if performative is None else performative.text, message.text)
                for performative, message in event.takes
            ),
            tuple((self._content(message), part.text) for message, part in event.sends),
            event.verb == "fails",
        )

    def _members(
        self, message: nodes.Filled, *, is_content: bool = False
    ) -> tuple[tuple[tuple[str, ...], Value], ...]:
        fills = self.check.fills(message, is_content=is_content)
        return tuple((item.path, self._supported(item.value)) for item in fills)

    def _content(self, message: nodes.Filled) -> play.Content:
        channel = self._channel(message.what)
        performative = None if message.performative is None else message.performative.text
        if (channel is None) != (performative is not None):
            raise _NotPlayed(
                message.span,
                "it is neither a message on a channel, as `topic.state.M { .. }`, nor an agent message, as"
                " `inform M { .. }`",
            )
        members = self._members(message)
        what = str(channel) if channel is not None else message.what.text
        return play.Content(what, members, message.span, performative)

    def _channel(self, path: tree.Path) -> Channel | None:
        """The channel, if the path names one; else it is a type of message."""
        kinds = {kind.value for kind in ChannelKind}
        is_channel = any(segment.text in kinds for segment in path.segments[1:3])
        return self.check.channel(path) if is_channel else None

    # ---- conditions ------------------------------------------------------------------------------

    def _about(self, item: nodes.Statement) -> str | None:
        """The agent that the bare conditions of a sentence are about: the only one, if there is one only."""
        named = only_agent(item)
        playing = self._playing(named) if named is not None else tuple(self.team)
        return playing[0] if len(playing) == 1 else None

    def _agent(self, name: tree.Name) -> str:
        """An agent by its name, or the one that plays the role or is bound to it."""
        playing = self._bound(name) or self._playing(name)
        if not playing:
            raise _NotThere(name.span, f"{name.text} does not take part")
        if len(playing) != 1:
            count, role = len(playing), name.text
            _refuse(
                name,
                f"{count} agents play {role}: name one, write `some {role}` or `every {role}`,"
                f" or choose the one that `any {role}` is with `asemec test --role {role}={playing[0]}`",
            )
        return playing[0]

    def _bound(self, name: tree.Name) -> tuple[str, ...]:
        """The agent that the user has chosen for a role."""
        agent = self.bound.get(name.text)
        if agent is None or name.text in self.team:
            return ()
        if self.team.get(agent) != model_name(name):
            _refuse(name, f"`--role {name.text}={agent}`: {agent} does not take part as {name.text}")
        return (agent,)

    def _playing(self, name: tree.Name) -> tuple[str, ...]:
        """The agent of that name, or those that play the role."""
        if name.text in self.team:
            return (name.text,)
        return tuple(agent for agent, role in self.team.items() if role == model_name(name))

    def _meant(self, name: tree.Name, which: str) -> tuple[str, ...]:
        """The agents that a condition is about."""
        return self._playing(name) if which in ("some", "every") else (self._agent(name),)

    def _condition(self, item: nodes.Condition, about: str | None) -> int:
        match item:
            case nodes.Joined(operator=operator, parts=written):
                parts = tuple(self._condition(part, about) for part in written)
                if operator == "not":
                    return self._number(play.NotSo(parts[0]))
                return self._number(play.AllOf(parts) if operator == "and" else play.AnyOf(parts))
            case nodes.InState(agent=None, places=(place,)) if self.check.is_value(place, self._role(about)):
                return self._holds(item, about, tree.Path((place.name,), place.name.span))
            case nodes.InState(agent=agent, places=places, which=which):
                agents = tuple(self.team) if agent is None else self._meant(agent, which)
                least = len(agents) if which == "every" else 1
                return self._number(play.InPlaces(self._in_places(agents, places, item), least))
            case nodes.Holds(agent=agent, expression=expression, which=which):
                if agent is None:
                    return self._holds(item, about, expression)
                found = tuple(self._holds(item, each, expression) for each in self._meant(agent, which))
                return self._number(play.AllOf(found) if which == "every" else play.AnyOf(found))
            case nodes.Heard(verb=verb) if verb.text == "untaken":
                return self._number(self._untaken(item))
            case nodes.Heard():
                return self._number(self._says(item, about))
            case nodes.Ended():
                return self._ended(item)
            case nodes.Fault():
                return self._number(play.Faulty())
            case _:
                assert_never(item)

    def _untaken(self, item: nodes.Heard) -> play.Untaken:
        if item.condition is not None or self._channel(item.what) is not None:
            _refuse(item, "`untaken` is about an agent message of some type, not about what it says")
        agents = None if item.agent is None else frozenset(self._meant(item.agent, item.which))
        performative = None if item.performative is None else item.performative.text
        return play.Untaken(item.what.text, performative, agents)

    def _ended(self, item: nodes.Ended) -> int:
        """An outcome of a protocol is reached where one of its places is entered, in any agent."""
        found: dict[str, frozenset[str]] = {}
        places = [
            (place, protocol.name.text)
            for protocol in self.places.blocks.aips
            for outcome in protocol.outcomes
            if outcome.text.text == item.text.text
            for place in outcome.when
        ]
        if not places:
            text = item.text.span.text
            _refuse(item, f"the protocol does not say when: write `outcome {text} when PLACE@PARTICIPANT`")
        for place, protocol in places:
            for agent, labels in self._labels(self.team, (place,), protocol).items():
                found[agent] = found.get(agent, frozenset()) | labels
        return self._number(play.InPlaces(_there(found, item)))

    def _role(self, agent: str | None) -> str | None:
        return None if agent is None else self.team[agent]

    def _holds(self, item: nodes.Condition, agent: str | None, written: tree.Expression) -> int:
        if agent is None:
            _refuse(item, "which agent is meant? write `robot1 has [...]`")
        return self._number(play.Holds(agent, self._value(written, self.team[agent])))

    def _value(self, written: tree.Expression, role: str | None) -> Value:
        value = self.check.value(written, role)
        assert value is not None
        return self._supported(value)

    def _supported(self, value: Value) -> Value:
        for part in not_evaluated(value):
            _refuse(part, f"`{part.span.text}` is not evaluated in scenarios yet")
        return value

    def _in_places(
        self,
        agents: Iterable[str],
        places: Iterable[tree.Place],
        item: nodes.Statement | nodes.Condition | tree.Clause,
        protocol: str | None = None,
    ) -> dict[str, frozenset[str]]:
        """The labels of the places in the statechart of each agent that has some. Those of a `protocol` are
        in its participants."""
        return _there(self._labels(agents, places, protocol), item)

    def _labels(
        self, agents: Iterable[str], places: Iterable[tree.Place], protocol: str | None
    ) -> dict[str, frozenset[str]]:
        found: dict[str, frozenset[str]] = {}
        for agent in agents:
            labels: set[str] = set()
            for place in places:
                chosen = self.row.get(place.name.text) if place.name.text in self.check.chosen else None
                name = chosen.text if isinstance(chosen, tree.Path) else place.name.text
                at = None if place.at is None else place.at.text
                if protocol is not None and at is None:
                    at = name  # a participant
                labels |= self.places.labels(self.team[agent], name, at, protocol)
            if labels:
                found[agent] = frozenset(labels)
        return found

    def _says(self, item: nodes.Heard, about: str | None) -> play.Says:
        channel = self._channel(item.what)
        agents = None if item.agent is None else self._meant(item.agent, item.which)
        condition = None
        if item.condition is not None:
            kind = self.check.carried(item.what)
            whose = agents[0] if agents else about
            found = self.check.value(item.condition, self._role(whose), BOOL, taken_by(item, kind))
            assert found is not None
            condition = self._supported(found)
        return play.Says(
            item.what.text if channel is None else str(channel),
            channel is None,
            item.verb.text == "received",
            None if item.performative is None else item.performative.text,
            None if agents is None else frozenset(agents),
            condition,
        )


def _there(
    found: dict[str, frozenset[str]], item: nodes.Statement | nodes.Condition | tree.Clause
) -> dict[str, frozenset[str]]:
    """Places that some agent has."""
    if not found:
        raise _NotThere(item.span, "no agent that takes part has this place in its statechart")
    return found


def _comes_last(item: nodes.Statement) -> bool:
    """Whether a statement needs to know the others: what is assumed of the network."""
    return isinstance(item, nodes.Setup) and item.word == "assume"


def _lasts(written: nodes.Lasts | None) -> play.Lasts | None:
    if written is None:
        return None
    return play.Lasts(written.least.nanoseconds, written.most.nanoseconds, written.is_normal)


def _declared(takes: int | None) -> play.Lasts | None:
    return None if takes is None else play.Lasts(takes, takes)


def _share(written: nodes.Share | None) -> play.Share | None:
    if written is None:
        return None
    assert isinstance(written.percent, tree.Number) and isinstance(written.seeds, tree.Number)
    seeds = int(written.seeds.value)
    return play.Share(-int(-written.percent.value * seeds // 100), seeds)


def _until(item: nodes.Setup) -> int:
    """Until when a scenario is played by hand."""
    return NEVER if item.duration is None else item.duration.nanoseconds


def _end(statements: Sequence[nodes.Statement]) -> tuple[int, bool]:
    """The end of the run: what the scenario says, or its last moment; whether some statement has none."""
    for item in statements:
        if isinstance(item, nodes.Setup) and item.word == "for" and item.duration is not None:
            return item.duration.nanoseconds, False
    is_open = False
    moments: list[int] = []
    delays = [0]
    for item in statements:
        match item:
            case nodes.Timed(word="after" | "within", times=times):
                delays.append(times[0].nanoseconds)
            case nodes.Timed(times=times):
                moments += [time.nanoseconds for time in times]
            case nodes.Fails(by=by):
                moments.append(by.nanoseconds)
            case nodes.Rule(word="no before" | "eventually", within=tree.Duration() as within):
                moments.append(within.nanoseconds)
            case nodes.Rule(word="no within" | "leads to", within=tree.Duration() as within):
                delays.append(within.nanoseconds)
            case nodes.Rule(word="eventually" | "leads to" | "in order"):
                is_open = True
            case _:
                pass
    return (max(moments) + max(delays), is_open) if moments else (0, True)


__all__ = ["played", "watched"]
