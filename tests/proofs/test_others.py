"""One agent among others that may do anything does all that it does in a team; so what it never does, no team
of it does.

A few random conversations are compared with a search of the team in every run of the tests; many with
`AMONG_OTHERS=200`.
"""

from __future__ import annotations

import os

import pytest

from aseme_dsl.proofs.explore.deciding import others
from aseme_dsl.proofs.explore.explored import Assumed, Explored
from aseme_dsl.proofs.explore.questions import stuck_alone
from aseme_dsl.proofs.explore.search import Eyes, Graph, Limits, search
from tests.proofs.test_reductions import ENDS, _loaded, random_texts, said_of

TALKS = int(os.environ.get("AMONG_OTHERS", "3"))
FIRST = int(os.environ.get("AMONG_FIRST", "1"))
MOST = 3000


PAUSE = """\
system Talks
message Word { int n }
aip talk {
  participant asking {
    var heard : int = 0
    process = Ask . Wait . [Both]
  }
  participant asked {
    process = Look . Tell
  }
  control asking {
    enter Wait   : / send request Word { n = 1 } to asked
    on    Wait   : inform Word from asked / heard = heard + 1
    on    Wait   : agree Word from asked / heard = heard + 1
    enter [Both] : when [heard > 0]
    enter Both   : [heard > 1]
    skip  Both   : else
  }
  control asked {
    enter Look : request Word from asking
    enter Tell : / send inform Word { n = 1 } to asking; send agree Word { n = 1 } to asking
  }
}
"""
"""Two messages are taken in one step, or only one."""
GROUP = """\
system Talks
message Word { int n }
aip talk {
  participant asking {
    var left : bool = false
    process = Ask . Wait . [Work] . Learn
  }
  participant asked [1..*] {
    var able : bool = false
    process = Look . [Work]
  }
  control asking {
    enter Wait   : / send request Word { n = 1 } to asked
    on    Wait   : agree Word from asked
    on    Wait   : refuse Word from asked
    on    Wait   : lost asked / left = true
    enter [Work] : when [all_answered(asked)]
    enter Work   : [!left]
    skip  Work   : else
  }
  control asked {
    enter Look : request Word from asking
    enter Work : [able] / send agree Word { n = 1 } to asking
    skip  Work : else / send refuse Word { n = 1 } to asking
  }
}
"""
"""One waits until all of several have answered."""


def alone(text: str, robots: int = 1) -> dict[str, tuple[Graph, bool]]:
    """What each agent of the only protocol in a file does among others, and whether it may wait for ever."""
    loaded, scope = _loaded(text, robots)
    found = {}
    for role, name in {role: name for name, role in reversed(scope.team)}.items():
        eyes = Eyes()
        beside = frozenset(other for other, _ in scope.team if other != name)
        explored = Explored(loaded, scope.team, Assumed(), [eyes], others=beside)
        explored.judged.clear()
        graph = search(explored, eyes, None, Limits(MOST, 1e9))
        assert explored.others is not None
        if graph.cut is None and not explored.others.is_bounded:
            found[role] = graph, stuck_alone(explored, graph)
    return found


def compare(text: str, crashes: bool, robots: int = 1) -> str:
    """What was compared with a search of the team: its states, those of each agent; empty if nothing was."""
    team = said_of(text, crashes, robots)
    if team is None:
        return ""
    told = []
    found = alone(text, robots)
    for role, (graph, may_wait) in found.items():
        name = role.rpartition("_")[2]
        assert team.visited[role] <= graph.visited[role], (role, text)
        assert team.taken.get(role, frozenset()) <= graph.taken.get(role, set()), (role, text)
        kinds = {item.kind for item in graph.sightings}
        told.append(f"{name} {len(graph.parents)}{' waits' if may_wait else ''} {sorted(kinds)}")
        if any(agent.rstrip("0123456789") == name for agent, _ in team.stuck):
            assert may_wait, (role, text)
    if "failure" in team.seen and len(found) == len(team.visited):
        kinds = {item.kind for graph, _ in found.values() for item in graph.sightings}
        assert "failure" in kinds, text
    return f"{team.states}: {', '.join(told)}; {sorted(team.stuck)} {sorted(team.seen)}"


@pytest.mark.parametrize("name", ENDS)
def test_an_agent_does_all_that_it_does_in_a_team(name: str) -> None:
    assert compare(ENDS[name], crashes=False)


def test_an_agent_of_several_does_all_that_it_does_in_a_team() -> None:
    assert compare(GROUP, crashes=True, robots=2)


def test_agents_of_random_conversations_do_all_that_they_do_in_a_team() -> None:
    compared = 0
    for number, text in enumerate(random_texts(FIRST, TALKS)):
        found = compare(text, crashes=number % 4 > 1)
        compared += bool(found)
        if "AMONG_OTHERS" in os.environ:
            print(FIRST + number, found, flush=True)
    assert compared


def test_what_others_say_in_the_midst_of_a_step_is_looked_at(monkeypatch: pytest.MonkeyPatch) -> None:
    """Without that, one that has just entered a state does not hear what comes before it goes on."""
    found = alone(PAUSE)["proved_talk_asking"][0]
    monkeypatch.setattr(others.Others, "_may_pause", lambda self, taken: None)
    fewer = alone(PAUSE)["proved_talk_asking"][0]
    assert fewer.taken["proved_talk_asking"] < found.taken["proved_talk_asking"]
