"""`asemec view`: the drawings of a system in a browser, as they are after each change."""

from __future__ import annotations

import html
import os
import queue
import tempfile
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager, nullcontext
from pathlib import Path
from typing import TYPE_CHECKING

import click

from aseme_dsl.cli.shared import TARGET_HELP, colour_option, one_file, print_diagnostics, target_argument
from aseme_dsl.records import dataclass

if TYPE_CHECKING:
    from aseme_dsl.editor.answers.diagram import Diagrams, LiveDrawing
    from aseme_dsl.editor.files.program import Program
    from aseme_dsl.editor.files.workspace import Workspace


@click.command(
    short_help="Show the diagrams of a system in a browser, live.",
    help="Serve the diagrams of a system to a browser on this machine, and update them whenever a file"
    " changes. A click on a state or transition shows its source line; a double click on a state shows its"
    f" content. Ctrl-C stops the server. {TARGET_HELP}",
    epilog="Example: asemec view team.aseme   ·   asemec view team.aseme iac.player --open",
)
@target_argument
@click.argument("model", required=False)
@click.option("--port", type=click.IntRange(0, 65535), default=0, help="TCP port.  [default: a free port]")
@click.option("--open", "opens", is_flag=True, help="Open the page in the browser.")
@colour_option
def command(target: str, model: str | None, port: int, opens: bool, colour: str) -> int:
    """Serve until the user interrupts; 1 if there is nothing to show."""
    from aseme_dsl.cli.lsp import project
    from aseme_dsl.editor.answers.diagram import Diagrams
    from aseme_dsl.editor.files.workspace import Workspace
    from aseme_dsl.editor.viewer import Viewer

    file = one_file(target)
    if not isinstance(file, Path):
        print_diagnostics(file, colour)
        return 1
    said: queue.SimpleQueue[Mapping[str, object]] = queue.SimpleQueue()
    try:
        viewer = Viewer(said.put, port)
    except OSError as problem:
        raise click.ClickException(
            f"port {port} is not available: {problem.strerror or problem}"
        ) from problem
    try:
        click.echo(f"{file}: {viewer.url} (Ctrl-C to stop)")
        with opened(viewer.url) if opens else nullcontext():
            watched = Watched(file, Workspace(project()), Diagrams(), model)
            viewer.show(watched.state())
            while True:
                changed = watched.wait(lambda: not said.empty())
                for tab in viewer.tabs() if changed else (watched.act(said.get()),):
                    viewer.show(watched.state(tab), tab)
                watched.forget_all_but(viewer.tabs())
    except KeyboardInterrupt:
        return 0
    finally:
        viewer.close()


@contextmanager
def opened(url: str) -> Iterator[None]:
    """Open an address in the browser, by a file that only this user can read and that is deleted in the end.

    The command line of a browser is for all users of the machine to see, and the address has a secret in it.
    """
    with tempfile.TemporaryDirectory(prefix="asemec-", ignore_cleanup_errors=True) as folder:  # mode 0700
        file = Path(folder) / "view.html"
        address = html.escape(url)
        file.touch(mode=0o600)
        file.write_text(
            '<!DOCTYPE html><meta charset="utf-8"><meta name="referrer" content="no-referrer">'
            f'<meta http-equiv="refresh" content="0; url={address}"><a href="{address}">asemec view</a>\n',
            encoding="utf-8",
        )
        click.launch(str(file))
        yield


@dataclass(slots=True)
class Selection:
    """What is selected in a tab: the model, the part of it that is drawn, and the element that is marked."""

    model: str | None
    part: str | None = None
    clicked: str | None = None


class Watched:
    """A file that is looked at, and what is shown of it in each tab of a browser ("": in a new one)."""

    def __init__(self, file: Path, workspace: Workspace, diagrams: Diagrams, model: str | None) -> None:
        from aseme_dsl.project.building.watch import Watch

        self._path = str(file)
        self._workspace = workspace
        self._diagrams = diagrams
        self._first = model
        self._selections: dict[str, Selection] = {}
        self._watch = Watch()
        self._program = self._compiled()

    def act(self, said: Mapping[str, object]) -> str:
        """Carry out an action of the user on the page; gives the tab."""
        named = said.get("tab")
        tab = named if isinstance(named, str) else ""
        selection = self._selection(tab)
        match said:
            case {"act": "choose", "model": str(model)}:
                selection.model, selection.part, selection.clicked = model, None, None
            case {"act": "click", "id": str(element)}:
                selection.clicked = element
            case {"act": "enter", "id": str(element)} if element.startswith("n"):
                selection.part, selection.clicked = element[1:], None
        return tab

    def forget_all_but(self, tabs: Iterable[str]) -> None:
        """Forget what is selected in other tabs."""
        self._selections = {tab: self._selections[tab] for tab in tabs if tab in self._selections}

    def _selection(self, tab: str) -> Selection:
        return self._selections.setdefault(tab, Selection(self._first))

    def wait(self, until: Callable[[], bool]) -> bool:
        """Wait for a file that is another one than before, and compile; False as soon as `until` says so."""
        if self._watch.wait(until) is None:
            return False
        self._program = self._compiled()
        return True

    def state(self, tab: str = "") -> dict[str, object]:
        """What the page shows now in a tab."""
        from aseme_dsl.diagrams import GraphvizMissing
        from aseme_dsl.editor.answers.diagram import models_of
        from aseme_dsl.editor.viewer import page_state

        selection = self._selection(tab)
        models = models_of(self._program)
        problems = _problems(self._program)
        try:
            drawing = self._drawing(models, selection)
        except GraphvizMissing as missing:
            return page_state(title=str(missing), models=models)
        if drawing is None:
            return page_state(title=f"Nothing to draw in {self._path}.", models=models, text=problems)
        here = selection.clicked if selection.clicked in drawing.elements else None
        return page_state(
            drawing,
            here=here,
            models=models if selection.model in models else (selection.model or "", *models),
            model=selection.model or "",
            part=selection.part is not None,
            text=_place(drawing, here) if here else problems,
        )

    def _drawing(self, models: Sequence[str], selection: Selection) -> LiveDrawing | None:
        """The picture of the chosen model, else of the first one: of a role's statechart, if there is one."""
        if selection.model is not None:
            drawing = self._diagrams.of(self._program, selection.model, selection.part)
            if drawing is not None:
                return drawing
        charts = [name for name in models if name.startswith("iac.")]
        for selection.model in (*charts, *models):
            selection.part = None
            drawing = self._diagrams.of(self._program, selection.model)
            if drawing is not None:
                return drawing
        return None

    def _compiled(self) -> Program:
        """The program as the files are now; from now on, they and those that were looked for are watched."""
        self._watch.begin()
        self._workspace.forget()
        program = self._workspace.program(str(Path(self._path).resolve()))
        self._watch.depend(program.inspection.loaded.paths.values())
        return program


def _place(drawing: LiveDrawing, element: str) -> str:
    """The lines of an element's place."""
    span = drawing.elements[element]
    first, last = span.line, span.source.position(span.end)[0]
    lines = [f"{number:>5} | {span.source.line(number)}" for number in range(first, min(last, first + 9) + 1)]
    line, column = span.source.position(span.start)
    return "\n".join([f"{os.path.relpath(span.source.path)}:{line}:{column}", *lines])


def _problems(program: Program) -> str:
    from aseme_dsl.diagnostics import Severity, render_text

    return render_text(item for item in program.diagnostics if item.severity is Severity.ERROR)


__all__ = ["Watched", "command"]
