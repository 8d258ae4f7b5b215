"""Later: contents of messages of which each member is decided when something reads it."""

from __future__ import annotations

from collections.abc import Collection, Container, Hashable, Iterable, Mapping, Sequence
from dataclasses import field
from itertools import count
from typing import cast

from aseme_dsl.proofs.explore.deciding.absence import tells_absence
from aseme_dsl.proofs.explore.deciding.choosing import Choices
from aseme_dsl.proofs.explore.deciding.order import AnyNumber, Order
from aseme_dsl.proofs.explore.deciding.outcomes import Outcomes
from aseme_dsl.proofs.explore.deciding.unread import Path, Unread, place_of, unread, unread_class
from aseme_dsl.proofs.explore.deciding.values import Place, Values
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.plan import Plan


@dataclass(slots=True)
class Decided:
    """What has been decided of contents: by their numbers, their types and the paths of members."""

    values: dict[tuple[int, str, Path], object] = field(default_factory=dict)
    made: int = 0
    """How many contents there have been."""


def _named(message: object) -> str:
    content, path = place_of(message)
    assert isinstance(content, Content)
    return f"{content.kind.__name__} {content.number} {path}"


_PLAIN = {
    "__dataclass_fields__": {},
    "__eq__": object.__eq__,
    "__hash__": object.__hash__,
    "__repr__": _named,
}
"""It tells of no members, so that a trace reads none, and a message is equal to itself alone."""


class Later:
    """Makes contents whose members are decided when they are read."""

    def __init__(
        self, choices: Choices, values: Values, outcomes: Outcomes, order: Order, told: Collection[str]
    ) -> None:
        """Properties ask for messages of the types `told`."""
        self._told = told
        self._outcomes = outcomes
        self._order = order
        self.forgotten: dict[int, Container[Path]] = {}
        """The contents of which something was forgotten in this move, with what was kept."""
        self._choices = choices
        self._values = values
        self._alike: dict[tuple[str, Path], object] = {}
        """What stands for numbers that are only compared with each other, by type and path."""
        self._like: dict[tuple[str, Path], tuple[Place, Mapping[object, tuple[object, ...]]]] = {}
        """The numbers that may change places, by type and path."""
        self._noted: set[tuple[str, Path]] = set()
        self.decided = Decided()
        self._kinds: dict[type[object], type[object]] = {}

    def content(
        self, kind: type[object], tried: Mapping[Path, Sequence[object]], name: str, is_brief: bool = False
    ) -> object:
        """A new message of this kind. For the members at these paths, one of the values is decided when it is
        read; the others have their defaults. `name` is what it is, for readers. `is_brief`: mostly, it may be
        another one at the next look."""
        self.decided.made += 1
        self._choices.note(("made", self.decided.made, kind.__name__))
        return self._open(kind, Content(self.decided.made, kind, tried, name, is_brief), ())

    def standing(self, kind: type[object], tried: Mapping[Path, Sequence[object]], name: str) -> object:
        """A message of which nothing is known, not even whether it has come."""
        self.decided.made += 1
        return self._open(kind, Content(self.decided.made, kind, tried, name, True), ())

    def is_open(self, message: object) -> bool:
        """Whether a message may still say anything."""
        content = content_of(message)
        return content is not None and all(key[0] != content.number for key in self.decided.values)

    def forget(self, message: object, kept: Container[Path] = ()) -> None:
        """What was decided of a message may be otherwise from now on, but for the members in `kept`."""
        content = content_of(message)
        if content is not None:
            self.forgotten[content.number] = kept
            self._choices.note(("forgotten", content.number))
            values = self.decided.values
            for key in [key for key in values if key[0] == content.number and key[2] not in kept]:
                del values[key]

    def fade(self, message: object) -> None:
        """Nothing asks any more what a message says."""
        content = content_of(message)
        if content is not None:
            for key in [key for key in self.decided.values if key[0] == content.number]:
                del self.decided.values[key]

    def keep(self, numbers: Collection[int]) -> bool:
        """Forget what was decided of all contents, and is known of all numbers, but these; whether there was
        anything to forget."""
        values = self.decided.values
        gone = [key for key in values if key[0] not in numbers]
        for key in gone:
            del values[key]
        inside = {value.number for value in values.values() if type(value) is AnyNumber}
        return self._order.keep({*numbers, *inside}) or bool(gone)

    def said(self, numbers: Iterable[int]) -> str:
        """What has been decided of contents, and is known of numbers that may be any (below 0), by their
        places."""
        places = {number: place for place, number in enumerate(numbers)}
        values = self.decided.values
        found: list[object] = []
        names: dict[tuple[Place, object], object] = {}
        for number in [*places]:
            own = sorted((path, kind) for other, kind, path in values if other == number)
            for path, kind in own:
                value = values[number, kind, path]
                if type(value) is AnyNumber:
                    value = places.setdefault(value.number, len(places)), value.offset
                else:
                    value = self._named(kind, path, value, names)
                found.append((places[number], path, value))
        return f"{found} {self._order.shown([number for number in places if number < 0])}"

    def _named(
        self, kind: str, path: Path, value: object, names: dict[tuple[Place, object], object]
    ) -> object:
        """The same for numbers that may change places: in the order of their occurrence in the `names`."""
        if (kind, path) not in self._like:
            self._like[kind, path] = self._values.like(kind, path, self._told)
        root, like = self._like[kind, path]
        others = like.get(value)
        if others is None:
            return value
        if (root, value) not in names:
            names[root, value] = others[sum((root, other) in names for other in others)]
        return names[root, value]

    def decide(self, content: Content, path: Path) -> object:
        """What a member holds."""
        key = content.number, content.kind.__name__, path
        values = self.decided.values
        if key not in values:
            answers = self._answers(content, path)
            if key[1:] not in self._noted:
                self._noted.add(key[1:])
                self._values.note(*key[1:])
            text = f"{content.name}.{'.'.join(path)} is {{}}"
            if content.is_brief and len(answers) > 1 and self._alike[key[1:]] is None:
                return self._outcomes.of(("member", *key), answers, text)
            question = "member", *key
            is_of_others = self._outcomes.decided_by_others([question])
            answer = self._choices.of(question, answers, text, is_of_others=is_of_others)
            values[key] = self._order.made(answer)
        return values[key]

    def settle(self) -> None:
        """The conditions of this move have been looked at: one of what may be so is so."""

        def is_left(question: Hashable) -> bool:
            match question:
                case ("member", int() as number, _, path):
                    return number not in self.forgotten or path in self.forgotten[number]
                case _:
                    return False

        for question, answer in self._outcomes.end(is_left):
            if is_left(question):
                _, *key = cast("tuple[str, int, str, Path]", question)
                self.decided.values[cast("tuple[int, str, Path]", tuple(key))] = answer

    def _answers(self, content: Content, path: Path) -> Sequence[object]:
        """What a member may hold; of numbers that are only compared with each other those that there are, and
        another one."""
        key = content.kind.__name__, path
        if len(content.tried[path]) == 1:
            return content.tried[path]
        if key not in self._alike:
            self._alike[key] = self._values.alike(*key)
        alike = self._alike[key]
        if alike is None:
            return content.tried[path]
        values = self.decided.values
        there = {
            value
            for (_, kind, path), value in values.items()
            if self._alike.get((kind, path)) == alike and isinstance(value, int)
        }
        return (*sorted(there), next(number for number in count(1) if number not in there))

    def _open(self, kind: type[object], content: Content, at: Path) -> object:
        opened = self._kinds.get(kind)
        if opened is None:
            opened = self._kinds[kind] = unread_class(kind, self._member, _PLAIN)
        return unread(opened, content, at)

    def _member(self, content: object, path: Path, hint: object) -> object:
        assert isinstance(content, Content)
        if path in content.tried:
            return self.decide(content, path)
        if any(other[: len(path)] == path for other in content.tried):
            return self._open(cast("type[object]", hint), content, path)
        return None


@dataclass(frozen=True, slots=True)
class Content:
    """The content of one message: its number, its type, and what is tried for its members."""

    number: int
    kind: type[object]
    tried: Mapping[Path, Sequence[object]]
    name: str
    is_brief: bool


def content_of(message: object) -> Content | None:
    """The content of a message of which members are decided later; None for any other."""
    root = place_of(message)[0] if isinstance(message, Unread) else None
    return root if isinstance(root, Content) else None


class Contents:
    """Makes the contents of messages that activities and the surroundings decide."""

    def __init__(
        self,
        choices: Choices,
        values: Values,
        later: Later,
        messages: Mapping[str, type[object]],
        told: frozenset[str],
        order: Order,
    ) -> None:
        """Of the types `told`, contents are decided when they are made: properties ask for them."""
        self._choices = choices
        self._values = values
        self._later = later
        self._order = order
        self._messages = messages
        self._told = told

    def standing(self, agent: str, channel: str) -> object:
        """What may have come to an agent on a channel, or not."""
        message = channel.rpartition(".")[2]
        tried = self._values.tried(message)
        assert tried is not None
        return self._later.standing(self._messages[message], tried, f"{agent}: {message}")

    def tells_absence(self, plan: Plan, channel: str) -> bool:
        """Whether something can tell that no message has come on a channel from one that may say anything."""
        message = channel.rpartition(".")[2]
        return (
            message in self._told
            or self._values.tried(message) is None
            or tells_absence(plan, channel, self._values)
        )

    def new(
        self,
        message: str,
        question: Hashable,
        text: str,
        name: str,
        fixed: Mapping[Path, object] | None = None,
        is_brief: bool = False,
    ) -> object:
        """A content of a type of message; `name` is what it is, and `text` what is said of one that is
        decided now, with `{}` for it. The members in `fixed` hold that, if they are decided later.
        `is_brief`: mostly, it may be another one at the next look."""
        tried = None if message in self._told else self._values.tried(message)
        if tried is None:
            return self._order.made(self._choices.of(question, self._values.contents(message), text))
        if fixed:
            tried = {path: (fixed[path],) if path in fixed else some for path, some in tried.items()}
        return self._later.content(self._messages[message], tried, name, is_brief)


__all__ = ["Content", "Contents", "Decided", "Later", "content_of"]
