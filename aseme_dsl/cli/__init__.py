"""The command line: `asemec`. One file a command; it parses arguments, prints, and exits.

Exit codes: 0 everything is fine; 1 the files (or what they make) have errors; 2 wrong use; 70 a mistake of
asemec itself; 130 stopped with Ctrl-C.
"""

from __future__ import annotations

from collections.abc import Sequence


def main(arguments: Sequence[str] | None = None) -> int:
    """Do what the command line says (`arguments` without the program's name) and return the exit code."""
    from aseme_dsl.cli.program import run_program

    return run_program(arguments)
