"""Ask: one thing that the grammar expects at the cursor, with what is known there."""

from __future__ import annotations

from aseme_dsl.compiler.names.scope import Scope
from aseme_dsl.editor.files.known import Known
from aseme_dsl.editor.files.place import Place
from aseme_dsl.editor.typing.around import Around, name_of
from aseme_dsl.grammar.parsing.expected import Expected
from aseme_dsl.grammar.text.token import Token
from aseme_dsl.records import dataclass


@dataclass(frozen=True, slots=True)
class Ask:
    """`expected` at `place`; `around` is the declaration there, `path` the file's own path."""

    place: Place
    expected: Expected
    known: Known
    around: Around
    path: str

    @property
    def said(self) -> list[Token]:
        """The tokens of the innermost rule before the cursor."""
        return self.place.tokens(self.expected.steps[-1]) if self.expected.steps else []

    def tokens(self, rule: str) -> list[Token]:
        """The tokens before the cursor since a rule around was begun."""
        step = self.expected.step(rule)
        return self.place.tokens(step) if step is not None else []

    def name(self, rule: str) -> str | None:
        """The name in the head of a block around."""
        return name_of(self.place, self.expected, rule)

    @property
    def participant(self) -> str | None:
        """The participant in whose block, or whose control, the cursor stands."""
        name = self.name("Participant")
        control = self.name("Control")
        if name is None and control is not None:
            found = self.around.owner(control)
            name = found[2] if found is not None else None
        return name

    @property
    def scope(self) -> Scope:
        """What is visible to an expression here."""
        return self.around.scope(self.participant)


__all__ = ["Ask"]
