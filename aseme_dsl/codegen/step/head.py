"""What the class says of the statechart, and its attributes."""

from __future__ import annotations

from collections.abc import Iterable

from aseme_dsl.amola.expression import (
    Publish,
    Send,
)
from aseme_dsl.amola.statechart import StateType
from aseme_dsl.codegen.code.face import key_of, natural
from aseme_dsl.codegen.step.boards import Boards, saving
from aseme_dsl.codegen.step.names import Part, StepNames
from aseme_dsl.runtime.chart.state import COMMON


class Head(Part):
    """What the class says of the statechart, and its attributes."""

    def __init__(self, names: StepNames, boards: Boards) -> None:
        super().__init__(names)
        self.boards = boards

    def lines(self) -> list[str]:
        """The class up to its methods."""
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
        attributes += [(self.names.time_name(label), "int", "0") for label in sorted(self.registers.timed)]
        for number in (n for numbers in self.flat.staying.values() for n in numbers):
            if self.names.has_mark(number):
                self.names.used.add("Seen")
                attributes.append((self.names.mark(number), "Seen | None", "None"))
            if self.names.has_time(number):
                attributes.append((self.names.past(number), "int", "-1"))
        attributes += [
            (self.names.kept(node), "dict[int, int] | None", "None") for node in self.history.resumed
        ]
        attributes += [(self.names.count_name(label), "int", "0") for label in self.registers.counted]
        for variable in self.chart.variables:
            attributes += [
                (copy, self.names.held(variable.type), self.names.initial(variable))
                for copy in self.names.copies(variable.name)
            ]
        names = ", ".join(f'"{name}"' for name, _, _ in sorted(attributes, key=lambda item: natural(item[0])))
        running = {
            node.label: (f"r{region.number}", f"k{region.number}", self.flat.leaf[node.label])
            for region in regions
            for node in self.flat.leaves(region.number)
            if node.type is StateType.BASIC
        }
        variables = {v.name: tuple(self.names.copies(v.name)) for v in self.chart.variables}
        times = {label: self.names.time_name(label) for label in sorted(self.registers.timed)}
        lines = [
            f"class {self.names.class_name}(Chart):",
            f'    """Runs the statechart {self.chart.name} of {self.chart.system}."""',
            "",
            f"    __slots__ = ({names},)",
            "",
            "    PLAN = PLAN",
            f"    REGIONS = {tuple(region.label for region in regions)!r}",
            f"    READERS: ClassVar[Mapping[str, tuple[int, ...]]] = {self.boards.readers()!r}",
            f"    RUNNING: ClassVar[Mapping[str, tuple[str, str, int]]] = {running!r}",
            f"    VARIABLES: ClassVar[Mapping[str, tuple[str, ...]]] = {variables!r}",
            f"    MESSAGES: ClassVar[Mapping[str, Any]] = {self._message_classes()}",
            f"    TIMES: ClassVar[Mapping[str, str]] = {times!r}",
            *self._expiring(),
            *self._waiting(),
            *self._deadlines(),
            *self._wakes(),
            *self._missed(),
            *self._marks(),
            *self._memories(),
            *self._part_timers(),
            *self._abandons(),
            *self._counts(),
            "    LEAVES: ClassVar[tuple[tuple[str, ...], ...]] = (",
            *(f"        {labels!r}," for labels in self._leaf_labels()),
            "    )",
            "",
            "    def __init__(self, agent: str) -> None:",
            "        super().__init__(agent)",
        ]
        lines += [f"        self.{name}: {kind} = {value}" for name, kind, value in attributes]
        agents = [agent for team in self.names.system.teams for agent in team.agents]
        if any(agent.settings for agent in agents if agent.role == self.chart.name):
            lines.append("        self.settle()")
        kept = {self.names.kept(node) for node in self.history.resumed}
        boards = {f"b{region.number}" for region in regions}
        own = sorted({name for name, _, _ in attributes} - kept - boards, key=natural)
        said = ("values", "What the places hold.", "set_values", "Let the places hold these again.")
        return [*lines, *saving([*COMMON, *own], *said)]

    def _expiring(self) -> list[str]:
        return ["    EXPIRING = True"] if self.boards.expire() else []

    def _waiting(self) -> list[str]:
        found = sorted(node.label for node in self.chart.states if node.waits)
        return [f"    WAITING: ClassVar[frozenset[str]] = frozenset({found!r})"] if found else []

    def _deadlines(self) -> list[str]:
        found = self.registers.deadlines
        return [f"    WITHIN: ClassVar[Mapping[str, int]] = {found!r}"] if found else []

    def _wakes(self) -> list[str]:
        """The copies of variables whose writers wake other regions, and the leaves at which they are read."""
        found: dict[str, tuple[tuple[str, str, tuple[tuple[int, int], ...]], ...]] = {}
        for name, readers in self.uses.wakes.items():
            found[name] = tuple(
                (self.names.variable(name, region), f"r{region}", self._leaves_at(sources))
                for region, sources in readers.items()
            )
        kind = "tuple[tuple[str, str, tuple[tuple[int, int], ...]], ...]"
        return [f"    WAKES: ClassVar[Mapping[str, {kind}]] = {found!r}"] if found else []

    def _missed(self) -> list[str]:
        """Of signals whose absence may enable something: the regions, and the leaves at which it may."""
        found: dict[str, tuple[tuple[int, str, tuple[tuple[int, int], ...]], ...]] = {}
        for channel, readers in self.uses.missed.items():
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
                self.names.mark(number) if self.names.has_mark(number) else "",
                self.names.past(number) if self.names.has_time(number) else "",
            )
            for numbers in self.flat.staying.values()
            for number in numbers
            if self.names.has_mark(number) or self.names.has_time(number)
        }
        return [f"    MARKS: ClassVar[Mapping[int, tuple[str, str]]] = {marks!r}"] if marks else []

    def _memories(self) -> list[str]:
        kept = {node.label: self.names.kept(node) for node in self.history.resumed}
        return [f"    KEPT: ClassVar[Mapping[str, str]] = {kept!r}"] if kept else []

    def _part_timers(self) -> list[str]:
        """The timers that end with a protocol branch, and stand still while it is suspended."""
        found = {
            branch.label: (f"b{self.flat.region_number[branch.label]}", names)
            for branch in self.flat.branches
            if (names := self.registers.started_in(branch.label))
        }
        kind = "tuple[str, tuple[str, ...]]"
        return [f"    PART_TIMERS: ClassVar[Mapping[str, {kind}]] = {found!r}"] if found else []

    def _abandons(self) -> list[str]:
        found = {label: f"_abandon_{key_of(label)}" for label in self.chart.abandons}
        return [f"    ABANDON: ClassVar[Mapping[str, str]] = {found!r}"] if found else []

    def _counts(self) -> list[str]:
        found = {label: self.names.count_name(label) for label in self.registers.counted}
        return [f"    COUNTS: ClassVar[Mapping[str, str]] = {found!r}"] if found else []

    def _message_classes(self) -> str:
        found: dict[str, str] = {}
        for transition in self.chart.transitions:
            for action in transition.expression.actions:
                if isinstance(action, Publish):
                    found[str(action.channel)] = action.channel.message
                elif isinstance(action, Send):
                    found[action.message] = action.message
        self.names.published |= set(found.values())
        return "{" + ", ".join(f"{key!r}: {found[key]}" for key in sorted(found)) + "}"

    def _leaf_labels(self) -> list[tuple[str, ...]]:
        """The labels of each region's leaves by their numbers."""
        return [
            tuple(
                label
                for node in self.flat.leaves(region.number)
                for label in [node.label] * (2 if node.type is StateType.BASIC else 1)
            )
            for region in self.flat.regions
        ]


__all__ = ["Head"]
