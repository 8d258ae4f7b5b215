"""Reader process: reads the texts that the language server gives it, one after the other.

Each question and each answer is its length (`LENGTH` bytes) and a pickle: the process is the server's own
child, and its pipes are theirs alone. For each text it may compute for some seconds; then the operating
system ends it, wherever it is.
"""

from __future__ import annotations

import io
import pickle
import signal
import sys
from collections.abc import Callable, Mapping

from aseme_dsl.grammar import parse
from aseme_dsl.grammar.layout import format_source
from aseme_dsl.grammar.parsing.copies import dump
from aseme_dsl.source import Source

LENGTH = 8

WORK: Mapping[str, Callable[[Source], object]] = {"parse": parse, "layout": format_source}
"""What can be asked for."""


def main(most: float) -> None:
    """Answer until the server closes the pipe; `most` is in seconds of computing for one text."""
    questions, answers = sys.stdin.buffer, sys.stdout.buffer
    sys.stdout = sys.stderr
    while size := questions.read(LENGTH):
        work, path, text = pickle.load(io.BytesIO(questions.read(int.from_bytes(size, "big"))))
        source = Source(path, text)
        if hasattr(signal, "setitimer"):
            signal.setitimer(signal.ITIMER_VIRTUAL, most)
        answer = dump(WORK[work](source), source)
        if hasattr(signal, "setitimer"):
            signal.setitimer(signal.ITIMER_VIRTUAL, 0)
        answers.write(len(answer).to_bytes(LENGTH, "big") + answer)
        answers.flush()


__all__ = ["LENGTH", "WORK", "main"]
