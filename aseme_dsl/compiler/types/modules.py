"""Modules: what a role says runs beside its statechart, resolved."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping

from aseme_dsl.amola.srm import Module
from aseme_dsl.amola.statechart import State
from aseme_dsl.compiler.names.scope import Scope
from aseme_dsl.compiler.read.names import declared_twice
from aseme_dsl.compiler.types.activities import type_activity
from aseme_dsl.diagnostics import Diagnostic, Related
from aseme_dsl.diagnostics.problems import activities as problems
from aseme_dsl.diagnostics.problems.names import NoTarget
from aseme_dsl.grammar.text import tree

_TARGET = re.compile(r"[A-Za-z_]\w*(\.[A-Za-z_]\w*)*:[A-Za-z_]\w*", re.ASCII)


def read_modules(
    written: Iterable[tree.Module], scope: Scope, is_damaged: bool
) -> tuple[tuple[Module, ...], tuple[Diagnostic, ...]]:
    """The modules of a role, in order. Where what is written `is_damaged`, a period may be lost with it."""
    found: dict[str, tree.Module] = {}
    modules: list[Module] = []
    diagnostics: list[Diagnostic] = []
    for item in written:
        name = item.name
        first = found.setdefault(name.text, item)
        if first is not item:
            diagnostics.append(declared_twice("module", name, first.name.span))
            continue
        statement, wrong = type_activity(item.activity, scope)
        diagnostics += wrong
        if item.activity.every is None and not is_damaged:
            diagnostics.append(Diagnostic(problems.NoPeriod(name.text), name.span))
        elif item.activity.every is not None and item.activity.every.nanoseconds <= 0:
            diagnostics.append(Diagnostic(problems.PeriodNotPositive(name.text), item.activity.every.span))
        for word, place in (
            ("within", item.activity.within),
            ("ends", item.activity.ends[0] if item.activity.ends else None),
            ("guarantees", item.activity.guarantees[0] if item.activity.guarantees else None),
        ):
            if place is not None:
                diagnostics.append(Diagnostic(problems.ModuleEnds(name.text, word), place.span))
        if item.activity.simulated is not None:
            diagnostics.append(Diagnostic(problems.ModuleSimulated(name.text), item.activity.simulated))
        if item.activity.waits is not None and not wrong:
            diagnostics.append(Diagnostic(problems.ModuleWaits(name.text), item.activity.waits))
        target = item.target.text if item.target is not None else ""
        if item.target is not None and not _TARGET.fullmatch(target):
            diagnostics.append(Diagnostic(NoTarget("class", target), item.target.span))
        modules.append(Module(statement, target))
    return tuple(modules), tuple(diagnostics)


def also_activities(
    modules: Mapping[str, Iterable[tree.Module]], used: Mapping[str, State]
) -> Iterator[Diagnostic]:
    """E219 for a module that is an activity of some formula, too: one class cannot be both."""
    for written in modules.values():
        for item in written:
            node = used.get(item.name.text)
            if node is not None:
                related = (Related(node.span, "the activity"),)
                yield Diagnostic(problems.ModuleIsActivity(item.name.text), item.name.span, related)


__all__ = ["also_activities", "read_modules"]
