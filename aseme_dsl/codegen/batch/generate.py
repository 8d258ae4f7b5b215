"""The steps of a statechart's plain class as code that runs thousands of instances at once.

What is printed are the steps of the plain class (`codegen/plain`), statement by statement, so that there is
one place that says what a step does. Where the class has a slot (`self.r3`) or its blackboard a value
(`bb.n`), the instances have an array with an element each:

    arrays     for NumPy. `sel` are the instances for which a line is done: a test splits them, a `return` or
               `break` takes some of them out of what follows
    elements   for numba. A function of one instance `i`, and a loop over all
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.amola.system import System
from aseme_dsl.codegen.batch.numba import START, STEP, ForNumba, calling_loop
from aseme_dsl.codegen.batch.numpy import ForNumpy
from aseme_dsl.codegen.batch.simple import Function, simple
from aseme_dsl.codegen.plain.generate import plain_steps
from aseme_dsl.codegen.plain.options import PlainMethod, PlainSteps
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.plain.batch import TABLES

LONG = 1000
"""A loop with more lines than this is with a call: numba would take very long to compile it."""


@dataclass(frozen=True, slots=True)
class Array:
    """What the instances have one of each: its name, its NumPy type, and what it begins with.

    `seen`: it is on the blackboard, where the program that simulates sees and sets it.
    """

    name: str
    dtype: str
    initial: bool | int | float = 0
    seen: bool = False
    constants: tuple[tuple[str, int], ...] = ()
    """Of an enum: their names and numbers."""


@dataclass(frozen=True, slots=True)
class BatchCode:
    """The parts of a module: what the instances have, which steps there are, and both forms of these."""

    arrays: tuple[Array, ...]
    methods: Mapping[str, str]
    """The name of the step with each event that has one."""
    tables: tuple[str, ...]
    """What is said of the regions, as in the plain class."""
    for_numpy: tuple[str, ...]
    """Methods, indented as in a class."""
    for_numba: tuple[str, ...]
    """Functions of an instance, each before those that call it; and the loops over all instances."""
    used: frozenset[str]
    """The functions of the runtime that the methods call."""


def generate_batch(
    system: System, chart: Statechart, class_name: str, variables: Sequence[Array]
) -> BatchCode:
    """Both forms of the steps of a statechart of which a batch refuses nothing.

    `variables` are those on its blackboard.
    """
    steps = plain_steps(system, chart, class_name)
    events = {event: f"on_{event}" for event, _ in steps.events}
    functions = _functions(steps, events)
    arrays = [*variables, *_slots(steps, variables), Array("stuck", "?")]
    owners = {("bb" if item.seen else "self", item.name): item for item in arrays}
    kinds = {key: item.dtype for key, item in owners.items()}
    places = {key: _place(item, arrays) for key, item in owners.items()}
    methods = [ForNumpy(item, kinds, steps.written) for item in functions.values()]
    for_numpy = [line for method in methods for line in (*method.lines(), "")]
    for_numba: list[str] = []
    compiled = {name: ForNumba(item, places, steps.written) for name, item in functions.items()}
    modes = (START, STEP, *events.values())
    called = {name for item in functions.values() for name in item.called}
    loops = {name: compiled[name].loop() for name in modes if name not in called}
    loops = {name: lines for name, lines in loops.items() if len(lines) <= LONG}
    for name in _callees_first({name: item for name, item in functions.items() if name not in loops}):
        for_numba += [*compiled[name].lines(), "", ""]
    for name in modes:
        for_numba += [*(loops.get(name) or calling_loop(name)), "", ""]
    used = frozenset(name for method in methods for name in method.used)
    return BatchCode(tuple(arrays), events, steps.tables, tuple(for_numpy), tuple(for_numba), used)


def _place(array: Array, arrays: Sequence[Array]) -> tuple[str, int]:
    """Where numba finds a value of the instance `i`: all of one type are in a table, in this order."""
    same = [other for other in arrays if other.dtype == array.dtype]
    return TABLES[array.dtype], same.index(array)


def _functions(steps: PlainSteps, events: Mapping[str, str]) -> dict[str, Function]:
    """The step of each mode (`start`, `step`, `on_EVENT`) and the methods that they call, by name."""
    first, *others = steps.methods
    with_events = (PlainMethod(events[event], "bool", block) for event, block in steps.events)
    return {method.name: simple(method) for method in (first, *with_events, *others)}


def _slots(steps: PlainSteps, variables: Sequence[Array]) -> Iterator[Array]:
    """What the class keeps: regions, times, counts, copies of variables, and what was written of these."""
    by_name = {item.name: item for item in variables}
    for name, is_truth, variable in steps.slots:
        if variable:
            yield Array(name, by_name[variable].dtype)
        elif name not in ("writes", "now", "faulty"):
            yield Array(name, "?" if is_truth else "i8")
    for name in steps.written:
        yield Array(f"w_{name}", by_name[name].dtype)
        yield Array(f"p_{name}", "i8", -1)


def _callees_first(functions: Mapping[str, Function]) -> list[str]:
    """The names of functions, each behind those that it calls. None calls itself."""
    found: list[str] = []
    waiting = list(functions)[::-1]
    while waiting:
        name = waiting[-1]
        called = functions[name].called
        missing = [other for other in functions if other in called and other not in found]
        if missing:
            waiting += missing
            continue
        waiting.pop()
        if name not in found:
            found.append(name)
    return found


__all__ = ["Array", "BatchCode", "generate_batch"]
