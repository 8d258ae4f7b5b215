"""One seed, one trace: whatever the hashes of texts are, and however many processes play."""

from __future__ import annotations

import os
import subprocess
import sys
from hashlib import sha256
from pathlib import Path

import pytest

from aseme_dsl.project.spreading.spread import spread
from tests.faults.test_seeded import TALK
from tests.runtime.playing import SECOND, play
from tests.support.generated import generate

ROOT = Path(__file__).parents[3]


def hash_of(place: tuple[Path, int]) -> str:
    """The hash of the trace of a run."""
    folder, seed = place
    path = folder / f"{os.getpid()}-{seed}.jsonl.gz"
    play(generate(TALK), trace=path, until=SECOND, seed=seed)
    return sha256(path.read_bytes()).hexdigest()


def test_in_one_and_in_two_processes(tmp_path: Path) -> None:
    places = [(tmp_path, seed) for seed in range(1, 5)]
    alone = [hash_of(place) for place in places]
    assert alone == spread(hash_of, places, 2, (), lambda: None)
    assert alone == [hash_of(place) for place in places]


@pytest.mark.parametrize("value", ["0", "1", "4242"])
def test_whatever_the_hashes_of_texts_are(value: str, tmp_path: Path) -> None:
    code = (
        f"import sys; from pathlib import Path; sys.path.insert(0, {str(ROOT)!r})\n"
        "from tests.runtime.trace.test_same_trace import hash_of\n"
        f"print(hash_of((Path({str(tmp_path)!r}), 7)))"
    )
    environment = {**os.environ, "PYTHONHASHSEED": value}
    done = subprocess.run([sys.executable, "-c", code], env=environment, stdout=subprocess.PIPE, text=True)
    assert done.stdout.strip() == hash_of((tmp_path, 7))
