"""Around: the declaration in which the cursor stands, read anew, without the entry that is being typed."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import replace
from functools import cached_property, lru_cache

from aseme_dsl.amola.liveness import Formula, names
from aseme_dsl.compiler.chart.aip_to_eac import PROCESS
from aseme_dsl.compiler.formula import formulas as formula_tables
from aseme_dsl.compiler.formula.formula_to_statechart import Way
from aseme_dsl.compiler.formula.formulas import Formulas
from aseme_dsl.compiler.formula.terms import Terms, terms_of, way
from aseme_dsl.compiler.names.inclusion import complete
from aseme_dsl.compiler.names.scope import Scope
from aseme_dsl.compiler.types.scopes import protocol_scopes, role_scope
from aseme_dsl.editor.files.known import Known, bindable, nodes, used_names
from aseme_dsl.editor.files.place import Place, end_of_declaration
from aseme_dsl.editor.reading.reading import at_once
from aseme_dsl.grammar import parse
from aseme_dsl.grammar.parsing.expected import Expected
from aseme_dsl.grammar.parsing.parts import TooSlow
from aseme_dsl.grammar.text import tree
from aseme_dsl.records import dataclass
from aseme_dsl.source import Source


@dataclass(frozen=True, eq=False)
class Around:
    """`written` is None outside of every role, statechart and protocol, or where it cannot be read.

    `declaration` is the same with what a role includes, which counts as if it stood in it.
    """

    known: Known
    written: tree.Srm | tree.Statechart | tree.Aip | None

    @cached_property
    def declaration(self) -> tree.Srm | tree.Statechart | tree.Aip | None:
        if not isinstance(self.written, tree.Srm):
            return self.written
        declared = (item for file in self.known.files for item in file.declarations)
        return complete(self.written, (item for item in declared if isinstance(item, tree.Srm)))

    def participant(self, name: str) -> tree.Participant | None:
        """The participant of this name, if the declaration is a protocol that has it."""
        parts = self.declaration.participants if isinstance(self.declaration, tree.Aip) else ()
        return next((item for item in parts if item.name.text == name), None)

    def scope(self, participant: str | None) -> Scope:
        """What is visible there; of a protocol, to a participant or (None) to all of them."""
        match self.declaration:
            case tree.Srm() | tree.Statechart():
                return self._role_scope
            case tree.Aip():
                return self._participant_scopes.get(participant or "", self._protocol_scope)
        return self.known.top

    @cached_property
    def _role_scope(self) -> Scope:
        assert isinstance(self.declaration, (tree.Srm, tree.Statechart))
        return role_scope(self.declaration, self.known.top)[0].scope

    @cached_property
    def _participant_scopes(self) -> Mapping[str, Scope]:
        assert isinstance(self.declaration, tree.Aip)
        typed = protocol_scopes(self.declaration, self.known.top)[0]
        return {name: item.scope for name, item in typed.items()}

    @cached_property
    def _protocol_scope(self) -> Scope:
        first = next(iter(self._participant_scopes.values()), None)
        if first is None:
            return self.known.top
        return replace(first, participant=None, variables={})

    @cached_property
    def timers(self) -> tuple[str, ...]:
        """The timers that the declaration starts or asks for."""
        found: dict[str, None] = {}
        for node in nodes(self.declaration):
            if isinstance(node, tree.Call) and node.function.text in ("start_timer", "expired"):
                found |= {item.text: None for item in node.arguments[:1] if isinstance(item, tree.Path)}
        return tuple(found)

    def owner(self, control: str) -> tuple[Formulas, str, str | None] | None:
        """The formulas that a control block is about, which of them, and whose (a participant's name)."""
        match self.declaration:
            case tree.Srm():
                table = formula_tables.table(self.declaration.name.text, self.declaration.formulas)[0]
                if table is not None and control in table.named:
                    return table, control, None
            case tree.Aip():
                for part in self.declaration.participants:
                    table = formula_tables.table(
                        f"{self.declaration.name}.{part.name}", part.formulas, PROCESS
                    )[0]
                    if table is None:
                        continue
                    if part.name.text == control:
                        return table, table.root, control
                    if control in table.named and control != table.root:
                        return table, control, part.name.text
        return None

    def terms(self, control: str) -> Terms | None:
        """The terms that the lines of a control block may name."""
        found = self.owner(control)
        return terms_of(found[0], found[1], control) if found is not None else None

    def terms_inside(self, control: str, terms: Terms) -> Iterator[tuple[Terms, Formula]]:
        """The terms of the formulas inside this one that have no block: their lines may stand here, too."""
        found = self.owner(control)
        assert isinstance(self.declaration, (tree.Srm, tree.Aip))
        if found is None:
            return
        named = found[0].named
        inside: dict[str, None] = {}
        waiting = [terms.formula]
        while waiting:
            used = [node.name for node in names(named[waiting.pop()].formula) if node.name in named]
            waiting += [name for name in used if name not in inside]
            inside |= dict.fromkeys(used)
        blocks = {item.name.text for item in self.declaration.controls}
        every = {name: terms_of(found[0], name, name) for name in named}
        times = Counter(key for other in every.values() for key in other.places)
        for name in inside:
            for key, places in every[name].places.items():
                if name not in blocks and times[key] == 1:
                    yield from ((every[name], term) for term in places)

    def said(self, control: str, terms: Terms) -> frozenset[Way]:
        """The ways that the block has lines for already."""
        assert isinstance(self.declaration, (tree.Srm, tree.Aip))
        found = set()
        for block in self.declaration.controls:
            if block.name.text == control:
                for entry in block.entries:
                    if isinstance(entry, tree.Way):
                        found.add(way(terms, entry.verb, entry.term)[0])
        found.discard(None)
        return frozenset(item for item in found if item is not None)

    def played(self, participant: str | None = None) -> Mapping[str, tree.Participant | None]:
        """What a role plays, or a participant of a protocol, by the names that its formulas use."""
        player = self.participant(participant) if participant is not None else self.declaration
        if not isinstance(player, (tree.Srm, tree.Participant)):
            return {}
        return {(item.alias or item.participant).text: self._part(item) for item in player.plays}

    def _part(self, item: tree.Plays) -> tree.Participant | None:
        protocol = self.known.protocols.get(item.protocol.text)
        parts = protocol.participants if protocol is not None else ()
        return next((one for one in parts if one.name.text == item.participant.text), None)

    def performed(self) -> tuple[str, ...]:
        """The activities of what a role plays, with those of what stands inside it, by their own names."""
        found: list[str] = []
        seen: set[tree.Participant] = set()
        waiting = [part for part in self.played().values() if part is not None]
        while waiting:
            part = waiting.pop(0)
            if part in seen:
                continue
            seen.add(part)
            found += bindable(part)
            waiting += [inner for item in part.plays if (inner := self._part(item)) is not None]
        return tuple(dict.fromkeys(found))


def around(place: Place, known: Known) -> Around:
    """The declaration around a place; reading it again costs nothing while only one entry changes."""
    end = end_of_declaration(place.text, max(place.first, place.start))
    text = place.text[place.first : end]
    begin = _begin_of_entry(place)
    if begin is not None:
        stop = min(_end_of_entry(place, begin), end) - place.first
        typed = text[begin - place.first : stop]
        text = text[: begin - place.first] + re.sub(r"[^\n]", " ", typed) + text[stop:]
    return _around(text, known)


_PIECE = re.compile(
    r"""(?x)
      "(?:[^"\\\n]|\\.)*"? | //[^\n]* | /\*[\s\S]*?(?:\*/|\Z)
    | [{}] | \n[ \t]*(?=\S)
    | [A-Za-z_]\w*\s*(?:\([\w\s,:]*\)\s*)?=(?!=)
    """
)


def _end_of_entry(place: Place, begin: int) -> int:
    """Where the entry ends that is being typed: before the brace that closes its block, or the next entry.

    The next one begins on a line that is not indented more; a formula also ends where the next has its name.
    """
    line = place.text.rfind("\n", 0, begin) + 1
    margin = len(place.text[line:begin]) - len(place.text[line:begin].lstrip(" \t"))
    is_formula = any(item.place in (("Formula", "tokens"), ("Process", "tokens")) for item in place.expected)
    depth = 0
    for found in _PIECE.finditer(place.text, place.end):
        sign = found.group()
        if sign == "{":
            depth += 1
        elif sign == "}":
            depth -= 1
            if depth < 0:
                return found.start()
        elif (sign[0] == "\n" and len(sign) - 1 <= margin) or (is_formula and sign[-1] == "="):
            return found.start()
    return len(place.text)


@lru_cache(maxsize=4)
def _around(text: str, known: Known) -> Around:
    try:
        file = at_once(parse, Source("<editor>", text))[0]
    except TooSlow:
        return Around(known, None)
    for item in file.declarations:
        if isinstance(item, (tree.Srm, tree.Statechart, tree.Aip)):
            return Around(known, item)
    return Around(known, None)


def _begin_of_entry(place: Place) -> int | None:
    """Where the entry begins that is being typed; None in the head of a block, and where none is begun."""
    if place.block < 0:
        return None
    if place.entry is not None:
        return place.entry
    if not place.expected:
        return place.text.rfind("\n", 0, place.start) + 1
    return place.start if place.start < place.end else None


def name_of(place: Place, expected: Expected, rule: str) -> str | None:
    """The name that follows the word of a block around: `player` in `srm player {`."""
    step = expected.step(rule)
    tokens = place.tokens(step) if step is not None else []
    return str(tokens[1]) if len(tokens) > 1 else None


__all__ = ["Around", "around", "name_of", "used_names"]
