"""Compiler: from source text through every AMOLA model to statecharts, one file for each phase.

The phases:

    load        files and their imports                  sag_to_suc   goals to use cases
    resolve     messages, topics, functions, agents      suc_to_aip   use cases to protocols
    scopes      the names visible at each place          suc_to_srm   use cases to roles
    typecheck   expressions                              aip_to_eac   the statechart of a protocol
    control     expressions onto transitions             srm_to_iac   that of a role, with its protocols

`phases.py` runs them in order.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from aseme_dsl.compiler.stages.analysis import Analysis, Options

if TYPE_CHECKING:
    from aseme_dsl.source import Source


def analyse(
    root: Source | Path | str,
    sources: Mapping[str, str] | None = None,
    options: Options | None = None,
) -> Analysis:
    """Compile `root` (a path, or a text that was read already) with everything that it imports.

    Texts in `sources` (by path) are taken instead of the files on disk. No document raises anything.
    """
    from aseme_dsl.compiler.phases import analyse_files

    return analyse_files(root, sources, options or Options())


__all__ = ["Analysis", "Options", "analyse"]
