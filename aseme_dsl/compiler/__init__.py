"""Compiler: from text through every AMOLA model to statecharts, one file a phase.

load        files and what they import               sag_to_suc   goals to use cases
resolve     messages, topics, functions, agents      suc_to_aip   use cases to protocols
scopes      what is visible where                    suc_to_srm   use cases to roles
typecheck   expressions                              aip_to_eac   a protocol's statechart
control     expressions onto transitions             srm_to_iac   a role's, with its protocols woven in
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
