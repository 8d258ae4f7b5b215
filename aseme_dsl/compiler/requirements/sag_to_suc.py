"""SAG to SUC: every actor becomes a role, every goal a use case (P1, section 4.2)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from aseme_dsl.amola.sag import Actor, Goal, Sag
from aseme_dsl.amola.suc import Role, RoleType, Suc, UseCase
from aseme_dsl.compiler.names.symbols import Symbols
from aseme_dsl.compiler.names.usecases import folded
from aseme_dsl.compiler.read.names import declared_twice, unknown
from aseme_dsl.diagnostics import Diagnostic, Related
from aseme_dsl.diagnostics.problems.absences import NoActor, NoRoleOfUseCase
from aseme_dsl.diagnostics.problems.names import UseCaseIncludesItself
from aseme_dsl.grammar.text import tree
from aseme_dsl.source import Span


def read_sag(written: Iterable[tree.Sag], symbols: Symbols) -> tuple[Sag, tuple[Diagnostic, ...]]:
    """The goals of all actors: E201 for a repeated declaration, E200 for an actor that is not declared."""
    actors: dict[str, Actor] = {}
    goals: dict[str, Goal] = {}
    found: list[Diagnostic] = []
    blocks = [actor for block in written for actor in block.actors]
    known = {actor.name.text for actor in blocks}
    for actor in blocks:
        name = actor.name.text
        if name in actors:
            found.append(declared_twice("actor", actor.name, actors[name].span))
        actors.setdefault(name, Actor(name, actor.name.span))
        for goal in actor.goals:
            if goal.name.text in goals:
                found.append(declared_twice("goal", goal.name, goals[goal.name.text].span))
                continue
            dependees: dict[str, None] = {}
            for other in goal.depends:
                if other.text in known:
                    dependees[other.text] = None
                elif not symbols.is_excused(other.text):
                    found.append(unknown(NoActor, other, known))
            requirements = goal.requirements.text if goal.requirements is not None else ""
            goals[goal.name.text] = Goal(goal.name.text, name, tuple(dependees), requirements, goal.name.span)
    return Sag(tuple(actors.values()), tuple(goals.values())), tuple(found)


def sag_to_suc(
    sag: Sag,
    written: Iterable[tree.Suc],
    declared_roles: Mapping[str, Span],
    abstract_roles: Mapping[str, Span],
    symbols: Symbols,
) -> tuple[Suc, tuple[Diagnostic, ...]]:
    """Actors as roles, goals as use cases of those who have them and those they depend on, and what is added.

    `declared_roles` are the names of roles that are written as an `srm` or `statechart`, `abstract_roles`
    those of an `abstract srm`.
    """
    written = tuple(written)
    found: list[Diagnostic] = []
    roles = {actor.name: Role(actor.name, RoleType.SYSTEM, actor.span) for actor in sag.actors}
    found += _add_roles(roles, written)
    cases: dict[str, UseCase] = {}
    for goal in sag.goals:
        participants = tuple(dict.fromkeys((goal.depender, *goal.dependees)))
        cases[folded(goal.name)] = UseCase(goal.name, participants, (), goal.requirements, (), goal.span)
    first: dict[str, tree.UseCase] = {}
    included: list[tree.Name] = []
    spelling = {key: case.name for key, case in cases.items()}
    entries = [entry for block in written for entry in block.usecases]
    for entry in entries:
        spelling.setdefault(folded(entry.name.text), entry.name.text)
    for entry in entries:
        key = folded(entry.name.text)
        if key in first:
            found.append(declared_twice("use case", entry.name, first[key].name.span))
            continue
        first[key] = entry
        by = []
        for name in entry.by:
            if name.text not in roles and name.text in declared_roles:
                roles[name.text] = Role(name.text, RoleType.SYSTEM, declared_roles[name.text])
            if name.text not in roles and name.text in abstract_roles:
                roles[name.text] = Role(name.text, RoleType.ABSTRACT, abstract_roles[name.text])
            if name.text in roles:
                by.append(name.text)
            elif not symbols.is_excused(name.text):
                found.append(unknown(NoRoleOfUseCase, name, [*roles, *declared_roles, *abstract_roles]))
        included += entry.includes
        cases[key] = _joined(cases.get(key), entry, by, spelling)
    for name in included:
        key = folded(name.text)
        cases.setdefault(key, UseCase(spelling.get(key, name.text), (), (), "", (), name.span))
    found += _circles(cases, first)
    return Suc(tuple(roles.values()), tuple(cases.values())), tuple(found)


def _add_roles(roles: dict[str, Role], written: Iterable[tree.Suc]) -> Iterator[Diagnostic]:
    """A role that is an actor as well gets the type that is written for it."""
    declared: dict[str, Span] = {}
    for block in written:
        for entry in block.roles:
            kind = RoleType(entry.type.text) if entry.type is not None else RoleType.SYSTEM
            for name in entry.names:
                if name.text in declared:
                    yield declared_twice("role", name, declared[name.text])
                    continue
                declared[name.text] = name.span
                earlier = roles.get(name.text)
                roles[name.text] = Role(name.text, kind, earlier.span if earlier is not None else name.span)


def _joined(
    goal: UseCase | None, entry: tree.UseCase, by: Iterable[str], spelling: dict[str, str]
) -> UseCase:
    """A use case as written, on top of the goal that it specifies, if there is one."""
    participants = dict.fromkeys((*(goal.participants if goal is not None else ()), *by))
    includes: dict[str, None] = {}
    for name in entry.includes:
        includes[spelling.setdefault(folded(name.text), name.text)] = None
    texts = [goal.requirements if goal is not None else ""]
    texts.append(entry.requirements.text if entry.requirements is not None else "")
    return UseCase(
        goal.name if goal is not None else entry.name.text,
        tuple(participants),
        tuple(includes),
        "\n".join(text for text in texts if text),
        tuple(name.text for name in entry.realises),
        entry.name.span,
    )


def _circles(cases: Mapping[str, UseCase], written: Mapping[str, tree.UseCase]) -> Iterator[Diagnostic]:
    """E208 for use cases that include themselves, each circle once."""
    done: set[str] = set()
    for root in cases:
        path: list[str] = []
        stack: list[tuple[str, bool]] = [(root, False)]
        while stack:
            key, leaving = stack.pop()
            if leaving:
                path.pop()
                done.add(key)
                continue
            if key in path:
                circle = path[path.index(key) :]
                names = tuple(cases[item].name for item in (*circle, key))
                last = written[circle[-1]]
                place = next(name for name in last.includes if folded(name.text) == key)
                related = tuple(
                    Related(written[item].name.span, f"`{cases[item].name}`") for item in circle[:-1]
                )
                yield Diagnostic(UseCaseIncludesItself(names), place.span, related)
                done.update(circle)
            elif key not in done:
                path.append(key)
                stack.append((key, True))
                stack += [(folded(name), False) for name in reversed(cases[key].includes)]


__all__ = ["read_sag", "sag_to_suc"]
