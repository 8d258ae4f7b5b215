"""`asemec export promela`: what it says and refuses, and SPIN as a second opinion about `asemec prove`.

SPIN and a C compiler are asked where they are installed: a few random protocols each time, more in the long
lane. They are left out, with the reason, where they are not.
"""

from __future__ import annotations

import os
import random
import re
import shutil
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

import pytest

from aseme_dsl.cli import main
from tests.cli.test_prove import BUY, CENTRES, MEET
from tests.proofs.random_talks import talk_of

TALKS = sorted({33, 45, *range(int(os.environ.get("SPIN_TALKS", "1")))})
"""Seeds of random protocols. One that is too large for a tool is replaced: so many are compared."""
MISSING = [tool for tool in ("spin", "gcc") if shutil.which(tool) is None]
needs_spin = pytest.mark.skipif(bool(MISSING), reason=f"not installed: {', '.join(MISSING)}")
SLOW = 300
"""So many seconds a tool may take on a busy machine."""
LONGEST = 20
"""So many seconds of the processor a checker may use."""
CUT = ("max search depth too small", "Search not completed")
"""What SPIN says if it has not looked at everything."""


def _exported(folder: Path, text: str, *options: str) -> int:
    (folder / "a.aseme").write_text(text)
    return main(["export", "promela", str(folder / "a.aseme"), "-o", str(folder / "out"), *options])


def _run(command: Sequence[str], folder: Path) -> subprocess.CompletedProcess[str]:
    try:
        return subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=SLOW)
    except subprocess.TimeoutExpired:
        pytest.skip(f"NOT COMPARED with SPIN: {command[0]} took more than {SLOW} s")


def _spin(model: Path, *checked: str) -> bool | None:
    """Whether SPIN finds an error; None if it did not come to an end. The test is skipped, and says why, if
    the machine is too busy to compare anything."""
    for command in (["spin", "-a", model.name], ["gcc", "-w", "-O0", "-o", "pan", "pan.c"]):
        made = _run(command, model.parent)
        assert made.returncode == 0, made.stdout + made.stderr
    limited = f'ulimit -t {LONGEST}; exec ./pan -m100000 "$@"'
    done = _run(["sh", "-c", limited, "pan", *checked], model.parent)
    if done.returncode < 0:
        return None
    errors = re.search(r"errors: ([0-9]+)", done.stdout)
    assert errors is not None, done.stdout
    is_cut = any(word in done.stdout + done.stderr for word in CUT)
    return True if errors[1] != "0" else None if is_cut else False


def test_a_protocol_becomes_processes_and_its_clause_a_formula(tmp_path: Path) -> None:
    assert _exported(tmp_path, BUY) == 0
    text = (tmp_path / "out/buy.pml").read_text()
    assert text.count("active proctype") == 2
    assert "ltl p1 { [] ((seen_buyer_Pay_0_2_4_3) -> (seen_seller_Look_0_2_2)) }" in text


SEVERAL = BUY.replace("participant seller {", "participant seller [1..*] {")
TIMER = BUY.replace("else / send", "else / start_timer(t, 1s); send")
NUMBER = BUY.replace("var there : bool = false", "var there : int").replace("[there]", "[there > 1]")
AGAIN = """
srm Buyer  { plays buy.buyer   liveness { Buyer = (buyer . Rest)~ } }
srm Seller { plays buy.seller  liveness { Seller = seller } }
team Market { b : Buyer  s : Seller }
"""
MISUNDERSTOOD = BUY.replace("receives inform Price", "receives not_understood Order, inform Price")
IN_TIME = "every Look@seller leads to Close@seller within 3s"


@pytest.mark.parametrize(
    ("text", "what", "place"),
    [
        (CENTRES, "a role that does not play exactly one participant", "a.aseme:4:5"),
        (MEET, "a protocol that not exactly one agent begins", "a.aseme:4:5"),
        (SEVERAL, "several agents play", "a.aseme:4:"),
        (TIMER, "the action start_timer", "a.aseme:25:"),
        (NUMBER, "this condition", "a.aseme:24:"),
        (BUY + AGAIN, "that its agent plays again", "a.aseme:29:52"),
        (MISUNDERSTOOD, "the answer not_understood", "a.aseme:4:5"),
        (BUY.replace("clause Look", f"clause {IN_TIME}\n  clause Look"), "with a time", "a.aseme:16:"),
    ],
)
def test_what_it_cannot_say_is_refused_with_its_place(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], text: str, what: str, place: str
) -> None:
    assert _exported(tmp_path, text) == 1
    said = capsys.readouterr().err
    assert "error[E323]" in said and what in said and place in said, said
    assert not (tmp_path / "out").exists()


def test_a_tool_that_takes_too_long_is_no_failure_and_is_named(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sys.modules[__name__], "SLOW", 0.01)
    with pytest.raises(pytest.skip.Exception, match=r"^NOT COMPARED with SPIN: sleep took more than 0.01 s$"):
        _run(["sleep", "5"], tmp_path)


@needs_spin
def test_spin_proves_a_clause_and_refutes_a_broken_one(tmp_path: Path) -> None:
    _exported(tmp_path, BUY)
    assert _spin(tmp_path / "out/buy.pml", "-a") is False
    _exported(
        tmp_path, BUY.replace("Look@seller before Pay@buyer", "Pay@buyer before Look@seller"), "--force"
    )
    assert _spin(tmp_path / "out/buy.pml", "-a") is True


UNANSWERED = """\
system Parting
message Word { int n }
aip talk {
  participant alice {
    sends    propose Word, refuse Word by Thank
    receives agree Word
    process  = Ask . [Thank]
  }
  participant bob {
    sends    agree Word by Part
    receives propose Word, refuse Word
    process  = Listen . Part
  }
  control alice {
    enter Ask    : / send propose Word { n = 1 } to bob
    enter Thank  : agree Word from bob
    skip Thank   : after(5s)
  }
  control bob {
    enter Listen : propose Word from alice
    enter Part   : refuse Word from alice
  }
}
"""


@needs_spin
@pytest.mark.parametrize("answers", ["Part", "Listen"])
def test_a_part_that_ends_without_an_answer_says_so(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], answers: str
) -> None:
    """Agents send by themselves what the protocol has for that; after an answer they do not."""
    _exported(tmp_path, UNANSWERED.replace("by Part", f"by {answers}"))
    assert _spin(tmp_path / "out/talk.pml") is (answers == "Listen")
    main(["prove", str(tmp_path / "a.aseme"), "deadlock"])
    assert ("REFUTED" if answers == "Listen" else "PROVED") in capsys.readouterr().out


@needs_spin
@pytest.mark.parametrize("seed", TALKS)
def test_spin_and_prove_find_the_same_deadlocks(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], seed: int
) -> None:
    for another in range(seed, seed + 10_000, 1000):
        text = talk_of(random.Random(another))
        shutil.rmtree(tmp_path / "out", ignore_errors=True)
        assert _exported(tmp_path, text) == 0
        found = _spin(tmp_path / "out/talk.pml")
        capsys.readouterr()
        if found is None:
            continue
        main(["prove", str(tmp_path / "a.aseme"), "deadlock", "--states", "3000"])
        said = capsys.readouterr().out
        if not said.startswith("UNDECIDED"):
            assert said.startswith("REFUTED" if found else "PROVED"), (another, text)
            return
    pytest.fail("each is too large for one of them")
