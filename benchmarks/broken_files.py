"""Broken files through `asemec check`: `python benchmarks/broken_files.py [NUMBER] [SEED]`.

Each file is a program of the project with slips in it, pieces of several programs, words of the language in
any order, or bytes. What counts: no traceback, exit code 0 or 1, less than 5 s of CPU time for one file.
Exits with 1 if a file breaks that, and keeps the file.
"""

from __future__ import annotations

import contextlib
import io
import random
import sys
import tempfile
import time
from collections import Counter
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

from aseme_dsl.cli.program import run_program
from tests.support.mutations import slips

ROOT = Path(__file__).parents[1]
PROGRAMS = [
    path.read_text("utf-8")
    for folder in ("tests/acceptance", "stdlib", "examples/robocup")
    for path in sorted((ROOT / folder).glob("*.aseme"))
]
WORDS = sorted({word for text in PROGRAMS for word in text.split()})
LIMIT = 5.0


def broken(chance: random.Random) -> bytes:
    """One broken file."""
    text = chance.choice(PROGRAMS)
    kind = chance.randrange(6)
    if kind <= 1:
        for _ in range(chance.choice([1, 2, 3, 8, 30])):
            slip = next(slips(text, chance.randrange(1 << 30)), None)
            text = slip.text if slip is not None else text
        return text.encode()
    if kind == 2:
        other = chance.choice(PROGRAMS)
        return (text[: chance.randrange(len(text))] + other[chance.randrange(len(other)) :]).encode()
    if kind == 3:
        lines = text.splitlines()
        chance.shuffle(lines)
        return "\n".join(lines[: chance.randrange(1, len(lines))]).encode()
    if kind == 4:
        return " ".join(chance.choices(WORDS, k=chance.choice([3, 30, 300]))).encode()
    content = bytearray(text.encode())
    for _ in range(chance.choice([1, 5, 200])):
        content[chance.randrange(len(content))] = chance.randrange(256)
    return bytes(content)


def main(number: int, seed: int) -> int:
    """Check that many; the number of files that were not answered as they should be."""
    chance = random.Random(seed)
    codes: Counter[int] = Counter()
    bad = 0
    slowest = 0.0
    with tempfile.TemporaryDirectory() as name:
        path = Path(name) / "broken.aseme"
        for index in range(number):
            content = broken(chance)
            path.write_bytes(content)
            begun = time.process_time()
            out = io.StringIO()
            with contextlib.redirect_stdout(out), contextlib.redirect_stderr(out):
                code = run_program(["check", str(path)])
            taken = time.process_time() - begun
            slowest = max(slowest, taken)
            codes[code] += 1
            if code not in (0, 1) or taken > LIMIT or "Traceback" in out.getvalue():
                bad += 1
                kept = Path(tempfile.gettempdir()) / f"broken-{seed}-{index}.aseme"
                kept.write_bytes(content)
                print(f"{kept}: exit code {code}, {taken:.1f} s\n{out.getvalue()[-400:]}")
    print(f"{number} files: exit codes {dict(sorted(codes.items()))}, slowest {slowest:.2f} s of CPU time")
    return bad


if __name__ == "__main__":
    given = [int(argument) for argument in sys.argv[1:]]
    sys.exit(1 if main(given[0] if given else 10_000, given[1] if len(given) > 1 else 1) else 0)
