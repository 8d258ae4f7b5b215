"""The flattened chart: regions, the numbers of their leaves, compound transitions, uses of messages.

Inside a region the hierarchy of OR states disappears: one integer says which leaf (START, BASIC, END or AND)
is active. The leaves of a composite have consecutive numbers.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

from aseme_dsl.amola.expression import (
    NEVER,
    After,
    Age,
    Arithmetic,
    Assign,
    At,
    Call,
    Compare,
    Expired,
    Has,
    Holds,
    Literal,
    Mean,
    Member,
    Named,
    Negate,
    Raised,
    StateValue,
    TransitionExpression,
    Value,
    VariableValue,
    values_of,
    walk,
)
from aseme_dsl.amola.meant import loop_of, performers, states_meant
from aseme_dsl.amola.messages import DURATION, Comm
from aseme_dsl.amola.srm import Activity
from aseme_dsl.amola.statechart import (
    Node,
    NodeType,
    Statechart,
    Transition,
    TransitionKind,
)


@dataclass(frozen=True, slots=True)
class Way:
    """A transition by its number; into a CONDITION with the ways out of it, in the order they are tried."""

    number: int
    branches: tuple[Way, ...] = ()


@dataclass(frozen=True, slots=True)
class Wait:
    """Something that time alone may change while a source is active.

    `kind` is "after" (`amount` ns after the entry of `source`), "within" (the same, while the activity of
    `source` runs), "timer" (`name`) or "age" (the message `member` becomes `amount` ns old).
    """

    source: str
    kind: str
    amount: int = 0
    name: str = ""
    member: Member | None = None


@dataclass(frozen=True, slots=True)
class FlatRegion:
    """A region: its number, its label and how many numbers its leaves have."""

    number: int
    label: str
    size: int


class FlatChart:
    """A statechart with everything that the generator asks about it."""

    def __init__(
        self,
        chart: Statechart,
        activities: Iterable[Activity] = (),
        width: Callable[[Node], int] | None = None,
    ) -> None:
        """`activities` are those of the system: of those in the chart, what is said of them counts.

        `width` says how many numbers a leaf needs, none if it is never active between two rounds.
        """
        self.chart = chart
        self._width = width or _width
        self.activities = {activity.name: activity for activity in activities}
        self.region_number: dict[str, int] = {}
        """The number of the innermost region around each state."""
        self.leaf: dict[str, int] = {}
        """The number of each leaf in its region; a BASIC that is complete has the next one, if it has two."""
        self.range: dict[str, tuple[int, int]] = {}
        """The first and last number of the leaves of each state inside its region."""
        self.regions: tuple[FlatRegion, ...] = self._number()
        self.transition_number = {id(t): n for n, t in enumerate(chart.transitions)}
        self._around: dict[str, list[Node]] = {}
        self._ways: dict[str, tuple[Way, ...]] = {}
        self._first_ways: dict[str, tuple[Way, ...]] = {}

    def _number(self) -> tuple[FlatRegion, ...]:
        labels: list[str] = []
        sizes: list[int] = []
        for node in self.chart.nodes:  # parents come before children, so document order
            if self.chart.is_region(node.label):
                self.region_number[node.label] = len(labels)
                labels.append(node.label)
                sizes.append(0)
            else:
                assert node.parent is not None
                self.region_number[node.label] = self.region_number[node.parent]
            if node.type in (NodeType.OR, NodeType.CONDITION):
                continue
            region = self.region_number[node.label]
            width = self._width(node)
            if not width:
                continue
            first, last = sizes[region], sizes[region] + width - 1
            self.leaf[node.label] = first
            sizes[region] += width
            for around in self._inside_region(node.label):
                known = self.range.get(around)
                self.range[around] = (known[0] if known else first, last)
        return tuple(FlatRegion(n, label, sizes[n]) for n, label in enumerate(labels))

    def _inside_region(self, label: str) -> Iterator[str]:
        """The label and the states around it up to its region, the region included."""
        while True:
            yield label
            if self.chart.is_region(label):
                return
            parent = self.chart.node(label).parent
            assert parent is not None
            label = parent

    def around(self, label: str) -> list[Node]:
        """The OR states around a leaf inside its region, innermost first, the region itself excluded."""
        found = self._around.get(label)
        if found is None:
            found = [self.chart.node(item) for item in list(self._inside_region(label))[1:-1]]
            self._around[label] = found
        return found

    def sources_around(self, leaf: str) -> list[Node]:
        """The states around a leaf inside its region that may have transitions, innermost first.

        The region itself is one of them where some lead out of its AND.
        """
        found = self.around(leaf)
        region = self.regions[self.region_number[leaf]]
        return [*found, self.chart.node(region.label)] if self.chart.outgoing(region.label) else found

    def place(self, taken: Sequence[int]) -> int:
        """The region in which a compound transition acts: that of its scope."""
        scopes = [self.chart.scope_of(self.transition(number)) for number in taken]
        return self.region_number[min(scopes, key=len)]

    @cached_property
    def leading_out(self) -> Mapping[int, int]:
        """The transitions that lead out of their region, by number, each with the region of its scope."""
        if len(self.regions) == 1:
            return {}
        found: dict[int, int] = {}
        for number, transition in enumerate(self.chart.transitions):
            if (
                transition.is_way
                and (place := self.place((number,))) != self.region_number[transition.source]
            ):
                found[number] = place
        return found

    def is_left_from_inside(self, label: str) -> bool:
        """Whether a transition leads from inside an AND out of it."""
        return any(
            self.transition(number).source.startswith(f"{label}.")
            and place in (self.region_number[label], *self.regions_around(self.region_number[label]))
            for number, place in self.leading_out.items()
        )

    def places(self, number: int) -> frozenset[int]:
        """The regions in which the actions of a transition may count."""
        transition = self.transition(number)
        found = {self.leading_out.get(number, self.region_number[transition.source])}
        if self.leading_out and self.chart.node(transition.target).type is NodeType.CONDITION:
            for branch in self.segments(transition.target):
                found.add(self.leading_out.get(self.transition_number[id(branch)], min(found)))
        return frozenset(found)

    def leaves(self, region: int) -> list[Node]:
        """The leaves of a region in document order."""
        return self._leaves[region]

    @cached_property
    def _leaves(self) -> list[list[Node]]:
        found: list[list[Node]] = [[] for _ in self.regions]
        for node in self.chart.nodes:
            if node.label in self.leaf:
                found[self.region_number[node.label]].append(node)
        return found

    def regions_of(self, label: str) -> list[FlatRegion]:
        """The regions of an AND."""
        return [self.regions[self.region_number[node.label]] for node in self.chart.children(label)]

    def enclosing(self, region: int) -> int | None:
        """The region around a region."""
        parent = self.chart.node(self.regions[region].label).parent
        return None if parent is None else self.region_number[parent]

    @cached_property
    def branches(self) -> tuple[Node, ...]:
        """The states that are the branch of a participant."""
        return tuple(node for node in self.chart.nodes if self.chart.is_branch(node))

    @cached_property
    def leaving(self) -> tuple[Node, ...]:
        """The composites with something to do when they are left: branches, and what has an `exit`."""
        return tuple(
            node
            for node in self.chart.nodes
            if node.type is NodeType.OR and (self.chart.is_branch(node) or self.chart.exits_of(node.label))
        )

    @cached_property
    def resumed(self) -> tuple[Node, ...]:
        """The composites that some transition resumes."""
        labels = {transition.target for transition in self.chart.transitions if transition.resume}
        return tuple(node for node in self.chart.nodes if node.label in labels and node.type is NodeType.OR)

    def regions_inside(self, label: str) -> list[FlatRegion]:
        """The regions inside a state, at any depth."""
        return [region for region in self.regions if region.label.startswith(f"{label}.")]

    @cached_property
    def entered_again(self) -> tuple[FlatRegion, ...]:
        """The regions that a composite which is resumed may have inside, but for those in branches."""
        return tuple(
            region
            for region in self.regions
            if any(
                region.label.startswith(f"{node.label}.")
                and self.chart.branch_of(region.label) == self.chart.branch_of(node.label)
                for node in self.resumed
            )
        )

    @cached_property
    def staying(self) -> Mapping[str, tuple[int, ...]]:
        """The numbers of the `on` transitions of each state that has some."""
        found: dict[str, tuple[int, ...]] = {}
        for number, transition in enumerate(self.chart.transitions):
            if transition.kind is TransitionKind.ON:
                found[transition.source] = (*found.get(transition.source, ()), number)
        return found

    def transition(self, number: int) -> Transition:
        """The transition of that number in the template's order."""
        return self.chart.transitions[number]

    def ways(self, label: str) -> tuple[Way, ...]:
        """The ways out of a source in the order in which they are tried, without those that are `first`."""
        found = self._ways.get(label)
        if found is None:
            found = tuple(self._way(item) for item in self.chart.outgoing(label) if not item.first)
            self._ways[label] = found
        return found

    def first_ways(self, label: str) -> tuple[Way, ...]:
        """The ways that are tried before anything inside the source."""
        found = self._first_ways.get(label)
        if found is None:
            found = tuple(
                self._way(item)
                for item in self.chart.outgoing(label)
                if item.first and item.expression is not NEVER
            )
            self._first_ways[label] = found
        return found

    def _way(self, transition: Transition) -> Way:
        target = self.chart.node(transition.target)
        branches = self.ways(target.label) if target.type is NodeType.CONDITION else ()
        return Way(self.transition_number[id(transition)], branches)

    def waits_for_event(self, way: Way) -> bool:
        """Whether a way may be taken while its source is not complete."""
        expression = self.transition(way.number).expression
        return bool(expression.events) or expression.when

    def segments(self, label: str) -> Iterator[Transition]:
        """The transitions out of a source and out of the CONDITIONs they lead to."""
        stack = list(reversed((*self.first_ways(label), *self.ways(label))))
        while stack:
            way = stack.pop()
            yield self.transition(way.number)
            stack.extend(reversed(way.branches))

    @cached_property
    def sources(self) -> tuple[str, ...]:
        """The states that may be active and have transitions, in document order."""
        return tuple(
            node.label
            for node in self.chart.nodes
            if node.type is not NodeType.CONDITION and self.chart.outgoing(node.label)
        )

    @cached_property
    def waits(self) -> tuple[Wait, ...]:
        """Everything that time alone may change, by source."""
        found: dict[Wait, None] = {}
        for source in self.sources:
            for transition in self.segments(source):
                for wait in _waits(source, transition.expression):
                    found.setdefault(wait)
        for label, within in self.deadlines.items():
            found.setdefault(Wait(label, "within", within))
        return tuple(found)

    def said_of(self, node: Node) -> Activity | None:
        """What is said of the activity of a BASIC state."""
        return self.activities.get(node.activity) if node.activity is not None else None

    @cached_property
    def deadlines(self) -> dict[str, int]:
        """The BASIC states whose activity has a deadline, with how long it has from their entry, in ns."""
        return {
            node.label: said.within
            for node in self.chart.nodes
            if (said := self.said_of(node)) is not None and said.within is not None
        }

    @cached_property
    def ending(self) -> frozenset[str]:
        """The BASIC states whose activity ends with an outcome."""
        return frozenset(
            node.label for node in self.chart.nodes if (said := self.said_of(node)) is not None and said.ends
        )

    def asked_of(self, source: str, activity: str) -> tuple[str, ...]:
        """The states of which `outcome(activity)` is the last outcome, in a transition out of `source`."""
        return tuple(node.label for node in performers(self.chart, source, activity))

    @cached_property
    def counted(self) -> dict[str, str]:
        """The states whose entries somebody counts, each with the state whose entry sets the count to 0."""
        found = {
            node.label
            for place, value in self.chart.values()
            if isinstance(value, StateValue) and value.question == "count"
            for node in states_meant(self.chart, place, value.state)
        }
        return {
            node.label: loop_of(self.chart, node.label) for node in self.chart.nodes if node.label in found
        }

    @cached_property
    def timed(self) -> frozenset[str]:
        """The states whose moment of entry somebody asks for."""
        return frozenset(wait.source for wait in self.waits if wait.kind in ("after", "within"))

    @cached_property
    def members(self) -> dict[int, tuple[Member, ...]]:
        """The messages that the expressions of each region look at, members and hosts included."""
        found: dict[int, dict[tuple[str, str | None], Member]] = {}
        for place, value in self.chart.values():
            if isinstance(value, Member):
                of_region = found.setdefault(self.region_number[place], {})
                of_region.setdefault((str(value.channel), value.host), value)
        return {
            region: tuple(uses[key] for key in sorted(uses, key=_by_channel))
            for region, uses in found.items()
        }

    @cached_property
    def aged(self) -> frozenset[tuple[int, str, str | None]]:
        """(region, channel, host) whose time of measurement somebody asks for."""
        return frozenset(
            (self.region_number[place], str(v.message.channel), v.message.host)
            for place, v in self.chart.values()
            if isinstance(v, Age)
        )

    @cached_property
    def variable_regions(self) -> dict[str, tuple[int, ...]]:
        """The regions whose expressions read, write or renew each variable, and one around inner ones."""
        found: dict[str, set[int]] = {variable.name: set() for variable in self.chart.variables}
        for variable in self.chart.variables:
            if variable.scope is not None:
                found[variable.name].add(self.region_number[variable.scope])
        for number, transition in enumerate(self.chart.transitions):
            region = self.region_number[transition.source]
            for name in _variables(transition.expression):
                found[name].add(region)
            for name in _assigned(transition.expression):
                found[name].update(self.places(number))
        for place, value in self.chart.values():
            if isinstance(value, VariableValue):
                found[value.name].add(self.region_number[place])
        for variable in self.chart.variables:
            # a region that is entered again starts with the copy around it, so there must be one
            if variable.scope is None and any(self._is_entered_again(n) for n in found[variable.name]):
                found[variable.name].add(0)
        return {name: tuple(sorted(regions)) for name, regions in found.items()}

    @cached_property
    def awaited(self) -> dict[int, frozenset[str]]:
        """The raised events that transitions of each region wait for."""
        found: dict[int, set[str]] = {}
        for transition in self.chart.transitions:
            names = {event.name for event in transition.expression.events if isinstance(event, Raised)}
            found.setdefault(self.region_number[transition.source], set()).update(names)
        return {region: frozenset(names) for region, names in found.items() if names}

    @cached_property
    def asked_signals(self) -> dict[int, frozenset[str]]:
        """The channels of the signals that the expressions of each region look at."""
        return {
            region: frozenset(str(use.channel) for use in uses if use.channel.comm is Comm.SIGNAL)
            for region, uses in self.members.items()
        }

    @cached_property
    def circling(self) -> tuple[int, ...]:
        """The numbers of the transitions that may be taken again and again within one step."""
        basic = {node.label for node in self.chart.nodes if node.type is NodeType.BASIC}
        ways: dict[str, dict[str, None]] = {}
        for node in self.chart.nodes:  # in at the START, out at the END, whatever is in between
            if node.parent is None:
                continue
            is_region = self.chart.node(node.parent).type is NodeType.AND
            if is_region or node.type is NodeType.START:
                ways.setdefault(node.parent, {})[node.label] = None
            cut = any(way.expression.when for way in self.chart.ways_from(node.parent))
            if is_region or cut or node.type is NodeType.END:
                ways.setdefault(node.label, {})[node.parent] = None
        quick: list[int] = []
        for number, transition in enumerate(self.chart.transitions):
            said = transition.expression
            waits = said.events or said is NEVER or said.every or transition.reactive
            if transition.is_way and not waits and (said.when or transition.source not in basic):
                quick.append(number)
                ways.setdefault(transition.source, {})[transition.target] = None

        def leads(source: str, target: str) -> bool:
            seen, waiting = {source}, [source]
            while waiting and target not in seen:
                new = ways.get(waiting.pop(), {}).keys() - seen
                seen |= new
                waiting += new
            return target in seen

        ends = [(self.chart.transitions[n].target, self.chart.transitions[n].source) for n in quick]
        return tuple(
            number for number, (target, source) in zip(quick, ends, strict=True) if leads(target, source)
        )

    def regions_around(self, region: int) -> Iterator[int]:
        """The regions around a region, innermost first."""
        around = self.enclosing(region)
        while around is not None:
            yield around
            around = self.enclosing(around)

    @cached_property
    def wakes(self) -> dict[str, dict[int, tuple[str, ...]]]:
        """Of each variable that one region writes and a condition of another reads: the regions that read it
        so, with the sources of these transitions.

        A region that is entered after the write of one around it starts with what was written: only what is
        done without leaving it can wake it.
        """
        found: dict[str, dict[int, dict[str, None]]] = {}
        for source in self.sources:
            for transition in self.segments(source):
                condition = transition.expression.condition
                for value in walk(condition) if condition is not None else ():
                    if isinstance(value, VariableValue):
                        readers = found.setdefault(value.name, {})
                        readers.setdefault(self.region_number[source], {}).setdefault(source)
        writers: dict[str, set[tuple[int, bool]]] = {}
        for number, transition in enumerate(self.chart.transitions):
            stays = transition.kind is TransitionKind.ON
            for name in _assigned(transition.expression):
                writers.setdefault(name, set()).update((place, stays) for place in self.places(number))
        woken: dict[str, dict[int, tuple[str, ...]]] = {}
        for name, readers in found.items():
            for region, sources in readers.items():
                others = (item for item in writers.get(name, ()) if item[0] != region)
                if any(stays or writer not in self.regions_around(region) for writer, stays in others):
                    woken.setdefault(name, {})[region] = tuple(sources)
        return woken

    @cached_property
    def missed(self) -> dict[str, dict[int, tuple[str, ...]]]:
        """Of each signal: the regions with a condition that may hold because the signal is gone, with the
        sources of these transitions.

        In three-valued logic an absent value makes nothing true that was not true before. Only what is
        two-valued, and what raises with the signal, tells that it is gone.
        """
        found: dict[str, dict[int, dict[str, None]]] = {}
        for source in self.sources:
            for transition in self.segments(source):
                condition = transition.expression.condition
                parts = list(walk(condition)) if condition is not None else []
                if not any(_tells_absence(part) for part in parts):
                    continue
                for channel, _ in signals(parts):
                    readers = found.setdefault(channel, {})
                    readers.setdefault(self.region_number[source], {}).setdefault(source)
        return {
            channel: {region: tuple(sources) for region, sources in readers.items()}
            for channel, readers in found.items()
        }

    def _is_entered_again(self, region: int) -> bool:
        """Whether a region may be entered after it was left: its AND can be reached from itself."""
        and_state = self.chart.node(self.regions[region].label).parent
        if and_state is None:
            return False
        inside = f"{and_state}."
        leaving = (self.transition(number).source for number in self.leading_out)
        stack = [and_state, *(source for source in leaving if source.startswith(inside))]
        seen = {*stack}
        while stack:
            active = stack.pop()
            for source in (active, *(around.label for around in self.chart.ancestors(active))):
                for transition in self.chart.outgoing(source):
                    entered = [transition.target]
                    while entered:
                        state = entered.pop()
                        if state == and_state or (state.startswith(inside) and not source.startswith(inside)):
                            return True
                        start = self.chart.start_of(state)
                        if start is not None:
                            entered.append(start.label)
                        elif self.chart.node(state).type is NodeType.AND:
                            entered += [inner.label for inner in self.chart.children(state)]
                        elif state not in seen:
                            seen.add(state)
                            stack.append(state)
        return False

    @cached_property
    def retention(self) -> dict[str, int]:
        """How long the expressions look back at each data channel, in ns."""
        found: dict[str, int] = {}
        for _, value in self.chart.values():
            match value:
                case At(message=message, offset=extent) | Mean(message=message, window=extent):
                    channel = str(message.channel)
                    found[channel] = max(found.get(channel, 0), _extent(extent))
        return found


def _width(leaf: Node) -> int:
    return 2 if leaf.type is NodeType.BASIC else 1


def _by_channel(key: tuple[str, str | None]) -> tuple[str, str]:
    return key[0], key[1] or ""


def _variables(expression: TransitionExpression) -> Iterator[str]:
    for value in values_of(expression):
        if isinstance(value, VariableValue):
            yield value.name
    yield from _assigned(expression)


def _assigned(expression: TransitionExpression) -> Iterator[str]:
    for action in expression.actions:
        if isinstance(action, Assign) and isinstance(action.target, VariableValue):
            yield action.target.name


def constant(value: Value) -> int | None:
    """The value of a duration that is a constant, in ns (`-200ms` and `2 * 100ms` too)."""
    if value.type != DURATION:
        return None
    amount = _folded(value)
    return None if amount is None else int(amount)


def _folded(value: Value) -> int | float | None:
    """A number or duration that is written down or computed from such: as the generated code computes it."""
    match value:
        case Literal(value=int() | float() as amount):
            return amount
        case Named(expression=inner):
            return _folded(inner)
        case Negate(operand=operand):
            positive = _folded(operand)
            return None if positive is None else -positive
        case Arithmetic(operator=operator, left=left, right=right, type=kind):
            one, other = _folded(left), _folded(right)
            if one is None or other is None or (operator in ("/", "%") and not other):
                return None
            match operator:
                case "+":
                    result = one + other
                case "-":
                    result = one - other
                case "*":
                    result = one * other
                case "%":
                    result = one % other
                case _:
                    result = one // other if kind == DURATION else one / other
            return int(result) if kind == DURATION else result
    return None


_MINUTE = 60_000_000_000


def _extent(value: Value) -> int:
    """How far back a history is asked for; a minute where the document computes it."""
    amount = constant(value)
    return _MINUTE if amount is None else abs(amount)


def _waits(source: str, expression: TransitionExpression) -> Iterator[Wait]:
    for event in expression.events:
        if isinstance(event, After):
            yield Wait(source, "after", event.duration)
    if expression.every is not None:
        yield Wait(source, "after", expression.every)
    if expression.condition is None:
        return
    for value in walk(expression.condition):
        match value:
            case Expired(timer=timer):
                yield Wait(source, "timer", name=timer)
            case Compare(operator=operator, left=left, right=right):
                yield from _age_waits(source, operator, left, right)


_FLIPPED = {"<": ">", "<=": ">=", ">": "<", ">=": "<=", "==": "==", "!=": "!="}


def _age_waits(source: str, operator: str, left: Value, right: Value) -> Iterator[Wait]:
    left, right = _plain(left), _plain(right)
    if isinstance(right, Age):
        left, right, operator = right, left, _FLIPPED[operator]
    amount = constant(right)
    if not isinstance(left, Age) or amount is None:
        return
    if operator in ("<", ">=", "==", "!="):
        yield Wait(source, "age", amount, member=left.message)
    if operator in (">", "<=", "==", "!="):
        yield Wait(source, "age", amount + 1, member=left.message)


def _plain(value: Value) -> Value:
    while isinstance(value, Named):
        value = value.expression
    return value


def _tells_absence(value: Value) -> bool:
    """Whether a value is two-valued whatever is absent, or may raise."""
    match value:
        case Has() | Holds():
            return True
        case Call(function=function):
            return not function.target.startswith("builtin:")
        case Arithmetic(operator=operator):
            return operator in ("*", "/", "%")
    return False


def signals(values: Iterable[Value]) -> tuple[tuple[str, str | None], ...]:
    """The signals (channel, host) among values, each once."""
    found = {
        (str(v.channel), v.host): None
        for v in values
        if isinstance(v, Member) and v.channel.comm is Comm.SIGNAL
    }
    return tuple(found)


__all__ = ["FlatChart", "FlatRegion", "Wait", "Way", "constant", "signals"]
