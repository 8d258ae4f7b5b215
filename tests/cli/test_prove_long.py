"""`asemec prove`: where a search is cut, long runs reach what is far from the beginning."""

from __future__ import annotations

import os
import re
import subprocess
import sys

from aseme_dsl.project.proving.judging import Judge
from aseme_dsl.proofs.explore.wandering.wander import wander
from tests.cli.test_prove import verdicts

STEPS = range(1, 9)
FAR = f"""\
system Market
message Offer {{ int euros }}
aip sale {{
  participant seller {{
    sends    cfp Offer, cancel Offer
    receives propose Offer, refuse Offer
    var tired : bool
    process = {" . ".join(f"Walk{step}" for step in STEPS)} . Call . Look . (Stop | Hear)
  }}
  participant buyer {{
    sends    propose Offer, refuse Offer
    receives cfp Offer, cancel Offer
    var keen : bool
    process = {" . ".join(f"Ride{step}" for step in STEPS)} . Listen . Think . (Bid | Leave)
  }}
  control seller {{
    enter Look : / send cfp Offer {{ euros = 1 }} to buyer
    enter Stop : [tired] / send cancel Offer {{ euros = 1 }} to buyer
    enter Hear : propose Offer from buyer or refuse Offer from buyer
  }}
  control buyer {{
    enter Listen : cfp Offer from seller
    enter Bid    : [keen] / send propose Offer {{ euros = 2 }} to seller
    enter Leave  : else / send refuse Offer {{ euros = 2 }} to seller
  }}
}}
"""
"""A sale that begins late: its 60 nearest states are all before that. The seller that stops crosses
the answer."""
CALM = (
    FAR.replace("Look . (Stop | Hear)", "Look . Hear")
    .replace("    enter Stop : [tired] / send cancel Offer { euros = 1 } to buyer\n", "")
    .replace(", cancel Offer", "")
)
"""No messages cross."""
DEAD = FAR.replace("(Bid | Leave)", "(Bid | Leave | Steal)").replace(
    "enter Bid    : [keen]", "enter Steal  : [keen && !keen]\n    enter Bid    : [keen]"
)
"""The buyer never steals."""


STATES = 60


def asked(prove, text: str, question: str, states: int = STATES):  # type: ignore[no-untyped-def]
    (found,) = prove(text, question, "--states", str(states), "--json").json["results"]
    return found


def test_what_only_long_runs_reach_is_not_dead(prove, monkeypatch) -> None:  # type: ignore[no-untyped-def]
    found = asked(prove, FAR, "dead states")
    assert found["verdict"] == "PROVED"
    assert re.search(r"; 6[0-9] states and [0-9]+ of long runs$", found["bounds"])
    monkeypatch.setattr(Judge, "has_enough", lambda judge, further, left: True)
    assert asked(prove, FAR, "dead states")["verdict"] == "UNDECIDED"


def test_what_no_run_reaches_stays_undecided(prove) -> None:  # type: ignore[no-untyped-def]
    found = asked(prove, DEAD, "dead states")
    assert found["verdict"] == "UNDECIDED"
    assert found["reason"].startswith("not reached: state Steal, `[keen && !keen]` (")
    assert "Bid" not in found["reason"]
    assert verdicts(prove(DEAD, "dead states", "--json"))["dead states"] == "REFUTED"


def test_what_is_seen_in_a_long_run_is_a_scenario_that_fails(prove) -> None:  # type: ignore[no-untyped-def]
    found = asked(prove, FAR, "orphan messages")
    assert found["verdict"] == "REFUTED"
    assert found["bounds"].endswith(" of long runs")
    assert len(found["counterexample"]) > 2 * len(STEPS)
    assert "never untaken Offer by" in found["scenario"]


def test_long_runs_are_the_same_every_time(prove, tmp_path) -> None:  # type: ignore[no-untyped-def]
    """Also where names are hashed otherwise."""
    path = tmp_path / "far.aseme"
    path.write_text(FAR, "utf-8")
    command = [sys.executable, "-m", "aseme_dsl", "prove", str(path), "--states", str(STATES), "--json"]
    found = [
        subprocess.run(
            command, env={**os.environ, "PYTHONHASHSEED": seed}, capture_output=True, text=True, check=False
        ).stdout
        for seed in ("1", "2")
    ]
    assert "of long runs" in found[0]
    assert found[0] == found[1]


def test_there_are_none_where_all_states_were_looked_at(prove) -> None:  # type: ignore[no-untyped-def]
    assert "long runs" not in prove(FAR, "--states", "10000").out


def test_without_limits_they_come_to_every_state(prove, monkeypatch) -> None:  # type: ignore[no-untyped-def]
    """They have all answers of a search of the nearest ones."""
    nearest = prove(CALM, "--states", "10000", "--json").json["results"]
    monkeypatch.setattr(
        "aseme_dsl.project.proving.prove.search",
        lambda explored, eyes, monitors, limits, is_enough, far: wander(
            explored, eyes, monitors, limits, lambda graph, left: is_enough(graph), lambda graph: ()
        ),
    )
    long = prove(CALM, "--states", "10000", "--json").json["results"]
    keys = ("name", "verdict")
    assert [[item[key] for key in keys] for item in long] == [[item[key] for key in keys] for item in nearest]
