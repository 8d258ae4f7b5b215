"""Changed files: a text with a few mistakes, and how long it may take to read one."""

from __future__ import annotations

import random
import signal
from collections.abc import Iterator, Sequence
from contextlib import contextmanager

LONGEST = 20
"""In seconds of computing: what one file may take at most. The slowest takes a fiftieth of that."""


def changed(text: str, pieces: Sequence[str], chance: random.Random) -> str:
    """A text with a few characters, pieces or stretches changed."""
    only_words = chance.randrange(2) == 0
    for _ in range(chance.randint(1, 4)):
        at = chance.randrange(len(text) + 1)
        other = chance.randrange(len(text) + 1)
        match 3 if only_words else chance.randrange(5):
            case 0:
                text = text[:at] + chance.choice(pieces) + text[at:]
            case 1:
                text = text[:at] + text[at + chance.randint(1, 30) :]
            case 2:
                text = text[:at] + text[other : other + 60] + text[at:]
            case 3:
                words = text.split('"')
                if len(words) > 3:  # what stands between quotes
                    words[chance.randrange(1, len(words), 2)] = words[chance.randrange(1, len(words), 2)]
                text = '"'.join(words)
            case _:
                text = text[:at] + chr(chance.choice((0, 9, 34, 60, 127, 233, 0x2028, 0x1F600))) + text[at:]
    return text


@contextmanager
def limited(title: str) -> Iterator[None]:
    """Ends what computes for longer than LONGEST, where the system can: a file on which it hangs is named."""
    if not hasattr(signal, "ITIMER_VIRTUAL"):
        yield
        return

    def stop(*_: object) -> None:
        raise TimeoutError(f"more than {LONGEST} s of computing: {title}")

    before = signal.signal(signal.SIGVTALRM, stop)
    signal.setitimer(signal.ITIMER_VIRTUAL, LONGEST)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0)
        signal.signal(signal.SIGVTALRM, before)
