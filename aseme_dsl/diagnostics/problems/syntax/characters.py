"""Characters: texts, names, numbers, and how deep terms may be nested (E103–E106, E108)."""

from __future__ import annotations

from aseme_dsl.diagnostics.problem import Problem
from aseme_dsl.diagnostics.wording import a, shown


class FormulaTooDeep(Problem):
    code = "E103"
    most: int
    hint = "give a part of it a name: NAME = …"

    @property
    def message(self) -> str:
        return f"this formula is nested more than {self.most} deep"


class ExpressionTooDeep(Problem):
    code = "E103"
    most: int
    hint = "give a part of it a name: let NAME = …"

    @property
    def message(self) -> str:
        return f"this expression is nested more than {self.most} deep"


class TextNotClosed(Problem):
    code = "E104"
    message = "the text that begins here is not closed on its line"
    hint = "write '\"' at its end"


class NoEscape(Problem):
    """`written`: a backslash and the character behind it."""

    code = "E105"
    written: str
    hint = "in a text, write '\\\\' for a backslash and '\\\"' for a quote"

    @property
    def message(self) -> str:
        return f"{shown(self.written)} means nothing in a text"


class TextInOtherQuotes(Problem):
    code = "E105"
    message = "a text stands in double quotes"
    hint = "write '\"' at both ends"


class CharactersInName(Problem):
    """`forever`: the name whose endless repetition may be meant."""

    code = "E105"
    name: str
    forever: str | None

    @property
    def message(self) -> str:
        return f"{shown(self.name)} is not a name of the language"

    @property
    def hint(self) -> str:
        if self.forever is not None:
            meant = shown(f"{self.forever}~")
            return f"{shown(self.name)} is one name; write {meant} for {self.forever} forever"
        return "names consist of the letters A to Z and a to z, digits and '_'"


class OddCharacters(Problem):
    """`meant`: what they stand for."""

    code = "E105"
    characters: str
    meant: str | None

    @property
    def message(self) -> str:
        if len(self.characters) > 1:
            return f"characters {shown(self.characters)} are not part of the language"
        return f"the character {shown(self.characters)} is not part of the language"

    @property
    def hint(self) -> str | None:
        if self.meant is None:
            return None
        return "write an ordinary blank" if self.meant == " " else f"write {self.meant}"


class ReservedOperand(Problem):
    """In a formula."""

    code = "E106"
    word: str

    @property
    def message(self) -> str:
        return f"{shown(self.word)} cannot be an activity or formula"


class WordAsName(Problem):
    """`kind`: of what it is the name, as `use case`."""

    code = "E106"
    name: str
    kind: str
    is_type: bool

    @property
    def message(self) -> str:
        word = "a type" if self.is_type else "a word of the language here"
        return f"{shown(self.name)} cannot be the name of {a(self.kind)}: it is {word}"

    @property
    def hint(self) -> str:
        return f"{self.name}_ can"


class NoUnitOfTime(Problem):
    """`meant`: the same duration, as the language writes it."""

    code = "E108"
    number: str
    unit: str
    meant: str

    @property
    def message(self) -> str:
        return f"{shown(self.unit)} is not a unit of time"

    @property
    def hint(self) -> str:
        return f"write {self.meant}"


class NumberWithUnit(Problem):
    code = "E108"
    number: str
    unit: str

    @property
    def message(self) -> str:
        return f"numbers have no units: {shown(self.number + self.unit)}"

    @property
    def hint(self) -> str:
        is_minute = self.unit in ("m", "M")
        time = f"minutes are written {self.number}min" if is_minute else "units of time are ms, s and min"
        return f"write {self.number}, and its unit in a comment; {time}"


class BlankBeforeUnit(Problem):
    code = "E108"
    number: str
    unit: str

    @property
    def message(self) -> str:
        return f"a blank between the number {self.number} and its unit {self.unit}"

    @property
    def hint(self) -> str:
        return f"write {self.number}{self.unit}"


class NeitherNumberNorName(Problem):
    code = "E108"
    written: str

    @property
    def message(self) -> str:
        return f"{shown(self.written)} is neither a number nor a name"


class TwoPointsInNumber(Problem):
    code = "E108"
    number: str

    @property
    def message(self) -> str:
        return f"{shown(self.number)} is not a number: it has more than one point"


class TooManyDigits(Problem):
    code = "E108"
    number: str

    @property
    def message(self) -> str:
        return f"{shown(self.number)} has too many digits"


class PartOfNanosecond(Problem):
    code = "E108"
    duration: str

    @property
    def message(self) -> str:
        return f"{shown(self.duration)} is not a whole number of nanoseconds"


class TooManyInstances(Problem):
    code = "E108"
    count: str

    @property
    def message(self) -> str:
        return f"{shown(self.count)} instances are too many"
