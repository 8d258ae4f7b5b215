"""Use cases: what each is called in the models that specify it, and what is still missing of them.

A use case and a formula or activity are the same if their names are equal ignoring case and underscores, or
if the use case says that it `realises` them.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence

from aseme_dsl.amola.operators import Operator
from aseme_dsl.amola.suc import RoleType, Suc, UseCase, folded
from aseme_dsl.records import dataclass

_BUILT = (RoleType.SYSTEM, RoleType.ABSTRACT)


@dataclass(frozen=True)
class UseCases:
    """The use cases by name, with the names of all protocols, formulas and activities that are written."""

    suc: Suc
    by_name: Mapping[str, UseCase]
    by_participant: Mapping[str, Sequence[UseCase]]
    spellings: Mapping[str, str]

    def case(self, name: str) -> UseCase:
        return self.by_name[folded(name)]

    def names_of(self, case: UseCase) -> tuple[str, ...]:
        """What may stand for the use case, folded."""
        return (folded(case.name), *(folded(name) for name in case.realises))

    def parties(self, case: UseCase) -> tuple[str, ...]:
        """The participants that are built: humans, legacy and external systems have no process."""
        outside = {item.name for item in self.suc.roles if item.type not in _BUILT}
        return tuple(name for name in case.participants if name not in outside)

    def is_protocol(self, case: UseCase) -> bool:
        """A use case with several parties and inclusions is a protocol."""
        return len(self.parties(case)) > 1 and bool(case.includes)

    def spelling(self, case: UseCase) -> str:
        """The name of the use case in formulas: as a formula has it, else in the usual spelling."""
        for name in self.names_of(case):
            if name in self.spellings:
                return self.spellings[name]
        if case.realises:
            return case.realises[0]
        return case.name if case.includes else activity_name(case.name)

    def activities(self, case: UseCase) -> tuple[str, ...]:
        """The activities that the use case needs: those of everything that it includes, at any depth."""
        found: dict[str, None] = {}
        seen = {folded(case.name)}
        waiting = list(reversed(case.includes))
        while waiting:
            item = self.case(waiting.pop())
            if folded(item.name) in seen:
                continue
            seen.add(folded(item.name))
            if item.includes:
                waiting += reversed(item.includes)
            else:
                found[self.spelling(item)] = None
        return tuple(found)


def use_cases(suc: Suc, written: Iterable[str]) -> UseCases:
    """The use cases of a model; `written` are the names of all protocols, formulas and activities."""
    spellings: dict[str, str] = {}
    for name in written:
        spellings.setdefault(folded(name), name)
    by_participant: dict[str, list[UseCase]] = {}
    for case in suc.usecases:
        for participant in case.participants:
            by_participant.setdefault(participant, []).append(case)
    return UseCases(suc, {folded(case.name): case for case in suc.usecases}, by_participant, spellings)


def activity_name(name: str) -> str:
    """`walk_towards_ball` as activities are written: `WalkTowardsBall`."""
    parts = [part for part in name.split("_") if part]
    return "".join(part[0].upper() + part[1:] for part in parts) or name


def joined(terms: Iterable[str]) -> str:
    """A formula to start from, with holes: nothing says yet how the terms are related."""
    return f" {Operator.HOLE} ".join(terms)


def helper_formulas(cases: UseCases, terms: Iterable[UseCase], term: Callable[[UseCase], str]) -> list[str]:
    """Formulas for those of `terms` that include others, and for what these include, each once.

    `term` says how a formula uses a use case; protocols have no formula.
    """
    found: list[str] = []
    done: set[str] = set()
    waiting = list(terms)
    while waiting:
        item = waiting.pop(0)
        if folded(item.name) in done or not item.includes or cases.is_protocol(item):
            continue
        done.add(folded(item.name))
        parts = [cases.case(name) for name in item.includes]
        found.append(formula_line(cases.spelling(item), [term(part) for part in parts]))
        waiting += parts
    return found


def formula_line(name: str, terms: Sequence[str]) -> str:
    """`name = A ? B`"""
    return f"{name} = {joined(terms)}"


__all__ = [
    "UseCases",
    "activity_name",
    "folded",
    "formula_line",
    "helper_formulas",
    "joined",
    "use_cases",
]
