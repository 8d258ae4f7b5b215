"""Modules: what a role says runs beside its statechart, resolved."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping

from aseme_dsl.amola.srm import Module
from aseme_dsl.amola.statechart import Node
from aseme_dsl.compiler.names.scope import Scope
from aseme_dsl.compiler.read.names import declared_twice
from aseme_dsl.compiler.types.activities import type_activity
from aseme_dsl.diagnostics import Diagnostic, Related
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
            diagnostics.append(declared_twice("the module", name, first.name.span))
            continue
        statement, problems = type_activity(item.activity, scope)
        diagnostics += problems
        if item.activity.every is None and not is_damaged:
            diagnostics.append(
                Diagnostic(
                    "E218",
                    f"the module `{name}` has no period",
                    name.span,
                    hint=f"say how often it runs: `{name} every 33ms`",
                )
            )
        elif item.activity.every is not None and item.activity.every.nanoseconds <= 0:
            diagnostics.append(
                Diagnostic(
                    "E218",
                    f"the period of the module `{name}` is no time at all",
                    item.activity.every.span,
                    hint="a module runs every so often: `every 33ms`",
                )
            )
        for word, place in (
            ("within", item.activity.within),
            ("ends", item.activity.ends[0] if item.activity.ends else None),
        ):
            if place is not None:
                problem = f"the module `{name}` does not end: it has no `{word}`"
                diagnostics.append(Diagnostic("E522", problem, place.span, hint="leave it out"))
        if item.activity.simulated is not None:
            diagnostics.append(
                Diagnostic(
                    "E545",
                    f"the module `{name}` cannot be simulated: nothing says what it would do",
                    item.activity.simulated,
                    hint="leave the module out as long as it has no code",
                )
            )
        target = item.target.text if item.target is not None else ""
        if item.target is not None and not _TARGET.fullmatch(target):
            diagnostics.append(
                Diagnostic(
                    "E214",
                    f"`{target}` does not say where the Python class is",
                    item.target.span,
                    hint='write "module:Class", or leave it out: then it is found by the module\'s name',
                )
            )
        modules.append(Module(statement, target))
    return tuple(modules), tuple(diagnostics)


def also_activities(
    modules: Mapping[str, Iterable[tree.Module]], used: Mapping[str, Node]
) -> Iterator[Diagnostic]:
    """E219 for a module that is an activity of some formula, too: one class cannot be both."""
    for written in modules.values():
        for item in written:
            node = used.get(item.name.text)
            if node is not None:
                yield Diagnostic(
                    "E219",
                    f"`{item.name}` is a module here, and an activity of a formula",
                    item.name.span,
                    (Related(node.span, "the activity"),),
                    hint="a module runs by itself: give one of them another name",
                )


__all__ = ["also_activities", "read_modules"]
