"""The batch backend: fills its templates with what `codegen/batch.py` says, or says what it cannot do."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from aseme_dsl.amola.expression import (
    Arithmetic,
    Call,
    Expired,
    Failed,
    Member,
    Outcome,
    Random,
    StartTimer,
    Value,
)
from aseme_dsl.amola.messages import DURATION, Kind, Type
from aseme_dsl.amola.statechart import Statechart, Transition, Variable
from aseme_dsl.amola.system import System
from aseme_dsl.backends.backend import Artefact, BackendOptions, Refused
from aseme_dsl.backends.plain.generate import module_of, refusals
from aseme_dsl.backends.shared.generate import environment, rendered, source_of, tidy
from aseme_dsl.codegen.batch import Array, generate_batch
from aseme_dsl.codegen.expressions import enum_name
from aseme_dsl.codegen.plain import PlainOptions, generate_plain
from aseme_dsl.codegen.plain_limits import Limit, limits
from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.runtime.batch import COMPILED
from aseme_dsl.runtime.naming import class_name

_TYPES = {Kind.BOOL: "?", Kind.INT: "i8", Kind.DOUBLE: "f8", Kind.DURATION: "i8", Kind.ENUM: "i8"}
"""The NumPy types of variables."""

MESSAGES = "messages (what it sees are variables)"
FUNCTIONS = "functions that are written in Python"
DIVISION = "division, which may fail"
TIMERS = "timers (there is `after`)"
PACES = "`every`"
FAILURES = "the failure of an activity"
OUTCOMES = "the outcome of an activity"
CHANCE = "chance (draw outside, into a variable)"
CHANCE = "chance (draw the values of variables for all at once)"
OUTCOMES = "the outcome or the failure of an activity"
TIMERS = "timers and `every` (there is `after`)"
TYPES = "values that are no truths and no numbers"


@dataclass(frozen=True, slots=True)
class BatchBackend:
    """Emits two modules a role: a class with its code for NumPy, and functions for numba."""

    name: str = "batch"

    def generate(self, system: System, options: BackendOptions) -> tuple[Artefact, ...]:
        """The package of a system.

        Raises:
            Refused: a role does what arrays cannot.
        """
        problems = [problem for chart in system.iacs for problem in problems_of(chart, system)]
        if problems:
            raise Refused(tuple(problems))
        templates = environment(options, Path(__file__).parent / "templates")
        known = {"system": system, "source": source_of(system)}
        artefacts = [rendered(templates, "batch_system.py.j2", f"{system.name}/__init__.py", known)]
        for chart in system.iacs:
            name = f"{system.name}/{module_of(chart.name)}"
            written = {**known, "chart": chart, "code": _code(system, chart), "role": class_name(chart.name)}
            for template, path in (("batch", name), ("compiled", f"{name}{COMPILED}")):
                file = rendered(templates, f"{template}.py.j2", f"{path}.py", written)
                artefacts.append(Artefact(file.path, tidy(file.text)))
        return tuple(artefacts)


def _code(system: System, chart: Statechart) -> object:
    code = generate_plain(system, chart, class_name(chart.name), PlainOptions(tables=False, gates=False))
    constants = {
        enum_name(enum.name, constant): number for enum in system.enums for constant, number in enum.constants
    }
    return generate_batch(code, [_array(system, item) for item in chart.variables], constants)


def _array(system: System, variable: Variable) -> Array:
    value = variable.initial.value
    enum = system.enum(variable.type.name)
    first = value if enum is None else dict(enum.constants)[str(value)]
    assert not isinstance(first, str)
    return Array(variable.name, _TYPES[variable.type.kind], first, seen=True)


def problems_of(chart: Statechart, system: System) -> Iterator[Diagnostic]:
    """One problem for each thing that a batch of a statechart cannot do, with all its places."""
    found = {
        (limit.what, limit.span.start): limit
        for limit in (*limits(chart, system.activities), *_limits(chart))
    }
    hint = "`--backend plain` does one instance at a time, and more"
    yield from refusals(found.values(), "E321", f"a batch of `{chart.name}` cannot do this", hint)


def _limits(chart: Statechart) -> Iterator[Limit]:
    for variable in chart.variables:
        if not _is_number(variable.type):
            yield Limit(TYPES, variable.span)
    for transition in chart.transitions:
        if transition.expression.every is not None:
            yield Limit(PACES, transition.span)
        for event in transition.expression.events:
            if isinstance(event, Failed):
                yield Limit(FAILURES, event.span)
        for action in transition.expression.actions:
            if isinstance(action, StartTimer):
                yield Limit(TIMERS, action.span)
    for transition in chart.transitions:
        yield from _of_expression(transition)
    for _, value in chart.values():
        what = _of_value(value) or ("" if _is_number(value.type) else TYPES)
        if what:
            yield Limit(what, value.span)


def _of_expression(transition: Transition) -> Iterator[Limit]:
    expression = transition.expression
    if expression.every is not None:
        yield Limit(TIMERS, transition.span)
    for event in expression.events:
        if isinstance(event, Failed):
            yield Limit(OUTCOMES, event.span)
    for action in expression.actions:
        if isinstance(action, StartTimer):
            yield Limit(TIMERS, action.span)


def _is_number(kind: Type) -> bool:
    return kind.kind in _TYPES


def _of_value(value: Value) -> str | None:
    match value:
        case Member():
            return MESSAGES
        case Expired():
            return TIMERS
        case Outcome():
            return OUTCOMES
        case Random():
            return CHANCE
        case Call(function=function) if not function.target.startswith("builtin:"):
            return FUNCTIONS
        case Arithmetic(operator="/" | "%"):
            return DIVISION
        case Arithmetic(type=kind) if kind == DURATION:
            return DIVISION
        case Random():
            return CHANCE
        case Outcome():
            return OUTCOMES
        case Expired():
            return TIMERS
    return None


BACKEND = BatchBackend()
