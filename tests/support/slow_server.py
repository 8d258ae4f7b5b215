"""A language server whose grammar is slow: at the word `Sloth` for ever, at `Snail` for a while."""

from __future__ import annotations

import re
import sys
import time
from typing import Any

from aseme_dsl.editor.answers.navigation import PythonFolders
from aseme_dsl.editor.files.workspace import Project
from aseme_dsl.editor.reading import reader_process
from aseme_dsl.editor.reading.reading import Reader
from aseme_dsl.editor.server import make_server
from aseme_dsl.grammar.parsing import terminals

MOST = 1.0
"""Seconds of computing that the reader may take for a text."""

SNAIL = 0.6
"""Seconds of computing that a `Snail` takes: more than the server has."""

COMMAND = (sys.executable, __file__)

_FOR_EVER = re.compile(r"(?:a|a)*b")


def plant() -> None:
    """Make every terminal of the grammar slow at these words."""
    matcher = terminals._matcher

    def planted(rule: Any) -> Any:
        match = matcher(rule)

        def slow(text: str, position: int) -> Any:
            if text.startswith("Sloth", position):
                _FOR_EVER.match("a" * 60)
            if text.startswith("Snail", position) and rule.rule_name == "FormulaToken":
                end = time.thread_time() + SNAIL
                while time.thread_time() < end:
                    pass
            return match(text, position)

        return slow

    terminals._matcher = planted


if __name__ == "__main__":
    plant()
    if sys.argv[1:] == ["reader"]:
        reader_process.main(MOST)
    else:
        reader = Reader((*COMMAND, "reader"), most=MOST)
        folders = PythonFolders()
        make_server("0", Project(), lambda root: folders, reader).start_io()
