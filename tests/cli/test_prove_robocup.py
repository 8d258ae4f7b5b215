"""The claim of `examples/robocup`: two robots never both believe to be the center."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from tests.cli.support import Here

ACCEPTANCE = Path(__file__).parents[1] / "acceptance" / "kouretes.aseme"
COACH = """
srm coach {
  liveness { coach = AssignRoles~ }
  activities { AssignRoles takes 1s writes team.state.Assignment }
}
"""
"""One agent says who is what."""
EXAMPLE = Path(__file__).parents[2] / "examples" / "robocup" / "kouretes.aseme"

LEASE = "age(team.state.Assignment) < 1200ms"
LEAVES = "    leave center          : when [!is_center]\n"
IS_CENTER = "assigned && team.state.Assignment.center == my.state.Identity.number"
FIVE = "robot1, robot2, robot3, robot4, robot5"
NUMBER_3 = "assume robot3 has [my.state.Identity.number == 3]"


def asked(here: Here, folder: Path, *changes: str) -> str:
    """The line about the claim, in a changed file and for up to five players."""
    text = EXAMPLE.read_text("utf-8")
    for old, new in zip(changes[::2], changes[1::2], strict=True):
        assert old in text
        text = text.replace(old, new, 1)
    (folder / "kouretes.aseme").write_text(text)
    done = here("prove", "kouretes.aseme", "one center", "--budget", "600ms", "--robots", "5")
    assert "one center of team" in done.out, done.out + done.err
    return done.out.splitlines()[0]


@pytest.mark.parametrize("players", [2, 4])
def test_two_centers_of_the_acceptance_file(here: Here, folder: Path, players: int) -> None:
    """Who hears of an assignment, in which order and when, is open: so two robots may follow two of them."""
    text = ACCEPTANCE.read_text("utf-8").partition("// ---- deployment")[0]
    robots = [f"robot{number}" for number in range(1, players + 1)]
    numbers = "".join(
        f"  assume robot{number} has [my.state.Identity.number == {number}]\n"
        for number in range(1, players + 1)
    )
    (folder / "kouretes.aseme").write_text(
        f"{text}{COACH}\nteam Kouretes {{ {', '.join(robots)} : player  bench : coach }}\n"
        f'property "one center" {{\n{numbers}  at most one center\n}}\n'
    )
    done = here("prove", "kouretes.aseme", "one center", "--robots", str(players), "--budget", "30s")
    assert done.out.startswith("REFUTED   one center of team"), done.out + done.err
    assert f"{players} player, 1 coach" in done.out
    assert int(done.out.split(" states]")[0].split()[-1]) < 400


def test_five_robots_never_both_believe_to_be_the_center(here: Here, folder: Path) -> None:
    more = " ".join(f"assume robot{n} has [my.state.Identity.number == {n}]" for n in (4, 5))
    line = asked(here, folder, "robot1, robot2, robot3 :", f"{FIVE} :", NUMBER_3, f"{NUMBER_3} {more}")
    assert line.startswith("PROVED"), line
    assert "5 player, 1 goalie; delay 0 s to 0.3 s; all times" in line
    assert "any crashes and restarts" in line


FAULTS: list[tuple[str, ...]] = [
    (LEASE, "age(team.state.Assignment) < 1201ms"),
    (LEASE, "age(team.state.Assignment) > 1200ms"),
    (LEAVES, ""),
    (IS_CENTER, "assigned || team.state.Assignment.center == my.state.Identity.number"),
    ("within 1400ms", "within 1399ms"),
    ("delay 0ms..300ms", "delay 0ms..301ms"),
    (NUMBER_3, "assume robot3 has [my.state.Identity.number == 2]"),
    ("[my.state.Identity.number == 1]", "[my.state.Identity.number > 0]"),
    ("leds         takes 5ms", "leds         takes 5ms writes team.state.Assignment"),
]


@pytest.mark.parametrize("changes", FAULTS if "CERTIFICATES" in os.environ else FAULTS[::3])
def test_planted_faults_are_never_proved(here: Here, folder: Path, changes: tuple[str, ...]) -> None:
    line = asked(here, folder, *changes)
    assert not line.startswith("PROVED"), line


def test_what_only_activities_read_makes_no_states(here: Here, folder: Path) -> None:
    """Nothing in the file asks for it, so it makes no difference whether it has come."""
    channels = "".join(f"message M{n} {{ int x }}\ntopic t{n} {{ state M{n} }}\n" for n in range(8))
    names = ", ".join(f"t{n}.state.M{n}" for n in range(8))
    (folder / "many.aseme").write_text(
        f"system Many\n{channels}"
        "srm robot {\n  liveness { robot = (Look . Act)~ }\n"
        f"  activities {{ Look takes 1s reads {names}  Act takes 1s writes {names} }}\n}}\n"
    )
    done = here("prove", "many.aseme", "failures")
    assert done.out.startswith("PROVED    failures of team"), done.out + done.err
    assert int(done.out.split(" states]")[0].split()[-1]) < 8
