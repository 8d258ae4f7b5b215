"""Measures a checkout for `agents.py --against`: `python -P agents_measured.py CHECKOUT`, once for each line.

The line says what: `message`, the processor time of one in the rally, or `crowd`, that of a thousand
conversations among a hundred agents, in ns. Both are run by the checkout's own files.
"""

from __future__ import annotations

import gc
import sys
import time
from collections.abc import Callable
from importlib import import_module
from pathlib import Path


def main(checkout: Path) -> None:
    """Measure until nothing more is asked for."""
    sys.path[:0] = [str(checkout), str(checkout / "benchmarks")]
    measures = {"message": message(), "crowd": crowd(checkout)}
    for line in sys.stdin:
        print(measures[line.strip()](), flush=True)


def message() -> Callable[[], float]:
    """What measures the processor time of a message."""
    agents = import_module("agents")
    generated = agents.generate(agents.TEXT)
    return lambda: timed(lambda: len(agents.rally(generated)))


def crowd(checkout: Path) -> Callable[[], float]:
    """What measures the processor time of a thousand conversations."""
    (file,) = (checkout / "tests" / "runtime").rglob("test_many_conversations.py")
    test = import_module(".".join(file.relative_to(checkout).with_suffix("").parts))
    generated = test.generate(test.TEXT.replace("EACH", str(test.EACH)))

    def talk() -> int:
        run, _, wrong = test.talk(generated)
        assert not wrong and run.result.reason == "finished", run.result
        return 1

    return lambda: timed(talk)


def timed(run: Callable[[], int]) -> float:
    """The processor time of each of those that are run."""
    gc.collect()  # what earlier runs have left is none of its cost
    begun = time.process_time_ns()
    number = run()
    return (time.process_time_ns() - begun) / number


if __name__ == "__main__":
    main(Path(sys.argv[1]))
