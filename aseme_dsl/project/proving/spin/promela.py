"""Promela: a small untimed team as a model for SPIN, with what is to hold as LTL.

A second opinion about the same plans that run and that are explored: each agent is a process. Its activities
end at any time, messages take any time and arrive in the order of their sender, deadlines pass at any time.
What a model cannot say is refused with its place.

A part that ends although it has asked another agent, and has taken no answer, sends what the protocol has for
that: agents do so by themselves (`runtime/conversation/losses.py`).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from aseme_dsl.play.scenario import Condition, Expectation, InPlaces
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.plan import BranchInfo, Plan, State, Transition, is_in
from aseme_dsl.runtime.conversation.losses import ASKING, FAREWELLS
from aseme_dsl.runtime.message.acl import NOT_UNDERSTOOD
from aseme_dsl.runtime.monitor.rules import Before, LeadsTo, Never

_ROOM = 8
"""So many messages are on their way from one agent to another, at the most."""
_MOST = 3
"""So many equal messages wait in an agent, at the most."""


class NotSaid(Exception):
    """A model for SPIN cannot say something: `what` it is, and where (`at`)."""

    def __init__(self, what: str, at: str) -> None:
        super().__init__(what)
        self.what = what
        self.at = at


def promela(
    name: str,
    team: Sequence[tuple[str, str]],
    plans: Mapping[str, Plan],
    conditions: Sequence[Condition] = (),
    expectations: Sequence[tuple[str, Expectation]] = (),
) -> str:
    """The model of a team whose roles have these plans, with the named expectations as LTL formulas.

    Raises:
        NotSaid: the model cannot say something.
    """
    return _Model(name, team, plans, conditions).text(expectations)


@dataclass(frozen=True, slots=True)
class _Message:
    """An agent message as it travels: `inform_Price`."""

    performative: str
    kind: str

    @property
    def name(self) -> str:
        return f"{self.performative}_{self.kind}"


class _Model:
    def __init__(
        self,
        name: str,
        team: Sequence[tuple[str, str]],
        plans: Mapping[str, Plan],
        conditions: Sequence[Condition],
    ) -> None:
        self._name = name
        self._team = dict(team)
        self._plans = plans
        self._conditions = conditions
        self._part_of = {agent: self._branch(agent).participant for agent in self._team}
        for agent in self._team:
            self._check(agent)
        starters = [agent for agent in self._team if not self._branch(agent).opens]
        if len(starters) != 1:
            plan = self._plan(next(iter(self._team)))
            raise NotSaid("a protocol that not exactly one agent begins", plan.states[0].at)

    def _plan(self, agent: str) -> Plan:
        return self._plans[self._team[agent]]

    def _branch(self, agent: str) -> BranchInfo:
        plan = self._plan(agent)
        if len(plan.branches) != 1:
            raise NotSaid("a role that does not play exactly one participant", plan.states[0].at)
        return plan.branches[0]

    def _check(self, agent: str) -> None:
        """Refuse what the model has no words for."""
        plan, info = self._plan(agent), self._branch(agent)
        at = plan.by_label[info.label].at
        for state in plan.states:
            if state.type == "AND":
                raise NotSaid("parts beside each other", state.at)
        for item in plan.channels:
            raise NotSaid(f"the channel {item.name}", at)
        for module in plan.modules:
            raise NotSaid(f"the module {module.name}", at)
        for low, high in ((low, high) for _, low, high in info.participants):
            if (low, high) != (1, 1):
                raise NotSaid("a participant that several agents play", at)
        if info.loses or info.counts or info.busy:
            raise NotSaid("what is said of lost agents, answers or busy participants", at)
        if any(performative == NOT_UNDERSTOOD for performative, _ in info.receives):
            raise NotSaid(f"the answer {NOT_UNDERSTOOD}, which agents give by themselves", at)
        if _is_played_again(plan, info.label):
            raise NotSaid("a participant that its agent plays again", at)
        for *_, repeatedly in info.moves:
            if repeatedly:
                raise NotSaid("a message that an activity sends repeatedly", at)
        for line in plan.transitions:
            if line.kind != "external" or line.resume or line.first or line.when:
                raise NotSaid("a line of this kind", line.at)
            if line.every is not None or line.weight is not None:
                raise NotSaid("a pace or a weight", line.at)

    # ---- names -------------------------------------------------------------------------------

    def _leaf(self, agent: str, state: State) -> str:
        name = state.activity or state.type.lower()
        return f"{agent}_{name}_{state.label.replace('.', '_')}"

    def _variable(self, agent: str, name: str) -> str:
        return f"{agent}_{name.replace('@', '_').replace('.', '_')}"

    def _mail(self, agent: str, message: _Message, sender: str) -> str:
        return f"{agent}_has_{message.name}_of_{sender}"

    def _asked(self, agent: str, other: str) -> str:
        return f"{agent}_has_asked_{other}"

    def _heard(self, agent: str, other: str) -> str:
        return f"{agent}_was_answered_by_{other}"

    def _channel(self, sender: str, receiver: str) -> str:
        return f"from_{sender}_to_{receiver}"

    # ---- the model ---------------------------------------------------------------------------

    def text(self, expectations: Sequence[tuple[str, Expectation]]) -> str:
        """The model."""
        lines = [f"/* {self._name}: written by asemec */"]
        messages = self._messages()
        if messages:
            lines.append(f"mtype = {{ {', '.join(item.name for item in messages)} }}")
        for agent in self._team:
            for other in self._team:
                if other != agent:
                    lines.append(f"chan {self._channel(agent, other)} = [{_ROOM}] of {{ mtype }}")
        body: list[str] = []
        for agent in self._team:
            lines += self._declared(agent)
            body += self._process(agent)
        lines += [*body, *self._formulas(expectations)]
        return "\n".join(lines) + "\n"

    def _messages(self) -> list[_Message]:
        found = {
            _Message(*item): None
            for agent in self._team
            for item in (*self._branch(agent).sends, *self._branch(agent).receives)
        }
        return list(found)

    def _declared(self, agent: str) -> Iterator[str]:
        plan = self._plan(agent)
        leaves = [state for state in plan.states if state.type in ("BASIC", "START", "END")]
        for number, state in enumerate(leaves):
            yield f"#define {self._leaf(agent, state)} {number}"
        yield f"byte {agent}_at = {self._leaf(agent, self._start(plan, plan.states[0].label))}"
        yield f"bool {agent}_done, {agent}_late, {agent}_joined, {agent}_over, {agent}_moved"
        for state in leaves:
            if state.type == "BASIC":
                yield f"bool seen_{self._leaf(agent, state)}"
        for item in plan.variables:
            kind = {"bool": "bool", "int": "int"}.get(item.type)
            if kind is not None:
                initial = int(item.initial) if isinstance(item.initial, bool | int) else 0
                yield f"{kind} {self._variable(agent, item.name)} = {initial}"
        for message in (_Message(*item) for item in self._branch(agent).receives):
            for other in self._team:
                if other != agent:
                    yield f"byte {self._mail(agent, message, other)}"
        for number, *_ in self._said(agent):
            yield f"bool {agent}_sent_{number}"

        for other in self._parted(agent):
            yield f"bool {self._asked(agent, other)}, {self._heard(agent, other)}"

    def _parted(self, agent: str) -> dict[str, _Message]:
        """To whom the part of an agent, if it ends without an answer, sends which message."""
        info = self._branch(agent)
        asks = any(performative in ASKING for performative, _ in info.sends)
        found: dict[str, _Message] = {}
        for other in self._team if asks and info.receives else ():
            theirs = self._branch(other).receives
            moves = [move for act in FAREWELLS for move in info.sends if move[0] == act and move in theirs]
            if other != agent and moves:
                found[other] = _Message(*moves[0])
        return found

    def _tells(self, agent: str, other: str, message: _Message) -> str:
        """A message is sent; the last one that asks is to be answered."""
        said = f"{self._channel(agent, other)}!{message.name}"
        if other not in self._parted(agent):
            return said
        return f"{said}; {self._asked(agent, other)} = {str(message.performative in ASKING).lower()}"

    def _start(self, plan: Plan, label: str) -> State:
        return next(state for state in plan.children(label) if state.type == "START")

    def _said(self, agent: str) -> Iterator[tuple[int, _Message, str, tuple[str, ...]]]:
        """What activities of an agent send: a number, the message, to whom, and in which states."""
        info = self._branch(agent)
        number = 0
        for performative, kind, states, _ in info.moves:
            for other, part in self._part_of.items():
                if other != agent and (performative, kind) in self._branch(other).receives:
                    assert part
                    yield number, _Message(performative, kind), other, states
                    number += 1

    # ---- processes ---------------------------------------------------------------------------

    def _process(self, agent: str) -> Iterator[str]:
        plan, info = self._plan(agent), self._branch(agent)
        yield f"inline {agent}_settles() {{"
        yield f"  {agent}_moved = true"
        yield "  do"
        yield f"  :: {agent}_moved ->"
        yield f"    {agent}_moved = false"
        yield "    if"
        for state in plan.states:
            if state.type in ("BASIC", "START", "END"):
                yield f"    :: {agent}_at == {self._leaf(agent, state)} ->"
                yield from self._moves(agent, plan, state)
        yield "    fi"
        yield "  :: else -> break"
        yield "  od"
        yield "}"
        yield f"active proctype {agent}() {{"
        yield f"  atomic {{ {agent}_settles() }}"
        final = [
            f"{agent}_at == {self._leaf(agent, state)}"
            for state in plan.states
            if state.type == "END" and state.parent == plan.states[0].label
        ]
        begin = self._start(plan, info.label)
        waits = f"({agent}_at == {self._leaf(agent, begin)} && !{agent}_joined)" if info.opens else "false"
        good = " || ".join((*final, waits))
        yield "  do"
        yield f"  :: {good} ->"
        yield "  end:"
        yield from self._options(agent, plan, info)
        yield f"  :: !({good}) ->"
        yield from self._options(agent, plan, info)
        yield "  od"
        yield "}"

    def _options(self, agent: str, plan: Plan, info: BranchInfo) -> Iterator[str]:
        """What may happen to an agent next."""
        yield "    if"
        basics = [state for state in plan.states if state.type == "BASIC"]
        for state in basics:
            here = f"{agent}_at == {self._leaf(agent, state)} && !{agent}_done"
            if any(item.name == state.activity and item.waits for item in plan.activities):
                continue
            yield f"    :: atomic {{ {here} -> {agent}_done = true"
            for variable in self._written(plan, state):
                name = self._variable(agent, variable)
                yield f"      if :: {name} = false :: {name} = true fi"
            yield f"      {agent}_settles() }}"
        for number, message, other, states in self._said(agent):
            for state in basics:
                if any(is_in(state.label, label) for label in states):
                    here = f"{agent}_at == {self._leaf(agent, state)} && !{agent}_done"
                    yield (
                        f"    :: atomic {{ {here} && {agent}_joined && !{agent}_sent_{number}"
                        f" -> {agent}_sent_{number} = true; {self._tells(agent, other, message)} }}"
                    )
        for source, transitions in self._timed(plan).items():
            if len({term[1] for item in transitions for term in item.events if term[0] == "after"}) > 1:
                raise NotSaid("two deadlines of one state", transitions[0].at)
            inside = self._resting(agent, plan, source)
            yield f"    :: atomic {{ ({inside}) && !{agent}_late -> {agent}_late = true; {agent}_settles() }}"
        receives = [_Message(*item) for item in info.receives]
        for other in self._team:
            if other == agent:
                continue
            channel = self._channel(other, agent)
            for message in self._messages():
                yield f"    :: atomic {{ {channel}?{message.name} ->"
                if message not in receives:
                    yield "      skip }"
                    continue
                opens = (message.performative, message.kind) in info.opens
                mail = self._mail(agent, message, other)
                yield "      if"
                joins = f"; {agent}_joined = true" if opens else ""  # others wait until it takes part
                yield f"      :: !{agent}_over && {mail} < {_MOST} -> {mail}++{joins}"
                yield "      :: else"
                yield "      fi"
                yield f"      {agent}_settles() }}"
        yield "    fi"

    def _written(self, plan: Plan, state: State) -> Iterator[str]:
        """The variables that the activity of a state may write, as far as lines read them."""
        read = {name for item in plan.transitions for name in _variables(item.condition)}
        assigned = {
            str(action[1]) for item in plan.transitions for action in item.actions if action[0] == "assign"
        }
        info = next((item for item in plan.activities if item.name == state.activity), None)
        for item in plan.variables:
            own = item.scope is not None and is_in(state.label, item.scope) and item.name not in assigned
            declared = info is not None and item.name.partition("@")[0] in info.variables
            if item.name in read and (own or declared):
                if item.type != "bool":
                    raise NotSaid(
                        f"the variable {item.name.partition('@')[0]}, which is not a bool", state.at
                    )
                yield item.name

    def _timed(self, plan: Plan) -> dict[str, list[Transition]]:
        """The transitions with deadlines, by the state whose time counts."""
        found: dict[str, list[Transition]] = {}
        for item in plan.transitions:
            if any(event[0] == "after" for event in item.events):
                source = plan.by_label[item.source]
                if source.type not in ("BASIC", "CONDITION", "START"):
                    raise NotSaid("a deadline of a composite state", item.at)
                label = item.source
                if source.type == "CONDITION":
                    assert source.parent is not None
                    label = self._start(plan, source.parent).label
                found.setdefault(label, []).append(item)
        return found

    def _resting(self, agent: str, plan: Plan, label: str) -> str:
        return f"{agent}_at == {self._leaf(agent, plan.by_label[label])}"

    # ---- moves -------------------------------------------------------------------------------

    def _moves(self, agent: str, plan: Plan, leaf: State) -> Iterator[str]:
        """The first move that is open in a leaf, of its own transitions and of those around it."""
        depth = 0
        for condition, action in self._candidates(agent, plan, leaf):
            yield f"      if :: {condition} -> {action}; {agent}_moved = true"
            yield "      :: else ->"
            depth += 1
        yield "      skip" + " fi" * depth

    def _candidates(self, agent: str, plan: Plan, leaf: State) -> Iterator[tuple[str, str]]:
        """The moves of a leaf, and of the states around it: these are complete where it is their end."""
        yield from self._of_source(
            agent, plan, leaf.label, f"{agent}_done" if leaf.type == "BASIC" else "true"
        )
        is_end = leaf.type == "END"
        state = leaf
        while state.parent is not None:
            state = plan.by_label[state.parent]
            yield from self._of_source(agent, plan, state.label, "true" if is_end else "false")
            is_end = False  # what is around it is left first

    def _of_source(self, agent: str, plan: Plan, source: str, complete: str) -> Iterator[tuple[str, str]]:
        """The moves out of a state, in their order; a choice is passed at once."""
        own = sorted((item for item in plan.transitions if item.source == source), key=_order)
        siblings: list[str] = []
        for item in own:
            if plan.by_label[item.target].type == "CONDITION":
                if item.events or item.condition is not None or item.actions:
                    raise NotSaid("a line into a choice", item.at)
                for condition, action in self._of_source(agent, plan, item.target, "true"):
                    yield f"({complete}) && ({condition})", action
                continue
            condition = self._open(agent, item, complete, siblings)
            yield condition, self._effect(agent, plan, item)
            siblings.append(condition)

    def _open(self, agent: str, item: Transition, complete: str, siblings: Sequence[str]) -> str:
        guard = self._condition(agent, item.condition, item)
        if item.otherwise:
            others = " && ".join(f"!({other})" for other in siblings) or "true"
            return f"({complete}) && {others} && {guard}"
        if not item.events:
            return f"({complete}) && {guard}"
        events = " || ".join(self._event(agent, event, item) for event in item.events)
        return f"({events}) && {guard}"

    def _event(self, agent: str, event: tuple[object, ...], item: Transition) -> str:
        match event:
            case ("after", int()):
                return f"{agent}_late"
            case ("received", str() as performative, str() as kind, str() as part, *_):
                message = _Message(performative, kind)
                boxes = [
                    f"{self._mail(agent, message, other)} > 0"
                    for other, own in self._part_of.items()
                    if other != agent and own == part
                ]
                return " || ".join(boxes) or "false"
            case _:
                raise NotSaid(f"the event {event[0]}", item.at)

    def _condition(self, agent: str, term: object, item: Transition) -> str:
        match term:
            case None:
                return "true"
            case ("const", bool() as value):
                return "true" if value else "false"
            case ("variable", str() as name):
                variable = next(one for one in self._plan(agent).variables if one.name == name)
                if variable.type != "bool":
                    raise NotSaid(f"the variable {name.partition('@')[0]}, which is not a bool", item.at)
                return self._variable(agent, name)
            case ("!", inner):
                return f"!({self._condition(agent, inner, item)})"
            case ("&&" | "||" as sign, *parts):
                return "(" + f" {sign} ".join(self._condition(agent, part, item) for part in parts) + ")"
            case _:
                raise NotSaid("this condition", item.at)

    def _effect(self, agent: str, plan: Plan, item: Transition) -> str:
        """What a transition does: it takes its message, acts, and leads to where its target begins."""
        done: list[str] = []
        heard = [event for event in item.events if event[0] == "received"]
        if len(heard) > 1:
            raise NotSaid("a line with several messages", item.at)
        for event in heard:
            message = _Message(str(event[1]), str(event[2]))
            other = next(name for name, own in self._part_of.items() if own == event[3] and name != agent)
            done.append(f"{self._mail(agent, message, other)}--")
            if other in self._parted(agent):
                done.append(f"{self._heard(agent, other)} = true")
        for action in item.actions:
            done += self._action(agent, action, item)
        target = plan.by_label[item.target]
        while target.type == "OR":
            target = self._start(plan, target.label)
        done.append(f"{agent}_at = {self._leaf(agent, target)}")
        done.append(f"{agent}_done = false; {agent}_late = false")
        if target.type == "BASIC":
            done.append(f"seen_{self._leaf(agent, target)} = true")
            done += [f"{agent}_sent_{number} = false" for number, *_ in self._said(agent)]
        if item.source == self._branch(agent).label:
            done.append(f"{agent}_over = true")
            for other, message in self._parted(agent).items():
                waits = f"{self._asked(agent, other)} && !{self._heard(agent, other)} && !{other}_over"
                said = f"{self._channel(agent, other)}!{message.name}"
                done.append(f"if :: {waits} -> {said} :: else fi")
        return "; ".join(done)

    def _action(self, agent: str, action: tuple[object, ...], item: Transition) -> Iterator[str]:
        match action:
            case ("send", str() as performative, str() as kind, str() as part, *_):
                message = _Message(performative, kind)
                yield f"{agent}_joined = true"
                for other, own in self._part_of.items():
                    if own == part and other != agent:
                        yield self._tells(agent, other, message)
            case ("assign", str() as name, ("const", bool() | int() as value)):
                yield f"{self._variable(agent, name)} = {int(value)}"
            case _:
                raise NotSaid(f"the action {action[0]}", item.at)

    # ---- what is to hold ---------------------------------------------------------------------

    def _formulas(self, expectations: Sequence[tuple[str, Expectation]]) -> Iterator[str]:
        for name, item in expectations:
            at = str(item.span)
            match item.rule:
                case Before(first, second):
                    one, two = self._seen(first, at), self._seen(second, at)
                    yield f"ltl {name} {{ [] (({two}) -> ({one})) }}"
                case Never(condition, before) if before > 10**18:
                    yield f"ltl {name} {{ [] !({self._inside(condition, at)}) }}"
                case LeadsTo(first, second, None):
                    one, two = self._inside(first, at), self._seen(second, at)
                    yield f"ltl {name} {{ [] (({one}) -> <> ({two})) }}"
                case LeadsTo() | Never():
                    raise NotSaid("a clause or property with a time", at)
                case _:
                    raise NotSaid("a clause or property of this kind", at)

    def _places(self, number: int, at: str) -> list[tuple[str, list[State]]]:
        condition = self._conditions[number]
        if not isinstance(condition, InPlaces):
            raise NotSaid("a property that is not about states", at)
        found = []
        for agent, labels in condition.places.items():
            plan = self._plan(agent)
            states = [
                state
                for state in plan.states
                if state.type == "BASIC" and any(is_in(state.label, label) for label in labels)
            ]
            found.append((agent, states))
        return found

    def _seen(self, number: int, at: str) -> str:
        places = self._places(number, at)
        return " || ".join(f"seen_{self._leaf(agent, state)}" for agent, states in places for state in states)

    def _inside(self, number: int, at: str) -> str:
        condition = self._conditions[number]
        assert isinstance(condition, InPlaces) or self._places(number, at)
        inside = [
            "(" + " || ".join(f"{agent}_at == {self._leaf(agent, state)}" for state in states) + ")"
            for agent, states in self._places(number, at)
        ]
        least = condition.least if isinstance(condition, InPlaces) else 1
        return " || ".join(inside) if least == 1 else f"({' + '.join(inside)}) >= {least}"


def _is_played_again(plan: Plan, branch: str) -> bool:
    """Whether a branch may be entered after it was left."""
    todo = [item.target for item in plan.transitions if is_in(branch, item.source)]
    reached: set[str] = set()
    while todo:
        label = todo.pop()
        if is_in(branch, label):
            return True
        if label not in reached:
            reached.add(label)
            todo += [
                item.target
                for item in plan.transitions
                if is_in(item.source, label) or is_in(label, item.source)
            ]
    return False


def _order(item: Transition) -> tuple[bool, bool, int]:
    """Those with neither event nor condition come last, and `else` behind them."""
    return item.otherwise, not item.events and item.condition is None, item.priority


def _variables(term: object) -> Iterator[str]:
    match term:
        case ("variable", str() as name):
            yield name
        case tuple():
            for part in term:
                yield from _variables(part)
        case _:
            pass


__all__ = ["NotSaid", "promela"]
