"""Activity forms: what expressions and formulas have to know of activities before these are resolved."""

from __future__ import annotations

import keyword
from collections.abc import Collection, Iterator
from dataclasses import replace

from aseme_dsl.amola.messages import Parameter
from aseme_dsl.compiler.names.symbols import ActivityForm
from aseme_dsl.compiler.read.builtins import reserved
from aseme_dsl.compiler.read.collector import Collector, type_named
from aseme_dsl.compiler.read.names import declared_twice
from aseme_dsl.diagnostics.problems.names import ReservedName
from aseme_dsl.grammar.text import tree


def activity_forms(
    collector: Collector, enums: Collection[str], messages: Collection[str]
) -> dict[str, ActivityForm]:
    """The form of each activity that a role describes; what several roles say of it is merged (E201, E202).

    Where they contradict each other the first counts: the other is E203. `enums` and `messages` are the names
    of types.
    """
    found: dict[str, ActivityForm] = {}
    for item in _described(collector):
        name = item.name.text
        known = found.get(name)
        ends = _outcomes(collector, item)
        parameters = _parameters(collector, item, enums, messages)
        if known is None:
            found[name] = ActivityForm(name, parameters, ends, item.name.span)
        else:
            found[name] = replace(known, ends=known.ends or ends, parameters=known.parameters or parameters)
    return found


def _parameters(
    collector: Collector, item: tree.Activity, enums: Collection[str], messages: Collection[str]
) -> tuple[Parameter, ...]:
    found: dict[str, Parameter] = {}
    for written in item.parameters:
        name = written.name
        kind = type_named(collector, written.type, enums, messages)
        if kind is None:
            collector.wrong.add(item.name.text)
            continue
        if name.text == "context" or name.text == "self" or keyword.iskeyword(name.text):
            collector.report(ReservedName("parameter", name.text, "python"), name.span)
        first = found.setdefault(name.text, Parameter(name.text, kind, name.span))
        if first.span != name.span:
            collector.diagnostics.append(declared_twice("parameter", name, first.span))
    return tuple(found.values())


def _described(collector: Collector) -> Iterator[tree.Activity]:
    for srm in collector.every(tree.Srm):
        yield from srm.activities
    for chart in collector.every(tree.Statechart):
        yield from chart.activities


def _outcomes(collector: Collector, item: tree.Activity) -> tuple[str, ...]:
    found: dict[str, tree.Name] = {}
    for name in item.ends:
        reason = reserved(name.text)
        if reason is not None:
            collector.report(ReservedName("outcome", name.text, reason), name.span)
        first = found.setdefault(name.text, name)
        if first is not name:
            collector.diagnostics.append(declared_twice("outcome", name, first.span))
    return tuple(found)


__all__ = ["activity_forms"]
