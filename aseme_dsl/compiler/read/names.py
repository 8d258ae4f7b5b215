"""Names: the diagnostics about names that every phase gives in the same words, and each file's spelling.

A role `attacker` of a file with the alias `alice` is `alice_attacker` in the models; its own file writes
`attacker`, and a file with the alias `alice.attacker`. A diagnostic has the names as its file writes them.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from typing import Concatenate, ParamSpec

from aseme_dsl.compiler.read.builtins import PERFORMATIVES
from aseme_dsl.diagnostics import Diagnostic, Edit, Problem, Related, closest, surely
from aseme_dsl.diagnostics.problems.absences import NoPerformative, Unknown
from aseme_dsl.diagnostics.problems.names import DeclaredTwice
from aseme_dsl.grammar.text import tree
from aseme_dsl.records import dataclass
from aseme_dsl.source import Span, is_library_path

P = ParamSpec("P")


def unknown(
    problem: Callable[Concatenate[str, str | None, tuple[str, ...], P], Unknown],
    name: tree.Name,
    candidates: Iterable[str],
    *values: P.args,
    **named: P.kwargs,
) -> Diagnostic:
    """`name` is none of the candidates; `values` are the further fields of the problem."""
    pool = tuple(sorted(set(candidates)))
    found = problem(name.text, None, pool, *values, **named)
    if found.certain is not None:
        return Diagnostic(found, name.span)
    return Diagnostic(found.but(close=closest(name.text, pool)), name.span, fix=surely(name.text, pool))


def declared_twice(what: str, name: tree.Name | tree.Text, first: Span) -> Diagnostic:
    """`name` has a declaration already, at `first`."""
    problem = DeclaredTwice(what, name.text, is_library_path(first.source.path))
    return Diagnostic(problem, name.span, (Related(first, "first declared here"),))


def unknown_performative(name: tree.Name) -> Diagnostic:
    """E512."""
    return unknown(NoPerformative, name, PERFORMATIVES)


# ---- spelling ------------------------------------------------------------------------------------

_WORD = re.compile(r"[A-Za-z_]\w*")


@dataclass(frozen=True, slots=True)
class Spelling:
    """How a file writes the names that differ in the models; of those `elsewhere` it can write none."""

    names: Mapping[str, str]
    elsewhere: frozenset[str] = frozenset()


Spellings = Mapping[str, Spelling]
"""By the path of the file."""


def as_written(found: Iterable[Diagnostic], spellings: Spellings) -> tuple[Diagnostic, ...]:
    """The diagnostics, each with the names of the file that it is about."""
    return tuple(_told(item, spellings) for item in found)


def of_homonyms(roles: Iterable[tree.Srm | tree.Statechart]) -> dict[str, Spelling]:
    """How files write the participants that have the names of their roles (homonyms.py)."""
    found: dict[str, dict[str, str]] = {}
    for role in roles:
        for part in role.plays if isinstance(role, tree.Srm) else ():
            if part.alias is not None and part.alias.span == part.participant.span:
                own = found.setdefault(part.alias.span.source.path, {})
                own[part.alias.text] = part.participant.text
    return {path: Spelling(own) for path, own in found.items()}


def together(first: Spellings, second: Spellings) -> Spellings:
    """Both, the second one where they differ."""
    found = dict(first)
    for path, own in second.items():
        other = found.get(path, _AS_IN_MODELS)
        found[path] = Spelling({**other.names, **own.names}, other.elsewhere)
    return found


_AS_IN_MODELS = Spelling({})


def _told(item: Diagnostic, spellings: Spellings) -> Diagnostic:
    path = item.span.source.path if item.span is not None else item.path
    own = spellings.get(path or "")
    if own is None:
        return item
    if isinstance(item.problem, Unknown) and item.problem.others and item.span is not None:
        item = _nearest(item, item.problem, own)
    return replace(
        item,
        problem=_problem(item.problem, own),
        fix=None if item.fix is None else _text(item.fix, own),
        related=tuple(Related(place.span, _text(place.message, own)) for place in item.related),
        edits=tuple(
            Edit(edit.span, _text(edit.text, spellings.get(edit.span.source.path, _AS_IN_MODELS)))
            for edit in item.edits
        ),
    )


def _nearest(item: Diagnostic, problem: Unknown, own: Spelling) -> Diagnostic:
    """With the name that is spelt alike as the file writes it: no prefix makes it more or less alike."""
    others = tuple(name for name in problem.others if name not in own.elsewhere)
    if item.edits or problem.certain is not None or not any(name in own.names for name in problem.others):
        return item
    by_word: dict[str, list[str]] = {}
    for name in others:
        by_word.setdefault(_text(name, own).rpartition(".")[2], []).append(name)
    word, sure = closest(problem.name, by_word), surely(problem.name, by_word)
    near = min(by_word[word], key=lambda name: ("." in _text(name, own), name)) if word is not None else None
    fix = near if sure is not None and word is not None and len(by_word[word]) == 1 else None
    return replace(item, problem=problem.but(close=near, others=others), fix=fix)


def _problem(problem: Problem, own: Spelling) -> Problem:
    changes = {name: _value(value, own) for name, value in vars(problem).items()}
    return problem if changes == vars(problem) else problem.but(**changes)


def _value(value: object, own: Spelling) -> object:
    if isinstance(value, str):
        return _text(value, own) if type(value) is str else value
    return tuple(_value(item, own) for item in value) if type(value) is tuple else value


def _text(text: str, own: Spelling) -> str:
    return _WORD.sub(lambda word: own.names.get(word[0], word[0]), text)
