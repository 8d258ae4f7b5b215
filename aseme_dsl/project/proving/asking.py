"""Asking: what the names stand for that `asemec prove` is given, and what to say of those that are none."""

from __future__ import annotations

from collections.abc import Sequence

from aseme_dsl.amola.system import System
from aseme_dsl.diagnostics.suggest import closest
from aseme_dsl.diagnostics.wording import did_you_mean, listed
from aseme_dsl.grammar.text import tree
from aseme_dsl.project.building.project import Compiled
from aseme_dsl.project.proving.results import BUILT_IN
from aseme_dsl.project.proving.scopes import TEAM
from aseme_dsl.source import is_library_path

_TALKS = "no agent sends or takes a message of a protocol"
_NEEDS = {
    "agreement": "no protocol of the file has two outcomes with `when`",
    "orphan messages": _TALKS,
    "non-local choice": _TALKS,
}


def narrowed(compiled: Compiled, asked: Sequence[str]) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """What is explored of the team and the protocols alone, all if none; and the names of what to answer.

    Protocols are asked for by their names. A property with the same title comes first.
    """
    assert compiled.system is not None
    titles = {
        item.title.text
        for file in compiled.inspection.loaded.files
        for item in file.must_hold
        if isinstance(item, tree.Property)
    }
    own = [item.name for item in compiled.system.aips if not is_library_path(item.span.source.path)]
    parts = {TEAM: TEAM, **{name: f"protocol {name}" for name in own}}
    parts = {name: what for name, what in parts.items() if name not in titles}
    models = {name: name if name in titles else _in_models(name) for name in asked}
    only = dict.fromkeys(parts[name] for name in models.values() if name in parts)
    return tuple(only), tuple(name for name, model in models.items() if model not in parts)


def _in_models(name: str) -> str:
    """What `talk.ask`, a protocol of a file with an alias, is called in the models."""
    return name.replace(".", "_") if all(part.isidentifier() for part in name.split(".")) else name


def nothing_for(question: str) -> str:
    """Why there is nothing of which a built-in question asks."""
    return _NEEDS.get(question, "there is no role and no protocol")


def not_there(name: str, there: Sequence[str], system: System) -> str:
    """That nothing is called so: with the most similar name, or with all of them."""
    if name in BUILT_IN:
        return f"`{name}` has no answer: {nothing_for(name)}"
    if name.endswith(".aseme"):
        return f"`{name}` is one file too many: one system is proved, and imports its other files"
    own = [aip.name for aip in system.aips if not is_library_path(aip.span.source.path)]
    names = list(dict.fromkeys((*there, *BUILT_IN, *own, TEAM)))
    similar = closest(name, names)
    hint = did_you_mean(similar) if similar is not None else f"there are {listed(names)}"
    return f"no property, clause or question is called `{name}`; {hint}"


__all__ = ["narrowed", "not_there", "nothing_for"]
