"""A statechart to the class that a program without agents runs: one number a region, everything in line.

The semantics is that of the agent's class (`step.py`); what is left away is what such a program does not use:
boards, effects, traces. What the compiler knows becomes code that is not there: an event has a body of its
own, a START that is always left has no number, and a second round is only looked for where one could be.

A region of two states has a truth instead of a number, which is asked for and written faster.

What region 3 writes it sees at once, others see it in the next step. A variable has one place, the
blackboard, where no other region can look at it or write it afterwards in the same step; otherwise each
region that uses it has a copy (`v3_x`) during the step.
"""

from __future__ import annotations

import builtins
import re
from bisect import bisect_right
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

from aseme_dsl.amola.expression import (
    NEVER,
    Action,
    After,
    Assign,
    Call,
    Evaluate,
    Event,
    Expired,
    Failed,
    Outcome,
    Raised,
    Random,
    StartTimer,
    TransitionExpression,
    Value,
    VariableValue,
    values_of,
    walk,
)
from aseme_dsl.amola.messages import Kind, Type
from aseme_dsl.amola.statechart import Node, NodeType, Statechart, TransitionKind
from aseme_dsl.amola.system import System
from aseme_dsl.codegen.expressions import (
    LOCAL,
    Names,
    Piece,
    converted,
    evaluate,
    function_key,
    may_fail,
)
from aseme_dsl.codegen.face import Face, Identifiers, Method, docstring, natural
from aseme_dsl.codegen.flat import FlatChart, Way
from aseme_dsl.codegen.resting import is_open, resting

TABLE = 64
"""Regions with more numbers than this dispatch through a tuple of functions, others through comparisons."""

CHUNK = 64
"""So many numbers have a function together: a power of two."""

IN_LINE = 400
"""An event whose body has more lines than this has a method of its own."""

SHARED = 400
"""With more tests that need no event than this, for all events together, events share methods for them."""

BRANCHES = 8
"""More events than this are found in a table, fewer by comparisons."""

GUARDS = 8
"""So many conditions in a row are not looked at again before the blackboard has changed, if it is tracked.

With fewer, asking for that costs those who do not track theirs more than it saves those who do.
"""

LEGEND = 16
"""So many states are named where the class says what its slots mean."""

NESTED = 6
"""Regions in so many others, and in twice as many, have methods of their own."""

DEEP = 24
"""Code that is indented further moves into a method (CPython refuses more than 100 levels)."""

_BB = f"{LOCAL}bb"
_NOW = f"{LOCAL}now"
"""The locals that a method has if its lines use them."""

TAKEN = frozenset(dir(builtins)) | {
    *(
        "ABSENT",
        "NEVER",
        "ROUNDS",
        "SHOWN",
        "ActivityFailed",
        "Any",
        "Callable",
        "ClassVar",
        "Iterable",
        "Mapping",
        "Plain",
        "Random",
        "UNSTARTED",
    ),
    *(
        "NotStarted",
        "Unsettled",
        "annotations",
        "cache",
        "function_at",
        "leaves_of",
        "logging",
        "names_of",
        "Sequence",
        "unknown_event",
    ),
}
"""What other names mean in a module, also in one of machine code, which has the class `Plain` in it."""

STEP = ""
"""The mode of a step without an event."""

OTHER = "*"
"""The mode of a step with an event that no transition waits for."""


@dataclass(frozen=True, slots=True)
class PlainOptions:
    """How the class is to be.

    `mapping`: the blackboard is a dictionary instead of a class with slots. `watched`: each activity has a
    method that is called as it starts, and one that is called when it is cut short, and `took` is told of
    each transition. `tables`: regions with many leaves find what is to do in a tuple of functions. `gates`:
    many conditions in a row are skipped while a tracked blackboard has not changed. `translated`: the steps
    are for `batch.py`, which has a `done` of its own, and nothing is called there that may raise.
    """

    mapping: bool = False
    watched: bool = False
    tables: bool = True
    gates: bool = True
    translated: bool = False


@dataclass(frozen=True, slots=True)
class PlainCode:
    """The parts of a module: what it imports, and its lines."""

    class_name: str
    board_name: str
    messages: tuple[str, ...]
    """What it imports of these, `Any as Any_` where a name is taken."""
    constants: tuple[tuple[str, str], ...]
    """Module-level names of enum constants with the expression they stand for."""
    numbers: tuple[tuple[str, int], ...]
    """The same names with the numbers of these constants."""
    functions: tuple[tuple[str, tuple[str, str, str]], ...]
    """Module-level names of functions, each with the target, the name in errors and the declared result."""
    board: tuple[str, ...]
    body: tuple[str, ...]
    tables: tuple[str, ...]

    def uses(self, name: str) -> bool:
        """Whether the module's lines mention a name."""
        return _mentioned(name, (*self.board, *self.body, *self.tables))

    def needs(self, name: str) -> bool:
        """Whether a constant or the parameter of a method is of that type, not only the blackboard has it."""
        constants = (value for _, value in self.constants)
        methods = (line for line in self.body if line.startswith("    def "))
        return _mentioned(name, (*constants, *methods))


_NO_CODE = re.compile(r"""'(?:[^'\\]|\\.)*'|"(?:[^"\\]|\\.)*"|#.*""")
"""A text or a comment on a line."""


def _mentioned(name: str, lines: Iterable[str]) -> bool:
    """Whether the code on some line has a name that is no member of something."""
    pattern = re.compile(rf"(?<![\w.]){name}\b")
    return any(name in line and pattern.search(_NO_CODE.sub("", line)) for line in lines)


def generate_plain(
    system: System,
    chart: Statechart,
    class_name: str,
    options: PlainOptions | None = None,
    board_name: str = "",
) -> PlainCode:
    """The class of a role's statechart; it must be one of which nothing is refused (`plain_limits.py`).

    That of its blackboard is called `board_name`, or as it is with `Blackboard` behind.
    """
    board = board_name or f"{class_name}Blackboard"
    return _Generator(system, chart, class_name, options or PlainOptions(), board).generate()


@dataclass(frozen=True, slots=True)
class _Candidate:
    """A compound transition with what must hold for it, besides that its source is active."""

    source: str
    tests: tuple[str, ...]
    taken: tuple[int, ...]
    spends: str
    """"" if it spends no event, "yes", or the condition under which it does not."""
    stays: bool = False
    """Whether its source is not left."""
    leads_on: bool = True
    """Whether it can be taken: a choice may have no way out, but what may fail before it is to be told."""


@dataclass(slots=True)
class _Mode:
    """What a step is made for: an event, or none. It `loops` if one round may not be enough."""

    event: str
    loops: bool = False
    flags: tuple[str, ...] = ("moved",)
    """The locals that are set when something moves."""
    direct: bool = False
    """Whether a transition that is taken ends the method."""
    again: bool = False
    """Whether a transition was written after which another round is needed."""
    inside: int = 0
    """How many locals tell whether something inside an AND has moved."""
    functions: dict[str, list[str]] = field(default_factory=dict)
    """Methods that the body calls, by their names."""
    tables: dict[str, list[str]] = field(default_factory=dict)
    apart: dict[int, str] = field(default_factory=dict)
    """The methods of regions that have one, by the region; "" for those with nothing to do."""


@dataclass(frozen=True, slots=True)
class _Use:
    """A variable is read or written in a region."""

    variable: str
    region: int
    writes: bool = False


@dataclass(frozen=True, slots=True)
class _Body:
    """What a round does while a region has one of these numbers."""

    first: int
    last: int
    title: str
    lines: tuple[str, ...]
    is_and: bool = False


@dataclass(slots=True)
class _Untouched:
    """What is done in a region, leaf by leaf, with an event that nothing there waits for.

    It is the same for all such events. In `all` of them, those of a leaf begin at `first`, and such as do
    the same as their neighbours at `starts`.
    """

    pieces: list[list[_Body] | None] = field(default_factory=list)
    all: list[_Body] = field(default_factory=list)
    first: list[int] = field(default_factory=list)
    starts: list[int] = field(default_factory=list)

    def join(self) -> None:
        """Find the neighbours that do the same."""
        for of in self.pieces:
            self.first.append(len(self.all))
            self.all += of or ()
        self.first.append(len(self.all))
        same = (n for n in range(1, len(self.all)) if self.all[n].lines != self.all[n - 1].lines)
        self.starts = [0, *same, len(self.all)]

    def between(self, begin: int, end: int) -> Iterator[_Body]:
        """The bodies from one leaf to before another."""
        place, last = self.first[begin], self.first[end]
        run = bisect_right(self.starts, place)
        while place < last:
            until = min(self.starts[run], last)
            yield _joined(self.all[place], self.all[until - 1]) if until - place > 1 else self.all[place]
            place, run = until, run + 1


class _Generator(Face):
    def __init__(
        self, system: System, chart: Statechart, class_name: str, options: PlainOptions, board_name: str
    ) -> None:
        self.rests = resting(chart, watched=options.watched)
        taken = {*TAKEN, class_name, f"Watched{class_name}", board_name}
        super().__init__(system, chart, FlatChart(chart, system.activities, self.rests.width), taken)
        self.truths = frozenset(
            region.number
            for region in self.flat.regions
            if region.size == 2 and len(self.flat.leaves(region.number)) == 2
        )
        """The regions with two leaves, of which neither has two numbers."""
        self.class_name = class_name
        self.board_name = board_name
        self.options = options
        self.board_names = Identifiers()
        # The blackboard of the watched class is that of the other one, which may have these.
        for name in ("tracked", "changed") if options.gates or options.watched else ():
            self.board_names.name(("reserved", name), name)
        for name in self.variables:
            self._on_board(name)
        self.function_names = Identifiers()
        for name in ("_EVENTS", "_PLACES"):
            self.function_names.name(("reserved", name), name)
        self.functions: dict[str, tuple[str, str, str]] = {}
        self.event_methods: dict[str, str] = {}
        self.leaving: dict[str, bool] = {}
        """Which methods that leave a region there are; False for those with nothing to do."""
        self.spends = False
        self.gated: set[tuple[str, frozenset[str], tuple[str, ...]]] = set()
        self.gates: dict[str, frozenset[str]] = {}
        """What says of many conditions that they still do not hold, with what on the blackboard they read."""
        self.place = {
            leaf.label: place
            for region in self.flat.regions
            for place, leaf in enumerate(self.flat.leaves(region.number))
        }
        """Where a leaf stands among those of its region."""
        self.modes = self._modes()
        self.timers = self._timers()
        self.uses = self._all_uses()
        self.touched = self._touched()
        self.untouched: dict[tuple[int, bool, bool, tuple[str, ...]], _Untouched] = {}
        self.looping: frozenset[str] | None = None
        """The leaves at which a step with an event that they do not wait for may need another round."""
        self.others: _Mode | None = None
        """What is done with an event that nothing waits for, where all events share that."""
        self.others_done: dict[int, tuple[list[int], list[int]]] = {}
        """The first and last numbers in a region for which there is anything in these methods."""
        self.times = frozenset(map(self._entered_now, self.flat.timed))
        self.is_timed = bool(self.flat.timed or self.timers)
        self.may_fail = options.watched or any(
            isinstance(event, Failed) for item in chart.transitions for event in item.expression.events
        )
        self.asked = tuple(
            dict.fromkeys(
                self.flat.asked_of(source, value.activity)
                for source, value in chart.values()
                if isinstance(value, Outcome)
            )
        )
        """The groups of states of which somebody asks how the last that was active has ended."""
        self.has_chance = any(isinstance(value, Random) for _, value in chart.values())
        self.faults = any(may_fail(value) for _, value in chart.values())
        self.copied = self._copied()
        """The variables of which some regions need a copy during the step, with these regions."""
        self.seen = {key: self._place_on_board(slot) for key, (slot, _) in self._message_slots().items()}
        self.names = {region.number: self._names_of(region.number) for region in self.flat.regions}

    # ---- names -----------------------------------------------------------------------------

    def _modes(self) -> tuple[str, ...]:
        """The events, those first that most transitions wait for: they are asked about first."""
        names = Counter(
            event.name
            for transition in self.chart.transitions
            for event in transition.expression.events
            if isinstance(event, Raised)
        )
        return (*(name for name, _ in names.most_common()), STEP)

    def _on_board(self, name: str) -> str:
        """What a variable is called on the blackboard: as in the document, if that is free."""
        return self.board_names.name(("variable", name), name)

    def _renamed(self) -> dict[str, str]:
        """The variables that are called otherwise on the blackboard."""
        return {name: own for name in self.variables if (own := self._on_board(name)) != name}

    def _place_on_board(self, name: str) -> str:
        return f"{_BB}[{name!r}]" if self.options.mapping else f"{_BB}.{name}"

    def _message_slots(self) -> dict[tuple[str, str | None], tuple[str, str]]:
        """The places of the messages that conditions read, by channel and host, with their types."""
        found: dict[tuple[str, str | None], tuple[str, str]] = {}
        for members in self.flat.members.values():
            for member in members:
                key = str(member.channel), member.host
                wish = f"{member.host}_{key[0]}" if member.host else key[0]
                found[key] = self.board_names.name(key, wish), member.channel.message
        return found

    def _copy(self, name: str, region: int) -> str:
        return self.identifiers.name(("variable", name, region), f"v{region}_{name}")

    def _names_of(self, region: int) -> dict[str, str]:
        return {
            name: f"self.{self._copy(name, region)}"
            if region in self.copied.get(name, ())
            else self._place_on_board(self._on_board(name))
            for name in self.variables
        }

    def _names(self, region: int, prefix: str = "") -> Names:
        variables = self.names[region]
        names = Names(self.seen, variables, self.fields, self.constants, self.enums, prefix=prefix)
        names.called = self._called_by
        names.now = _NOW
        names.timer = lambda timer: f"self.{self._timer(region, timer)}"
        names.last_outcome = lambda labels: f"self.{self._outcome(labels)}"
        return names

    def _time(self, label: str) -> str:
        """When a state was entered; states of which one is active at most have one place for that."""
        region = self.flat.region_number[label]
        deep = sum(around.label in self.flat.timed for around in self.flat.around(label))
        if label != self.flat.regions[region].label and self.flat.regions[region].label in self.flat.timed:
            deep += 1
        return self.identifiers.name(("time", region, deep), f"t{region}_{deep}")

    def _timer(self, region: int, timer: str) -> str:
        return self.identifiers.name(("timer", region, timer), f"timer{region}_{timer}")

    def _outcome(self, labels: tuple[str, ...]) -> str:
        number = self.asked.index(labels)
        return self.identifiers.name(
            ("outcome", labels), f"outcome{number}_{self.chart.node(labels[0]).name}"
        )

    def _called_by(self, call: Call, arguments: Sequence[str]) -> str:
        """The call of a function of the document, which stands under a name of its own in the module."""
        key = function_key(call)
        name = self.function_names.name(key, f"_{call.function.name}")
        self.functions[name] = (call.function.target, key, str(call.type))
        return f"{name}({', '.join(arguments)})"

    def _python(self, kind: Type) -> str:
        name = super()._python(kind)
        return self._imported(name) if kind.kind in (Kind.ENUM, Kind.MESSAGE) else name

    def _imported(self, name: str) -> str:
        """What a message or an enum is called in the module."""
        called = name
        while called in TAKEN or (called != name and called in self.document_types):
            called += "_"
        return called

    def _held(self, region: int) -> tuple[str, str]:
        return f"bb: {self._board_type()}", _BB

    def _board_type(self) -> str:
        return "dict[str, Any]" if self.options.mapping else self.board_name

    def _is_active(self, node: Node) -> str | None:
        """The code for a state being active: what is left keeps its number, so what is around it counts."""
        found = self.flat.range.get(node.label)
        if found is None:
            return None
        return self._inside(self.flat.region_number[node.label], *found)

    def _inside(self, region: int, first: int, last: int) -> str:
        tests: list[str] = []
        around: int | None = region
        while around is not None:
            if first == last and self.flat.regions[around].size > 1:
                tests.append(self._at(around, first))
            elif last - first + 1 < self.flat.regions[around].size:
                tests.append(f"{first} <= self.r{around} <= {last}")
            parent = self.chart.node(self.flat.regions[around].label).parent
            around = self.flat.enclosing(around)
            if parent is not None:
                first = last = self.flat.leaf[parent]
        return " and ".join(reversed(tests)) or "True"

    def _at(self, region: int, number: int) -> str:
        """The test whether a region has a number."""
        name = f"self.r{region}"
        if region in self.truths:
            return name if number else f"not {name}"
        return f"{name} == {number}"

    def _is_done(self, node: Node) -> str | None:
        region = self.flat.region_number[node.label]
        if node.type is NodeType.OR:
            end = self.chart.end_of(node.label)
            return None if end is None else self._is_active(end)
        number = self.flat.leaf.get(node.label)
        if number is None:
            return None
        if node.type is NodeType.BASIC:
            return self._inside(region, number + 1, number + 1)
        complete = self._complete(node, number)
        if complete is False:
            return None
        active = self._inside(region, number, number)
        return " and ".join(str(test) for test in (active, complete) if str(test) != "True") or "True"

    def _method(self, signature: str, document: str, method: Method) -> None:
        self.methods.append(self._written(signature, document, method.lines))

    def _written(self, signature: str, document: str, lines: Sequence[str]) -> list[str]:
        """A method with those locals that its lines use."""
        head = [f"    def {signature}:", f'        """{document}"""']
        return [*head, *self._locals(lines, 2, signature), *lines]

    def _locals(self, lines: Sequence[str], depth: int, signature: str = "") -> list[str]:
        found = []
        if any(_BB in line for line in lines) and "bb:" not in signature:
            found.append("    " * depth + "bb = self.bb")
        if any(_NOW in line for line in lines):
            found.append("    " * depth + "now = self.now")
        return found

    def _timers(self) -> dict[int, tuple[str, ...]]:
        """The timers of the regions that have some."""
        found: dict[int, dict[str, None]] = {}
        for transition in self.chart.transitions:
            for item in (*transition.expression.actions, *values_of(transition.expression)):
                if isinstance(item, StartTimer | Expired):
                    region = self.flat.region_number[transition.source]
                    found.setdefault(region, {}).setdefault(item.timer)
        return {region: tuple(sorted(found[region])) for region in sorted(found)}

    # ---- what may follow -------------------------------------------------------------------

    def _copied(self) -> dict[str, tuple[int, ...]]:
        """The variables that some regions may look at after others wrote them, with those that need a copy.

        Who does not write, and is not inside a region that does, finds on the blackboard what there was when
        the step began.
        """
        found: set[str] = set()
        for mode in self.modes:
            reads, writes = self._uses(mode)
            loops = self._may_loop(mode)
            for name, writers in writes.items():
                readers = reads.get(name, set())
                others = {(w, u) for w in writers for u in readers | (writers if loops else set()) if u != w}
                if any(loops or self._looks_later(u, w) for w, u in others):
                    found.add(name)
        written: dict[str, set[int]] = {}
        for transition in self.chart.transitions:
            for name in _written_by(transition.expression):
                written.setdefault(name, set()).add(self.flat.region_number[transition.source])
                if transition.kind is TransitionKind.EXIT and len(self.flat.variable_regions[name]) > 1:
                    found.add(name)
        return {
            name: tuple(
                region
                for region in self.flat.variable_regions[name]
                if any(around in written[name] for around in self._with_around(region))
            )
            for name in sorted(found)
        }

    def _with_around(self, region: int) -> Iterator[int]:
        """A region and those around it, innermost first."""
        around: int | None = region
        while around is not None:
            yield around
            around = self.flat.enclosing(around)

    def _uses(self, mode: str) -> tuple[dict[str, set[int]], dict[str, set[int]]]:
        """The regions that may read, and those that may write each variable in a step of a mode."""
        reads: dict[str, set[int]] = {}
        writes: dict[str, set[int]] = {}
        for use in (*self.uses.get(None, ()), *(self.uses.get(mode, ()) if mode else ())):
            (writes if use.writes else reads).setdefault(use.variable, set()).add(use.region)
        return reads, writes

    def _all_uses(self) -> dict[str | None, tuple[_Use, ...]]:
        """The uses of variables that only an event opens, by the event; None for all others."""
        found: dict[str | None, dict[_Use, None]] = {}
        for transition in self.chart.transitions:
            expression = transition.expression
            raised = [event.name for event in expression.events if isinstance(event, Raised)]
            only_raised = raised and len(raised) == len(expression.events) and not expression.when
            region = self.flat.region_number[transition.source]
            uses = [_Use(v.name, region) for v in values_of(expression) if isinstance(v, VariableValue)]
            uses += [_Use(name, region, writes=True) for name in _written_by(expression)]
            for event in raised if only_raised else (None,):
                found.setdefault(event, {}).update(dict.fromkeys(uses))
        for node in self.chart.nodes if self.options.watched else ():
            for argument in node.arguments:
                for value in values_of(TransitionExpression(condition=argument.value)):
                    if isinstance(value, VariableValue):
                        use = _Use(value.name, self.flat.region_number[node.label])
                        found.setdefault(None, {}).setdefault(use)
        return {event: tuple(uses) for event, uses in found.items()}

    def _touched(self) -> dict[str, dict[int, tuple[int, ...]]]:
        """The leaves for which it makes a difference which event it is: their places in their regions."""
        own: dict[str, frozenset[str]] = {}
        """The events that the transitions of a state wait for, and those of the states around it."""
        for node in self.chart.nodes:  # parents come before children
            around = own[node.parent] if node.parent is not None else frozenset()
            events = {
                event.name
                for segment in self.flat.segments(node.label)
                for event in segment.expression.events
                if isinstance(event, Raised)
            }
            own[node.label] = around | events
        found: dict[str, dict[int, list[int]]] = {}
        for region in self.flat.regions:
            for place, leaf in enumerate(self.flat.leaves(region.number)):
                events = set(own[leaf.label])
                for way in self._open_ways(OTHER, leaf):
                    for taken in _paths(way):
                        target = self.flat.transition(taken[-1]).target
                        events.update(*(own[label] for label in self._rests_in(target)))
                        events.update(*(self.flat.awaited.get(n, ()) for n in self._regions_in(target)))
                for event in events:
                    found.setdefault(event, {}).setdefault(region.number, []).append(place)
        return {
            event: {region: tuple(sorted(places)) for region, places in self._with_ands(item).items()}
            for event, item in found.items()
        }

    def _with_ands(self, places: Mapping[int, Iterable[int]]) -> dict[int, set[int]]:
        """Places of leaves by their regions, with those of the ANDs around these regions."""
        found = {region: set(items) for region, items in places.items()}
        for inner in places:
            for region in self._with_around(inner):
                around = self.chart.node(self.flat.regions[region].label).parent
                if around is not None:
                    found.setdefault(self.flat.region_number[around], set()).add(self.place[around])
        return found

    def _rests_in(self, target: str) -> Iterator[str]:
        """The leaves at which regions rest when `target` has been entered."""
        stack = [target]
        while stack:
            label = self._rest(stack.pop())
            yield label
            if self.chart.node(label).type is NodeType.AND:
                stack += [region.label for region in self.flat.regions_of(label)]

    def _regions_in(self, target: str) -> Iterator[int]:
        """The regions that are entered with `target`."""
        for label in self._rests_in(target):
            if self.chart.node(label).type is NodeType.AND:
                yield from (region.number for region in self.flat.regions_of(label))

    def _looks_later(self, region: int, writer: int) -> bool:
        """Whether a region is looked at after another in a round in which both may move."""
        one, other = self.flat.regions[region].label, self.flat.regions[writer].label
        if one.startswith(f"{other}.") or other.startswith(f"{one}."):
            return False
        return region > writer

    def _may_loop(self, mode: str) -> bool:
        """Whether some transition of a mode may need another round after it."""
        if not mode:
            return any(self._loops_at(mode, leaf) for leaves in self._all_leaves() for leaf in leaves)
        if self.looping is None:
            self.looping = frozenset(
                leaf.label for leaves in self._all_leaves() for leaf in leaves if self._loops_at(OTHER, leaf)
            )
        touched = [
            self.flat.leaves(region)[place]
            for region, places in self.touched.get(mode, {}).items()
            for place in places
        ]
        others = self.looping.difference(leaf.label for leaf in touched)
        return bool(others) or any(self._loops_at(mode, leaf) for leaf in touched)

    def _all_leaves(self) -> list[list[Node]]:
        return [self.flat.leaves(region.number) for region in self.flat.regions]

    def _loops_at(self, mode: str, leaf: Node) -> bool:
        """Whether a transition that is taken while a leaf is active may need another round after it."""
        region = self.flat.region_number[leaf.label]
        for taken, spent in self._open_paths(mode, leaf):
            if self.flat.transition(taken[0]).kind is TransitionKind.ON:
                if self._again_at(mode, leaf, spent):
                    return True
            elif self._again(mode, region, taken, spent):
                return True
        return False

    def _open_paths(self, mode: str, leaf: Node) -> Iterator[tuple[tuple[int, ...], bool]]:
        """The compound transitions that may be taken while a leaf is active, each with whether it certainly
        spends the event."""
        for way in self._open_ways(mode, leaf):
            for taken in _paths(way):
                spends = self._spends(mode, taken)
                if spends is not None:
                    yield taken, spends == "yes"

    def _open_ways(self, mode: str, leaf: Node) -> Iterator[Way]:
        """The ways that may be taken while a leaf is active, if what they wait for is there."""
        for source in (leaf, *self.flat.around(leaf.label)):
            if source is leaf:
                complete = leaf.type is not NodeType.BASIC or not (mode and self._is_left(leaf))
            else:
                complete = leaf.type is NodeType.END and leaf.parent == source.label
            for way in (*self.flat.first_ways(source.label), *self.flat.ways(source.label)):
                if complete or self.flat.waits_for_event(way):
                    yield way

    def _spends(self, mode: str, taken: tuple[int, ...]) -> str | None:
        """What the transitions of a way spend in a mode (see `_Candidate.spends`); None if it is shut."""
        spends = ""
        for number in taken:
            expression = self.flat.transition(number).expression
            if expression is NEVER:
                return None
            if not expression.events:
                continue
            raised = any(isinstance(e, Raised) and e.name == mode for e in expression.events)
            timed = any(
                isinstance(e, After) or (isinstance(e, Failed) and mode == STEP) for e in expression.events
            )
            if not raised and not timed and not expression.when:
                return None
            if raised:
                spends = "perhaps" if timed else "yes"
        return spends

    def _scope(self, taken: tuple[int, ...]) -> str:
        """The lowest OR state that holds source and target of a compound transition."""
        return min((self.chart.scope_of(self.flat.transition(number)) for number in taken), key=len)

    def _rest(self, target: str) -> str:
        """The leaf at which its region rests when `target` has been entered."""
        node = self.chart.node(target)
        while True:
            if node.type is NodeType.OR:
                start = self.chart.start_of(node.label)
                assert start is not None
                node = start
            elif node.label in self.rests.passed:
                node = self.chart.node(self.rests.passed[node.label].target)
            else:
                return node.label

    def _again(self, mode: str, region: int, taken: tuple[int, ...], spent: bool) -> bool:
        """Whether something may be enabled after a transition that could not be taken before."""
        if self.rests.asked:
            return True
        target = self.flat.transition(taken[-1]).target
        leaf = self._rest(target)
        entered = self._scope(taken)
        if self._open_at(mode, leaf, spent, entered):
            return True
        return self._open_around(mode, self.chart.node(leaf), spent)

    def _again_at(self, mode: str, leaf: Node, spent: bool) -> bool:
        """Whether something may be enabled at an active leaf after an action that has left nothing."""
        if self.rests.asked:
            return True
        for source in (leaf, *self.flat.around(leaf.label)):
            done = source is leaf or (leaf.type is NodeType.END and leaf.parent == source.label)
            for way in (*self.flat.first_ways(source.label), *self.flat.ways(source.label)):
                if self._is_open(mode, way, done, spent=spent, entered=False):
                    return True
        return self._open_around(mode, leaf, spent)

    def _open_around(self, mode: str, ends: Node, spent: bool) -> bool:
        """Whether something may be enabled around the region of a leaf in which something was taken."""
        around_region = self.chart.region_of(ends.label)
        complete = ends.type is NodeType.END and ends.parent == around_region
        for around in self.chart.ancestors(around_region):
            for way in self.flat.ways(around.label):
                if self._is_open(mode, way, complete, spent=spent, entered=False):
                    return True
            complete = False
        return False

    def _open_at(self, mode: str, label: str, spent: bool, scope: str) -> bool:
        """Whether something may be enabled at a leaf that was entered, or around it in its region."""
        stack = [(label, spent, scope)]
        while stack:
            label, spent, scope = stack.pop()
            if self._open_in(mode, label, spent, scope):
                return True
            if self.chart.node(label).type is NodeType.AND:
                for region in self.flat.regions_of(label):
                    stack.append((self._rest(region.label), True, region.label))
        return False

    def _open_in(self, mode: str, label: str, spent: bool, scope: str) -> bool:
        """The same, without what is inside an AND."""
        leaf = self.chart.node(label)
        complete = leaf.type is NodeType.START
        if leaf.type is NodeType.AND:
            rests = [self._rest(region.label) for region in self.flat.regions_of(label)]
            complete = all(self.chart.node(rest).type is NodeType.END for rest in rests)
        for source in (leaf, *self.flat.around(label)):
            is_new = source.label != scope and source.label.startswith(f"{scope}.")
            ended = leaf.type is NodeType.END and leaf.parent == source.label
            done = complete if source is leaf else ended
            for way in (*self.flat.first_ways(source.label), *self.flat.ways(source.label)):
                if self._is_open(mode, way, done, spent=spent, entered=is_new):
                    return True
        return False

    def _is_open(self, mode: str, way: Way, complete: bool, *, spent: bool, entered: bool) -> bool:
        expression = self.flat.transition(way.number).expression
        if expression is NEVER:
            return False
        if expression.when:
            return True
        if not expression.events:
            return complete
        return any(
            (event.name == mode and not spent)
            if isinstance(event, Raised)
            else mode == STEP
            if isinstance(event, Failed)
            else not (entered and isinstance(event, After) and event.duration > 0)
            for event in expression.events
        )

    # ---- the whole -------------------------------------------------------------------------

    def generate(self) -> PlainCode:
        methods: list[list[str]] = []
        for region in reversed(self.flat.regions[1:]):  # innermost first, so that nothing goes deep
            self._leave_region(region.number)
        self._share()
        bodies = {event: self._mode(event) for event in self.modes}
        methods.append(self._start(bodies[STEP][0]))
        methods.append(self._send(bodies))
        methods += self._step(bodies[STEP][0])
        if not self.options.translated:
            methods += self._done()
        for mode in (*(mode for _, mode in bodies.values()), *([self.others] if self.others else ())):
            methods += mode.functions.values()
            self.tables += [line for table in mode.tables.values() for line in table]
        head = self._head()
        methods = [self._told(method) for method in (*methods, *self.methods)]
        methods += self._due()
        methods += self._hooks()
        board = tuple(self._board())
        body = [line for method in [head, *methods] for line in [*method, ""]]
        constants = tuple(
            (self.constants[enum, constant], f"{self._imported(enum)}.{constant}")
            for enum, constant in sorted(self.enums)
        )
        known = {(enum.name, name): number for enum in self.system.enums for name, number in enum.constants}
        numbers = tuple((self.constants[item], known[item]) for item in sorted(self.enums))
        functions = tuple(sorted(self.functions.items()))
        used = self.messages | {enum for enum, _ in self.enums}
        return PlainCode(
            self.class_name,
            self.board_name,
            tuple(
                name if name not in TAKEN else f"{name} as {self._imported(name)}" for name in sorted(used)
            ),
            constants,
            numbers,
            functions,
            board,
            tuple(body),
            tuple(self.tables),
        )

    def _told(self, method: list[str]) -> list[str]:
        """A method in which what is written makes the conditions that read it be looked at again."""
        lines: list[str] = []
        for line in method:
            text = line.lstrip()
            if not text.startswith(_WROTE):
                lines.append(line.replace(LOCAL, ""))
                continue
            gates = [gate for gate, read in self.gates.items() if text.removeprefix(_WROTE) in read]
            again = f"{line[: len(line) - len(text)]}{' = '.join(gates)} = False".replace(LOCAL, "")
            if gates and again not in lines[-2:]:
                lines.append(again)
        return lines

    def _board(self) -> list[str]:
        """The class of the blackboard, or the function that makes a dictionary."""
        values = [
            (self._on_board(v.name), self._python(v.type), self._initial(v)) for v in self.chart.variables
        ]
        for slot, message in self._message_slots().values():
            self.messages.add(message)
            values.append((slot, f"{self._imported(message)} | None", "None"))
        called = [f"The variable `{name}` is `{own}`." for name, own in self._renamed().items()]
        knows = " ".join([f"What {docstring(self.chart.name)} knows.", *called])
        document = f'"""{knows}"""'
        if self.options.mapping:
            entries = ", ".join(f"{name!r}: {initial}" for name, _, initial in values)
            return [
                f"def {self.board_name}() -> dict[str, Any]:",
                f"    {document}",
                f"    return {{{entries}}}",
            ]
        lines = [f"class {self.board_name}:", f"    {document}", ""]
        gates = [gate.removeprefix(f"{_BB}.") for gate in self.gates]
        names = [name for name, _, _ in values]
        lines.append(f"    __slots__ = {_tuple([*names, *gates, *(['tracked'] if gates else [])])}")
        if gates:
            lines += [
                "",
                "    def __init__(self, *, tracked: bool = False) -> None:",
                '        """`tracked`: whoever writes to it says `changed()` afterwards."""',
                "        self.tracked = tracked",
            ]
        elif values:
            lines += ["", "    def __init__(self) -> None:"]
        lines += [f"        self.{name}: {kind} = {initial}" for name, kind, initial in values]
        shown = "".join(f" {name}={{self.{name}!r}}" for name, *_ in values)
        if gates:
            lines += [f"        self.{' = self.'.join(gates)} = False", "", "    def changed(self) -> None:"]
            lines.append('        """Something was written: look at all conditions again."""')
            lines.append(f"        self.{' = self.'.join(gates)} = False")
        lines += ["", "    def __repr__(self) -> str:"]
        lines.append(f'        return {"f" * bool(shown)}"<{self.board_name}{shown}>"')
        return lines

    def _head(self) -> list[str]:
        regions = [region for region in self.flat.regions if region.size > 1]
        slots = ["bb", *(f"r{region.number}" for region in regions)]
        annotations = [f"    bb: {self._board_type()}"]
        annotations += [
            f"    r{region.number}: {'bool' if region.number in self.truths else 'int'}" for region in regions
        ]
        for time in sorted({self._time(label) for label in self.flat.timed}, key=_naturally):
            slots.append(time)
            annotations.append(f"    {time}: int")
        if self.is_timed:
            slots.append("now")
        fields = [
            (self._timer(region, timer), "int", "NEVER", True)
            for region, timers in self.timers.items()
            for timer in timers
        ]
        fields += [(self._outcome(labels), "str | None", "None", True) for labels in self.asked]
        fields.append(("failures", "dict[str, str] | None", "None", self.may_fail))
        fields.append(("chance", "Random | None", "None", self.has_chance))
        fields.append(("writes", "tuple[int, str, Any, Any] | None", "None", bool(self.copied)))
        fields.append(("faulty", "tuple[int, ...]", "()", self.faults))
        fields = [item for item in fields if item[3]]
        slots += [name for name, *_ in fields]
        for label in self.flat.counted:
            slots.append(self._count(label))
            annotations.append(f"    {self._count(label)}: int")
        kinds = {name: self._python(self.variables[name].type) for name in self.copied}
        for name, copies in self.copied.items():
            for region in copies:
                slots.append(self._copy(name, region))
                annotations.append(f"    {self._copy(name, region)}: {kinds[name]}")
        if self.spends:
            slots.append("spent")
            annotations.append("    spent: int")
        if self.flat.wakes:
            slots.append("woken")
            annotations.append("    woken: bool")
        inner = [
            (
                region.number,
                self.flat.leaf[leaf.label],
                tuple(r.number for r in self.flat.regions_of(leaf.label)),
            )
            for region in self.flat.regions
            for leaf in self.flat.leaves(region.number)
            if leaf.type is NodeType.AND
        ]
        running = {
            node.label: (self.flat.region_number[node.label], self.flat.leaf[node.label])
            for node in self.chart.nodes
            if node.label in self.rests.completing and node.label in self.flat.leaf
        }
        lines = [
            f"class {self.class_name}(Plain):",
            f'    """The statechart {docstring(self.chart.name)} of {self.chart.system}."""',
            "",
            *(f"    # {line}" for line in self._legend()),
            f"    __slots__ = {_tuple(slots)}",
            "",
            f"    EVENTS = {_tuple(sorted(event for event in self.modes if event != STEP))}",
            "    NAMES = (",
            *(f"        {names!r}," for names in self._of_leaves(_name_or_type)),
            "    )",
            "    LEAVES = (",
            *(f"        {labels!r}," for labels in self._of_leaves(lambda node: node.label)),
            "    )",
        ]
        if inner:
            table = {(region, number): numbers for region, number, numbers in inner}
            lines.append(f"    INNER: ClassVar[Mapping[tuple[int, int], tuple[int, ...]]] = {table!r}")
        if running:
            lines.append(f"    RUNNING: ClassVar[Mapping[str, tuple[int, int]]] = {running!r}")
        ends = {
            node.label: said.ends
            for node in self.chart.nodes
            if node.label in self.flat.leaf and (said := self.flat.said_of(node)) is not None and said.ends
        }
        if ends:
            lines.append(f"    ENDS: ClassVar[Mapping[str, tuple[str, ...]]] = {ends!r}")
        messages = tuple((slot, *key) for key, (slot, _) in self._message_slots().items())
        if messages:
            lines.append(f"    MESSAGES = {messages!r}")
        if renamed := self._renamed():
            lines.append(f"    VARIABLES: ClassVar[Mapping[str, str]] = {renamed!r}")
        if self.options.watched:
            texts = [f"        {self._place(number)!r}," for number in range(len(self.chart.transitions))]
            lines += ["    TRANSITIONS = (", *texts, "    )"]
        if self.flat.wakes:
            texts = [f"        {self._place(number)!r}," for number in self._waking()]
            lines += ["    WAKING = (", *texts, "    )"]
        if circling := [f"        {self._place(number)!r}," for number in self.flat.circling]:
            lines += ["    CIRCLING = (", *circling, "    )"]
        end = self.chart.end_of(self.chart.root.label)
        if end is not None and end.label in self.flat.leaf:
            lines.append(f"    END = {self.flat.leaf[end.label]}")
        lines += ["", *annotations]
        lines += ["", f"    def __init__(self, bb: {self._board_type()} | None = None) -> None:"]
        lines.append(f"        self.bb = {self.board_name}() if bb is None else bb")
        if self.is_timed:
            lines.append("        self.now = 0")
        lines += [f"        self.{name}: {kind} = {value}" for name, kind, value, _ in fields]
        if self.flat.wakes:
            lines.append("        self.woken = False")
        first = [f"self.r{region.number}" for region in regions if self._is_around_all(region.number)]
        first += [
            f"self.{name}"
            for name in dict.fromkeys(
                self._time(label)
                for label in sorted(self.flat.timed)
                if self._is_active(self.chart.node(label)) == "True"
            )
        ]
        if first and not self.options.translated:
            lines.append(f"        {' = '.join(first)} = UNSTARTED")
        return lines

    def _waking(self) -> Iterator[int]:
        """The transitions that write or ask for a variable by which regions wake each other."""
        for number, transition in enumerate(self.chart.transitions):
            condition = transition.expression.condition
            values = walk(condition) if condition is not None else ()
            read = {value.name for value in values if isinstance(value, VariableValue)}
            if not self.flat.wakes.keys().isdisjoint(read | _written_by(transition.expression)):
                yield number

    def _is_around_all(self, region: int) -> bool:
        """Whether a region is active whatever the other numbers are."""
        parent = self.chart.node(self.flat.regions[region].label).parent
        return parent is None or self._is_active(self.chart.node(parent)) == "True"

    def _legend(self) -> Iterator[str]:
        """What the slots mean, for people who look at an instance."""
        for region in self.flat.regions:
            if region.size > 1:
                shown = [
                    f"{number} {_leaf_name(leaf)}{' (complete)' * (number > self.flat.leaf[leaf.label])}"
                    for leaf in self.flat.leaves(region.number)
                    for number in range(self.flat.leaf[leaf.label], self._last(leaf) + 1)
                ]
                where = f"{region.label} {_leaf_name(self.chart.node(region.label))}"
                yield f"r{region.number}: what is active in {where}: {', '.join(_first(shown))}"
        for time in sorted({self._time(label) for label in self.flat.timed}, key=_naturally):
            states = [label for label in sorted(self.flat.timed) if self._time(label) == time]
            shown = [f"{label} {_leaf_name(self.chart.node(label))}" for label in states]
            yield f"{time}: when (ns) it was entered: {', '.join(_first(shown))}"
        for number, timers in self.timers.items():
            for timer in timers:
                yield f"{self._timer(number, timer)}: when (ns) the timer {timer} of region {number} runs out"
        for labels in self.asked:
            yield f"{self._outcome(labels)}: how the activity of {' or '.join(_first(labels))} has ended"
        for label in self.flat.counted:
            yield f"{self._count(label)}: how often {label} {_leaf_name(self.chart.node(label))} was entered"
        for name, copies in self.copied.items():
            for number in copies:
                yield f"{self._copy(name, number)}: {name} during a step, as region {number} sees it"
        if self.spends:
            yield "spent: the regions without the event of this step any more (1 region 0, 2 region 1, 4 ...)"

    def _of_leaves(self, word: Callable[[Node], str]) -> list[str]:
        """A word for each of a region's leaves by their numbers."""
        return [
            " ".join(
                word(node) for node in self.flat.leaves(region.number) for _ in range(self.rests.width(node))
            )
            for region in self.flat.regions
        ]

    # ---- the interface ---------------------------------------------------------------------

    def _start(self, step: list[str]) -> list[str]:
        """The method that enters the root and goes on until nothing is enabled, as a `step` does."""
        root = self.chart.root
        lines = [f"self.{self._count(label)} = 0" for label in self.flat.counted]
        copies = [line for name in self.copied for line in self._taken_copies(name)]
        lines += [*copies, *self._on_entry(0, root)]
        entered = self._enter_inside(0, root.label)
        goes_on = (
            self.rests.asked
            or self._open_at(STEP, self._rest(root.label), False, root.label)
            or bool(self.chart.outgoing(root.label))
        )
        signature, document = "start(self) -> None", "Enter the root, and go on until nothing is enabled."
        if goes_on and any(line.startswith("self.writes = ") for line in entered):
            # It is one step: what a region has written it sees, so the copies are not taken again.
            again = set(_indented(copies, 2))
            rest = [line for line in step[:-1] if line not in again]
            place, depth = (rest.index("        try:") + 1, 3) if "        try:" in rest else (0, 2)
            rest[place:place] = _indented(entered, depth)
            rest += _indented(_FOLLOWS, 2) if self.flat.wakes else []
            return self._written(signature, document, [*_indented(lines, 2), *rest])
        lines += entered if goes_on else self._ended_by(entered, self._spread())
        if goes_on:
            lines.append("self.step()")
        elif "self.woken = True" in entered:
            lines += _FOLLOWS
        return self._written(signature, document, _indented(lines or ["pass"], 2))

    def _due(self) -> list[list[str]]:
        """The method that says when time alone may matter, where it may."""
        if not self.is_timed:
            return []
        lines = ["now = self.now", "best = NEVER"]
        for wait in self.flat.waits:
            found = self.flat.range.get(wait.source)
            if found is None:
                continue
            where = self._inside(self.flat.region_number[wait.source], *found)
            at = (
                f"self.{self._time(wait.source)} + {wait.amount}"
                if wait.kind == "after"
                else f"self.{self._timer(self.flat.region_number[wait.source], wait.name)}"
            )
            body = [f"at = {at}", "if now < at < best:", "    best = at"]
            lines += body if where == "True" else [f"if {where}:", *_indented(body, 1)]
        lines.append("return None if best == NEVER else best")
        document = "The next moment (ns) at which time alone may enable something that is waited for."
        return [["    def due(self) -> int | None:", f'        """{document}"""', *_indented(lines, 2)]]

    def _send(self, bodies: dict[str, tuple[list[str], _Mode]]) -> list[str]:
        """The method that makes a step with an event: a body for each."""
        events = [event for event in bodies if event != STEP]
        idle = bodies[STEP][0] == _NOTHING
        document = "One step with an event; whether anything was taken."
        signature = "send(self, event: str) -> bool"
        lines: list[str] = []
        in_line = sum(len(bodies[event][0]) for event in events) <= IN_LINE and len(events) <= BRANCHES
        for event in events if not in_line else ():
            name = self.identifiers.name(("event", event), f"_on_{event}")
            self.event_methods[event] = name
            self.methods.append(
                self._written(f"{name}(self) -> bool", f"One step with `{event}`.", bodies[event][0])
            )
        if len(events) > BRANCHES:
            entries = [f"    {event!r}: {self.class_name}.{self.event_methods[event]}," for event in events]
            kind = f"dict[str, Callable[[{self.class_name}], bool]]"
            self.tables += ["", f"_EVENTS: {kind} = {{", *entries, "}"]
            lines = ["        method = _EVENTS.get(event)", "        if method is not None:"]
            lines += ["            return method(self)"]
        if in_line and len(events) == 1:
            (event,) = events
            body = bodies[event][0]
            other = "return False" if idle else "return self.step()"
            lines = [f"        if event != {event!r}:", f"            {other}"]
            return [
                f"    def {signature}:",
                f'        """{document}"""',
                *lines,
                *self._locals(body, 2),
                *body,
            ]
        for index, event in enumerate(events if len(events) <= BRANCHES else ()):
            body = bodies[event][0] if in_line else [f"        return self.{self.event_methods[event]}()"]
            lines.append(f"        {'elif' if index else 'if'} event == {event!r}:")
            lines += _indented([*self._locals(body, 2), *body], 1)
            if in_line and body[-1] == "        return False":
                del lines[-1]  # there is one at the end
                if lines[-1].endswith(":"):
                    lines.append("            pass")
        falls = in_line and any(bodies[event][0][-1] == "        return False" for event in events)
        if idle:
            lines.append("        return False")
        elif falls:
            lines += ["        else:", "            return self.step()", "        return False"]
        else:
            lines.append("        return self.step()")
        return [f"    def {signature}:", f'        """{document}"""', *lines]

    def _step(self, body: list[str]) -> list[list[str]]:
        """The method that makes a step without an event, with what follows at the same instant."""
        signature, document = "step(self) -> bool", "One step without an event."
        if not self.flat.wakes:
            return [self._written(signature, document, body)]
        whole = ["if not self._alone():", "    return False", *_FOLLOWS, "return True"]
        follow = [
            "steps = 0",
            "while True:",
            "    if not self.woken:",
            "        break",
            "    self.woken = False",
            "    self._alone()",
            "    steps += 1",
            "    if steps == ROUNDS:",
            "        raise self.endless()",
        ]
        alone = "What a step without an event does, without the steps that follow it."
        after = "The steps that follow as long as regions write what conditions of others read."
        return [
            self._written(signature, document, _indented(whole, 2)),
            self._written("_alone(self) -> bool", alone, body),
            self._written("_follow(self) -> None", after, _indented(follow, 2)),
        ]

    # ---- an activity that has returned -----------------------------------------------------

    def _done(self) -> Iterator[list[str]]:
        """The method that makes a step before which an activity has returned, if that matters anywhere.

        States are found by their place among the leaves of all regions, one region after the other.
        """
        bodies: list[_Body] = []
        places = 0
        alone = self._alone()
        for region in self.flat.regions:
            for leaf in self.flat.leaves(region.number):
                if leaf.type is NodeType.BASIC and self.rests.width(leaf) > 1:
                    place = places + self.flat.leaf[leaf.label]
                    does = self._returned(region.number, leaf, places, alone[region.number])
                    bodies.append(_Body(place, place, f"{leaf.label} {leaf.name}", tuple(does)))
            places += region.size
        bodies = _merged(bodies)
        if not bodies:
            return
        if sum(len(body.lines) for body in bodies) > IN_LINE:
            bodies = [
                self._done_apart(number, bodies[first : first + CHUNK])
                for number, first in enumerate(range(0, len(bodies), CHUNK))
            ]
        says = any(map(self.flat.ending.__contains__, self.flat.leaf))
        key, kind = ("(label, outcome)", "tuple[str, str | None]") if says else ("label", "str")
        self.tables += ["", f"_PLACES: dict[{kind}, int] = {{}}"]
        self.tables.append('"""The activities that have returned before, as they were given to `done`."""')
        lines = [
            f"place = _PLACES.get({key})",
            "if place is None:",
            "    place = self.place(label, outcome)",
            "    if place < 0:",
            "        return self.step()",
            *(
                ["    if outcome is None or outcome in self.ENDS.get(self.label_of(label), ()):"]
                if says
                else []
            ),
            f"    {'    ' * says}_PLACES[{key}] = place",
            *self._tree("place", bodies),
            "return self.step()",
        ]
        yield [
            "    def done(self, label: str, outcome: str | None = None) -> bool:",
            '        """One step, before which the activity of a BASIC state has returned."""',
            *_indented(lines, 2),
        ]

    def _done_apart(self, number: int, bodies: list[_Body]) -> _Body:
        """A method for some of the activities that have returned; what calls it."""
        name = self.identifiers.name(("done", number), f"_done_{number}")
        given = {"place": "int"} | ({"outcome": "str | None"} if self.asked else {})
        signature = ", ".join(["self", *(f"{item}: {kind}" for item, kind in given.items())])
        both = _joined(bodies[0], bodies[-1])
        lines = [*self._tree("place", bodies), "return self.step()"]
        head = [
            f"    def {name}({signature}) -> bool:",
            f'        """{docstring(both.title)} has returned."""',
        ]
        self.methods.append([*head, *_indented(lines, 2)])
        return replace(both, lines=(f"return self.{name}({', '.join(given)})",))

    def _returned(self, region: int, leaf: Node, places: int, alone: bool) -> list[str]:
        """What is done as the activity of a leaf has returned, and all of the step if it moves `alone`.

        Where nothing can be said of the rest, a step is to follow.
        """
        number = self.flat.leaf[leaf.label]
        slot = f"self.r{region}"
        ends = [f"self.{self._outcome(labels)} = outcome" for labels in self.asked if leaf.label in labels]
        around = self.chart.node(self.flat.regions[region].label).parent
        inside = "" if around is None else self._is_active(self.chart.node(around))
        before = f"{inside} and " if inside not in ("", "True") else ""
        again = self._loops_at(STEP, leaf)
        if self.flat.regions[region].size > TABLE or not alone or (again and (self.copied or self.faults)):
            if not ends:  # the same for all
                running = f"place - {places}" if places else "place"
                return [f"if {before}{slot} == {running}:", f"    {slot} += 1"]
            return [f"if {before}{slot} == {number}:", f"    {slot} = {number + 1}", *_indented(ends, 1)]
        mode = _Mode(STEP, direct=not self.copied and not self.faults)
        lines = self._whole(mode, self._from_leaf(mode, region, leaf, number + 1, 4), region)
        lines = [f"{slot} = {number + 1}  # {self._title(leaf, number + 1)}", *ends, *lines]
        return [f"if {before}{slot} == {number}:", *_indented([*self._locals(lines, 0), *lines], 1)]

    def _alone(self) -> list[bool]:
        """The regions in which something may move by itself: by the regions' numbers, whether in a step
        without an event nothing else does, as long as no other activity returns."""
        failing = any(
            isinstance(e, Failed) for item in self.chart.transitions for e in item.expression.events
        )
        moves = [
            any(self._moves_by_itself(leaf, complete=True) for leaf in leaves)
            for leaves in self._all_leaves()
        ]
        inside = list(moves)
        for region in reversed(self.flat.regions[1:]):  # innermost first
            around = self.flat.enclosing(region.number)
            assert around is not None
            inside[around] |= inside[region.number]
        alone = [not failing]
        moving = Counter(
            self.chart.node(region.label).parent for region in self.flat.regions if inside[region.number]
        )
        for region in self.flat.regions[1:]:
            parent = self.chart.node(region.label).parent
            assert parent is not None
            is_calm = not self._moves_by_itself(self.chart.node(parent), complete=False)
            others = moving[parent] - inside[region.number]
            alone.append(alone[self.flat.region_number[parent]] and is_calm and not others)
        return alone

    def _moves_by_itself(self, leaf: Node, *, complete: bool) -> bool:
        """Whether something may be taken while a leaf is active that has no event and rests there until then.

        `complete`: it may be complete. What is left as soon as it is complete does not rest.
        """
        for source in (leaf, *self.flat.around(leaf.label)):
            ended = complete if source is leaf else leaf.type is NodeType.END and leaf.parent == source.label
            rests = ended and not self._is_left(source)
            for way in (*self.flat.first_ways(source.label), *self.flat.ways(source.label)):
                waits = self.flat.waits_for_event(way)
                if (rests or waits) and self._spends(OTHER, (way.number,)) is not None:
                    return True
        return False

    # ---- a step ----------------------------------------------------------------------------

    def _mode(self, event: str) -> tuple[list[str], _Mode]:
        """The body of a step, as it stands in a method; without an event, without the steps that follow."""
        mode = self._mode_of(event)
        for region in reversed(self.flat.regions):  # innermost first, so that nothing goes deep
            is_deep = region.number and self._nesting(region.number) % NESTED == 0
            if is_deep and not self._is_shared(mode, region.number):
                self._apart(mode, region.number)
        lines = self._region(mode, 0, 3 if mode.loops else 2)
        return _indented(self._whole(mode, lines, follows=event != STEP), 2), mode

    def _whole(
        self, mode: _Mode, lines: list[str], region: int | None = None, *, follows: bool = True
    ) -> list[str]:
        """What a step does, with what comes before and after it; of one `region` if nothing else is done.

        `follows`: steps may follow it at the same instant.
        """
        if not lines:
            return ["return False"]
        if mode.direct:
            return lines if _returns(lines) else [*lines, "return False"]
        head: list[str] = []
        for name in self.copied:
            head += self._taken_copies(name, region)
        tail = self._spread()
        if self.faults:
            tail += ["if self.faulty:", "    self.faulty = ()"]
        after = list(_FOLLOWS) if follows and self.flat.wakes else []
        if mode.loops:
            every = [lines, *mode.functions.values()]
            if any("self.spent" in line for text in every for line in text):
                self.spends = True
                head.append("self.spent = 0")
            head += ["rounds = 0", "moved = False"]
            lines = ["while True:", "    again = False", *_indented(lines, 1), "    if not again:"]
            lines += ["        break", "    rounds += 1"]
            lines += ["    if rounds == ROUNDS:", "        raise self.unsettled()"]
        else:
            says = f"{_MOVED} = True"
            if says in lines and all(line == says for line in lines if re.search(rf"\b{_MOVED}\b", line)):
                lines = [line for line in lines if line != says]
                return [*head, *self._ended_by(lines, tail), *after, "return True"]
            head.append(f"{_MOVED} = False")
        return [*head, *self._ended_by(lines, tail), *after, f"return {_MOVED}"]

    def _ended_by(self, lines: list[str], tail: list[str]) -> list[str]:
        """A step with what ends it: also one that something raises, where a program is called in it."""
        if not tail or self.options.translated:
            return [*lines, *tail]
        return ["try:", *_indented(lines, 1), "finally:", *_indented(tail, 1)]

    def _mode_of(self, event: str) -> _Mode:
        mode = _Mode(event, self._may_loop(event))
        if event and self.others is not None:
            mode.loops |= self.others.loops
        mode.direct = not mode.loops and len(self.flat.regions) == 1 and not self.copied and not self.faults
        return mode

    def _share(self) -> None:
        """Write what needs no event into methods, one a region, if that is much to stand with each event."""
        leaves = [leaf for leaves in self._all_leaves() for leaf in leaves]
        tests = sum(1 for leaf in leaves for _ in self._open_paths(OTHER, leaf))
        if tests * (len(self.modes) - 1) > SHARED:
            mode = self._mode_of(OTHER)
            for region in reversed(self.flat.regions):
                self._apart(mode, region.number)
            self.others = mode

    def _is_shared(self, mode: _Mode, region: int) -> bool:
        """Whether what is done in a region is the same for other events, and stands in a method of theirs."""
        return (
            self.others is not None
            and mode.event not in (STEP, OTHER)
            and region not in self.touched.get(mode.event, {})
        )

    def _taken_copies(self, name: str, only: int | None = None) -> list[str]:
        """The copies of a variable at the beginning of a step, of all regions or only one."""
        copies = [
            f"self.{self._copy(name, region)}" for region in self.copied[name] if only in (None, region)
        ]
        return [f"{' = '.join(copies)} = {self._place_on_board(self._on_board(name))}"] if copies else []

    def _spread(self) -> list[str]:
        """The end of a step: all regions see what some have written into their copies."""
        if not self.copied:
            return []
        lines = ["if self.writes is not None:", f"    self.spread({_BB})", "    self.writes = None"]
        return [
            *lines,
            *(f"    {_WROTE}{self._place_on_board(self._on_board(name))}" for name in self.copied),
        ]

    def _region(self, mode: _Mode, region: int, depth: int) -> list[str]:
        """One round of a region: by its active leaf, what can be taken from there."""
        if self.others is not None and self._is_shared(mode, region):
            return self._called_apart(mode, self.others, region)
        if region in mode.apart:
            return self._called_apart(mode, mode, region)
        if depth > DEEP:
            self._apart(mode, region)
            return self._called_apart(mode, mode, region)
        if self.options.tables and self.flat.regions[region].size > TABLE:
            touched = self.touched.get(mode.event, {}).get(region, ())
            if not mode.event or self.others is None or len(touched) > TABLE:
                return self._by_table(mode, region)
        bodies = self._bodies(mode, region, depth)
        if mode.flags != (_MOVED,) or mode.direct or mode.loops:
            return self._dispatch(region, bodies)
        says = f"{_MOVED} = True"
        if not all(body.lines and body.lines[-1] == says for body in bodies):
            return self._dispatch(region, bodies)
        # Whatever the number, it moves: that need not be said in each body.
        bodies = [replace(body, lines=body.lines[:-1]) for body in bodies]
        return [*self._dispatch(region, bodies), says]

    def _bodies(self, mode: _Mode, region: int, depth: int) -> list[_Body]:
        """What is done for each number of a region; neighbours that do the same are one."""
        leaves = self.flat.leaves(region)
        if mode.event in (STEP, OTHER):
            bodies = _merged(body for leaf in leaves for body in self._pieces(mode, region, leaf, depth))
            if mode.event == OTHER:
                filled = [body for body in bodies if body.lines]
                self.others_done[region] = [body.first for body in filled], [body.last for body in filled]
            return bodies
        if self.others is not None:
            return _merged(self._beside_others(mode, region, depth, self.others))
        touched = set(self.touched.get(mode.event, {}).get(region, ()))
        touched.update(place for place, leaf in enumerate(leaves) if leaf.type is NodeType.AND)
        others = self.untouched.setdefault((region, mode.loops, mode.direct, mode.flags), _Untouched())
        other = replace(mode, event=OTHER)
        if not others.pieces:
            others.pieces = [None] * len(leaves)
            found: list[_Body] = []
            for place, leaf in enumerate(leaves):
                of = self._pieces(mode if place in touched else other, region, leaf, depth)
                found += of
                others.pieces[place] = None if place in touched else of
            return _merged(found)
        if not others.starts:
            for place, leaf in enumerate(leaves):
                if others.pieces[place] is None:
                    is_and = leaf.type is NodeType.AND  # it is never used then
                    of = (
                        [_Body(0, 0, "", (f"{place}",))]
                        if is_and
                        else self._pieces(other, region, leaf, depth)
                    )
                    others.pieces[place] = of
            others.join()
        found = []
        begin = 0
        for place in sorted(touched):
            found += others.between(begin, place)
            found += self._pieces(mode, region, leaves[place], depth)
            begin = place + 1
        return _merged([*found, *others.between(begin, len(leaves))])

    def _beside_others(self, mode: _Mode, region: int, depth: int, others: _Mode) -> Iterator[_Body]:
        """What is done for each number of a region, where a method does what needs no event."""
        leaves = self.flat.leaves(region)
        called = tuple(self._called_apart(mode, others, region))
        begin = 0
        for place in (*self.touched.get(mode.event, {}).get(region, ()), len(leaves)):
            if begin < place:
                one, other = leaves[begin], leaves[place - 1]
                first, last = self.flat.leaf[one.label], self._last(other)
                title = self._title(one, first)
                if first < last:
                    title = f"{title} to {self._title(other, last)}"
                yield _Body(first, last, title, called if self._is_in_others(region, first, last) else ())
            if place < len(leaves):
                yield from self._pieces(mode, region, leaves[place], depth)
            begin = place + 1

    def _is_in_others(self, region: int, first: int, last: int) -> bool:
        """Whether there is anything for some of these numbers in what all events share."""
        begins, ends = self.others_done[region]
        found = bisect_right(begins, last) - 1
        return found >= 0 and ends[found] >= first

    def _pieces(self, mode: _Mode, region: int, leaf: Node, depth: int) -> list[_Body]:
        """What is done for each number of a leaf."""
        found: list[_Body] = []
        for number in range(self.flat.leaf[leaf.label], self._last(leaf) + 1):
            if mode.event and self._is_left(leaf) and number > self.flat.leaf[leaf.label]:
                found[-1] = replace(found[-1], last=number)
                continue
            lines = tuple(self._from_leaf(mode, region, leaf, number, depth + 3))
            found.append(_Body(number, number, self._title(leaf, number), lines, leaf.type is NodeType.AND))
        return found

    def _is_left(self, leaf: Node) -> bool:
        """Whether a state is left as soon as it is complete: no step with an event finds it so."""
        ways = self.chart.ways_from(leaf.label)
        return any(
            is_open(way.expression) and self.chart.node(way.target).type is not NodeType.CONDITION
            for way in ways
        )

    def _last(self, leaf: Node) -> int:
        return self.flat.leaf[leaf.label] + self.rests.width(leaf) - 1

    def _title(self, leaf: Node, number: int) -> str:
        if self.rests.width(leaf) == 1 and leaf.type is NodeType.BASIC:
            return f"{leaf.label} {leaf.name}"
        return self._leaf_title(leaf, number)

    def _dispatch(self, region: int, bodies: list[_Body]) -> list[str]:
        """Find the body of the active leaf by comparisons; halves where there are many."""
        filled = [body for body in bodies if body.lines]
        if not filled:
            return []
        if len(bodies) == 1:
            return list(bodies[0].lines)
        name = f"self.r{region}"
        if len(bodies) == 2:
            return self._either(name, *bodies)
        if len(filled) == 1:
            return self._tree(name, bodies)
        local = f"r{region}"
        return [f"{local} = {name}", *self._tree(local, bodies)]

    def _either(self, name: str, one: _Body, other: _Body) -> list[str]:
        """One of two bodies; truth is the cheapest comparison."""
        alone = one.first == 0 and other.first == 1
        later = name if alone else f"{name} > {one.last}"
        if not one.lines:
            return _only(later, other)
        if not other.lines:
            return _only(f"not {name}" if alone else f"{name} < {other.first}", one)
        lines = [f"if {later}:  # {other.title}", *_indented(other.lines, 1)]
        return [*lines, f"else:  # {one.title}", *_indented(one.lines, 1)]

    def _tree(self, name: str, bodies: list[_Body]) -> list[str]:
        filled = [body for body in bodies if body.lines]
        if not filled:
            return []
        if len(bodies) == 1:
            return list(bodies[0].lines)
        if len(bodies) == 2:
            return self._either(name, *bodies)
        is_held = filled[-1] is bodies[-1] and bodies[-1].is_and and len(filled) > 1
        if len(filled) <= 3 and not is_held:
            return self._one_by_one(name, bodies)
        # A statechart stays long in an AND: one comparison is to lead there.
        middle = len(bodies) - 1 if is_held else len(bodies) // 2
        lower, upper = self._tree(name, bodies[:middle]), self._tree(name, bodies[middle:])
        if not lower:
            return [f"if {name} >= {bodies[middle].first}:", *_indented(upper, 1)]
        lines = [f"if {name} < {bodies[middle].first}:", *_indented(lower, 1)]
        if is_held:
            return [*lines, f"else:  # {bodies[-1].title}", *_indented(upper, 1)]
        return [*lines, f"el{upper[0]}", *upper[1:]] if upper else lines

    def _one_by_one(self, name: str, bodies: list[_Body]) -> list[str]:
        """Compare with each number at which there is anything to do."""
        lines: list[str] = []
        tested = bodies[0].first
        """What is smaller does not come so far."""
        filled = [body for body in bodies if body.lines]
        for body in filled:
            is_last = body is bodies[-1] and body.first == tested
            if body.first == body.last:
                test = f"{name} == {body.first}"
            elif body.first == tested:
                test = f"{name} <= {body.last}"
            elif body is bodies[-1]:
                test = f"{name} >= {body.first}"
            else:
                test = f"{body.first} <= {name} <= {body.last}"
            if body.first == tested:
                tested = body.last + 1
            word = "else" if is_last else f"{'elif' if lines else 'if'} {test}"
            lines += [f"{word}:  # {body.title}", *_indented(body.lines, 1)]
        return lines

    def _by_table(self, mode: _Mode, region: int) -> list[str]:
        """Find the body of the active leaf in a tuple of functions, each for as many leaves as `CHUNK`.

        A function for each leaf is no faster, and takes long to load.
        """
        word = _word(mode)
        table = self.identifiers.name(("table", mode.event, region), f"_{word.upper()}_{region}")
        entries: list[str] = []
        inner = self._called(mode)
        others = self.others if mode.event not in (STEP, OTHER) else None
        shared = others.apart[region] if others is not None else ""
        called = self._called_apart(inner, others, region) if others is not None else []
        bodies = self._bodies(inner, region, 3)
        for first in range(0, self.flat.regions[region].size, CHUNK):
            last = first + CHUNK - 1
            inside = [
                replace(body, first=max(body.first, first), last=min(body.last, last))
                for body in bodies
                if body.first <= last and body.last >= first
            ]
            lines = self._dispatch(region, inside)
            if not lines:
                entries.append("None")
                continue
            if lines == called:
                entries.append(f"{self.class_name}.{shared}")
                continue
            name = self.identifiers.name(("leaves", mode.event, region, first), f"_{word}_{region}_{first}")
            ends = [labels[0].split()[0] for labels in ([inside[0].title], [inside[-1].title])]
            self._function(inner, name, f"{_said(mode)} while {ends[0]} … {ends[1]}.", lines)
            entries.append(f"{self.class_name}.{name}")
        if all(entry == "None" for entry in entries):
            return []
        gives = "bool" if mode.direct else "int"
        kind = f"tuple[Callable[[{self.class_name}], {gives}] | None, ...]"
        mode.tables[table] = ["", f"{table}: {kind} = (", *(f"    {entry}," for entry in entries), ")"]
        found = f"leaves = {table}[self.r{region} >> {CHUNK.bit_length() - 1}]"
        moved = self._after_call(mode, "leaves(self)", loops=mode.loops)
        return [found, "if leaves is not None:", *_indented(moved, 1)]

    def _apart(self, mode: _Mode, region: int) -> None:
        """Write the code of a region into a method of its own."""
        word = _word(mode)
        inner = self._called(mode)
        lines = self._region(inner, region, 3)
        if lines:
            name = self.identifiers.name(("region", mode.event, region), f"_{word}_region_{region}")
            self._function(inner, name, f"{_said(mode)} in region {self.flat.regions[region].label}.", lines)
            mode.apart[region] = name
        else:
            mode.apart[region] = ""

    def _called_apart(self, mode: _Mode, called: _Mode, region: int) -> list[str]:
        """The call of a region's method, which is one of the same mode or of the shared one."""
        name = called.apart[region]
        if not name:
            return []
        return self._after_call(mode, f"self.{name}()", loops=called.loops)

    def _nesting(self, region: int) -> int:
        """How many regions are around a region."""
        return sum(
            node.type is NodeType.AND for node in self.chart.ancestors(self.flat.regions[region].label)
        )

    def _called(self, mode: _Mode) -> _Mode:
        """The mode for what is written into methods that the body calls."""
        return _Mode(
            mode.event,
            mode.loops,
            direct=mode.direct,
            functions=mode.functions,
            tables=mode.tables,
            apart=mode.apart,
        )

    def _function(self, mode: _Mode, name: str, document: str, lines: list[str]) -> None:
        """A method that gives 0, 1 if something moved, 2 if another round is needed after it."""
        kind = "bool" if mode.direct else "int"
        if mode.direct:
            if not _returns(lines):
                lines = [*lines, "return False"]
        elif mode.loops:
            lines = ["moved = again = False", *lines, "return moved + again"]
        else:
            lines = ["moved = False", *lines, "return moved"]
        signature = f"{name}(self) -> {kind}"
        mode.functions[name] = self._written(signature, docstring(document), _indented(lines, 2))

    def _after_call(self, mode: _Mode, call: str, *, loops: bool) -> list[str]:
        """A call of what says whether something moved, and if it `loops`, whether another round is needed."""
        if mode.direct:
            return [f"return {call}"]
        flags = " = ".join(mode.flags)
        if not loops:
            return [f"if {call}:", f"    {flags} = True"]
        lines = [f"found = {call}", "if found:", f"    {flags} = True"]
        return [*lines, "    if found > 1:", "        again = True"]

    # ---- from a leaf -----------------------------------------------------------------------

    def _from_leaf(self, mode: _Mode, region: int, leaf: Node, number: int, depth: int) -> list[str]:
        """What one round may do while `leaf` is active: what cuts short, the outermost first; then innermost
        source first."""
        complete = self._complete(leaf, number)
        cuts: list[_Candidate] = []
        for around in reversed(self.flat.around(leaf.label)):
            for way in self.flat.first_ways(around.label):
                cuts += self._candidates(mode, region, around.label, False, way)
        for way in self.flat.first_ways(leaf.label):
            cuts += self._candidates(mode, region, leaf.label, complete, way)
        ways: list[_Candidate] = []
        for way in self.flat.ways(leaf.label):
            ways += self._candidates(mode, region, leaf.label, complete, way)
        for around in self.flat.around(leaf.label):
            ended = leaf.type is NodeType.END and leaf.parent == around.label
            for way in self.flat.ways(around.label):
                ways += self._candidates(mode, region, around.label, ended, way)
        inside: list[str] = []
        if leaf.type is NodeType.AND:
            flags = mode.flags
            if ways:
                mode.inside += 1
                flag = f"inside_{region}_{mode.inside}"
                mode.flags = (*flags, flag)
            deeper = depth + (1 if cuts else 0)
            was_direct, mode.direct = mode.direct, False
            for inner in self.flat.regions_of(leaf.label):
                inside += self._region(mode, inner.number, deeper)
            mode.direct = was_direct
            mode.flags = flags
        rest = self._chain(mode, region, leaf, number, ways)
        if inside and rest:
            rest = [f"{flag} = False", *inside, f"if not {flag}:", *_indented(rest, 1)]
        else:
            rest = inside or rest
        return self._chain(mode, region, leaf, number, cuts, rest) if cuts else rest

    def _complete(self, leaf: Node, number: int) -> str | bool:
        if leaf.type is NodeType.BASIC:
            return number != self.flat.leaf[leaf.label]
        if leaf.type is NodeType.AND:
            tests = []
            for region in self.flat.regions_of(leaf.label):
                end = self.chart.end_of(region.label)
                if end is None or end.label not in self.flat.leaf:
                    return False
                if region.size > 1:
                    tests.append(self._at(region.number, self.flat.leaf[end.label]))
            return " and ".join(tests) or True
        return leaf.type is NodeType.START

    def _chain(
        self,
        mode: _Mode,
        region: int,
        leaf: Node,
        number: int,
        candidates: list[_Candidate],
        otherwise: Sequence[str] = (),
    ) -> list[str]:
        """The first candidate that is open is taken; `otherwise` is done where none is."""
        lines: list[str] = []
        word = "if"
        gate = "" if otherwise else self._gate(candidates)
        for candidate in candidates:
            taken = self._take(mode, region, leaf, number, candidate) if candidate.leads_on else ["pass"]
            notes = [f"# {self._place(step)}" for step in candidate.taken]
            if not candidate.tests:
                if word == "if":
                    return [*notes, *taken]
                return [*lines, "else:", *_indented([*notes, *taken], 1)]
            test = " and ".join(candidate.tests)
            lines += [*notes, f"{word} {test}:", *_indented(taken, 1)]
            word = "elif"
        if gate:
            lines += ["else:", f"    {gate} = {_BB}.tracked"]
            return [f"if not {gate}:  # something has changed", *_indented(lines, 1)]
        if otherwise:
            return [*lines, "else:", *_indented(otherwise, 1)] if lines else list(otherwise)
        return lines

    def _gate(self, candidates: list[_Candidate]) -> str:
        """What says that none of many conditions holds, as long as nothing changes that they read."""
        tests = [test for candidate in candidates for test in candidate.tests]
        if len(candidates) < GUARDS or self.options.mapping or not self.options.gates:
            return ""
        if not all(item.tests for item in candidates):
            return ""
        if any(_NOW in test or re.search(r"\bself\b", test) for test in tests):
            return ""
        read = frozenset(re.findall(rf"{_BB}\.\w+", " ".join(tests)))
        found = next(
            (name for name, reads in self.gates.items() if (name, reads, tuple(tests)) in self.gated), ""
        )
        if not found:
            number = len(self.gates) + 1
            found = f"{_BB}." + self.board_names.name(("gate", number), f"still_{number}")
            self.gates[found] = read
            self.gated.add((found, read, tuple(tests)))
        return found

    def _candidates(
        self,
        mode: _Mode,
        region: int,
        source: str,
        complete: str | bool,
        way: Way,
        before: tuple[int, ...] = (),
        tests: tuple[str, ...] = (),
        spends: str = "",
    ) -> Iterator[_Candidate]:
        """The compound transitions of a way, each with all of its tests."""
        transition = self.flat.transition(way.number)
        expression = transition.expression
        if expression is NEVER:
            return
        if expression.events and not expression.when:
            found = self._there(mode, region, source, expression.events)
            if found is None:
                return
            tests = (*tests, *found)
        elif not expression.events and not expression.when and not before:
            if complete is False:
                return
            if isinstance(complete, str):
                tests = (*tests, complete)
        spends = self._spending(mode, source, expression.events) or spends
        if expression.every is not None:
            tests = (*tests, f"{_NOW} - self.{self._time(source)} >= {expression.every}")
        if expression.condition is not None:
            prefix = f"{region}_{way.number}_"
            method = Method(self._names(region, prefix))
            guard = self._guard(method, region, way.number, expression.condition)
            if guard != "True":
                tests = (*tests, guard)
        taken = (*before, way.number)
        if self.chart.node(transition.target).type is NodeType.CONDITION:
            found_ways = [
                item
                for branch in way.branches
                for item in self._candidates(mode, region, source, complete, branch, taken, tests, spends)
            ]
            if not found_ways and _may_do(tests):
                found_ways = [_Candidate(source, (*tests, "False"), taken, "", leads_on=False)]
            yield from found_ways
            return
        yield _Candidate(source, tests, taken, spends, transition.kind is TransitionKind.ON)

    def _there(
        self, mode: _Mode, region: int, source: str, events: Iterable[Event]
    ) -> tuple[str, ...] | None:
        """What must hold for one of the events to be there; None if it cannot be."""
        tests: list[str] = []
        for event in events:
            if isinstance(event, After):
                tests.append(f"{_NOW} - self.{self._time(source)} >= {event.duration}")
            elif isinstance(event, Failed) and mode.event == STEP:
                tests.append(f"self.failed_inside({source!r})")
            elif isinstance(event, Raised) and event.name == mode.event:
                if not mode.loops:
                    return ()
                tests.append(f"not self.spent & {1 << region}")
        if not tests:
            return None
        return (tests[0] if len(tests) == 1 else f"({' or '.join(tests)})",)

    def _spending(self, mode: _Mode, source: str, events: Iterable[Event]) -> str:
        """Whether the event is spent (see `_Candidate.spends`): the first of several that is there counts."""
        before: list[str] = []
        for event in events:
            if isinstance(event, Raised) and event.name == mode.event:
                return f"not ({' or '.join(before)})" if before else "yes"
            if isinstance(event, After):
                before.append(f"{_NOW} - self.{self._time(source)} >= {event.duration}")
        return ""

    # ---- taking a transition ---------------------------------------------------------------

    def _take(self, mode: _Mode, region: int, leaf: Node, number: int, candidate: _Candidate) -> list[str]:
        taken = candidate.taken
        lines: list[str] = []
        if mode.loops and candidate.spends:
            spend = f"self.spent |= {self._bits(mode, (region, *self.flat.regions_around(region)))}"
            lines += [spend] if candidate.spends == "yes" else [f"if {candidate.spends}:", f"    {spend}"]
        missed = 0
        if mode.loops and not candidate.stays:
            missed = self._bits(mode, self._regions_in(self.flat.transition(taken[-1]).target))
        if missed:
            lines.append(f"self.spent |= {missed}  # what is entered now does not see it")
        if candidate.stays:
            lines += [*self._took(taken), *self._actions(region, taken[0])]
            return [*lines, *self._moved(mode, self._again_at(mode.event, leaf, candidate.spends == "yes"))]
        scope = self._scope(taken)
        lines += self._took(taken)
        lines += self._leave(region, scope, leaf, number)
        for step in taken:
            lines += self._actions(region, step)
        lines += self._enter(region, scope, self.flat.transition(taken[-1]).target, number)
        return [*lines, *self._moved(mode, self._again(mode.event, region, taken, candidate.spends == "yes"))]

    def _bits(self, mode: _Mode, regions: Iterable[int]) -> int:
        """The bits of those regions that wait for the event of a mode."""
        return sum(1 << number for number in regions if mode.event in self.flat.awaited.get(number, ()))

    def _moved(self, mode: _Mode, again: bool) -> list[str]:
        """What is noted when something was taken."""
        if mode.direct:
            return ["self.step()", "return True"] if again else ["return True"]
        flags = [*mode.flags, "again"] if mode.loops and again else mode.flags
        return [f"{' = '.join(flags)} = True"]

    def _leave(self, region: int, scope: str, leaf: Node, number: int | None) -> list[str]:
        """What is done as everything inside `scope` is left; None for a BASIC state that may be complete."""
        lines: list[str] = []
        if leaf.type is NodeType.BASIC and (self.options.watched or self.may_fail):
            lines += self._stop(region, leaf, number)
        elif leaf.type is NodeType.AND:
            for inner in self.flat.regions_of(leaf.label):
                lines += self._leave_region(inner.number)
        for node in (leaf, *self.flat.around(leaf.label)):
            if len(node.label) > len(scope) and node.type in _LEFT:
                lines += self._left(region, node)
        return lines

    def _left(self, region: int, node: Node) -> list[str]:
        """What is done when a state is left, after what is inside it."""
        lines: list[str] = []
        for transition in self.chart.exits_of(node.label):
            number = self.flat.transition_number[id(transition)]
            done = [*self._took((number,)), *self._actions(region, number)]
            lines += [f"# {self._place(number)}", *done] if done else []
        return lines

    def _took(self, taken: tuple[int, ...]) -> list[str]:
        """The call that tells of a transition that is taken."""
        return [f"self.took({', '.join(map(str, taken))})"] if self.options.watched else []

    def _leave_region(self, region: int) -> list[str]:
        """The call of the method that leaves a region, if there is anything to do."""
        name = f"_leave_{region}"
        if name not in self.leaving:
            label = self.flat.regions[region].label
            bodies: list[_Body] = []
            self.leaving[name] = False
            for leaf in self.flat.leaves(region):
                for number in range(self.flat.leaf[leaf.label], self._last(leaf) + 1):
                    lines = self._leave(region, label, leaf, number)
                    bodies.append(_Body(number, number, self._title(leaf, number), tuple(lines)))
            outermost = self._left(region, self.chart.node(label))
            lines = [*self._dispatch(region, bodies), *outermost]
            if lines:
                self.leaving[name] = True
                written = self._written(
                    f"{name}(self) -> None", f"Leave region {label}.", _indented(lines, 2)
                )
                self.methods.append(written)
        return [f"self.{name}()"] if self.leaving[name] else []

    # ---- entering --------------------------------------------------------------------------

    def _enter(self, region: int, scope: str, target: str, number: int | None = None) -> list[str]:
        """Enter a state inside `scope`, outermost first; `number` is that of the region so far."""
        path = self._path(scope, target)
        lines = [line for label in reversed(path) for line in self._on_entry(region, self.chart.node(label))]
        return [*lines, *self._enter_inside(region, target, number)]

    def _enter_inside(self, region: int, target: str, number: int | None = None) -> list[str]:
        """Make the leaf of a state active that has been entered, and the leaves of what is inside it.

        What says where the regions stand comes before all that may raise (`took`, the methods of activities):
        whatever these do, no region is without a leaf.
        """
        stands: list[str] = []
        lines: list[str] = []
        stack = [(region, target, number)]
        while stack:
            region, target, number = stack.pop()
            node = self.chart.node(target)
            if target == self.flat.regions[region].label and region:
                lines += self._begin_region(region)
            if node.type is NodeType.OR:
                start = self.chart.start_of(target)
                assert start is not None
                lines += self._on_entry(region, start)
                stack.append((region, start.label, number))
            elif target in self.rests.passed:
                lines += self._pass(region, node)
                stack.append((region, self.rests.passed[target].target, number))
            else:
                stands += self._stand(region, node, number)
                if target in self.flat.ending:
                    lines += [
                        f"self.{self._outcome(labels)} = None" for labels in self.asked if target in labels
                    ]
                if node.type is NodeType.BASIC and self.options.watched:
                    lines += self._begin(region, node)
                elif node.type is NodeType.AND:
                    inner = [(item.number, item.label, None) for item in self.flat.regions_of(target)]
                    stack += reversed(inner)
        times = [line for line in lines if line in self.times]
        return [*stands, *dict.fromkeys(times), *(line for line in lines if line not in self.times)]

    def _stand(self, region: int, leaf: Node, number: int | None) -> list[str]:
        """Note which leaf is active, where that is not known."""
        entered = self.flat.leaf[leaf.label]
        if self.flat.regions[region].size == 1 or entered == number:
            return []
        value = bool(entered) if region in self.truths else entered
        return [f"self.r{region} = {value}  # {self._title(leaf, entered)}"]

    def _pass(self, region: int, node: Node) -> list[str]:
        """Go on at once from a START or an END that is never rested at, into the target's surroundings."""
        way = self.rests.passed[node.label]
        step = self.flat.transition_number[id(way)]
        scope = self.chart.scope_of(way)
        actions = self._actions(region, step)
        note = [f"# {self._place(step)}"] if actions else []
        lines = [*self._took((step,)), *self._leave(region, scope, node, None), *note, *actions]
        for label in reversed(self._path(scope, way.target)):
            lines += self._on_entry(region, self.chart.node(label))
        return lines

    def _path(self, scope: str, target: str) -> list[str]:
        """A state and those around it that are inside `scope`, innermost first."""
        path = [target]
        while (parent := self.chart.node(path[-1]).parent) not in (scope, None):
            assert parent is not None
            path.append(parent)
        return path

    def _begin_region(self, region: int) -> list[str]:
        """What a region of an AND begins with: its copies of variables, no timers."""
        lines: list[str] = []
        for name, copies in self.copied.items():
            regions = self.flat.variable_regions[name]
            around = next(
                (item for item in self._with_around(region) if item != region and item in regions), None
            )
            if region in copies and around is not None:
                lines.append(f"self.{self._copy(name, region)} = {self.names[around][name]}")
        if region in self.timers:
            timers = [f"self.{self._timer(region, timer)}" for timer in self.timers[region]]
            lines.append(f"{' = '.join(timers)} = NEVER")
        return [*lines, *self._on_entry(region, self.chart.node(self.flat.regions[region].label))]

    def _on_entry(self, region: int, node: Node) -> list[str]:
        lines = []
        if node.label in self.flat.timed:
            lines.append(self._entered_now(node.label))
        for label, loop in self.flat.counted.items():
            if loop == node.label:
                lines.append(f"self.{self._count(label)} = 0")
        if node.label in self.flat.counted:
            lines.append(f"self.{self._count(node.label)} += 1")
        return lines

    def _entered_now(self, label: str) -> str:
        """What notes when a state was entered."""
        return f"self.{self._time(label)} = {_NOW}"

    def _begin(self, region: int, node: Node) -> list[str]:
        """The call that starts the activity of a state, with what it is given."""
        names = self._names(region, f"{region}_")
        self._asked_at(node.label, names)
        said = self.flat.said_of(node)
        types = {item.name: item.type for item in said.parameters} if said is not None else {}
        given = [
            converted(evaluate(item.value, names), item.value.type, types.get(item.name, item.value.type))
            for item in node.arguments
        ]
        return [f"self.{self._hook('start', node)}({', '.join([repr(node.label), *given])})"]

    def _stop(self, region: int, node: Node, number: int | None) -> list[str]:
        """The call that cuts an activity short, unless it has returned."""
        if number != self.flat.leaf[node.label]:
            return []
        stop = [f"self.{self._hook('stop', node)}({node.label!r})"] if self.options.watched else []
        if not self.may_fail:
            return stop
        if not stop:
            return ["if self.failures:", f"    self.failures.pop({node.label!r}, None)"]
        test = f"if not self.failures or self.failures.pop({node.label!r}, None) is None:"
        return [test, *_indented(stop, 1)]

    def _hooks(self) -> Iterator[list[str]]:
        """What subclasses override: `took`, and two methods for each activity."""
        if self.options.watched:
            yield [
                "    def took(self, *transitions: int) -> None:",
                '        """A transition is taken, given by the numbers of its parts in `TRANSITIONS`."""',
            ]
        activities = {node.activity: node for node in self.chart.nodes if node.activity is not None}
        for node in activities.values() if self.options.watched else ():
            for word, document in (("start", "begins"), ("stop", "is cut short")):
                told = f"{docstring(node.activity or '')} {document}, the activity of the state `label`."
                parameters = self._parameters(node) if word == "start" else []
                signature = ", ".join(["self", "label: str", *parameters])
                yield [f"    def {self._hook(word, node)}({signature}) -> None:", f'        """{told}"""']

    def _parameters(self, node: Node) -> list[str]:
        """What the method of an activity is given: by the declared types, or by those of the values."""
        said = self.flat.said_of(node)
        declared = {item.name: item.type for item in said.parameters} if said is not None else {}
        kinds = ((item.name, declared.get(item.name, item.value.type)) for item in node.arguments)
        return [f"{name}: {'Any' if kind.element else self._python(kind)}" for name, kind in kinds]

    def _hook(self, word: str, node: Node) -> str:
        """The method by which an activity is told something."""
        return f"{word}_{node.activity}"

    # ---- actions ---------------------------------------------------------------------------

    def _actions(self, region: int, number: int) -> list[str]:
        # Machine code has one type for a local: the condition of this transition has its own.
        method = Method(self._names(region, f"e{region}_{number}_"))
        for action in self.flat.transition(number).expression.actions:
            self._action(method, region, number, action)
        if self._wakes(region, number):
            method.add(0, "self.woken = True")
        return method.lines

    def _wakes(self, region: int, number: int) -> bool:
        """Whether a transition writes what a condition of another region reads that it does not enter."""
        transition = self.flat.transition(number)
        return any(
            reader != region
            and (transition.kind is TransitionKind.ON or region not in self.flat.regions_around(reader))
            for name in _written_by(transition.expression)
            for reader in self.flat.wakes.get(name, ())
        )

    def _action(self, method: Method, region: int, number: int, action: Action) -> None:
        match action:
            case Assign(target=VariableValue() as target, value=value):
                self._computed(
                    method,
                    0,
                    number,
                    (value,),
                    lambda piece: self._assignment(region, target, value, piece),
                )
            case Evaluate(value=value):
                self._computed(method, 0, number, (value,), lambda piece: [piece.code])
            case StartTimer(timer=timer, duration=duration):
                place = f"self.{self._timer(region, timer)}"
                self._computed(
                    method, 0, number, (duration,), lambda piece: [f"{place} = {_NOW} + {piece.code}"]
                )
            case _:
                raise AssertionError(f"{action} is refused")

    def _assignment(self, region: int, target: VariableValue, value: Value, piece: Piece) -> list[str]:
        code = converted(piece, value.type, target.type)
        if target.name not in self.copied:
            place = self._place_on_board(self._on_board(target.name))
            return [f"{place} = {code}", f"{_WROTE}{place}"]
        copy = f"self.{self._copy(target.name, region)}"
        return [
            f"{copy} = {code}",
            f"self.writes = ({region}, {self._on_board(target.name)!r}, {copy}, self.writes)",
        ]


_MOVED = "moved"
"""The local that says whether anything has moved."""

_UNLESS = f"if not {_BB}.still_"
"""How the test begins whether many conditions have to be looked at."""

_WROTE = "@wrote "
"""Stands where something on the blackboard was written, until it is known which conditions read it."""
_NOTHING = ["        return False"]

_FOLLOWS = ("if self.woken:", "    self._follow()")
"""What is done after a step in which a region may have written what a condition of another reads."""


def _only(test: str, body: _Body) -> list[str]:
    """A body that is the only one of two with anything in it.

    If all of it is for when something has changed, that is asked first: it is the rarer thing.
    """
    head, *rest = body.lines
    if head.startswith(_UNLESS) and all(line.startswith(" ") for line in rest):
        return [head, f"    if {test}:  # {body.title}", *_indented(rest, 1)]
    return [f"if {test}:  # {body.title}", *_indented(body.lines, 1)]


def _merged(bodies: Iterable[_Body]) -> list[_Body]:
    """Bodies, neighbours that do the same as one."""
    found: list[_Body] = []
    for body in bodies:
        if found and found[-1].lines == body.lines:
            found[-1] = _joined(found[-1], body)
        else:
            found.append(body)
    return found


def _joined(one: _Body, other: _Body) -> _Body:
    title = f"{one.title.split(' to ')[0]} to {other.title.split(' to ')[-1]}"
    return _Body(one.first, other.last, title, one.lines)


def _indented(lines: Iterable[str], depth: int) -> list[str]:
    return ["    " * depth + line for line in lines]


def _word(mode: _Mode) -> str:
    """What methods of a mode are called by."""
    return {STEP: "step", OTHER: "other"}.get(mode.event, mode.event)


def _said(mode: _Mode) -> str:
    """What the docstrings of methods of a mode begin with."""
    return "any other event" if mode.event == OTHER else _word(mode)


def _leaf_name(node: Node) -> str:
    """What a leaf is called; what has no name, by what it is."""
    return node.name if node.name.isidentifier() else node.type.value


def _name_or_type(node: Node) -> str:
    """The name of a leaf, or what it is in brackets."""
    name = _leaf_name(node)
    return name if name == node.name else f"({name})"


def _first(words: Sequence[str]) -> list[str]:
    """Not too many words for a line, with how many there are besides."""
    more = len(words) - LEGEND
    return [*words[:LEGEND], *([f"and {more} more"] if more > 0 else [])]


def _naturally(name: str) -> list[tuple[int, str]]:
    return natural((name, "", None))


def _tuple(names: Iterable[str]) -> str:
    """Names as a tuple of texts, in order."""
    found = [f'"{name}"' for name in sorted(names, key=_naturally)]
    return f"({', '.join(found)}{',' if len(found) == 1 else ''})"


def _returns(lines: Sequence[str]) -> bool:
    """Whether the lines always end the method: the last of them does, or all branches that it is in do."""
    waiting = [lines]
    while waiting:
        lines = [line for line in waiting.pop() if not line.lstrip().startswith("#")]
        if lines and lines[-1].startswith("return "):
            continue
        heads = [place for place, line in enumerate(lines) if not line.startswith(" ")]
        begin = next((n for n in range(len(heads) - 1, -1, -1) if lines[heads[n]].startswith("if ")), None)
        if begin is None or not lines[heads[-1]].startswith("else:"):
            return False
        ends = [*heads[begin + 1 :], len(lines)]
        for head, end in zip(heads[begin:], ends, strict=True):
            waiting.append([line[4:] for line in lines[head + 1 : end]])
    return True


def _paths(way: Way) -> Iterator[tuple[int, ...]]:
    """The compound transitions of a way, as the numbers of their segments."""
    if not way.branches:
        yield (way.number,)
    for branch in way.branches:
        for path in _paths(branch):
            yield (way.number, *path)


def _may_do(tests: Iterable[str]) -> bool:
    """Whether to test does anything: it may be told that a condition has failed, or chance goes on."""
    return any("self._holds_" in test or "self.random()" in test for test in tests)


_LEFT = (NodeType.BASIC, NodeType.OR, NodeType.AND)
"""What may have an `exit`."""


def _written_by(expression: TransitionExpression) -> set[str]:
    """The variables that an expression assigns."""
    return {
        action.target.name
        for action in expression.actions
        if isinstance(action, Assign) and isinstance(action.target, VariableValue)
    }


__all__ = ["PlainCode", "PlainOptions", "generate_plain"]
