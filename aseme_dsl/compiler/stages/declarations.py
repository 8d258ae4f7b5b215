"""Declarations: the files, and what their declarations mean."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

from aseme_dsl.compiler.formula.holes import apart_from_holes
from aseme_dsl.compiler.names.inclusion import Inclusion, include
from aseme_dsl.compiler.names.resolve import resolve
from aseme_dsl.compiler.names.scope import Scope
from aseme_dsl.compiler.names.symbols import Symbols
from aseme_dsl.compiler.read.blocks import Blocks, blocks_of
from aseme_dsl.compiler.read.damage import Damaged, damage
from aseme_dsl.compiler.read.load import Loaded, Read, load
from aseme_dsl.compiler.read.memory import Memory
from aseme_dsl.compiler.stages.found import Found, With
from aseme_dsl.compiler.types.scopes import global_scope
from aseme_dsl.diagnostics import has_errors
from aseme_dsl.records import dataclass
from aseme_dsl.source import Source


@dataclass(frozen=True, slots=True)
class Declarations:
    """What the files declare.

    `resolved` are the symbols as they are; `symbols` the same, of which a memory knows what was asked.
    `blocks` has every role complete. `unread`: something may be written that could not be read.
    """

    loaded: Loaded
    unread: bool
    resolved: Symbols
    symbols: Symbols
    inclusion: Inclusion
    blocks: Blocks
    is_damaged: Damaged
    top: Scope

    @property
    def system(self) -> str:
        """The name of the system; empty where none is declared."""
        return self.symbols.system.name.text if self.symbols.system is not None else ""


def read_declarations(
    root: Source | Path | str, sources: Mapping[str, str] | None, memory: Memory, read: Read | None
) -> With[Declarations]:
    """The files from `root` on, resolved. `sources` and `read` stand for files on disk (see `load`)."""
    found = Found()
    loaded = load(root, sources, read=read, protos=memory.protos)
    found.add(loaded.diagnostics)
    certain = apart_from_holes(loaded.diagnostics)
    resolved = found.keep(resolve(loaded))
    symbols = memory.shared("symbols", resolved)
    unread = has_errors(certain)
    all_blocks = found.keep(blocks_of(loaded.files))
    inclusion = found.keep(include(all_blocks, symbols.is_excused, not unread))
    roles = tuple(memory.same(("role", item.name.text), item) for item in inclusion.blocks.roles)
    aips = tuple(memory.same(("aip", item.name.text), item) for item in inclusion.blocks.aips)
    blocks = replace(inclusion.blocks, aips=aips, roles=roles)
    is_damaged = inclusion.damaged(damage(certain))
    top = found.keep(memory.recall(global_scope, symbols))
    return found.of(Declarations(loaded, unread, resolved, symbols, inclusion, blocks, is_damaged, top))


__all__ = ["Declarations", "read_declarations"]
