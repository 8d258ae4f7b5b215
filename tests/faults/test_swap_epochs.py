"""Epochs: a team ends in one version, whoever is killed, slow or unreachable while it changes."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from aseme_dsl.project.operating.swapping import quorum_of
from aseme_dsl.project.playing.operate import OperateError
from aseme_dsl.runtime.control.control import Control
from aseme_dsl.runtime.control.control_socket import ask, endpoints, label_of
from aseme_dsl.runtime.version.epochs import Epoch, EpochError, EpochFile, epoch_of
from tests.faults.test_operate import LONGER, Here, Running, here, package, said
from tests.faults.test_swap import ONE
from tests.support.waiting import LONG, wait_until

__all__ = ["here"]  # the fixture

TRIO = ONE.replace("team S { a : player  b : player }", "team S { a : player  b : player  c : player }")
CHANGED = TRIO.replace("Search . (Kick | Wait)", "Search . (Kick | Wait) . Cheer")
NAMES = ("a", "b", "c")
CONFIGURATION = '[tool.asemec]\noutput = "out"\n[tool.asemec.deploy]\nlease = "2s"\n'


class Team:
    """Three nodes without a supervisor."""

    def __init__(self, here: Here) -> None:
        self.here = here
        here.write("one.aseme", TRIO)
        here.write("two.aseme", CHANGED)
        here.write("pyproject.toml", CONFIGURATION)
        assert here.asemec("build", "one.aseme", "-o", "out")[0] == 0
        self.nodes = {name: self.start(name) for name in NAMES}
        wait_until(lambda: self.connected(), pause=0.1)

    def start(self, name: str) -> subprocess.Popen[str]:
        process = subprocess.Popen(
            [sys.executable, "-m", "aseme_dsl", "node", name, "--from", "out", "-q"],
            cwd=self.here.folder,
            env={**os.environ, "PYTHONPATH": str(Path(__file__).parents[2])},
            text=True,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
        )
        self.here.running.append(process)
        return process

    def status(self) -> dict[str, dict[str, Any]]:
        """What each process that answers says of itself, by its agent."""
        _, text = self.here.asemec("team", "status", "--json")
        return {p["agents"][0]["name"]: p for p in json.loads(text).get("processes", [])}

    def connected(self) -> bool:
        found = self.status()
        return len(found) == 3 and all(p["connected"] for s in found.values() for p in s["peers"].values())

    def epochs(self) -> dict[str, int]:
        return {name: status["epoch"]["number"] for name, status in self.status().items()}

    def models(self) -> set[str]:
        return {status["model"] for status in self.status().values()}

    def swap(self, *options: str, target: str = "two.aseme") -> tuple[int, str]:
        return self.here.asemec("team", "swap", target, "-o", "out", *options)

    def ask(self, name: str, **request: Any) -> dict[str, Any]:
        path = next(p for p in endpoints(self.here.folder / "out") if label_of(p) == name)
        return dict(ask(path, request, LONG))

    def prepared(self, *names: str, epoch: int = 1) -> dict[str, int]:
        """Phase 1 of a swap by hand, in these; the numbers of the swaps."""
        store = self.here.folder / "out"
        version, _ = package(store, CHANGED)
        found = {}
        for name in names:
            request = {"request": "swap", "phase": "prepare", "hash": version, "agents": None, "within": 5}
            reply = self.ask(name, **request, hold=5, epoch=epoch)
            assert reply["state"] == "prepared", reply
            found[name] = reply["id"]
        return found


@pytest.fixture
def team(here: Here) -> Iterator[Team]:
    pytest.importorskip("zenoh")
    yield Team(here)


def test_all_members_change_and_begin_in_their_epoch_after_a_restart(team: Team) -> None:
    before = team.models()
    code, said = team.swap()
    assert code == 0, said
    assert team.epochs() == dict.fromkeys(NAMES, 1)
    assert team.models() != before and len(team.models()) == 1
    team.nodes["b"].kill()
    team.nodes["b"].wait()
    team.nodes["b"] = team.start("b")
    wait_until(lambda: team.epochs().get("b") == 1, pause=0.1)
    assert len(team.models()) == 1


def test_all_is_all_and_a_quorum_leaves_behind_who_catches_up(team: Team) -> None:
    before = team.models()
    team.nodes["c"].send_signal(signal.SIGSTOP)
    code, said = team.swap()
    assert code == 1 and "nothing has changed:" in said and "(c) does not answer" in said
    code, said = team.swap("--quorum", "1")
    assert code == 1 and "needs `all`, or a number from 2 to 3" in said
    code, said = team.swap("--quorum", "2")
    assert code == 3, said
    assert "a, b swapped to model" in said and "c: c does not answer" in said
    team.nodes["c"].send_signal(signal.SIGCONT)
    wait_until(lambda: team.epochs() == dict.fromkeys(NAMES, 1), pause=0.2)
    assert len(team.models()) == 1 and team.models() != before
    assert all(status["held"] is None for status in team.status().values())


def test_who_lacks_the_version_is_held_until_it_is_copied(team: Team) -> None:
    team.nodes["c"].kill()
    team.nodes["c"].wait()
    assert team.swap("--quorum", "2")[0] == 3
    store = team.here.folder / "out" / "versions"
    (version,) = [path for path in store.iterdir() if len(path.name) == 64]
    version.rename(team.here.folder / "elsewhere")
    team.nodes["c"] = team.start("c")
    held = wait_until(lambda: (team.status().get("c") or {"held": None})["held"], pause=0.1)
    assert held["number"] == 1
    assert wait_until(lambda: team.status()["c"]["held"]["reasons"], pause=0.1)[0].startswith(
        "there is no version"
    )
    _, text = team.here.asemec("team", "status")
    assert "  held         until epoch 1, version " in text
    (team.here.folder / "elsewhere").rename(version)
    wait_until(lambda: team.epochs() == dict.fromkeys(NAMES, 1), pause=0.2)


@pytest.mark.parametrize("committed", [(), ("a",), ("a", "b"), NAMES])
def test_an_operator_that_dies_between_the_phases_leaves_one_epoch(
    team: Team, committed: tuple[str, ...]
) -> None:
    ids = team.prepared(*NAMES)
    for name in committed:
        assert team.ask(name, request="swap", phase="commit", id=ids[name])["state"] == "committed"
    wanted = dict.fromkeys(NAMES, 1 if committed else 0)
    wait_until(
        lambda: team.epochs() == wanted and not any(s["swap"] for s in team.status().values()), pause=0.2
    )
    assert len(team.models()) == 1


def test_a_robot_that_dies_after_its_commit_begins_in_the_new_epoch(team: Team) -> None:
    ids = team.prepared(*NAMES)
    for name in NAMES:
        team.ask(name, request="swap", phase="commit", id=ids[name])
    team.nodes["b"].kill()
    team.nodes["b"].wait()
    team.nodes["b"] = team.start("b")
    wait_until(lambda: team.epochs() == dict.fromkeys(NAMES, 1), pause=0.2)
    assert len(team.models()) == 1


def test_a_robot_that_dies_while_it_is_prepared_keeps_the_others_from_it(team: Team) -> None:
    before = team.models()
    ids = team.prepared(*NAMES)
    team.nodes["b"].kill()
    team.nodes["b"].wait()
    for name in ("a", "c"):
        team.ask(name, request="swap", phase="rollback", id=ids[name], reason="b died")
    team.nodes["b"] = team.start("b")
    wait_until(lambda: team.epochs() == dict.fromkeys(NAMES, 0), pause=0.2)
    assert team.models() == before


def test_two_operators_at_once_end_in_one_epoch(team: Team) -> None:
    team.here.write("three.aseme", TRIO.replace("Search . (Kick | Wait)", "Search . (Kick | Wait) . Rest"))
    command = [sys.executable, "-m", "aseme_dsl", "team", "swap"]
    operators = [
        subprocess.Popen([*command, f"{name}.aseme", "-o", "out"], cwd=team.here.folder)
        for name in ("two", "three")
    ]
    codes = [operator.wait(LONG) for operator in operators]
    assert set(codes) <= {0, 1, 3}
    wait_until(lambda: len(set(team.epochs().values())) == 1 and len(team.models()) == 1, pause=0.2)


# ---- without processes ----------------------------------------------------------------------------


def test_an_epoch_is_newer_than_those_before(tmp_path: Path) -> None:
    name, _ = package(tmp_path, LONGER)
    with Running() as (running, _):
        control = Control(running, store=tmp_path / "versions", epoch=Epoch(3, name))
        reply = said(control, request="swap", phase="prepare", hash=name, epoch=3)
        assert reply["reasons"] == ["epoch 3 is not newer than 3, which is followed here"]
        for wrong in (0, -1, 2.5, True, 1 << 60):
            assert not said(control, request="swap", phase="prepare", hash=name, epoch=wrong)["ok"]


def test_a_kept_epoch(tmp_path: Path) -> None:
    kept = EpochFile(tmp_path / "versions", "ann")
    assert kept.read("m") == Epoch(base="m")
    epoch = Epoch(4, "a" * 64, "m")
    kept.write(epoch)
    assert kept.read("m") == epoch
    assert kept.read("another build") == Epoch(base="another build")
    assert kept.path.stat().st_mode & 0o777 == 0o600
    for damaged in ("", "{", "[]", '{"number": 1}', '{"number": -1, "hash": "", "base": ""}', "[" * 10_000):
        kept.path.write_text(damaged)
        with pytest.raises(EpochError, match="remove it to begin anew"):
            kept.read("m")


@pytest.mark.parametrize("members, least", [(1, 1), (2, 2), (3, 2), (4, 3), (5, 3)])
def test_a_quorum_is_a_majority(members: int, least: int) -> None:
    assert quorum_of("all", members) == members
    assert quorum_of(str(least), members) == least
    for wrong in (str(least - 1), str(members + 1), "half", "-1", "", "9" * 50, "²"):
        with pytest.raises(OperateError):
            quorum_of(wrong, members)


EPOCHS = st.builds(Epoch, st.integers(0, 4), st.sampled_from(["a" * 64, "b" * 64]), st.just("m")).map(
    lambda epoch: epoch if epoch.number else Epoch(base="m")
)


@given(st.lists(EPOCHS, min_size=1, max_size=6), st.randoms(use_true_random=False))
def test_agents_that_hear_each_other_in_any_order_agree(epochs: list[Epoch], chance: Any) -> None:
    mine = list(epochs)
    pairs = [(a, b) for a in range(len(mine)) for b in range(len(mine))] * len(mine)
    chance.shuffle(pairs)
    for a, b in [*pairs, *((a, b) for a in range(len(mine)) for b in range(len(mine)))]:
        before = mine[a]
        if mine[b].is_newer(mine[a]):
            mine[a] = mine[b]
        assert not before.is_newer(mine[a])  # never back
    assert len(set(mine)) == 1 and mine[0] in epochs
    assert epoch_of(json.loads(json.dumps(mine[0].as_data()))) == mine[0]


@settings(max_examples=300, deadline=None)
@given(st.data())
def test_the_phases_end_in_one_epoch_whoever_dies_when(data: st.DataObject) -> None:
    """A model of the protocol: operators and robots that die at any moment, requests that are lost."""
    number = data.draw(st.integers(2, 5))
    kept = [Epoch(base="m")] * number
    for hash_ in ("a" * 64, "b" * 64)[: data.draw(st.integers(1, 2))]:
        there = [data.draw(st.booleans()) for _ in range(number)]
        needed = data.draw(st.sampled_from([number, number // 2 + 1]))
        mine = 1 + max((kept[r].number for r in range(number) if there[r]), default=0)
        prepared = [r for r in range(number) if there[r] and mine > kept[r].number]
        if len(prepared) < needed or data.draw(st.booleans()):  # refused, or the operator dies: rolled back
            continue
        committed = [r for r in prepared if data.draw(st.booleans())]  # the others' commits are lost
        for r in committed:  # it is kept before it is confirmed; then a robot may die, and changes
            kept[r] = Epoch(mine, hash_, "m")
        if len(committed) < needed:  # who hears of the rollback goes back
            for r in committed:
                if data.draw(st.booleans()):
                    kept[r] = Epoch(base="m")
    for _ in range(number):
        for a in range(number):
            for b in range(number):
                if kept[b].is_newer(kept[a]):
                    kept[a] = kept[b]
    assert len(set(kept)) == 1


def test_agents_that_are_held_end_their_conversations_and_begin_none() -> None:
    from tests.faults.test_swap import NET, played
    from tests.runtime.playing import MS

    def hold(running: Any) -> None:
        running.driver.at(130 * MS, lambda: running.conversations.hold("held until epoch 2 is followed here"))
        running.driver.at(600 * MS, lambda: running.conversations.hold(""))

    records = played(NET, hold)
    opened = [r["time"] // MS for r in records if r["kind"] == "conversation" and r["what"] == "open"]
    assert opened[0] == 100 and not any(130 <= moment < 600 for moment in opened)
    left = [r for r in records if r["kind"] == "conversation" and r["what"] == "leave"]
    assert left[0]["time"] >= 130 * MS and not left[0].get("untaken")  # it went on to its end
    unsent = [r for r in records if r["kind"] == "unsent"]
    assert unsent and unsent[0]["reason"] == "held until epoch 2 is followed here"
    assert any("is not sent: held until" in r["reason"] for r in records if r["kind"] == "fault")


def test_an_agent_that_is_held_refuses_invitations_to_their_sender() -> None:
    from tests.faults.test_swap import NET, played
    from tests.runtime.playing import MS

    def hold(running: Any) -> None:
        deliver = running.conversations._delivery.deliver

        def held(agent: Any, acl: Any) -> None:  # the other side of a network: only the receiver is held
            running.conversations._members.held = "held" if agent.name == "aide" else ""
            try:
                deliver(agent, acl)
            finally:
                running.conversations._members.held = ""

        running.driver.at(50 * MS, lambda: setattr(running.conversations._delivery, "deliver", held))

    records = played(NET, hold)
    assert {r["reason"] for r in records if r["kind"] == "unexpected" and r["agent"] == "aide"} == {"held"}
    answers = {r["performative"] for r in records if r.get("sender") == "aide"}
    assert answers == {"not_understood"}
    joined = [r for r in records if r["kind"] == "conversation" and r["what"] == "join"]
    assert not [r for r in joined if r["agent"] == "aide"]
