"""One agent among others that may publish anything does all that it does in a team, and waits where it does.

A few random teams are compared with a search of the team in every run of the tests; many with
`PUBLISHING_OTHERS=200`.
"""

from __future__ import annotations

import os
import random
from collections.abc import Iterable, Sequence
from itertools import pairwise
from pathlib import Path

from aseme_dsl.project.building.project import compile_root
from aseme_dsl.proofs.explore.deciding.order import Unanswerable
from aseme_dsl.proofs.explore.explored import Assumed, Explored
from aseme_dsl.proofs.explore.questions import stuck_alone
from aseme_dsl.proofs.explore.search import Eyes, Graph, Limits, search
from aseme_dsl.runtime.version.loading import Loaded
from aseme_dsl.source import Source
from tests.proofs.test_absence import loaded_of
from tests.proofs.test_reductions import _stuck

TEAMS = int(os.environ.get("PUBLISHING_OTHERS", "2"))
FIRST = int(os.environ.get("PUBLISHING_FIRST", "1"))
MOST = 3000
TEAM = """\
system Team
message Ping { int n  bool on }
message Ball { int n }
topic t { state Ping  signal Ping  data Ping }
topic eye { state Ball }
srm giver {
  liveness { giver = GIVES }
  activities { G0 GWRITES }
  control giver {
GLINES  }
}
srm robot {
  var kept : int = 0
  liveness {
    robot = one || two
    one = ONE
    two = TWO
  }
  activities { A0 AWRITES  B0 BWRITES }
  control one {
ALINES  }
  control two {
BLINES  }
}
"""
ASKED = (
    *("t.state.Ping.n > 1", "t.state.Ping.n == 2", "t.state.Ping.on", "!t.state.Ping.on", "kept > 1"),
    *("age(t.state.Ping) < 1s", "age(t.state.Ping) > 2s", "has(t.state.Ping)", "!has(t.state.Ping)"),
    *("t.signal.Ping.n > 1", "t.signal.Ping.on", "t.data.Ping.n == 1", "eye.state.Ball.n > 3", "kept == 2"),
)
KINDS = "state", "signal", "data"


def team_of(seed: int) -> str:
    """A giver that publishes, and a robot in two regions that asks for it."""
    chance = random.Random(seed)

    def act(given: Iterable[str]) -> str:
        found = [item for item in given if chance.random() < 0.4]
        return f" / {'; '.join(found)}" if found else ""

    def publishes(kind: str) -> str:
        return f"t.{kind}.Ping.n = {chance.choice((0, 1, 2))}; write_messages.t.{kind}.Ping"

    def lines(names: list[str], given: Iterable[str], asked: tuple[str, ...]) -> str:
        found = []
        for _, name in pairwise(names):
            ways = ("when [{}]", "when [{}]", "[{}]", "", "after(1s)") if asked else ("", "after(1s)")
            way = chance.choice(ways)
            condition = chance.choice(asked) if asked else "true"
            if asked and chance.random() < 0.4:
                condition += chance.choice((" && ", " || ")) + chance.choice(asked)
            found.append(f"    enter {name} : {way.format(condition)}{act(given)}\n")
        return "".join(found)

    def chain(letter: str, most: int) -> tuple[list[str], str]:
        names = [f"{letter}{number}" for number in range(chance.choice((2, most)))]
        whole = " . ".join(names)
        return names, f"({whole})~" if chance.random() < 0.5 else whole

    gives, giver = chain("G", 3)
    ones, one = chain("A", 3)
    twos, two = chain("B", 2)
    writes = chance.sample(KINDS, 2)
    text = TEAM.replace("GIVES", giver).replace("ONE", one).replace("TWO", two)
    text = text.replace("GLINES", lines(gives, [publishes(kind) for kind in writes], ()))
    text = text.replace("ALINES", lines(ones, ["kept = t.state.Ping.n", "kept = kept + 1"], ASKED))
    text = text.replace("BLINES", lines(twos, ["kept = 2"], ASKED))
    own = chance.choice(("", "writes t.state.Ping", "writes eye.state.Ball"))
    text = text.replace("GWRITES", chance.choice(("", "writes t.state.Ping", "writes t.data.Ping")))
    return text.replace("AWRITES", own).replace("BWRITES", chance.choice(("", "writes t.signal.Ping")))


def team_explored(loaded: Loaded) -> tuple[Graph, frozenset[tuple[str, str]]] | None:
    eyes = Eyes()
    team = Explored(loaded, [("giver", "giver"), ("robot", "robot")], Assumed(), [eyes])
    graph = search(team, eyes, None, Limits(MOST, 20.0))
    return None if graph.cut is not None else (graph, frozenset(_stuck(team, graph)))


def alone(
    loaded: Loaded, numbers: Sequence[float] | None
) -> tuple[set[str], set[int], bool, int, int] | None:
    """What the robot does among others: states, lines, whether it may wait; states and groups."""
    visited, taken, waits, states = set[str](), set[int](), False, 0
    number, groups = 0, 1
    while number < groups:
        eyes = Eyes()
        names = [("giver", "giver"), ("robot", "robot")]
        robot = Explored(
            loaded, names, Assumed(), [eyes], numbers=numbers, others=frozenset(("giver",)), group=number
        )
        assert not robot.left_out
        robot.judged.clear()
        graph = search(robot, eyes, None, Limits(MOST, 20.0))
        if graph.cut is not None:
            return None
        visited |= graph.visited["robot"]
        taken |= graph.taken.get("robot", set())
        waits = waits or stuck_alone(robot, graph)
        states += len(graph.parents)
        number, groups = number + 1, max(1, len(robot.apart))
    return visited, taken, waits, states, groups


def compare(seed: int, folder: Path) -> str:
    """What was compared; empty if nothing was."""
    text = team_of(seed)
    if compile_root(Source("team.aseme", text)).system is None:
        return ""
    loaded = loaded_of(Source("team.aseme", text), folder)
    team = team_explored(loaded)
    if team is None:
        return ""
    graph, stuck = team
    told = [f"{len(graph.parents)} {sorted(stuck)}"]
    for numbers in ((), None):
        try:
            found = alone(loaded, numbers)
        except Unanswerable:
            continue
        if found is None:
            return ""
        visited, taken, waits, states, groups = found
        assert graph.visited["robot"] <= visited, (seed, text)
        assert graph.taken.get("robot", set()) <= taken, (seed, text)
        if any(agent == "robot" for agent, _ in stuck):
            assert waits, (seed, stuck, text)
        told.append(f"{states} in {groups}{' waits' if waits else ''}")
    return ", ".join(told)


def test_a_robot_does_all_that_it_does_in_a_team(tmp_path: Path) -> None:
    compared = 0
    for seed in range(FIRST, FIRST + 4 * TEAMS):
        found = compare(seed, tmp_path / str(seed))
        compared += bool(found)
        if "PUBLISHING_OTHERS" in os.environ:
            print(seed, found, flush=True)
        if compared == TEAMS:
            break
    assert compared
