"""The field keeps the promises of the port through which every body is reached."""

from __future__ import annotations

import ast
import sys
import threading
from pathlib import Path

import pytest

import aseme_dsl.worlds.field
from aseme_dsl.runtime.world.body import Body, RadioMessage, World
from aseme_dsl.worlds.field.command import Command, Dive, Kick, Sit, Stand, Walk
from aseme_dsl.worlds.field.match import STEP_NS, Match
from aseme_dsl.worlds.field.percept import Percept, PlayerState
from aseme_dsl.worlds.field.radio import RadioSettings
from aseme_dsl.worlds.field.team import Player, TeamSheet, team_sheet

SECOND = 1_000_000_000


def body_of(match: Match, name: str) -> Body[Percept, Command]:
    # The annotation is half the test: mypy compares FieldBody with the port.
    body: Body[Percept, Command] = match.bodies[name]
    return body


def test_a_match_is_a_world_of_bodies_by_name() -> None:
    match = Match(seed=3)
    world: World[Percept, Command] = match
    assert isinstance(world, World)
    assert list(world.bodies) == ["robot1", "robot2", "robot3", "keeper"]
    for name, body in world.bodies.items():
        assert isinstance(body, Body)
        assert body.name == name == body.sense().name
        assert body.payload_limit == 10


def test_time_passes_only_when_asked_and_in_whole_steps() -> None:
    match = Match()
    assert (match.now_ns, match.step_ns) == (0, STEP_NS)
    match.advance(STEP_NS - 1)
    assert match.now_ns == 0
    match.advance(3 * STEP_NS + 1)
    assert match.now_ns == 3 * STEP_NS
    match.advance(3 * STEP_NS)
    assert match.now_ns == 3 * STEP_NS
    with pytest.raises(ValueError, match="passed"):
        match.advance(2 * STEP_NS)


def test_sensing_changes_nothing() -> None:
    looked, blind = Match(seed=5), Match(seed=5)
    for step in range(1, 400):
        looked.advance(step * STEP_NS)
        blind.advance(step * STEP_NS)
        for body in looked.bodies.values():
            assert body.sense() == body.sense()
    assert looked.truth() == blind.truth()
    assert [b.sense() for b in looked.bodies.values()] == [b.sense() for b in blind.bodies.values()]


def test_a_command_stays_in_force_and_of_two_the_last_counts() -> None:
    match = Match()
    body = body_of(match, "robot2")
    body.act(Command(Walk(forward=-10)))
    body.act(Command(Walk(turn=-30)))
    match.advance(5 * SECOND)
    assert body.sense().walk == Walk(turn=-30)
    body.act(Command(Walk()))
    match.advance(6 * SECOND)
    assert body.sense().walk == Walk()


def test_head_and_motion_are_commanded_one_by_one() -> None:
    match = Match()
    body = body_of(match, "robot1")
    body.act(Command(motion=Walk(turn=20)))
    body.act(Command(head=45))
    match.advance(3 * SECOND)
    assert body.sense().head == 45
    assert body.sense().walk == Walk(turn=20)


@pytest.mark.parametrize("number", [float("nan"), float("inf"), float("-inf")])
def test_a_command_that_means_nothing_is_refused_where_it_is_made(number: float) -> None:
    for speeds in ((number, 0, 0), (0, number, 0), (0, 0, number)):
        with pytest.raises(ValueError, match="finite"):
            Walk(*speeds)
    with pytest.raises(ValueError, match="finite"):
        Kick(1, number)
    with pytest.raises(ValueError, match="strength"):
        Kick(number)
    with pytest.raises(ValueError, match="finite"):
        Command(head=number)


def test_only_a_command_is_obeyed() -> None:
    with pytest.raises(TypeError, match="Command"):
        Match().bodies["robot1"].act(Walk(1))  # type: ignore[arg-type]


def test_a_message_reaches_the_team_mates_and_nobody_else() -> None:
    match = Match(seed=2, radio=RadioSettings(loss=0.0), away=team_sheet(2, "Guests", ["g1", "g2"]))
    assert body_of(match, "robot1").say(b"0123456789") is True
    assert body_of(match, "robot2").hear() == []
    match.advance(SECOND)
    for name in ("robot2", "robot3", "keeper"):
        assert body_of(match, name).hear() == [RadioMessage("robot1", b"0123456789")]
        assert body_of(match, name).hear() == []
    for name in ("robot1", "g1", "g2"):
        assert body_of(match, name).hear() == []


def test_a_message_that_is_too_long_or_too_many_is_refused_aloud() -> None:
    match = Match()
    body = body_of(match, "keeper")
    with pytest.raises(ValueError, match="11 bytes"):
        body.say(b"01234567890")
    assert [body.say(b"x") for _ in range(7)] == [True] * 5 + [False] * 2
    match.advance(SECOND // 10)
    assert [body.say(b"x") for _ in range(2)] == [True, False]
    assert match.radio[0].refused == 3


def test_two_driven_teams_see_the_field_from_their_own_side() -> None:
    match = Match(home=team_sheet(5, "Reds", ["r"]), away=team_sheet(7, "Blues", ["b"]))
    assert list(match.bodies) == ["r", "b"]
    match.advance(11 * SECOND)
    for name, number in (("r", 5), ("b", 7)):
        percept = match.bodies[name].sense()
        assert percept.team == number
        assert percept.game.state is PlayerState.PLAYING
        # The whistle has gone: both stand in their own halves, which for each is where x is negative.
        assert percept.pose.x < 0
        assert abs(percept.pose.heading) < 15
    assert match.bodies["r"].sense().game.own_kick_off
    assert not match.bodies["b"].sense().game.own_kick_off


def test_a_team_sheet_that_cannot_be_told_apart_is_refused() -> None:
    with pytest.raises(ValueError, match="same name"):
        team_sheet(1, "Home", ["a", "a"])
    with pytest.raises(ValueError, match="jersey"):
        TeamSheet(1, "Home", (Player("a", 1), Player("b", 1)))
    with pytest.raises(ValueError, match="2 goalies"):
        TeamSheet(1, "Home", (Player("a", 1, goalie=True), Player("b", 2, goalie=True)))
    with pytest.raises(ValueError, match="more than 6"):
        team_sheet(1, "Home", list("abcdefg"))
    with pytest.raises(ValueError, match="same name"):
        Match(home=team_sheet(1, "Home", ["a"]), away=team_sheet(2, "Away", ["a"]))


def test_every_motion_is_taken_by_a_body() -> None:
    match = Match()
    for motion in (Walk(1, 2, 3), Kick(0.5, -10), Stand(), Sit(), Dive(left=True)):
        body_of(match, "robot1").act(Command(motion))
    match.advance(SECOND)


def test_the_field_needs_nothing_but_the_port_and_the_standard_library() -> None:
    port = ("aseme_dsl.runtime.world.body", "aseme_dsl.runtime.world.lineup")
    allowed = {*sys.stdlib_module_names, *port}
    folder = Path(aseme_dsl.worlds.field.__file__).parent
    for path in sorted(folder.glob("*.py")):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            names: list[str] = []
            if isinstance(node, ast.ImportFrom):
                assert node.level == 0 and node.module
                names = [node.module]
            elif isinstance(node, ast.Import):
                names = [alias.name for alias in node.names]
            for name in names:
                own = name == "aseme_dsl.worlds.field" or name.startswith("aseme_dsl.worlds.field.")
                assert own or name in allowed or name.split(".")[0] in allowed, f"{path.name} imports {name}"


def test_bodies_may_be_used_from_any_thread() -> None:
    match = Match(radio=RadioSettings(loss=0.0, interval_ns=0))
    heard: dict[str, int] = dict.fromkeys(match.bodies, 0)
    said = 200

    def live(body: Body[Percept, Command]) -> None:
        for number in range(said):
            assert body.say(bytes([number]))
            body.act(Command(Walk(turn=number), head=body.sense().head))
            heard[body.name] += len(body.hear())

    threads = [threading.Thread(target=live, args=(body,)) for body in match.bodies.values()]
    for thread in threads:
        thread.start()
    while any(thread.is_alive() for thread in threads):
        match.advance(match.now_ns + STEP_NS)
    match.advance(match.now_ns + SECOND)
    for name, body in match.bodies.items():
        assert heard[name] + len(body.hear()) == 3 * said
    assert match.radio[0].delivered == 4 * 3 * said
