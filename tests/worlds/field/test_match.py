"""A match is the same to the bit for one seed, and it can be won through the port alone."""

from __future__ import annotations

import os
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from collections.abc import Callable
from itertools import pairwise
from pathlib import Path

import pytest

from aseme_dsl.worlds.field.event import EventKind, clock
from aseme_dsl.worlds.field.geometry import Point, Pose
from aseme_dsl.worlds.field.match import NOBODY, STEP_NS, VISITORS, Match
from aseme_dsl.worlds.field.referee import Rules
from aseme_dsl.worlds.field.render import progress, svg
from aseme_dsl.worlds.field.team import team_sheet
from tests.worlds.field.players import play

SECOND = 1_000_000_000
ONE_HALF = Rules(half_ns=120 * SECOND, halves=1)
SHORT = Rules(half_ns=50 * SECOND, halves=1)


def log(match: Match) -> str:
    return "".join(f"{event} at {event.x!r} {event.y!r}\n" for event in match.events)


def played(seed: int, rules: Rules = SHORT) -> Match:
    return play(Match(seed, rules=rules), rules.match_ns)


def test_one_seed_gives_one_match() -> None:
    one, other = played(4), played(4)
    assert log(one) == log(other)
    assert svg(one) == svg(other)
    assert one.truth() == other.truth()
    assert one.trail == other.trail
    assert one.radio == other.radio


def test_different_seeds_give_different_matches() -> None:
    logs = {log(played(seed, Rules(half_ns=15 * SECOND, halves=1))) for seed in range(5)}
    assert len(logs) == 5


def test_it_does_not_matter_in_how_many_calls_time_passes() -> None:
    at_once, bit_by_bit = Match(8), Match(8)
    at_once.advance(40 * SECOND)
    now_ns = 0
    while now_ns < 40 * SECOND:
        now_ns = min(40 * SECOND, now_ns + 7_777_777)
        bit_by_bit.advance(now_ns)
    assert log(at_once) == log(bit_by_bit)
    assert at_once.truth() == bit_by_bit.truth()
    assert [b.sense() for b in at_once.bodies.values()] == [b.sense() for b in bit_by_bit.bodies.values()]


def test_another_process_plays_the_same_match(snapshot: Callable[[str, str], None]) -> None:
    """Also the matches of other machines: the snapshot has every event with its place to the last bit."""
    program = (
        "import sys\n"
        "from tests.worlds.field.test_match import log, played\n"
        "sys.stdout.buffer.write(log(played(5)).encode())"
    )
    texts = []
    for hash_seed in ("1", "2"):
        environment = {**os.environ, "PYTHONHASHSEED": hash_seed}
        root = Path(__file__).parents[3]
        run = subprocess.run(
            [sys.executable, "-c", program], cwd=root, env=environment, capture_output=True, check=True
        )
        texts.append(run.stdout.decode())
    assert texts[0] == texts[1]
    snapshot(texts[0], "match.txt")


def test_a_team_written_by_hand_scores_for_most_seeds() -> None:
    """The proof that the field can be played through the port alone."""
    scored = 0
    goals = conceded = 0
    for seed in range(1, 7):
        own, other = played(seed, ONE_HALF).result().score
        scored += own > 0
        goals += own
        conceded += other
    assert scored >= 4
    assert goals > 2 * conceded


def test_the_scripted_team_plays_football_too() -> None:
    """Against nobody it scores; against itself it neither stops nor breaks a rule all the time."""
    home = team_sheet(1, "Idle", ())
    match = Match(1, home, VISITORS, ONE_HALF)
    match.advance(ONE_HALF.match_ns)
    assert match.result().score[1] >= 1
    twin = team_sheet(1, "Locals", ("l1", "l2", "l3"), goalie="lk", scripted=True)
    match = Match(1, twin, VISITORS, ONE_HALF)
    match.advance(ONE_HALF.match_ns)
    assert match.bodies == {}
    kinds = [event.kind for event in match.events]
    assert kinds.count(EventKind.KICK) > 8
    assert kinds.count(EventKind.PENALTY) < 6


def test_there_may_be_nobody_to_play_against() -> None:
    match = play(Match(2, away=NOBODY, rules=SHORT), SHORT.match_ns)
    assert match.result().score[0] >= 1
    assert match.result().score[1] == 0


# ---- pictures -------------------------------------------------------------------------------------------


def test_the_picture_is_a_drawing_of_the_match(snapshot: Callable[[str, str], None]) -> None:
    match = played(5)
    picture = svg(match)
    snapshot(picture, "match.svg")
    root = ElementTree.fromstring(picture)
    texts = [element.text or "" for element in root.iter("{http://www.w3.org/2000/svg}text")]
    goals = match.result().goals
    assert goals
    for goal in goals:
        assert any(clock(goal.time_ns) in text and goal.robot in text for text in texts)
    names = [element.text for element in root.iter("{http://www.w3.org/2000/svg}title")]
    assert set(names) >= {robot.name for robot in match.truth().robots}
    assert "nan" not in picture
    assert "-0.0" not in picture


def test_a_picture_can_be_drawn_before_anything_happened() -> None:
    picture = svg(Match())
    assert "no goals" in picture
    ElementTree.fromstring(picture)


def test_names_do_not_break_the_picture() -> None:
    match = Match(1, team_sheet(1, 'A<b> & "c"', ["<r&1>"]), NOBODY)
    root = ElementTree.fromstring(svg(match))
    assert any(element.text == "<r&1>" for element in root.iter())


def test_progress_is_one_line_that_says_where_the_ball_is() -> None:
    match = Match(1, team_sheet(1, "Home", ["r"]), NOBODY, Rules(initial_ns=0, ready_ns=0, set_ns=0))
    match.advance(10 * STEP_NS)
    assert progress(match) == "0:00.1  Home 0:0 Nobody  PLAYING   [············o············]"
    match.put_ball(Point(-449, 0))
    assert progress(match).endswith("[o···········|············]")
    match.put_ball(Point(449, 0))
    assert progress(match).endswith("[············|···········o]")


def test_the_trail_follows_the_ball_and_knows_where_it_was_carried() -> None:
    match = Match(1, team_sheet(1, "Home", ["r"]), NOBODY, Rules(initial_ns=0, ready_ns=0, set_ns=0))
    match.put_robot("r", Pose(-400, 250))
    match.advance(10 * STEP_NS)
    match.put_ball(Point(0, 200), 0, 150)
    match.advance(3 * SECOND)
    trail = match.trail
    assert [point.time_ns for point in trail] == sorted(point.time_ns for point in trail)
    for one, other in pairwise(trail):
        if one.rolling:
            assert abs(other.x - one.x) + abs(other.y - one.y) < 30
    assert max(point.y for point in trail) > 300
    assert trail[-1].y == 300


def test_setting_somebody_down_needs_a_name_that_plays() -> None:
    with pytest.raises(KeyError, match="zidane"):
        Match().put_robot("zidane", Pose(0, 0))
