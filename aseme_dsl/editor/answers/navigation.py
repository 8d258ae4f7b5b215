"""Navigation: from a name to where it is declared, implemented and used, in all files and in Python."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path

from aseme_dsl.editor.files.index import Kind, Occurrence, Symbol, Use
from aseme_dsl.editor.files.program import Program
from aseme_dsl.editor.files.python_places import activity_place, outcome_places, target_place
from aseme_dsl.editor.files.view import View
from aseme_dsl.grammar.text import tree
from aseme_dsl.records import dataclass
from aseme_dsl.source import Source, Span


@dataclass(frozen=True, slots=True)
class Place:
    """A range in a file; `span` is whole, and its source has the text in which it counts."""

    path: str
    span: Span


@dataclass(frozen=True, slots=True)
class PythonFolders:
    """Where the Python of a program is looked for: its activities, and the modules that functions name.

    `templates` are the project's own, if it has some for new activities.
    """

    activities: Path | None = None
    modules: tuple[Path, ...] = ()
    templates: Path | None = None


def definition(view: View, offset: int) -> tuple[Place, ...]:
    """Where the name at `offset` is declared; of an import, the file."""
    target = _import_at(view, offset)
    if target is not None:
        return (target,)
    found = view.occurrence_at(offset)
    return _declared(view.program, found.symbol) if found is not None else ()


def implementation(view: View, offset: int, folders: PythonFolders) -> tuple[Place, ...]:
    """The Python of what is at `offset`: an activity's class, a function's or module's target."""
    text = _target_at(view, offset)
    found = view.occurrence_at(offset)
    places: list[Span | None] = []
    if text is not None:
        places.append(target_place(folders.modules, text))
    elif found is not None:
        places += _python_of(view.program, found.symbol, folders)
    return tuple(_python(span) for span in places if span is not None)


def definition_or_python(view: View, offset: int, folders: PythonFolders) -> tuple[Place, ...]:
    """As `definition`; in the text of a target (`"module:name"`), the Python that it names."""
    if _target_at(view, offset) is not None:
        return implementation(view, offset, folders)
    return definition(view, offset) or implementation(view, offset, folders)


def references(
    view: View, offset: int, folders: PythonFolders, *, declaration: bool = True
) -> tuple[Place, ...]:
    """Everywhere the thing at `offset` stands, and the Python that implements it."""
    found = view.occurrence_at(offset)
    if found is None:
        return ()
    program = view.program
    places = [
        _place(program, item)
        for item in program.index.of(found.symbol)
        if declaration or item.use is not Use.DECLARATION
    ]
    if found.symbol.kind is Kind.MESSAGE or found.symbol.kind is Kind.ENUM:
        places += _imported(program, found.symbol) if declaration else []
    places += [_python(span) for span in _python_of(program, found.symbol, folders) if span is not None]
    return tuple(dict.fromkeys(places))


def highlights(view: View, offset: int) -> tuple[tuple[Span, Use], ...]:
    """Where the thing at `offset` stands in this file, and whether it is written there."""
    found = view.occurrence_at(offset)
    if found is None:
        return ()
    return tuple(
        (view.whole(item.span), item.use)
        for item in view.occurrences
        if item.symbol == found.symbol and view.stands(item)
    )


# ---- declarations ---------------------------------------------------------------------------------


def _declared(program: Program, symbol: Symbol) -> tuple[Place, ...]:
    declared = program.index.declarations(symbol)
    if symbol.kind is Kind.ROLE:  # an actor or a role of use cases is specified by its srm
        specified = [item for item in declared if isinstance(item.node, (tree.Srm, tree.Statechart))]
        declared = tuple(specified) or declared
    if declared:
        return tuple(dict.fromkeys(_place(program, item) for item in declared))
    if symbol.kind in (Kind.MESSAGE, Kind.ENUM, Kind.FIELD, Kind.CONSTANT):
        return tuple(_imported(program, symbol))
    if symbol.kind is Kind.STATE:
        return tuple(_state(program, symbol))
    if symbol.kind is Kind.AGENT:
        return tuple(_numbered_agent(program, symbol))
    if symbol.kind in (
        Kind.ACTIVITY,
        Kind.TIMER,
    ):  # declared by use: where a formula says it, or one starts it
        uses = program.index.of(symbol)
        first = [item for item in uses if isinstance(item.node, tree.NamedFormula) or item.use is Use.WRITE]
        return tuple(_place(program, item) for item in (first or uses)[:1])
    return ()


def _place(program: Program, item: Occurrence) -> Place:
    span = program.whole(item.span)
    return Place(program.path_of(span.source), span)


def _python(span: Span) -> Place:
    return Place(os.path.realpath(span.source.path), span)


def _imported(program: Program, symbol: Symbol) -> list[Place]:
    """Where a .proto file declares a type or a part of one."""
    symbols = program.inspection.symbols
    owner = symbol.owner or symbol.name
    found = symbols.message(owner) or symbols.enum(owner)
    if found is None or found.imported is None:
        return []
    span = found.span
    message = symbols.message(owner)
    if symbol.kind is Kind.FIELD and message is not None:
        member = message.field(symbol.name)
        span = member.span if member is not None else span
    span = program.whole(span)
    return [Place(program.path_of(span.source), span)]


def _state(program: Program, symbol: Symbol) -> Iterator[Place]:
    """The place in a formula of a state that is called by its label."""
    for charts in (program.inspection.iacs, program.inspection.eacs):
        chart = charts.get(symbol.owner.partition(".")[0])
        node = chart.by_label.get(symbol.name) if chart is not None else None
        if node is not None:
            span = program.whole(node.span)
            yield Place(program.path_of(span.source), span)


def _numbered_agent(program: Program, symbol: Symbol) -> Iterator[Place]:
    """`carrier3` is one of `carrier[1..8]`."""
    for team in program.inspection.symbols.teams:
        for agent in team.agents:
            if agent.name == symbol.name:
                span = program.whole(agent.span)
                yield Place(program.path_of(span.source), span)


# ---- imports and Python ---------------------------------------------------------------------------


def links(view: View) -> tuple[tuple[Span, str], ...]:
    """The imports of a file: where each is written, and the file that it means."""
    if view.file is None:
        return ()
    found = []
    for item in view.file.declarations:
        if isinstance(item, tree.Import):
            path = imported_path(view, item)
            if path is not None:
                found.append((view.whole(item.target.span), path))
    return tuple(found)


def imported_path(view: View, item: tree.Import) -> str | None:
    """The file that an import means, if there is one."""
    from aseme_dsl.standard_library import standard_library

    if isinstance(item.target, tree.Name):
        path = standard_library() / f"{item.target.text}.aseme"
    else:
        path = Path(view.path).parent / item.target.text
    try:
        return os.path.realpath(path) if path.is_file() else None
    except (OSError, ValueError):
        return None


def _import_at(view: View, offset: int) -> Place | None:
    item = view.declaration_at(offset)
    if not isinstance(item, tree.Import):
        return None
    span = view.whole(item.target.span)
    path = imported_path(view, item)
    if path is None or not span.start <= offset <= span.end:
        return None
    known = view.program.files.get(path)
    return Place(path, Span(known.source if known is not None else Source(path, ""), 0, 0))


def _target_at(view: View, offset: int) -> str | None:
    """The text of the target of a function or module that `offset` is in."""
    declaration = view.declaration_at(offset)
    texts: list[tree.Text | None] = []
    if isinstance(declaration, tree.Function):
        texts.append(declaration.target)
    if isinstance(declaration, (tree.Srm, tree.Statechart)):
        texts += [item.target for item in declaration.modules]
    for text in texts:
        if text is not None:
            span = view.whole(text.span)
            if span.start <= offset <= span.end:
                return text.text
    return None


def _python_of(program: Program, symbol: Symbol, folders: PythonFolders) -> Iterator[Span | None]:
    match symbol.kind:
        case Kind.ACTIVITY:
            for block in program.inspection.blocks.roles:
                for module in block.modules:
                    if module.name.text == symbol.name and module.target is not None:
                        yield target_place(folders.modules, module.target.text)
            yield activity_place(folders.activities, symbol.name)
        case Kind.OUTCOME:
            yield from outcome_places(folders.activities, symbol.owner, symbol.name)
        case Kind.FUNCTION:
            for function in program.inspection.symbols.overloads(symbol.name):
                if function.is_of_document:
                    yield target_place(folders.modules, function.target)
