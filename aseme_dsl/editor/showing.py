"""Showing: what is known of all runs, as lenses, diagnostics, actions and progress in an editor."""

from __future__ import annotations

import asyncio
import time
import uuid
from collections.abc import Awaitable, Callable, Coroutine, Iterator, Sequence
from concurrent.futures import Future
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any

from lsprotocol import types as lsp
from pygls.exceptions import JsonRpcException

from aseme_dsl import outside
from aseme_dsl.editor.files.program import Program, errors_in_texts
from aseme_dsl.editor.files.view import View
from aseme_dsl.editor.proving.proofs import Answer, Proofs, Running, Text
from aseme_dsl.editor.proving.questions import Question, digest, questions, text_of
from aseme_dsl.editor.proving.settings import WrongSetting, read_settings
from aseme_dsl.editor.proving.titles import running_title, title_of
from aseme_dsl.editor.reading import reading
from aseme_dsl.grammar.layout.adding import addition
from aseme_dsl.grammar.parsing.parts import TooSlow
from aseme_dsl.grammar.text import tree
from aseme_dsl.source import Span

if TYPE_CHECKING:
    from aseme_dsl.editor.publishing import Publishing
    from aseme_dsl.editor.session import Server

PROVE, STOP = "asemec.prove", "asemec.stopProving"
"""The commands of the lenses: find out, and give up; their argument has `uri` and `question`."""

CODE = "refuted"
SOURCE = "asemec prove"
"""What the diagnostics of refuted answers are called."""

AGAIN = 1.0
"""Seconds after which it is shown again how long something takes."""
ANSWERED = 5.0
"""Seconds that an editor may take to make room for progress."""


class Showing:
    """The proofs of a server, as its editor sees them."""

    def __init__(self, server: Server, publishing: Publishing, command: Sequence[str]) -> None:
        self.proofs = Proofs(command, self._changed)
        self._server = server
        self._publishing = publishing
        self._digests: dict[str, tuple[Program, str]] = {}
        self._tasks: set[asyncio.Task[None]] = set()

    # ---- what is shown -------------------------------------------------------------------------------

    def lenses(self, view: View) -> list[lsp.CodeLens]:
        """A verdict above everything that may be proved."""
        running = self.proofs.running.get(view.program.root)
        uri = self._server.texts.uri(view.path)
        found = []
        for question in questions(view):
            is_running = running is not None and running.question.key in (question.key, "all")
            if running is not None and is_running:
                title = running_title(time.monotonic() - running.begun)
            else:
                title = title_of(question, *self._found(view, question))
            arguments = {"uri": uri, "question": question.key}
            command = lsp.Command(title, STOP if is_running else PROVE, arguments=[arguments])
            place = Span(view.source, question.span.start, question.span.start)
            found.append(lsp.CodeLens(self._server.texts.range(place), command))
        return found

    def diagnostics(self, view: View) -> list[lsp.Diagnostic]:
        """What is refuted of the text as it is now, with the shortest run."""
        found = []
        for question, answer in self._refuted(view):
            place = self._server.texts.range(question.name)
            here = lsp.Location(self._server.texts.uri(view.path), place)
            found.append(
                lsp.Diagnostic(
                    place,
                    f"`{answer.name}` of {answer.of} is refuted"
                    f"{f': {answer.reason}' if answer.reason else ''}\n{answer.bounds}",
                    severity=lsp.DiagnosticSeverity.Warning,
                    code=CODE,
                    source=SOURCE,
                    related_information=[
                        lsp.DiagnosticRelatedInformation(here, f"{number}. {line}")
                        for number, line in enumerate(answer.run, 1)
                    ],
                )
            )
        return found

    def actions(
        self, view: View, start: int, end: int, shown: Sequence[lsp.Diagnostic]
    ) -> list[lsp.CodeAction]:
        """The quick fixes that insert a counterexample as a scenario, into the file with the system."""
        root, texts = view.program.root, self._server.texts
        text = self._server.files.text(root)
        found = []
        for question, answer in self._refuted(view):
            if answer.scenario is None or text is None:
                continue
            if not (question.name.start <= end and start <= question.name.end):
                continue
            added = addition(text, answer.scenario["roles"], answer.scenario["text"])
            if added is None:
                continue
            source = texts.source(root, text)
            edit = lsp.TextEdit(texts.range(Span(source, len(source.text), len(source.text))), added)
            mended = [
                item
                for item in shown
                if item.code == CODE and f"`{answer.name}` of {answer.of} " in item.message
            ]
            found.append(
                lsp.CodeAction(
                    f"Insert the counterexample of `{answer.name}` of {answer.of} as a scenario",
                    kind=lsp.CodeActionKind.QuickFix,
                    diagnostics=mended or None,
                    edit=lsp.WorkspaceEdit(changes={texts.uri(root): [edit]}),
                )
            )
        return found

    def _refuted(self, view: View) -> Iterator[tuple[Question, Answer]]:
        """The refuted answers of the text as it is now, each at the first place that asks for it."""
        seen: set[tuple[str, str]] = set()
        elsewhere = self._of_other_files(view)
        asked = [item for item in questions(view) if item.asked]
        asked += [item for item in questions(view) if not item.asked]  # the team, where none is declared
        for question in asked:
            answers, _, is_current = self._found(view, question)
            for answer in answers if is_current else ():
                if answer.verdict == "REFUTED" and (answer.name, answer.of) not in seen:
                    seen.add((answer.name, answer.of))
                    if question.asked or (answer.of == "team" and answer.name not in elsewhere):
                        yield question, answer

    def _of_other_files(self, view: View) -> set[str]:
        """The names of what stands in the other open files of the system: what is refuted is shown there."""
        files = view.program.files
        others = [path for path in files if path != view.path and path in self._server.files.buffers]
        found: set[str] = set()
        for item in (item for path in others for item in files[path].declarations):
            if isinstance(item, tree.Property):
                found.add(item.title.text)
            elif isinstance(item, tree.Aip):
                found.update(text_of(clause) for clause in item.clauses)
        return found

    def _found(self, view: View, question: Question) -> tuple[list[Answer], str, bool]:
        return self.proofs.found(view.program.root, self._digest(view.program), question)

    def _digest(self, program: Program) -> str:
        known = self._digests.get(program.root)
        if known is None or known[0] is not program:
            known = self._digests[program.root] = (program, digest(program))
        return known[1]

    def _changed(self, root: str, is_final: bool) -> None:
        """There is something new to show of a system."""
        self.refresh()
        if is_final:
            for path in list(self._server.files.buffers):
                if root in self._server.files.roots(path):
                    self._publishing.soon(path)

    def refresh(self) -> None:
        """Have the editor ask for its lenses again, if it does so when told."""
        workspace = self._server.client_capabilities.workspace
        able = workspace.code_lens if workspace is not None else None
        if able is not None and able.refresh_support:
            self._server.workspace_code_lens_refresh(None)

    # ---- what is done --------------------------------------------------------------------------------

    async def prove(self, path: str, key: str, is_asked: bool = True) -> None:
        """Begin to answer a question of a file. Unless it `is_asked` for, known answers are enough, and
        nothing is said of what cannot be proved."""
        view = await self._server.settled(path)
        if view is None:
            return
        program = view.program
        file = program.files.get(program.root)
        problem = self._obstacle(program)
        if file is None or problem:
            if is_asked:
                self._say(f"Not proved: {problem or 'the file cannot be read'}")
            return
        everything = Question("all", (), (), Span(view.source, 0, 0), Span(view.source, 0, 0))
        question = next((item for item in questions(view) if item.key == key), None)
        if question is None:
            if key != "all":
                self._say(f"Not proved: there is no {key} any more")
                return
            question = everything
        code = str(self._server.folders_of(Path(program.root)).activities)
        text = Text(program.root, file.source.text, self._digest(program), code)
        if not is_asked and self.proofs.is_all_known(text):
            return
        running = self.proofs.begin(text, question)
        self._meanwhile(self._watch(program.root, running))

    def saved(self, path: str) -> None:
        """A file was saved: prove everything of it, if that is wanted."""
        if self.proofs.settings.on_save:
            self._meanwhile(self._patiently(lambda: self.prove(path, "all", is_asked=False)))

    def closed(self) -> None:
        """A file was closed: what runs for systems of which none is open is given up."""
        files = self._server.files
        roots = {root for path in files.buffers for root in files.roots(path)}
        for root in set(self.proofs.running) - roots:
            self.proofs.stop(root)

    def configured(self, given: object) -> None:
        """Take over settings; what is none is said."""
        try:
            self.proofs.configure(read_settings(given, self.proofs.settings))
        except WrongSetting as problem:
            self._say(f"asemec: {problem}")

    def _meanwhile(self, work: Coroutine[object, object, None]) -> None:
        """Do something meanwhile."""
        task: asyncio.Task[None] = asyncio.ensure_future(work)
        self._tasks.add(task)
        task.add_done_callback(self._tasks.discard)

    def _obstacle(self, program: Program) -> str:
        """Why a system is not proved as it is in the editor; "" if it can be."""
        if errors_in_texts(program.diagnostics):
            return "the file has errors"
        if not Path(program.root).is_file():
            return "save the file first"
        for path in program.files:
            buffer = self._server.files.buffers.get(path)
            if buffer is None or path == program.root:
                continue
            with suppress(OSError, UnicodeDecodeError, ValueError):
                if outside.read_text(Path(path)).lstrip("\ufeff") == buffer.text.lstrip("\ufeff"):
                    continue
            return f"save {Path(path).name} first, which is imported"
        return ""

    async def _patiently(self, work: Callable[[], Awaitable[None]]) -> None:
        """Some work of the server that is none of its answers."""
        with suppress(TooSlow):
            while True:
                try:
                    return await self._server.reading(work)
                except reading.NotYet as wanted:
                    await self._server.reader.wait(wanted.job)

    async def _watch(self, root: str, running: Running) -> None:
        """Show how long it takes, until it ends."""
        task = running.task
        assert task is not None
        self.refresh()
        token = await self._progress(root, running)
        while not task.done():
            await asyncio.wait([task], timeout=AGAIN)
            if not task.done():
                self.refresh()
                if token is not None:
                    said = f"{running.told} ({time.monotonic() - running.begun:.0f} s)"
                    report = lsp.WorkDoneProgressReport(message=said)
                    self._server.work_done_progress.report(token, report)
        if token is not None:
            self._server.work_done_progress.end(token, lsp.WorkDoneProgressEnd())
            self._server.work_done_progress.tokens.pop(token, None)

    async def _progress(self, root: str, running: Running) -> str | None:
        """Where progress is shown, if the editor can do that; who cancels it there gives it up."""
        window = self._server.client_capabilities.window
        if window is None or not window.work_done_progress:
            return None
        token, progress = f"asemec-{uuid.uuid4()}", self._server.work_done_progress
        try:
            await asyncio.wait_for(progress.create_async(token), ANSWERED)
        except (JsonRpcException, TimeoutError):
            return None
        title = f"asemec: proving {Path(root).name}"
        progress.begin(token, lsp.WorkDoneProgressBegin(title, cancellable=True, message=running.told))

        def given_up(future: Future[object]) -> None:
            if future.cancelled() and self.proofs.running.get(root) is running:
                self.proofs.stop(root)

        progress.tokens[token].add_done_callback(given_up)
        return token

    def _say(self, text: str) -> None:
        self._server.window_show_message(lsp.ShowMessageParams(lsp.MessageType.Warning, text))


def answer_proofs(server: Server, publishing: Publishing, command: Sequence[str]) -> None:
    """Answer all requests of this file; `command` starts a process that proves."""
    showing = Showing(server, publishing, command)
    server.showing = showing

    @server.feature(lsp.INITIALIZE)
    def initialize(params: lsp.InitializeParams) -> None:
        showing.configured(params.initialization_options)

    @server.feature(lsp.WORKSPACE_DID_CHANGE_CONFIGURATION)
    def configuration(params: lsp.DidChangeConfigurationParams) -> None:
        showing.configured(params.settings)

    @server.feature(lsp.SHUTDOWN)
    def shutdown(params: None) -> None:
        showing.proofs.stop_all()

    @server.command(PROVE)
    async def prove(data: Any) -> None:
        await showing.prove(server.texts.path(str(_part(data, "uri"))), str(_part(data, "question")))

    @server.command(STOP)
    async def stop(data: Any) -> None:
        view = await server.view(str(_part(data, "uri")))
        if view is not None:
            showing.proofs.stop(view.program.root)


def _part(data: object, name: str) -> object:
    """A member of what an editor has sent back."""
    found: object = data[name] if isinstance(data, dict) else getattr(data, name)
    return found


__all__ = ["CODE", "PROVE", "STOP", "Showing", "answer_proofs"]
