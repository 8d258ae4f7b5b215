"""Rewriting: a declaration taken apart for a refactoring, its new text, and whether that means the same."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import field, fields
from difflib import SequenceMatcher

from aseme_dsl.amola.expression import action_text, events_text, value_text
from aseme_dsl.amola.statechart import State, Statechart, StateType, Transition, TransitionKind
from aseme_dsl.compiler import Analysis, analyse
from aseme_dsl.compiler.chart.aip_to_eac import PROCESS
from aseme_dsl.compiler.formula import formulas as formula_tables
from aseme_dsl.compiler.formula.formulas import Formulas
from aseme_dsl.compiler.formula.holes import apart_from_holes
from aseme_dsl.compiler.formula.interrupts import with_interrupts
from aseme_dsl.compiler.formula.terms import Terms, terms_of
from aseme_dsl.diagnostics import Diagnostic, Edit, Severity, has_errors
from aseme_dsl.editor.files.place import begin_of_declaration, end_of_declaration
from aseme_dsl.editor.files.view import View
from aseme_dsl.editor.reading.reading import format_source, parse
from aseme_dsl.grammar.text import tree
from aseme_dsl.records import dataclass
from aseme_dsl.source import Source, Span


class Refused(Exception):
    """A refactoring cannot be done here, or would change what the model means; says why."""


@dataclass(frozen=True, slots=True)
class Owner:
    """A role or a participant with its formulas, as its control blocks call them."""

    formulas: Formulas
    titles: Mapping[str, str]
    """What the control block of each formula is called: a participant's name for its process."""
    written: tree.Srm | tree.Participant

    def formula_of(self, title: str) -> str | None:
        """The formula that a control block of this name is about."""
        return next((name for name, other in self.titles.items() if other == title), None)

    def terms(self, formula: str) -> Terms:
        return terms_of(self.formulas, formula, self.titles[formula])


@dataclass(frozen=True, slots=True)
class Piece:
    """A declaration in the text of its file; the spans of its tree count from `first`."""

    source: Source
    first: int
    end: int
    declaration: tree.Srm | tree.Aip

    @property
    def text(self) -> str:
        return self.source.text[self.first : self.end]

    @property
    def owners(self) -> tuple[Owner, ...]:
        """The role, or the participants of the protocol."""
        return tuple(_owners(self.declaration))


def piece_at(source: Source, offset: int) -> Piece:
    """The role or protocol around an offset.

    Raises:
        Refused: There is none, or it has mistakes of syntax.
    """
    first = begin_of_declaration(source.text, offset + 1)
    end = end_of_declaration(source.text, first)
    return Piece(source, first, end, read_piece(source.text[first:end]))


def read_piece(text: str) -> tree.Srm | tree.Aip:
    """The role or protocol that a text consists of.

    Raises:
        Refused: It is none, or has mistakes of syntax.
    """
    file, diagnostics = parse(Source("<declaration>", text))
    if has_errors(apart_from_holes(diagnostics)):
        raise Refused(f"fix the syntax errors first: {diagnostics[0].message}")
    for item in file.declarations:
        if isinstance(item, (tree.Srm, tree.Aip)):
            return item
    raise Refused("there is no role and no protocol here")


def _owners(declaration: tree.Srm | tree.Aip) -> Iterator[Owner]:
    if isinstance(declaration, tree.Srm):
        table = formula_tables.table(declaration.name.text, declaration.formulas)[0]
        if table is not None:
            titles = {name: name for name in table.named}
            yield Owner(_interrupted(table, titles, declaration), titles, declaration)
        return
    for part in declaration.participants:
        table = formula_tables.table(f"{declaration.name}.{part.name}", part.formulas, PROCESS)[0]
        if table is not None:
            titles = {name: part.name.text if name == PROCESS else name for name in table.named}
            yield Owner(_interrupted(table, titles, declaration), titles, part)


def _interrupted(formulas: Formulas, titles: Mapping[str, str], declaration: tree.Srm | tree.Aip) -> Formulas:
    """The formulas, with the branches that interrupt each by itself, as the control blocks say."""
    formula = {title: name for name, title in titles.items()}
    found = [(item, formula[item.name.text]) for item in declaration.controls if item.name.text in formula]
    return with_interrupts(formulas, found)


def same_owner(text: str, old: Owner) -> Owner:
    """The same role or participant in the new text of its declaration.

    Raises:
        Refused: The text cannot be read, or has it no more.
    """
    for owner in _owners(read_piece(text)):
        if owner.formulas.owner == old.formulas.owner:
            return owner
    raise Refused(f"{old.formulas.owner} would have no formulas any more")


# ---- texts -----------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Replaced:
    """`text` instead of what stands from `start` to `end` in the text of a piece."""

    start: int
    end: int
    text: str


def applied(text: str, changes: Iterable[Replaced]) -> str:
    """The text with changes that do not overlap; of those at one place, the first comes first."""
    done = len(text)
    parts: list[str] = []
    for change in reversed(sorted(changes, key=lambda item: (item.start, item.end))):
        parts += [text[change.end : done], change.text]
        done = change.start
    return "".join([text[:done], *reversed(parts)])


def edits(piece: Piece, text: str) -> tuple[Edit, ...]:
    """What changes in the file when the piece gets another text, line by line.

    A file that is in the canonical layout stays so.
    """
    whole = piece.source.text
    changed = whole[: piece.first] + text + whole[piece.end :]
    laid = format_source(Source(piece.source.path, changed))
    if not format_source(piece.source).changed and not laid.diagnostics:
        changed = laid.text
    return differences(piece.source, changed)


def differences(source: Source, changed: str) -> tuple[Edit, ...]:
    """The edits that make one text of another, in whole lines."""
    old, new = source.text.splitlines(keepends=True), changed.splitlines(keepends=True)
    starts = [0]
    for line in old:
        starts.append(starts[-1] + len(line))
    found = []
    for tag, a, b, c, d in SequenceMatcher(None, old, new, autojunk=False).get_opcodes():
        if tag != "equal":
            found.append(Edit(Span(source, starts[a], starts[b]), "".join(new[c:d])))
    return tuple(found)


def after(text: str, changes: Sequence[Edit]) -> str:
    """The text with edits that do not overlap."""
    return applied(text, (Replaced(item.span.start, item.span.end, item.text) for item in changes))


# ---- meaning ---------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Looked:
    """What the compiler says of a program with a file as it is, or as it would be."""

    analysis: Analysis
    codes: Counter[str] = field(default_factory=Counter)


def look(view: View, text: str | None = None) -> Looked:
    """Compile the program that a file is in, with the text as it is open or with another one."""
    program = view.program
    texts = {path: file.source.text for path, file in program.files.items()}
    texts[view.path] = view.source.text if text is None else text
    analysis = analyse(program.root, texts) if program.tried is None else program.tried(texts)
    return Looked(analysis, Counter(item.code for item in analysis.diagnostics))


def nothing_new(view: View, text: str, allowed: frozenset[str] = frozenset()) -> tuple[Looked, Looked]:
    """Compile the program as it is and as it would be with a new text of the file.

    While there are errors, what needs a whole model is not looked at. If the new text has none, what is said
    then but for errors is not new: it had to wait.

    Raises:
        Refused: There would be something new to complain of, but for `allowed` codes.
    """
    before, changed = look(view), look(view, text)
    new = changed.codes - before.codes
    waited = has_errors(before.analysis.diagnostics)
    for item in changed.analysis.diagnostics:
        if waited and item.severity is not Severity.ERROR:
            continue
        if item.code in new and item.code not in allowed:
            raise Refused(f"there would be something new to say: {_said(item)}")
    return before, changed


def same_meaning(
    view: View, text: str, *, exactly: bool = True, allowed: frozenset[str] = frozenset()
) -> None:
    """Make sure that a new text of the file says nothing else than the one that is open.

    With `exactly`, every chart has the same labels of states, and the same transitions between them. Without
    it, states that hold others may differ. The names of expressions (`let`) may differ in both cases. New
    diagnostics have only `allowed` codes.

    Raises:
        Refused: It does not, or that cannot be said because there are errors.
    """
    before, changed = nothing_new(view, text, allowed)
    if before.analysis.system is None:
        raise Refused("fix the errors first: what the model means is not known")
    if changed.analysis.system is None:
        raise Refused("the new text would have errors")
    read = _exact if exactly else _up_to_nesting
    charts = [
        {chart.name: read(chart) for chart in (*system.eacs, *system.iacs)}
        for system in (before.analysis.system, changed.analysis.system)
    ]
    for name, chart in charts[0].items():
        if charts[1].get(name) != chart:
            raise Refused(f"the statechart of {name} would do something else")


def _said(item: Diagnostic) -> str:
    return f"{item.code}: {item.message}"


def _exact(chart: Statechart) -> object:
    """All but what things are called, where they come from and where they are written."""
    states = [_plain(node) for node in chart.states]
    ways = [(_plain(item), _meaning(item)) for item in chart.transitions]
    variables = [(item.name, item.type, item.scope) for item in chart.variables]
    return sorted(states, key=str), sorted(ways, key=str), variables, chart.regions


def _plain(part: State | Transition) -> tuple[object, ...]:
    aside = ("name", "origin", "span", "expression")
    return tuple(getattr(part, item.name) for item in fields(part) if item.name not in aside)


def _up_to_nesting(chart: Statechart) -> object:
    activities = Counter(node.activity for node in chart.states if node.type is StateType.BASIC)
    texts = Counter(_meaning(item) for item in chart.transitions)
    texts.pop(TransitionKind.EXTERNAL.value, None)
    return activities, texts


def _meaning(transition: Transition) -> str:
    """What a transition waits for and does, with the expressions that names stand for."""
    written = transition.expression
    parts = ["[>" if transition.first else "", transition.kind.value, events_text(written) or ""]
    if written.condition is not None:
        parts.append(f"[{value_text(written.condition, expand=True)}]")
    parts += [f"/ {action_text(action, expand=True)}" for action in written.actions]
    return " ".join(filter(None, parts))


__all__ = [
    "Looked",
    "Owner",
    "Piece",
    "Refused",
    "Replaced",
    "after",
    "applied",
    "differences",
    "edits",
    "look",
    "nothing_new",
    "piece_at",
    "read_piece",
    "same_meaning",
    "same_owner",
]
