"""Compiler: from text through every AMOLA model to statecharts, one file a phase.

load        files and what they import               sag_to_suc   goals to use cases
resolve     messages, topics, functions, agents      suc_to_aip   use cases to protocols
scopes      what is visible where                    suc_to_srm   use cases to roles
typecheck   expressions                              aip_to_eac   a protocol's statechart
control     expressions onto transitions             srm_to_iac   a role's, with its protocols woven in
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from aseme_dsl.compiler.formula_to_statechart import LARGEST
from aseme_dsl.diagnostics.policy import NO_POLICY, Policy

if TYPE_CHECKING:
    from aseme_dsl.amola.system import System
    from aseme_dsl.compiler.missing import Missing
    from aseme_dsl.diagnostics import Diagnostic, Suppressed
    from aseme_dsl.source import Source


@dataclass(frozen=True, slots=True)
class Options:
    """`largest` is the size limit of one statechart, in states; a larger one is E304.

    `policy` says how bad the project finds each kind of problem.
    """

    largest: int = LARGEST
    policy: Policy = NO_POLICY


@dataclass(frozen=True, slots=True)
class Analysis:
    """What is known of a file: every diagnostic, in order, and its system if none of them is an error.

    `missing` are the notes with what `asemec scaffold` writes for each. `is_library`: the file declares no
    system, and nothing but what other files import; that is E008 only where a system is wanted. `suppressed`
    is what comments in the sources allow; it is not among the diagnostics. `unchecked` is the number of
    choices whose conditions were not compared, because z3 is not installed. `files` are all that was read or
    looked for, where they really are.
    """

    system: System | None
    diagnostics: tuple[Diagnostic, ...]
    missing: tuple[Missing, ...] = ()
    is_library: bool = False
    suppressed: tuple[Suppressed, ...] = ()
    unchecked: int = 0
    files: tuple[str, ...] = ()


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
