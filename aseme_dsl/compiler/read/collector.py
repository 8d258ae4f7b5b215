"""Collector: the declarations of all files on their way to symbols, and what is wrong with them."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import field
from typing import TypeVar

from aseme_dsl.amola.messages import BUILT_IN, Kind, Type
from aseme_dsl.compiler.read.builtins import OTHER_SPELLINGS
from aseme_dsl.compiler.read.library import providers
from aseme_dsl.compiler.read.names import unknown
from aseme_dsl.diagnostics import Diagnostic, Problem, Related
from aseme_dsl.diagnostics.problems.absences import NoDeclaredType
from aseme_dsl.grammar.text import tree
from aseme_dsl.records import dataclass
from aseme_dsl.source import Span

D = TypeVar("D", bound=tree.Declaration)


@dataclass(slots=True)
class Collector:
    """State of one `resolve`: the names of types so far, those that are wrong, and the diagnostics."""

    files: Sequence[tree.File]
    types: dict[str, Span] = field(default_factory=dict)
    wrong: set[str] = field(default_factory=set)
    lost: frozenset[str] = frozenset()
    complete: bool = True
    diagnostics: list[Diagnostic] = field(default_factory=list)

    def every(self, kind: type[D]) -> Iterator[D]:
        """The declarations of one kind in all files."""
        for file in self.files:
            for item in file.declarations:
                if isinstance(item, kind):
                    yield item

    def is_excused(self, name: str) -> bool:
        """Whether it is a consequence of another problem that this name is not known."""
        return name in self.wrong or name in self.lost or not self.complete

    def report(self, problem: Problem, span: Span, *related: Related) -> None:
        self.diagnostics.append(Diagnostic(problem, span, related))


def type_named(
    collector: Collector, name: tree.Name, enums: Collection[str], messages: Collection[str]
) -> Type | None:
    """The type that a name stands for, or None with a diagnostic (E200)."""
    if name.text in BUILT_IN:
        return BUILT_IN[name.text]
    if name.text in enums:
        return Type(Kind.ENUM, name.text)
    if name.text in messages:
        return Type(Kind.MESSAGE, name.text)
    if collector.is_excused(name.text):
        return None
    other = OTHER_SPELLINGS.get(name.text)
    if other is not None:
        collector.diagnostics.append(
            Diagnostic(NoDeclaredType(name.text, None, (), spelling=other), name.span, fix=other)
        )
        return None
    pool = (*BUILT_IN, *enums, *messages)
    libraries = providers(name.text, "enum", "message")
    collector.diagnostics.append(unknown(NoDeclaredType, name, pool, libraries=libraries))
    return None
