"""The standard library: it compiles, its functions are there, and they calculate what it says."""

from __future__ import annotations

import importlib
import inspect
import math
from dataclasses import dataclass
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from aseme_dsl.compiler.names.resolve import Symbols, resolve
from aseme_dsl.compiler.read.builtins import PERFORMATIVES
from aseme_dsl.compiler.read.load import load
from aseme_dsl.diagnostics import render_text
from aseme_dsl.runtime.library import math as maths
from aseme_dsl.runtime.library import soccer, time
from aseme_dsl.source import Source
from aseme_dsl.standard_library import standard_library
from tests.support.compiling import analysis, system

FILES = sorted(standard_library().glob("*.aseme"))


def symbols_of(name: str) -> Symbols:
    loaded = load(Source("test.aseme", f"import {name}"))
    symbols, found = resolve(loaded)
    assert not loaded.diagnostics + found, render_text(loaded.diagnostics + found)
    return symbols


def test_the_library_has_its_files() -> None:
    assert {path.stem for path in FILES} >= {"soccer", "time", "math", "protocols"}


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_functions_are_there_with_their_parameters(path: Path) -> None:
    for function in symbols_of(path.stem).functions:
        module, _, attribute = function.target.partition(":")
        assert module.startswith("aseme_dsl.runtime.library."), "a robot has nothing but the runtime"
        found = getattr(importlib.import_module(module), attribute)
        assert len(inspect.signature(found).parameters) == len(function.parameters), function.name


def test_everything_may_be_imported_together() -> None:
    imports = "\n".join(f"import {path.stem}" for path in FILES)
    found = analysis(f"system All\n{imports}\nsrm r {{ liveness {{ r = A }} }}")
    assert {item.code for item in found.diagnostics} == {"N727"}, render_text(found.diagnostics)


def test_what_the_case_tools_goalie_reads_is_in_soccer() -> None:
    """The names of Figure 6 of the paper on the case tool, and of its half-time changes.

    That nobody may have said what the player is yet is a note.
    """
    text = """
    system Keeper
    import soccer
    srm goalie {
      var approach_limit : double = 60
      liveness { goalie = (A | B | C | D | E | F) }
      control goalie {
        enter A : [game.state.GameState.player_state != PlayerState.PLAYING]
        enter B : [world.state.Pose.distance_to_post > 20]
        enter C : [vision.state.Ball.visible && vision.state.Ball.distance < approach_limit]
        enter D : [vision.state.Ball.speed >= 40 && mean(vision.data.BallTrack.bearing, 300ms) < 30]
        enter E : [can_kick(vision.state.Ball) && world.state.Obstacles.front > 30]
        enter F : else
      }
    }
    """
    assert [item.code for item in analysis(text).diagnostics] == ["N720"]


PLAYED = """
system Played
import protocols
srm asker {{ plays {protocol}.{first}  liveness {{ asker = {first} }} }}
srm doer  {{ plays {protocol}.{second}  liveness {{ doer = {second} }} }}
team T {{ one : asker   other[1..3] : doer }}
"""


@pytest.mark.parametrize(
    ("protocol", "first", "second"),
    [
        ("request", "initiator", "responder"),
        ("contract_net", "manager", "contractor"),
        ("auction", "auctioneer", "bidder"),
    ],
)
def test_protocols_are_played_as_they_are(protocol: str, first: str, second: str) -> None:
    compiled = system(PLAYED.format(protocol=protocol, first=first, second=second))
    played = next(item for item in compiled.aips if item.name == protocol)
    assert [item.name for item in played.participants] == [first, second]
    assert compiled.eac(protocol) is not None
    for participant, other in (played.participants, reversed(played.participants)):
        assert {item.performative for item in participant.sends} <= set(PERFORMATIVES)
        sent = {(item.performative, item.message) for item in participant.sends}
        received = {(item.performative, item.message) for item in other.receives}
        assert sent == {kind for kind in received if kind[0] != "not_understood"}


def test_all_protocols_may_be_played_by_one_role() -> None:
    compiled = system(
        """
        system Played
        import protocols
        srm boss { plays request.initiator  plays contract_net.manager  plays auction.auctioneer
                   liveness { boss = initiator . manager . auctioneer } }
        srm hand { plays request.responder  plays contract_net.contractor  plays auction.bidder
                   liveness { hand = (responder . contractor . bidder)~ }
                   activities { ConsiderOrder writes willing  CarryOut takes 1s } }
        """
    )
    assert {item.name for item in compiled.iacs} == {"boss", "hand"}


# ---- soccer ------------------------------------------------------------------------------------


@dataclass
class Ball:
    visible: bool = True
    distance: float = 3.0
    bearing: float = 0.0


@dataclass
class Pose:
    x: float = 0.0
    y: float = 0.0
    heading: float = 0.0


@pytest.mark.parametrize(
    ("ball", "expected"),
    [
        (Ball(), True),
        (Ball(visible=False), False),
        (Ball(distance=5.5), False),
        (Ball(bearing=29.0), True),
        (Ball(bearing=-31.0), False),
        (Ball(bearing=350.0), True),
    ],
)
def test_a_ball_can_be_kicked_where_a_kick_hits_it(ball: Ball, expected: bool) -> None:
    assert soccer.can_kick(ball) is expected


@pytest.mark.parametrize(
    ("pose", "expected"),
    [
        (Pose(), True),
        (Pose(heading=8.0), True),
        (Pose(heading=9.0), False),
        (Pose(heading=180.0), False),
        (Pose(x=400.0, y=300.0, heading=-79.0), True),
        (Pose(x=400.0, y=300.0, heading=0.0), False),
        (Pose(x=440.0, y=0.0, heading=0.0), True),
        (Pose(x=440.0, y=0.0, heading=180.0), False),
        (Pose(x=460.0, y=0.0, heading=0.0), False),
        (Pose(heading=360.0), True),
    ],
)
def test_facing_the_goal_is_between_the_posts(pose: Pose, expected: bool) -> None:
    assert soccer.facing_goal(pose) is expected


def test_places_on_the_field() -> None:
    assert soccer.distance_to_goal(Pose(x=150.0, y=400.0)) == 500.0
    assert soccer.bearing_to(Pose(x=10.0, y=10.0, heading=90.0), 10.0, 20.0) == 0.0
    assert soccer.bearing_to(Pose(heading=-90.0), 10.0, 0.0) == 90.0
    assert soccer.in_own_half(Pose(x=-1.0)) and not soccer.in_own_half(Pose(x=1.0))
    assert soccer.in_own_penalty_area(Pose(x=-300.0, y=-200.0))
    assert not soccer.in_own_penalty_area(Pose(x=-280.0))


# ---- math and time -----------------------------------------------------------------------------


def test_rounding() -> None:
    assert [maths.round(number) for number in (2.5, -2.5, 2.4999, -0.5, 0.49999999999999994, 7.0)] == [
        3,
        -3,
        2,
        -1,
        0,
        7,
    ]
    assert (maths.floor(-0.5), maths.ceil(-0.5), maths.sign(-3), maths.sign(0.0)) == (-1, 0, -1, 0)


def test_angles_are_degrees() -> None:
    assert maths.sin(30.0) == pytest.approx(0.5)
    assert maths.cos(60.0) == pytest.approx(0.5)
    assert maths.tan(45.0) == pytest.approx(1.0)
    assert maths.atan2(1.0, 0.0) == pytest.approx(90.0)
    assert maths.degrees(maths.radians(77.0)) == pytest.approx(77.0)
    assert maths.turn_from(170.0, -170.0) == pytest.approx(20.0)
    assert maths.turned(-180.0) == 180.0


@given(st.floats(-1e6, 1e6))
def test_a_turned_angle_is_the_same_direction(angle: float) -> None:
    turned = maths.turned(angle)
    assert -180.0 <= turned <= 180.0
    assert math.isclose(math.cos(math.radians(turned)), math.cos(math.radians(angle)), abs_tol=1e-6)


def test_numbers() -> None:
    assert (maths.clamp(5, 1, 3), maths.clamp(0.5, 1.0, 3.0)) == (3, 1.0)
    assert (maths.hypot(3.0, 4.0), maths.power(2.0, 10.0), maths.sqrt(9.0)) == (5.0, 1024.0, 3.0)
    with pytest.raises(ValueError):
        maths.sqrt(-1.0)


def test_durations() -> None:
    assert (time.seconds(1_500_000_000), time.milliseconds(1_500_000), time.minutes(90_000_000_000)) == (
        1.5,
        1.5,
        1.5,
    )
    assert time.from_seconds(1.5) == 1_500_000_000
