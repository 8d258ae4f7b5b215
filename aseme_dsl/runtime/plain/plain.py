"""Plain: what the generated classes of plain statecharts have in common.

A plain chart is an ordinary object: it is given events and says whether it took them. It has no thread, no
queue, no agent; `Machine` (`machine.py`) makes a complete runtime of it.
"""

from __future__ import annotations

import logging
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from functools import cache
from random import Random
from typing import Any, ClassVar

ROUNDS = 1000
"""A step that has not settled after so many rounds never will."""

SHOWN = 16
"""So many states are named in an error."""

ABSENT = "a value is absent"
"""Why an action was not done that needs a message which is not there."""

_log = logging.getLogger("aseme_dsl.plain")


NEVER = 2**63 - 1
"""When a timer runs out that was not started."""


class ActivityFailed(RuntimeError):
    """An activity has failed, and no `error` transition takes that."""


class OutOfBounds(ValueError):
    """A number that a variable cannot hold was written to it. No step may follow."""


class Unsettled(RuntimeError):
    """A step does not come to an end: its transitions enable each other."""


class NotStarted(RuntimeError):
    """A step before `start`: nothing is active yet."""


class _Unstarted:
    """Stands for the number of a region before `start`: its use raises `NotStarted`.

    So it costs a step nothing to look whether there is a number.
    """

    __slots__ = ()

    def __reduce__(self) -> str:
        return "UNSTARTED"

    def _refuse(self, other: object = None) -> Any:
        raise NotStarted("nothing is active yet: call start() first")

    __eq__ = __ne__ = __lt__ = __le__ = __gt__ = __ge__ = __rsub__ = __rshift__ = _refuse
    __bool__ = __hash__ = _refuse


UNSTARTED: Any = _Unstarted()
"""Stands where a number will be."""


@cache
def leaves_of(labels: str) -> tuple[str, ...]:
    """The labels of a region's leaves by their numbers, of `LEAVES`."""
    return tuple(labels.split())


class Plain:
    """A running statechart. Subclasses are generated; `semantics.md` says what a step does.

    A region is a slot with the number of its active leaf, or a Boolean if it has two. Nothing is active
    before `start`: until then a step raises `NotStarted`. Do not call a method while another one runs (from a
    function of a condition, or from the method of an activity). This is not checked, and leaves the regions
    in undefined states. Use `Machine` if such calls can happen.

    Methods take a state as its label, or as its name if no other state has that name.
    """

    __slots__ = ()

    # Subclasses have those of these slots that they need: hence `setattr`, for mypy.
    writes: tuple[int, str, Any, Any] | None  # mypyc cannot compile a recursive type
    """What a region has written last that others see in the next step, and what was written before."""
    faulty: tuple[int, ...]
    """The transitions of which something could not be done in this step."""
    failures: dict[str, str] | None
    """The states whose activity has failed, with the reason; None while there are none."""
    chance: Random | None
    """The generator of `random()`: 2.5 kB, made at the first call unless the user sets it before."""

    EVENTS: ClassVar[tuple[str, ...]] = ()
    """The events that transitions wait for. `send` of any other event is a step without an event."""
    LEAVES: ClassVar[tuple[str, ...]] = ()
    """The labels of each region's leaves by their numbers, in one text: that is loaded faster than many."""
    NAMES: ClassVar[tuple[str, ...]] = ()
    """The same leaves, by their names; those that have none, by their type: `(AND)`."""
    INNER: ClassVar[Mapping[tuple[int, int], tuple[int, ...]]] = {}
    """For each AND, as its region and number, the regions inside it."""
    RUNNING: ClassVar[Mapping[str, tuple[int, int]]] = {}
    """The BASIC states whose completion matters: their region, and their number until they are complete."""
    ENDS: ClassVar[Mapping[str, tuple[str, ...]]] = {}
    """The states whose activity says how it has ended, and the names of how it may."""
    MESSAGES: ClassVar[tuple[tuple[str, str, str | None], ...]] = ()
    """The places of messages on the blackboard, each with its channel and its sender (None: any sender)."""
    VARIABLES: ClassVar[Mapping[str, str]] = {}
    """What those variables are called on the blackboard whose names mean something else there."""
    WAKING: ClassVar[tuple[str, ...]] = ()
    """The transitions by which regions wake each other, in words."""
    CIRCLING: ClassVar[tuple[str, ...]] = ()
    """The transitions that may be taken again and again in one step, in words."""
    TRANSITIONS: ClassVar[tuple[str, ...]] = ()
    """The transitions by their numbers, in words; in classes that are watched only."""
    END: ClassVar[int] = -1
    """The number of the root's END."""

    # ---- generated -------------------------------------------------------------------------

    def start(self) -> None:
        """Enter the root, and take transitions until none is enabled."""
        raise NotImplementedError

    def send(self, event: str) -> bool:
        """One step with an event; whether anything was taken."""
        raise NotImplementedError

    def step(self) -> bool:
        """One step without an event, for what the blackboard says; whether anything was taken."""
        raise NotImplementedError

    # ---- the same for all ------------------------------------------------------------------

    def done(self, label: str, outcome: str | None = None) -> bool:
        """One step, before which the activity of a BASIC state has returned; whether anything was taken.

        That is of no account if the state is not active, or its activity has returned before. `outcome` is
        the name of how it has ended, for activities that say so; it is of no account for others.

        Raises:
            KeyError: the statechart has no such state, or can never be in it, or has several of that name.
            ValueError: the activity does not end so, or it was not said how it has.
        """
        self.place(
            label, outcome
        )  # classes in which it matters whether something has returned have their own
        return self.step()

    def failed(self, label: str, reason: str) -> bool:
        """One step, before which the activity of a BASIC state has failed; whether anything was taken.

        That is of no account if the state is not active, or its activity has returned before.

        Raises:
            KeyError: the statechart has no such state, or can never be in it.
            ActivityFailed: the step has not left the state: no `error` transition has taken it. A chart
                without such transitions keeps no account: one that was left and entered again in the same
                step counts as not left.
        """
        label = self.label_of(label)
        found = self._running(label)
        takes = hasattr(self, "failures")  # there is an `error` transition
        if takes and found is not None:
            setattr(self, "failures", {**(self.failures or {}), label: reason})  # noqa: B010
        taken = self._alone()
        not_left = bool(self.failures) if takes else label in self.configuration()
        if takes and not not_left:
            setattr(self, "failures", None)  # noqa: B010
        if self.WAKING and not (takes and not_left):
            self._follow()
        if not_left:
            raise ActivityFailed(f"the activity of {label} failed: {reason}")
        return taken

    def _alone(self) -> bool:
        """What a step without an event does, without the steps that follow it."""
        return self.step()

    def _follow(self) -> None:
        """The steps that follow as long as regions write what conditions of others read."""

    def _running(self, label: str) -> tuple[int, int] | None:
        """The region of a BASIC state and its number, if its activity runs and that matters."""
        found = self.RUNNING.get(label)
        return found if found is not None and found in self._active() else None

    def place(self, state: str, outcome: str | None) -> int:
        """Where a BASIC state whose completion matters stands among the leaves of all regions, else -1.

        Raises:
            KeyError: the statechart has no such state, or can never be in it.
            ValueError: its activity does not end with that outcome.
        """
        label = self.label_of(state)
        ends = self.ENDS.get(label, ())
        if ends and outcome not in ends:
            ended = "it was not said how it has ended" if outcome is None else f"not with {outcome!r}"
            raise ValueError(f"the activity of {state} ends with {' or '.join(map(repr, ends))}; {ended}")
        found = self.RUNNING.get(label)
        if found is None:
            return -1
        region, number = found
        return sum(len(leaves_of(labels)) for labels in self.LEAVES[:region]) + number

    def label_of(self, state: str) -> str:
        """The label of a state that is given by it, or by a name that no other has.

        Raises:
            KeyError: the statechart has no such state, or can never be in it, or has several of that name.
        """
        named = {
            label: name
            for labels, names in zip(self.LEAVES, self.NAMES, strict=True)
            for label, name in zip(leaves_of(labels), leaves_of(names), strict=True)
        }
        if state in named:
            return state
        found = [label for label, name in named.items() if name == state]
        if len(found) == 1:
            return found[0]
        if found:
            raise KeyError(f"{type(self).__name__} has several states {state}: {', '.join(found)}")
        known = [f"{label} {name}" for label, name in named.items() if not name.startswith("(")]
        more = f" and {len(known) - SHOWN} more" if len(known) > SHOWN else ""
        raise KeyError(f"{type(self).__name__} has no state {state}; it has {', '.join(known[:SHOWN])}{more}")

    def configuration(self) -> tuple[str, ...]:
        """The labels of the active leaves, region by region in document order."""
        return tuple(leaves_of(self.LEAVES[region])[number] for region, number in sorted(self._active()))

    def names(self) -> tuple[str, ...]:
        """The names of the active leaves that have one, in the same order; with the label where several have
        that name."""
        return names_of(self.LEAVES, self.NAMES, sorted(self._active()))

    def __repr__(self) -> str:
        """For debuggers: which states are active."""
        try:
            leaves = [item for item in sorted(self._active()) if item not in self.INNER]
            active = [_called(self.LEAVES, self.NAMES, *item) for item in leaves]
            return f"<{type(self).__name__}: {', '.join(active)}>"
        except (AttributeError, NotStarted):  # a region has no number yet
            return f"<{type(self).__name__}: not started>"

    @property
    def finished(self) -> bool:
        """Whether the root's END is active."""
        return self._number(0) == self.END

    def _active(self) -> list[tuple[int, int]]:
        """The active regions with the numbers of their leaves."""
        active: list[tuple[int, int]] = []
        stack = [0]
        while stack:
            region = stack.pop()
            found = region, self._number(region)
            active.append(found)
            stack += self.INNER.get(found, ())
        return active

    def _number(self, region: int) -> int:
        """The number of a region's leaf; one that has a single leaf has no slot."""
        return 0 if " " not in self.LEAVES[region] else getattr(self, f"r{region}")

    # ---- what generated code calls ---------------------------------------------------------

    def spread(self, board: object) -> None:
        """Let all regions see what some have written: of several writes, the last in document order."""
        write = self.writes
        found = []
        while write is not None:
            found.append(write)
            write = write[3]
        if len(found) > 1:
            found.reverse()
            found.sort(key=lambda write: write[0])
        for _, name, value, _ in found:
            if isinstance(board, dict):
                board[name] = value
            else:
                setattr(board, name, value)

    def inside(self, name: str, least: float, most: float, value: Any) -> Any:
        """The value that a bounded variable is to hold. Raises OutOfBounds if it cannot."""
        if not least <= value <= most:
            raise OutOfBounds(f"variable {name} of {least}..{most} cannot be {value!r}")
        return value

    def short(self, name: str, length: int, items: Any) -> Any:
        """The list that a variable is to hold. Raises OutOfBounds if it is too long."""
        if len(items) > length:
            raise OutOfBounds(f"list {name} of at most {length} elements cannot have {len(items)}")
        return items

    def appended(self, items: Any, item: Any) -> Any:
        """A list with one element more."""
        return (*items, item)

    def removed(self, items: Any, item: Any) -> Any:
        """A list without the first element that equals the item."""
        place = items.index(item) if item in items else len(items)
        return (*items[:place], *items[place + 1 :])

    def dropped(self, name: str, items: Any, place: int) -> Any:
        """A list without the element at a place. Raises OutOfBounds if there is none."""
        self._check_place(name, items, place)
        return (*items[:place], *items[place + 1 :])

    def put(self, name: str, items: Any, place: int, item: Any) -> Any:
        """A list with another element at a place. Raises OutOfBounds if there is none."""
        self._check_place(name, items, place)
        return (*items[:place], item, *items[place + 1 :])

    def of_each(self, items: Any, path: tuple[str, ...]) -> Any:
        """The members at a path of the elements of a list; None where an optional one is not there."""
        return tuple([_member(item, path) for item in items])

    def made(
        self,
        kind: Any,
        members: Iterable[tuple[tuple[str, ...], object]],
        rest: object,
        taken: tuple[str, ...],
    ) -> Any:
        """A new message with these members; the others are those of `rest` that are `taken`, or have their
        defaults."""
        message = kind(**{name: getattr(rest, name) for name in taken})
        for path, value in members:
            message = _with(message, path, value)
        return message

    def _check_place(self, name: str, items: Any, place: int) -> None:
        if not 0 <= place < len(items):
            raise OutOfBounds(f"list {name} of {len(items)} elements has no element {place}")

    def fault(self, transition: int, reason: object) -> bool:
        """Something of a transition could not be done; always False.

        Told to the logger `aseme_dsl.plain`, once a step; override it to do something else.

        Raises:
            OutOfBounds: a variable cannot hold what was written. That ends the statechart.
        """
        if isinstance(reason, OutOfBounds):
            raise reason
        if transition not in self.faulty:
            setattr(self, "faulty", (*self.faulty, transition))  # noqa: B010
            text = f"{type(reason).__name__}: {reason}" if isinstance(reason, Exception) else str(reason)
            _log.warning("%s, transition %d: %s", type(self).__name__, transition, text)
        return False

    def failed_inside(self, label: str) -> bool:
        """Whether an activity of the state or inside it has failed."""
        return any(item == label or item.startswith(label + ".") for item in self.failures or ())

    def random(self) -> float:
        """The next number in [0, 1)."""
        chance = self.chance
        if chance is None:
            chance = Random(1)
            setattr(self, "chance", chance)  # noqa: B010
        return chance.random()

    def unsettled(self) -> Unsettled:
        """The error of a step that does not settle."""
        name, active = type(self).__name__, ", ".join(self.names() or self.configuration())
        ways = "; ".join(self.CIRCLING[:SHOWN])
        return Unsettled(f"{name} does not settle after {ROUNDS} rounds, at {active}: {ways}")

    def endless(self) -> Unsettled:
        """The error of steps that follow each other at one instant without an end."""
        name, active = type(self).__name__, ", ".join(self.names() or self.configuration())
        ways = "; ".join(self.WAKING[:SHOWN])
        return Unsettled(
            f"{name} makes {ROUNDS} steps at one instant and does not settle, at {active}: {ways}"
        )


def names_of(
    leaves: Sequence[str], names: Sequence[str], active: Iterable[tuple[int, int]]
) -> tuple[str, ...]:
    """The names of leaves (region, number), where they have one, by a class's `LEAVES` and `NAMES`."""
    named = [item for item in active if not leaves_of(names[item[0]])[item[1]].startswith("(")]
    return tuple(_called(leaves, names, *item) for item in named)


def _called(leaves: Sequence[str], names: Sequence[str], region: int, number: int) -> str:
    """The name of a leaf, with its label where others have that name, too."""
    label, name = leaves_of(leaves[region])[number], leaves_of(names[region])[number]
    others = (
        place
        for labels, words in zip(leaves, names, strict=True)
        for place, other in zip(leaves_of(labels), leaves_of(words), strict=True)
        if other == name and place != label
    )
    alone = next(others, None) is None
    name = name.strip("()")  # what has no name is called by its type
    return name if alone else f"{name} {label}"


def _member(message: Any, path: tuple[str, ...]) -> Any:
    """A member of a member …, or None where one on the way is absent."""
    for name in path:
        message = None if message is None else getattr(message, name)
    return message


def _with(message: Any, path: tuple[str, ...], value: object) -> Any:
    """A message with another member."""
    if len(path) > 1:
        value = _with(getattr(message, path[0]), path[1:], value)
    return replace(message, **{path[0]: value})


def unknown_event(kind: type, event: str) -> ValueError:
    """The error of an event that no transition waits for, of a class that has its `EVENTS`."""
    from difflib import get_close_matches

    events: tuple[str, ...] = tuple(getattr(kind, "EVENTS", ()))
    near = get_close_matches(str(event), events, 1)
    known = "there is none" if not events else f"it waits for {', '.join(events)}"
    hint = f"did you mean {near[0]!r}?" if near else known
    return ValueError(f"{kind.__name__} waits for no event {event!r}; {hint}")


__all__ = [
    "ABSENT",
    "NEVER",
    "ROUNDS",
    "UNSTARTED",
    "ActivityFailed",
    "NotStarted",
    "Plain",
    "Unsettled",
    "leaves_of",
    "names_of",
    "unknown_event",
]
