"""Diagram: the drawing that belongs to a place in a file, and the places that belong to what it shows.

A picture follows the cursor. `Diagrams.at` finds the model that the cursor is in, draws it, and finds the
element of the picture for that place. `elements` lead from each element back into the text.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import field, replace

from aseme_dsl.amola.statechart import State, Statechart, StateType
from aseme_dsl.amola.system import System
from aseme_dsl.diagnostics import Severity
from aseme_dsl.diagrams import (
    Drawing,
    DrawingFailed,
    GraphvizMissing,
    Layout,
    Options,
    PageSize,
    draw_one,
    names,
)
from aseme_dsl.diagrams.look.places import places
from aseme_dsl.diagrams.look.words import words
from aseme_dsl.diagrams.rendering.store import Store
from aseme_dsl.editor.files.index import Kind, Symbol
from aseme_dsl.editor.files.program import Program, errors_in_texts
from aseme_dsl.editor.files.view import View
from aseme_dsl.grammar.text import tree
from aseme_dsl.records import dataclass
from aseme_dsl.source import Source, Span

READABLE = 80
"""The most states that are shown at once where a statechart is drawn nested, as it has no compact drawing."""

TIME_LIMIT = 4.0
"""How long one run of Graphviz may take, in seconds."""

MISTAKES = "There are mistakes in the text: what they concern may be missing here."
EARLIER = "This is as it was before the mistakes that are in the text now."

COMPACT = Options(page=PageSize.SCREEN)
"""What has no room on a screen is closed."""

Draws = Callable[[str, Options], Drawing | None]
"""Draws a model of a system."""


@dataclass(frozen=True, slots=True)
class LiveDrawing:
    """A picture for a place in a file.

    `name` is the drawing's, `title` says what it shows. `elements` are the whole places of what is drawn, by
    the ids of the SVG; `here` is the id of what stands for the place that was asked about. `note` is what
    people should know of the picture, or "".
    """

    name: str
    title: str
    svg: str
    elements: Mapping[str, Span]
    here: str | None = None
    note: str = ""


@dataclass(frozen=True, slots=True)
class Shot:
    """What to draw: a model, for a statechart which part of it, and the ids that may stand for the place."""

    model: str
    options: Options = COMPACT
    here: tuple[str, ...] = ()


@dataclass(slots=True)
class Diagrams:
    """Makes live drawings; remembers pictures, and of each model the last that could be drawn."""

    store: Store = field(default_factory=Store)
    _program: Program | None = None
    _laid_out: dict[tuple[str, Options], Drawing | None] = field(default_factory=dict)
    _drawn: dict[tuple[str, Options], LiveDrawing] = field(default_factory=dict)
    _good: dict[tuple[str, str], LiveDrawing] = field(default_factory=dict)

    def at(self, view: View, offset: int) -> LiveDrawing | None:
        """The picture for an offset of the file; None where no model is meant.

        A model that cannot be drawn now is shown as it was drawn last, if it was.

        Raises:
            GraphvizMissing: there is no program that draws.
        """
        self._begin(view.program)
        system = system_of(view.program)
        last = ""
        for model in models_at(view, offset):
            last = last or model
            shot = aim(view, offset, system, model, lambda *what: self._lay_out(system, *what))
            if shot is None:
                continue
            if (view.program.root, last) in self._good and is_damaged(view.program, model):
                break  # what the compiler has left of it would be another model
            drawn = self._draw(system, shot)
            if drawn is not None:
                self._good[view.program.root, last] = drawn
                note = MISTAKES if errors_in_texts(view.program.diagnostics) else ""
                here = next((item for item in shot.here if item in drawn.elements), None)
                return replace(drawn, here=here, note=note)
        before = self._good.get((view.program.root, last))
        return None if before is None else replace(before, note=EARLIER)

    def of(self, program: Program, model: str, state: str | None = None) -> LiveDrawing | None:
        """The picture of a model, or of one state of its statechart; if need be as it was drawn last.

        Raises:
            GraphvizMissing: there is no program that draws.
        """
        self._begin(program)
        system = system_of(program)
        chart = system.chart(model)
        options = COMPACT
        if chart is not None:
            label = chart.root.label if state is None or state not in chart.by_label else state
            options = replace(COMPACT, at=_part(chart, label))
            laid_out = self._lay_out(system, model, options)
            if laid_out is not None and not laid_out.picture:
                depth = max(1, _deepest(_levels(chart, label)))
                at = label if label != chart.root.label else None
                options = Options(at=at, depth=depth, layout=Layout.NESTED)
        good = (program.root, f"{model} {state or ''}")
        drawn = None
        if good not in self._good or not is_damaged(program, model):
            drawn = self._draw(system, Shot(model, options))
        if drawn is None:
            before = self._good.get(good)
            return None if before is None else replace(before, note=EARLIER)
        self._good[good] = drawn
        return replace(drawn, note=MISTAKES if errors_in_texts(program.diagnostics) else "")

    def _begin(self, program: Program) -> None:
        """What was drawn of another program counts no more; its pictures are still in the store."""
        if self._program is not program:
            self._program = program
            self._laid_out.clear()
            self._drawn.clear()

    def _lay_out(self, system: System, model: str, options: Options) -> Drawing | None:
        key = (model, options)
        if key not in self._laid_out:
            self._laid_out[key] = draw_one(system, model, options)
        return self._laid_out[key]

    def _draw(self, system: System, shot: Shot) -> LiveDrawing | None:
        key = (shot.model, shot.options)
        if key not in self._drawn:
            drawing = self._lay_out(system, shot.model, shot.options)
            if drawing is None:
                return None
            try:
                svg = self.store.render(drawing, "svg", time_limit=TIME_LIMIT).decode()
            except GraphvizMissing:
                raise
            except DrawingFailed:
                return None
            self._drawn[key] = self._live(system, drawing, svg)
        return self._drawn[key]

    def _live(self, system: System, drawing: Drawing, svg: str) -> LiveDrawing:
        assert self._program is not None
        elements = {name: self._program.whole(span) for name, span in places(system, drawing).items()}
        return LiveDrawing(drawing.name, words(system, drawing), svg, elements)


def system_of(program: Program) -> System:
    """The system, or where there are errors as much of it as can be drawn."""
    found = program.inspection
    if found.analysis.system is not None:
        return found.analysis.system
    name = found.symbols.system.name.text if found.symbols.system is not None else ""
    return System(
        name,
        sag=found.sag,
        suc=found.suc,
        eacs=tuple(chart for chart in found.eacs.values() if chart is not None),
        iacs=tuple(chart for chart in found.iacs.values() if chart is not None),
    )


def models_of(program: Program) -> tuple[str, ...]:
    """The names of everything that can be drawn of a program."""
    return tuple(names(system_of(program)))


# ---- which model ----------------------------------------------------------------------------------


def models_at(view: View, offset: int) -> tuple[str, ...]:
    """The names of the drawings that may be meant by a place, the best one first."""
    declaration = view.declaration_at(offset)
    if declaration is None and view.earlier is not None:
        declaration = view.earlier.declaration_at(offset)
    match declaration:
        case tree.Sag():
            return ("sag",)
        case tree.Suc():
            return ("suc",)
        case tree.Aip():
            return (f"eac.{declaration.name}", f"aip.{declaration.name}")
        case tree.Srm():
            own = f"iac.{declaration.name}"
            others = (f"iac.{name}" for name in _having(view, offset) if f"iac.{name}" != own)
            return (own, *others, f"srm.{declaration.name}")
        case tree.Statechart():
            return (f"iac.{declaration.name}",)
    found = view.occurrence_at(offset)
    if found is None:
        return ()
    named = {Kind.ROLE: "iac", Kind.PROTOCOL: "eac"}.get(found.symbol.kind)
    return (f"{named}.{found.symbol.name}",) if named is not None else ()


def _having(view: View, offset: int) -> Iterator[str]:
    """The roles whose statecharts have something of this place: those that include what is written here."""
    part, inside = view.at(offset)
    for name, chart in view.program.inspection.iacs.items():
        if chart is not None and any(_holds(node.span, part, inside) for node in chart.states):
            yield name


def _holds(span: Span, part: Source, inside: int) -> bool:
    return span.source is part and span.start <= inside <= span.end


def is_damaged(program: Program, model: str) -> bool:
    """Whether there are mistakes of syntax in what a model is made from."""
    wrong = [
        item.span
        for item in program.diagnostics
        if item.span is not None and item.code.startswith("E1") and item.severity is Severity.ERROR
    ]
    if not wrong:
        return False
    kind, _, owner = model.partition(".")
    for declaration in _made_from(program, kind, owner):
        span = program.whole(declaration.span)
        if any(item.source is span.source and span.start <= item.start <= span.end for item in wrong):
            return True
    return False


def _played(
    item: tree.Aip | tree.Srm | tree.Statechart, declarations: Iterable[tree.Declaration]
) -> Iterator[tree.Aip]:
    """The protocols of which participants stand in a declaration, at any depth."""
    protocols = {one.name.text: one for one in declarations if isinstance(one, tree.Aip)}
    waiting: list[tree.Aip | tree.Srm | tree.Statechart] = [item]
    seen: set[str] = set()
    while waiting:
        found = waiting.pop()
        players: Iterable[tree.Srm | tree.Participant] = ()
        if isinstance(found, tree.Aip):
            players = found.participants
        elif isinstance(found, tree.Srm):
            players = (found,)
        for name in (play.protocol.text for player in players for play in player.plays):
            if name in protocols and name not in seen:
                seen.add(name)
                waiting.append(protocols[name])
                yield protocols[name]


def _made_from(program: Program, kind: str, owner: str) -> Iterator[tree.Declaration]:
    """The declarations that a model is made from, with the protocols that are played in it."""
    declarations = [item for file in program.files.values() for item in file.declarations]
    for item in declarations:
        match item:
            case tree.Sag():
                if kind == "sag":
                    yield item
            case tree.Suc():
                if kind == "suc":
                    yield item
            case tree.Aip():
                if kind in ("aip", "eac") and item.name.text == owner:
                    yield item
                    yield from _played(item, declarations)
            case tree.Statechart() | tree.Srm():
                if kind in ("srm", "iac") and item.name.text == owner:
                    yield item
                    yield from _played(item, declarations)


# ---- which part of it -----------------------------------------------------------------------------


def aim(view: View, offset: int, system: System, model: str, draws: Draws) -> Shot | None:
    """What to draw of a model, so that the place is in it; None if the system has no such model."""
    chart = system.chart(model)
    part, inside = view.at(offset)
    if chart is None:
        drawing = draws(model, COMPACT)
        if drawing is None:
            return None
        # Their places are their names; what is said of them follows.
        before = [
            (inside - span.start, name)
            for name, span in places(system, drawing).items()
            if span.source is part and span.start <= inside
        ]
        return Shot(model, here=tuple(name for _, name in sorted(before)))
    label, elements = _meant(view, offset, chart)
    shown = [f"n{node.label}" for node in chart.ancestors(label)]
    return Shot(model, _opened(chart, label, model, draws), (*elements, f"n{label}", *shown))


def _opened(chart: Statechart, label: str, model: str, draws: Draws) -> Options:
    """What shows a state: the page where what is around it is open."""
    options = COMPACT
    while drawing := draws(model, options):
        if not drawing.picture:
            at, depth = framed(chart, label)
            return Options(at=at, depth=depth, layout=Layout.NESTED)
        around = next((item for item in drawing.closed if label.startswith(f"{item}.")), None)
        if around is None or _part(chart, around) in (None, options.at):
            break
        options = replace(options, at=_part(chart, around))
    return options


def _part(chart: Statechart, label: str) -> str | None:
    """The innermost state that has a compact drawing and holds a state; None is the whole statechart."""
    around = (chart.node(label), *chart.ancestors(label))
    found = next((node.label for node in around if node.type is StateType.OR), chart.root.label)
    return found if found != chart.root.label else None


_RANKS = {StateType.BASIC: 0, StateType.OR: 1, StateType.AND: 1, StateType.CONDITION: 2}


def _meant(view: View, offset: int, chart: Statechart) -> tuple[str, tuple[str, ...]]:
    """The label of the state that a place is about, and the ids of what stands for it, the best first."""
    part, inside = view.at(offset)
    found: list[tuple[int, int, int, str, str]] = []
    for place, node in enumerate(chart.states):
        if _holds(node.span, part, inside):
            size = node.span.end - node.span.start
            found.append((size, _RANKS.get(node.type, 4), place, node.label, f"n{node.label}"))
    for place, way in enumerate(chart.transitions):
        if _holds(way.span, part, inside):
            found.append((way.span.end - way.span.start, 3, place, way.source, f"t{place}"))
    if found:
        found.sort()
        return found[0][3], tuple(item[4] for item in found if item[0] == found[0][0])
    occurrence = view.occurrence_at(offset)
    named = _named(chart, occurrence.symbol) if occurrence is not None else []
    if named:
        return named[0].label, tuple(f"n{node.label}" for node in named)
    return chart.root.label, ()


def _named(chart: Statechart, symbol: Symbol) -> list[State]:
    """The states that a name is about."""
    match symbol.kind:
        case Kind.ACTIVITY:
            return [node for node in chart.states if node.activity == symbol.name]
        case Kind.FORMULA:
            owner = symbol.owner.rpartition(".")[2]
            return [
                node
                for node in chart.states
                if node.origin.name == symbol.name and node.origin.owner.rpartition(".")[2] == owner
            ]
        case Kind.STATE:
            return [node for node in chart.states if node.label == symbol.name]
    return []


def framed(chart: Statechart, label: str) -> tuple[str | None, int | None]:
    """The outermost state, and how many levels of it, that show `label` among at most `READABLE` states.

    None is the whole statechart, and all levels. Where there are too many states side by side, they are shown
    all the same.
    """
    if len(chart.states) <= READABLE:
        return None, None
    around = [node.label for node in reversed(list(chart.ancestors(label)))]
    if chart.children(label) or not around:
        around.append(label)
    for at in around:
        needed = max(label.count(".") - at.count("."), 1)
        depth = _deepest(_levels(chart, at))
        if depth >= needed:
            return at if at != chart.root.label else None, depth
    return around[-1], 1


def _levels(chart: Statechart, at: str) -> list[int]:
    """How many states there are at each level from `at` downwards."""
    levels: list[int] = []
    states: Sequence[State] = (chart.node(at),)
    while states:
        levels.append(len(states))
        states = [child for node in states for child in chart.children(node.label)]
    return levels


def _deepest(levels: Sequence[int]) -> int:
    """The greatest depth at which at most `READABLE` states are shown."""
    total = 0
    for depth, number in enumerate(levels):
        total += number
        if total > READABLE:
            return depth - 1
    return len(levels)


__all__ = ["EARLIER", "MISTAKES", "READABLE", "Diagrams", "LiveDrawing", "models_of"]
