"""The phases of a swap by the operator's own code, against members that are modelled by hand.

A request or its answer may be lost, a member killed or slow, the operator killed: at any point. In the end
there is one version, the old or the new one, and what the operator was told is true.
"""

from __future__ import annotations

import itertools
from collections.abc import Mapping
from types import SimpleNamespace
from typing import Any, cast
from unittest import mock

from hypothesis import event, given, settings
from hypothesis import strategies as st

from aseme_dsl.project.operating import swapping
from aseme_dsl.project.operating.whole_team import WholeTeam
from aseme_dsl.project.playing.operate import Node, OperateError
from aseme_dsl.runtime.version.epochs import Epoch

NEW = "b" * 64
FAULTS = (*[""] * 16, "lost", "answer lost", "killed", "killed after", "slow")


class Killed(Exception):
    """The operator is killed."""


class Clock:
    """The time of all, in seconds."""

    def __init__(self) -> None:
        self.now = 0.0

    def monotonic(self) -> float:
        return self.now

    def sleep(self, seconds: float) -> None:
        self.now += max(seconds, 0.01)


class Member:
    """A robot: what it keeps, and the swap for which it is held; as `control` and `holding` say."""

    def __init__(self, name: str, clock: Clock, busy: bool) -> None:
        self.name, self.clock, self.busy = name, clock, busy
        self.kept = self.epoch = Epoch(base="m")
        self.numbers = itertools.count(1)
        self.number, self.state, self.until = 0, "", 0.0
        self.coming = self.epoch

    def pass_time(self) -> None:
        """Nobody has said anything for too long: it decides alone."""
        if self.state and self.clock.now >= self.until:
            self._end(self.state == "committed")

    def kill(self) -> None:
        """It starts again at once, with what it has kept."""
        self.state, self.epoch = "", self.kept

    def _end(self, change: bool) -> None:
        self.epoch = self.kept = self.coming if change else self.epoch
        self.state = ""

    def handle(self, request: Mapping[str, Any]) -> dict[str, Any]:
        self.pass_time()
        if request["request"] == "status":
            going = {"id": self.number, "state": self.state} if self.state else None
            epoch = self.epoch.as_data()
            return {"ok": True, "agents": [{"name": self.name}], "swap": going, "epoch": epoch, "held": None}
        match request["phase"]:
            case "ready":
                reasons = ["busy"] if self.busy else []
                return {"ok": not self.state, "reasons": reasons if not self.state else ["another"]}
            case "prepare":
                if self.state or request["epoch"] <= self.epoch.number:
                    return {"ok": False, "reasons": ["another swap is under way, or has been done"]}
                self.number, self.state = next(self.numbers), "prepared"
                self.coming = Epoch(request["epoch"], request["hash"], "m")
                self.until = self.clock.now + request["hold"]
                return {"ok": True, "state": "prepared", "id": self.number, "reasons": [], "notes": []}
            case "refuse":
                return {"ok": True, "state": "refused"}
        if not self.state or request["id"] != self.number:
            return {"ok": False, "reasons": ["it is not held here any more"]}
        match request["phase"]:
            case "commit":
                self.state, self.kept = "committed", self.coming
                self.until = self.clock.now + 3.0
                return {"ok": True, "state": self.state}
            case "finish" if self.state == "committed":
                self._end(True)
                return {"ok": True, "state": "done"}
            case "rollback":
                self._end(False)
                return {"ok": True, "state": "rolled back"}
        return {"ok": False, "reasons": ["it has not been committed"]}


@settings(max_examples=200, deadline=None)
@given(st.data())
def test_one_version_in_the_end_and_what_is_said_of_it_is_true(data: st.DataObject) -> None:
    clock = Clock()
    count = data.draw(st.integers(2, 4), "members")
    members = [
        Member(name, clock, data.draw(st.sampled_from([False] * 5 + [True]))) for name in "abcd"[:count]
    ]
    deaths = data.draw(st.sampled_from([None, None, *range(1, 6 * count)]), "operator dies at")
    questions = itertools.count(1)

    def ask_each(requests: Mapping[Any, Mapping[str, Any]], timeout: float = 5.0) -> dict[Any, Any]:
        replies: dict[Any, Any] = {}
        slowest = 0.0
        for member, request in requests.items():
            if deaths is not None and next(questions) >= deaths:
                raise Killed
            fault = data.draw(st.sampled_from(FAULTS), f"{member.name} {request}")
            reply: dict[str, Any] = {"ok": False, "reasons": [f"{member.name} does not answer"]}
            if fault == "killed":
                member.kill()
            elif fault != "lost":
                found = member.handle(request)
                reply = reply if fault in ("answer lost", "killed after") else found
                if fault == "killed after":
                    member.kill()
            slowest = max(slowest, 2.0 if fault == "slow" else 5.0 if fault else 0.0)
            replies[member] = reply
        clock.now += min(slowest, timeout)
        for member in members:
            member.pass_time()
        return replies

    nodes = tuple(
        Node(cast("Any", member), cast("Any", member.handle({"request": "status"}))) for member in members
    )
    team = WholeTeam(nodes, (), tuple(member.name for member in members))
    quorum = data.draw(st.sampled_from(["all", str(count // 2 + 1)]), "quorum")
    done: swapping.Swapped | None = None
    refused = False
    with (
        mock.patch.object(swapping, "ask_each", ask_each),
        mock.patch.object(swapping, "time", SimpleNamespace(monotonic=clock.monotonic, sleep=clock.sleep)),
    ):
        try:
            done = swapping.swap(team, NEW, within=1.0, quorum=quorum)
        except OperateError:
            refused = True
        except Killed:
            pass
    clock.now += 100.0
    for member in members:
        member.pass_time()
    follow = {member.name: member.epoch for member in members}
    if refused:
        event("refused")
        assert {epoch.number for epoch in follow.values()} == {0}
    if done is not None:
        event("whole" if done.is_whole else "in part")
        assert all(follow[name] == Epoch(1, NEW, "m") for name in done.changed)
        if done.is_whole and quorum == "all":
            assert set(done.changed) == set(follow)
        assert set(done.changed) | set(done.unchanged) == set(follow)
        known = [name for name, why in done.unchanged.items() if why == "it was rolled back there"]
        assert all(follow[name].number == 0 for name in known)
    for one, other in itertools.product(members, repeat=2):  # they hear of each other
        if other.epoch.is_newer(one.epoch):
            one.epoch = other.epoch
    assert len({member.epoch for member in members}) == 1
    assert members[0].epoch in (Epoch(base="m"), Epoch(1, NEW, "m"))
