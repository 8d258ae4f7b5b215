"""Rename: another name for a thing, everywhere in all files, unless that would change what a file means."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import field, replace
from pathlib import Path

from aseme_dsl.compiler.names.usecases import folded
from aseme_dsl.compiler.read.pieces import InPieces, finished
from aseme_dsl.diagnostics import Diagnostic, Edit
from aseme_dsl.diagnostics.problems.syntax.entries import NotReadInTime
from aseme_dsl.diagnostics.wording import a
from aseme_dsl.editor.changes.renamed_code import Code, Unreadable, renamed_code
from aseme_dsl.editor.files.aliases import Alias, alias_at
from aseme_dsl.editor.files.index import Kind, Occurrence, Symbol
from aseme_dsl.editor.files.program import Program, errors_in_texts
from aseme_dsl.editor.files.view import View
from aseme_dsl.editor.files.workspace import Workspace
from aseme_dsl.grammar.text import tree
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.message.naming import class_name, snake_case
from aseme_dsl.source import Span
from aseme_dsl.standard_library import standard_library

_NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")

_FIXED = {
    Kind.COMM: "it is a word of the language",
    Kind.TYPE: "it is a type of the language",
    Kind.PERFORMATIVE: "it is a communicative act of FIPA",
    Kind.LIBRARY: "it is the name of a file",
    Kind.STATE: "a label is the place of a state among the others",
}

_SPECIFIES = (Kind.USE_CASE, Kind.FORMULA, Kind.ACTIVITY, Kind.PROTOCOL, Kind.CAPABILITY)
"""What counts as one thing if the names are equal but for case and underscores, and one is a use case."""


@dataclass(frozen=True, slots=True)
class Refused:
    """Why a name stays as it is."""

    reason: str


@dataclass(frozen=True, slots=True)
class Renaming:
    """The changes of each file, by its path, and what changes in Python; all of them together."""

    edits: Mapping[str, tuple[Edit, ...]]
    code: Code = field(default_factory=Code)


def renameable(workspace: Workspace, view: View, offset: int) -> Span | Refused:
    """The name at `offset`, if it can have another one."""
    found = view.occurrence_at(offset)
    if found is None:
        alias = alias_at(view, offset)
        return Refused("there is no name here") if alias is None else alias.span
    reason = _fixed(workspace, view, found)
    return Refused(reason) if reason is not None else view.whole(found.span)


def rename(
    workspace: Workspace, view: View, offset: int, name: str, activities: Path | None = None
) -> Renaming | Refused:
    """`renaming` in one go."""
    return finished(renaming(workspace, view, offset, name, activities))


def renaming(
    workspace: Workspace, view: View, offset: int, name: str, activities: Path | None = None
) -> InPieces[Renaming | Refused]:
    """Call what is at `offset` `name`, in every file, with what is the same thing in another model.

    The Python of activities, in the folder `activities`, goes with it.

    Refused where the name is none, belongs to something else, or would make a file mean something else.
    """
    found = view.occurrence_at(offset)
    alias = alias_at(view, offset) if found is None else None
    if found is None and alias is None:
        return Refused("there is no name here")
    reason = None if found is None else _fixed(workspace, view, found)
    if reason is not None:
        return Refused(reason)
    if not _NAME.fullmatch(name):
        return Refused(
            f"`{name}` is not a name: names consist of the letters A to Z and a to z, digits and '_'"
        )
    if alias is not None:
        return (yield from _of_alias(workspace, view, alias, name, activities))
    assert found is not None
    word = view.program.whole(found.span).text
    if name in (found.symbol.name, word):
        return Renaming({})
    programs = yield from _programs(workspace, view, found.symbol)
    if any(isinstance(item.problem, NotReadInTime) for program in programs for item in program.diagnostics):
        return Refused("a declaration was not read in time (E116): what it uses is not known")
    all_names = [_names(program, view, found.symbol, name) for program in programs]
    for program, names in zip(programs, all_names, strict=True):
        for symbol, new in names.items():
            taken = program.index.of(replace(symbol, name=new))
            if taken:
                span = program.whole(taken[0].span)
                where = f"{Path(span.source.path).name}:{span.line}"
                return Refused(f"there is {a(symbol.kind)} `{new}` already: {where}")
    edits = _edits(programs, all_names)
    reason = yield from _spoilt(workspace, programs, edits, all_names)
    if reason is not None:
        return Refused(reason)
    try:
        return Renaming(edits, renamed_code(_names(view.program, view, found.symbol, name), activities))
    except Unreadable as problem:
        return Refused(str(problem))


def _of_alias(
    workspace: Workspace, view: View, alias: Alias, name: str, activities: Path | None
) -> InPieces[Renaming | Refused]:
    """Another name for an import, in the file that gives it."""
    old = alias.span.text
    if name == old:
        return Renaming({})
    programs = []
    for root in workspace.roots(view.path):
        programs.append((yield from workspace.programming(root)))
    text, declared = view.source.text, alias.declared
    edits = {(declared.start, declared.end): Edit(declared, name)}
    all_names: list[dict[Symbol, str]] = []
    for program in programs:
        all_names.append({})
        for item in program.index.all():
            if not item.symbol.name.startswith(f"{old}_"):
                continue
            all_names[-1][item.symbol] = name + item.symbol.name.removeprefix(old)
            span = program.whole(item.span)
            before = re.search(rf"\b({re.escape(old)})\s*\.\s*$", text[: span.start])
            if before is not None and program.path_of(span.source) == view.path:
                place = Span(view.source, before.start(1), before.end(1))
                edits[place.start, place.end] = Edit(place, name)
    found = {view.path: tuple(edits[key] for key in sorted(edits))}
    reason = yield from _spoilt(workspace, programs, found, all_names)
    if reason is not None:
        return Refused(reason)
    try:
        changed = {symbol: new for names in all_names for symbol, new in names.items()}
        return Renaming(found, renamed_code(changed, activities))
    except Unreadable as problem:
        return Refused(str(problem))


def _fixed(workspace: Workspace, view: View, found: Occurrence) -> str | None:
    """Why a name cannot be changed to any new one."""
    symbol = found.symbol
    if symbol.kind in _FIXED:
        return f"`{symbol.name}` cannot be renamed: {_FIXED[symbol.kind]}"
    if symbol.kind is Kind.FORMULA and symbol.name == "process":
        return "`process` cannot be renamed: it is a word of the language"
    program = view.program
    symbols = program.inspection.symbols
    if symbol.kind is Kind.FUNCTION and not any(item.name == symbol.name for item in symbols.functions):
        return f"`{symbol.name}` cannot be renamed: it is built in"
    owner = symbols.message(symbol.owner or symbol.name) or symbols.enum(symbol.owner or symbol.name)
    typed = symbol.kind in (Kind.MESSAGE, Kind.ENUM, Kind.FIELD, Kind.CONSTANT)
    if typed and owner is not None and owner.imported is not None:
        return f"`{symbol.name}` cannot be renamed: {owner.imported} declares it"
    library = standard_library().resolve()
    for item in program.index.declarations(symbol):
        if Path(program.path_of(item.span.source)).is_relative_to(library):
            return f"`{symbol.name}` cannot be renamed: the standard library declares it"
    if symbol.kind is Kind.AGENT and not program.index.declarations(symbol):
        return f"`{symbol.name}` cannot be renamed here: it is one of several; rename them in the team"
    return None


def _programs(workspace: Workspace, view: View, symbol: Symbol) -> InPieces[tuple[Program, ...]]:
    """All programs that know the thing: those of the file, and those of the files that declare it."""
    roots = dict.fromkeys(workspace.roots(view.path))
    for item in view.program.index.declarations(symbol):
        roots |= dict.fromkeys(workspace.roots(view.program.path_of(item.span.source)))
    found = []
    for root in roots:
        found.append((yield from workspace.programming(root)))
    return tuple(found)


def _names(program: Program, view: View, symbol: Symbol, name: str) -> dict[Symbol, str]:
    """What gets another name in a program. Behind an alias, a thing is called otherwise than in its file."""
    own = view.program
    declared = {own.whole(item.span) for item in own.index.declarations(symbol)}
    if program is not own and declared:
        places = {(own.path_of(span.source), span.start) for span in declared}
        symbol = next(
            (
                item.symbol
                for item in program.index.all()
                if item.symbol.kind is symbol.kind
                and (program.path_of(item.span.source), program.whole(item.span).start) in places
            ),
            symbol,
        )
    word = next((span.text for span in declared), symbol.name)
    prefix = symbol.name.removesuffix(word) if symbol.name.endswith(f"_{word}") else ""
    return dict(_together(program, symbol, prefix + name))


def _together(program: Program, symbol: Symbol, name: str) -> Iterator[tuple[Symbol, str]]:
    """The thing and what is the same in other models, each with its new name."""
    yield symbol, name
    for other in kin(program, symbol):
        yield other, name if other.name == symbol.name else _spelt_like(other.name, name)
    if symbol.kind is Kind.AGENT:  # `carrier[1..8]` is called carrier3 elsewhere
        for team in program.inspection.symbols.teams:
            for agent in team.agents:
                number = agent.name.removeprefix(symbol.name)
                if number.isdigit() and agent.span.text == symbol.name:
                    yield Symbol(Kind.AGENT, agent.name), name + number


def kin(program: Program, symbol: Symbol) -> tuple[Symbol, ...]:
    """What is the same thing as `symbol` in another model, by its name."""
    found: dict[Symbol, None] = {}
    everything = {item.symbol for item in program.index.all()}
    if symbol.kind in _SPECIFIES:
        same = {
            item
            for item in everything
            if item.kind in _SPECIFIES and folded(item.name) == folded(symbol.name)
        }
        if any(item.kind is Kind.USE_CASE for item in same | {symbol}):
            found |= dict.fromkeys(same)
    if symbol.kind in (Kind.ROLE, Kind.PARTICIPANT):
        found |= dict.fromkeys(_parties(program, symbol, everything))
    found.pop(symbol, None)
    return tuple(sorted(found, key=lambda item: (item.kind, item.owner, item.name)))


def _parties(program: Program, symbol: Symbol, everything: set[Symbol]) -> Iterator[Symbol]:
    """The role of a use case and the participant of the protocol that the use case is."""
    for case in program.inspection.suc.usecases:
        if symbol.name not in case.participants:
            continue
        protocols = {folded(case.name), *(folded(name) for name in case.realises)}
        owned = [
            item
            for item in everything
            if item.kind is Kind.PARTICIPANT and item.name == symbol.name and folded(item.owner) in protocols
        ]
        if symbol.kind is Kind.ROLE or symbol in owned:
            yield from owned
            yield Symbol(Kind.ROLE, symbol.name)


def _spelt_like(old: str, name: str) -> str:
    """`name` in the spelling of `old`: with underscores or with capitals."""
    if old == snake_case(old):
        return snake_case(name)
    return class_name(name) if old[:1].isupper() and "_" not in old else name


def _edits(
    programs: Sequence[Program], all_names: Sequence[Mapping[Symbol, str]]
) -> dict[str, tuple[Edit, ...]]:
    found: dict[str, dict[tuple[int, int], Edit]] = {}
    for program, names in zip(programs, all_names, strict=True):
        for item in program.index.of(*names):
            span = program.whole(item.span)
            name, new = item.symbol.name, names[item.symbol]
            prefix = name.removesuffix(span.text)
            if name.endswith(f"_{span.text}") and new.startswith(prefix):  # behind an alias
                new = new.removeprefix(prefix)
            elif span.text != name and item.symbol.kind is not Kind.AGENT:
                continue
            found.setdefault(program.path_of(span.source), {})[span.start, span.end] = Edit(span, new)
    for program, names in zip(
        programs, all_names, strict=True
    ):  # an alias is not needed any more where it was the new name; realises stays
        for path, edit in _other_spellings(program, names):
            found.setdefault(path, {}).setdefault((edit.span.start, edit.span.end), edit)
    return {path: tuple(edits[key] for key in sorted(edits)) for path, edits in found.items()}


def _other_spellings(program: Program, names: Mapping[Symbol, str]) -> Iterator[tuple[str, Edit]]:
    """Where a thing is written in another spelling than its own (`realises`)."""
    for item in program.index.of(*names):
        span = program.whole(item.span)
        if span.text != item.symbol.name and isinstance(item.node, tree.UseCase):
            yield program.path_of(span.source), Edit(span, _spelt_like(span.text, names[item.symbol]))


def _spoilt(
    workspace: Workspace,
    programs: Iterable[Program],
    edits: Mapping[str, tuple[Edit, ...]],
    all_names: Sequence[Mapping[Symbol, str]],
) -> InPieces[str | None]:
    """What would be wrong, or mean something else, with the new names."""
    texts = {path: edited(workspace.text(path) or "", changes) for path, changes in edits.items()}
    for program, names in zip(programs, all_names, strict=True):
        known = {(item.code, item.severity) for item in program.diagnostics}
        counted = len(errors_in_texts(program.diagnostics))
        before = [
            (names.get(item.symbol, item.symbol.name), item.symbol.kind) for item in program.index.all()
        ]
        yield
        then, meant = yield from workspace.trying(program.root, texts, _seen)
        errors = errors_in_texts(then)
        if len(errors) > counted:
            new = next((item for item in errors if (item.code, item.severity) not in known), errors[0])
            return f"with this name, {new.message}"
        if before != meant:
            return "with this name, something else would be meant somewhere"
    return None


def _seen(program: Program) -> tuple[tuple[Diagnostic, ...], list[tuple[str, Kind]]]:
    """What there is to say of a program, and what all its names mean."""
    return program.diagnostics, [(item.symbol.name, item.symbol.kind) for item in program.index.all()]


def edited(text: str, edits: Iterable[Edit]) -> str:
    """A text with changes that do not overlap."""
    for edit in sorted(edits, key=lambda item: item.span.start, reverse=True):
        text = text[: edit.span.start] + edit.text + text[edit.span.end :]
    return text


__all__ = ["Refused", "Renaming", "edited", "kin", "rename", "renameable", "renaming"]
