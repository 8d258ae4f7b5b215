"""Inclusion: roles that take over what others say, as if it were written in them (`includes`)."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import field, replace
from typing import TypeVar

from aseme_dsl.compiler.names.usecases import folded
from aseme_dsl.compiler.read.blocks import Blocks
from aseme_dsl.compiler.read.damage import Damaged
from aseme_dsl.compiler.read.library import is_of_library
from aseme_dsl.compiler.read.names import unknown
from aseme_dsl.diagnostics import Diagnostic, Related, Severity
from aseme_dsl.diagnostics.problems import names as problems
from aseme_dsl.diagnostics.problems.absences import NoRole
from aseme_dsl.diagnostics.problems.formulas import FormulaNotUsed, RoleWithoutFormula
from aseme_dsl.grammar.formulas.expression import spelled
from aseme_dsl.grammar.text import tree
from aseme_dsl.records import dataclass
from aseme_dsl.source import Span

_T = TypeVar("_T")


@dataclass(frozen=True, slots=True)
class Inclusion:
    """The blocks, where each role has all that it includes; abstract roles only occur inside others.

    `included` has, for each role, the roles that it includes, directly or not, in order. `abstract` are the
    abstract roles, `unused` those of them that no role includes.
    """

    blocks: Blocks
    included: Mapping[str, tuple[tree.Srm, ...]] = field(default_factory=dict)
    abstract: tuple[tree.Srm, ...] = ()
    unused: tuple[tree.Srm, ...] = ()
    incomplete: frozenset[str] = frozenset()
    """Roles that name one that there is not, or that includes itself: what is missing there means nothing."""

    def names(self, role: str) -> tuple[str, ...]:
        """The roles that a role takes over, directly or not."""
        return tuple(item.name.text for item in self.included.get(role, ()))

    def damaged(self, is_damaged: Damaged) -> Damaged:
        """`is_damaged` for roles as they are now: also by what is wrong in the text that they take over."""
        if not self.included and not self.incomplete:
            return is_damaged
        others = {
            item.span: tuple(other.span for other in self.included.get(item.name.text, ()))
            for item in self.blocks.srms
        }
        lacking = {item.span for item in self.blocks.srms if item.name.text in self.incomplete}

        def is_damaged_somewhere(span: Span) -> bool:
            return span in lacking or is_damaged(span) or any(map(is_damaged, others.get(span, ())))

        return is_damaged_somewhere

    def once(self, found: Sequence[Diagnostic]) -> tuple[Diagnostic, ...]:
        """The diagnostics with one for each problem of a text that several roles take over."""
        shared = [item.span for items in self.included.values() for item in items]
        if not shared:
            return tuple(found)
        seen: set[tuple[str, Span]] = set()
        kept: list[Diagnostic] = []
        for item in found:
            if item.span is not None and any(_holds(span, item.span) for span in shared):
                key = (item.code, item.span)
                if key in seen:
                    continue
                seen.add(key)
            kept.append(item)
        return tuple(kept)


def include(
    blocks: Blocks, is_excused: Callable[[str], bool], all_read: bool = True
) -> tuple[Inclusion, tuple[Diagnostic, ...]]:
    """Roles with what they include: E207, E221, E222, E223 and, for abstract ones, W550.

    A name that `is_excused` may be declared in what could not be read; unless `all_read`, so may what
    includes a role.
    """
    srms = {item.name.text: item for item in blocks.srms}
    if not any(item.includes or item.abstract for item in srms.values()):
        return Inclusion(blocks), ()
    found: list[Diagnostic] = []
    direct: dict[str, list[tuple[tree.Name, tree.Srm]]] = {}
    incomplete: set[str] = set()
    charts = {item.name.text: item for item in blocks.statecharts}
    for name, item in srms.items():
        direct[name] = []
        for other in item.includes:
            if other.text in srms:
                direct[name].append((other, srms[other.text]))
                continue
            incomplete.add(name)
            if other.text in charts:
                found.append(_is_chart(other, charts[other.text]))
            elif not is_excused(other.text):
                found.append(unknown(NoRole, other, srms.keys() - {name}))
    for circle in _circles(direct):
        found.append(_circle(circle))
        incomplete.update(name for name, _ in circle)
    included: dict[str, tuple[tree.Srm, ...]] = {}
    complete: dict[str, tree.Srm] = {}
    for name, item in srms.items():
        parts = _parts(item, direct)
        if not incomplete.isdisjoint(parts):
            incomplete.add(name)
        included[name] = tuple(part for _, part in parts.values())
        complete[name], twice = _taken_over(item, tuple(parts.values()))
        found += twice
    used = {part.name.text for parts in included.values() for part in parts}
    abstract = tuple(item for item in srms.values() if item.abstract)
    unused = tuple(complete[item.name.text] for item in abstract if item.name.text not in used)
    of_users = (item for item in unused if not is_of_library(item.name.span.source))
    found += map(_nobody_includes, of_users if all_read else ())
    roles = tuple(
        complete[item.name.text] if isinstance(item, tree.Srm) else item
        for item in blocks.roles
        if not (isinstance(item, tree.Srm) and item.abstract)
    )
    made = Inclusion(
        replace(blocks, roles=roles),
        {name: parts for name, parts in included.items() if parts},
        abstract,
        unused,
        frozenset(incomplete),
    )
    return made, _once_by_pair(found)


def complete(role: tree.Srm, roles: Iterable[tree.Srm]) -> tree.Srm:
    """A role with all that it includes of these; a role that is not among them is left out."""
    if not role.includes:
        return role
    known = {item.name.text: item for item in roles} | {role.name.text: role}
    direct = {
        name: [(other, known[other.text]) for other in item.includes if other.text in known]
        for name, item in known.items()
    }
    return _taken_over(role, tuple(_parts(role, direct).values()))[0]


def includers(roles: Iterable[tree.Srm]) -> dict[str, tuple[str, ...]]:
    """Of each role that others include those others, directly or not, in document order."""
    direct = {item.name.text: [name.text for name in item.includes] for item in roles}
    found: dict[str, list[str]] = {}
    for name in direct:
        seen = {name}
        waiting = list(direct[name])
        while waiting:
            other = waiting.pop()
            if other in direct and other not in seen:
                seen.add(other)
                found.setdefault(other, []).append(name)
                waiting += direct[other]
    return {name: tuple(others) for name, others in found.items()}


# ---- taking over ---------------------------------------------------------------------------------


def _parts(
    item: tree.Srm, direct: Mapping[str, Sequence[tuple[tree.Name, tree.Srm]]]
) -> dict[str, tuple[tree.Name, tree.Srm]]:
    """What a role takes over, directly or not, each with the name in its head through which it does."""
    parts: dict[str, tuple[tree.Name, tree.Srm]] = {}
    waiting = list(reversed(direct[item.name.text]))
    first_names = {id(part): other for other, part in waiting}
    while waiting:
        other, part = waiting.pop()
        if part.name.text in parts or part is item:
            continue
        parts[part.name.text] = (first_names.get(id(part), other), part)
        waiting += [(other, inner) for _, inner in reversed(direct[part.name.text])]
    return parts


def _taken_over(
    item: tree.Srm, parts: Sequence[tuple[tree.Name, tree.Srm]]
) -> tuple[tree.Srm, tuple[Diagnostic, ...]]:
    """A role with what it includes: its own first, then that of the others in their order."""
    if not parts:
        return item, ()
    found: list[Diagnostic] = []
    replaced: set[str] = set()
    """The formulas that stand twice: their control then does, too, which is not said again."""

    def joined(kind: str, what: problems.Part) -> tuple[_T, ...]:
        """What all have of a kind; of two of one name the first counts (E223), unless they say the same."""
        own: tuple[_T, ...] = getattr(item, kind)
        items = list(own)
        names = {_name_of(one): one for one in own}
        for other, part in parts:
            for one in getattr(part, kind):
                first = names.setdefault(_name_of(one), one)
                if first is one:
                    items.append(one)
                elif _plain(first) != _plain(one) and not (kind == "controls" and _name_of(one) in replaced):
                    if kind == "formulas":
                        replaced.add(_name_of(one))
                    found.append(_twice(item, what, other, part, first, one))
        return tuple(items)

    complete = replace(
        item,
        plays=joined("plays", "participant"),
        capabilities=joined("capabilities", "capability"),
        variables=joined("variables", "variable"),
        lets=joined("lets", "let"),
        formulas=joined("formulas", "formula"),
        activities=item.activities + tuple(one for _, part in parts for one in part.activities),
        modules=joined("modules", "module"),
        functionalities=joined("functionalities", "functionality"),
        controls=joined("controls", "control"),
    )
    return complete, tuple(found)


def _name_of(one: object) -> str:
    match one:
        case tree.Plays():
            return (one.alias or one.participant).text
        case tree.Capability():
            return folded(one.name.text)
        case (
            tree.Var()
            | tree.Let()
            | tree.NamedFormula()
            | tree.Module()
            | tree.Functionality()
            | tree.Control()
        ):
            return one.name.text
    raise AssertionError(f"a {type(one).__name__} is not a part of a role")


def _plain(one: object) -> object:
    """What must agree for two to be the same: plays and functionalities say all of it themselves."""
    match one:
        case tree.Plays():
            bindings = {(item.abstract.text, spelled(item.expression)) for item in one.bindings}
            busy = "" if one.busy is None else " ".join(one.busy.span.text.split())
            return one.protocol.text, one.participant.text, frozenset(bindings), busy
        case tree.Functionality():
            texts = (one.technology, one.permissions, one.environment, one.algorithm)
            return tuple(text.text if text is not None else "" for text in texts)
    return id(one)


def _span_of(one: object) -> Span:
    if isinstance(one, tree.Plays):
        return one.span
    name = one.name if hasattr(one, "name") else None
    assert isinstance(name, tree.Name)
    return name.span


def _twice(
    item: tree.Srm, kind: problems.Part, other: tree.Name, part: tree.Srm, first: object, second: object
) -> Diagnostic:
    is_own = _holds(item.span, _span_of(first))
    return Diagnostic(
        problems.IncludedTwice(item.name.text, kind, _shown(second), part.name.text, is_own),
        other.span,
        (Related(_span_of(first), "the one"), Related(_span_of(second), "the other")),
    )


def _shown(one: object) -> str:
    if isinstance(one, tree.Plays):
        return (one.alias or one.participant).text
    return _span_of(one).text


def _holds(outer: Span, inner: Span) -> bool:
    return outer.source is inner.source and outer.start <= inner.start and inner.end <= outer.end


# ---- what is wrong -------------------------------------------------------------------------------


def _is_chart(other: tree.Name, chart: tree.Statechart) -> Diagnostic:
    related = (Related(chart.name.span, "the statechart"),)
    return Diagnostic(problems.ChartIncluded(other.text), other.span, related)


_Direct = Mapping[str, Sequence[tuple[tree.Name, tree.Srm]]]


def _circles(direct: _Direct) -> Iterator[list[tuple[str, tree.Name]]]:
    """Roles that include themselves, each with the place that names the next one; no role is in two."""
    done: set[str] = set()
    for root in direct:
        if root in done:
            continue
        path: list[str] = [root]
        stack = [iter(direct[root])]
        places: list[tree.Name] = []
        done.add(root)
        while stack:
            step = next(stack[-1], None)
            if step is None:
                stack.pop()
                path.pop()
                if places:
                    places.pop()
                continue
            place, part = step
            name = part.name.text
            if name in path:
                start = path.index(name)
                yield list(zip(path[start:], [*places[start:], place], strict=True))
            elif name not in done:
                done.add(name)
                path.append(name)
                places.append(place)
                stack.append(iter(direct[name]))


def _circle(circle: Sequence[tuple[str, tree.Name]]) -> Diagnostic:
    path = (*(name for name, _ in circle), circle[0][0])
    related = tuple(Related(place.span, f"`{name}` includes `{place}`") for name, place in circle[:-1])
    return Diagnostic(problems.RoleInItself(path), circle[-1][1].span, related)


def _nobody_includes(item: tree.Srm) -> Diagnostic:
    return Diagnostic(problems.AbstractRoleUnused(item.name.text), item.name.span)


def _once_by_pair(found: Iterable[Diagnostic]) -> tuple[Diagnostic, ...]:
    """The diagnostics, where a name that two included roles share is one problem for all their users."""
    seen: set[object] = set()
    kept: list[Diagnostic] = []
    for item in found:
        is_twice = isinstance(item.problem, problems.IncludedTwice)
        key = tuple(place.span for place in item.related) if is_twice else item
        if key not in seen:
            seen.add(key)
            kept.append(item)
    return tuple(kept)


def errors_alone(found: Iterable[Diagnostic]) -> Iterator[Diagnostic]:
    """What is wrong with a role for itself, though others shall complete it."""
    left = (FormulaNotUsed, RoleWithoutFormula)  # to the role that includes it
    return (item for item in found if item.severity is Severity.ERROR and not isinstance(item.problem, left))


__all__ = ["Inclusion", "complete", "errors_alone", "include", "includers"]
