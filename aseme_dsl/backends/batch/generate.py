"""The batch backend: fills its templates with what `codegen/batch` says, or says what it cannot do."""

from __future__ import annotations

from collections.abc import Iterator
from math import isfinite
from pathlib import Path
from typing import TypeGuard

from aseme_dsl.amola.expression import (
    Arithmetic,
    Call,
    Conditional,
    Expired,
    Failed,
    Literal,
    Member,
    Outcome,
    Random,
    StartTimer,
    Value,
)
from aseme_dsl.amola.messages import DOUBLE, DURATION, Kind, Type
from aseme_dsl.amola.statechart import Statechart, Transition, Variable
from aseme_dsl.amola.system import System
from aseme_dsl.backends.backend import Artefact, BackendOptions, Refused
from aseme_dsl.backends.plain.generate import module_names, refusals
from aseme_dsl.backends.shared.generate import environment, rendered, source_of, tidy
from aseme_dsl.codegen.batch.generate import Array, BatchCode, generate_batch
from aseme_dsl.codegen.plain_limits import Limit, limits
from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.diagnostics.problems.running import NotBatch, NotBatchButPlain, SingleFeature
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.message.naming import class_name
from aseme_dsl.runtime.plain.batch import COMPILED

_TYPES = {Kind.BOOL: "?", Kind.INT: "i8", Kind.DOUBLE: "f8", Kind.DURATION: "i8", Kind.ENUM: "i8"}
"""The NumPy types of variables."""


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
        modules = module_names(system, COMPILED)
        for chart in system.iacs:
            name = f"{system.name}/{modules[chart.name]}"
            code = _code(system, chart)
            used = ["Batch", "Selection", *(name for name in _CALLED if name in code.used)]
            written = {**known, "chart": chart, "code": code, "role": class_name(chart.name), "used": used}
            for template, path in (("batch", name), ("compiled", f"{name}{COMPILED}")):
                file = rendered(templates, f"{template}.py.j2", f"{path}.py", written)
                artefacts.append(Artefact(file.path, tidy(file.text)))
        return tuple(artefacts)


_CALLED = ("larger", "pick", "smaller", "whole")
"""What a module imports where it calls it."""


def _code(system: System, chart: Statechart) -> BatchCode:
    variables = [_array(system, item) for item in chart.variables]
    return generate_batch(system, chart, class_name(chart.name), variables)


def _array(system: System, variable: Variable) -> Array:
    value = variable.initial.value
    enum = system.enum(variable.type.name)
    first = value if enum is None else dict(enum.constants)[str(value)]
    assert not isinstance(first, str)
    constants = () if enum is None else enum.constants
    return Array(variable.name, _TYPES[variable.type.kind], first, seen=True, constants=constants)


def problems_of(chart: Statechart, system: System) -> Iterator[Diagnostic]:
    """One problem for each thing that a batch of a statechart cannot do, with all its places."""
    known = limits(chart, system.activities)
    yield from refusals(known, chart, NotBatch)
    told = {_place(limit) for limit in known}
    own: list[Limit] = []
    for limit in _limits(chart):
        if _place(limit) not in told:
            told.add(_place(limit))
            own.append(limit)
    yield from refusals(own, chart, NotBatchButPlain)


def _place(limit: Limit) -> tuple[str, int, int]:
    """The place of a limit: only the first limit of each place is reported."""
    return limit.span.source.path, limit.span.start, limit.span.end


def _limits(chart: Statechart) -> Iterator[Limit]:
    for variable in chart.variables:
        if not _is_number(variable.type):
            yield Limit(SingleFeature.TYPES, variable.span)
        elif variable.bounds is not None:
            yield Limit(SingleFeature.BOUNDS, variable.span)
    for transition in chart.transitions:
        yield from _of_expression(transition)
    for _, value in chart.values():
        what = _of_value(value) or (None if _is_number(value.type) else SingleFeature.TYPES)
        if what is not None:
            yield Limit(what, value.span)


def _of_expression(transition: Transition) -> Iterator[Limit]:
    expression = transition.expression
    if expression.every is not None:
        yield Limit(SingleFeature.TIMERS, transition.span)
    for event in expression.events:
        if isinstance(event, Failed):
            yield Limit(SingleFeature.OUTCOMES, event.span)
    for action in expression.actions:
        if isinstance(action, StartTimer):
            yield Limit(SingleFeature.TIMERS, action.span)


def _is_number(kind: Type) -> bool:
    return kind.kind in _TYPES


def _of_value(value: Value) -> SingleFeature | None:
    match value:
        case Member():
            return SingleFeature.MESSAGES
        case Expired():
            return SingleFeature.TIMERS
        case Outcome():
            return SingleFeature.OUTCOMES
        case Random():
            return SingleFeature.CHANCE
        case Call(function=function) if function.is_of_document:
            return SingleFeature.FUNCTIONS
        case Conditional():
            return SingleFeature.CONDITIONALS
        case Arithmetic(operator="/" | "%", right=by) if not (_is_written(by) and by.value):
            return SingleFeature.DIVISION
        case Arithmetic(operator="*", left=one, right=other, type=kind) if kind == DURATION:
            doubles = [side for side in (one, other) if side.type == DOUBLE]
            return None if all(map(_is_written, doubles)) else SingleFeature.SCALING
    return None


def _is_written(value: Value) -> TypeGuard[Literal]:
    """Whether it is a number that stands there, and no infinite one."""
    return isinstance(value, Literal) and isinstance(value.value, int | float) and isfinite(value.value)


BACKEND = BatchBackend()
