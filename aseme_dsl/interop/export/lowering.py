"""From a statechart to a machine that other engines can run, or what keeps it from being one."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import field, replace
from functools import cached_property
from itertools import pairwise
from pathlib import PurePath

from aseme_dsl.amola.expression import (
    NEVER as NO_LINE,
)
from aseme_dsl.amola.expression import (
    Action,
    After,
    Assign,
    Evaluate,
    Event,
    Expired,
    Failed,
    Lost,
    Member,
    Publish,
    Raised,
    ReadMessages,
    Received,
    Send,
    StartTimer,
    Value,
    VariableValue,
    values_of,
)
from aseme_dsl.amola.expression import Raise as RaiseEvent
from aseme_dsl.amola.statechart import (
    State,
    Statechart,
    StateType,
    Transition,
    TransitionKind,
    Variable,
    label_key,
    transition_text,
)
from aseme_dsl.amola.system import System
from aseme_dsl.diagnostics.problems.exporting import Foreign
from aseme_dsl.interop.export.machine import (
    ALWAYS,
    INPUT,
    NEVER,
    SETTLED,
    Act,
    Cond,
    Const,
    Datum,
    Emit,
    Given,
    Handler,
    If,
    Machine,
    Move,
    Op,
    Pick,
    Present,
    Raise,
    Ref,
    Schedule,
    Set,
    Shape,
    Sign,
    Term,
    Truth,
    Unschedule,
    Vertex,
    both,
    either,
    opposite,
)
from aseme_dsl.interop.export.names import Names
from aseme_dsl.interop.export.values import PLAIN, Values
from aseme_dsl.records import dataclass
from aseme_dsl.source import Span

Path = tuple[Transition, ...]
"""A compound transition: into a CONDITION and out of it again."""


@dataclass(frozen=True, slots=True)
class Refusal:
    """What cannot be said, and where it stands."""

    feature: Foreign
    span: Span


def place(span: Span | None) -> str:
    """`team.aseme:12:5`"""
    if span is None:
        return ""
    line, column = span.source.position(span.start)
    return f"{PurePath(span.source.path).name}:{line}:{column}"


def lowered(system: System, chart: Statechart) -> tuple[Machine, tuple[Refusal, ...]]:
    """The machine of a chart. With refusals it does not mean the same, and must not be written."""
    lowering = _Lowering(system, chart)
    machine = lowering.machine()
    found = [Refusal(feature, span) for feature, span in lowering.values.refused.values()]
    return machine, tuple(sorted(found, key=lambda item: (item.span.source.path, item.span.start)))


@dataclass
class _Lowering:
    system: System
    chart: Statechart
    flags: dict[str, Datum] = field(default_factory=dict)
    handlers: dict[str, Handler] = field(default_factory=dict)
    emitted: dict[str, None] = field(default_factory=dict)
    spans: dict[str, Span] = field(default_factory=dict)

    @cached_property
    def names(self) -> Names:
        return Names(self.chart)

    @cached_property
    def values(self) -> Values:
        actions = [action for item in self.chart.transitions for action in item.expression.actions]
        changed = {
            action.target.name
            for action in actions
            if isinstance(action, Assign) and isinstance(action.target, VariableValue)
        }
        scoped = {variable.name for variable in self.chart.variables if variable.scope is not None}
        published = {str(action.channel) for action in actions if isinstance(action, Publish)}
        return Values(self.chart, self.names, frozenset(changed | scoped), frozenset(published))

    # ---- the whole ----------------------------------------------------------------------

    def machine(self) -> Machine:
        for state in self.chart.states:
            self.names.id_of(state)
        self._refuse_activities()
        self._refuse_sharing()
        for region, timers in self._timers.items():
            for timer in timers:
                self._timer(region, timer)  # also one that nothing starts
        root = self._vertices()
        variables = [self._variable(item) for item in self.chart.variables if item.name in self._used]
        settled = tuple(self._settled())
        inputs = list(self.values.inputs.values())
        data = (*inputs, *(item for item in variables if item is not None), *self.flags.values())
        handlers = (self._input_handler(data), *self.handlers.values(), *settled)
        span = self.chart.span
        return Machine(
            self.chart.name,
            self.system.name,
            "" if span is None else PurePath(span.source.path).name,
            root,
            self.values.complete(self.chart.root),
            data,
            handlers,
            tuple(self.emitted),
        )

    def _vertices(self) -> Vertex:
        states = [state for state in self.chart.states if state.type is not StateType.CONDITION]
        plain = [self._vertex(state) for state in states]
        made: dict[str, Vertex] = {}
        for state, vertex in zip(reversed(states), reversed(plain), strict=True):
            children = [child for child in self.chart.children(state.label) if child.label in made]
            start = self.chart.start_of(state.label)
            children.sort(key=lambda child: child is not start)
            made[state.label] = replace(vertex, children=tuple(made[child.label] for child in children))
        return made[self.chart.root.label]

    def _vertex(self, state: State) -> Vertex:
        """A state without what is inside."""
        shape = {
            StateType.OR: Shape.COMPOUND,
            StateType.AND: Shape.PARALLEL,
            StateType.END: Shape.FINAL,
        }.get(state.type, Shape.ATOMIC)
        entry, left = self._entry(state)
        return Vertex(
            self.names.id_of(state),
            state.label,
            self.chart.title(state),
            shape,
            state.activity,
            tuple(entry),
            tuple(left),
            tuple(self._moves(state)),
        )

    # ---- what is left out ---------------------------------------------------------------

    def _refuse_activities(self) -> None:
        used = {state.activity for state in self.chart.states}
        for said in self.system.activities:
            if said.name in used and said.within is not None:
                self.values.refuse(Foreign.DEADLINES, said.span)
        for state in self.chart.states:
            for item in state.arguments:
                if state.type is not StateType.BASIC:
                    continue
                self.values.term(item.value, state.label)
                if self.values.presence(item.value, state.label) != ALWAYS:
                    self.values.refuse(Foreign.GIVEN, item.value.span)

    def _refuse_sharing(self) -> None:
        """A region sees what another one writes from the next step on: engines have one value for all."""
        uses: dict[str, dict[str, Span]] = {}
        written: set[str] = set()
        for transition in self.chart.transitions:
            here = self.chart.region_of(transition.source)
            for value in values_of(transition.expression):
                if isinstance(value, VariableValue):
                    uses.setdefault(value.name, {}).setdefault(here, value.span)
            for action in transition.expression.actions:
                if isinstance(action, Assign) and isinstance(action.target, VariableValue):
                    written.add(action.target.name)
                    for region in (here, self.chart.acts_in(transition)):
                        uses.setdefault(action.target.name, {}).setdefault(region, action.span)
        for name in written:
            for span in list(uses[name].values())[1:]:
                self.values.refuse(Foreign.SHARING, span)

    @cached_property
    def _used(self) -> frozenset[str]:
        """The variables that a transition reads or writes."""
        read = {
            value.name
            for item in self.chart.transitions
            for value in values_of(item.expression)
            if isinstance(value, VariableValue)
        }
        return self.values.changed | read

    def _variable(self, item: Variable) -> Datum | None:
        if item.type.kind not in PLAIN:
            return None  # each use of it is refused
        if item.is_limited and item.name in self.values.changed:
            self.values.refuse(Foreign.BOUNDS, item.span)
        name = self.names.variable(item.name)
        text = f"the variable {item.name.partition('@')[0]}"
        return Datum(name, item.initial.value, text, True, str(item.type))

    # ---- entering and leaving -----------------------------------------------------------

    def _flag(self, name: str, text: str, *, initial: bool = False, is_input: bool = True) -> str:
        self.flags.setdefault(name, Datum(name, initial, text, is_input, "bool"))
        return name

    def _entry(self, state: State) -> tuple[list[Act], list[Act]]:
        entry: list[Act] = []
        left: list[Act] = []
        for variable in self.chart.variables:
            if variable.scope == state.label and variable.name in self._used and variable.type.kind in PLAIN:
                entry.append(Set(self.names.variable(variable.name), Const(variable.initial.value)))
        if state.type is StateType.BASIC and not state.waits:
            entry += self._completion(state)
        for duration in self._durations(state):
            flag = self._flag(
                self.names.after(state, duration),
                f"{duration} ns since {self.chart.title(state)} was entered",
            )
            event = f"after.{flag}"
            entry.append(Set(flag, Const(duration <= 0)))
            if duration > 0:
                self._handle(event, (Set(flag, Const(True)),), self.flags[flag].text)
                entry.append(Schedule(event, Const(duration)))
                left.append(Unschedule(event))
        if self.chart.is_region(state.label) and state.parent is not None:
            for name in self._events_in(state.label):
                entry.append(Set(self._event(state.label, name), Const(False)))
            for timer in self._timers_in(state.label):
                flag = self._timer(state.label, timer)
                entry.append(Set(flag, Const(False)))
                left.append(Unschedule(f"timer.{flag}"))
        for transition in self.chart.exits_of(state.label):
            left += self._acts((transition,))
        if state.label in self.chart.abandons:
            self.values.refuse(Foreign.ABANDONING, self.chart.abandons[state.label][0].span)
        return entry, left

    def _completion(self, state: State) -> Iterator[Act]:
        done = self._flag(self.names.flag("done", state), f"{state.activity} has returned")
        acts: list[Act] = [Set(done, Const(True))]
        said = self.system.activity(state.activity) if state.activity else None
        yield Set(done, Const(False))
        if said is not None and said.ends:
            name = self.names.flag("outcome", state)
            self.flags[name] = Datum(name, None, f"how {state.activity} has ended", True, "outcome")
            acts.append(Set(name, Pick(Present(Given(name)), Given(name), Const(None))))
            yield Set(name, Const(None))
        self._handle(f"complete.{self.names.id_of(state)}", tuple(acts), f"{state.activity} has returned")

    def _durations(self, state: State) -> list[int]:
        """After how many ns since its entry something may become possible in a state."""
        found: dict[int, None] = {}
        for path in self._paths(state.label):
            for transition in path:
                expression = transition.expression
                for event in expression.events:
                    if isinstance(event, After):
                        found.setdefault(event.duration)
                if expression.every is not None:
                    found.setdefault(expression.every)
        return sorted(found)

    # ---- events and timers --------------------------------------------------------------

    def _handle(self, event: str, acts: tuple[Act, ...], text: str) -> None:
        known = self.handlers.get(event)
        if known is None:
            self.handlers[event] = Handler(event, acts, text)

    def _event(self, region: str, name: str) -> str:
        return self._flag(self.names.event(region, name), f"the event {name} is there")

    @cached_property
    def _awaited(self) -> dict[str, tuple[str, ...]]:
        """The events that transitions of each region wait for."""
        found: dict[str, dict[str, None]] = {}
        for transition in self.chart.transitions:
            for event in transition.expression.events:
                if isinstance(event, Raised):
                    region = self.chart.region_of(transition.source)
                    found.setdefault(region, {}).setdefault(event.name)
        return {region: tuple(names) for region, names in found.items()}

    def _events_in(self, region: str) -> tuple[str, ...]:
        return self._awaited.get(region, ())

    @cached_property
    def _timers(self) -> dict[str, tuple[str, ...]]:
        found: dict[str, dict[str, None]] = {}
        for transition in self.chart.transitions:
            for action in transition.expression.actions:
                if isinstance(action, StartTimer):
                    found.setdefault(self.chart.acts_in(transition), {}).setdefault(action.timer)
            for value in values_of(transition.expression):
                if isinstance(value, Expired):
                    found.setdefault(self.chart.region_of(transition.source), {}).setdefault(value.timer)
        return {region: tuple(sorted(names)) for region, names in found.items()}

    def _timers_in(self, region: str) -> tuple[str, ...]:
        return self._timers.get(region, ())

    def _timer(self, region: str, name: str) -> str:
        flag = self._flag(self.names.timer(region, name), f"the timer {name} has run out")
        self._handle(f"timer.{flag}", (Set(flag, Const(True)),), f"the timer {name} has run out")
        return flag

    def _settled(self) -> Iterator[Handler]:
        """What events do, and that they are gone when nothing is enabled any more."""
        events: dict[str, list[str]] = {}
        for region in sorted(self._awaited, key=label_key):
            for name in self._awaited[region]:
                events.setdefault(name, []).append(self._event(region, name))
        for name, flags in events.items():
            come: list[Act] = [*(Set(flag, Const(True)) for flag in flags), Raise(SETTLED)]
            yield Handler(f"event.{name}", tuple(come), f"the event {name}")
        if events:
            gone: list[Act] = [Set(flag, Const(False)) for flags in events.values() for flag in flags]
            yield Handler(SETTLED, tuple(gone), "the step is over: events that nothing has taken are dropped")

    def _input_handler(self, data: tuple[Datum, ...]) -> Handler:
        acts: list[Act] = [
            If(Present(Given(item.name)), (Set(item.name, Given(item.name)),))
            for item in data
            if item.is_input
        ]
        if self._awaited:
            acts.append(Raise(SETTLED))
        return Handler(INPUT, tuple(acts), "values of inputs, all at once")

    # ---- transitions --------------------------------------------------------------------

    def _paths(self, label: str) -> tuple[Path, ...]:
        """The compound transitions of a source, in the order in which they are tried."""
        known = self._known_paths.get(label)
        if known is None:
            outgoing = [item for item in self.chart.outgoing(label) if item.expression is not NO_LINE]
            ordered = [item for item in outgoing if item.first] + [i for i in outgoing if not i.first]
            known = tuple(path for item in ordered for path in self._paths_of(item))
            self._known_paths[label] = known
        return known

    @cached_property
    def _known_paths(self) -> dict[str, tuple[Path, ...]]:
        return {}

    def _paths_of(self, transition: Transition) -> Iterator[Path]:
        if self.chart.node(transition.target).type is not StateType.CONDITION or not transition.changes_state:
            yield (transition,)
            return
        for path in self._paths(transition.target):
            yield (transition, *path)

    def _moves(self, state: State) -> Iterator[Move]:
        if state.type is StateType.END:
            return
        blocked = [opposite(self._interrupts(around.label)) for around in self.chart.ancestors(state.label)]
        for path in self._paths(state.label):
            condition = both(self._condition(state, path), *blocked)
            if condition == NEVER:
                continue
            self._check(path)
            acts = (*self._spending(state, path), *self._acts(path))
            yield Move(
                condition,
                self._targets(path[-1]) if path[0].changes_state else (),
                acts,
                " · ".join(filter(None, map(transition_text, path))),
                place(path[0].span),
            )

    def _targets(self, transition: Transition) -> tuple[str, ...]:
        """The ids of the targets. The first alone has the scope of all: SCION looks at no other one."""
        if not transition.into:
            return (self.names.id_of(self.chart.node(transition.target)),)
        scope = self.chart.scope_of(transition)
        alone = (replace(transition, target=label, into=()) for label in transition.into)
        ordered = sorted(alone, key=lambda item: self.chart.scope_of(item) != scope)
        return tuple(self.names.id_of(self.chart.node(item.target)) for item in ordered)

    def _interrupts(self, label: str) -> Cond:
        """Whether something interrupts a state."""
        known = self._known_interrupts.get(label)
        if known is None:
            state = self.chart.node(label)
            first = [path for path in self._paths(label) if path[0].first]
            known = either(*(self._condition(state, path) for path in first))
            self._known_interrupts[label] = known
        return known

    @cached_property
    def _known_interrupts(self) -> dict[str, Cond]:
        return {}

    def _condition(self, state: State, path: Path) -> Cond:
        parts: list[Cond] = []
        for number, transition in enumerate(path):
            expression = transition.expression
            if not expression.when:
                if expression.events:
                    parts.append(either(*(self._there(event, state) for event in expression.events)))
                elif number == 0:
                    parts.append(self.values.complete(state))
            if expression.every is not None:
                parts.append(Truth(Ref(self._after(state, expression.every))))
            if expression.weight is not None or expression.draw is not None:
                self.values.refuse(Foreign.BRANCHING, transition.span)
            elif expression.condition is not None:
                parts.append(self.values.truth(expression.condition, transition.source))
        return both(*parts)

    def _after(self, state: State, duration: int) -> str:
        return self._flag(
            self.names.after(state, duration), f"{duration} ns since {self.chart.title(state)} was entered"
        )

    def _there(self, event: Event, state: State) -> Cond:
        match event:
            case After(duration=duration):
                return Truth(Ref(self._after(state, duration)))
            case Raised(name=name):
                return Truth(Ref(self._event(self.chart.region_of(state.label), name)))
            case Failed():
                self.values.refuse(Foreign.ERRORS, event.span)
            case Received() | Lost():
                self.values.refuse(Foreign.AGENT_MESSAGES, event.span)
        return NEVER

    def _spending(self, state: State, path: Path) -> Iterator[Act]:
        """A transition consumes the first of its events that is there."""
        region = self.chart.region_of(state.label)
        around = [label for label in (region, *(s.label for s in self.chart.ancestors(region)))]
        for transition in path:
            spent: tuple[Act, ...] = ()
            for event in reversed(transition.expression.events):
                here: tuple[Act, ...] = ()
                if isinstance(event, Raised):
                    here = tuple(
                        Set(self._event(label, event.name), Const(False))
                        for label in around
                        if event.name in self._events_in(label)
                    )
                alone = len(transition.expression.events) == 1 and not transition.expression.when
                if alone:
                    spent = here
                elif here or spent:
                    spent = (If(self._there(event, state), here, spent),)
            yield from spent

    def _check(self, path: Path) -> None:
        """Refuse what other engines do otherwise with a transition."""
        first = path[0]
        if first.kind is TransitionKind.ON:
            self._check_staying(first)
            return
        for transition in path:
            if transition.resume:
                self.values.refuse(Foreign.RESUMING, transition.span)
        scope = min((self.chart.scope_of(item) for item in path), key=len)
        inside = [first.source, *(state.label for state in self.chart.ancestors(first.source))]
        for label, parent in pairwise(inside[: inside.index(scope) + 1]):
            if (
                self.chart.node(parent).type is StateType.AND
                and self.chart.children(parent)[0].label != label
            ):
                self.values.refuse(Foreign.LEAVING, first.span)
        self._check_entering_again(path)

    def _check_entering_again(self, path: Path) -> None:
        """SCION and XState stay in an AND that SCXML leaves and enters again: its times and exits differ."""
        last = path[-1]
        for label in (state.label for state in self.chart.ancestors(path[0].source)):
            is_around = all(target.startswith(f"{label}.") for target in last.into)
            if last.into and is_around and self.chart.node(label).type is StateType.AND:
                if self._durations(self.chart.node(label)) or any(self.chart.exits_of(label)):
                    self.values.refuse(Foreign.REENTERING, last.span)
                return

    def _check_staying(self, transition: Transition) -> None:
        expression = transition.expression
        if expression.when or not expression.events:
            self.values.refuse(Foreign.STAYING, transition.span)
        if any(isinstance(event, After) for event in expression.events):
            self.values.refuse(Foreign.TIMED_STAYING, transition.span)
        inside = f"{transition.source}."
        for state in self.chart.states:
            concurrent = state.type is StateType.AND
            if concurrent and (state.label == transition.source or state.label.startswith(inside)):
                self.values.refuse(Foreign.STAYING_AROUND, transition.span)
        if self._is_overtaken(transition.source):
            self.values.refuse(Foreign.STAYING_INSIDE, transition.span)

    def _is_overtaken(self, source: str) -> bool:
        """Whether a transition around the concurrent regions of a state may be enabled before they complete.

        It is tried only if no region moves. Engines take it beside a transition that stays.
        """
        beyond = self.chart.ancestors(self.chart.region_of(source))
        ways = (way for state in beyond for way in self.chart.outgoing(state.label) if not way.first)
        return any(way.expression.events or way.expression.when for way in ways)

    # ---- actions ------------------------------------------------------------------------

    def _acts(self, path: Path) -> list[Act]:
        where = self.chart.region_of(path[0].source)
        if path[0].changes_state:
            where = self.chart.region_of(min((self.chart.scope_of(item) for item in path), key=len))
        found: list[Act] = []
        for transition in path:
            fills: list[Assign] = []
            for action in transition.expression.actions:
                if isinstance(action, Assign) and isinstance(action.target, Member):
                    fills.append(action)
                else:
                    found += self._act(action, transition, where, fills)
            for fill in fills:
                self.values.refuse(Foreign.DRAFTS, fill.span)
        return found

    def _act(self, action: Action, transition: Transition, where: str, fills: list[Assign]) -> Iterator[Act]:
        source = transition.source
        match action:
            case Assign(target=VariableValue(name=name) as target, value=value):
                term = self.values.term(value, source)
                self.values.term(target, source)
                yield from self._if_there(value, source, Set(self.names.variable(name), term))
            case StartTimer(timer=timer, duration=duration):
                flag = self._timer(where, timer)
                event = f"timer.{flag}"
                term = self.values.term(duration, source)
                due = Op(Sign.MOST, (term, Const(0)))
                yield from self._if_there(duration, source, Set(flag, due), Schedule(event, term))
            case Publish(channel=channel):
                own = [fill for fill in fills if fill.target.channel == channel]  # type: ignore[union-attr]
                fills[:] = [fill for fill in fills if fill not in own]
                event = f"publish.{channel}"
                self.emitted.setdefault(event)
                yield Emit(event, tuple(self._filled(fill, source) for fill in own))
            case RaiseEvent(name=name):
                yield Raise(f"event.{name}")
            case ReadMessages():
                self.values.refuse(Foreign.READING, action.span)
            case Send():
                self.values.refuse(Foreign.AGENT_MESSAGES, action.span)
            case Evaluate():
                pass  # a pure function, whose value is dropped
            case Assign():
                self.values.refuse(Foreign.DRAFTS, action.span)

    def _if_there(self, value: Value, source: str, *acts: Act) -> Iterator[Act]:
        """What is done where a value is there: an action that lacks one is not done."""
        there = self.values.presence(value, source)
        if there == ALWAYS:
            yield from acts
        elif there != NEVER:
            yield If(there, acts)

    def _filled(self, fill: Assign, source: str) -> tuple[str, Term]:
        assert isinstance(fill.target, Member)
        term = self.values.term(fill.value, source)
        there = self.values.presence(fill.value, source)
        return ".".join(fill.target.path), term if there == ALWAYS else Pick(there, term, Const(None))


__all__ = ["Refusal", "lowered", "place"]
