"""`asemec prove`: what the answer about dead states says of what is hard to reach, or not asked for."""

from __future__ import annotations

import pytest

from tests.cli.test_prove import verdicts

pytestmark = pytest.mark.long

KEEPER = """\
system Keeper
message Ball {{ double speed  double bearing }}
topic eye {{ data Ball }}
srm keeper {{
  liveness {{
    keeper = Wait . playing~
    playing = Dive | Kick | Scan
  }}
  activities {{ Wait takes 1s  Dive takes 1s  Kick takes 1s  Scan takes 1s }}
  control playing reactive {{
    enter Dive : [{dive}]
    enter Kick : [eye.data.Ball.speed > 80]
    enter Scan : else
    {leave}
  }}
}}
team T {{ one : keeper }}
"""
SEEN = "eye.data.Ball.speed > 90"


@pytest.mark.parametrize(
    "seen", ["abs(mean(eye.data.Ball.bearing, 300ms)) < 30", "mean(eye.data.Ball.bearing, 300ms) > 99"]
)
def test_what_asks_for_a_mean_is_reached(prove, seen: str) -> None:  # type: ignore[no-untyped-def]
    found = verdicts(prove(KEEPER.format(dive=seen, leave=""), "--json", "--budget", "20s"))
    assert found == {"deadlock": "UNDECIDED", "dead states": "PROVED", "failures": "UNDECIDED"}


@pytest.mark.parametrize(
    ("dive", "leave", "verdict"),
    [
        (f"{SEEN} || in(Dive)", "", "PROVED"),
        (f"!!({SEEN} || in(playing) && in(Dive))", "", "PROVED"),
        (f"{SEEN} || in(Wait)", "", "PROVED"),
        (f"{SEEN} || in(Dive)", f"leave Dive : when [{SEEN} && !in(Dive)]", "REFUTED"),
        (f"{SEEN} && in(Wait) || in(Dive)", "", "REFUTED"),
    ],
)
def test_a_reactive_choice_may_keep_what_it_has_chosen(prove, dive: str, leave: str, verdict: str) -> None:  # type: ignore[no-untyped-def]
    found = verdicts(prove(KEEPER.format(dive=dive, leave=leave), "--json"))
    assert found["dead states"] == verdict


COPIES = """\
system Works
srm a {{
  liveness {{ a = {formula}  b = U . V }}
  control b {{ enter V : {line} }}
}}
team T {{ one : a }}
"""


@pytest.mark.parametrize(
    ("formula", "line", "verdict"),
    [
        ("b[3]", "when [index == 2]", "PROVED"),
        ("(X . b[2])[2]", "when [index == 2]", "PROVED"),
        ("b[3]", "when [index == 4]", "REFUTED"),
        ("(Z . b) || (Y . b)", "when [in(Z)]", "REFUTED"),
    ],
)
def test_of_the_copies_of_a_number_one_has_to_be_reached(
    prove, formula: str, line: str, verdict: str
) -> None:  # type: ignore[no-untyped-def]
    found = prove(COPIES.format(formula=formula, line=line), "dead states", "--json")
    assert verdicts(found)["dead states"] == verdict


NESTED = """\
system Ward
message Parcel {{ int n }}
aip hand_over {{
  participant giver {{ process = Hold . LetGo }}
  participant taker{most} {{ process = Grasp }}
  control giver {{
    enter Hold  : / send request Parcel {{ n = 1 }} to taker
    enter LetGo : agree Parcel from taker
  }}
  control taker {{ enter Grasp : request Parcel from giver / send agree Parcel {{ n = 1 }} to giver }}
}}
aip delivery {{
  participant porter {{ plays hand_over.giver  process = Drive . giver . Rest }}
  participant desk {{ process = Wait }}
}}
"""


def test_a_protocol_that_is_alone_has_no_partners_of_another(prove) -> None:  # type: ignore[no-untyped-def]
    first, second = prove(NESTED.format(most=""), "dead states", "--json").json["results"]
    assert (first["of"], first["verdict"]) == ("protocol hand_over", "PROVED")
    assert (second["of"], second["verdict"]) == ("protocol delivery", "UNDECIDED")
    assert second["reason"].endswith("; no agent plays taker of hand_over where the protocol is alone")
    _, waits = prove(NESTED.format(most=""), "deadlock", "--json").json["results"]
    assert (waits["of"], waits["verdict"]) == ("protocol delivery", "UNDECIDED")
    assert waits["reason"].endswith("; no agent plays taker of hand_over where the protocol is alone")


def test_partners_that_nobody_has_to_play_are_not_missed_and_those_of_a_team_are(prove) -> None:  # type: ignore[no-untyped-def]
    team = "srm porter { liveness { porter = giver } plays hand_over.giver }\nteam T { one : porter }\n"
    for text, of in (
        (NESTED.format(most=" [0..*]"), "protocol delivery"),
        (NESTED.format(most="") + team, "team"),
    ):
        results = prove(text, "dead states", "--json").json["results"]
        assert {item["of"]: item["verdict"] for item in results}[of] == "REFUTED"


LENT = """\
system Lab
import resources
srm desk {{
  includes resource_keeper
  liveness {{ desk = service  places = keeper~ }}
}}
srm user {{
  plays resource.holder with whom = "{whom}", what = "a saw", urgency = 0, lease = 30s, patience = 1min,
      renewing = false, UseResource = work
  liveness {{ user = holder  work = Toss . (Saw | Rest) }}
  activities {{ Toss ends head, tail }}
  control work {{ enter Saw : [{saw}]  enter Rest : else }}
}}
team T {{ desk : desk  one : user }}
"""


@pytest.mark.parametrize(
    ("whom", "saw", "left"),
    [
        ("desk", "outcome(Toss) == head", ""),
        ("desk", "index == 2", "state Saw, `[index == 2]`"),
        ("nobody", "outcome(Toss) == head", "state ConsiderNeed, state KeepInLine"),
    ],
)
def test_lines_of_the_library_need_not_be_taken_in_each_team(prove, whom: str, saw: str, left: str) -> None:  # type: ignore[no-untyped-def]
    text = LENT.format(whom=whom, saw=saw)
    (found,) = prove(text, "dead states", "--json", "--states", "400").json["results"]
    assert (found["verdict"] == "PROVED") == (not left), found
    assert left in found["reason"].replace(" (it.aseme:12:28)", ""), found
