"""`asemec view`: the drawings of a system in a browser, as they are after each change."""

from __future__ import annotations

import os
import queue
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from aseme_dsl.cli.shared import FilePath

if TYPE_CHECKING:
    from aseme_dsl.editor.diagram import Diagrams, LiveDrawing
    from aseme_dsl.editor.program import Program
    from aseme_dsl.editor.workspace import Workspace


@click.command(
    short_help="Show the models of a system in a browser, live.",
    help="Show the models of a system on a page in a browser of this machine, and again whenever a file"
    " changes. A click on a state or transition shows its place in the text, a double click on a state what"
    " is in it. Ctrl-C ends it.",
    epilog="Example: asemec view team.aseme   ·   asemec view team.aseme iac.player --open",
)
@click.argument("file", type=FilePath(path_type=Path))
@click.argument("model", required=False)
@click.option(
    "--port", type=click.IntRange(0, 65535), default=0, help="The port.  [default: any that is free]"
)
@click.option("--open", "opens", is_flag=True, help="Open the page in the browser.")
def command(file: Path, model: str | None, port: int, opens: bool) -> int:
    """Serve until somebody ends it."""
    from aseme_dsl.cli.lsp import project
    from aseme_dsl.editor.diagram import Diagrams
    from aseme_dsl.editor.viewer import Viewer
    from aseme_dsl.editor.workspace import Workspace

    if not file.is_file():
        raise click.UsageError(f"{file} is not a file.")
    said: queue.SimpleQueue[Mapping[str, Any]] = queue.SimpleQueue()
    try:
        viewer = Viewer(said.put, port)
    except OSError as problem:
        raise click.ClickException(f"port {port} cannot be used: {problem.strerror or problem}") from problem
    try:
        click.echo(f"{file}: {viewer.url} (Ctrl-C ends it)")
        if opens:
            click.launch(viewer.url)
        watched = Watched(file, Workspace(project()), Diagrams(), model)
        viewer.show(watched.state())
        while True:
            if not watched.wait(lambda: not said.empty()):
                watched.act(said.get())
            viewer.show(watched.state())
    except KeyboardInterrupt:
        return 0
    finally:
        viewer.close()


class Watched:
    """A file that is looked at, and what is shown of it."""

    def __init__(self, file: Path, workspace: Workspace, diagrams: Diagrams, model: str | None) -> None:
        from aseme_dsl.build.watch import Watch

        self._path = str(file)
        self._workspace = workspace
        self._diagrams = diagrams
        self._model = model
        self._part: str | None = None
        self._clicked: str | None = None
        self._watch = Watch()
        self._program = self._compiled()

    def act(self, said: Mapping[str, Any]) -> None:
        """What somebody does on the page."""
        match said:
            case {"act": "choose", "model": str(model)}:
                self._model, self._part, self._clicked = model, None, None
            case {"act": "click", "id": str(element)}:
                self._clicked = element
            case {"act": "enter", "id": str(element)} if element.startswith("n"):
                self._part, self._clicked = element[1:], None

    def wait(self, until: Callable[[], bool]) -> bool:
        """Wait for a file that is another one than before, and compile; False as soon as `until` says so."""
        if self._watch.wait(until) is None:
            return False
        self._program = self._compiled()
        return True

    def state(self) -> dict[str, Any]:
        """What the page shows now."""
        from aseme_dsl.diagrams import GraphvizMissing
        from aseme_dsl.editor.diagram import models_of
        from aseme_dsl.editor.viewer import page_state

        models = models_of(self._program)
        problems = _problems(self._program)
        try:
            drawing = self._drawing(models)
        except GraphvizMissing as missing:
            return page_state(title=str(missing), models=models)
        if drawing is None:
            return page_state(
                title=f"There is nothing to draw in {self._path}.", models=models, text=problems
            )
        here = self._clicked if self._clicked in drawing.elements else None
        return page_state(
            drawing,
            here=here,
            models=models if self._model in models else (self._model or "", *models),
            model=self._model or "",
            part=self._part is not None,
            text=_place(drawing, here) if here else problems,
        )

    def _drawing(self, models: Sequence[str]) -> LiveDrawing | None:
        """The picture of the chosen model, else of the first one: of a role's statechart, if there is one."""
        if self._model is not None:
            drawing = self._diagrams.of(self._program, self._model, self._part)
            if drawing is not None:
                return drawing
        charts = [name for name in models if name.startswith("iac.")]
        for self._model in (*charts, *models):
            self._part = None
            drawing = self._diagrams.of(self._program, self._model)
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
