"""Agents that are gone in the middle of conversations: the others' conversations end, and say so."""

from __future__ import annotations

from collections import Counter

import pytest

from aseme_dsl.runtime.team.faults import Crash, Faults
from tests.runtime.playing import MS, SECOND, Played, play
from tests.support.generated import Generated, generate

TEXT = """
system Crowd
message Question {{ int n }}
aip ask {{
  participant asker {{
    sends    request Question
    receives inform Question
    process  = Ask . Wait . (Compare | Mourn | GiveUp)
  }}
  participant helper [1..*] {{
    sends    inform Question
    receives request Question
    process  = Think . Tell
  }}
  control asker {{
    enter Ask     : / send request Question to helper
    enter Compare : inform Question from helper
    enter Mourn   : lost helper
    enter GiveUp  : after(5s)
  }}
  control helper {{
    enter Think : request Question from asker
    leave Tell  : / send inform Question to asker
  }}
}}
srm boss {{
  plays ask.asker
  liveness {{ boss = asker~ }}
  activities {{ Ask takes 1ms  Wait takes 1ms  Compare takes 100ms  Mourn takes 100ms  GiveUp takes 100ms }}
}}
srm worker {{
  plays ask.helper
  liveness {{ worker = helper~ || helper~ || helper~ }}
  activities {{ Think takes {think}  Tell takes 1ms }}
}}
team T {{ {team} }}
"""


def crowd(think: str = "1s", team: str = "ann, ben : boss  tim : worker", mourn: bool = True) -> Generated:
    text = TEXT.format(think=think, team=team)
    if not mourn:
        text = text.replace(" | Mourn", "").replace("    enter Mourn   : lost helper\n", "")
        text = text.replace("Mourn takes 100ms  ", "")
    return generate(text)


def ends(run: Played, agent: str) -> list[str]:
    """How the rounds of an asker ended: `1002 Compare`."""
    found = []
    for record in run.of("activity", agent=agent, what="start"):
        if record["activity"] in ("Compare", "Mourn", "GiveUp"):
            found.append(f"{record['time'] // MS} {record['activity']}")
    return found


def test_an_agent_is_killed_in_mid_conversation() -> None:
    """Who waits to hear of it does. While it is gone nobody is asked; when it is back it is."""
    faults = Faults(crashes=(Crash("tim", 1500 * MS, 700 * MS),))
    run = play(crowd(), until=8 * SECOND, faults=faults)
    assert not run.result.failed
    for agent in ("ann", "ben"):
        assert ends(run, agent) == ["1001 Compare", "1500 Mourn", "6602 GiveUp", "7703 Compare"]
    gone = run.of("conversation", what="gone")
    assert {(r["agent"], r["peer"], r["played"]) for r in gone} == {
        ("ann", "tim", "helper"),
        ("ben", "tim", "helper"),
    }


def test_who_does_not_wait_to_hear_of_it_gives_up_in_time() -> None:
    faults = Faults(crashes=(Crash("tim", 500 * MS, 60 * SECOND),))
    run = play(crowd(mourn=False), until=6 * SECOND, faults=faults)
    assert ends(run, "ann")[:1] == ends(run, "ben")[:1] == ["5002 GiveUp"]
    told = [r["reason"] for r in run.of("fault") if "code" not in r]
    assert "request Question is not sent: ask takes one helper, and there is none" in told


@pytest.mark.parametrize("seed", range(2))
def test_of_a_crowd_some_die_and_the_others_talk_on(seed: int) -> None:
    bosses = ", ".join(f"b{n}" for n in range(8))
    workers = [f"w{n}" for n in range(6)]
    crashes = tuple(
        Crash(name, (300 + 170 * number + 37 * seed) * MS, 60 * SECOND)
        for number, name in enumerate(workers[::2])
    )
    generated = crowd("10ms", f"{bosses} : boss  {', '.join(workers)} : worker")
    run = play(generated, until=3 * SECOND, faults=Faults(crashes=crashes), seed=seed)
    assert not run.result.failed
    for number in range(8):
        kinds = Counter(line.split()[1] for line in ends(run, f"b{number}"))
        assert kinds["Compare"] >= 5 and kinds["Mourn"] <= 3, kinds
    team = run.team.conversations
    opened = Counter(r["what"] for r in run.of("conversation"))
    assert opened["join"] > 100
    assert team._members.conversations == {}
    for name in workers[::2]:
        assert not [
            r
            for r in run.of("agent_message", agent=name)
            if r["time"] > max(crash.at for crash in crashes if crash.agent == name)
        ]
