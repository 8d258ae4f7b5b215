"""Activity forms: what expressions and formulas have to know of activities before these are resolved."""

from __future__ import annotations

from collections.abc import Iterator

from aseme_dsl.compiler.builtins import reserved
from aseme_dsl.compiler.collector import Collector
from aseme_dsl.compiler.names import declared_twice
from aseme_dsl.compiler.symbols import ActivityForm
from aseme_dsl.grammar import tree


def activity_forms(collector: Collector) -> dict[str, ActivityForm]:
    """The form of each activity that a role describes; what several roles say of it is merged (E201, E202).

    Where they contradict each other the first counts: the other is E203.
    """
    found: dict[str, ActivityForm] = {}
    for item in _described(collector):
        name = item.name.text
        known = found.get(name)
        ends = _outcomes(collector, item)
        if known is None or (ends and not known.ends):
            found[name] = ActivityForm(name, ends, item.name.span)
    return found


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
            collector.report("E202", f"an outcome cannot be called `{name}`", name.span, reason)
        first = found.setdefault(name.text, name)
        if first is not name:
            collector.diagnostics.append(declared_twice("the outcome", name, first.span))
    return tuple(found)


__all__ = ["activity_forms"]
