"""Activities that are begun anew for ever: an end that does more than to begin them again is a move.

Each program needs one of the conditions under which an end is taken for idle.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from aseme_dsl.proofs.explore.explored import Assumed
from tests.proofs.test_roles import explored, without_steady

WRITES = """\
system Writes
message Ball { bool near }
topic eye { state Ball }
srm robot {
  var n : int = 0
  liveness { robot = Look~ || play  play = Kick | Rest }
  activities { Look writes n }
  control play { enter Kick : [n > 3]  enter Rest : when [eye.state.Ball.near] }
}
"""
ASKED = """\
system Asked
message Ball { bool near }
topic eye { state Ball }
srm robot {
  liveness { robot = play || Look~  play = Wait . (Kick | Rest) }
  control play { enter Kick : when [ASKED]  enter Rest : when [eye.state.Ball.near] }
}
"""
TELLS = """\
system Tells
message Ball { bool near }
message Word { int n }
topic eye { state Ball }
topic team { state Word }
srm robot {
  liveness { robot = Look~ || play  play = Wait . Kick }
  activities { Look writes team.state.Word }
  control play { enter Kick : when [eye.state.Ball.near] }
}
srm other { liveness { other = Hear . Rest }  control other { enter Rest : when [team.state.Word.n > 3] } }
"""
ENDS = """\
system Ends
message Ball { bool near }
topic eye { state Ball }
srm robot {
  liveness { robot = Look~ || play  play = Wait . (Kick | Rest) }
  activities { Look ends good, bad within 1s }
  control play { enter Kick : when [eye.state.Ball.near] enter Rest : after(1s) }
}
"""
UNASKED = """\
system Unasked
message Ball { bool near }
topic eye { state Ball }
message Word { int n }
topic log { state Word }
srm robot {
  liveness { robot = Look~ || play  play = Wait . Kick }
  activities { Look writes log.state.Word }
  control play { enter Kick : when [eye.state.Ball.near] }
}
"""


@pytest.mark.parametrize(
    ("text", "roles"),
    [
        pytest.param(WRITES, ("robot",), id="writes"),
        pytest.param(ASKED.replace("ASKED", "done(Look)"), ("robot",), id="done"),
        pytest.param(ASKED.replace("ASKED", "done(Look) && eye.state.Ball.near"), ("robot",), id="done and"),
        pytest.param(ASKED.replace("ASKED", "!in(Look)"), ("robot",), id="in"),
        pytest.param(ASKED.replace("ASKED", "count(Look) > 2"), ("robot",), id="count"),
        pytest.param(ENDS.replace("after(1s)", "when [outcome(Look) == bad]"), ("robot",), id="outcome"),
        pytest.param(TELLS, ("robot", "other"), id="tells"),
    ],
)
def test_an_end_that_does_more_is_a_move(
    text: str, roles: tuple[str, ...], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    found, answers = explored(text, tmp_path / "a", *roles)
    without_steady(monkeypatch)
    full, others = explored(text, tmp_path / "b", *roles)
    assert found.cut is full.cut is None
    assert answers == others


@pytest.mark.parametrize("text", [ENDS, UNASKED], ids=["ends", "unasked"])
@pytest.mark.parametrize("fails", [frozenset[str](), frozenset(("Look",))], ids=["", "fails"])
def test_one_of_which_nothing_asks_is_none(
    text: str, fails: frozenset[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    found, answers = explored(text, tmp_path / "a", "robot", assumed=Assumed(fails=fails))
    without_steady(monkeypatch)
    full, others = explored(text, tmp_path / "b", "robot", assumed=Assumed(fails=fails))
    assert found.cut is full.cut is None
    assert answers == others
    assert found.moves < full.moves
