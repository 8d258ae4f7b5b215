"""What a plain class says of itself: its slots, its leaves, its blackboard, and what programs override."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence

from aseme_dsl.amola.expression import VariableValue, walk
from aseme_dsl.amola.statechart import State, StateType
from aseme_dsl.codegen.code.face import docstring, natural
from aseme_dsl.codegen.code.tree import (
    NONE,
    NOW,
    TRUE,
    Choice,
    Compared,
    Const,
    Expr,
    Field,
    Infix,
    Name,
    Return,
    Set,
    Statement,
    compared,
    own,
    when,
)
from aseme_dsl.codegen.plain.names import Method, Parameter, PlainNames
from aseme_dsl.codegen.program import sizes
from aseme_dsl.codegen.program.circling import circling
from aseme_dsl.codegen.program.events import STEP
from aseme_dsl.codegen.program.moves import assigned
from aseme_dsl.records import dataclass


@dataclass(frozen=True, slots=True)
class Slot:
    """What an instance keeps: its name, its type, and what it is made with, if that is known then.

    `declared`: its type stands in the class.
    """

    name: str
    kind: str
    initial: str = ""
    declared: bool = True
    needs: tuple[str, ...] = ()
    """What its type and its first value need of other modules."""
    copies: str = ""
    """The variable that it is a copy of."""

    @property
    def is_truth(self) -> bool:
        """Whether it is true or false."""
        return self.kind == "bool"


@dataclass(frozen=True, slots=True)
class Attribute:
    """Something that the class says of the statechart: a value, or rows of texts.

    `kind` is what a mapping is from and to.
    """

    name: str
    value: object = None
    kind: str = ""
    rows: tuple[str, ...] | None = None

    def lines(self, kind: str = "") -> list[str]:
        """The lines in the class; `kind` is how the type is written."""
        if self.rows is None:
            return [f"    {self.name}{kind} = {self.value!r}"]
        return [f"    {self.name} = (", *(f"        {row!r}," for row in self.rows), "    )"]


class Head:
    """The lines of the class before its methods; those of its blackboard; and the methods to override."""

    def __init__(self, names: PlainNames, gates: Iterable[Field], *, spends: bool) -> None:
        self._names = names
        self._flat = names.flat
        self._chart = names.chart
        self._gates = tuple(gates)
        self._spends = spends

    # ---- slots -----------------------------------------------------------------------------

    def slots(self) -> Iterator[Slot]:
        """What the class keeps, besides the blackboard and the numbers of its regions."""
        names = self._names
        for time in self._times():
            yield Slot(time, "int")
        if names.is_timed:
            yield Slot("now", "int", "0", declared=False)
        for region, timers in names.registers.timers.items():
            for timer in timers:
                yield Slot(names.timer(region, timer).name, "int", "NEVER", declared=False, needs=("NEVER",))
        for labels in names.registers.outcomes:
            yield Slot(names.outcome(labels).name, "str | None", "None", declared=False)
        if names.may_fail:
            yield Slot("failures", "dict[str, str] | None", "None", declared=False)
        if names.has_chance:
            yield Slot("chance", "Random | None", "None", declared=False, needs=("Random",))
        if names.copied:
            kind = "tuple[int, str, Any, Any] | None"
            yield Slot("writes", kind, "None", declared=False, needs=("Any",))
        if names.faults:
            yield Slot("faulty", "tuple[int, ...]", "()", declared=False)
        for label in names.registers.counted:
            yield Slot(names.count(label).name, "int")
        for name, copies in names.copied.items():
            kind = names.held(names.variables[name].type)
            for region in copies:
                yield Slot(names.copy(name, region).name, kind, copies=name)
        if self._spends:
            yield Slot("spent", "int")
        if names.uses.wakes:
            yield Slot("woken", "bool")

    def regions(self) -> list[Slot]:
        """The numbers of the regions."""
        truths = self._names.truths
        return [
            Slot(f"r{region.number}", "bool" if region.number in truths else "int")
            for region in self._flat.regions
            if region.size > 1
        ]

    def _times(self) -> list[str]:
        return sorted({self._names.time(label).name for label in self._names.registers.timed}, key=natural)

    # ---- the class -------------------------------------------------------------------------

    def lines(self) -> list[str]:
        """The class, up to its methods."""
        names = self._names
        regions = self.regions()
        slots = list(self.slots())
        lines = [
            f"class {names.class_name}(Plain):",
            f'    """The statechart {docstring(self._chart.name)} of {self._chart.system}."""',
            "",
            *(f"    # {line}" for line in self._legend()),
            f"    __slots__ = {_tuple(['bb', *(slot.name for slot in (*regions, *slots))])}",
            "",
            f"    EVENTS = {_tuple(sorted(event for event in names.events.modes if event != STEP))}",
        ]
        for attribute in self.attributes():
            kind = f": ClassVar[Mapping[{attribute.kind}]]" if attribute.kind else ""
            if kind:
                names.used |= {"ClassVar", "Mapping"}
            lines += attribute.lines(kind)
        lines += ["", f"    bb: {names.board_type()}"]
        lines += [f"    {slot.name}: {slot.kind}" for slot in (*regions, *slots) if slot.declared]
        lines += ["", f"    def __init__(self, bb: {names.board_type()} | None = None) -> None:"]
        lines.append(f"        self.bb = {names.board_name}() if bb is None else bb")
        made = [slot for slot in slots if not slot.declared]
        lines += [
            f"        self.{slot.name}{'' if slot.name == NOW.name else f': {slot.kind}'} = {slot.initial}"
            for slot in made
        ]
        names.used |= {name for slot in made for name in slot.needs}
        if names.uses.wakes:
            lines.append("        self.woken = False")
        first = self._unstarted()
        if first and not names.options.translated:
            names.used.add("UNSTARTED")
            lines.append(f"        {' = '.join(f'self.{name}' for name in first)} = UNSTARTED")
        return lines

    def _unstarted(self) -> list[str]:
        """The slots that hold `UNSTARTED` before the start, and never afterwards."""
        names = self._names
        regions = [region for region in self._flat.regions if region.size > 1]
        first = [f"r{region.number}" for region in regions if self._is_around_all(region.number)]
        always = (
            names.time(label).name
            for label in sorted(names.registers.timed)
            if names.is_active(self._chart.node(label)) == TRUE
        )
        return [*first, *dict.fromkeys(always)]

    def _is_around_all(self, region: int) -> bool:
        """Whether a region is active in every configuration."""
        parent = self._chart.node(self._flat.regions[region].label).parent
        return parent is None or self._names.is_active(self._chart.node(parent)) == TRUE

    def attributes(self) -> Iterator[Attribute]:
        """What the class says of the statechart."""
        names, flat = self._names, self._flat
        yield Attribute("NAMES", rows=tuple(self._of_leaves(_name_or_type)))
        yield Attribute("LEAVES", rows=tuple(self._of_leaves(lambda node: node.label)))
        inner = {
            (region.number, flat.leaf[leaf.label]): tuple(r.number for r in flat.regions_of(leaf.label))
            for region in flat.regions
            for leaf in flat.leaves(region.number)
            if leaf.type is StateType.AND
        }
        if inner:
            yield Attribute("INNER", inner, "tuple[int, int], tuple[int, ...]")
        here = [node for node in self._chart.states if node.label in flat.leaf]
        running = {
            node.label: (flat.region_number[node.label], flat.leaf[node.label])
            for node in here
            if node.label in names.rests.completing and not node.waits
        }
        if running:
            yield Attribute("RUNNING", running, "str, tuple[int, int]")
        ends = {
            node.label: said.ends
            for node in here
            if (said := names.registers.said_of(node)) is not None and said.ends
        }
        if ends:
            yield Attribute("ENDS", ends, "str, tuple[str, ...]")
        if messages := tuple((slot, *key) for key, (slot, _) in names.message_slots().items()):
            yield Attribute("MESSAGES", messages)
        if renamed := names.renamed():
            yield Attribute("VARIABLES", renamed, "str, str")
        if names.options.watched:
            every = range(len(self._chart.transitions))
            yield Attribute("TRANSITIONS", rows=tuple(map(names.place, every)))
        if names.uses.wakes:
            yield Attribute("WAKING", rows=tuple(map(names.place, self._waking())))
        if numbers := circling(self._chart):
            yield Attribute("CIRCLING", rows=tuple(map(names.place, numbers)))
        end = self._chart.end_of(self._chart.root.label)
        if end is not None and end.label in flat.leaf:
            yield Attribute("END", flat.leaf[end.label])

    def _waking(self) -> Iterator[int]:
        """The transitions that write or ask for a variable by which regions wake each other."""
        wakes = self._names.uses.wakes
        for number, transition in enumerate(self._chart.transitions):
            guard = transition.expression.guard
            values = walk(guard) if guard is not None else ()
            read = {value.name for value in values if isinstance(value, VariableValue)}
            if not wakes.keys().isdisjoint((*read, *assigned(transition.expression))):
                yield number

    def _of_leaves(self, word: Callable[[State], str]) -> list[str]:
        """A word for each of a region's leaves by their numbers."""
        return [
            " ".join(
                word(node)
                for node in self._flat.leaves(region.number)
                for _ in range(self._names.rests.width(node))
            )
            for region in self._flat.regions
        ]

    def _legend(self) -> Iterator[str]:
        """What the slots mean, for people who look at an instance."""
        names, flat = self._names, self._flat
        for region in flat.regions:
            if region.size > 1:
                shown = [
                    f"{number} {_leaf_name(leaf)}{' (complete)' * (number > flat.leaf[leaf.label])}"
                    for leaf in flat.leaves(region.number)
                    for number in range(flat.leaf[leaf.label], names.last(leaf) + 1)
                ]
                where = self._called(region.label)
                yield f"r{region.number}: what is active in {where}: {', '.join(_first(shown))}"
        for time in self._times():
            shown = [
                self._called(label)
                for label in sorted(names.registers.timed)
                if names.time(label).name == time
            ]
            yield f"{time}: when (ns) it was entered: {', '.join(_first(shown))}"
        for number, timers in names.registers.timers.items():
            for timer in timers:
                slot = names.timer(number, timer).name
                yield f"{slot}: when (ns) the timer {timer} of region {number} runs out"
        for labels in names.registers.outcomes:
            states = " or ".join(_first(labels))
            yield f"{names.outcome(labels).name}: how the activity of {states} has ended"
        for label in names.registers.counted:
            yield f"{names.count(label).name}: how often {self._called(label)} was entered"
        for name, copies in names.copied.items():
            for number in copies:
                slot = names.copy(name, number).name
                yield f"{slot}: {name} during a step, as region {number} sees it"
        if self._spends:
            yield "spent: the regions without the event of this step any more (1 region 0, 2 region 1, 4 ...)"

    def _called(self, label: str) -> str:
        """A state for people: its label and what it is called."""
        return f"{label} {_leaf_name(self._chart.node(label))}"

    # ---- the blackboard --------------------------------------------------------------------

    def board(self) -> list[str]:
        """The class of the blackboard, or the function that makes a dictionary."""
        names = self._names
        values = [
            (names.on_board(v.name), names.held(v.type), names.initial(v)) for v in self._chart.variables
        ]
        for slot, message in names.message_slots().values():
            names.messages.add(message)
            values.append((slot, f"{names.imported(message)} | None", "None"))
        called = [f"The variable `{name}` is `{other}`." for name, other in names.renamed().items()]
        knows = " ".join([f"What {docstring(self._chart.name)} knows.", *called])
        document = f'"""{knows}"""'
        if names.options.mapping:
            entries = ", ".join(f"{name!r}: {initial}" for name, _, initial in values)
            return [
                f"def {names.board_name}() -> dict[str, Any]:",
                f"    {document}",
                f"    return {{{entries}}}",
            ]
        lines = [f"class {names.board_name}:", f"    {document}", ""]
        gates = [gate.name for gate in self._gates]
        slots = [*(name for name, _, _ in values), *gates, *(["tracked"] if gates else [])]
        lines.append(f"    __slots__ = {_tuple(slots)}")
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
            opened = f"        self.{' = self.'.join(gates)} = False"
            lines += [opened, "", "    def changed(self) -> None:"]
            lines += ['        """Something was written: look at all conditions again."""', opened]
        lines += ["", "    def __repr__(self) -> str:"]
        lines.append(f'        return {"f" * bool(shown)}"<{names.board_name}{shown}>"')
        return lines

    # ---- what programs ask and override ----------------------------------------------------

    def due(self) -> Iterator[Method]:
        """The method that says when time alone may matter, where it may."""
        names = self._names
        if not names.is_timed:
            return
        now, best, at = NOW, Name("best"), Name("at")
        body: list[Statement] = [Set((now,), own("now")), Set((best,), Name("NEVER"))]
        for wait in names.registers.waits:
            found = self._flat.range.get(wait.source)
            if found is None:
                continue
            region = self._flat.region_number[wait.source]
            where = names.is_inside(region, *found)
            moment: Expr = names.timer(region, wait.name)
            if wait.kind == "after":
                moment = Infix("+", names.time(wait.source), Const(wait.amount))
            earlier = Compared(now, (("<", at), ("<", best)))
            look = (Set((at,), moment), when(earlier, Set((best,), at)))
            body += look if where == TRUE else (when(where, *look),)
        never = compared(best, "==", Name("NEVER"))
        body.append(Return(Choice(never, NONE, best)))
        document = "The next moment (ns) at which time alone may enable something that is waited for."
        yield Method("due", "int | None", document, tuple(body))

    def hooks(self) -> Iterator[Method]:
        """What subclasses override: `took`, and two methods for each activity."""
        if not self._names.options.watched:
            return
        took = "A transition is taken, given by the numbers of its parts in `TRANSITIONS`."
        yield Method("took", "None", took, (), (("*transitions", "int"),))
        performing = (node for node in self._chart.states if not node.waits)
        activities = {node.activity: node for node in performing if node.activity is not None}
        for node in activities.values():
            for word, document in (("start", "begins"), ("stop", "is cut short")):
                told = f"{docstring(node.activity or '')} {document}, the activity of the state `label`."
                given = tuple(self._parameters(node)) if word == "start" else ()
                yield Method(f"{word}_{node.activity}", "None", told, (), (("label", "str"), *given))

    def _parameters(self, node: State) -> Iterator[Parameter]:
        """What the method of an activity is given: by the declared types, or by those of the values."""
        declared = self._names.registers.parameters(node)
        for item in node.arguments:
            kind = declared.get(item.name, item.value.type)
            name = "Any" if kind.element else self._names.python(kind)
            self._names.used.add(name)
            yield item.name, name


def _leaf_name(node: State) -> str:
    """What a leaf is called; what has no name, by what it is."""
    return node.name if node.name.isidentifier() else node.type.value


def _name_or_type(node: State) -> str:
    """The name of a leaf, or what it is in brackets."""
    name = _leaf_name(node)
    return name if name == node.name else f"({name})"


def _first(words: Sequence[str]) -> list[str]:
    """Not too many words for a line, with how many there are besides."""
    more = len(words) - sizes.LEGEND
    return [*words[: sizes.LEGEND], *([f"and {more} more"] if more > 0 else [])]


def _tuple(names: Iterable[str]) -> str:
    """Names as a tuple of texts, in order."""
    found = [f'"{name}"' for name in sorted(names, key=natural)]
    return f"({', '.join(found)}{',' if len(found) == 1 else ''})"


__all__ = ["Attribute", "Head", "Slot"]
