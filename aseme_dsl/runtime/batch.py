"""Batch: thousands of instances of a plain statechart at once, for Monte-Carlo: with NumPy, or numba.

Each instance has a place in arrays; what one does depends on nothing but its own places. Of the plain class
there are two translations: methods over arrays, which NumPy runs, and functions of one instance, which numba
compiles (some seconds, the first time). Both do what the plain class does, step by step.
"""

from __future__ import annotations

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
    """A batch cannot be had as it is asked for; the text says why."""


class BatchBoard:
    """The arrays that a program sees; one that is set is set element by element, or all to one value."""

    def __init__(self, arrays: Mapping[str, Any]) -> None:
        self.__dict__.update(arrays)

    def __setattr__(self, name: str, value: Any) -> None:
        array = self.__dict__.get(name)
        if array is None:
            raise AttributeError(f"there is no {name} on this blackboard")
        try:
            shape = _numpy().shape(value)
            if shape in ((), (1,), array.shape):
                array[:] = value
                return
        except (ValueError, TypeError, OverflowError) as error:
            raise type(error)(f"{name} cannot be set: {error}") from error
        given = " by ".join(map(str, shape))
        raise ValueError(f"{name} wants one value for all, or an array of {len(array)}, not one of {given}")


class Batch:
    """So many running instances of a statechart. Subclasses are generated.

    `bb` has an array for each value of the plain blackboard, to be read and written between steps; whole
    numbers have 64 bits. `now` is the time of all instances, in ns.
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
        self.now = 0
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

    # ---- steps -----------------------------------------------------------------------------

    def start(self) -> None:
        """Enter the root of every instance, and go on until nothing is enabled."""
        self._run("start")

    def send(self, event: str) -> Any:
        """One step with an event for every instance; for each, whether anything was taken."""
        return self._run(self.EVENTS.get(event, "step"))

    def step(self) -> Any:
        """One step without an event for every instance; for each, whether anything was taken."""
        return self._run("step")

    def done(self, label: str, which: Any) -> Any:
        """The activity of a BASIC state has returned in those instances (an array of truths), where it runs.

        Raises:
            KeyError: there is no such state whose completion matters.
        """
        region, number = self.RUNNING[label]
        ended = which & self.active(label)
        if len(self._leaves[region]) > 1:
            slot = getattr(self, f"r{region}")
            ended &= slot == number
            slot[ended] = number + 1
        return self.step()

    def _run(self, name: str) -> Any:
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
