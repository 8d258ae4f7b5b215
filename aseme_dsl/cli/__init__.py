"""The command line: `asemec`. One file a command; it parses arguments, prints, and exits.

Exit codes: 0 success; 1 errors in the files or a failed run; 2 invalid command line; 70 internal error;
130 interrupted with Ctrl-C.
"""

from __future__ import annotations

from collections.abc import Sequence


def main(arguments: Sequence[str] | None = None) -> int:
    """Do what the command line says (`arguments` without the program's name) and return the exit code."""
    from aseme_dsl.cli.program import run_program

    return run_program(arguments)
