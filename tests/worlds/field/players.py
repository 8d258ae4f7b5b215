"""A team written by hand that plays through the port alone: what the field's tests drive matches with."""

from __future__ import annotations

from aseme_dsl.runtime.world.body import Body
from aseme_dsl.worlds.field.command import Command, Motion, Stand, Walk
from aseme_dsl.worlds.field.field import in_own_penalty_area
from aseme_dsl.worlds.field.geometry import Point, distance
from aseme_dsl.worlds.field.match import Match
from aseme_dsl.worlds.field.percept import Percept, PlayerState
from aseme_dsl.worlds.field.skills import (
    SEARCH_NS,
    aim,
    attack,
    ball_place,
    clear,
    keeper_place,
    line_up,
    look_at,
    recover,
    save,
    scan,
    search,
    seconds_to_ball,
    support_place,
    walk_to,
)

THINK_NS = 60_000_000
FORGET_NS = 3_000_000_000
TELL_NS = 300_000_000


class HandPlayer:
    """One robot's head: it remembers the ball and tells its mates about it; who is nearest goes for it."""

    def __init__(self, body: Body[Percept, Command]) -> None:
        self.body = body
        self.ball: Point | None = None
        self.ball_seen_ns = -FORGET_NS
        self.told_ns = -TELL_NS
        self.mates: dict[str, tuple[int, float]] = {}

    def think(self) -> None:
        percept = self.body.sense()
        now = percept.time_ns
        seen = ball_place(percept)
        if seen is not None:
            self.ball, self.ball_seen_ns = seen, now
        for heard in self.body.hear():
            tenths, x, y = heard.payload
            self.mates[heard.sender] = (now, tenths / 10)
            if now - self.ball_seen_ns > 500_000_000:
                self.ball, self.ball_seen_ns = Point(x * 4.0 - 500.0, y * 4.0 - 500.0), now - 500_000_000
        known = self.ball if now - self.ball_seen_ns < FORGET_NS else None
        mine = seconds_to_ball(percept.pose, known) if known is not None else 25.0
        if seen is not None and now - self.told_ns >= TELL_NS:
            self.told_ns = now
            self.body.say(bytes([int(min(mine, 25.0) * 10), _byte(seen.x), _byte(seen.y)]))
        if known is None:
            self.body.act(Command(self._lost(percept), scan(now)))
        else:
            head = (
                look_at(percept.pose, known)
                if seen is not None or now % 2_000_000_000 < 1_000_000_000
                else scan(now)
            )
            self.body.act(Command(self._motion(percept, known, mine), head))

    def _lost(self, percept: Percept) -> Motion:
        if percept.game.state is PlayerState.READY:
            return walk_to(percept.pose, percept.kick_off_place, percept.kick_off_place.heading)
        if percept.goalie:
            place = keeper_place(Point(0.0, 0.0))
            return recover(percept) or walk_to(percept.pose, place, place.heading)
        return recover(percept) or search(percept.pose, percept.time_ns + percept.jersey % 2 * SEARCH_NS)

    def _motion(self, percept: Percept, ball: Point, mine: float) -> Motion:
        if percept.game.state is PlayerState.READY:
            return walk_to(percept.pose, percept.kick_off_place, percept.kick_off_place.heading)
        if percept.game.state is not PlayerState.PLAYING:
            return Stand() if recover(percept) else Walk()
        if percept.goalie:
            return self._keep(percept, ball)
        others = [
            need for heard_ns, need in self.mates.values() if percept.time_ns - heard_ns < 1_500_000_000
        ]
        if mine <= min(others, default=99.0) + 0.3 or distance(percept.pose, ball) < 40.0:
            return attack(percept, ball, aim(percept, ball))
        place = support_place(ball, percept.jersey)
        return recover(percept) or walk_to(percept.pose, place, place.heading)

    def _keep(self, percept: Percept, ball: Point) -> Motion:
        dive = save(percept)
        if dive is not None:
            return dive
        up = recover(percept)
        if up is not None:
            return up
        if in_own_penalty_area(ball) and (percept.ball is None or percept.ball.speed < 25.0):
            if percept.ball_at_feet and abs(percept.pose.heading) < 90.0:
                return clear(percept.pose, ball)
            return line_up(percept.pose, ball, Point(450.0, 0.0))
        place = keeper_place(ball)
        return walk_to(percept.pose, place, place.heading)


def _byte(cm: float) -> int:
    return max(0, min(255, round((cm + 500.0) / 4.0)))


def play(match: Match, until_ns: int) -> Match:
    """Let every body of a match be driven by a hand-written player up to a time."""
    players = [HandPlayer(body) for body in match.bodies.values()]
    while match.now_ns < until_ns:
        match.advance(min(until_ns, match.now_ns + THINK_NS))
        for player in players:
            player.think()
    return match
