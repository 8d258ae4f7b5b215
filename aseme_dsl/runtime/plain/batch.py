"""Batch: thousands of instances of a plain statechart at once, for Monte-Carlo: with NumPy, or numba.

Each instance has a place in arrays; what one does depends on nothing but its own places. Of the plain class
there are two translations: methods over arrays, which NumPy runs, and functions of one instance, which numba
compiles (some seconds, the first time). Both do what the plain class does, step by step.
"""

from __future__ import annotations

import operator
from collections.abc import Mapping
from importlib import import_module
from typing import Any, ClassVar, TypeAlias

from aseme_dsl.runtime.plain.plain import ROUNDS, SHOWN, Unsettled, leaves_of, names_of, unknown_event

Selection: TypeAlias = Any
"""Which instances: their numbers, in an array; or a slice that is all of them."""

ENGINES = ("numpy", "numba")
TABLES = {"?": "truths", "i8": "wholes", "f8": "reals"}
"""The tables of a batch by NumPy type: all that the instances have is in one of them."""
COMPILED = "_compiled"
"""What the module with the functions for numba is called behind the name of that with the class."""


class BatchError(Exception):
    """A batch cannot be had or used as it is asked for; the text says why."""


class BatchBoard:
    """The arrays that a program sees; one that is set is set element by element, or all to one value."""

    __slots__ = ("__constants", "__dict__")
    __constants: Mapping[str, Mapping[str, int]]

    def __init__(self, arrays: Mapping[str, Any], constants: Mapping[str, Mapping[str, int]]) -> None:
        """`constants` are the numbers that the variables of enum types may have, by their names."""
        object.__setattr__(self, "_BatchBoard__constants", constants)
        self.__dict__.update(arrays)

    def __reduce__(self) -> tuple[Any, ...]:
        return BatchBoard, (self.__dict__, self.__constants)

    def __repr__(self) -> str:
        """For debuggers: the first and last values."""
        with _numpy().printoptions(threshold=8, edgeitems=3):
            return f"<{'; '.join(f'{name}: {array}' for name, array in self.__dict__.items())}>"

    def __setattr__(self, name: str, value: Any) -> None:
        array = self.__dict__.get(name)
        if array is None:
            raise AttributeError(f"there is no {name} on this blackboard")
        np = _numpy()
        try:
            given = np.asarray(value)
            with np.errstate(invalid="ignore"):  # the check below reports values that are not numbers
                fitting = given.astype(array.dtype, copy=False)
            fits = np.can_cast(given.dtype, array.dtype, "same_kind") or bool((fitting == given).all())
        except (ValueError, TypeError, OverflowError) as error:
            raise type(error)(f"{name} cannot be set: {error}") from error
        _check_shape(name, given.shape, len(array))
        if not fits:
            changed = given[fitting != given].flat[0]
            raise ValueError(f"{name} cannot be set: {changed} is not a {_KINDS[array.dtype.kind]}")
        constants = self.__constants.get(name)
        if constants is not None:
            others = fitting[~np.isin(fitting, list(constants.values()))]
            if others.size:
                known = ", ".join(f"{number} {constant}" for constant, number in constants.items())
                raise ValueError(f"{name} cannot be set: {others.flat[0]} is none of {known}")
        array[:] = fitting


_KINDS = {"b": "truth", "i": "whole number", "f": "number"}


def _check_shape(name: str, shape: tuple[int, ...], size: int) -> None:
    if shape not in ((), (1,), (size,)):
        given = " by ".join(map(str, shape))
        raise ValueError(f"{name} wants one value for all, or an array of {size}, not one of {given}")


class Batch:
    """Many running instances of a statechart, which make their steps together. Subclasses are generated.

    `bb` has an array for each value of the plain blackboard, to be read and written between steps; whole
    numbers have 64 bits. Nothing is active before `start`: until then there are no steps and nothing to ask.

    The class has the same public methods as a plain statechart, for arrays, and a few for generated code.
    """

    ARRAYS: ClassVar[tuple[tuple[str, str, bool | int | float, bool], ...]] = ()
    """What the instances have one of each: name, NumPy type, first value, and whether it is on `bb`."""
    CONSTANTS: ClassVar[Mapping[str, Mapping[str, int]]] = {}
    """For each variable of an enum type, the numbers of its constants."""
    EVENTS: ClassVar[Mapping[str, str]] = {}
    """The methods that make a step with an event; with others a step is one without."""
    LEAVES: ClassVar[tuple[str, ...]] = ()
    INNER: ClassVar[Mapping[tuple[int, int], tuple[int, ...]]] = {}
    RUNNING: ClassVar[Mapping[str, tuple[int, int]]] = {}
    END: ClassVar[int] = -1
    NAMES: ClassVar[tuple[str, ...]] = ()
    CIRCLING: ClassVar[tuple[str, ...]] = ()
    WAKING: ClassVar[tuple[str, ...]] = ()
    """These are the plain class's."""

    def __init__(self, size: int, engine: str = "numpy", *, strict: bool = False) -> None:
        """`size` instances, not yet started. `strict`: an event that no transition waits for is a mistake.

        Raises:
            BatchError: the engine is not installed, or there is none of that name.
            TypeError: `size` is not a whole number.
            ValueError: `size` is negative.
        """
        np = _numpy()
        if engine not in ENGINES:
            raise BatchError(f"there is no engine {engine}; there are {', '.join(ENGINES)}")
        self.size = self._checked(size)
        self.engine = engine
        self.strict = strict
        self._now = 0
        self._is_started = False
        self.stuck: Any = None
        self._everybody = slice(None)
        self._leaves = tuple(map(leaves_of, self.LEAVES))
        # What numba looks at, an instance after the other, lies together; NumPy takes it array by array.
        self._tables = []
        for kind in TABLES:
            firsts = np.array([first for _, dtype, first, _ in self.ARRAYS if dtype == kind], kind)
            table = np.empty((self.size, len(firsts)), kind, "C" if engine == "numba" else "F")
            table[:] = firsts
            self._tables.append(table if engine == "numba" else table.T)
        self._share()

    def _checked(self, size: int) -> int:
        try:
            count = operator.index(size)
        except TypeError as error:
            told = f"{type(self).__name__} wants a whole number of instances, not {size!r}"
            raise TypeError(told) from error
        if count < 0:
            raise ValueError(f"{type(self).__name__} wants no instance or more, not {count}")
        return count

    def _share(self) -> None:
        """Give each name its part of the tables."""
        seen: dict[str, Any] = {}
        for kind, table in zip(TABLES, self._tables, strict=True):
            members = [(name, is_seen) for name, dtype, _, is_seen in self.ARRAYS if dtype == kind]
            rows = table.T if self.engine == "numba" else table
            for (name, is_seen), array in zip(members, rows, strict=True):
                if is_seen:
                    seen[name] = array
                else:
                    setattr(self, name, array)
        self.bb: Any = BatchBoard(seen, self.CONSTANTS)
        self._compiled = _compiled(type(self)) if self.engine == "numba" else None

    def __getstate__(self) -> dict[str, Any]:
        """What a copy is made of: it has tables of its own, and begins as this one is."""
        shared = {name for name, _, _, is_seen in self.ARRAYS if not is_seen} | {"bb", "_compiled"}
        state = {name: value for name, value in self.__dict__.items() if name not in shared}
        return {**state, "_tables": [table.copy() for table in self._tables]}

    def __setstate__(self, state: Mapping[str, Any]) -> None:
        self.__dict__.update(state)
        self._share()

    def __repr__(self) -> str:
        """For debuggers: in how many instances which states are active."""
        said = f"{type(self).__name__} of {self.size}, {self.engine}"
        if not self._is_started:
            return f"<{said}: not started>"
        active = [f"{count} at {label}" for label, count in self.counts().items() if count]
        return f"<{said}: {', '.join(active)}>"

    @property
    def now(self) -> int:
        """The time of all instances, in ns."""
        return self._now

    @now.setter
    def now(self, value: int) -> None:
        try:
            self._now = operator.index(value)
        except TypeError as error:
            raise TypeError(f"now is one time for all instances, in whole ns, not {value!r}") from error

    # ---- steps -----------------------------------------------------------------------------

    def start(self) -> None:
        """Enter the root of every instance, and take transitions until none is enabled."""
        self._is_started = True
        self._run("start")

    def send(self, event: str, which: Any = True) -> Any:
        """One step with an event; for each instance, whether anything was taken.

        `which` has a truth for each instance, or is one for all; the others stay as they are.

        Raises:
            TypeError: `which` has no truths, but perhaps the numbers of instances.
            ValueError: `which` has fewer or more of them; or the batch is strict, and no transition waits for
                the event.
        """
        name = self.EVENTS.get(event)
        if name is None and self.strict:
            raise unknown_event(type(self), event)
        return self._run(name or "step", self._chosen(which))

    def step(self, which: Any = True) -> Any:
        """One step without an event; `which` and what is returned are as with `send`."""
        return self._run("step", self._chosen(which))

    def done(self, label: str, which: Any) -> Any:
        """One step of `which`, before which the activity of a BASIC state has returned where it runs.

        `which` and what is returned are as with `send`: the others make no step.

        Raises:
            KeyError: the statechart has no such state, or can never be in it.
            TypeError, ValueError: as with `send`.
        """
        chosen = self._chosen(which)
        found = self.RUNNING.get(label)
        if found is None:
            self.active(label)  # is it there?
            return self._run("step", chosen)
        region, number = found
        ended = chosen & self.active(label)
        if len(self._leaves[region]) > 1:
            slot = getattr(self, f"r{region}")
            ended &= slot == number
            slot[ended] = number + 1
        return self._run("step", chosen)

    def _check_started(self) -> None:
        if not self._is_started:
            raise BatchError(f"{type(self).__name__} has not been started: call start() first")

    def _chosen(self, which: Any) -> Any:
        """A truth for each instance, or one for all."""
        which = _numpy().asarray(which)
        if which.dtype != bool:
            raise TypeError(f"which wants a truth for each instance, not values of type {which.dtype}")
        _check_shape("which", which.shape, self.size)
        return which if which.shape == (self.size,) else which.reshape(())

    def _run(self, name: str, which: Any = True) -> Any:
        self._check_started()
        np = _numpy()
        if self._compiled is not None:
            moved = np.full(self.size, which)
            getattr(self._compiled, f"each_{name}")(moved, *self._tables, self.now)
        else:
            step = getattr(type(self), f"do_{name}")
            with np.errstate(all="ignore"):  # as with Python's own numbers
                if np.ndim(which) == 0 and which:
                    moved = step(self, self._everybody)
                else:
                    moved = np.zeros(self.size, bool)
                    chosen = np.flatnonzero(moved | which)
                    moved[chosen] = step(self, chosen)
        if self.stuck.any():
            first = int(np.flatnonzero(self.stuck)[0])
            self.stuck[:] = False
            raise self._unsettled(first)
        return moved

    def _unsettled(self, instance: int) -> Unsettled:
        """The error of an instance that does not settle: where it is, and the lines that may be the cause."""
        active = ", ".join(self.names(instance) or self.configuration(instance))
        ways = "; ".join(tuple(dict.fromkeys((*self.CIRCLING, *self.WAKING)))[:SHOWN])
        return Unsettled(f"instance {instance} does not settle after {ROUNDS} rounds, at {active}: {ways}")

    def table(self, name: str) -> tuple[Any, int]:
        """The array in which a variable of `bb` is a row, and which one: `[row, instance]`.

        There is one array for each type of variable, so that a loop that numba compiles needs no more.

        Raises:
            KeyError: there is no such variable.
        """
        kind = next((dtype for other, dtype, _, is_seen in self.ARRAYS if other == name and is_seen), None)
        if kind is None:
            raise KeyError(f"{type(self).__name__} has no variable {name}")
        row = [other for other, dtype, _, _ in self.ARRAYS if dtype == kind].index(name)
        table = self._tables[list(TABLES).index(kind)]
        return (table.T if self._compiled is not None else table), row

    # ---- questions -------------------------------------------------------------------------

    def active(self, label: str) -> Any:
        """For each instance, whether a leaf is active.

        Raises:
            KeyError: no leaf has that label.
        """
        self._check_started()
        np = _numpy()
        region = next((n for n, labels in enumerate(self._leaves) if label in labels), None)
        if region is None:
            raise KeyError(f"{type(self).__name__} has no leaf {label}")
        found = self._reached(region)
        if len(self._leaves[region]) > 1:
            numbers = [n for n, other in enumerate(self._leaves[region]) if other == label]
            found = found & np.isin(getattr(self, f"r{region}"), numbers)
        return found

    def counts(self) -> dict[str, int]:
        """In how many instances each leaf is active."""
        labels = dict.fromkeys(label for labels in self._leaves for label in labels)
        return {label: int(self.active(label).sum()) for label in labels}

    def configuration(self, instance: int) -> tuple[str, ...]:
        """The labels of an instance's active leaves, region by region in document order.

        Raises:
            IndexError: there is no such instance.
        """
        return tuple(self._leaves[region][number] for region, number in self._active_in(instance))

    def names(self, instance: int) -> tuple[str, ...]:
        """The names of an instance's active leaves that have one, in the same order.

        Raises:
            IndexError: there is no such instance.
        """
        return names_of(self.LEAVES, self.NAMES, self._active_in(instance))

    def _active_in(self, instance: int) -> list[tuple[int, int]]:
        """The regions that are active in an instance, with the numbers of their leaves."""
        self._check_started()
        if not -self.size <= instance < self.size:
            raise IndexError(f"{type(self).__name__} of {self.size} has no instance {instance}")
        active: list[tuple[int, int]] = []
        stack = [0]
        while stack:
            region = stack.pop()
            number = int(getattr(self, f"r{region}")[instance]) if len(self._leaves[region]) > 1 else 0
            active.append((region, number))
            stack += self.INNER.get((region, number), ())
        return sorted(active)

    @property
    def finished(self) -> Any:
        """For each instance, whether the root's END is active."""
        self._check_started()
        np = _numpy()
        if len(self._leaves[0]) == 1:
            return np.full(self.size, self.END == 0)
        return getattr(self, "r0") == self.END  # noqa: B009  a slot of the subclass

    def _reached(self, region: int) -> Any:
        """For each instance, whether a region is active."""
        found = _numpy().ones(self.size, bool)
        around = next((key for key, regions in self.INNER.items() if region in regions), None)
        while around is not None:
            outer, number = around
            if len(self._leaves[outer]) > 1:
                found &= getattr(self, f"r{outer}") == number
            around = next((key for key, regions in self.INNER.items() if outer in regions), None)
        return found

    # ---- what generated code calls -----------------------------------------------------------

    def nothing(self, kind: type) -> Any:
        """A place for a truth or a number of each instance: false, or 0."""
        return _numpy().zeros(self.size, kind)

    def all(self) -> Any:
        """A truth for each instance: true."""
        return self.everywhere(True)

    def everywhere(self, value: bool | int | float) -> Any:
        """The same for each instance."""
        return _numpy().full(self.size, value)


def pick(sel: Selection, found: Any) -> Any:
    """The numbers of those of the selected instances for which something was found."""
    return found.nonzero()[0] if isinstance(sel, slice) else sel[found]


def larger(one: Any, other: Any) -> Any:
    """Element by element what `max` gives."""
    return _numpy().where(other > one, other, one)


def smaller(one: Any, other: Any) -> Any:
    """Element by element what `min` gives."""
    return _numpy().where(other < one, other, one)


def whole(value: Any) -> Any:
    """Element by element what `int` gives."""
    return _numpy().asarray(value).astype(int)


def _numpy() -> Any:
    try:
        import numpy as np
    except ImportError as missing:
        raise BatchError("batches need NumPy: pip install 'aseme-dsl[batch]'") from missing
    return np


def _compiled(kind: type[Batch]) -> Any:
    """The module with the functions for numba."""
    try:
        import numba  # noqa: F401
    except ImportError as missing:
        raise BatchError("the engine numba needs numba: pip install 'aseme-dsl[numba]'") from missing
    return import_module(kind.__module__ + COMPILED)
