"""What the runtime asks of the class."""

from __future__ import annotations

from aseme_dsl.amola.statechart import StateType
from aseme_dsl.codegen.program.registers import Wait
from aseme_dsl.codegen.step.events import mail_kind
from aseme_dsl.codegen.step.names import Method, Part


class Frame(Part):
    """What the runtime asks of the class."""

    def write(self) -> None:
        """Write its methods."""
        regions = self.flat.regions
        plain = self.names.writing(0)
        plain.add(2, "return self._region_0(self.now)")
        self.names.method("round(self) -> bool", "One round over all regions.", plain)
        leave = self.names.writing(0)
        leave.add(2, "self._leave_0()")
        self.names.method("leave(self) -> None", "Leave everything.", leave)
        end = self.chart.end_of(self.chart.root.label)
        finished = self.names.writing(0)
        finished.add(2, f"return self.r0 == {self.flat.leaf[end.label]}" if end else "return False")
        self.names.method("is_finished(self) -> bool", "Whether the root's END is active.", finished)
        boards = self.names.writing(0)
        parts = ["self.b0"]
        parts += [f"self.b{r.number} if self.r{r.number} >= 0 else None" for r in regions[1:]]
        boards.add(2, f"return ({', '.join(parts)},)")
        self.names.method(
            "boards(self) -> tuple[Board | None, ...]", "The blackboard of each region.", boards
        )
        every = self.names.writing(0)
        every.add(2, f"return ({', '.join(f'self.b{region.number}' for region in regions)},)")
        self.names.method("all_boards(self) -> tuple[Board, ...]", "The blackboards of all regions.", every)
        self._due()
        self._configuration()

    def _configuration(self) -> None:
        method = self.names.writing(0)
        numbers = ", ".join(f"self.r{region.number}" for region in self.flat.regions)
        method.add(
            2,
            f"numbers = ({numbers},)",
            "return tuple(labels[n] for labels, n in zip(self.LEAVES, numbers, strict=True) if n >= 0)",
        )
        self.names.method(
            "configuration(self) -> tuple[str, ...]", "The labels of the active leaves.", method
        )

    def _due(self) -> None:
        method = self.names.writing(0)
        if not self.registers.waits:
            method.add(2, "return None")
        else:
            self.names.used.add("NEVER")
            method.add(2, "best = NEVER")
            for wait in self.registers.waits:
                self._wait(method, wait)
            method.add(2, "return None if best == NEVER else best")
        self.names.method(
            "due(self, now: int) -> int | None", "The next moment at which time alone may matter.", method
        )

    def _wait(self, method: Method, wait: Wait) -> None:
        region = self.flat.region_number[wait.source]
        if wait.source in self.flat.leaf:
            number = self.flat.leaf[wait.source]
            has_two = self.chart.node(wait.source).type is StateType.BASIC and wait.kind != "within"
            first, last = number, number + 1 if has_two else number
        else:
            first, last = self.flat.range[wait.source]
        where = f"self.r{region} == {first}" if first == last else f"{first} <= self.r{region} <= {last}"
        method.add(2, f"if {where}:")
        depth = 3
        board = f"self.b{region}"
        match wait.kind:
            case "after" | "within":
                method.add(depth, f"at = self.{self.names.time_name(wait.source)} + {wait.amount}")
            case "timer":
                method.add(depth, f"at = {board}.timers.get({wait.name!r}, NEVER)")
            case "sent":
                branch = self.chart.branch_of(wait.source)
                kinds = tuple(mail_kind(event) for event in wait.events)
                method.add(depth, f"for mail in self.letters({branch!r}, {kinds!r}):")
                depth += 1
                method.add(depth, f"at = mail.since + {wait.amount}")
            case _:
                assert wait.member is not None
                slot = self.names.slots[region][str(wait.member.channel), wait.member.host]
                method.add(depth, f"if {board}.{slot} is not None:")
                depth += 1
                method.add(depth, f"at = {board}.{slot}_time + {wait.amount}")
        method.add(depth, "if now < at < best:", "    best = at")


__all__ = ["Frame"]
