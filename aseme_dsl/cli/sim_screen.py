"""The screen of `asemec sim`: statecharts, values, source and what happened, with a line for commands."""

from __future__ import annotations

import asyncio
from collections.abc import Iterable
from typing import TYPE_CHECKING, ClassVar

from rich.text import Text
from textual import on
from textual.app import App, ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Horizontal, Vertical, VerticalScroll
from textual.widgets import Footer, Input, Label, RichLog, Static, Tab, Tabs

from aseme_dsl.cli.stepping import WrongCommand, news, obey
from aseme_dsl.project.stepping.telling import inner_states, state_line, value_line
from aseme_dsl.runtime.time.clock import shown

if TYPE_CHECKING:
    from aseme_dsl.project.stepping.picture import AgentPicture
    from aseme_dsl.project.stepping.stepper import Stepper

AROUND = 6
"""So many lines of the source are shown before and behind the active ones."""


class Screen(App[None]):
    """Shows where a run stands; each key and each command moves it."""

    CSS = "\n".join(
        (
            "#top { height: 2fr; }",
            "#states { width: 2fr; border: round $primary; }",
            "#right { width: 3fr; }",
            "#values, #source, #log { height: 1fr; border: round $primary; }",
            "#where { height: 1; padding: 0 1; }",
        )
    )
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("f10", "obey('step')", "step"),
        Binding("f9", "obey('back')", "back"),
        Binding("f5", "obey('go')", "go"),
        Binding("f1", "obey('help')", "commands"),
        Binding("ctrl+q", "quit", "quit"),
    ]
    ENABLE_COMMAND_PALETTE = False

    def __init__(self, stepper: Stepper) -> None:
        super().__init__()
        self._stepper = stepper
        self._agent = stepper.instant.picture.agents[0].name

    def compose(self) -> ComposeResult:
        """The parts of the screen."""
        yield Label(id="where")
        names = [item.name for item in self._stepper.instant.picture.agents]
        yield Tabs(*(Tab(name, id=f"agent-{place}") for place, name in enumerate(names)))
        with Horizontal(id="top"):
            with VerticalScroll(id="states"):
                yield Static(id="outline")
            with Vertical(id="right"):
                with VerticalScroll(id="values"):
                    yield Static(id="known")
                with VerticalScroll(id="source"):
                    yield Static(id="lines")
        yield RichLog(id="log", wrap=True, max_lines=2000)
        yield Input(
            placeholder="step, back, to 2s, go, halt ..., do ..., add ..., save FILE, help", id="command"
        )
        yield Footer()

    def on_mount(self) -> None:
        """Show the beginning."""
        for part, title in (
            ("states", "statechart"),
            ("values", "values"),
            ("source", "source"),
            ("log", "events"),
        ):
            self.query_one(f"#{part}").border_title = title
        self.query_one(Input).focus()
        self._tell(news(self._stepper))
        self._show()

    @on(Tabs.TabActivated)
    def choose(self, event: Tabs.TabActivated) -> None:
        """Show another agent."""
        self._agent = str(event.tab.label)
        self._show()

    @on(Input.Submitted)
    def submit(self, event: Input.Submitted) -> None:
        """Do what was typed; an empty line steps."""
        line = event.value.strip() or "step"
        event.input.value = ""
        if line == "quit":
            self.run_worker(self.action_quit())
        else:
            self._obey(line)

    async def action_quit(self) -> None:
        """Leave, also while code of the user does not return."""
        self._stepper.close()
        self.exit()

    def action_obey(self, line: str) -> None:
        """Do what a key says."""
        self._obey(line)

    def _obey(self, line: str) -> None:
        """Do it beside the screen, which can be left meanwhile."""
        command = self.query_one(Input)
        if not command.disabled:
            command.disabled = True
            self.query_one(RichLog).write(Text(f"> {line}", style="bold"))
            self.run_worker(self._done(line))

    async def _done(self, line: str) -> None:
        try:
            self._tell(await asyncio.to_thread(list, obey(self._stepper, line)))
        except WrongCommand as problem:
            self.query_one(RichLog).write(Text(str(problem), style="red"))
        self._show()
        command = self.query_one(Input)
        command.disabled = False
        command.focus()

    def _tell(self, lines: Iterable[str]) -> None:
        log = self.query_one(RichLog)
        for line in lines:
            log.write(Text(line))

    def _show(self) -> None:
        instant = self._stepper.instant
        agent = next(item for item in instant.picture.agents if item.name == self._agent)
        halts = len(self._stepper.session.halts)
        where = f"{shown(instant.picture.moment)}   seed {self._stepper.session.seed}   {halts} halts"
        self.query_one("#where", Label).update(Text(where, style="bold"))
        self.query_one("#outline", Static).update(_outline(agent))
        self.query_one("#known", Static).update(Text("\n".join(map(value_line, agent.values))))
        self.query_one("#lines", Static).update(self._source(agent))

    def _source(self, agent: AgentPicture) -> Text:
        """The lines around those of the active states, which are marked."""
        places = {self._stepper.line_at(item.at)[:2] for item in inner_states(agent)}
        text = Text()
        for path in sorted({path for path, _ in places}):
            marked = {line for other, line in places if other == path}
            text.append(f"{path}\n", style="dim")
            lines = self._stepper.lines_of(path)
            for number in range(max(1, min(marked) - AROUND), min(len(lines), max(marked) + AROUND) + 1):
                style = "bold reverse" if number in marked else ""
                text.append(f"{number:4}  {lines[number - 1]}\n", style=style)
        return text


def _outline(agent: AgentPicture) -> Text:
    text = Text()
    for item in agent.states:
        style = "bold green" if item.is_running else "green" if item.is_active else "dim"
        text.append(f"{state_line(item)}\n", style=style)
    if agent.ended:
        text.append(agent.ended, style="red")
    return text


__all__ = ["Screen"]
