"""A statechart to the class that runs: one slotted class, one integer a region, everything else inlined.

What the code does is written in the semantics; its form is the one that was measured to cost no more than
what a careful person writes by hand. Methods of the class, for region 3:

    _region_3   one round of the region: by its active leaf, the transitions that can be taken from there
    _around_…   the transitions of a composite that may be taken while it is not complete
    _first_…    the transitions of a composite that are tried before anything inside it
    _enter_3    the region's AND is entered;  _leave_3: it is left
    _picks_12   the agent message that transition 12 takes, where it speaks of it
    _holds_12   the condition of transition 12, where evaluating it may raise
    _seen_12    what the condition of the `on` transition 12 reads
    _exit_…     what is done when a state is left
    _keep_…     what is remembered of a composite that may be resumed
    _resume_…   such a composite goes on;  _again_3: and a region in it
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import assert_never

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
    Outcome,
    Publish,
    Raised,
    ReadMessages,
    Received,
    Send,
    StartTimer,
    StateValue,
    TransitionExpression,
    Value,
    VariableValue,
    taken_message,
    values_of,
    walk,
)
from aseme_dsl.amola.messages import Comm
from aseme_dsl.amola.statechart import (
    Node,
    NodeType,
    Region,
    Statechart,
    TransitionKind,
)
from aseme_dsl.amola.system import System
from aseme_dsl.codegen.expressions import (
    Names,
    Piece,
    converted,
    evaluate,
    holds,
)
from aseme_dsl.codegen.face import Face, Method, docstring, mail_name, natural
from aseme_dsl.codegen.flat import FlatChart, Wait, Way, signals

TABLE = 64
"""Regions with more numbers than this dispatch through a tuple of functions, others through comparisons."""

LOST = "lost"
"""What stands for the performative where an agent is lost."""


@dataclass(frozen=True, slots=True)
class StepCode:
    """The parts of a step module: what it imports from the messages module, and its lines."""

    class_name: str
    messages: tuple[str, ...]
    constants: tuple[tuple[str, str], ...]
    """Module-level names of enum constants with the expression they stand for."""
    boards: tuple[str, ...]
    body: tuple[str, ...]
    tables: tuple[str, ...]

    def uses(self, name: str) -> bool:
        """Whether the module's lines mention a name."""
        pattern = re.compile(rf"\b{name}\b")
        return any(name in line and pattern.search(line) for line in (*self.body, *self.tables))


def generate_step(system: System, chart: Statechart, class_name: str) -> StepCode:
    """The step class of a role's statechart."""
    return _Generator(system, chart, class_name).generate()


@dataclass(frozen=True, slots=True)
class _Body:
    """What a round does while a region has this number."""

    number: int
    title: str
    method: Method


class _Generator(Face):
    def __init__(self, system: System, chart: Statechart, class_name: str) -> None:
        super().__init__(system, chart, FlatChart(chart, system.activities), (class_name,))
        self.class_name = class_name
        self.published: set[str] = set()
        self.slots = {region.number: self._region_slots(region.number) for region in self.flat.regions}
        self.seen = {
            region: {message: f"b.{slot}" for message, slot in slots.items()}
            for region, slots in self.slots.items()
        }

    # ---- names -----------------------------------------------------------------------------

    def _region_slots(self, region: int) -> dict[tuple[str, str | None], str]:
        found: dict[tuple[str, str | None], str] = {}
        for member in self.flat.members.get(region, ()):
            channel, host = str(member.channel), member.host
            wish = f"{host}_{channel}" if host else channel
            found[channel, host] = self.identifiers.name((channel, host), wish)
        return found

    def _variable(self, name: str, region: int) -> str:
        """The attribute that holds a variable for the expressions of a region."""
        plain = name.replace("@", "_")
        regions = self.flat.variable_regions[name]
        if len(regions) < 2:
            return self.identifiers.name(("variable", name), f"v_{plain}")
        return self.identifiers.name(("variable", name, region), f"v{region}_{plain}")

    def _copies(self, name: str) -> list[str]:
        regions = self.flat.variable_regions[name]
        return list(dict.fromkeys(self._variable(name, region) for region in regions or (0,)))

    def _kept(self, node: Node) -> str:
        """What is remembered of a composite that may be resumed."""
        return self.identifiers.name(("kept", node.label), f"m_{node.label}")

    def _memories(self) -> list[str]:
        kept = {node.label: self._kept(node) for node in self.flat.resumed}
        return [f"    KEPT: ClassVar[Mapping[str, str]] = {kept!r}"] if kept else []

    def _mark(self, number: int) -> str:
        """What an `on` transition has seen when it was taken last."""
        return self.identifiers.name(("mark", number), f"o_{number}")

    def _past(self, number: int) -> str:
        """The longest `after` by which an `on` transition was taken."""
        return self.identifiers.name(("past", number), f"a_{number}")

    def _has_mark(self, number: int) -> bool:
        """Whether a transition may be taken without an event, and must know what it has seen."""
        expression = self.chart.transitions[number].expression
        return expression.when or not expression.events

    def _has_time(self, number: int) -> bool:
        return any(isinstance(event, After) for event in self.chart.transitions[number].expression.events)

    def _names(self, region: int, prefix: str = "") -> Names:
        variables = {name: f"self.{self._variable(name, region)}" for name in self.variables}
        return Names(self.seen[region], variables, self.fields, self.constants, self.enums, prefix=prefix)

    def _held(self, region: int) -> tuple[str, str]:
        return f"b: Board{region}, now: int", "b, now"

    # ---- the whole -------------------------------------------------------------------------

    def generate(self) -> StepCode:
        for region in self.flat.regions:
            self._region(region.number)
            self._leave(region.number)
            if region.number:
                self._enter_region(region.number)
        for node in self.chart.nodes:
            if self.chart.exits_of(node.label):
                self._exit(node)
        for numbers in self.flat.staying.values():
            for number in numbers:
                if self._has_mark(number):
                    self._seen(number)
        for node in self.flat.resumed:
            self._keep(node)
            self._resume(node)
        for inner in self.flat.entered_again:
            self._again(inner.number)
        self._enter_root()
        self._frame()
        boards = [line for region in self.flat.regions for line in self._board(region.number)]
        body = [line for method in [self._head(), *self.methods] for line in [*method, ""]]
        constants = tuple(
            (self.constants[enum, constant], f"{enum}.{constant}") for enum, constant in sorted(self.enums)
        )
        used = self.messages | {enum for enum, _ in self.enums} | self.published
        return StepCode(
            self.class_name, tuple(sorted(used)), constants, tuple(boards), tuple(body), tuple(self.tables)
        )

    def _method(self, signature: str, document: str, method: Method) -> None:
        """Write a method, with only those locals that its lines use."""
        region = next((r for r, slots in self.seen.items() if slots is method.names.slots), 0)
        lines = [f"    def {signature}:", f'        """{document}"""']
        text = "\n".join(method.lines)
        if re.search(r"\bb\b", text) and "b:" not in signature:
            lines.append(f"        b = self.b{region}")
        lines += method.lines
        self.methods.append(lines)

    # ---- the class -------------------------------------------------------------------------

    def _head(self) -> list[str]:
        regions = self.flat.regions
        attributes: list[tuple[str, str, str | None]] = []
        for region in regions:
            attributes += [
                (f"r{region.number}", "int", "INACTIVE"),
                (f"k{region.number}", "int", "0"),
                (f"b{region.number}", f"Board{region.number}", f"Board{region.number}()"),
            ]
        if self.flat.leading_out:
            attributes.append(("out", "int", "-1"))
        attributes += [(self._time(label), "int", "0") for label in sorted(self.flat.timed)]
        for number in (n for numbers in self.flat.staying.values() for n in numbers):
            if self._has_mark(number):
                attributes.append((self._mark(number), "Seen | None", "None"))
            if self._has_time(number):
                attributes.append((self._past(number), "int", "-1"))
        attributes += [(self._kept(node), "dict[int, int] | None", "None") for node in self.flat.resumed]
        attributes += [(self._count(label), "int", "0") for label in self.flat.counted]
        for variable in self.chart.variables:
            attributes += [
                (copy, self._python(variable.type), self._initial(variable))
                for copy in self._copies(variable.name)
            ]
        names = ", ".join(f'"{name}"' for name, _, _ in sorted(attributes, key=natural))
        running = {
            node.label: (f"r{region.number}", f"k{region.number}", self.flat.leaf[node.label])
            for region in regions
            for node in self.flat.leaves(region.number)
            if node.type is NodeType.BASIC
        }
        variables = {v.name: tuple(self._copies(v.name)) for v in self.chart.variables}
        times = {label: self._time(label) for label in sorted(self.flat.timed)}
        lines = [
            f"class {self.class_name}(Chart):",
            f'    """Runs the statechart {self.chart.name} of {self.chart.system}."""',
            "",
            f"    __slots__ = ({names},)",
            "",
            "    PLAN = PLAN",
            f"    REGIONS = {tuple(region.label for region in regions)!r}",
            f"    READERS: ClassVar[Mapping[str, tuple[int, ...]]] = {self._readers()!r}",
            f"    RUNNING: ClassVar[Mapping[str, tuple[str, str, int]]] = {running!r}",
            f"    VARIABLES: ClassVar[Mapping[str, tuple[str, ...]]] = {variables!r}",
            f"    MESSAGES: ClassVar[Mapping[str, Any]] = {self._message_classes()}",
            f"    TIMES: ClassVar[Mapping[str, str]] = {times!r}",
            *self._deadlines(),
            *self._wakes(),
            *self._missed(),
            *self._marks(),
            *self._memories(),
            *self._counts(),
            "    LEAVES: ClassVar[tuple[tuple[str, ...], ...]] = (",
            *(f"        {labels!r}," for labels in self._leaf_labels()),
            "    )",
            "",
            "    def __init__(self, agent: str) -> None:",
            "        super().__init__(agent)",
        ]
        lines += [f"        self.{name}: {kind} = {value}" for name, kind, value in attributes]
        agents = [agent for team in self.system.teams for agent in team.agents]
        if any(agent.settings for agent in agents if agent.role == self.chart.name):
            lines.append("        self.settle()")
        return lines

    def _deadlines(self) -> list[str]:
        found = self.flat.deadlines
        return [f"    WITHIN: ClassVar[Mapping[str, int]] = {found!r}"] if found else []

    def _wakes(self) -> list[str]:
        """The copies of variables whose writers wake other regions, and the leaves at which they are read."""
        found: dict[str, tuple[tuple[str, str, tuple[tuple[int, int], ...]], ...]] = {}
        for name, readers in self.flat.wakes.items():
            found[name] = tuple(
                (self._variable(name, region), f"r{region}", self._leaves_at(sources))
                for region, sources in readers.items()
            )
        kind = "tuple[tuple[str, str, tuple[tuple[int, int], ...]], ...]"
        return [f"    WAKES: ClassVar[Mapping[str, {kind}]] = {found!r}"] if found else []

    def _missed(self) -> list[str]:
        """Of signals whose absence may enable something: the regions, and the leaves at which it may."""
        found: dict[str, tuple[tuple[int, str, tuple[tuple[int, int], ...]], ...]] = {}
        for channel, readers in self.flat.missed.items():
            found[channel] = tuple(
                (region, f"r{region}", self._leaves_at(sources)) for region, sources in readers.items()
            )
        kind = "tuple[tuple[int, str, tuple[tuple[int, int], ...]], ...]"
        return [f"    MISSED: ClassVar[Mapping[str, {kind}]] = {found!r}"] if found else []

    def _leaves_at(self, sources: Iterable[str]) -> tuple[tuple[int, int], ...]:
        """The first and last numbers of the leaves at which one of these states is active."""
        found: list[tuple[int, int]] = []
        for first, last in sorted(self.flat.range[source] for source in sources):
            if found and first <= found[-1][1] + 1:
                found[-1] = found[-1][0], max(last, found[-1][1])
            else:
                found.append((first, last))
        return tuple(found)

    def _marks(self) -> list[str]:
        """The slots of what the `on` transitions remember, by number, where there are any."""
        marks = {
            number: (
                self._mark(number) if self._has_mark(number) else "",
                self._past(number) if self._has_time(number) else "",
            )
            for numbers in self.flat.staying.values()
            for number in numbers
            if self._has_mark(number) or self._has_time(number)
        }
        return [f"    MARKS: ClassVar[Mapping[int, tuple[str, str]]] = {marks!r}"] if marks else []

    def _counts(self) -> list[str]:
        found = {label: self._count(label) for label in self.flat.counted}
        return [f"    COUNTS: ClassVar[Mapping[str, str]] = {found!r}"] if found else []

    def _readers(self) -> dict[str, tuple[int, ...]]:
        found: dict[str, list[int]] = {}
        for region in self.flat.regions:
            for channel in self._reads(region.number):
                found.setdefault(channel, []).append(region.number)
        return {channel: tuple(numbers) for channel, numbers in sorted(found.items())}

    def _reads(self, region: int) -> tuple[str, ...]:
        return tuple(sorted(str(channel) for channel in self._region_model(region).reads))

    def _region_model(self, region: int) -> Region:
        label = self.flat.regions[region].label
        return next((r for r in self.chart.regions if r.label == label), Region(label, (), ()))

    def _message_classes(self) -> str:
        found: dict[str, str] = {}
        for transition in self.chart.transitions:
            for action in transition.expression.actions:
                if isinstance(action, Publish):
                    found[str(action.channel)] = action.channel.message
                elif isinstance(action, Send):
                    found[action.message] = action.message
        self.published |= set(found.values())
        return "{" + ", ".join(f"{key!r}: {found[key]}" for key in sorted(found)) + "}"

    def _board(self, number: int) -> list[str]:
        region = self.flat.regions[number]
        slots = self.slots[number]
        reads = self._reads(number)
        rules = {str(r.channel): r for topic in self.system.topics for r in topic.channels}
        queued = sorted(channel for channel in reads if channel in rules and rules[channel].queued)
        table: dict[str, tuple[tuple[str, str | None], ...]] = {}
        typed: list[str] = []
        timed: list[str] = []
        for (channel, host), slot in sorted(slots.items(), key=lambda item: item[1]):
            table[channel] = (*table.get(channel, ()), (slot, host))
            message = channel.rsplit(".", 1)[1]
            self.messages.add(message)
            typed.append(f"    {slot}: {message} | None")
            if (number, channel, host) in self.flat.aged:
                timed.append(slot)
                typed.append(f"    {slot}_time: int")
        names = [line.split(":")[0].strip() for line in typed]
        kept = {c: n for c, n in sorted(self._retention().items()) if c in reads}
        lines = [
            "",
            "",
            f"class Board{number}(Board):",
            f'    """What region {region.label} knows."""',
            "",
            "    __slots__ = ("
            + "".join(
                f'"{name}", ' for name in sorted(names, key=lambda name: natural((name, "", None)))
            ).rstrip()
            + ")",
            f"    CHANNELS = frozenset({list(reads)!r})",
        ]
        if queued:
            lines.append(f"    QUEUED = frozenset({queued!r})")
        if kept:
            lines.append(f"    RETENTION: ClassVar[Mapping[str, int]] = {kept!r}")
        if table:
            lines.append(f"    SLOTS: ClassVar[Mapping[str, tuple[tuple[str, str | None], ...]]] = {table!r}")
        if timed:
            lines.append(f"    TIMED = frozenset({sorted(timed)!r})")
        return lines + typed

    def _retention(self) -> dict[str, int]:
        return retention(self.system, self.chart, self.flat)

    # ---- a round ---------------------------------------------------------------------------

    def _region(self, region: int) -> None:
        bodies: list[_Body] = []
        for leaf in self.flat.leaves(region):
            number = self.flat.leaf[leaf.label]
            numbers = [number, number + 1] if leaf.type is NodeType.BASIC else [number]
            for state in numbers:
                # locals of different leaves are typed differently, so they do not share names
                method = Method(self._names(region, f"{state}_"))
                self._from_leaf(method, region, leaf, complete=self._leaf_complete(leaf, state))
                if method.lines:
                    bodies.append(_Body(state, self._leaf_title(leaf, state), method))
        label = self.flat.regions[region].label
        signature = f"_region_{region}(self, now: int) -> bool"
        document = f"One round of region {label}."
        if self.flat.regions[region].size > TABLE:
            self._table(region, bodies, signature, document)
            return
        whole = Method(self._names(region))
        if bodies:
            whole.add(2, f"r = self.r{region}")
            self._tree(whole, bodies, 2)
        whole.add(2, "return False")
        self._method(signature, document, whole)

    def _tree(self, whole: Method, bodies: list[_Body], depth: int) -> None:
        """Find the body of the active leaf by comparisons; halves where there are many."""
        if len(bodies) > 4:
            middle = len(bodies) // 2
            whole.add(depth, f"if r < {bodies[middle].number}:")
            self._tree(whole, bodies[:middle], depth + 1)
            whole.add(depth, "else:")
            self._tree(whole, bodies[middle:], depth + 1)
            return
        for index, body in enumerate(bodies):
            whole.add(depth, f"{'elif' if index else 'if'} r == {body.number}:  # {body.title}")
            whole.lines += ["    " * (depth - 1) + line for line in body.method.lines]  # written two deep

    def _table(self, region: int, bodies: list[_Body], signature: str, document: str) -> None:
        """Find the body of the active leaf in a tuple of functions."""
        entries = ["None"] * self.flat.regions[region].size
        for body in bodies:
            name = f"_leaf_{region}_{body.number}"
            body.method.add(2, "return False")
            self._method(f"{name}(self, now: int) -> bool", f"While {body.title}.", body.method)
            entries[body.number] = f"{self.class_name}.{name}"
        whole = Method(self._names(region))
        whole.add(
            2,
            f"leaf = _LEAVES_{region}[self.r{region}]",
            "return leaf is not None and leaf(self, now)",
        )
        self._method(signature, document, whole)
        kind = f"tuple[Callable[[{self.class_name}, int], bool] | None, ...]"
        self.tables += ["", f"_LEAVES_{region}: {kind} = ("]
        self.tables += [f"    {entry}," for entry in entries]
        self.tables += [")"]

    def _from_leaf(self, method: Method, region: int, leaf: Node, complete: str | bool) -> None:
        """Everything that one round may do while `leaf` is active: what cuts short, the outermost first, then
        innermost source first."""
        depth = 2
        for around in reversed(self.flat.sources_around(leaf.label)):
            if self.flat.first_ways(around.label):
                method.add(depth, f"if self._first_{self._key(around.label)}(now):", "    return True")
                self._before(region, around)
        for way in self.flat.first_ways(leaf.label):
            if self._way(method, depth, region, leaf.label, leaf, complete, way, ()):
                return
        if leaf.type is NodeType.AND:
            first, *others = self.flat.regions_of(leaf.label)
            method.add(depth, f"moved = self._region_{first.number}(now)")
            self._left_behind(method, depth, region, leaf)
            for inner in others:
                method.add(depth, f"if self._region_{inner.number}(now):", "    moved = True")
                self._left_behind(method, depth, region, leaf)
            method.add(depth, "if moved:", "    return True")
        if self._ways(method, depth, region, leaf.label, leaf, complete):
            return
        inside = leaf
        for around in self.flat.sources_around(leaf.label):
            is_complete = inside.type is NodeType.END and inside is leaf and leaf.parent == around.label
            if is_complete:
                if self._ways(method, depth, region, around.label, leaf, True):
                    return
            elif any(self.flat.waits_for_event(way) for way in self.flat.ways(around.label)):
                method.add(depth, f"if self._around_{self._key(around.label)}(now):", "    return True")
                self._around(region, around)

    def _left_behind(self, method: Method, depth: int, region: int, leaf: Node) -> None:
        """The end of a round in an AND which one of its regions has left; up to the region of the scope."""
        if self.flat.is_left_from_inside(leaf.label):
            method.add(depth, "if self.out >= 0:")
            method.add(depth + 1, f"if self.out == {region}:", "    self.out = -1", "return True")

    def _around(self, region: int, source: Node) -> None:
        """A method with the transitions that may leave a composite before it is complete."""
        name = f"_around_{self._key(source.label)}(self, now: int) -> bool"
        if any(method[0] == f"    def {name}:" for method in self.methods):
            return
        method = Method(self._names(region))
        self._ways(method, 2, region, source.label, None, False)
        method.add(2, "return False")
        self._method(name, f"What may leave {source.label} {source.name} before it is complete.", method)

    def _before(self, region: int, source: Node) -> None:
        """A method with the transitions that cut a composite short."""
        name = f"_first_{self._key(source.label)}(self, now: int) -> bool"
        if any(method[0] == f"    def {name}:" for method in self.methods):
            return
        method = Method(self._names(region))
        always = any(
            self._way(method, 2, region, source.label, None, False, way, ())
            for way in self.flat.first_ways(source.label)
        )
        if not always:
            method.add(2, "return False")
        self._method(name, f"What cuts {source.label} {source.name} short.", method)

    def _ways(
        self, method: Method, depth: int, region: int, source: str, leaf: Node | None, complete: str | bool
    ) -> bool:
        """The ways out of a source; whether one of them is always taken, so that nothing follows."""
        return any(
            self._way(method, depth, region, source, leaf, complete, way, ())
            for way in self.flat.ways(source)
        )

    def _way(
        self,
        method: Method,
        depth: int,
        region: int,
        source: str,
        leaf: Node | None,
        complete: str | bool,
        way: Way,
        before: tuple[int, ...],
    ) -> bool:
        """The tests of a way around what taking it does; whether it is always taken."""
        if self.flat.transition(way.number).kind is TransitionKind.ON:
            self._on(method, depth, region, way.number, complete)
            return False
        expression = self.flat.transition(way.number).expression
        tests: list[str] = []
        if expression.events and not expression.when:
            there = " or ".join(self._there(region, source, event) for event in expression.events)
            tests.append(f"({there})" if len(expression.events) > 1 else there)
        elif not expression.events and not expression.when and not before:
            if complete is False:
                return False
            if isinstance(complete, str):
                tests.append(complete)
        if expression.every is not None:
            tests.append(f"now - self.{self._time(source)} >= {expression.every}")
        method.add(depth, f"# {self._place(way.number)}")
        outside = depth
        if expression.condition is not None:
            asked = signals(walk(expression.condition))
            if asked and tests:  # a signal is looked at only where its condition is evaluated
                method.add(depth, f"if {' and '.join(tests)}:")
                tests.clear()
                depth += 1
            for channel, host in asked:
                method.add(depth, f"b.ask({channel!r}, {host!r})")
            if not taken_message(expression):
                tests.append(self._guard(method, region, way.number, expression.condition))
        if taken_message(expression):
            picked = self._pick(region, way.number, expression)
            tests.append(f"({mail_name(way.number)} := {picked}) is not None")
        tests = [test for test in tests if test != "True"]
        if tests:
            method.add(depth, f"if {' and '.join(tests)}:")
            depth += 1
        taken = (*before, way.number)
        if self.chart.node(self.flat.transition(way.number).target).type is NodeType.CONDITION:
            if not way.branches:
                method.add(depth, "pass  # no way out of the choice")
            always = any(
                self._way(method, depth, region, source, leaf, complete, branch, taken)
                for branch in way.branches
            )
            return always and depth == outside
        self._take(method, depth, region, source, leaf, complete, taken)
        method.add(depth, "return True")
        return depth == outside

    def _there(self, region: int, source: str, event: Event) -> str:
        match event:
            case After(duration=duration):
                return f"now - self.{self._time(source)} >= {duration}"
            case Received() | Lost():
                return f"self.waiting_mail({self._letter(source, event)}) is not None"
            case Raised(name=name):
                return f"{name!r} in self.events and ({region}, {name!r}) not in self.spent"
            case Failed():
                return f"self.failed_inside({source!r})"

    def _letter(self, source: str, event: Received | Lost) -> str:
        branch = self.chart.branch_of(source)
        return f"{branch!r}, {', '.join(map(repr, _kind(event)))}"

    def _pick(self, region: int, number: int, expression: TransitionExpression) -> str:
        """A method that finds the agent message which a transition takes, if its condition depends on it."""
        if number not in self.guards:
            self.guards.add(number)
            pick = Method(self._names(region))
            pick.names.mail = "mail"
            self._asked_by(number, pick.names)
            branch = self.chart.branch_of(self.flat.transition(number).source)
            kinds = tuple(_kind(event) for event in expression.events if isinstance(event, Received | Lost))
            pick.add(2, f"for mail in self.letters({branch!r}, {kinds!r}):")
            if expression.condition is None:
                pick.add(3, "return mail")
            else:
                code, _ = holds(expression.condition, pick.names)
                depth = 4 if pick.names.may_raise else 3
                if pick.names.may_raise:
                    pick.add(3, "try:")
                pick.add(depth, f"if {code}:", "    return mail")
                if pick.names.may_raise:
                    pick.add(3, "except Exception as error:", f"    self.fault({number}, error)")
            pick.add(2, "return None")
            signature = f"_picks_{number}(self, b: Board{region}, now: int) -> Any"
            document = f"What is taken by {docstring(self._place(number))}."
            self._method(signature, document, pick)
        return f"self._picks_{number}(self.b{region}, now)"

    # ---- taking a transition ---------------------------------------------------------------

    def _take(
        self,
        method: Method,
        depth: int,
        region: int,
        source: str,
        leaf: Node | None,
        complete: str | bool,
        taken: tuple[int, ...],
    ) -> None:
        transitions = [self.flat.transition(number) for number in taken]
        method.add(depth, f"self.taken.append({taken!r})")
        plain = [t.expression for t in transitions if not taken_message(t.expression)]
        self._spend_events(method, depth, region, source, plain)
        for number, transition in zip(taken, transitions, strict=True):
            if taken_message(transition.expression):
                method.add(depth, f"self.take_letter({mail_name(number)})")
        scope = self.chart.scope_of(transitions[0])
        target = transitions[-1].target
        for transition in transitions[1:]:
            other = self.chart.scope_of(transition)
            scope = min(scope, other, key=len)
        place = self.flat.region_number[scope]
        if place == region:
            self._leave_leaf(method, depth, region, scope, leaf, complete is not False)
        else:
            around = next(
                node
                for node in self.chart.ancestors(source)
                if node.type is NodeType.AND and self.flat.region_number[node.label] == place
            )
            self._leave_leaf(method, depth, place, scope, around, False)
            method.add(depth, f"self.out = {place}")
        looked_at = self._actions(method, depth, region, source, taken, place)
        self._enter(method, depth, place, scope, target, resume=transitions[-1].resume)
        for channel, host in looked_at:
            self._consume(method, depth, region, channel, host, place)

    def _actions(
        self,
        method: Method,
        depth: int,
        region: int,
        source: str,
        taken: tuple[int, ...],
        place: int | None = None,
    ) -> list[tuple[str, str | None]]:
        """The actions of the segments in order; the signals that these and their conditions look at.

        They read what `region` knows; what they change they change in `place`, if that is another one.
        """
        transitions = [self.flat.transition(number) for number in taken]
        conditions = [t.expression.condition for t in transitions if t.expression.condition is not None]
        looked_at = dict.fromkeys(found for item in conditions for found in signals(walk(item)))
        still_seen = set(looked_at)  # until an action puts messages on the board
        for number, transition in zip(taken, transitions, strict=True):
            method.names.mail = mail_name(number)
            for action in transition.expression.actions:
                for channel, host in signals(_read_by(action)):
                    if (channel, host) not in still_seen:
                        method.add(depth, f"b.ask({channel!r}, {host!r})")
                        still_seen.add((channel, host))
                        looked_at[channel, host] = None
                self._action(
                    method, depth, region, number, source, action, region if place is None else place
                )
                if isinstance(action, ReadMessages):
                    still_seen.clear()
                elif isinstance(action, Publish):
                    still_seen = {seen for seen in still_seen if seen[0] != str(action.channel)}
        return list(looked_at)

    # ---- staying in a state ----------------------------------------------------------------

    def _on(self, method: Method, depth: int, region: int, number: int, complete: str | bool) -> None:
        """The tests of a transition that stays, around what it does.

        Without an event it is taken once for what it sees: again when something of that is news, or when its
        condition has not held in between.
        """
        transition = self.flat.transition(number)
        expression, source = transition.expression, transition.source
        if not expression.events and not expression.when and complete is False:
            return
        method.add(depth, f"# {self._place(number)}")
        if not expression.events and not expression.when and isinstance(complete, str):
            method.add(depth, f"if {complete}:")
            depth += 1
        there = [
            f"self.{self._past(number)} < {event.duration} <= now - self.{self._time(source)}"
            if isinstance(event, After)
            else self._there(region, source, event)
            for event in expression.events
        ]
        if there and not expression.when:
            method.add(depth, f"if {' or '.join(there)}:")
            depth += 1
        outside = depth
        asked = [] if expression.condition is None else signals(walk(expression.condition))
        for channel, host in asked:
            method.add(depth, f"b.ask({channel!r}, {host!r})")
        guard = "True"
        if taken_message(expression):
            guard = f"({mail_name(number)} := {self._pick(region, number, expression)}) is not None"
        elif expression.condition is not None:
            guard = self._guard(method, region, number, expression.condition)
        if guard != "True":
            method.add(depth, f"if {guard}:")
            depth += 1
        if self._has_mark(number):
            slots = self.slots[region]
            news = [*there, *(f"b.{slots[signal]} is not None" for signal in asked)]
            news.append(f"self.is_news(self.{self._mark(number)}, self._seen_{number}())")
            method.add(depth, f"if {' or '.join(news)}:")
            depth += 1
        method.add(depth, f"self.taken.append(({number},))")
        spent = [
            f"self.{self._past(number)} = {event.duration}"
            if isinstance(event, After)
            else self._spent(region, source, event)
            for event in expression.events
        ]
        if taken_message(expression):
            method.add(depth, f"self.take_letter({mail_name(number)})")
            spent = there = []
        for index, (test, action) in enumerate(zip(there, spent, strict=True)):
            if len(spent) == 1 and not expression.when:
                method.add(depth, action)
            else:
                method.add(depth, f"{'elif' if index else 'if'} {test}:", f"    {action}")
        for channel, host in self._actions(method, depth, region, source, (number,)):
            self._consume(method, depth, region, channel, host)
        if self._has_mark(number):
            method.add(depth, f"self.{self._mark(number)} = self._seen_{number}()")
        method.add(depth, "return True")
        if self._has_mark(number) and guard != "True":
            method.add(outside, "else:", f"    self.{self._mark(number)} = None")

    def _seen(self, number: int) -> None:
        """A method with what the condition of a transition reads: messages, and values."""
        transition = self.flat.transition(number)
        region = self.flat.region_number[transition.source]
        condition = transition.expression.condition
        messages: dict[str, None] = {}
        values: dict[str, None] = {}
        for value in walk(condition) if condition is not None else ():
            match value:
                case Member(channel=channel, host=host) if channel.comm is not Comm.SIGNAL:
                    messages.setdefault(f"b.{self.slots[region][str(channel), host]}")
                case VariableValue(name=name):
                    values.setdefault(f"self.{self._variable(name, region)}")
                case Expired(timer=timer):
                    values.setdefault(f"b.timers.get({timer!r})")
                case Outcome(activity=activity):
                    labels = self.flat.asked_of(transition.source, activity)
                    values.setdefault(f"self.last_outcome({labels!r})")
                case StateValue():
                    values.setdefault(self._about_states(transition.source, value))
        method = Method(self._names(region))
        parts = ["(" + "".join(f"{code}, " for code in found).strip() + ")" for found in (messages, values)]
        method.add(2, f"return {parts[0]}, {parts[1]}")
        place = docstring(self._place(number))
        self._method(f"_seen_{number}(self) -> Seen", f"What {place} reads.", method)

    def _exit(self, node: Node) -> None:
        """A method with what is done when a state is left."""
        region = self.flat.region_number[node.label]
        method = Method(self._names(region))
        for transition in self.chart.exits_of(node.label):
            number = self.flat.transition_number[id(transition)]
            method.add(2, f"# {self._place(number)}", f"self.taken.append(({number},))")
            for channel, host in self._actions(method, 2, region, node.label, (number,)):
                self._consume(method, 2, region, channel, host)
        if any(re.search(r"\bnow\b", line) for line in method.lines):
            method.lines.insert(0, "        now = self.now")
        name = f"_exit_{self._key(node.label)}(self) -> None"
        self._method(name, f"What is done when {node.label} {docstring(node.name)} is left.", method)

    def _left(self, node: Node) -> list[str]:
        """What is done when a state is left, after what is inside it."""
        lines = [f"self._exit_{self._key(node.label)}()"] if self.chart.exits_of(node.label) else []
        return [*lines, f"self.part({node.label!r})"] if self.chart.is_branch(node) else lines

    def _spend_events(
        self, method: Method, depth: int, region: int, source: str, segments: list[TransitionExpression]
    ) -> None:
        """Spend the first event of each segment that is there, one that several name once."""
        spending = [
            item for item in segments if any(isinstance(e, Received | Lost | Raised) for e in item.events)
        ]
        if not spending:
            return
        if len(spending) == 1:
            events = [
                (self._there(region, source, e), self._spent(region, source, e)) for e in spending[0].events
            ]
            if len(events) == 1 and not spending[0].when:
                method.add(depth, events[0][1])
                return
            for index, (test, action) in enumerate(events):
                method.add(depth, f"{'elif' if index else 'if'} {test}:", f"    {action}")
            return
        actions: dict[str, int] = {}  # what was there is seen before any of it is spent
        choices = []
        for item in spending:
            tests = [
                f"{actions.setdefault(self._spent(region, source, e), len(actions))} "
                f"if {self._there(region, source, e)} else "
                for e in item.events
            ]
            choices.append("".join(tests) + "-1")
        method.add(depth, f"for event in dict.fromkeys(({', '.join(choices)})):")
        for action, index in actions.items():
            method.add(depth + 1, f"{'elif' if index else 'if'} event == {index}:", f"    {action}")

    def _spent(self, region: int, source: str, event: Event) -> str:
        """What spends an event; time and failures are not spent."""
        match event:
            case Received() | Lost():
                return f"self.take_mail({self._letter(source, event)})"
            case Raised(name=name):
                around = [n for n in self.flat.regions_around(region) if name in self.flat.awaited.get(n, ())]
                if not around:
                    return f"self.spent.add(({region}, {name!r}))"
                gone = ", ".join(f"({number}, {name!r})" for number in (region, *around))
                return f"self.spent.update(({gone}))"
        return "pass"

    def _consume(
        self,
        method: Method,
        depth: int,
        region: int,
        channel: str,
        host: str | None,
        place: int | None = None,
    ) -> None:
        """Consume the signal that was looked at, for the region and for those around it.

        Those inside `place` have been left.
        """
        regions = list(self.flat.regions_around(region))
        if place is not None and place != region:
            regions = regions[regions.index(place) :]
        around = [n for n in regions if channel in self.flat.asked_signals.get(n, ())]
        outer = "".join(f", self.b{number}" for number in around)
        method.add(depth, f"b.spend({channel!r}, {host!r}{outer})")

    def _leave_leaf(
        self, method: Method, depth: int, region: int, scope: str, leaf: Node | None, complete: bool
    ) -> None:
        for node in self.flat.resumed:
            if self.flat.region_number[node.label] != region or not node.label.startswith(scope + "."):
                continue
            first, last = self.flat.range[node.label]
            if leaf is None:
                method.add(depth, f"if {first} <= self.r{region} <= {last}:")
                method.add(depth + 1, f"self._keep_{self._key(node.label)}()")
            elif leaf.label.startswith(f"{node.label}."):
                method.add(depth, f"self._keep_{self._key(node.label)}()")
        if leaf is None:
            method.add(depth, f"self._leave_leaf_{region}()")
            for node in reversed(self.flat.leaving):
                if self.flat.region_number[node.label] == region and node.label.startswith(scope + "."):
                    first, last = self.flat.range[node.label]
                    method.add(depth, f"if {first} <= self.r{region} <= {last}:")
                    method.add(depth + 1, *self._left(node))
            return
        if leaf.type is NodeType.BASIC and not complete:
            method.add(depth, f"self.cancel({leaf.label!r}, {leaf.activity!r}, self.k{region})")
        elif leaf.type is NodeType.AND:
            for inner in self.flat.regions_of(leaf.label):
                method.add(depth, f"self._leave_{inner.number}()")
        if leaf.type in (NodeType.BASIC, NodeType.AND):
            method.add(depth, *self._left(leaf))
        for around in self.flat.around(leaf.label):
            if len(around.label) > len(scope):
                method.add(depth, *self._left(around))

    def _leave(self, region: int) -> None:
        """Methods that leave whatever is active in a region."""
        running = [n for n in self.flat.leaves(region) if n.type is NodeType.BASIC]
        ands = [n for n in self.flat.leaves(region) if n.type is NodeType.AND]
        left = [n for n in running if self._left(n)]
        method = Method(self._names(region))
        if running or ands:
            method.add(2, f"r = self.r{region}")
        if running:
            method.add(2, f"running = _RUNNING_{region}.get(r)")
            method.add(2, "if running is not None:", f"    self.cancel(*running, self.k{region})")
            table = {self.flat.leaf[n.label]: (n.label, n.activity) for n in running}
            self.tables += ["", f"_RUNNING_{region}: dict[int, tuple[str, str]] = {table!r}"]
        for node in left:
            first = self.flat.leaf[node.label]
            method.add(2, f"if {first} <= r <= {first + 1}:", *(f"    {line}" for line in self._left(node)))
        for node in ands:
            method.add(2, f"if r == {self.flat.leaf[node.label]}:")
            for inner in self.flat.regions_of(node.label):
                method.add(3, f"self._leave_{inner.number}()")
            method.add(3, *self._left(node))
        if not method.lines:
            method.add(2, "return")
        label = self.flat.regions[region].label
        self._method(
            f"_leave_leaf_{region}(self) -> None", f"Leave the active leaf of region {label}.", method
        )
        whole = Method(self._names(region))
        for node in self.flat.resumed:
            if self.flat.region_number[node.label] == region:
                first, last = self.flat.range[node.label]
                whole.add(2, f"if {first} <= self.r{region} <= {last}:")
                whole.add(3, f"self._keep_{self._key(node.label)}()")
        whole.add(2, f"self._leave_leaf_{region}()")
        for node in reversed(self.flat.leaving):
            if self.flat.region_number[node.label] == region:
                first, last = self.flat.range[node.label]
                whole.add(2, f"if {first} <= self.r{region} <= {last}:")
                whole.add(3, *self._left(node))
        whole.add(2, f"self.r{region} = INACTIVE")
        self._method(f"_leave_{region}(self) -> None", f"Leave region {label}.", whole)

    # ---- entering --------------------------------------------------------------------------

    def _enter(
        self,
        method: Method,
        depth: int,
        region: int,
        scope: str,
        target: str,
        *,
        resume: bool = False,
        again: bool = False,
        complete: bool = False,
    ) -> None:
        """Enter a state inside `scope`, outermost first.

        With `resume` a composite goes on; `again` and `complete` are for what is inside it: an AND whose
        regions go on, too, and a BASIC state whose activity has returned.
        """
        path = [target]
        while (parent := self.chart.node(path[-1]).parent) not in (scope, None):
            assert parent is not None
            path.append(parent)
        for label in reversed(path):
            if self.chart.is_region(label):
                self._enter_one(method, depth, region, label, target, resume)
                return
            self._on_entry(method, depth, region, self.chart.node(label))
        node = self.chart.node(target)
        number = self.flat.leaf.get(target)
        match node.type:
            case NodeType.BASIC if complete:
                method.add(depth, f"self.r{region} = {number} + 1")
            case NodeType.BASIC:
                method.add(depth, f"self.r{region} = {number}")
                if target in self.flat.ending:
                    method.add(depth, f"self.await_outcome({target!r})")
                method.add(depth, f"self.k{region} = {self._begin(node)}")
            case NodeType.AND:
                method.add(depth, f"self.r{region} = {number}")
                for inner in self.flat.regions_of(target):
                    call = f"_again_{inner.number}(now, kept)" if again else f"_enter_{inner.number}(now)"
                    method.add(depth, f"self.{call}")
            case NodeType.OR if resume:
                method.add(depth, f"if self.{self._kept(node)} is None:")
                self._activate_start(method, depth + 1, region, target)
                method.add(depth, "else:", f"    self._resume_{self._key(target)}(now)")
            case NodeType.OR:
                self._activate_start(method, depth, region, target)
            case NodeType.START | NodeType.END | NodeType.CONDITION:
                method.add(depth, f"self.r{region} = {number}")
            case _:
                assert_never(node.type)

    def _enter_one(
        self, method: Method, depth: int, region: int, entered: str, target: str, resume: bool
    ) -> None:
        """Enter an AND, in one of its regions (`entered`) the target instead of its START."""
        around = self.chart.node(entered).parent
        assert around is not None
        method.add(depth, f"self.r{region} = {self.flat.leaf[around]}")
        for inner in self.flat.regions_of(around):
            if inner.label == entered:
                begin = Method(self._names(inner.number))
                self._begin_region(begin, inner.number)
                method.add(depth - 2, *begin.lines)
                self._enter(method, depth, inner.number, entered, target, resume=resume)
            else:
                method.add(depth, f"self._enter_{inner.number}(now)")

    def _begin(self, node: Node) -> str:
        """The call that starts the activity of a state; with arguments in a method of its own."""
        if not node.arguments:
            return f"self.begin({node.label!r}, {node.activity!r})"
        name = f"_begin_{self._key(node.label)}"
        if not any(method[0].startswith(f"    def {name}(") for method in self.methods):
            self._begin_given(name, node)
        return f"self.{name}(now)"

    def _begin_given(self, name: str, node: Node) -> None:
        """Compute what an activity is given; where that cannot be, the state has failed."""
        region = self.flat.region_number[node.label]
        method = Method(self._names(region))
        self._asked_at(node.label, method.names)
        said = self.flat.said_of(node)
        types = {item.name: item.type for item in said.parameters} if said is not None else {}
        for number, argument in enumerate(node.arguments):
            method.names.may_raise = False
            piece = evaluate(argument.value, method.names)
            what = f"the argument `{argument.name}`"
            depth = 2
            if method.names.may_raise:
                method.add(depth, "try:")
                depth += 1
            if piece.needs:
                method.add(depth, f"if not ({' and '.join(piece.needs)}):")
                method.add(depth + 1, f"return self.not_given({node.label!r}, {f'{what} is absent'!r})")
            kind = types.get(argument.name, argument.value.type)
            method.add(depth, f"given_{number} = {converted(piece, argument.value.type, kind)}")
            if method.names.may_raise:
                method.add(2, "except Exception as error:")
                method.add(3, f"return self.not_given({node.label!r}, {what!r}, error)")
        given = "".join(f"({item.name!r}, given_{n}), " for n, item in enumerate(node.arguments)).rstrip()
        method.add(2, f"return self.begin({node.label!r}, {node.activity!r}, ({given}))")
        document = f"Start {docstring(node.name)}, the activity of {node.label}."
        self._method(f"{name}(self, now: int) -> int", document, method)

    def _on_entry(self, method: Method, depth: int, region: int, node: Node) -> None:
        if self.chart.is_branch(node):
            method.add(depth, f"self.join({node.label!r})")
        for variable in self.chart.variables:
            if variable.scope == node.label:
                if len(self.flat.variable_regions[variable.name]) > 1:
                    method.add(depth, f"self.renew({variable.name!r})")
                self._write(method, depth, region, variable.name, self._initial(variable))
        if node.label in self.flat.timed:
            method.add(depth, f"self.{self._time(node.label)} = now")
        for number in self.flat.staying.get(node.label, ()):
            if self._has_mark(number):
                method.add(depth, f"self.{self._mark(number)} = None")
            if self._has_time(number):
                method.add(depth, f"self.{self._past(number)} = -1")
        for label, loop in self.flat.counted.items():
            if loop == node.label:
                method.add(depth, f"self.{self._count(label)} = 0")
        if node.label in self.flat.counted:
            method.add(depth, f"self.{self._count(node.label)} += 1")
        if self.chart.is_branch(node):
            for inner in self.flat.resumed:
                if inner.label.startswith(f"{node.label}."):
                    method.add(depth, f"self.{self._kept(inner)} = None")

    # ---- going on --------------------------------------------------------------------------

    def _keep(self, node: Node) -> None:
        """A method that remembers where a composite is left, before it is; nothing if it is complete."""
        region = self.flat.region_number[node.label]
        method = Method(self._names(region))
        inside = [region, *(inner.number for inner in self.flat.regions_inside(node.label))]
        kept = ", ".join(f"{number}: self.r{number}" for number in inside)
        end = self.chart.end_of(node.label)
        value = f"{{{kept}}}"
        if end is not None:
            value = f"None if self.r{region} == {self.flat.leaf[end.label]} else {value}"
        method.add(2, f"self.{self._kept(node)} = {value}")
        name = f"_keep_{self._key(node.label)}(self) -> None"
        self._method(name, f"Remember where {node.label} {docstring(node.name)} is left.", method)

    def _resume(self, node: Node) -> None:
        """A method by which a composite that has been entered goes on with what is remembered."""
        region = self.flat.region_number[node.label]
        method = Method(self._names(region))
        method.add(2, f"kept = self.{self._kept(node)} or {{}}", f"self.{self._kept(node)} = None")
        method.add(2, f"n = kept.get({region}, INACTIVE)")
        if self.chart.is_branch(node):
            self._activate_start(method, 2, region, node.label)
        else:
            self._where_it_was(method, region, node.label)
        name = f"_resume_{self._key(node.label)}(self, now: int) -> None"
        self._method(name, f"Go on in {node.label} {docstring(node.name)}.", method)

    def _again(self, region: int) -> None:
        """A method that enters a region in which a composite around it goes on."""
        label = self.flat.regions[region].label
        method = Method(self._names(region))
        self._begin_region(method, region)
        method.add(2, f"n = kept.get({region}, INACTIVE)")
        self._where_it_was(method, region, label)
        signature = f"_again_{region}(self, now: int, kept: dict[int, int]) -> None"
        self._method(signature, f"Enter region {label} where it was left.", method)

    def _where_it_was(self, method: Method, region: int, label: str) -> None:
        """Enter the leaf `n` inside the state `label`, or its START; the inside of a branch begins anew."""
        branches: set[str] = set()
        branched = False
        for leaf in self.flat.leaves(region):
            if not leaf.label.startswith(f"{label}."):
                continue
            inner = next(
                (
                    around.label
                    for around in reversed(self.flat.around(leaf.label))
                    if around.label.startswith(f"{label}.") and self.chart.is_branch(around)
                ),
                None,
            )
            if inner is not None and inner in branches:
                continue
            number = self.flat.leaf[leaf.label]
            word = "elif" if branched else "if"
            branched = True
            if inner is not None:
                branches.add(inner)
                first, last = self.flat.range[inner]
                method.add(2, f"{word} {first} <= n <= {last}:")
                self._enter(method, 3, region, label, inner)
                continue
            method.add(2, f"{word} n == {number}:")
            self._enter(method, 3, region, label, leaf.label, again=True)
            if leaf.type is NodeType.BASIC:
                method.add(2, f"elif n == {number + 1}:")
                self._enter(method, 3, region, label, leaf.label, complete=True)
        method.add(2, "else:")
        self._activate_start(method, 3, region, label)

    def _activate_start(self, method: Method, depth: int, region: int, label: str) -> None:
        start = self.chart.start_of(label)
        assert start is not None
        method.add(depth, f"self.r{region} = {self.flat.leaf[start.label]}")
        if start.label in self.flat.timed:
            method.add(depth, f"self.{self._time(start.label)} = now")

    def _enter_region(self, region: int) -> None:
        label = self.flat.regions[region].label
        method = Method(self._names(region))
        self._begin_region(method, region)
        self._activate_start(method, 2, region, label)
        self._method(f"_enter_{region}(self, now: int) -> None", f"Enter region {label}.", method)

    def _begin_region(self, method: Method, region: int) -> None:
        """The blackboard of a region that is entered, and its copies of variables."""
        outer = self.flat.enclosing(region)
        method.add(2, f"self.b{region} = Board{region}()", f"self.b{region}.inherit(self.b{outer})")
        if region in self.flat.awaited:
            method.add(2, "if self.events:", f"    self.miss({region})")
        for name, regions in self.flat.variable_regions.items():
            if len(regions) > 1 and region in regions:
                around = outer
                while around is not None and around not in regions:
                    around = self.flat.enclosing(around)
                if around is not None:
                    method.add(
                        2, f"self.{self._variable(name, region)} = self.{self._variable(name, around)}"
                    )
        self._on_entry(method, 2, region, self.chart.node(self.flat.regions[region].label))

    def _enter_root(self) -> None:
        method = Method(self._names(0))
        root = self.chart.root
        self._on_entry(method, 2, 0, root)
        self._activate_start(method, 2, 0, root.label)
        if any(re.search(r"\bnow\b", line) for line in method.lines):
            method.lines.insert(0, "        now = self.now")
        self._method("enter(self) -> None", "Enter the root.", method)

    def _write(
        self, method: Method, depth: int, region: int, name: str, code: str, place: int | None = None
    ) -> None:
        """Write a variable in a region, and in `place`, if that is where it counts."""
        place = region if place is None else place
        attribute = self._variable(name, place)
        copies = dict.fromkeys((attribute, self._variable(name, region)))
        method.add(depth, "".join(f"self.{copy} = " for copy in copies) + code)
        if len(self.flat.variable_regions[name]) > 1:
            method.add(depth, f"self.writes.append(({place}, {name!r}, self.{attribute}))")

    # ---- actions ---------------------------------------------------------------------------

    def _action(
        self,
        method: Method,
        depth: int,
        region: int,
        number: int,
        source: str,
        action: Action,
        place: int,
    ) -> None:
        board = "b" if place == region else f"self.b{place}"
        match action:
            case ReadMessages():
                method.add(depth, f"self.read_messages({place}, {board})")
            case Publish(channel=channel):
                drafts = "" if place == region else ", b"
                method.add(depth, f"self.publish({place}, {board}, {str(channel)!r}{drafts})")
            case Send(performative=performative, message=message, participant=participant):
                branch = self.chart.branch_of(source)
                letter = f"{branch!r}, {performative!r}, {message!r}, {participant!r}"
                self._computed(method, depth, number, action.values, lambda *p: [_sending(letter, action, p)])
            case StartTimer(timer=timer, duration=duration):
                self._computed(
                    method,
                    depth,
                    number,
                    (duration,),
                    lambda piece: [f"{board}.timers[{timer!r}] = now + {piece.code}"],
                )
            case Assign(target=target, value=value):
                self._computed(
                    method,
                    depth,
                    number,
                    (value,),
                    lambda piece: self._assignment(region, target, value, piece, place),
                )
            case Evaluate(value=value):
                self._computed(method, depth, number, (value,), lambda piece: [piece.code])

    def _assignment(
        self, region: int, target: VariableValue | Member, value: Value, piece: Piece, place: int
    ) -> list[str]:
        code = converted(piece, value.type, target.type)
        if isinstance(target, Member):
            return [f"b.fill({str(target.channel)!r}, {target.host!r}, {target.path!r}, {code})"]
        lines = Method(self._names(region))
        self._write(lines, 0, region, target.name, code, place)
        return lines.lines

    # ---- the rest --------------------------------------------------------------------------

    def _frame(self) -> None:
        regions = self.flat.regions
        plain = Method(self._names(0))
        plain.add(2, "return self._region_0(self.now)")
        self._method("round(self) -> bool", "One round over all regions.", plain)
        leave = Method(self._names(0))
        leave.add(2, "self._leave_0()")
        self._method("leave(self) -> None", "Leave everything.", leave)
        end = self.chart.end_of(self.chart.root.label)
        finished = Method(self._names(0))
        finished.add(2, f"return self.r0 == {self.flat.leaf[end.label]}" if end else "return False")
        self._method("is_finished(self) -> bool", "Whether the root's END is active.", finished)
        boards = Method(self._names(0))
        parts = ["self.b0"]
        parts += [f"self.b{r.number} if self.r{r.number} >= 0 else None" for r in regions[1:]]
        boards.add(2, f"return ({', '.join(parts)},)")
        self._method("boards(self) -> tuple[Board | None, ...]", "The blackboard of each region.", boards)
        self._due()
        self._configuration()

    def _leaf_labels(self) -> list[tuple[str, ...]]:
        """The labels of each region's leaves by their numbers."""
        return [
            tuple(
                label
                for node in self.flat.leaves(region.number)
                for label in [node.label] * (2 if node.type is NodeType.BASIC else 1)
            )
            for region in self.flat.regions
        ]

    def _configuration(self) -> None:
        method = Method(self._names(0))
        numbers = ", ".join(f"self.r{region.number}" for region in self.flat.regions)
        method.add(
            2,
            f"numbers = ({numbers},)",
            "return tuple(labels[n] for labels, n in zip(self.LEAVES, numbers, strict=True) if n >= 0)",
        )
        self._method("configuration(self) -> tuple[str, ...]", "The labels of the active leaves.", method)

    def _due(self) -> None:
        method = Method(self._names(0))
        if not self.flat.waits:
            method.add(2, "return None")
        else:
            method.add(2, "best = NEVER")
            for wait in self.flat.waits:
                self._wait(method, wait)
            method.add(2, "return None if best == NEVER else best")
        self._method(
            "due(self, now: int) -> int | None", "The next moment at which time alone may matter.", method
        )

    def _wait(self, method: Method, wait: Wait) -> None:
        region = self.flat.region_number[wait.source]
        if wait.source in self.flat.leaf:
            number = self.flat.leaf[wait.source]
            has_two = self.chart.node(wait.source).type is NodeType.BASIC and wait.kind != "within"
            first, last = number, number + 1 if has_two else number
        else:
            first, last = self.flat.range[wait.source]
        where = f"self.r{region} == {first}" if first == last else f"{first} <= self.r{region} <= {last}"
        method.add(2, f"if {where}:")
        depth = 3
        board = f"self.b{region}"
        match wait.kind:
            case "after" | "within":
                method.add(depth, f"at = self.{self._time(wait.source)} + {wait.amount}")
            case "timer":
                method.add(depth, f"at = {board}.timers.get({wait.name!r}, NEVER)")
            case _:
                assert wait.member is not None
                slot = self.slots[region][str(wait.member.channel), wait.member.host]
                method.add(depth, f"if {board}.{slot} is not None:")
                depth += 1
                method.add(depth, f"at = {board}.{slot}_time + {wait.amount}")
        method.add(depth, "if now < at < best:", "    best = at")


def _kind(event: Received | Lost) -> tuple[str, str, str]:
    """What mail an event waits for: performative, message and participant."""
    if isinstance(event, Lost):
        return LOST, "", event.participant
    return event.performative, event.message, event.participant


def _sending(letter: str, action: Send, pieces: Sequence[Piece]) -> str:
    """The call that sends an agent message, with what its values have come to."""
    fills = action.fills
    count = len(fills or ())
    arguments = [letter]
    if fills is not None:
        given = zip(fills, pieces, strict=False)
        members = [f"{i.path!r}: {converted(p, i.value.type, i.type)}" for i, p in given]
        arguments.append(f"{{{', '.join(members)}}}")
    if action.to is not None:
        arguments.append(f"to={pieces[count].code}")
        count += 1
    if action.excepts:
        arguments.append(f"excepts=({', '.join(piece.code for piece in pieces[count:])},)")
    return f"self.send({', '.join(arguments)})"


def _read_by(action: Action) -> Iterable[Value]:
    return values_of(TransitionExpression(actions=(action,)))


def retention(system: System, chart: Statechart, flat: FlatChart | None = None) -> dict[str, int]:
    """How long each data channel must be kept, in ns: the longest history that anything asks for."""
    found = dict((flat or FlatChart(chart)).retention)
    used = {node.activity for node in chart.nodes if node.activity}
    activities = [item for item in system.activities if item.name in used]
    for activity in (*activities, *(module.statement for module in chart.modules)):
        for subscription in activity.reads:
            if subscription.channel is not None and subscription.channel.comm is Comm.DATA:
                channel = str(subscription.channel)
                found[channel] = max(found.get(channel, 0), subscription.history)
    return {channel: found[channel] for channel in sorted(found)}


__all__ = ["StepCode", "generate_step", "retention"]
