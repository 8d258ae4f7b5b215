"""Python answers: what an editor is told of the Python of activities."""

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

    async def programs(path: str) -> list[Program]:
        """The programs whose activities are in the file's folder."""
        found = []
        for root in sorted({root for file in server.files.files() for root in server.files.roots(file)}):
            folder = server.folders_of(Path(root)).activities
            if folder is not None and folder.resolve() == Path(path).parent:
                found.append(await server.in_pieces(server.files.programming(root)))
        return found

    async def read(uri: str) -> Classes | None:
        path = server.texts.path(uri)
        try:
            text = server.texts.code[path] if path in server.texts.code else outside.read_text(Path(path))
        except (OSError, ValueError):
            return None
        source = server.texts.source(path, text)
        return source, activity_classes(source, await programs(path))

    async def at(params: AtPlace) -> tuple[ActivityClass, int] | None:
        found = await read(params.text_document.uri)
        if found is None:
            return None
        offset = server.texts.offset_in(found[0], params.position)
        one = class_at(found[1], offset)
        return None if one is None else (one, offset)

    async def definition(params: lsp.DefinitionParams) -> list[lsp.Location] | None:
        found = await at(params)
        if found is None or not found[0].name.start <= found[1] <= found[0].name.end:
            return None  # it is the Python's own
        return server.texts.locations(places(found[0])[:1])

    async def declaration(params: lsp.DeclarationParams) -> list[lsp.Location] | None:
        found = await at(params)
        return None if found is None else server.texts.locations(places(found[0])[:1])

    async def references(params: lsp.ReferenceParams) -> list[lsp.Location] | None:
        found = await at(params)
        return None if found is None else server.texts.locations(places(found[0]))

    async def lenses(params: lsp.CodeLensParams) -> list[lsp.CodeLens] | None:
        found = await read(params.text_document.uri)
        made = []
        for item in found[1] if found is not None else ():
            locations = server.texts.locations(places(item))
            if locations:
                first = locations[0]
                start = first.range.start
                title = f"{Path(server.texts.path(first.uri)).name}:{start.line + 1}"
                title += f" and {len(locations) - 1} more places" if len(locations) > 2 else ""
                arguments = [first.uri, start.line, start.character]
                made.append(
                    lsp.CodeLens(
                        server.texts.range(item.name), lsp.Command(title, GO_ON, arguments=arguments)
                    )
                )
        return made

    async def actions(params: lsp.CodeActionParams) -> list[lsp.CodeAction] | None:
        found = await read(params.text_document.uri)
        if found is None:
            return None
        start, end = (
            server.texts.offset_in(found[0], place) for place in (params.range.start, params.range.end)
        )
        path = found[0].path
        made = []
        for program, item in problems(path, start, end, await programs(path)):
            if item.span is None or item.span.source.text != found[0].text:
                continue  # the compiler sees the file as it is on disk
            shown = [one for one in params.context.diagnostics if one.code == item.code]
            for fix in mending(item):
                edit = lsp.WorkspaceEdit(changes=_changes(server, program, fix.edits))
                made.append(
                    lsp.CodeAction(
                        fix.title, lsp.CodeActionKind.QuickFix, shown or None, is_preferred=True, edit=edit
                    )
                )
        return made

    server.of_python |= {
        lsp.TEXT_DOCUMENT_DEFINITION: definition,
        lsp.TEXT_DOCUMENT_DECLARATION: declaration,
        lsp.TEXT_DOCUMENT_REFERENCES: references,
        lsp.TEXT_DOCUMENT_CODE_LENS: lenses,
        lsp.TEXT_DOCUMENT_CODE_ACTION: actions,
    }


def _changes(server: Server, program: Program, edits: tuple[Edit, ...]) -> dict[str, list[lsp.TextEdit]]:
    found: dict[str, list[lsp.TextEdit]] = {}
    for edit in edits:
        uri = server.texts.uri(program.path_of(edit.span.source))
        place = lsp.TextEdit(server.texts.range(edit.span), edit.text)
        found.setdefault(uri, []).append(place)
    return found


__all__ = ["answer_in_python"]
