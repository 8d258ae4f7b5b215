"""Observer: follows a run by the lines of its trace, and shows the rules of a scenario what happens."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import field, replace
from typing import TYPE_CHECKING, assert_never, cast

from aseme_dsl.amola import expression as e
from aseme_dsl.play.assumptions import Assumptions
from aseme_dsl.play.conversations import Clauses
from aseme_dsl.play.evaluate import Known, Told, ages, asked, counted, timers, value_of
from aseme_dsl.play.followed import Followed, answer, around, entered_by
from aseme_dsl.play.promises import Promises
from aseme_dsl.play.scenario import (
    AllOf,
    AnyOf,
    Breached,
    Condition,
    Failed,
    Faulty,
    Holds,
    InPlaces,
    NotSo,
    Says,
    Script,
    Untaken,
    all_parts,
)
from aseme_dsl.play.sight.alarms import Alarms
from aseme_dsl.play.sight.guards import told
from aseme_dsl.play.sight.insight import Surroundings
from aseme_dsl.play.sight.instead import Instead, located
from aseme_dsl.play.sight.standing import standing
from aseme_dsl.play.sight.story import Happened
from aseme_dsl.play.sight.storyteller import About, Storyteller
from aseme_dsl.play.sight.words import Said, failing, few, leaf_names, went_wrong
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.plan import Plan
from aseme_dsl.runtime.monitor.rules import InOrder, State, Verdict, View, ended, seen
from aseme_dsl.runtime.team.ending import Unread, Waiting
from aseme_dsl.runtime.trace.records import Record

if TYPE_CHECKING:
    from aseme_dsl.play.sight.subject import Next

KINDS = frozenset(
    (
        "step",
        "message",
        "agent_message",
        "received",
        "radio_received",
        "arrived",
        "fault",
        "error",
        "activity",
        "conversation",
        "lost",
        "unexpected",
        "unsent",
        "refused",
        "expired",
    )
)


@dataclass(frozen=True, slots=True)
class _Happening:
    """What is new at a point."""

    entered: Mapping[str, frozenset[str]] = field(default_factory=dict)
    sent: Said | None = None
    received: tuple[tuple[str, Said], ...] = ()
    is_fault: bool = False
    untaken: tuple[str, str | None, str] | None = None
    """Who does not take an agent message, with its performative and type."""
    breached: frozenset[int] = frozenset()
    """The conditions about guarantees that are broken."""
    failed: str | None = None


_NOTHING = _Happening()
_NONE: frozenset[str] = frozenset()


class Observer:
    """Follows one run. A listener of its trace; `settled` is asked at the end of each instant."""

    def __init__(
        self,
        script: Script,
        inputs: Mapping[str, object],
        *,
        goes_on: bool = False,
        teller: Storyteller | None = None,
    ) -> None:
        """What comes after an expectation was broken is not part of the run, unless it `goes_on`."""
        self.script = script
        self._teller = teller
        self._goes_on = goes_on
        self.states = [State() for _ in script.expectations]
        self.met: set[int] = set()
        """The conditions that were met at some point."""
        self.broken: int | None = None
        """The first expectation that was broken, of those that every run has to meet."""
        self.read = ""
        """What the broken condition has read: `one has n = 4`, `one is in Walk`."""
        self.near = ""
        """Which message came that is not the awaited one, and why: `ann sent Ball at 3 s, but …`."""
        self.reached: dict[int, int] = {}
        """When an expectation has come as far as it is (ns)."""
        self.given: set[tuple[str, int]] = set()
        """The identities of what the scenario has given in the name of an agent."""
        self.failures: dict[str, str] = {}
        """Why agents have failed."""
        self.faults: list[str] = []
        self.waiting: dict[int, list[Callable[[int], None]]] = {}
        """Called with the moment at which a condition occurs for the first time, in the midst of a step."""
        self.assumed = Assumptions(script.assumptions)
        self._alarms = Alarms(self.look)
        self._promises = Promises(script.conditions)
        self._clauses = Clauses(script.expectations, script.conditions, self._alarms)
        self._inputs = inputs
        self._agents = {name: Followed() for name, _ in script.team}
        self._said: dict[tuple[str, int], Said] = {}
        self._arrived: dict[tuple[str, str, int], int] = {}
        self._instead = Instead()
        self.came: dict[int, int] = {}
        """When the conditions of orders have occurred last (ns)."""
        self._ordered = frozenset(
            number
            for item in script.expectations
            if isinstance(item.rule, InOrder)
            for number in item.rule.conditions
        )
        self._held: frozenset[int] = frozenset()
        self._passing = _passing(script.conditions)
        self._aged = _aged(script.conditions)
        values = [item.value for item in script.conditions if isinstance(item, Holds)]
        self._counted = frozenset(name for value in values for name in counted(value))
        self._timers = frozenset(name for value in values for name in timers(value))
        self._kept = frozenset(
            name for value in values for kind in (e.At, e.Mean) for name in asked(value, kind)
        )
        self._now = 0
        self._roles = dict(script.team)
        self._surroundings: Surroundings | None = None
        self._is_over = False

    def begin(self, surroundings: Surroundings) -> None:
        """The run of the team begins."""
        self._surroundings = surroundings
        self._alarms.begin(surroundings)
        for place, item in enumerate(self.script.expectations):
            self._alarms.mind(place, item.rule, self.states[place])

    def wants(self, kind: str, what: str | None) -> bool:
        if kind == "activity":
            tells = self._teller is not None and what in (None, "end", "crash")
            return tells or self.assumed.minds_activities
        return kind in KINDS

    def __call__(self, record: Record) -> None:
        if self._is_over or record["kind"] not in KINDS:
            return
        self._pass_to(record["time"])
        if self.broken is not None and not self._goes_on and self.states[self.broken].at < self._now:
            return  # what comes later is not part of the story
        self.assumed.see(record)
        match record["kind"]:
            case "step":
                self._step(record)
            case "message" | "agent_message" | "received" | "radio_received":
                self._say(record)
            case "arrived":
                agent, number = record["input"]
                self._arrived[record["agent"], str(agent), int(number)] = record["measured"]
            case "fault":
                self.faults.append(record["reason"])
                self._instead.failed(record["agent"], str(record["reason"]), self._now)
                self._note(record["agent"], f"fault: {record['reason']}")
                self._look(_Happening(is_fault=True))
            case "error":
                why = failing(self._plan(record["agent"]), record["reason"])
                self.failures[record["agent"]] = why
                self._note(record["agent"], f"fails: {why}")
                self._look(_Happening(failed=record["agent"]))
            case "conversation" if record["agent"] in self._agents:
                if self._teller is not None and record["what"] == "gone" and "sequence" in record:
                    self._teller.gone(record)
                if self._clauses:
                    branches = {info.label: info.protocol for info in self._plan(record["agent"]).branches}
                    self._clauses.conversation(record, branches[record["branch"]], self._now)
                    self._take_clauses()
            case "activity" if record["what"] in ("end", "crash") and self._teller is not None:
                self._teller.end(record)
            case "lost" | "unexpected" | "unsent" | "refused" | "expired":
                if record["kind"] == "unsent":
                    self._instead.failed(record["agent"], went_wrong(record), self._now)
                if record["kind"] == "unexpected":  # it has arrived
                    sender, number = record["input"]
                    if self._teller is not None:
                        self._teller.arrived(record["agent"], (str(sender), int(number)))
                self._note(record["agent"], went_wrong(record))
                if record["kind"] == "unexpected":
                    what = record.get("performative"), str(record.get("message", ""))
                    self._look(_Happening(untaken=(record["agent"], *what)))

    # ---- time --------------------------------------------------------------------------------

    def settled(self, team: object = None) -> str | None:
        """Nothing is left to do at this instant; why the run ends, if it does."""
        self._pass_to(self._around.now())
        return "broken" if self.broken is not None else None

    def _pass_to(self, moment: int) -> None:
        """Time passes: until then all has rested."""
        if moment > self._now:
            self._show(self._view(_NOTHING, self._now, moment - 1, rests=True))
            if self._clauses:
                self._clauses.rest(self._now, moment - 1)
                self._take_clauses()
            self._now = moment

    def look(self) -> None:
        """Time alone may have changed something."""
        if self._surroundings is not None and not self._is_over:
            self._pass_to(self._around.now())
            self.look_now()

    def look_now(self) -> None:
        """Something may have changed without a step, at the moment of what has come last."""
        self._look(_NOTHING)
        if self._clauses:
            self._clauses.look(self._now)
            self._take_clauses()

    def end(self, moment: int, unread: Iterable[Unread] = ()) -> None:
        """The run was to end at this moment: nothing changes any more, and nothing takes what is `unread`."""
        if self.broken is None:
            for letter in unread:
                said = letter.agent, letter.performative, letter.message
                self._look(_Happening(untaken=said))
            self._pass_to(moment + 1)
            self.assumed.pass_to(moment + 1)
            for place, item in enumerate(self.script.expectations):
                if not item.of.startswith("clause"):  # its conversation may have been cut off
                    self._take(place, ended(item.rule, self.states[place], moment))
        self._is_over = True

    def places(self) -> dict[str, frozenset[str]]:
        """The labels of the states that each agent is in."""
        return {name: agent.active for name, agent in self._agents.items()}

    def rest(self, moment: int) -> None:
        """A run that may have been cut off ended at this moment: what is still awaited stays so."""
        self._pass_to(moment + 1)

    @property
    def now(self) -> int:
        """How far the run has come (ns)."""
        return self._now

    def is_awaited(self, number: int, moment: int) -> bool:
        """Whether something that an expectation speaks of has still to come."""
        rule = self.script.expectations[number].rule
        if self.script.expectations[number].protocol is not None:
            return self._clauses.is_awaited(number, moment)
        state = self.states[number]
        return state.verdict is Verdict.OPEN and ended(rule, state, moment).verdict is Verdict.BROKEN

    # ---- what happens ------------------------------------------------------------------------

    def crashed(self, agent: str) -> None:
        """An agent has stopped dead: it is in no state, and knows nothing."""
        self._pass_to(self._around.now())
        self.assumed.crash(agent, self._now)
        self.forget(agent)
        self._note(agent, "crashes")
        self.look()

    def forget(self, agent: str) -> None:
        """An agent is in no state any more, and knows nothing."""
        self._agents[agent].forget()
        self._clauses.crash(agent, self._now)
        self._take_clauses()

    def restarted(self, agent: str) -> None:
        self.look()
        self._note(agent, "starts again")

    def _step(self, record: Record) -> None:
        agent = record["agent"]
        followed = self._agents[agent]
        plan = self._plan(agent)
        before = followed.active
        if plan.name != self._roles[agent]:  # it has switched: the labels of its role are not in use
            followed.active = _NONE
        elif "configuration" in record:
            leaves = record["configuration"]
            followed.active = frozenset(label for leaf in leaves for label in around(leaf))
        followed.has_begun = True
        entered = set(followed.active - before)
        if "configuration" in record:
            followed.leaves = tuple(record["configuration"])
        received = []
        for identity in record["inputs"]:
            said = self._said.get((str(identity[0]), int(identity[1])))
            if said is not None:
                self._receive(agent, said, (str(identity[0]), int(identity[1])))
                received.append((agent, said))
        for taken in record["taken"]:
            new = entered_by(plan, taken["transitions"])
            if self._counted:
                followed.count(plan, self._counted, new)
            if plan.name == self._roles[agent]:
                entered |= new
        if record["taken"] and self._teller is not None:
            self._teller.step(record, plan, followed.leaves, lambda: self._known(agent))
        if self._timers:
            self._wake_for_timers(agent)
        self._look(_Happening({agent: frozenset(entered)}, received=tuple(received)))
        if self._clauses:
            branches = (info.label for info in plan.branches)
            self._clauses.step(agent, branches, frozenset(entered), followed.active, self._now)
            self._take_clauses()

    def _take_clauses(self) -> None:
        """A clause that is broken in one conversation is broken."""
        for place, state in self._clauses.broken.items():
            self._take(place, state)

    def _wake_for_timers(self, agent: str) -> None:
        """Look again when a timer that a condition asks for runs out."""
        inside = self._around.insight(agent)
        for moment in (moment for name in self._timers for moment in inside.timers(name)):
            if moment > self._now:
                self._around.at(moment, self.look)

    def _receive(self, agent: str, said: Said, identity: tuple[str, int]) -> None:
        if self._teller is not None:
            self._teller.arrived(agent, identity)
            if said.sender != agent:
                self._teller.received(self._now, agent, said, identity)
        self._has_received(agent, said, identity)

    def _has_received(self, agent: str, said: Said, identity: tuple[str, int]) -> None:
        if said.performative is not None:
            return
        followed = self._agents[agent]
        measured = self._arrived.get((agent, *identity), said.moment)
        followed.receive(said.what, said.sender, said.content, measured, said.what in self._kept)
        for age in self._aged.get(said.what, ()):
            for moment in (measured + age, measured + age + 1):
                self._around.at(moment, self.look)

    def _say(self, record: Record) -> None:
        agent = record["agent"]
        sender = record.get("sender", agent)
        is_outside = record["kind"] == "received"
        if is_outside:
            sender = str(record["input"][0])
        performative = record.get("performative")
        if performative is not None:
            kind, content = str(record["message"]), record["content"]
            what = f"{performative} {kind}"
        else:
            what, content = record["channel"], record["message"]
            kind = what.rpartition(".")[2]
        said = Said(what, kind, performative, sender, cast(Told, content), self._now)
        if is_outside:
            self._said[sender, int(record["input"][1])] = said
            return
        self._said[agent, record["sequence"]] = said
        if record["kind"] != "radio_received" and sender in self._agents:
            self._instead.sent(said, record.get("to", ()))
            if self._teller is not None:
                is_given = agent not in self._agents or (agent, record["sequence"]) in self.given
                self._teller.sent(said, record, is_given)
            by = None if (agent, record["sequence"]) in self.given else record.get("activity")
            breached = self._promises.see(sender, by, what, said.content, self._now)
            self._look(_Happening(sent=said, breached=breached))

    def _plan(self, agent: str) -> Plan:
        return self._around.insight(agent).plan

    @property
    def _around(self) -> Surroundings:
        assert self._surroundings is not None
        return self._surroundings

    def _note(self, agent: str, text: str) -> None:
        """Something has happened to an agent."""
        if self._teller is not None:
            self._teller.note(self._now, agent, text)

    def story(self, waits: Mapping[str, Sequence[Waiting]], is_whole: bool = False) -> tuple[Happened, ...]:
        """What led to the end of the run, or to the broken expectation, and where each agent is then.

        `waits` is what each agent waits for. If it `is_whole`, it has all that happened to all agents.
        """
        teller = self._teller
        if teller is None:
            return ()
        subject = About() if is_whole else self._about()
        plans = {name: self._plan(name) for name in self._agents}
        leaves = {name: leaf_names(plans[name], item.leaves) for name, item in self._agents.items()}
        teller.guards.begin(plans, {name: few(names) or "no state" for name, names in leaves.items()})
        end = self._now if self.broken is None else self.states[self.broken].at
        story = teller.whole() if is_whole else [*teller.story(subject, self.script.cuts, end, self._plan)]
        for name, followed in self._agents.items():
            if subject.agents is None or name in subject.agents:
                place = subject.places.get(name, frozenset())
                given = (self._plan(name), waits.get(name, ()), followed.leaves, place)
                story += standing(name, end, *given, teller.guards, self._known(name), teller.came(name))
        return tuple(story)

    def _about(self) -> About:
        """What the story is about."""

        from aseme_dsl.play.sight.subject import about  # only who reads a story asks for it

        if self.broken is None:
            return About()
        rule, state = self.script.expectations[self.broken].rule, self.states[self.broken]
        return about(self.script, rule, state, self._plan, self.reached.get(self.broken))

    @property
    def question(self) -> Next | None:
        """What to ask next about the broken expectation."""
        from aseme_dsl.play.sight.subject import Next, question, turned_away

        if self.broken is None:
            return None
        rule, state = self.script.expectations[self.broken].rule, self.states[self.broken]
        found = question(self.script, rule, state, self._held, self._plan)
        close = self._instead.near
        near = next((close[number] for number in self._asked() if number in close), None)
        if found is None or found.is_why:
            return found
        if near is not None:  # that it came can be explained, with the values that it has
            agent, said = near
            return Next(agent, found.what, True, said.moment) if agent == said.sender else found
        if self._teller is None:
            return found
        plan = self._plan(found.agent)
        return replace(found, at=turned_away(plan, found.what, self._teller.taken(found.agent, plan)))

    def _asked(self) -> Iterator[int]:
        """The conditions that decide on the broken expectation, with all their parts."""
        from aseme_dsl.play.sight.subject import spoken

        if self.broken is not None:
            rule, state = self.script.expectations[self.broken].rule, self.states[self.broken]
            yield from all_parts(self.script.conditions, spoken(rule, state))

    def _values(self) -> Iterator[str]:
        """What the broken expectation reads at this moment: where agents are, and values."""
        for number in self._asked():
            condition = self.script.conditions[number]
            if isinstance(condition, Holds):
                known = self._known(condition.agent)
                read = [part for part in e.walk(condition.value) if isinstance(part, _READ)]
                said = [f"{e.value_text(part)} = {told(part, value_of(part, known))}" for part in read]
                if said:
                    yield f"{condition.agent} has {', '.join(dict.fromkeys(said))}"
            elif isinstance(condition, InPlaces):
                yield from located(condition, self._plan, self._agents)
            elif isinstance(condition, Breached) and number in self._promises.said:
                yield self._promises.said[number]

    def _refused(self) -> Iterator[str]:
        """What came instead of the messages that the broken expectation speaks of."""
        since = 0 if self.broken is None else self.reached.get(self.broken, 0)
        for number in self._asked():
            condition = self.script.conditions[number]
            if isinstance(condition, Says):
                yield from self._instead.told(number, condition, since, self._known)

    # ---- what is seen ------------------------------------------------------------------------

    def _look(self, happening: _Happening) -> None:
        self.assumed.look(self._known, self._now, None if happening is _NOTHING else happening.entered.keys())
        view = self._view(happening, self._now, self._now)
        self._show(view)
        self.came.update(dict.fromkeys(view.occurs & self._ordered, self._now))
        for condition in view.occurs & self.waiting.keys():
            for call in self.waiting.pop(condition):
                call(self._now)

    def _view(self, happening: _Happening, first: int, last: int, rests: bool = False) -> View:
        holds: set[int] = set()
        occurs: set[int] = set()
        for number, condition in enumerate(self.script.conditions):
            if rests and isinstance(condition, Holds):  # the agent may have made its next step already
                is_held, has_occurred = number in self._held, False
            else:
                is_held, has_occurred = self._judge(number, condition, happening, holds, occurs)
            if is_held:
                holds.add(number)
            if has_occurred:
                occurs.add(number)
        self._held = frozenset(holds - self._passing)
        has_begun = all(item.has_begun for item in self._agents.values())
        return View(first, last, frozenset(holds), frozenset(occurs), has_begun, rests)

    def _judge(
        self,
        number: int,
        condition: Condition,
        happening: _Happening,
        holds: set[int],
        occurs: set[int],
    ) -> tuple[bool, bool]:
        """Whether a condition holds, and whether it occurs."""
        match condition:
            case InPlaces(places=places, least=least):
                inside = [bool(self._agents[agent].active & labels) for agent, labels in places.items()]
                if least == 1:
                    found = happening.entered
                    return any(inside), any(
                        places[agent] & found[agent] for agent in found if agent in places
                    )
                is_held = sum(inside) >= least
            case Holds(agent=agent, value=value):
                is_held = value_of(value, self._known(agent)) is True
            case Says():
                is_held = any(
                    self._is_meant(number, condition, *item) for item in _messages(condition, happening)
                )
            case Untaken(kind=kind, performative=performative, agents=agents):
                agent, act, what = happening.untaken or ("", None, "")
                is_held = what == kind and performative in (None, act) and (agents is None or agent in agents)
            case Breached():
                is_held = number in happening.breached
            case Faulty():
                is_held = happening.is_fault
            case Failed(agents=agents):
                is_held = happening.failed in agents
            case AllOf(parts=parts):
                is_held = holds.issuperset(parts)
            case AnyOf(parts=parts):
                return not holds.isdisjoint(parts), not occurs.isdisjoint(parts)
            case NotSo(part=part):
                is_held = part not in holds
            case _:
                assert_never(condition)
        return is_held, is_held and number not in self._held

    def _known(self, agent: str, bound: Told | None = None) -> Known:
        followed, inside = self._agents[agent], self._around.insight(agent)
        return Known(
            self._now,
            self._inputs,
            lambda channel, sender: followed.newest.get((channel, sender)),
            inside.variable,
            bound,
            lambda channel, sender: followed.measured.get((channel, sender), ()),
            lambda question, state: answer(inside, followed, question, state),
            inside.outcome,
            lambda timer: any(moment <= self._now for moment in inside.timers(timer)),
            inside.index,
        )

    def _is_meant(self, number: int, says: Says, agent: str, said: Said) -> bool:
        if says.what != (said.kind if says.is_kind else said.what):
            return False
        if says.performative not in (None, said.performative):
            return False
        if says.agents is not None and agent not in says.agents:
            return False
        if says.condition is None or value_of(says.condition, self._known(agent, said.content)) is True:
            self._instead.near.pop(number, None)
            return True
        self._instead.near[number] = agent, said
        return False

    def _show(self, view: View) -> None:
        self.met |= view.holds | view.occurs
        for place, item in enumerate(self.script.expectations):
            if item.protocol is None:
                self._take(place, seen(item.rule, self.states[place], view))

    def _take(self, place: int, state: State) -> None:
        if state is self.states[place]:
            return
        if state.stage != self.states[place].stage:
            self.reached[place] = self._now
        self.states[place] = state
        item = self.script.expectations[place]
        if item.protocol is None:
            self._alarms.mind(place, item.rule, state)
        is_broken = state.verdict is Verdict.BROKEN and item.share is None
        if is_broken and (self.broken is None or state.at < self.states[self.broken].at):
            self.broken = place
            self.read = "; ".join(dict.fromkeys(self._values()))
            self.near = "; ".join(filter(None, dict.fromkeys(self._refused())))


_READ = e.VariableValue | e.Member | e.Age | e.Outcome
"""The parts of an expression whose values say why a condition does not hold."""


def _messages(says: Says, happening: _Happening) -> Iterable[tuple[str, Said]]:
    if says.is_received:
        return happening.received
    return () if happening.sent is None else ((happening.sent.sender, happening.sent),)


def _passing(conditions: Sequence[Condition]) -> frozenset[int]:
    """The conditions that hold at points only: each time they do, they occur."""
    found: set[int] = set()
    for number, condition in enumerate(conditions):
        is_part = isinstance(condition, AllOf | AnyOf) and not found.isdisjoint(condition.parts)
        if is_part or isinstance(condition, Says | Untaken | Breached | Faulty | Failed):
            found.add(number)
    return frozenset(found)


def _aged(conditions: Iterable[Condition]) -> Mapping[str, frozenset[int]]:
    """The ages (ns) that conditions ask for, by channel."""
    found: dict[str, set[int]] = {}
    for condition in conditions:
        if isinstance(condition, Holds):
            for member, age in ages(condition.value):
                found.setdefault(str(member.channel), set()).add(age)
    return {channel: frozenset(items) for channel, items in found.items()}


__all__ = ["KINDS", "Observer"]
