"""Playing: the participants of protocols that a role plays, or a participant of another protocol."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence, Set
from dataclasses import replace
from itertools import pairwise

from aseme_dsl.amola.aip import Plays
from aseme_dsl.amola.expression import Outcome, values_of
from aseme_dsl.amola.liveness import called, names
from aseme_dsl.compiler.chart.busy import busy_of
from aseme_dsl.compiler.chart.chart import Part, Protocol
from aseme_dsl.compiler.control.control import Lines, read_lines
from aseme_dsl.compiler.control.stopping import stops_of
from aseme_dsl.compiler.formula import formulas as formula_tables
from aseme_dsl.compiler.formula.formula_to_statechart import FRAME, Branch, too_large
from aseme_dsl.compiler.formula.formulas import Formulas
from aseme_dsl.compiler.formula.interrupts import with_interrupts
from aseme_dsl.compiler.names.scope import Scope
from aseme_dsl.compiler.names.symbols import Symbols
from aseme_dsl.compiler.read.damage import Damaged
from aseme_dsl.compiler.read.missing import Missing
from aseme_dsl.compiler.read.names import unknown
from aseme_dsl.compiler.types.given import Supplied, give, supplied_names, supply
from aseme_dsl.diagnostics import Diagnostic, Edit, Related
from aseme_dsl.diagnostics.problems.absences import NoActivityToBind, NoParticipant, NoProtocol
from aseme_dsl.diagnostics.problems.activities import BoundToOtherParameters
from aseme_dsl.diagnostics.problems.formulas import FormulaNotUsed, ProcessRestated
from aseme_dsl.diagnostics.problems.missing import ParticipantNotUsed
from aseme_dsl.diagnostics.problems.names import (
    BoundToExpression,
    BoundToParticipant,
    BoundTwice,
    EmptyFormulaInLoop,
    FormulaOfParticipant,
    OutcomeOfFormula,
    ParticipantNameTaken,
    ProtocolsInCircle,
)
from aseme_dsl.grammar.text import tree
from aseme_dsl.records import dataclass
from aseme_dsl.source import Span

Player = tree.Srm | tree.Participant
"""Who plays."""


@dataclass(frozen=True, slots=True)
class Woven:
    """The formulas of a player with their control, and what they may use of what is played.

    `named` has it by all the names that the formulas may use for it, `branches` its processes, as far as they
    could be read. `expandable` says whether all of it can become states.
    """

    formulas: Formulas
    named: Mapping[str, Plays]
    branches: Mapping[str, Branch]
    lines: Lines
    expandable: bool


def weave(
    player: Player,
    formulas: Formulas,
    plays: Sequence[Plays],
    parts: Mapping[tuple[str, str], Part],
    controls: Sequence[tuple[tree.Control, str]],
    scope: Scope,
    largest: int,
    damaged: bool,
    regions: int = 1,
) -> tuple[Woven, tuple[Diagnostic, ...]]:
    """What a player says of itself, and all that is wrong with it.

    `parts` are the sound ones among the processes that it plays, `controls` its control blocks, each with the
    formula that it is about. `regions` is how often the whole stands in the chart.
    """
    of_participant = isinstance(player, tree.Participant)
    formulas, named, branches = _played_in(formulas, plays, parts)
    found: list[Diagnostic] = []
    formulas, problems = give(formulas, scope, named)
    found += problems
    found += _other_parameters(player, plays, formulas, scope.symbols)
    is_empty, empty_bound = _emptiness(branches, parts)
    formulas = with_interrupts(formulas, controls)
    inside = {owner: part.formulas for owner, part in parts.items()}
    lines, problems = read_lines(formulas, controls, scope, inside, named, of_participant=of_participant)
    found += problems
    expandable, problems = formula_tables.check(formulas, is_empty, frozenset(named), stops_of(lines.by_way))
    # A formula that could not be read may be the one that uses another.
    found += [item for item in problems if not (damaged and isinstance(item.problem, FormulaNotUsed))]
    # What is played and could not be read would stand as an activity.
    if expandable and len(plays) == len(player.plays) and len(branches) == len(named):
        found += _unfit_formulas(player, plays, branches, parts, empty_bound)
        frame = FRAME if of_participant else 0
        problem = too_large(formulas, branches, largest, player.name.span, regions, frame)
        found += [] if problem is None else [problem]
        expandable = problem is None
    else:
        expandable = False
    return Woven(formulas, named, branches, lines, expandable), tuple(found)


def _played_in(
    formulas: Formulas, plays: Sequence[Plays], parts: Mapping[tuple[str, str], Part]
) -> tuple[Formulas, dict[str, Plays], dict[str, Branch]]:
    """The formulas, which know what stands in the participants that they name; what is played, by name."""
    own = {item.name: item for item in plays}
    named = own | _by_own_name(plays, own, formulas)
    through = {
        name: tuple(other for _, other in item.bindings if other in formulas.named)
        for name, item in named.items()
    }
    branches = {
        name: parts[item.protocol, item.participant].branch(item)
        for name, item in named.items()
        if (item.protocol, item.participant) in parts
    }
    return replace(formulas, through=through), named, branches


def in_order(
    protocols: Sequence[tree.Aip],
) -> tuple[tuple[tree.Aip, ...], frozenset[str], tuple[Diagnostic, ...]]:
    """The protocols, each after those whose participants play a part in it; E594 for those in a circle.

    The names of the latter are the second that is given: what they play cannot be woven in.
    """
    known = {item.name.text: item for item in protocols}
    uses = {
        name: {
            play.protocol.text: play
            for party in reversed(item.participants)
            for play in reversed(party.plays)
            if play.protocol.text in known
        }
        for name, item in known.items()
    }
    order: list[tree.Aip] = []
    circles: list[list[str]] = []
    started: set[str] = set()
    for name in known:
        chain = {} if name in started else {name: iter(uses[name])}
        started.add(name)
        while chain:
            inner = next(reversed(chain))
            for use in chain[inner]:
                if use in chain:
                    around = list(chain)
                    circles.append(around[around.index(use) :])
                elif use not in started:
                    started.add(use)
                    chain[use] = iter(uses[use])
                    break
            else:
                order.append(known[inner])
                del chain[inner]
    in_circle: set[str] = set()
    found: list[Diagnostic] = []
    for circle in circles:
        if in_circle.isdisjoint(circle):
            found.append(_circle(circle, uses))
        in_circle.update(circle)
    return tuple(order), frozenset(in_circle), tuple(found)


def _circle(circle: Sequence[str], uses: Mapping[str, Mapping[str, tree.Plays]]) -> Diagnostic:
    """E594, told where the first protocol by name plays the next one."""
    first = circle.index(min(circle))
    names = (*circle[first:], *circle[:first], circle[first])
    places = [uses[name][other].span for name, other in pairwise(names)]
    related = tuple(Related(place, "and here") for place in places[1:])
    return Diagnostic(ProtocolsInCircle(names), places[0], related)


def with_inside(parts: Mapping[tuple[str, str], Part]) -> dict[tuple[str, str], Part]:
    """The parts, and those that stand in them."""
    found = dict(parts)
    for part in parts.values():
        found.update(part.inside)
    return found


def _may_be_empty(
    branch: Branch, parts: Mapping[tuple[str, str], Part], activities: Collection[str]
) -> tuple[bool, tuple[Diagnostic, ...]]:
    """Whether a participant may do nothing at all, and its loops over such, also in what it plays itself.

    `activities` are those for which something stands that may be done at once.
    """
    empty, loops = list(activities), list[Diagnostic]()
    for name, inner in branch.played.items():
        bound = [activity for activity, own in inner.bindings.items() if own in activities]
        is_empty, found = _may_be_empty(inner, parts, bound)
        empty += [name] if is_empty else []
        loops += found
    stops = stops_of(parts[branch.protocol, branch.participant].lines.by_way)
    is_empty, found = formula_tables.may_be_empty(branch.formulas, stops, empty)
    return is_empty, (*found, *loops)


def read_plays(
    written: Player,
    formulas: Formulas | None,
    protocols: Mapping[str, Protocol],
    scope: Scope,
    is_damaged: Damaged,
) -> tuple[tuple[Plays, ...], dict[tuple[str, str], Part], tuple[Diagnostic, ...]]:
    """What a role or a participant plays, by the names that its formulas use: E205, E206, E213, E306."""
    found: list[Diagnostic] = []
    plays: dict[str, Plays] = {}
    parts: dict[tuple[str, str], Part] = {}
    own_formulas: Collection[str] = ()
    if isinstance(written, tree.Participant) and formulas is not None:
        own_formulas = formulas.named
    for item in written.plays:
        protocol = protocols.get(item.protocol.text)
        if protocol is None:
            if not scope.symbols.is_excused(item.protocol.text):
                found.append(unknown(NoProtocol, item.protocol, protocols))
            continue
        participants = {p.name.text: p for p in protocol.written.participants}
        if item.participant.text not in participants:
            if not is_damaged(protocol.written.span):
                named = item.protocol.text
                found.append(unknown(NoParticipant, item.participant, participants, named))
            continue
        name = item.alias or item.participant
        earlier = plays.get(name.text)
        if earlier is not None:
            found.append(_same_name(name, earlier))
            continue
        part = protocol.parts.get(item.participant.text)
        bindings: dict[str, str] = {}
        supplied = Supplied()
        busy, problems = busy_of(item, participants[item.participant.text], scope)
        found += problems
        if part is not None:
            parts[protocol.name, part.participant] = part
            party = participants[item.participant.text]
            bindings, problems = _bindings(item, part, party, _played_names(written), own_formulas)
            found += problems
            supplied, problems = supply(item, part.inputs, part.results, part.variables, scope)
            found += problems
        plays[name.text] = Plays(
            item.protocol.text,
            item.participant.text,
            name.text,
            tuple(bindings.items()),
            item.span,
            supplied.inputs,
            supplied.results,
            busy,
        )
        restated = formulas.named.get(name.text) if formulas is not None else None
        if restated is not None:
            found.append(_restated(restated, written, item, participants[item.participant.text]))
    return tuple(plays.values()), with_inside(parts), tuple(found)


def _same_name(name: tree.Name, earlier: Plays) -> Diagnostic:
    problem = ParticipantNameTaken(name.text, earlier.protocol, earlier.participant)
    return Diagnostic(problem, name.span, (Related(earlier.span, "here"),))


def _restated(
    formula: tree.NamedFormula, player: Player, plays: tree.Plays, participant: tree.Participant
) -> Diagnostic:
    """E306, with the fix where a role calls its participant as charts do (`talk_desk`), not by its name."""
    related = [Related(plays.span, "the role plays it here")]
    related += [
        Related(item.span, "its process") for item in participant.formulas if item.name.text == "process"
    ]
    name, protocol = formula.name.text, plays.protocol.text
    is_role = isinstance(player, tree.Srm) and formula is player.formulas[0] and plays.alias is None
    problem = ProcessRestated(name, protocol, plays.participant.text, is_role)
    meant = [
        Edit(node.span, name)
        for node in names(formula.formula)
        if is_role and node.name == f"{protocol}_{name}"
    ]
    return Diagnostic(problem, formula.name.span, tuple(related), edits=tuple(meant))


def _bindings(
    written: tree.Plays,
    part: Part,
    party: tree.Participant,
    played: Mapping[str, Span],
    formulas: Collection[str],
) -> tuple[dict[str, str], tuple[Diagnostic, ...]]:
    """The protocol's activities, and the activities or formulas of the player that stand for them (E206).

    `formulas` are those of a participant. They may send messages of its own conversation, and stand inside
    of another one: none of them can be bound.
    """
    activities = part.bindable
    others = {name.text for name in supplied_names(party)}
    found: list[Diagnostic] = []
    bindings: dict[str, str] = {}
    seen: set[str] = set()
    for item in written.bindings:
        abstract = item.abstract.text
        if abstract in seen:
            found.append(Diagnostic(BoundTwice(abstract), item.abstract.span))
        elif abstract in others:
            pass  # see `supply`
        elif abstract not in activities:
            pool = (*sorted(activities), *others)
            none = unknown(NoActivityToBind, item.abstract, pool, part.protocol, part.participant)
            related = (Related(part.formulas.named[part.formulas.root].span, "its process"),)
            found.append(replace(none, related=related))
        elif item.own is None:
            found.append(Diagnostic(BoundToExpression(abstract), item.expression.span))
        elif item.own.text in played:
            own = item.own.text
            found.append(
                Diagnostic(BoundToParticipant(own), item.own.span, (Related(played[own], "played here"),))
            )
        elif item.own.text in formulas:
            found.append(Diagnostic(FormulaOfParticipant(abstract, item.own.text), item.own.span))
        else:
            bindings[abstract] = item.own.text
        seen.add(abstract)
    return bindings, tuple(found)


def _other_parameters(
    written: Player, plays: Iterable[Plays], formulas: Formulas, symbols: Symbols
) -> Iterable[Diagnostic]:
    """E525 for a binding to what is given something else than the protocol gives it."""
    for _, binding, own in _bound(written, plays):
        abstract = symbols.activities.get(binding.abstract.text)
        wanted = [kind.type for kind in abstract.parameters] if abstract is not None else []
        form = symbols.activities.get(own)
        known = [] if abstract is None else [abstract]
        if own in formulas.named:
            has = formulas.parameters.get(own, ())
            if len(has) != len(formulas.named[own].parameters):
                continue  # that is said
            related = [Related(formulas.named[own].name.span, "the formula")]
        else:
            has = form.parameters if form is not None else ()
            known += [] if form is None else [form]
            related = []
        if wanted == [kind.type for kind in has]:
            continue
        if symbols.is_excused(own) or symbols.is_excused(binding.abstract.text):
            continue
        related += [Related(one.span, f"`{called(one.name, map(str, one.parameters))}`") for one in known]
        problem = BoundToOtherParameters(binding.abstract.text, own, tuple(map(str, wanted)))
        yield Diagnostic(problem, binding.expression.span, tuple(related))


def _bound(written: Player, plays: Iterable[Plays]) -> Iterator[tuple[Plays, tree.Binding, str]]:
    """The sound bindings of a role, each with what stands for the protocol's activity."""
    by_span = {item.span: item for item in plays}
    for play in written.plays:
        item = by_span.get(play.span)
        bindings = dict(item.bindings) if item is not None else {}
        for binding in play.bindings:
            own = bindings.get(binding.abstract.text)
            if item is not None and own is not None and binding.own is not None and binding.own.text == own:
                yield item, binding, own


def _emptiness(
    branches: Mapping[str, Branch], parts: Mapping[tuple[str, str], Part]
) -> tuple[formula_tables.IsEmpty, dict[tuple[str, str], tuple[Diagnostic, ...]]]:
    """Whether a participant may do nothing at all; and, filled meanwhile, loops over bound formulas that may.

    The loops are known by the name of the participant and that of the formula.
    """
    known: dict[str, bool] = {}
    loops: dict[tuple[str, str], tuple[Diagnostic, ...]] = {}

    def is_empty(name: str, formulas: Set[str]) -> bool:
        branch = branches.get(name)
        if branch is None:
            return False
        if name not in known:
            bound = [activity for activity, own in branch.bindings.items() if own in formulas]
            known[name], _ = _may_be_empty(branch, parts, bound)
            for activity in bound:
                _, loops[name, activity] = _may_be_empty(branch, parts, (activity,))
        return known[name]

    return is_empty, loops


def _unfit_formulas(
    written: Player,
    plays: Iterable[Plays],
    branches: Mapping[str, Branch],
    parts: Mapping[tuple[str, str], Part],
    loops: Mapping[tuple[str, str], tuple[Diagnostic, ...]],
) -> Iterable[Diagnostic]:
    """E593 for a formula that stands for an activity of whose outcome is asked, or in an empty loop."""
    for item, binding, own in _bound(written, plays):
        part = parts[item.protocol, item.participant]
        activity = binding.abstract.text
        asked = next(_outcomes_asked(part, activity, parts), None)
        formula = next((one for one in written.formulas if one.name.text == own), None)
        if asked is not None and formula is not None:
            related = (Related(asked.span, "asked here"), Related(formula.name.span, "the formula"))
            yield Diagnostic(OutcomeOfFormula(activity, own), binding.expression.span, related)
        for loop in loops.get((item.name, activity), ())[:1]:
            places = () if loop.span is None else (Related(loop.span, "the loop"),)
            yield Diagnostic(EmptyFormulaInLoop(activity, own), binding.expression.span, places)


def _outcomes_asked(part: Part, activity: str, parts: Mapping[tuple[str, str], Part]) -> Iterator[Outcome]:
    """Where a participant asks for the outcome of an activity, also in what it plays itself."""
    for lines in part.lines.by_way.values():
        for line in lines:
            for value in values_of(line.expression):
                if isinstance(value, Outcome) and value.activity == activity:
                    yield value
    for branch in part.played.values():
        for inner, own in branch.bindings.items():
            if own == activity:
                yield from _outcomes_asked(parts[branch.protocol, branch.participant], inner, parts)


def _by_own_name(plays: Sequence[Plays], played: Mapping[str, Plays], formulas: Formulas) -> dict[str, Plays]:
    """Participants that have another name in the role and may be called by their own as well."""
    found: dict[str, list[Plays]] = {}
    for item in plays:
        if item.participant not in played and item.participant not in formulas.named:
            found.setdefault(item.participant, []).append(item)
    return {name: items[0] for name, items in found.items() if len(items) == 1}


def unused_plays(formulas: Formulas, plays: Sequence[Plays]) -> Iterable[Plays]:
    """What is played and no formula uses."""
    used = {node.name for item in formulas.named.values() for node in names(item.formula)}
    named = _by_own_name(plays, {item.name: item for item in plays}, formulas)
    used.update(item.name for name, item in named.items() if name in used)
    return (item for item in plays if item.name not in used and item.name not in formulas.named)


def not_used(player: str, formulas: Formulas, item: Plays, block: Span) -> Missing:
    """N702 for what a role or participant plays and no formula of it uses."""
    problem = ParticipantNotUsed(player, item.protocol, item.participant, item.name, formulas.root)
    note = Diagnostic(problem, item.span)
    return Missing(note, f"// Let a formula use the participant {item.name}.", block)


def _played_names(written: Player) -> dict[str, Span]:
    return {(item.alias or item.participant).text: item.span for item in written.plays}


__all__ = [
    "Woven",
    "in_order",
    "not_used",
    "read_plays",
    "unused_plays",
    "weave",
    "with_inside",
]
