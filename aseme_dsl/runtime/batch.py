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

from aseme_dsl.runtime.plain import ROUNDS, Unsettled, leaves_of

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

    def __init__(self, arrays: Mapping[str, Any]) -> None:
        self.__dict__.update(arrays)

    def __setattr__(self, name: str, value: Any) -> None:
        array = self.__dict__.get(name)
        if array is None:
            raise AttributeError(f"there is no {name} on this blackboard")
        np = _numpy()
        try:
            given = np.asarray(value)
            with np.errstate(invalid="ignore"):  # what is no number is told below
                fitting = given.astype(array.dtype, copy=False)
            fits = np.can_cast(given.dtype, array.dtype, "same_kind") or bool((fitting == given).all())
        except (ValueError, TypeError, OverflowError) as error:
            raise type(error)(f"{name} cannot be set: {error}") from error
        _check_shape(name, given.shape, len(array))
        if not fits:
            changed = given[fitting != given].flat[0]
            raise ValueError(f"{name} cannot be set: {changed} is no {_KINDS[array.dtype.kind]}")
        array[:] = fitting


_KINDS = {"b": "truth", "i": "whole number", "f": "number"}


def _check_shape(name: str, shape: tuple[int, ...], size: int) -> None:
    if shape not in ((), (1,), (size,)):
        given = " by ".join(map(str, shape))
        raise ValueError(f"{name} wants one value for all, or an array of {size}, not one of {given}")


class Batch:
    """So many running instances of a statechart. Subclasses are generated.

    `bb` has an array for each value of the plain blackboard, to be read and written between steps; whole
    numbers have 64 bits. Nothing is active before `start`: until then there are no steps and nothing to ask.
    """

    ARRAYS: ClassVar[tuple[tuple[str, str, bool | int | float, bool], ...]] = ()
    """What the instances have one of each: name, NumPy type, first value, and whether it is on `bb`."""
    EVENTS: ClassVar[Mapping[str, str]] = {}
    """The methods that make a step with an event; with others a step is one without."""
    LEAVES: ClassVar[tuple[str, ...]] = ()
    INNER: ClassVar[Mapping[tuple[int, int], tuple[int, ...]]] = {}
    RUNNING: ClassVar[Mapping[str, tuple[int, int]]] = {}
    END: ClassVar[int] = -1
    """These four are the plain class's."""

    def __init__(self, size: int, engine: str = "numpy") -> None:
        """`size` instances, not yet started.

        Raises:
            BatchError: the engine is not installed, or there is none of that name.
        """
        np = _numpy()
        if engine not in ENGINES:
            raise BatchError(f"there is no engine {engine}; there are {', '.join(ENGINES)}")
        self.size = size
        self.engine = engine
        self._now = 0
        self._is_started = False
        self.stuck: Any = None
        self._everybody = slice(None)
        self._leaves = tuple(map(leaves_of, self.LEAVES))
        # What numba looks at, an instance after the other, lies together; NumPy takes it array by array.
        turned = engine == "numba"
        self._tables = []
        seen: dict[str, Any] = {}
        for kind in TABLES:
            members = [(name, first, is_seen) for name, dtype, first, is_seen in self.ARRAYS if dtype == kind]
            shape = (size, len(members)) if turned else (len(members), size)
            table = np.empty(shape, kind)
            self._tables.append(table)
            for place, (name, first, is_seen) in enumerate(members):
                array = table[:, place] if turned else table[place]
                array[:] = first
                if is_seen:
                    seen[name] = array
                else:
                    setattr(self, name, array)
        self.bb: Any = BatchBoard(seen)
        self._compiled = _compiled(type(self)) if engine == "numba" else None

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
        """Enter the root of every instance, and go on until nothing is enabled."""
        self._is_started = True
        self._run("start")

    def send(self, event: str) -> Any:
        """One step with an event for every instance; for each, whether anything was taken."""
        return self._run(self.EVENTS.get(event, "step"))

    def step(self) -> Any:
        """One step without an event for every instance; for each, whether anything was taken."""
        return self._run("step")

    def done(self, label: str, which: Any) -> Any:
        """One step, before which the activity of a BASIC state has returned in those instances where it runs.

        `which` has a truth for each instance, or is one for all.

        Raises:
            KeyError: the statechart has no such state, or can never be in it.
            TypeError: `which` has no truths, but perhaps the numbers of instances.
            ValueError: `which` has fewer or more of them.
        """
        np = _numpy()
        self._check_started()
        which = np.asarray(which)
        if which.dtype != bool:
            raise TypeError(f"which wants a truth for each instance, not values of type {which.dtype}")
        _check_shape("which", which.shape, self.size)
        found = self.RUNNING.get(label)
        if found is None:
            self.active(label)  # is it there?
            return self.step()
        region, number = found
        ended = which & self.active(label)
        if len(self._leaves[region]) > 1:
            slot = getattr(self, f"r{region}")
            ended &= slot == number
            slot[ended] = number + 1
        return self.step()

    def _check_started(self) -> None:
        if not self._is_started:
            raise BatchError(f"{type(self).__name__} has not been started: call start() first")

    def _run(self, name: str) -> Any:
        self._check_started()
        np = _numpy()
        if self._compiled is None:
            moved = getattr(type(self), f"do_{name}")(self, self._everybody)
        else:
            moved = np.zeros(self.size, bool)
            getattr(self._compiled, f"each_{name}")(moved, *self._tables, self.now)
        if self.stuck.any():
            first = int(np.flatnonzero(self.stuck)[0])
            active = ", ".join(self.configuration(first))
            raise Unsettled(f"instance {first} does not settle after {ROUNDS} rounds, at {active}")
        return moved

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
        """The labels of an instance's active leaves, region by region in document order."""
        self._check_started()
        active: list[tuple[int, int]] = []
        stack = [0]
        while stack:
            region = stack.pop()
            number = int(getattr(self, f"r{region}")[instance]) if len(self._leaves[region]) > 1 else 0
            active.append((region, number))
            stack += self.INNER.get((region, number), ())
        return tuple(self._leaves[region][number] for region, number in sorted(active))

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
