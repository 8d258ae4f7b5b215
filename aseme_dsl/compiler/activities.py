"""Activities: what the roles say of them, resolved, and merged into one statement an activity."""

from __future__ import annotations

from collections.abc import Iterable

from aseme_dsl.amola.srm import Activity
from aseme_dsl.compiler.scope import Scope
from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.grammar import tree


def type_activity(written: tree.Activity, scope: Scope) -> tuple[Activity, tuple[Diagnostic, ...]]:
    """One role's statement about an activity; `kind` is "" where it does not say. `scope` is the role's."""
    raise NotImplementedError


def merge_activities(
    statements: Iterable[Activity],
) -> tuple[tuple[Activity, ...], tuple[Diagnostic, ...]]:
    """One activity for each name, in order: same or disjoint clauses join, different ones are E203.

    `kind` is "thread" where no role says otherwise.
    """
    raise NotImplementedError
