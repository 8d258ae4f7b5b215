"""`asemec match`: two teams in one world, apart from each other, and a count of the points."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.cli.support import asemec
from tests.support.traces import texts_of

TEAM = """\
system Team
message Hint { int number }
topic mates radio 8 { signal Hint queued }
topic said { state Hint }
srm player {
  liveness { player = Play~ }
  activities { Play as thread reads mates.signal.Hint writes mates.signal.Hint, said.state.Hint }
}
team Team { one, two : player }
"""

PLAY = """\
from monas.Team.messages import Hint
from tactics import OWN

class Play:
    def execute(self, context):
        context.body.act(OWN)
        context.publish("mates.signal.Hint", Hint(OWN))
        context.wait(0.05)
        heard = context.read("mates.signal.Hint", Hint)
        if heard is not None and heard.number != OWN:
            context.body.act(1000)
"""

WORLD = """\
import random
from aseme_dsl.runtime.world.body import RadioMessage

class Body:
    def __init__(self, world, seat):
        self.world, self.name, self.payload_limit, self.inbox = world, seat, 8, []
    def sense(self):
        return self.world.now_ns
    def act(self, command):
        if not isinstance(command, int):
            raise TypeError("this is no command")
        self.world.acts.append((self.name, command))
    def say(self, payload):
        for seat, body in self.world.bodies.items():  # one medium: the other team is heard, too
            if body is not self:
                body.inbox.append(RadioMessage(self.name, payload))
        return True
    def hear(self):
        heard, self.inbox = self.inbox, []
        return heard

class World:
    step_ns = 10_000_000
    def __init__(self, seed, home, away):
        self.now_ns, self.acts, self.chance = 0, [], random.Random(seed)
        self.bodies = {f"{side}.{name}": Body(self, f"{side}.{name}")
                       for side, lineup in (("home", home), ("away", away)) for name in lineup.roles}
        self.points = [0, 0]
    @property
    def over(self):
        return self.now_ns >= 500_000_000
    @property
    def score(self):
        return tuple(self.points)
    @property
    def story(self):
        return [" ".join(f"{seat}={command}" for seat, command in self.acts[:6])]
    def advance(self, until):
        while self.now_ns + self.step_ns <= until:
            self.now_ns += self.step_ns
            for seat, command in self.acts[-4:]:
                self.points[seat.startswith("away")] += command * self.chance.randint(0, 3)

def make(seed, home, away):
    return World(seed, home, away)
"""


@pytest.fixture
def teams(tmp_path: Path) -> Path:
    """Two teams in which everything is called the same, and a world with one medium for both."""
    for name, own in (("alice", 1), ("bob", 2)):
        folder = tmp_path / name
        (folder / "activities").mkdir(parents=True)
        (folder / "team.aseme").write_text(TEAM, "utf-8")
        (folder / "activities" / "play.py").write_text(PLAY, "utf-8")
        (folder / "tactics.py").write_text(f"OWN = {own}\n", "utf-8")
        (folder / "pyproject.toml").write_text(
            '[tool.asemec]\nfiles = ["team.aseme"]\nactivities = "activities"\n', "utf-8"
        )
    (tmp_path / "arena.py").write_text(WORLD, "utf-8")
    return tmp_path


def test_two_teams_of_equal_names_play_apart(teams: Path) -> None:
    match = ("match", "alice", "bob", "--world", "arena:make", "--seeds", "3", "--json")
    first = asemec(*match, "-j", "1", cwd=teams)
    assert first.code == 0, first.err
    result = first.json["result"]
    assert [item["seed"] for item in result["matches"]] == [1, 2, 3]
    for item in result["matches"]:
        # Each has its own module `tactics`, and heard its own mate alone: nobody has acted with 1000.
        assert item["story"] == ["home.one=1 home.two=1 away.one=2 away.two=2 home.one=1 home.two=1"]
        assert max(item["score"]) < 1000 and item["over"]
        assert item["home"]["faults"] == item["away"]["faults"] == []
    assert result["wins"] + result["draws"] + result["losses"] == 3
    table = asemec(*match[:-1], "-j", "2", cwd=teams).out.splitlines()
    assert table[0].split() == ["seed", "Team", "(home)", "Team", "(away)"]
    scores = [[str(item["seed"]), *map(str, item["score"])] for item in result["matches"]]
    assert [line.split() for line in table[1:4]] == scores
    assert table[4].split()[0] == "sum" and table[5].startswith("Team (home) wins ")


@pytest.mark.parametrize(
    ("line", "broken", "failure"),
    [
        ("import os; os._exit(3)", "its process has ended with code 3", ""),
        ("context.body.act(object)", None, "command"),
    ],
)
def test_a_team_that_fails_does_not_stop_the_other(
    teams: Path, line: str, broken: str | None, failure: str
) -> None:
    play = PLAY.replace("        context.wait(0.05)\n", f"        {line}\n")
    (teams / "bob" / "activities" / "play.py").write_text(play, "utf-8")
    done = asemec("match", "alice", "bob", "--world", "arena:make", "--json", cwd=teams)
    assert done.code == 1
    (played,) = json.loads(done.out)["result"]["matches"]
    assert played["over"] and played["score"][0] > 0
    assert played["home"]["failures"] == [] and played["home"]["broken"] is None
    assert played["away"]["broken"] == broken
    assert failure in " ".join(played["away"]["failures"])
    assert bool(failure) == bool(played["away"]["failures"])


def test_the_football_field_is_ready(teams: Path) -> None:
    team = "system S\nsrm goalie { liveness { goalie = Stand~ }  activities { Stand takes 1s simulated } }\n"
    for name in ("carol", "dan"):
        (teams / f"{name}.aseme").write_text(
            team.replace("system S", f"system {name}") + "team S { keeper : goalie }\n", "utf-8"
        )
    done = asemec("match", "carol.aseme", "dan.aseme", "--for", "2s", "-o", "pictures", cwd=teams)
    assert done.code == 0, done.err
    assert done.out == "  seed  carol   dan\n     1      0     0  (after 2 s)\n"
    assert "carol 0:0 dan" in (teams / "pictures" / "match-1.svg").read_text("utf-8")
    for side, name in (("home", "carol"), ("away", "dan")):
        shown = asemec(
            "trace", f"pictures/match-1.{side}.jsonl.gz", "--lines", "--kind", "activity", cwd=teams
        )
        assert shown.code == 0 and "keeper" in shown.out and "start Stand" in shown.out
        assert f'"system":"{name}"' in texts_of(teams / "pictures" / f"match-1.{side}.jsonl.gz")[0]


def test_what_cannot_be_played_is_said(teams: Path) -> None:
    (teams / "alone.aseme").write_text(TEAM[: TEAM.index("team Team")], "utf-8")
    alone = asemec("match", "alice", "alone.aseme", cwd=teams)
    assert (alone.code, alone.out) == (1, "")
    assert "Team declares no team, so it cannot play" in alone.err
    (teams / "arena.py").write_text(WORLD.replace("def score", "def goals"), "utf-8")
    no_score = asemec("match", "alice", "bob", "--world", "arena:make", cwd=teams)
    assert no_score.code == 1
    assert "arena:make gave a world whose `score` is not two numbers" in no_score.err
