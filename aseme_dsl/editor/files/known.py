"""Known: what was found in the files when they were last read through, for questions in between."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator, Mapping
from functools import cached_property

from aseme_dsl.amola.liveness import Formula, names
from aseme_dsl.compiler.names.scope import Scope
from aseme_dsl.compiler.names.symbols import Symbols
from aseme_dsl.compiler.read.blocks import Blocks
from aseme_dsl.editor.files.comments import documentation
from aseme_dsl.editor.files.program import Program
from aseme_dsl.editor.files.view import View
from aseme_dsl.grammar.text import tree
from aseme_dsl.records import dataclass
from aseme_dsl.source import Source, Span


@dataclass(frozen=True, eq=False)
class Known:
    """What the last look at a program has found."""

    program: Program

    @property
    def files(self) -> tuple[tree.File, ...]:
        return self.program.inspection.loaded.files

    @cached_property
    def aliases(self) -> frozenset[str]:
        """The aliases of imports."""
        imports = (item for file in self.files for item in file.declarations if isinstance(item, tree.Import))
        return frozenset(item.alias.text for item in imports if item.alias is not None)

    @property
    def symbols(self) -> Symbols:
        return self.program.inspection.symbols

    @property
    def top(self) -> Scope:
        """The scope at the top of every file."""
        return self.program.inspection.top

    @property
    def blocks(self) -> Blocks:
        """The declarations that become models."""
        return self.program.inspection.blocks

    @cached_property
    def protocols(self) -> Mapping[str, tree.Aip]:
        return {item.name.text: item for item in self.blocks.aips}

    @cached_property
    def _by_source(self) -> Mapping[Source, tree.File]:
        return {file.source: file for file in self.files}

    def documentation(self, span: Span) -> str:
        """What the comments say of what is declared at `span`."""
        span = self.program.whole(span)
        file = self._by_source.get(span.source)
        return documentation(file, span) if file is not None else ""

    @cached_property
    def events(self) -> tuple[str, ...]:
        """The events that some transition waits for."""
        found = {
            name
            for file in self.files
            for item in file.declarations
            for name in self.program.recall(_events_in, item)
        }
        return tuple(sorted(found))

    @cached_property
    def activities(self) -> Mapping[str, tree.Name | None]:
        """The activities of all roles and protocols, with the name where one is described."""
        found: dict[str, tree.Name | None] = {}
        for role in self.blocks.srms:
            found |= dict.fromkeys(used_names(role.formulas))
            found |= dict.fromkeys(
                item.own.text for play in role.plays for item in play.bindings if item.own is not None
            )
        for protocol in self.blocks.aips:
            for part in protocol.participants:
                found |= dict.fromkeys(bindable(part))
        for block in self.blocks.roles:
            found |= {item.name.text: item.name for item in block.activities}
        return found

    @cached_property
    def functionalities(self) -> Mapping[str, tree.Name]:
        """What activities use, with the name where it is described, or used first."""
        found: dict[str, tree.Name] = {}
        for role in self.blocks.srms:
            found |= {item.name.text: item.name for item in role.functionalities}
        for block in self.blocks.roles:
            for item in block.activities:
                for name in item.uses:
                    found.setdefault(name.text, name)
        return found

    @cached_property
    def actors(self) -> tuple[tree.Actor, ...]:
        return tuple(actor for sag in self.blocks.sags for actor in sag.actors)

    @cached_property
    def role_names(self) -> tuple[str, ...]:
        """Roles of every kind: actors, those of use cases, participants, and those with a model."""
        found = [actor.name.text for actor in self.actors]
        found += [name.text for suc in self.blocks.sucs for group in suc.roles for name in group.names]
        found += [name.text for suc in self.blocks.sucs for case in suc.usecases for name in case.by]
        found += [part.name.text for aip in self.blocks.aips for part in aip.participants]
        found += [item.name.text for item in self.blocks.roles]
        return tuple(dict.fromkeys(found))

    @cached_property
    def use_cases(self) -> tuple[str, ...]:
        """Goals, use cases, and what use cases include."""
        found = [goal.name.text for actor in self.actors for goal in actor.goals]
        for suc in self.blocks.sucs:
            for case in suc.usecases:
                found += [case.name.text, *(item.text for item in case.includes)]
        return tuple(dict.fromkeys(found))


def _events_in(item: tree.Declaration) -> frozenset[str]:
    """The events that transitions of a declaration wait for."""
    entries: list[tree.Way | tree.LabelledWay | tree.StandingWay] = []
    if isinstance(item, (tree.Srm, tree.Aip)):
        entries += (entry for control in item.controls for entry in control.entries)
    elif isinstance(item, tree.Statechart):
        entries += item.transitions
    events = (event for entry in entries for event in entry.expression.events)
    return frozenset(event.name.text for event in events if isinstance(event, tree.Raised))


def known_in(view: View) -> Known:
    """What is known of a file that is being typed in.

    Where a typing error has just swallowed declarations, that is what was known before it.
    """
    if view.earlier is not None and view.program.inspection.symbols.lost:
        return Known(view.earlier.program)
    return Known(view.program)


def used_names(formulas: tuple[tree.NamedFormula, ...]) -> list[str]:
    """What formulas use and none of them is called."""
    own = {item.name.text for item in formulas}
    used = (node.name for item in formulas for node in names(item.formula))
    return [name for name in dict.fromkeys(used) if name not in own]


def bindable(part: tree.Participant) -> list[str]:
    """The activities of a participant, with the names that it gives to those of what it plays itself."""
    played = {(item.alias or item.participant).text for item in part.plays}
    declared = [item.name for item in part.formulas] + [item.name for item in part.inputs]
    declared += (item.name for item in (*part.variables, *part.results))
    others = {name.text for name in declared}
    bound = [item.own.text for play in part.plays for item in play.bindings if item.own is not None]
    found = [*used_names(part.formulas), *(name for name in bound if name not in others)]
    return [name for name in dict.fromkeys(found) if name not in played]


def nodes(part: object) -> Iterator[object]:
    """Every part of a tree but formulas, in no certain order."""
    waiting: list[object] = [part]
    while waiting:
        node = waiting.pop()
        if isinstance(node, tuple):
            waiting += node
        elif dataclasses.is_dataclass(node) and not isinstance(node, (Source, Span, Formula)):
            yield node
            waiting += (getattr(node, item.name) for item in dataclasses.fields(node))


__all__ = ["Known", "known_in", "nodes", "used_names"]
