"""Choosing: what is left open in a move is decided when it is asked; one answer after another is tried."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Sequence
from enum import Enum
from typing import TypeVar

_T = TypeVar("_T")


class Choices:
    """The decisions of one move. A question that was asked in it before has the same answer."""

    def __init__(self) -> None:
        self._script: list[int] = []
        self._widths: list[int] = []
        self._made: dict[Hashable, object] = {}
        self._place = 0
        self.begun = 0
        """How often a move was begun: what is known of its ways holds as long as this is the same."""
        self.said: list[str] = []
        """The decisions of this way, for readers."""
        self.of_others: list[int] = []
        """Which decisions of this way are made by agents that are not explored."""
        self.draw: Callable[[Sequence[int], int], int] | None = None
        """Draws the answer to a decision that was not made yet, if something does: from the answers to those
        before, and from how many there are. Else it is the first one."""
        self.heard: list[tuple[Hashable, object]] | None = None
        """What was asked and answered, and what was noted, if something keeps it."""

    def begin(self) -> None:
        """A move is made for the first time."""
        self.begun += 1
        self._script.clear()
        self._widths.clear()
        self._start()

    def again(self) -> bool:
        """Whether there is another way to make the move; it is taken next."""
        while self._script and self._script[-1] + 1 == self._widths[-1]:
            self._script.pop()
            self._widths.pop()
        if not self._script:
            return False
        self._script[-1] += 1
        self._start()
        return True

    def of(
        self, question: Hashable, answers: Sequence[_T], text: str = "", *, is_of_others: bool = False
    ) -> _T:
        """One of the answers. `text` says what was decided, with `{}` for the answer; not if that is None."""
        if question in self._made:
            return self._made[question]  # type: ignore[return-value]
        if len(answers) == 1:
            chosen = answers[0]
        else:
            if self._place == len(self._script):
                self._script.append(0 if self.draw is None else self.draw(self._script, len(answers)))
                self._widths.append(len(answers))
            chosen = answers[self._script[self._place]]
            if is_of_others:
                self.of_others.append(self._place)
            self._place += 1
            if text and chosen is not None:
                self.say(text, chosen)
        self._made[question] = chosen
        self.note(question, chosen)
        return chosen

    def say(self, text: str, answer: object) -> None:
        """Tell readers what was decided: a text with `{}` for the answer."""
        self.said.append(text.format(answer.name if isinstance(answer, Enum) else answer))

    def note(self, what: Hashable, value: object = None) -> None:
        """Something is to be known beside the decisions."""
        if self.heard is not None:
            self.heard.append((what, value))

    @property
    def made(self) -> int:
        """How many questions have been answered."""
        return len(self._made)

    @property
    def place(self) -> int:
        """How many decisions have been made; which one the next is."""
        return self._place

    def close(self, place: int) -> None:
        """The answers to a decision that are still to be tried are not."""
        self._widths[place] = self._script[place] + 1

    def kept(self) -> tuple[list[int], list[int]]:
        """Which ways of the move have been taken, to continue with the next one."""
        return self._script[:], self._widths[:]

    def take_back(self, kept: tuple[list[int], list[int]]) -> None:
        """Continue with a move of which these ways have been taken."""
        self.begun += 1
        self._script[:], self._widths[:] = kept

    def way(self) -> tuple[int, ...]:
        """The decisions of this way by their numbers: the same again lead to the same state."""
        return tuple(self._script[: self._place])

    def follow(self, way: Sequence[int]) -> None:
        """Make the move as it was made on this way."""
        self.begun += 1
        self._script[:] = way
        self._widths[:] = [len(way) + 1] * len(way)
        self._start()

    def _start(self) -> None:
        self._place = 0
        self._made.clear()
        self.said.clear()
        self.of_others.clear()


__all__ = ["Choices"]
