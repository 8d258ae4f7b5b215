"""Analysis: what is asked of the compiler, and what it has found."""

from __future__ import annotations

from typing import TYPE_CHECKING

from aseme_dsl.compiler.formula.formula_to_statechart import LARGEST
from aseme_dsl.diagnostics.policy import NO_POLICY, Policy
from aseme_dsl.display import Displayed
from aseme_dsl.records import dataclass

if TYPE_CHECKING:
    from aseme_dsl.amola.system import System
    from aseme_dsl.compiler.read.missing import Missing
    from aseme_dsl.diagnostics import Diagnostic, Suppressed


@dataclass(frozen=True, slots=True)
class Options:
    """`largest` is the size limit of one statechart, in states; a larger one is E304.

    `policy` says how bad the project finds each kind of problem.
    """

    largest: int = LARGEST
    policy: Policy = NO_POLICY


@dataclass(frozen=True, slots=True)
class Analysis(Displayed):
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
