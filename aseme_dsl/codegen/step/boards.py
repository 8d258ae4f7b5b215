"""The blackboards of regions, and what these read."""

from __future__ import annotations

from collections.abc import Sequence

from aseme_dsl.amola.statechart import Region
from aseme_dsl.codegen.code.face import natural
from aseme_dsl.codegen.program.uses import retention
from aseme_dsl.codegen.step.names import Part


class Boards(Part):
    """The blackboards of regions, and what these read."""

    def readers(self) -> dict[str, tuple[int, ...]]:
        """The regions that read each channel."""
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

    def expire(self) -> bool:
        """Whether any region reads signals that expire."""
        return any(self._expiring(self._reads(region.number)) for region in self.flat.regions)

    def _expiring(self, reads: tuple[str, ...]) -> dict[str, int]:
        """After how many ns the signals of these channels expire, of those that do."""
        rules = (rules for topic in self.names.system.topics for rules in topic.channels)
        found = {str(item.channel): item.expires for item in rules if item.expires is not None}
        return {channel: found[channel] for channel in reads if channel in found}

    def board(self, number: int) -> list[str]:
        """The class of a region's blackboard."""
        region = self.flat.regions[number]
        slots = self.names.slots[number]
        reads = self._reads(number)
        rules = {str(r.channel): r for topic in self.names.system.topics for r in topic.channels}
        queued = sorted(channel for channel in reads if channel in rules and rules[channel].queued)
        table: dict[str, tuple[tuple[str, str | None], ...]] = {}
        typed: list[tuple[str, str]] = []
        timed: list[str] = []
        messages = {str(item.channel): item.channel.message for item in self.uses.members.get(number, ())}
        for (channel, host), slot in sorted(slots.items(), key=lambda item: item[1]):
            table[channel] = (*table.get(channel, ()), (slot, host))
            message = messages[channel]
            self.names.messages.add(message)
            typed.append((slot, f"{message} | None"))
            if (number, channel, host) in self.uses.aged:
                timed.append(slot)
                typed.append((f"{slot}_time", "int"))
        names = [name for name, _ in typed]
        kept = {
            c: n for c, n in sorted(retention(self.names.system, self.chart, self.uses).items()) if c in reads
        }
        lines = [
            "",
            "",
            f"class Board{number}(Board):",
            f'    """What region {region.label} knows."""',
            "",
            "    __slots__ = ("
            + "".join(f'"{name}", ' for name in sorted(names, key=natural)).rstrip()
            + ")",
            f"    CHANNELS = frozenset({list(reads)!r})",
        ]
        if queued:
            lines.append(f"    QUEUED = frozenset({queued!r})")
        expiring = self._expiring(reads)
        if expiring:
            lines.append(f"    EXPIRES: ClassVar[Mapping[str, int]] = {expiring!r}")
        if kept:
            lines.append(f"    RETENTION: ClassVar[Mapping[str, int]] = {kept!r}")
        if table:
            lines.append(f"    SLOTS: ClassVar[Mapping[str, tuple[tuple[str, str | None], ...]]] = {table!r}")
        if timed:
            lines.append(f"    TIMED = frozenset({sorted(timed)!r})")
        lines += [f"    {name}: {kind}" for name, kind in typed]
        return lines + saving(sorted(names, key=natural), "shown", "", "show", "") if names else lines


def saving(names: Sequence[str], read: str, said: str, write: str, done: str) -> list[str]:
    """Two methods that give the attributes as one value, and put it back: several times as fast as a loop."""
    places = ", ".join(f"self.{name}" for name in names) + ("," if len(names) == 1 else "")
    return [
        "",
        f"    def {read}(self) -> tuple[object, ...]:",
        *([f'        """{said}"""'] if said else []),
        f"        return ({places})",
        "",
        f"    def {write}(self, values: tuple[Any, ...]) -> None:",
        *([f'        """{done}"""'] if done else []),
        f"        ({places}) = values",
    ]


__all__ = ["Boards", "saving"]
