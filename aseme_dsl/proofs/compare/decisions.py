"""Decisions: what is left open in a move is decided once, for both versions, when either asks for it."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Mapping, Sequence
from enum import IntEnum
from random import Random
from typing import cast

from aseme_dsl.amola.expression import TURNED
from aseme_dsl.proofs.explore.deciding.choosing import Choices
from aseme_dsl.proofs.explore.deciding.values import Values
from aseme_dsl.runtime.chart.plan import Plan, Variable, terms_of
from aseme_dsl.runtime.message.convert import converted

DRAWN = (0.0, 0.25, 0.5, 0.75, 0.9999)
"""What stands for random numbers."""

Field = tuple[str, tuple[str, ...]]
"""A type of message, and the path to one of its members."""


class Open:
    """What an activity has written to a variable, until something reads it.

    Two versions hold the same one if the same activity has written it at the same time.
    """

    __slots__ = ("number",)

    def __init__(self, number: int) -> None:
        self.number = number

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Open) and other.number == self.number

    def __hash__(self) -> int:
        return hash(("open", self.number))

    def __repr__(self) -> str:
        return f"open {self.number}"


class Decisions:
    """The decisions of one move. A question has the same answer in both versions."""

    def __init__(self, plans: Sequence[Plan], types: Mapping[str, type[object]]) -> None:
        self.choices = Choices()
        self.values = Values(plans, types, ("other1", "other2"))
        self._asked = _Asked(plans)
        self._ways = self._left = 0
        self._is_open = False
        self._chance = Random(0)
        self._members: dict[Field, tuple[object, ...] | None] = {}
        self.made: dict[Hashable, object] = {}
        """The answers that were given in this move."""
        self.is_impossible = False
        """Whether one version cannot have what was decided: it is not a move of both."""
        self.there: frozenset[str] = frozenset()
        """The channels on which a message has come: one is there from then on."""

    def sample(self, ways: int) -> None:
        """From now on, only so many ways of each move are tried, which are random; 0: all of them."""
        self._ways = ways
        self._chance = Random(ways)

    def begin(self, there: frozenset[str]) -> None:
        """A move is made for the first time."""
        self.choices.begin()
        self._left, self._is_open = self._ways, False
        self._start(there)

    def again(self, there: frozenset[str]) -> bool:
        """Whether there is another way to make the move; it is taken next."""
        if self._ways:
            self._left -= 1
            if not self._is_open or self._left <= 0:
                return False
            self.choices.begin()
        elif not self.choices.again():
            return False
        self._start(there)
        return True

    def _start(self, there: frozenset[str]) -> None:
        self.made.clear()
        self.is_impossible = False
        self.there = there

    def of(self, question: Hashable, answers: Sequence[object], text: str = "") -> object:
        """One of the answers; `text` says what was decided, with `{}` for the answer."""
        answer = self.made.get(question, self)
        if answer is self:
            if self._ways and len(answers) > 1:
                self._is_open = True
                answer = self._chance.choice(answers)
                if text and answer is not None:
                    self.choices.say(text, answer)
            else:
                answer = self.choices.of(question, answers, text)
            self.made[question] = answer
        return answer

    # ---- what is asked -----------------------------------------------------------------------

    def is_there(self, channel: str, host: str | None) -> bool:
        """Whether a message has come on a channel of which the latest is read."""
        name = channel if host is None else f"{host}.{channel}"
        if name in self.there:
            return True
        found = bool(self.of(("there", name), (True, False)))
        if found:
            self.there |= {name}
        else:
            text = f"there is no {name} yet"
            if text not in self.choices.said:
                self.choices.said.append(text)
        return found

    def age(self, channel: str, host: str | None) -> int:
        """How old that message is, in ns."""
        answers = tuple(_Age(age) for age in sorted(self._asked.ages.get(channel, {0})))
        name = channel if host is None else f"{host}.{channel}"
        return cast(int, self.of(("age", name), answers, f"{name} is {{}} old"))

    def member(self, name: str, field: Field, kind: object) -> object:
        """What a member of that message is."""
        if field not in self._members:
            self._members[field] = self._tried(field, kind)
        answers = self._members[field]
        if answers is None:
            return None
        path = ".".join(field[1])
        return self.of((name, path), answers, f"{name}.{path} is {{}}")

    def _tried(self, field: Field, kind: object) -> tuple[object, ...] | None:
        if not self.values.is_read(field):
            return None
        if isinstance(kind, type) and issubclass(kind, IntEnum):
            return self._asked.of_enum(kind)
        return self.values.tried_for(field, kind)

    def variable(self, variable: Variable, written: Open, known: Callable[[str], str]) -> object:
        """What an activity has written to a variable."""
        name = known(variable.name.partition("@")[0])
        return self.of(("variable", name, written.number), self.values.held(variable), f"{name} is {{}}")

    def called(self, name: str, result: str, arguments: tuple[object, ...]) -> object:
        """What a function of the document gives."""
        kinds: Mapping[str, tuple[object, ...]] = {"bool": (False, True)}
        answers = kinds.get(result) or self.values.results(name, result)
        shown = ", ".join(map(_said, arguments))
        text = f"{name.partition('(')[0]}({shown}) is {{}}"
        return self.of(("call", name, repr(arguments)), answers, text)

    def drawn(self, number: int) -> float:
        """A random number: one of a few."""
        self.values.bounds["random()"] = f"random() in {', '.join(map(str, DRAWN))}"
        return cast(float, self.of(("random", number), DRAWN, "random() is {}"))

    # ---- each version has types of its own ---------------------------------------------------

    def as_of(self, value: object, messages: Mapping[str, type[object]], enums: Enums) -> object:
        """A value of both versions as one of the types of one of them."""
        if isinstance(value, IntEnum):
            own = enums.get(type(value).__name__)
            if own is None:
                return value
            if value.name in own.__members__:
                return own[value.name]
            self.is_impossible = True
            return next(iter(own))
        if hasattr(type(value), "__dataclass_fields__"):
            try:
                return converted(value, messages)
            except LookupError:
                self.is_impossible = True
        return value


Enums = Mapping[str, type[IntEnum]]


class _Age(int):
    """A time in ns that readers see in ms."""

    def __format__(self, spec: str) -> str:
        return f"{self // 1_000_000} ms"


def _said(value: object) -> str:
    return str(value.name) if isinstance(value, IntEnum) else str(value)


class _Asked:
    """What conditions compare with: of values that they do not tell apart, one is enough."""

    def __init__(self, plans: Sequence[Plan]) -> None:
        self.ages: dict[str, set[int]] = {}
        """The ages of messages, by channel."""
        self.constants: dict[str, set[str]] = {}
        """The constants, by enum."""
        for plan in plans:
            for term in terms_of(plan):
                self._note(term)

    def _note(self, term: tuple[object, ...]) -> None:
        match term:
            case ("enum", str() as kind, str() as constant, _):
                self.constants.setdefault(kind, set()).add(constant)
            case (str() as word, ("age", ("member", _, channel, *_)), ("const", int(age))):
                self._age(word, str(channel), age)
            case (str() as word, ("const", int(age)), ("age", ("member", _, channel, *_))):
                self._age(TURNED.get(word, word), str(channel), age)

    def _age(self, word: str, channel: str, age: int) -> None:
        points = {"<": (0, age), ">=": (0, age), "<=": (age, age + 1), ">": (age, age + 1)}
        self.ages.setdefault(channel, set()).update(points.get(word, (0, age, age + 1)))

    def of_enum(self, kind: type[IntEnum]) -> tuple[object, ...]:
        """The constants that conditions name, and one that they do not."""
        named = self.constants.get(kind.__name__, set())
        others = [item for item in kind if item.name not in named]
        return (*(item for item in kind if item.name in named), *others[:1])


__all__ = ["Decisions", "Enums", "Open"]
