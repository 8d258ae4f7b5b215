"""Activity use: the activities of all charts, with what is said of them and what only looks like one."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import lru_cache
from typing import Literal

from aseme_dsl.amola.aip import Plays
from aseme_dsl.amola.srm import Activity
from aseme_dsl.amola.statechart import OriginKind, State, Statechart, StateType
from aseme_dsl.compiler.names.usecases import folded
from aseme_dsl.compiler.read.damage import Damaged
from aseme_dsl.compiler.read.library import is_of_library
from aseme_dsl.compiler.read.names import unknown
from aseme_dsl.diagnostics import Diagnostic, Related, closest
from aseme_dsl.diagnostics.problems.absences import NoActivityInFormulas
from aseme_dsl.diagnostics.problems.activities import (
    AlmostNamedLike,
    FormulaDescribed,
    NamedLikeParticipant,
    VariableOutOfReach,
)
from aseme_dsl.grammar.text import tree
from aseme_dsl.source import Span

_LONG = 5
"""How many letters a name has to have for one of them to be a typing error."""


_Named = Literal["activity", "formula", "participant"]
Used = Mapping[str, State]
"""Activities, each with the state where it stands first, in document order."""


def used_in(chart: Statechart) -> Used:
    """The activities of a chart."""
    found: dict[str, State] = {}
    for node in chart.states:
        if node.type is StateType.BASIC and node.activity is not None:
            found.setdefault(node.activity, node)
    return found


def used_activities(in_charts: Iterable[Used]) -> dict[str, State]:
    """The activities of all charts."""
    found: dict[str, State] = {}
    for used in in_charts:
        for name, node in used.items():
            found.setdefault(name, node)
    return found


def all_activities(in_roles: Iterable[Used], described: Mapping[str, Activity]) -> tuple[Activity, ...]:
    """The activities that roles perform: as described, else with nothing said of them."""
    return tuple(
        described.get(name) or Activity(name, (), None, None, "thread", (), (), (), node.span)
        for name, node in used_activities(in_roles).items()
    )


def check_described(
    written: Iterable[tree.Activity],
    used: Iterable[str],
    formulas: Iterable[tree.NamedFormula],
    is_damaged: Damaged,
) -> Iterator[Diagnostic]:
    """E204 for a description of an activity that no formula has, or of a formula."""
    used = set(used)
    named = {item.name.text: item.name.span for item in formulas}
    for item in written:
        name = item.name
        if name.text in used or is_damaged(item.span):
            continue
        if name.text in named:
            related = (Related(named[name.text], "the formula"),)
            yield Diagnostic(FormulaDescribed(name.text), name.span, related)
        else:
            yield unknown(NoActivityInFormulas, name, used)


def check_reach(written: Iterable[tree.Activity], chart: Statechart) -> Iterator[Diagnostic]:
    """E200 for a variable of a participant of which no state with the activity is inside."""
    scopes: dict[str, list[str]] = {}
    for variable in chart.variables:
        if variable.scope is not None:
            scopes.setdefault(variable.name.partition("@")[0], []).append(variable.scope)
    of_role = {variable.name for variable in chart.variables if variable.scope is None}
    for item in written if scopes else ():
        labels = [node.label for node in chart.states if node.activity == item.name.text]
        for path in (*item.writes, *(read.path for read in item.reads)):
            name = path.segments[0].text
            inside = scopes.get(name, ())
            if not labels or not inside or len(path.segments) > 1 or name in of_role:
                continue
            if not any(label.startswith(f"{scope}.") for label in labels for scope in inside):
                part = chart.by_label[inside[0]].name
                yield Diagnostic(VariableOutOfReach(item.name.text, name, part), path.span)


def close_names(
    used: Mapping[str, State],
    described: Mapping[str, Activity],
    formulas: Iterable[tree.NamedFormula],
    unused: Mapping[str, Plays],
) -> Iterator[Diagnostic]:
    """W200 for an activity whose name is close to a formula's or another activity's: is it misspelt?

    `unused` are the participants that a role plays and no formula of it uses: there, less closeness will do.
    A description that no formula has is E204, which says what it is close to. The protocols of the standard
    library have their own names: what a system calls its activities is not a misspelling of those.

    Close is: equal but for case and underscores, or one letter more, less, wrong or swapped in a name of five
    or more. Names that differ in a digit or a capital (`ScanA`, `ScanB`) are meant to differ.
    """
    used = {name: node for name, node in used.items() if not is_of_library(node.span.source)}
    declared: dict[str, tuple[Span, _Named]] = {}
    for formula in formulas:
        if formula.name.text != "process" and not is_of_library(formula.name.span.source):
            declared.setdefault(formula.name.text, (formula.name.span, "formula"))
    for name, activity in described.items():
        if name not in used:
            continue
        declared.setdefault(name, (activity.span, "activity"))
    new = [name for name in used if name not in declared]
    for name in new:
        declared.setdefault(name, (used[name].span, "activity"))
    near = _nearest(tuple(declared), tuple(new))
    for name in new:
        played = closest(name, unused)
        if played is not None:
            yield _close(name, used[name], played, unused[played].span, "participant")
        elif name in near:
            yield _close(name, used[name], near[name], *declared[near[name]])


@lru_cache(8)
def _nearest(declared: tuple[str, ...], new: tuple[str, ...]) -> Mapping[str, str]:
    """Of each new name that is close to others, which are declared before it, the first of these."""
    by_shape: dict[str, list[str]] = {}
    for name in declared:
        for shape in _shapes(folded(name)):
            by_shape.setdefault(shape, []).append(name)
    rank = {name: place for place, name in enumerate(declared)}
    found: dict[str, str] = {}
    for name in new:
        near = {
            other
            for shape in _shapes(folded(name))
            for other in by_shape[shape]
            if rank[other] < rank[name] and _is_close(name, other)
        }
        if near:
            found[name] = min(near, key=rank.__getitem__)
    return found


def _close(name: str, node: State, other: str, place: Span, kind: _Named) -> Diagnostic:
    related = (Related(place, f"`{other}`"),)
    return Diagnostic(AlmostNamedLike(name, other, kind), node.span, related, other)


def unplayed(iacs: Mapping[str, Used], aips: Iterable[tree.Aip]) -> Iterator[Diagnostic]:
    """W202 for an activity of a role that is called like a participant which the role does not play."""
    participants: dict[str, list[tuple[tree.Aip, tree.Participant]]] = {}
    for aip in aips:
        for part in aip.participants:
            participants.setdefault(part.name.text, []).append((aip, part))
    for role, used in iacs.items():
        for name in participants.keys() & used.keys():
            node = used[name]
            if node.origin.kind is OriginKind.FORMULA:
                alike = participants[name]
                related = tuple(
                    Related(part.name.span, f"the participant of {aip.name}") for aip, part in alike
                )
                protocols = tuple(aip.name.text for aip, _ in alike)
                yield Diagnostic(NamedLikeParticipant(name, protocols, role), node.span, related)


@lru_cache(maxsize=20_000)
def _shapes(name: str) -> Sequence[str]:
    """The name itself and all that lack one of its letters: close names share one of these."""
    if len(name) < _LONG:
        return (name,)
    return (name, *dict.fromkeys(name[:i] + name[i + 1 :] for i in range(len(name))))


@lru_cache(maxsize=20_000)
def _is_close(one: str, other: str) -> bool:
    if folded(one) == folded(other):
        return True
    if min(sum(char.isalpha() for char in name) for name in (one, other)) < _LONG:
        return False
    start = 0
    while start < min(len(one), len(other)) and one[start].lower() == other[start].lower():
        start += 1
    end = 0
    while end < min(len(one), len(other)) - start and one[-1 - end].lower() == other[-1 - end].lower():
        end += 1
    left, right = one[start : len(one) - end], other[start : len(other) - end]
    if all(char.isdigit() or char.isupper() for char in left + right):
        return False
    swapped = len(left) == 2 and left == right[::-1]
    return swapped or (len(left) <= 1 and len(right) <= 1)


__all__ = ["all_activities", "check_described", "close_names", "unplayed", "used_activities"]
