"""Python answers: answers to an editor about the Python of activities."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from lsprotocol import types as lsp

from aseme_dsl import outside
from aseme_dsl.diagnostics import Edit
from aseme_dsl.editor.answers.python_files import ActivityClass, activity_classes, class_at, places, problems
from aseme_dsl.editor.authoring import GO_ON
from aseme_dsl.editor.changes.quick_fixes import mending
from aseme_dsl.editor.files.program import Program
from aseme_dsl.source import Source

if TYPE_CHECKING:
    from aseme_dsl.editor.session import AtPlace, Server

Classes = tuple[Source, tuple[ActivityClass, ...]]


def answer_in_python(server: Server) -> None:
    """Answer the requests about a module in the folder of the activities; all others are of no interest."""
    answers = _PythonAnswers(server)
    server.of_python |= {
        lsp.TEXT_DOCUMENT_DEFINITION: answers.definition,
        lsp.TEXT_DOCUMENT_DECLARATION: answers.declaration,
        lsp.TEXT_DOCUMENT_REFERENCES: answers.references,
        lsp.TEXT_DOCUMENT_CODE_LENS: answers.lenses,
        lsp.TEXT_DOCUMENT_CODE_ACTION: answers.actions,
    }


class _PythonAnswers:
    """Answers to requests about the modules in the folders of the activities."""

    def __init__(self, server: Server) -> None:
        self._server = server

    async def _programs(self, path: str) -> list[Program]:
        """The programs whose activities are in the file's folder."""
        found, files = [], self._server.files
        for root in sorted({root for file in files.files() for root in files.roots(file)}):
            folder = self._server.folders_of(Path(root)).activities
            if folder is not None and folder.resolve() == Path(path).parent:
                found.append(await self._server.in_pieces(files.programming(root)))
        return found

    async def _read(self, uri: str) -> Classes | None:
        texts = self._server.texts
        path = texts.path(uri)
        try:
            text = texts.code[path] if path in texts.code else outside.read_text(Path(path))
        except (OSError, ValueError):
            return None
        source = texts.source(path, text)
        return source, activity_classes(source, await self._programs(path))

    async def _at(self, params: AtPlace) -> tuple[ActivityClass, int] | None:
        found = await self._read(params.text_document.uri)
        if found is None:
            return None
        offset = self._server.texts.offset_in(found[0], params.position)
        one = class_at(found[1], offset)
        return None if one is None else (one, offset)

    async def definition(self, params: lsp.DefinitionParams) -> list[lsp.Location] | None:
        found = await self._at(params)
        if found is None or not found[0].name.start <= found[1] <= found[0].name.end:
            return None  # it is the Python's own
        return self._server.texts.locations(places(found[0])[:1])

    async def declaration(self, params: lsp.DeclarationParams) -> list[lsp.Location] | None:
        found = await self._at(params)
        return None if found is None else self._server.texts.locations(places(found[0])[:1])

    async def references(self, params: lsp.ReferenceParams) -> list[lsp.Location] | None:
        found = await self._at(params)
        return None if found is None else self._server.texts.locations(places(found[0]))

    async def lenses(self, params: lsp.CodeLensParams) -> list[lsp.CodeLens] | None:
        found = await self._read(params.text_document.uri)
        made = []
        for item in found[1] if found is not None else ():
            locations = self._server.texts.locations(places(item))
            if locations:
                first = locations[0]
                start = first.range.start
                title = f"{Path(self._server.texts.path(first.uri)).name}:{start.line + 1}"
                title += f" and {len(locations) - 1} more places" if len(locations) > 2 else ""
                arguments = [first.uri, start.line, start.character]
                made.append(
                    lsp.CodeLens(
                        self._server.texts.range(item.name), lsp.Command(title, GO_ON, arguments=arguments)
                    )
                )
        return made

    async def actions(self, params: lsp.CodeActionParams) -> list[lsp.CodeAction] | None:
        found = await self._read(params.text_document.uri)
        if found is None:
            return None
        start, end = (
            self._server.texts.offset_in(found[0], place) for place in (params.range.start, params.range.end)
        )
        path = found[0].path
        made = []
        for program, item in problems(path, start, end, await self._programs(path)):
            if item.span is None or item.span.source.text != found[0].text:
                continue  # the compiler sees the file as it is on disk
            shown = [one for one in params.context.diagnostics if one.code == item.code]
            for fix in mending(item):
                edit = lsp.WorkspaceEdit(changes=self._changes(program, fix.edits))
                made.append(
                    lsp.CodeAction(
                        fix.title, lsp.CodeActionKind.QuickFix, shown or None, is_preferred=True, edit=edit
                    )
                )
        return made

    def _changes(self, program: Program, edits: tuple[Edit, ...]) -> dict[str, list[lsp.TextEdit]]:
        found: dict[str, list[lsp.TextEdit]] = {}
        for edit in edits:
            uri = self._server.texts.uri(program.path_of(edit.span.source))
            place = lsp.TextEdit(self._server.texts.range(edit.span), edit.text)
            found.setdefault(uri, []).append(place)
        return found


__all__ = ["answer_in_python"]
