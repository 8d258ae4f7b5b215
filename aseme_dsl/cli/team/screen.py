"""The screen of `asemec team status --watch`: the agents of a team and their recent records."""

from __future__ import annotations

import asyncio
from collections.abc import Mapping, Sequence
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING, ClassVar

from rich.text import Text
from textual.app import App, ComposeResult
from textual.binding import Binding, BindingType
from textual.widgets import DataTable, Footer, Label, RichLog

from aseme_dsl.cli.terminal import harmless
from aseme_dsl.project.operating.logs import Line, Logs
from aseme_dsl.project.operating.telling import doing, record_agent, record_text, share, size
from aseme_dsl.project.operating.whole_team import WholeTeam, whole_team
from aseme_dsl.project.playing.operate import OperateError

if TYPE_CHECKING:
    from aseme_dsl.project.playing.remote import Robot
    from aseme_dsl.runtime.control.replies import Reply

SECONDS = 1.0
"""How often it is asked, and for how long an answer is waited for."""
COLUMNS = ("agent", "role", "model", "doing", "waiting", "peers", "lost", "refused", "clock", "CPU", "memory")


class Screen(App[None]):
    """Shows a team, again and again; it changes nothing."""

    CSS = (
        "#agents { height: 2fr; } #records { height: 1fr; border: round $primary; } #wrong { color: $error; }"
    )
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("q", "quit", "quit"),
        Binding("ctrl+q", "quit", "quit", show=False),
    ]
    ENABLE_COMMAND_PALETTE = False

    def __init__(self, output: Path, robots: Sequence[Robot] | None) -> None:
        super().__init__()
        self._output = output
        self._robots = robots
        self._logs = Logs(output, robots, last=20)
        self._spent: dict[str, tuple[float, float]] = {}

    def compose(self) -> ComposeResult:
        """The parts of the screen."""
        yield Label(id="where")
        yield Label(id="wrong")
        yield DataTable(id="agents", cursor_type="row")
        yield RichLog(id="records", wrap=True, max_lines=2000)
        yield Footer()

    def on_mount(self) -> None:
        """Begin to ask."""
        self.query_one(DataTable).add_columns(*COLUMNS)
        self.query_one("#records").border_title = "records"
        self.run_worker(self._ask_on())

    async def _ask_on(self) -> None:
        while True:
            await self.renew()
            await asyncio.sleep(SECONDS)

    async def renew(self) -> None:
        """Ask once, beside the screen, and show it."""
        try:
            team = await asyncio.to_thread(whole_team, self._output, self._robots, 2 * SECONDS)
            lines = (await asyncio.to_thread(self._logs.new, 2 * SECONDS)).lines
        except OperateError as problem:
            self.query_one("#wrong", Label).update(Text(harmless("\n".join(map(str, problem.args)))))
            return
        self._show(team)
        for line in lines:
            self.query_one(RichLog).write(Text(record_line(line)))

    def _show(self, team: WholeTeam) -> None:
        here = len(team.members) - len(team.missing)
        now = datetime.now().strftime("%H:%M:%S")
        models = len(team.models())
        versions = f"   {models} models" if models > 1 else ""
        self.query_one("#where", Label).update(
            Text(f"{now}   {here} of {len(team.members)} agents{versions}")
        )
        self.query_one("#wrong", Label).update(Text(harmless("\n".join(team.reasons()))))
        table = self.query_one(DataTable)
        table.clear()
        for node in team.nodes:
            status = node.status
            cpu = self._cpu(str(node.socket), status)
            for row in rows(status, cpu):
                table.add_row(*(Text(harmless(cell)) for cell in row))

    def _cpu(self, name: str, status: Reply) -> str:
        """The share of a processor since the last answer."""
        spent, at = status["process"]["cpu"], status["process"]["uptime"]
        before = self._spent.get(name, (0.0, 0.0))
        self._spent[name] = spent, at
        return share(spent - before[0], at - before[1]) if at > before[1] else share(spent, at)


def rows(status: Reply, cpu: str) -> list[tuple[str, ...]]:
    """A row of the table for each agent of a process."""
    peers = status["peers"]
    connected = sum(peer["connected"] for peer in peers.values())
    together = {
        "peers": f"{connected}/{len(peers)}" if peers else "",
        "lost": str(sum(peer["lost"] for peer in peers.values())) if peers else "",
        "refused": str(sum(peer["refused"] for peer in peers.values())) if peers else "",
        "clock": _clocks(status["clocks"]),
    }
    return [
        (
            agent["name"],
            agent["role"],
            agent["model"][:8],
            doing(agent),
            str(agent["waiting"] + agent["unread"]),
            *together.values(),
            cpu,
            size(status["process"]["memory"]),
        )
        for agent in status["agents"]
    ]


def _clocks(clocks: Mapping[str, object]) -> str:
    """The largest difference of a clock, in ms; empty if all have the same."""
    found = [
        abs(clock["difference"])
        for clock in clocks.values()
        if isinstance(clock, dict) and isinstance(clock.get("difference"), int) and clock["difference"]
    ]
    return f"{max(found) / 1e6:.2f} ms" if found else ""


def record_line(line: Line) -> str:
    """A recent record in one line."""
    record = line.record
    at = datetime.fromtimestamp(line.at).strftime("%H:%M:%S.%f")[:-3]
    who = record_agent(record) or line.process
    return harmless(f"{at}  {who:<12} {record.get('kind', '')}: {record_text(record)}")


__all__ = ["Screen", "record_line", "rows"]
