"""Unused: what the file of the system declares and no place of any file names; roles without agents."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from typing import Literal

from aseme_dsl.compiler.names.symbols import Symbols
from aseme_dsl.compiler.read.blocks import participants_of
from aseme_dsl.compiler.read.library import declared_by
from aseme_dsl.compiler.read.memory import Memory
from aseme_dsl.compiler.types.exchange import is_answered
from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.diagnostics.problems.use import (
    AgentMessageUnmatched,
    DeclarationKind,
    DeclarationNotUsed,
    ImportedTwice,
    ImportNotUsed,
    RoleWithoutAgent,
)
from aseme_dsl.grammar.text import tree
from aseme_dsl.source import Source

_COMMENT = re.compile(r'"(?:[^"\\\n]|\\.)*"|//[^\n]*|/\*.*?\*/', re.DOTALL)
_WORD = re.compile(r"[A-Za-z_]\w*", re.ASCII)


def check_unused(files: Sequence[tree.File], symbols: Symbols, memory: Memory) -> Iterator[Diagnostic]:
    """N727 for what the file of the system declares or imports and nothing names.

    A variable or a topic may be for an activity's Python and is not reported.
    """
    assert symbols.system is not None
    home = symbols.system.span.source
    words = memory.each(_words, [(file.source,) for file in files])
    for file, own_words in zip(files, words, strict=True):
        if file.source.path == home.path:
            yield from _imports(file, own_words)
    own = [item for file in files if file.source.path == home.path for item in file.declarations]
    for what, name in _declared(own):
        if sum(of_file[name.text] for of_file in words) == 1:
            yield Diagnostic(DeclarationNotUsed(what, name.text), name.span)


def _declared(declarations: Iterable[object]) -> Iterator[tuple[DeclarationKind, tree.Name]]:
    for item in declarations:
        match item:
            case tree.Let(name=name):
                yield "let", name
            case tree.Function(name=name):
                yield "function", name
            case tree.Enum(name=name):
                yield "enum", name
            case tree.Message(name=name):
                yield "message", name
            case tree.Srm():
                yield from (("let", let.name) for let in item.lets)
                yield from (("functionality", use.name) for use in item.functionalities)
            case tree.Aip():
                yield from (("let", let.name) for let in item.lets)
                yield from (("let", let.name) for part in item.participants for let in part.lets)


def _words(source: Source) -> Counter[str]:
    """How often each word stands in a file, outside of comments and texts."""
    return Counter(_WORD.findall(_COMMENT.sub(" ", source.text)))


def _imports(file: tree.File, own: Counter[str]) -> Iterator[Diagnostic]:
    """What is imported twice, and what the standard library gives that the file does not use."""
    seen: set[str] = set()
    for item in file.declarations:
        if not isinstance(item, tree.Import):
            continue
        text = item.target.text
        if text in seen:
            yield Diagnostic(ImportedTwice(text), item.target.span)
        elif isinstance(item.target, tree.Name):
            given = declared_by(text)
            if given and not any(own[name] for name in given):
                yield Diagnostic(ImportNotUsed(text), item.target.span)
        seen.add(text)


def check_agents(
    roles: Iterable[tree.Srm | tree.Statechart], symbols: Symbols, told: Iterable[Diagnostic] = ()
) -> Iterator[Diagnostic]:
    """N728 for a role of the system's own file that no agent of its teams has, unless W554 has `told` it."""
    assert symbols.system is not None
    if not symbols.teams:
        return
    played = {agent.role for team in symbols.teams for agent in team.agents}
    known = {place.span for item in told for place in item.related}
    for role in roles:
        if role.name.span in known:
            continue
        if role.span.source.path == symbols.system.span.source.path and role.name.text not in played:
            yield Diagnostic(RoleWithoutAgent(role.name.text), role.name.span)


def check_exchange(aips: Iterable[tree.Aip]) -> Iterator[Diagnostic]:
    """W524 for an agent message that a participant receives and none sends, or sends and none receives."""
    for aip in aips:
        parts = participants_of(aip)
        sent = {(item.performative.text, item.message.text) for part in parts for item in part.sends}
        received = {(item.performative.text, item.message.text) for part in parts for item in part.receives}
        for part in parts:
            own = [item.message.text for item in part.sends]
            clauses: tuple[Literal["sends", "receives"], ...] = ("sends", "receives")
            for clause in clauses:
                items, others = (part.sends, received) if clause == "sends" else (part.receives, sent)
                for item in items:
                    name = f"{item.performative} {item.message}"
                    if clause == "receives" and is_answered(item.performative.text, item.message.text, own):
                        continue
                    if (item.performative.text, item.message.text) not in others:
                        problem = AgentMessageUnmatched(part.name.text, clause, name)
                        yield Diagnostic(problem, item.span)


__all__ = ["check_agents", "check_exchange", "check_unused"]
